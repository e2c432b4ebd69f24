//! What a limit is, where the bounds that a proof would use tell; nothing is proved here.

use super::asymptotic_bounds::Tends;
use super::letters::natural;
use super::{Prover, with_values_of_integrals};
use crate::algebra::Moment;
use crate::claim::syntax::*;
use crate::claim::walk::parts_mut;
use crate::kernel::statement::apply;
use crate::refute::catalogue::Limits;

/// The value that the limit of a claim seems to have, whatever the claim says of it.
pub(crate) fn value_of_limit(claim: &Claim, limits: &Limits) -> Option<Expr> {
    let PropKind::Limit(l) = &claim.goal.kind else { return None };
    let mut prover = Prover::new(claim, &[], limits, Moment::now().checked_add(limits.time)).ok()?;
    prover.define(&l.value);
    let mut value = prover.value_of(&l.of, &l.variable.text)?;
    exponentials_in(&mut value);
    Some(value)
}

/// Writes exp(1)^k as exp(k).
fn exponentials_in(e: &mut Expr) {
    parts_mut(e, &mut exponentials_in);
    if let ExprKind::Power(base, exponent) = &e.kind
        && let ExprKind::Apply(f, list) = &base.kind
        && f.text == "exp"
        && list.iter().all(|e| natural(e) == Some(1))
    {
        *e = apply("exp", (**exponent).clone());
    }
}

impl Prover {
    fn value_of(&mut self, e: &Expr, x: &str) -> Option<Expr> {
        let mut of = with_values_of_integrals(e);
        if let Ok((closed, _)) = self.with_closed_sums(&of, x) {
            of = closed;
        }
        // Powers of −1 and the like come to less; other powers are seen better as they are written.
        let plain = self.simplified(&of);
        [Some(of), plain].into_iter().flatten().find_map(|of| match self.tends(&of, x) {
            Tends::To(value) => self.simplified(&value),
            _ => self.limit_by_bounds(&of, x),
        })
    }
}
