//! The report as Markdown.

use super::evidence::Evidence;
use super::numbers::WHAT_IS_CERTAIN;
use super::{Handout, STATED, address, certificate_of, coq_file, findings, named, plot_file, provenance, table_file};
use crate::report::argument;
use crate::report::markdown::{self, escape};
use crate::report::table::{Form, Writer};
use crate::report::{Entry, summary};

/// The report: counts, a table for each section, what could not be judged, then claim by claim, then the numbers.
pub(super) fn report(handout: &Handout) -> String {
    let s = summary(&handout.audit.entries);
    let mut out = format!(
        "# {}\n\n{}: {} proved, {} refuted, {} undecided; {} not as expected. {}\n",
        escape(&one_line(&handout.title)),
        handout.audit.count(),
        s.proved,
        s.refuted,
        s.undecided,
        s.unexpected,
        handout.vouched().join(" ")
    );
    let again = handout.again();
    if !again.is_empty() {
        out.push_str("\nTo check again, in this folder:\n\n");
        out.extend(again.iter().map(|(command, what)| format!("- `{command}`: {what}.\n")));
    }
    findings(&mut out, handout);
    markdown::sections(&mut out, &handout.audit);
    for (section, entries) in handout.audit.sections() {
        out.push_str(&format!("\n## {}, claim by claim\n", escape(&one_line(section))));
        for entry in entries {
            for paragraph in &entry.claim.prose {
                out.push_str(&format!("\n{}\n", escape(paragraph)));
            }
            claim(&mut out, entry, handout.evidence.get(&entry.claim.name.text));
        }
    }
    numbers(&mut out, handout);
    out
}

/// A text without line ends, which would end a heading.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn link(path: &str) -> String {
    format!("[{}]({})", escape(path), address(path))
}

fn findings(out: &mut String, handout: &Handout) {
    let list = findings::of(&handout.audit);
    if !list.is_empty() {
        out.push_str("\n## Findings\n\n| claim | finding | title | what was found |\n|---|---|---|---|\n");
    }
    for finding in list {
        let mut says: Vec<String> = finding.says.iter().map(|s| escape(&one_line(s))).collect();
        if let Some(at) = &finding.fails_at {
            says.push(escape(&format!("Fails at {}.", at.join(", "))));
        }
        let (name, title) = (escape(finding.name), escape(&one_line(finding.title)));
        out.push_str(&format!("| {name} | {} | {title} | {} |\n", finding.kind, says.join(" ")));
    }
}

fn claim(out: &mut String, entry: &Entry, evidence: Option<&Evidence>) {
    // Headings are two levels deeper than in the Markdown of a single claim; no line in a block of code begins with `#`.
    for line in argument::markdown(entry).lines() {
        let deeper = if line.starts_with("# ") || line.starts_with("## ") { "##" } else { "" };
        out.push_str(&format!("{}{deeper}{line}\n", if deeper.is_empty() { "" } else { "\n" }));
    }
    let Some(evidence) = evidence else { return };
    let marks: Vec<String> = evidence.marks(entry.outcome.verdict).iter().map(|m| format!("**{}**", m.0)).collect();
    if !marks.is_empty() {
        out.push_str(&format!("\n{}\n", marks.join(", ")));
    }
    let name = &entry.claim.name.text;
    if let Some(proof) = &evidence.kernel {
        out.push_str(&format!(
            "\nChecked by the kernel: {}, SHA-256 of the statement `{}`{}.\n",
            link(&certificate_of(name)),
            proof.statement,
            match proof.rests_on.as_slice() {
                [] => String::new(),
                list => format!("; rests on {}", escape(&list.join(", "))),
            }
        ));
    }
    match &evidence.coq {
        Ok(theorem) => out.push_str(&format!(
            "\nCoq: theorem `{}`, stated in {}, proved in {}.\n",
            theorem.name,
            link(&coq_file(STATED)),
            link(&coq_file(&theorem.module))
        )),
        Err(reason) => out.push_str(&format!("\nNot in Coq: {}.\n", escape(reason))),
    }
}

fn numbers(out: &mut String, handout: &Handout) {
    if !handout.tables.is_empty() || !handout.plots.is_empty() {
        out.push_str(&format!("\n## Numbers\n\n{WHAT_IS_CERTAIN}\n"));
    }
    for (place, table) in handout.tables.iter().enumerate() {
        let said: Vec<String> = provenance(handout, table).iter().map(|t| escape(t).replace("\\`", "`")).collect();
        out.push_str(&format!("\n### Table {}: {}\n\n{}.\n\n", place + 1, escape(table.title()), said.join(". ")));
        let mut writer = Writer::new(Form::Markdown, table.head.clone());
        let mut text = Vec::new();
        // Writing to memory cannot fail.
        let _ = writer.begin(&mut text);
        for row in &table.rows {
            let _ = writer.row(row.clone(), &mut text);
        }
        let _ = writer.end(&mut text);
        out.push_str(&String::from_utf8_lossy(&text));
        let (csv, certificate) = (link(&table_file(place, "csv")), link(&table_file(place, "jsonl")));
        out.push_str(&format!("\n`{}`: {csv}, certificate {certificate}\n", table.command.replace('`', "'")));
    }
    for (place, plot) in handout.plots.iter().enumerate() {
        let claims = escape(&named(handout, plot.claims)).replace("\\`", "`");
        out.push_str(&format!(
            "\n### Figure {}: {}\n\n![{}]({})\n\nThe formulas are those of {claims}.\n\n`{}`\n",
            place + 1,
            escape(&plot.title),
            escape(&plot.description),
            address(&plot_file(place, "svg")),
            plot.command.replace('`', "'"),
        ));
    }
}
