//! What stands above and below a sign, in one form: its braces, and what is below first.
//!
//! Contract: prints alike. `x^\frac{1}{2}` is `x^{\frac{1}{2}}`, `v_\text{up}` is `v_{\text{up}}`, `\sigma^2_N` is `\sigma_N^2`.

use super::expression::NESTING_LIMIT;
use super::name::{ACCENTS, UPRIGHT, argument};
use super::token::{Kind, Token};

/// Commands with two arguments.
const TWO: &[&str] = &["frac", "dfrac", "tfrac", "cfrac", "binom", "dbinom", "tbinom", "nicefrac", "sfrac"];
/// Commands with one argument that may stand above or below a sign without braces.
const ONE: &[&str] = &["textnormal", "mathbb"];

/// The tokens with braces around what stands above and below a sign, and what is below first.
pub(crate) fn with_scripts(tokens: &[Token]) -> Vec<Token> {
    formed(tokens, 0)
}

/// The same for a part; what is nested deeper than is read stays as it is.
fn formed(tokens: &[Token], depth: usize) -> Vec<Token> {
    if depth > NESTING_LIMIT {
        return tokens.to_vec();
    }
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let Some((script, next)) = script(tokens, at, depth) else {
            out.push(token.clone());
            at += 1;
            continue;
        };
        let lower = script_below(tokens, next, depth).filter(|_| token.is_char('^'));
        // Primes stay where they are: they are read on both sides of an index.
        let is_prime = script.iter().any(|t| t.is("prime") || t.is_char('\''));
        match lower.filter(|_| !is_prime) {
            Some((below, behind)) => {
                out.extend(below);
                out.extend(script);
                at = behind;
            }
            None => {
                out.extend(script);
                at = next;
            }
        }
    }
    out
}

fn script_below(tokens: &[Token], at: usize, depth: usize) -> Option<(Vec<Token>, usize)> {
    script(tokens, at, depth).filter(|_| tokens[at].is_char('_'))
}

/// The sign at `at` with what it puts above or below, in braces where that is a command with arguments.
fn script(tokens: &[Token], at: usize, depth: usize) -> Option<(Vec<Token>, usize)> {
    let sign = tokens.get(at).filter(|t| matches!(t.char(), Some('^' | '_')))?;
    let first = tokens.get(at + 1)?;
    let is = |list: &[&str]| first.command().is_some_and(|name| list.contains(&name));
    let count = if is(TWO) { 2 } else { usize::from(is(UPRIGHT) || is(ACCENTS) || is(ONE)) };
    if count == 0 {
        let (inner, next) = argument(tokens, at + 1).ok()?;
        let inner = if first.kind == Kind::Open { formed(inner, depth + 1) } else { inner.to_vec() };
        let mut out = vec![sign.clone()];
        match first.kind {
            Kind::Open => {
                out.push(first.clone());
                out.extend(inner);
                out.push(tokens[next - 1].clone());
            }
            _ => out.extend(inner),
        }
        return Some((out, next));
    }
    let mut next = at + 2;
    for _ in 0..count {
        next = argument(tokens, next).ok()?.1;
    }
    let brace = |kind: Kind, place: &Token| Token { kind, span: place.span, apart: false };
    let mut out = vec![sign.clone(), brace(Kind::Open, first)];
    out.extend(formed(&tokens[at + 1..next], depth + 1));
    out.push(brace(Kind::Close, &tokens[next - 1]));
    Some((out, next))
}
