//! Comparisons of a power whose exponent is a variable, by the roots of both sides: (2/(1 + R^(1/n)))^n <= 1/sqrt(R) by
//! 2/(1 + R^(1/n)) <= (1/sqrt(R))^(1/n).
//!
//! Method: for E > 0 and sides that are not negative, a^E has the order to b that a has to b^(1/E).
//!
//! Certificate: the comparison of the roots, raised to E by the rule `monotone`, and (b^(1/E))^E = b by the rule `power`.

use super::comparison::single;
use super::facts::scaled;
use super::limits::over;
use super::{Fail, Prover};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral, power};

impl Prover {
    /// Shows an order between a power to a natural variable and another side. A root has no such exponent, so that this ends.
    pub(super) fn by_roots_of_sides(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("a power to a variable");
        if self.in_bernoulli || matches!(relation, Relation::Equal | Relation::NotEqual) {
            return Err(no());
        }
        for (side, other, is_left) in [(a, b, true), (b, a, false)] {
            let ExprKind::Power(base, exponent) = &side.kind else { continue };
            let varies = crate::claim::definedness::number(exponent).is_none() && self.is_whole(exponent);
            if !varies || !self.signs_of(exponent).within(Signs::POSITIVE) {
                continue;
            }
            let root = power(other, &over(numeral(1), exponent.as_ref().clone()));
            let ordered = |x: &Expr, y: &Expr, r: Relation| {
                let (x, y) = if is_left { (x, y) } else { (y, x) };
                compare(x.clone(), r, y.clone())
            };
            let Ok(rooted) = self.show(&ordered(base, &root, relation)) else { continue };
            let back = power(&root, exponent);
            let raised = self.emit(Rule::Monotone { from: rooted }, ordered(side, &back, relation))?;
            let same = self.plainly(Rule::Power, &ordered(&back, other, Relation::Equal))?;
            return self.combination(goal.clone(), vec![scaled(&raised, numeral(1)), scaled(&same, numeral(1))]);
        }
        Err(no())
    }
}
