//! The points at which a claim is tried, in one order for every command.
//!
//! Contract: all hypotheses hold exactly and certainly at every point. The points of a claim and a seed are always the same; a
//! limit of time or of expressions ends them earlier.
//!
//! The order: the author's sample; small values; angles at multiples of π; the edges of the claim (`edges`), where chance finds nothing; members of
//! families in geometric progression; far values; values that the claim suggests; more of all these; points drawn at random.

use super::Moment;
use super::candidates::Values;
use super::draw::{Below, Drawing};
use super::edges::edges;
use super::evaluate::Assignment;
use super::expand::Statement;
use super::random::Random;
use super::reading::Reading;
use super::search::{Choice, Round, Search, Visit};
use super::{solve, turns};
use crate::claim::syntax::*;
use std::collections::VecDeque;
use std::ops::Range;
use std::rc::Rc;
use std::time::Duration;

/// How many points of a path with small values are looked at.
pub(super) const SMALL: usize = 6_000;

/// How many of them before the edges.
const FEW: usize = 300;

/// The part of the work before a proof that edges have for themselves.
const EDGES: u64 = 4;

/// How many points of a path with angles at multiples of π are looked at.
pub(super) const TURNED: usize = 1_500;

/// How many points of each edge, and of the author's sample.
const EDGE: usize = 24;

/// How many far points of a path.
const FAR: usize = 200;

/// How many points of those that a claim suggests.
pub(super) const SUGGESTED: usize = 2_500;

/// How often a point is drawn until the hypotheses hold.
const DRAWS: usize = 100;

/// How many points an audit draws at random.
pub const RANDOM: u32 = 256;

/// Of how many random points one lies on an edge.
const ON_AN_EDGE: u64 = 4;

/// How far a claim is tried.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Before a proof is sought: the number of expressions that are evaluated for the first points, and the longest time.
    pub first: Option<(u64, Duration)>,
    /// When to stop.
    pub deadline: Option<Moment>,
    /// How many points are drawn at random.
    pub random: u32,
    /// The seed of the random numbers.
    pub seed: u64,
}

impl Effort {
    /// All points of an audit.
    pub fn whole(deadline: Option<Moment>) -> Effort {
        Effort { first: None, deadline, random: RANDOM, seed: 0 }
    }
}

/// Where points are kinds of their own: a counterexample that is not small is made smaller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Origin {
    /// The author's sample, and small values.
    Small,
    /// Any other list, an edge, or chance.
    Other,
}

/// The points of one claim.
pub(super) struct Points {
    statement: Rc<Statement>,
    reading: Option<Reading>,
    pub(super) search: Search,
    /// What is to hold at them.
    goal: Prop,
    /// The path of the author's sample, if there is one.
    sample: Range<usize>,
    /// The ways to satisfy the hypotheses, and the premise of the goal.
    held: Range<usize>,
    /// The same with angles at multiples of π, and the values for these.
    turned: Range<usize>,
    turns: Values,
    /// The edges that are still to be solved, once they were collected. All later paths of the search lie on edges.
    open: Option<VecDeque<Prop>>,
    drawing: Drawing,
    small: Values,
    others: Option<Others>,
}

/// Lists that most claims do not need.
struct Others {
    edge: Values,
    far: Values,
    suggested: Values,
}

impl Points {
    /// The points of a goal. The paths of the search are the ways to satisfy the hypotheses.
    pub(super) fn new(
        statement: Rc<Statement>,
        mut reading: Option<Reading>,
        mut search: Search,
        goal: Prop,
    ) -> Points {
        let held = 0..search.paths.len();
        let sample = match statement.sample.as_slice() {
            [] => held.end..held.end,
            given => search.follow(&[given.to_vec()]),
        };
        let angles = turns::angles(&search, &goal);
        let turned = turns::follow(&mut search, held.clone(), &angles, reading.as_mut());
        let turns = Values::turned(angles);
        let drawing = Drawing::of(&search, &goal);
        let small = Values::usual();
        Points {
            statement,
            reading,
            search,
            goal,
            sample,
            held,
            turned,
            turns,
            open: None,
            drawing,
            small,
            others: None,
        }
    }

    /// Visits points in their order, until a visit says to stop; whether one did.
    pub(super) fn each(
        &mut self,
        effort: &Effort,
        visit: &mut dyn FnMut(Origin, &Choice, &Assignment) -> bool,
    ) -> bool {
        let first = effort.first.and_then(|(_, time)| Moment::now().checked_add(time));
        self.search.until.set(first.into_iter().chain(effort.deadline).min());
        let most = effort.first.map_or(u64::MAX, |(most, _)| most);
        let more = Round { skip: FEW, ..Round::first(SMALL) };
        let geometric = |round: Round| Round { geometric: true, ..round };
        let mut visit_small: &mut Visit = &mut |choice, point| visit(Origin::Small, choice, point);
        // Edges have a part of the work for themselves.
        self.search.left.set(most - most / EDGES);
        let (sample, held) = (self.sample.clone(), self.held.clone());
        if self.search.run(sample, &mut self.small, Round::first(EDGE), &mut visit_small)
            || self.search.run(held.clone(), &mut self.small, Round::first(FEW), &mut visit_small)
        {
            return true;
        }
        let mut visit: &mut Visit = &mut |choice, point| visit(Origin::Other, choice, point);
        // Angles have work and time of their own: what fails at multiples of π alone is mostly neither found nor proved otherwise.
        if !self.turned.is_empty() {
            self.search.left.set(self.search.left.get().saturating_add(most));
            let more = effort.first.and_then(|(_, time)| Moment::now().checked_add(time));
            self.search.until.set(more.into_iter().chain(effort.deadline).min());
            if self.search.run(self.turned.clone(), &mut self.turns, Round::first(TURNED), &mut visit) {
                return true;
            }
            self.search.left.set(0);
        }
        self.search.left.set(self.search.left.get().saturating_add(most / EDGES));
        let edges = self.edges();
        let statement = &self.statement;
        let Others { edge, far, suggested } = self.others.get_or_insert_with(|| Others {
            edge: Values::small(statement),
            far: Values::far(statement),
            suggested: Values::suggested(statement),
        });
        let (search, small) = (&self.search, &mut self.small);
        let families = !search.families.is_empty();
        if search.run(edges, edge, Round::first(EDGE), &mut visit)
            || families && search.run(held.clone(), small, geometric(Round::first(FEW)), &mut visit)
            || search.run(held.clone(), far, Round::first(FAR), &mut visit)
            || search.run(held.clone(), suggested, Round::first(SUGGESTED), &mut visit)
            || search.run(held.clone(), small, more, &mut visit)
            || families && search.run(held, small, geometric(more), &mut visit)
        {
            return true;
        }
        let mut random = Random::of(&self.statement.name, effort.seed);
        (0..effort.random).any(|_| {
            let mut draws = (0..DRAWS).take_while(|_| !self.search.is_over());
            let drawn = draws.find_map(|_| self.drawn(&mut |bound| random.below(bound)));
            drawn.is_some_and(|(choice, point)| visit(&choice, &point))
        })
    }

    /// The paths of the edges; those found so far where the time ends.
    fn edges(&mut self) -> Range<usize> {
        let Some(reading) = &mut self.reading else { return self.turned.end..self.turned.end };
        let open = self.open.get_or_insert_with(|| {
            let whole = |name: &str| self.search.base.naturals.contains(name);
            edges(&self.goal, &self.search.hypotheses, &self.statement.sequences, &whole).into()
        });
        while !self.search.is_over()
            && let Some(edge) = open.pop_front()
        {
            let ways = solve::on_an_edge(reading, edge, &self.search.hypotheses, &self.search.real());
            self.search.follow(&ways);
        }
        self.on_edges()
    }

    /// The ways to lie on an edge that were found.
    fn on_edges(&self) -> Range<usize> {
        self.turned.end..self.search.paths.len()
    }

    /// A random choice where the hypotheses hold, if one is found.
    pub(super) fn random(&self, below: Below<'_>) -> Option<Choice> {
        (0..DRAWS).find_map(|_| self.drawn(below)).map(|drawn| drawn.0)
    }

    /// One random choice with its point; `None` where the hypotheses do not hold.
    pub(super) fn drawn(&self, below: Below<'_>) -> Option<(Choice, Assignment)> {
        let edges = self.on_edges();
        let on_an_edge = !edges.is_empty() && below(ON_AN_EDGE) == 0;
        let paths = if on_an_edge { edges } else { self.held.clone() };
        let path = paths.clone().nth(usize::try_from(below(paths.len() as u64)).ok()?)?;
        let choice = self.drawing.drawn(&self.search, path, below).filter(|choice| self.search.may_be(choice))?;
        let point = self.search.at(&choice)?;
        Some((choice, point))
    }

    /// The statement.
    pub(super) fn statement(&self) -> &Rc<Statement> {
        &self.statement
    }

    /// How expressions are read.
    pub(super) fn reading(&mut self) -> Option<&mut Reading> {
        self.reading.as_mut()
    }
}
