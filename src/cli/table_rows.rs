//! How a row of a table's file looks from outside: enough to tell it from the rows of all other tables.
//!
//! **Contract.** [`Rows::has`] says whether a line is the row that belongs at a place: it begins with the values of the axes
//! there, has as many fields as the heading, and a value. Whether the value is right is not asked: that is for
//! `carom table --check` and `carom check`.

use crate::table::Plan;
use serde_json::Value;

/// The contents of a file.
#[derive(Clone, Copy)]
pub(super) enum Form {
    /// The table itself.
    Csv,
    /// Its certificate, one JSON object a line.
    Certificate,
}

/// The rows of one file.
pub(super) struct Rows<'a> {
    plan: &'a Plan,
    form: Form,
    commas: usize,
}

impl<'a> Rows<'a> {
    /// The rows below a head, whose last line is the heading.
    pub(super) fn new(plan: &'a Plan, form: Form, head: &str) -> Rows<'a> {
        Rows { plan, form, commas: head.lines().last().unwrap_or_default().matches(',').count() }
    }

    /// The columns before the value of a row.
    fn begin(&self, row: u64) -> String {
        match self.form {
            Form::Csv => format!("{},", self.plan.labels(row).join(",")),
            Form::Certificate => {
                let place = self.plan.place(row);
                let ratio = Value::from(place.as_ref().map(|p| p.ratio.value().to_string()));
                let e = Value::from(place.as_ref().and_then(|p| p.e.as_ref()).map(|e| e.value().to_string()));
                let n = Value::from(place.as_ref().and_then(|p| p.n).map(|n| n.to_string()));
                format!("{{\"row\":{row},\"ratio\":{ratio},\"e\":{e},\"n\":{n},\"printed\":\"")
            }
        }
    }

    /// Whether a line, with its end, is this row of the table.
    pub(super) fn has(&self, row: u64, line: &[u8]) -> bool {
        let whole = match self.form {
            Form::Csv => line.ends_with(b"\n") && line.iter().filter(|b| **b == b',').count() == self.commas,
            Form::Certificate => line.ends_with(b"}\n"),
        };
        let value = line.strip_prefix(self.begin(row).as_bytes());
        whole && value.is_some_and(|rest| !matches!(rest.first(), None | Some(b',' | b'"' | b'\n' | b'\r')))
    }
}
