//! Exact points at which the hypotheses hold.
//!
//! Contract: a visited point satisfies every hypothesis exactly and certainly. Variables that the hypotheses determine are
//! computed, not guessed: each `Path` is a way to satisfy the equations. Values are tried in the order of their lists, all
//! variables together: the first point takes the first value of each.

use super::Moment;
use super::candidates::Values;
use super::evaluate::{Assignment, STEPS};
use super::expand::Statement;
use super::number::Number;
use super::outcome::Point;
use super::reading::Reading;
use super::recurrence::recurrences;
use super::solve::{Way, ways};
use crate::claim::print;
use crate::claim::syntax::*;
use crate::claim::walk::names_in;
use crate::kernel::statement::{constraints, domain, name};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::conversion::traits::IsInteger;
use std::cell::{Cell, OnceCell};
use std::collections::BTreeSet;
use std::ops::Range;
use std::rc::Rc;

/// A search over points.
pub(super) struct Search {
    /// The variables as they are declared, and whether each is a natural number.
    pub(super) names: Vec<(String, bool)>,
    /// The families with what their members obey.
    pub(super) families: Vec<(String, bool, Vec<Prop>)>,
    /// Ways to satisfy the equations.
    pub(super) paths: Vec<Path>,
    /// What holds at a point.
    pub(super) hypotheses: Vec<Prop>,
    /// The names in each of the hypotheses.
    mentioned: OnceCell<Vec<BTreeSet<String>>>,
    /// What all points have in common.
    pub(super) base: Assignment,
    /// How many expressions may still be evaluated.
    pub(super) left: Cell<u64>,
    /// When to stop.
    pub(super) until: Cell<Option<Moment>>,
}

/// A way to satisfy the equations.
pub(super) struct Path {
    /// The variables that are free to choose on it, and whether each is a natural number.
    pub(super) free: Vec<(String, bool)>,
    /// Those that are computed from them.
    determined: Way,
    /// Whether values that are computed are irrational wherever they are: they speak of π, exponentials or logarithms, or are constants.
    is_irrational: bool,
}

/// What is chosen at a point: the way to satisfy the equations, the variables that are free on it, and the families.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The way, by its place in the search.
    pub(super) path: usize,
    /// The variables.
    pub scalars: Vec<Rational>,
    /// The families.
    pub families: Vec<Members>,
}

/// The members of a family.
#[derive(Clone, Debug, PartialEq)]
pub enum Members {
    /// These in turn.
    InTurn(Vec<Rational>),
    /// Member 0 and the ratio of a member to the one before.
    Geometric(Rational, Rational),
}

/// Which points are visited of a list of values.
#[derive(Clone, Copy)]
pub(super) struct Round {
    /// Whether families are geometric where their domains allow it, or run through listed values.
    pub(super) geometric: bool,
    /// How many points of each path were visited before.
    pub(super) skip: usize,
    /// How many points of each path are looked at, those skipped included.
    pub(super) most: usize,
}

impl Round {
    /// So many points from the first one on.
    pub(super) fn first(most: usize) -> Round {
        Round { geometric: false, skip: 0, most }
    }
}

/// Hears of a point at which the hypotheses hold; whether to stop there.
pub(super) type Visit<'v> = dyn FnMut(&Choice, &Assignment) -> bool + 'v;

impl Search {
    /// A search that has no path yet.
    pub(super) fn new(bindings: &[Binding], statement: Option<&Statement>) -> Search {
        let mut search = Search {
            names: Vec::new(),
            families: Vec::new(),
            paths: Vec::new(),
            hypotheses: Vec::new(),
            mentioned: OnceCell::new(),
            base: Assignment::default(),
            left: Cell::new(u64::MAX),
            until: Cell::new(None),
        };
        if let Some(statement) = statement {
            let sequences = statement.sequences.iter().map(|u| (u.name.clone(), Rc::new(u.clone())));
            search.base.sequences = Rc::new(sequences.collect());
            search.base.is_pi = !statement.declares(PI);
            search.hypotheses = statement.assumptions.iter().map(|a| a.1.clone()).collect();
        }
        search.declare(bindings);
        search.go_on_by_recurrences();
        search
    }

    /// Takes the families that recurrences determine as such; these hypotheses hold by construction.
    fn go_on_by_recurrences(&mut self) {
        // What a domain says of all members is not seen at a few.
        let free = self.families.iter().filter(|f| !f.1 && f.2.is_empty() && !self.base.ranges.contains_key(&f.0));
        let names: Vec<String> = free.map(|f| f.0.clone()).collect();
        let (found, places) = recurrences(&names, &self.hypotheses);
        let mut place = 0..;
        self.hypotheses.retain(|_| place.next().is_none_or(|place| !places.contains(&place)));
        self.base.recurrences = Rc::new(found);
    }

    pub(super) fn declare(&mut self, bindings: &[Binding]) {
        for binding in bindings {
            for (name, index) in &binding.names {
                if binding.natural {
                    Rc::make_mut(&mut self.base.naturals).insert(name.text.clone());
                }
                if index.is_some() {
                    let domain = constraints(binding, &super::search::name(&name.text));
                    self.families.push((name.text.clone(), binding.natural, domain));
                    if let Some(range) = &binding.indices {
                        Rc::make_mut(&mut self.base.ranges).insert(name.text.clone(), range.clone());
                    }
                } else {
                    self.names.push((name.text.clone(), binding.natural));
                }
            }
            self.hypotheses.extend(domain(binding));
        }
    }

    /// The variables that are not natural numbers.
    pub(super) fn real(&self) -> Vec<String> {
        self.names.iter().filter(|n| !n.1).map(|n| n.0.clone()).collect()
    }

    /// Adds paths on which these values are computed, unless there is such a path; the places of the new ones.
    pub(super) fn follow(&mut self, ways: &[Way]) -> Range<usize> {
        let before = self.paths.len();
        for way in ways {
            if self.paths.iter().all(|path| path.determined != *way) {
                // A variable whose value speaks of the variable itself is chosen first.
                let speaks_of = |value: &Expr, name: &str| {
                    let mut inside = BTreeSet::new();
                    crate::claim::walk::names_in(value, &mut inside);
                    inside.contains(name)
                };
                let is_free = |name: &str| {
                    way.iter().filter(|(computed, _)| computed == name).all(|(name, value)| speaks_of(value, name))
                };
                let free = self.names.iter().filter(|n| is_free(&n.0)).cloned().collect();
                let is_pi = |value: &Expr| self.base.is_pi && speaks_of(value, PI);
                let is_irrational = way.iter().any(|(_, value)| is_pi(value) || is_transcendental(value));
                self.paths.push(Path { free, determined: way.clone(), is_irrational });
            }
        }
        before..self.paths.len()
    }

    /// The ways of its paths.
    pub(super) fn ways(&self) -> impl Iterator<Item = &Way> {
        self.paths.iter().map(|path| &path.determined)
    }

    /// Whether the constant bounds of a variable, or of the members of a family, allow a value.
    pub(super) fn allows(&self, name: &str, value: Number) -> bool {
        let mut alone =
            Assignment { naturals: self.base.naturals.clone(), is_pi: self.base.is_pi, ..Assignment::default() };
        alone.give(name, value);
        if let Some((_, _, domain)) = self.families.iter().find(|f| f.0 == name) {
            return domain.iter().all(|h| alone.truth(h) == Ok(true));
        }
        // Hypotheses without the name say the same whatever its value is; those with others mostly nothing yet.
        let names = || self.hypotheses.iter().map(super::names::names_of_prop).collect();
        let own = self.hypotheses.iter().zip(self.mentioned.get_or_init(names)).filter(|h| h.1.contains(name));
        own.into_iter().all(|(h, _)| alone.truth(h) != Ok(false))
    }

    /// Whether the constant bounds of variables allow what is computed of so many times π.
    pub(super) fn allows_turned(&self, way: &Way, name: &str, turns: &Rational) -> bool {
        let mut here = Assignment { is_pi: self.base.is_pi, ..Assignment::default() };
        here.values.insert(name.to_string(), turns.clone());
        way.iter().all(|(x, value)| here.number(value).is_ok_and(|value| self.allows(x, value)))
    }

    /// Visits points of these paths where the hypotheses hold, simple ones first, until a visit says to stop.
    pub(super) fn run(&self, paths: Range<usize>, values: &mut Values, round: Round, visit: &mut Visit) -> bool {
        paths.into_iter().any(|path| self.run_path(path, values, round, visit))
    }

    fn run_path(&self, path: usize, values: &mut Values, round: Round, visit: &mut Visit) -> bool {
        let names: Vec<(String, bool)> =
            self.paths[path].free.iter().cloned().chain(self.families.iter().map(|f| (f.0.clone(), f.1))).collect();
        let mut visit = |search: &Search, lists: &[Rc<[Rational]>], ranks: &[usize]| {
            let choice = search.chosen(path, lists, ranks, round.geometric);
            let Some(point) = search.at(&choice) else { return false };
            let before = point.steps.get();
            let done = visit(&choice, &point);
            search.spend(before - point.steps.get());
            done
        };
        // The simplest point needs the first value of each only, and mostly it is enough.
        if round.skip == 0 {
            let Some(first) =
                names.iter().map(|(name, natural)| values.first(self, name, *natural)).collect::<Option<Vec<_>>>()
            else {
                return false;
            };
            if visit(self, &first, &vec![0; names.len()]) {
                return true;
            }
        }
        let lists: Vec<Rc<[Rational]>> = names.iter().map(|(name, natural)| values.of(self, name, *natural)).collect();
        let sizes: Vec<usize> = lists.iter().map(|list| list.len()).collect();
        let (mut tried, mut found) = (0, false);
        in_order(&sizes, &mut |ranks| {
            tried += 1;
            // The first point was visited above.
            if tried <= round.skip.max(1) {
                return false;
            }
            if tried > round.most || self.is_over() {
                return true;
            }
            found = visit(self, &lists, ranks);
            found
        });
        found
    }

    /// Whether a limit ends the search.
    pub(super) fn is_over(&self) -> bool {
        self.left.get() == 0 || self.until.get().is_some_and(|end| Moment::now() > end)
    }

    /// The values at these ranks.
    fn chosen(&self, path: usize, lists: &[Rc<[Rational]>], ranks: &[usize], geometric: bool) -> Choice {
        let free = self.paths[path].free.len();
        let (of_names, of_families) = ranks.split_at(free);
        let scalars = of_names.iter().zip(lists).map(|(rank, values)| values[*rank].clone()).collect();
        let families =
            self.families.iter().zip(of_families.iter().zip(&lists[free..])).map(|(family, (rank, values))| {
                let ratio = Rational::from_signeds([2, 1, 3][rank % 3], [1, 2, 1][rank % 3]);
                let first = values[*rank].clone();
                if geometric && self.may_be_geometric(family, &first, &ratio) {
                    return Members::Geometric(first, ratio);
                }
                // Members run through the values in turn, starting at the rank.
                let in_turn = (0..values.len().min(5)).map(|k| values[(rank + k * rank) % values.len()].clone());
                Members::InTurn(in_turn.collect())
            });
        Choice { path, scalars, families: families.collect() }
    }

    /// Whether all members of a geometric family lie in its domain.
    pub(super) fn may_be_geometric(
        &self,
        (name, natural, domain): &(String, bool, Vec<Prop>),
        first: &Rational,
        ratio: &Rational,
    ) -> bool {
        // Members rise or fall, and bounds on one side hold for all members if they do for the first and last.
        let plain = domain.iter().all(|h| match &h.kind {
            PropKind::Compare(_, relations) => !relations.contains(&Relation::NotEqual),
            _ => false,
        });
        let whole = !natural || (first.is_integer() && ratio.is_integer());
        let allowed = |k: i64| {
            let mut alone =
                Assignment { naturals: self.base.naturals.clone(), is_pi: self.base.is_pi, ..Assignment::default() };
            alone.values.insert(name.clone(), first * ratio.pow(k));
            domain.iter().all(|h| alone.truth(h) == Ok(true))
        };
        plain && whole && (0..24).chain([super::number::LARGEST + 1]).all(allowed)
    }

    /// Whether natural numbers are natural and members of families lie in their domains: at a point this is taken as given.
    pub(super) fn may_be(&self, choice: &Choice) -> bool {
        let Some(path) = self.paths.get(choice.path) else { return false };
        let scalars = path.free.iter().zip(&choice.scalars).all(|((_, natural), q)| !natural || is_natural(q));
        let families = self.families.iter().zip(&choice.families).all(|(family, members)| match members {
            Members::Geometric(first, ratio) => self.may_be_geometric(family, first, ratio),
            Members::InTurn(list) => {
                list.iter().all(|q| (!family.1 || is_natural(q)) && self.allows(&family.0, Number::Exact(q.clone())))
            }
        });
        scalars && families
    }

    /// The point of a choice, with what the hypotheses determine, if they all hold there for certain.
    pub(super) fn at(&self, choice: &Choice) -> Option<Assignment> {
        let steps = Rc::new(Cell::new(STEPS));
        let point = self.at_with(choice, steps.clone());
        self.spend(STEPS - steps.get());
        point
    }

    /// Counts expressions that were evaluated, and the point itself.
    pub(super) fn spend(&self, expressions: u32) {
        self.left.set(self.left.get().saturating_sub(1 + u64::from(expressions)));
    }

    fn at_with(&self, choice: &Choice, steps: Rc<Cell<u32>>) -> Option<Assignment> {
        let path = self.paths.get(choice.path)?;
        let mut point = Assignment { steps, until: self.until.get(), members: Rc::default(), ..self.base.clone() };
        for ((name, _), value) in path.free.iter().zip(&choice.scalars) {
            point.values.insert(name.clone(), value.clone());
        }
        for ((name, ..), members) in self.families.iter().zip(&choice.families) {
            match members {
                Members::InTurn(list) => {
                    point.families.insert(name.clone(), list.clone());
                }
                Members::Geometric(first, ratio) => {
                    point.families.insert(name.clone(), vec![first.clone()]);
                    point.ratios.insert(name.clone(), ratio.clone());
                }
            }
        }
        for (name, value) in &path.determined {
            let value = point.number(value).ok()?;
            let fits = match &value {
                // The author's sample may give a value to a natural number.
                Number::Exact(q) => !self.base.naturals.contains(name) || is_natural(q),
                // Rational numbers are easier to read, but of angles and logarithms they are few.
                Number::Between(..) => {
                    path.is_irrational && !self.base.naturals.contains(name) && value.written().is_some()
                }
            };
            if !fits {
                return None;
            }
            point.give(name, value);
        }
        for family in self.base.recurrences.keys() {
            let list = point.families.remove(family).unwrap_or_default();
            point.ratios.remove(family);
            point.begin(family, &list).ok()?;
        }
        // Where the first step has a value all have.
        for (family, recurrence) in self.base.recurrences.iter() {
            point.recurrent(family, recurrence.order).ok()?;
        }
        // A hypothesis that divides says that the divisor is not 0, wherever in it it stands.
        self.hypotheses.iter().all(|h| !point.undefined(h) && point.truth(h) == Ok(true)).then_some(point)
    }
}

/// Whether an exponential or a logarithm stands in an expression, or no name at all.
fn is_transcendental(e: &Expr) -> bool {
    let mut names = BTreeSet::new();
    names_in(e, &mut names);
    names.iter().all(|name| is_built_in(name)) || names.contains("exp") || names.contains("ln")
}

fn is_natural(q: &Rational) -> bool {
    *q >= 0 && *q.denominator_ref() == 1u32
}

/// Calls `visit` with ranks below these sizes, those with a small sum first, until it says to stop.
fn in_order(sizes: &[usize], visit: &mut dyn FnMut(&[usize]) -> bool) {
    if sizes.contains(&0) {
        return;
    }
    // What the places from each one on can take up.
    let mut room = vec![0; sizes.len() + 1];
    for (place, size) in sizes.iter().enumerate().rev() {
        room[place] = room[place + 1] + size - 1;
    }
    let mut ranks = vec![0; sizes.len()];
    let _ = (0..=room[0]).any(|sum| shared(sum, 0, sizes, &room, &mut ranks, visit));
}

/// All ways to share a sum among the places from this one on.
fn shared(
    sum: usize,
    place: usize,
    sizes: &[usize],
    room: &[usize],
    ranks: &mut [usize],
    visit: &mut dyn FnMut(&[usize]) -> bool,
) -> bool {
    let Some(size) = sizes.get(place) else { return visit(ranks) };
    (sum.saturating_sub(room[place + 1])..=sum.min(size - 1)).any(|rank| {
        ranks[place] = rank;
        shared(sum - rank, place + 1, sizes, room, ranks, visit)
    })
}

pub(super) fn as_point(statement: &Statement, point: &Assignment) -> Point {
    let mut values = Vec::new();
    let mut named: Vec<String> = Vec::new();
    for binding in &statement.bindings {
        named.extend(binding.names.iter().filter(|n| n.1.is_none()).map(|n| n.0.text.clone()));
    }
    let mut others: Vec<&String> = point.values.keys().chain(point.numbers.keys()).collect();
    others.retain(|name| !named.contains(name));
    others.sort();
    for name in named.iter().chain(others) {
        if let Some(q) = point.values.get(name) {
            values.push((name.clone(), q.to_string()));
        } else if let Some(value) = point.numbers.get(name).and_then(Number::written) {
            values.push((name.clone(), print::expr(&value)));
        }
    }
    for ((name, index), q) in point.seen.borrow().iter() {
        values.push((format!("{name}({index})"), q.to_string()));
    }
    Point { values }
}

/// How a statement is searched: its expressions as the kernel reads them, and ways to satisfy its equations.
pub(super) struct Plan {
    pub(super) reading: Option<Reading>,
    pub(super) ways: Vec<Way>,
}

impl Plan {
    /// The plan of a statement.
    pub(super) fn of(statement: &Statement) -> Plan {
        let mut plan = Plan { reading: reading(statement), ways: vec![Vec::new()] };
        if let Some(reading) = &mut plan.reading {
            let search = Search::new(&statement.bindings, Some(statement));
            plan.ways = ways(reading, &search.hypotheses, &search.real());
        }
        plan
    }
}

/// A reader for the variables of a statement, and those that quantifiers in front of its goal bind.
fn reading(statement: &Statement) -> Option<Reading> {
    let (mut all, mut goal) = (statement.bindings.clone(), &statement.goal);
    loop {
        goal = match &goal.kind {
            PropKind::ForAll(bindings, body) => {
                all.extend(bindings.iter().cloned());
                body
            }
            PropKind::Extremum(e) => {
                all.extend(e.over.iter().cloned());
                break;
            }
            _ => break,
        };
    }
    Reading::of(statement, &all).or_else(|| Reading::of(statement, &statement.bindings))
}
