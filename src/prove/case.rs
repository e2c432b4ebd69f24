//! One claim as a search for points sees it: its hypotheses, a point at which they hold, a counterexample.
//!
//! Contract: a sample satisfies every hypothesis exactly. A counterexample is one of [`refute`]. It is sought twice: at
//! few points, before a proof is sought, and at all of them, where none was found.

use super::Instant;
use super::catalogue::{Limits, engine, given_in};
use super::context::{Context, Engine, Failure};
use super::expand::Statement;
use super::faults;
use super::outcome::{Outcome, Point, Verdict, Witness, limit_reached};
use super::refute::{self, Goal, Search};
use super::translate::Value;
use super::trial::Untried;
use crate::algebra::form::{Form, Limit};
use crate::claim::syntax::{Claim, Diagnose, PropKind, Relation};
use std::time::Duration;

/// How many expressions are evaluated before a proof is sought: most false claims fail within them, and a true one waits
/// for a few milliseconds.
pub const FIRST: u64 = 20_000;

const NO_POINT: &str = "no point was found at which all the hypotheses hold";

/// A claim with its hypotheses taken in.
pub struct Case {
    engine: Engine,
    cx: Context,
    statement: Statement,
    /// Whether the hypotheses could be taken in.
    taken: Result<(), Failure>,
    sample: Option<Point>,
    /// The points and the goal, once a counterexample is sought; none where a point says nothing of what moves.
    aim: Option<Option<(Search, Goal)>>,
    started: Instant,
    time: Duration,
}

impl Case {
    /// Takes in the hypotheses and seeks a point at which they hold.
    ///
    /// # Errors
    /// The hypotheses contradict each other, or the statement is beyond a limit.
    pub fn new(claim: &Claim, limits: &Limits) -> Result<Case, Untried> {
        let started = Instant::now();
        let statement = Statement::of(claim).map_err(|Limit(name)| Untried::Limit(name))?;
        let mut engine = engine(limits);
        let (cx, taken, sample) = given_in(&mut engine, &statement).map_err(Untried::Fault)?;
        Ok(Case { engine, cx, statement, taken, sample, aim: None, started, time: limits.time })
    }

    /// The first fault of the claim's argument, which may cite these claims.
    ///
    /// # Errors
    /// The fault.
    pub fn check(&mut self, cited: &[&Claim]) -> Result<(), Diagnose> {
        faults::check(&self.statement, cited)?;
        self.matrices_fit()
    }

    /// Why no proof is sought, if there is a reason: the goal may be read in two ways.
    pub fn ambiguous(&self) -> Option<String> {
        let variable = refute::tied_derivative(&self.statement)?;
        Some(format!("a derivative by {variable}, which a hypothesis ties to other variables, may be read in two ways"))
    }

    /// Matrices are compared with matrices of the same size, by = or ≠.
    fn matrices_fit(&mut self) -> Result<(), Diagnose> {
        let mut open = vec![&self.statement.goal];
        while let Some(prop) = open.pop() {
            let (sides, relations) = match &prop.kind {
                PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                    open.extend(list.iter().rev());
                    continue;
                }
                PropKind::Implies(p, q) => {
                    open.extend([&**q, &**p]);
                    continue;
                }
                PropKind::Compare(sides, relations) => (sides, relations),
                _ => continue,
            };
            let mut values = Vec::new();
            for side in sides {
                match self.engine.translate(&mut self.cx.clone(), side, &mut Vec::new()) {
                    Ok(value) => values.push(value),
                    Err(Failure::Fault(fault)) => return Err(fault),
                    // What is wrong besides is for others to say.
                    Err(_) => return Ok(()),
                }
            }
            for (pair, relation) in values.windows(2).zip(relations) {
                let message = match (&pair[0], &pair[1]) {
                    (Value::Scalar(_), Value::Scalar(_)) => continue,
                    (Value::Matrix(a), Value::Matrix(b)) => {
                        let size = |m: &[Vec<Form>]| (m.len(), m.first().map_or(0, Vec::len));
                        match relation {
                            Relation::Equal | Relation::NotEqual if size(a) == size(b) => continue,
                            Relation::Equal | Relation::NotEqual => "the sizes of these matrices differ",
                            _ => "matrices have no order: compare them by = or !=",
                        }
                    }
                    _ => "a matrix is compared with a number",
                };
                return Err(Diagnose { message: message.to_string(), help: None, span: prop.span });
            }
        }
        Ok(())
    }

    /// Whether the claim has hypotheses, and no point was found at which they hold.
    pub fn lacks_a_point(&self) -> bool {
        self.statement.has_hypotheses() && self.sample.is_none()
    }

    /// Notes a point at which the hypotheses were shown to hold.
    pub fn found_a_point(&mut self, point: Option<Point>) {
        self.sample = point;
    }

    /// What is said of a claim whose proof is accepted: that its hypotheses can hold has to be known as well.
    pub fn proved(self) -> Outcome {
        let mut outcome = undecided(&self.statement.name, None, self.limit());
        if self.lacks_a_point() {
            let limit = outcome.limit.map_or(String::new(), |name| format!("; {}", limit_reached(name)));
            outcome.reason = Some(format!("{NO_POINT}{limit}"));
        } else {
            outcome = Outcome { verdict: Verdict::Proved, sample: self.sample, limit: None, ..outcome };
        }
        outcome
    }

    /// What is said of a claim that is neither shown nor refuted.
    pub fn undecided(self, reason: String, limit: Option<&'static str>) -> Outcome {
        // Hypotheses that cannot be taken in say more than what came of it.
        let reason = match &self.taken {
            Err(Failure::Undefined(text)) => format!("an expression may have no value: {text}"),
            _ => reason,
        };
        let late = limit.is_none() && self.started.elapsed() > self.time;
        let reason = if late { format!("{reason}; {}", limit_reached("time")) } else { reason };
        let limit = if late { Some("time") } else { limit };
        Outcome {
            sample: self.sample,
            points: self.engine.points,
            ..undecided(&self.statement.name, Some(reason), limit)
        }
    }

    /// A counterexample among the points that are tried with so many expressions evaluated, or among all.
    pub fn counterexample(&mut self, most: Option<u64>) -> Option<Outcome> {
        if self.lacks_a_point() {
            return None;
        }
        let witness = self.falsified(most)?;
        let without_value = witness.broken.iter().all(|b| b.left == "no value");
        Some(Outcome {
            verdict: Verdict::Refuted,
            method: if without_value { "definedness" } else { "search" }.to_string(),
            sample: self.sample.clone(),
            witness: Some(witness),
            ..undecided(&self.statement.name, None, None)
        })
    }

    fn falsified(&mut self, most: Option<u64>) -> Option<Witness> {
        let Case { engine, cx, statement, aim, .. } = self;
        engine.steps = engine.steps.max(1_000);
        let (search, goal) = aim.get_or_insert_with(|| refute::aimed(engine, cx, statement)).as_mut()?;
        if most.is_none() {
            goal.identify(engine, cx);
        }
        refute::falsified_by(engine, statement, search, goal, most)
    }

    /// The limit that stood in the way of the hypotheses, or of a point.
    fn limit(&self) -> Option<&'static str> {
        match &self.taken {
            Err(Failure::Limit(name)) => Some(name),
            _ if self.engine.limit.is_some() => self.engine.limit,
            // A search for points ends there without a word.
            _ => (self.started.elapsed() > self.time).then_some("time"),
        }
    }

    /// The time that is left for the claim.
    pub fn time_left(&self) -> Duration {
        self.time.saturating_sub(self.started.elapsed())
    }
}

/// A claim that is beyond a limit before anything is sought.
pub fn beyond(claim: &Claim, limit: &'static str) -> Outcome {
    undecided(&claim.name.text, Some(limit_reached(limit)), Some(limit))
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
        points: 0,
    }
}
