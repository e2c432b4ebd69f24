//! Comparisons with arcsin, arccos and arctan.
//!
//! Method: an equation is solved for one of its arcs, `arctan(x) = y`; it holds if x is the tangent of y and y lies between −π/2
//! and π/2. An order of two arcs is that of their arguments. An arc beside a number in its range is compared with the arc of the
//! number's sine or tangent.
//!
//! Certificate: rule `arc`, with what it needs shown before.

use super::comparison::single;
use super::facts::{minus, negated};
use super::letters::product;
use super::limits::over;
use super::{Fail, Prover};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::arc::{as_arc, turned_back};
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, name, numeral};
use crate::kernel::trigonometry::{below_the_argument, below_the_tangent};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::One;

/// A multiple of π/2.
pub(super) fn quarter_turn(times: i64) -> Expr {
    product(vec![literal(&Rational::from_signeds(times, 2)), name(PI)])
}

impl Prover {
    /// Of an arc: the bounds of its range, and those that its sine and cosine give.
    pub(super) fn learn_arc(&mut self, arc: &Expr) -> Result<bool, Fail> {
        let (below, above) = match as_arc(arc) {
            Some(("arctan", _)) => (Relation::Greater, Relation::Less),
            Some(("arcsin", _)) => (Relation::GreaterEqual, Relation::LessEqual),
            _ => return Ok(false),
        };
        for (relation, times) in [(below, -1), (above, 1)] {
            self.new_fact(
                Rule::Combination { times: None, terms: Vec::new() },
                compare(arc.clone(), relation, quarter_turn(times)),
            )?;
        }
        let _ = self.attempt(|c| c.beside_argument(arc));
        Ok(false)
    }

    /// arctan x is at most x for x ≥ 0, and arcsin x at least; for x ≤ 0 the other way round.
    fn beside_argument(&mut self, arc: &Expr) -> Result<(), Fail> {
        let (f, x) = as_arc(arc).ok_or(Fail::No("an arc"))?;
        let signs = self.signs_of(arc);
        let is_negative = signs.within(Signs::of(Relation::LessEqual));
        let u = if is_negative { negated(arc.clone()) } else { arc.clone() };
        let order = if signs.within(Signs::NOT_ZERO) { Relation::Less } else { Relation::LessEqual };
        let rule = Rule::Circle { with: vec![(Name::new("u"), u.clone())] };
        let (order_of_arc, shown, factor) = if f == "arctan" {
            (order, below_the_tangent(&u, order), over(numeral(1), apply("cos", arc.clone())))
        } else {
            (order.turned(), below_the_argument(&u, order), numeral(1))
        };
        let label = self.emit(rule, shown)?;
        let relation = if is_negative { order_of_arc.turned() } else { order_of_arc };
        let shown = compare(arc.clone(), relation, x.clone());
        let label = self.combination(shown.clone(), vec![Term { facts: vec![label], factor }])?;
        self.take_in(&label, &shown)
    }

    /// Shows a comparison in which an arc stands.
    pub(super) fn by_arcs(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("an arc");
        if self.within_arcs || self.checker.statement().declares(PI) {
            return Err(no());
        }
        let difference = minus(a, b);
        let arcs: Vec<Expr> = self.letters_in(&[&difference]).into_iter().filter(|e| as_arc(e).is_some()).collect();
        for arc in &arcs {
            let Some((turned, rest)) = self.solved_for(&difference, arc) else { continue };
            let relation = if turned { relation.turned() } else { relation };
            self.within_arcs = true;
            let shown = self.attempt(|c| {
                let label = match relation {
                    Relation::Equal => c.equal_to_arc(arc, &rest)?,
                    _ => c.beside_arc(arc, relation, &rest)?,
                };
                let known = c.fact(&label).ok_or_else(no)?;
                c.take_in(&label, &known)?;
                c.put_in(&label);
                c.combination(goal.clone(), Vec::new()).or_else(|_| c.quietly(goal))
            });
            self.within_arcs = false;
            if shown.is_ok() {
                return shown;
            }
        }
        Err(no())
    }

    /// The y for which the difference is c·(arc − y) with a rational number c, and whether c is negative.
    pub(super) fn solved_for(&mut self, difference: &Expr, arc: &Expr) -> Option<(bool, Expr)> {
        let reading = self.read(difference, false)?;
        let [factor] = reading.factors.as_slice() else { return None };
        let letter = self.letters.of(arc);
        let list = factor.poly.coefficients_in(letter);
        let ([rest, slope], 1) = (list.as_slice(), factor.power) else { return None };
        let slope = slope.as_constant()?;
        let turned = (slope < 0) != (reading.number < 0);
        let rest = rest.scale(&(-Rational::ONE / slope));
        Some((turned, self.letters.written(&rest)))
    }

    /// Shows `arc = y`.
    fn equal_to_arc(&mut self, arc: &Expr, y: &Expr) -> Result<Label, Fail> {
        let (f, x) = as_arc(arc).ok_or(Fail::No("an arc"))?;
        let goal = compare(arc.clone(), Relation::Equal, y.clone());
        if let Some((g, other)) = as_arc(y)
            && f == g
        {
            let label = self.quietly(&compare(x.clone(), Relation::Equal, other.clone()))?;
            self.put_in(&label);
            return self.emit(Rule::Arc, goal);
        }
        let cosine = if f == "arctan" { Relation::Greater } else { Relation::GreaterEqual };
        let three = quarter_turn(3);
        let parts = [
            turned_back(f, x, y),
            compare(y.clone(), Relation::Less, three.clone()),
            compare(y.clone(), Relation::Greater, negated(three)),
            compare(apply("cos", y.clone()), cosine, numeral(0)),
        ];
        for needed in parts {
            let label = self.without_cases(&needed)?;
            self.take_in(&label, &needed)?;
        }
        self.emit(Rule::Arc, goal)
    }

    /// Shows an order of an arc and y.
    fn beside_arc(&mut self, arc: &Expr, relation: Relation, y: &Expr) -> Result<Label, Fail> {
        let (f, x) = as_arc(arc).ok_or(Fail::No("an arc"))?;
        let other = match as_arc(y) {
            Some((g, other)) if f == g => other.clone(),
            // A number as the arc of its own sine or tangent.
            _ => {
                if !self.is_of_numbers(y) {
                    return Err(Fail::No("a number"));
                }
                let sine = apply("sin", y.clone());
                let written = if f == "arctan" { over(sine, apply("cos", y.clone())) } else { sine };
                let written = self.simplified(&written).ok_or(Fail::No("the tangent of a number"))?;
                let label = self.equal_to_arc(&apply(f, written.clone()), y)?;
                self.put_in(&label);
                written
            }
        };
        let needed = compare(x.clone(), relation, other.clone());
        let label = self.without_cases(&needed)?;
        self.take_in(&label, &needed)?;
        self.emit(Rule::Arc, compare(arc.clone(), relation, apply(f, other)))
    }
}
