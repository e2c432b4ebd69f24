//! The names that occur in expressions, propositions and bindings; in an expression those that occur free.

use super::syntax::*;
use std::collections::BTreeSet;

/// Every name that occurs free.
pub fn names_in(e: &Expr, out: &mut BTreeSet<String>) {
    use ExprKind::*;
    match &e.kind {
        Number(_) => {}
        Name(text) => {
            out.insert(text.clone());
        }
        Apply(function, arguments) => {
            out.insert(function.text.clone());
            arguments.iter().for_each(|e| names_in(e, out));
        }
        Negate(a) => names_in(a, out),
        Sum(list) => list.iter().for_each(|(_, e)| names_in(e, out)),
        Product(list) => list.iter().for_each(|(_, e)| names_in(e, out)),
        Power(a, b) => {
            names_in(a, out);
            names_in(b, out);
        }
        SumOver(index, body) | ProductOver(index, body) | IntegralOver(index, body) => {
            names_in(&index.from, out);
            names_in(&index.to, out);
            let mut inside = BTreeSet::new();
            names_in(body, &mut inside);
            inside.remove(&index.name.text);
            out.extend(inside);
        }
        Derivative(body, by) => {
            out.extend(by.iter().map(|n| n.text.clone()));
            names_in(body, out);
        }
        Matrix(rows) => rows.iter().flatten().for_each(|e| names_in(e, out)),
    }
}

/// Every name that occurs in a proposition, bound ones as well.
pub fn names_in_prop(p: &Prop, out: &mut BTreeSet<String>) {
    use PropKind::*;
    match &p.kind {
        Compare(sides, _) => sides.iter().for_each(|e| names_in(e, out)),
        And(list) | Or(list) | Equivalent(list) => list.iter().for_each(|p| names_in_prop(p, out)),
        Not(inner) => names_in_prop(inner, out),
        Implies(a, b) => {
            names_in_prop(a, out);
            names_in_prop(b, out);
        }
        Exists(bindings, body) | ForAll(bindings, body) => {
            bindings.iter().for_each(|b| names_in_binding(b, out));
            names_in_prop(body, out);
        }
        Extremum(e) => {
            e.over.iter().for_each(|b| names_in_binding(b, out));
            [&e.of, &e.value].into_iter().chain(e.at.iter().map(|a| &a.1)).for_each(|e| names_in(e, out));
        }
        Limit(l) => {
            out.insert(l.variable.text.clone());
            names_in(&l.of, out);
            names_in(&l.value, out);
        }
        WrittenLimit(l) => {
            out.insert(l.variable.text.clone());
            l.parts().for_each(|e| names_in(e, out));
        }
    }
}

/// Every name that occurs in a binding.
pub fn names_in_binding(b: &Binding, out: &mut BTreeSet<String>) {
    for (name, index) in &b.names {
        out.insert(name.text.clone());
        out.extend(index.iter().map(|n| n.text.clone()));
    }
    for constraint in &b.constraints {
        match constraint {
            Constraint::Relation(_, e) => names_in(e, out),
            Constraint::Interval { from, to, .. } | Constraint::Range(from, to) => {
                names_in(from, out);
                names_in(to, out);
            }
        }
    }
    if let Some((from, to)) = &b.indices {
        names_in(from, out);
        names_in(to, out);
    }
}
