//! Errors in claim files and scene files, and their messages.
//!
//! The code that detects an error makes a [`Fault`]. [`Diagnostic::render`] turns it into a message with file, line, column,
//! the source line and a caret. Only this file words these messages.

mod source;

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
            Fault::Undeclared { name, nearest, applied } => {
                Some(match nearest.as_ref().filter(|_| instead(name).is_none()) {
                    Some(nearest) => format!("did you mean {nearest}?"),
                    None if instead(name).is_some() => instead(name).unwrap_or_default().to_string(),
                    None if *applied => {
                        format!(
                            "there is no such function; define it, as in `let {name}(x) = x^2`, or for a product write {name}*(…)"
                        )
                    }
                    None => format!("declare it, for instance `given {name} > 0` or `given {name} real`"),
                })
            }
            Fault::Empty => Some("a claim begins with: claim NAME \"Title\"".to_string()),
            Fault::Pi => Some("choose another name".to_string()),
            Fault::Missing { .. } => Some("add a line such as: prove a = b".to_string()),
            Fault::Stray(c) => match c {
                '.' => Some("write a digit before the decimal point, as in 0.5; a range is 1..n".to_string()),
                '\\' => Some(
                    "in a claim file write sqrt(x), a/b, x^2, <=; a paper in LaTeX is read from a file that ends in .tex"
                        .to_string(),
                ),
                '≈' => Some("write the bound that is meant, as in |x - 0.543| <= 0.0005".to_string()),
                '±' | '∓' => Some(
                    "write both statements, one with + and one with -; a measured value is an interval: `given x in [57.0, 57.2]`"
                        .to_string(),
                ),
                '%' => Some("a comment begins with #; a percentage is a decimal, as in 0.05".to_string()),
                '∫' => Some(INTEGRAL.to_string()),
                '∂' => Some("write derivative(f, x)".to_string()),
                '∑' => Some("write sum(i = 1..n, x)".to_string()),
                '∏' => Some("write product(i = 1..n, x)".to_string()),
                '°' => Some("write an angle with pi: 30° is pi/6".to_string()),
                '&' => Some("write `and`".to_string()),
                '{' | '}' => Some("group with parentheses: (…)".to_string()),
                _ => None,
            },
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

/// How an integral is written.
const INTEGRAL: &str =
    "write integral(x = a..b, f) for a definite integral; for an indefinite one say derivative(F, x) = f";

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

/// What to write instead of a word that other languages have and this one does not.
fn instead(name: &str) -> Option<&'static str> {
    const COMPLEX: &str = "there are no complex numbers; declare the real and the imaginary part: `given x, y real`";
    Some(match name {
        "cot" => "write cos(x)/sin(x)",
        "sec" => "write 1/cos(x)",
        "csc" => "write 1/sin(x)",
        "asin" => "write arcsin(x)",
        "acos" => "write arccos(x)",
        "atan" => "write arctan(x)",
        "atan2" => "write arctan(y/x), with the case x > 0 in a hypothesis",
        "arccot" | "acot" => "write pi/2 - arctan(x)",
        "log" => "write the natural logarithm as ln(x), the logarithm to base b as ln(x)/ln(b)",
        "lg" | "log10" => "write ln(x)/ln(10)",
        "log2" | "lb" => "write ln(x)/ln(2)",
        "coth" => "write 1/tanh(x)",
        "csch" => "write 1/sinh(x)",
        "arcosh" | "acosh" => "write ln(x + sqrt(x^2 - 1))",
        "arsinh" | "asinh" => "write ln(x + sqrt(x^2 + 1))",
        "artanh" | "atanh" => "write ln((1 + x)/(1 - x))/2",
        "sgn" | "sign" => "write x/|x| where x != 0",
        "mod" => "declare the quotient and the remainder: `given q natural; r in 0..6` and `assume n = 7*q + r`",
        "int" | "integrate" | "Integrate" => INTEGRAL,
        "e" => "for the base of exponentials write exp(x), for a restitution declare it: `given e in [0, 1]`",
        "diff" | "Derivative" | "D" => "write derivative(f, x)",
        "O" | "o" => "there is no O(…); state a bound with a constant, such as |f - g| <= C*h^2 for h in (0, 1)",
        "Re" | "Im" | "conj" => COMPLEX,
        "tr" => "write trace(M)",
        "inv" => "write inverse(M)",
        "choose" | "binom" => "write binomial(n, k)",
        _ => return None,
    })
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
