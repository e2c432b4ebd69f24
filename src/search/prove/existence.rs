//! Hypotheses that something exists: it gets a name, and what it has becomes a hypothesis.
//!
//! Certificate: the goal for all such values, in a block, and the rule `existence`. That nothing of a kind exists is shown in the
//! same way, from what all values lack.
//!
//! Limit: [`OPEN`] statements that something exists, each once within the other.

use super::facts::opposite;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, name, numeral, prop};
use crate::kernel::substitution::Substitution;
use std::rc::Rc;

/// The most statements that are opened within one another.
const OPEN: usize = 6;

impl Prover {
    /// Shows a goal by a name for what a fact says to exist; nothing where there is no such fact that was not used yet.
    pub(super) fn by_existence(&mut self, goal: &Prop) -> Option<Result<Label, Fail>> {
        if self.opened.len() >= OPEN {
            return None;
        }
        let is_open = |(label, fact): &(&str, &Rc<Prop>)| {
            let PropKind::Exists(bindings, _) = &fact.kind else { return false };
            let plain = bindings.iter().flat_map(|b| &b.names).all(|n| n.1.is_none());
            plain && self.opened.iter().all(|opened| opened != label)
        };
        let (label, fact) =
            self.checker.facts().find(is_open).map(|(label, fact)| (label.to_string(), fact.clone()))?;
        self.opened.push(label.clone());
        let shown = self.attempt(|c| c.opened_existence(goal, &label, &fact));
        self.opened.pop();
        Some(shown)
    }

    /// Shows that nothing has a property: everything lacks it.
    pub(super) fn by_no_example(&mut self, goal: &Prop, some: &Prop) -> Result<Label, Fail> {
        let PropKind::Exists(bindings, body) = &some.kind else { return Err(Fail::No("what exists")) };
        let none = prop(PropKind::ForAll(bindings.clone(), Box::new(prop(PropKind::Not(body.clone())))));
        let none = self.show(&none)?;
        let absurd = compare(numeral(0), Relation::Greater, numeral(0));
        let block = self
            .block(&implies(some, &absurd), |c, supposed| c.excluded(bindings, body, &format!("{supposed}s"), &none))?;
        self.logic(&[&block], goal)
    }

    /// Shows that not everything has a property: something lacks it.
    pub(super) fn by_example_without(&mut self, goal: &Prop, every: &Prop) -> Result<Label, Fail> {
        let PropKind::ForAll(bindings, body) = &every.kind else { return Err(Fail::No("a statement for all values")) };
        let lacks = opposite(body).unwrap_or_else(|| prop(PropKind::Not(body.clone())));
        let some = prop(PropKind::Exists(bindings.clone(), Box::new(lacks.clone())));
        let some = self.by_witness(&some, bindings, &lacks)?;
        let absurd = compare(numeral(0), Relation::Greater, numeral(0));
        let block = self.block(&implies(every, &absurd), |c, supposed| {
            c.excluded(bindings, &lacks, &some, &format!("{supposed}s"))
        })?;
        self.logic(&[&block], goal)
    }

    /// A contradiction: something has a property, and a fact says of everything that it has not.
    fn excluded(&mut self, bindings: &[Binding], has: &Prop, some: &str, none: &str) -> Result<Label, Fail> {
        let absurd = compare(numeral(0), Relation::Greater, numeral(0));
        let own = |n: &(Name, Option<Name>)| (n.0.text.clone(), name(&n.0.text));
        let point: Vec<(String, Expr)> = bindings.iter().flat_map(|b| &b.names).map(own).collect();
        let has_it = implies(has, &absurd);
        let all = self.block(&prop(PropKind::ForAll(bindings.to_vec(), Box::new(has_it.clone()))), |c, _| {
            c.block(&has_it, |c, block| {
                let lacks = c.instance_at(none, point)?;
                c.logic(&[&lacks, &format!("{block}s")], &absurd)
            })
        })?;
        self.emit(Rule::Existence { some: some.to_string(), all }, absurd)
    }

    fn opened_existence(&mut self, goal: &Prop, some: &str, fact: &Prop) -> Result<Label, Fail> {
        let PropKind::Exists(bindings, body) = &fact.kind else { return Err(Fail::No("what exists")) };
        let (mut bindings, mut map) = (bindings.clone(), Substitution::default());
        for own in bindings.iter_mut().flat_map(|b| &mut b.names) {
            let fresh = self.fresh(&own.0.text);
            map.replace(&own.0.text, &name(&fresh));
            own.0.text = fresh;
        }
        for constraint in bindings.iter_mut().flat_map(|b| &mut b.constraints) {
            let ends = match constraint {
                Constraint::Relation(_, end) => vec![end],
                Constraint::Interval { from, to, .. } | Constraint::Range(from, to) => vec![from, to],
            };
            for end in ends {
                *end = map.expr(end).map_err(Fail::from)?;
            }
        }
        let body = map.prop(body).map_err(Fail::from)?;
        let all = self.show(&prop(PropKind::ForAll(bindings, Box::new(implies(&body, goal)))))?;
        self.emit(Rule::Existence { some: some.to_string(), all }, goal.clone())
    }
}
