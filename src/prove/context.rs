//! What is known at a point of an argument: variables, facts and the signs that follow at once.
//!
//! Contract: a [`Context`] holds only consequences of its facts. Facts are propositions; from each
//! the context derives what is cheap: the sign of an atom, a substitution for a variable that an
//! equation determines, a constraint between atoms. A sign set that is empty means that the facts
//! contradict each other, and then everything follows.
//!
//! A fact that divides by something, or takes a root, is understood to say that it is defined.

use super::Instant;
use super::expand::Sequence;
use crate::algebra::Polynomial;
use crate::algebra::form::{AtomId, Form, Ring};
use crate::algebra::positivity::Constraint;
use crate::claim::syntax::{Binding, Diagnose, Expr, Prop, Relation};
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A set of possible signs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signs(u8);

impl Signs {
    /// Only negative.
    pub const NEGATIVE: Signs = Signs(1);
    /// Only zero.
    pub const ZERO: Signs = Signs(2);
    /// Only positive.
    pub const POSITIVE: Signs = Signs(4);
    /// Zero or positive.
    pub const NOT_NEGATIVE: Signs = Signs(6);
    /// Not zero.
    pub const NOT_ZERO: Signs = Signs(5);
    /// Nothing known.
    pub const ANY: Signs = Signs(7);

    /// The signs that a relation to zero allows.
    pub fn of(relation: Relation) -> Signs {
        match relation {
            Relation::Equal => Signs(2),
            Relation::NotEqual => Signs(5),
            Relation::Less => Signs(1),
            Relation::LessEqual => Signs(3),
            Relation::Greater => Signs(4),
            Relation::GreaterEqual => Signs(6),
        }
    }

    /// The sign of a number.
    pub fn of_number(q: &malachite::Rational) -> Signs {
        match q.partial_cmp(&0) {
            Some(std::cmp::Ordering::Less) => Signs(1),
            Some(std::cmp::Ordering::Greater) => Signs(4),
            _ => Signs(2),
        }
    }

    /// Both.
    pub fn and(self, other: Signs) -> Signs {
        Signs(self.0 & other.0)
    }

    /// Whether every sign here is in the other set.
    pub fn within(self, other: Signs) -> bool {
        self.0 & !other.0 == 0
    }

    /// No sign is possible.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The signs of products.
    pub fn times(self, other: Signs) -> Signs {
        let mut out = 0;
        for a in [-1i8, 0, 1] {
            for b in [-1i8, 0, 1] {
                if self.has(a) && other.has(b) {
                    out |= 1 << (a * b + 1);
                }
            }
        }
        Signs(out)
    }

    /// The signs of sums.
    pub fn plus(self, other: Signs) -> Signs {
        let mut out = 0;
        for a in [-1i8, 0, 1] {
            for b in [-1i8, 0, 1] {
                if self.has(a) && other.has(b) {
                    out |= if a * b < 0 { 7 } else { 1 << ((a + b).signum() + 1) };
                }
            }
        }
        Signs(out)
    }

    /// The signs of squares.
    pub fn squared(self) -> Signs {
        Signs((self.0 & 2) | if self.0 & 5 != 0 { 4 } else { 0 })
    }

    fn has(self, sign: i8) -> bool {
        self.0 & (1 << (sign + 1)) != 0
    }
}

/// The facts that a conclusion used, by number, as far as the search keeps account of them: a hint, not to be relied on.
/// Facts past the 127th share the last bit.
pub type Sources = u128;

/// A comparison of a product of atoms with zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Literal {
    /// The relation to zero.
    pub relation: Relation,
    /// The atoms; the flag says that the atom enters squared.
    pub atoms: Vec<(AtomId, bool)>,
}

/// A proposition known to hold.
#[derive(Clone, Debug)]
pub struct Fact {
    /// What holds.
    pub prop: Rc<Prop>,
}

/// A family: its domain in terms of the index name, and the indices where it is defined.
#[derive(Clone, Debug)]
pub struct Family {
    /// The declaration.
    pub binding: Binding,
    /// The index name.
    pub index: String,
    /// The number of the fact that stands for its domain.
    pub source: Sources,
}

/// Why a step failed. None of these is a verdict.
#[derive(Clone, Debug, PartialEq)]
pub enum Failure {
    /// A named limit was reached.
    Limit(&'static str),
    /// The methods do not reach this; the text says what was not shown.
    NotShown(String),
    /// An expression may have no value; the text says where.
    Undefined(String),
    /// The text of the claim makes no sense here.
    Fault(Diagnose),
}

impl From<crate::algebra::form::Limit> for Failure {
    fn from(limit: crate::algebra::form::Limit) -> Failure {
        Failure::Limit(limit.0)
    }
}

/// What is known.
#[derive(Clone, Default)]
pub struct Context {
    /// Variables in the order of declaration, and whether each is a natural number.
    pub variables: Vec<(String, bool)>,
    /// Families by name.
    pub families: BTreeMap<String, Rc<Family>>,
    /// Sequences by name.
    pub sequences: BTreeMap<String, Rc<Sequence>>,
    /// Values of eliminated variables and of bound indices, with the facts behind them.
    pub environment: HashMap<String, (Form, Sources)>,
    /// Values of bound indices: like the environment, but set by scope, not by facts.
    pub indices: HashMap<String, Form>,
    /// The facts.
    pub facts: Vec<Fact>,
    /// Signs of atoms that follow from facts.
    pub signs: HashMap<AtomId, (Signs, Sources)>,
    /// Comparisons of products of several atoms.
    pub constraints: Vec<(Literal, Sources)>,
    /// Members of families whose domain was already used.
    pub members: HashSet<AtomId>,
    /// Set when the facts contradict each other.
    pub contradiction: Option<Sources>,
    /// Signs that were derived from the facts above.
    pub memo: HashMap<AtomId, (Signs, Sources)>,
    /// Atoms whose signs were searched in vain with the facts as they are.
    pub searched: HashSet<AtomId>,
    /// How many indices of sums and products are in scope.
    pub binders: usize,
    /// Whether what is translated is being differentiated.
    pub differentiated: bool,
}

/// The state of an argument that does not go back when a branch fails.
pub struct Engine {
    /// Atoms and forms.
    pub ring: Ring,
    /// Facts that were used, by number.
    pub used: Sources,
    /// When to stop.
    pub deadline: Option<Instant>,
    /// Steps left: a deterministic bound on the search.
    pub steps: usize,
    /// Whether a limit was hit in a branch that failed.
    pub limit: Option<&'static str>,
    /// At how many points the goal was seen to hold while a counterexample was sought.
    pub points: usize,
    /// What certificates were found for a polynomial under constraints: all signs if none was.
    pub certified: HashMap<(Polynomial, Vec<Constraint>), Signs>,
}

impl Engine {
    /// Counts a step of the search.
    pub fn tick(&mut self) -> Result<(), Failure> {
        if self.steps == 0 {
            self.limit = Some("steps");
            return Err(Failure::Limit("steps"));
        }
        self.steps -= 1;
        if self.steps.is_multiple_of(64)
            && let Some(deadline) = self.deadline
            && Instant::now() > deadline
        {
            self.limit = Some("time");
            self.steps = 0;
            return Err(Failure::Limit("time"));
        }
        Ok(())
    }

    /// Runs a step, and remembers the limit at which it ended, if it did.
    pub fn attempt<T>(&mut self, step: impl FnOnce(&mut Self) -> Result<T, Failure>) -> Result<T, Failure> {
        let result = step(self);
        if let Err(Failure::Limit(name)) = &result {
            self.limit = Some(name);
        }
        result
    }
}

impl From<crate::algebra::LimitReached> for Failure {
    fn from(reached: crate::algebra::LimitReached) -> Failure {
        use crate::algebra::Limit;
        Failure::Limit(match reached.limit {
            Limit::Terms => "terms",
            Limit::Degree => "degree",
            Limit::Bits => "digits",
            _ => "work",
        })
    }
}

/// The bit of a fact.
pub fn source(fact: usize) -> Sources {
    1u128 << fact.min(127)
}

/// An expression that is a name.
pub fn name_expr(name: &str) -> Expr {
    Expr { kind: crate::claim::syntax::ExprKind::Name(name.to_string()), span: Default::default() }
}
