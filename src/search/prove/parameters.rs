//! Limits that depend on parameters: the members of a sequence by their closed form, and parameters of any sign case by case.

use super::limits::holds;
use super::slopes::put_in;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::names::names_in;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, name, numeral};
use std::collections::BTreeSet;

/// The most parameters whose signs are distinguished.
const PARAMETERS: usize = 2;

impl Prover {
    /// Proves a limit after replacing members of sequences u(k + 1) = a·u(k) + b by a^n·(u(0) − p) + p with p = b/(1 − a), or by
    /// u(0) + n·b where a is 1.
    pub(super) fn by_closed_members(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        let no = || Fail::No("a sequence in closed form");
        let n = name(&l.variable.text);
        let (mut closed, mut facts) = (l.of.clone(), Vec::new());
        for sequence in self.checker.statement().sequences.clone() {
            let member = |at: Expr| apply(&sequence.name, at);
            if !mentions(&closed, &member(n.clone())) {
                continue;
            }
            let value = self.member_at(&sequence, &n).ok_or_else(no)?;
            let own = member(n.clone());
            facts.push(self.on_its_own(|c| c.is_closed_form(&own, &value, &l.variable.text))?);
            super::sums::replace(&mut closed, &own, &value);
        }
        if facts.is_empty() {
            return Err(no());
        }
        self.between(goal, l, (&closed, &closed), &facts, 1)
    }

    /// Proves a limit where a real parameter is negative, 0 and positive.
    pub(super) fn by_signs_of_a_parameter(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        let no = || Fail::No("a parameter of any sign");
        if self.parameters >= PARAMETERS {
            return Err(no());
        }
        let mut names = BTreeSet::new();
        names_in(&l.of, &mut names);
        names.remove(&l.variable.text);
        // What stands beside the value tells nothing by its sign, but for what is raised to the variable.
        let mut raised = Vec::new();
        super::alternating::powers_to(&l.of, &l.variable.text, &mut raised);
        let is_open = |c: &mut Prover, n: &String| c.is_a_name(n) && c.signs_of(&name(n)) == Signs::ANY;
        let beside = names.iter().find(|n| !holds(&l.value, n) && is_open(self, n)).cloned();
        let is_beside = beside.is_some();
        let in_a_base = |n: &&String| raised.iter().any(|(base, _)| holds(base, n));
        let open = beside.or_else(|| names.iter().filter(in_a_base).find(|n| is_open(self, n)).cloned());
        let open = open.or_else(|| names.iter().filter(|_| !raised.is_empty()).find(|n| is_open(self, n)).cloned());
        let open = open.ok_or_else(no)?;
        let relations = match is_beside {
            true => vec![Relation::Less, Relation::Equal, Relation::Greater],
            false => vec![Relation::Less, Relation::GreaterEqual],
        };
        self.parameters += 1;
        let mut from = Vec::new();
        for relation in relations {
            let case = compare(name(&open), relation, numeral(0));
            let shown = self.block(&implies(&case, goal), |c, _| {
                if relation == Relation::Equal {
                    let zero = put_in(&l.of, &open, &numeral(0))?;
                    return c.between(goal, l, (&zero, &zero), &[], 1);
                }
                c.limit(goal, l)
            });
            match shown {
                Ok(label) => from.push(label),
                Err(fail) => {
                    self.parameters -= 1;
                    return Err(fail);
                }
            }
        }
        self.parameters -= 1;
        self.emit(Rule::Logic { from }, goal.clone())
    }
}

/// Whether an expression occurs in another.
fn mentions(e: &Expr, part: &Expr) -> bool {
    let mut found = key::expr(e) == key::expr(part);
    crate::claim::walk::parts(e, &mut |e| found |= mentions(e, part));
    found
}
