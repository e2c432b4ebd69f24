//! A number that is ready to be printed: exactly where it is short, with its enclosure and its decimal.

use super::{Answers, Value};
use crate::chain::uncertain::Reals;
use crate::chain::{ChainError, MAX_EXACT_BITS};
use crate::number::decimal::{Decimal, Rounding};
use crate::number::real::{Level, Real};
use malachite::Rational;
use malachite::base::num::logic::traits::SignificantBits;

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

/// Whether an exact number is written down beside its decimal.
fn is_short(x: &Rational) -> bool {
    x.numerator_ref().significant_bits() + x.denominator_ref().significant_bits() <= MAX_EXACT_BITS
}

impl Answers<'_> {
    pub(super) fn number(&self, x: &Real) -> Result<(Number, Level), ChainError> {
        let (found, level) = Decimal::with_enclosure(x, self.scene.digits, self.scene.rounding)?;
        let number = Number {
            exact: x.as_rational().filter(|x| is_short(x)).cloned(),
            radical: x.radical().map(str::to_owned),
            enclosure: (found.lower.to_string(), found.upper.to_string()),
            decimal: Some(found.decimal.to_string()),
        };
        Ok((number, level))
    }

    pub(super) fn list(&self, list: impl Iterator<Item = Real>) -> Result<(Value, Level), ChainError> {
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
    pub(super) fn between(&self, range: &Reals) -> Result<(Number, Level), ChainError> {
        let longer = self.scene.digits.plus(3);
        let (lower, level) = Decimal::of_real(&range.least, longer, Rounding::Down)?;
        let (upper, other) = Decimal::of_real(&range.greatest, longer, Rounding::Up)?;
        let round = |x: &Real| Decimal::of_real(x, self.scene.digits, self.scene.rounding);
        let (least, greatest) = (round(&range.least)?.0, round(&range.greatest)?.0);
        let decimal = (least == greatest).then(|| least.to_string());
        let enclosure = (lower.to_string(), upper.to_string());
        Ok((Number { exact: None, radical: None, enclosure, decimal }, level.max(other)))
    }

    /// Enclosures over the box of measured inputs.
    pub(super) fn all_between(
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
}
