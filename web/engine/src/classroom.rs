//! The teacher's tools: worksheets, the check of a pupil's table, the restitution of measured bounces.

use crate::request::{Fault, Request, numeral};
use carom_documents::report::plot::pdf;
use carom_documents::report::worksheet::made::{MAX_VERSIONS, STANDARD, Wanted, sheets};
use carom_documents::report::worksheet::sketch::Stroke;
use carom_documents::report::worksheet::{Cell, Part, Sheet, Style, html, latex, pages, text};
use carom_documents::report::{bounces, comparison};
use carom_exact::number::decimal::{Digits, Rounding};
use carom_exact::number::typed;
use carom_physics::chain::bounces::{Estimate, Kind};
use carom_physics::chain::{ChainError, MAX_LISTED};
use carom_physics::scene::drop::Drop;
use carom_physics::scene::read::{self, ROUNDINGS, Subject};
use carom_physics::scene::{About, Chain, Inserted, Scene, Start};
use carom_physics::table::bounces::{MeasurementError, Measurements};
use carom_physics::table::check::Agreement;
use carom_physics::table::comparison::{Comparison, Given, Tally};
use carom_physics::table::grid::{Grid, GridError};
use serde_json::{Value, json};

/// The most digits of an entry, and of a bound.
const MAX_DIGITS: u64 = 50;
/// The most bodies of a worksheet on this page.
const MAX_BODIES: u64 = 20;
/// The most bytes of a table or of measurements.
const MAX_BYTES: usize = 200_000;
/// The most cells that are judged.
const MAX_CELLS: usize = 5_000;

/// A worksheet: `{kind, masses, e, velocity, floor, height, title, about, …}`; `format` is `view` for its parts.
pub fn worksheet(request: &Request) -> Result<Value, Fault> {
    let (about, subject) = match request.text("kind")? {
        "" | "chain" => (about(request)?, carts(request)?),
        "drop" => (about(request)?, balls(request)?),
        other => return Err(Fault::at("kind", format!("there is no worksheet of {other:?}"))),
    };
    let title = match (request.text("title")?, &subject) {
        ("", Subject::Chain(_)) => "Carts in a row".to_owned(),
        ("", Subject::Drop(..)) => "Balls dropped together".to_owned(),
        (typed, _) => typed.to_owned(),
    };
    let digits = few(request, "digits", MAX_DIGITS)?;
    let sheet = request.text("sheet")?;
    let wanted = Wanted {
        title: &title,
        standard: (request.text("standard")? == "yes").then_some(STANDARD),
        blank: sheet != "key",
        key: sheet != "blank",
        versions: u8::try_from(counted(request, "versions", MAX_VERSIONS.into())?).unwrap_or(MAX_VERSIONS),
        seed: request.natural("seed")?,
        style: Style { digits: Digits::Significant(digits), exact: request.text("exact")? == "yes" },
    };
    let made = sheets(&about, &subject, &wanted).map_err(|error| Fault::chain(field(&error), &error))?;
    let letter = request.text("paper")? == "letter";
    let joined = |one: fn(&Sheet) -> String| made.iter().map(one).collect::<Vec<_>>().join("\n\n");
    Ok(match request.text("format")? {
        "" | "view" => json!({ "sheets": made.iter().map(view).collect::<Vec<_>>() }),
        "html" => json!({ "text": html::page(&made, letter) }),
        "latex" => json!({ "text": latex::document(&made, letter) }),
        "markdown" => json!({ "text": joined(text::markdown) }),
        "pdf" => json!({ "base64": base64(&pdf::render(&pages::pages(&made, letter))) }),
        other => return Err(Fault::at("format", format!("no form is called {other:?}"))),
    })
}

/// The field that an error of a sheet is about.
fn field(error: &ChainError) -> Option<&'static str> {
    match error {
        ChainError::Count { of: "coefficients of restitution", .. } => Some("e"),
        ChainError::NotAtRest | ChainError::NoCollision { .. } | ChainError::MayNotCollide { .. } => Some("velocity"),
        _ => None,
    }
}

/// A number from 1 to a limit.
fn few(request: &Request, field: &'static str, most: u64) -> Result<u64, Fault> {
    match counted(request, field, most)? {
        0 => Err(Fault::at(field, "at least 1 is needed")),
        count => Ok(count),
    }
}

fn counted(request: &Request, field: &'static str, most: u64) -> Result<u64, Fault> {
    let count = request.natural(field)?;
    if count > most {
        return Err(Fault::at(field, format!("limit reached: {most} at most")).limit());
    }
    Ok(count)
}

fn about(request: &Request) -> Result<About, Fault> {
    let text = |field| Ok::<_, Fault>(Some(request.text(field)?.to_owned()).filter(|text| !text.is_empty()));
    let unit = |field| match text(field)? {
        Some(unit) if !read::is_unit(&unit) => Err(Fault::at(field, format!("{unit:?} is not a unit"))),
        unit => Ok(unit),
    };
    Ok(About {
        title: None,
        text: text("about")?,
        mass: unit("mass_unit")?,
        velocity: unit("velocity_unit")?,
        height: unit("height_unit")?,
    })
}

/// So many bodies, and no more.
fn bodies<T>(list: Vec<T>) -> Result<Vec<T>, Fault> {
    if list.len() as u64 > MAX_BODIES.min(MAX_LISTED) {
        return Err(Fault::at("masses", format!("limit reached: {MAX_BODIES} bodies on a sheet of this page")).limit());
    }
    Ok(list)
}

fn carts(request: &Request) -> Result<Subject, Fault> {
    let mut masses = bodies(request.bodies("masses")?)?.into_iter();
    let (Some(first), Some(last)) = (masses.next(), masses.next_back()) else {
        return Err(Fault::at("masses", "at least two masses are needed, as in 2, 1"));
    };
    let start = Start::Speed(request.single("velocity")?);
    let chain = Chain::new(first, last, Inserted::Given(masses.collect()), request.coefficients()?, start)
        .map_err(|error| Fault::chain(field(&error), &error))?;
    let digits = Digits::Significant(1);
    Ok(Subject::Chain(Scene { want: Vec::new(), digits, rounding: Rounding::Nearest, inputs: chain.into() }))
}

fn balls(request: &Request) -> Result<Subject, Fault> {
    let masses = bodies(request.bodies("masses")?)?;
    let (floor, height) = (request.coefficient("floor")?, request.length("height")?);
    let drop = Drop::new(masses, request.coefficients()?, floor, height);
    Ok(Subject::Drop(drop.map_err(|error| Fault::chain(field(&error), &error))?, 1))
}

fn long<'a>(request: &'a Request, field: &'static str) -> Result<&'a str, Fault> {
    let text = request.long_text(field);
    if text.len() > MAX_BYTES {
        return Err(Fault::at(field, format!("limit reached: {MAX_BYTES} bytes")).limit());
    }
    Ok(text)
}

/// The width of a sketch, in the units of its strokes.
const SKETCH: f32 = 487.0;

/// A sheet for the page to show.
fn view(sheet: &Sheet) -> Value {
    let part = |part: &Part| match part {
        Part::Names => json!({ "kind": "names" }),
        Part::Heading(text) => json!({ "kind": "heading", "text": text }),
        Part::Text(text) => json!({ "kind": "text", "text": text }),
        Part::Sketch(sketch) => {
            let stroke = |stroke: Stroke| match stroke {
                Stroke::Line(points) => json!({ "points": points }),
                Stroke::Label(at, text, size) => json!({ "at": at, "text": text, "size": size }),
            };
            let strokes: Vec<Value> = sketch.strokes(SKETCH).into_iter().map(stroke).collect();
            json!({ "kind": "sketch", "size": [SKETCH, sketch.height()], "text": sketch.description(), "strokes": strokes })
        }
        Part::Choice { ask, options, .. } => json!({ "kind": "choice", "ask": ask, "options": options }),
        Part::Open { ask, answer, lines, .. } => {
            json!({ "kind": "open", "ask": ask, "answer": answer, "lines": lines })
        }
        Part::Table(table) => {
            let cell = |cell: &Cell| match cell {
                Cell::Number(text) => json!(text),
                Cell::Blank(_) => json!(""),
                Cell::Nothing => Value::Null,
            };
            let row = |row: &carom_documents::report::worksheet::Row| json!({ "name": row.name, "cells": row.cells.iter().map(cell).collect::<Vec<_>>() });
            let groups: Vec<Vec<Value>> = table.groups.iter().map(|group| group.iter().map(row).collect()).collect();
            json!({ "kind": "table", "title": table.title, "columns": table.columns, "groups": groups })
        }
    };
    json!({ "title": sheet.title, "foot": sheet.foot, "parts": sheet.parts.iter().map(part).collect::<Vec<_>>() })
}

/// Bytes in a JSON text.
fn base64(bytes: &[u8]) -> String {
    const SIGNS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let bits = (0..3).fold(0_u32, |bits, i| bits << 8 | u32::from(*three.get(i).unwrap_or(&0)));
        for place in 0..4 {
            let sign = char::from(SIGNS[(bits >> (18 - 6 * place) & 63) as usize]);
            out.push(if place <= three.len() { sign } else { '=' });
        }
    }
    out
}

/// Somebody's table beside the certified values: `{table, ratio, e, n, round}`.
pub fn check_table(request: &Request) -> Result<Value, Fault> {
    let text = long(request, "table")?;
    let given = Given {
        ratio: grid(request, "ratio")?,
        e: grid(request, "e")?,
        n: grid(request, "n")?,
        names: ["the field for the mass ratio", "the field for e", "the field for n"],
    };
    let name = request.text("round")?;
    let rounding = ROUNDINGS.iter().find(|r| r.0 == name).map_or(Rounding::Nearest, |r| r.1);
    let fault = |error: carom_physics::table::comparison::ComparisonError| Fault {
        limit: error.is_limit(),
        ..Fault::at("table", error.to_string())
    };
    let mut table = Comparison::open(text.as_bytes(), &given).map_err(fault)?;
    let (mut tally, mut cells) = (Tally::default(), Vec::new());
    while let Some(row) = table.row(rounding).map_err(fault)? {
        for cell in row {
            if cells.len() == MAX_CELLS {
                let help = "the command line judges tables of any length: carom table --check";
                return Err(Fault::at("table", format!("limit reached: {MAX_CELLS} cells")).limit().help(help));
            }
            tally.count(&cell);
            let shown: Vec<String> = comparison::entries(&cell).iter().map(|entry| entry.plain().to_owned()).collect();
            cells
                .push(json!({ "entries": shown, "mark": mark(cell.judgement.as_ref().map(|found| &found.agreement)) }));
        }
    }
    if tally.judged() == 0 {
        return Err(Fault::at("table", "there is no cell to check"));
    }
    let head = comparison::head(table.quantities(), rounding);
    Ok(json!({
        "columns": head.columns.iter().map(|column| &column.name).collect::<Vec<_>>(),
        "cells": cells,
        "summary": comparison::summary(&tally),
        "right": tally.right == tally.judged(),
    }))
}

fn mark(agreement: Option<&Agreement>) -> &'static str {
    match agreement {
        Some(Agreement::Right) => "right",
        Some(Agreement::Rounded(_)) => "rounded",
        Some(Agreement::Wrong(_)) => "wrong",
        Some(Agreement::Unreadable(_)) => "unreadable",
        None => "empty",
    }
}

/// A value for all rows; `None` where the field is empty.
fn grid(request: &Request, field: &'static str) -> Result<Option<Grid>, Fault> {
    let plain = request.number(field)?;
    if plain.is_empty() {
        return Ok(None);
    }
    Grid::parse(&plain).map(Some).map_err(|error| {
        let message = match &error {
            GridError::Numeral { part, error } => numeral(part, error),
            error => error.to_string(),
        };
        Fault { limit: error.is_limit(), ..Fault::at(field, message) }
    })
}

/// The restitution that measured bounces allow: `{readings, kind, within, digits}`. Readings stand one a line, two a line for
/// `pairs`; a blank line begins another ball. A text with a heading is a table.
pub fn restitution(request: &Request) -> Result<Value, Fault> {
    let text = long(request, "readings")?;
    let digits = few(request, "digits", MAX_DIGITS)?;
    let within = within(request)?;
    let fault = |error: MeasurementError| {
        let field = if matches!(error, MeasurementError::Within { .. }) { "within" } else { "readings" };
        let message = match &error {
            MeasurementError::Reading { line, .. } => format!("reading {line}: {error}"),
            error => error.to_string(),
        };
        Fault { limit: error.is_limit(), ..Fault::at(field, message) }
    };
    let is_table = text.lines().find(|line| !line.trim().is_empty()).is_some_and(|line| {
        let word = line.trim_start_matches(['\u{feff}', ' ', '"', '#']);
        word.starts_with(|c: char| c.is_alphabetic())
    });
    let found = if is_table {
        Measurements::read(text.as_bytes(), within.as_deref())
    } else {
        let (kind, runs) = lists(request, text)?;
        Measurements::of_lists(kind, &runs, within.as_deref())
    }
    .map_err(fault)?;
    let estimate = found.estimate().map_err(fault)?;
    let limit = |error| Fault::chain(Some("digits"), &ChainError::Number(error));
    let said = bounces::text(&found, &estimate, digits).map_err(limit)?;
    let json = bounces::json(&found, &estimate, digits).map_err(limit)?;
    Ok(json!({
        "consistent": matches!(estimate, Estimate::Consistent(..)),
        "said": said.lines().collect::<Vec<_>>(),
        "bounds": serde_json::from_str::<Value>(&json).unwrap_or_default(),
    }))
}

/// The uncertainty that all readings share; of a percentage the sign stays, since it is relative.
fn within(request: &Request) -> Result<Option<String>, Fault> {
    let text = request.text("within")?;
    if text.is_empty() {
        return Ok(None);
    }
    let (number, percent) = text.strip_suffix('%').map_or((text, ""), |number| (number.trim_end(), " %"));
    let plain = typed::number(number).map_err(|unclear| Fault::unclear("within", unclear))?;
    Ok(Some(format!("{plain}{percent}")))
}

fn lists(request: &Request, text: &str) -> Result<(Kind, Vec<Vec<String>>), Fault> {
    let kind = request.text("kind")?;
    let number = |line: usize, part: &str| {
        typed::number(part).map_err(|unclear| Fault {
            message: format!("line {line}: {}", unclear.0),
            ..Fault::unclear("readings", unclear)
        })
    };
    let mut runs: Vec<Vec<String>> = vec![Vec::new()];
    for (line, row) in (1..).zip(text.lines()) {
        let row = row.trim();
        if kind == "pairs" {
            let parts: Vec<&str> = row.split([';', '\t']).map(str::trim).filter(|part| !part.is_empty()).collect();
            match parts.as_slice() {
                [] => {}
                [fall, bounce] => runs.push(vec![number(line, fall)?, number(line, bounce)?]),
                _ => {
                    let message = format!("line {line}: two heights are needed, as in 1.20; 0.86");
                    return Err(Fault::at("readings", message));
                }
            }
        } else if row.is_empty() {
            runs.push(Vec::new());
        } else if let Some(run) = runs.last_mut() {
            run.push(number(line, row)?);
        }
    }
    runs.retain(|run| !run.is_empty());
    if runs.is_empty() {
        return Err(Fault::at("readings", "readings are missing: write one a line"));
    }
    Ok((if kind == "times" { Kind::Times } else { Kind::Heights }, runs))
}

#[cfg(test)]
mod tests {
    use super::base64;
    use serde_json::{Value, json};

    fn ask(call: fn(&str) -> String, changes: &[(&str, &str)], request: &Value) -> Value {
        let mut request = request.clone();
        for (field, text) in changes {
            request[*field] = json!(text);
        }
        serde_json::from_str(&call(&request.to_string())).expect("JSON")
    }

    fn worksheet(changes: &[(&str, &str)]) -> Value {
        let request = json!({"kind": "chain", "masses": "2, 1, 0,5", "e": "1/2", "velocity": "3", "digits": "4", "versions": "0",
            "seed": "1", "mass_unit": "kg", "velocity_unit": "m/s", "floor": "1"});
        ask(crate::worksheet, changes, &request)
    }

    fn restitution(changes: &[(&str, &str)]) -> Value {
        let request = json!({"kind": "heights", "readings": "1.20\n0.77\n0.49\n0.31", "within": "0.01", "digits": "4"});
        ask(crate::restitution, changes, &request)
    }

    fn check(changes: &[(&str, &str)]) -> Value {
        let request =
            json!({"table": "ratio;e;n;eta\n64;0,9;2;0,1927\n64;0,9;2;0,1937\n64;0,9;2;\n", "round": "nearest"});
        ask(crate::check_table, changes, &request)
    }

    #[test]
    fn sheets_have_a_key_with_the_numbers_of_the_chain() {
        let found = worksheet(&[("masses", "2; 1; 0,5")]);
        let sheets = found["sheets"].as_array().expect("sheets");
        assert_eq!(sheets.len(), 2, "{found}");
        assert_eq!(sheets[0]["title"], "Carts in a row: worksheet");
        // v1' = (m1 - e m2)/(m1 + m2) v1 = 3/2.
        let table = |sheet: &Value| {
            sheet["parts"].as_array().and_then(|parts| {
                parts
                    .iter()
                    .find(|p| p["kind"] == "table" && p["title"].as_str().is_some_and(|t| t.contains("Collision 1")))
                    .cloned()
            })
        };
        let after = |sheet: &Value| table(sheet).expect("a table")["groups"][1][1]["cells"][0].clone();
        assert_eq!((after(&sheets[0]), after(&sheets[1])), (json!(""), json!("1.500")), "{found}");
    }

    #[test]
    fn versions_come_from_their_seed_and_every_form_is_written() {
        let all =
            |seed: &str| worksheet(&[("masses", "2; 1; 0,5"), ("versions", "3"), ("seed", seed)])["sheets"].clone();
        assert_eq!(all("7").as_array().map(Vec::len), Some(6));
        assert_eq!((all("7") == all("7"), all("7") == all("8")), (true, false));
        for (form, sign) in [("html", "<!DOCTYPE html>"), ("latex", "\\documentclass"), ("markdown", "| ")] {
            let found = worksheet(&[("masses", "2; 1"), ("format", form)]);
            assert!(found["text"].as_str().is_some_and(|text| text.contains(sign)), "{form}: {found}");
        }
        let pdf = worksheet(&[("masses", "2; 1"), ("format", "pdf")]);
        assert!(pdf["base64"].as_str().is_some_and(|text| text.starts_with("JVBERi0")), "%PDF-");
        assert_eq!(base64(b"Man"), "TWFu");
        assert_eq!((base64(b"Ma"), base64(b"M"), base64(b"")), ("TWE=".to_owned(), "TQ==".to_owned(), String::new()));
    }

    #[test]
    fn faults_of_a_sheet_name_their_field() {
        for (field, changes) in [
            ("masses", &[("masses", "2")][..]),
            ("masses", &[("masses", "2; x")]),
            ("masses", &[("masses", "1; 0")]),
            ("e", &[("masses", "2; 1"), ("e", "2")]),
            ("e", &[("masses", "2; 1"), ("e", "1, 1")]),
            ("velocity", &[("masses", "2; 1"), ("velocity", "0")]),
            ("velocity", &[("masses", "2; 1"), ("velocity", "")]),
            ("versions", &[("masses", "2; 1"), ("versions", "27")]),
            ("seed", &[("masses", "2; 1"), ("seed", "x")]),
            ("digits", &[("masses", "2; 1"), ("digits", "0")]),
            ("mass_unit", &[("masses", "2; 1"), ("mass_unit", "3 kg")]),
            ("floor", &[("kind", "drop"), ("masses", "2; 1"), ("floor", "")]),
            ("height", &[("kind", "drop"), ("masses", "2; 1"), ("height", "-1")]),
            ("kind", &[("kind", "pendulum")]),
        ] {
            assert_eq!(worksheet(changes)["error"]["field"], field, "{changes:?}: {}", worksheet(changes));
        }
        assert_eq!(worksheet(&[("masses", &"1; ".repeat(30))])["error"]["limit"], json!(false), "an empty element");
        assert_eq!(worksheet(&[("masses", &format!("{}1", "1; ".repeat(30)))])["error"]["limit"], true);
    }

    #[test]
    fn dropped_balls_make_sheets_too() {
        let drop = worksheet(&[
            ("kind", "drop"),
            ("masses", "620 ± 2; 57,7(1)"),
            ("floor", "0.76"),
            ("height", "1.2"),
            ("height_unit", "m"),
        ]);
        assert!(drop["sheets"][1].to_string().contains('±'), "{drop}");
    }

    #[test]
    fn a_table_is_judged_cell_by_cell() {
        let found = check(&[]);
        let marks: Vec<&Value> = found["cells"].as_array().expect("cells").iter().map(|cell| &cell["mark"]).collect();
        assert_eq!(marks, ["right", "wrong", "empty"]);
        assert_eq!(found["right"], false);
        assert!(found["summary"].as_str().is_some_and(|text| text.starts_with("2 cells: 1 right")), "{found}");
        let fixed = check(&[("table", "eta\n0.1927\n"), ("ratio", "64"), ("e", "0,9"), ("n", "2")]);
        assert_eq!(fixed["right"], true, "{fixed}");
        for (field, changes) in [
            ("table", &[("table", "")][..]),
            ("table", &[("table", "eta\n0.5\n")]),
            ("table", &[("e", "0.5")]),
            ("ratio", &[("table", "e,n,eta\n1,1,1\n"), ("ratio", "x")]),
        ] {
            assert_eq!(check(changes)["error"]["field"], field, "{changes:?}");
        }
    }

    #[test]
    fn readings_give_e_or_those_that_exclude_each_other() {
        let found = restitution(&[]);
        assert_eq!((&found["consistent"], &found["said"][0]), (&json!(true), &json!("e = 0.799 ± 0.006")));
        // As a class types it, and as a file.
        assert_eq!(restitution(&[("readings", "1,20\n0,77\n0,49\n0,31"), ("within", "0,01")])["said"], found["said"]);
        let file = restitution(&[("readings", "height\n1.20\n0.77\n0.49\n0.31\n")]);
        assert_eq!(file["said"][0], found["said"][0]);
        let pairs = restitution(&[("kind", "pairs"), ("readings", "1,00; 0,64\n1,00; 0,49")]);
        assert_eq!(pairs["consistent"], false, "{pairs}");
        assert!(pairs["said"][1].as_str().is_some_and(|said| said.contains("1.00")), "{pairs}");
        // Two per cent of each reading, and not two hundredths.
        let relative = restitution(&[("readings", "100\n50"), ("within", "2 %")]);
        assert!(relative["said"][1].as_str().is_some_and(|said| said.contains("from 0.6931 to 0.7214")), "{relative}");
        for (field, changes) in [
            ("readings", &[("readings", "")][..]),
            ("readings", &[("readings", "1.0\nx")]),
            ("readings", &[("readings", "1.0\n-0.5")]),
            ("readings", &[("readings", "1.0")]),
            ("readings", &[("readings", "1,000\n0.5")]),
            ("readings", &[("kind", "pairs"), ("readings", "1.0")]),
            ("within", &[("within", "x")]),
            ("digits", &[("digits", "0")]),
        ] {
            assert_eq!(restitution(changes)["error"]["field"], field, "{changes:?}: {}", restitution(changes));
        }
    }
}
