//! Antiderivatives of elementary functions: a proposal, which the kernel's derivative confirms.
//!
//! Method: sums by parts; what is free of the variable stays; powers, exponentials, logarithms, sines and cosines of a linear
//! argument by the table; polynomials times one of them by parts; products of powers of a sine and a cosine by their reductions;
//! h(u)·u′ by substitution, where u is a polynomial or moves by one function. Polynomials in the variable are lists of
//! coefficients, from that of x^0 on. A list may have zeros that are not seen to be zeros: then the proposal fails, and nothing
//! is lost.
//!
//! Reference: M. Bronstein, Symbolic Integration I, Springer 2005, chapters 1 and 5, for what goes beyond this.

use super::facts::negated;
use super::letters::{as_power, natural, product, total, whole_power};
use super::limits::{holds, over};
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, expr, name, numeral, power};
use crate::refute::literal::{is_zero, literal};
use malachite::Rational;

/// The highest degree of a polynomial, and the highest power of a sine or cosine.
const DEGREE: usize = 12;
/// How deep products are taken apart.
const DEPTH: usize = 8;

/// A polynomial in the variable.
type Coefficients = Vec<Expr>;

fn times(a: &Expr, b: &Expr) -> Expr {
    if is_zero(a) || is_zero(b) { numeral(0) } else { product(vec![a.clone(), b.clone()]) }
}

fn add(list: Vec<Expr>) -> Expr {
    let list: Vec<Expr> = list.into_iter().filter(|e| !is_zero(e)).collect();
    total(list.into_iter().map(|e| (Sign::Plus, e)).collect())
}

/// An expression as a polynomial in x whose coefficients are free of x.
fn polynomial(e: &Expr, x: &str) -> Option<Coefficients> {
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

fn scaled(p: &[Expr], c: &Expr) -> Coefficients {
    p.iter().map(|a| times(c, a)).collect()
}

fn plus(p: &[Expr], q: &[Expr]) -> Coefficients {
    let at = |list: &[Expr], i: usize| list.get(i).cloned().unwrap_or_else(|| numeral(0));
    (0..p.len().max(q.len())).map(|i| add(vec![at(p, i), at(q, i)])).collect()
}

fn multiplied(p: &[Expr], q: &[Expr]) -> Option<Coefficients> {
    if p.len() + q.len() > DEGREE + 2 {
        return None;
    }
    let terms = |k: usize| (0..=k).filter_map(|i| Some(times(p.get(i)?, q.get(k - i)?))).collect();
    Some((0..(p.len() + q.len()).saturating_sub(1)).map(|k| add(terms(k))).collect())
}

fn derivative_of(p: &[Expr]) -> Coefficients {
    (1u32..).zip(p.iter().skip(1)).map(|(k, c)| times(&numeral(k), c)).collect()
}

/// The antiderivative that is 0 at 0.
fn antiderivative_of(p: &[Expr]) -> Coefficients {
    let raised = (1u32..).zip(p).map(|(k, c)| times(c, &over(numeral(1), numeral(k))));
    std::iter::once(numeral(0)).chain(raised).collect()
}

fn written(p: &[Expr], x: &Expr) -> Expr {
    add(p.iter().enumerate().map(|(k, c)| times(c, &whole_power(x.clone(), i64::try_from(k).unwrap_or(0)))).collect())
}

/// The slope p of a linear expression p·x + q.
fn slope(u: &Expr, x: &str) -> Option<Expr> {
    match polynomial(u, x)?.as_slice() {
        [_, p] => Some(p.clone()),
        _ => None,
    }
}

/// An antiderivative of f in x.
pub(super) fn antiderivative(f: &Expr, x: &str) -> Option<Expr> {
    of(f, x, DEPTH)
}

fn of(f: &Expr, x: &str, depth: usize) -> Option<Expr> {
    let depth = depth.checked_sub(1)?;
    if !holds(f, x) {
        return Some(times(f, &name(x)));
    }
    if let Some(p) = polynomial(f, x) {
        return Some(written(&antiderivative_of(&p), &name(x)));
    }
    match &f.kind {
        ExprKind::Negate(a) => of(a, x, depth).map(negated),
        ExprKind::Sum(list) => {
            let parts: Option<Vec<_>> = list.iter().map(|(sign, e)| Some((*sign, of(e, x, depth)?))).collect();
            Some(total(parts?))
        }
        _ => of_product(f, x, depth),
    }
}

/// The factors of a product with their exponents, quotients and whole powers of products taken apart.
fn factors(e: &Expr, exponent: &Expr, out: &mut Vec<(Expr, Expr)>) {
    match &e.kind {
        ExprKind::Product(list) => {
            for (factor, part) in list {
                let own = if *factor == Factor::Times { exponent.clone() } else { negated(exponent.clone()) };
                factors(part, &own, out);
            }
        }
        ExprKind::Negate(a) if *exponent == numeral(1) => {
            out.push((negated(numeral(1)), numeral(1)));
            factors(a, exponent, out);
        }
        _ => match as_power(e) {
            Some((base, k)) => factors(&base, &times(&k, exponent), out),
            None => match out.iter_mut().find(|known| known.0 == *e) {
                Some(known) => known.1 = add(vec![known.1.clone(), exponent.clone()]),
                None => out.push((e.clone(), exponent.clone())),
            },
        },
    }
}

/// A number that an exponent made of numerals is, where it is whole.
fn whole(e: &Expr) -> Option<i64> {
    match crate::claim::definedness::number(e)? {
        (top, 1) => i64::try_from(top).ok(),
        _ => None,
    }
}

fn raised(base: &Expr, exponent: &Expr) -> Expr {
    match whole(exponent) {
        Some(k) => whole_power(base.clone(), k),
        None => power(base, exponent),
    }
}

fn of_product(f: &Expr, x: &str, depth: usize) -> Option<Expr> {
    let mut list = Vec::new();
    factors(f, &numeral(1), &mut list);
    let (moving, still): (Vec<_>, Vec<_>) = list.into_iter().partition(|(base, k)| holds(base, x) || holds(k, x));
    let constant = product(still.iter().map(|(base, k)| raised(base, k)).collect());
    let found = of_factors(&moving, x, depth).or_else(|| {
        // Sums among the factors, multiplied out.
        let (place, terms) = moving.iter().enumerate().find_map(|(i, (base, k))| match (&base.kind, whole(k)) {
            (ExprKind::Sum(terms), Some(1)) => Some((i, terms)),
            _ => None,
        })?;
        let others = moving.iter().enumerate().filter(|(i, _)| *i != place);
        let others: Vec<Expr> = others.map(|(_, (base, k))| raised(base, k)).collect();
        let term = |(sign, e): &(Sign, Expr)| {
            let whole = product(others.iter().cloned().chain([e.clone()]).collect());
            Some((*sign, of(&whole, x, depth)?))
        };
        Some(total(terms.iter().map(term).collect::<Option<Vec<_>>>()?))
    });
    Some(times(&constant, &found?))
}

fn of_factors(list: &[(Expr, Expr)], x: &str, depth: usize) -> Option<Expr> {
    if let [(base, exponent)] = list {
        return of_power(base, exponent, x, depth);
    }
    sines_and_cosines(list, x).or_else(|| by_parts(list, x, depth)).or_else(|| by_substitution(list, x))
}

/// The antiderivative of u^k in u, where k is free of it.
fn power_rule(u: &Expr, k: &Expr) -> Expr {
    if whole(k) == Some(-1) {
        return apply("ln", u.clone());
    }
    let next = add(vec![k.clone(), numeral(1)]);
    over(raised(u, &next), next)
}

/// u^k: by the table where u is linear, or one function of a linear argument.
fn of_power(base: &Expr, exponent: &Expr, x: &str, depth: usize) -> Option<Expr> {
    if !holds(exponent, x)
        && let Some(p) = slope(base, x)
    {
        return Some(over(power_rule(base, exponent), p));
    }
    if !holds(base, x) {
        let p = slope(exponent, x)?;
        return Some(over(power(base, exponent), product(vec![p, apply("ln", base.clone())])));
    }
    if let ExprKind::Apply(function, arguments) = &base.kind
        && let [u] = arguments.as_slice()
    {
        let k = whole(exponent)?;
        let p = slope(u, x)?;
        return match (function.text.as_str(), k) {
            ("exp", k) => Some(over(whole_power(base.clone(), k), product(vec![literal(&Rational::from(k)), p]))),
            ("ln", 1) => Some(over(total(vec![(Sign::Plus, times(u, base)), (Sign::Minus, u.clone())]), p)),
            ("sinh", 1) => Some(over(apply("cosh", u.clone()), p)),
            ("cosh", 1) => Some(over(apply("sinh", u.clone()), p)),
            ("tanh", 1) => Some(over(apply("ln", apply("cosh", u.clone())), p)),
            ("sech", 2) => Some(over(apply("tanh", u.clone()), p)),
            ("cos", -2) => Some(over(over(apply("sin", u.clone()), base.clone()), p)),
            ("sin", -2) => Some(negated(over(over(apply("cos", u.clone()), base.clone()), p))),
            ("sin" | "cos", _) => sines_and_cosines(&[(base.clone(), exponent.clone())], x),
            _ => None,
        };
    }
    // A whole power of a sum is multiplied out.
    let (ExprKind::Sum(terms), Some(k @ 2..=4)) = (&base.kind, whole(exponent)) else { return None };
    let rest = whole_power(base.clone(), k - 1);
    let term = |(sign, e): &(Sign, Expr)| Some((*sign, of(&product(vec![rest.clone(), e.clone()]), x, depth)?));
    Some(total(terms.iter().map(term).collect::<Option<Vec<_>>>()?))
}

/// w^k·(1 − w²)^times.
fn times_unit(k: usize, times: usize) -> Option<Coefficients> {
    let unit = [numeral(1), numeral(0), negated(numeral(1))];
    let power: Coefficients = std::iter::repeat_n(numeral(0), k).chain([numeral(1)]).collect();
    (0..times).try_fold(power, |q, _| multiplied(&q, &unit))
}

/// sin(u)^m·cos(u)^n for a linear u: where one exponent is odd, a polynomial in the other function; else
/// ∫cos^k = sin·cos^(k−1)/k + (k − 1)/k·∫cos^(k−2), after sin² = 1 − cos².
fn sines_and_cosines(list: &[(Expr, Expr)], x: &str) -> Option<Expr> {
    let (mut u, mut m, mut n) = (None::<Expr>, 0usize, 0usize);
    for (base, k) in list {
        let ExprKind::Apply(function, arguments) = &base.kind else { return None };
        let ([argument], k) = (arguments.as_slice(), usize::try_from(whole(k)?).ok()?) else { return None };
        if u.as_ref().is_some_and(|u| u != argument) || k > DEGREE {
            return None;
        }
        u = Some(argument.clone());
        match function.text.as_str() {
            "sin" => m += k,
            "cos" => n += k,
            _ => return None,
        }
    }
    let u = u?;
    let p = slope(&u, x)?;
    let (sine, cosine) = (apply("sin", u.clone()), apply("cos", u.clone()));
    let value = if m % 2 == 1 || n % 2 == 1 {
        // w = cos has w′ = −sin, w = sin has w′ = cos.
        let (w, own, odd, sign) = if m % 2 == 1 { (cosine, n, m, true) } else { (sine, m, n, false) };
        let q = times_unit(own, odd / 2)?;
        let value = written(&antiderivative_of(&q), &w);
        if sign { negated(value) } else { value }
    } else {
        let q = times_unit(n, m / 2)?;
        let mut reduced = vec![u.clone(), sine.clone()];
        for k in 2..q.len() {
            let k32 = u32::try_from(k).ok()?;
            let first = over(times(&sine, &whole_power(cosine.clone(), i64::from(k32) - 1)), numeral(k32));
            let rest = times(&over(numeral(k32 - 1), numeral(k32)), reduced.get(k - 2)?);
            reduced.push(add(vec![first, rest]));
        }
        add(q.iter().zip(&reduced).map(|(c, r)| times(c, r)).collect())
    };
    Some(over(value, p))
}

/// p·g for a polynomial p and g one of exp, sin, cos or ln of a linear argument, or exp times a sine or cosine.
fn by_parts(list: &[(Expr, Expr)], x: &str, depth: usize) -> Option<Expr> {
    let one = |e: &(Expr, Expr)| whole(&e.1) == Some(1);
    let mut p = vec![numeral(1)];
    let mut rest: Vec<&(Expr, Expr)> = Vec::new();
    for factor in list {
        match (polynomial(&factor.0, x), whole(&factor.1)) {
            (Some(q), Some(k @ 1..)) => {
                for _ in 0..k {
                    p = multiplied(&p, &q)?;
                }
            }
            _ => rest.push(factor),
        }
    }
    match rest.as_slice() {
        [g] if one(g) || matches!(&g.0.kind, ExprKind::Apply(f, _) if f.text == "exp") || !holds(&g.0, x) => {
            if let ExprKind::Apply(f, arguments) = &g.0.kind
                && let ("ln", [u]) = (f.text.as_str(), arguments.as_slice())
            {
                // ∫p·ln u = P·ln u − ∫P·u′/u, where P is 0 at the zero of u.
                let (a, b) = (slope(u, x)?, polynomial(u, x)?.first()?.clone());
                let mut whole = antiderivative_of(&p);
                let zero = negated(over(b, a.clone()));
                let at_zero = whole.iter().rev().fold(numeral(0), |sum, c| add(vec![times(&sum, &zero), c.clone()]));
                whole[0] = negated(at_zero);
                let divided = divided(&whole, &zero);
                let left = times(&written(&whole, &name(x)), &g.0);
                return Some(total(vec![
                    (Sign::Plus, left),
                    (Sign::Minus, of(&written(&divided, &name(x)), x, depth)?),
                ]));
            }
            // ∫p·g = p·G − ∫p′·G, with G a multiple of a function of the same kind.
            let mut terms = Vec::new();
            let mut integral = of_power(&g.0, &g.1, x, depth)?;
            let mut sign = Sign::Plus;
            loop {
                terms.push((sign, times(&written(&p, &name(x)), &integral)));
                p = derivative_of(&p);
                if p.iter().all(is_zero) {
                    return Some(total(terms));
                }
                integral = of(&integral, x, depth)?;
                sign = if sign == Sign::Plus { Sign::Minus } else { Sign::Plus };
            }
        }
        // ∫e^(ax)·sin(bx) and the same with cos.
        [g, h] if p.len() == 1 => {
            let is_exp = |e: &Expr| matches!(&e.kind, ExprKind::Apply(f, _) if f.text == "exp");
            let (g, h) = if is_exp(&g.0) { (g, h) } else { (h, g) };
            let (ExprKind::Apply(_, u), ExprKind::Apply(f, v)) = (&g.0.kind, &h.0.kind) else { return None };
            let ([u], [v], true, true) = (u.as_slice(), v.as_slice(), is_exp(&g.0), one(h)) else { return None };
            let (a, b) = (times(&literal(&Rational::from(whole(&g.1)?)), &slope(u, x)?), slope(v, x)?);
            let (sine, cosine) = (apply("sin", v.clone()), apply("cos", v.clone()));
            let inner = match f.text.as_str() {
                "sin" => total(vec![(Sign::Plus, times(&a, &sine)), (Sign::Minus, times(&b, &cosine))]),
                "cos" => add(vec![times(&a, &cosine), times(&b, &sine)]),
                _ => return None,
            };
            let below = add(vec![whole_power(a, 2), whole_power(b, 2)]);
            Some(over(product(vec![raised(&g.0, &g.1), inner]), below))
        }
        _ => None,
    }
}

/// The quotient of a polynomial that is 0 at a place, by x − place.
fn divided(p: &[Expr], place: &Expr) -> Coefficients {
    let mut out = Vec::new();
    let mut carried = numeral(0);
    for c in p.iter().skip(1).rev() {
        carried = add(vec![times(&carried, place), c.clone()]);
        out.push(carried.clone());
    }
    out.reverse();
    out
}

/// r·h(u)^k where r is a multiple of u′: a polynomial u of degree 2 or more, or the logarithm of a linear one.
fn by_substitution(list: &[(Expr, Expr)], x: &str) -> Option<Expr> {
    for (place, (base, exponent)) in list.iter().enumerate() {
        let others: Vec<&(Expr, Expr)> =
            list.iter().enumerate().filter(|(i, _)| *i != place).map(|(_, factor)| factor).collect();
        if let Some(value) = by_inner_function(base, exponent, &others, x) {
            return Some(value);
        }
        let inner = match (&base.kind, polynomial(base, x)) {
            (_, Some(p)) => Some((p, None)),
            (ExprKind::Apply(f, u), None) if f.text != "ln" => {
                Some((polynomial(u.first()?, x)?, Some(f.text.as_str())))
            }
            _ => None,
        };
        if let Some((u, function)) = inner
            && u.len() > 2
            && let Some(ratio) = ratio_of(&others, &derivative_of(&u), x)
        {
            let value = match (function, whole(exponent)) {
                (None, _) if !holds(exponent, x) => power_rule(base, exponent),
                (Some("exp"), Some(k)) => over(raised(base, exponent), literal(&Rational::from(k))),
                (Some(f @ ("sin" | "cos")), Some(1)) => {
                    let ExprKind::Apply(_, at) = &base.kind else { return None };
                    let other = apply(if f == "sin" { "cos" } else { "sin" }, at.first()?.clone());
                    if f == "sin" { negated(other) } else { other }
                }
                _ => continue,
            };
            return Some(times(&ratio, &value));
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
    None
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

/// c where the product of the factors is c·p, by the highest coefficients.
fn ratio_of(list: &[&(Expr, Expr)], p: &[Expr], x: &str) -> Option<Expr> {
    let mut q = vec![numeral(1)];
    for (base, k) in list {
        let k @ 1.. = whole(k)? else { return None };
        let factor = polynomial(base, x)?;
        for _ in 0..k {
            q = multiplied(&q, &factor)?;
        }
    }
    let same = q.len() == p.len() && q.iter().zip(p).all(|(a, b)| is_zero(a) == is_zero(b));
    same.then(|| Some(over(q.last()?.clone(), p.last()?.clone()))).flatten()
}
