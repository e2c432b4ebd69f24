//! An audit as JSON: the contract of the command line.

use super::{Audit, Entry, number, reading, summary};
use crate::claim::print::Style;
use crate::refute::outcome::Point;
use serde_json::{Map, Value, json};

/// The report; `errors` names what could not be judged.
pub fn report(audit: &Audit) -> String {
    let claims: Vec<Value> = audit.entries.iter().map(one).collect();
    let errors: Vec<Value> = audit.problems.iter().map(|p| json!({ "claim": p.name, "message": p.message })).collect();
    let s = summary(&audit.entries);
    let value = json!({
        "claims": claims,
        "errors": errors,
        "summary": {
            "proved": s.proved,
            "refuted": s.refuted,
            "undecided": s.undecided,
            "unexpected": s.unexpected,
            "errors": audit.problems.len(),
            "judged": audit.judged,
        },
    });
    let mut out = serde_json::to_string_pretty(&value).unwrap_or_default();
    out.push('\n');
    out
}

fn one(entry: &Entry) -> Value {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let point = |point: &Point| {
        let values = point.named(claim, Style::Text).map(|(name, value)| (name, Value::String(value.to_string())));
        Value::Object(values.collect::<Map<_, _>>())
    };
    let expected = match claim.expect {
        crate::claim::syntax::Expectation::Proved => "proved",
        crate::claim::syntax::Expectation::Refuted => "refuted",
        crate::claim::syntax::Expectation::Undecided => "undecided",
    };
    json!({
        "id": claim.name.text,
        "number": number(claim),
        "title": claim.title,
        "source": claim.source,
        "section": claim.section,
        "statement": entry.goal(Style::Text),
        "latex": entry.goal(Style::Latex),
        "reading": reading(claim),
        "verdict": outcome.verdict.name(),
        "expected": expected,
        "as_expected": entry.as_expected(),
        "method": outcome.method,
        "assumptions": outcome.used,
        "unused": outcome.unused,
        "sample": outcome.sample.as_ref().map(point),
        "witness": outcome.witness.as_ref().map(|w| point(&w.point)),
        "broken": outcome.witness.as_ref().map(|w| w.broken.iter().map(|b| json!({
            "statement": b.statement, "left": b.left, "right": b.right,
        })).collect::<Vec<_>>()),
        "reason": outcome.reason,
        "notes": claim.notes,
        "limit": outcome.limit,
        "found_by": outcome.found_by,
        "remaining": outcome.remaining.iter().map(|r| json!({
            "goal": r.goal, "tried": r.tried, "open": r.open,
        })).collect::<Vec<_>>(),
        "certificate": entry.proof.as_ref().map(|p| &p.sha256),
        "rests_on": entry.proof.as_ref().map(|p| &p.rests_on),
    })
}
