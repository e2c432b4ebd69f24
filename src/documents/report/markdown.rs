//! An audit as Markdown.

use super::{Audit, Entry, counted, reading, summary};
use crate::claim::print::Style;

/// The report: a table for each section, then what could not be judged.
pub fn report(audit: &Audit) -> String {
    let s = summary(&audit.entries);
    let mut out = format!(
        "# Audit\n\n{}: {} proved, {} refuted, {} undecided; {} not as expected{}.\n",
        audit.count(),
        s.proved,
        s.refuted,
        s.undecided,
        s.unexpected,
        if audit.problems.is_empty() { String::new() } else { format!("; {}", counted(audit.problems.len(), "error")) }
    );
    sections(&mut out, audit);
    out
}

/// A table for each section, then what could not be judged.
pub fn sections(out: &mut String, audit: &Audit) {
    for (section, entries) in audit.sections() {
        out.push_str(&format!(
            "\n## {}\n\n| claim | no. | verdict | reading | statement | remarks |\n|---|---|---|---|---|---|\n",
            escape(section)
        ));
        for entry in entries {
            row(out, entry);
        }
    }
    if !audit.problems.is_empty() {
        out.push_str("\n## Errors\n");
    }
    for problem in &audit.problems {
        out.push_str(&format!("\n{}\n\n```text\n{}\n```\n", escape(&problem.name), problem.message));
    }
}

fn row(out: &mut String, entry: &Entry) {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let mut remarks: Vec<String> = Vec::new();
    if let Some(witness) = &outcome.witness {
        let at = witness.point.in_words(&entry.claim);
        remarks.push(format!("fails at {}", at.join(", ")));
        remarks.extend(entry.proof.is_none().then(|| "evaluated, not certified".to_string()));
    }
    remarks.extend(outcome.reason.clone());
    remarks.extend(claim.notes.iter().cloned());
    let number = claim.number.as_deref().map_or(String::new(), escape);
    out.push_str(&format!(
        "| {} {} | {number} | {}{} | {} | `{}` | {} |\n",
        escape(&claim.name.text),
        escape(&claim.title),
        outcome.verdict.name(),
        if entry.as_expected() { "" } else { " (not as expected)" },
        reading(claim).unwrap_or_default(),
        entry.goal(Style::Unicode).replace('|', "\\|").replace('`', "'"),
        escape(&remarks.join("; ")),
    ));
}

/// Text that Markdown shows unchanged.
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
