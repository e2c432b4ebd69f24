//! Upper bounds for the degrees of a gcd, from univariate images modulo a prime.
//!
//! Contract: [`degree_bounds`] gives for every variable a number that the degree of the gcd in that
//! variable cannot exceed.
//!
//! Why it is right: let `g` divide `a` and `b`, all with integer coefficients. Put residues for all
//! variables but one; the image of `g` divides both images. If the image of `a` keeps the degree of
//! `a`, the image of the leading coefficient of `a` is not 0, so neither is that of `g`, whose
//! leading coefficient divides it; so the image of `g` keeps the degree of `g`, and the gcd of the
//! images has at least this degree. The same holds with `b`. Where neither image keeps its degree
//! at any of the tried points, the bound is the smaller degree, which always holds.
//!
//! Cost: terms times variables squared, in machine words.

use super::super::residue::{PRIME, add, inverse, multiply, negate, power, residue};
use super::super::{Polynomial, Var};
use std::collections::BTreeMap;

/// How many points are tried for each variable.
const POINTS: u64 = 2;

/// For every variable an upper bound of the degree of `gcd(a, b)` in it; coefficients are integers.
pub(super) fn degree_bounds(a: &Polynomial, b: &Polynomial, vars: &[Var]) -> BTreeMap<Var, u32> {
    let left = residues(a);
    let right = residues(b);
    let bound = |var: Var| {
        let mut best = a.degree_in(var).min(b.degree_in(var));
        for attempt in 0..POINTS {
            let (p, full_p) = image(a, &left, var, attempt);
            let (q, full_q) = image(b, &right, var, attempt);
            if full_p || full_q {
                best = best.min(gcd_degree(p, q));
            }
            if best == 0 {
                break;
            }
        }
        (var, best)
    };
    vars.iter().map(|&var| bound(var)).collect()
}

/// The coefficients modulo the prime.
fn residues(p: &Polynomial) -> Vec<u64> {
    p.terms().map(|(_, c)| residue(c).unwrap_or(0)).collect()
}

/// The image in one variable, low coefficients first, and whether it keeps the degree.
fn image(p: &Polynomial, coefficients: &[u64], var: Var, attempt: u64) -> (Vec<u64>, bool) {
    let degree = p.degree_in(var) as usize;
    let mut image = vec![0; degree + 1];
    for ((monomial, _), &coefficient) in p.terms().zip(coefficients) {
        let mut value = coefficient;
        let mut place = 0;
        for &(v, exponent) in monomial.powers() {
            if v == var {
                place = exponent as usize;
            } else {
                value = multiply(value, power(point(v, attempt), u64::from(exponent)));
            }
        }
        image[place] = add(image[place], value);
    }
    let full = image[degree] != 0;
    (image, full)
}

/// A fixed, scattered residue for a variable: the splitmix64 sequence.
fn point(var: Var, attempt: u64) -> u64 {
    let seed = (u64::from(var) + 1).wrapping_add(attempt << 32);
    let mut z = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (z ^ (z >> 31)) % (PRIME - 2) + 2
}

/// The degree of the gcd of two images; 0 where both vanish is never asked for.
fn gcd_degree(mut p: Vec<u64>, mut q: Vec<u64>) -> u32 {
    trim(&mut p);
    trim(&mut q);
    while !q.is_empty() {
        remainder(&mut p, &q);
        std::mem::swap(&mut p, &mut q);
    }
    u32::try_from(p.len().saturating_sub(1)).unwrap_or(u32::MAX)
}

/// Reduces `p` modulo `q`, whose last coefficient is not 0.
fn remainder(p: &mut Vec<u64>, q: &[u64]) {
    let Some(&lead) = q.last() else { return };
    let inverse = inverse(lead);
    while p.len() >= q.len() {
        let shift = p.len() - q.len();
        let factor = multiply(p.last().copied().unwrap_or(0), inverse);
        for (i, &c) in q.iter().enumerate() {
            p[shift + i] = add(p[shift + i], negate(multiply(factor, c)));
        }
        p.pop();
        trim(p);
    }
}

fn trim(p: &mut Vec<u64>) {
    while p.last() == Some(&0) {
        p.pop();
    }
}
