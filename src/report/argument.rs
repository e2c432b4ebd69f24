//! One claim with its whole argument, for `carom explain`.

use super::{Entry, statement};
use crate::claim::print::Style;

/// As text, with Unicode signs.
pub fn text(entry: &Entry) -> String {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let mut out = format!("{}  {}\n", claim.name.text, claim.title);
    if let Some(source) = &claim.source {
        out.push_str(&format!("{source}\n"));
    }
    out.push('\n');
    for line in statement(claim, Style::Unicode) {
        out.push_str(&format!("  {line}\n"));
    }
    out.push_str(&format!("\n{}", outcome.verdict.name()));
    if !outcome.method.is_empty() {
        out.push_str(&format!(" ({})", outcome.method));
    }
    out.push('\n');
    if let Some(reason) = &outcome.reason {
        out.push_str(&format!("  {reason}\n"));
    }
    if !outcome.argument.is_empty() {
        out.push_str("\nArgument\n");
        for line in &outcome.argument {
            out.push_str(&format!("  {}[{}] {}\n", "  ".repeat(line.depth), line.rule, line.text));
        }
    }
    for (title, list) in [("Used", &outcome.used), ("Not needed", &outcome.unused)] {
        if !list.is_empty() {
            out.push_str(&format!("\n{title}\n"));
            for item in list {
                out.push_str(&format!("  {item}\n"));
            }
        }
    }
    if let Some(sample) = &outcome.sample {
        let at: Vec<String> = sample.values.iter().map(|(n, v)| format!("{n} = {v}")).collect();
        out.push_str(&format!("\nThe hypotheses hold, for instance, at {}\n", at.join(", ")));
    }
    for note in &claim.notes {
        out.push_str(&format!("\nNote: {note}\n"));
    }
    out
}

/// As LaTeX, ready for a document with amsmath.
pub fn latex(entry: &Entry) -> String {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let mut out = format!("\\paragraph{{{}}} {}\n", escape(&claim.name.text), escape(&claim.title));
    out.push_str("\\begin{gather*}\n");
    let lines = statement(claim, Style::Latex);
    out.push_str(&format!("{}\n\\end{{gather*}}\n", lines.join(" \\\\\n")));
    out.push_str(&format!("\\emph{{{}}}", outcome.verdict.name()));
    if !outcome.argument.is_empty() {
        out.push_str("\n\\begin{enumerate}\n");
        for line in &outcome.argument {
            out.push_str(&format!("  \\item \\textit{{{}}}: \\texttt{{{}}}\n", line.rule, escape(&line.text)));
        }
        out.push_str("\\end{enumerate}");
    }
    out.push('\n');
    out
}

/// Text that LaTeX shows as it stands.
fn escape(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => {
                out.push('\\');
                out.push(c);
            }
            '^' => out.push_str("\\^{}"),
            '~' => out.push_str("\\~{}"),
            '\\' => out.push_str("\\textbackslash{}"),
            c => out.push(c),
        }
    }
    out
}
