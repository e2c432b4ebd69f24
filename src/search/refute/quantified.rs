//! Quantifiers at a point: whether `exists` and `for all` hold there.
//!
//! Contract: as in `truth`, only what is certain.
//!
//! Method: values that make the body true show `exists`. Where the body compares rational functions of one unknown (a real number, a
//! natural number, or the difference of two natural numbers), signs change at roots and poles alone, which Sturm's theorem
//! isolates: these and a number between any two of them decide, or the whole numbers up to a bound of them. A pole in the domain
//! leaves it open.
//!
//! Limits: [`QUANTIFIERS`] statements of one search, [`DEGREE`] and [`WHOLES`] of one statement.

use super::evaluate::Assignment;
use super::literal::literal;
use super::number::{Missing, Result};
use super::reading::{Reading, declaring};
use super::sample::example;
use crate::algebra::roots::{End, Interval, RealRoot};
use crate::algebra::{Polynomial, Univariate};
use crate::claim::definedness::{Need, needs, numerals};
use crate::claim::syntax::*;
use crate::claim::walk::parts;
use crate::kernel::names::free_names;
use crate::kernel::order::Signs;
use crate::kernel::statement::{domain, numeral};
use crate::kernel::substitution::Substitution;
use malachite::base::num::arithmetic::traits::Ceiling;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Rational};
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// The most statements that are decided in one search.
pub(super) const QUANTIFIERS: u32 = 1_000;

/// The largest degree of all polynomials together whose roots are isolated.
const DEGREE: u32 = 24;

/// The most whole numbers that are tried.
const WHOLES: i64 = 2_000;

impl Assignment {
    /// Whether there are values for which the body holds here.
    pub(super) fn exists(&self, bindings: &[Binding], body: &Prop) -> Result<bool> {
        let mut here = Substitution::default();
        for (name, value) in self.values.iter().chain(&self.indices) {
            here.replace(name, &literal(value));
        }
        let kind = PropKind::Exists(bindings.to_vec(), Box::new(body.clone()));
        let said = here.prop(&Prop { kind, span: body.span }).map_err(|_| Missing::Unknown)?;
        let mut names = BTreeSet::new();
        free_names(&said, &mut names);
        let is_known = names.iter().all(|n| n == PI && self.is_pi || is_built_in(n));
        let PropKind::Exists(bindings, body) = &said.kind else { return Err(Missing::Unknown) };
        let left = self.quantifiers.get().checked_sub(1).filter(|_| is_known).ok_or(Missing::Unknown)?;
        self.quantifiers.set(left);
        match decided(bindings, body) {
            None if example(bindings, body, self.until).is_some() => Ok(true),
            known => known.ok_or(Missing::Unknown),
        }
    }
}

/// Whether a body of polynomials in one unknown holds somewhere.
fn decided(bindings: &[Binding], body: &Prop) -> Option<bool> {
    let names: Vec<&str> = bindings.iter().flat_map(|b| &b.names).map(|n| n.0.text.as_str()).collect();
    let natural = bindings.iter().all(|b| b.natural);
    let parts: Vec<Prop> = bindings.iter().flat_map(domain).collect();
    let lowest = match names.len() {
        1 => Some(Integer::ZERO),
        2 if natural && parts.is_empty() => None,
        _ => return None,
    };
    if !natural && bindings.iter().any(|b| b.natural) {
        return None;
    }
    let domain = Prop { kind: PropKind::And(parts), span: body.span };
    let mut reading = Reading::of(&super::expand::Statement::of(&declaring(bindings)?).ok()?, bindings)?;
    let (mut differences, mut divisors) = (Vec::new(), Vec::new());
    for part in [&domain, body] {
        holds(part, &mut |a, b| {
            differences.push(difference(&mut reading, &names, a, b)?);
            [a, b].into_iter().try_for_each(|side| in_divisors(side, &mut divisors))?;
            Some(Ordering::Equal)
        })?;
    }
    let compared = differences.len();
    for divisor in &divisors {
        differences.push(difference(&mut reading, &names, divisor, &numeral(0))?);
    }
    let signed: Vec<Univariate> = differences.iter().map(|d| d.1.clone()).collect();
    let at = |signs: Vec<Ordering>| {
        let has_pole = signs.iter().skip(compared).any(|sign| sign.is_eq());
        let mut signs = signs.into_iter();
        match holds(&domain, &mut |_, _| signs.next())? {
            false => Some(false),
            true if has_pole => None,
            true => holds(body, &mut |_, _| signs.next()),
        }
    };
    let at_number = |x: &Rational| at(signed.iter().map(|p| p.sign_at(x)).collect());
    if natural {
        let roots = signed.iter().flat_map(Univariate::real_roots);
        let ends = roots.flat_map(|root| [-root.lower(), root.upper().clone()]);
        let bound = ends.max().unwrap_or(Rational::ZERO).ceiling() + Integer::ONE;
        let bound = Some(bound).filter(|bound| *bound <= WHOLES)?;
        let mut k = lowest.unwrap_or_else(|| -&bound);
        while k <= bound {
            if at_number(&Rational::from(&k))? {
                return Some(true);
            }
            k += Integer::ONE;
        }
        return Some(false);
    }
    let mut plain = differences.iter().map(|d| &d.0).filter(|p| !p.is_constant());
    let all = plain.try_fold(Polynomial::one(), |all, p| all.try_mul(p).ok())?;
    let letter = all.variables().first().copied().unwrap_or_default();
    let roots = Univariate::from_polynomial(&all, letter).filter(|_| all.degree() <= DEGREE)?.real_roots();
    let one = || Rational::ONE;
    let ends = roots.windows(2).map(|pair| (pair[0].upper() + pair[1].lower()) / Rational::from(2));
    let beyond = match (roots.first(), roots.last()) {
        (Some(first), Some(last)) => vec![first.lower() - one(), last.upper() + one()],
        _ => vec![Rational::ZERO],
    };
    for x in beyond.into_iter().chain(ends) {
        if at_number(&x)? {
            return Some(true);
        }
    }
    for root in &roots {
        let there = match root {
            RealRoot::Exact(x) => at_number(x)?,
            RealRoot::Between(a, b) => {
                let around = Interval { lower: End::Open(a.clone()), upper: End::Open(b.clone()) };
                let sign = |p: &Univariate| match p.root_count_in(&around) {
                    0 => p.sign_at(a),
                    _ => Ordering::Equal,
                };
                at(signed.iter().map(sign).collect())?
            }
        };
        if there {
            return Some(true);
        }
    }
    Some(false)
}

/// A polynomial in the one unknown with the sign of the difference of two sides, where their divisors are not 0.
fn difference(reading: &mut Reading, names: &[&str], a: &Expr, b: &Expr) -> Option<(Polynomial, Univariate)> {
    let (above, below) = reading.difference(a, b)?;
    let p = match below.as_constant() {
        Some(c) => above.scale(&Some(c).filter(|c| *c != 0)?),
        None => above.try_mul(&below).ok()?,
    };
    let mut letters = Vec::new();
    for letter in p.variables() {
        let ExprKind::Name(n) = reading.letter(letter).kind else { return None };
        names.contains(&n.as_str()).then(|| letters.push(letter))?;
    }
    let p = match letters.as_slice() {
        [] | [_] if names.len() == 1 => p,
        [] => p,
        // The same wherever both grow by the same: a polynomial in the difference.
        [x, y] if p.derivative(*x).add(&p.derivative(*y)).is_zero() => p.coefficients_in(*y).first()?.clone(),
        _ => return None,
    };
    let one = Univariate::from_polynomial(&p, letters.first().copied().unwrap_or_default())?;
    Some((p, one))
}

/// Adds the divisors of an expression that are no numerals; `None` where it may have no value for another reason.
fn in_divisors(e: &Expr, into: &mut Vec<Expr>) -> Option<()> {
    for need in needs(e, &|_| false).ok()? {
        let Need::NotZero(divisor) = need else { return None };
        if numerals(&divisor).ok().flatten().is_none_or(|n| n.sign == Ordering::Equal) {
            into.push(divisor);
        }
    }
    let mut all = Some(());
    parts(e, &mut |part| all = all.and_then(|()| in_divisors(part, into)));
    all
}

/// Whether a proposition holds where its comparisons have these signs of a - b; each is asked for once, in their order.
fn holds(p: &Prop, sign: &mut dyn FnMut(&Expr, &Expr) -> Option<Ordering>) -> Option<bool> {
    let mut each = |list: &[Prop]| list.iter().map(|p| holds(p, sign)).collect::<Option<Vec<bool>>>();
    Some(match &p.kind {
        PropKind::Compare(sides, relations) => {
            let mut all = true;
            for (pair, relation) in sides.windows(2).zip(relations) {
                let signs = match sign(&pair[0], &pair[1])? {
                    Ordering::Less => Signs::of(Relation::Less),
                    Ordering::Equal => Signs::ZERO,
                    Ordering::Greater => Signs::POSITIVE,
                };
                all &= signs.within(Signs::of(*relation));
            }
            all
        }
        PropKind::And(list) => !each(list)?.contains(&false),
        PropKind::Or(list) => each(list)?.contains(&true),
        PropKind::Equivalent(list) => each(list)?.windows(2).all(|pair| pair[0] == pair[1]),
        PropKind::Not(p) => !holds(p, sign)?,
        PropKind::Implies(p, q) => {
            let (premise, conclusion) = (holds(p, sign)?, holds(q, sign)?);
            !premise || conclusion
        }
        _ => return None,
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;
    use crate::claim::parse::parse;

    fn truth(said: &str) -> Result<bool> {
        let claim = parse(&format!("claim c \"t\"\nprove {said}\n")).unwrap().remove(0);
        Assignment::default().truth(&claim.goal)
    }

    #[test]
    fn a_quantifier_is_decided_at_roots_between_them_and_at_whole_numbers_alone() {
        for (said, holds) in [
            ("exists x real: x^2 = 2", true),
            ("exists x in (0, 1): x^2 = 2", false),
            ("exists x real: x^2 = 2 and x^3 = 2*x and x < 0", true),
            ("exists x real: x^2 = 2 and x^4 != 4", false),
            ("for all x real: x^4 - 4*x^2 + 4 >= 0", true),
            ("for all x real: x^4 - 4*x^2 + 4 > 0", false),
            ("exists x in [0, 1]: x >= 1", true),
            ("exists x in [0, 1): x >= 1", false),
            ("exists k natural: 4*k = 12", true),
            ("exists k natural: 4*k = 14", false),
            ("exists k natural: k + 3 = 0", false),
            ("exists i, j natural: 2*(i - j) = -6", true),
            ("exists i, j natural: 2*(i - j) = 5", false),
            ("for all k natural: k^2 > 10*k - 25", false),
            ("for all k natural: 4*k^2 != 1", true),
            ("exists x > 0: x/(1 + x) = 1", false),
            ("exists x > 0: x/(1 + x)^2 = 1/4", true),
            ("exists x in [0, 1/2]: 1 - x = 0", false),
            ("exists x < 0: 1/(x - 1) > 0", false),
            ("exists k natural: 1/(k + 1) = 1/7", true),
            ("exists k natural: 1/(2*k + 1) = 1/6", false),
        ] {
            assert_eq!(truth(said), Ok(holds), "{said}");
        }
        // Without a value somewhere, with two unknowns, and too far away.
        for said in [
            "for all x real: x/x = 1",
            "exists x in [0, 2]: 1/(x - 1) = 0",
            "for all x real: sqrt(x)^2 = x",
            "exists i, j natural: i + 2*j + 1 = 0",
        ] {
            assert_eq!(truth(said), Err(Missing::Unknown), "{said}");
        }
    }
}
