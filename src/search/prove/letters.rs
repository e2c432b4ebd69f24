//! Expressions as polynomials over letters: every atom of the kernel, such as a root or a sum over an index, is a letter.

use crate::algebra::{Monomial, Polynomial};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::statement::{expr, numeral, sum};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use num_rational::BigRational;
use std::collections::HashMap;
use std::str::FromStr;

/// The letters met so far, each with the expression that it stands for.
#[derive(Default)]
pub(super) struct Letters {
    exprs: Vec<Expr>,
    index: HashMap<String, u32>,
}

/// A number of the kernel as one of the engine.
pub(super) fn number(q: &BigRational) -> Option<Rational> {
    Rational::from_str(&q.to_string()).ok()
}

/// A natural numeral, where an expression is one.
pub(super) fn natural(e: &Expr) -> Option<u32> {
    match &e.kind {
        ExprKind::Number(text) => text.parse().ok(),
        _ => None,
    }
}

/// The product of expressions, without factors 1; 1 where there are none.
pub(super) fn product(mut list: Vec<Expr>) -> Expr {
    list.retain(|e| !matches!(&e.kind, ExprKind::Number(text) if text == "1"));
    match (list.len(), list.pop()) {
        (_, None) => numeral(1),
        (1, Some(one)) => one,
        (_, Some(last)) => {
            list.push(last);
            expr(ExprKind::Product(list.into_iter().map(|e| (Factor::Times, e)).collect()))
        }
    }
}

/// The sum of terms with signs; the first has none.
pub(super) fn total(mut terms: Vec<(Sign, Expr)>) -> Expr {
    terms.sort_by_key(|(sign, _)| *sign == Sign::Minus);
    if let Some((sign @ Sign::Minus, first)) = terms.first_mut() {
        *sign = Sign::Plus;
        *first = expr(ExprKind::Negate(Box::new(first.clone())));
    }
    match terms.as_slice() {
        [] => numeral(0),
        [(_, one)] => one.clone(),
        _ => sum(terms),
    }
}

/// The summands of an expression as they are written, sums of sums taken apart, with their signs.
pub(super) fn summands_of(e: &Expr, sign: Sign, out: &mut Vec<(Sign, Expr)>) {
    let turned = |own| if own == sign { Sign::Plus } else { Sign::Minus };
    match &e.kind {
        ExprKind::Sum(list) => list.iter().for_each(|(own, e)| summands_of(e, turned(*own), out)),
        ExprKind::Negate(inner) => summands_of(inner, turned(Sign::Minus), out),
        _ => out.push((sign, e.clone())),
    }
}

/// The base and exponent of a power; a root has the exponent 1/2 or 1/3.
pub(crate) fn as_power(e: &Expr) -> Option<(Expr, Expr)> {
    match &e.kind {
        ExprKind::Power(base, exponent) => Some(((**base).clone(), (**exponent).clone())),
        ExprKind::Apply(f, list) if matches!(f.text.as_str(), "sqrt" | "cbrt") => {
            let degree = numeral(if f.text == "sqrt" { 2 } else { 3 });
            let part = expr(ExprKind::Product(vec![(Factor::Times, numeral(1)), (Factor::Over, degree)]));
            list.first().map(|x| (x.clone(), part))
        }
        _ => None,
    }
}

/// An expression to a whole power.
pub(crate) fn whole_power(base: Expr, k: i64) -> Expr {
    let size = u32::try_from(k.unsigned_abs()).unwrap_or(u32::MAX);
    let power = if size == 1 { base } else { expr(ExprKind::Power(Box::new(base), Box::new(numeral(size)))) };
    match k {
        0 => numeral(1),
        1.. => power,
        _ => expr(ExprKind::Product(vec![(Factor::Times, numeral(1)), (Factor::Over, power)])),
    }
}

impl Letters {
    /// The letter that stands for an expression.
    pub(super) fn of(&mut self, e: &Expr) -> u32 {
        let next = u32::try_from(self.exprs.len()).unwrap_or(u32::MAX);
        let letter = *self.index.entry(key::expr(e)).or_insert(next);
        if letter == next {
            self.exprs.push(e.clone());
        }
        letter
    }

    /// Whether an expression is a letter.
    pub(super) fn knows(&self, e: &Expr) -> bool {
        self.index.contains_key(&key::expr(e))
    }

    /// What all letters stand for.
    pub(super) fn all(&self) -> Vec<Expr> {
        self.exprs.clone()
    }

    /// What a letter stands for.
    pub(super) fn expr(&self, letter: u32) -> Option<&Expr> {
        self.exprs.get(letter as usize)
    }

    /// A sum of monomials, as the kernel's view writes it.
    pub(super) fn polynomial(&mut self, e: &Expr) -> Option<Polynomial> {
        Some(match &e.kind {
            ExprKind::Number(text) => Polynomial::constant(number(&crate::kernel::numeral(text).ok()?)?),
            ExprKind::Negate(a) => self.polynomial(a)?.neg(),
            ExprKind::Sum(list) => {
                let mut sum = Polynomial::zero();
                for (sign, e) in list {
                    let term = self.polynomial(e)?;
                    sum = if *sign == Sign::Plus { sum.add(&term) } else { sum.sub(&term) };
                }
                sum
            }
            ExprKind::Product(list) => {
                let mut all = Polynomial::one();
                for (factor, e) in list {
                    let one = self.polynomial(e)?;
                    all = match factor {
                        Factor::Times => all.try_mul(&one).ok()?,
                        Factor::Over => {
                            let divisor = one.as_constant().filter(|c| *c != Rational::ZERO)?;
                            all.scale(&(Rational::ONE / divisor))
                        }
                    };
                }
                all
            }
            ExprKind::Power(base, exponent) => match natural(exponent) {
                Some(k) => self.polynomial(base)?.pow(k).ok()?,
                None => Polynomial::variable(self.of(e)),
            },
            _ => Polynomial::variable(self.of(e)),
        })
    }

    /// The numerator and the denominator of a quotient of sums of monomials, as it is written.
    pub(super) fn quotient(&mut self, e: &Expr) -> Option<(Polynomial, Polynomial)> {
        let times = |a: &Polynomial, b: &Polynomial| a.try_mul(b).ok();
        Some(match &e.kind {
            ExprKind::Negate(a) => {
                let (above, below) = self.quotient(a)?;
                (above.neg(), below)
            }
            ExprKind::Sum(list) => {
                let (mut above, mut below) = (Polynomial::zero(), Polynomial::one());
                for (sign, e) in list {
                    let (mut more, own) = self.quotient(e)?;
                    if *sign == Sign::Minus {
                        more = more.neg();
                    }
                    if own == below {
                        above = above.add(&more);
                        continue;
                    }
                    above = times(&above, &own)?.add(&times(&more, &below)?);
                    below = times(&below, &own)?;
                }
                (above, below)
            }
            ExprKind::Product(list) => {
                let (mut above, mut below) = (Polynomial::one(), Polynomial::one());
                for (factor, e) in list {
                    let (top, bottom) = self.quotient(e)?;
                    let (top, bottom) = if *factor == Factor::Times { (top, bottom) } else { (bottom, top) };
                    (above, below) = (times(&above, &top)?, times(&below, &bottom)?);
                }
                (above, below)
            }
            ExprKind::Power(base, exponent) if natural(exponent).is_some() => {
                let k = natural(exponent)?;
                let (above, below) = self.quotient(base)?;
                (above.pow(k).ok()?, below.pow(k).ok()?)
            }
            _ => (self.polynomial(e)?, Polynomial::one()),
        })
    }

    /// The rational number that an expression comes to, if it is one.
    pub(super) fn number(&mut self, e: &Expr) -> Option<Rational> {
        self.polynomial(e)?.as_constant()
    }

    /// A polynomial as an expression.
    pub(super) fn written(&self, p: &Polynomial) -> Expr {
        let mut terms: Vec<(Sign, Expr)> = Vec::new();
        for (monomial, c) in p.terms() {
            let sign = if *c < 0 { Sign::Minus } else { Sign::Plus };
            let size = if *c < 0 { -c } else { c.clone() };
            let mut list = Vec::new();
            if size != Rational::ONE || monomial.powers().is_empty() {
                list.push(literal(&size));
            }
            list.extend(self.monomial(monomial));
            terms.push((sign, product(list)));
        }
        total(terms)
    }

    fn monomial(&self, m: &Monomial) -> Vec<Expr> {
        m.powers().iter().filter_map(|(v, k)| Some(whole_power(self.expr(*v)?.clone(), i64::from(*k)))).collect()
    }
}
