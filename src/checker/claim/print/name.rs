//! Names as they are printed: Greek letters as signs, digits at the end as an index.

use super::Style;
use crate::claim::lex::GREEK;

impl Style {
    /// A name: `mu`, `v_mu`, `m1`.
    pub fn name(self, name: &str) -> String {
        if self == Style::Text {
            return name.to_string();
        }
        // Primes stand behind the index in print, whatever the name has first: `v1'` and `v_1'` are both v with 1 and a prime.
        let bare = name.trim_end_matches('\'');
        if bare.len() < name.len() && bare.contains(|c: char| c == '_' || is_digit(c)) {
            return format!("{}{}", self.name(bare), &name[bare.len()..]);
        }
        if let Some((head, tail)) = name.split_once('_') {
            return match self {
                Style::Latex => {
                    let (head, tail) = (self.name(head), self.name(tail));
                    if head.contains('_') { format!("{{{head}}}_{{{tail}}}") } else { format!("{head}_{{{tail}}}") }
                }
                // No other name of the claim prints alike: the reader refuses both `v2` and `v_2`.
                _ if is_number(tail) && !head.ends_with(is_digit) => format!("{}{}", self.name(head), lowered(tail)),
                _ => format!("{}_{}", self.name(head), self.name(tail)),
            };
        }
        let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let digits = &name[letters.len()..];
        if letters.is_empty() {
            // What follows `_` in `v_2`.
            return digits.to_string();
        }
        let primes = letters.trim_end_matches('\'');
        let marks = &letters[primes.len()..];
        let head = match (GREEK.iter().find(|g| g.0 == primes), self) {
            (Some((name, _)), Style::Latex) => format!("\\{name}"),
            (Some((_, sign)), _) => sign.to_string(),
            _ => primes.to_string(),
        };
        match self {
            Style::Latex if digits.is_empty() => format!("{head}{marks}"),
            Style::Latex => format!("{head}{marks}_{{{digits}}}"),
            _ => format!("{head}{marks}{}", lowered(digits)),
        }
    }
}

fn is_digit(c: char) -> bool {
    c.is_ascii_digit()
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.chars().all(is_digit)
}

/// Digits below the line.
fn lowered(digits: &str) -> String {
    digits.chars().filter_map(|c| c.to_digit(10).and_then(|d| char::from_u32(0x2080 + d))).collect()
}
