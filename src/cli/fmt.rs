//! `carom fmt`

use super::load::{files, read, rendered};
use super::{Exit, print, write_file};
use crate::claim::diagnostic::Diagnostic;
use crate::claim::format::format;
use crate::claim::parse::parse_bytes;
use std::path::PathBuf;

/// Runs the command: nothing is written unless every file parses.
pub fn run(paths: &[PathBuf], check: bool) -> Result<u8, Exit> {
    let mut changed = Vec::new();
    let (mut messages, mut only_limits) = (Vec::new(), true);
    for path in files(paths)? {
        let bytes = read(&path)?;
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let shown = path.display().to_string();
        let formatted = parse_bytes(&bytes).and_then(|_| format(&text));
        match formatted {
            Ok(formatted) if formatted != text => changed.push((path, formatted)),
            Ok(_) => {}
            Err(faults) => {
                only_limits &= faults.iter().all(Diagnostic::is_limit);
                messages.extend(rendered(&faults, &shown, &text));
            }
        }
    }
    if !messages.is_empty() {
        return Err(Exit::faults(&messages, only_limits));
    }
    for (path, formatted) in &changed {
        print(&format!("{} {}\n", if check { "not formatted:" } else { "formatted" }, path.display()))?;
        if !check {
            write_file(path, formatted)?;
        }
    }
    Ok(u8::from(check && !changed.is_empty()))
}
