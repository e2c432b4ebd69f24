//! Finitely many cases: whole numbers that the facts bound are tried one by one.
//!
//! Method: bounds consistency (Apt, "Principles of Constraint Programming", 2003, chapter 6). A box gives each whole number a least
//! and a greatest value. Each comparison among the facts narrows it; a box with too many points is halved at the number with the
//! fewest values. Doubles only suggest the bounds.
//!
//! Certificate: every bound is a goal of its own, and the rule `evaluate` tries the points of a box, of which an instance is taken.
//!
//! Limits: [`WHOLES`] numbers, [`POINTS`] points of a box, [`BOXES`] boxes, [`ROUNDS`] rounds of narrowing, [`SEARCHES`] searches of a claim, [`FAR`] as the size of a
//! bound.

use super::facts::{minus, opposite};
use super::letters::{Letters, natural};
use super::{Fail, Prover, implies};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::claim::walk;
use crate::kernel::statement::{compare, name, numeral, prop, sum};
use crate::kernel::substitution::Substitution;
use crate::number::double::nearest;
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

/// The most rounds of narrowing for one box.
const ROUNDS: usize = 8;

/// A bound that leaves more than this part of a number's values is not taken.
const LITTLE: f64 = 0.7;

/// Where a bound is sought: up to this size.
const FAR: f64 = (1_u64 << 40) as f64;

/// Values from the first to the second; an end may be infinite.
type Values = (f64, f64);

const ALL: Values = (f64::NEG_INFINITY, f64::INFINITY);

/// A bound: at most, or at least, so much of the number with this place.
#[derive(Clone, Copy)]
struct Bound {
    place: usize,
    at_most: bool,
    value: f64,
}

/// A comparison of a difference with 0.
struct Row {
    difference: Polynomial,
    relation: Relation,
}

/// Whole numbers with what is known of them.
struct Problem {
    /// Each number's name, and what it is in natural numbers.
    wholes: Vec<(String, Expr)>,
    facts: Vec<Prop>,
    rows: Vec<Row>,
    letters: Letters,
}

fn times(a: Values, b: Values) -> Values {
    // 0·∞ is the value of no point: it is 0 at the end that is 0.
    let product = |x: f64, y: f64| if x == 0.0 || y == 0.0 { 0.0 } else { x * y };
    let ends = [product(a.0, b.0), product(a.0, b.1), product(a.1, b.0), product(a.1, b.1)];
    (ends.iter().copied().fold(f64::INFINITY, f64::min), ends.iter().copied().fold(f64::NEG_INFINITY, f64::max))
}

fn plus(a: Values, b: Values) -> Values {
    (a.0 + b.0, a.1 + b.1)
}

fn power(a: Values, k: u32) -> Values {
    let k = i32::try_from(k).unwrap_or(i32::MAX);
    let (low, high) = (a.0.powi(k), a.1.powi(k));
    match (k % 2 == 0, a.0 < 0.0, a.1 > 0.0) {
        (true, true, true) => (0.0, low.max(high)),
        (true, true, false) => (high, low),
        _ => (low, high),
    }
}

fn common(a: Values, b: Values) -> Values {
    (a.0.max(b.0), a.1.min(b.1))
}

/// Whether no value of a difference satisfies a comparison with 0.
fn excludes(relation: Relation, (low, high): Values) -> bool {
    match relation {
        Relation::Equal => low > 0.0 || high < 0.0,
        Relation::NotEqual => low == 0.0 && high == 0.0,
        Relation::Greater => high <= 0.0,
        Relation::GreaterEqual => high < 0.0,
        Relation::Less => low >= 0.0,
        Relation::LessEqual => low > 0.0,
    }
}

/// The number of points, 0 where there is none.
fn points(of: &[Values]) -> f64 {
    of.iter().map(|(low, high)| (high - low + 1.0).max(0.0)).product()
}

fn number(x: f64) -> Expr {
    literal(&Rational::from(x as i64))
}

/// The end of n! = product(i = 1..n, i).
fn factorial_of(e: &Expr) -> Option<&Expr> {
    let ExprKind::ProductOver(index, body) = &e.kind else { return None };
    let is_index = matches!(&body.kind, ExprKind::Name(n) if *n == index.name.text);
    (is_index && natural(&index.from) == Some(1)).then_some(&*index.to)
}

impl Problem {
    fn place(&self, e: &Expr) -> Option<usize> {
        let ExprKind::Name(n) = &e.kind else { return None };
        self.wholes.iter().position(|w| w.0 == *n)
    }

    /// The values of an expression on a box, as far as its form tells.
    fn of_letter(&self, e: &Expr, on: &[Values]) -> Values {
        if let Some(place) = self.place(e) {
            return on[place];
        }
        if let Some(to) = factorial_of(e) {
            let factorial = |n: f64| (1..=(n.clamp(0.0, 200.0) as u32)).map(f64::from).product::<f64>();
            let (low, high) = self.of_expr(to, on);
            return (factorial(low), if high > 170.0 { f64::INFINITY } else { factorial(high) });
        }
        match &e.kind {
            ExprKind::Power(base, exponent) => {
                let (base, exponent) = (self.of_expr(base, on), self.of_expr(exponent, on));
                if base.0 >= 1.0 { (base.0.powf(exponent.0.max(0.0)), base.1.powf(exponent.1)) } else { ALL }
            }
            _ => ALL,
        }
    }

    fn of_expr(&self, e: &Expr, on: &[Values]) -> Values {
        let mut letters = self.letters.clone();
        match letters.polynomial(e) {
            Some(p) if p.as_constant().is_some() => p.as_constant().map_or(ALL, |c| (nearest(&c), nearest(&c))),
            Some(p) if p.variables().iter().all(|v| letters.expr(*v).is_some_and(|l| self.place(l).is_some())) => {
                let value = |v: u32| letters.expr(v).and_then(|l| self.place(l)).map_or(ALL, |place| on[place]);
                in_form(&p, &value)
            }
            _ => ALL,
        }
    }

    /// The values of a polynomial on a box: of its monomials, and by Horner's scheme in each of its letters.
    fn of_difference(&self, p: &Polynomial, on: &[Values]) -> Values {
        let known: Vec<(u32, Values)> = p
            .variables()
            .into_iter()
            .map(|v| (v, self.letters.expr(v).map_or(ALL, |e| self.of_letter(e, on))))
            .collect();
        let value = |v: u32| known.iter().find(|k| k.0 == v).map_or(ALL, |k| k.1);
        let by_horner = |(v, x): &(u32, Values)| {
            let coefficients = p.coefficients_in(*v);
            coefficients.iter().rev().fold((0.0, 0.0), |sum, c| plus(times(sum, *x), in_form(c, &value)))
        };
        let forms = known.iter().map(by_horner).chain([in_form(p, &value)]);
        // An end that is no number is no bound.
        let read = |(a, b): Values| (if a.is_nan() { ALL.0 } else { a }, if b.is_nan() { ALL.1 } else { b });
        forms.map(read).fold(ALL, common)
    }

    fn is_excluded(&self, row: &Row, on: &[Values], place: usize, values: Values) -> bool {
        let mut part = on.to_vec();
        part[place] = values;
        excludes(row.relation, self.of_difference(&row.difference, &part))
    }

    /// The greatest value that a row leaves to a number, where it is less than the one that is known.
    fn greatest(&self, row: &Row, on: &[Values], place: usize) -> Option<f64> {
        let (low, high) = on[place];
        let (mut inside, mut outside) = (low.max(-FAR), high.min(FAR));
        if !self.is_excluded(row, on, place, (outside, high)) {
            return None;
        }
        if self.is_excluded(row, on, place, (inside, high)) {
            return (low > -FAR).then_some(inside - 1.0);
        }
        while outside - inside > 1.0 {
            let middle = ((inside + outside) / 2.0).floor();
            if self.is_excluded(row, on, place, (middle, high)) { outside = middle } else { inside = middle }
        }
        Some(outside - 1.0)
    }

    /// The same for the least value.
    fn least(&self, row: &Row, on: &[Values], place: usize) -> Option<f64> {
        let (low, high) = on[place];
        let (mut outside, mut inside) = (low.max(-FAR), high.min(FAR));
        if !self.is_excluded(row, on, place, (low, outside)) {
            return None;
        }
        if self.is_excluded(row, on, place, (low, inside)) {
            return (high < FAR).then_some(inside + 1.0);
        }
        while inside - outside > 1.0 {
            let middle = ((inside + outside) / 2.0).ceil();
            if self.is_excluded(row, on, place, (low, middle)) { outside = middle } else { inside = middle }
        }
        Some(outside + 1.0)
    }

    /// Narrows a box; the bounds in the order in which they follow from each other.
    fn narrow(&self, on: &mut [Values]) -> Vec<Bound> {
        let mut found: Vec<Bound> = Vec::new();
        for _ in 0..ROUNDS {
            let before = found.len();
            for row in &self.rows {
                for place in 0..on.len() {
                    for at_most in [true, false] {
                        let new = if at_most { self.greatest(row, on, place) } else { self.least(row, on, place) };
                        let Some(value) = new else { continue };
                        let old = on[place];
                        let new = if at_most { (old.0, value) } else { (value, old.1) };
                        // What narrows little is not worth a proof.
                        if (new.1 - new.0) + 1.0 > LITTLE * (old.1 - old.0 + 1.0) {
                            continue;
                        }
                        on[place] = new;
                        found.push(Bound { place, at_most, value });
                        if on[place].0 > on[place].1 {
                            return found;
                        }
                    }
                }
            }
            if found.len() == before {
                break;
            }
        }
        found
    }
}

/// The values of a sum of monomials.
fn in_form(p: &Polynomial, value: &dyn Fn(u32) -> Values) -> Values {
    p.terms().fold((0.0, 0.0), |sum, (monomial, c)| {
        let c = nearest(c);
        let powers = monomial.powers().iter().map(|(v, k)| power(value(*v), *k));
        plus(sum, powers.fold((c, c), times))
    })
}

/// Whether the rule `evaluate` may know a proposition in these names.
fn is_evaluated(p: &Prop, names: &BTreeSet<&str>) -> bool {
    fn of(e: &Expr, names: &mut Vec<String>) -> bool {
        match &e.kind {
            ExprKind::Name(n) => names.contains(n),
            ExprKind::Derivative(..) | ExprKind::Matrix(..) => false,
            ExprKind::Apply(f, _) if FUNCTIONS.iter().all(|g| g.0 != f.text) => false,
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
        for (k, difference) in integers {
            let ExprKind::Sum(parts) = &difference.kind else { continue };
            let [up, down] = parts.as_slice() else { continue };
            for signs in [[Sign::Plus, Sign::Minus], [Sign::Minus, Sign::Plus]] {
                let at = |part: &Expr, sign: Sign, list: &[(Sign, Expr)]| {
                    list.iter().position(|(s, e)| {
                        *s == sign && matches!((&e.kind, &part.kind), (ExprKind::Name(a), ExprKind::Name(b)) if a == b)
                    })
                };
                while let (Some(_), Some(second)) = (at(&up.1, signs[0], list), at(&down.1, signs[1], list)) {
                    list.remove(second);
                    if let Some(first) = at(&up.1, signs[0], list) {
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

fn prop_with_integers(p: &mut Prop, integers: &[(String, Expr)]) {
    match &mut p.kind {
        PropKind::Compare(sides, _) => sides.iter_mut().for_each(|e| with_integers(e, integers)),
        PropKind::And(list) | PropKind::Or(list) => list.iter_mut().for_each(|p| prop_with_integers(p, integers)),
        PropKind::Not(inner) => prop_with_integers(inner, integers),
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
        let is_part = |n: &String| {
            integers.iter().any(|(_, d)| matches!(&d.kind, ExprKind::Sum(l) if l.iter().any(|(_, e)| matches!(&e.kind, ExprKind::Name(m) if m == n))))
        };
        let wholes: Vec<(String, Expr)> =
            natural.iter().chain(&integers).filter(|w| used.contains(&w.0) && !is_part(&w.0)).cloned().collect();
        let left: BTreeSet<&str> = wholes.iter().map(|w| w.0.as_str()).collect();
        facts.retain(|p| is_evaluated(p, &left));
        if wholes.is_empty() || wholes.len() > WHOLES {
            return None;
        }
        let start =
            wholes.iter().map(|w| if integers.iter().any(|k| k.0 == w.0) { ALL } else { (0.0, ALL.1) }).collect();
        let (mut letters, mut rows) = (Letters::default(), Vec::new());
        for fact in &facts {
            let PropKind::Compare(sides, relations) = &fact.kind else { continue };
            for (pair, relation) in sides.windows(2).zip(relations) {
                if let Some(difference) = letters.polynomial(&minus(&pair[0], &pair[1])) {
                    rows.push(Row { difference, relation: *relation });
                }
            }
        }
        Some((Problem { wholes, facts, rows, letters }, start))
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
        for v in of.rows.iter().flat_map(|r| r.difference.variables()).collect::<BTreeSet<u32>>() {
            let Some(e) = of.letters.expr(v) else { continue };
            if of.place(e).is_some() {
                continue;
            }
            let (low, high) = of.of_letter(e, on);
            for (relation, end) in [(Relation::GreaterEqual, low), (Relation::LessEqual, high)] {
                if end.is_finite() && end.abs() < FAR && end == end.floor() {
                    let fact = compare(self.in_naturals(e), relation, number(end));
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
            bindings.push(Binding {
                names: vec![(Name { text: fresh.clone(), span: Span::default() }, None)],
                natural: true,
                constraints: vec![Constraint::Range(number(low - least), number(high - least))],
                indices: None,
                span: Span::default(),
            });
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

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    /// The box that is left of these values of x and y.
    fn left(rows: &[(&str, Relation)], mut on: Vec<Values>) -> Vec<Values> {
        let mut letters = Letters::default();
        let wholes: Vec<_> = ["x", "y"].iter().map(|n| ((*n).to_string(), name(n))).collect();
        let rows = rows.iter().map(|(text, relation)| {
            let difference = letters.polynomial(&crate::claim::parse::expression(text).unwrap()).unwrap();
            Row { difference, relation: *relation }
        });
        let rows = rows.collect();
        Problem { wholes, facts: Vec::new(), rows, letters }.narrow(&mut on);
        on
    }

    #[test]
    fn bounds_hold_every_solution_and_little_else() {
        let naturals = vec![(0.0, f64::INFINITY); 2];
        let product = left(&[("x*y - 2005", Relation::Equal), ("x - 2", Relation::GreaterEqual)], naturals.clone());
        assert_eq!(product, [(2.0, 2005.0), (1.0, 1002.0)]);
        assert_eq!(left(&[("2^x*3^y - 1296", Relation::Equal)], naturals.clone()), [(0.0, 10.0), (0.0, 6.0)]);
        // y^2 + 3·x^2·y^2 = 30·x^2 + 517 has the solutions x = ±2, y = ±7.
        let on = left(&[("y^2 + 3*x^2*y^2 - 30*x^2 - 517", Relation::Equal)], vec![ALL, (4.0, f64::INFINITY)]);
        assert_eq!(on[1], (4.0, 22.0));
        assert!(on[0].0 >= -6.0 && on[0].1 <= 6.0);
        assert!(left(&[("x - y", Relation::Equal)], naturals)[0].1.is_infinite());
    }
}
