//! Definite integrals: the value by an antiderivative.

use super::antiderivatives::antiderivative;
use super::facts::{minus, negated};
use super::slopes::put_in;
use super::{Fail, Prover};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, name, numeral, prop};

/// An expression with the integrals in it replaced by their values by antiderivatives, where these are found.
pub(crate) fn with_values_of_integrals(e: &Expr) -> Expr {
    let mut out = e.clone();
    crate::claim::walk::parts_mut(&mut out, &mut |part| *part = with_values_of_integrals(part));
    if let ExprKind::IntegralOver(x, f) = &out.kind
        && let Some(big_f) = antiderivative(f, &x.name.text)
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
    /// A comparison with the values of its integrals in their places.
    pub(super) fn by_integrals(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(Fail::No("a comparison")) };
        let mut integrals = Vec::new();
        sides.iter().for_each(|e| integrals_in(e, &mut integrals));
        if integrals.is_empty() {
            return Err(Fail::No("an integral"));
        }
        self.enrich(&integrals.iter().collect::<Vec<_>>());
        let plain = sides.iter().map(with_values_of_integrals).collect();
        let plain = prop(PropKind::Compare(plain, relations.clone()));
        let shown = self.attempt(|c| c.show(&plain))?;
        sides.iter().for_each(|side| self.define(side));
        self.combination(goal.clone(), vec![Term { facts: vec![shown], factor: numeral(1) }])
    }

    /// F(b) − F(a) = integral(x = a..b, f), put in for the integral. F is tried on all numbers, on one side of 0, and between the
    /// ends: the kernel adds no bounds up, so that 1/x needs to be told that x > 0.
    pub(super) fn learn_integral(&mut self, variable: &Index, f: &Expr) -> Result<bool, Fail> {
        let no = || Fail::No("an antiderivative");
        let x = self.fresh("t");
        let f = put_in(f, &variable.name.text, &name(&x))?;
        let big_f = antiderivative(&with_values_of_integrals(&f), &x).ok_or_else(no)?;
        let (a, b) = ((*variable.from).clone(), (*variable.to).clone());
        let own = Index { name: Name::new(&x), ..variable.clone() };
        let integral = expr(ExprKind::IntegralOver(own, Box::new(f.clone())));
        let values = minus(&put_in(&big_f, &x, &b)?, &put_in(&big_f, &x, &a)?);
        let goal = compare(values.clone(), Relation::Equal, integral.clone());
        let equation = compare(integral, Relation::Equal, values);
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
        let mut domains = vec![Vec::new(), vec![side(Relation::Greater)], vec![side(Relation::Less)]];
        if run.within(Signs::NOT_NEGATIVE) {
            domains.push(vec![between(&a, &b)]);
        } else if run.within(Signs::of(Relation::LessEqual)) {
            domains.push(vec![between(&b, &a)]);
        }
        for constraints in domains {
            let binding = Binding::of(Name::new(&x), false, constraints);
            let shown = self.attempt(|c| {
                let derivative = expr(ExprKind::Derivative(Box::new(big_f.clone()), vec![Name::new(&x)]));
                let body = compare(derivative.clone(), Relation::Equal, f.clone());
                let every = prop(PropKind::ForAll(vec![binding], Box::new(body.clone())));
                let source = c.block(&every, |c, _| {
                    c.define(&derivative);
                    c.combination(body.clone(), Vec::new()).or_else(|_| c.quietly(&body))
                })?;
                let with = vec![(Name::new("a"), a.clone()), (Name::new("b"), b.clone())];
                let label = c.emit(Rule::Slope { source, with, from: Vec::new() }, goal.clone())?;
                // An equation is put in for what stands on its left.
                let terms = vec![Term { facts: vec![label], factor: negated(numeral(1)) }];
                c.combination(equation.clone(), terms)
            });
            if let Ok(label) = shown {
                self.take_in(&label, &equation)?;
                self.put_in(&label);
                return Ok(true);
            }
        }
        Err(no())
    }
}
