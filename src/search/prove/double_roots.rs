//! Inequalities with equality at a stationary point: what is nowhere negative is (x − r)²·q there.
//!
//! Method: the roots r of the partial derivatives are found (`solved_equations`), also with radicals. The polynomial is divided by
//! x − r twice. The remainders are not looked at: whether (x − r)²·q is the polynomial, the kernel decides, which knows the powers
//! of roots. What is left to show is the sign of q, of a degree that is less by 2.

use super::facts::minus;
use super::letters::{product, whole_power};
use super::squares::{Open, own_relation};
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, numeral};
use malachite::Rational;
use malachite::base::num::basic::traits::One;

impl Prover {
    /// Shows a comparison whose sides meet at a stationary point of their difference.
    pub(super) fn by_double_root(
        &mut self,
        goal: &Prop,
        a: &Expr,
        relation: Relation,
        b: &Expr,
    ) -> Result<Label, Fail> {
        let no = || Fail::No("a double root");
        if !matches!(relation, Relation::LessEqual | Relation::GreaterEqual) {
            return Err(no());
        }
        let reading = self.read(&minus(a, b), true).ok_or_else(no)?;
        let open = Open::of(self, &reading).ok_or_else(no)?;
        let own = own_relation(open.signs, relation).ok_or_else(no)?;
        for v in open.poly.variables() {
            if open.poly.degree_in(v) < 3 || !matches!(self.letters.expr(v), Some(Expr { kind: ExprKind::Name(_), .. }))
            {
                continue;
            }
            for (above, below) in self.stationary_values(&open.poly, v) {
                let Some(quotient) = without_double_root(&open.poly, v, &above, &below) else { continue };
                let done = self.attempt(|c| {
                    let apart = below.mul(&Polynomial::variable(v)).sub(&above);
                    let factors = [whole_power(c.letters.written(&apart), 2), c.letters.written(&quotient)];
                    let mut rest = open.rest.clone();
                    rest.push(factors[0].clone());
                    // The kernel multiplies out what is to be shown equal before the sign of the quotient is sought.
                    let whole = product(factors.to_vec());
                    if !c.is_zero(&minus(&whole, &c.letters.written(&open.poly))) {
                        return Err(no());
                    }
                    let sign = c.without_cases(&compare(factors[1].clone(), own, numeral(0)))?;
                    c.combination(goal.clone(), vec![Term { facts: vec![sign], factor: product(rest) }])
                });
                if done.is_ok() {
                    return done;
                }
            }
        }
        Err(no())
    }
}

/// A polynomial divided by (below·v − above)²; the remainders are dropped where `below` is a number.
fn without_double_root(p: &Polynomial, v: u32, above: &Polynomial, below: &Polynomial) -> Option<Polynomial> {
    let Some(slope) = below.as_constant() else {
        let apart = below.mul(&Polynomial::variable(v)).sub(above);
        return p.exact_divide(&apart.pow(2).ok()?);
    };
    let root = above.scale(&(Rational::ONE / &slope));
    let mut coefficients = p.coefficients_in(v);
    for _ in 0..2 {
        // Horner's scheme.
        let mut carried = Polynomial::zero();
        for c in coefficients.iter_mut().rev() {
            carried = carried.try_mul(&root).ok()?.add(c);
            *c = carried.clone();
        }
        coefficients.remove(0);
    }
    Some(Polynomial::from_coefficients_in(v, &coefficients).scale(&(Rational::ONE / (&slope * &slope))))
}
