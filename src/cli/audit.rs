//! `carom audit`

use super::load::{self, Source};
use super::{Exit, Format, print, write_file};
use crate::claim::diagnostic::{Diagnostic, Fault as Wrong, nearest};
use crate::claim::embedded;
use crate::claim::syntax::Claim;
use crate::prove::catalogue::{Catalogue, Limits};
use crate::prove::outcome::{Fault, Outcome, Verdict};
use crate::report::{self, Entry};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Claims ready to be judged, with the texts that errors point into.
pub struct Loaded {
    /// The claims.
    pub catalogue: Catalogue,
    origin: Vec<usize>,
    sources: Vec<Source>,
}

/// Loads the built-in catalogue or the given files; with `only`, no more of the catalogue than needed.
pub fn load(paths: &[PathBuf], only: &[String]) -> Result<Loaded, Exit> {
    let (claims, origin, sources): (Vec<Claim>, Vec<usize>, Vec<Source>) = if paths.is_empty() {
        let broken = |faults: Vec<Diagnostic>| {
            Exit::usage(faults.iter().map(Diagnostic::message).collect::<Vec<_>>().join("\n"))
        };
        let claims = match embedded::claims(only).map_err(broken)? {
            Some(claims) => claims,
            None => {
                let files = embedded::files();
                let names: Vec<&str> = files.iter().map(|f| embedded::stem(f.path)).collect();
                return Err(no_match(only, &names));
            }
        };
        (claims, Vec::new(), Vec::new())
    } else {
        load::claims(&load::files(paths)?)?
    };
    let copy = claims.clone();
    let catalogue = Catalogue::new(claims).map_err(|list| load::faults(&list, &copy, &origin, &sources))?;
    if only.iter().find(|n| catalogue.get(n).is_none()).is_some() {
        let names: Vec<&str> = catalogue.claims().iter().map(|c| c.name.text.as_str()).collect();
        return Err(no_match(only, &names));
    }
    Ok(Loaded { catalogue, origin, sources })
}

fn no_match(only: &[String], names: &[&str]) -> Exit {
    let missing: Vec<String> = only
        .iter()
        .filter(|n| !names.contains(&n.as_str()))
        .map(|n| match nearest(n, names.iter().copied()) {
            Some(near) => format!("error: no claim is called {n}; did you mean {near}?"),
            None => format!("error: no claim is called {n}; `carom audit` lists the names"),
        })
        .collect();
    Exit::usage(missing.join("\n"))
}

impl Loaded {
    /// Judges a claim.
    pub fn judge(&mut self, name: &str, limits: &Limits) -> Result<Outcome, Exit> {
        let outcome = self.catalogue.audit(name, limits);
        outcome.map_err(|fault| {
            let claim = self.catalogue.get(name).cloned();
            let span = claim.as_ref().map_or(Default::default(), |c| c.name.span);
            let diagnostic = match fault {
                Fault::Contradictory { hypotheses } => Diagnostic::new(
                    Wrong::Other {
                        message: format!("the hypotheses of {name} cannot all hold: {hypotheses}"),
                        help: Some("such a claim would be true of nothing; mend the hypotheses".to_string()),
                    },
                    span,
                ),
                Fault::Text(d) => Diagnostic::new(Wrong::Other { message: d.message, help: d.help }, d.span),
            };
            let list = vec![(name.to_string(), diagnostic)];
            load::faults(&list, self.catalogue.claims(), &self.origin, &self.sources)
        })
    }
}

/// Runs the command.
pub fn run(
    paths: &[PathBuf],
    only: &[String],
    format: Format,
    output: Option<&Path>,
    limits: &Limits,
) -> Result<u8, Exit> {
    let mut loaded = load(paths, only)?;
    let names: Vec<String> = if only.is_empty() {
        loaded.catalogue.claims().iter().map(|c| c.name.text.clone()).collect()
    } else {
        let all = loaded.catalogue.claims().iter().map(|c| c.name.text.clone());
        all.filter(|n| only.contains(n)).collect()
    };
    let started = Instant::now();
    let mut bar: Option<indicatif::ProgressBar> = None;
    let mut entries: Vec<Entry> = Vec::new();
    let mut faults = Vec::new();
    for (done, name) in names.iter().enumerate() {
        if bar.is_none() && started.elapsed() > Duration::from_millis(500) {
            bar = Some(indicatif::ProgressBar::new(names.len() as u64));
        }
        if let Some(bar) = &bar {
            bar.set_position(done as u64);
        }
        match loaded.judge(name, limits) {
            Ok(outcome) => {
                if let Some(claim) = loaded.catalogue.get(name) {
                    entries.push(Entry { claim: claim.clone(), outcome });
                }
            }
            Err(exit) => faults.push(exit.message),
        }
    }
    if let Some(bar) = bar {
        bar.finish_and_clear();
    }
    if !faults.is_empty() {
        return Err(Exit::usage(faults.join("\n")));
    }
    let text = match format {
        Format::Text => report::text::report(&entries),
        Format::Json => report::json::report(&entries, loaded.catalogue.work()),
        Format::Markdown => report::markdown::report(&entries),
        Format::Junit => report::junit::report(&entries),
    };
    match output {
        Some(path) => write_file(path, &anstream::adapter::strip_str(&text).to_string())?,
        None => print(&text)?,
    }
    let unexpected: Vec<&Entry> = entries.iter().filter(|e| !e.as_expected()).collect();
    let limit = |e: &&&Entry| {
        e.outcome.verdict == Verdict::Undecided
            && e.outcome.reason.as_deref().is_some_and(|r| r.contains("limit reached"))
    };
    Ok(if unexpected.is_empty() {
        0
    } else if unexpected.iter().all(|e| limit(&e)) {
        3
    } else {
        1
    })
}
