//! Hypotheses that something exists: it gets a name, and what it has becomes a hypothesis.
//!
//! Certificate: the goal for all such values, in a block, and the rule `existence`. That nothing of a kind exists is shown in the
//! same way, from what all values lack.
//!
//! Limit: [`OPEN`] statements that something exists, each once within the other.

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
        let every = |body: Prop| prop(PropKind::ForAll(bindings.clone(), Box::new(body)));
        let none = self.show(&every(prop(PropKind::Not(body.clone()))))?;
        let absurd = compare(numeral(0), Relation::Greater, numeral(0));
        let own = |n: &(Name, Option<Name>)| (n.0.text.clone(), name(&n.0.text));
        let point: Vec<(String, Expr)> = bindings.iter().flat_map(|b| &b.names).map(own).collect();
        let has_it = implies(body, &absurd);
        let block = self.block(&implies(some, &absurd), |c, supposed| {
            let all = c.block(&every(has_it.clone()), |c, _| {
                c.block(&has_it, |c, block| {
                    let lacks = c.instance_at(&none, point)?;
                    c.logic(&[&lacks, &format!("{block}s")], &absurd)
                })
            })?;
            c.emit(Rule::Existence { some: format!("{supposed}s"), all }, absurd.clone())
        })?;
        self.logic(&[&block], goal)
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
