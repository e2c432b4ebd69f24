//! Samples: a point at which all hypotheses hold, and values that make the body of an `exists` true.
//!
//! Contract: what is returned satisfies every hypothesis, or the body, exactly and certainly.

use super::Moment;
use super::candidates::Values;
use super::edges::edges;
use super::evaluate::Assignment;
use super::expand::Statement;
use super::outcome::Point;
use super::points::{SMALL, SUGGESTED, TURNED};
use super::reading::declaring;
use super::search::{Choice, Plan, Round, Search, as_point};
use super::solve::{Way, on_an_edge};
use super::turns;
use crate::claim::syntax::*;
use malachite::Rational;

/// A point where all hypotheses of the statement hold: one that the author gives, or one that is found.
pub(super) fn sample(plan: &Plan, statement: &Statement, deadline: Option<Moment>) -> Option<Point> {
    let mut search = Search::new(&statement.bindings, Some(statement));
    let mut found = None;
    let mut visit = |_: &Choice, point: &Assignment| {
        found = Some(as_point(statement, point));
        true
    };
    // Variables to which the author gives no value are sought.
    let given = if statement.sample.is_empty() { 0..0 } else { search.follow(std::slice::from_ref(&statement.sample)) };
    let held = search.follow(&plan.ways);
    let angles = turns::angles(&search, &statement.goal);
    let turned = turns::follow(&mut search, held.clone(), &angles, None);
    let mut small = Values::usual();
    search.until.set(deadline);
    let _ = search.run(given, &mut small, Round::first(SMALL), &mut visit)
        || search.run(held.clone(), &mut small, Round::first(SMALL), &mut visit)
        || search.run(turned, &mut Values::turned(angles), Round::first(TURNED), &mut visit)
        || search.run(held, &mut Values::suggested(statement), Round::first(SUGGESTED), &mut visit);
    found
}

/// Values for the variables of an `exists` that make its body certainly true.
pub(crate) fn example(bindings: &[Binding], body: &Prop, deadline: Option<Moment>) -> Option<Vec<(String, Rational)>> {
    let mut search = Search::new(bindings, None);
    let names: Vec<String> = search.names.iter().map(|n| n.0.clone()).collect();
    let chosen = search.follow(&[Vec::new()]);
    let computed = search.follow(&computed(bindings, body).unwrap_or_default());
    let mut found = None;
    search.until.set(deadline);
    for paths in [computed, chosen] {
        let is_found = search.run(paths, &mut Values::usual(), Round::first(SMALL), &mut |_, point| {
            if point.truth(body) != Ok(true) {
                return false;
            }
            found = Some(names.iter().filter_map(|n| Some((n.clone(), point.values.get(n)?.clone()))).collect());
            true
        });
        if is_found {
            break;
        }
    }
    found
}

/// Ways to satisfy the equations of a body, and those at its edges: what may be equal, where that is allowed.
fn computed(bindings: &[Binding], body: &Prop) -> Option<Vec<Way>> {
    let mut claim = declaring(bindings)?;
    claim.items.push(Item::Assume { label: None, prop: body.clone() });
    let statement = Statement::of(&claim).ok()?;
    let Plan { reading, mut ways } = Plan::of(&statement);
    let (mut reading, search) = (reading?, Search::new(&statement.bindings, Some(&statement)));
    for edge in edges(&statement.goal, &search.hypotheses, &[], &|name| search.base.naturals.contains(name)) {
        ways.extend(on_an_edge(&mut reading, edge, &search.hypotheses, &search.real()));
    }
    Some(ways)
}
