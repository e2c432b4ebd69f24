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

use malachite::base::num::arithmetic::traits::{DivisibleByPowerOf2, FloorSqrt, NegAssign, PowerOf2, Sign, Square};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::SaturatingFrom;
use malachite::base::num::logic::traits::{BitAccess, SignificantBits};
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

/// Divisions of more bits than this multiply by a Newton reciprocal (bench `numbers`, group `division`).
pub(super) const NEWTON_DIVISION_BITS: u64 = 20_000;

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

/// A bound `size·2^shift` of an absolute error, rounded up in every step.
#[derive(Clone, Copy)]
struct Bound {
    size: u64,
    shift: u64,
}

impl Bound {
    const NONE: Bound = Bound { size: 0, shift: 0 };
    const UNIT: Bound = Bound { size: 1, shift: 0 };

    /// At least `|x|`, with 32 bits.
    fn of(x: &Integer) -> Bound {
        let shift = x.significant_bits().saturating_sub(RADIUS_BITS.into());
        let top = x.unsigned_abs_ref() >> shift;
        let top = u64::saturating_from(&top);
        Bound { size: top + u64::from(shift > 0), shift }
    }

    /// At least the product.
    fn times(self, factor: u64) -> Bound {
        let product = u128::from(self.size) * u128::from(factor);
        Bound::from_wide(product, self.shift)
    }

    fn from_wide(size: u128, shift: u64) -> Bound {
        let excess = (128 - u64::from(size.leading_zeros())).saturating_sub(60);
        Bound { size: ceil_shift(size, excess), shift: shift + excess }
    }

    /// At least the sum.
    fn plus(self, other: Bound) -> Bound {
        if self.size == 0 {
            return other;
        }
        if other.size == 0 {
            return self;
        }
        let (high, low) = if self.shift >= other.shift { (self, other) } else { (other, self) };
        let gap = high.shift - low.shift;
        // Keep low digits where the high one has room for them.
        let room = gap.min(60);
        let wide = (u128::from(high.size) << room) + u128::from(ceil_shift(u128::from(low.size), gap - room));
        Bound::from_wide(wide, high.shift - room)
    }

    /// At least the bound times `2^-places`, in whole units.
    fn down(self, places: u64) -> Bound {
        let less = places.min(self.shift);
        Bound { size: ceil_shift(u128::from(self.size), places - less), shift: self.shift - less }
    }

    /// At least the bound times `2^places`.
    fn up(self, places: u64) -> Bound {
        Bound { size: self.size, shift: self.shift + places }
    }

    /// The bound in units; it is short.
    fn units(self) -> u64 {
        if self.size == 0 { 0 } else { self.size << self.shift }
    }

    /// Bits of the bound.
    fn bits(self) -> u64 {
        self.size.significant_bits() + if self.size == 0 { 0 } else { self.shift }
    }
}

/// `x·2^-places`, rounded up; `x` fits after the shift.
fn ceil_shift(x: u128, places: u64) -> u64 {
    if places == 0 {
        return u64::try_from(x).unwrap_or(u64::MAX - 1);
    }
    if places >= 128 {
        return u64::from(x != 0);
    }
    let floor = x >> places;
    let up = u128::from(floor << places != x);
    u64::try_from(floor + up).unwrap_or(u64::MAX - 1)
}

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
    pub fn middle_bits(&self) -> u64 {
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
