//! Distinctions of cases, and conclusions of implications whose premises are seen.

use super::facts::{is_settled, minus, opposite};
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};
use std::collections::BTreeSet;

impl Prover {
    /// Conclusions of implications and equivalences whose premises are seen; whether there were any.
    pub fn saturate(&mut self) -> bool {
        let list: Vec<(Label, Prop)> = self.checker.facts().map(|(l, p)| (l.to_string(), p.clone())).collect();
        let mut changed = false;
        for (label, fact) in list {
            let pairs: Vec<(Prop, Prop)> = match &fact.kind {
                PropKind::Implies(p, q) => vec![((**p).clone(), (**q).clone())],
                PropKind::Equivalent(parts) if parts.len() == 2 => {
                    vec![(parts[0].clone(), parts[1].clone()), (parts[1].clone(), parts[0].clone())]
                }
                _ => continue,
            };
            for (p, q) in pairs {
                if self.known(&q).is_some() {
                    continue;
                }
                let Ok(premise) = self.quietly(&p) else { continue };
                if let Ok(new) = self.logic(&[&label, &premise], &q) {
                    let _ = self.take_in(&new, &q);
                    changed = true;
                }
            }
        }
        changed
    }

    /// Distinguishes cases.
    pub fn by_cases(&mut self, goal: &Prop) -> Result<Label, Fail> {
        if self.splits >= 3 {
            return Err(Fail::NotShown(crate::claim::print::prop(goal)));
        }
        let list: Vec<(Label, Prop)> = self.checker.facts().map(|(l, p)| (l.to_string(), p.clone())).collect();
        for (label, fact) in list.iter().rev() {
            let PropKind::Or(parts) = &fact.kind else { continue };
            let used: Vec<Prop> = parts.iter().map(|p| implies(p, goal)).collect();
            if used.iter().any(|p| self.known(p).is_some()) || parts.iter().any(|p| self.known(p).is_some()) {
                continue;
            }
            let done = self.attempt(|c| {
                c.splits += 1;
                let mut from = vec![label.clone()];
                for case in &used {
                    from.push(c.block(case, |c, _| c.show(goal))?);
                }
                c.splits -= 1;
                c.emit(Rule::Logic { from }, goal.clone())
            });
            if done.is_ok() {
                return done;
            }
        }
        let mut cases: Vec<Prop> = Vec::new();
        let mut seen = BTreeSet::new();
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(Fail::No("a comparison is needed")) };
        for fact in list.iter().map(|f| &f.1).chain([goal]) {
            let PropKind::Compare(sides, relations) = &fact.kind else { continue };
            if relations.len() > 1 {
                continue;
            }
            let Some(reading) = self.read(&minus(&sides[0], &sides[1]), true) else { continue };
            let several = reading.factors.len() > 1;
            for f in &reading.factors {
                if several && !is_settled(f.signs) {
                    let e = self.letters.written(&f.poly);
                    if seen.insert(crate::kernel::key::expr(&e)) {
                        cases.push(compare(e, Relation::GreaterEqual, numeral(0)));
                    }
                }
                for v in f.poly.variables() {
                    let Some(e) = self.letters.expr(v).cloned() else { continue };
                    if !matches!(e.kind, ExprKind::Name(_)) || !seen.insert(crate::kernel::key::expr(&e)) {
                        continue;
                    }
                    let signs = self.signs_of(&e);
                    if !is_settled(signs) {
                        let natural = matches!(&e.kind, ExprKind::Name(n) if self.naturals.contains(n));
                        let relation = if natural || signs.within(Signs::NOT_NEGATIVE) {
                            Relation::Equal
                        } else {
                            Relation::GreaterEqual
                        };
                        cases.push(compare(e, relation, numeral(0)));
                    }
                }
            }
        }
        if relations[0] == Relation::GreaterEqual || relations[0] == Relation::LessEqual {
            cases.push(compare(sides[0].clone(), Relation::Equal, sides[1].clone()));
        }
        cases.truncate(4);
        cases.extend(self.orders(goal));
        for case in cases {
            let Some(other) = opposite(&case) else { continue };
            let done = self.attempt(|c| {
                c.splits += 1;
                let x = c.block(&implies(&case, goal), |c, _| {
                    c.solve_equations();
                    c.show(goal)
                })?;
                let y = c.block(&implies(&other, goal), |c, _| c.show(goal))?;
                c.splits -= 1;
                c.logic(&[&x, &y], goal)
            });
            if done.is_ok() {
                return done;
            }
        }
        Err(Fail::NotShown(crate::claim::print::prop(goal)))
    }

    /// Cases by the order of two variables, and of a natural number and a small numeral.
    fn orders(&mut self, goal: &Prop) -> Vec<Prop> {
        let mut names = BTreeSet::new();
        crate::kernel::statement::names_in_prop(goal, &mut names);
        let variable = |n: &String| crate::kernel::statement::name(n);
        let naturals: Vec<String> = names.iter().filter(|n| self.naturals.contains(n)).cloned().collect();
        let mut out = Vec::new();
        for (i, m) in naturals.iter().enumerate() {
            for n in naturals.iter().skip(i + 1) {
                out.push(compare(variable(m), Relation::LessEqual, variable(n)));
            }
            out.extend([1, 2, 3].map(|k| compare(variable(m), Relation::LessEqual, numeral(k))));
        }
        if naturals.is_empty() && names.len() <= 3 && self.splits < 2 {
            let names: Vec<&String> = names.iter().collect();
            for (i, x) in names.iter().enumerate() {
                for y in names.iter().skip(i + 1) {
                    let p = compare(variable(x), Relation::GreaterEqual, variable(y));
                    if let Some(o) = opposite(&p)
                        && self.known(&p).is_none()
                        && self.known(&o).is_none()
                    {
                        out.push(p);
                    }
                }
            }
            out.truncate(2);
        }
        out
    }
}
