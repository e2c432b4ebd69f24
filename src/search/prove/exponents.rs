//! Equations and inequalities of powers with variable exponents, by their logarithms: 10^x = 1000 gives x = 3.
//!
//! Method: a fact A = B about products of positive powers is exp(t) = 1 for t = ln A − ln B, where ln b^E is E·ln b and numbers are
//! split into primes. The exponential lies above its tangent, at t and at −t, so t <= exp(t) − 1 = 0 and −t <= 0. Of A < B it gives
//! t < 0, and a goal A < B follows from it. What is left is polynomial in the exponents and in logarithms of primes.
//!
//! Certificate: two steps `tangent`, two combinations. Cost: of four steps for each fact. Limits: [`ROUNDS`], [`PRIME`].

use super::comparison::single;
use super::letters::{as_power, natural, product, total};
use super::limits::over;
use super::products::{Kind, Known};
use super::{Fail, Prover};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, expr, numeral, power};
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
                let taken = self.attempt(|c| c.take_logarithms(&label, &fact));
                // Of exp(x) = 2 nothing is left where 2 is put in for exp(x).
                changed |= taken.or_else(|_| self.without_equations(|c| c.take_logarithms(&label, &fact))).is_ok();
            }
            changed |= self.split_logarithms(goal);
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

    /// Proves A < B for two products with exponents from ln A < ln B: B − A = A·(exp(t) − 1) for t = ln B − ln A, and exp(t) lies
    /// above 1 + t.
    pub(super) fn by_logarithms(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("two products with exponents");
        let is_greater = relation.is_greater().ok_or_else(no)?;
        let (less, greater, sign, order) = if is_greater { (b, a, 1, relation) } else { (a, b, -1, relation.turned()) };
        let (below, above) = (factors_of(less), factors_of(greater));
        if self.within_logarithms || !below.iter().chain(&above).any(|(_, e)| has_exponent(e)) {
            return Err(no());
        }
        let mut parts = Vec::new();
        for (side, factors) in [(1, above), (-1, below)] {
            for (factor, e) in factors {
                parts.extend(signed(self.logarithm_of(&e)?, if factor == Factor::Over { -side } else { side }));
            }
        }
        let t = total(parts);
        self.define(&t);
        let ordered = compare(t.clone(), order, numeral(0));
        self.split_logarithms(&ordered);
        self.within_logarithms = true;
        let shown = self.without_cases(&ordered);
        self.within_logarithms = false;
        let shown = shown?;
        let tangent = self.tangent_fact(&t)?;
        let factor = |k: i64| product(vec![literal(&Rational::from(k)), less.clone()]);
        let line = Term { facts: vec![tangent], factor: factor(-sign) };
        let mut terms = vec![line, Term { facts: vec![shown], factor: factor(sign) }];
        self.attempt(|c| c.combination(goal.clone(), terms.clone())).or_else(|_| {
            // exp(n·ln(x)) is not read as x^n where n is a whole number: the rules for powers say so.
            let whole = compare(apply("exp", t), Relation::Equal, over(greater.clone(), less.clone()));
            let whole = self.plainly(Rule::Power, &whole)?;
            terms.push(Term { facts: vec![whole], factor: factor(-sign) });
            self.combination(goal.clone(), terms)
        })
    }

    /// Proves a comparison of x^n with exp(n·y) from that with exp(y)^n.
    pub(super) fn by_power_of_exponential(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("a power and an exponential");
        let exponent_of = |e: &Expr| match &e.kind {
            ExprKind::Apply(f, list) if f.text == "exp" => list.first().cloned(),
            _ => None,
        };
        let (n, whole, is_left) = match (as_power(a), exponent_of(b), exponent_of(a), as_power(b)) {
            (Some((_, n)), Some(whole), ..) => (n, whole, false),
            (_, _, Some(whole), Some((_, n))) => (n, whole, true),
            _ => return Err(no()),
        };
        let (top, bottom) = (self.letters.polynomial(&whole), self.letters.polynomial(&n));
        let (top, bottom) = (top.ok_or_else(no)?, bottom.filter(|n| !n.is_constant()).ok_or_else(no)?);
        let part = self.letters.written(&top.exact_divide(&bottom).ok_or_else(no)?);
        let other = power(&apply("exp", part), &n);
        let (left, right) = if is_left { (other, b.clone()) } else { (a.clone(), other) };
        let shown = self.show(&compare(left, relation, right))?;
        self.combination(goal.clone(), vec![Term { facts: vec![shown], factor: numeral(1) }])
    }

    /// Runs a part of the search in which no equation is put in, where there is one.
    fn without_equations<T>(&mut self, run: impl FnOnce(&mut Self) -> Result<T, Fail>) -> Result<T, Fail> {
        if self.equations.is_empty() {
            return Err(Fail::No("an equation that is put in"));
        }
        let equations = std::mem::take(&mut self.equations);
        let shown = self.attempt(run);
        self.equations = equations;
        shown
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
        let t = total(parts.clone());
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
        let apart = self.exponential_apart(&t, &parts, -1)?;
        // t = (A − B)/A − ((1 − t) − exp(−t)).
        let mut label = self.beside(&known, compare(t.clone(), least, numeral(0)), (low, apart, -1), a)?;
        if relation == Relation::Equal {
            let high = self.tangent_at(&t)?;
            let apart = self.exponential_apart(&t, &parts, 1)?;
            // t = (A − B)/B + ((1 + t) − exp(t)).
            let most = self.beside(&known, compare(t, Relation::LessEqual, numeral(0)), (high, apart, 1), b)?;
            label = self.logic(&[&label, &most], &shown)?;
        }
        self.take_in(&label, &shown)
    }

    /// exp(±t) = exp(±t1)·exp(±(t − t1)) for the first part t1 of t, where t is a quotient: its exponential is not seen to be a product.
    fn exponential_apart(&mut self, t: &Expr, parts: &[(Sign, Expr)], sign: i32) -> Result<Option<Label>, Fail> {
        let divides = self.read(t, false).is_some_and(|r| r.factors.iter().any(|f| f.power < 0));
        let ([first, rest @ ..], true) = (parts, divides && parts.len() > 1) else { return Ok(None) };
        let [first, rest] = [total(vec![first.clone()]), total(rest.to_vec())];
        let of = |e: Expr| if sign < 0 { expr(ExprKind::Negate(Box::new(e))) } else { e };
        self.exponential_of_a_sum(&of(first), &of(rest)).map(Some)
    }

    /// A bound from a tangent and a fact over a divisor.
    fn beside(
        &mut self,
        known: &Known,
        shown: Prop,
        (tangent, apart, sign): (Label, Option<Label>, i32),
        divisor: Expr,
    ) -> Result<Label, Fail> {
        let factors: Vec<Expr> = known.factors.iter().cloned().chain([over(numeral(1), divisor)]).collect();
        let own = Term { facts: known.facts.clone(), factor: product(factors) };
        let line = |label| Term { facts: vec![label], factor: literal(&Rational::from(sign)) };
        self.combination(shown, [tangent].into_iter().chain(apart).map(line).chain([own]).collect())
    }

    /// The logarithm of a monomial with a positive number, times 1 or −1, as a sum.
    fn logarithm(&mut self, (m, q): &(Monomial, Rational), sign: i64) -> Result<Vec<(Sign, Expr)>, Fail> {
        let mut out = signed(logarithm_of_number(q.numerator_ref()), sign);
        out.extend(signed(logarithm_of_number(q.denominator_ref()), -sign));
        for (v, k) in m.powers() {
            let e = self.letters.expr(*v).cloned().ok_or(Fail::No("a letter"))?;
            out.extend(signed(self.logarithm_of(&e)?, sign * i64::from(*k)));
        }
        Ok(out)
    }

    /// The logarithm of a positive factor, as whole multiples.
    fn logarithm_of(&mut self, e: &Expr) -> Result<Vec<(i64, Expr)>, Fail> {
        if let Some(n) = natural(e).filter(|n| *n > 0) {
            return Ok(logarithm_of_number(&Natural::from(n)));
        }
        Ok(match (&e.kind, as_power(e)) {
            (ExprKind::Apply(f, list), _) if f.text == "exp" && list.len() == 1 => vec![(1, list[0].clone())],
            (_, Some((base, exponent))) if self.signs_of(&base).within(Signs::POSITIVE) => {
                let of_base = match natural(&base) {
                    Some(n) => logarithm_of_number(&Natural::from(n)),
                    None => vec![(1, apply("ln", base))],
                };
                of_base.into_iter().map(|(k, log)| (k, product(vec![exponent.clone(), log]))).collect()
            }
            _ if self.signs_of(e).within(Signs::POSITIVE) => vec![(1, apply("ln", e.clone()))],
            _ => return Err(Fail::No("a positive factor")),
        })
    }
}

/// The logarithm of a number by its primes.
pub(super) fn logarithm_of_number(n: &Natural) -> Vec<(i64, Expr)> {
    primes(n).into_iter().map(|(p, k)| (k, apply("ln", literal(&Rational::from(p))))).collect()
}

/// Multiples times a whole number, as terms.
pub(super) fn signed(list: Vec<(i64, Expr)>, by: i64) -> Vec<(Sign, Expr)> {
    let term = |(k, e): (i64, Expr)| {
        let size = literal(&Rational::from((k * by).abs()));
        (if k * by < 0 { Sign::Minus } else { Sign::Plus }, product(vec![size, e]))
    };
    list.into_iter().map(term).collect()
}

/// The factors of a product, or the expression alone.
fn factors_of(e: &Expr) -> Vec<(Factor, Expr)> {
    match &e.kind {
        ExprKind::Product(list) => list.clone(),
        _ => vec![(Factor::Times, e.clone())],
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
