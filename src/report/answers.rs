//! The answers to a scene as text and as JSON.

use crate::chain::best::Best;
use crate::chain::recollision::{MAY_WARN, WARNING};
use crate::chain::uncertain::meeting::Meeting;
use crate::chain::{ChainError, threshold::Helps};
use crate::number::real::Level;
use crate::scene::Scene;
use crate::scene::answer::{Answers, Number, Value};
use crate::scene::quantity::Quantity;
use serde_json::{Map, Value as Json, json};
use std::fmt::Write;

/// What was wanted and what came out.
type Found<'a> = Vec<(Quantity, &'a Value, Level)>;

/// Computes what a scene wants, in its order; the first failure with its quantity.
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

fn best_text(best: &Best) -> String {
    match best {
        Best::Finite { count, .. } => count.to_string(),
        Best::Infinite => "infinite".to_owned(),
        Best::Any => "any".to_owned(),
    }
}

fn is_tie(best: &Best) -> bool {
    matches!(best, Best::Finite { tie: true, .. })
}

/// The answers as text.
///
/// # Errors
/// The first quantity that has no answer, and why.
pub fn text(scene: &Scene, answers: &Answers<'_>, explain: bool) -> Result<String, (Quantity, ChainError)> {
    let mut out = String::new();
    for (quantity, value, level) in all(scene, answers)? {
        let name = quantity.name();
        match value {
            Value::Number(number) => number_lines(&mut out, name, number),
            Value::List(numbers) => {
                // Body 0 is the first one; collision 1 is its own, and body 1 the first inserted one.
                let first = usize::from(matches!(quantity, Quantity::Losses | Quantity::Threshold));
                for (i, number) in numbers.iter().enumerate() {
                    number_lines(&mut out, &format!("{name}[{}]", i + first), number);
                }
            }
            Value::Matrices(list) => {
                for (i, rows) in list.iter().enumerate() {
                    for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                        if let Some(number) = rows.get(row).and_then(|r: &[Number; 2]| r.get(column)) {
                            number_lines(&mut out, &format!("{name}[{}][{row}][{column}]", i + 1), number);
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
                let range = if least == greatest {
                    best_text(least)
                } else {
                    format!("from {} to {}", best_text(least), best_text(greatest))
                };
                line(&mut out, name, &range);
                if is_tie(least) && least == greatest {
                    line(&mut out, "", "one body fewer transfers exactly as much");
                }
            }
            Value::Recollides(answer) => {
                line(&mut out, name, answer.text());
            }
            Value::Prepared(_) => {}
        }
        if explain {
            line(&mut out, "", &format!("settled at level {level}"));
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

fn line(out: &mut String, name: &str, value: &str) {
    let _ = writeln!(out, "{name:<14} {value}");
}

fn number_lines(out: &mut String, name: &str, number: &Number) {
    let (lower, upper) = &number.enclosure;
    match &number.decimal {
        Some(decimal) => line(out, name, decimal),
        None => line(out, name, &format!("from {lower} to {upper}")),
    }
    match (&number.exact, &number.radical) {
        (Some(exact), _) if number.decimal.as_ref() != Some(&exact.to_string()) => {
            line(out, "", &format!("= {}", shortened(&exact.to_string())));
        }
        (None, Some(radical)) => line(out, "", &format!("= {}", shortened(radical))),
        _ => {}
    }
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
        "digits": digits,
    })
}

fn best_json(least: &Best, greatest: &Best) -> Json {
    let (low, high) = (best_text(least), best_text(greatest));
    let same = (least == greatest).then(|| low.clone());
    json!({
        "exact": same,
        "radical": null,
        "enclosure": [low, high],
        "decimal": same,
        "digits": same.as_ref().map(String::len),
        "tie": is_tie(least) && least == greatest,
    })
}
