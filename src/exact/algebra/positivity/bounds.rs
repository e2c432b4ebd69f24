//! Proofs of positivity from bounds of single variables.
//!
//! Contract: the functions return combinations that hold by construction; the caller verifies them.
//!
//! Method: with a lower bound `x = a + s`, `s ≥ 0` (or `x = b − s` from an upper one) a polynomial whose
//! coefficients in the new variables are not negative is not negative. With both, `s = x − a` and
//! `t = b − x` have the constant sum `b − a`, and the polynomial is made homogeneous in `s, t`: its
//! coefficients are the Bernstein coefficients up to positive factors. A variable without bounds
//! must occur in even powers only.

use super::super::roots::{End, Interval};
use super::super::{Monomial, Polynomial, Var};
use super::{Certificate, Constraint, Summand};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::BTreeMap;

/// How far the degree in a variable is raised to make Bernstein coefficients positive.
const BERNSTEIN_RAISES: [u32; 3] = [0, 1, 3];

/// A constraint `slope·x + offset ≥ 0` on one variable.
#[derive(Clone)]
struct Bound {
    constraint: usize,
    /// Where the constraint is 0.
    at: Rational,
    /// The absolute value of the slope: the constraint is `size·s` for the distance `s` from `at`.
    size: Rational,
    strict: bool,
}

/// The tightest bounds of a variable.
#[derive(Clone, Default)]
struct Bounds {
    lower: Option<Bound>,
    upper: Option<Bound>,
}

/// The tightest bounds of a variable among the constraints that are linear in it alone.
fn bounds_of(constraints: &[Constraint], var: Var) -> Bounds {
    let mut bounds = Bounds::default();
    for (constraint, Constraint { poly, strict }) in constraints.iter().enumerate() {
        if poly.degree() != 1 || poly.variables() != [var] {
            continue;
        }
        let slope = poly.leading_coefficient();
        let at = -poly.constant_term() / &slope;
        let lower = slope > Rational::ZERO;
        let size = if lower { slope } else { -slope };
        let held = if lower { &mut bounds.lower } else { &mut bounds.upper };
        let tighter = held.as_ref().is_none_or(|old| {
            let order = if lower { at.cmp(&old.at) } else { old.at.cmp(&at) };
            order.is_gt() || order.is_eq() && *strict && !old.strict
        });
        if tighter {
            *held = Some(Bound { constraint, at, size, strict: *strict });
        }
    }
    bounds
}

/// The interval that the linear constraints on one variable cut out.
pub(super) fn interval(constraints: &[Constraint], var: Var) -> Interval {
    let end = |bound: Option<Bound>| match bound {
        None => End::Infinite,
        Some(Bound { at, strict: true, .. }) => End::Open(at),
        Some(Bound { at, .. }) => End::Closed(at),
    };
    let Bounds { lower, upper } = bounds_of(constraints, var);
    Interval { lower: end(lower), upper: end(upper) }
}

/// A combination from the signs of the coefficients after moving one bound of each variable to 0.
pub(super) fn by_coefficients(p: &Polynomial, constraints: &[Constraint]) -> Option<Certificate> {
    let mut moved = p.clone();
    let mut distances: BTreeMap<Var, Bound> = BTreeMap::new();
    for var in p.variables() {
        let Bounds { lower, upper } = bounds_of(constraints, var);
        let (bound, sign) = match (lower, upper) {
            (Some(lower), _) => (lower, Rational::ONE),
            (None, Some(upper)) => (upper, -Rational::ONE),
            (None, None) => continue,
        };
        if bound.at != Rational::ZERO || sign != Rational::ONE {
            let value = Polynomial::variable(var).scale(&sign).add(&Polynomial::constant(bound.at.clone()));
            moved = moved.substitute(var, &value).ok()?;
        }
        distances.insert(var, bound);
    }
    summands_of(&moved, &distances, constraints)
}

/// A combination from the Bernstein coefficients in the variables that have two bounds.
pub(super) fn by_bernstein(p: &Polynomial, constraints: &[Constraint]) -> Option<Certificate> {
    let vars = p.variables();
    let boxed = |var: &Var| {
        let bounds = bounds_of(constraints, *var);
        let (lower, upper) = (bounds.lower?, bounds.upper?);
        (lower.at < upper.at).then_some((*var, lower, upper))
    };
    let boxes: Vec<(Var, Bound, Bound)> = vars.iter().filter_map(boxed).collect();
    if boxes.is_empty() {
        return None;
    }
    BERNSTEIN_RAISES.iter().find_map(|&raise| {
        let mut moved = p.clone();
        let mut distances: BTreeMap<Var, Bound> = BTreeMap::new();
        // New variables for the distances to the upper bounds.
        let mut fresh = vars.iter().max()?.checked_add(1)?;
        for (var, lower, upper) in &boxes {
            moved = homogeneous(&moved, *var, fresh, lower, upper, raise)?;
            distances.insert(*var, lower.clone());
            distances.insert(fresh, upper.clone());
            fresh = fresh.checked_add(1)?;
        }
        for var in &vars {
            let Bounds { lower: Some(lower), upper: None } = bounds_of(constraints, *var) else {
                continue;
            };
            let value = Polynomial::variable(*var).add(&Polynomial::constant(lower.at.clone()));
            moved = moved.substitute(*var, &value).ok()?;
            distances.insert(*var, lower);
        }
        summands_of(&moved, &distances, constraints)
    })
}

/// `p` with `var` written in the distances `s` (again `var`) and `t` to its bounds, homogeneous in
/// them: `x = (a·t + b·s)/(b − a)` and `1 = (s + t)/(b − a)`.
fn homogeneous(p: &Polynomial, var: Var, fresh: Var, lower: &Bound, upper: &Bound, raise: u32) -> Option<Polynomial> {
    let inverse = Rational::ONE / (&upper.at - &lower.at);
    let (s, t) = (Polynomial::variable(var), Polynomial::variable(fresh));
    let value = t.scale(&lower.at).add(&s.scale(&upper.at)).scale(&inverse);
    let one = s.add(&t).scale(&inverse);
    let mut coefficients = p.coefficients_in(var);
    let degree = coefficients.len() + raise as usize;
    coefficients.resize(degree, Polynomial::zero());
    let mut sum = Polynomial::zero();
    let mut scale = Polynomial::one();
    for coefficient in coefficients.iter().rev() {
        sum = sum.try_mul(&value).ok()?.add(&coefficient.try_mul(&scale).ok()?);
        scale = scale.try_mul(&one).ok()?;
    }
    Some(sum)
}

/// The combination whose summands are the terms, where none is negative.
fn summands_of(
    moved: &Polynomial,
    distances: &BTreeMap<Var, Bound>,
    constraints: &[Constraint],
) -> Option<Certificate> {
    let mut summands = Vec::with_capacity(moved.term_count());
    for (monomial, coefficient) in moved.terms() {
        if *coefficient < Rational::ZERO {
            return None;
        }
        summands.push(summand_of(monomial, coefficient, distances)?);
    }
    Some(Certificate::combination(summands, constraints))
}

/// One term in the distances as a summand in the constraints.
fn summand_of(monomial: &Monomial, coefficient: &Rational, distances: &BTreeMap<Var, Bound>) -> Option<Summand> {
    let mut weight = coefficient.clone();
    let mut used = Vec::new();
    let mut squared = Vec::new();
    for &(var, exponent) in monomial.powers() {
        match distances.get(&var) {
            Some(bound) => {
                weight /= (&bound.size).pow(u64::from(exponent));
                used.push((bound.constraint, exponent));
            }
            None if exponent % 2 == 0 => squared.push((var, exponent / 2)),
            None => return None,
        }
    }
    let squares = match squared.is_empty() {
        true => Vec::new(),
        false => vec![Polynomial::monomial(Monomial::new(&squared).ok()?)],
    };
    Some(Summand { weight, constraints: used, squares })
}
