//! Expressions with sin, cos and tan, written in the cosines and sines of the named angles.

use super::{NODES_LIMIT, Writer};
use crate::claim::angle::Angle;
use crate::claim::circle::{MULTIPLE_LIMIT, Point, TERMS_LIMIT};
use crate::claim::matrix::at;
use crate::claim::syntax::*;
use crate::claim::walk;
use num_rational::BigRational;
use num_traits::ToPrimitive;

impl Writer<'_> {
    pub(super) fn expr(&mut self, e: &mut Expr) {
        let span = e.span;
        if let Some((word, argument)) = self.function(e) {
            let Some(point) = self.angle(argument).and_then(|angle| self.point(&angle, span)) else { return };
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
            ExprKind::Name(name) if name == PI && self.is_pi => {
                let help = "use it inside sin, cos or tan and in bounds of angles; to use it as a number, declare it: \
                            `given pi in (3.14159, 3.1416)`";
                self.fault("pi cannot be used as a number here".to_string(), help, span);
            }
            ExprKind::Name(name) if self.is_angle(name) => {
                let message = format!("{name} is an angle; use it only inside sin, cos or tan");
                let help = "bound it where it is declared, such as `theta in (0, pi/2)`, and use another variable for the number";
                self.fault(message, help, span);
            }
            ExprKind::Derivative(body, by) if by.iter().any(|name| self.angles.contains_key(&name.text)) => {
                self.expr(body);
                if let Some(out) = self.derivatives(body, by, span) {
                    *e = out;
                }
            }
            _ => walk::parts_mut(e, &mut |part| self.expr(part)),
        }
    }

    /// The cosine and sine of an angle in those of the named angles.
    pub(super) fn point(&mut self, angle: &Angle, span: Span) -> Option<Point> {
        if self.nodes > NODES_LIMIT {
            return None;
        }
        let Some(mut out) = Point::of_turns(&angle.turns) else {
            let help = "use a multiple of pi/120, or name the angle: `given phi real`";
            self.fault("the cosine and sine of this multiple of pi are not known".to_string(), help, span);
            return None;
        };
        for (name, k) in &angle.of {
            let Some(variable) = self.angles.get(name) else {
                self.not_about_angles(span);
                return None;
            };
            let times = (k * BigRational::from_integer(variable.over.into())).to_integer().to_i64();
            let part = Point::named(&variable.cos, &variable.sin);
            let Some(part) = times.and_then(|times| part.times(times)) else {
                self.limit("multiple of an angle", MULTIPLE_LIMIT as usize, span);
                return None;
            };
            let Some(sum) = out.plus(&part) else {
                self.limit("products for a cosine or sine", TERMS_LIMIT, span);
                return None;
            };
            out = sum;
        }
        self.nodes += 10 * out.terms();
        if self.nodes > NODES_LIMIT {
            self.limit("nodes of angles written out", NODES_LIMIT, span);
            return None;
        }
        Some(out)
    }
}
