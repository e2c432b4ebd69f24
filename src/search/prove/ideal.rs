//! Equations from equations: ideal membership, with the cofactors that show it.
//!
//! Method: Buchberger's algorithm in the graded order of the polynomials, each element of the basis with its cofactors in the
//! equations (Cox, Little, O'Shea, "Ideals, Varieties, and Algorithms", chapter 2). A goal p = 0 is divided by the basis; if
//! nothing is left, p is the sum of cofactors times equations. If something is left, p times a polynomial that is not 0 is tried.
//!
//! Limits: [`PAIRS`], [`TERMS`] and [`WORK`]; beyond them there is no answer.

use super::letters::{product, whole_power};
use super::products::{Kind, Known};
use super::{Fail, Prover};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use malachite::Rational;
use malachite::base::num::basic::traits::One;
use std::rc::Rc;

/// The most pairs of which an S-polynomial is taken.
const PAIRS: usize = 120;

/// The most terms of a polynomial or a cofactor.
const TERMS: usize = 400;

/// The most reductions by one polynomial.
const WORK: usize = 4_000;

/// The most equations that are taken.
const EQUATIONS: usize = 12;

/// A polynomial of the ideal with its cofactors in the equations.
#[derive(Clone)]
struct Member {
    poly: Polynomial,
    cofactors: Vec<Polynomial>,
}

impl Member {
    /// self − m·other.
    fn minus(&self, m: &Polynomial, other: &Member) -> Option<Member> {
        let less =
            |a: &Polynomial, b: &Polynomial| Some(a.sub(&b.try_mul(m).ok()?)).filter(|p| p.term_count() <= TERMS);
        let cofactors = self.cofactors.iter().zip(&other.cofactors).map(|(a, b)| less(a, b)).collect::<Option<_>>()?;
        Some(Member { poly: less(&self.poly, &other.poly)?, cofactors })
    }

    fn lead(&self) -> Option<(Monomial, Rational)> {
        self.poly.terms().next().map(|(m, c)| (m.clone(), c.clone()))
    }
}

/// What is left of a member by division by others, with the cofactors of what was taken off. Terms that no leading one divides
/// are left where `whole` says so; else the division stops at the first.
fn divided(mut p: Member, by: &[Member], whole: bool, work: &mut usize) -> Option<Member> {
    let mut left = Polynomial::zero();
    while let Some((m, c)) = p.lead() {
        *work = work.checked_sub(1)?;
        let step = by.iter().find_map(|g| {
            let (n, d) = g.lead()?;
            Some((g, Polynomial::term(m.checked_div(&n)?, &c / d)))
        });
        match step {
            Some((g, times)) => p = p.minus(&times, g)?,
            None if !whole => break,
            None => {
                let term = Polynomial::term(m, c);
                p.poly = p.poly.sub(&term);
                left = left.add(&term);
            }
        }
    }
    p.poly = p.poly.add(&left);
    Some(p)
}

/// A Gröbner basis of the ideal of these polynomials as far as the limits allow, with cofactors.
fn basis(equations: &[Polynomial], work: &mut usize) -> Vec<Member> {
    let count = equations.len();
    let unit = |i: usize| (0..count).map(|j| if i == j { Polynomial::one() } else { Polynomial::zero() }).collect();
    let mut out: Vec<Member> =
        equations.iter().enumerate().map(|(i, p)| Member { poly: p.clone(), cofactors: unit(i) }).collect();
    let mut pairs: Vec<(usize, usize)> = (0..count).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
    let mut taken = 0;
    while !pairs.is_empty() && taken < PAIRS {
        // The pair with the smallest common multiple first.
        let degree = |&(i, j): &(usize, usize)| match (out[i].lead(), out[j].lead()) {
            (Some((m, _)), Some((n, _))) => m.degree() + n.degree() - m.gcd(&n).degree(),
            _ => u32::MAX,
        };
        let Some(at) = (0..pairs.len()).min_by_key(|k| degree(&pairs[*k])) else { break };
        let (i, j) = pairs.swap_remove(at);
        taken += 1;
        let (Some((m, c)), Some((n, d))) = (out[i].lead(), out[j].lead()) else { continue };
        let common = m.gcd(&n);
        if common.is_one() {
            continue;
        }
        let (Some(up), Some(down)) = (n.checked_div(&common), m.checked_div(&common)) else { continue };
        let zero = Member { poly: Polynomial::zero(), cofactors: vec![Polynomial::zero(); count] };
        let s = zero
            .minus(&Polynomial::term(up, -(Rational::ONE / c)), &out[i])
            .and_then(|s| s.minus(&Polynomial::term(down, Rational::ONE / d), &out[j]));
        let Some(rest) = s.and_then(|s| divided(s, &out, false, work)) else { continue };
        if !rest.poly.is_zero() {
            pairs.extend((0..out.len()).map(|i| (i, out.len())));
            out.push(rest);
        }
    }
    out
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
        let mut work = WORK;
        let equations: Vec<Polynomial> = zeros.iter().map(|k| k.poly.clone()).collect();
        let basis = basis(&equations, &mut work);
        let mut multipliers = vec![Polynomial::one()];
        multipliers.extend(self.not_zero());
        for times in multipliers {
            let Ok(poly) = open.poly.try_mul(&times) else { continue };
            let none = vec![Polynomial::zero(); equations.len()];
            let mut work = WORK;
            let Some(left) = divided(Member { poly, cofactors: none }, &basis, true, &mut work) else { continue };
            if !left.poly.is_zero() {
                continue;
            }
            let mut terms = Vec::new();
            for (zero, cofactor) in zeros.iter().zip(&left.cofactors).filter(|z| !z.1.is_zero()) {
                let mut factors = vec![self.letters.written(&cofactor.neg())];
                factors.extend(open.rest.iter().chain(&zero.factors).cloned());
                if !times.is_one() {
                    factors.push(whole_power(self.letters.written(&times), -1));
                }
                terms.push(Term { facts: zero.facts.clone(), factor: product(factors) });
            }
            if let Ok(label) = self.combination(goal.clone(), terms) {
                return Ok(label);
            }
        }
        Err(no())
    }

    /// Polynomials that facts say are not 0, and products of two of them.
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
        out.truncate(4);
        let products: Vec<Polynomial> =
            out.iter().enumerate().flat_map(|(i, p)| out[i..].iter().filter_map(|q| p.try_mul(q).ok())).collect();
        out.extend(products);
        out
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    /// What the cofactors say a member is.
    fn sum(member: &Member, equations: &[Polynomial]) -> Polynomial {
        member.cofactors.iter().zip(equations).fold(Polynomial::zero(), |s, (c, p)| s.add(&c.mul(p)))
    }

    #[test]
    fn cofactors_give_every_member_of_a_basis() {
        let [x, y] = [0, 1].map(Polynomial::variable);
        let equations = [
            x.pow(2).unwrap().add(&y.pow(2).unwrap()).sub(&Polynomial::integer(5)),
            x.mul(&y).sub(&Polynomial::integer(2)),
        ];
        let mut work = WORK;
        let basis = basis(&equations, &mut work);
        assert!(basis.len() > 2, "the pair of both gives a third");
        for member in &basis {
            assert_eq!(sum(member, &equations), member.poly);
        }
        // (x² − y²)² = 9.
        let goal = x.pow(2).unwrap().sub(&y.pow(2).unwrap()).pow(2).unwrap().sub(&Polynomial::integer(9));
        let none = vec![Polynomial::zero(); 2];
        let left = divided(Member { poly: goal.clone(), cofactors: none }, &basis, true, &mut work).unwrap();
        assert!(left.poly.is_zero());
        assert_eq!(sum(&left, &equations).neg(), goal);
    }

    #[test]
    fn what_lies_outside_an_ideal_is_left_over() {
        let [x, y] = [0, 1].map(Polynomial::variable);
        let mut work = WORK;
        let basis = basis(&[x.sub(&y)], &mut work);
        let left = divided(Member { poly: x.add(&y), cofactors: vec![Polynomial::zero()] }, &basis, true, &mut work);
        assert!(!left.unwrap().poly.is_zero());
    }
}
