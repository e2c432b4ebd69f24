//! `carom restitution`: the coefficient of restitution from heights or times that a class has measured.

use super::form::form;
use super::{Exit, ValueFormat, deliver, load};
use crate::chain::bounces::{Bound, Estimate, Kind, Pair, restitution};
use crate::chain::uncertain::Range;
use crate::chain::{ChainError, Positive};
use crate::number::NumberError;
use crate::number::decimal::Rounding;
use crate::number::plus_minus::plus_minus;
use crate::number::rational::parse;
use crate::report::counted;
use crate::table::foreign::{Foreign, ForeignError, completed};
use malachite::Rational;
use serde_json::json;
use std::path::PathBuf;

/// The most bytes of a file of measurements.
const MAX_BYTES: usize = 16 << 20;

/// The arguments.
#[derive(clap::Args)]
pub struct Flags {
    /// A CSV file, or - for standard input. One column `height` or `time` has the readings of one ball, bounce after bounce;
    /// a column `run` tells several balls or tries apart. Two columns `drop` and `bounce` have one bounce a row
    file: PathBuf,
    /// The uncertainty of readings that have none of their own: 0.01, or 2 %
    #[arg(long, value_name = "U")]
    within: Option<String>,
    /// Significant digits of the bounds
    #[arg(long, value_name = "D", default_value_t = 4, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    digits: u64,
    /// The form of the answer [default: by the ending of --output (.json), else text]
    #[arg(long, value_enum)]
    format: Option<ValueFormat>,
    /// Write the answer to a file, - for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// A reading as it was written, with its line.
struct Reading {
    line: u64,
    text: String,
}

/// Measurements, and where each comes from.
struct Measurements {
    kind: Kind,
    runs: Vec<Vec<Range<Positive>>>,
    places: Vec<Vec<Reading>>,
}

/// Runs the command: 0 for measurements that one coefficient explains, 1 for those that none does.
pub fn run(flags: &Flags) -> Result<u8, Exit> {
    let found = read(flags)?;
    let estimate = restitution(&found.runs, found.kind).map_err(|e| {
        let limit = matches!(e, ChainError::Number(NumberError::LimitReached { .. }));
        Exit { code: if limit { 3 } else { 2 }, message: format!("error: {}: {e}", flags.file.display()) }
    })?;
    let shown = match form(flags.format, flags.output.as_deref())? {
        ValueFormat::Text => text(&found, &estimate, flags.digits),
        ValueFormat::Json => json(&found, &estimate, flags.digits),
    };
    let shown = shown.map_err(|e| Exit { code: 3, message: format!("error: --digits: {e}") })?;
    deliver(flags.output.as_deref(), &shown)?;
    Ok(u8::from(matches!(estimate, Estimate::Contradiction(..))))
}

/// Which columns hold what.
enum Columns {
    /// Readings, and the run of each where that is told.
    Readings(Kind, usize, Option<usize>),
    /// The height of the fall, and of the bounce.
    Bounce(usize, usize),
}

fn columns(names: &[String]) -> Result<Columns, String> {
    let place = |wanted: &[&str]| names.iter().position(|name| wanted.contains(&name.to_lowercase().as_str()));
    let (drop, bounce) = (place(&["drop", "fall", "from"]), place(&["bounce", "rebound", "to"]));
    if let (Some(drop), Some(bounce)) = (drop, bounce) {
        return Ok(Columns::Bounce(drop, bounce));
    }
    let run = place(&["run", "ball", "try"]);
    match (place(&["height", "heights", "h"]), place(&["time", "times", "t"])) {
        (Some(height), None) => Ok(Columns::Readings(Kind::Heights, height, run)),
        (None, Some(time)) => Ok(Columns::Readings(Kind::Times, time, run)),
        (Some(_), Some(_)) => Err("the file has heights and times; keep one of the two columns".to_owned()),
        (None, None) => {
            Err(format!("no column is called height, time, or drop and bounce; there are {}", names.join(", ")))
        }
    }
}

fn read(flags: &Flags) -> Result<Measurements, Exit> {
    let path = &flags.file;
    let shown = path.display();
    let bytes = load::bounded(path, MAX_BYTES).map_err(|e| load::cannot_read(path, &e))?;
    if bytes.len() > MAX_BYTES {
        return Err(Exit { code: 3, message: format!("error: {shown}: limit reached: {MAX_BYTES} bytes in a file") });
    }
    let foreign = |e: ForeignError| {
        let said = match &e {
            ForeignError::Empty => "the file has no heading; write for instance: height".to_owned(),
            other => other.to_string(),
        };
        Exit { code: if e.is_limit() { 3 } else { 2 }, message: format!("error: {shown}: {said}") }
    };
    if let Some(within) = &flags.within {
        Range::read(&format!("1 ± {within}"))
            .map_err(|e| Exit::usage(format!("error: --within {within}: {e}; write for instance 0.01 or \"2 %\"")))?;
    }
    let mut table = Foreign::open(bytes.as_slice()).map_err(foreign)?;
    let columns = columns(&table.names).map_err(|e| Exit::usage(format!("error: {shown}: {e}")))?;
    let kind = if let Columns::Readings(kind, ..) = columns { kind } else { Kind::Heights };
    let mut found = Measurements { kind, runs: Vec::new(), places: Vec::new() };
    let mut names: Vec<String> = Vec::new();
    while let Some(row) = table.row().map_err(foreign)? {
        let line = row.line;
        let reading = |place: usize| -> Result<(Range<Positive>, Reading), Exit> {
            let text = row.fields.get(place).map_or("", String::as_str);
            let range = measured(text, flags.within.as_deref())
                .map_err(|e| Exit::usage(format!("error: {shown}:{line}: {text:?}: {e}")))?;
            Ok((range, Reading { line, text: text.to_owned() }))
        };
        match columns {
            Columns::Bounce(drop, bounce) => {
                let (before, after) = (reading(drop)?, reading(bounce)?);
                found.runs.push(vec![before.0, after.0]);
                found.places.push(vec![before.1, after.1]);
            }
            Columns::Readings(_, place, run) => {
                let name = run.and_then(|run| row.fields.get(run)).cloned().unwrap_or_default();
                let at = names.iter().position(|known| *known == name).unwrap_or_else(|| {
                    names.push(name);
                    found.runs.push(Vec::new());
                    found.places.push(Vec::new());
                    names.len() - 1
                });
                let (range, place) = reading(place)?;
                found.runs[at].push(range);
                found.places[at].push(place);
            }
        }
    }
    Ok(found)
}

/// A reading, with the uncertainty of its own or the one that all share.
fn measured(text: &str, within: Option<&str>) -> Result<Range<Positive>, String> {
    let own = ["±", "+-", "+/-", "(", "["].iter().any(|sign| text.contains(sign));
    let text = completed(text);
    let whole = match within {
        Some(within) if !own => format!("{text} ± {within}"),
        _ => text.into_owned(),
    };
    let range = Range::read(&whole).map_err(|e| e.to_string())?;
    range.map(Positive::new).map_err(|_| "a reading must be above 0, for every value within its uncertainty".to_owned())
}

impl Measurements {
    /// `lines 2 and 3 (1.20, 0.86)`, and nothing for the bound 1 itself.
    fn named(&self, pair: Option<Pair>) -> String {
        let Some(Pair { run, earlier, later }) = pair else { return "no coefficient exceeds 1".to_owned() };
        let at = |place: usize| self.places.get(run).and_then(|run| run.get(place));
        match (at(earlier), at(later)) {
            (Some(a), Some(b)) if a.line == b.line => format!("line {} ({} and {})", a.line, a.text, b.text),
            (Some(a), Some(b)) => format!("lines {} and {} ({} and {})", a.line, b.line, a.text, b.text),
            _ => String::new(),
        }
    }

    fn lines(&self, pair: Option<Pair>) -> Option<[u64; 2]> {
        let Pair { run, earlier, later } = pair?;
        let run = self.places.get(run)?;
        Some([run.get(earlier)?.line, run.get(later)?.line])
    }
}

fn rounded(bound: &Bound, digits: u64, rounding: Rounding) -> Result<String, NumberError> {
    Ok(bound.decimal(digits, rounding)?.to_string())
}

fn text(found: &Measurements, estimate: &Estimate, digits: u64) -> Result<String, NumberError> {
    let count = counted(found.runs.iter().map(Vec::len).sum(), "reading");
    let mut out = String::new();
    match estimate {
        Estimate::Consistent(lower, upper) => {
            let (low, high) = (rounded(lower, digits, Rounding::Down)?, rounded(upper, digits, Rounding::Up)?);
            let ends: [Option<Rational>; 2] = [&low, &high].map(|end| parse(end).ok());
            let about = if let [Some(lo), Some(hi)] = &ends { plus_minus(lo, hi) } else { None };
            out.push_str(&format!("e = {}\n", about.unwrap_or_else(|| low.clone())));
            out.push_str(&format!("consistent with one e: {count}, e from {low} to {high}\n"));
            out.push_str(&format!("at least {low}: {}\n", found.named(lower.from)));
            out.push_str(&format!("at most {high}: {}\n", found.named(upper.from)));
        }
        Estimate::Contradiction(lower, upper) => {
            // Rounded towards each other they might seem to agree: more digits, until they do not.
            let mut digits = digits;
            let (low, high) = loop {
                let (low, high) = (lower.decimal(digits, Rounding::Down)?, upper.decimal(digits, Rounding::Up)?);
                if low.value() > high.value() {
                    break (low.to_string(), high.to_string());
                }
                digits = digits.saturating_mul(2);
            };
            out.push_str(&format!("no e fits {count}\n"));
            out.push_str(&format!("{}: e is at least {low}\n", found.named(lower.from)));
            out.push_str(&format!("{}: e is at most {high}\n", found.named(upper.from)));
            out.push_str("a reading is wrong, an uncertainty is too small, or e was not the same each time\n");
        }
    }
    Ok(out)
}

fn json(found: &Measurements, estimate: &Estimate, digits: u64) -> Result<String, NumberError> {
    let bound = |bound: &Bound, rounding| {
        Ok::<_, NumberError>(json!({
            "decimal": rounded(bound, digits, rounding)?,
            "root": { "of": bound.quotient.to_string(), "index": bound.index },
            "lines": found.lines(bound.from),
        }))
    };
    let (consistent, lower, upper) = match estimate {
        Estimate::Consistent(lower, upper) => (true, lower, upper),
        Estimate::Contradiction(lower, upper) => (false, lower, upper),
    };
    let value = json!({
        "consistent": consistent,
        "at_least": bound(lower, Rounding::Down)?,
        "at_most": bound(upper, Rounding::Up)?,
        "readings": found.runs.iter().map(Vec::len).sum::<usize>(),
    });
    Ok(serde_json::to_string_pretty(&value).unwrap_or_default() + "\n")
}
