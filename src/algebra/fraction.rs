//! Rational functions in lowest terms.
//!
//! Contract: numerator and denominator are coprime, the denominator has coprime integer coefficients
//! and a positive leading one, so equal functions are equal values; a polynomial has denominator 1.
//! As functions they are equal wherever both are defined: cancelling `x/x` to 1 fills the gap at 0,
//! so a caller who cares for poles records the denominators before it makes a fraction.
//!
//! Method: products cancel crosswise and sums through the gcd of the denominators (Henrici), so
//! gcds are taken of small polynomials only; polynomials are added and multiplied without any gcd.

use super::gcd::gcd;
use super::{LimitReached, Polynomial, Var};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::fmt;

/// A quotient of polynomials in lowest terms.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Fraction {
    numerator: Polynomial,
    denominator: Polynomial,
}

/// Why there is no fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FractionError {
    /// The denominator is the zero polynomial.
    ZeroDenominator,
    /// A limit of the polynomial arithmetic was reached.
    Limit(LimitReached),
}

impl From<LimitReached> for FractionError {
    fn from(limit: LimitReached) -> Self {
        Self::Limit(limit)
    }
}

impl fmt::Display for FractionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ZeroDenominator => f.write_str("the denominator is zero"),
            Self::Limit(limit) => limit.fmt(f),
        }
    }
}

impl std::error::Error for FractionError {}

impl From<Polynomial> for Fraction {
    fn from(numerator: Polynomial) -> Self {
        Self { numerator, denominator: Polynomial::one() }
    }
}

impl From<Rational> for Fraction {
    fn from(value: Rational) -> Self {
        Self::from(Polynomial::constant(value))
    }
}

impl Fraction {
    /// The function 0.
    #[must_use]
    pub fn zero() -> Self {
        Self::from(Polynomial::zero())
    }

    /// The function 1.
    #[must_use]
    pub fn one() -> Self {
        Self::from(Polynomial::one())
    }

    /// A variable.
    #[must_use]
    pub fn variable(var: Var) -> Self {
        Self::from(Polynomial::variable(var))
    }

    /// The quotient of two polynomials.
    ///
    /// # Errors
    /// [`FractionError`] for the denominator 0 and at a limit.
    pub fn new(numerator: &Polynomial, denominator: &Polynomial) -> Result<Self, FractionError> {
        if denominator.is_zero() {
            return Err(FractionError::ZeroDenominator);
        }
        let (n, d) = cancelled(numerator, denominator)?;
        Ok(Self::coprime(n, d))
    }

    /// The fraction of coprime polynomials, the denominator not 0.
    fn coprime(numerator: Polynomial, denominator: Polynomial) -> Self {
        if numerator.is_zero() {
            return Self::zero();
        }
        let (content, denominator) = denominator.primitive_part();
        let numerator = match content == Rational::ONE {
            true => numerator,
            false => numerator.scale(&(Rational::ONE / content)),
        };
        Self { numerator, denominator }
    }

    /// The numerator; its coefficients are rational.
    #[must_use]
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// The denominator; its coefficients are coprime integers, the leading one positive.
    #[must_use]
    pub fn denominator(&self) -> &Polynomial {
        &self.denominator
    }

    /// Whether this is the function 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Whether this is the function 1.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.denominator.is_one() && self.numerator.is_one()
    }

    /// The polynomial, where the denominator is 1.
    #[must_use]
    pub fn as_polynomial(&self) -> Option<&Polynomial> {
        self.denominator.is_one().then_some(&self.numerator)
    }

    /// The value of a constant function.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        self.as_polynomial()?.as_constant()
    }

    /// The variables that occur, increasing.
    #[must_use]
    pub fn variables(&self) -> Vec<Var> {
        let mut all = self.numerator.variables();
        all.extend(self.denominator.variables());
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The negative.
    #[must_use]
    pub fn neg(&self) -> Self {
        Self { numerator: self.numerator.neg(), denominator: self.denominator.clone() }
    }

    /// The product with a rational number.
    #[must_use]
    pub fn scale(&self, factor: &Rational) -> Self {
        if *factor == Rational::ZERO {
            return Self::zero();
        }
        Self { numerator: self.numerator.scale(factor), denominator: self.denominator.clone() }
    }

    /// The sum.
    ///
    /// # Errors
    /// [`LimitReached`] at a limit of the polynomial arithmetic.
    pub fn add(&self, other: &Self) -> Result<Self, LimitReached> {
        let (a, b) = (&self.numerator, &self.denominator);
        let (c, d) = (&other.numerator, &other.denominator);
        if b == d {
            let sum = a.add(c);
            if b.is_one() {
                return Ok(Self::from(sum));
            }
            let (n, d) = cancelled(&sum, b)?;
            return Ok(Self::coprime(n, d));
        }
        let common = gcd(b, d)?;
        let (rest_b, rest_d) = (divided(b, &common), divided(d, &common));
        let sum = a.try_mul(&rest_d)?.add(&c.try_mul(&rest_b)?);
        // Only the common part of the denominators can cancel.
        let (numerator, common) = cancelled(&sum, &common)?;
        Ok(Self::coprime(numerator, rest_b.try_mul(&rest_d)?.try_mul(&common)?))
    }

    /// The difference.
    ///
    /// # Errors
    /// [`LimitReached`] at a limit of the polynomial arithmetic.
    pub fn sub(&self, other: &Self) -> Result<Self, LimitReached> {
        self.add(&other.neg())
    }

    /// The product.
    ///
    /// # Errors
    /// [`LimitReached`] at a limit of the polynomial arithmetic.
    pub fn mul(&self, other: &Self) -> Result<Self, LimitReached> {
        let (a, d) = cancelled(&self.numerator, &other.denominator)?;
        let (c, b) = cancelled(&other.numerator, &self.denominator)?;
        Ok(Self::coprime(a.try_mul(&c)?, b.try_mul(&d)?))
    }

    /// The reciprocal.
    ///
    /// # Errors
    /// [`FractionError::ZeroDenominator`] for the function 0.
    pub fn reciprocal(&self) -> Result<Self, FractionError> {
        if self.is_zero() {
            return Err(FractionError::ZeroDenominator);
        }
        Ok(Self::coprime(self.denominator.clone(), self.numerator.clone()))
    }

    /// The quotient.
    ///
    /// # Errors
    /// [`FractionError`] for the divisor 0 and at a limit.
    pub fn div(&self, other: &Self) -> Result<Self, FractionError> {
        Ok(self.mul(&other.reciprocal()?)?)
    }

    /// The power; the zeroth is 1, also of the function 0.
    ///
    /// # Errors
    /// [`FractionError`] for a negative power of 0 and at a limit.
    pub fn pow(&self, exponent: i32) -> Result<Self, FractionError> {
        let base = if exponent < 0 { self.reciprocal()? } else { self.clone() };
        let size = exponent.unsigned_abs();
        // Powers of coprime polynomials are coprime, powers of primitive ones primitive (Gauss).
        Ok(Self { numerator: base.numerator.pow(size)?, denominator: base.denominator.pow(size)? })
    }

    /// The value at a point, `None` at a pole.
    #[must_use]
    pub fn evaluate(&self, value: &dyn Fn(Var) -> Rational) -> Option<Rational> {
        let below = self.denominator.evaluate(value);
        if below == Rational::ZERO {
            return None;
        }
        Some(self.numerator.evaluate(value) / below)
    }

    /// The partial derivative.
    ///
    /// # Errors
    /// [`LimitReached`] at a limit of the polynomial arithmetic.
    pub fn derivative(&self, var: Var) -> Result<Self, LimitReached> {
        let (n, d) = (&self.numerator, &self.denominator);
        if !d.contains(var) {
            let (n, d) = cancelled(&n.derivative(var), d)?;
            return Ok(Self::coprime(n, d));
        }
        let change = n.derivative(var).try_mul(d)?.sub(&n.try_mul(&d.derivative(var))?);
        let (n, d) = cancelled(&change, &d.pow(2)?)?;
        Ok(Self::coprime(n, d))
    }

    /// The function with one variable replaced by a function.
    ///
    /// # Errors
    /// [`FractionError`] where the denominator becomes 0 and at a limit.
    pub fn substitute(&self, var: Var, value: &Self) -> Result<Self, FractionError> {
        if let Some(value) = value.as_polynomial() {
            return Self::new(&self.numerator.substitute(var, value)?, &self.denominator.substitute(var, value)?);
        }
        // Both are made polynomials by the same power of the denominator of the value.
        let degree = self.numerator.degree_in(var).max(self.denominator.degree_in(var));
        let above = homogenised(&self.numerator, var, degree, value)?;
        let below = homogenised(&self.denominator, var, degree, value)?;
        Self::new(&above, &below)
    }

    /// The function as text, with the given names.
    #[must_use]
    pub fn display(&self, name: &dyn Fn(Var) -> String) -> String {
        let above = self.numerator.display(name);
        if self.denominator.is_one() {
            return above;
        }
        format!("({above})/({})", self.denominator.display(name))
    }
}

impl fmt::Display for Fraction {
    /// The function with the variables named `x0`, `x1`, ….
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.display(&|var| format!("x{var}")))
    }
}

/// Both polynomials without their common divisor.
fn cancelled(a: &Polynomial, b: &Polynomial) -> Result<(Polynomial, Polynomial), LimitReached> {
    if a.is_constant() && !a.is_zero() || b.is_constant() {
        return Ok((a.clone(), b.clone()));
    }
    let common = gcd(a, b)?;
    Ok((divided(a, &common), divided(b, &common)))
}

/// The quotient by a divisor that is known to divide.
fn divided(p: &Polynomial, divisor: &Polynomial) -> Polynomial {
    if divisor.is_one() {
        return p.clone();
    }
    p.exact_divide(divisor).expect("a common divisor divides")
}

/// `Σ cᵢ·nⁱ·d^(degree − i)` for `p = Σ cᵢ·varⁱ` and the value `n/d`.
fn homogenised(p: &Polynomial, var: Var, degree: u32, value: &Fraction) -> Result<Polynomial, LimitReached> {
    let mut coefficients = p.coefficients_in(var);
    coefficients.resize(degree as usize + 1, Polynomial::zero());
    let mut sum = Polynomial::zero();
    let mut scale = Polynomial::one();
    for coefficient in coefficients.iter().rev() {
        sum = sum.try_mul(&value.numerator)?.add(&coefficient.try_mul(&scale)?);
        scale = scale.try_mul(&value.denominator)?;
    }
    Ok(sum)
}
