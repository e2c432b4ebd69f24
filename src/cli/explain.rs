//! `carom explain`

use super::audit::load_for;
use super::{Exit, ExplainFormat};
use crate::judge::Settings;
use crate::refute::catalogue::Limits;
use crate::report::argument;
use std::path::PathBuf;

/// The text that the command prints, and its exit code.
pub(super) fn run(id: &str, paths: &[PathBuf], format: ExplainFormat, limits: &Limits) -> Result<(String, u8), Exit> {
    let only = [id.to_string()];
    let loaded = load_for(paths, id)?.with_certificates(false)?;
    let settings = Settings { limits: limits.clone(), argument: true, ..Settings::default() };
    let Some((_, found)) = loaded.judge(&only, &settings).entries.pop() else {
        return Err(Exit::usage(format!("error: no claim is called {id}")));
    };
    let entry = found.map_err(|fault| loaded.failure(id, fault))?;
    let text = match format {
        ExplainFormat::Text => argument::text(&entry, width()),
        ExplainFormat::Markdown => argument::markdown(&entry),
        ExplainFormat::Latex => argument::latex(&entry),
    };
    Ok((text, u8::from(!entry.as_expected())))
}

/// The columns of the terminal, at most as many as are read with ease; the same for a file.
fn width() -> usize {
    const WIDEST: usize = 100;
    super::terminal::width().map_or(WIDEST, |columns| columns.clamp(40, WIDEST))
}
