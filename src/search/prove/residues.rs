//! Cases by the remainders of whole numbers: n = c·m, or n = c·m + 1, …
//!
//! Method: a modulus M of the goal or the facts is a coefficient, or a denominator. Of a whole number x those remainders are
//! distinguished, by the least divisor c of M, that leave no x in the polynomials modulo M: of x^2, with M = 8, those by 4. Of a
//! number in an exponent, as n in 2^n, those by the period of the power modulo M. Where all have their remainders the goal is one
//! of linear arithmetic, or its witness is a quotient; and mostly before.
//!
//! Certificate: that there is such an m for every n, by induction, with the rule `existence` in its step; then its instance at n.
//! An integer k_up - k_down leaves the remainder of k_up + (c - 1)*k_down.
//!
//! Limits: moduli from 2 to [`MODULUS`], [`PLANS`] choices of moduli, [`CASES`] cases of each, primes up to [`PRIME`], powers with bases
//! up to [`BASE`].

use super::boxes::prop_with_integers;
use super::integers::{all_sides, difference};
use super::{Fail, Prover, implies};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, expr, name, numeral, prop, sum};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Gcd, Lcm};
use malachite::base::num::conversion::traits::IsInteger;
use std::collections::BTreeSet;

/// The largest modulus.
const MODULUS: u32 = 30;

/// The most choices of moduli.
const PLANS: usize = 3;

/// The most cases of one choice.
const CASES: u32 = 64;

/// The largest prime whose remainders are distinguished.
const PRIME: u32 = 7;

/// The largest base of a power with a period.
const BASE: u64 = 1_000_000_000;

/// A letter that no expression has.
const STEP: u32 = u32::MAX;

/// Whole numbers with the moduli of their remainders.
type Plan = Vec<(String, u32)>;

/// c·m + r.
fn form(modulus: u32, m: &Expr, remainder: u32) -> Expr {
    let multiple = super::letters::product(vec![numeral(modulus), m.clone()]);
    if remainder == 0 { multiple } else { sum(vec![(Sign::Plus, multiple), (Sign::Plus, numeral(remainder))]) }
}

/// n = c·m or n = c·m + 1 or …
fn some_form(n: &Expr, modulus: u32, m: &Expr) -> Prop {
    let forms = (0..modulus).map(|r| compare(n.clone(), Relation::Equal, form(modulus, m, r)));
    prop(PropKind::Or(forms.collect()))
}

/// A natural variable without a domain.
fn natural(text: &str) -> Vec<Binding> {
    vec![Binding::of(Name::new(text), true, Vec::new())]
}

/// The coefficients of a polynomial that may be moduli, and its denominators.
fn moduli(p: &Polynomial, out: &mut BTreeSet<u32>) {
    for (_, c) in p.terms().filter(|t| !t.0.is_one()) {
        let parts = [u32::try_from(c.numerator_ref()), u32::try_from(c.denominator_ref())];
        out.extend(parts.into_iter().flatten().filter(|c| (2..=MODULUS).contains(c)));
    }
}

/// A multiple of a polynomial with whole coefficients.
fn whole(p: &Polynomial) -> Polynomial {
    let below = p.terms().fold(malachite::Natural::from(1u32), |n, t| n.lcm(t.1.denominator_ref()));
    p.scale(&Rational::from(below))
}

/// The order of a number modulo another, its factors in common with the number taken out of the other; with what is left.
fn period(base: u64, mut modulus: u64) -> (u32, u64) {
    loop {
        match modulus.gcd(base) {
            1 => break,
            common => modulus /= common,
        }
    }
    let (mut power, mut order) = (base % modulus, 1);
    while power != 1 % modulus {
        (power, order) = (power * (base % modulus) % modulus, order + 1);
    }
    (order, modulus)
}

impl Prover {
    /// Whether a goal speaks of a floor, as the reader writes it.
    pub(super) fn has_a_floor(goal: &Prop) -> bool {
        let mut names = BTreeSet::new();
        crate::kernel::names::names_in_prop(goal, &mut names);
        names.iter().any(|n| n.starts_with("floor_"))
    }

    /// Proves a goal for each remainder of its whole numbers.
    pub(super) fn by_residues(&mut self, goal: &Prop) -> Result<Label, Fail> {
        if self.splits > 0 || self.inductions > 0 || self.in_residues {
            return Err(Fail::No("remainders"));
        }
        self.in_residues = true;
        let (integers, opened) = (self.integers.len(), self.opened.len());
        let mut shown = Err(Fail::No("remainders"));
        for (modulus, plan) in self.plans(goal) {
            shown = self.on_its_own(|c| c.in_remainders(goal, modulus, &plan, None));
            self.splits = 0;
            self.integers.truncate(integers);
            self.opened.truncate(opened);
            if shown.is_ok() {
                break;
            }
        }
        self.in_residues = false;
        shown
    }

    /// Choices of moduli, each with the one that it is made for.
    fn plans(&mut self, goal: &Prop) -> Vec<(u32, Plan)> {
        let integers = self.integers.clone();
        let read = |c: &mut Prover, p: &Prop| -> Vec<Polynomial> {
            let (mut p, mut sides) = (p.clone(), Vec::new());
            prop_with_integers(&mut p, &integers);
            all_sides(&p, &mut sides);
            sides.iter().filter_map(|e| c.letters.polynomial(e)).collect()
        };
        let own = read(self, goal);
        let facts: Vec<Polynomial> = self.facts().iter().flat_map(|f| read(self, &f.1)).collect();
        let (mut first, mut others) = (BTreeSet::new(), BTreeSet::new());
        own.iter().for_each(|p| moduli(p, &mut first));
        facts.iter().for_each(|p| moduli(p, &mut others));
        let [own, facts] = [own, facts].map(|list| list.iter().map(whole).collect::<Vec<_>>());
        let is_part = |n: &str| integers.iter().filter_map(|k| difference(&k.1)).any(|(up, down)| n == up || n == down);
        let names = self.naturals.iter().chain(integers.iter().map(|k| &k.0));
        let names: Vec<String> = names.filter(|n| !n.starts_with("floor_") && !is_part(n)).cloned().collect();
        let for_modulus = |c: &mut Prover, modulus: u32| -> Option<Plan> {
            let mut plan = Vec::new();
            for polys in [&own, &facts] {
                for n in &names {
                    if plan.iter().all(|(known, _)| known != n) {
                        plan.extend(c.remainders_of(n, modulus, polys)?.map(|own| (n.clone(), own)));
                    }
                }
            }
            Some(plan)
        };
        let mut all: Vec<(u32, Plan)> = Vec::new();
        for modulus in first.iter().rev().chain(others.difference(&first)) {
            all.extend(for_modulus(self, *modulus).map(|plan| (*modulus, plan)));
        }
        // All together, where facts say something of other remainders.
        let mut together: Plan = Vec::new();
        for (n, modulus) in all.iter().flat_map(|plan| &plan.1) {
            match together.iter_mut().find(|known| known.0 == *n) {
                Some(known) => known.1 = known.1.lcm(*modulus),
                None => together.push((n.clone(), *modulus)),
            }
        }
        if let (Some((modulus, plan)), true) = (all.first(), !others.is_subset(&first)) {
            let whole = (*modulus, together);
            if whole.1 != *plan {
                all.insert(0, whole);
            }
        }
        let cases = |plan: &Plan| plan.iter().try_fold(1u32, |n, p| n.checked_mul(p.1));
        // A prime has as many cases in one step of logic.
        let has_small_primes =
            |c: u32| (PRIME + 1..=c).all(|p| !c.is_multiple_of(p) || (2..=PRIME).any(|q| p.is_multiple_of(q)));
        let is_possible =
            |plan: &Plan| cases(plan).is_some_and(|n| n <= CASES) && plan.iter().all(|p| has_small_primes(p.1));
        all.retain(|(_, plan)| !plan.is_empty() && is_possible(plan));
        all.truncate(PLANS);
        all
    }

    /// The modulus whose remainders of a number fix these polynomials by another modulus, if they are not fixed without;
    /// `None` where it stands in what has no period.
    #[allow(clippy::option_option)] // that they are fixed is no failure
    fn remainders_of(&mut self, n: &str, modulus: u32, polys: &[Polynomial]) -> Option<Option<u32>> {
        let letter = self.letters.of(&name(n));
        let (mut is_exponent, mut own) = (false, 1u32);
        let is_multiple = |p: &Polynomial| {
            let by = Rational::from(modulus);
            p.terms().all(|t| (t.1 / &by).is_integer())
        };
        for p in polys {
            for other in p.variables().into_iter().filter(|v| *v != letter) {
                let e = self.letters.expr(other)?.clone();
                if super::limits::holds(&e, n) {
                    let (base, slope) = self.power_in(&e, n)?;
                    is_exponent = true;
                    own = own.lcm(period(base.checked_pow(slope).filter(|b| *b <= BASE)?, modulus.into()).0);
                }
            }
            if p.contains(letter) {
                let fixes = |c: &u32| {
                    let step = Polynomial::variable(STEP).scale(&Rational::from(*c));
                    let moved = p.substitute(letter, &Polynomial::variable(letter).add(&step));
                    modulus.is_multiple_of(*c) && moved.is_ok_and(|moved| is_multiple(&moved.sub(p)))
                };
                own = own.lcm((1..=modulus).find(fixes)?);
            }
        }
        Some((own > 1 || is_exponent).then_some(own))
    }

    /// b and c, where an expression is b^(c*n + …) with numerals b and c.
    fn power_in(&mut self, e: &Expr, n: &str) -> Option<(u64, u32)> {
        let ExprKind::Power(base, exponent) = &e.kind else { return None };
        let letter = self.letters.of(&name(n));
        let parts = self.letters.polynomial(exponent)?.coefficients_in(letter);
        let [_, slope] = parts.as_slice() else { return None };
        let base = super::letters::natural(base).filter(|b| *b > 1)?;
        Some((base.into(), u32::try_from(slope.as_constant()?.numerator_ref()).ok()?))
    }

    /// Proves a goal for each remainder of these numbers, unless it is seen before.
    /// A modulus is distinguished by its prime factors, of the number, of its quotient and so on; at the last quotient the powers
    /// have their periods.
    fn in_remainders(
        &mut self,
        goal: &Prop,
        modulus: u32,
        plan: &[(String, u32)],
        powers: Option<&[Label]>,
    ) -> Result<Label, Fail> {
        let Some(((n, total), rest)) = plan.split_first() else {
            let splits = std::mem::replace(&mut self.splits, 2);
            let shown = self.show(goal);
            self.splits = splits;
            return shown;
        };
        let own = (2..=*total).find(|c| total.is_multiple_of(*c)).unwrap_or(*total);
        let powers = match powers {
            Some(known) => known.to_vec(),
            None => self.periods(goal, n, (modulus, *total))?,
        };
        if *total == 1 {
            for every in &powers {
                self.instance(every, &name(n))?;
            }
            return self.in_remainders(goal, modulus, rest, None);
        }
        let integer = self.integers.iter().find(|k| k.0 == *n).and_then(|k| difference(&k.1));
        let integer = integer.map(|(up, down)| (up.to_string(), down.to_string()));
        let number = match &integer {
            None => name(n),
            Some((up, down)) => sum(vec![(Sign::Plus, name(up)), (Sign::Plus, form(own - 1, &name(down), 0))]),
        };
        let every = self.remainders(own)?;
        let some = self.instance(&every, &number)?;
        self.opened.push(some.clone());
        let quotient = self.fresh("q");
        let step = implies(&some_form(&number, own, &name(&quotient)), goal);
        let all = prop(PropKind::ForAll(natural(&quotient), Box::new(step.clone())));
        let all = self.block(&all, |c, _| {
            c.block(&step, |c, block| {
                let mut from = vec![format!("{block}s")];
                for remainder in 0..own {
                    let case = compare(number.clone(), Relation::Equal, form(own, &name(&quotient), remainder));
                    from.push(c.block(&implies(&case, goal), |c, block| {
                        let case = format!("{block}s");
                        let next = match &integer {
                            None => {
                                c.put_in(&case);
                                quotient.clone()
                            }
                            Some((_, down)) => c.put_in_integer(n, down, &quotient, (own, remainder), case)?,
                        };
                        if own < *total {
                            let plan: Plan = [(next, total / own)].into_iter().chain(rest.iter().cloned()).collect();
                            return c.in_remainders(goal, modulus, &plan, Some(&powers));
                        }
                        for every in &powers {
                            c.instance(every, &name(&quotient))?;
                        }
                        let shown = c.on_its_own(|c| c.seen(goal));
                        shown.or_else(|_| c.on_its_own(|c| c.in_remainders(goal, modulus, rest, None)))
                    })?);
                }
                c.emit(Rule::Logic { from }, goal.clone())
            })
        })?;
        self.emit(Rule::Existence { some, all }, goal.clone())
    }

    /// A goal that needs no more remainders, as far as a witness from equations or linear arithmetic tells.
    fn seen(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let splits = std::mem::replace(&mut self.splits, 8);
        let shown = match &goal.kind {
            PropKind::Exists(bindings, body) => self.by_equations(goal, bindings, body),
            _ => self.by_whole_numbers(goal),
        };
        let shown = shown.or_else(|_| self.absurd_in_whole_numbers(goal, 0));
        self.splits = splits;
        shown
    }

    /// n = c·q + r for an integer n and an integer q, put in, from its natural numbers.
    fn put_in_integer(
        &mut self,
        n: &str,
        down: &str,
        quotient: &str,
        (own, remainder): (u32, u32),
        case: Label,
    ) -> Result<String, Fail> {
        let d = sum(vec![(Sign::Plus, name(quotient)), (Sign::Minus, name(down))]);
        let integer = self.name_integer("q", quotient, down, d)?;
        let shown = compare(name(n), Relation::Equal, form(own, &name(&integer), remainder));
        let shown = self.combination(shown, vec![Term { facts: vec![case], factor: numeral(1) }])?;
        self.put_in(&shown);
        Ok(integer)
    }

    /// That b^(c·q) leaves the remainder 1 for all q, for each power b^n in the goal and the facts.
    fn periods(&mut self, goal: &Prop, n: &str, (modulus, own): (u32, u32)) -> Result<Vec<Label>, Fail> {
        let mut sides = Vec::new();
        self.facts().iter().map(|f| &*f.1).chain([goal]).for_each(|p| all_sides(p, &mut sides));
        let polys: Vec<Polynomial> = sides.iter().filter_map(|e| self.letters.polynomial(e)).collect();
        let letters: BTreeSet<u32> = polys.iter().flat_map(Polynomial::variables).collect();
        let mut bases = BTreeSet::new();
        for letter in letters {
            let Some(e) = self.letters.expr(letter).cloned() else { continue };
            if let Some((base, slope)) = self.power_in(&e, n) {
                let left = period(base, modulus.into()).1;
                bases.extend(base.checked_pow(slope * own).filter(|b| *b <= BASE && left > 1).map(|b| (b, left)));
            }
        }
        let (q, j) = (self.fresh("q"), self.fresh("j"));
        let mut out = Vec::new();
        for (base, left) in bases {
            let [base, left] = [base, left].map(|c| u32::try_from(c).map_err(|_| Fail::No("a period")));
            let power = expr(ExprKind::Power(Box::new(numeral(base?)), Box::new(name(&q))));
            let says = compare(power, Relation::Equal, form(left?, &name(&j), 1));
            let some = prop(PropKind::Exists(natural(&j), Box::new(says)));
            let every = prop(PropKind::ForAll(natural(&q), Box::new(some)));
            // The base of an induction counts as a case.
            let splits = self.splits;
            out.push(self.all_by_induction(&every, 3)?);
            self.splits = splits;
        }
        Ok(out)
    }

    /// For every natural number n there is an m with n = c·m + r and r < c.
    fn remainders(&mut self, modulus: u32) -> Result<Label, Fail> {
        let (n, m) = (self.fresh("n"), self.fresh("m"));
        let body = prop(PropKind::Exists(natural(&m), Box::new(some_form(&name(&n), modulus, &name(&m)))));
        if let Some(known) = self.known(&prop(PropKind::ForAll(natural(&n), Box::new(body.clone())))) {
            return Ok(known);
        }
        self.induction_by(&n, None, &body, &mut |c, hypothesis, next| {
            let quotient = c.fresh("m");
            let cases = some_form(&name(&n), modulus, &name(&quotient));
            let step = implies(&cases, next);
            let all = prop(PropKind::ForAll(natural(&quotient), Box::new(step.clone())));
            let all = c.block(&all, |c, _| {
                c.block(&step, |c, block| {
                    let mut from = vec![format!("{block}s")];
                    for remainder in 0..modulus {
                        let case = compare(name(&n), Relation::Equal, form(modulus, &name(&quotient), remainder));
                        from.push(c.block(&implies(&case, next), |c, block| {
                            c.next_remainder(&n, &quotient, (modulus, remainder), &format!("{block}s"), next)
                        })?);
                    }
                    c.emit(Rule::Logic { from }, next.clone())
                })
            })?;
            c.emit(Rule::Existence { some: hypothesis, all }, next.clone())
        })
    }

    /// n + 1 = c·m + (r + 1), or c·(m + 1), from n = c·m + r.
    fn next_remainder(
        &mut self,
        n: &str,
        quotient: &str,
        (modulus, remainder): (u32, u32),
        fact: &str,
        next: &Prop,
    ) -> Result<Label, Fail> {
        let PropKind::Exists(bindings, _) = &next.kind else { return Err(Fail::No("a quotient")) };
        let own = bindings.first().and_then(|b| b.names.first()).ok_or(Fail::No("a quotient"))?.0.clone();
        let above = |e: Expr| sum(vec![(Sign::Plus, e), (Sign::Plus, numeral(1))]);
        let last = remainder + 1 == modulus;
        let value = if last { above(name(quotient)) } else { name(quotient) };
        let number = above(name(n));
        let shown = form(modulus, &value, if last { 0 } else { remainder + 1 });
        let term = Term { facts: vec![fact.to_string()], factor: numeral(1) };
        let equation = self.combination(compare(number.clone(), Relation::Equal, shown), vec![term])?;
        let some = self.logic(&[&equation], &some_form(&number, modulus, &value))?;
        self.emit(Rule::Witness { with: vec![(own, value)], from: vec![some] }, next.clone())
    }
}
