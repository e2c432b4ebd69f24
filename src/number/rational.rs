//! Exact rational numbers from text, and exact roots.
//!
//! Contract: [`parse`] reads integers, fractions `p/q`, decimals and scientific notation, with an
//! optional sign, and returns the very number written. Repeating decimals such as `1.2(3)` are refused
//! with the fraction form named, because no standard says how they read.

use malachite::base::num::arithmetic::traits::{CheckedRoot, Pow};
use malachite::{Integer, Natural, Rational};
use std::str::FromStr;

/// The most digits of a numeral, and the largest decimal exponent.
pub const DIGITS_LIMIT: usize = 10_000;

/// Why a numeral was not read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NumeralError {
    /// Nothing to read.
    Empty,
    /// A character that does not belong there, with its place in bytes.
    Unexpected(usize, char),
    /// A fraction with denominator 0.
    ZeroDenominator,
    /// A repeating decimal.
    Repeating,
    /// More digits than [`DIGITS_LIMIT`], or a larger exponent.
    TooLong,
}

impl std::fmt::Display for NumeralError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            NumeralError::Empty => write!(f, "a number is missing"),
            NumeralError::Unexpected(at, c) => write!(f, "{c:?} at place {} does not belong to a number", at + 1),
            NumeralError::ZeroDenominator => write!(f, "the denominator is 0"),
            NumeralError::Repeating => write!(f, "repeating decimals are not read: write a fraction such as 37/30"),
            NumeralError::TooLong => write!(f, "limit reached: at most {DIGITS_LIMIT} digits, exponents up to {DIGITS_LIMIT}"),
        }
    }
}

/// The number that a text denotes.
pub fn parse(text: &str) -> Result<Rational, NumeralError> {
    let trimmed = text.trim();
    if trimmed.len() > 2 * DIGITS_LIMIT + 16 {
        return Err(NumeralError::TooLong);
    }
    if let Some((top, bottom)) = trimmed.split_once('/') {
        let (top, bottom) = (decimal(top.trim())?, decimal(bottom.trim())?);
        if bottom == 0 {
            return Err(NumeralError::ZeroDenominator);
        }
        return Ok(top / bottom);
    }
    decimal(trimmed)
}

fn decimal(text: &str) -> Result<Rational, NumeralError> {
    if text.contains('(') {
        return Err(NumeralError::Repeating);
    }
    let (negative, digits) = match text.strip_prefix(['-', '−']) {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let (mantissa, exponent) = match digits.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent),
        None => (digits, "0"),
    };
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    if whole.is_empty() && part.is_empty() {
        return Err(match text.chars().next() {
            Some(c) => NumeralError::Unexpected(0, c),
            None => NumeralError::Empty,
        });
    }
    for list in [whole, part] {
        if let Some(c) = list.chars().find(|c| !c.is_ascii_digit()) {
            return Err(NumeralError::Unexpected(text.find(c).unwrap_or(0), c));
        }
    }
    if whole.len() + part.len() > DIGITS_LIMIT {
        return Err(NumeralError::TooLong);
    }
    let unsigned = exponent.strip_prefix(['-', '+']).unwrap_or(exponent);
    if unsigned.is_empty() || !unsigned.bytes().all(|b| b.is_ascii_digit()) {
        let c = unsigned.chars().find(|c| !c.is_ascii_digit()).unwrap_or('e');
        return Err(NumeralError::Unexpected(text.rfind(c).unwrap_or(0), c));
    }
    let exponent: i64 = exponent.parse().map_err(|_| NumeralError::TooLong)?;
    if exponent.unsigned_abs() > DIGITS_LIMIT as u64 {
        return Err(NumeralError::TooLong);
    }
    let digits = format!("{whole}{part}");
    let value = Natural::from_str(&digits).map_err(|()| NumeralError::Empty)?;
    let scale = exponent - i64::try_from(part.len()).map_err(|_| NumeralError::TooLong)?;
    let value = Rational::from(value) * Rational::from(10).pow(scale);
    Ok(if negative { -value } else { value })
}

/// The k-th root of a non-negative rational, if it is rational. k ≥ 1.
pub fn exact_root(q: &Rational, k: u64) -> Option<Rational> {
    if *q < 0 || k == 0 {
        return None;
    }
    let top = Integer::from(q.numerator_ref()).checked_root(k)?;
    let bottom = Integer::from(q.denominator_ref()).checked_root(k)?;
    Some(Rational::from_integers(top, bottom))
}
