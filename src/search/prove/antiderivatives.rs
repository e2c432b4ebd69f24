//! Antiderivatives of elementary functions: a proposal, which the kernel's derivative confirms.
//!
//! Method: sums by parts; what is free of the variable stays; powers, exponentials, logarithms, sines and cosines of a linear
//! argument by the table; polynomials times one of them by parts; products of powers of a sine and a cosine by their reductions, and
//! of several arguments or beside other factors by sums; powers of logarithms and arcs by parts; roots of c ± a·x²; h(u)·u′ by
//! substitution (`substitutions`); rational functions by partial
//! fractions (`partial_fractions`).
//! Coefficients may be zeros that are not seen to be zeros: then the proposal fails, and nothing is lost.
//!
//! Reference: M. Bronstein, Symbolic Integration I, Springer 2005, chapters 1 and 5, for what goes beyond this.

use super::coefficients::*;
use super::facts::negated;
use super::letters::{as_power, product, total, whole_power};
use super::limits::{holds, over};
use super::partial_fractions::{of_fraction, root, signed};
use super::substitutions::by_substitution;
use crate::claim::syntax::*;
use crate::kernel::arc::as_arc;
use crate::kernel::statement::{apply, name, numeral, power};
use crate::refute::literal::{is_zero, literal};
use malachite::Rational;

/// How deep products are taken apart.
const DEPTH: usize = 8;

/// The highest power of a logarithm.
const LOGARITHMS: i64 = 4;

/// The most sines and cosines of a product.
const WAVES: usize = 4;

/// An antiderivative of f in x.
pub(super) fn antiderivative(f: &Expr, x: &str) -> Option<Expr> {
    of(f, x, DEPTH)
}

/// The same, taken apart to a depth.
pub(super) fn of(f: &Expr, x: &str, depth: usize) -> Option<Expr> {
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
pub(super) fn factors(e: &Expr, exponent: &Expr, out: &mut Vec<(Expr, Expr)>) {
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

/// A power of an expression, a whole one by its number.
pub(super) fn raised(base: &Expr, exponent: &Expr) -> Expr {
    match whole(exponent) {
        Some(k) => whole_power(base.clone(), k),
        None => power(base, exponent),
    }
}

fn of_product(f: &Expr, x: &str, depth: usize) -> Option<Expr> {
    let mut list = Vec::new();
    factors(f, &numeral(1), &mut list);
    list.retain(|(_, k)| !is_zero(k));
    let (moving, still): (Vec<_>, Vec<_>) = list.into_iter().partition(|(base, k)| holds(base, x) || holds(k, x));
    let constant = product(still.iter().map(|(base, k)| raised(base, k)).collect());
    let found = of_factors(&moving, x, depth).or_else(|| {
        // Sums among the factors, multiplied out.
        let (place, terms) = moving.iter().enumerate().find_map(|(i, (base, k))| match (&base.kind, whole(k)) {
            (ExprKind::Sum(terms), Some(k @ 1..=4)) => Some((i, (terms, k))),
            _ => None,
        })?;
        let (terms, k) = terms;
        let others = moving.iter().enumerate().filter(|(i, _)| *i != place);
        let rest = whole_power(moving[place].0.clone(), k - 1);
        let others: Vec<Expr> = others.map(|(_, (base, k))| raised(base, k)).chain([rest]).collect();
        let term = |(sign, e): &(Sign, Expr)| {
            let whole = product(others.iter().cloned().chain([e.clone()]).collect());
            Some((*sign, of(&whole, x, depth)?))
        };
        Some(total(terms.iter().map(term).collect::<Option<Vec<_>>>()?))
    });
    Some(times(&constant, &found?))
}

fn of_factors(list: &[(Expr, Expr)], x: &str, depth: usize) -> Option<Expr> {
    match list {
        [] => return Some(name(x)),
        [(base, exponent)] => return of_power(base, exponent, x, depth),
        _ => {}
    }
    sines_and_cosines(list, x)
        .or_else(|| of_waves(list, x, depth))
        .or_else(|| by_parts(list, x, depth))
        .or_else(|| by_substitution(list, x, depth))
        .or_else(|| of_fraction(list, x))
}

/// The antiderivative of u^k in u, where k is free of it.
pub(super) fn power_rule(u: &Expr, k: &Expr) -> Expr {
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
        if function.text == "ln" && (1..=LOGARITHMS).contains(&k) {
            return of_power_of_logarithm(&[numeral(1)], u, k, x, depth);
        }
        if k == 1
            && let Some(found) = of_arc(&[numeral(1)], base, x, depth)
        {
            return Some(found);
        }
        let p = slope(u, x)?;
        return match (function.text.as_str(), k) {
            ("exp", k) => Some(over(whole_power(base.clone(), k), product(vec![literal(&Rational::from(k)), p]))),
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
    if let Some(found) = of_root(base, exponent, x) {
        return Some(found);
    }
    // A whole power of a sum is multiplied out.
    let (ExprKind::Sum(terms), Some(k @ 2..=4)) = (&base.kind, whole(exponent)) else {
        return of_fraction(&[(base.clone(), exponent.clone())], x);
    };
    let rest = whole_power(base.clone(), k - 1);
    let term = |(sign, e): &(Sign, Expr)| Some((*sign, of(&product(vec![rest.clone(), e.clone()]), x, depth)?));
    Some(total(terms.iter().map(term).collect::<Option<Vec<_>>>()?))
}

/// u^(1/2) and u^(−1/2) for u = c + a·x²: with s = √|a|, r = √c, the antiderivative of 1/√u is arcsin(s·x/r)/s where a is negative,
/// and ln(s·x + √u)/s where it is positive; that of √u is half of x·√u and of c times the other.
fn of_root(base: &Expr, exponent: &Expr, x: &str) -> Option<Expr> {
    let (twice, p) = (rational(exponent)? * Rational::from(2), polynomial(base, x)?);
    let [c, zero, a] = p.as_slice() else { return None };
    let ((false, c), (falls, size), true) = (signed(c), signed(a), is_zero(zero)) else { return None };
    let s = root(&size);
    let along = times(&s, &name(x));
    let inverse = match falls {
        true => apply("arcsin", over(along, root(&c))),
        false => apply("ln", add(vec![along, apply("sqrt", base.clone())])),
    };
    let inverse = over(inverse, s);
    if twice == -1 {
        return Some(inverse);
    }
    let half = literal(&Rational::from_signeds(1, 2));
    let first = product(vec![half.clone(), name(x), apply("sqrt", base.clone())]);
    (twice == 1).then(|| add(vec![first, product(vec![half, c, inverse])]))
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

/// Two or more sines and cosines of linear arguments, also times a polynomial, an exponential or both: two of these are half a sum of
/// waves, as in x²·cos(x)² = (x² + x²·cos(2·x))/2 and cos(m·x)·cos(n·x) = (cos((m − n)·x) + cos((m + n)·x))/2.
fn of_waves(list: &[(Expr, Expr)], x: &str, depth: usize) -> Option<Expr> {
    let as_wave = |(base, k): &(Expr, Expr)| match &base.kind {
        ExprKind::Apply(f, u) if matches!(f.text.as_str(), "sin" | "cos") && u.len() == 1 => {
            slope(&u[0], x)?;
            let k = usize::try_from(whole(k)?).ok().filter(|k| *k <= WAVES)?;
            Some(std::iter::repeat_n((f.text == "sin", u[0].clone()), k))
        }
        _ => None,
    };
    let mut waves: Vec<(bool, Expr)> = list.iter().filter_map(as_wave).flatten().collect();
    let others: Vec<Expr> =
        list.iter().filter(|factor| as_wave(factor).is_none()).map(|(base, k)| raised(base, k)).collect();
    if !(2..=WAVES).contains(&waves.len()) {
        return None;
    }
    let ((f, u), (g, v)) = (waves.pop()?, waves.pop()?);
    let rest = waves.into_iter().map(|(is_sine, u)| apply(if is_sine { "sin" } else { "cos" }, u));
    let beside: Vec<Expr> = others.into_iter().chain(rest).collect();
    let (u, v) = if g && !f { (v, u) } else { (u, v) };
    let is_sine = f != g;
    let part = |w: Option<Expr>| match w {
        Some(w) => product(beside.iter().cloned().chain([apply(if is_sine { "sin" } else { "cos" }, w)]).collect()),
        None if is_sine => numeral(0),
        None => product(beside.clone()),
    };
    let minus = (u != v).then(|| total(vec![(Sign::Plus, u.clone()), (Sign::Minus, v.clone())]));
    let plus = if u == v { times(&numeral(2), &u) } else { add(vec![u, v]) };
    let sign = if f && g { Sign::Minus } else { Sign::Plus };
    let sum = total(vec![(Sign::Plus, of(&part(minus), x, depth)?), (sign, of(&part(Some(plus)), x, depth)?)]);
    Some(times(&literal(&Rational::from_signeds(1, 2)), &sum))
}

/// ∫p·ln u = P·ln u − Σ k·∫P·l′/l for u = c·∏ l^k; where there is one l and it is linear, P is 0 at its zero.
fn of_logarithm(p: &[Expr], u: &Expr, x: &str, depth: usize) -> Option<Expr> {
    let mut list = Vec::new();
    factors(u, &numeral(1), &mut list);
    list.retain(|(l, _)| holds(l, x));
    let mut whole_p = antiderivative_of(p);
    let mut terms = Vec::new();
    let polynomials: Option<Vec<_>> = list.iter().map(|(l, k)| Some((polynomial(l, x)?, whole(k)?, l))).collect();
    let polynomials = polynomials?;
    if let [(l, k, _)] = polynomials.as_slice()
        && let [b, a] = l.as_slice()
    {
        let part;
        (whole_p, part) = vanishing(whole_p, &negated(over(b.clone(), a.clone())));
        let part = scaled(&part, &literal(&Rational::from(*k)));
        terms.push((Sign::Minus, written(&antiderivative_of(&part), &name(x))));
    } else {
        for (l, k, as_written) in &polynomials {
            let above = scaled(&multiplied(&whole_p, &derivative_of(l))?, &literal(&Rational::from(*k)));
            let quotient = over(written(&above, &name(x)), (*as_written).clone());
            terms.push((Sign::Minus, of(&quotient, x, depth)?));
        }
    }
    terms.push((Sign::Plus, times(&written(&whole_p, &name(x)), &apply("ln", u.clone()))));
    Some(total(terms))
}

/// ∫p·ln(u)^k = P·ln(u)^k − k·∫(P·u′/u)·ln(u)^(k − 1) for a linear u, with P = 0 at its zero.
fn of_power_of_logarithm(p: &[Expr], u: &Expr, k: i64, x: &str, depth: usize) -> Option<Expr> {
    let depth = depth.checked_sub(1)?;
    if k == 1 {
        return of_logarithm(p, u, x, depth);
    }
    let linear = polynomial(u, x)?;
    let [b, a] = linear.as_slice() else { return None };
    let (whole_p, part) = vanishing(antiderivative_of(p), &negated(over(b.clone(), a.clone())));
    let rest = of_power_of_logarithm(&scaled(&part, &literal(&Rational::from(k))), u, k - 1, x, depth)?;
    let first = times(&written(&whole_p, &name(x)), &whole_power(apply("ln", u.clone()), k));
    Some(total(vec![(Sign::Plus, first), (Sign::Minus, rest)]))
}

/// The polynomial with another constant term, so that it is 0 at a place, and its quotient by the distance to it.
fn vanishing(mut p: Coefficients, zero: &Expr) -> (Coefficients, Coefficients) {
    p[0] = numeral(0);
    let at_zero = p.iter().rev().fold(numeral(0), |sum, c| add(vec![times(&sum, zero), c.clone()]));
    p[0] = negated(at_zero);
    let part = divided(&p, zero);
    (p, part)
}

/// ∫p·arc(u) = P·arc(u) − ∫P·u′·arc′(u) for arc = arctan or arcsin and a linear u.
fn of_arc(p: &[Expr], arc: &Expr, x: &str, depth: usize) -> Option<Expr> {
    let (f, u) = as_arc(arc)?;
    let (square, whole_p) = (whole_power(u.clone(), 2), written(&antiderivative_of(p), &name(x)));
    let below = match f {
        "arctan" => add(vec![square, numeral(1)]),
        "arcsin" => apply("sqrt", add(vec![numeral(1), negated(square)])),
        _ => return None,
    };
    let rest = of(&over(times(&slope(u, x)?, &whole_p), below), x, depth)?;
    Some(total(vec![(Sign::Plus, times(&whole_p, arc)), (Sign::Minus, rest)]))
}

/// p·g for a polynomial p and g one of exp, sin, cos or ln of a linear argument, a power of one such as a root, or exp times a sine or
/// cosine.
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
        [g] if one(g)
            || matches!(&g.0.kind, ExprKind::Apply(f, _) if f.text == "exp")
            || matches!((&g.0.kind, whole(&g.1)), (ExprKind::Apply(f, _), Some(1..=LOGARITHMS)) if f.text == "ln")
            || !holds(&g.0, x)
            || (!holds(&g.1, x) && whole(&g.1).is_none() && slope(&g.0, x).is_some()) =>
        {
            if let ExprKind::Apply(f, arguments) = &g.0.kind
                && let ("ln", [u]) = (f.text.as_str(), arguments.as_slice())
            {
                return of_power_of_logarithm(&p, u, whole(&g.1)?, x, depth);
            }
            if let Some(found) = of_arc(&p, &g.0, x, depth) {
                return Some(found);
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
