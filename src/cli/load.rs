//! Claim files from the disk, with every fault reported at once.

use super::Exit;
use super::paper::add;
use super::rest::{Rest, rest};
use super::terminal::colour;
use crate::claim::diagnostic::{Diagnostic, Fault, Source};
use crate::claim::embedded;
use crate::claim::lex::FILE_LIMIT;
use crate::claim::parse::{claim_names, parse_under, text_of};
use crate::claim::preamble::{self, Preamble};
use crate::claim::syntax::Claim;
use crate::latex::is_paper;
use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;
use std::path::{Path, PathBuf};

/// The claim files under the paths, folders searched for `*.claim`, in order of their names.
///
/// A file is listed once, by the first of its names: two paths may lead to it, and links may lead in
/// a circle.
pub(super) fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Exit> {
    let mut seen = BTreeSet::new();
    let mut out = Vec::new();
    for path in paths {
        if path.is_dir() && !is_standard_input(path) {
            let mut found = false;
            folder(path, &mut out, &mut seen, &mut found, 0)?;
            if !found {
                return Err(Exit::usage(format!("error: no .claim files in {}", path.display())));
            }
        } else if fresh(path, &mut seen)? {
            out.push(path.clone());
        }
    }
    Ok(out)
}

/// Whether this file or folder was not seen before. Standard input and pipes are compared by name only.
fn fresh(path: &Path, seen: &mut BTreeSet<PathBuf>) -> Result<bool, Exit> {
    let canonical = match std::fs::canonicalize(path) {
        Ok(canonical) => canonical,
        Err(_) if is_standard_input(path) || std::fs::metadata(path).is_ok() => path.to_path_buf(),
        Err(e) => return Err(claim_as_path(path).unwrap_or_else(|| cannot_read(path, &e))),
    };
    Ok(seen.insert(canonical))
}

/// The error for the name of a claim of the built-in catalogue in the place of a file, if it is one.
fn claim_as_path(path: &Path) -> Option<Exit> {
    let name = path.to_str()?;
    embedded::files().iter().any(|f| embedded::stem(f.path) == name).then(|| {
        Exit::usage(format!(
            "error: there is no file {name}; for the claim {name} of the built-in catalogue write --only {name}"
        ))
    })
}

/// Whether a path means standard input.
pub(crate) fn is_standard_input(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// A file opened for reading; `-` is standard input.
pub(super) fn open(path: &Path) -> std::io::Result<Box<dyn Read>> {
    Ok(if is_standard_input(path) { Box::new(std::io::stdin()) } else { Box::new(std::fs::File::open(path)?) })
}

/// The error for what cannot be read.
pub(crate) fn cannot_read(path: &Path, e: &std::io::Error) -> Exit {
    Exit::usage(format!("error: cannot read {}: {e}", path.display()))
}

fn folder(
    path: &Path,
    out: &mut Vec<PathBuf>,
    seen: &mut BTreeSet<PathBuf>,
    found: &mut bool,
    depth: usize,
) -> Result<(), Exit> {
    if depth > 32 {
        return Err(Exit { code: 3, message: "error: limit reached: folders nest deeper than 32 levels".to_string() });
    }
    if !fresh(path, seen)? {
        *found = true;
        return Ok(());
    }
    let mut list: Vec<PathBuf> = std::fs::read_dir(path)
        .and_then(Iterator::collect::<Result<Vec<_>, _>>)
        .map_err(|e| cannot_read(path, &e))?
        .into_iter()
        .map(|e| e.path())
        .collect();
    list.sort();
    for entry in list {
        if entry.is_dir() {
            folder(&entry, out, seen, found, depth + 1)?;
        } else if entry.extension().is_some_and(|e| e == "claim") {
            *found = true;
            if fresh(&entry, seen)? {
                out.push(entry);
            }
        }
    }
    Ok(())
}

/// The bytes of a file, or of standard input for `-`, at most one more than `limit`: enough to see that an endless one is too long.
pub(super) fn bounded(path: &Path, limit: usize) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    open(path)?.take(limit as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The bytes of a claim file; of an endless one no more than is needed to see that it is too long.
pub(super) fn read(path: &Path) -> Result<Vec<u8>, Exit> {
    let bytes = bounded(path, FILE_LIMIT).map_err(|e| cannot_read(path, &e))?;
    if bytes.len() > FILE_LIMIT {
        let message = format!("error: {}: limit reached: at most {FILE_LIMIT} bytes in a claim file", path.display());
        return Err(Exit { code: 3, message });
    }
    Ok(bytes)
}

/// The contents of claim files.
#[derive(Default)]
pub(super) struct Files {
    /// The claims.
    pub claims: Vec<Claim>,
    /// The number of each one's source.
    pub origin: Vec<usize>,
    /// The sources.
    pub sources: Vec<Source>,
    /// What could not be read.
    pub broken: Vec<Broken>,
}

/// A file that could not be read, or a claim of a name that is taken.
pub(super) struct Broken {
    /// The file or the claim.
    pub name: String,
    /// The names of the claims that are missing for it.
    pub claims: Vec<String>,
    /// Why.
    pub exit: Exit,
}

impl Files {
    /// All claims, if nothing is broken.
    pub(super) fn whole(self) -> Result<Files, Exit> {
        if self.broken.is_empty() { Ok(self) } else { Err(together(&self.broken)) }
    }
}

/// What is wrong, in one failure.
pub(super) fn together(broken: &[Broken]) -> Exit {
    let messages: Vec<String> = broken.iter().map(|b| b.exit.message.clone()).collect();
    Exit::faults(&messages, broken.iter().all(|b| b.exit.code == 3))
}

/// The claims of files under the preambles of their folders; a file or claim that is broken leaves the others as they are.
pub(super) fn claims(files: &[PathBuf]) -> Files {
    let mut out = Files::default();
    let mut folders: BTreeMap<PathBuf, Result<Preamble, String>> = BTreeMap::new();
    for path in files {
        let name = path.display().to_string();
        let bytes = match read(path) {
            Ok(bytes) => bytes,
            Err(exit) => {
                out.broken.push(Broken { name, claims: Vec::new(), exit });
                continue;
            }
        };
        if is_paper(path) {
            add(path, &bytes, &mut out);
            continue;
        }
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let folder = path.with_file_name(preamble::FILE);
        let shared = folders.entry(folder.clone()).or_insert_with(|| shared(&folder));
        let none = Preamble::default();
        let shared = match shared {
            _ if is_standard_input(path) || *path == folder => &none,
            Ok(shared) => shared,
            Err(message) => {
                let exit = Exit::usage(format!("{message}\n  in the preamble of {name}"));
                out.broken.push(Broken { name, claims: claim_names(&text), exit });
                continue;
            }
        };
        let list = match parse_all(&bytes, shared) {
            Ok(list) => list,
            Err(faults) => {
                // A fault of one claim leaves the others of the file.
                let rest = match text_of(&bytes) {
                    Ok(text) => rest(text, shared, faults),
                    Err(_) => Rest { claims: Vec::new(), lost: claim_names(&text), faults },
                };
                let Rest { claims, lost, faults } = rest;
                let exit = exit(&faults, &Source::new(name.clone(), text.clone()));
                out.broken.push(Broken { name: name.clone(), claims: lost, exit });
                claims
            }
        };
        out.origin.extend(std::iter::repeat_n(out.sources.len(), list.len()));
        out.claims.extend(list);
        out.sources.push(Source::new(name, text));
    }
    let taken = twice(&out);
    for (place, exit) in taken.into_iter().rev() {
        let claim = out.claims.remove(place);
        out.origin.remove(place);
        out.broken.push(Broken { name: claim.name.text, claims: Vec::new(), exit });
    }
    out
}

fn parse_all(bytes: &[u8], folder: &Preamble) -> Result<Vec<Claim>, Vec<Diagnostic>> {
    parse_under(text_of(bytes)?, folder).map(|file| file.0)
}

/// The preamble in a file, or an empty one if the file does not exist. The error is its first fault.
fn shared(path: &Path) -> Result<Preamble, String> {
    if !path.exists() {
        return Ok(Preamble::default());
    }
    let bytes = read(path).map_err(|exit| exit.message)?;
    let text = String::from_utf8_lossy(&bytes);
    let read = text_of(&bytes).and_then(|text| parse_under(text, &Preamble::default()));
    let source = || Source::new(path.display().to_string(), text.to_string());
    read.map(|file| file.1).map_err(|faults| rendered(&faults[..1], &source()).concat())
}

/// The most faults of one file that are shown.
const SHOWN: usize = 20;

/// The first faults of a file in full, and how many more there are.
pub(super) fn rendered(faults: &[Diagnostic], source: &Source) -> Vec<String> {
    let mut out: Vec<String> = faults.iter().take(SHOWN).map(|fault| source.render(fault, colour())).collect();
    let path = source.path();
    match faults.len().saturating_sub(SHOWN) {
        0 => {}
        1 => out.push(format!("error: {path}: 1 more fault")),
        more => out.push(format!("error: {path}: {more} more faults")),
    }
    out
}

/// The failure that shows the faults of a file.
pub(super) fn exit(faults: &[Diagnostic], source: &Source) -> Exit {
    Exit::faults(&rendered(faults, source), faults.iter().all(Diagnostic::is_limit))
}

/// Claims whose name an earlier one has, each shown at its place with the first in the help.
fn twice(files: &Files) -> Vec<(usize, Exit)> {
    let Files { claims, origin, sources, .. } = files;
    let mut first: BTreeMap<&str, usize> = BTreeMap::new();
    let mut out = Vec::new();
    for (place, claim) in claims.iter().enumerate() {
        let name = claim.name.text.as_str();
        let Some(before) = first.get(name) else {
            first.insert(name, place);
            continue;
        };
        let here = &sources[origin[place]];
        let there = &sources[origin[*before]];
        let (path, line, column) = there.place(claims[*before].name.span);
        let message = format!("another claim is already called {name}");
        let help = Some(format!("the first stands at {path}:{line}:{column}; give one of them another name"));
        let fault = Diagnostic::new(Fault::Other { message, help }, claim.name.span);
        out.push((place, Exit::usage(here.render(&fault, colour()))));
    }
    out
}

/// Faults found in a set of claims, rendered at their places.
pub(super) fn faults(list: &[(String, Diagnostic)], claims: &[Claim], origin: &[usize], sources: &[Source]) -> Exit {
    let text: Vec<String> = list
        .iter()
        .map(|(name, fault)| {
            let source = claims
                .iter()
                .position(|c| c.name.text == *name)
                .and_then(|i| origin.get(i))
                .and_then(|s| sources.get(*s));
            match source {
                Some(source) => source.render(fault, colour()),
                None => format!("error: {name}: {}", fault.message()),
            }
        })
        .collect();
    Exit::usage(text.join("\n"))
}
