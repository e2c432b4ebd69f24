//! Polynomials in one variable with integer coefficients: their rational roots, the number and the
//! place of their real roots.
//!
//! Contract: a [`Univariate`] made from a rational polynomial differs from it by a positive factor,
//! so it has the same roots and the same sign everywhere. Counts and signs are exact.
//!
//! Method: Sturm's theorem counts the roots of the square-free part in an interval; rational roots
//! are found first, by lifting roots modulo a small prime, and divided out, so that bisection meets
//! only irrational roots and never stands on one.
//!
//! Limits: none; a caller that does not know the degree bounds it.
//!
//! Cost: a Sturm sequence of degree `n` takes `O(n²)` coefficient products, the coefficients being
//! subresultants of `O(n)` times the bits of the input; one count evaluates it twice.

use super::{Polynomial, Var};
use malachite::base::num::arithmetic::traits::{DivExact, Gcd, ModInverse};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Natural, Rational};
use std::cmp::Ordering;

/// A polynomial in one variable, low coefficients first, the last one not 0.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub struct Univariate {
    coefficients: Vec<Integer>,
}

impl Univariate {
    /// The polynomial with the given coefficients, low ones first.
    #[must_use]
    pub fn new(mut coefficients: Vec<Integer>) -> Self {
        while coefficients.last().is_some_and(|c| *c == Integer::ZERO) {
            coefficients.pop();
        }
        Self { coefficients }
    }

    /// A positive multiple, with coprime integer coefficients, of a polynomial in which at most the
    /// variable `var` occurs; `None` where another variable occurs.
    #[must_use]
    pub fn from_polynomial(p: &Polynomial, var: Var) -> Option<Self> {
        if p.is_zero() {
            return Some(Self::default());
        }
        let content = p.content();
        let mut coefficients = vec![Integer::ZERO; p.degree_in(var) as usize + 1];
        for (monomial, coefficient) in p.terms() {
            let (rest, exponent) = monomial.without(var);
            if !rest.is_one() {
                return None;
            }
            coefficients[exponent as usize] = integer(&(coefficient / &content));
        }
        Some(Self::new(coefficients))
    }

    /// The polynomial in the variable `var`.
    #[must_use]
    pub(crate) fn to_polynomial(&self, var: Var) -> Polynomial {
        let coefficients: Vec<Polynomial> =
            self.coefficients.iter().map(|c| Polynomial::constant(Rational::from(c))).collect();
        Polynomial::from_coefficients_in(var, &coefficients)
    }

    /// The coefficients, low ones first; none of the zero polynomial.
    #[must_use]
    pub fn coefficients(&self) -> &[Integer] {
        &self.coefficients
    }

    /// The degree; 0 of the zero polynomial.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// Whether this is the zero polynomial.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The sign at a rational point.
    #[must_use]
    pub fn sign_at(&self, x: &Rational) -> Ordering {
        // With x = n/d, d > 0, the sign is that of Σ cᵢ·nⁱ·d^(deg−i).
        let n = numerator(x);
        let d = Integer::from(x.denominator_ref());
        let mut sum = Integer::ZERO;
        let mut scale = Integer::ONE;
        for c in self.coefficients.iter().rev() {
            sum = sum * &n + c * &scale;
            scale *= &d;
        }
        sum.cmp(&Integer::ZERO)
    }

    /// The sign for all sufficiently large `x`.
    #[must_use]
    pub(crate) fn sign_at_infinity(&self) -> Ordering {
        self.coefficients.last().map_or(Ordering::Equal, |c| c.cmp(&Integer::ZERO))
    }

    /// The sign for all sufficiently small (very negative) `x`.
    #[must_use]
    pub(crate) fn sign_at_minus_infinity(&self) -> Ordering {
        let sign = self.sign_at_infinity();
        if self.degree() % 2 == 1 { sign.reverse() } else { sign }
    }

    /// The derivative.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let lowered = self.coefficients.iter().enumerate().skip(1);
        Self::new(lowered.map(|(i, c)| c * Integer::from(i as u64)).collect())
    }

    /// The number of sign changes among the non-zero coefficients: by Descartes' rule at least the
    /// number of positive roots with multiplicity, and of the same parity.
    #[must_use]
    pub fn sign_variations(&self) -> usize {
        variations(self.coefficients.iter().map(|c| c.cmp(&Integer::ZERO)))
    }

    /// The square-free part: the same roots, each once; the sign of the leading coefficient stays.
    #[must_use]
    pub(crate) fn square_free_part(&self) -> Self {
        let common = self.gcd(&self.derivative());
        if common.degree() == 0 {
            return self.primitive();
        }
        self.pseudo_divide(&common).0.primitive()
    }

    /// The greatest common divisor, primitive with positive leading coefficient.
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        // The general gcd reads most answers off integers; the remainder sequence has no limit.
        let general = super::gcd::gcd(&self.to_polynomial(0), &other.to_polynomial(0));
        if let Some(common) = general.ok().and_then(|g| Self::from_polynomial(&g, 0)) {
            return common;
        }
        let (mut p, mut q) = (self.primitive(), other.primitive());
        while !q.is_zero() {
            let rest = p.pseudo_divide(&q).1.primitive();
            p = q;
            q = rest;
        }
        if p.sign_at_infinity() == Ordering::Less { p.negated() } else { p }
    }

    /// The Sturm sequence: the polynomial, its derivative, and then the negated remainders, each up
    /// to a positive factor.
    #[must_use]
    pub(crate) fn sturm_sequence(&self) -> SturmSequence {
        let mut sequence = vec![self.primitive(), self.derivative().primitive()];
        while let [.., p, q] = sequence.as_slice() {
            if q.is_zero() {
                break;
            }
            let next = p.pseudo_divide(q).1.primitive().negated();
            sequence.push(next);
        }
        sequence.retain(|p| !p.is_zero());
        SturmSequence { sequence }
    }

    /// The rational roots in increasing order, each once; none of the zero polynomial.
    ///
    /// Why it is right: for a root `r` of the square-free part `f` with leading coefficient `l`,
    /// `l·r` is an integer of absolute value at most `l + max |cᵢ|` (Cauchy). A prime that divides
    /// neither `l` nor a value `f'(s)` at a root `s` of `f` modulo it has each such `s` lifted to
    /// exactly one root modulo each of its powers, so the balanced residue of `l·s` is `l·r` once
    /// the power exceeds twice the bound. Every candidate is tested exactly.
    #[must_use]
    pub fn rational_roots(&self) -> Vec<Rational> {
        self.square_free_part().rational_roots_if_square_free()
    }

    /// The rational roots of a square-free polynomial.
    pub(super) fn rational_roots_if_square_free(&self) -> Vec<Rational> {
        let mut roots = Vec::new();
        let mut f = self.clone();
        if f.degree() > 0 && f.coefficients.first() == Some(&Integer::ZERO) {
            roots.push(Rational::ZERO);
            f.coefficients.remove(0);
        }
        match f.coefficients.as_slice() {
            [] | [_] => {}
            [b, a] => roots.push(Rational::from_integers_ref(&-b, a)),
            _ => roots.extend(f.lifted_roots()),
        }
        roots.sort();
        roots
    }

    /// The rational roots of a square-free polynomial, by lifting.
    fn lifted_roots(&self) -> Vec<Rational> {
        let Some((prime, residues)) = self.simple_roots_modulo() else {
            return Vec::new();
        };
        let lead = self.coefficients.last().cloned().unwrap_or(Integer::ONE);
        let largest = self.coefficients.iter().map(Integer::unsigned_abs_ref).max().cloned();
        let bound = (lead.unsigned_abs_ref() + largest.unwrap_or(Natural::ONE)) << 1u32;
        let derivative = self.derivative();
        let mut found = Vec::new();
        for residue in residues {
            let mut modulus = Natural::from(prime);
            let mut root = Natural::from(residue);
            while modulus <= bound {
                modulus = &modulus * &modulus;
                let value = self.value_modulo(&root, &modulus);
                let slope = derivative.value_modulo(&root, &modulus);
                let Some(inverse) = slope.mod_inverse(&modulus) else {
                    break;
                };
                // Newton's step r − f(r)/f'(r).
                root = (root + (&modulus - value) * inverse) % &modulus;
            }
            let product = Integer::from(&root) * &lead;
            let shifted = balanced(&product, &modulus);
            let candidate = Rational::from_integers_ref(&shifted, &lead);
            if self.sign_at(&candidate) == Ordering::Equal {
                found.push(candidate);
            }
        }
        found
    }

    /// A prime modulo which the degree stays and all roots are simple, with these roots.
    fn simple_roots_modulo(&self) -> Option<(u64, Vec<u64>)> {
        let lead = self.coefficients.last()?;
        let derivative = self.derivative();
        let mut prime = 13u64;
        loop {
            let modulus = Natural::from(prime);
            if residue(lead, &modulus) != Natural::ZERO {
                let small = self.residues(prime);
                let slope = derivative.residues(prime);
                let roots: Vec<u64> = (0..prime).filter(|&x| horner(&small, x, prime) == 0).collect();
                if roots.iter().all(|&x| horner(&slope, x, prime) != 0) {
                    return Some((prime, roots));
                }
            }
            // Only divisors of the leading coefficient and the discriminant are unsuitable: finitely
            // many primes.
            prime = next_prime(prime)?;
        }
    }

    fn residues(&self, prime: u64) -> Vec<u64> {
        let modulus = Natural::from(prime);
        let small = |c| u64::try_from(&residue(c, &modulus)).unwrap_or(0);
        self.coefficients.iter().map(small).collect()
    }

    fn value_modulo(&self, x: &Natural, modulus: &Natural) -> Natural {
        let mut sum = Natural::ZERO;
        for c in self.coefficients.iter().rev() {
            sum = (sum * x + residue(c, modulus)) % modulus;
        }
        sum
    }

    /// A bound with all real roots strictly between its negative and itself.
    #[must_use]
    pub(crate) fn root_bound(&self) -> Rational {
        let Some((lead, lower)) = self.coefficients.split_last() else {
            return Rational::ONE;
        };
        // Cauchy: |x| < 1 + max |cᵢ/l|; the next power of two is kinder to bisection.
        let largest = lower.iter().map(Integer::unsigned_abs_ref).max().cloned();
        let ratio = largest.unwrap_or(Natural::ZERO) / lead.unsigned_abs_ref() + Natural::from(2u32);
        Rational::from(Natural::ONE << ratio.significant_bits())
    }

    /// The quotient and remainder of a positive multiple, that is, `m·self = q·divisor + r` with an
    /// integer `m > 0`. The divisor is not 0.
    fn pseudo_divide(&self, divisor: &Self) -> (Self, Self) {
        let Some((lead, lower)) = divisor.coefficients.split_last() else {
            return (Self::default(), self.clone());
        };
        let size = Integer::from(lead.unsigned_abs_ref());
        let negative = *lead < Integer::ZERO;
        let mut rest = self.coefficients.clone();
        let mut quotient: Vec<Integer> = Vec::new();
        while rest.len() > lower.len() {
            let Some(top) = rest.pop() else { break };
            let factor = if negative { -top } else { top };
            let shift = rest.len() - lower.len();
            for (i, c) in rest.iter_mut().enumerate() {
                *c *= &size;
                if let Some(part) = i.checked_sub(shift) {
                    *c -= &factor * &lower[part];
                }
            }
            for c in &mut quotient {
                *c *= &size;
            }
            quotient.push(factor);
        }
        quotient.reverse();
        (Self::new(quotient), Self::new(rest))
    }

    /// The polynomial divided by the (positive) gcd of its coefficients.
    fn primitive(&self) -> Self {
        let mut content = Natural::ZERO;
        for c in &self.coefficients {
            content = content.gcd(c.unsigned_abs_ref());
        }
        if content <= Natural::ONE {
            return self.clone();
        }
        let content = Integer::from(content);
        Self { coefficients: self.coefficients.iter().map(|c| c.div_exact(&content)).collect() }
    }

    /// The quotient by `d·x − n` for a root `n/d`.
    pub(super) fn without_root(&self, root: &Rational) -> Self {
        let linear = Self::new(vec![-numerator(root), Integer::from(root.denominator_ref())]);
        self.pseudo_divide(&linear).0.primitive()
    }

    fn negated(mut self) -> Self {
        for c in &mut self.coefficients {
            *c = -&*c;
        }
        self
    }
}

/// A Sturm sequence; see [`Univariate::sturm_sequence`].
#[derive(Clone, Debug)]
pub(crate) struct SturmSequence {
    sequence: Vec<Univariate>,
}

impl SturmSequence {
    /// The number of distinct real roots.
    #[must_use]
    pub(crate) fn count(&self) -> usize {
        let below = self.sequence.iter().map(Univariate::sign_at_minus_infinity);
        let above = self.sequence.iter().map(Univariate::sign_at_infinity);
        variations(below).saturating_sub(variations(above))
    }

    /// The number of distinct roots in the half-open interval `(a, b]`; an end that is `None` is
    /// infinite.
    ///
    /// Why it is right: Sturm's theorem in the form that holds for polynomials with multiple roots
    /// and for ends that are roots of a square-free polynomial. For a polynomial that is not
    /// square-free the ends must not be multiple roots.
    #[must_use]
    pub(crate) fn count_between(&self, a: Option<&Rational>, b: Option<&Rational>) -> usize {
        let below = a.map_or_else(
            || variations(self.sequence.iter().map(Univariate::sign_at_minus_infinity)),
            |x| variations(self.sequence.iter().map(|p| p.sign_at(x))),
        );
        let above = b.map_or_else(
            || variations(self.sequence.iter().map(Univariate::sign_at_infinity)),
            |x| variations(self.sequence.iter().map(|p| p.sign_at(x))),
        );
        below.saturating_sub(above)
    }
}

/// The number of changes in a sequence of signs, zeros left out.
fn variations(signs: impl Iterator<Item = Ordering>) -> usize {
    let mut last = Ordering::Equal;
    let mut count = 0;
    for sign in signs.filter(|&s| s != Ordering::Equal) {
        if last != Ordering::Equal && sign != last {
            count += 1;
        }
        last = sign;
    }
    count
}

/// The numerator with its sign.
fn numerator(x: &Rational) -> Integer {
    Integer::from_sign_and_abs(*x >= Rational::ZERO, x.numerator_ref().clone())
}

/// The value of an integer rational.
fn integer(x: &Rational) -> Integer {
    numerator(x)
}

/// The residue in `0..modulus`.
fn residue(c: &Integer, modulus: &Natural) -> Natural {
    let rest = c.unsigned_abs_ref() % modulus;
    if *c < Integer::ZERO && rest != Natural::ZERO { modulus - rest } else { rest }
}

/// The residue of smallest absolute value.
fn balanced(c: &Integer, modulus: &Natural) -> Integer {
    let rest = residue(c, modulus);
    if &rest + &rest > *modulus { Integer::from(rest) - Integer::from(modulus) } else { Integer::from(rest) }
}

fn horner(coefficients: &[u64], x: u64, prime: u64) -> u64 {
    coefficients.iter().rev().fold(0, |sum, &c| (sum * x + c) % prime)
}

/// The next prime below 2³¹.
fn next_prime(after: u64) -> Option<u64> {
    (after + 1..1 << 31).find(|&n| (2..).take_while(|d| d * d <= n).all(|d| n % d != 0))
}
