//! What is positive by its form alone.
//!
//! Contract: [`Positive::holds`] is true only of expressions that are positive wherever the
//! declarations hold and the expression has a value. It decides no more than which conditions go
//! without saying, never a claim.

use super::kinds::{Kinds, is_natural};
use crate::claim::syntax::*;

/// The names that declarations make positive.
#[derive(Clone)]
pub struct Positive {
    names: Vec<String>,
}

fn positive_numeral(text: &str) -> bool {
    // The digits before an exponent of ten decide.
    text.split(['e', 'E']).next().is_some_and(|digits| digits.bytes().any(|b| (b'1'..=b'9').contains(&b)))
}

fn numeral(e: &Expr) -> Option<&str> {
    match &e.kind {
        ExprKind::Number(text) => Some(text),
        _ => None,
    }
}

impl Positive {
    /// The names and families that a claim declares positive.
    pub(crate) fn of_claim(claim: &Claim) -> Positive {
        let mut out = Positive { names: Vec::new() };
        for item in &claim.items {
            if let Item::Given(bindings) = item {
                out.declare(bindings);
            }
        }
        out
    }

    /// Adds names that bindings make positive.
    pub fn declare(&mut self, bindings: &[Binding]) {
        for binding in bindings.iter().filter(|b| b.indices.is_none()) {
            let positive = binding.constraints.iter().any(|c| match c {
                Constraint::Relation(Relation::Greater, e) => numeral(e).is_some(),
                Constraint::Relation(Relation::GreaterEqual, e) => numeral(e).is_some_and(positive_numeral),
                _ => false,
            });
            if positive {
                self.names.extend(binding.names.iter().map(|n| n.0.text.clone()));
            }
        }
    }

    /// Whether an expression is positive by its form.
    pub fn holds(&self, e: &Expr, kinds: &Kinds) -> bool {
        match &e.kind {
            ExprKind::Number(text) => positive_numeral(text),
            ExprKind::Name(name) => self.names.contains(name),
            ExprKind::Apply(f, list) => match f.text.as_str() {
                "exp" | "cosh" | "sech" => true,
                "sqrt" | "cbrt" => list.iter().all(|e| self.holds(e, kinds)),
                name => self.names.iter().any(|p| p == name),
            },
            ExprKind::Sum(list) => {
                list.iter().all(|(s, e)| *s == Sign::Plus && (self.holds(e, kinds) || is_natural(e, kinds)))
                    && list.iter().any(|(_, e)| self.holds(e, kinds))
            }
            ExprKind::Product(list) => list.iter().all(|(_, e)| self.holds(e, kinds)),
            ExprKind::Power(base, _) => self.holds(base, kinds),
            _ => false,
        }
    }
}
