//! Scenes: a chain, what is asked of it, and the answers.
//!
//! [`read`] turns a TOML file into a [`Scene`]; [`answer`] computes what the scene wants and nothing else;
//! [`quantity`] holds the table of what needs what. [`mod@drop`] has balls that are dropped together. [`replay`] reads the scenes
//! of `carom replay`.

pub mod answer;
pub mod drop;
mod keys;
pub mod quantity;
pub mod read;
pub mod replay;
pub mod versions;

pub use crate::chain::uncertain::Coefficients;
use crate::chain::uncertain::Range;
use crate::chain::{ChainError, MAX_LISTED, Positive, Restitution, Restitutions, limit_inserted};
use crate::number::decimal::{Digits, Rounding};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Two};
use quantity::{Input, Quantity};

/// A chain and the questions about it.
#[derive(Clone, Debug)]
pub struct Scene {
    /// What is asked, in the order of the answers.
    pub want: Vec<Quantity>,
    /// The digits of each decimal.
    pub digits: Digits,
    /// The direction of rounding.
    pub rounding: Rounding,
    /// What is known of the chain.
    pub inputs: Inputs,
}

/// What a scene says of itself, for sheets and pictures.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct About {
    /// Its title.
    pub title: Option<String>,
    /// A sentence or two for those who work with it.
    pub text: Option<String>,
    /// The unit of masses.
    pub mass: Option<String>,
    /// The unit of velocities.
    pub velocity: Option<String>,
    /// The unit of heights.
    pub height: Option<String>,
}

impl Scene {
    /// The first quantity that is wanted without an input that it needs.
    #[must_use]
    pub fn missing(&self) -> Option<(Quantity, Input)> {
        self.want.iter().find_map(|quantity| Some((*quantity, self.inputs.missing(*quantity)?)))
    }
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

/// What is known of a chain: all of it, or as much as some quantities need ([`Quantity::needs`]).
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Inputs {
    /// All of it.
    Whole(Chain),
    /// A part.
    Part(Part),
}

/// A chain of which the inserted bodies or the coefficients of restitution are not known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    first: Range<Positive>,
    last: Range<Positive>,
    inserted: Option<Inserted>,
    coefficients: Option<Coefficients>,
    start: Start,
}

impl From<Chain> for Inputs {
    fn from(chain: Chain) -> Inputs {
        Inputs::Whole(chain)
    }
}

impl Inputs {
    /// What is known; lists fit together as far as they are there.
    ///
    /// # Errors
    /// As [`Chain::new`].
    pub fn new(
        first: Range<Positive>,
        last: Range<Positive>,
        inserted: Option<Inserted>,
        coefficients: Option<Coefficients>,
        start: Start,
    ) -> Result<Inputs, ChainError> {
        let inserted = inserted.map(Inserted::normal);
        match (inserted, coefficients) {
            (Some(inserted), Some(coefficients)) => {
                Ok(Inputs::Whole(Chain::new(first, last, inserted, coefficients, start)?))
            }
            (inserted, coefficients) => {
                fit(inserted.as_ref(), coefficients.as_ref(), &start)?;
                Ok(Inputs::Part(Part { first, last, inserted, coefficients, start }))
            }
        }
    }

    /// The chain, where all of it is known.
    #[must_use]
    pub fn chain(&self) -> Option<&Chain> {
        match self {
            Self::Whole(chain) => Some(chain),
            Self::Part(_) => None,
        }
    }

    /// The chain for something that needs all of it, such as a worksheet.
    ///
    /// # Errors
    /// [`ChainError::Missing`].
    pub fn whole(&self, needed_by: &'static str) -> Result<&Chain, ChainError> {
        let missing = if self.has(Input::Inserted) { Input::Restitution } else { Input::Inserted };
        self.chain().ok_or(ChainError::Missing { quantity: needed_by, input: missing.words() })
    }

    /// The masses of the first and of the last body.
    #[must_use]
    pub fn ends(&self) -> (&Range<Positive>, &Range<Positive>) {
        match self {
            Self::Whole(chain) => (&chain.first, &chain.last),
            Self::Part(part) => (&part.first, &part.last),
        }
    }

    /// The inserted bodies, where they are known.
    #[must_use]
    pub fn inserted(&self) -> Option<&Inserted> {
        match self {
            Self::Whole(chain) => Some(&chain.inserted),
            Self::Part(part) => part.inserted.as_ref(),
        }
    }

    /// The coefficients of restitution, where they are known.
    #[must_use]
    pub fn coefficients(&self) -> Option<&Coefficients> {
        match self {
            Self::Whole(chain) => Some(&chain.coefficients),
            Self::Part(part) => part.coefficients.as_ref(),
        }
    }

    /// The velocities before the pass.
    #[must_use]
    pub fn start(&self) -> &Start {
        match self {
            Self::Whole(chain) => &chain.start,
            Self::Part(part) => &part.start,
        }
    }

    fn has(&self, input: Input) -> bool {
        match input {
            Input::Inserted => self.inserted().is_some(),
            Input::Restitution => self.coefficients().is_some(),
        }
    }

    /// The first input that a quantity needs, by itself or for another one, and that is not here.
    #[must_use]
    pub fn missing(&self, quantity: Quantity) -> Option<Input> {
        let needs = quantity.needs();
        let own = needs.inputs.iter().copied().find(|input| !self.has(*input));
        own.or_else(|| needs.quantities.iter().find_map(|other| self.missing(*other)))
    }

    /// Whether every mass and coefficient that is known is a single number.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        let (first, last) = self.ends();
        let ends = first.single().is_some() && last.single().is_some();
        ends && self.inserted().is_none_or(Inserted::is_exact) && self.coefficients().is_none_or(Coefficients::is_exact)
    }
}

fn middle(lo: &Rational, hi: &Rational) -> Rational {
    (lo + hi) / Rational::TWO
}

/// Refuses lists that do not fit together, and more bodies than are allowed.
fn fit(inserted: Option<&Inserted>, coefficients: Option<&Coefficients>, start: &Start) -> Result<(), ChainError> {
    let Some(inserted) = inserted else { return Ok(()) };
    let n = inserted.count();
    match inserted {
        Inserted::Optimal(_) if matches!(start, Start::Velocities(_)) => return Err(ChainError::NeedsGivenMasses),
        Inserted::Optimal(_) => {}
        Inserted::Given(_) => limit_inserted(n, "listed bodies", MAX_LISTED)?,
    }
    limit_inserted(n, "inserted bodies", crate::chain::MAX_INSERTED)?;
    let check = |of: &'static str, given: usize, needed: u64| {
        let given = given as u64;
        if given == needed { Ok(()) } else { Err(ChainError::Count { of, given, needed }) }
    };
    if let Some(Coefficients::Each(list)) = coefficients {
        check("coefficients of restitution", list.len(), n + 1)?;
    }
    if let Start::Velocities(list) = start {
        check("velocities", list.len(), n + 2)?;
    }
    Ok(())
}

impl Inserted {
    /// How many bodies are inserted.
    #[must_use]
    pub fn count(&self) -> u64 {
        match self {
            Self::Optimal(n) => *n,
            Self::Given(masses) => masses.len() as u64,
        }
    }

    /// Whether every given mass is a single number.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        match self {
            Self::Optimal(_) => true,
            Self::Given(masses) => masses.iter().all(|m| m.single().is_some()),
        }
    }

    /// Without inserted bodies nothing is to be optimised.
    fn normal(self) -> Inserted {
        if self == Inserted::Optimal(0) { Inserted::Given(Vec::new()) } else { self }
    }
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
        let inserted = inserted.normal();
        fit(Some(&inserted), Some(&coefficients), &start)?;
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
        self.inserted.count()
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

    /// As [`Coefficients::common`].
    ///
    /// # Errors
    /// [`ChainError::UnequalRestitutions`] naming the quantity.
    pub fn common_restitution(&self, quantity: &'static str) -> Result<Range<Restitution>, ChainError> {
        self.coefficients.common(quantity)
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

    /// The chain of the middle of each measured value; an exact chain is its own.
    ///
    /// # Errors
    /// None for a chain: between two masses lies a mass, and so for coefficients.
    pub fn midpoint(&self) -> Result<Chain, ChainError> {
        let mass = |m: &Range<Positive>| Positive::new(middle(m.lo().value(), m.hi().value())).map(Range::point);
        let e = |e: &Range<Restitution>| Restitution::new(middle(e.lo().value(), e.hi().value())).map(Range::point);
        let inserted = match &self.inserted {
            Inserted::Given(list) => Inserted::Given(list.iter().map(mass).collect::<Result<_, _>>()?),
            optimal => optimal.clone(),
        };
        let coefficients = match &self.coefficients {
            Coefficients::Same(one) => Coefficients::Same(e(one)?),
            Coefficients::Each(list) => Coefficients::Each(list.iter().map(e).collect::<Result<_, _>>()?),
        };
        Chain::new(mass(&self.first)?, mass(&self.last)?, inserted, coefficients, self.start.clone())
    }

    /// Whether every mass and coefficient is a single number.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        let ends = self.first.single().is_some() && self.last.single().is_some();
        ends && self.inserted.is_exact() && self.coefficients.is_exact()
    }
}

impl Start {
    /// The first body moves with velocity 1.
    #[must_use]
    pub fn unit() -> Start {
        Start::Speed(Rational::ONE)
    }
}
