//! Counterexamples: points where the hypotheses hold and the goal fails.
//!
//! Contract: a returned point satisfies every hypothesis exactly and certainly, and the goal is certainly false there or has
//! no value.

use super::Moment;
use super::evaluate::Assignment;
use super::expand::Statement;
use super::goal::{Goal, Seen, aimed};
use super::outcome::Witness;
use super::search::{Plan, Search, as_point};
use std::time::Duration;

/// At how many points limits are found anew.
pub(super) const LIMITS: usize = 60;

/// At how many of them before a proof is sought.
const FIRST_LIMITS: usize = 4;

/// How long points are tried before a proof is sought.
const FIRST_TIME: Duration = Duration::from_millis(100);

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
