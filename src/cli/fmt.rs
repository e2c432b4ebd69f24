//! `carom fmt`

use super::interrupt::{Interrupt, interrupted};
use super::load::{files, is_standard_input, read, rendered};
use super::{Exit, print, write_file};
use crate::claim::diagnostic::{Diagnostic, Source};
use crate::claim::format::format;
use crate::claim::parse::text_of;
use std::path::PathBuf;

/// Runs the command. It writes nothing unless it can read every file.
pub(super) fn run(paths: &[PathBuf], check: bool) -> Result<u8, Exit> {
    let mut changed = Vec::new();
    let (mut messages, mut only_limits) = (Vec::new(), true);
    let paths = files(paths)?;
    if !check && paths.len() > 1 && paths.iter().any(|path| is_standard_input(path)) {
        return Err(Exit::usage("error: - reads standard input and cannot be combined with files"));
    }
    for path in paths {
        let bytes = read(&path)?;
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let formatted = text_of(&bytes).and_then(format);
        match formatted {
            Ok(formatted) if !check && is_standard_input(&path) => return print(&formatted).map(|()| 0),
            Ok(formatted) if formatted != text => changed.push((path, formatted)),
            Ok(_) => {}
            Err(faults) => {
                only_limits &= faults.iter().all(Diagnostic::is_limit);
                messages.extend(rendered(&faults, &Source::new(path.display().to_string(), text)));
            }
        }
    }
    if !messages.is_empty() {
        return Err(Exit::faults(&messages, only_limits));
    }
    // From here on Ctrl-C takes effect only after the last file is written.
    let interrupt = Interrupt::listen();
    for (path, formatted) in &changed {
        print(&format!("{} {}\n", if check { "not formatted:" } else { "formatted" }, path.display()))?;
        if !check {
            write_file(path, formatted)?;
        }
    }
    if interrupt.asked() {
        return Err(interrupted("everything is written"));
    }
    Ok(u8::from(check && !changed.is_empty()))
}
