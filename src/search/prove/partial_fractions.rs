//! Integration of rational functions whose divisors are products of linear ones, by partial fractions.
//!
//! Method: a divisor l = p·x + q takes P(x) to its value at −q/p and a polynomial times l. Two divisors are separated by
//! p·m − p′·l = p·q′ − p′·q. A quadratic divisor is taken apart if it is a difference of squares or has rational roots.

use super::antiderivatives::power_rule;
use super::coefficients::*;
use super::facts::negated;
use super::letters::{natural, whole_power};
use super::limits::over;
use super::values::root_of;
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, expr, name, numeral};
use crate::refute::literal::{is_zero, literal};
use malachite::Rational;

/// The highest number of linear divisors, each as often as it divides.
const DIVISORS: i64 = 6;

/// A linear polynomial, and how often it divides.
type Divisor = (Coefficients, i64);

/// The antiderivative of a product of whole powers of polynomials, some of them negative.
pub(super) fn of_fraction(list: &[(Expr, Expr)], x: &str) -> Option<Expr> {
    let mut above = vec![numeral(1)];
    let mut below: Vec<Divisor> = Vec::new();
    for (base, exponent) in list {
        let (k, p) = (whole(exponent)?, polynomial(base, x)?);
        if k.unsigned_abs() > DEGREE as u64 {
            return None;
        }
        for _ in 0..k {
            above = multiplied(&above, &p)?;
        }
        if k < 0 {
            for l in linear_factors(&p)? {
                match below.iter_mut().find(|known| known.0 == l) {
                    Some(known) => known.1 -= k,
                    None => below.push((l, -k)),
                }
            }
        }
    }
    let count: i64 = below.iter().map(|l| l.1).sum();
    (1..=DIVISORS).contains(&count).then(|| of_quotient(above, below, x))
}

/// The antiderivative of a polynomial over linear divisors.
fn of_quotient(mut above: Coefficients, mut below: Vec<Divisor>, x: &str) -> Expr {
    while above.len() > 1 && above.last().is_some_and(is_zero) {
        above.pop();
    }
    below.retain(|l| l.1 > 0);
    let without = |place: usize| {
        let mut less = below.clone();
        less[place].1 -= 1;
        less
    };
    match (below.as_slice(), above.as_slice()) {
        ([], _) => written(&antiderivative_of(&above), &name(x)),
        ([(l, k)], [c]) => {
            let power = power_rule(&written(l, &name(x)), &literal(&Rational::from(-k)));
            times(c, &over(power, l[1].clone()))
        }
        ([(l, _), (m, _), ..], [c]) => {
            let between = add(vec![times(&l[1], &m[0]), negated(times(&m[1], &l[0]))]);
            let part = |slope: &Expr| vec![times(c, &quotient(slope, &between))];
            let first = of_quotient(part(&l[1]), without(1), x);
            add(vec![first, negated(of_quotient(part(&m[1]), without(0), x))])
        }
        ([(l, _), ..], _) => {
            let zero = negated(quotient(&l[0], &l[1]));
            let value = above.iter().rev().fold(numeral(0), |sum, c| add(vec![times(&sum, &zero), c.clone()]));
            let rest = scaled(&divided(&above, &zero), &quotient(&numeral(1), &l[1]));
            add(vec![of_quotient(rest, without(0), x), of_quotient(vec![value], below.clone(), x)])
        }
    }
}

/// a/b, of numbers as a number.
fn quotient(a: &Expr, b: &Expr) -> Expr {
    let whole = over(a.clone(), b.clone());
    rational(&whole).map_or(whole, |q| literal(&q))
}

/// Linear polynomials whose product a polynomial is.
fn linear_factors(p: &[Expr]) -> Option<Vec<Coefficients>> {
    match p {
        [_, slope] if !is_zero(slope) => Some(vec![p.to_vec()]),
        [zero, rest @ ..] if is_zero(zero) && rest.len() > 1 => {
            let mut list = linear_factors(rest)?;
            list.push(vec![numeral(0), numeral(1)]);
            Some(list)
        }
        [c, zero, a] if is_zero(zero) => match (signed(c), signed(a)) {
            // c − a·x² and a·x² − c
            ((false, c), (true, a)) => {
                let (c, a) = (root(&c), root(&a));
                Some(vec![vec![c.clone(), negated(a.clone())], vec![c, a]])
            }
            ((true, c), (false, a)) => {
                let (c, a) = (root(&c), root(&a));
                Some(vec![vec![negated(c.clone()), a.clone()], vec![c, a]])
            }
            _ => None,
        },
        [c, b, a] => {
            let (c, b, a) = (rational(c)?, rational(b)?, rational(a)?);
            let (root, true) = root_of(&(&b * &b - Rational::from(4) * &a * &c), 2)? else { return None };
            let linear = |q: Rational, p: Rational| vec![literal(&q), literal(&p)];
            let [first, second] = [&b - &root, &b + &root].map(|top| top / (Rational::from(2) * &a));
            Some(vec![linear(&a * first, a), linear(second, Rational::from(1))])
        }
        _ => None,
    }
}

/// Whether an expression is written as a negative one, and without its signs.
fn signed(e: &Expr) -> (bool, Expr) {
    match &e.kind {
        ExprKind::Negate(a) => {
            let (sign, size) = signed(a);
            (!sign, size)
        }
        ExprKind::Product(list) => {
            let (mut sign, mut out) = (false, Vec::new());
            for (how, factor) in list {
                let (own, size) = signed(factor);
                sign ^= own;
                if size != numeral(1) {
                    out.push((*how, size));
                }
            }
            if out.first().is_none_or(|f| f.0 == Factor::Over) {
                out.insert(0, (Factor::Times, numeral(1)));
            }
            match out.as_slice() {
                [(_, one)] => (sign, one.clone()),
                _ => (sign, expr(ExprKind::Product(out))),
            }
        }
        _ => (false, e.clone()),
    }
}

/// The square root of a positive expression, of squares as what is squared.
fn root(e: &Expr) -> Expr {
    if let Some((root, true)) = rational(e).and_then(|q| root_of(&q, 2)) {
        return literal(&root);
    }
    match &e.kind {
        ExprKind::Power(base, k) if natural(k).is_some_and(|k| k % 2 == 0) => {
            whole_power((**base).clone(), i64::from(natural(k).unwrap_or(0) / 2))
        }
        ExprKind::Product(list) => expr(ExprKind::Product(list.iter().map(|(how, e)| (*how, root(e))).collect())),
        _ => apply("sqrt", e.clone()),
    }
}
