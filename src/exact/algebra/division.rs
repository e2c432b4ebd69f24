//! Contents and exact division of polynomials.
//!
//! Contract: a quotient is returned exactly when the divisor divides; there are no remainders here,
//! because in several variables they depend on the order of the monomials.

use super::polynomial::within;
use super::{Limit, LimitReached, Monomial, Polynomial, Var};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Gcd;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::IsInteger;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

impl Polynomial {
    /// The quotient, where the divisor divides exactly; `None` otherwise and for the divisor 0.
    ///
    /// It is unlimited, for divisors that are known to divide or small.
    ///
    /// Cost: terms of the quotient times terms of the divisor, with a logarithmic factor.
    #[must_use]
    pub fn exact_divide(&self, divisor: &Self) -> Option<Self> {
        self.divide_counted(divisor, usize::MAX, &mut 0).ok().flatten()
    }

    /// The quotient, counting products of terms in `work` up to `most`.
    ///
    /// Why it is right: the leading term of a multiple of `d` is a multiple of the leading term of
    /// `d`, so the first remainder that violates this shows that `d` does not divide. Degrees in
    /// each variable add in a product, and a quotient of a polynomial with integer coefficients by
    /// a primitive one has integer coefficients (Gauss); both end most failing divisions early.
    pub(super) fn divide_counted(
        &self,
        divisor: &Self,
        most: usize,
        work: &mut usize,
    ) -> Result<Option<Self>, LimitReached> {
        let Some((lead, lead_coefficient)) = divisor.leading_term() else {
            return Ok(None);
        };
        if self.is_zero() {
            return Ok(Some(Self::zero()));
        }
        if divisor.terms.len() == 1 {
            return Ok(self.divide_by_term(lead, lead_coefficient));
        }
        let Some(room) = self.room_above(divisor) else {
            return Ok(None);
        };
        let integral = self.terms.iter().all(|(_, c)| c.is_integer()) && divisor.content() == Rational::ONE;
        let inverse = Rational::ONE / lead_coefficient;
        let mut remainder: BTreeMap<Monomial, Rational> = self.terms.iter().cloned().collect();
        let mut quotient = Vec::new();
        while let Some((monomial, coefficient)) = remainder.pop_last() {
            let Some(factor) = monomial.checked_div(lead) else {
                return Ok(None);
            };
            let scale = &coefficient * &inverse;
            if integral && !scale.is_integer() || room.iter().any(|(&var, &left)| factor.exponent(var) > left) {
                return Ok(None);
            }
            *work = work.saturating_add(divisor.terms.len());
            within(Limit::Work, most, *work)?;
            for (m, c) in &divisor.terms[1..] {
                subtract(&mut remainder, factor.mul(m), c * &scale);
            }
            quotient.push((factor, scale));
        }
        Ok(Some(Self { terms: quotient }))
    }

    /// The quotient by a single term.
    fn divide_by_term(&self, monomial: &Monomial, coefficient: &Rational) -> Option<Self> {
        let mut terms = Vec::with_capacity(self.terms.len());
        for (m, c) in &self.terms {
            terms.push((m.checked_div(monomial)?, c / coefficient));
        }
        Some(Self { terms })
    }

    /// The degrees that a quotient may have; `None` where the ends or degrees exclude one.
    fn room_above(&self, divisor: &Self) -> Option<BTreeMap<Var, u32>> {
        self.terms.last()?.0.checked_div(&divisor.terms.last()?.0)?;
        let mut room = BTreeMap::new();
        for var in divisor.variables() {
            room.insert(var, self.degree_in(var).checked_sub(divisor.degree_in(var))?);
        }
        Some(room)
    }

    /// The positive rational that leaves coprime integer coefficients when divided out; 0 of zero.
    #[must_use]
    pub fn content(&self) -> Rational {
        let mut content = Rational::ZERO;
        for (_, coefficient) in &self.terms {
            content = (&content).gcd(coefficient);
        }
        content
    }

    /// The content with the sign of the leading coefficient, and the primitive part: coprime integer
    /// coefficients, the leading one positive. Their product is the polynomial; zero gives (0, 0).
    #[must_use]
    pub fn primitive_part(&self) -> (Rational, Self) {
        if self.is_zero() {
            return (Rational::ZERO, Self::zero());
        }
        let mut content = self.content();
        if self.leading_coefficient() < Rational::ZERO {
            content = -content;
        }
        if content == Rational::ONE {
            return (content, self.clone());
        }
        let terms = self.terms.iter().map(|(m, c)| (m.clone(), c / &content)).collect();
        (content, Self { terms })
    }

    /// The largest monomial that divides every term; 1 of the zero polynomial.
    #[must_use]
    pub(crate) fn monomial_content(&self) -> Monomial {
        let mut monomials = self.terms.iter().map(|(m, _)| m);
        let Some(first) = monomials.next() else {
            return Monomial::one();
        };
        let mut common = first.clone();
        for monomial in monomials {
            if common.is_one() {
                break;
            }
            common = common.gcd(monomial);
        }
        common
    }
}

/// Subtracts a term from a polynomial in progress.
fn subtract(remainder: &mut BTreeMap<Monomial, Rational>, monomial: Monomial, change: Rational) {
    match remainder.entry(monomial) {
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
