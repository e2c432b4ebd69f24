//! Sheets as a page of HTML: a form to fill in on a screen, and paper when it is printed.
//!
//! Contract: one file that loads nothing; each sheet begins on a printed page of its own; every field has a name for screen
//! readers. The script of a sheet to be filled in marks what is typed and needs no network; without it the fields can still
//! be filled in. A key has no script.

use super::expected::salted;
use super::sketch::{Sketch, Stroke};
use super::{Cell, Expected, Part, Sheet, Table, with_powers};
use crate::report::markup::escape;

const STYLE: &str = include_str!("sheet.css");
const SCRIPT: &str = include_str!("marks.js");

/// The page with all sheets.
#[must_use]
pub fn page(sheets: &[Sheet], letter: bool) -> String {
    let title = sheets.first().map_or("", |sheet| sheet.title.as_str());
    let paper = if letter { "letter" } else { "A4" };
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n\
         <style>\n@page {{ size: {paper}; margin: 18mm; }}\n{STYLE}</style>\n</head>\n<body>\n<main>\n",
        escape(title)
    );
    for (place, sheet) in sheets.iter().enumerate() {
        out.push_str(&one(sheet, place));
    }
    out.push_str("</main>\n");
    if sheets.iter().any(is_marked) {
        out.push_str(&format!("<script>\n{SCRIPT}</script>\n"));
    }
    out.push_str("</body>\n</html>\n");
    out
}

/// What is right in the fields of a sheet, where something is known.
fn expected(sheet: &Sheet) -> impl Iterator<Item = Option<&Expected>> {
    sheet.parts.iter().flat_map(|part| match part {
        Part::Table(table) => {
            let cells = table.groups.iter().flatten().flat_map(|row| &row.cells);
            let blanks = cells.filter_map(|cell| match cell {
                Cell::Blank(expected) => Some(expected.as_ref()),
                _ => None,
            });
            blanks.collect::<Vec<_>>()
        }
        Part::Open { answer: None, numbers, .. } => numbers.iter().map(|number| number.expected.as_ref()).collect(),
        _ => Vec::new(),
    })
}

/// Whether a sheet has fields that are marked.
fn is_marked(sheet: &Sheet) -> bool {
    expected(sheet).any(|field| field.is_some())
}

/// A field for a number, and the place of its mark.
fn field(sheet: &Sheet, name: &str, label: Option<&str>, expected: Option<&Expected>) -> String {
    let label = label.map_or(String::new(), |label| format!(" aria-label=\"{}\"", escape(label)));
    let Some(expected) = expected else {
        return format!("<input type=\"text\" id=\"{name}\" name=\"{name}\"{label}>");
    };
    let answers = expected.digests(&salt(sheet, name)).join(" ");
    format!(
        "<input type=\"text\" id=\"{name}\" name=\"{name}\"{label} aria-describedby=\"{name}-mark\" data-answer=\"{answers}\">\
         <output id=\"{name}-mark\"></output>"
    )
}

/// The salt of the digests of a field.
fn salt(sheet: &Sheet, name: &str) -> String {
    format!("{} {name}", sheet.foot)
}

/// How the numbers of a sheet are marked.
fn instruction(sheet: &Sheet) -> String {
    let some = expected(sheet).any(|field| field.is_none());
    let open = if some { " Answers with an uncertainty are not marked." } else { "" };
    format!(
        "<p class=\"marks\" hidden>Each number is marked when you leave its field. Write 0.9, 0,9, 9/10, 90 % or 10^3, without a unit.{open}</p>\n"
    )
}

fn one(sheet: &Sheet, place: usize) -> String {
    let marked = is_marked(sheet);
    let data = if marked { format!(" data-salt=\"{}\"", escape(&sheet.foot)) } else { String::new() };
    let mut out = format!("<form class=\"sheet\" autocomplete=\"off\"{data}>\n<h1>{}</h1>\n", escape(&sheet.title));
    if marked {
        out.push_str(&instruction(sheet));
    }
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
            Part::Choice { ask, options, right } => {
                let right = right.filter(|_| marked).map_or(String::new(), |right| {
                    let answer = salted(&salt(sheet, &name), &format!("tick {right}"));
                    format!(" data-answer=\"{answer}\"")
                });
                let told = if right.is_empty() { "" } else { "<output></output>\n" };
                out.push_str(&format!("<fieldset name=\"{name}\"{right}>\n<legend>{}</legend>\n", escape(ask)));
                for (text, right) in options {
                    let checked = if *right { " checked" } else { "" };
                    out.push_str(&format!(
                        "<label><input type=\"radio\" name=\"{name}\"{checked}> {}</label>\n",
                        escape(text)
                    ));
                }
                out.push_str(&format!("{told}</fieldset>\n"));
            }
            Part::Open { ask, answer, lines, numbers } => {
                out.push_str(&format!("<p class=\"ask\" id=\"{name}\">{}</p>\n", powers(ask)));
                out.push_str(&match answer {
                    Some(answer) => format!("<p class=\"answer\">{}</p>\n", powers(answer)),
                    None => {
                        let one = |(at, number): (usize, &super::Number)| {
                            let (label, name) = (escape(&number.label), format!("{name}-{at}"));
                            let field = field(sheet, &name, None, number.expected.as_ref());
                            format!("<div class=\"number\"><label for=\"{name}\">{label}</label>{field}</div>\n")
                        };
                        let fields: String = numbers.iter().enumerate().map(one).collect();
                        let fields = if fields.is_empty() {
                            fields
                        } else {
                            format!("<div class=\"numbers\">\n{fields}</div>\n")
                        };
                        format!("{fields}<textarea rows=\"{lines}\" aria-labelledby=\"{name}\"></textarea>\n")
                    }
                });
            }
            Part::Table(found) => out.push_str(&table(sheet, &name, found)),
        }
    }
    if marked {
        out.push_str("<p class=\"marks score\" role=\"status\" hidden></p>\n");
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

fn table(sheet: &Sheet, name: &str, table: &Table) -> String {
    let mut out = String::from("<table>\n");
    if !table.title.is_empty() {
        out.push_str(&format!("<caption>{}</caption>\n", escape(&table.title)));
    }
    let heads: String = table.columns.iter().map(|c| format!("<th scope=\"col\">{}</th>", escape(c))).collect();
    out.push_str(&format!("<thead><tr><td></td>{heads}</tr></thead>\n"));
    let mut line = 0;
    for group in &table.groups {
        out.push_str("<tbody>\n");
        for row in group {
            line += 1;
            out.push_str(&format!("<tr><th scope=\"row\">{}</th>", escape(&row.name)));
            for (place, (cell, column)) in row.cells.iter().zip(&table.columns).enumerate() {
                let label = format!("{}, {}, {}", table.title, row.name, column);
                out.push_str(&match cell {
                    Cell::Number(text) => format!("<td>{}</td>", number(text)),
                    Cell::Blank(expected) => {
                        let name = format!("{name}-{line}-{place}");
                        format!("<td class=\"blank\">{}</td>", field(sheet, &name, Some(&label), expected.as_ref()))
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
