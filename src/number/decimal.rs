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

use super::NumberError;
use super::interval::Interval;
use super::real::{Level, Real};
use malachite::base::num::arithmetic::traits::{DivRound, Pow, ShrRound, Sign, UnsignedAbs};
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::rounding_modes::RoundingMode;
use malachite::{Integer, Natural, Rational};
use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

/// The most digits of one decimal.
pub const MAX_DIGITS: u64 = 10_000_000;

/// Rationals of more bits than this are rounded from their leading digits, where those settle it.
const LONG_BITS: u64 = 8_192;

/// From so many digits on, digits are made by [`super::digits`] (bench `numbers`, group `digits`).
const LONG_DIGITS: u64 = 2_000;

/// Digits beyond those asked for that tell how to round, and the unit of the last digit asked for in theirs.
const FURTHER: u64 = 9;
const FURTHER_UNIT: u64 = 1_000_000_000;

/// Leading places from here to [`PLAIN_TO`] are written without an exponent.
const PLAIN_FROM: i64 = -6;
const PLAIN_TO: i64 = 20;

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

    /// The common rounding of all reals between two positive doubles, in machine words; `None` where they do not share
    /// one, where a tie is among them, and where words are too short.
    ///
    /// Right for a number between the doubles that is neither a decimal of so many digits nor a tie: both ends have the
    /// same whole number of halves of the last place, and the lower one is not itself such a number of halves.
    #[must_use]
    pub fn of_doubles(lo: f64, hi: f64, digits: Digits, rounding: Rounding) -> Option<Decimal> {
        if !(WORD_LEAST..=WORD_MOST).contains(&lo) || !(WORD_LEAST..=WORD_MOST).contains(&hi) {
            return None;
        }
        let (places, least) = match digits {
            Digits::Places(places) => (i64::try_from(places).ok()?, 1_u128),
            Digits::Significant(count) => {
                // The leading place, give or take one: the number of digits is checked below.
                let leading = -i64::try_from(SCALES.iter().position(|scale| lo >= *scale)?).ok()?;
                let count = i64::try_from(count).ok()?;
                (count - 1 - leading, power_of_ten(count - 1)?)
            }
        };
        let power = power_of_ten(places)?;
        // Twice x·10^places: its whole part, and whether it is whole.
        let halves = |x: f64| {
            let bits = x.to_bits();
            let mantissa = u128::from(bits & ((1 << 52) - 1) | 1 << 52);
            // At most 2^127 by the limits of both factors; x = mantissa·2^-shift.
            let shift = u32::try_from(1075 - i64::try_from(bits >> 52).ok()?).ok()?;
            let scaled = mantissa.checked_mul(power)?.checked_mul(2)?;
            Some((scaled >> shift, scaled & ((1 << shift) - 1) == 0))
        };
        let ((below, whole), (above, _)) = (halves(lo)?, halves(hi)?);
        if below != above || whole {
            return None;
        }
        let floor = below / 2;
        let value = match rounding {
            Rounding::Nearest => floor + below % 2,
            Rounding::Down | Rounding::Zero => floor,
            Rounding::Up | Rounding::Away => floor + 1,
        };
        let plain = matches!(digits, Digits::Places(_));
        let (fits, value, exponent) = match digits {
            Digits::Places(_) => (value > 0, value, -places),
            // What rounds up to a power of ten has one digit more: its last zero goes.
            Digits::Significant(_) if value == 10 * least => (true, least, 1 - places),
            Digits::Significant(_) => (floor >= least && value < 10 * least, value, -places),
        };
        fits.then(|| Decimal { negative: false, digits: value.to_string(), exponent, plain })
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

/// The doubles that [`Decimal::of_doubles`] takes: with `10^MAX_PLACES` they make numbers of at most 127 bits.
const WORD_LEAST: f64 = f64::from_bits((1023 - 70) << 52);
const WORD_MOST: f64 = 1.0;
const MAX_PLACES: i64 = 21;

/// About `10^-k`.
const SCALES: [f64; 22] = [
    1e0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, 1e-17,
    1e-18, 1e-19, 1e-20, 1e-21,
];

/// `10^k`, for `k` from 0 to [`MAX_PLACES`].
fn power_of_ten(k: i64) -> Option<u128> {
    (0..=MAX_PLACES).contains(&k).then(|| 10_u128.pow(u32::try_from(k).unwrap_or(0)))
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

/// Bits that hold so many decimal digits.
#[must_use]
pub fn bits_of_digits(digits: u64) -> u64 {
    digits.saturating_mul(3_322) / 1_000 + 1
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

/// The place of the leading decimal digit, give or take one (a few for exponents of 10^18).
fn leading_place(x: &Interval) -> i64 {
    let top = x.top();
    // ends with 53 bits of the middle, scaled to [1/2, 1)
    let mantissa = x.middle(53).shifted(-top.clamp(-super::interval::MAX_EXPONENT, super::interval::MAX_EXPONENT));
    let part = mantissa.guess_f64().abs().log10();
    // log10(2)·10^18 = 301029995663981195.2…
    let whole = i128::from(top) * 301_029_995_663_981_195;
    let unit = 1_000_000_000_000_000_000_i128;
    // The cast saturates; the result is an estimate that is corrected where it is used.
    let part = if part.is_finite() { (part * 1e18) as i128 } else { 0 };
    i64::try_from((whole + part).div_euclid(unit)).unwrap_or(0)
}

/// The common rounding of all elements of an enclosure to many digits; `None` where the general way must tell.
///
/// `y = |x|·10^-(leading + 1)`, from 0.1 to 1, is written down to [`FURTHER`] digits more than asked for, cut off; those tell
/// whether the width of the enclosure, in their last place, reaches across a point where rounding jumps.
fn of_long(x: &Interval, sign: Ordering, digits: Digits, rounding: Rounding) -> Option<Decimal> {
    let leading = leading_place(x);
    let wanted = match digits {
        Digits::Significant(count) => i64::try_from(count).ok()?,
        Digits::Places(places) => i64::try_from(places).ok()?.checked_add(leading)?.checked_add(1)?,
    };
    let count = u64::try_from(wanted).ok().filter(|count| *count >= LONG_DIGITS)?;
    let shift = -leading.checked_add(1)?;
    let scaled = if shift == 0 {
        let ((lo, exponent), (hi, _)) = (x.lower()?, x.upper()?);
        (lo, hi, exponent)
    } else {
        times_power_of_ten(x, shift, digits)?
    };
    let (lo, hi, exponent) = scaled;
    let (near, far) = if sign == Ordering::Less {
        (hi.unsigned_abs(), lo.unsigned_abs())
    } else {
        (lo.unsigned_abs(), hi.unsigned_abs())
    };
    let bits = u64::try_from(exponent.checked_neg()?).ok()?;
    if far.significant_bits() > bits || far <= near {
        return None;
    }
    let all = count + FURTHER;
    // The width in units of the last digit: (far − near)·10^all/2^bits, at most 2^(its bits + log2(10)·all − bits).
    let gap = (far - &near).significant_bits() + bits_of_digits(all);
    let units =
        1_u64.checked_shl(u32::try_from(gap.saturating_sub(bits)).ok()?).filter(|units| *units < FURTHER_UNIT / 4)?;
    let text = super::digits::of_fraction(&near, bits, all)?;
    let (kept, rest) = text.split_at_checked(usize::try_from(count).ok()?)?;
    let rest: u64 = rest.parse().ok()?;
    // The value lies between `rest` and `rest + units + 1` units, or at one of them.
    let (least, most) = (rest, rest + units + 1);
    let half = FURTHER_UNIT / 2;
    let away = match rounding {
        Rounding::Nearest => (least > half).then_some(true).or((most < half).then_some(false))?,
        Rounding::Up => sign == Ordering::Greater,
        Rounding::Down => sign == Ordering::Less,
        Rounding::Away => true,
        Rounding::Zero => false,
    };
    if least == 0 || most >= FURTHER_UNIT || kept.starts_with('0') {
        return None;
    }
    let plain = matches!(digits, Digits::Places(_));
    let negative = sign == Ordering::Less;
    let cut = Decimal { negative, digits: kept.to_owned(), exponent: leading + 1 - wanted, plain };
    let mut found = if away { cut.away() } else { cut };
    if !plain && found.digits.len() > kept.len() {
        found.digits.pop();
        found.exponent += 1;
    }
    Some(found)
}

/// The ends of `x·10^places` in units of a common power of two.
fn times_power_of_ten(x: &Interval, places: i64, digits: Digits) -> Option<(Integer, Integer, i64)> {
    // All that x tells is kept: how near it is to a rounding boundary is not known in advance.
    let bits = x.accuracy().min(x.middle_bits().max(bits_of_digits(digits.count()))).max(64) + 40;
    let five = Interval::from_integer(5);
    let power = five.power(&Natural::from(places.unsigned_abs()), bits);
    let product = if places >= 0 { x.multiply(&power, bits) } else { x.divide(&power, bits) }.shifted(places);
    // An integer of that many bits would not be the result of any rounding that is asked for.
    if product.top() > i64::try_from(super::real::MAX_BITS).unwrap_or(i64::MAX) {
        return None;
    }
    let ((lo, exponent), (hi, _)) = (product.lower()?, product.upper()?);
    Some((lo, hi, exponent))
}

/// `x·2^exponent` as an integer, rounded as asked.
fn to_integer(x: &Integer, exponent: i64, mode: RoundingMode) -> Integer {
    if exponent >= 0 { x << exponent.unsigned_abs() } else { x.shr_round(exponent.unsigned_abs(), mode).0 }
}

/// The order of `|x·2^exponent|` and `|y|`.
fn compare_size(x: &Integer, exponent: i64, y: &Integer) -> Ordering {
    let places = exponent.unsigned_abs();
    let (x, y) = (x.unsigned_abs(), y.unsigned_abs());
    if exponent >= 0 {
        (x << places).cmp(&y)
    } else if x.significant_bits() < places + y.significant_bits() {
        Ordering::Less
    } else if x.significant_bits() > places + y.significant_bits() {
        Ordering::Greater
    } else {
        x.cmp(&(y << places))
    }
}

/// Finds the place of the last digit and rounds there.
///
/// `scaled(places)` gives the number times `10^places`, rounded as asked, and whether the number reaches that
/// in size; `None` where the enclosure does not tell.
fn place_and_round(
    sign: Ordering,
    digits: Digits,
    mut leading: i64,
    scaled: impl Fn(i64) -> Option<(Integer, Option<bool>)>,
) -> Option<Decimal> {
    let negative = sign == Ordering::Less;
    let wanted = match digits {
        Digits::Places(places) => {
            let places = i64::try_from(places).ok()?;
            let value = scaled(places)?.0.unsigned_abs();
            return Some(Decimal {
                negative: negative && value != 0,
                digits: value.to_string(),
                exponent: -places,
                plain: true,
            });
        }
        Digits::Significant(wanted) => i64::try_from(wanted).ok()?,
    };
    // The estimate is off by a few places at most, and each round corrects it by what it finds.
    for _ in 0..6 {
        let places = wanted.checked_sub(1)?.checked_sub(leading)?;
        let (value, reaches) = scaled(places)?;
        let mut text = value.unsigned_abs_ref().to_string();
        let length = i64::try_from(text.len()).ok()?;
        let is_power_of_ten = text.starts_with('1') && text.bytes().skip(1).all(|b| b == b'0');
        if value == 0 {
            leading -= 1;
        } else if length == wanted + 1 && is_power_of_ten {
            // Rounded up to the next power of ten, or equal to it to the last digit: the same decimal.
            text.pop();
            return Some(Decimal { negative, digits: text, exponent: 1 - places, plain: false });
        } else if length == wanted && is_power_of_ten && !reaches? {
            // Smaller than that power of ten: one more place is significant.
            leading -= 1;
        } else if length == wanted {
            return Some(Decimal { negative, digits: text, exponent: -places, plain: false });
        } else {
            leading += length - wanted;
        }
    }
    None
}

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.negative {
            write!(f, "-")?;
        }
        let length = i64::try_from(self.digits.len()).unwrap_or(i64::MAX);
        let leading = length - 1 + self.exponent;
        let plain = self.plain || (self.exponent <= 0 && (PLAIN_FROM..=PLAIN_TO).contains(&leading));
        if !plain {
            let (first, rest) = self.digits.split_at(1);
            let point = if rest.is_empty() { "" } else { "." };
            return write!(f, "{first}{point}{rest}e{leading}");
        }
        if self.exponent >= 0 {
            return write!(f, "{}{}", self.digits, "0".repeat(usize::try_from(self.exponent).unwrap_or(0)));
        }
        let after = usize::try_from(-self.exponent).unwrap_or(usize::MAX);
        if after < self.digits.len() {
            let (whole, fraction) = self.digits.split_at(self.digits.len() - after);
            write!(f, "{whole}.{fraction}")
        } else {
            // By hand: format widths end at 65535.
            write!(f, "0.{}{}", "0".repeat(after - self.digits.len()), self.digits)
        }
    }
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
