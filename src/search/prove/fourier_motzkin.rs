//! Inequalities from a fact that is linear in the same unknown: the unknown is eliminated, with polynomials as coefficients.
//!
//! Method (Fourier and Motzkin; Schrijver, "Theory of Linear and Integer Programming", section 12.2): the goal says T > 0 or
//! T >= 0, a fact says so of K, and both are linear in an unknown y with the coefficients g and h. Then h·T = g·K + r without y in r,
//! so T = (g/h)·K + r/h, where g/h is not negative and r/h has the sign of the goal. An unknown is a letter, or a product of letters
//! that are no variables: in the step of an induction a power, a sum or a product, and K is the hypothesis.
//!
//! Limits: [`PAIRS`].

use super::comparison::OpenFactors;
use super::letters::{product, whole_power};
use super::products::{Kind, Known};
use super::{Fail, Prover};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};
use crate::refute::literal::literal;
use malachite::Rational;

/// The most pairs of an unknown and a fact that are tried for one goal.
const PAIRS: usize = 6;

/// What is left of a goal T without an unknown: T = (outer/inner)·K + left/inner.
struct Eliminated {
    outer: Polynomial,
    inner: Polynomial,
    left: Polynomial,
}

impl Prover {
    /// Shows an inequality from a fact that is linear in the same unknown.
    pub(super) fn by_linear_unknown(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("an unknown to eliminate");
        let PropKind::Compare(_, relations) = &goal.kind else { return Err(no()) };
        if matches!(relations[0], Relation::Equal | Relation::NotEqual) {
            return Err(no());
        }
        let OpenFactors { poly, rest, flip, .. } = self.open_factors(goal, 1)?;
        let target = if flip { poly.neg() } else { poly.clone() };
        let strict = matches!(relations[0], Relation::Less | Relation::Greater);
        let columns = self.columns(std::slice::from_ref(&poly), 0);
        let facts: Vec<&Known> = columns.iter().filter(|k| k.order == 1).collect();
        let unknowns = self.unknowns(&target);
        let pairs = unknowns.iter().flat_map(|y| facts.iter().rev().map(move |k| (y, *k)));
        let pairs: Vec<(Eliminated, &Known)> =
            pairs.filter_map(|(y, k)| Some((without(y, &target, &k.poly)?, k))).take(PAIRS).collect();
        let mut shown = pairs
            .iter()
            .map(|(parts, known)| self.attempt(|c| c.by_eliminated(goal, parts, known, (&rest, flip), strict)));
        shown.find(Result::is_ok).unwrap_or_else(|| Err(no()))
    }

    /// What may be eliminated from a polynomial: of each monomial the part of letters that are no variables, then each variable.
    fn unknowns(&self, p: &Polynomial) -> Vec<Monomial> {
        let is_variable = |v: u32| self.letters.expr(v).is_none_or(|e| matches!(e.kind, ExprKind::Name(_)));
        let mut out: Vec<Monomial> = Vec::new();
        for (monomial, _) in p.terms() {
            let part = monomial.powers().iter().filter(|(v, _)| is_variable(*v));
            let part = part.fold(monomial.clone(), |m, (v, _)| m.without(*v).0);
            if !part.is_one() && !out.contains(&part) {
                out.push(part);
            }
        }
        out.extend(p.variables().into_iter().filter(|v| is_variable(*v)).map(Monomial::variable));
        out
    }

    fn by_eliminated(
        &mut self,
        goal: &Prop,
        parts: &Eliminated,
        known: &Known,
        (rest, flip): (&[Expr], bool),
        strict: bool,
    ) -> Result<Label, Fail> {
        let [outer, inner] = [&parts.outer, &parts.inner].map(|p| self.letters.written(p));
        let up = self.has_sign(&inner, Relation::Greater, Relation::Less).ok_or(Fail::No("the sign of a divisor"))?;
        if known.kind != Kind::Zero && self.has_sign(&outer, Relation::GreaterEqual, Relation::LessEqual) != Some(up) {
            return Err(Fail::No("the sign of a factor"));
        }
        let left = self.letters.written(&if up { parts.left.clone() } else { parts.left.neg() });
        // A strict fact times a factor that is not 0 is strict already.
        let by_fact = known.kind == Kind::Strict && self.has_sign(&outer, Relation::Greater, Relation::Less).is_some();
        let relation = if strict && !by_fact { Relation::Greater } else { Relation::GreaterEqual };
        let remains = self.quietly(&compare(left, relation, numeral(0)))?;
        let sign = |negative: bool| literal(&Rational::from(if negative { -1 } else { 1 }));
        let times = |more: Vec<Expr>| {
            product(rest.iter().cloned().chain(more).chain([whole_power(inner.clone(), -1)]).collect())
        };
        let from_fact = times([sign(flip), outer].into_iter().chain(known.factors.iter().cloned()).collect());
        let terms = vec![
            Term { facts: known.facts.clone(), factor: from_fact },
            Term { facts: vec![remains], factor: times(vec![sign(flip == up)]) },
        ];
        self.combination(goal.clone(), terms)
    }

    /// Whether an expression is above 0, or below, with little effort; `None` if neither is seen.
    fn has_sign(&mut self, e: &Expr, above: Relation, below: Relation) -> Option<bool> {
        [(above, true), (below, false)].into_iter().find_map(|(relation, up)| {
            let seen = self.signs_of(e).within(Signs::of(relation));
            (seen || self.quietly(&compare(e.clone(), relation, numeral(0))).is_ok()).then_some(up)
        })
    }
}

/// Eliminates an unknown from T by K, if both are linear in it and a coefficient is no number: what linear programs do not try.
fn without(y: &Monomial, target: &Polynomial, known: &Polynomial) -> Option<Eliminated> {
    let (outer, inner) = (coefficient(y, target)?, coefficient(y, known)?);
    if outer.is_constant() && inner.is_constant() {
        return None;
    }
    let left = inner.try_mul(target).ok()?.sub(&outer.try_mul(known).ok()?);
    Some(Eliminated { outer, inner, left })
}

/// The coefficient of an unknown y in a polynomial g·y + r, where the letters of y are neither in g nor in r; `None` if it is not so.
fn coefficient(y: &Monomial, p: &Polynomial) -> Option<Polynomial> {
    let apart = |m: &Monomial| y.powers().iter().all(|(v, _)| m.exponent(*v) == 0);
    let mut terms = Vec::new();
    for (monomial, c) in p.terms().filter(|(m, _)| !apart(m)) {
        terms.push((monomial.checked_div(y).filter(apart)?, c.clone()));
    }
    (!terms.is_empty()).then(|| Polynomial::from_terms(terms))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    #[test]
    fn what_is_left_is_without_the_unknown() {
        let [x, y, z] = [0, 1, 2].map(Polynomial::variable);
        let unknown = Monomial::new(&[(1, 1), (2, 1)]).unwrap();
        // T = x·y·z + 1, K = 3 − (x + 1)·y·z
        let yz = y.mul(&z);
        let target = x.mul(&yz).add(&Polynomial::one());
        let known = Polynomial::integer(3).sub(&x.add(&Polynomial::one()).mul(&yz));
        let parts = without(&unknown, &target, &known).unwrap();
        assert_eq!(parts.inner.mul(&target), parts.outer.mul(&known).add(&parts.left));
        assert!(!parts.left.contains(1) && !parts.left.contains(2));
        // Beside y alone y·z is no unknown.
        assert!(coefficient(&unknown, &target.add(&y)).is_none());
    }
}
