//! A replay as JSON: the contract of the command line.
//!
//! Numbers are strings. Pairs name two neighbours; bodies count from 1, 0 is the left wall and the number after
//! the last body the right wall. Beyond the contract's keys there are `time` and `positions` of the end, `listed`
//! (how many collisions are listed), `simultaneous`, `any_order`, `largest_bits`, `exact`, and one of `collapse`, `limit`,
//! `ambiguous` where the run ended so. `joins` counts how often bodies came together after infinitely many collisions;
//! `joined` lists those instants, each with `after` (how many collisions were counted before), `bodies` (first and last),
//! `before` (their velocities), `velocity` (the common one), `cause` (`inelastic` or `collapse`) and, for a collapse, all
//! that is known of it under `collapse`.

use super::{Numbers, Replay, decimal};
use crate::chain::replay::{Cause, Collapse, Collision, Contact, Joined, Limit, Status, Value};
use serde_json::{Map, Value as Json, json};

/// The report.
#[must_use]
pub fn report(replay: &Replay) -> String {
    let o = replay.outcome;
    let n = |v: &Value| replay.numbers.write(v);
    let all = |list: &[Value]| list.iter().map(n).collect::<Vec<_>>();
    let mut map = Map::new();
    let mut put = |key: &str, value: Json| map.insert(key.to_string(), value);
    put("status", json!(status(&o.status)));
    put("count", json!(o.count));
    put("collisions", o.events.iter().map(|c| collision(c, replay.numbers)).collect());
    put("final", json!(all(&o.velocities)));
    put("energy", json!({"initial": n(&o.energy.initial), "final": n(&o.energy.last), "lost": n(&o.energy.lost)}));
    put("momentum", json!(n(&o.momentum.1)));
    put("time", json!(n(&o.time)));
    put("positions", json!(all(&o.positions)));
    put("listed", json!(o.events.len()));
    put("joins", json!(o.joins));
    put("joined", o.joined.iter().map(|j| joined(j, replay.numbers)).collect());
    put("simultaneous", json!(o.simultaneous));
    put("any_order", json!(o.any_order));
    put("largest_bits", json!(o.growth.last().map_or(0, |g| g.1)));
    put("exact", json!(o.enclosed.is_none()));
    if let Some(part) = o.enclosed {
        put("enclosed", json!({"after": part.after, "bits": part.bits, "entries": part.entries}));
    }
    match &o.status {
        Status::Complete => {}
        Status::Collapse(found) => {
            put("collapse", collapse(found, replay.numbers));
        }
        Status::Limit(limit) => {
            let (name, allowed) = match limit {
                Limit::Events { allowed } => ("collisions", *allowed),
                Limit::Precision { bits } => ("bits of an enclosure", *bits),
                Limit::Values { allowed, .. } => ("bits of exact final values", *allowed),
            };
            put("limit", json!({"name": name, "allowed": allowed}));
        }
        Status::Ambiguous(found) => {
            put("ambiguous", ambiguous(found, replay.numbers));
        }
    }
    let mut out = serde_json::to_string_pretty(&Json::Object(map)).unwrap_or_default();
    out.push('\n');
    out
}

fn status(status: &Status) -> &'static str {
    match status {
        Status::Complete => "complete",
        Status::Collapse(_) => "collapse",
        Status::Limit(_) => "limit",
        Status::Ambiguous(_) => "ambiguous",
    }
}

fn collision(c: &Collision, numbers: Numbers) -> Json {
    let two = |x: &[Value; 2]| [numbers.write(&x[0]), numbers.write(&x[1])];
    json!({
        "time": numbers.write(&c.time),
        "pair": [c.pair, c.pair + 1],
        "before": two(&c.before),
        "after": two(&c.after),
    })
}

fn joined(j: &Joined, numbers: Numbers) -> Json {
    let (cause, found) = match &j.cause {
        Cause::Inelastic => ("inelastic", None),
        Cause::Collapse(found) => ("collapse", Some(collapse(found, numbers))),
    };
    let mut map = json!({
        "after": j.after,
        "time": numbers.write(&j.time),
        "position": numbers.write(&j.position),
        "bodies": [j.bodies.0, j.bodies.1],
        "before": [numbers.rational(&j.before[0]), numbers.rational(&j.before[1])],
        "velocity": numbers.rational(&j.velocity),
        "lost": numbers.rational(&j.lost),
        "cause": cause,
    });
    if let Some(found) = found {
        map["collapse"] = found;
    }
    map
}

fn collapse(found: &Collapse, numbers: Numbers) -> Json {
    let exact = |x: &malachite::Rational| numbers.rational(x);
    json!({
        "time": numbers.write(&found.time),
        "time_decimal": decimal(&found.time, super::DEFAULT_DIGITS),
        "position": numbers.write(&found.position),
        "velocity": exact(&found.velocity),
        "bodies": [found.bodies.0, found.bodies.1],
        "pattern": found.pattern.iter().map(|p| json!([p, p + 1])).collect::<Vec<_>>(),
        "trace": found.trace.as_ref().map(|t| exact(&t.0)),
        "determinant": found.trace.as_ref().map(|t| exact(&t.1)),
        "factor": numbers.write(&found.factor),
        "rounds": found.rounds,
        "critical": found.critical,
        "convergence": if found.critical { "like 1/n" } else { "geometric" },
    })
}

fn ambiguous(found: &Contact, numbers: Numbers) -> Json {
    let pairs = |list: &[usize]| list.iter().map(|p| json!([p, p + 1])).collect::<Vec<_>>();
    let exact = |x: &malachite::Rational| numbers.rational(x);
    json!({
        "time": exact(&found.time),
        "bodies": [found.bodies.0, found.bodies.1],
        "pairs": pairs(&found.pairs),
        "outcomes": found.outcomes.as_ref().map(|o| o.outcomes.iter().map(|one| json!({
            "order": pairs(&one.order),
            "velocities": one.velocities.iter().map(exact).collect::<Vec<_>>(),
        })).collect::<Vec<_>>()),
        "cut": found.outcomes.as_ref().map(|o| o.cut),
    })
}
