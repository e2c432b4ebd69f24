//! Angles: the arguments of sin, cos and tan, and the bounds of an angle.
//!
//! Contract: an [`Angle`] is a sum of variables and of π with rational coefficients. [`Bounds::conditions`] says the same
//! of cosine and sine as the bounds say of the angle: a point of the circle fulfils them if and only if it belongs to an
//! angle within the bounds.

use super::circle::{Point, compared};
use super::definedness::number;
use super::matrix::numeral;
use super::syntax::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::BTreeMap;

/// `turns`·π + Σ kᵢ·xᵢ.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Angle {
    /// How many times π.
    pub turns: BigRational,
    /// The variables with their coefficients, none of which is 0.
    pub of: BTreeMap<String, BigRational>,
}

/// A number and an angle.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Linear {
    number: BigRational,
    angle: Angle,
}

impl Linear {
    fn number(q: BigRational) -> Linear {
        Linear { number: q, ..Linear::default() }
    }

    fn plus(mut self, other: &Linear, times: &BigRational) -> Linear {
        self.number += &other.number * times;
        self.angle.turns += &other.angle.turns * times;
        for (name, k) in &other.angle.of {
            let sum = self.angle.of.remove(name).unwrap_or_else(BigRational::zero) + k * times;
            if !sum.is_zero() {
                self.angle.of.insert(name.clone(), sum);
            }
        }
        self
    }

    fn times(&self, k: &BigRational) -> Linear {
        Linear::default().plus(self, k)
    }

    fn as_number(&self) -> Option<&BigRational> {
        (self.angle == Angle::default()).then_some(&self.number)
    }

    /// The angle, if no other number is added to it.
    pub(crate) fn as_angle(&self) -> Option<&Angle> {
        self.number.is_zero().then_some(&self.angle)
    }
}

/// The sum of numbers, variables and π with rational coefficients that an expression is; `None` if it is no such sum.
/// `definitions` has the values of names without parameters; `is_pi` says whether `pi` is the number π.
pub(super) fn linear(e: &Expr, definitions: &BTreeMap<String, Linear>, is_pi: bool) -> Option<Linear> {
    if let Some((top, bottom)) = number(e) {
        return Some(Linear::number(BigRational::new(BigInt::from(top), BigInt::from(bottom))));
    }
    let read = |e: &Expr| linear(e, definitions, is_pi);
    let one = BigRational::one();
    match &e.kind {
        ExprKind::Name(name) if name == PI && is_pi => {
            Some(Linear { angle: Angle { turns: one, of: BTreeMap::new() }, ..Linear::default() })
        }
        ExprKind::Name(name) => Some(definitions.get(name).cloned().unwrap_or_else(|| {
            let of = BTreeMap::from([(name.clone(), one)]);
            Linear { angle: Angle { turns: BigRational::zero(), of }, ..Linear::default() }
        })),
        ExprKind::Negate(a) => Some(read(a)?.times(&-one)),
        ExprKind::Sum(list) => list.iter().try_fold(Linear::default(), |sum, (sign, part)| {
            Some(sum.plus(&read(part)?, &if *sign == Sign::Plus { one.clone() } else { -one.clone() }))
        }),
        ExprKind::Product(list) => list.iter().try_fold(Linear::number(one), |out, (factor, part)| {
            let part = read(part)?;
            match (factor, out.as_number(), part.as_number()) {
                (Factor::Times, _, Some(k)) => Some(out.times(k)),
                (Factor::Times, Some(k), None) => Some(part.times(k)),
                (Factor::Over, _, Some(k)) if !k.is_zero() => Some(out.times(&k.recip())),
                _ => None,
            }
        }),
        _ => None,
    }
}

/// An end of a range of angles, in units of π, and whether it belongs to the range.
pub(super) type End = (BigRational, bool);

/// The bounds of an angle.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Bounds {
    low: Option<End>,
    high: Option<End>,
}

impl Bounds {
    /// The angle stands in this relation to an end: `<`, `<=`, `>`, `>=`. `false` for the other relations.
    pub(super) fn narrow(&mut self, relation: Relation, turns: BigRational) -> bool {
        let closed = matches!(relation, Relation::LessEqual | Relation::GreaterEqual);
        match relation {
            Relation::Less | Relation::LessEqual => {
                let inside = |(q, c): &End| *q < turns || *q == turns && !c;
                if !self.high.as_ref().is_some_and(inside) {
                    self.high = Some((turns, closed));
                }
            }
            Relation::Greater | Relation::GreaterEqual => {
                let inside = |(q, c): &End| *q > turns || *q == turns && !c;
                if !self.low.as_ref().is_some_and(inside) {
                    self.low = Some((turns, closed));
                }
            }
            Relation::Equal | Relation::NotEqual => return false,
        }
        true
    }

    /// Whether there are neither.
    pub(crate) fn are_none(&self) -> bool {
        self.low.is_none() && self.high.is_none()
    }

    /// Both ends.
    pub(super) fn ends(&self) -> Option<(&End, &End)> {
        Some((self.low.as_ref()?, self.high.as_ref()?))
    }

    /// Whether an angle lies within.
    pub(super) fn hold(&self, turns: &BigRational) -> bool {
        let above = |(q, closed): &End| turns > q || turns == q && *closed;
        let below = |(q, closed): &End| turns < q || turns == q && *closed;
        self.low.as_ref().is_none_or(above) && self.high.as_ref().is_none_or(below)
    }

    /// Whether every angle within has a point of its own.
    pub(crate) fn are_less_than_a_turn(&self) -> bool {
        let two = BigRational::from_integer(BigInt::from(2));
        self.ends().is_some_and(|(low, high)| {
            let length = &high.0 - &low.0;
            length < two || length == two && !(low.1 && high.1)
        })
    }

    /// What the bounds say of the point of a part of the angle, of which the bounded angle is so many times. `None` where an end
    /// is no multiple of π/120 or the bounds hold no interval.
    ///
    /// Let the angle lie between α and β, of length L = β − α. sin(b − α) ≥ 0 holds on the half circle from α on, and
    /// sin(β − b) ≥ 0 on the half circle up to β.
    /// - L < π: the arc is where the two half circles meet. At α the second sine is positive and at α + π it is negative,
    ///   so that `>` in place of `≥` takes out α alone; and so for β.
    /// - L = π: the half circles are the same; the points α and β are those at which cos(b − α) is 1 and −1.
    /// - π < L < 2π: what is left out is an arc shorter than π, from β to α + 2π: sin(b − β) > 0 and sin(α − b) > 0, with `≥`
    ///   where the end is left out as well. The conditions say the opposite.
    /// - L = 2π: every point; without that of α if both ends are left out. L > 2π, or an end missing: every point.
    pub(super) fn conditions(&self, part: &Point, times: u32, span: Span) -> Option<Vec<Prop>> {
        let Some((low, high)) = self.ends() else { return Some(Vec::new()) };
        let share = BigRational::new(BigInt::one(), BigInt::from(times));
        let (alpha, beta) = (&low.0 * &share, &high.0 * &share);
        let length = &beta - &alpha;
        let one = BigRational::one();
        let two = &one + &one;
        if !length.is_positive() {
            return None;
        }
        if length > two || length == two && (low.1 || high.1) {
            return Some(Vec::new());
        }
        let from_low = part.plus(&Point::of_turns(&-alpha)?)?;
        let to_high = part.clone().opposite().plus(&Point::of_turns(&beta)?)?;
        let at_least = |closed: bool| if closed { Relation::GreaterEqual } else { Relation::Greater };
        let is_not = |value: Expr| compared(from_low.cosine(span), Relation::NotEqual, value);
        let minus_one = || Expr { kind: ExprKind::Negate(Box::new(numeral(span, 1))), span };
        if length == two {
            return Some(vec![is_not(numeral(span, 1))]);
        }
        if length == one {
            let mut out = vec![from_low.sine_is(at_least(low.1 || high.1), span)];
            match (low.1, high.1) {
                (false, true) => out.push(is_not(numeral(span, 1))),
                (true, false) => out.push(is_not(minus_one())),
                _ => {}
            }
            return Some(out);
        }
        let both = vec![from_low.sine_is(at_least(low.1), span), to_high.sine_is(at_least(high.1), span)];
        Some(match length < one {
            true => both,
            false => vec![Prop { kind: PropKind::Or(both), span }],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claim::print::prop;

    fn said(low: (i64, i64), low_closed: bool, high: (i64, i64), high_closed: bool, times: u32) -> String {
        let turns = |(top, bottom): (i64, i64)| BigRational::new(BigInt::from(top), BigInt::from(bottom));
        let mut bounds = Bounds::default();
        bounds.narrow(if low_closed { Relation::GreaterEqual } else { Relation::Greater }, turns(low));
        bounds.narrow(if high_closed { Relation::LessEqual } else { Relation::Less }, turns(high));
        let conditions =
            bounds.conditions(&Point::named("cos_a", "sin_a"), times, Span::default()).expect("an interval");
        conditions.iter().map(prop).collect::<Vec<_>>().join("; ")
    }

    #[test]
    fn bounds_are_conditions_on_cosine_and_sine() {
        assert_eq!(said((0, 1), true, (1, 2), true, 1), "sin_a >= 0; cos_a >= 0");
        assert_eq!(said((-1, 2), false, (1, 2), false, 1), "cos_a > 0");
        assert_eq!(said((0, 1), true, (1, 1), false, 1), "sin_a >= 0; cos_a != -1");
        assert_eq!(said((0, 1), false, (3, 2), true, 1), "sin_a > 0 or cos_a <= 0");
        assert_eq!(said((0, 1), false, (2, 1), false, 1), "cos_a != 1");
        assert_eq!(said((0, 1), true, (2, 1), false, 1), "");
        assert_eq!(said((0, 1), true, (1, 1), true, 2), "sin_a >= 0; cos_a >= 0");
        assert_eq!(said((1, 2), true, (1, 1), true, 1), "cos_a <= 0; sin_a >= 0");
    }

    /// Every twelfth of π against every range of twelfths, open and closed: the conditions hold at its point if and only if
    /// the angle, or one that differs by whole turns, lies in the range.
    #[test]
    fn a_point_fulfils_the_conditions_if_and_only_if_it_lies_within() {
        let value_at = |e: &Expr, at: i64| value(e, std::f64::consts::PI * at as f64 / 12.0);
        for low in -13..13 {
            for high in low + 1..low + 26 {
                for closed in 0..4 {
                    let (low_closed, high_closed) = (closed & 1 == 1, closed & 2 == 2);
                    let turns = |k: i64| BigRational::new(BigInt::from(k), BigInt::from(12));
                    let mut bounds = Bounds::default();
                    bounds.narrow(if low_closed { Relation::GreaterEqual } else { Relation::Greater }, turns(low));
                    bounds.narrow(if high_closed { Relation::LessEqual } else { Relation::Less }, turns(high));
                    let conditions =
                        bounds.conditions(&Point::named("cos_a", "sin_a"), 1, Span::default()).expect("an interval");
                    for at in 0..24 {
                        let within = (-3..=3).any(|turn| bounds.hold(&turns(at + 24 * turn)));
                        let held = conditions.iter().all(|p| holds(p, &|e| value_at(e, at)));
                        assert_eq!(within, held, "{low}..{high} {closed} at {at}");
                    }
                }
            }
        }
    }

    fn holds(p: &Prop, value: &dyn Fn(&Expr) -> f64) -> bool {
        match &p.kind {
            PropKind::Or(list) => list.iter().any(|p| holds(p, value)),
            PropKind::Compare(sides, relations) => {
                let difference = value(&sides[0]) - value(&sides[1]);
                let difference = if difference.abs() < 1e-9 { 0.0 } else { difference };
                match relations[0] {
                    Relation::Greater => difference > 0.0,
                    Relation::GreaterEqual => difference >= 0.0,
                    Relation::Less => difference < 0.0,
                    Relation::LessEqual => difference <= 0.0,
                    Relation::Equal => difference == 0.0,
                    Relation::NotEqual => difference != 0.0,
                }
            }
            _ => panic!("a comparison"),
        }
    }

    fn value(e: &Expr, angle: f64) -> f64 {
        let of = |e: &Expr| value(e, angle);
        match &e.kind {
            ExprKind::Number(text) => text.parse().expect("a numeral"),
            ExprKind::Name(name) => {
                if name == "cos_a" {
                    angle.cos()
                } else {
                    angle.sin()
                }
            }
            ExprKind::Apply(_, list) => of(&list[0]).sqrt(),
            ExprKind::Negate(a) => -of(a),
            ExprKind::Sum(list) => list.iter().map(|(s, a)| if *s == Sign::Plus { of(a) } else { -of(a) }).sum(),
            ExprKind::Product(list) => {
                list.iter().fold(1.0, |out, (f, a)| if *f == Factor::Times { out * of(a) } else { out / of(a) })
            }
            _ => panic!("arithmetic"),
        }
    }
}
