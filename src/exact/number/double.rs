//! Double-double numbers that carry a rigorous error bound: the cheapest level of certified answers.
//!
//! **Contract.** A [`Double`] stands for every real `v` with `|v − (hi + lo)| <= radius`. Each
//! operation contains what the exact operation gives on all elements of its operands. Where that
//! cannot be promised (overflow, results near the end of the range of doubles) the radius is
//! infinite, and [`Double::ends`] answers `None`: the caller then climbs to a dearer level.
//!
//! **Why the bounds hold.** `u = 2^-53`; every double operation is rounded to nearest (IEEE 754), so
//! `fl(x∘y) = (x∘y)(1+δ)`, `|δ| <= u`, as long as nothing overflows or underflows. `two_sum` and
//! `two_product` are error-free (Knuth; Dekker). A pair is normalised: `|lo| <= u·|hi|`.
//! - *Sum.* `hi`s and `lo`s are added without error; two roundings follow, of sizes at most
//!   `u·(2u + O(u²))·S` and `u·(2u + O(u²))·S`, `S = |a.hi| + |b.hi|`: together below `2^-103·S`.
//! - *Product.* Dropped `a.lo·b.lo`: `u²`. Roundings of the two mixed products: `u²` each; of their
//!   sum: `2u²(1+u)`; of its sum with the error of the leading product: `3u²(1+2u)`. In all less
//!   than `9u²·|a.hi·b.hi|`, charged as `16u² = 2^-102`.
//! - *Quotient.* Two steps of long division; the remainder that is left is computed with its own
//!   bound and divided by the least divisor: nothing is assumed about the quotient.
//! - *Underflow.* A product of small parts may lose up to `2^-1074` several times; with every
//!   non-zero result kept in `[2^-480, 2^480]`, the addition of `TINY` covers it.
//! - Radii are computed in doubles and enlarged by `1 + 2^-49`, more than the at most six roundings
//!   and the factor `1 + u` between `|hi|` and `|hi + lo|` can take away.
//!
//! **Cost.** 10 to 40 double operations each; no allocation, no libm except for guesses.

use super::interval::Interval;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::rounding_modes::RoundingMode;
use malachite::{Natural, Rational};

/// The double next to a rational number; infinite where it is too large.
#[must_use]
pub fn nearest(q: &Rational) -> f64 {
    f64::rounding_from(q, RoundingMode::Nearest).0
}

/// Relative error charged for a product, relative to the larger operand for a sum: `2^-102`.
const UNIT: f64 = f64::from_bits((1023 - 102) << 52);
/// `2^-900`: covers every loss to underflow of one operation.
const TINY: f64 = f64::from_bits((1023 - 900) << 52);
/// `1 + 2^-49`: covers the roundings of a radius.
const ROUND_UP: f64 = 1.0 + 16.0 * f64::EPSILON / 2.0;
/// Terms of the series of `artanh`, and a bound of what is left of it: `2·25^-24/49 < 2^-115`.
const TERMS: u32 = 24;
const REST: f64 = f64::from_bits((1023 - 115) << 52);
/// `2^480` and its reciprocal: the range in which results are certified.
pub const LARGEST: f64 = f64::from_bits((1023 + 480) << 52);
const SMALLEST: f64 = f64::from_bits((1023 - 480) << 52);

/// All reals within `radius` of `hi + lo`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Double {
    hi: f64,
    lo: f64,
    radius: f64,
}

/// `a + b = s + error`, exactly, barring overflow (Knuth).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let a_part = s - b;
    let b_part = s - a_part;
    (s, (a - a_part) + (b - b_part))
}

/// `a + b = s + error`, exactly, for `|a| >= |b|` (Dekker).
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// `a = high + low` with 26 bits each (Veltkamp), for `|a| < 2^990`.
fn split(a: f64) -> (f64, f64) {
    let c = 134_217_729.0 * a;
    let high = c - (c - a);
    (high, a - high)
}

/// `a·b = p + error`, exactly, for `2^-960 < |a·b|` and both below `2^480` in size (Dekker).
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    if cfg!(target_feature = "fma") {
        return (p, a.mul_add(b, -p));
    }
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    let error = ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (p, error)
}

impl Double {
    /// A double, exactly; not certified where it is not finite or out of range.
    #[must_use]
    pub fn exact(x: f64) -> Self {
        Self::guarded(x, 0.0, 0.0)
    }

    /// The number whose radius says that nothing is known.
    const UNKNOWN: Self = Self { hi: 0.0, lo: 0.0, radius: f64::INFINITY };

    /// Keeps results in the range in which the bounds are proved.
    fn guarded(hi: f64, lo: f64, radius: f64) -> Self {
        let size = hi.abs();
        // Written so that NaN fails it.
        let certified = (hi == 0.0 || (SMALLEST..=LARGEST).contains(&size)) && radius < LARGEST;
        if certified { Self { hi, lo, radius } } else { Self::UNKNOWN }
    }

    /// The doubles next to a rational.
    #[must_use]
    pub fn from_rational(x: &Rational) -> Self {
        let hi = nearest(x);
        if !hi.is_finite() {
            return Self::UNKNOWN;
        }
        let Ok(hi_exact) = Rational::try_from(hi) else {
            return Self::UNKNOWN;
        };
        let rest = x - hi_exact;
        if rest == Rational::ZERO {
            return Self::exact(hi);
        }
        let lo = nearest(&rest);
        // |rest − lo| <= u·|rest| <= u²·|hi|, or half the least double.
        Self::guarded(hi, lo, hi.abs() * UNIT + TINY)
    }

    /// A double below every element and one above, each within the radius and one rounding; `None`
    /// where nothing is certified.
    #[must_use]
    pub fn ends(self) -> Option<(f64, f64)> {
        if self.radius.is_infinite() {
            return None;
        }
        if self.lo == 0.0 && self.radius == 0.0 {
            return Some((self.hi, self.hi));
        }
        let below = self.lo - self.radius;
        let above = self.lo + self.radius;
        // Each of the two roundings to nearest is undone by one step outwards.
        Some(((self.hi + below.next_down()).next_down(), (self.hi + above.next_up()).next_up()))
    }

    /// The two neighbouring doubles between which every element lies; `None` where they are not the same for all
    /// elements, or where nothing is certified.
    #[must_use]
    pub fn neighbours(self) -> Option<(f64, f64)> {
        let Self { hi, lo, radius } = self;
        let (below, above) = (hi.next_down(), hi.next_up());
        // The distance to either side of `hi` is exact; what is left of it covers the rounding of the sums.
        if lo > radius && lo + radius < 0.75 * (above - hi) {
            Some((hi, above))
        } else if lo < -radius && radius - lo < 0.75 * (hi - below) {
            Some((below, hi))
        } else {
            None
        }
    }

    /// The same set as a dyadic interval, a hair wider; `None` where nothing is certified.
    #[must_use]
    pub fn to_interval(self) -> Option<Interval> {
        if self.radius.is_infinite() {
            return None;
        }
        // Both parts lie within 2^±1074: their sum is exact with so many bits.
        let centre = Interval::from_f64(self.hi).add(&Interval::from_f64(self.lo), 2_200);
        Some(centre.widened(&Interval::from_f64(self.radius)))
    }

    /// The sign of every element, or `None`.
    #[must_use]
    pub fn sign(self) -> Option<std::cmp::Ordering> {
        let (lo, hi) = self.ends()?;
        if lo > 0.0 {
            Some(std::cmp::Ordering::Greater)
        } else if hi < 0.0 {
            Some(std::cmp::Ordering::Less)
        } else if lo == 0.0 && hi == 0.0 {
            Some(std::cmp::Ordering::Equal)
        } else {
            None
        }
    }

    /// The centre, rounded to a double.
    #[must_use]
    pub fn guess(self) -> f64 {
        self.hi
    }

    /// All negatives.
    #[must_use]
    pub fn negated(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo, radius: self.radius }
    }

    /// All sums.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        let (sum, error) = two_sum(self.hi, other.hi);
        let (low_sum, low_error) = two_sum(self.lo, other.lo);
        let (v, rest) = two_sum(sum, error + low_sum);
        let (hi, lo) = two_sum(v, rest + low_error);
        let scale = self.hi.abs() + other.hi.abs();
        let radius = (self.radius + other.radius + scale * UNIT + TINY) * ROUND_UP;
        Self::guarded(hi, lo, radius)
    }

    /// All differences.
    #[must_use]
    pub fn subtract(self, other: Self) -> Self {
        self.plus(other.negated())
    }

    /// All products.
    #[must_use]
    pub fn multiply(self, other: Self) -> Self {
        let (p, error) = two_product(self.hi, other.hi);
        let mixed = self.hi * other.lo + self.lo * other.hi;
        let (hi, lo) = fast_two_sum(p, error + mixed);
        let radius = self.hi.abs() * other.radius
            + other.hi.abs() * self.radius
            + self.radius * other.radius
            + p.abs() * UNIT
            + TINY;
        Self::guarded(hi, lo, radius * ROUND_UP)
    }

    /// All quotients; nothing is certified where zero is an element of the divisor.
    #[must_use]
    pub fn divide(self, other: Self) -> Self {
        let least = (other.hi.abs() - other.lo.abs() - other.radius) / ROUND_UP;
        let q1 = self.hi / other.hi;
        let divisor = Self { radius: 0.0, ..other };
        let dividend = Self { radius: 0.0, ..self };
        let first = dividend.subtract(divisor.multiply(Self::exact(q1)));
        let q2 = first.hi / other.hi;
        let (hi, lo) = fast_two_sum(q1, q2);
        // a − (q1+q2)·b for the centres; where q2 is too small to be certified, it is part of the
        // remainder.
        let remainder = if q2.abs() < SMALLEST {
            first.hi.abs() + first.lo.abs() + first.radius
        } else {
            let second = first.subtract(divisor.multiply(Self::exact(q2)));
            second.hi.abs() + second.lo.abs() + second.radius
        };
        let lo = if q2.abs() < SMALLEST { 0.0 } else { lo };
        let hi = if q2.abs() < SMALLEST { q1 } else { hi };
        // |a/b − q| <= (|a_c − q·b_c| + a.radius + |q|·b.radius)/|b|.
        let spread = remainder + self.radius + (hi.abs() + lo.abs()) * other.radius;
        // Far from zero, so that the roundings of `least` itself are covered.
        if least > SMALLEST && least > other.hi.abs() / 4.0 {
            Self::guarded(hi, lo, (spread / least * ROUND_UP + TINY) * ROUND_UP)
        } else {
            Self::UNKNOWN
        }
    }

    /// All powers with a natural exponent.
    #[must_use]
    pub fn power(self, exponent: u64) -> Self {
        let Some(top) = exponent.checked_ilog2() else {
            return Self::exact(1.0);
        };
        let mut result = self;
        for place in (0..top).rev() {
            result = result.multiply(result);
            if exponent >> place & 1 == 1 {
                result = result.multiply(self);
            }
        }
        result
    }

    /// All sums with what is at most as large as an element of another, on either side.
    #[must_use]
    pub fn joined(self, other: Self) -> Self {
        match other.ends() {
            Some((lo, hi)) => self.widened(lo.abs().max(hi.abs())),
            None => Self::UNKNOWN,
        }
    }

    /// The natural logarithm of a positive rational; nothing is certified for others.
    ///
    /// With `x = m·2^k`, `m` from 2/3 to 4/3, and `z = (m − 1)/(m + 1)`, `|z| <= 1/5`: `ln x = k·ln 2 + 2·artanh z`, and what is left of
    /// `artanh z/z = Σ z^(2j)/(2j+1)` after `TERMS` terms is below `2·25^(−TERMS)/(2·TERMS + 1)`. `z` is formed exactly, so that
    /// the logarithm of a number near 1 is as accurate, relatively, as any.
    #[must_use]
    pub fn ln(x: &Rational) -> Self {
        let (above, below) = (x.numerator_ref(), x.denominator_ref());
        let places = |n: &Natural| i64::try_from(n.significant_bits()).unwrap_or(i64::MAX / 4);
        if *x <= Rational::ZERO {
            return Self::UNKNOWN;
        }
        let mut k = places(above) - places(below);
        let mut m = x >> k;
        // Now m lies between 1/2 and 2.
        if m > Rational::from_unsigneds(4u8, 3u8) {
            m >>= 1;
            k += 1;
        } else if m < Rational::from_unsigneds(2u8, 3u8) {
            m <<= 1;
            k -= 1;
        }
        let z = Self::from_rational(&((&m - Rational::ONE) / (m + Rational::ONE)));
        let square = z.multiply(z);
        let mut sum = Self::exact(0.0);
        for j in (0..TERMS).rev() {
            sum = sum.multiply(square).plus(Self::exact(1.0).divide(Self::exact(f64::from(2 * j + 1))));
        }
        let part = z.multiply(sum.widened(REST)).multiply(Self::exact(2.0));
        if k == 0 {
            return part;
        }
        // The cast is exact: below 2^53, as no rational has more bits.
        part.plus(Self::LN_2.multiply(Self::exact(k as f64)))
    }

    /// `ln 2`: the doubles next to it and a bound of what is left.
    const LN_2: Self = Self { hi: std::f64::consts::LN_2, lo: 2.319_046_813_846_299_6e-17, radius: 3.0 * UNIT };

    /// The same set, a given amount wider on both sides.
    fn widened(self, by: f64) -> Self {
        Self::guarded(self.hi, self.lo, (self.radius + by) * ROUND_UP)
    }

    /// The `k`-th root of a positive number: guessed, corrected once and certified by its power, as
    /// in [`super::root`].
    #[must_use]
    pub fn root(self, k: u64) -> Self {
        if k == 1 {
            return self;
        }
        if k == 0 || k > 1 << 50 || self.hi <= 0.0 {
            return Self::UNKNOWN;
        }
        // k <= 2^50 is exact as a double.
        let count = k as f64;
        let y = if (self.hi - 1.0).abs() < 0.25 {
            ((self.hi - 1.0) + self.lo).ln_1p() / count
        } else {
            self.hi.ln() / count
        };
        let t = if y.abs() < 0.25 {
            let (hi, lo) = two_sum(1.0, y.exp_m1());
            Self::guarded(hi, lo, 0.0)
        } else {
            Self::exact(y.exp())
        };
        let one = Self::exact(1.0);
        let residue = one.subtract(t.power(k).divide(self));
        let size = (residue.hi.abs() + residue.lo.abs() + residue.radius) * ROUND_UP;
        // Written so that NaN and infinity fail it.
        let near = size <= 0.0625;
        if !near {
            return Self::UNKNOWN;
        }
        let step = t.multiply(residue).divide(Self::exact(count));
        // Upper bound of 5/4·q²·t/k; t is at most twice its leading part.
        let tail = 1.25 * size * size * t.hi * 2.0 / count * ROUND_UP * ROUND_UP + TINY;
        let result = if step.radius.is_infinite() {
            // q is exactly or nearly zero: its whole size is the correction's bound.
            t.widened(2.0 * t.hi * size / count * ROUND_UP * ROUND_UP + TINY)
        } else {
            t.plus(step)
        };
        result.widened(tail)
    }
}
