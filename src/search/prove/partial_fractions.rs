//! Integration of rational functions by partial fractions: over products of linear divisors, or over powers of one linear divisor
//! and a quadratic one.
//!
//! Method: a divisor l = p·x + q takes P(x) to its value at −q/p and a polynomial times l. Two divisors are separated by
//! p·m − p′·l = p·q′ − p′·q. A quadratic divisor is taken apart if it is a difference of squares or has rational roots; else it is
//! a sum of squares, and what stands over it is a part of its derivative and a number, whose integrals are a logarithm and an arctan.

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
    let mut quadratic: Option<Coefficients> = None;
    for (base, exponent) in list {
        let (k, p) = (whole(exponent)?, polynomial(base, x)?);
        if k.unsigned_abs() > DEGREE as u64 {
            return None;
        }
        for _ in 0..k {
            above = multiplied(&above, &p)?;
        }
        if k < 0 {
            let Some(list) = linear_factors(&p) else {
                if k != -1 || quadratic.is_some() || p.len() != 3 {
                    return None;
                }
                quadratic = Some(p);
                continue;
            };
            for l in list {
                match below.iter_mut().find(|known| known.0 == l) {
                    Some(known) => known.1 -= k,
                    None => below.push((l, -k)),
                }
            }
        }
    }
    let count: i64 = below.iter().map(|l| l.1).sum();
    if count > DIVISORS {
        return None;
    }
    match quadratic {
        Some(q) => beside_quadratic(above, below, &q, x),
        None => (count > 0).then(|| of_quotient(above, below, x)),
    }
}

/// The antiderivative of a polynomial A over linear divisors and a sum of squares Q: at the zero r of l = p·x + q,
/// A/(l·Q) = (A(r)/Q(r))/l + (A − A(r)/Q(r)·Q)/(l·Q), whose last numerator l divides.
fn beside_quadratic(above: Coefficients, mut below: Vec<Divisor>, q: &[Expr], x: &str) -> Option<Expr> {
    below.retain(|l| l.1 > 0);
    let Some(((l, k), others)) = below.split_last() else { return over_sum_of_squares(above, q, x) };
    if !others.is_empty() {
        return None;
    }
    let zero = negated(quotient(&l[0], &l[1]));
    let share = quotient(&at(&above, &zero), &at(q, &zero));
    let first = of_quotient(vec![share.clone()], vec![(l.clone(), *k)], x);
    let rest = plus(&above, &scaled(q, &negated(share)));
    let rest = scaled(&divided(&rest, &zero), &quotient(&numeral(1), &l[1]));
    Some(add(vec![first, beside_quadratic(rest, vec![(l.clone(), k - 1)], q, x)?]))
}

/// The antiderivative of A/Q for Q = a·x² + b·x + c: of a polynomial, a part of ln Q, and a part of arctan((2·a·x + b)/d)
/// with d² = 4·a·c − b².
fn over_sum_of_squares(mut above: Coefficients, q: &[Expr], x: &str) -> Option<Expr> {
    let [c, b, a] = q else { return None };
    let mut whole = vec![numeral(0); above.len()];
    while above.len() > 2 {
        let k = above.len() - 3;
        let lead = quotient(&above.pop()?, a);
        above[k] = add(vec![above[k].clone(), negated(times(&lead, c))]);
        above[k + 1] = add(vec![above[k + 1].clone(), negated(times(&lead, b))]);
        whole[k] = lead;
    }
    let half = literal(&Rational::from_signeds(1, 2));
    let (last, first) = (above.first()?.clone(), above.get(1).cloned().unwrap_or_else(|| numeral(0)));
    let of_logarithm = times(&half, &quotient(&first, a));
    // What is left beside the part of Q′.
    let rest = add(vec![last, negated(times(&of_logarithm, b))]);
    let (divisor, argument) = if is_zero(b) {
        let (((false, c), (false, a)) | ((true, c), (true, a))) = (signed(c), signed(a)) else { return None };
        let (below, inside) = (times(&root(&a), &root(&c)), quotient(&root(&a), &root(&c)));
        (if signed(q.last()?).0 { negated(below) } else { below }, times(&inside, &name(x)))
    } else {
        let (c, b, a) = (rational(c)?, rational(b)?, rational(a)?);
        let d = Rational::from(4) * &a * &c - &b * &b;
        if d <= 0 {
            return None;
        }
        let d = root(&literal(&d));
        let top = written(&[literal(&b), literal(&(Rational::from(2) * &a))], &name(x));
        (times(&half, &d), over(top, d))
    };
    let list = [
        written(&antiderivative_of(&whole), &name(x)),
        times(&of_logarithm, &apply("ln", positive(q, x))),
        times(&quotient(&rest, &divisor), &apply("arctan", argument)),
    ];
    Some(add(list.to_vec()))
}

/// A sum of squares, or its opposite, whichever is positive at 0.
fn positive(q: &[Expr], x: &str) -> Expr {
    let e = written(q, &name(x));
    if q.first().is_some_and(|c| signed(c).0) { negated(e) } else { e }
}

/// p at a place.
fn at(p: &[Expr], place: &Expr) -> Expr {
    p.iter().rev().fold(numeral(0), |sum, c| add(vec![times(&sum, place), c.clone()]))
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
            let value = at(&above, &zero);
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
pub(super) fn signed(e: &Expr) -> (bool, Expr) {
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
pub(super) fn root(e: &Expr) -> Expr {
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
