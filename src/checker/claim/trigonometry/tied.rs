//! Hypotheses that tie an angle to something else, on the claim as its author wrote it.
//!
//! Under `x = cos(theta)` a derivative by θ may hold x fast or not, and a reader may think of either. Such a derivative is refused.

use super::Writer;
use crate::claim::free_names::{names_in, names_in_prop};
use crate::claim::substitution::Substitution;
use crate::claim::syntax::*;
use crate::claim::walk;
use crate::claim::{abbreviation, floor};
use std::collections::BTreeSet;

impl Writer<'_> {
    /// Whether the claim has a derivative by an angle.
    pub(super) fn differentiates_by_an_angle(&self, claim: &mut Claim) -> bool {
        fn is_by(e: &Expr, is_angle: &dyn Fn(&str) -> bool) -> bool {
            let mut found = matches!(&e.kind, ExprKind::Derivative(_, by) if by.iter().any(|n| is_angle(&n.text)));
            walk::parts(e, &mut |part| found = found || is_by(part, is_angle));
            found
        }
        let mut found = false;
        walk::expressions(claim, &mut |e| found = found || is_by(e, &|name| self.angles.contains_key(name)));
        found
    }

    /// Notes what hypotheses, domains and premises say together. A strict comparison leaves a whole neighbourhood, so it ties nothing.
    pub(super) fn find_ties(&mut self, claim: &Claim) {
        let mut definitions = Substitution::default();
        for item in &claim.items {
            match item {
                Item::Given(bindings) => self.domains(bindings, &definitions),
                Item::Let { name, parameters, value } => {
                    match definitions.under(parameters).and_then(|inner| inner.expr(value)) {
                        Ok(value) => {
                            let parameters = parameters.iter().map(|p| p.text.clone()).collect();
                            definitions.define(&name.text, parameters, value);
                        }
                        Err(obstacle) => self.refused(obstacle, value.span),
                    }
                }
                // No member of a sequence is differentiated.
                Item::Define { .. } => {}
                Item::Assume { prop, .. } => self.tie(prop, &definitions),
            }
        }
        self.premises(&claim.goal, &definitions);
    }

    /// Another name that a hypothesis ties to an angle, if there is one.
    pub(super) fn tied_to(&self, angle: &str) -> Option<String> {
        let tie = self.ties.iter().find(|names| names.contains(angle))?;
        tie.iter().find(|name| *name != angle).cloned()
    }

    /// Notes what a part of a goal may be said under: premises, domains, and the other parts of an equivalence or disjunction.
    fn premises(&mut self, p: &Prop, definitions: &Substitution) {
        match &p.kind {
            PropKind::And(list) => list.iter().for_each(|p| self.premises(p, definitions)),
            PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().filter(|p| !differentiates(p)).for_each(|p| self.tie(p, definitions));
                list.iter().for_each(|p| self.premises(p, definitions));
            }
            PropKind::Implies(p, q) => {
                self.tie(p, definitions);
                self.premises(q, definitions);
            }
            PropKind::Not(p) => self.premises(p, definitions),
            PropKind::Exists(bindings, p) | PropKind::ForAll(bindings, p) => {
                self.domains(bindings, definitions);
                self.premises(p, definitions);
            }
            PropKind::Extremum(e) => self.domains(&e.over, definitions),
            PropKind::Compare(..) | PropKind::Limit(_) | PropKind::WrittenLimit(_) => {}
        }
    }

    fn domains(&mut self, bindings: &[Binding], definitions: &Substitution) {
        for binding in bindings {
            let bounds = binding.constraints.iter().flat_map(|constraint| match constraint {
                Constraint::Relation(Relation::Less | Relation::Greater | Relation::NotEqual, _) => Vec::new(),
                Constraint::Relation(_, e) => vec![e],
                Constraint::Interval { from, to, from_closed, to_closed } => {
                    [(from, *from_closed), (to, *to_closed)].into_iter().filter(|end| end.1).map(|end| end.0).collect()
                }
                Constraint::Range(from, to) => vec![from, to],
            });
            let mut names: BTreeSet<String> = binding.names.iter().map(|n| n.0.text.clone()).collect();
            let alone = names.len();
            bounds.for_each(|e| self.names(e, definitions, &mut names));
            if names.len() > alone {
                self.ties.push(names);
            }
        }
    }

    /// Notes the names of a hypothesis, unless it is a chain of strict comparisons.
    fn tie(&mut self, p: &Prop, definitions: &Substitution) {
        let mut names = BTreeSet::new();
        self.names_of(p, definitions, &mut names);
        if names.len() > 1 {
            self.ties.push(names);
        }
    }

    fn names_of(&mut self, p: &Prop, definitions: &Substitution, into: &mut BTreeSet<String>) {
        match &p.kind {
            PropKind::Compare(sides, relations) => {
                let strict = [Relation::Less, Relation::Greater, Relation::NotEqual];
                if !relations.iter().all(|r| strict.contains(r)) {
                    sides.iter().for_each(|e| self.names(e, definitions, into));
                }
            }
            // A conjunction is said part by part.
            PropKind::And(list) => list.iter().for_each(|p| self.tie(p, definitions)),
            _ => match definitions.prop(p) {
                Ok(p) => {
                    let mut names = BTreeSet::new();
                    names_in_prop(&p, &mut names);
                    into.extend(names.into_iter().filter(|name| self.is_variable(name)));
                }
                Err(obstacle) => self.refused(obstacle, p.span),
            },
        }
    }

    /// The names of variables, families and sequences in an expression, definitions put in.
    fn names(&mut self, e: &Expr, definitions: &Substitution, into: &mut BTreeSet<String>) {
        match definitions.expr(e) {
            Ok(e) => {
                let mut names = BTreeSet::new();
                names_in(&e, &mut names);
                into.extend(names.into_iter().filter(|name| self.is_variable(name)));
            }
            Err(obstacle) => self.refused(obstacle, e.span),
        }
    }

    /// Whether a name is no function of the language and not π.
    fn is_variable(&self, name: &str) -> bool {
        let is_pi = name == PI && self.is_pi;
        let is_function = FUNCTIONS.iter().any(|f| f.0 == name)
            || self.words.contains(&name)
            || abbreviation::is_one(name)
            || floor::is_function(name);
        !is_pi && (!is_function || self.applied.contains(name))
    }
}

/// Whether a derivative stands in a proposition.
fn differentiates(p: &Prop) -> bool {
    fn in_expr(e: &Expr) -> bool {
        let mut found = matches!(e.kind, ExprKind::Derivative(..));
        walk::parts(e, &mut |part| found = found || in_expr(part));
        found
    }
    match &p.kind {
        PropKind::Compare(sides, _) => sides.iter().any(in_expr),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().any(differentiates),
        PropKind::Not(p) | PropKind::Exists(_, p) | PropKind::ForAll(_, p) => differentiates(p),
        PropKind::Implies(p, q) => differentiates(p) || differentiates(q),
        PropKind::Extremum(e) => in_expr(&e.of) || in_expr(&e.value),
        PropKind::Limit(l) => in_expr(&l.of) || in_expr(&l.value),
        PropKind::WrittenLimit(l) => l.parts().any(in_expr),
    }
}
