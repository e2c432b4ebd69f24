//! A sketch of the bodies before the first collision: how they stand, each with its mass and its velocity.
//!
//! Contract: bodies stand in the order of the track, or of the stack from the floor up, at even distances. An arrow says in
//! which direction a body moves, not how fast. Every stroke is horizontal, vertical or an arrowhead of 45°, so that each form of
//! a sheet can draw it; no stroke or label lies outside of the width that is given.

use super::setting::bodies;
use super::{Style, Subject, Units, written};
use crate::number::NumberError;
use crate::report::padded;
use crate::table::worksheet::Entry;
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
use std::cmp::Ordering;

/// More bodies than these make no sketch.
const DRAWN: usize = 8;
/// The width and the height of a box.
const BOX: (f32, f32) = (26.0, 18.0);
/// The length of an arrow, and of its head.
const ARROW: (f32, f32) = (20.0, 4.0);
/// From one body of a stack to the next.
const STOREY: f32 = 32.0;
/// The widest room for a body of a row.
const CELL: f32 = 110.0;
/// The size of labels, and how wide a letter is at most, in its size.
const LETTER: f32 = 8.5;
const WIDE: f32 = 0.66;

/// The bodies before the first collision.
#[derive(Clone, Debug)]
pub struct Sketch {
    bodies: Vec<Body>,
    /// On a floor, the first body lowest, instead of in a row from the left.
    upright: bool,
}

#[derive(Clone, Debug)]
struct Body {
    mass: String,
    velocity: String,
    /// Above for to the right or upwards.
    direction: Ordering,
}

/// A part of a drawing, in points from its upper left corner.
#[derive(Clone, Debug, PartialEq)]
pub enum Stroke {
    /// From one point to the next.
    Line(Vec<(f32, f32)>),
    /// A text whose line has its middle there, and the size of its letters.
    Label((f32, f32), String, f32),
}

impl Sketch {
    /// The sketch of a sheet; `None` where there are too many bodies, or where it is open in which direction one moves.
    pub(super) fn of(subject: &Subject<'_>, units: &Units, style: Style) -> Result<Option<Sketch>, NumberError> {
        let zero = Entry::exact(&Rational::ZERO);
        let named = |text: String, unit: &Option<String>| match unit {
            Some(unit) if text.contains('±') => format!("({text}) {unit}"),
            Some(unit) => format!("{text} {unit}"),
            None => text,
        };
        let mut list = Vec::new();
        for body in bodies(subject.worksheet) {
            let Some(direction) = body.velocity.before.compared(&zero) else { return Ok(None) };
            let velocity = match direction {
                Ordering::Equal => "at rest".to_owned(),
                _ => named(written(&body.velocity.before, style)?.replace('-', "−"), &units.velocity),
            };
            let mass = written(&body.mass, style)?;
            let mass = if units.mass.is_some() { named(mass, &units.mass) } else { format!("m = {mass}") };
            let velocity = if units.velocity.is_some() || direction == Ordering::Equal {
                velocity
            } else {
                format!("v = {velocity}")
            };
            list.push(Body { mass, velocity, direction });
        }
        Ok((2..=DRAWN).contains(&list.len()).then_some(Sketch { bodies: list, upright: subject.drop.is_some() }))
    }

    /// What a reader hears who does not see it.
    #[must_use]
    pub fn description(&self) -> String {
        let one = |(place, body): (usize, &Body)| format!("body {}: {}, {}", place + 1, body.mass, body.velocity);
        let list: Vec<String> = self.bodies.iter().enumerate().map(one).collect();
        let order = if self.upright { "from the floor up" } else { "from left to right" };
        format!("Sketch, {order}: {}", list.join("; "))
    }

    /// Whether the bodies stand one above the other.
    #[must_use]
    pub fn is_upright(&self) -> bool {
        self.upright
    }

    /// How high the drawing is.
    #[must_use]
    pub fn height(&self) -> f32 {
        if self.upright { self.bodies.len() as f32 * STOREY + 8.0 } else { BOX.1 + 40.0 }
    }

    /// The drawing in this width.
    #[must_use]
    pub fn strokes(&self, width: f32) -> Vec<Stroke> {
        if self.upright { self.stack(width) } else { self.row(width) }
    }

    fn row(&self, width: f32) -> Vec<Stroke> {
        let cell = CELL.min(width / self.bodies.len() as f32);
        let track = BOX.1 + 4.0;
        let mut out = vec![Stroke::Line(vec![(0.0, track), (cell * self.bodies.len() as f32, track)])];
        for (place, body) in self.bodies.iter().enumerate() {
            let middle = cell * (place as f32 + 0.5);
            out.extend(framed(place, (middle, track - BOX.1 / 2.0)));
            let from = (middle, track - BOX.1 / 2.0);
            let end = BOX.0 / 2.0 + ARROW.0.min((cell - BOX.0) / 2.0);
            match body.direction {
                Ordering::Greater => out.extend(arrow((from.0 + BOX.0 / 2.0, from.1), (from.0 + end, from.1))),
                Ordering::Less => out.extend(arrow((from.0 - BOX.0 / 2.0, from.1), (from.0 - end, from.1))),
                Ordering::Equal => {}
            }
            out.push(fitted(&body.mass, (middle, track + 11.0), cell));
            out.push(fitted(&body.velocity, (middle, track + 24.0), cell));
        }
        out
    }

    fn stack(&self, width: f32) -> Vec<Stroke> {
        let floor = self.height() - 4.0;
        let side = CELL.min((width - BOX.0 - 30.0) / 2.0);
        let middle = side + BOX.0 / 2.0;
        let mut out = vec![Stroke::Line(vec![(0.0, floor), (2.0 * side + BOX.0 + 30.0, floor)])];
        for (place, body) in self.bodies.iter().enumerate() {
            let at = (middle, floor - STOREY * place as f32 - BOX.1 / 2.0 - 6.0);
            out.extend(framed(place, at));
            let (x, reach) = (middle + BOX.0 / 2.0 + 12.0, BOX.1 / 2.0);
            match body.direction {
                Ordering::Greater => out.extend(arrow((x, at.1 + reach), (x, at.1 - reach))),
                Ordering::Less => out.extend(arrow((x, at.1 - reach), (x, at.1 + reach))),
                Ordering::Equal => {}
            }
            out.push(fitted(&body.mass, (side / 2.0, at.1), side));
            out.push(fitted(&body.velocity, (x + 12.0 + side / 2.0, at.1), side));
        }
        out
    }

    /// The drawing in letters.
    #[must_use]
    pub fn lines(&self) -> Vec<String> {
        let boxed = |(place, body): (usize, &Body)| match (self.upright, body.direction) {
            (false, Ordering::Greater) => format!("[{}]-->", place + 1),
            (false, Ordering::Less) => format!("<--[{}]", place + 1),
            (true, Ordering::Greater) => format!("[{}] ^", place + 1),
            (true, Ordering::Less) => format!("[{}] v", place + 1),
            (_, Ordering::Equal) => format!("[{}]", place + 1),
        };
        let pictures: Vec<String> = self.bodies.iter().enumerate().map(boxed).collect();
        let masses: Vec<String> = self.bodies.iter().map(|body| body.mass.clone()).collect();
        let velocities: Vec<String> = self.bodies.iter().map(|body| body.velocity.clone()).collect();
        let widest = |list: &[String]| list.iter().map(|text| text.chars().count()).max().unwrap_or(0);
        if self.upright {
            let widths = [widest(&pictures), widest(&masses), widest(&velocities)];
            let row = |place: usize| {
                let cells = [&pictures[place], &masses[place], &velocities[place]];
                let cells: Vec<String> =
                    cells.iter().zip(widths).map(|(text, width)| padded(text, width, false)).collect();
                cells.join("   ").trim_end().to_owned()
            };
            let mut lines: Vec<String> = (0..self.bodies.len()).rev().map(row).collect();
            lines.push(format!("{} floor", "=".repeat(widths[0] + widths[1] + 3)));
            return lines;
        }
        let width = [&pictures, &masses, &velocities].map(|list| widest(list)).into_iter().max().unwrap_or(0) + 2;
        let row = |list: &[String]| {
            let cells: Vec<String> = list.iter().map(|text| padded(text, width, false)).collect();
            cells.concat().trim_end().to_owned()
        };
        vec![row(&pictures), "=".repeat(width * self.bodies.len()), row(&masses), row(&velocities)]
    }
}

/// A box with the number of a body.
fn framed(place: usize, (x, y): (f32, f32)) -> [Stroke; 2] {
    let (w, h) = (BOX.0 / 2.0, BOX.1 / 2.0);
    let corners = vec![(x - w, y - h), (x + w, y - h), (x + w, y + h), (x - w, y + h), (x - w, y - h)];
    [Stroke::Line(corners), Stroke::Label((x, y), (place + 1).to_string(), LETTER)]
}

/// An arrow along an axis.
fn arrow(from: (f32, f32), to: (f32, f32)) -> [Stroke; 3] {
    let sign = |a: f32, b: f32| if a == b { 0.0 } else { (b - a).signum() };
    let (dx, dy) = (sign(from.0, to.0) * ARROW.1, sign(from.1, to.1) * ARROW.1);
    let wing = |turn: f32| (to.0 - dx + turn * dy, to.1 - dy + turn * dx);
    [Stroke::Line(vec![from, to]), Stroke::Line(vec![to, wing(1.0)]), Stroke::Line(vec![to, wing(-1.0)])]
}

/// A label that is at most so wide.
fn fitted(text: &str, at: (f32, f32), room: f32) -> Stroke {
    let size = LETTER.min((room - 4.0) / (WIDE * text.chars().count().max(1) as f32));
    Stroke::Label(at, text.to_owned(), size)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::plot::letters::Letters;

    #[test]
    fn no_stroke_and_no_label_lies_outside_of_the_width() {
        let letters = Letters::new();
        for upright in [false, true] {
            for count in 2..=DRAWN {
                let directions = [Ordering::Greater, Ordering::Equal, Ordering::Less];
                let body = |place: usize| Body {
                    mass: ["m = 1", "(57.1234567 ± 0.0000012) kg", "123456789/987654 kg"][place % 3].to_owned(),
                    velocity: ["at rest", "−12345678.25 m/s"][place % 2].to_owned(),
                    direction: directions[place % 3],
                };
                let sketch = Sketch { bodies: (0..count).map(body).collect(), upright };
                for width in [455.0, 487.0, 504.0] {
                    for stroke in sketch.strokes(width) {
                        let points = match &stroke {
                            Stroke::Line(points) => points.clone(),
                            Stroke::Label((x, y), text, size) => {
                                let half = letters.width(text, *size) / 2.0;
                                vec![(x - half, y - size / 2.0), (x + half, y + size / 2.0)]
                            }
                        };
                        let inside =
                            |(x, y): &(f32, f32)| *x >= 0.0 && *x <= width && *y >= 0.0 && *y <= sketch.height();
                        assert!(points.iter().all(inside), "{count} {upright} {width}: {stroke:?}");
                    }
                }
            }
        }
    }
}
