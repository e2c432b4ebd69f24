//! Definite integrals: the value by an antiderivative, and the order by that of what is integrated.

use super::antiderivatives::antiderivative;
use super::facts::{minus, negated};
use super::letters::{as_power, product, total};
use super::limits::{holds, over};
use super::slopes::put_in;
use super::sums::replace;
use super::{Fail, Prover};
use crate::certificate::{Label, Rule, Term};
use crate::claim::definedness::{Need, needs};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, name, numeral, power, prop};

/// An expression with the integrals in it replaced by their values by antiderivatives, where these are found.
pub(crate) fn with_values_of_integrals(e: &Expr) -> Expr {
    with_values_by(e, &mut |x, f| antiderivative(f, &x.name.text))
}

/// The same, with this way to find an antiderivative.
fn with_values_by(e: &Expr, find: &mut dyn FnMut(&Index, &Expr) -> Option<Expr>) -> Expr {
    let mut out = e.clone();
    crate::claim::walk::parts_mut(&mut out, &mut |part| *part = with_values_by(part, find));
    if let ExprKind::IntegralOver(x, f) = &out.kind
        && let Some(big_f) = find(x, f)
        && let (Ok(to), Ok(from)) = (put_in(&big_f, &x.name.text, &x.to), put_in(&big_f, &x.name.text, &x.from))
    {
        return minus(&to, &from);
    }
    out
}

/// The integrals in an expression that stand in no sum, product or other integral.
fn integrals_in(e: &Expr, out: &mut Vec<Expr>) {
    match &e.kind {
        ExprKind::IntegralOver(..) => out.push(e.clone()),
        ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::Derivative(..) => {}
        _ => crate::claim::walk::parts(e, &mut |part| integrals_in(part, out)),
    }
}

impl Prover {
    /// A comparison with the values of its integrals in their places, or else by the order of what is integrated.
    pub(super) fn by_integrals(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let PropKind::Compare(sides, _) = &goal.kind else { return Err(Fail::No("a comparison")) };
        let mut integrals = Vec::new();
        sides.iter().for_each(|e| integrals_in(e, &mut integrals));
        if integrals.is_empty() {
            return Err(Fail::No("an integral"));
        }
        for e in &integrals {
            if let ExprKind::IntegralOver(variable, f) = &e.kind
                && self.read(e, false).is_none()
            {
                self.have_values_between([&variable.from, &variable.to], &variable.name.text, [f, f]);
            }
        }
        self.enrich(&integrals.iter().collect::<Vec<_>>());
        let by_value = self.by_values_of_integrals(goal);
        // With little effort there is no search for another order.
        if by_value.is_ok() || self.splits >= 8 { by_value } else { self.attempt(|c| c.by_integrands(goal)) }
    }

    /// A comparison with the values of its integrals in their places.
    fn by_values_of_integrals(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(Fail::No("a comparison")) };
        let mut find = |x: &Index, f: &Expr| self.antiderivative_between(f, &x.name.text, x);
        let plain: Vec<Expr> = sides.iter().map(|e| with_values_by(e, &mut find)).collect();
        if plain == *sides {
            return Err(Fail::No("an antiderivative"));
        }
        let plain = prop(PropKind::Compare(plain, relations.clone()));
        let shown = self.attempt(|c| c.show(&plain))?;
        sides.iter().for_each(|side| self.define(side));
        self.combination(goal.clone(), vec![Term { facts: vec![shown], factor: numeral(1) }])
    }

    /// An antiderivative with a value between the ends: ln(−u) stands for ln(u) where u is negative at one of them.
    fn antiderivative_between(&mut self, f: &Expr, x: &str, ends: &Index) -> Option<Expr> {
        let found = antiderivative(f, x)?;
        Some(self.with_positive_arguments(&found, x, &[(*ends.from).clone(), (*ends.to).clone()]))
    }

    fn with_positive_arguments(&mut self, e: &Expr, x: &str, ends: &[Expr]) -> Expr {
        let mut out = e.clone();
        crate::claim::walk::parts_mut(&mut out, &mut |part| *part = self.with_positive_arguments(part, x, ends));
        if let ExprKind::Apply(function, at) = &mut out.kind
            && let ("ln", [u]) = (function.text.as_str(), at.as_mut_slice())
            && holds(u, x)
        {
            let values: Vec<Expr> = ends.iter().filter_map(|end| put_in(u, x, end).ok()).collect();
            if values.iter().any(|u| self.signs_of(u).within(Signs::of(Relation::Less))) {
                *u = negated(u.clone());
            }
        }
        out
    }

    /// F(b) − F(a) = integral(x = a..b, f), put in for the integral.
    pub(super) fn learn_integral(&mut self, variable: &Index, f: &Expr) -> Result<bool, Fail> {
        let no = || Fail::No("an antiderivative");
        let x = self.fresh("t");
        let f = put_in(f, &variable.name.text, &name(&x))?;
        let big_f = self.antiderivative_between(&with_values_of_integrals(&f), &x, variable).ok_or_else(no)?;
        let (a, b) = (&variable.from, &variable.to);
        let values = minus(&put_in(&big_f, &x, b)?, &put_in(&big_f, &x, a)?);
        let integral = over_interval(variable, &x, &f);
        let equation = compare(integral.clone(), Relation::Equal, values.clone());
        let label = self.gained(variable, &x, [&big_f, &f, &f], Relation::Equal, |c, label| {
            // An equation is put in for what stands on its left.
            let terms = vec![Term { facts: vec![label], factor: negated(numeral(1)) }];
            c.combination(equation.clone(), terms)
        })?;
        self.take_in(&label, &equation)?;
        self.put_in(&label);
        Ok(true)
    }

    /// Shows that expressions have values everywhere from one end to another, which the kernel then learns where it asks for
    /// it. Returns whether there is something that it did not know.
    fn have_values_between(&mut self, [from, to]: [&Expr; 2], x: &str, exprs: [&Expr; 2]) -> bool {
        let every = |p: Prop, closed: bool| {
            let (from, to) = (from.clone(), to.clone());
            let ends = Constraint::Interval { from, from_closed: closed, to, to_closed: closed };
            prop(PropKind::ForAll(vec![Binding::of(Name::new(x), false, vec![ends])], Box::new(p)))
        };
        // What stands under roots is to be positive, of which the kernel does not learn by a root. At an end it may be 0.
        let mut inside = Vec::new();
        exprs.iter().for_each(|e| under_roots(e, x, &mut inside));
        let mut is_new =
            |p: &Prop| self.known(p).is_none() && self.quietly(p).or_else(|_| self.without_cases(p)).is_ok();
        let mut count = 0;
        for e in inside {
            let is = |relation| compare(e.clone(), relation, numeral(0));
            let positive = is_new(&every(is(Relation::Greater), true));
            let but_at_ends = [every(is(Relation::GreaterEqual), true), every(is(Relation::Greater), false)];
            count += usize::from(positive || but_at_ends.iter().filter(|p| is_new(p)).count() > 0);
        }
        let itself = exprs.map(|e| every(compare(e.clone(), Relation::Equal, e.clone()), true));
        count + itself.iter().filter(|p| is_new(p)).count() > 0
    }

    /// Shows that what stands under the roots of an expression is positive, between the ends of an integral.
    fn positive_under_roots(&mut self, e: &Expr, x: &str) {
        let mut inside = Vec::new();
        under_roots(e, x, &mut inside);
        for e in inside {
            if !self.signs_of(&e).within(Signs::POSITIVE) {
                let positive = compare(e, Relation::Greater, numeral(0));
                let _ = self.quietly(&positive).or_else(|_| self.without_cases(&positive));
            }
        }
    }

    /// F(b) − F(a) relation integral(x = a..b, f), from F′ relation f, and what follows from it; F′ is given as well. Where a > b,
    /// the relation of F′ is the opposite one. An equation is tried on all numbers, between the ends, and on one side of 0:
    /// the kernel adds no bounds up, so that 1/x needs to be told that x > 0.
    fn gained(
        &mut self,
        variable: &Index,
        x: &str,
        [big_f, slope, f]: [&Expr; 3],
        relation: Relation,
        conclude: impl Fn(&mut Prover, Label) -> Result<Label, Fail>,
    ) -> Result<Label, Fail> {
        let (a, b) = ((*variable.from).clone(), (*variable.to).clone());
        let values = minus(&put_in(big_f, x, &b)?, &put_in(big_f, x, &a)?);
        let derivative = expr(ExprKind::Derivative(Box::new(big_f.clone()), vec![Name::new(x)]));
        self.define(&a);
        self.define(&b);
        let side = |relation| Constraint::Relation(relation, numeral(0));
        let between = |from: &Expr, to: &Expr| Constraint::Interval {
            from: from.clone(),
            from_closed: false,
            to: to.clone(),
            to_closed: false,
        };
        let run = self.signs_of(&minus(&b, &a));
        let (up, down) = (run.within(Signs::NOT_NEGATIVE), run.within(Signs::of(Relation::LessEqual)));
        let mut domains = Vec::new();
        if relation == Relation::Equal {
            domains.extend([vec![], vec![side(Relation::Greater)], vec![side(Relation::Less)]]);
        }
        if up || down {
            domains.insert(domains.len().min(1), vec![if up { between(&a, &b) } else { between(&b, &a) }]);
        }
        let own = if up { relation } else { relation.turned() };
        let goal = compare(values.clone(), relation, over_interval(variable, x, f));
        let mut shown = Err(Fail::No("an order of the ends"));
        for constraints in domains {
            let is_between = constraints.iter().any(|c| matches!(c, Constraint::Interval { .. }));
            let binding = Binding::of(Name::new(x), false, constraints);
            shown = self.attempt(|c| {
                let body = compare(derivative.clone(), own, f.clone());
                let every = prop(PropKind::ForAll(vec![binding], Box::new(body.clone())));
                let source = c.block(&every, |c, _| {
                    if is_between {
                        c.positive_under_roots(big_f, x);
                    }
                    c.define(&derivative);
                    c.combination(body.clone(), Vec::new()).or_else(|_| {
                        if own == Relation::Equal {
                            return c.quietly(&body).or_else(|fail| {
                                // Roots that are multiples of each other.
                                if is_between { c.without_cases(&body) } else { Err(fail) }
                            });
                        }
                        let shown = c.quietly(&compare(slope.clone(), own, f.clone()))?;
                        c.combination(body.clone(), vec![Term { facts: vec![shown], factor: numeral(1) }])
                    })
                })?;
                let with = vec![(Name::new("a"), a.clone()), (Name::new("b"), b.clone())];
                let rule = Rule::Slope { source, with, from: Vec::new() };
                let label = c.emit(rule.clone(), goal.clone()).or_else(|fail| {
                    let (from, to) = if up { (&a, &b) } else { (&b, &a) };
                    c.define(&values);
                    if !up && !down || !c.have_values_between([from, to], x, [big_f, f]) {
                        return Err(fail);
                    }
                    c.emit(rule, goal.clone())
                })?;
                conclude(c, label)
            });
            if shown.is_ok() {
                break;
            }
        }
        shown
    }

    /// A comparison of integrals over one interval with each other and with a number, by the order of what is integrated.
    ///
    /// With everything on one side it says c·∫f + Σ cᵢ·∫fᵢ + v relation 0. It follows from c·f + Σ cᵢ·fᵢ + v/(b − a) relation 0 between
    /// the ends. Where v is another number, a bound of f whose integral is known stands for f.
    pub(super) fn by_integrands(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("integrals over one interval");
        let Some((left, relation, right)) = goal.single() else { return Err(no()) };
        if matches!(relation, Relation::Equal | Relation::NotEqual) {
            return Err(no());
        }
        let mut terms = Vec::new();
        terms_of(left, &numeral(1), &mut terms);
        terms_of(right, &negated(numeral(1)), &mut terms);
        let is_integral = |e: &Expr| matches!(e.kind, ExprKind::IntegralOver(..));
        // What has no antiderivative is the one to be compared.
        let moving = terms.iter().filter(|t| is_integral(&t.1));
        let main = moving.clone().find(|t| with_values_of_integrals(&t.1) == t.1).or_else(|| moving.clone().next());
        let Some((factor, integral)) = main.cloned() else { return Err(no()) };
        let ExprKind::IntegralOver(variable, f) = &integral.kind else { return Err(no()) };
        let signs = self.signs_of(&factor);
        // integral relation (the rest)/c
        let relation = match (signs.within(Signs::POSITIVE), signs.within(Signs::of(Relation::Less))) {
            (true, _) => relation,
            (_, true) => relation.turned(),
            _ => return Err(no()),
        };
        let (a, b) = (&*variable.from, &*variable.to);
        let x = self.fresh("t");
        let f = put_in(f, &variable.name.text, &name(&x))?;
        let (mut beside, mut rest) = (Vec::new(), Vec::new());
        let mut is_main = true;
        for (own, e) in &terms {
            if is_main && *e == integral {
                is_main = false;
                continue;
            }
            let ratio = negated(over(own.clone(), factor.clone()));
            match &e.kind {
                ExprKind::IntegralOver(own, g) if [(a, b), (b, a)].contains(&(&*own.from, &*own.to)) => {
                    let g = put_in(g, &own.name.text, &name(&x))?;
                    let ratio = if *own.from == *a { ratio } else { negated(ratio) };
                    beside.push((Sign::Plus, product(vec![ratio, g])));
                }
                _ => rest.push((Sign::Plus, product(vec![ratio, e.clone()]))),
            }
        }
        let rest = with_values_of_integrals(&total(rest));
        let no_rest = self.signs_of(&rest).within(Signs::ZERO);
        let mut lower = beside.clone();
        if !no_rest {
            lower.push((Sign::Plus, over(rest.clone(), minus(b, a))));
        }
        // F′ with F(b) − F(a) beside the integral of f.
        let mut bounds = vec![total(lower)];
        if beside.is_empty() && !no_rest {
            bounds.extend(tangents(&f));
        }
        for bound in bounds {
            let Some(big_f) = antiderivative(&bound, &x) else { continue };
            let gain = minus(&put_in(&big_f, &x, b)?, &put_in(&big_f, &x, a)?);
            let mut sides = [left.clone(), right.clone()];
            sides.iter_mut().for_each(|e| replace(e, &integral, &gain));
            let plain = compare(sides[0].clone(), relation.loose(), sides[1].clone());
            let shown = self.gained(variable, &x, [&big_f, &bound, &f], relation.turned(), |c, label| {
                c.enrich(&sides.iter().collect::<Vec<_>>());
                // left - right = -c·(F(b) - F(a) - integral) + what is left with F(b) - F(a) for the integral.
                let mut terms = vec![Term { facts: vec![label], factor: negated(factor.clone()) }];
                c.combination(goal.clone(), terms.clone()).or_else(|_| {
                    terms.push(Term { facts: vec![c.quietly(&plain)?], factor: numeral(1) });
                    c.combination(goal.clone(), terms)
                })
            });
            if shown.is_ok() {
                return shown;
            }
        }
        Err(no())
    }
}

/// What stands under roots and holds a variable, each once.
fn under_roots(e: &Expr, x: &str, out: &mut Vec<Expr>) {
    for need in needs(e, &|_| false).into_iter().flatten() {
        if let Need::NotNegative(inside) | Need::Positive(inside) = need
            && holds(&inside, x)
            && !out.contains(&inside)
        {
            out.push(inside);
        }
    }
    crate::claim::walk::parts(e, &mut |part| under_roots(part, x, out));
}

/// The terms of a sum with the factors before them; what is no integral may keep its own.
fn terms_of(e: &Expr, factor: &Expr, out: &mut Vec<(Expr, Expr)>) {
    match &e.kind {
        ExprKind::Sum(list) => {
            let opposite = negated(factor.clone());
            list.iter().for_each(|(sign, e)| terms_of(e, if *sign == Sign::Plus { factor } else { &opposite }, out));
        }
        ExprKind::Negate(e) => terms_of(e, &negated(factor.clone()), out),
        ExprKind::Product(list) => {
            let is_moving = |e: &Expr| {
                let mut found = Vec::new();
                integrals_in(e, &mut found);
                !found.is_empty()
            };
            let places: Vec<usize> = (0..list.len()).filter(|i| is_moving(&list[*i].1)).collect();
            let [place] = places.as_slice() else { return out.push((factor.clone(), e.clone())) };
            let (Factor::Times, main) = &list[*place] else { return out.push((factor.clone(), e.clone())) };
            let beside = list.iter().enumerate().filter(|(i, _)| i != place);
            let beside = beside.map(|(_, (how, e))| match how {
                Factor::Times => e.clone(),
                Factor::Over => over(numeral(1), e.clone()),
            });
            terms_of(main, &product(beside.chain([factor.clone()]).collect()), out);
        }
        _ => out.push((factor.clone(), e.clone())),
    }
}

/// Tangents of functions, which lie on one side of them: of exp, sin and cos at 0, of ln, roots and reciprocals at 1.
fn tangents(f: &Expr) -> Vec<Expr> {
    let one = |sign, e: &Expr| expr(ExprKind::Sum(vec![(Sign::Plus, numeral(1)), (sign, e.clone())]));
    let Some((base, exponent)) = as_power(f) else {
        let ExprKind::Apply(function, arguments) = &f.kind else { return Vec::new() };
        let [w] = arguments.as_slice() else { return Vec::new() };
        return match function.text.as_str() {
            "exp" => vec![one(Sign::Plus, w)],
            "sin" => vec![w.clone()],
            "cos" => vec![one(Sign::Minus, &over(power(w, &numeral(2)), numeral(2)))],
            "ln" => vec![minus(w, &numeral(1))],
            "sqrt" => vec![over(one(Sign::Plus, w), numeral(2))],
            _ => Vec::new(),
        };
    };
    // 1 + k·(u - 1)
    vec![one(Sign::Plus, &product(vec![exponent, minus(&base, &numeral(1))]))]
}

/// integral(x = a..b, f) with another name for its variable.
fn over_interval(variable: &Index, x: &str, f: &Expr) -> Expr {
    let own = Index { name: Name::new(x), ..variable.clone() };
    expr(ExprKind::IntegralOver(own, Box::new(f.clone())))
}
