//! Measured masses and coefficients of restitution: results as enclosures over the whole box of inputs.
//!
//! **Contract.** Both ends are attained, up to the rounding of the printed decimals: nothing is widened.
//!
//! **Why the corners suffice.** Let `d = ln(r)/2`; `r` close to 1 means `|d|` small.
//! - *Optimal masses.* `eta = ∏(1+e_i)²/4 · sech(d/N)^(2N)` rises with each `e_i` and falls with `|d|`.
//!   `L_n + 1 = 2·cosh(d/(n+1))^(n+1)/cosh(d/n)^n`, and the derivative of its logarithm by `d > 0` is
//!   `tanh(d/(n+1)) − tanh(d/n) < 0`: `L_n` falls with `|d|`. So `n* = #{n : L_n <= e}` rises with `e` and with `|d|`, and
//!   `e − L_n` does. `mu_i = m1^((N−i)/N)·m2^(i/N)` rises with both masses.
//! - *Given masses.* With `δ_i = ln(m_(i−1)/m_i)`, `eta = ∏(1+e_i)²/4 · ∏ sech(δ_i/2)²`, as
//!   `m_(i−1)·m_i/(m_(i−1)+m_i)² = sech(δ_i/2)²/4`. Its logarithm is concave in the logarithms of the masses: the least
//!   value lies at a vertex of the box, and a chain's vertices are searched body by body ([`least_transfer`]).
//!   The greatest one minimises a sum of one even convex function of all `δ_i` between walls: its solution is
//!   the taut string, the same for all such functions. Between the walls that it touches it is a chain of
//!   constant ratio ([`greatest_transfer`]).
//!
//! The ratio `r` ranges over `[m1_lo/m2_hi, m1_hi/m2_lo]`: the two masses are measured independently.

use super::best::{Best, best};
use super::optimum::Optimum;
use super::threshold::{Helps, helps};
use super::{ChainError, Positive, Restitution, Restitutions, recollision, transfer};
use crate::number::NumberError;
use crate::number::interval::Interval;
use crate::number::rational::{NumeralError, parse};
use crate::number::real::{Level, Real};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Pow, Square};
use malachite::base::num::basic::traits::One;
use std::cmp::Ordering;
use std::fmt;

/// The most bodies of a chain with measured masses.
pub const MAX_MEASURED: u64 = 200;

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
}

impl fmt::Display for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Numeral(error @ NumeralError::Uncertainty { .. }) => {
                write!(f, "{error}, or an uncertainty as in 57.1 ± 0.1")
            }
            Self::Numeral(error) => write!(f, "{error}"),
            Self::Brackets => write!(f, "a range is written [lower, upper]"),
            Self::Reversed => write!(f, "the lower end of a range is above its upper end"),
            Self::NegativeUncertainty => write!(f, "an uncertainty must not be below 0"),
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
    /// Reads `57.1`, `57.1 ± 0.1`, `57.1 +- 0.1` or `[57.0, 57.2]`.
    ///
    /// ```
    /// use carom::chain::uncertain::Range;
    /// assert_eq!(Range::read("57.1 ± 0.1"), Range::read("[57, 57.2]"));
    /// ```
    ///
    /// # Errors
    /// [`RangeError`].
    pub fn read(text: &str) -> Result<Range<Rational>, RangeError> {
        let text = text.trim();
        let numeral = |t: &str| parse(t.trim()).map_err(RangeError::Numeral);
        if let Some(inside) = text.strip_prefix('[') {
            let inside = inside.strip_suffix(']').ok_or(RangeError::Brackets)?;
            let (lo, hi) = inside.split_once(',').ok_or(RangeError::Brackets)?;
            return Range::new(numeral(lo)?, numeral(hi)?);
        }
        let parts = ["±", "+-", "+/-"].iter().find_map(|sign| text.split_once(sign));
        let Some((centre, reach)) = parts else { return Ok(Range::point(numeral(text)?)) };
        let (centre, reach) = (numeral(centre)?, numeral(reach)?);
        if reach < 0 {
            return Err(RangeError::NegativeUncertainty);
        }
        Ok(Range { lo: &centre - &reach, hi: centre + reach })
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
pub fn optimal_transfer(
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
pub fn helps_over(
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
pub fn best_over(
    first: &Range<Positive>,
    last: &Range<Positive>,
    e: &Range<Restitution>,
) -> Result<((Best, Best), Level), ChainError> {
    let (near, far) = ratios(first, last);
    let (least, level) = best(&near, &e.lo)?;
    let (greatest, other) = best(&far, &e.hi)?;
    Ok(((least, greatest), level.max(other)))
}

/// Whether bodies of optimal mass meet again after the pass, with one coefficient for all collisions: they do iff
/// `|d|/N < −ln(e)/2`, so this ceases as `|d|` or `e` grows. `None` where it depends.
///
/// # Errors
/// As [`recollision::of_optimum`].
pub fn recollides_over(
    first: &Range<Positive>,
    last: &Range<Positive>,
    e: &Range<Restitution>,
    n: u64,
) -> Result<(Option<bool>, Level), ChainError> {
    let (near, far) = ratios(first, last);
    let unit = first.lo.over(&first.lo);
    let again = |r: Positive, e: &Restitution| {
        recollision::of_optimum(&Optimum::new(r, unit.clone(), n, Restitutions::Same(e.clone()))?)
    };
    let (likeliest, level) = again(near, &e.lo)?;
    let (least, other) = again(far, &e.hi)?;
    Ok(((likeliest == least).then_some(least), level.max(other)))
}

/// `∏(1 + e_i)²` of lower or upper coefficients.
fn gains(restitutions: &Restitutions, count: usize) -> Rational {
    let product = match restitutions {
        Restitutions::Same(e) => e.plus_one().pow(count as u64),
        Restitutions::Each(list) => list.iter().map(Restitution::plus_one).fold(Rational::ONE, |a, b| a * b),
    };
    product.square()
}

/// `a·b/(a + b)²`: the share that a pair of masses contributes.
fn share(a: &Rational, b: &Rational) -> Rational {
    a * b / (a + b).square()
}

fn limit_measured(masses: &[Range<Positive>]) -> Result<(), NumberError> {
    super::limit_inserted(masses.len() as u64, "bodies of measured mass", MAX_MEASURED)
}

/// The least eta of a chain of given masses over the box, exactly: a shortest path over the vertices.
///
/// # Errors
/// A limit above [`MAX_MEASURED`].
pub fn least_transfer(masses: &[Range<Positive>], restitutions: &Restitutions) -> Result<Rational, NumberError> {
    limit_measured(masses)?;
    // The least product up to the present body, for its mass at the lower and at the upper end.
    let mut products = [Rational::ONE, Rational::ONE];
    for pair in masses.windows(2) {
        let [behind, front] = pair else { continue };
        let arrive = |mass: &Positive| {
            let from_lo = &products[0] * share(behind.lo.value(), mass.value());
            let from_hi = &products[1] * share(behind.hi.value(), mass.value());
            from_lo.min(from_hi)
        };
        products = [arrive(&front.lo), arrive(&front.hi)];
    }
    let [a, b] = products;
    Ok(a.min(b) * gains(restitutions, masses.len().saturating_sub(1)))
}

/// A point where the taut string turns: the number of a body, and its mass.
type Knot = (usize, Rational);

/// Encloses the greatest eta of a chain of given masses over the box.
///
/// # Errors
/// A limit above [`MAX_MEASURED`].
pub fn greatest_transfer(
    masses: &[Range<Positive>],
    restitutions: &Restitutions,
    bits: u64,
) -> Result<Interval, ChainError> {
    limit_measured(masses)?;
    let knots = taut_string(masses);
    let mut product = Interval::from_rational(&gains(restitutions, masses.len().saturating_sub(1)), bits + 16);
    let still = Restitutions::Same(Restitution::new(Rational::from(0))?);
    for pair in knots.windows(2) {
        let [(i, a), (j, b)] = pair else { continue };
        let links = j.saturating_sub(*i) as u64;
        if links == 0 {
            continue;
        }
        // With e = 0, eta is the share of these links alone.
        let part = transfer::optimal(&Positive::new(a / b)?, &still, links - 1)?;
        product = product.multiply(&part.enclosure(bits + 16), bits + 16);
    }
    Ok(product)
}

/// A slope: the ratio of the masses at the ends, and the number of links between them.
type Slope = (Rational, usize);

/// The order of the slopes of two lines through a common point: `(ln p)/i` against `(ln q)/j`.
fn compare_slopes((p, i): (&Rational, usize), (q, j): (&Rational, usize)) -> Ordering {
    p.pow(j as u64).cmp(&q.pow(i as u64))
}

/// The path of masses between the walls whose logarithm is the taut string with free ends.
fn taut_string(masses: &[Range<Positive>]) -> Vec<Knot> {
    let Some(start) = level_start(masses) else { return Vec::new() };
    let mut knots = vec![(0, start.1.clone()), start];
    while let Some((at, mass)) = knots.last().cloned()
        && at + 1 < masses.len()
    {
        knots.push(next_knot(masses, at, &mass));
    }
    knots
}

/// Where a level string from the free start first has to turn, and its mass.
fn level_start(masses: &[Range<Positive>]) -> Option<Knot> {
    let first = masses.first()?;
    let (mut low, mut high) = ((0, first.lo.value().clone()), (0, first.hi.value().clone()));
    for (k, wall) in masses.iter().enumerate() {
        if *wall.lo.value() > high.1 {
            return Some(high);
        }
        if *wall.hi.value() < low.1 {
            return Some(low);
        }
        if *wall.lo.value() >= low.1 {
            low = (k, wall.lo.value().clone());
        }
        if *wall.hi.value() <= high.1 {
            high = (k, wall.hi.value().clone());
        }
    }
    Some((masses.len() - 1, low.1))
}

/// The next point where the string from a knot turns, or its end.
fn next_knot(masses: &[Range<Positive>], at: usize, mass: &Rational) -> Knot {
    // The least and greatest slopes so far, as ratios of masses over a number of links.
    let (mut low, mut high): (Option<Slope>, Option<Slope>) = (None, None);
    let knot = |(ratio, links): &Slope| (at + links, mass * ratio);
    for (k, wall) in masses.iter().enumerate().skip(at + 1) {
        let links = k - at;
        let (lo, hi) = (wall.lo.value() / mass, wall.hi.value() / mass);
        if let Some(top) = &high
            && compare_slopes((&lo, links), (&top.0, top.1)) == Ordering::Greater
        {
            return knot(top);
        }
        if let Some(bottom) = &low
            && compare_slopes((&hi, links), (&bottom.0, bottom.1)) == Ordering::Less
        {
            return knot(bottom);
        }
        if low.as_ref().is_none_or(|b| compare_slopes((&lo, links), (&b.0, b.1)) != Ordering::Less) {
            low = Some((lo, links));
        }
        if high.as_ref().is_none_or(|t| compare_slopes((&hi, links), (&t.0, t.1)) != Ordering::Greater) {
            high = Some((hi, links));
        }
    }
    // The end is free: as level as the walls allow.
    match (&low, &high) {
        (Some(bottom), _) if bottom.0 > Rational::ONE => knot(bottom),
        (_, Some(top)) if top.0 < Rational::ONE => knot(top),
        _ => (masses.len() - 1, mass.clone()),
    }
}
