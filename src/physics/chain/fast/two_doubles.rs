//! Numbers as sums of two doubles.

use super::lanes::{Lanes, Pair};
use super::{LARGE, SMALL};
use crate::number::rational;
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

/// A number as the sum of two doubles, the second at most half a unit in the last place of the first.
///
/// **Contract.** The sum is within `4u²` of the number, relatively, or NaN where that cannot be promised; a quotient is
/// within `2E`. So `9/10` and `10/3` enter [`super::etas_of_two`] as well as doubles do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TwoDoubles {
    /// The nearest double, or next to it in a quotient.
    pub high: f64,
    /// What is left.
    pub low: f64,
}

impl TwoDoubles {
    /// Nothing is promised.
    const UNKNOWN: TwoDoubles = TwoDoubles { high: f64::NAN, low: 0.0 };

    /// A double.
    #[must_use]
    pub(crate) fn exact(x: f64) -> TwoDoubles {
        TwoDoubles { high: x, low: 0.0 }
    }

    /// A whole number.
    #[must_use]
    pub(crate) fn of_integer(x: i64) -> TwoDoubles {
        let high = x as f64;
        // At most 2^9 in size.
        TwoDoubles { high, low: (i128::from(x) - high as i128) as f64 }
    }

    /// A rational: the nearest double, and the double nearest to the rest.
    #[must_use]
    pub(crate) fn of_rational(x: &Rational) -> TwoDoubles {
        let nearest = |x: &Rational| f64::rounding_from(x, RoundingMode::Nearest).0;
        let high = nearest(x);
        if *x == Rational::ZERO {
            return TwoDoubles::exact(0.0);
        }
        match Rational::try_from(high) {
            // Far from where doubles lose bits.
            Ok(exact) if (SMALL..=LARGE).contains(&high.abs()) => TwoDoubles { high, low: nearest(&(x - exact)) },
            _ => TwoDoubles::UNKNOWN,
        }
    }

    /// The shortest decimal that this double is printed as: nine tenths for `0.9`.
    ///
    /// **Why.** Two decimals of at most 15 digits never share their nearest double. So if `x·10^k` rounds to a whole `p` below
    /// `10^15` with `p/10^k` rounding to `x`, then `p/10^k` is the shortest one. The rest `(p − x·10^k)/10^k` follows from the exact
    /// product, with two roundings.
    #[must_use]
    pub(crate) fn of_decimal(x: f64) -> TwoDoubles {
        const MOST: f64 = 1e15;
        let mut scale = 1.0;
        for _ in 0..=15 {
            let whole = (x * scale).round_ties_even();
            if whole.abs() >= MOST {
                break;
            }
            if whole / scale == x {
                let Pair { high, low } = Lanes::<1, false>([x]).product(Lanes([scale]));
                return TwoDoubles { high: x, low: ((whole - high.0[0]) - low.0[0]) / scale };
            }
            scale *= 10.0;
        }
        decimal_of(x).map_or(TwoDoubles::UNKNOWN, |x| TwoDoubles::of_rational(&x))
    }

    /// The quotient, within `2E` for operands within `4u²`.
    #[must_use]
    #[inline]
    pub(crate) fn over(self, other: TwoDoubles) -> TwoDoubles {
        let pair = |x: TwoDoubles| Pair::<1, false> { high: Lanes([x.high]), low: Lanes([x.low]) };
        // Then no product on the way is so small or so large that its error is not a double.
        if [self, other].iter().all(|x| (SMALL..=LARGE).contains(&x.high)) {
            let found = pair(self).over(pair(other));
            return TwoDoubles { high: found.high.0[0], low: found.low.0[0] };
        }
        TwoDoubles::UNKNOWN
    }
}

/// The shortest decimal that a double is printed as, exactly; `None` where it is not finite.
#[must_use]
pub(crate) fn decimal_of(x: f64) -> Option<Rational> {
    if x.is_finite() { rational::parse(&format!("{x:e}")).ok() } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_decimal_is_the_one_that_is_printed(bits in any::<u64>(), whole in 0..10_000_000_u32, places in 0..9_u32) {
            let short = f64::from(whole) / 10_f64.powi(places as i32);
            for x in [short, f64::from_bits(bits)] {
                let Some(exact) = decimal_of(x) else { continue };
                let found = TwoDoubles::of_decimal(x);
                if exact == Rational::ZERO {
                    prop_assert_eq!((found.high, found.low), (0.0, 0.0));
                } else if !found.high.is_nan() {
                    let double = |x: f64| Rational::try_from(x).expect("finite");
                    let rest = double(found.high) + double(found.low) - &exact;
                    let relative = f64::rounding_from(&(rest / exact), RoundingMode::Nearest).0;
                    prop_assert!(relative.abs() <= 4.0 * 2f64.powi(-106), "{}: {}", x, relative);
                } else {
                    prop_assert!(!(SMALL..=LARGE).contains(&x.abs()), "{}", x);
                }
            }
        }
    }
}
