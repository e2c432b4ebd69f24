//! Equations between angles, as equations between cosines and sines.

use super::Writer;
use crate::claim::angle::{Angle, Bounds};
use crate::claim::circle::compared;
use crate::claim::matrix::{at, numeral};
use crate::claim::syntax::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

impl Writer<'_> {
    /// An equation between angles as two equations, of cosines and of sines.
    ///
    /// These two say that the sides differ by a multiple of 2π. They are equivalent to the equation in two cases. First, the bounds
    /// may exclude every multiple but 0. Second, an angle of the equation may have no bounds, occur in no other equation and
    /// have the coefficient 1 or −1: some value of it, plus a multiple of 2π, satisfies the equation.
    pub(super) fn relation(&mut self, a: &Expr, b: &Expr) -> Vec<Prop> {
        let span = Span { start: a.span.start, end: b.span.end };
        let Some(sum) = self.difference(a, b) else {
            self.give_up();
            return Vec::new();
        };
        // The coefficient of the named angle is 1 or -1: cosine and sine can be solved for.
        let single = |name: &String, k: &BigRational| {
            self.angles.get(name).is_some_and(|v| (k * BigRational::from_integer(v.over.into())).abs().is_one())
        };
        let solved = sum.of.iter().rev().find(|(name, k)| single(name, k));
        let free = sum.of.iter().rev().find(|(name, k)| {
            let others = self.equations.iter().filter(|e| e.of.contains_key(*name)).count();
            single(name, k) && self.bounds.get(*name).is_none_or(Bounds::are_none) && others == 1
        });
        if free.is_none() && !self.turns_are_known(&sum) {
            self.give_up();
            return Vec::new();
        }
        let Some((name, k)) = free.or(solved).map(|(name, k)| (name.clone(), k.clone())) else {
            let is = |value: Expr, k: u32| compared(value, Relation::Equal, numeral(span, k));
            let zero = self.point(&sum);
            return zero.map_or(Vec::new(), |p| vec![is(p.cosine(span), 1), is(p.sine(span), 0)]);
        };
        let mut rest = sum;
        rest.of.remove(&name);
        let sign = if k.is_positive() { -BigRational::one() } else { BigRational::one() };
        rest.turns *= &sign;
        rest.of.values_mut().for_each(|k| *k *= &sign);
        let Some((cos, sin)) = self.angles.get(&name).map(|v| (v.cos.clone(), v.sin.clone())) else {
            return Vec::new();
        };
        let Some(point) = self.point(&rest) else { return Vec::new() };
        let value = |text: String| at(span, ExprKind::Name(text));
        vec![
            compared(value(cos), Relation::Equal, point.cosine(span)),
            compared(value(sin), Relation::Equal, point.sine(span)),
        ]
    }

    /// Whether the bounds exclude every multiple of 2π but 0 as a value of the sum.
    fn turns_are_known(&self, sum: &Angle) -> bool {
        // An end of the sum is attained where every angle attains its own.
        let (mut low, mut high) = ((sum.turns.clone(), true), (sum.turns.clone(), true));
        for (name, k) in &sum.of {
            let Some((from, to)) = self.bounds.get(name).and_then(Bounds::ends) else { return false };
            let (from, to) = if k.is_negative() { (to, from) } else { (from, to) };
            low = (low.0 + k * &from.0, low.1 && from.1);
            high = (high.0 + k * &to.0, high.1 && to.1);
        }
        let two = BigRational::from_integer(BigInt::from(2));
        let above = if low.1 { low.0 > -&two } else { low.0 >= -&two };
        above && if high.1 { high.0 < two } else { high.0 <= two }
    }
}
