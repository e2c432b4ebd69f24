//! Decimals of which every printed digit is right.
//!
//! **Contract.** A [`Decimal`] is the correctly rounded value of a number, to a number of significant digits
//! or of places after the point, in one of five directions. Ties (to even, for rounding to nearest) are
//! recognised exactly: a rational is rounded in exact arithmetic, and an irrational number is never a tie.
//!
//! **Why it is right.** Rounding is monotone: if both ends of an enclosure round to the same decimal, every
//! element does. If they do not, the enclosure is narrowed, and this ends since an irrational number keeps
//! a distance from every point where rounding jumps.
//!
//! **Cost.** One power of ten, one product, and one conversion to text.

mod doubles;
mod enclosed;
mod long;
mod notation;
mod place;

use super::NumberError;
pub use super::digits::bits_of_digits;
use super::interval::Interval;
use super::real::{Level, Real};
pub use enclosed::{Enclosed, Extra};
use long::of_long;
use malachite::base::num::arithmetic::traits::{DivRound, Pow, Sign, UnsignedAbs};
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::rounding_modes::RoundingMode;
use malachite::{Integer, Natural, Rational};
use place::{compare_size, leading_place, place_and_round, times_power_of_ten, to_integer};
use std::cmp::Ordering;
use std::str::FromStr;

/// The most digits of one decimal.
pub const MAX_DIGITS: u64 = 10_000_000;

/// Rationals of more bits than this are rounded from their leading digits, where those settle it.
const LONG_BITS: u64 = 8_192;

/// How many digits are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// So many significant digits, at least one.
    Significant(u64),
    /// So many digits after the point.
    Places(u64),
}

impl Digits {
    /// So many digits more.
    #[must_use]
    pub fn plus(self, more: u64) -> Digits {
        match self {
            Self::Significant(d) => Self::Significant(d.saturating_add(more)),
            Self::Places(p) => Self::Places(p.saturating_add(more)),
        }
    }

    /// How many.
    #[must_use]
    pub fn count(self) -> u64 {
        match self {
            Self::Significant(count) | Self::Places(count) => count,
        }
    }
}

/// The direction of rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rounding {
    /// To the nearest decimal, ties to the even one.
    #[default]
    Nearest,
    /// Never below the value.
    Up,
    /// Never above the value.
    Down,
    /// Towards zero.
    Zero,
    /// Away from zero.
    Away,
}

impl Rounding {
    /// All directions.
    pub const ALL: [Rounding; 5] = [Self::Nearest, Self::Up, Self::Down, Self::Zero, Self::Away];

    /// The rule in words, for the head of a table.
    #[must_use]
    pub fn rule(self) -> &'static str {
        match self {
            Self::Nearest => "to nearest, ties to even",
            Self::Up => "up",
            Self::Down => "down",
            Self::Zero => "towards zero",
            Self::Away => "away from zero",
        }
    }

    fn mode(self) -> RoundingMode {
        match self {
            Self::Nearest => RoundingMode::Nearest,
            Self::Up => RoundingMode::Ceiling,
            Self::Down => RoundingMode::Floor,
            Self::Zero => RoundingMode::Down,
            Self::Away => RoundingMode::Up,
        }
    }
}

/// `±digits·10^exponent`, and how to write it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decimal {
    negative: bool,
    digits: String,
    exponent: i64,
    /// Written without an exponent whatever its size.
    plain: bool,
}

impl Decimal {
    /// A rational, correctly rounded.
    ///
    /// # Errors
    /// [`NumberError::LimitReached`] above [`MAX_DIGITS`]; [`NumberError::Undefined`] for no digits at all.
    pub fn of_rational(x: &Rational, digits: Digits, rounding: Rounding) -> Result<Decimal, NumberError> {
        check(digits)?;
        if *x == Rational::ZERO {
            return Ok(Decimal::zero(digits));
        }
        let size = x.numerator_ref().significant_bits().max(x.denominator_ref().significant_bits());
        let bits = bits_of_digits(digits.count()) + 64;
        if size > bits.saturating_mul(8).saturating_add(LONG_BITS) {
            // Far longer than the decimal: its leading digits settle all but what is next to a tie.
            let near = Interval::from_rational(x, bits);
            let found = if near.is_point() { None } else { Decimal::of_interval(&near, digits, rounding) };
            if let Some(found) = found {
                return Ok(found);
            }
        }
        let numerator = Integer::from_sign_and_abs_ref(*x > Rational::ZERO, x.numerator_ref());
        let denominator = Integer::from(x.denominator_ref());
        let guess = Interval::from_rational(x, 64);
        let found = place_and_round(x.sign(), digits, leading_place(&guess), |places| {
            let power = Integer::from(10).pow(places.unsigned_abs());
            let (above, below) = if places >= 0 {
                (&numerator * power, denominator.clone())
            } else {
                (numerator.clone(), &denominator * power)
            };
            let value = (&above).div_round(&below, rounding.mode()).0;
            let reaches = (&above).unsigned_abs() >= (&value * below).unsigned_abs();
            Some((value, Some(reaches)))
        });
        Ok(found.unwrap_or_else(|| Decimal::zero(digits)))
    }

    /// The common rounding of all elements of an enclosure; `None` where they do not share one.
    #[must_use]
    pub fn of_interval(x: &Interval, digits: Digits, rounding: Rounding) -> Option<Decimal> {
        let sign = match (x.sign(), digits) {
            (Some(sign), _) => sign,
            // Around zero only a result of zero can be shared.
            (None, Digits::Places(_)) if !x.is_whole() => Ordering::Equal,
            _ => return None,
        };
        if let Some(exact) = x.point() {
            return Decimal::of_rational(&exact, digits, rounding).ok();
        }
        if sign != Ordering::Equal
            && let Some(found) = of_long(x, sign, digits, rounding)
        {
            return Some(found);
        }
        let scaled = |places: i64| {
            let (lo, hi, exponent) = times_power_of_ten(x, places, digits)?;
            let lower = to_integer(&lo, exponent, rounding.mode());
            let upper = to_integer(&hi, exponent, rounding.mode());
            if lower != upper {
                return None;
            }
            // Whether all elements reach the rounded value in size, or none do.
            let size = |m: &Integer| compare_size(m, exponent, &lower);
            let reaches = match (size(&lo), size(&hi)) {
                (Ordering::Less, Ordering::Less) => Some(false),
                (a, b) if a != Ordering::Less && b != Ordering::Less => Some(true),
                _ => None,
            };
            Some((lower, reaches))
        };
        if sign == Ordering::Equal {
            let Digits::Places(places) = digits else { return None };
            let (value, _) = scaled(i64::try_from(places).ok()?)?;
            return (value == 0).then(|| Decimal::zero(digits));
        }
        place_and_round(sign, digits, leading_place(x), scaled)
    }

    /// A real number, correctly rounded, and the level that settled it.
    ///
    /// # Errors
    /// [`NumberError::LimitReached`]; [`NumberError::Undefined`] for no digits at all.
    pub fn of_real(x: &Real, digits: Digits, rounding: Rounding) -> Result<(Decimal, Level), NumberError> {
        check(digits)?;
        if let Some(exact) = x.as_rational() {
            return Ok((Decimal::of_rational(exact, digits, rounding)?, Level::Exact));
        }
        x.settle(bits_of_digits(digits.count()) + 16, |enclosure| Decimal::of_interval(enclosure, digits, rounding))
    }

    /// The next decimal away from zero with the same last place.
    fn away(&self) -> Decimal {
        let mut digits = self.digits.clone().into_bytes();
        let nines = digits.iter().rev().take_while(|b| **b == b'9').count();
        let stem = digits.len() - nines;
        digits[stem..].fill(b'0');
        match digits[..stem].last_mut() {
            Some(last) => *last += 1,
            None => digits.insert(0, b'1'),
        }
        Decimal { digits: digits.into_iter().map(char::from).collect(), ..self.clone() }
    }

    fn zero(digits: Digits) -> Decimal {
        let exponent = match digits {
            Digits::Significant(_) => 0,
            Digits::Places(p) => -i64::try_from(p).unwrap_or(0),
        };
        Decimal { negative: false, digits: "0".to_owned(), exponent, plain: true }
    }

    /// The digits as one integer in text, without sign and point.
    #[must_use]
    pub fn digits(&self) -> &str {
        &self.digits
    }

    /// Whether it is below zero.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        self.negative
    }

    /// The exponent of ten of the last digit.
    #[must_use]
    pub fn exponent(&self) -> i64 {
        self.exponent
    }

    /// The value, exactly. Cost: a power of ten of the exponent's size.
    #[must_use]
    pub fn value(&self) -> Rational {
        let digits = Natural::from_str(&self.digits).unwrap_or(Natural::ZERO);
        let size = Rational::from(digits) * Rational::from(10).pow(self.exponent);
        if self.negative { -size } else { size }
    }
}

fn check(digits: Digits) -> Result<(), NumberError> {
    let asked = digits.count();
    if asked > MAX_DIGITS {
        return Err(NumberError::LimitReached { limit: "digits", allowed: MAX_DIGITS, needed: asked.to_string() });
    }
    if digits == Digits::Significant(0) {
        return Err(NumberError::Undefined { what: "no significant digit was asked for".to_owned() });
    }
    Ok(())
}

/// The ends of an enclosure as decimals, rounded outwards to so many significant digits; `None` for the whole
/// line.
#[must_use]
pub fn outward(x: &Interval, digits: u64) -> Option<(String, String)> {
    let (lo, hi) = x.ends()?;
    let digits = Digits::Significant(digits.max(1));
    let lower = Decimal::of_interval(&lo, digits, Rounding::Down)?;
    let upper = Decimal::of_interval(&hi, digits, Rounding::Up)?;
    Some((lower.to_string(), upper.to_string()))
}
