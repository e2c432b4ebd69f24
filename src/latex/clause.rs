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
const VERBS: &[&str] = &[
    "name",
    "skip",
    "comma",
    "pm",
    "digits",
    "e",
    "d",
    "product",
    "remark",
    "log",
    "inline",
    "begin",
    "end",
    "continues",
    "begins",
    "by",
];

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
    /// Whether a comment says that it is a claim.
    pub is_claim: bool,
    /// What is decided.
    pub decisions: Decisions,
}

/// Clauses with the lines that continue them; a word of a paper's own comments has one line, but for a reason or an argument.
pub(crate) fn whole(clauses: &[Clause]) -> Vec<(String, Vec<Clause>)> {
    let mut out: Vec<(String, Vec<Clause>)> = Vec::new();
    for clause in clauses {
        let word = first_word(&clause.text);
        match out.last_mut() {
            Some((before, lines))
                if !(begins_clause(word)
                    || VERBS.contains(&word)
                    || clause.text.starts_with('{')
                    || word.starts_with("carom"))
                    && (["skip", "by"].contains(&before.as_str()) || !VERBS.contains(&before.as_str())) =>
            {
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
        ["remark"] => decisions.has_remarks = true,
        ["d", "is", "number"] => decisions.d_is_number = true,
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
        ["remark", ..] => return Err(expected("the end of this clause", "something else", first.span)),
        ["d", ..] => return Err(expected("`d is number`", "something else", first.span)),
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
        is_claim: false,
        decisions,
    };
    let mut purpose = None;
    for (word, lines) in whole(clauses) {
        let Some(first) = lines.first() else { continue };
        let rest = first.text[word.len()..].trim();
        if decides(&lines, &mut out.decisions)? {
            continue;
        }
        out.is_claim |= ["claim", "expect", "prove", "by", "using", ""].contains(&word.as_str());
        let once = |slot: &mut Option<Placed>, said: Placed| match slot.replace(said) {
            None => Ok(()),
            Some(_) => {
                Err(refused(format!("`{word}` is said twice of one equation"), "leave one of them out", first.span))
            }
        };
        let mut is = |what: Purpose| match purpose.replace(what) {
            None => Ok(()),
            Some(_) => Err(refused("comments say twice what this equation is", "leave one of them out", first.span)),
        };
        match word.as_str() {
            "skip" => {
                let more = lines[1..].iter().map(|line| format!(" {}", line.text));
                is(Purpose::Skip(rest.to_string() + &more.collect::<String>()))?;
            }
            "continues" | "begins" if rest.is_empty() => {}
            "name" => super::comment::rename(first, names)?,
            "product" if lines.len() == 1 => super::comment::factors(first, names)?,
            "let" if rest.is_empty() && lines.len() == 1 => is(Purpose::Let)?,
            "assume" if rest.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') && lines.len() == 1 => {
                is(Purpose::Assume(Some(rest.to_string()).filter(|label| !label.is_empty())))?;
            }
            "prove" if rest.is_empty() && lines.len() == 1 => {}
            "prove" | "by" | "" => {
                let text = read(&lines, names)?;
                let start = if word == "prove" { "prove".len() } else { 0 };
                let said = text.text()[start..].trim_start();
                let is_argument = said.starts_with('{') || said.starts_with("by ");
                let part = tail(&text, text.text().len() - said.len());
                once(if is_argument { &mut out.proof } else { &mut out.statement }, part)?;
            }
            "claim" => once(&mut out.name, read(&lines, names)?)?,
            "expect" => once(&mut out.expect, read(&lines, names)?)?,
            "given" | "let" | "define" | "assume" => out.items.push(read(&lines, names)?),
            "number" | "source" | "section" | "reading" | "note" | "using" | "sample" => {
                out.has_number |= word == "number";
                out.about.push(read(&lines, names)?);
            }
            _ => return Err(misplaced(&word, first.span)),
        }
    }
    out.purpose = purpose.unwrap_or(out.purpose);
    Ok(out)
}

impl Said {
    /// Nothing that is said of a claim may be said of what is none.
    ///
    /// # Errors
    /// Such a clause.
    pub(crate) fn of_no_claim(&self) -> Result<(), Diagnostic> {
        let statement = self.statement.iter().filter(|_| !matches!(self.purpose, Purpose::Assume(_)));
        let said = self.about.iter().chain(&self.proof).chain(&self.expect).chain(statement).next();
        let help = "leave this clause out, or write the equation once more as a claim";
        said.map_or(Ok(()), |said| Err(refused("a hypothesis or a definition is not proved", help, said.span())))
    }
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
