//! Comparisons of one root with the rest, by their squares.

use super::facts::minus;
use super::letters::{product, whole_power};
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, numeral};
use crate::refute::search::literal;
use malachite::Rational;

impl Prover {
    /// Shows a comparison that is linear in a square root, r against e, from that of r² and e² where e is not negative.
    pub fn by_squares(&mut self, goal: &Prop, a: &Expr, relation: Relation, b: &Expr) -> Result<Label, Fail> {
        let no = || Fail::No("a root alone");
        let reading = self.read(&minus(a, b), true).ok_or_else(no)?;
        let mut rest = vec![literal(&reading.number)];
        let mut signs = super::facts::sign_of(&reading.number);
        let mut open = None;
        for f in &reading.factors {
            match f.power {
                1 if open.is_none() && !super::facts::is_settled(f.signs) => open = Some(f.poly.clone()),
                _ => {
                    signs = signs.times(f.signs.power(f.power));
                    rest.push(whole_power(self.letters.written(&f.poly), f.power));
                }
            }
        }
        let poly: Polynomial = open.ok_or_else(no)?;
        let mut last = Err(no());
        for v in poly.variables() {
            let Some(root) = self.letters.expr(v).cloned() else { continue };
            let ExprKind::Power(base, exponent) = &root.kind else { continue };
            let is_half = self
                .read(exponent, false)
                .is_some_and(|r| r.factors.is_empty() && r.number == Rational::from(1) / Rational::from(2));
            let parts = poly.coefficients_in(v);
            let [constant, slope] = parts.as_slice() else { continue };
            if !is_half {
                continue;
            }
            let slope_expr = self.letters.written(slope);
            // a − b = rest·slope·(root − e).
            let sign = signs.times(self.signs_of(&slope_expr));
            let all = [Relation::Less, Relation::LessEqual, Relation::Greater, Relation::GreaterEqual];
            let Some(own) = all
                .into_iter()
                .find(|r| super::facts::is_settled(sign) && sign.times(Signs::of(*r)) == Signs::of(relation))
            else {
                continue;
            };
            let e = expr(ExprKind::Product(vec![
                (Factor::Times, self.letters.written(&constant.neg())),
                (Factor::Over, slope_expr.clone()),
            ]));
            let mut factors = rest.clone();
            factors.push(slope_expr);
            let (base, exponent) = ((**base).clone(), (**exponent).clone());
            last = self.attempt(|c| {
                c.show(&compare(e.clone(), Relation::GreaterEqual, numeral(0)))?;
                let square = whole_power(e.clone(), 2);
                let from = c.show(&compare(base.clone(), own, square.clone()))?;
                let even = expr(ExprKind::Power(Box::new(square), Box::new(exponent)));
                let roots = c.emit(Rule::Monotone { from }, compare(root.clone(), own, even.clone()))?;
                let same = c.emit(Rule::Power, compare(even, Relation::Equal, e.clone()))?;
                let factor = product(factors);
                let terms = [roots, same].map(|label| Term { facts: vec![label], factor: factor.clone() });
                c.combination(goal.clone(), terms.to_vec())
            });
            if last.is_ok() {
                break;
            }
        }
        last
    }
}
