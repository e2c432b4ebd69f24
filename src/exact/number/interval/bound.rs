//! Bounds of absolute errors: a short integer and a power of two, rounded up in every step.

use super::RADIUS_BITS;
use malachite::Integer;
use malachite::base::num::conversion::traits::SaturatingFrom;
use malachite::base::num::logic::traits::SignificantBits;

/// A bound `size·2^shift` of an absolute error, rounded up in every step.
#[derive(Clone, Copy)]
pub(super) struct Bound {
    pub(super) size: u64,
    pub(super) shift: u64,
}

impl Bound {
    pub(super) const NONE: Bound = Bound { size: 0, shift: 0 };
    pub(super) const UNIT: Bound = Bound { size: 1, shift: 0 };

    /// At least `|x|`, with 32 bits.
    pub(super) fn of(x: &Integer) -> Bound {
        let shift = x.significant_bits().saturating_sub(RADIUS_BITS.into());
        let top = x.unsigned_abs_ref() >> shift;
        let top = u64::saturating_from(&top);
        Bound { size: top + u64::from(shift > 0), shift }
    }

    /// At least the product.
    pub(super) fn times(self, factor: u64) -> Bound {
        let product = u128::from(self.size) * u128::from(factor);
        Bound::from_wide(product, self.shift)
    }

    pub(super) fn from_wide(size: u128, shift: u64) -> Bound {
        let excess = (128 - u64::from(size.leading_zeros())).saturating_sub(60);
        Bound { size: ceil_shift(size, excess), shift: shift + excess }
    }

    /// At least the sum.
    pub(super) fn plus(self, other: Bound) -> Bound {
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
    pub(super) fn down(self, places: u64) -> Bound {
        let less = places.min(self.shift);
        Bound { size: ceil_shift(u128::from(self.size), places - less), shift: self.shift - less }
    }

    /// At least the bound times `2^places`.
    pub(super) fn up(self, places: u64) -> Bound {
        Bound { size: self.size, shift: self.shift + places }
    }

    /// The bound in units; it is short.
    pub(super) fn units(self) -> u64 {
        if self.size == 0 { 0 } else { self.size << self.shift }
    }

    /// Bits of the bound.
    pub(super) fn bits(self) -> u64 {
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
