//! Conditions under which expressions have values, shown where the kernel does not see them itself.

use super::Prover;
use super::letters::natural;
use crate::claim::definedness::{Need, needs};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, numeral};

impl Prover {
    /// Proves the conditions under which an expression has a value, if the kernel does not see them itself.
    pub(crate) fn define(&mut self, e: &Expr) {
        match &e.kind {
            ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) | ExprKind::IntegralOver(index, _) => {
                self.define(&index.from);
                self.define(&index.to);
            }
            ExprKind::Derivative(body, _) => return self.define(body),
            _ => crate::claim::walk::parts(e, &mut |part| self.define(part)),
        }
        let naturals = self.naturals.clone();
        for need in needs(e, &|name| naturals.iter().any(|n| n == name)).into_iter().flatten() {
            let zero = numeral(0);
            match need {
                Need::NotZero(d) => self.nonzero(&d),
                Need::Positive(b) => self.sign(&b, Relation::Greater, &zero),
                Need::NotNegative(b) => {
                    // A root of something positive may be divided by. A square is positive where its base is not 0, which the kernel
                    // sees or not.
                    let reading = self.read(&b, false);
                    let is_square = reading.is_some_and(|r| r.number > 0 && r.factors.iter().all(|f| f.power % 2 == 0));
                    if !is_square {
                        self.sign(&b, Relation::Greater, &zero);
                    }
                    self.sign(&b, Relation::GreaterEqual, &zero);
                }
                Need::NotZeroOrNatural(b, k) => {
                    if !self.signs_of(&k).within(Signs::NOT_NEGATIVE) {
                        self.nonzero(&b);
                    }
                }
                Need::Range(from, to) => {
                    let next = expr(ExprKind::Sum(vec![(Sign::Plus, to), (Sign::Plus, numeral(1))]));
                    self.sign(&next, Relation::GreaterEqual, &from);
                }
                Need::Differentiable(..) => {}
            }
        }
    }

    fn sign(&mut self, e: &Expr, relation: Relation, bound: &Expr) {
        let seen = natural(bound) == Some(0) && self.signs_of(e).within(Signs::of(relation));
        if !seen {
            let sign = compare(e.clone(), relation, bound.clone());
            if self.quietly(&sign).is_err() && self.roots_in_full.is_some() {
                let _ = self.compared_in_full(&sign);
            }
        }
    }

    /// Shows that an expression is not 0, if little effort does.
    pub(super) fn nonzero(&mut self, e: &Expr) {
        if self.signs_of(e).within(Signs::NOT_ZERO) {
            return;
        }
        for relation in [Relation::Greater, Relation::Less, Relation::NotEqual] {
            if self.quietly(&compare(e.clone(), relation, numeral(0))).is_ok() {
                return;
            }
        }
    }
}
