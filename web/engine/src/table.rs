//! Tables of certified numbers.

use crate::request::{Fault, MAX_DIGITS, Request, numeral};
use carom_documents::report::table::{Form, Head, Writer, entries};
use carom_exact::number::decimal::{Digits, Rounding};
use carom_exact::number::{rational, typed};
use carom_physics::scene::read::ROUNDINGS;
use carom_physics::table::grid::{Grid, GridError};
use carom_physics::table::shared::Factors;
use carom_physics::table::{Plan, Printing, Quantity, TableError};
use malachite::Rational;
use malachite::base::num::conversion::traits::IsInteger;
use serde_json::{Value, json};

/// The most rows of a table on this page.
const MAX_ROWS: u64 = 20_000;
/// The rows that the page shows.
const SHOWN: u64 = 200;

/// A table in a form, with its first rows as cells.
pub fn table(request: &Request) -> Result<Value, Fault> {
    let plan = plan(request)?;
    let form = match request.text("format")? {
        "" | "csv" => Form::Csv,
        "spreadsheet" => Form::Spreadsheet,
        "spreadsheet-comma" => Form::SpreadsheetComma,
        "latex" => Form::Latex,
        "markdown" => Form::Markdown,
        "json" => Form::Json,
        "text" => Form::Text,
        other => return Err(Fault::at("format", format!("no form is called {other:?}"))),
    };
    let head = Head::of(&plan);
    let names: Vec<String> = head.columns.iter().map(|c| c.name.clone()).collect();
    let facts: Vec<Value> = head.facts.iter().map(|(name, text)| json!([name, text])).collect();
    let mut writer = Writer::new(form, head);
    let mut out = Vec::new();
    let mut cells: Vec<Value> = Vec::new();
    let unwritten = |e: std::io::Error| Fault::new(format!("the table cannot be written: {e}"));
    writer.begin(&mut out).map_err(unwritten)?;
    let mut factors = Factors::new(&plan);
    for row in 0..plan.rows() {
        let found = factors.value(row).map_err(|e| fault(&e))?;
        let (line, _) = plan.row(row, found).map_err(|e| fault(&e))?;
        let entries = entries(&plan, line);
        if row < SHOWN {
            cells.push(entries.iter().map(|e| e.plain()).collect::<Vec<_>>().into());
        }
        writer.row(entries, &mut out).map_err(unwritten)?;
    }
    writer.end(&mut out).map_err(unwritten)?;
    Ok(json!({
        "rows": plan.rows(),
        "columns": names,
        "facts": facts,
        "cells": cells,
        "text": String::from_utf8_lossy(&out),
    }))
}

fn plan(request: &Request) -> Result<Plan, Fault> {
    let quantity = match request.text("want")? {
        "" | "eta" => Quantity::Eta,
        "threshold" => Quantity::Threshold,
        "best-n" => Quantity::BestN,
        other => return Err(Fault::at("want", format!("there is no table of {other:?}"))),
    };
    let ratio = grid(request, "ratio")?;
    let e = if quantity.needs_e() { Some(grid(request, "e")?) } else { None };
    let n = if quantity.needs_n() { Some(grid(request, "n")?) } else { None };
    let count = request.natural("digits")?;
    if count > MAX_DIGITS {
        return Err(Fault::at("digits", format!("limit reached: {MAX_DIGITS} digits on this page")).limit());
    }
    let digits = match request.text("count")? {
        "places" => Digits::Places(count),
        _ => Digits::Significant(count),
    };
    let name = request.text("round")?;
    let rounding = ROUNDINGS.iter().find(|r| r.0 == name).map_or(Rounding::Nearest, |r| r.1);
    let plan = Plan::new(quantity, ratio, e, n, Printing { digits, rounding, extra: 0 }).map_err(|e| fault(&e))?;
    if plan.rows() > MAX_ROWS {
        let help = "the command line writes tables of any length: carom table --help";
        let message = format!("limit reached: {MAX_ROWS} rows on this page, {} asked for", plan.rows());
        return Err(Fault::new(message).limit().help(help));
    }
    Ok(plan)
}

fn grid(request: &Request, field: &'static str) -> Result<Grid, Fault> {
    let in_range = |x: &Rational| match field {
        "n" => x.is_integer() && *x >= 0,
        "e" => *x >= 0 && *x <= 1,
        _ => *x > 0,
    };
    let fits = |part: &str| rational::parse(part).is_ok_and(|x| in_range(&x));
    let plain = typed::grid(request.text(field)?, fits).map_err(|unclear| Fault::unclear(field, unclear))?;
    Grid::parse(&plain).map_err(|error| {
        let message = match &error {
            GridError::Numeral { part, error } => numeral(part, error),
            error => error.to_string(),
        };
        Fault { limit: error.is_limit(), ..Fault::at(field, message) }
    })
}

fn fault(error: &TableError) -> Fault {
    let field = match error {
        TableError::Lacks(_, axis) | TableError::Independent(_, axis) => Some(*axis),
        TableError::Range { axis, .. } => Some(match *axis {
            "a ratio" => "ratio",
            "a restitution e" => "e",
            _ => "n",
        }),
        TableError::NotIntegral => Some("n"),
        TableError::Digits(_) => Some("digits"),
        _ => None,
    };
    Fault { field, limit: error.is_limit(), ..Fault::new(error.to_string()) }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    fn table(changes: &[(&str, &str)]) -> Value {
        let mut request = json!({"ratio": "1,2,10", "e": "0.5,1", "n": "1:3:1", "digits": "6", "want": "eta"});
        for (field, text) in changes {
            request[*field] = json!(text);
        }
        serde_json::from_str(&crate::table(&request.to_string())).expect("JSON")
    }

    #[test]
    fn all_forms_have_all_rows() {
        for (form, line) in
            [("csv", "\n2,0.5,1,0.298052,"), ("latex", "\\begin{"), ("markdown", "|"), ("json", "\"eta\"")]
        {
            let found = table(&[("format", form)]);
            assert_eq!(found["rows"], 18);
            assert!(found["text"].as_str().expect("text").contains(line), "{form}: {}", found["text"]);
            assert_eq!(found["cells"].as_array().map(Vec::len), Some(18));
        }
    }

    #[test]
    fn faults_name_their_field_and_limits_are_limits() {
        assert_eq!(table(&[("ratio", "1:2")])["error"]["field"], "ratio");
        assert_eq!(table(&[("e", "1.5")])["error"]["field"], "e");
        assert_eq!(table(&[("n", "0.5")])["error"]["field"], "n");
        assert_eq!(table(&[("ratio", "1:100000:1")])["error"]["limit"], true);
        assert_eq!(table(&[("digits", "99999")])["error"]["limit"], true);
    }
}
