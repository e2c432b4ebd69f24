//! The first facts: the domains and hypotheses of a claim, and that its sequences have values.

use super::fraction::Poly;
use super::known::Known;
use super::names::names_in;
use super::order::Signs;
use super::statement::{Sequence, Statement};
use super::term::Atom;
use super::tree::parts;
use super::{Checker, Reason, Refusal, cited, quantifier, rejected, statement};
use crate::certificate::Label;
use crate::claim::definedness::is_natural;
use crate::claim::syntax::*;
use std::collections::BTreeSet;

impl Checker {
    /// Declares what the claim declares, and takes its domains and hypotheses as facts. A hypothesis is understood to
    /// say of its own expressions that they have values.
    pub(super) fn hypotheses(&mut self) -> Result<(), Refusal> {
        let statement = self.statement.clone();
        for binding in &statement.bindings {
            self.declare_binding(binding)?;
        }
        // A sequence speaks of what the claim declares, never of a variable that a block introduces later, nor of a
        // sequence that is defined after it; and of itself only by the member before.
        for (place, u) in statement.sequences.iter().enumerate() {
            let mut names = BTreeSet::new();
            names_in(&u.step, &mut names);
            names.remove(&u.index);
            names_in(&u.initial, &mut names);
            let known = |n: &String| self.is_declared(n) || is_built_in(n) || n == PI;
            if let Some(free) = names.iter().find(|n| !known(n)) {
                return rejected(Reason::Undeclared(free.clone()));
            }
            let later = statement.sequences.iter().skip(place + 1).any(|v| names.contains(&v.name));
            let mut first = BTreeSet::new();
            names_in(&u.initial, &mut first);
            if later || first.contains(&u.name) || !statement::steps_once(&u.step, &u.name, &u.index) {
                return rejected(Reason::Sequence(u.name.clone()));
            }
        }
        self.moving_variables_are_free()?;
        let domains = statement.bindings.iter().flat_map(quantifier::domains);
        for prop in domains.chain(statement.assumptions.iter().cloned()) {
            let label = format!("h{}", self.facts.len() + 1);
            self.know(&label, prop)?;
        }
        self.begin_at_naturals(&statement)?;
        // Every member has a value, so that a member is one wherever its index is a natural number.
        let all: Vec<Label> = self.facts.iter().map(|f| f.label.clone()).collect();
        for u in &statement.sequences {
            let (scope, binders) = (self.scope.len(), self.binders);
            let mut known = self.known(&all, &[])?;
            let mut refused = None;
            for signs in [Signs::ANY, Signs::POSITIVE, Signs::NOT_NEGATIVE] {
                known.forget_used();
                match self.members(u, signs, &mut known) {
                    Ok(()) => {
                        self.assumed.extend(cited(known.used().0, &all));
                        self.signs_of_members.insert(u.name.clone(), signs);
                        refused = None;
                        break;
                    }
                    Err(Refusal::Rejected(because)) => refused = refused.or(Some(because)),
                    Err(limit) => return Err(limit),
                }
                self.scope.truncate(scope);
                self.binders = binders;
            }
            if let Some(because) = refused {
                return rejected(Reason::Member(u.name.clone(), Box::new(because)));
            }
        }
        Ok(())
    }

    /// Checks that the sums and products over an index in domains and hypotheses begin at a natural number: by its form, or by
    /// the signs that hypotheses without sums give.
    ///
    /// An index is read as a natural number. In a goal or a definition this is shown where the sum is asked for a value
    /// (`defined`), which nobody asks of a hypothesis.
    fn begin_at_naturals(&mut self, statement: &Statement) -> Result<(), Refusal> {
        let of_claim = statement.bindings.iter().filter(|b| b.natural).flat_map(|b| &b.names);
        let mut naturals: Vec<String> = of_claim.map(|n| n.0.text.clone()).collect();
        let (mut plain, mut open) = (Vec::new(), Vec::new());
        for fact in &self.facts {
            let mut found = Vec::new();
            begins_of_prop(&fact.prop, &mut naturals, &mut found);
            if found.is_empty() {
                plain.push(fact.label.clone());
            }
            open.extend(found.into_iter().filter(|begin| !begin.by_form));
        }
        if open.is_empty() {
            return Ok(());
        }
        let known = self.known(&plain, &[])?;
        for Begin { of, from, .. } in open {
            let shown = match self.is(&from, Signs::NOT_NEGATIVE, &known) {
                // A name that the proposition binds is not known here.
                Err(Refusal::Rejected(_)) => false,
                other => other?,
            };
            if !shown {
                return rejected(Reason::Range(of));
            }
        }
        self.assumed.extend(cited(known.used().0, &plain));
        Ok(())
    }

    /// Shows that every member of a sequence has a value and one of these signs.
    ///
    /// Sound: by induction. u(0) has a value and such a sign; if u(k) has, then the step has, so that u(k + 1) has.
    fn members(&mut self, u: &Sequence, signs: Signs, known: &mut Known) -> Result<(), Refusal> {
        self.defined(&u.initial, known)?;
        if signs != Signs::ANY {
            self.need(&u.initial, signs, known)?;
        }
        let before = known.mark();
        let result = self.opened(|checker, own| {
            checker.under(&u.index, Atom::Bound(own), |checker| {
                let index = checker.intern(Atom::Bound(own));
                let member = checker.atom_fraction(Atom::Member(u.name.clone(), Poly::atom(index)));
                if signs != Signs::ANY {
                    checker.learn_signs(&member, signs, known)?;
                }
                checker.defined(&u.step, known)?;
                if signs == Signs::ANY { Ok(()) } else { checker.need(&u.step, signs, known) }
            })
        });
        known.back_to(before);
        result
    }
}

/// A sum or product over an index, where it begins, and whether that is a natural number by its form.
struct Begin {
    of: Expr,
    from: Expr,
    by_form: bool,
}

/// The sums and products over an index in an expression, where these names stand for natural numbers.
fn begins(e: &Expr, naturals: &mut Vec<String>, out: &mut Vec<Begin>) {
    match &e.kind {
        ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
            let by_form = is_natural(&index.from, &|name| naturals.iter().any(|n| n == name));
            out.push(Begin { of: e.clone(), from: (*index.from).clone(), by_form });
            begins(&index.from, naturals, out);
            begins(&index.to, naturals, out);
            naturals.push(index.name.text.clone());
            begins(body, naturals, out);
            naturals.pop();
        }
        // What it binds is a real number, even where a natural one outside has its name.
        ExprKind::IntegralOver(variable, body) => {
            begins(&variable.from, naturals, out);
            begins(&variable.to, naturals, out);
            let mut inside = naturals.iter().filter(|name| **name != variable.name.text).cloned().collect();
            begins(body, &mut inside, out);
        }
        _ => parts(e).into_iter().for_each(|part| begins(part, naturals, out)),
    }
}

/// Those in a proposition.
fn begins_of_prop(p: &Prop, naturals: &mut Vec<String>, out: &mut Vec<Begin>) {
    let under = |bindings: &[Binding], naturals: &mut Vec<String>, out: &mut Vec<Begin>| {
        let names = bindings.iter().filter(|b| b.natural).flat_map(|b| &b.names);
        naturals.extend(names.map(|n| n.0.text.clone()));
        bindings.iter().flat_map(statement::domain).for_each(|p| begins_of_prop(&p, naturals, out));
    };
    let length = naturals.len();
    match &p.kind {
        PropKind::Compare(sides, _) => sides.iter().for_each(|e| begins(e, naturals, out)),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| begins_of_prop(p, naturals, out));
        }
        PropKind::Not(inner) => begins_of_prop(inner, naturals, out),
        PropKind::Implies(a, b) => [a, b].into_iter().for_each(|p| begins_of_prop(p, naturals, out)),
        PropKind::Exists(bindings, body) | PropKind::ForAll(bindings, body) => {
            under(bindings, naturals, out);
            begins_of_prop(body, naturals, out);
        }
        PropKind::Extremum(e) => {
            e.at.iter().map(|a| &a.1).chain([&e.value]).for_each(|e| begins(e, naturals, out));
            under(&e.over, naturals, out);
            begins(&e.of, naturals, out);
        }
        PropKind::Limit(l) => [&l.of, &l.value].into_iter().for_each(|e| begins(e, naturals, out)),
        // Refused elsewhere.
        PropKind::WrittenLimit(_) => {}
    }
    naturals.truncate(length);
}
