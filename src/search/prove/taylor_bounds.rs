//! Bounds by Taylor's polynomials, from the last derivative back.
//!
//! Method: let G be the distance of a function from its polynomial of degree d with the remainder C·s^(d + 1). At the centre G and its
//! derivatives up to order d are 0. That of order d + 1 has one sign, for C is large. So on each side of the centre the sign of a
//! derivative gives the sign of the one before: one step of the rule `slope` each. The first derivatives of arcsin and arctan are
//! compared as any other goal.

use super::facts::{minus, negated, scaled};
use super::taylor::{Function, Side, TaylorBound, polynomial};
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::statement::{compare, expr, name, numeral, prop};
use malachite::Rational;

impl Prover {
    /// Shows a bound for all y, if it is not known.
    pub(super) fn taylor_bound(&mut self, bound: &TaylorBound) -> Result<Label, Fail> {
        let is_it = |fact: &Prop| match &fact.kind {
            PropKind::ForAll(bindings, _) => match bindings.as_slice() {
                [Binding { names, .. }] => key::prop(&bound.statement(&names[0].0.text)) == key::prop(fact),
                _ => false,
            },
            _ => false,
        };
        if let Some((label, _)) = self.checker.facts().find(|(_, fact)| is_it(fact)) {
            return Ok(label.to_string());
        }
        let y = self.fresh("y");
        match self.on_its_own(|c| c.by_the_last_derivative(bound, &y)) {
            Ok(label) => Ok(label),
            Err(_) => self.lemma(&bound.statement(&y)),
        }
    }

    fn by_the_last_derivative(&mut self, bound: &TaylorBound, y: &str) -> Result<Label, Fail> {
        let orders = match bound.function {
            Function::Sine | Function::Cosine => bound.degree + 1,
            Function::Arcsine | Function::Arctangent => 1,
            _ => return Err(Fail::No("derivatives in few words")),
        };
        let mut sides = Vec::new();
        for side in [Side::Above, Side::Below] {
            if bound.side == Side::Both || bound.side == side {
                sides.push((side, self.beside_the_centre(bound, orders, side)?));
            }
        }
        let every = bound.statement(y);
        let PropKind::ForAll(_, goal) = &every.kind else { return Err(Fail::No("a bound")) };
        self.block(&every, |c, _| {
            let mut from = Vec::new();
            for (side, every) in &sides {
                let case = compare(
                    name(y),
                    if *side == Side::Above { Relation::GreaterEqual } else { Relation::Less },
                    numeral(0),
                );
                from.push(c.block(&implies(&case, goal), |c, _| {
                    if *side == Side::Below {
                        c.by_linear_facts(&compare(name(y), Relation::LessEqual, numeral(0)))?;
                    }
                    let (here, ..) = c.instance_alone(every, &name(y))?;
                    c.combination((**goal).clone(), vec![scaled(&here, negated(numeral(1)))])
                })?);
            }
            if bound.side == Side::Below {
                let case = compare(name(y), Relation::Equal, numeral(0));
                from.push(c.block(&implies(&case, goal), |c, _| {
                    c.solve_equations();
                    c.quietly(goal)
                })?);
            }
            c.emit(Rule::Logic { from }, (**goal).clone())
        })
    }

    /// The sign of the distance from the bound on a side of the centre, by those of its derivatives up to an order.
    fn beside_the_centre(&mut self, bound: &TaylorBound, orders: u32, side: Side) -> Result<Label, Fail> {
        let mut last: Option<Label> = None;
        for order in (0..=orders).rev() {
            let y = self.fresh("y");
            let distance = |y: &Expr| distance(bound, order, y).ok_or(Fail::No("a derivative"));
            let relation = sign(bound, order, side);
            let goal = compare(distance(&name(&y))?, relation, numeral(0));
            let every = prop(PropKind::ForAll(vec![side.near(&y, 0)], Box::new(goal.clone())));
            let Some(next) = &last else {
                last = Some(self.lemma(&every)?);
                continue;
            };
            let shown = self.block(&every, |c, _| {
                let (t, y, centre) = (c.fresh("t"), name(&y), numeral(0));
                let (from, to) = if side == Side::Above { (&centre, &y) } else { (&y, &centre) };
                let between =
                    Constraint::Interval { from: from.clone(), from_closed: false, to: to.clone(), to_closed: false };
                let f = distance(&name(&t))?;
                c.define(&f);
                let derivative = expr(ExprKind::Derivative(Box::new(f), vec![Name::new(&t)]));
                let slope = compare(derivative, sign(bound, order + 1, side), numeral(0));
                let binding = Binding::of(Name::new(&t), false, vec![between]);
                let every = prop(PropKind::ForAll(vec![binding], Box::new(slope.clone())));
                let source = c.block(&every, |c, _| {
                    for constraint in side.near(&t, 0).constraints {
                        let Constraint::Interval { from, to, .. } = constraint else { continue };
                        c.by_linear_facts(&compare(from, Relation::LessEqual, name(&t)))?;
                        c.by_linear_facts(&compare(name(&t), Relation::LessEqual, to))?;
                    }
                    let (here, ..) = c.instance_alone(next, &name(&t))?;
                    c.combination(slope.clone(), vec![scaled(&here, numeral(1))])
                })?;
                let with = vec![(Name::new("a"), centre.clone()), (Name::new("b"), y.clone())];
                let order = compare(distance(&y)?, relation, distance(&centre)?);
                let label = c.emit(Rule::Slope { source, with, from: Vec::new() }, order)?;
                c.combination(goal.clone(), vec![scaled(&label, numeral(1))])
            })?;
            last = Some(shown);
        }
        last.ok_or(Fail::No("a derivative"))
    }
}

/// The derivative of the distance of the function from its bound.
fn distance(bound: &TaylorBound, order: u32, y: &Expr) -> Option<Expr> {
    let mut coefficients = bound.function.bound_coefficients(bound.degree, bound.upper, bound.side);
    for _ in 0..order {
        coefficients = coefficients.into_iter().zip(0u32..).skip(1).map(|(c, k)| c * Rational::from(k)).collect();
    }
    let (f, polynomial) = (bound.function.derivative(order, y)?, polynomial(&coefficients, y));
    Some(if bound.upper { minus(&polynomial, &f) } else { minus(&f, &polynomial) })
}

/// Its sign on a side of the centre. That of the last derivative is the sign of the remainder; before the centre each sign is the
/// opposite of the next.
fn sign(bound: &TaylorBound, order: u32, side: Side) -> Relation {
    let steps = (bound.degree + 1).saturating_sub(order);
    let is_last_negative = bound.side == Side::Below && bound.degree.is_multiple_of(2);
    let is_turned = side == Side::Below && !steps.is_multiple_of(2);
    if is_last_negative == is_turned { Relation::GreaterEqual } else { Relation::LessEqual }
}
