//! Proofs of positivity by a linear program over products of constraints and squares.
//!
//! Contract: [`by_products`] returns a combination `p = Σ λ·∏ gⱼ^αⱼ·s²` with products up to a degree,
//! or `None` when there is none among the products tried or a limit stopped the search.
//!
//! Why products suffice: on a compact polytope with interior every positive polynomial is such a
//! combination of products of its linear constraints for some degree (Handelman); with squares the
//! same holds on every compact set of polynomial constraints (Schmüdgen). The degree that is needed
//! is not known, so a failure proves nothing.

use super::super::simplex::{Column, SimplexLimits, solve};
use super::super::{Monomial, Polynomial, Var};
use super::{Certificate, Constraint, Limits, Summand};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use rustc_hash::FxHashMap as HashMap;
use std::collections::BTreeMap;

/// A product that the program may use.
struct Candidate {
    poly: Polynomial,
    constraints: Vec<(usize, u32)>,
    square: Option<Polynomial>,
    positive: bool,
}

/// The squares that are tried without being asked for: variables, and their differences from each
/// other and from 1.
pub(super) fn usual_squares(p: &Polynomial) -> Vec<Polynomial> {
    let vars: Vec<Polynomial> = p.variables().into_iter().map(Polynomial::variable).collect();
    let mut squares = vars.clone();
    for (i, x) in vars.iter().enumerate() {
        squares.extend(vars[i + 1..].iter().map(|y| x.sub(y)));
        squares.push(x.sub(&Polynomial::one()));
    }
    squares
}

/// A combination of products of degree at most `degree`.
pub(super) fn by_products(
    p: &Polynomial,
    constraints: &[Constraint],
    squares: &[Polynomial],
    want_strict: bool,
    degree: u32,
    limits: &Limits,
) -> Option<Certificate> {
    let candidates = candidates(p, constraints, squares, degree, limits.columns);
    let mut places: BTreeMap<&Monomial, usize> = BTreeMap::new();
    for (monomial, _) in p.terms().chain(candidates.iter().flat_map(|c| c.poly.terms())) {
        let next = places.len();
        places.entry(monomial).or_insert(next);
    }
    if places.len() > limits.rows {
        return None;
    }
    let column =
        |q: &Polynomial| -> Column { q.terms().filter_map(|(m, c)| Some((*places.get(m)?, c.clone()))).collect() };
    let columns: Vec<Column> = candidates.iter().map(|c| column(&c.poly)).collect();
    let mut target = vec![Rational::ZERO; places.len()];
    for (place, value) in column(p) {
        target[place] = value;
    }
    let positive: Vec<bool> = candidates.iter().map(|c| c.positive).collect();
    let preferred = want_strict.then_some(positive.as_slice());
    let cost = SimplexLimits { pivots: limits.pivots, work: limits.work };
    let weights = solve(&columns, &target, preferred, &cost).ok()??;
    let summands = candidates
        .into_iter()
        .zip(weights)
        .filter(|(_, weight)| *weight != Rational::ZERO)
        .map(|(candidate, weight)| Summand {
            weight,
            constraints: candidate.constraints,
            squares: candidate.square.into_iter().collect(),
        })
        .collect();
    Some(Certificate::combination(summands, constraints))
}

/// Products of constraints, alone and with one square, up to a degree: all of low degree before those
/// of higher degree, up to the given number.
fn candidates(
    p: &Polynomial,
    constraints: &[Constraint],
    squares: &[Polynomial],
    degree: u32,
    most: usize,
) -> Vec<Candidate> {
    let vars = p.variables();
    let relevant = relevant_constraints(constraints, vars);
    let mut products =
        vec![Candidate { poly: Polynomial::one(), constraints: Vec::new(), square: None, positive: true }];
    // Each product is extended by its last constraint or a later one, so that none is met twice;
    // the list grows while it is walked.
    let mut seen: HashMap<Polynomial, usize> = HashMap::default();
    let mut next = 0;
    while next < products.len() && products.len() < most {
        let first = products[next].constraints.last().map_or(0, |&(j, _)| j);
        for &j in relevant.iter().filter(|&&j| j >= first) {
            let base = &products[next];
            let g = &constraints[j];
            if g.poly.degree() == 0 || base.poly.degree() + g.poly.degree() > degree {
                continue;
            }
            let Ok(poly) = base.poly.try_mul(&g.poly) else {
                continue;
            };
            let mut used = base.constraints.clone();
            match used.last_mut() {
                Some(last) if last.0 == j => last.1 += 1,
                _ => used.push((j, 1)),
            }
            let positive = base.positive && g.strict;
            let extended = Candidate { poly, constraints: used, square: None, positive };
            push_distinct(&mut products, &mut seen, extended);
        }
        next += 1;
    }
    let plain = products.len();
    for square in squares {
        let Ok(squared) = square.pow(2) else { continue };
        for index in 0..plain {
            let base = &products[index];
            if products.len() >= most || squared.degree() + base.poly.degree() > degree {
                continue;
            }
            let Ok(poly) = base.poly.try_mul(&squared) else {
                continue;
            };
            let extended = Candidate {
                poly,
                constraints: base.constraints.clone(),
                square: Some(square.clone()),
                positive: false,
            };
            push_distinct(&mut products, &mut seen, extended);
        }
    }
    products
}

/// Adds a candidate unless a multiple of it is there already; a positive one takes its place.
fn push_distinct(products: &mut Vec<Candidate>, seen: &mut HashMap<Polynomial, usize>, candidate: Candidate) {
    let content = candidate.poly.content();
    if content == Rational::ZERO {
        return;
    }
    let key = candidate.poly.scale(&(Rational::ONE / content));
    match seen.get(&key) {
        None => {
            seen.insert(key, products.len());
            products.push(candidate);
        }
        Some(&index) if candidate.positive && !products[index].positive => {
            products[index] = candidate;
        }
        Some(_) => {}
    }
}

/// The constraints linked to the variables of the polynomial, directly or through one another.
fn relevant_constraints(constraints: &[Constraint], mut vars: Vec<Var>) -> Vec<usize> {
    let mut relevant = vec![false; constraints.len()];
    loop {
        let before = vars.len();
        for (mark, constraint) in relevant.iter_mut().zip(constraints) {
            let own = constraint.poly.variables();
            if !*mark && own.iter().any(|v| vars.contains(v)) {
                *mark = true;
                vars.extend(own);
            }
        }
        vars.sort_unstable();
        vars.dedup();
        if vars.len() == before {
            break;
        }
    }
    (0..constraints.len()).filter(|&j| relevant[j]).collect()
}
