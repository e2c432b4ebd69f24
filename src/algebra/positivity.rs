//! Certificates that a polynomial is positive, or not negative, where given polynomials are.
//!
//! Contract: [`certify`] returns a [`Certificate`] only after it has multiplied it out again, so a
//! returned one is a proof: under the constraints gⱼ ≥ 0 (strict ones gⱼ > 0) and the assumption
//! that p is *not* positive, a sum of products of non-negative quantities would be both 0 and
//! positive. `None` says nothing.
//!
//! Method: a search among products of constraints (with squares offered by the caller) for
//! non-negative λ with Σ λ·∏g ≡ 0, one λ of a strictly positive product not 0: an exact linear
//! program. In one variable Sturm's theorem decides outright.

use super::polynomial::{Monomial, Polynomial};
use super::simplex::feasible;
use super::univariate::{self, End};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::BTreeMap;

/// g ≥ 0, or g > 0 where strict.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraint {
    /// g.
    pub poly: Polynomial,
    /// Whether g > 0.
    pub strict: bool,
}

/// Bounds of the search.
#[derive(Clone, Debug)]
pub struct Limits {
    /// The most products tried at once.
    pub columns: usize,
    /// The most monomials among them.
    pub rows: usize,
    /// The most factors in a product.
    pub factors: usize,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits { columns: 220, rows: 120, factors: 2 }
    }
}

/// Why p has its sign.
#[derive(Clone, Debug, PartialEq)]
pub enum Certificate {
    /// Σ λ·∏ (constraints, by number; the number of constraints stands for the negated goal) ≡ 0.
    Combination(Vec<(Rational, Vec<usize>)>),
    /// Sturm's theorem in one variable on the interval that the constraints cut out.
    Sturm,
}

/// A certificate that p > 0 (`strict`) or p ≥ 0 where all the constraints hold.
pub fn certify(p: &Polynomial, constraints: &[Constraint], strict: bool, squares: &[Polynomial], limits: &Limits) -> Option<Certificate> {
    if let Some(true) = by_sturm(p, constraints, strict) {
        return Some(Certificate::Sturm);
    }
    if p.degree() > 12 || p.len() > 60 || p.variables().len() > 7 {
        return None;
    }
    // The negated goal: −p ≥ 0, or −p > 0.
    let mut all: Vec<Constraint> = constraints.to_vec();
    all.push(Constraint { poly: -p, strict: !strict });
    let goal = all.len() - 1;
    for square in squares {
        all.push(Constraint { poly: square * square, strict: false });
    }
    let mut tried = 0;
    for factors in 1..=limits.factors {
        let products = products(&all, factors, limits.columns, goal);
        if products.len() == tried {
            continue;
        }
        tried = products.len();
        if let Some(found) = combination(&all, &products, limits) {
            let certificate = Certificate::Combination(found);
            if verify(&certificate, &all) {
                return Some(certificate);
            }
        }
    }
    None
}

/// Whether a combination is a contradiction: it multiplies out to 0, has no negative λ, and one
/// positive λ stands before a product of strict constraints only.
fn verify(certificate: &Certificate, all: &[Constraint]) -> bool {
    let Certificate::Combination(list) = certificate else { return false };
    let mut sum = Polynomial::zero();
    let mut strict = false;
    for (weight, product) in list {
        if *weight < 0 {
            return false;
        }
        let mut term = Polynomial::constant(weight.clone());
        for &j in product {
            term = &term * &all[j].poly;
        }
        strict |= *weight > 0 && product.iter().all(|&j| all[j].strict);
        sum = &sum + &term;
    }
    sum.is_zero() && strict
}

/// Products to combine: at most `factors` of the constraints that are more than a variable, times
/// monomials in the variables known to be non-negative, no variable's degree above the goal's.
fn products(all: &[Constraint], factors: usize, most: usize, goal: usize) -> Vec<Vec<usize>> {
    let is_variable = |c: &Constraint| c.poly.len() == 1 && c.poly.degree() == 1;
    let variables: Vec<usize> = (0..all.len()).filter(|&j| j != goal && is_variable(&all[j])).collect();
    let others: Vec<usize> = (0..all.len()).filter(|j| !variables.contains(j)).collect();
    let bounds: BTreeMap<usize, u32> = variables
        .iter()
        .map(|&j| {
            let v = all[j].poly.variables()[0];
            let degree = all.iter().map(|c| c.poly.degree_in(v)).max().unwrap_or(1);
            (j, all[goal].poly.degree_in(v).max(degree).min(8))
        })
        .collect();
    let degree = all[goal].poly.degree().max(all.iter().map(|c| c.poly.degree()).max().unwrap_or(1));
    let mut monomials: Vec<Vec<usize>> = vec![Vec::new()];
    for &j in &variables {
        let mut longer = Vec::new();
        for monomial in &monomials {
            for k in 1..=bounds[&j] as usize {
                if monomial.len() + k > degree as usize || longer.len() > 4 * most {
                    break;
                }
                let mut next = monomial.clone();
                next.extend(std::iter::repeat_n(j, k));
                longer.push(next);
            }
        }
        monomials.extend(longer);
    }
    monomials.sort_by_key(Vec::len);
    let mut bases: Vec<Vec<usize>> = vec![Vec::new()];
    let mut layer = bases.clone();
    for _ in 0..factors {
        let mut next = Vec::new();
        for product in &layer {
            let from = product.last().copied().unwrap_or(0);
            for &j in others.iter().filter(|&&j| j >= from && !(j == goal && product.contains(&goal))) {
                let mut longer = product.clone();
                longer.push(j);
                next.push(longer);
            }
        }
        bases.extend(next.iter().cloned());
        layer = next;
        if bases.len() > most {
            break;
        }
    }
    let room = |base: &Vec<usize>, monomial: &Vec<usize>| {
        let size: u32 = base.iter().map(|&j| all[j].poly.degree()).sum();
        size as usize + monomial.len() <= degree as usize + factors - 1
    };
    let mut out = Vec::new();
    for monomial in &monomials {
        for base in &bases {
            if room(base, monomial) {
                let mut product = base.clone();
                product.extend(monomial);
                out.push(product);
            }
        }
        if out.len() > most {
            break;
        }
    }
    out.truncate(most);
    out
}

fn combination(all: &[Constraint], products: &[Vec<usize>], limits: &Limits) -> Option<Vec<(Rational, Vec<usize>)>> {
    let mut rows: BTreeMap<Monomial, usize> = BTreeMap::new();
    let mut columns = Vec::new();
    let mut kept = Vec::new();
    for product in products {
        let mut poly = Polynomial::one();
        for &j in product {
            poly = &poly * &all[j].poly;
        }
        if poly.len() > 200 {
            continue;
        }
        let mut column: Vec<(usize, Rational)> = Vec::new();
        for (monomial, c) in poly.terms() {
            let next = rows.len() + 1;
            let row = *rows.entry(monomial.clone()).or_insert(next);
            column.push((row, c.clone()));
        }
        // Row 0: the λ of strict products sum to 1.
        if product.iter().all(|&j| all[j].strict) {
            column.push((0, Rational::ONE));
        }
        columns.push(column);
        kept.push(product.clone());
        if rows.len() > limits.rows {
            return None;
        }
    }
    let count = rows.len() + 1;
    let mut right = vec![Rational::ZERO; count];
    right[0] = Rational::ONE;
    let solution = feasible(count, &columns, &right)?;
    Some(solution.into_iter().zip(kept).filter(|(weight, _)| *weight != 0).collect())
}

/// Sturm's theorem, where p has one variable: on the interval cut out by the linear constraints in it.
fn by_sturm(p: &Polynomial, constraints: &[Constraint], strict: bool) -> Option<bool> {
    let variables = p.variables();
    let [v] = variables.as_slice() else {
        return p.as_constant().map(|c| if strict { c > 0 } else { c >= 0 });
    };
    let dense: Vec<Rational> = p.coefficients_in(*v).iter().map(|c| c.as_constant()).collect::<Option<_>>()?;
    let (mut left, mut right) = (End::Infinite, End::Infinite);
    for constraint in constraints {
        if constraint.poly.variables() != [*v] || constraint.poly.degree() != 1 {
            continue;
        }
        let list = constraint.poly.coefficients_in(*v);
        let (Some(b), Some(a)) = (list[0].as_constant(), list[1].as_constant()) else { continue };
        let at = -b / &a;
        let end = if constraint.strict { End::Open(at.clone()) } else { End::Closed(at.clone()) };
        let tighter = |old: &End, larger: bool| match old {
            End::Infinite => true,
            End::Closed(x) => (if larger { at > *x } else { at < *x }) || (at == *x && constraint.strict),
            End::Open(x) => {
                if larger {
                    at > *x
                } else {
                    at < *x
                }
            }
        };
        if a > 0 {
            if tighter(&left, true) {
                left = end;
            }
        } else if tighter(&right, false) {
            right = end;
        }
    }
    Some(univariate::is_positive(&dense, &left, &right, strict))
}
