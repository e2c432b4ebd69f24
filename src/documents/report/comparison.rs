//! Somebody's table beside the certified values, as a table.

use super::counted;
use super::table::{Column, Entry, Head};
use crate::number::decimal::Rounding;
use crate::table::Quantity;
use crate::table::check::Judgement;
use crate::table::comparison::{Judged, Tally};
use crate::table::grid::decimal_or_fraction;

/// The head of the report.
#[must_use]
pub fn head(quantities: impl Iterator<Item = Quantity>, rounding: Rounding) -> Head {
    let mut facts: Vec<(&'static str, String)> =
        quantities.map(|quantity| ("formula", quantity.formula().to_owned())).collect();
    facts.push(("rounding", format!("to as many decimal places as each cell has, {}", rounding.rule())));
    facts.push(("program", format!("carom {}", env!("CARGO_PKG_VERSION"))));
    let numbers = [("line", "\\mathrm{line}"), ("ratio", "m_1/m_2"), ("e", "e"), ("n", "n")];
    let mut columns: Vec<Column> = numbers.iter().map(|(name, latex)| Column::number(name, latex)).collect();
    columns.push(Column::words("quantity"));
    columns.push(Column { numeric: true, ..Column::words("written") });
    columns.push(Column { numeric: true, ..Column::words("certified") });
    columns.push(Column::words("judgement"));
    Head { facts, latex: String::new(), columns }
}

/// A cell as a row of the report.
#[must_use]
pub fn entries(cell: &Judged) -> Vec<Entry> {
    let entry = |value: &Option<malachite::Rational>| {
        value.as_ref().map_or(Entry::Empty, |v| Entry::Plain(decimal_or_fraction(v)))
    };
    let plain = |text: &str| Entry::Plain(text.to_owned());
    vec![
        plain(&cell.line.to_string()),
        entry(&cell.ratio),
        entry(&cell.e),
        entry(&cell.n),
        plain(cell.quantity.name()),
        plain(&cell.written),
        plain(cell.judgement.as_ref().map_or("", |judgement| &judgement.certified)),
        plain(&judgement(cell)),
    ]
}

/// The judgement of a cell, in words.
#[must_use]
pub fn judgement(cell: &Judged) -> String {
    cell.judgement.as_ref().map_or_else(|| "empty".to_owned(), Judgement::text)
}

/// All cells in a line.
#[must_use]
pub fn summary(tally: &Tally) -> String {
    let mut out = format!(
        "{}: {} right, {} rounded otherwise, {} wrong",
        counted(tally.judged(), "cell"),
        tally.right,
        tally.rounded,
        tally.wrong,
    );
    for (count, what) in [(tally.unreadable, "unreadable"), (tally.empty, "empty")] {
        if count > 0 {
            out += &format!("; {count} {what}");
        }
    }
    out
}
