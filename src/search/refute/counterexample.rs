//! Counterexamples: points where the hypotheses hold and the goal fails.
//!
//! Contract: a returned point satisfies every hypothesis exactly and certainly, and the goal is certainly false there or has
//! no value.

use super::Moment;
use super::evaluate::Assignment;
use super::expand::Statement;
use super::outcome::{Broken, Witness};
use super::points::Effort;
use super::search::{Plan, Search};
use super::trial::Trial;
use crate::claim::syntax::{Claim, Expr, ExprKind};
use crate::claim::write_out::Words;
use std::rc::Rc;
use std::time::Duration;

/// The comparisons of a false goal at a point of variables, rational or not, with both sides; empty where one is not computed.
/// The statement is that of the claim, whose author's words are said.
pub fn broken(claim: &Claim, statement: &Statement, point: &[(Expr, Expr)]) -> Vec<Broken> {
    let words = Rc::new(Words::of(claim));
    let mut at = Assignment { words, ..Search::new(&statement.bindings, Some(statement)).base };
    let alone = Assignment { is_pi: at.is_pi, ..Assignment::default() };
    for (place, value) in point {
        match (&place.kind, alone.number(value)) {
            (ExprKind::Name(name), Ok(number)) => at.give(name, number),
            _ => return Vec::new(),
        }
    }
    let mut found = Vec::new();
    at.broken(&statement.goal, &mut found);
    found
}

/// A counterexample at the points of an audit. A search of all of them may take minutes, unless `time` ends it.
pub fn falsified(statement: &Statement, time: Option<Duration>) -> Option<Witness> {
    let deadline = time.and_then(|time| Moment::now().checked_add(time));
    let mut trial = Trial::of(Rc::new(statement.clone()), Plan::of(statement))?;
    trial.tried(&Effort::whole(deadline), false, &mut || {}).witness
}
