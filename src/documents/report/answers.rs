//! The answers to a scene as text and as JSON.

use super::padded;
use crate::chain::best::Best;
use crate::chain::recollision::{MAY_WARN, WARNING};
use crate::chain::uncertain::meeting::Meeting;
use crate::chain::{ChainError, threshold::Helps};
use crate::claim::print::Style;
use crate::number::plus_minus::plus_minus;
use crate::number::rational::parse;
use crate::number::real::Level;
use crate::scene::Scene;
use crate::scene::answer::{Answers, Number, Value};
use crate::scene::quantity::Quantity;
use crate::table::count_text;
use serde_json::{Map, Value as Json, json};
use std::fmt::Write;

/// The wanted quantities with their values.
type Found<'a> = Vec<(Quantity, &'a Value, Level)>;

/// Computes the quantities that a scene wants, in its order. The error is the first failure, with its quantity.
fn all<'a>(scene: &Scene, answers: &'a Answers<'_>) -> Result<Found<'a>, (Quantity, ChainError)> {
    scene
        .want
        .iter()
        .map(|q| answers.get(*q).map(|(value, level)| (*q, value, level)).map_err(|error| (*q, error)))
        .collect()
}

/// A warning where velocities are asked for that are not final.
fn warning(answers: &Answers<'_>, scene: &Scene) -> Option<String> {
    let of_pass = [Quantity::Velocities, Quantity::LastVelocity];
    if !scene.want.iter().any(|q| of_pass.contains(q)) {
        return None;
    }
    match answers.get(Quantity::Recollides) {
        Ok((Value::Recollides(Meeting::Always), _)) => Some(format!("velocities: {WARNING}")),
        Ok((Value::Recollides(Meeting::Depends | Meeting::Unsettled), _)) => Some(format!("velocities: {MAY_WARN}")),
        _ => None,
    }
}

fn depends(answer: Option<&'static str>) -> &'static str {
    answer.unwrap_or("depends")
}

/// The best number of bodies, or the range of it, and whether one body fewer transfers exactly as much.
#[must_use]
pub fn best(least: &Best, greatest: &Best) -> (String, bool) {
    let (low, high) = (count_text(least).0, count_text(greatest).0);
    let text = if low == high { low } else { format!("from {low} to {high}") };
    (text, least == greatest && matches!(least, Best::Finite { tie: true, .. }))
}

/// The answers as text.
///
/// # Errors
/// The first quantity that has no answer, and why.
pub fn text(scene: &Scene, answers: &Answers<'_>, explain: bool) -> Result<String, (Quantity, ChainError)> {
    let mut out = String::new();
    let found = all(scene, answers)?;
    out.push_str(&bodies(&found));
    for (quantity, value, level) in found {
        let name = quantity.name();
        match value {
            _ if OF_BODIES.contains(&quantity) => {
                if explain {
                    line(&mut out, name, &format!("arithmetic: {level}"));
                }
                continue;
            }
            Value::Number(number) => number_lines(&mut out, name, number),
            Value::List(numbers) => {
                for (number, place) in numbers.iter().zip(1..) {
                    number_lines(&mut out, &format!("{name}[{place}]"), number);
                }
            }
            Value::Matrices(list) => {
                for (i, rows) in list.iter().enumerate() {
                    for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                        if let Some(number) = rows.get(row).and_then(|r: &[Number; 2]| r.get(column)) {
                            let place = format!("{name}[{}][{}][{}]", i + 1, row + 1, column + 1);
                            number_lines(&mut out, &place, number);
                        }
                    }
                }
            }
            Value::Helps(answer) => line(&mut out, name, depends(answer.map(Helps::text))),
            Value::EachHelps(list) => {
                for (answer, body) in list.iter().zip(1..) {
                    line(&mut out, &format!("{name}[{body}]"), depends(answer.map(Helps::text)));
                }
            }
            Value::Best(least, greatest) => {
                let (text, tie) = best(least, greatest);
                line(&mut out, name, &text);
                if tie {
                    line(&mut out, "", "tie: one body fewer transfers exactly as much");
                }
            }
            Value::Recollides(answer) => {
                line(&mut out, name, answer.text());
            }
            Value::Prepared(_) => {}
        }
        if explain {
            line(&mut out, "", &format!("arithmetic: {level}"));
        }
    }
    if let Some(warning) = warning(answers, scene) {
        let _ = writeln!(out, "warning: {warning}");
    }
    if explain {
        let names = |list: Vec<Quantity>| list.into_iter().map(Quantity::name).collect::<Vec<_>>().join(", ");
        let none = |text: String| if text.is_empty() { "nothing".to_owned() } else { text };
        let _ = writeln!(out, "computed: {}", none(names(answers.computed())));
        let _ = writeln!(out, "skipped: {}", none(names(answers.skipped())));
    }
    Ok(out)
}

/// The known values of each body, as columns of one table.
const OF_BODIES: [Quantity; 2] = [Quantity::Masses, Quantity::Velocities];

/// The table of the bodies, counted from 1 and named as the paper does: m₁, then the inserted μ₁, …, μₙ, then m₂.
fn bodies(found: &Found<'_>) -> String {
    let mut columns: Vec<(&str, &[Number])> = Vec::new();
    for (quantity, value, _) in found {
        if let (true, Value::List(numbers)) = (OF_BODIES.contains(quantity), value) {
            let name = if *quantity == Quantity::Masses { "mass" } else { "velocity" };
            columns.push((name, numbers));
        }
    }
    let count = columns.iter().map(|c| c.1.len()).max().unwrap_or(0);
    if count == 0 {
        return String::new();
    }
    let mut rows = vec![vec!["body".to_owned(), String::new()]];
    for (name, _) in &columns {
        rows[0].extend([(*name).to_owned(), String::new()]);
    }
    for place in 0..count {
        let name = match place {
            0 => "m1".to_owned(),
            _ if place + 1 == count => "m2".to_owned(),
            _ => format!("mu{place}"),
        };
        let mut row = vec![(place + 1).to_string(), Style::Unicode.name(&name)];
        for number in columns.iter().filter_map(|c| c.1.get(place)) {
            row.extend([decimal(number), exactly(number).map_or(String::new(), |exact| format!("= {exact}"))]);
        }
        rows.push(row);
    }
    let mut out = String::new();
    let width = |column: usize| rows.iter().filter_map(|r| r.get(column)).map(|c| c.chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..rows[0].len()).map(width).collect();
    for row in &rows {
        let cells = row.iter().zip(&widths).filter(|(_, width)| **width > 0);
        let cells: Vec<String> = cells.map(|(cell, width)| padded(cell, *width, false)).collect();
        out += &format!("{}\n", cells.join("  ").trim_end());
    }
    out
}

/// The decimal, or its ends.
fn decimal(number: &Number) -> String {
    let (lower, upper) = &number.enclosure;
    number.decimal.clone().or_else(|| measured(number)).unwrap_or_else(|| format!("from {lower} to {upper}"))
}

/// The exact form, if it says more than the decimal and is short enough.
fn exactly(number: &Number) -> Option<String> {
    match (&number.exact, &number.radical) {
        (Some(exact), _) => Some(exact.to_string()).filter(|exact| number.decimal.as_ref() != Some(exact)),
        (None, radical) => radical.clone(),
    }
    .map(|exact| shortened(&exact))
}

fn line(out: &mut String, name: &str, value: &str) {
    let _ = writeln!(out, "{name:<14} {value}");
}

fn number_lines(out: &mut String, name: &str, number: &Number) {
    line(out, name, &decimal(number));
    if measured(number).is_some() {
        let (lower, upper) = &number.enclosure;
        line(out, "", &format!("from {lower} to {upper}"));
    }
    if let Some(exact) = exactly(number) {
        line(out, "", &format!("= {exact}"));
    }
}

/// A range as its centre ± its half-width, with as many digits as are certain.
fn measured(number: &Number) -> Option<String> {
    if number.decimal.is_some() {
        return None;
    }
    let (lower, upper) = &number.enclosure;
    plus_minus(&parse(lower).ok()?, &parse(upper).ok()?)
}

/// Long exact forms fill no screen; JSON has them in full.
fn shortened(text: &str) -> String {
    const LONGEST: usize = 200;
    if text.len() <= LONGEST {
        return text.to_owned();
    }
    let head: String = text.chars().take(LONGEST - 60).collect();
    format!("{head}… ({} characters)", text.len())
}

/// The answers as JSON.
///
/// # Errors
/// The first quantity that has no answer, and why.
pub fn json(scene: &Scene, answers: &Answers<'_>, explain: bool) -> Result<String, (Quantity, ChainError)> {
    let digits = scene.digits.count();
    let mut object = Map::new();
    let mut levels = Map::new();
    let mut dearest = Level::Double;
    for (quantity, value, level) in all(scene, answers)? {
        let value = match value {
            Value::Number(number) => number_json(number, digits),
            Value::List(numbers) => numbers.iter().map(|n| number_json(n, digits)).collect(),
            Value::Matrices(list) => list
                .iter()
                .map(|rows| {
                    let rows = rows.iter().map(|row| row.iter().map(|n| number_json(n, digits)).collect());
                    Json::Array(rows.collect())
                })
                .collect(),
            Value::Helps(answer) => json!(depends(answer.map(Helps::text))),
            Value::EachHelps(list) => list.iter().map(|answer| depends(answer.map(Helps::text))).collect(),
            Value::Best(least, greatest) => best_json(least, greatest),
            Value::Recollides(Meeting::Always) => json!(true),
            Value::Recollides(Meeting::Never) => json!(false),
            Value::Recollides(other) => json!(other.text()),
            Value::Prepared(_) => Json::Null,
        };
        levels.insert(quantity.name().to_owned(), json!(level.to_string()));
        dearest = dearest.max(level);
        object.insert(quantity.name().to_owned(), value);
    }
    if let Some(warning) = warning(answers, scene) {
        object.insert("warnings".to_owned(), json!([warning]));
    }
    if explain {
        let names = |list: Vec<Quantity>| list.into_iter().map(Quantity::name).collect::<Vec<_>>();
        object.insert("computed".to_owned(), json!(names(answers.computed())));
        object.insert("skipped".to_owned(), json!(names(answers.skipped())));
        let level = if levels.is_empty() { Json::Null } else { json!(dearest.to_string()) };
        object.insert("level".to_owned(), level);
        object.insert("levels".to_owned(), Json::Object(levels));
    }
    let mut out = serde_json::to_string_pretty(&Json::Object(object)).unwrap_or_default();
    out.push('\n');
    Ok(out)
}

fn number_json(number: &Number, digits: u64) -> Json {
    json!({
        "exact": number.exact.as_ref().map(ToString::to_string),
        "radical": number.radical,
        "enclosure": [number.enclosure.0, number.enclosure.1],
        "decimal": number.decimal,
        "measured": measured(number),
        "digits": digits,
    })
}

fn best_json(least: &Best, greatest: &Best) -> Json {
    let (low, high) = (count_text(least).0, count_text(greatest).0);
    let same = (least == greatest).then(|| low.clone());
    json!({
        "exact": same,
        "radical": null,
        "enclosure": [low, high],
        "decimal": same,
        "digits": same.as_ref().map(String::len),
        "tie": best(least, greatest).1,
    })
}
