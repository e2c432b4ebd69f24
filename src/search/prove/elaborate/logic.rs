//! Steps of logic and induction, with the facts that they rest on written out.

use super::{Elaborator, Stuck};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, expr, name, numeral};
use crate::kernel::substitution::Substitution;
use crate::prove::draft;

impl Elaborator {
    /// The facts that a step of logic of the draft looked up.
    pub(super) fn premises(&self, step: &draft::Step, goal: &Prop) -> Result<Vec<Label>, Stuck> {
        let missing = || Stuck::Malformed(step.label.clone());
        let cited: Vec<Label> = step.from.iter().map(|f| self.label(f)).collect::<Result<_, _>>()?;
        let implies = |p: &Prop, q: &Prop| Prop {
            kind: PropKind::Implies(Box::new(p.clone()), Box::new(q.clone())),
            span: Span::default(),
        };
        let needed: Vec<Prop> = match step.rule {
            draft::Rule::All => parts(goal),
            draft::Rule::Either => match &goal.kind {
                PropKind::Or(list) => list.iter().find(|p| self.find(p).is_some()).cloned().into_iter().collect(),
                _ => return Err(missing()),
            },
            draft::Rule::Cases => match cited.first().and_then(|label| self.prop_of(label)).map(|p| p.kind) {
                Some(PropKind::Or(list)) => list.iter().map(|case| implies(case, goal)).collect(),
                _ => return Err(missing()),
            },
            draft::Rule::Apply => match cited.first().and_then(|label| self.prop_of(label)).map(|p| p.kind) {
                Some(PropKind::Implies(p, _)) => vec![*p],
                Some(PropKind::Equivalent(list)) => {
                    list.into_iter().find(|p| self.find(p).is_some()).into_iter().collect()
                }
                _ => return Err(missing()),
            },
            draft::Rule::Equivalent => match &goal.kind {
                PropKind::Equivalent(list) => list
                    .windows(2)
                    .flat_map(|pair| match pair {
                        [p, q] => vec![implies(p, q), implies(q, p)],
                        _ => Vec::new(),
                    })
                    .collect(),
                _ => return Err(missing()),
            },
            _ => Vec::new(),
        };
        let mut from = cited;
        for prop in needed {
            from.push(self.find(&prop).ok_or_else(missing)?);
        }
        Ok(from)
    }

    /// The comparison of numbers that a fact comes to, which is false.
    pub(super) fn absurd(&mut self, step: &draft::Step) -> Result<Rule, Stuck> {
        let missing = || Stuck::Malformed(step.label.clone());
        let label = self.label(step.from.first().map(String::as_str).unwrap_or_default())?;
        let fact = self.prop_of(&label).ok_or_else(missing)?;
        let PropKind::Compare(_, relations) = &fact.kind else { return Err(missing()) };
        let using = self.using();
        let Ok(Some(number)) = self.checker.constant(&fact, &using) else { return Err(missing()) };
        let digits = |n: num_bigint::BigInt| expr(ExprKind::Number(n.to_string()));
        let size = num_traits::Signed::abs(&number);
        let mut value = digits(size.numer().clone());
        if !size.is_integer() {
            value = expr(ExprKind::Product(vec![(Factor::Times, value), (Factor::Over, digits(size.denom().clone()))]));
        }
        if num_traits::Signed::is_negative(&number) {
            value = expr(ExprKind::Negate(Box::new(value)));
        }
        let false_one = compare(value, relations[0], numeral(0));
        let terms = vec![Term { facts: vec![label], factor: numeral(1) }];
        let shown = self.emit(&step.label, Rule::Combination { times: None, terms }, &false_one)?;
        Ok(Rule::Logic { from: vec![shown] })
    }

    pub(super) fn induction(&mut self, step: &draft::Step, prop: &Prop) -> Result<Rule, Stuck> {
        let missing = || Stuck::Malformed(step.label.clone());
        let PropKind::ForAll(bindings, body) = &prop.kind else { return Err(missing()) };
        let [binding] = bindings.as_slice() else { return Err(missing()) };
        let [(variable, None)] = binding.names.as_slice() else { return Err(missing()) };
        let first = match binding.constraints.as_slice() {
            [Constraint::Relation(_, bound)] => bound.clone(),
            _ => numeral(0),
        };
        let next = expr(ExprKind::Sum(vec![(Sign::Plus, name(&variable.text)), (Sign::Plus, numeral(1))]));
        let at = |value: &Expr| {
            let mut map = Substitution::default();
            map.replace(&variable.text, value);
            map.prop(body).map_err(|_| missing())
        };
        let advance = Prop { kind: PropKind::Implies(body.clone(), Box::new(at(&next)?)), span: prop.span };
        let advance = Prop { kind: PropKind::ForAll(bindings.clone(), Box::new(advance)), span: prop.span };
        Ok(Rule::Induction {
            base: self.find(&at(&first)?).ok_or_else(missing)?,
            advance: self.find(&advance).ok_or_else(missing)?,
        })
    }
}

/// The parts of a conjunction or chain.
fn parts(p: &Prop) -> Vec<Prop> {
    match &p.kind {
        PropKind::And(list) => list.clone(),
        PropKind::Compare(sides, relations) => sides
            .windows(2)
            .zip(relations)
            .map(|(pair, r)| Prop { kind: PropKind::Compare(pair.to_vec(), vec![*r]), span: p.span })
            .collect(),
        _ => Vec::new(),
    }
}
