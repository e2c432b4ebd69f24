//! Tables as text, CSV, JSON, Markdown and LaTeX, written row by row.
//!
//! Contract: [`Writer::begin`], then [`Writer::row`] for each row, then [`Writer::end`]; what is written
//! then is a whole table. Text holds the first thousand rows to choose the widths of its columns, and LaTeX all of
//! [`LATEX_ROWS`] at most; the other forms hold none.

pub mod cross;
pub mod csv;
mod json;
pub(in crate::report) mod latex;
mod markdown;
mod text;

use super::visible;
use crate::number::decimal::Digits;
use crate::table::{Plan, Quantity, Row};
use std::io::{self, Write};

/// Rows that are looked at before widths are chosen.
const BLOCK: usize = 1_000;
/// The most rows of a table in LaTeX: its columns are as wide as their widest entry, which must be known.
pub const LATEX_ROWS: u64 = 100_000;

/// The forms of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Aligned columns.
    Text,
    /// Comma-separated values after comment lines.
    Csv,
    /// CSV for Excel and LibreOffice: no comment lines, and no fractions that they would read as dates.
    Spreadsheet,
    /// The same with semicolons and decimal commas.
    SpreadsheetComma,
    /// One object with the rows in a list.
    Json,
    /// A table of Markdown.
    Markdown,
    /// A table for booktabs and siunitx.
    Latex,
}

/// A column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its name in headings and keys.
    pub name: String,
    /// Its heading in LaTeX.
    pub latex: String,
    /// Its entries are numbers.
    pub numeric: bool,
}

impl Column {
    /// A column of numbers with its heading in mathematics mode.
    #[must_use]
    pub fn number(name: &str, latex: &str) -> Column {
        Column { name: name.to_owned(), latex: format!("${latex}$"), numeric: true }
    }

    /// A column of words.
    #[must_use]
    pub fn words(name: &str) -> Column {
        Column { name: name.to_owned(), latex: name.to_owned(), numeric: false }
    }
}

/// What stands above a table.
#[derive(Clone, Debug)]
pub struct Head {
    /// Names and texts: the formula, its number, the rule of rounding, the version.
    pub facts: Vec<(&'static str, String)>,
    /// The formula for LaTeX.
    pub latex: String,
    /// The columns.
    pub columns: Vec<Column>,
}

impl Head {
    /// The head of a table of certified numbers.
    #[must_use]
    pub fn of(plan: &Plan) -> Head {
        let (quantity, printing) = (plan.quantity(), plan.printing());
        let count = match printing.digits {
            Digits::Significant(1) => "1 significant digit".to_owned(),
            Digits::Significant(digits) => format!("{digits} significant digits"),
            Digits::Places(1) => "1 place after the point".to_owned(),
            Digits::Places(places) => format!("{places} places after the point"),
        };
        let mut facts = vec![
            ("formula", format!("{}, r = m1/m2 = ratio", quantity.formula())),
            ("equation", format!("{} of Ricardo & Lee 2015, inserted bodies of optimal mass", quantity.equation())),
        ];
        if quantity != Quantity::BestN {
            facts.push(("rounding", format!("{count}, {}; every digit is certified", printing.rounding.rule())));
            facts.push((
                "exact",
                format!("p/q where the value is rational, up to {} characters", crate::table::MAX_EXACT),
            ));
        }
        if printing.extra > 0 {
            let text = "the value cut off after more digits; it lies less than the bound farther from zero";
            facts.push(("further", text.to_owned()));
        }
        facts.push(("program", format!("carom {}", env!("CARGO_PKG_VERSION"))));
        let axis = |name: &str| match name {
            "ratio" => Column::number("ratio", "m_1/m_2"),
            name => Column::number(name, name),
        };
        let mut columns: Vec<Column> = plan.axis_names().into_iter().map(axis).collect();
        columns.push(Column::number(
            quantity.name(),
            match quantity {
                Quantity::Eta => "\\eta",
                Quantity::Threshold => "L_n",
                Quantity::BestN => "n^*",
            },
        ));
        if quantity != Quantity::BestN {
            columns.push(Column::words("exact"));
        }
        if printing.extra > 0 {
            columns.push(Column { numeric: true, ..Column::words("further") });
            columns.push(Column { numeric: true, ..Column::words("bound") });
        }
        Head { facts, latex: quantity.latex().to_owned(), columns }
    }
}

/// A row of such a table.
#[must_use]
pub fn entries(plan: &Plan, row: Row) -> Vec<Entry> {
    let mut out: Vec<Entry> = row.labels.into_iter().map(Entry::Plain).collect();
    out.push(Entry::Plain(row.value));
    if plan.quantity() != Quantity::BestN {
        out.push(row.exact.map_or(Entry::Empty, Entry::Plain));
    }
    if let Some(further) = row.further {
        out.push(Entry::Small(further.decimal, further.small));
        out.push(Entry::Plain(further.bound));
    }
    out
}

/// An entry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Entry {
    /// As it stands.
    Plain(String),
    /// A number of which the last so many digits are printed small.
    Small(String, usize),
    /// Nothing.
    Empty,
}

impl Entry {
    /// The entry without ornament.
    #[must_use]
    pub fn plain(&self) -> &str {
        match self {
            Self::Plain(text) | Self::Small(text, _) => text,
            Self::Empty => "",
        }
    }

    /// The entry for a terminal, if it is somebody else's text: see [`visible`].
    #[must_use]
    pub fn visible(self) -> Entry {
        match self {
            Self::Plain(text) => Self::Plain(visible(&text).into_owned()),
            other => other,
        }
    }

    /// The mantissa without its small digits, the small digits, and the exponent with its sign.
    pub(super) fn parts(&self) -> (&str, &str, &str) {
        let Self::Small(text, small) = self else { return (self.plain(), "", "") };
        let (mantissa, exponent) = text.split_once('e').map_or((text.as_str(), ""), |(m, e)| (m, e));
        // A point among the small digits is carried along.
        let mut at = mantissa.len();
        let mut left = *small;
        for (place, c) in mantissa.char_indices().rev() {
            if left == 0 {
                break;
            }
            at = place;
            left -= usize::from(c.is_ascii_digit());
        }
        let at = if mantissa[..at].ends_with('.') { at - 1 } else { at };
        let (kept, small) = mantissa.split_at(at);
        (kept, small, exponent)
    }
}

/// Writes one table.
#[derive(Clone)]
pub struct Writer {
    form: Form,
    head: Head,
    held: Vec<Vec<Entry>>,
    widths: Option<Vec<usize>>,
    rows: u64,
    /// The place of a column that is left out.
    without: Option<usize>,
}

impl Writer {
    /// Nothing is written yet.
    #[must_use]
    pub fn new(form: Form, head: Head) -> Writer {
        Writer { form, head, held: Vec::new(), widths: None, rows: 0, without: None }
    }

    /// Leaves a column out, and what the head says of it.
    #[must_use]
    pub fn without(mut self, name: &str) -> Writer {
        self.without = self.head.columns.iter().position(|column| column.name == name);
        self.head.columns.retain(|column| column.name != name);
        self.head.facts.retain(|fact| fact.0 != name);
        self
    }

    /// The head as CSV has it, for comparing with a file begun earlier.
    #[must_use]
    pub fn csv_head(&self) -> String {
        csv::head(&self.head, csv::Dialect::Plain)
    }

    /// A writer that writes the same rows in the same way; `None` as long as rows are held back, or any would be.
    #[must_use]
    pub fn settled(&self) -> Option<Writer> {
        let settled = match self.form {
            Form::Text => self.widths.is_some(),
            Form::Latex => false,
            Form::Csv | Form::Spreadsheet | Form::SpreadsheetComma | Form::Json | Form::Markdown => true,
        };
        settled.then(|| self.clone())
    }

    /// Goes on after rows that are written already, by another writer or in an earlier run (CSV).
    pub fn resume(&mut self, rows: u64) {
        self.rows = rows;
    }

    /// Writes what stands above the rows.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn begin(&mut self, out: &mut dyn Write) -> io::Result<()> {
        match self.form {
            Form::Text => text::begin(&self.head, out),
            Form::Csv => out.write_all(csv::head(&self.head, csv::Dialect::Plain).as_bytes()),
            Form::Spreadsheet => out.write_all(csv::head(&self.head, csv::Dialect::Spreadsheet).as_bytes()),
            Form::SpreadsheetComma => out.write_all(csv::head(&self.head, csv::Dialect::Comma).as_bytes()),
            Form::Json => json::begin(&self.head, out),
            Form::Markdown => markdown::begin(&self.head, out),
            Form::Latex => latex::begin(&self.head, out),
        }
    }

    /// Writes a row.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn row(&mut self, mut row: Vec<Entry>, out: &mut dyn Write) -> io::Result<()> {
        self.rows += 1;
        if let Some(place) = self.without.filter(|place| *place < row.len()) {
            row.remove(place);
        }
        match self.form {
            Form::Csv => csv::row(&row, csv::Dialect::Plain, out),
            Form::Spreadsheet => csv::row(&row, csv::Dialect::Spreadsheet, out),
            Form::SpreadsheetComma => csv::row(&row, csv::Dialect::Comma, out),
            Form::Json => json::row(&self.head, &row, self.rows == 1, out),
            Form::Markdown => markdown::row(&row, out),
            Form::Text => match &self.widths {
                Some(widths) => text::row(&self.head, &row, widths, out),
                None => {
                    self.held.push(row);
                    if self.held.len() >= BLOCK { self.release(out) } else { Ok(()) }
                }
            },
            Form::Latex => {
                self.held.push(row);
                Ok(())
            }
        }
    }

    /// Writes the rows that are held as text.
    fn release(&mut self, out: &mut dyn Write) -> io::Result<()> {
        let widths = text::widths(&self.head, &self.held);
        text::heading(&self.head, &widths, out)?;
        for row in self.held.drain(..) {
            text::row(&self.head, &row, &widths, out)?;
        }
        self.widths = Some(widths);
        Ok(())
    }

    /// Writes what stands below the rows.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn end(&mut self, out: &mut dyn Write) -> io::Result<()> {
        match self.form {
            Form::Text if self.widths.is_none() => self.release(out),
            Form::Json => json::end(self.rows, out),
            Form::Latex => latex::rows(&self.head, &self.held, out),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_digits_are_cut_off_before_the_exponent_and_never_inside_the_point() {
        let parts = |text: &str, small| {
            let entry = Entry::Small(text.to_owned(), small);
            let (a, b, c) = entry.parts();
            format!("{a}|{b}|{c}")
        };
        assert_eq!(parts("0.0192759", 2), "0.01927|59|");
        assert_eq!(parts("1.234e-18", 2), "1.2|34|-18");
        assert_eq!(parts("1.23", 2), "1|.23|");
        assert_eq!(parts("1.23", 0), "1.23||");
    }
}
