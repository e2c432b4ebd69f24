//! Derivatives of fractions by a variable.

use super::translate::Atom;
use super::{Draft, Failure, declined, rejected};
use crate::kernel::fraction::{Fraction, Poly};
use num_traits::One;

impl Draft {
    /// The derivative of c·∏ pᵢ^kᵢ by a variable: f·Σ kᵢ·pᵢ′/pᵢ.
    ///
    /// Where the expression has a value at a point it has one nearby, for divisors that are not 0 and
    /// bases that are positive stay so; there the rules of differentiation hold.
    pub(super) fn derivative(&mut self, f: &Fraction, by: &str, depth: usize) -> Result<Fraction, Failure> {
        let Some(depth) = depth.checked_sub(1) else { return declined("depth") };
        if self.variable(by).is_none_or(|v| v.natural) {
            return rejected("a derivative by what is not a real variable");
        }
        let dependence = self.dependence();
        self.work.count(self.replaced.len())?;
        if let Some(reason) = dependence {
            return rejected(&reason);
        }
        let mut terms = Vec::new();
        for (poly, k) in &f.factors {
            let mut slope = Vec::new();
            let atoms: std::collections::BTreeSet<usize> = poly.atoms().collect();
            for atom in atoms {
                let inner = self.atom_derivative(atom, by, depth)?;
                if !inner.is_zero() {
                    slope.push(Fraction::of(&poly.derivative(atom)).times(&inner, &self.work)?);
                }
            }
            let slope = Fraction::sum(&slope, &self.work)?;
            let mut term = slope.times(&Fraction::of(poly).power(-1)?, &self.work)?;
            term.multiply(&Fraction::integer(*k), &self.work)?;
            term.multiply(f, &self.work)?;
            terms.push(term);
        }
        Ok(Fraction::sum(&terms, &self.work)?)
    }

    fn atom_derivative(&mut self, place: usize, by: &str, depth: usize) -> Result<Fraction, Failure> {
        match self.atoms.get(place).cloned() {
            Some(Atom::Variable(name)) => Ok(Fraction::integer(i64::from(name == by))),
            Some(Atom::Logarithm(inner)) => {
                let slope = self.derivative(&Fraction::of(&inner), by, depth)?;
                Ok(slope.times(&self.present(&inner)?.power(-1)?, &self.work)?)
            }
            Some(Atom::Exponential(inner)) => {
                Ok(self.derivative(&inner, by, depth)?.times(&Fraction::atom(place), &self.work)?)
            }
            _ => rejected("a derivative of a member of a family, or of a sum or product over an index"),
        }
    }

    /// A polynomial with its atoms written as they are now.
    fn present(&mut self, poly: &Poly) -> Result<Fraction, Failure> {
        let mut terms = Vec::new();
        for (monomial, c) in poly.terms() {
            let mut term = Fraction::number(c.clone());
            for (atom, k) in monomial {
                term.multiply(&self.resolved(*atom).power(i64::from(*k))?, &self.work)?;
            }
            terms.push(term);
        }
        Ok(Fraction::sum(&terms, &self.work)?)
    }

    /// Why derivatives cannot be taken now: an atom is replaced by what equals it only where a
    /// hypothesis holds, so that it no longer shows what depends on what.
    fn dependence(&self) -> Option<String> {
        let always = |place: usize, value: &Fraction| {
            let log = |f: &Fraction| match f.factors.iter().next() {
                Some((poly, 1)) if f.factors.len() == 1 => poly.single_atom().and_then(|a| self.atoms.get(a)),
                _ => None,
            };
            match self.atoms.get(place) {
                // An index that stands for itself.
                Some(Atom::Variable(_)) if matches!(log(value), Some(Atom::Bound(_))) => true,
                // x = exp(ln x / k)^k.
                Some(Atom::Variable(_)) => {
                    value.coefficient.is_one()
                        && value.factors.len() == 1
                        && value.factors.iter().all(|(poly, k)| {
                            let Some(Atom::Exponential(inner)) = poly.single_atom().and_then(|a| self.atoms.get(a))
                            else {
                                return false;
                            };
                            let log = self.atom_index.get(&Atom::Logarithm(Poly::atom(place)));
                            let log = log.map(|log| Fraction::atom(*log));
                            log.is_some() && inner.times(&Fraction::integer(*k), &self.work).ok() == log
                        })
                }
                _ => false,
            }
        };
        let bad = self.replaced.iter().find(|r| !always(r.atom, &r.value));
        bad.map(|_| "a derivative where an atom is replaced by means of a hypothesis".to_string())
    }
}
