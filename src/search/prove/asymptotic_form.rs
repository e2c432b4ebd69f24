//! Expressions by a variable x that grows without bound: their leading terms, and logarithms, powers and roots written by x
//! and by what tends to 1.
//!
//! ln(x + 1) = ln(x) + ln(1 + 1/x), sqrt(x^2 + x) = x*(1 + 1/x)^(1/2), (1 + a/x)^x = exp(x*ln(1 + a/x)). A difference of two
//! that grow alike is then a difference of two that tend to 1, whose expansions tell how fast it falls (Gruntz, "On computing
//! limits in a symbolic manipulation system", 1996, has the general theory).

use super::Prover;
use super::arcs::quarter_turn;
use super::asymptotic_bounds::Tends;
use super::facts::{minus, negated};
use super::letters::{as_power, natural, product};
use super::limits::{holds, over};
use crate::algebra::{Monomial, Polynomial};
use crate::claim::syntax::*;
use crate::claim::walk::parts_mut;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, expr, name, numeral, power, sum};
use crate::refute::limit::by_exponentials;
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::BTreeMap;

/// c·x^exponent.
pub(super) struct Leading {
    pub c: Expr,
    pub exponent: Rational,
}

/// e^r.
pub(super) fn raised(e: &Expr, r: &Rational) -> Expr {
    if *r == 1 { e.clone() } else { power(e, &literal(r)) }
}

/// The sum of some expressions.
pub(super) fn total(list: &[Expr]) -> Expr {
    match list {
        [] => numeral(0),
        [only] => only.clone(),
        _ => sum(list.iter().map(|e| (Sign::Plus, e.clone())).collect()),
    }
}

/// Whether a power is one of x, or stands for a number.
fn is_plain(base: &Expr, exponent: &Expr, x: &str) -> bool {
    !holds(exponent, x) && (matches!(&base.kind, ExprKind::Name(n) if n == x) || !holds(base, x))
}

/// Whether a power is t^x for a constant t.
pub(super) fn is_turning(base: &Expr, exponent: &Expr, x: &str) -> bool {
    !holds(base, x) && matches!(&exponent.kind, ExprKind::Name(n) if n == x)
}

/// The parts that are no sums, products or whole powers, the outermost ones; `None` where one is not read here.
pub(super) fn atoms(e: &Expr, x: &str, out: &mut Vec<Expr>) -> Option<()> {
    if !holds(e, x) {
        return Some(());
    }
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => {}
        ExprKind::Negate(a) => atoms(a, x, out)?,
        ExprKind::Sum(list) => list.iter().try_for_each(|(_, e)| atoms(e, x, out))?,
        ExprKind::Product(list) => list.iter().try_for_each(|(_, e)| atoms(e, x, out))?,
        ExprKind::Power(base, exponent) if natural(exponent).is_some() => atoms(base, x, out)?,
        ExprKind::Power(base, exponent) if is_plain(base, exponent, x) => {}
        // A power of what may be negative; the others are exponentials here.
        ExprKind::Power(base, exponent) if is_turning(base, exponent, x) => once(e, out),
        ExprKind::Power(_, exponent) if holds(exponent, x) => return None,
        ExprKind::Power(..) => once(e, out),
        ExprKind::Apply(f, list) if MOVING.contains(&f.text.as_str()) && list.len() == 1 => once(e, out),
        _ => return None,
    }
    Some(())
}

/// Functions with bounds of their own.
const MOVING: [&str; 6] = ["exp", "ln", "sin", "cos", "arcsin", "arctan"];

/// Adds an expression that is not there yet.
fn once(e: &Expr, out: &mut Vec<Expr>) {
    if !out.iter().any(|known| key::expr(known) == key::expr(e)) {
        out.push(e.clone());
    }
}

/// The sum of exponents; w·ln(a) ± w·ln(b) is w·ln(a·b^(±1)) for numbers a and b, whose order is seen more easily.
fn together(exponents: &[(Sign, Expr)]) -> Expr {
    let logarithm = |e: &Expr| match &e.kind {
        ExprKind::Product(list) => match list.as_slice() {
            [(Factor::Times, w), (Factor::Times, Expr { kind: ExprKind::Apply(f, inside), .. })] if f.text == "ln" => {
                Some((w.clone(), inside.first().filter(|b| matches!(b.kind, ExprKind::Number(_)))?.clone()))
            }
            _ => None,
        },
        _ => None,
    };
    let mut terms: Vec<(Sign, Expr)> = Vec::new();
    let mut bases: Vec<(Expr, Vec<(Factor, Expr)>)> = Vec::new();
    for (sign, e) in exponents {
        let Some((w, base)) = logarithm(e) else {
            terms.push((*sign, e.clone()));
            continue;
        };
        let factor = if *sign == Sign::Plus { Factor::Times } else { Factor::Over };
        match bases.iter_mut().find(|(other, _)| key::expr(other) == key::expr(&w)) {
            Some((_, list)) => list.push((factor, base)),
            None => bases.push((w, vec![(Factor::Times, numeral(1)), (factor, base)])),
        }
    }
    for (w, list) in bases {
        // The same base above and below.
        if let [_, (Factor::Times, a), (Factor::Over, b)] = list.as_slice()
            && key::expr(a) == key::expr(b)
        {
            continue;
        }
        let base = match list.as_slice() {
            [_, (Factor::Times, only)] => only.clone(),
            _ => expr(ExprKind::Product(list)),
        };
        terms.push((Sign::Plus, product(vec![w, apply("ln", base)])));
    }
    terms.sort_by_key(|(sign, _)| *sign == Sign::Minus);
    if let Some((sign @ Sign::Minus, u)) = terms.first_mut() {
        (*sign, *u) = (Sign::Plus, negated(u.clone()));
    }
    match terms.as_slice() {
        [] => numeral(0),
        [(_, only)] => only.clone(),
        _ => sum(terms),
    }
}

/// Puts a value in the place of an atom, but not inside of other atoms.
pub(super) fn put_for_atom(e: &mut Expr, atom: &Expr, value: &Expr) {
    if key::expr(e) == key::expr(atom) {
        *e = value.clone();
        return;
    }
    match &e.kind {
        ExprKind::Negate(_) | ExprKind::Sum(_) | ExprKind::Product(_) => {}
        ExprKind::Power(_, exponent) if natural(exponent).is_some() => {}
        _ => return,
    }
    parts_mut(e, &mut |part| put_for_atom(part, atom, value));
}

impl Prover {
    /// The leading term of a quotient of sums of powers of x; 0 where it vanishes.
    pub(super) fn leading(&mut self, e: &Expr, x: &str) -> Option<Leading> {
        let reading = self.read(e, false)?;
        let (mut factors, mut total) = (vec![literal(&reading.number)], Rational::ZERO);
        for f in &reading.factors {
            let (degree, c) = self.by_degrees(&f.poly, x)?.pop_last()?;
            total += degree * Rational::from(f.power);
            factors.push(super::letters::whole_power(self.letters.written(&c), f.power));
        }
        Some(Leading { c: product(factors), exponent: total })
    }

    /// The coefficients by powers of x.
    pub(super) fn by_degrees(&mut self, p: &Polynomial, x: &str) -> Option<BTreeMap<Rational, Polynomial>> {
        let mut out: BTreeMap<Rational, Polynomial> = BTreeMap::new();
        for (monomial, c) in p.terms() {
            let (degree, rest, _) = self.apart(monomial, x)?;
            let sum = out.entry(degree).or_insert_with(Polynomial::zero);
            *sum = sum.add(&Polynomial::term(rest, c.clone()));
        }
        out.retain(|_, p| !p.is_zero());
        Some(out)
    }

    /// The degree in x of a monomial, what is free of x, and the rest as it is written.
    pub(super) fn apart(&mut self, monomial: &Monomial, x: &str) -> Option<(Rational, Monomial, Expr)> {
        let (mut degree, mut rest, mut powers) = (Rational::ZERO, Vec::new(), Vec::new());
        for (v, k) in monomial.powers() {
            match self.degree_of(*v, x)? {
                Some(own) => {
                    degree += own * Rational::from(*k);
                    powers.push(super::letters::whole_power(self.letters.expr(*v)?.clone(), i64::from(*k)));
                }
                None => rest.push((*v, *k)),
            }
        }
        Some((degree, Monomial::new(&rest).ok()?, product(powers)))
    }

    /// Of a letter that is a power of x, its exponent; `Some(None)` for one that is free of x, `None` for any other.
    fn degree_of(&mut self, letter: u32, x: &str) -> Option<Option<Rational>> {
        let e = &self.letters.expr(letter)?.clone();
        if !holds(e, x) {
            return Some(None);
        }
        let is_x = |e: &Expr| matches!(&e.kind, ExprKind::Name(n) if n == x);
        if is_x(e) {
            return Some(Some(Rational::ONE));
        }
        let (base, exponent) = as_power(e)?;
        let exponent = self.letters.number(&exponent)?;
        is_x(&base).then_some(Some(exponent))
    }

    /// An expression written by x and what tends to 1, and the equations by which it is the same.
    pub(super) fn written_by(&mut self, e: &Expr, x: &str, equations: &mut Vec<(Expr, Expr)>) -> Option<Expr> {
        if !holds(e, x) {
            return Some(e.clone());
        }
        if let Some((base, exponent)) = as_power(e).filter(|p| natural(&p.1).is_none()) {
            return self.power_by(&base, &exponent, x, equations);
        }
        let mut out = e.clone();
        let mut found = Some(());
        parts_mut(&mut out, &mut |part| match self.written_by(part, x, equations) {
            Some(new) => *part = new,
            None => found = None,
        });
        found?;
        match &out.kind {
            ExprKind::Product(list) => self.product_by(list, x, equations),
            ExprKind::Apply(f, list) if f.text == "ln" => self.logarithm_by(list.first()?, x, equations),
            ExprKind::Apply(f, list) if f.text == "arccos" => {
                Some(minus(&quarter_turn(1), &apply("arcsin", list.first()?.clone())))
            }
            ExprKind::Apply(f, list) if f.text == "arctan" => self.arctangent_by(list.first()?, x, equations),
            ExprKind::Apply(f, list) if matches!(f.text.as_str(), "sin" | "cos") => {
                let argument = self.read(list.first()?, false)?;
                match argument.factors.iter().all(|f| f.poly.terms().count() == 1) {
                    // The sine of a multiple stays whole: it is linear in itself.
                    true => self.turned(&f.text, list.first()?, argument.number < 0),
                    // The addition formulas leave terms as arguments.
                    false => self.simplified(&out),
                }
            }
            // 1 − 2/(exp(2·u) + 1), in which one exponential grows.
            ExprKind::Apply(f, list) if f.text == "tanh" => {
                let twice = apply("exp", product(vec![numeral(2), list.first()?.clone()]));
                let rest = over(numeral(2), sum(vec![(Sign::Plus, twice), (Sign::Plus, numeral(1))]));
                self.written_by(&minus(&numeral(1), &rest), x, equations)
            }
            ExprKind::Apply(f, list) if matches!(f.text.as_str(), "cosh" | "sinh" | "sech") => {
                self.written_by(&by_exponentials(&f.text, list.first()?), x, equations)
            }
            _ => Some(out),
        }
    }

    /// The sine or cosine of an argument of one term, with the sign of its number before it.
    fn turned(&mut self, function: &str, argument: &Expr, is_negative: bool) -> Option<Expr> {
        if !is_negative {
            return Some(apply(function, self.simplified(argument)?));
        }
        let whole = apply(function, self.simplified(&negated(argument.clone()))?);
        Some(if function == "sin" { negated(whole) } else { whole })
    }

    /// A product with one exponential at most, and with powers in the place of divisors.
    fn product_by(&mut self, list: &[(Factor, Expr)], x: &str, equations: &mut Vec<(Expr, Expr)>) -> Option<Expr> {
        let (mut rest, mut exponents) = (Vec::new(), Vec::new());
        let mut turns = false;
        for (factor, e) in list {
            let sign = if *factor == Factor::Times { Sign::Plus } else { Sign::Minus };
            let mut e = e.clone();
            // What is expanded is mostly positive so.
            while let ExprKind::Negate(opposite) = &e.kind {
                (e, turns) = ((**opposite).clone(), !turns);
            }
            if let Some((top, others)) = self.dominant(&e, x) {
                exponents.push((sign, top));
                e = others;
            }
            match (&e.kind, factor) {
                (ExprKind::Apply(f, u), _) if f.text == "exp" => exponents.push((sign, u.first()?.clone())),
                (_, Factor::Over) if holds(&e, x) => rest.push((Factor::Times, self.inverse_by(&e, x, equations)?)),
                _ => rest.push((*factor, e)),
            }
        }
        let exponent = (!exponents.is_empty()).then(|| together(&exponents));
        let exponent = exponent.filter(|u| natural(u) != Some(0));
        rest.extend(exponent.map(|u| (Factor::Times, apply("exp", u))));
        if turns || !matches!(rest.first(), Some((Factor::Times, _))) {
            rest.insert(0, (Factor::Times, literal(&Rational::from(if turns { -1 } else { 1 }))));
        }
        match rest.as_slice() {
            [(_, only)] => Some(only.clone()),
            _ => Some(expr(ExprKind::Product(rest))),
        }
    }

    /// 1/u: c^(−1)·x^(−r)·(u/(c·x^r))^(−1), or u^(−1) where u has no leading term by powers of x.
    fn inverse_by(&mut self, u: &Expr, x: &str, equations: &mut Vec<(Expr, Expr)>) -> Option<Expr> {
        if let Some((base, exponent)) = as_power(u)
            && let Some(a) = self.letters.number(&exponent)
        {
            return self.power_by(&base, &literal(&-a), x, equations);
        }
        Some(self.apart_from_its_lead(u, &Rational::from(-1), x))
    }

    /// u^a = c^a·x^(r·a)·(u/(c·x^r))^a; u^a itself where u has no leading term by powers of x.
    fn apart_from_its_lead(&mut self, u: &Expr, a: &Rational, x: &str) -> Expr {
        let exponent = literal(a);
        let Some(lead) = self.leading(u, x) else { return power(u, &exponent) };
        let mut factors = Vec::new();
        if !self.is_one(&lead.c) {
            factors.push(power(&lead.c, &exponent));
        }
        if lead.exponent != 0 {
            factors.push(raised(&name(x), &(&lead.exponent * a)));
        }
        let rest = self.rest(u, &lead, x);
        if !self.is_one(&rest) {
            factors.push(power(&rest, &exponent));
        }
        product(factors)
    }

    /// arctan(u): where u grows beyond all bounds, ±π/2 − arctan(1/u); where it tends to c, arctan(c) + arctan((u − c)/(1 + c·u)).
    fn arctangent_by(&mut self, u: &Expr, x: &str, equations: &mut Vec<(Expr, Expr)>) -> Option<Expr> {
        let whole = apply("arctan", u.clone());
        let (first, rest) = match self.tends(u, x) {
            Tends::To(c) if self.is_zero(&c) => return Some(whole),
            Tends::To(c) => {
                let below = sum(vec![(Sign::Plus, numeral(1)), (Sign::Plus, product(vec![c.clone(), u.clone()]))]);
                (apply("arctan", c.clone()), over(minus(u, &c), below))
            }
            end @ (Tends::PlusInfinity | Tends::MinusInfinity) => {
                let times = if matches!(end, Tends::PlusInfinity) { 1 } else { -1 };
                (quarter_turn(times), negated(over(numeral(1), u.clone())))
            }
            Tends::Elsewhere => return None,
        };
        let rest = self.written_by(&rest, x, equations)?;
        let new = sum(vec![(Sign::Plus, first), (Sign::Plus, apply("arctan", rest))]);
        equations.push((whole, new.clone()));
        Some(new)
    }

    /// ln(c·Π p^k) = ln(c) + Σ k·ln(p), where a divisor is a sum: u/(c·x^r) would be no sum of powers of x then.
    fn logarithm_of_quotient(&mut self, u: &Expr, x: &str) -> Option<Expr> {
        let reading = self.read(u, false)?;
        let is_sum = |p: &Polynomial| p.term_count() > 1 && holds(&self.letters.written(p), x);
        if !reading.factors.iter().any(|f| f.power < 0 && is_sum(&f.poly)) {
            return None;
        }
        let (mut number, mut terms) = (reading.number, Vec::new());
        for f in &reading.factors {
            let mut p = self.letters.written(&f.poly);
            let lead = self.leading(&p, x)?;
            if !self.sign_of_constant(&lead.c)?.within(Signs::POSITIVE) {
                p = self.letters.written(&f.poly.neg());
                number *= Rational::from(if f.power % 2 == 0 { 1 } else { -1 });
            }
            // Its own equation follows from that of the whole.
            let log = self.logarithm_by(&p, x, &mut Vec::new())?;
            terms.push(product(vec![literal(&Rational::from(f.power)), log]));
        }
        if number <= 0 {
            return None;
        }
        if number != 1 {
            terms.push(apply("ln", literal(&number)));
        }
        Some(total(&terms))
    }

    /// ln(u) = ln(c) + r·ln(x) + ln(u/(c·x^r)).
    fn logarithm_by(&mut self, u: &Expr, x: &str, equations: &mut Vec<(Expr, Expr)>) -> Option<Expr> {
        let whole = apply("ln", u.clone());
        if matches!(&u.kind, ExprKind::Name(n) if n == x) {
            return Some(whole);
        }
        if let Some((top, rest)) = self.dominant(u, x) {
            let rest = self.written_by(&apply("ln", rest), x, equations)?;
            let new = sum(vec![(Sign::Plus, top), (Sign::Plus, rest)]);
            equations.push((whole, new.clone()));
            return Some(new);
        }
        if let Some(new) = self.logarithm_of_quotient(u, x) {
            equations.push((whole, new.clone()));
            return Some(new);
        }
        let Some(lead) = self.leading(u, x) else { return Some(whole) };
        let mut terms = Vec::new();
        if !self.is_one(&lead.c) {
            terms.push(apply("ln", lead.c.clone()));
        }
        if lead.exponent != 0 {
            terms.push(product(vec![literal(&lead.exponent), apply("ln", name(x))]));
        }
        if terms.is_empty() {
            return Some(whole);
        }
        let rest = self.rest(u, &lead, x);
        if !self.is_one(&rest) {
            terms.push(apply("ln", rest));
        }
        let new = total(&terms);
        equations.push((whole, new.clone()));
        Some(new)
    }

    /// u^a = c^a·x^(r·a)·(u/(c·x^r))^a for a number a, and b^u = exp(u·ln(b)).
    fn power_by(&mut self, base: &Expr, exponent: &Expr, x: &str, equations: &mut Vec<(Expr, Expr)>) -> Option<Expr> {
        let whole = power(base, exponent);
        if is_plain(base, exponent, x) {
            return Some(whole);
        }
        if is_turning(base, exponent, x) && !self.signs_of(base).within(Signs::POSITIVE) {
            return Some(whole);
        }
        if holds(exponent, x) {
            let log = self.written_by(&apply("ln", base.clone()), x, equations)?;
            let exponent = self.written_by(exponent, x, equations)?;
            let new = apply("exp", product(vec![exponent, log]));
            equations.push((whole, new.clone()));
            return Some(new);
        }
        let a = self.letters.number(exponent)?;
        let base = self.written_by(base, x, equations)?;
        let new = self.apart_from_its_lead(&base, &a, x);
        if key::expr(&new) != key::expr(&power(&base, &literal(&a))) {
            equations.push((whole, new.clone()));
        }
        Some(new)
    }

    /// The exponent t of the exponential that outgrows the others in a sum, if it grows or falls, and the sum over exp(t).
    fn dominant(&mut self, e: &Expr, x: &str) -> Option<(Expr, Expr)> {
        let ExprKind::Sum(list) = &e.kind else { return None };
        let exponent = |e: &Expr| match &e.kind {
            ExprKind::Apply(f, u) if f.text == "exp" => u.first().cloned(),
            ExprKind::Product(list) => list.iter().find_map(|(factor, e)| match &e.kind {
                ExprKind::Apply(f, u) if f.text == "exp" && *factor == Factor::Times => u.first().cloned(),
                _ => None,
            }),
            _ => None,
        };
        let exponents: Vec<Expr> = list.iter().map(|(_, e)| exponent(e).unwrap_or(numeral(0))).collect();
        let less = |u: &Expr, v: &Expr| together(&[(Sign::Plus, u.clone()), (Sign::Minus, v.clone())]);
        let mut top = exponents.first()?.clone();
        for u in &exponents {
            let lead = self.leading(&less(u, &top), x)?;
            if lead.exponent > 0 && self.sign_of_constant(&lead.c)?.within(Signs::POSITIVE) {
                top = u.clone();
            }
        }
        if self.leading(&top, x)?.exponent <= 0 {
            return None;
        }
        let over_top = |e: &Expr, u: &Expr| {
            let mut rest = e.clone();
            super::sums::replace(&mut rest, &apply("exp", u.clone()), &apply("exp", less(u, &top)));
            match exponent(e) {
                Some(_) => rest,
                None => product(vec![rest, apply("exp", negated(top.clone()))]),
            }
        };
        let mut rest = Vec::new();
        for ((sign, e), u) in list.iter().zip(&exponents) {
            let e = match self.leading(&minus(u, &top), x)? {
                lead if self.is_zero(&lead.c) => {
                    let mut e = e.clone();
                    super::sums::replace(&mut e, &apply("exp", u.clone()), &numeral(1));
                    e
                }
                _ => over_top(e, u),
            };
            rest.push((*sign, e));
        }
        Some((top, sum(rest)))
    }

    /// The sign of what does not depend on the variable, shown if need be.
    pub(super) fn sign_of_constant(&mut self, c: &Expr) -> Option<Signs> {
        let seen = self.signs_of(c);
        if seen.within(Signs::NOT_NEGATIVE) || seen.within(Signs::of(Relation::LessEqual)) {
            return Some(seen);
        }
        let sign = |relation| compare(c.clone(), relation, numeral(0));
        [Relation::Greater, Relation::Less].into_iter().find(|r| self.quietly(&sign(*r)).is_ok()).map(Signs::of)
    }

    /// u/(c·x^r), in lowest terms.
    fn rest(&mut self, u: &Expr, lead: &Leading, x: &str) -> Expr {
        let quotient = over(u.clone(), product(vec![lead.c.clone(), raised(&name(x), &lead.exponent)]));
        let small = minus(&quotient, &numeral(1));
        match self.simplified(&small) {
            Some(small) if natural(&small) == Some(0) => numeral(1),
            Some(small) => sum(vec![(Sign::Plus, numeral(1)), (Sign::Plus, small)]),
            None => quotient,
        }
    }
}
