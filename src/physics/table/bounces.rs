//! A class's measurements of bounces as a table: which reading comes from which line.
//!
//! Contract: [`Measurements::read`] reads a column `height` or `time`, perhaps with a column `run`, or the columns `drop` and
//! `bounce`; [`Measurements::of_lists`] takes lists. A reading has its own uncertainty, as in `0.86 ± 0.01`, or the one that all
//! share. What they say about `e`, [`crate::chain::bounces`] tells.

use super::foreign::{Foreign, ForeignError};
use crate::chain::bounces::{Estimate, Kind, Pair, restitution};
use crate::chain::uncertain::Range;
use crate::chain::{ChainError, Positive};
use crate::number::NumberError;
use std::fmt;

/// A reading as it was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reading {
    /// Its line, from 1; of a list its place.
    pub line: u64,
    /// Its text.
    pub text: String,
}

/// Measurements, and where each comes from.
#[derive(Clone, Debug)]
pub struct Measurements {
    /// What was read.
    pub kind: Kind,
    /// The readings of each run, in order.
    pub runs: Vec<Vec<Range<Positive>>>,
    /// The same as they were written.
    pub places: Vec<Vec<Reading>>,
    /// What [`Reading::line`] counts.
    pub counted_in: &'static str,
}

/// Why measurements cannot be used.
#[derive(Debug)]
pub enum MeasurementError {
    /// The file is no table.
    Table(ForeignError),
    /// Heights and times in one file.
    BothKinds,
    /// No column has readings; these columns are there.
    NoColumn(Vec<String>),
    /// The uncertainty that all share is none.
    Within {
        /// Its text.
        text: String,
        /// Why.
        reason: String,
    },
    /// A reading is none.
    Reading {
        /// Its line.
        line: u64,
        /// Its text.
        text: String,
        /// Why.
        reason: String,
    },
    /// They tell nothing, or a limit is reached.
    Chain(ChainError),
}

impl fmt::Display for MeasurementError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Table(ForeignError::Empty) => write!(f, "the file has no heading; write for instance: height"),
            Self::Table(error) => write!(f, "{error}"),
            Self::BothKinds => write!(f, "the file has heights and times; keep only one of the two columns"),
            Self::NoColumn(names) => {
                write!(
                    f,
                    "expected a column height, a column time, or two columns drop and bounce; the columns are {}",
                    names.join(", ")
                )
            }
            Self::Within { text, reason } => {
                write!(f, "within {text}: {reason}; write for instance 0.01 or \"2 %\"")
            }
            Self::Reading { text, reason, .. } => write!(f, "{text:?}: {reason}"),
            Self::Chain(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for MeasurementError {}

impl MeasurementError {
    /// Whether a stated limit is the reason.
    #[must_use]
    pub fn is_limit(&self) -> bool {
        match self {
            Self::Table(error) => error.is_limit(),
            Self::Chain(error) => matches!(error, ChainError::Number(NumberError::LimitReached { .. })),
            _ => false,
        }
    }
}

/// Which columns hold what.
enum Columns {
    /// Readings, and the run of each where that is told.
    Readings(Kind, usize, Option<usize>),
    /// The height of the fall, and of the bounce.
    Bounce(usize, usize),
}

fn columns(names: &[String]) -> Result<Columns, MeasurementError> {
    let place = |wanted: &[&str]| names.iter().position(|name| wanted.contains(&name.to_lowercase().as_str()));
    let (drop, bounce) = (place(&["drop", "fall", "from"]), place(&["bounce", "rebound", "to"]));
    if let (Some(drop), Some(bounce)) = (drop, bounce) {
        return Ok(Columns::Bounce(drop, bounce));
    }
    let run = place(&["run", "ball", "try"]);
    match (place(&["height", "heights", "h"]), place(&["time", "times", "t"])) {
        (Some(height), None) => Ok(Columns::Readings(Kind::Heights, height, run)),
        (None, Some(time)) => Ok(Columns::Readings(Kind::Times, time, run)),
        (Some(_), Some(_)) => Err(MeasurementError::BothKinds),
        (None, None) => Err(MeasurementError::NoColumn(names.to_vec())),
    }
}

/// A reading, with the uncertainty of its own or the one that all share.
fn measured(text: &str, within: Option<&str>) -> Result<Range<Positive>, String> {
    let own = ["±", "+-", "+/-", "(", "["].iter().any(|sign| text.contains(sign));
    let whole = match within {
        Some(within) if !own => format!("{text} ± {within}"),
        _ => text.to_owned(),
    };
    let range = Range::read(&whole).map_err(|e| e.to_string())?;
    range.map(Positive::new).map_err(|_| "a reading must be above 0, for every value within its uncertainty".to_owned())
}

fn reading(line: u64, text: &str, within: Option<&str>) -> Result<(Range<Positive>, Reading), MeasurementError> {
    let text = text.to_owned();
    match measured(&text, within) {
        Ok(range) => Ok((range, Reading { line, text })),
        Err(reason) => Err(MeasurementError::Reading { line, text, reason }),
    }
}

fn check_within(within: Option<&str>) -> Result<(), MeasurementError> {
    let Some(text) = within else { return Ok(()) };
    match Range::read(&format!("1 ± {text}")) {
        Ok(_) => Ok(()),
        Err(error) => Err(MeasurementError::Within { text: text.to_owned(), reason: error.to_string() }),
    }
}

impl Measurements {
    fn new(kind: Kind, counted_in: &'static str) -> Measurements {
        Measurements { kind, runs: Vec::new(), places: Vec::new(), counted_in }
    }

    fn push(&mut self, run: usize, (range, place): (Range<Positive>, Reading)) {
        if run == self.runs.len() {
            self.runs.push(Vec::new());
            self.places.push(Vec::new());
        }
        self.runs[run].push(range);
        self.places[run].push(place);
    }

    /// Reads a table; `within` is the uncertainty of readings that have none of their own, as `0.01` or `2 %`.
    ///
    /// # Errors
    /// [`MeasurementError`].
    pub fn read(bytes: &[u8], within: Option<&str>) -> Result<Measurements, MeasurementError> {
        check_within(within)?;
        let mut table = Foreign::open(bytes).map_err(MeasurementError::Table)?;
        let columns = columns(&table.names)?;
        let kind = if let Columns::Readings(kind, ..) = columns { kind } else { Kind::Heights };
        let mut found = Measurements::new(kind, "line");
        let mut names: Vec<String> = Vec::new();
        while let Some(row) = table.row().map_err(MeasurementError::Table)? {
            let reading = |place: usize| reading(row.line, row.fields.get(place).map_or("", String::as_str), within);
            match columns {
                Columns::Bounce(drop, bounce) => {
                    let (run, both) = (found.runs.len(), [reading(drop)?, reading(bounce)?]);
                    both.into_iter().for_each(|one| found.push(run, one));
                }
                Columns::Readings(_, place, run) => {
                    let name = run.and_then(|run| row.fields.get(run)).cloned().unwrap_or_default();
                    let at = names.iter().position(|known| *known == name).unwrap_or_else(|| {
                        names.push(name);
                        names.len() - 1
                    });
                    found.push(at, reading(place)?);
                }
            }
        }
        Ok(found)
    }

    /// Takes the readings of one ball after the other.
    ///
    /// # Errors
    /// [`MeasurementError`].
    pub fn of_lists(kind: Kind, runs: &[Vec<String>], within: Option<&str>) -> Result<Measurements, MeasurementError> {
        check_within(within)?;
        let mut found = Measurements::new(kind, "reading");
        let mut line = 0;
        for (run, texts) in runs.iter().enumerate() {
            for text in texts {
                line += 1;
                found.push(run, reading(line, text, within)?);
            }
        }
        Ok(found)
    }

    /// How many readings there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.runs.iter().map(Vec::len).sum()
    }

    /// What they say about `e`.
    ///
    /// # Errors
    /// [`MeasurementError::Chain`].
    pub fn estimate(&self) -> Result<Estimate, MeasurementError> {
        restitution(&self.runs, self.kind).map_err(MeasurementError::Chain)
    }

    /// The two readings of a pair.
    #[must_use]
    pub fn pair(&self, pair: Option<Pair>) -> Option<[&Reading; 2]> {
        let Pair { run, earlier, later } = pair?;
        let run = self.places.get(run)?;
        Some([run.get(earlier)?, run.get(later)?])
    }

    /// `lines 2 and 3 (1.20, 0.86)`, and nothing for the bound 1 itself.
    #[must_use]
    pub fn named(&self, pair: Option<Pair>) -> String {
        let unit = self.counted_in;
        match self.pair(pair) {
            Some([a, b]) if a.line == b.line => format!("{unit} {} ({} and {})", a.line, a.text, b.text),
            Some([a, b]) => format!("{unit}s {} and {} ({} and {})", a.line, b.line, a.text, b.text),
            None => "no coefficient exceeds 1".to_owned(),
        }
    }
}
