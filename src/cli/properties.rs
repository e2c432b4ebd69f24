//! `carom test`

use super::audit::{Loaded, readable};
use super::form::{self, form};
use super::interrupt::{Heard, Interrupt, interrupted};
use super::output::write_file;
use super::progress::Progress;
use super::{Exit, deliver, junit, terminal};
use crate::claim::print::{Style, statement};
use crate::claim::syntax::{Claim, Expectation, Item};
use crate::judge::hand::AtHand;
use crate::property::law::{Failure, Found, Outcome, Settings, again as tried_again, tried};
use crate::refute::outcome::Point;
use crate::report::{Problem, counted, visible};
use quick_junit::TestCaseStatus;
use serde_json::{Value, json};
use std::hash::{BuildHasher, RandomState};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering::Relaxed};
use std::sync::mpsc::{Sender, channel};
use std::time::Duration;

/// The most points for one claim.
const MAX_CASES: u32 = 100_000_000;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Flags {
    /// Claim files and folders, - for standard input [default: the built-in catalogue]
    paths: Vec<PathBuf>,
    /// Random points for each claim
    #[arg(long, value_name = "N", default_value_t = 256, value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_CASES)))]
    cases: u32,
    /// The seed of the random numbers; it is always printed [default: a new one for each run]
    #[arg(long, value_name = "S")]
    seed: Option<u64>,
    /// Try only these claims
    #[arg(long, value_name = "ID", num_args = 1.., value_delimiter = ',')]
    only: Vec<String>,
    /// Largest number of seconds for each claim, on one core
    #[arg(long, value_name = "SECONDS", default_value_t = 10, value_parser = super::seconds)]
    time: u64,
    /// Save each counterexample in this folder as a claim file: the statement, with the variables' values as hypotheses.
    /// The next run with this folder tries what is saved there first
    #[arg(long, value_name = "FOLDER")]
    save: Option<PathBuf>,
    /// The form of the report [default: by the ending of --output (.json, .xml), else text]
    #[arg(long, value_enum)]
    format: Option<Form>,
    /// Write the report to a file, - for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// The forms of the report.
#[derive(Clone, Copy, clap::ValueEnum)]
enum Form {
    Text,
    Json,
    Junit,
}

impl form::Form for Form {
    const DEFAULT: Self = Self::Text;
    const ENDINGS: &'static [(&'static str, Self)] = &[("json", Self::Json), ("xml", Self::Junit)];
}

/// A claim with its outcome.
struct Row<'a> {
    claim: &'a Claim,
    outcome: Outcome,
    saved: Option<String>,
    /// The command that repeats the run for this claim.
    again: String,
}

impl Row<'_> {
    /// A counterexample is expected if and only if the claim file expects a refutation.
    fn as_expected(&self) -> bool {
        match self.outcome {
            Outcome::Failed(_) => self.claim.expect == Expectation::Refuted,
            Outcome::Held { .. } => self.claim.expect != Expectation::Refuted,
            Outcome::Untested(_) => true,
            Outcome::Fault(_) => false,
        }
    }

    fn is_untested(&self) -> bool {
        matches!(self.outcome, Outcome::Untested(_))
    }
}

/// Runs the command. The exit code is 1 if an outcome is not as expected, 3 if a requested claim could not be tried. After
/// Ctrl-C the report has the claims that were tried by then.
pub(super) fn run(flags: &Flags) -> Result<u8, Exit> {
    let loaded = readable(&flags.paths, &flags.only)?.with_certificates(false)?;
    let format = form(flags.format, flags.output.as_deref())?;
    if let Some(folder) = &flags.save {
        std::fs::create_dir_all(folder)
            .map_err(|e| Exit::usage(format!("error: cannot make the folder {}: {e}", folder.display())))?;
    }
    // The hasher of the standard library starts from numbers of the operating system.
    let seed = flags.seed.unwrap_or_else(|| RandomState::new().hash_one("seed"));
    let settings = Settings { cases: flags.cases, seed, time: Duration::from_secs(flags.time) };
    let wanted = |claim: &&Claim| flags.only.is_empty() || flags.only.contains(&claim.name.text);
    let claims: Vec<&Claim> = loaded.claims().iter().filter(wanted).collect();
    let earlier = claims.iter().map(|claim| earlier(claim, flags)).collect::<Result<Vec<_>, _>>()?;
    let (problems, messages): (Vec<_>, Vec<_>) = loaded.unread().into_iter().unzip();
    let left = |outcomes: Vec<Option<Outcome>>| {
        // A claim that makes no sense was not tried.
        let known = |outcome: &Option<Outcome>| outcome.as_ref().is_some_and(|o| !matches!(o, Outcome::Fault(_)));
        let tried = claims.iter().copied().zip(outcomes).filter(|(_, outcome)| known(outcome));
        let mut rows: Vec<Row> =
            tried.filter_map(|(claim, outcome)| Some(row_of(claim, outcome?, flags, &settings))).collect();
        let message = format!("interrupted: {} of {} are tried", rows.len(), counted(claims.len(), "claim"));
        let mut problems = loaded.unread().into_iter().map(|(problem, _)| problem).collect::<Vec<_>>();
        problems.push(Problem { name: "test".to_owned(), message: message.clone() });
        let written = save(&mut rows, flags).and_then(|()| write(&rows, &problems, format, flags, &settings, &loaded));
        written.map_or_else(|exit| exit.message, |()| message)
    };
    let outcomes = on_all_cores(&claims, &earlier, &settings, loaded.hand(), &left);
    let mut rows = Vec::new();
    for (claim, outcome) in claims.iter().copied().zip(outcomes) {
        let name = &claim.name.text;
        match outcome {
            Some(Outcome::Fault(fault)) => return Err(loaded.failure(name, fault)),
            Some(outcome) => rows.push(row_of(claim, outcome, flags, &settings)),
            None => return Err(Exit { code: 101, message: format!("{name}: the program failed; please report this") }),
        }
    }
    // No file is written before all claims are tried.
    save(&mut rows, flags)?;
    write(&rows, &problems, format, flags, &settings, &loaded)?;
    if Interrupt::listen().asked() {
        return Err(interrupted("everything is written"));
    }
    if !messages.is_empty() {
        return Err(Exit::usage(messages.join("\n")));
    }
    let asked = !flags.paths.is_empty() || !flags.only.is_empty();
    Ok(match rows.iter().any(|row| !row.as_expected()) {
        true => 1,
        false if rows.iter().any(Row::is_untested) && (asked || rows.iter().all(Row::is_untested)) => 3,
        false => 0,
    })
}

fn row_of<'a>(claim: &'a Claim, outcome: Outcome, flags: &Flags, settings: &Settings) -> Row<'a> {
    Row { claim, outcome, saved: None, again: again(flags, settings, &claim.name.text) }
}

/// Writes the counterexamples into the folder of `--save`.
fn save(rows: &mut [Row], flags: &Flags) -> Result<(), Exit> {
    let Some(folder) = &flags.save else { return Ok(()) };
    for row in rows {
        if let Outcome::Failed(failure) = &row.outcome {
            let path = file_of(folder, row.claim);
            if failure.found != Found::Saved {
                write_file(&path, &as_claim(row.claim, failure, &row.again))?;
            }
            row.saved = Some(path.display().to_string());
        }
    }
    Ok(())
}

/// Writes the report.
fn write(
    rows: &[Row],
    problems: &[Problem],
    format: Form,
    flags: &Flags,
    settings: &Settings,
    loaded: &Loaded,
) -> Result<(), Exit> {
    let report = match format {
        Form::Text => text(rows, settings),
        Form::Json => json(rows, problems, settings),
        Form::Junit => {
            let cases = rows.iter().map(|row| {
                let claim = row.claim;
                let section = claim.section.as_deref();
                junit::case(&claim.name.text, &claim.title, section, status(row), &|name| loaded.place(name))
            });
            junit::suite("carom test", cases, problems)
        }
    };
    deliver(flags.output.as_deref(), &report)
}

/// Where the counterexample of a claim is saved.
fn file_of(folder: &Path, claim: &Claim) -> PathBuf {
    folder.join(format!("counterexample-{}.claim", claim.name.text))
}

/// The counterexample of a claim that an earlier run saved.
fn earlier(claim: &Claim, flags: &Flags) -> Result<Option<Claim>, Exit> {
    let path = flags.save.as_deref().map(|folder| file_of(folder, claim)).filter(|path| path.is_file());
    let loaded = path.map(|path| readable(&[path], &[])).transpose()?;
    Ok(loaded.and_then(|loaded| loaded.claims().first().cloned()))
}

/// The outcome of each claim, in their order. One thread tries one claim at a time, first at the point that an `earlier` run
/// saved; `None` if it failed. After Ctrl-C, `leave` gets the outcomes until then and says what was written, and the program
/// ends.
fn on_all_cores(
    claims: &[&Claim],
    earlier: &[Option<Claim>],
    settings: &Settings,
    hand: &AtHand,
    leave: &dyn Fn(Vec<Option<Outcome>>) -> String,
) -> Vec<Option<Outcome>> {
    let progress = Progress::rows(0, claims.len() as u64 * u64::from(settings.cases));
    let interrupt = Interrupt::listen();
    let (next, done) = (AtomicUsize::new(0), AtomicU64::new(0));
    let work = |sender: Sender<(usize, Outcome)>| {
        while let Some((i, claim)) = Some(next.fetch_add(1, Relaxed)).and_then(|i| Some((i, claims.get(i)?))) {
            let mut before = 0;
            let saved = earlier.get(i).and_then(Option::as_ref);
            let again = saved.and_then(|saved| tried_again(claim, saved, settings));
            let outcome = again.map(Outcome::Failed).unwrap_or_else(|| {
                tried(claim, settings, hand, &mut |points| {
                    let points = u64::try_from(points).unwrap_or(u64::MAX).min(u64::from(settings.cases));
                    let all = done.fetch_add(points - before, Relaxed) + points - before;
                    before = points;
                    progress.now(all, &claim.name.text);
                })
            });
            done.fetch_add(u64::from(settings.cases) - before, Relaxed);
            // Nobody listens any more once Ctrl-C was obeyed.
            drop(sender.send((i, outcome)));
        }
    };
    let mut found: Vec<Option<Outcome>> = claims.iter().map(|_| None).collect();
    std::thread::scope(|scope| {
        let (sender, receiver) = channel();
        let work = &work;
        let workers = std::thread::available_parallelism().map_or(1, usize::from).min(claims.len());
        let begun = (0..workers).filter(|_| {
            let sender = sender.clone();
            let thread = std::thread::Builder::new().stack_size(super::STACK);
            thread.spawn_scoped(scope, move || work(sender)).is_ok()
        });
        // If no thread can be made, this one does the work.
        if begun.count() == 0 {
            work(sender.clone());
        }
        drop(sender);
        loop {
            match interrupt.next(&receiver) {
                Heard::News((i, outcome)) => found[i] = Some(outcome),
                Heard::End => break,
                Heard::Interrupted => interrupt.end(&leave(std::mem::take(&mut found))),
            }
        }
    });
    progress.finish();
    found
}

/// The command that repeats the run for one claim.
fn again(flags: &Flags, settings: &Settings, name: &str) -> String {
    let paths: String = flags.paths.iter().map(|path| format!(" {}", quoted(&path.display().to_string()))).collect();
    format!("carom test{paths} --only {name} --seed {} --cases {}", settings.seed, settings.cases)
}

/// A word, quoted for a shell if necessary.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-+".contains(c);
    if word.chars().all(plain) { word.to_owned() } else { format!("'{}'", word.replace('\'', "'\\''")) }
}

/// A counterexample as a claim of its own: the same statement, with the values of its variables as hypotheses. Values of what
/// the reader made, such as the whole number below another one, follow from these.
fn as_claim(claim: &Claim, failure: &Failure, again: &str) -> String {
    let declared = |name: &str| {
        let bindings = claim.written_items().iter().filter_map(|item| match item {
            Item::Given(bindings) => Some(bindings),
            _ => None,
        });
        let name = name.split('(').next().unwrap_or(name);
        bindings.flatten().any(|b| b.names.iter().any(|n| n.0.text == name))
    };
    let mut lines = statement(claim, Style::Text);
    let kept = |(name, _): &&(String, String)| declared(name) || claim.meaning_of(name).is_some();
    let values = Point { values: failure.witness.point.values.iter().filter(kept).cloned().collect() };
    let values = values.in_words(claim).into_iter().map(|value| format!("assume {value}"));
    let place = lines.iter().position(|line| line.starts_with("prove ")).unwrap_or(lines.len());
    lines.splice(place..place, values);
    let name = &claim.name.text;
    format!(
        "# Found by {again}\nclaim {name}-counterexample \"{}\"\n{}\nexpect refuted\n",
        claim.title,
        lines.join("\n")
    )
}

/// The status of a test case: a claim that could not be tried is skipped.
fn status(row: &Row) -> TestCaseStatus {
    if let Outcome::Untested(reason) = &row.outcome {
        let mut status = TestCaseStatus::skipped();
        status.set_message(reason.as_str());
        return status;
    }
    if row.as_expected() {
        return TestCaseStatus::success();
    }
    let mut lines = match &row.outcome {
        Outcome::Failed(Failure { witness, .. }) => junit::witness(&witness.point.in_words(row.claim), &witness.broken),
        _ => vec!["its file expects a counterexample, and none was found".to_owned()],
    };
    lines.push(format!("to repeat: {}", row.again));
    junit::failure(word(&row.outcome), &lines)
}

fn word(outcome: &Outcome) -> &'static str {
    match outcome {
        Outcome::Held { .. } => "held",
        Outcome::Failed(_) => "counterexample",
        Outcome::Untested(_) | Outcome::Fault(_) => "untested",
    }
}

fn text(rows: &[Row], settings: &Settings) -> String {
    let mut out = String::new();
    if !terminal::quiet() {
        let random = counted(settings.cases as usize, "random point");
        out += &format!("seed {}, {random} for each claim, after the points of an audit\n\n", settings.seed);
    }
    let shown = rows.iter().filter(|row| !terminal::quiet() || !row.as_expected());
    shown.for_each(|row| out += &lines(row));
    let count = |of: fn(&Row) -> bool| rows.iter().filter(|row| of(row)).count();
    let mut end = match count(|row| !row.as_expected()) {
        0 => "all as expected".to_owned(),
        n => format!("{n} not as expected"),
    };
    match count(|row| row.is_untested()) {
        0 => {}
        n => end += &format!("; {n} could not be tried"),
    }
    let gap = if out.is_empty() { "" } else { "\n" };
    out + &format!("{gap}{}: {end}; seed {}\n", counted(rows.len(), "claim"), settings.seed)
}

fn lines(row: &Row) -> String {
    let mut out = format!("  {:14}  {}  {}\n", word(&row.outcome), row.claim.name.text, visible(&row.claim.title));
    let mut more = |text: &str| out += &format!("{:18}{text}\n", "");
    match &row.outcome {
        Outcome::Held { points, open, late } => {
            let open = if *open == 0 { String::new() } else { format!("; {open} more could not be decided") };
            let late = if *late { "; limit reached: time (--time raises it)" } else { "" };
            more(&format!("at {}{open}{late}", counted(*points, "point")));
        }
        Outcome::Untested(reason) => more(reason),
        Outcome::Fault(_) => {}
        Outcome::Failed(Failure { witness, found }) => {
            match witness.point.in_words(row.claim) {
                at if at.is_empty() => more("it is false"),
                at => more(&format!("fails at {}", at.join(", "))),
            }
            for broken in &witness.broken {
                if broken.right.is_empty() {
                    more(&format!("  {}", broken.statement));
                } else {
                    let (left, right) = (&broken.left, &broken.right);
                    more(&format!("  {}: left side {left}, right side {right}", broken.statement));
                }
            }
            match found {
                Found::At(number) => more(&format!("found at point {number}, then simplified")),
                Found::Saved => more("found again where an earlier run had saved it"),
                Found::ByAudit => more("found by an audit: all points that were tried hold"),
            }
        }
    }
    if let Some(path) = &row.saved {
        more(&format!("saved in {path}"));
    }
    match (row.as_expected(), row.claim.expect) {
        (true, Expectation::Refuted) if !row.is_untested() => more("as expected: its file expects a counterexample"),
        (false, Expectation::Refuted) => more("not as expected: its file expects a counterexample, and none was found"),
        (false, _) => more("not as expected: its file expects the claim to hold"),
        _ => {}
    }
    if !row.as_expected() {
        more(&format!("to repeat: {}", row.again));
    }
    out
}

fn json(rows: &[Row], problems: &[Problem], settings: &Settings) -> String {
    let count = |of: fn(&Row) -> bool| rows.iter().filter(|row| of(row)).count();
    let claims: Vec<Value> = rows.iter().map(row).collect();
    let value = json!({
        "seed": settings.seed.to_string(),
        "cases": settings.cases,
        "claims": claims,
        "unexpected": count(|row| !row.as_expected()),
        "untested": count(|row| row.is_untested()),
        "errors": problems.iter().map(|p| json!({ "claim": p.name, "message": p.message })).collect::<Vec<_>>(),
    });
    serde_json::to_string_pretty(&value).unwrap_or_default() + "\n"
}

fn row(row: &Row) -> Value {
    let (points, open) = match row.outcome {
        Outcome::Held { points, open, .. } => (json!(points), json!(open)),
        _ => (Value::Null, Value::Null),
    };
    let failure = match &row.outcome {
        Outcome::Failed(failure) => Some(failure),
        _ => None,
    };
    let witness = failure.map(|f| {
        let values = f.witness.point.values.iter().map(|(name, value)| (name.clone(), Value::from(value.clone())));
        Value::Object(values.collect())
    });
    let broken = failure.map(|f| {
        let each = f.witness.broken.iter();
        let each = each.map(|b| json!({ "statement": b.statement, "left": b.left, "right": b.right }));
        Value::Array(each.collect())
    });
    json!({
        "id": row.claim.name.text,
        "title": row.claim.title,
        "outcome": word(&row.outcome),
        "as_expected": row.as_expected(),
        "points": points,
        "open": open,
        "reason": match &row.outcome { Outcome::Untested(reason) => Some(reason), _ => None },
        "witness": witness,
        "broken": broken,
        "found": failure.and_then(|f| match f.found { Found::At(number) => Some(number), _ => None }),
        "found_by": failure.map(|f| match f.found { Found::At(_) => "point", Found::Saved => "saved", Found::ByAudit => "audit" }),
        "again": row.again,
        "saved": row.saved,
    })
}
