//! Instances of `for all` facts at the indices that occur.

use super::Prover;
use super::coefficients::rational;
use crate::algebra::Polynomial;
use crate::certificate::Label;
use crate::claim::syntax::*;
use std::collections::BTreeSet;

/// The name of a family or sequence, and an index.
type Member = (String, Polynomial);

impl Prover {
    /// Adds instances of the `for all` facts that relate members, at the indices in these expressions and in what follows
    /// from them. Returns whether there is a new fact.
    pub(crate) fn instantiate(&mut self, exprs: &[&Expr]) -> bool {
        let facts: Vec<(Label, Name, Vec<Member>)> = self
            .checker
            .facts()
            .filter_map(|(label, p)| {
                let PropKind::ForAll(bindings, body) = &p.kind else { return None };
                let [Binding { names, natural: true, .. }] = bindings.as_slice() else { return None };
                let [(variable, None)] = names.as_slice() else { return None };
                Some((label.to_string(), variable.clone(), (**body).clone()))
            })
            .collect::<Vec<_>>()
            .into_iter()
            .filter_map(|(label, variable, body)| {
                let mut members = Vec::new();
                let mut sides = Vec::new();
                super::goals::sides_in(&body, &mut sides);
                sides.iter().for_each(|e| members_in(e, &mut members));
                let members: Vec<(String, Polynomial)> =
                    members.into_iter().filter_map(|(f, e)| Some((f, self.letters.polynomial(&e)?))).collect();
                // The kernel itself uses the sign of every member.
                let is_sign = members.len() == 1 && sides.iter().any(|e| rational(e).is_some());
                (!members.is_empty() && !is_sign).then_some((label, variable, members))
            })
            .collect();
        if facts.is_empty() {
            return false;
        }
        let mut changed = false;
        let mut done: BTreeSet<(Label, String)> = BTreeSet::new();
        let mut open: Vec<(String, Polynomial)> = Vec::new();
        for e in exprs {
            let mut members = Vec::new();
            members_in(e, &mut members);
            open.extend(members.into_iter().filter_map(|(f, e)| Some((f, self.letters.polynomial(&e)?))));
        }
        // After those that occur, earlier members only; at numerals back to the first.
        for round in 0..12 {
            let mut next = Vec::new();
            for (label, variable, members) in &facts {
                let v = self.letters.of(&crate::kernel::statement::name(&variable.text));
                let shift_of = |at: &Polynomial| at.sub(&Polynomial::variable(v));
                let top = members.iter().filter_map(|(_, at)| shift_of(at).as_constant()).max();
                for (f, t) in open.iter().filter(|(_, t)| round < 3 || t.is_constant()) {
                    for (g, at) in members {
                        // at = k + c: the index that makes it t is t − c.
                        let shift = shift_of(at);
                        if round > 0 && shift.as_constant() != top {
                            continue;
                        }
                        let index = t.sub(&shift);
                        if f != g || shift.contains(v) || index.contains(v) || done.len() > 24 {
                            continue;
                        }
                        if index.as_constant().is_some_and(|c| c < 0) {
                            continue;
                        }
                        let value = self.letters.written(&index);
                        if !done.insert((label.clone(), crate::kernel::key::expr(&value))) {
                            continue;
                        }
                        if let Ok(new) = self.attempt(|c| c.instance(label, &value)) {
                            changed = true;
                            self.put_in_parts(&new);
                            next.extend(
                                members.iter().map(|(g, at)| (g.clone(), at.sub(&Polynomial::variable(v)).add(&index))),
                            );
                        }
                    }
                }
            }
            if next.is_empty() {
                break;
            }
            open = next;
        }
        changed
    }
}

impl Prover {
    /// Substitutes the equations of a fact whose left sides are members.
    fn put_in_parts(&mut self, label: &str) {
        let Some(fact) = self.fact(label) else { return };
        let parts = match &fact.kind {
            PropKind::And(list) => list.clone(),
            _ => vec![fact],
        };
        for part in parts {
            if let PropKind::Compare(sides, relations) = &part.kind
                && *relations == [Relation::Equal]
                && matches!(&sides[0].kind, ExprKind::Apply(..))
                && let Some(label) = self.known(&part)
            {
                self.put_in(&label);
            }
        }
    }
}

/// The members of families and sequences in an expression: the name and the index.
pub(super) fn members_in(e: &Expr, out: &mut Vec<(String, Expr)>) {
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => {}
        ExprKind::Apply(f, list) => {
            list.iter().for_each(|e| members_in(e, out));
            if let ([at], false) = (list.as_slice(), is_built_in(&f.text)) {
                out.push((f.text.clone(), at.clone()));
            }
        }
        ExprKind::Negate(a) | ExprKind::Derivative(a, _) => members_in(a, out),
        ExprKind::Sum(list) => list.iter().for_each(|(_, e)| members_in(e, out)),
        ExprKind::Product(list) => list.iter().for_each(|(_, e)| members_in(e, out)),
        ExprKind::Power(a, b) => [a, b].into_iter().for_each(|e| members_in(e, out)),
        ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) | ExprKind::IntegralOver(index, _) => {
            members_in(&index.from, out);
            members_in(&index.to, out);
        }
        ExprKind::Matrix(rows) => rows.iter().flatten().for_each(|e| members_in(e, out)),
    }
}
