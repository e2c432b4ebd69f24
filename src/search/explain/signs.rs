//! Why a comparison holds by signs: its difference as a product, and the sign of each factor with the facts that it
//! comes from.

use super::document::{Block, Piece};
use super::follow::{Seen, difference};
use super::words::{Words, say};
use crate::certificate::Label;
use crate::claim::print::Style;
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, constraints, expr, name, numeral};
use crate::kernel::view::{Part, View};
use num_rational::BigRational;
use num_traits::One;

/// A polynomial of more letters is written as the difference that it comes from.
const LONG: usize = 30;
/// The common value of both sides is printed if it has at most this many characters.
const COMMON: usize = 60;

impl Words<'_> {
    /// A comparison that the sign of its difference shows.
    pub(super) fn by_signs(&self, seen: &Seen, out: &mut Vec<Block>) {
        let show = &seen.show;
        let (Some(view), Some((a, relation, b))) = (&seen.difference, show.prop.single()) else {
            self.hence("Entry by entry,", &show.prop, Some(&show.label), out);
            return;
        };
        let put_in = self.put_in(seen);
        if view.factors.is_empty() {
            return self.agree(seen, (a, b), &put_in, out);
        }
        let shown = self.written_out(view, seen);
        if matches!(relation, Relation::Equal | Relation::NotEqual) {
            return self.zero(seen, &shown, out);
        }
        let product = self.short.expr(&shown.expr());
        let whole = self.short.expr(&difference(a, b));
        let mut lead = vec![say("The factors of the difference of the sides determine its sign")];
        if !put_in.is_empty() {
            lead.push(say(", with "));
            lead.extend(self.cited_all(&put_in));
            lead.push(say(" substituted"));
        }
        lead.push(say(":"));
        let reasons = self.reasons(&shown, relation, &seen.used.by, Some(&show.label));
        let simple = Style::Text.expr(&product) == Style::Text.expr(&whole);
        let nearly =
            matches!(shown.factors.as_slice(), [one] if one.power == 1 && one.by.iter().all(|l| self.is_short(l)));
        if let ([one], [label]) = (shown.factors.as_slice(), shown.factors.first().map_or(&[][..], |p| &p.by))
            && one.power == 1
            && !self.is_short(label)
        {
            return self.formula(vec![self.cited(label), say(" comes to")], &show.prop, Some(&show.label), out);
        }
        if simple || nearly {
            let mut lead = vec![say("By ")];
            let since: Vec<Piece> = self.since(&seen.used.by).into_iter().skip(1).collect();
            if since.is_empty() {
                lead = vec![say("Clearly,")];
            } else {
                lead.extend(since);
                lead.push(say(","));
            }
            return self.formula(lead, &show.prop, Some(&show.label), out);
        }
        out.push(Block::Sentence(lead));
        let kind = PropKind::Compare(vec![whole, product, numeral(0)], vec![Relation::Equal, relation]);
        out.push(Block::Formula { label: None, prop: Prop { kind, span: show.prop.span }, number: None });
        if !reasons.is_empty() {
            out.push(Block::Sentence(reasons));
        }
        if *b != numeral(0) {
            self.hence("Hence", &show.prop, Some(&show.label), out);
        }
    }

    /// Both sides are equal when they are expanded.
    fn agree(&self, seen: &Seen, (a, b): (&Expr, &Expr), put_in: &[Label], out: &mut Vec<Block>) {
        let show = &seen.show;
        let mut lead = Vec::new();
        if put_in.is_empty() {
            let named = self.short.given() > 0;
            lead.push(say(if named { "In these names, both sides agree:" } else { "Written out, both sides agree:" }));
        } else {
            lead.push(say("With "));
            lead.extend(self.cited_all(put_in));
            lead.push(say(" substituted, both sides agree:"));
        }
        // The common value of both sides, if it is short and differs from both.
        let common = seen.common.as_ref().map(|view| self.short.expr(&view.expr()));
        let text = |e: &Expr| Style::Text.expr(e);
        let (left, right) = (self.short.expr(a), self.short.expr(b));
        match common.filter(|c| text(c).len() <= COMMON && text(c) != text(&left) && text(c) != text(&right)) {
            Some(common) => {
                let kind = PropKind::Compare(vec![left, common, right], vec![Relation::Equal; 2]);
                let prop = Prop { kind, span: show.prop.span };
                out.push(Block::Sentence(lead));
                out.push(Block::Formula { label: Some(show.label.clone()), prop, number: None });
            }
            None => self.formula(lead, &show.prop, Some(&show.label), out),
        }
    }

    /// An equation, or that something is not 0: one factor is known to be 0, or none is.
    fn zero(&self, seen: &Seen, view: &View, out: &mut Vec<Block>) {
        let show = &seen.show;
        let put_in = self.put_in(seen);
        let from: Vec<Label> = view.factors.iter().flat_map(|part| part.by.clone()).collect();
        let mut facts: Vec<Label> = from.into_iter().filter(|label| !self.is_short(label)).collect();
        facts.sort();
        facts.dedup();
        let mut lead = Vec::new();
        let product = |label: &Label| seen.known.iter().any(|(l, view)| l == label && view.factors.len() > 1);
        if facts.iter().any(product) && relation_shown(seen) == Some(Relation::Equal) {
            lead.push(say("A product is 0 only if one of its factors is. "));
        }
        if facts.is_empty() {
            lead.push(say("Since no factor of the difference is 0"));
        } else {
            lead.push(say("From "));
            lead.extend(self.cited_all(&facts));
        }
        if !put_in.is_empty() {
            lead.push(say(", with "));
            lead.extend(self.cited_all(&put_in));
            lead.push(say(" substituted"));
        }
        let since = self.since(&seen.used.by);
        if !since.is_empty() {
            lead.push(say(", "));
            lead.extend(since);
        }
        lead.push(say(", it follows that"));
        self.formula(lead, &show.prop, Some(&show.label), out);
    }

    /// A difference with those polynomials as products whose sign an earlier step reads from factors.
    ///
    /// A polynomial whose sign comes from a comparison is written as the difference of its sides, by what it is that
    /// times.
    fn written_out(&self, view: &View, seen: &Seen) -> View {
        let mut out = View { number: view.number.clone(), factors: Vec::new() };
        for part in &view.factors {
            let alone = |power: i64| View { number: BigRational::one(), factors: vec![Part { power, ..part.clone() }] };
            // P = product/c where the difference that it shows is c·P.
            let product = seen.products.iter().filter(|p| self.products.contains(&p.0)).find_map(|(label, product)| {
                let of = |k: &&(Label, View)| {
                    k.0 == *label && matches!(k.1.factors.as_slice(), [one] if one.of == part.of && one.power == 1)
                };
                let known = seen.known.iter().find(of)?;
                Some(View { number: &product.number / &known.1.number, factors: product.factors.clone() })
            });
            if let Some(product) = product {
                out = out.times(&product, part.power);
                continue;
            }
            let from = part.by.iter().filter(|label| !self.is_short(label));
            let is_in = |view: &View| view.factors.iter().any(|p| p.of == part.of && p.power == 1);
            let of = |label: &Label| seen.known.iter().filter(|k| k.0 == *label && is_in(&k.1)).collect::<Vec<_>>();
            let known: Vec<_> = from.flat_map(of).collect();
            let strict = |k: &&&(Label, View)| {
                let relation = self.followed.facts.get(&k.0).and_then(Prop::single).map(|s| s.1);
                !matches!(relation, Some(Relation::LessEqual | Relation::GreaterEqual))
            };
            let known = known.iter().find(strict).or(known.first()).copied();
            let sides = known.and_then(|(label, known)| Some((label, known, self.followed.facts.get(label)?)));
            match sides.and_then(|(label, known, fact)| Some((label, known, fact.single()?))) {
                Some((label, known, (a, relation, b))) if Style::Text.expr(&part.of).len() > LONG => {
                    // P = (a − b)/(the rest of a − b).
                    let rest = known.clone().times(&alone(1), -1);
                    let of = self.short.expr(&difference(a, b));
                    let whole = Part { of, power: 1, signs: Signs::of(relation), by: vec![label.clone()] };
                    let whole = View { number: BigRational::one(), factors: vec![whole] };
                    out = out.times(&whole, part.power).times(&rest, -part.power);
                }
                _ => out = out.times(&alone(part.power), 1),
            }
        }
        out
    }

    /// The reasons for the sign of a product: `(x − y)^2 ≥ 0 as a square; … > 0 by (3); the other factors …`
    pub(super) fn reasons(&self, view: &View, relation: Relation, by: &[Label], own: Option<&Label>) -> Vec<Piece> {
        let mut out = Vec::new();
        let mut since: Vec<Label> = view.factors.iter().flat_map(|part| part.by.clone()).collect();
        since.extend(by.iter().cloned());
        let mut kept: Vec<Label> = Vec::new();
        for label in since {
            if !kept.contains(&label) && own != Some(&label) {
                kept.push(label);
            }
        }
        let weak = matches!(relation, Relation::LessEqual | Relation::GreaterEqual);
        let square = |part: &Part| part.power % 2 == 0 && !part.signs.within(Signs::POSITIVE);
        let squares: Vec<Expr> = view.factors.iter().filter(|part| weak && square(part)).map(squared).collect();
        if !squares.is_empty() {
            let single = squares.len() == 1;
            let squares: Vec<(Expr, Relation)> =
                squares.iter().map(|e| (self.short.expr(e), Relation::GreaterEqual)).collect();
            listed(&squares, &mut out);
            out.push(say(if single { " as a square" } else { " as squares" }));
        }
        for part in &view.factors {
            let said = |label: &&Label| !self.is_short(label) && !self.products.contains(*label);
            let facts: Vec<Label> = part.by.iter().filter(said).cloned().collect();
            if facts.is_empty() || weak && square(part) {
                continue;
            }
            let Some(sign) = part.signs.relation() else { continue };
            if !out.is_empty() {
                out.push(say("; "));
            }
            let prop = self.short.prop(&compare(part.of.clone(), sign, numeral(0)));
            if Style::Text.prop(&prop).len() <= COMMON {
                out.push(Piece::Prop(prop));
                out.push(say(" by "));
            } else {
                out.push(say(if out.is_empty() { "The" } else { "the" }));
                out.push(say(" longest factor has its sign by "));
            }
            out.extend(self.cited_all(&facts));
        }
        let list = self.since(&kept);
        if !list.is_empty() {
            let rest = list.into_iter().skip(1);
            if out.is_empty() {
                out.push(say("The factors have their signs because "));
            } else {
                out.push(say("; the other factors have their signs because "));
            }
            out.extend(rest);
        }
        if !out.is_empty() {
            out.push(say("."));
        }
        out
    }
}

/// An even power in a product, in the numerator or in the denominator.
fn squared(part: &Part) -> Expr {
    let power = expr(ExprKind::Number(part.power.unsigned_abs().to_string()));
    expr(ExprKind::Power(Box::new(part.of.clone()), Box::new(power)))
}

/// The relation that a step shows.
fn relation_shown(seen: &Seen) -> Option<Relation> {
    seen.show.prop.single().map(|s| s.1)
}

/// `r₁, r₂ > 0`, with their common relation to 0.
pub(super) fn listed(names: &[(Expr, Relation)], out: &mut Vec<Piece>) {
    let facts: Vec<(Expr, Relation, Expr)> = names.iter().map(|(e, r)| (e.clone(), *r, numeral(0))).collect();
    grouped(&facts, out);
}

/// `m₁, m₂ > 0 and e ≥ 0`.
pub(super) fn grouped(facts: &[(Expr, Relation, Expr)], out: &mut Vec<Piece>) {
    let mut groups: Vec<(Relation, &Expr, Vec<&Expr>)> = Vec::new();
    for (e, relation, bound) in facts {
        match groups.iter_mut().find(|g| g.0 == *relation && g.1 == bound) {
            Some(group) if group.2.contains(&e) => {}
            Some(group) => group.2.push(e),
            None => groups.push((*relation, bound, vec![e])),
        }
    }
    let count = groups.len();
    for (place, (relation, bound, list)) in groups.into_iter().enumerate() {
        if place > 0 {
            out.push(say(if place + 1 == count { " and " } else { ", " }));
        }
        let Some((last, before)) = list.split_last() else { continue };
        for e in before {
            out.push(Piece::Expr((*e).clone()));
            out.push(say(", "));
        }
        out.push(Piece::Prop(compare((*last).clone(), relation, bound.clone())));
    }
}

/// `x > 0`, `a natural number n ≥ 1`.
pub(super) fn bound(binding: &Binding, out: &mut Vec<Piece>) {
    if binding.natural {
        out.push(say(if binding.names.len() == 1 { "the natural number " } else { "the natural numbers " }));
    }
    for (place, (variable, _)) in binding.names.iter().enumerate() {
        if place > 0 {
            out.push(say(", "));
        }
        let props = constraints(binding, &name(&variable.text));
        if props.is_empty() {
            out.push(Piece::Expr(name(&variable.text)));
        }
        for (place, prop) in props.into_iter().enumerate() {
            if place > 0 {
                out.push(say(", "));
            }
            out.push(Piece::Prop(prop));
        }
    }
}
