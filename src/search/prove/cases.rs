//! Case distinctions, and conclusions of implications whose premises are known.

use super::facts::{is_settled, minus, opposite};
use super::products::Kind;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};
use std::collections::BTreeSet;
use std::rc::Rc;

impl Prover {
    /// Adds the conclusions of implications and equivalences whose premises are known. Returns whether there were any.
    pub(crate) fn saturate(&mut self) -> bool {
        self.conclude(&mut |c, premise| c.quietly(premise).ok())
    }

    /// The same, for premises that the kernel sees.
    pub(super) fn conclude_at_once(&mut self) -> bool {
        self.conclude(&mut |c, premise| match &premise.kind {
            PropKind::Compare(..) => c.known(premise).or_else(|| c.combination(premise.clone(), Vec::new()).ok()),
            _ => c.known(premise),
        })
    }

    fn conclude(&mut self, shown: &mut dyn FnMut(&mut Prover, &Prop) -> Option<Label>) -> bool {
        let list = self.facts();
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
                let Some(premise) = shown(self, &p) else { continue };
                if let Ok(new) = self.logic(&[&label, &premise], &q) {
                    let _ = self.take_in(&new, &q);
                    changed = true;
                }
            }
        }
        changed
    }

    /// Distinguishes cases.
    pub(crate) fn by_cases(&mut self, goal: &Prop) -> Result<Label, Fail> {
        if self.splits >= 3 {
            return Err(Fail::NotShown(crate::claim::print::prop(goal)));
        }
        if let Ok(label) = self.by_disjunction(goal) {
            return Ok(label);
        }
        let list = self.facts();
        for case in self.cases(goal, &list)? {
            let Some(other) = opposite(&case) else { continue };
            let done = self.attempt(|c| {
                c.splits += 1;
                let x = c.block(&implies(&case, goal), |c, block| {
                    c.put_in(&format!("{block}s"));
                    c.solve_equations();
                    c.put_in_zeros();
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

    /// Shows a goal in each case of a disjunction among the facts.
    pub(super) fn by_disjunction(&mut self, goal: &Prop) -> Result<Label, Fail> {
        for (label, fact) in self.facts().iter().rev() {
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
        Err(Fail::No("a disjunction"))
    }

    /// Cases to distinguish for a comparison, likely ones first: signs of factors and letters, orders of variables, sums that
    /// may be 0.
    fn cases(&mut self, goal: &Prop, list: &[(Label, Rc<Prop>)]) -> Result<Vec<Prop>, Fail> {
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(Fail::No("a comparison is needed")) };
        let (mut cases, mut sums): (Vec<Prop>, Vec<Prop>) = Default::default();
        let mut seen = BTreeSet::new();
        for fact in list.iter().map(|f| &*f.1).chain([goal]) {
            let PropKind::Compare(sides, relations) = &fact.kind else { continue };
            if relations.len() > 1 {
                continue;
            }
            let Some(reading) = self.read(&minus(&sides[0], &sides[1]), true) else { continue };
            if relations[0] == Relation::NotEqual && !is_settled(self.signs_of(&minus(&sides[0], &sides[1]))) {
                cases.push(compare(sides[0].clone(), Relation::Greater, sides[1].clone()));
            }
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
                    let is_sum = matches!(e.kind, ExprKind::SumOver(..));
                    let kind = is_sum || matches!(e.kind, ExprKind::Name(_));
                    if kind && seen.insert(crate::kernel::key::expr(&e)) {
                        let case = self.case_of_letter(e);
                        if is_sum { sums.extend(case) } else { cases.extend(case) }
                    }
                }
            }
        }
        if relations[0] == Relation::GreaterEqual || relations[0] == Relation::LessEqual {
            cases.push(compare(sides[0].clone(), Relation::Equal, sides[1].clone()));
        }
        cases.truncate(4);
        cases.extend(self.orders(goal));
        cases.extend(sums);
        Ok(cases)
    }

    /// The case to distinguish for a letter whose sign is open: whether it is 0, or at least 0.
    fn case_of_letter(&mut self, e: Expr) -> Option<Prop> {
        let signs = self.signs_of(&e);
        if is_settled(signs) {
            return None;
        }
        let natural = matches!(&e.kind, ExprKind::Name(n) if self.naturals.contains(n));
        if natural || signs.within(Signs::NOT_NEGATIVE) {
            return Some(compare(e, Relation::Equal, numeral(0)));
        }
        match e.kind {
            ExprKind::SumOver(..) => None,
            _ => Some(compare(e, Relation::GreaterEqual, numeral(0))),
        }
    }

    /// Substitutes 0 for each letter whose square is not positive according to a fact.
    fn put_in_zeros(&mut self) {
        let list = self.facts();
        for (label, fact) in list {
            let Some(known) = self.known_of(&label, &fact) else { continue };
            let mut terms = known.poly.terms();
            let (Some((m, c)), None) = (terms.next(), terms.next()) else { continue };
            let [(v, k)] = *m.powers() else { continue };
            if known.kind != Kind::Weak || *c > 0 || k % 2 == 1 {
                continue;
            }
            let Some(e) = self.letters.expr(v).cloned() else { continue };
            if let Ok(zero) = self.attempt(|c| {
                c.splits = 8;
                c.show(&compare(e, Relation::Equal, numeral(0)))
            }) {
                self.put_in(&zero);
            }
        }
    }

    /// Cases by the order of two variables, and of a natural number and a small numeral.
    fn orders(&mut self, goal: &Prop) -> Vec<Prop> {
        let mut names = BTreeSet::new();
        crate::kernel::names::names_in_prop(goal, &mut names);
        names.retain(|n| self.is_a_name(n));
        let variable = |n: &String| crate::kernel::statement::name(n);
        let naturals: Vec<String> = names.iter().filter(|n| self.naturals.contains(n)).cloned().collect();
        let mut out = Vec::new();
        for (i, m) in naturals.iter().enumerate() {
            for n in naturals.iter().skip(i + 1) {
                out.push(compare(variable(m), Relation::LessEqual, variable(n)));
                out.push(compare(variable(n), Relation::LessEqual, variable(m)));
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
