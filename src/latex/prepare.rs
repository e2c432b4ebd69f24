//! A formula's tokens without what only spaces or sizes it.
//!
//! Contract: what is left is read sign by sign. `\quad` stays where it stands between two statements. Space between digits is
//! refused, since it prints as one number and may be two.

use super::binding::relation_of;
use super::macros::group;
use super::refusal::refused;
use super::remark::MARKS;
use super::token::{Kind, Token, words};
use carom_diagnostic::Diagnostic;

/// Spaces; they separate a factor from a parenthesis that follows it.
pub(crate) const SPACES: &[&str] =
    &[",", ";", ":", ">", "!", " ", "/", "thinspace", "medspace", "thickspace", "enspace", "hfill", "hfil"];
/// Commands that change only how a formula looks.
pub(crate) const LOOKS: &[&str] = &[
    "displaystyle",
    "textstyle",
    "scriptstyle",
    "limits",
    "nolimits",
    "allowbreak",
    "nobreak",
    "mathstrut",
    "strut",
    "relax",
    "big",
    "Big",
    "bigg",
    "Bigg",
    "bigl",
    "bigr",
    "Bigl",
    "Bigr",
    "biggl",
    "biggr",
    "Biggl",
    "Biggr",
    "noindent",
    "centering",
];
/// Signs between two statements or parts of one.
pub(crate) const OPERATORS: &[&str] = &[
    "le",
    "leq",
    "leqslant",
    "ge",
    "geq",
    "geqslant",
    "ne",
    "neq",
    "cdot",
    "times",
    "pm",
    "mp",
    "approx",
    "equiv",
    "in",
    "to",
    "Rightarrow",
    "implies",
    "Leftrightarrow",
    "iff",
    "Longrightarrow",
    "Longleftrightarrow",
    "text",
    "mbox",
    "land",
    "wedge",
    "lor",
    "vee",
    "textrm",
    "textnormal",
];

/// Commands whose argument does not print.
const BLANK: &[&str] = &["phantom", "hspace", "vspace", "vphantom", "hphantom", "color", "hspace*"];

/// The tokens without what only spaces, sizes or groups: the first and the last are what a reader sees first and last.
pub(crate) fn printed(tokens: &[Token]) -> impl Iterator<Item = &Token> {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            if let Some((_, next)) = blank(tokens, at) {
                at = next;
                continue;
            }
            let token = tokens.get(at)?;
            at += 1;
            let is_form = |name: &str| {
                LOOKS.contains(&name) || super::form::CLASSES.contains(&name) || name == "left" || name == "right"
            };
            if !matches!(token.kind, Kind::Open | Kind::Close) && !token.command().is_some_and(is_form) {
                return Some(token);
            }
        }
    })
}

/// The tokens that are read.
///
/// # Errors
/// `\left.`, `\middle`, or space between digits.
pub(crate) fn prepared(tokens: &[Token]) -> Result<Vec<Token>, Diagnostic> {
    let tokens = &super::form::one_form(tokens)?;
    let mut out: Vec<Token> = Vec::new();
    // In a chain of comparisons a smaller space may part two of them.
    let wide = if tokens.iter().filter(|t| relation_of(t).is_some()).count() > 1 { 3.0 } else { 5.0 };
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        if let Some((first, mut next)) = blank(tokens, at) {
            let mut points = first;
            while let Some((more, behind)) = blank(tokens, next) {
                (points, next) = (points + more, behind);
            }
            let is_single = next == at + 1 && SPACES.contains(&token.command().unwrap_or_default());
            let thin = |name: &str| Token { kind: Kind::Command(name.to_string()), ..token.clone() };
            match points >= wide {
                true if parts(&out, &tokens[next..]) => out.push(thin("quad")),
                true => {}
                false if is_single => out.push(token.clone()),
                false if points > 0.0 => out.push(thin(",")),
                false => {}
            }
            at = next;
            continue;
        }
        at += 1;
        let Some(name) = token.command() else {
            out.push(token.clone());
            continue;
        };
        match name {
            "left" | "right" => {
                if tokens.get(at).is_some_and(|t| t.is_char('.')) {
                    // Where a formula is broken, both signs print nothing.
                    let blank = |t: &&Token| !t.command().is_some_and(|n| SPACES.contains(&n) || n.ends_with("quad"));
                    let next = tokens[at + 1..].iter().position(|t| blank(&t)).map(|skipped| at + 1 + skipped);
                    let again = next.filter(|next| name == "right" && tokens[*next].is("left"));
                    if let Some(next) = again.filter(|next| tokens.get(next + 1).is_some_and(|t| t.is_char('.'))) {
                        at = next + 2;
                        continue;
                    }
                    let help = "write the two values, as in F(b) - F(a)";
                    return Err(refused("a parenthesis with one side left out is not read", help, token.span));
                }
                if let Some(bar) = tokens.get(at).filter(|t| t.is_char('|')) {
                    let kind = Kind::Command(if name == "left" { "lvert" } else { "rvert" }.to_string());
                    out.push(Token { kind, ..bar.clone() });
                    at += 1;
                }
            }
            "middle" => return Err(refused("\\middle is not read", "write the relation that is meant", token.span)),
            _ if LOOKS.contains(&name) => {}
            _ => out.push(token.clone()),
        }
    }
    let is_digit = |t: Option<&Token>| t.and_then(Token::char).is_some_and(|c| c.is_ascii_digit());
    for (place, token) in out.iter().enumerate() {
        let space = token.command().is_some_and(|name| SPACES.contains(&name)) || braced_comma(&out, place);
        if space && place > 0 && is_digit(out.get(place - 1)) {
            let skip = if token.kind == Kind::Open { 3 } else { 1 };
            if is_digit(out.get(place + skip)) {
                let help = "write one number without a separator, as in 1000, or a product with \\cdot";
                return Err(refused("these digits are separated by a space or a comma", help, token.span));
            }
        }
    }
    let dots = out.iter().rev().take_while(|t| t.is_char('.')).count();
    if let Some(last) = out.last().filter(|_| dots > 1) {
        let help = "write what is meant, a sum with its index or a number";
        return Err(refused("dots at the end of a formula are not read", help, last.span));
    }
    // What confirms the equation stands behind a space.
    let is_mark = |t: &Token| t.command().is_some_and(|name| MARKS.contains(&name));
    if out.len() > 1 && is_mark(&out[out.len() - 1]) && out[out.len() - 2].is("quad") {
        out.pop();
    }
    // A full stop or a comma ends the sentence that the formula belongs to.
    while out.last().is_some_and(|t| {
        matches!(t.char(), Some('.' | ',' | ';'))
            || t.command().is_some_and(|name| SPACES.contains(&name) || name == "quad")
    }) {
        out.pop();
    }
    Ok(out)
}

/// The width in points, about, of what does not print at this place, and where to read on.
fn blank(tokens: &[Token], at: usize) -> Option<(f64, usize)> {
    let token = tokens.get(at)?;
    if token.is_char('~') {
        return Some((3.3, at + 1));
    }
    let name = token.command()?;
    if BLANK.contains(&name) {
        let at = at + 1 + usize::from(tokens.get(at + 1).is_some_and(|t| t.is_char('*')));
        let inner = tokens.get(at).filter(|t| t.kind == Kind::Open).and_then(|_| group(tokens, at).ok());
        let is_wide = name.ends_with("phantom") && name != "vphantom";
        return Some(match inner {
            Some((inner, next)) if name.starts_with("hspace") => (super::form::width(&words(inner)).max(0.0), next),
            Some((inner, next)) => (if is_wide && !inner.is_empty() { 10.0 } else { 0.0 }, next),
            None => (0.0, at),
        });
    }
    let points = match name {
        "quad" => 10.0,
        "qquad" => 20.0,
        "hfill" | "hfil" => 100.0,
        "enspace" => 5.0,
        " " => 3.3,
        ";" | "thickspace" => 2.8,
        ":" | ">" | "medspace" => 2.2,
        "!" => 0.0,
        _ if SPACES.contains(&name) => 1.7,
        _ => return None,
    };
    Some((points, at + 1))
}

/// Whether a wide space between these stands between two statements, or parts of one.
fn parts(before: &[Token], after: &[Token]) -> bool {
    let operator = |t: &Token| {
        t.command().is_some_and(|name| OPERATORS.contains(&name))
            || matches!(t.char(), Some('=' | '<' | '>' | '+' | '-' | ',' | ';' | '.' | ':'))
    };
    let opens = |t: &Token| t.kind == Kind::Open || t.is("quad");
    let is_digit = |t: Option<&Token>| t.and_then(Token::char).is_some_and(|c| c.is_ascii_digit());
    let is_decimal = after.first().is_some_and(|t| t.is_char('.')) && is_digit(after.get(1));
    after.first().is_some_and(|t| is_decimal || !operator(t))
        && before.last().is_some_and(|t| !operator(t) && !opens(t))
        && !after_text(before)
}

/// `{,}` as in `1{,}000`.
fn braced_comma(tokens: &[Token], at: usize) -> bool {
    tokens[at].kind == Kind::Open
        && tokens.get(at + 1).is_some_and(|t| t.is_char(','))
        && tokens.get(at + 2).is_some_and(|t| t.kind == Kind::Close)
}

/// Whether the last token closes a `\text{…}`.
pub(crate) fn after_text(tokens: &[Token]) -> bool {
    if tokens.last().is_none_or(|t| t.kind != Kind::Close) {
        return false;
    }
    let mut level = 0usize;
    for (place, token) in tokens.iter().enumerate().rev() {
        match token.kind {
            Kind::Close => level += 1,
            Kind::Open => {
                level -= 1;
                if level == 0 {
                    return place.checked_sub(1).is_some_and(|before| tokens[before].is_text());
                }
            }
            _ => {}
        }
    }
    false
}

/// Whether a command stands between statements or parts of one.
pub(crate) fn is_operator(name: &str) -> bool {
    OPERATORS.contains(&name)
}
