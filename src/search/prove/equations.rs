//! Equations: an equation from another one, and the value of a variable that an equation determines.

use super::draft::Rule;
use super::polynomials::{factored, from_algebra, to_algebra};
use super::write::multiplied;
use super::{Certifier, Fail};
use crate::certificate::Term;
use crate::claim::syntax::*;
use crate::kernel::fraction::{Fraction, Work};
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};
use crate::prove::draft::translate::Atom;
use num_rational::BigRational;
use std::collections::BTreeSet;

impl Certifier {
    /// An equation as a multiple of one that is known.
    pub(super) fn by_equations(&mut self, prop: &Prop, difference: &Fraction) -> Result<(), Fail> {
        let (top, bottom) = difference.parts(&Work::default()).map_err(Fail::from)?;
        let goal = to_algebra(&top)?;
        let list = self.facts();
        for (label, fact) in list.iter().rev() {
            if !matches!(&fact.kind, PropKind::Compare(_, r) if r.as_slice() == [Relation::Equal]) {
                continue;
            }
            let Ok((known, _)) = self.checker.difference(fact) else { continue };
            if known.is_zero() {
                continue;
            }
            let (p, q) = known.parts(&Work::default()).map_err(Fail::from)?;
            if let Some(quotient) = to_algebra(&p)?.exact_divide(&goal) {
                // D·goal = the fact.
                let times = multiplied(&from_algebra(&quotient)?, &Fraction::of(&bottom))?;
                let times = multiplied(&times, &Fraction::of(&q).power(-1).map_err(Fail::from)?)?;
                let times = self.fraction_expr(&times)?;
                let term = Term { facts: vec![label.clone()], factor: numeral(1) };
                if self.combination(prop.clone(), Some(times), vec![term]).is_ok() {
                    return Ok(());
                }
            }
            if let Some(quotient) = goal.exact_divide(&to_algebra(&p)?) {
                let factor = multiplied(&from_algebra(&quotient)?, &Fraction::of(&q))?;
                let factor = multiplied(&factor, &Fraction::of(&bottom).power(-1).map_err(Fail::from)?)?;
                let factor = self.fraction_expr(&factor)?;
                let term = Term { facts: vec![label.clone()], factor };
                if self.combination(prop.clone(), None, vec![term]).is_ok() {
                    return Ok(());
                }
            }
        }
        Err(Fail::No("no equation gives this"))
    }

    /// What follows from a comparison that is known: signs of factors, values of variables.
    pub(crate) fn exploit(&mut self, label: &str, prop: &Prop) -> Result<(), Fail> {
        let Ok((difference, relation)) = self.checker.difference(prop) else { return Ok(()) };
        let _ = self.take(Rule::Note, &[label.to_string()], None);
        let Ok((difference, _)) = self.checker.difference(prop).or(Ok::<_, Fail>((difference, relation))) else {
            return Ok(());
        };
        if difference.as_number().is_some() {
            return Ok(());
        }
        // Factors that the kernel does not see: the same fact, with its difference in factors.
        let mut whole = Fraction::number(difference.coefficient.clone());
        let mut changed = false;
        for (poly, k) in &difference.factors {
            let p = to_algebra(poly)?;
            let split = if p.term_count() > 120 { Fraction::of(poly) } else { factored(&p)? };
            changed |= split != Fraction::of(poly);
            whole = multiplied(&whole, &split.power(*k).map_err(Fail::from)?)?;
        }
        if changed && whole.factors.len() > 1 {
            for part in whole.factors.keys() {
                let signs = self.checker.poly_signs(part).map_err(Fail::from)?;
                if !signs.within(Signs::NOT_ZERO) && part.single_atom().is_none() {
                    let _ = self.attempt(|c| c.settle(part, 0));
                }
            }
        }
        let mut label = label.to_string();
        let mut prop = prop.clone();
        if changed {
            // Not where finer powers were introduced on the way, in which the factors are no longer written.
            let shown = self.fraction_expr(&whole).map(|whole| compare(whole, relation, numeral(0)));
            let term = Term { facts: vec![label.clone()], factor: numeral(1) };
            if let Ok(shown) = shown
                && let Ok(new) = self.combination(shown.clone(), None, vec![term])
            {
                label = new;
                prop = shown;
            }
        }
        if relation != Relation::Equal {
            return Ok(());
        }
        if whole.factors.len() > 1 || whole.factors.values().any(|k| *k > 1) {
            for part in whole.factors.keys() {
                if self.checker.poly_signs(part).map_err(Fail::from)?.within(Signs::ZERO) {
                    let shown = compare(self.poly_expr(part)?, Relation::Equal, numeral(0));
                    if let Ok(new) = self.take(Rule::Sign, &[], Some(shown.clone())) {
                        return self.determine(&new, &shown);
                    }
                }
            }
        }
        self.determine(&label, &prop)
    }

    /// Writes a variable by means of an equation that is linear in it.
    fn determine(&mut self, label: &str, prop: &Prop) -> Result<(), Fail> {
        let Ok((difference, _)) = self.checker.difference(prop) else { return Ok(()) };
        let mut open = Vec::new();
        let mut rest = Fraction::number(difference.coefficient.clone());
        for (p, k) in &difference.factors {
            let signs = self.checker.poly_signs(p).map_err(Fail::from)?;
            let one = Fraction::of(p).power(*k).map_err(Fail::from)?;
            let negative = p.terms().any(|t| *t.1 < BigRational::from_integer(0.into()));
            if signs.within(Signs::NOT_ZERO) && (!negative || *k < 0) {
                rest = multiplied(&rest, &one)?
            } else {
                open.push((p.clone(), *k))
            }
        }
        let [(poly, 1)] = open.as_slice() else { return Ok(()) };
        if !self.checker.signs_of(&rest).map_err(Fail::from)?.within(Signs::NOT_ZERO) {
            return Ok(());
        }
        let mut atoms: Vec<usize> = poly.atoms().collect::<BTreeSet<_>>().into_iter().collect();
        let order = |c: &Self, atom: usize| match c.checker.atom(atom) {
            Some(Atom::Variable(name)) => {
                c.checker.variables().iter().position(|v| v.name() == name && !v.is_natural()).map_or(0, |p| p + 1)
            }
            _ => 0,
        };
        atoms.sort_by_key(|a| std::cmp::Reverse((order(self, *a), *a)));
        for atom in atoms {
            let variable = match self.checker.atom(atom).cloned() {
                Some(Atom::Variable(variable)) if order(self, atom) > 0 => variable,
                Some(Atom::Member(..)) => String::new(),
                _ => continue,
            };
            let parts = poly.coefficients(atom);
            if parts.keys().any(|k| *k > 1) {
                continue;
            }
            let Some(slope) = parts.get(&1) else { continue };
            let slope = Fraction::of(slope);
            if !self.checker.signs_of(&slope).map_err(Fail::from)?.within(Signs::NOT_ZERO) {
                continue;
            }
            let constant = parts.get(&0).map_or(Fraction::integer(0), Fraction::of);
            let free = |f: &Fraction| {
                f.atoms().all(|a| a != atom)
                    && (variable.is_empty() || self.checker.is_free_of(f, &variable).is_ok_and(|free| free))
            };
            if !free(&slope) || !free(&constant) {
                continue;
            }
            let value = multiplied(&constant, &slope.power(-1).map_err(Fail::from)?)?.negated();
            let value = super::powers::simplified(&value)?;
            let shown = compare(self.atom_expr(atom)?, Relation::Equal, self.fraction_expr(&value)?);
            let factor = self.fraction_expr(&multiplied(&rest, &slope)?.power(-1).map_err(Fail::from)?)?;
            let new = if self.checker.knows(&shown) && text_of(prop) == text_of(&shown) {
                label.to_string()
            } else {
                match self.combination(shown, None, vec![Term { facts: vec![label.to_string()], factor }]) {
                    Ok(new) => new,
                    Err(_) => continue,
                }
            };
            if self.take(Rule::Replace, std::slice::from_ref(&new), None).is_err() {
                continue;
            }
            self.introduced.clear();
            // Values that mention the variable are written anew.
            for (label, other) in self.replaced.clone().into_iter().rev() {
                if other != variable && self.checker.fact(&label).is_ok() {
                    let _ = self.take(Rule::Replace, &[label], None);
                }
            }
            self.replaced.push((new, variable.clone()));
            return self.renote(&variable);
        }
        Ok(())
    }

    /// The simple facts that mention a variable; all where it has no name.
    fn facts_about(&self, variable: &str) -> Vec<(String, std::rc::Rc<Prop>)> {
        let mut list = self.facts();
        list.retain(|(_, fact)| {
            let mut names = BTreeSet::new();
            crate::kernel::names::names_in_prop(fact, &mut names);
            matches!(fact.kind, PropKind::Compare(..)) && (variable.is_empty() || names.contains(variable))
        });
        list
    }

    /// Notes again what mentions a variable that is written otherwise from now on, its powers introduced anew.
    fn renote(&mut self, variable: &str) -> Result<(), Fail> {
        for (label, fact) in self.facts_about(variable) {
            if let PropKind::Compare(sides, _) = &fact.kind {
                self.prepare(&sides.iter().collect::<Vec<_>>())?;
            }
            let _ = self.take(Rule::Note, &[label], None);
        }
        Ok(())
    }

    /// Has the kernel note once more the simple facts that mention a variable.
    pub(crate) fn note_again(&mut self, variable: &str) {
        for (label, _) in self.facts_about(variable) {
            let _ = self.take(Rule::Note, &[label], None);
        }
    }
}

fn text_of(prop: &Prop) -> String {
    crate::kernel::text::prop(prop)
}
