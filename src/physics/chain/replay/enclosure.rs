//! The numbers that a worldline is followed with: rationals, doubles with bounds, and intervals.

use super::Value;
use super::bounds::Bounds;
use crate::number::interval::Interval;
use malachite::base::num::arithmetic::traits::Sign;
use malachite::{Integer, Rational};
use std::cmp::Ordering;

/// The operations that follow a worldline.
pub(super) trait Number: Clone {
    fn of(x: &Rational, bits: u64) -> Self;
    fn plus(&self, other: &Self, bits: u64) -> Self;
    fn minus(&self, other: &Self, bits: u64) -> Self;
    fn times(&self, other: &Self, bits: u64) -> Self;
}

/// A number known up to an enclosure.
pub(super) trait Enclosure: Number {
    fn over(&self, other: &Self, bits: u64) -> Self;
    fn sign(&self) -> Option<Ordering>;
    /// A double to order the heap by; it decides nothing.
    fn guess(&self) -> f64;
    fn value(&self) -> Option<Value>;
}

impl Number for Rational {
    fn of(x: &Rational, _: u64) -> Rational {
        x.clone()
    }
    fn plus(&self, other: &Rational, _: u64) -> Rational {
        self + other
    }
    fn minus(&self, other: &Rational, _: u64) -> Rational {
        self - other
    }
    fn times(&self, other: &Rational, _: u64) -> Rational {
        self * other
    }
}

impl Number for Bounds {
    #[inline]
    fn of(x: &Rational, _: u64) -> Bounds {
        Bounds::of(x)
    }
    #[inline]
    fn plus(&self, other: &Bounds, _: u64) -> Bounds {
        Bounds::plus(*self, *other)
    }
    #[inline]
    fn minus(&self, other: &Bounds, _: u64) -> Bounds {
        Bounds::minus(*self, *other)
    }
    #[inline]
    fn times(&self, other: &Bounds, _: u64) -> Bounds {
        Bounds::times(*self, *other)
    }
}

impl Enclosure for Bounds {
    #[inline]
    fn over(&self, other: &Bounds, _: u64) -> Bounds {
        Bounds::over(*self, *other)
    }
    #[inline]
    fn sign(&self) -> Option<Ordering> {
        Bounds::sign(*self)
    }
    #[inline]
    fn guess(&self) -> f64 {
        self.lo
    }
    #[inline]
    fn value(&self) -> Option<Value> {
        Some(Value::Within(Rational::try_from(self.lo).ok()?, Rational::try_from(self.hi).ok()?))
    }
}

impl Enclosure for Rational {
    fn over(&self, other: &Rational, _: u64) -> Rational {
        self / other
    }
    fn sign(&self) -> Option<Ordering> {
        Some(Sign::sign(self))
    }
    fn guess(&self) -> f64 {
        Bounds::of(self).lo
    }
    fn value(&self) -> Option<Value> {
        Some(Value::Exact(self.clone()))
    }
}

impl Number for Interval {
    fn of(x: &Rational, bits: u64) -> Interval {
        Interval::from_rational(x, bits)
    }
    fn plus(&self, other: &Interval, bits: u64) -> Interval {
        self.add(other, bits)
    }
    fn minus(&self, other: &Interval, bits: u64) -> Interval {
        self.subtract(other, bits)
    }
    fn times(&self, other: &Interval, bits: u64) -> Interval {
        self.multiply(other, bits)
    }
}

impl Enclosure for Interval {
    fn over(&self, other: &Interval, bits: u64) -> Interval {
        self.divide(other, bits)
    }
    fn sign(&self) -> Option<Ordering> {
        Interval::sign(self)
    }
    fn guess(&self) -> f64 {
        self.to_f64_ends().0
    }
    fn value(&self) -> Option<Value> {
        let end = |(mid, exponent): (Integer, i64)| Rational::from(mid) << exponent;
        Some(Value::Within(end(self.lower()?), end(self.upper()?)))
    }
}
