//! The words for each rule, and the choice of steps that deserve a sentence.

mod ahead;
mod citation;
mod combination;

use super::document::{Block, Piece};
use super::follow::{Followed, Node, Seen};
use super::shorthand::Shorthand;
use super::signs;
use crate::certificate::{Label, Rule};
use crate::claim::print::{self, Style};
use crate::claim::syntax::*;
use crate::claim::walk::parts;
use crate::kernel::statement::{compare, name, numeral};
use std::collections::{BTreeMap, BTreeSet};

/// A supposition of at most this many characters is written inside its sentence.
const SENTENCE: usize = 48;

/// The sentences of a proof.
pub(super) struct Words<'a> {
    pub(super) followed: &'a Followed,
    pub(super) short: Shorthand,
    /// The names of the hypotheses.
    hypotheses: BTreeMap<Label, String>,
    /// False facts, which follow from contradictory suppositions.
    absurd: BTreeSet<Label>,
    /// Equations that only introduce names, or rewrite something with these names.
    naming: BTreeSet<Label>,
    /// Comparisons proved by a product and used only for a sign: the product is stated where the sign is needed.
    pub(super) products: BTreeSet<Label>,
    /// Facts that repeat another one, which is cited instead.
    same: BTreeMap<Label, Label>,
    /// The open suppositions, from the outermost to the innermost.
    open: Vec<Prop>,
    /// The suppositions that are the second direction of an equivalence.
    converse: BTreeSet<Label>,
    /// The suppositions that are cases.
    cases: BTreeSet<Label>,
}

/// A sentence out of words.
pub(super) fn say(text: &str) -> Piece {
    Piece::Text(text.to_string())
}

impl<'a> Words<'a> {
    pub(super) fn of(claim: &Claim, followed: &'a Followed) -> Words<'a> {
        let named = claim.items.iter().filter_map(|item| match item {
            Item::Assume { label, .. } => Some(label.as_ref().map(|l| l.text.clone())),
            _ => None,
        });
        let named: Vec<Option<String>> = named.collect();
        // The assumptions come behind the domains.
        let first = followed.facts.keys().filter_map(|l| l.strip_prefix('h')?.parse::<usize>().ok()).max().unwrap_or(0);
        let start = first.saturating_sub(named.len());
        let hypotheses = named
            .into_iter()
            .enumerate()
            .filter_map(|(k, label)| Some((format!("h{}", start + k + 1), label?)))
            .collect();
        let mut words = Words {
            followed,
            short: Shorthand::of(claim),
            hypotheses,
            absurd: BTreeSet::new(),
            naming: BTreeSet::new(),
            products: BTreeSet::new(),
            same: BTreeMap::new(),
            open: Vec::new(),
            converse: BTreeSet::new(),
            cases: BTreeSet::new(),
        };
        words.look_ahead();
        words
    }

    /// The whole proof.
    pub(super) fn all(mut self) -> Vec<Block> {
        let followed = self.followed;
        let mut out = Vec::new();
        self.nodes(&followed.nodes, &mut out);
        let closing = match followed.seen.last().map(|seen| &seen.show.rule) {
            Some(Rule::Logic { .. }) => "This proves every part of the claim.",
            _ => "This is the claim.",
        };
        out.push(Block::Sentence(vec![say(closing)]));
        out
    }

    fn nodes(&mut self, nodes: &[Node], out: &mut Vec<Block>) {
        let given = self.short.given();
        let mut rest = nodes;
        while let Some(node) = rest.first() {
            let names = self.names(rest, out);
            if names > 0 {
                rest = rest.get(names..).unwrap_or_default();
                continue;
            }
            match node {
                Node::Step(place) => self.step(&self.followed.seen[*place], out),
                Node::Block(place, inner, conclusion) => self.block(*place, inner, conclusion, out),
            }
            rest = rest.get(1..).unwrap_or_default();
        }
        self.short.back_to(given);
    }

    /// Words for consecutive steps that introduce names, with facts about the names. Returns the number of these steps.
    fn names(&mut self, nodes: &[Node], out: &mut Vec<Block>) -> usize {
        let (mut given, mut positive, mut written) = (Vec::new(), Vec::new(), Vec::new());
        let mut count = 0;
        for node in nodes {
            let Node::Step(place) = node else { break };
            let show = &self.followed.seen[*place].show;
            let Some((a, relation, b)) = show.prop.single() else { break };
            match (&show.rule, &a.kind, &b.kind) {
                (Rule::Name, _, ExprKind::Name(new)) => {
                    given.push(compare(b.clone(), Relation::Equal, self.short.expr(a)));
                    self.short.give(new, a);
                }
                (Rule::Combination { .. }, ExprKind::Name(r), _) if self.short.is_given(r) && *b == numeral(0) => {
                    positive.push((a.clone(), relation));
                }
                (Rule::Power, _, _) if self.naming.contains(&show.label) && !given.is_empty() => {
                    written.push(self.short.prop(&show.prop));
                }
                _ => break,
            }
            count += 1;
        }
        if given.is_empty() {
            return 0;
        }
        out.push(Block::Sentence(vec![say("Write")]));
        out.extend(given.into_iter().map(|prop| Block::Formula { label: None, prop, number: None }));
        let mut sentence = Vec::new();
        if !positive.is_empty() {
            signs::listed(&positive, &mut sentence);
            let one = positive.len() == 1;
            sentence.push(say(if one {
                ", as a power of a positive number."
            } else {
                ", as powers of positive numbers."
            }));
            let above = positive.iter().all(|p| p.1 == Relation::Greater);
            if !above {
                sentence.pop();
                sentence.push(say("."));
            }
        }
        if !written.is_empty() {
            if !sentence.is_empty() {
                sentence.push(say(" "));
            }
            sentence.push(say("Then"));
            out.push(Block::Sentence(sentence));
            out.extend(written.into_iter().map(|prop| Block::Formula { label: None, prop, number: None }));
        } else if !sentence.is_empty() {
            out.push(Block::Sentence(sentence));
        }
        count
    }

    fn block(&mut self, place: usize, inner: &[Node], conclusion: &Label, out: &mut Vec<Block>) {
        if self.is_plain(inner) {
            return;
        }
        let show = &self.followed.seen[place].show;
        let mut blocks = Vec::new();
        let is_absurd = self.absurd.contains(conclusion);
        if let PropKind::Implies(condition, _) = &show.prop.kind {
            // A condition that is already supposed needs no case, and one that contradicts a supposition makes none.
            let text = print::prop(condition);
            if self.open.iter().any(|p| print::prop(p) == text) {
                return self.nodes(inner, out);
            }
            if self.cases.contains(&show.label) && self.open.iter().any(|p| contradict(p, condition)) {
                return;
            }
        }
        let last = match &show.prop.kind {
            PropKind::Implies(condition, goal) => {
                let lead = match (self.cases.contains(&show.label), self.converse.contains(&show.label)) {
                    (_, true) => "Conversely, suppose that",
                    (true, _) => "Consider the case",
                    _ => "Suppose that",
                };
                self.open.push((**condition).clone());
                self.introduced(lead, condition, &format!("{}s", show.label), out);
                (**goal).clone()
            }
            PropKind::ForAll(bindings, goal) => {
                let mut sentence = vec![say("Let ")];
                for (place, binding) in bindings.iter().enumerate() {
                    if place > 0 {
                        sentence.push(say(", and "));
                    }
                    signs::bound(binding, &mut sentence);
                }
                sentence.push(say(" be arbitrary."));
                out.push(Block::Sentence(sentence));
                (**goal).clone()
            }
            _ => show.prop.clone(),
        };
        let depth = self.open.len();
        self.nodes(inner, &mut blocks);
        if matches!(show.prop.kind, PropKind::Implies(..)) {
            self.open.truncate(depth.saturating_sub(1));
        }
        if is_absurd {
            blocks.push(Block::Sentence(vec![say("So this case does not occur.")]));
        } else if let Some(Block::Sentence(_)) | None = blocks.last() {
            self.hence("So", &last, None, &mut blocks);
        }
        out.push(Block::Inner(blocks));
    }

    /// A supposition.
    fn introduced(&self, lead: &str, condition: &Prop, label: &str, out: &mut Vec<Block>) {
        let prop = self.short.prop(condition);
        if Style::Text.prop(&prop).len() <= SENTENCE {
            out.push(Block::Sentence(vec![say(lead), say(" "), Piece::Prop(prop), say(".")]));
            return;
        }
        out.push(Block::Sentence(vec![say(lead)]));
        out.push(Block::Formula { label: Some(label.to_string()), prop, number: None });
    }

    /// Whether a block is obvious to a reader.
    fn is_plain(&self, inner: &[Node]) -> bool {
        inner.iter().all(|node| match node {
            Node::Step(place) => matches!(self.followed.seen[*place].show.rule, Rule::Logic { .. }),
            Node::Block(_, inner, _) => self.is_plain(inner),
        })
    }

    /// A proved formula with words before it.
    pub(super) fn hence(&self, lead: &str, prop: &Prop, label: Option<&Label>, out: &mut Vec<Block>) {
        self.formula(vec![say(lead)], prop, label, out);
    }

    pub(super) fn formula(&self, lead: Vec<Piece>, prop: &Prop, label: Option<&Label>, out: &mut Vec<Block>) {
        let prop = self.short.prop(prop);
        if let Some(Block::Formula { prop: before, .. }) = out.last()
            && print::prop(before) == print::prop(&prop)
        {
            return;
        }
        out.push(Block::Sentence(lead));
        out.push(Block::Formula { label: label.cloned(), prop, number: None });
    }

    fn step(&mut self, seen: &Seen, out: &mut Vec<Block>) {
        let show = &seen.show;
        let (prop, label) = (&show.prop, Some(&show.label));
        let fact = |label: &Label| self.cited(label);
        let lead = match &show.rule {
            Rule::Suppose | Rule::Let => return,
            Rule::Combination { .. } => return self.combination(seen, out),
            Rule::Logic { from } => return self.logic(seen, from, out),
            Rule::Name => return,
            Rule::Power => vec![say("By the rules for powers,")],
            Rule::Instance { source, with, .. } => {
                let mut lead = vec![say("By ")];
                lead.push(match self.followed.facts.get(source) {
                    Some(_) => fact(source),
                    None => Piece::Text(source.clone()),
                });
                self.values(with, &mut lead);
                lead.push(say(","));
                lead
            }
            Rule::Induction { base, advance } => {
                vec![
                    fact(base),
                    say(" is the base case of an induction, and "),
                    fact(advance),
                    say(" is its step. Hence"),
                ]
            }
            Rule::Existence { some, .. } => {
                vec![
                    say("There are such values by "),
                    fact(some),
                    say(", and the conclusion does not speak of them. Hence"),
                ]
            }
            Rule::Witness { with, .. } => {
                let mut lead = vec![say("Such values exist:")];
                self.values(with, &mut lead);
                lead.push(say(", all conditions are satisfied. Hence"));
                lead
            }
            Rule::Extremum { from } => return self.extremum(prop, from, label, out),
            Rule::Monotone { from } => self.raised(prop, from),
            Rule::Unfold => vec![say("By definition,")],
            Rule::Termwise { from } => vec![say("Combining "), fact(from), say(" for all indices,")],
            Rule::Mean { with } => {
                let mut lead = vec![say("The weighted inequality between geometric and arithmetic mean says,")];
                self.values(with, &mut lead);
                lead.push(say(","));
                lead
            }
            Rule::Tangent { with } => {
                let mut lead = vec![say("The exponential function lies above its tangent at 0;")];
                self.values(with, &mut lead);
                lead.push(say(":"));
                lead
            }
            Rule::Circle { with } => {
                let mut lead = vec![say("It is known of cosine and sine,")];
                self.values(with, &mut lead);
                lead.push(say(":"));
                lead
            }
            Rule::Arc => vec![say("By the inverse functions of sine and tangent:")],
            Rule::Intermediate { with, from } => {
                let mut lead = vec![say("The intermediate value theorem applies, with the sides at both ends from ")];
                for (place, label) in from.iter().take(2).enumerate() {
                    lead.extend([fact(label), say(if place == 0 { " and " } else { "." })]);
                }
                lead.push(say(" Applied"));
                self.values(with, &mut lead);
                lead.push(say(":"));
                lead
            }
            Rule::Slope { source, with, .. } => {
                let integrates = matches!(&show.prop.kind, PropKind::Compare(sides, _)
                    if sides.last().is_some_and(|e| matches!(e.kind, ExprKind::IntegralOver(..))));
                let mut lead = match integrates {
                    true => vec![
                        say("An integral is the difference of an antiderivative's values, by "),
                        fact(source),
                        say("."),
                    ],
                    false => vec![
                        say("The mean value theorem applies, with the sign of the derivative from "),
                        fact(source),
                        say("."),
                    ],
                };
                if !with.is_empty() {
                    lead.push(say(" Applied"));
                    self.values(with, &mut lead);
                    lead.push(say(", it gives"));
                }
                lead
            }
            Rule::Limit { .. } => vec![say(if limit_with_roots(prop) {
                "Numerator and denominator are sums of powers of the variable that grows; the terms of highest degree give"
            } else {
                "Numerator and denominator are polynomials in the variable that grows; the terms of highest degree give"
            })],
            Rule::Squeeze { from } => {
                let mut lead = vec![say("By ")];
                lead.extend(self.cited_all(from));
                lead.push(say(", the expression lies between two others with the same limit. Hence"));
                lead
            }
            Rule::Along { from } => {
                vec![
                    say("The exponential grows without bound and takes every positive value, so by "),
                    fact(from),
                    say(","),
                ]
            }
            Rule::Eventually { from } => {
                vec![say("The values are near their limit from some number on, so by "), fact(from), say(",")]
            }
            Rule::Evaluate => vec![say("By arithmetic,")],
            Rule::Integer { from } => vec![say("Both sides of "), fact(from), say(" are whole numbers, so")],
        };
        self.formula(lead, prop, label, out);
    }

    /// ` with a = …, b = …`
    fn values(&self, with: &[(Name, Expr)], lead: &mut Vec<Piece>) {
        for (place, (variable, value)) in with.iter().enumerate() {
            lead.push(say(if place == 0 { " with " } else { ", " }));
            let prop = compare(name(&variable.text), Relation::Equal, self.short.expr(value));
            lead.push(Piece::Prop(prop));
        }
    }

    fn raised(&self, prop: &Prop, from: &Label) -> Vec<Piece> {
        let before = self.followed.facts.get(from).and_then(Prop::single);
        let exponent = match (prop.single(), before) {
            (Some((Expr { kind: ExprKind::Power(base, exponent), .. }, _, _)), Some((a, _, _))) if **base == *a => {
                Some(exponent)
            }
            _ => None,
        };
        match exponent {
            Some(exponent) => vec![
                say("Both sides of "),
                self.cited(from),
                say(" are not negative, so they may be raised to the power "),
                Piece::Expr(self.short.expr(exponent)),
                say(":"),
            ],
            None => vec![
                say("Positive powers keep the order of numbers that are not negative, so "),
                self.cited(from),
                say(" gives"),
            ],
        }
    }

    fn extremum(&self, prop: &Prop, from: &[Label], label: Option<&Label>, out: &mut Vec<Block>) {
        let only = matches!(&prop.kind, PropKind::Extremum(x) if x.unique) && from.len() > 1;
        let lead = match only {
            true => "No value is better, and this one is attained only at the stated point. Hence",
            false => "No value is better, and this one is attained at the stated point. Hence",
        };
        self.formula(vec![say(lead)], prop, label, out);
    }

    fn logic(&self, seen: &Seen, from: &[Label], out: &mut Vec<Block>) {
        let (show, facts) = (&seen.show, &self.followed.facts);
        if from.is_empty() || self.absurd.contains(&show.label) {
            return;
        }
        let kind = |label: &Label| facts.get(label).map(|p| &p.kind);
        let by_cases = from.iter().any(|l| matches!(kind(l), Some(PropKind::Or(_))));
        // A part of a fact, or parts joined together, need no words.
        let single = from.len() == 1 && !matches!(kind(&from[0]), Some(PropKind::Implies(..)));
        if single || matches!(show.prop.kind, PropKind::And(_)) && !by_cases {
            return;
        }
        let lead = match &show.prop.kind {
            _ if by_cases => vec![say("This covers all cases, so")],
            PropKind::Equivalent(_) => vec![say("Both directions together prove")],
            _ => {
                let mut lead = vec![say("By ")];
                lead.extend(self.cited_all(from));
                lead.push(say(","));
                lead
            }
        };
        self.formula(lead, &show.prop, Some(&show.label), out);
    }
}

/// Whether two propositions are an equation and its negation.
fn contradict(p: &Prop, q: &Prop) -> bool {
    let (Some((a, r, b)), Some((c, s, d))) = (p.single(), q.single()) else { return false };
    a == c && b == d && matches!((r, s), (Relation::Equal, Relation::NotEqual) | (Relation::NotEqual, Relation::Equal))
}

/// Whether a limit has roots of the variable that grows.
fn limit_with_roots(p: &Prop) -> bool {
    match &p.kind {
        PropKind::Limit(limit) => has_root_of(&limit.of, &limit.variable.text),
        PropKind::Not(inner) => limit_with_roots(inner),
        _ => false,
    }
}

fn has_root_of(e: &Expr, x: &str) -> bool {
    let is_x = |e: &Expr| matches!(&e.kind, ExprKind::Name(n) if n == x);
    let is_whole = |e: &Expr| match &e.kind {
        ExprKind::Negate(a) => matches!(&a.kind, ExprKind::Number(text) if text.bytes().all(|b| b.is_ascii_digit())),
        kind => matches!(kind, ExprKind::Number(text) if text.bytes().all(|b| b.is_ascii_digit())),
    };
    let own = match &e.kind {
        ExprKind::Power(base, exponent) => is_x(base) && !is_whole(exponent),
        ExprKind::Apply(f, list) => matches!(f.text.as_str(), "sqrt" | "cbrt") && list.iter().any(is_x),
        _ => false,
    };
    let mut found = own;
    parts(e, &mut |part| found |= has_root_of(part, x));
    found
}
