//! The coefficient of restitution from measured bounces.

use crate::number::{Hex, hex};
use crate::refusal::{Refusal, detached};
use carom::chain::bounces::{Bound, Estimate, Kind};
use carom::report::bounces;
use carom::table::bounces::{MeasurementError, Measurements};
use pyo3::prelude::*;

impl From<MeasurementError> for Refusal {
    fn from(error: MeasurementError) -> Refusal {
        let place = match &error {
            MeasurementError::Reading { line, .. } => format!("reading {line}: "),
            _ => String::new(),
        };
        let text = format!("{place}{error}");
        if error.is_limit() { Refusal::Limit(text) } else { Refusal::Input(text) }
    }
}

/// A bound of e: the number where it is rational, the quotient and which root of it, and the two readings that it comes
/// from, each with its line or place and its text.
type Ends = (Option<Hex>, Hex, u64, Option<Vec<(u64, String)>>);

/// What was measured: the text of a table, or for each ball the list of its readings and whether they are heights.
#[derive(FromPyObject)]
pub enum Measured {
    /// A table.
    Table(String),
    /// Lists.
    Lists(bool, Vec<Vec<String>>),
}

/// Whether one e explains the readings, the two bounds of it, how many readings there are, and the whole in words.
#[pyfunction]
pub fn restitution(
    py: Python<'_>,
    measured: Measured,
    within: Option<String>,
    digits: u64,
) -> Result<(bool, Ends, Ends, usize, String), Refusal> {
    detached(py, || {
        let within = within.as_deref();
        let found = match measured {
            Measured::Table(text) => Measurements::read(text.as_bytes(), within)?,
            Measured::Lists(true, runs) => Measurements::of_lists(Kind::Heights, &runs, within)?,
            Measured::Lists(false, runs) => Measurements::of_lists(Kind::Times, &runs, within)?,
        };
        let estimate = found.estimate()?;
        let words = bounces::text(&found, &estimate, digits)?;
        let (consistent, lower, upper) = match &estimate {
            Estimate::Consistent(lower, upper) => (true, lower, upper),
            Estimate::Contradiction(lower, upper) => (false, lower, upper),
        };
        let bound = |end: &Bound| -> Ends {
            let readings = found.pair(end.from).map(|pair| pair.map(|one| (one.line, one.text.clone())).to_vec());
            (end.value().as_rational().map(hex), hex(&end.quotient), end.index, readings)
        };
        Ok((consistent, bound(lower), bound(upper), found.count(), words))
    })
}
