//! eta for rows of numbers: columns of `m1`, `m2`, `e` and `n`, as they stand in somebody's table.
//!
//! **Contract.** Every number of a column is exact: a whole number, a rational, a double taken as it is, or the decimal that
//! a double is printed as. [`Rows::etas`] encloses each row's eta between two doubles, at most `2^-50` apart relatively in the
//! ordinary range of [`super::fast`]. A row that is no chain is an error that names it.
//!
//! **Cost.** That of scattered cells (`fast::etas_of_two`) and of two quotients for each row; where words do not
//! suffice, that of [`super::transfer::optimal`].

use super::fast::{self, TwoDoubles, decimal_of};
use super::{ChainError, Positive, Restitution, Restitutions, transfer};
use malachite::Rational;
use std::fmt;

/// The numbers of a column.
#[derive(Clone, Debug)]
pub enum Column {
    /// The same number in each row.
    One(Rational),
    /// Whole numbers.
    Integers(Vec<i64>),
    /// Doubles, taken as the numbers that they are.
    Doubles(Vec<f64>),
    /// Doubles, taken as the decimals that they are printed as.
    Decimals(Vec<f64>),
    /// Rationals.
    Rationals(Vec<Rational>),
}

impl Column {
    /// How many there are, where the column does not fit any number of rows.
    fn len(&self) -> Option<usize> {
        match self {
            Self::One(_) => None,
            Self::Integers(list) => Some(list.len()),
            Self::Doubles(list) | Self::Decimals(list) => Some(list.len()),
            Self::Rationals(list) => Some(list.len()),
        }
    }

    /// The number of a row; `None` for what is no number.
    fn exact(&self, row: usize) -> Option<Rational> {
        match self {
            Self::One(x) => Some(x.clone()),
            Self::Integers(list) => list.get(row).copied().map(Rational::from),
            Self::Doubles(list) => Rational::try_from(*list.get(row)?).ok(),
            Self::Decimals(list) => decimal_of(*list.get(row)?),
            Self::Rationals(list) => list.get(row).cloned(),
        }
    }

    /// The numbers of some rows, each as two doubles.
    fn doubles(&self, rows: std::ops::Range<usize>) -> Vec<TwoDoubles> {
        fn each<T>(list: &[T], rows: std::ops::Range<usize>, of: impl Fn(&T) -> TwoDoubles) -> Vec<TwoDoubles> {
            list.get(rows).unwrap_or_default().iter().map(of).collect()
        }
        match self {
            Self::One(x) => vec![TwoDoubles::of_rational(x); rows.len()],
            Self::Integers(list) => each(list, rows, |x| TwoDoubles::of_integer(*x)),
            Self::Doubles(list) => each(list, rows, |x| TwoDoubles::exact(*x)),
            Self::Decimals(list) => each(list, rows, |x| TwoDoubles::of_decimal(*x)),
            Self::Rationals(list) => each(list, rows, TwoDoubles::of_rational),
        }
    }
}

/// Numbers of inserted bodies.
#[derive(Clone, Debug)]
pub enum Counts {
    /// The same in each row.
    One(u64),
    /// One for each row.
    Each(Vec<u64>),
}

impl Counts {
    fn at(&self, row: usize) -> u64 {
        match self {
            Self::One(n) => *n,
            Self::Each(list) => list.get(row).copied().unwrap_or(0),
        }
    }
}

/// Why there is no eta for a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RowError {
    /// The row, counted from 0.
    pub row: usize,
    /// The column.
    pub column: &'static str,
    /// What is wrong; `None` where a double is no number.
    pub error: Option<ChainError>,
}

impl fmt::Display for RowError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "row {}: {}: ", self.row, self.column)?;
        match &self.error {
            Some(error) => write!(f, "{error}"),
            None => write!(f, "a finite number is expected"),
        }
    }
}

impl std::error::Error for RowError {}

/// Columns of equal length.
#[derive(Clone, Debug)]
pub struct Rows {
    m1: Column,
    m2: Column,
    e: Column,
    n: Counts,
    count: usize,
}

impl Rows {
    /// Rows of the masses of both ends, the coefficient of restitution and the number of inserted bodies of optimal mass.
    ///
    /// # Errors
    /// [`ChainError::Count`] where columns are not equally long.
    pub fn new(m1: Column, m2: Column, e: Column, n: Counts) -> Result<Rows, ChainError> {
        let of_n = if let Counts::Each(list) = &n { Some(list.len()) } else { None };
        let lengths = [m1.len(), m2.len(), e.len(), of_n];
        let count = lengths.iter().flatten().copied().max().unwrap_or(1);
        if let Some(other) = lengths.iter().flatten().find(|length| **length != count) {
            return Err(ChainError::Count { of: "numbers of a column", given: *other as u64, needed: count as u64 });
        }
        Ok(Rows { m1, m2, e, n, count })
    }

    /// How many rows there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// The enclosures of eta of the rows from one up to another.
    ///
    /// # Errors
    /// [`RowError`] for the first row that is no chain, or where a limit is reached.
    pub fn etas(&self, rows: std::ops::Range<usize>) -> Result<Vec<(f64, f64)>, RowError> {
        let rows = rows.start.min(self.count)..rows.end.min(self.count);
        let masses = [&self.m1, &self.m2].map(|column| column.doubles(rows.clone()));
        let [m1, m2] = &masses;
        let ratios: Vec<TwoDoubles> = m1.iter().zip(m2).map(|(a, b)| a.over(*b)).collect();
        let (e, r) = (parts(&self.e.doubles(rows.clone())), parts(&ratios));
        let collisions: Vec<u64> = rows.clone().map(|row| self.n.at(row).saturating_add(1)).collect();
        let mut out = vec![(f64::NAN, f64::NAN); rows.len()];
        fast::etas_of_two([&e.0, &e.1], [&r.0, &r.1], &collisions, &mut out);
        for (row, ends) in rows.zip(&mut out) {
            if ends.0.is_nan() {
                *ends = self.careful(row)?;
            }
        }
        Ok(out)
    }

    /// A row by exact numbers and intervals.
    #[cold]
    fn careful(&self, row: usize) -> Result<(f64, f64), RowError> {
        let fault = |column, error| RowError { row, column, error };
        let exact = |name, column: &Column| column.exact(row).ok_or(fault(name, None));
        let mass = |name, column| Positive::new(exact(name, column)?).map_err(|error| fault(name, Some(error)));
        let (m1, m2) = (mass("m1", &self.m1)?, mass("m2", &self.m2)?);
        let e = Restitution::new(exact("e", &self.e)?).map_err(|error| fault("e", Some(error)))?;
        let of = || {
            transfer::optimal(&m1.over(&m2), &Restitutions::Same(e), self.n.at(row))?.neighbours().map_err(Into::into)
        };
        of().map_err(|error: ChainError| fault("n", Some(error)))
    }
}

/// The first parts and the second parts.
fn parts(list: &[TwoDoubles]) -> (Vec<f64>, Vec<f64>) {
    list.iter().map(|x| (x.high, x.low)).unzip()
}

#[cfg(test)]
mod tests {
    use super::super::fast::MAX_COLLISIONS;
    use super::*;
    use crate::number::rational::parse;
    use proptest::prelude::*;

    /// Whether the ends are around the exact eta of a row, and how far apart they are.
    fn judged(rows: &Rows, row: usize, (lo, hi): (f64, f64)) -> (bool, f64) {
        let number = |column: &Column| column.exact(row).expect("a number");
        let r = Positive::new(number(&rows.m1) / number(&rows.m2)).expect("positive");
        let e = Restitution::new(number(&rows.e)).expect("a coefficient");
        let eta = transfer::optimal(&r, &Restitutions::Same(e), rows.n.at(row)).expect("an answer");
        let inside = eta.settle(200, |x| {
            let (below, above) = x.ends().expect("finite");
            let ends = [lo, hi].map(|end| Rational::try_from(end).expect("finite"));
            Some(ends[0] <= above.point().expect("an end") && below.point().expect("an end") <= ends[1])
        });
        (inside.expect("an answer").0, (hi - lo) / lo)
    }

    proptest! {
        /// Numbers that are no doubles, in each kind of column: eta lies between the ends, which are as near as doubles'.
        #[test]
        fn eta_of_a_row_lies_between_its_ends(
            masses in prop::collection::vec((1..1_000_000_i64, 1..1_000_000_i64, 0..=1_000_000_u64, 0..70_000_u64), 1..20),
            scale in 0..4_usize,
        ) {
            let n: Vec<u64> = masses.iter().map(|row| row.3 % [5, 40, 300, 70_000][scale]).collect();
            let coefficients = |k: u64| k as f64 / 1e6;
            let e = masses.iter().map(|row| 1.0 - (1.0 - coefficients(row.2)) / (1 + row.3 / 10) as f64);
            let e: Vec<f64> = e.map(|e| (e * 1e12).round() / 1e12).collect();
            let column = |of: fn(&(i64, i64, u64, u64)) -> i64| masses.iter().map(of).collect::<Vec<_>>();
            let thirds = |list: Vec<i64>| list.into_iter().map(|x| Rational::from(x) / Rational::from(3)).collect();
            let tenths = |list: Vec<i64>| list.into_iter().map(|x| x as f64 / 10.0).collect();
            for (m1, m2) in [
                (Column::Integers(column(|row| row.0)), Column::Rationals(thirds(column(|row| row.1)))),
                (Column::Decimals(tenths(column(|row| row.0))), Column::One(parse("0.7").expect("a number"))),
                (Column::Doubles(tenths(column(|row| row.0))), Column::Integers(column(|row| row.1))),
            ] {
                let rows = Rows::new(m1, m2, Column::Decimals(e.clone()), Counts::Each(n.clone())).expect("equally long");
                for (row, ends) in rows.etas(0..rows.count()).expect("chains").into_iter().enumerate() {
                    let (inside, width) = judged(&rows, row, ends);
                    prop_assert!(inside, "row {} of {:?}: {:?}", row, rows, ends);
                    prop_assert!(width <= 2f64.powi(-50) || ends.0 < 1e-100, "row {} of {:?}: {:?}", row, rows, ends);
                }
            }
        }
    }

    #[test]
    fn a_row_that_is_no_chain_is_named_with_its_column() {
        let one = |text| Column::One(parse(text).expect("a number"));
        let wrong = |m1, e: Column| {
            let rows = Rows::new(m1, one("1"), e, Counts::One(2)).expect("equally long");
            rows.etas(0..rows.count()).expect_err("no chain").to_string()
        };
        assert_eq!(wrong(Column::Integers(vec![3, 0]), one("1/2")), "row 1: m1: a mass must be above 0, not 0");
        assert!(wrong(one("3"), Column::Doubles(vec![0.5, f64::NAN])).starts_with("row 1: e: a finite number"));
        // A hair above 1: the nearest double is 1 itself.
        let above = parse("1.00000000000000000000000000000001").expect("a number");
        assert!(wrong(one("3"), Column::Rationals(vec![above])).starts_with("row 0: e: "));
        assert!(Rows::new(Column::Integers(vec![1]), Column::Integers(vec![1, 2]), one("1"), Counts::One(0)).is_err());
    }

    #[test]
    fn rows_beyond_words_are_enclosed_all_the_same() {
        let m1 = Column::Rationals(vec![parse("1e300").expect("a number"), parse("1e-300").expect("a number")]);
        let n = Counts::Each(vec![3, MAX_COLLISIONS + 5]);
        let rows = Rows::new(m1, Column::One(Rational::from(7)), Column::One(Rational::from(1)), n).expect("rows");
        for (row, ends) in rows.etas(0..2).expect("chains").into_iter().enumerate() {
            let (inside, width) = judged(&rows, row, ends);
            assert!(inside && width < 1e-15, "{row}: {ends:?}");
        }
    }
}
