//! A page as PNG, drawn from the same shapes and letters as the SVG.

use super::letters::{Letters, Piece};
use super::shape::{BLACK, Colour, Page, Shape, WHITE};
use std::fmt;
use tiny_skia::{FillRule, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};

/// The largest picture, in pixels of its longer side.
pub(crate) const MAX_PIXELS: u32 = 10_000;

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq)]
pub enum PngError {
    /// Less than one pixel.
    Small {
        /// The scale that was asked for.
        scale: f32,
    },
    /// More pixels than allowed.
    Size {
        /// The longer side that was asked for.
        needed: f32,
    },
    /// The encoder failed.
    Encoding(String),
}

impl fmt::Display for PngError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Small { scale } => write!(f, "{scale} is not a usable scale; write for instance 2"),
            Self::Size { needed } => {
                write!(f, "limit reached: pixels of a side: {MAX_PIXELS} allowed, {needed} asked for")
            }
            Self::Encoding(text) => write!(f, "the picture cannot be encoded: {text}"),
        }
    }
}

impl std::error::Error for PngError {}

/// The bytes of the file, `scale` pixels for each point.
///
/// # Errors
/// [`PngError`].
pub fn render(page: &Page, scale: f32) -> Result<Vec<u8>, PngError> {
    let needed = page.width.max(page.height) * scale;
    let too_large = || PngError::Size { needed };
    // What is no number is no scale either.
    if !(1.0..).contains(&needed) {
        return Err(PngError::Small { scale });
    }
    if needed > MAX_PIXELS as f32 {
        return Err(too_large());
    }
    let (width, height) = ((page.width * scale).ceil() as u32, (page.height * scale).ceil() as u32);
    let mut pixmap = Pixmap::new(width.max(1), height.max(1)).ok_or_else(too_large)?;
    pixmap.fill(tiny_skia::Color::WHITE);
    let letters = Letters::new();
    for shape in &page.shapes {
        one(shape, &letters, Transform::from_scale(scale, scale), &mut pixmap);
    }
    pixmap.encode_png().map_err(|e| PngError::Encoding(e.to_string()))
}

fn paint(Colour(r, g, b): Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, 255);
    paint.anti_alias = true;
    paint
}

fn path(points: &[(f32, f32)], closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    let (first, rest) = points.split_first()?;
    builder.move_to(first.0, first.1);
    rest.iter().for_each(|p| builder.line_to(p.0, p.1));
    if closed {
        builder.close();
    }
    builder.finish()
}

fn fill(pixmap: &mut Pixmap, path: &Path, colour: Colour, transform: Transform) {
    pixmap.fill_path(path, &paint(colour), FillRule::Winding, transform, None);
}

fn one(shape: &Shape, letters: &Letters, transform: Transform, pixmap: &mut Pixmap) {
    match shape {
        Shape::Line { points, colour, width, dash } => {
            let stroke = Stroke {
                width: *width,
                line_join: LineJoin::Round,
                dash: StrokeDash::new(dash.to_vec(), 0.0),
                ..Stroke::default()
            };
            if let Some(path) = path(points, false) {
                pixmap.stroke_path(&path, &paint(*colour), &stroke, transform, None);
            }
        }
        Shape::Area { points, colour } => {
            if let Some(path) = path(points, true) {
                fill(pixmap, &path, *colour, transform);
            }
        }
        Shape::Dot { at, radius, colour, full } => {
            if let Some(disc) = PathBuilder::from_circle(at.0, at.1, *radius) {
                fill(pixmap, &disc, if *full { *colour } else { WHITE }, transform);
                let stroke = Stroke { width: 1.5, ..Stroke::default() };
                pixmap.stroke_path(&disc, &paint(*colour), &stroke, transform, None);
            }
        }
        Shape::Text { at, text, size, anchor, upwards } => {
            let turned = transform.pre_translate(at.0, at.1).pre_rotate(if *upwards { -90.0 } else { 0.0 });
            for letter in letters.set(text, *size, *anchor) {
                let place = turned.pre_translate(letter.x, letter.y).pre_scale(letter.scale, -letter.scale);
                if let Some(path) = outline(&letters.outline(letter.glyph)) {
                    fill(pixmap, &path, BLACK, place);
                }
            }
        }
    }
}

fn outline(pieces: &[Piece]) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for piece in pieces {
        match *piece {
            Piece::Move(x, y) => builder.move_to(x, y),
            Piece::Line(x, y) => builder.line_to(x, y),
            Piece::Quad(a, b, x, y) => builder.quad_to(a, b, x, y),
            Piece::Cubic(a, b, c, d, x, y) => builder.cubic_to(a, b, c, d, x, y),
            Piece::Close => builder.close(),
        }
    }
    builder.finish()
}
