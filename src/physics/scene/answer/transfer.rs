//! Answers for eta, the share of the energy that reaches the last body.

use super::{Answers, Number, Value};
use crate::chain::{ChainError, MAX_EXACT_BITS, transfer, uncertain};
use crate::number::real::{Level, Real};
use crate::scene::Inserted;

impl Answers<'_> {
    pub(super) fn eta(&self) -> Result<(Value, Level), ChainError> {
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

    fn eta_of_measured_masses(&self) -> Result<(Number, Level), ChainError> {
        self.moving()?;
        self.between(&self.given()?.transfer()?)
    }
}
