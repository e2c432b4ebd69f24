//! Units as text: `kg`, `m/s^2`, `J/(kg*K)`, `1/s`.

use super::dimension::{Dimension, raised};
use super::exponent::{Exponent, add_multiple};
use super::table::{Scale, TABLE};
use std::ops::Range;

/// The longest text of a unit, in bytes.
const LENGTH: usize = 200;
/// The deepest nesting of parentheses in a unit.
const NESTING: usize = 10;

/// A unit of measurement.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Unit(Box<Parts>);

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct Parts {
    text: String,
    dimension: Dimension,
    scale: Scale,
}

/// What is wrong with a unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub help: String,
    /// The bytes of the text that are.
    pub place: Range<usize>,
}

impl Unit {
    /// The unit that a text says.
    ///
    /// # Errors
    /// A symbol that is not known, or a sign that does not belong there.
    pub fn read(text: &str) -> Result<Unit, Fault> {
        let mut reader = Reader { text, at: 0, depth: 0, out: String::new() };
        if text.len() > LENGTH {
            return Err(reader.fault("a unit is too long", "write a shorter product of units", 0..text.len()));
        }
        let (dimension, scale) = reader.product()?;
        match reader.next() {
            None => Ok(Unit(Box::new(Parts { text: reader.out, dimension, scale }))),
            Some((c, place)) => {
                let help = "write a unit such as kg, m/s, kg*m/s^2 or J/(kg*K)";
                Err(reader.fault(format!("`{c}` does not belong to a unit"), help, place))
            }
        }
    }

    /// Its text, as a claim file says it: `kg*m/s^2`.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.0.text
    }

    /// With signs of print: `kg·m/s²`.
    #[must_use]
    pub fn printed(&self) -> String {
        self.set("·", &|power| match power.parse() {
            Ok(whole) => raised(Exponent::whole(whole)),
            Err(_) => format!("^{power}"),
        })
    }

    /// As LaTeX, for mathematics mode.
    #[must_use]
    pub fn latex(&self) -> String {
        format!("\\mathrm{{{}}}", self.set("\\,", &|power| format!("^{{{}}}", power.trim_matches(['(', ')']))))
    }

    /// The text with other signs for products and powers.
    fn set(&self, times: &str, power: &dyn Fn(&str) -> String) -> String {
        let mut parts = self.0.text.split('^');
        let mut out = parts.next().unwrap_or_default().replace('*', times);
        for part in parts {
            let end = match part.strip_prefix('(') {
                Some(inside) => inside.find(')').map_or(part.len(), |end| end + 2),
                None => part.find(|c: char| !c.is_ascii_digit() && c != '-').unwrap_or(part.len()),
            };
            out.push_str(&power(&part[..end]));
            out.push_str(&part[end..].replace('*', times));
        }
        out
    }

    /// Its dimension.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.0.dimension
    }

    pub(crate) fn scale(&self) -> Scale {
        self.0.scale
    }
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
    depth: usize,
    /// What was read, in the form of claim files.
    out: String,
}

type Value = (Dimension, Scale);

impl Reader<'_> {
    fn fault(&self, message: impl Into<String>, help: impl Into<String>, place: Range<usize>) -> Fault {
        Fault { message: message.into(), help: help.into(), place }
    }

    /// The next sign and its place.
    fn next(&mut self) -> Option<(char, Range<usize>)> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        let c = self.text[self.at..].chars().next()?;
        Some((c, self.at..self.at + c.len_utf8()))
    }

    fn take(&mut self, signs: &[char]) -> Option<char> {
        let (c, place) = self.next().filter(|(c, _)| signs.contains(c))?;
        self.at = place.end;
        Some(c)
    }

    /// `kg*m/s^2`
    fn product(&mut self) -> Result<Value, Fault> {
        let start = self.at;
        let mut value = match self.next() {
            // 1/s
            Some(('1', place)) => {
                self.at = place.end;
                self.out.push('1');
                if !matches!(self.next(), Some(('/', _))) {
                    return Err(self.fault(
                        "a number is no unit",
                        "write the unit alone, as in kg*m/s^2 or 1/s",
                        place,
                    ));
                }
                (Dimension::NUMBER, [Exponent::ZERO; 4])
            }
            _ => self.factor()?,
        };
        let mut has_divided = false;
        while let Some(sign) = self.take(&['*', '·', '⋅', '/']) {
            let divides = sign == '/';
            if has_divided && !divides {
                let message = "what follows `/` may be read in two ways: (a/b)·c, or a/(b·c)";
                return Err(self.fault(message, "write parentheses, as in J/(kg*K)", start..self.text.len()));
            }
            has_divided |= divides;
            self.out.push(if divides { '/' } else { '*' });
            let other = self.factor()?;
            value = self.times(&value, &other, Exponent::whole(if divides { -1 } else { 1 }), start)?;
        }
        Ok(value)
    }

    fn times(&self, value: &Value, other: &Value, exponent: Exponent, start: usize) -> Result<Value, Fault> {
        let mut scale = value.1;
        let added = add_multiple(&mut scale, &other.1, exponent);
        match added.and(value.0.times(&other.0, exponent)) {
            Some(dimension) => Ok((dimension, scale)),
            None => Err(self.fault("an exponent of this unit is too long", "write a simpler unit", start..self.at)),
        }
    }

    /// `s^2`, `(kg*K)`
    fn factor(&mut self) -> Result<Value, Fault> {
        let start = self.at;
        let value = match self.next() {
            Some(('(', place)) => {
                if self.depth >= NESTING {
                    return Err(self.fault("a unit nests too deep", "write a simpler unit", place));
                }
                (self.at, self.depth) = (place.end, self.depth + 1);
                self.out.push('(');
                let value = self.product()?;
                self.depth -= 1;
                if self.take(&[')']).is_none() {
                    return Err(self.fault("this parenthesis is not closed", "close it with `)`", place));
                }
                self.out.push(')');
                value
            }
            Some((c, _)) if c.is_alphabetic() => self.symbol()?,
            Some((c, place)) if c.is_ascii_digit() => {
                return Err(self.fault("a number is no unit", "write the unit alone, as in kg*m/s^2 or 1/s", place));
            }
            Some((_, place)) => return Err(self.no_symbol(place)),
            None => return Err(self.no_symbol(self.text.len()..self.text.len())),
        };
        match self.exponent()? {
            None => Ok(value),
            Some(exponent) => self.times(&(Dimension::NUMBER, [Exponent::ZERO; 4]), &value, exponent, start),
        }
    }

    fn no_symbol(&self, place: Range<usize>) -> Fault {
        self.fault("a unit is missing here", "write a unit such as kg, m/s or J/(kg*K)", place)
    }

    fn symbol(&mut self) -> Result<Value, Fault> {
        let rest = &self.text[self.at..];
        let length = rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len());
        let (word, place) = (&rest[..length], self.at..self.at + length);
        match TABLE.iter().find(|entry| entry.symbols.contains(&word)) {
            Some(entry) => {
                self.at = place.end;
                self.out.push_str(entry.symbols.first().copied().unwrap_or(word));
                Ok((entry.dimension(), entry.scale()))
            }
            None => {
                let list: Vec<&str> = super::known().collect();
                let help = match word {
                    "deg" | "degree" | "degrees" => "angles are numbers: write `rad`".to_string(),
                    _ => format!("units that are known: {}", list.join(", ")),
                };
                Err(self.fault(format!("{word} is no unit that is known"), help, place))
            }
        }
    }

    /// `^2`, `^-1`, `^(1/2)`, `²`
    fn exponent(&mut self) -> Result<Option<Exponent>, Fault> {
        const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
        let Some((c, place)) = self.next() else { return Ok(None) };
        let digit = |c: char| RAISED.chars().position(|own| own == c);
        let mut text = String::new();
        if c == '^' {
            self.at = place.end;
            let inside = self.take(&['(']).is_some();
            let rest = &self.text[self.at..];
            let length = rest.find(|c: char| !(c.is_ascii_digit() || c == '-' || inside && c == '/'));
            text.push_str(&rest[..length.unwrap_or(rest.len())]);
            self.at += text.len();
            if inside && self.take(&[')']).is_none() {
                return Err(self.fault("this exponent is not closed", "write it as in m^(1/2)", place));
            }
        } else if c == '⁻' || digit(c).is_some() {
            for c in self.text[self.at..].chars() {
                match digit(c) {
                    Some(digit) => text.push_str(&digit.to_string()),
                    None if c == '⁻' && text.is_empty() => text.push('-'),
                    None => break,
                }
                self.at += c.len_utf8();
            }
        } else {
            return Ok(None);
        }
        let (above, below) = text.split_once('/').unwrap_or((&text, "1"));
        let parts = above.parse::<i64>().ok().zip(below.parse::<i64>().ok());
        let value = parts.and_then(|(above, below)| Exponent::new(i128::from(above), i128::from(below)));
        let Some(value) = value else {
            let help = "write a number, as in s^2, s^-1 or m^(1/2)";
            return Err(self.fault("this exponent of a unit is no number", help, place.start..self.at));
        };
        self.out.push('^');
        self.out.push_str(&if text.contains('/') { format!("({value})") } else { value.to_string() });
        Ok(Some(value))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::System;

    fn dimension(text: &str) -> String {
        Unit::read(text).map_or_else(|fault| fault.message, |unit| unit.dimension().to_string())
    }

    #[test]
    fn a_unit_has_another_dimension() {
        for (text, wanted) in [
            ("kg*m/s^2", "kg·m/s²"),
            ("N", "kg·m/s²"),
            ("J/(kg*K)", "m²/(s²·K)"),
            ("1/s", "s⁻¹"),
            ("m s", "`s` does not belong to a unit"),
            ("kg·m²/s²", "kg·m²/s²"),
            ("m^(1/2)", "m^(1/2)"),
            ("s⁻¹", "s⁻¹"),
            ("rad", "1"),
            ("V/A*s", "what follows `/` may be read in two ways: (a/b)·c, or a/(b·c)"),
            ("parsec", "parsec is no unit that is known"),
            ("m^x", "this exponent of a unit is no number"),
            ("2*m", "a number is no unit"),
            ("(m", "this parenthesis is not closed"),
            ("m/", "a unit is missing here"),
            ("", "a unit is missing here"),
            ("m^9223372036854775807^2", "`^` does not belong to a unit"),
            ("(m^9223372036854775807)^2", "an exponent of this unit is too long"),
        ] {
            assert_eq!(dimension(text), wanted, "{text}");
        }
    }

    #[test]
    fn a_unit_is_printed_as_another() {
        for unit in super::super::known().chain(["kg*m/s^2", "J/(kg*K)", "m^(1/2)/s^-1", "1/s"]) {
            let read = Unit::read(unit).unwrap();
            assert_eq!(Unit::read(&read.printed()).unwrap(), read, "{unit}");
            assert_eq!(read.text(), unit);
        }
        assert_eq!(Unit::read("kg*m/s^2").unwrap().latex(), "\\mathrm{kg\\,m/s^{2}}");
    }

    #[test]
    fn units_of_two_scales_fit() {
        let fits = |list: &[&str]| {
            let mut system = System::default();
            list.iter().try_for_each(|unit| system.add(&Unit::read(unit).unwrap()))
        };
        for list in [&["m", "m", "s", "m/s"][..], &["g", "cm/s", "erg"], &["kg", "m/s", "J"], &["keV", "keV"], &["rad"]]
        {
            assert_eq!(fits(list), Ok(()), "{list:?}");
        }
        for (list, wanted) in [
            (&["m", "cm"][..], &["m", "cm"][..]),
            (&["s", "m", "km/h"], &["s", "m", "km/h"]),
            (&["mol", "kg", "m/s", "erg"], &["kg", "m/s", "erg"]),
            (&["m/cm"], &["m/cm"]),
            (&["J", "eV"], &["J", "eV"]),
        ] {
            assert_eq!(fits(list), Err(wanted.iter().map(ToString::to_string).collect()), "{list:?}");
        }
    }
}
