//! Goals proved by contradiction, and by chains of comparisons.

use super::draft::{Rule, negation};
use super::write::negated;
use super::{Certifier, Fail};
use crate::certificate::Term;
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral, prop};
use crate::kernel::text;

impl Certifier {
    /// A fact that compares two numbers and is false.
    pub(super) fn contradiction(&mut self) -> Option<String> {
        let list = self.facts();
        for (label, fact) in list.into_iter().rev() {
            if let Ok((difference, relation)) = self.checker.difference(&fact)
                && let Some(number) = difference.as_number()
                && !Signs::of_number(number).within(Signs::of(relation))
            {
                return Some(label);
            }
        }
        self.opposite_signs()
    }

    /// A false comparison of numbers from an equation whose sides are known to differ, by the signs noted.
    fn opposite_signs(&mut self) -> Option<String> {
        let list = self.facts();
        for (label, fact) in list.into_iter().rev() {
            let PropKind::Compare(sides, relations) = &fact.kind else { continue };
            let ([a, b], [Relation::Equal]) = (sides.as_slice(), relations.as_slice()) else { continue };
            let Ok((difference, _)) = self.checker.difference(&fact) else { continue };
            let Ok(signs) = self.checker.signs_of(&difference) else { continue };
            if !(signs.within(Signs::NOT_ZERO) && signs.within(Signs::ZERO)) {
                continue;
            }
            let apart = compare(a.clone(), Relation::NotEqual, b.clone());
            let found = self.attempt(|c| {
                let other = c.take(Rule::Sign, &[], Some(apart))?;
                c.difference_of(&label, &other, Relation::NotEqual)
            });
            if let Ok(found) = found {
                return Some(found);
            }
        }
        None
    }

    /// `0 relation 0` from two facts about one difference, which the first less the second gives.
    fn difference_of(&mut self, first: &str, second: &str, relation: Relation) -> Result<String, Fail> {
        let term = |label: &str, factor: Expr| Term { facts: vec![label.to_string()], factor };
        let terms = vec![term(first, numeral(1)), term(second, negated(numeral(1)))];
        self.combination(compare(numeral(0), relation, numeral(0)), None, terms)
    }

    /// Adds the conclusions of implications and equivalences whose premises are immediate.
    pub(super) fn saturate(&mut self) -> Result<bool, Fail> {
        let mut changed = false;
        let list = self.facts();
        for (label, fact) in list {
            let pairs: Vec<(Prop, Prop)> = match &fact.kind {
                PropKind::Implies(p, q) => vec![((**p).clone(), (**q).clone())],
                PropKind::Equivalent(parts) => parts
                    .iter()
                    .flat_map(|p| parts.iter().map(move |q| (p.clone(), q.clone())))
                    .filter(|(p, q)| text::prop(p) != text::prop(q))
                    .collect(),
                _ => continue,
            };
            for (p, q) in pairs {
                if self.checker.knows(&q) {
                    continue;
                }
                let splits = std::mem::replace(&mut self.splits, 9);
                let premise = self.attempt(|c| match &p.kind {
                    PropKind::Compare(sides, relations) if relations.len() == 1 => {
                        c.comparison(&sides[0], relations[0], &sides[1])
                    }
                    PropKind::And(parts) => {
                        for part in parts {
                            let PropKind::Compare(sides, relations) = &part.kind else {
                                return Err(Fail::No("deep"));
                            };
                            c.comparison(&sides[0], relations[0], &sides[1])?;
                        }
                        c.take(Rule::All, &[], Some(p.clone())).map(|_| ())
                    }
                    _ => Err(Fail::No("not at once")),
                });
                self.splits = splits;
                if premise.is_ok()
                    && let Ok(new) = self.take(Rule::Apply, std::slice::from_ref(&label), Some(q.clone()))
                {
                    self.suppose(&new, &q)?;
                    changed = true;
                }
            }
        }
        Ok(changed)
    }

    /// Proves a comparison as the sum of a chain of facts in which each right side is the next left side.
    pub(super) fn transitive(&mut self, goal: &Prop, a: &Expr, relation: Relation, b: &Expr) -> Result<(), Fail> {
        let (from, to) = match relation {
            Relation::Greater | Relation::GreaterEqual => (a, b),
            Relation::Less | Relation::LessEqual => (b, a),
            _ => return Err(Fail::No("no chain")),
        };
        let mut edges: Vec<(Expr, Expr, String, bool)> = Vec::new();
        for fact in self.checker.facts() {
            let PropKind::Compare(sides, relations) = &fact.prop().kind else { continue };
            let ([x, y], [r]) = (sides.as_slice(), relations.as_slice()) else { continue };
            if matches!(r, Relation::Greater | Relation::GreaterEqual | Relation::Equal) {
                edges.push((x.clone(), y.clone(), fact.label().to_string(), true));
            }
            if matches!(r, Relation::Less | Relation::LessEqual | Relation::Equal) {
                edges.push((y.clone(), x.clone(), fact.label().to_string(), false));
            }
        }
        let mut paths: Vec<(Expr, Vec<(String, bool)>)> = vec![(from.clone(), Vec::new())];
        for _ in 0..5 {
            let mut next = Vec::new();
            for (at, path) in &paths {
                for (x, y, label, forward) in &edges {
                    if x != at || path.iter().any(|p| p.0 == *label) {
                        continue;
                    }
                    let mut longer = path.clone();
                    longer.push((label.clone(), *forward));
                    if y == to {
                        let up = matches!(relation, Relation::Greater | Relation::GreaterEqual);
                        let terms = longer
                            .iter()
                            .map(|(label, forward)| {
                                let one = numeral(1);
                                let factor = if *forward == up { one } else { negated(one) };
                                Term { facts: vec![label.clone()], factor }
                            })
                            .collect();
                        if self.combination(goal.clone(), None, terms).is_ok() {
                            return Ok(());
                        }
                    }
                    next.push((y.clone(), longer));
                }
            }
            next.truncate(200);
            paths = next;
        }
        Err(Fail::No("no chain"))
    }

    pub(super) fn by_contradiction(&mut self, goal: &Prop) -> Result<(), Fail> {
        let opposite = negation(goal).ok_or("no negation")?;
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(Fail::No("no comparison")) };
        let sides: Vec<&Expr> = sides.iter().collect();
        self.define(&sides)?;
        let either = prop(PropKind::Or(vec![goal.clone(), opposite.clone()]));
        let either = self.take(Rule::Excluded, &[], Some(either))?;
        let same = prop(PropKind::Implies(Box::new(goal.clone()), Box::new(goal.clone())));
        self.block(&same, |_, _| Ok(()))?;
        let other = prop(PropKind::Implies(Box::new(opposite.clone()), Box::new(goal.clone())));
        let (a, relation, b) = (sides[0].clone(), relations[0], sides[1].clone());
        self.block(&other, |c, block| {
            c.suppose(&format!("{block}s"), &opposite)?;
            if c.comparison(&a, relation, &b).is_ok() {
                return Ok(());
            }
            if c.saturate()? && c.comparison(&a, relation, &b).is_ok() {
                return Ok(());
            }
            if let Some(label) = c.contradiction() {
                return c.take(Rule::Absurd, &[label], Some(goal.clone())).map(|_| ());
            }
            c.clash(goal)
        })?;
        self.take(Rule::Cases, &[either], Some(goal.clone())).map(|_| ())
    }

    /// Facts that contradict each other: two that say opposite things of the same difference.
    fn clash(&mut self, goal: &Prop) -> Result<(), Fail> {
        let list = self.facts();
        for (_, fact) in list.iter().rev() {
            let PropKind::Compare(sides, relations) = &fact.kind else { continue };
            if relations.len() != 1 {
                continue;
            }
            // An expression that a fact says to be 0 may have a known sign other than 0.
            if relations[0] == Relation::Equal
                && let Ok((difference, _)) = self.checker.difference(fact)
            {
                for poly in difference.factors.keys() {
                    let done = self.attempt(|c| {
                        c.search_again(poly)?;
                        match &goal.kind {
                            PropKind::Compare(g, r) => c.comparison(&g[0], r[0], &g[1]),
                            _ => Err(Fail::No("no comparison")),
                        }
                    });
                    if done.is_ok() {
                        return Ok(());
                    }
                }
            }
            // A fact whose opposite is shown as well.
            let Some(opposite) = negation(fact) else { continue };
            let PropKind::Compare(_, relations) = &opposite.kind else { continue };
            let (a, b) = (sides[0].clone(), sides[1].clone());
            let relation = relations[0];
            if self.attempt(|c| c.comparison(&a, relation, &b)).is_ok() {
                let both = [self.label_of(fact), self.label_of(&opposite)];
                let [Some(x), Some(y)] = both else { continue };
                let wrong = [(&x, &y, Relation::NotEqual), (&x, &y, Relation::Less), (&y, &x, Relation::Less)];
                for (first, second, relation) in wrong {
                    if let Ok(label) = self.difference_of(first, second, relation) {
                        return self.take(Rule::Absurd, &[label], Some(goal.clone())).map(|_| ());
                    }
                }
            }
        }
        Err(Fail::No("no contradiction"))
    }
}
