//! `carom audit`

use super::check::unreadable;
use super::interrupt::{Interrupt, interrupted};
use super::load::{self, Broken, Files};
use super::progress::Progress;
use super::{Exit, Format, print, stream, terminal, write_file};
use crate::certificate::VERSION;
use crate::certificate::text::{FILE_LIMIT, Fault as Unread, Malformed, version_of};
use crate::claim::diagnostic::{self, Diagnostic, Source, nearest};
use crate::claim::dimension;
use crate::claim::embedded;
use crate::claim::syntax::Claim;
use crate::judge::hand::AtHand;
use crate::judge::{self, Judgement, News, Settings, judge};
use crate::latex::is_paper;
use crate::refute::catalogue::Catalogue;
use crate::refute::outcome::{Fault, Verdict};
use crate::report::{self, Audit, Entry, Problem, counted};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

/// Claims ready to be judged, with the source texts for error messages.
pub(super) struct Loaded {
    /// The claims.
    pub catalogue: Catalogue,
    /// Number of requested claims in the catalogue. The claims after them are cited ones of the built-in catalogue.
    own: usize,
    origin: Vec<usize>,
    sources: Vec<Source>,
    /// Files and claims that could not be read, and claims that cite these.
    broken: Vec<Broken>,
    /// The built-in certificates, and those in the folders of the claims.
    hand: AtHand,
}

/// Loads the built-in catalogue or the given files; with `only`, just the part of the catalogue that is needed.
///
/// # Errors
/// A file or claim could not be read.
pub(crate) fn load(paths: &[PathBuf], only: &[String]) -> Result<Loaded, Exit> {
    let loaded = readable(paths, only)?;
    if loaded.broken.is_empty() { Ok(loaded) } else { Err(load::together(&loaded.broken)) }
}

/// The same for a command about one claim: the rest of its file may be at fault.
///
/// # Errors
/// This claim, or one that it cites, could not be read.
pub(super) fn load_for(paths: &[PathBuf], id: &str) -> Result<Loaded, Exit> {
    let is_its = |broken: &Broken| broken.name == id || broken.claims.iter().any(|name| name == id);
    match readable(paths, &[id.to_string()])? {
        loaded if loaded.broken.iter().any(is_its) => Err(load::together(&loaded.broken)),
        loaded => Ok(loaded),
    }
}

/// The same, but leaves out what could not be read.
///
/// # Errors
/// Nothing could be read.
pub(super) fn readable(paths: &[PathBuf], only: &[String]) -> Result<Loaded, Exit> {
    let mut files = if paths.is_empty() {
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
        Files { claims, ..Files::default() }
    } else {
        load::claims(&load::files(paths)?)
    };
    let catalogue = loop {
        let all = if paths.is_empty() { files.claims.clone() } else { cited_too(files.claims.clone()) };
        let list = match Catalogue::new(all) {
            Ok(catalogue) => break catalogue,
            Err(list) => list,
        };
        set_aside(&mut files, &list);
    };
    let own = files.claims.len();
    if own == 0 && !files.broken.is_empty() {
        return Err(load::together(&files.broken));
    }
    let Files { claims, origin, sources, broken } = files;
    if only.iter().any(|n| claims.iter().all(|c| c.name.text != *n)) {
        if !broken.is_empty() {
            return Err(load::together(&broken));
        }
        let names: Vec<&str> = claims.iter().map(|c| c.name.text.as_str()).collect();
        return Err(no_match(only, &names));
    }
    Ok(Loaded { catalogue, own, origin, sources, broken, hand: AtHand::default() })
}

/// Adds the claims of the built-in catalogue that these claims cite and do not define themselves.
pub(crate) fn cited_too(mut claims: Vec<Claim>) -> Vec<Claim> {
    let missing = |claims: &[Claim]| -> Vec<String> {
        let cited = claims.iter().flat_map(|c| c.using.iter().map(|n| n.text.clone()));
        cited.filter(|n| claims.iter().all(|c| c.name.text != *n)).collect()
    };
    for name in missing(&claims) {
        let Ok(Some(list)) = embedded::claims(&[name]) else { continue };
        let is_new = |c: &Claim| claims.iter().all(|own| own.name.text != c.name.text);
        let list: Vec<Claim> = list.into_iter().filter(is_new).collect();
        claims.extend(list);
    }
    claims
}

/// Removes claims that cite an unknown claim, or themselves, and records their errors.
fn set_aside(files: &mut Files, list: &[(String, Diagnostic)]) {
    let gone: Vec<String> = files.broken.iter().flat_map(|b| b.claims.iter().cloned()).collect();
    for (name, fault) in list {
        let Some(place) = files.claims.iter().position(|c| c.name.text == *name) else { continue };
        let claim = &files.claims[place];
        let lost = claim.using.iter().find(|n| gone.contains(&n.text));
        let fault = match lost {
            Some(cited) => {
                let message = format!("{}, which {name} cites, could not be read", cited.text);
                let help = Some("correct that claim first".to_string());
                Diagnostic::new(diagnostic::Fault::Other { message, help }, cited.span)
            }
            None => fault.clone(),
        };
        let one = [(name.clone(), fault)];
        let exit = load::faults(&one, &files.claims, &files.origin, &files.sources);
        files.claims.remove(place);
        files.origin.remove(place);
        files.broken.push(Broken { name: name.clone(), claims: vec![name.clone()], exit });
    }
}

fn no_match(only: &[String], names: &[&str]) -> Exit {
    let missing: Vec<String> = only
        .iter()
        .filter(|n| !names.contains(&n.as_str()))
        .map(|n| match nearest(n, names.iter().copied()) {
            Some(near) => format!("error: no claim is called {n}; did you mean {near}?"),
            // Every word after --only counts as a name, even a path.
            None if n.contains('/') || n.ends_with(".claim") || is_paper(Path::new(n)) || Path::new(n).exists() => {
                format!(
                    "error: no claim is called {n}; it looks like a path: write paths before --only, \
                 as in `carom audit {n} --only ID`, and behind --from, as in `carom export coq --from {n}`"
                )
            }
            None => format!("error: no claim is called {n}; `carom list` prints the names"),
        })
        .collect();
    Exit::usage(missing.join("\n"))
}

impl Loaded {
    /// The claims that were asked for.
    pub(super) fn claims(&self) -> &[Claim] {
        &self.catalogue.claims()[..self.own]
    }

    /// Judges claims: all of the catalogue, or those of these names.
    pub(super) fn judge(&self, only: &[String], settings: &Settings) -> Judgement {
        let all = self.claims().iter().map(|c| c.name.text.clone());
        let names: Vec<String> = all.filter(|n| only.is_empty() || only.contains(n)).collect();
        let progress = Progress::start(names.len() as u64);
        let hear = |news: News<'_>| {
            if let News::Begun(done, name) = news {
                progress.now(done as u64, name);
            }
        };
        let found = judge(&self.catalogue, &names, &self.hand, settings, &hear);
        progress.finish();
        found
    }

    /// The certificates at hand.
    pub(super) fn hand(&self) -> &AtHand {
        &self.hand
    }

    /// The file and the line of a claim; of the built-in catalogue its path there.
    pub(super) fn place(&self, name: &str) -> Option<(String, usize)> {
        let at = self.claims().iter().position(|claim| claim.name.text == name)?;
        let span = self.claims()[at].name.span;
        match self.origin.get(at).and_then(|source| self.sources.get(*source)) {
            Some(source) => {
                let (path, line, _) = source.place(span);
                Some((path.to_owned(), line))
            }
            None => {
                let file = embedded::files().into_iter().find(|file| embedded::stem(file.path) == name)?;
                let start = Diagnostic::new(diagnostic::Fault::Empty, span);
                Some((file.path.to_owned(), start.place(file.text).0))
            }
        }
    }

    /// What could not be read: for the report, and as messages.
    pub(super) fn unread(&self) -> Vec<(Problem, String)> {
        self.broken.iter().map(|broken| (problem(&broken.name, &broken.exit), broken.exit.message.clone())).collect()
    }

    /// Adds the stored certificates: the built-in ones, and those in the folders of the claims.
    ///
    /// # Errors
    /// A certificate has another format version, unless `replaced` says that new ones will be made.
    pub(crate) fn with_certificates(mut self, replaced: bool) -> Result<Loaded, Exit> {
        self.hand = AtHand::of(embedded::certificates());
        let parents = self.sources.iter().map(|s| match Path::new(s.path()).parent() {
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
                // A file that cannot be read, or is not a certificate, is ignored.
                let text = load::bounded(&file, FILE_LIMIT).ok().and_then(|bytes| String::from_utf8(bytes).ok());
                let Some(text) = text else { continue };
                match version_of(&text).filter(|version| *version != VERSION.to_string()) {
                    None => self.hand.add(text.into()),
                    Some(_) if replaced => {}
                    Some(version) => {
                        let malformed = Malformed { line: 1, fault: Unread::Version(version.to_string()) };
                        return Err(unreadable(&file.display().to_string(), &malformed));
                    }
                }
            }
        }
        Ok(self)
    }

    /// Shows where dimensions differ, each at its place.
    fn show_dimensions(&self, entries: &[Entry]) {
        let list = entries.iter().filter_map(|entry| {
            let mismatch = dimension::of_goal(&entry.claim)?;
            let (message, help) = (mismatch.message(), Some(mismatch.help()));
            let fault = Diagnostic::new(diagnostic::Fault::Other { message, help }, mismatch.span);
            Some((entry.claim.name.text.clone(), fault))
        });
        let list: Vec<(String, Diagnostic)> = list.collect();
        if !list.is_empty() {
            terminal::note(&load::faults(&list, self.catalogue.claims(), &self.origin, &self.sources).message);
        }
    }

    /// The error of a claim that cannot be judged, with its place.
    pub(super) fn failure(&self, name: &str, fault: Fault) -> Exit {
        let Some(claim) = self.catalogue.get(name) else {
            return Exit::usage(format!("error: no claim is called {name}"));
        };
        let list = vec![(name.to_string(), judge::diagnostic(claim, fault))];
        load::faults(&list, self.catalogue.claims(), &self.origin, &self.sources)
    }
}

/// Runs the command.
pub(super) fn run(
    paths: &[PathBuf],
    only: &[String],
    format: Format,
    output: Option<&Path>,
    certificates: Option<&Path>,
    settings: &Settings,
) -> Result<u8, Exit> {
    let replaced = certificates.is_some() || settings.anew;
    let loaded = match readable(paths, only).and_then(|loaded| loaded.with_certificates(replaced)) {
        Ok(loaded) => loaded,
        Err(exit) => {
            // A program that reads only the report must not mistake an empty one for success.
            if let Format::Junit = format {
                let problems = vec![problem("claims", &exit)];
                write(&Audit { entries: Vec::new(), problems, judged: 0 }, format, output, &|_| None)?;
            }
            return Err(exit);
        }
    };
    let (audit, messages) = streamed(&loaded, only, format, output, certificates, settings)?;
    if Interrupt::listen().asked() {
        return Err(interrupted("everything is written"));
    }
    if !messages.is_empty() {
        return Err(Exit::usage(messages.join("\n")));
    }
    Ok(code(&audit))
}

/// Judges the claims and writes the report. Text for a file or pipe on standard output is written claim by claim; on a
/// terminal there is a bar until all are judged. Of every form, Ctrl-C leaves what was judged before it.
fn streamed(
    loaded: &Loaded,
    only: &[String],
    format: Format,
    output: Option<&Path>,
    certificates: Option<&Path>,
    settings: &Settings,
) -> Result<(Audit, Vec<String>), Exit> {
    let place = |name: &str| loaded.place(name);
    let piecewise = matches!(format, Format::Text) && output.is_none() && !std::io::stdout().is_terminal();
    let pieces = RefCell::new((report::text::Pieces::new(terminal::quiet()), Ok(())));
    let told = RefCell::new(BTreeSet::new());
    let show = |entry: &Entry| {
        if piecewise && told.borrow_mut().insert(entry.claim.name.text.clone()) {
            let (pieces, written) = &mut *pieces.borrow_mut();
            let piece = pieces.entry(entry);
            if written.is_ok() {
                *written = print(&piece);
            }
        }
    };
    let mut tell = |_: &str, result: &Result<Entry, Fault>| result.iter().for_each(&show);
    let finish = |audit: &Audit| -> Result<(), Exit> {
        if let Some(folder) = certificates {
            write_certificates(&audit.entries, folder)?;
        }
        if piecewise { print(&pieces.borrow().0.end(audit)) } else { write(audit, format, output, &place) }
    };
    let leave = |found: Judgement| {
        let mut audit = audit_of(loaded, found).0;
        // What was judged behind a claim that is not.
        audit.entries.iter().for_each(&show);
        let all = loaded.claims().iter().filter(|c| only.is_empty() || only.contains(&c.name.text)).count();
        let message = format!("interrupted: {} of {} are judged", audit.entries.len(), counted(all, "claim"));
        audit.problems.push(Problem { name: "audit".to_owned(), message: message.clone() });
        finish(&audit).map_or_else(|exit| exit.message, |()| message)
    };
    let found = stream::judged(loaded, only, settings, &mut tell, &leave);
    let (audit, messages) = audit_of(loaded, found);
    finish(&audit)?;
    if let Format::Text = format {
        loaded.show_dimensions(&audit.entries);
    }
    pieces.into_inner().1.map(|()| (audit, messages))
}

/// Judges the built-in catalogue or the given files as a whole; with the messages of what could not be judged.
pub(super) fn all(paths: &[PathBuf], settings: &Settings) -> Result<(Audit, Vec<String>), Exit> {
    let loaded = readable(paths, &[])?.with_certificates(settings.anew)?;
    Ok(audit_of(&loaded, loaded.judge(&[], settings)))
}

/// The audit, and the error messages of claims that could not be judged.
fn audit_of(loaded: &Loaded, found: Judgement) -> (Audit, Vec<String>) {
    let mut entries = Vec::new();
    let (mut problems, mut messages): (Vec<Problem>, Vec<String>) = loaded.unread().into_iter().unzip();
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

/// The exit code: 0 if all verdicts are as expected, 3 if only limits prevented that, else 1.
pub(super) fn code(audit: &Audit) -> u8 {
    let unexpected: Vec<&Entry> = audit.entries.iter().filter(|e| !e.as_expected()).collect();
    let limit = |e: &&Entry| e.outcome.verdict == Verdict::Undecided && e.outcome.limit.is_some();
    match unexpected.len() {
        0 => 0,
        _ if unexpected.iter().all(limit) => 3,
        _ => 1,
    }
}

/// Writes the certificates, and names the claims whose proofs the kernel does not accept.
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
    terminal::note(&format!("{} in {}", counted(written, "certificate"), folder.display()));
    Ok(())
}

/// A failure for a report, without the colours of the message for the terminal.
fn problem(name: &str, exit: &Exit) -> Problem {
    Problem { name: name.to_string(), message: anstream::adapter::strip_str(&exit.message).to_string() }
}

/// Writes the report; `place` tells the file and line of a claim.
fn write(
    audit: &Audit,
    format: Format,
    output: Option<&Path>,
    place: &dyn Fn(&str) -> Option<(String, usize)>,
) -> Result<(), Exit> {
    let text = match format {
        Format::Text if terminal::quiet() => report::text::unexpected(audit),
        Format::Text => report::text::report(audit),
        Format::Json => report::json::report(audit),
        Format::Markdown => report::markdown::report(audit),
        Format::Junit => super::junit::report(audit, place),
    };
    match output {
        Some(path) => write_file(path, &anstream::adapter::strip_str(&text).to_string()),
        None => print(&text),
    }
}
