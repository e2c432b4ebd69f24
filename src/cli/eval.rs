//! `carom eval`: one chain, by flags or by a scene file, or a stream of chains.

use super::form::{form, place};
use super::interrupt::{INTERRUPTED, Interrupt, interrupted};
use super::output::Output;
use super::partial::Target;
use super::progress::Progress;
use super::table_contents::{Round, joined};
use super::{Exit, ValueFormat, deliver, load, terminal};
use crate::chain::best::Best;
use crate::chain::threshold::Helps;
use crate::chain::uncertain::{Range, RangeError};
use crate::chain::{ChainError, Positive, Restitution};
use crate::number::NumberError;
use crate::number::decimal::{Digits, Rounding};
use crate::number::rational::{NumeralError, parse};
use crate::report::answers;
use crate::scene::answer::{Answers, Number, Value};
use crate::scene::drop::Drop;
use crate::scene::quantity::{Input, Quantity};
use crate::scene::read::{self, DEFAULT_DIGITS, SceneFault, elements};
use crate::scene::{About, Coefficients, Inputs, Inserted, Scene, Start};
use malachite::base::num::conversion::traits::IsInteger;
use std::io::{BufRead, BufReader, BufWriter, IsTerminal, Read, Write};
use std::path::{Path, PathBuf};

/// The longest line of a batch.
const MAX_LINE: usize = 1 << 16;
/// So many lines of a batch that have no answer are named.
const MAX_NAMED: usize = 20;

/// The flags of `carom eval`.
#[derive(clap::Args)]
pub struct EvalFlags {
    /// A scene file (see `carom help scene`), - for standard input; flags override its `digits` and `want`
    scene: Option<PathBuf>,
    /// Mass of the first body: 10, 3/4, 0.5, 2e-3, or measured: "57.1 ± 0.1", "[57, 58]"
    #[arg(long, value_name = "MASS", allow_hyphen_values = true)]
    m1: Option<String>,
    /// Mass of the last body
    #[arg(long, value_name = "MASS", allow_hyphen_values = true)]
    m2: Option<String>,
    /// Coefficient of restitution, or one for each collision: 9/10,4/5; threshold and masses do not need it
    #[arg(short = 'e', long = "restitution", value_name = "E[,E…]", allow_hyphen_values = true)]
    e: Vec<String>,
    /// Number of inserted bodies, 0 for none; best-n does not need it
    #[arg(short, long = "inserted", value_name = "N", allow_hyphen_values = true)]
    n: Option<String>,
    /// Inserted masses: optimal, or a list of n masses [default: optimal]
    #[arg(long, value_name = "optimal|M,M…", allow_hyphen_values = true)]
    masses: Vec<String>,
    /// Velocity of the first body [default: 1]
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    speed: Option<String>,
    /// What to compute, several with commas [default: eta]: eta (share of the first body's kinetic energy that reaches
    /// the last body), threshold (L_n: least restitution with which the n-th inserted body helps), helps (whether it
    /// does), best-n (n*: best number of inserted bodies), masses, velocities (after each body has struck the next),
    /// last-velocity, matrix (of each collision), losses (of energy), recollides (whether bodies meet again)
    #[arg(long, value_name = "LIST")]
    want: Vec<String>,
    /// Significant digits of each decimal [default: 15]
    #[arg(long, value_name = "D", conflicts_with = "places")]
    digits: Option<u64>,
    /// Digits after the point
    #[arg(long, value_name = "P")]
    places: Option<u64>,
    /// The direction of rounding [default: nearest]
    #[arg(long, value_enum)]
    round: Option<Round>,
    /// The form of the answers [default: by the ending of --output (.json), else text]
    #[arg(long, value_enum)]
    format: Option<ValueFormat>,
    /// Write the answers to a file, - for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// List what was computed, what was skipped, and the level that settled each answer
    #[arg(long)]
    explain: bool,
    /// Read chains as CSV lines m1,m2,e,n from a file (- for standard input) and write one CSV line for each; a field
    /// that nothing asks for may be empty. A line that is no chain is named and answered by empty cells, the others are
    /// answered all the same, and the exit code is 2
    #[arg(long, value_name = "FILE", conflicts_with_all = ["scene", "m1", "m2", "e", "n", "masses", "speed",
        "explain"])]
    batch: Option<PathBuf>,
}

/// Runs the subcommand.
pub fn run(flags: &EvalFlags) -> Result<u8, Exit> {
    if let Some(batch) = &flags.batch {
        return run_batch(flags, batch);
    }
    let scene = match &flags.scene {
        Some(path) => match from_file(flags, path)? {
            (_, read::Subject::Chain(scene)) => scene,
            (about, read::Subject::Drop(drop, digits)) => return dropped(flags, &about, &drop, digits),
        },
        None => from_flags(flags)?,
    };
    let found = Answers::new(&scene);
    let progress = Progress::alone("computing");
    let report = match form(flags.format, flags.output.as_deref())? {
        ValueFormat::Text => answers::text(&scene, &found, flags.explain),
        ValueFormat::Json => answers::json(&scene, &found, flags.explain),
    };
    progress.finish();
    deliver(flags.output.as_deref(), &report.map_err(|(quantity, error)| failure(quantity.name(), &error))?)?;
    Ok(0)
}

/// The failure of a quantity, with the exit code that it deserves.
fn failure(place: &str, error: &ChainError) -> Exit {
    let limit = matches!(error, ChainError::Number(NumberError::LimitReached { .. }));
    Exit { code: if limit { 3 } else { 2 }, message: format!("error: {place}: {error}") }
}

/// What a sheet or a picture of a scene is called: its file's name.
pub fn scene_title(path: &Path) -> String {
    let stem = path.file_stem().map_or_else(String::new, |s| s.to_string_lossy().replace(['-', '_'], " "));
    if stem.trim().is_empty() { "scene".to_owned() } else { stem }
}

/// Answers for balls that are dropped together.
fn dropped(flags: &EvalFlags, about: &About, drop: &Drop, digits: u64) -> Result<u8, Exit> {
    let refused = [
        ("--want", !flags.want.is_empty()),
        ("--places", flags.places.is_some()),
        ("--round", flags.round.is_some()),
        ("--explain", flags.explain),
    ];
    if let Some((flag, _)) = refused.iter().find(|(_, given)| *given) {
        return Err(Exit::usage(format!(
            "error: {flag}: a scene with [drop] answers one question, how high the balls rise"
        )));
    }
    let digits = match flags.digits {
        Some(0) => return Err(Exit::usage("error: --digits 0: give at least one significant digit")),
        Some(digits) => digits,
        None => digits,
    };
    let report = match form(flags.format, flags.output.as_deref())? {
        ValueFormat::Text => crate::report::drop::text(drop, about, digits),
        ValueFormat::Json => crate::report::drop::json(drop, digits),
    };
    deliver(flags.output.as_deref(), &report.map_err(|error| failure("drop", &error))?)?;
    Ok(0)
}

/// Reads a scene file, of a chain or of balls that are dropped, with what it says of itself.
pub fn described(path: &Path) -> Result<(About, read::Subject), Exit> {
    let text = text_of(path)?;
    read::described(&text).map_err(|fault| shown(&fault, path, &text))
}

/// A fault of a scene file, with its place.
fn shown(SceneFault { diagnostic, limit }: &SceneFault, path: &Path, text: &str) -> Exit {
    Exit {
        code: if *limit { 3 } else { 2 },
        message: diagnostic.render(&path.display().to_string(), text, terminal::colour()),
    }
}

fn text_of(path: &Path) -> Result<String, Exit> {
    let fail = |e: std::io::Error| Exit::usage(format!("error: cannot read {}: {e}", path.display()));
    let bytes = load::bounded(path, read::MAX_BYTES).map_err(fail)?;
    String::from_utf8(bytes).map_err(|_| Exit::usage(format!("error: {}: this is not UTF-8 text", path.display())))
}

fn from_file(flags: &EvalFlags, path: &Path) -> Result<(About, read::Subject), Exit> {
    let given = [
        ("--m1", flags.m1.is_some()),
        ("--m2", flags.m2.is_some()),
        ("-e", !flags.e.is_empty()),
        ("-n", flags.n.is_some()),
        ("--masses", !flags.masses.is_empty()),
        ("--speed", flags.speed.is_some()),
    ];
    if let Some((name, _)) = given.iter().find(|(_, given)| *given) {
        return Err(Exit::usage(format!(
            "error: {name} and a scene file: the file describes the whole chain; leave {name} out"
        )));
    }
    let text = text_of(path)?;
    let (about, subject) = read::described(&text).map_err(|fault| shown(&fault, path, &text))?;
    let read::Subject::Chain(mut scene) = subject else { return Ok((about, subject)) };
    if let Some(want) = joined(&flags.want) {
        scene.want = wants(&want)?;
    }
    if flags.digits.is_some() || flags.places.is_some() {
        scene.digits = digits(flags)?;
    }
    if flags.round.is_some() {
        scene.rounding = rounding(flags);
    }
    match scene.missing() {
        Some((quantity, input)) => Err(shown(&read::lacking(&text, quantity, input), path, &text)),
        None => Ok((about, read::Subject::Chain(scene))),
    }
}

fn from_flags(flags: &EvalFlags) -> Result<Scene, Exit> {
    let missing = |name: &str| Exit::usage(format!("error: {name} is missing: give --m1 and --m2, or a scene file"));
    let first = mass("--m1", flags.m1.as_ref().ok_or_else(|| missing("--m1"))?)?;
    let last = mass("--m2", flags.m2.as_ref().ok_or_else(|| missing("--m2"))?)?;
    let coefficients = joined(&flags.e).as_deref().map(coefficients).transpose()?;
    let count = flags.n.as_ref().map(|n| natural("-n", n)).transpose()?;
    let inserted = match joined(&flags.masses).as_deref() {
        None | Some("optimal") => count.map(Inserted::Optimal),
        Some(masses) => {
            let list = elements(masses).iter().map(|m| mass("--masses", m)).collect::<Result<Vec<_>, _>>()?;
            if let Some(count) = count
                && count != list.len() as u64
            {
                return Err(Exit::usage(format!("error: -n {count} does not fit {} masses", list.len())));
            }
            Some(Inserted::Given(list))
        }
    };
    let start = match &flags.speed {
        None => Start::unit(),
        Some(speed) => Start::Speed(parse(speed).map_err(|e| bad("--speed", &RangeError::Numeral(e)))?),
    };
    let inputs = Inputs::new(first, last, inserted, coefficients, start).map_err(|e| failure("chain", &e))?;
    let want = joined(&flags.want).as_deref().map_or(Ok(vec![Quantity::Eta]), wants)?;
    let scene = Scene { want, digits: digits(flags)?, rounding: rounding(flags), inputs };
    match scene.missing() {
        Some((quantity, Input::Restitution)) => {
            Err(Exit::usage(format!("error: {} needs -e, the coefficient of restitution", quantity.name())))
        }
        Some((quantity, Input::Inserted)) => Err(Exit::usage(format!(
            "error: {} needs -n, the number of inserted bodies (0 for none), or --masses",
            quantity.name()
        ))),
        None => Ok(scene),
    }
}

fn coefficients(text: &str) -> Result<Coefficients, Exit> {
    match elements(text).as_slice() {
        [one] => Ok(Coefficients::Same(coefficient("-e", one)?)),
        list => {
            // `0,9` is a list of two, and was hardly meant as one.
            let whole = |text: &&str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
            let hint = |exit: Exit| match list {
                [a, b] if whole(a) && whole(b) => Exit {
                    message: format!(
                        "{}; if one number is meant, write it with a decimal point: {a}.{b}",
                        exit.message
                    ),
                    ..exit
                },
                _ => exit,
            };
            let all = list.iter().map(|e| coefficient("-e", e)).collect::<Result<_, _>>();
            Ok(Coefficients::Each(all.map_err(hint)?))
        }
    }
}

fn wants(text: &str) -> Result<Vec<Quantity>, Exit> {
    let list = text
        .split(',')
        .map(str::trim)
        .filter(|name| !name.is_empty())
        .map(|name| Quantity::of_name(name).map_err(|message| Exit::usage(format!("error: --want: {message}"))))
        .collect::<Result<Vec<_>, _>>()?;
    if list.is_empty() {
        let names: Vec<&str> = Quantity::names().collect();
        return Err(Exit::usage(format!("error: --want: name at least one of {}", names.join(", "))));
    }
    Ok(list)
}

fn digits(flags: &EvalFlags) -> Result<Digits, Exit> {
    match (flags.places, flags.digits) {
        (Some(places), _) => Ok(Digits::Places(places)),
        (None, Some(0)) => Err(Exit::usage("error: --digits 0: give at least one significant digit")),
        (None, digits) => Ok(Digits::Significant(digits.unwrap_or(DEFAULT_DIGITS))),
    }
}

fn rounding(flags: &EvalFlags) -> Rounding {
    flags.round.map_or(Rounding::Nearest, Round::rounding)
}

fn bad(flag: &str, error: &RangeError) -> Exit {
    let limit = matches!(
        error,
        RangeError::Numeral(NumeralError::TooManyDigits { .. } | NumeralError::ExponentTooLarge { .. })
    );
    Exit { code: if limit { 3 } else { 2 }, message: format!("error: {flag}: {error}") }
}

fn mass(flag: &str, text: &str) -> Result<Range<Positive>, Exit> {
    Range::read(text).map_err(|e| bad(flag, &e))?.map(Positive::new).map_err(|e| failure(flag, &e))
}

fn coefficient(flag: &str, text: &str) -> Result<Range<Restitution>, Exit> {
    Range::read(text).map_err(|e| bad(flag, &e))?.map(Restitution::new).map_err(|e| failure(flag, &e))
}

fn natural(flag: &str, text: &str) -> Result<u64, Exit> {
    let number = match parse(text) {
        Ok(number) if number >= 0 && (&number).is_integer() => number,
        Err(e @ (NumeralError::TooManyDigits { .. } | NumeralError::ExponentTooLarge { .. })) => {
            return Err(bad(flag, &RangeError::Numeral(e)));
        }
        _ => return Err(Exit::usage(format!("error: {flag}: expected a natural number, found {text:?}"))),
    };
    u64::try_from(&number).map_err(|_| Exit {
        code: 3,
        message: format!("error: {flag}: limit reached: inserted bodies: {} allowed", crate::chain::MAX_INSERTED),
    })
}

/// Answers a stream of chains, a line each; memory stays flat.
fn run_batch(flags: &EvalFlags, path: &Path) -> Result<u8, Exit> {
    if let Some(ValueFormat::Json) = flags.format {
        return Err(Exit::usage("error: --batch writes CSV: leave --format json out"));
    }
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

/// The fields of a line of a batch: m1, m2, e, n.
const INPUTS: usize = 4;

/// What a batch asks of each line.
struct Batch {
    want: Vec<Quantity>,
    digits: Digits,
    rounding: Rounding,
}

impl Batch {
    /// Answers line by line, the heading first. A line without an answer has empty cells.
    fn answers(&self, input: &mut dyn BufRead, path: &Path, out: &mut dyn Write) -> Result<Unanswered, Stop> {
        let shown = path.display();
        let fault = |code: u8, line: u64, what: &str| Exit { code, message: format!("error: {shown}:{line}: {what}") };
        let mut unanswered = Unanswered::default();
        let (mut bytes, mut number, mut first) = (Vec::new(), 0_u64, true);
        let interrupt = Interrupt::listen();
        // What is printed says itself how far the work is.
        let progress = (!std::io::stdout().is_terminal()).then(|| Progress::alone("lines"));
        loop {
            if interrupt.asked() {
                return Err(Stop::Input(interrupted(&format!("{number} lines are answered"))));
            }
            if let Some(progress) = &progress {
                progress.now(0, &format!("{number} lines"));
            }
            bytes.clear();
            let read = (&mut *input).take(MAX_LINE as u64).read_until(b'\n', &mut bytes);
            let read = read.map_err(|e| Stop::Input(load::cannot_read(path, &e)))?;
            if number == 0 {
                out.write_all(self.header().as_bytes())?;
            }
            if read == 0 {
                return Ok(unanswered);
            }
            number += 1;
            if bytes.len() >= MAX_LINE {
                return Err(Stop::Input(fault(3, number, &format!("limit reached: {MAX_LINE} bytes in a line"))));
            }
            let Ok(text) = std::str::from_utf8(&bytes) else {
                let Exit { code, message } = fault(2, number, "this is not UTF-8 text");
                unanswered.note(code, message);
                out.write_all(self.empty("").as_bytes())?;
                continue;
            };
            let text = if number == 1 { text.trim_start_matches('\u{feff}') } else { text }.trim();
            if text.is_empty() || text.starts_with('#') {
                continue;
            }
            // The first line that is none of these may be the heading.
            let is_first = std::mem::take(&mut first);
            if is_first && text.replace(' ', "") == "m1,m2,e,n" {
                continue;
            }
            match self.answer(text) {
                Ok(answer) => out.write_all(answer.as_bytes())?,
                Err(exit) => {
                    let what = exit.message.strip_prefix("error: ").unwrap_or(&exit.message);
                    let fault = fault(exit.code, number, what);
                    // The heading of another table: no line of it will be a chain.
                    if is_first && text.split(',').count() != INPUTS {
                        return Err(Stop::Input(fault));
                    }
                    unanswered.note(fault.code, fault.message);
                    out.write_all(self.empty(text).as_bytes())?;
                }
            }
        }
    }

    /// The row of a line that has no answer: its fields, where they are as many as they must be, and empty cells.
    fn empty(&self, line: &str) -> String {
        let columns = self.header().split(',').count();
        let inputs = if line.split(',').count() == INPUTS { line.to_owned() } else { ",".repeat(INPUTS - 1) };
        format!("{inputs}{}\n", ",".repeat(columns - INPUTS))
    }

    fn header(&self) -> String {
        let mut columns = vec!["m1,m2,e,n"];
        columns.extend(self.want.iter().map(|q| match q {
            Quantity::Eta => "eta,eta_lower,eta_upper",
            Quantity::Threshold => "threshold,threshold_lower,threshold_upper",
            Quantity::Helps => "helps",
            _ => "best-n,tie",
        }));
        columns.join(",") + "\n"
    }

    fn answer(&self, line: &str) -> Result<String, Exit> {
        let fields: Vec<&str> = line.split(',').map(str::trim).collect();
        let [m1, m2, e, n] = fields.as_slice() else {
            return Err(Exit::usage(format!("error: four fields m1,m2,e,n were expected, not {}", fields.len())));
        };
        let number = |name: &str, text: &str| parse(text).map_err(|error| bad(name, &RangeError::Numeral(error)));
        let positive = |name: &str, text: &str| Positive::new(number(name, text)?).map_err(|e| failure(name, &e));
        let (first, last) = (positive("m1", m1)?, positive("m2", m2)?);
        // A field that nothing asks for may be empty.
        let given = |text: &&&str| !text.is_empty();
        let e = Some(e).filter(given).map(|e| Restitution::new(number("e", e)?).map_err(|error| failure("e", &error)));
        let n = Some(n).filter(given).map(|n| natural("n", n)).transpose()?;
        let inputs = Inputs::new(
            Range::point(first),
            Range::point(last),
            n.map(Inserted::Optimal),
            e.transpose()?.map(|e| Coefficients::Same(Range::point(e))),
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
        let mut out = line.to_owned();
        for quantity in &self.want {
            let (value, _) = answers.get(*quantity).map_err(|error| failure(quantity.name(), &error))?;
            out.push(',');
            out.push_str(&field(value));
        }
        out.push('\n');
        Ok(out)
    }
}

/// The answer to a streamed question, as its columns.
fn field(value: &Value) -> String {
    match value {
        Value::Number(Number { decimal, enclosure: (lower, upper), .. }) => {
            format!("{},{lower},{upper}", decimal.as_deref().unwrap_or(""))
        }
        Value::Helps(answer) => answer.map_or("depends", Helps::text).to_owned(),
        Value::Best(best, _) => match best {
            Best::Finite { count, tie } => format!("{count},{tie}"),
            Best::Infinite => "infinite,false".to_owned(),
            Best::Any => "any,false".to_owned(),
        },
        _ => String::new(),
    }
}

/// The page of `carom help scene`.
pub fn scene_help() -> String {
    format!("{}\nJSON schema for editors:\n\n{}", include_str!("scene.txt"), read::SCHEMA)
}
