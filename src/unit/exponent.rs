//! Exponents of dimensions: exact fractions of machine integers.

use std::fmt;

/// A reduced fraction with a positive denominator. Arithmetic returns nothing where a number leaves 64 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Exponent {
    above: i64,
    below: i64,
}

impl Exponent {
    /// 0
    pub const ZERO: Exponent = Exponent { above: 0, below: 1 };
    /// 1
    pub const ONE: Exponent = Exponent { above: 1, below: 1 };

    /// A whole number.
    #[must_use]
    pub const fn whole(value: i64) -> Exponent {
        Exponent { above: value, below: 1 }
    }

    /// `above/below`, reduced; nothing if it divides by 0 or is too long.
    #[must_use]
    pub fn new(above: i128, below: i128) -> Option<Exponent> {
        if below == 0 {
            return None;
        }
        let (mut a, mut b) = (above.unsigned_abs(), below.unsigned_abs());
        while b > 0 {
            (a, b) = (b, a % b);
        }
        let divisor = i128::try_from(a).ok()?;
        let sign = if below < 0 { -1 } else { 1 };
        let part = |value: i128| i64::try_from(value / divisor * sign).ok();
        Some(Exponent { above: part(above)?, below: part(below)? })
    }

    /// Whether it is 0.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.above == 0
    }

    /// Whether it is above 0.
    #[must_use]
    pub fn is_positive(self) -> bool {
        self.above > 0
    }

    /// Its negative.
    #[must_use]
    pub fn negated(self) -> Option<Exponent> {
        Exponent::new(-i128::from(self.above), i128::from(self.below))
    }

    /// The sum.
    #[must_use]
    pub fn plus(self, other: Exponent) -> Option<Exponent> {
        let [a, b, c, d] = [self.above, self.below, other.above, other.below].map(i128::from);
        Exponent::new(a.checked_mul(d)?.checked_add(c.checked_mul(b)?)?, b.checked_mul(d)?)
    }

    /// The product.
    #[must_use]
    pub fn times(self, other: Exponent) -> Option<Exponent> {
        let [a, b, c, d] = [self.above, self.below, other.above, other.below].map(i128::from);
        Exponent::new(a.checked_mul(c)?, b.checked_mul(d)?)
    }

    /// The quotient.
    #[must_use]
    pub fn over(self, other: Exponent) -> Option<Exponent> {
        let [a, b, c, d] = [self.above, self.below, other.above, other.below].map(i128::from);
        Exponent::new(a.checked_mul(d)?, b.checked_mul(c)?)
    }
}

/// Adds a multiple of a list to another of its length; nothing if an exponent becomes too long.
pub(crate) fn add_multiple(own: &mut [Exponent], other: &[Exponent], factor: Exponent) -> Option<()> {
    own.iter_mut().zip(other).try_for_each(|(own, other)| {
        *own = own.plus(other.times(factor)?)?;
        Some(())
    })
}

impl fmt::Display for Exponent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.below == 1 { write!(f, "{}", self.above) } else { write!(f, "{}/{}", self.above, self.below) }
    }
}
