//! Looks through a proof before its first sentence: false facts, steps that introduce names, purposes of suppositions.

use super::Words;
use crate::certificate::{Label, Rule};
use crate::claim::print;
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::numeral;

/// A part of a fact of more letters is cited by the whole fact.
const LONG: usize = 30;

impl Words<'_> {
    /// Finds false facts, steps that introduce names, polynomials that are products, and the purpose of each supposition.
    pub(super) fn look_ahead(&mut self) {
        for seen in &self.followed.seen {
            let show = &seen.show;
            match &show.rule {
                Rule::Name => {
                    self.naming.insert(show.label.clone());
                }
                // An equation that writes a product of powers by a few others needs no words.
                Rule::Power if show.prop.single().is_some() => {
                    self.naming.insert(show.label.clone());
                }
                Rule::Logic { from } => {
                    // A part of a long fact is cited by the whole.
                    if let [one] = from.as_slice()
                        && matches!(self.followed.facts.get(one).map(|p| &p.kind), Some(PropKind::And(_)))
                        && print::prop(&self.short.prop(&show.prop)).len() > LONG
                    {
                        self.same.insert(show.label.clone(), one.clone());
                    }
                    if from.iter().any(|label| self.absurd.contains(label)) {
                        self.absurd.insert(show.label.clone());
                    }
                    if let (PropKind::Equivalent(_), [_, second]) = (&show.prop.kind, from.as_slice()) {
                        self.converse.insert(second.clone());
                    }
                    let is_or =
                        |l: &&Label| matches!(self.followed.facts.get(*l).map(|p| &p.kind), Some(PropKind::Or(_)));
                    if from.iter().any(|label| is_or(&label)) {
                        self.cases.extend(from.iter().filter(|l| !is_or(l)).cloned());
                    }
                }
                Rule::Combination { terms, .. } => {
                    let text = print::prop(&show.prop);
                    let cited = show.by.iter().chain(terms.iter().flat_map(|t| &t.facts));
                    let says = |label: &&Label| self.followed.facts.get(*label).is_some_and(|p| print::prop(p) == text);
                    if let Some(same) = cited.into_iter().find(says) {
                        self.same.insert(show.label.clone(), same.clone());
                    }
                    if is_false(&show.prop) {
                        self.absurd.insert(show.label.clone());
                    }
                    // A polynomial whose sign is plain from its factors, and that serves for its sign only.
                    if let [term] = terms.as_slice()
                        && term.facts.is_empty()
                        && !self.followed.cited.contains(&show.label)
                    {
                        self.products.insert(show.label.clone());
                    }
                }
                _ => {}
            }
        }
    }
}

/// Whether a comparison of numerals is false.
fn is_false(p: &Prop) -> bool {
    let zero = |text: &str| text.bytes().all(|b| b == b'0' || b == b'.');
    let signs = |e: &Expr| match &e.kind {
        ExprKind::Number(text) => Some(if zero(text) { Signs::ZERO } else { Signs::POSITIVE }),
        ExprKind::Negate(inner) => match &inner.kind {
            ExprKind::Number(text) if !zero(text) => Some(Signs::of(Relation::Less)),
            _ => None,
        },
        _ => None,
    };
    match p.single() {
        Some((a, relation, b)) if *b == numeral(0) => signs(a).is_some_and(|found| !found.within(Signs::of(relation))),
        _ => false,
    }
}
