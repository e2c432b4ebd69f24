//! Whole numbers that differ, because a divisor of all but one term does not divide that one: 2·j ≠ 2·k + 1.

use super::facts::minus;
use super::{Fail, Prover, implies};
use crate::algebra::Polynomial;
use crate::certificate::Label;
use crate::claim::definedness::is_whole;
use crate::claim::syntax::*;
use crate::kernel::statement::compare;
use crate::refute::literal::literal;
use malachite::base::num::arithmetic::traits::{Floor, Gcd};
use malachite::{Integer, Natural, Rational};

impl Prover {
    /// Shows `a != b` where a − b = g·w + c with whole numbers w and g, and g does not divide c: w is at most floor(−c/g), or at
    /// least one more.
    pub(crate) fn by_divisibility(&mut self, goal: &Prop, a: &Expr, b: &Expr) -> Result<Label, Fail> {
        let no = || Fail::No("a common divisor");
        let naturals = self.naturals.clone();
        let whole = |e: &Expr| is_whole(e, &|n| naturals.iter().any(|m| m == n));
        if !whole(a) || !whole(b) {
            return Err(no());
        }
        let poly = self.letters.polynomial(&minus(a, b)).ok_or_else(no)?;
        let rest = poly.constant_term();
        let others = poly.sub(&Polynomial::constant(rest.clone()));
        let divisor = others.terms().map(|(_, c)| c.numerator_ref().clone()).reduce(Natural::gcd).ok_or_else(no)?;
        let divisor = Rational::from(divisor);
        let place = -(rest / &divisor);
        let floor: Integer = (&place).floor();
        if place == floor || others.terms().any(|(_, c)| Integer::try_from(c.clone()).is_err()) {
            return Err(no());
        }
        let w = self.letters.written(&others.scale(&(Rational::from(1) / divisor)));
        let floor = literal(&Rational::from(floor));
        let mut cases = Vec::new();
        for relation in [Relation::LessEqual, Relation::Greater] {
            let case = implies(&compare(w.clone(), relation, floor.clone()), goal);
            cases.push(self.block(&case, |c, _| {
                c.splits = 9;
                c.show(goal)
            })?);
        }
        self.logic(&cases.iter().map(String::as_str).collect::<Vec<_>>(), goal)
    }
}
