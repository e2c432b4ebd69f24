//! The physics of one pass along a chain: body 0 strikes body 1, which strikes body 2, and so on.
//!
//! Notation: `m1` the first body's mass, `m2` the last one's, `n` bodies inserted between them, `N = n + 1`
//! collisions, `r = m1/m2`, `x = r^(1/N)`, `e` the coefficient of restitution.
//!
//! # Which results are rational
//!
//! **Lemma.** Let `x > 0` be irrational with `x^N` rational, and let `k >= 2` be least with `x^k` rational. Then
//! `1, x, …, x^(k−1)` are independent over Q. *Proof.* The minimal polynomial of `x` divides `T^k − x^k`, whose
//! roots all have absolute value `x`; its constant term is rational and in size `x^d`, `d` its degree; so
//! `x^d` is rational and `d >= k`. ∎
//!
//! Every power of `x` is a positive rational times one of these `k` basis elements, so a polynomial in `x`
//! is rational only if the other coefficients cancel. With irrational `x`:
//! - `(1 + x)^m`, `m >= 1`, is irrational: all coefficients are positive, that of `x` included. Hence `eta` and the
//!   last body's velocity are rational iff `x` is.
//! - `x^i·(x − e) = c·(1 + x)^(i+1)` has no rational solution `c`: at `x^(i+1)` it asks for `c > 0`, and at `x^i` (another
//!   basis element) for `c·positive = −e`. Hence each body's velocity is rational iff `x` is.
//! - `x^(i−1) = c·(1 + x)^(2i−1)`: the left has one basis element, the right at least two. Hence the energy lost in
//!   a collision with `e < 1` is rational iff `x` is.
//! - `L_n + 1 = (1 + a)^(n+1)/(1 + b)^n` with `a = r^(1/(n+1))`, `b = r^(1/n)`: the degrees of `a` and `b` divide `n + 1`
//!   and `n`, which have no common factor, so Q(a) and Q(b) share only Q; if `L_n` is rational, both powers
//!   are, and then `a` and `b` are. Hence `L_n` is rational iff `r` is an `n(n+1)`-th power.
//!
//! So each result is either an exact rational or known to be irrational, which is what
//! [`crate::number::real::Real`] asks for.

pub mod best;
pub mod bounces;
pub mod collision;
pub mod fast;
pub mod insertion;
pub mod optimum;
pub mod pass;
pub mod recollision;
pub mod replay;
pub mod rows;
pub mod threshold;
pub mod transfer;
pub mod uncertain;

use crate::number::NumberError;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::fmt;

/// The most inserted bodies; with more, exponents no longer fit a machine word.
pub const MAX_INSERTED: u64 = 1_000_000_000_000_000_000;

/// The most bodies of which each one's value is listed.
pub const MAX_LISTED: u64 = 1_000_000;

/// The same with optimal masses and unequal coefficients, whose products are formed for each body.
pub(crate) const MAX_LISTED_UNEQUAL: u64 = 2_000;

/// The most bits of an exact power that is written down; a longer rational is enclosed instead.
pub(crate) const MAX_EXACT_BITS: u64 = 1 << 20;

/// Why a chain has no answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ChainError {
    /// A mass that is not above zero.
    NotPositive {
        /// What was given.
        value: Rational,
    },
    /// A coefficient of restitution outside of [0, 1].
    NotRestitution {
        /// What was given.
        value: Rational,
    },
    /// So many coefficients or velocities do not fit so many bodies.
    Count {
        /// Of what.
        of: &'static str,
        /// How many there are.
        given: u64,
        /// How many there must be.
        needed: u64,
    },
    /// A collision of the pass does not take place: the body behind is not faster.
    NoCollision {
        /// Its number, from 1.
        collision: usize,
        /// The velocities of the body behind, when it should strike, and of the body in front.
        velocities: Box<(Rational, Rational)>,
    },
    /// With measured inputs, a collision takes place for some of their values at most, as far as bounds tell.
    MayNotCollide {
        /// Its number, from 1.
        collision: usize,
    },
    /// One coefficient of restitution for all collisions is needed here.
    UnequalRestitutions {
        /// For what.
        quantity: &'static str,
    },
    /// What is asked for is defined for a first body that moves forward and all others at rest.
    NotAtRest,
    /// A quantity that is not computed for measured inputs.
    Measured {
        /// Which.
        quantity: &'static str,
    },
    /// Velocities of all bodies with masses that are not given.
    NeedsGivenMasses,
    /// A question about bodies of optimal mass, asked of given masses.
    NeedsOptimalMasses,
    /// An input is missing.
    Missing {
        /// What was asked.
        quantity: &'static str,
        /// What it needs.
        input: &'static str,
    },
    /// The number itself.
    Number(NumberError),
}

impl fmt::Display for ChainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotPositive { value } => write!(f, "a mass must be above 0, not {value}"),
            Self::NotRestitution { value } => {
                write!(f, "a coefficient of restitution must lie from 0 to 1, not {value}")
            }
            Self::Count { of, given, needed } => write!(f, "{needed} {of} are needed, {given} are given"),
            Self::NoCollision { collision, velocities } => write!(
                f,
                "collision {collision} does not take place: the body behind arrives at {}, the one in front moves at {}",
                velocities.0, velocities.1
            ),
            Self::MayNotCollide { collision } => {
                write!(
                    f,
                    "for some values of the measured inputs, collision {collision} does not take place: give narrower ranges"
                )
            }
            Self::UnequalRestitutions { quantity } => {
                write!(f, "{quantity} needs the same coefficient of restitution at all collisions")
            }
            Self::NotAtRest => {
                write!(f, "the first body must move forward (velocity above 0), and all others must be at rest")
            }
            Self::Measured { quantity } => {
                write!(f, "{quantity} is not computed for measured inputs: give exact masses and coefficients")
            }
            Self::NeedsGivenMasses => {
                write!(
                    f,
                    "velocities of all bodies need a list of inserted masses; bodies of optimal mass start at rest"
                )
            }
            Self::NeedsOptimalMasses => {
                write!(f, "this needs inserted bodies of optimal mass: leave the list of inserted masses out")
            }
            Self::Missing { quantity, input } => write!(f, "{quantity} needs {input}"),
            Self::Number(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for ChainError {}

impl From<NumberError> for ChainError {
    fn from(error: NumberError) -> Self {
        Self::Number(error)
    }
}

/// A rational above zero: a mass, or a ratio of masses.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Positive(Rational);

impl Positive {
    /// Checks that the number is above zero.
    ///
    /// # Errors
    /// [`ChainError::NotPositive`].
    pub fn new(value: Rational) -> Result<Positive, ChainError> {
        if value > Rational::ZERO { Ok(Positive(value)) } else { Err(ChainError::NotPositive { value }) }
    }

    /// The number.
    #[must_use]
    pub fn value(&self) -> &Rational {
        &self.0
    }

    /// The quotient.
    #[must_use]
    pub fn over(&self, other: &Positive) -> Positive {
        Positive(&self.0 / &other.0)
    }
}

/// A coefficient of restitution, from 0 to 1.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Restitution(Rational);

impl Restitution {
    /// Checks that the number lies from 0 to 1.
    ///
    /// # Errors
    /// [`ChainError::NotRestitution`].
    pub fn new(value: Rational) -> Result<Restitution, ChainError> {
        if value >= Rational::ZERO && value <= Rational::ONE {
            Ok(Restitution(value))
        } else {
            Err(ChainError::NotRestitution { value })
        }
    }

    /// The number.
    #[must_use]
    pub fn value(&self) -> &Rational {
        &self.0
    }

    /// `1 + e`.
    #[must_use]
    pub fn plus_one(&self) -> Rational {
        &self.0 + Rational::ONE
    }
}

/// The coefficients of restitution of a chain's collisions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Restitutions {
    /// One for all.
    Same(Restitution),
    /// One for each collision, in order.
    Each(Vec<Restitution>),
}

impl Restitutions {
    /// Checks that there are enough for `n` inserted bodies; a list of equal ones becomes [`Self::Same`].
    ///
    /// # Errors
    /// [`ChainError::Count`].
    pub fn for_inserted(self, n: u64) -> Result<Restitutions, ChainError> {
        match self {
            Self::Same(e) => Ok(Self::Same(e)),
            Self::Each(list) => {
                let given = list.len() as u64;
                if n.checked_add(1) != Some(given) {
                    return Err(ChainError::Count {
                        of: "coefficients of restitution",
                        given,
                        needed: n.saturating_add(1),
                    });
                }
                match list.first() {
                    Some(first) if list.iter().all(|e| e == first) => Ok(Self::Same(first.clone())),
                    _ => Ok(Self::Each(list)),
                }
            }
        }
    }

    /// The one coefficient of all collisions.
    ///
    /// # Errors
    /// [`ChainError::UnequalRestitutions`] naming the quantity.
    pub fn common(&self, quantity: &'static str) -> Result<&Restitution, ChainError> {
        match self {
            Self::Same(e) => Ok(e),
            Self::Each(_) => Err(ChainError::UnequalRestitutions { quantity }),
        }
    }

    /// The coefficient of a collision, counted from 0; `None` beyond the last.
    #[must_use]
    pub fn at(&self, collision: u64) -> Option<&Restitution> {
        match self {
            Self::Same(e) => Some(e),
            Self::Each(list) => list.get(usize::try_from(collision).ok()?),
        }
    }
}

/// Refuses a number of inserted bodies beyond a limit.
pub(crate) fn limit_inserted(n: u64, limit: &'static str, allowed: u64) -> Result<(), NumberError> {
    if n > allowed {
        return Err(NumberError::LimitReached { limit, allowed, needed: n.to_string() });
    }
    Ok(())
}
