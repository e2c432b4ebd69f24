//! From text to syntax trees.
//!
//! Contract: [`parse`] returns every claim of a file, or every fault that it found, never both, and
//! never panics. After a fault it continues at the next clause, so that one run reports several.
//! Nesting is limited by [`MAX_DEPTH`]; time is linear in the number of tokens but for parentheses
//! that may open a proposition or an expression, which are decided by one look ahead.

mod clause;
mod define;
mod expression;
mod given;
mod limit;
mod proof;
mod proposition;
mod unit;
mod well_founded;

use super::diagnostic::{Diagnostic, Fault, behind_a_statement, domain, foreign, nearest};
use super::lex::{FILE_LIMIT, Kind, Token, tokens};
use super::preamble::Preamble;
use super::print::Style;
use super::syntax::*;
use super::total::Values;
use proposition::relation_of;
use std::collections::{BTreeMap, BTreeSet};

/// Words that begin a clause.
pub(super) const CLAUSES: &[&str] = &[
    "claim", "paper", "text", "source", "section", "number", "reading", "note", "using", "given", "let", "define",
    "assume", "sample", "prove", "expect",
];

/// Words that begin a clause of a preamble.
const PREAMBLE: &[&str] = &["paper", "source", "section", "reading", "given", "let", "define", "assume"];

/// What is expected after the names of a declaration.
const DOMAIN: &str = "a domain: `real`, `natural`, `integer`, `> 0`, `in [0, 1]` or `in 1..n`";

/// Where a limit goes, and where a sum has no end.
const INFINITY: &str = "infinity";

/// Words that cannot be names of variables.
const RESERVED: &[&str] = &[
    "claim",
    "source",
    "section",
    "number",
    "reading",
    "note",
    "using",
    "given",
    "let",
    "define",
    "assume",
    "prove",
    "expect",
    "and",
    "or",
    "not",
    "exists",
    "for",
    "all",
    "each",
    "in",
    "is",
    "at",
    "over",
    "of",
    "as",
    "by",
    "with",
    "maximum",
    "minimum",
    "limit",
    INFINITY,
    "have",
    "obtain",
    "case",
    "real",
    "natural",
    "sum",
    "product",
    "integral",
    "derivative",
    "only",
    "conclude",
];

/// Whether a word is the name of a function that the language knows.
fn is_function(word: &str) -> bool {
    is_built_in(word)
        || super::trigonometry::is_function(word)
        || super::abbreviation::is_one(word)
        || super::floor::is_function(word)
}

/// What a parser expects behind a clause.
const END_OF_CLAUSE: &str = "the end of the clause";

/// Whether a word begins a clause of a claim.
pub fn begins_clause(word: &str) -> bool {
    CLAUSES.contains(&word)
}

/// Whether a word is a keyword, which cannot be a name.
pub fn is_keyword(word: &str) -> bool {
    RESERVED.contains(&word) || begins_clause(word)
}

/// The claims of a source text.
pub fn parse(source: &str) -> Result<Vec<Claim>, Vec<Diagnostic>> {
    parse_under(source, &Preamble::default()).map(|file| file.0)
}

/// The claims of a source text under the preamble of its folder, and the preamble that the file leaves to others.
///
/// A returned claim contains the declarations that it takes from the preambles, and all abbreviations are expanded.
pub fn parse_under(source: &str, folder: &Preamble) -> Result<(Vec<Claim>, Preamble), Vec<Diagnostic>> {
    parse_placed(source, folder, &|span| span)
}

/// The same for a text that was made from another one: `place` gives each part of it its place there, which all places of
/// the claims and of the faults are.
pub fn parse_placed(
    source: &str,
    folder: &Preamble,
    place: &dyn Fn(Span) -> Span,
) -> Result<(Vec<Claim>, Preamble), Vec<Diagnostic>> {
    let mut faults = Vec::new();
    let (mut claims, mut preamble) = clauses_placed(source, folder, place)?;
    super::alpha_conversion::convert(&mut preamble.items);
    super::check::preamble(&preamble, &mut faults);
    if faults.is_empty() {
        super::dimension::preamble(&preamble, &mut faults);
    }
    if faults.is_empty() {
        for claim in &mut claims {
            preamble.put_before(claim, &mut faults);
            super::alpha_conversion::convert(&mut claim.items);
            super::check::check(claim, &mut faults);
        }
    }
    if faults.is_empty() {
        claims.iter().for_each(|claim| super::dimension::check(claim, &mut faults));
    }
    if faults.is_empty() {
        claims.iter_mut().for_each(|claim| super::write_out::write_out(claim, &mut faults));
    }
    if faults.is_empty() {
        claims.iter_mut().for_each(|claim| super::constants::check(claim, &mut faults));
    }
    if faults.is_empty() { Ok((claims, preamble)) } else { Err(faults) }
}

/// The clauses of a file as they are written: no name is looked up.
pub fn clauses(source: &str, folder: &Preamble) -> Result<(Vec<Claim>, Preamble), Vec<Diagnostic>> {
    clauses_placed(source, folder, &|span| span)
}

/// The same for a text that was made from another one, as in [`parse_placed`].
pub fn clauses_placed(
    source: &str,
    folder: &Preamble,
    place: &dyn Fn(Span) -> Span,
) -> Result<(Vec<Claim>, Preamble), Vec<Diagnostic>> {
    if source.len() > FILE_LIMIT {
        let fault = Fault::Limit { name: "bytes in a claim file", allowed: FILE_LIMIT };
        return Err(vec![Diagnostic::new(fault, Span::default())]);
    }
    let (mut tokens, mut faults) = tokens(source);
    tokens.iter_mut().for_each(|token| token.span = place(token.span));
    faults.iter_mut().for_each(|fault| fault.span = place(fault.span));
    let mut parser = Parser::new(tokens, faults);
    parser.preamble = folder.clone();
    let claims = parser.claims();
    let mut faults = parser.faults;
    if claims.is_empty() && faults.is_empty() && !parser.preamble.is_said {
        faults.push(Diagnostic::new(Fault::Empty, Span { start: 0, end: source.len().min(1) }));
    }
    if faults.is_empty() { Ok((claims, parser.preamble)) } else { Err(faults) }
}

/// The names of the claims in a file, be it faulty or not.
pub fn claim_names(source: &str) -> Vec<String> {
    let (tokens, _) = tokens(source);
    let begins = |token: &Token| token.first_on_line && token.kind == Kind::Word("claim".to_string());
    let pairs = tokens.windows(2).filter(|pair| begins(&pair[0]));
    pairs
        .filter_map(|pair| match &pair[1].kind {
            Kind::Word(name) => Some(name.clone()),
            _ => None,
        })
        .collect()
}

/// The text of a file's bytes.
pub fn text_of(bytes: &[u8]) -> Result<&str, Vec<Diagnostic>> {
    std::str::from_utf8(bytes).map_err(|fault| {
        let start = fault.valid_up_to();
        vec![Diagnostic::new(Fault::NotText, Span { start, end: start + 1 })]
    })
}

/// The claims of a file's bytes.
pub fn parse_bytes(bytes: &[u8]) -> Result<Vec<Claim>, Vec<Diagnostic>> {
    parse(text_of(bytes)?)
}

/// A proposition by itself, for tests and tools.
pub fn parse_prop(source: &str) -> Result<Prop, Vec<Diagnostic>> {
    let (tokens, faults) = tokens(source);
    let mut parser = Parser::new(tokens, faults);
    let prop = parser.prop();
    if let Ok(prop) = prop
        && parser.faults.is_empty()
        && parser.peek() == &Kind::End
    {
        return Ok(prop);
    }
    if parser.faults.is_empty() {
        parser.expected("the end of the statement");
    }
    Err(parser.faults)
}

/// An expression by itself, for certificates and tools.
pub fn parse_expr(source: &str) -> Result<Expr, Vec<Diagnostic>> {
    let (tokens, faults) = tokens(source);
    let mut parser = Parser::new(tokens, faults);
    let expr = parser.expr();
    if let Ok(expr) = expr
        && parser.faults.is_empty()
        && parser.peek() == &Kind::End
    {
        return Ok(expr);
    }
    if parser.faults.is_empty() {
        parser.expected("the end of the expression");
    }
    Err(parser.faults)
}

/// The fault has been reported; the caller gives up its construct.
struct Reported;

type Parsed<T> = Result<T, Reported>;

struct Parser {
    tokens: Vec<Token>,
    at: usize,
    depth: usize,
    /// The names of the claim so far, by their printed form.
    printed: BTreeMap<String, String>,
    /// The preamble, which the claims of the file share.
    preamble: Preamble,
    /// The names that the claim, or the preamble, has declared so far.
    declared: BTreeSet<String>,
    /// The names that a quantifier, a sum, a parameter or a label of the claim introduces.
    bound: BTreeSet<String>,
    /// What the preamble's declarations and those of the claim so far tell of names.
    values: Values,
    /// The variables of limits, and whether they are natural numbers, if the file says so.
    growing: Vec<(Name, Option<bool>)>,
    /// The word `integer` of the declaration that was just read.
    whole: Option<Span>,
    /// Whether the text comes from a claim file, not from a certificate or a tool.
    file: bool,
    /// The keywords that the preamble and the claim so far use as names. The first use is a fault, which explains the others.
    refused: Vec<String>,
    /// How many of them the preamble uses.
    refused_before: usize,
    faults: Vec<Diagnostic>,
    /// How many of the faults are the lexer's. They come first, in the order of their places.
    lexed: usize,
}

impl Parser {
    fn new(tokens: Vec<Token>, faults: Vec<Diagnostic>) -> Parser {
        Parser {
            tokens,
            at: 0,
            depth: 0,
            printed: BTreeMap::new(),
            preamble: Preamble::default(),
            declared: BTreeSet::new(),
            bound: BTreeSet::new(),
            values: Values::default(),
            growing: Vec::new(),
            whole: None,
            file: false,
            refused: Vec::new(),
            refused_before: 0,
            lexed: faults.len(),
            faults,
        }
    }

    fn peek(&self) -> &Kind {
        &self.tokens[self.at].kind
    }

    fn peek_at(&self, ahead: usize) -> &Kind {
        &self.tokens[(self.at + ahead).min(self.tokens.len() - 1)].kind
    }

    fn span(&self) -> Span {
        self.tokens[self.at].span
    }

    /// Where something is missing: here, or behind the last token where the next claim begins here, so that the fault is one of the
    /// claim that is not finished.
    fn missing(&self) -> Span {
        let begins = self.tokens[self.at].first_on_line && self.is_word("claim");
        if begins && self.at > 0 { self.since(self.last_end()) } else { self.span() }
    }

    fn last_end(&self) -> usize {
        if self.at == 0 { 0 } else { self.tokens[self.at - 1].span.end }
    }

    fn since(&self, start: usize) -> Span {
        Span { start, end: self.last_end().max(start) }
    }

    fn advance(&mut self) -> Token {
        let token = self.tokens[self.at].clone();
        if self.at + 1 < self.tokens.len() {
            self.at += 1;
        }
        token
    }

    fn sign(&mut self, sign: &str) -> bool {
        let found = matches!(self.peek(), Kind::Sign(s) if *s == sign);
        if found {
            self.advance();
        }
        found
    }

    fn is_word(&self, word: &str) -> bool {
        matches!(self.peek(), Kind::Word(w) if w == word)
    }

    fn word(&mut self, word: &str) -> bool {
        let found = self.is_word(word);
        if found {
            self.advance();
        }
        found
    }

    fn need_sign(&mut self, sign: &str, what: &str) -> Parsed<()> {
        if self.sign(sign) { Ok(()) } else { Err(self.expected(&format!("`{sign}` {what}"))) }
    }

    fn need_word(&mut self, word: &str) -> Parsed<()> {
        if self.word(word) { Ok(()) } else { Err(self.expected(&format!("`{word}`"))) }
    }

    fn found(&self) -> String {
        match self.peek() {
            Kind::Word(w) => format!("`{w}`"),
            Kind::Number(n) => format!("the number {}", n.chars().take(20).collect::<String>()),
            Kind::Raised(n) => format!("the power {}", n.chars().take(20).collect::<String>()),
            Kind::Text(_) => "a text".to_string(),
            Kind::Sign(s) => format!("`{s}`"),
            Kind::End => "the end of the file".to_string(),
        }
    }

    fn expected(&mut self, expected: &str) -> Reported {
        self.expected_with(expected, None)
    }

    /// Reports what is expected here, unless a fault that is already reported explains it.
    fn expected_with(&mut self, expected: &str, help: Option<String>) -> Reported {
        if self.is_explained() {
            return Reported;
        }
        if let Some((word, span, help)) = self.foreign_word(expected) {
            return self.other(&format!("the claim language has no `{word}`"), Some(help), span);
        }
        let help = help.or_else(|| {
            let previous = self.at.checked_sub(1).map(|i| &self.tokens[i]);
            let is_name = |word: &str| !RESERVED.contains(&word) && !CLAUSES.contains(&word);
            let product = |word: &str| is_name(word) && self.in_expression();
            let next = self.peek_at(1);
            if let Some(help) = self.function_without_parentheses() {
                return Some(help);
            }
            match (previous.map(|t| &t.kind), self.peek()) {
                // The line before is complete, so the word was meant to begin a clause.
                (_, Kind::Word(w)) if self.tokens[self.at].first_on_line && is_name(w) => {
                    let near = || nearest(w, CLAUSES.iter().copied()).map(|near| format!("did you mean `{near}`?"));
                    behind_a_statement(w).map(str::to_string).or_else(near)
                }
                (_, Kind::Word(w)) if matches!(w.as_str(), "in" | INFINITY) => foreign(w).map(str::to_string),
                (Some(Kind::Word(w)), _) if expected == "`of`" => foreign(w).map(str::to_string),
                (Some(Kind::Word(w)), Kind::Sign("!")) if w == "exists" => foreign("exists !").map(str::to_string),
                (_, Kind::Word(w)) if expected == END_OF_CLAUSE && behind_a_statement(w).is_some() => {
                    behind_a_statement(w).map(str::to_string)
                }
                (_, Kind::Word(w)) if w == "with" => {
                    Some("put a condition in: `maximum of x*y` with x + y = 1 is `maximum of x*(1 - x)`".to_string())
                }
                (_, Kind::Sign(";")) if expected == END_OF_CLAUSE => Some("begin the next `let` or `assume` on a line of its own".to_string()),
                (Some(Kind::Number(a)), Kind::Sign(",")) if self.is_joined() && matches!(next, Kind::Number(_)) => match next {
                    Kind::Number(b) if b.len() == 3 => {
                        Some(format!("write {a}{b} without a separator, or {a}.{b} if the comma is a decimal one"))
                    }
                    Kind::Number(b) => Some(format!("write {a}.{b} with a decimal point")),
                    _ => None,
                },
                (_, Kind::Sign(",")) if expected == END_OF_CLAUSE && self.peek_at(2) != &Kind::Sign("->") => {
                    Some("join two statements by `and`; begin the next `let` or `assume` on a line of its own".to_string())
                }
                (_, Kind::Word(w)) if w == "is" && expected.starts_with("a comparison sign") => Some(
                    "say it with numbers: that f rises is `for all x, y > 0: x < y => f(x) < f(y)`, its greatest value is `maximum of f(x) \
                     over x > 0 at x = 1 is 2`"
                        .to_string(),
                ),
                (_, Kind::Sign(",")) if expected == END_OF_CLAUSE && self.peek_at(2) == &Kind::Sign("->") => {
                    Some("say where a variable goes by `as`: `sin(x) = x + O(x^3) as x -> 0`".to_string())
                }
                (_, Kind::Word(w)) if w == "for" && expected == "`over`" => Some("write `over` before the domain: over x > 0".to_string()),
                (_, Kind::Sign("=")) if expected == "`is`" => Some("write `is` before the value".to_string()),
                (Some(Kind::Sign("=")), Kind::Sign("<")) => Some("write <=".to_string()),
                (Some(Kind::Sign("<")), Kind::Sign(">")) => Some("write !=".to_string()),
                (Some(Kind::Sign(a)), Kind::Sign(b)) if a == b && relation_of(a).is_some() => {
                    Some(format!("write one sign: {a}"))
                }
                (_, Kind::Sign("=>")) => Some("write >= for a comparison; `A => B` joins two statements".to_string()),
                (Some(Kind::Sign("<")), Kind::Sign("->")) => foreign("<->").map(str::to_string),
                (_, Kind::Sign("->")) if !expected.starts_with("`=`") => foreign("->").map(str::to_string),
                (_, Kind::Sign(":")) if *next == Kind::Sign("=") => Some("write = for :=".to_string()),
                (_, Kind::Sign("|")) if *next == Kind::Sign("|") => Some("write `or`".to_string()),
                (Some(Kind::Number(_) | Kind::Word(_) | Kind::Sign(")")), Kind::Sign("|")) if expected != DOMAIN => {
                    foreign("divides").map(|help| format!("{help}; for a product with |x| write *"))
                }
                (Some(Kind::Word(w)), Kind::Sign("{")) if w == "in" => foreign(w).map(str::to_string),
                (_, Kind::Sign("==")) if *next == Kind::Sign(">") => foreign("->").map(str::to_string),
                (_, Kind::Sign("==")) => Some("equality is written with one sign: a = b".to_string()),
                (_, Kind::Sign("**")) => Some("powers are written a^b".to_string()),
                (Some(Kind::Number(n)), Kind::Word(w)) if is_name(w) => Some(format!("write {n}*{w}")),
                (Some(Kind::Number(n)), Kind::Sign("(")) => Some(format!("write {n}*(…)")),
                (Some(Kind::Sign(")")), Kind::Sign("(")) => Some("write (…)*(…)".to_string()),
                (Some(Kind::Sign(")")), Kind::Word(w)) if is_name(w) => Some(format!("write (…)*{w}")),
                (Some(Kind::Word(a)), Kind::Word(b)) if product(a) && is_name(b) => Some(match expected {
                    DOMAIN => format!("write a comma between names: {a}, {b}"),
                    _ => format!("write {a}*{b} for a product"),
                }),
                (Some(Kind::Word(a)), Kind::Number(n)) if product(a) => {
                    Some(format!("write {a}*{n} for a product, or {a}{n} for a name with an index"))
                }
                (Some(Kind::Sign("^")), Kind::Sign("{")) => Some("group with parentheses, as in a^(n + 1)".to_string()),
                (Some(Kind::Word(name)), _) if expected == DOMAIN && is_name(name) => {
                    Some(format!("declare a real number as `{name} real`"))
                }
                _ => None,
            }
        });
        let fault = Fault::Expected { expected: expected.to_string(), found: self.found(), help };
        let span = self.missing();
        self.faults.push(Diagnostic::new(fault, span));
        Reported
    }

    /// Whether no blank stands between this token and its neighbours.
    fn is_joined(&self) -> bool {
        let spans: Vec<Span> = self.tokens.iter().skip(self.at.saturating_sub(1)).take(3).map(|t| t.span).collect();
        spans.windows(2).all(|pair| pair[0].end == pair[1].start)
    }

    /// Whether a fault that is already reported explains one here: a keyword that the claim uses as a name, here or just
    /// before, or a character of its clause that the language does not have.
    fn is_explained(&self) -> bool {
        let before = self.at.checked_sub(1).map(|i| &self.tokens[i]);
        let is_refused = |token: &Token| match &token.kind {
            Kind::Word(word) => self.refused.contains(word),
            _ => false,
        };
        // Up to the token behind, so that a character after a word is one with it.
        let from = self.clause_begun().map_or(0, |token| token.span.start);
        let to = self.tokens.get(self.at + 1).map_or(self.span().end, |token| token.span.start);
        let between = from..to.max(from);
        let lexed = &self.faults[..self.lexed];
        let first = lexed.partition_point(|fault| fault.span.start < between.start);
        let mut strays = lexed[first..].iter().take_while(|fault| fault.span.start < between.end);
        before.into_iter().chain([&self.tokens[self.at]]).any(is_refused)
            || strays.any(|fault| matches!(fault.fault, Fault::Stray(_)))
    }

    /// What to write for `sin x` or `sin^2(x)` where the fault is behind the name of a function.
    fn function_without_parentheses(&self) -> Option<String> {
        let before = |back: usize| self.at.checked_sub(back).map(|i| &self.tokens[i].kind);
        let (power, of) = match (before(1), before(2)) {
            (Some(Kind::Number(power)), Some(Kind::Sign("^"))) => (power.clone(), before(3)),
            (Some(Kind::Raised(power)), of) => (power.clone(), of),
            _ => (String::new(), before(1)),
        };
        let function = |kind: Option<&Kind>| match kind {
            Some(Kind::Word(word)) if is_function(word) => Some(word.clone()),
            _ => None,
        };
        match self.peek() {
            Kind::Word(argument) if !is_keyword(argument) => function(of).map(|name| match power.as_str() {
                "" => format!("write {name}({argument})"),
                _ => format!("write {name}({argument})^{power}"),
            }),
            Kind::Number(argument) => function(before(1)).map(|name| format!("write {name}({argument}*x)")),
            Kind::Sign("(") if !power.is_empty() => {
                function(of).map(|name| format!("write the power behind the argument: {name}(x)^{power}"))
            }
            _ => None,
        }
    }

    /// The word with which the current clause begins.
    fn clause_begun(&self) -> Option<&Token> {
        let begins = |token: &&Token| {
            token.first_on_line && matches!(&token.kind, Kind::Word(word) if CLAUSES.contains(&word.as_str()))
        };
        self.tokens[..self.at].iter().rev().find(begins)
    }

    /// The word of other languages that explains a fault here, its place and what to write instead: the nearest one of the
    /// clause before this place, or at it, that is no name of the claim.
    fn foreign_word(&self, expected: &str) -> Option<(String, Span, &'static str)> {
        if !self.in_expression() {
            return None;
        }
        for at in (0..=self.at).rev() {
            let (token, next) = (&self.tokens[at], self.tokens.get(at + 1));
            let word = match &token.kind {
                Kind::Word(word) if token.first_on_line && CLAUSES.contains(&word.as_str()) && at < self.at => break,
                Kind::Word(word) if !is_keyword(word) => word,
                Kind::Sign("{" | "}") if at < self.at => break,
                _ => continue,
            };
            // A label, or a name that stands here for a number.
            let is_label = matches!(next, Some(Token { kind: Kind::Sign(":"), .. }));
            let is_domain = expected == DOMAIN && at + 1 >= self.at && domain(word).is_some();
            let is_name = self.declared.contains(word) || self.bound.contains(word) && !is_domain;
            if is_label || is_name || at + 1 < self.at && word.len() <= 2 {
                continue;
            }
            if let Some(Token { kind: Kind::Word(next), .. }) = next
                && ["of", "over"].contains(&next.as_str())
            {
                let form = format!("{word} {next}");
                if let Some(help) = foreign(&form) {
                    return Some((form, token.span, help));
                }
            }
            if let Some(help) = foreign(word) {
                return Some((word.clone(), token.span, help));
            }
        }
        None
    }

    /// Whether the current clause is one of expressions, and no method has begun in it.
    fn in_expression(&self) -> bool {
        for token in self.tokens[..self.at].iter().rev() {
            match &token.kind {
                Kind::Word(word) if token.first_on_line && CLAUSES.contains(&word.as_str()) => {
                    return ["given", "let", "define", "assume", "prove"].contains(&word.as_str());
                }
                Kind::Word(word) if word == "by" => return false,
                _ => {}
            }
        }
        true
    }

    fn other(&mut self, message: &str, help: Option<&str>, span: Span) -> Reported {
        let fault = Fault::Other { message: message.to_string(), help: help.map(str::to_string) };
        self.faults.push(Diagnostic::new(fault, span));
        Reported
    }

    /// Runs a parser one level deeper, unless that is too deep.
    fn deeper<T>(&mut self, parse: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if self.depth >= MAX_DEPTH {
            let span = self.span();
            let fault = Fault::Limit { name: "levels of nesting", allowed: MAX_DEPTH };
            self.faults.push(Diagnostic::new(fault, span));
            // The rest of such a file is of the same kind: stop reading.
            self.at = self.tokens.len() - 1;
            return Err(Reported);
        }
        self.depth += 1;
        let result = parse(self);
        self.depth -= 1;
        result
    }

    /// A name that is no keyword, and does not look in print like another name of the claim: `m_1` and `m1`
    /// are both m with an index.
    fn name(&mut self, what: &str) -> Parsed<Name> {
        match self.peek().clone() {
            Kind::Word(text) if !RESERVED.contains(&text.as_str()) => {
                let span = self.advance().span;
                let first = self.printed.entry(Style::Latex.name(&text)).or_insert_with(|| text.clone());
                if *first != text {
                    let message = format!("the names {first} and {text} look the same in print");
                    self.other(&message, Some("give one of them another name"), span);
                }
                if what != "a name" {
                    self.bound.insert(text.clone());
                }
                Ok(Name { text, span })
            }
            Kind::Word(text) => {
                let help = match text.as_str() {
                    "real" | "natural" => format!("write the domain behind the name: `given x {text}`"),
                    _ => format!("`{text}` is a keyword; choose another name"),
                };
                let reported = self.expected_with(what, Some(help));
                self.refused.push(text);
                Err(reported)
            }
            _ => Err(self.expected(what)),
        }
    }

    fn text(&mut self) -> Parsed<String> {
        match self.peek().clone() {
            Kind::Text(text) => {
                self.advance();
                Ok(text)
            }
            _ => Err(self.expected("a text in quotation marks")),
        }
    }

    /// Whether a clause begins here.
    fn at_clause(&self) -> bool {
        let token = &self.tokens[self.at];
        match &token.kind {
            Kind::End => true,
            Kind::Word(w) => token.first_on_line && CLAUSES.contains(&w.as_str()),
            _ => false,
        }
    }
}
