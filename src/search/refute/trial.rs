//! A claim tried at points: those of [`super::points`], or at choices of the caller.
//!
//! Contract: only points where every hypothesis certainly holds count. At a point the goal certainly holds, certainly fails, or
//! is left open: values are exact, or enclosed with [`super::number::PRECISION`] bits, so a failure is never noise.

pub use super::draw::Below;
use super::evaluate::Assignment;
use super::expand::{Limit, Statement};
use super::goal::{Goal, LIMITS, Seen, aimed};
use super::outcome::{Fault, Point, Witness};
use super::points::{Effort, Origin, Points};
use super::search::{Choice, Plan, as_point};
use super::shape;
use super::shrink::simpler;
use crate::claim::syntax::*;
use crate::claim::write_out::Words;
use std::rc::Rc;

/// The most times a failing point is made simpler.
const SHRINKING: usize = 200;

/// How many expressions are evaluated to make a failing point simpler.
const SHRUNK: u64 = 300_000;

/// How many points that leave a goal open are kept.
const OPEN: usize = 3;

/// At how many points limits are found anew before a proof is sought.
const FIRST_LIMITS: usize = 4;

/// Why a claim cannot be tried.
pub enum Untried {
    /// It makes no sense.
    Fault(Fault),
    /// A limit, by name.
    Limit(&'static str),
    /// What holds at a point says nothing: a derivative or a limit is about variables that hypotheses tie.
    Moves,
}

/// What came of trying a claim at its points.
#[derive(Debug, Default)]
pub struct Tried {
    /// A counterexample.
    pub witness: Option<Witness>,
    /// At how many points the goal certainly holds.
    pub held: usize,
    /// How many points leave it open.
    pub open: usize,
    /// The first of these.
    pub(super) open_at: Vec<Point>,
}

/// A claim, ready to be tried.
pub struct Trial {
    points: Points,
    goal: Goal,
    /// Whether comparisons of equal sides were found.
    is_identified: bool,
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
        let plan = Plan::of(&statement);
        let trial = Trial::of(Rc::new(statement), plan).ok_or(Untried::Moves)?;
        Ok(trial.in_words(Rc::new(Words::of(claim))))
    }

    /// The same trial, which says what fails in these words.
    pub(super) fn in_words(mut self, words: Rc<Words>) -> Trial {
        self.points.search.base.words = words;
        self
    }

    /// A trial of a statement; `None` where no point decides the goal.
    pub(super) fn of(statement: Rc<Statement>, mut plan: Plan) -> Option<Trial> {
        let (search, goal) = aimed(&mut plan, &statement)?;
        let points = Points::new(statement, plan.reading, search, goal.prop.clone());
        Some(Trial { points, goal, is_identified: false })
    }

    /// Tries the claim at its points until one is a counterexample. It is made as small as it can be, unless the first values
    /// that are tried are its values and it need not be `smallest`. `now` hears of each point.
    pub fn tried(&mut self, effort: &Effort, smallest: bool, now: &mut dyn FnMut()) -> Tried {
        if effort.first.is_none() {
            self.identify();
        }
        self.goal.limits_left = if effort.first.is_some() { FIRST_LIMITS } else { LIMITS };
        let statement = Rc::clone(self.points.statement());
        let Trial { points, goal, .. } = self;
        let (mut tried, mut failing) = (Tried::default(), None);
        points.each(effort, &mut |origin, choice, point| {
            now();
            match goal.at(point) {
                Seen::Holds => tried.held += 1,
                Seen::Open => {
                    tried.open += 1;
                    if tried.open_at.len() < OPEN {
                        tried.open_at.push(as_point(&statement, point));
                    }
                }
                Seen::Fails(broken) => failing = Some((origin, choice.clone(), broken, point.clone())),
            }
            failing.is_some()
        });
        if let Some((origin, choice, broken, point)) = failing {
            let shrunk = if smallest || origin == Origin::Other { self.smallest(choice) } else { None };
            tried.witness = shrunk.or_else(|| Some(Witness { point: self.named(&point), broken }));
        }
        tried
    }

    /// Finds the comparisons of equal sides, once.
    fn identify(&mut self) {
        if !self.is_identified
            && let Some(reading) = self.points.reading()
        {
            self.goal.identify(reading);
        }
        self.is_identified = true;
    }

    /// What the goal is at a choice; `None` where a hypothesis does not hold for certain.
    pub fn at(&mut self, choice: &Choice) -> Option<(Seen, Assignment)> {
        self.identify();
        let search = &self.points.search;
        let point = if search.may_be(choice) { search.at(choice)? } else { return None };
        let before = point.steps.get();
        let seen = self.goal.at(&point);
        self.points.search.spend(before - point.steps.get());
        Some((seen, point))
    }

    /// A random point where the hypotheses hold, if one is found.
    pub fn random(&self, below: Below<'_>) -> Option<Choice> {
        self.points.random(below)
    }

    /// One random choice from numbers that the caller has; `None` where the hypotheses do not hold.
    pub fn once(&self, below: Below<'_>) -> Option<Choice> {
        self.points.drawn(below).map(|drawn| drawn.0)
    }

    /// The values of a point by their names.
    pub fn named(&self, point: &Assignment) -> Point {
        as_point(self.points.statement(), point)
    }

    /// The choices in which one number, or the list of a family, is shorter.
    pub fn simpler(choice: &Choice) -> Vec<Choice> {
        simpler(choice)
    }

    /// A counterexample as small as it can be made: at each step one number becomes simpler and the goal still fails.
    pub fn smallest(&mut self, mut choice: Choice) -> Option<Witness> {
        let mut witness = self.witness(&choice)?;
        self.points.search.left.set(SHRUNK);
        for _ in 0..SHRINKING {
            let mut next = simpler(&choice).into_iter();
            let found = next.find_map(|c| match self.points.search.left.get() {
                0 => None,
                _ => self.witness(&c).map(|found| (c, found)),
            });
            let Some((simpler, found)) = found else { break };
            (choice, witness) = (simpler, found);
        }
        Some(witness)
    }

    fn witness(&mut self, choice: &Choice) -> Option<Witness> {
        match self.at(choice)? {
            (Seen::Fails(broken), point) => Some(Witness { point: self.named(&point), broken }),
            _ => None,
        }
    }
}
