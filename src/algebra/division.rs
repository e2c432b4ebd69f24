//! Exact division of polynomials.
//!
//! Contract: a quotient is returned exactly when the divisor divides; there are no remainders here,
//! because in several variables they depend on the order of the monomials.

use super::{Monomial, Polynomial, Var};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

impl Polynomial {
    /// The quotient, where the divisor divides exactly; `None` otherwise and for the divisor 0.
    ///
    /// Why it is right: the leading term of a multiple of `d` is a multiple of the leading term of
    /// `d`, so the first remainder that violates this shows that `d` does not divide.
    ///
    /// Cost: terms of the quotient times terms of the divisor, with a logarithmic factor.
    #[must_use]
    pub fn exact_divide(&self, divisor: &Self) -> Option<Self> {
        let (lead, lead_coefficient) = divisor.leading_term()?;
        if self.is_zero() {
            return Some(Self::zero());
        }
        if divisor.terms.len() == 1 {
            let mut terms = Vec::with_capacity(self.terms.len());
            for (monomial, coefficient) in &self.terms {
                terms.push((monomial.checked_div(lead)?, coefficient / lead_coefficient));
            }
            return Some(Self { terms });
        }
        // Degrees add in a product, in each variable and at both ends of the order.
        self.terms.last()?.0.checked_div(&divisor.terms.last()?.0)?;
        let mut room: BTreeMap<Var, u32> = BTreeMap::new();
        for var in divisor.variables() {
            let left = self.degree_in(var).checked_sub(divisor.degree_in(var))?;
            room.insert(var, left);
        }
        let inverse = Rational::ONE / lead_coefficient;
        let mut remainder: BTreeMap<Monomial, Rational> = self.terms.iter().cloned().collect();
        let mut quotient = Vec::new();
        while let Some((monomial, coefficient)) = remainder.pop_last() {
            let factor = monomial.checked_div(lead)?;
            if room.iter().any(|(&var, &left)| factor.exponent(var) > left) {
                return None;
            }
            let scale = &coefficient * &inverse;
            for (m, c) in &divisor.terms[1..] {
                let change = c * &scale;
                let place = factor.mul(m);
                match remainder.entry(place) {
                    Entry::Vacant(empty) => {
                        empty.insert(-change);
                    }
                    Entry::Occupied(mut held) => {
                        *held.get_mut() -= change;
                        if *held.get() == Rational::ZERO {
                            held.remove();
                        }
                    }
                }
            }
            quotient.push((factor, scale));
        }
        Some(Self { terms: quotient })
    }
}
