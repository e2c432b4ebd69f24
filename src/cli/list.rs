//! `carom list`: the claims by name.

use super::audit::load;
use super::{Exit, ValueFormat};
use crate::claim::syntax::{Claim, Expectation};
use crate::refute::outcome::Verdict;
use crate::report::visible;
use serde_json::json;
use std::path::PathBuf;

/// The text that the command prints.
pub(super) fn run(paths: &[PathBuf], format: ValueFormat) -> Result<String, Exit> {
    let loaded = load(paths, &[])?;
    let claims = loaded.claims();
    Ok(match format {
        ValueFormat::Text => text(claims),
        ValueFormat::Json => {
            let list: Vec<serde_json::Value> = claims.iter().map(row).collect();
            serde_json::to_string_pretty(&list).unwrap_or_default() + "\n"
        }
    })
}

fn expected(claim: &Claim) -> Verdict {
    match claim.expect {
        Expectation::Proved => Verdict::Proved,
        Expectation::Refuted => Verdict::Refuted,
        Expectation::Undecided => Verdict::Undecided,
    }
}

/// A line for each claim, the sections as headings.
fn text(claims: &[Claim]) -> String {
    let width = claims.iter().map(|c| c.name.text.chars().count()).max().unwrap_or(0);
    let mut out = String::new();
    let mut section = None;
    for claim in claims {
        if section != Some(&claim.section) {
            let gap = if section.is_some() { "\n" } else { "" };
            out += &format!("{gap}{}\n", visible(claim.section.as_deref().unwrap_or("Claims")));
            section = Some(&claim.section);
        }
        let expected = match expected(claim) {
            Verdict::Proved => String::new(),
            other => format!(" (expected: {})", other.name()),
        };
        let number = claim.number.as_ref().map_or(String::new(), |n| format!("({n})"));
        let name = &claim.name.text;
        out += &format!("  {name:width$}  {number:>5} {}{expected}\n", visible(&claim.title));
    }
    out
}

fn row(claim: &Claim) -> serde_json::Value {
    json!({
        "id": claim.name.text,
        "number": crate::report::number(claim),
        "title": claim.title,
        "section": claim.section,
        "source": claim.source,
        "expected": expected(claim).name(),
    })
}
