//! Answers on demand: a quantity is computed when it is asked for, once, after what it needs.
//!
//! [`Quantity::needs`] drives the evaluation; [`Answers::computed`] tells afterwards what was done.

mod inserted;
mod matrices;
mod motion;
mod number;
mod transfer;

use super::quantity::{Input, Quantity};
use super::{Chain, Inserted, Scene, Start};
use crate::chain::best::Best;
use crate::chain::optimum::Optimum;
use crate::chain::pass::{MAX_PASS_BITS, Pass};
use crate::chain::threshold::Helps;
use crate::chain::uncertain::given::Given;
use crate::chain::uncertain::meeting::Meeting;
use crate::chain::uncertain::optimum::Measured;
use crate::chain::uncertain::{Coefficients, cells};
use crate::chain::{ChainError, MAX_LISTED, MAX_LISTED_UNEQUAL, Positive, Restitutions, limit_inserted};
use crate::number::decimal::bits_of_digits;
use crate::number::real::Level;
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
pub use number::Number;
use std::cell::OnceCell;

/// The answer to a question.
#[derive(Debug)]
pub enum Value {
    /// A number.
    Number(Number),
    /// A number for each body or collision.
    List(Vec<Number>),
    /// A matrix for each collision; a single one where all are the same.
    Matrices(Vec<[[Number; 2]; 2]>),
    /// Whether the last inserted body helps; `None` where that depends on the measured inputs.
    Helps(Option<Helps>),
    /// The same for each inserted body of given mass; see [`crate::chain::insertion`].
    EachHelps(Vec<Option<Helps>>),
    /// The least and the greatest best number of bodies over the box; equal where nothing is measured.
    Best(Best, Best),
    /// Whether bodies meet again.
    Recollides(Meeting),
    /// The chain, ready for the pass.
    Prepared(Prepared),
}

/// A chain with its masses.
#[derive(Debug)]
pub enum Prepared {
    /// Optimal masses.
    Optimal(Optimum),
    /// Given masses.
    Given(Pass),
    /// Measured masses or coefficients.
    Measured,
}

/// Refuses to list the velocities of too many bodies.
fn limit_listed(optimum: &Optimum) -> Result<(), ChainError> {
    match optimum.restitutions() {
        Restitutions::Same(_) => limit_inserted(optimum.collisions(), "listed bodies", MAX_LISTED)?,
        Restitutions::Each(_) => {
            let limit = "listed bodies with unequal coefficients";
            limit_inserted(optimum.collisions(), limit, MAX_LISTED_UNEQUAL)?;
        }
    }
    limit_inserted(optimum.listed_bits(), "bits of all exact velocities", MAX_PASS_BITS)?;
    Ok(())
}

type Cell = OnceCell<Result<(Value, Level), ChainError>>;

/// The answers to a scene, each computed at most once.
#[derive(Debug)]
pub struct Answers<'a> {
    scene: &'a Scene,
    cells: [Cell; Quantity::ALL.len()],
}

impl<'a> Answers<'a> {
    /// Nothing is computed yet.
    #[must_use]
    pub fn new(scene: &'a Scene) -> Answers<'a> {
        Answers { scene, cells: [const { OnceCell::new() }; Quantity::ALL.len()] }
    }

    /// The answer to one question, and the dearest level that it took.
    ///
    /// # Errors
    /// Why there is none.
    pub fn get(&self, quantity: Quantity) -> Result<(&Value, Level), ChainError> {
        if let Some(input) = self.scene.inputs.missing(quantity) {
            return Err(ChainError::Missing { quantity: quantity.name(), input: input.words() });
        }
        for need in quantity.needs().quantities {
            self.get(*need)?;
        }
        let cell = self.cells.get(quantity.index());
        let found = cell.map(|cell| cell.get_or_init(|| self.compute(quantity)));
        match found {
            Some(Ok((value, level))) => Ok((value, *level)),
            Some(Err(error)) => Err(error.clone()),
            None => Err(ChainError::NotAtRest),
        }
    }

    /// Takes an answer that was computed.
    pub fn take(&mut self, quantity: Quantity) -> Option<Value> {
        let cell = self.cells.get_mut(quantity.index())?;
        cell.take()?.ok().map(|(value, _)| value)
    }

    /// What was computed so far, in the order of [`Quantity::ALL`].
    #[must_use]
    pub fn computed(&self) -> Vec<Quantity> {
        self.of_state(true)
    }

    /// What was not.
    #[must_use]
    pub fn skipped(&self) -> Vec<Quantity> {
        self.of_state(false)
    }

    fn of_state(&self, computed: bool) -> Vec<Quantity> {
        let known = |q: &Quantity| self.cells.get(q.index()).is_some_and(|cell| cell.get().is_some());
        Quantity::ALL.into_iter().filter(|q| known(q) == computed).collect()
    }

    /// The chain, for what needs all of it.
    fn chain(&self) -> Result<&'a Chain, ChainError> {
        self.scene.inputs.whole("this")
    }

    /// The inserted bodies.
    fn inserted(&self) -> Result<&'a Inserted, ChainError> {
        let missing = ChainError::Missing { quantity: "this", input: Input::Inserted.words() };
        self.scene.inputs.inserted().ok_or(missing)
    }

    /// The coefficients of restitution.
    fn coefficients(&self) -> Result<&'a Coefficients, ChainError> {
        let missing = ChainError::Missing { quantity: "this", input: Input::Restitution.words() };
        self.scene.inputs.coefficients().ok_or(missing)
    }

    fn compute(&self, quantity: Quantity) -> Result<(Value, Level), ChainError> {
        match quantity {
            Quantity::Pass => Ok((Value::Prepared(self.prepare()?), Level::Exact)),
            Quantity::Eta => self.eta(),
            Quantity::Threshold => self.threshold(),
            Quantity::Helps => self.helps(),
            Quantity::Masses => self.masses(),
            Quantity::Velocities => self.velocities(),
            Quantity::LastVelocity => self.last_velocity(),
            Quantity::BestN => self.best(),
            Quantity::Matrix => self.matrices(),
            Quantity::Losses => self.losses(),
            Quantity::Recollides => self.recollides(),
        }
    }

    /// The chain where nothing is measured: first mass, last mass, coefficients.
    fn exact(&self) -> Option<(&'a Positive, &'a Positive, Restitutions)> {
        let chain = self.scene.inputs.chain()?;
        let both = (chain.first().single()?, chain.last().single()?);
        chain.is_exact().then(|| (both.0, both.1, chain.restitutions().0))
    }

    fn prepare(&self) -> Result<Prepared, ChainError> {
        let chain = self.chain()?;
        let Some((first, last, restitutions)) = self.exact() else { return Ok(Prepared::Measured) };
        match chain.inserted() {
            Inserted::Optimal(n) => Ok(Prepared::Optimal(Optimum::new(first.clone(), last.clone(), *n, restitutions)?)),
            Inserted::Given(_) => Ok(Prepared::Given(self.pass(restitutions)?)),
        }
    }

    /// The pass along given masses that are single numbers.
    fn pass(&self, restitutions: Restitutions) -> Result<Pass, ChainError> {
        let chain = self.chain()?;
        let masses = chain.masses().unwrap_or_default().into_iter().map(|m| m.lo().clone()).collect();
        match chain.start() {
            Start::Speed(speed) => Pass::from_rest(masses, restitutions, speed.clone()),
            Start::Velocities(list) => Pass::new(masses, restitutions, list.clone()),
        }
    }

    fn prepared(&self) -> Result<&Prepared, ChainError> {
        match self.get(Quantity::Pass)?.0 {
            Value::Prepared(prepared) => Ok(prepared),
            _ => Err(ChainError::NotAtRest),
        }
    }

    /// Bits of the ends of enclosures over a box of measured inputs: those of the digits that are shown.
    fn measured_bits(&self) -> u64 {
        bits_of_digits(self.scene.digits.plus(3).count()) + 16
    }

    /// The measured chain of given masses whose first body alone moves.
    fn given(&self) -> Result<Given, ChainError> {
        let chain = self.chain()?;
        let masses = chain.masses().unwrap_or_default();
        Given::new(masses, chain.coefficients().clone(), self.speed()?, self.measured_bits())
    }

    /// The measured chain of optimal masses.
    fn measured(&self, n: u64) -> Result<Measured, ChainError> {
        let chain = self.chain()?;
        let (first, last) = (chain.first().clone(), chain.last().clone());
        let found = Measured::new(first, last, n, chain.coefficients().clone(), self.speed()?, self.measured_bits());
        limit_listed(&found.corner()?)?;
        Ok(found)
    }

    /// The velocities of all bodies before, where others than the first move.
    fn moving_all(&self) -> Option<&'a [Rational]> {
        match self.scene.inputs.start() {
            Start::Velocities(list) if list.iter().skip(1).any(|v| *v != Rational::ZERO) => Some(list),
            _ => None,
        }
    }

    /// The first body moves towards others that are at rest.
    fn moving(&self) -> Result<(), ChainError> {
        let moves = match self.scene.inputs.start() {
            Start::Speed(speed) => *speed > Rational::ZERO,
            Start::Velocities(list) => match list.split_first() {
                Some((first, rest)) => *first > Rational::ZERO && rest.iter().all(|v| *v == Rational::ZERO),
                None => false,
            },
        };
        if moves { Ok(()) } else { Err(ChainError::NotAtRest) }
    }

    /// The speed of the first body, the others being at rest.
    fn speed(&self) -> Result<Rational, ChainError> {
        self.moving()?;
        match self.scene.inputs.start() {
            Start::Speed(speed) => Ok(speed.clone()),
            Start::Velocities(list) => Ok(list.first().cloned().unwrap_or(Rational::ZERO)),
        }
    }

    /// The pass over the box of measured inputs, others than the first body moving before.
    fn follow(&self, before: &[Rational]) -> Result<cells::Moving, ChainError> {
        cells::follow(&self.chain()?.masses().unwrap_or_default(), self.chain()?.coefficients(), before)
    }
}
