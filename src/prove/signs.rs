//! Comparisons: hints that let the kernel see the sign of a difference.

use super::draft::Rule;
use super::write::multiplied;
use super::{Certifier, Fail};
use crate::algebra::positivity::{self, Constraint};
use crate::algebra::{Polynomial, factor};
use crate::certificate::Term;
use crate::claim::syntax::*;
use crate::kernel::fraction::{Fraction, Poly, Work};
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, numeral};
use crate::prove::draft::translate::Atom;
use num_rational::BigRational;
use std::collections::BTreeSet;
use std::str::FromStr;

/// The kernel's polynomial as one of the engine's.
pub(crate) fn to_algebra(poly: &Poly) -> Result<Polynomial, Fail> {
    Ok(crate::refute::reading::to_algebra(poly).ok_or("too many atoms, or too high a degree")?)
}

/// The engine's polynomial as one of the kernel's.
pub(crate) fn from_algebra(p: &Polynomial) -> Result<Fraction, Fail> {
    let mut terms = Vec::new();
    for (monomial, c) in p.terms() {
        let c = BigRational::from_str(&c.to_string()).map_err(|_| "a number that cannot be read")?;
        let mut term = Fraction::number(c);
        for (atom, k) in monomial.powers() {
            term = multiplied(&term, &Fraction::atom(*atom as usize).power(i64::from(*k)).map_err(Fail::from)?)?;
        }
        terms.push(term);
    }
    Fraction::sum(&terms, &Work::default()).map_err(Fail::from)
}

/// The engine's polynomial, in factors.
pub(super) fn factored(p: &Polynomial) -> Result<Fraction, Fail> {
    let Ok(list) = factor::factor(p) else { return from_algebra(p) };
    let mut out =
        Fraction::number(BigRational::from_str(&list.unit.to_string()).map_err(|_| "a number that cannot be read")?);
    for (p, k) in &list.factors {
        out = multiplied(&out, &from_algebra(p)?.power(i64::from(*k)).map_err(Fail::from)?)?;
    }
    Ok(out)
}

/// A polynomial that a fact or an atom says is not negative.
struct Known {
    constraint: Constraint,
    /// The fact, if it comes from one.
    label: Option<String>,
    /// The factor: the constraint is this times the difference of the fact's sides, or just this without a fact.
    factor: Fraction,
}

impl Certifier {
    /// Shows a single comparison by signs.
    pub fn comparison(&mut self, a: &Expr, relation: Relation, b: &Expr) -> Result<(), Fail> {
        let prop = compare(a.clone(), relation, b.clone());
        self.prepare(&[a, b])?;
        self.unfold_all(&[a, b])?;
        if self.take(Rule::Sign, &[], Some(prop.clone())).is_ok() {
            return Ok(());
        }
        let (difference, _) = match self.checker.difference(&prop) {
            Ok(found) => found,
            Err(crate::prove::draft::Failure::Rejected(reason)) => {
                // Whether it has a value may depend on a sign that must be proved first.
                self.define(&[a, b])?;
                if self.take(Rule::Sign, &[], Some(prop.clone())).is_ok() {
                    return Ok(());
                }
                self.checker.difference(&prop).map_err(|_| Fail::Value(reason))?
            }
            Err(failure) => return Err(failure.into()),
        };
        let open: Vec<Poly> = difference
            .factors
            .iter()
            .filter(|(p, k)| {
                let signs = self.checker.poly_signs(p).unwrap_or(Signs::ANY).power(**k);
                !(signs.within(Signs::POSITIVE) || signs.within(Signs::of(Relation::Less)))
            })
            .map(|f| f.0.clone())
            .collect();
        for poly in &open {
            // The search may have found finer powers, in which this polynomial is no longer written.
            let _ = self.settle(poly, 3);
            if self.take(Rule::Sign, &[], Some(prop.clone())).is_ok() {
                return Ok(());
            }
        }
        if relation == Relation::Equal && self.by_equations(&prop, &difference).is_ok() {
            return Ok(());
        }
        Err(Fail::NotShown(crate::claim::print::prop(&prop)))
    }

    /// Proves the conditions under which these expressions have values: on divisors, bases and arguments of logarithms.
    pub fn define(&mut self, exprs: &[&Expr]) -> Result<(), Fail> {
        let mut list = Vec::new();
        exprs.iter().for_each(|e| needs(e, &mut list));
        for (e, relation) in list {
            let Ok(f) = self.checker.scalar(&e) else { continue };
            if self.checker.signs_of(&f).is_ok_and(|s| s.within(Signs::of(relation))) {
                continue;
            }
            let wanted = compare(e.clone(), relation, numeral(0));
            if self.checker.knows(&wanted) {
                continue;
            }
            let _ = self.attempt(|c| c.comparison(&e, relation, &numeral(0)));
            if relation == Relation::Greater {
                // A power needs the sign of each factor.
                for poly in f.factors.keys() {
                    let _ = self.settle(poly, 2);
                }
            }
        }
        self.prepare(exprs)
    }

    /// Finds the sign of a polynomial and notes it in the draft.
    pub fn settle(&mut self, poly: &Poly, depth: usize) -> Result<(), Fail> {
        let known = self.checker.poly_signs(poly).map_err(Fail::from)?;
        if known.within(Signs::POSITIVE) || known.within(Signs::of(Relation::Less)) || known.within(Signs::ZERO) {
            return Ok(());
        }
        let p = to_algebra(poly)?;
        if p.term_count() <= 300 && depth > 0 {
            let split = factored(&p)?;
            if split.factors.len() > 1 || split.factors.values().any(|k| *k > 1) {
                for part in split.factors.keys().cloned().collect::<Vec<_>>() {
                    self.settle(&part, depth - 1)?;
                }
                let signs = self.checker.signs_of(&split).map_err(Fail::from)?;
                if let Some(relation) = signs.relation() {
                    let prop = compare(self.poly_expr(poly)?, relation, numeral(0));
                    let factor = self.fraction_expr(&split)?;
                    self.combination(prop, None, vec![Term { facts: Vec::new(), factor }])?;
                }
                return Ok(());
            }
        }
        self.search(poly, &p)
    }

    /// The sign of a polynomial sought although one is known: facts may contradict each other.
    pub(crate) fn search_again(&mut self, poly: &Poly) -> Result<(), Fail> {
        let p = to_algebra(poly)?;
        self.search(poly, &p)
    }

    /// A certificate of positivity under the facts, as a combination.
    fn search(&mut self, poly: &Poly, p: &Polynomial) -> Result<(), Fail> {
        self.tick()?;
        let known = self.known(poly)?;
        let constraints: Vec<Constraint> = known.iter().map(|k| k.constraint.clone()).collect();
        let seen = guess_signs(p, &constraints);
        for (p, positive, in_vain) in [(p.clone(), true, seen.1), (p.neg(), false, seen.0)] {
            if in_vain {
                continue;
            }
            let limits = positivity::Limits::default();
            let weak = positivity::certify(&p, &constraints, &[], false, &limits);
            let Some(weak) = weak else { continue };
            let strict = positivity::certify(&p, &constraints, &[], true, &limits);
            for (found, is_strict) in [(strict, true), (Some(weak), false)] {
                let Some(positivity::Certificate::Combination { summands, .. }) = found else { continue };
                let relation = match (positive, is_strict) {
                    (true, true) => Relation::Greater,
                    (true, false) => Relation::GreaterEqual,
                    (false, true) => Relation::Less,
                    (false, false) => Relation::LessEqual,
                };
                let mut terms = Vec::new();
                for summand in &summands {
                    let weight = BigRational::from_str(&summand.weight.to_string()).map_err(|_| "a weight")?;
                    let mut factor = Fraction::number(if positive { weight } else { -weight });
                    let mut facts = Vec::new();
                    for (place, exponent) in &summand.constraints {
                        let k = known.get(*place).ok_or("a constraint")?;
                        factor = multiplied(&factor, &k.factor.power(i64::from(*exponent)).map_err(Fail::from)?)?;
                        if let Some(label) = &k.label {
                            facts.extend(std::iter::repeat_n(label.clone(), *exponent as usize));
                        }
                    }
                    for square in &summand.squares {
                        factor = multiplied(&factor, &from_algebra(square)?.power(2).map_err(Fail::from)?)?;
                    }
                    terms.push(Term { facts, factor: self.fraction_expr(&factor)? });
                }
                let prop = compare(self.poly_expr(poly)?, relation, numeral(0));
                if self.combination(prop, None, terms).is_ok() {
                    return Ok(());
                }
            }
        }
        Ok(())
    }

    /// What is known of signs around a polynomial, as constraints.
    fn known(&mut self, poly: &Poly) -> Result<Vec<Known>, Fail> {
        let mut near: BTreeSet<usize> = poly.atoms().collect();
        let mut facts: Vec<(String, Fraction, Relation)> = Vec::new();
        let list = self.facts();
        for (label, prop) in list.iter().rev() {
            if !matches!(&prop.kind, PropKind::Compare(_, r) if r.len() == 1 && r.first() != Some(&Relation::NotEqual))
            {
                continue;
            }
            let Ok((difference, relation)) = self.checker.difference(prop) else { continue };
            if difference.is_zero() {
                continue;
            }
            facts.push((label.clone(), difference, relation));
        }
        let mut chosen: Vec<(Fraction, Known)> = Vec::new();
        let mut more = BTreeSet::new();
        for pass in 0..2 {
            for (label, difference, relation) in &facts {
                let mut open = Fraction::integer(1);
                let mut rest = Fraction::number(difference.coefficient.clone());
                for (p, k) in &difference.factors {
                    let signs = self.checker.poly_signs(p).map_err(Fail::from)?.power(*k);
                    // What the fact itself says is not what is known without it.
                    let settled = signs.within(Signs::POSITIVE) || signs.within(Signs::of(Relation::Less));
                    let open_terms = p.terms().any(|t| *t.1 < BigRational::from_integer(0.into()))
                        || p.atoms().any(|a| {
                            !self.checker.poly_signs(&Poly::atom(a)).is_ok_and(|s| s.within(Signs::NOT_NEGATIVE))
                        });
                    let keep = !settled || (*k == 1 && p.single_atom().is_none() && open_terms);
                    let one = Fraction::of(p).power(*k).map_err(Fail::from)?;
                    if keep { open = multiplied(&open, &one)? } else { rest = multiplied(&rest, &one)? }
                }
                if open.factors.values().any(|k| *k < 0) || open.factors.is_empty() {
                    continue;
                }
                let Ok(expanded) = open.expanded(&Work::default()) else { continue };
                if expanded.terms().count() > 60 {
                    continue;
                }
                let inside = expanded.atoms().all(|a| near.contains(&a));
                if !inside {
                    if pass == 0 && expanded.atoms().any(|a| near.contains(&a)) {
                        more.extend(expanded.atoms());
                    }
                    continue;
                }
                let signs = self.checker.signs_of(&rest).map_err(Fail::from)?;
                let positive = signs.within(Signs::POSITIVE);
                if !positive && !signs.within(Signs::of(Relation::Less)) {
                    continue;
                }
                let wanted = match relation {
                    Relation::Greater => vec![(true, true)],
                    Relation::GreaterEqual => vec![(true, false)],
                    Relation::Less => vec![(false, true)],
                    Relation::LessEqual => vec![(false, false)],
                    _ => vec![(true, false), (false, false)],
                };
                for (up, strict) in wanted {
                    // ±open = (x − y)/|rest|, up to the direction.
                    let same = up == positive;
                    let base = to_algebra(&expanded)?;
                    let constraint = Constraint { poly: if same { base } else { base.neg() }, strict };
                    let inverse = rest.power(-1).map_err(Fail::from)?;
                    let factor = if same { inverse } else { inverse.negated() };
                    if chosen.iter().any(|c| c.1.constraint == constraint) {
                        continue;
                    }
                    chosen.push((open.clone(), Known { constraint, label: Some(label.clone()), factor }));
                }
            }
            if pass == 0 {
                if chosen.len() >= 6 || near.len() + more.len() > 14 {
                    break;
                }
                near.extend(more.iter().copied());
            }
        }
        chosen.truncate(14);
        let mut out: Vec<Known> = chosen.into_iter().map(|c| c.1).collect();
        let used: BTreeSet<usize> =
            poly.atoms().chain(out.iter().flat_map(|k| k.constraint.poly.variables()).map(|v| v as usize)).collect();
        for atom in used {
            let signs = self.checker.poly_signs(&Poly::atom(atom)).map_err(Fail::from)?;
            let base = Polynomial::variable(u32::try_from(atom).map_err(|_| "too many atoms")?);
            if signs.within(Signs::NOT_NEGATIVE) {
                let strict = signs.within(Signs::POSITIVE);
                let constraint = Constraint { poly: base, strict };
                if !out.iter().any(|k| k.constraint.poly == constraint.poly && (k.constraint.strict || !strict)) {
                    out.push(Known { constraint, label: None, factor: Fraction::atom(atom) });
                }
            }
        }
        Ok(out)
    }

    /// An equation as a multiple of one that is known.
    fn by_equations(&mut self, prop: &Prop, difference: &Fraction) -> Result<(), Fail> {
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

    /// Solves an equation for a variable in which it is linear, and replaces the variable.
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
            crate::kernel::statement::names_in_prop(fact, &mut names);
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

    /// Splits members off sums, products and sequences, so that equal ones are written alike.
    pub(crate) fn unfold_all(&mut self, exprs: &[&Expr]) -> Result<(), Fail> {
        self.unfold_within(exprs, 40)
    }

    fn unfold_within(&mut self, exprs: &[&Expr], depth: usize) -> Result<(), Fail> {
        for _ in 0..depth {
            let mut atoms = BTreeSet::new();
            for e in exprs {
                if let Ok(crate::prove::draft::translate::Value::Scalar(f)) = self.checker.value(e, 300) {
                    atoms.extend(f.atoms());
                }
            }
            let mut changed = false;
            for atom in atoms {
                if let Some((left, right)) = self.unfolding(atom)? {
                    let prop = compare(left, Relation::Equal, right.clone());
                    let done = self.attempt(|c| {
                        let label = c.take(Rule::Unfold, &[], Some(prop))?;
                        // What is replaced is not looked at again: the right side has to be unfolded first.
                        c.unfold_within(&[&right], depth - 1)?;
                        c.take(Rule::Replace, &[label], None)
                    });
                    changed |= done.is_ok();
                }
            }
            if !changed {
                return Ok(());
            }
        }
        Ok(())
    }

    /// An atom as what it unfolds to, where its index has a positive constant part.
    fn unfolding(&mut self, atom: usize) -> Result<Option<(Expr, Expr)>, Fail> {
        use crate::kernel::statement::Substitution;
        let constant =
            |p: &Poly| p.terms().find(|t| t.0.is_empty()).map_or(BigRational::from_integer(0.into()), |t| t.1.clone());
        let zero = BigRational::from_integer(0.into());
        let shifted = |p: &Poly, by: i64| {
            let sum = Fraction::sum(&[Fraction::of(p), Fraction::integer(by)], &Work::default());
            sum.and_then(|f| f.expanded(&Work::default())).map_err(Fail::from)
        };
        match self.checker.atom(atom).cloned() {
            Some(Atom::Member(name, index)) => {
                let statement = self.checker.statement().clone();
                let Some(u) = statement.sequences.iter().find(|s| s.name == name) else { return Ok(None) };
                let left = self.atom_expr(atom)?;
                if index.terms().next().is_none() {
                    return Ok(Some((left, u.initial.clone())));
                }
                if constant(&index) <= zero {
                    return Ok(None);
                }
                let before = self.poly_expr(&shifted(&index, -1)?)?;
                let mut map = Substitution::default();
                map.replace(&u.index, &before);
                Ok(Some((left, map.expr(&u.step).map_err(Fail::from)?)))
            }
            Some(Atom::Over(is_sum, _, from, to, _)) => {
                let left = self.atom_expr(atom)?;
                let (ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body)) = &left.kind else {
                    return Ok(None);
                };
                let length = Fraction::of(&shifted(&to, 1)?)
                    .minus(&Fraction::of(&from), &Work::default())
                    .map_err(Fail::from)?;
                if length.is_zero() {
                    return Ok(Some((left.clone(), numeral(u32::from(!is_sum)))));
                }
                let over = |index: Index| {
                    let body = body.clone();
                    expr(if is_sum { ExprKind::SumOver(index, body) } else { ExprKind::ProductOver(index, body) })
                };
                let at = |e: &Expr| -> Result<Expr, Fail> {
                    let mut map = Substitution::default();
                    map.replace(&index.name.text, e);
                    map.expr(body).map_err(Fail::from)
                };
                let joined = |rest: Expr, one: Expr| {
                    if is_sum {
                        expr(ExprKind::Sum(vec![(Sign::Plus, rest), (Sign::Plus, one)]))
                    } else {
                        expr(ExprKind::Product(vec![(Factor::Times, rest), (Factor::Times, one)]))
                    }
                };
                if constant(&to) > zero {
                    let shorter = Index { to: Box::new(self.poly_expr(&shifted(&to, -1)?)?), ..index.clone() };
                    return Ok(Some((left.clone(), joined(over(shorter), at(&index.to)?))));
                }
                if from.terms().next().is_none() {
                    let later = Index { from: Box::new(numeral(1)), ..index.clone() };
                    return Ok(Some((left.clone(), joined(over(later), at(&index.from)?))));
                }
                Ok(None)
            }
            _ => Ok(None),
        }
    }
}

fn text_of(prop: &Prop) -> String {
    crate::kernel::text::prop(prop)
}

/// The conditions under which an expression has a value, innermost first.
fn needs(e: &Expr, out: &mut Vec<(Expr, Relation)>) {
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => {}
        ExprKind::Apply(f, list) => {
            list.iter().for_each(|e| needs(e, out));
            if let ("sqrt" | "cbrt" | "ln", Some(x)) = (f.text.as_str(), list.first()) {
                out.push((x.clone(), Relation::Greater));
            }
        }
        ExprKind::Negate(a) => needs(a, out),
        ExprKind::Sum(list) => list.iter().for_each(|(_, e)| needs(e, out)),
        ExprKind::Product(list) => {
            for (factor, e) in list {
                needs(e, out);
                if *factor == Factor::Over {
                    out.push((e.clone(), Relation::NotEqual));
                }
            }
        }
        ExprKind::Power(a, b) => {
            needs(a, out);
            needs(b, out);
            if !matches!(&b.kind, ExprKind::Number(text) if text.bytes().all(|b| b.is_ascii_digit())) {
                out.push((
                    (**a).clone(),
                    if matches!(b.kind, ExprKind::Negate(_)) { Relation::NotEqual } else { Relation::Greater },
                ));
            }
        }
        ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) => {
            needs(&index.from, out);
            needs(&index.to, out);
        }
        ExprKind::Derivative(body, _) => needs(body, out),
        ExprKind::Matrix(rows) => rows.iter().flatten().for_each(|e| needs(e, out)),
    }
}

/// Whether the polynomial takes positive values, and negative values, at sampled points that satisfy the constraints
/// strictly. It works in floating point and is only a hint which searches are futile.
fn guess_signs(p: &Polynomial, constraints: &[Constraint]) -> (bool, bool) {
    use malachite::base::num::conversion::traits::RoundingFrom;
    use malachite::base::rounding_modes::RoundingMode;
    type Terms = Vec<(Vec<(u32, i32)>, f64)>;
    let terms = |p: &Polynomial| -> Terms {
        p.terms()
            .map(|(m, c)| {
                let powers = m.powers().iter().map(|&(v, k)| (v, i32::try_from(k).unwrap_or(i32::MAX))).collect();
                (powers, f64::rounding_from(c, RoundingMode::Nearest).0)
            })
            .collect()
    };
    let variables: BTreeSet<u32> =
        p.variables().into_iter().chain(constraints.iter().flat_map(|c| c.poly.variables())).collect();
    let order: Vec<u32> = variables.into_iter().collect();
    let value = |terms: &Terms, point: &[f64]| -> f64 {
        let (sum, size) = terms.iter().fold((0.0, 0.0), |(sum, size), (powers, c)| {
            let term = powers
                .iter()
                .fold(*c, |t, &(v, k)| t * order.binary_search(&v).map_or(1.0, |place| point[place]).powi(k));
            (sum + term, size + f64::abs(term))
        });
        if f64::abs(sum) > size * 1e-9 { sum } else { 0.0 }
    };
    let limits: Vec<Terms> = constraints.iter().filter(|c| !c.poly.is_zero()).map(|c| terms(&c.poly)).collect();
    let goal = terms(p);
    let (mut positive, mut negative) = (false, false);
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    for _ in 0..400 {
        let point: Vec<f64> = order
            .iter()
            .map(|_| {
                state ^= state << 13;
                state ^= state >> 7;
                state ^= state << 17;
                const VALUES: [f64; 8] = [0.1, 0.4, 0.8, 0.97, 1.05, 1.3, 2.5, 8.0];
                let size = VALUES[(state >> 40) as usize % 8] * (1.0 + ((state >> 20) % 97) as f64 / 1000.0);
                if state & 7 == 1 { -size } else { size }
            })
            .collect();
        if limits.iter().any(|c| value(c, &point) <= 0.0) {
            continue;
        }
        let v = value(&goal, &point);
        positive |= v > 0.0;
        negative |= v < 0.0;
    }
    (positive, negative)
}
