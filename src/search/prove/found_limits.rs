//! What a limit is, where the bounds that a proof would use tell; nothing is proved here.

use super::asymptotic_bounds::Tends;
use super::{Prover, with_values_of_integrals};
use crate::algebra::Moment;
use crate::claim::syntax::*;
use crate::refute::catalogue::Limits;

/// The value that the limit of a claim seems to have, whatever the claim says of it.
pub(crate) fn value_of_limit(claim: &Claim, limits: &Limits) -> Option<Expr> {
    let PropKind::Limit(l) = &claim.goal.kind else { return None };
    let mut prover = Prover::new(claim, &[], limits, Moment::now().checked_add(limits.time)).ok()?;
    prover.define(&l.value);
    prover.value_of(&l.of, &l.variable.text)
}

impl Prover {
    fn value_of(&mut self, e: &Expr, x: &str) -> Option<Expr> {
        let mut of = with_values_of_integrals(e);
        if let Ok((closed, _)) = self.with_closed_sums(&of, x) {
            of = closed;
        }
        // Powers of −1 and the like come to less.
        of = self.simplified(&of).unwrap_or(of);
        match self.tends(&of, x) {
            Tends::To(value) => self.simplified(&value),
            _ => self.limit_by_bounds(&of, x),
        }
    }
}
