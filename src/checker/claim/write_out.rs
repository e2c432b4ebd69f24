//! A claim written out in the kernel's words.
//!
//! Contract: after `write_out` a claim has no floors, no limits but those at infinity, and no abbreviations, and says
//! the same as before. What its author wrote stays in [`Claim::written`]. The claim that was written out is checked for its names
//! again, as its author's was.

use super::diagnostic::Diagnostic;
use super::fresh::Fresh;
use super::substitution::Substitution;
use super::syntax::*;
use super::{abbreviation, check, floor, limit, trigonometry, walk};
use std::collections::BTreeSet;

/// Writes out a claim whose names were checked.
pub(super) fn write_out(claim: &mut Claim, faults: &mut Vec<Diagnostic>) {
    if !has_to_be(claim) {
        return;
    }
    let written = Written { items: said_items(claim), goal: claim.goal.clone(), made: Vec::new() };
    let mut fresh = Fresh::of(claim);
    trigonometry::write_out(claim, &mut fresh);
    let stages = [limit::write_out, floor::write_out, abbreviation::write_out];
    let mut found = Vec::new();
    for stage in stages {
        if found.is_empty() {
            stage(claim, &mut fresh, &mut found);
        }
    }
    if found.is_empty() {
        check::check(claim, &mut found);
    }
    // What a stage writes out twice is at fault once.
    found.dedup();
    faults.append(&mut found);
    claim.written = Some(Box::new(Written { made: fresh.made(), ..written }));
}

/// The declarations without those that a limit makes of its own variable: their place is that of the name in the limit.
fn said_items(claim: &mut Claim) -> Vec<Item> {
    let mut variables = Vec::new();
    walk::all_props(claim, &mut |p| {
        if let PropKind::WrittenLimit(limit) = &p.kind {
            variables.push((limit.variable.text.clone(), limit.variable.span));
        }
    });
    let is_own = |binding: &Binding| match binding.names.as_slice() {
        [(name, None)] => variables.contains(&(name.text.clone(), binding.span)),
        _ => false,
    };
    let mut items = claim.items.clone();
    items.retain(|item| !matches!(item, Item::Given(bindings) if bindings.iter().all(is_own)));
    items
}

/// The words of a claim's author for the names that the reader made: `cos(theta)` for `cos_theta`. Where a name is bound, what
/// holds it stays as it is.
#[derive(Clone, Debug, Default)]
pub struct Words(Substitution);

impl Words {
    /// The words of this claim's author.
    pub fn of(claim: &Claim) -> Words {
        let mut words = Substitution::default();
        for (name, meaning) in claim.written.iter().flat_map(|written| &written.made) {
            words.replace(name, meaning);
        }
        Words(words)
    }

    /// An expression in these words.
    pub fn expr(&self, e: &Expr) -> Expr {
        self.0.expr(e).unwrap_or_else(|_| e.clone())
    }

    /// A proposition in these words.
    pub fn prop(&self, prop: &Prop) -> Prop {
        self.0.prop(prop).unwrap_or_else(|_| prop.clone())
    }
}

/// A proposition in the words of the claim's author.
pub fn in_words(claim: &Claim, prop: &Prop) -> Prop {
    Words::of(claim).prop(prop)
}

/// Whether a claim has something to be written out: a word that is, a power of a matrix, or a limit.
fn has_to_be(claim: &mut Claim) -> bool {
    let mut names = BTreeSet::new();
    let mut has_matrix = false;
    walk::expressions(claim, &mut |e| {
        walk::names_in(e, &mut names);
        has_matrix = has_matrix || is_matrix(e);
    });
    let mut has_limit = false;
    walk::all_props(claim, &mut |p| has_limit = has_limit || matches!(p.kind, PropKind::WrittenLimit(_)));
    let is_word = |name: &String| {
        trigonometry::is_function(name) || floor::is_function(name) || abbreviation::is_one(name) || name == PI
    };
    let is_integer = |item: &Item| matches!(item, Item::Let { value: Expr { kind: ExprKind::Sum(_), .. }, .. });
    has_matrix
        || has_limit
        || names.iter().any(is_word)
        || !claim.sample.is_empty() && claim.items.iter().any(is_integer)
}

/// Whether a matrix occurs.
fn is_matrix(e: &Expr) -> bool {
    let mut found = matches!(e.kind, ExprKind::Matrix(_));
    walk::parts(e, &mut |part| found = found || is_matrix(part));
    found
}
