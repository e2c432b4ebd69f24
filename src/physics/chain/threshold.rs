//! The threshold `L_n`, (19): the `n`-th inserted body helps iff `e >= L_n`.
//!
//! `L_n + 1 = (1 + a)^(n+1)/(1 + b)^n` with `a = r^(1/(n+1))`, `b = r^(1/n)`, the same for `r` and `1/r`. It is rational iff
//! `r` is an `n(n+1)`-th power (see [`super`]); then `e` and `L_n` are compared exactly, and otherwise they differ.

use super::optimum::root_text;
use super::{MAX_INSERTED, Positive, Restitution, limit_inserted};
use crate::number::NumberError;
use crate::number::double::Double;
use crate::number::fixed::{Fixed, above_one, in_words};
use crate::number::interval::Interval;
use crate::number::parallel::{MIN_BITS, both};
use crate::number::rational::exact_root;
use crate::number::real::{FIRST_BITS, Level, MAX_BITS, Real};
use crate::number::root::{guess_ln, root};
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Two};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};
use std::cmp::Ordering;

/// Whether a further body helps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Helps {
    /// It raises the energy transfer.
    Yes,
    /// It lowers it.
    No,
    /// It changes nothing: `e = L_n`.
    OnTheThreshold,
}

impl Helps {
    /// The answer in words.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Yes => "yes",
            Self::No => "no",
            Self::OnTheThreshold => "exactly on the threshold",
        }
    }
}

/// `L_n` for the mass ratio `r = m1/m2`.
///
/// # Errors
/// [`NumberError::Undefined`] for `n = 0`; a limit above [`MAX_INSERTED`].
pub fn threshold(r: &Positive, n: u64) -> Result<Real, NumberError> {
    limit_inserted(n, "inserted bodies", MAX_INSERTED)?;
    defined(n)?;
    if let Some(exact) = rational(r.value(), &Natural::from(n)) {
        return Ok(Real::rational(exact));
    }
    let r = r.value().clone();
    let text = {
        let r = r.clone();
        move || match n {
            1 => format!("2*{}/(1 + {r})", root_text(&r, 1, 2)),
            _ => format!("(1 + {})^{}/(1 + {})^{n} - 1", root_text(&r, 1, n + 1), n + 1, root_text(&r, 1, n)),
        }
    };
    // Where r is far from 1, L_n is about (n + 1)·|r|^(−1/(n+1)): that many bits cancel.
    let cancelled = (guess_ln(&r).abs() * std::f64::consts::LOG2_E / (n as f64 + 1.0)) as u64;
    let quick = {
        let r = r.clone();
        move || double(&r, n)?.subtract(Double::exact(1.0)).to_interval()
    };
    let enclose = move |bits: u64| {
        if n == 1 {
            let above = root(&r, &Natural::TWO, bits + 8).shifted(1);
            return above.divide(&Interval::from_rational(&(&r + Rational::ONE), bits + 8), bits + 4);
        }
        let work = bits + cancelled + 4;
        plus_one(&r, &Natural::from(n), work).subtract(&Interval::from_integer(1), bits + 4)
    };
    Ok(Real::enclosed(enclose).with_quick(quick).with_radical(text))
}

fn defined(n: u64) -> Result<(), NumberError> {
    if n == 0 {
        return Err(NumberError::Undefined {
            what: "L_n is defined for n >= 1: it is the least restitution with which the n-th body helps".to_owned(),
        });
    }
    Ok(())
}

/// `L_n` where it is rational: for an `n(n+1)`-th power `r`.
fn rational(r: &Rational, n: &Natural) -> Option<Rational> {
    if *r == Rational::ONE {
        return Some(Rational::ONE);
    }
    // Other perfect powers have an exponent below the number of their bits.
    let n = u64::try_from(n).ok().filter(|n| *n < 1 << 31)?;
    let t = exact_root(r, n * (n + 1))?;
    Some((Rational::ONE + (&t).pow(n)).pow(n + 1) / (Rational::ONE + t.pow(n + 1)).pow(n) - Rational::ONE)
}

/// `L_n + 1` with about `bits` bits: `2·((1 + a)/2)^(n+1)/((1 + b)/2)^n`, in which no power exceeds `r`.
fn plus_one(r: &Rational, n: &Natural, bits: u64) -> Interval {
    if let Some(found) = in_words(r, n, bits) {
        return found.shifted(1);
    }
    let next = n + Natural::ONE;
    let work = bits + next.significant_bits() + 12;
    let one = Interval::from_integer(1);
    let half_sum = |k: &Natural| root(r, k, work).add(&one, work).shifted(-1).power(k, work);
    let (above, below) = both(work >= MIN_BITS, || half_sum(&next), || half_sum(n));
    above.divide(&below, work).shifted(1)
}

/// `(L_n + 1)/2` in machine words, where the ratio is short and so many bits fit.
fn in_words(r: &Rational, n: &Natural, bits: u64) -> Option<Interval> {
    let (r, n) = (above_one(r)?, u64::try_from(n).ok()?);
    in_words!(
        bits, bits, half_in_words(r, n),
        <3>, <4>, <6>, <8>, <10>, <12>, <14>, <16>, <20>, <24>, <28>, <32>, <40>, <46>, <54>, <62>
    )
}

/// `((1 + r^(−1/(n+1)))/2)^(n+1)/((1 + r^(−1/n))/2)^n` for `r > 1`: (19), the fraction reduced by `r`.
fn half_in_words<const L: usize>(r: (u64, u64), n: u64) -> Option<Fixed<L>> {
    let half_sum = |k: u64| Fixed::<L>::inverse_root(r.0, r.1, k)?.halfway_to_one()?.power(k);
    half_sum(n.checked_add(1)?)?.over(&half_sum(n)?)
}

/// `1 − L_n`, small for large `n`, with about `bits` bits.
pub(super) fn shortfall(r: &Positive, n: &Natural, bits: u64) -> Interval {
    let work = bits + 2 * n.significant_bits();
    Interval::from_integer(2).subtract(&plus_one(r.value(), n, work), work)
}

/// `L_n + 1` in double-double.
fn double(r: &Rational, n: u64) -> Option<Double> {
    let r = Double::from_rational(r);
    let one = Double::exact(1.0);
    let half = Double::exact(0.5);
    let half_sum = |k: u64| r.root(k).plus(one).multiply(half).power(k);
    Some(half_sum(n.checked_add(1)?).divide(half_sum(n)).multiply(Double::exact(2.0)))
}

/// The largest `d/n` for which [`by_series`] is asked. Beyond it [`double`], which loses `n·2^-100`, tells about as much.
const NEAR: f64 = 1e-4;

/// The order of `1 + e` and `L_n + 1` for large `n`, in double-double; `None` where that does not tell.
///
/// With `d = ln(r)/2`, `(L_n + 1)/2 = exp(−S)`, `S = n·ln cosh(d/n) − (n+1)·ln cosh(d/(n+1))`. For `φ(t) = ln cosh(d·t)/t`,
/// `S = φ(1/n) − φ(1/(n+1))` and `φ'(t) = u(d·t)/t²`, `u(x) = x·tanh x − ln cosh x`, `u'(x) = x·(1 − tanh² x)`. As `tanh x <= x`,
/// and so `tanh x >= x − x³/3`, for `0 <= x <= 1`: `u` lies within `x⁶/9` above `x²/2 − x⁴/4`. Integrated, `S` lies within
/// `d⁶/(9n⁴)·D` above `d²/2·D − d⁴/12·(1/n³ − 1/(n+1)³)`, `D = 1/n − 1/(n+1)`. No power of a number near 1 is formed, so that no
/// digits are lost; `−ln((1 + e)/2)` is compared with `S`.
fn by_series(e_plus_one: &Rational, r: &Rational, n: &Natural) -> Option<Ordering> {
    let double = |n: &Natural| Double::from_rational(&Rational::from(n));
    let one = Double::exact(1.0);
    let (here, next) = (one.divide(double(n)), one.divide(double(&(n + Natural::ONE))));
    // What is refused below is refused before the logarithm is taken, but for a hair.
    if guess_ln(r).abs() * here.guess() > 3.0 * NEAR {
        return None;
    }
    let d = Double::ln(r).multiply(Double::exact(0.5));
    let square = d.multiply(d);
    let x = square.multiply(here).multiply(here);
    // Otherwise the rest is no smaller than what [`double`] loses; NaN fails it, too.
    let near = x.ends().is_some_and(|(_, most)| most <= NEAR * NEAR);
    if !near {
        return None;
    }
    let step = here.multiply(next);
    // 1/n³ − 1/(n+1)³ = D·(1/n² + 1/(n(n+1)) + 1/(n+1)²).
    let cubes = here.multiply(here).plus(step).plus(next.multiply(next));
    let third = Double::exact(1.0).divide(Double::exact(3.0));
    // S/D·2/d² without its rest, and the rest: x²·2/9 at most.
    let shape = one.subtract(square.multiply(cubes).multiply(third).multiply(Double::exact(0.5)));
    let rest = x.multiply(x).multiply(third).multiply(third);
    let shape = shape.plus(rest).joined(rest);
    let s = step.multiply(square).multiply(Double::exact(0.5)).multiply(shape);
    let ln = Double::ln(&(e_plus_one >> 1u32));
    // 1 + e > L_n + 1 iff ln((1 + e)/2) > −S.
    ln.plus(s).sign().filter(|sign| *sign != Ordering::Equal)
}

/// The order of `e` and `L_n`, for any `n >= 1`, and the level that settled it.
///
/// # Errors
/// [`NumberError::Undefined`] for `n = 0`; [`NumberError::LimitReached`] where `e` and `L_n` differ by less than
/// the most precise enclosures can tell.
pub fn compare(e: &Restitution, r: &Positive, n: &Natural) -> Result<(Ordering, Level), NumberError> {
    let (e, r) = (e.plus_one(), r.value());
    if *n == 0u32 {
        defined(0)?;
    }
    if let Some(exact) = rational(r, n) {
        return Ok((e.cmp(&(exact + Rational::ONE)), Level::Exact));
    }
    if let Ok(small) = u64::try_from(n)
        && let Some(sign) = double(r, small).and_then(|l| Double::from_rational(&e).subtract(l).sign())
        && sign != Ordering::Equal
    {
        return Ok((sign, Level::Double));
    }
    if let Some(sign) = by_series(&e, r, n) {
        return Ok((sign, Level::Double));
    }
    // 1 − L_n is about d²/(n(n+1)), and neighbours differ by a factor n less.
    let mut bits = FIRST_BITS.max(3 * n.significant_bits() + 32);
    while bits <= MAX_BITS {
        let difference = Interval::from_rational(&e, bits).subtract(&plus_one(r, n, bits), bits);
        match difference.sign() {
            Some(sign) if sign != Ordering::Equal => return Ok((sign, Level::Interval(bits))),
            _ => bits *= 2,
        }
    }
    Err(NumberError::LimitReached { limit: "bits of an enclosure", allowed: MAX_BITS, needed: bits.to_string() })
}

/// Whether the `n`-th inserted body helps, each number of bodies with its optimal masses, and the level that
/// settled it.
///
/// # Errors
/// As [`compare`].
pub fn helps(e: &Restitution, r: &Positive, n: u64) -> Result<(Helps, Level), NumberError> {
    let (order, level) = compare(e, r, &Natural::from(n))?;
    let answer = match order {
        Ordering::Greater => Helps::Yes,
        Ordering::Less => Helps::No,
        Ordering::Equal => Helps::OnTheThreshold,
    };
    Ok((answer, level))
}
