//! Enclosures in double precision: the first look at an exact number.
//!
//! Contract: [`Bounds`] contains the number that it was made from, and the result of an operation contains the
//! exact results on all elements of its operands. IEEE arithmetic rounds each operation to a neighbour, so one
//! step outward contains the exact result, also at overflow and underflow; where nothing is known (`inf − inf`,
//! `0·inf`, a divisor around zero) the result is the whole line.

use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use std::cmp::Ordering;

/// All reals from `lo` to `hi`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub lo: f64,
    pub hi: f64,
}

impl Bounds {
    /// Nothing is known.
    pub(crate) const WHOLE: Bounds = Bounds { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// The two neighbouring doubles around an exact number.
    pub(super) fn of(x: &Rational) -> Bounds {
        Bounds { lo: f64::rounding_from(x, RoundingMode::Floor).0, hi: f64::rounding_from(x, RoundingMode::Ceiling).0 }
    }

    fn outward(lo: f64, hi: f64) -> Bounds {
        if lo.is_nan() || hi.is_nan() {
            return Bounds::WHOLE;
        }
        Bounds { lo: lo.next_down(), hi: hi.next_up() }
    }

    pub(crate) fn minus(self, other: Bounds) -> Bounds {
        let points = self.lo == self.hi && other.lo == other.hi && self.lo.is_finite();
        if points && self.lo == other.lo {
            return Bounds { lo: 0.0, hi: 0.0 };
        }
        Bounds::outward(self.lo - other.hi, self.hi - other.lo)
    }

    pub(super) fn plus(self, other: Bounds) -> Bounds {
        Bounds::outward(self.lo + other.lo, self.hi + other.hi)
    }

    pub(super) fn times(self, other: Bounds) -> Bounds {
        let all = [self.lo * other.lo, self.lo * other.hi, self.hi * other.lo, self.hi * other.hi];
        Bounds::around(all)
    }

    /// The quotient; the whole line where the divisor may be zero.
    pub(super) fn over(self, other: Bounds) -> Bounds {
        if other.sign().is_none_or(Ordering::is_eq) {
            return Bounds::WHOLE;
        }
        Bounds::around([self.lo / other.lo, self.lo / other.hi, self.hi / other.lo, self.hi / other.hi])
    }

    fn around(all: [f64; 4]) -> Bounds {
        if all.iter().any(|x| x.is_nan()) {
            return Bounds::WHOLE;
        }
        let lo = all.iter().copied().fold(f64::INFINITY, f64::min);
        let hi = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Bounds::outward(lo, hi)
    }

    /// The sign, where all elements have the same.
    pub(super) fn sign(self) -> Option<Ordering> {
        if self.lo > 0.0 {
            Some(Ordering::Greater)
        } else if self.hi < 0.0 {
            Some(Ordering::Less)
        } else if self.lo == 0.0 && self.hi == 0.0 {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    /// The order, where the enclosures are apart.
    pub(super) fn order(self, other: Bounds) -> Option<Ordering> {
        if self.hi < other.lo {
            Some(Ordering::Less)
        } else if self.lo > other.hi {
            Some(Ordering::Greater)
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use malachite::base::num::arithmetic::traits::Pow;

    fn holds(b: Bounds, x: &Rational) -> bool {
        let below = b.lo == f64::NEG_INFINITY || Rational::try_from(b.lo).is_ok_and(|lo| lo <= *x);
        let above = b.hi == f64::INFINITY || Rational::try_from(b.hi).is_ok_and(|hi| hi >= *x);
        below && above
    }

    #[test]
    fn every_operation_contains_the_exact_result() {
        let mut numbers = vec![Rational::from(0), Rational::from(1), Rational::from(-1)];
        for k in [1i64, 3, 52, 53, 54, 400, 1022, 1074, 1080, 1100] {
            for n in [1i64, 3, 7, -5, 1_000_003] {
                numbers.push(Rational::from(n) * Rational::from(2).pow(k));
                numbers.push(Rational::from(n) / Rational::from(2).pow(k));
                numbers.push(Rational::from_signeds(n, 3) + Rational::from(2).pow(-k));
            }
        }
        for x in &numbers {
            assert!(holds(Bounds::of(x), x), "{x}");
            for y in &numbers {
                let (a, b) = (Bounds::of(x), Bounds::of(y));
                assert!(holds(a.plus(b), &(x + y)) && holds(a.minus(b), &(x - y)), "{x} {y}");
                assert!(holds(a.times(b), &(x * y)), "{x} {y}");
                if *y != 0 {
                    assert!(holds(a.over(b), &(x / y)), "{x} {y}");
                }
                if let Some(order) = a.order(b) {
                    assert_eq!(order, x.cmp(y));
                }
            }
        }
    }
}
