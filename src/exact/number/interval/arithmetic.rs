//! Sums, products, quotients, square roots and powers of intervals.
//!
//! Each computes with the middles and bounds the error; [`super::Interval`] states the contract.

use super::bound::Bound;
use super::{Interval, MAX_EXPONENT, RADIUS_BITS};
use malachite::base::num::arithmetic::traits::{DivisibleByPowerOf2, FloorSqrt, Square};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::SaturatingFrom;
use malachite::base::num::logic::traits::{BitAccess, SignificantBits};
use malachite::{Integer, Natural, Rational};

/// Divisions of more bits than this multiply by a Newton reciprocal (bench `numbers`, group `division`).
pub(in crate::number) const NEWTON_DIVISION_BITS: u64 = 20_000;

impl Interval {
    /// All negatives.
    #[must_use]
    pub fn negated(&self) -> Interval {
        Interval { mid: -&self.mid, radius: self.radius, exponent: self.exponent }
    }

    /// All elements times `2^places`.
    #[must_use]
    pub fn shifted(&self, places: i64) -> Interval {
        if self.is_whole() {
            return Interval::whole();
        }
        Interval::checked(self.mid.clone(), self.radius, self.exponent.saturating_add(places))
    }

    /// All sums.
    #[must_use]
    pub fn add(&self, other: &Interval, bits: u64) -> Interval {
        if self.is_whole() || other.is_whole() {
            return Interval::whole();
        }
        let top = self.top().max(other.top());
        if self.top() == i64::MIN {
            return other.round(bits);
        }
        if other.top() == i64::MIN {
            return self.round(bits);
        }
        // Digits more than four places below the precision are not needed.
        let needed = top.saturating_sub(i64::try_from(bits.saturating_add(4)).unwrap_or(i64::MAX));
        let unit = self.exponent.min(other.exponent).max(needed);
        let (x, x_bound) = self.in_units(unit);
        let (y, y_bound) = other.in_units(unit);
        Interval::rounded(x + y, x_bound.plus(y_bound), unit, bits)
    }

    /// All differences.
    #[must_use]
    pub fn subtract(&self, other: &Interval, bits: u64) -> Interval {
        self.add(&other.negated(), bits)
    }

    /// All products.
    #[must_use]
    pub fn multiply(&self, other: &Interval, bits: u64) -> Interval {
        if self.is_whole() || other.is_whole() {
            return Interval::whole();
        }
        let bound = if self.radius == 0 && other.radius == 0 {
            Bound::NONE
        } else {
            Bound::of(&self.mid)
                .times(other.radius)
                .plus(Bound::of(&other.mid).times(self.radius))
                .plus(Bound { size: self.radius, shift: 0 }.times(other.radius))
        };
        let exponent = self.exponent.saturating_add(other.exponent);
        Interval::rounded(&self.mid * &other.mid, bound, exponent, bits)
    }

    /// All squares.
    #[must_use]
    pub fn square(&self, bits: u64) -> Interval {
        if self.is_whole() {
            return Interval::whole();
        }
        let radius = Bound { size: self.radius, shift: 0 };
        let bound = if self.radius == 0 {
            Bound::NONE
        } else {
            Bound::of(&self.mid).times(2 * self.radius).plus(radius.times(self.radius))
        };
        Interval::rounded((&self.mid).square(), bound, self.exponent.saturating_mul(2), bits)
    }

    /// All square roots; the whole line unless the middle is above 0 and no element is below 0.
    ///
    /// In the units of the result, let `M` be the middle, `y` an element, `|y − M| <= E`, and `s` the root found,
    /// `s <= √M < s + 1`. Then `|√y − √M| = |y − M|/(√y + √M)` is at most `E/√M <= E/s`, and for `E <= M/16` at most
    /// `(16/31)·E/s`, since `√y >= √M·√(1 − 1/16) >= √M·15/16`.
    #[must_use]
    pub fn square_root(&self, bits: u64) -> Interval {
        let middle = self.mid.unsigned_abs_ref();
        if self.mid <= 0 || *middle < self.radius {
            return Interval::whole();
        }
        let bits = bits.max(2);
        // Twice as many digits as the root shall have, and an even exponent.
        let places = bits.saturating_mul(2).saturating_sub(self.mid.significant_bits());
        let places = places + (places + self.exponent.unsigned_abs()) % 2;
        let root = (middle << places).floor_sqrt();
        let small = middle.significant_bits() > 4 + u64::from(RADIUS_BITS)
            || self.radius.saturating_mul(16) <= u64::saturating_from(middle);
        let (above, below) = if small { (16, 31) } else { (1, 1) };
        // Its first digits, not 0, and at most twice 32 bits over them.
        let cut = root.significant_bits().saturating_sub(RADIUS_BITS.into());
        let leading = below * u128::from(u64::saturating_from(&(&root >> cut)));
        let size = ((u128::from(self.radius) * above) << RADIUS_BITS).div_ceil(leading);
        let bound = Bound::from_wide(size, places).down(cut + u64::from(RADIUS_BITS)).plus(Bound::UNIT);
        let exponent = self.exponent.saturating_sub(i64::try_from(places).unwrap_or(i64::MAX)) / 2;
        Interval::rounded(Integer::from(root), bound, exponent, bits)
    }

    /// All quotients by a natural number, the whole line where it is zero.
    #[must_use]
    pub fn divide_by_natural(&self, divisor: &Natural, bits: u64) -> Interval {
        if self.is_whole() || *divisor == Natural::ZERO {
            return Interval::whole();
        }
        if *divisor == Natural::ONE {
            return self.round(bits);
        }
        let divisor_bits = divisor.significant_bits();
        if divisor.divisible_by_power_of_2(divisor_bits - 1) {
            return self.shifted(-i64::try_from(divisor_bits - 1).unwrap_or(MAX_EXPONENT)).round(bits);
        }
        let extra = bits.saturating_add(divisor_bits + 2).saturating_sub(self.mid.significant_bits());
        let quotient = (&self.mid << extra) / Integer::from(divisor);
        // The divisor is at least 2^(divisor_bits − 1); truncation costs a unit.
        let bound = Bound { size: self.radius, shift: 0 }.up(extra).down(divisor_bits - 1).plus(Bound::UNIT);
        let exponent = self.exponent.saturating_sub(i64::try_from(extra).unwrap_or(i64::MAX));
        Interval::rounded(quotient, bound, exponent, bits)
    }

    /// All products with a rational; cheap where its numerator and denominator are short.
    #[must_use]
    pub fn multiply_rational(&self, x: &Rational, bits: u64) -> Interval {
        let numerator = Integer::from_sign_and_abs_ref(*x >= Rational::ZERO, x.numerator_ref());
        let product = self.multiply(&Interval::from_integer(numerator), bits.saturating_add(2));
        product.divide_by_natural(x.denominator_ref(), bits)
    }

    /// All quotients; the whole line where zero may be an element of the divisor.
    #[must_use]
    pub fn divide(&self, other: &Interval, bits: u64) -> Interval {
        let divisor_bits = other.mid.significant_bits();
        // Below, |divisor| >= 2^(divisor_bits − 2) is used.
        if self.is_whole() || other.is_whole() || divisor_bits == 0 {
            return Interval::whole();
        }
        if other.radius.significant_bits() + 2 > divisor_bits && other.radius > 0 {
            return Interval::whole();
        }
        if bits > NEWTON_DIVISION_BITS && divisor_bits > NEWTON_DIVISION_BITS {
            return self.multiply(&other.reciprocal(bits + 4), bits);
        }
        let extra = bits.saturating_add(divisor_bits + 2).saturating_sub(self.mid.significant_bits());
        let quotient = (&self.mid << extra) / &other.mid;
        // |a/b − a'/b'| <= (|a − a'| + |a'/b'|·|b − b'|)/|b|, in units of 2^-extra.
        let from_divisor = Bound::of(&quotient).plus(Bound::UNIT).times(other.radius);
        let from_dividend = Bound { size: self.radius, shift: 0 }.up(extra);
        let bound = from_dividend.plus(from_divisor).up(1).down(divisor_bits - 1).plus(Bound::UNIT);
        let exponent = self.exponent.saturating_sub(other.exponent);
        let exponent = exponent.saturating_sub(i64::try_from(extra).unwrap_or(i64::MAX));
        Interval::rounded(quotient, bound, exponent, bits)
    }

    /// All powers with a natural exponent.
    ///
    /// Cost: a squaring for each binary digit of the exponent, a product for each digit one.
    #[must_use]
    pub fn power(&self, exponent: &Natural, bits: u64) -> Interval {
        let digits = exponent.significant_bits();
        if digits == 0 {
            return Interval::from_integer(1);
        }
        // Each doubling of the exponent doubles the relative error.
        let bits = bits.saturating_add(digits + 4);
        let mut result = self.round(bits);
        for place in (0..digits - 1).rev() {
            result = result.square(bits);
            if exponent.get_bit(place) {
                result = result.multiply(self, bits);
            }
        }
        result
    }
}
