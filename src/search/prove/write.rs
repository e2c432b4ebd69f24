//! The kernel's fractions as expressions of the claim language.

use super::{Certifier, Fail};
use crate::claim::syntax::*;
use crate::kernel::fraction::{Fraction, Poly, Work};
use crate::kernel::statement::{expr, name};
use crate::kernel::words::{self, whole_power};
use crate::prove::draft::translate::Atom;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// A numeral that is not negative.
fn numeral(n: &BigInt) -> Expr {
    expr(ExprKind::Number(n.to_string()))
}

/// A product and quotient of expressions.
pub(super) fn quotient(top: Vec<Expr>, bottom: Vec<Expr>) -> Expr {
    words::quotient(&BigRational::one(), top, bottom)
}

/// The opposite.
pub(super) fn negated(e: Expr) -> Expr {
    expr(ExprKind::Negate(Box::new(e)))
}

/// A name without a place, with its value.
pub(super) fn named(text: &str, value: &Expr) -> (Name, Expr) {
    (Name { text: text.to_string(), span: Span::default() }, value.clone())
}

/// The product of two fractions.
pub(crate) fn multiplied(a: &Fraction, b: &Fraction) -> Result<Fraction, Fail> {
    a.times(b, &Work::default()).map_err(Fail::from)
}

impl Certifier {
    /// A fraction.
    pub(crate) fn fraction_expr(&self, f: &Fraction) -> Result<Expr, Fail> {
        if f.is_zero() {
            return Ok(numeral(&BigInt::zero()));
        }
        let (mut top, mut bottom) = (Vec::new(), Vec::new());
        let size = f.coefficient.abs();
        if !size.numer().is_one() {
            top.push(numeral(size.numer()));
        }
        if !size.denom().is_one() {
            bottom.push(numeral(size.denom()));
        }
        for (poly, k) in &f.factors {
            let power = whole_power(self.poly_expr(poly)?, k.unsigned_abs());
            if *k > 0 { top.push(power) } else { bottom.push(power) }
        }
        let value = quotient(top, bottom);
        Ok(if f.coefficient.is_negative() { negated(value) } else { value })
    }

    /// A polynomial.
    pub(crate) fn poly_expr(&self, poly: &Poly) -> Result<Expr, Fail> {
        let mut terms = Vec::new();
        let mut list: Vec<_> = poly.terms().collect();
        // A positive term first reads better.
        list.sort_by_key(|(_, c)| c.is_negative());
        for (monomial, c) in list {
            let mut top = Vec::new();
            let size: BigRational = c.abs();
            let mut bottom = Vec::new();
            if !size.numer().is_one() {
                top.push(numeral(size.numer()));
            }
            if !size.denom().is_one() {
                bottom.push(numeral(size.denom()));
            }
            for (atom, k) in monomial {
                top.push(whole_power(self.atom_expr(*atom)?, u64::from(*k)));
            }
            let sign = if c.is_negative() { Sign::Minus } else { Sign::Plus };
            terms.push((sign, quotient(top, bottom)));
        }
        match terms.len() {
            0 => Ok(numeral(&BigInt::zero())),
            1 => {
                let (sign, single) = terms.remove(0);
                Ok(if sign == Sign::Minus { negated(single) } else { single })
            }
            _ => {
                if let Some((sign @ Sign::Minus, first)) = terms.first_mut() {
                    *sign = Sign::Plus;
                    *first = negated(first.clone());
                }
                Ok(expr(ExprKind::Sum(terms)))
            }
        }
    }

    /// An atom.
    pub(crate) fn atom_expr(&self, place: usize) -> Result<Expr, Fail> {
        if let Some((_, e)) = self.exponentials.iter().find(|x| x.0 == place) {
            return Ok(e.clone());
        }
        let apply = |function: &str, argument: Expr| {
            let function = Name { text: function.to_string(), span: Span::default() };
            expr(ExprKind::Apply(function, vec![argument]))
        };
        match self.checker.atom(place).cloned() {
            Some(Atom::Variable(text)) => Ok(name(&text)),
            Some(Atom::Bound(depth)) => Ok(name(&bound_name(depth))),
            Some(Atom::Member(family, index)) => Ok(apply(&family, self.poly_expr(&index)?)),
            Some(Atom::Logarithm(inner)) => Ok(apply("ln", self.poly_expr(&inner)?)),
            Some(Atom::Over(is_sum, depth, from, to, body)) => {
                let index = Index {
                    name: Name { text: bound_name(depth), span: Span::default() },
                    from: Box::new(self.poly_expr(&from)?),
                    to: Box::new(self.poly_expr(&to)?),
                };
                let body = Box::new(self.fraction_expr(&body)?);
                Ok(expr(if is_sum { ExprKind::SumOver(index, body) } else { ExprKind::ProductOver(index, body) }))
            }
            Some(Atom::Exponential(_)) | None => Err(Fail::No("a power that cannot be written")),
        }
    }
}

/// The name that stands for an index of sums and products.
pub(crate) fn bound_name(depth: usize) -> String {
    format!("index_{depth}")
}
