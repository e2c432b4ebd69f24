//! The gcd by the subresultant remainder sequence: slow, and always right.
//!
//! Contract: [`gcd_in`] returns the primitive gcd of two polynomials that both contain the main
//! variable.
//!
//! Why it is right: by Gauss's lemma the gcd is the gcd of the contents times the gcd of the
//! primitive parts, and the last non-zero member of a pseudo-remainder sequence is, up to factors
//! free of the main variable, the gcd. The divisions by `g·h^δ` are exact (Collins; Brown and
//! Traub).

use super::super::{LimitReached, Polynomial, Var};
use super::{Budget, content_within, gcd_within};

/// The gcd of two polynomials in the main variable `var`.
pub(super) fn gcd_in(
    a: &Polynomial,
    b: &Polynomial,
    var: Var,
    budget: &mut Budget,
) -> Result<Polynomial, LimitReached> {
    let left = content_within(a, var, budget)?;
    let right = content_within(b, var, budget)?;
    let common = gcd_within(&left, &right, budget)?;
    let (p, q) = (without(a, &left, budget)?, without(b, &right, budget)?);
    let last = last_remainder(p, q, var, budget)?;
    if !last.contains(var) {
        return Ok(common);
    }
    let content = content_within(&last, var, budget)?;
    let primitive = without(&last, &content, budget)?;
    Ok(budget.mul(&common, &primitive)?.primitive_part().1)
}

/// The quotient by a divisor that is known to divide.
fn without(p: &Polynomial, divisor: &Polynomial, budget: &mut Budget) -> Result<Polynomial, LimitReached> {
    let quotient = budget.divide(p, divisor)?;
    Ok(quotient.expect("contents and the scaling of subresultants divide exactly"))
}

/// The last non-zero member of the subresultant sequence.
fn last_remainder(a: Polynomial, b: Polynomial, var: Var, budget: &mut Budget) -> Result<Polynomial, LimitReached> {
    let (mut p, mut q) = if a.degree_in(var) >= b.degree_in(var) { (a, b) } else { (b, a) };
    let (mut g, mut h) = (Polynomial::one(), Polynomial::one());
    loop {
        if q.is_zero() {
            return Ok(p);
        }
        if !q.contains(var) {
            return Ok(q);
        }
        let drop = p.degree_in(var) - q.degree_in(var);
        let remainder = pseudo_remainder(&p, &q, var, budget)?;
        let scale = budget.mul(&g, &h.pow(drop)?)?;
        let next = without(&remainder, &scale, budget)?;
        g = q.leading_coefficient_in(var);
        h = match drop {
            0 => h,
            1 => g.clone(),
            _ => without(&g.pow(drop)?, &h.pow(drop - 1)?, budget)?,
        };
        p = q;
        q = next;
    }
}

/// The remainder of `lc(q)^(δ+1)·p` by `q`, where δ is the difference of the degrees.
fn pseudo_remainder(p: &Polynomial, q: &Polynomial, var: Var, budget: &mut Budget) -> Result<Polynomial, LimitReached> {
    let divisor = q.coefficients_in(var);
    let mut rest = p.coefficients_in(var);
    let Some((lead, lower)) = divisor.split_last() else {
        return Ok(p.clone());
    };
    while rest.len() >= divisor.len() {
        let Some(top) = rest.pop() else { break };
        let shift = rest.len() + 1 - divisor.len();
        for (place, coefficient) in rest.iter_mut().enumerate() {
            let mut scaled = budget.mul(coefficient, lead)?;
            if let Some(part) = place.checked_sub(shift).and_then(|i| lower.get(i)) {
                scaled = scaled.sub(&budget.mul(&top, part)?);
            }
            *coefficient = scaled;
        }
    }
    Ok(Polynomial::from_coefficients_in(var, &rest))
}
