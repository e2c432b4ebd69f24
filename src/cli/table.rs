//! `carom table`

use super::interrupt::interrupted;
use super::output::{Output, place};
use super::partial::{self, Partial, Target};
use super::table_contents::{Contents, grid, joined};
use super::table_cross::{self, Axis};
use super::table_rows::{self, Rows};
use super::table_write::{End, Stop, write};
use super::{Exit, form, table_check};
use crate::number::decimal::{Digits, Rounding};
use crate::report::table::{Entry, Form, Head, LATEX_ROWS, Writer, entries};
use crate::table::comparison::Given;
use crate::table::grid::{Grid, Shape};
use crate::table::shared::Factors;
use crate::table::{Plan, Quantity, TableError};
use clap::ValueEnum;
use clap::builder::PossibleValue;
use serde_json::json;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Flags {
    #[command(flatten)]
    contents: Contents,
    /// The form of the table [default: by the ending of --output (.csv, .json, .md, .tex), else text]
    #[arg(long, value_enum)]
    format: Option<Written>,
    /// Write the table to a file, - for standard output. An interrupted run with CSV leaves its rows in FILE.partial, which
    /// no later run overwrites
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Print a cross table: the columns are the values of this axis, the rows those of another. A table too wide for a page
    /// is split; a third axis makes one table for each of its values
    #[arg(long, value_enum, value_name = "AXIS", conflicts_with_all = ["certificate", "resume", "check", "extra"])]
    across: Option<Axis>,
    /// In a cross table, write rational values as short fractions p/q
    #[arg(long, requires = "across")]
    fractions: bool,
    /// Leave out the column of exact values
    #[arg(long, conflicts_with_all = ["resume", "check", "across"])]
    no_exact: bool,
    /// Write the exact enclosure of every cell to a file, one JSON object a line; `carom check FILE` checks it
    #[arg(long, value_name = "FILE", conflicts_with = "check")]
    certificate: Option<PathBuf>,
    /// Continue an interrupted run from FILE.partial
    #[arg(long, requires = "output", conflicts_with = "check")]
    resume: bool,
    /// Compare every cell of somebody else's table (CSV, - for standard input) with the certified value; exit 1 if a cell
    /// is wrong. A threshold for n = 0 does not exist: there nothing, or none, is right
    #[arg(long, value_name = "FILE.csv")]
    check: Option<PathBuf>,
}

/// The form of a table, as a value of `--format`.
#[derive(Clone, Copy)]
struct Written(Form);

impl ValueEnum for Written {
    fn value_variants<'a>() -> &'a [Self] {
        const {
            &[
                Self(Form::Text),
                Self(Form::Csv),
                Self(Form::Spreadsheet),
                Self(Form::SpreadsheetComma),
                Self(Form::Json),
                Self(Form::Markdown),
                Self(Form::Latex),
            ]
        }
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, help) = match self.0 {
            Form::Text => ("text", "Aligned columns"),
            Form::Csv => ("csv", "Comma-separated values after comment lines"),
            Form::Spreadsheet => (
                "spreadsheet",
                "CSV for Excel and LibreOffice: no comment lines, and no fractions that they would read as dates",
            ),
            Form::SpreadsheetComma => ("spreadsheet-comma", "The same with semicolons and decimal commas"),
            Form::Json => ("json", "One object with the rows in a list"),
            Form::Markdown => ("markdown", "A table of Markdown"),
            Form::Latex => ("latex", "A table for booktabs and siunitx"),
        };
        Some(PossibleValue::new(name).help(help))
    }
}

impl Flags {
    /// Where the table goes; `None` is standard output.
    fn output(&self) -> Option<&Path> {
        form::place(self.output.as_deref())
    }

    /// The form in which it is written.
    fn form(&self) -> Result<Form, Exit> {
        form::form(self.format.map(|written| written.0), self.output())
    }
}

/// The error of a table, with the flag that it is about.
pub(super) fn exit(error: &TableError) -> Exit {
    let of_axis = |axis: &str| if axis == "e" { "-e: " } else { "-n: " };
    let flag = match error {
        TableError::Lacks(_, axis) | TableError::Independent(_, axis) => of_axis(axis),
        TableError::Range { axis: "a ratio", .. } => "--ratio: ",
        TableError::Range { axis: "a restitution e", .. } => "-e: ",
        TableError::Range { .. } | TableError::NotIntegral => "-n: ",
        TableError::Whole(_) => "--extra: ",
        TableError::Digits(_) => "--digits or --places: ",
        TableError::TooManyRows | TableError::Row { .. } => "",
    };
    Exit { code: if error.is_limit() { 3 } else { 2 }, message: format!("error: {flag}{error}") }
}

/// Runs the command.
pub(super) fn run(flags: &Flags) -> Result<u8, Exit> {
    if let Some(path) = &flags.check {
        let given = &flags.contents;
        let of = |flag: &str, values: &[String]| grid(flag, joined(values).as_deref());
        let given = Given {
            ratio: of("--ratio", &given.ratio)?,
            e: of("-e", &given.e)?,
            n: of("-n", &given.n)?,
            names: ["--ratio", "-e", "-n"],
        };
        let rounding = flags.contents.round.rounding();
        return table_check::run(path, &given, rounding, flags.form()?, flags.output());
    }
    let plan = flags.contents.plan()?;
    let form = flags.form()?;
    if let Some(axis) = flags.across {
        return table_cross::run(&plan, axis, flags.fractions, form, flags.output());
    }
    if form == Form::Latex && plan.rows() > LATEX_ROWS {
        let message =
            format!("error: limit reached: rows of a table in LaTeX: {LATEX_ROWS} allowed, {} asked for", plan.rows());
        return Err(Exit { code: 3, message });
    }
    if flags.resume && form != Form::Csv {
        return Err(Exit::usage("error: --resume works with CSV only: add --format csv"));
    }
    let writer = Writer::new(form, Head::of(&plan));
    let writer = if flags.no_exact { writer.without("exact") } else { writer };
    match flags.output() {
        None => standard(&plan, writer, flags.certificate.as_deref()),
        Some(path) => file(&plan, writer, path, flags),
    }
}

/// Writes to standard output; a reader that goes away ends the work.
fn standard(plan: &Plan, writer: Writer, certificate: Option<&Path>) -> Result<u8, Exit> {
    let mut out = BufWriter::new(io::stdout().lock());
    let mut certificate = certificate.map(whole).transpose()?;
    let end = write(plan, writer, 0, &mut out, certificate.as_mut().map(|c| c as &mut dyn Write));
    match end.and_then(|end| out.flush().map(|()| end).map_err(Stop::Write)) {
        Ok(End::Complete) => certificate.map_or(Ok(()), Target::finish).map(|()| 0),
        Ok(End::Interrupted(rows)) => Err(interrupted(&format!("the table ends after {rows} rows"))),
        Err(Stop::Write(e)) if e.kind() == io::ErrorKind::BrokenPipe => Ok(0),
        Err(Stop::Write(e)) => Err(Exit::usage(format!("error: cannot write the table: {e}"))),
        Err(Stop::Table(e)) => Err(exit(&e)),
    }
}

fn whole(path: &Path) -> Result<Target, Exit> {
    Ok(Target::Whole(BufWriter::new(Output::file(path)?)))
}

/// The first line of a certificate: what the table says of itself in words, then all that is needed to check that the
/// rows are those of the table, and all of them (`src/checker/table_checker/text.rs`).
pub(super) fn certificate_head(plan: &Plan) -> String {
    let facts: serde_json::Map<String, serde_json::Value> =
        Head::of(plan).facts.into_iter().map(|(name, text)| (name.to_owned(), text.into())).collect();
    let axis = |grid: &Grid| match grid.shape() {
        Shape::List(list) => json!({ "list": list.iter().map(ToString::to_string).collect::<Vec<_>>() }),
        Shape::Steps(start, step, count) => {
            json!({ "start": start.to_string(), "step": step.to_string(), "count": count })
        }
        Shape::Factors(start, factor, count) => {
            json!({ "start": start.to_string(), "factor": factor.to_string(), "count": count })
        }
    };
    let axes: serde_json::Map<String, serde_json::Value> =
        plan.axes().map(|(name, grid)| (name.to_owned(), axis(grid))).collect();
    let digits = match plan.printing().digits {
        Digits::Significant(count) => json!({ "significant": count }),
        Digits::Places(count) => json!({ "places": count }),
    };
    let rounds = plan.quantity() != Quantity::BestN;
    let head = json!({
        "certificate": "table",
        "want": plan.quantity().name(),
        "head": facts,
        "version": 1,
        "axes": axes,
        "digits": rounds.then_some(digits),
        "rounding": rounds.then_some(rounding_name(plan.printing().rounding)),
        "rows": plan.rows(),
    });
    format!("{head}\n")
}

fn rounding_name(rounding: Rounding) -> &'static str {
    match rounding {
        Rounding::Nearest => "nearest-even",
        Rounding::Up => "up",
        Rounding::Down => "down",
        Rounding::Zero => "zero",
        Rounding::Away => "away",
    }
}

/// Writes to a file. At the end it is either complete or unchanged.
fn file(plan: &Plan, writer: Writer, path: &Path, flags: &Flags) -> Result<u8, Exit> {
    let csv = flags.form()? == Form::Csv;
    let grows = |path: &Path| csv && partial::can_grow(path);
    let targets: Vec<(&Path, table_rows::Form, String)> = [
        Some((path, table_rows::Form::Csv, writer.csv_head())),
        flags.certificate.as_deref().map(|path| (path, table_rows::Form::Certificate, certificate_head(plan))),
    ]
    .into_iter()
    .flatten()
    .collect();
    apart(path, flags.certificate.as_deref())?;
    if flags.resume
        && let Some((path, ..)) = targets.iter().find(|(path, ..)| !grows(path))
    {
        return Err(Exit::usage(format!("error: {} is not a regular file, so it cannot be resumed", path.display())));
    }
    let mut from = if flags.resume { plan.rows() } else { 0 };
    let mut open = Vec::new();
    for (path, form, head) in &targets {
        if !grows(path) {
            open.push(whole(path)?);
            continue;
        }
        let mut partial = Partial::open(path)?;
        if flags.resume {
            let rows = Rows::new(plan, *form, head);
            let lines = partial.lines(head, |row, text| row < plan.rows() && rows.has(row, text))?;
            from = from.min(lines);
        } else {
            partial.refuse_rows()?;
        }
        open.push(Target::Grows(partial));
    }
    // Every file is read completely before one is truncated.
    for (target, (.., head)) in open.iter_mut().zip(&targets) {
        if let Target::Grows(partial) = target {
            partial.keep(head, from)?;
        }
    }
    let mut certificate = if open.len() > 1 { open.pop() } else { None };
    let Some(mut out) = open.pop() else { return Err(Exit::usage("error: give a file: --output FILE")) };
    let result = write(plan, writer, from, &mut out, certificate.as_mut().map(|c| c as &mut dyn Write));
    match result {
        Ok(End::Complete) => {
            if let Some(certificate) = certificate {
                certificate.finish()?;
            }
            out.finish().map(|()| 0)
        }
        Ok(End::Interrupted(rows)) => {
            let mut ended = interrupted("nothing is left behind");
            for target in certificate.into_iter().chain([out]) {
                if let Target::Grows(partial) = target {
                    let left = partial.leave()?;
                    ended.message = format!(
                        "interrupted after {rows} rows; to continue from {}, run the same command with --resume",
                        left.display()
                    );
                }
            }
            Err(ended)
        }
        Err(Stop::Write(e)) => Err(Exit::usage(format!("error: cannot write {}: {e}", path.display()))),
        Err(Stop::Table(e)) => Err(exit(&e)),
    }
}

/// Rejects a table and a certificate that would overwrite each other, or each other's `.partial` file.
fn apart(output: &Path, certificate: Option<&Path>) -> Result<(), Exit> {
    let Some(certificate) = certificate else { return Ok(()) };
    // A special file, such as /dev/null, is not replaced.
    if std::fs::metadata(output).is_ok_and(|m| !m.is_file()) {
        return Ok(());
    }
    let names = |path: &Path| Ok::<_, Exit>([place(path)?, place(&partial::name(path))?]);
    let (table, other) = (names(output)?, names(certificate)?);
    if table.iter().any(|name| other.contains(name)) {
        let (output, certificate) = (output.display(), certificate.display());
        let message = format!(
            "error: --output {output} and --certificate {certificate} would overwrite each other; give two files, neither of which is the other's .partial"
        );
        return Err(Exit::usage(message));
    }
    Ok(())
}

/// A table in memory: its comma-separated values and its certificate.
///
/// # Errors
/// A limit, or Ctrl-C.
pub(crate) fn in_memory(plan: &Plan) -> Result<(String, String), Exit> {
    let (mut csv, mut certificate) = (Vec::new(), Vec::new());
    match write(plan, Writer::new(Form::Csv, Head::of(plan)), 0, &mut csv, Some(&mut certificate)) {
        Ok(End::Complete) => {
            Ok((String::from_utf8_lossy(&csv).into_owned(), String::from_utf8_lossy(&certificate).into_owned()))
        }
        Ok(End::Interrupted(_)) => Err(interrupted("nothing is written")),
        Err(Stop::Write(e)) => Err(Exit::usage(format!("error: cannot write the table: {e}"))),
        Err(Stop::Table(e)) => Err(exit(&e)),
    }
}

/// The rows of a table.
///
/// # Errors
/// A limit.
pub(super) fn rows(plan: &Plan) -> Result<Vec<Vec<Entry>>, Exit> {
    let mut factors = Factors::new(plan);
    let one = |row: u64| {
        let found = factors.value(row)?;
        Ok(entries(plan, plan.row(row, found)?.0))
    };
    (0..plan.rows()).map(one).collect::<Result<_, TableError>>().map_err(|e| exit(&e))
}
