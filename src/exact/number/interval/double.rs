//! Intervals from doubles, exactly, and back to doubles, rounded outwards.

use super::Interval;
use super::bound::Bound;
use malachite::base::num::arithmetic::traits::{DivisibleByPowerOf2, NegAssign};
use malachite::base::num::conversion::traits::SaturatingFrom;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Natural};

impl Interval {
    /// A double, exactly; the whole line where it is not finite.
    #[must_use]
    pub fn from_f64(x: f64) -> Interval {
        if !x.is_finite() {
            return Interval::whole();
        }
        let bits = x.to_bits();
        let fraction = bits & ((1 << 52) - 1);
        let biased = i64::from(u16::saturating_from(bits >> 52 & 0x7ff));
        let (size, exponent) = if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
        let mut mid = Integer::from(size);
        if x < 0.0 {
            mid.neg_assign();
        }
        Interval::from_dyadic(mid, exponent)
    }

    /// All reals between two positive doubles, `lo <= hi`; exactly them where they agree to about 20 bits.
    #[must_use]
    pub fn between_f64(lo: f64, hi: f64) -> Interval {
        let (least, most) = (Interval::from_f64(lo), Interval::from_f64(hi));
        let exponent = least.exponent.min(most.exponent).saturating_sub(1);
        let places = |x: &Interval| x.exponent.saturating_sub(exponent).saturating_sub(1).unsigned_abs();
        if least.is_whole() || most.is_whole() || places(&least).max(places(&most)) > 4_096 {
            return Interval::whole();
        }
        let (a, b) = (&least.mid << places(&least), &most.mid << places(&most));
        let radius = Bound::of(&(&b - &a));
        Interval::rounded(a + b, radius, exponent, u64::MAX)
    }

    /// A double at most the least element and one at least the greatest, infinite where need be.
    #[must_use]
    pub fn to_f64_ends(&self) -> (f64, f64) {
        match self.ends() {
            None => (f64::NEG_INFINITY, f64::INFINITY),
            Some((lo, hi)) => (-(lo.negated()).f64_above(), hi.f64_above()),
        }
    }

    /// The least double not below a point.
    fn f64_above(&self) -> f64 {
        let negative = self.mid < 0;
        let bits = self.mid.significant_bits();
        let top = self.top();
        if bits == 0 {
            return 0.0;
        }
        if top > 1024 {
            return if negative { -f64::MAX } else { f64::INFINITY };
        }
        // The unit of the last place of doubles of this size.
        let unit = (top - 53).max(-1074);
        let shift = self.exponent.saturating_sub(unit);
        let size = if shift >= 0 {
            self.mid.unsigned_abs_ref() << shift.unsigned_abs()
        } else {
            let places = shift.unsigned_abs();
            let floor = self.mid.unsigned_abs_ref() >> places;
            let up = !negative && !self.mid.divisible_by_power_of_2(places);
            floor + Natural::from(u8::from(up))
        };
        // At most 2^53, exact; powers of two are exact down to 2^-1074.
        let size = u64::saturating_from(&size) as f64;
        let scaled = scale_f64(size, unit);
        if negative { -scaled } else { scaled }
    }

    /// About the middle, as a double; for guesses.
    #[must_use]
    pub fn guess_f64(&self) -> f64 {
        let (lo, hi) = self.to_f64_ends();
        if lo.is_finite() && hi.is_finite() { lo / 2.0 + hi / 2.0 } else { f64::NAN }
    }
}

/// `x·2^exponent` for a non-negative integer below `2^54`, exact where the result is a double.
fn scale_f64(x: f64, exponent: i64) -> f64 {
    let power = |k: i64| f64::from_bits(u64::try_from(1023 + k).unwrap_or(0) << 52);
    if exponent < -1000 {
        // In two steps; the first is exact, the second is where the result is a double.
        x * power(-500) * power((exponent + 500).max(-1022))
    } else if exponent > 1000 {
        f64::INFINITY
    } else {
        x * power(exponent)
    }
}
