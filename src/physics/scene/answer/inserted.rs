//! Answers for inserted bodies: from which restitution on they help, whether they do, and how many are best.

use super::{Answers, Value};
use crate::chain::best::best;
use crate::chain::insertion::Bounds;
use crate::chain::threshold::{helps, threshold};
use crate::chain::uncertain::{self, Range};
use crate::chain::{ChainError, Positive};
use crate::number::real::{Level, Real};
use crate::scene::Inserted;

impl Answers<'_> {
    pub(super) fn threshold(&self) -> Result<(Value, Level), ChainError> {
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

    pub(super) fn helps(&self) -> Result<(Value, Level), ChainError> {
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

    pub(super) fn best(&self) -> Result<(Value, Level), ChainError> {
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
}
