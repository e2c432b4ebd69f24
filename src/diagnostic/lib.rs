//! Errors in claim files and scene files, and their messages.
//!
//! The code that detects an error makes a [`Fault`]. [`Diagnostic::render`] turns it into a message with file, line, column,
//! the source line and a caret. Only this file words these messages.

mod foreign;
mod source;

pub use foreign::{behind_a_statement, binds, domain, foreign};
pub use source::Source;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

/// A range of bytes in the source file, `start..end`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Hash)]
pub struct Span {
    /// First byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

/// A fault and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// What is wrong.
    pub fault: Fault,
    /// Where.
    pub span: Span,
}

/// The kinds of faults.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// Something else was expected.
    Expected {
        /// What would be right here.
        expected: String,
        /// What stands here.
        found: String,
        /// A hint.
        help: Option<String>,
    },
    /// A character that the language does not have.
    Stray(char),
    /// A text without its closing quotation mark.
    OpenText,
    /// A named limit.
    Limit {
        /// Its name.
        name: &'static str,
        /// Its value.
        allowed: usize,
    },
    /// A name that nothing declares.
    Undeclared {
        /// The name.
        name: String,
        /// The nearest name that is known there.
        nearest: Option<String>,
        /// Whether it is applied to arguments, as in `f(x)`.
        applied: bool,
        /// Whether it is declared further on.
        later: bool,
    },
    /// A name declared twice.
    Twice(String),
    /// A name `pi` where it is the number π.
    Pi,
    /// A claim's clause is missing.
    Missing {
        /// The claim.
        claim: String,
        /// The clause.
        clause: &'static str,
    },
    /// A file without a claim.
    Empty,
    /// Bytes that are no UTF-8.
    NotText,
    /// A claim that cites itself through others.
    Circular(Vec<String>),
    /// Any other fault, in words.
    Other {
        /// What is wrong.
        message: String,
        /// What would be right.
        help: Option<String>,
    },
}

impl Diagnostic {
    /// A fault at a place.
    pub fn new(fault: Fault, span: Span) -> Diagnostic {
        Diagnostic { fault, span }
    }

    /// The fault in one line.
    pub fn message(&self) -> String {
        match &self.fault {
            Fault::Expected { expected, found, .. } => format!("expected {expected}, found {found}"),
            Fault::Stray(c) => format!("the character {c:?} is not part of the language"),
            Fault::OpenText => "this text has no closing quotation mark".to_string(),
            Fault::Limit { name, allowed } => format!("limit reached: at most {allowed} {name}"),
            Fault::Undeclared { name, later: true, .. } => format!("the name {name} stands before its declaration"),
            Fault::Undeclared { name, .. } => format!("nothing declares the name {name}"),
            Fault::Twice(name) => format!("the name {name} is declared twice"),
            Fault::Pi => "pi is the number π, which nothing else may be called here".to_string(),
            Fault::Missing { claim, clause } => format!("claim {claim} has no `{clause}` clause"),
            Fault::Empty => "no claim found in this file".to_string(),
            Fault::NotText => "this is not UTF-8 text".to_string(),
            Fault::Circular(path) => format!("claims cite each other in a circle: {}", path.join(" -> ")),
            Fault::Other { message, .. } => message.clone(),
        }
    }

    /// Whether it is a limit of this program; the input may still be correct.
    pub fn is_limit(&self) -> bool {
        matches!(self.fault, Fault::Limit { .. })
    }

    /// What to write instead, if there is a suggestion.
    pub fn help(&self) -> Option<String> {
        match &self.fault {
            Fault::Expected { help, .. } | Fault::Other { help, .. } => help.clone(),
            Fault::Undeclared { name, applied: true, .. } if name.ends_with('\'') => {
                let of = name.trim_end_matches('\'');
                Some(format!("for a derivative write derivative({of}(x), x)"))
            }
            Fault::Undeclared { name, later: true, .. } => {
                Some(format!("declare {name} first, as b in `given b > 0; a > b`, or write a chain: `given a > b > 0`"))
            }
            Fault::Undeclared { name, nearest, applied, .. } => Some(match (foreign(name), nearest) {
                (Some(instead), _) => instead.to_string(),
                (None, Some(nearest)) => format!("did you mean {nearest}?"),
                (None, None) if *applied => {
                    format!(
                        "there is no such function; define it, as in `let {name}(x) = x^2`, or for a product write {name}*(…)"
                    )
                }
                (None, None) => format!("declare it, for instance `given {name} > 0` or `given {name} real`"),
            }),
            Fault::Empty => Some("a claim begins with: claim NAME \"Title\"".to_string()),
            Fault::Twice(_) => Some("a name has one meaning at a place: give one of the two another name".to_string()),
            Fault::Pi => Some("choose another name".to_string()),
            Fault::Missing { .. } => Some("add a line such as: prove a = b".to_string()),
            Fault::Stray(c) => foreign(c.encode_utf8(&mut [0; 4])).map(str::to_string),
            Fault::OpenText => Some("write the text on one line, between \"…\"".to_string()),
            Fault::NotText => Some("save the file as UTF-8".to_string()),
            _ => None,
        }
    }

    /// Line and column, both from 1, the column in characters.
    pub fn place(&self, source: &str) -> (usize, usize) {
        place(self.span, source)
    }

    /// The full message: file, line, column, source line with a caret, help.
    pub fn render(&self, file: &str, source: &str, colour: bool) -> String {
        let start = floor_boundary(source, self.span.start);
        let end = floor_boundary(source, self.span.end.max(start));
        // Of a very long line show only a part.
        let line_start = source[..start].rfind('\n').map_or(0, |i| i + 1);
        let line_end = source[start..].find('\n').map_or(source.len(), |i| start + i);
        let (line, column) = self.place(source);
        let message = self.message();
        let title = Level::ERROR.primary_title(message.as_str());
        let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
        let file_place = format!("{file}:{line}:{column}");
        let mut text = if line_end - line_start > 400 {
            let from = floor_boundary(source, start.saturating_sub(60).max(line_start));
            let to = floor_boundary(source, (start + 60).min(line_end));
            let annotation = AnnotationKind::Primary.span(start - from..(end.min(to)).max(start) - from);
            let snippet = Snippet::source(&source[from..to]).line_start(line).path(file).annotation(annotation);
            renderer.render(&[Group::with_title(title).element(snippet)])
        } else {
            let annotation = AnnotationKind::Primary.span(start..end.min(line_end).max(start));
            let snippet = Snippet::source(source).line_start(1).path(file).annotation(annotation);
            renderer.render(&[Group::with_title(title).element(snippet)])
        };
        if !text.contains(&file_place) && !colour {
            text.push_str(&format!("\n  at {file_place}"));
        }
        if let Some(help) = self.help() {
            text.push_str(&format!("\n  = help: {help}"));
        }
        text
    }
}

/// The line and the column at which a range of a text begins, both from 1, the column in characters.
fn place(span: Span, text: &str) -> (usize, usize) {
    let before = &text[..floor_boundary(text, span.start)];
    let line = before.matches('\n').count() + 1;
    (line, before.rsplit('\n').next().unwrap_or("").chars().count() + 1)
}

fn floor_boundary(text: &str, mut at: usize) -> usize {
    at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// The candidate nearest to a word, if it is near enough to be a typing error.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<String> {
    let limit = if word.chars().count() <= 3 { 1 } else { 2 };
    candidates
        .into_iter()
        .map(|c| (distance(word, c), c))
        .filter(|(d, _)| *d <= limit)
        .min()
        .map(|(_, c)| c.to_string())
}

/// The number of insertions, deletions and exchanges between two words.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut corner = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let above = row[j + 1];
            row[j + 1] = (corner + usize::from(x != *y)).min(above + 1).min(row[j] + 1);
            corner = above;
        }
    }
    row[b.len()]
}
