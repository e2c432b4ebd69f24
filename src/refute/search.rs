//! Search for exact points at which the hypotheses hold.
//!
//! Contract: a visited point satisfies every hypothesis exactly and certainly. Points are tried in order of simplicity, so
//! the first is small: 0, 1, 2, 1/2, … Variables that the hypotheses determine are computed, not guessed.

use super::Moment;
use super::evaluate::{Assignment, STEPS};
use super::expand::Statement;
use super::outcome::Point;
use super::reading::Reading;
use super::recurrence::recurrences;
use super::solve::{Way, ways};
use crate::claim::syntax::*;
use crate::kernel::statement::{constraints, domain, name};
use crate::number::rational;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::conversion::traits::IsInteger;
use std::cell::Cell;
use std::collections::BTreeSet;
use std::rc::Rc;

/// Real values in order of simplicity; the perfect powers among them make roots rational.
const REALS: &[&str] = &[
    "1", "2", "1/2", "0", "3", "4", "1/4", "-1", "-1/2", "1/3", "9", "8", "64", "3/2", "3/4", "1/8", "9/10", "16",
    "1/9", "-2", "1/10", "27", "1/64", "10", "81", "99/100", "100", "729",
];

/// How many points are tried.
const POINTS: usize = 6_000;

/// How many points of those that a claim suggests.
const SUGGESTED: usize = 2_500;

/// A search over points.
pub(super) struct Search {
    /// The variables that are free to choose, and whether each is a natural number.
    pub(super) names: Vec<(String, bool)>,
    /// All variables as they are declared.
    order: Vec<String>,
    values: Vec<Vec<Rational>>,
    /// The families with what their members obey.
    pub(super) families: Vec<(String, bool, Vec<Prop>)>,
    /// Variables that are computed from the others.
    determined: Way,
    /// Ways to satisfy the equations.
    pub(super) ways: Vec<Way>,
    /// Whether families are geometric where their domains allow it, or run through listed values.
    pub(super) geometric: bool,
    /// Values for reals and naturals that the claim suggests, instead of the usual ones.
    pub(super) suggested: Option<[Vec<Rational>; 2]>,
    /// What holds at a point.
    pub(super) hypotheses: Vec<Prop>,
    /// What all points have in common.
    pub(super) base: Assignment,
    /// How many expressions may still be evaluated.
    pub(super) left: Cell<u64>,
}

/// What is chosen at a point: the free variables and the families, in the order of the search.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
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

impl Search {
    pub(super) fn new(bindings: &[Binding], statement: Option<&Statement>) -> Search {
        let mut search = Search {
            names: Vec::new(),
            order: Vec::new(),
            values: Vec::new(),
            families: Vec::new(),
            determined: Vec::new(),
            ways: vec![Vec::new()],
            geometric: false,
            suggested: None,
            hypotheses: Vec::new(),
            base: Assignment::default(),
            left: Cell::new(u64::MAX),
        };
        if let Some(statement) = statement {
            for sequence in &statement.sequences {
                search.base.sequences.insert(sequence.name.clone(), sequence.clone());
            }
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
                        self.base.ranges.insert(name.text.clone(), range.clone());
                    }
                } else {
                    self.names.push((name.text.clone(), binding.natural));
                    self.order.push(name.text.clone());
                }
            }
            self.hypotheses.extend(domain(binding));
        }
    }

    /// Computes from the others what this way of satisfying the equations gives.
    fn follow(&mut self, way: Way) {
        let natural = &self.base.naturals;
        let before = std::mem::replace(&mut self.determined, way);
        self.names.extend(before.into_iter().map(|d| (d.0.clone(), natural.contains(&d.0))));
        let is_parameter = |name: &str, value: &Expr| {
            let mut inside = BTreeSet::new();
            crate::claim::walk::names_in(value, &mut inside);
            inside.contains(name)
        };
        self.names.retain(|n| !self.determined.iter().any(|d| d.0 == n.0 && !is_parameter(&n.0, &d.1)));
        self.names.sort_by_key(|n| self.order.iter().position(|name| *name == n.0));
        self.names.dedup();
    }

    /// Follows the first way on which there is a point, if there is one.
    pub(super) fn follow_a_way_with_points(&mut self) {
        for way in self.ways.clone() {
            self.follow(way);
            if self.run_choices(None, &mut |_, _| true) {
                return;
            }
        }
    }

    /// Candidate values for each variable, the first `most` of those that its own constant bounds allow.
    fn candidates(&mut self, most: usize) {
        let [reals, naturals] = self.suggested.clone().unwrap_or_else(|| {
            [REALS.iter().filter_map(|t| rational::parse(t).ok()).collect(), (0..8).map(Rational::from).collect()]
        });
        let mentioned: Vec<BTreeSet<String>> = self.hypotheses.iter().map(super::names::names_of_prop).collect();
        let kept = |name: &String, natural: bool, fits: &dyn Fn(&Assignment) -> bool| {
            let all = if natural { &naturals } else { &reals };
            let allowed = |value: &&Rational| {
                let mut alone = Assignment { naturals: self.base.naturals.clone(), ..Assignment::default() };
                alone.values.insert(name.clone(), (*value).clone());
                fits(&alone)
            };
            all.iter().filter(allowed).take(most).cloned().collect()
        };
        let mut values: Vec<Vec<Rational>> = Vec::new();
        for (name, natural) in &self.names {
            // Hypotheses without the name say the same whatever its value is; those with others mostly nothing yet.
            let own: Vec<&Prop> =
                self.hypotheses.iter().zip(&mentioned).filter(|h| h.1.contains(name)).map(|h| h.0).collect();
            values.push(kept(name, *natural, &|alone| own.iter().all(|h| alone.truth(h) != Ok(false))));
        }
        for (name, natural, domain) in &self.families {
            values.push(kept(name, *natural, &|alone| domain.iter().all(|h| alone.truth(h) == Ok(true))));
        }
        self.values = values;
    }

    /// Calls `visit` with points where the hypotheses hold, simple ones first, until it returns true.
    pub(super) fn run(&mut self, deadline: Option<Moment>, visit: &mut dyn FnMut(&Assignment) -> bool) -> bool {
        self.ways.clone().into_iter().any(|way| {
            self.follow(way);
            self.run_choices(deadline, &mut |_, point| visit(point))
        })
    }

    /// The same, with what was chosen.
    pub(super) fn run_choices(
        &mut self,
        deadline: Option<Moment>,
        visit: &mut dyn FnMut(&Choice, &Assignment) -> bool,
    ) -> bool {
        let mut visit = |search: &Search, ranks: &[usize]| {
            let choice = search.chosen(ranks);
            let Some(point) = search.at(&choice) else { return false };
            let before = point.steps.get();
            let done = visit(&choice, &point);
            search.spend(before - point.steps.get());
            done
        };
        // The simplest point needs the first value of each only, and mostly it is enough.
        self.candidates(1);
        let width = self.values.len();
        if self.values.iter().any(Vec::is_empty) {
            return false;
        }
        if visit(self, &vec![0; width]) {
            return true;
        }
        self.candidates(usize::MAX);
        let largest: usize = self.values.iter().map(|v| v.len() - 1).sum();
        let mut tried = 1;
        for total in 1..=largest {
            let mut ranks = vec![0usize; width];
            let mut stack = vec![(0usize, total)];
            // All ways to share `total` among the variables.
            while let Some((place, _)) = stack.last().copied() {
                let used: usize = ranks[..place].iter().sum();
                let left = total - used;
                if place == width {
                    stack.pop();
                    if left == 0 {
                        tried += 1;
                        if tried > if self.suggested.is_some() { SUGGESTED } else { POINTS } {
                            return false;
                        }
                        if self.left.get() == 0 || deadline.is_some_and(|deadline| Moment::now() > deadline) {
                            return false;
                        }
                        if visit(self, &ranks) {
                            return true;
                        }
                    }
                    // Advance the last place that can grow.
                    while let Some((place, _)) = stack.pop() {
                        let used: usize = ranks[..place].iter().sum();
                        let room = (total - used).min(self.values[place].len() - 1);
                        if ranks[place] < room {
                            ranks[place] += 1;
                            stack.push((place, total));
                            stack.push((place + 1, total));
                            if place + 1 < width {
                                ranks[place + 1] = self.least(&ranks, place + 1, total);
                            }
                            break;
                        }
                        ranks[place] = 0;
                    }
                    continue;
                }
                ranks[place] = self.least(&ranks, place, total);
                stack.push((place + 1, total));
            }
        }
        false
    }

    /// The least rank here such that the places after it can still take up the rest.
    fn least(&self, ranks: &[usize], place: usize, total: usize) -> usize {
        let used: usize = ranks[..place].iter().sum();
        let after: usize = self.values[place + 1..].iter().map(|v| v.len() - 1).sum();
        (total - used).saturating_sub(after).min(self.values[place].len() - 1)
    }

    /// The values at these ranks.
    fn chosen(&self, ranks: &[usize]) -> Choice {
        let (of_names, of_families) = ranks.split_at(self.names.len());
        let scalars = of_names.iter().zip(&self.values).map(|(rank, values)| values[*rank].clone()).collect();
        let values = &self.values[self.names.len()..];
        let families = self.families.iter().zip(of_families.iter().zip(values)).map(|(family, (rank, values))| {
            let ratio = Rational::from_signeds([2, 1, 3][rank % 3], [1, 2, 1][rank % 3]);
            let first = values[*rank].clone();
            if self.geometric && self.may_be_geometric(family, &first, &ratio) {
                return Members::Geometric(first, ratio);
            }
            // Members run through the values in turn, starting at the rank.
            let in_turn = (0..values.len().min(5)).map(|k| values[(rank + k * rank) % values.len()].clone());
            Members::InTurn(in_turn.collect())
        });
        Choice { scalars, families: families.collect() }
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
            let mut alone = Assignment { naturals: self.base.naturals.clone(), ..Assignment::default() };
            alone.values.insert(name.clone(), first * ratio.pow(k));
            domain.iter().all(|h| alone.truth(h) == Ok(true))
        };
        plain && whole && (0..24).chain([super::number::LARGEST + 1]).all(allowed)
    }

    /// The point of a choice, with what the hypotheses determine, if they all hold there for certain.
    pub(super) fn at(&self, choice: &Choice) -> Option<Assignment> {
        let steps = Rc::new(Cell::new(STEPS));
        let point = self.at_with(choice, steps.clone());
        self.spend(STEPS - steps.get());
        point
    }

    /// Counts expressions that were evaluated, and the point itself.
    fn spend(&self, expressions: u32) {
        self.left.set(self.left.get().saturating_sub(1 + u64::from(expressions)));
    }

    fn at_with(&self, choice: &Choice, steps: Rc<Cell<u32>>) -> Option<Assignment> {
        let mut point = Assignment { steps, members: Rc::default(), ..self.base.clone() };
        for ((name, _), value) in self.names.iter().zip(&choice.scalars) {
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
        for (name, value) in &self.determined {
            match point.number(value) {
                Ok(super::number::Number::Exact(q)) => {
                    point.values.insert(name.clone(), q);
                }
                _ => return None,
            }
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

pub(super) fn as_point(statement: &Statement, point: &Assignment) -> Point {
    let mut values = Vec::new();
    let mut named: Vec<String> = Vec::new();
    for binding in &statement.bindings {
        named.extend(binding.names.iter().filter(|n| n.1.is_none()).map(|n| n.0.text.clone()));
    }
    for name in &named {
        if let Some(q) = point.values.get(name) {
            values.push((name.clone(), q.to_string()));
        }
    }
    let mut others: Vec<&String> = point.values.keys().filter(|k| !named.contains(k)).collect();
    others.sort();
    for name in others {
        values.push((name.clone(), point.values[name].to_string()));
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
        let mut plan = Plan::in_its_own_words(statement);
        if let Some(reading) = &mut plan.reading {
            let search = Search::new(&statement.bindings, Some(statement));
            let real: Vec<String> = search.names.into_iter().filter(|n| !n.1).map(|n| n.0).collect();
            plan.ways = ways(reading, &search.hypotheses, &real);
        }
        plan
    }

    /// A plan that solves no equation.
    pub(super) fn in_its_own_words(statement: &Statement) -> Plan {
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
        let reading = Reading::of(statement, &all).or_else(|| Reading::of(statement, &statement.bindings));
        Plan { reading, ways: vec![Vec::new()] }
    }
}
