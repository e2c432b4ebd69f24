//! Derivatives of fractions, by the rules for sums, products, powers, logarithms, cosines, sines and arcs.

use super::fraction::Fraction;
use super::term::{Atom, Over};
use super::{Checker, Reason, Refusal, rejected};
use std::collections::BTreeSet;

impl Checker {
    /// The derivative of c·∏ pᵢ^kᵢ by a variable: f·Σ kᵢ·pᵢ′/pᵢ.
    ///
    /// That the expression has a value at the point and around it is asked in [`super::defined`].
    pub(super) fn derivative(&mut self, f: &Fraction, by: &str, depth: usize) -> Result<Fraction, Refusal> {
        let Some(depth) = depth.checked_sub(1) else { return Err(Refusal::Limit("depth")) };
        let innermost = self.scope.iter().rev().find(|v| v.name == *by);
        let Some(variable) = innermost.filter(|v| !v.natural).map(|v| v.atom.clone()) else {
            return rejected(Reason::NotAReal(by.to_string()));
        };
        // A member of a sequence may depend on anything that the claim declares.
        if self.holds_atom(f, &|atom| matches!(atom, Atom::Member(name, _) if self.is_sequence(name)))? {
            return rejected(Reason::DerivativeOfMember);
        }
        let mut terms = Vec::new();
        for (poly, k) in &f.factors {
            let mut slope = Vec::new();
            let atoms: BTreeSet<usize> = poly.atoms().collect();
            for atom in atoms {
                let inner = self.atom_derivative(atom, &variable, by, depth)?;
                if !inner.is_zero() {
                    slope.push(Fraction::of(&poly.derivative(atom)).times(&inner, &self.work)?);
                }
            }
            let slope = Fraction::sum(&slope, &self.work)?;
            if slope.is_zero() {
                continue;
            }
            let mut term = slope.times(&Fraction::of(poly).power(-1)?, &self.work)?;
            term.multiply(&Fraction::integer(*k), &self.work)?;
            term.multiply(f, &self.work)?;
            terms.push(term);
        }
        Fraction::sum(&terms, &self.work)
    }

    fn atom_derivative(&mut self, place: usize, variable: &Atom, by: &str, depth: usize) -> Result<Fraction, Refusal> {
        if self.is_free_of(&Fraction::atom(place), variable)? {
            return Ok(Fraction::integer(0));
        }
        match self.atoms.get(place).cloned() {
            Some(Atom::Variable(_) | Atom::Growing(_) | Atom::Real(_)) => Ok(Fraction::integer(1)),
            Some(Atom::Logarithm(inner)) => {
                Ok(self.derivative(&inner, by, depth)?.times(&inner.power(-1)?, &self.work)?)
            }
            Some(Atom::Exponential(inner)) => {
                Ok(self.derivative(&inner, by, depth)?.times(&Fraction::atom(place), &self.work)?)
            }
            Some(Atom::Cosine(u)) => {
                let sine = Fraction::atom(self.intern(Atom::Sine(u.clone())));
                Ok(self.derivative(&u, by, depth)?.times(&sine.negated(), &self.work)?)
            }
            Some(Atom::Sine(u)) => {
                let cosine = Fraction::atom(self.intern(Atom::Cosine(u.clone())));
                Ok(self.derivative(&u, by, depth)?.times(&cosine, &self.work)?)
            }
            Some(ref arc @ (Atom::Arcsine(ref x) | Atom::Arctangent(ref x))) => {
                let slope = self.arc_derivative(x, matches!(arc, Atom::Arcsine(_)))?;
                Ok(self.derivative(x, by, depth)?.times(&slope, &self.work)?)
            }
            // Of a sum term by term: its ends are whole numbers, which do not move.
            Some(Atom::Over(over)) if over.sum => self.opened(|checker, own| {
                let body = checker.renamed(&over.body, Atom::Bound(over.own), Atom::Bound(own))?;
                let body = checker.derivative(&body, by, depth)?;
                checker.over_of(&Over { own, body, ..over })
            }),
            Some(Atom::Integral(integral)) => self.integral_derivative(&integral, variable, by, depth),
            Some(Atom::Power(base, exponent)) if self.is_free_of(&exponent, variable)? => {
                // (b^E)′ = E·b′/b·b^E.
                let mut out = self.derivative(&base, by, depth)?.times(&base.power(-1)?, &self.work)?;
                out.multiply(&exponent, &self.work)?;
                out.multiply(&Fraction::atom(place), &self.work)?;
                Ok(out)
            }
            Some(Atom::Power(base, exponent)) => {
                // b^E = exp(E·ln b), so (b^E)′ = (E′·ln b + E·b′/b)·b^E.
                let log = self.logarithm(&base)?;
                let first = self.derivative(&exponent, by, depth)?.times(&log, &self.work)?;
                let mut second = self.derivative(&base, by, depth)?.times(&base.power(-1)?, &self.work)?;
                second.multiply(&exponent, &self.work)?;
                Ok(Fraction::sum(&[first, second], &self.work)?.times(&Fraction::atom(place), &self.work)?)
            }
            _ => rejected(Reason::DerivativeOfMember),
        }
    }
}
