//! Jensen's inequality with weights: f(Σ w·x) beside Σ w·f(x) for weights that add up to 1 and a function f that is convex or concave,
//! `ln(t*a + (1 - t)*b) >= t*ln(a) + (1 - t)*ln(b)`.
//!
//! Method (J. L. W. V. Jensen, 1906): the graph of f lies on one side of its tangents, f(u) >= f(v) + f′(v)·(u − v). That is shown once,
//! for all u and v within the bounds that the values x share, by the same search, and taken at each x and at the mean v = Σ w·x.
//! These instances, each times its weight, add up to the goal.
//!
//! What is a mean of what is read from a sum in the goal, multiplied out: each of its terms holds one value, or none, which then is 1;
//! weights that add up to less leave the rest for 0.
//!
//! Limits: [`TERMS`] and [`WAYS`]. Sums over an index are left to `members`, powers of sums to `hoelder`.

use super::comparison::single;
use super::facts::{minus, negated, scaled};
use super::letters::{product, summands_of, total, whole_power};
use super::limits::plus;
use super::slopes::put_in;
use super::sums::{occurs, replace};
use super::{Fail, Prover, implies};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::claim::walk::parts;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, name, numeral, prop};
use crate::refute::literal::literal;
use malachite::Rational;

/// The most terms of a mean, multiplied out.
const TERMS: usize = 8;

/// The most ways in which a sum is read as a mean.
const WAYS: usize = 24;

/// The most sums in a goal that are read so.
const SUMS: usize = 4;

/// Values with their weights.
type Mean = Vec<(Expr, Expr)>;

/// A function of a name.
struct Function {
    of: String,
    value: Expr,
    /// Whether it lies above its tangents; else it lies below them.
    is_convex: bool,
}

impl Function {
    fn at(&self, place: &Expr) -> Result<Expr, Fail> {
        put_in(&self.value, &self.of, place)
    }
}

impl Prover {
    /// Shows an order of the value of a function at a mean and the mean of its values.
    pub(super) fn by_jensen(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("the value at a mean");
        let (a, relation, b) = single(goal)?;
        let up = relation.is_greater().ok_or_else(no)?;
        // greater − less.
        let mut terms = Vec::new();
        summands_of(&if up { minus(a, b) } else { minus(b, a) }, Sign::Plus, &mut terms);
        let mut sums = Vec::new();
        terms.iter().for_each(|(_, e)| inner_sums(e, false, &mut sums));
        if sums.is_empty() || sums.len() > SUMS || terms.len() < 2 {
            return Err(no());
        }
        let as_written = self.attempt(|c| c.by_means_in(goal, &terms, &sums));
        as_written.or_else(|_| self.with_solved_equations(|c| c.by_means_in(goal, &terms, &sums)))
    }

    fn by_means_in(&mut self, goal: &Prop, terms: &[(Sign, Expr)], sums: &[Expr]) -> Result<Label, Fail> {
        let no = || Fail::No("the mean of the values of a function");
        for sum in sums {
            let (own, others): (Vec<_>, Vec<_>) = terms.iter().cloned().partition(|(_, e)| occurs(sum, e));
            if others.is_empty() {
                continue;
            }
            let is_convex = own.iter().all(|(sign, _)| *sign == Sign::Minus);
            let signed = |sign| if is_convex && sign == Sign::Minus { Sign::Plus } else { sign };
            let mut value = total(own.iter().map(|(sign, e)| (signed(*sign), e.clone())).collect());
            let of = self.fresh("u");
            replace(&mut value, sum, &name(&of));
            let f = Function { of, value, is_convex };
            let others = total(others);
            for mean in self.as_means(sum) {
                let values = mean.iter().map(|(w, x)| Ok((Sign::Plus, product(vec![w.clone(), f.at(x)?]))));
                let values = total(values.collect::<Result<_, Fail>>()?);
                let rest = if is_convex { minus(&others, &values) } else { plus(&others, values) };
                if !self.is_zero(&rest) {
                    continue;
                }
                if let Ok(label) = self.on_its_own(|c| c.by_tangents_at_mean(goal, &f, sum, &mean)) {
                    return Ok(label);
                }
            }
        }
        Err(no())
    }

    /// Shows the goal by the tangent at a mean, which is put in at the values.
    fn by_tangents_at_mean(&mut self, goal: &Prop, f: &Function, sum: &Expr, mean: &Mean) -> Result<Label, Fail> {
        let (_, relation, _) = single(goal)?;
        for (weight, _) in mean {
            self.quietly(&compare(weight.clone(), Relation::GreaterEqual, numeral(0)))?;
        }
        let bounds = self.shared_bounds(mean);
        for (order, bound) in &bounds {
            self.within_as_mean(sum, mean, *order, bound)?;
        }
        let is_strict = matches!(relation, Relation::Less | Relation::Greater);
        let lemma = self.above_its_tangents(f, &bounds, is_strict)?;
        let mut terms = Vec::new();
        for (weight, x) in mean {
            let point = vec![(f.of.clone(), x.clone()), (lemma.at.clone(), sum.clone())];
            let mut label = self.instance_at(&lemma.weak, point.clone())?;
            let apart = compare(x.clone(), Relation::NotEqual, sum.clone());
            if let Some(strict) = &lemma.strict
                && let Ok(apart) = self.quietly(&apart)
            {
                let implied = self.instance_at(strict, point)?;
                if let Some(PropKind::Implies(_, conclusion)) = self.fact(&implied).map(|p| p.kind) {
                    label = self.logic(&[&implied, &apart], &conclusion)?;
                }
            }
            let up = relation.is_greater() == Some(true);
            let sign = if up == f.is_convex { weight.clone() } else { negated(weight.clone()) };
            terms.push(scaled(&label, sign));
        }
        self.combination(goal.clone(), terms)
    }

    /// A mean lies within bounds that all values have: strictly, since not all weights are 0.
    fn within_as_mean(&mut self, sum: &Expr, mean: &Mean, order: Relation, bound: &Expr) -> Result<Label, Fail> {
        let goal = compare(sum.clone(), order, bound.clone());
        if let Ok(label) = self.quietly(&goal) {
            return Ok(label);
        }
        let mut by = Vec::new();
        for (weight, x) in mean {
            let label = self.quietly(&compare(x.clone(), order, bound.clone()))?;
            by.push(scaled(&label, weight.clone()));
        }
        if let Ok(label) = self.combination(goal.clone(), by.clone()) {
            return Ok(label);
        }
        // Where the first weight is not 0, its value makes the order strict; where it is 0, the others are left.
        let mut from = Vec::new();
        for (place, (weight, _)) in mean.iter().enumerate() {
            let positive = compare(weight.clone(), Relation::Greater, numeral(0));
            let Some(not_negative) = self.known(&compare(weight.clone(), Relation::GreaterEqual, numeral(0))) else {
                return Err(Fail::No("the sign of a weight"));
            };
            from.push(not_negative);
            from.push(self.block(&implies(&positive, &goal), |c, _| c.combination(goal.clone(), by.clone()))?);
            if place + 1 == mean.len() {
                let zeros: Vec<Prop> =
                    mean.iter().map(|(w, _)| compare(w.clone(), Relation::Equal, numeral(0))).collect();
                let all = prop(PropKind::And(zeros.clone()));
                from.push(self.block(&implies(&all, &goal), |c, block| {
                    let supposed = format!("{block}s");
                    let mut sum_of_weights = Vec::new();
                    for zero in &zeros {
                        sum_of_weights.push(scaled(&c.logic(&[&supposed], zero)?, numeral(1)));
                    }
                    let absurd = compare(numeral(1), Relation::Equal, numeral(0));
                    let absurd = c.combination(absurd, sum_of_weights)?;
                    c.logic(&[&absurd], &goal)
                })?);
            }
        }
        self.emit(Rule::Logic { from }, goal)
    }

    /// The bounds that facts give all values of a mean: by a fact about the first that is one about the others as well, or by signs.
    fn shared_bounds(&mut self, mean: &Mean) -> Vec<(Relation, Expr)> {
        let mut out: Vec<(Relation, Expr)> = Vec::new();
        let values: Vec<&Expr> = mean.iter().map(|(_, x)| x).collect();
        let first = values.iter().find(|x| !matches!(x.kind, ExprKind::Number(_)));
        for (_, fact) in self.facts() {
            let Some((a, relation, b)) = fact.single() else { continue };
            let Some(first) = first.map(|x| key::expr(x)) else { break };
            let (relation, bound) = match relation {
                _ if relation.is_greater().is_none() => continue,
                _ if key::expr(a) == first => (relation, b),
                _ if key::expr(b) == first => (relation.turned(), a),
                _ => continue,
            };
            if out.iter().any(|(r, _)| r.is_greater() == relation.is_greater()) {
                continue;
            }
            let loose = |x: &Expr, r| compare(x.clone(), r, bound.clone());
            let all = |c: &mut Self, r| values.iter().all(|x| c.quietly(&loose(x, r)).is_ok());
            if all(self, relation) {
                out.push((relation, bound.clone()));
            } else if relation != relation.loose() && all(self, relation.loose()) {
                out.push((relation.loose(), bound.clone()));
            }
        }
        if !out.iter().any(|(r, _)| r.is_greater() == Some(true)) {
            for (signs, relation) in
                [(Signs::POSITIVE, Relation::Greater), (Signs::NOT_NEGATIVE, Relation::GreaterEqual)]
            {
                if values.iter().all(|x| self.signs_of(x).within(signs)) {
                    out.push((relation, numeral(0)));
                    break;
                }
            }
        }
        out
    }

    /// That a function lies on one side of its tangents within bounds.
    fn above_its_tangents(
        &mut self,
        f: &Function,
        bounds: &[(Relation, Expr)],
        is_strict: bool,
    ) -> Result<Lemma, Fail> {
        let at = self.fresh("v");
        let constraints: Vec<Constraint> = bounds.iter().map(|(r, e)| Constraint::Relation(*r, e.clone())).collect();
        let binding = |n: &str| Binding::of(Name::new(n), false, constraints.clone());
        let slope = self.slope_at(f, &at, binding(&at))?;
        let along = product(vec![slope, minus(&name(&f.of), &name(&at))]);
        let line = plus(&f.at(&name(&at))?, along);
        let every = |body: Prop| prop(PropKind::ForAll(vec![binding(&f.of), binding(&at)], Box::new(body)));
        let (loose, strict) = match f.is_convex {
            true => (Relation::GreaterEqual, Relation::Greater),
            false => (Relation::LessEqual, Relation::Less),
        };
        let body = |r| compare(f.value.clone(), r, line.clone());
        let weak = self.block(&every(body(loose)), |c, _| c.show(&body(loose)))?;
        let apart = implies(&compare(name(&f.of), Relation::NotEqual, name(&at)), &body(strict));
        let strict = if is_strict { Some(self.show(&every(apart))?) } else { None };
        Ok(Lemma { at, weak, strict })
    }

    /// The derivative of a function where its variable has another name, written out.
    fn slope_at(&mut self, f: &Function, at: &str, binding: Binding) -> Result<Expr, Fail> {
        let derivative = expr(ExprKind::Derivative(Box::new(f.at(&name(at))?), vec![Name::new(at)]));
        let mut slope = None;
        self.where_it_is_bound(binding, |c| slope = c.simplified(&derivative));
        slope.ok_or(Fail::No("a derivative"))
    }

    /// The ways in which a sum is a mean of values.
    fn as_means(&mut self, sum: &Expr) -> Vec<Mean> {
        let Some(reading) = self.read(sum, false) else { return Vec::new() };
        let mut beside = vec![literal(&reading.number)];
        let mut inner: Option<Polynomial> = None;
        for f in &reading.factors {
            if f.power == 1 && f.poly.term_count() > 1 && inner.is_none() {
                inner = Some(f.poly.clone());
            } else {
                beside.push(whole_power(self.letters.written(&f.poly), f.power));
            }
        }
        let Some(inner) = inner.or_else(|| reading.factors.first().map(|f| f.poly.clone())) else { return Vec::new() };
        if inner.term_count() > TERMS || reading.factors.is_empty() {
            return Vec::new();
        }
        if inner.term_count() == 1 {
            beside = vec![literal(&reading.number)];
        }
        let monomials: Vec<(Monomial, Rational)> = inner.terms().map(|(m, c)| (m.clone(), c.clone())).collect();
        let mut ways = Vec::new();
        assigned(&monomials, &mut Vec::new(), &mut ways);
        let (mut whole, mut rest) = (Vec::new(), Vec::new());
        for way in ways {
            let mut mean: Mean = Vec::new();
            let mut values: Vec<Option<u32>> = way.clone();
            values.sort_unstable();
            values.dedup();
            for value in values {
                let own = monomials.iter().zip(&way).filter(|(_, v)| **v == value);
                let mut weight = Polynomial::zero();
                for ((m, c), _) in own {
                    let rest = value.map_or_else(|| m.clone(), |v| m.without(v).0);
                    weight = weight.add(&Polynomial::term(rest, c.clone()));
                }
                let x = value.and_then(|v| self.letters.expr(v).cloned()).unwrap_or_else(|| numeral(1));
                let parts = beside.iter().cloned().chain([self.letters.written(&weight)]).collect();
                let weight = product(parts);
                mean.push((self.simplified(&weight).unwrap_or(weight), x));
            }
            let all = total(mean.iter().map(|(w, _)| (Sign::Plus, w.clone())).collect());
            let left = minus(&numeral(1), &all);
            if self.is_zero(&left) {
                whole.push(mean);
            } else if let Some(left) = self.simplified(&left) {
                mean.push((left, numeral(0)));
                rest.push(mean);
            }
        }
        whole.extend(rest);
        whole
    }
}

/// That a function lies on one side of its tangents, at the places `at`.
struct Lemma {
    at: String,
    weak: Label,
    strict: Option<Label>,
}

/// For each monomial the letter that is its value, or none: one that no other monomial has beside its own value.
fn assigned(monomials: &[(Monomial, Rational)], so_far: &mut Vec<Option<u32>>, out: &mut Vec<Vec<Option<u32>>>) {
    if out.len() >= WAYS {
        return;
    }
    let Some((next, _)) = monomials.get(so_far.len()) else {
        if so_far.iter().any(Option::is_some) {
            out.push(so_far.clone());
        }
        return;
    };
    let is_value = |v: u32| so_far.contains(&Some(v));
    let own: Vec<u32> = next.powers().iter().map(|(v, _)| *v).filter(|v| is_value(*v)).collect();
    let free = |v: u32| monomials[..so_far.len()].iter().all(|(m, _)| m.powers().iter().all(|(u, _)| *u != v));
    let choices: Vec<Option<u32>> = match own.as_slice() {
        [] => next.powers().iter().filter(|(v, k)| *k == 1 && free(*v)).map(|(v, _)| Some(*v)).chain([None]).collect(),
        [one] if next.powers().iter().any(|(v, k)| v == one && *k == 1) => vec![Some(*one)],
        _ => Vec::new(),
    };
    for choice in choices {
        so_far.push(choice);
        assigned(monomials, so_far, out);
        so_far.pop();
    }
}

/// The sums within a function, a power, a product or a divisor, each once.
fn inner_sums(e: &Expr, is_inner: bool, out: &mut Vec<Expr>) {
    if matches!(e.kind, ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::IntegralOver(..)) {
        return;
    }
    let is_sum = |e: &Expr| matches!(&e.kind, ExprKind::Sum(list) if list.len() > 1);
    let is_mean = is_sum(e)
        || matches!(&e.kind, ExprKind::Product(list) if list.iter().any(|(how, e)| *how == Factor::Times && is_sum(e))
            && list.iter().any(|(how, _)| *how == Factor::Over));
    if is_inner && is_mean && !out.iter().any(|old| key::expr(old) == key::expr(e)) {
        out.push(e.clone());
    }
    parts(e, &mut |part| inner_sums(part, true, out));
}
