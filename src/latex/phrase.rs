//! Names of several signs that a comment gives: `%carom name \langle v \rangle as v_mean`, `name \sum F_x as F_net`.
//!
//! Contract: only what prints as the comment says is that name; spaces and the braces of one sign do not count. A name that begins
//! with a large sign ends its product, since what follows may be under that sign.

use super::expression::{Read, Reader, is_space};
use super::name::{Names, Symbol, argument, canonical};
use super::prepare::LOOKS;
use super::refusal::{ambiguous, refused};
use super::token::{Kind, Token};
use carom_diagnostic::{Diagnostic, Span};

/// Before the key, in the command that stands for such a name; no command of LaTeX holds a space.
const MARK: &str = "name ";
/// Signs that reach over what follows.
const LARGE: &[&str] = &["\\sum", "\\Sigma", "\\prod", "\\Pi", "\\int", "\\oint", "\\lim"];

/// A sign that prints, and where it stands with the braces that do not.
struct Printed<'t> {
    kind: &'t Kind,
    from: usize,
    to: usize,
}

/// The signs that print.
fn printed(tokens: &[Token]) -> Vec<Printed<'_>> {
    let (mut out, mut at): (Vec<Printed<'_>>, usize) = (Vec::new(), 0);
    while let Some(token) = tokens.get(at) {
        let is_form = |name: &str| LOOKS.contains(&name) || name == "left" || name == "right";
        let is_script = at > 0 && matches!(tokens[at - 1].char(), Some('_' | '^'));
        match argument(tokens, at) {
            Ok(([one], next)) if is_script && token.kind == Kind::Open => {
                out.push(Printed { kind: &one.kind, from: at, to: next });
                at = next;
                continue;
            }
            _ if is_space(token) || token.command().is_some_and(is_form) => {}
            _ => out.push(Printed { kind: &token.kind, from: at, to: at + 1 }),
        }
        at += 1;
    }
    out
}

/// Whether braces and parentheses close where they open.
fn is_balanced(tokens: &[Token]) -> bool {
    let mut open: Vec<&str> = Vec::new();
    tokens.iter().all(|token| {
        let text = token.text();
        match text.as_str() {
            "{" => open.push("}"),
            "(" => open.push(")"),
            "[" => open.push("]"),
            "\\langle" => open.push("\\rangle"),
            "}" | ")" | "]" | "\\rangle" => return open.pop() == Some(text.as_str()),
            _ => {}
        }
        true
    }) && open.is_empty()
}

/// The key in the command that stands for a name of several signs.
pub(crate) fn key_of(command: &str) -> Option<&str> {
    command.strip_prefix(MARK)
}

impl Names {
    /// Takes a name of several signs.
    ///
    /// # Errors
    /// Signs that are none, or one, or in parentheses that are not closed.
    pub(crate) fn phrase(&mut self, tokens: &[Token], spelling: &str, span: Span) -> Result<(), Diagnostic> {
        let signs: Vec<Kind> = printed(tokens).into_iter().map(|sign| sign.kind.clone()).collect();
        let compares = |kind: &Kind| matches!(kind, Kind::Char('=' | '<' | '>' | '&' | '"') | Kind::Dollar(_));
        if signs.len() < 2 || !is_balanced(tokens) || signs.iter().any(compares) {
            let help = "write what is printed and what it is called, as in `%carom name \\langle v \\rangle as v_mean`";
            return Err(refused("this is no name", help, span));
        }
        let key = canonical(tokens);
        self.set(&key, spelling, span)?;
        self.phrases.retain(|phrase| phrase.0 != signs);
        self.phrases.push((signs, key));
        // Of two the longer one is the name.
        self.phrases.sort_by_key(|phrase| std::cmp::Reverse(phrase.0.len()));
        Ok(())
    }

    /// The tokens with one command for each name of several signs.
    pub(crate) fn with_phrases(&self, tokens: &[Token]) -> Vec<Token> {
        if self.phrases.is_empty() {
            return tokens.to_vec();
        }
        let signs = printed(tokens);
        let (mut out, mut done, mut at) = (Vec::new(), 0, 0);
        while at < signs.len() {
            let found = self.phrases.iter().find(|(phrase, _)| {
                let part = signs.get(at..at + phrase.len());
                part.is_some_and(|part| {
                    part.iter().zip(phrase).all(|(sign, kind)| sign.kind == kind)
                        && is_balanced(&tokens[part[0].from..part[part.len() - 1].to])
                })
            });
            let Some((phrase, key)) = found else {
                at += 1;
                continue;
            };
            let (from, to) = (signs[at].from, signs[at + phrase.len() - 1].to);
            out.extend_from_slice(&tokens[done..from]);
            let span = Span { start: tokens[from].span.start, end: tokens[to - 1].span.end };
            out.push(Token { kind: Kind::Command(format!("{MARK}{key}")), span, apart: tokens[from].apart });
            (done, at) = (to, at + phrase.len());
        }
        out.extend_from_slice(&tokens[done..]);
        out
    }
}

impl Reader<'_, '_, '_> {
    /// Refuses a factor behind a name that begins with a large sign: it may be under that sign.
    pub(crate) fn ends_product(&mut self, symbol: &Symbol) -> Read<()> {
        let is_large = LARGE.iter().any(|sign| symbol.base.starts_with(sign));
        if !is_large || !self.begins_factor() {
            return Ok(());
        }
        let key = symbol.key();
        let readings = ["a factor behind the name", "a part of what the sign is over"];
        let write =
            ["put the factor before it, or write \\cdot".to_string(), format!("name all of it instead of {key}")];
        Err(ambiguous(&format!("what follows {key}"), readings, write.each_ref().map(String::as_str), symbol.span))
    }
}
