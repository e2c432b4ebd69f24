//! A proof in words for a terminal: Unicode, wrapped to a width, formulas on lines of their own.

use super::document::{Block, Document, Piece};
use crate::claim::print::Style;

/// The indentation of a formula against the sentences, and of a part under a supposition against the text around it.
const STEP: usize = 4;
/// The least width of a line, however deep it is nested.
const LEAST: usize = 40;

/// The proof with a left margin, each line at most this wide if a space allows it.
#[must_use]
pub fn text(document: &Document, margin: usize, width: usize) -> String {
    let mut out = String::new();
    blocks(&document.blocks, margin, width, &mut out);
    out
}

/// Text behind a margin, which is wider from the second line on.
#[must_use]
pub fn paragraph(text: &str, first: usize, rest: usize, width: usize) -> String {
    let mut out = String::new();
    wrapped(text, first, rest, width, &mut out);
    out
}

/// The proof as lines, each with its depth of nesting; 0 is the main argument.
#[must_use]
pub fn lines(document: &Document) -> Vec<(usize, String)> {
    let text = text(document, 0, usize::MAX);
    let deep = |line: &str| (line.len() - line.trim_start().len()) / STEP;
    text.lines().map(|line| (deep(line), line.trim_start().to_string())).collect()
}

fn blocks(list: &[Block], indent: usize, width: usize, out: &mut String) {
    for block in list {
        match block {
            Block::Sentence(pieces) => wrapped(&sentence(pieces), indent, indent, width, out),
            Block::Formula { prop, number, .. } => {
                let text = Style::Unicode.prop(prop);
                let tag = number.map_or(String::new(), |n| format!("({n})"));
                let lead = format!("{tag:<STEP$}{}", if tag.len() >= STEP { " " } else { "" });
                wrapped(&format!("{lead}{text}"), indent, indent + lead.chars().count() + 2, width, out);
            }
            Block::Inner(inner) => blocks(inner, indent + STEP, width, out),
        }
    }
}

/// A sentence on one line. The spaces of formulas are kept from breaking only where a line has room.
fn sentence(pieces: &[Piece]) -> String {
    pieces
        .iter()
        .map(|piece| match piece {
            Piece::Text(text) => text.clone(),
            Piece::Expr(e) => Style::Unicode.expr(e),
            Piece::Prop(p) | Piece::Fact(_, p) => Style::Unicode.prop(p),
            Piece::Number(n) => format!("({n})"),
        })
        .collect()
}

/// Text broken at spaces; a word that is wider than a line gets a line of its own.
fn wrapped(text: &str, first: usize, rest: usize, width: usize, out: &mut String) {
    let start = text.len() - text.trim_start().len();
    let mut line = " ".repeat(first) + &text[..start];
    let mut empty = true;
    for word in text.split_whitespace() {
        let length = line.chars().count() + word.chars().count() + usize::from(!empty);
        if !empty && length > width.max(first + LEAST) {
            out.push_str(line.trim_end());
            out.push('\n');
            line = " ".repeat(rest);
            empty = true;
        }
        if !empty {
            line.push(' ');
        }
        line.push_str(word);
        empty = false;
    }
    out.push_str(line.trim_end());
    out.push('\n');
}
