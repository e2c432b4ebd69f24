//! Rational numbers and multiples of π as expressions.

use crate::claim::syntax::*;
use crate::kernel::statement::{expr, name};
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

/// r + s·π as an expression, s other than 0: `2*pi/3`, `1/2 - pi`.
pub(crate) fn beside_pi(rest: &Rational, turns: &Rational) -> Expr {
    let (top, bottom) = (turns.numerator_ref(), turns.denominator_ref());
    let mut factors = vec![(Factor::Times, name(PI))];
    if *top != 1u32 {
        factors.insert(0, (Factor::Times, expr(ExprKind::Number(top.to_string()))));
    }
    if *bottom != 1u32 {
        factors.push((Factor::Over, expr(ExprKind::Number(bottom.to_string()))));
    }
    let size = if factors.len() == 1 { name(PI) } else { expr(ExprKind::Product(factors)) };
    match (*rest == 0, *turns < 0) {
        (true, false) => size,
        (true, true) => expr(ExprKind::Negate(Box::new(size))),
        (false, below) => {
            let sign = if below { Sign::Minus } else { Sign::Plus };
            expr(ExprKind::Sum(vec![(Sign::Plus, literal(rest)), (sign, size)]))
        }
    }
}

/// Whether an expression is the numeral 0.
pub(crate) fn is_zero(e: &Expr) -> bool {
    matches!(&e.kind, ExprKind::Number(text) if text == "0")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claim::print::expr;

    #[test]
    fn multiples_of_pi_are_written_as_a_reader_writes_them() {
        let q = Rational::from_signeds;
        for (rest, turns, text) in [
            (q(0, 1), q(1, 1), "pi"),
            (q(0, 1), q(-1, 2), "-pi/2"),
            (q(0, 1), q(2, 3), "2*pi/3"),
            (q(1, 2), q(-1, 1), "1/2 - pi"),
            (q(-3, 1), q(5, 6), "-3 + 5*pi/6"),
        ] {
            assert_eq!(expr(&beside_pi(&rest, &turns)), text);
        }
    }
}
