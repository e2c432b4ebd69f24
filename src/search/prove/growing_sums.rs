//! Sums that grow beyond all bounds: 1/S tends to 0 because S is at least a simpler expression that grows.
//!
//! Method: of members that fall each is at least the last, so the sum from 1 to n is at least n times that; the sum of 1/k is at
//! least ln(n + 1). Both are shown by induction.

use super::letters::product;
use super::limits::{over, plus};
use super::slopes::put_in;
use super::{Fail, Prover};
use crate::certificate::Label;
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, compare, name, numeral, prop};

impl Prover {
    /// Shows that the inverse of a sum up to the variable tends to 0.
    pub(super) fn by_a_growing_sum(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        let no = || Fail::No("the inverse of a sum");
        let ExprKind::Product(list) = &l.of.kind else { return Err(no()) };
        let [(Factor::Times, top), (Factor::Over, sum)] = list.as_slice() else { return Err(no()) };
        let ExprKind::SumOver(index, body) = &sum.kind else { return Err(no()) };
        let x = &l.variable.text;
        let is_end = matches!(&index.to.kind, ExprKind::Name(n) if n == x);
        if !is_end || !self.is_one(top) || !self.is_zero(&l.value) || !self.is_one(&index.from) {
            return Err(no());
        }
        let n = name(x);
        let last = put_in(body, &index.name.text, &n)?;
        for least in [product(vec![n.clone(), last]), apply("ln", plus(&n, numeral(1)))] {
            let least = self.simplified(&least).unwrap_or(least);
            if let Ok(label) = self.attempt(|c| c.by_a_lower_bound(goal, l, sum, &least)) {
                return Ok(label);
            }
        }
        Err(no())
    }

    fn by_a_lower_bound(&mut self, goal: &Prop, l: &Limit, sum: &Expr, least: &Expr) -> Result<Label, Fail> {
        let upper = over(numeral(1), least.clone());
        // Whether it grows is seen sooner than whether it is a bound.
        self.show(&prop(PropKind::Limit(Box::new(Limit { of: upper.clone(), ..l.clone() }))))?;
        let k = self.fresh("k");
        let at = |e: &Expr| put_in(e, &l.variable.text, &name(&k));
        let body = compare(at(least)?, Relation::LessEqual, at(sum)?);
        let every = prop(PropKind::ForAll(vec![self.growing_from(&numeral(1), l, &k)], Box::new(body)));
        let splits = std::mem::replace(&mut self.splits, 0);
        let shown = self.on_its_own(|c| c.all_by_induction(&every, 0));
        self.splits = splits;
        self.between(goal, l, (&numeral(0), &upper), &[shown?], 1)
    }
}
