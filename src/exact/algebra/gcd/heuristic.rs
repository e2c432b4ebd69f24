//! Candidates for a gcd, read off the gcds of integers.
//!
//! Contract: [`candidate`] returns a primitive polynomial that is probably the gcd. It may be wrong;
//! the caller tests it.
//!
//! Method (Char, Geddes and Gonnet's heuristic): put a large integer `ξ` for one variable, find the
//! gcd of the values in the variables that are left (in the end, of integers), and read its balanced
//! `ξ`-adic digits as the coefficients of the gcd. `ξ` exceeds twice the coefficients of one
//! argument, so digits of a true divisor with small coefficients are read back correctly.
//!
//! Cost: the integers have up to `bits·Π(degree + 1)` bits; above [`MAX_HEURISTIC_BITS`] the guess is
//! not made.

use super::super::{LimitReached, Polynomial, Var};
use super::Budget;
use malachite::base::num::arithmetic::traits::{DivMod, Gcd, UnsignedAbs};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural, Rational};

/// The largest size of the integers whose gcd is taken.
const MAX_HEURISTIC_BITS: u64 = 1 << 19;

/// How many evaluation points are tried at each level.
const ATTEMPTS: u32 = 3;

/// A polynomial that is probably the gcd of two primitive polynomials with the given variables.
pub(super) fn candidate(
    a: &Polynomial,
    b: &Polynomial,
    vars: &[Var],
    budget: &mut Budget,
) -> Result<Option<Polynomial>, LimitReached> {
    let mut bits = a.height_bits().max(b.height_bits()) as u64 + 6;
    for &var in vars {
        bits = bits.saturating_mul(u64::from(a.degree_in(var).max(b.degree_in(var))) + 1);
    }
    if bits > MAX_HEURISTIC_BITS {
        return Ok(None);
    }
    Ok(guess(a, b, vars, budget)?.map(|g| g.primitive_part().1))
}

/// A common divisor over the integers, contents included, that is probably the greatest.
fn guess(
    a: &Polynomial,
    b: &Polynomial,
    vars: &[Var],
    budget: &mut Budget,
) -> Result<Option<Polynomial>, LimitReached> {
    let content = a.content().gcd(&b.content());
    let Some((&var, fewer)) = vars.split_last() else {
        return Ok(Some(Polynomial::constant(content)));
    };
    let inverse = Rational::ONE / &content;
    let (a, b) = (a.scale(&inverse), b.scale(&inverse));
    let smaller = norm(&a).min(norm(&b));
    let mut point = smaller * Natural::from(2u32) + Natural::from(29u32);
    for _ in 0..ATTEMPTS {
        let at = Rational::from(&point);
        let (left, right) = (a.evaluate_at(var, &at), b.evaluate_at(var, &at));
        if !left.is_zero() && !right.is_zero() {
            budget.spend(a.term_count() + b.term_count(), vars.len())?;
            if let Some(image) = guess(&left, &right, fewer, budget)? {
                let (_, read) = digits(image, var, &point).primitive_part();
                if !read.is_zero() && budget.divide(&a, &read)?.is_some() && budget.divide(&b, &read)?.is_some() {
                    return Ok(Some(read.scale(&content)));
                }
            }
        }
        // A ratio without small multiples, so that an unlucky point does not meet its relatives.
        point = point * Natural::from(73_794u32) / Natural::from(27_011u32) + Natural::ONE;
    }
    Ok(None)
}

/// The largest absolute value of a coefficient; the coefficients are integers.
fn norm(p: &Polynomial) -> Natural {
    p.terms().map(|(_, c)| c.numerator_ref().clone()).max().unwrap_or(Natural::ZERO)
}

/// The polynomial in `var` whose coefficients are the balanced digits of `image` to the base `point`.
fn digits(mut image: Polynomial, var: Var, point: &Natural) -> Polynomial {
    let mut coefficients = Vec::new();
    while !image.is_zero() {
        let digit = Polynomial::from_terms(image.terms().map(|(m, c)| (m.clone(), Rational::from(balanced(c, point)))));
        image = image.sub(&digit).scale(&Rational::from_naturals(Natural::ONE, point.clone()));
        coefficients.push(digit);
    }
    Polynomial::from_coefficients_in(var, &coefficients)
}

/// The residue of smallest absolute value modulo `point` of an integer.
fn balanced(c: &Rational, point: &Natural) -> Integer {
    let value = Integer::from_sign_and_abs(*c >= Rational::ZERO, c.numerator_ref().clone());
    let (_, rest) = value.div_mod(Integer::from(point));
    if rest.clone().unsigned_abs() * Natural::from(2u32) > *point { rest - Integer::from(point) } else { rest }
}
