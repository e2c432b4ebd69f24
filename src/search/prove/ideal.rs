//! Equations from equations: ideal membership, each element of the basis that is needed a step of its own.
//!
//! Method: Buchberger's algorithm modulo a prime, the needed steps made again over the rationals (`algebra::ideal`). What is known not
//! to be 0 may be divided by: its inverse t gets a name, and t·d = 1 is one more equation (Rabinowitsch; Cox, Little, O'Shea,
//! "Ideals, Varieties, and Algorithms", chapter 4, §2). Where only a power of the goal is a sum of multiples, it is supposed not to be
//! 0: then 1 = 0 follows.
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
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

/// The most equations that are taken.
const EQUATIONS: usize = 24;

/// The most polynomials that are divided by.
const INVERSES: usize = 10;

/// The most of them of which it is asked whether they are 0.
const DENIALS: usize = 3;

/// The most terms that are taken from others for one derivation, modulo the prime.
pub(super) const WORK: usize = 1_200_000;

/// The same where other ways are still to be tried.
pub(super) const FIRST_WORK: usize = 300_000;

/// The same for all derivations of one goal.
const ALL_WORK: usize = 6_000_000;

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

/// A goal, equations, and what is divided by.
type Question = (Polynomial, Vec<Polynomial>, Vec<Polynomial>);

/// What was asked about ideals within one goal.
pub(super) struct Asked {
    /// The work that is left for all questions.
    left: usize,
    /// The work that a question was given in vain.
    in_vain: HashMap<Question, usize>,
}

impl Asked {
    /// Nothing was asked yet.
    pub(super) fn nothing() -> Asked {
        Asked { left: ALL_WORK, in_vain: HashMap::new() }
    }

    /// The work for all questions is there again.
    pub(super) fn renew(&mut self) {
        self.left = ALL_WORK;
    }
}

impl Prover {
    /// Shows an equation by equations among the facts.
    pub(super) fn by_ideal(&mut self, goal: &Prop) -> Result<Label, Fail> {
        if let Ok(label) = self.attempt(|c| c.in_ideal(goal, &[], FIRST_WORK)) {
            return Ok(label);
        }
        let divisors = self.not_zero();
        if divisors.is_empty() {
            return Err(Fail::No("an equation from equations"));
        }
        self.in_ideal(goal, &divisors, WORK)
    }

    /// Shows an equation of which a power follows from equations among the facts.
    pub(super) fn by_radical_ideal(&mut self, goal: &Prop) -> Result<Label, Fail> {
        self.against_opposite(goal, |c, _| {
            let divisors = c.not_zero();
            c.without_common_zero(goal, &divisors, WORK)
        })
    }

    /// Shows any goal from equations that cannot hold beside what is not 0: one of those polynomials is 0, or there is no common zero.
    pub(super) fn absurd_by_ideal(&mut self, goal: &Prop, efforts: &[usize]) -> Result<Label, Fail> {
        let divisors = self.not_zero();
        // A theorem says more than the conditions under which it holds.
        let mut denials: Vec<&Polynomial> = divisors.iter().collect();
        denials.sort_by_key(|d| std::cmp::Reverse((d.degree(), d.term_count())));
        denials.truncate(DENIALS);
        for work in efforts.iter().copied() {
            // What is denied of expressions that equations have changed since.
            let shown = self.by_denial(goal, |c, equation| c.attempt(|c| c.in_ideal(equation, &divisors, work)));
            if shown.is_ok() {
                return shown;
            }
            for denied in denials.iter().copied() {
                let others: Vec<Polynomial> = divisors.iter().filter(|d| *d != denied).cloned().collect();
                if let Ok(label) = self.attempt(|c| c.denied_in_ideal(goal, denied, &others, work)) {
                    return Ok(label);
                }
            }
            if let Ok(label) = self.attempt(|c| c.without_common_zero(goal, &divisors, work)) {
                return Ok(label);
            }
        }
        Err(Fail::No("equations that contradict each other"))
    }

    /// Shows any goal: what is known not to be 0 is 0 by the equations.
    fn denied_in_ideal(
        &mut self,
        goal: &Prop,
        denied: &Polynomial,
        others: &[Polynomial],
        work: usize,
    ) -> Result<Label, Fail> {
        let zeros = self.zeros(std::slice::from_ref(denied));
        let (zeros, found) = self.derivation_of(denied, zeros, others, work)?;
        let sides = |relation| compare(self.letters.written(denied), relation, numeral(0));
        let (equation, denial) = (sides(Relation::Equal), sides(Relation::NotEqual));
        let shown = self.derived(&equation, zeros, &[], found)?;
        let denial = self.combination(denial, Vec::new())?;
        self.logic(&[&denial, &shown], goal)
    }

    /// Shows an equation, once it may be divided by these polynomials.
    fn in_ideal(&mut self, goal: &Prop, divisors: &[Polynomial], work: usize) -> Result<Label, Fail> {
        let no = || Fail::No("an equation from equations");
        let open = self.open_factors(goal, 1)?;
        let zeros = self.zeros(std::slice::from_ref(&open.poly));
        if zeros.is_empty() || open.poly.is_constant() {
            return Err(no());
        }
        let (zeros, found) = self.derivation_of(&open.poly, zeros, divisors, work)?;
        self.derived(goal, zeros, &open.rest, found)
    }

    /// Shows an equation whose difference is this polynomial times the rest, by these facts alone.
    pub(super) fn in_ideal_of(
        &mut self,
        goal: &Prop,
        poly: &Polynomial,
        rest: &[Expr],
        facts: &[(Label, Prop)],
    ) -> Result<Label, Fail> {
        let mut zeros = Vec::new();
        for (label, fact) in facts {
            if let Some(k) = self.known_of(label, fact).filter(|k| k.kind == Kind::Zero && !k.poly.is_zero()) {
                zeros.push(Zero { poly: k.poly, facts: k.facts, factors: k.factors });
            }
        }
        let (zeros, found) = self.derivation_of(poly, zeros, &[], FIRST_WORK)?;
        self.derived(goal, zeros, rest, found)
    }

    /// Shows any goal: the equations have no common zero beside what is not 0.
    fn without_common_zero(&mut self, goal: &Prop, divisors: &[Polynomial], work: usize) -> Result<Label, Fail> {
        let zeros = self.zeros(divisors);
        if zeros.is_empty() || divisors.is_empty() {
            return Err(Fail::No("equations that contradict each other"));
        }
        let (zeros, found) = self.derivation_of(&Polynomial::one(), zeros, divisors, work)?;
        let shown = self.derived(&compare(numeral(1), Relation::Equal, numeral(0)), zeros, &[], found)?;
        self.logic(&[&shown], goal)
    }

    /// The equations that are known, those that share a letter with these polynomials first.
    fn zeros(&mut self, about: &[Polynomial]) -> Vec<Zero> {
        let letters: BTreeSet<u32> = about.iter().flat_map(Polynomial::variables).collect();
        let known = self.all_known(about);
        let shares = |k: &&Known| k.poly.variables().iter().any(|v| letters.contains(v));
        let mut zeros: Vec<&Known> = known.iter().filter(|k| k.kind == Kind::Zero && !k.poly.is_zero()).collect();
        zeros.sort_by_key(|k| !shares(k));
        zeros.truncate(EQUATIONS);
        let zero = |k: &Known| Zero { poly: k.poly.clone(), facts: k.facts.clone(), factors: k.factors.clone() };
        zeros.into_iter().map(zero).collect()
    }

    /// A derivation of a polynomial from equations and inverses, which are added to the equations. What was not found once is not
    /// sought again with as little work.
    fn derivation_of(
        &mut self,
        goal: &Polynomial,
        mut zeros: Vec<Zero>,
        divisors: &[Polynomial],
        work: usize,
    ) -> Result<(Vec<Zero>, Derivation), Fail> {
        let no = Fail::No("an equation from equations");
        let polynomials = |zeros: &[Zero]| zeros.iter().map(|z| z.poly.clone()).collect::<Vec<_>>();
        let question = (goal.clone(), polynomials(&zeros), divisors.to_vec());
        let work = work.min(self.ideals.left);
        if self.ideals.in_vain.get(&question).is_some_and(|before| *before >= work) {
            return Err(no);
        }
        for d in divisors {
            zeros.push(self.inverse(d)?);
        }
        let mut left = work;
        let found = derivation(goal, &polynomials(&zeros), &mut left);
        self.ideals.left -= work - left;
        self.ticks += 1;
        let Some(found) = found else {
            // Where work is left, more would not help.
            self.ideals.in_vain.insert(question, if left > work / 100 { usize::MAX } else { work });
            return Err(no);
        };
        Ok((zeros, found))
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
    pub(super) fn not_zero(&mut self) -> Vec<Polynomial> {
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
