//! `carom table --across`: cross tables that fit a page.

use super::table::exit;
use super::{Exit, deliver};
use crate::report::table::{Form, Writer, cross};
use crate::table::shared::Factors;
use crate::table::{Plan, TableError};
use std::path::Path;

/// The most cells: a cross table is for readers.
const MAX_CELLS: u64 = 20_000;

/// An axis.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Axis {
    /// The mass ratio
    Ratio,
    /// The restitution
    E,
    /// The number of inserted bodies
    N,
}

impl Axis {
    fn name(self) -> &'static str {
        match self {
            Self::Ratio => "ratio",
            Self::E => "e",
            Self::N => "n",
        }
    }
}

/// Writes the cross tables of a plan.
pub(super) fn run(plan: &Plan, axis: Axis, fractions: bool, form: Form, output: Option<&Path>) -> Result<u8, Exit> {
    let names = plan.axis_names();
    let Some(across) = names.iter().position(|name| *name == axis.name()) else {
        let message = format!("error: --across {}: this table has the axes {}", axis.name(), names.join(", "));
        return Err(Exit::usage(message));
    };
    if names.len() < 2 {
        return Err(Exit::usage("error: --across: a table with one axis has nothing to run down"));
    }
    if form == Form::Json {
        return Err(Exit::usage("error: --across: JSON has one object for each cell; leave --across out"));
    }
    if plan.rows() > MAX_CELLS {
        let message = format!("limit reached: cells of a cross table: {MAX_CELLS} allowed, {} asked for", plan.rows());
        return Err(Exit { code: 3, message });
    }
    let mut factors = Factors::new(plan);
    let rows = (0..plan.rows()).map(|row| Ok(plan.row(row, factors.value(row)?)?.0));
    let rows = rows.collect::<Result<Vec<_>, TableError>>().map_err(|e| exit(&e))?;
    let room = match form {
        Form::Csv | Form::Spreadsheet | Form::SpreadsheetComma => None,
        Form::Latex => Some(cross::LATEX),
        _ => Some(cross::PAGE),
    };
    let mut out: Vec<u8> = Vec::new();
    let cannot = |e: std::io::Error| Exit::usage(format!("error: cannot write the table: {e}"));
    for (place, (head, rows)) in cross::tables(plan, &rows, across, fractions, room).into_iter().enumerate() {
        let mut head = head;
        if place > 0 {
            // Said once.
            head.facts.clear();
            out.extend_from_slice(if form == Form::Latex { b"\n\\par\\bigskip\n\n" } else { b"\n" });
        }
        let mut writer = Writer::new(form, head);
        writer.begin(&mut out).map_err(cannot)?;
        for row in rows {
            writer.row(row, &mut out).map_err(cannot)?;
        }
        writer.end(&mut out).map_err(cannot)?;
    }
    deliver(output, &String::from_utf8_lossy(&out))?;
    Ok(0)
}
