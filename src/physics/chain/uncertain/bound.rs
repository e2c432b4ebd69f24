//! Exact numbers, rounded to one side where they grow long.
//!
//! A bound of a product of many rationals is carried as a rational: exact while it is short, and beyond that rounded
//! in the direction that keeps it a bound.

use super::{ChainError, Positive, Range};
use crate::number::NumberError;
use malachite::base::num::arithmetic::traits::{Ceiling, Floor, PowerOf2};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Rational};

/// Numbers of at most so many times the bits asked for stay exact.
const EXACT: u64 = 8;

/// The most bits by which the sizes of all masses may differ from 1 together.
pub(crate) const MAX_SPREAD_BITS: u64 = 1 << 18;

/// The side to which a bound may be off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// Never above.
    Below,
    /// Never below.
    Above,
}

/// A number of about `bits` bits on the given side of `x`, within a relative `2^(1 − bits)`; `x` itself where it is short.
#[must_use]
pub(crate) fn shortened(x: Rational, side: Side, bits: u64) -> Rational {
    let (above, below) = (x.numerator_ref().significant_bits(), x.denominator_ref().significant_bits());
    if above.max(below) <= bits.saturating_mul(EXACT) {
        return x;
    }
    let size = i64::try_from(above).unwrap_or(i64::MAX / 4) - i64::try_from(below).unwrap_or(i64::MAX / 4);
    let places = i64::try_from(bits).unwrap_or(i64::MAX / 4) - size + 1;
    let scaled = x * Rational::power_of_2(places);
    let whole: Integer = match side {
        Side::Below => scaled.floor(),
        Side::Above => scaled.ceiling(),
    };
    Rational::from(whole) * Rational::power_of_2(-places)
}

/// The product of all factors, on one side.
pub(super) fn product(factors: impl Iterator<Item = Rational>, side: Side, bits: u64) -> Rational {
    factors.fold(Rational::from(1), |product, factor| shortened(product * factor, side, bits))
}

/// Refuses masses of so different sizes that their products are not written down.
pub(super) fn limit_spread(masses: &[Range<Positive>]) -> Result<(), ChainError> {
    let size = |m: &Positive| {
        let m = m.value();
        m.numerator_ref().significant_bits().abs_diff(m.denominator_ref().significant_bits())
    };
    let spread: u64 = masses.iter().map(|m| size(m.lo()).max(size(m.hi()))).sum();
    if spread > MAX_SPREAD_BITS {
        let limit = "bits by which measured masses differ in size";
        return Err(NumberError::LimitReached { limit, allowed: MAX_SPREAD_BITS, needed: spread.to_string() }.into());
    }
    Ok(())
}
