//! Other ways to prove what a step of a draft shows, if it does not become a step of the certificate directly.

use super::{Elaborator, Kind, is_equation};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::statement::{compare, expr};
use crate::prove::draft::{self, negation};
use std::collections::{BTreeSet, HashMap};

impl Elaborator {
    /// Proves what a step of the draft shows by signs or by a combination, either as an equation of powers or logarithms, or
    /// from facts that contradict each other.
    pub(super) fn otherwise(&mut self, step: &draft::Step, rule: Rule, goal: &Prop) -> Option<Label> {
        if !matches!(step.rule, draft::Rule::Sign | draft::Rule::Combination) {
            return None;
        }
        let power = is_equation(goal).then(|| self.emit(&step.label, Rule::Power, goal).ok()).flatten();
        let power = power.or_else(|| self.with_more_powers(&step.label, rule, goal));
        power.or_else(|| self.contradiction(&step.label, goal))
    }

    /// The step, with powers and roots written as equal ones that the draft knew: it saw by their logarithms that
    /// `sqrt(1/2)` is `2^(-1/2)`.
    fn with_more_powers(&mut self, step: &str, rule: Rule, goal: &Prop) -> Option<Label> {
        let known: Vec<Expr> = self.powers().into_iter().map(|(left, _)| left.clone()).collect();
        let mut open = Vec::new();
        for prop in self.facts.iter().map(|fact| &fact.prop).chain([goal]) {
            if let PropKind::Compare(sides, _) = &prop.kind {
                sides.iter().for_each(|e| powers_in(e, &mut open));
            }
        }
        let mut seen: BTreeSet<String> = known.iter().map(key::expr).collect();
        open.retain(|e| seen.insert(key::expr(e)));
        let before = self.equations.len();
        for power in &open {
            for other in &known {
                let same = compare(power.clone(), Relation::Equal, other.clone());
                if let Ok(label) = self.emit(step, Rule::Power, &same) {
                    self.put_in(label, Kind::Written);
                    break;
                }
            }
        }
        if self.equations.len() == before { None } else { self.emit(step, rule, goal).ok() }
    }

    /// Proves any proposition from a fact whose negation follows from the signs of all facts.
    fn contradiction(&mut self, step: &str, goal: &Prop) -> Option<Label> {
        for fact in self.facts.clone().into_iter().rev() {
            let PropKind::Compare(..) = &fact.prop.kind else { continue };
            let Some(opposite) = negation(&fact.prop) else { continue };
            let signs = Rule::Combination { times: None, terms: Vec::new() };
            if let Ok(shown) = self.emit(step, signs, &opposite) {
                return self.emit(step, Rule::Logic { from: vec![fact.label, shown] }, goal).ok();
            }
        }
        None
    }

    /// An expression with the powers written as the steps of the draft so far write them.
    pub(super) fn powers_written(&self, e: &Expr) -> Expr {
        let written = self.powers().into_iter().map(|(left, right)| (key::expr(left), right)).collect();
        rewritten(e, &written)
    }

    /// Both sides of the powers that the old steps so far introduce.
    fn powers(&self) -> Vec<(&Expr, &Expr)> {
        let steps = self.past.iter().filter(|step| step.rule == draft::Rule::Power);
        let sides = steps.filter_map(|step| match step.prop.as_ref().map(|p| &p.kind) {
            Some(PropKind::Compare(sides, _)) => match sides.as_slice() {
                [left, right] => Some((left, right)),
                _ => None,
            },
            _ => None,
        });
        sides.collect()
    }
}

/// The powers whose exponents are no numerals, and the roots, in an expression; not under bound names.
fn powers_in(e: &Expr, out: &mut Vec<Expr>) {
    match &e.kind {
        ExprKind::Power(_, exponent) if !matches!(exponent.kind, ExprKind::Number(_)) => out.push(e.clone()),
        ExprKind::Apply(f, _) if matches!(f.text.as_str(), "sqrt" | "cbrt") => out.push(e.clone()),
        _ => {}
    }
    match &e.kind {
        ExprKind::Power(a, b) => [a, b].into_iter().for_each(|e| powers_in(e, out)),
        ExprKind::Apply(_, arguments) => arguments.iter().for_each(|e| powers_in(e, out)),
        ExprKind::Negate(a) => powers_in(a, out),
        ExprKind::Sum(list) => list.iter().for_each(|(_, e)| powers_in(e, out)),
        ExprKind::Product(list) => list.iter().for_each(|(_, e)| powers_in(e, out)),
        _ => {}
    }
}

/// An expression in which those of these keys are replaced, outermost first. What binds names stays.
fn rewritten(e: &Expr, by: &HashMap<String, &Expr>) -> Expr {
    if let Some(other) = by.get(&key::expr(e)) {
        return (*other).clone();
    }
    let inner = |e: &Expr| rewritten(e, by);
    expr(match &e.kind {
        ExprKind::Apply(f, arguments) => ExprKind::Apply(f.clone(), arguments.iter().map(inner).collect()),
        ExprKind::Negate(a) => ExprKind::Negate(Box::new(inner(a))),
        ExprKind::Sum(list) => ExprKind::Sum(list.iter().map(|(sign, e)| (*sign, inner(e))).collect()),
        ExprKind::Product(list) => ExprKind::Product(list.iter().map(|(factor, e)| (*factor, inner(e))).collect()),
        ExprKind::Power(a, b) => ExprKind::Power(Box::new(inner(a)), Box::new(inner(b))),
        other => other.clone(),
    })
}
