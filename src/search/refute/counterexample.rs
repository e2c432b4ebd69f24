//! Counterexamples: points where the hypotheses hold and the goal fails.
//!
//! Contract: a returned point satisfies every hypothesis exactly and certainly, and the goal is certainly false there or has
//! no value.

use super::Moment;
use super::expand::Statement;
use super::outcome::Witness;
use super::points::Effort;
use super::search::Plan;
use super::trial::Trial;
use std::rc::Rc;
use std::time::Duration;

/// A counterexample at the points of an audit. A search of all of them may take minutes, unless `time` ends it.
pub fn falsified(statement: &Statement, time: Option<Duration>) -> Option<Witness> {
    let deadline = time.and_then(|time| Moment::now().checked_add(time));
    let mut trial = Trial::of(Rc::new(statement.clone()), Plan::of(statement))?;
    trial.tried(&Effort::whole(deadline), false, &mut || {}).witness
}
