//! Dependence: whether a hypothesis keeps the variable of a limit from growing, or ties the variable of a derivative to
//! others. Where it does, a single point says nothing of the limit or the derivative.

use super::expand::Statement;
use crate::claim::syntax::*;
use crate::kernel::statement::domain;
use std::collections::BTreeSet;

/// Whether a hypothesis or a domain keeps the variable of a limit from growing or ties the variable of a derivative to
/// others: then what holds at a point says nothing of either.
pub(super) fn ties_what_moves(statement: &Statement, bindings: &[Binding], goal: &Prop) -> bool {
    let (limit, derivative) = tied(statement, bindings, goal);
    limit || derivative.is_some()
}

/// The variable of a derivative in the goal that a hypothesis ties to others, if there is one. The derivative is partial
/// all the same, but a reader may think of another.
pub(super) fn tied_derivative(statement: &Statement) -> Option<String> {
    let (mut bindings, mut goal) = (statement.bindings.clone(), &statement.goal);
    while let PropKind::ForAll(more, body) = &goal.kind {
        bindings.extend(more.iter().cloned());
        goal = body;
    }
    // Parts of an equivalence are shown from one another by the kernel as they are read: partial.
    let mut premise = Vec::new();
    while let PropKind::Implies(p, q) = &goal.kind {
        premise.push((**p).clone());
        goal = q;
    }
    tied_by(statement, &bindings, goal, premise).1
}

/// Whether the variable of a limit is kept from growing, and the variable of a derivative that is tied to others.
fn tied(statement: &Statement, bindings: &[Binding], goal: &Prop) -> (bool, Option<String>) {
    let mut said = Vec::new();
    premises(goal, &mut said);
    tied_by(statement, bindings, goal, said)
}

/// The same, where the goal is said under no more than this.
fn tied_by(statement: &Statement, bindings: &[Binding], goal: &Prop, more: Vec<Prop>) -> (bool, Option<String>) {
    let (mut limits, mut derivatives) = (Vec::new(), Vec::new());
    moving(goal, &mut limits, &mut derivatives);
    if limits.is_empty() && derivatives.is_empty() {
        return (false, None);
    }
    let mut said = more;
    said.extend(statement.assumptions.iter().map(|a| a.1.clone()));
    said.extend(bindings.iter().flat_map(domain));
    let families = bindings.iter().filter(|b| b.names.iter().any(|n| n.1.is_some()));
    let of_families: BTreeSet<String> = families.flat_map(super::names::names_of_binding).collect();
    let kept = |v: &String| of_families.contains(v) || !said.iter().all(|prop| lets_grow(prop, v));
    let mut single = Vec::new();
    said.iter().for_each(|prop| comparisons(prop, &mut single));
    let bound = |v: &String| {
        let tying: Vec<&Prop> = single.iter().filter(|prop| ties(prop, v, !statement.declares(PI))).collect();
        let sides: BTreeSet<Option<bool>> = tying.iter().map(|prop| bounds_above(prop, v)).collect();
        // Below or above one bound a variable has room, whatever the others are.
        of_families.contains(v) || sides.contains(&None) || sides.len() > 1
    };
    (limits.iter().any(kept), derivatives.into_iter().find(bound))
}

/// What a part of a goal may be said under: premises, and the other parts of an equivalence or disjunction.
fn premises(goal: &Prop, into: &mut Vec<Prop>) {
    match &goal.kind {
        PropKind::And(list) => list.iter().filter(|p| speaks_of_what_moves(p)).for_each(|p| premises(p, into)),
        PropKind::Or(list) | PropKind::Equivalent(list) => {
            // One part of a disjunction is looked at where the others fail.
            for part in list.iter().filter(|p| !speaks_of_what_moves(p)) {
                into.push(part.clone());
                into.extend(negation(part));
            }
            list.iter().for_each(|p| premises(p, into));
        }
        PropKind::Implies(p, q) => {
            into.push((**p).clone());
            premises(q, into);
        }
        PropKind::Not(p) | PropKind::ForAll(_, p) | PropKind::Exists(_, p) => premises(p, into),
        PropKind::Compare(..) | PropKind::Extremum(_) | PropKind::Limit(_) | PropKind::WrittenLimit(_) => {}
    }
}

/// Whether a hypothesis says nothing of a variable, or only that it is above a number.
fn lets_grow(prop: &Prop, variable: &str) -> bool {
    if !super::names::names_of_prop(prop).contains(variable) {
        return true;
    }
    let PropKind::Compare(sides, relations) = &prop.kind else { return false };
    sides.len() == 2
        && matches!(relations[0], Relation::Greater | Relation::GreaterEqual)
        && matches!(&sides[0].kind, ExprKind::Name(n) if *n == variable)
        && matches!(&sides[1].kind, ExprKind::Number(_))
}

/// Whether a hypothesis, other than a strict comparison, has a variable and another name in it: alone or with others it
/// may determine one by the other, as `x*y <= 1` and `x*y >= 1` do; π is no such name. Derivatives are partial all the same, all other
/// variables held fast; this only refuses to speak of them where a reader could think of another derivative.
fn ties(prop: &Prop, variable: &str, is_pi: bool) -> bool {
    let strict = [Relation::Less, Relation::Greater, Relation::NotEqual];
    let open = match &prop.kind {
        PropKind::Compare(_, relations) => relations.iter().all(|r| strict.contains(r)),
        _ => false,
    };
    let mut names = super::names::names_of_prop(prop);
    names.retain(|name| !(is_built_in(name) || is_pi && name == PI));
    !open && names.contains(variable) && names.len() > 1
}

/// The parts of a conjunction, and the links of chains.
fn comparisons(prop: &Prop, into: &mut Vec<Prop>) {
    match &prop.kind {
        PropKind::And(list) => list.iter().for_each(|p| comparisons(p, into)),
        PropKind::Compare(sides, relations) => {
            let links = sides.windows(2).zip(relations);
            into.extend(links.map(|(pair, r)| {
                let kind = PropKind::Compare(pair.to_vec(), vec![*r]);
                Prop { kind, span: prop.span }
            }));
        }
        _ => into.push(prop.clone()),
    }
}

/// Whether an inequality bounds a variable from above or below by an expression without it; `None` where it does neither.
fn bounds_above(prop: &Prop, variable: &str) -> Option<bool> {
    let (a, relation, b) = prop.single()?;
    let is_it = |e: &Expr| matches!(&e.kind, ExprKind::Name(n) if n == variable);
    let is_free = |e: &Expr| {
        let mut names = BTreeSet::new();
        crate::claim::free_names::names_in(e, &mut names);
        !names.contains(variable)
    };
    let is_upper = match relation {
        Relation::LessEqual => is_it(a),
        Relation::GreaterEqual => is_it(b),
        _ => return None,
    };
    let other = if is_it(a) { b } else { a };
    ((is_it(a) || is_it(b)) && is_free(other)).then_some(is_upper)
}

fn speaks_of_what_moves(prop: &Prop) -> bool {
    let (mut limits, mut derivatives) = (Vec::new(), Vec::new());
    moving(prop, &mut limits, &mut derivatives);
    !limits.is_empty() || !derivatives.is_empty()
}

/// The variables of limits and of derivatives.
fn moving(prop: &Prop, limits: &mut Vec<String>, derivatives: &mut Vec<String>) {
    fn by(e: &Expr, into: &mut Vec<String>) {
        if let ExprKind::Derivative(_, names) = &e.kind {
            into.extend(names.iter().map(|n| n.text.clone()));
        }
        super::expand::parts(e, &mut |part| by(part, into));
    }
    match &prop.kind {
        PropKind::Compare(sides, _) => sides.iter().for_each(|e| by(e, derivatives)),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| moving(p, limits, derivatives));
        }
        PropKind::Not(p) | PropKind::Exists(_, p) | PropKind::ForAll(_, p) => moving(p, limits, derivatives),
        PropKind::Implies(p, q) => {
            moving(p, limits, derivatives);
            moving(q, limits, derivatives);
        }
        PropKind::Extremum(extremum) => {
            [&extremum.of, &extremum.value].into_iter().for_each(|e| by(e, derivatives));
            extremum.at.iter().for_each(|(_, e)| by(e, derivatives));
        }
        PropKind::Limit(limit) => {
            limits.push(limit.variable.text.clone());
            by(&limit.of, derivatives);
            by(&limit.value, derivatives);
        }
        PropKind::WrittenLimit(limit) => {
            limits.push(limit.variable.text.clone());
            limit.parts().for_each(|e| by(e, derivatives));
        }
    }
}

pub(super) fn differentiates(e: &Expr) -> bool {
    let mut found = matches!(e.kind, ExprKind::Derivative(..));
    super::expand::parts(e, &mut |part| found |= differentiates(part));
    found
}

/// The negation with `not` pushed inwards; `None` for extrema and limits.
fn negation(prop: &Prop) -> Option<Prop> {
    let span = prop.span;
    let kind = match &prop.kind {
        PropKind::Compare(sides, relations) => {
            let list: Vec<Prop> = sides
                .windows(2)
                .zip(relations)
                .map(|(pair, r)| Prop { kind: PropKind::Compare(pair.to_vec(), vec![r.negated()]), span })
                .collect();
            if let [one] = list.as_slice() {
                return Some(one.clone());
            }
            PropKind::Or(list)
        }
        PropKind::And(list) => PropKind::Or(list.iter().map(negation).collect::<Option<_>>()?),
        PropKind::Or(list) => PropKind::And(list.iter().map(negation).collect::<Option<_>>()?),
        PropKind::Not(inner) => return Some((**inner).clone()),
        PropKind::Implies(p, q) => PropKind::And(vec![(**p).clone(), negation(q)?]),
        PropKind::Equivalent(list) => {
            let [p, q] = list.as_slice() else { return None };
            let both = |a: Prop, b: Prop| Prop { kind: PropKind::And(vec![a, b]), span };
            PropKind::Or(vec![both(p.clone(), negation(q)?), both(negation(p)?, q.clone())])
        }
        PropKind::Exists(bindings, body) => PropKind::ForAll(bindings.clone(), Box::new(negation(body)?)),
        PropKind::ForAll(bindings, body) => PropKind::Exists(bindings.clone(), Box::new(negation(body)?)),
        PropKind::Extremum(_) | PropKind::Limit(_) | PropKind::WrittenLimit(_) => return None,
    };
    Some(Prop { kind, span })
}
