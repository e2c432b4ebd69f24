//! Polynomials that are 0 and may be added with any weight: what they span, and polynomials reduced by it.

use super::super::{Monomial, Polynomial};
use malachite::Rational;
use malachite::base::num::basic::traits::One;
use std::collections::BTreeMap;

/// Weights of polynomials, by their place.
type Weights = BTreeMap<usize, Rational>;

/// A polynomial whose leading coefficient is 1, as a sum of the given ones.
struct Member {
    lead: Monomial,
    poly: Polynomial,
    weights: Weights,
}

/// The span of some polynomials, in echelon form: no leading monomial occurs in another member.
pub(super) struct Span(Vec<Member>);

impl Span {
    pub(super) fn new(given: &[Polynomial]) -> Self {
        let mut span = Self(Vec::new());
        for (place, p) in given.iter().enumerate() {
            let (poly, weights) = span.divided(p);
            let Some((lead, c)) = poly.terms().next().map(|(m, c)| (m.clone(), c.clone())) else { continue };
            let unit = Rational::ONE / c;
            // p − Σ weights·given, over its leading coefficient.
            let mut weights: Weights = weights.into_iter().map(|(k, w)| (k, -w * &unit)).collect();
            weights.insert(place, unit.clone());
            let new = Member { lead, poly: poly.scale(&unit), weights };
            for old in &mut span.0 {
                let c = old.poly.coefficient(&new.lead);
                if c != 0 {
                    old.poly = old.poly.sub(&new.poly.scale(&c));
                    add(&mut old.weights, &new.weights, &-c);
                }
            }
            span.0.push(new);
        }
        span
    }

    /// A polynomial without the leading monomials of the span.
    pub(super) fn reduced(&self, p: &Polynomial) -> Polynomial {
        let taken_off = |p: Polynomial, m: &Member| match p.coefficient(&m.lead) {
            c if c == 0 => p,
            c => p.sub(&m.poly.scale(&c)),
        };
        self.0.iter().fold(p.clone(), taken_off)
    }

    /// The same, with the weights of the given polynomials in what was taken off.
    pub(super) fn divided(&self, p: &Polynomial) -> (Polynomial, Weights) {
        let mut weights = Weights::new();
        for member in &self.0 {
            // No other member changes this coefficient.
            add(&mut weights, &member.weights, &p.coefficient(&member.lead));
        }
        (self.reduced(p), weights)
    }
}

/// Adds a multiple of weights.
fn add(sum: &mut Weights, other: &Weights, factor: &Rational) {
    if *factor == 0 {
        return;
    }
    for (place, weight) in other {
        let entry = sum.entry(*place).or_default();
        *entry += weight * factor;
        if *entry == 0 {
            sum.remove(place);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_give_what_was_taken_off() {
        let [x, y] = [0, 1].map(Polynomial::variable);
        let given = [x.mul(&x).add(&y), x.mul(&y).sub(&Polynomial::one()), x.mul(&x).add(&x.mul(&y))];
        let span = Span::new(&given);
        let p = x.mul(&x).scale(&Rational::from(3)).add(&x.mul(&y)).add(&x);
        let (rest, weights) = span.divided(&p);
        let sum = weights.iter().fold(Polynomial::zero(), |s, (k, w)| s.add(&given[*k].scale(w)));
        assert_eq!(rest.add(&sum), p);
        assert!(rest.degree() < 2, "{rest}");
    }
}
