//! The weighted mean inequality, tried for the powers in a goal, and for many values at once.

use super::comparison::single;
use super::facts::{is_settled, minus, sign_of};
use super::letters::{product, whole_power};
use super::{Fail, Prover};
use crate::algebra::simplex::{Column, SimplexLimits, solve};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::analysis::weighted_mean;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, name, numeral, one_minus, power, prop, sum};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::BTreeMap;

/// What the linear program for weights may cost.
const LIMITS: SimplexLimits = SimplexLimits { pivots: 250, work: 400_000 };

/// The most terms of a polynomial whose monomials are compared with means, and the most of these that are subtracted.
const TERMS: usize = 40;
const BELOW: usize = 24;

impl Prover {
    /// Notes a^(1 - p)*b^p <= (1 - p)*a + p*b for powers a^q and b^p in the goal with q = 1 - p, and for a power alone.
    pub(crate) fn means(&mut self, goal: &Prop) -> Result<Vec<Label>, Fail> {
        let mut powers = Vec::new();
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        sides.iter().for_each(|e| powers_in(e, &mut powers));
        let one = numeral(1);
        let mut out = Vec::new();
        for (b, p) in powers.clone() {
            // t^r for r >= 1 lies above its tangent: the mean of t^r and 1 with weight 1/r.
            let inverse = super::limits::over(one.clone(), p.clone());
            let whole = crate::kernel::statement::power(&b, &p);
            let mut tries = vec![(one.clone(), b.clone(), p.clone()), (one.clone(), whole.clone(), inverse.clone())];
            for (a, q) in &powers {
                let gap = super::facts::minus(q, &one_minus(&p));
                if self.is_zero(&gap) {
                    tries.push((a.clone(), b.clone(), p.clone()));
                }
                // W. H. Young's inequality: the mean of a^q and b^p, where 1/p + 1/q = 1.
                let gap = super::facts::minus(&super::limits::over(one.clone(), q.clone()), &one_minus(&inverse));
                if self.is_zero(&gap) {
                    tries.push((power(a, q), whole.clone(), inverse.clone()));
                }
            }
            for (a, b, p) in tries {
                out.extend(self.attempt(|c| c.mean(&a, &b, &p)));
            }
            if self.is_whole(&p) && !self.in_bernoulli {
                out.extend(self.on_its_own(|c| c.bernoulli(&b, &p)));
            }
        }
        if out.is_empty() { Err(Fail::No("the mean inequality")) } else { Ok(out) }
    }

    /// Notes b^n >= 1 + n·(b − 1), Bernoulli's inequality for b >= 0, shown for every exponent by induction: b may hold n.
    fn bernoulli(&mut self, b: &Expr, n: &Expr) -> Result<Label, Fail> {
        let k = self.fresh("k");
        let line = sum(vec![(Sign::Plus, numeral(1)), (Sign::Plus, product(vec![name(&k), minus(b, &numeral(1))]))]);
        let body = compare(power(b, &name(&k)), Relation::GreaterEqual, line);
        let every = prop(PropKind::ForAll(vec![Binding::of(Name::new(&k), true, Vec::new())], Box::new(body)));
        let splits = std::mem::replace(&mut self.splits, 0);
        self.in_bernoulli = true;
        let shown = self.all_by_induction(&every, 3);
        self.in_bernoulli = false;
        self.splits = splits;
        self.instance(&shown?, n)
    }

    fn mean(&mut self, a: &Expr, b: &Expr, p: &Expr) -> Result<Label, Fail> {
        for e in [a, b] {
            self.quietly(&compare(e.clone(), Relation::Greater, numeral(0)))?;
        }
        for e in [p.clone(), one_minus(p)] {
            self.quietly(&compare(e, Relation::GreaterEqual, numeral(0)))?;
        }
        self.noted_mean(a, b, p, Relation::LessEqual)
    }

    /// The weighted mean inequality of a and b, strict where a != b can be shown. Returns its label, and whether it is strict.
    pub(super) fn this_mean(&mut self, a: &Expr, b: &Expr, p: &Expr) -> Result<(Label, bool), Fail> {
        for e in [a, b] {
            self.show(&positive(e))?;
        }
        for e in [p, &one_minus(p)] {
            if self.quietly(&positive(e)).is_err() {
                self.show(&compare(e.clone(), Relation::GreaterEqual, numeral(0)))?;
            }
        }
        if self.quietly(&compare(a.clone(), Relation::NotEqual, b.clone())).is_ok()
            && let Ok(label) = self.noted_mean(a, b, p, Relation::Less)
        {
            return Ok((label, true));
        }
        self.noted_mean(a, b, p, Relation::LessEqual).map(|label| (label, false))
    }

    /// Notes the weighted mean inequality, whose conditions are known.
    pub(super) fn noted_mean(&mut self, a: &Expr, b: &Expr, p: &Expr, relation: Relation) -> Result<Label, Fail> {
        let shown = weighted_mean(a, b, p, relation);
        if let Some(label) = self.known(&shown) {
            return Ok(label);
        }
        let named = |text: &str, e: &Expr| (Name::new(text), e.clone());
        let with = vec![named("a", a), named("b", b), named("p", p)];
        let label = self.emit(Rule::Mean { with }, shown.clone())?;
        self.take_in(&label, &shown)?;
        Ok(label)
    }
}

impl Prover {
    /// Shows that a polynomial in positive letters is not negative where each monomial that is subtracted lies below a
    /// mean of monomials that are added: x1^w1*x2^w2*… <= w1*x1 + w2*x2 + … for weights that add up to 1.
    pub(crate) fn by_means_of_many(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("a mean of monomials");
        let up = relation.is_greater().ok_or_else(no)?;
        let reading = self.read(&minus(a, b), true).ok_or_else(no)?;
        let (mut signs, mut open) = (sign_of(&reading.number), None);
        let mut rest = vec![literal(&reading.number)];
        for f in &reading.factors {
            if is_settled(f.signs.power(f.power)) {
                signs = signs.times(f.signs.power(f.power));
                rest.push(whole_power(self.letters.written(&f.poly), f.power));
            } else if f.power == 1 && open.is_none() {
                open = Some(f.poly.clone());
            } else {
                return Err(no());
            }
        }
        // a − b = rest·poly.
        let poly: Polynomial = open.filter(|p| p.term_count() <= TERMS).ok_or_else(no)?;
        let flip = signs.within(Signs::POSITIVE) != up;
        let poly = if flip { poly.neg() } else { poly };
        let mut exponents = BTreeMap::new();
        for v in poly.variables() {
            exponents.insert(v, self.exponents_of(v).ok_or_else(no)?);
        }
        let means = means_below(&poly, &exponents).ok_or_else(no)?;
        // poly = Σ c·(Σ w·x − m) + what is left of the monomials that are added.
        let mut left: Polynomial = poly;
        let mut terms = Vec::new();
        for (c, monomial, weights) in means {
            let sign = if flip { Rational::from(-1) } else { Rational::ONE };
            for (fact, weight) in self.mean_of_many(&monomial, &weights)? {
                let mut factors = vec![literal(&(&sign * &c * weight))];
                factors.extend(rest.iter().cloned());
                terms.push(Term { facts: vec![fact], factor: product(factors) });
            }
            left = weights.iter().fold(left.add(&monomial.scale(&c)), |p, (x, w)| p.sub(&x.scale(&(&c * w))));
        }
        for (m, c) in left.terms() {
            let monomial = Polynomial::term(m.clone(), if flip { -c } else { c.clone() });
            let mut factors = vec![self.letters.written(&monomial)];
            factors.extend(rest.iter().cloned());
            terms.push(Term { facts: Vec::new(), factor: product(factors) });
        }
        self.combination(goal.clone(), terms)
    }

    /// A positive letter as a product of powers of positive variables, if it is one: each with its exponent.
    fn exponents_of(&mut self, letter: u32) -> Option<Vec<(u32, Rational)>> {
        let e = self.letters.expr(letter).cloned()?;
        if !self.signs_of(&e).within(Signs::POSITIVE) {
            return None;
        }
        let plain = vec![(letter, Rational::ONE)];
        let ExprKind::Power(base, exponent) = &e.kind else { return Some(plain) };
        let Some(k) = self.read(exponent, false).filter(|r| r.factors.is_empty()).map(|r| r.number) else {
            return Some(plain);
        };
        let base = self.read(base, false)?;
        let mut out = Vec::new();
        for f in &base.factors {
            let mut terms = f.poly.terms();
            let (Some((m, c)), None) = (terms.next(), terms.next()) else { return Some(plain) };
            if *c != Rational::ONE {
                return Some(plain);
            }
            out.extend(m.powers().iter().map(|(v, j)| (*v, &k * Rational::from(*j) * Rational::from(f.power))));
        }
        Some(if base.number == Rational::ONE { out } else { plain })
    }

    /// Shows that a monomial lies below the mean of others with these weights, one value after the other: the mean g of the
    /// first ones, with all their weight, and the next. Returns the facts and what they are multiplied by in
    /// Σ w·x − m = Σ factor·(left − right).
    fn mean_of_many(
        &mut self,
        monomial: &Polynomial,
        weights: &[(Polynomial, Rational)],
    ) -> Result<Vec<(Label, Rational)>, Fail> {
        let Some(((first, weight), rest)) = weights.split_first() else { return Err(Fail::No("weights")) };
        let mut total = weight.clone();
        let mut so_far = vec![(self.letters.written(first), weight.clone())];
        let mut before = self.letters.written(first);
        let mut facts = Vec::new();
        for (place, (x, weight)) in rest.iter().enumerate() {
            total += weight;
            let x = self.letters.written(x);
            let p = literal(&(weight / &total));
            facts.push((self.mean(&before, &x, &p)?, -total.clone()));
            so_far.push((x.clone(), weight.clone()));
            let after = if place + 1 == rest.len() {
                self.letters.written(monomial)
            } else {
                product(so_far.iter().map(|(x, w)| power(x, &literal(&(w / &total)))).collect())
            };
            let both = product(vec![power(&before, &one_minus(&p)), power(&x, &p)]);
            self.define(&after);
            facts.push((self.emit(Rule::Power, compare(both, Relation::Equal, after.clone()))?, total.clone()));
            before = after;
        }
        Ok(facts)
    }
}

/// A monomial with the coefficient −c, c itself first, and monomials whose mean it is, with their weights.
type MeanBelow = (Rational, Polynomial, Vec<(Polynomial, Rational)>);

/// For each monomial with a negative coefficient −c, weights of monomials with positive coefficients whose mean it is:
/// Σ w = 1, Σ w·exponents = its exponents, and all c·w together are no more than the positive coefficients.
fn means_below(p: &Polynomial, exponents: &BTreeMap<u32, Vec<(u32, Rational)>>) -> Option<Vec<MeanBelow>> {
    let (above, below): (Vec<_>, Vec<_>) = p.terms().partition(|(_, c)| **c > 0);
    if above.is_empty() || below.is_empty() || below.len() > BELOW {
        return None;
    }
    let mut letters: Vec<u32> = exponents.values().flatten().map(|e| e.0).collect();
    letters.sort_unstable();
    letters.dedup();
    let exponent = |m: &Monomial, v: u32| {
        let of = |(u, k): &(u32, u32)| {
            let own = exponents.get(u).into_iter().flatten().filter(|e| e.0 == v);
            own.map(|e| &e.1 * Rational::from(*k)).fold(Rational::ZERO, |a, b| a + b)
        };
        m.powers().iter().map(of).fold(Rational::ZERO, |a, b| a + b)
    };
    let width = letters.len() + 1;
    let mut target = Vec::new();
    for (m, c) in &below {
        target.extend(letters.iter().map(|v| -*c * exponent(m, *v)));
        target.push(-*c);
    }
    target.extend(above.iter().map(|(_, c)| (*c).clone()));
    let mut columns: Vec<Column> = Vec::new();
    for j in 0..below.len() {
        for (i, (m, _)) in above.iter().enumerate() {
            let own = letters.iter().enumerate().map(|(k, v)| (j * width + k, exponent(m, *v)));
            let ends = [(j * width + letters.len(), Rational::ONE), (below.len() * width + i, Rational::ONE)];
            columns.push(own.chain(ends).filter(|(_, c)| *c != Rational::ZERO).collect());
        }
    }
    columns.extend((0..above.len()).map(|i| vec![(below.len() * width + i, Rational::ONE)]));
    let solution = solve(&columns, &target, None, &LIMITS).ok()??;
    let term = |m: &Monomial| Polynomial::term(m.clone(), Rational::ONE);
    let means = below.iter().zip(solution.chunks(above.len())).map(|((m, c), list)| {
        let weighted = above.iter().zip(list).filter(|(_, w)| **w != Rational::ZERO);
        (-*c, term(m), weighted.map(|((x, _), w)| (term(x), -(w / *c))).collect())
    });
    Some(means.collect())
}

/// The powers in an expression whose exponents are no whole numerals, with their bases and exponents.
fn powers_in(e: &Expr, out: &mut Vec<(Expr, Expr)>) {
    match &e.kind {
        ExprKind::Power(base, exponent) if super::letters::natural(exponent).is_none() => {
            let power = ((**base).clone(), (**exponent).clone());
            if !out.contains(&power) && out.len() < 4 {
                out.push(power);
            }
        }
        ExprKind::Power(base, _) => powers_in(base, out),
        ExprKind::Negate(a) => powers_in(a, out),
        ExprKind::Sum(list) => list.iter().for_each(|(_, e)| powers_in(e, out)),
        ExprKind::Product(list) => list.iter().for_each(|(_, e)| powers_in(e, out)),
        _ => {}
    }
}

/// That an expression is positive.
pub(super) fn positive(e: &Expr) -> Prop {
    compare(e.clone(), Relation::Greater, numeral(0))
}
