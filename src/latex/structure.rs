//! A document's tokens as LaTeX would meet them: what it never reaches is left out, and macros that begin or end a formula
//! are put in place.
//!
//! Contract: a formula that prints is in sight: `\be … \ee` where these stand for an environment. What stands behind
//! `\end{document}` or between `\iffalse` and `\fi` is not.

use super::document::{declares, environment};
use super::macros::{Macros, defines};
use super::token::{Kind, Token};

/// The tokens that LaTeX reaches, with the macros in place that begin or end a formula.
pub(crate) fn structured(tokens: &[Token]) -> Vec<Token> {
    let mut macros = Macros::default();
    let mut out = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let name = token.command().unwrap_or_default();
        if name == "end" && environment(tokens, at).is_some_and(|found| found.0 == "document") {
            break;
        }
        let next = match name {
            "iffalse" => passed_over(tokens, at),
            "iftrue" => {
                let (end, last) = branch(tokens, at);
                out.extend(structured(&tokens[at + 1..end]));
                last
            }
            // Of some packages a condition has its branches in braces, and no `\fi`.
            name if is_condition(name) && branch(tokens, at).1 < tokens.len() => {
                let (_, last) = branch(tokens, at);
                // What may not print is not read; if it is a formula or a comment to Carom, that is a fault.
                let shows =
                    |t: &Token| matches!(t.kind, Kind::Comment(_) | Kind::Dollar(2)) || t.is("[") || t.is("begin");
                if tokens[at + 1..last].iter().any(shows) {
                    let name = UNKNOWN[usize::from(tokens[at + 1..last].iter().any(declares))];
                    out.push(Token { kind: Kind::Command(name.to_string()), ..token.clone() });
                }
                last
            }
            _ if defines(name) => {
                let next = macros.define(tokens, at).unwrap_or(at + 1);
                out.extend_from_slice(&tokens[at..next]);
                next
            }
            _ => match macros.structure(tokens, at) {
                Some((written, next)) => {
                    out.extend(written);
                    next
                }
                None => {
                    macros.passes(token);
                    out.push(token.clone());
                    at + 1
                }
            },
        };
        at = next.max(at + 1);
    }
    out
}

/// What stands for a condition that is not known, with a formula in it, or with a hypothesis or a declaration.
const UNKNOWN: [&str; 2] = ["if…", "if… given"];

/// Whether a command stands for a condition that is not known, and may declare something.
pub(crate) fn unknown_condition(name: &str) -> Option<bool> {
    UNKNOWN.iter().position(|known| *known == name).map(|found| found == 1)
}

/// Whether a command begins a condition that ends with `\fi`.
fn is_condition(name: &str) -> bool {
    name.starts_with("if") && name != "iff" && name != "ifthenelse"
}

/// Where the first branch of a condition at `at` ends, and where to read on behind its `\fi`.
fn branch(tokens: &[Token], at: usize) -> (usize, usize) {
    let end = passed_over(tokens, at);
    let is_else = end.checked_sub(1).is_some_and(|at| tokens[at].is("else"));
    let last = if is_else { passed_over(tokens, end - 1) } else { end };
    (end.saturating_sub(1).max(at + 1).min(tokens.len()), last)
}

/// Where to read on behind an `\iffalse`: behind its `\else` or its `\fi`.
fn passed_over(tokens: &[Token], at: usize) -> usize {
    let mut level = 0usize;
    for (place, token) in tokens.iter().enumerate().skip(at + 1) {
        let Kind::Command(name) = &token.kind else { continue };
        match name.as_str() {
            "fi" | "else" if level == 0 => return place + 1,
            "fi" => level -= 1,
            // `\iff` and `\ifthenelse` have no `\fi`.
            _ if is_condition(name) => level += 1,
            _ => {}
        }
    }
    tokens.len()
}
