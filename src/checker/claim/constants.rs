//! What a derivative takes for a constant, although it depends on the variable.
//!
//! A floor, a member of a power of a matrix and a member of a recurrence become numbers that hypotheses define: `k <= x < k + 1`,
//! `u(0) = A`, `for all k natural: u(k + 1) = B`. To the kernel such a number is another variable, so its derivative by x is 0.
//! Contract: [`check`] refuses a claim in which one of them stands in a derivative by a variable that its definition mentions,
//! directly or through other definitions. A family that its author defines by such equations is refused likewise.

use super::diagnostic::{Diagnostic, Fault};
use super::preamble::applied;
use super::syntax::*;
use super::walk;
use std::collections::{BTreeMap, BTreeSet};

/// The names of a claim with those that their definitions mention.
type Mentions = BTreeMap<String, BTreeSet<String>>;

/// Refuses such derivatives in a claim that is written out.
pub(super) fn check(claim: &mut Claim, faults: &mut Vec<Diagnostic>) {
    let mut derivatives = Vec::new();
    walk::expressions(claim, &mut |e| derivatives_in(e, &mut derivatives));
    if derivatives.is_empty() {
        return;
    }
    let (plain, made) = (plain_definitions(claim), made_constants(claim));
    let mut all = plain.clone();
    made.iter().for_each(|(name, mentions)| all.entry(name.clone()).or_default().extend(mentions.iter().cloned()));
    for (span, body, by) in derivatives {
        let inside = reached(body, &plain);
        for name in inside.iter().filter(|name| made.contains_key(*name)) {
            let depends = reached(BTreeSet::from([name.clone()]), &all);
            if let Some(variable) = by.iter().find(|variable| depends.contains(*variable)) {
                let shown = claim.meaning_of(name).map_or_else(|| name.clone(), super::print::expr);
                let message =
                    format!("a derivative by {variable} of {shown}, which depends on {variable}, cannot be read");
                let help = Some("write out what is differentiated, as an expression in the variable".to_string());
                faults.push(Diagnostic::new(Fault::Other { message, help }, span));
                break;
            }
        }
    }
}

/// The derivatives in an expression: place, names in the body, and the variables.
fn derivatives_in(e: &Expr, out: &mut Vec<(Span, BTreeSet<String>, Vec<String>)>) {
    if let ExprKind::Derivative(body, by) = &e.kind {
        let mut names = BTreeSet::new();
        walk::names_in(body, &mut names);
        out.push((e.span, names, by.iter().map(|n| n.text.clone()).collect()));
    }
    walk::parts(e, &mut |part| derivatives_in(part, out));
}

/// What is put in place, or unfolded by its own step: definitions by `let`, and sequences.
fn plain_definitions(claim: &Claim) -> Mentions {
    let mut out = Mentions::new();
    for item in &claim.items {
        let (name, values) = match item {
            Item::Let { name, value, .. } => (name, vec![value]),
            Item::Define { name, initial, step, .. } => (name, vec![initial, step]),
            Item::Given(_) | Item::Assume { .. } => continue,
        };
        let mentions = out.entry(name.text.clone()).or_default();
        values.into_iter().for_each(|value| walk::names_in(value, mentions));
    }
    out
}

/// What hypotheses define: floors, and families by an equation for a member alone.
fn made_constants(claim: &Claim) -> Mentions {
    let mut out = Mentions::new();
    for (name, meaning) in claim.written.iter().flat_map(|written| &written.made) {
        if matches!(&meaning.kind, ExprKind::Apply(word, _) if super::floor::is_function(&word.text)) {
            walk::names_in(meaning, out.entry(name.clone()).or_default());
        }
    }
    let given = claim.items.iter().filter(|item| matches!(item, Item::Given(_)));
    let families: BTreeSet<&str> = given.flat_map(applied).map(|n| n.text.as_str()).collect();
    for item in &claim.items {
        let Item::Assume { prop, .. } = item else { continue };
        equations(prop, &mut |side, other| {
            if let ExprKind::Apply(name, _) = &side.kind
                && families.contains(name.text.as_str())
            {
                walk::names_in(other, out.entry(name.text.clone()).or_default());
            }
        });
    }
    out
}

/// Calls `visit` with both sides of every equation in a hypothesis, each once as the first.
fn equations(prop: &Prop, visit: &mut dyn FnMut(&Expr, &Expr)) {
    match &prop.kind {
        PropKind::Compare(sides, relations) => {
            for (pair, relation) in sides.windows(2).zip(relations) {
                if let ([a, b], Relation::Equal) = (pair, relation) {
                    visit(a, b);
                    visit(b, a);
                }
            }
        }
        PropKind::And(list) => list.iter().for_each(|p| equations(p, visit)),
        PropKind::ForAll(_, body) => equations(body, visit),
        _ => {}
    }
}

/// These names, and all that their definitions mention.
fn reached(names: BTreeSet<String>, mentions: &Mentions) -> BTreeSet<String> {
    let mut open: Vec<String> = names.iter().cloned().collect();
    let mut out = names;
    while let Some(name) = open.pop() {
        for next in mentions.get(&name).into_iter().flatten() {
            if out.insert(next.clone()) {
                open.push(next.clone());
            }
        }
    }
    out
}
