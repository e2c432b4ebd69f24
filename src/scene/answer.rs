//! Answers on demand: a quantity is computed when it is asked for, once, after what it needs.
//!
//! [`Quantity::needs`] drives the evaluation; [`Answers::computed`] tells afterwards what was done.

use super::quantity::{Input, Quantity};
use super::{Chain, Inserted, Scene, Start};
use crate::chain::best::{Best, best};
use crate::chain::insertion::Bounds;
use crate::chain::optimum::{self, Optimum};
use crate::chain::pass::{MAX_PASS_BITS, Pass};
use crate::chain::threshold::{Helps, helps, threshold};
use crate::chain::uncertain::given::{self, Given};
use crate::chain::uncertain::meeting::{self, Meeting};
use crate::chain::uncertain::optimum::Measured;
use crate::chain::uncertain::{self, Coefficients, Range, Reals, cells};
use crate::chain::{
    ChainError, MAX_EXACT_BITS, MAX_LISTED, MAX_LISTED_UNEQUAL, Positive, Restitutions, collision, limit_inserted,
    recollision, transfer,
};
use crate::number::decimal::{Decimal, Rounding, bits_of_digits};
use crate::number::real::{Level, Real};
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;
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

/// Whether an exact number is written down beside its decimal.
fn is_short(x: &Rational) -> bool {
    x.numerator_ref().significant_bits() + x.denominator_ref().significant_bits() <= MAX_EXACT_BITS
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

    /// Enclosures over the box of measured inputs.
    fn all_between(
        &self,
        ranges: impl Iterator<Item = Result<Reals, ChainError>>,
    ) -> Result<(Value, Level), ChainError> {
        let mut dearest = Level::Double;
        let mut numbers = Vec::new();
        for range in ranges {
            let (number, level) = self.between(&range?)?;
            dearest = dearest.max(level);
            numbers.push(number);
        }
        Ok((Value::List(numbers), dearest))
    }

    fn number(&self, x: &Real) -> Result<(Number, Level), ChainError> {
        let (found, level) = Decimal::with_enclosure(x, self.scene.digits, self.scene.rounding)?;
        let number = Number {
            exact: x.as_rational().filter(|x| is_short(x)).cloned(),
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
        let chain = self.chain()?;
        let wrap = |(number, level)| (Value::Number(number), level);
        match (self.exact(), chain.inserted()) {
            (Some((first, last, restitutions)), Inserted::Optimal(n)) => {
                self.moving()?;
                self.number(&transfer::optimal(&first.over(last), &restitutions, *n)?).map(wrap)
            }
            (Some((_, _, restitutions)), Inserted::Given(_)) => {
                self.number(&Real::fraction(self.pass(restitutions)?.transfer()?, MAX_EXACT_BITS)).map(wrap)
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
        let moves = match self.scene.inputs.start() {
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
        self.between(&self.given()?.transfer()?)
    }

    fn threshold(&self) -> Result<(Value, Level), ChainError> {
        let inserted = self.inserted()?;
        if let Inserted::Given(list) = inserted
            && !list.is_empty()
        {
            return self.thresholds_of_given(list);
        }
        let ((first, last), n) = (self.scene.inputs.ends(), inserted.count());
        let (number, level) = match (first.single(), last.single()) {
            (Some(first), Some(last)) => self.number(&threshold(&first.over(last), n)?)?,
            _ => self.between(&uncertain::threshold(first, last, n)?)?,
        };
        Ok((Value::Number(number), level))
    }

    fn thresholds_of_given(&self, inserted: &[Range<Positive>]) -> Result<(Value, Level), ChainError> {
        let mut dearest = Level::Double;
        let mut numbers = Vec::with_capacity(inserted.len());
        for bounds in self.insertions(inserted)? {
            let (number, level) = match bounds.single() {
                Some(value) => self.number(&Real::rational(value.clone()))?,
                None => self.between(&bounds.reals()?)?,
            };
            dearest = dearest.max(level);
            numbers.push(number);
        }
        Ok((Value::List(numbers), dearest))
    }

    /// The bounds of each given inserted body.
    fn insertions(&self, inserted: &[Range<Positive>]) -> Result<Vec<Bounds>, ChainError> {
        // Whether a body helps is told by eta, which is about a first body that moves towards others at rest.
        if self.moving_all().is_some() {
            return Err(ChainError::NotAtRest);
        }
        let (first, last) = self.scene.inputs.ends();
        let masses: Vec<_> = std::iter::once(first).chain(inserted).chain(std::iter::once(last)).collect();
        let of = |window: &[&Range<Positive>]| match window {
            [a, mass, b] => Some(Bounds::of(a, mass, b)),
            _ => None,
        };
        Ok(masses.windows(3).filter_map(of).collect())
    }

    fn helps(&self) -> Result<(Value, Level), ChainError> {
        let (inserted, coefficients) = (self.inserted()?, self.coefficients()?);
        if let Inserted::Given(list) = inserted
            && !list.is_empty()
        {
            let each = self.insertions(list)?.into_iter().enumerate();
            let answer = |(k, bounds): (usize, Bounds)| bounds.help(&coefficients.around(k, k + 1)?);
            return Ok((Value::EachHelps(each.map(answer).collect()), Level::Exact));
        }
        let (first, last) = self.scene.inputs.ends();
        let e = coefficients.common("helps")?;
        let (answer, level) = match (first.single(), last.single(), e.single()) {
            (Some(first), Some(last), Some(e)) => {
                let (answer, level) = helps(e, &first.over(last), inserted.count())?;
                (Some(answer), level)
            }
            _ => uncertain::helps_over(first, last, &e, inserted.count())?,
        };
        Ok((Value::Helps(answer), level))
    }

    fn best(&self) -> Result<(Value, Level), ChainError> {
        if matches!(self.scene.inputs.inserted(), Some(Inserted::Given(list)) if !list.is_empty()) {
            return Err(ChainError::NeedsOptimalMasses);
        }
        let (first, last) = self.scene.inputs.ends();
        let e = self.coefficients()?.common("best-n")?;
        match (first.single(), last.single(), e.single()) {
            (Some(first), Some(last), Some(e)) => {
                let (found, level) = best(&first.over(last), e)?;
                Ok((Value::Best(found.clone(), found), level))
            }
            _ => {
                let ((least, greatest), level) = uncertain::best_over(first, last, &e)?;
                Ok((Value::Best(least, greatest), level))
            }
        }
    }

    fn masses(&self) -> Result<(Value, Level), ChainError> {
        let (first, last) = self.scene.inputs.ends();
        let inserted = self.inserted()?;
        let exact = first.single().is_some() && last.single().is_some() && inserted.is_exact();
        let ranges: Vec<Reals> = match inserted {
            Inserted::Given(list) => {
                let real = |m: &Positive| Real::rational(m.value().clone());
                let range = |m: &Range<Positive>| Reals { least: real(m.lo()), greatest: real(m.hi()) };
                std::iter::once(first).chain(list).chain(std::iter::once(last)).map(range).collect()
            }
            Inserted::Optimal(n) => {
                limit_inserted(*n + 1, "listed bodies", MAX_LISTED)?;
                let mass = |end: fn(&Range<Positive>) -> &Positive, i| optimum::mass(end(first), end(last), *n, i);
                let range = |i| Reals { least: mass(Range::lo, i), greatest: mass(Range::hi, i) };
                (0..=*n + 1).map(range).collect()
            }
        };
        if exact {
            return self.list(ranges.into_iter().map(|range| range.least));
        }
        self.all_between(ranges.into_iter().map(Ok))
    }

    /// The speed of the first body, the others being at rest.
    fn speed(&self) -> Result<Rational, ChainError> {
        self.moving()?;
        match self.scene.inputs.start() {
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
            // Not by running products: a rational is made with the common divisor that those spare.
            Prepared::Given(pass) => self.list(pass.velocities_after()?.into_iter().map(Real::rational)),
            Prepared::Measured => match (self.chain()?.inserted(), self.moving_all()) {
                (Inserted::Optimal(n), _) => {
                    let chain = self.measured(*n)?;
                    self.all_between((0..=*n + 1).map(|i| chain.velocity(i)))
                }
                (Inserted::Given(_), None) => self.all_between(self.given()?.velocities()?.into_iter().map(Ok)),
                (Inserted::Given(_), Some(before)) => {
                    self.all_between(self.follow(before)?.velocities.into_iter().map(Ok))
                }
            },
        }
    }

    /// The velocity of the last body alone: from rest a product, found without those of the others.
    fn last_velocity(&self) -> Result<(Value, Level), ChainError> {
        let (number, level) = match self.prepared()? {
            Prepared::Optimal(optimum) => self.number(&optimum.arrival(optimum.collisions(), &self.speed()?))?,
            Prepared::Given(pass) => match pass.last_velocity() {
                Ok(velocity) => self.number(&Real::fraction(velocity, MAX_EXACT_BITS))?,
                Err(_) => match pass.velocities_after()?.pop() {
                    Some(velocity) => self.number(&Real::rational(velocity))?,
                    None => return Err(ChainError::NotAtRest),
                },
            },
            Prepared::Measured => match (self.chain()?.inserted(), self.moving_all()) {
                (Inserted::Optimal(n), _) => self.between(&self.measured(*n)?.velocity(*n + 1)?)?,
                (Inserted::Given(_), None) => self.between(&self.given()?.last_velocity()?)?,
                (Inserted::Given(_), Some(before)) => match self.follow(before)?.velocities.pop() {
                    Some(range) => self.between(&range)?,
                    None => return Err(ChainError::NotAtRest),
                },
            },
        };
        Ok((Value::Number(number), level))
    }

    /// The pass over the box of measured inputs, others than the first body moving before.
    fn follow(&self, before: &[Rational]) -> Result<cells::Moving, ChainError> {
        cells::follow(&self.chain()?.masses().unwrap_or_default(), self.chain()?.coefficients(), before)
    }

    fn losses(&self) -> Result<(Value, Level), ChainError> {
        match self.prepared()? {
            Prepared::Optimal(optimum) => {
                limit_listed(optimum)?;
                let speed = self.speed()?;
                self.list((1..=optimum.collisions()).map(|i| optimum.loss(i, &speed)))
            }
            Prepared::Given(pass) => self.list(pass.losses()?.into_iter().map(Real::rational)),
            Prepared::Measured => match (self.chain()?.inserted(), self.moving_all()) {
                (Inserted::Optimal(n), _) => {
                    let chain = self.measured(*n)?;
                    self.all_between((1..=*n + 1).map(|i| chain.loss(i)))
                }
                (Inserted::Given(_), None) => self.all_between(self.given()?.losses()?.into_iter().map(Ok)),
                (Inserted::Given(_), Some(before)) => self.all_between(self.follow(before)?.losses.into_iter().map(Ok)),
            },
        }
    }

    fn matrices(&self) -> Result<(Value, Level), ChainError> {
        let Some((_, _, restitutions)) = self.exact() else { return self.measured_matrices() };
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
            Prepared::Measured => return self.measured_matrices(),
        }
        Ok((Value::Matrices(matrices), dearest))
    }

    fn measured_matrices(&self) -> Result<(Value, Level), ChainError> {
        let chain = self.chain()?;
        let matrices = match (chain.inserted(), chain.coefficients()) {
            (Inserted::Given(_), coefficients) => given::matrices(&chain.masses().unwrap_or_default(), coefficients)?,
            (Inserted::Optimal(n), coefficients) => {
                let found = self.measured(*n)?;
                // With one coefficient the same matrix serves every collision.
                let count = if let Coefficients::Each(_) = coefficients { *n + 1 } else { 1 };
                (0..count).map(|i| found.matrix(i)).collect::<Result<_, _>>()?
            }
        };
        let mut dearest = Level::Double;
        let mut ready = |x: &Reals| -> Result<Number, ChainError> {
            let (number, level) = self.between(x)?;
            dearest = dearest.max(level);
            Ok(number)
        };
        let list = matrices
            .iter()
            .map(|[[a, b], [c, d]]| Ok([[ready(a)?, ready(b)?], [ready(c)?, ready(d)?]]))
            .collect::<Result<_, ChainError>>()?;
        Ok((Value::Matrices(list), dearest))
    }

    fn recollides(&self) -> Result<(Value, Level), ChainError> {
        let chain = self.chain()?;
        match self.prepared()? {
            Prepared::Optimal(optimum) => {
                self.moving()?;
                let (again, level) = recollision::of_optimum(optimum)?;
                Ok((Value::Recollides(Meeting::of(again)), level))
            }
            Prepared::Given(pass) => Ok((Value::Recollides(Meeting::of(pass.recollides()?)), Level::Exact)),
            Prepared::Measured => match (chain.inserted(), self.moving_all()) {
                (Inserted::Optimal(n), _) => {
                    self.moving()?;
                    let (first, last) = (chain.first(), chain.last());
                    let (found, level) = meeting::of_optimal(first, last, chain.coefficients(), *n)?;
                    Ok((Value::Recollides(found), level))
                }
                (Inserted::Given(_), None) => {
                    self.moving()?;
                    let masses = chain.masses().unwrap_or_default();
                    Ok((Value::Recollides(meeting::of_given(&masses, chain.coefficients())), Level::Exact))
                }
                (Inserted::Given(_), Some(before)) => {
                    let masses = chain.masses().unwrap_or_default();
                    let velocities = self.follow(before)?.velocities;
                    let found = meeting::of_moving(&masses, chain.coefficients(), before, &velocities)?;
                    Ok((Value::Recollides(found), Level::Exact))
                }
            },
        }
    }
}
