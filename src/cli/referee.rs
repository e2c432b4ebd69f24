//! `carom referee`: compares the results of a simulator with exact collisions.

use super::form::form;
use super::{Exit, ValueFormat, deliver, load};
use crate::referee::judge::{Answer, MAX_DIGITS, judge};
use crate::referee::results::{self, ResultsError, unknown};
use crate::referee::{Reference, Scene, reference, settings};
use crate::report::referee as report;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The most bytes of a file of results.
const MAX_BYTES: usize = 64 << 20;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Flags {
    /// Your simulator's results as CSV, - for standard input. Required columns: `scene` and `velocities`; optional ones:
    /// `positions`, `collisions` (1-2 2-3 …, 0 is the left wall), `times` and `count`. Separate the numbers of one field
    /// by spaces
    #[arg(required_unless_present_any = ["scenes", "answers"])]
    results: Option<PathBuf>,
    /// Write the scenes as JSON: masses, positions, velocities and restitutions, with the exact final state
    #[arg(long, conflicts_with_all = ["results", "answers", "format"])]
    scenes: bool,
    /// Write the exact answers as CSV, in the form in which `carom referee` reads results
    #[arg(long, conflicts_with_all = ["results", "format"])]
    answers: bool,
    /// Only these scenes, or all scenes of these groups
    #[arg(long, value_name = "NAME", num_args = 1.., value_delimiter = ',')]
    only: Vec<String>,
    /// A number is right if its error is below 10^-D times the scene's largest velocity or position, or its duration
    #[arg(long, value_name = "D", default_value_t = 9, value_parser = clap::value_parser!(u64).range(1..=MAX_DIGITS))]
    digits: u64,
    /// The form of the report [default: by the ending of --output (.json), else text]
    #[arg(long, value_enum)]
    format: Option<ValueFormat>,
    /// Write to a file, - for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Runs the command. The exit code is 0 if every scene is right, 1 if one is wrong or missing.
pub(super) fn run(flags: &Flags) -> Result<u8, Exit> {
    // An error in the program's own list of scenes; the tests rule it out.
    let broken = |fault: String| Exit { code: 101, message: format!("{fault}; please report this") };
    let all = settings().map_err(broken)?;
    let chosen: Vec<Scene> = chosen(&all, &flags.only)?.into_iter().cloned().collect();
    let references = chosen.into_iter().map(reference).collect::<Result<Vec<Reference>, _>>().map_err(broken)?;
    let listed: Vec<&Reference> = references.iter().collect();
    let output = flags.output.as_deref();
    let path = match &flags.results {
        Some(path) => path,
        None => {
            let text = if flags.scenes { report::scenes(&listed) } else { report::answers(&listed) };
            return deliver(output, &text).map(|()| 0);
        }
    };
    let results = read(path, &all)?;
    let judge = |reference| (reference, judge(reference, results.get(&reference.scene.name), flags.digits));
    let judged: Vec<_> = references.iter().map(judge).collect();
    let text = match form(flags.format, output)? {
        ValueFormat::Text => report::text(&judged, flags.digits),
        ValueFormat::Json => report::json(&judged, flags.digits),
    };
    deliver(output, &text)?;
    Ok(u8::from(judged.iter().any(|(_, findings)| !findings.is_empty())))
}

fn chosen<'a>(all: &'a [Scene], only: &[String]) -> Result<Vec<&'a Scene>, Exit> {
    let fits = |scene: &Scene, name: &String| scene.name == *name || scene.group == *name;
    for name in only {
        if !all.iter().any(|scene| fits(scene, name)) {
            let known = all.iter().flat_map(|scene| [scene.name.as_str(), scene.group.as_str()]);
            return Err(Exit::usage(format!("error: --only: {}", unknown(name, known))));
        }
    }
    Ok(all.iter().filter(|scene| only.is_empty() || only.iter().any(|name| fits(scene, name))).collect())
}

/// The results of each scene.
fn read(path: &Path, scenes: &[Scene]) -> Result<BTreeMap<String, Answer>, Exit> {
    let shown = path.display();
    let bytes = load::bounded(path, MAX_BYTES).map_err(|e| load::cannot_read(path, &e))?;
    if bytes.len() > MAX_BYTES {
        return Err(Exit { code: 3, message: format!("error: {shown}: limit reached: {MAX_BYTES} bytes in a file") });
    }
    results::read(&bytes, scenes).map_err(|error| {
        let line = if let ResultsError::Field { line, .. } = &error { format!(":{line}") } else { String::new() };
        Exit { code: if error.is_limit() { 3 } else { 2 }, message: format!("error: {shown}{line}: {error}") }
    })
}
