//! `carom fmt`: one way to write a claim file.
//!
//! Contract: the tree stays the same, comments and line breaks stay, and formatting twice changes
//! nothing more. Only the spaces within lines, indentation, trailing spaces and runs of blank lines
//! are changed.

use super::diagnostic::Diagnostic;
use super::lex::{Kind, tokens};
use super::parse::{CLAUSES, clauses};
use super::preamble::Preamble;

/// Words that begin a line at the margin.
const MARGIN: &[&str] = CLAUSES;

/// The formatted source.
///
/// # Errors
/// The faults of a file that does not parse.
pub fn format(source: &str) -> Result<String, Vec<Diagnostic>> {
    clauses(source, &Preamble::default())?;
    let mut out = String::new();
    let mut blank = true;
    let mut depth = 0usize;
    for line in source.lines() {
        let (code, comment) = split_comment(line);
        let code = code.trim();
        if code.is_empty() && comment.is_empty() {
            if !blank {
                out.push('\n');
            }
            blank = true;
            continue;
        }
        blank = false;
        let text = spaced(code);
        let first = text.split([' ', ':']).next().unwrap_or("");
        let closing = text.starts_with('}');
        let indent = if depth == 0 && (MARGIN.contains(&first) || closing || code.is_empty()) {
            0
        } else if depth == 0 {
            4
        } else {
            let step = ["have", "case", "obtain", "conclude", "by", "}"].contains(&first) || closing || code.is_empty();
            2 * (depth - usize::from(closing)) + if step && first != "by" { 0 } else { 2 }
        };
        out.push_str(&" ".repeat(indent));
        out.push_str(&text);
        if !comment.is_empty() {
            if !text.is_empty() {
                out.push_str("  ");
            }
            out.push_str(comment.trim_end());
        }
        out.push('\n');
        depth = (depth + text.matches('{').count()).saturating_sub(text.matches('}').count());
        if text.starts_with('"') || text.contains('"') {
            // Braces inside texts do not nest.
            let inside: String = text.split('"').skip(1).step_by(2).collect();
            depth = (depth + inside.matches('}').count()).saturating_sub(inside.matches('{').count());
        }
    }
    while out.ends_with("\n\n") {
        out.pop();
    }
    Ok(out)
}

/// A line's code and its comment.
fn split_comment(line: &str) -> (&str, &str) {
    let mut inside = false;
    for (at, c) in line.char_indices() {
        match c {
            '"' => inside = !inside,
            '#' if !inside => return line.split_at(at),
            _ => {}
        }
    }
    (line, "")
}

/// The tokens of a line with the usual spaces between them.
fn spaced(code: &str) -> String {
    let (list, _) = tokens(code);
    let mut out = String::new();
    // The end of the token before, and whether it ends an operand.
    let mut before: Option<(Kind, usize)> = None;
    // After this sign, a minus or a bar that opens, no space is wanted.
    let (mut opening, mut closed_bar) = (false, false);
    for token in list {
        if token.kind == Kind::End {
            break;
        }
        let text = &code[token.span.start..token.span.end];
        let operand_before = closed_bar || before.as_ref().is_some_and(|(k, _)| ends_operand(k));
        let space = match (&before, &token.kind) {
            (None, _) => "",
            _ if opening => "",
            (Some((Kind::Sign("(" | "[" | "√"), _)), _) => "",
            (_, Kind::Raised(_) | Kind::Sign(")" | "]" | "," | ";" | ":" | "!")) => "",
            (_, Kind::Sign("|")) if operand_before => "",
            (Some((Kind::Sign(";"), _)), _) => "  ",
            (Some((Kind::Sign("^" | "*" | "/" | ".."), _)), _) => "",
            (_, Kind::Sign("^" | "*" | "/" | "..")) => "",
            (Some((Kind::Word(_), end)), Kind::Sign("(")) if *end == token.span.start => "",
            (Some((Kind::Sign(")"), _)), Kind::Sign("(")) => " ",
            _ => " ",
        };
        out.push_str(space);
        out.push_str(text);
        opening = matches!(token.kind, Kind::Sign("-" | "|")) && !operand_before;
        closed_bar = token.kind == Kind::Sign("|") && operand_before;
        before = Some((token.kind, token.span.end));
    }
    out
}

fn ends_operand(kind: &Kind) -> bool {
    const WORDS: &[&str] = &[
        "by", "is", "at", "over", "of", "and", "or", "not", "given", "assume", "prove", "in", "to", "weight",
        "between", "with",
    ];
    match kind {
        Kind::Word(w) => !WORDS.contains(&w.as_str()),
        Kind::Number(_) | Kind::Raised(_) | Kind::Text(_) => true,
        Kind::Sign(s) => matches!(*s, ")" | "]" | "}" | "!"),
        Kind::End => false,
    }
}
