//! Words for a combination: facts multiplied by factors and added, a contradiction, or a product with a sign.

use super::{Words, say};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::explain::document::{Block, Piece};
use crate::explain::follow::{Seen, difference};
use crate::kernel::statement::{expr, numeral, product};

/// The end of a sentence that states a contradiction.
const CONTRADICTION: &str = ", which is impossible.";

impl Words<'_> {
    pub(super) fn combination(&self, seen: &Seen, out: &mut Vec<Block>) {
        let show = &seen.show;
        let Rule::Combination { times, terms } = &show.rule else { return };
        let facts: Vec<Label> = terms.iter().flat_map(|t| t.facts.clone()).collect();
        if self.absurd.contains(&show.label) {
            return self.contradiction(seen, &facts, out);
        }
        if self.same.contains_key(&show.label) {
            return;
        }
        if terms.is_empty() {
            return self.by_signs(seen, out);
        }
        if facts.is_empty() {
            // A product that shows a sign is stated where it is needed.
            if !self.products.contains(&show.label) {
                self.by_product(seen, out);
            }
            return;
        }
        let put_in = self.put_in(seen);
        let lead = match terms.as_slice() {
            [term] if times.is_none() && put_in.is_empty() && is_unit(&term.factor) && is_zero_goal(&show.prop) => {
                let mut lead = vec![say("Bring everything in ")];
                lead.extend(self.cited_all(&term.facts));
                lead.push(say(" to one side and factor:"));
                lead
            }
            [term] if times.is_none() => self.multiplied(term, &put_in),
            _ => self.added(seen, terms, &put_in),
        };
        self.formula(lead, &show.prop, Some(&show.label), out);
    }

    /// A contradiction: some facts together imply something false.
    fn contradiction(&self, seen: &Seen, facts: &[Label], out: &mut Vec<Block>) {
        if facts.iter().any(|label| self.absurd.contains(label)) {
            return;
        }
        let is_said = |last: &[Piece]| matches!(last.last(), Some(Piece::Text(text)) if text.as_str() == CONTRADICTION);
        if matches!(out.last(), Some(Block::Sentence(last)) if is_said(last)) {
            return;
        }
        let put_in = self.put_in(seen);
        // Facts that give the factors their signs are a part of it.
        let mut all: Vec<Label> = Vec::new();
        let signs = seen.used.by.iter().filter(|label| !put_in.contains(label) && !self.absurd.contains(*label));
        for label in facts.iter().chain(signs) {
            // Parts of one fact are cited once.
            let said = |label: &Label| format!("{:?}", self.cited(label));
            if !all.iter().any(|known| known == label || said(known) == said(label)) {
                all.push(label.clone());
            }
        }
        let mut lead = Vec::new();
        if !put_in.is_empty() {
            lead.push(say("But with "));
            lead.extend(self.cited_all(&put_in));
            lead.push(say(" substituted, "));
        } else if all.len() <= 1 {
            lead.push(say("But "));
        }
        lead.extend(self.cited_all(&all));
        if all.len() > 1 {
            lead.push(say(" contradict each other"));
        } else {
            lead.push(say(" becomes "));
            lead.push(Piece::Prop(seen.show.prop.clone()));
        }
        lead.push(say(CONTRADICTION));
        out.push(Block::Sentence(lead));
    }

    /// One product of facts, multiplied by a factor.
    fn multiplied(&self, term: &Term, put_in: &[Label]) -> Vec<Piece> {
        let mut lead = vec![say("From ")];
        lead.extend(self.cited_all(&term.facts));
        if !put_in.is_empty() {
            lead.push(say(", with "));
            lead.extend(self.cited_all(put_in));
            lead.push(say(" substituted,"));
        }
        let factor = self.short.expr(&term.factor);
        let plain = matches!(&factor.kind, ExprKind::Number(_))
            || matches!(&factor.kind, ExprKind::Negate(a) if matches!(a.kind, ExprKind::Number(_)));
        if plain {
            lead.push(say(" it follows that"));
        } else {
            lead.push(say(if put_in.is_empty() { ", multiplied by " } else { " multiplied by " }));
            lead.push(Piece::Expr(factor));
            lead.push(say(", it follows that"));
        }
        lead
    }

    /// Several products of facts, each multiplied by its factor, and added.
    fn added(&self, seen: &Seen, terms: &[Term], put_in: &[Label]) -> Vec<Piece> {
        let mut lead = vec![say("Multiply ")];
        for (place, term) in terms.iter().filter(|t| !t.facts.is_empty()).enumerate() {
            if place > 0 {
                lead.push(say(", "));
            }
            for (place, label) in term.facts.iter().enumerate() {
                if place > 0 {
                    lead.push(say(" times "));
                }
                lead.push(self.cited(label));
            }
            lead.push(say(" by "));
            lead.push(Piece::Expr(self.short.expr(&term.factor)));
        }
        lead.push(say(" and add"));
        let alone = terms.iter().filter(|t| t.facts.is_empty()).map(|t| &t.factor);
        for (place, factor) in alone.enumerate() {
            lead.push(say(if place == 0 { " " } else { " and " }));
            lead.push(Piece::Expr(self.short.expr(factor)));
        }
        if !put_in.is_empty() {
            lead.push(say(", with "));
            lead.extend(self.cited_all(put_in));
            lead.push(say(" substituted"));
        }
        if !matches!(seen.show.prop.single(), Some((_, Relation::Equal, _))) {
            let since = self.since(&seen.used.by);
            if !since.is_empty() {
                lead.push(say("; the factors have the right signs "));
                lead.extend(since);
            }
        }
        lead.push(say(". This gives"));
        lead
    }

    /// A comparison whose difference is a sum of expressions with plain signs.
    fn by_product(&self, seen: &Seen, out: &mut Vec<Block>) {
        let show = &seen.show;
        let (Rule::Combination { times, terms }, Some((a, relation, b))) = (&show.rule, show.prop.single()) else {
            return;
        };
        let summed: Vec<(Sign, Expr)> = terms.iter().map(|t| (Sign::Plus, self.short.expr(&t.factor))).collect();
        let sum = match summed.as_slice() {
            [(_, one)] => one.clone(),
            _ => expr(ExprKind::Sum(summed)),
        };
        self.hence("We have", &show.prop, Some(&show.label), out);
        let apart = difference(a, b);
        let whole = match times {
            // The multiplier is not 0, and positive where the sum has the sign of the relation.
            Some(times) => product(vec![times.clone(), apart]),
            None => apart,
        };
        let whole = self.short.expr(&whole);
        let prop = Prop {
            kind: PropKind::Compare(vec![whole, sum, numeral(0)], vec![Relation::Equal, relation]),
            span: show.prop.span,
        };
        out.push(Block::Sentence(vec![say("because")]));
        out.push(Block::Formula { label: None, prop, number: None });
        if let Some(view) = seen.terms.first().and_then(|v| v.as_ref()).filter(|_| terms.len() == 1) {
            let reasons = self.reasons(view, relation, &seen.used.by, None);
            if !reasons.is_empty() {
                out.push(Block::Sentence(reasons));
            }
            return;
        }
        let since = self.since(&seen.used.by);
        if !since.is_empty() {
            let mut sentence = vec![say("Each summand has this sign, ")];
            sentence.extend(since);
            sentence.push(say("."));
            out.push(Block::Sentence(sentence));
        }
    }
}

/// Whether a factor is 1 or −1.
fn is_unit(e: &Expr) -> bool {
    let one = |e: &Expr| matches!(&e.kind, ExprKind::Number(text) if text == "1");
    one(e) || matches!(&e.kind, ExprKind::Negate(inner) if one(inner))
}

/// Whether a comparison is one with 0.
fn is_zero_goal(p: &Prop) -> bool {
    p.single().is_some_and(|(_, _, b)| *b == numeral(0))
}
