//! The names of a paper and those of the claim language.
//!
//! Contract: a name of the paper is known by its *key*, its LaTeX without spaces and with all braces: `m_{1}`, `v_{1}'`,
//! `\bar{v}`. The printer of the claim language writes its names in the same form, so `m_1`, `m_{1}` and the claim language's `m1`
//! have one key. A key has one spelling in the claim language, the first that a comment uses. Two keys never share a spelling.

use super::macros::group;
use super::phrase::key_of;
use super::prepare::SPACES;
use super::refusal::{expected, refused};
use super::token::{Kind, Token};
use carom_checker::claim::lex::GREEK;
use carom_checker::claim::parse::parse_expr;
use carom_checker::claim::print::Style;
use carom_diagnostic::{Diagnostic, Span};
use std::collections::{BTreeMap, BTreeSet};

/// Signs over a letter, which make another name of it.
pub(crate) const ACCENTS: &[&str] = &[
    "bar",
    "overline",
    "tilde",
    "widetilde",
    "hat",
    "widehat",
    "vec",
    "dot",
    "ddot",
    "mathbf",
    "boldsymbol",
    "mathcal",
    "bm",
    "check",
    "breve",
];
/// Commands that set a word upright; the word is what counts.
pub(crate) const UPRIGHT: &[&str] =
    &["mathrm", "text", "textrm", "mathit", "textit", "mathsf", "rm", "operatorname", "mbox"];
/// Greek letters that the claim language writes as another word.
const VARIANTS: &[&str] =
    &["varepsilon", "varphi", "vartheta", "varrho", "varsigma", "varpi", "varkappa", "ell", "hbar"];

/// A name as the paper prints it.
#[derive(Clone, Debug)]
pub(crate) struct Symbol {
    /// The letter with its accent.
    pub base: String,
    /// What stands below it.
    pub below: Option<Vec<Token>>,
    /// The number of its primes.
    pub primes: usize,
    /// Where it stands.
    pub span: Span,
}

impl Symbol {
    /// The key.
    pub(crate) fn key(&self) -> String {
        let below = self.below.as_ref().map_or(String::new(), |below| format!("_{{{}}}", canonical(below)));
        format!("{}{below}{}", self.base, "'".repeat(self.primes))
    }

    /// The key without what stands below.
    pub(crate) fn upper_key(&self) -> String {
        format!("{}{}", self.base, "'".repeat(self.primes))
    }
}

/// Whether a command is a letter.
pub(crate) fn is_letter(command: &str) -> bool {
    GREEK.iter().any(|greek| greek.0 == command) || VARIANTS.contains(&command)
}

/// The letter, with its accent or as a word, that begins at `at`, and where to read on; nothing if no name begins there.
pub(crate) fn base(tokens: &[Token], at: usize) -> Result<Option<(String, usize)>, Diagnostic> {
    let Some(token) = tokens.get(at) else { return Ok(None) };
    Ok(match &token.kind {
        Kind::Char(c) if c.is_ascii_alphabetic() => Some((c.to_string(), at + 1)),
        Kind::Command(name) if key_of(name).is_some() => key_of(name).map(|key| (key.to_string(), at + 1)),
        Kind::Command(name) if is_letter(name) => {
            // The change of a quantity is a name of two letters, where a comment declares it.
            Some((format!("\\{name}"), at + 1))
        }
        Kind::Command(name) if ACCENTS.contains(&name.as_str()) => {
            let (inner, next) = argument(tokens, at + 1)?;
            let inner = canonical(inner);
            let is_plain = inner.chars().all(|c| c.is_ascii_alphanumeric() || "\\_{}' ".contains(c));
            if inner.is_empty() || !is_plain {
                let help = "put a sign over a single letter, and declare it: `%carom given \\bar{v} real`";
                return Err(refused(format!("\\{name} over {inner} is not read"), help, token.span));
            }
            Some((format!("\\{name}{{{inner}}}"), next))
        }
        Kind::Command(name) if UPRIGHT.contains(&name.as_str()) && name != "text" && name != "mbox" => {
            let (inner, next) = argument(tokens, at + 1)?;
            Some((canonical(inner), next))
        }
        _ => None,
    })
}

/// Reads primes and what stands below a letter, from `at` on.
pub(crate) fn scripts(
    tokens: &[Token],
    base: String,
    start: Span,
    mut at: usize,
) -> Result<(Symbol, usize), Diagnostic> {
    let mut symbol = Symbol { base, below: None, primes: 0, span: start };
    loop {
        match tokens.get(at) {
            Some(token) if token.is_char('\'') => {
                symbol.primes += 1;
                at += 1;
            }
            Some(token) if token.is_char('^') => {
                let Some((count, next)) = primes(tokens, at + 1) else { break };
                symbol.primes += count;
                at = next;
            }
            Some(token) if token.is_char('_') && symbol.below.is_none() => {
                let (inner, next) = argument(tokens, at + 1)?;
                if let [one] = inner
                    && one.char().is_some_and(|c| c.is_ascii_digit())
                    && tokens[at + 1].kind != Kind::Open
                    && tokens.get(next).is_some_and(|t| !t.apart && t.char().is_some_and(|c| c.is_ascii_digit()))
                {
                    let message = "an index of two digits without braces prints as an index of one digit and a factor";
                    return Err(refused(message, "write the braces, as in x_{12}", token.span));
                }
                symbol.below = Some(inner.to_vec());
                at = next;
            }
            _ => break,
        }
        symbol.span.end = tokens[at - 1].span.end.max(symbol.span.end);
    }
    Ok((symbol, at))
}

/// The primes of `^\prime` or `^{\prime\prime}`, behind `^`.
fn primes(tokens: &[Token], at: usize) -> Option<(usize, usize)> {
    if tokens.get(at)?.is("prime") {
        return Some((1, at + 1));
    }
    if tokens.get(at)?.kind != Kind::Open {
        return None;
    }
    let (inner, next) = group(tokens, at).ok()?;
    let all = !inner.is_empty() && inner.iter().all(|t| t.is("prime") || t.is_char('\''));
    all.then_some((inner.len(), next))
}

/// The argument at `at`: a group, one command with its group, or one token.
pub(crate) fn argument(tokens: &[Token], at: usize) -> Result<(&[Token], usize), Diagnostic> {
    let is_mark = |t: &&Token| t.command().is_some_and(|name| UPRIGHT.contains(&name) || ACCENTS.contains(&name));
    let marks = tokens.get(at..).unwrap_or_default().iter().take_while(is_mark).count();
    let last = at + marks;
    match tokens.get(last) {
        Some(Token { kind: Kind::Open, .. }) if marks == 0 => group(tokens, at),
        Some(Token { kind: Kind::Open, .. }) => group(tokens, last).map(|(_, next)| (&tokens[at..next], next)),
        Some(_) => Ok((&tokens[at..=last], last + 1)),
        None => {
            let span = tokens.last().map_or(Span::default(), |t| t.span);
            Err(expected("an argument", "the end of the formula", span))
        }
    }
}

/// Tokens in the form that the claim language's printer gives to names.
pub(crate) fn canonical(tokens: &[Token]) -> String {
    let mut out = String::new();
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        match &token.kind {
            Kind::Char('_') => {
                let inner = argument(tokens, at).map_or((&tokens[at..], tokens.len()), |found| found);
                out.push_str(&format!("_{{{}}}", canonical(inner.0)));
                at = inner.1.max(at);
            }
            Kind::Char(c) => {
                let after_command =
                    out.rfind('\\').is_some_and(|i| out[i + 1..].chars().all(|c| c.is_ascii_alphabetic()));
                if after_command && c.is_ascii_alphabetic() {
                    out.push(' ');
                }
                out.push(*c);
            }
            Kind::Command(name) if UPRIGHT.contains(&name.as_str()) => {}
            Kind::Command(name) if SPACES.contains(&name.as_str()) => {}
            Kind::Command(name) => out.push_str(&format!("\\{name}")),
            _ => {}
        }
    }
    out
}

/// Whether a name stands somewhere in these tokens.
pub(crate) fn mentions(tokens: &[Token], key: &str) -> bool {
    (0..tokens.len()).any(|at| begin(&tokens[at..]).is_some_and(|found| found.0.key() == key))
}

/// Whether a sign may stand in a name of the claim language.
pub(crate) fn is_in_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_' || c == '\''
}

/// The names, words and numerals of a text in the claim language.
pub(crate) fn words_of(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c| !is_in_word(c))
}

/// The name that begins these tokens, and where it ends.
pub(crate) fn begin(tokens: &[Token]) -> Option<(Symbol, usize)> {
    let (first, next) = base(tokens, 0).ok()??;
    scripts(tokens, first, tokens[0].span, next).ok()
}

/// What a name of the paper is in the claim language.
#[derive(Clone, Debug, Default)]
pub(crate) struct Names {
    /// The spelling of a key.
    spelling: BTreeMap<String, String>,
    /// The key of a spelling.
    key: BTreeMap<String, String>,
    /// Keys that stand for an expression, as `m_{12}` for `m(12)`.
    meaning: BTreeMap<String, String>,
    /// Names of several signs: what prints, and the key.
    pub phrases: Vec<(Vec<Kind>, String)>,
    /// What a member of a family is, by its key.
    pub members: BTreeMap<String, String>,
    /// Spellings of numbers behind which a parenthesis, or a number, is a factor.
    pub factors: BTreeSet<String>,
    /// Keys to which a comment gives a name.
    pub renamed: BTreeSet<String>,
    /// How often each key occurs in equations.
    pub count: BTreeMap<String, usize>,
    /// Spellings of functions that a formula defines, as f(x): an index below such a name is no argument.
    pub functions: BTreeSet<String>,
}

impl Names {
    /// The spelling of a key, if it has one.
    pub(crate) fn spelled(&self, key: &str) -> Option<&str> {
        self.spelling.get(key).map(String::as_str)
    }

    /// The expression that a key stands for, if a comment says one.
    pub(crate) fn meaning(&self, key: &str) -> Option<&str> {
        self.meaning.get(key).map(String::as_str)
    }

    /// The spelling of a name that the claim language's author wrote.
    pub(crate) fn identifier(&mut self, name: &str) -> String {
        let key = Style::Latex.name(name);
        match self.spelling.get(&key) {
            Some(spelling) => spelling.clone(),
            None => {
                if !self.key.contains_key(name) {
                    self.spelling.insert(key.clone(), name.to_string());
                    self.key.insert(name.to_string(), key);
                }
                name.to_string()
            }
        }
    }

    /// The spelling of a name that is written as LaTeX; a new one is made if it has none.
    pub(crate) fn of(&mut self, symbol: &Symbol) -> Result<String, Diagnostic> {
        let key = symbol.key();
        if let Some(spelling) = self.spelling.get(&key) {
            return Ok(spelling.clone());
        }
        let Some(spelling) = spelling(&key) else {
            let help = format!("give it a name of letters and digits: `%carom name {key} as x1`");
            return Err(refused(format!("the name {key} has no spelling in the claim language"), help, symbol.span));
        };
        self.set(&key, &spelling, symbol.span)?;
        Ok(spelling)
    }

    /// Gives a key its spelling, or the expression that it stands for.
    pub(crate) fn set(&mut self, key: &str, spelling: &str, span: Span) -> Result<(), Diagnostic> {
        if !spelling.chars().all(is_in_word) {
            parse_expr(spelling).map_err(|_| {
                let help = format!("write a name or an expression behind `as`: `%carom name {key} as x1`");
                refused(format!("what {key} stands for is no expression of the claim language"), help, span)
            })?;
            self.meaning.insert(key.to_string(), spelling.to_string());
            return Ok(());
        }
        if let Some(other) = self.key.get(spelling).filter(|other| *other != key) {
            let message = format!("the names {other} and {key} would both be {spelling}");
            let help = format!("give one of them another name: `%carom name {key} as …`");
            return Err(refused(message, help, span));
        }
        self.spelling.insert(key.to_string(), spelling.to_string());
        self.key.insert(spelling.to_string(), key.to_string());
        Ok(())
    }

    /// Whether a comment gives this key its name.
    pub(crate) fn is_renamed(&self, key: &str) -> bool {
        self.renamed.contains(key)
    }

    /// Whether a comment names a value of this function, as v(t) is one of v, or of any.
    pub(crate) fn has_values(&self, of: Option<&str>) -> bool {
        let is = |key: &str| of.is_none_or(|of| key.strip_prefix(of).is_some_and(|rest| rest.starts_with('(')));
        self.spelling.keys().any(|key| key.ends_with(')') && is(key))
    }

    /// Counts an occurrence in an equation.
    pub(crate) fn seen(&mut self, key: &str) {
        *self.count.entry(key.to_string()).or_default() += 1;
    }
}

/// The spelling that a key gets of its own: `m1`, `v1'`, `v_max`, `bar_v`.
fn spelling(key: &str) -> Option<String> {
    let bare = key.trim_end_matches('\'');
    let marks = &key[bare.len()..];
    let bare = &bare.replace("_{+}", "_plus").replace("_{-}", "_minus");
    if !bare.chars().all(|c| c.is_ascii_alphanumeric() || "\\{}_, ".contains(c)) {
        return None;
    }
    let parts: Vec<&str> = bare.split(|c: char| !c.is_ascii_alphanumeric()).filter(|part| !part.is_empty()).collect();
    if !parts.first()?.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return None;
    }
    let is_number = |text: &str| text.chars().all(|c| c.is_ascii_digit());
    Some(match parts.as_slice() {
        [head, tail] if is_number(tail) => format!("{head}{tail}{marks}"),
        _ => format!("{}{marks}", parts.join("_")),
    })
}
