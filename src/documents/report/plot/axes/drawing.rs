//! A chart on its page: the measures of the frame, and the shapes of all marks, ticks and texts.

use super::clip::{area_inside, inside};
use super::{Chart, Key, Mark};
use crate::report::plot::letters::{Letters, plain};
use crate::report::plot::scale::{Scale, Ticks};
use crate::report::plot::shape::{Anchor, BLACK, Colour, DASHES, PALE, PALETTE, Shape, WHITE};
use crate::report::plot::unclear::Unclear;

/// The size of the frame.
const FRAME: (f32, f32) = (432.0, 334.0);
/// The frame's least distances from the page's edges.
const LEFT: f32 = 78.0;
const RIGHT: f32 = 180.0;
const TOP: f32 = 44.0;
const BOTTOM: f32 = 62.0;
/// The least distance of a text from the page's edge.
const EDGE: f32 = 8.0;
/// The least distance of two labels of an axis.
const GAP: f32 = 8.0;
/// Sizes of letters.
const SMALL: f32 = 12.0;
const LARGE: f32 = 14.0;
/// From one line of text to the next.
const LINE: f32 = 18.0;
/// From one line of the legend to the next.
const ENTRY: f32 = 20.0;
/// From the frame to the legend.
const ASIDE: f32 = 14.0;
/// Half the width of a bar's end.
const CAP: f32 = 4.0;
/// From the left edge to the line on which the label of the vertical axis stands, and the room that it takes.
const UPRIGHT: (f32, f32) = (24.0, 34.0);

/// A page with its measures.
pub(super) struct Drawing<'a> {
    pub(super) width: f32,
    pub(super) height: f32,
    /// The left and the upper edge of the frame.
    corner: (f32, f32),
    x: &'a Scale,
    y: &'a Scale,
    across: Ticks,
    upright: Ticks,
    cut: bool,
    title: Vec<String>,
    note: Vec<String>,
    pub(super) shapes: Vec<Shape>,
}

impl<'a> Drawing<'a> {
    /// The measures of the page, from those of its texts.
    pub(super) fn laid_out(chart: &'a Chart) -> Result<Drawing<'a>, Unclear> {
        let letters = Letters::new();
        let small = |text: &str| letters.width(text, SMALL);
        let upright = chart.y.choices().into_iter().find(|ticks| {
            let places: Vec<f32> = ticks.main.iter().map(|t| chart.y.share(t.value) as f32 * FRAME.1).collect();
            places.windows(2).all(|pair| pair[1] - pair[0] >= SMALL + GAP)
        });
        let upright = upright.ok_or_else(|| Unclear::Axis(plain(&chart.y.label)))?;
        let widest = upright.main.iter().map(|t| small(&t.label)).fold(0.0, f32::max);
        let left = LEFT.max(UPRIGHT.1 + widest + 9.0).ceil();
        let aside = chart.legend.iter().map(|(key, text)| key.width() + small(text)).fold(0.0, f32::max);
        let right = RIGHT.max(ASIDE + aside + EDGE).ceil();
        let width = left + FRAME.0 + right;
        let across = chart.x.choices().into_iter().find(|ticks| {
            let boxes = ticks.main.iter().map(|t| {
                let (middle, half) = (left + chart.x.share(t.value) as f32 * FRAME.0, small(&t.label) / 2.0);
                (middle - half, middle + half)
            });
            let boxes: Vec<(f32, f32)> = boxes.collect();
            boxes.windows(2).all(|pair| pair[1].0 - pair[0].1 >= GAP)
                && boxes.iter().all(|b| b.0 >= EDGE && b.1 <= width - EDGE)
        });
        let across = across.ok_or_else(|| Unclear::Axis(plain(&chart.x.label)))?;
        let room = width - 2.0 * EDGE;
        let title = letters.lines(&chart.title, LARGE, room);
        let note = chart.note.as_ref().map_or_else(Vec::new, |note| letters.lines(note, SMALL, room));
        let top = TOP + LINE * (title.len() as f32 - 1.0);
        let height = top + FRAME.1 + BOTTOM + LINE * note.len() as f32;
        let (x, y, corner) = (&chart.x, &chart.y, (left, top));
        Ok(Drawing { width, height, corner, x, y, across, upright, cut: chart.cut, title, note, shapes: Vec::new() })
    }

    /// The point on the page at these shares of the frame's width and height.
    fn point(&self, across: f64, up: f64) -> (f32, f32) {
        (self.corner.0 + across as f32 * FRAME.0, self.corner.1 + FRAME.1 - up as f32 * FRAME.1)
    }

    /// The point on the page of a pair of values, which lie in the frame but for rounding.
    fn at(&self, (x, y): (f64, f64)) -> Result<(f32, f32), Unclear> {
        let (across, up) = (self.x.share(x), self.y.share(y));
        if [across, up].iter().any(|share| !(-1e-3..=1.0 + 1e-3).contains(share)) {
            return Err(Unclear::Outside);
        }
        Ok(self.point(across.clamp(0.0, 1.0), up.clamp(0.0, 1.0)))
    }

    /// The points on the page of a line, in one piece; in several where it is cut off.
    fn all(&self, points: &[(f64, f64)]) -> Result<Vec<Vec<(f32, f32)>>, Unclear> {
        if !self.cut {
            return Ok(vec![points.iter().map(|p| self.at(*p)).collect::<Result<_, _>>()?]);
        }
        Ok(inside(&self.shares(points)?).iter().map(|piece| self.placed(piece)).collect())
    }

    /// The points on the page of an area.
    fn filled(&self, points: &[(f64, f64)]) -> Result<Vec<(f32, f32)>, Unclear> {
        if !self.cut {
            return points.iter().map(|p| self.at(*p)).collect();
        }
        Ok(self.placed(&area_inside(&self.shares(points)?)))
    }

    /// Shares of the frame, which may lie outside of it.
    fn shares(&self, points: &[(f64, f64)]) -> Result<Vec<(f64, f64)>, Unclear> {
        let share = |p: &(f64, f64)| {
            let (across, up) = (self.x.share(p.0), self.y.share(p.1));
            if across.is_nan() || up.is_nan() {
                Err(Unclear::Outside)
            } else {
                Ok((across.clamp(-1e6, 1e6), up.clamp(-1e6, 1e6)))
            }
        };
        points.iter().map(share).collect()
    }

    fn placed(&self, shares: &[(f64, f64)]) -> Vec<(f32, f32)> {
        shares.iter().map(|(across, up)| self.point(*across, *up)).collect()
    }

    /// Whether a value is beyond limits that were given.
    fn beyond(&self, (x, y): (f64, f64)) -> bool {
        self.cut && [self.x.share(x), self.y.share(y)].iter().any(|share| !(-1e-9..=1.0 + 1e-9).contains(share))
    }

    fn line(&mut self, points: Vec<(f32, f32)>, colour: Colour, width: f32) {
        self.shapes.push(Shape::Line { points, colour, width, dash: &[] });
    }

    fn text(&mut self, at: (f32, f32), text: &str, size: f32, anchor: Anchor, upwards: bool) {
        self.shapes.push(Shape::Text { at, text: text.to_owned(), size, anchor, upwards });
    }

    pub(super) fn grid(&mut self) {
        for share in self.across.main.iter().map(|t| self.x.share(t.value)).collect::<Vec<_>>() {
            self.line(vec![self.point(share, 0.0), self.point(share, 1.0)], PALE, 0.7);
        }
        for share in self.upright.main.iter().map(|t| self.y.share(t.value)).collect::<Vec<_>>() {
            self.line(vec![self.point(0.0, share), self.point(1.0, share)], PALE, 0.7);
        }
    }

    pub(super) fn mark(&mut self, mark: &Mark) -> Result<(), Unclear> {
        let style = |number: usize| (PALETTE[number % PALETTE.len()], DASHES[number % DASHES.len()]);
        match mark {
            Mark::Curve(number, points) => {
                let (colour, dash) = style(*number);
                for points in self.all(points)? {
                    self.shapes.push(Shape::Line { points, colour, width: 1.8, dash });
                }
            }
            Mark::Border(points) => {
                for points in self.all(points)? {
                    self.line(points, WHITE, 0.9);
                }
            }
            Mark::Area(points, colour) => {
                let points = self.filled(points)?;
                self.shapes.push(Shape::Area { points, colour: *colour });
            }
            Mark::Bar { number, x, ends } => {
                let colour = style(*number).0;
                for piece in self.all(&[(*x, ends.0), (*x, ends.1)])? {
                    self.line(piece, colour, 1.5);
                }
                for end in [ends.0, ends.1].into_iter().filter(|end| !self.beyond((*x, *end))).collect::<Vec<_>>() {
                    let (x, y) = self.at((*x, end))?;
                    self.line(vec![(x - CAP, y), (x + CAP, y)], colour, 1.5);
                }
            }
            Mark::Own { x, y } => {
                let (left, right) = (self.at((x.0, y.0))?, self.at((x.1, y.1))?);
                let middle = (f32::midpoint(left.0, right.0), f32::midpoint(left.1, right.1));
                if x.0 < x.1 {
                    self.line(vec![(left.0, middle.1), (right.0, middle.1)], BLACK, 1.2);
                    for x in [left.0, right.0] {
                        self.line(vec![(x, middle.1 - CAP), (x, middle.1 + CAP)], BLACK, 1.2);
                    }
                }
                if y.0 < y.1 {
                    self.line(vec![(middle.0, left.1), (middle.0, right.1)], BLACK, 1.2);
                    for y in [left.1, right.1] {
                        self.line(vec![(middle.0 - CAP, y), (middle.0 + CAP, y)], BLACK, 1.2);
                    }
                }
                self.cross(middle);
            }
            Mark::Dot { at, .. } if self.beyond(*at) => {}
            Mark::Dot { number, at, full, radius } => {
                let (at, colour) = (self.at(*at)?, style(*number).0);
                self.shapes.push(Shape::Dot { at, radius: *radius, colour, full: *full });
            }
        }
        Ok(())
    }

    /// A cross with arms of four points, which no curve has.
    fn cross(&mut self, (x, y): (f32, f32)) {
        for width in [4.5, 2.0] {
            let colour = if width > 3.0 { WHITE } else { BLACK };
            self.line(vec![(x - CAP, y - CAP), (x + CAP, y + CAP)], colour, width);
            self.line(vec![(x + CAP, y - CAP), (x - CAP, y + CAP)], colour, width);
        }
    }

    /// A line of the legend, right of the frame.
    pub(super) fn entry(&mut self, place: usize, key: &Key, text: &str) {
        let x = self.corner.0 + FRAME.0 + ASIDE;
        let y = self.corner.1 + ENTRY * (place as f32 + 1.0);
        match key {
            Key::Nothing => {}
            Key::Curve(number) => {
                let (colour, dash) = (PALETTE[number % PALETTE.len()], DASHES[number % DASHES.len()]);
                let points = vec![(x, y - 4.0), (x + 28.0, y - 4.0)];
                self.shapes.push(Shape::Line { points, colour, width: 1.8, dash });
            }
            Key::Dot(number, full) => {
                let colour = PALETTE[number % PALETTE.len()];
                self.shapes.push(Shape::Dot { at: (x + 8.0, y - 4.0), radius: 4.0, colour, full: *full });
            }
            Key::Own => self.cross((x + 8.0, y - 4.0)),
            Key::Area(colour) => {
                let points = vec![(x, y - 11.0), (x + 18.0, y - 11.0), (x + 18.0, y + 2.0), (x, y + 2.0)];
                let mut border = points.clone();
                border.push(points[0]);
                self.shapes.push(Shape::Area { points, colour: *colour });
                self.line(border, BLACK, 0.5);
            }
        }
        self.text((x + key.width(), y), text, SMALL, Anchor::Start, false);
    }

    /// The frame with the ticks and numbers of both axes.
    pub(super) fn frame(&mut self) {
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)];
        self.line(corners.map(|(a, b)| self.point(a, b)).to_vec(), BLACK, 1.0);
        let (across, upright) = (self.across.clone(), self.upright.clone());
        for tick in &across.main {
            let (px, py) = self.point(self.x.share(tick.value), 0.0);
            self.line(vec![(px, py), (px, py + 6.0)], BLACK, 1.0);
            self.text((px, py + 20.0), &tick.label, SMALL, Anchor::Middle, false);
        }
        for value in &across.fine {
            let (px, py) = self.point(self.x.share(*value), 0.0);
            self.line(vec![(px, py), (px, py + 3.0)], BLACK, 0.7);
        }
        for tick in &upright.main {
            let (px, py) = self.point(0.0, self.y.share(tick.value));
            self.line(vec![(px - 6.0, py), (px, py)], BLACK, 1.0);
            self.text((px - 9.0, py + 4.0), &tick.label, SMALL, Anchor::End, false);
        }
        for value in &upright.fine {
            let (px, py) = self.point(0.0, self.y.share(*value));
            self.line(vec![(px - 3.0, py), (px, py)], BLACK, 0.7);
        }
    }

    /// The axes' labels, the note and the title, which is centred over the frame where that leaves it on the page.
    pub(super) fn words(&mut self, chart: &Chart) {
        let (centre, middle) = (self.corner.0 + FRAME.0 / 2.0, self.corner.1 + FRAME.1 / 2.0);
        let bottom = self.corner.1 + FRAME.1 + BOTTOM;
        self.text((centre, bottom - 18.0), &chart.x.label, LARGE, Anchor::Middle, false);
        self.text((UPRIGHT.0, middle), &chart.y.label, LARGE, Anchor::Middle, true);
        for (place, line) in std::mem::take(&mut self.note).iter().enumerate() {
            self.text((self.width / 2.0, bottom + LINE * place as f32 + 4.0), line, SMALL, Anchor::Middle, false);
        }
        let letters = Letters::new();
        for (place, line) in std::mem::take(&mut self.title).iter().enumerate() {
            let half = letters.width(line, LARGE) / 2.0;
            let inside = centre - half >= EDGE && centre + half <= self.width - EDGE;
            let at = if inside { centre } else { self.width / 2.0 };
            self.text((at, 26.0 + LINE * place as f32), line, LARGE, Anchor::Middle, false);
        }
    }
}
