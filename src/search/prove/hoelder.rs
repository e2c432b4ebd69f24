//! Hölder's inequality in comparisons of powers of sums: (Σ tᵢ)^q <= (Σ aᵢ)^p·(Σ bᵢ)^r for p + r = q and tᵢ = aᵢ^(p/q)·bᵢ^(r/q).
//! The inequalities of Cauchy and Schwarz (p = r), between power means (bᵢ = 1) and of Lyapunov (powers of one family) are cases.
//!
//! Method (Hardy, Littlewood, Pólya, "Inequalities", 1934, theorem 11): let w = r/q, A = Σ aᵢ and B = Σ bᵢ. The inequality between
//! weighted means says that (aᵢ/A)^(1 − w)·(bᵢ/B)^w <= (1 − w)·aᵢ/A + w·bᵢ/B. The right sides add up to 1.
//!
//! That the goal follows is shown with names for the sums, so that no power of a sum is multiplied out.
//!
//! Limits: one sum on the smaller side, two on the other, or one and a number; [`TERMS`] positive terms each.

use super::antiderivatives::factors;
use super::coefficients::{add, rational};
use super::comparison::single;
use super::facts::{minus, negated};
use super::letters::{product, total};
use super::limits::over;
use super::means::positive;
use super::sums::replace;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, name, numeral, one_minus, power, prop, sum};
use crate::refute::literal::literal;
use malachite::Rational;

/// The most terms of a sum.
const TERMS: usize = 6;

/// A power of a sum that is costly to multiply out is above this.
const HIGH: u64 = 10;

/// A comparison of powers of sums.
struct Powers {
    /// The sum that is alone on the smaller side, and its exponent there.
    small: (Expr, Expr),
    /// The sums on the greater side with their exponents; instead of a second one a number.
    large: Vec<(Expr, Expr)>,
}

impl Prover {
    /// Shows an order of products of powers of sums by Hölder's inequality. The facts on the way end with a block: they are about powers
    /// that nothing else holds.
    ///
    /// With `high` only where the power of the sum alone is a number above [`HIGH`]: what is less is multiplied out first, which shows
    /// more in fewer steps.
    pub(super) fn by_hoelder(&mut self, goal: &Prop, high: bool) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let (greater, less) = if relation.is_greater() == Some(true) { (a, b) } else { (b, a) };
        let (greater, less) = without_common_summands(greater, less);
        let powers = self.powers_of_sums(&greater, &less).ok_or(Fail::No("powers of sums"))?;
        if high && rational(&powers.small.1).is_none_or(|q| q <= HIGH) {
            return Err(Fail::No("a high power"));
        }
        let nothing = compare(numeral(0), Relation::Equal, numeral(0));
        let apart = self.block(&implies(&nothing, goal), |c, _| c.by_means_of_terms(goal, powers))?;
        let nothing = self.combination(nothing, Vec::new())?;
        self.logic(&[&apart, &nothing], goal)
    }

    fn by_means_of_terms(&mut self, goal: &Prop, powers: Powers) -> Result<Label, Fail> {
        let no = || Fail::No("powers of sums");
        let Powers { small: (small, q), mut large } = powers;
        let wanted = terms(&small).ok_or_else(no)?;
        let (first, p) = large.remove(0);
        let weight = as_number(over(minus(&q, &p), q.clone()));
        let is_positive = |c: &mut Prover, e: &Expr| c.signs_of(e).within(Signs::POSITIVE);
        if ![&weight, &as_number(one_minus(&weight))].into_iter().all(|w| is_positive(self, w)) {
            return Err(no());
        }
        let (second, others) = match large.pop() {
            Some((second, r)) if self.is_zero(&minus(&q, &add(vec![p.clone(), r.clone()]))) => {
                let others = terms(&second).ok_or_else(no)?;
                (second, others)
            }
            Some(_) => return Err(no()),
            None => (numeral(u32::try_from(wanted.len()).map_err(|_| no())?), vec![numeral(1); wanted.len()]),
        };
        let firsts = terms(&first).ok_or_else(no)?;
        let (firsts, seconds, equations) = self.matched(&wanted, &firsts, &others, &weight).ok_or_else(no)?;
        let shown = self.hoelder(&firsts, &seconds, &weight)?;
        let order = self.fact(&shown).and_then(|fact| fact.single().map(|s| s.1)).ok_or_else(no)?;
        // The sum itself for that of the means.
        let term = |label, sign: i64| Term { facts: vec![label], factor: literal(&Rational::from(sign)) };
        let by = [term(shown, 1)].into_iter().chain(equations.into_iter().map(|label| term(label, -1))).collect();
        let least = self.combination(compare(between(&first, &second, &weight), order, small.clone()), by)?;
        let mut sums = vec![small, first];
        sums.extend(terms(&second).is_some().then(|| second.clone()));
        let lemma = self.goal_below_the_mean(goal, &sums, (&second, &weight, &q), order)?;
        for (_, whole) in &lemma.1 {
            self.quietly(&positive(whole))?;
        }
        let instance = self.instance_at(&lemma.0, lemma.1)?;
        self.logic(&[&instance, &least], goal)
    }

    /// For all t, s and s′ > 0, the goal with these names for its sums if s^(1 − w)·s′^w lies above t; with the sum that each name is
    /// for. A power of a sum need not be multiplied out so.
    fn goal_below_the_mean(
        &mut self,
        goal: &Prop,
        sums: &[Expr],
        (second, weight, q): (&Expr, &Expr, &Expr),
        order: Relation,
    ) -> Result<(Label, Vec<(String, Expr)>), Fail> {
        let (a, relation, b) = single(goal)?;
        let point: Vec<(String, Expr)> = sums.iter().map(|whole| (self.fresh("s"), whole.clone())).collect();
        let named = |e: &Expr| {
            let mut e = e.clone();
            point.iter().for_each(|(own, whole)| replace(&mut e, whole, &name(own)));
            e
        };
        let above = Constraint::Relation(Relation::Greater, numeral(0));
        let bindings = point.iter().map(|(own, _)| Binding::of(Name::new(own), false, vec![above.clone()])).collect();
        let (mean, below) = (between(&named(&sums[1]), &named(second), weight), named(&sums[0]));
        let premise = compare(mean.clone(), order, below.clone());
        let (a, b) = (named(a), named(b));
        let conclusion = compare(a.clone(), relation, b.clone());
        let every = prop(PropKind::ForAll(bindings, Box::new(implies(&premise, &conclusion))));
        let is_greater = relation.is_greater() == Some(true);
        let (greater, less) = if is_greater { (&a, &b) } else { (&b, &a) };
        let (greater, less) = without_common_summands(greater, less);
        // greater − less = less/t^q·((s^(1 − w)·s′^w)^q − t^q).
        let signed = |e: Expr| if is_greater { e } else { negated(e) };
        let factor = signed(over(less.clone(), power(&below, q)));
        let label = self.block(&every, |c, _| {
            c.block(&implies(&premise, &conclusion), |c, _| {
                let from = c.known(&premise).ok_or(Fail::No("what is supposed"))?;
                let raised = compare(power(&mean, q), order, power(&below, q));
                let raised = c.emit(Rule::Monotone { from }, raised)?;
                let mut by = vec![Term { facts: vec![raised], factor }];
                if let Ok(label) = c.combination(conclusion.clone(), by.clone()) {
                    return Ok(label);
                }
                // Powers of quotients are not read as quotients of powers: the rules for powers say so.
                let factor = signed(over(as_powers(&less), power(&below, q)));
                by[0].factor = factor.clone();
                let sides = [(greater, signed(numeral(1))), (less, signed(negated(numeral(1))))];
                for (side, factor) in sides.into_iter().chain([(power(&mean, q), negated(factor))]) {
                    let apart = compare(side.clone(), Relation::Equal, as_powers(&side));
                    by.push(Term { facts: vec![c.plainly(Rule::Power, &apart)?], factor });
                }
                c.combination(conclusion.clone(), by)
            })
        })?;
        Ok((label, point))
    }

    /// (Σ aᵢ)^(1 − w)·(Σ bᵢ)^w >= Σ aᵢ^(1 − w)·bᵢ^w, strict where some mean is seen to be.
    pub(super) fn hoelder(&mut self, firsts: &[Expr], seconds: &[Expr], weight: &Expr) -> Result<Label, Fail> {
        let [first, second] = [firsts, seconds].map(|list| added(list.iter().cloned()));
        let large = between(&first, &second, weight);
        let means = firsts.iter().zip(seconds).map(|(a, b)| between(a, b, weight));
        let small = added(means);
        let (mut terms, mut written, mut strict) = (Vec::new(), Vec::new(), false);
        for (a, b) in firsts.iter().zip(seconds) {
            let (own, other) = (over(a.clone(), first.clone()), over(b.clone(), second.clone()));
            let (label, is_strict) = self.this_mean(&own, &other, weight)?;
            strict |= is_strict;
            terms.push(Term { facts: vec![label], factor: negated(large.clone()) });
            let whole = product(vec![large.clone(), between(&own, &other, weight)]);
            written.push(compare(whole, Relation::Equal, between(a, b, weight)));
        }
        let relation = if strict { Relation::Greater } else { Relation::GreaterEqual };
        self.write_powers(&[&large, &small]);
        let shown = compare(large, relation, small);
        let label = match self.combination(shown.clone(), terms.clone()) {
            Ok(label) => label,
            // Roots of quotients are not read as quotients of roots: the rules for powers say so.
            Err(_) => {
                for equation in written {
                    let label = self.plainly(Rule::Power, &equation)?;
                    terms.push(Term { facts: vec![label], factor: numeral(1) });
                }
                self.combination(shown.clone(), terms)?
            }
        };
        self.take_in(&label, &shown).map(|()| label)
    }

    /// The sums of a comparison of two products of powers, each side with its own.
    fn powers_of_sums(&mut self, greater: &Expr, less: &Expr) -> Option<Powers> {
        let mut list = Vec::new();
        factors(greater, &numeral(1), &mut list);
        factors(less, &negated(numeral(1)), &mut list);
        let (mut small, mut large) = (None, Vec::new());
        for (base, exponent) in list {
            if self.is_of_numbers(&base) || self.is_zero(&exponent) {
                continue;
            }
            terms(&base)?;
            match self.signs_of(&exponent) {
                signs if signs.within(Signs::POSITIVE) => large.push((base, exponent)),
                signs if signs.within(Signs::of(Relation::Less)) && small.is_none() => {
                    small = Some((base, as_number(negated(exponent))))
                }
                _ => return None,
            }
        }
        let small = small.filter(|_| matches!(large.len(), 1 | 2))?;
        Some(Powers { small, large })
    }

    /// The terms of two sums in the order in which their means are the terms of a third, with the equations that say so.
    fn matched(
        &mut self,
        wanted: &[Expr],
        firsts: &[Expr],
        seconds: &[Expr],
        weight: &Expr,
    ) -> Option<(Vec<Expr>, Vec<Expr>, Vec<Label>)> {
        if firsts.len() != wanted.len() || seconds.len() != wanted.len() {
            return None;
        }
        let (mut firsts, mut seconds) = (firsts.to_vec(), seconds.to_vec());
        let (mut own, mut others, mut equations) = (Vec::new(), Vec::new(), Vec::new());
        for t in wanted {
            let pairs = (0..firsts.len()).flat_map(|i| (0..seconds.len()).map(move |j| (i, j)));
            let mean_is =
                |c: &mut Prover, i: usize, j: usize| c.has_the_exponents(t, &between(&firsts[i], &seconds[j], weight));
            let (i, j) = pairs.into_iter().find(|&(i, j)| mean_is(self, i, j))?;
            own.push(firsts.remove(i));
            others.push(seconds.remove(j));
        }
        for ((t, a), b) in wanted.iter().zip(&own).zip(&others) {
            let equation = compare(t.clone(), Relation::Equal, between(a, b, weight));
            // By the rules for powers it does not enter what later expressions are read with.
            let shown = self.plainly(Rule::Power, &equation).or_else(|_| self.quietly(&equation));
            equations.push(shown.ok()?);
        }
        Some((own, others, equations))
    }

    /// Whether two products of powers have the same bases with the same exponents, but for numbers.
    fn has_the_exponents(&mut self, a: &Expr, b: &Expr) -> bool {
        let mut quotient = Vec::new();
        factors(a, &numeral(1), &mut quotient);
        factors(b, &negated(numeral(1)), &mut quotient);
        quotient.iter().all(|(base, exponent)| self.is_of_numbers(base) || self.is_zero(exponent))
    }
}

/// An expression, as a numeral where it is a number.
fn as_number(e: Expr) -> Expr {
    rational(&e).map_or(e, |number| literal(&number))
}

/// a^(1 − w)·b^w.
fn between(a: &Expr, b: &Expr, weight: &Expr) -> Expr {
    product(vec![power(a, &as_number(one_minus(weight))), power(b, weight)])
}

/// A product of powers, with quotients and powers of products taken apart.
fn as_powers(e: &Expr) -> Expr {
    let mut list = Vec::new();
    factors(e, &numeral(1), &mut list);
    product(list.into_iter().map(|(base, exponent)| power(&base, &exponent)).collect())
}

/// The sum of these terms.
fn added(terms: impl Iterator<Item = Expr>) -> Expr {
    total(terms.map(|e| (Sign::Plus, e)).collect())
}

/// The terms of a sum, if all are added.
fn terms(e: &Expr) -> Option<Vec<Expr>> {
    let ExprKind::Sum(list) = &e.kind else { return None };
    let all = list.iter().map(|(sign, e)| (*sign == Sign::Plus).then(|| e.clone()));
    all.collect::<Option<Vec<_>>>().filter(|terms| terms.len() <= TERMS)
}

/// Two sides without the summands that both have.
fn without_common_summands(a: &Expr, b: &Expr) -> (Expr, Expr) {
    let (ExprKind::Sum(left), ExprKind::Sum(right)) = (&a.kind, &b.kind) else { return (a.clone(), b.clone()) };
    let (mut left, mut right) = (left.clone(), right.clone());
    left.retain(|summand| match right.iter().position(|other| other == summand) {
        Some(place) => {
            right.remove(place);
            false
        }
        None => true,
    });
    let side = |list: Vec<(Sign, Expr)>| match list.as_slice() {
        [] => numeral(0),
        [(Sign::Plus, only)] => only.clone(),
        _ => sum(list),
    };
    (side(left), side(right))
}
