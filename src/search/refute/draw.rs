//! Choices drawn at random: within the bounds of the variables, on one of the ways to satisfy the equations.
//!
//! Numbers are small and large, perfect powers (whose roots are rational), ends of domains, values that another variable has,
//! and values that meet a bound of the goal exactly. A choice depends on the numbers that the caller draws and on nothing else.

use super::evaluate::Assignment;
use super::expand::names_in;
use super::number::Number;
use super::search::{Choice, Members, Search};
use crate::claim::syntax::*;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Ceiling, Floor, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::{BTreeMap, BTreeSet};

/// Gives a number below its argument, which is at least 1.
pub type Below<'r> = &'r mut dyn FnMut(u64) -> u64;

/// The most members of a family that are listed.
const MEMBERS: u64 = 6;

/// A bound of a variable: the relation to the value of an expression.
type Bound = (Relation, Expr);

/// What is known of the variables of a claim when values are drawn for them.
pub(super) struct Drawing {
    /// The hypotheses that bound a variable, and the values to which the goal compares it, by its name.
    known: BTreeMap<String, (Vec<Bound>, Vec<Expr>)>,
}

impl Drawing {
    /// What the hypotheses and the goal say of each variable.
    pub(super) fn of(search: &Search, goal: &Prop) -> Drawing {
        let known = search.names.iter().map(|(name, _)| {
            let (mut bounds, mut met) = (Vec::new(), Vec::new());
            search.hypotheses.iter().for_each(|h| bounds_of(h, name, &mut bounds));
            comparisons(goal, &mut |h| bounds_of(h, name, &mut met));
            (name.clone(), (bounds, met.into_iter().map(|bound| bound.1).collect()))
        });
        Drawing { known: known.collect() }
    }

    /// Random values within the bounds that are known when a variable's turn comes.
    pub(super) fn drawn(&self, search: &Search, path: usize, below: Below<'_>) -> Option<Choice> {
        let mut here = search.base.clone();
        // Bounds may speak of members of families.
        let mut families = Vec::new();
        for family in &search.families {
            let members = members(search, family, below)?;
            if let Members::InTurn(list) = &members {
                here.families.insert(family.0.clone(), list.clone());
            }
            families.push(members);
        }
        let mut scalars = Vec::new();
        let none = Default::default();
        for (name, natural) in &search.paths.get(path)?.free {
            let (bounds, met) = self.known.get(name).unwrap_or(&none);
            let range = Range::of(&here, bounds);
            let value = match below(6) {
                0 => shared(&here, met, &range, *natural, &scalars, below),
                _ => None,
            };
            let value = value.or_else(|| range.drawn(*natural, below))?;
            here.values.insert(name.clone(), value.clone());
            scalars.push(value);
        }
        Some(Choice { path, scalars, families })
    }
}

/// A value that another variable has, or to which the goal compares this one, if there is one in the range.
fn shared(
    here: &Assignment,
    met: &[Expr],
    range: &Range,
    natural: bool,
    others: &[Rational],
    below: Below<'_>,
) -> Option<Rational> {
    let met = met.iter().filter_map(|e| match here.number(e) {
        Ok(Number::Exact(value)) => Some(value),
        _ => None,
    });
    let list: Vec<Rational> = others.iter().cloned().chain(met).collect();
    let value = list.get(usize::try_from(below(list.len().max(1) as u64)).ok()?)?;
    let fits = range.holds(value) && (!natural || *value.denominator_ref() == 1u32);
    fits.then(|| value.clone())
}

fn members(search: &Search, family: &(String, bool, Vec<Prop>), below: Below<'_>) -> Option<Members> {
    let (name, natural, domain) = family;
    let mut bounds = Vec::new();
    domain.iter().for_each(|h| bounds_of(h, name, &mut bounds));
    let range = Range::of(&search.base, &bounds);
    let first = range.drawn(*natural, below)?;
    if below(4) == 0 {
        let ratio = Rational::from_unsigneds(1 + below(4), 1 + below(4));
        if search.may_be_geometric(family, &first, &ratio) {
            return Some(Members::Geometric(first, ratio));
        }
    }
    let count = if below(4) == 0 { 1 } else { 1 + below(MEMBERS) };
    let more = (1..count).map(|_| range.drawn(*natural, below));
    Some(Members::InTurn(std::iter::once(Some(first)).chain(more).collect::<Option<_>>()?))
}

/// What a comparison says of a variable: a side that is the variable alone, beside one without it.
fn bounds_of(prop: &Prop, name: &str, into: &mut Vec<Bound>) {
    let PropKind::Compare(sides, relations) = &prop.kind else { return };
    let alone = |e: &Expr| matches!(&e.kind, ExprKind::Name(n) if n == name);
    for (pair, relation) in sides.windows(2).zip(relations) {
        for (this, other, relation) in [(&pair[0], &pair[1], *relation), (&pair[1], &pair[0], relation.turned())] {
            let mut names = BTreeSet::new();
            names_in(other, &mut names);
            if alone(this) && !names.contains(name) {
                into.push((relation, other.clone()));
            }
        }
    }
}

/// The comparisons in a proposition.
fn comparisons(prop: &Prop, visit: &mut dyn FnMut(&Prop)) {
    match &prop.kind {
        PropKind::Compare(..) => visit(prop),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| comparisons(p, visit));
        }
        PropKind::Not(p) | PropKind::ForAll(_, p) | PropKind::Exists(_, p) => comparisons(p, visit),
        PropKind::Implies(p, q) => {
            comparisons(p, visit);
            comparisons(q, visit);
        }
        PropKind::Extremum(_) | PropKind::Limit(_) | PropKind::WrittenLimit(_) => {}
    }
}

/// Where a value may lie: the ends, each with whether it belongs to it.
#[derive(Default)]
struct Range {
    from: Option<(Rational, bool)>,
    to: Option<(Rational, bool)>,
}

impl Range {
    /// The bounds that have a value here.
    fn of(here: &Assignment, bounds: &[Bound]) -> Range {
        let mut range = Range::default();
        for (relation, bound) in bounds {
            let Ok(number) = here.number(bound) else { continue };
            // Of an enclosure the end that is safe.
            let (low, high) = match number {
                Number::Exact(q) => (q.clone(), q),
                Number::Between(low, high, _) => (low, high),
            };
            match relation {
                Relation::Greater => range.above(high, false),
                Relation::GreaterEqual => range.above(high, true),
                Relation::Less => range.below(low, false),
                Relation::LessEqual => range.below(low, true),
                Relation::Equal => {
                    range.above(low, true);
                    range.below(high, true);
                }
                Relation::NotEqual => {}
            }
        }
        range
    }

    fn above(&mut self, bound: Rational, closed: bool) {
        if self.from.as_ref().is_none_or(|(old, was)| bound > *old || bound == *old && *was) {
            self.from = Some((bound, closed));
        }
    }

    fn below(&mut self, bound: Rational, closed: bool) {
        if self.to.as_ref().is_none_or(|(old, was)| bound < *old || bound == *old && *was) {
            self.to = Some((bound, closed));
        }
    }

    fn holds(&self, value: &Rational) -> bool {
        self.from.as_ref().is_none_or(|(from, closed)| value > from || *closed && value == from)
            && self.to.as_ref().is_none_or(|(to, closed)| value < to || *closed && value == to)
    }

    /// A random value in it; `None` where there is none.
    fn drawn(&self, natural: bool, below: Below<'_>) -> Option<Rational> {
        if natural {
            return self.natural(below);
        }
        let value = match (&self.from, &self.to) {
            (Some((from, _)), Some((to, _))) => from + (to - from) * share(below),
            (Some((from, closed)), None) => match *closed && below(8) == 0 {
                true => from.clone(),
                false => from + size(below),
            },
            (None, Some((to, closed))) => match *closed && below(8) == 0 {
                true => to.clone(),
                false => to - size(below),
            },
            (None, None) => match below(9) {
                0 => Rational::ZERO,
                k if k % 2 == 0 => size(below),
                _ => -size(below),
            },
        };
        if self.holds(&value) {
            return Some(value);
        }
        // An end that does not belong to it.
        let (Some((from, _)), Some((to, _))) = (&self.from, &self.to) else { return None };
        let middle = (from + to) / Rational::from(2);
        self.holds(&middle).then_some(middle)
    }

    fn natural(&self, below: Below<'_>) -> Option<Rational> {
        let least = match &self.from {
            Some((from, true)) => from.ceiling(),
            Some((from, false)) => from.floor() + malachite::Integer::ONE,
            None => malachite::Integer::ZERO,
        };
        let least = Rational::from(least.max(malachite::Integer::ZERO));
        let mut room = [2, 4, 9, 21][usize::try_from(below(4)).ok()?];
        if let Some((to, closed)) = &self.to {
            let most = Rational::from(to.floor());
            let most = if most == *to && !closed { most - Rational::ONE } else { most };
            if most < least {
                return None;
            }
            room = room.min(u64::try_from(&(most - &least)).unwrap_or(u64::MAX).saturating_add(1));
        }
        Some(least + Rational::from(below(room)))
    }
}

/// A random number above 0.
fn size(below: Below<'_>) -> Rational {
    let mut quotient = |most: u64| Rational::from_unsigneds(1 + below(most), 1 + below(most));
    let plain = [quotient(6), quotient(60)];
    let [small, medium] = plain;
    match below(8) {
        0 | 1 => Rational::from(1 + below(6)),
        2 | 3 => small,
        4 => medium,
        // Roots of perfect powers are rational.
        5 | 6 => small.pow([2i64, 3, 4, 6, 12][usize::try_from(below(5)).unwrap_or(0)]),
        _ => medium * Rational::from(10).pow(i64::try_from(below(41)).unwrap_or(0) - 20),
    }
}

/// A random number from 0 to 1.
fn share(below: Below<'_>) -> Rational {
    let most = [4, 20, 1_000_000][usize::try_from(below(3)).unwrap_or(0)];
    let parts = 1 + below(most);
    let plain = Rational::from_unsigneds(below(parts + 1), parts);
    match below(8) {
        0 => Rational::from(10).pow(-1 - i64::try_from(below(20)).unwrap_or(0)),
        1 => Rational::ONE - Rational::from(10).pow(-1 - i64::try_from(below(20)).unwrap_or(0)),
        2 => (&plain).pow(2u64),
        _ => plain,
    }
}
