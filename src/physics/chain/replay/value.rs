//! A number of a replay: exact, of a quadratic field, or between two rationals.

use super::Surd;
use malachite::Rational;
use std::cmp::Ordering;

/// A number of a replay.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// This number.
    Exact(Rational),
    /// A number of a quadratic field.
    Surd(Surd),
    /// A number from the first to the second.
    Within(Rational, Rational),
}

impl Value {
    /// The number, where it is known and rational.
    #[must_use]
    pub fn rational(&self) -> Option<&Rational> {
        match self {
            Value::Exact(x) => Some(x),
            Value::Surd(x) => x.rational(),
            Value::Within(lo, hi) => (lo == hi).then_some(lo),
        }
    }

    /// Rationals around the number, for exact ones at most `2^-bits` apart.
    #[must_use]
    pub fn enclose(&self, bits: u64) -> (Rational, Rational) {
        match self {
            Value::Exact(x) => (x.clone(), x.clone()),
            Value::Surd(x) => x.enclose(bits),
            Value::Within(lo, hi) => (lo.clone(), hi.clone()),
        }
    }

    /// The sum with a rational.
    pub(super) fn plus(&self, x: &Rational) -> Value {
        match self {
            Value::Exact(y) => Value::Exact(x + y),
            Value::Surd(y) => Value::from(y.plus(x)),
            Value::Within(lo, hi) => Value::Within(lo + x, hi + x),
        }
    }

    /// The product with a rational.
    pub(super) fn times(&self, x: &Rational) -> Value {
        match self {
            Value::Exact(y) => Value::Exact(x * y),
            Value::Surd(y) => Value::from(y.times(x)),
            Value::Within(lo, hi) if *x < 0 => Value::Within(hi * x, lo * x),
            Value::Within(lo, hi) => Value::Within(lo * x, hi * x),
        }
    }

    /// The order of the number and a rational, where it is certain.
    #[must_use]
    pub fn compare(&self, other: &Rational) -> Option<Ordering> {
        match self {
            Value::Exact(x) => Some(x.cmp(other)),
            Value::Surd(x) => Some(x.compare(other)),
            Value::Within(lo, hi) => {
                let (low, high) = (lo.cmp(other), hi.cmp(other));
                (low == high).then_some(low)
            }
        }
    }
}

impl From<Surd> for Value {
    fn from(x: Surd) -> Value {
        match x.rational() {
            Some(q) => Value::Exact(q.clone()),
            None => Value::Surd(x),
        }
    }
}
