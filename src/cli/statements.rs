//! `carom print`

use super::audit::load;
use super::{Exit, PrintFormat, load, print};
use crate::claim::print::{Style, statement};
use crate::claim::syntax::Claim;
use crate::report::argument::statement_latex;
use std::path::{Path, PathBuf};

/// Runs the command: the claims in the order in which they are named.
pub fn run(names: &[String], format: PrintFormat) -> Result<u8, Exit> {
    let mut claims: Vec<Claim> = Vec::new();
    if names.is_empty() {
        claims.extend_from_slice(load(&[], &[])?.catalogue.claims());
    }
    for name in names {
        if Path::new(name).exists() || name.contains('/') || name.ends_with(".claim") {
            claims.extend(load::claims(&load::files(&[PathBuf::from(name)])?)?.0);
        } else {
            let only = [name.clone()];
            claims.extend(load(&[], &only)?.catalogue.get(name).cloned());
        }
    }
    let text: Vec<String> = claims.iter().map(|claim| one(claim, format)).collect();
    print(&text.join("\n"))?;
    Ok(0)
}

fn one(claim: &Claim, format: PrintFormat) -> String {
    let style = match format {
        PrintFormat::Latex => return statement_latex(claim),
        PrintFormat::Text => Style::Text,
        PrintFormat::Unicode => Style::Unicode,
    };
    format!("claim {} \"{}\"\n{}\n", claim.name.text, claim.title, statement(claim, style).join("\n"))
}
