//! An audit as text, JSON, Markdown and JUnit, and as a folder to hand in; one claim's argument, the answers to a
//! scene, and a replay in words and pictures.

pub mod answers;
pub mod argument;
pub mod bounces;
pub mod comparison;
pub mod drop;
pub mod handout;
pub mod json;
pub(crate) mod latex;
pub mod markdown;
pub(crate) mod markup;
pub mod mathml;
pub mod plot;
pub(crate) mod proof;
pub mod referee;
pub mod replay;
pub mod table;
pub mod text;
pub mod theorems;
pub mod worksheet;

use crate::claim::print::{self, Style};
use crate::claim::syntax::{Claim, Reading};
pub use crate::judge::Entry;
use crate::refute::outcome::Verdict;
use serde_json::Value;
use std::borrow::Cow;

/// A claim, or a file of claims, that could not be judged.
pub struct Problem {
    /// The claim, or `claims` if it concerns no single claim.
    pub name: String,
    /// What is wrong, with its place; several lines.
    pub message: String,
}

/// An audit.
pub struct Audit {
    /// The judged claims, in the order of the catalogue.
    pub entries: Vec<Entry>,
    /// What could not be judged.
    pub problems: Vec<Problem>,
    /// How many claims were worked on, cited ones included.
    pub judged: usize,
}

impl Audit {
    /// The entries of each section, the sections in the order in which they first appear.
    pub fn sections(&self) -> Vec<(&str, Vec<&Entry>)> {
        let mut out: Vec<(&str, Vec<&Entry>)> = Vec::new();
        for entry in &self.entries {
            let here = section(entry);
            match out.iter_mut().find(|s| s.0 == here) {
                Some(section) => section.1.push(entry),
                None => out.push((here, vec![entry])),
            }
        }
        out
    }

    /// `84 claims`, `1 claim`.
    pub fn count(&self) -> String {
        counted(self.entries.len(), "claim")
    }
}

/// The section of a claim.
pub(crate) fn section(entry: &Entry) -> &str {
    entry.claim.section.as_deref().unwrap_or("Claims")
}

/// A number with its noun.
pub fn counted(number: usize, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}

/// Foreign text for a terminal: a character that is not visible, and could steer the terminal or turn the text around, is
/// shown by its number, as `\u{1b}`.
#[must_use]
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.contains(steers) {
        return Cow::Borrowed(text);
    }
    let shown = |c: char| if steers(c) { c.escape_unicode().to_string() } else { c.to_string() };
    Cow::Owned(text.chars().map(shown).collect())
}

/// The same for a text of several lines, whose ends stay.
#[must_use]
pub fn visible_lines(text: &str) -> Cow<'_, str> {
    if !text.contains(|c| c != '\n' && steers(c)) {
        return Cow::Borrowed(text);
    }
    Cow::Owned(text.split('\n').map(visible).collect::<Vec<_>>().join("\n"))
}

/// Control characters, ends of lines, and marks that change the direction of writing.
fn steers(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// A text filled up with spaces to so many characters, on its left or on its right. (The widths of `format!` end at
/// 65,535, and there are longer numbers.)
pub(crate) fn padded(text: &str, width: usize, to_the_right: bool) -> String {
    let mut out = String::new();
    push_padded(&mut out, text, width, to_the_right);
    out
}

/// The same at the end of a line.
pub(crate) fn push_padded(line: &mut String, text: &str, width: usize, to_the_right: bool) {
    let space = width.saturating_sub(if text.is_ascii() { text.len() } else { text.chars().count() });
    if !to_the_right {
        line.push_str(text);
    }
    line.extend(std::iter::repeat_n(' ', space));
    if to_the_right {
        line.push_str(text);
    }
}

/// The counts of an audit.
#[derive(Default, Clone, Copy)]
pub struct Summary {
    /// Claims proved.
    pub proved: usize,
    /// Claims refuted.
    pub refuted: usize,
    /// Claims undecided.
    pub undecided: usize,
    /// Claims whose verdict is not the expected one.
    pub unexpected: usize,
}

/// Counts the verdicts.
pub fn summary(entries: &[Entry]) -> Summary {
    let mut out = Summary::default();
    for entry in entries {
        match entry.outcome.verdict {
            Verdict::Proved => out.proved += 1,
            Verdict::Refuted => out.refuted += 1,
            Verdict::Undecided => out.undecided += 1,
        }
        out.unexpected += usize::from(!entry.as_expected());
    }
    out
}

/// `as printed`, `restored`, `extracted` or `beyond`, where the claim says it.
pub fn reading(claim: &Claim) -> Option<&'static str> {
    claim.reading.map(|reading| match reading {
        Reading::Printed => "as printed",
        Reading::Restored => "restored",
        Reading::Extracted => "extracted",
        Reading::Beyond => "beyond",
    })
}

/// The equation number for a program: a JSON number if possible, else the text in the source.
pub fn number(claim: &Claim) -> Value {
    let Some(text) = &claim.number else { return Value::Null };
    match text.parse::<u32>() {
        Ok(plain) if plain.to_string() == *text => plain.into(),
        _ => text.as_str().into(),
    }
}

/// Hypotheses and goal, one a line.
pub fn statement(claim: &Claim, style: Style) -> Vec<String> {
    print::statement(claim, style)
}
