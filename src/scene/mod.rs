//! Scenes: a chain, what is asked of it, and the answers.
//!
//! [`read`] turns a TOML file into a [`Scene`]; [`answer`] computes what the scene wants and nothing else;
//! [`quantity`] holds the table of what needs what. [`replay`] reads the scenes of `carom replay`.

pub mod answer;
pub mod quantity;
pub mod read;
pub mod replay;

pub use crate::chain::uncertain::Coefficients;
use crate::chain::uncertain::Range;
use crate::chain::{ChainError, MAX_LISTED, Positive, Restitution, Restitutions, limit_inserted};
use crate::number::decimal::{Digits, Rounding};
use malachite::Rational;
use malachite::base::num::basic::traits::One;
use quantity::Quantity;

/// A chain and the questions about it.
#[derive(Clone, Debug)]
pub struct Scene {
    /// What is asked, in the order of the answers.
    pub want: Vec<Quantity>,
    /// The digits of each decimal.
    pub digits: Digits,
    /// The direction of rounding.
    pub rounding: Rounding,
    /// The chain.
    pub chain: Chain,
}

/// The inserted bodies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Inserted {
    /// So many, of optimal mass.
    Optimal(u64),
    /// These masses.
    Given(Vec<Range<Positive>>),
}

/// The velocities before the pass.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Start {
    /// The first body moves, the others are at rest.
    Speed(Rational),
    /// One velocity for each body.
    Velocities(Vec<Rational>),
}

/// A chain as a scene describes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chain {
    first: Range<Positive>,
    last: Range<Positive>,
    inserted: Inserted,
    coefficients: Coefficients,
    start: Start,
}

impl Chain {
    /// A chain whose lists fit together.
    ///
    /// # Errors
    /// [`ChainError::Count`], or a limit on the length of lists.
    pub fn new(
        first: Range<Positive>,
        last: Range<Positive>,
        inserted: Inserted,
        coefficients: Coefficients,
        start: Start,
    ) -> Result<Chain, ChainError> {
        // Without inserted bodies nothing is to be optimised.
        let inserted = if inserted == Inserted::Optimal(0) { Inserted::Given(Vec::new()) } else { inserted };
        let n = match &inserted {
            Inserted::Optimal(_) if matches!(start, Start::Velocities(_)) => return Err(ChainError::NeedsGivenMasses),
            Inserted::Optimal(n) => *n,
            Inserted::Given(masses) => masses.len() as u64,
        };
        if let Inserted::Given(_) = inserted {
            limit_inserted(n, "listed bodies", MAX_LISTED)?;
        }
        limit_inserted(n, "inserted bodies", crate::chain::MAX_INSERTED)?;
        let check = |of: &'static str, given: usize, needed: u64| {
            let given = given as u64;
            if given == needed { Ok(()) } else { Err(ChainError::Count { of, given, needed }) }
        };
        if let Coefficients::Each(list) = &coefficients {
            check("coefficients of restitution", list.len(), n + 1)?;
        }
        if let Start::Velocities(list) = &start {
            check("velocities", list.len(), n + 2)?;
        }
        Ok(Chain { first, last, inserted, coefficients, start })
    }

    /// The first body's mass.
    #[must_use]
    pub fn first(&self) -> &Range<Positive> {
        &self.first
    }

    /// The last body's mass.
    #[must_use]
    pub fn last(&self) -> &Range<Positive> {
        &self.last
    }

    /// The inserted bodies.
    #[must_use]
    pub fn inserted(&self) -> &Inserted {
        &self.inserted
    }

    /// How many bodies are inserted.
    #[must_use]
    pub fn count(&self) -> u64 {
        match &self.inserted {
            Inserted::Optimal(n) => *n,
            Inserted::Given(masses) => masses.len() as u64,
        }
    }

    /// The velocities before the pass.
    #[must_use]
    pub fn start(&self) -> &Start {
        &self.start
    }

    /// The coefficients of restitution as they were given.
    #[must_use]
    pub fn coefficients(&self) -> &Coefficients {
        &self.coefficients
    }

    /// The coefficients at their lower and at their upper ends.
    #[must_use]
    pub fn restitutions(&self) -> (Restitutions, Restitutions) {
        match &self.coefficients {
            Coefficients::Same(e) => (Restitutions::Same(e.lo().clone()), Restitutions::Same(e.hi().clone())),
            Coefficients::Each(list) => {
                let side = |end: fn(&Range<Restitution>) -> &Restitution| {
                    let list: Vec<Restitution> = list.iter().map(|e| end(e).clone()).collect();
                    // The length was checked when the chain was made.
                    let n = self.count();
                    Restitutions::Each(list.clone()).for_inserted(n).unwrap_or(Restitutions::Each(list))
                };
                (side(Range::lo), side(Range::hi))
            }
        }
    }

    /// The one coefficient of all collisions. Equal ranges in a list are not one: each of them has a value of its own.
    ///
    /// # Errors
    /// [`ChainError::UnequalRestitutions`] naming the quantity.
    pub fn common_restitution(&self, quantity: &'static str) -> Result<Range<Restitution>, ChainError> {
        match &self.coefficients {
            Coefficients::Same(e) => Ok(e.clone()),
            Coefficients::Each(list) => match list.first() {
                Some(first) if first.single().is_some() && list.iter().all(|e| e == first) => Ok(first.clone()),
                _ => Err(ChainError::UnequalRestitutions { quantity }),
            },
        }
    }

    /// All masses in order, where they are given.
    #[must_use]
    pub fn masses(&self) -> Option<Vec<Range<Positive>>> {
        let Inserted::Given(inserted) = &self.inserted else { return None };
        let mut masses = vec![self.first.clone()];
        masses.extend(inserted.iter().cloned());
        masses.push(self.last.clone());
        Some(masses)
    }

    /// Whether every mass and coefficient is a single number.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        let ends = self.first.single().is_some() && self.last.single().is_some();
        let inserted = match &self.inserted {
            Inserted::Optimal(_) => true,
            Inserted::Given(masses) => masses.iter().all(|m| m.single().is_some()),
        };
        let coefficients = match &self.coefficients {
            Coefficients::Same(e) => e.single().is_some(),
            Coefficients::Each(list) => list.iter().all(|e| e.single().is_some()),
        };
        ends && inserted && coefficients
    }
}

impl Start {
    /// The first body moves with velocity 1.
    #[must_use]
    pub fn unit() -> Start {
        Start::Speed(Rational::ONE)
    }
}
