//! A frame with two scales, their ticks and labels, and a legend.

use super::letters::plain;
use super::shape::{Anchor, BLACK, Colour, DASHES, PALE, PALETTE, Page, Shape, WHITE};

/// The size of the page.
const WIDTH: f32 = 690.0;
const HEIGHT: f32 = 440.0;
/// The frame's distances from the page's edges.
const LEFT: f32 = 78.0;
const RIGHT: f32 = 180.0;
const TOP: f32 = 44.0;
const BOTTOM: f32 = 62.0;
/// Sizes of letters.
const SMALL: f32 = 12.0;
const LARGE: f32 = 14.0;

/// A scale.
#[derive(Clone, Debug)]
pub struct Scale {
    /// The values at its two ends.
    pub ends: (f64, f64),
    /// Whether it is logarithmic.
    pub logarithmic: bool,
    /// Whether only whole numbers have ticks.
    pub whole: bool,
    /// What it measures.
    pub label: String,
}

impl Scale {
    /// An even scale.
    #[must_use]
    pub fn even(from: f64, to: f64, label: &str) -> Scale {
        Scale { ends: (from, to), logarithmic: false, whole: false, label: label.to_owned() }
    }

    /// A logarithmic scale; its ends are above 0.
    #[must_use]
    pub fn logarithmic(from: f64, to: f64, label: &str) -> Scale {
        Scale { logarithmic: true, ..Scale::even(from, to, label) }
    }

    /// An even scale of whole numbers.
    #[must_use]
    pub fn whole(from: f64, to: f64, label: &str) -> Scale {
        Scale { whole: true, ..Scale::even(from, to, label) }
    }

    /// The scale in words.
    fn words(&self) -> String {
        let kind = if self.logarithmic { ", logarithmic" } else { "" };
        let end = |v: f64| match v.abs() {
            0.0 | 1e-4..1e6 => v.to_string(),
            _ => format!("{v:e}"),
        };
        let (from, to) = (end(self.ends.0).replace('-', "−"), end(self.ends.1).replace('-', "−"));
        format!("{} from {from} to {to}{kind}", plain(&self.label))
    }

    /// The share of the way from one end to the other.
    fn share(&self, value: f64) -> f64 {
        let (from, to) = self.ends;
        if self.logarithmic { (value / from).ln() / (to / from).ln() } else { (value - from) / (to - from) }
    }

    /// Ticks with their labels, and fine ticks without.
    fn ticks(&self) -> (Vec<(f64, String)>, Vec<f64>) {
        let (from, to) = self.ends;
        let inside = |v: &f64| (-1e-9..=1.0 + 1e-9).contains(&self.share(*v));
        if self.logarithmic {
            let (low, high) = (from.log10().ceil() as i32, to.log10().floor() as i32);
            let step = ((high - low) / 8 + 1).max(1);
            let decades = (low..=high).filter(|k| k.rem_euclid(step) == 0);
            let label =
                |k: i32| if (0..=1).contains(&k) { 10f64.powi(k).to_string() } else { format!("10^{{{}}}", minus(k)) };
            let main: Vec<(f64, String)> = decades.map(|k| (10f64.powi(k), label(k))).collect();
            let fine = (low - 1..=high).flat_map(|k| (2..10).map(move |d| f64::from(d) * 10f64.powi(k)));
            return (main, if step == 1 { fine.filter(inside).collect() } else { Vec::new() });
        }
        let raw = (to - from) / 6.0;
        let power = 10f64.powf(raw.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|s| s * power).into_iter().find(|s| *s >= raw).unwrap_or(raw);
        let step = if self.whole { step.round().max(1.0) } else { step };
        let places = if step >= 1.0 { 0 } else { (-step.log10()).ceil() as usize };
        let (first, last) = ((from / step).ceil() as i64, (to / step + 1e-9).floor() as i64);
        let main = (first..=last).map(|k| k as f64 * step).map(|v| (v, format!("{v:.places$}").replace('-', "−")));
        (main.collect(), Vec::new())
    }
}

/// A whole number with a true minus sign.
fn minus(k: i32) -> String {
    k.to_string().replace('-', "−")
}

/// A picture in the making.
pub struct Chart {
    page: Page,
    x: Scale,
    y: Scale,
    legend: Vec<String>,
}

impl Chart {
    /// A frame with its scales and ticks; `grid` draws fine lines at the ticks.
    #[must_use]
    pub fn new(title: &str, x: Scale, y: Scale, grid: bool) -> Chart {
        let (title, description) = (title.to_owned(), String::new());
        let page = Page { width: WIDTH, height: HEIGHT, title, description, shapes: Vec::new() };
        let mut chart = Chart { page, x, y, legend: Vec::new() };
        if grid {
            chart.grid();
        }
        chart
    }

    /// The point on the page of a pair of values.
    #[must_use]
    pub fn at(&self, x: f64, y: f64) -> (f32, f32) {
        let (a, b) = (self.x.share(x) as f32, self.y.share(y) as f32);
        (LEFT + a * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - b * (HEIGHT - TOP - BOTTOM))
    }

    fn line(&mut self, points: Vec<(f32, f32)>, colour: Colour, width: f32) {
        self.page.shapes.push(Shape::Line { points, colour, width, dash: &[] });
    }

    fn grid(&mut self) {
        let (x, y) = (self.x.clone(), self.y.clone());
        for (v, _) in x.ticks().0 {
            self.line(vec![self.at(v, y.ends.0), self.at(v, y.ends.1)], PALE, 0.7);
        }
        for (v, _) in y.ticks().0 {
            self.line(vec![self.at(x.ends.0, v), self.at(x.ends.1, v)], PALE, 0.7);
        }
    }

    /// A text on the page.
    pub fn text(&mut self, at: (f32, f32), text: &str, anchor: Anchor) {
        let text = text.to_owned();
        self.page.shapes.push(Shape::Text { at, text, size: SMALL, anchor, upwards: false });
    }

    /// A curve in the colour and dashes of its number; values beyond the frame are cut off.
    pub fn curve(&mut self, number: usize, points: &[(f64, f64)]) {
        let dash = DASHES[number % DASHES.len()];
        let colour = PALETTE[number % PALETTE.len()];
        let inside = |p: &&(f64, f64)| (-1e-6..=1.0 + 1e-6).contains(&self.y.share(p.1));
        let points: Vec<(f32, f32)> = points.iter().filter(inside).map(|p| self.at(p.0, p.1)).collect();
        self.page.shapes.push(Shape::Line { points, colour, width: 1.8, dash });
    }

    /// A thin white line between two areas.
    pub fn border(&mut self, points: &[(f64, f64)]) {
        let points = points.iter().map(|p| self.at(p.0, p.1)).collect();
        self.line(points, WHITE, 0.9);
    }

    /// A dot in the colour of a curve.
    pub fn dot(&mut self, number: usize, x: f64, y: f64, full: bool, radius: f32) {
        let (at, colour) = (self.at(x, y), PALETTE[number % PALETTE.len()]);
        self.page.shapes.push(Shape::Dot { at, radius, colour, full });
    }

    /// A filled area through pairs of values.
    pub fn area(&mut self, points: &[(f64, f64)], colour: Colour) {
        let points = points.iter().map(|p| self.at(p.0, p.1)).collect();
        self.page.shapes.push(Shape::Area { points, colour });
    }

    /// The place of the next line of the legend, right of the frame.
    fn entry(&mut self, text: &str) -> (f32, f32) {
        self.legend.push(plain(text));
        (WIDTH - RIGHT + 14.0, TOP + 20.0 * self.legend.len() as f32)
    }

    /// A title over the legend.
    pub fn legend_title(&mut self, text: &str) {
        let (x, y) = self.entry(text);
        self.text((x, y), text, Anchor::Start);
    }

    /// A curve in the legend.
    pub fn legend_curve(&mut self, number: usize, text: &str) {
        let (x, y) = self.entry(text);
        let (colour, dash) = (PALETTE[number % PALETTE.len()], DASHES[number % DASHES.len()]);
        let points = vec![(x, y - 4.0), (x + 28.0, y - 4.0)];
        self.page.shapes.push(Shape::Line { points, colour, width: 1.8, dash });
        self.text((x + 34.0, y), text, Anchor::Start);
    }

    /// A dot in the legend.
    pub fn legend_dot(&mut self, number: usize, full: bool, text: &str) {
        let (x, y) = self.entry(text);
        let colour = PALETTE[number % PALETTE.len()];
        self.page.shapes.push(Shape::Dot { at: (x + 8.0, y - 4.0), radius: 4.0, colour, full });
        self.text((x + 20.0, y), text, Anchor::Start);
    }

    /// A filled area in the legend.
    pub fn legend_area(&mut self, colour: Colour, text: &str) {
        let (x, y) = self.entry(text);
        let points = vec![(x, y - 11.0), (x + 18.0, y - 11.0), (x + 18.0, y + 2.0), (x, y + 2.0)];
        let mut border = points.clone();
        border.push(points[0]);
        self.page.shapes.push(Shape::Area { points, colour });
        self.line(border, BLACK, 0.5);
        self.text((x + 24.0, y), text, Anchor::Start);
    }

    /// The finished page: frame, ticks, labels and title are drawn above everything else.
    #[must_use]
    pub fn finish(mut self) -> Page {
        let (x, y) = (self.x.clone(), self.y.clone());
        let corner = |c: &Chart, a: bool, b: bool| {
            c.at(if a { x.ends.1 } else { x.ends.0 }, if b { y.ends.1 } else { y.ends.0 })
        };
        let frame = [(false, false), (true, false), (true, true), (false, true), (false, false)];
        let frame = frame.map(|(a, b)| corner(&self, a, b)).to_vec();
        self.line(frame, BLACK, 1.0);
        let (main, fine) = x.ticks();
        for (value, label) in main {
            let (px, py) = self.at(value, y.ends.0);
            self.line(vec![(px, py), (px, py + 6.0)], BLACK, 1.0);
            self.text((px, py + 20.0), &label, Anchor::Middle);
        }
        for value in fine {
            let (px, py) = self.at(value, y.ends.0);
            self.line(vec![(px, py), (px, py + 3.0)], BLACK, 0.7);
        }
        let (main, fine) = y.ticks();
        for (value, label) in main {
            let (px, py) = self.at(x.ends.0, value);
            self.line(vec![(px - 6.0, py), (px, py)], BLACK, 1.0);
            self.text((px - 9.0, py + 4.0), &label, Anchor::End);
        }
        for value in fine {
            let (px, py) = self.at(x.ends.0, value);
            self.line(vec![(px - 3.0, py), (px, py)], BLACK, 0.7);
        }
        let label = |at, text: &str, upwards| Shape::Text {
            at,
            text: text.to_owned(),
            size: LARGE,
            anchor: Anchor::Middle,
            upwards,
        };
        let centre = ((LEFT + WIDTH - RIGHT) / 2.0, (TOP + HEIGHT - BOTTOM) / 2.0);
        self.page.shapes.push(label((centre.0, HEIGHT - 18.0), &x.label, false));
        self.page.shapes.push(label((24.0, centre.1), &y.label, true));
        self.page.description = format!("{} against {}. Legend: {}.", y.words(), x.words(), self.legend.join("; "));
        let title = self.page.title.clone();
        self.page.shapes.push(label((centre.0, 26.0), &title, false));
        self.page
    }
}
