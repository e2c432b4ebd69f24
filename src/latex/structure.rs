//! A document's tokens as LaTeX would meet them: what it never reaches is left out, and macros that begin or end a formula
//! are put in place.
//!
//! Contract: a formula that prints is in sight: `\be … \ee` where these stand for an environment. What stands behind
//! `\end{document}` or between `\iffalse` and `\fi` is not.

use super::document::environment;
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

/// Where to read on behind an `\iffalse`: behind its `\else` or its `\fi`.
fn passed_over(tokens: &[Token], at: usize) -> usize {
    let mut level = 0usize;
    for (place, token) in tokens.iter().enumerate().skip(at + 1) {
        let Kind::Command(name) = &token.kind else { continue };
        match name.as_str() {
            "fi" if level == 0 => return place + 1,
            "else" if level == 0 => return place + 1,
            "fi" => level -= 1,
            // `\iff` and `\ifthenelse` have no `\fi`.
            _ if name.starts_with("if") && name != "iff" && name != "ifthenelse" => level += 1,
            _ => {}
        }
    }
    tokens.len()
}
