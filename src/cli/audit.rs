//! `carom audit`

use super::load::{self, Source};
use super::progress::Progress;
use super::{Exit, Format, print, write_file};
use crate::certify::several::Collection;
use crate::claim::diagnostic::{Diagnostic, Fault as Wrong, nearest};
use crate::claim::embedded;
use crate::claim::syntax::Claim;
use crate::prove::catalogue::{Catalogue, Limits};
use crate::prove::outcome::{Fault, Outcome, Verdict};
use crate::report::{self, Audit, Entry, Problem};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

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
            // Every word after --only is taken for a name, a path as well.
            None if n.contains('/') || n.ends_with(".claim") || Path::new(n).exists() => format!(
                "error: no claim is called {n}; it looks like a path: write paths before --only, \
                 as in `carom audit {n} --only ID`"
            ),
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

/// What the kernel is asked about proved claims.
pub struct Kernel<'a> {
    /// Where to write certificates.
    pub certificates: Option<&'a Path>,
    /// Whether a proof counts only with a certificate that the kernel accepts.
    pub checked: bool,
}

/// Runs the command.
pub fn run(
    paths: &[PathBuf],
    only: &[String],
    format: Format,
    output: Option<&Path>,
    kernel: &Kernel<'_>,
    limits: &Limits,
) -> Result<u8, Exit> {
    let mut loaded = match load(paths, only) {
        Ok(loaded) => loaded,
        Err(exit) => {
            // A machine that reads only the report must not take silence for success.
            if let Format::Junit = format {
                let problems = vec![problem("claims", &exit)];
                write(&Audit { entries: Vec::new(), problems, judged: 0 }, format, output)?;
            }
            return Err(exit);
        }
    };
    let (mut audit, messages) = judge_all(&mut loaded, only, limits);
    if kernel.checked || kernel.certificates.is_some() {
        ask_the_kernel(&loaded.catalogue, &mut audit.entries, kernel)?;
    }
    write(&audit, format, output)?;
    if !messages.is_empty() {
        return Err(Exit::usage(messages.join("\n")));
    }
    Ok(code(&audit))
}

/// Judges the built-in catalogue or the given files as a whole; also the proved claims, cited ones first.
pub fn all(paths: &[PathBuf], limits: &Limits) -> Result<(Audit, Vec<Claim>), Exit> {
    let mut loaded = load(paths, &[])?;
    let (audit, messages) = judge_all(&mut loaded, &[], limits);
    if !messages.is_empty() {
        return Err(Exit::usage(messages.join("\n")));
    }
    let proved: Vec<Claim> = proved(&audit.entries);
    Ok((audit, loaded.catalogue.in_order(&proved)))
}

fn proved(entries: &[Entry]) -> Vec<Claim> {
    entries.iter().filter(|e| e.outcome.verdict == Verdict::Proved).map(|e| e.claim.clone()).collect()
}

/// The audit, and what to print of the claims that could not be judged.
fn judge_all(loaded: &mut Loaded, only: &[String], limits: &Limits) -> (Audit, Vec<String>) {
    let all = loaded.catalogue.claims().iter().map(|c| c.name.text.clone());
    let names: Vec<String> = all.filter(|n| only.is_empty() || only.contains(n)).collect();
    let progress = Progress::start(names.len() as u64);
    let (mut entries, mut problems, mut messages) = (Vec::new(), Vec::new(), Vec::new());
    for (done, name) in names.iter().enumerate() {
        progress.now(done as u64, name);
        match loaded.judge(name, limits) {
            Ok(outcome) => {
                if let Some(claim) = loaded.catalogue.get(name) {
                    entries.push(Entry { claim: claim.clone(), outcome, certificate: None });
                }
            }
            Err(exit) => {
                problems.push(problem(name, &exit));
                messages.push(exit.message);
            }
        }
    }
    progress.finish();
    (Audit { entries, problems, judged: loaded.catalogue.work() }, messages)
}

/// The exit code: 0 all as expected, 3 where only limits stand in the way, else 1.
pub fn code(audit: &Audit) -> u8 {
    let unexpected: Vec<&Entry> = audit.entries.iter().filter(|e| !e.as_expected()).collect();
    let limit = |e: &&Entry| {
        e.outcome.verdict == Verdict::Undecided
            && e.outcome.reason.as_deref().is_some_and(|r| r.contains("limit reached"))
    };
    match unexpected.len() {
        0 => 0,
        _ if unexpected.iter().all(limit) => 3,
        _ => 1,
    }
}

/// Finds a certificate that the kernel accepts for each claim that was proved, writes it where that is wanted, and says
/// for which there is none.
fn ask_the_kernel(catalogue: &Catalogue, entries: &mut [Entry], kernel: &Kernel<'_>) -> Result<(), Exit> {
    if let Some(folder) = kernel.certificates {
        std::fs::create_dir_all(folder)
            .map_err(|e| Exit::usage(format!("error: cannot make the folder {}: {e}", folder.display())))?;
    }
    let proved = proved(entries);
    // A certificate that comes with the program is as good as a new one, unless it is to be written.
    let held: BTreeMap<String, &str> =
        if kernel.certificates.is_none() { embedded::certificates().into_iter().collect() } else { BTreeMap::new() };
    let (mut collection, mut found, mut missing) = (Collection::default(), 0, Vec::new());
    for claim in catalogue.in_order(&proved) {
        let name = &claim.name.text;
        let at_hand = held.get(name).and_then(|text| crate::certificate::text::read(text).ok());
        let result = collection.add(&claim, at_hand).map(|(certificate, _)| certificate);
        match result {
            Ok(certificate) => {
                if let Some(folder) = kernel.certificates {
                    let path = folder.join(format!("{name}.cert"));
                    write_file(&path, &crate::certificate::text::write(&certificate))?;
                    for entry in entries.iter_mut().filter(|e| e.claim.name.text == *name) {
                        entry.certificate = Some(path.display().to_string());
                    }
                }
                found += 1;
            }
            Err(reason) => {
                missing.push(format!("  {name}: {reason}"));
                for entry in entries.iter_mut().filter(|e| kernel.checked && e.claim.name.text == *name) {
                    entry.outcome.verdict = Verdict::Undecided;
                    entry.outcome.reason =
                        Some(format!("the search found a proof, but no certificate that the kernel accepts: {reason}"));
                }
            }
        }
    }
    let mut message = format!("{found} of {} proved claims have a certificate", found + missing.len());
    if !missing.is_empty() {
        message += &format!("; proved, no certificate:\n{}", missing.join("\n"));
    }
    let _ = std::io::Write::write_all(&mut anstream::stderr(), format!("{message}\n").as_bytes());
    Ok(())
}

/// A failure as a report shows it; the message for the terminal may have colours.
fn problem(name: &str, exit: &Exit) -> Problem {
    Problem { name: name.to_string(), message: anstream::adapter::strip_str(&exit.message).to_string() }
}

/// Writes the report.
fn write(audit: &Audit, format: Format, output: Option<&Path>) -> Result<(), Exit> {
    let text = match format {
        Format::Text => report::text::report(audit),
        Format::Json => report::json::report(audit),
        Format::Markdown => report::markdown::report(audit),
        Format::Junit => report::junit::report(audit),
    };
    match output {
        Some(path) => write_file(path, &anstream::adapter::strip_str(&text).to_string()),
        None => print(&text),
    }
}
