//! Sums up to a variable in closed form: of polynomials in the index, and geometric ones.

use super::letters::{natural, product};
use super::limits::{holds, over, powers_of};
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::Label;
use crate::claim::syntax::*;
use crate::claim::walk::{parts, parts_mut};
use crate::kernel::key;
use crate::kernel::statement::{compare, name, power, prop, sum};
use crate::kernel::substitution::Substitution;
use malachite::Rational;
use malachite::base::num::basic::traits::One;

/// The largest exponent of the index in a sum.
const DEGREE: usize = 8;

impl Prover {
    /// An expression with closed forms in the place of the sums up to a variable, and the facts that these are equal for
    /// every value of it, shown by induction.
    ///
    /// # Errors
    /// No sum has a closed form that was found.
    pub(crate) fn with_closed_sums(&mut self, e: &Expr, variable: &str) -> Result<(Expr, Vec<Label>), Fail> {
        let mut sums = Vec::new();
        sums_to(e, variable, &mut sums);
        let (mut closed, mut facts) = (e.clone(), Vec::new());
        for s in sums {
            for value in self.closed_sum(&s, variable) {
                if let Ok(fact) = self.attempt(|c| c.is_closed_form(&s, &value, variable)) {
                    replace(&mut closed, &s, &value);
                    facts.push(fact);
                    break;
                }
            }
        }
        if facts.is_empty() { Err(Fail::No("a sum in closed form")) } else { Ok((closed, facts)) }
    }

    /// A comparison with the closed forms of its sums up to natural numbers put in.
    pub(crate) fn by_sums(&mut self, goal: &Prop) -> Result<Label, Fail> {
        if self.inductions > 0 {
            return Err(Fail::No("a comparison outside an induction"));
        }
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        let whole = sum(sides.into_iter().map(|e| (Sign::Plus, e)).collect());
        let mut any = false;
        for variable in self.naturals.clone() {
            let Ok((_, facts)) = self.with_closed_sums(&whole, &variable) else { continue };
            for fact in facts {
                let here = self.instance(&fact, &name(&variable))?;
                self.put_in(&here);
                any = true;
            }
        }
        if any { self.quietly(goal) } else { Err(Fail::No("a sum in closed form")) }
    }

    /// Shows that a sum has this value for every value of the variable.
    fn is_closed_form(&mut self, s: &Expr, value: &Expr, variable: &str) -> Result<Label, Fail> {
        let k = self.fresh("k");
        let mut map = Substitution::default();
        map.replace(variable, &name(&k));
        let at = |e: &Expr| map.expr(e).map_err(Fail::from);
        let body = compare(at(s)?, Relation::Equal, at(value)?);
        let every = prop(PropKind::ForAll(vec![Binding::of(Name::new(&k), true, Vec::new())], Box::new(body)));
        let splits = std::mem::replace(&mut self.splits, 0);
        let shown = self.all_by_induction(&every, 3);
        self.splits = splits;
        shown
    }

    /// What a sum from 0 or 1 to a variable n may come to.
    fn closed_sum(&mut self, s: &Expr, variable: &str) -> Vec<Expr> {
        let ExprKind::SumOver(index, body) = &s.kind else { return Vec::new() };
        let Some(from) = natural(&index.from).filter(|from| *from <= 1) else { return Vec::new() };
        let n = name(variable);
        let mut out = Vec::new();
        if let Some(value) = self.sum_of_polynomial(&index.name.text, body, from, &n) {
            out.push(value);
        }
        let mut ratios = Vec::new();
        if is_geometric(body, &index.name.text) {
            powers_of(body, &index.name.text, &mut ratios);
        }
        let mut first = Substitution::default();
        first.replace(&index.name.text, &crate::kernel::statement::numeral(from));
        if let Ok(first) = first.expr(body) {
            for r in ratios {
                // a + a·r + … + a·r^(m - 1) = a·(1 − r^m)/(1 − r), where r^m = r^n·r for m = n + 1.
                let mut last = vec![power(&r, &n)];
                if from == 0 {
                    last.push(r.clone());
                }
                let one = || crate::kernel::statement::numeral(1);
                let less = |e: Expr| sum(vec![(Sign::Plus, one()), (Sign::Minus, e)]);
                out.push(product(vec![first.clone(), over(less(product(last)), less(r))]));
            }
        }
        out
    }

    /// Σ c_j·i^j for i = from … n, with the sums of powers as polynomials in n.
    fn sum_of_polynomial(&mut self, index: &str, body: &Expr, from: u32, n: &Expr) -> Option<Expr> {
        let i = self.letters.of(&name(index));
        let poly = self.letters.polynomial(body).filter(|p| p.degree_in(i) as usize <= DEGREE)?;
        let nowhere_else = poly.variables().into_iter().filter(|v| *v != i).all(|v| {
            let mut names = std::collections::BTreeSet::new();
            self.letters.expr(v).inspect(|e| crate::kernel::names::names_in(e, &mut names));
            !names.contains(index)
        });
        let place = self.letters.of(n);
        let mut total = Polynomial::zero();
        for (j, c) in poly.coefficients_in(i).into_iter().enumerate() {
            let mut powers = sum_of_powers(j, place)?;
            if from == 0 && j == 0 {
                powers = powers.add(&Polynomial::one());
            }
            total = total.add(&powers.try_mul(&c).ok()?);
        }
        (nowhere_else && !poly.is_constant()).then(|| self.letters.written(&total))
    }
}

/// 1^j + 2^j + … + n^j as a polynomial in n, from (k + 1)^(j + 1) − k^(j + 1) summed over k.
fn sum_of_powers(j: usize, n: u32) -> Option<Polynomial> {
    let mut sums: Vec<Polynomial> = Vec::new();
    for m in 0..=j {
        // (n + 1)^(m + 1) − 1 = Σ binomial(m + 1, i)·S_i over i = 0 … m.
        let next = Polynomial::variable(n).add(&Polynomial::one());
        let mut rest = next.pow(u32::try_from(m + 1).ok()?).ok()?.sub(&Polynomial::one());
        let mut binomial = Rational::ONE;
        for (i, s) in sums.iter().enumerate() {
            rest = rest.sub(&s.scale(&binomial));
            binomial *= Rational::from(m + 1 - i) / Rational::from(i + 1);
        }
        let whole = rest.scale(&(Rational::ONE / binomial));
        sums.push(whole);
    }
    sums.pop()
}

/// Whether an expression holds the index in one factor only, a power: r^i times what does not depend on i.
fn is_geometric(e: &Expr, index: &str) -> bool {
    match &e.kind {
        ExprKind::Power(base, _) => !holds(base, index),
        ExprKind::Negate(a) => is_geometric(a, index),
        ExprKind::Product(list) => {
            let mut with = list.iter().filter(|(_, e)| holds(e, index));
            matches!((with.next(), with.next()), (Some((Factor::Times, e)), None) if is_geometric(e, index))
        }
        _ => false,
    }
}

/// The sums up to a variable.
fn sums_to(e: &Expr, variable: &str, out: &mut Vec<Expr>) {
    if let ExprKind::SumOver(index, _) = &e.kind
        && matches!(&index.to.kind, ExprKind::Name(n) if n == variable)
    {
        if !out.iter().any(|s| key::expr(s) == key::expr(e)) {
            out.push(e.clone());
        }
        return;
    }
    parts(e, &mut |part| sums_to(part, variable, out));
}

/// Puts a value in the place of an expression.
pub(super) fn replace(e: &mut Expr, old: &Expr, value: &Expr) {
    if key::expr(e) == key::expr(old) {
        *e = value.clone();
    } else {
        parts_mut(e, &mut |part| replace(part, old, value));
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;
    use malachite::base::num::basic::traits::Zero;

    #[test]
    fn sums_of_powers_are_those_that_are_added_up() {
        for j in 0..=DEGREE {
            let closed = sum_of_powers(j, 0).unwrap();
            let mut sum = Rational::ZERO;
            for n in 1..=12u32 {
                sum += Rational::from(u64::from(n).pow(u32::try_from(j).unwrap()));
                let coefficients = closed.coefficients_in(0);
                let value = coefficients
                    .iter()
                    .rev()
                    .fold(Rational::ZERO, |sum, c| sum * Rational::from(n) + c.as_constant().unwrap());
                assert_eq!(value, sum, "j = {j}, n = {n}");
            }
        }
    }
}
