//! eta for columns of numbers.

use crate::refusal::{Refusal, detached};
use crate::table::by_chunks;
use carom::chain::rows::{self, Column, Counts};
use carom::chain::{ChainError, MAX_INSERTED};
use carom::number::{NumberError, typed};
use pyo3::prelude::*;

/// A column as Python hands it over.
#[derive(FromPyObject)]
pub enum Given {
    /// Its kind, and the numbers as bytes of this machine.
    Bytes(String, Vec<u8>),
    /// The same number in each row, or one for each.
    Texts(bool, Vec<String>),
}

fn numbers<const N: usize, T>(bytes: &[u8], of: fn([u8; N]) -> T) -> Vec<T> {
    bytes.as_chunks().0.iter().map(|chunk| of(*chunk)).collect()
}

fn column(name: &str, given: Given) -> Result<Column, Refusal> {
    let number = |text: &String| typed::read(text).map_err(|error| Refusal::at(name, error));
    Ok(match given {
        Given::Bytes(kind, bytes) => match kind.as_str() {
            "integers" => Column::Integers(numbers(&bytes, i64::from_ne_bytes)),
            "exact" => Column::Doubles(numbers(&bytes, f64::from_ne_bytes)),
            _ => Column::Decimals(numbers(&bytes, f64::from_ne_bytes)),
        },
        Given::Texts(true, list) => match list.first() {
            Some(text) => Column::One(number(text)?),
            None => return Err(Refusal::at(name, "a number is missing")),
        },
        Given::Texts(false, list) => Column::Rationals(list.iter().map(number).collect::<Result<_, _>>()?),
    })
}

/// Columns of `m1`, `m2`, `e` and `n`.
#[pyclass(frozen, module = "carom._engine")]
pub struct Rows {
    rows: rows::Rows,
}

#[pymethods]
impl Rows {
    /// Columns of equal length; `n` has one number for all rows or one for each.
    #[new]
    fn new(py: Python<'_>, m1: Given, m2: Given, e: Given, n: Vec<u8>) -> Result<Rows, Refusal> {
        detached(py, || {
            let n = numbers(&n, u64::from_ne_bytes);
            if let Some(row) = n.iter().position(|n| *n > MAX_INSERTED) {
                let needed = n.get(row).map_or(String::new(), u64::to_string);
                let limit = NumberError::LimitReached { limit: "inserted bodies", allowed: MAX_INSERTED, needed };
                return Err(Refusal::Limit(format!("row {row}: n: {limit}")));
            }
            let n = if let [one] = n.as_slice() { Counts::One(*one) } else { Counts::Each(n) };
            let (m1, m2, e) = (column("m1", m1)?, column("m2", m2)?, column("e", e)?);
            Ok(Rows { rows: rows::Rows::new(m1, m2, e, n)? })
        })
    }

    /// Hands all rows to `sink(offset, lo, hi)`, chunk by chunk: the doubles around each eta as bytes of this machine.
    fn fill(&self, py: Python<'_>, sink: &Bound<'_, PyAny>) -> PyResult<()> {
        let place = |row: u64| usize::try_from(row).unwrap_or(usize::MAX);
        by_chunks(py, 0..self.rows.count() as u64, sink, |rows| {
            self.rows.etas(place(rows.start)..place(rows.end)).map_err(|fault| {
                let limit = matches!(fault.error, Some(ChainError::Number(NumberError::LimitReached { .. })));
                if limit { Refusal::Limit(fault.to_string()) } else { Refusal::Input(fault.to_string()) }
            })
        })
    }
}
