//! Halves of angles that add up to half a turn, as those of a triangle: α/2 + β/2 + γ/2 = π/2.
//!
//! Method: where a claim speaks of halves, the sum of the whole angles says of the cosine X and the sine Y of the sum of the halves that
//! X² − Y² = −1. With X² + Y² = 1 that is X = 0. All cosines and sines of the halves are positive, so Y is: for the last half γ and the
//! cosine P and sine Q of the sum of the others, cos γ·Y = Q + X·sin γ. So Y = 1, and then sin γ = P and cos γ = Q, which are put in.
//! The goal is left with an angle less.

use super::circle::of_a_sum;
use super::facts::minus;
use super::letters::{product, whole_power};
use super::limits::over;
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};
use crate::refute::literal::literal;
use malachite::Rational;

/// The most points of the circle that are tried.
const POINTS: usize = 5;

/// A point of the circle: its cosine and sine, and the fact that says that it lies there.
#[derive(Clone)]
struct Point {
    cosine: Polynomial,
    sine: Polynomial,
    circle: Label,
}

impl Prover {
    /// Shows a goal about halves of angles that add up to half a turn with one of the halves written by the others.
    pub(super) fn by_halved_sums(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("halves of angles that add up to half a turn");
        let points = self.points_of_first_quarters();
        let mut choices: Vec<Vec<Point>> = Vec::new();
        for (i, first) in points.iter().enumerate() {
            for (j, second) in points.iter().enumerate().skip(i + 1) {
                choices
                    .extend(points.iter().skip(j + 1).map(|third| vec![first.clone(), second.clone(), third.clone()]));
                choices.push(vec![first.clone(), second.clone()]);
            }
        }
        if choices.is_empty() {
            return Err(no());
        }
        let mut equations = Vec::new();
        for (label, fact) in self.facts() {
            if let Some((a, Relation::Equal, b)) = fact.single()
                && let Some(p) = self.letters.polynomial(&minus(a, b)).filter(|p| p.degree() >= 4)
            {
                equations.push((label, p));
            }
        }
        for choice in choices {
            let [x, y] = turned(&choice).ok_or_else(no)?;
            let square = |p: &Polynomial| p.try_mul(p).ok();
            let doubled = square(&x).ok_or_else(no)?.sub(&square(&y).ok_or_else(no)?).add(&Polynomial::one());
            let said = equations.iter().find_map(|(label, p)| match () {
                () if *p == doubled => Some((label.clone(), 1)),
                () if p.neg() == doubled => Some((label.clone(), -1)),
                () => None,
            });
            if let Some((label, sign)) = said {
                self.write_last_half(&choice, [&x, &y], &label, sign)?;
                return self.show(goal);
            }
        }
        Err(no())
    }

    /// The points of the circle whose cosine and sine are variables and positive.
    fn points_of_first_quarters(&mut self) -> Vec<Point> {
        let mut out = Vec::new();
        for (circle, fact) in self.facts() {
            let Some((left, Relation::Equal, right)) = fact.single() else { continue };
            let (ExprKind::Sum(list), Some(1)) = (&left.kind, super::letters::natural(right)) else { continue };
            let [(Sign::Plus, first), (Sign::Plus, second)] = list.as_slice() else { continue };
            let root = |e: &Expr| match &e.kind {
                ExprKind::Power(base, two) if super::letters::natural(two) == Some(2) => match &base.kind {
                    ExprKind::Name(_) => Some((**base).clone()),
                    _ => None,
                },
                _ => None,
            };
            let (Some(cosine), Some(sine)) = (root(first), root(second)) else { continue };
            if out.len() < POINTS && [&cosine, &sine].iter().all(|e| self.signs_of(e).within(Signs::POSITIVE)) {
                let [cosine, sine] = [cosine, sine].map(|e| Polynomial::variable(self.letters.of(&e)));
                out.push(Point { cosine, sine, circle });
            }
        }
        out
    }

    /// sin γ = P and cos γ = Q for the last of the points, put in.
    fn write_last_half(
        &mut self,
        points: &[Point],
        [x, y]: [&Polynomial; 2],
        doubled: &Label,
        sign: i64,
    ) -> Result<(), Fail> {
        let no = || Fail::No("halves of angles that add up to half a turn");
        let (last, others) = points.split_last().ok_or_else(no)?;
        let [p, q] = turned(others).ok_or_else(no)?;
        let w = |c: &Prover, p: &Polynomial| c.letters.written(p);
        let (x_, y_, p_, q_) = (w(self, x), w(self, y), w(self, &p), w(self, &q));
        let (cosine, sine) = (w(self, &last.cosine), w(self, &last.sine));
        let is_zero = compare(x_.clone(), Relation::Equal, numeral(0));
        if self.known(&is_zero).is_some() {
            return Err(no());
        }
        let number = |k: i64| literal(&Rational::from(k));
        let term = |fact: &Label, factor: Expr| Term { facts: vec![fact.clone()], factor };
        // ∏ rᵢ − 1 = Σ (rᵢ − 1)·∏ of those behind, times a factor.
        let circles = |c: &Prover, points: &[Point], factor: &Expr| -> Vec<Term> {
            let radius = |p: &Point| {
                super::letters::total(vec![
                    (Sign::Plus, whole_power(w(c, &p.cosine), 2)),
                    (Sign::Plus, whole_power(w(c, &p.sine), 2)),
                ])
            };
            let behind = |i: usize| points.iter().skip(i + 1).map(radius);
            let one = |(i, p): (usize, &Point)| {
                term(&p.circle, product(std::iter::once(factor.clone()).chain(behind(i)).collect()))
            };
            points.iter().enumerate().map(one).collect()
        };
        let half = literal(&Rational::from_unsigneds(1u32, 2));
        let mut terms = circles(self, points, &half);
        terms.push(term(doubled, product(vec![number(sign), half])));
        let square = compare(whole_power(x_.clone(), 2), Relation::Equal, numeral(0));
        let square = self.identity(square, terms)?;
        let zero = self.combination(is_zero.clone(), Vec::new()).or_else(|_| {
            self.against_opposite(&is_zero, |c, _| {
                let denied = compare(whole_power(x_.clone(), 2), Relation::NotEqual, numeral(0));
                let denied = c.combination(denied, Vec::new())?;
                c.logic(&[&denied, &square], &is_zero)
            })
        })?;
        let positive = compare(y_.clone(), Relation::Greater, numeral(0));
        let along = vec![
            term(&zero, over(sine.clone(), cosine.clone())),
            term(&last.circle, over(q_.clone(), cosine.clone())),
            Term { facts: Vec::new(), factor: over(q_.clone(), cosine.clone()) },
        ];
        let positive = self.combination(positive, along)?;
        let mut terms = circles(self, points, &numeral(1));
        terms.push(term(&zero, product(vec![number(-1), x_.clone()])));
        let unit = self.identity(compare(whole_power(y_.clone(), 2), Relation::Equal, numeral(1)), terms)?;
        let above = w(self, &y.add(&Polynomial::one()));
        let beyond = vec![term(&positive, numeral(1)), Term { facts: Vec::new(), factor: numeral(1) }];
        self.combination(compare(above.clone(), Relation::Greater, numeral(0)), beyond)?;
        let one = compare(y_, Relation::Equal, numeral(1));
        let one = self.combination(one, vec![term(&unit, over(numeral(1), above))])?;
        let minus_of = |e: &Expr| product(vec![number(-1), e.clone()]);
        for (letter, value, along, across) in [(&sine, &p_, &p_, minus_of(&q_)), (&cosine, &q_, &q_, p_.clone())] {
            let mut terms = circles(self, others, &minus_of(letter));
            terms.extend([term(&one, along.clone()), term(&zero, across)]);
            let label = self.identity(compare(letter.clone(), Relation::Equal, value.clone()), terms)?;
            self.put_in(&label);
        }
        Ok(())
    }
}

/// The cosine and the sine of a sum of angles.
fn turned(points: &[Point]) -> Option<[Polynomial; 2]> {
    let none = [Polynomial::one(), Polynomial::zero()];
    points.iter().try_fold(none, |sum, point| of_a_sum(&sum, &[point.cosine.clone(), point.sine.clone()]))
}
