//! `carom audit`

use super::load::{self, Source};
use super::progress::Progress;
use super::{Exit, Format, print, write_file};
use crate::certificate::text::FILE_LIMIT;
use crate::claim::diagnostic::{Diagnostic, nearest};
use crate::claim::embedded;
use crate::claim::syntax::Claim;
use crate::judge::hand::AtHand;
use crate::judge::{Judgement, Settings, diagnostic, judge};
use crate::prove::catalogue::Catalogue;
use crate::prove::outcome::{Fault, Verdict};
use crate::report::{self, Audit, Entry, Problem, counted};
use std::collections::BTreeSet;
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
    /// Judges claims: all of the catalogue, or those of these names.
    pub fn judge(&self, only: &[String], settings: &Settings) -> Judgement {
        let all = self.catalogue.claims().iter().map(|c| c.name.text.clone());
        let names: Vec<String> = all.filter(|n| only.is_empty() || only.contains(n)).collect();
        let progress = Progress::start(names.len() as u64);
        let found =
            judge(&self.catalogue, &names, &self.hand(), settings, &|done, name| progress.now(done as u64, name));
        progress.finish();
        found
    }

    /// The certificates that come with the program, and those that lie beside the claims.
    fn hand(&self) -> AtHand {
        let mut out = AtHand::embedded();
        let parents = self.sources.iter().map(|s| match Path::new(&s.path).parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent.to_path_buf(),
            _ => PathBuf::from("."),
        });
        let folders: BTreeSet<PathBuf> = parents.flat_map(|p| [p.join("certificates"), p]).collect();
        for folder in folders {
            let Ok(entries) = std::fs::read_dir(folder) else { continue };
            let mut files: Vec<PathBuf> = entries.filter_map(|e| Some(e.ok()?.path())).collect();
            files.retain(|path| path.extension().is_some_and(|e| e == "cert"));
            files.sort();
            for file in files {
                // What cannot be read, or is no certificate, decides nothing.
                let text = load::bounded(&file, FILE_LIMIT).ok().and_then(|bytes| String::from_utf8(bytes).ok());
                text.into_iter().for_each(|text| out.add(text.into()));
            }
        }
        out
    }

    /// The failure of a claim that makes no sense, at its place.
    pub fn failure(&self, name: &str, fault: Fault) -> Exit {
        let Some(claim) = self.catalogue.get(name) else {
            return Exit::usage(format!("error: no claim is called {name}"));
        };
        let list = vec![(name.to_string(), diagnostic(claim, fault))];
        load::faults(&list, self.catalogue.claims(), &self.origin, &self.sources)
    }
}

/// Runs the command.
pub fn run(
    paths: &[PathBuf],
    only: &[String],
    format: Format,
    output: Option<&Path>,
    certificates: Option<&Path>,
    settings: &Settings,
) -> Result<u8, Exit> {
    let loaded = match load(paths, only) {
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
    let (audit, messages) = judge_all(&loaded, only, settings);
    if let Some(folder) = certificates {
        write_certificates(&audit.entries, folder)?;
    }
    write(&audit, format, output)?;
    if !messages.is_empty() {
        return Err(Exit::usage(messages.join("\n")));
    }
    Ok(code(&audit))
}

/// Judges the built-in catalogue or the given files as a whole.
pub fn all(paths: &[PathBuf], settings: &Settings) -> Result<Audit, Exit> {
    let loaded = load(paths, &[])?;
    let (audit, messages) = judge_all(&loaded, &[], settings);
    if messages.is_empty() { Ok(audit) } else { Err(Exit::usage(messages.join("\n"))) }
}

/// The audit, and what to print of the claims that could not be judged.
fn judge_all(loaded: &Loaded, only: &[String], settings: &Settings) -> (Audit, Vec<String>) {
    let (mut entries, mut problems, mut messages) = (Vec::new(), Vec::new(), Vec::new());
    let found = loaded.judge(only, settings);
    for (name, entry) in found.entries {
        match entry {
            Ok(entry) => entries.push(entry),
            Err(fault) => {
                let exit = loaded.failure(&name, fault);
                problems.push(problem(&name, &exit));
                messages.push(exit.message);
            }
        }
    }
    (Audit { entries, problems, judged: found.judged }, messages)
}

/// The exit code: 0 all as expected, 3 where only limits stand in the way, else 1.
pub fn code(audit: &Audit) -> u8 {
    let unexpected: Vec<&Entry> = audit.entries.iter().filter(|e| !e.as_expected()).collect();
    let limit = |e: &&Entry| e.outcome.verdict == Verdict::Undecided && e.outcome.limit.is_some();
    match unexpected.len() {
        0 => 0,
        _ if unexpected.iter().all(limit) => 3,
        _ => 1,
    }
}

/// Writes the certificate of each proved claim, and says which claims have a proof that the kernel does not check.
fn write_certificates(entries: &[Entry], folder: &Path) -> Result<(), Exit> {
    std::fs::create_dir_all(folder)
        .map_err(|e| Exit::usage(format!("error: cannot make the folder {}: {e}", folder.display())))?;
    let mut written = 0;
    for entry in entries {
        if let Some(proof) = &entry.proof {
            write_file(&folder.join(format!("{}.cert", entry.claim.name.text)), &proof.certificate)?;
            written += 1;
        }
    }
    let mut message = format!("{} in {}", counted(written, "certificate"), folder.display());
    let missing: Vec<&str> = entries.iter().filter(|e| e.found).map(|e| e.claim.name.text.as_str()).collect();
    if !missing.is_empty() {
        message += &format!("; found by the search, not accepted by the kernel: {}", missing.join(", "));
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
