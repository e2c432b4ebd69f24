//! What a limit is, where the bounds that a proof would use tell; nothing is proved here.

use super::asymptotic_bounds::Tends;
use super::asymptotic_form::{Leading, atoms};
use super::asymptotic_limits::{ORDERS, ROOTS};
use super::facts::minus;
use super::letters::natural;
use super::{Prover, with_values_of_integrals};
use crate::algebra::Moment;
use crate::claim::syntax::*;
use crate::claim::walk::parts_mut;
use crate::kernel::statement::{apply, numeral};
use crate::refute::catalogue::Limits;
use crate::refute::literal::literal;

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
            _ => {
                let apart = self.apart_from_signs(&of, x).ok()?;
                self.told_limit(&apart.of, x)
            }
        })
    }

    /// The limit of an expression as x grows, if bounds tell one, or else an expansion.
    pub(super) fn told_limit(&mut self, e: &Expr, x: &str) -> Option<Expr> {
        if let Some(limit) = self.finite_limit(e, x) {
            return Some(limit);
        }
        let limit = match self.first_term(e, x)? {
            (..0, _) => return None,
            (0, c) => c,
            (1.., _) => numeral(0),
        };
        self.value_written(limit)
    }

    fn value_written(&mut self, value: Expr) -> Option<Expr> {
        match self.letters.number(&value) {
            Some(q) => Some(literal(&q)),
            None => Some(self.simplified(&value).unwrap_or(value)),
        }
    }

    /// The limit of an expression as x grows, if bounds tell one.
    pub(super) fn finite_limit(&mut self, e: &Expr, x: &str) -> Option<Expr> {
        let limit = self.by_bounds(e, x, &mut |c, lower, upper| {
            let (Tends::To(a), Tends::To(b)) = (c.tends(lower, x), c.tends(upper, x)) else { return None };
            c.is_zero(&minus(&a, &b)).then_some(a)
        })?;
        self.value_written(limit)
    }

    /// The leading term of an expression as x grows, if bounds tell one other than 0.
    pub(super) fn leading_limit(&mut self, e: &Expr, x: &str) -> Option<Leading> {
        let lead = self.by_bounds(e, x, &mut |c, lower, upper| {
            let (a, b) = (c.leading(lower, x)?, c.leading(upper, x)?);
            let same = a.exponent == b.exponent && !c.is_zero(&a.c) && c.is_zero(&minus(&a.c, &b.c));
            same.then_some(a)
        })?;
        let c = match self.letters.number(&lead.c) {
            Some(q) => literal(&q),
            None => self.simplified(&lead.c)?,
        };
        Some(Leading { c, exponent: lead.exponent })
    }

    /// What the first bounds of an expression tell that tell something.
    fn by_bounds<T>(
        &mut self,
        e: &Expr,
        x: &str,
        told: &mut dyn FnMut(&mut Prover, &Expr, &Expr) -> Option<T>,
    ) -> Option<T> {
        let form = self.written_by(e, x, &mut Vec::new())?;
        let mut found = Vec::new();
        atoms(&form, x, &mut found)?;
        if found.is_empty() {
            return told(self, &form, &form);
        }
        for degree in ORDERS {
            for root in ROOTS {
                self.tick().ok()?;
                let mut plan = self.plan(x, degree, root, &[]);
                if let Some([Some(lower), Some(upper)]) = self.bounds_of(&form, &mut plan)
                    && let Some(told) = told(self, &lower.value, &upper.value)
                {
                    return Some(told);
                }
                if !plan.has_logarithm() {
                    break;
                }
            }
        }
        None
    }
}
