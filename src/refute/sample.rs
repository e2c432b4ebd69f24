//! Samples: a point at which all hypotheses hold, and values that make the body of an `exists` true.
//!
//! Contract: what is returned satisfies every hypothesis, or the body, exactly and certainly.

use super::Moment;
use super::evaluate::Assignment;
use super::expand::Statement;
use super::outcome::Point;
use super::search::{Plan, Search, as_point};
use crate::claim::syntax::*;
use malachite::Rational;

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

/// Values for the variables of an `exists` that make its body certainly true.
pub(crate) fn example(bindings: &[Binding], body: &Prop, deadline: Option<Moment>) -> Option<Vec<(String, Rational)>> {
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
