//! Tables re-checked: every row of a table's certificate, with nothing but the file and integers.
//!
//! Contract: [`Checker::finish`] returns [`AcceptedTable`] only if the file is the whole table that its head describes, and
//! every number printed in it is the value of the quantity at its place, rounded as the head says. Lines are given
//! one at a time; memory does not grow with their number.
//!
//! **What is shown of a row.** Each rule is a function:
//! - `Axes::matches`: the row stands at the place of the grid that its number says. Rows follow one another from 0, and
//!   the head's axes say how many there are: none is left out, none is there twice.
//! - `exact_cell`, `enclosed_cell`: the value lies in the enclosure; the printed digits follow.
//! - `best_cell`: the number of bodies, by two comparisons. This rests on the claims `b-grow`, that `L_n` rises with `n`,
//!   and `b-grow-bounded`, that it stays below 1, which have certificates of their own; an acceptance says so.
//!
//! **What is assumed.** The formulas of `value`, which the head repeats in words. That other numbers are irrational is
//! not assumed: what is not known exactly is enclosed, and an enclosure decides or a limit is reached.

mod axes;
mod cell;
pub(crate) mod dyadic;
mod failure;
mod remarks;
pub(crate) mod root;
pub(crate) mod rounding;
pub mod text;
pub(crate) mod value;
pub(crate) mod work;

pub use failure::Failure;

use axes::{Axes, Axis};
use cell::{best_cell, enclosed_cell, exact_cell};
use dyadic::Interval;
use failure::rejected;
use remarks::{formula, remarks, rounding_in_words};
use std::cmp::Ordering;
use text::{Head, Quantity, Row};
use value::{Cell, Form};
use work::Work;

/// A table that was shown. Only the checker makes one.
#[derive(Clone, Debug)]
pub struct AcceptedTable {
    rows: u64,
    statement: String,
    rests_on: &'static [&'static str],
}

impl AcceptedTable {
    /// How many rows it has.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// What was shown, as the kernel understood it.
    pub fn text(&self) -> &str {
        &self.statement
    }

    /// The claims that it rests on.
    pub fn rests_on(&self) -> &'static [&'static str] {
        self.rests_on
    }
}

/// Checks one table, line by line.
#[derive(Clone, Debug)]
pub struct Checker {
    head: Head,
    axes: Axes,
    next: u64,
    work: Work,
}

impl Checker {
    /// Begins with the head.
    ///
    /// What it says in words about the formula and the rounding has to be what the kernel says of the same; the remarks
    /// `further` and `program` say nothing that a row depends on.
    pub fn new(line: &str) -> Result<Checker, Failure> {
        let work = Work::default();
        work.read(line.len());
        let head = text::head(line, &work)?;
        let axes = Axes::of(&head)?;
        let wanted = remarks(&head)?;
        if head.remarks.iter().filter(|(name, _)| name == "further").count() > 1 {
            return rejected("the head has two remarks called `further`");
        }
        let mut given = head.remarks.iter().filter(|(name, _)| name != "further");
        for (name, text) in &wanted {
            match given.next() {
                Some((found, said)) if found == name && said == text => {}
                _ => return rejected(&format!("the head lacks the remark {name:?}: {text:?}")),
            }
        }
        if !given.map(|(name, _)| name.as_str()).eq(["program"]) {
            return rejected("the last remark of the head must name the program");
        }
        Ok(Checker { head, axes, next: 0, work })
    }

    /// The place of the next row in words.
    pub fn place(&self) -> String {
        let axes: Vec<String> = self.axes.0.iter().map(|axis| format!("{} {}", axis.name, axis.text)).collect();
        format!("row {}, {}", self.next, axes.join(", "))
    }

    /// Checks the next row.
    pub fn row(&mut self, line: &str) -> Result<(), Failure> {
        if self.next >= self.head.rows {
            return rejected(&format!("the table has {} rows, and the file has more", self.head.rows));
        }
        self.work.read(line.len());
        let row = text::row(line)?;
        if row.row != self.next {
            return rejected(&format!("found row {}, expected row {}", row.row, self.next));
        }
        self.axes.matches(&row)?;
        let ratio = self.axes.ratio()?;
        match self.head.quantity {
            Quantity::BestN => best_cell(&row, ratio, &self.axes.restitution()?, &self.work)?,
            Quantity::Eta => {
                let cell = Cell::Eta(ratio, self.axes.restitution()?, self.axes.inserted(0)? + 1u32);
                self.real(&row, &cell)?;
            }
            Quantity::Threshold => self.real(&row, &Cell::Threshold(ratio, self.axes.inserted(1)?))?,
        }
        self.next += 1;
        self.axes.advance(&self.work)
    }

    fn real(&self, row: &Row<'_>, cell: &Cell) -> Result<(), Failure> {
        let (Some(digits), Some(rounding)) = (self.head.digits, self.head.rounding) else {
            return rejected("the head must give digits and rounding");
        };
        if row.tie.is_some() {
            return rejected("only a number of bodies can be a tie");
        }
        let (Some(lower), Some(upper)) = (&row.lower, &row.upper) else { return rejected("the enclosure is missing") };
        let enclosure = Interval { lo: lower.clone(), hi: upper.clone() };
        if enclosure.lo.compare(&enclosure.hi)? == Ordering::Greater {
            return rejected("the enclosure is empty");
        }
        match cell.form(&self.work)? {
            Form::Exact(value) => exact_cell(row, &value, &enclosure, digits, rounding, &self.work),
            form => enclosed_cell(row, cell, matches!(form, Form::Long), &enclosure, digits, rounding, &self.work),
        }
    }

    /// The table, if all its rows were there.
    pub fn finish(self) -> Result<AcceptedTable, Failure> {
        if self.next != self.head.rows {
            return rejected(&format!("the file ends after {} of {} rows", self.next, self.head.rows));
        }
        let axes: String = self.axes.0.iter().map(Axis::described).collect();
        let rounding = rounding_in_words(&self.head)?.map(|words| words + "\n").unwrap_or_default();
        let statement = format!("{}\n{axes}{rounding}", formula(self.head.quantity).0);
        let rests_on: &[&str] = if self.head.quantity == Quantity::BestN { &["b-grow", "b-grow-bounded"] } else { &[] };
        Ok(AcceptedTable { rows: self.next, statement, rests_on })
    }
}
