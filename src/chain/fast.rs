//! eta as a pair of doubles that enclose it, for many cells: no allocation, no big numbers.
//!
//! **Contract.** For doubles taken as exact numbers, [`eta`] gives `(lo, hi)` with `lo <= eta <= hi`. In the
//! ordinary range (`r` from 2^-400 to 2^400, `N <= `[`MAX_COLLISIONS`], eta above 2^-400) the relative width is at most
//! 2^-50; elsewhere the enclosure comes from intervals, and for arguments that are no chain it is NaN.
//!
//! **Method.** A guess `t` of `r^(1/N)`; `ρ = t^N/r − 1` in double-double; then
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
//!
//! **Numbers that are no doubles**, such as 9/10, enter as [`TwoDoubles`]: `e` within `4u²` and `r` within `2E`. Then `1 + e` is
//! rounded once, and is within `8u²`: the base stays within `2E`. `ρ` gains `2E + 2u²` and, being divided by `r`'s first
//! part, `2u·|ρ|`: that is at most `7E + 6u·|ρ|` in the correction. The product or quotient by `r` gains `2E`. In all less than
//! `32N·E + 32u·|ρ| + 22ρ²`, which is below `2^-80 + 2^-84 + 2^-67`: the same `SLACK` covers it.
//!
//! **Side by side.** Cells that take the same steps share instructions, eight at a time where the processor has registers
//! for four doubles and fused products (asked at run time). A fused product gives the error of a product as Dekker's
//! splitting does, exactly, and nothing else is fused: up to `SORTED` collisions, beyond which libm guesses, every machine
//! gives the same ends.

use super::{Positive, Restitution, Restitutions, transfer};
use crate::number::rational;
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
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

/// A double of each of `N` cells, computed side by side: what one waits for fills the time of another, and some share an
/// instruction. `FUSED` where the processor multiplies and adds in one: otherwise that would be slow. Both give the same.
#[derive(Clone, Copy)]
struct Lanes<const N: usize, const FUSED: bool>([f64; N]);

impl<const N: usize, const FUSED: bool> Lanes<N, FUSED> {
    #[inline(always)]
    fn map(self, with: impl Fn(f64) -> f64) -> Self {
        Lanes(self.0.map(with))
    }

    #[inline(always)]
    fn each(mut self, other: Self, with: impl Fn(f64, f64) -> f64) -> Self {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a = with(*a, b);
        }
        self
    }

    /// `self = high + low` with 26 bits each (Veltkamp).
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        let c = Lanes::from(134_217_729.0) * self;
        let high = c - (c - self);
        (high, self - high)
    }

    /// `self·b` exactly.
    #[inline(always)]
    fn product(self, b: Self) -> Pair<N, FUSED> {
        let p = self * b;
        let low = if FUSED {
            Lanes(std::array::from_fn(|i| self.0[i].mul_add(b.0[i], -p.0[i])))
        } else {
            // Dekker.
            let ((ah, al), (bh, bl)) = (self.split(), b.split());
            ((ah * bh - p) + ah * bl + al * bh) + al * bl
        };
        Pair { high: p, low }
    }

    /// `self + b = s + error` for `|self| >= |b|` (Dekker).
    #[inline(always)]
    fn fast_sum(self, b: Self) -> Pair<N, FUSED> {
        let s = self + b;
        Pair { high: s, low: b - (s - self) }
    }

    /// `self^(1/collisions)`, nearly, for positive doubles that are not subnormal.
    #[inline(always)]
    fn guessed_root(self, collisions: u64) -> Self {
        match collisions {
            1 => self,
            2..=SORTED => (self.guessed_log2() * Lanes::from(1.0 / collisions as f64)).guessed_exp2(),
            // Here ρ = N·(the relative error) leaves less room.
            _ => self.map(|r| r.powf(1.0 / collisions as f64)),
        }
    }

    /// The logarithm to base 2 within `2^-41`, as `r = 2^k·m`, `m` between `√½` and `√2`, and
    /// `ln m = 2·(s + s³/3 + s⁵/5 + …)`, `s = (m − 1)/(m + 1)`, where `s² < 0.03`.
    #[inline(always)]
    fn guessed_log2(self) -> Self {
        const fn term(j: u32) -> f64 {
            2.0 / ((2 * j + 1) as f64 * std::f64::consts::LN_2)
        }
        let low = std::f64::consts::FRAC_1_SQRT_2.to_bits();
        let scaled = self.0.map(|r| r.to_bits().wrapping_sub(low).wrapping_add(1023 << 52));
        let k = Lanes(scaled.map(|bits| f64::from_bits(bits >> 52 | WHOLE.to_bits()) - (WHOLE + 1023.0)));
        let m = Lanes(scaled.map(|bits| f64::from_bits((bits & ((1 << 52) - 1)) + low)));
        let s = (m - Lanes::from(1.0)) / (m + Lanes::from(1.0));
        let q = s * s;
        k + s
            * (q.cubic(const { [term(0), term(1), term(2), term(3)] })
                + (q * q) * (q * q) * q.cubic(const { [term(4), term(5), term(6), term(7)] }))
    }

    /// 2 to the power of this within a factor of `1 ± 2^-46`, for exponents that a double has: `2^(k + f) = 2^k·e^(f·ln 2)`
    /// with `|f| <= 1/2`, and the first twelve terms of the series of `e^z`, `|z| < 0.35`.
    #[inline(always)]
    fn guessed_exp2(self) -> Self {
        const fn term(j: u32) -> f64 {
            if j == 0 { 1.0 } else { term(j - 1) * std::f64::consts::LN_2 / j as f64 }
        }
        // The sum's last bits are the nearest whole number.
        let shifted = self + Lanes::from(1.5 * WHOLE);
        let f = self - (shifted - Lanes::from(1.5 * WHOLE));
        let fourth = (f * f) * (f * f);
        let power = f.cubic(const { [term(0), term(1), term(2), term(3)] })
            + fourth
                * (f.cubic(const { [term(4), term(5), term(6), term(7)] })
                    + fourth * f.cubic(const { [term(8), term(9), term(10), term(11)] }));
        Lanes(std::array::from_fn(|i| f64::from_bits(power.0[i].to_bits().wrapping_add(shifted.0[i].to_bits() << 52))))
    }

    /// `a + b·x + c·x² + d·x³`.
    #[inline(always)]
    fn cubic(self, [a, b, c, d]: [f64; 4]) -> Self {
        (Lanes::from(a) + Lanes::from(b) * self) + (self * self) * (Lanes::from(c) + Lanes::from(d) * self)
    }
}

/// `2^52`: doubles from here to its double are whole, and end with their bits.
const WHOLE: f64 = f64::from_bits((1023 + 52) << 52);

impl<const N: usize, const FUSED: bool> From<f64> for Lanes<N, FUSED> {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Lanes([x; N])
    }
}

impl<const N: usize, const FUSED: bool> Add for Lanes<N, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.each(other, |a, b| a + b)
    }
}

impl<const N: usize, const FUSED: bool> Sub for Lanes<N, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.each(other, |a, b| a - b)
    }
}

impl<const N: usize, const FUSED: bool> Mul for Lanes<N, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.each(other, |a, b| a * b)
    }
}

impl<const N: usize, const FUSED: bool> Div for Lanes<N, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.each(other, |a, b| a / b)
    }
}

/// `high + low`, not evaluated.
#[derive(Clone, Copy)]
struct Pair<const N: usize, const FUSED: bool> {
    high: Lanes<N, FUSED>,
    low: Lanes<N, FUSED>,
}

impl<const N: usize, const FUSED: bool> Pair<N, FUSED> {
    #[inline(always)]
    fn exact(x: Lanes<N, FUSED>) -> Self {
        Pair { high: x, low: Lanes::from(0.0) }
    }

    #[inline(always)]
    fn square(self) -> Self {
        let p = self.high.product(self.high);
        p.high.fast_sum(p.low + Lanes::from(2.0) * (self.high * self.low))
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        let p = self.high.product(other.high);
        p.high.fast_sum(p.low + (self.high * other.low + self.low * other.high))
    }

    #[inline(always)]
    fn times_double(self, other: Lanes<N, FUSED>) -> Self {
        let p = self.high.product(other);
        p.high.fast_sum(p.low + self.low * other)
    }

    #[inline(always)]
    fn over(self, other: Self) -> Self {
        let q = self.high / other.high;
        let p = q.product(other.high);
        // self.high − p.high is exact: the two agree to a few ulps.
        let rest = ((self.high - p.high) - p.low) + (self.low - q * other.low);
        q.fast_sum(rest / other.high)
    }

    /// Two powers with the same exponent, at least 1; side by side they keep the processor busy.
    #[inline(always)]
    fn powers(a: Self, b: Self, exponent: u64) -> (Self, Self) {
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
}

/// eta in double-double for cells with as many collisions, at least 1, and `ρ`, from a guess of the root; `above` says
/// `r > 1`. The second parts of `e` and `r` count where it is `TWO`.
#[inline(always)]
fn corrected<const N: usize, const FUSED: bool, const TWO: bool>(
    e: Pair<N, FUSED>,
    r: Pair<N, FUSED>,
    guess: Lanes<N, FUSED>,
    collisions: u64,
    above: bool,
) -> (Pair<N, FUSED>, Lanes<N, FUSED>) {
    let one = Lanes::from(1.0);
    // The larger one first.
    let sum = guess.each(one, f64::max).fast_sum(guess.each(one, f64::min));
    let mut up = one.fast_sum(e.high);
    if TWO {
        up = up.high.fast_sum(up.low + e.low);
    }
    // For r > 1 as (q·t)^(2N)/r, so that nothing overflows on the way.
    let base = if above { up.times_double(guess) } else { up }.over(sum);
    let (power, root) = Pair::powers(Pair::exact(guess), base, collisions);
    // The difference is exact where the power is near r, and where it is not, ρ is refused.
    let rest = if TWO { power.low - r.low } else { power.low };
    let rho = ((power.high - r.high) + rest) / r.high;
    let square = root.square();
    let (found, correction) = if above {
        (square.over(if TWO { r } else { Pair::exact(r.high) }), Lanes::from(-2.0) * rho / sum.high)
    } else {
        (if TWO { square.times(r) } else { square.times_double(r.high) }, Lanes::from(2.0) * rho * (guess / sum.high))
    };
    (found.high.fast_sum(found.low + found.high * correction), rho)
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
    let found = match collisions {
        1..=MAX_COLLISIONS => quick::<1, false, false>([[e], [0.0]], [[r], [0.0]], collisions, r > 1.0)[0],
        _ => None,
    };
    found.unwrap_or_else(|| careful(e, r, collisions))
}

/// [`eta`] for slices of equal length; of slices of unequal length the shortest one counts.
///
/// The cells of a block with as many collisions and `r` on the same side of 1 follow the same steps: they are taken
/// some at a time. Each gets exactly what [`eta`] gives it.
pub fn etas(e: &[f64], r: &[f64], collisions: &[u64], out: &mut [(f64, f64)]) {
    let zero: &[f64] = &[];
    side_by_side::<false>(&Cells { e: [e, zero], r: [r, zero], collisions }, out);
}

/// The same for numbers that need not be doubles: each of `e` and `r` as the slices of the first and of the second parts of
/// its [`TwoDoubles`].
///
/// `(NaN, NaN)` where words do not suffice, and for what is no chain: the caller tells the two apart.
pub fn etas_of_two(e: [&[f64]; 2], r: [&[f64]; 2], collisions: &[u64], out: &mut [(f64, f64)]) {
    side_by_side::<true>(&Cells { e, r, collisions }, out);
}

/// The inputs of many cells; the second parts are read where it is `TWO`.
struct Cells<'a> {
    e: [&'a [f64]; 2],
    r: [&'a [f64]; 2],
    collisions: &'a [u64],
}

fn side_by_side<const TWO: bool>(cells: &Cells<'_>, out: &mut [(f64, f64)]) {
    #[cfg(target_arch = "x86_64")]
    if let pulp::Arch::V3(wide) = pulp::Arch::new() {
        return pulp::Simd::vectorize(wide, Wide::<TWO> { cells, out });
    }
    blocks::<4, false, TWO>(cells, out);
}

/// [`side_by_side`] for processors with fused products and registers for four doubles: compiled for those, where it is called.
#[cfg(target_arch = "x86_64")]
struct Wide<'a, const TWO: bool> {
    cells: &'a Cells<'a>,
    out: &'a mut [(f64, f64)],
}

#[cfg(target_arch = "x86_64")]
impl<const TWO: bool> pulp::NullaryFnOnce for Wide<'_, TWO> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        blocks::<8, true, TWO>(self.cells, self.out);
    }
}

#[inline(always)]
fn blocks<const N: usize, const FUSED: bool, const TWO: bool>(cells: &Cells<'_>, out: &mut [(f64, f64)]) {
    let Cells { e, r, collisions } = cells;
    let mut count = e[0].len().min(r[0].len()).min(collisions.len()).min(out.len());
    if TWO {
        count = count.min(e[1].len()).min(r[1].len());
    }
    for (k, out) in out[..count].chunks_mut(BLOCK).enumerate() {
        let some = k * BLOCK..k * BLOCK + out.len();
        block::<N, FUSED, TWO>(
            &Cells {
                e: [&e[0][some.clone()], if TWO { &e[1][some.clone()] } else { &[] }],
                r: [&r[0][some.clone()], if TWO { &r[1][some.clone()] } else { &[] }],
                collisions: &collisions[some],
            },
            out,
        );
    }
}

/// Cells that are put in order at a time.
const BLOCK: usize = 2048;

/// Collisions up to which cells are put in order by their number; more are rare, and costly one by one too.
const SORTED: u64 = 128;

/// [`side_by_side`] for at most [`BLOCK`] cells, as many of each input as there is room for answers.
#[inline(always)]
fn block<const N: usize, const FUSED: bool, const TWO: bool>(cells: &Cells<'_>, out: &mut [(f64, f64)]) {
    let Cells { e, r, collisions } = cells;
    let count = out.len();
    let second = |x: [&[f64]; 2], i: usize| if TWO { x[1][i] } else { 0.0 };
    // A key is twice the number of collisions, and one more where r > 1; 0 for what is not sorted.
    let key = |i: usize| match collisions[i] {
        n @ ..=SORTED => 2 * n as usize + usize::from(r[0][i] > 1.0),
        _ => 0,
    };
    // Counting sort: where the cells of each key begin, then their numbers in that order.
    let mut ends = [0_usize; 2 * SORTED as usize + 2];
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
        if key < 2 {
            for &i in same {
                let (e, r) = ([[e[0][i]], [second(*e, i)]], [[r[0][i]], [second(*r, i)]]);
                let found = match collisions[i] {
                    n @ 1..=MAX_COLLISIONS => quick::<1, false, TWO>(e, r, n, r[0][0] > 1.0)[0],
                    _ => None,
                };
                out[i] = found.unwrap_or_else(|| dearer::<TWO>(e[0][0], r[0][0], collisions[i]));
            }
            continue;
        }
        for some in same.chunks(N) {
            // The last ones are filled up with a cell among them.
            let lanes: [usize; N] = std::array::from_fn(|k| *some.get(k).unwrap_or(&some[0]));
            let (count, above) = ((key / 2) as u64, key % 2 == 1);
            let both = |x: [&[f64]; 2]| [lanes.map(|i| x[0][i]), lanes.map(|i| second(x, i))];
            let found = quick::<N, FUSED, TWO>(both(*e), both(*r), count, above);
            for (&i, found) in some.iter().zip(found) {
                out[i] = found.unwrap_or_else(|| dearer::<TWO>(e[0][i], r[0][i], collisions[i]));
            }
        }
    }
}

/// A cell for which words do not suffice.
#[inline(always)]
fn dearer<const TWO: bool>(e: f64, r: f64, collisions: u64) -> (f64, f64) {
    if TWO { (f64::NAN, f64::NAN) } else { careful(e, r, collisions) }
}

/// Whether the bounds are stated for such inputs, of `e` both parts.
fn ordinary(e: (f64, f64), r: f64) -> bool {
    (0.0..=1.0).contains(&e.0) && !(e.0 == 1.0 && e.1 > 0.0) && (SMALL..=LARGE).contains(&r)
}

/// The ends, where the bounds hold.
#[inline(always)]
fn ends(guess: f64, rho: f64, high: f64, low: f64) -> Option<(f64, f64)> {
    // Each comparison refuses NaN too.
    let holds = (SMALL..=LARGE).contains(&guess) && rho.abs() <= NEAR && (SMALL..=2.0).contains(&high);
    if !holds {
        return None;
    }
    let slack = high * SLACK;
    // Each end: a rounding of the inner difference (far below an ulp) and one of the outer, undone by a step.
    // Both are positive and normal, so a step is one unit of their bits.
    let lo = f64::from_bits((high + (low - slack)).to_bits() - 1);
    let hi = f64::from_bits((high + (low + slack)).to_bits() + 1);
    Some((lo, hi))
}

/// The ends for cells with as many collisions, at least 1, and `r` on the same side of 1, where words suffice: `e` and `r` by
/// their first and second parts.
#[inline(always)]
fn quick<const N: usize, const FUSED: bool, const TWO: bool>(
    e: [[f64; N]; 2],
    r: [[f64; N]; 2],
    collisions: u64,
    above: bool,
) -> [Option<(f64, f64)>; N] {
    let lanes = Lanes::<N, FUSED>;
    let pair = |x: [[f64; N]; 2]| Pair { high: lanes(x[0]), low: lanes(x[1]) };
    let guess = lanes(r[0]).guessed_root(collisions);
    let (Pair { high, low }, rho) = corrected::<N, FUSED, TWO>(pair(e), pair(r), guess, collisions, above);
    std::array::from_fn(|i| {
        if ordinary((e[0][i], e[1][i]), r[0][i]) { ends(guess.0[i], rho.0[i], high.0[i], low.0[i]) } else { None }
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

/// A number as the sum of two doubles, the second at most half a unit in the last place of the first.
///
/// **Contract.** The sum is within `4u²` of the number, relatively, or NaN where that cannot be promised; a quotient is
/// within `2E`. So `9/10` and `10/3` enter [`etas_of_two`] as well as doubles do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoDoubles {
    /// The nearest double, or next to it in a quotient.
    pub high: f64,
    /// What is left.
    pub low: f64,
}

impl TwoDoubles {
    /// Nothing is promised.
    const UNKNOWN: TwoDoubles = TwoDoubles { high: f64::NAN, low: 0.0 };

    /// A double.
    #[must_use]
    pub fn exact(x: f64) -> TwoDoubles {
        TwoDoubles { high: x, low: 0.0 }
    }

    /// A whole number.
    #[must_use]
    pub fn of_integer(x: i64) -> TwoDoubles {
        let high = x as f64;
        // At most 2^9 in size.
        TwoDoubles { high, low: (i128::from(x) - high as i128) as f64 }
    }

    /// A rational: the nearest double, and the double nearest to the rest.
    #[must_use]
    pub fn of_rational(x: &Rational) -> TwoDoubles {
        let nearest = |x: &Rational| f64::rounding_from(x, RoundingMode::Nearest).0;
        let high = nearest(x);
        if *x == Rational::ZERO {
            return TwoDoubles::exact(0.0);
        }
        match Rational::try_from(high) {
            // Far from where doubles lose bits.
            Ok(exact) if (SMALL..=LARGE).contains(&high.abs()) => TwoDoubles { high, low: nearest(&(x - exact)) },
            _ => TwoDoubles::UNKNOWN,
        }
    }

    /// The shortest decimal that this double is printed as: nine tenths for `0.9`.
    ///
    /// **Why.** Two decimals of at most 15 digits never share their nearest double. So if `x·10^k` rounds to a whole `p` below
    /// `10^15` with `p/10^k` rounding to `x`, then `p/10^k` is the shortest one. The rest `(p − x·10^k)/10^k` follows from the exact
    /// product, with two roundings.
    #[must_use]
    pub fn of_decimal(x: f64) -> TwoDoubles {
        const MOST: f64 = 1e15;
        let mut scale = 1.0;
        for _ in 0..=15 {
            let whole = (x * scale).round_ties_even();
            if whole.abs() >= MOST {
                break;
            }
            if whole / scale == x {
                let Pair { high, low } = Lanes::<1, false>([x]).product(Lanes([scale]));
                return TwoDoubles { high: x, low: ((whole - high.0[0]) - low.0[0]) / scale };
            }
            scale *= 10.0;
        }
        decimal_of(x).map_or(TwoDoubles::UNKNOWN, |x| TwoDoubles::of_rational(&x))
    }

    /// The quotient, within `2E` for operands within `4u²`.
    #[must_use]
    #[inline]
    pub fn over(self, other: TwoDoubles) -> TwoDoubles {
        let pair = |x: TwoDoubles| Pair::<1, false> { high: Lanes([x.high]), low: Lanes([x.low]) };
        // Then no product on the way is so small or so large that its error is not a double.
        if [self, other].iter().all(|x| (SMALL..=LARGE).contains(&x.high)) {
            let found = pair(self).over(pair(other));
            return TwoDoubles { high: found.high.0[0], low: found.low.0[0] };
        }
        TwoDoubles::UNKNOWN
    }
}

/// The shortest decimal that a double is printed as, exactly; `None` where it is not finite.
#[must_use]
pub fn decimal_of(x: f64) -> Option<Rational> {
    if x.is_finite() { rational::parse(&format!("{x:e}")).ok() } else { None }
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Ordinary restitutions and ratios, the latter evenly in their logarithm.
    fn ordinary_cells() -> impl Strategy<Value = (f64, f64)> {
        (0.0..=1.0_f64, -399.9..399.9_f64).prop_map(|(e, power)| (e, power.exp2()))
    }

    proptest! {
        #[test]
        fn guesses_are_near(power in -1000.0..1000.0_f64, small in -1.0..1.0_f64) {
            let of = |x: f64| Lanes::<1, false>([x]);
            for power in [power, small, small * 1e-9] {
                let r = power.exp2();
                prop_assert!((of(r).guessed_log2().0[0] - r.log2()).abs() <= 2f64.powi(-41));
                prop_assert!((of(power).guessed_exp2().0[0] / r - 1.0).abs() <= 2f64.powi(-46));
            }
        }

        /// No ordinary cell whose eta is not tiny needs intervals; and fused products, and cells beside one, change nothing.
        #[test]
        fn words_suffice_and_all_ways_agree((e, r) in ordinary_cells(), beside in ordinary_cells(), lows in (-1e-17..=1e-17_f64, -1e-17..=1e-17_f64), n in prop_oneof![1..=130_u64, 1..=MAX_COLLISIONS]) {
            let above = r > 1.0;
            let zero = [0.0; 8];
            let alone = quick::<1, false, false>([[e], [0.0]], [[r], [0.0]], n, above)[0];
            // eta is ((1 + e)/2)^(2N) times a factor that grows with N from 4r/(1 + r)², which exceeds r or 1/r.
            if 2.0 * n as f64 * (0.5 + e / 2.0).log2() - r.log2().abs() > -399.0 {
                prop_assert!(alone.is_some());
            }
            let (mut es, mut rs) = ([beside.0; 8], [beside.1; 8]);
            (es[3], rs[3]) = (e, r);
            prop_assert_eq!(quick::<8, true, false>([es, zero], [rs, zero], n, above)[3], alone);
            prop_assert_eq!(quick::<8, false, false>([es, zero], [rs, zero], n, above)[3], alone);
            let [mut low_e, mut low_r] = [zero, zero];
            (low_e[3], low_r[3]) = (e * lows.0, r * lows.1);
            let two = quick::<1, false, true>([[e], [low_e[3]]], [[r], [low_r[3]]], n, above)[0];
            prop_assert_eq!(quick::<8, true, true>([es, low_e], [rs, low_r], n, above)[3], two);
        }
    }
    proptest! {
        #[test]
        fn a_decimal_is_the_one_that_is_printed(bits in any::<u64>(), whole in 0..10_000_000_u32, places in 0..9_u32) {
            let short = f64::from(whole) / 10_f64.powi(places as i32);
            for x in [short, f64::from_bits(bits)] {
                let Some(exact) = decimal_of(x) else { continue };
                let found = TwoDoubles::of_decimal(x);
                if exact == Rational::ZERO {
                    prop_assert_eq!((found.high, found.low), (0.0, 0.0));
                } else if !found.high.is_nan() {
                    let double = |x: f64| Rational::try_from(x).expect("finite");
                    let rest = double(found.high) + double(found.low) - &exact;
                    let relative = f64::rounding_from(&(rest / exact), RoundingMode::Nearest).0;
                    prop_assert!(relative.abs() <= 4.0 * 2f64.powi(-106), "{}: {}", x, relative);
                } else {
                    prop_assert!(!(SMALL..=LARGE).contains(&x.abs()), "{}", x);
                }
            }
        }
    }
}
