//! Somebody's results as a table: which answer belongs to which scene.
//!
//! Contract: the columns `scene` and `velocities` must be there; `positions`, `collisions` (1-2 2-3 …, 0 is the left wall),
//! `times` and `count` may be. Numbers in a field stand apart by spaces. A scene has one row at most.

use super::Scene;
use super::judge::{Answer, Given};
use crate::number::rational::NumeralError;
use crate::number::typed;
use crate::table::foreign::{Foreign, ForeignError};
use carom_diagnostic::nearest;
use std::collections::BTreeMap;
use std::fmt;

/// Why results cannot be judged.
#[derive(Debug)]
pub enum ResultsError {
    /// They are no table.
    Table(ForeignError),
    /// A column is missing; these are there.
    Columns(Vec<String>),
    /// A field is wrong.
    Field {
        /// Its line, from 1.
        line: u64,
        /// Its column, from 1.
        column: usize,
        /// The column's name.
        name: String,
        /// What is wrong.
        what: String,
        /// Whether a stated limit is the reason.
        limit: bool,
    },
}

impl fmt::Display for ResultsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Table(ForeignError::Empty) => {
                write!(f, "the file has no heading; write for instance: scene,velocities")
            }
            Self::Table(error) => write!(f, "{error}"),
            Self::Columns(names) => {
                write!(f, "the columns scene and velocities are required; the columns are {}", names.join(", "))
            }
            Self::Field { column, name, what, .. } => write!(f, "column {column} ({name}): {what}"),
        }
    }
}

impl std::error::Error for ResultsError {}

impl ResultsError {
    /// Whether a stated limit is the reason.
    #[must_use]
    pub fn is_limit(&self) -> bool {
        match self {
            Self::Table(error) => error.is_limit(),
            Self::Field { limit, .. } => *limit,
            Self::Columns(_) => false,
        }
    }
}

/// What is said of a name that no scene has.
#[must_use]
pub fn unknown<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    match nearest(name, known) {
        Some(near) => format!("no scene is called {name}; did you mean {near}?"),
        None => format!("no scene is called {name}; `carom referee --scenes` lists all scenes"),
    }
}

/// What is wrong with a part of a field.
struct Wrong {
    what: String,
    limit: bool,
}

fn wrong(what: impl Into<String>) -> Wrong {
    Wrong { what: what.into(), limit: false }
}

/// A field with its column's name.
struct Field<'a> {
    line: u64,
    column: usize,
    name: &'a str,
    text: &'a str,
}

impl Field<'_> {
    /// A fault of this field, with its line and column.
    fn fault(&self, Wrong { what, limit }: Wrong) -> ResultsError {
        ResultsError::Field { line: self.line, column: self.column + 1, name: self.name.to_owned(), what, limit }
    }

    fn wrong(&self, what: impl Into<String>) -> ResultsError {
        self.fault(wrong(what))
    }

    /// The parts of the field, each read.
    fn list<T>(&self, read: impl Fn(&str) -> Result<T, Wrong>) -> Result<Vec<T>, ResultsError> {
        self.text.split_whitespace().map(|part| read(part).map_err(|e| self.fault(e))).collect()
    }

    fn numbers(&self, needed: Option<usize>) -> Result<Vec<Given>, ResultsError> {
        let list = self.list(number)?;
        match needed.filter(|needed| !list.is_empty() && list.len() != *needed) {
            Some(needed) => {
                Err(self.wrong(format!("expected {needed} numbers, one for each body, found {}", list.len())))
            }
            None => Ok(list),
        }
    }
}

fn number(text: &str) -> Result<Given, Wrong> {
    use NumeralError::{ExponentTooLarge, TooManyDigits};
    let bare = text.trim_start_matches(['-', '+']).to_ascii_lowercase();
    if ["nan", "inf", "infinity"].contains(&bare.as_str()) {
        return Ok(Given::Strange(text.to_owned()));
    }
    typed::read(text).map(Given::Number).map_err(|e| Wrong {
        limit: matches!(e, TooManyDigits { .. } | ExponentTooLarge { .. }),
        what: format!("{text:?}: {e}"),
    })
}

/// A pair `1-2` of neighbours, by its left point.
fn pair(text: &str, bodies: usize) -> Result<usize, Wrong> {
    let place = |part: &str| part.parse::<usize>().ok();
    let pair = text.split_once(['-', '–']).and_then(|(a, b)| place(a).zip(place(b)));
    let Some((a, b)) = pair else {
        return Err(wrong(format!("{text:?} is not a pair of bodies; write for instance 1-2")));
    };
    if a.abs_diff(b) != 1 || a.max(b) > bodies + 1 {
        let last = bodies + 1;
        return Err(wrong(format!(
            "{text:?}: neighbours collide: 0-1 at the left wall to {bodies}-{last} at the right"
        )));
    }
    Ok(a.min(b))
}

/// The results of each scene.
///
/// # Errors
/// [`ResultsError`].
pub fn read(bytes: &[u8], scenes: &[Scene]) -> Result<BTreeMap<String, Answer>, ResultsError> {
    let mut table = Foreign::open(bytes).map_err(ResultsError::Table)?;
    let column = |wanted: &str| table.names.iter().position(|name| name.eq_ignore_ascii_case(wanted));
    let (Some(name), Some(velocities)) = (column("scene"), column("velocities")) else {
        return Err(ResultsError::Columns(table.names));
    };
    let further = ["positions", "collisions", "times", "count"].map(column);
    let names = table.names.clone();
    let mut found = BTreeMap::new();
    while let Some(row) = table.row().map_err(ResultsError::Table)? {
        let field = |place: usize| Field {
            line: row.line,
            column: place,
            name: &names[place],
            text: row.fields.get(place).map_or("", String::as_str),
        };
        let head = field(name);
        let scene = scenes.iter().find(|scene| scene.name == head.text);
        let known = || scenes.iter().map(|scene| scene.name.as_str());
        let scene = scene.ok_or_else(|| head.wrong(unknown(head.text, known())))?;
        let answer = answer(&field, velocities, further, scene.bodies.len())?;
        if found.insert(scene.name.clone(), answer).is_some() {
            return Err(head.wrong(format!("{} already has a result", scene.name)));
        }
    }
    Ok(found)
}

fn answer<'a>(
    field: &dyn Fn(usize) -> Field<'a>,
    velocities: usize,
    [positions, collisions, times, count]: [Option<usize>; 4],
    bodies: usize,
) -> Result<Answer, ResultsError> {
    let numbers = |place: Option<usize>, needed| place.map_or(Ok(Vec::new()), |place| field(place).numbers(needed));
    let pairs = collisions.map(field).map(|field| field.list(|text| pair(text, bodies))).transpose()?;
    let count = count
        .map(field)
        .filter(|field| !field.text.is_empty())
        .map(|field| field.text.parse().map_err(|_| field.wrong(format!("{:?} is not a whole number", field.text))));
    Ok(Answer {
        velocities: field(velocities).numbers(Some(bodies))?,
        positions: numbers(positions, Some(bodies))?,
        pairs,
        times: numbers(times, None)?,
        count: count.transpose()?,
    })
}
