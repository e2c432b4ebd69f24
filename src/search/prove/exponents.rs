//! Equations and inequalities of powers with variable exponents, by their logarithms: 10^x = 1000 gives x = 3.
//!
//! Method: a fact A = B about products of positive powers is exp(t) = 1 for t = ln A − ln B, where ln b^E is E·ln b and numbers are
//! split into primes. The exponential lies above its tangent, at t and at −t, so t <= exp(t) − 1 = 0 and −t <= 0. Of A < B it gives
//! t < 0. What is left is polynomial in the exponents and in logarithms of primes.
//!
//! Certificate: two steps `tangent`, two combinations. Cost: of four steps for each fact. Limits: [`ROUNDS`], [`PRIME`].

use super::letters::{as_power, natural, product};
use super::limits::over;
use super::products::{Kind, Known};
use super::{Fail, Prover};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, expr, numeral, sum};
use crate::refute::literal::literal;
use malachite::{Natural, Rational};

/// How often logarithms are taken: the exponents of one equation may be known only after another is solved.
const ROUNDS: usize = 2;

/// The largest prime that is split off a number.
const PRIME: u32 = 1_000;

/// The prime factors of a number up to [`PRIME`], and what is left of it.
fn primes(n: &Natural) -> Vec<(Natural, i64)> {
    let mut rest = n.clone();
    let mut out: Vec<(Natural, i64)> = Vec::new();
    for p in 2..=PRIME {
        let mut count = 0;
        while rest != 0u32 && &rest % Natural::from(p) == 0u32 {
            rest /= Natural::from(p);
            count += 1;
        }
        if count > 0 {
            out.push((Natural::from(p), count));
        }
    }
    if rest > 1u32 {
        out.push((rest, 1));
    }
    out
}

/// The sum of terms with signs; the first has none.
fn total(mut terms: Vec<(Sign, Expr)>) -> Expr {
    terms.sort_by_key(|(sign, _)| *sign == Sign::Minus);
    if let Some((sign @ Sign::Minus, first)) = terms.first_mut() {
        *sign = Sign::Plus;
        *first = expr(ExprKind::Negate(Box::new(first.clone())));
    }
    match terms.as_slice() {
        [] => numeral(0),
        [(_, one)] => one.clone(),
        _ => sum(terms),
    }
}

/// Whether an expression is an exponential or a power whose exponent is no number.
fn has_exponent(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Apply(f, list) => f.text == "exp" && list.len() == 1,
        ExprKind::Power(_, exponent) => {
            let mut names = std::collections::BTreeSet::new();
            crate::kernel::names::names_in(exponent, &mut names);
            !names.is_empty()
        }
        _ => false,
    }
}

impl Prover {
    /// Proves a comparison from the logarithms of facts.
    pub(super) fn by_exponents(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("an equation of powers");
        for _ in 0..ROUNDS {
            let mut changed = false;
            for (label, fact) in self.facts() {
                changed |= self.attempt(|c| c.take_logarithms(&label, &fact)).is_ok();
            }
            if !changed {
                return Err(no());
            }
            self.solve_equations();
            if let Ok(label) = self.quietly(goal) {
                return Ok(label);
            }
        }
        Err(no())
    }

    /// Adds ln A = ln B, or an inequality, for a fact about two products with exponents.
    fn take_logarithms(&mut self, label: &str, fact: &Prop) -> Result<(), Fail> {
        let no = || Fail::No("two products with exponents");
        let PropKind::Compare(..) = &fact.kind else { return Err(no()) };
        let known = self.known_of(label, fact).ok_or_else(no)?;
        let terms: Vec<(Monomial, Rational)> = known.poly.terms().map(|(m, c)| (m.clone(), c.clone())).collect();
        let [first, second] = terms.as_slice() else { return Err(no()) };
        let (above, below) = if first.1 > 0 { (first, second) } else { (second, first) };
        let letters = || known.poly.variables().into_iter().filter_map(|v| self.letters.expr(v));
        if above.1 <= 0 || below.1 >= 0 || !letters().any(has_exponent) {
            return Err(no());
        }
        let below = (below.0.clone(), -&below.1);
        let mut parts = self.logarithm(above, 1)?;
        parts.extend(self.logarithm(&below, -1)?);
        let t = total(parts);
        let written =
            |c: &Prover, (m, q): &(Monomial, Rational)| c.letters.written(&Polynomial::term(m.clone(), q.clone()));
        let (a, b) = (written(self, above), written(self, &below));
        self.define(&t);
        // A − B is 0, positive or not negative.
        let relation = match known.kind {
            Kind::Zero => Relation::Equal,
            Kind::Strict => Relation::Greater,
            Kind::Weak => Relation::GreaterEqual,
        };
        let shown = compare(t.clone(), relation, numeral(0));
        if self.known(&shown).is_some() {
            return Err(no());
        }
        let least = if relation == Relation::Equal { Relation::GreaterEqual } else { relation };
        let minus_t = expr(ExprKind::Negate(Box::new(t.clone())));
        let low = self.tangent_at(&minus_t)?;
        // t = (A − B)/A − ((1 − t) − exp(−t)).
        let mut label = self.beside(&known, compare(t.clone(), least, numeral(0)), (low, -1), a)?;
        if relation == Relation::Equal {
            let high = self.tangent_at(&t)?;
            // t = (A − B)/B + ((1 + t) − exp(t)).
            let most = self.beside(&known, compare(t, Relation::LessEqual, numeral(0)), (high, 1), b)?;
            label = self.logic(&[&label, &most], &shown)?;
        }
        self.take_in(&label, &shown)
    }

    /// A bound from a tangent and a fact over a divisor.
    fn beside(
        &mut self,
        known: &Known,
        shown: Prop,
        (tangent, sign): (Label, i32),
        divisor: Expr,
    ) -> Result<Label, Fail> {
        let factors: Vec<Expr> = known.factors.iter().cloned().chain([over(numeral(1), divisor)]).collect();
        let own = Term { facts: known.facts.clone(), factor: product(factors) };
        let line = Term { facts: vec![tangent], factor: literal(&Rational::from(sign)) };
        self.combination(shown, vec![line, own])
    }

    /// The logarithm of a monomial with a positive number, times 1 or −1, as a sum.
    fn logarithm(&mut self, (m, q): &(Monomial, Rational), sign: i64) -> Result<Vec<(Sign, Expr)>, Fail> {
        let mut out = Vec::new();
        let mut add = |k: i64, e: Expr| {
            let size = literal(&Rational::from(k.abs()));
            out.push((if k < 0 { Sign::Minus } else { Sign::Plus }, product(vec![size, e])));
        };
        let log = |e: Expr| apply("ln", e);
        for (numbers, side) in [(primes(q.numerator_ref()), 1), (primes(q.denominator_ref()), -1)] {
            for (p, k) in numbers {
                add(side * sign * k, log(literal(&Rational::from(p))));
            }
        }
        for (v, k) in m.powers() {
            let e = self.letters.expr(*v).cloned().ok_or(Fail::No("a letter"))?;
            let k = sign * i64::from(*k);
            match (&e.kind, as_power(&e)) {
                (ExprKind::Apply(f, list), _) if f.text == "exp" && list.len() == 1 => add(k, list[0].clone()),
                (_, Some((base, exponent))) if self.signs_of(&base).within(Signs::POSITIVE) => match natural(&base) {
                    Some(n) => {
                        for (p, j) in primes(&Natural::from(n)) {
                            add(k * j, product(vec![exponent.clone(), log(literal(&Rational::from(p)))]));
                        }
                    }
                    None => add(k, product(vec![exponent, log(base)])),
                },
                _ if self.signs_of(&e).within(Signs::POSITIVE) => add(k, log(e)),
                _ => return Err(Fail::No("a positive factor")),
            }
        }
        Ok(out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_the_product_of_its_primes() {
        for n in [1u32, 2, 12, 1000, 1009 * 3, 999_983] {
            let product = primes(&Natural::from(n))
                .into_iter()
                .fold(Natural::from(1u32), |all, (p, k)| (0..k).fold(all, |all, _| all * &p));
            assert_eq!(product, n);
        }
    }
}
