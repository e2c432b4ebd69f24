//! Why no certificate was found, as values; worded here and nowhere else.

use super::draft::Failure;
use super::elaborate::Stuck;
use crate::claim::print::prop;
use crate::claim::syntax::Prop;
use crate::kernel::{Refusal, Verdict};
use crate::refute::outcome::limit_reached;
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
    /// A step of a draft that does not say what it needs, by label.
    Malformed(String),
    /// It stopped within a part of the argument.
    Within(String, Box<Fail>),
    /// A goal that was not shown, and why.
    Goal(String, Box<Fail>),
    /// All was shown, and what was written of it is not accepted.
    Unwritten(Box<Fail>),
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
            Fail::Within(_, inner) | Fail::Goal(_, inner) | Fail::Unwritten(inner) => inner.limit(),
            _ => None,
        }
    }

    /// The same, within a part of the argument.
    pub fn within(self, part: &str) -> Fail {
        Fail::Within(part.to_string(), Box::new(self))
    }

    /// The same, with the goal where it does not name what was not shown.
    pub(crate) fn of_goal(self, goal: &Prop) -> Fail {
        match self.limit() {
            None if !self.names_what() => Fail::Goal(prop(goal), Box::new(self)),
            _ => self,
        }
    }

    /// Whether it says which proposition was not shown.
    fn names_what(&self) -> bool {
        match self {
            Fail::NotShown(_) => true,
            Fail::Within(_, inner) => inner.names_what(),
            _ => false,
        }
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
            Verdict::Accepted(_) | Verdict::Refuted => Fail::No("a certificate"),
            Verdict::Rejected { step, rule, reason } => Fail::Whole { step, rule, reason: reason.to_string() },
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
            Fail::NotShown(prop) => write!(f, "not shown: {prop}"),
            Fail::NoFact(name) => write!(f, "no fact is called {name}"),
            Fail::NoProofOf(name) => write!(f, "{name} is not proved"),
            Fail::No(what) => write!(f, "no step for {what}"),
            Fail::Malformed(step) => write!(f, "the step {step} of the draft does not say what it needs"),
            Fail::Within(part, inner) => write!(f, "{part}: {inner}"),
            Fail::Goal(goal, inner) => write!(f, "not shown: {goal} ({inner})"),
            Fail::Unwritten(inner) => inner.fmt(f),
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

impl From<Refusal> for Fail {
    fn from(refusal: Refusal) -> Fail {
        Failure::from(refusal).into()
    }
}

impl From<Stuck> for Fail {
    fn from(stuck: Stuck) -> Fail {
        let refused = |step: String, rule, refusal| match refusal {
            Refusal::Rejected(reason) => Fail::Whole { step, rule, reason: reason.to_string() },
            Refusal::Limit(limit) => Fail::KernelLimit(limit),
        };
        match stuck {
            Stuck::Refused { step, rule, refusal } => refused(step, rule, *refusal),
            Stuck::Statement(refusal) => refused(String::new(), "statement", refusal),
            Stuck::Unfinished(refusal) => refused(String::new(), "qed", refusal),
            Stuck::Time => Fail::Limit("time"),
            Stuck::Malformed(step) => Fail::Malformed(step),
        }
    }
}
