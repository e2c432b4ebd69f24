//! Greatest common divisors and pseudo-remainders of polynomials in several variables.
//!
//! Method: recursive primitive remainder sequences: contents with respect to the main variable are
//! gcds in fewer variables, the primitive parts go through pseudo-division. Every step is exact; a
//! sequence whose members grow past [`TERMS_LIMIT`] is given up and reported as a limit.

use super::form::Limit;
use super::polynomial::Polynomial;

/// The most terms of a member of a remainder sequence.
pub const TERMS_LIMIT: usize = 3_000;

/// The greatest common divisor, primitive with a positive leading coefficient; 0 only for 0 and 0.
pub fn gcd(a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Limit> {
    if a.is_zero() {
        return Ok(b.primitive().1);
    }
    if b.is_zero() {
        return Ok(a.primitive().1);
    }
    let (a, b) = (a.primitive().1, b.primitive().1);
    if a == b {
        return Ok(a);
    }
    let in_a = a.variables();
    let in_b = b.variables();
    let Some(&v) = in_a.iter().find(|v| in_b.contains(v)) else { return Ok(Polynomial::one()) };
    // A variable of one only: the gcd divides each coefficient in it.
    if let Some(&w) = in_a.iter().find(|w| !in_b.contains(w)) {
        return gcd(&content(&a, w)?, &b);
    }
    if let Some(&w) = in_b.iter().find(|w| !in_a.contains(w)) {
        return gcd(&a, &content(&b, w)?);
    }
    let (content_a, content_b) = (content(&a, v)?, content(&b, v)?);
    let common = gcd(&content_a, &content_b)?;
    let mut p = a.quotient(&content_a).unwrap_or(a);
    let mut q = b.quotient(&content_b).unwrap_or(b);
    if p.degree_in(v) < q.degree_in(v) {
        std::mem::swap(&mut p, &mut q);
    }
    while !q.is_zero() && q.degree_in(v) > 0 {
        let r = pseudo_remainder(&p, &q, v)?;
        p = q;
        q = if r.is_zero() {
            r
        } else {
            let c = content(&r, v)?;
            r.quotient(&c).unwrap_or(r).primitive().1
        };
    }
    let last = if q.is_zero() { p } else { Polynomial::one() };
    Ok((&last * &common).primitive().1)
}

/// The gcd of the coefficients with respect to a variable.
pub fn content(p: &Polynomial, v: u32) -> Result<Polynomial, Limit> {
    let mut coefficients: Vec<Polynomial> = p.coefficients_in(v).into_iter().filter(|c| !c.is_zero()).collect();
    coefficients.sort_by_key(Polynomial::len);
    let mut out = Polynomial::zero();
    for coefficient in &coefficients {
        out = gcd(&out, coefficient)?;
        if out.as_constant().is_some() {
            return Ok(Polynomial::one());
        }
    }
    Ok(out)
}

/// The remainder r of lᵏ·p by q in v, where l is q's leading coefficient in v and k is as small as
/// the division allows: p = 0 and q = 0 imply r = 0, and p − r·(…) is a multiple of q up to lᵏ.
pub fn pseudo_remainder(p: &Polynomial, q: &Polynomial, v: u32) -> Result<Polynomial, Limit> {
    let degree = q.degree_in(v);
    let coefficients = q.coefficients_in(v);
    let Some(lead) = coefficients.last() else { return Ok(p.clone()) };
    let mut rest = p.clone();
    while !rest.is_zero() && rest.degree_in(v) >= degree {
        let k = rest.degree_in(v);
        let top = rest.coefficients_in(v).pop().unwrap_or_default();
        let mut shifted = vec![Polynomial::zero(); (k - degree) as usize];
        shifted.push(top);
        let multiple = &Polynomial::from_coefficients_in(v, &shifted) * q;
        rest = &(&rest * lead) - &multiple;
        if rest.len() > TERMS_LIMIT {
            return Err(Limit("terms"));
        }
        if degree == 0 && rest.degree_in(v) == k && !rest.is_zero() {
            return Ok(rest);
        }
    }
    Ok(rest)
}
