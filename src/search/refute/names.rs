//! The names that occur in propositions and bindings, bound ones included.

use crate::claim::syntax::*;
use crate::claim::walk::names_in;
use std::collections::BTreeSet;

/// All names that occur in a proposition.
pub(crate) fn names_of_prop(prop: &Prop) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    names_in_prop(prop, &mut names);
    names
}

/// All names that occur in a binding.
pub(crate) fn names_of_binding(binding: &Binding) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    names_in_binding(binding, &mut names);
    names
}

fn names_in_prop(prop: &Prop, into: &mut BTreeSet<String>) {
    use PropKind::*;
    match &prop.kind {
        Compare(sides, _) => sides.iter().for_each(|e| names_in(e, into)),
        And(list) | Or(list) | Equivalent(list) => list.iter().for_each(|p| names_in_prop(p, into)),
        Not(p) => names_in_prop(p, into),
        Implies(p, q) => {
            names_in_prop(p, into);
            names_in_prop(q, into);
        }
        Exists(bindings, body) | ForAll(bindings, body) => {
            bindings.iter().for_each(|b| names_in_binding(b, into));
            names_in_prop(body, into);
        }
        Extremum(extremum) => {
            extremum.over.iter().for_each(|b| names_in_binding(b, into));
            names_in(&extremum.of, into);
            names_in(&extremum.value, into);
            extremum.at.iter().for_each(|(_, e)| names_in(e, into));
        }
        Limit(limit) => {
            into.insert(limit.variable.text.clone());
            names_in(&limit.of, into);
            names_in(&limit.value, into);
        }
        WrittenLimit(limit) => {
            into.insert(limit.variable.text.clone());
            limit.parts().for_each(|e| names_in(e, into));
        }
    }
}

fn names_in_binding(binding: &Binding, into: &mut BTreeSet<String>) {
    into.extend(binding.names.iter().map(|n| n.0.text.clone()));
    for constraint in &binding.constraints {
        match constraint {
            Constraint::Relation(_, e) => names_in(e, into),
            Constraint::Interval { from, to, .. } | Constraint::Range(from, to) => {
                names_in(from, into);
                names_in(to, into);
            }
        }
    }
    if let Some((a, b)) = &binding.indices {
        names_in(a, into);
        names_in(b, into);
    }
}
