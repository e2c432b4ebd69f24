//! Quadratics with a positive leading coefficient, by a square that is completed: L·v² + M·v + N is
//! ((2·L·v + M)² + (4·L·N − M²))/(4·L).

use super::letters::{product, whole_power};
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};
use crate::refute::literal::literal;
use malachite::Rational;

impl Prover {
    /// The sign of L·v² + M·v + N for a positive polynomial L.
    pub(super) fn by_completed_square(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a square to complete");
        let open = self.open_factors(goal, 0)?;
        let PropKind::Compare(_, relations) = &goal.kind else { return Err(no()) };
        let strict = matches!(relations[0], Relation::Greater | Relation::Less);
        let target = if open.flip { open.poly.neg() } else { open.poly };
        for v in target.variables() {
            let [constant, linear, lead] = &target.coefficients_in(v)[..] else { continue };
            let written = self.letters.written(lead);
            if lead.is_constant() || !self.signs_of(&written).within(Signs::POSITIVE) {
                continue;
            }
            let four = Rational::from(4);
            let Ok(product_of_ends) = lead.try_mul(constant) else { continue };
            let Ok(square) = linear.pow(2) else { continue };
            let gap = product_of_ends.scale(&four).sub(&square);
            let root = lead.scale(&Rational::from(2)).mul(&Polynomial::variable(v)).add(linear);
            let mut rest = open.rest.clone();
            let quarter = Rational::from(if open.flip { -1 } else { 1 }) / &four;
            rest.extend([literal(&quarter), whole_power(written, -1)]);
            let with = |e: Expr| product(std::iter::once(e).chain(rest.iter().cloned()).collect());
            let squared = with(whole_power(self.letters.written(&root), 2));
            let mut terms = vec![Term { facts: Vec::new(), factor: squared }];
            if !gap.is_zero() {
                let relation = if strict { Relation::Greater } else { Relation::GreaterEqual };
                let shown = compare(self.letters.written(&gap), relation, numeral(0));
                let Ok(label) = self.quietly(&shown) else { continue };
                terms.push(Term { facts: vec![label], factor: with(numeral(1)) });
            }
            if let Ok(label) = self.combination(goal.clone(), terms) {
                return Ok(label);
            }
        }
        Err(no())
    }
}
