//! Bindings of quantifiers and extrema, limits, and membership in intervals.

use super::expression::{Read, Reader};
use super::name::{Symbol, argument, base, scripts};
use super::piece::Piece;
use super::place::Placed;
use super::refusal::refused;
use super::statement::{Said, joined};
use super::token::Token;
use carom_diagnostic::Span;

/// The sign of the claim language for a sign of comparison.
pub(crate) fn relation_of(token: &Token) -> Option<&'static str> {
    Some(match (token.char(), token.command()) {
        (Some('='), _) => "=",
        (Some('<'), _) | (_, Some("lt")) => "<",
        (Some('>'), _) | (_, Some("gt")) => ">",
        (_, Some("le" | "leq" | "leqslant")) => "<=",
        (_, Some("ge" | "geq" | "geqslant")) => ">=",
        (_, Some("ne" | "neq")) => "!=",
        _ => return None,
    })
}

/// Where the interval closes whose opening stands before these tokens.
fn closing(tokens: &[Token]) -> usize {
    let mut level = 0i64;
    let end = tokens.iter().position(|t| {
        level += match t.text().as_str() {
            "(" | "[" | "{" => 1,
            ")" | "]" | "}" => -1,
            _ => 0,
        };
        level < 0
    });
    end.unwrap_or(tokens.len())
}

impl Reader<'_, '_, '_> {
    /// A name that is declared here.
    fn declared_name(&mut self) -> Read<(Symbol, String)> {
        self.peek();
        let start = self.span();
        let Some((first, next)) = base(self.tokens, self.at)? else { return self.expected("a name to declare") };
        let (symbol, next) = scripts(self.tokens, first, start, next)?;
        let name = self.scope.names.of(&symbol)?;
        self.scope.names.seen(&symbol.key());
        self.at = next;
        Ok((symbol, name))
    }

    /// `x, y > 0; n \text{ natural}; e \in [0, 1]`: the names stay bound for what follows.
    pub(crate) fn bindings(&mut self) -> Read<Placed> {
        let mut text = Placed::default();
        loop {
            let mut names = Vec::new();
            loop {
                let (symbol, name) = self.declared_name()?;
                self.scope.bound.push((symbol.key(), name.clone()));
                names.push((symbol, name));
                if !self.take_char(',') {
                    break;
                }
            }
            self.binding(&names, &mut text)?;
            let span = self.span();
            if !self.take_char(';') {
                return Ok(text);
            }
            text.push("; ", span);
        }
    }

    /// The domain of names that stand before it.
    fn binding(&mut self, names: &[(Symbol, String)], text: &mut Placed) -> Read<()> {
        let (mut said, mut bounds): (Placed, Vec<String>) = (Placed::default(), Vec::new());
        let (mut has_kind, mut is_counted) = (false, false);
        loop {
            let span = self.span();
            let from = said.text().len();
            if let Some(relation) = self.peek().and_then(relation_of) {
                self.at += 1;
                said.push(&format!(" {relation} "), span);
                said.append(&self.sum()?.text);
            } else if let Some(word) = ["real", "natural", "integer"].into_iter().find(|word| self.take_text(&[word])) {
                said.push(&format!(" {word}"), span);
                has_kind = true;
                continue;
            } else if !said.text().is_empty() && self.take_text(&["and"]) {
                said.push(" and", span);
                continue;
            } else if self.take_command(&["in"]) {
                match self.number_set()? {
                    Some(Some(kind)) => {
                        said.push(&format!(" {kind}"), span);
                        has_kind = true;
                        continue;
                    }
                    Some(None) => {
                        is_counted = true;
                        continue;
                    }
                    None => {
                        let domain = self.domain()?;
                        has_kind |= domain.text().contains("..");
                        said.append(&domain);
                    }
                }
            } else {
                break;
            }
            bounds.push(said.text()[from..].trim().to_string());
        }
        // Names of different kinds are declared one by one.
        let kinds = names.iter().map(|(symbol, name)| match has_kind {
            true => Ok(String::new()),
            false if is_counted => self.declared_as_natural(symbol, name, &bounds),
            false => self.kind_of_bound(symbol, name, &bounds),
        });
        let kinds = kinds.collect::<Read<Vec<String>>>()?;
        let is_one = kinds.iter().all(|kind| *kind == kinds[0]);
        for (place, ((symbol, name), kind)) in names.iter().zip(&kinds).enumerate() {
            if place > 0 {
                text.push(if is_one { ", " } else { "; " }, symbol.span);
            }
            text.push(name, symbol.span);
            if !is_one || place + 1 == names.len() {
                text.push(kind, symbol.span);
                text.append(&said);
            }
        }
        Ok(())
    }

    /// `[a, b)` or `\{a, \dots, b\}`, behind `\in`.
    fn domain(&mut self) -> Read<Placed> {
        let span = self.span();
        if self.take_command(&["{", "lbrace"]) {
            let mut text = Placed::new(" in ", span);
            text.append(&self.sum()?.at_least(1));
            if !(self.take_char(',') && self.take_command(&["dots", "ldots", "cdots"]) && self.take_char(',')) {
                return self.expected("`, \\dots, ` and the last number");
            }
            text.push("..", span);
            text.append(&self.sum()?.text);
            if !self.take_command(&["}", "rbrace"]) {
                return self.expected("`\\}`");
            }
            return Ok(text);
        }
        let (from, from_closed, to, to_closed) = self.interval()?;
        let mut text = Placed::new(if from_closed { " in [" } else { " in (" }, span);
        text.append(&from.text);
        text.push(", ", span);
        text.append(&to.text);
        text.push(if to_closed { "]" } else { ")" }, span);
        Ok(text)
    }

    fn interval(&mut self) -> Read<(Piece, bool, Piece, bool)> {
        let from_closed = self.is_next_char('[');
        if !(self.take_char('[') || self.take_char('(')) {
            let span = self.span();
            let help = "write an interval, \\in [0, 1], or declare the name in a comment: `%carom given n natural`";
            return Err(refused("this set is not read", help, span));
        }
        // The comma between two numbers is no decimal comma here, so the ends are parted before they are read.
        let rest = self.tokens.get(self.at..).unwrap_or_default();
        let end = closing(rest);
        let parts = super::symbol::commas(&rest[..end]);
        let [from, to] = parts.as_slice() else {
            return self.expected("two ends with `,` between them");
        };
        let (from, to) = (self.sum_in(from)?, self.sum_in(to)?);
        self.at += end;
        let to_closed = self.is_next_char(']');
        if !(self.take_char(']') || self.take_char(')')) {
            return self.expected("`]` or `)` to close the interval");
        }
        Ok((from, from_closed, to, to_closed))
    }

    /// `x \in [a, b]` as a statement.
    pub(crate) fn member(&mut self, left: &Piece) -> Read<Said> {
        let start = self.span();
        let (from, from_closed, to, to_closed) = self.interval()?;
        let sign = |closed: bool| if closed { " <= " } else { " < " };
        let mut text = from.text;
        text.push(sign(from_closed), start);
        text.append(&left.text);
        text.push(sign(to_closed), start);
        text.append(&to.text);
        Ok(Said { text, level: 6 })
    }

    /// `\lim_{n \to \infty} F = L`
    pub(crate) fn limit(&mut self, start: Span) -> Read<Said> {
        self.at += 1;
        if !self.take_char('_') {
            return self.expected("`_{n \\to \\infty}`");
        }
        let (below, next) = argument(self.tokens, self.at)?;
        self.at = next;
        let outside = self.scope.bound.len();
        let (name, towards) = self.inside(below, |inside| inside.towards(start))?;
        let of = self.term()?;
        let span = self.span();
        if self.peek().is_some_and(|t| t.is_char('+') || t.is_char('-')) {
            let readings = ["of the first term alone", "of the whole sum"];
            let write = ["write two equations", "write parentheses around the sum"];
            return Err(super::refusal::ambiguous("what this limit is of", readings, write, span));
        }
        if !self.take_char('=') {
            return self.expected("`=` and the limit's value");
        }
        self.finish_limit(&of, name, towards, outside, start)
    }

    /// `\text{limit of } F \text{ as } n \to \infty \text{ is } L`
    pub(crate) fn written_limit(&mut self, start: Span) -> Read<Said> {
        let Some((_, next)) = self.text_here() else { return self.expected("a limit") };
        let Some(along) = self.find_text(next, "as") else { return self.expected("\\text{as} and the variable") };
        let body = &self.tokens[next..along];
        let outside = self.scope.bound.len();
        self.at = along;
        self.take_text(&["as"]);
        let (name, towards) = self.towards(start)?;
        let of = self.sum_in(body)?;
        if !self.take_text(&["is"]) {
            return self.expected("\\text{is} and the limit's value");
        }
        self.finish_limit(&of, name, towards, outside, start)
    }

    /// `n \to \infty`, `x \to a^+`: the variable, and where it goes.
    fn towards(&mut self, start: Span) -> Read<(String, Placed)> {
        let (symbol, name) = self.declared_name()?;
        self.scope.bound.push((symbol.key(), name.clone()));
        let mut said = name;
        for domain in ["natural", "real"] {
            if self.take_text(&[domain]) {
                said = format!("{said} {domain}");
            }
        }
        if !self.take_command(&["to", "rightarrow", "longrightarrow"]) {
            return self.expected("`\\to`");
        }
        if self.take_command(&["infty"]) {
            return Ok((said, Placed::new("infinity", start)));
        }
        // A sign above the point is the side from which it is reached.
        let rest = &self.tokens[self.at..];
        let side = rest.iter().position(|t| t.is_char('^')).and_then(|at| {
            let (inner, next) = argument(rest, at + 1).ok()?;
            let sign = inner.first().and_then(Token::char).filter(|_| inner.len() == 1)?;
            let side = match sign {
                '+' => " from above",
                '-' => " from below",
                _ => return None,
            };
            (next == rest.len()).then_some((at, side))
        });
        let mut point = match side {
            Some((at, side)) => {
                let mut point = self.sum_in(&rest[..at])?.text;
                point.push(side, start);
                self.at = self.tokens.len();
                point
            }
            None => self.sum()?.text,
        };
        for side in ["from above", "from below"] {
            if self.take_text(&[side]) {
                point.push(&format!(" {side}"), start);
            }
        }
        Ok((said, point))
    }

    fn finish_limit(&mut self, of: &Piece, name: String, towards: Placed, outside: usize, start: Span) -> Read<Said> {
        self.scope.bound.truncate(outside);
        let is_negative = self.is_next_char('-') && self.tokens.get(self.at + 1).is_some_and(|t| t.is("infty"));
        self.at += usize::from(is_negative);
        let value = if self.take_command(&["infty"]) {
            Placed::new(if is_negative { "-infinity" } else { "infinity" }, start)
        } else {
            self.sum()?.text
        };
        let mut text = Placed::new("limit of ", start);
        text.append(&of.text);
        text.push(&format!(" as {name} -> "), start);
        text.append(&towards);
        text.push(" is ", start);
        text.append(&value);
        Ok(joined(vec![Said { text, level: 6 }], "", 6, 6))
    }
}
