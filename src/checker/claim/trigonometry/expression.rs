//! Expressions with sin, cos and tan, written in the cosines and sines of the named angles.

use super::{NODES_LIMIT, Writer};
use crate::claim::angle::Angle;
use crate::claim::circle::Point;
use crate::claim::matrix::at;
use crate::claim::syntax::*;
use crate::claim::walk;
use num_rational::BigRational;
use num_traits::ToPrimitive;

impl Writer<'_> {
    pub(super) fn expr(&mut self, e: &mut Expr) {
        let span = e.span;
        if let Some((word, argument)) = self.function(e) {
            let Some(point) = self.angle(argument).and_then(|angle| self.point(&angle)) else { return };
            *e = match word {
                "cos" => point.cosine(span),
                "sin" => point.sine(span),
                _ => at(
                    span,
                    ExprKind::Product(vec![(Factor::Times, point.sine(span)), (Factor::Over, point.cosine(span))]),
                ),
            };
            return;
        }
        match &mut e.kind {
            ExprKind::Name(name) if name == PI && self.is_pi || self.is_angle(name) => self.give_up(),
            _ => walk::parts_mut(e, &mut |part| self.expr(part)),
        }
    }

    /// The cosine and sine of an angle in those of the named angles.
    pub(super) fn point(&mut self, angle: &Angle) -> Option<Point> {
        if self.nodes > NODES_LIMIT {
            return None;
        }
        let Some(mut out) = Point::of_turns(&angle.turns) else {
            self.give_up();
            return None;
        };
        for (name, k) in &angle.of {
            let Some(variable) = self.angles.get(name) else {
                self.give_up();
                return None;
            };
            let times = (k * BigRational::from_integer(variable.over.into())).to_integer().to_i64();
            let part = Point::named(&variable.cos, &variable.sin);
            let Some(part) = times.and_then(|times| part.times(times)) else {
                self.give_up();
                return None;
            };
            let Some(sum) = out.plus(&part) else {
                self.give_up();
                return None;
            };
            out = sum;
        }
        self.nodes += 10 * out.terms();
        if self.nodes > NODES_LIMIT {
            self.give_up();
            return None;
        }
        Some(out)
    }
}
