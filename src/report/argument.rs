//! One claim with its whole argument, for `carom explain`.

use super::latex::{code, escape};
use super::{Entry, markdown, statement, visible};
use crate::claim::print::Style;
use crate::claim::syntax::Claim;
use crate::prove::outcome::Point;

/// As text, with Unicode signs.
pub fn text(entry: &Entry) -> String {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let mut out = format!("{}  {}\n", claim.name.text, visible(&claim.title));
    if let Some(source) = &claim.source {
        out.push_str(&format!("{}\n", visible(source)));
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
        out.push_str(&format!("\nNote: {}\n", visible(note)));
    }
    out
}

/// What follows the argument: where it fails, why it is undecided, what was used, a point where the
/// hypotheses hold, and the notes; each with its title.
pub fn remarks(entry: &Entry) -> Vec<(&'static str, Vec<String>)> {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let at = |point: &Point| point.values.iter().map(|(n, v)| format!("{n} = {v}")).collect::<Vec<_>>().join(", ");
    let mut out = Vec::new();
    if let Some(witness) = &outcome.witness {
        let mut lines = vec![at(&witness.point)];
        lines.extend(witness.broken.iter().map(|b| match b.right.as_str() {
            "" => b.statement.clone(),
            right => format!("{}: left side {}, right side {right}", b.statement, b.left),
        }));
        out.push(("It fails at", lines));
    }
    out.push(("Why it is undecided", outcome.reason.iter().cloned().collect()));
    out.push(("Used", outcome.used.clone()));
    out.push(("Not needed", outcome.unused.clone()));
    out.push(("The hypotheses hold, for instance, at", outcome.sample.iter().map(at).collect()));
    out.push(("Notes", claim.notes.clone()));
    out.retain(|r| !r.1.is_empty());
    out
}

/// As LaTeX, ready for a document with amsmath.
pub fn latex(entry: &Entry) -> String {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let mut out = statement_latex(claim);
    out.push_str(&format!("\\emph{{{}}}", outcome.verdict.name()));
    if !outcome.method.is_empty() {
        out.push_str(&format!(" ({})", escape(&outcome.method)));
    }
    out.push('\n');
    if !outcome.argument.is_empty() && outcome.witness.is_none() {
        // Lists nest four deep at most in LaTeX; a margin has no such limit.
        out.push_str("\\begin{itemize}\n");
        for line in &outcome.argument {
            out.push_str(&format!(
                "  \\item \\hspace*{{{}em}}\\textit{{{}}}: {}\n",
                2 * line.depth,
                escape(line.rule),
                code(&line.text)
            ));
        }
        out.push_str("\\end{itemize}\n");
    }
    for (title, lines) in remarks(entry) {
        if title == "Notes" {
            out.push_str(&format!("\nNote: {}\n", escape(&lines.join(" "))));
            continue;
        }
        let lines: Vec<String> = lines.iter().map(|l| code(l)).collect();
        out.push_str(&format!("\n{title}: {}.\n", lines.join("; ")));
    }
    out
}

/// Name, title, hypotheses and goal as LaTeX.
pub fn statement_latex(claim: &Claim) -> String {
    format!(
        "\\paragraph{{{}}} {}\n\\begin{{gather*}}\n{}\n\\end{{gather*}}\n",
        escape(&claim.name.text),
        escape(&claim.title),
        statement(claim, Style::Latex).join(" \\\\\n")
    )
}

/// As Markdown, the formulas in code so that every viewer shows them.
pub fn markdown(entry: &Entry) -> String {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let code = |text: &str| format!("`{}`", text.replace('`', "'"));
    let mut out = format!("# {}: {}\n", markdown::escape(&claim.name.text), markdown::escape(&claim.title));
    if let Some(source) = &claim.source {
        out.push_str(&format!("\n{}\n", markdown::escape(source)));
    }
    out.push_str(&format!(
        "\n```text\n{}\n```\n\n**{}**",
        statement(claim, Style::Unicode).join("\n"),
        outcome.verdict.name()
    ));
    if !outcome.method.is_empty() {
        out.push_str(&format!(" ({})", markdown::escape(&outcome.method)));
    }
    out.push('\n');
    if !outcome.argument.is_empty() && outcome.witness.is_none() {
        out.push_str("\n## Argument\n\n");
        for line in &outcome.argument {
            out.push_str(&format!(
                "{}- *{}*: {}\n",
                "  ".repeat(line.depth),
                markdown::escape(line.rule),
                code(&line.text)
            ));
        }
    }
    for (title, lines) in remarks(entry) {
        out.push_str(&format!("\n## {title}\n\n"));
        for line in lines {
            let line = if title == "Notes" { markdown::escape(&line) } else { code(&line) };
            out.push_str(&format!("- {line}\n"));
        }
    }
    out
}
