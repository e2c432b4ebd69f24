//! Dyadic enclosures at any precision.
//!
//! **Contract.** An [`Interval`] is the set of reals within `radius` units of `mid`, a unit being
//! `2^exponent`: `[(mid − radius)·2^exponent, (mid + radius)·2^exponent]`. Every operation contains what
//! the exact operation gives on all elements of its operands, whatever precision it is given; more
//! precision makes it narrower. A result that cannot be enclosed (a divisor that may be zero, an exponent
//! beyond [`MAX_EXPONENT`]) is the whole line: nothing is claimed, nothing is wrong.
//!
//! **Method.** Integer arithmetic on the middle, then a shift to the precision asked for. A radius is a
//! bound and only ever rounded up; it keeps at most 32 bits, and a middle never carries more digits below
//! the radius than that. The exponent is a 64-bit integer, so nothing over- or underflows in practice:
//! `10^(10^18)` is an ordinary value.
//!
//! **Cost.** One integer operation of the precision each; a radius costs a few machine words.

mod arithmetic;
mod bound;
mod double;

pub(super) use arithmetic::NEWTON_DIVISION_BITS;
use bound::Bound;
use malachite::base::num::arithmetic::traits::{DivisibleByPowerOf2, PowerOf2, Sign};
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Natural, Rational};
use std::cmp::Ordering;

/// The largest absolute value of an exponent; beyond it an enclosure is the whole line.
pub const MAX_EXPONENT: i64 = 1 << 61;

/// The largest exponent of a point that is written down as a rational.
const MAX_WRITTEN: u64 = 1 << 20;

/// The most bits of a radius.
const RADIUS_BITS: u32 = 32;

/// Denominators longer than the precision by so much are cut to it.
const LONG_BITS: u64 = 1_024;

/// All reals within `radius·2^exponent` of `mid·2^exponent`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    mid: Integer,
    /// Below `2^RADIUS_BITS`, or `WHOLE`.
    radius: u64,
    exponent: i64,
}

/// By how many places a unit is refined at most to hold a small radius.
const MAX_REFINEMENT: i64 = 4_096;

/// The radius that says that nothing is known.
const WHOLE: u64 = u64::MAX;

impl Interval {
    /// The whole line.
    #[must_use]
    pub fn whole() -> Interval {
        Interval { mid: Integer::ZERO, radius: WHOLE, exponent: 0 }
    }

    /// Whether nothing is claimed.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.radius == WHOLE
    }

    /// An integer, exactly.
    #[must_use]
    pub fn from_integer(x: impl Into<Integer>) -> Interval {
        Interval { mid: x.into(), radius: 0, exponent: 0 }
    }

    /// `mid·2^exponent`, exactly.
    #[must_use]
    pub fn from_dyadic(mid: Integer, exponent: i64) -> Interval {
        Interval::checked(mid, 0, exponent)
    }

    /// A rational to `bits` bits; exact where it is dyadic and short enough.
    #[must_use]
    pub fn from_rational(x: &Rational, bits: u64) -> Interval {
        let numerator = Integer::from_sign_and_abs_ref(*x >= Rational::ZERO, x.numerator_ref());
        if x.denominator_ref().significant_bits() > bits.saturating_mul(2).saturating_add(LONG_BITS) {
            // The leading digits of both tell as much.
            let divisor = Interval::from_integer(Integer::from(x.denominator_ref())).round(bits + 8);
            return Interval::from_integer(numerator).round(bits + 8).divide(&divisor, bits);
        }
        Interval::from_integer(numerator).divide_by_natural(x.denominator_ref(), bits)
    }

    /// What lies within `error` units of `2^exponent` of the middle, with at most `bits` bits; `error` below `2^60`.
    pub(super) fn around(mid: Integer, error: u64, exponent: i64, bits: u64) -> Interval {
        Interval::rounded(mid, Bound { size: error, shift: 0 }, exponent, bits)
    }

    /// The set grown on both sides by an upper bound of `|by|`.
    #[must_use]
    pub fn widened(&self, by: &Interval) -> Interval {
        if self.is_whole() || by.is_whole() {
            return Interval::whole();
        }
        let bound = Bound::of(&by.mid).plus(Bound { size: by.radius, shift: 0 });
        if bound.size == 0 {
            return self.clone();
        }
        // A reach far below the unit asks for a finer one, up to a point.
        let finest = by.top().saturating_sub(i64::from(RADIUS_BITS)).max(self.exponent.saturating_sub(MAX_REFINEMENT));
        let unit = self.exponent.min(finest);
        let (mid, own) = self.in_units(unit);
        let gap = by.exponent.abs_diff(unit);
        let reach = if by.exponent >= unit { bound.up(gap) } else { bound.down(gap) };
        Interval::rounded(mid, own.plus(reach), unit, u64::MAX)
    }

    fn checked(mid: Integer, radius: u64, exponent: i64) -> Interval {
        if mid == 0 && radius == 0 {
            return Interval { mid, radius, exponent: 0 };
        }
        if exponent.unsigned_abs() > MAX_EXPONENT.unsigned_abs() {
            return Interval::whole();
        }
        Interval { mid, radius, exponent }
    }

    /// `mid ± bound` in units of `2^exponent`, cut down to `bits` bits and a short radius.
    fn rounded(mut mid: Integer, bound: Bound, exponent: i64, bits: u64) -> Interval {
        let for_middle = mid.significant_bits().saturating_sub(bits.max(2));
        let for_radius = bound.bits().saturating_sub((RADIUS_BITS - 2).into());
        let shift = for_middle.max(for_radius);
        if shift == 0 {
            return Interval::checked(mid, bound.units(), exponent);
        }
        let cut = !mid.divisible_by_power_of_2(shift);
        mid >>= shift;
        // A positive shift exceeds that of the bound: both count in units of the exponent.
        let bound = bound.down(shift);
        let radius = bound.units() + u64::from(cut);
        Interval::checked(mid, radius, exponent.saturating_add(i64::try_from(shift).unwrap_or(i64::MAX)))
    }

    /// The same set with at most `bits` bits in the middle, a hair wider.
    #[must_use]
    pub fn round(&self, bits: u64) -> Interval {
        if self.is_whole() || self.mid.significant_bits() <= bits {
            return self.clone();
        }
        Interval::rounded(self.mid.clone(), Bound { size: self.radius, shift: 0 }, self.exponent, bits)
    }

    /// The middle as a point, to `bits` bits; not an enclosure of the set.
    #[must_use]
    pub fn middle(&self, bits: u64) -> Interval {
        let shift = self.mid.significant_bits().saturating_sub(bits);
        let step = i64::try_from(shift).unwrap_or(i64::MAX);
        Interval::checked(&self.mid >> shift, 0, self.exponent.saturating_add(step))
    }

    /// The least element, as `mantissa·2^exponent`; `None` for the whole line.
    #[must_use]
    pub fn lower(&self) -> Option<(Integer, i64)> {
        (!self.is_whole()).then(|| (&self.mid - Integer::from(self.radius), self.exponent))
    }

    /// The greatest element, as `mantissa·2^exponent`; `None` for the whole line.
    #[must_use]
    pub fn upper(&self) -> Option<(Integer, i64)> {
        (!self.is_whole()).then(|| (&self.mid + Integer::from(self.radius), self.exponent))
    }

    /// The least and the greatest element as points.
    #[must_use]
    pub fn ends(&self) -> Option<(Interval, Interval)> {
        let ((lo, exponent), (hi, _)) = (self.lower()?, self.upper()?);
        Some((Interval::checked(lo, 0, exponent), Interval::checked(hi, 0, exponent)))
    }

    /// Whether it is a single number.
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.radius == 0
    }

    /// The single number of a point, where its exponent is small enough to write it down.
    #[must_use]
    pub fn point(&self) -> Option<Rational> {
        let short = self.radius == 0 && self.exponent.unsigned_abs() <= MAX_WRITTEN;
        short.then(|| Rational::from(&self.mid) * Rational::power_of_2(self.exponent))
    }

    /// The sign that all elements have, or `None`.
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        if self.radius == 0 {
            return Some(self.mid.sign());
        }
        (self.radius != WHOLE && self.mid.unsigned_abs_ref() > &Natural::from(self.radius)).then(|| self.mid.sign())
    }

    /// Relative accuracy in bits: the radius is at most `2^-accuracy` times the middle. 0 where the sign
    /// is open, `u64::MAX` for a point.
    #[must_use]
    pub fn accuracy(&self) -> u64 {
        if self.radius == 0 {
            return u64::MAX;
        }
        if self.radius == WHOLE {
            return 0;
        }
        self.mid.significant_bits().saturating_sub(1 + self.radius.significant_bits())
    }

    /// Bits of the middle.
    #[must_use]
    pub(crate) fn middle_bits(&self) -> u64 {
        self.mid.significant_bits()
    }

    /// The least `k` with all absolute values below `2^k`; `i64::MIN` for zero.
    #[must_use]
    pub fn top(&self) -> i64 {
        if self.mid == 0 && self.radius == 0 {
            return i64::MIN;
        }
        let bits = self.mid.significant_bits().max(self.radius.significant_bits()) + u64::from(self.radius > 0);
        self.exponent.saturating_add(i64::try_from(bits).unwrap_or(i64::MAX))
    }

    /// Whether a rational is an element.
    #[must_use]
    pub fn contains(&self, x: &Rational) -> bool {
        if self.is_whole() {
            return true;
        }
        // x = p/q against (mid ± radius)·2^exponent, in integers.
        let numerator = Integer::from_sign_and_abs_ref(*x >= Rational::ZERO, x.numerator_ref());
        let denominator = Integer::from(x.denominator_ref());
        let up = self.exponent.unsigned_abs();
        let (left, unit) =
            if self.exponent >= 0 { (numerator, denominator << up) } else { (numerator << up, denominator) };
        let lo = (&self.mid - Integer::from(self.radius)) * &unit;
        let hi = (&self.mid + Integer::from(self.radius)) * unit;
        lo <= left && left <= hi
    }

    /// Whether every element of another is an element.
    #[must_use]
    pub fn contains_interval(&self, other: &Interval) -> bool {
        let (Some((lo, hi)), Some((least, most))) = (self.ends(), other.ends()) else {
            return self.is_whole();
        };
        let below = |a: &Interval, b: &Interval| a.compare_point(b) != Ordering::Greater;
        below(&lo, &least) && below(&most, &hi)
    }

    /// The order of two points.
    fn compare_point(&self, other: &Interval) -> Ordering {
        let (x, y) = (self.mid.sign(), other.mid.sign());
        if x != y || x == Ordering::Equal {
            return x.cmp(&y);
        }
        let by_top = self.top().cmp(&other.top());
        if by_top != Ordering::Equal {
            return if x == Ordering::Greater { by_top } else { by_top.reverse() };
        }
        let gap = self.exponent.abs_diff(other.exponent);
        if self.exponent >= other.exponent {
            (&self.mid << gap).cmp(&other.mid)
        } else {
            self.mid.cmp(&(&other.mid << gap))
        }
    }

    /// The same set in units of `2^exponent`, a hair wider; only for larger units.
    fn in_units(&self, exponent: i64) -> (Integer, Bound) {
        let shift = exponent.abs_diff(self.exponent);
        let bound = Bound { size: self.radius, shift: 0 };
        if self.exponent >= exponent {
            return (&self.mid << shift, bound.up(shift));
        }
        let cut = !self.mid.divisible_by_power_of_2(shift);
        let bound = bound.down(shift);
        (&self.mid >> shift, if cut { bound.plus(Bound::UNIT) } else { bound })
    }
}
