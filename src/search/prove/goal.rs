//! Proves a goal by its form: first its parts, then the known facts.

use super::draft::{Rule, negation};
use super::{Certifier, Fail};
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, prop};

impl Certifier {
    /// Proves a goal without an argument.
    pub(super) fn show(&mut self, goal: &Prop) -> Result<(), Fail> {
        self.tick()?;
        if self.checker.knows(goal) {
            return Ok(());
        }
        match &goal.kind {
            PropKind::Compare(sides, relations) => match (sides.as_slice(), relations.as_slice()) {
                ([a, b], [relation]) => self.show_comparison(goal, a, *relation, b),
                _ => {
                    for (pair, relation) in sides.windows(2).zip(relations) {
                        self.show(&compare(pair[0].clone(), *relation, pair[1].clone()))?;
                    }
                    self.take(Rule::All, &[], Some(goal.clone())).map(|_| ())
                }
            },
            PropKind::And(list) => {
                for part in list {
                    self.show(part)?;
                }
                self.take(Rule::All, &[], Some(goal.clone())).map(|_| ())
            }
            PropKind::Or(list) => self.show_or(goal, list),
            PropKind::Not(inner) => {
                let p = negation(inner).ok_or("a negation that is not followed")?;
                self.show(&p)?;
                let label = self.label_of(&p).ok_or("a negation")?;
                self.take(Rule::Negation, &[label], Some(goal.clone())).map(|_| ())
            }
            PropKind::Implies(p, q) => {
                let mut exprs = Vec::new();
                exprs_in(p, &mut exprs);
                let exprs: Vec<&Expr> = exprs.iter().collect();
                self.prepare(&exprs)?;
                self.define(&exprs)?;
                self.block(goal, |c, block| {
                    c.suppose(&format!("{block}s"), p)?;
                    c.show(q)
                })
            }
            PropKind::Equivalent(list) => {
                for pair in list.windows(2) {
                    for (p, q) in [(&pair[0], &pair[1]), (&pair[1], &pair[0])] {
                        self.show(&prop(PropKind::Implies(Box::new(p.clone()), Box::new(q.clone()))))?;
                    }
                }
                self.take(Rule::Equivalent, &[], Some(goal.clone())).map(|_| ())
            }
            PropKind::ForAll(_, body) => self.block(goal, |c, block| {
                c.enter(block)?;
                c.show(body)
            }),
            PropKind::Exists(bindings, body) => {
                let point =
                    crate::refute::sample::example(bindings, body, self.deadline).ok_or("no witness was found")?;
                let values: Vec<(Name, Expr)> = point
                    .into_iter()
                    .map(|(n, v)| (Name { text: n, span: Span::default() }, crate::refute::literal::literal(&v)))
                    .collect();
                self.witness(goal, &values)
            }
            PropKind::Extremum(e) => self.extremum(goal, e),
            PropKind::WrittenLimit(_) => Err(Fail::No("a limit as it is written")),
            PropKind::Limit(l) => {
                self.define(&[&l.of, &l.value])?;
                self.take(Rule::Limit, &[], Some(goal.clone())).map(|_| ())
            }
        }
    }

    /// Uses the domain of a block's variables.
    pub(super) fn enter(&mut self, block: &str) -> Result<(), Fail> {
        let list: Vec<(String, Prop)> = self
            .checker
            .facts()
            .iter()
            .filter(|f| f.label().strip_prefix(block).is_some_and(|rest| rest.starts_with('d')))
            .map(|f| (f.label().to_string(), (**f.prop()).clone()))
            .collect();
        list.iter().try_for_each(|(label, fact)| self.suppose(label, fact))
    }

    fn show_comparison(&mut self, goal: &Prop, a: &Expr, relation: Relation, b: &Expr) -> Result<(), Fail> {
        if is_matrix(a) || is_matrix(b) {
            self.prepare(&[a, b])?;
            self.define(&[a, b])?;
            return self.take(Rule::Sign, &[], Some(goal.clone())).map(|_| ());
        }
        let first = match self.attempt(|c| c.comparison(a, relation, b)) {
            Ok(()) => return Ok(()),
            Err(first) => first,
        };
        if let Some(label) = self.contradiction() {
            return self.take(Rule::Absurd, &[label], Some(goal.clone())).map(|_| ());
        }
        if self.saturate()? && self.attempt(|c| c.comparison(a, relation, b)).is_ok() {
            return Ok(());
        }
        if self.attempt(|c| c.transitive(goal, a, relation, b)).is_ok() {
            return Ok(());
        }
        const ORDER: [Relation; 4] = [Relation::Less, Relation::LessEqual, Relation::Greater, Relation::GreaterEqual];
        if !self.within_powers && ORDER.contains(&relation) {
            self.within_powers = true;
            let result = self.attempt(|c| c.by_powers(goal, &ORDER));
            self.within_powers = false;
            if result.is_ok() {
                return Ok(());
            }
        }
        if self.splits < 3 {
            self.splits += 1;
            let result = self.attempt(|c| c.by_contradiction(goal)).or_else(|_| self.attempt(|c| c.by_facts(goal)));
            self.splits -= 1;
            if result.is_ok() {
                return Ok(());
            }
        }
        Err(first)
    }

    /// Cases by a disjunction that is known.
    fn by_facts(&mut self, goal: &Prop) -> Result<(), Fail> {
        let list = self.facts();
        for (label, fact) in list.iter().rev() {
            let PropKind::Or(parts) = &fact.kind else { continue };
            let done = self.attempt(|c| {
                for part in parts {
                    let implication = prop(PropKind::Implies(Box::new(part.clone()), Box::new(goal.clone())));
                    if c.checker.knows(&implication) {
                        continue;
                    }
                    c.block(&implication, |c, block| {
                        c.suppose(&format!("{block}s"), part)?;
                        c.show(goal)
                    })?;
                }
                c.take(Rule::Cases, std::slice::from_ref(label), Some(goal.clone())).map(|_| ())
            });
            if done.is_ok() {
                return Ok(());
            }
        }
        Err(Fail::No("no disjunction helps"))
    }

    pub(super) fn show_or(&mut self, goal: &Prop, list: &[Prop]) -> Result<(), Fail> {
        let mut exprs = Vec::new();
        exprs_in(goal, &mut exprs);
        self.prepare(&exprs.iter().collect::<Vec<_>>())?;
        self.define(&exprs.iter().collect::<Vec<_>>())?;
        if self.take(Rule::Excluded, &[], Some(goal.clone())).is_ok() {
            return Ok(());
        }
        let splits = std::mem::replace(&mut self.splits, 9);
        for part in list {
            if self.attempt(|c| c.show(part)).is_ok() {
                self.splits = splits;
                return self.take(Rule::Either, &[], Some(goal.clone())).map(|_| ());
            }
        }
        self.splits = splits;
        // Suppose that all but the last are false.
        let (last, others) = list.split_last().ok_or("an empty disjunction")?;
        let (first, rest) = others.split_first().ok_or("a disjunction of one")?;
        let opposite = negation(first).ok_or("no negation")?;
        let either = prop(PropKind::Or(vec![first.clone(), opposite.clone()]));
        let either = self.take(Rule::Excluded, &[], Some(either))?;
        let implies = |p: &Prop, q: &Prop| prop(PropKind::Implies(Box::new(p.clone()), Box::new(q.clone())));
        let direct = implies(first, goal);
        self.block(&direct, |c, _| c.take(Rule::Either, &[], Some(goal.clone())).map(|_| ()))?;
        let other = implies(&opposite, goal);
        self.block(&other, |c, block| {
            c.suppose(&format!("{block}s"), &opposite)?;
            if rest.is_empty() {
                c.show(last)?;
            } else {
                let mut fewer = rest.to_vec();
                fewer.push(last.clone());
                let fewer = prop(PropKind::Or(fewer));
                c.show(&fewer)?;
                let label = c.label_of(&fewer).ok_or("a disjunction")?;
                if let PropKind::Or(parts) = &fewer.kind {
                    for part in parts {
                        c.block(&implies(part, goal), |c, _| {
                            c.take(Rule::Either, &[], Some(goal.clone())).map(|_| ())
                        })?;
                    }
                }
                return c.take(Rule::Cases, &[label], Some(goal.clone())).map(|_| ());
            }
            c.take(Rule::Either, &[], Some(goal.clone())).map(|_| ())
        })?;
        self.take(Rule::Cases, &[either], Some(goal.clone())).map(|_| ())
    }
}

/// The sides of every comparison in a proposition, but for those under quantifiers.
pub(super) fn exprs_in(p: &Prop, out: &mut Vec<Expr>) {
    match &p.kind {
        PropKind::Compare(sides, _) => out.extend(sides.iter().cloned()),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| exprs_in(p, out));
        }
        PropKind::Not(inner) => exprs_in(inner, out),
        PropKind::Implies(a, b) => {
            exprs_in(a, out);
            exprs_in(b, out);
        }
        PropKind::Exists(..) | PropKind::ForAll(..) => {}
        PropKind::Extremum(e) => {
            out.extend(e.at.iter().map(|a| a.1.clone()));
            out.push(e.value.clone());
        }
        PropKind::Limit(l) => out.extend([l.of.clone(), l.value.clone()]),
        PropKind::WrittenLimit(_) => {}
    }
}

fn is_matrix(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Matrix(_) => true,
        ExprKind::Apply(f, _) => f.text == "transpose",
        ExprKind::Negate(a) => is_matrix(a),
        ExprKind::Sum(list) => list.iter().any(|(_, e)| is_matrix(e)),
        ExprKind::Product(list) => list.iter().any(|(_, e)| is_matrix(e)),
        _ => false,
    }
}
