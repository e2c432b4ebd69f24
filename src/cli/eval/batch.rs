//! A stream of chains, a row of CSV each; memory stays flat.

use super::columns::{Columns, NAMES};
use super::{EvalFlags, coefficient, digits, failure, mass, natural, rounding, wants};
use crate::chain::threshold::Helps;
use crate::cli::form::{ending, place};
use crate::cli::interrupt::{INTERRUPTED, Interrupt, interrupted};
use crate::cli::output::Output;
use crate::cli::partial::Target;
use crate::cli::progress::Progress;
use crate::cli::table_contents::joined;
use crate::cli::{Exit, ValueFormat, load};
use crate::number::decimal::{Digits, Rounding};
use crate::report::answers::best;
use crate::report::table::csv::quoted;
use crate::scene::answer::{Answers, Number, Value};
use crate::scene::quantity::{Input, Quantity};
use crate::scene::{Coefficients, Inputs, Inserted, Scene, Start};
use crate::table::foreign::{Foreign, ForeignError};
use std::io::{BufRead, BufReader, BufWriter, IsTerminal, Write};
use std::path::Path;

/// So many lines of a batch that have no answer are named.
const MAX_NAMED: usize = 20;

/// Answers a stream of chains, a line each; memory stays flat.
pub(super) fn run(flags: &EvalFlags, path: &Path) -> Result<u8, Exit> {
    if let Some(ValueFormat::Json) = flags.format {
        return Err(Exit::usage("error: --batch writes CSV: leave --format json out"));
    }
    ending(flags.output.as_deref(), &[("csv", ())])?;
    let want = joined(&flags.want).as_deref().map_or(Ok(vec![Quantity::Eta]), wants)?;
    let streamed = [Quantity::Eta, Quantity::Threshold, Quantity::Helps, Quantity::BestN];
    if let Some(other) = want.iter().find(|q| !streamed.contains(q)) {
        return Err(Exit::usage(format!(
            "error: --batch answers eta, threshold, helps and best-n, not {}",
            other.name()
        )));
    }
    let fail = |e: std::io::Error| Exit::usage(format!("error: cannot read {}: {e}", path.display()));
    let mut input = BufReader::with_capacity(1 << 16, load::open(path).map_err(fail)?);
    let batch = Batch { want, digits: digits(flags)?, rounding: rounding(flags) };
    if let Some(target) = place(flags.output.as_deref()) {
        let mut out = BufWriter::with_capacity(1 << 16, Output::file(target)?);
        return match batch.answers(&mut input, path, &mut out) {
            Err(Stop::Input(exit)) if exit.code == INTERRUPTED => Err(interrupted("nothing is written")),
            Ok(unanswered) => Target::Whole(out).finish().and_then(|()| unanswered.exit()),
            Err(Stop::Write(e)) => Err(Exit::usage(format!("error: cannot write {}: {e}", target.display()))),
            Err(Stop::Input(exit)) => Err(exit),
        };
    }
    let mut out = BufWriter::with_capacity(1 << 16, std::io::stdout().lock());
    let ended = batch.answers(&mut input, path, &mut out);
    // What was answered so far stays, also when a line is wrong.
    let ended = match (ended, out.flush()) {
        (Ok(_), Err(e)) => Err(Stop::Write(e)),
        (ended, _) => ended,
    };
    match ended {
        Ok(unanswered) => unanswered.exit(),
        // The reader has gone away.
        Err(Stop::Write(e)) if e.kind() == std::io::ErrorKind::BrokenPipe => Ok(0),
        Err(Stop::Write(e)) => Err(Exit::usage(format!("error: cannot write to standard output: {e}"))),
        Err(Stop::Input(exit)) => Err(exit),
    }
}

/// Why a batch ended early.
enum Stop {
    Write(std::io::Error),
    Input(Exit),
}

impl From<std::io::Error> for Stop {
    fn from(error: std::io::Error) -> Stop {
        Stop::Write(error)
    }
}

/// The lines of a batch that have no answer.
#[derive(Default)]
struct Unanswered {
    /// What is wrong with the first of them.
    messages: Vec<String>,
    /// How many there are.
    count: u64,
    /// Whether any is bad input, and no limit.
    bad: bool,
}

impl Unanswered {
    fn note(&mut self, code: u8, message: String) {
        self.count += 1;
        self.bad |= code != 3;
        if self.messages.len() < MAX_NAMED {
            self.messages.push(message);
        }
    }

    fn exit(mut self) -> Result<u8, Exit> {
        if self.count == 0 {
            return Ok(0);
        }
        let more = self.count - self.messages.len() as u64;
        if more > 0 {
            self.messages.push(format!("error: {more} more lines have no answer"));
        }
        Err(Exit::faults(&self.messages, !self.bad))
    }
}

/// What a batch asks of each line.
struct Batch {
    want: Vec<Quantity>,
    digits: Digits,
    rounding: Rounding,
}

impl Batch {
    /// Answers row by row, the heading first. A row without an answer has empty cells.
    fn answers(&self, input: &mut dyn BufRead, path: &Path, out: &mut dyn Write) -> Result<Unanswered, Stop> {
        let shown = path.display();
        // The place once, however the message begins.
        let fault = |line: Option<u64>, exit: Exit| {
            let what = exit.message.strip_prefix("error: ").unwrap_or(&exit.message);
            let line = line.map_or_else(String::new, |line| format!(":{line}"));
            Exit { message: format!("error: {shown}{line}: {what}"), code: exit.code }
        };
        let unread = |error: ForeignError, is_named: bool| match error {
            ForeignError::Read(error) => load::cannot_read(path, &error),
            ForeignError::Fields { line, given, .. } if !is_named => {
                fault(Some(line), Exit::usage(format!("four fields m1,m2,e,n were expected, not {given}")))
            }
            error => {
                let code = if error.is_limit() { 3 } else { 2 };
                fault(error.line(), Exit { code, message: error.reason() })
            }
        };
        let mut unanswered = Unanswered::default();
        let mut table = Foreign::open_or(input, &NAMES).map_err(|error| Stop::Input(unread(error, true)))?;
        let columns = Columns::of(&table, &self.want).map_err(|exit| Stop::Input(fault(None, exit)))?;
        out.write_all(self.header().as_bytes())?;
        let interrupt = Interrupt::listen();
        // What is printed says itself how far the work is.
        let progress = (!std::io::stdout().is_terminal()).then(|| Progress::alone("rows"));
        for number in 0_u64.. {
            if interrupt.asked() {
                return Err(Stop::Input(interrupted(&format!("{number} rows are answered"))));
            }
            if let Some(progress) = &progress {
                progress.now(0, &format!("{number} rows"));
            }
            let row = match table.row() {
                Ok(None) if number == 0 => {
                    return Err(Stop::Input(fault(None, Exit::usage("there is no row to answer"))));
                }
                Ok(None) => break,
                Ok(Some(row)) => row,
                Err(error @ (ForeignError::NotText { .. } | ForeignError::Fields { .. })) => {
                    let exit = unread(error, table.is_named);
                    // No row of a table without a heading that begins so will be a chain.
                    if number == 0 && !table.is_named {
                        return Err(Stop::Input(exit));
                    }
                    unanswered.note(exit.code, exit.message);
                    out.write_all(self.empty([""; 4]).as_bytes())?;
                    continue;
                }
                Err(error) => return Err(Stop::Input(unread(error, table.is_named))),
            };
            let fields = columns.fields(&row);
            match self.answer(fields) {
                Ok(answer) => out.write_all(answer.as_bytes())?,
                Err(exit) => {
                    let exit = fault(Some(row.line), exit);
                    unanswered.note(exit.code, exit.message);
                    out.write_all(self.empty(fields).as_bytes())?;
                }
            }
        }
        Ok(unanswered)
    }

    /// The row of a chain that has no answer: its fields, and empty cells.
    fn empty(&self, fields: [&str; 4]) -> String {
        let columns = self.header().split(',').count();
        format!("{}{}\n", given(fields), ",".repeat(columns - fields.len()))
    }

    fn header(&self) -> String {
        let mut columns = NAMES.to_vec();
        columns.extend(self.want.iter().map(|q| match q {
            Quantity::Eta => "eta,eta_lower,eta_upper",
            Quantity::Threshold => "threshold,threshold_lower,threshold_upper",
            Quantity::Helps => "helps",
            _ => "best-n,tie",
        }));
        columns.join(",") + "\n"
    }

    fn answer(&self, fields: [&str; 4]) -> Result<String, Exit> {
        let [m1, m2, e, n] = fields;
        // A field that no wanted quantity needs may be empty.
        let is_given = |text: &&str| !text.is_empty();
        let e = Some(e).filter(is_given).map(|e| coefficient("e", e)).transpose()?;
        let n = Some(n).filter(is_given).map(|n| natural("n", n)).transpose()?;
        let inputs = Inputs::new(
            mass("m1", m1)?,
            mass("m2", m2)?,
            n.map(Inserted::Optimal),
            e.map(Coefficients::Same),
            Start::unit(),
        );
        let inputs = inputs.map_err(|error| failure("n", &error))?;
        let scene = Scene { want: self.want.clone(), digits: self.digits, rounding: self.rounding, inputs };
        if let Some((quantity, input)) = scene.missing() {
            let field = match input {
                Input::Restitution => "e",
                Input::Inserted => "n",
            };
            return Err(Exit::usage(format!("error: {} needs {field}, {}", quantity.name(), input.words())));
        }
        let answers = Answers::new(&scene);
        let mut out = given(fields);
        for quantity in &self.want {
            let (value, _) = answers.get(*quantity).map_err(|error| failure(quantity.name(), &error))?;
            out.push(',');
            out.push_str(&field(value));
        }
        out.push('\n');
        Ok(out)
    }
}

/// What was given, as the first columns.
fn given(fields: [&str; 4]) -> String {
    fields.map(|field| quoted(field.into(), b',')).join(",")
}

/// The answer to a streamed question, as its columns.
fn field(value: &Value) -> String {
    match value {
        Value::Number(Number { decimal, enclosure: (lower, upper), .. }) => {
            format!("{},{lower},{upper}", decimal.as_deref().unwrap_or(""))
        }
        Value::Helps(answer) => answer.map_or("depends", Helps::text).to_owned(),
        Value::Best(least, greatest) => {
            let (text, tie) = best(least, greatest);
            format!("{text},{tie}")
        }
        _ => String::new(),
    }
}
