//! Claim files from the disk, with every fault reported at once.

use super::Exit;
use crate::claim::diagnostic::Diagnostic;
use crate::claim::parse::parse_bytes;
use crate::claim::syntax::Claim;
use std::path::{Path, PathBuf};

/// The claim files under the paths, folders searched for `*.claim`, in order of their names.
pub fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Exit> {
    let mut out = Vec::new();
    for path in paths {
        if path.is_dir() {
            let before = out.len();
            folder(path, &mut out, 0)?;
            if out.len() == before {
                return Err(Exit::usage(format!("error: no .claim files in {}", path.display())));
            }
        } else {
            out.push(path.clone());
        }
    }
    Ok(out)
}

fn folder(path: &Path, out: &mut Vec<PathBuf>, depth: usize) -> Result<(), Exit> {
    if depth > 32 {
        return Err(Exit { code: 3, message: "limit reached: folders nest deeper than 32 levels".to_string() });
    }
    let fail = |e: std::io::Error| Exit::usage(format!("error: cannot read {}: {e}", path.display()));
    let mut list: Vec<PathBuf> = std::fs::read_dir(path)
        .map_err(fail)?
        .collect::<Result<Vec<_>, _>>()
        .map_err(fail)?
        .into_iter()
        .map(|e| e.path())
        .collect();
    list.sort();
    for entry in list {
        if entry.is_dir() {
            folder(&entry, out, depth + 1)?;
        } else if entry.extension().is_some_and(|e| e == "claim") {
            out.push(entry);
        }
    }
    Ok(())
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
        let size = std::fs::metadata(path).map(|m| m.len()).unwrap_or(0);
        if size > crate::claim::lex::FILE_LIMIT as u64 {
            messages.push(format!(
                "error: {}: limit reached: at most {} bytes in a claim file",
                path.display(),
                crate::claim::lex::FILE_LIMIT
            ));
            continue;
        }
        let bytes = match std::fs::read(path) {
            Ok(bytes) => bytes,
            Err(e) => {
                messages.push(format!("error: cannot read {}: {e}", path.display()));
                continue;
            }
        };
        let source = Source { path: path.display().to_string(), text: String::from_utf8_lossy(&bytes).into_owned() };
        match parse_bytes(&bytes) {
            Ok(list) => {
                origin.extend(std::iter::repeat_n(sources.len(), list.len()));
                claims.extend(list);
            }
            Err(faults) => {
                messages.extend(faults.iter().take(20).map(|f| f.render(&source.path, &source.text, colour())))
            }
        }
        sources.push(source);
    }
    if messages.is_empty() { Ok((claims, origin, sources)) } else { Err(Exit::usage(messages.join("\n"))) }
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
