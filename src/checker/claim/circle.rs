//! Cosine and sine of sums of angles, exactly.
//!
//! Contract: a [`Point`] holds cos u and sin u as polynomials with rational coefficients in the cosines and sines of
//! named angles and in the roots that the multiples of π/120 need. Nothing is rounded, and c² + s² = 1 is not used.
//! To add two angles is to multiply cos u + i·sin u by cos v + i·sin v.

use super::matrix::{apply, at, numeral};
use super::syntax::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::collections::BTreeMap;

/// The largest multiple of an angle.
pub(crate) const MULTIPLE_LIMIT: i64 = 24;

/// The most products of terms in a cosine or sine of a sum.
pub(crate) const TERMS_LIMIT: usize = 10_000;

/// What a term is a product of.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Letter {
    /// The name of a cosine.
    Cosine(String),
    /// The name of a sine.
    Sine(String),
    /// √2, √3 or √5.
    Root(u32),
    /// √(2 + √2) = 2·cos(π/8).
    Eighth,
    /// √(10 − 2·√5) = 4·sin(π/5).
    Fifth,
}

type Monomial = BTreeMap<Letter, u32>;

/// A sum of monomials with coefficients other than 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Polynomial(BTreeMap<Monomial, BigRational>);

fn ratio(top: i64, bottom: i64) -> BigRational {
    BigRational::new(BigInt::from(top), BigInt::from(bottom))
}

impl Polynomial {
    /// Coefficients, each with the letters that it stands before.
    fn of(terms: &[(BigRational, &[Letter])]) -> Polynomial {
        let mut out = Polynomial::default();
        for (coefficient, letters) in terms {
            let mut monomial = Monomial::new();
            letters.iter().for_each(|letter| *monomial.entry(letter.clone()).or_default() += 1);
            out.add(monomial, coefficient.clone());
        }
        out
    }

    fn number(k: i64) -> Polynomial {
        Polynomial::of(&[(ratio(k, 1), &[])])
    }

    /// Adds a term. Squares of roots are numbers: √p² = p, √(2 + √2)² = 2 + √2, √(10 − 2√5)² = 10 − 2√5.
    fn add(&mut self, mut monomial: Monomial, coefficient: BigRational) {
        let square = monomial
            .iter()
            .find(|(letter, k)| **k >= 2 && matches!(letter, Letter::Root(_) | Letter::Eighth | Letter::Fifth));
        if let Some((letter, k)) = square.map(|(letter, k)| (letter.clone(), *k)) {
            match k {
                2 => monomial.remove(&letter),
                _ => monomial.insert(letter.clone(), k - 2),
            };
            let (number, root) = match letter {
                Letter::Eighth => (2, Some((2, 1))),
                Letter::Fifth => (10, Some((5, -2))),
                Letter::Root(p) => (i64::from(p), None),
                Letter::Cosine(_) | Letter::Sine(_) => (1, None),
            };
            if let Some((p, times)) = root {
                let mut other = monomial.clone();
                *other.entry(Letter::Root(p)).or_default() += 1;
                self.add(other, &coefficient * ratio(times, 1));
            }
            return self.add(monomial, coefficient * ratio(number, 1));
        }
        let sum = self.0.remove(&monomial).unwrap_or_else(BigRational::zero) + coefficient;
        if !sum.is_zero() {
            self.0.insert(monomial, sum);
        }
    }

    fn plus(mut self, other: &Polynomial, sign: i64) -> Polynomial {
        other.0.iter().for_each(|(monomial, c)| self.add(monomial.clone(), c * ratio(sign, 1)));
        self
    }

    fn times(&self, other: &Polynomial) -> Polynomial {
        let mut out = Polynomial::default();
        for (a, c) in &self.0 {
            for (b, d) in &other.0 {
                let mut monomial = a.clone();
                b.iter().for_each(|(letter, k)| *monomial.entry(letter.clone()).or_default() += k);
                out.add(monomial, c * d);
            }
        }
        out
    }

    /// Every denominator is a power of two: the largest is a multiple of all.
    fn common_denominator(&self) -> BigInt {
        self.0.values().map(|c| c.denom().clone()).max().unwrap_or_else(BigInt::one)
    }

    /// The polynomial over a common denominator.
    fn written(&self, span: Span) -> Expr {
        let whole = |q: BigInt| at(span, ExprKind::Number(q.to_string()));
        let below = self.common_denominator();
        let mut terms: Vec<(&Monomial, BigInt)> = self
            .0
            .iter()
            .map(|(monomial, c)| (monomial, (c * BigRational::from_integer(below.clone())).to_integer()))
            .collect();
        // What is added stands before what is subtracted.
        terms.sort_by_key(|(_, c)| c.is_negative());
        let mut list = Vec::new();
        for (monomial, c) in terms {
            let mut factors = letters_written(monomial, span);
            if !c.abs().is_one() || factors.is_empty() {
                factors.insert(0, whole(c.abs()));
            }
            let term = match factors.len() {
                1 => factors.remove(0),
                _ => at(span, ExprKind::Product(factors.into_iter().map(|f| (Factor::Times, f)).collect())),
            };
            list.push((if c.is_negative() { Sign::Minus } else { Sign::Plus }, term));
        }
        // A minus sign before all terms stands before the fraction.
        let negative = list.iter().all(|(sign, _)| *sign == Sign::Minus) && !list.is_empty();
        if negative {
            list.iter_mut().for_each(|(sign, _)| *sign = Sign::Plus);
        }
        let sum = match list.len() {
            0 => numeral(span, 0),
            1 => list.remove(0).1,
            _ => at(span, ExprKind::Sum(list)),
        };
        let fraction = match below.is_one() {
            true => sum,
            false => at(span, ExprKind::Product(vec![(Factor::Times, sum), (Factor::Over, whole(below))])),
        };
        if negative { at(span, ExprKind::Negate(Box::new(fraction))) } else { fraction }
    }
}

/// The factors of a term; roots of whole numbers as one root.
fn letters_written(monomial: &Monomial, span: Span) -> Vec<Expr> {
    let whole = |k: u32| numeral(span, k);
    let root = |of: Expr| apply(span, "sqrt", of);
    let two_terms = |a: u32, sign: Sign, b: Expr| at(span, ExprKind::Sum(vec![(Sign::Plus, whole(a)), (sign, b)]));
    let radicand: u32 = monomial.keys().map(|l| if let Letter::Root(p) = l { *p } else { 1 }).product();
    let mut out = Vec::new();
    for (letter, k) in monomial {
        let base = match letter {
            Letter::Cosine(name) | Letter::Sine(name) => at(span, ExprKind::Name(name.clone())),
            Letter::Root(_) => continue,
            Letter::Eighth => root(two_terms(2, Sign::Plus, root(whole(2)))),
            Letter::Fifth => {
                let twice = vec![(Factor::Times, whole(2)), (Factor::Times, root(whole(5)))];
                root(two_terms(10, Sign::Minus, at(span, ExprKind::Product(twice))))
            }
        };
        out.push(match k {
            1 => base,
            k => at(span, ExprKind::Power(Box::new(base), Box::new(whole(*k)))),
        });
    }
    if radicand > 1 {
        out.push(root(whole(radicand)));
    }
    out
}

/// A comparison at a place.
pub(super) fn compared(left: Expr, relation: Relation, right: Expr) -> Prop {
    let span = left.span;
    Prop { kind: PropKind::Compare(vec![left, right], vec![relation]), span }
}

/// A point of the unit circle: the cosine and the sine of an angle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Point {
    cos: Polynomial,
    sin: Polynomial,
}

impl Point {
    /// The point whose cosine and sine have these names.
    pub(super) fn named(cos: &str, sin: &str) -> Point {
        let one = |letter: Letter| Polynomial::of(&[(ratio(1, 1), &[letter])]);
        Point { cos: one(Letter::Cosine(cos.to_string())), sin: one(Letter::Sine(sin.to_string())) }
    }

    /// The point of the angle 0.
    pub(super) fn zero() -> Point {
        Point { cos: Polynomial::number(1), sin: Polynomial::default() }
    }

    /// The point of so many times π, where that is a multiple of π/120.
    ///
    /// Every whole number m is 10·a + 15·b + 24·c for some a, b, c, so that π/12, π/8 and π/5 are enough.
    pub fn of_turns(turns: &BigRational) -> Option<Point> {
        let scaled = turns * ratio(120, 1);
        if !scaled.is_integer() {
            return None;
        }
        let m = (scaled.to_integer() % BigInt::from(240)).to_i64()?;
        let counts = (0..10).flat_map(|c| (0..16).map(move |b| (b, c)));
        let (b, c) = counts.into_iter().find(|(b, c)| (m - 15 * b - 24 * c).rem_euclid(10) == 0)?;
        let a = ((m - 15 * b - 24 * c) / 10).rem_euclid(24);
        use Letter::{Eighth, Fifth, Root};
        let twelfth = |sign: i64| Polynomial::of(&[(ratio(1, 4), &[Root(2), Root(3)]), (ratio(sign, 4), &[Root(2)])]);
        let twelfth = Point { cos: twelfth(1), sin: twelfth(-1) };
        let eighth = Point {
            cos: Polynomial::of(&[(ratio(1, 2), &[Eighth])]),
            sin: Polynomial::of(&[(ratio(1, 2), &[Root(2), Eighth]), (ratio(-1, 2), &[Eighth])]),
        };
        let fifth = Point {
            cos: Polynomial::of(&[(ratio(1, 4), &[]), (ratio(1, 4), &[Root(5)])]),
            sin: Polynomial::of(&[(ratio(1, 4), &[Fifth])]),
        };
        twelfth.times(a)?.plus(&eighth.times(b)?)?.plus(&fifth.times(c)?)
    }

    /// The point of the sum of two angles; `None` where it has more than [`TERMS_LIMIT`] terms.
    pub(super) fn plus(&self, other: &Point) -> Option<Point> {
        if self.terms().saturating_mul(other.terms()) > TERMS_LIMIT {
            return None;
        }
        Some(Point {
            cos: self.cos.times(&other.cos).plus(&self.sin.times(&other.sin), -1),
            sin: self.sin.times(&other.cos).plus(&self.cos.times(&other.sin), 1),
        })
    }

    /// The point of a multiple of the angle, at most [`MULTIPLE_LIMIT`] times it.
    pub(super) fn times(&self, k: i64) -> Option<Point> {
        if k.abs() > MULTIPLE_LIMIT {
            return None;
        }
        let mut out = Point::zero();
        for _ in 0..k.abs() {
            out = out.plus(self)?;
        }
        Some(if k < 0 { out.opposite() } else { out })
    }

    /// The point of the opposite angle.
    pub(crate) fn opposite(self) -> Point {
        Point { sin: Polynomial::default().plus(&self.sin, -1), cos: self.cos }
    }

    /// The number of terms.
    pub(super) fn terms(&self) -> usize {
        self.cos.0.len() + self.sin.0.len()
    }

    /// The cosine.
    pub fn cosine(&self, span: Span) -> Expr {
        self.cos.written(span)
    }

    /// The sine.
    pub fn sine(&self, span: Span) -> Expr {
        self.sin.written(span)
    }

    /// The sine compared with 0, over what is positive in all its terms; `-s >= 0` is written `s <= 0`.
    pub(crate) fn sine_is(&self, relation: Relation, span: Span) -> Prop {
        let mut sine = self.sin.clone();
        for root in [2, 3, 5].map(Letter::Root) {
            if sine.0.keys().all(|monomial| monomial.contains_key(&root)) {
                sine = Polynomial(
                    sine.0
                        .into_iter()
                        .map(|(mut monomial, c)| {
                            monomial.remove(&root);
                            (monomial, c)
                        })
                        .collect(),
                );
            }
        }
        let turned = !sine.0.is_empty() && sine.0.values().all(Signed::is_negative);
        let below = sine.common_denominator();
        let scale = BigRational::from_integer(if turned { -below } else { below });
        sine.0.values_mut().for_each(|c| *c *= &scale);
        let relation = if turned { relation.turned() } else { relation };
        compared(sine.written(span), relation, numeral(span, 0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claim::print::expr;

    fn turns(top: i64, bottom: i64) -> Point {
        Point::of_turns(&ratio(top, bottom)).expect("a multiple of π/120")
    }

    fn both(point: &Point) -> (String, String) {
        (expr(&point.cosine(Span::default())), expr(&point.sine(Span::default())))
    }

    #[test]
    fn known_values_are_written_as_in_textbooks() {
        let said = |top, bottom| {
            let (c, s) = both(&turns(top, bottom));
            format!("{c}; {s}")
        };
        assert_eq!(said(0, 1), "1; 0");
        assert_eq!(said(1, 6), "sqrt(3)/2; 1/2");
        assert_eq!(said(1, 4), "sqrt(2)/2; sqrt(2)/2");
        assert_eq!(said(1, 12), "(sqrt(2) + sqrt(6))/4; (sqrt(6) - sqrt(2))/4");
        assert_eq!(said(-7, 2), "0; 1");
        assert_eq!(said(2, 3), "-1/2; sqrt(3)/2");
        assert_eq!(said(1, 5), "(1 + sqrt(5))/4; sqrt(10 - 2*sqrt(5))/4");
        assert_eq!(said(1, 8), "sqrt(2 + sqrt(2))/2; (sqrt(2 + sqrt(2))*sqrt(2) - sqrt(2 + sqrt(2)))/2");
        assert!(Point::of_turns(&ratio(1, 7)).is_none());
    }

    #[test]
    fn every_multiple_lies_where_floating_point_says() {
        let value = |p: &Polynomial| -> f64 {
            p.0.iter()
                .map(|(monomial, c)| {
                    let letter = |(l, k): (&Letter, &u32)| {
                        match l {
                            Letter::Root(p) => f64::from(*p).sqrt(),
                            Letter::Eighth => (2.0 + 2f64.sqrt()).sqrt(),
                            Letter::Fifth => (10.0 - 2.0 * 5f64.sqrt()).sqrt(),
                            Letter::Cosine(_) | Letter::Sine(_) => f64::NAN,
                        }
                        .powi(*k as i32)
                    };
                    c.to_f64().unwrap_or(f64::NAN) * monomial.iter().map(letter).product::<f64>()
                })
                .sum()
        };
        for m in -300..300 {
            let angle = std::f64::consts::PI * f64::from(m) / 120.0;
            let point = turns(i64::from(m), 120);
            assert!((value(&point.cos) - angle.cos()).abs() < 1e-12, "cos {m}");
            assert!((value(&point.sin) - angle.sin()).abs() < 1e-12, "sin {m}");
        }
    }

    #[test]
    fn sums_and_multiples_follow_the_addition_formulas() {
        let (x, y) = (Point::named("cos_x", "sin_x"), Point::named("cos_y", "sin_y"));
        let sum = both(&x.plus(&y).expect("short"));
        assert_eq!(sum.0, "cos_x*cos_y - sin_x*sin_y");
        assert_eq!(sum.1, "cos_x*sin_y + cos_y*sin_x");
        let triple = both(&x.times(3).expect("short"));
        assert_eq!(triple, ("cos_x^3 - 3*cos_x*sin_x^2".to_string(), "3*cos_x^2*sin_x - sin_x^3".to_string()));
        assert_eq!(both(&x.clone().opposite()).1, "-sin_x");
        assert!(x.times(25).is_none());
    }
}
