//! Worksheets: blank for the pupils, filled in for the teacher.
//!
//! A sheet describes how the bodies stand and move, asks for predictions, then for the numbers of each collision, and
//! then for a comparison. A blank sheet gives the masses, the coefficients of restitution and the velocities before the first
//! collision of each body; everything else is to be found. [`sheet`] puts it together; [`text`], [`latex`] and [`html`]
//! write it, and [`pages`] lays it out.

pub mod expected;
pub mod html;
pub mod latex;
pub mod made;
pub mod pages;
mod questions;
mod setting;
pub mod sketch;
pub mod text;

use crate::chain::recollision::{MAY_WARN, WARNING};
use crate::number::NumberError;
use crate::number::decimal::{Decimal, Digits, Rounding};
use crate::number::plus_minus::plus_minus;
use crate::report::counted;
use crate::scene::About;
use crate::scene::drop::Drop;
use crate::table::grid::decimal_or_fraction;
use crate::table::worksheet::{Change, Collision, Entry, Worksheet};
pub use expected::Expected;
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
pub use setting::Units;
use std::cmp::Ordering;

/// How entries are written.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// The digits of decimals.
    pub digits: Digits,
    /// Fractions `p/q` where the value is rational and its fraction short.
    pub exact: bool,
}

/// The subject of a sheet.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The collisions.
    pub worksheet: &'a Worksheet,
    /// Title, text and units of the scene.
    pub about: &'a About,
    /// The balls, where they are dropped.
    pub drop: Option<&'a Drop>,
    /// The title.
    pub title: &'a str,
    /// The letter of the version, and the seed that gives it.
    pub version: Option<(char, u64)>,
    /// The standard that the sheet serves.
    pub standard: Option<&'a str>,
    /// Which predictions of the stock a version asks; `None` for the usual ones.
    pub asked: Option<&'a [usize]>,
}

/// A sheet.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Its title.
    pub title: String,
    /// The footer of each page.
    pub foot: String,
    /// Its parts in order.
    pub parts: Vec<Part>,
}

/// A part of a sheet.
#[derive(Clone, Debug)]
pub enum Part {
    /// Lines for name, class and date.
    Names,
    /// A heading.
    Heading(String),
    /// A paragraph.
    Text(String),
    /// The bodies before the first collision.
    Sketch(sketch::Sketch),
    /// A question with boxes to tick.
    Choice {
        /// The question.
        ask: String,
        /// The answers, and whether each is ticked.
        options: Vec<(String, bool)>,
        /// Which of them is right.
        right: Option<usize>,
    },
    /// A question with lines to write on, or its answer.
    Open {
        /// The question.
        ask: String,
        /// The answer.
        answer: Option<String>,
        /// The numbers of the answer.
        numbers: Vec<Number>,
        /// So many lines.
        lines: usize,
    },
    /// A table.
    Table(Table),
}

/// A number that a question asks for.
#[derive(Clone, Debug)]
pub struct Number {
    /// Its name and unit.
    pub label: String,
    /// What is right; `None` where an answer has an uncertainty.
    pub expected: Option<Expected>,
}

/// A table; the first column has the names of the rows.
#[derive(Clone, Debug)]
pub struct Table {
    /// Above it.
    pub title: String,
    /// The headings of all columns but the first.
    pub columns: Vec<String>,
    /// Rows that belong together, with a line below each group.
    pub groups: Vec<Vec<Row>>,
}

/// A row of a table.
#[derive(Clone, Debug)]
pub struct Row {
    /// Its name.
    pub name: String,
    /// Its cells.
    pub cells: Vec<Cell>,
}

/// A cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Cell {
    /// A number.
    Number(String),
    /// To be filled in, and what is right there.
    Blank(Option<Expected>),
    /// Nothing belongs here.
    Nothing,
}

/// Before the standard that a sheet serves.
const STANDARD: &str = "Standard: ";
/// The longest fraction in a cell, in characters.
const MAX_FRACTION: usize = 15;

/// A sheet; `filled` is the answer key.
///
/// # Errors
/// A limit on digits.
pub fn sheet(subject: &Subject<'_>, style: Style, filled: bool) -> Result<Sheet, NumberError> {
    let units = Units::of(subject.about, subject.drop.is_some());
    let kind = if filled { "answer key" } else { "worksheet" };
    let letter = subject.version.map_or(String::new(), |(letter, _)| format!(", version {letter}"));
    let title = format!("{}: {kind}{letter}", subject.title);
    let seed = subject.version.map_or(String::new(), |(letter, seed)| format!(", version {letter} of seed {seed}"));
    let foot = format!("{}: {kind}{seed}", subject.title);
    let mut parts = Vec::new();
    if !filled {
        parts.push(Part::Names);
    }
    if let Some(standard) = subject.standard {
        parts.push(Part::Text(format!("{STANDARD}{standard}")));
    }
    parts.extend(setting::parts(subject, &units, style)?);
    parts.extend(questions::predictions(subject, filled));
    parts.push(Part::Heading("Compute".to_owned()));
    parts.push(Part::Text(compute(subject, style, filled)));
    for (place, collision) in subject.worksheet.collisions.iter().enumerate() {
        parts.push(Part::Table(table(collision, place, &units, style, filled)?));
    }
    parts.extend(questions::comparison(subject, &units, style, filled)?);
    parts.extend(note(subject).map(|note| Part::Text(format!("Note: {note}."))));
    Ok(Sheet { title, foot, parts })
}

/// What the velocities of the sheet are not, where it does not say how it goes on.
fn note(subject: &Subject<'_>) -> Option<&'static str> {
    match (subject.drop, &subject.worksheet.later, subject.worksheet.again) {
        (Some(_), ..) => Some(
            "the sheet ends when the highest ball has been struck; later collisions, with the floor or with each other, are left out",
        ),
        (None, Some(_), _) | (None, None, Some(false)) => None,
        (None, None, Some(true)) => Some(WARNING),
        (None, None, None) => Some(MAY_WARN),
    }
}

/// The instructions, or on the answer key how the answers are rounded.
fn compute(subject: &Subject<'_>, style: Style, filled: bool) -> String {
    let way = if subject.drop.is_some() { "upwards" } else { "to the right" };
    let about = format!(
        "p = m v is the momentum, E = m v²/2 the kinetic energy. A change is after minus before. Velocities {way} are positive."
    );
    let measured =
        if subject.worksheet.collisions.iter().any(|c| c.bodies.iter().any(|b| is_measured(&b.velocity.after))) {
            " a ± b stands for every value from a − b to a + b."
        } else {
            ""
        };
    let rounded = match style.digits {
        Digits::Significant(digits) => counted(usize::try_from(digits).unwrap_or(usize::MAX), "significant digit"),
        Digits::Places(places) => counted(usize::try_from(places).unwrap_or(usize::MAX), "decimal place"),
    };
    let rule = match filled {
        true => format!("Decimals are rounded to nearest, to {rounded}."),
        false => format!(
            "Fill in the empty cells with exact numbers, or round to {rounded}. Carry more digits while you compute."
        ),
    };
    format!("{about}{measured} {rule}")
}

fn is_measured(entry: &Entry) -> bool {
    matches!(entry, Entry::Between(_))
}

/// One of the entries of a change.
type Pick = fn(&Change) -> &Entry;

/// The table of a collision: two bodies and both together.
fn table(c: &Collision, place: usize, units: &Units, style: Style, filled: bool) -> Result<Table, NumberError> {
    let [a, b] = &c.bodies;
    let cell = |entry: &Entry, given: bool| {
        Ok(match (given, filled) {
            (true, _) => Cell::Number(written(entry, style)?),
            (_, true) => Cell::Number(number(entry, style)?),
            _ => Cell::Blank(Expected::of(entry, &number(entry, style)?, style.digits)),
        })
    };
    let row = |name: String, cells: Vec<Result<Cell, NumberError>>| {
        Ok::<Row, NumberError>(Row { name, cells: cells.into_iter().collect::<Result<_, _>>()? })
    };
    let nothing = || Ok(Cell::Nothing);
    let quantity = |name: &str, unit: &Option<String>, first: &Change, second: &Change, both: Option<&Change>| {
        let unit = unit.as_ref().map_or(String::new(), |unit| format!(" ({unit})"));
        let parts: [(&str, Pick); 3] = [("before", |c| &c.before), ("after", |c| &c.after), ("change", |c| &c.change)];
        let rows = parts.into_iter().map(|(when, part)| {
            // A body that is struck has not moved yet: its velocity is one of the given ones.
            let known = name == "velocity" && when == "before";
            let both = both.map_or_else(nothing, |both| cell(part(both), false));
            let cells = vec![cell(part(first), known && place == 0), cell(part(second), known), both];
            row(format!("{name} {when}{unit}"), cells)
        });
        rows.collect::<Result<Vec<Row>, NumberError>>()
    };
    let unit = units.mass.as_ref().map_or(String::new(), |unit| format!(" ({unit})"));
    let groups = vec![
        vec![row(format!("mass{unit}"), vec![cell(&a.mass, true), cell(&b.mass, true), nothing()])?],
        quantity("velocity", &units.velocity, &a.velocity, &b.velocity, None)?,
        quantity("momentum", &units.momentum, &a.momentum, &b.momentum, Some(&c.momentum))?,
        quantity("kinetic energy", &units.energy, &a.energy, &b.energy, Some(&c.energy))?,
    ];
    let (behind, front) = (a.number, b.number);
    let e = written(&c.e, style)?;
    let moves = a.velocity.before.compared(&Entry::exact(&Rational::ZERO)) == Some(Ordering::Greater);
    let meeting = match moves {
        true => format!("body {behind} strikes body {front}"),
        false => format!("body {behind} and body {front} collide"),
    };
    Ok(Table {
        title: format!("Collision {}: {meeting}, e = {e}", place + 1),
        columns: vec![format!("body {behind}"), format!("body {front}"), "both".to_owned()],
        groups,
    })
}

/// A text with its decimals such as `2.250e4` as `power` writes them, from the digits and the exponent.
fn with_powers(text: &str, power: impl Fn(&str, &str) -> String) -> String {
    let natural = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let one = |word: &str| {
        let number = word.trim_matches(|c: char| !c.is_ascii_alphanumeric());
        let parts = number.split_once('e').filter(|(digits, exponent)| {
            natural(&digits.replacen('.', "", 1)) && natural(exponent.strip_prefix('-').unwrap_or(exponent))
        });
        match parts {
            Some((digits, exponent)) => word.replacen(number, &power(digits, exponent), 1),
            None => word.to_owned(),
        }
    };
    text.split(' ').map(one).collect::<Vec<_>>().join(" ")
}

/// A given number, as it was written if that is short.
fn written(entry: &Entry, style: Style) -> Result<String, NumberError> {
    if let Entry::Number(x) = entry
        && let Some(text) = x.as_rational().map(decimal_or_fraction).filter(|text| text.len() <= MAX_FRACTION)
    {
        return Ok(text);
    }
    number(entry, style)
}

/// An answer: a fraction if wanted, a decimal, or a centre ± its half-width.
fn number(entry: &Entry, style: Style) -> Result<String, NumberError> {
    let x = match entry {
        Entry::Number(x) => x,
        Entry::Between(range) => {
            let shown = plus_minus(range.lo(), range.hi());
            return Ok(shown.unwrap_or_else(|| decimal_or_fraction(range.lo())));
        }
    };
    if style.exact
        && let Some(text) = x.as_rational().map(ToString::to_string)
        && text.len() <= MAX_FRACTION
    {
        return Ok(text);
    }
    Ok(Decimal::of_real(x, style.digits, Rounding::Nearest)?.0.to_string())
}
