//! Numbers as papers print them: rounded, `0.543`, or with an uncertainty, `57.1 \pm 0.1` and `57.1(1)`.
//!
//! Contract: a rounded number says that the exact value is at most half a unit of its last digit away; one with an uncertainty says
//! that the value lies between its two bounds. Behind `=` a number is exact, and ± may mean two values, unless a comment decides.

use super::expression::{Read, Reader, is_space};
use super::name::argument;
use super::piece::Piece;
use super::place::Placed;
use super::refusal::{ambiguous, limit, refused};
use super::scope::Decisions;
use super::statement::Said;
use super::token::{Token, words};
use carom_diagnostic::{Diagnostic, Span};

/// The largest power of ten of a printed number, up or down.
const POWER_LIMIT: i64 = 300;

/// A number as it is printed.
struct Printed {
    is_negative: bool,
    /// The digits, perhaps with a decimal point.
    digits: String,
    /// How far the value may be away, as a numeral without its power of ten.
    uncertainty: Option<String>,
    /// Whether the uncertainty stands behind ±.
    has_sign: bool,
    /// The power of ten behind it.
    exponent: i64,
    /// Whether all of it is in degrees.
    in_degrees: bool,
    /// Where it stands.
    span: Span,
}

impl Reader<'_, '_, '_> {
    /// Whether the tokens from `at` on are a rounded or measured number, which is compared with what stands before it.
    pub(crate) fn begins_printed(&mut self, at: usize, is_approximate: bool) -> Read<bool> {
        if is_approximate {
            return Ok(true);
        }
        let before = std::mem::replace(&mut self.at, at);
        let from = self.at;
        let found = self.value();
        let has_sign = self.tokens[from.min(self.at)..self.at].iter().any(|t| t.is("pm"));
        if let (Err(fault), true, Some(true)) = (&found, has_sign, self.scope.decisions.is_measured) {
            return Err(fault.clone());
        }
        let found = found.ok().filter(|_| self.ends_side());
        self.at = before;
        let Decisions { is_measured, digits, .. } = self.scope.decisions;
        match (found, is_measured) {
            (None, _) | (Some(Printed { uncertainty: Some(_), .. }), Some(false)) => Ok(false),
            (Some(Printed { uncertainty: None, .. }), _) => Ok(digits.is_some()),
            (Some(_), Some(true)) => Ok(true),
            (Some(printed), None) => Err(two_readings(printed.has_sign, printed.span)),
        }
    }

    /// Whether digits in parentheses, which end before `next`, are a factor of the number before them and no uncertainty: in
    /// an exponent, behind a number in parentheses, or before another parenthesis.
    pub(crate) fn is_factor(&self, next: usize) -> bool {
        let before = self.tokens[..self.at].iter().rev().find(|t| !is_space(t));
        self.scope.is_exponent
            || before.is_some_and(|t| t.is_char(')'))
            || self.tokens.get(next).is_some_and(|t| t.is_char('('))
    }

    /// Whether a side of a comparison ends here.
    fn ends_side(&mut self) -> bool {
        self.peek().is_none_or(|t| {
            matches!(t.char(), Some(',' | ';'))
                || ["quad", "text", "mbox", "textrm", "textnormal", "land", "wedge", "lor", "vee"]
                    .iter()
                    .any(|w| t.is(w))
        })
    }

    /// The number that is printed here.
    fn value(&mut self) -> Read<Printed> {
        let start = self.span();
        let not_read = |span| {
            let help = "write the bound that is meant, as in |x - y| \\le 0.01, or `%carom skip`";
            refused("≈ is read only before a number", help, span)
        };
        let in_parentheses = self.take_char('(');
        let is_negative = self.take_char('-');
        if !self.peek().and_then(Token::char).is_some_and(|c| c.is_ascii_digit()) {
            return Err(not_read(start));
        }
        let (digits, mut in_degrees) = self.digits_and_degrees()?;
        let mut uncertainty = self.last_digits(&digits);
        let has_sign = uncertainty.is_none() && self.take_command(&["pm"]);
        if has_sign {
            if !self.peek().and_then(Token::char).is_some_and(|c| c.is_ascii_digit()) {
                return Err(not_read(start));
            }
            let (away, is_too) = self.digits_and_degrees()?;
            uncertainty = Some(away);
            // A sign of degrees behind one of two numbers may be meant for both.
            if in_degrees != is_too && !in_parentheses {
                let help =
                    "write it behind both numbers, 57.3^\\circ \\pm 0.2^\\circ, or behind parentheses around them";
                return Err(refused("degrees stand behind one number and not behind the other", help, start));
            }
        }
        if in_parentheses && (uncertainty.is_none() || !self.take_char(')')) {
            return Err(not_read(start));
        }
        if let Some(next) = self.degrees().filter(|_| !in_degrees) {
            (in_degrees, self.at) = (true, next);
        }
        if digits.contains('e') {
            return Err(not_read(start));
        }
        let mut exponent = 0i64;

        let power = self.span();
        if self.take_command(&["times", "cdot"]) {
            if has_sign && !in_parentheses {
                if let Some(more) = self.own_power(&digits, uncertainty.as_deref().unwrap_or_default()) {
                    let uncertainty = Some(more);
                    return Ok(Printed {
                        is_negative,
                        digits,
                        uncertainty,
                        has_sign,
                        exponent,
                        in_degrees,
                        span: self.since(start),
                    });
                }
                let readings = ["a power of ten for both numbers", "a power of ten for the uncertainty alone"];
                let write = ["write (57.1 \\pm 0.1) \\times 10^{3}", "write it without, as in 1.40 \\pm 0.00057"];
                return Err(ambiguous("a power of ten behind ±", readings, write, power));
            }
            let is_ten = self.number().is_ok_and(|piece| piece.text.text() == "10");
            if !is_ten || !self.take_char('^') {
                return Err(not_read(start));
            }
            let (inner, next) = argument(self.tokens, self.at)?;
            exponent = words(inner).replace(' ', "").parse::<i64>().map_err(|_| not_read(start))?;
            self.at = next;
        }
        if exponent.abs() > POWER_LIMIT {
            return Err(limit("digits of a power of ten", POWER_LIMIT as usize, start));
        }
        Ok(Printed { is_negative, digits, uncertainty, has_sign, exponent, in_degrees, span: self.since(start) })
    }

    /// The digits of a number, and whether the sign of degrees stands behind it.
    fn digits_and_degrees(&mut self) -> Read<(String, bool)> {
        let digits = self.numeral()?.text.text().to_string();
        let behind = self.degrees();
        self.at = behind.unwrap_or(self.at);
        Ok((digits, behind.is_some()))
    }

    /// The uncertainty with the power of ten here, if that makes its last digit the last one of the value: `0.00243 \pm 6 \cdot 10^{-5}`.
    fn own_power(&mut self, digits: &str, uncertainty: &str) -> Option<String> {
        let here = self.at;
        let power =
            self.number().ok().filter(|piece| piece.text.text() == "10" && self.take_char('^')).and_then(|_| {
                let (inner, next) = argument(self.tokens, self.at).ok()?;
                self.at = next;
                words(inner)
                    .replace(' ', "")
                    .parse::<i64>()
                    .ok()
                    .filter(|power| power.abs() <= POWER_LIMIT && *power != 0)
            });
        match power.filter(|power| places(uncertainty) - power == places(digits)) {
            Some(power) => Some(format!("{uncertainty}e{power}")),
            None => {
                self.at = here;
                None
            }
        }
    }

    /// `(1)` directly behind the digits: the uncertainty in units of the last digit.
    fn last_digits(&mut self, digits: &str) -> Option<String> {
        self.tokens.get(self.at).filter(|t| t.is_char('(') && !t.apart)?;
        let length =
            self.tokens[self.at + 1..].iter().take_while(|t| t.char().is_some_and(|c| c.is_ascii_digit())).count();
        let end = self.at + 1 + length;
        self.tokens.get(end).filter(|t| t.is_char(')') && length > 0)?;
        let said: String = self.tokens[self.at + 1..end].iter().filter_map(Token::char).collect();
        self.at = end + 1;
        Some(match places(digits) {
            0 => said,
            places => format!("{said}e-{places}"),
        })
    }

    /// What the printed number here says of the exact value.
    pub(crate) fn printed(&mut self, exact: &Piece) -> Read<Said> {
        let printed = self.value()?;
        let span = printed.span;
        let scaled = |digits: &str| match digits.split_once('e') {
            Some((digits, power)) => {
                format!("{digits}e{}", power.parse::<i64>().unwrap_or_default().saturating_add(printed.exponent))
            }
            None if printed.exponent == 0 => digits.to_string(),
            None => format!("{digits}e{}", printed.exponent),
        };
        let unit_of_angles = if printed.in_degrees { "*pi/180" } else { "" };
        let value = scaled(&printed.digits) + unit_of_angles;
        let mut text = Placed::default();
        if let Some(uncertainty) = &printed.uncertainty {
            let value = if printed.is_negative { format!("-{value}") } else { value };
            let away = scaled(uncertainty) + unit_of_angles;
            text.push(&format!("{value} - {away} <= "), span);
            text.append(&exact.text);
            text.push(&format!(" <= {value} + {away}"), span);
        } else {
            self.scope.has_printed = true;
            let unit = last_unit(&printed, self.scope.decisions.digits)?;
            text.push("abs(", span);
            text.append(&exact.text);
            let sign = if printed.is_negative { '+' } else { '-' };
            text.push(&format!(" {sign} {value}) <= 0.5e{unit}{unit_of_angles}"), span);
        }
        Ok(Said { text, level: 6 })
    }
}

/// The number of digits behind the decimal point.
fn places(digits: &str) -> i64 {
    digits.split_once('.').map_or(0, |(_, tail)| tail.len() as i64)
}

/// The power of ten of the last digit that counts: the last printed one, or the one to which a comment says that it is rounded.
fn last_unit(printed: &Printed, said: Option<usize>) -> Read<i64> {
    let Printed { digits, exponent, span, .. } = printed;
    let places = places(digits);
    let significant = digits.replace('.', "");
    let significant = significant.trim_start_matches('0');
    if significant.is_empty() && places == 0 {
        let help = "write the bound that is meant, as in |x| \\le 0.01";
        return Err(refused("what is approximately 0 has no significant digits", help, *span));
    }
    let Some(said) = said else {
        if places == 0 && digits.len() > 1 && digits.ends_with('0') {
            let readings = ["a number rounded to its last digit", "one rounded to its last digit other than 0"];
            let write = [
                &*format!("write `%carom digits {}`", digits.len()),
                &*format!("write `%carom digits {}`", digits.trim_end_matches('0').len()),
            ];
            return Err(ambiguous("a rounded number that ends in 0", readings, write, *span));
        }
        return Ok(exponent - places);
    };
    let beyond = significant
        .len()
        .checked_sub(said)
        .filter(|beyond| *beyond == 0 || (places == 0 && significant.ends_with(&"0".repeat(*beyond))));
    match beyond {
        Some(beyond) if !significant.is_empty() => Ok(exponent - places + beyond as i64),
        _ => {
            let has = significant.len();
            let message = format!("a comment says {said} significant digits, and this number has {has}");
            Err(refused(message, format!("print {said} digits, or write `%carom digits {has}`"), *span))
        }
    }
}

/// `57.1 \pm 0.1` or, without the sign, `57.1(1)`.
pub(crate) fn two_readings(has_sign: bool, span: Span) -> Diagnostic {
    match has_sign {
        true => {
            let readings = ["a measured value with its uncertainty", "the two values, with + and with -"];
            let write = ["write `%carom pm interval`", "write `%carom pm or` or `%carom pm and`"];
            ambiguous("± between two numbers", readings, write, span)
        }
        false => {
            let readings = ["a measured value with the uncertainty of its last digits", "a product"];
            ambiguous(
                "a number in parentheses behind a number",
                readings,
                ["write `%carom pm interval`", "write \\cdot"],
                span,
            )
        }
    }
}
