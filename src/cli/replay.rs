//! `carom replay`

use super::form::form;
use super::progress::Progress;
use super::{Exit, deliver, load, terminal};
use crate::chain::replay::{Options, Status, replay};
use crate::claim::diagnostic::{Diagnostic, Fault};
use crate::claim::syntax::Span;
use crate::number::typed;
use crate::report::replay::{self as report, Numbers, Replay};
use crate::scene::replay::{MAX_BYTES, read};
use std::path::{Path, PathBuf};

/// The forms of a replay.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum ReplayFormat {
    /// Tables to read
    Text,
    /// Everything, for programs
    Json,
    /// One line for each collision
    Csv,
    /// A space–time diagram, time upward
    Svg,
    /// An animated, self-contained HTML page
    Html,
}

/// The arguments of `carom replay`.
#[derive(clap::Args)]
pub(super) struct ReplayArguments {
    /// The scene, a TOML file, - for standard input
    scene: PathBuf,
    /// The form of the report [default: by the ending of --output (.json, .csv, .svg, .html), else text]
    #[arg(long, value_enum)]
    format: Option<ReplayFormat>,
    /// Stop at this time
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    until: Option<String>,
    /// Stop after this many collisions
    #[arg(long, value_name = "N", default_value_t = crate::chain::replay::MAX_EVENTS)]
    max_events: u64,
    /// How many collisions to list [default: 40 in text, 2000 in pictures, 10000 elsewhere]
    #[arg(long, value_name = "N")]
    list: Option<usize>,
    /// Write all numbers exactly, however long they are, including the final values of a run with enclosures
    #[arg(long, conflicts_with = "digits")]
    exact: bool,
    /// Print decimals with D correct significant digits
    #[arg(long, value_name = "D", value_parser = clap::value_parser!(u64).range(1..=100_000))]
    digits: Option<u64>,
    /// Replace exact numbers by enclosures once a number has more than this many bits
    #[arg(long, value_name = "BITS", default_value_t = crate::chain::replay::EXACT_BITS)]
    exact_bits: u64,
    /// Try all orders of an ambiguous contact
    #[arg(long)]
    orders: bool,
    /// Continue after an inelastic collapse, with its bodies in contact at one velocity [default: the replay ends there]
    #[arg(long)]
    through_collapse: bool,
    /// Write the report to a file, - for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Runs the command.
pub(super) fn run(arguments: &ReplayArguments) -> Result<u8, Exit> {
    let until = arguments.until.as_deref().map(|t| {
        typed::read(t).map_err(|e| Exit::usage(format!("error: --until {t}: {e}; write for instance 3/2 or 1.5")))
    });
    let until = until.transpose()?;
    if until.as_ref().is_some_and(|t| *t < 0) {
        return Err(Exit::usage("error: --until must not be negative; the scene begins at time 0"));
    }
    let text = source(&arguments.scene)?;
    let scene = read(&text).map_err(|e| {
        let fault = Fault::Other { message: e.message, help: e.help };
        let span = Span { start: e.span.start, end: e.span.end };
        Exit::usage(Diagnostic::new(fault, span).render(
            &arguments.scene.display().to_string(),
            &text,
            terminal::colour(),
        ))
    })?;
    let format = form(arguments.format, arguments.output.as_deref())?;
    let list = arguments.list.unwrap_or(match format {
        ReplayFormat::Text => 40,
        ReplayFormat::Json | ReplayFormat::Csv => 10_000,
        ReplayFormat::Svg | ReplayFormat::Html => 2000,
    });
    let options = Options {
        max_events: arguments.max_events,
        until,
        list,
        exact_bits: Some(arguments.exact_bits),
        orders: arguments.orders,
        through_collapse: arguments.through_collapse,
        digits: arguments.digits.unwrap_or(report::DEFAULT_DIGITS),
        exact_values: arguments.exact,
    };
    let progress = Progress::alone("replaying");
    let outcome = replay(&scene.line, &options).map_err(|e| Exit {
        code: 101,
        message: format!(
            "internal error: {} is not conserved (collision {:?}); please report this",
            e.law, e.collision
        ),
    })?;
    progress.finish();
    let numbers = match (arguments.digits, format) {
        (Some(digits), _) => Numbers::Decimal(digits),
        (None, ReplayFormat::Text | ReplayFormat::Svg | ReplayFormat::Html) if !arguments.exact => {
            Numbers::Short(24, 12)
        }
        (None, _) => Numbers::Exact,
    };
    let replay = Replay { title: scene.title.as_deref(), line: &scene.line, outcome: &outcome, numbers };
    let text = match format {
        ReplayFormat::Text => report::text::report(&replay),
        ReplayFormat::Json => report::json::report(&replay),
        ReplayFormat::Csv => report::csv::report(&replay),
        ReplayFormat::Svg => report::svg::report(&replay),
        ReplayFormat::Html => report::html::report(&replay),
    };
    deliver(arguments.output.as_deref(), &text)?;
    Ok(if matches!(outcome.status, Status::Limit(_)) { 3 } else { 0 })
}

/// The text of the scene file.
fn source(path: &Path) -> Result<String, Exit> {
    let fail = |e: &dyn std::fmt::Display| Exit::usage(format!("error: cannot read {}: {e}", path.display()));
    let bytes = load::bounded(path, MAX_BYTES).map_err(|e| fail(&e))?;
    if bytes.len() > MAX_BYTES {
        let message = format!("error: {}: limit reached: at most {MAX_BYTES} bytes in a scene", path.display());
        return Err(Exit { code: 3, message });
    }
    String::from_utf8(bytes).map_err(|_| fail(&"it is not UTF-8 text; save the scene as UTF-8"))
}
