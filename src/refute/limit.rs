//! Limits at infinity, at a point: series in t = 1/n whose coefficients are numbers.
//!
//! Contract: [`tends`] returns a number, exact or enclosed, that is the limit of an expression as its variable n grows, the
//! other variables at the values of a point; or that the expression grows beyond every bound; or `None` where this method
//! does not reach.
//!
//! Why it is right: a constant power c^E with c > 0 is exp(E·ln c). Sums, products, quotients with a leading coefficient that
//! is certainly not 0, ln of a series with a positive leading coefficient and exp of a series without pole are analytic in t
//! near 0 apart from a power of t, and their coefficients are those of the formal operations. exp(c/t^k + …) with c < 0
//! vanishes faster than every power of t. So the value tends, as t falls to 0, to the coefficient of t^0 where there is no
//! pole. A coefficient is a polynomial in ln n, which grows slower than every power of n: times a positive power of t it
//! vanishes. Where a sign, or the limit itself, would depend on ln n, there is no answer.
//!
//! Coefficients are enclosures. One that contains 0 is not taken for 0, and cannot be a leading coefficient.
//!
//! Cost: a fixed number of coefficients (`TERMS`).

use super::evaluate::Assignment;
use super::number::{Number, add, exponential, invert, logarithm, multiply};
use crate::claim::definedness::Exponent;
use crate::claim::syntax::*;
use crate::claim::walk::names_in;
use crate::kernel::statement::{expr, numeral};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// How many coefficients are kept.
const TERMS: usize = 5;

/// The highest whole power that is multiplied out.
const WHOLE: i64 = 60;

/// The highest degree of a sum in closed form.
const DEGREE: usize = 8;

/// The order in t given to terms that decrease exponentially.
const VANISHED: i64 = 1_000_000;

/// The limit of an expression.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Tends {
    /// To this value.
    To(Number),
    /// It grows beyond every bound.
    Infinitely,
}

/// A polynomial in ln n: its coefficients, the constant first; 0 has none.
type Coefficient = Vec<Number>;

/// Σ terms\[k\]·t^(order + k), up to O(t^(order + number of terms)); the first term is not exactly 0.
#[derive(Clone, Debug)]
struct Series {
    order: Rational,
    terms: Vec<Coefficient>,
}

/// The limit of an expression as its variable grows, with the other variables at the values of a point.
pub(crate) fn tends(point: &Assignment, limit: &Limit) -> Option<Tends> {
    let mut point = point.clone();
    point.values.remove(&limit.variable.text);
    let at = At { point: &point, variable: &limit.variable.text };
    let Some(series) = at.series(&limit.of) else {
        // The reciprocal of an exponentially growing expression tends to 0.
        let reciprocal = at.product(&[(Factor::Over, limit.of.clone())])?;
        return (reciprocal.order > 0).then_some(Tends::Infinitely);
    };
    if series.end() <= 0 {
        return None;
    }
    if series.order > 0 {
        return Some(Tends::To(Number::Exact(Rational::ZERO)));
    }
    let lead = constant_of(series.terms.first()?)?;
    if series.order == 0 {
        return Some(Tends::To(lead));
    }
    sign(&lead).map(|_| Tends::Infinitely)
}

fn exact(k: i64) -> Number {
    Number::Exact(Rational::from(k))
}

fn is_zero(x: &Number) -> bool {
    matches!(x, Number::Exact(q) if *q == 0)
}

/// The sign of a number that is certainly not 0.
fn sign(x: &Number) -> Option<Ordering> {
    x.order(&exact(0)).filter(|order| *order != Ordering::Equal)
}

/// A coefficient that does not depend on ln n.
fn constant_of(c: &Coefficient) -> Option<Number> {
    match c.as_slice() {
        [] => Some(exact(0)),
        [one] => Some(one.clone()),
        _ => None,
    }
}

fn sum_of(a: &Coefficient, b: &Coefficient) -> Coefficient {
    let zero = exact(0);
    let each = |k: usize| add(a.get(k).unwrap_or(&zero), b.get(k).unwrap_or(&zero));
    without_zeros((0..a.len().max(b.len())).map(each).collect())
}

fn product_of(a: &Coefficient, b: &Coefficient) -> Coefficient {
    let mut out = vec![exact(0); (a.len() + b.len()).saturating_sub(1)];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            out[i + j] = add(&out[i + j], &multiply(x, y));
        }
    }
    without_zeros(out)
}

fn without_zeros(mut c: Coefficient) -> Coefficient {
    while c.last().is_some_and(is_zero) {
        c.pop();
    }
    c
}

impl Series {
    fn constant(value: Number) -> Series {
        let mut terms = vec![Vec::new(); TERMS];
        terms[0] = without_zeros(vec![value]);
        Series { order: Rational::ZERO, terms }.stripped()
    }

    fn vanished() -> Series {
        Series { order: Rational::from(VANISHED), terms: Vec::new() }
    }

    fn end(&self) -> Rational {
        &self.order + Rational::from(self.terms.len())
    }

    fn stripped(mut self) -> Series {
        let zeros = self.terms.iter().take_while(|c| c.is_empty()).count();
        self.terms.drain(..zeros);
        self.order += Rational::from(zeros);
        self
    }

    /// The coefficient of a power of t.
    fn at(&self, power: &Rational) -> Coefficient {
        let place = usize::try_from(&(power - &self.order)).ok();
        place.and_then(|k| self.terms.get(k).cloned()).unwrap_or_default()
    }

    /// The sum; none where the powers of t of two summands differ by no whole number.
    fn plus(&self, other: &Series) -> Option<Series> {
        let apart = &self.order - &other.order;
        if i64::try_from(&apart).is_err() && !self.terms.is_empty() && !other.terms.is_empty() {
            return None;
        }
        let end = self.end().min(other.end());
        let starts = [self, other].into_iter().filter(|s| !s.terms.is_empty()).map(|s| s.order.clone());
        let order = starts.min().unwrap_or_else(|| end.clone()).min(end.clone());
        let mut terms = Vec::new();
        let mut power = order.clone();
        while power < end && terms.len() < 4 * TERMS {
            terms.push(sum_of(&self.at(&power), &other.at(&power)));
            power += Rational::ONE;
        }
        // Where an end is no whole step away, what stands beyond it is cut off.
        if power > end {
            terms.pop();
        }
        Some(Series { order, terms }.stripped())
    }

    fn times(&self, other: &Series) -> Series {
        let length = self.terms.len().min(other.terms.len());
        let term = |k: usize| {
            (0..=k).fold(Vec::new(), |sum, i| sum_of(&sum, &product_of(&self.terms[i], &other.terms[k - i])))
        };
        Series { order: &self.order + &other.order, terms: (0..length).map(term).collect() }.stripped()
    }

    fn scaled(&self, factor: &Number) -> Series {
        self.times(&Series::constant(factor.clone()))
    }

    /// The leading coefficient c, certainly not 0 and without ln n, its sign, and s/(c·t^order) − 1.
    fn lead(&self) -> Option<(Number, Ordering, Series)> {
        let lead = constant_of(self.terms.first()?)?;
        let sign = sign(&lead)?;
        let inverse = vec![invert(&lead, String::new).ok()?];
        let rest = self.terms.iter().skip(1).map(|c| product_of(c, &inverse));
        let terms = std::iter::once(Vec::new()).chain(rest).collect();
        Some((lead, sign, Series { order: Rational::ZERO, terms }.stripped()))
    }
}

/// Σ coefficients\[k\]·u^k, for u without constant term.
fn composed(coefficients: &[Rational], u: &Series) -> Option<Series> {
    let mut power = Series::constant(exact(1));
    // The series that is cut off starts with u to the number of coefficients.
    let end = (&u.order * Rational::from(coefficients.len())).min(u.end());
    let mut sum = Series { order: end, terms: Vec::new() };
    for c in coefficients {
        sum = sum.plus(&power.scaled(&Number::Exact(c.clone())))?;
        power = power.times(u);
    }
    Some(sum)
}

/// The coefficients 1, next(1), next(1)·next(2), …: each is the one before times the next factor.
fn coefficients(next: impl Fn(i64) -> Rational) -> Vec<Rational> {
    let mut list = vec![Rational::ONE];
    for k in 1..i64::try_from(TERMS).unwrap_or(1) {
        let last = list.last().cloned().unwrap_or(Rational::ONE);
        list.push(last * next(k));
    }
    list
}

fn logarithm_of(s: &Series) -> Option<Series> {
    let (lead, Ordering::Greater, u) = s.lead()? else { return None };
    // ln(c·t^k) = ln c − k·ln n.
    let growing = Number::Exact(-s.order.clone());
    let constant = without_zeros(vec![logarithm(&lead, String::new).ok()?, growing]);
    let mut terms = vec![Vec::new(); TERMS];
    terms[0] = constant;
    let constant = Series { order: Rational::ZERO, terms }.stripped();
    let mut list = vec![Rational::ZERO];
    list.extend(
        (1..i64::try_from(TERMS).unwrap_or(1)).map(|k| Rational::from_signeds(if k % 2 == 1 { 1 } else { -1 }, k)),
    );
    constant.plus(&composed(&list, &u)?)
}

fn exponential_of(s: &Series) -> Option<Series> {
    let (zero, mut s) = (Rational::ZERO, s.clone());
    // exp(k·ln n) = t^(−k).
    let mut shift = Rational::ZERO;
    if let Ok(place) = usize::try_from(&-s.order.clone())
        && let Some([_, Number::Exact(k)]) = s.terms.get(place).map(Vec::as_slice)
    {
        shift = -k.clone();
        s.terms[place].truncate(1);
        s.terms[place] = without_zeros(s.terms[place].clone());
        s = s.stripped();
    }
    if s.end() <= 0 {
        return None;
    }
    let early = s.terms.iter().zip(0i64..).filter(|(_, k)| &s.order + Rational::from(*k) <= 0);
    if early.into_iter().any(|(c, _)| c.len() > 1) {
        return None;
    }
    if s.order < 0 {
        let falls = sign(&constant_of(s.terms.first()?)?)? == Ordering::Less;
        return falls.then(Series::vanished);
    }
    let constant = match constant_of(&s.at(&zero))? {
        x if is_zero(&x) => exact(1),
        x => exponential(&x).ok()?,
    };
    if s.order == 0 && !s.terms.is_empty() {
        s.terms[0] = Vec::new();
        s = s.stripped();
    }
    let mut power = composed(&coefficients(|k| Rational::from_signeds(1, k)), &s)?.scaled(&constant);
    power.order += shift;
    Some(power)
}

/// The expressions of one limit at a point.
struct At<'a> {
    point: &'a Assignment,
    variable: &'a str,
}

impl At<'_> {
    fn moves(&self, e: &Expr) -> bool {
        let mut names = BTreeSet::new();
        names_in(e, &mut names);
        names.contains(self.variable)
    }

    fn series(&self, e: &Expr) -> Option<Series> {
        if !self.moves(e) {
            return Some(Series::constant(self.point.number(e).ok()?));
        }
        match &e.kind {
            ExprKind::Name(_) => Some(Series { order: Rational::from(-1), ..Series::constant(exact(1)) }),
            ExprKind::Negate(a) => Some(self.series(a)?.scaled(&exact(-1))),
            ExprKind::Sum(list) => {
                let mut sum: Option<Series> = None;
                for (sign, e) in list {
                    let next = self.series(e)?.scaled(&exact(if *sign == Sign::Plus { 1 } else { -1 }));
                    sum = Some(match sum {
                        Some(sum) => sum.plus(&next)?,
                        None => next,
                    });
                }
                sum
            }
            ExprKind::Apply(f, arguments) => match (f.text.as_str(), arguments.as_slice()) {
                ("ln", [x]) => logarithm_of(&self.series(x)?),
                ("cosh" | "sinh" | "tanh" | "sech", [x]) => self.series(&by_exponentials(&f.text, x)),
                ("exp" | "sqrt" | "cbrt", [_]) => self.product(&[(Factor::Times, e.clone())]),
                _ => None,
            },
            ExprKind::SumOver(index, body) => self.sum_over(index, body),
            ExprKind::Product(list) => self.product(list),
            ExprKind::Power(..) => self.product(&[(Factor::Times, e.clone())]),
            _ => None,
        }
    }

    /// A sum up to the variable: of a polynomial in the index, or a geometric one whose ratio is less than 1 in size.
    ///
    /// S(n) = f(a) + … + f(n) is a polynomial of one degree more in n, with S(a − 1) = 0: its values at a − 1, …, a + d tell it.
    fn sum_over(&self, index: &Index, body: &Expr) -> Option<Series> {
        let is_variable = matches!(&index.to.kind, ExprKind::Name(n) if n == self.variable);
        if !is_variable || self.moves(&index.from) || self.moves(body) || self.variable == index.name.text {
            return None;
        }
        let rational = |point: &Assignment, e: &Expr| match point.number(e).ok()? {
            Number::Exact(q) => Some(q),
            Number::Between(..) => None,
        };
        let from = rational(self.point, &index.from)?;
        let at = |k: usize| {
            let mut inner = self.point.clone();
            inner.indices.insert(index.name.text.clone(), &from + Rational::from(k));
            rational(&inner, body)
        };
        if let Some(ratio) = self.ratio(body, &index.name.text) {
            // S(n) tends to f(a)/(1 − q), faster than any power of n.
            let q = rational(self.point, &ratio)?;
            let bounded = q > -1 && q < 1;
            return bounded
                .then_some(())
                .and_then(|()| Some(Series::constant(Number::Exact(at(0)? / (Rational::ONE - q)))));
        }
        let degree = degree_in(body, &index.name.text).filter(|d| *d <= DEGREE)?;
        // Newton's form: S = Σ Δ^k·binomial(n − a + 1, k).
        let mut values = vec![Rational::ZERO];
        for k in 0..=degree {
            let last = values.last().cloned()?;
            values.push(last + at(k)?);
        }
        let n = Series { order: Rational::from(-1), ..Series::constant(exact(1)) };
        let steps = n.plus(&Series::constant(Number::Exact(Rational::ONE - &from)))?;
        let (mut sum, mut binomial) = (None::<Series>, Series::constant(exact(1)));
        let mut k = 0i64;
        while let Some(first) = values.first().cloned() {
            if first != 0 {
                let term = binomial.scaled(&Number::Exact(first));
                sum = Some(match sum {
                    Some(sum) => sum.plus(&term)?,
                    None => term,
                });
            }
            let next = steps.plus(&Series::constant(exact(-k)))?;
            binomial = binomial.times(&next).scaled(&Number::Exact(Rational::from_signeds(1, k + 1)));
            values = values.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
            k += 1;
        }
        Some(sum.unwrap_or_else(|| Series::constant(exact(0))))
    }

    /// The ratio of a member of a geometric sequence to the one before.
    fn ratio(&self, body: &Expr, index: &str) -> Option<Expr> {
        match &body.kind {
            ExprKind::Negate(a) => self.ratio(a, index),
            ExprKind::Product(list) => {
                let mut with = list.iter().filter(|(_, e)| stands_in(index, e));
                match (with.next(), with.next()) {
                    (Some((Factor::Times, e)), None) => self.ratio(e, index),
                    (Some((Factor::Over, e)), None) => {
                        let one = (Factor::Times, numeral(1));
                        Some(expr(ExprKind::Product(vec![one, (Factor::Over, self.ratio(e, index)?)])))
                    }
                    _ => None,
                }
            }
            ExprKind::Power(base, exponent) if !stands_in(index, base) => {
                // What is added to the exponent for each step, which has to be the same for all.
                let slope = slope_in(exponent, index)?;
                Some(expr(ExprKind::Power(base.clone(), Box::new(slope))))
            }
            _ => None,
        }
    }

    /// A product: what is raised to something that moves is collected under one exponential.
    fn product(&self, list: &[(Factor, Expr)]) -> Option<Series> {
        self.collected(list).or_else(|| self.distributed(list))
    }

    /// A product as a sum of products: what grows in one factor may fall in another.
    fn distributed(&self, list: &[(Factor, Expr)]) -> Option<Series> {
        let is_sum =
            |(f, e): &(Factor, Expr)| *f == Factor::Times && matches!(e.kind, ExprKind::Sum(_)) && self.moves(e);
        let place = list.iter().position(is_sum).filter(|_| list.len() > 1)?;
        let ExprKind::Sum(summands) = &list[place].1.kind else { return None };
        let product = |e: &Expr| {
            let mut list = list.to_vec();
            list[place].1 = e.clone();
            expr(ExprKind::Product(list))
        };
        self.series(&expr(ExprKind::Sum(summands.iter().map(|(sign, e)| (*sign, product(e))).collect())))
    }

    fn collected(&self, list: &[(Factor, Expr)]) -> Option<Series> {
        let (mut plain, mut log) = (Series::constant(exact(1)), None);
        for (factor, e) in list {
            self.factor(e, *factor == Factor::Over, &mut plain, &mut log)?;
        }
        match log {
            None => Some(plain),
            Some(log) => Some(plain.times(&exponential_of(&log)?)),
        }
    }

    fn factor(&self, e: &Expr, over: bool, plain: &mut Series, log: &mut Option<Series>) -> Option<()> {
        let side = if over { exact(-1) } else { exact(1) };
        let mut under = |summand: Series| {
            let summand = summand.scaled(&side);
            *log = Some(match log.take() {
                None => summand,
                Some(sum) => sum.plus(&summand)?,
            });
            Some(())
        };
        match &e.kind {
            ExprKind::Negate(a) => {
                *plain = plain.scaled(&exact(-1));
                return self.factor(a, over, plain, log);
            }
            ExprKind::Product(list) if self.moves(e) => {
                return list.iter().try_for_each(|(f, e)| self.factor(e, over != (*f == Factor::Over), plain, log));
            }
            ExprKind::Power(a, b) if self.moves(b) => {
                return under(logarithm_of(&self.series(a)?)?.times(&self.series(b)?));
            }
            ExprKind::Apply(f, list) if f.text == "exp" && self.moves(e) => return under(self.series(list.first()?)?),
            _ => {}
        }
        let (base, q) = match &e.kind {
            ExprKind::Power(a, b) if self.moves(e) => match self.point.number(b).ok()? {
                Number::Exact(q) => (self.series(a)?, q),
                Number::Between(..) => return None,
            },
            ExprKind::Apply(f, list) if self.moves(e) && f.text == "sqrt" => {
                (self.series(list.first()?)?, Rational::from_signeds(1, 2))
            }
            ExprKind::Apply(f, list) if self.moves(e) && f.text == "cbrt" => {
                (self.series(list.first()?)?, Rational::from_signeds(1, 3))
            }
            _ => (self.series(e)?, Rational::ONE),
        };
        *plain = plain.times(&self.power(&base, &if over { -q } else { q })?);
        Some(())
    }

    fn power(&self, s: &Series, q: &Rational) -> Option<Series> {
        if let Ok(k @ 1..=WHOLE) = i64::try_from(q) {
            return Some((1..k).fold(s.clone(), |power, _| power.times(s)));
        }
        let (lead, sign, u) = s.lead()?;
        let kind = if i64::try_from(q).is_ok() { Exponent::Whole } else { Exponent::Real };
        if kind != Exponent::Whole && sign != Ordering::Greater {
            return None;
        }
        let power = self.point.power(&lead, &Number::Exact(q.clone()), kind, &numeral(1)).ok()?;
        // (1 + u)^q by the binomial series.
        let binomial = coefficients(|k| (q - Rational::from(k - 1)) / Rational::from(k));
        let mut out = composed(&binomial, &u)?.scaled(&power);
        out.order += q * &s.order;
        Some(out)
    }
}

fn stands_in(name: &str, e: &Expr) -> bool {
    let mut names = BTreeSet::new();
    names_in(e, &mut names);
    names.contains(name)
}

/// The degree of a polynomial in the index; `None` for anything else.
fn degree_in(e: &Expr, index: &str) -> Option<usize> {
    if !stands_in(index, e) {
        return Some(0);
    }
    match &e.kind {
        ExprKind::Name(_) => Some(1),
        ExprKind::Negate(a) => degree_in(a, index),
        ExprKind::Sum(list) => list.iter().map(|(_, e)| degree_in(e, index)).try_fold(0, |most, d| Some(d?.max(most))),
        ExprKind::Product(list) => list.iter().try_fold(0, |sum, (factor, e)| {
            let own = degree_in(e, index)?;
            (own == 0 || *factor == Factor::Times).then_some(sum + own)
        }),
        ExprKind::Power(a, k) => {
            let (k, 1) = crate::claim::definedness::number(k)? else { return None };
            degree_in(a, index)?.checked_mul(usize::try_from(k).ok()?)
        }
        _ => None,
    }
}

/// The slope of an expression that is linear in the index, with numerals as coefficients.
fn slope_in(e: &Expr, index: &str) -> Option<Expr> {
    match &e.kind {
        ExprKind::Name(n) if n == index => Some(numeral(1)),
        _ if !stands_in(index, e) => Some(numeral(0)),
        ExprKind::Sum(list) => {
            let slopes: Option<Vec<_>> = list.iter().map(|(sign, e)| Some((*sign, slope_in(e, index)?))).collect();
            Some(expr(ExprKind::Sum(slopes?)))
        }
        ExprKind::Product(list) => match list.as_slice() {
            [(Factor::Times, c @ Expr { kind: ExprKind::Number(_), .. }), (Factor::Times, e)] => {
                Some(expr(ExprKind::Product(vec![(Factor::Times, c.clone()), (Factor::Times, slope_in(e, index)?)])))
            }
            _ => None,
        },
        _ => None,
    }
}

/// cosh, sinh, tanh and sech by exponentials.
fn by_exponentials(function: &str, x: &Expr) -> Expr {
    let name = |text: &str| Name { text: text.to_string(), span: Span::default() };
    let exp = |x: Expr| expr(ExprKind::Apply(name("exp"), vec![x]));
    let (up, down) = (exp(x.clone()), exp(expr(ExprKind::Negate(Box::new(x.clone())))));
    let of = |sign: Sign| expr(ExprKind::Sum(vec![(Sign::Plus, up.clone()), (sign, down.clone())]));
    let over = |a: Expr, b: Expr| expr(ExprKind::Product(vec![(Factor::Times, a), (Factor::Over, b)]));
    match function {
        "cosh" => over(of(Sign::Plus), numeral(2)),
        "sinh" => over(of(Sign::Minus), numeral(2)),
        "sech" => over(numeral(2), of(Sign::Plus)),
        _ => over(of(Sign::Minus), of(Sign::Plus)),
    }
}
