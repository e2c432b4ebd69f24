//! Text as outlines of the font DejaVu Sans.

use super::shape::{Anchor, Page, Shape};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// DejaVu Sans without what outlines do not need; `build.rs` makes it.
static OUTLINES: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/outlines.ttf"));

/// The font.
pub(crate) struct Letters {
    face: Option<Face<'static>>,
}

/// A letter in its place: the outline times `scale`, moved to `x`, `y` (downwards) from the text's point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Letter {
    /// Which.
    pub glyph: GlyphId,
    /// The character that it shows.
    pub character: char,
    /// To the right.
    pub x: f32,
    /// Down.
    pub y: f32,
    /// Points for each unit of the font.
    pub scale: f32,
}

/// A piece of an outline, in units of the font, `y` upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Piece {
    /// Go there.
    Move(f32, f32),
    /// A straight line.
    Line(f32, f32),
    /// A quadratic curve: the control point, the end.
    Quad(f32, f32, f32, f32),
    /// A cubic curve: two control points, the end.
    Cubic(f32, f32, f32, f32, f32, f32),
    /// Back to the beginning.
    Close,
}

impl Letters {
    /// The embedded font.
    #[must_use]
    pub(crate) fn new() -> Letters {
        Letters { face: Face::parse(OUTLINES, 0).ok() }
    }

    /// The letters of a text with their places.
    #[must_use]
    pub(crate) fn set(&self, text: &str, size: f32, anchor: Anchor) -> Vec<Letter> {
        let (mut out, width) = self.row(text, size);
        let back = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => width / 2.0,
            Anchor::End => width,
        };
        out.iter_mut().for_each(|letter| letter.x -= back);
        out
    }

    /// How wide a text is.
    #[must_use]
    pub(crate) fn width(&self, text: &str, size: f32) -> f32 {
        self.row(text, size).1
    }

    /// A text in lines of at most so many points; words that are longer are broken.
    #[must_use]
    pub(crate) fn lines(&self, text: &str, size: f32, room: f32) -> Vec<String> {
        let mut out = vec![String::new()];
        for word in text.split_whitespace() {
            let mut word = word.to_owned();
            loop {
                let last = out.last().map_or("", String::as_str);
                let joined = if last.is_empty() { word.clone() } else { format!("{last} {word}") };
                if self.width(&joined, size) <= room {
                    out.pop();
                    out.push(joined);
                    break;
                }
                if !last.is_empty() {
                    out.push(String::new());
                    continue;
                }
                let fits = |(end, _): &(usize, char)| *end == 0 || self.width(&word[..*end], size) <= room;
                let end = word.char_indices().skip(1).take_while(fits).last().map_or(word.len(), |(end, _)| end);
                let rest = word.split_off(end);
                out.pop();
                out.extend([std::mem::replace(&mut word, rest), String::new()]);
                if word.is_empty() {
                    break;
                }
            }
        }
        out
    }

    /// Units of the font for each size of 1.
    #[must_use]
    pub(crate) fn units(&self) -> f32 {
        self.face.as_ref().map_or(1.0, |face| f32::from(face.units_per_em()))
    }

    /// How far a letter takes the pen, in units of the font.
    #[must_use]
    pub(crate) fn advance(&self, glyph: GlyphId) -> u16 {
        self.face.as_ref().and_then(|face| face.glyph_hor_advance(glyph)).unwrap_or(0)
    }

    /// The letters of a text that begins at 0, and where it ends. A character that the font lacks is its empty box.
    fn row(&self, text: &str, size: f32) -> (Vec<Letter>, f32) {
        let Some(face) = &self.face else { return (Vec::new(), 0.0) };
        let unit = size / f32::from(face.units_per_em());
        let mut out = Vec::new();
        let (mut x, mut level) = (0.0, 0i8);
        let mut rest = text.chars().peekable();
        while let Some(c) = rest.next() {
            match (c, rest.peek()) {
                ('_' | '^', Some('{')) => {
                    rest.next();
                    level = if c == '_' { -1 } else { 1 };
                }
                ('}', _) if level != 0 => level = 0,
                (c, _) => {
                    let glyph = face.glyph_index(c).unwrap_or(GlyphId(0));
                    let (scale, y) = match level {
                        -1 => (unit * 0.7, size * 0.2),
                        1 => (unit * 0.7, size * -0.36),
                        _ => (unit, 0.0),
                    };
                    out.push(Letter { glyph, character: c, x, y, scale });
                    x += f32::from(face.glyph_hor_advance(glyph).unwrap_or(0)) * scale;
                }
            }
        }
        (out, x)
    }

    /// The outline of a letter.
    #[must_use]
    pub(crate) fn outline(&self, glyph: GlyphId) -> Vec<Piece> {
        let mut pen = Pen(Vec::new());
        if let Some(face) = &self.face {
            face.outline_glyph(glyph, &mut pen);
        }
        pen.0
    }
}

impl Default for Letters {
    fn default() -> Letters {
        Letters::new()
    }
}

/// The characters on some pages that the font lacks, each once: an empty box is drawn for each.
#[must_use]
pub fn boxes(pages: &[Page]) -> Vec<char> {
    let letters = Letters::new();
    let mut out = Vec::new();
    for shape in pages.iter().flat_map(|page| &page.shapes) {
        let Shape::Text { text, .. } = shape else { continue };
        for letter in letters.row(text, 1.0).0 {
            if letter.glyph == GlyphId(0) && !out.contains(&letter.character) {
                out.push(letter.character);
            }
        }
    }
    out
}

/// A text without its marks for lowering; what is raised stands after `^`.
#[must_use]
pub fn plain(text: &str) -> String {
    text.replace("_{", "").replace("^{", "^").replace('}', "")
}

struct Pen(Vec<Piece>);

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.push(Piece::Move(x, y));
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.0.push(Piece::Line(x, y));
    }
    fn quad_to(&mut self, a: f32, b: f32, x: f32, y: f32) {
        self.0.push(Piece::Quad(a, b, x, y));
    }
    fn curve_to(&mut self, a: f32, b: f32, c: f32, d: f32, x: f32, y: f32) {
        self.0.push(Piece::Cubic(a, b, c, d, x, y));
    }
    fn close(&mut self) {
        self.0.push(Piece::Close);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_letter_of_the_smaller_font_has_another_outline_or_width() {
        let full = Face::parse(dejavu::sans::regular(), 0).unwrap();
        let letters = Letters::new();
        let own = letters.face.as_ref().unwrap();
        assert!(OUTLINES.len() < 600_000, "{} bytes", OUTLINES.len());
        assert_eq!((own.units_per_em(), own.number_of_glyphs()), (full.units_per_em(), full.number_of_glyphs()));
        for c in '\0'..'\u{3000}' {
            assert_eq!(own.glyph_index(c), full.glyph_index(c), "{c:?}");
        }
        for glyph in (0..full.number_of_glyphs()).map(GlyphId) {
            let mut pen = Pen(Vec::new());
            full.outline_glyph(glyph, &mut pen);
            assert_eq!(letters.outline(glyph), pen.0, "{glyph:?}");
            assert_eq!(own.glyph_hor_advance(glyph), full.glyph_hor_advance(glyph), "{glyph:?}");
        }
    }
}
