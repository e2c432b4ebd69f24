//! Finitely many cases: whole numbers that the facts bound are tried one by one.
//!
//! Method: each comparison among the facts narrows a box ([`super::narrowing`]); a box with too many points is halved at the number
//! with the fewest values.
//!
//! Certificate: every bound is a goal of its own, and the rule `evaluate` tries the points of a box, of which an instance is taken.
//!
//! Limits: [`WHOLES`] numbers, [`POINTS`] points of a box, [`BOXES`] boxes, [`SEARCHES`] searches of a claim.

use super::facts::opposite;
use super::integers::difference;
use super::narrowing::{ALL, Bound, FAR, Problem, Values, points};
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::claim::walk;
use crate::kernel::statement::{compare, name, numeral, prop, sum};
use crate::kernel::substitution::Substitution;
use crate::refute::literal::literal;
use malachite::Rational;
use std::collections::BTreeSet;

/// The most whole numbers of a problem.
const WHOLES: usize = 5;

/// The most points of a box that are evaluated.
const POINTS: f64 = 2_500.0;

/// The most boxes of one search.
const BOXES: usize = 48;

/// The most searches of a claim that may fail.
pub(super) const SEARCHES: usize = 6;

fn number(x: f64) -> Expr {
    literal(&Rational::from(x as i64))
}

/// Whether the rule `evaluate` may know a proposition in these names.
fn is_evaluated(p: &Prop, names: &BTreeSet<&str>) -> bool {
    fn of(e: &Expr, names: &mut Vec<String>) -> bool {
        match &e.kind {
            ExprKind::Name(n) => names.contains(n) || n == PI,
            ExprKind::IntegralOver(..) | ExprKind::Derivative(..) | ExprKind::Matrix(..) => false,
            ExprKind::Apply(f, _) if !is_built_in(&f.text) => false,
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
                let ends = of(&index.from, names) && of(&index.to, names);
                names.push(index.name.text.clone());
                let all = ends && of(body, names);
                names.pop();
                all
            }
            _ => {
                let mut all = true;
                walk::parts(e, &mut |part| all &= of(part, names));
                all
            }
        }
    }
    match &p.kind {
        PropKind::Compare(sides, _) => {
            let mut bound = names.iter().map(|n| (*n).to_string()).collect();
            sides.iter().all(|e| of(e, &mut bound))
        }
        PropKind::And(list) | PropKind::Or(list) => list.iter().all(|p| is_evaluated(p, names)),
        PropKind::Not(inner) => is_evaluated(inner, names),
        PropKind::Implies(a, b) => is_evaluated(a, names) && is_evaluated(b, names),
        _ => false,
    }
}

/// An expression with k_up − k_down written as the name of the integer k.
fn with_integers(e: &mut Expr, integers: &[(String, Expr)]) {
    if let ExprKind::Sum(list) = &mut e.kind {
        for (k, whole) in integers {
            let Some((up, down)) = difference(whole) else { continue };
            for signs in [[Sign::Plus, Sign::Minus], [Sign::Minus, Sign::Plus]] {
                let at = |part: &str, sign: Sign, list: &[(Sign, Expr)]| {
                    list.iter().position(|(s, e)| *s == sign && matches!(&e.kind, ExprKind::Name(n) if n == part))
                };
                while let (Some(_), Some(second)) = (at(up, signs[0], list), at(down, signs[1], list)) {
                    list.remove(second);
                    if let Some(first) = at(up, signs[0], list) {
                        list[first].1 = name(k);
                    }
                }
            }
        }
        if let [(Sign::Plus, only)] = list.as_slice() {
            *e = only.clone();
        }
    }
    walk::parts_mut(e, &mut |part| with_integers(part, integers));
}

pub(super) fn prop_with_integers(p: &mut Prop, integers: &[(String, Expr)]) {
    match &mut p.kind {
        PropKind::Compare(sides, _) => sides.iter_mut().for_each(|e| with_integers(e, integers)),
        PropKind::And(list) | PropKind::Or(list) => list.iter_mut().for_each(|p| prop_with_integers(p, integers)),
        PropKind::Not(inner) | PropKind::Exists(_, inner) | PropKind::ForAll(_, inner) => {
            prop_with_integers(inner, integers)
        }
        PropKind::Implies(a, b) => [a, b].into_iter().for_each(|p| prop_with_integers(p, integers)),
        _ => {}
    }
}

impl Prover {
    /// Proves a goal by trying the whole numbers that what is assumed, and its opposite, leave.
    pub(super) fn by_boxes(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("finitely many cases");
        if self.naturals.is_empty() || self.in_boxes || self.box_searches == 0 {
            return Err(no());
        }
        let other = opposite(goal).ok_or_else(no)?;
        let (problem, start) = self.problem(Some(&other)).ok_or_else(no)?;
        let mut on = start.clone();
        problem.narrow(&mut on);
        let is_small = |(low, high): &Values| low > high || high - low < FAR / 2.0;
        if !on.iter().all(is_small) && points(&on) > 0.0 {
            return Err(no());
        }
        self.in_boxes = true;
        let shown = self.attempt(|c| {
            c.against_opposite(goal, |c, _| {
                let (problem, _) = c.problem(None).ok_or_else(no)?;
                c.on_box(goal, &problem, start, &mut BOXES.clone())
            })
        });
        self.in_boxes = false;
        if shown.is_err() {
            self.box_searches -= 1;
        }
        shown
    }

    /// The whole numbers that comparisons among the facts, and one more, relate; with the box of all their values.
    fn problem(&mut self, other: Option<&Prop>) -> Option<(Problem, Vec<Values>)> {
        let natural: Vec<(String, Expr)> = self.naturals.iter().map(|n| (n.clone(), name(n))).collect();
        let integers = self.integers.clone();
        let all: BTreeSet<&str> = natural.iter().chain(&integers).map(|w| w.0.as_str()).collect();
        let mut facts: Vec<Prop> = self.facts().iter().map(|f| (*f.1).clone()).collect();
        facts.extend(other.cloned());
        facts.iter_mut().for_each(|p| prop_with_integers(p, &integers));
        facts.retain(|p| is_evaluated(p, &all));
        let mut used = BTreeSet::new();
        facts.iter().for_each(|p| crate::kernel::names::names_in_prop(p, &mut used));
        let is_part = |n: &str| integers.iter().filter_map(|k| difference(&k.1)).any(|(up, down)| n == up || n == down);
        let wholes: Vec<(String, Expr)> =
            natural.iter().chain(&integers).filter(|w| used.contains(&w.0) && !is_part(&w.0)).cloned().collect();
        let left: BTreeSet<&str> = wholes.iter().map(|w| w.0.as_str()).collect();
        facts.retain(|p| is_evaluated(p, &left));
        if wholes.is_empty() || wholes.len() > WHOLES {
            return None;
        }
        let start =
            wholes.iter().map(|w| if integers.iter().any(|k| k.0 == w.0) { ALL } else { (0.0, ALL.1) }).collect();
        Some((Problem::new(wholes, facts), start))
    }

    /// Proves a goal on a box from facts that no point of it satisfies.
    fn on_box(&mut self, goal: &Prop, of: &Problem, mut on: Vec<Values>, left: &mut usize) -> Result<Label, Fail> {
        *left = left.checked_sub(1).ok_or(Fail::No("so many cases"))?;
        let mut known = on.clone();
        let mut failures = 2;
        for bound in of.narrow(&mut on) {
            match self.bound_of_box(of, bound, &known) {
                Ok(_) if bound.at_most => known[bound.place].1 = bound.value,
                Ok(_) => known[bound.place].0 = bound.value,
                Err(fail) if failures == 0 => return Err(fail),
                Err(_) => failures -= 1,
            }
        }
        let on = known;
        let count = points(&on);
        if count == 0.0 {
            return self.attempt(|c| c.absurd(0, goal, None));
        }
        if count <= POINTS {
            return self.at_points(goal, of, &on);
        }
        let several = (0..on.len()).filter(|place| on[*place].1 > on[*place].0);
        let width = |place: &usize| on[*place].1 - on[*place].0;
        let place = several.min_by(|a, b| width(a).total_cmp(&width(b))).ok_or(Fail::No("a number with values"))?;
        if !width(&place).is_finite() {
            return Err(Fail::No("bounds"));
        }
        let middle = ((on[place].0 + on[place].1) / 2.0).floor();
        let whole = &of.wholes[place].1;
        let case = compare(whole.clone(), Relation::LessEqual, number(middle));
        let (mut low, mut high) = (on.clone(), on);
        (low[place].1, high[place].0) = (middle, middle + 1.0);
        let below = self.block(&implies(&case, goal), |c, _| c.on_box(goal, of, low, left))?;
        let case = compare(whole.clone(), Relation::Greater, number(middle));
        let beyond = self.block(&implies(&case, goal), |c, block| {
            let shown = compare(whole.clone(), Relation::GreaterEqual, number(middle + 1.0));
            if c.known(&shown).is_none() {
                let label = c.emit(Rule::Integer { from: format!("{block}s") }, shown.clone())?;
                c.take_in(&label, &shown)?;
            }
            c.on_box(goal, of, high, left)
        })?;
        self.logic(&[&below, &beyond], goal)
    }

    /// Shows a bound, with the powers that lie above or below those at the ends of the box.
    fn bound_of_box(&mut self, of: &Problem, bound: Bound, on: &[Values]) -> Result<Label, Fail> {
        let relation = if bound.at_most { Relation::LessEqual } else { Relation::GreaterEqual };
        let shown = compare(of.wholes[bound.place].1.clone(), relation, number(bound.value));
        if let Ok(label) = self.quietly(&shown) {
            self.take_in(&label, &shown)?;
            return Ok(label);
        }
        let mut beyond = on.to_vec();
        let end = &mut beyond[bound.place];
        if bound.at_most {
            end.0 = bound.value + 1.0
        } else {
            end.1 = bound.value - 1.0
        }
        let label = self.attempt(|c| {
            c.against_opposite(&shown, |c, _| {
                c.powers_on(of, &beyond);
                c.quietly(&shown).or_else(|_| c.refuted(&shown))
            })
        })?;
        self.take_in(&label, &shown)?;
        Ok(label)
    }

    /// Adds bounds of the powers with variable exponents, where they are integers.
    fn powers_on(&mut self, of: &Problem, on: &[Values]) {
        for (e, (low, high)) in of.others(on) {
            for (relation, end) in [(Relation::GreaterEqual, low), (Relation::LessEqual, high)] {
                if end.is_finite() && end.abs() < FAR && end == end.floor() {
                    let fact = compare(self.in_naturals(&e), relation, number(end));
                    // By induction, mostly.
                    let before = (std::mem::take(&mut self.splits), std::mem::take(&mut self.inductions));
                    let shown = self.attempt(|c| c.show(&fact));
                    (self.splits, self.inductions) = before;
                    if let Ok(label) = shown {
                        let _ = self.take_in(&label, &fact);
                    }
                }
            }
        }
    }

    /// Proves a goal from facts that hold at no point of a box: they are evaluated at each.
    fn at_points(&mut self, goal: &Prop, of: &Problem, on: &[Values]) -> Result<Label, Fail> {
        let (mut there, mut here) = (Substitution::default(), Substitution::default());
        let (mut bindings, mut values) = (Vec::new(), Vec::new());
        for ((own, whole), (low, high)) in of.wholes.iter().zip(on) {
            let fresh = self.fresh("k");
            let least = low.min(0.0);
            let shift = |e: Expr, by: f64| match by {
                0.0 => e,
                _ => sum(vec![(Sign::Plus, e), (Sign::Plus, number(by))]),
            };
            there.replace(own, &shift(name(&fresh), least));
            let value = shift(whole.clone(), -least);
            here.replace(own, &shift(value.clone(), least));
            bindings.push(Binding::of(
                Name::new(&fresh),
                true,
                vec![Constraint::Range(number(low - least), number(high - least))],
            ));
            values.push((fresh, value));
        }
        let absurd = compare(numeral(0), Relation::Greater, numeral(0));
        let together = prop(PropKind::And(of.facts.clone()));
        let premise = if let [only] = of.facts.as_slice() { only } else { &together };
        let body = implies(&there.prop(premise).map_err(Fail::from)?, &absurd);
        let every = bindings.into_iter().rev().fold(body, |p, b| prop(PropKind::ForAll(vec![b], Box::new(p))));
        let mut label = self.emit(Rule::Evaluate, every)?;
        for (fresh, value) in values {
            label = self.instance_at(&label, vec![(fresh, value)])?;
        }
        let premise = here.prop(premise).map_err(Fail::from)?;
        let holds = self.quietly(&premise)?;
        let shown = self.logic(&[&label, &holds], &absurd)?;
        self.logic(&[&shown], goal)
    }
}
