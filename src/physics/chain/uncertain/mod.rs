//! Measured masses and coefficients of restitution: results as enclosures over the whole box of inputs.
//!
//! **Contract.** Nothing outside of the printed ends is a value of the box. The ends are attained, up to the rounding
//! of the printed decimals, with two exceptions that a limit bounds: velocities with *one* measured coefficient for
//! all collisions ([`given::PIECES`]) and chains whose other bodies move as well ([`cells::CELLS`]).
//!
//! **Why the corners suffice.** Let `d = ln(r)/2`; `r` close to 1 means `|d|` small.
//! - *Optimal masses.* `eta = ∏(1+e_i)²/4 · sech(d/N)^(2N)` rises with each `e_i` and falls with `|d|`.
//!   `L_n + 1 = 2·cosh(d/(n+1))^(n+1)/cosh(d/n)^n`, and the derivative of its logarithm by `d > 0` is
//!   `tanh(d/(n+1)) − tanh(d/n) < 0`: `L_n` falls with `|d|`. So `n* = #{n : L_n <= e}` rises with `e` and with `|d|`, and
//!   `e − L_n` does. `mu_i = m1^((N−i)/N)·m2^(i/N)` rises with both masses. Velocities and losses: [`optimum`].
//! - *Given masses.* [`given`]: what falls is least at a vertex of the box; what is greatest is the maximum of a
//!   concave function, found in `peak`. Other bodies in motion: [`cells`]. Whether bodies meet again: [`meeting`].
//!
//! The ratio `r` ranges over `[m1_lo/m2_hi, m1_hi/m2_lo]`: the two masses are measured independently.

pub(crate) mod bound;
pub mod cells;
pub mod given;
pub mod meeting;
pub mod optimum;
pub(crate) mod peak;

use super::best::{Best, best};
use super::threshold::{Helps, helps};
use super::{ChainError, Positive, Restitution, Restitutions, transfer};
use crate::number::NumberError;
use crate::number::rational::{NumeralError, parse};
use crate::number::real::{Level, Real};
use crate::number::typed::{self, Unclear};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Abs;
use malachite::base::num::basic::traits::{One, Zero};
use std::fmt;

/// The most bodies of a chain with given masses of which some input is measured.
pub const MAX_MEASURED: u64 = 1_000;

/// All numbers from `lo` to `hi`; a point where they are equal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Range<T> {
    lo: T,
    hi: T,
}

/// Why a text is no number and no range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RangeError {
    /// A numeral in it is wrong.
    Numeral(NumeralError),
    /// A bracket or comma is missing.
    Brackets,
    /// The lower end is above the upper one.
    Reversed,
    /// An uncertainty below zero.
    NegativeUncertainty,
    /// Parentheses that do not hold the uncertainty of the last digits.
    Parentheses,
}

impl fmt::Display for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Numeral(error @ NumeralError::Uncertainty { .. }) => {
                write!(f, "{error}, or an uncertainty such as 57.1 ± 0.1")
            }
            Self::Numeral(error) => write!(f, "{error}"),
            Self::Brackets => write!(f, "write a range as [lower, upper]"),
            Self::Reversed => write!(f, "the lower end of a range is above its upper end"),
            Self::NegativeUncertainty => write!(f, "an uncertainty must not be negative"),
            Self::Parentheses => {
                write!(f, "write an uncertainty of the last digits as 57.1(1), which means 57.1 ± 0.1")
            }
        }
    }
}

impl std::error::Error for RangeError {}

impl<T: Clone + PartialOrd> Range<T> {
    /// A single number.
    #[must_use]
    pub fn point(x: T) -> Range<T> {
        Range { lo: x.clone(), hi: x }
    }

    /// A range.
    ///
    /// # Errors
    /// [`RangeError::Reversed`].
    pub fn new(lo: T, hi: T) -> Result<Range<T>, RangeError> {
        if lo <= hi { Ok(Range { lo, hi }) } else { Err(RangeError::Reversed) }
    }

    /// The lower end.
    #[must_use]
    pub fn lo(&self) -> &T {
        &self.lo
    }

    /// The upper end.
    #[must_use]
    pub fn hi(&self) -> &T {
        &self.hi
    }

    /// The single number, where it is one.
    #[must_use]
    pub fn single(&self) -> Option<&T> {
        (self.lo == self.hi).then_some(&self.lo)
    }

    /// Both ends converted by an increasing function.
    ///
    /// # Errors
    /// What the function answers.
    pub fn map<U, E>(self, f: impl Fn(T) -> Result<U, E>) -> Result<Range<U>, E> {
        Ok(Range { lo: f(self.lo)?, hi: f(self.hi)? })
    }
}

impl Range<Rational> {
    /// All sums with the numbers of another range.
    #[must_use]
    pub fn plus(&self, other: &Range<Rational>) -> Range<Rational> {
        Range { lo: &self.lo + &other.lo, hi: &self.hi + &other.hi }
    }

    /// All products with the numbers of another range.
    #[must_use]
    pub fn times(&self, other: &Range<Rational>) -> Range<Rational> {
        let corner = |a: &Rational, b: &Rational| a * b;
        let (a, b) = (corner(&self.lo, &other.lo), corner(&self.lo, &other.hi));
        let (c, d) = (corner(&self.hi, &other.lo), corner(&self.hi, &other.hi));
        let lo = (&a).min(&b).min(&c).min(&d).clone();
        Range { lo, hi: a.max(b).max(c).max(d) }
    }

    /// All products with one number.
    #[must_use]
    pub fn scaled(&self, by: &Rational) -> Range<Rational> {
        self.times(&Range::point(by.clone()))
    }

    /// The least range that holds both.
    #[must_use]
    pub fn hull(&self, other: &Range<Rational>) -> Range<Rational> {
        Range { lo: (&self.lo).min(&other.lo).clone(), hi: (&self.hi).max(&other.hi).clone() }
    }

    /// What lies in both, where something does.
    #[must_use]
    pub fn meet(&self, other: &Range<Rational>) -> Range<Rational> {
        let (lo, hi) = ((&self.lo).max(&other.lo).clone(), (&self.hi).min(&other.hi).clone());
        if lo <= hi { Range { lo, hi } } else { self.clone() }
    }

    /// All squares.
    #[must_use]
    pub fn square(&self) -> Range<Rational> {
        let (a, b) = (&self.lo * &self.lo, &self.hi * &self.hi);
        if self.lo <= 0 && self.hi >= 0 {
            return Range { lo: Rational::ZERO, hi: a.max(b) };
        }
        if a <= b { Range { lo: a, hi: b } } else { Range { lo: b, hi: a } }
    }

    /// Reads a number or a measured value as it was typed ([`typed`]): `57.1`, `57.1 ± 0.1`, `57.1 +- 0.1`, `57.1 ± 1 %`, `57.1(1)`, `(5.71 ± 0.01)e1` or `[57.0, 57.2]`.
    ///
    /// An uncertainty is a bound: the value lies within it, and nothing outside is considered.
    ///
    /// ```
    /// use carom_physics::chain::uncertain::Range;
    /// assert_eq!(Range::read("57.1 ± 0.1"), Range::read("[57, 57.2]"));
    /// assert_eq!(Range::read("57.1(1)"), Range::read("57.1 ± 0.1"));
    /// assert_eq!(Range::read("50 ± 2 %"), Range::read("[49, 51]"));
    /// ```
    ///
    /// # Errors
    /// [`RangeError`].
    pub fn read(text: &str) -> Result<Range<Rational>, RangeError> {
        let plain = typed::number(text).map_err(|Unclear(what)| RangeError::Numeral(NumeralError::Unclear { what }))?;
        let text = plain.trim();
        if let Some(inside) = text.strip_prefix('[') {
            let inside = inside.strip_suffix(']').ok_or(RangeError::Brackets)?;
            let (lo, hi) = inside.split_once(',').ok_or(RangeError::Brackets)?;
            return Range::new(numeral(lo)?, numeral(hi)?);
        }
        if let Some(inside) = text.strip_prefix('(') {
            let (inside, exponent) = inside.split_once(")e").ok_or(RangeError::Parentheses)?;
            let scale = numeral(&format!("1e{exponent}"))?;
            let Range { lo, hi } = Range::read(inside)?;
            return Ok(Range { lo: lo * &scale, hi: hi * scale });
        }
        let parts = ["±", "+-", "+/-"].iter().find_map(|sign| text.split_once(sign));
        let (centre, reach) = match parts {
            None if text.contains('(') => concise(text)?,
            None => return Ok(Range::point(numeral(text)?)),
            Some((centre, reach)) => {
                let centre = numeral(centre)?;
                let reach = match reach.trim().strip_suffix('%') {
                    Some(share) => numeral(share)? * (&centre).abs() / Rational::from(100),
                    None => numeral(reach)?,
                };
                (centre, reach)
            }
        };
        if reach < 0 {
            return Err(RangeError::NegativeUncertainty);
        }
        Ok(Range { lo: &centre - &reach, hi: centre + reach })
    }
}

fn numeral(text: &str) -> Result<Rational, RangeError> {
    parse(text.trim()).map_err(RangeError::Numeral)
}

/// Centre and reach of `57.1(1)`: the digits in parentheses count in the last places before them.
fn concise(text: &str) -> Result<(Rational, Rational), RangeError> {
    let (before, rest) = text.split_once('(').ok_or(RangeError::Parentheses)?;
    let (digits, exponent) = rest.split_once(')').ok_or(RangeError::Parentheses)?;
    let power = !exponent.is_empty() && !exponent.starts_with(['e', 'E']);
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) || power || before.contains(['e', 'E', '/']) {
        return Err(RangeError::Parentheses);
    }
    let places = before.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    let scale = numeral(&format!("1{exponent}"))?;
    let last = numeral(&format!("1e-{places}"))?;
    Ok((numeral(before)? * &scale, numeral(digits)? * last * scale))
}

/// Coefficients of restitution, each perhaps measured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Coefficients {
    /// One for all collisions; where it is measured, all collisions share the one value that it has.
    Same(Range<Restitution>),
    /// One for each collision, measured independently.
    Each(Vec<Range<Restitution>>),
}

impl Coefficients {
    /// That of a collision, counted from 0; `None` beyond the last.
    #[must_use]
    pub fn at(&self, collision: usize) -> Option<&Range<Restitution>> {
        match self {
            Self::Same(e) => Some(e),
            Self::Each(list) => list.get(collision),
        }
    }

    /// The one coefficient of all collisions. Equal ranges in a list are not one: each of them has a value of its own.
    ///
    /// # Errors
    /// [`ChainError::UnequalRestitutions`] naming the quantity.
    pub fn common(&self, quantity: &'static str) -> Result<Range<Restitution>, ChainError> {
        match self {
            Self::Same(e) => Ok(e.clone()),
            Self::Each(list) => match list.first() {
                Some(first) if first.single().is_some() && list.iter().all(|e| e == first) => Ok(first.clone()),
                _ => Err(ChainError::UnequalRestitutions { quantity }),
            },
        }
    }

    /// The least range that holds the coefficients of two collisions; `None` where one of them is beyond the last.
    #[must_use]
    pub fn around(&self, one: usize, other: usize) -> Option<Range<Restitution>> {
        let (one, other) = (self.at(one)?, self.at(other)?);
        Some(Range { lo: one.lo.clone().min(other.lo.clone()), hi: one.hi.clone().max(other.hi.clone()) })
    }

    /// Whether each coefficient is a single number.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        match self {
            Self::Same(e) => e.single().is_some(),
            Self::Each(list) => list.iter().all(|e| e.single().is_some()),
        }
    }

    /// The range that all collisions share the value of, where it is more than a point.
    #[must_use]
    pub fn shared(&self) -> Option<&Range<Restitution>> {
        match self {
            Self::Same(e) if e.single().is_none() => Some(e),
            _ => None,
        }
    }
}

/// The ratios nearest to 1 and farthest from it, of independent first and last masses.
///
/// `r` and `1/r` count as equally far: everything that is asked here is the same for both.
#[must_use]
pub fn ratios(first: &Range<Positive>, last: &Range<Positive>) -> (Positive, Positive) {
    let (lo, hi) = (first.lo.over(&last.hi), first.hi.over(&last.lo));
    let far_below = lo.value() * hi.value() < Rational::ONE;
    let inside = *lo.value() <= Rational::ONE && *hi.value() >= Rational::ONE;
    let (near, far) = if far_below { (hi, lo) } else { (lo, hi) };
    (if inside { first.lo.over(&first.lo) } else { near }, far)
}

/// A range of real numbers: its least and greatest elements.
#[derive(Debug)]
pub struct Reals {
    /// The least one.
    pub least: Real,
    /// The greatest one.
    pub greatest: Real,
}

/// eta for optimal masses, over the box; the coefficients at their lower and at their upper ends.
///
/// # Errors
/// As [`transfer::optimal`].
pub(crate) fn optimal_transfer(
    first: &Range<Positive>,
    last: &Range<Positive>,
    (lower, upper): (&Restitutions, &Restitutions),
    n: u64,
) -> Result<Reals, ChainError> {
    let (near, far) = ratios(first, last);
    Ok(Reals { least: transfer::optimal(&far, lower, n)?, greatest: transfer::optimal(&near, upper, n)? })
}

/// `L_n`, over the box.
///
/// # Errors
/// As [`super::threshold::threshold`].
pub fn threshold(first: &Range<Positive>, last: &Range<Positive>, n: u64) -> Result<Reals, NumberError> {
    let (near, far) = ratios(first, last);
    Ok(Reals { least: super::threshold::threshold(&far, n)?, greatest: super::threshold::threshold(&near, n)? })
}

/// Whether the `n`-th body helps: the answer that the whole box shares, `None` where it depends.
///
/// # Errors
/// As [`super::threshold::compare`].
pub(crate) fn helps_over(
    first: &Range<Positive>,
    last: &Range<Positive>,
    e: &Range<Restitution>,
    n: u64,
) -> Result<(Option<Helps>, Level), NumberError> {
    let (near, far) = ratios(first, last);
    let (least, level) = helps(&e.lo, &near, n)?;
    if e.single().is_some() && near == far {
        return Ok((Some(least), level));
    }
    let (greatest, other) = helps(&e.hi, &far, n)?;
    Ok(((least == greatest).then_some(least), level.max(other)))
}

/// The least and the greatest `n*` over the box.
///
/// # Errors
/// As [`best`].
pub(crate) fn best_over(
    first: &Range<Positive>,
    last: &Range<Positive>,
    e: &Range<Restitution>,
) -> Result<((Best, Best), Level), ChainError> {
    let (near, far) = ratios(first, last);
    let (least, level) = best(&near, &e.lo)?;
    let (greatest, other) = best(&far, &e.hi)?;
    Ok(((least, greatest), level.max(other)))
}
