//! Claims tried at random exact points.
//!
//! Contract: a point is drawn from the domains of the variables, what the hypotheses determine is computed, and only points
//! where every hypothesis certainly holds count. At a point the goal certainly holds, certainly fails, or is left open:
//! values are exact, or enclosed with [`super::number::PRECISION`] bits, so a failure is never noise. The points depend
//! on the numbers that the caller draws and on nothing else.
//!
//! Simple points come first, as in a refutation; then random ones: small and large numbers, perfect powers (whose roots
//! are rational), ends of domains, and values that meet a bound of the goal exactly.

use super::evaluate::Assignment;
use super::expand::{Limit, Statement, names_in};
use super::goal::{Goal, Seen, aimed};
use super::number::Number;
use super::outcome::{Fault, Point, Witness};
use super::search::{Choice, Members, Plan, Search, as_point};
use super::shape;
use crate::claim::syntax::*;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Ceiling, Floor, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use std::collections::BTreeSet;

/// Gives a number below its argument, which is at least 1.
pub type Below<'r> = &'r mut dyn FnMut(u64) -> u64;

/// How often a point is drawn until the hypotheses hold.
const DRAWS: usize = 100;

/// The most members of a family that are listed.
const MEMBERS: u64 = 6;

/// The most times a failing point is made simpler.
const SHRINKING: usize = 200;

/// Why a claim cannot be tried.
pub enum Untried {
    /// It makes no sense.
    Fault(Fault),
    /// A limit, by name.
    Limit(&'static str),
    /// What holds at a point says nothing: a derivative or a limit is about variables that hypotheses tie.
    Moves,
}

/// A bound of a variable: the relation to the value of an expression.
type Bound = (Relation, Expr);

/// A claim, ready to be tried.
pub struct Trial {
    statement: Statement,
    search: Search,
    goal: Goal,
    /// For each free variable, the hypotheses that bound it.
    bounds: Vec<Vec<Bound>>,
    /// For each free variable, the values to which the goal compares it.
    met: Vec<Vec<Expr>>,
}

impl Trial {
    /// A trial of a claim.
    ///
    /// # Errors
    /// Matrices that do not fit, a limit, a goal that no point decides.
    pub fn new(claim: &Claim) -> Result<Trial, Untried> {
        let statement = Statement::of(claim).map_err(|Limit(name)| Untried::Limit(name))?;
        let said = statement.assumptions.iter().map(|a| &a.1).chain([&statement.goal]);
        said.into_iter().try_for_each(shape::check).map_err(|fault| Untried::Fault(Fault::Text(fault)))?;
        let mut plan = Plan::of(&statement);
        let (mut search, mut goal) = aimed(&mut plan, &statement).ok_or(Untried::Moves)?;
        goal.identify(&mut plan);
        search.follow_a_way_with_points();
        let mut bounds = Vec::new();
        let mut met = Vec::new();
        for (name, _) in &search.names {
            let mut list = Vec::new();
            search.hypotheses.iter().for_each(|h| bounds_of(h, name, &mut list));
            bounds.push(list);
            let mut list = Vec::new();
            comparisons(&goal.prop, &mut |h| bounds_of(h, name, &mut list));
            met.push(list.into_iter().map(|bound| bound.1).collect());
        }
        Ok(Trial { statement, search, goal, bounds, met })
    }

    /// What the goal is at a choice; `None` where a hypothesis does not hold for certain.
    pub fn at(&mut self, choice: &Choice) -> Option<(Seen, Assignment)> {
        let point = if self.lies_in_domains(choice) { self.search.at(choice)? } else { return None };
        let seen = self.goal.at(&point);
        Some((seen, point))
    }

    /// Whether natural numbers are natural and members of families lie in their domains: the search takes this as given.
    fn lies_in_domains(&self, choice: &Choice) -> bool {
        let whole = |q: &Rational| *q >= 0 && *q.denominator_ref() == 1u32;
        let scalars = self.search.names.iter().zip(&choice.scalars).all(|((_, natural), q)| !natural || whole(q));
        let families = self.search.families.iter().zip(&choice.families).all(|(family, members)| match members {
            Members::Geometric(first, ratio) => self.search.may_be_geometric(family, first, ratio),
            Members::InTurn(list) => list.iter().all(|q| {
                let mut alone = Assignment { naturals: self.search.base.naturals.clone(), ..Assignment::default() };
                alone.values.insert(family.0.clone(), q.clone());
                (!family.1 || whole(q)) && family.2.iter().all(|h| alone.truth(h) == Ok(true))
            }),
        });
        scalars && families
    }

    /// The simplest points, so many at most.
    pub(crate) fn simple(&mut self, most: usize) -> Vec<Choice> {
        let mut out = Vec::new();
        self.search.run_choices(None, &mut |choice, _| {
            out.push(choice.clone());
            out.len() >= most
        });
        out.truncate(most);
        out
    }

    /// A random point where the hypotheses hold, if one is found.
    pub fn random(&self, below: Below<'_>) -> Option<Choice> {
        (0..DRAWS).find_map(|_| self.once(below))
    }

    /// One random choice from numbers that the caller has; `None` where the hypotheses do not hold.
    pub fn once(&self, below: Below<'_>) -> Option<Choice> {
        self.drawn(below).filter(|choice| self.search.at(choice).is_some())
    }

    /// The values of a point by their names.
    pub fn named(&self, point: &Assignment) -> Point {
        as_point(&self.statement, point)
    }

    /// The choices in which one number, or the list of a family, is shorter.
    pub(crate) fn simpler(choice: &Choice) -> Vec<Choice> {
        simpler(choice)
    }

    /// A counterexample as small as it can be made: at each step one number becomes simpler and the goal still fails.
    pub fn smallest(&mut self, mut choice: Choice) -> Option<Witness> {
        let mut witness = self.witness(&choice)?;
        for _ in 0..SHRINKING {
            let Some((simpler, found)) =
                simpler(&choice).into_iter().find_map(|c| Some((c.clone(), self.witness(&c)?)))
            else {
                break;
            };
            (choice, witness) = (simpler, found);
        }
        Some(witness)
    }

    fn witness(&mut self, choice: &Choice) -> Option<Witness> {
        match self.at(choice)? {
            (Seen::Fails(broken), point) => Some(Witness { point: as_point(&self.statement, &point), broken }),
            _ => None,
        }
    }

    /// Random values within the bounds that are known when a variable's turn comes.
    fn drawn(&self, below: Below<'_>) -> Option<Choice> {
        let mut here = self.search.base.clone();
        // Bounds may speak of members of families.
        let mut families = Vec::new();
        for family in &self.search.families {
            let members = self.members(family, below)?;
            if let Members::InTurn(list) = &members {
                here.families.insert(family.0.clone(), list.clone());
            }
            families.push(members);
        }
        let mut scalars = Vec::new();
        for (place, (name, natural)) in self.search.names.iter().enumerate() {
            let range = Range::of(&here, &self.bounds[place]);
            let value = match below(6) {
                0 => self.shared(&here, place, &range, *natural, &scalars, below),
                _ => None,
            };
            let value = value.or_else(|| range.drawn(*natural, below))?;
            here.values.insert(name.clone(), value.clone());
            scalars.push(value);
        }
        Some(Choice { scalars, families })
    }

    /// A value that another variable has, or to which the goal compares this one, if there is one in the range.
    fn shared(
        &self,
        here: &Assignment,
        place: usize,
        range: &Range,
        natural: bool,
        others: &[Rational],
        below: Below<'_>,
    ) -> Option<Rational> {
        let met = self.met[place].iter().filter_map(|e| match here.number(e) {
            Ok(Number::Exact(value)) => Some(value),
            _ => None,
        });
        let list: Vec<Rational> = others.iter().cloned().chain(met).collect();
        let value = list.get(usize::try_from(below(list.len().max(1) as u64)).ok()?)?;
        let fits = range.holds(value) && (!natural || *value.denominator_ref() == 1u32);
        fits.then(|| value.clone())
    }

    fn members(&self, family: &(String, bool, Vec<Prop>), below: Below<'_>) -> Option<Members> {
        let (name, natural, domain) = family;
        let mut bounds = Vec::new();
        domain.iter().for_each(|h| bounds_of(h, name, &mut bounds));
        let range = Range::of(&self.search.base, &bounds);
        let first = range.drawn(*natural, below)?;
        if below(4) == 0 {
            let ratio = Rational::from_unsigneds(1 + below(4), 1 + below(4));
            if self.search.may_be_geometric(family, &first, &ratio) {
                return Some(Members::Geometric(first, ratio));
            }
        }
        let count = if below(4) == 0 { 1 } else { 1 + below(MEMBERS) };
        let more = (1..count).map(|_| range.drawn(*natural, below));
        Some(Members::InTurn(std::iter::once(Some(first)).chain(more).collect::<Option<_>>()?))
    }
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
        PropKind::Extremum(_) | PropKind::Limit(_) => {}
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

/// How much there is to read in a number.
fn length(q: &Rational) -> u64 {
    let bits = q.numerator_ref().significant_bits() + 2 * q.denominator_ref().significant_bits();
    4 * bits + 2 * u64::from(*q < 0) + u64::from(*q == 0)
}

/// Numbers that are shorter than this one, the shortest first.
fn shorter(q: &Rational) -> Vec<Rational> {
    let simple =
        [(1, 1), (2, 1), (1, 2), (0, 1), (3, 1), (4, 1), (1, 4), (1, 3), (3, 2), (3, 4), (9, 1), (8, 1), (9, 10)];
    let mut list: Vec<Rational> = simple.iter().map(|(p, q)| Rational::from_signeds(*p, *q)).collect();
    list.extend([-1, -2].map(Rational::from));
    let parts = [(1, 1), (1, 2), (3, 4)].map(|(p, d)| q * Rational::from_signeds(p, d));
    list.extend(parts.iter().flat_map(|part| [Rational::from(part.floor()), Rational::from(part.ceiling())]));
    // The convergents of its continued fraction.
    let (mut before, mut last) = ((Rational::ZERO, Rational::ONE), (Rational::ONE, Rational::ZERO));
    let mut rest = q.clone();
    for _ in 0..64 {
        let whole = Rational::from((&rest).floor());
        let next = (&whole * &last.0 + before.0, &whole * &last.1 + before.1);
        (before, last) = (last, next);
        if last.1 != 0 {
            list.push(&last.0 / &last.1);
        }
        rest -= whole;
        if rest == 0 {
            break;
        }
        rest = Rational::ONE / rest;
    }
    list.retain(|other| length(other) < length(q));
    list.sort_by_cached_key(length);
    list.dedup();
    list
}

/// The choices in which one number, or the list of a family, is shorter.
fn simpler(choice: &Choice) -> Vec<Choice> {
    let mut out = Vec::new();
    for (place, value) in choice.scalars.iter().enumerate() {
        let others = choice.scalars.iter().filter(|other| length(other) < length(value)).cloned();
        for shorter in shorter(value).into_iter().chain(others) {
            let mut next = choice.clone();
            next.scalars[place] = shorter;
            out.push(next);
        }
    }
    for (place, members) in choice.families.iter().enumerate() {
        let mut with = |members: Members| {
            let mut next = choice.clone();
            next.families[place] = members;
            out.push(next);
        };
        match members {
            Members::Geometric(first, ratio) => {
                with(Members::InTurn(vec![first.clone()]));
                shorter(first).into_iter().for_each(|first| with(Members::Geometric(first, ratio.clone())));
                shorter(ratio).into_iter().filter(|r| *r > 0).for_each(|r| with(Members::Geometric(first.clone(), r)));
            }
            Members::InTurn(list) => {
                for shorter in 1..list.len() {
                    with(Members::InTurn(list[..shorter].to_vec()));
                }
                for (member, value) in list.iter().enumerate() {
                    for shorter in shorter(value) {
                        let mut list = list.clone();
                        list[member] = shorter;
                        with(Members::InTurn(list));
                    }
                }
            }
        }
    }
    out
}
