//! `carom test`

use super::output::write_file;
use super::progress::Progress;
use super::{Exit, ValueFormat, print};
use crate::claim::diagnostic::nearest;
use crate::property::claims::{PROPERTIES, Property};
use crate::property::{Outcome, check, scene};
use crate::report::counted;
use serde_json::{Value, json};
use std::hash::{BuildHasher, RandomState};
use std::path::{Path, PathBuf};

/// The most cases of one property.
const MAX_CASES: u32 = 100_000_000;

/// The arguments.
#[derive(clap::Args)]
pub struct Flags {
    /// Random chains for each claim
    #[arg(long, value_name = "N", default_value_t = 256, value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_CASES)))]
    cases: u32,
    /// The seed of the random numbers; a new one if none is given, and printed always
    #[arg(long, value_name = "S")]
    seed: Option<u64>,
    /// Try only these claims
    #[arg(long, value_name = "ID", num_args = 1..)]
    only: Vec<String>,
    /// Save counterexamples here as scene files, those that are expected as well
    #[arg(long, value_name = "FOLDER")]
    save: Option<PathBuf>,
    /// The form of the report
    #[arg(long, value_enum, default_value = "text")]
    format: ValueFormat,
}

/// Runs the command.
pub fn run(flags: &Flags) -> Result<u8, Exit> {
    let missing: Vec<String> = flags
        .only
        .iter()
        .filter(|id| PROPERTIES.iter().all(|p| p.id != *id))
        .map(|id| {
            let names: Vec<&str> = PROPERTIES.iter().map(|p| p.id).collect();
            match nearest(id, names.iter().copied()) {
                Some(near) => format!("error: no property is called {id}; did you mean {near}?"),
                None => format!("error: no property is called {id}; there are {}", names.join(", ")),
            }
        })
        .collect();
    if !missing.is_empty() {
        return Err(Exit::usage(missing.join("\n")));
    }
    if let Some(folder) = flags.save.as_ref().filter(|f| !f.is_dir()) {
        return Err(Exit::usage(format!("error: {} is no folder", folder.display())));
    }
    // The hasher of the standard library starts from numbers of the operating system.
    let seed = flags.seed.unwrap_or_else(|| RandomState::new().hash_one("seed"));
    let text = matches!(flags.format, ValueFormat::Text);
    if text {
        print(&format!("seed {seed}, {} for each claim\n\n", counted(flags.cases as usize, "random chain")))?;
    }
    let chosen: Vec<&Property> =
        PROPERTIES.iter().filter(|p| flags.only.is_empty() || flags.only.iter().any(|id| id == p.id)).collect();
    let progress = Progress::start(chosen.len() as u64);
    let (mut rows, mut unexpected) = (Vec::new(), 0);
    for (done, property) in chosen.iter().enumerate() {
        progress.now(done as u64, property.id);
        let outcome = check(property, flags.cases, seed);
        let failed = matches!(outcome, Outcome::Failed { .. });
        let as_expected = failed == property.refuted && !matches!(outcome, Outcome::Stopped(_));
        unexpected += usize::from(!as_expected);
        let mut saved = None;
        if let Outcome::Failed { chain, reason } = &outcome
            && (!as_expected || flags.save.is_some())
        {
            let folder = flags.save.as_deref().unwrap_or(Path::new("."));
            let path = folder.join(format!("counterexample-{}.toml", property.id));
            let remarks = [
                format!("{}: {}", property.id, property.statement),
                format!("It fails here: {reason}."),
                format!("Found by carom test --only {} --seed {seed} --cases {}", property.id, flags.cases),
            ];
            write_file(&path, &scene::write(chain, &remarks, property.want))?;
            saved = Some(path.display().to_string());
        }
        if text {
            print(&line(property, &outcome, as_expected, saved.as_deref()))?;
        }
        rows.push(row(property, &outcome, as_expected, saved.as_deref()));
    }
    progress.finish();
    if text {
        let end = match unexpected {
            0 => "all as expected".to_owned(),
            n => format!("{n} not as expected; seed {seed}"),
        };
        print(&format!("\n{}: {end}\n", counted(chosen.len(), "claim")))?;
    } else {
        let value =
            json!({ "seed": seed.to_string(), "cases": flags.cases, "properties": rows, "unexpected": unexpected });
        print(&format!("{}\n", serde_json::to_string_pretty(&value).unwrap_or_default()))?;
    }
    Ok(u8::from(unexpected > 0))
}

fn word(outcome: &Outcome) -> &'static str {
    match outcome {
        Outcome::Held => "held",
        Outcome::Failed { .. } => "failed",
        Outcome::Stopped(_) => "stopped",
    }
}

fn reason(outcome: &Outcome) -> Option<&str> {
    match outcome {
        Outcome::Held => None,
        Outcome::Failed { reason, .. } | Outcome::Stopped(reason) => Some(reason),
    }
}

fn line(property: &Property, outcome: &Outcome, as_expected: bool, saved: Option<&str>) -> String {
    let mut out = format!("  {:8} {:17} {}\n", word(outcome), property.id, property.statement);
    let mut more = |text: &str| out.push_str(&format!("{:30}{text}\n", ""));
    if let Some(reason) = reason(outcome) {
        more(reason);
    }
    if let Outcome::Failed { chain, .. } = outcome {
        scene::write(chain, &[], &[]).lines().skip(3).for_each(&mut more);
    }
    if let Some(path) = saved {
        more(&format!("saved: carom eval {path}"));
    }
    more(match (as_expected, property.refuted) {
        (true, true) => "as expected: the catalogue refutes this claim",
        (false, true) => "not as expected: the catalogue refutes this claim",
        (false, false) => "not as expected: the catalogue proves this claim",
        (true, false) => return out,
    });
    out
}

fn row(property: &Property, outcome: &Outcome, as_expected: bool, saved: Option<&str>) -> Value {
    json!({
        "id": property.id,
        "statement": property.statement,
        "outcome": word(outcome),
        "as_expected": as_expected,
        "reason": reason(outcome),
        "scene": match outcome {
            Outcome::Failed { chain, .. } => Some(scene::write(chain, &[], property.want)),
            _ => None,
        },
        "saved": saved,
    })
}
