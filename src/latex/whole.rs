//! A formula read to its end: all of its tokens are read, or it is refused.

use super::expression::{Read, Reader};
use super::index::no_upper_index;
use super::prepare::is_operator;
use super::refusal::{command, expected, unread_words};
use super::scope::Scope;
use super::token::Token;
use carom_diagnostic::Span;

/// Reads all tokens of a formula.
pub(crate) fn whole<T>(
    tokens: &[Token],
    scope: &mut Scope<'_>,
    read: impl FnOnce(&mut Reader<'_, '_, '_>) -> Read<T>,
) -> Read<T> {
    let start = tokens.first().map_or(0, |t| t.span.start);
    let end = tokens.last().map_or(start, |t| t.span.end);
    let mut reader = Reader { tokens, at: 0, depth: 0, whole: Span { start, end }, scope };
    let out = read(&mut reader)?;
    match reader.peek() {
        None => no_upper_index(tokens, reader.scope).map(|()| out),
        Some(token) => {
            let span = token.span;
            if let Some((said, _)) = reader.text_here() {
                return Err(unread_words(&said, span));
            }
            Err(match token.command() {
                Some(name) if !is_operator(name) => command(name, span),
                _ => {
                    expected("an operator, a relation or the end of the formula", &format!("`{}`", token.text()), span)
                }
            })
        }
    }
}
