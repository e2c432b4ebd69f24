//! Rule `eventually`: what the limit of an expression says of its values from some number on.

use super::known::Known;
use super::names::names_in;
use super::order::Signs;
use super::statement::{compare, sum};
use super::tree::renamed;
use super::{Checker, Reason, Refusal, key, rejected};
use crate::claim::syntax::*;
use std::collections::BTreeSet;

impl Checker {
    /// Rule `eventually`: `exists N …: for all k >= N: C` from `limit of G as v -> infinity is L`, where each pair of
    /// neighbours in the chain C compares G, with k for v, with an expression c that does not depend on k and N, in the order
    /// in which L and c are.
    ///
    /// N has lower bounds only. k has the one bound `>= N` or `> N`, and is natural if v is. Signs are read outside the quantifiers.
    ///
    /// Sound: let ε > 0 be the least distance of L from a c. From some number on G lies within ε of L, hence on the side of
    /// each c on which L is, and strictly. N is a number above that one and above its own bounds, natural if need be. What
    /// holds for all large real numbers holds for the natural ones. The statement is defined, so G has a value for every k.
    /// That N and k are new names is seen with it (`within`), so a name in c is the one outside. L mentions none of v, N and
    /// k, and no sequence depends on v.
    pub(super) fn eventually(&mut self, goal: &Prop, from: &str, known: &mut Known) -> Result<(), Refusal> {
        let fact = self.fact(from)?;
        let PropKind::Limit(limit) = &fact.kind else { return rejected(Reason::NotALimit) };
        let natural = self.kind_of(&limit.variable.text)?;
        let PropKind::Exists(bindings, body) = &goal.kind else { return rejected(Reason::NotExists) };
        let Some((start, start_constraints, _)) = plain(bindings) else { return rejected(Reason::NotExists) };
        let PropKind::ForAll(bindings, chain) = &body.kind else { return rejected(Reason::NotForAll) };
        let Some((index, index_constraints, natural_index)) = plain(bindings) else {
            return rejected(Reason::NotForAll);
        };
        let moves = |e: &Expr| mentions(e, start) || mentions(e, index);
        let above = |c: &Constraint| match c {
            Constraint::Relation(Relation::Greater | Relation::GreaterEqual, bound) => !moves(bound),
            _ => false,
        };
        let from_start = |c: &Constraint| match c {
            Constraint::Relation(Relation::Greater | Relation::GreaterEqual, bound) => {
                matches!(&bound.kind, ExprKind::Name(name) if name == start)
            }
            _ => false,
        };
        let is_unbounded = start_constraints.iter().all(above)
            && matches!(index_constraints, [only] if from_start(only))
            && (natural_index || !natural);
        if !is_unbounded {
            return rejected(Reason::NotUnbounded);
        }
        let PropKind::Compare(sides, relations) = &chain.kind else { return rejected(Reason::NotSingle) };
        if [limit.variable.text.as_str(), start, index].into_iter().any(|name| mentions(&limit.value, name)) {
            return rejected(Reason::OtherLimit);
        }
        let there = key::expr(&renamed(&limit.of, &limit.variable.text, index)?);
        for (pair, relation) in sides.windows(2).zip(relations) {
            let [left, right] = pair else { continue };
            let (bound, is_left) = match (key::expr(left) == there, key::expr(right) == there) {
                (true, false) => (right, true),
                (false, true) => (left, false),
                _ => return rejected(Reason::OtherLimit),
            };
            if moves(bound) {
                return rejected(Reason::OtherLimit);
            }
            let strict = match relation {
                Relation::Less | Relation::LessEqual => Relation::Less,
                Relation::Greater | Relation::GreaterEqual => Relation::Greater,
                Relation::NotEqual => Relation::NotEqual,
                Relation::Equal => return rejected(Reason::Signs),
            };
            let (left, right) = if is_left { (&limit.value, bound) } else { (bound, &limit.value) };
            let distance = sum(vec![(Sign::Plus, left.clone()), (Sign::Minus, right.clone())]);
            if !self.signs_of_expr(&distance, known)?.within(Signs::of(strict)) {
                return rejected(Reason::Needs(compare(left.clone(), strict, right.clone())));
            }
        }
        self.prop_defined(goal, known)
    }
}

/// The one plain name of the one binding, with its constraints and whether it is natural.
fn plain(bindings: &[Binding]) -> Option<(&str, &[Constraint], bool)> {
    let [Binding { names, constraints, natural, indices: None, .. }] = bindings else { return None };
    match names.as_slice() {
        [(name, None)] => Some((name.text.as_str(), constraints, *natural)),
        _ => None,
    }
}

/// Whether a name occurs in an expression.
fn mentions(e: &Expr, name: &str) -> bool {
    let mut names = BTreeSet::new();
    names_in(e, &mut names);
    names.contains(name)
}
