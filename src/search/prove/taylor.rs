//! Taylor's polynomials of exp, ln, sin, cos, arcsin, arctan and powers, with a remainder.

use super::facts::{minus, negated};
use super::letters::{product, total, whole_power};
use super::limits::over;
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, name, numeral, power, prop, sum};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Abs, Ceiling};
use malachite::base::num::basic::traits::{One, Zero};

/// A function with an expansion: ln and powers at 1, the others at 0.
#[derive(Clone, PartialEq)]
pub(super) enum Function {
    Exponential,
    Logarithm,
    Sine,
    Cosine,
    Arcsine,
    Arctangent,
    /// y^a.
    Root(Rational),
    /// t^y for a number t from −1 to 1, which has no expansion.
    Turning(Expr),
}

impl Function {
    /// Where it is expanded.
    pub(super) fn centre(&self) -> u32 {
        u32::from(matches!(self, Function::Logarithm | Function::Root(_)))
    }

    /// Its value.
    pub(super) fn at(&self, y: &Expr) -> Expr {
        match self {
            Function::Exponential => apply("exp", y.clone()),
            Function::Logarithm => apply("ln", y.clone()),
            Function::Sine => apply("sin", y.clone()),
            Function::Cosine => apply("cos", y.clone()),
            Function::Arcsine => apply("arcsin", y.clone()),
            Function::Arctangent => apply("arctan", y.clone()),
            Function::Root(a) => power(y, &literal(a)),
            Function::Turning(t) => power(t, y),
        }
    }

    /// Whether it turns without end: sin and cos, and powers of what may be negative.
    pub(super) fn turns(&self) -> bool {
        matches!(self, Function::Sine | Function::Cosine | Function::Turning(_))
    }

    /// Whether it falls as its argument rises.
    pub(super) fn falls(&self) -> bool {
        matches!(self, Function::Root(a) if *a < 0)
    }

    /// The coefficients of 1, s, s² and so on up to a degree, for the distance s from the centre.
    pub(super) fn coefficients(&self, degree: u32) -> Vec<Rational> {
        let part = |k: u32| Rational::from_unsigneds(1u32, k.max(1));
        let alternating = |k: u32| if (k / 2).is_multiple_of(2) { Rational::ONE } else { -Rational::ONE };
        // 1/k!, the binomial coefficient of k, and 1·3·…/(2·4·…) for the odd k.
        let (mut inverse, mut binomial, mut central) = (Rational::ONE, Rational::ONE, Rational::ONE);
        let mut out = Vec::new();
        for k in 0..=degree {
            let (odd, zero) = (!k.is_multiple_of(2), Rational::ZERO);
            out.push(match self {
                Function::Exponential => inverse.clone(),
                Function::Logarithm if k == 0 => zero,
                Function::Logarithm if odd => part(k),
                Function::Logarithm => -part(k),
                Function::Sine if odd => alternating(k) * &inverse,
                Function::Cosine if !odd => alternating(k) * &inverse,
                Function::Arcsine if odd => &central * part(k),
                Function::Arctangent if odd => alternating(k) * part(k),
                Function::Sine | Function::Cosine | Function::Arcsine | Function::Arctangent => zero,
                Function::Root(_) => binomial.clone(),
                Function::Turning(_) => zero,
            });
            inverse *= part(k + 1);
            if let Function::Root(a) = self {
                binomial *= (a - Rational::from(k)) * part(k + 1);
            }
            if odd {
                central *= Rational::from_unsigneds(k, k + 1);
            }
        }
        out
    }

    /// The C of the remainder C·|s|^(degree + 1) of Taylor's polynomial.
    ///
    /// It is large enough that the prover shows the bound for |s| <= 1/2; if it were too small, the proof would fail.
    pub(super) fn remainder(&self, degree: u32) -> u32 {
        match self {
            Function::Root(a) => {
                let size = a.clone().abs() * ((a.clone() - Rational::ONE).abs() + Rational::ONE);
                u32::try_from(&Ceiling::ceiling(size)).unwrap_or(u32::MAX).max(1)
            }
            _ => 2 * degree,
        }
    }

    /// The derivative of an order, for the functions that have one in few words.
    pub(super) fn derivative(&self, order: u32, y: &Expr) -> Option<Expr> {
        let quadratic = |sign| sum(vec![(Sign::Plus, numeral(1)), (sign, whole_power(y.clone(), 2))]);
        let turned = |quarters: u32| {
            let value = apply(if quarters.is_multiple_of(2) { "sin" } else { "cos" }, y.clone());
            if quarters % 4 < 2 { value } else { negated(value) }
        };
        match self {
            _ if order == 0 => Some(self.at(y)),
            Function::Sine => Some(turned(order)),
            Function::Cosine => Some(turned(order + 1)),
            Function::Arctangent if order == 1 => Some(over(numeral(1), quadratic(Sign::Plus))),
            Function::Arcsine if order == 1 => Some(over(numeral(1), apply("sqrt", quadratic(Sign::Minus)))),
            _ => None,
        }
    }

    /// The coefficients of Taylor's polynomial of a degree with the remainder ±C·|s|^(degree + 1), for s on one side of 0, or on both.
    pub(super) fn bound_coefficients(&self, degree: u32, upper: bool, side: Side) -> Vec<Rational> {
        let mut coefficients = self.coefficients(degree);
        let turned = degree.is_multiple_of(2) && side == Side::Below;
        let rest = Rational::from(self.remainder(degree));
        coefficients.push(if upper != turned { rest } else { -rest });
        coefficients
    }

    /// Taylor's polynomial of a degree with its remainder.
    pub(super) fn bound(&self, s: &Expr, degree: u32, upper: bool, side: Side) -> Expr {
        polynomial(&self.bound_coefficients(degree, upper, side), s)
    }
}

/// c₀ + c₁·s + c₂·s² + …
pub(super) fn polynomial(coefficients: &[Rational], s: &Expr) -> Expr {
    let terms = coefficients.iter().zip(0..).filter(|(c, _)| **c != 0);
    let terms: Vec<(Sign, Expr)> =
        terms.map(|(c, k)| (Sign::Plus, product(vec![literal(c), whole_power(s.clone(), k)]))).collect();
    if terms.is_empty() { numeral(0) } else { total(terms) }
}

/// That a function is at most, or at least, its polynomial of Taylor with a remainder, up to the distance 1/2 from the centre.
#[derive(Clone, PartialEq)]
pub(super) struct TaylorBound {
    pub function: Function,
    pub degree: u32,
    pub upper: bool,
    /// On which sides of the centre.
    pub side: Side,
}

impl TaylorBound {
    /// The statement for all y.
    pub(super) fn statement(&self, y: &str) -> Prop {
        let TaylorBound { function, degree, upper, side } = self;
        let s = match function.centre() {
            0 => name(y),
            _ => minus(&name(y), &numeral(1)),
        };
        let body = at_most(!upper, &function.bound(&s, *degree, *upper, *side), &function.at(&name(y)));
        prop(PropKind::ForAll(vec![side.near(y, function.centre())], Box::new(body)))
    }
}

/// On which sides of a number another lies, or may lie.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Side {
    Both,
    Above,
    Below,
}

impl Side {
    /// The side of 0 on which a number with these signs lies, or 0 itself.
    pub(super) fn of(signs: Signs) -> Side {
        match signs {
            s if s.within(Signs::NOT_NEGATIVE) => Side::Above,
            s if s.within(Signs::of(Relation::LessEqual)) => Side::Below,
            _ => Side::Both,
        }
    }

    /// y on these sides of a centre, up to the distance 1/2.
    pub(super) fn near(self, y: &str, centre: u32) -> Binding {
        let end = |k: i64| literal(&(Rational::from_signeds(k, 2) + Rational::from(centre)));
        let (from, to) = match self {
            Side::Both => (end(-1), end(1)),
            Side::Above => (end(0), end(1)),
            Side::Below => (end(-1), end(0)),
        };
        let domain = Constraint::Interval { from, from_closed: true, to, to_closed: true };
        Binding::of(Name::new(y), false, vec![domain])
    }

    pub(super) fn opposite(self) -> Side {
        match self {
            Side::Both => Side::Both,
            Side::Above => Side::Below,
            Side::Below => Side::Above,
        }
    }
}

/// A bound is at most what it bounds from below, and the other way round.
pub(super) fn at_most(is_lower: bool, bound: &Expr, e: &Expr) -> Prop {
    let (a, b) = if is_lower { (bound, e) } else { (e, bound) };
    compare(a.clone(), Relation::LessEqual, b.clone())
}
