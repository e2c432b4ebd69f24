//! Integration by substitution: h(u)·u′ where u is a polynomial, a power of the variable, or moves by one function.

use super::antiderivatives::{factors, of, power_rule, raised};
use super::coefficients::*;
use super::facts::negated;
use super::letters::product;
use super::limits::{holds, over};
use super::slopes::put_in;
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, expr, name, numeral};
use crate::refute::literal::{is_zero, literal};
use malachite::Rational;

/// r·h(u)^k where r is u′·q(u): a polynomial u of degree 2 or more, or the logarithm of a linear one.
pub(super) fn by_substitution(list: &[(Expr, Expr)], x: &str, depth: usize) -> Option<Expr> {
    for (place, (base, exponent)) in list.iter().enumerate() {
        let others: Vec<&(Expr, Expr)> =
            list.iter().enumerate().filter(|(i, _)| *i != place).map(|(_, factor)| factor).collect();
        if let Some(value) = by_inner_function(base, exponent, &others, x) {
            return Some(value);
        }
        if let Some(value) = by_inner_polynomial(base, exponent, &others, x, depth) {
            return Some(value);
        }
        // ln(u)^k/w, where w is u, or both are multiples of the variable.
        if let (ExprKind::Apply(f, u), [(other, minus_one)]) = (&base.kind, others.as_slice())
            && let ("ln", [u], Some(-1)) = (f.text.as_str(), u.as_slice(), whole(minus_one))
            && let (Some(p), Some(q)) = (polynomial(u, x), polynomial(other, x))
            && p.len() == 2
            && q.len() == 2
            && (u == other || is_zero(&p[0]) && is_zero(&q[0]))
        {
            return Some(over(power_rule(base, exponent), q[1].clone()));
        }
    }
    (2..=4).rev().find_map(|k| by_power_of_the_variable(list, x, k, depth))
}

/// x^(k − 1 + k·m)·g(x^k) for a product g of powers of polynomials: the antiderivative of w^m·g(w)/k, at w = x^k.
fn by_power_of_the_variable(list: &[(Expr, Expr)], x: &str, k: usize, depth: usize) -> Option<Expr> {
    let (mut m, mut factors) = (1 - i64::try_from(k).ok()?, Vec::new());
    let w = (1..).map(|i| format!("w{i}")).find(|w| w != x && !list.iter().any(|(e, _)| holds(e, w)))?;
    for (base, exponent) in list {
        if matches!(&base.kind, ExprKind::Name(n) if n == x) {
            m += whole(exponent)?;
            continue;
        }
        let p = polynomial(base, x)?;
        if holds(exponent, x) || p.iter().enumerate().any(|(i, c)| i % k != 0 && !is_zero(c)) {
            return None;
        }
        let p: Coefficients = p.into_iter().step_by(k).collect();
        factors.push(raised(&written(&p, &name(&w)), exponent));
    }
    let k_as_whole = i64::try_from(k).ok()?;
    if m % k_as_whole != 0 || factors.is_empty() {
        return None;
    }
    factors.push(raised(&name(&w), &literal(&Rational::from(m / k_as_whole))));
    let found = of(&product(factors), &w, depth)?;
    let value = put_in(&found, &w, &raised(&name(x), &literal(&Rational::from(k_as_whole)))).ok()?;
    Some(over(value, literal(&Rational::from(k_as_whole))))
}

/// p(x)·h(u)^k where u is a polynomial of degree 2 or more and p is u′·q(u): the antiderivative of q(w)·h(w)^k, at w = u.
fn by_inner_polynomial(base: &Expr, exponent: &Expr, others: &[&(Expr, Expr)], x: &str, depth: usize) -> Option<Expr> {
    if holds(exponent, x) {
        return None;
    }
    let inner = match &base.kind {
        ExprKind::Apply(_, at) if polynomial(base, x).is_none() => at.first()?,
        _ => base,
    };
    let u = polynomial(inner, x).filter(|u| u.len() > 2)?;
    let q = composed(&product_of(others, x)?, &u)?;
    let taken = |w: &str| [base, exponent].iter().any(|e| holds(e, w)) || others.iter().any(|(e, _)| holds(e, w));
    let w = (1..).map(|k| format!("w{k}")).find(|w| w != x && !taken(w))?;
    let outer = match &base.kind {
        ExprKind::Apply(f, _) if inner != base => apply(&f.text, name(&w)),
        _ => name(&w),
    };
    let found = of(&product(vec![written(&q, &name(&w)), raised(&outer, exponent)]), &w, depth)?;
    put_in(&found, &w, inner).ok()
}

/// The product of whole powers of polynomials.
fn product_of(list: &[&(Expr, Expr)], x: &str) -> Option<Coefficients> {
    let mut all = vec![numeral(1)];
    for (base, k) in list {
        let k @ 1.. = whole(k)? else { return None };
        let factor = polynomial(base, x)?;
        for _ in 0..k {
            all = multiplied(&all, &factor)?;
        }
    }
    Some(all)
}

/// r·h(u)^k where u is made of one function of a linear argument and r is a multiple of u′.
fn by_inner_function(base: &Expr, exponent: &Expr, others: &[&(Expr, Expr)], x: &str) -> Option<Expr> {
    let (u, value) = match &base.kind {
        ExprKind::Apply(f, arguments) if f.text == "exp" && derivative_of_one(arguments.first()?, x).is_some() => {
            let k = literal(&Rational::from(whole(exponent)?));
            (arguments.first()?, over(raised(base, exponent), k))
        }
        _ if !holds(exponent, x) => (base, power_rule(base, exponent)),
        _ => return None,
    };
    let mut slope = Vec::new();
    factors(&derivative_of_one(u, x)?, &numeral(1), &mut slope);
    let (moving, still): (Vec<_>, Vec<_>) = slope.into_iter().partition(|(e, k)| holds(e, x) || holds(k, x));
    let same = moving.len() == others.len() && moving.iter().all(|factor| others.contains(&factor));
    same.then(|| over(value, product(still.iter().map(|(e, k)| raised(e, k)).collect())))
}

/// The derivative of an expression in which one function of a linear argument moves: p·g(v) and terms that are still.
fn derivative_of_one(u: &Expr, x: &str) -> Option<Expr> {
    match &u.kind {
        ExprKind::Sum(list) => {
            let mut moving = list.iter().filter(|(_, e)| holds(e, x));
            let (Some((sign, e)), None) = (moving.next(), moving.next()) else { return None };
            let slope = derivative_of_one(e, x)?;
            Some(if *sign == Sign::Plus { slope } else { negated(slope) })
        }
        ExprKind::Negate(e) => derivative_of_one(e, x).map(negated),
        ExprKind::Product(list) => {
            let place = list.iter().position(|(how, e)| *how == Factor::Times && holds(e, x))?;
            if list.iter().filter(|(_, e)| holds(e, x)).count() > 1 {
                return None;
            }
            let mut out = list.clone();
            out[place].1 = derivative_of_one(&list[place].1, x)?;
            Some(expr(ExprKind::Product(out)))
        }
        ExprKind::Apply(f, arguments) => {
            let [v] = arguments.as_slice() else { return None };
            let p = slope(v, x)?;
            let outer = match f.text.as_str() {
                "exp" => u.clone(),
                "ln" => over(numeral(1), v.clone()),
                "sin" => apply("cos", v.clone()),
                "cos" => negated(apply("sin", v.clone())),
                "sinh" => apply("cosh", v.clone()),
                "cosh" => apply("sinh", v.clone()),
                _ => return None,
            };
            Some(times(&p, &outer))
        }
        _ => None,
    }
}
