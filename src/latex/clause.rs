//! The clauses of one equation: what it is, and what is said of it.

use super::comment::{clause, first_word};
use super::document::Clause;
use super::name::Names;
use super::place::Placed;
use super::refusal::{expected, refused};
use super::scope::Decisions;
use carom_checker::claim::parse::begins_clause;
use carom_diagnostic::{Diagnostic, Span};

/// Words that begin a clause in a comment, besides those of the claim language.
const VERBS: &[&str] =
    &["name", "skip", "comma", "pm", "digits", "e", "log", "inline", "begin", "end", "continues", "begins", "by"];

/// What an equation is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Purpose {
    /// A claim.
    Prove,
    /// A hypothesis of all that follow, perhaps with a label.
    Assume(Option<String>),
    /// A definition for all that follow.
    Let,
    /// The author passes it over, for this reason.
    Skip(String),
}

/// What the comments of an equation say.
pub(crate) struct Said {
    /// What the equation is.
    pub purpose: Purpose,
    /// `claim NAME "Title"`
    pub name: Option<Placed>,
    /// Whether the comment gives the equation's number.
    pub has_number: bool,
    /// Clauses such as `source` and `using`.
    pub about: Vec<Placed>,
    /// Declarations and hypotheses, in order.
    pub items: Vec<Placed>,
    /// The statement in the claim language, where the comment says it.
    pub statement: Option<Placed>,
    /// The argument.
    pub proof: Option<Placed>,
    /// `expect`
    pub expect: Option<Placed>,
    /// What is decided.
    pub decisions: Decisions,
}

/// Clauses with the lines that continue them.
pub(crate) fn whole(clauses: &[Clause]) -> Vec<(String, Vec<Clause>)> {
    let mut out: Vec<(String, Vec<Clause>)> = Vec::new();
    for clause in clauses {
        let word = first_word(&clause.text);
        match out.last_mut() {
            Some((_, lines)) if !begins_clause(word) && !VERBS.contains(&word) && !clause.text.starts_with('{') => {
                lines.push(clause.clone());
            }
            _ => out.push((word.to_string(), vec![clause.clone()])),
        }
    }
    out
}

/// The lines of a clause in the claim language.
pub(crate) fn read(lines: &[Clause], names: &mut Names) -> Result<Placed, Diagnostic> {
    let mut out = Placed::default();
    for (place, line) in lines.iter().enumerate() {
        if place > 0 {
            out.push("\n    ", line.span);
        }
        out.append(&clause(&line.text, line.span, names)?);
    }
    Ok(out)
}

/// `comma and`, `pm or`, `e is base`: whether the clause decides something.
pub(crate) fn decides(lines: &[Clause], decisions: &mut Decisions) -> Result<bool, Diagnostic> {
    let Some(first) = lines.first() else { return Ok(false) };
    let words: Vec<&str> = first.text.split_whitespace().collect();
    match words.as_slice() {
        ["comma", "and"] => decisions.comma_is_and = Some(true),
        ["comma", "if"] => decisions.comma_is_and = Some(false),
        ["pm", word @ ("and" | "or")] => {
            (decisions.both_signs, decisions.is_measured) = (Some(*word == "and"), Some(false));
        }
        ["pm", "interval"] => decisions.is_measured = Some(true),
        ["digits", count] if count.parse::<usize>().is_ok_and(|count| (1..=100).contains(&count)) => {
            decisions.digits = count.parse().ok();
        }
        ["e", "is", "base"] => decisions.e_is_base = true,
        ["log", "is", word @ ("natural" | "decimal")] => decisions.log_is_natural = Some(*word == "natural"),
        ["log", ..] => {
            return Err(expected("`log is natural` or `log is decimal`", "something else", first.span));
        }
        ["comma" | "pm", ..] => {
            let wanted = "`and` or `if` behind comma; `and`, `or` or `interval` behind pm";
            return Err(expected(wanted, "something else", first.span));
        }
        ["digits", ..] => {
            return Err(expected("a number from 1 to 100, as in `digits 3`", "something else", first.span));
        }
        ["e", ..] => return Err(expected("`e is base`", "something else", first.span)),
        _ => return Ok(false),
    }
    Ok(true)
}

/// What the comments of an equation say.
///
/// # Errors
/// A clause that is not read.
pub(crate) fn of(clauses: &[Clause], decisions: Decisions, names: &mut Names) -> Result<Said, Diagnostic> {
    let mut out = Said {
        purpose: Purpose::Prove,
        name: None,
        has_number: false,
        about: Vec::new(),
        items: Vec::new(),
        statement: None,
        proof: None,
        expect: None,
        decisions,
    };
    for (word, lines) in whole(clauses) {
        let Some(first) = lines.first() else { continue };
        let rest = first.text[word.len()..].trim();
        if decides(&lines, &mut out.decisions)? {
            continue;
        }
        match word.as_str() {
            "skip" => out.purpose = Purpose::Skip(rest.to_string()),
            "continues" | "begins" => {}
            "name" => super::comment::rename(first, names)?,
            "let" if rest.is_empty() => out.purpose = Purpose::Let,
            "assume" if rest.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') && lines.len() == 1 => {
                out.purpose = Purpose::Assume(Some(rest.to_string()).filter(|label| !label.is_empty()));
            }
            "prove" if rest.is_empty() && lines.len() == 1 => {}
            "prove" | "by" | "" => {
                let text = read(&lines, names)?;
                let start = if word == "prove" { "prove".len() } else { 0 };
                let said = text.text()[start..].trim_start();
                let is_argument = said.starts_with('{') || said.starts_with("by ");
                let part = tail(&text, text.text().len() - said.len());
                if is_argument { out.proof = Some(part) } else { out.statement = Some(part) }
            }
            "claim" => out.name = Some(read(&lines, names)?),
            "expect" => out.expect = Some(read(&lines, names)?),
            "given" | "let" | "define" | "assume" => out.items.push(read(&lines, names)?),
            "number" | "source" | "section" | "reading" | "note" | "using" | "sample" => {
                out.has_number |= word == "number";
                out.about.push(read(&lines, names)?);
            }
            _ => return Err(misplaced(&word, first.span)),
        }
    }
    Ok(out)
}

/// A clause that does not belong where it stands.
pub(crate) fn misplaced(word: &str, span: Span) -> Diagnostic {
    let help = "in an equation: given, let, define, assume, prove, skip, claim, number, note, using, by, expect, digits; before the \
                equations: paper, source, section, given, let, define, assume, name, begin, end";
    let what =
        if word.is_empty() { "this comment is no clause".to_string() } else { format!("`{word}` is no clause here") };
    refused(what, help, span)
}

/// The end of a text from a byte on.
fn tail(text: &Placed, from: usize) -> Placed {
    let mut out = Placed::default();
    let mut at = from;
    // One part for each sign keeps every place.
    for (i, c) in text.text()[from..].char_indices() {
        let end = from + i + c.len_utf8();
        out.push(&text.text()[at..end], text.place(Span { start: at, end }));
        at = end;
    }
    out
}
