//! Letters behind a number that may be a unit: `2.4\; cm`, `11km/s`.
//!
//! Contract: letters that spell a unit, in italics and behind a number, are refused where both readings are likely. `2 m v` is a
//! product.

use super::expression::{Read, Reader, is_space};
use super::name::argument;
use super::piece::Piece;
use super::refusal::ambiguous;
use super::token::{Token, words};
use carom_checker::claim::syntax::Unit;
use carom_diagnostic::Span;

impl Reader<'_, '_, '_> {
    /// Refuses letters here, behind the number `before`, that are a unit or a product of names.
    pub(crate) fn no_unit_in_letters(&mut self, before: &Piece) -> Read<()> {
        let number = before.text.text();
        if !number.chars().all(|c| c.is_ascii_digit() || "^()*./-e".contains(c))
            || !number.starts_with(|c: char| c.is_ascii_digit())
        {
            return Ok(());
        }
        let is_spaced = self.at > 0 && is_space(&self.tokens[self.at - 1]);
        let Some((unit, letters, span)) = self.letters_of_unit() else { return Ok(()) };
        // 4 km may be a coefficient and two names, as in b^2 = 4 k m; 11 km and 0.5 km are seldom that.
        let is_long = number.chars().count() > 1;
        let is_unit = [letters > 1, is_long, is_spaced].iter().filter(|sign| **sign).count() > 1;
        if !is_unit {
            return Ok(());
        }
        let readings = [format!("the unit {unit}"), "a product of names".to_string()];
        let write =
            ["declare the unit with the name, `%carom given x > 0 in m`, and write the number alone", "write \\cdot"];
        Err(ambiguous("letters behind a number", readings.each_ref().map(String::as_str), write, span))
    }

    /// The unit that the letters here spell up to the end of the term, and how many they are.
    fn letters_of_unit(&mut self) -> Option<(String, usize, Span)> {
        let (mut unit, mut letters, mut at) = (String::new(), 0, self.at);
        let start = self.tokens.get(at)?.span;
        while let Some(token) = self.tokens.get(at) {
            match token.char() {
                Some(c) if c.is_ascii_alphabetic() && !(token.apart && letters > 0 && !unit.ends_with(['/', '*'])) => {
                    letters += 1
                }
                Some('/') if letters > 0 => {}
                None if letters > 0
                    && token.is("cdot")
                    && self.tokens.get(at + 1).and_then(Token::char).is_some_and(|c| c.is_ascii_alphabetic()) =>
                {
                    unit.push('*');
                    at += 1;
                    continue;
                }
                Some('^') if letters > 0 => {
                    let (inner, next) = argument(self.tokens, at + 1).ok()?;
                    unit += &format!("^{}", words(inner));
                    at = next;
                    continue;
                }
                _ => break,
            }
            unit += &token.text();
            at += 1;
        }
        let span = Span { start: start.start, end: self.tokens[at.checked_sub(1)?].span.end };
        let run: String = unit.chars().take_while(char::is_ascii_alphabetic).collect();
        let is_name =
            run.len() > 1 && self.scope.names.spelled(&run).is_some_and(|name| self.scope.roles.contains_key(name));
        let here = std::mem::replace(&mut self.at, at);
        let goes_on = self.begins_factor()
            || self
                .peek()
                .is_some_and(|t| matches!(t.char(), Some('/' | '_' | '\'' | '!')) || t.is("cdot") || t.is("times"));
        self.at = here;
        (letters > 0 && !is_name && !goes_on && Unit::read(&unit).is_ok()).then_some((unit, letters, span))
    }
}
