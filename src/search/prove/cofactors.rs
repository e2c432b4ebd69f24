//! Equations from a multiple that is 0: p = 0 from h·p = 0 and h != 0.

use super::letters::{product, whole_power};
use super::products::{Kind, Known};
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use malachite::Rational;
use malachite::base::num::basic::traits::One;

impl Prover {
    /// Proves an equation p = 0 from p·h = 0 and h != 0, for p linear in some variable. The kernel decides whether p·h is the
    /// expression known to be 0, since it knows the powers of roots.
    fn by_cofactor(&mut self, goal: &Prop, p: &Polynomial, zero: &Known, rest: &[Expr]) -> Result<Label, Fail> {
        for v in p.variables() {
            let Some(Quotient { cofactor, scale }) = quotient_in(v, p, &zero.poly)? else { continue };
            let e = self.letters.written(&cofactor);
            if cofactor.is_constant() {
                continue;
            }
            let mut terms = Vec::new();
            if !self.signs_of(&e).within(Signs::NOT_ZERO) {
                continue;
            }
            let mut factors = rest.to_vec();
            factors.push(whole_power(e, -1));
            factors.extend(scale.map(|scale| self.letters.written(&scale)));
            factors.extend(zero.factors.iter().cloned());
            terms.push(Term { facts: zero.facts.clone(), factor: product(factors) });
            if let Ok(label) = self.combination(goal.clone(), terms) {
                return Ok(label);
            }
        }
        Err(Fail::No("a cofactor"))
    }

    /// Proves an equation p = 0 from the first of the facts about what is 0 that gives it.
    pub(super) fn by_cofactors(
        &mut self,
        goal: &Prop,
        p: &Polynomial,
        columns: &[Known],
        rest: &[Expr],
    ) -> Result<Label, Fail> {
        let mut zeros = columns.iter().filter(|k| k.kind == Kind::Zero && k.order == 1);
        let shown = zeros.find_map(|known| self.attempt(|c| c.by_cofactor(goal, p, known, rest)).ok());
        shown.ok_or(Fail::No("a cofactor"))
    }
}

/// The quotient of a polynomial by another: scale·q = cofactor·p and a rest that does not hold the variable. No scale is 1.
struct Quotient {
    cofactor: Polynomial,
    scale: Option<Polynomial>,
}

/// The quotient of q by p, where p = slope·v + constant for a variable v, and q has a higher degree d in it.
///
/// With w = slope·v: slope^d·q is a polynomial in w, and Horner's scheme at w = −constant divides it by w + constant. A slope that
/// is a number is divided by.
fn quotient_in(v: u32, p: &Polynomial, q: &Polynomial) -> Result<Option<Quotient>, Fail> {
    let parts = p.coefficients_in(v);
    let ([constant, slope], true) = (parts.as_slice(), q.degree_in(v) > 1) else { return Ok(None) };
    let times = |a: &Polynomial, b: &Polynomial| a.try_mul(b).map_err(|_| Fail::No("a product"));
    let number = slope.as_constant().map(|slope| Rational::ONE / slope);
    let (root, base) = match &number {
        Some(inverse) => (constant.scale(&-inverse.clone()), Polynomial::one()),
        None => (constant.neg(), slope.clone()),
    };
    let (mut scale, mut carried, mut quotient) = (Polynomial::one(), Polynomial::zero(), Vec::new());
    for (k, c) in q.coefficients_in(v).iter().rev().enumerate() {
        scale = if k == 0 { scale } else { times(&scale, &base)? };
        carried = times(&carried, &root)?.add(&times(c, &scale)?);
        quotient.push(carried.clone());
    }
    quotient.pop();
    quotient.reverse();
    let mut power = Polynomial::one();
    for c in &mut quotient {
        *c = times(c, &power)?;
        power = times(&power, &base)?;
    }
    let cofactor = Polynomial::from_coefficients_in(v, &quotient);
    Ok(Some(match number {
        Some(inverse) => Quotient { cofactor: cofactor.scale(&inverse), scale: None },
        None => Quotient { cofactor, scale: Some(scale) },
    }))
}
