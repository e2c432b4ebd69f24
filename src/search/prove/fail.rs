//! Why no certificate was found, as values. Only this file words these reasons.

use crate::claim::print::prop;
use crate::claim::substitution::Obstacle;
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
    /// The kernel's arithmetic cannot read an expression.
    Value(String),
    /// A comparison that no step proves.
    NotShown(String),
    /// The name of a fact or a cited claim that does not exist.
    NoFact(String),
    /// A claim that is cited and was not proved.
    NoProofOf(String),
    /// What no method handles, or what a method lacks, in words.
    No(&'static str),
    /// The failure of a part of the argument.
    Within(String, Box<Fail>),
    /// A goal that was not proved, and why.
    Goal(String, Box<Fail>),
    /// The kernel rejects the whole certificate: the first rejected step, its rule and the reason.
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
            Fail::Within(_, inner) | Fail::Goal(_, inner) => inner.limit(),
            _ => None,
        }
    }

    /// The same failure, with the part of the argument in which it happened.
    pub fn within(self, part: &str) -> Fail {
        Fail::Within(part.to_string(), Box::new(self))
    }

    /// The same failure, with the goal added unless the failure names a proposition.
    pub(crate) fn of_goal(self, goal: &Prop) -> Fail {
        if self.names_what() { self } else { Fail::Goal(prop(goal), Box::new(self)) }
    }

    /// The same failure for want of something that the search needs, such as time.
    pub(crate) fn for_want_of(self, limit: Fail) -> Fail {
        match self {
            Fail::NotShown(goal) | Fail::Goal(goal, _) => Fail::Goal(goal, Box::new(limit)),
            Fail::Within(part, inner) => Fail::Within(part, Box::new(inner.for_want_of(limit))),
            _ => limit,
        }
    }

    /// Whether it names the proposition that was not proved.
    fn names_what(&self) -> bool {
        match self {
            Fail::NotShown(_) | Fail::Goal(..) => true,
            Fail::Within(_, inner) => inner.names_what(),
            _ => false,
        }
    }

    /// Why the kernel does not accept a whole certificate.
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
            Fail::KernelLimit(name) => {
                write!(f, "limit reached: {name} (a fixed limit of the kernel; no flag raises it)")
            }
            Fail::Value(reason) => f.write_str(reason),
            Fail::NotShown(prop) => write!(f, "could not prove: {prop}"),
            Fail::NoFact(name) => write!(f, "no fact is called {name}"),
            Fail::NoProofOf(name) => write!(f, "{name} is not proved"),
            Fail::No(what) => write!(f, "no method applies ({what})"),
            Fail::Within(part, inner) => write!(f, "{part}: {inner}"),
            Fail::Goal(goal, inner) => write!(f, "could not prove: {goal} ({inner})"),
            Fail::Whole { step, rule, reason } => {
                write!(f, "the kernel rejects the certificate found, at step {step} ({rule}): {reason}")
            }
        }
    }
}

impl From<Obstacle> for Fail {
    fn from(obstacle: Obstacle) -> Fail {
        Refusal::from(obstacle).into()
    }
}

impl From<Refusal> for Fail {
    fn from(refusal: Refusal) -> Fail {
        match refusal {
            Refusal::Rejected(reason) => Fail::Value(reason.to_string()),
            Refusal::Limit(limit) => Fail::KernelLimit(limit),
        }
    }
}
