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
//! **Numbers that are no doubles**, such as 9/10, enter as `TwoDoubles`: `e` within `4u²` and `r` within `2E`. Then `1 + e` is
//! rounded once, and is within `8u²`: the base stays within `2E`. `ρ` gains `2E + 2u²` and, being divided by `r`'s first
//! part, `2u·|ρ|`: that is at most `7E + 6u·|ρ|` in the correction. The product or quotient by `r` gains `2E`. In all less than
//! `32N·E + 32u·|ρ| + 22ρ²`, which is below `2^-80 + 2^-84 + 2^-67`: the same `SLACK` covers it.
//!
//! **Side by side.** Cells that take the same steps share instructions, eight at a time where the processor has registers
//! for four doubles and fused products (asked at run time). A fused product gives the error of a product as Dekker's
//! splitting does, exactly, and nothing else is fused: up to `SORTED` collisions, beyond which libm guesses, every machine
//! gives the same ends.

mod cells;
mod grid;
mod guess;
mod lanes;
mod two_doubles;

use super::{Positive, Restitution, Restitutions, transfer};
pub use cells::etas;
pub(super) use cells::etas_of_two;
pub use grid::{Factors, grid, times};
use lanes::{Lanes, Pair};
use malachite::Rational;
pub(super) use two_doubles::{TwoDoubles, decimal_of};

/// The most collisions that are computed in double-double; more go to intervals.
pub const MAX_COLLISIONS: u64 = 1 << 16;

/// Collisions up to which cells are put in order by their number; more are rare, and costly one by one too.
const SORTED: u64 = 128;

/// A bound of all relative errors of the middle; see the module.
const SLACK: f64 = f64::from_bits((1023 - 64) << 52);

/// The largest `|ρ|` for which the bounds are stated.
const NEAR: f64 = f64::from_bits((1023 - 36) << 52);

/// `2^400` and `2^-400`.
const LARGE: f64 = f64::from_bits((1023 + 400) << 52);
const SMALL: f64 = f64::from_bits((1023 - 400) << 52);

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
/// let (lo, hi) = carom_physics::chain::fast::eta(0.9, 10.0, 8);
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

/// Whether the bounds are stated for such inputs, of `e` both parts.
#[inline]
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

#[cfg(test)]
mod tests {
    use super::{MAX_COLLISIONS, quick};
    use proptest::prelude::*;

    /// Ordinary restitutions and ratios, the latter evenly in their logarithm.
    fn ordinary_cells() -> impl Strategy<Value = (f64, f64)> {
        (0.0..=1.0_f64, -399.9..399.9_f64).prop_map(|(e, power)| (e, power.exp2()))
    }

    proptest! {
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
}
