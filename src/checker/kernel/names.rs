//! The names that occur in expressions and propositions.

pub use crate::claim::free_names::{names_in, names_in_binding, names_in_prop};

use super::statement::domain;
use crate::claim::syntax::*;
use std::collections::BTreeSet;

/// The names that occur free in a proposition.
pub fn free_names(p: &Prop, out: &mut BTreeSet<String>) {
    match &p.kind {
        PropKind::Compare(sides, _) => sides.iter().for_each(|e| names_in(e, out)),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| free_names(p, out))
        }
        PropKind::Not(inner) => free_names(inner, out),
        PropKind::Implies(a, b) => [a, b].into_iter().for_each(|p| free_names(p, out)),
        PropKind::Exists(bindings, body) | PropKind::ForAll(bindings, body) => {
            let mut inside = BTreeSet::new();
            free_names(body, &mut inside);
            for binding in bindings {
                domain(binding).iter().for_each(|p| free_names(p, &mut inside));
            }
            bindings.iter().flat_map(|b| &b.names).for_each(|n| {
                inside.remove(&n.0.text);
            });
            out.extend(inside);
        }
        // Not evaluated.
        PropKind::Extremum(_) | PropKind::Limit(_) | PropKind::WrittenLimit(_) => {}
    }
}
