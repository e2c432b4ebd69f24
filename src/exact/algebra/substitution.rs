//! Polynomials and numbers in the place of variables.
//!
//! Contract: substitution and evaluation are ring homomorphisms; all of them are exact. Putting
//! polynomials in is limited like a product, putting numbers in is not.

use super::polynomial::{MAX_TERMS, within};
use super::{Limit, LimitReached, Polynomial, Var};
use malachite::Rational;
use malachite::base::num::basic::traits::One;
use std::collections::BTreeMap;

impl Polynomial {
    /// The polynomial with one variable replaced, by Horner's rule.
    ///
    /// # Errors
    /// [`LimitReached`] when the degree, the terms, the work or the bits pass their limit.
    pub fn substitute(&self, var: Var, value: &Self) -> Result<Self, LimitReached> {
        if !self.contains(var) {
            return Ok(self.clone());
        }
        let mut result = Self::zero();
        for coefficient in self.coefficients_in(var).iter().rev() {
            result = result.try_mul(value)?.add(coefficient);
        }
        Ok(result)
    }

    /// The polynomial with several variables replaced at once; where `value` is `None`, the variable
    /// stays.
    ///
    /// # Errors
    /// [`LimitReached`] when the degree, the terms, the work or the bits pass their limit.
    pub fn substitute_all(&self, value: &dyn Fn(Var) -> Option<Self>) -> Result<Self, LimitReached> {
        let values: BTreeMap<Var, Self> = self.variables().into_iter().filter_map(|v| Some((v, value(v)?))).collect();
        let mut powers: BTreeMap<(Var, u32), Self> = BTreeMap::new();
        let mut sum = Self::zero();
        for (monomial, coefficient) in &self.terms {
            let mut product = Self::constant(coefficient.clone());
            for &(var, exponent) in monomial.powers() {
                let power = match powers.get(&(var, exponent)) {
                    Some(power) => power.clone(),
                    None => {
                        let base = values.get(&var).cloned().unwrap_or_else(|| Self::variable(var));
                        let power = base.pow(exponent)?;
                        powers.insert((var, exponent), power.clone());
                        power
                    }
                };
                product = product.try_mul(&power)?;
            }
            sum = sum.add(&product);
            within(Limit::Terms, MAX_TERMS, sum.terms.len())?;
        }
        Ok(sum)
    }

    /// The value at a point.
    #[must_use]
    pub fn evaluate(&self, value: &dyn Fn(Var) -> Rational) -> Rational {
        self.evaluate_some(&|var| Some(value(var))).constant_term()
    }

    /// The polynomial with some variables replaced by numbers; where `value` is `None`, the variable
    /// stays.
    #[must_use]
    pub fn evaluate_some(&self, value: &dyn Fn(Var) -> Option<Rational>) -> Self {
        let mut tables: BTreeMap<Var, Vec<Rational>> = BTreeMap::new();
        for var in self.variables() {
            if let Some(value) = value(var) {
                let mut powers = vec![Rational::ONE];
                for i in 0..self.degree_in(var) as usize {
                    powers.push(&powers[i] * &value);
                }
                tables.insert(var, powers);
            }
        }
        let terms = self.terms.iter().map(|(monomial, coefficient)| {
            let mut product = coefficient.clone();
            let mut kept = monomial.clone();
            for &(var, exponent) in monomial.powers() {
                if let Some(powers) = tables.get(&var) {
                    product *= &powers[exponent as usize];
                    kept = kept.without(var).0;
                }
            }
            (kept, product)
        });
        Self::from_terms(terms)
    }

    /// The polynomial with one variable replaced by a number.
    #[must_use]
    pub fn evaluate_at(&self, var: Var, value: &Rational) -> Self {
        self.evaluate_some(&|v| (v == var).then(|| value.clone()))
    }
}
