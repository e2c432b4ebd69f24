//! `carom explain`

use super::audit::load;
use super::{Exit, ExplainFormat, print};
use crate::prove::catalogue::Limits;
use crate::report::{Entry, argument};
use std::path::PathBuf;

/// Runs the command.
pub fn run(id: &str, paths: &[PathBuf], format: ExplainFormat, limits: &Limits) -> Result<u8, Exit> {
    let only = [id.to_string()];
    let mut loaded = load(paths, &only)?;
    let outcome = loaded.judge(id, limits)?;
    let Some(claim) = loaded.catalogue.get(id).cloned() else {
        return Err(Exit::usage(format!("error: no claim is called {id}")));
    };
    let entry = Entry { claim, outcome, certificate: None };
    print(&match format {
        ExplainFormat::Text => argument::text(&entry),
        ExplainFormat::Markdown => argument::markdown(&entry),
        ExplainFormat::Latex => argument::latex(&entry),
    })?;
    Ok(u8::from(!entry.as_expected()))
}
