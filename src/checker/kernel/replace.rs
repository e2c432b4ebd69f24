//! Atoms of a fraction: where they occur, and others put in their places.

use super::fraction::Fraction;
use super::integral::Integral;
use super::known::Equation;
use super::substitution::DEPTH_LIMIT;
use super::term::{Atom, Over};
use super::{Checker, Refusal};
use std::collections::{BTreeMap, BTreeSet};

impl Checker {
    /// Whether a fraction is free of an atom, at any depth.
    pub(super) fn is_free_of(&self, f: &Fraction, atom: &Atom) -> Result<bool, Refusal> {
        match self.atom_index.get(atom) {
            Some(place) => Ok(!self.occurs(*place, f)?),
            None => Ok(true),
        }
    }

    /// Whether an atom occurs in a fraction, at any depth.
    pub(super) fn occurs(&self, atom: usize, f: &Fraction) -> Result<bool, Refusal> {
        for place in f.atoms() {
            self.work.count(1)?;
            if self.occurring.get(place).is_some_and(|inside| inside.binary_search(&atom).is_ok()) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether an atom of a kind occurs in a fraction, at any depth. Each atom is looked at once.
    pub(super) fn holds_atom(&self, f: &Fraction, kind: &dyn Fn(&Atom) -> bool) -> Result<bool, Refusal> {
        let mut open: Vec<usize> = f.atoms().collect();
        let mut seen = BTreeSet::new();
        while let Some(place) = open.pop() {
            if !seen.insert(place) {
                continue;
            }
            let before = open.len();
            let Some(atom) = self.atoms.get(place) else { continue };
            if kind(atom) {
                return Ok(true);
            }
            open.extend(atom.parts());
            self.work.count(1 + open.len() - before)?;
        }
        Ok(false)
    }

    /// A fraction with an atom replaced by what equals it, also inside other atoms: they are functions of what they
    /// are made of. Only the atoms of the value stay as they are, so that x = (x^(1/2))^2 can be put in.
    pub(super) fn replaced(&mut self, f: &Fraction, atom: usize, value: &Fraction) -> Result<Fraction, Refusal> {
        if !self.occurs(atom, f)? {
            return Ok(f.clone());
        }
        let mut done: BTreeMap<usize, Fraction> = value.atoms().map(|place| (place, Fraction::atom(place))).collect();
        done.remove(&atom);
        self.replaced_in(f, atom, value, &mut done, DEPTH_LIMIT)
    }

    /// A fraction with the atoms of equations replaced one after the other, and the places of those that occur.
    pub(super) fn all_replaced(
        &mut self,
        f: &Fraction,
        equations: &[Equation],
    ) -> Result<(Fraction, Vec<usize>), Refusal> {
        let (mut out, mut places) = (f.clone(), Vec::new());
        for equation in equations {
            let Some((atom, value)) = &equation.atom else { continue };
            let new = self.replaced(&out, *atom, value)?;
            if new != out {
                places.extend(&equation.rests_on);
                out = new;
            }
        }
        Ok((out, places))
    }

    fn replaced_in(
        &mut self,
        f: &Fraction,
        atom: usize,
        value: &Fraction,
        done: &mut BTreeMap<usize, Fraction>,
        depth: usize,
    ) -> Result<Fraction, Refusal> {
        let Some(depth) = depth.checked_sub(1) else { return Err(Refusal::Limit("depth")) };
        let atoms: BTreeSet<usize> = f.atoms().collect();
        let mut changed = Vec::new();
        for place in atoms {
            if !done.contains_key(&place) {
                let new = self.replaced_atom(place, atom, value, done, depth)?;
                done.insert(place, new);
            }
            if let Some(new) = done.get(&place).filter(|new| **new != Fraction::atom(place)) {
                changed.push((place, new.clone()));
            }
        }
        if changed.is_empty() {
            return Ok(f.clone());
        }
        let mut out = Fraction::number(f.coefficient.clone());
        for (poly, k) in &f.factors {
            let factor = if poly.atoms().any(|a| changed.iter().any(|c| c.0 == a)) {
                let mut terms = Vec::new();
                for (monomial, c) in poly.terms() {
                    let mut term = Fraction::number(c.clone());
                    for (place, power) in monomial {
                        let new = changed.iter().find(|c| c.0 == *place);
                        let base = new.map_or_else(|| Fraction::atom(*place), |c| c.1.clone());
                        term.multiply(&base.power(i64::from(*power))?, &self.work)?;
                    }
                    terms.push(term);
                }
                Fraction::sum(&terms, &self.work)?
            } else {
                Fraction::of(poly)
            };
            out.multiply(&factor.power(*k)?, &self.work)?;
        }
        Ok(out)
    }

    fn replaced_atom(
        &mut self,
        place: usize,
        atom: usize,
        value: &Fraction,
        done: &mut BTreeMap<usize, Fraction>,
        depth: usize,
    ) -> Result<Fraction, Refusal> {
        if place == atom {
            return Ok(value.clone());
        }
        let plain = Fraction::atom(place);
        if !self.occurs(atom, &plain)? {
            return Ok(plain);
        }
        let Some(found) = self.atoms.get(place).cloned() else { return Ok(plain) };
        let mut inner = |checker: &mut Checker, f: &Fraction| checker.replaced_in(f, atom, value, done, depth);
        match found {
            Atom::Variable(_) | Atom::Growing(_) | Atom::Bound(_) | Atom::Real(_) | Atom::Pi => Ok(plain),
            Atom::Member(name, index) => {
                let index = inner(self, &Fraction::of(&index))?;
                let index = self.whole(&index)?;
                Ok(self.atom_fraction(Atom::Member(name, index)))
            }
            Atom::Power(base, exponent) => {
                let (base, new) = (inner(self, &base)?, inner(self, &exponent)?);
                // As in `exponent_in`: a whole power stays one.
                let whole = self.is_whole(&exponent)? && !self.is_whole(&new)?;
                self.power(&base, if whole { &exponent } else { &new })
            }
            Atom::Exponential(log) => {
                let log = inner(self, &log)?;
                self.exponential(&log)
            }
            Atom::Logarithm(x) => {
                let x = inner(self, &x)?;
                self.logarithm(&x)
            }
            Atom::Cosine(u) => {
                let u = inner(self, &u)?;
                Ok(self.cosine_and_sine(&u)?.0)
            }
            Atom::Sine(u) => {
                let u = inner(self, &u)?;
                Ok(self.cosine_and_sine(&u)?.1)
            }
            Atom::Arcsine(x) => {
                let x = inner(self, &x)?;
                self.arc("arcsin", &x)
            }
            Atom::Arctangent(x) => {
                let x = inner(self, &x)?;
                self.arc("arctan", &x)
            }
            Atom::Integral(Integral { own: bound, from, to, body }) => {
                let (from, to) = (inner(self, &from)?, inner(self, &to)?);
                self.opened(|checker, own| {
                    let body = checker.renamed(&body, Atom::Real(bound), Atom::Real(own))?;
                    let body = inner(checker, &body)?;
                    checker.integral_of(own, from, to, &body)
                })
            }
            Atom::Over(over) => {
                let (from, to) = (inner(self, &Fraction::of(&over.from))?, inner(self, &Fraction::of(&over.to))?);
                let (from, to) = (self.whole(&from)?, self.whole(&to)?);
                self.opened(|checker, own| {
                    let body = checker.renamed(&over.body, Atom::Bound(over.own), Atom::Bound(own))?;
                    let body = inner(checker, &body)?;
                    checker.over_of(&Over { own, from, to, body, ..over })
                })
            }
        }
    }
}
