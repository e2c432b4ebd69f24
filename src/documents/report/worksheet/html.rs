//! Sheets as a page of HTML: a form to fill in on a screen, and paper when it is printed.
//!
//! Contract: one file without scripts that loads nothing; each sheet begins on a printed page of its own; every field has a
//! name for screen readers.

use super::sketch::{Sketch, Stroke};
use super::{Cell, Part, Sheet, Table, with_powers};
use crate::report::markup::escape;

const STYLE: &str = include_str!("sheet.css");

/// The page with all sheets.
#[must_use]
pub fn page(sheets: &[Sheet], letter: bool) -> String {
    let title = sheets.first().map_or("", |sheet| sheet.title.as_str());
    let paper = if letter { "letter" } else { "A4" };
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n\
         <style>\n@page {{ size: {paper}; margin: 18mm; }}\n{STYLE}</style>\n</head>\n<body>\n",
        escape(title)
    );
    for (place, sheet) in sheets.iter().enumerate() {
        out.push_str(&one(sheet, place));
    }
    out.push_str("</body>\n</html>\n");
    out
}

fn one(sheet: &Sheet, place: usize) -> String {
    let mut out = format!("<form class=\"sheet\" autocomplete=\"off\">\n<h1>{}</h1>\n", escape(&sheet.title));
    for (number, part) in sheet.parts.iter().enumerate() {
        let name = format!("s{place}-{number}");
        match part {
            Part::Names => {
                let field =
                    |text: &str, class: &str| format!("<label class=\"{class}\">{text} <input type=\"text\"></label>");
                let fields = [field("Name", "long"), field("Class", "short"), field("Date", "short")];
                out.push_str(&format!("<div class=\"names\">{}</div>\n", fields.concat()));
            }
            Part::Heading(text) => out.push_str(&format!("<h2>{}</h2>\n", escape(text))),
            Part::Text(text) => out.push_str(&format!("<p>{}</p>\n", formulas(text))),
            Part::Sketch(sketch) => out.push_str(&drawn(sketch)),
            Part::Choice { ask, options } => {
                out.push_str(&format!("<fieldset>\n<legend>{}</legend>\n", escape(ask)));
                for (text, right) in options {
                    let checked = if *right { " checked" } else { "" };
                    out.push_str(&format!(
                        "<label><input type=\"radio\" name=\"{name}\"{checked}> {}</label>\n",
                        escape(text)
                    ));
                }
                out.push_str("</fieldset>\n");
            }
            Part::Open { ask, answer, lines } => {
                out.push_str(&format!("<p class=\"ask\" id=\"{name}\">{}</p>\n", powers(ask)));
                out.push_str(&match answer {
                    Some(answer) => format!("<p class=\"answer\">{}</p>\n", powers(answer)),
                    None => format!("<textarea rows=\"{lines}\" aria-labelledby=\"{name}\"></textarea>\n"),
                });
            }
            Part::Table(found) => out.push_str(&table(found)),
        }
    }
    out.push_str(&format!("<p class=\"foot\">{}</p>\n</form>\n", escape(&sheet.foot)));
    out
}

/// The width of a sketch, in points.
const WIDTH: f32 = 487.0;

/// A sketch as SVG in the page.
fn drawn(sketch: &Sketch) -> String {
    let mut out = format!(
        "<svg class=\"sketch\" role=\"img\" aria-label=\"{}\" viewBox=\"-1 -1 {} {}\">\n",
        escape(&sketch.description()),
        WIDTH + 2.0,
        sketch.height() + 2.0
    );
    for stroke in sketch.strokes(WIDTH) {
        out.push_str(&match stroke {
            Stroke::Line(points) => {
                let points: Vec<String> = points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
                format!("<polyline points=\"{}\"/>\n", points.join(" "))
            }
            Stroke::Label((x, y), text, size) => {
                let base = y + 0.36 * size;
                format!("<text x=\"{x:.1}\" y=\"{base:.1}\" font-size=\"{size:.1}\">{}</text>\n", escape(&text))
            }
        });
    }
    out + "</svg>\n"
}

/// Text with the letters of its formulas in italics.
fn formulas(text: &str) -> String {
    let set = "<i>p</i> = <i>m</i> <i>v</i> is";
    powers(text).replace("p = m v is", set).replace("E = m v²/2 the", "<i>E</i> = ½ <i>m</i> <i>v</i>² the")
}

fn table(table: &Table) -> String {
    let mut out = String::from("<table>\n");
    if !table.title.is_empty() {
        out.push_str(&format!("<caption>{}</caption>\n", escape(&table.title)));
    }
    let heads: String = table.columns.iter().map(|c| format!("<th scope=\"col\">{}</th>", escape(c))).collect();
    out.push_str(&format!("<thead><tr><td></td>{heads}</tr></thead>\n"));
    for group in &table.groups {
        out.push_str("<tbody>\n");
        for row in group {
            out.push_str(&format!("<tr><th scope=\"row\">{}</th>", escape(&row.name)));
            for (cell, column) in row.cells.iter().zip(&table.columns) {
                let label = format!("{}, {}, {}", table.title, row.name, column);
                out.push_str(&match cell {
                    Cell::Number(text) => format!("<td>{}</td>", number(text)),
                    Cell::Blank => {
                        format!("<td class=\"blank\"><input type=\"text\" aria-label=\"{}\"></td>", escape(&label))
                    }
                    Cell::Nothing => "<td></td>".to_owned(),
                });
            }
            out.push_str("</tr>\n");
        }
        out.push_str("</tbody>\n");
    }
    out.push_str("</table>\n");
    out
}

/// A number with a true minus sign, and a power of ten raised.
fn number(text: &str) -> String {
    powers(text).replace('-', "−")
}

/// A text with its powers of ten raised.
fn powers(text: &str) -> String {
    with_powers(&escape(text), |digits, exponent| format!("{digits}·10<sup>{}</sup>", exponent.replace('-', "−")))
}
