//! Claim files from the disk, with every fault reported at once.

use super::Exit;
use crate::claim::diagnostic::{Diagnostic, Fault};
use crate::claim::lex::FILE_LIMIT;
use crate::claim::parse::parse_bytes;
use crate::claim::syntax::Claim;
use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;
use std::path::{Path, PathBuf};

/// The claim files under the paths, folders searched for `*.claim`, in order of their names.
///
/// A file is listed once, by the first of its names: two paths may lead to it, and links may lead in
/// a circle.
pub fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Exit> {
    let mut seen = BTreeSet::new();
    let mut out = Vec::new();
    for path in paths {
        if path.is_dir() {
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

/// Whether nothing seen so far is this file or folder.
fn fresh(path: &Path, seen: &mut BTreeSet<PathBuf>) -> Result<bool, Exit> {
    let canonical = std::fs::canonicalize(path).map_err(|e| cannot_read(path, &e))?;
    Ok(seen.insert(canonical))
}

pub fn cannot_read(path: &Path, e: &std::io::Error) -> Exit {
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
        return Err(Exit { code: 3, message: "limit reached: folders nest deeper than 32 levels".to_string() });
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

/// A file's bytes, at most one more than `limit`: enough to see that an endless one is too long.
pub fn bounded(path: &Path, limit: usize) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    std::fs::File::open(path)?.take(limit as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The bytes of a claim file; of an endless one no more than is needed to see that it is too long.
pub fn read(path: &Path) -> Result<Vec<u8>, Exit> {
    let bytes = bounded(path, FILE_LIMIT).map_err(|e| cannot_read(path, &e))?;
    if bytes.len() > FILE_LIMIT {
        let message = format!("error: {}: limit reached: at most {FILE_LIMIT} bytes in a claim file", path.display());
        return Err(Exit::usage(message));
    }
    Ok(bytes)
}

/// A file's text; what is not UTF-8 is replaced, for messages only.
pub struct Source {
    /// The path as given.
    pub path: String,
    /// The text.
    pub text: String,
}

/// Claims, the number of each one's source, and the sources.
pub type Claims = (Vec<Claim>, Vec<usize>, Vec<Source>);

/// The claims of files, each with the number of its source.
pub fn claims(files: &[PathBuf]) -> Result<Claims, Exit> {
    let (mut claims, mut origin, mut sources) = (Vec::new(), Vec::new(), Vec::new());
    let mut messages = Vec::new();
    for path in files {
        let bytes = match read(path) {
            Ok(bytes) => bytes,
            Err(exit) => {
                messages.push(exit.message);
                continue;
            }
        };
        let source = Source { path: path.display().to_string(), text: String::from_utf8_lossy(&bytes).into_owned() };
        match parse_bytes(&bytes) {
            Ok(list) => {
                origin.extend(std::iter::repeat_n(sources.len(), list.len()));
                claims.extend(list);
            }
            Err(faults) => messages.extend(rendered(&faults, &source.path, &source.text)),
        }
        sources.push(source);
    }
    messages.extend(twice(&claims, &origin, &sources));
    if messages.is_empty() { Ok((claims, origin, sources)) } else { Err(Exit::usage(messages.join("\n"))) }
}

/// The most faults of one file that are shown.
const SHOWN: usize = 20;

/// The first faults of a file in full, and how many more there are.
pub fn rendered(faults: &[Diagnostic], path: &str, text: &str) -> Vec<String> {
    let mut out: Vec<String> = faults.iter().take(SHOWN).map(|f| f.render(path, text, colour())).collect();
    match faults.len().saturating_sub(SHOWN) {
        0 => {}
        1 => out.push(format!("error: {path}: 1 more fault")),
        more => out.push(format!("error: {path}: {more} more faults")),
    }
    out
}

/// Names that more than one claim has, each shown at the second place with the first in the help.
fn twice(claims: &[Claim], origin: &[usize], sources: &[Source]) -> Vec<String> {
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
        let span = claims[*before].name.span;
        let (line, column) = Diagnostic::new(Fault::Empty, span).place(&there.text);
        let message = format!("another claim is called {name} already");
        let help = Some(format!("the first stands at {}:{line}:{column}; give one of them another name", there.path));
        let fault = Diagnostic::new(Fault::Other { message, help }, claim.name.span);
        out.push(fault.render(&here.path, &here.text, colour()));
    }
    out
}

/// Faults found in a set of claims, rendered at their places.
pub fn faults(list: &[(String, Diagnostic)], claims: &[Claim], origin: &[usize], sources: &[Source]) -> Exit {
    let text: Vec<String> = list
        .iter()
        .map(|(name, fault)| {
            let source = claims
                .iter()
                .position(|c| c.name.text == *name)
                .and_then(|i| origin.get(i))
                .and_then(|s| sources.get(*s));
            match source {
                Some(source) => fault.render(&source.path, &source.text, colour()),
                None => format!("error: {name}: {}", fault.message()),
            }
        })
        .collect();
    Exit::usage(text.join("\n"))
}

/// Whether errors go to a terminal that wants colours.
pub fn colour() -> bool {
    use std::io::IsTerminal;
    std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty())
}
