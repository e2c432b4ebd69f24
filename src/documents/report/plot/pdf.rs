//! Pages as PDF, drawn from the same shapes and letters as SVG and PNG.
//!
//! Contract: a file that every reader opens, without a date in it: the same pages are the same bytes. Letters are the
//! outlines of the embedded font, as fonts of type 3 with their characters, so that text is vector and can be searched.

use super::letters::{Letter, Letters, Piece};
use super::shape::{BLACK, Colour, Page, Shape, WHITE};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Letters of one font: codes are bytes.
const CODES: usize = 256;
/// The distance of a circle's control points from its ends, for a radius of 1.
const ROUND: f32 = 0.552_284_8;

/// The bytes of the file.
#[must_use]
pub fn render(pages: &[Page]) -> Vec<u8> {
    let letters = Letters::new();
    let mut fonts = Fonts::default();
    let contents: Vec<String> = pages.iter().map(|page| drawn(page, &letters, &mut fonts)).collect();
    let mut file = File::default();
    let (catalog, tree, info, resources) = (file.reserve(), file.reserve(), file.reserve(), file.reserve());
    let mut kids = Vec::new();
    for (page, content) in pages.iter().zip(&contents) {
        let stream = file.reserve();
        file.stream(stream, content);
        let kid = file.reserve();
        file.set(
            kid,
            format!(
                "<< /Type /Page /Parent {tree} 0 R /MediaBox [0 0 {} {}] /Resources {resources} 0 R /Contents {stream} 0 R >>",
                page.width, page.height
            ),
        );
        kids.push(format!("{kid} 0 R"));
    }
    let list: Vec<String> =
        fonts.write(&letters, &mut file).iter().enumerate().map(|(i, id)| format!("/F{i} {id} 0 R")).collect();
    file.set(resources, format!("<< /Font << {} >> >>", list.join(" ")));
    file.set(tree, format!("<< /Type /Pages /Count {} /Kids [{}] >>", kids.len(), kids.join(" ")));
    file.set(catalog, format!("<< /Type /Catalog /Pages {tree} 0 R /Lang (en) >>"));
    let title = pages.first().map_or("", |page| page.title.as_str());
    file.set(info, format!("<< /Title <FEFF{}> /Creator (carom {}) >>", utf16(title), env!("CARGO_PKG_VERSION")));
    file.finish(catalog, info)
}

/// The objects of a file, numbered from 1.
#[derive(Default)]
struct File {
    objects: Vec<String>,
}

impl File {
    fn reserve(&mut self) -> usize {
        self.objects.push(String::new());
        self.objects.len()
    }

    fn set(&mut self, number: usize, body: String) {
        if let Some(place) = self.objects.get_mut(number - 1) {
            *place = body;
        }
    }

    fn stream(&mut self, number: usize, content: &str) {
        self.set(number, format!("<< /Length {} >>\nstream\n{content}\nendstream", content.len()));
    }

    fn finish(self, catalog: usize, info: usize) -> Vec<u8> {
        let mut out = String::from("%PDF-1.4\n");
        let mut places = Vec::new();
        for (place, body) in self.objects.iter().enumerate() {
            places.push(out.len());
            let _ = writeln!(out, "{} 0 obj\n{body}\nendobj", place + 1);
        }
        let (start, count) = (out.len(), places.len() + 1);
        let _ = write!(out, "xref\n0 {count}\n0000000000 65535 f \n");
        for place in places {
            let _ = writeln!(out, "{place:010} 00000 n ");
        }
        let _ = write!(
            out,
            "trailer\n<< /Size {count} /Root {catalog} 0 R /Info {info} 0 R >>\nstartxref\n{start}\n%%EOF\n"
        );
        out.into_bytes()
    }
}

/// The letters that are used, each with its code in the order of their first use.
#[derive(Default)]
struct Fonts {
    codes: BTreeMap<(u16, char), usize>,
    order: Vec<Letter>,
}

impl Fonts {
    /// The number of the font, and the code in it.
    fn code(&mut self, letter: Letter) -> (usize, usize) {
        let next = self.order.len();
        let code = *self.codes.entry((letter.glyph.0, letter.character)).or_insert(next);
        if code == next {
            self.order.push(letter);
        }
        (code / CODES, code % CODES)
    }

    fn write(&self, letters: &Letters, file: &mut File) -> Vec<usize> {
        let unit = 1.0 / letters.units();
        let mut fonts = Vec::new();
        for chunk in self.order.chunks(CODES) {
            let (mut shapes, mut names, mut widths, mut unicode) =
                (String::new(), String::new(), String::new(), String::new());
            for (code, letter) in chunk.iter().enumerate() {
                let width = letters.advance(letter.glyph);
                let shape = file.reserve();
                file.stream(shape, &format!("{width} 0 d0\n{}", outline(&letters.outline(letter.glyph))));
                let _ = write!(shapes, "/g{code} {shape} 0 R ");
                let _ = write!(names, "/g{code} ");
                let _ = write!(widths, "{width} ");
                let _ = writeln!(unicode, "<{code:02X}> <{}>", utf16(&letter.character.to_string()));
            }
            let map = file.reserve();
            // A section has at most a hundred lines.
            let sections: String = unicode
                .lines()
                .collect::<Vec<_>>()
                .chunks(100)
                .map(|lines| format!("{} beginbfchar\n{}\nendbfchar\n", lines.len(), lines.join("\n")))
                .collect();
            file.stream(
                map,
                &format!(
                    "/CIDInit /ProcSet findresource begin\n12 dict begin\nbegincmap\n/CMapName /Carom def\n/CMapType 2 def\n\
                     1 begincodespacerange\n<00> <FF>\nendcodespacerange\n{sections}endcmap\n\
                     CMapName currentdict /CMap defineresource pop\nend\nend"
                ),
            );
            let font = file.reserve();
            file.set(
                font,
                format!(
                    "<< /Type /Font /Subtype /Type3 /FontBBox [0 0 0 0] /FontMatrix [{unit:.10} 0 0 {unit:.10} 0 0] \
                     /FirstChar 0 /LastChar {} /Widths [{widths}] /Encoding << /Type /Encoding /Differences [0 {names}] >> \
                     /CharProcs << {shapes}>> /Resources << >> /ToUnicode {map} 0 R >>",
                    chunk.len() - 1
                ),
            );
            fonts.push(font);
        }
        fonts
    }
}

fn utf16(text: &str) -> String {
    text.encode_utf16().map(|unit| format!("{unit:04X}")).collect()
}

fn colour(Colour(r, g, b): Colour) -> String {
    let share = |x: u8| format!("{:.3}", f32::from(x) / 255.0);
    format!("{} {} {}", share(r), share(g), share(b))
}

/// The drawing of a page, with `y` downwards.
fn drawn(page: &Page, letters: &Letters, fonts: &mut Fonts) -> String {
    let mut out = format!("1 0 0 -1 0 {} cm 1 j\n", page.height);
    for shape in &page.shapes {
        one(shape, letters, fonts, &mut out);
    }
    out
}

fn one(shape: &Shape, letters: &Letters, fonts: &mut Fonts, out: &mut String) {
    // Writing to a text cannot fail.
    let _ = match shape {
        Shape::Line { points, colour: ink, width, dash } => {
            let dash: Vec<String> = dash.iter().map(f32::to_string).collect();
            writeln!(out, "{} RG {width} w [{}] 0 d {}S", colour(*ink), dash.join(" "), path(points))
        }
        Shape::Area { points, colour: ink } => writeln!(out, "{} rg {}f", colour(*ink), path(points)),
        Shape::Dot { at: (x, y), radius: r, colour: ink, full } => {
            let fill = if *full { *ink } else { WHITE };
            let k = ROUND * r;
            writeln!(
                out,
                "{} rg {} RG 1.5 w [] 0 d {:.2} {y:.2} m {:.2} {:.2} {:.2} {:.2} {x:.2} {:.2} c {:.2} {:.2} {:.2} {:.2} {:.2} {y:.2} c \
                 {:.2} {:.2} {:.2} {:.2} {x:.2} {:.2} c {:.2} {:.2} {:.2} {:.2} {:.2} {y:.2} c b",
                colour(fill),
                colour(*ink),
                x + r,
                x + r,
                y + k,
                x + k,
                y + r,
                y + r,
                x - k,
                y + r,
                x - r,
                y + k,
                x - r,
                x - r,
                y - k,
                x - k,
                y - r,
                y - r,
                x + k,
                y - r,
                x + r,
                y - k,
                x + r,
            )
        }
        Shape::Text { at, text, size, anchor, upwards } => {
            let _ = writeln!(out, "BT {} rg", colour(BLACK));
            let units = letters.units();
            for letter in letters.set(text, *size, *anchor) {
                let (font, code) = fonts.code(letter);
                let (x, y) = (letter.x, letter.y);
                let matrix = if *upwards {
                    format!("0 -1 -1 0 {:.3} {:.3}", at.0 + y, at.1 - x)
                } else {
                    format!("1 0 0 -1 {:.3} {:.3}", at.0 + x, at.1 + y)
                };
                let _ = writeln!(out, "/F{font} {:.4} Tf {matrix} Tm <{code:02X}> Tj", letter.scale * units);
            }
            writeln!(out, "ET")
        }
    };
}

fn path(points: &[(f32, f32)]) -> String {
    let mut out = String::new();
    for (place, (x, y)) in points.iter().enumerate() {
        let _ = write!(out, "{x:.2} {y:.2} {} ", if place == 0 { "m" } else { "l" });
    }
    out
}

/// A letter's outline; quadratic curves as cubic ones.
fn outline(pieces: &[Piece]) -> String {
    let (mut out, mut at) = (String::new(), (0.0_f32, 0.0_f32));
    for piece in pieces {
        let _ = match *piece {
            Piece::Move(x, y) => {
                at = (x, y);
                writeln!(out, "{x} {y} m")
            }
            Piece::Line(x, y) => {
                at = (x, y);
                writeln!(out, "{x} {y} l")
            }
            Piece::Quad(a, b, x, y) => {
                let third = |from: f32, to: f32| from + (to - from) * 2.0 / 3.0;
                let (p, q) = ((third(at.0, a), third(at.1, b)), (third(x, a), third(y, b)));
                at = (x, y);
                writeln!(out, "{:.1} {:.1} {:.1} {:.1} {x} {y} c", p.0, p.1, q.0, q.1)
            }
            Piece::Cubic(a, b, c, d, x, y) => {
                at = (x, y);
                writeln!(out, "{a} {b} {c} {d} {x} {y} c")
            }
            Piece::Close => writeln!(out, "h"),
        };
    }
    out + "f"
}
