//! Polynomial inequalities made homogeneous by a hypothesis: where a·b + b·c + c·a = a·b·c·(a + b + c), a polynomial with terms of
//! degrees 4 and 6 has the sign of a form of degree 8; where a² + b² + c² >= 1, a form that is not less than a² + b² + c² is not less than 1.
//!
//! Method (the normalisation of G. Hardy, J. Littlewood, G. Pólya, "Inequalities", 1934, 1.4): let H and L be forms of degrees D > d
//! with L > 0, and H = L by hypothesis. A polynomial p with parts of degree e, all in one class modulo D − d, then has
//! L^K·p = Σ p_e·H^j·L^(K − j), where (D − d)·j is what e lacks. The two sides differ by a multiple of H − L. Where H >= L is all
//! that is known, the multiplier must not be negative.
//!
//! Certificate: the inequality of the form, and a combination with L^K as its multiplier.
//!
//! Limits: [`DEGREE`], [`TERMS`], [`HYPOTHESES`].

use super::facts::{negated, scaled};
use super::letters::{product, whole_power};
use super::products::{Kind, Known};
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};
use malachite::Rational;
use malachite::base::num::basic::traits::One;

/// The highest degree of the form, and its most terms.
const DEGREE: u32 = 24;
const TERMS: usize = 300;

/// The most hypotheses that are tried.
const HYPOTHESES: usize = 4;

/// A form that has the sign of a polynomial p: L^K·p = form + multiplier·hypothesis.
struct Made {
    form: Polynomial,
    lower: Polynomial,
    power: u32,
    multiplier: Polynomial,
}

impl Prover {
    /// Shows an order of polynomials by that of a form.
    pub(super) fn by_homogeneous(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a hypothesis that makes the goal homogeneous");
        let PropKind::Compare(_, relations) = &goal.kind else { return Err(no()) };
        let open = self.open_factors(goal, 1)?;
        let target = if open.flip { open.poly.neg() } else { open.poly.clone() };
        // The degree of a root is no whole number.
        let named = |c: &Prover, p: &Polynomial| {
            p.variables().iter().all(|v| matches!(c.letters.expr(*v).map(|e| &e.kind), Some(ExprKind::Name(_))))
        };
        if parts(&target).len() < 2 || !named(self, &target) {
            return Err(no());
        }
        let strict = matches!(relations[0], Relation::Greater | Relation::Less);
        let order = if strict { Relation::Greater } else { Relation::GreaterEqual };
        let mut last = Err(no());
        let mut known: Vec<Known> = self.all_known(&[]);
        known.retain(|k| parts(&k.poly).len() == 2 && named(self, &k.poly));
        for fact in known.iter().take(HYPOTHESES) {
            let Some(made) = self.made_homogeneous_by(&target, fact) else { continue };
            last = self.attempt(|c| {
                let shown = c.without_roots(&compare(c.letters.written(&made.form), order, numeral(0)))?;
                let sign = |e: Expr| if open.flip { negated(e) } else { e };
                let rest = || open.rest.iter().cloned();
                let multiplier = sign(c.letters.written(&made.multiplier));
                let factors = [multiplier].into_iter().chain(rest()).chain(fact.factors.iter().cloned());
                let terms = vec![
                    scaled(&shown, product([sign(numeral(1))].into_iter().chain(rest()).collect())),
                    Term { facts: fact.facts.clone(), factor: product(factors.collect()) },
                ];
                let times = whole_power(c.letters.written(&made.lower), i64::from(made.power));
                let times = (!made.lower.is_one()).then_some(times);
                c.emit(Rule::Combination { times, terms }, goal.clone())
            });
            if last.is_ok() {
                break;
            }
        }
        last
    }

    fn made_homogeneous_by(&mut self, p: &Polynomial, fact: &Known) -> Option<Made> {
        let hypothesis = parts(&fact.poly);
        let [(d, lower), (top, higher)] = hypothesis.as_slice() else { return None };
        // H − L, or L − H.
        let (lower, higher) = match self.signs_of(&self.letters.written(lower)) {
            signs if signs.within(Signs::POSITIVE) => (lower.clone(), higher.neg()),
            signs if signs.within(Signs::of(Relation::Less)) => (lower.neg(), higher.clone()),
            _ => return None,
        };
        let scale = lower.as_constant().map_or(Rational::ONE, |c| Rational::ONE / c);
        let (lower, higher) = (lower.scale(&scale), higher.scale(&scale));
        let own = parts(p);
        let most = own.last()?.0;
        if own.iter().any(|(e, _)| (most - e) % (top - d) != 0) {
            return None;
        }
        let steps = |e: u32| (most - e) / (top - d);
        let power = steps(own.first()?.0);
        if most + power * d > DEGREE {
            return None;
        }
        let mut form = Polynomial::zero();
        for (e, part) in &own {
            let factor = higher.pow(steps(*e)).ok()?.try_mul(&lower.pow(power - steps(*e)).ok()?).ok()?;
            form = form.add(&part.try_mul(&factor).ok()?);
        }
        let left = p.try_mul(&lower.pow(power).ok()?).ok()?.sub(&form);
        let multiplier = left.exact_divide(&fact.poly).filter(|_| form.term_count() <= TERMS)?;
        let holds =
            fact.kind == Kind::Zero || self.signs_of(&self.letters.written(&multiplier)).within(Signs::NOT_NEGATIVE);
        holds.then_some(Made { form, lower, power, multiplier })
    }
}

/// The homogeneous parts of a polynomial, with their degrees from the lowest.
fn parts(p: &Polynomial) -> Vec<(u32, Polynomial)> {
    let mut out: std::collections::BTreeMap<u32, Polynomial> = std::collections::BTreeMap::new();
    for (m, c) in p.terms() {
        let part = out.entry(m.degree()).or_insert_with(Polynomial::zero);
        *part = part.add(&Polynomial::term(m.clone(), c.clone()));
    }
    out.into_iter().collect()
}
