//! A replay as one self-contained page: the bodies move, a cursor runs up the space–time diagram.
//!
//! The page needs nothing from elsewhere. Its motion is drawn from doubles; the numbers in its table and the words on
//! how it ended are those of the text report.

use super::svg::{Frame, Worldlines, caption, colour, draw};
use super::text::{JOINED, verdict};
use super::{Numbers, Replay, group, pair};
use crate::chain::replay::{Entry, Value};
use crate::report::markup::escape;
use serde_json::json;
use std::fmt::Write;

/// The most collisions in the table of the page.
const ROWS: usize = 200;

/// The page.
#[must_use]
pub fn report(replay: &Replay) -> String {
    let lines = Worldlines::new(replay);
    let frame = Frame::around(&lines);
    let title = escape(replay.title.unwrap_or("Collisions on a line"));
    let mut diagram = String::new();
    draw(replay, &lines, &frame, &mut diagram);
    let masses: Vec<f64> = (1..=lines.bodies.len())
        .map(|b| {
            let mass = replay.line.mass(b).map(|m| crate::chain::replay::Value::Exact(m.clone()));
            mass.map_or(1.0, |m| super::svg::near(&m))
        })
        .collect();
    let heaviest = masses.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let unit = frame.width / (frame.x.1 - frame.x.0);
    let bodies: Vec<serde_json::Value> = lines
        .bodies
        .iter()
        .enumerate()
        .map(|(i, path)| {
            // Volumes in proportion to masses, small ones still visible.
            let radius = (16.0 * (masses[i] / heaviest).cbrt()).max(4.0);
            json!({"path": path, "colour": colour(i), "radius": radius, "half": lines.half[i] * unit})
        })
        .collect();
    let collisions: Vec<bool> = replay.outcome.in_order().map(|entry| matches!(entry, Entry::Collision(..))).collect();
    let data = json!({
        "bodies": bodies,
        "contacts": lines.contacts.iter().map(|c| c.0).collect::<Vec<_>>(),
        "collisions": collisions,
        "end": lines.end,
        "top": frame.t.1,
        "x": [frame.x.0, frame.x.1],
        "frame": [frame.left, frame.top, frame.width, frame.height],
        "walls": [lines.walls.0, lines.walls.1],
    });
    // Inside a script element "</" could end it.
    let data = data.to_string().replace("</", "<\\/");
    PAGE.replace("@TITLE@", &title)
        .replace("@CAPTION@", &escape(&caption(replay)))
        .replace("@VERDICT@", &escape(&verdict(replay)))
        .replace("@DIAGRAM@", &diagram)
        .replace("@HIDDEN@", if lines.contacts.is_empty() { " hidden" } else { "" })
        .replace("@ROWS@", &rows(replay))
        .replace("@NOTES@", &notes(replay))
        .replace("@DATA@", &data)
}

/// The listed collisions, one row each.
fn rows(replay: &Replay) -> String {
    let mut rows = String::new();
    let n = |v: &Value| replay.numbers.write(v);
    let q = |x| replay.numbers.rational(x);
    for entry in replay.outcome.in_order().take(ROWS) {
        let cells = match entry {
            Entry::Collision(number, c) => [
                number.to_string(),
                n(&c.time),
                pair(replay.line, c.pair),
                n(&c.before[0]),
                n(&c.before[1]),
                n(&c.after[0]),
                n(&c.after[1]),
                n(&c.lost),
            ],
            Entry::Joined(j) => [
                "∞".to_string(),
                n(&j.time),
                group(replay.line, j.bodies),
                q(&j.before[0]),
                q(&j.before[1]),
                q(&j.velocity),
                q(&j.velocity),
                q(&j.lost),
            ],
        };
        let cells: String = cells.iter().map(|cell| format!("<td>{}</td>", escape(cell))).collect();
        let _ = writeln!(rows, "<tr>{cells}</tr>");
    }
    rows
}

/// What the table does not say by itself.
fn notes(replay: &Replay) -> String {
    let o = replay.outcome;
    let mut notes = Vec::new();
    let shown = o.in_order().take(ROWS).filter(|entry| matches!(entry, Entry::Collision(..))).count();
    let more = o.count.saturating_sub(shown as u64);
    if more > 0 {
        notes.push(format!("{more} more collisions are not in this table."));
    }
    if !o.joined.is_empty() {
        notes.push(JOINED.to_string());
    }
    if matches!(replay.numbers, Numbers::Short(..)) && !o.events.is_empty() {
        notes.push("Numbers with a decimal point are rounded, all others are exact.".to_string());
    }
    notes.iter().map(|note| format!("<p>{}</p>", escape(note))).collect()
}

const PAGE: &str = include_str!("page.html");
