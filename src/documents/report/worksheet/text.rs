//! Sheets as text for a terminal, and as Markdown.

use super::{Cell, Part, Sheet, Table};
use crate::report::{markdown, padded};

/// The width of a text for a terminal.
const WIDTH: usize = 78;
/// A blank to fill in by hand.
const BLANK: &str = "_______";

/// The sheet as text.
#[must_use]
pub fn text(sheet: &Sheet) -> String {
    let mut out = headed(&sheet.title, '=');
    for part in &sheet.parts {
        out.push('\n');
        match part {
            Part::Names => out.push_str("Name: ______________________   Class: ________   Date: ___________\n"),
            Part::Heading(text) => out.push_str(&headed(text, '-')),
            Part::Text(text) => out.push_str(&filled(text)),
            Part::Sketch(sketch) => sketch.lines().iter().for_each(|line| out.push_str(&format!("  {line}\n"))),
            Part::Choice { ask, options, .. } => {
                out.push_str(&filled(ask));
                for (text, right) in options {
                    out.push_str(&format!("   [{}] {text}\n", if *right { 'x' } else { ' ' }));
                }
            }
            Part::Open { ask, answer, lines, .. } => {
                out.push_str(&filled(ask));
                match answer {
                    Some(answer) => out.push_str(&format!("   {answer}\n")),
                    None => out.push_str(&format!("   {}\n", "_".repeat(WIDTH - 8)).repeat(*lines)),
                }
            }
            Part::Table(table) => out.push_str(&aligned(table)),
        }
    }
    out
}

/// The sheet as Markdown.
#[must_use]
pub fn markdown(sheet: &Sheet) -> String {
    let escape = |text: &str| markdown::escape(text);
    let mut out = format!("# {}\n", escape(&sheet.title));
    for part in &sheet.parts {
        out.push('\n');
        match part {
            Part::Names => out.push_str("Name: \\_\\_\\_\\_\\_\\_\\_\\_ Class: \\_\\_\\_\\_ Date: \\_\\_\\_\\_\n"),
            Part::Heading(text) => out.push_str(&format!("## {}\n", escape(text))),
            Part::Text(text) => out.push_str(&format!("{}\n", escape(text))),
            Part::Sketch(sketch) => out.push_str(&format!("```text\n{}\n```\n", sketch.lines().join("\n"))),
            Part::Choice { ask, options, .. } => {
                out.push_str(&format!("{}\n\n", escape(ask)));
                for (text, right) in options {
                    out.push_str(&format!("- [{}] {}\n", if *right { 'x' } else { ' ' }, escape(text)));
                }
            }
            Part::Open { ask, answer, .. } => {
                out.push_str(&format!("{}\n", escape(ask)));
                out.push_str(&answer.as_ref().map_or(String::new(), |answer| format!("\n> {}\n", escape(answer))));
            }
            Part::Table(table) => {
                if !table.title.is_empty() {
                    out.push_str(&format!("### {}\n\n", escape(&table.title)));
                }
                out.push_str(&format!("| | {} |\n", table.columns.join(" | ")));
                out.push_str(&format!("| :-- |{}\n", " --: |".repeat(table.columns.len())));
                for row in table.groups.iter().flatten() {
                    let cells = row.cells.iter().map(|cell| match cell {
                        Cell::Number(text) => text.as_str(),
                        Cell::Blank(_) | Cell::Nothing => "",
                    });
                    out.push_str(&format!("| {} | {} |\n", escape(&row.name), cells.collect::<Vec<_>>().join(" | ")));
                }
            }
        }
    }
    out
}

fn headed(text: &str, line: char) -> String {
    format!("{text}\n{}\n", line.to_string().repeat(text.chars().count()))
}

/// A paragraph in lines of at most [`WIDTH`] characters, but for longer words.
fn filled(text: &str) -> String {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let last = lines.last().map_or(0, |line| line.chars().count());
        if last > 0 && last + 1 + word.chars().count() > WIDTH {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
    }
    lines.join("\n") + "\n"
}

fn aligned(table: &Table) -> String {
    let shown = |cell: &Cell| match cell {
        Cell::Number(text) => text.clone(),
        Cell::Blank(_) => BLANK.to_owned(),
        Cell::Nothing => String::new(),
    };
    let mut rows = vec![std::iter::once(String::new()).chain(table.columns.iter().cloned()).collect::<Vec<String>>()];
    for row in table.groups.iter().flatten() {
        rows.push(std::iter::once(row.name.clone()).chain(row.cells.iter().map(shown)).collect());
    }
    let columns = rows.first().map_or(0, Vec::len);
    let width = |place: usize| rows.iter().filter_map(|row| row.get(place)).map(|cell| cell.chars().count()).max();
    let widths: Vec<usize> = (0..columns).map(|place| width(place).unwrap_or(0)).collect();
    let mut out = if table.title.is_empty() { String::new() } else { format!("{}\n", table.title) };
    for row in rows {
        let cells: Vec<String> =
            row.iter().zip(&widths).enumerate().map(|(i, (cell, width))| padded(cell, *width, i > 0)).collect();
        out.push_str(&format!("  {}\n", cells.join("  ").trim_end()));
    }
    out
}
