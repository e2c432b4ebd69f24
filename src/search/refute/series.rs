//! Series in t = 1/n with finitely many coefficients, which are polynomials in ln n: sum, product, ln and exp.
//!
//! Contract: a series that is returned equals its expression up to O(t^(order + number of terms)). Coefficients are exact or
//! enclosed. One that cannot be told from 0 is not taken for 0.

use super::number::{Number, add, exponential, invert, logarithm, multiply};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::cmp::Ordering;

/// How many coefficients are kept.
const TERMS: usize = 5;

/// A power of t below which everything vanishes that falls exponentially.
const VANISHED: i64 = 1_000_000;

/// A polynomial in ln n: its coefficients, the constant first; 0 has none.
pub(super) type Coefficient = Vec<Number>;

/// Σ terms\[k\]·t^(order + k), up to O(t^(order + number of terms)); the first term is not exactly 0.
#[derive(Clone, Debug)]
pub(super) struct Series {
    pub(super) order: Rational,
    pub(super) terms: Vec<Coefficient>,
}

pub(super) fn exact(k: i64) -> Number {
    Number::Exact(Rational::from(k))
}

fn is_zero(x: &Number) -> bool {
    matches!(x, Number::Exact(q) if *q == 0)
}

/// The sign of a number that is certainly not 0.
pub(super) fn sign(x: &Number) -> Option<Ordering> {
    x.order(&exact(0)).filter(|order| *order != Ordering::Equal)
}

/// A coefficient that does not depend on ln n.
pub(super) fn constant_of(c: &Coefficient) -> Option<Number> {
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
    pub(super) fn constant(value: Number) -> Series {
        let mut terms = vec![Vec::new(); TERMS];
        terms[0] = without_zeros(vec![value]);
        Series { order: Rational::ZERO, terms }.stripped()
    }

    fn vanished() -> Series {
        Series { order: Rational::from(VANISHED), terms: Vec::new() }
    }

    pub(super) fn end(&self) -> Rational {
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
    pub(super) fn plus(&self, other: &Series) -> Option<Series> {
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

    pub(super) fn times(&self, other: &Series) -> Series {
        let length = self.terms.len().min(other.terms.len());
        let term = |k: usize| {
            (0..=k).fold(Vec::new(), |sum, i| sum_of(&sum, &product_of(&self.terms[i], &other.terms[k - i])))
        };
        Series { order: &self.order + &other.order, terms: (0..length).map(term).collect() }.stripped()
    }

    pub(super) fn scaled(&self, factor: &Number) -> Series {
        self.times(&Series::constant(factor.clone()))
    }

    /// The leading coefficient c, certainly not 0 and without ln n, its sign, and s/(c·t^order) − 1.
    pub(super) fn lead(&self) -> Option<(Number, Ordering, Series)> {
        let lead = constant_of(self.terms.first()?)?;
        let sign = sign(&lead)?;
        let inverse = vec![invert(&lead, String::new).ok()?];
        let rest = self.terms.iter().skip(1).map(|c| product_of(c, &inverse));
        let terms = std::iter::once(Vec::new()).chain(rest).collect();
        Some((lead, sign, Series { order: Rational::ZERO, terms }.stripped()))
    }
}

/// Σ coefficients\[k\]·u^k, for u without constant term.
pub(super) fn composed(coefficients: &[Rational], u: &Series) -> Option<Series> {
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

/// Coefficients from the first, each by what the last is multiplied with.
pub(super) fn coefficients(next: impl Fn(i64) -> Rational) -> Vec<Rational> {
    let mut list = vec![Rational::ONE];
    for k in 1..i64::try_from(TERMS).unwrap_or(1) {
        let last = list.last().cloned().unwrap_or(Rational::ONE);
        list.push(last * next(k));
    }
    list
}

pub(super) fn logarithm_of(s: &Series) -> Option<Series> {
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

pub(super) fn exponential_of(s: &Series) -> Option<Series> {
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
