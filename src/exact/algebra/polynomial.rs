//! Sparse polynomials in any number of variables with rational coefficients.
//!
//! Contract: a [`Polynomial`] is a list of terms with non-zero coefficients and distinct monomials in
//! strictly decreasing graded lexicographic order, so that equal polynomials are equal values and
//! `==`, hashing and ordering mean what they say. All arithmetic is exact.
//!
//! ```
//! use carom_exact::algebra::Polynomial;
//! let (x, y) = (Polynomial::variable(0), Polynomial::variable(1));
//! let difference = &(&x * &x) - &(&y * &y);
//! assert_eq!(difference.exact_divide(&(&x - &y)), Some(&x + &y));
//! assert_eq!(difference.to_string(), "x0^2 - x1^2");
//! ```
//!
//! Limits: [`Polynomial::try_mul`], [`Polynomial::pow`] and [`Polynomial::substitute`] refuse results
//! beyond [`MAX_DEGREE`], [`MAX_TERMS`] or [`MAX_WORK`]. The plain product [`Polynomial::mul`] is for
//! factors already known to be moderate; whatever a user may have written goes through `try_mul`.
//!
//! Cost: sums are linear in the terms; a product of n and m terms costs `n·m` coefficient products
//! and `O(n·m·log n)` moves of terms, because rows are merged in a balanced tree.

use super::monomial::{Monomial, checked_degree};
use super::{Limit, LimitReached, Var};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::HeightRef;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// The most terms that a limited operation may return.
pub(crate) const MAX_TERMS: usize = 50_000;

/// The most products of two terms that one limited operation may form.
pub(crate) const MAX_WORK: usize = 4_000_000;

/// The most bits of a numerator or denominator in the result of a limited operation.
pub(crate) const MAX_BITS: usize = 1 << 22;

/// A polynomial with rational coefficients, in normal form.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct Polynomial {
    pub(super) terms: Vec<(Monomial, Rational)>,
}

impl Polynomial {
    /// The zero polynomial.
    #[must_use]
    pub fn zero() -> Self {
        Self::default()
    }

    /// The constant 1.
    #[must_use]
    pub fn one() -> Self {
        Self::constant(Rational::ONE)
    }

    /// A constant.
    #[must_use]
    pub fn constant(value: Rational) -> Self {
        Self::term(Monomial::one(), value)
    }

    /// An integer constant.
    #[must_use]
    pub fn integer(value: i64) -> Self {
        Self::constant(Rational::from(value))
    }

    /// A variable.
    #[must_use]
    pub fn variable(var: Var) -> Self {
        Self::monomial(Monomial::variable(var))
    }

    /// A monomial with coefficient 1.
    #[must_use]
    pub fn monomial(monomial: Monomial) -> Self {
        Self::term(monomial, Rational::ONE)
    }

    /// A single term.
    #[must_use]
    pub fn term(monomial: Monomial, coefficient: Rational) -> Self {
        if coefficient == Rational::ZERO {
            return Self::zero();
        }
        Self { terms: vec![(monomial, coefficient)] }
    }

    /// The sum of the given terms, in any order, with repetitions and zeros allowed.
    #[must_use]
    pub fn from_terms(terms: impl IntoIterator<Item = (Monomial, Rational)>) -> Self {
        let mut terms: Vec<_> = terms.into_iter().collect();
        terms.sort_by(|a, b| b.0.cmp(&a.0));
        let mut merged: Vec<(Monomial, Rational)> = Vec::with_capacity(terms.len());
        for (monomial, coefficient) in terms {
            match merged.last_mut() {
                Some(last) if last.0 == monomial => last.1 += coefficient,
                _ => merged.push((monomial, coefficient)),
            }
        }
        merged.retain(|(_, c)| *c != Rational::ZERO);
        Self { terms: merged }
    }

    /// Whether this is the zero polynomial.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether this is the constant 1.
    #[must_use]
    pub fn is_one(&self) -> bool {
        matches!(self.terms.as_slice(), [(m, c)] if m.is_one() && *c == Rational::ONE)
    }

    /// Whether no variable occurs.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.terms.iter().all(|(m, _)| m.is_one())
    }

    /// The value of a constant polynomial.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        match self.terms.as_slice() {
            [] => Some(Rational::ZERO),
            [(m, c)] if m.is_one() => Some(c.clone()),
            _ => None,
        }
    }

    /// The terms in decreasing order of their monomials.
    pub fn terms(&self) -> impl ExactSizeIterator<Item = (&Monomial, &Rational)> {
        self.terms.iter().map(|(m, c)| (m, c))
    }

    /// The number of terms.
    #[must_use]
    pub fn term_count(&self) -> usize {
        self.terms.len()
    }

    /// The term with the largest monomial; none of the zero polynomial.
    #[must_use]
    pub(crate) fn leading_term(&self) -> Option<(&Monomial, &Rational)> {
        self.terms.first().map(|(m, c)| (m, c))
    }

    /// The coefficient of the leading term; 0 of the zero polynomial.
    #[must_use]
    pub fn leading_coefficient(&self) -> Rational {
        self.terms.first().map_or(Rational::ZERO, |(_, c)| c.clone())
    }

    /// The coefficient of one monomial, 0 where it does not occur.
    #[must_use]
    pub fn coefficient(&self, monomial: &Monomial) -> Rational {
        self.terms.binary_search_by(|(m, _)| monomial.cmp(m)).map_or(Rational::ZERO, |i| self.terms[i].1.clone())
    }

    /// The constant term.
    #[must_use]
    pub fn constant_term(&self) -> Rational {
        match self.terms.last() {
            Some((m, c)) if m.is_one() => c.clone(),
            _ => Rational::ZERO,
        }
    }

    /// The total degree; 0 of the zero polynomial.
    #[must_use]
    pub fn degree(&self) -> u32 {
        self.terms.first().map_or(0, |(m, _)| m.degree())
    }

    /// The largest exponent of a variable.
    #[must_use]
    pub fn degree_in(&self, var: Var) -> u32 {
        self.terms.iter().map(|(m, _)| m.exponent(var)).max().unwrap_or(0)
    }

    /// The variables that occur, increasing.
    #[must_use]
    pub fn variables(&self) -> Vec<Var> {
        let all: BTreeSet<Var> = self.terms.iter().flat_map(|(m, _)| m.powers().iter().map(|&(v, _)| v)).collect();
        all.into_iter().collect()
    }

    /// The bits of the largest numerator or denominator among the coefficients.
    #[must_use]
    pub(crate) fn height_bits(&self) -> usize {
        let bits = self.terms.iter().map(|(_, c)| c.height_ref().significant_bits()).max();
        usize::try_from(bits.unwrap_or(0)).unwrap_or(usize::MAX)
    }

    /// Whether a variable occurs.
    #[must_use]
    pub fn contains(&self, var: Var) -> bool {
        self.terms.iter().any(|(m, _)| m.exponent(var) > 0)
    }

    /// The sum.
    #[must_use]
    pub fn add(&self, other: &Self) -> Self {
        Self { terms: merge(self.terms.clone(), other.terms.clone()) }
    }

    /// The difference.
    #[must_use]
    pub fn sub(&self, other: &Self) -> Self {
        Self { terms: merge(self.terms.clone(), other.neg().terms) }
    }

    /// The negative.
    #[must_use]
    pub fn neg(&self) -> Self {
        Self { terms: self.terms.iter().map(|(m, c)| (m.clone(), -c)).collect() }
    }

    /// The product with a rational number.
    #[must_use]
    pub fn scale(&self, factor: &Rational) -> Self {
        if *factor == Rational::ZERO {
            return Self::zero();
        }
        Self { terms: self.terms.iter().map(|(m, c)| (m.clone(), c * factor)).collect() }
    }

    /// The product of two polynomials whose degrees together stay below `u32::MAX`.
    ///
    /// Limited operations keep degrees at most `MAX_DEGREE`, so this holds for every product of a
    /// few of their results; for unbounded products use `Polynomial::try_mul`.
    #[must_use]
    pub fn mul(&self, other: &Self) -> Self {
        let (few, many) = if self.terms.len() <= other.terms.len() { (self, other) } else { (other, self) };
        Self { terms: product(&few.terms, &many.terms) }
    }

    /// The product, within the limits.
    ///
    /// # Errors
    /// [`LimitReached`] when the degree, the terms, the work or the bits pass their limit.
    pub fn try_mul(&self, other: &Self) -> Result<Self, LimitReached> {
        checked_degree(u64::from(self.degree()) + u64::from(other.degree()))?;
        let work = self.terms.len().saturating_mul(other.terms.len());
        within(Limit::Work, MAX_WORK, work)?;
        within(Limit::Bits, MAX_BITS, self.height_bits().saturating_add(other.height_bits()))?;
        let result = self.mul(other);
        within(Limit::Terms, MAX_TERMS, result.terms.len())?;
        Ok(result)
    }

    /// The power; the zeroth is 1, also of zero.
    ///
    /// # Errors
    /// [`LimitReached`] when the degree, the terms, the work or the bits pass their limit.
    pub fn pow(&self, exponent: u32) -> Result<Self, LimitReached> {
        let degree = u64::from(self.degree()) * u64::from(exponent);
        checked_degree(degree)?;
        let mut result = Self::one();
        for bit in (0..32 - exponent.leading_zeros()).rev() {
            result = result.try_mul(&result)?;
            if exponent >> bit & 1 == 1 {
                result = result.try_mul(self)?;
            }
        }
        Ok(result)
    }

    /// The coefficients with respect to one variable, by exponent, from 0 to the degree in it.
    ///
    /// The zero polynomial has the empty list.
    #[must_use]
    pub fn coefficients_in(&self, var: Var) -> Vec<Self> {
        if self.is_zero() {
            return Vec::new();
        }
        let mut lists = vec![Vec::new(); self.degree_in(var) as usize + 1];
        for (monomial, coefficient) in &self.terms {
            let (rest, exponent) = monomial.without(var);
            // Monomials with one exponent in common keep their order when that power is taken out.
            lists[exponent as usize].push((rest, coefficient.clone()));
        }
        lists.into_iter().map(|terms| Self { terms }).collect()
    }

    /// The coefficient of the highest power of one variable; 0 of the zero polynomial.
    #[must_use]
    pub(crate) fn leading_coefficient_in(&self, var: Var) -> Self {
        let degree = self.degree_in(var);
        let terms = self
            .terms
            .iter()
            .filter(|(m, _)| m.exponent(var) == degree)
            .map(|(m, c)| (m.without(var).0, c.clone()))
            .collect();
        Self { terms }
    }

    /// The polynomial `Σ cᵢ·varⁱ`.
    #[must_use]
    pub fn from_coefficients_in(var: Var, coefficients: &[Self]) -> Self {
        let terms = coefficients.iter().zip(0u32..).flat_map(|(poly, exponent)| {
            let power = Monomial::small_power(var, exponent);
            poly.terms.iter().map(move |(m, c)| (m.mul(&power), c.clone()))
        });
        Self::from_terms(terms)
    }

    /// The product with a monomial.
    #[must_use]
    pub(crate) fn mul_monomial(&self, monomial: &Monomial) -> Self {
        Self { terms: self.terms.iter().map(|(m, c)| (m.mul(monomial), c.clone())).collect() }
    }

    /// The partial derivative.
    #[must_use]
    pub fn derivative(&self, var: Var) -> Self {
        let terms = self.terms.iter().filter_map(|(monomial, coefficient)| {
            let (rest, exponent) = monomial.without(var);
            let lowered = exponent.checked_sub(1)?;
            let power = Monomial::small_power(var, lowered);
            Some((rest.mul(&power), coefficient * Rational::from(exponent)))
        });
        Self::from_terms(terms)
    }
}

/// Checks one count against its limit.
pub(super) fn within(limit: Limit, allowed: usize, needed: usize) -> Result<(), LimitReached> {
    if needed <= allowed {
        return Ok(());
    }
    Err(LimitReached { limit, allowed: allowed as u64, needed: needed as u64 })
}

/// The sum of two ordered lists of terms, ordered and without zeros.
fn merge(left: Vec<(Monomial, Rational)>, right: Vec<(Monomial, Rational)>) -> Vec<(Monomial, Rational)> {
    if left.is_empty() {
        return right;
    }
    if right.is_empty() {
        return left;
    }
    let mut sum = Vec::with_capacity(left.len() + right.len());
    let (mut left, mut right) = (left.into_iter().peekable(), right.into_iter().peekable());
    loop {
        let order = match (left.peek(), right.peek()) {
            (Some(a), Some(b)) => a.0.cmp(&b.0),
            (Some(_), None) => Ordering::Greater,
            (None, Some(_)) => Ordering::Less,
            (None, None) => return sum,
        };
        match order {
            Ordering::Greater => sum.extend(left.next()),
            Ordering::Less => sum.extend(right.next()),
            Ordering::Equal => {
                if let (Some((monomial, a)), Some((_, b))) = (left.next(), right.next()) {
                    let coefficient = a + b;
                    if coefficient != Rational::ZERO {
                        sum.push((monomial, coefficient));
                    }
                }
            }
        }
    }
}

/// The product of two ordered lists of terms: rows of products, merged in a balanced tree.
fn product(few: &[(Monomial, Rational)], many: &[(Monomial, Rational)]) -> Vec<(Monomial, Rational)> {
    match few {
        [] => Vec::new(),
        [(monomial, coefficient)] => many.iter().map(|(m, c)| (m.mul(monomial), c * coefficient)).collect(),
        _ => {
            let (upper, lower) = few.split_at(few.len() / 2);
            merge(product(upper, many), product(lower, many))
        }
    }
}

impl std::ops::Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: Self) -> Polynomial {
        Polynomial::add(self, other)
    }
}

impl std::ops::Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: Self) -> Polynomial {
        Polynomial::sub(self, other)
    }
}

impl std::ops::Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: Self) -> Polynomial {
        Polynomial::mul(self, other)
    }
}

impl std::ops::Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        Polynomial::neg(self)
    }
}
