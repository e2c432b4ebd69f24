//! Citations of facts: by their name, by their text, or by their number.

use super::{Words, say};
use crate::certificate::Label;
use crate::claim::print::Style;
use crate::claim::syntax::*;
use crate::explain::document::Piece;
use crate::explain::follow::Seen;
use crate::explain::signs;

/// Facts of at most this many characters are cited by their text.
const PLAIN: usize = 14;

impl Words<'_> {
    /// The citation of a fact.
    pub(in crate::explain) fn cited(&self, label: &Label) -> Piece {
        let mut label = label;
        while let Some(same) = self.same.get(label) {
            label = same;
        }
        if self.followed.seen.iter().any(|seen| seen.show.label == *label && seen.show.opens()) {
            return say("what was shown above");
        }
        if let Some(called) = self.hypotheses.get(label) {
            return Piece::Text(format!("the hypothesis “{called}”"));
        }
        match self.followed.facts.get(label) {
            Some(prop) => Piece::Fact(label.clone(), self.short.prop(prop)),
            None => Piece::Text(label.clone()),
        }
    }

    /// Facts as they are cited, separated by commas and `and`.
    pub(in crate::explain) fn cited_all(&self, labels: &[Label]) -> Vec<Piece> {
        let mut out = Vec::new();
        for (place, label) in labels.iter().enumerate() {
            if place > 0 {
                out.push(say(if place + 1 == labels.len() { " and " } else { ", " }));
            }
            out.push(self.cited(label));
        }
        out
    }

    /// Whether a fact is short enough to be cited by its text, like `m > 0`.
    pub(in crate::explain) fn is_short(&self, label: &Label) -> bool {
        let Some((a, relation, b)) = self.followed.facts.get(label).and_then(Prop::single) else { return false };
        relation != Relation::Equal
            && matches!(b.kind, ExprKind::Number(_) | ExprKind::Name(_))
            && Style::Text.expr(&self.short.expr(a)).len() <= PLAIN
    }

    /// Whether a fact only says that a name of the proof is positive, which the proof states with the name.
    fn is_of_name(&self, label: &Label) -> bool {
        let sides = self.followed.facts.get(label).and_then(Prop::single);
        matches!(sides, Some((Expr { kind: ExprKind::Name(r), .. }, _, _)) if self.short.is_given(r))
    }

    /// `since m₁, m₂ > 0 and e ≥ 0`, of those facts that are short; nothing if there are none.
    pub(in crate::explain) fn since(&self, labels: &[Label]) -> Vec<Piece> {
        let facts: Vec<(Expr, Relation, Expr)> = labels
            .iter()
            .filter(|label| self.is_short(label) && !self.is_of_name(label))
            .filter_map(|label| self.followed.facts.get(label).and_then(Prop::single))
            .map(|(a, r, b)| (self.short.expr(a), r, b.clone()))
            .collect();
        let mut out = Vec::new();
        if !facts.is_empty() {
            out.push(say("since "));
            signs::grouped(&facts, &mut out);
        }
        out
    }

    /// The equations that a step puts in, but for those that only give names.
    pub(in crate::explain) fn put_in(&self, seen: &Seen) -> Vec<Label> {
        seen.used.using.iter().filter(|label| !self.naming.contains(*label)).cloned().collect()
    }
}
