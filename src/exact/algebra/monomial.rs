//! Monomials: products of powers of variables, in graded lexicographic order.
//!
//! Contract: a monomial holds its variables in increasing number, every exponent is at least 1, and
//! its total degree is stored beside them and is at most [`MAX_DEGREE`]. The order compares total
//! degrees first and breaks ties lexicographically with variable 0 the largest; it is a monomial
//! order: `a < b` implies `a·c < b·c`, which polynomial division relies on.
//!
//! Cost: every operation is linear in the number of variables that occur.

use super::{Limit, LimitReached, Var};
use std::cmp::Ordering;

/// The largest total degree of a monomial.
pub(crate) const MAX_DEGREE: u32 = 50_000;

/// A product of powers of variables.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub struct Monomial {
    degree: u32,
    powers: Vec<(Var, u32)>,
}

impl Monomial {
    /// The empty product, 1.
    #[must_use]
    pub fn one() -> Self {
        Self::default()
    }

    /// The variable itself.
    #[must_use]
    pub fn variable(var: Var) -> Self {
        Self { degree: 1, powers: vec![(var, 1)] }
    }

    /// The product of the given powers, in any order; equal variables are multiplied together.
    ///
    /// # Errors
    /// [`LimitReached`] when the total degree would pass `MAX_DEGREE`.
    pub fn new(powers: &[(Var, u32)]) -> Result<Self, LimitReached> {
        let total: u64 = powers.iter().map(|&(_, e)| u64::from(e)).sum();
        let degree = checked_degree(total)?;
        let mut sorted: Vec<(Var, u32)> = powers.iter().copied().filter(|&(_, e)| e > 0).collect();
        sorted.sort_unstable();
        let mut merged: Vec<(Var, u32)> = Vec::with_capacity(sorted.len());
        for (var, exponent) in sorted {
            match merged.last_mut() {
                Some(last) if last.0 == var => last.1 += exponent,
                _ => merged.push((var, exponent)),
            }
        }
        Ok(Self { degree, powers: merged })
    }

    /// The power `var^exponent` for an exponent that is known to be within the limit.
    pub(super) fn small_power(var: Var, exponent: u32) -> Self {
        match exponent {
            0 => Self::one(),
            _ => Self { degree: exponent, powers: vec![(var, exponent)] },
        }
    }

    /// Whether this is the empty product.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.powers.is_empty()
    }

    /// The sum of the exponents.
    #[must_use]
    pub fn degree(&self) -> u32 {
        self.degree
    }

    /// The exponent of one variable, 0 where it does not occur.
    #[must_use]
    pub fn exponent(&self, var: Var) -> u32 {
        self.powers.iter().find(|&&(v, _)| v == var).map_or(0, |&(_, e)| e)
    }

    /// The variables with their exponents, variables increasing, exponents at least 1.
    #[must_use]
    pub fn powers(&self) -> &[(Var, u32)] {
        &self.powers
    }

    /// The product of two monomials whose degrees together stay below `u32::MAX`.
    pub(super) fn mul(&self, other: &Self) -> Self {
        if other.powers.is_empty() {
            return self.clone();
        }
        if self.powers.is_empty() {
            return other.clone();
        }
        let mut powers = Vec::with_capacity(self.powers.len() + other.powers.len());
        let (mut left, mut right) = (self.powers.iter().peekable(), other.powers.iter().peekable());
        loop {
            match (left.peek(), right.peek()) {
                (Some(&&(a, e)), Some(&&(b, f))) => match a.cmp(&b) {
                    Ordering::Less => {
                        powers.push((a, e));
                        left.next();
                    }
                    Ordering::Greater => {
                        powers.push((b, f));
                        right.next();
                    }
                    Ordering::Equal => {
                        powers.push((a, e + f));
                        left.next();
                        right.next();
                    }
                },
                (Some(&&power), None) | (None, Some(&&power)) => {
                    powers.push(power);
                    left.next();
                    right.next();
                }
                (None, None) => break,
            }
        }
        Self { degree: self.degree + other.degree, powers }
    }

    /// The quotient, where the divisor divides.
    #[must_use]
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        if divisor.degree > self.degree {
            return None;
        }
        let mut powers = Vec::with_capacity(self.powers.len());
        let mut rest = divisor.powers.iter().peekable();
        for &(var, exponent) in &self.powers {
            match rest.peek() {
                Some(&&(v, e)) if v == var => {
                    rest.next();
                    let left = exponent.checked_sub(e)?;
                    if left > 0 {
                        powers.push((var, left));
                    }
                }
                Some(&&(v, _)) if v < var => return None,
                _ => powers.push((var, exponent)),
            }
        }
        if rest.peek().is_some() {
            return None;
        }
        Some(Self { degree: self.degree - divisor.degree, powers })
    }

    /// The greatest common divisor: the smaller exponent of each variable.
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        let mut degree = 0;
        let mut powers = Vec::new();
        for &(var, exponent) in &self.powers {
            let common = exponent.min(other.exponent(var));
            if common > 0 {
                degree += common;
                powers.push((var, common));
            }
        }
        Self { degree, powers }
    }

    /// The monomial with one variable taken out, and the exponent that it had.
    #[must_use]
    pub fn without(&self, var: Var) -> (Self, u32) {
        let exponent = self.exponent(var);
        if exponent == 0 {
            return (self.clone(), 0);
        }
        let powers = self.powers.iter().copied().filter(|&(v, _)| v != var).collect();
        (Self { degree: self.degree - exponent, powers }, exponent)
    }

    /// The monomial as text, 1 as the empty string.
    pub(super) fn text(&self, name: &dyn Fn(Var) -> String) -> String {
        let parts: Vec<String> = self
            .powers
            .iter()
            .map(|&(var, exponent)| match exponent {
                1 => name(var),
                _ => format!("{}^{exponent}", name(var)),
            })
            .collect();
        parts.join("*")
    }
}

/// The degree as a `u32`, or the limit that it passes.
pub(super) fn checked_degree(total: u64) -> Result<u32, LimitReached> {
    match u32::try_from(total) {
        Ok(degree) if degree <= MAX_DEGREE => Ok(degree),
        _ => Err(LimitReached { limit: Limit::Degree, allowed: u64::from(MAX_DEGREE), needed: total }),
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        self.degree.cmp(&other.degree).then_with(|| {
            for (&(a, e), &(b, f)) in self.powers.iter().zip(&other.powers) {
                // The monomial that holds the smaller variable number is the larger one.
                match b.cmp(&a).then(e.cmp(&f)) {
                    Ordering::Equal => {}
                    decided => return decided,
                }
            }
            // Equal degrees and one a prefix of the other: both ended together.
            Ordering::Equal
        })
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
