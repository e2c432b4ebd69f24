//! Dimensions: products of powers of the base quantities of the SI.

use super::exponent::{Exponent, add_multiple};
use std::fmt;

/// The units of the base quantities: mass, length, time, current, temperature, amount, luminous intensity.
pub(crate) const BASE: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];

/// A product of powers of the base quantities.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension(pub(crate) [Exponent; 7]);

impl Dimension {
    /// That of a plain number.
    pub const NUMBER: Dimension = Dimension([Exponent::ZERO; 7]);

    /// Whether it is that of a plain number.
    #[must_use]
    pub fn is_number(&self) -> bool {
        self.0.iter().all(|exponent| exponent.is_zero())
    }

    /// `self * other^exponent`; nothing if an exponent becomes too long.
    #[must_use]
    pub fn times(&self, other: &Dimension, exponent: Exponent) -> Option<Dimension> {
        let mut out = *self;
        add_multiple(&mut out.0, &other.0, exponent)?;
        Some(out)
    }

    /// Its power; nothing if an exponent becomes too long.
    #[must_use]
    pub fn to(&self, exponent: Exponent) -> Option<Dimension> {
        Dimension::NUMBER.times(self, exponent)
    }
}

/// A power in print: `²`, `⁻¹`, `^(1/2)`.
pub(crate) fn raised(exponent: Exponent) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let text = exponent.to_string();
    if exponent == Exponent::ONE {
        return String::new();
    }
    if text.contains('/') {
        return format!("^({text})");
    }
    text.chars().map(|c| c.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize])).collect()
}

impl fmt::Display for Dimension {
    /// In base units, `kg·m²/s²`; `1` for a number.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |exponent: Exponent, unit: &str| format!("{unit}{}", raised(exponent));
        let list = || self.0.iter().copied().zip(BASE);
        let above: Vec<String> = list().filter(|(e, _)| e.is_positive()).map(|(e, unit)| part(e, unit)).collect();
        let below: Vec<(Exponent, &str)> = list().filter(|(e, _)| !e.is_zero() && !e.is_positive()).collect();
        let divisor: Vec<String> = below.iter().filter_map(|(e, unit)| e.negated().map(|e| part(e, unit))).collect();
        match (above.join("·"), divisor.as_slice()) {
            (above, []) if above.is_empty() => write!(f, "1"),
            (above, []) => write!(f, "{above}"),
            (above, _) if above.is_empty() => {
                let parts: Vec<String> = below.iter().map(|(e, unit)| part(*e, unit)).collect();
                write!(f, "{}", parts.join("·"))
            }
            (above, [only]) => write!(f, "{above}/{only}"),
            (above, several) => write!(f, "{above}/({})", several.join("·")),
        }
    }
}
