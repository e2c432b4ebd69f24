//! Equations from equations: ideal membership, each element of the basis that is needed a step of its own.
//!
//! Method: Buchberger's algorithm modulo a prime, the needed steps made again over the rationals (`algebra::ideal`). What is known not
//! to be 0 may be divided by: its inverse t gets a name, and t·d = 1 is one more equation (Rabinowitsch; Cox, Little, O'Shea,
//! "Ideals, Varieties, and Algorithms", chapter 4, §2).
//!
//! Limits: [`EQUATIONS`], [`INVERSES`], [`WORK`] and those of `algebra::ideal`; beyond them there is no answer.

use super::letters::product;
use super::products::{Kind, Known};
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::algebra::ideal::{Derivation, derivation};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, name, numeral};
use std::rc::Rc;

/// The most equations that are taken.
const EQUATIONS: usize = 24;

/// The most polynomials that are divided by.
const INVERSES: usize = 4;

/// The most terms that are taken from others for one derivation, modulo the prime.
const WORK: usize = 400_000;

/// The same for all derivations of one goal.
pub(super) const ALL_WORK: usize = 1_600_000;

/// An equation p = 0: p is the product of these facts' differences and factors.
struct Zero {
    poly: Polynomial,
    facts: Vec<Label>,
    factors: Vec<Expr>,
}

impl Zero {
    /// It times a factor, as a term of a combination.
    fn times(&self, factor: Expr, rest: &[Expr]) -> Term {
        let mut factors = vec![factor];
        factors.extend(rest.iter().chain(&self.factors).cloned());
        Term { facts: self.facts.clone(), factor: product(factors) }
    }
}

impl Prover {
    /// Shows an equation by equations among the facts.
    pub(super) fn by_ideal(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("an equation from equations");
        let open = self.open_factors(goal, 1)?;
        let letters = open.poly.variables();
        let known = self.all_known(std::slice::from_ref(&open.poly));
        let shares = |k: &&Known| k.poly.variables().iter().any(|v| letters.contains(v));
        let mut zeros: Vec<&Known> = known.iter().filter(|k| k.kind == Kind::Zero && !k.poly.is_zero()).collect();
        zeros.sort_by_key(|k| !shares(k));
        zeros.truncate(EQUATIONS);
        if zeros.is_empty() || open.poly.is_constant() {
            return Err(no());
        }
        let mut zeros: Vec<Zero> = zeros
            .into_iter()
            .map(|k| Zero { poly: k.poly.clone(), facts: k.facts.clone(), factors: k.factors.clone() })
            .collect();
        let equations = |zeros: &[Zero]| zeros.iter().map(|z| z.poly.clone()).collect::<Vec<_>>();
        if let Some(found) = self.within_ideal(&open.poly, equations(&zeros)) {
            return self.derived(goal, zeros, &open.rest, found);
        }
        let divisors = self.not_zero();
        if divisors.is_empty() {
            return Err(no());
        }
        for d in divisors {
            zeros.push(self.inverse(&d)?);
        }
        let found = self.within_ideal(&open.poly, equations(&zeros)).ok_or_else(no)?;
        self.derived(goal, zeros, &open.rest, found)
    }

    /// A derivation of a polynomial from equations; what was not found once is not sought again.
    fn within_ideal(&mut self, goal: &Polynomial, equations: Vec<Polynomial>) -> Option<Derivation> {
        let question = (goal.clone(), equations);
        if self.outside.contains(&question) {
            return None;
        }
        let mut work = self.ideal_work.min(WORK);
        let before = work;
        let found = derivation(&question.0, &question.1, &mut work);
        self.ideal_work -= before - work;
        if found.is_none() {
            self.outside.insert(question);
        }
        found
    }

    /// Writes a derivation as steps: each element that is 0, then the goal.
    fn derived(&mut self, goal: &Prop, mut zeros: Vec<Zero>, rest: &[Expr], found: Derivation) -> Result<Label, Fail> {
        let terms = |c: &Prover, zeros: &[Zero], parts: &[(usize, Polynomial)], rest: &[Expr]| {
            let term = |(k, q): &(usize, Polynomial)| Some(zeros.get(*k)?.times(c.letters.written(q), rest));
            parts.iter().map(term).collect::<Option<Vec<_>>>().ok_or(Fail::No("an element"))
        };
        for step in found.steps {
            let shown = compare(self.letters.written(&step.poly), Relation::Equal, numeral(0));
            let terms = terms(self, &zeros, &step.parts, &[])?;
            let label = self.identity(shown, terms)?;
            zeros.push(Zero { poly: step.poly, facts: vec![label], factors: Vec::new() });
        }
        let terms = terms(self, &zeros, &found.goal, rest)?;
        self.identity(goal.clone(), terms)
    }

    /// A name t for 1/d, with t·d − 1 = 0.
    fn inverse(&mut self, d: &Polynomial) -> Result<Zero, Fail> {
        let fresh = name(&self.fresh("t"));
        let d_written = self.letters.written(d);
        let inverse = super::letters::whole_power(d_written.clone(), -1);
        let named = self.emit(Rule::Name, compare(inverse, Relation::Equal, fresh.clone()))?;
        let t = Polynomial::variable(self.letters.of(&fresh));
        let poly = t.try_mul(d).map_err(|_| Fail::No("a product"))?.sub(&Polynomial::one());
        // (1/d − t)·(−d) = t·d − 1.
        let factor = self.letters.written(&d.neg());
        let shown = compare(self.letters.written(&poly), Relation::Equal, numeral(0));
        let label = self.identity(shown, vec![Term { facts: vec![named], factor }])?;
        Ok(Zero { poly, facts: vec![label], factors: Vec::new() })
    }

    /// Polynomials that facts say are not 0.
    fn not_zero(&mut self) -> Vec<Polynomial> {
        let facts: Vec<Rc<Prop>> = self.checker.facts().map(|f| f.1.clone()).collect();
        let mut out: Vec<Polynomial> = Vec::new();
        for fact in facts {
            let PropKind::Compare(sides, relations) = &fact.kind else { continue };
            if *relations != [Relation::NotEqual] {
                continue;
            }
            let Some(reading) = self.read(&super::facts::minus(&sides[0], &sides[1]), true) else { continue };
            for f in self.split(reading).factors {
                if f.signs.within(Signs::NOT_ZERO) && !f.poly.is_constant() && !out.contains(&f.poly) {
                    out.push(f.poly);
                }
            }
        }
        out.truncate(INVERSES);
        out
    }
}
