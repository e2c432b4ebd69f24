//! Edges: equations at which a claim may fail although it holds all around.
//!
//! They are, in this order: zeros of what the goal divides by, takes the logarithm of, or raises to a power that is no whole
//! number; what stands under a root, at 0 and just below; sides that the goal compares, where they are equal; and the ends of
//! domains and hypotheses, where these belong to them. Points of an edge are computed, since chance does not meet them.

use super::literal::literal;
use crate::claim::definedness::{Need, needs, number};
use crate::claim::print;
use crate::claim::syntax::*;
use crate::claim::walk::{names_in, parts};
use crate::kernel::statement::Sequence;
use crate::kernel::statement::{compare, numeral};
use crate::kernel::substitution::Substitution;
use malachite::Rational;
use std::collections::BTreeSet;

/// The most edges of a claim.
const MOST: usize = 24;

/// How far below 0 what stands under a root is tried.
const BELOW: (i64, i64) = (-1, 1000);

/// The edges of a goal under hypotheses. `whole` says of a name whether it stands for whole numbers.
pub(super) fn edges(
    goal: &Prop,
    hypotheses: &[Prop],
    sequences: &[Sequence],
    whole: &dyn Fn(&str) -> bool,
) -> Vec<Prop> {
    let mut edges = Edges::of(goal, whole);
    for sequence in sequences {
        edges.expr(&sequence.initial);
        edges.at_the_first(&sequence.index, &numeral(0), &sequence.step);
    }
    hypotheses.iter().for_each(|h| edges.ends(h));
    let Edges { zeros, roots, equal, .. } = edges;
    distinct(zeros.into_iter().chain(roots).chain(equal)).take(MOST).collect()
}

/// Zeros of what a goal divides by or takes the logarithm of.
pub(crate) fn zeros_of_divisors(goal: &Prop) -> Vec<Prop> {
    distinct(Edges::of(goal, &|_| false).zeros.into_iter()).collect()
}

fn distinct(edges: impl Iterator<Item = Prop>) -> impl Iterator<Item = Prop> {
    let mut seen = BTreeSet::new();
    edges.filter(move |edge| speaks_of_a_name(edge) && seen.insert(print::prop(edge)))
}

struct Edges<'w> {
    whole: &'w dyn Fn(&str) -> bool,
    zeros: Vec<Prop>,
    roots: Vec<Prop>,
    equal: Vec<Prop>,
}

impl<'w> Edges<'w> {
    fn of(goal: &Prop, whole: &'w dyn Fn(&str) -> bool) -> Edges<'w> {
        let mut edges = Edges { whole, zeros: Vec::new(), roots: Vec::new(), equal: Vec::new() };
        edges.goal(goal, true);
        edges
    }

    /// What a part of the goal needs for its value, and where its sides are equal. A part that is `asserted` says so itself
    /// where it is an equation, and where it lets the sides be equal.
    fn goal(&mut self, p: &Prop, asserted: bool) {
        match &p.kind {
            PropKind::Compare(sides, relations) => {
                sides.iter().for_each(|e| self.expr(e));
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let strict = matches!(relation, Relation::Less | Relation::Greater | Relation::NotEqual);
                    if strict || !asserted {
                        self.equal.push(compare(pair[0].clone(), Relation::Equal, pair[1].clone()));
                    }
                }
            }
            PropKind::And(list) => list.iter().for_each(|p| self.goal(p, asserted)),
            PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().for_each(|p| self.goal(p, false)),
            PropKind::Not(p) => self.goal(p, false),
            PropKind::Implies(p, q) => {
                self.goal(p, false);
                self.goal(q, asserted);
            }
            PropKind::Limit(limit) => self.expr(&limit.value),
            PropKind::Exists(..) | PropKind::ForAll(..) | PropKind::Extremum(_) | PropKind::WrittenLimit(_) => {}
        }
    }

    /// The ends that belong to a hypothesis.
    fn ends(&mut self, p: &Prop) {
        match &p.kind {
            PropKind::And(list) => list.iter().for_each(|p| self.ends(p)),
            PropKind::Compare(sides, relations) => {
                for (pair, relation) in sides.windows(2).zip(relations) {
                    if matches!(relation, Relation::LessEqual | Relation::GreaterEqual) {
                        self.equal.push(compare(pair[0].clone(), Relation::Equal, pair[1].clone()));
                    }
                }
            }
            _ => {}
        }
    }

    /// What an expression and its parts need for their values.
    fn expr(&mut self, e: &Expr) {
        match &e.kind {
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
                [&index.from, &index.to].into_iter().for_each(|e| self.expr(e));
                self.at_the_first(&index.name.text, &index.from, body);
            }
            ExprKind::IntegralOver(variable, _) => {
                [&variable.from, &variable.to].into_iter().for_each(|e| self.expr(e));
            }
            _ => parts(e, &mut |part| self.expr(part)),
        }
        // An exponent that is too long has no edge that is looked for.
        for need in needs(e, self.whole).into_iter().flatten() {
            let zero = |e: &Expr| compare(e.clone(), Relation::Equal, numeral(0));
            match need {
                Need::NotZero(e) | Need::Positive(e) | Need::NotZeroOrNatural(e, _) => self.zeros.push(zero(&e)),
                Need::NotNegative(e) if !is_square(&e) => {
                    let below = literal(&Rational::from_signeds(BELOW.0, BELOW.1));
                    self.roots.extend([zero(&e), compare(e, Relation::Equal, below)]);
                }
                // A root has no derivative at 0.
                Need::NotNegative(e) => self.roots.push(zero(&e)),
                Need::Range(..) | Need::Differentiable(..) => {}
            }
        }
    }

    /// What an expression needs where an index has its first value.
    fn at_the_first(&mut self, index: &str, first: &Expr, body: &Expr) {
        let mut there = Substitution::default();
        there.replace(index, first);
        if let Ok(body) = there.expr(body) {
            self.expr(&body);
        }
    }
}

/// Whether an expression is a square by its form.
fn is_square(e: &Expr) -> bool {
    matches!(&e.kind, ExprKind::Power(_, k) if matches!(number(k), Some((top, 1)) if top % 2 == 0))
}

fn speaks_of_a_name(edge: &Prop) -> bool {
    let PropKind::Compare(sides, _) = &edge.kind else { return false };
    let mut names = BTreeSet::new();
    sides.iter().for_each(|e| names_in(e, &mut names));
    names.iter().any(|name| name != PI && !is_built_in(name))
}
