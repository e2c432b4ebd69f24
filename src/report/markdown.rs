//! An audit as Markdown.

use super::{Entry, reading, summary};
use crate::claim::print::Style;

/// The report: a table for each section.
pub fn report(entries: &[Entry]) -> String {
    let s = summary(entries);
    let mut out = format!(
        "# Audit\n\n{} claims: {} proved, {} refuted, {} undecided; {} not as expected.\n",
        entries.len(),
        s.proved,
        s.refuted,
        s.undecided,
        s.unexpected
    );
    let mut section = None;
    for entry in entries {
        let here = entry.claim.section.as_deref().unwrap_or("Claims");
        if section != Some(here) {
            out.push_str(&format!(
                "\n## {}\n\n| claim | no. | verdict | reading | statement | remarks |\n|---|---|---|---|---|---|\n",
                escape(here)
            ));
            section = Some(here);
        }
        let (claim, outcome) = (&entry.claim, &entry.outcome);
        let mut remarks: Vec<String> = Vec::new();
        if let Some(witness) = &outcome.witness {
            let at: Vec<String> = witness.point.values.iter().map(|(n, v)| format!("{n} = {v}")).collect();
            remarks.push(format!("fails at {}", at.join(", ")));
        }
        remarks.extend(outcome.reason.clone());
        remarks.extend(claim.notes.iter().cloned());
        let number = claim.number.map_or(String::new(), |n| n.to_string());
        out.push_str(&format!(
            "| {} {} | {number} | {}{} | {} | `{}` | {} |\n",
            escape(&claim.name.text),
            escape(&claim.title),
            outcome.verdict.name(),
            if entry.as_expected() { "" } else { " (not as expected)" },
            reading(claim),
            entry.goal(Style::Unicode).replace('|', "\\|").replace('`', "'"),
            escape(&remarks.join("; ")),
        ));
    }
    out
}

/// Text that Markdown shows as it stands.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if matches!(c, '|' | '*' | '_' | '`' | '<' | '>' | '[' | ']' | '\\' | '#') {
            out.push('\\');
        }
        out.push(c);
    }
    out
}
