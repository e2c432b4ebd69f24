//! Decimals with further digits: an enclosure of the value, or its digits towards zero with their bound.

use super::{Decimal, Digits, Rounding, bits_of_digits, check};
use crate::number::NumberError;
use crate::number::interval::Interval;
use crate::number::real::{Level, Real};
use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;
use std::cmp::Ordering;

/// Digits beyond those asked for, with a bound: the value lies within `bound` of the printed decimal with
/// these digits appended, on the side away from zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extra {
    /// The value towards zero, to the digits asked for.
    pub kept: Decimal,
    /// The digits that follow.
    pub further: String,
    /// One unit of the last of them, as text; `0` where the value ends there.
    pub bound: String,
}

/// A decimal with an enclosure a few digits longer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Enclosed {
    /// The correctly rounded value.
    pub decimal: Decimal,
    /// At most the value.
    pub lower: Decimal,
    /// At least the value.
    pub upper: Decimal,
}

/// Digits of an enclosure beyond those of the decimal.
const ENCLOSURE_DIGITS: u8 = 3;

impl Decimal {
    /// The value to `digits` towards zero, and `further` digits more with their bound.
    ///
    /// # Errors
    /// As [`Decimal::of_real`].
    pub fn with_extra(x: &Real, digits: Digits, further: u64) -> Result<(Extra, Level), NumberError> {
        let (long, level) = Decimal::of_real(x, digits.plus(further), Rounding::Zero)?;
        let exact = x.as_rational().is_some_and(|value| *value == long.value());
        let bound = if exact { "0".to_owned() } else { format!("1e{}", long.exponent) };
        let cut = usize::try_from(further).unwrap_or(usize::MAX);
        let padded = format!("{}{}", "0".repeat((cut + 1).saturating_sub(long.digits.len())), long.digits);
        let (kept, rest) = padded.split_at(padded.len() - cut);
        let exponent = long.exponent + i64::try_from(further).unwrap_or(i64::MAX);
        let kept = Decimal { negative: long.negative, digits: kept.to_owned(), exponent, plain: long.plain };
        Ok((Extra { kept, further: rest.to_owned(), bound }, level))
    }

    /// A real number, correctly rounded, with an enclosure that is three digits longer, and the level that
    /// settled it. One conversion to text serves all.
    ///
    /// # Errors
    /// As [`Decimal::of_real`].
    pub fn with_enclosure(x: &Real, digits: Digits, rounding: Rounding) -> Result<(Enclosed, Level), NumberError> {
        check(digits)?;
        let more = digits.plus(ENCLOSURE_DIGITS.into());
        if let Some(exact) = x.as_rational() {
            let round = |digits, rounding| Decimal::of_rational(exact, digits, rounding);
            let decimal = round(digits, rounding)?;
            let (lower, upper) = (round(more, Rounding::Down)?, round(more, Rounding::Up)?);
            return Ok((Enclosed { decimal, lower, upper }, Level::Exact));
        }
        // The rounded value and both ends, where the value is found exactly; else what it begins with.
        let (found, level) = x.settle(bits_of_digits(more.count()) + 16, |enclosure| {
            if enclosure.is_point() {
                let round = |digits, rounding| Decimal::of_interval(enclosure, digits, rounding);
                let (decimal, lower) = (round(digits, rounding)?, round(more, Rounding::Down)?);
                return Some(Ok(Enclosed { decimal, lower, upper: round(more, Rounding::Up)? }));
            }
            if may_end_on_a_decimal(enclosure, more) {
                return None;
            }
            Decimal::of_interval(enclosure, more, Rounding::Zero).map(Err)
        })?;
        let mut short = match found {
            Ok(exact) => return Ok((exact, level)),
            Err(short) => short,
        };
        if short.digits == "0" {
            short.negative = x.sign()?.0 == Ordering::Less;
        }
        // The value lies strictly between this decimal and the next one away from zero: it is neither.
        let long = short.away();
        let cut = short.digits.len().saturating_sub(usize::from(ENCLOSURE_DIGITS));
        let (kept, rest) = short.digits.split_at(cut);
        let up = match rounding {
            Rounding::Nearest => rest.as_bytes().first().is_some_and(|first| *first >= b'5') && rest.len() == 3,
            Rounding::Away => true,
            Rounding::Zero => false,
            Rounding::Up => !short.negative,
            Rounding::Down => short.negative,
        };
        let kept = if kept.is_empty() { "0" } else { kept };
        let exponent = short.exponent + i64::from(ENCLOSURE_DIGITS);
        let towards = Decimal { digits: kept.to_owned(), exponent, ..short.clone() };
        let mut decimal = if up { towards.away() } else { towards };
        if let Digits::Significant(count) = digits
            && u64::try_from(decimal.digits.len()).is_ok_and(|length| length > count)
        {
            decimal.digits.pop();
            decimal.exponent += 1;
        }
        let (lower, upper) = if short.negative { (long, short) } else { (short, long) };
        let [decimal, lower, upper] = [decimal, lower, upper].map(Decimal::without_sign_of_zero);
        Ok((Enclosed { decimal, lower, upper }, level))
    }

    fn without_sign_of_zero(mut self) -> Decimal {
        self.negative &= self.digits.bytes().any(|b| b != b'0');
        self
    }
}

/// Whether an end of an enclosure might be a decimal of so many digits. Only then can the value be one, if all elements
/// begin with it: the smallest in size of them is an end.
///
/// The end is `M·2^E`, `M` odd. With places after the point, `m >= 0`, a decimal has at most `m` binary ones; and a
/// multiple of `10^k` has the factors `2^k` and `5^k`, `5^k > 2^(2k)`.
fn may_end_on_a_decimal(x: &Interval, digits: Digits) -> bool {
    let places = match digits {
        Digits::Places(places) => i64::try_from(places).unwrap_or(i64::MAX),
        Digits::Significant(count) => {
            // The leading place is at least this, as 0.30103 exceeds the logarithm of 2 by less than 1 in 10^6 places.
            let top = x.top().saturating_sub(1);
            let leading = i64::try_from((i128::from(top) * 30_103).div_euclid(100_000)).unwrap_or(i64::MIN);
            let slack = 2 + top.unsigned_abs() / 1_000_000;
            let count = i64::try_from(count.saturating_add(slack)).unwrap_or(i64::MAX);
            count.saturating_sub(leading)
        }
    };
    let decimal = |end: Option<(Integer, i64)>| {
        let Some((mantissa, exponent)) = end else { return true };
        let Some(zeros) = mantissa.trailing_zeros() else { return true };
        let exponent = exponent.saturating_add(i64::try_from(zeros).unwrap_or(i64::MAX));
        if places >= 0 {
            return exponent.saturating_add(places) >= 0;
        }
        let k = places.unsigned_abs();
        exponent >= places.saturating_neg() && mantissa.significant_bits() - zeros >= 2 * k
    };
    decimal(x.lower()) || decimal(x.upper())
}
