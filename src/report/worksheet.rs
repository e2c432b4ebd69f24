//! Worksheets as text, Markdown and LaTeX: blank for the pupils, filled in for the teacher.
//!
//! A blank sheet gives the masses, the coefficients of restitution and the velocities before the first
//! collision of each body; everything else is to be found.

use super::{markdown, padded};
use crate::chain::recollision::WARNING;
use crate::number::NumberError;
use crate::number::decimal::{Decimal, Digits, Rounding};
use crate::number::real::Real;
use crate::table::grid::decimal_or_fraction;
use crate::table::worksheet::{Change, Collision, Worksheet};

/// The forms of a worksheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Form {
    /// Aligned columns.
    Text,
    /// Tables of Markdown.
    Markdown,
    /// Tables for booktabs.
    Latex,
}

/// How entries are written.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// The form.
    pub form: Form,
    /// The digits of decimals.
    pub digits: Digits,
    /// Fractions `p/q` where the value is rational and its fraction short.
    pub exact: bool,
}

/// The longest fraction that stands in a cell, in characters.
const MAX_FRACTION: usize = 15;

const HEADINGS: [&str; 11] =
    ["body", "mass", "v before", "v after", "change", "p before", "p after", "change", "E before", "E after", "change"];

/// A sheet; `filled` is the answer key.
///
/// # Errors
/// A limit on digits.
pub fn sheet(worksheet: &Worksheet, title: &str, style: Style, filled: bool) -> Result<String, NumberError> {
    let mut out = heading(&format!("{title}: {}", if filled { "answer key" } else { "worksheet" }), style.form, 1);
    let about = "p = m v is the momentum, E = m v²/2 the kinetic energy; change is after minus before. ";
    let rule = match (filled, style.digits) {
        (true, Digits::Significant(digits)) => {
            format!("Decimals are rounded to nearest, to {digits} significant digits.")
        }
        (true, Digits::Places(places)) => format!("Decimals are rounded to nearest, to {places} places."),
        (false, _) => "Fill in the empty cells.".to_owned(),
    };
    out.push_str(&paragraph(&format!("{about}{rule}"), style.form));
    for (place, collision) in worksheet.collisions.iter().enumerate() {
        let [a, b] = &collision.bodies;
        let title = format!(
            "Collision {}: body {} strikes body {}, e = {}",
            place + 1,
            a.number,
            b.number,
            decimal_or_fraction(&collision.e)
        );
        out.push_str(&heading(&title, style.form, 2));
        out.push_str(&table(&rows(collision, place == 0, style, filled)?, style.form));
    }
    if filled && worksheet.again {
        out.push_str(&paragraph(&format!("Note: {WARNING}."), style.form));
    }
    Ok(out)
}

/// The cells of a collision: two bodies and their total.
fn rows(collision: &Collision, first: bool, style: Style, filled: bool) -> Result<Vec<Vec<String>>, NumberError> {
    let cell = |x: &Real, given: bool| match x.as_rational() {
        // What is given is shown as it was given, where that is short.
        Some(x) if given && decimal_or_fraction(x).len() <= MAX_FRACTION => Ok(decimal_or_fraction(x)),
        _ if filled || given => number(x, style),
        _ => Ok(blank(style.form)),
    };
    let change = |c: &Change| -> Result<Vec<String>, NumberError> {
        [&c.before, &c.after, &c.change].into_iter().map(|x| cell(x, false)).collect()
    };
    let mut rows = Vec::new();
    for (place, body) in collision.bodies.iter().enumerate() {
        // The body that is struck has not moved yet: its velocity is one of the given ones.
        let given = first || place == 1;
        let mut row = vec![body.number.to_string(), cell(&body.mass, true)?, cell(&body.velocity.before, given)?];
        row.extend(change(&body.velocity)?.into_iter().skip(1));
        row.extend(change(&body.momentum)?);
        row.extend(change(&body.energy)?);
        rows.push(row);
    }
    let mut total = vec!["total".to_owned(), String::new(), String::new(), String::new(), String::new()];
    total.extend(change(&collision.momentum)?);
    total.extend(change(&collision.energy)?);
    rows.push(total);
    Ok(rows)
}

fn number(x: &Real, style: Style) -> Result<String, NumberError> {
    if style.exact
        && let Some(text) = x.as_rational().map(ToString::to_string)
        && text.len() <= MAX_FRACTION
    {
        return Ok(text);
    }
    Ok(Decimal::of_real(x, style.digits, Rounding::Nearest)?.0.to_string())
}

fn blank(form: Form) -> String {
    match form {
        Form::Text => "_______".to_owned(),
        Form::Markdown => String::new(),
        Form::Latex => "\\rule{3em}{0.4pt}".to_owned(),
    }
}

fn heading(text: &str, form: Form, level: usize) -> String {
    match form {
        Form::Text => format!(
            "{}{text}\n{}\n",
            if level == 1 { "" } else { "\n" },
            if level == 1 { "=" } else { "-" }.repeat(text.chars().count())
        ),
        Form::Markdown => format!("{} {}\n\n", "#".repeat(level), markdown::escape(text)),
        Form::Latex => format!("\\{}*{{{}}}\n", if level == 1 { "section" } else { "subsection" }, latex(text)),
    }
}

fn paragraph(text: &str, form: Form) -> String {
    match form {
        Form::Text => format!("\n{text}\n"),
        Form::Markdown => format!("{text}\n\n"),
        Form::Latex => format!("{}\n", latex(text).replace("m v²/2", "$mv^2/2$")),
    }
}

fn latex(text: &str) -> String {
    super::latex::escape(text)
}

fn table(rows: &[Vec<String>], form: Form) -> String {
    let mut out = String::new();
    match form {
        Form::Text => {
            let width = |place: usize| {
                let cells = rows.iter().map(|row| row[place].chars().count());
                cells.max().unwrap_or(0).max(HEADINGS[place].chars().count())
            };
            let widths: Vec<usize> = (0..HEADINGS.len()).map(width).collect();
            let line = |cells: &mut dyn Iterator<Item = &str>| {
                let cells: Vec<String> = cells.zip(&widths).map(|(cell, width)| padded(cell, *width, true)).collect();
                format!("{}\n", cells.join("  "))
            };
            out.push_str(&line(&mut HEADINGS.into_iter()));
            for row in rows {
                out.push_str(&line(&mut row.iter().map(String::as_str)));
            }
        }
        Form::Markdown => {
            out.push_str(&format!("| {} |\n|{}\n", HEADINGS.join(" | "), " --: |".repeat(HEADINGS.len())));
            for row in rows {
                out.push_str(&format!("| {} |\n", row.join(" | ")));
            }
            out.push('\n');
        }
        Form::Latex => {
            out.push_str(&format!("\\begin{{tabular}}{{@{{}} {} @{{}}}}\n\\toprule\n", "r ".repeat(HEADINGS.len())));
            out.push_str(" & & \\multicolumn{3}{c}{velocity} & \\multicolumn{3}{c}{momentum} & \\multicolumn{3}{c}{kinetic energy} \\\\\n");
            out.push_str("\\cmidrule(lr){3-5} \\cmidrule(lr){6-8} \\cmidrule(lr){9-11}\n");
            out.push_str(&format!("body & mass{} \\\\\n\\midrule\n", " & before & after & change".repeat(3)));
            for (place, row) in rows.iter().enumerate() {
                let rule = if place + 1 == rows.len() { "\\midrule\n" } else { "" };
                let cells: Vec<String> = row.iter().map(|c| math(c)).collect();
                out.push_str(&format!("{rule}{} \\\\\n", cells.join(" & ")));
            }
            out.push_str("\\bottomrule\n\\end{tabular}\n\n");
        }
    }
    out
}

/// A number in mathematics mode, so that its sign is a minus.
fn math(text: &str) -> String {
    let numeric = text.starts_with(|c: char| c.is_ascii_digit() || c == '-');
    match text.split_once('e') {
        Some((mantissa, exponent)) if numeric => format!("${mantissa} \\cdot 10^{{{exponent}}}$"),
        _ if numeric => format!("${text}$"),
        _ => text.to_owned(),
    }
}
