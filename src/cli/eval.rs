//! `carom eval`: one chain, by flags or by a scene file, or a stream of chains.

mod batch;
mod columns;

use super::form::form;
use super::progress::Progress;
use super::table_contents::{Round, joined};
use super::{Exit, ValueFormat, deliver, load, terminal};
use crate::chain::uncertain::{Range, RangeError};
use crate::chain::{ChainError, Positive, Restitution};
use crate::number::NumberError;
use crate::number::decimal::{Digits, Rounding};
use crate::number::rational::NumeralError;
use crate::number::typed::{self, Unclear};
use crate::report::answers;
use crate::scene::answer::Answers;
use crate::scene::drop::Drop;
use crate::scene::quantity::{Input, Quantity};
use crate::scene::read::{self, DEFAULT_DIGITS, SceneFault};
use crate::scene::{About, Coefficients, Inputs, Inserted, Scene, Start};
use malachite::base::num::conversion::traits::IsInteger;
use std::path::{Path, PathBuf};

/// The flags of `carom eval`.
#[derive(clap::Args)]
pub(super) struct EvalFlags {
    /// A scene file (see `carom help scene`), - for standard input; flags override its `digits` and `want`
    scene: Option<PathBuf>,
    /// Mass of the first body: 10, 3/4, 0.5 or 0,5, 2e-3 or 2·10^-3, or measured: "57.1 ± 0.1", "[57, 58]"
    #[arg(long, value_name = "MASS", allow_hyphen_values = true)]
    m1: Option<String>,
    /// Mass of the last body
    #[arg(long, value_name = "MASS", allow_hyphen_values = true)]
    m2: Option<String>,
    /// Coefficient of restitution, or one for each collision: "9/10; 4/5" or 9/10,4/5. threshold and masses do not need it
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
    /// Also list the quantities computed and skipped, and the arithmetic that settled each answer
    #[arg(long)]
    explain: bool,
    /// Read chains from a CSV file (- for standard input) with columns m1, m2, e and n in any order, and write one CSV
    /// row for each. Without a heading, the columns are m1,m2,e,n. A field that no wanted quantity needs may be empty, and
    /// its column missing. A bad row gives an error message, empty cells and exit code 2; the other rows are still answered. Cells may
    /// hold measured values; an answer then has its ends, and a decimal only where both round to it. No row is an error
    #[arg(long, value_name = "FILE", conflicts_with_all = ["scene", "m1", "m2", "e", "n", "masses", "speed",
        "explain"])]
    batch: Option<PathBuf>,
}

/// Runs the subcommand.
pub(super) fn run(flags: &EvalFlags) -> Result<u8, Exit> {
    if let Some(batch) = &flags.batch {
        return batch::run(flags, batch);
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

/// The failure of a quantity, with its exit code.
fn failure(place: &str, error: &ChainError) -> Exit {
    let limit = matches!(error, ChainError::Number(NumberError::LimitReached { .. }));
    Exit { code: if limit { 3 } else { 2 }, message: format!("error: {place}: {error}") }
}

/// The default title of a worksheet or picture of a scene, from the file's name.
pub(crate) fn scene_title(path: &Path) -> String {
    let stem = path.file_stem().map_or_else(String::new, |s| s.to_string_lossy().replace(['-', '_'], " "));
    if stem.trim().is_empty() { "scene".to_owned() } else { stem }
}

/// Computes the answers for balls that are dropped together.
fn dropped(flags: &EvalFlags, about: &About, drop: &Drop, digits: u64) -> Result<u8, Exit> {
    let refused = [
        ("--want", !flags.want.is_empty()),
        ("--places", flags.places.is_some()),
        ("--round", flags.round.is_some()),
        ("--explain", flags.explain),
    ];
    if let Some((flag, _)) = refused.iter().find(|(_, given)| *given) {
        return Err(Exit::usage(format!(
            "error: {flag} does not apply to a scene with [drop], which has one answer: how high the balls rise"
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

/// Reads a scene file, of a chain or of dropped balls, with its title, text and units.
pub(super) fn described(path: &Path) -> Result<(About, read::Subject), Exit> {
    let text = text_of(path)?;
    read::described(&text).map_err(|fault| shown(&fault, path, &text))
}

/// The message of an error in a scene file, with its place.
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
            "error: {name} cannot be combined with a scene file, which describes the whole chain; leave {name} out"
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
            let fits = |m: &str| mass("--masses", m).is_ok();
            let list = list("--masses", masses, fits)?;
            let list = list.iter().map(|m| mass("--masses", m)).collect::<Result<Vec<_>, _>>()?;
            if let Some(count) = count
                && count != list.len() as u64
            {
                let given = list.len();
                return Err(Exit::usage(format!(
                    "error: -n {count} contradicts --masses, which lists {given}; leave -n out"
                )));
            }
            Some(Inserted::Given(list))
        }
    };
    let start = match &flags.speed {
        None => Start::unit(),
        Some(speed) => Start::Speed(typed::read(speed).map_err(|e| bad("--speed", speed, &RangeError::Numeral(e)))?),
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
    match list("-e", text, |e| coefficient("-e", e).is_ok())?.as_slice() {
        [one] => Ok(Coefficients::Same(coefficient("-e", one)?)),
        list => Ok(Coefficients::Each(list.iter().map(|e| coefficient("-e", e)).collect::<Result<_, _>>()?)),
    }
}

/// The elements of a list, each in the engine's spelling.
fn list(flag: &str, text: &str, fits: impl Fn(&str) -> bool) -> Result<Vec<String>, Exit> {
    typed::list(text, fits).map_err(|Unclear(what)| Exit::usage(format!("error: {flag}: {what}")))
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
        return Err(Exit::usage(format!("error: --want: give at least one of {}", names.join(", "))));
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

/// Characters of a number that an error repeats.
const SHOWN: usize = 40;

fn rounding(flags: &EvalFlags) -> Rounding {
    flags.round.map_or(Rounding::Nearest, Round::rounding)
}

/// The error of a number in a flag, with the beginning of what was typed.
fn bad(flag: &str, text: &str, error: &RangeError) -> Exit {
    let shown: String = if text.is_empty() { "\"\"".to_owned() } else { text.chars().take(SHOWN).collect() };
    let rest = if text.chars().count() > SHOWN { "…" } else { "" };
    let limit = matches!(
        error,
        RangeError::Numeral(NumeralError::TooManyDigits { .. } | NumeralError::ExponentTooLarge { .. })
    );
    Exit { code: if limit { 3 } else { 2 }, message: format!("error: {flag} {shown}{rest}: {error}") }
}

fn mass(flag: &str, text: &str) -> Result<Range<Positive>, Exit> {
    Range::read(text).map_err(|e| bad(flag, text, &e))?.map(Positive::new).map_err(|e| failure(flag, &e))
}

fn coefficient(flag: &str, text: &str) -> Result<Range<Restitution>, Exit> {
    Range::read(text).map_err(|e| bad(flag, text, &e))?.map(Restitution::new).map_err(|e| failure(flag, &e))
}

fn natural(flag: &str, text: &str) -> Result<u64, Exit> {
    let number = match typed::read(text) {
        Ok(number) if number >= 0 && (&number).is_integer() => number,
        Err(
            e @ (NumeralError::TooManyDigits { .. }
            | NumeralError::ExponentTooLarge { .. }
            | NumeralError::Unclear { .. }),
        ) => {
            return Err(bad(flag, text, &RangeError::Numeral(e)));
        }
        _ => return Err(Exit::usage(format!("error: {flag}: expected a natural number, found {text:?}"))),
    };
    u64::try_from(&number).map_err(|_| Exit {
        code: 3,
        message: format!("error: {flag}: limit reached: inserted bodies: {} allowed", crate::chain::MAX_INSERTED),
    })
}

/// The page of `carom help scene`.
pub(crate) fn scene_help() -> String {
    format!("{}\nJSON schema for editors:\n\n{}", include_str!("scene.txt"), read::SCHEMA)
}
