//! Greatest common divisors of polynomials in several variables over the rationals.
//!
//! Contract: [`gcd`] returns *the* greatest common divisor, normalised to its primitive part (coprime
//! integer coefficients, leading coefficient positive); constants other than 0 have gcd 1 with
//! everything, and `gcd(0, a)` is the primitive part of `a`.
//!
//! Method, from the cheap to the certain:
//! 1. contents and monomials are taken out; a variable that only one argument has cannot occur in
//!    the gcd, so that argument is replaced by its coefficients;
//! 2. images modulo a prime in one variable at a time bound the degrees of the gcd (`modular`); a
//!    bound 0 takes the variable out, and often settles that the gcd is 1;
//! 3. when one argument is as small as the bounds allow, it is tried as a divisor; an argument
//!    linear in a variable is, up to content, irreducible and is tried as well;
//! 4. homogeneous polynomials lose a variable;
//! 5. a candidate is guessed from integer gcds (`heuristic`); it is accepted only if it divides
//!    both arguments and reaches every degree bound, which makes it the gcd: the cofactor that it
//!    might miss would have degree 0 in every variable;
//! 6. otherwise the subresultant remainder sequence decides (`subresultant`).
//!
//! ```
//! use carom_exact::algebra::{Polynomial, gcd::gcd};
//! let (x, y) = (Polynomial::variable(0), Polynomial::variable(1));
//! let squares = &(&x * &x) - &(&y * &y);
//! assert_eq!(gcd(&squares, &(&(&x + &y) * &y)), Ok(&x + &y));
//! ```
//!
//! Limits: products of terms and steps of divisions are counted over the whole call, up to [`MAX_GCD_WORK`].

mod heuristic;
mod modular;
mod subresultant;

use super::polynomial::within;
use super::{Limit, LimitReached, Monomial, Polynomial, Var};
use malachite::Rational;
use malachite::base::num::basic::traits::One;
use std::collections::BTreeMap;

/// The most products of two terms that one gcd may form; a product of long coefficients counts once
/// for every 64 bits.
pub const MAX_GCD_WORK: usize = 20_000_000;

/// What one computation may still spend.
pub(super) struct Budget {
    spent: usize,
}

impl Budget {
    /// A full budget.
    pub(super) fn new() -> Self {
        Self { spent: 0 }
    }

    /// Counts `left·right` products of terms.
    fn spend(&mut self, left: usize, right: usize) -> Result<(), LimitReached> {
        self.spent = self.spent.saturating_add(left.saturating_mul(right));
        within(Limit::Work, MAX_GCD_WORK, self.spent)
    }

    /// The product, paid for.
    fn mul(&mut self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, LimitReached> {
        let words = 1 + (a.height_bits() + b.height_bits()) / 64;
        self.spend(a.term_count().saturating_mul(words), b.term_count())?;
        a.try_mul(b)
    }

    /// The exact quotient, paid for.
    fn divide(&mut self, a: &Polynomial, b: &Polynomial) -> Result<Option<Polynomial>, LimitReached> {
        a.divide_counted(b, MAX_GCD_WORK, &mut self.spent)
    }
}

/// The greatest common divisor, primitive with positive leading coefficient; `gcd(0, 0) = 0`.
///
/// # Errors
/// [`LimitReached`] when the work passes [`MAX_GCD_WORK`] or an intermediate degree its limit.
pub fn gcd(a: &Polynomial, b: &Polynomial) -> Result<Polynomial, LimitReached> {
    gcd_within(a, b, &mut Budget::new())
}

/// The content with respect to one variable: the gcd of the coefficients, primitive.
///
/// # Errors
/// As for [`gcd`].
pub(crate) fn content_in(p: &Polynomial, var: Var) -> Result<Polynomial, LimitReached> {
    content_within(p, var, &mut Budget::new())
}

fn content_within(p: &Polynomial, var: Var, budget: &mut Budget) -> Result<Polynomial, LimitReached> {
    fold(Polynomial::zero(), p.coefficients_in(var), budget)
}

/// The gcd of `start` with every polynomial of the list, the smallest first.
fn fold(start: Polynomial, mut list: Vec<Polynomial>, budget: &mut Budget) -> Result<Polynomial, LimitReached> {
    list.retain(|p| !p.is_zero());
    list.sort_by_key(|p| (p.term_count(), p.degree()));
    list.dedup();
    let mut common = start;
    for polynomial in &list {
        if !common.is_zero() && common.is_constant() {
            break;
        }
        common = gcd_within(&common, polynomial, budget)?;
    }
    Ok(common)
}

/// Step 1: contents, monomials and the trivial cases.
fn gcd_within(a: &Polynomial, b: &Polynomial, budget: &mut Budget) -> Result<Polynomial, LimitReached> {
    if a.is_zero() {
        return Ok(b.primitive_part().1);
    }
    if b.is_zero() {
        return Ok(a.primitive_part().1);
    }
    if a.is_constant() || b.is_constant() {
        return Ok(Polynomial::one());
    }
    let (left, left_monomial) = reduced(a);
    let (right, right_monomial) = reduced(b);
    let monomial = left_monomial.gcd(&right_monomial);
    let rest = gcd_reduced(&left, &right, budget)?;
    Ok(rest.mul_monomial(&monomial))
}

/// The primitive part without its monomial content, and that monomial.
fn reduced(p: &Polynomial) -> (Polynomial, Monomial) {
    let (_, primitive) = p.primitive_part();
    let monomial = primitive.monomial_content();
    if monomial.is_one() {
        return (primitive, monomial);
    }
    let stripped = primitive
        .exact_divide(&Polynomial::monomial(monomial.clone()))
        .expect("the monomial content divides every term");
    (stripped, monomial)
}

/// Steps 1 to 6 for primitive polynomials without monomial content.
fn gcd_reduced(a: &Polynomial, b: &Polynomial, budget: &mut Budget) -> Result<Polynomial, LimitReached> {
    if a.is_constant() || b.is_constant() {
        return Ok(Polynomial::one());
    }
    if a == b {
        return Ok(a.clone());
    }
    // A primitive polynomial of degree 1 is irreducible.
    for (linear, other) in [(a, b), (b, a)] {
        if linear.degree() == 1 {
            let divides = budget.divide(other, linear)?.is_some();
            return Ok(if divides { linear.clone() } else { Polynomial::one() });
        }
    }
    let (left, right) = (a.variables(), b.variables());
    if let Some(&var) = left.iter().find(|v| !right.contains(v)) {
        return fold(b.clone(), a.coefficients_in(var), budget);
    }
    if let Some(&var) = right.iter().find(|v| !left.contains(v)) {
        return fold(a.clone(), b.coefficients_in(var), budget);
    }
    budget.spend(a.term_count() + b.term_count(), left.len())?;
    let bounds = modular::degree_bounds(a, b, &left);
    if bounds.values().all(|&bound| bound == 0) {
        return Ok(Polynomial::one());
    }
    if let Some((&var, _)) = bounds.iter().find(|&(_, &bound)| bound == 0) {
        let mut coefficients = a.coefficients_in(var);
        coefficients.extend(b.coefficients_in(var));
        return fold(Polynomial::zero(), coefficients, budget);
    }
    if reaches(a, &bounds) && budget.divide(b, a)?.is_some() {
        return Ok(a.clone());
    }
    if reaches(b, &bounds) && budget.divide(a, b)?.is_some() {
        return Ok(b.clone());
    }
    for &var in &left {
        if a.degree_in(var) == 1 {
            return gcd_with_linear(a, b, var, budget);
        }
        if b.degree_in(var) == 1 {
            return gcd_with_linear(b, a, var, budget);
        }
    }
    if left.len() > 1 && is_homogeneous(a) && is_homogeneous(b) {
        return gcd_homogeneous(a, b, &left, budget);
    }
    if let Some(candidate) = heuristic::candidate(a, b, &left, budget)?
        && reaches(&candidate, &bounds)
        && budget.divide(a, &candidate)?.is_some()
        && budget.divide(b, &candidate)?.is_some()
    {
        return Ok(candidate);
    }
    let main = left.iter().copied().min_by_key(|&var| a.degree_in(var).max(b.degree_in(var))).unwrap_or_default();
    subresultant::gcd_in(a, b, main, budget)
}

/// Whether all terms have the same degree.
fn is_homogeneous(p: &Polynomial) -> bool {
    p.terms().all(|(m, _)| m.degree() == p.degree())
}

/// The gcd of homogeneous polynomials without monomial content, with one variable put to 1.
///
/// Why it is right: divisors of a homogeneous polynomial are homogeneous, and for polynomials that
/// the variable does not divide, putting it to 1 keeps products and is undone by restoring degrees.
fn gcd_homogeneous(
    a: &Polynomial,
    b: &Polynomial,
    vars: &[Var],
    budget: &mut Budget,
) -> Result<Polynomial, LimitReached> {
    let gain = |&var: &Var| a.degree_in(var).min(b.degree_in(var));
    let var = vars.iter().copied().max_by_key(gain).unwrap_or_default();
    let one = Rational::ONE;
    let flat = gcd_within(&a.evaluate_at(var, &one), &b.evaluate_at(var, &one), budget)?;
    let degree = flat.degree();
    let restored = flat.terms().map(|(m, c)| {
        let missing = Monomial::small_power(var, degree - m.degree());
        (m.mul(&missing), c.clone())
    });
    Ok(Polynomial::from_terms(restored).primitive_part().1)
}

/// Whether a polynomial has exactly the given degrees.
fn reaches(p: &Polynomial, bounds: &BTreeMap<Var, u32>) -> bool {
    bounds.iter().all(|(&var, &bound)| p.degree_in(var) == bound)
}

/// The gcd where `a` has degree 1 in a variable.
///
/// Why it is right: `a = c·l` with the content `c` free of the variable and `l` primitive of degree
/// 1, hence irreducible. Either `l` divides `b`, and `gcd(a, b) = l·gcd(c, b/l)`, or it is coprime
/// to `b`, and `gcd(a, b) = gcd(c, b)`.
fn gcd_with_linear(a: &Polynomial, b: &Polynomial, var: Var, budget: &mut Budget) -> Result<Polynomial, LimitReached> {
    let content = content_within(a, var, budget)?;
    let linear = match budget.divide(a, &content)? {
        Some(quotient) => quotient.primitive_part().1,
        None => a.clone(),
    };
    match budget.divide(b, &linear)? {
        Some(quotient) => {
            let rest = gcd_within(&content, &quotient, budget)?;
            budget.mul(&linear, &rest)
        }
        None => gcd_within(&content, b, budget),
    }
}

#[cfg(test)]
mod tests {
    use super::{Budget, gcd, heuristic, modular, subresultant};
    use crate::algebra::{Monomial, Polynomial};
    use malachite::Rational;
    use proptest::prelude::*;

    /// Random polynomials in two variables with integer coefficients.
    fn polynomial() -> impl Strategy<Value = Polynomial> {
        prop::collection::vec((0u32..4, 0u32..4, -6i64..=6), 1..6).prop_map(|terms| {
            Polynomial::from_terms(terms.into_iter().map(|(a, b, n)| {
                let monomial = Monomial::new(&[(0, a), (1, b)]).expect("small degree");
                (monomial, Rational::from(n))
            }))
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn every_method_finds_the_same_gcd(p in polynomial(), a in polynomial(), b in polynomial()) {
            let (a, b) = (p.mul(&a).primitive_part().1, p.mul(&b).primitive_part().1);
            prop_assume!(a.contains(0) && b.contains(0) && a.contains(1) && b.contains(1));
            let expected = gcd(&a, &b).expect("small");
            let slow = subresultant::gcd_in(&a, &b, 0, &mut Budget::new()).expect("small");
            prop_assert_eq!(&slow, &expected);
            let flat = |p: &Polynomial| {
                let degree = p.degree();
                Polynomial::from_terms(p.terms().map(|(m, c)| {
                    let powers = [m.powers(), &[(5, degree - m.degree())]].concat();
                    (Monomial::new(&powers).expect("small degree"), c.clone())
                }))
            };
            let restored = gcd(&flat(&a), &flat(&b)).expect("small");
            // The leading term, whose sign is fixed, may be another one now.
            prop_assert_eq!(restored, flat(&expected).primitive_part().1);
            for (var, bound) in modular::degree_bounds(&a, &b, &[0, 1]) {
                prop_assert!(expected.degree_in(var) <= bound);
            }
            let guess = heuristic::candidate(&a, &b, &[0, 1], &mut Budget::new()).expect("small");
            if let Some(guess) = guess {
                prop_assert!(a.exact_divide(&guess).is_some() && b.exact_divide(&guess).is_some());
            }
        }
    }
}
