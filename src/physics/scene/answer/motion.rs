//! Answers for each body: masses, velocities, losses of energy, and whether bodies meet again.

use super::{Answers, Prepared, Value, limit_listed};
use crate::chain::uncertain::meeting::{self, Meeting};
use crate::chain::uncertain::{Range, Reals};
use crate::chain::{ChainError, MAX_EXACT_BITS, MAX_LISTED, Positive, limit_inserted, optimum, recollision};
use crate::number::real::{Level, Real};
use crate::scene::Inserted;

impl Answers<'_> {
    pub(super) fn masses(&self) -> Result<(Value, Level), ChainError> {
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

    pub(super) fn velocities(&self) -> Result<(Value, Level), ChainError> {
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
    pub(super) fn last_velocity(&self) -> Result<(Value, Level), ChainError> {
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

    pub(super) fn losses(&self) -> Result<(Value, Level), ChainError> {
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

    pub(super) fn recollides(&self) -> Result<(Value, Level), ChainError> {
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
