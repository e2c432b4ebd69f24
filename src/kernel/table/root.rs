//! Roots: `t = r^(1/N)` for a positive rational `r`.
//!
//! Contract: [`enclosure`] holds `t`. Where the candidate ends come from does not matter: `lo <= t` is shown by
//! `lo^N <= r`, and `t <= hi` by `r <= hi^N`, with powers rounded against what is to be shown.

use super::super::{Failure, declined};
use super::dyadic::{Dyadic, Interval, Toward};
use num_bigint::{BigInt, BigUint};
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};
use std::cmp::Ordering;

/// How often a candidate that is too narrow is widened, sixteenfold each time.
const WIDENINGS: u32 = 4;

/// The root where it is rational. `p/q` in lowest terms is an `N`-th power of a rational iff `p` and `q` are `N`-th
/// powers; other than 0 and 1 these have more than `N` bits.
pub fn rational(r: &BigRational, count: &BigUint) -> Option<BigRational> {
    if r.is_one() || count.is_one() {
        return Some(r.clone());
    }
    let (above, below) = (r.numer().magnitude(), r.denom().magnitude());
    let count = count.to_u32().filter(|count| *count >= 1 && u64::from(*count) < above.bits().max(below.bits()))?;
    let of = |x: &BigUint| Some(x.nth_root(count)).filter(|root| root.pow(count) == *x).map(BigInt::from);
    Some(BigRational::new(of(above)?, of(below)?))
}

/// An interval with about `bits` bits that holds the root, for `r > 0` and `N >= 1`.
///
/// For `r < 1` the root is that of `1/r`, inverted. Else two candidates beside a guess are tried: `x ↦ x^N` rises, so
/// `lo^N <= r <= hi^N` shows `lo <= r^(1/N) <= hi`. The powers are cut upwards for `lo` and downwards for `hi`, the rational
/// `r` the other way about.
pub fn enclosure(r: &BigRational, count: &BigUint, bits: u64) -> Result<Interval, Failure> {
    if r.is_one() || count.is_one() {
        return Interval::ratio(r, bits);
    }
    if r.numer() < r.denom() {
        return Interval::point(Dyadic::one()).over(&enclosure(&r.recip(), count, bits)?, bits);
    }
    let work = bits + 10;
    let r = Interval::ratio(r, work)?;
    let guess = guess(&r.lo, count, bits)?.cut(bits, Toward::Down)?.widened(bits)?;
    for widening in 0..=WIDENINGS {
        let reach = BigUint::from(2u32) << (4 * widening);
        let (Some(lo), Some(hi)) = (guess.moved(&reach, Toward::Down), guess.moved(&reach, Toward::Up)) else { break };
        let below = lo.power(count, work, Toward::Up)?.compare(&r.lo)? != Ordering::Greater;
        let above = hi.power(count, work, Toward::Down)?.compare(&r.hi)? != Ordering::Less;
        if below && above {
            return Ok(Interval { lo, hi });
        }
    }
    declined("attempts at a root")
}

/// About the root of `r > 1`, by Newton's method; nothing rests on it.
///
/// It starts within `1/(4N)` of the root in proportion, and the error times `N` is squared by each step.
fn guess(r: &Dyadic, count: &BigUint, bits: u64) -> Result<Dyadic, Failure> {
    let size = count.bits();
    let near = r.compare(&Dyadic::new(BigUint::from(9u32), -3))? == Ordering::Less;
    let mut x = if near { Dyadic::one() } else { first(r, count)? };
    let number = Dyadic::new(count.clone(), 0);
    let rest = Dyadic::new(count - 1u32, 0);
    let mut gained = 2;
    while size + gained < bits + 3 {
        let work = size + 2 * gained + 20;
        let quotient = r.over(&x.power(count, work, Toward::Down)?, work, Toward::Down)?;
        let sum = rest.plus(&quotient)?.cut(work, Toward::Down)?;
        x = x.times(&sum, work, Toward::Down)?.over(&number, work, Toward::Down)?;
        gained *= 2;
    }
    Ok(x)
}

/// A start for [`guess`], for `r >= 9/8`: `1 + d`, the leading bits of `d` found one by one.
fn first(r: &Dyadic, count: &BigUint) -> Result<Dyadic, Failure> {
    let size = i64::try_from(count.bits()).unwrap_or(i64::MAX);
    let work = count.bits() + 40;
    // Whether (1 + d)^N exceeds r; powers beyond r are not finished.
    let exceeds = |d: &Dyadic| -> Result<bool, Failure> {
        let base = d.plus(&Dyadic::one())?;
        let mut out = base.clone();
        for place in (0..count.bits().saturating_sub(1)).rev() {
            out = out.times(&out, work, Toward::Down)?;
            if count.bit(place) {
                out = out.times(&base, work, Toward::Down)?;
            }
            if out.top() > r.top() + 1 {
                return Ok(true);
            }
        }
        Ok(out.compare(r)? == Ordering::Greater)
    };
    let unit = |k: i64| Dyadic::new(BigUint::one(), k);
    // (1 + 2^low)^N < 9/8 <= r < 1 + 2^high.
    let (mut low, mut high) = (-size - 5, r.top() + 1);
    while low + 1 < high {
        let middle = low + (high - low) / 2;
        if exceeds(&unit(middle))? {
            high = middle;
        } else {
            low = middle;
        }
    }
    let mut d = unit(low);
    for step in 1..=(low.min(0) + size + 3).max(0) {
        let next = d.plus(&unit(low - step))?;
        if !exceeds(&next)? {
            d = next;
        }
    }
    d.plus(&Dyadic::one())
}
