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
//! vanishes. Where a sign depends on ln n there is no answer; of a quotient whose parts begin with such polynomials, these decide by their
//! degrees.
//!
//! Coefficients are enclosures; one that cannot be told from 0 is not taken for 0, and leads nothing (`series`).
//!
//! Cost: a fixed number of coefficients.

use super::evaluate::Assignment;
use super::number::{Number, invert, multiply};
use super::series::{Series, coefficients, composed, constant_of, exact, exponential_of, logarithm_of, sign};
use crate::claim::definedness::Exponent;
use crate::claim::syntax::*;
use crate::claim::walk::names_in;
use crate::kernel::statement::{expr, numeral};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::rc::Rc;

/// The highest whole power that is multiplied out.
const WHOLE: i64 = 60;

/// The highest degree of a sum in closed form.
const DEGREE: usize = 8;

/// What an expression tends to.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Tends {
    /// To this value.
    To(Number),
    /// It grows beyond every bound.
    Infinitely,
}

/// What an expression tends to as its variable grows, the other variables at the values of a point.
pub(crate) fn tends(point: &Assignment, limit: &Limit) -> Option<Tends> {
    let mut point = point.clone();
    point.values.remove(&limit.variable.text);
    Rc::make_mut(&mut point.numbers).remove(&limit.variable.text);
    let at = At { point: &point, variable: &limit.variable.text };
    let Some(series) = at.series(&limit.of) else {
        // The reciprocal of an exponentially growing expression tends to 0.
        return match at.product(&[(Factor::Over, limit.of.clone())]) {
            Some(reciprocal) if reciprocal.order > 0 => Some(Tends::Infinitely),
            _ => at.tends_slowly(&limit.of),
        };
    };
    if series.end() <= 0 {
        return None;
    }
    if series.order > 0 {
        return Some(Tends::To(Number::Exact(Rational::ZERO)));
    }
    let Some(lead) = constant_of(series.terms.first()?) else { return at.tends_slowly(&limit.of) };
    if series.order == 0 {
        return Some(Tends::To(lead));
    }
    sign(&lead).map(|_| Tends::Infinitely)
}

/// How an expression grows: as c·t^order·(ln n)^degree with c other than 0.
struct Growth {
    order: Rational,
    degree: usize,
    lead: Number,
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

    /// What a quotient tends to whose parts grow as powers of n and of ln n: each by its first power of ln n.
    fn tends_slowly(&self, e: &Expr) -> Option<Tends> {
        let whole = [(Factor::Times, e.clone())];
        let list = if let ExprKind::Product(list) = &e.kind { list.as_slice() } else { &whole };
        let part = |side: Factor| {
            let own = list.iter().filter(|(f, _)| *f == side).map(|(_, e)| (Factor::Times, e.clone()));
            self.growth(&self.product(&own.collect::<Vec<_>>())?)
        };
        let (above, below) = (part(Factor::Times)?, part(Factor::Over)?);
        let falls = above.order.cmp(&below.order).then(below.degree.cmp(&above.degree));
        Some(match falls {
            Ordering::Greater => Tends::To(exact(0)),
            Ordering::Less => Tends::Infinitely,
            Ordering::Equal => Tends::To(multiply(&above.lead, &invert(&below.lead, String::new).ok()?)),
        })
    }

    /// How a series grows, if its first power of ln n has a coefficient that is certainly not 0.
    fn growth(&self, series: &Series) -> Option<Growth> {
        let first = series.terms.first()?;
        let degree = first.iter().rposition(|c| !matches!(c, Number::Exact(q) if *q == 0))?;
        let lead = first.get(degree)?.clone();
        sign(&lead)?;
        Some(Growth { order: series.order.clone(), degree, lead })
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
pub(crate) fn by_exponentials(function: &str, x: &Expr) -> Expr {
    let exp = |x: Expr| expr(ExprKind::Apply(Name::new("exp"), vec![x]));
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
