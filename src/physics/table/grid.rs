//! The axis of a table: exact values, listed or in steps.
//!
//! **Contract.** A grid is a list `a,b,c` of different numbers, an arithmetic run `start:stop:step` or a geometric run
//! `start:stop:xFACTOR`. Every value is exact: `0.1` is one tenth, and the tenth step from 0 is 1. A run
//! includes its stop where it meets it. The values of an arithmetic run are made when they are asked for,
//! so that an axis of 10^8 values takes no memory.
//!
//! **Limits.** A geometric run holds its values: at most [`MAX_GEOMETRIC`] of them and [`MAX_BITS`] bits in all.

use crate::number::NumberError;
use crate::number::rational::{self, NumeralError};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Abs, Floor};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use std::collections::HashSet;
use std::fmt;

/// The most values of a geometric run.
pub const MAX_GEOMETRIC: usize = 1_000_000;
/// The most bits of all values of a geometric run.
pub const MAX_BITS: u64 = 1 << 30;
/// The most values of one axis.
pub(crate) const MAX_VALUES: u64 = 1 << 62;

/// Exact values in order; at least one.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    values: Values,
    /// Values are shown as fractions, not as decimals.
    fractions: bool,
}

#[derive(Clone, Debug, PartialEq)]
enum Values {
    /// With the text as it was given.
    List(Vec<(String, Rational)>),
    Steps {
        start: Rational,
        step: Rational,
        count: u64,
    },
    Made(Vec<Rational>),
}

/// How the values of a grid are made, for writing them down.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// One by one.
    List(Vec<Rational>),
    /// So many from a start on, each by a step more than the last.
    Steps(Rational, Rational, u64),
    /// So many from a start on, each a factor times the last.
    Factors(Rational, Rational, u64),
}

/// Why a text is no grid.
#[derive(Clone, Debug, PartialEq)]
pub enum GridError {
    /// A part is no number.
    Numeral {
        /// The part.
        part: String,
        /// What is wrong with it.
        error: NumeralError,
    },
    /// A number is missing between commas or colons.
    Missing,
    /// Neither a list nor a run of three parts.
    Shape,
    /// Commas and colons together.
    Mixed,
    /// A list holds a number twice.
    Twice {
        /// The number as it stands there the second time.
        part: String,
    },
    /// The step is 0, or the factor 1.
    Still,
    /// The run never comes nearer to its stop.
    Away,
    /// A geometric run needs positive numbers.
    NotPositive,
    /// A stated limit.
    Limit {
        /// Its name.
        limit: &'static str,
        /// What it allows.
        allowed: u64,
    },
}

impl fmt::Display for GridError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Numeral { part, error } => match beyond_limits(error) {
                Some(limit) => write!(f, "{limit}"),
                None => write!(f, "{part:?} is not a number: {error}"),
            },
            Self::Missing => write!(f, "a number is missing; write a,b,c or start:stop:step or start:stop:xFACTOR"),
            Self::Shape => write!(f, "a progression has three parts: start:stop:step or start:stop:xFACTOR"),
            Self::Mixed => {
                write!(f, "commas and colons cannot be mixed; write a list a,b,c or one progression start:stop:step")
            }
            Self::Twice { part } => write!(f, "{part} is given twice; leave one of them out"),
            Self::Still => {
                write!(f, "a step of 0 or a factor of 1 never leaves the start; give another step or factor")
            }
            Self::Away => {
                write!(
                    f,
                    "the steps lead away from the stop and never reach the stop; write the step with the other sign, or 1/factor"
                )
            }
            Self::NotPositive => write!(f, "a geometric progression needs a positive start, stop and factor"),
            Self::Limit { limit, allowed } => write!(f, "limit reached: {limit}: {allowed} allowed"),
        }
    }
}

impl std::error::Error for GridError {}

impl GridError {
    /// Whether a stated limit is the reason.
    #[must_use]
    pub fn is_limit(&self) -> bool {
        match self {
            Self::Limit { .. } => true,
            Self::Numeral { error, .. } => beyond_limits(error).is_some(),
            _ => false,
        }
    }
}

/// The limit that a numeral exceeds, where that is what keeps it from being read.
#[must_use]
pub(crate) fn beyond_limits(error: &NumeralError) -> Option<NumberError> {
    match error {
        NumeralError::TooManyDigits { allowed, needed } => Some(NumberError::LimitReached {
            limit: "digits of a numeral",
            allowed: *allowed as u64,
            needed: needed.to_string(),
        }),
        NumeralError::ExponentTooLarge { allowed, .. } => Some(NumberError::LimitReached {
            limit: "exponent of a numeral",
            allowed: *allowed,
            needed: "more".to_owned(),
        }),
        _ => None,
    }
}

fn number(part: &str) -> Result<Rational, GridError> {
    match part.trim() {
        "" => Err(GridError::Missing),
        text => rational::parse(text).map_err(|error| GridError::Numeral { part: text.to_owned(), error }),
    }
}

impl Grid {
    /// Reads a grid.
    ///
    /// ```
    /// use carom_physics::table::grid::Grid;
    /// let labels = |text: &str| {
    ///     let grid = Grid::parse(text).unwrap();
    ///     (0..grid.len()).filter_map(|i| grid.label(i)).collect::<Vec<_>>().join(" ")
    /// };
    /// assert_eq!(labels("0.10,1/3"), "0.10 1/3");
    /// assert_eq!(labels("0:1:0.25"), "0 0.25 0.5 0.75 1");
    /// assert_eq!(labels("1:100:x10"), "1 10 100");
    /// assert_eq!(labels("1:1/4:x1/2"), "1 1/2 1/4");
    /// ```
    ///
    /// # Errors
    /// [`GridError`] says what is wrong and what would be right.
    pub fn parse(text: &str) -> Result<Grid, GridError> {
        let grid = Grid::sample(text)?;
        if let Values::List(list) = &grid.values {
            let mut seen = HashSet::new();
            if let Some((part, _)) = list.iter().find(|(_, value)| !seen.insert(value)) {
                return Err(GridError::Twice { part: part.clone() });
            }
        }
        Ok(grid)
    }

    /// The same for a list of measured or drawn values, in which a number may come again: an axis of numbers that are
    /// computed with, not of a table that is certified.
    ///
    /// # Errors
    /// [`GridError`] but for [`GridError::Twice`].
    pub fn sample(text: &str) -> Result<Grid, GridError> {
        if !text.contains(':') {
            let list = text.split(',').map(|part| Ok((part.trim().to_owned(), number(part)?)));
            let values = Values::List(list.collect::<Result<_, _>>()?);
            return Ok(Grid { values, fractions: false });
        }
        if text.contains(',') {
            return Err(GridError::Mixed);
        }
        let parts: Vec<&str> = text.split(':').collect();
        let [start, stop, step] = parts[..] else { return Err(GridError::Shape) };
        let fractions = text.contains('/');
        let (start, stop) = (number(start)?, number(stop)?);
        let values = match step.trim().strip_prefix('x') {
            Some(factor) => geometric(start, &stop, &number(factor)?)?,
            None => arithmetic(start, &stop, number(step)?)?,
        };
        Ok(Grid { values, fractions })
    }

    /// A grid of one value.
    #[must_use]
    pub fn single(value: Rational) -> Grid {
        Grid { values: Values::Made(vec![value]), fractions: false }
    }

    /// How many values there are; at least one.
    #[must_use]
    #[allow(clippy::len_without_is_empty, reason = "a grid is never empty")]
    pub fn len(&self) -> u64 {
        match &self.values {
            Values::List(list) => list.len() as u64,
            Values::Steps { count, .. } => *count,
            Values::Made(list) => list.len() as u64,
        }
    }

    /// How its values are made.
    #[must_use]
    pub fn shape(&self) -> Shape {
        match &self.values {
            Values::List(list) => Shape::List(list.iter().map(|v| v.1.clone()).collect()),
            Values::Steps { start, step, count } => Shape::Steps(start.clone(), step.clone(), *count),
            Values::Made(list) => match &list[..] {
                [first, second, ..] => Shape::Factors(first.clone(), second / first, self.len()),
                _ => Shape::List(list.clone()),
            },
        }
    }

    /// The value at a place, from 0.
    #[must_use]
    pub fn value(&self, place: u64) -> Option<Rational> {
        let at = usize::try_from(place).ok();
        match &self.values {
            Values::List(list) => list.get(at?).map(|v| v.1.clone()),
            Values::Steps { start, step, count } => (place < *count).then(|| start + step * Rational::from(place)),
            Values::Made(list) => list.get(at?).cloned(),
        }
    }

    /// The value at a place as it was given, or as a decimal where it has one, or as `p/q`.
    #[must_use]
    pub fn label(&self, place: u64) -> Option<String> {
        if let Values::List(list) = &self.values {
            return list.get(usize::try_from(place).ok()?).map(|v| v.0.clone());
        }
        let value = self.value(place)?;
        Some(if self.fractions { value.to_string() } else { decimal_or_fraction(&value) })
    }

    /// The least and the greatest value.
    #[must_use]
    pub fn bounds(&self) -> (Rational, Rational) {
        let of = |list: &mut dyn Iterator<Item = &Rational>| {
            let first = list.next().cloned().unwrap_or(Rational::ZERO);
            list.fold((first.clone(), first), |(low, high), v| {
                if *v < low {
                    (v.clone(), high)
                } else if *v > high {
                    (low, v.clone())
                } else {
                    (low, high)
                }
            })
        };
        match &self.values {
            Values::List(list) => of(&mut list.iter().map(|v| &v.1)),
            Values::Made(list) => of(&mut list.iter()),
            Values::Steps { start, step, count } => {
                let last = start + step * Rational::from(count - 1);
                if last < *start { (last, start.clone()) } else { (start.clone(), last) }
            }
        }
    }

    /// Whether every value is an integer.
    #[must_use]
    pub(crate) fn is_integral(&self) -> bool {
        let integer = |v: &Rational| *v.denominator_ref() == 1u32;
        match &self.values {
            Values::List(list) => list.iter().all(|v| integer(&v.1)),
            Values::Made(list) => list.iter().all(integer),
            Values::Steps { start, step, count } => integer(start) && (*count == 1 || integer(step)),
        }
    }
}

fn arithmetic(start: Rational, stop: &Rational, step: Rational) -> Result<Values, GridError> {
    if step == Rational::ZERO {
        return Err(GridError::Still);
    }
    let steps = (stop - &start) / &step;
    if steps < Rational::ZERO {
        return Err(GridError::Away);
    }
    let count = u64::try_from(&steps.floor()).ok().filter(|c| *c < MAX_VALUES);
    let Some(count) = count else { return Err(GridError::Limit { limit: "values of a grid", allowed: MAX_VALUES }) };
    Ok(Values::Steps { start, step, count: count + 1 })
}

fn geometric(start: Rational, stop: &Rational, factor: &Rational) -> Result<Values, GridError> {
    if start <= Rational::ZERO || *stop <= Rational::ZERO || *factor <= Rational::ZERO {
        return Err(GridError::NotPositive);
    }
    if *factor == Rational::ONE {
        return Err(GridError::Still);
    }
    let rises = *factor > Rational::ONE;
    let beyond = |v: &Rational| if rises { v > stop } else { v < stop };
    if beyond(&start) {
        return Err(GridError::Away);
    }
    let mut list = Vec::new();
    let mut bits = 0;
    let mut value = start;
    while !beyond(&value) {
        bits += value.numerator_ref().significant_bits() + value.denominator_ref().significant_bits();
        if bits > MAX_BITS {
            return Err(GridError::Limit { limit: "bits of a geometric grid", allowed: MAX_BITS });
        }
        if list.len() >= MAX_GEOMETRIC {
            return Err(GridError::Limit { limit: "values of a geometric grid", allowed: MAX_GEOMETRIC as u64 });
        }
        let next = &value * factor;
        list.push(value);
        value = next;
    }
    Ok(Values::Made(list))
}

/// The longest decimal that stands for a fraction.
const MAX_DECIMAL: u32 = 20;

/// A terminating decimal of moderate length where there is one, else `p/q`.
#[must_use]
pub fn decimal_or_fraction(value: &Rational) -> String {
    let mut scaled = value.clone();
    for places in 0..=MAX_DECIMAL {
        if *scaled.denominator_ref() == 1u32 {
            if places == 0 {
                return scaled.to_string();
            }
            let digits = (&scaled).abs().to_string();
            let width = places as usize + 1;
            let padded = format!("{digits:0>width$}");
            let (whole, fraction) = padded.split_at(padded.len() - places as usize);
            let sign = if scaled < Rational::ZERO { "-" } else { "" };
            return format!("{sign}{whole}.{fraction}");
        }
        scaled *= Rational::from(10);
    }
    value.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(text: &str) -> String {
        Grid::parse(text).expect_err(text).to_string()
    }

    #[test]
    fn steps_are_exact_and_meet_their_stop() {
        let grid = Grid::parse("0.1:0.9:0.1").expect("a grid");
        assert_eq!(grid.len(), 9);
        assert_eq!(grid.value(8), rational::parse("9/10").ok());
        assert_eq!(grid.value(9), None);
        assert_eq!(Grid::parse("1:2:0.3").expect("a grid").len(), 4);
        assert_eq!(Grid::parse("9:1:-4").expect("a grid").bounds(), (Rational::ONE, Rational::from(9)));
        assert_eq!(Grid::parse("5:5:1").expect("a grid").len(), 1);
        let long = Grid::parse("1:1e8:1").expect("a grid");
        assert_eq!((long.len(), long.label(99_999_999)), (100_000_000, Some("100000000".to_owned())));
        assert!(long.is_integral() && !grid.is_integral());
    }

    #[test]
    fn bad_grids_say_what_would_be_right() {
        assert!(fault("").contains("missing"));
        assert!(fault("1,,2").contains("missing"));
        assert!(fault("1,2,3,1").contains("1 is given twice"));
        assert!(fault("0.5,1/2").contains("1/2 is given twice"));
        assert_eq!(Grid::sample("0.5,1/2,0.5").map(|grid| grid.len()), Ok(3));
        assert!(fault("1:2").contains("three parts"));
        assert!(fault("1:2:3:4").contains("three parts"));
        assert!(fault("1,2:3:1").contains("mixed"));
        assert!(fault("1:2:0").contains("never leaves the start"));
        assert!(fault("1:2:x1").contains("never leaves the start"));
        assert!(fault("1:2:-1").contains("never reach the stop"));
        assert!(fault("1:2:x1/2").contains("never reach the stop"));
        assert!(fault("0:2:x2").contains("positive"));
        assert!(fault("1.2(3)").contains("uncertainty"));
        assert!(fault("one").contains("\"one\""));
        assert!(Grid::parse("0:1:1e-30").is_err_and(|e| e.is_limit()));
        assert!(Grid::parse("1e99999").is_err_and(|e| e.is_limit()));
        assert!(!Grid::parse("1,x").is_err_and(|e| e.is_limit()));
        assert!(fault("0:1:1e-30").contains("limit reached"));
        assert!(fault("1:1e9999:x1.00000000000000000000000000001").contains("limit reached"));
    }

    #[test]
    fn labels_read_back() {
        for text in ["-1/8:1:1/8", "0.001:0.01:0.0005", "1:1e30:x1000", "-0.5:0.5:0.125", "7:1/7:x1/7"] {
            let grid = Grid::parse(text).expect(text);
            for place in 0..grid.len() {
                let label = grid.label(place).expect("in range");
                assert_eq!(rational::parse(&label).ok(), grid.value(place), "{text} {label}");
            }
        }
    }
}
