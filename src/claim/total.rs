//! Expressions that, by their form, have a value wherever the hypotheses hold.
//!
//! Expanding an abbreviation may drop a part of it, and with the part the conditions under which it has a value. Code that
//! asks this module first keeps these conditions.

use super::definedness::{needs, number};
use super::syntax::*;
use super::walk;

/// Whether an expression has a value wherever the hypotheses hold, by how it is written: it divides by numbers other than 0
/// alone, and nothing in it has another condition. `named` says of a name whether what it stands for has a value; families,
/// definitions with parameters, sums and products are taken to have conditions.
pub(crate) fn has_a_value(e: &Expr, named: &dyn Fn(&str) -> bool) -> bool {
    const EVERYWHERE: [&str; 8] = ["abs", "max", "min", "exp", "cosh", "sinh", "sech", "tanh"];
    let mut all = match &e.kind {
        ExprKind::Product(list) => {
            list.iter().all(|(factor, a)| *factor == Factor::Times || number(a).is_some_and(|(top, _)| top != 0))
        }
        ExprKind::Apply(f, _) => EVERYWHERE.contains(&f.text.as_str()) && named(&f.text),
        ExprKind::Name(name) => named(name),
        ExprKind::Number(_) | ExprKind::Negate(_) | ExprKind::Sum(_) => true,
        ExprKind::Power(..) => needs(e, &|_| false).is_empty(),
        _ => false,
    };
    walk::parts(e, &mut |part| all = all && has_a_value(part, named));
    all
}
