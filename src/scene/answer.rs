//! Answers on demand: a quantity is computed when it is asked for, once, after what it needs.
//!
//! [`Quantity::needs`] drives the evaluation; [`Answers::computed`] tells afterwards what was done.

use super::quantity::Quantity;
use super::{Chain, Inserted, Scene, Start};
use crate::chain::best::{Best, best};
use crate::chain::optimum::Optimum;
use crate::chain::pass::{MAX_PASS_BITS, Pass};
use crate::chain::threshold::{Helps, helps, threshold};
use crate::chain::uncertain::{self, Range, Reals};
use crate::chain::{
    ChainError, MAX_LISTED, MAX_LISTED_UNEQUAL, Positive, Restitutions, collision, limit_inserted, recollision,
    transfer,
};
use crate::number::decimal::{Decimal, Rounding, bits_of_digits};
use crate::number::real::{Level, Real};
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
use std::cell::OnceCell;

/// A number that is ready to be printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Number {
    /// Exactly, where it is rational and short.
    pub exact: Option<Rational>,
    /// The closed form, where it is irrational and one is known.
    pub radical: Option<String>,
    /// Decimals that enclose it, or all its values over the box of a measured scene.
    pub enclosure: (String, String),
    /// Correctly rounded; `None` where the values over a box do not round to one decimal.
    pub decimal: Option<String>,
}

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
    /// The least and the greatest best number of bodies over the box; equal where nothing is measured.
    Best(Best, Best),
    /// Whether bodies meet again; `None` where that depends on the measured inputs.
    Recollides(Option<bool>),
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
        for need in quantity.needs() {
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

    fn chain(&self) -> &'a Chain {
        &self.scene.chain
    }

    fn compute(&self, quantity: Quantity) -> Result<(Value, Level), ChainError> {
        match quantity {
            Quantity::Pass => Ok((Value::Prepared(self.prepare()?), Level::Exact)),
            Quantity::Eta => self.eta(),
            Quantity::Threshold => self.threshold(),
            Quantity::Helps => self.helps(),
            Quantity::Masses => self.masses(),
            Quantity::Velocities => self.velocities(),
            Quantity::BestN => self.best(),
            Quantity::Matrix => self.matrices(),
            Quantity::Losses => self.losses(),
            Quantity::Recollides => self.recollides(),
        }
    }

    /// The chain where nothing is measured: first mass, last mass, coefficients.
    fn exact(&self) -> Option<(&'a Positive, &'a Positive, Restitutions)> {
        let chain = self.chain();
        let both = (chain.first().single()?, chain.last().single()?);
        chain.is_exact().then(|| (both.0, both.1, chain.restitutions().0))
    }

    fn prepare(&self) -> Result<Prepared, ChainError> {
        let chain = self.chain();
        let Some((first, last, restitutions)) = self.exact() else { return Ok(Prepared::Measured) };
        match chain.inserted() {
            Inserted::Optimal(n) => Ok(Prepared::Optimal(Optimum::new(first.clone(), last.clone(), *n, restitutions)?)),
            Inserted::Given(_) => Ok(Prepared::Given(self.pass(restitutions)?)),
        }
    }

    /// The pass along given masses that are single numbers.
    fn pass(&self, restitutions: Restitutions) -> Result<Pass, ChainError> {
        let chain = self.chain();
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

    fn measured_only(quantity: Quantity) -> ChainError {
        ChainError::Measured { quantity: quantity.name() }
    }

    fn number(&self, x: &Real) -> Result<(Number, Level), ChainError> {
        let (found, level) = Decimal::with_enclosure(x, self.scene.digits, self.scene.rounding)?;
        let number = Number {
            exact: x.as_rational().cloned(),
            radical: x.radical().map(str::to_owned),
            enclosure: (found.lower.to_string(), found.upper.to_string()),
            decimal: Some(found.decimal.to_string()),
        };
        Ok((number, level))
    }

    fn list(&self, list: impl Iterator<Item = Real>) -> Result<(Value, Level), ChainError> {
        let mut dearest = Level::Double;
        let mut numbers = Vec::new();
        for x in list {
            let (number, level) = self.number(&x)?;
            dearest = dearest.max(level);
            numbers.push(number);
        }
        Ok((Value::List(numbers), dearest))
    }

    /// All values between two reals, as one enclosure.
    fn between(&self, range: &Reals) -> Result<(Number, Level), ChainError> {
        let longer = self.scene.digits.plus(3);
        let (lower, level) = Decimal::of_real(&range.least, longer, Rounding::Down)?;
        let (upper, other) = Decimal::of_real(&range.greatest, longer, Rounding::Up)?;
        let round = |x: &Real| Decimal::of_real(x, self.scene.digits, self.scene.rounding);
        let (least, greatest) = (round(&range.least)?.0, round(&range.greatest)?.0);
        let decimal = (least == greatest).then(|| least.to_string());
        let enclosure = (lower.to_string(), upper.to_string());
        Ok((Number { exact: None, radical: None, enclosure, decimal }, level.max(other)))
    }

    fn eta(&self) -> Result<(Value, Level), ChainError> {
        let chain = self.chain();
        let wrap = |(number, level)| (Value::Number(number), level);
        match (self.exact(), chain.inserted()) {
            (Some((first, last, restitutions)), Inserted::Optimal(n)) => {
                self.moving()?;
                self.number(&transfer::optimal(&first.over(last), &restitutions, *n)?).map(wrap)
            }
            (Some((_, _, restitutions)), Inserted::Given(_)) => {
                self.number(&Real::rational(self.pass(restitutions)?.transfer()?)).map(wrap)
            }
            (None, Inserted::Optimal(n)) => {
                self.moving()?;
                let (lower, upper) = chain.restitutions();
                let range = uncertain::optimal_transfer(chain.first(), chain.last(), (&lower, &upper), *n)?;
                self.between(&range).map(wrap)
            }
            (None, Inserted::Given(_)) => self.eta_of_measured_masses().map(wrap),
        }
    }

    /// The first body moves towards others that are at rest.
    fn moving(&self) -> Result<(), ChainError> {
        let moves = match self.chain().start() {
            Start::Speed(speed) => *speed > Rational::ZERO,
            Start::Velocities(list) => match list.split_first() {
                Some((first, rest)) => *first > Rational::ZERO && rest.iter().all(|v| *v == Rational::ZERO),
                None => false,
            },
        };
        if moves { Ok(()) } else { Err(ChainError::NotAtRest) }
    }

    fn eta_of_measured_masses(&self) -> Result<(Number, Level), ChainError> {
        self.moving()?;
        let masses = self.chain().masses().unwrap_or_default();
        let (lower, upper) = self.chain().restitutions();
        let least = Real::rational(uncertain::least_transfer(&masses, &lower)?);
        // Known only by enclosures: whether it is a short decimal is not asked.
        let digits = self.scene.digits.plus(3);
        let mut bits = bits_of_digits(digits.count()) + 64;
        let greatest = loop {
            let enclosure = uncertain::greatest_transfer(&masses, &upper, bits)?;
            let narrow = enclosure.accuracy() > bits_of_digits(digits.count()) + 8;
            if narrow && let Some((_, top)) = enclosure.ends() {
                break (enclosure, top.point());
            }
            bits *= 2;
        };
        let (lower, _) = Decimal::of_real(&least, digits, Rounding::Down)?;
        let upper = greatest.1.map(|top| Decimal::of_rational(&top, digits, Rounding::Up)).transpose()?;
        let upper = upper.map_or_else(|| "1".to_owned(), |d| d.to_string());
        let rounded = Decimal::of_interval(&greatest.0, self.scene.digits, self.scene.rounding);
        let (least, _) = Decimal::of_real(&least, self.scene.digits, self.scene.rounding)?;
        let decimal = rounded.filter(|d| *d == least).map(|d| d.to_string());
        let enclosure = (lower.to_string(), upper);
        Ok((Number { exact: None, radical: None, enclosure, decimal }, Level::Interval(bits)))
    }

    fn threshold(&self) -> Result<(Value, Level), ChainError> {
        let chain = self.chain();
        let n = chain.count();
        let (number, level) = match (chain.first().single(), chain.last().single()) {
            (Some(first), Some(last)) => self.number(&threshold(&first.over(last), n)?)?,
            _ => self.between(&uncertain::threshold(chain.first(), chain.last(), n)?)?,
        };
        Ok((Value::Number(number), level))
    }

    fn helps(&self) -> Result<(Value, Level), ChainError> {
        let chain = self.chain();
        let e = chain.common_restitution("helps")?;
        let (answer, level) = match (chain.first().single(), chain.last().single(), e.single()) {
            (Some(first), Some(last), Some(e)) => {
                let (answer, level) = helps(e, &first.over(last), chain.count())?;
                (Some(answer), level)
            }
            _ => uncertain::helps_over(chain.first(), chain.last(), &e, chain.count())?,
        };
        Ok((Value::Helps(answer), level))
    }

    fn best(&self) -> Result<(Value, Level), ChainError> {
        let chain = self.chain();
        let e = chain.common_restitution("best-n")?;
        match (chain.first().single(), chain.last().single(), e.single()) {
            (Some(first), Some(last), Some(e)) => {
                let (found, level) = best(&first.over(last), e)?;
                Ok((Value::Best(found.clone(), found), level))
            }
            _ => {
                let ((least, greatest), level) = uncertain::best_over(chain.first(), chain.last(), &e)?;
                Ok((Value::Best(least, greatest), level))
            }
        }
    }

    fn masses(&self) -> Result<(Value, Level), ChainError> {
        let chain = self.chain();
        match self.prepared()? {
            Prepared::Optimal(optimum) => {
                limit_inserted(optimum.collisions(), "listed bodies", MAX_LISTED)?;
                self.list((0..=optimum.collisions()).map(|i| optimum.mass(i)))
            }
            Prepared::Given(pass) => self.list(pass.masses().iter().map(|m| Real::rational(m.value().clone()))),
            Prepared::Measured => {
                let ranges: Vec<Reals> = match chain.inserted() {
                    Inserted::Given(_) => {
                        let real = |m: &Positive| Real::rational(m.value().clone());
                        let range = |m: Range<Positive>| Reals { least: real(m.lo()), greatest: real(m.hi()) };
                        chain.masses().unwrap_or_default().into_iter().map(range).collect()
                    }
                    Inserted::Optimal(n) => {
                        limit_inserted(*n, "listed bodies", MAX_LISTED)?;
                        let (lower, upper) = chain.restitutions();
                        let (first, last) = (chain.first(), chain.last());
                        let low = Optimum::new(first.lo().clone(), last.lo().clone(), *n, lower)?;
                        let high = Optimum::new(first.hi().clone(), last.hi().clone(), *n, upper)?;
                        (0..=low.collisions()).map(|i| Reals { least: low.mass(i), greatest: high.mass(i) }).collect()
                    }
                };
                let mut dearest = Level::Double;
                let mut numbers = Vec::new();
                for range in &ranges {
                    let (number, level) = self.between(range)?;
                    dearest = dearest.max(level);
                    numbers.push(number);
                }
                Ok((Value::List(numbers), dearest))
            }
        }
    }

    /// The speed of the first body, for chains of optimal masses.
    fn speed(&self) -> Result<Rational, ChainError> {
        self.moving()?;
        match self.chain().start() {
            Start::Speed(speed) => Ok(speed.clone()),
            Start::Velocities(list) => Ok(list.first().cloned().unwrap_or(Rational::ZERO)),
        }
    }

    fn velocities(&self) -> Result<(Value, Level), ChainError> {
        match self.prepared()? {
            Prepared::Optimal(optimum) => {
                limit_listed(optimum)?;
                let speed = self.speed()?;
                self.list((0..=optimum.collisions()).map(|i| optimum.velocity(i, &speed)))
            }
            Prepared::Given(pass) => self.list(pass.velocities_after()?.into_iter().map(Real::rational)),
            Prepared::Measured => Err(Self::measured_only(Quantity::Velocities)),
        }
    }

    fn losses(&self) -> Result<(Value, Level), ChainError> {
        match self.prepared()? {
            Prepared::Optimal(optimum) => {
                limit_listed(optimum)?;
                let speed = self.speed()?;
                self.list((1..=optimum.collisions()).map(|i| optimum.loss(i, &speed)))
            }
            Prepared::Given(pass) => self.list(pass.losses()?.into_iter().map(Real::rational)),
            Prepared::Measured => Err(Self::measured_only(Quantity::Losses)),
        }
    }

    fn matrices(&self) -> Result<(Value, Level), ChainError> {
        let Some((_, _, restitutions)) = self.exact() else {
            return Err(Self::measured_only(Quantity::Matrix));
        };
        let mut dearest = Level::Double;
        let mut matrices = Vec::new();
        let mut push = |entries: [[Real; 2]; 2]| -> Result<(), ChainError> {
            let mut ready = |x: &Real| -> Result<Number, ChainError> {
                let (number, level) = self.number(x)?;
                dearest = dearest.max(level);
                Ok(number)
            };
            let [[a, b], [c, d]] = entries;
            matrices.push([[ready(&a)?, ready(&b)?], [ready(&c)?, ready(&d)?]]);
            Ok(())
        };
        match self.prepared()? {
            Prepared::Optimal(optimum) => {
                if let Restitutions::Each(_) = restitutions {
                    limit_listed(optimum)?;
                }
                // With equal coefficients the same matrix serves every collision.
                let count = match &restitutions {
                    Restitutions::Same(_) => 1,
                    Restitutions::Each(list) => list.len() as u64,
                };
                for i in 0..count {
                    if let Some(matrix) = optimum.matrix(i) {
                        push(matrix)?;
                    }
                }
            }
            Prepared::Given(pass) => {
                for (i, pair) in pass.masses().windows(2).enumerate() {
                    if let ([m1, m2], Some(e)) = (pair, restitutions.at(i as u64)) {
                        push(collision::matrix(m1, m2, e).map(|row| row.map(Real::rational)))?;
                    }
                }
            }
            Prepared::Measured => return Err(Self::measured_only(Quantity::Matrix)),
        }
        Ok((Value::Matrices(matrices), dearest))
    }

    fn recollides(&self) -> Result<(Value, Level), ChainError> {
        let chain = self.chain();
        match self.prepared()? {
            Prepared::Optimal(optimum) => {
                self.moving()?;
                let (again, level) = recollision::of_optimum(optimum)?;
                Ok((Value::Recollides(Some(again)), level))
            }
            Prepared::Given(pass) => {
                let again = recollision::of_velocities(&pass.velocities_after()?);
                Ok((Value::Recollides(Some(again)), Level::Exact))
            }
            Prepared::Measured => {
                let (Inserted::Optimal(n), Ok(e)) = (chain.inserted(), chain.common_restitution("recollides")) else {
                    return Err(Self::measured_only(Quantity::Recollides));
                };
                self.moving()?;
                let (answer, level) = uncertain::recollides_over(chain.first(), chain.last(), &e, *n)?;
                Ok((Value::Recollides(answer), level))
            }
        }
    }
}
