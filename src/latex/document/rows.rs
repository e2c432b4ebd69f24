//! The rows of a displayed formula: where they end, their cells, labels, numbers and comments.

use super::{Clause, Reader, Row, end_of, environment};
use crate::macros::{group, option};
use crate::name::argument;
use crate::refusal::refused;
use crate::token::{Kind, Token, words};
use carom_diagnostic::{Diagnostic, Span};

/// Environments in a displayed formula that hold its rows.
const INNER: &[&str] = &["split", "aligned", "gathered", "alignedat"];

impl Reader<'_> {
    /// The rows of the formula with this body.
    pub(super) fn rows(&mut self, environment: &str, body: &[Token]) -> Result<Vec<Row>, Diagnostic> {
        let plain = environment.trim_end_matches('*');
        let body = &unboxed(body);
        let mut whole = Row::default();
        let bare = self.without_marks(body, &mut whole, false)?;
        // The rows of `split` within `equation` share its number.
        if let Some(inner) = inner(&bare) {
            let mut rows = self.split(inner)?;
            if let Some(first) = rows.first_mut() {
                first.clauses.splice(0..0, whole.clauses);
                first.label = whole.label;
                first.number = self.numbers.row(environment, whole.number, true);
            }
            return Ok(rows);
        }
        let mut rows = self.split(body)?;
        let shared = ["equation", "multline", "[", "$", "$$", "displaymath"].contains(&plain);
        let count = rows.len();
        for (place, row) in rows.iter_mut().enumerate() {
            let has_one = if shared { place + 1 == count } else { true };
            if has_one {
                let said = row.number.take();
                row.number = self.numbers.row(environment, said, true);
            }
        }
        Ok(rows)
    }

    /// The rows of a body, each with its cells.
    fn split(&mut self, body: &[Token]) -> Result<Vec<Row>, Diagnostic> {
        let mut rows: Vec<Row> = Vec::new();
        let mut pieces: Vec<Vec<Token>> = vec![Vec::new()];
        let (mut level, mut at) = (0usize, 0);
        while let Some(token) = body.get(at) {
            match &token.kind {
                Kind::Open => level += 1,
                Kind::Close => {
                    let below = level.checked_sub(1);
                    let help = "remove it, or write `{` where its group begins";
                    level = below.ok_or_else(|| refused("this brace was not opened", help, token.span))?;
                }
                Kind::Command(name) if name == "begin" => level += 1,
                Kind::Command(name) if name == "end" => level = level.saturating_sub(1),
                _ => {}
            }
            if level == 0 && (token.is("\\") || token.is("newline") || token.is("cr")) {
                at += 1;
                at += usize::from(body.get(at).is_some_and(|t| t.is_char('*') && !t.apart));
                if let Some((_, next)) = option(body, at).filter(|_| !body[at].apart) {
                    at = next;
                }
                // What stands on the line of the break still belongs to the row.
                let line = self.lines.line(token.span.start);
                while let Some(comment) = body.get(at)
                    && matches!(comment.kind, Kind::Comment(_))
                    && self.lines.line(comment.span.start) == line
                {
                    pieces.last_mut().into_iter().for_each(|piece| piece.push(comment.clone()));
                    at += 1;
                }
                pieces.push(Vec::new());
                continue;
            }
            pieces.last_mut().into_iter().for_each(|piece| piece.push(token.clone()));
            at += 1;
        }
        if level > 0 {
            let span = body.iter().find(|t| t.kind == Kind::Open || t.is("begin")).map_or(Span::default(), |t| t.span);
            return Err(refused("a brace or an environment of this formula is not closed", "close it", span));
        }
        for piece in pieces {
            let mut row = Row::default();
            let bare = self.without_marks(&piece, &mut row, true)?;
            if bare.is_empty() && row.label.is_none() && row.clauses.is_empty() {
                continue;
            }
            let (start, end) = (bare.first().map(|t| t.span.start), bare.last().map(|t| t.span.end));
            let clause = row.clauses.first().map(|c| (c.span.start, c.span.end)).unwrap_or_default();
            row.span = Span { start: start.unwrap_or(clause.0), end: end.unwrap_or(clause.1) };
            row.cells = cells(&bare);
            rows.push(row);
        }
        Ok(rows)
    }

    /// The tokens without labels, numbers and comments, which go into the row; comments in an environment of rows belong to these.
    fn without_marks(&mut self, body: &[Token], row: &mut Row, is_row: bool) -> Result<Vec<Token>, Diagnostic> {
        let mut out = Vec::new();
        let mut at = 0;
        let mut level = 0usize;
        while let Some(token) = body.get(at) {
            match &token.kind {
                Kind::Comment(text) if is_row || level == 0 => {
                    row.clauses.push(Clause { text: text.clone(), span: token.span })
                }
                Kind::Command(name) if ["label", "tag"].contains(&name.as_str()) && level == 0 => {
                    let star = usize::from(body.get(at + 1).is_some_and(|t| t.is_char('*')));
                    // Without braces a tag is one sign.
                    let (inner, next) = match name == "tag" {
                        true => argument(body, at + 1 + star)?,
                        false => group(body, at + 1 + star)?,
                    };
                    match name.as_str() {
                        "label" => row.label = Some(words(inner)),
                        _ => row.number = Some(words(inner)),
                    }
                    at = next;
                    continue;
                }
                Kind::Command(name) if name == "nonumber" || name == "notag" => row.number = Some(String::new()),
                _ => {
                    level += usize::from(token.is("begin"));
                    level = level.saturating_sub(usize::from(token.is("end")));
                    out.push(token.clone());
                }
            }
            at += 1;
        }
        Ok(out)
    }
}

/// The tokens without the boxes of `\Aboxed{a &= b}`, each of which holds an equation with its cells.
fn unboxed(tokens: &[Token]) -> Vec<Token> {
    let ends = |token: Option<&Token>| {
        token.is_none_or(|t| {
            matches!(t.kind, Kind::Char('&' | '.' | ',' | ';') | Kind::Comment(_))
                || ["\\", "label", "tag", "notag", "nonumber", "quad", "qquad", "end"].iter().any(|name| t.is(name))
        })
    };
    let mut out: Vec<Token> = Vec::new();
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let is_box = token.is("Aboxed") && tokens.get(at + 1).is_some_and(|t| t.kind == Kind::Open) && ends(out.last());
        let inner = if is_box { group(tokens, at + 1).ok() } else { None };
        match inner.filter(|(_, next)| ends(tokens.get(*next))) {
            Some((inner, next)) => {
                out.extend_from_slice(inner);
                at = next;
            }
            None => {
                out.push(token.clone());
                at += 1;
            }
        }
    }
    out
}

/// The body of the environment of rows that a formula consists of, if it does.
fn inner(bare: &[Token]) -> Option<&[Token]> {
    if !bare.first()?.is("begin") {
        return None;
    }
    let (name, mut inside) = environment(bare, 0)?;
    if !INNER.contains(&name.as_str()) {
        return None;
    }
    if let Some((_, next)) = option(bare, inside) {
        inside = next;
    }
    if name == "alignedat" {
        inside = group(bare, inside).ok()?.1;
    }
    let end = end_of(bare, inside)?;
    let rest = &bare[environment(bare, end)?.1..];
    rest.iter().all(|t| matches!(t.kind, Kind::Char('.' | ','))).then(|| &bare[inside..end])
}

/// The cells of a row.
pub(crate) fn cells(tokens: &[Token]) -> Vec<Vec<Token>> {
    let mut out = vec![Vec::new()];
    let mut level = 0usize;
    for token in tokens {
        match &token.kind {
            Kind::Open => level += 1,
            Kind::Close => level = level.saturating_sub(1),
            Kind::Command(name) if name == "begin" => level += 1,
            Kind::Command(name) if name == "end" => level = level.saturating_sub(1),
            _ => {}
        }
        if level == 0 && token.is_char('&') {
            out.push(Vec::new());
        } else if let Some(cell) = out.last_mut() {
            cell.push(token.clone());
        }
    }
    out
}
