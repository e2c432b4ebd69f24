//! The referee's scenes as JSON, right answers as CSV, and its judgement as text and JSON.

use super::counted;
use super::replay::decimal;
use crate::chain::replay::Value;
use crate::number::decimal::{Decimal, Digits, Rounding};
use crate::referee::judge::{Finding, Given, Law, Measure};
use crate::referee::{End, Known, Reference, Scene};
use malachite::Rational;
use malachite::base::num::comparison::traits::PartialOrdAbs;
use serde_json::{Map, Value as Json, json};

/// Digits of the decimals in the file of scenes and in findings.
const SHOWN: u64 = 20;

/// An exact number is written in full up to so many characters.
const LONGEST: usize = 200;

/// A scene and what is wrong with its results.
pub type Judged<'a> = (&'a Reference, Vec<Finding>);

/// The scenes with their ends.
#[must_use]
pub fn scenes(references: &[&Reference]) -> String {
    let scenes: Vec<Json> = references.iter().map(|reference| entry(reference)).collect();
    let file = json!({ "format": "carom-referee 1", "program": env!("CARGO_PKG_VERSION"), "scenes": scenes });
    serde_json::to_string_pretty(&file).unwrap_or_default() + "\n"
}

fn entry(reference: &Reference) -> Json {
    let scene = &reference.scene;
    let mut out = set_up(scene);
    let due = reference.instants.iter().flatten();
    out.insert("count".into(), json!(reference.count));
    out.insert("collisions".into(), due.clone().map(|due| json!([due.pair, due.pair + 1])).collect());
    out.insert("times".into(), due.map(|due| number(&due.time)).collect());
    out.insert("ends".into(), reference.ends.iter().map(|end| ended(scene, end)).collect());
    Json::Object(out)
}

fn set_up(scene: &Scene) -> Map<String, Json> {
    let all = |list: Vec<&Rational>| list.into_iter().map(ToString::to_string).collect::<Vec<_>>();
    let wall = |place: usize| {
        scene.walls[place]
            .as_ref()
            .map(|wall| json!({ "position": wall.position.to_string(), "restitution": wall.restitution.to_string() }))
    };
    let value = json!({
        "name": scene.name,
        "group": scene.group,
        "about": scene.about,
        "masses": all(scene.bodies.iter().map(|body| &body.mass).collect()),
        "positions": all(scene.bodies.iter().map(|body| &body.position).collect()),
        "velocities": all(scene.bodies.iter().map(|body| &body.velocity).collect()),
        "lengths": all(scene.bodies.iter().map(|body| &body.length).collect()),
        "restitution": all(scene.restitution.iter().collect()),
        "left_wall": wall(0),
        "right_wall": wall(1),
        "until": scene.until.to_string(),
    });
    if let Json::Object(map) = value { map } else { Map::new() }
}

fn ended(scene: &Scene, end: &End) -> Json {
    let exact: Option<Vec<&Rational>> = end.velocities.iter().map(|known| known.value.rational()).collect();
    let sum = |term: &dyn Fn(&Rational, &Rational) -> Rational| {
        let velocities = exact.as_ref()?;
        let terms = scene.bodies.iter().zip(velocities).map(|(body, v)| term(&body.mass, v));
        Some(number(&exactly(terms.fold(Rational::from(0), |a, b| a + b))))
    };
    json!({
        "velocities": end.velocities.iter().map(number).collect::<Vec<_>>(),
        "positions": end.positions.iter().map(number).collect::<Vec<_>>(),
        "momentum": sum(&|m, v| m * v),
        "energy": sum(&|m, v| m * v * v / Rational::from(2)),
    })
}

fn exactly(x: Rational) -> Known {
    Known { value: Value::Exact(x.clone()), lo: x.clone(), hi: x }
}

/// A decimal with correct digits only, and the exact number if it is rational and not too long.
fn number(known: &Known) -> Json {
    let exact = known.value.rational().map(ToString::to_string).filter(|text| text.len() <= LONGEST);
    json!({ "decimal": decimal(&known.value, SHOWN), "exact": exact })
}

/// The right answers as somebody's program would write them.
#[must_use]
pub fn answers(references: &[&Reference]) -> String {
    let mut out = "scene,velocities,positions,collisions,times,count\n".to_owned();
    for reference in references {
        let Some(end) = reference.ends.first() else { continue };
        let all = |list: &[Known]| list.iter().map(|k| decimal(&k.value, SHOWN)).collect::<Vec<_>>().join(" ");
        let due: Vec<_> = reference.instants.iter().flatten().collect();
        let pairs: Vec<String> = due.iter().map(|due| pair(due.pair)).collect();
        let times: Vec<String> = due.iter().map(|due| decimal(&due.time.value, SHOWN)).collect();
        let count = reference.count.map_or(String::new(), |count| count.to_string());
        let (velocities, positions) = (all(&end.velocities), all(&end.positions));
        let fields = [velocities, positions, pairs.join(" "), times.join(" "), count];
        out.push_str(&format!("{},{}\n", reference.scene.name, fields.join(",")));
    }
    out
}

fn pair(left: usize) -> String {
    format!("{left}-{}", left + 1)
}

fn rounded(x: &Rational, digits: u64) -> String {
    Decimal::of_rational(x, Digits::Significant(digits), Rounding::Nearest)
        .map_or_else(|_| x.to_string(), |d| d.to_string())
}

/// Two numbers with as many digits as show that they differ.
fn apart(one: &Rational, other: &Rational) -> (String, String) {
    let with = |digits| (rounded(one, digits), rounded(other, digits));
    (4..SHOWN).map(with).find(|(one, other)| one != other).unwrap_or_else(|| with(SHOWN))
}

/// A number with enough digits to show where it is wrong.
fn shown(given: &Given, digit: Option<u64>) -> String {
    match given {
        Given::Number(x) => rounded(x, digit.unwrap_or(3).saturating_add(2).min(SHOWN)),
        Given::Strange(text) => text.clone(),
    }
}

/// A finding in words.
#[must_use]
pub fn words(finding: &Finding) -> String {
    match finding {
        Finding::NoAnswer => "no result".to_owned(),
        Finding::Number { what, number, given, right, digit } => {
            let of = match what {
                Measure::Velocity => format!("velocity of body {number}"),
                Measure::Position => format!("position of body {number}"),
                Measure::Time => format!("time of collision {number}"),
            };
            let right = decimal(&right.value, digit.map_or(3, |digit| digit.saturating_add(2).min(SHOWN)));
            let from = digit.map_or(String::new(), |digit| format!(": wrong from digit {digit} on"));
            format!("{of}: {} given, {right} right{from}", shown(given, *digit))
        }
        Finding::Balance { law, given, right } => {
            let law = match law {
                Law::Momentum => "momentum",
                Law::Energy => "energy",
            };
            let verb = if given.gt_abs(right) { "made" } else { "lost" };
            let (given, right) = apart(given, right);
            format!("{law} {verb}: {given} given, {right} right")
        }
        Finding::Order { number, given, right } => {
            let right: Vec<String> = right.iter().map(|left| pair(*left)).collect();
            format!("order of collisions: number {number} is {}, not {}", right.join(" or "), pair(*given))
        }
        Finding::Count { given, right } => {
            format!("{} given, {right} right", counted(usize::try_from(*given).unwrap_or(usize::MAX), "collision"))
        }
    }
}

/// The first finding of each kind, the others counted.
fn summary(findings: &[Finding]) -> Vec<String> {
    let kind = |finding: &Finding| match finding {
        Finding::Number { what, .. } => Some(*what),
        _ => None,
    };
    let mut lines = Vec::new();
    for (place, finding) in findings.iter().enumerate() {
        let Some(of) = kind(finding) else {
            lines.push(words(finding));
            continue;
        };
        if findings[..place].iter().any(|earlier| kind(earlier) == Some(of)) {
            continue;
        }
        let others = findings.iter().filter(|other| kind(other) == Some(of)).count() - 1;
        let more = if others == 0 { String::new() } else { format!(" (and {others} more)") };
        lines.push(words(finding) + &more);
    }
    lines
}

/// How many are right, wrong, and without a result.
#[must_use]
pub fn tally(judged: &[Judged]) -> (usize, usize, usize) {
    let right = judged.iter().filter(|(_, findings)| findings.is_empty()).count();
    let missing = judged.iter().filter(|(_, findings)| findings.contains(&Finding::NoAnswer)).count();
    (right, judged.len() - right - missing, missing)
}

/// The judgement to read.
#[must_use]
pub fn text(judged: &[Judged], digits: u64) -> String {
    let mut out = String::new();
    let mut group = "";
    for (reference, findings) in judged {
        if reference.scene.group != group {
            group = &reference.scene.group;
            out.push_str(&format!("{group}\n"));
        }
        let verdict = match findings.as_slice() {
            [] => "right",
            [Finding::NoAnswer] => "missing",
            _ => "wrong",
        };
        out.push_str(&format!("  {verdict:<8}{}\n", reference.scene.name));
        if verdict == "wrong" {
            for line in summary(findings) {
                out.push_str(&format!("            {line}\n"));
            }
        }
    }
    let (right, wrong, missing) = tally(judged);
    let total = counted(judged.len(), "scene");
    out.push_str(&format!("\n{total}, to {digits} digits: {right} right, {wrong} wrong, {missing} without a result\n"));
    out
}

/// The judgement for programs.
#[must_use]
pub fn json(judged: &[Judged], digits: u64) -> String {
    let entries = judged.iter().map(|(reference, findings)| {
        let verdict = match findings.as_slice() {
            [] => "right",
            [Finding::NoAnswer] => "missing",
            _ => "wrong",
        };
        json!({
            "scene": reference.scene.name,
            "group": reference.scene.group,
            "verdict": verdict,
            "findings": findings.iter().map(finding).collect::<Vec<_>>(),
        })
    });
    let (right, wrong, missing) = tally(judged);
    let value = json!({
        "digits": digits, "right": right, "wrong": wrong, "missing": missing,
        "scenes": entries.collect::<Vec<_>>(),
    });
    serde_json::to_string_pretty(&value).unwrap_or_default() + "\n"
}

fn finding(finding: &Finding) -> Json {
    let (kind, number, digit) = match finding {
        Finding::NoAnswer => ("missing", None, None),
        Finding::Number { what: Measure::Velocity, number, digit, .. } => ("velocity", Some(*number), *digit),
        Finding::Number { what: Measure::Position, number, digit, .. } => ("position", Some(*number), *digit),
        Finding::Number { what: Measure::Time, number, digit, .. } => ("time", Some(*number), *digit),
        Finding::Balance { law: Law::Momentum, .. } => ("momentum", None, None),
        Finding::Balance { law: Law::Energy, .. } => ("energy", None, None),
        Finding::Order { number, .. } => ("order", Some(*number), None),
        Finding::Count { .. } => ("count", None, None),
    };
    json!({ "kind": kind, "number": number, "wrong_from_digit": digit, "text": words(finding) })
}
