//! Units of declarations: `m1, m2 > 0 in kg`.

use super::*;

impl Parser {
    /// Whether a unit follows behind `in`, and not an interval or a range; `has_domain` says whether a domain came before.
    ///
    /// `n in N` alone is no unit, since it may mean the natural numbers.
    pub(super) fn begins_unit(&self, has_domain: bool) -> bool {
        let is_set = |word: &str| ["R", "Q", "Z", "N"].contains(&word);
        match (self.peek_at(1), self.peek_at(2)) {
            (Kind::Word(word), next) if !has_domain && is_set(word) => matches!(next, Kind::Sign("*" | "/" | "^")),
            (Kind::Word(_), _) | (Kind::Number(_), Kind::Sign("/")) => {
                self.unit_tokens(self.at + 1).iter().all(|token| token.kind != Kind::Sign(".."))
            }
            _ => false,
        }
    }

    /// The tokens of a unit: to the end of the declaration.
    fn unit_tokens(&self, at: usize) -> &[Token] {
        let ends = |token: &Token| match &token.kind {
            Kind::Sign("," | ";" | ":") | Kind::End => true,
            Kind::Word(word) => RESERVED.contains(&word.as_str()) || token.first_on_line && is_keyword(word),
            _ => false,
        };
        let length = self.tokens[at..].iter().position(ends).unwrap_or(0);
        &self.tokens[at..at + length]
    }

    /// Reads `in` and the unit behind it.
    pub(super) fn unit(&mut self, is_natural: bool) -> Parsed<Unit> {
        let span = self.advance().span;
        if is_natural {
            let help = "write `real` or a bound: `m > 0 in kg`";
            return Err(self.other("a natural number has no unit", Some(help), span));
        }
        let list = self.unit_tokens(self.at);
        let (mut text, mut places) = (String::new(), Vec::new());
        for token in list {
            let part = match &token.kind {
                Kind::Word(word) | Kind::Number(word) => word.clone(),
                Kind::Raised(power) => format!("^{power}"),
                Kind::Sign(sign) => (*sign).to_string(),
                Kind::Text(_) | Kind::End => "?".to_string(),
            };
            // Two words side by side stay two words.
            if text.ends_with(char::is_alphanumeric) && part.starts_with(char::is_alphanumeric) {
                text.push(' ');
            }
            text.push_str(&part);
            places.push((text.len(), token.span));
        }
        let length = list.len();
        match Unit::read(&text) {
            Ok(unit) => {
                self.at += length;
                Ok(unit)
            }
            Err(_) if self.is_explained() => Err(Reported),
            Err(fault) => {
                let place = places.iter().find(|(end, _)| *end > fault.place.start).or(places.last());
                let span = place.map_or(self.span(), |(_, span)| *span);
                Err(self.other(&fault.message, Some(&fault.help), span))
            }
        }
    }
}
