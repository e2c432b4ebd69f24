//! Somebody's whole table beside the certified values, cell by cell.
//!
//! **Contract.** Every cell of a column `eta`, `threshold` or `best-n` is judged as [`super::check`] says, at the mass ratio,
//! restitution and number of bodies of its row. A value that has no column may be given once for all rows. Rows are read one
//! at a time.

use super::check::{Agreement, Judgement, judge};
use super::foreign::{Fields, Foreign, ForeignError, Role};
use super::grid::{Grid, beyond_limits};
use super::{Place, Quantity};
use crate::chain::{ChainError, MAX_INSERTED, Positive, Restitution};
use crate::number::decimal::Rounding;
use crate::number::{NumberError, typed};
use malachite::Rational;
use std::fmt;
use std::io::BufRead;

/// Values for columns that the table does not have: one each.
#[derive(Clone, Debug)]
pub struct Given {
    /// The mass ratio.
    pub ratio: Option<Grid>,
    /// The restitution.
    pub e: Option<Grid>,
    /// The number of inserted bodies.
    pub n: Option<Grid>,
    /// What messages call the three: flags or fields.
    pub names: [&'static str; 3],
}

/// Why a table cannot be judged.
#[derive(Debug)]
pub enum ComparisonError {
    /// It is no table.
    Table(ForeignError),
    /// Its columns do not say where the values belong.
    Columns(String),
    /// What a row says is no chain.
    Row {
        /// Its line, from 1.
        line: u64,
        /// What is wrong.
        what: String,
    },
    /// A stated limit, in a row.
    Limit {
        /// Its line, from 1.
        line: u64,
        /// Which.
        what: String,
    },
}

impl fmt::Display for ComparisonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Table(error) => write!(f, "{error}"),
            Self::Columns(what) => write!(f, "{what}"),
            Self::Row { line, what } | Self::Limit { line, what } => write!(f, "line {line}: {what}"),
        }
    }
}

impl std::error::Error for ComparisonError {}

impl ComparisonError {
    /// Whether a stated limit is the reason.
    #[must_use]
    pub fn is_limit(&self) -> bool {
        match self {
            Self::Table(error) => error.is_limit(),
            Self::Limit { .. } => true,
            Self::Columns(_) | Self::Row { .. } => false,
        }
    }
}

/// A cell beside the certified value.
#[derive(Clone, Debug)]
pub struct Judged {
    /// Its line, from 1.
    pub line: u64,
    /// The mass ratio.
    pub ratio: Option<Rational>,
    /// The restitution, where the quantity depends on it.
    pub e: Option<Rational>,
    /// The number of inserted bodies, where the quantity depends on it.
    pub n: Option<Rational>,
    /// The quantity.
    pub quantity: Quantity,
    /// The cell.
    pub written: String,
    /// What is to be said; `None` for an empty cell where there is a value.
    pub judgement: Option<Judgement>,
}

/// Counts of cells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Right.
    pub right: usize,
    /// Right, if it were rounded in another direction.
    pub rounded: usize,
    /// Wrong.
    pub wrong: usize,
    /// Not numbers.
    pub unreadable: usize,
    /// Empty.
    pub empty: usize,
}

impl Tally {
    /// Counts a cell.
    pub fn count(&mut self, cell: &Judged) {
        match cell.judgement.as_ref().map(|judgement| &judgement.agreement) {
            Some(Agreement::Right) => self.right += 1,
            Some(Agreement::Rounded(_)) => self.rounded += 1,
            Some(Agreement::Wrong(_)) => self.wrong += 1,
            Some(Agreement::Unreadable(_)) => self.unreadable += 1,
            None => self.empty += 1,
        }
    }

    /// The cells that were judged: all but empty ones.
    #[must_use]
    pub fn judged(&self) -> usize {
        self.right + self.rounded + self.wrong + self.unreadable
    }
}

/// Where a value of an axis comes from.
enum From {
    /// A column.
    Column(usize),
    /// Two columns, divided.
    Quotient(usize, usize),
    /// Given for all rows.
    Fixed(Rational),
    /// Nowhere.
    Nowhere,
}

/// Where everything comes from.
struct Places {
    ratio: From,
    e: From,
    n: From,
    values: Vec<(usize, Quantity)>,
}

impl Places {
    fn of<R: BufRead>(table: &Foreign<R>, given: &Given) -> Result<Places, String> {
        let values: Vec<(usize, Quantity)> = table
            .roles
            .iter()
            .filter_map(|(column, role)| match role {
                Role::Value(quantity) => Some((*column, *quantity)),
                _ => None,
            })
            .collect();
        if values.is_empty() {
            return Err("there is no column to check: name a column eta, threshold or best-n".to_owned());
        }
        let [ratio_name, e_name, n_name] = given.names;
        let from = |role: Role, name: &str, grid: &Option<Grid>| -> Result<From, String> {
            match (table.column(role), grid) {
                (Some(_), Some(_)) => Err(format!("{name} is given twice: the table has a column for it")),
                (Some(column), None) => Ok(From::Column(column)),
                (None, Some(grid)) if grid.len() == 1 => Ok(grid.value(0).map_or(From::Nowhere, From::Fixed)),
                (None, Some(_)) => Err(format!("{name} takes one value, for all rows of the table")),
                (None, None) => Ok(From::Nowhere),
            }
        };
        let mut ratio = from(Role::Ratio, ratio_name, &given.ratio)?;
        if let (Some(first), Some(last)) = (table.column(Role::First), table.column(Role::Last)) {
            if !matches!(ratio, From::Nowhere) {
                let other = if given.ratio.is_some() {
                    format!("by {ratio_name}")
                } else {
                    "in a column of its own".to_owned()
                };
                return Err(format!("the mass ratio is given twice: by the columns m1 and m2, and {other}"));
            }
            ratio = From::Quotient(first, last);
        }
        let (e, n) = (from(Role::E, e_name, &given.e)?, from(Role::N, n_name, &given.n)?);
        let lacks = |from: &From, needed: bool| needed && matches!(from, From::Nowhere);
        let needs_e = values.iter().any(|v| v.1.needs_e());
        let needs_n = values.iter().any(|v| v.1.needs_n());
        for (lacking, column, name) in [
            (lacks(&ratio, true), "ratio", ratio_name),
            (lacks(&e, needs_e), "e", e_name),
            (lacks(&n, needs_n), "n", n_name),
        ] {
            if lacking {
                return Err(format!("there is no column {column}: add one, or give the value with {name}"));
            }
        }
        Ok(Places { ratio, e, n, values })
    }
}

/// A table that is being judged.
pub struct Comparison<R> {
    table: Foreign<R>,
    places: Places,
}

impl<R: BufRead> Comparison<R> {
    /// Reads the heading.
    ///
    /// # Errors
    /// [`ComparisonError`].
    pub fn open(reader: R, given: &Given) -> Result<Comparison<R>, ComparisonError> {
        let table = Foreign::open(reader).map_err(ComparisonError::Table)?;
        let places = Places::of(&table, given).map_err(ComparisonError::Columns)?;
        Ok(Comparison { table, places })
    }

    /// The quantities that are judged, in the order of their columns.
    pub fn quantities(&self) -> impl Iterator<Item = Quantity> + '_ {
        self.places.values.iter().map(|value| value.1)
    }

    /// The cells of the next row; `None` after the last.
    ///
    /// # Errors
    /// [`ComparisonError`].
    pub fn row(&mut self, rounding: Rounding) -> Result<Option<Vec<Judged>>, ComparisonError> {
        let Some(row) = self.table.row().map_err(ComparisonError::Table)? else { return Ok(None) };
        let of = |(column, quantity): &(usize, Quantity)| cell(&row, *column, *quantity, &self.places, rounding);
        let cells = self.places.values.iter().map(of).collect::<Result<_, _>>().map_err(|failure| match failure {
            Failure::Input(what) => ComparisonError::Row { line: row.line, what },
            Failure::Limit(what) => ComparisonError::Limit { line: row.line, what },
        })?;
        Ok(Some(cells))
    }
}

/// Why a cell cannot be judged.
enum Failure {
    Input(String),
    Limit(String),
}

fn number(from: &From, row: &Fields) -> Result<Option<Rational>, Failure> {
    let at = |column: usize| {
        let text = row.fields.get(column).map_or("", String::as_str);
        typed::read(text).map_err(|e| match beyond_limits(&e) {
            Some(limit) => Failure::Limit(limit.to_string()),
            None => Failure::Input(format!("{text:?} is not a number: {e}")),
        })
    };
    Ok(match from {
        From::Column(column) => Some(at(*column)?),
        From::Quotient(first, last) => {
            let last = at(*last)?;
            if last == 0u32 {
                return Err(Failure::Input("m2 is 0; a mass must be above 0".to_owned()));
            }
            Some(at(*first)? / last)
        }
        From::Fixed(value) => Some(value.clone()),
        From::Nowhere => None,
    })
}

/// One cell judged.
fn cell(
    row: &Fields,
    column: usize,
    quantity: Quantity,
    places: &Places,
    rounding: Rounding,
) -> Result<Judged, Failure> {
    let input = |e: &dyn fmt::Display| Failure::Input(e.to_string());
    let (ratio, e, n) = (number(&places.ratio, row)?, number(&places.e, row)?, number(&places.n, row)?);
    let count = match &n {
        Some(n) if quantity.needs_n() => match u64::try_from(n) {
            Ok(n) => Some(n),
            Err(_) if *n > MAX_INSERTED && *n.denominator_ref() == 1u32 => {
                let what = format!("limit reached: inserted bodies: {MAX_INSERTED} allowed, {n} asked for");
                return Err(Failure::Limit(what));
            }
            Err(_) => return Err(input(&format!("n is a number of bodies, not {n}"))),
        },
        _ => None,
    };
    let place = Place {
        ratio: Positive::new(ratio.clone().unwrap_or_default()).map_err(|e| input(&e))?,
        e: match &e {
            Some(e) if quantity.needs_e() => Some(Restitution::new(e.clone()).map_err(|e| input(&e))?),
            _ => None,
        },
        n: count,
    };
    let written = row.fields.get(column).map_or("", String::as_str);
    let chain = |e: ChainError| match e {
        ChainError::Number(NumberError::LimitReached { .. }) => Failure::Limit(e.to_string()),
        e => Failure::Input(e.to_string()),
    };
    let found = judge(written, quantity, &place, rounding).map_err(chain)?;
    let judgement = Some(found).filter(|found| !written.is_empty() || found.agreement == Agreement::Right);
    Ok(Judged {
        line: row.line,
        ratio,
        e: e.filter(|_| quantity.needs_e()),
        n: n.filter(|_| quantity.needs_n()),
        quantity,
        written: written.to_owned(),
        judgement,
    })
}
