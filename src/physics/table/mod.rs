//! Tables of certified numbers over grids of mass ratios, restitutions and numbers of bodies.
//!
//! **Contract.** A [`Plan`] names the quantity, its axes and how it is printed; [`Plan::row`] gives the row of
//! any place, counted with the last axis running fastest. Every printed digit is right, every `p/q` exact.
//! Rows are made one at a time, or in short pieces on several cores: a table of 10^8 rows takes no more memory than one
//! of a few pieces.
//!
//! **Shared work.** (25) is a product of a factor of `e` and one of the ratio, for each `n`: see [`shared`].

pub mod bounces;
pub mod check;
pub mod comparison;
pub mod foreign;
pub mod grid;
pub mod later;
mod measured;
mod records;
pub mod shared;
pub mod worksheet;

use crate::chain::best::{self, Best};
use crate::chain::{ChainError, Positive, Restitution, Restitutions, threshold, transfer};
use crate::number::NumberError;
use crate::number::decimal::{Decimal, Digits, Rounding, bits_of_digits};
use crate::number::interval::Interval;
use crate::number::real::Real;
use grid::Grid;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use std::fmt;

/// The longest `p/q` that a row shows, in characters.
pub const MAX_EXACT: usize = 60;

/// The name of the axis of numbers of bodies in [`TableError::Range`].
const BODIES: &str = "a number n of inserted bodies";

/// The quantity of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The share of the energy handed on through `n` inserted bodies of optimal mass, (25).
    Eta,
    /// The least restitution with which the `n`-th inserted body helps, `L_n`, (19).
    Threshold,
    /// n*: the best number of inserted bodies, `n*`.
    BestN,
}

impl Quantity {
    /// All quantities.
    pub const ALL: [Quantity; 3] = [Self::Eta, Self::Threshold, Self::BestN];

    /// The name on the command line and at the head of the column.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Eta => "eta",
            Self::Threshold => "threshold",
            Self::BestN => "best-n",
        }
    }

    /// The formula as text, `r` being the ratio m1/m2.
    #[must_use]
    pub fn formula(self) -> &'static str {
        match self {
            Self::Eta => "eta = (1 + e)^(2(n + 1)) r/(1 + r^(1/(n + 1)))^(2(n + 1))",
            Self::Threshold => "L_n = (1 + r^(1/(n + 1)))^(n + 1)/(1 + r^(1/n))^n - 1",
            Self::BestN => "n* = number of n >= 1 with L_n <= e",
        }
    }

    /// The formula for mathematics mode in LaTeX.
    #[must_use]
    pub fn latex(self) -> &'static str {
        match self {
            Self::Eta => r"\eta = (1+e)^{2(n+1)}\, r \big/ \bigl(1 + r^{1/(n+1)}\bigr)^{2(n+1)}",
            Self::Threshold => r"L_n = \bigl(1 + r^{1/(n+1)}\bigr)^{n+1} \big/ \bigl(1 + r^{1/n}\bigr)^n - 1",
            Self::BestN => r"n^* = \#\{n \ge 1 : L_n \le e\}",
        }
    }

    /// The equation of the paper, or the claim of the catalogue.
    #[must_use]
    pub fn equation(self) -> &'static str {
        match self {
            Self::Eta => "(25)",
            Self::Threshold => "(19)",
            Self::BestN => "claim b-best, from (19)",
        }
    }

    /// Whether it depends on the restitution.
    #[must_use]
    pub fn needs_e(self) -> bool {
        self != Self::Threshold
    }

    /// Whether it depends on the number of inserted bodies.
    #[must_use]
    pub fn needs_n(self) -> bool {
        self != Self::BestN
    }
}

/// How numbers are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Printing {
    /// How many digits.
    pub digits: Digits,
    /// In which direction they are rounded.
    pub rounding: Rounding,
    /// How many further digits are shown beside them.
    pub extra: u64,
}

/// Why there is no table.
#[derive(Clone, Debug, PartialEq)]
pub enum TableError {
    /// The quantity depends on an axis that is not given.
    Lacks(Quantity, &'static str),
    /// The quantity does not depend on an axis that is given.
    Independent(Quantity, &'static str),
    /// A value of an axis is out of its range.
    Range {
        /// The axis.
        axis: &'static str,
        /// The value.
        value: Rational,
        /// What would be right.
        wanted: &'static str,
    },
    /// The numbers of inserted bodies are not all integers.
    NotIntegral,
    /// Further digits are asked of a whole number.
    Whole(Quantity),
    /// So many digits cannot be printed.
    Digits(NumberError),
    /// More rows than a machine word counts.
    TooManyRows,
    /// A row cannot be computed.
    Row {
        /// Which, in words.
        row: String,
        /// Why.
        error: Box<ChainError>,
    },
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lacks(quantity, axis) => {
                write!(f, "{} depends on {axis}: give at least one value of {axis}", quantity.name())
            }
            Self::Independent(quantity, axis) => {
                write!(f, "{} does not depend on {axis}: leave {axis} out", quantity.name())
            }
            Self::Range { axis, value, wanted } => write!(f, "{axis} {wanted}, not {value}"),
            Self::NotIntegral => write!(f, "n is a number of bodies: give whole numbers"),
            Self::Whole(quantity) => {
                write!(f, "{} is a whole number and has no more digits: leave them out", quantity.name())
            }
            Self::Digits(error) => write!(f, "{error}"),
            Self::TooManyRows => write!(f, "limit reached: rows of a table: {} allowed", u64::MAX),
            Self::Row { row, error } => write!(f, "{row}: {error}"),
        }
    }
}

impl std::error::Error for TableError {}

impl TableError {
    /// Whether a stated limit is the reason.
    #[must_use]
    pub fn is_limit(&self) -> bool {
        match self {
            Self::TooManyRows | Self::Digits(NumberError::LimitReached { .. }) => true,
            Self::Range { axis: BODIES, value, .. } => *value > crate::chain::MAX_INSERTED,
            Self::Row { error, .. } => matches!(**error, ChainError::Number(NumberError::LimitReached { .. })),
            _ => false,
        }
    }
}

/// A quantity over its axes.
#[derive(Clone, Debug)]
pub struct Plan {
    quantity: Quantity,
    ratio: Grid,
    e: Option<Grid>,
    n: Option<Grid>,
    rows: u64,
    printing: Printing,
}

/// The values of the axes at one row.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The ratio m1/m2.
    pub ratio: Positive,
    /// The restitution, where the quantity depends on it.
    pub e: Option<Restitution>,
    /// The number of inserted bodies, where the quantity depends on it.
    pub n: Option<u64>,
}

/// A row.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The values of the axes as text.
    pub labels: Vec<String>,
    /// The value, rounded as asked.
    pub value: String,
    /// The value as `p/q` where it is rational and no longer than [`MAX_EXACT`] characters.
    pub exact: Option<String>,
    /// Further digits, where asked for.
    pub further: Option<Further>,
}

/// A longer decimal, cut off: the value lies between it and itself plus `bound`, away from zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Further {
    /// The longer decimal.
    pub decimal: String,
    /// How many of its digits are beyond those asked for.
    pub small: usize,
    /// One unit of its last digit; `0` where it is exact.
    pub bound: String,
}

/// The value of a row before it is printed.
pub enum Value {
    /// A real number.
    Real(Real),
    /// A number of bodies.
    Count(Best),
}

/// The value of a row, perhaps with its digits.
pub enum Found {
    /// Nothing is printed yet.
    Open(Value),
    /// An irrational number of which the digits asked for are settled already, by this enclosure.
    Settled(Decimal, Interval),
    /// The same, with a double below and one above.
    Quick(Decimal, (f64, f64)),
}

impl Plan {
    /// A table; every value of every axis is checked.
    ///
    /// # Errors
    /// [`TableError`]; nothing is computed yet.
    pub fn new(
        quantity: Quantity,
        ratio: Grid,
        e: Option<Grid>,
        n: Option<Grid>,
        printing: Printing,
    ) -> Result<Plan, TableError> {
        for (needed, given, axis) in [(quantity.needs_e(), e.is_some(), "e"), (quantity.needs_n(), n.is_some(), "n")] {
            match (needed, given) {
                (true, false) => return Err(TableError::Lacks(quantity, axis)),
                (false, true) => return Err(TableError::Independent(quantity, axis)),
                _ => {}
            }
        }
        if quantity == Quantity::BestN && printing.extra > 0 {
            return Err(TableError::Whole(quantity));
        }
        let range = |axis, value, wanted| Err(TableError::Range { axis, value, wanted });
        let (low, _) = ratio.bounds();
        if low <= Rational::ZERO {
            return range("a ratio", low, "of masses is above 0");
        }
        if let Some((low, high)) = e.as_ref().map(Grid::bounds) {
            let wanted = "lies from 0 to 1";
            if low < Rational::ZERO {
                return range("a restitution e", low, wanted);
            }
            if high > Rational::ONE {
                return range("a restitution e", high, wanted);
            }
        }
        if let Some(grid) = &n {
            let (low, high) = grid.bounds();
            let least = if quantity == Quantity::Threshold { Rational::ONE } else { Rational::ZERO };
            if low < least {
                let wanted = if quantity == Quantity::Threshold { "is at least 1" } else { "is at least 0" };
                return range(BODIES, low, wanted);
            }
            if !grid.is_integral() {
                return Err(TableError::NotIntegral);
            }
            if high > crate::chain::MAX_INSERTED {
                return range(BODIES, high, "is at most 10^18 (limit reached)");
            }
        }
        // Refuses numbers of digits that no row could have.
        Decimal::of_rational(&Rational::ONE, printing.digits, printing.rounding).map_err(TableError::Digits)?;
        let rows = [Some(&ratio), e.as_ref(), n.as_ref()]
            .into_iter()
            .flatten()
            .try_fold(1u64, |rows, grid| rows.checked_mul(grid.len()))
            .ok_or(TableError::TooManyRows)?;
        Ok(Plan { quantity, ratio, e, n, rows, printing })
    }

    /// The quantity.
    #[must_use]
    pub fn quantity(&self) -> Quantity {
        self.quantity
    }

    /// How it is printed.
    #[must_use]
    pub fn printing(&self) -> Printing {
        self.printing
    }

    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// The axes in their order, the first running slowest.
    pub fn axes(&self) -> impl Iterator<Item = (&'static str, &Grid)> {
        [("ratio", Some(&self.ratio)), ("e", self.e.as_ref()), ("n", self.n.as_ref())]
            .into_iter()
            .filter_map(|(name, grid)| Some((name, grid?)))
    }

    /// The names of the axes.
    #[must_use]
    pub fn axis_names(&self) -> Vec<&'static str> {
        self.axes().map(|a| a.0).collect()
    }

    /// The places of a row on the axes of ratio, restitution and number; 0 where there is none.
    fn places(&self, row: u64) -> [u64; 3] {
        let (ns, es) = (self.n.as_ref().map_or(1, Grid::len), self.e.as_ref().map_or(1, Grid::len));
        [row / ns / es, row / ns % es, row % ns]
    }

    /// The values of the axes at a row; `None` beyond the last one.
    #[must_use]
    pub fn place(&self, row: u64) -> Option<Place> {
        let [i, j, k] = self.places(row);
        let at = |grid: &Option<Grid>, place| grid.as_ref().and_then(|g| g.value(place));
        Some(Place {
            ratio: Positive::new(self.ratio.value(i)?).ok()?,
            e: at(&self.e, j).and_then(|e| Restitution::new(e).ok()),
            n: at(&self.n, k).and_then(|n| u64::try_from(&n).ok()),
        })
    }

    /// The values of the axes at a row as text.
    #[must_use]
    pub fn labels(&self, row: u64) -> Vec<String> {
        let [i, j, k] = self.places(row);
        let at = |grid: Option<&Grid>, place| grid.and_then(|g| g.label(place));
        [at(Some(&self.ratio), i), at(self.e.as_ref(), j), at(self.n.as_ref(), k)].into_iter().flatten().collect()
    }

    /// The value of a row, by itself.
    ///
    /// # Errors
    /// [`TableError::Row`] naming the row, where a limit is reached.
    pub fn value(&self, row: u64) -> Result<Value, TableError> {
        let fail = |error| TableError::Row { row: self.in_words(row), error: Box::new(error) };
        let place = self.place(row).ok_or(TableError::TooManyRows)?;
        value(self.quantity, &place).map_err(fail)
    }

    /// `ratio 10, e 0.9, n 7`.
    #[must_use]
    pub fn in_words(&self, row: u64) -> String {
        let parts: Vec<String> =
            self.axes().zip(self.labels(row)).map(|((name, _), label)| format!("{name} {label}")).collect();
        parts.join(", ")
    }

    /// Prints a value of a row, and gives the enclosure that settles its digits.
    ///
    /// # Errors
    /// [`TableError::Row`].
    pub fn row(&self, row: u64, found: Found) -> Result<(Row, Option<Interval>), TableError> {
        self.labelled(row, self.labels(row), found)
    }

    /// The same with the texts of the axes, which the caller knows.
    ///
    /// # Errors
    /// [`TableError::Row`].
    pub fn labelled(&self, row: u64, labels: Vec<String>, found: Found) -> Result<(Row, Option<Interval>), TableError> {
        let fail = |error: NumberError| TableError::Row { row: self.in_words(row), error: Box::new(error.into()) };
        let real = match found {
            Found::Quick(decimal, (lo, hi)) => {
                let row = Row { labels, value: decimal.to_string(), exact: None, further: None };
                return Ok((row, Some(Interval::between_f64(lo, hi))));
            }
            Found::Settled(decimal, enclosure) => {
                let row = Row { labels, value: decimal.to_string(), exact: None, further: None };
                return Ok((row, Some(enclosure)));
            }
            Found::Open(Value::Count(best)) => {
                let (value, exact) = count_text(&best);
                return Ok((Row { labels, value, exact, further: None }, None));
            }
            Found::Open(Value::Real(real)) => real,
        };
        let Printing { digits, rounding, extra } = self.printing;
        let (decimal, enclosure) = rounded(&real, digits, rounding).map_err(fail)?;
        let exact = real.as_rational().and_then(short);
        let further = if extra == 0 { None } else { Some(further(&real, digits, extra).map_err(fail)?) };
        Ok((Row { labels, value: decimal.to_string(), exact, further }, Some(enclosure)))
    }
}

/// A quantity at one place.
///
/// # Errors
/// [`ChainError`]: a limit, or an axis that is missing.
pub fn value(quantity: Quantity, place: &Place) -> Result<Value, ChainError> {
    let missing = |of| ChainError::Count { of, given: 0, needed: 1 };
    let e = || place.e.clone().ok_or(missing("coefficients of restitution"));
    let n = || place.n.ok_or(missing("numbers of inserted bodies"));
    Ok(match quantity {
        Quantity::Eta => Value::Real(transfer::optimal(&place.ratio, &Restitutions::Same(e()?), n()?)?),
        Quantity::Threshold => Value::Real(threshold::threshold(&place.ratio, n()?)?),
        Quantity::BestN => Value::Count(best::best(&place.ratio, &e()?)?.0),
    })
}

/// A rational as text, where that is short enough to show.
fn short(x: &Rational) -> Option<String> {
    // A digit holds more than three bits: longer ones need not be written to see that they are.
    let bits = x.numerator_ref().significant_bits() + x.denominator_ref().significant_bits();
    (bits <= 4 * MAX_EXACT as u64).then(|| x.to_string()).filter(|text| text.len() <= MAX_EXACT)
}

/// A number of bodies as text, and exactly where it is finite.
#[must_use]
pub fn count_text(best: &Best) -> (String, Option<String>) {
    match best {
        Best::Finite { count, .. } => (count.to_string(), Some(count.to_string())),
        Best::Infinite => ("infinite".to_owned(), None),
        Best::Any => ("any".to_owned(), None),
    }
}

/// The decimal with an enclosure of which every element rounds to it.
///
/// # Errors
/// [`NumberError`] as [`Decimal::of_real`].
pub fn rounded(x: &Real, digits: Digits, rounding: Rounding) -> Result<(Decimal, Interval), NumberError> {
    let (Digits::Significant(count) | Digits::Places(count)) = digits;
    let bits = bits_of_digits(count) + 16;
    if x.as_rational().is_some() {
        let (decimal, _) = Decimal::of_real(x, digits, rounding)?;
        return Ok((decimal, x.enclosure(bits)));
    }
    // Refuses what `settle` would search for in vain.
    Decimal::of_rational(&Rational::ONE, digits, rounding)?;
    let settle = |enclosure: &Interval| Some((Decimal::of_interval(enclosure, digits, rounding)?, enclosure.clone()));
    Ok(x.settle(bits, settle)?.0)
}

fn further(x: &Real, digits: Digits, extra: u64) -> Result<Further, NumberError> {
    let more = match digits {
        Digits::Significant(d) => Digits::Significant(d.saturating_add(extra)),
        Digits::Places(p) => Digits::Places(p.saturating_add(extra)),
    };
    let (decimal, _) = Decimal::of_real(x, more, Rounding::Zero)?;
    let (found, _) = Decimal::with_extra(x, digits, extra)?;
    Ok(Further {
        decimal: decimal.to_string(),
        small: usize::try_from(extra).unwrap_or(usize::MAX),
        bound: found.bound,
    })
}
