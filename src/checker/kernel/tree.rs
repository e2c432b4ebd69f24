//! Trees taken apart: the parts of an expression, conjuncts, the sides of a single comparison; and a name in place of another.

use super::names::names_in;
use super::substitution::Substitution;
use super::{Reason, Refusal, rejected, statement};
use crate::claim::syntax::*;
use std::collections::BTreeSet;

/// The parts of an expression.
pub(super) fn parts(e: &Expr) -> Vec<&Expr> {
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => Vec::new(),
        ExprKind::Apply(_, arguments) => arguments.iter().collect(),
        ExprKind::Negate(a) | ExprKind::Derivative(a, _) => vec![a],
        ExprKind::Sum(list) => list.iter().map(|(_, e)| e).collect(),
        ExprKind::Product(list) => list.iter().map(|(_, e)| e).collect(),
        ExprKind::Power(a, b) => vec![a, b],
        ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) | ExprKind::IntegralOver(index, body) => {
            vec![&index.from, &index.to, body]
        }
        ExprKind::Matrix(rows) => rows.iter().flatten().collect(),
    }
}

/// Whether a proposition is a conjunction, whose parts are facts where it is one.
pub(super) fn conjuncts(p: &Prop) -> Vec<&Prop> {
    match &p.kind {
        PropKind::And(list) => list.iter().flat_map(conjuncts).collect(),
        _ => vec![p],
    }
}

/// The sides and the relation of a single comparison.
pub(super) fn single(prop: &Prop) -> Result<(&Expr, Relation, &Expr), Refusal> {
    prop.single().map_or_else(|| rejected(Reason::NotSingle), Ok)
}

/// An expression with one name in place of another. The new name must not occur yet: it would be taken for the old one.
pub(super) fn renamed(e: &Expr, old: &str, new: &str) -> Result<Expr, Refusal> {
    let mut names = BTreeSet::new();
    names_in(e, &mut names);
    if old != new && names.contains(new) {
        return rejected(Reason::NameInUse(new.to_string()));
    }
    let mut map = Substitution::default();
    map.replace(old, &statement::name(new));
    Ok(map.expr(e)?)
}
