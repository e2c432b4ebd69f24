//! The search for points of one claim: a point that satisfies its hypotheses, and a counterexample.
//!
//! Contract: a sample satisfies every hypothesis exactly. A counterexample is one of [`super::counterexample`]. It is sought twice: at
//! few points, before a proof is sought, and at all of them, where none was found.

use super::Moment;
use super::catalogue::Limits;
use super::expand::{Limit, Statement};
use super::outcome::{DIMENSIONS, Diagnose, Outcome, Point, Verdict, limit_reached};
use super::points::Effort;
use super::search::Plan;
use super::shape;
use super::trial::Trial;
use super::{dependence, faults, sample};
use crate::claim::dimension::Mismatch;
use crate::claim::syntax::Claim;
use crate::claim::write_out::Words;
use std::rc::Rc;
use std::time::Duration;

/// Number of expressions evaluated before a proof is tried. Most false claims fail within this number, and a true claim
/// loses only a few milliseconds.
const FIRST: u64 = 20_000;

/// How long the first points are tried.
const FIRST_TIME: Duration = Duration::from_millis(100);

/// The part of the time limit in which a point is sought that satisfies the hypotheses: a proof needs none.
const SAMPLE: u32 = 5;

const NO_POINT: &str = "no point was found that satisfies all hypotheses";

/// When a counterexample is sought.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stage {
    /// Before a proof is sought, at the first points.
    First,
    /// After that, at all points.
    Last,
}

/// A claim whose hypotheses have been read.
pub(crate) struct Case {
    /// How the statement is searched, until the search for a counterexample begins.
    plan: Option<Plan>,
    statement: Rc<Statement>,
    /// The words of the claim's author.
    words: Rc<Words>,
    sample: Option<Point>,
    /// Whether the sample was shown to exist, because none was found by evaluation.
    is_shown: bool,
    /// The claim at points, once the search for a counterexample has begun. `None` if values at a point cannot decide the
    /// goal, because a variable of a derivative or limit moves.
    trial: Option<Trial>,
    /// Number of points at which the goal was true, and at which it was left open.
    points: (usize, usize),
    /// The first points that leave it open.
    open: Vec<Point>,
    started: Moment,
    time: Duration,
}

impl Case {
    /// Reads the hypotheses and looks for a point that satisfies them.
    ///
    /// # Errors
    /// A limit, by name.
    pub(crate) fn new(claim: &Claim, limits: &Limits) -> Result<Case, &'static str> {
        let started = Moment::now();
        let statement = Statement::of(claim).map_err(|Limit(name)| name)?;
        let plan = Plan::of(&statement);
        let has_hypotheses = statement.has_hypotheses();
        // No deadline where the clock does not reach that far.
        let deadline = started.checked_add(limits.time / SAMPLE);
        let sample = if has_hypotheses { sample::sample(&plan, &statement, deadline) } else { None };
        let (plan, statement) = (Some(plan), Rc::new(statement));
        Ok(Case {
            plan,
            statement,
            words: Rc::new(Words::of(claim)),
            sample,
            is_shown: false,
            trial: None,
            points: (0, 0),
            open: Vec::new(),
            started,
            time: limits.time,
        })
    }

    /// Whether there are hypotheses and no point was found that satisfies them.
    pub(crate) fn has_no_point(&self) -> bool {
        self.statement.has_hypotheses() && self.sample.is_none()
    }

    /// Whether the claim declares anything.
    pub(crate) fn has_variables(&self) -> bool {
        !self.statement.bindings.is_empty()
    }

    /// The first points at which the hypotheses hold and evaluation leaves the goal open.
    pub(crate) fn open_points(&self) -> &[Point] {
        &self.open
    }

    /// Records a point at which the hypotheses were shown to hold.
    pub(crate) fn found_a_point(&mut self, point: Option<Point>) {
        self.is_shown = point.is_some();
        self.sample = point;
    }

    /// Whether the hypotheses were shown to hold at a point that evaluation did not find: mostly its coordinates are roots.
    pub(crate) fn has_shown_point(&self) -> bool {
        self.is_shown
    }

    /// The first fault of the claim's argument, which may cite these claims.
    ///
    /// # Errors
    /// The fault.
    pub(crate) fn check(&mut self, cited: &[&Claim]) -> Result<(), Diagnose> {
        faults::check(&self.statement, cited)?;
        let said = self.statement.assumptions.iter().map(|a| &a.1).chain([&self.statement.goal]);
        said.into_iter().try_for_each(shape::check)
    }

    /// Why no proof is tried, if there is a reason: the goal is ambiguous.
    pub(crate) fn ambiguous(&self) -> Option<String> {
        let variable = dependence::tied_derivative(&self.statement)?;
        Some(format!(
            "a derivative by {variable} is ambiguous, because a hypothesis ties {variable} to other variables"
        ))
    }

    /// The outcome of a claim whose proof is accepted. If no point is known that satisfies the hypotheses, it says so.
    pub(crate) fn proved(self) -> Outcome {
        let reason = self.has_no_point().then(|| NO_POINT.to_string());
        let outcome = undecided(&self.statement.name, reason, None);
        Outcome { verdict: Verdict::Proved, sample: self.sample, ..outcome }
    }

    /// The outcome of a claim that is neither proved nor refuted.
    pub(crate) fn undecided(self, reason: String, limit: Option<&'static str>) -> Outcome {
        let late = limit.is_none() && self.started.elapsed() > self.time;
        let reason = if late { format!("{reason}; {}", limit_reached("time")) } else { reason };
        let limit = if late { Some("time") } else { limit };
        let (points, open) = self.points;
        Outcome { sample: self.sample, points, open, ..undecided(&self.statement.name, Some(reason), limit) }
    }

    /// A counterexample at the first points, before a proof is sought, or at all of them.
    pub(crate) fn counterexample(&mut self, stage: Stage) -> Option<Outcome> {
        if self.has_no_point() {
            return None;
        }
        if let Some(plan) = self.plan.take() {
            let trial = Trial::of(self.statement.clone(), plan);
            self.trial = trial.map(|trial| trial.in_words(self.words.clone()));
        }
        let deadline = self.started.checked_add(self.time);
        let effort = match stage {
            Stage::First => Effort { first: Some((FIRST, FIRST_TIME)), ..Effort::whole(deadline) },
            Stage::Last => Effort::whole(deadline),
        };
        let tried = self.trial.as_mut()?.tried(&effort, false, &mut || {});
        if self.open.is_empty() {
            self.open = tried.open_at;
        }
        // The last stage may end earlier than the first.
        self.points = self.points.max((tried.held, tried.open));
        let witness = tried.witness?;
        let without_value = witness.broken.iter().all(|b| b.left == "no value");
        Some(Outcome {
            verdict: Verdict::Refuted,
            method: if without_value { "definedness" } else { "search" }.to_string(),
            sample: self.sample.clone(),
            witness: Some(witness),
            ..undecided(&self.statement.name, None, None)
        })
    }

    /// The outcome of a claim that is refuted by this method.
    pub(crate) fn refuted(self, method: &str) -> Outcome {
        let outcome = undecided(&self.statement.name, None, None);
        Outcome { verdict: Verdict::Refuted, method: method.to_string(), sample: self.sample, ..outcome }
    }

    /// The time left for the claim.
    pub(crate) fn time_left(&self) -> Duration {
        self.time.saturating_sub(self.started.elapsed())
    }
}

/// The outcome of a claim that exceeds a limit before any search.
pub(crate) fn beyond(claim: &Claim, limit: &'static str) -> Outcome {
    undecided(&claim.name.text, Some(limit_reached(limit)), Some(limit))
}

/// The outcome of a claim at which the search met an error of its own.
pub(crate) fn broken_off(claim: &Claim) -> Outcome {
    let reason = "the search broke off at an error of its own; please report this claim with the message before";
    undecided(&claim.name.text, Some(reason.to_string()), None)
}

/// The outcome of a claim that adds or compares different dimensions: it says nothing of quantities that may be true, whatever
/// its numbers are.
pub(crate) fn differing(claim: &Claim, mismatch: &Mismatch) -> Outcome {
    let reason = Some(mismatch.message());
    Outcome { verdict: Verdict::Refuted, method: DIMENSIONS.to_string(), ..undecided(&claim.name.text, reason, None) }
}

fn undecided(name: &str, reason: Option<String>, limit: Option<&'static str>) -> Outcome {
    Outcome {
        claim: name.to_string(),
        verdict: Verdict::Undecided,
        method: String::new(),
        used: Vec::new(),
        unused: Vec::new(),
        sample: None,
        witness: None,
        reason,
        limit,
        found_by: Vec::new(),
        remaining: Vec::new(),
        points: 0,
        open: 0,
    }
}
