//! A part of a table's rows, for many machines.
//!
//! **Contract.** Shard `i/n` of a table of `R` rows holds the rows from `⌊(i−1)R/n⌋` up to, without, `⌊iR/n⌋`: the shards
//! of one `n` follow each other, none overlaps, none is left out, and their sizes differ by one at most. Where `n`
//! exceeds `R` some are empty. The same settings give the same shards on every machine.
//!
//! **Binding.** [`Binding`] is what a shard's file says of itself: the whole table's quantity, axes and number of rows,
//! and its own place in it. Together with the head of the table, which names formula, rounding and version, it tells the
//! shards of one table from all others.

use super::grid::{Grid, GridError};
use super::{Plan, Printing, Quantity, TableError};
use crate::number::decimal::{Digits, Rounding};
use std::fmt;
use std::ops::Range;

/// Which part of how many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    part: u64,
    of: u64,
}

/// Why a text names no shard.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ShardError {
    /// It is not `i/n`.
    Shape,
    /// `i` is not from 1 to `n`.
    Range,
}

impl fmt::Display for ShardError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shape => write!(f, "write I/N, such as 3/8 for the third of eight parts"),
            Self::Range => write!(f, "in I/N, I must lie from 1 to N"),
        }
    }
}

impl std::error::Error for ShardError {}

impl Shard {
    /// Reads `i/n`.
    ///
    /// ```
    /// use carom_physics::table::shard::Shard;
    /// let shard = Shard::parse("2/3").unwrap();
    /// assert_eq!((shard.part(), shard.of(), shard.rows(10)), (2, 3, 3..6));
    /// assert!(Shard::parse("0/3").is_err() && Shard::parse("4/3").is_err() && Shard::parse("+1/3").is_err());
    /// ```
    ///
    /// # Errors
    /// [`ShardError`].
    pub fn parse(text: &str) -> Result<Shard, ShardError> {
        let number = |text: &str| {
            let digits = !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
            digits.then(|| text.parse::<u64>().ok()).flatten().ok_or(ShardError::Shape)
        };
        let (part, of) = text.split_once('/').ok_or(ShardError::Shape)?;
        let (part, of) = (number(part)?, number(of)?);
        if part == 0 || part > of { Err(ShardError::Range) } else { Ok(Shard { part, of }) }
    }

    /// Which part, from 1.
    #[must_use]
    pub fn part(self) -> u64 {
        self.part
    }

    /// Of how many.
    #[must_use]
    pub fn of(self) -> u64 {
        self.of
    }

    /// Its rows among so many, from 0.
    #[must_use]
    pub fn rows(self, rows: u64) -> Range<u64> {
        // A product of two words fits into two, and the quotient is at most `rows`.
        let end = |part: u64| u64::try_from(u128::from(part) * u128::from(rows) / u128::from(self.of)).unwrap_or(rows);
        end(self.part - 1)..end(self.part)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.part, self.of)
    }
}

/// What a shard's file says of the table it is a part of, and of its place there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    /// The whole table: quantity, number of rows, axes.
    pub table: String,
    /// The part, and its rows.
    pub shard: String,
}

/// The axes of a table as they were given.
#[derive(Clone, Copy, Debug)]
pub struct Axes<'a> {
    /// The grid of ratios.
    pub ratio: &'a str,
    /// The grid of restitutions.
    pub e: Option<&'a str>,
    /// The grid of numbers.
    pub n: Option<&'a str>,
}

impl Binding {
    /// The lines for a shard of a plan.
    #[must_use]
    pub fn new(plan: &Plan, axes: Axes<'_>, shard: Shard) -> Binding {
        let mut table = format!("{}; {} rows", plan.quantity().name(), plan.rows());
        for (name, grid) in [("ratio", Some(axes.ratio)), ("e", axes.e), ("n", axes.n)] {
            if let Some(grid) = grid {
                // Spaces mean nothing in a grid, and a line break would end the line.
                let text: String = grid.chars().filter(|c| !c.is_whitespace()).collect();
                table.push_str(&format!("; {name} {text}"));
            }
        }
        Binding { table, shard: range(shard, plan.rows()) }
    }

    /// The shard and the plan that the lines describe, read back; digits and rounding, which they do not name, are
    /// arbitrary.
    ///
    /// # Errors
    /// What does not fit together, in words.
    pub fn read(&self) -> Result<(Plan, Shard), String> {
        let mut parts = self.table.split("; ");
        let named = |text: &str, name: &str| text.strip_prefix(name).map(str::to_owned);
        let quantity = parts.next().and_then(|name| Quantity::ALL.into_iter().find(|q| q.name() == name));
        let quantity = quantity.ok_or("its quantity is not known")?;
        let rows = parts.next().and_then(|text| text.strip_suffix(" rows")).ok_or("its number of rows is missing")?;
        let (mut ratio, mut e, mut n) = (None, None, None);
        for part in parts {
            let place = [("ratio ", &mut ratio), ("e ", &mut e), ("n ", &mut n)]
                .into_iter()
                .find_map(|(name, slot)| Some((slot, named(part, name)?)));
            let (slot, text) = place.ok_or_else(|| format!("{part:?} names no axis"))?;
            *slot = Some(Grid::parse(&text).map_err(|error: GridError| format!("{part}: {error}"))?);
        }
        let printing = Printing { digits: Digits::Significant(1), rounding: Rounding::Nearest, extra: 0 };
        let ratio = ratio.ok_or("its axis of ratios is missing")?;
        let plan = Plan::new(quantity, ratio, e, n, printing).map_err(|error: TableError| error.to_string())?;
        if plan.rows().to_string() != rows {
            return Err(format!("its axes make {} rows, not {rows}", plan.rows()));
        }
        let shard = self.shard.split_once(',').and_then(|(shard, _)| Shard::parse(shard).ok());
        match shard {
            Some(shard) if range(shard, plan.rows()) == self.shard => Ok((plan, shard)),
            _ => Err(format!("{:?} is no part of {} rows", self.shard, plan.rows())),
        }
    }
}

/// `2/3, rows 4 to 6 of 10`, counted from 1.
fn range(shard: Shard, rows: u64) -> String {
    let found = shard.rows(rows);
    if found.is_empty() {
        return format!("{shard}, no rows of {rows}");
    }
    format!("{shard}, rows {} to {} of {rows}", found.start + 1, found.end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shards_of_one_number_share_the_rows_among_them() {
        for rows in (0..40).chain([999, 1000, u64::MAX - 1, u64::MAX]) {
            for of in (1..25).chain([u64::MAX].into_iter().filter(|_| rows > 0)) {
                let parts: Vec<u64> = if of < 25 { (1..=of).collect() } else { vec![1, of / 2, of / 2 + 1, of] };
                let mut before = 0..0;
                for part in parts {
                    let here = Shard { part, of }.rows(rows);
                    assert!(here.start <= here.end && here.end <= rows);
                    assert!(here.end - here.start == rows / of || here.end - here.start == rows / of + 1);
                    if of < 25 || part == of / 2 + 1 {
                        assert_eq!(here.start, before.end, "{part}/{of} of {rows}");
                    }
                    before = here;
                }
                assert_eq!((Shard { part: 1, of }.rows(rows).start, before.end), (0, rows));
            }
        }
    }

    #[test]
    fn a_binding_reads_back_and_lies_are_seen() {
        let grid = |text: &str| Grid::parse(text).expect(text);
        let printing = Printing { digits: Digits::Significant(6), rounding: Rounding::Up, extra: 0 };
        let (ratio, e) = ("1, 2,1/3", "0:1:0.25");
        let plan = Plan::new(Quantity::BestN, grid(ratio), Some(grid(e)), None, printing).expect("a plan");
        let shard = Shard { part: 2, of: 4 };
        let binding = Binding::new(&plan, Axes { ratio, e: Some(e), n: None }, shard);
        assert_eq!(binding.table, "best-n; 15 rows; ratio 1,2,1/3; e 0:1:0.25");
        assert_eq!(binding.shard, "2/4, rows 4 to 7 of 15");
        let (found, at) = binding.read().expect("it is right");
        assert_eq!((found.rows(), found.labels(14), at), (15, plan.labels(14), shard));
        let with = |from: &str, to: &str| Binding {
            table: binding.table.replace(from, to),
            shard: binding.shard.replace(from, to),
        };
        for (from, to, sign) in [
            ("15 rows", "16 rows", "15 rows, not 16"),
            ("best-n", "worst-n", "quantity"),
            ("ratio", "ration", "names no axis"),
            ("; e 0:1:0.25", "", "depends on e"),
            ("2/4", "5/4", "no part"),
            ("4 to 7", "4 to 8", "no part"),
            ("0.25", "zero", "\"zero\""),
        ] {
            let fault = with(from, to).read().map(|_| ()).expect_err(to);
            assert!(fault.contains(sign), "{to}: {fault}");
        }
    }
}
