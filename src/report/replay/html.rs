//! A replay as one self-contained page: the bodies move, a cursor runs up the space–time diagram.
//!
//! The page needs nothing from elsewhere. Its motion is drawn from doubles; the numbers in its table are those of
//! the replay.

use super::svg::{Frame, Worldlines, caption, colour, draw};
use super::{Replay, pair};
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
    let data = json!({
        "bodies": bodies,
        "contacts": lines.contacts.iter().map(|c| c.0).collect::<Vec<_>>(),
        "end": lines.end,
        "top": frame.t.1,
        "x": [frame.x.0, frame.x.1],
        "frame": [frame.left, frame.top, frame.width, frame.height],
        "walls": [lines.walls.0, lines.walls.1],
    });
    // Inside a script element "</" could end it.
    let data = data.to_string().replace("</", "<\\/");
    let mut rows = String::new();
    let n = |v| escape(&replay.numbers.write(v));
    for (i, c) in replay.outcome.events.iter().enumerate().take(ROWS) {
        let _ = writeln!(
            rows,
            "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            i + 1,
            n(&c.time),
            escape(&pair(replay.line, c.pair)),
            n(&c.before[0]),
            n(&c.before[1]),
            n(&c.after[0]),
            n(&c.after[1]),
            n(&c.lost)
        );
    }
    let more = replay.outcome.count.saturating_sub(replay.outcome.events.len().min(ROWS) as u64);
    let more = if more > 0 { format!("<p>{more} more collisions are not in this table.</p>") } else { String::new() };
    PAGE.replace("@TITLE@", &title)
        .replace("@CAPTION@", &escape(&caption(replay)))
        .replace("@DIAGRAM@", &diagram)
        .replace("@ROWS@", &rows)
        .replace("@MORE@", &more)
        .replace("@DATA@", &data)
}

const PAGE: &str = include_str!("page.html");
