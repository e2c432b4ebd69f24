//! The methods that an argument names: induction, products, means, extrema, squeezes.

use super::direct::argument;
use super::draft::Rule;
use super::goal::exprs_in;
use super::write::{named, negated, quotient};
use super::{Certifier, Fail};
use crate::certificate::Term;
use crate::claim::syntax::*;
use crate::kernel::analysis::{at_the_point, weighted_mean};
use crate::kernel::statement::{compare, domain, expr, name, numeral, one_minus, power, product, prop, sum};
use crate::kernel::substitution::Substitution;

impl Certifier {
    pub(super) fn induction(&mut self, goal: &Prop, variable: &Name, steps: &Proof) -> Result<(), Fail> {
        // The bound variable of the induction must be new.
        let mut fresh = format!("{}_step", variable.text);
        while self.checker.variables().iter().any(|v| v.name() == fresh) {
            fresh += "_";
        }
        let statement = self.checker.statement().clone();
        let declared =
            statement.bindings.iter().find(|b| b.names.iter().any(|n| n.0.text == variable.text && n.1.is_none()));
        let constraints: Vec<Constraint> = declared
            .map(|b| b.constraints.clone())
            .unwrap_or_default()
            .into_iter()
            .filter(|c| {
                matches!(c, Constraint::Relation(Relation::GreaterEqual, Expr { kind: ExprKind::Number(_), .. }))
            })
            .collect();
        let base = match constraints.first() {
            Some(Constraint::Relation(_, bound)) => bound.clone(),
            _ => numeral(0),
        };
        let mut map = Substitution::default();
        map.replace(&variable.text, &name(&fresh));
        let body = map.prop(goal).map_err(Fail::from)?;
        let at = |value: &Expr| -> Result<Prop, Fail> {
            let mut map = Substitution::default();
            map.replace(&fresh, value);
            map.prop(&body).map_err(Fail::from)
        };
        let next = expr(ExprKind::Sum(vec![(Sign::Plus, name(&fresh)), (Sign::Plus, numeral(1))]));
        let binding = Binding {
            names: vec![(Name { text: fresh.clone(), span: Span::default() }, None)],
            natural: true,
            constraints,
            indices: None,
            span: Span::default(),
        };
        let every = |body: Prop| prop(PropKind::ForAll(vec![binding.clone()], Box::new(body)));
        let first = at(&base)?;
        self.show(&first).map_err(|e| e.within("base"))?;
        let advance = prop(PropKind::Implies(Box::new(body.clone()), Box::new(at(&next)?)));
        let values = self.values.clone();
        self.values.replace(&variable.text, &name(&fresh));
        let all = every(advance.clone());
        let done = self.block(&all, |c, outer| {
            c.enter(outer)?;
            let mut exprs = Vec::new();
            exprs_in(&body, &mut exprs);
            exprs_in(&at(&next)?, &mut exprs);
            let mut inside = Vec::new();
            argument::exprs_in(steps, &exprs_in, &mut inside);
            for e in &inside {
                exprs.push(c.put_expr(e)?);
            }
            c.prepare(&exprs.iter().collect::<Vec<_>>())?;
            let mut premise = Vec::new();
            exprs_in(&body, &mut premise);
            c.define(&premise.iter().collect::<Vec<_>>())?;
            c.block(&advance, |c, inner| {
                c.labels.push(("induction".to_string(), body.clone()));
                c.suppose(&format!("{inner}s"), &body)?;
                c.follow(&at(&next)?, steps)
            })
        });
        self.values = values;
        done?;
        let whole = every(body.clone());
        let label = self.take(Rule::Induction, &[], Some(whole))?;
        let with = vec![named(&fresh, &name(&variable.text))];
        self.with(Rule::Instance, &[label], Some(goal.clone()), with).map(|_| ())
    }

    /// A fact with both sides to a power.
    pub(super) fn power_of(&mut self, fact: &str, exponent: &Expr) -> Result<(), Fail> {
        let fact = self.labelled(fact)?;
        let PropKind::Compare(sides, relations) = &fact.kind else { return Err(Fail::No("a comparison is needed")) };
        let label = self.label_of(&fact).ok_or("a fact")?;
        for e in sides.iter().chain([exponent]) {
            self.show(&compare(e.clone(), Relation::Greater, numeral(0)))?;
        }
        self.raised(&label, (&sides[0], relations[0], &sides[1]), exponent)
    }

    /// Both sides of a known comparison to a power; that they and the exponent are positive is seen.
    pub(super) fn raised(
        &mut self,
        label: &str,
        (x, relation, y): (&Expr, Relation, &Expr),
        exponent: &Expr,
    ) -> Result<(), Fail> {
        let (a, b) = (power(x, exponent), power(y, exponent));
        self.prepare(&[&a, &b])?;
        let shown = compare(a, relation, b);
        let with = vec![named("exponent", exponent)];
        let label = self.with(Rule::Monotone, &[label.to_string()], Some(shown.clone()), with)?;
        self.suppose(&label, &shown)
    }

    /// The product of comparisons between positive sides, by telescoping.
    pub(super) fn product(&mut self, goal: &Prop, list: &[(Name, Option<Expr>)]) -> Result<(), Fail> {
        let mut pairs = Vec::new();
        let mut strict = false;
        for (fact, exponent) in list {
            if exponent.is_some() {
                return Err(Fail::No("powers in a product"));
            }
            let fact = self.labelled(&fact.text)?;
            let PropKind::Compare(sides, relations) = &fact.kind else { return Err(Fail::No("a comparison")) };
            let label = self.label_of(&fact).ok_or("a fact")?;
            strict |= matches!(relations[0], Relation::Greater | Relation::Less);
            let up = matches!(relations[0], Relation::Greater | Relation::GreaterEqual);
            let (high, low) = if up { (&sides[0], &sides[1]) } else { (&sides[1], &sides[0]) };
            self.prepare(&[high, low])?;
            self.unfold_all(&[high, low])?;
            pairs.push((high.clone(), low.clone(), label, up));
        }
        let highs: Vec<Expr> = pairs.iter().map(|p| p.0.clone()).collect();
        let lows: Vec<Expr> = pairs.iter().map(|p| p.1.clone()).collect();
        let (a, b) = (quotient(highs.clone(), Vec::new()), quotient(lows.clone(), Vec::new()));
        let relation = if strict { Relation::Greater } else { Relation::GreaterEqual };
        let mut terms = Vec::new();
        for (place, (_, _, label, up)) in pairs.iter().enumerate() {
            let mut factors: Vec<Expr> = lows.iter().take(place).cloned().collect();
            factors.extend(highs.iter().skip(place + 1).cloned());
            let factor = quotient(factors, Vec::new());
            let factor = if *up { factor } else { negated(factor) };
            terms.push(Term { facts: vec![label.clone()], factor });
        }
        let shown = compare(a, relation, b);
        let label = self.combination(shown.clone(), None, terms)?;
        self.suppose(&label, &shown)?;
        self.show(goal)
    }

    /// The weighted mean inequality, strict where the kernel sees that it is.
    pub(super) fn mean(&mut self, a: &Expr, b: &Expr, p: &Expr) -> Result<(String, bool), Fail> {
        let rest = one_minus(p);
        for e in [a, b] {
            self.show(&compare(e.clone(), Relation::Greater, numeral(0)))?;
            let f = self.checker.scalar(e).map_err(Fail::from)?;
            for poly in f.factors.keys() {
                let _ = self.settle(poly, 2);
            }
        }
        for e in [p, &rest] {
            let positive = compare(e.clone(), Relation::Greater, numeral(0));
            if self.attempt(|c| c.show(&positive)).is_err() {
                self.show(&compare(e.clone(), Relation::GreaterEqual, numeral(0)))?;
            }
        }
        let apart = compare(a.clone(), Relation::NotEqual, b.clone());
        let strict = self.attempt(|c| c.comparison(a, Relation::NotEqual, b)).is_ok()
            || self.attempt(|c| c.by_powers(&apart, &[Relation::NotEqual])).is_ok();
        self.prepare(&[&product(vec![power(a, &rest), power(b, p)])])?;
        let with = vec![named("a", a), named("b", b), named("p", p)];
        for (relation, possible) in [(Relation::Less, strict), (Relation::LessEqual, true)] {
            if possible {
                let shown = weighted_mean(a, b, p, relation);
                if let Ok(label) = self.with(Rule::Mean, &[], Some(shown.clone()), with.clone()) {
                    self.suppose(&label, &shown)?;
                    return Ok((label, relation == Relation::Less));
                }
            }
        }
        Err(Fail::No("the mean inequality"))
    }

    /// A comparison of values that are powers of others, from a fact that compares those.
    pub(super) fn by_powers(&mut self, goal: &Prop, wanted: &[Relation]) -> Result<(), Fail> {
        let PropKind::Compare(goal_sides, goal_relations) = &goal.kind else { return Err(Fail::No("no comparison")) };
        let goal_relation = goal_relations[0];
        let list = self.facts();
        for (label, fact) in list.iter().rev() {
            let PropKind::Compare(sides, relations) = &fact.kind else { continue };
            let ([x, y], [relation]) = (sides.as_slice(), relations.as_slice()) else { continue };
            if !wanted.contains(relation) {
                continue;
            }
            let Ok(f) = self.checker.scalar(x) else { continue };
            for exponent in self.exponents_of(&f) {
                let done = self.attempt(|c| {
                    // Not every exponent is positive; that has to be seen at once.
                    c.comparison(&exponent, Relation::Greater, &numeral(0))?;
                    c.raised(label, (x, *relation, y), &exponent)?;
                    c.comparison(&goal_sides[0], goal_relation, &goal_sides[1])
                });
                if done.is_ok() {
                    return Ok(());
                }
            }
        }
        Err(Fail::No("no power of a fact helps"))
    }

    /// (a+b)^(1−p) (c+d)^p ≥ a^(1−p) c^p + b^(1−p) d^p: the mean of a/(a+b) and c/(c+d), that of b/(a+b)
    /// and d/(c+d), added.
    pub(super) fn hoelder(&mut self, goal: &Prop, [a, b, c, d]: [Expr; 4], p: &Expr) -> Result<(), Fail> {
        let plus = |x: &Expr, y: &Expr| sum(vec![(Sign::Plus, x.clone()), (Sign::Plus, y.clone())]);
        let times = |x: Expr, y: Expr| product(vec![x, y]);
        let over = |x: &Expr, y: &Expr| quotient(vec![x.clone()], vec![y.clone()]);
        let rest = one_minus(p);
        let (ab, cd) = (plus(&a, &b), plus(&c, &d));
        let big = times(power(&ab, &rest), power(&cd, p));
        let small = plus(&times(power(&a, &rest), power(&c, p)), &times(power(&b, &rest), power(&d, p)));
        let means = [(over(&a, &ab), over(&c, &cd)), (over(&b, &ab), over(&d, &cd))];
        let mut all = vec![big.clone(), small.clone()];
        for (x, y) in &means {
            all.push(power(x, &rest));
            all.push(power(y, p));
        }
        self.prepare(&all.iter().collect::<Vec<_>>())?;
        let mut terms = Vec::new();
        let mut strict = false;
        for (x, y) in &means {
            let (label, is_strict) = self.mean(x, y, p)?;
            strict |= is_strict;
            terms.push(Term { facts: vec![label], factor: negated(big.clone()) });
        }
        let relation = if strict { Relation::Greater } else { Relation::GreaterEqual };
        let shown = compare(big, relation, small);
        let label = self.combination(shown.clone(), None, terms)?;
        self.suppose(&label, &shown)?;
        self.show(goal)
    }

    pub(super) fn extremum(&mut self, goal: &Prop, e: &Extremum) -> Result<(), Fail> {
        let mut at = Substitution::default();
        e.at.iter().for_each(|(n, v)| at.replace(&n.text, v));
        for fact in e.over.iter().flat_map(domain) {
            let fact = at.prop(&fact).map_err(Fail::from)?;
            self.show(&fact)?;
        }
        self.show(&compare(at.expr(&e.of).map_err(Fail::from)?, Relation::Equal, e.value.clone()))?;
        let every = |body: Prop| prop(PropKind::ForAll(e.over.clone(), Box::new(body)));
        let relation = if e.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
        self.show(&every(compare(e.of.clone(), relation, e.value.clone())))?;
        if e.unique {
            let there = at_the_point(e).ok_or("an extremum has a point")?;
            let equal = compare(e.of.clone(), Relation::Equal, e.value.clone());
            self.show(&every(prop(PropKind::Implies(Box::new(equal), Box::new(there)))))?;
        }
        self.take(Rule::Extremum, &[], Some(goal.clone())).map(|_| ())
    }

    pub(super) fn squeeze(&mut self, goal: &Prop, lower: Expr, upper: Expr) -> Result<(), Fail> {
        let PropKind::Limit(limit) = &goal.kind else { return Err(Fail::No("`squeeze` proves limits only")) };
        for bound in [&lower, &upper] {
            let same = Limit { of: bound.clone(), ..(**limit).clone() };
            self.show(&prop(PropKind::Limit(Box::new(same))))?;
        }
        self.show(&compare(lower.clone(), Relation::LessEqual, limit.of.clone()))?;
        self.show(&compare(limit.of.clone(), Relation::LessEqual, upper.clone()))?;
        let with = vec![named("lower", &lower), named("upper", &upper)];
        self.with(Rule::Squeeze, &[], Some(goal.clone()), with).map(|_| ())
    }
}
