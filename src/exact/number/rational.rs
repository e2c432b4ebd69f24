//! Rational numbers as text, their exact roots and their height.
//!
//! Contract: [`parse`] reads a numeral as exactly the number that it denotes: `0.1` is one tenth.
//! Accepted are integers `12`, fractions of integers `3/4`, decimals `0.5` and scientific notation
//! `2.5e-3`, each with an optional sign; a point needs digits on both sides. Measured values with an
//! uncertainty, `1.2(3)`, are refused: they do not denote a number.
//!
//! Limits: [`MAX_DIGITS`] digits and exponents of ten up to [`MAX_EXPONENT`] in size.

use malachite::base::num::arithmetic::traits::{CheckedRoot, HeightRef, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};
use std::fmt;
use std::str::FromStr;

/// The most digits of one numeral, its exponent not counted.
pub const MAX_DIGITS: usize = 10_000;

/// The largest absolute value of the exponent of ten.
pub const MAX_EXPONENT: u64 = 10_000;

/// Why a text is not a numeral; places are byte offsets into the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NumeralError {
    /// Digits were expected here.
    MissingDigits {
        /// The place.
        at: usize,
    },
    /// A character that does not belong into a numeral, or not here.
    Unexpected {
        /// The place.
        at: usize,
        /// The character.
        found: char,
    },
    /// An uncertainty in parentheses: `1.2(3)` is a measurement, not a number.
    Uncertainty {
        /// The place of the parenthesis.
        at: usize,
    },
    /// A fraction with denominator zero.
    ZeroDenominator {
        /// The place of the denominator.
        at: usize,
    },
    /// More than [`MAX_DIGITS`] digits.
    TooManyDigits {
        /// How many are allowed.
        allowed: usize,
        /// How many there are.
        needed: usize,
    },
    /// An exponent of ten beyond [`MAX_EXPONENT`].
    ExponentTooLarge {
        /// The place of the exponent.
        at: usize,
        /// The largest absolute value that is allowed.
        allowed: u64,
    },
    /// A text with two readings ([`super::typed`]).
    Unclear {
        /// Both of them.
        what: String,
    },
}

impl fmt::Display for NumeralError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::MissingDigits { at: 0 } => write!(f, "expected a number, found nothing"),
            Self::MissingDigits { at } => write!(f, "expected a digit at character {}", at + 1),
            Self::Unexpected { found: ',', .. } => {
                write!(f, "expected one number, found a comma that is no decimal one")
            }
            Self::Unexpected { at, found } => {
                let hint = match found {
                    '.' if *at < 2 => "; write a digit before the decimal point, as in 0.7",
                    '%' => "; write 90 % as 0.9",
                    ' ' | '_' if *at > 0 => "; write it without a unit and without spaces",
                    found if *at > 0 && found.is_alphabetic() => "; write it without a unit",
                    _ => "",
                };
                write!(f, "expected a number, found {found:?} at character {}{hint}", at + 1)
            }
            Self::Uncertainty { at } => {
                write!(f, "found an uncertainty in parentheses at character {}: write an exact number", at + 1)
            }
            Self::ZeroDenominator { at } => write!(f, "the denominator at character {} is zero", at + 1),
            Self::TooManyDigits { allowed, needed } => {
                write!(f, "the number has {needed} digits; at most {allowed} are allowed")
            }
            Self::Unclear { what } => write!(f, "{what}"),
            Self::ExponentTooLarge { at, allowed } => {
                write!(f, "the exponent at character {} is too large; at most {allowed} is allowed", at + 1)
            }
        }
    }
}

impl std::error::Error for NumeralError {}

/// Reads a numeral exactly.
///
/// ```
/// use carom_exact::number::rational::parse;
/// assert_eq!(parse("-2.5e-1"), parse("-1/4"));
/// assert!(parse("1.2(3)").is_err());
/// ```
///
/// # Errors
/// [`NumeralError`] says what is wrong and where.
pub fn parse(text: &str) -> Result<Rational, NumeralError> {
    let mut reader = Reader { text, at: 0 };
    let negative = reader.sign();
    let whole = reader.digits()?;
    let value = if reader.take(b'/') {
        let place = reader.at;
        let below = reader.digits()?;
        reader.end()?;
        limit_digits(whole.len() + below.len())?;
        let denominator = natural(below, place)?;
        if denominator == Natural::ZERO {
            return Err(NumeralError::ZeroDenominator { at: place });
        }
        Rational::from_naturals(natural(whole, 0)?, denominator)
    } else {
        let fraction = if reader.take(b'.') { reader.digits()? } else { "" };
        let exponent = reader.exponent()?;
        reader.end()?;
        limit_digits(whole.len() + fraction.len())?;
        let mantissa = natural(&[whole, fraction].concat(), 0)?;
        let places = i64::try_from(fraction.len()).unwrap_or(i64::MAX);
        Rational::from(mantissa) * Rational::from(10).pow(exponent - places)
    };
    Ok(if negative { -value } else { value })
}

fn limit_digits(needed: usize) -> Result<(), NumeralError> {
    if needed > MAX_DIGITS {
        return Err(NumeralError::TooManyDigits { allowed: MAX_DIGITS, needed });
    }
    Ok(())
}

fn natural(digits: &str, at: usize) -> Result<Natural, NumeralError> {
    Natural::from_str(digits).map_err(|()| NumeralError::MissingDigits { at })
}

/// A position in the text of a numeral.
struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Reader<'a> {
    fn take(&mut self, byte: u8) -> bool {
        let found = self.text.as_bytes().get(self.at) == Some(&byte);
        self.at += usize::from(found);
        found
    }

    /// An optional sign; whether it was a minus.
    fn sign(&mut self) -> bool {
        let minus = self.take(b'-');
        if !minus {
            self.take(b'+');
        }
        minus
    }

    /// One or more decimal digits.
    fn digits(&mut self) -> Result<&'a str, NumeralError> {
        let rest = &self.text[self.at..];
        let length = rest.bytes().take_while(u8::is_ascii_digit).count();
        if length == 0 {
            return Err(match rest.chars().next() {
                Some('(') => NumeralError::Uncertainty { at: self.at },
                Some(found) => NumeralError::Unexpected { at: self.at, found },
                None => NumeralError::MissingDigits { at: self.at },
            });
        }
        self.at += length;
        Ok(&rest[..length])
    }

    /// An optional exponent of ten, 0 where there is none.
    fn exponent(&mut self) -> Result<i64, NumeralError> {
        if !self.take(b'e') && !self.take(b'E') {
            return Ok(0);
        }
        let place = self.at;
        let negative = self.sign();
        let digits = self.digits()?.trim_start_matches('0');
        let size = if digits.is_empty() { Ok(0) } else { digits.parse::<u64>() };
        match size {
            Ok(size) if size <= MAX_EXPONENT => {
                let size = i64::try_from(size).unwrap_or(i64::MAX);
                Ok(if negative { -size } else { size })
            }
            _ => Err(NumeralError::ExponentTooLarge { at: place, allowed: MAX_EXPONENT }),
        }
    }

    fn end(&self) -> Result<(), NumeralError> {
        match self.text[self.at..].chars().next() {
            None => Ok(()),
            Some('(') => Err(NumeralError::Uncertainty { at: self.at }),
            Some(found) => Err(NumeralError::Unexpected { at: self.at, found }),
        }
    }
}

/// The exact `k`-th root of a non-negative rational, where it is rational.
///
/// `None` for a negative number, for `k = 0`, and where the root is irrational.
#[must_use]
pub fn exact_root(value: &Rational, k: u64) -> Option<Rational> {
    if k == 0 || *value < Rational::ZERO {
        return None;
    }
    if *value == Rational::ZERO || *value == Rational::ONE || k == 1 {
        return Some(value.clone());
    }
    // A k-th power other than 0 and 1 has a part of at least 2^k.
    if value.height_ref().significant_bits() <= k {
        return None;
    }
    value.checked_root(k)
}

/// The larger of the absolute values of numerator and denominator in lowest terms.
#[must_use]
pub fn height(value: &Rational) -> Natural {
    value.height_ref().clone()
}
