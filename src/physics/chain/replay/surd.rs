//! Numbers `a + b·√d` of a quadratic field, `a`, `b`, `d` rational: where collapses happen.
//!
//! Contract: the value is exact; sign and order are decided by rational arithmetic alone, for the sign of
//! `a + b·√d` is that of the larger of `a²` and `b²·d`. The radicand is a positive integer without square
//! factors of primes below [`SQUARE_PRIMES`], and no square; rational numbers have `b = 0`, `d = 1`.

use malachite::base::num::arithmetic::traits::{CheckedSqrt, DivExact, DivisibleBy, FloorSqrt, Sign, Square};
use malachite::base::num::basic::traits::{One, Two, Zero};
use malachite::{Natural, Rational};
use std::cmp::Ordering;
use std::fmt;

/// Square factors of primes below this are taken out of radicands.
const SQUARE_PRIMES: u32 = 1000;

/// `a + b·√d`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Surd {
    a: Rational,
    b: Rational,
    d: Natural,
}

impl From<Rational> for Surd {
    fn from(a: Rational) -> Surd {
        Surd { a, b: Rational::ZERO, d: Natural::ONE }
    }
}

impl Surd {
    /// `a + b·√d`; `None` for a negative radicand.
    ///
    /// ```
    /// use carom_physics::chain::replay::Surd;
    /// use malachite::Rational;
    /// let x = Surd::new(Rational::from(1), Rational::from(2), &Rational::from(8)).unwrap();
    /// assert_eq!(x.to_string(), "1 + 4*sqrt(2)");
    /// ```
    #[must_use]
    pub fn new(a: Rational, b: Rational, d: &Rational) -> Option<Surd> {
        if *d < Rational::ZERO {
            return None;
        }
        // √(n/m) = √(n·m)/m.
        let below = Rational::from(d.denominator_ref());
        let mut radicand = d.numerator_ref() * d.denominator_ref();
        let mut b = b / below;
        if radicand == Natural::ZERO || b == Rational::ZERO {
            return Some(Surd::from(a));
        }
        if let Some(root) = (&radicand).checked_sqrt() {
            return Some(Surd::from(a + b * Rational::from(root)));
        }
        for p in 2..SQUARE_PRIMES {
            let square = Natural::from(p).square();
            if square > radicand {
                break;
            }
            while (&radicand).divisible_by(&square) {
                radicand = radicand.div_exact(&square);
                b *= Rational::from(p);
            }
        }
        Some(Surd { a, b, d: radicand })
    }

    /// The number, where it is rational.
    #[must_use]
    pub fn rational(&self) -> Option<&Rational> {
        (self.b == Rational::ZERO).then_some(&self.a)
    }

    /// `Less`, `Equal` or `Greater` than zero.
    #[must_use]
    pub fn sign(&self) -> Ordering {
        let (a, b) = (self.a.sign(), self.b.sign());
        if b == Ordering::Equal || a == b {
            return a;
        }
        if a == Ordering::Equal {
            return b;
        }
        let (left, right) = ((&self.a).square(), (&self.b).square() * Rational::from(&self.d));
        if left > right { a } else { b }
    }

    /// The order of the number and a rational.
    #[must_use]
    pub fn compare(&self, other: &Rational) -> Ordering {
        self.plus(&-other).sign()
    }

    /// The sum with a rational.
    #[must_use]
    pub fn plus(&self, x: &Rational) -> Surd {
        Surd { a: &self.a + x, b: self.b.clone(), d: self.d.clone() }
    }

    /// The product with a rational.
    #[must_use]
    pub fn times(&self, x: &Rational) -> Surd {
        if *x == Rational::ZERO {
            return Surd::from(Rational::ZERO);
        }
        Surd { a: &self.a * x, b: &self.b * x, d: self.d.clone() }
    }

    /// The quotient of two numbers over the same radicand (or rational); `None` where it does not exist.
    #[must_use]
    pub fn over(&self, other: &Surd) -> Option<Surd> {
        let d = if self.b == Rational::ZERO { &other.d } else { &self.d };
        if other.sign() == Ordering::Equal || (other.b != Rational::ZERO && other.d != *d) {
            return None;
        }
        let radicand = Rational::from(d);
        let norm = (&other.a).square() - (&other.b).square() * &radicand;
        let a = (&self.a * &other.a - &self.b * &other.b * &radicand) / &norm;
        let b = (&self.b * &other.a - &self.a * &other.b) / norm;
        if b == Rational::ZERO { Some(Surd::from(a)) } else { Some(Surd { a, b, d: d.clone() }) }
    }

    /// Rationals around the number, at most `2^-bits` apart.
    #[must_use]
    pub fn enclose(&self, bits: u64) -> (Rational, Rational) {
        if self.b == Rational::ZERO {
            return (self.a.clone(), self.a.clone());
        }
        let size = malachite::base::num::logic::traits::SignificantBits::significant_bits(self.b.numerator_ref());
        let shift = bits + size + 1;
        let root = (&self.d << (2 * shift)).floor_sqrt();
        let lo = Rational::from(&root) >> shift;
        let hi = Rational::from(root + Natural::ONE) >> shift;
        let (x, y) = (&self.a + &self.b * lo, &self.a + &self.b * hi);
        if x <= y { (x, y) } else { (y, x) }
    }
}

impl fmt::Display for Surd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.b == Rational::ZERO {
            return write!(f, "{}", self.a);
        }
        let size = if self.b < Rational::ZERO { -&self.b } else { self.b.clone() };
        let minus = self.b < Rational::ZERO;
        if self.a == Rational::ZERO {
            f.write_str(if minus { "-" } else { "" })?;
        } else {
            write!(f, "{} {} ", self.a, if minus { '-' } else { '+' })?;
        }
        if size != Rational::ONE {
            write!(f, "{size}*")?;
        }
        write!(f, "sqrt({})", self.d)
    }
}

/// The larger root of `x² − sum·x + product`, where it is real.
pub(super) fn larger_root(sum: &Rational, product: &Rational) -> Option<Surd> {
    let discriminant = sum.square() - Rational::from(4) * product;
    Surd::new(sum / Rational::TWO, Rational::ONE / Rational::TWO, &discriminant)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_and_quotients_agree_with_enclosures() {
        let q = |n: i64, d: i64| Rational::from_signeds(n, d);
        for a in -6..7 {
            for b in -4..5 {
                for d in [0u32, 1, 2, 3, 4, 8, 12, 18, 45] {
                    let Some(x) = Surd::new(q(a, 2), q(b, 3), &q(i64::from(d), 5)) else { panic!("radicand") };
                    let (lo, hi) = x.enclose(200);
                    assert!(hi >= lo && &hi - &lo <= Rational::ONE >> 200u32);
                    let expected = if lo > 0 {
                        Ordering::Greater
                    } else if hi < 0 {
                        Ordering::Less
                    } else {
                        Ordering::Equal
                    };
                    assert_eq!(x.sign(), expected, "{x}");
                    let Some(y) = Surd::new(q(1, 7), q(2, 1), &q(i64::from(d), 5)) else { panic!("radicand") };
                    let Some(ratio) = x.over(&y) else { panic!("{x} over {y}") };
                    let (rlo, rhi) = ratio.enclose(300);
                    let (ylo, yhi) = y.enclose(300);
                    // ratio·y − x is zero up to the widths.
                    let slack = Rational::ONE >> 150u32;
                    assert!(&rlo * &ylo - &hi <= slack && &lo - &rhi * &yhi <= slack || rlo < 0, "{x} / {y}");
                }
            }
        }
        assert_eq!(larger_root(&q(4, 1), &q(1, 1)).map(|s| s.to_string()).as_deref(), Some("2 + sqrt(3)"));
    }
}
