//! A replay as a space–time diagram: place to the right, time upward.
//!
//! Drawing is done in doubles: a picture shows, it decides nothing. Only listed collisions are drawn; where there
//! are more, the caption says so.

use super::{Replay, counted, decimal};
use crate::chain::replay::{Entry, Status, Value};
use crate::report::markup::escape;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use std::fmt::Write;

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

/// The worldlines as corners `(t, x)`, in doubles: for drawing only.
pub struct Worldlines {
    /// One list of corners for each body, first and last at the ends of the picture.
    pub bodies: Vec<Vec<(f64, f64)>>,
    /// Half the length of each body.
    pub half: Vec<f64>,
    /// Where listed collisions happen, infinitely many at once included.
    pub contacts: Vec<(f64, f64)>,
    /// The walls.
    pub walls: (Option<f64>, Option<f64>),
    /// Times and places of infinitely many collisions, and of an ambiguous contact.
    pub marks: Vec<(f64, f64)>,
    /// The last time drawn.
    pub end: f64,
    /// The places drawn.
    pub range: (f64, f64),
}

impl Worldlines {
    /// Follows the listed collisions.
    #[must_use]
    pub fn new(replay: &Replay) -> Worldlines {
        let (line, o) = (replay.line, replay.outcome);
        let exact = |x: &malachite::Rational| near(&Value::Exact(x.clone()));
        let n = line.bodies();
        let half: Vec<f64> = (1..=n).map(|b| line.half_length(b).map_or(0.0, exact)).collect();
        let starts: Vec<(f64, f64)> =
            (1..=n).map(|b| line.start(b).map_or((0.0, 0.0), |(x, v)| (exact(&x), exact(&v)))).collect();
        let mut bodies: Vec<Vec<(f64, f64)>> = starts.iter().map(|(x, _)| vec![(0.0, *x)]).collect();
        let mut speed: Vec<f64> = starts.iter().map(|(_, v)| *v).collect();
        let mut contacts = Vec::new();
        let mut marks = Vec::new();
        for entry in o.in_order() {
            match entry {
                Entry::Collision(_, c) => {
                    let (t, x) = (near(&c.time), near(&c.position));
                    contacts.push((t, x));
                    for (point, after, side) in [(c.pair, &c.after[0], -1.0), (c.pair + 1, &c.after[1], 1.0)] {
                        if (1..=n).contains(&point) {
                            bodies[point - 1].push((t, x + side * half[point - 1]));
                            speed[point - 1] = near(after);
                        }
                    }
                }
                Entry::Joined(j) => {
                    let (t, mut x) = (near(&j.time), near(&j.position));
                    contacts.push((t, x));
                    marks.push((t, x));
                    // The position is where the first two touch: the first ends there, the second begins.
                    if let Some(wide) = j.bodies.0.checked_sub(1).and_then(|first| half.get(first)) {
                        x -= 2.0 * wide;
                    }
                    for body in j.bodies.0.max(1)..=j.bodies.1.min(n) {
                        bodies[body - 1].push((t, x + half[body - 1]));
                        x += 2.0 * half[body - 1];
                        speed[body - 1] = exact(&j.velocity);
                    }
                }
            }
        }
        let all = o.events.len() as u64 == o.count && o.joined.len() as u64 == o.joins;
        let last = contacts.last().map_or(0.0, |c| c.0);
        let stop = if all { near(&o.time).max(last) } else { last };
        // Some room to see who flies where, unless the picture was asked to end here.
        let end = match (&o.status, stop > 0.0) {
            (Status::Complete, true) if all && stop <= last => stop * 1.15,
            (_, true) => stop,
            (_, false) => 1.0,
        }
        .max(1.0 / EDGE);
        match &o.status {
            Status::Collapse(found) if all => {
                let (t, x) = (near(&found.time), near(&found.position));
                marks.push((t, x));
                for point in found.bodies.0.max(1)..=found.bodies.1.min(n) {
                    bodies[point - 1].push((t, near(&o.positions[point - 1])));
                    speed[point - 1] = near(&o.velocities[point - 1]);
                }
            }
            Status::Ambiguous(found) if all => {
                let point = found.bodies.0.clamp(1, n);
                marks.push((near(&o.time), near(&o.positions[point - 1]) + half[point - 1]));
            }
            _ => {}
        }
        for (path, v) in bodies.iter_mut().zip(&speed) {
            if let Some((t, x)) = path.last().copied().filter(|(t, _)| *t < end) {
                path.push((end, x + v * (end - t)));
            }
        }
        let walls = line.walls();
        let walls = (walls.0.as_ref().map(exact), walls.1.as_ref().map(exact));
        // Bodies that fly off after the last collision must not squeeze the rest: what happens sets the range.
        let inside = |(t, _): &&(f64, f64)| *t <= stop || stop == 0.0;
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        let mut grow = |x: f64| range = (range.0.min(x), range.1.max(x));
        for (path, h) in bodies.iter().zip(&half) {
            for (_, x) in path.iter().filter(inside) {
                grow(x - h);
                grow(x + h);
            }
            if let [.., (t0, x0), (t1, x1)] = path.as_slice()
                && *t1 > stop
                && *t1 > *t0
            {
                grow(x0 + (x1 - x0) * (stop.max(*t0) - t0) / (t1 - t0));
            }
        }
        for x in [walls.0, walls.1].into_iter().flatten() {
            grow(x);
        }
        let wide = range.1 - range.0;
        let room = (wide * 0.06).max(1e-9 * range.1.abs());
        let room = if wide > 1.0 / EDGE { room } else { 1.0f64.max(range.1.abs()) };
        let range = (range.0 - room, range.1 + room);
        Worldlines { bodies, half, contacts, walls, marks, end, range }
    }
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
    pub fn around(lines: &Worldlines) -> Frame {
        Frame { left: 78.0, top: 64.0, width: 742.0, height: 500.0, x: lines.range, t: (0.0, lines.end * 1.04) }
    }

    /// Across the page.
    pub fn across(&self, x: f64) -> f64 {
        self.left + (x - self.x.0) / (self.x.1 - self.x.0) * self.width
    }

    /// Down the page: later is higher.
    pub fn down(&self, t: f64) -> f64 {
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
    let _ = writeln!(
        out,
        "<clipPath id=\"plot\"><rect x=\"{l}\" y=\"{top}\" width=\"{}\" height=\"{}\"/></clipPath>\n<g clip-path=\"url(#plot)\">",
        frame.width, frame.height
    );
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
    let many = lines.bodies.len() > 40;
    let width = if many { 0.8 } else { 2.2 };
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
    out.push_str("</g>\n");
    let _ = writeln!(out, "<path d=\"M{l} {top}V{bottom}H{r}\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.2\"/>");
    if !many {
        labels(replay, lines, frame, out);
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
