//! Search for exact points: where the hypotheses hold, and where the goal then fails.
//!
//! Contract: a returned point satisfies every hypothesis exactly and certainly, and the goal is
//! certainly false there or has no value. Points are tried in order of simplicity, so the first is
//! small: 0, 1, 2, 1/2, … Variables that the hypotheses determine are computed, not guessed.

use super::Moment;
use super::evaluate::{Assignment, STEPS};
use super::expand::Statement;
use super::limit::{Tends, tends};
use super::number::Missing;
use super::outcome::{Broken, Point, Witness};
use super::reading::Reading;
use super::recurrence::recurrences;
use super::solve::{Way, ways};
use crate::claim::print;
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, constraints, domain, name};
use crate::number::rational;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::conversion::traits::IsInteger;
use rustc_hash::FxHashSet as HashSet;
use std::cell::Cell;
use std::collections::BTreeSet;
use std::rc::Rc;
use std::time::Duration;

/// Real values in order of simplicity; the perfect powers among them make roots rational.
const REALS: &[&str] = &[
    "1", "2", "1/2", "0", "3", "4", "1/4", "-1", "-1/2", "1/3", "9", "8", "64", "3/2", "3/4", "1/8", "9/10", "16",
    "1/9", "-2", "1/10", "27", "1/64", "10", "81", "99/100", "100", "729",
];

/// How many points are tried.
const POINTS: usize = 6_000;

/// How many points of those that a claim suggests.
const SUGGESTED: usize = 2_500;

/// At how many points limits are found anew.
const LIMITS: usize = 60;

/// At how many of them before a proof is sought.
const FIRST_LIMITS: usize = 4;

/// How long points are tried before a proof is sought.
const FIRST_TIME: Duration = Duration::from_millis(100);

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
    ways: Vec<Way>,
    /// Whether families are geometric where their domains allow it, or run through listed values.
    geometric: bool,
    /// Values for reals and naturals that the claim suggests, instead of the usual ones.
    suggested: Option<[Vec<Rational>; 2]>,
    /// What holds at a point.
    pub(super) hypotheses: Vec<Prop>,
    /// What all points have in common.
    pub(super) base: Assignment,
    /// How many expressions may still be evaluated.
    left: Cell<u64>,
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
    fn new(bindings: &[Binding], statement: Option<&Statement>) -> Search {
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

    fn declare(&mut self, bindings: &[Binding]) {
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
        let mentioned: Vec<BTreeSet<String>> = self.hypotheses.iter().map(super::expand::names_of_prop).collect();
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
    fn run(&mut self, deadline: Option<Moment>, visit: &mut dyn FnMut(&Assignment) -> bool) -> bool {
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
    fn in_its_own_words(statement: &Statement) -> Plan {
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

/// A point where all hypotheses of the statement hold: one that the author gives, or one that is found.
pub(super) fn sample(plan: &mut Plan, statement: &Statement, deadline: Option<Moment>) -> Option<Point> {
    if !statement.sample.is_empty()
        && let Some(point) = given_sample(statement, deadline)
    {
        return Some(point);
    }
    let mut search = Search::new(&statement.bindings, Some(statement));
    search.ways = plan.ways.clone();
    let mut found = None;
    let mut visit = |point: &Assignment| {
        found = Some(as_point(statement, point));
        true
    };
    if !search.run(deadline, &mut visit) {
        search.suggested = Some(super::candidates::suggested(statement, &statement.goal));
        search.run(deadline, &mut visit);
    }
    found
}

/// The author's point, where the hypotheses hold at it; variables without a value there are sought.
fn given_sample(statement: &Statement, deadline: Option<Moment>) -> Option<Point> {
    let mut search = Search::new(&statement.bindings, Some(statement));
    search.ways = vec![statement.sample.clone()];
    let mut found = None;
    search.run(deadline, &mut |point| {
        found = Some(as_point(statement, point));
        true
    });
    found
}

/// A goal made ready to be looked at, point by point.
pub(super) struct Goal {
    /// What is to hold, with derivatives carried out where that succeeds.
    pub(super) prop: Prop,
    /// The same as the claim says it, where a derivative was carried out.
    said: Option<Prop>,
    identities: Rc<HashSet<(String, String)>>,
    limits_left: usize,
}

/// What a goal is at a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Seen {
    /// It certainly holds.
    Holds,
    /// It certainly fails, or has no value.
    Fails(Vec<Broken>),
    /// The point does not decide it.
    Open,
}

/// The points of a statement and its goal at them; `None` where a point says nothing of what moves.
pub(super) fn aimed(plan: &mut Plan, statement: &Statement) -> Option<(Search, Goal)> {
    let mut search = Search::new(&statement.bindings, Some(statement));
    search.ways = plan.ways.clone();
    let (mut goal, mut bound) = (statement.goal.clone(), statement.bindings.clone());
    // Quantifiers in front and the variables of an extremum are searched like the others.
    loop {
        goal = match goal.kind {
            PropKind::ForAll(bindings, body) => {
                search.declare(&bindings);
                bound.extend(bindings);
                *body
            }
            PropKind::Extremum(extremum) => {
                let mut at = super::expand::Substitution::default();
                for (name, value) in &extremum.at {
                    at.replace(&name.text, value.clone());
                }
                let there = at.expr(&extremum.of).ok()?;
                search.declare(&extremum.over);
                bound.extend(extremum.over.iter().cloned());
                let relation = if extremum.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
                let mut list = vec![
                    compare(there, Relation::Equal, extremum.value.clone()),
                    compare(extremum.of.clone(), relation, extremum.value.clone()),
                ];
                if extremum.unique {
                    let same =
                        extremum.at.iter().map(|(n, e)| compare(name(&n.text), Relation::Equal, e.clone())).collect();
                    let equal = compare(extremum.of, Relation::Equal, extremum.value);
                    let kind = PropKind::Implies(
                        Box::new(equal),
                        Box::new(Prop { kind: PropKind::And(same), span: goal.span }),
                    );
                    list.push(Prop { kind, span: goal.span });
                }
                Prop { kind: PropKind::And(list), span: goal.span }
            }
            kind => {
                goal = Prop { kind, span: goal.span };
                break;
            }
        };
    }
    if ties_what_moves(statement, &bound, &goal) {
        return None;
    }
    // Where a premise has equations, the points at which it holds are tried first.
    if let (PropKind::Implies(premise, _), Some(reading)) = (&goal.kind, &mut plan.reading) {
        let real: Vec<String> = search.names.iter().filter(|n| !n.1).map(|n| n.0.clone()).collect();
        let held: Vec<Prop> = search.hypotheses.iter().cloned().chain([(**premise).clone()]).collect();
        let solved = ways(reading, &held, &real);
        if solved != search.ways {
            search.ways.splice(0..0, solved);
        }
    }
    let mut said = None;
    if let Some(reading) = &mut plan.reading
        && differs(&goal)
    {
        let plain = without_derivatives(reading, &goal);
        said = Some(std::mem::replace(&mut goal, plain));
    }
    Some((search, Goal { prop: goal, said, identities: Rc::default(), limits_left: LIMITS }))
}

impl Goal {
    /// Finds the comparisons whose sides are one: intervals cannot tell that they are equal.
    pub(super) fn identify(&mut self, plan: &mut Plan) {
        if let Some(reading) = &mut plan.reading {
            self.identities = Rc::new(identities(reading, &self.prop));
        }
    }

    /// What it is at a point, which keeps the members of families that were looked up.
    pub(super) fn at(&mut self, point: &Assignment) -> Seen {
        point.seen.borrow_mut().clear();
        let here = Assignment { identities: self.identities.clone(), ..point.clone() };
        let mut broken = Vec::new();
        let truth = if has_limit(&self.prop) {
            self.limits_left = self.limits_left.saturating_sub(1);
            with_limits(&here, &self.prop, self.limits_left > 0, &mut broken)
        } else {
            here.truth(&self.prop)
        };
        let seen = match truth {
            Ok(true) => Seen::Holds,
            Ok(false) => {
                if !has_limit(&self.prop) {
                    here.broken(&self.prop, &mut broken);
                }
                Seen::Fails(broken)
            }
            Err(Missing::Undefined(text)) if self.is_undefined_as_said(&here) => {
                Seen::Fails(vec![Broken { statement: text, left: "no value".to_string(), right: String::new() }])
            }
            Err(_) => Seen::Open,
        };
        point.seen.replace(here.seen.take());
        seen
    }

    /// Whether the goal has no value in the claim's own words: the formula of a derivative may have none where the
    /// derivative has one.
    fn is_undefined_as_said(&self, here: &Assignment) -> bool {
        self.said.as_ref().is_none_or(|said| matches!(here.truth(said), Err(Missing::Undefined(_))))
    }
}

/// The truth of a goal that says limits, and what of it fails; limits are left open unless `sought`.
fn with_limits(
    here: &Assignment,
    prop: &Prop,
    sought: bool,
    broken: &mut Vec<Broken>,
) -> std::result::Result<bool, Missing> {
    match &prop.kind {
        PropKind::And(list) => {
            let parts: Vec<_> = list.iter().map(|p| with_limits(here, p, sought, broken)).collect();
            match parts.iter().find(|p| **p != Ok(true)) {
                _ if parts.contains(&Ok(false)) => Ok(false),
                Some(Err(missing)) => Err(missing.clone()),
                _ => Ok(true),
            }
        }
        PropKind::Limit(limit) if sought => {
            let value = here.number(&limit.value)?;
            let left = match tends(here, limit).ok_or(Missing::Unknown)? {
                Tends::Infinitely => "no limit".to_string(),
                Tends::To(found) => match found.order(&value) {
                    None => return Err(Missing::Unknown),
                    Some(std::cmp::Ordering::Equal) => return Ok(true),
                    _ => found.text(),
                },
            };
            broken.push(if left == "no limit" {
                let statement = "the expression grows beyond every bound: it has no finite limit".to_string();
                Broken { statement, left, right: String::new() }
            } else {
                Broken { statement: print::prop(prop), left, right: value.text() }
            });
            Ok(false)
        }
        PropKind::Limit(_) => Err(Missing::Unknown),
        _ => {
            let truth = here.truth(prop);
            if truth == Ok(false) {
                here.broken(prop, broken);
            }
            truth
        }
    }
}

/// A counterexample to the statement, among all points or those that are tried with `most` expressions evaluated; and at
/// how many points the goal was seen to hold.
pub(super) fn falsified_by(
    statement: &Statement,
    search: &mut Search,
    goal: &mut Goal,
    most: Option<u64>,
    deadline: Option<Moment>,
) -> (Option<Witness>, usize) {
    let (mut found, mut held) = (None, 0);
    let first = most.and_then(|_| Moment::now().checked_add(FIRST_TIME));
    let deadline = deadline.into_iter().chain(first).min();
    search.left.set(most.unwrap_or(u64::MAX));
    search.geometric = false;
    goal.limits_left = if most.is_some() { FIRST_LIMITS } else { LIMITS };
    let mut visit = |point: &Assignment| match goal.at(point) {
        Seen::Fails(broken) => {
            found = Some(Witness { point: as_point(statement, point), broken });
            true
        }
        Seen::Holds => {
            held += 1;
            false
        }
        Seen::Open => false,
    };
    let mut done = search.run(deadline, &mut visit);
    if !done && !search.families.is_empty() {
        search.geometric = true;
        done = search.run(deadline, &mut visit);
        search.geometric = false;
    }
    if !done {
        search.suggested = Some(super::candidates::suggested(statement, &statement.goal));
        search.run(deadline, &mut visit);
    }
    (found, held)
}

/// A counterexample found by the evaluator and the statement's own words alone. For tests of soundness; a search of all
/// points may take minutes, unless `time` ends it.
pub fn falsified(statement: &Statement, time: Option<Duration>) -> Option<Witness> {
    let deadline = time.and_then(|time| Moment::now().checked_add(time));
    let mut plan = Plan::in_its_own_words(statement);
    let (mut search, mut goal) = aimed(&mut plan, statement)?;
    goal.identify(&mut plan);
    falsified_by(statement, &mut search, &mut goal, None, deadline).0
}

/// Values for the variables of an `exists` that make its body certainly true.
pub fn example(bindings: &[Binding], body: &Prop, deadline: Option<Moment>) -> Option<Vec<(String, Rational)>> {
    let mut search = Search::new(bindings, None);
    let names: Vec<String> = search.names.iter().map(|n| n.0.clone()).collect();
    let mut found = None;
    search.run(deadline, &mut |point| {
        if point.truth(body) != Ok(true) {
            return false;
        }
        found = Some(names.iter().filter_map(|n| Some((n.clone(), point.values.get(n)?.clone()))).collect());
        true
    });
    found
}

/// The proposition with derivatives carried out, where that succeeds: the evaluator knows none.
fn without_derivatives(reading: &mut Reading, prop: &Prop) -> Prop {
    let mut each = |list: &[Prop]| list.iter().map(|p| without_derivatives(reading, p)).collect::<Vec<_>>();
    let kind = match &prop.kind {
        PropKind::And(list) => PropKind::And(each(list)),
        PropKind::Or(list) => PropKind::Or(each(list)),
        PropKind::Equivalent(list) => PropKind::Equivalent(each(list)),
        PropKind::Implies(p, q) => {
            PropKind::Implies(Box::new(without_derivatives(reading, p)), Box::new(without_derivatives(reading, q)))
        }
        PropKind::Compare(sides, relations) => {
            let plain = |e: &Expr| if differentiates(e) { reading.plain(e) } else { None };
            let sides = sides.iter().map(plain).zip(sides).map(|(plain, e)| plain.unwrap_or_else(|| e.clone()));
            PropKind::Compare(sides.collect(), relations.clone())
        }
        other => other.clone(),
    };
    Prop { kind, span: prop.span }
}

/// Whether a comparison of a goal has a derivative in it.
fn differs(prop: &Prop) -> bool {
    match &prop.kind {
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().any(differs),
        PropKind::Implies(p, q) => differs(p) || differs(q),
        PropKind::Compare(sides, _) => sides.iter().any(differentiates),
        _ => false,
    }
}

/// The comparisons in a proposition whose two sides have one form: intervals cannot tell that they are equal.
fn identities(reading: &mut Reading, prop: &Prop) -> HashSet<(String, String)> {
    let mut found = HashSet::default();
    let mut open = vec![prop];
    while let Some(prop) = open.pop() {
        match &prop.kind {
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => open.extend(list),
            PropKind::Not(p) => open.push(p),
            PropKind::Implies(p, q) => open.extend([&**p, &**q]),
            PropKind::Compare(sides, _) => {
                for pair in sides.windows(2).filter(|pair| reading.same(&pair[0], &pair[1])) {
                    found.insert((print::expr(&pair[0]), print::expr(&pair[1])));
                }
            }
            _ => {}
        }
    }
    found
}

fn has_limit(prop: &Prop) -> bool {
    match &prop.kind {
        PropKind::And(list) => list.iter().any(has_limit),
        PropKind::Limit(_) => true,
        _ => false,
    }
}

/// Whether a hypothesis or a domain keeps the variable of a limit from growing or ties the variable of a derivative to
/// others: then what holds at a point says nothing of either.
fn ties_what_moves(statement: &Statement, bindings: &[Binding], goal: &Prop) -> bool {
    let (limit, derivative) = tied(statement, bindings, goal);
    limit || derivative.is_some()
}

/// The variable of a derivative in the goal that a hypothesis ties to others, if there is one. The derivative is partial
/// all the same, but a reader may think of another.
pub(super) fn tied_derivative(statement: &Statement) -> Option<String> {
    let (mut bindings, mut goal) = (statement.bindings.clone(), &statement.goal);
    while let PropKind::ForAll(more, body) = &goal.kind {
        bindings.extend(more.iter().cloned());
        goal = body;
    }
    // Parts of an equivalence are shown from one another by the kernel as they are read: partial.
    let mut premise = Vec::new();
    while let PropKind::Implies(p, q) = &goal.kind {
        premise.push((**p).clone());
        goal = q;
    }
    tied_by(statement, &bindings, goal, premise).1
}

/// Whether the variable of a limit is kept from growing, and the variable of a derivative that is tied to others.
fn tied(statement: &Statement, bindings: &[Binding], goal: &Prop) -> (bool, Option<String>) {
    let mut said = Vec::new();
    premises(goal, &mut said);
    tied_by(statement, bindings, goal, said)
}

/// The same, where the goal is said under no more than this.
fn tied_by(statement: &Statement, bindings: &[Binding], goal: &Prop, more: Vec<Prop>) -> (bool, Option<String>) {
    let (mut limits, mut derivatives) = (Vec::new(), Vec::new());
    moving(goal, &mut limits, &mut derivatives);
    if limits.is_empty() && derivatives.is_empty() {
        return (false, None);
    }
    let mut said = more;
    said.extend(statement.assumptions.iter().map(|a| a.1.clone()));
    said.extend(bindings.iter().flat_map(domain));
    let families = bindings.iter().filter(|b| b.names.iter().any(|n| n.1.is_some()));
    let of_families: BTreeSet<String> = families.flat_map(super::expand::names_of_binding).collect();
    let kept = |v: &String| of_families.contains(v) || !said.iter().all(|prop| lets_grow(prop, v));
    let bound = |v: &String| of_families.contains(v) || said.iter().any(|prop| ties(prop, v));
    (limits.iter().any(kept), derivatives.into_iter().find(bound))
}

/// What a part of a goal may be said under: premises, and the other parts of an equivalence or disjunction.
fn premises(goal: &Prop, into: &mut Vec<Prop>) {
    match &goal.kind {
        PropKind::And(list) => list.iter().filter(|p| speaks_of_what_moves(p)).for_each(|p| premises(p, into)),
        PropKind::Or(list) | PropKind::Equivalent(list) => {
            // One part of a disjunction is looked at where the others fail.
            for part in list.iter().filter(|p| !speaks_of_what_moves(p)) {
                into.push(part.clone());
                into.extend(negation(part));
            }
            list.iter().for_each(|p| premises(p, into));
        }
        PropKind::Implies(p, q) => {
            into.push((**p).clone());
            premises(q, into);
        }
        PropKind::Not(p) | PropKind::ForAll(_, p) | PropKind::Exists(_, p) => premises(p, into),
        PropKind::Compare(..) | PropKind::Extremum(_) | PropKind::Limit(_) => {}
    }
}

/// Whether a hypothesis says nothing of a variable, or only that it is above a number.
fn lets_grow(prop: &Prop, variable: &str) -> bool {
    if !super::expand::names_of_prop(prop).contains(variable) {
        return true;
    }
    let PropKind::Compare(sides, relations) = &prop.kind else { return false };
    sides.len() == 2
        && matches!(relations[0], Relation::Greater | Relation::GreaterEqual)
        && matches!(&sides[0].kind, ExprKind::Name(n) if *n == variable)
        && matches!(&sides[1].kind, ExprKind::Number(_))
}

/// Whether a hypothesis, other than a strict comparison, has a variable and another name in it: alone or with others it
/// may determine one by the other, as `x*y <= 1` and `x*y >= 1` do. Derivatives are partial all the same, all other
/// variables held fast; this only refuses to speak of them where a reader could think of another derivative.
fn ties(prop: &Prop, variable: &str) -> bool {
    let strict = [Relation::Less, Relation::Greater, Relation::NotEqual];
    let open = match &prop.kind {
        PropKind::Compare(_, relations) => relations.iter().all(|r| strict.contains(r)),
        _ => false,
    };
    let mut names = super::expand::names_of_prop(prop);
    names.retain(|name| !FUNCTIONS.iter().any(|f| f.0 == name));
    !open && names.contains(variable) && names.len() > 1
}

fn speaks_of_what_moves(prop: &Prop) -> bool {
    let (mut limits, mut derivatives) = (Vec::new(), Vec::new());
    moving(prop, &mut limits, &mut derivatives);
    !limits.is_empty() || !derivatives.is_empty()
}

/// The variables of limits and of derivatives.
fn moving(prop: &Prop, limits: &mut Vec<String>, derivatives: &mut Vec<String>) {
    fn by(e: &Expr, into: &mut Vec<String>) {
        if let ExprKind::Derivative(_, names) = &e.kind {
            into.extend(names.iter().map(|n| n.text.clone()));
        }
        super::expand::parts(e, &mut |part| by(part, into));
    }
    match &prop.kind {
        PropKind::Compare(sides, _) => sides.iter().for_each(|e| by(e, derivatives)),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| moving(p, limits, derivatives));
        }
        PropKind::Not(p) | PropKind::Exists(_, p) | PropKind::ForAll(_, p) => moving(p, limits, derivatives),
        PropKind::Implies(p, q) => {
            moving(p, limits, derivatives);
            moving(q, limits, derivatives);
        }
        PropKind::Extremum(extremum) => {
            [&extremum.of, &extremum.value].into_iter().for_each(|e| by(e, derivatives));
            extremum.at.iter().for_each(|(_, e)| by(e, derivatives));
        }
        PropKind::Limit(limit) => {
            limits.push(limit.variable.text.clone());
            by(&limit.of, derivatives);
            by(&limit.value, derivatives);
        }
    }
}

fn differentiates(e: &Expr) -> bool {
    let mut found = matches!(e.kind, ExprKind::Derivative(..));
    super::expand::parts(e, &mut |part| found |= differentiates(part));
    found
}

/// A rational as an expression.
pub fn literal(q: &Rational) -> Expr {
    let span = Span::default();
    let number = |text: String| Expr { kind: ExprKind::Number(text), span };
    let (top, bottom) = (number(q.numerator_ref().to_string()), number(q.denominator_ref().to_string()));
    let size = if *q.denominator_ref() == 1u32 {
        top
    } else {
        Expr { kind: ExprKind::Product(vec![(Factor::Times, top), (Factor::Over, bottom)]), span }
    };
    if *q < 0 { Expr { kind: ExprKind::Negate(Box::new(size)), span } } else { size }
}

/// The negation with `not` pushed inwards; `None` for extrema and limits.
fn negation(prop: &Prop) -> Option<Prop> {
    let span = prop.span;
    let kind = match &prop.kind {
        PropKind::Compare(sides, relations) => {
            let list: Vec<Prop> = sides
                .windows(2)
                .zip(relations)
                .map(|(pair, r)| Prop { kind: PropKind::Compare(pair.to_vec(), vec![r.negated()]), span })
                .collect();
            if let [one] = list.as_slice() {
                return Some(one.clone());
            }
            PropKind::Or(list)
        }
        PropKind::And(list) => PropKind::Or(list.iter().map(negation).collect::<Option<_>>()?),
        PropKind::Or(list) => PropKind::And(list.iter().map(negation).collect::<Option<_>>()?),
        PropKind::Not(inner) => return Some((**inner).clone()),
        PropKind::Implies(p, q) => PropKind::And(vec![(**p).clone(), negation(q)?]),
        PropKind::Equivalent(list) => {
            let [p, q] = list.as_slice() else { return None };
            let both = |a: Prop, b: Prop| Prop { kind: PropKind::And(vec![a, b]), span };
            PropKind::Or(vec![both(p.clone(), negation(q)?), both(negation(p)?, q.clone())])
        }
        PropKind::Exists(bindings, body) => PropKind::ForAll(bindings.clone(), Box::new(negation(body)?)),
        PropKind::ForAll(bindings, body) => PropKind::Exists(bindings.clone(), Box::new(negation(body)?)),
        PropKind::Extremum(_) | PropKind::Limit(_) => return None,
    };
    Some(Prop { kind, span })
}
