//! The steps that show an expansion in powers of t = 1/x, as `expansions` plans it.
//!
//! Method: bounds get names, then a block "for all t > 0 up to 1/N" takes one part after the other. The number ρ of a part is a
//! name for what is left of it over t^n; that e = Σ a_i·t^i + ρ·t^n follows, and bounds of ρ by those of products of t and the
//! numbers of other parts. At the end the number of the whole is bounded, and 1/k can be put in for t.

use super::asymptotic_form::total;
use super::expansions::{Bounded, Expansion, Factors, How, Node, Series};
use super::facts::{minus, negated, scaled};
use super::letters::{product, whole_power};
use super::limits::over;
use super::taylor::{Function, Side, TaylorBound, at_most};
use super::{Fail, Prover};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, name, numeral, prop};
use crate::kernel::substitution::Substitution;
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::{BTreeSet, HashMap};

/// That what is left of an expression is bounded near infinity.
pub(super) struct Remainder {
    /// For all t > 0 up to 1/start: −bound < left < bound, for the expression at 1/t.
    pub lemma: Label,
    pub bound: Expr,
    pub start: Expr,
    /// What is left, for a value of t.
    left: Left,
}

/// (e − Σ a_i·t^i)/t^n.
struct Left {
    e: Expr,
    x: String,
    polynomial: Series,
    order: i64,
}

impl Left {
    fn at(&self, t: &Expr) -> Result<Expr, Fail> {
        let e = at_inverse(&self.x, t).expr(&self.e).map_err(Fail::from)?;
        let left = match self.polynomial.terms.is_empty() {
            true => e,
            false => minus(&e, &written(&self.polynomial, t, &[])),
        };
        Ok(if self.order == 0 { left } else { over(left, whole_power(t.clone(), self.order)) })
    }
}

/// 1/t for the variable.
fn at_inverse(x: &str, t: &Expr) -> Substitution {
    let mut at = Substitution::default();
    at.replace(x, &over(numeral(1), t.clone()));
    at
}

/// A polynomial as an expression.
fn written(series: &Series, t: &Expr, numbers: &[(String, Expr)]) -> Expr {
    let terms = series.terms.iter().map(|((k, list), c)| {
        let mut factors = vec![c.clone(), whole_power(t.clone(), *k)];
        factors.extend(list.iter().filter_map(|number| numbers.get(*number)).map(|number| name(&number.0)));
        product(factors)
    });
    total(&terms.collect::<Vec<_>>())
}

fn alone(factor: Expr) -> Term {
    Term { facts: Vec::new(), factor }
}

fn whole(k: i64) -> Expr {
    literal(&Rational::from(k))
}

/// What is shown so far, in the block for t.
struct Steps<'p> {
    plan: &'p Expansion,
    t: Expr,
    at: Substitution,
    /// That t is at most 1.
    one: Label,
    /// For each node that it is its polynomial.
    equations: Vec<Option<Label>>,
    /// For each number its bounds, the upper one first.
    numbers: Vec<Option<[Label; 2]>>,
    /// The same for products.
    products: HashMap<(i64, Vec<usize>), [Label; 2]>,
    /// t·M <= 1.
    reach: Vec<Label>,
    /// What names stand for.
    names: HashMap<String, Label>,
    lemmas: HashMap<(usize, bool), Label>,
}

impl Steps<'_> {
    fn written(&self, series: &Series) -> Expr {
        written(series, &self.t, &self.plan.numbers)
    }

    fn t(&self, k: i64) -> Expr {
        whole_power(self.t.clone(), k)
    }

    /// The polynomial of a node, without what is left.
    fn polynomial(&self, node: &Node) -> Series {
        Series { terms: node.terms.iter().map(|(k, c)| ((*k, Vec::new()), c.clone())).collect() }
    }

    fn equation(&self, node: usize) -> Vec<Label> {
        self.equations.get(node).cloned().flatten().into_iter().collect()
    }

    /// The expression of a node for t.
    fn here(&self, e: &Expr) -> Result<Expr, Fail> {
        self.at.expr(e).map_err(Fail::from)
    }

    /// Terms that come to a factor times t·M − 1, for one of the numbers M that tell how small t is.
    fn reached(&self, place: usize, factor: &Expr) -> Vec<Term> {
        let mut terms = vec![scaled(&self.reach[place], factor.clone())];
        let named = self.name_of(&self.plan.reach[place]);
        terms.extend(named.map(|l| scaled(l, product(vec![factor.clone(), self.t.clone()]))));
        terms
    }

    /// The equation by which a bound is named.
    fn name_of(&self, bound: &Expr) -> Option<&Label> {
        match &bound.kind {
            ExprKind::Name(n) => self.names.get(n),
            _ => None,
        }
    }
}

impl Prover {
    /// Shows that what is left of a planned expression, after the terms below t^order, is bounded near infinity.
    pub(super) fn remainder_of(&mut self, plan: &Expansion, order: i64) -> Result<Remainder, Fail> {
        let root = plan.nodes.last().ok_or(Fail::No("an expansion"))?;
        let used = used(plan);
        let mut names = HashMap::new();
        for (fresh, parts) in &plan.names {
            names.insert(fresh.clone(), self.name_for_a_sum(fresh, parts)?);
        }
        let (start, parts) = self.start(plan)?;
        if let (ExprKind::Name(fresh), true) = (&start.kind, parts.len() > 1) {
            let label = self.name_for_a_sum(fresh, &parts)?;
            names.insert(fresh.clone(), label.clone());
            let positive = compare(start.clone(), Relation::Greater, numeral(0));
            let terms = std::iter::once(scaled(&label, whole(-1))).chain(parts.iter().map(|e| alone(e.clone())));
            self.combination(positive, terms.collect())?;
        }
        let mut lemmas = HashMap::new();
        for (k, node) in plan.nodes.iter().enumerate().filter(|(k, _)| used.contains(k)) {
            if let How::Function { function, degree, .. } = &node.how {
                for upper in [false, true] {
                    let bound = TaylorBound { function: function.clone(), degree: *degree, upper, side: Side::Both };
                    let lemma = self.taylor_bound(&bound)?;
                    lemmas.insert((k, upper), lemma);
                }
            }
        }
        let number = root.rest.ok_or(Fail::No("what is left"))?;
        let bound = match self.letters.number(&plan.numbers[number].1) {
            Some(q) => literal(&(q + Rational::ONE)),
            None => total(&[plan.numbers[number].1.clone(), numeral(1)]),
        };
        let polynomial = root.terms.iter().map(|(k, c)| ((*k, Vec::new()), c.clone())).collect();
        let left = Left { e: root.e.clone(), x: plan.x.clone(), polynomial: Series { terms: polynomial }, order };
        let fresh = self.fresh("t");
        let t = name(&fresh);
        let domain = [(Relation::Greater, numeral(0)), (Relation::LessEqual, over(numeral(1), start.clone()))];
        let domain = domain.map(|(relation, e)| Constraint::Relation(relation, e));
        let value = left.at(&t)?;
        let inside = vec![negated(bound.clone()), value.clone(), bound.clone()];
        let inside = prop(PropKind::Compare(inside, vec![Relation::Less; 2]));
        let binding = Binding::of(Name::new(&fresh), false, domain.to_vec());
        let every = prop(PropKind::ForAll(vec![binding], Box::new(inside.clone())));
        let lemma = self.block(&every, |c, _| {
            let mut steps = c.begun(plan, t, &start, &parts, names, lemmas)?;
            for (k, node) in plan.nodes.iter().enumerate().filter(|(k, _)| used.contains(k)) {
                c.node_shown(&mut steps, k, node)?;
            }
            let last = plan.nodes.len() - 1;
            let scale = steps.t(-order);
            let [upper, lower] = steps.numbers[number].clone().ok_or(Fail::No("a bound"))?;
            let mut both = Vec::new();
            for (sign, fact) in [(-1, lower), (1, upper)] {
                let links = steps.equation(last);
                let mut terms: Vec<Term> =
                    links.iter().map(|l| scaled(l, product(vec![whole(sign), scale.clone()]))).collect();
                terms.extend([scaled(&fact, numeral(1)), alone(whole(-1))]);
                let order = match sign {
                    1 => compare(value.clone(), Relation::Less, bound.clone()),
                    _ => compare(negated(bound.clone()), Relation::Less, value.clone()),
                };
                both.push(c.combination(order, terms)?);
            }
            c.emit(Rule::Logic { from: both }, inside)
        })?;
        Ok(Remainder { lemma, bound, start, left })
    }

    /// −bound < left and left < bound at a value of k, which is at least the start; what is left there.
    pub(super) fn remainder_at(
        &mut self,
        remainder: &Remainder,
        k: &Expr,
        at_least: &Term,
    ) -> Result<(Expr, [Label; 2]), Fail> {
        let inverse = over(numeral(1), k.clone());
        let positive = compare(inverse.clone(), Relation::Greater, numeral(0));
        self.combination(positive.clone(), Vec::new()).or_else(|_| self.without_cases(&positive))?;
        let near = compare(inverse.clone(), Relation::LessEqual, over(numeral(1), remainder.start.clone()));
        self.combination(near, vec![at_least.clone()])?;
        let here = self.instance(&remainder.lemma, &inverse)?;
        let value = remainder.left.at(&inverse)?;
        let bound = &remainder.bound;
        let lower = self.logic(&[&here], &compare(negated(bound.clone()), Relation::Less, value.clone()))?;
        let upper = self.logic(&[&here], &compare(value.clone(), Relation::Less, bound.clone()))?;
        Ok((value, [lower, upper]))
    }

    /// A name for a sum of numbers that are not negative, and that it is not negative.
    fn name_for_a_sum(&mut self, fresh: &str, parts: &[Expr]) -> Result<Label, Fail> {
        let label = self.emit(Rule::Name, compare(total(parts), Relation::Equal, name(fresh)))?;
        let terms = std::iter::once(scaled(&label, whole(-1))).chain(parts.iter().map(|e| alone(e.clone())));
        self.combination(compare(name(fresh), Relation::GreaterEqual, numeral(0)), terms.collect())?;
        Ok(label)
    }

    /// A number from which on t = 1/x is as small as need be, and the numbers whose sum it is.
    fn start(&mut self, plan: &Expansion) -> Result<(Expr, Vec<Expr>), Fail> {
        let (mut least, mut others) = (Rational::ONE, Vec::new());
        for number in &plan.reach {
            match self.letters.number(number) {
                Some(q) => least = least.max(q),
                None => others.push(number.clone()),
            }
        }
        others.insert(0, literal(&least));
        let start = if others.len() == 1 { others[0].clone() } else { name(&self.fresh("n")) };
        Ok((start, others))
    }

    /// t is at most 1, and as small as the plan asks for.
    fn begun<'p>(
        &mut self,
        plan: &'p Expansion,
        t: Expr,
        start: &Expr,
        parts: &[Expr],
        names: HashMap<String, Label>,
        lemmas: HashMap<(usize, bool), Label>,
    ) -> Result<Steps<'p>, Fail> {
        let near = compare(t.clone(), Relation::LessEqual, over(numeral(1), start.clone()));
        let near = self.known(&near).ok_or(Fail::No("a small number"))?;
        let within = compare(product(vec![t.clone(), start.clone()]), Relation::LessEqual, numeral(1));
        let within = self.combination(within, vec![scaled(&near, start.clone())])?;
        let named = match &start.kind {
            ExprKind::Name(n) => names.get(n).cloned(),
            _ => None,
        };
        let least = self.letters.number(&parts[0]).ok_or(Fail::No("a number"))?;
        let at_most_one = |c: &mut Prover, number: &Expr| {
            let goal = compare(product(vec![t.clone(), number.clone()]), Relation::LessEqual, numeral(1));
            let mut terms = vec![scaled(&within, numeral(1))];
            terms.extend(named.iter().map(|l| scaled(l, t.clone())));
            let q = c.letters.number(number);
            for (k, part) in parts.iter().enumerate() {
                let rest = match (&q, k) {
                    (Some(q), 0) => literal(&(q - &least)),
                    (None, _) if part == number => continue,
                    _ => negated(part.clone()),
                };
                terms.push(alone(product(vec![rest, t.clone()])));
            }
            c.combination(goal, terms)
        };
        let mut reach = Vec::new();
        for number in &plan.reach {
            reach.push(at_most_one(self, number)?);
        }
        let one = at_most_one(self, &numeral(1))?;
        let at = at_inverse(&plan.x, &t);
        let (equations, numbers) = (vec![None; plan.nodes.len()], vec![None; plan.numbers.len()]);
        Ok(Steps { plan, t, at, one, equations, numbers, products: HashMap::new(), reach, names, lemmas })
    }

    fn node_shown(&mut self, steps: &mut Steps<'_>, place: usize, node: &Node) -> Result<(), Fail> {
        match &node.how {
            How::Exact => Ok(()),
            How::Same { child, by_powers, base } => self.same_shown(steps, place, node, (*child, *by_powers), base),
            How::Linked { links, tail } => self.linked_shown(steps, place, node, links, tail),
            How::Inverse { .. } => self.inverse_shown(steps, place, node),
            How::Function { .. } => self.function_shown(steps, place, node),
            How::Turning => self.turning_shown(steps, place, node),
        }
    }

    /// Names what is left, and shows that the expression is its polynomial. Returns the name's equation.
    fn rest_named(&mut self, steps: &mut Steps<'_>, place: usize, node: &Node) -> Result<Label, Fail> {
        let (Some(order), Some(rest)) = (node.order, node.rest) else { return Err(Fail::No("what is left")) };
        let (e, polynomial) = (steps.here(&node.e)?, steps.written(&steps.polynomial(node)));
        let rest = name(&steps.plan.numbers[rest].0);
        let left = if node.terms.is_empty() { e.clone() } else { minus(&e, &polynomial) };
        let left = if order == 0 { left } else { over(left, steps.t(order)) };
        let named = self.emit(Rule::Name, compare(left, Relation::Equal, rest))?;
        let whole = steps.written(&steps.plan.series(place));
        let equation = self.combination(compare(e, Relation::Equal, whole), vec![scaled(&named, steps.t(order))])?;
        steps.equations[place] = Some(equation);
        Ok(named)
    }

    fn same_shown(
        &mut self,
        steps: &mut Steps<'_>,
        place: usize,
        node: &Node,
        (child, by_powers): (usize, bool),
        base: &Option<[Expr; 3]>,
    ) -> Result<(), Fail> {
        if let Some([base, rest, scale]) = base {
            let [base, rest, scale] = [steps.here(base)?, steps.here(rest)?, steps.here(scale)?];
            let half = literal(&Rational::from_unsigneds(1u32, 2));
            let order = at_most(true, &half, &rest);
            let order = self.known(&order).ok_or(Fail::No("what is near 1"))?;
            let near = vec![scaled(&order, negated(scale.clone())), alone(product(vec![half, scale]))];
            self.combination(compare(base, Relation::Greater, numeral(0)), near)?;
        }
        if !by_powers {
            steps.equations[place] = steps.equations[child].clone();
            return Ok(());
        }
        let (e, other) = (steps.here(&node.e)?, steps.here(&steps.plan.nodes[child].e)?);
        let same = compare(e.clone(), Relation::Equal, other);
        let same = self.emit(Rule::Power, same.clone()).or_else(|_| self.without_cases(&same))?;
        let mut terms = vec![scaled(&same, numeral(1))];
        terms.extend(steps.equation(child).iter().map(|l| scaled(l, numeral(1))));
        let whole = steps.written(&steps.plan.series(place));
        steps.equations[place] = Some(self.combination(compare(e, Relation::Equal, whole), terms)?);
        Ok(())
    }

    fn linked_shown(
        &mut self,
        steps: &mut Steps<'_>,
        place: usize,
        node: &Node,
        links: &[(usize, Factors)],
        tail: &Series,
    ) -> Result<(), Fail> {
        let mut terms = Vec::new();
        let scale = steps.t(-node.order.unwrap_or(0));
        for (child, (is_negative, before, behind)) in links {
            let mut factor = vec![whole(if *is_negative { -1 } else { 1 }), scale.clone()];
            factor.extend(before.iter().map(|k| steps.written(&steps.plan.series(*k))));
            for k in behind {
                factor.push(steps.here(&steps.plan.nodes[*k].e)?);
            }
            terms.extend(steps.equation(*child).iter().map(|l| scaled(l, product(factor.clone()))));
        }
        let Some(rest) = node.rest else {
            let whole = steps.written(&steps.polynomial(node));
            let equation = compare(steps.here(&node.e)?, Relation::Equal, whole);
            steps.equations[place] = Some(self.combination(equation, terms)?);
            return Ok(());
        };
        let named = self.rest_named(steps, place, node)?;
        let number = name(&steps.plan.numbers[rest].0);
        terms.push(scaled(&named, whole(-1)));
        let value = self.combination(compare(number, Relation::Equal, steps.written(tail)), terms)?;
        let sides = [true, false].map(|upper| self.bounding(steps, tail, upper));
        let [upper, lower] = sides;
        self.number_bounded(steps, rest, [(&value, upper?), (&value, lower?)])
    }

    /// The bounds of a number: that it is, or is at most or at least, something, and terms that bound that.
    fn number_bounded(
        &mut self,
        steps: &mut Steps<'_>,
        number: usize,
        sides: [(&Label, Vec<Term>); 2],
    ) -> Result<(), Fail> {
        let (own, bound) = (name(&steps.plan.numbers[number].0), steps.plan.numbers[number].1.clone());
        let mut labels = Vec::new();
        for (place, (value, mut terms)) in sides.into_iter().enumerate() {
            let is_order = self
                .fact(value)
                .is_some_and(|p| matches!(&p.kind, PropKind::Compare(_, relations) if *relations != [Relation::Equal]));
            terms.push(scaled(value, whole(if place == 0 || is_order { 1 } else { -1 })));
            terms.extend(steps.name_of(&bound).map(|l| scaled(l, numeral(1))));
            labels.push(self.combination(side(place == 0, &own, &bound), terms)?);
        }
        steps.numbers[number] = <[Label; 2]>::try_from(labels).ok();
        Ok(())
    }

    /// That something with a named or numeral bound lies within it: the upper order first.
    fn within(&mut self, steps: &mut Steps<'_>, bounded: &Bounded) -> Result<[Label; 2], Fail> {
        let value = steps.written(&bounded.of);
        let mut labels = Vec::new();
        for upper in [true, false] {
            let mut terms = self.bounding(steps, &bounded.of, upper)?;
            terms.extend(steps.name_of(&bounded.by).map(|l| scaled(l, numeral(1))));
            labels.push(self.combination(side(upper, &value, &bounded.by), terms)?);
        }
        <[Label; 2]>::try_from(labels).map_err(|_| Fail::No("two bounds"))
    }

    /// Terms that come to S − Σ|c|·B, or to −Σ|c|·B − S, for a polynomial S.
    fn bounding(&mut self, steps: &mut Steps<'_>, series: &Series, upper: bool) -> Result<Vec<Term>, Fail> {
        let mut out = Vec::new();
        for ((k, list), c) in &series.terms {
            let c = if upper { c.clone() } else { negated(c.clone()) };
            let side = self.side_of(&c);
            if *k == 0 && list.is_empty() {
                match side {
                    Side::Above => {}
                    Side::Below => out.push(alone(product(vec![numeral(2), c]))),
                    Side::Both => {
                        let half = literal(&Rational::from_signeds(-1, 2));
                        out.push(alone(product(vec![half, whole_power(minus(&c, &numeral(1)), 2)])));
                    }
                }
                continue;
            }
            let [above, below] = self.product_bounded(steps, *k, list)?;
            match side {
                Side::Above => out.push(scaled(&above, c)),
                Side::Below => out.push(scaled(&below, negated(c))),
                Side::Both => {
                    let quarter =
                        |e: Expr| product(vec![literal(&Rational::from_unsigneds(1u32, 4)), whole_power(e, 2)]);
                    out.push(scaled(&above, quarter(total(&[c.clone(), numeral(1)]))));
                    out.push(scaled(&below, quarter(minus(&c, &numeral(1)))));
                }
            }
        }
        Ok(out)
    }

    /// −B <= t^k·ρ·… and t^k·ρ·… <= B for the product B of the bounds; the upper one first.
    fn product_bounded(&mut self, steps: &mut Steps<'_>, k: i64, list: &[usize]) -> Result<[Label; 2], Fail> {
        let key = (k, list.to_vec());
        if let Some(known) = steps.products.get(&key) {
            return Ok(known.clone());
        }
        if let (0, [only]) = (k, list) {
            return steps.numbers[*only].clone().ok_or(Fail::No("a bound"));
        }
        let one = Series { terms: [(key.clone(), numeral(1))].into() };
        let value = steps.written(&one);
        let labels = match list.split_last() {
            None => {
                let powers: Vec<Expr> = (0..k).map(|j| steps.t(j)).collect();
                let upper = vec![scaled(&steps.one, total(&powers))];
                let lower = vec![alone(negated(total(&[numeral(1), value.clone()])))];
                [
                    self.combination(side(true, &value, &numeral(1)), upper)?,
                    self.combination(side(false, &value, &numeral(1)), lower)?,
                ]
            }
            Some((last, before)) => {
                let [p, q] = self.product_bounded(steps, k, before)?;
                let [r, s] = steps.numbers[*last].clone().ok_or(Fail::No("a bound"))?;
                let bound = product(list.iter().map(|n| steps.plan.numbers[*n].1.clone()).collect());
                let bound = self.letters.number(&bound).map_or(bound, |q| literal(&q));
                let both = |a: &Label, b: &Label| Term {
                    facts: vec![a.clone(), b.clone()],
                    factor: literal(&Rational::from_signeds(-1, 2)),
                };
                [
                    self.combination(side(true, &value, &bound), vec![both(&p, &s), both(&q, &r)])?,
                    self.combination(side(false, &value, &bound), vec![both(&p, &r), both(&q, &s)])?,
                ]
            }
        };
        steps.products.insert(key, labels.clone());
        Ok(labels)
    }

    fn inverse_shown(&mut self, steps: &mut Steps<'_>, place: usize, node: &Node) -> Result<(), Fail> {
        let How::Inverse { of: child, power, lead, is_negative, rest, reach, cofactor } = &node.how else {
            return Err(Fail::No("a quotient"));
        };
        let (child_node, order) = (&steps.plan.nodes[*child], node.order.unwrap_or(0));
        let sign = whole(if *is_negative { -1 } else { 1 });
        let size = if *is_negative { negated(lead.clone()) } else { lead.clone() };
        let half = over(size.clone(), numeral(2));
        // F = t^v·G, and G is at least |b|/2 in size.
        let inner = steps.written(&steps.plan.series(*child).over(*power));
        let signed = product(vec![sign.clone(), inner.clone()]);
        let [above, below] = self.within(steps, rest)?;
        let mut away = steps.reached(*reach, &half);
        away.push(scaled(if *is_negative { &above } else { &below }, steps.t.clone()));
        let away = self.combination(compare(half.clone(), Relation::LessEqual, signed.clone()), away)?;
        self.at_least_positive(&signed, &away, &half)?;
        let scale = product(vec![sign.clone(), steps.t(*power)]);
        let mut terms: Vec<Term> = steps.equation(*child).iter().map(|l| scaled(l, numeral(1))).collect();
        terms.push(scaled(&away, negated(scale.clone())));
        terms.push(alone(product(vec![scale, half.clone()])));
        let relation = if *is_negative { Relation::Less } else { Relation::Greater };
        let divisor = steps.here(&child_node.e)?;
        self.combination(compare(divisor.clone(), relation, numeral(0)), terms)?;
        let named = self.rest_named(steps, place, node)?;
        let number = node.rest.ok_or(Fail::No("what is left"))?;
        let (own, bound) = (name(&steps.plan.numbers[number].0), steps.plan.numbers[number].1.clone());
        let mut terms = vec![scaled(&named, negated(inner.clone()))];
        let below = product(vec![whole(-1), over(numeral(1), product(vec![divisor, steps.t(order + power)]))]);
        terms.extend(steps.equation(*child).iter().map(|l| scaled(l, below.clone())));
        let times = compare(product(vec![own.clone(), inner]), Relation::Equal, steps.written(&cofactor.of));
        let times = self.combination(times, terms)?;
        let [above, below] = self.within(steps, cofactor)?;
        let mut labels = Vec::new();
        for upper in [true, false] {
            let turned = upper == *is_negative;
            let mut terms = vec![
                scaled(&times, if turned { whole(-1) } else { whole(1) }),
                scaled(if turned { &below } else { &above }, numeral(1)),
                scaled(&away, bound.clone()),
            ];
            terms.extend(steps.name_of(&bound).map(|l| scaled(l, half.clone())));
            let rule = Rule::Combination { times: Some(signed.clone()), terms };
            labels.push(self.emit(rule, side(upper, &own, &bound))?);
        }
        steps.numbers[number] = <[Label; 2]>::try_from(labels).ok();
        Ok(())
    }

    fn function_shown(&mut self, steps: &mut Steps<'_>, place: usize, node: &Node) -> Result<(), Fail> {
        let How::Function { of: child, function, degree, small, reach, tail, remainder } = &node.how else {
            return Err(Fail::No("a function"));
        };
        let argument = steps.here(&steps.plan.nodes[*child].e)?;
        let links = steps.equation(*child);
        // Near the centre.
        let [above, below] = self.within(steps, small)?;
        let half = |k: i64| literal(&Rational::from_signeds(k, 2));
        let mut near = Vec::new();
        for (sign, fact) in [(-1, &below), (1, &above)] {
            let end = literal(&(Rational::from_signeds(sign, 2) + Rational::from(function.centre())));
            let goal = at_most(sign < 0, &end, &argument);
            let mut terms: Vec<Term> = links.iter().map(|l| scaled(l, whole(sign))).collect();
            terms.push(scaled(fact, steps.t.clone()));
            terms.extend(steps.reached(*reach, &half(1)));
            near.push(self.combination(goal, terms)?);
        }
        if function.centre() == 1 {
            self.at_least_positive(&argument, &near[0], &half(1))?;
        }
        let near = <[Label; 2]>::try_from(near).map_err(|_| Fail::No("two bounds"))?;
        let named = self.rest_named(steps, place, node)?;
        let (order, number) = (node.order.unwrap_or(0), node.rest.ok_or(Fail::No("what is left"))?);
        let own = name(&steps.plan.numbers[number].0);
        let scale = steps.t(-order);
        let polynomial = steps.written(&steps.plan.series(*child));
        let mut values = Vec::new();
        for upper in [true, false] {
            let lemma = steps.lemmas.get(&(place, upper)).cloned().ok_or(Fail::No("a lemma"))?;
            self.within_reach(&lemma, &argument, &near)?;
            let fact = self.instance(&lemma, &argument)?;
            let mut terms = vec![scaled(&fact, scale.clone()), scaled(&named, whole(if upper { -1 } else { 1 }))];
            let slope = slope(function, *degree, upper, &argument, &polynomial);
            let factor = product(vec![whole(if upper { 1 } else { -1 }), scale.clone(), slope]);
            terms.extend(links.iter().map(|l| scaled(l, factor.clone())));
            let mut value = vec![steps.written(tail), steps.written(remainder)];
            if !upper {
                value[1] = negated(value[1].clone());
            }
            values.push(self.combination(side_of(upper, &own, &total(&value)), terms)?);
        }
        let mut sides = Vec::new();
        for upper in [true, false] {
            let mut terms = self.bounding(steps, tail, upper)?;
            terms.extend(self.bounding(steps, remainder, true)?);
            sides.push(terms);
        }
        let [upper, lower] = <[Vec<Term>; 2]>::try_from(sides).map_err(|_| Fail::No("two bounds"))?;
        self.number_bounded(steps, number, [(&values[0], upper), (&values[1], lower)])
    }

    /// What is at least a positive number is positive.
    fn at_least_positive(&mut self, e: &Expr, fact: &Label, bound: &Expr) -> Result<Label, Fail> {
        let terms = vec![scaled(fact, whole(-1)), alone(bound.clone())];
        self.combination(compare(e.clone(), Relation::Greater, numeral(0)), terms)
    }

    /// A sine or cosine lies between −1 and 1.
    fn turning_shown(&mut self, steps: &mut Steps<'_>, place: usize, node: &Node) -> Result<(), Fail> {
        let named = self.rest_named(steps, place, node)?;
        let e = steps.here(&node.e)?;
        let number = node.rest.ok_or(Fail::No("what is left"))?;
        let own = name(&steps.plan.numbers[number].0);
        let mut labels = Vec::new();
        for upper in [true, false] {
            let order = self.without_cases(&side(upper, &e, &numeral(1)))?;
            let terms = vec![scaled(&order, numeral(1)), scaled(&named, whole(if upper { -1 } else { 1 }))];
            labels.push(self.combination(side(upper, &own, &numeral(1)), terms)?);
        }
        steps.numbers[number] = <[Label; 2]>::try_from(labels).ok();
        Ok(())
    }
}

/// `e <= bound`, or `-bound <= e`.
fn side(upper: bool, e: &Expr, bound: &Expr) -> Prop {
    if upper { side_of(true, e, bound) } else { side_of(false, e, &negated(bound.clone())) }
}

/// `e <= bound`, or `bound <= e`.
fn side_of(upper: bool, e: &Expr, bound: &Expr) -> Prop {
    at_most(!upper, bound, e)
}

/// (T(a) − T(b))/(a − b) for a polynomial of Taylor with its remainder.
fn slope(function: &Function, degree: u32, upper: bool, a: &Expr, b: &Expr) -> Expr {
    let centre = |e: &Expr| match function.centre() {
        0 => e.clone(),
        k => minus(e, &numeral(k)),
    };
    let (a, b) = (centre(a), centre(b));
    let coefficients = function.bound_coefficients(degree, upper, Side::Both);
    let mut terms = Vec::new();
    for (k, c) in coefficients.iter().enumerate().filter(|(_, c)| **c != Rational::ZERO) {
        for i in 0..k {
            let powers = [(&a, i), (&b, k - 1 - i)].map(|(e, j)| whole_power(e.clone(), i64::try_from(j).unwrap_or(0)));
            terms.push(product([vec![literal(c)], powers.to_vec()].concat()));
        }
    }
    total(&terms)
}

/// The nodes that the last one needs.
fn used(plan: &Expansion) -> BTreeSet<usize> {
    let mut used = BTreeSet::new();
    let mut open: Vec<usize> = plan.nodes.len().checked_sub(1).into_iter().collect();
    while let Some(k) = open.pop() {
        if !used.insert(k) {
            continue;
        }
        match &plan.nodes[k].how {
            How::Exact | How::Turning => {}
            How::Same { child, .. } => open.push(*child),
            How::Linked { links, .. } => open.extend(links.iter().map(|l| l.0)),
            How::Inverse { of, .. } | How::Function { of, .. } => open.push(*of),
        }
    }
    used
}
