//! Counterexamples: points where the hypotheses hold and the goal fails.
//!
//! Contract: a returned point satisfies every hypothesis exactly and certainly, and the goal is certainly false there or has
//! no value.

use super::Moment;
use super::evaluate::Assignment;
use super::expand::Statement;
use super::number::Number;
use super::outcome::{Broken, Witness};
use super::points::Effort;
use super::search::{Plan, Search};
use super::trial::Trial;
use crate::claim::syntax::{Expr, ExprKind};
use rustc_hash::FxHashMap;
use std::rc::Rc;
use std::time::Duration;

/// The comparisons of a false goal at a point of variables, rational or not, with both sides; empty where one is not computed.
pub fn broken(statement: &Statement, point: &[(Expr, Expr)]) -> Vec<Broken> {
    let mut at = Search::new(&statement.bindings, Some(statement)).base;
    let mut irrational = FxHashMap::default();
    for (place, value) in point {
        match (&place.kind, Assignment::default().number(value)) {
            (ExprKind::Name(name), Ok(Number::Exact(q))) => drop(at.values.insert(name.clone(), q)),
            (ExprKind::Name(name), Ok(number)) => drop(irrational.insert(name.clone(), number)),
            _ => return Vec::new(),
        }
    }
    at.numbers = Rc::new(irrational);
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
