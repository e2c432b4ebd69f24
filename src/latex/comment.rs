//! Clauses in comments: the claim language with the paper's names.
//!
//! Contract: a clause is copied sign by sign. Only names change: a name in LaTeX, `\mu_{1}` or `v_1^\prime`, becomes its spelling in
//! the claim language, and so does a name that is spelled in two ways.

use super::document::Clause;
use super::macros::group;
use super::name::{Names, base, canonical, is_in_word, is_letter, scripts};
use super::place::Placed;
use super::refusal::{expected, refused};
use super::token::{Kind, Token, raw_tokens};
use carom_diagnostic::{Diagnostic, Span};

/// The clause in the claim language.
///
/// # Errors
/// LaTeX that is no name.
pub(crate) fn clause(text: &str, span: Span, names: &mut Names) -> Result<Placed, Diagnostic> {
    let tokens = raw_tokens(text, span.start)?;
    let mut out = Placed::default();
    let first = first_word(text);
    // Names of claims hold dashes, and are no names of the paper.
    let is_plain = ["claim", "using", "expect", "reading", "number"].contains(&first);
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        if token.apart && at > 0 {
            out.push(" ", token.span);
        }
        if token.is_char('"') {
            let end = tokens[at + 1..].iter().position(|t| t.is_char('"')).map_or(tokens.len() - 1, |i| at + 1 + i);
            let (from, to) = (token.span.start - span.start, tokens[end].span.end - span.start);
            out.push(&text[from..to], Span { start: token.span.start, end: tokens[end].span.end });
            at = end + 1;
            continue;
        }
        if let (false, Some((symbol, next))) = (is_plain, latex_name(&tokens, at)?) {
            out.push(&names.of(&symbol)?, symbol.span);
            at = next;
            continue;
        }
        let length = identifier(&tokens, at);
        if first == "given" && length == 2 && token.is_char('i') && tokens[at + 1].is_char('n') {
            out.push("in", token.span);
            at += length;
            if let Some(end) = unit_end(&tokens, at) {
                out.push(" ", token.span);
                tokens[at..end].iter().for_each(|part| out.push(&unit_part(part), part.span));
                at = end;
            }
            continue;
        }
        if length > 0 {
            let word: String = tokens[at..at + length].iter().filter_map(|t| t.char()).collect();
            let place = Span { start: token.span.start, end: tokens[at + length - 1].span.end };
            let is_word = is_plain || at == 0;
            out.push(&if is_word { word } else { names.identifier(&word) }, place);
            at += length;
            continue;
        }
        match &token.kind {
            Kind::Command(name) if is_sign(name) => out.push(is_sign_text(name), token.span),
            Kind::Command(name) => {
                let help = "in comments write the claim language: a/b, sqrt(x), x^2, sum(i = 1..n, x), a*b";
                return Err(refused(format!("\\{name} is not read in a comment"), help, token.span));
            }
            _ => out.push(&token.text(), token.span),
        }
        at += 1;
    }
    Ok(out)
}

/// Where the unit ends that begins at `at`, if one does: its symbols are no names of the paper.
fn unit_end(tokens: &[Token], at: usize) -> Option<usize> {
    let begins = tokens.get(at).is_some_and(|t| t.is_char('1') || t.is("mathrm") || t.is("Omega"));
    let begins = begins || identifier(tokens, at) > 0;
    let rest = tokens.get(at..)?;
    let length = rest.iter().position(|t| matches!(t.char(), Some(',' | ';' | ':'))).unwrap_or(rest.len());
    // A range has two points.
    (begins && !rest[..length].iter().any(|t| t.is_char('.'))).then_some(at + length)
}

/// A part of a unit in the claim language.
fn unit_part(token: &Token) -> String {
    match &token.kind {
        Kind::Command(name) if name == "cdot" || name == "times" => "*".to_string(),
        Kind::Command(name) if name == "Omega" => name.clone(),
        Kind::Char(c) => c.to_string(),
        _ => String::new(),
    }
}

/// The first word of a clause.
pub(crate) fn first_word(text: &str) -> &str {
    text.split(|c: char| !c.is_ascii_alphabetic()).next().unwrap_or_default()
}

/// `name m_{12} as m12`: a name, the value of a function at one place, or several signs, and what it stands for.
pub(crate) fn rename(said: &Clause, names: &mut Names) -> Result<(), Diagnostic> {
    let tokens = raw_tokens(&said.text, said.span.start)?;
    let first = "name".len();
    let is_as = |at: &usize| {
        let (Some(a), Some(s)) = (tokens.get(*at), tokens.get(at + 1)) else { return false };
        a.is_char('a') && a.apart && s.is_char('s') && !s.apart && tokens.get(at + 2).is_some_and(|t| t.apart)
    };
    let Some(end) = (first + 1..tokens.len()).rev().find(is_as) else {
        let wanted = "a name and what it is called, as in `%carom name m_{12} as m12`";
        return Err(expected(wanted, "something else", said.span));
    };
    let spelling = said.text[tokens[end + 2].span.start - said.span.start..].trim();
    let printed = &tokens[first..end];
    let Some(key) = key_of_name(printed)? else { return names.phrase(printed, spelling, said.span) };
    names.set(&key, spelling, said.span)?;
    names.renamed.insert(key);
    Ok(())
}

/// The key of a name, or of the value of a function at one place, if these tokens are one.
fn key_of_name(tokens: &[Token]) -> Result<Option<String>, Diagnostic> {
    let Some((first, next)) = base(tokens, 0)? else { return Ok(None) };
    let (first, next) = match base(tokens, next)? {
        // A change is a name of two letters.
        Some((second, after)) if first == "\\Delta" => (format!("{first} {second}"), after),
        _ => (first, next),
    };
    let (symbol, next) = scripts(tokens, first, tokens[0].span, next)?;
    let key = symbol.key();
    let is_value = tokens.get(next).is_some_and(|t| t.is_char('(')) && tokens.last().is_some_and(|t| t.is_char(')'));
    Ok(match next == tokens.len() {
        true => Some(key),
        false => is_value.then(|| format!("{key}({})", canonical(&tokens[next + 1..tokens.len() - 1]))),
    })
}

/// `product K, \sigma`: behind these numbers a parenthesis is a factor.
pub(crate) fn factors(said: &Clause, names: &mut Names) -> Result<(), Diagnostic> {
    let tokens = raw_tokens(&said.text, said.span.start)?;
    let rest = &tokens["product".len().min(tokens.len())..];
    for part in super::symbol::commas(rest) {
        let found = match part.first() {
            Some(first) => base(part, 0)?.map(|(base, next)| scripts(part, base, first.span, next)).transpose()?,
            None => None,
        };
        let Some((symbol, _)) = found.filter(|found| found.1 == part.len()) else {
            return Err(expected("names with commas between them, as in `product K, w`", "something else", said.span));
        };
        let name = names.of(&symbol)?;
        names.factors.insert(name);
    }
    Ok(())
}

/// The name in LaTeX at `at`, if one stands there: a letter by its command, or a letter with braces below.
fn latex_name(tokens: &[Token], at: usize) -> Result<Option<(super::name::Symbol, usize)>, Diagnostic> {
    let token = &tokens[at];
    if let Kind::Command(name) = &token.kind {
        if is_sign(name) {
            return Ok(None);
        }
        let Some((mut first, mut next)) = base(tokens, at)? else { return Ok(None) };
        if name == "Delta"
            && let Some((second, after)) = base(tokens, next)?
            && (tokens[next].command().is_some_and(is_letter) || identifier(tokens, next) == 1)
        {
            (first, next) = (format!("{first} {second}"), after);
        }
        return scripts(tokens, first, token.span, next).map(Some);
    }
    if token.char().is_some_and(|c| c.is_ascii_alphabetic()) {
        let length = identifier(tokens, at);
        let is_command = |t: &Token| matches!(t.kind, Kind::Open | Kind::Command(_) | Kind::Char('+' | '-'));
        let below = tokens.get(at + length).is_some_and(|t| t.is_char('_') && !t.apart)
            && tokens.get(at + length + 1).is_some_and(is_command);
        let above = tokens.get(at + length).is_some_and(|t| t.is_char('^'))
            && tokens.get(at + length + 1).is_some_and(|t| {
                t.is("prime")
                    || (t.kind == Kind::Open
                        && group(tokens, at + length + 1).is_ok_and(|g| g.0.iter().all(|t| t.is("prime"))))
            });
        if below || above {
            let word: String = tokens[at..at + length].iter().filter_map(|t| t.char()).collect();
            // What the word has below already, as in v_1^\prime.
            let (head, tail) = word.split_once('_').map_or((word.as_str(), None), |(head, tail)| (head, Some(tail)));
            let (mut symbol, next) = scripts(tokens, head.to_string(), token.span, at + length)?;
            if let Some(tail) = tail {
                let place = token.span;
                symbol.below =
                    Some(tail.chars().map(|c| Token { kind: Kind::Char(c), span: place, apart: false }).collect());
            }
            return Ok(Some((symbol, next)));
        }
    }
    Ok(None)
}

/// The number of tokens of the claim language's name at `at`.
fn identifier(tokens: &[Token], at: usize) -> usize {
    let starts = |t: &Token| t.char().is_some_and(char::is_alphabetic);
    if !tokens.get(at).is_some_and(starts) {
        return 0;
    }
    let mut length = 1;
    while let Some(token) = tokens.get(at + length)
        && !token.apart
        && let Some(c) = token.char()
        && is_in_word(c)
    {
        let after = tokens.get(at + length + 1);
        if c == '_' && after.is_none_or(|t| !t.char().is_some_and(char::is_alphanumeric)) {
            break;
        }
        length += 1;
    }
    length
}

/// Whether a command is a sign that the claim language has.
fn is_sign(name: &str) -> bool {
    !is_sign_text(name).is_empty()
}

fn is_sign_text(name: &str) -> &'static str {
    match name {
        "le" | "leq" | "leqslant" => "<=",
        "ge" | "geq" | "geqslant" => ">=",
        "ne" | "neq" => "!=",
        "cdot" | "times" => "*",
        "in" => "in",
        "infty" => "infinity",
        "to" => "->",
        "Rightarrow" => "=>",
        "Leftrightarrow" => "<=>",
        _ => "",
    }
}
