//! A document's parts in order: clauses in comments, and displayed equations with their rows.
//!
//! Contract: every displayed formula is a [`Display`] or a fault; formulas in running text are counted, unless a comment behind
//! them, `%carom inline`, makes one a [`Display`]. A comment on a line of
//! an equation belongs to the row that the line ends, one on a line of its own to the row that follows.

use super::comment::first_word;
use super::macros::{Macros, defines, group};
use super::number::Numbers;
use super::refusal::refused;
use super::script::with_scripts;
use super::structure::unknown_condition;
use super::token::{Kind, Token, words};
use carom_diagnostic::{Diagnostic, Span};
use std::ops::Range;

mod rows;

pub(crate) use rows::cells;

/// What a comment says, without `%carom`.
#[derive(Clone, Debug)]
pub(crate) struct Clause {
    /// The text.
    pub text: String,
    /// Its place.
    pub span: Span,
}

/// A row of a displayed formula.
#[derive(Clone, Debug, Default)]
pub(crate) struct Row {
    /// Its cells, as `&` separates them.
    pub cells: Vec<Vec<Token>>,
    /// The comments in it.
    pub clauses: Vec<Clause>,
    /// `\label{…}`
    pub label: Option<String>,
    /// Its number in print.
    pub number: Option<String>,
    /// Where it stands.
    pub span: Span,
    /// Why its formula is not read.
    pub fault: Option<Diagnostic>,
}

/// A displayed formula.
#[derive(Debug)]
pub(crate) struct Display {
    /// The environment, `[` for `\[ … \]`, `$` for a marked formula in running text.
    pub environment: String,
    /// Its rows.
    pub rows: Vec<Row>,
    /// Where it stands.
    pub span: Span,
}

/// A part of a document.
pub(crate) enum Part {
    /// A clause for all equations that follow.
    Shared(Clause),
    /// A displayed formula, macros expanded.
    Display(Display),
    /// What could not be read, and whether that may be a hypothesis or a declaration.
    Fault(Diagnostic, bool),
}

/// A document's parts.
#[derive(Default)]
pub(crate) struct Document {
    /// In order.
    pub parts: Vec<Part>,
    /// The number of formulas in running text.
    pub inline: usize,
}

/// Environments of displayed formulas.
pub(crate) const DISPLAYS: &[&str] =
    &["equation", "align", "gather", "multline", "eqnarray", "flalign", "alignat", "displaymath", "math"];
/// Environments of other packages that are written like one of these.
const ALIKE: &[(&str, &str)] = &[("IEEEeqnarray", "eqnarray"), ("dmath", "equation"), ("xalignat", "alignat")];
/// Environments of displayed formulas that are not read.
const NOT_READ: &[&str] = &["empheq", "darray", "dseries", "dgroup", "numcases", "subnumcases"];
/// Reads a document from its tokens; `lines` says in which line a byte stands, `unread` why a file was not read.
pub(crate) fn document(tokens: &[Token], lines: &Lines, unread: &[Diagnostic]) -> Document {
    let mut reader = Reader {
        tokens,
        lines,
        unread,
        macros: Macros::default(),
        numbers: Numbers::default(),
        inline: Vec::new(),
        out: Document::default(),
    };
    let mut at = 0;
    while at < tokens.len() {
        at = reader.part(at).max(at + 1);
    }
    reader.out
}

/// Where the lines of a text begin.
pub(crate) struct Lines(Vec<usize>);

impl Lines {
    /// Of a text.
    pub(crate) fn of(source: &str) -> Lines {
        Lines(std::iter::once(0).chain(source.match_indices('\n').map(|(at, _)| at + 1)).collect())
    }

    /// The number of the line in which a byte stands, from 1.
    pub(crate) fn line(&self, at: usize) -> usize {
        self.0.partition_point(|start| *start <= at)
    }
}

struct Reader<'a> {
    tokens: &'a [Token],
    lines: &'a Lines,
    unread: &'a [Diagnostic],
    macros: Macros,
    numbers: Numbers,
    /// Formulas in running text: the tokens of each, its signs included, and the line on which it ends.
    inline: Vec<(Range<usize>, usize)>,
    out: Document,
}

impl Reader<'_> {
    fn fault(&mut self, fault: Diagnostic, declares: bool) {
        self.out.parts.push(Part::Fault(fault, declares));
    }

    /// Reads the part that begins at a token, and returns where to read on.
    fn part(&mut self, at: usize) -> usize {
        let token = &self.tokens[at];
        let is_environment = token.is("begin") || token.is("end");
        if !is_environment {
            self.macros.passes(token);
        }
        match &token.kind {
            Kind::Comment(text) if first_word(text) == "inline" => {
                self.marked(text, token);
                at + 1
            }
            Kind::Comment(text) => {
                let clause = Clause { text: text.clone(), span: token.span };
                match self.out.parts.last_mut() {
                    // A comment behind the end of a formula, on its line.
                    Some(Part::Display(display))
                        if !display.rows.is_empty()
                            && self.lines.line(display.span.end.saturating_sub(1))
                                == self.lines.line(token.span.start) =>
                    {
                        if let Some(row) = display.rows.last_mut() {
                            row.clauses.push(clause);
                        }
                    }
                    _ => self.out.parts.push(Part::Shared(clause)),
                }
                at + 1
            }
            Kind::Dollar(2) => self.until(at, |t| t.kind == Kind::Dollar(2), "$$"),
            Kind::Dollar(_) => self.inline(at, |t| t.kind == Kind::Dollar(1)),
            Kind::Command(name) => match name.as_str() {
                "[" => self.until(at, |t| t.is("]"), "["),
                "(" => self.inline(at, |t| t.is(")")),
                "begin" => self.begin(at),
                "end" => self.end(at),
                "input" | "include" => {
                    let why = self.unread.iter().find(|why| why.span.start == token.span.start).cloned();
                    let help = "audit the paper's main file where it lies, or put the text here";
                    let here = || refused(format!("this \\{name} is not followed"), help, token.span);
                    self.fault(why.unwrap_or_else(here), true);
                    at + 1
                }
                "import" | "subimport" | "subfile" | "InputIfFileExists" | "includeonly" => {
                    let help = "write \\input for files that are read";
                    self.fault(refused(format!("\\{name} is not followed"), help, token.span), true);
                    at + 1
                }
                name if unknown_condition(name).is_some() => {
                    let declares = unknown_condition(name) == Some(true);
                    let help = "remove the condition, or what is not meant to print";
                    self.fault(refused("what stands in this condition may not print", help, token.span), declares);
                    at + 1
                }
                name if defines(name) => match self.macros.define(self.tokens, at) {
                    Ok(next) => {
                        self.unheard(at..next);
                        next
                    }
                    Err(fault) => {
                        self.fault(fault, false);
                        at + 1
                    }
                },
                name => {
                    self.numbers.command(name, &self.tokens[at + 1..]);
                    at + 1
                }
            },
            _ => at + 1,
        }
    }

    /// A formula in running text.
    fn inline(&mut self, at: usize, ends: impl Fn(&Token) -> bool) -> usize {
        match self.tokens[at + 1..].iter().position(ends) {
            Some(length) => {
                let next = at + length + 2;
                self.seen_inline(at..next);
                next
            }
            None => {
                let help = "close it with the same sign; a sign for money is \\$";
                self.fault(refused("this formula is not closed", help, self.tokens[at].span), false);
                self.tokens.len()
            }
        }
    }

    /// Comments where none is read.
    fn unheard(&mut self, place: Range<usize>) {
        for comment in self.tokens[place].iter().filter(|t| matches!(t.kind, Kind::Comment(_))) {
            let message = "a comment within a formula in running text, or a macro, is not read";
            self.fault(refused(message, "put it before that, or behind it", comment.span), declares(comment));
        }
    }

    /// Counts a formula in running text.
    fn seen_inline(&mut self, place: Range<usize>) {
        self.unheard(place.clone());
        self.out.inline += 1;
        let line = self.lines.line(self.tokens[place.end - 1].span.start);
        self.inline.push((place, line));
    }

    /// `%carom inline CLAUSE` behind a formula in running text, which is read as a displayed one without a number.
    fn marked(&mut self, text: &str, comment: &Token) {
        let line = self.lines.line(comment.span.start);
        let on_line = self.inline.iter().rev().take_while(|formula| formula.1 == line).count();
        let Some((place, _)) = self.inline.last().filter(|_| on_line == 1).cloned() else {
            let (message, help) = match on_line {
                0 => ("no formula in running text ends on this line", "put the comment on the line that ends with it"),
                _ => (
                    "more than one formula ends on this line",
                    "break the line behind the formula that is meant, and put the comment there",
                ),
            };
            return self.fault(refused(message, help, comment.span), declares(comment));
        };
        self.out.inline -= 1;
        // The signs around it are one token each; those of an environment, `\begin{math}`, are a name in braces as well.
        let begun = environment(self.tokens, place.start).filter(|_| self.tokens[place.start].is("begin"));
        let inside = begun.map_or(place.start + 1, |found| found.1);
        let end = end_of(self.tokens, inside).filter(|end| *end < place.end).unwrap_or(place.end - 1);
        self.display("$", place.start, inside, end, place.end - 1);
        let rest = text["inline".len()..].trim_start();
        if let Some(Part::Display(display)) = self.out.parts.last_mut()
            && let Some(row) = display.rows.last_mut()
            && !rest.is_empty()
        {
            let span = Span { start: comment.span.start + text.len() - rest.len(), ..comment.span };
            row.clauses.push(Clause { text: rest.to_string(), span });
        }
    }

    /// A displayed formula between signs.
    fn until(&mut self, at: usize, ends: impl Fn(&Token) -> bool, environment: &str) -> usize {
        match self.tokens[at + 1..].iter().position(ends) {
            Some(length) => {
                let end = at + 1 + length;
                self.display(environment, at, at + 1, end, end);
                end + 1
            }
            None => {
                let fault = refused("this formula is not closed", "close it with the same sign", self.tokens[at].span);
                self.fault(fault, false);
                self.tokens.len()
            }
        }
    }

    fn begin(&mut self, at: usize) -> usize {
        let Some((name, inside)) = environment(self.tokens, at) else { return at + 1 };
        let plain = name.trim_end_matches('*').to_string();
        if NOT_READ.contains(&plain.as_str()) {
            let help = "use an environment of amsmath, such as align";
            let fault = refused(format!("the environment {name} is not read"), help, self.tokens[at].span);
            self.macros.passes(&self.tokens[at]);
            let end = end_of(self.tokens, inside).unwrap_or(inside);
            self.unread(&name, &self.tokens[inside..end], self.tokens[at].span, fault);
            return end;
        }
        let alike = ALIKE.iter().find(|pair| pair.0 == plain).map(|pair| pair.1);
        let has_argument = ["alignat", "xalignat", "IEEEeqnarray"].contains(&plain.as_str());
        let plain = alike.map_or(plain, str::to_string);
        if plain == "subequations" {
            self.numbers.begin_sub();
        }
        if !DISPLAYS.contains(&plain.as_str()) {
            self.macros.passes(&self.tokens[at]);
            return inside;
        }
        let Some(end) = end_of(self.tokens, inside) else {
            let message = format!("\\begin{{{name}}} has no \\end{{{name}}}");
            self.fault(refused(message, "close the environment", self.tokens[at].span), false);
            return self.tokens.len();
        };
        let (closed, next) = environment(self.tokens, end).unwrap_or_default();
        if closed != name {
            let message = format!("\\begin{{{name}}} is closed by \\end{{{closed}}}");
            let help = "close the environments in the order of their nesting";
            let fault = refused(message, help, self.tokens[end].span);
            self.unread(&name, &self.tokens[inside..end], self.tokens[at].span, fault);
            return next.max(end + 1);
        }
        let inside = if has_argument { group(self.tokens, inside).map_or(inside, |g| g.1) } else { inside };
        if plain == "math" {
            self.seen_inline(at..next);
        } else {
            let star = if name.ends_with('*') { "*" } else { "" };
            self.display(&format!("{plain}{star}"), at, inside, end, next.saturating_sub(1));
        }
        next
    }

    fn end(&mut self, at: usize) -> usize {
        if environment(self.tokens, at).is_some_and(|(name, _)| name == "subequations") {
            self.numbers.end_sub();
        }
        self.macros.passes(&self.tokens[at]);
        at + 1
    }

    /// Reads the displayed formula whose body is `inside..end`.
    fn display(&mut self, environment: &str, at: usize, inside: usize, end: usize, last: usize) {
        if let Some((environment, inner)) = self.within(environment, inside..end) {
            let first = comments(&self.tokens[inside..inner.start]);
            let behind = comments(&self.tokens[inner.end..end]);
            self.display(&environment, at, inner.start, inner.end, last);
            if let Some(Part::Display(display)) = self.out.parts.last_mut() {
                display.rows.first_mut().into_iter().for_each(|row| drop(row.clauses.splice(0..0, first.clone())));
                display.rows.last_mut().into_iter().for_each(|row| row.clauses.extend(behind.clone()));
            }
            return;
        }
        let span =
            Span { start: self.tokens[at].span.start, end: self.tokens[last.min(self.tokens.len() - 1)].span.end };
        let body = self.macros.expand(&self.tokens[inside..end]);
        let read = body.and_then(|body| self.rows(environment, &with_scripts(&body)));
        match read {
            Ok(rows) => {
                let environment = environment.to_string();
                self.out.parts.push(Part::Display(Display { environment, rows, span }));
            }
            Err(fault) => {
                self.numbers.row(environment, None, false);
                self.unread(environment, &self.tokens[inside..end], span, fault);
            }
        }
    }

    /// The environment of displayed formulas that is all that stands between `$$` or `\[`, without a number, and its body:
    /// pages in Markdown write it so.
    fn within(&self, environment: &str, body: Range<usize>) -> Option<(String, Range<usize>)> {
        let is_mark = |t: &Token| matches!(t.kind, Kind::Comment(_) | Kind::Char('.' | ','));
        let tokens = self.tokens.get(body.clone())?;
        let begin = body.start + tokens.iter().position(|t| !matches!(t.kind, Kind::Comment(_)))?;
        if !["$$", "["].contains(&environment) || !self.tokens[begin].is("begin") {
            return None;
        }
        let (name, inside) = self::environment(self.tokens, begin)?;
        let plain = name.trim_end_matches('*');
        let is_read = DISPLAYS.contains(&plain) && !["math", "displaymath"].contains(&plain);
        let end = end_of(self.tokens, inside).filter(|end| is_read && *end < body.end)?;
        let (closed, next) = self::environment(self.tokens, end)?;
        let inside = if plain == "alignat" { group(self.tokens, inside).ok()?.1 } else { inside };
        let is_whole = closed == name && self.tokens[next.min(body.end)..body.end].iter().all(is_mark);
        is_whole.then(|| (format!("{plain}*"), inside..end))
    }

    /// A displayed formula that is not read, with its comments: it may be a hypothesis, or passed over. In one of several rows
    /// a comment passes over no more than that row, which is not known.
    fn unread(&mut self, environment: &str, body: &[Token], span: Span, fault: Diagnostic) {
        let has_rows = body.iter().any(|t| t.is("\\"));
        let clauses =
            comments(body).into_iter().filter(|clause| !has_rows || first_word(&clause.text) != "skip").collect();
        let cells = vec![vec![Token { kind: Kind::Char('='), span, apart: true }]];
        let row = Row { cells, clauses, span, fault: Some(fault), ..Row::default() };
        self.out.parts.push(Part::Display(Display { environment: environment.to_string(), rows: vec![row], span }));
    }
}

/// The comments among tokens.
fn comments(tokens: &[Token]) -> Vec<Clause> {
    let comments = tokens.iter().filter_map(|token| match &token.kind {
        Kind::Comment(text) => Some(Clause { text: text.clone(), span: token.span }),
        _ => None,
    });
    comments.collect()
}

/// Whether a token is a comment that says what holds for others.
pub(crate) fn declares(token: &Token) -> bool {
    let Kind::Comment(text) = &token.kind else { return false };
    let word = first_word(text.strip_prefix("inline").unwrap_or(text).trim_start());
    ["given", "let", "define", "assume"].contains(&word)
}

/// The name of the environment that `\begin` or `\end` at `at` names, and where to read on.
pub(crate) fn environment(tokens: &[Token], at: usize) -> Option<(String, usize)> {
    if tokens.get(at + 1)?.kind != Kind::Open {
        return None;
    }
    let (name, next) = group(tokens, at + 1).ok()?;
    Some((words(name), next))
}

/// Where the `\end` stands that belongs to a `\begin` before `inside`.
pub(crate) fn end_of(tokens: &[Token], inside: usize) -> Option<usize> {
    let mut level = 0usize;
    for (place, token) in tokens.iter().enumerate().skip(inside) {
        if token.is("begin") {
            level += 1;
        } else if token.is("end") {
            if level == 0 {
                return Some(place);
            }
            level -= 1;
        }
    }
    None
}
