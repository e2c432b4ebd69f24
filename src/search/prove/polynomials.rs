//! The kernel's polynomials as the engine's, and back.

use super::Fail;
use super::write::multiplied;
use crate::algebra::{Polynomial, factor};
use crate::kernel::fraction::{Fraction, Poly, Work};
use num_rational::BigRational;
use std::str::FromStr;

/// The kernel's polynomial as one of the engine's.
pub(crate) fn to_algebra(poly: &Poly) -> Result<Polynomial, Fail> {
    Ok(crate::refute::reading::to_algebra(poly).ok_or("too many atoms, or too high a degree")?)
}

/// The engine's polynomial as one of the kernel's.
pub(crate) fn from_algebra(p: &Polynomial) -> Result<Fraction, Fail> {
    let mut terms = Vec::new();
    for (monomial, c) in p.terms() {
        let c = BigRational::from_str(&c.to_string()).map_err(|_| "a number that cannot be read")?;
        let mut term = Fraction::number(c);
        for (atom, k) in monomial.powers() {
            term = multiplied(&term, &Fraction::atom(*atom as usize).power(i64::from(*k)).map_err(Fail::from)?)?;
        }
        terms.push(term);
    }
    Fraction::sum(&terms, &Work::default()).map_err(Fail::from)
}

/// The engine's polynomial, in factors.
pub(super) fn factored(p: &Polynomial) -> Result<Fraction, Fail> {
    let Ok(list) = factor::factor(p) else { return from_algebra(p) };
    let mut out =
        Fraction::number(BigRational::from_str(&list.unit.to_string()).map_err(|_| "a number that cannot be read")?);
    for (p, k) in &list.factors {
        out = multiplied(&out, &from_algebra(p)?.power(i64::from(*k)).map_err(Fail::from)?)?;
    }
    Ok(out)
}
