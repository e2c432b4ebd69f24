//! `carom print`

use super::audit::load;
use super::{Exit, PrintFormat, load};
use crate::claim::print::{Style, statement};
use crate::claim::syntax::Claim;
use crate::latex::is_paper;
use crate::report::argument::statement_latex;
use std::path::{Path, PathBuf};

/// The text of the claims, in the order in which they are named.
pub(super) fn run(names: &[String], format: PrintFormat) -> Result<String, Exit> {
    let mut claims: Vec<Claim> = Vec::new();
    if names.is_empty() {
        claims.extend_from_slice(load(&[], &[])?.catalogue.claims());
    }
    for name in names {
        if name == "-"
            || Path::new(name).exists()
            || name.contains('/')
            || name.ends_with(".claim")
            || is_paper(Path::new(name))
        {
            claims.extend(load::claims(&load::files(&[PathBuf::from(name)])?).whole()?.claims);
        } else {
            let only = [name.clone()];
            claims.extend(load(&[], &only)?.catalogue.get(name).cloned());
        }
    }
    let text: Vec<String> = claims.iter().map(|claim| one(claim, format)).collect();
    Ok(text.join("\n"))
}

/// The statement of a claim under its name.
pub(super) fn one(claim: &Claim, format: PrintFormat) -> String {
    let style = match format {
        PrintFormat::Latex => return statement_latex(claim),
        PrintFormat::Text => Style::Text,
        PrintFormat::Unicode => Style::Unicode,
    };
    format!("claim {} \"{}\"\n{}\n", claim.name.text, claim.title, statement(claim, style).join("\n"))
}
