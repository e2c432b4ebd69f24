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

/// The input of a report.
pub struct Replay<'a> {
    /// The title of the scene.
    pub title: Option<&'a str>,
    /// The line.
    pub line: &'a Line,
    /// The result of the replay.
    pub outcome: &'a Outcome,
    /// How numbers are written.
    pub numbers: Numbers,
}

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbers {
    /// As `p/q`, or in a quadratic field; enclosed ones as decimals.
    Exact,
    /// As decimals with this many significant digits, correctly rounded.
    Decimal(u64),
    /// Exact if that takes at most this many characters (first number), else as decimals with this many digits (second).
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

/// Default digits of enclosed numbers.
pub const DEFAULT_DIGITS: u64 = 15;

/// The number rounded to as many certain digits as there are, at most this many; an enclosure if no digit is certain.
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

/// The name of a point in reports: the number of a body, or a wall.
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

/// The number of collisions, and how often there were infinitely many.
#[must_use]
pub fn counted(outcome: &Outcome) -> String {
    let plural = if outcome.count == 1 { "" } else { "s" };
    let besides = match outcome.joins {
        0 => String::new(),
        1 => ", and infinitely many more".to_string(),
        often => format!(", and {often} times infinitely many more"),
    };
    format!("{} collision{plural}{besides}", outcome.count)
}

/// The names of a group of points.
#[must_use]
pub fn group(line: &Line, (first, last): (usize, usize)) -> String {
    format!("{} to {}", name(line, first), name(line, last))
}

/// The names of a pair of points.
#[must_use]
pub fn pair(line: &Line, left: usize) -> String {
    format!("{}–{}", name(line, left), name(line, left + 1))
}
