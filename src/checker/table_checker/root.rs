//! Roots: `t = r^(1/N)` for a positive rational `r`.
//!
//! Contract: [`enclosure`] holds `t`. Where the candidate ends come from does not matter: `lo <= t` is shown by
//! `lo^N <= r`, and `t <= hi` by `r <= hi^N`, with powers rounded against what is to be shown.

use super::dyadic::{Dyadic, Interval, Toward};
use super::failure::{Failure, declined};
use super::work::Work;
use num_bigint::{BigInt, BigUint};
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};
use std::cmp::Ordering;

/// How often a candidate that is too narrow is widened, sixteenfold each time.
const WIDENINGS: u32 = 4;

/// The root where it is rational. `p/q` in lowest terms is an `N`-th power of a rational iff `p` and `q` are `N`-th
/// powers; other than 0 and 1 these have more than `N` bits.
pub(crate) fn rational(r: &BigRational, count: &BigUint, work: &Work) -> Result<Option<BigRational>, Failure> {
    if r.is_one() || count.is_one() {
        return Ok(Some(r.clone()));
    }
    let (above, below) = (r.numer().magnitude(), r.denom().magnitude());
    let size = above.bits().max(below.bits());
    let Some(count) = count.to_u32().filter(|count| *count >= 1 && u64::from(*count) < size) else { return Ok(None) };
    // Steps of Newton's method, each with a power and a quotient, for either part; then the lowest terms.
    for _ in 0..2 * (size.ilog2() + 4) {
        work.quotient(size, size)?;
    }
    work.reduction(size / u64::from(count))?;
    let of = |x: &BigUint| Some(x.nth_root(count)).filter(|root| root.pow(count) == *x).map(BigInt::from);
    Ok(of(above).zip(of(below)).map(|(above, below)| BigRational::new(above, below)))
}

/// An interval with about `bits` bits that holds the root, for `r > 0` and `N >= 1`.
///
/// For `r < 1` the root is that of `1/r`, inverted. Else two candidates beside a guess are tried: `x ↦ x^N` rises, so
/// `lo^N <= r <= hi^N` shows `lo <= r^(1/N) <= hi`. The powers are cut upwards for `lo` and downwards for `hi`, the rational
/// `r` the other way about.
pub(crate) fn enclosure(r: &BigRational, count: &BigUint, bits: u64, work: &Work) -> Result<Interval, Failure> {
    work.quotient(bits, r.numer().bits().max(r.denom().bits()))?;
    if r.is_one() || count.is_one() {
        return Interval::ratio(r, bits);
    }
    if r.numer() < r.denom() {
        return Interval::point(Dyadic::one()).over(&enclosure(&r.recip(), count, bits, work)?, bits);
    }
    let wide = bits + 10;
    let r = Interval::ratio(r, wide)?;
    let guess = guess(&r.lo, count, bits, work)?.cut(bits, Toward::Down)?.widened(bits)?;
    for widening in 0..=WIDENINGS {
        let reach = BigUint::from(2u32) << (4 * widening);
        let (Some(lo), Some(hi)) = (guess.moved(&reach, Toward::Down), guess.moved(&reach, Toward::Up)) else { break };
        let below = lo.power(count, wide, Toward::Up, work)?.compare(&r.lo)? != Ordering::Greater;
        let above = hi.power(count, wide, Toward::Down, work)?.compare(&r.hi)? != Ordering::Less;
        if below && above {
            return Ok(Interval { lo, hi });
        }
    }
    declined("attempts at a root")
}

/// About the root of `r > 1`, by Newton's method; nothing rests on it.
///
/// It starts within `1/(4N)` of the root in proportion, and the error times `N` is squared by each step.
fn guess(r: &Dyadic, count: &BigUint, bits: u64, work: &Work) -> Result<Dyadic, Failure> {
    let size = count.bits();
    let near = r.compare(&Dyadic::new(BigUint::from(9u32), -3))? == Ordering::Less;
    let mut x = if near { Dyadic::one() } else { first(r, count, work)? };
    let number = Dyadic::new(count.clone(), 0);
    let rest = Dyadic::new(count - 1u32, 0);
    let mut gained = 2;
    while size + gained < bits + 3 {
        let wide = size + 2 * gained + 20;
        // Two quotients and a product.
        (0..3).try_for_each(|_| work.quotient(wide, wide))?;
        let quotient = r.over(&x.power(count, wide, Toward::Down, work)?, wide, Toward::Down)?;
        let sum = rest.plus(&quotient)?.cut(wide, Toward::Down)?;
        x = x.times(&sum, wide, Toward::Down)?.over(&number, wide, Toward::Down)?;
        gained *= 2;
    }
    Ok(x)
}

/// A start for [`guess`], for `r >= 9/8`: `1 + d`, the leading bits of `d` found one by one.
fn first(r: &Dyadic, count: &BigUint, work: &Work) -> Result<Dyadic, Failure> {
    let size = i64::try_from(count.bits()).unwrap_or(i64::MAX);
    let wide = count.bits() + 40;
    // Whether (1 + d)^N exceeds r; powers beyond r are not finished.
    let exceeds = |d: &Dyadic| -> Result<bool, Failure> {
        let base = d.plus(&Dyadic::one())?;
        let mut out = base.clone();
        for place in (0..count.bits().saturating_sub(1)).rev() {
            work.product(wide, wide)?;
            out = out.times(&out, wide, Toward::Down)?;
            if count.bit(place) {
                work.product(wide, wide)?;
                out = out.times(&base, wide, Toward::Down)?;
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
