//! Limits that depend on parameters: the members of a sequence by their closed form, and parameters of any sign case by case.

use super::limits::holds;
use super::sums::occurs;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::claim::walk::parts;
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
            if !occurs(&member(n.clone()), &closed) {
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

    /// A sum free of the variable, of any sign, by which what holds the variable is multiplied or divided.
    fn constant_of_any_sign(&mut self, e: &Expr, x: &str) -> Option<Expr> {
        if !holds(e, x) {
            return None;
        }
        if let ExprKind::Product(list) = &e.kind {
            let mut constants =
                list.iter().map(|(_, e)| e).filter(|e| matches!(e.kind, ExprKind::Sum(_)) && !holds(e, x));
            if let Some(open) = constants.find(|e| self.signs_of(e) == Signs::ANY) {
                return Some(open.clone());
            }
        }
        match &e.kind {
            ExprKind::Negate(_) | ExprKind::Sum(_) | ExprKind::Product(_) => {
                let mut found = None;
                parts(e, &mut |part| {
                    if found.is_none() {
                        found = self.constant_of_any_sign(part, x);
                    }
                });
                found
            }
            _ => None,
        }
    }

    /// Proves a limit where a real parameter, or a factor that is a sum of parameters, is negative, 0 and positive.
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
        let factor = self.constant_of_any_sign(&l.of, &l.variable.text);
        let beside = names.iter().find(|n| !holds(&l.value, n) && is_open(self, n)).cloned();
        let is_beside = match &factor {
            Some(factor) => !occurs(factor, &l.value),
            None => beside.is_some(),
        };
        let in_a_base = |n: &&String| raised.iter().any(|(base, _)| holds(base, n));
        let open = beside.or_else(|| names.iter().filter(in_a_base).find(|n| is_open(self, n)).cloned());
        let open = open.or_else(|| names.iter().filter(|_| !raised.is_empty()).find(|n| is_open(self, n)).cloned());
        let open = factor.or_else(|| open.map(|n| name(&n))).ok_or_else(no)?;
        let relations = match is_beside {
            true => vec![Relation::Less, Relation::Equal, Relation::Greater],
            false => vec![Relation::Less, Relation::GreaterEqual],
        };
        self.parameters += 1;
        let mut from = Vec::new();
        for relation in relations {
            let case = compare(open.clone(), relation, numeral(0));
            let shown = self.block(&implies(&case, goal), |c, _| {
                if relation == Relation::Equal {
                    let mut zero = l.of.clone();
                    super::sums::replace(&mut zero, &open, &numeral(0));
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
