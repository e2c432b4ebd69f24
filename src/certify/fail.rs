//! Why no certificate was found, as values; worded here and nowhere else.

use crate::kernel::{Failure, Verdict};
use crate::prove::outcome::limit_reached;
use std::fmt;

/// What stopped the search for a certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fail {
    /// A limit of the search was reached.
    Limit(&'static str),
    /// A limit of the kernel was reached.
    KernelLimit(&'static str),
    /// The kernel does not take a step of this rule.
    Step {
        /// The rule.
        rule: &'static str,
        /// Why.
        reason: String,
    },
    /// The kernel's arithmetic does not follow an expression.
    Value(String),
    /// A comparison that no step shows.
    NotShown(String),
    /// A fact or a cited claim that is not there, by name.
    NoFact(String),
    /// A claim that is cited and was not proved.
    NoProofOf(String),
    /// No step for this, in words.
    No(&'static str),
    /// It stopped within a part of the argument.
    Within(String, Box<Fail>),
    /// What was found is not accepted when it is checked from nothing: the rule and the reason.
    Whole {
        /// The step, by label.
        step: String,
        /// Its rule.
        rule: &'static str,
        /// Why.
        reason: String,
    },
}

impl Fail {
    /// The limit that was reached, if one was.
    pub fn limit(&self) -> Option<&'static str> {
        match self {
            Fail::Limit(name) | Fail::KernelLimit(name) => Some(name),
            Fail::Within(_, inner) => inner.limit(),
            _ => None,
        }
    }

    /// The same, within a part of the argument.
    pub fn within(self, part: &str) -> Fail {
        Fail::Within(part.to_string(), Box::new(self))
    }

    /// Why a step of a rule was not taken.
    pub fn step(rule: &'static str, failure: Failure) -> Fail {
        match failure {
            Failure::Rejected(reason) => Fail::Step { rule, reason },
            Failure::Declined(limit) => Fail::KernelLimit(limit),
        }
    }

    /// Why a whole certificate is not accepted.
    pub fn whole(verdict: Verdict) -> Fail {
        match verdict {
            Verdict::Accepted(_) => Fail::No("a certificate"),
            Verdict::Rejected { step, rule, reason } => Fail::Whole { step, rule, reason },
            Verdict::Declined { limit } => Fail::KernelLimit(limit),
        }
    }
}

impl fmt::Display for Fail {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fail::Limit(name) => f.write_str(&limit_reached(name)),
            Fail::KernelLimit(name) => write!(f, "limit reached: {name}, a limit of the kernel that no flag raises"),
            Fail::Step { rule, reason } => write!(f, "no step of rule `{rule}` ({reason})"),
            Fail::Value(reason) => f.write_str(reason),
            Fail::NotShown(prop) => write!(f, "no step shows {prop}"),
            Fail::NoFact(name) => write!(f, "no fact is called {name}"),
            Fail::NoProofOf(name) => write!(f, "{name} is not proved"),
            Fail::No(what) => write!(f, "no step for {what}"),
            Fail::Within(part, inner) => write!(f, "{part}: {inner}"),
            Fail::Whole { step, rule, reason } => write!(f, "what was written is rejected at {rule} {step}: {reason}"),
        }
    }
}

impl From<&'static str> for Fail {
    fn from(what: &'static str) -> Fail {
        Fail::No(what)
    }
}

impl From<Failure> for Fail {
    fn from(failure: Failure) -> Fail {
        match failure {
            Failure::Rejected(reason) => Fail::Value(reason),
            Failure::Declined(limit) => Fail::KernelLimit(limit),
        }
    }
}
