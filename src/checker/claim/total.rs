//! Expressions that, by their form, have a value wherever the hypotheses hold.
//!
//! Expanding an abbreviation may drop a part of it, and with the part the conditions under which it has a value. Code that
//! asks this module first keeps these conditions.

use super::definedness::{needs, number};
use super::preamble::applied;
use super::syntax::*;
use super::walk;
use std::collections::BTreeSet;

/// Whether an expression has a value wherever the hypotheses hold, by how it is written: it divides by numbers other than 0
/// and by what is positive by its form, and nothing in it has another condition. `named` says of a name whether what it
/// stands for has a value, `positive` whether it is declared positive; families, definitions with parameters, sums and products
/// are taken to have conditions.
pub(crate) fn has_a_value(e: &Expr, named: &dyn Fn(&str) -> bool, positive: &dyn Fn(&str) -> bool) -> bool {
    const EVERYWHERE: [&str; 8] = ["abs", "max", "min", "exp", "cosh", "sinh", "sech", "tanh"];
    let mut all = match &e.kind {
        ExprKind::Product(list) => list.iter().all(|(factor, a)| {
            *factor == Factor::Times || number(a).is_some_and(|(top, _)| top != 0) || is_positive(a, positive)
        }),
        ExprKind::Apply(f, _) => EVERYWHERE.contains(&f.text.as_str()) && named(&f.text),
        ExprKind::Name(name) => named(name),
        ExprKind::Number(_) | ExprKind::Negate(_) | ExprKind::Sum(_) => true,
        ExprKind::Power(..) => needs(e, &|_| false).is_ok_and(|needs| needs.is_empty()),
        _ => false,
    };
    walk::parts(e, &mut |part| all = all && has_a_value(part, named, positive));
    all
}

/// Whether an expression is positive by its form: sums, products, quotients and whole powers of positive numbers and names.
fn is_positive(e: &Expr, positive: &dyn Fn(&str) -> bool) -> bool {
    let inner = |e: &Expr| is_positive(e, positive);
    match &e.kind {
        ExprKind::Number(_) => number(e).is_some_and(|(top, _)| top > 0),
        ExprKind::Name(name) => positive(name),
        ExprKind::Sum(list) => list.iter().all(|(sign, e)| *sign == Sign::Plus && inner(e)),
        ExprKind::Product(list) => list.iter().all(|(_, e)| inner(e)),
        ExprKind::Power(base, exponent) => inner(base) && number(exponent).is_some_and(|(_, below)| below == 1),
        _ => false,
    }
}

/// Whether a constraint keeps a name above 0: `> 0`, `>= 1`, `in (0, 1]`, `in 1..n`.
fn is_above_zero(constraint: &Constraint) -> bool {
    let above = |bound: &Expr, included: bool| number(bound).is_some_and(|(top, _)| top > 0 || (top == 0 && !included));
    match constraint {
        Constraint::Relation(Relation::Greater, bound) => above(bound, false),
        Constraint::Relation(Relation::GreaterEqual, bound) => above(bound, true),
        Constraint::Relation(..) => false,
        Constraint::Interval { from, from_closed, .. } => above(from, *from_closed),
        Constraint::Range(from, _) => above(from, true),
    }
}

/// What the items of a claim, in their order, tell of the names that they declare.
#[derive(Default)]
pub(crate) struct Values {
    /// Names of what may have no value: families, definitions with parameters or with conditions of their own.
    partial: BTreeSet<String>,
    /// Variables that are declared positive.
    positive: BTreeSet<String>,
}

impl Values {
    /// Learns what an item says of the names that it declares.
    pub(crate) fn learn(&mut self, item: &Item) {
        self.partial.extend(applied(item).into_iter().map(|n| n.text.clone()));
        match item {
            Item::Let { name, value, .. } if !self.exist_for(value) => {
                self.partial.insert(name.text.clone());
            }
            Item::Given(bindings) => {
                let positive = bindings.iter().filter(|b| b.constraints.iter().any(is_above_zero));
                let names = positive.flat_map(|b| &b.names).filter(|n| n.1.is_none());
                self.positive.extend(names.map(|n| n.0.text.clone()));
            }
            _ => {}
        }
    }

    /// Whether an expression has a value wherever the hypotheses hold.
    pub(crate) fn exist_for(&self, e: &Expr) -> bool {
        has_a_value(e, &|name| !self.partial.contains(name), &|name| self.positive.contains(name))
    }
}
