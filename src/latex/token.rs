//! Tokens of a LaTeX document.
//!
//! Contract: every byte belongs to a token, to white space, to a comment of the author's, or to a verbatim passage; only
//! comments that begin with `%carom` become tokens. Signs outside ASCII that mathematics has a command for become that command.
//! Limits: [`FILE_LIMIT`], [`TOKENS_LIMIT`].

use carom_checker::claim::lex::GREEK;
use carom_diagnostic::{Diagnostic, Fault, Span};

/// The largest document in bytes.
pub const FILE_LIMIT: usize = 1 << 20;
/// Separates the lines of a comment of several lines.
pub(crate) const NEXT_LINE: &str = "\u{c}";
/// The most tokens of a document, and of an equation after its macros are expanded.
pub(crate) const TOKENS_LIMIT: usize = 500_000;

/// A token with its place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Token {
    /// What it is.
    pub kind: Kind,
    /// Where it stands; for what a macro expands to, where the macro stands.
    pub span: Span,
    /// Whether white space is before it.
    pub apart: bool,
}

/// The kinds of tokens.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Kind {
    /// `\frac`, `\,`: the name without the backslash.
    Command(String),
    /// A letter, a digit or a sign.
    Char(char),
    /// `{`
    Open,
    /// `}`
    Close,
    /// `$` or `$$`: the number of signs.
    Dollar(usize),
    /// `%carom …`: the text behind the word, whose place is the token's.
    Comment(String),
}

impl Token {
    /// 1 where it opens a brace or parenthesis, −1 where it closes one: the sum of these is the level of nesting.
    pub(crate) fn nesting(&self) -> i64 {
        match self.kind {
            Kind::Open | Kind::Char('(' | '[') => 1,
            Kind::Close | Kind::Char(')' | ']') => -1,
            _ => 0,
        }
    }

    /// Whether it is this command.
    pub(crate) fn is(&self, name: &str) -> bool {
        matches!(&self.kind, Kind::Command(own) if own == name)
    }

    /// Whether it is a command whose argument is upright words.
    pub(crate) fn is_text(&self) -> bool {
        ["text", "mbox", "textrm", "textnormal"].iter().any(|name| self.is(name))
    }

    /// Whether it is this sign.
    pub(crate) fn is_char(&self, sign: char) -> bool {
        self.kind == Kind::Char(sign)
    }

    /// The command's name.
    pub(crate) fn command(&self) -> Option<&str> {
        if let Kind::Command(name) = &self.kind { Some(name) } else { None }
    }

    /// The letter, digit or sign.
    pub(crate) fn char(&self) -> Option<char> {
        if let Kind::Char(c) = self.kind { Some(c) } else { None }
    }

    /// As its author wrote it.
    pub(crate) fn text(&self) -> String {
        match &self.kind {
            Kind::Command(name) => format!("\\{name}"),
            Kind::Char(c) => c.to_string(),
            Kind::Open => "{".to_string(),
            Kind::Close => "}".to_string(),
            Kind::Dollar(count) => "$".repeat(*count),
            Kind::Comment(_) => "%carom".to_string(),
        }
    }
}

/// Environments whose text is no LaTeX.
const VERBATIM: &[&str] =
    &["verbatim", "verbatim*", "lstlisting", "minted", "comment", "Verbatim", "filecontents", "filecontents*"];

/// Signs, and the commands that print alike.
const SIGNS: &[(char, &str)] = &[
    ('≤', "le"),
    ('≥', "ge"),
    ('≠', "ne"),
    ('≈', "approx"),
    ('·', "cdot"),
    ('⋅', "cdot"),
    ('×', "times"),
    ('±', "pm"),
    ('∓', "mp"),
    ('∞', "infty"),
    ('→', "to"),
    ('⇒', "Rightarrow"),
    ('⇔', "Leftrightarrow"),
    ('∈', "in"),
    ('∂', "partial"),
    ('∫', "int"),
    ('∑', "sum"),
    ('∏', "prod"),
    ('√', "sqrt"),
    ('′', "prime"),
];

/// The tokens of a document.
///
/// # Errors
/// A limit.
pub(crate) fn tokens(source: &str) -> Result<Vec<Token>, Diagnostic> {
    read(source, 0, true)
}

/// The tokens of a clause in a comment, which begins at the byte `from` of the document.
///
/// # Errors
/// A limit.
pub(crate) fn raw_tokens(source: &str, from: usize) -> Result<Vec<Token>, Diagnostic> {
    read(source, from, false)
}

fn read(source: &str, from: usize, has_comments: bool) -> Result<Vec<Token>, Diagnostic> {
    if source.len() > FILE_LIMIT {
        let fault = Fault::Limit { name: "bytes in a LaTeX file", allowed: FILE_LIMIT };
        return Err(Diagnostic::new(fault, Span::default()));
    }
    let mut out: Vec<Token> = Vec::new();
    let mut apart = true;
    let mut at = 0;
    while let Some(c) = source[at..].chars().next() {
        let start = at;
        if out.len() >= TOKENS_LIMIT {
            let fault = Fault::Limit { name: "tokens in a LaTeX file", allowed: TOKENS_LIMIT };
            return Err(Diagnostic::new(fault, Span { start: from + start, end: from + start }));
        }
        at += c.len_utf8();
        if c.is_whitespace() || c == '\u{feff}' {
            apart = true;
            continue;
        }
        let kind = match c {
            '%' if has_comments => {
                let line = source[at..].find('\n').map_or(source.len(), |end| at + end);
                let said = clause(&source[at..line]);
                let begin = line - said.map_or(0, str::len);
                at = line;
                apart = true;
                let mut begin = from + begin;
                for said in said.into_iter().flat_map(|said| said.split(NEXT_LINE)) {
                    let text = said.trim();
                    let start = begin + said.len() - said.trim_start().len();
                    begin += said.len() + NEXT_LINE.len();
                    let span = Span { start, end: start + text.len() };
                    if !text.is_empty() {
                        out.push(Token { kind: Kind::Comment(text.to_string()), span, apart });
                    }
                }
                continue;
            }
            '\\' => {
                let rest = &source[at..];
                let letters = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
                let length = if letters > 0 { letters } else { rest.chars().next().map_or(0, char::len_utf8) };
                let name = &rest[..length];
                at += length;
                if let Some(end) = verbatim(name, &source[at..]).filter(|_| has_comments) {
                    at += end;
                    continue;
                }
                Kind::Command(name.to_string())
            }
            '{' => Kind::Open,
            '}' => Kind::Close,
            '$' => {
                let two = source[at..].starts_with('$');
                at += usize::from(two);
                Kind::Dollar(1 + usize::from(two))
            }
            '−' => Kind::Char('-'),
            _ => match SIGNS.iter().find(|sign| sign.0 == c) {
                Some((_, name)) => Kind::Command((*name).to_string()),
                None => match GREEK.iter().find(|greek| greek.1 == c) {
                    Some((name, _)) => Kind::Command((*name).to_string()),
                    None => Kind::Char(c),
                },
            },
        };
        out.push(Token { kind, span: Span { start: from + start, end: from + at }, apart });
        apart = false;
    }
    Ok(out)
}

/// What a comment says to Carom: the text behind `carom`, with that word where it is joined to another, which is then no
/// clause. A second `%` makes it a comment for people alone.
pub(crate) fn clause(comment: &str) -> Option<&str> {
    let said = comment.trim_start();
    let rest = said.strip_prefix("carom")?;
    let is_word = rest.is_empty() || rest.starts_with(|c: char| c.is_whitespace() || "{:".contains(c));
    Some(if is_word { rest.trim_start_matches(|c: char| c.is_whitespace() || c == ':') } else { said })
}

/// The length of the verbatim passage that a command begins, if it begins one.
fn verbatim(command: &str, rest: &str) -> Option<usize> {
    if command == "verb" {
        let rest_of = rest.strip_prefix('*').unwrap_or(rest);
        let fence = rest_of.chars().next()?;
        let skipped = rest.len() - rest_of.len() + fence.len_utf8();
        return rest[skipped..].find(fence).map(|end| skipped + end + fence.len_utf8());
    }
    if command != "begin" {
        return None;
    }
    let name = VERBATIM.iter().find(|name| rest.starts_with(&format!("{{{name}}}")))?;
    let end = format!("\\end{{{name}}}");
    Some(rest.find(&end).map_or(rest.len(), |at| at + end.len()))
}

/// The text of tokens as words: what was apart stays apart.
pub(crate) fn words(tokens: &[Token]) -> String {
    let mut out = String::new();
    for token in tokens {
        let spacing = matches!(token.command(), Some(" " | "," | ";" | ":" | "quad" | "qquad" | "~"));
        if (token.apart || spacing) && !out.is_empty() && !out.ends_with(' ') {
            out.push(' ');
        }
        if !spacing && !matches!(token.kind, Kind::Open | Kind::Close) {
            out.push_str(&token.text());
        }
    }
    out.trim().to_string()
}
