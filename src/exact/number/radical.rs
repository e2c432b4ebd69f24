//! The field Q(s^(1/k)): exact arithmetic, an exact zero test and the sign.
//!
//! **Contract.** A [`Field`] is made for a root `t = r^(1/K)` of a positive rational. Its elements are
//! polynomials in `t`; two of them are equal iff their coefficients are. [`Field::sign`] is exact.
//!
//! **Why it is right.** Write `r = s^j` with `j` maximal and `k = K/gcd(K, j)`: then `t^k = s^(j/gcd(K, j))` is rational,
//! no smaller power is, and `1, t, …, t^(k−1)` are independent over Q (the lemma in `src/physics/chain`). So an
//! element is zero iff every coefficient is, and intervals settle the sign of any other.
//!
//! **Cost.** A product costs `k²` products of coefficients; a sign one evaluation at each precision tried.

use super::NumberError;
use super::interval::Interval;
use super::rational::{exact_root, height};
use super::real::{Level, Real};
use super::root::root;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};
use std::cmp::Ordering;

/// The largest degree of a field whose elements are written down.
pub const MAX_DEGREE: u64 = 100_000;

/// `Q(t)` for `t` the positive `k`-th root of a rational, `k` minimal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// `t^k`.
    power: Rational,
    degree: u64,
}

/// An element: the coefficients of `1, t, …, t^(k−1)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Element {
    coefficients: Vec<Rational>,
}

impl Field {
    /// The field of `r^(1/root)`, and the element `r^(1/root)`.
    ///
    /// # Errors
    /// [`NumberError::Undefined`] for `r <= 0` or `root = 0`; [`NumberError::LimitReached`] above [`MAX_DEGREE`].
    pub fn of_root(r: &Rational, degree: u64) -> Result<(Field, Element), NumberError> {
        if *r <= Rational::ZERO || degree == 0 {
            return Err(NumberError::Undefined { what: format!("the positive root of degree {degree} of {r}") });
        }
        // Only 1 is a power of more than as many degrees as it has bits.
        let bits = if *r == Rational::ONE { u64::MAX } else { height(r).significant_bits() };
        if degree.div_ceil(bits) > MAX_DEGREE {
            return Err(too_large(degree / bits));
        }
        let degree = if *r == Rational::ONE { 1 } else { degree };
        // The largest divisor d of the degree for which r is a d-th power leaves the minimal degree.
        let (taken, power) = largest_power(r, degree);
        let degree = degree / taken;
        if degree > MAX_DEGREE {
            return Err(too_large(degree));
        }
        let field = Field { power, degree };
        let generator = field.monomial(Rational::ONE, 1);
        Ok((field, generator))
    }

    /// `k`, the degree of the field over Q.
    #[must_use]
    pub fn degree(&self) -> u64 {
        self.degree
    }

    /// A rational.
    #[must_use]
    pub fn rational(&self, x: Rational) -> Element {
        self.monomial(x, 0)
    }

    /// `c·t^exponent`.
    #[must_use]
    pub fn monomial(&self, c: Rational, exponent: u64) -> Element {
        let mut coefficients = vec![Rational::ZERO; usize::try_from(self.degree).unwrap_or(1)];
        let place = usize::try_from(exponent % self.degree).unwrap_or(0);
        if let Some(entry) = coefficients.get_mut(place) {
            *entry = c * (&self.power).pow(exponent / self.degree);
        }
        Element { coefficients }
    }

    /// The sum.
    #[must_use]
    pub fn add(&self, a: &Element, b: &Element) -> Element {
        Element { coefficients: a.coefficients.iter().zip(&b.coefficients).map(|(x, y)| x + y).collect() }
    }

    /// The difference.
    #[must_use]
    pub fn subtract(&self, a: &Element, b: &Element) -> Element {
        Element { coefficients: a.coefficients.iter().zip(&b.coefficients).map(|(x, y)| x - y).collect() }
    }

    /// The product.
    #[must_use]
    pub fn multiply(&self, a: &Element, b: &Element) -> Element {
        let degree = a.coefficients.len();
        let mut coefficients = vec![Rational::ZERO; degree];
        for (i, x) in a.coefficients.iter().enumerate().filter(|(_, x)| **x != Rational::ZERO) {
            for (j, y) in b.coefficients.iter().enumerate() {
                let product = x * y;
                let (place, product) =
                    if i + j < degree { (i + j, product) } else { (i + j - degree, product * &self.power) };
                if let Some(entry) = coefficients.get_mut(place) {
                    *entry += product;
                }
            }
        }
        Element { coefficients }
    }

    /// The power, by squarings.
    #[must_use]
    pub fn power(&self, a: &Element, exponent: u64) -> Element {
        let mut result = self.rational(Rational::ONE);
        for place in (0..u64::BITS - exponent.leading_zeros()).rev() {
            result = self.multiply(&result, &result);
            if exponent >> place & 1 == 1 {
                result = self.multiply(&result, a);
            }
        }
        result
    }

    /// The value as a real number: rational iff all coefficients but the first are zero.
    #[must_use]
    pub fn real(&self, a: &Element) -> Real {
        if let Some(exact) = a.as_rational() {
            return Real::rational(exact.clone());
        }
        let (field, a) = (self.clone(), a.clone());
        Real::enclosed(move |bits| field.enclosure(&a, bits))
    }

    /// An enclosure by Horner's rule.
    fn enclosure(&self, a: &Element, bits: u64) -> Interval {
        let bits = bits + u64::from(self.degree.ilog2()) + 16;
        let t = root(&self.power, &Natural::from(self.degree), bits);
        a.coefficients.iter().rev().fold(Interval::from_integer(0), |sum, c| {
            sum.multiply(&t, bits).add(&Interval::from_rational(c, bits), bits)
        })
    }

    /// The sign, exactly, and the level that settled it.
    ///
    /// # Errors
    /// [`NumberError::LimitReached`] where the most precise enclosures do not tell.
    pub fn sign(&self, a: &Element) -> Result<(Ordering, Level), NumberError> {
        self.real(a).sign()
    }
}

fn too_large(degree: u64) -> NumberError {
    let limit = "degree of a radical field";
    NumberError::LimitReached { limit, allowed: MAX_DEGREE, needed: degree.to_string() }
}

impl Element {
    /// Whether it is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.coefficients.iter().all(|c| *c == Rational::ZERO)
    }

    /// The value where it is rational.
    #[must_use]
    pub fn as_rational(&self) -> Option<&Rational> {
        let (first, rest) = self.coefficients.split_first()?;
        rest.iter().all(|c| *c == Rational::ZERO).then_some(first)
    }

    /// The coefficients of `1, t, …`.
    #[must_use]
    pub fn coefficients(&self) -> &[Rational] {
        &self.coefficients
    }
}

/// The largest divisor `d` of `n` for which `r` is a `d`-th power, and that root.
fn largest_power(r: &Rational, n: u64) -> (u64, Rational) {
    let (mut taken, mut base, mut rest) = (1, r.clone(), n);
    let mut prime = 2;
    while rest > 1 {
        if prime * prime > rest {
            prime = rest;
        }
        if !rest.is_multiple_of(prime) {
            prime += 1;
            continue;
        }
        rest /= prime;
        match exact_root(&base, prime) {
            Some(found) => (taken, base) = (taken * prime, found),
            // No further factor of this prime helps.
            None => {
                while rest.is_multiple_of(prime) {
                    rest /= prime;
                }
            }
        }
    }
    (taken, base)
}
