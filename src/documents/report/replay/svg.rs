//! A replay as a space–time diagram: place to the right, time upward.
//!
//! Drawing is done in doubles: a picture shows, it decides nothing. Only listed collisions are drawn; where there
//! are more, the caption says so.

mod worldlines;

use super::{Replay, counted, decimal};
use crate::chain::replay::{Status, Value};
use crate::report::markup::escape;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use std::fmt::Write;
pub use worldlines::Worldlines;

/// Colours that people with any colour vision tell apart (Okabe and Ito), darkest first.
const COLOURS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#555555"];

/// The colour of a body, counted from 0.
pub(super) fn colour(body: usize) -> &'static str {
    COLOURS[body % COLOURS.len()]
}

/// Beyond this, numbers are drawn at the edge: sums and products of what is drawn stay finite.
const EDGE: f64 = 1e100;

/// A double near the number.
pub(super) fn near(value: &Value) -> f64 {
    let (lo, hi) = value.enclose(80);
    let middle = (lo + hi) / malachite::Rational::from(2);
    f64::rounding_from(&middle, RoundingMode::Nearest).0.clamp(-EDGE, EDGE)
}

/// Where the picture puts things.
pub(super) struct Frame {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
    pub x: (f64, f64),
    pub t: (f64, f64),
}

impl Frame {
    /// The frame of the diagram around worldlines.
    pub(super) fn around(lines: &Worldlines) -> Frame {
        Frame { left: 78.0, top: 64.0, width: 742.0, height: 500.0, x: lines.range, t: (0.0, lines.end * 1.04) }
    }

    /// Across the page.
    pub(super) fn across(&self, x: f64) -> f64 {
        self.left + (x - self.x.0) / (self.x.1 - self.x.0) * self.width
    }

    /// Down the page: later is higher.
    pub(super) fn down(&self, t: f64) -> f64 {
        self.top + self.height - (t - self.t.0) / (self.t.1 - self.t.0) * self.height
    }
}

/// Round numbers from `lo` to `hi`, about six, each with a text that does not say more than it knows.
pub(super) fn ticks(lo: f64, hi: f64) -> Vec<(f64, String)> {
    let raw = (hi - lo) / 6.0;
    if !raw.is_finite() || raw <= 0.0 {
        return Vec::new();
    }
    let power = 10f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].iter().map(|m| m * power).find(|s| *s >= raw).unwrap_or(raw);
    let places = usize::try_from((-step.log10().floor()) as i64).unwrap_or(0).min(12);
    let large = !(1e-6..1e6).contains(&step);
    let mut found = Vec::new();
    let mut k = (lo / step).ceil();
    while k * step <= hi + step * 1e-9 && found.len() < 20 {
        let x = k * step + 0.0;
        found.push((x, if large { format!("{x:.2e}") } else { format!("{x:.places$}") }));
        k += 1.0;
    }
    found
}

/// One line on how the replay ended.
pub(super) fn caption(replay: &Replay) -> String {
    let o = replay.outcome;
    let mut text = match &o.status {
        Status::Complete => counted(o),
        Status::Collapse(found) => {
            format!("infinitely many collisions before t = {} ({} drawn)", decimal(&found.time, 8), o.events.len())
        }
        Status::Limit(_) => format!("stopped at a limit after {}", counted(o)),
        Status::Ambiguous(found) => {
            format!("{}, then an ambiguous contact at t = {}", counted(o), replay.numbers.rational(&found.time))
        }
    };
    if (o.events.len() as u64) < o.count {
        let _ = write!(text, "; the first {} are drawn", o.events.len());
    }
    text
}

/// The diagram.
#[must_use]
pub fn report(replay: &Replay) -> String {
    let lines = Worldlines::new(replay);
    let frame = Frame::around(&lines);
    let mut out = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 860 640\" width=\"860\" height=\"640\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"14\" role=\"img\">\n",
    );
    let title = replay.title.unwrap_or("Collisions on a line");
    let _ = writeln!(out, "<title>{}</title>", escape(title));
    out.push_str("<rect width=\"860\" height=\"640\" fill=\"#ffffff\"/>\n");
    let _ =
        writeln!(out, "<text x=\"{}\" y=\"26\" font-size=\"18\" fill=\"#111\">{}</text>", frame.left, escape(title));
    let _ = writeln!(out, "<text x=\"{}\" y=\"48\" fill=\"#444\">{}</text>", frame.left, escape(&caption(replay)));
    draw(replay, &lines, &frame, &mut out);
    out.push_str("</svg>\n");
    out
}

/// Axes and worldlines.
pub(super) fn draw(replay: &Replay, lines: &Worldlines, frame: &Frame, out: &mut String) {
    let (l, r) = (frame.left, frame.left + frame.width);
    let (top, bottom) = (frame.top, frame.top + frame.height);
    scales(frame, out);
    let _ = writeln!(
        out,
        "<clipPath id=\"plot\"><rect x=\"{l}\" y=\"{top}\" width=\"{}\" height=\"{}\"/></clipPath>\n<g clip-path=\"url(#plot)\">",
        frame.width, frame.height
    );
    let many = lines.bodies.len() > 40;
    inside(lines, frame, if many { 0.8 } else { 2.2 }, out);
    out.push_str("</g>\n");
    let _ = writeln!(out, "<path d=\"M{l} {top}V{bottom}H{r}\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.2\"/>");
    if !many {
        labels(replay, lines, frame, out);
    }
}

/// The scales of place and time, with their ticks.
fn scales(frame: &Frame, out: &mut String) {
    let (l, r) = (frame.left, frame.left + frame.width);
    let (top, bottom) = (frame.top, frame.top + frame.height);
    for (t, text) in ticks(frame.t.0, frame.t.1) {
        let y = frame.down(t);
        let _ = writeln!(out, "<path d=\"M{l:.1} {y:.2}H{r:.1}\" stroke=\"#e4e4e4\"/>");
        let _ = writeln!(
            out,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\" fill=\"#333\">{}</text>",
            l - 8.0,
            y + 5.0,
            minus(&text)
        );
    }
    for (x, text) in ticks(frame.x.0, frame.x.1) {
        let at = frame.across(x);
        let _ = writeln!(out, "<path d=\"M{at:.2} {top:.1}V{bottom:.1}\" stroke=\"#f0f0f0\"/>");
        let _ = writeln!(
            out,
            "<text x=\"{at:.1}\" y=\"{:.1}\" text-anchor=\"middle\" fill=\"#333\">{}</text>",
            bottom + 20.0,
            minus(&text)
        );
    }
    let _ = writeln!(
        out,
        "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\" fill=\"#111\">place</text>",
        (l + r) / 2.0,
        bottom + 62.0
    );
    let _ = writeln!(
        out,
        "<text transform=\"translate(20 {:.1}) rotate(-90)\" text-anchor=\"middle\" fill=\"#111\">time</text>",
        (top + bottom) / 2.0
    );
}

/// What is drawn in the frame: walls, bodies, contacts, and infinitely many collisions.
fn inside(lines: &Worldlines, frame: &Frame, width: f64, out: &mut String) {
    let (top, bottom) = (frame.top, frame.top + frame.height);
    for (wall, side) in [(lines.walls.0, -1.0), (lines.walls.1, 1.0)] {
        if let Some(x) = wall {
            let at = frame.across(x);
            let from = if side < 0.0 { at - 60.0 } else { at };
            let _ = writeln!(
                out,
                "<rect x=\"{from:.2}\" y=\"{top}\" width=\"60\" height=\"{}\" fill=\"#cccccc\"/><path d=\"M{at:.2} {top}V{bottom}\" stroke=\"#555\" stroke-width=\"2\"/>",
                frame.height
            );
        }
    }
    for (i, (path, half)) in lines.bodies.iter().zip(&lines.half).enumerate() {
        let at = |side: f64| {
            path.iter().map(move |(t, x)| format!("{:.2} {:.2}", frame.across(x + side * half), frame.down(*t)))
        };
        if *half > 0.0 {
            let edge: Vec<String> = at(-1.0).chain(at(1.0).rev()).collect();
            let _ = writeln!(
                out,
                "<path d=\"M{}Z\" fill=\"{}\" fill-opacity=\"0.35\" stroke=\"none\"/>",
                edge.join("L"),
                colour(i)
            );
        }
        let corners: Vec<String> = at(0.0).collect();
        let _ = writeln!(
            out,
            "<path d=\"M{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"/>",
            corners.join("L"),
            colour(i)
        );
    }
    if lines.contacts.len() <= 400 {
        for (t, x) in &lines.contacts {
            let (cx, cy) = (frame.across(*x), frame.down(*t));
            let _ = writeln!(out, "<circle cx=\"{cx:.2}\" cy=\"{cy:.2}\" r=\"3\" fill=\"#111\"/>");
        }
    }
    for (t, x) in lines.marks.iter().take(400) {
        let (cx, cy) = (frame.across(*x), frame.down(*t));
        let _ = writeln!(
            out,
            "<circle cx=\"{cx:.2}\" cy=\"{cy:.2}\" r=\"9\" fill=\"none\" stroke=\"#b00020\" stroke-width=\"2.5\"/>"
        );
    }
}

/// The number and mass of each body under its start, no two texts over one another.
fn labels(replay: &Replay, lines: &Worldlines, frame: &Frame, out: &mut String) {
    let y = frame.top + frame.height + 40.0;
    let mut free = f64::NEG_INFINITY;
    for (i, path) in lines.bodies.iter().enumerate() {
        let Some((_, x)) = path.first() else { continue };
        let mass = replay.line.mass(i + 1).map(|m| m.to_string()).unwrap_or_default();
        let text = if mass.len() <= 8 { format!("{} (m={mass})", i + 1) } else { (i + 1).to_string() };
        let wide = 7.4 * text.chars().count() as f64;
        let at = (frame.across(*x) - wide / 2.0).clamp(frame.left - 30.0, frame.left + frame.width - wide + 30.0);
        if at >= free {
            free = at + wide + 8.0;
            let _ = writeln!(out, "<text x=\"{at:.1}\" y=\"{y:.1}\" fill=\"{}\">{text}</text>", colour(i));
        }
    }
}

/// A true minus sign.
fn minus(text: &str) -> String {
    text.replace('-', "−")
}
