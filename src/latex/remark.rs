//! Words that are no part of an equation: a title before it, a remark behind it.
//!
//! Contract: words are passed over only where a comment says `remark`, at the beginning of a row, in a cell of their own or before
//! a wide space, or at its end. Words that say what holds, such as `if` and `for all`, are never passed over.

use super::macros::group;
use super::prepare::printed;
use super::token::{Kind, Token, words};

/// Words of which a statement is made.
const LOGIC: &[&str] = &[
    "if",
    "for",
    "when",
    "whenever",
    "where",
    "with",
    "without",
    "provided",
    "as",
    "and",
    "or",
    "not",
    "iff",
    "exists",
    "all",
    "each",
    "every",
    "any",
    "then",
    "otherwise",
    "else",
    "unless",
    "only",
    "except",
    "assuming",
    "given",
    "suppose",
    "let",
    "maximum",
    "minimum",
    "limit",
    "mod",
    "modulo",
    "natural",
    "real",
    "integer",
    "is",
    "constant",
    "const",
    "neither",
    "nor",
    "no",
    "never",
];

/// Signs that end a proof or confirm an equation.
pub(crate) const MARKS: &[&str] = &["checkmark", "qed", "qedhere", "qedsymbol", "square", "blacksquare", "Box"];

/// The cells of a row without the words before and behind its equation.
pub(crate) fn without_remarks(cells: &[Vec<Token>]) -> Vec<Vec<Token>> {
    let mut out = cells.to_vec();
    if let Some(first) = out.iter_mut().find(|cell| printed(cell).next().is_some())
        && let Some((from, to)) = first.iter().position(Token::is_text).and_then(|at| remark(first, at))
        && printed(&first[..from]).next().is_none()
        && (is_apart(&first[to..]) || printed(&first[to..]).next().is_none())
    {
        first.drain(from..to);
    }
    if let Some(last) = out.iter_mut().rev().find(|cell| printed(cell).next().is_some())
        && let Some((from, to)) = last.iter().rposition(Token::is_text).and_then(|at| remark(last, at))
        && printed(&last[to..]).all(|t| matches!(t.char(), Some('.' | ',' | ';')))
    {
        last.drain(from..to);
    }
    out
}

/// Whether these tokens begin with a wide space.
fn is_apart(tokens: &[Token]) -> bool {
    tokens.iter().find(|t| !matches!(t.char(), Some(',' | ':' | '.'))).is_some_and(|t| t.is("quad") || t.is("qquad"))
}

/// The words at this place and where they end, if they are a remark.
fn remark(tokens: &[Token], at: usize) -> Option<(usize, usize)> {
    let is_script = at > 0 && matches!(tokens[at - 1].char(), Some('_' | '^'));
    let (inner, next) = group(tokens, at + 1).ok().filter(|_| tokens[at + 1].kind == Kind::Open && !is_script)?;
    let said = words(inner).to_lowercase();
    let count = |sign: char| said.matches(sign).count();
    let is_logic = said.split(|c: char| !c.is_alphabetic()).any(|word| LOGIC.contains(&word));
    let is_whole = count('(') == count(')') && count('[') == count(']') && said.chars().any(char::is_alphabetic);
    let holds_formula =
        inner.iter().any(|t| matches!(t.kind, Kind::Dollar(_)) || matches!(t.char(), Some('=' | '<' | '>')));
    (is_whole && !is_logic && !holds_formula).then_some((at, next))
}
