//! A formula's tokens without what only spaces or sizes it.
//!
//! Contract: what is left is read sign by sign. `\quad` stays where it stands between two statements. Space between digits is
//! refused, since it prints as one number and may be two.

use super::macros::group;
use super::refusal::refused;
use super::token::{Kind, Token};
use carom_diagnostic::Diagnostic;

/// Spaces; they separate a factor from a parenthesis that follows it.
pub(crate) const SPACES: &[&str] = &[",", ";", ":", "!", " ", "/", "thinspace", "enspace", "hfill", "hfil"];
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

/// The tokens that are read.
///
/// # Errors
/// `\left.`, `\middle`, or space between digits.
pub(crate) fn prepared(tokens: &[Token]) -> Result<Vec<Token>, Diagnostic> {
    let tokens = &super::form::one_form(tokens)?;
    let mut out: Vec<Token> = Vec::new();
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        let Some(name) = token.command() else {
            if token.is_char('~') {
                out.push(Token { kind: Kind::Command(",".to_string()), ..token.clone() });
            } else {
                out.push(token.clone());
            }
            continue;
        };
        match name {
            "left" | "right" => {
                if tokens.get(at).is_some_and(|t| t.is_char('.')) {
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
            "phantom" | "hspace" | "vspace" | "vphantom" | "hphantom" | "color" | "hspace*" => {
                at += usize::from(tokens.get(at).is_some_and(|t| t.is_char('*')));
                if tokens.get(at).is_some_and(|t| t.kind == Kind::Open) {
                    at = group(tokens, at)?.1;
                }
            }
            "quad" | "qquad" => {
                let operator = |t: &Token| {
                    t.command().is_some_and(|name| OPERATORS.contains(&name))
                        || matches!(t.char(), Some('=' | '<' | '>' | '+' | '-' | ',' | ';' | '.' | ':'))
                };
                let next = tokens[at..]
                    .iter()
                    .find(|t| !t.command().is_some_and(|n| SPACES.contains(&n) || n.ends_with("quad")));
                let opens = |t: &Token| t.kind == Kind::Open || t.is("quad");
                if next.is_some_and(|t| !operator(t))
                    && out.last().is_some_and(|t| !operator(t) && !opens(t))
                    && !after_text(&out)
                {
                    out.push(Token { kind: Kind::Command("quad".to_string()), ..token.clone() });
                }
            }
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
    // A full stop or a comma ends the sentence that the formula belongs to.
    while out.last().is_some_and(|t| {
        matches!(t.char(), Some('.' | ',' | ';'))
            || t.command().is_some_and(|name| SPACES.contains(&name) || name == "quad")
    }) {
        out.pop();
    }
    Ok(out)
}

/// `{,}` as in `1{,}000`.
fn braced_comma(tokens: &[Token], at: usize) -> bool {
    tokens[at].kind == Kind::Open
        && tokens.get(at + 1).is_some_and(|t| t.is_char(','))
        && tokens.get(at + 2).is_some_and(|t| t.kind == Kind::Close)
}

/// Whether the last token closes a `\text{…}`.
fn after_text(tokens: &[Token]) -> bool {
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
