//! Angles at multiples of π, where sines and cosines are exact: there equations of angles hold, and chance finds none of these.
//!
//! Contract: a cosine and sine are exact. What is taken for an angle costs points and nothing else: at a point
//! every hypothesis is evaluated in the claim's own words.

use super::evaluate::Assignment;
use super::number::Number;
use super::search::Search;
use super::solve::Way;
use crate::claim::circle::Point;
use crate::claim::syntax::*;
use crate::claim::walk::parts;
use crate::kernel::statement::{name, product};
use malachite::Rational;
use num_rational::BigRational;
use std::collections::BTreeSet;
use std::ops::Range;

/// The most terms of a sum that are looked at.
const TERMS: usize = 32;

/// The cosine and sine of so many times π, where that is a multiple of π/120: their value in square roots.
pub(super) fn cosine_and_sine_of(turns: &Rational) -> Option<(Number, Number)> {
    let whole = |k: &malachite::Natural| k.to_string().parse().ok();
    let size = BigRational::new(whole(turns.numerator_ref())?, whole(turns.denominator_ref())?);
    let point = Point::of_turns(&if *turns < 0 { -size } else { size })?;
    let here = Assignment::default();
    let value = |e: Expr| here.number(&e).ok();
    Some((value(point.cosine(Span::default()))?, value(point.sine(Span::default()))?))
}

/// The variables that are angles: one of each summand under a sine or cosine, unless π or another angle stands in it, and what is added
/// to an angle alone or compared with one. None where `pi` is no number.
pub(super) fn angles(search: &Search, goal: Option<&Prop>) -> BTreeSet<String> {
    let mut found = Angles { real: search.real().into_iter().collect(), found: BTreeSet::new() };
    if !search.base.is_pi {
        return found.found;
    }
    let said: Vec<&Prop> = search.hypotheses.iter().chain(goal).collect();
    said.iter().for_each(|p| exprs(p, &mut |sides| sides.iter().for_each(|e| found.under(e))));
    if found.found.is_empty() {
        return found.found;
    }
    loop {
        let before = found.found.len();
        said.iter().for_each(|p| exprs(p, &mut |sides| found.beside(sides.iter())));
        for (name, value) in search.ways().flatten() {
            found.beside([&self::name(name), value].into_iter());
        }
        if found.found.len() == before {
            return found.found;
        }
    }
}

/// The ways of these paths on which the angles that are free are multiples of π.
pub(super) fn ways(search: &Search, paths: Range<usize>, angles: &BTreeSet<String>) -> Vec<Way> {
    let turned = |way: &Way| -> Way {
        let free = angles.iter().filter(|angle| way.iter().all(|(computed, _)| computed != *angle));
        let turns = free.map(|angle| (angle.clone(), product(vec![name(angle), name(PI)])));
        turns.chain(way.iter().cloned()).collect()
    };
    if angles.is_empty() { Vec::new() } else { search.ways().take(paths.end).skip(paths.start).map(turned).collect() }
}

struct Angles {
    real: BTreeSet<String>,
    found: BTreeSet<String>,
}

impl Angles {
    /// Chooses an angle of each summand under a sine or cosine in an expression: the variable that stands last.
    fn under(&mut self, e: &Expr) {
        if let ExprKind::Apply(f, list) = &e.kind
            && matches!(f.text.as_str(), "cos" | "sin")
        {
            for summand in list.iter().filter_map(summands).flatten() {
                if summand.iter().all(|n| n != PI && !self.found.contains(n)) {
                    let last = summand.into_iter().rev().find(|n| self.real.contains(n));
                    self.found.extend(last);
                }
            }
        }
        parts(e, &mut |part| self.under(part));
    }

    /// Takes variables that stand alone in sums for angles where one of them is.
    fn beside<'e>(&mut self, sides: impl Iterator<Item = &'e Expr>) {
        let all: Vec<Vec<String>> = sides.filter_map(summands).flatten().collect();
        let alone: Vec<&String> = all.iter().filter(|s| s.len() == 1).flatten().collect();
        if alone.iter().any(|n| self.found.contains(*n)) {
            let real = alone.into_iter().filter(|n| self.real.contains(*n));
            self.found.extend(real.cloned().collect::<Vec<_>>());
        }
    }
}

/// The names in the numerators of the summands of an expression, products of sums multiplied out; `None` of too many.
fn summands(e: &Expr) -> Option<Vec<Vec<String>>> {
    Some(match &e.kind {
        ExprKind::Name(name) => vec![vec![name.clone()]],
        ExprKind::Negate(a) => summands(a)?,
        ExprKind::Sum(list) => list.iter().map(|(_, part)| summands(part)).collect::<Option<Vec<_>>>()?.concat(),
        ExprKind::Product(list) => {
            let mut out = vec![Vec::new()];
            for (_, factor) in list.iter().filter(|(factor, _)| *factor == Factor::Times) {
                let more = summands(factor)?;
                if out.len() * more.len() > TERMS {
                    return None;
                }
                out = out.iter().flat_map(|a| more.iter().map(move |b| [a.as_slice(), b].concat())).collect();
            }
            out
        }
        _ => vec![Vec::new()],
    })
    .filter(|list| list.len() <= TERMS)
}

/// Hears of the sides of each comparison in a proposition.
fn exprs(p: &Prop, hear: &mut dyn FnMut(&[Expr])) {
    match &p.kind {
        PropKind::Compare(sides, _) => hear(sides),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| exprs(p, hear));
        }
        PropKind::Not(p) | PropKind::Exists(_, p) | PropKind::ForAll(_, p) => exprs(p, hear),
        PropKind::Implies(p, q) => [p, q].into_iter().for_each(|p| exprs(p, hear)),
        PropKind::Extremum(_) | PropKind::Limit(_) | PropKind::WrittenLimit(_) => {}
    }
}
