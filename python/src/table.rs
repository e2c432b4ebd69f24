//! Tables over grids as doubles.

use crate::refusal::{Refusal, detached};
use crate::tools::unknown_form;
use carom::number::decimal::{Digits, Rounding};
use carom::report::table::{Form, Head, Writer, entries};
use carom::table::grid::{Grid, GridError};
use carom::table::shared::Factors;
use carom::table::{self, Printing, Quantity};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::ops::Range;

/// Rows that are computed between two looks at Python: its other threads, Ctrl-C.
///
/// Few enough to stay near the processor while they are copied: `python/benchmark.py`.
const CHUNK: u64 = 1 << 14;
/// The most rows of a table as text; the command and `carom.sweep` write longer ones.
const MAX_WRITTEN: u64 = 1_000_000;

/// A quantity over its axes.
#[pyclass(frozen, module = "carom._engine")]
pub struct Plan {
    plan: table::Plan,
    axes: Vec<Grid>,
}

fn grid(name: &str, text: &str) -> Result<Grid, Refusal> {
    Grid::sample(text).map_err(|error| match error {
        GridError::Limit { .. } => Refusal::Limit(format!("{name}: {error}")),
        error => Refusal::at(name, error),
    })
}

fn fault(error: &table::TableError) -> Refusal {
    if error.is_limit() { Refusal::Limit(error.to_string()) } else { Refusal::Input(error.to_string()) }
}

/// A table and its axes.
fn planned(
    want: &str,
    ratio: &str,
    e: Option<&str>,
    n: Option<&str>,
    digits: Digits,
    rounding: Rounding,
) -> Result<(table::Plan, Vec<Grid>), Refusal> {
    let names = || Quantity::ALL.map(Quantity::name).join(", ");
    let quantity = Quantity::ALL.into_iter().find(|q| q.name() == want);
    let quantity =
        quantity.ok_or_else(|| Refusal::at("want", format!("{want:?} is not a table; write {}", names())))?;
    let ratio = grid("ratio", ratio)?;
    let e = e.map(|text| grid("e", text)).transpose()?;
    let n = n.map(|text| grid("n", text)).transpose()?;
    let axes = [Some(&ratio), e.as_ref(), n.as_ref()].into_iter().flatten().cloned().collect();
    let printing = Printing { digits, rounding, extra: 0 };
    let plan = table::Plan::new(quantity, ratio, e, n, printing).map_err(|error| fault(&error))?;
    Ok((plan, axes))
}

#[pymethods]
impl Plan {
    /// A table: the quantity and the grids as the command line writes them.
    #[new]
    fn new(py: Python<'_>, want: String, ratio: String, e: Option<String>, n: Option<String>) -> Result<Plan, Refusal> {
        detached(py, || {
            let digits = Digits::Significant(15);
            let (plan, axes) = planned(&want, &ratio, e.as_deref(), n.as_deref(), digits, Rounding::Nearest)?;
            Ok(Plan { plan, axes })
        })
    }

    /// How many rows there are.
    fn rows(&self) -> u64 {
        self.plan.rows()
    }

    /// The axes: names and how many values each has; the last one runs fastest.
    fn shape(&self) -> Vec<(&'static str, u64)> {
        self.plan.axis_names().into_iter().zip(self.axes.iter().map(Grid::len)).collect()
    }

    /// The texts of an axis's values from one place up to another.
    fn labels(&self, py: Python<'_>, axis: usize, start: u64, stop: u64) -> Result<Vec<String>, Refusal> {
        detached(py, || {
            let axis = self.axes.get(axis).ok_or_else(|| Refusal::Input("there is no such axis".to_owned()))?;
            Ok((start..stop.min(axis.len())).filter_map(|place| axis.label(place)).collect())
        })
    }

    /// Hands the rows from one up to another to `sink(offset, lo, hi)`, chunk by chunk: the doubles around each value as
    /// bytes of this machine.
    fn fill(&self, py: Python<'_>, start: u64, stop: u64, sink: &Bound<'_, PyAny>) -> PyResult<()> {
        let stop = stop.min(self.plan.rows());
        let mut factors = Factors::new(&self.plan);
        by_chunks(py, start..stop, sink, |rows| {
            rows.map(|row| factors.neighbours(row).map_err(|error| fault(&error))).collect()
        })
    }
}

/// A table as text, in one of the forms of the command.
#[pyfunction]
#[allow(clippy::too_many_arguments)] // the flags of the command
pub fn table_text(
    py: Python<'_>,
    want: String,
    axes: (String, Option<String>, Option<String>),
    digits: (bool, u64),
    rounding: &str,
    form: &str,
) -> Result<String, Refusal> {
    let forms = [
        ("text", Form::Text),
        ("csv", Form::Csv),
        ("spreadsheet", Form::Spreadsheet),
        ("spreadsheet-comma", Form::SpreadsheetComma),
        ("json", Form::Json),
        ("markdown", Form::Markdown),
        ("latex", Form::Latex),
    ];
    let form = forms
        .iter()
        .find(|(name, _)| *name == form)
        .map(|(_, form)| *form)
        .ok_or_else(|| unknown_form(form, "text, csv, spreadsheet, spreadsheet-comma, json, markdown or latex"))?;
    let rounding = crate::tools::rounding(rounding)?;
    let digits = if digits.0 { Digits::Places(digits.1) } else { Digits::Significant(digits.1) };
    detached(py, || {
        let (plan, _) = planned(&want, &axes.0, axes.1.as_deref(), axes.2.as_deref(), digits, rounding)?;
        if plan.rows() > MAX_WRITTEN {
            let rows = plan.rows();
            return Err(Refusal::Limit(format!(
                "limit reached: rows of a text: {MAX_WRITTEN} allowed, {rows} asked for"
            )));
        }
        let mut writer = Writer::new(form, Head::of(&plan));
        let mut out = Vec::new();
        let mut factors = Factors::new(&plan);
        // Writing to memory does not fail.
        let written = |found: std::io::Result<()>| found.map_err(|_| Refusal::Failure);
        written(writer.begin(&mut out))?;
        for row in 0..plan.rows() {
            let found = factors.value(row).map_err(|error| fault(&error))?;
            let (line, _) = plan.row(row, found).map_err(|error| fault(&error))?;
            written(writer.row(entries(&plan, line), &mut out))?;
        }
        written(writer.end(&mut out))?;
        String::from_utf8(out).map_err(|_| Refusal::Failure)
    })
}

/// Hands the ends of some rows to `sink(offset, lo, hi)`, chunk by chunk.
pub fn by_chunks(
    py: Python<'_>,
    rows: Range<u64>,
    sink: &Bound<'_, PyAny>,
    mut ends: impl FnMut(Range<u64>) -> Result<Vec<(f64, f64)>, Refusal> + Send,
) -> PyResult<()> {
    let mut at = rows.start;
    while at < rows.end {
        let end = rows.end.min(at.saturating_add(CHUNK));
        let (lo, hi) = detached(py, || {
            let found = ends(at..end)?;
            let bytes = |of: fn(&(f64, f64)) -> f64| -> Vec<u8> {
                found.iter().map(|ends| of(ends).to_ne_bytes()).collect::<Vec<_>>().into_flattened()
            };
            Ok((bytes(|ends| ends.0), bytes(|ends| ends.1)))
        })?;
        sink.call1((at - rows.start, PyBytes::new(py, &lo), PyBytes::new(py, &hi)))?;
        at = end;
    }
    Ok(())
}
