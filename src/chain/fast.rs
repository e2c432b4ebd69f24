//! eta as a pair of doubles that enclose it, for many cells: no allocation, no big numbers.
//!
//! **Contract.** For doubles taken as exact numbers, [`eta`] gives `(lo, hi)` with `lo <= eta <= hi`. In the
//! ordinary range (`r` from 2^-400 to 2^400, `N <= `[`MAX_COLLISIONS`], eta above 2^-400) the relative width is at most
//! 2^-50; elsewhere the enclosure comes from intervals, and for arguments that are no chain it is NaN.
//!
//! **Method.** A guess `t` of `r^(1/N)` from libm; `ρ = t^N/r − 1` in double-double; then
//! `r^(1/N) = t·(1 + ε)`, `1 + ε = (1 + ρ)^(−1/N)`, so `ε = −ρ/N + θ`, `|θ| <= 2ρ²/N` ([`crate::number::root`]). Let
//! `eta_0 = ((1+e)/(1+t))^(2N)·r` be eta's formula at the guess. With `s = t/(1+t)`,
//! `eta = eta_0·(1 + ε·s)^(−2N) = eta_0·(1 + 2ρ·s + κ)`: the exponent `−2N·ln(1 + ε·s)` is `2ρ·s` within `4ρ² + 2ρ²/N`, and
//! `e^z − 1 − z` is below `z²`, `|z| <= 2.1·|ρ|`; so `|κ| <= 11ρ²`. For `r > 1`, `eta_0 = ((1+e)·s)^(2N)/r` and the factor
//! `(1 + ε)^(2N)·(1 + ε·s)^(−2N)` is `1 − 2ρ·(1 − s)` within as much twice. The two powers do not wait for each other. A
//! wrong guess makes `ρ` large, and then intervals decide.
//!
//! **Why the bounds hold.** `u = 2^-53`, all results within 2^±800. A pair `(h, l)`, `|l| <= u|h|`, stands for `h + l`.
//! A product of pairs is within `9u²` of the exact one and a quotient within `16u²`, `1 + t` and `1 + e` are exact (the
//! counts are those of [`crate::number::double`]). A power by products multiplies a relative error by its exponent `p`
//! and adds at most `9u²·2p` of its own. Let `E = 2^-101 >= 16u²`:
//! - `t^N` is within `2N·E`, so `ρ` is within `2.1·N·E + 3u·|ρ|`, and the correction within three times that.
//! - the base of the other power is within `2E`, its `2N`-th power within `8N·E`, the product or quotient by `r` adds `E`.
//! - adding the correction rounds it by `4u·|ρ|`.
//!
//! In all less than `16N·E + 16u·|ρ| + 22ρ²`, for `N <= 2^16` and `|ρ| <= 2^-36` below `2^-81 + 2^-85 + 2^-67`. `SLACK` is
//! `2^-64`, which is far below the two roundings that make the ends doubles.

use super::{Positive, Restitution, Restitutions, transfer};
use malachite::Rational;
use std::ops::{Add, Div, Mul, Sub};

/// The most collisions that are computed in double-double; more go to intervals.
pub const MAX_COLLISIONS: u64 = 1 << 16;

/// A bound of all relative errors of the middle; see the module.
const SLACK: f64 = f64::from_bits((1023 - 64) << 52);

/// The largest `|ρ|` for which the bounds are stated.
const NEAR: f64 = f64::from_bits((1023 - 36) << 52);

/// `2^400` and `2^-400`.
const LARGE: f64 = f64::from_bits((1023 + 400) << 52);
const SMALL: f64 = f64::from_bits((1023 - 400) << 52);

/// What the double-double formulas need of a number: a double, or several side by side.
trait Value: Copy + From<f64> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> {}

impl Value for f64 {}
impl Value for Lanes {}

/// Cells that are computed side by side: what one waits for fills the time of another, and two share an instruction.
const LANES: usize = 4;

/// A double of each of [`LANES`] cells.
#[derive(Clone, Copy)]
struct Lanes([f64; LANES]);

impl Lanes {
    #[inline(always)]
    fn each(mut self, other: Lanes, with: impl Fn(f64, f64) -> f64) -> Lanes {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a = with(*a, b);
        }
        self
    }
}

impl From<f64> for Lanes {
    #[inline(always)]
    fn from(x: f64) -> Lanes {
        Lanes([x; LANES])
    }
}

impl Add for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn add(self, other: Lanes) -> Lanes {
        self.each(other, |a, b| a + b)
    }
}

impl Sub for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn sub(self, other: Lanes) -> Lanes {
        self.each(other, |a, b| a - b)
    }
}

impl Mul for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn mul(self, other: Lanes) -> Lanes {
        self.each(other, |a, b| a * b)
    }
}

impl Div for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn div(self, other: Lanes) -> Lanes {
        self.each(other, |a, b| a / b)
    }
}

/// `high + low`, not evaluated.
#[derive(Clone, Copy)]
struct Pair<T> {
    high: T,
    low: T,
}

/// `a = high + low` with 26 bits each (Veltkamp).
#[inline(always)]
fn split<T: Value>(a: T) -> (T, T) {
    let c = T::from(134_217_729.0) * a;
    let high = c - (c - a);
    (high, a - high)
}

/// `a + b = s + error` for `|a| >= |b|` (Dekker).
#[inline(always)]
fn fast_sum<T: Value>(a: T, b: T) -> Pair<T> {
    let s = a + b;
    Pair { high: s, low: b - (s - a) }
}

/// `a·b` exactly (Dekker).
#[inline(always)]
fn product<T: Value>(a: T, b: T) -> Pair<T> {
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    Pair { high: p, low: ((ah * bh - p) + ah * bl + al * bh) + al * bl }
}

impl<T: Value> Pair<T> {
    #[inline(always)]
    fn exact(x: T) -> Self {
        Pair { high: x, low: T::from(0.0) }
    }

    #[inline(always)]
    fn square(self) -> Self {
        let (a, two) = (self.high, T::from(2.0));
        let p = a * a;
        let (h, l) = split(a);
        let error = ((h * h - p) + two * (h * l)) + l * l;
        fast_sum(p, error + two * (a * self.low))
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        let p = product(self.high, other.high);
        fast_sum(p.high, p.low + (self.high * other.low + self.low * other.high))
    }

    #[inline(always)]
    fn times_double(self, other: T) -> Self {
        let p = product(self.high, other);
        fast_sum(p.high, p.low + self.low * other)
    }

    #[inline(always)]
    fn over(self, other: Self) -> Self {
        let q = self.high / other.high;
        let p = product(q, other.high);
        // self.high − p.high is exact: the two agree to a few ulps.
        let rest = ((self.high - p.high) - p.low) + (self.low - q * other.low);
        fast_sum(q, rest / other.high)
    }
}

/// Two powers with the same exponent, at least 1; side by side they keep the processor busy.
#[inline(always)]
fn powers<T: Value>(a: Pair<T>, b: Pair<T>, exponent: u64) -> (Pair<T>, Pair<T>) {
    let (mut x, mut y) = (a, b);
    let mut mask = (1_u64 << exponent.ilog2()) >> 1;
    while mask != 0 {
        (x, y) = (x.square(), y.square());
        if exponent & mask != 0 {
            (x, y) = (x.times(a), y.times(b));
        }
        mask >>= 1;
    }
    (x, y)
}

/// eta in double-double and `ρ`, from the guess, which is `big/small`'s or its reciprocal; `above` says `r > 1`.
#[inline(always)]
fn corrected<T: Value>(e: T, r: T, guess: T, (big, small): (T, T), collisions: u64, above: bool) -> (Pair<T>, T) {
    let sum = fast_sum(big, small);
    let up = fast_sum(T::from(1.0), e);
    // For r > 1 as (q·t)^(2N)/r, so that nothing overflows on the way.
    let base = if above { up.times_double(guess) } else { up }.over(sum);
    let (power, root) = powers(Pair::exact(guess), base, collisions);
    // The difference is exact where the power is near r, and where it is not, ρ is refused.
    let rho = ((power.high - r) + power.low) / r;
    let (found, correction) = if above {
        (root.square().over(Pair::exact(r)), T::from(-2.0) * rho / sum.high)
    } else {
        (root.square().times_double(r), T::from(2.0) * rho * (guess / sum.high))
    };
    (fast_sum(found.high, found.low + found.high * correction), rho)
}

/// Encloses eta for optimal masses: restitution `e`, mass ratio `r = m1/m2`, `collisions = n + 1`.
///
/// `(NaN, NaN)` where `e` does not lie from 0 to 1, `r` is not a positive number or there is no collision.
///
/// ```
/// let (lo, hi) = carom::chain::fast::eta(0.9, 10.0, 8);
/// // The double 0.9 is a little more than 9/10; for that e, eta = 0.373137511773738644...
/// assert!(lo <= 0.373137511773738644 && 0.373137511773738644 <= hi && (hi - lo) / lo <= 2f64.powi(-50));
/// ```
#[must_use]
#[inline]
pub fn eta(e: f64, r: f64, collisions: u64) -> (f64, f64) {
    match quick(e, r, collisions) {
        Some(found) => found,
        None => careful(e, r, collisions),
    }
}

/// [`eta`] for slices of equal length; of slices of unequal length the shortest one counts.
///
/// The cells of a block with as many collisions and `r` on the same side of 1 follow the same steps: they are taken
/// some at a time. Each gets exactly what [`eta`] gives it.
pub fn etas(e: &[f64], r: &[f64], collisions: &[u64], out: &mut [(f64, f64)]) {
    let blocks = e.chunks(BLOCK).zip(r.chunks(BLOCK)).zip(collisions.chunks(BLOCK)).zip(out.chunks_mut(BLOCK));
    for (((e, r), collisions), out) in blocks {
        block(e, r, collisions, out);
    }
}

/// Cells that are put in order at a time.
const BLOCK: usize = 2048;

/// Collisions up to which cells are put in order by their number; more are rare, and costly one by one too.
const SORTED: usize = 128;

/// [`etas`] for at most [`BLOCK`] cells.
fn block(e: &[f64], r: &[f64], collisions: &[u64], out: &mut [(f64, f64)]) {
    let count = e.len().min(r.len()).min(collisions.len()).min(out.len());
    // A key is twice the number of collisions, and one more where r > 1; 0 for what is not sorted.
    let key = |i: usize| match usize::try_from(collisions[i]) {
        Ok(n) if n <= SORTED => 2 * n + usize::from(r[i] > 1.0),
        _ => 0,
    };
    // Counting sort: where the cells of each key begin, then their numbers in that order.
    let mut ends = [0_usize; 2 * SORTED + 2];
    for i in 0..count {
        ends[key(i)] += 1;
    }
    let mut sum = 0;
    for end in &mut ends {
        sum += std::mem::replace(end, sum);
    }
    let mut order = [0_usize; BLOCK];
    for i in 0..count {
        let place = &mut ends[key(i)];
        order[*place] = i;
        *place += 1;
    }
    // Now each key's cells end where `ends` says.
    let mut from = 0;
    for (key, to) in ends.into_iter().enumerate() {
        let same = order.get(from..to).unwrap_or_default();
        from = to;
        for some in same.chunks(LANES) {
            match <[usize; LANES]>::try_from(some) {
                Ok(lanes) if key >= 2 => {
                    let found = quick_lanes(lanes.map(|i| e[i]), lanes.map(|i| r[i]), (key / 2) as u64, key % 2 == 1);
                    for (i, found) in lanes.into_iter().zip(found) {
                        out[i] = found.unwrap_or_else(|| careful(e[i], r[i], collisions[i]));
                    }
                }
                _ => some.iter().for_each(|&i| out[i] = eta(e[i], r[i], collisions[i])),
            }
        }
    }
}

fn ordinary(e: f64, r: f64) -> bool {
    (0.0..=1.0).contains(&e) && (SMALL..=LARGE).contains(&r)
}

/// `r^(1/collisions)`, nearly; and 1 and that in order.
#[inline(always)]
fn guessed(r: f64, collisions: u64) -> (f64, (f64, f64)) {
    let guess = if collisions == 1 { r } else { r.powf(1.0 / collisions as f64) };
    (guess, if guess >= 1.0 { (guess, 1.0) } else { (1.0, guess) })
}

/// The ends, where the bounds hold.
#[inline(always)]
fn ends(guess: f64, rho: f64, found: Pair<f64>) -> Option<(f64, f64)> {
    // Each comparison refuses NaN too.
    let holds = (SMALL..=LARGE).contains(&guess) && rho.abs() <= NEAR && (SMALL..=2.0).contains(&found.high);
    if !holds {
        return None;
    }
    let slack = found.high * SLACK;
    // Each end: a rounding of the inner difference (far below an ulp) and one of the outer, undone by a step.
    // Both are positive and normal, so a step is one unit of their bits.
    let lo = f64::from_bits((found.high + (found.low - slack)).to_bits() - 1);
    let hi = f64::from_bits((found.high + (found.low + slack)).to_bits() + 1);
    Some((lo, hi))
}

#[inline(always)]
fn quick(e: f64, r: f64, collisions: u64) -> Option<(f64, f64)> {
    if !ordinary(e, r) || collisions.wrapping_sub(1) >= MAX_COLLISIONS {
        return None;
    }
    let (guess, parts) = guessed(r, collisions);
    let (found, rho) = corrected(e, r, guess, parts, collisions, r > 1.0);
    ends(guess, rho, found)
}

/// [`quick`] for cells with as many collisions, at most [`SORTED`], and `r` on the same side of 1.
#[inline]
fn quick_lanes(e: [f64; LANES], r: [f64; LANES], collisions: u64, above: bool) -> [Option<(f64, f64)>; LANES] {
    let guesses = r.map(|r| guessed(r, collisions));
    let (guess, big, small) = (guesses.map(|g| g.0), guesses.map(|g| g.1.0), guesses.map(|g| g.1.1));
    let parts = (Lanes(big), Lanes(small));
    let (found, rho) = corrected(Lanes(e), Lanes(r), Lanes(guess), parts, collisions, above);
    std::array::from_fn(|i| {
        let pair = Pair { high: found.high.0[i], low: found.low.0[i] };
        if ordinary(e[i], r[i]) { ends(guess[i], rho.0[i], pair) } else { None }
    })
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

/// Encloses the product of two numbers from 0 to 1 that are given by their ends.
#[must_use]
#[inline]
pub fn times(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    (step_down(a.0 * b.0), step_up(a.1 * b.1))
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
