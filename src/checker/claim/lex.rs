//! Tokens of a claim file.
//!
//! Contract: every byte of the source belongs to a token, to white space or to a comment; each token
//! knows its place. Unicode signs (≤ ≥ ≠ ⇒ ⇔ · × − ∧ ∨ ¬ ∞ →) read as their ASCII forms, and Greek letters
//! in names as their names: `μ1` is `mu1`. Digits below the line are an index, `m₁` is `m1`, and those above it a power,
//! `x²` is `x^2`: the language reads what it prints. So a name is ASCII, and no two names are one in print by their
//! letters alone; see [`super::parse`] for `m1` and `m_1`.
//! Limits: `NUMERAL_LIMIT`, `NAME_LIMIT`, `TOKENS_LIMIT`, [`FILE_LIMIT`].

use super::diagnostic::{Diagnostic, Fault};
use super::syntax::Span;

/// The largest claim file in bytes.
pub const FILE_LIMIT: usize = 1 << 20;
/// The longest numeral in characters, and the largest decimal exponent.
pub(crate) const NUMERAL_LIMIT: usize = 10_000;
/// The longest name in characters.
pub(crate) const NAME_LIMIT: usize = 100;
/// The most tokens in a file.
pub(crate) const TOKENS_LIMIT: usize = 500_000;

/// A token with its place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Token {
    /// What it is.
    pub kind: Kind,
    /// Where it stands.
    pub span: Span,
    /// Whether it is the first on its line.
    pub first_on_line: bool,
}

/// The kinds of tokens.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Kind {
    /// A name or keyword; may hold `-` between letters where a claim's name is read.
    Word(String),
    /// A numeral as written.
    Number(String),
    /// A power above the line, `²` or `⁻¹`, in ASCII.
    Raised(String),
    /// A text in quotation marks.
    Text(String),
    /// A sign in its ASCII form.
    Sign(&'static str),
    /// The end of the file.
    End,
}

const SIGNS: &[&str] = &[
    "<=>", "**", "==", "<=", ">=", "!=", "=>", "->", "..", "+", "-", "*", "/", "^", "(", ")", "[", "]", "{", "}", ",",
    ";", ":", "=", "<", ">", "|", "!",
];

const UNICODE: &[(char, &str)] = &[
    ('≤', "<="),
    ('≥', ">="),
    ('≠', "!="),
    ('⇒', "=>"),
    ('⇔', "<=>"),
    ('·', "*"),
    ('×', "*"),
    ('−', "-"),
    ('→', "->"),
    ('√', "√"),
    ('…', ".."),
];

/// Greek letters: a name may hold them by their names or as signs, which are the same. Those are left out
/// that look like a Latin letter, and Σ and Π, which stand for sums and products in print.
pub const GREEK: &[(&str, char)] = &[
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
];

/// Sums, products and integrals as they are printed; without an index these letters are no names.
const OVER: &[(&str, &str)] = &[("Σ(", "sum"), ("Π(", "product"), ("∫(", "integral")];

/// Digits above the line, in order; those below it follow each other from `₀` on.
const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";

const UNICODE_WORDS: &[(char, &str)] = &[('∧', "and"), ('∨', "or"), ('¬', "not"), ('∞', "infinity"), ('∈', "in")];

/// The tokens of a source, with all faults found on the way.
pub(crate) fn tokens(source: &str) -> (Vec<Token>, Vec<Diagnostic>) {
    let mut out: Vec<Token> = Vec::new();
    let mut faults = Vec::new();
    let mut first_on_line = true;
    let mut at = 0;
    while let Some(c) = source[at..].chars().next() {
        if out.len() >= TOKENS_LIMIT {
            let span = Span { start: at, end: at + c.len_utf8() };
            faults.push(Diagnostic::new(Fault::Limit { name: "tokens per file", allowed: TOKENS_LIMIT }, span));
            break;
        }
        let start = at;
        if c == '\n' {
            first_on_line = true;
            at += 1;
            continue;
        }
        if c.is_whitespace() || c == '\u{feff}' {
            at += c.len_utf8();
            continue;
        }
        if c == '#' {
            at += source[at..].find('\n').unwrap_or(source.len() - at);
            continue;
        }
        let kind = if let Some(length) = equation_number(&source[at..], &out) {
            at += length;
            Kind::Text(source[start..at].to_string())
        } else if let Some((sign, word)) = OVER.iter().find(|over| source[at..].starts_with(over.0)) {
            at += sign.len() - 1;
            Kind::Word((*word).to_string())
        } else if (c.is_alphabetic() || c == '_') && !"ℝℚℤℕℂ".contains(c) {
            let length = name_length(&source[at..], &out);
            at += length;
            match name(&source[start..at], Span { start, end: at }, &mut faults) {
                Some(name) => Kind::Word(name),
                None => continue,
            }
        } else if let Some((length, power)) = power(&source[at..]) {
            at += length;
            if power.len() > NUMERAL_LIMIT {
                let fault = Fault::Limit { name: "digits of a numeral", allowed: NUMERAL_LIMIT };
                faults.push(Diagnostic::new(fault, Span { start, end: at }));
            }
            Kind::Raised(power)
        } else if c.is_ascii_digit() {
            at += numeral(&source[at..]);
            Kind::Number(number(&source[start..at], Span { start, end: at }, &mut faults))
        } else if c == '"' {
            let rest = &source[at + 1..];
            let end = rest.find(['"', '\n']).unwrap_or(rest.len());
            if !rest[end..].starts_with('"') {
                at += 1 + end;
                faults.push(Diagnostic::new(Fault::OpenText, Span { start, end: at }));
                continue;
            }
            at += end + 2;
            Kind::Text(rest[..end].to_string())
        } else if let Some((_, sign)) = UNICODE.iter().find(|u| u.0 == c) {
            at += c.len_utf8();
            Kind::Sign(sign)
        } else if let Some((_, word)) = UNICODE_WORDS.iter().find(|u| u.0 == c) {
            at += c.len_utf8();
            Kind::Word(word.to_string())
        } else if let Some(sign) = SIGNS.iter().find(|s| source[at..].starts_with(**s)) {
            at += sign.len();
            Kind::Sign(sign)
        } else {
            at += c.len_utf8();
            // `&&` is one fault.
            match faults.last_mut() {
                Some(Diagnostic { fault: Fault::Stray(before), span }) if *before == c && span.end == start => {
                    span.end = at
                }
                _ => faults.push(Diagnostic::new(Fault::Stray(c), Span { start, end: at })),
            }
            continue;
        };
        out.push(Token { kind, span: Span { start, end: at }, first_on_line });
        first_on_line = false;
    }
    let end = Span { start: source.len(), end: source.len() };
    out.push(Token { kind: Kind::End, span: end, first_on_line: true });
    (out, faults)
}

/// The length of the name at the beginning. It may hold dashes between letters where [`dashed`] says so.
fn name_length(rest: &str, before: &[Token]) -> usize {
    let mut end = 0;
    for (i, d) in rest.char_indices() {
        let dash = d == '-' && i > 0 && dashed(before) && rest[i + 1..].starts_with(|n: char| n.is_alphanumeric());
        if raised(d).is_none() && (d.is_alphanumeric() || d == '_' || dash || d == '\'') {
            end = i + d.len_utf8();
        } else {
            break;
        }
    }
    end
}

/// A name in ASCII; `None` if it is too long.
fn name(text: &str, span: Span, faults: &mut Vec<Diagnostic>) -> Option<String> {
    if text.chars().count() > NAME_LIMIT {
        faults.push(Diagnostic::new(Fault::Limit { name: "characters in a name", allowed: NAME_LIMIT }, span));
        return None;
    }
    Some(word(text).unwrap_or_else(|message| {
        let help = "a name begins with a Latin or Greek letter; letters, digits and single `_` may follow, and \
                    `'` at the end; powers are written x^2 or x², indices x1 or x₁";
        let fault = Fault::Other { message, help: Some(help.to_string()) };
        faults.push(Diagnostic::new(fault, span));
        // Read on as if it were right: one mistake, one message.
        text.to_string()
    }))
}

/// A numeral as written; 1 where it is too long.
fn number(text: &str, span: Span, faults: &mut Vec<Diagnostic>) -> String {
    let exponent = text.split_once(['e', 'E']).map_or("0", |p| p.1).trim_start_matches(['+', '-']);
    let exponent: usize = exponent.parse().unwrap_or(usize::MAX);
    if text.len() > NUMERAL_LIMIT || exponent > NUMERAL_LIMIT {
        let fault = Fault::Limit { name: "digits of a numeral", allowed: NUMERAL_LIMIT };
        faults.push(Diagnostic::new(fault, span));
        return "1".to_string();
    }
    text.to_string()
}

/// A word in ASCII; digits below the line are its index. Signs that print as something else than a part of a name are
/// refused, and so is `_` without anything to stand between.
fn word(text: &str) -> Result<String, String> {
    let mut out = String::new();
    let mut before = ' ';
    for c in text.chars() {
        // In print x₁2 could be x₁ times 2, or one name whose index is 12.
        let is_mixed = |a: char, b: char| a.is_ascii_digit() && lowered(b).is_some();
        if is_mixed(before, c) || is_mixed(c, before) {
            return Err(format!("the name {text} mixes digits on the line with subscript digits"));
        }
        match GREEK.iter().find(|g| g.1 == c) {
            Some((name, _)) => out.push_str(name),
            None if c.is_ascii() => out.push(c),
            None if lowered(c).is_some() => out.extend(lowered(c)),
            None => return Err(format!("the name {text} contains the character {c:?}")),
        }
        before = c;
    }
    if out.split('_').any(str::is_empty) {
        return Err(format!("the name {text} begins or ends with `_`, or has two in a row"));
    }
    // Names with more behind an apostrophe are those that the prover makes.
    if out.trim_end_matches('\'').contains('\'') {
        return Err(format!("the name {text} has an apostrophe before its end"));
    }
    Ok(out)
}

/// The digit that a sign below the line is.
fn lowered(c: char) -> Option<char> {
    char::from_digit(u32::from(c).checked_sub(u32::from('₀'))?, 10)
}

/// The digit that a sign above the line is.
fn raised(c: char) -> Option<char> {
    char::from_digit(u32::try_from(RAISED.chars().position(|known| known == c)?).ok()?, 10)
}

/// The power above the line at the beginning, `²` or `⁻¹`: its length and its digits.
fn power(text: &str) -> Option<(usize, String)> {
    let digits = text.strip_prefix('⁻').unwrap_or(text);
    let end = digits.find(|c| raised(c).is_none()).unwrap_or(digits.len());
    let minus = if digits.len() < text.len() { "-" } else { "" };
    let number: String = digits[..end].chars().filter_map(raised).collect();
    (end > 0).then(|| (text.len() - digits.len() + end, format!("{minus}{number}")))
}

/// Whether a word here may hold dashes: after `claim`, `using` or `by`, and in the list after `using`.
fn dashed(before: &[Token]) -> bool {
    let word = |i: usize| match before.get(i).map(|t| &t.kind) {
        Some(Kind::Word(word)) => Some(word.as_str()),
        _ => None,
    };
    let mut at = before.len();
    if at > 0 && matches!(word(at - 1), Some("claim" | "using" | "by")) {
        return true;
    }
    while at >= 2 && before[at - 1].kind == Kind::Sign(",") && word(at - 2).is_some() {
        at -= 2;
        if at >= 1 && word(at - 1) == Some("using") {
            return true;
        }
    }
    false
}

/// The length of an equation number as a source prints it, `2.13`, `A.3` or `7a`, where the text follows `number`.
fn equation_number(text: &str, before: &[Token]) -> Option<usize> {
    let is_asked =
        matches!(before.last(), Some(Token { kind: Kind::Word(word), first_on_line: true, .. }) if word == "number");
    if !is_asked || !text.starts_with(|c: char| c.is_alphanumeric()) {
        return None;
    }
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '.' | '-' | '\'' | '′' | '*');
    let length = text.find(|c: char| !is_part(c)).unwrap_or(text.len());
    (text[..length].chars().count() <= NAME_LIMIT).then_some(length)
}

/// The length of the numeral at the beginning: digits, point and digits, exponent. `1..6` is a range.
fn numeral(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |mut i: usize| {
        while bytes.get(i).is_some_and(u8::is_ascii_digit) {
            i += 1;
        }
        i
    };
    let mut at = digits(0);
    if bytes.get(at) == Some(&b'.') && bytes.get(at + 1).is_some_and(u8::is_ascii_digit) {
        at = digits(at + 1);
    }
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(at + 1), Some(b'+' | b'-')));
        if bytes.get(at + 1 + sign).is_some_and(u8::is_ascii_digit) {
            at = digits(at + 1 + sign);
        }
    }
    at
}
