//! A page as SVG; letters as outlines, each kept once, so that no font is needed to read it.

use super::letters::{Letters, Piece, plain};
use super::shape::{BLACK, Colour, Page, Shape, WHITE};
use crate::report::markup::escape;
use std::collections::BTreeMap;
use std::fmt::Write;

/// The text of the file.
#[must_use]
pub fn render(page: &Page) -> String {
    inline(page, "")
}

/// The same to stand in a document with other pictures: its identifiers begin with a prefix.
#[must_use]
pub fn inline(page: &Page, prefix: &str) -> String {
    let letters = Letters::new();
    let (mut used, mut body) = (BTreeMap::new(), String::new());
    for shape in &page.shapes {
        one(shape, &letters, prefix, &mut used, &mut body);
    }
    let (width, height) = (page.width, page.height);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" role=\"img\">\n\
         <title>{}</title>\n<desc>{}</desc>\n<defs>\n",
        escape(&plain(&page.title)),
        escape(&page.description)
    );
    for (id, glyph) in &used {
        let _ = writeln!(out, "<path id=\"{prefix}g{id}\" d=\"{}\"/>", outline(&letters.outline(*glyph)));
    }
    let _ =
        write!(out, "</defs>\n<rect width=\"{width}\" height=\"{height}\" fill=\"{}\"/>\n{body}</svg>\n", hex(WHITE));
    out
}

type Used = BTreeMap<u16, ttf_parser::GlyphId>;

fn one(shape: &Shape, letters: &Letters, prefix: &str, used: &mut Used, out: &mut String) {
    // Writing to a text cannot fail.
    let _ = match shape {
        Shape::Line { points, colour, width, dash } => {
            let dashes: Vec<String> = dash.iter().map(f32::to_string).collect();
            let dash =
                if dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{}\"", dashes.join(" ")) };
            writeln!(
                out,
                "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{dash}/>",
                list(points),
                hex(*colour)
            )
        }
        Shape::Area { points, colour } => {
            writeln!(out, "<polygon points=\"{}\" fill=\"{}\"/>", list(points), hex(*colour))
        }
        Shape::Dot { at: (x, y), radius, colour, full } => {
            let fill = hex(if *full { *colour } else { WHITE });
            writeln!(
                out,
                "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius}\" fill=\"{fill}\" stroke=\"{}\" stroke-width=\"1.5\"/>",
                hex(*colour)
            )
        }
        Shape::Text { at: (x, y), text, size, anchor, upwards } => {
            let turn = if *upwards { " rotate(-90)" } else { "" };
            let _ = writeln!(
                out,
                "<g transform=\"translate({x:.2} {y:.2}){turn}\" fill=\"{}\" aria-label=\"{}\">",
                hex(BLACK),
                escape(&plain(text))
            );
            for letter in letters.set(text, *size, *anchor) {
                used.insert(letter.glyph.0, letter.glyph);
                let (x, y, s) = (letter.x, letter.y, letter.scale);
                let _ = writeln!(
                    out,
                    "<use href=\"#{prefix}g{}\" transform=\"translate({x:.2} {y:.2}) scale({s:.5} -{s:.5})\"/>",
                    letter.glyph.0
                );
            }
            writeln!(out, "</g>")
        }
    };
}

fn list(points: &[(f32, f32)]) -> String {
    points.iter().map(|(x, y)| format!("{x:.2},{y:.2}")).collect::<Vec<_>>().join(" ")
}

fn hex(Colour(r, g, b): Colour) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn outline(pieces: &[Piece]) -> String {
    let text = |piece: &Piece| match piece {
        Piece::Move(x, y) => format!("M{x} {y}"),
        Piece::Line(x, y) => format!("L{x} {y}"),
        Piece::Quad(a, b, x, y) => format!("Q{a} {b} {x} {y}"),
        Piece::Cubic(a, b, c, d, x, y) => format!("C{a} {b} {c} {d} {x} {y}"),
        Piece::Close => "Z".to_owned(),
    };
    pieces.iter().map(text).collect()
}
