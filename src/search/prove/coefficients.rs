//! Polynomials in one variable as lists of coefficients that are free of it, from that of x^0 on. A list may have zeros that are not
//! seen to be zeros.

use super::facts::negated;
use super::letters::{natural, product, total, whole_power};
use super::limits::{holds, over};
use crate::claim::definedness::number;
use crate::claim::syntax::*;
use crate::kernel::statement::numeral;
use crate::refute::literal::{is_zero, literal};
use malachite::{Integer, Rational};

/// The highest degree.
pub(super) const DEGREE: usize = 12;

/// A polynomial in the variable.
pub(super) type Coefficients = Vec<Expr>;

/// The number that an expression made of numerals is, where it is short.
pub(super) fn rational(e: &Expr) -> Option<Rational> {
    let (top, bottom) = number(e)?;
    Some(Rational::from_integers(Integer::from(top), Integer::from(bottom)))
}

/// The whole number that an expression made of numerals is.
pub(super) fn whole(e: &Expr) -> Option<i64> {
    match number(e)? {
        (top, 1) => i64::try_from(top).ok(),
        _ => None,
    }
}

/// a·b, in which numbers are multiplied.
pub(super) fn times(a: &Expr, b: &Expr) -> Expr {
    match (rational(a), rational(b)) {
        (Some(a), Some(b)) => literal(&(a * b)),
        (Some(zero), _) | (_, Some(zero)) if zero == 0 => numeral(0),
        _ => product(vec![a.clone(), b.clone()]),
    }
}

/// The sum of a list, in which numbers are added.
pub(super) fn add(list: Vec<Expr>) -> Expr {
    let mut numbers = Rational::from(0);
    let mut terms = Vec::new();
    for e in list {
        match rational(&e) {
            Some(q) => numbers += q,
            None => terms.push((Sign::Plus, e)),
        }
    }
    if numbers != 0 {
        terms.push((Sign::Plus, literal(&numbers)));
    }
    total(terms)
}

/// An expression as a polynomial in x whose coefficients are free of x.
pub(super) fn polynomial(e: &Expr, x: &str) -> Option<Coefficients> {
    if !holds(e, x) {
        return Some(vec![e.clone()]);
    }
    match &e.kind {
        ExprKind::Name(_) => Some(vec![numeral(0), numeral(1)]),
        ExprKind::Negate(a) => Some(scaled(&polynomial(a, x)?, &negated(numeral(1)))),
        ExprKind::Sum(list) => {
            let mut out = Vec::new();
            for (sign, part) in list {
                let part = polynomial(part, x)?;
                let part = if *sign == Sign::Plus { part } else { scaled(&part, &negated(numeral(1))) };
                out = plus(&out, &part);
            }
            Some(out)
        }
        ExprKind::Product(list) => {
            let mut out = vec![numeral(1)];
            for (factor, part) in list {
                out = match factor {
                    Factor::Times => multiplied(&out, &polynomial(part, x)?)?,
                    Factor::Over if holds(part, x) => return None,
                    Factor::Over => scaled(&out, &over(numeral(1), part.clone())),
                };
            }
            Some(out)
        }
        ExprKind::Power(base, exponent) => {
            let k = natural(exponent).filter(|k| (*k as usize) <= DEGREE)?;
            let base = polynomial(base, x)?;
            (0..k).try_fold(vec![numeral(1)], |out, _| multiplied(&out, &base))
        }
        _ => None,
    }
}

/// c·p.
pub(super) fn scaled(p: &[Expr], c: &Expr) -> Coefficients {
    p.iter().map(|a| times(c, a)).collect()
}

/// p + q.
pub(super) fn plus(p: &[Expr], q: &[Expr]) -> Coefficients {
    let at = |list: &[Expr], i: usize| list.get(i).cloned().unwrap_or_else(|| numeral(0));
    (0..p.len().max(q.len())).map(|i| add(vec![at(p, i), at(q, i)])).collect()
}

/// p·q, where its degree is at most [`DEGREE`].
pub(super) fn multiplied(p: &[Expr], q: &[Expr]) -> Option<Coefficients> {
    if p.len() + q.len() > DEGREE + 2 {
        return None;
    }
    let terms = |k: usize| (0..=k).filter_map(|i| Some(times(p.get(i)?, q.get(k - i)?))).collect();
    Some((0..(p.len() + q.len()).saturating_sub(1)).map(|k| add(terms(k))).collect())
}

/// p′.
pub(super) fn derivative_of(p: &[Expr]) -> Coefficients {
    (1u32..).zip(p.iter().skip(1)).map(|(k, c)| times(&numeral(k), c)).collect()
}

/// The antiderivative that is 0 at 0.
pub(super) fn antiderivative_of(p: &[Expr]) -> Coefficients {
    let raised = (1u32..).zip(p).map(|(k, c)| times(c, &over(numeral(1), numeral(k))));
    std::iter::once(numeral(0)).chain(raised).collect()
}

/// p at x.
pub(super) fn written(p: &[Expr], x: &Expr) -> Expr {
    add(p.iter().enumerate().map(|(k, c)| times(c, &whole_power(x.clone(), i64::try_from(k).unwrap_or(0)))).collect())
}

/// The slope p of a linear expression p·x + q.
pub(super) fn slope(u: &Expr, x: &str) -> Option<Expr> {
    match polynomial(u, x)?.as_slice() {
        [_, p] => Some(p.clone()),
        _ => None,
    }
}

/// The quotient of a polynomial that is 0 at a place, by x − place.
pub(super) fn divided(p: &[Expr], place: &Expr) -> Coefficients {
    let mut out = Vec::new();
    let mut carried = numeral(0);
    for c in p.iter().skip(1).rev() {
        carried = add(vec![times(&carried, place), c.clone()]);
        out.push(carried.clone());
    }
    out.reverse();
    out
}

/// The coefficients of q where p = u′·q(u), by the highest ones. Of p only the powers are compared that are seen to be there.
pub(super) fn composed(p: &[Expr], u: &[Expr]) -> Option<Coefficients> {
    let (slope, degree) = (derivative_of(u), u.len().checked_sub(1).filter(|d| *d > 0)?);
    let lead = slope.last()?.clone();
    let highest = p.len().checked_sub(slope.len()).filter(|k| k % degree == 0)? / degree;
    let mut powers = vec![slope];
    for k in 0..highest {
        powers.push(multiplied(&powers[k], u)?);
    }
    let (mut rest, mut q) = (p.to_vec(), Vec::new());
    for (k, power) in powers.iter().enumerate().rev() {
        let top = rest.get(power.len() - 1)?.clone();
        let below = times(&lead, &whole_power(u.last()?.clone(), i64::try_from(k).ok()?));
        let c = if is_zero(&top) { numeral(0) } else { times(&top, &over(numeral(1), below)) };
        rest = plus(&rest, &scaled(power, &negated(c.clone())));
        rest.truncate(power.len() - 1);
        q.push(c);
    }
    q.reverse();
    // What is left is 0, or a sum of symbols that may be.
    let expected = powers.iter().zip(&q).fold(Vec::new(), |sum, (power, c)| plus(&sum, &scaled(power, c)));
    let open = |e: Option<&Expr>| e.is_some_and(|e| !is_zero(e));
    let fits = (0..p.len())
        .all(|i| open(p.get(i)) == open(expected.get(i)) || expected.get(i).is_some_and(|e| rational(e).is_none()));
    let left = rest.iter().all(|e| rational(e).is_none_or(|q| q == 0));
    (fits && left).then_some(q)
}
