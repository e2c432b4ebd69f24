//! arcsin, arccos and arctan: how they are read, and rule `arc`.
//!
//! Contract: as in `term`. arccos x is π/2 − arcsin x. arcsin and arctan are odd, so an argument has a positive coefficient, and
//! those of the constants `of_a_constant` are multiples of π. Everything else is an atom. Its cosine and sine are read off the
//! right triangle (`of_an_arc`).

use super::fraction::Fraction;
use super::known::Known;
use super::order::Signs;
use super::statement::{apply, compare, product, sum};
use super::term::Atom;
use super::tree::single;
use super::{Checker, Reason, Refusal, rejected};
use crate::claim::syntax::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

/// A fraction, numerator first, and the k of an angle π/k.
pub type KnownAngle = (i64, i64, i64);

/// The angles whose squared sine is known, or for arctan whose squared tangent is.
pub fn known_angles(f: &str) -> &'static [KnownAngle] {
    if f == "arctan" { &[(1, 3, 6), (1, 1, 4), (3, 1, 3)] } else { &[(1, 4, 6), (1, 2, 4), (3, 4, 3), (1, 1, 2)] }
}

fn part(k: i64) -> BigRational {
    BigRational::new(BigInt::from(1), BigInt::from(k))
}

/// What holds where `f(x) = y` for f = arcsin or arctan: `sin(y) = x`, or `sin(y) = x*cos(y)`.
pub fn turned_back(f: &str, x: &Expr, y: &Expr) -> Prop {
    let right = if f == "arctan" { product(vec![x.clone(), apply("cos", y.clone())]) } else { x.clone() };
    compare(apply("sin", y.clone()), Relation::Equal, right)
}

impl Checker {
    /// π/2, whatever a claim declares.
    fn quarter_turn(&mut self) -> Result<Fraction, Refusal> {
        Fraction::atom(self.intern(Atom::Pi)).times(&Fraction::number(part(2)), &self.work)
    }

    /// arcsin, arccos or arctan of x.
    pub(super) fn arc(&mut self, function: &str, x: &Fraction) -> Result<Fraction, Refusal> {
        if function == "arccos" {
            return self.quarter_turn()?.minus(&self.arc("arcsin", x)?, &self.work);
        }
        if x.is_zero() {
            return Ok(Fraction::integer(0));
        }
        if x.coefficient.is_negative() {
            return Ok(self.arc(function, &x.negated())?.negated());
        }
        if let Some(k) = self.of_a_constant(x, known_angles(function)) {
            return Fraction::atom(self.intern(Atom::Pi)).times(&Fraction::number(part(k)), &self.work);
        }
        let atom = if function == "arcsin" { Atom::Arcsine(x.clone()) } else { Atom::Arctangent(x.clone()) };
        Ok(self.atom_fraction(atom))
    }

    /// The k of an angle π/k, by the square of its sine or tangent. The positive constant is a rational number times powers of positive
    /// numbers: of `sqrt(x^2)/x`, whose square is a number too, the sign is not known.
    fn of_a_constant(&self, x: &Fraction, angles: &[KnownAngle]) -> Option<i64> {
        let mut square = &x.coefficient * &x.coefficient;
        for (poly, k) in &x.factors {
            let Some(Atom::Power(base, e)) = poly.single_atom().and_then(|atom| self.atoms.get(atom)) else {
                return None;
            };
            let (base, e) = (base.as_number()?, e.as_number()?);
            let twice = e * BigRational::from_integer(BigInt::from(*k) * BigInt::from(2));
            // Longer ones are none of these angles.
            let power = twice.is_integer().then(|| twice.to_i32()).flatten().filter(|k| k.unsigned_abs() <= 8)?;
            if !base.is_positive() || base.numer().bits().max(base.denom().bits()) > 64 {
                return None;
            }
            square *= num_traits::Pow::pow(base, power);
        }
        angles.iter().find(|(top, bottom, _)| square == BigRational::new((*top).into(), (*bottom).into())).map(|a| a.2)
    }

    /// The cosine and sine of a fraction that is an arc: of arcsin x, √(1 − x²) and x; of arctan x, 1/√(1 + x²) and x/√(1 + x²).
    ///
    /// Sound: an arc lies between −π/2 and π/2, where no cosine is negative.
    pub(super) fn of_an_arc(&mut self, arc: &Fraction) -> Result<Option<(Fraction, Fraction)>, Refusal> {
        let alone =
            arc.factors.iter().next().filter(|(_, k)| arc.factors.len() == 1 && **k == 1 && arc.coefficient.is_one());
        let Some(atom) = alone.and_then(|(poly, _)| poly.single_atom()) else { return Ok(None) };
        Ok(match self.atoms.get(atom).cloned() {
            Some(Atom::Arcsine(x)) => Some((self.root_of_one_and_square(&x, -1)?, x)),
            Some(Atom::Arctangent(x)) => {
                let cosine = self.root_of_one_and_square(&x, 1)?.power(-1)?;
                let sine = x.times(&cosine, &self.work)?;
                Some((cosine, sine))
            }
            _ => None,
        })
    }

    /// 1 + s·x².
    fn one_and_square(&self, x: &Fraction, s: i64) -> Result<Fraction, Refusal> {
        let square = x.times(x, &self.work)?.times(&Fraction::integer(s), &self.work)?;
        Fraction::sum(&[Fraction::integer(1), square], &self.work)
    }

    /// √(1 + s·x²).
    fn root_of_one_and_square(&mut self, x: &Fraction, s: i64) -> Result<Fraction, Refusal> {
        let under = self.one_and_square(x, s)?;
        self.power(&under, &Fraction::number(part(2)))
    }

    /// The derivative of an arc by its argument: of arcsin x, 1/√(1 − x²); of arctan x, 1/(1 + x²).
    pub(super) fn arc_derivative(&mut self, x: &Fraction, is_sine: bool) -> Result<Fraction, Refusal> {
        let under = self.one_and_square(x, if is_sine { -1 } else { 1 })?;
        if is_sine { self.power(&under, &Fraction::number(-part(2))) } else { under.power(-1) }
    }

    /// Rule `arc`:
    /// - `f(a) relation f(b)` for f = arcsin, arccos or arctan, if `a relation b`, or for arccos `b relation a`;
    /// - `arcsin(x) = y` if sin y = x and cos y ≥ 0; `arctan(x) = y` if sin y = x·cos y and cos y > 0; in both cases
    ///   −3π/2 < y < 3π/2.
    ///
    /// Sound: arcsin and arctan rise strictly and arccos falls strictly where they have values. Less than three right angles from 0
    /// the cosine is not negative only from −π/2 to π/2, and positive only between them. There y is the arcsin of its
    /// sine, and the arctan of its tangent.
    pub(super) fn arc_rule(&mut self, goal: &Prop, known: &mut Known) -> Result<(), Refusal> {
        self.prop_defined(goal, known)?;
        let (left, relation, right) = single(goal)?;
        let Some((f, x)) = as_arc(left) else { return rejected(Reason::NotAnArc) };
        if let Some((g, b)) = as_arc(right)
            && f == g
        {
            let (first, second) = if f == "arccos" { (b, x) } else { (x, b) };
            let difference = sum(vec![(Sign::Plus, first.clone()), (Sign::Minus, second.clone())]);
            if self.signs_of_expr(&difference, known)?.within(Signs::of(relation)) {
                return Ok(());
            }
            if relation != Relation::Equal || f == "arccos" {
                return rejected(Reason::Needs(compare(first.clone(), relation, second.clone())));
            }
        }
        if relation != Relation::Equal || f == "arccos" {
            return rejected(Reason::NotAnArc);
        }
        let equation = turned_back(f, x, right);
        let (sine, _, other) = single(&equation)?;
        let difference = sum(vec![(Sign::Plus, sine.clone()), (Sign::Minus, other.clone())]);
        if !self.signs_of_expr(&difference, known)?.within(Signs::ZERO) {
            return rejected(Reason::Needs(equation));
        }
        let cosine = if f == "arctan" { Signs::POSITIVE } else { Signs::NOT_NEGATIVE };
        self.need(&apply("cos", right.clone()), cosine, known)?;
        let y = self.fraction(right)?;
        let three = self.quarter_turn()?.times(&Fraction::integer(3), &self.work)?;
        for room in [three.minus(&y, &self.work)?, Fraction::sum(&[three, y], &self.work)?] {
            if !self.signs_of(&room, known)?.within(Signs::POSITIVE) {
                return rejected(Reason::BeyondThreeQuarters(right.clone()));
            }
        }
        Ok(())
    }
}

/// The function and the argument of an arc.
pub fn as_arc(e: &Expr) -> Option<(&str, &Expr)> {
    match &e.kind {
        ExprKind::Apply(f, list) => match (f.text.as_str(), list.as_slice()) {
            (word @ ("arcsin" | "arccos" | "arctan"), [x]) => Some((word, x)),
            _ => None,
        },
        _ => None,
    }
}
