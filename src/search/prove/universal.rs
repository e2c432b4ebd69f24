//! Instances of facts `for all`: over real numbers, and of recurrences between members with numerals as indices.
//!
//! Method: where fact and goal are linear, elimination says at which values the fact contradicts the opposite of the goal. Else
//! the fact is taken at a few numbers, which determine polynomials of low degree, and at the names of the goal.
//!
//! A fact about members of families is taken at all numbers between the indices that occur.
//!
//! Limits: [`INSTANCES`] of each fact, [`VARIABLES`] of a fact, [`MEMBERS`] between indices.

use super::instances::members_in;
use super::letters::natural;
use super::{Fail, Prover};
use crate::certificate::Label;
use crate::claim::syntax::*;
use crate::kernel::names::names_in_prop;
use crate::kernel::statement::{name, numeral};
use crate::refute::literal::literal;
use malachite::Rational;
use std::collections::BTreeSet;
use std::rc::Rc;

/// The most instances of a fact.
const INSTANCES: usize = 9;

/// The most variables of a fact whose instances are tried.
const VARIABLES: usize = 2;

/// The largest distance between indices.
const MEMBERS: u32 = 12;

/// The numbers at which a fact is taken.
const NUMBERS: [i32; 5] = [0, 1, -1, 2, -2];

impl Prover {
    /// Proves a comparison by instances of facts `for all`.
    pub(super) fn by_universal_facts(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a fact for all values");
        let real = |b: &Binding| !b.natural && b.names.iter().all(|n| n.1.is_none());
        // What a step has shown for all values serves the rule that asked for it; an argument says which instances it wants.
        let shown = |label: &str| label.bytes().all(|b| b.is_ascii_digit());
        let universal: Vec<(Label, Rc<Prop>)> = self
            .facts()
            .into_iter()
            .filter(|(label, p)| {
                !shown(label) && matches!(&p.kind, PropKind::ForAll(bindings, _) if bindings.iter().all(real))
            })
            .collect();
        if universal.is_empty() {
            return self.by_members_between(goal);
        }
        for (label, every) in &universal {
            if let Ok(shown) = self.attempt(|c| c.by_linear_instance(goal, label, every)) {
                return Ok(shown);
            }
        }
        for (label, every) in &universal {
            if let Ok(shown) = self.attempt(|c| c.by_turning_instance(goal, label, every)) {
                return Ok(shown);
            }
        }
        self.attempt(|c| {
            let mut changed = false;
            for (label, every) in &universal {
                changed |= c.take_instances(goal, label, every);
            }
            if !changed {
                return Err(no());
            }
            let _ = c.conclude_at_once();
            c.quietly(goal).or_else(|_| {
                c.solve_equations();
                c.quietly(goal)
            })
        })
    }

    /// Proves a comparison by facts about members at all indices between those that occur.
    fn by_members_between(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("members with numerals as indices");
        let (mut sides, mut members) = (Vec::new(), Vec::new());
        let facts = self.facts();
        facts.iter().map(|f| &*f.1).chain([goal]).for_each(|p| super::goals::sides_in(p, &mut sides));
        sides.iter().for_each(|e| members_in(e, &mut members));
        let indices = || members.iter().filter_map(|(_, at)| natural(at));
        let (Some(least), Some(most)) = (indices().min(), indices().max()) else { return Err(no()) };
        if least == most || most - least > MEMBERS {
            return Err(no());
        }
        let one = |b: &[Binding]| matches!(b, [Binding { names, natural: true, .. }] if names.len() == 1);
        let recurrences: Vec<Label> = facts
            .into_iter()
            .filter(|(_, p)| matches!(&p.kind, PropKind::ForAll(bindings, _) if one(bindings)))
            .map(|f| f.0)
            .collect();
        self.attempt(|c| {
            let mut changed = false;
            for label in &recurrences {
                for k in least..most {
                    changed |= c.attempt(|c| c.instance(label, &numeral(k))).is_ok();
                }
            }
            if changed { c.quietly(goal) } else { Err(no()) }
        })
    }

    /// Takes instances of a fact; whether there were any.
    fn take_instances(&mut self, goal: &Prop, label: &str, every: &Prop) -> bool {
        let PropKind::ForAll(bindings, _) = &every.kind else { return false };
        let variables: Vec<String> = bindings.iter().flat_map(|b| &b.names).map(|n| n.0.text.clone()).collect();
        let mut names = BTreeSet::new();
        names_in_prop(goal, &mut names);
        names.retain(|n| self.is_a_name(n));
        let mut values: Vec<Expr> = names.iter().take(3).map(|n| name(n)).collect();
        values.extend(NUMBERS.map(|k| literal(&Rational::from(k))));
        let mut points: Vec<Vec<Expr>> = vec![Vec::new()];
        for _ in variables.iter().take(VARIABLES) {
            let more = |p: &Vec<Expr>| {
                values.iter().map(|v| p.iter().chain([v]).cloned().collect()).collect::<Vec<Vec<Expr>>>()
            };
            points = points.iter().flat_map(more).collect();
        }
        if variables.len() > VARIABLES {
            return false;
        }
        let mut changed = false;
        for values in points.into_iter().take(INSTANCES) {
            let point = variables.iter().cloned().zip(values).collect();
            changed |= self.attempt(|c| c.instance_at(label, point)).is_ok();
        }
        changed
    }
}
