//! One claim with its whole proof in words, for `carom explain`.

use super::latex::{code, escape};
use super::{Entry, counted, markdown, proof, statement, visible};
use crate::claim::print::{self, Style};
use crate::claim::syntax::{Claim, Expr, ExprKind, Item, Relation};
use crate::explain;
use crate::refute::outcome::{Broken, Point, Remaining, Verdict};

/// As text, with Unicode signs, wrapped to so many columns.
pub fn text(entry: &Entry, width: usize) -> String {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let mut out = format!("{}  {}\n", claim.name.text, visible(&claim.title));
    if let Some(source) = &claim.source {
        out.push_str(&format!("{}\n", visible(source)));
    }
    out.push('\n');
    for line in statement(claim, Style::Unicode) {
        out.push_str(&explain::text::paragraph(&line, 2, 6, width));
    }
    let read = as_read(claim);
    if !read.is_empty() {
        out.push_str("\nAs the kernel reads it\n");
    }
    for line in read {
        out.push_str(&explain::text::paragraph(&line, 2, 6, width));
    }
    out.push_str(&format!("\n{}", outcome.verdict.name()));
    if !outcome.method.is_empty() {
        out.push_str(&format!(" ({})", outcome.method));
    }
    out.push('\n');
    if let Some(document) = &entry.explained {
        out.push_str(&format!("\nProof\n{}", explain::text::text(document, 2, width)));
    }
    for (title, lines) in remarks(entry) {
        out.push_str(&format!("\n{title}\n"));
        for line in lines {
            out.push_str(&explain::text::paragraph(&visible(&line), 2, 4, width));
        }
    }
    out
}

/// The paragraphs after the statement, each with its title: where it fails, why it is undecided and what would help, the
/// hypotheses used, a point that satisfies the hypotheses, and the notes.
pub fn remarks(entry: &Entry) -> Vec<(&'static str, Vec<String>)> {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let mut out = Vec::new();
    let at = |point: &Point| point.in_words(claim).join(", ");
    if let Some(witness) = &outcome.witness {
        let mut lines = vec![at(&witness.point)];
        lines.extend(witness.broken.iter().map(fails));
        if entry.proof.is_none() {
            lines.push("Both sides were evaluated exactly; there is no certificate.".to_string());
        }
        out.push(("It fails at", lines));
    }
    if outcome.verdict == Verdict::Undecided {
        out.push(("Why it is undecided", outcome.reason.iter().cloned().collect()));
        out.push(("What remained", outcome.remaining.iter().map(remained).collect()));
        out.push(("What was tried", tried(entry)));
        out.push(("What would help", help(entry)));
    }
    if outcome.verdict == Verdict::Refuted {
        out.push(("Why it is refuted", outcome.reason.iter().cloned().collect()));
    }
    if outcome.verdict == Verdict::Proved {
        out.push(("Beside the proof", outcome.reason.iter().cloned().collect()));
    }
    out.push(("Used", outcome.used.clone()));
    out.push(("Not needed", outcome.unused.clone()));
    out.push(("The hypotheses hold, for instance, at", outcome.sample.iter().map(at).collect()));
    out.push(("Notes", claim.notes.clone()));
    out.retain(|r| !r.1.is_empty());
    out
}

/// What fails at a point, with the values of both sides if it has two.
fn fails(broken: &Broken) -> String {
    match broken.right.as_str() {
        "" => broken.statement.clone(),
        right => format!("{}: left side {}, right side {right}", broken.statement, broken.left),
    }
}

/// A goal that remained, with what is not known of it.
fn remained(goal: &Remaining) -> String {
    match goal.open.as_slice() {
        [] => goal.goal.clone(),
        [one] => format!("{}: the sign of {one} is not known.", goal.goal),
        several => format!("{}: the signs of these are not known: {}.", goal.goal, several.join("; ")),
    }
}

/// What was tried for an undecided claim.
fn tried(entry: &Entry) -> Vec<String> {
    let mut out = Vec::new();
    if !entry.claim.proof.is_empty() {
        out.push("The claim's own argument was tried, and the automatic methods without it.".to_string());
    }
    let mut methods: Vec<&str> = Vec::new();
    for name in entry.outcome.remaining.iter().flat_map(|r| &r.tried) {
        if !methods.contains(name) {
            methods.push(name);
        }
    }
    match (methods.first(), entry.outcome.limit) {
        (Some(_), Some("time")) => {
            out.push(format!("These methods, until the time ended at the last: {}.", methods.join(", ")));
        }
        (Some(_), _) => out.push(format!("These methods: {}.", methods.join(", "))),
        (None, _) => {}
    }
    let (held, open) = (entry.outcome.points, entry.outcome.open);
    let points = counted(held + open, "point");
    out.push(match (held, open) {
        (0, _) => "No point was found at which both sides could be compared.".to_string(),
        (_, 0) => format!("No counterexample was found at {points}; `carom test` tries more."),
        _ => format!(
            "No counterexample was found at {points}, and {open} of them decide nothing; `carom test` tries more."
        ),
    });
    out
}

/// Steps that the author could add to an undecided claim.
fn help(entry: &Entry) -> Vec<String> {
    if entry.outcome.limit.is_some() {
        return Vec::new();
    }
    let claim = &entry.claim;
    let mut out = Vec::new();
    let naturals = claim.items.iter().flat_map(|item| match item {
        Item::Given(bindings) => bindings.iter().filter(|b| b.natural).flat_map(|b| &b.names).collect::<Vec<_>>(),
        _ => Vec::new(),
    });
    if let Some((name, _)) = naturals.into_iter().find(|(_, index)| index.is_none()) {
        out.push(format!("Try an induction: write `by induction on {}` after the goal.", name.text));
    }
    if let Some((a, relation, b)) = claim.written_goal().single()
        && !matches!(relation, Relation::NotEqual)
    {
        let minus = |e: &Expr| match &e.kind {
            ExprKind::Sum(_) | ExprKind::Negate(_) => format!("({})", Style::Text.expr(e)),
            _ => Style::Text.expr(e),
        };
        out.push(format!(
            "Write the difference as a product or sum of terms of obvious sign: `have split: {} - {} = …`.",
            Style::Text.expr(a),
            minus(b)
        ));
    }
    out.push("Add a `have` for each step that you would write on paper, and a `case` for each case.".to_string());
    out
}

/// The proof in words as lines, each with its depth of indentation. For a refuted claim: the point and what fails there, each
/// with the kind of line. For an undecided claim: the reason.
pub fn lines(entry: &Entry) -> Vec<(usize, &'static str, String)> {
    match &entry.explained {
        Some(document) => explain::text::lines(document).into_iter().map(|(depth, text)| (depth, "", text)).collect(),
        None => {
            let (witness, reason) = (entry.outcome.witness.as_ref(), entry.outcome.reason.as_ref());
            let place = witness.map(|witness| (0, "witness", witness.point.in_words(&entry.claim).join(", ")));
            let broken = witness.iter().flat_map(|w| &w.broken).map(|b| (1, "witness", fails(b)));
            place.into_iter().chain(broken).chain(reason.map(|reason| (0, "", reason.clone()))).collect()
        }
    }
}

/// As LaTeX, ready for a document with amsmath and graphicx.
pub fn latex(entry: &Entry) -> String {
    let outcome = &entry.outcome;
    let mut out = statement_latex(&entry.claim);
    out.push_str(&format!("\\noindent\\emph{{{}}}", outcome.verdict.name()));
    if !outcome.method.is_empty() {
        out.push_str(&format!(" ({})", escape(&outcome.method)));
    }
    out.push_str("\\par\n");
    if let Some(document) = &entry.explained {
        out.push_str("\\smallskip\\noindent\\textit{Proof}\\par\n");
        out.push_str(&proof::latex::latex(document));
    }
    for (title, lines) in remarks(entry) {
        if title == "Notes" {
            out.push_str(&format!("\n{{\\raggedright\\noindent Note: {}\\par}}\n", escape(&lines.join(" "))));
            continue;
        }
        let lines: Vec<String> = lines.iter().map(|l| code(l)).collect();
        out.push_str(&format!("\n{{\\raggedright\\noindent {title}: {}.\\par}}\n", lines.join("; ")));
    }
    out
}

/// The statement as the kernel reads it, with what each name that was made stands for; nothing where it is what the author wrote.
fn as_read(claim: &Claim) -> Vec<String> {
    let (said, read) = (statement(claim, Style::Unicode), print::statement_as_read(claim, Style::Unicode));
    if said == read {
        return Vec::new();
    }
    let made = claim.written.iter().flat_map(|written| &written.made);
    let stands_for =
        |(name, of): &(String, Expr)| format!("{} stands for {}", Style::Unicode.name(name), Style::Unicode.expr(of));
    made.map(stands_for).chain(read).collect()
}

/// Name, title, hypotheses and goal as LaTeX, with what each line is.
pub fn statement_latex(claim: &Claim) -> String {
    let mut out =
        format!("{}\\paragraph{{{}}} {}\n", proof::latex::MACROS, escape(&claim.name.text), escape(&claim.title));
    out.push_str(&clauses_latex(claim));
    out
}

/// Hypotheses and goal as LaTeX, each with its keyword: given, let, define, assume, prove.
pub(crate) fn clauses_latex(claim: &Claim) -> String {
    let mut out = String::new();
    let mut before = "";
    let clauses = claim.written_items().iter().map(|item| (word(item), Style::Latex.item(item)));
    for (word, math) in clauses.chain([("Prove", Style::Latex.prop(claim.written_goal()))]) {
        if word != before {
            out.push_str(&format!("\n\\noindent\\textit{{{word}}}\n"));
            before = word;
        }
        out.push_str(&proof::latex::formula("", &math));
    }
    out
}

/// The word for a clause.
fn word(item: &Item) -> &'static str {
    match item {
        Item::Given(_) => "Given",
        Item::Let { .. } => "Let",
        Item::Define { .. } => "Define",
        Item::Assume { .. } => "Assume",
    }
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
    if let Some(document) = &entry.explained {
        out.push_str(&format!("\n## Proof\n\n```text\n{}```\n", explain::text::text(document, 0, 100)));
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
