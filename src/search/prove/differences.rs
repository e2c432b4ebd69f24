//! Successive difference substitution: a polynomial in variables that are not negative is not negative if, for every order of
//! the variables, it has no negative coefficient in the smallest one and the differences of neighbours. If it has, the same is
//! tried again with these. (L. Yang, "Solving harder problems with lesser mathematics", 2005; X. Hou and J. Shao, 2011.)
//!
//! A variable between two numbers a and b enters by v − a and b − v instead: with 1 = ((v − a) + (b − v))/(b − a) the polynomial
//! becomes a form in both (Bernstein coefficients). An equation h = c, where h is a form, makes the polynomial a form first. Where none
//! does, the number 1 is put in order with the variables: many such inequalities are equations where all variables are 1.
//!
//! Certificate: cases by the order of two expressions, and in each a sum of products that are not negative.
//!
//! Cost: n! cases for n variables at each depth, of which [`LEAVES`] may be reached.

use super::letters::{product, whole_power};
use super::products::{Kind, Known};
use super::{Fail, Prover, implies};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::ops::RangeInclusive;

/// The most variables that are put in order; five have 120 orders, and a certificate of seconds.
const VARIABLES: usize = 4;

/// The most orders that one goal may need.
const LEAVES: usize = 130;

/// The most terms of a polynomial on the way.
const TERMS: usize = 400;

/// The highest degree of the polynomial.
const DEGREE: u32 = 60;

/// Something that is not negative, for which a variable of the new polynomial stands.
#[derive(Clone)]
struct Part {
    variable: u32,
    written: Expr,
    strict: bool,
}

/// How the polynomial is shown to be not negative.
enum Plan {
    /// No coefficient is negative.
    Leaf(Polynomial),
    /// Each order of the variables has a plan.
    Orders(Vec<(Vec<u32>, Plan)>),
}

/// What is shown, and how a plan's polynomial enters.
struct Aim<'a> {
    goal: &'a Prop,
    /// Factors of every term.
    rest: &'a [Expr],
    /// Terms that are there in every case.
    always: Vec<Term>,
    /// A minus sign before each product.
    flip: bool,
}

impl Prover {
    /// Shows a comparison by differences of variables to one of these depths; 0 allows no cases.
    pub(super) fn by_differences(&mut self, goal: &Prop, depths: RangeInclusive<usize>) -> Result<Label, Fail> {
        let no = || Fail::No("a polynomial in variables that are not negative");
        let open = self.open_factors(goal, 1)?;
        let PropKind::Compare(_, relations) = &goal.kind else { return Err(no()) };
        if relations[0] == Relation::Equal || open.poly.degree() > DEGREE {
            return Err(no());
        }
        let strict = matches!(relations[0], Relation::Greater | Relation::Less);
        let target = if open.flip { open.poly.neg() } else { open.poly.clone() };
        let known = self.all_known(std::slice::from_ref(&target));
        let mut last = Err(no());
        for (form, always) in self.forms(&target, &known, &open.rest, open.flip) {
            let Some((parts, poly)) = self.in_parts(&form, &known) else { continue };
            let beside_one = if *depths.end() > 1 { beside_one(&parts, &poly) } else { None };
            for (parts, poly) in [(parts, poly)].into_iter().chain(beside_one) {
                let ordered: Vec<u32> = parts.ordered.iter().map(|p| p.variable).collect();
                let mut all = parts.ordered;
                all.extend(parts.bounded);
                let mut leaves = LEAVES;
                self.ticks += 1;
                for depth in depths.clone() {
                    if depth > 0 && (ordered.len() > VARIABLES || is_negative_somewhere(&poly)) {
                        break;
                    }
                    if let Some(plan) = plan(&poly, &ordered, &all, strict, depth, &mut leaves) {
                        let aim = Aim { goal, rest: &open.rest, always: always.clone(), flip: open.flip };
                        last = self.attempt(|c| c.by_plan(&aim, &plan, &all));
                        if last.is_ok() {
                            return last;
                        }
                    }
                }
            }
        }
        last
    }

    /// The polynomial as it is, and as a form by an equation, with the terms that make up the difference.
    pub(super) fn forms(
        &self,
        p: &Polynomial,
        known: &[Known],
        rest: &[Expr],
        flip: bool,
    ) -> Vec<(Polynomial, Vec<Term>)> {
        let mut out = vec![(p.clone(), Vec::new())];
        for zero in known.iter().filter(|k| k.kind == Kind::Zero) {
            let Some(form) = super::columns::made_homogeneous(p, std::slice::from_ref(zero)) else { continue };
            let Some(quotient) = p.sub(&form).exact_divide(&zero.poly) else { continue };
            let quotient = self.letters.written(&if flip { quotient.neg() } else { quotient });
            let factors = std::iter::once(quotient).chain(rest.iter().cloned()).chain(zero.factors.iter().cloned());
            out.push((form, vec![Term { facts: zero.facts.clone(), factor: product(factors.collect()) }]));
        }
        out
    }

    /// A polynomial in parts that are not negative; `None` where a variable may be negative.
    fn in_parts(&mut self, p: &Polynomial, known: &[Known]) -> Option<(Parts, Polynomial)> {
        let letters = p.variables();
        let mut next = letters.iter().max()? + 1;
        let mut parts = Parts::default();
        let mut poly = p.clone();
        for v in letters {
            let written = self.letters.expr(v)?.clone();
            let signs = self.signs_of(&written);
            let zero = Bound { at: Rational::ZERO, strict: signs.within(Signs::POSITIVE) };
            let mut low = signs.within(Signs::NOT_NEGATIVE).then_some(zero);
            let mut high: Option<Bound> = None;
            for (bound, is_low) in known.iter().filter_map(|k| bound_of(v, k)) {
                let side = if is_low { &mut low } else { &mut high };
                let closer = |old: &Bound| match bound.at.cmp(&old.at) {
                    std::cmp::Ordering::Equal => bound.strict && !old.strict,
                    order => (order == std::cmp::Ordering::Greater) == is_low,
                };
                if side.as_ref().is_none_or(closer) {
                    *side = Some(bound);
                }
            }
            let above = |low: &Bound| super::facts::minus(&written, &literal(&low.at));
            match (low, high) {
                (Some(low), Some(high)) if high.at > low.at => {
                    let below = super::facts::minus(&literal(&high.at), &written);
                    let first = if low.at == 0 { written.clone() } else { above(&low) };
                    let (x, y) = (Polynomial::variable(next), Polynomial::variable(next + 1));
                    poly = bernstein(&poly, v, &low.at, &high.at, &x, &y)?;
                    parts.bounded.push(Part { variable: next, written: first, strict: low.strict });
                    parts.bounded.push(Part { variable: next + 1, written: below, strict: high.strict });
                    next += 2;
                }
                (Some(low), _) if low.at == 0 => {
                    parts.ordered.push(Part { variable: v, written: written.clone(), strict: low.strict });
                }
                (Some(low), _) => {
                    let shifted = Polynomial::variable(v).add(&Polynomial::constant(low.at.clone()));
                    poly = put(&poly, v, &shifted)?;
                    parts.ordered.push(Part { variable: v, written: above(&low), strict: low.strict });
                }
                (None, _) => return None,
            }
        }
        (poly.term_count() <= TERMS).then_some((parts, poly))
    }

    fn by_plan(&mut self, aim: &Aim, plan: &Plan, parts: &[Part]) -> Result<Label, Fail> {
        match plan {
            Plan::Leaf(poly) => {
                let mut terms = aim.always.clone();
                for (m, c) in poly.terms() {
                    let mut factors = vec![literal(&if aim.flip { -c } else { c.clone() })];
                    for (v, k) in m.powers() {
                        let part = parts.iter().find(|p| p.variable == *v).ok_or(Fail::No("a part"))?;
                        factors.push(whole_power(part.written.clone(), i64::from(*k)));
                    }
                    factors.extend(aim.rest.iter().cloned());
                    terms.push(Term { facts: Vec::new(), factor: product(factors) });
                }
                self.combination(aim.goal.clone(), terms)
            }
            Plan::Orders(orders) => {
                let mut all: Vec<u32> = orders.first().map(|o| o.0.clone()).unwrap_or_default();
                all.sort_unstable();
                self.by_orders(aim, orders, parts, &[], &all)
            }
        }
    }

    /// Distinguishes where the first of the variables `left` stands among the `sorted` ones, and so on.
    fn by_orders(
        &mut self,
        aim: &Aim,
        orders: &[(Vec<u32>, Plan)],
        parts: &[Part],
        sorted: &[u32],
        left: &[u32],
    ) -> Result<Label, Fail> {
        let Some((new, left)) = left.split_first() else {
            let plan = orders.iter().find(|o| o.0 == sorted).map(|o| &o.1).ok_or(Fail::No("an order"))?;
            return self.by_plan(aim, plan, &differences(parts, sorted));
        };
        self.insert(aim, orders, parts, sorted, sorted.len(), *new, left)
    }

    /// Distinguishes whether the new variable is at least the one before this place among the sorted ones.
    #[allow(clippy::too_many_arguments)] // the state of a walk through a tree
    fn insert(
        &mut self,
        aim: &Aim,
        orders: &[(Vec<u32>, Plan)],
        parts: &[Part],
        sorted: &[u32],
        place: usize,
        new: u32,
        left: &[u32],
    ) -> Result<Label, Fail> {
        let here = |c: &mut Prover| {
            let mut longer = sorted.to_vec();
            longer.insert(place, new);
            c.by_orders(aim, orders, parts, &longer, left)
        };
        let Some(before) = place.checked_sub(1).and_then(|k| sorted.get(k)) else { return here(self) };
        let written = |v: u32| parts.iter().find(|p| p.variable == v).map(|p| p.written.clone());
        let (Some(a), Some(b)) = (written(new), written(*before)) else { return Err(Fail::No("a part")) };
        let gap = self.signs_of(&super::facts::minus(&a, &b));
        if gap.within(Signs::NOT_NEGATIVE) {
            return here(self);
        }
        if gap.within(Signs::of(Relation::LessEqual)) {
            return self.insert(aim, orders, parts, sorted, place - 1, new, left);
        }
        let above = implies(&compare(a.clone(), Relation::GreaterEqual, b.clone()), aim.goal);
        let below = implies(&compare(a, Relation::Less, b), aim.goal);
        let x = self.block(&above, |c, _| here(c))?;
        let y = self.block(&below, |c, _| c.insert(aim, orders, parts, sorted, place - 1, new, left))?;
        self.logic(&[&x, &y], aim.goal)
    }
}

/// The parts of a polynomial.
#[derive(Clone, Default)]
struct Parts {
    /// Those that are put in order.
    ordered: Vec<Part>,
    /// The two distances of a variable from its bounds.
    bounded: Vec<Part>,
}

/// The form in the parts and in the number 1 that a polynomial in parts is, if it is none in the parts alone: 1 then has its place
/// in the order of the variables.
fn beside_one(parts: &Parts, p: &Polynomial) -> Option<(Parts, Polynomial)> {
    let mut parts = parts.clone();
    let one = parts.ordered.iter().chain(&parts.bounded).map(|part| part.variable).max()? + 1;
    let mut form = Polynomial::zero();
    for (m, c) in p.terms() {
        let term = Polynomial::term(m.clone(), c.clone());
        let missing = p.degree() - m.degree();
        form = form.add(&term.try_mul(&Polynomial::variable(one).pow(missing).ok()?).ok()?);
    }
    parts.ordered.push(Part { variable: one, written: numeral(1), strict: true });
    (form.contains(one) && parts.bounded.is_empty()).then_some((parts, form))
}

/// A number that bounds a variable.
struct Bound {
    at: Rational,
    /// Whether the variable is never equal to it.
    strict: bool,
}

/// What a fact says of one letter alone, if it bounds it: the bound, and whether it lies below.
fn bound_of(letter: u32, known: &Known) -> Option<(Bound, bool)> {
    if known.kind == Kind::Zero || known.poly.variables() != [letter] {
        return None;
    }
    let [constant, slope] = &known.poly.coefficients_in(letter)[..] else { return None };
    let slope = slope.as_constant()?;
    let at = -(constant.as_constant()? / &slope);
    Some((Bound { at, strict: known.kind == Kind::Strict }, slope > 0))
}

/// A polynomial with x − v, in the form x·b + y·a, for a variable between a and b, where x = v − a and y = b − v.
fn bernstein(p: &Polynomial, v: u32, a: &Rational, b: &Rational, x: &Polynomial, y: &Polynomial) -> Option<Polynomial> {
    let width = Rational::ONE / (b - a);
    let value = x.scale(b).add(&y.scale(a)).scale(&width);
    let one = x.add(y).scale(&width);
    let coefficients = p.coefficients_in(v);
    let degree = coefficients.len().saturating_sub(1);
    let mut out = Polynomial::zero();
    for (k, c) in coefficients.iter().enumerate() {
        let powers = value.pow(u32::try_from(k).ok()?).ok()?;
        let rest = one.pow(u32::try_from(degree - k).ok()?).ok()?;
        out = out.add(&c.try_mul(&powers.try_mul(&rest).ok()?).ok()?);
    }
    Some(out)
}

/// A polynomial with a value put in for a variable, if it stays short.
fn put(p: &Polynomial, v: u32, value: &Polynomial) -> Option<Polynomial> {
    p.substitute(v, value).ok().filter(|p| p.term_count() <= TERMS)
}

/// The parts in this order: the smallest, and the differences of neighbours.
fn differences(parts: &[Part], order: &[u32]) -> Vec<Part> {
    let of = |v: &u32| parts.iter().find(|p| p.variable == *v);
    let mut out: Vec<Part> = parts.iter().filter(|p| !order.contains(&p.variable)).cloned().collect();
    out.extend(order.first().and_then(of).cloned());
    for pair in order.windows(2) {
        if let (Some(low), Some(high)) = (of(&pair[0]), of(&pair[1])) {
            let written = super::facts::minus(&high.written, &low.written);
            out.push(Part { variable: high.variable, written, strict: false });
        }
    }
    out
}

/// A plan for a polynomial in parts, of which those in `ordered` may be put in order.
fn plan(
    p: &Polynomial,
    ordered: &[u32],
    parts: &[Part],
    strict: bool,
    depth: usize,
    leaves: &mut usize,
) -> Option<Plan> {
    let is_strict = |m: &Monomial| m.powers().iter().all(|(v, _)| parts.iter().any(|p| p.variable == *v && p.strict));
    if p.terms().all(|(_, c)| *c > 0) && (!strict || p.terms().any(|(m, _)| is_strict(m))) {
        *leaves = leaves.checked_sub(1)?;
        return Some(Plan::Leaf(p.clone()));
    }
    if depth == 0 || ordered.len() < 2 {
        return None;
    }
    let mut orders = Vec::new();
    for order in permutations(ordered) {
        let mut q = p.clone();
        // x_i = t_1 + … + t_i, where t_i takes the place of x_i: none of them stands in a sum that comes before it.
        for at in 1..order.len() {
            let sum = order.iter().take(at + 1).fold(Polynomial::zero(), |s, v| s.add(&Polynomial::variable(*v)));
            q = put(&q, order[at], &sum)?;
        }
        let inner = plan(&q, ordered, &differences(parts, &order), strict, depth - 1, leaves)?;
        orders.push((order, inner));
    }
    Some(Plan::Orders(orders))
}

/// All orders of these variables.
fn permutations(list: &[u32]) -> Vec<Vec<u32>> {
    let Some((first, rest)) = list.split_first() else { return vec![Vec::new()] };
    let with = |p: Vec<u32>| {
        (0..=p.len()).map(move |at| {
            let mut longer = p.clone();
            longer.insert(at, *first);
            longer
        })
    };
    permutations(rest).into_iter().flat_map(with).collect()
}

/// Whether a polynomial is negative at one of a few points with coordinates that are not negative: then no plan will do.
fn is_negative_somewhere(p: &Polynomial) -> bool {
    let letters = p.variables();
    let value = |at: &dyn Fn(usize) -> i64| {
        p.evaluate(&|v| Rational::from(at(letters.iter().position(|l| *l == v).unwrap_or(0))))
    };
    let count = letters.len();
    let single = (0..count).any(|i| value(&|j| i64::from(i == j)) < 0 || value(&|j| if i == j { 3 } else { 1 }) < 0);
    single
        || value(&|_| 1) < 0
        || value(&|j| i64::try_from(j).unwrap_or(0) + 1) < 0
        || (0..count).any(|i| value(&|j| i64::from(i != j)) < 0)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    fn part(variable: u32) -> Part {
        Part { variable, written: crate::kernel::statement::name(&format!("x{variable}")), strict: false }
    }

    /// A leaf's polynomial, with the differences of the variables put back in.
    fn put_back(p: &Polynomial, order: &[u32]) -> Polynomial {
        // t_i = x_i − x_(i−1), from the second smallest on: what is put in stands for x already.
        (1..order.len()).fold(p.clone(), |p, at| {
            let gap = Polynomial::variable(order[at]).sub(&Polynomial::variable(order[at - 1]));
            put(&p, order[at], &gap).unwrap()
        })
    }

    fn schur() -> Polynomial {
        let [a, b, c] = [0, 1, 2].map(Polynomial::variable);
        let term = |x: &Polynomial, y: &Polynomial, z: &Polynomial| x.mul(&x.sub(y)).mul(&x.sub(z));
        term(&a, &b, &c).add(&term(&b, &c, &a)).add(&term(&c, &a, &b))
    }

    #[test]
    fn every_order_has_the_polynomial_itself_in_its_differences() {
        let parts = [0, 1, 2].map(part);
        let mut leaves = LEAVES;
        let Some(Plan::Orders(orders)) = plan(&schur(), &[0, 1, 2], &parts, false, 1, &mut leaves) else {
            panic!("no plan");
        };
        assert_eq!(orders.len(), 6);
        for (order, plan) in orders {
            let Plan::Leaf(leaf) = plan else { panic!("a leaf is due at depth 1") };
            assert!(leaf.terms().all(|(_, c)| *c > 0));
            assert_eq!(put_back(&leaf, &order), schur(), "{order:?}");
        }
    }

    #[test]
    fn what_is_negative_somewhere_has_no_plan() {
        let [a, b] = [0, 1].map(Polynomial::variable);
        let p = a.mul(&a).add(&b.mul(&b)).sub(&a.mul(&b).scale(&Rational::from(3)));
        assert!(is_negative_somewhere(&p));
        let mut leaves = LEAVES;
        assert!(plan(&p, &[0, 1], &[part(0), part(1)], false, 3, &mut leaves).is_none());
    }

    #[test]
    fn a_strict_goal_needs_a_term_that_is_positive() {
        let square = Polynomial::variable(0).mul(&Polynomial::variable(0));
        let mut leaves = LEAVES;
        assert!(plan(&square, &[0], &[part(0)], false, 0, &mut leaves).is_some());
        assert!(plan(&square, &[0], &[part(0)], true, 0, &mut leaves).is_none());
    }

    #[test]
    fn distances_from_both_bounds_give_the_polynomial_back() {
        let (v, x, y) = (Polynomial::variable(0), Polynomial::variable(1), Polynomial::variable(2));
        let p = v.pow(3).unwrap().sub(&v).add(&Polynomial::integer(5));
        let (a, b) = (Rational::from(-1), Rational::from(3));
        let form = bernstein(&p, 0, &a, &b, &x, &y).unwrap();
        let above = v.sub(&Polynomial::constant(a));
        let below = Polynomial::constant(b).sub(&v);
        assert_eq!(put(&put(&form, 1, &above).unwrap(), 2, &below).unwrap(), p);
    }
}
