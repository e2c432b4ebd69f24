//! eta as a pair of doubles that enclose it, for many cells: no allocation, no big numbers.
//!
//! **Contract.** For doubles taken as exact numbers, [`eta`] gives `(lo, hi)` with `lo <= eta <= hi`. In the
//! ordinary range (`r` from 2^-400 to 2^400, `N <= `[`MAX_COLLISIONS`], eta above 2^-400) the relative width is at most
//! 2^-50; elsewhere the enclosure comes from intervals, and for arguments that are no chain it is NaN.
//!
//! **Method.** A guess `t` of `r^(1/N)` from libm; `ρ = t^N/r − 1` in double-double; then
//! `r^(1/N) = t·(1 + ρ)^(−1/N) = t·(1 − ρ/N + θ)`, `|θ| <= 2ρ²/N` for `|ρ| <= 1/16` ([`crate::number::root`]). With
//! `q = (1 + e)/(1 + t)`, eta is `q^(2N)·r`. A wrong guess makes `ρ` large, and then intervals decide.
//!
//! **Why the bounds hold.** `u = 2^-53`, all results within 2^±800. A pair `(h, l)`, `|l| <= u|h|`, stands for `h + l`.
//! A product of pairs is within `9u²` of the exact one and a quotient within `16u²`, a sum of positive pairs within
//! `3u²` (the counts are those of [`crate::number::double`]). A power by `k` products multiplies a relative error
//! by at most its exponent and adds `9u²` in each, doubled by each squaring after it: at most `9u²·2p` for a `p`-th
//! power. Let `E = 2^-101 > 16u²`:
//! - `t^N` is within `N·E` (of exact `t`), so `ρ` is within `1.1·(N + 2)·E + 2u·|ρ|`, and `ρ/N` within `4E + 2u·|ρ|/N`.
//! - the correction `t·ρ/N` is made of doubles, which costs `8u·|ρ|/N`; the root is within `6E + (8u·|ρ| + 2ρ²)/N`.
//! - `1 + t`, `q`: another `3E` and `E` (the relative error of `1 + t` is at most that of `t`). The `2N`-th power has
//!   `2N` times as much and `2N·2E` of its own, the product with `r` another `E`: in all less than
//!   `2N·16E + 16u·|ρ| + 4ρ²`.
//!
//! For `N <= 2^16` and `|ρ| <= 2^-36` this is below `2^-80 + 2^-85 + 2^-70`; [`SLACK`] is `2^-64`, which is far below
//! the two roundings that make the ends doubles.

use super::{Positive, Restitution, Restitutions, transfer};
use malachite::Rational;

/// The most collisions that are computed in double-double; more go to intervals.
pub const MAX_COLLISIONS: u64 = 1 << 16;

/// A bound of all relative errors of the middle; see the module.
const SLACK: f64 = f64::from_bits((1023 - 64) << 52);

/// The largest `|ρ|` for which the bounds are stated.
const NEAR: f64 = f64::from_bits((1023 - 36) << 52);

/// `2^400` and `2^-400`.
const LARGE: f64 = f64::from_bits((1023 + 400) << 52);
const SMALL: f64 = f64::from_bits((1023 - 400) << 52);

/// `high + low`, not evaluated.
#[derive(Clone, Copy)]
struct Pair {
    high: f64,
    low: f64,
}

/// `a = high + low` with 26 bits each (Veltkamp).
#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    let c = 134_217_729.0 * a;
    let high = c - (c - a);
    (high, a - high)
}

/// `a + b = s + error` for `|a| >= |b|` (Dekker).
#[inline(always)]
fn fast_sum(a: f64, b: f64) -> Pair {
    let s = a + b;
    Pair { high: s, low: b - (s - a) }
}

/// `a·b` exactly (Dekker).
#[inline(always)]
fn product(a: f64, b: f64) -> Pair {
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    Pair { high: p, low: ((ah * bh - p) + ah * bl + al * bh) + al * bl }
}

impl Pair {
    #[inline(always)]
    fn square(self) -> Pair {
        let a = self.high;
        let p = a * a;
        let (h, l) = split(a);
        let error = ((h * h - p) + 2.0 * (h * l)) + l * l;
        fast_sum(p, error + 2.0 * (a * self.low))
    }

    #[inline(always)]
    fn times(self, other: Pair) -> Pair {
        let p = product(self.high, other.high);
        fast_sum(p.high, p.low + (self.high * other.low + self.low * other.high))
    }

    #[inline(always)]
    fn times_double(self, other: f64) -> Pair {
        let p = product(self.high, other);
        fast_sum(p.high, p.low + self.low * other)
    }

    #[inline(always)]
    fn over(self, other: Pair) -> Pair {
        let q = self.high / other.high;
        let p = product(q, other.high);
        // self.high − p.high is exact: the two agree to a few ulps.
        let rest = ((self.high - p.high) - p.low) + (self.low - q * other.low);
        fast_sum(q, rest / other.high)
    }

    /// The power with an exponent of at least 1.
    #[inline(always)]
    fn power(self, exponent: u64) -> Pair {
        let mut result = self;
        let mut mask = (1_u64 << exponent.ilog2()) >> 1;
        while mask != 0 {
            result = result.square();
            if exponent & mask != 0 {
                result = result.times(self);
            }
            mask >>= 1;
        }
        result
    }
}

/// Encloses eta for optimal masses: restitution `e`, mass ratio `r = m1/m2`, `collisions = n + 1`.
///
/// `(NaN, NaN)` where `e` does not lie from 0 to 1, `r` is not a positive number or there is no collision.
///
/// ```
/// let (lo, hi) = carom::chain::fast::eta(0.9, 10.0, 8);
/// assert!(lo <= 0.37313751177373857 && 0.37313751177373859 <= hi && (hi - lo) / lo <= 2f64.powi(-50));
/// ```
#[must_use]
#[inline]
pub fn eta(e: f64, r: f64, collisions: u64) -> (f64, f64) {
    match quick(e, r, collisions) {
        Some(found) => found,
        None => careful(e, r, collisions),
    }
}

/// [`eta`] for slices of equal length.
///
/// # Panics
/// Never: of slices of unequal length the shortest one counts.
pub fn etas(e: &[f64], r: &[f64], collisions: &[u64], out: &mut [(f64, f64)]) {
    for (((e, r), count), out) in e.iter().zip(r).zip(collisions).zip(out) {
        *out = eta(*e, *r, *count);
    }
}

#[inline(always)]
fn quick(e: f64, r: f64, collisions: u64) -> Option<(f64, f64)> {
    let ordinary = (0.0..=1.0).contains(&e) && (SMALL..=LARGE).contains(&r);
    if !ordinary || collisions.wrapping_sub(1) >= MAX_COLLISIONS {
        return None;
    }
    let count = collisions as f64;
    let exact = |x: f64| Pair { high: x, low: 0.0 };
    let guess = if collisions == 1 { r } else { r.powf(1.0 / count) };
    // Also refuses NaN.
    if !(SMALL..=LARGE).contains(&guess) {
        return None;
    }
    let power = exact(guess).power(collisions);
    // The difference is exact where the power is near r, and where it is not, ρ is refused.
    let rho = ((power.high - r) + power.low) / r;
    if rho.abs() > NEAR || rho.is_nan() {
        return None;
    }
    // 1 + t, with the correction −t·ρ/N below an ulp of t; its own rounding is u times as large.
    let correction = -guess * (rho / count);
    let (big, small) = if guess >= 1.0 { (guess, 1.0) } else { (1.0, guess) };
    let sum = fast_sum(big, small);
    let sum = fast_sum(sum.high, sum.low + correction);
    let up = fast_sum(1.0, e);
    let q = up.over(sum);
    // q^(2N)·r; for r >= 1 as (q·t)^(2N)/r, so that nothing overflows on the way.
    let found = if r > 1.0 {
        let root = fast_sum(guess, correction);
        q.times(root).power(2 * collisions).over(exact(r))
    } else {
        q.power(2 * collisions).times_double(r)
    };
    if !(SMALL..=2.0).contains(&found.high) {
        return None;
    }
    let slack = found.high * SLACK;
    // Each end: a rounding of the inner difference (far below an ulp) and one of the outer, undone by a step.
    // Both are positive and normal, so a step is one unit of their bits.
    let lo = f64::from_bits((found.high + (found.low - slack)).to_bits() - 1);
    let hi = f64::from_bits((found.high + (found.low + slack)).to_bits() + 1);
    Some((lo, hi))
}

/// The same by intervals.
#[cold]
#[inline(never)]
fn careful(e: f64, r: f64, collisions: u64) -> (f64, f64) {
    let exact = |x: f64| Rational::try_from(x).ok();
    let chain = || {
        let e = Restitution::new(exact(e)?).ok()?;
        let r = Positive::new(exact(r)?).ok()?;
        transfer::optimal(&r, &Restitutions::Same(e), collisions.checked_sub(1)?).ok()
    };
    match chain() {
        Some(eta) => eta.enclosure(80).to_f64_ends(),
        None => (f64::NAN, f64::NAN),
    }
}

/// The factors of eta on a grid: `eta(e, r, N) = A(e, N)·B(r, N)`, `A = ((1+e)/2)^(2N)`, `B = (4t/(1+t)²)^N`.
///
/// Both lie in (0, 1], so their products do not overflow.
#[derive(Clone, Debug, Default)]
pub struct Factors {
    lower: Vec<f64>,
    upper: Vec<f64>,
}

impl Factors {
    /// `A(e, N)` for each `e`.
    #[must_use]
    pub fn of_restitutions(e: &[f64], collisions: u64) -> Factors {
        // At r = 1, eta is ((1+e)/2)^(2N).
        Factors::collect(e.iter().map(|e| eta(*e, 1.0, collisions)))
    }

    /// `B(r, N)` for each `r`.
    #[must_use]
    pub fn of_ratios(r: &[f64], collisions: u64) -> Factors {
        // At e = 1, eta is (4t/(1+t)²)^N.
        Factors::collect(r.iter().map(|r| eta(1.0, *r, collisions)))
    }

    fn collect(ends: impl Iterator<Item = (f64, f64)>) -> Factors {
        let (lower, upper) = ends.unzip();
        Factors { lower, upper }
    }
}

/// All products of the factors, a row of `ratios` for each restitution: `lower` and `upper` ends.
///
/// A cell costs two products and a step outwards each; its relative width is that of both factors and two
/// roundings, below 2^-48. `lower` and `upper` must have `restitutions × ratios` places; further cells are left.
pub fn grid(restitutions: &Factors, ratios: &Factors, lower: &mut [f64], upper: &mut [f64]) {
    let width = ratios.lower.len();
    if width == 0 {
        return;
    }
    let rows = lower.chunks_exact_mut(width).zip(upper.chunks_exact_mut(width));
    for ((a, b), (low, high)) in restitutions.lower.iter().zip(&restitutions.upper).zip(rows) {
        for (cell, factor) in low.iter_mut().zip(&ratios.lower) {
            *cell = step_down(a * factor);
        }
        for (cell, factor) in high.iter_mut().zip(&ratios.upper) {
            *cell = step_up(b * factor);
        }
    }
}

/// Below `x >= 0` by at least half an ulp, without a branch: `x·2^-52` is at least an ulp, so the product is
/// rounded to at most the double below `x`; two of the least positive doubles cover what underflows.
#[inline(always)]
fn step_down(x: f64) -> f64 {
    let below = x * (1.0 - f64::EPSILON) - f64::from_bits(2);
    below.max(0.0)
}

/// Above `x >= 0` by at least half an ulp.
#[inline(always)]
fn step_up(x: f64) -> f64 {
    x * (1.0 + f64::EPSILON) + f64::from_bits(2)
}
