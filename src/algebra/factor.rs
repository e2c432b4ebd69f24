//! Factors of polynomials: square-free decomposition and the splittings that are cheap.
//!
//! Contract: unit · ∏ fᵢ^kᵢ is exactly the polynomial given, every fᵢ primitive with a positive
//! leading coefficient. The factors are pairwise distinct; they need not be irreducible.

use super::form::Limit;
use super::gcd::{content, gcd};
use super::polynomial::Polynomial;
use crate::number::rational::exact_root;
use malachite::Rational;

/// A factorisation.
#[derive(Clone, Debug, PartialEq)]
pub struct Factors {
    /// The rational factor.
    pub unit: Rational,
    /// The polynomials with their multiplicities.
    pub factors: Vec<(Polynomial, u32)>,
}

/// The factors that are found cheaply.
pub fn factor(p: &Polynomial) -> Result<Factors, Limit> {
    let (unit, primitive) = p.primitive();
    let mut factors: Vec<(Polynomial, u32)> = Vec::new();
    let mut push = |f: Polynomial, k: u32| {
        if f.as_constant().is_some() {
            return;
        }
        match factors.iter_mut().find(|g| g.0 == f) {
            Some(found) => found.1 += k,
            None => factors.push((f, k)),
        }
    };
    let common = primitive.common_monomial();
    let rest = primitive
        .quotient(&Polynomial::term(common.clone(), Rational::from(1)))
        .unwrap_or_else(|| primitive.clone());
    for (v, k) in common.powers() {
        push(Polynomial::variable(v), k);
    }
    for (part, multiplicity) in square_free(&rest)? {
        for piece in split(&part)? {
            push(piece, multiplicity);
        }
    }
    Ok(Factors { unit, factors })
}

/// Square-free parts with multiplicities (Yun's algorithm in each variable in turn); primitive.
pub fn square_free(p: &Polynomial) -> Result<Vec<(Polynomial, u32)>, Limit> {
    let p = p.primitive().1;
    let Some(&v) = p.variables().first() else { return Ok(Vec::new()) };
    let inner = content(&p, v)?;
    let mut out = if inner.as_constant().is_some() { Vec::new() } else { square_free(&inner)? };
    let f = p.quotient(&inner).unwrap_or(p);
    let derivative = f.derivative(v);
    let g = gcd(&f, &derivative)?;
    let (Some(mut b), Some(c)) = (f.quotient(&g), derivative.quotient(&g)) else { return Ok(vec![(f, 1)]) };
    let mut d = &c - &b.derivative(v);
    let mut k = 1;
    while b.as_constant().is_none() {
        let a = gcd(&b, &d)?;
        let (Some(next), Some(rest)) = (b.quotient(&a), d.quotient(&a)) else { break };
        b = next;
        d = &rest - &b.derivative(v);
        if a.as_constant().is_none() {
            out.push((a.primitive().1, k));
        }
        k += 1;
    }
    Ok(out)
}

/// The exact square root, if there is one.
pub fn square_root(p: &Polynomial) -> Result<Option<Polynomial>, Limit> {
    if p.is_zero() {
        return Ok(Some(Polynomial::zero()));
    }
    let (unit, primitive) = p.primitive();
    let Some(root) = exact_root(&unit, 2) else { return Ok(None) };
    let mut out = Polynomial::constant(root);
    let common = primitive.common_monomial();
    for (v, k) in common.powers() {
        if k % 2 == 1 {
            return Ok(None);
        }
        out = &out * &Polynomial::variable(v).power(k / 2);
    }
    let rest = primitive.quotient(&Polynomial::term(common, Rational::from(1))).unwrap_or_else(|| primitive.clone());
    for (part, multiplicity) in square_free(&rest)? {
        if multiplicity % 2 == 1 {
            return Ok(None);
        }
        out = &out * &part.power(multiplicity / 2);
    }
    Ok((&(&out * &out) == p).then_some(out))
}

/// Splits a square-free polynomial where that is cheap: factors free of a variable, quadratics in a
/// variable whose discriminant is a square.
fn split(p: &Polynomial) -> Result<Vec<Polynomial>, Limit> {
    for v in p.variables() {
        let inner = content(p, v)?;
        if inner.as_constant().is_none()
            && let Some(rest) = p.quotient(&inner)
        {
            let mut out = split(&inner)?;
            out.extend(split(&rest.primitive().1)?);
            return Ok(out);
        }
    }
    for v in p.variables() {
        if p.degree_in(v) != 2 || p.len() > 60 {
            continue;
        }
        let coefficients = p.coefficients_in(v);
        let [c, b, a] = coefficients.as_slice() else { continue };
        let discriminant = &(b * b) - &(a * c).scaled(&Rational::from(4));
        let Some(root) = square_root(&discriminant)? else { continue };
        // 4a·p = (2a v + b − root)(2a v + b + root)
        let line = |sign: i32| {
            let constant = if sign > 0 { b + &root } else { b - &root };
            Polynomial::from_coefficients_in(v, &[constant, a.scaled(&Rational::from(2))])
        };
        let candidate = line(1);
        let inner = content(&candidate, v)?;
        let factor = candidate.quotient(&inner).unwrap_or(candidate).primitive().1;
        if let Some(rest) = p.quotient(&factor)
            && rest.as_constant().is_none()
            && factor.as_constant().is_none()
        {
            let mut out = split(&factor)?;
            out.extend(split(&rest.primitive().1)?);
            return Ok(out);
        }
    }
    Ok(vec![p.primitive().1])
}
