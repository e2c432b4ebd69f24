//! A replay as text, JSON, CSV, as a space–time diagram and as a page that moves.

pub mod csv;
pub mod html;
pub mod json;
pub mod svg;
pub mod text;

use crate::chain::replay::{Line, Outcome, Value};
use crate::number::decimal::{Decimal, Digits, Rounding, outward};
use crate::number::interval::Interval;
use malachite::Rational;

/// What a report is made from.
pub struct Replay<'a> {
    /// The title of the scene.
    pub title: Option<&'a str>,
    /// The line.
    pub line: &'a Line,
    /// What the replay found.
    pub outcome: &'a Outcome,
    /// How numbers are written.
    pub numbers: Numbers,
}

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbers {
    /// As `p/q`, or in a quadratic field; enclosed ones as decimals.
    Exact,
    /// As decimals of so many significant digits, all right.
    Decimal(u64),
    /// Exact where that takes at most so many characters, else as decimals with so many digits.
    Short(usize, u64),
}

impl Numbers {
    /// The number as text.
    #[must_use]
    pub fn write(self, value: &Value) -> String {
        let exact = match value {
            Value::Exact(x) => Some(x.to_string()),
            Value::Surd(x) => Some(x.to_string()),
            Value::Within(..) => None,
        };
        match (self, exact) {
            (Numbers::Exact, Some(text)) => text,
            (Numbers::Short(most, _), Some(text)) if text.chars().count() <= most => text,
            (Numbers::Exact, None) => decimal(value, DEFAULT_DIGITS),
            (Numbers::Decimal(digits) | Numbers::Short(_, digits), _) => decimal(value, digits),
        }
    }

    /// A rational as text.
    #[must_use]
    pub fn rational(self, x: &Rational) -> String {
        self.write(&Value::Exact(x.clone()))
    }
}

/// Digits of numbers that are enclosed, where none were asked for.
pub const DEFAULT_DIGITS: u64 = 15;

/// The number rounded to as many digits as are certain, at most so many; an enclosure where none is.
#[must_use]
pub fn decimal(value: &Value, digits: u64) -> String {
    let round = |x: &Rational, d| Decimal::of_rational(x, Digits::Significant(d), Rounding::Nearest).ok();
    if let Some(x) = value.rational() {
        return round(x, digits).map_or_else(|| x.to_string(), |d| d.to_string());
    }
    let mut bits = digits.saturating_mul(4).saturating_add(64);
    loop {
        let (lo, hi) = value.enclose(bits);
        let common = |d| round(&lo, d).filter(|low| round(&hi, d).as_ref() == Some(low));
        let wanted = if matches!(value, Value::Surd(_)) { digits } else { 1 };
        if let Some(found) = (wanted..=digits).rev().find_map(common) {
            return found.to_string();
        }
        if matches!(value, Value::Within(..)) || bits > 1 << 24 {
            let both = Interval::from_rational(&lo, bits).widened(&Interval::from_rational(&(hi - &lo), 64));
            return outward(&both, 3).map_or_else(|| "unknown".to_string(), |(a, b)| format!("[{a}, {b}]"));
        }
        // An irrational number is never a tie: more bits settle it.
        bits *= 2;
    }
}

/// The point as people call it: a number, or a wall.
#[must_use]
pub fn name(line: &Line, point: usize) -> String {
    if point == 0 {
        "left wall".to_string()
    } else if point > line.bodies() {
        "right wall".to_string()
    } else {
        point.to_string()
    }
}

/// How many collisions there were, and how often infinitely many.
#[must_use]
pub fn counted(outcome: &Outcome) -> String {
    let plural = if outcome.count == 1 { "" } else { "s" };
    let besides = match outcome.joins {
        0 => String::new(),
        1 => ", besides infinitely many".to_string(),
        often => format!(", besides {often} times infinitely many"),
    };
    format!("{} collision{plural}{besides}", outcome.count)
}

/// The points as people call them.
#[must_use]
pub fn group(line: &Line, (first, last): (usize, usize)) -> String {
    format!("{} to {}", name(line, first), name(line, last))
}

/// The pair as people call it.
#[must_use]
pub fn pair(line: &Line, left: usize) -> String {
    format!("{}–{}", name(line, left), name(line, left + 1))
}
