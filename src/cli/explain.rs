//! `carom explain`

use super::audit::load;
use super::{Exit, ExplainFormat, print};
use crate::judge::Settings;
use crate::prove::catalogue::Limits;
use crate::report::argument;
use std::path::PathBuf;

/// Runs the command.
pub fn run(id: &str, paths: &[PathBuf], format: ExplainFormat, limits: &Limits) -> Result<u8, Exit> {
    let only = [id.to_string()];
    let loaded = load(paths, &only)?;
    let settings = Settings { limits: limits.clone(), argument: true, ..Settings::default() };
    let Some((_, found)) = loaded.judge(&only, &settings).entries.pop() else {
        return Err(Exit::usage(format!("error: no claim is called {id}")));
    };
    let entry = found.map_err(|fault| loaded.failure(id, fault))?;
    print(&match format {
        ExplainFormat::Text => argument::text(&entry),
        ExplainFormat::Markdown => argument::markdown(&entry),
        ExplainFormat::Latex => argument::latex(&entry),
    })?;
    Ok(u8::from(!entry.as_expected()))
}
