//! `carom table --check`: somebody's table beside the certified values.

use super::output::Output;
use super::progress::Progress;
use super::{Exit, load, print};
use crate::chain::{ChainError, MAX_INSERTED, Positive, Restitution};
use crate::number::NumberError;
use crate::number::decimal::Rounding;
use crate::number::rational;
use crate::report::counted;
use crate::report::table::{Column, Entry, Form, Head, LATEX_ROWS, Writer};
use crate::table::check::{Agreement, judge, judge_count};
use crate::table::foreign::{Fields, Foreign, ForeignError, Role, completed};
use crate::table::grid::{Grid, beyond_limits};
use crate::table::{Place, Quantity, Value, value};
use malachite::Rational;
use std::io::{BufReader, Write};
use std::path::Path;

/// What the command line gives for columns that the file does not have: one value each.
pub struct Given {
    /// The mass ratio.
    pub ratio: Option<Grid>,
    /// The restitution.
    pub e: Option<Grid>,
    /// The number of inserted bodies.
    pub n: Option<Grid>,
}

/// Counts of cells.
#[derive(Default)]
struct Tally {
    right: usize,
    rounded: usize,
    wrong: usize,
    unreadable: usize,
    empty: usize,
}

/// Runs the check.
pub fn run(path: &Path, given: &Given, rounding: Rounding, form: Form, output: Option<&Path>) -> Result<u8, Exit> {
    let shown = path.display();
    let fail = |e: &dyn std::fmt::Display| Exit::usage(format!("error: {shown}: {e}"));
    let file = load::open(path).map_err(|e| Exit::usage(format!("error: cannot read {shown}: {e}")))?;
    let foreign =
        |e: ForeignError| Exit { code: if e.is_limit() { 3 } else { 2 }, message: format!("error: {shown}: {e}") };
    let mut table = Foreign::open(BufReader::new(file)).map_err(foreign)?;
    let places = Places::of(&table, given).map_err(|e| fail(&e))?;
    let mut out: Vec<u8> = Vec::new();
    let mut writer = Writer::new(form, head(&places, rounding));
    let (mut tally, mut rows) = (Tally::default(), 0);
    let mut target = output.map(Output::file).transpose()?;
    let mut flush = |out: &mut Vec<u8>| -> Result<(), Exit> {
        match &mut target {
            Some(file) => {
                file.write_all(out).map_err(|e| Exit::usage(format!("error: cannot write the report: {e}")))?;
            }
            None => print(&String::from_utf8_lossy(out))?,
        }
        out.clear();
        Ok(())
    };
    let unwritten = |e: std::io::Error| Exit::usage(format!("error: cannot write: {e}"));
    writer.begin(&mut out).map_err(unwritten)?;
    let progress = output.is_some().then(|| Progress::alone("comparing"));
    while let Some(row) = table.row().map_err(foreign)? {
        if let Some(progress) = progress.as_ref().filter(|_| rows % 256 == 0) {
            progress.now(0, &format!("{rows} cells compared"));
        }
        for (column, quantity) in &places.values {
            let entries = cell(&row, *column, *quantity, &places, rounding, &mut tally).map_err(|e| match e {
                Failure::Input(e) => fail(&format!("line {}: {e}", row.line)),
                Failure::Limit(e) => Exit { code: 3, message: format!("error: {shown}: line {}: {e}", row.line) },
            })?;
            // JSON writes control characters by their numbers itself.
            let entries = if form == Form::Json { entries } else { entries.into_iter().map(Entry::visible).collect() };
            writer.row(entries, &mut out).map_err(unwritten)?;
            rows += 1;
            if form == Form::Latex && rows > LATEX_ROWS {
                let message = format!("error: limit reached: rows of a table in LaTeX: {LATEX_ROWS} allowed");
                return Err(Exit { code: 3, message });
            }
        }
        if out.len() > 1 << 16 {
            flush(&mut out)?;
        }
    }
    drop(progress);
    writer.end(&mut out).map_err(unwritten)?;
    let cells = tally.right + tally.rounded + tally.wrong + tally.unreadable;
    let summary = tally.summary(cells);
    if form == Form::Text {
        writeln!(out, "\n{summary}").map_err(unwritten)?;
    }
    flush(&mut out)?;
    if form != Form::Text || output.is_some() {
        // The last line of a report for machines must stay machine-readable.
        let _ = writeln!(anstream::stderr(), "{summary}");
    }
    if cells == 0 {
        return Err(fail(&"there is no cell to check"));
    }
    if let Some(file) = target {
        file.finish()?;
    }
    Ok(u8::from(tally.right < cells))
}

fn head(places: &Places, rounding: Rounding) -> Head {
    let mut facts: Vec<(&'static str, String)> =
        places.values.iter().map(|(_, quantity)| ("formula", quantity.formula().to_owned())).collect();
    facts.push(("rounding", format!("to as many places as are written, {}", rounding.rule())));
    facts.push(("program", format!("carom {}", env!("CARGO_PKG_VERSION"))));
    let numbers = [("line", "\\mathrm{line}"), ("ratio", "m_1/m_2"), ("e", "e"), ("n", "n")];
    let mut columns: Vec<Column> = numbers.iter().map(|(name, latex)| Column::number(name, latex)).collect();
    columns.push(Column::words("quantity"));
    columns.push(Column { numeric: true, ..Column::words("written") });
    columns.push(Column { numeric: true, ..Column::words("certified") });
    columns.push(Column::words("judgement"));
    Head { facts, latex: String::new(), columns }
}

/// Where a value of an axis comes from.
enum From {
    /// A column.
    Column(usize),
    /// Two columns, divided.
    Quotient(usize, usize),
    /// The command line.
    Fixed(Rational),
    /// Nowhere.
    Nowhere,
}

/// Where everything comes from.
struct Places {
    ratio: From,
    e: From,
    n: From,
    values: Vec<(usize, Quantity)>,
}

impl Places {
    fn of<R: std::io::BufRead>(table: &Foreign<R>, given: &Given) -> Result<Places, String> {
        let values: Vec<(usize, Quantity)> = table
            .roles
            .iter()
            .filter_map(|(column, role)| match role {
                Role::Value(quantity) => Some((*column, *quantity)),
                _ => None,
            })
            .collect();
        if values.is_empty() {
            return Err("no column to check: name one of them eta, threshold or best-n".to_owned());
        }
        let from = |role: Role, flag: &str, grid: &Option<Grid>| -> Result<From, String> {
            match (table.column(role), grid) {
                (Some(_), Some(_)) => Err(format!("{flag} is given twice: in the file and on the command line")),
                (Some(column), None) => Ok(From::Column(column)),
                (None, Some(grid)) if grid.len() == 1 => Ok(grid.value(0).map_or(From::Nowhere, From::Fixed)),
                (None, Some(_)) => Err(format!("with --check, {flag} takes one value")),
                (None, None) => Ok(From::Nowhere),
            }
        };
        let mut ratio = from(Role::Ratio, "--ratio", &given.ratio)?;
        if let (Some(first), Some(last)) = (table.column(Role::First), table.column(Role::Last)) {
            if !matches!(ratio, From::Nowhere) {
                let other = if given.ratio.is_some() { "by --ratio" } else { "in a column of its own" };
                return Err(format!("the mass ratio is given twice: by the columns m1 and m2, and {other}"));
            }
            ratio = From::Quotient(first, last);
        }
        let (e, n) = (from(Role::E, "-e", &given.e)?, from(Role::N, "-n", &given.n)?);
        let lacks = |from: &From, needed: bool| needed && matches!(from, From::Nowhere);
        let needs_e = values.iter().any(|v| v.1.needs_e());
        let needs_n = values.iter().any(|v| v.1.needs_n());
        for (lacking, column, flag) in [
            (lacks(&ratio, true), "ratio", "--ratio"),
            (lacks(&e, needs_e), "e", "-e"),
            (lacks(&n, needs_n), "n", "-n"),
        ] {
            if lacking {
                return Err(format!("there is no column {column}: add one, or give the value with {flag}"));
            }
        }
        Ok(Places { ratio, e, n, values })
    }
}

/// Why a cell cannot be judged.
enum Failure {
    Input(String),
    Limit(String),
}

fn number(from: &From, row: &Fields) -> Result<Option<Rational>, Failure> {
    let at = |column: usize| {
        let text = row.fields.get(column).map_or("", String::as_str);
        rational::parse(&completed(text)).map_err(|e| match beyond_limits(&e) {
            Some(limit) => Failure::Limit(limit.to_string()),
            None => Failure::Input(format!("{text:?} is no number: {e}")),
        })
    };
    Ok(match from {
        From::Column(column) => Some(at(*column)?),
        From::Quotient(first, last) => {
            let last = at(*last)?;
            if last == 0u32 {
                return Err(Failure::Input("m2 is 0; a mass is above 0".to_owned()));
            }
            Some(at(*first)? / last)
        }
        From::Fixed(value) => Some(value.clone()),
        From::Nowhere => None,
    })
}

/// One cell judged.
fn cell(
    row: &Fields,
    column: usize,
    quantity: Quantity,
    places: &Places,
    rounding: Rounding,
    tally: &mut Tally,
) -> Result<Vec<Entry>, Failure> {
    let input = |e: &dyn std::fmt::Display| Failure::Input(e.to_string());
    let (ratio, e, n) = (number(&places.ratio, row)?, number(&places.e, row)?, number(&places.n, row)?);
    let count = match &n {
        Some(n) if quantity.needs_n() => match u64::try_from(n) {
            Ok(n) => Some(n),
            Err(_) if *n > MAX_INSERTED && *n.denominator_ref() == 1u32 => {
                let what = format!("limit reached: inserted bodies: {MAX_INSERTED} allowed, {n} asked for");
                return Err(Failure::Limit(what));
            }
            Err(_) => return Err(input(&format!("n counts bodies, {n} does not"))),
        },
        _ => None,
    };
    let place = Place {
        ratio: Positive::new(ratio.clone().unwrap_or_default()).map_err(|e| input(&e))?,
        e: match &e {
            Some(e) if quantity.needs_e() => Some(Restitution::new(e.clone()).map_err(|e| input(&e))?),
            _ => None,
        },
        n: count,
    };
    let written = row.fields.get(column).map_or("", String::as_str);
    let number = |e: NumberError| match e {
        NumberError::LimitReached { .. } => Failure::Limit(e.to_string()),
        NumberError::Undefined { .. } => Failure::Input(e.to_string()),
    };
    let chain = |e: ChainError| match e {
        ChainError::Number(e) => number(e),
        e => Failure::Input(e.to_string()),
    };
    let (said, certified) = match value(quantity, &place).map_err(chain)? {
        _ if written.is_empty() => ("empty".to_owned(), String::new()),
        Value::Count(best) => {
            let certified = crate::table::count_text(&best).0;
            let agreement = judge_count(written, &certified).map_err(number)?;
            tally.count(&agreement);
            (agreement.text(), certified)
        }
        Value::Real(real) => {
            let (agreement, certified) = judge(written, &real, rounding).map_err(number)?;
            tally.count(&agreement);
            (agreement.text(), certified)
        }
    };
    tally.empty += usize::from(written.is_empty());
    let entry = |value: &Option<Rational>| {
        value.as_ref().map_or(Entry::Empty, |v| Entry::Plain(crate::table::grid::decimal_or_fraction(v)))
    };
    let plain = |text: String| Entry::Plain(text);
    Ok(vec![
        plain(row.line.to_string()),
        entry(&ratio),
        if quantity.needs_e() { entry(&e) } else { Entry::Empty },
        if quantity.needs_n() { entry(&n) } else { Entry::Empty },
        plain(quantity.name().to_owned()),
        plain(written.to_owned()),
        plain(certified),
        plain(said),
    ])
}

impl Tally {
    fn count(&mut self, agreement: &Agreement) {
        match agreement {
            Agreement::Right => self.right += 1,
            Agreement::Rounded(_) => self.rounded += 1,
            Agreement::Wrong(_) => self.wrong += 1,
            Agreement::Unreadable(_) => self.unreadable += 1,
        }
    }

    /// The last line of a report.
    fn summary(&self, cells: usize) -> String {
        let mut out = format!(
            "{}: {} right, {} not rounded as asked, {} wrong",
            counted(cells, "cell"),
            self.right,
            self.rounded,
            self.wrong,
        );
        for (count, what) in [(self.unreadable, "unreadable"), (self.empty, "empty")] {
            if count > 0 {
                out += &format!("; {count} {what}");
            }
        }
        out
    }
}
