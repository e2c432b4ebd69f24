//! A frame with two scales, their ticks and labels, and a legend.
//!
//! Contract: every text lies on the page, no two texts overlap, each axis has two numbers at least, and what is drawn lies
//! in the frame; what cannot be drawn so is [`Unclear`]. Text is measured before the page is laid out: the page is
//! wider for a long legend, and long titles and notes take several lines.

mod clip;
mod drawing;

use super::letters::plain;
use super::scale::Scale;
use super::shape::{Colour, Page};
use super::unclear::Unclear;
use drawing::Drawing;

/// What stands before a line of the legend.
enum Key {
    Nothing,
    Curve(usize),
    Dot(usize, bool),
    Area(Colour),
    Own,
}

impl Key {
    fn width(&self) -> f32 {
        match self {
            Key::Nothing => 0.0,
            Key::Curve(_) => 34.0,
            Key::Dot(..) | Key::Own => 20.0,
            Key::Area(_) => 24.0,
        }
    }
}

/// What is drawn in the frame, by values.
enum Mark {
    Curve(usize, Vec<(f64, f64)>),
    Border(Vec<(f64, f64)>),
    Area(Vec<(f64, f64)>, Colour),
    Dot { number: usize, at: (f64, f64), full: bool, radius: f32 },
    Bar { number: usize, x: f64, ends: (f64, f64) },
    Own { x: (f64, f64), y: (f64, f64) },
}

/// A picture in the making.
pub struct Chart {
    title: String,
    x: Scale,
    y: Scale,
    grid: bool,
    marks: Vec<Mark>,
    legend: Vec<(Key, String)>,
    note: Option<String>,
    /// Whether limits were given, beyond which marks are cut off.
    cut: bool,
}

impl Chart {
    /// A frame with its scales; `grid` draws fine lines at the ticks.
    #[must_use]
    pub fn new(title: &str, x: Scale, y: Scale, grid: bool) -> Chart {
        Chart { title: title.to_owned(), x, y, grid, marks: Vec::new(), legend: Vec::new(), note: None, cut: false }
    }

    /// A curve in the colour and dashes of its number.
    pub fn curve(&mut self, number: usize, points: &[(f64, f64)]) {
        self.marks.push(Mark::Curve(number, points.to_vec()));
    }

    /// A thin white line between two areas.
    pub(crate) fn border(&mut self, points: &[(f64, f64)]) {
        self.marks.push(Mark::Border(points.to_vec()));
    }

    /// A dot in the colour of a curve.
    pub fn dot(&mut self, number: usize, x: f64, y: f64, full: bool, radius: f32) {
        self.marks.push(Mark::Dot { number, at: (x, y), full, radius });
    }

    /// An upright bar with its two ends, in the colour of a curve.
    pub(crate) fn bar(&mut self, number: usize, x: f64, ends: (f64, f64)) {
        self.marks.push(Mark::Bar { number, x, ends });
    }

    /// A filled area through pairs of values.
    pub(crate) fn area(&mut self, points: &[(f64, f64)], colour: Colour) {
        self.marks.push(Mark::Area(points.to_vec(), colour));
    }

    /// Its title.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// A title in place of its own.
    pub fn rename(&mut self, title: &str) {
        title.clone_into(&mut self.title);
    }

    /// The horizontal axis has these ends; what lies beyond them is cut off.
    ///
    /// # Errors
    /// [`Unclear::Limits`] where there is no such axis.
    pub(crate) fn cut_across(&mut self, ends: (f64, f64)) -> Result<(), Unclear> {
        self.cut = true;
        limited(&mut self.x, ends)
    }

    /// The vertical axis has these ends; what lies beyond them is cut off.
    ///
    /// # Errors
    /// [`Unclear::Limits`] where there is no such axis.
    pub(crate) fn cut_upright(&mut self, ends: (f64, f64)) -> Result<(), Unclear> {
        self.cut = true;
        limited(&mut self.y, ends)
    }

    /// A reader's own measurement, with its uncertainties as bars.
    ///
    /// # Errors
    /// [`Unclear::Beyond`] where it lies outside of the picture.
    pub fn measured(&mut self, x: (f64, f64), y: (f64, f64)) -> Result<(), Unclear> {
        let inside =
            |scale: &Scale, ends: (f64, f64)| [ends.0, ends.1].iter().all(|v| (0.0..=1.0).contains(&scale.share(*v)));
        if !inside(&self.x, x) || !inside(&self.y, y) {
            return Err(Unclear::Beyond);
        }
        self.marks.push(Mark::Own { x, y });
        Ok(())
    }

    /// A reader's own points in the legend.
    pub fn legend_own(&mut self, text: &str) {
        self.legend.push((Key::Own, text.to_owned()));
    }

    /// A line under the picture.
    pub fn note(&mut self, text: &str) {
        self.note = Some(text.to_owned());
    }

    /// A title over the legend.
    pub fn legend_title(&mut self, text: &str) {
        self.legend.push((Key::Nothing, text.to_owned()));
    }

    /// A curve in the legend.
    pub(crate) fn legend_curve(&mut self, number: usize, text: &str) {
        self.legend.push((Key::Curve(number), text.to_owned()));
    }

    /// What the legend says of a curve.
    #[must_use]
    pub fn label(&self, number: usize) -> Option<&str> {
        self.legend.iter().find(|(key, _)| matches!(key, Key::Curve(n) if *n == number)).map(|(_, text)| text.as_str())
    }

    /// A dot in the legend.
    pub fn legend_dot(&mut self, number: usize, full: bool, text: &str) {
        self.legend.push((Key::Dot(number, full), text.to_owned()));
    }

    /// A filled area in the legend.
    pub(crate) fn legend_area(&mut self, colour: Colour, text: &str) {
        self.legend.push((Key::Area(colour), text.to_owned()));
    }

    /// The finished page: frame, ticks, labels and title are drawn above everything else.
    ///
    /// # Errors
    /// [`Unclear`]: a value that has no place in the frame, an axis without two numbers.
    pub fn finish(self) -> Result<Page, Unclear> {
        let mut drawing = Drawing::laid_out(&self)?;
        if self.grid {
            drawing.grid();
        }
        for mark in &self.marks {
            drawing.mark(mark)?;
        }
        for (place, (key, text)) in self.legend.iter().enumerate() {
            drawing.entry(place, key, text);
        }
        drawing.frame();
        drawing.words(&self);
        let legend: Vec<String> = self.legend.iter().map(|(_, text)| plain(text)).collect();
        Ok(Page {
            width: drawing.width,
            height: drawing.height,
            title: self.title.clone(),
            description: format!("{} against {}. Legend: {}.", self.y.words(), self.x.words(), legend.join("; ")),
            shapes: drawing.shapes,
        })
    }
}

/// Gives a scale its ends.
fn limited(scale: &mut Scale, ends: (f64, f64)) -> Result<(), Unclear> {
    let finite = [ends.0, ends.1].iter().all(|v| v.is_finite() && v.abs() <= 1e300);
    if !finite || ends.0 >= ends.1 || (scale.logarithmic && ends.0 <= 0.0) {
        return Err(Unclear::Limits);
    }
    scale.ends = ends;
    Ok(())
}
