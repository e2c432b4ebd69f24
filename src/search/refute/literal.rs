//! Rational numbers as expressions.

use crate::claim::syntax::*;
use malachite::Rational;

/// A rational as an expression.
pub fn literal(q: &Rational) -> Expr {
    let span = Span::default();
    let number = |text: String| Expr { kind: ExprKind::Number(text), span };
    let (top, bottom) = (number(q.numerator_ref().to_string()), number(q.denominator_ref().to_string()));
    let size = if *q.denominator_ref() == 1u32 {
        top
    } else {
        Expr { kind: ExprKind::Product(vec![(Factor::Times, top), (Factor::Over, bottom)]), span }
    };
    if *q < 0 { Expr { kind: ExprKind::Negate(Box::new(size)), span } } else { size }
}

/// Whether an expression is the numeral 0.
pub(crate) fn is_zero(e: &Expr) -> bool {
    matches!(&e.kind, ExprKind::Number(text) if text == "0")
}
