//! How the bodies stand and move, in words and with units.

use super::sketch::Sketch;
use super::{Cell, Part, Row, Style, Subject, Table, written};
use crate::number::NumberError;
use crate::number::decimal::{Decimal, Digits, Rounding};
use crate::number::plus_minus::plus_minus;
use crate::scene::About;
use crate::table::grid::decimal_or_fraction;
use crate::table::worksheet::{Body, Collision, Entry, Worksheet};
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;

/// The units of a sheet; `None` where the scene names none.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Units {
    /// Of masses.
    pub mass: Option<String>,
    /// Of velocities.
    pub velocity: Option<String>,
    /// Of momenta.
    pub momentum: Option<String>,
    /// Of energies.
    pub energy: Option<String>,
}

/// Units of energies that have a name.
const ENERGIES: [(&str, &str, &str); 3] = [("kg", "m/s", "J"), ("g", "m/s", "mJ"), ("t", "m/s", "kJ")];

impl Units {
    /// Those of a scene; velocities of balls that are dropped are in units of the speed `v` at the floor.
    #[must_use]
    pub fn of(about: &About, dropped: bool) -> Units {
        let mass = about.mass.clone();
        let velocity = if dropped { Some("v".to_owned()) } else { about.velocity.clone() };
        let both = mass.as_ref().zip(velocity.as_ref());
        let momentum = both.map(|(m, v)| format!("{m}·{v}"));
        let energy = both.map(|(m, v)| match ENERGIES.iter().find(|known| known.0 == m && known.1 == v) {
            Some((.., name)) => (*name).to_owned(),
            None if v.contains('/') => format!("{m}·({v})²"),
            None => format!("{m}·{v}²"),
        });
        Units { mass, velocity, momentum, energy }
    }
}

const COUNTS: [&str; 9] = ["Two", "Three", "Four", "Five", "Six", "Seven", "Eight", "Nine", "Ten"];

fn count(bodies: usize) -> String {
    COUNTS.get(bodies.wrapping_sub(2)).map_or_else(|| bodies.to_string(), |word| (*word).to_owned())
}

/// The scene's own words, what happens, and a table of the bodies.
pub(super) fn parts(subject: &Subject<'_>, units: &Units, style: Style) -> Result<Vec<Part>, NumberError> {
    let collisions = &subject.worksheet.collisions;
    if collisions.is_empty() {
        return Ok(Vec::new());
    }
    let mut parts = Vec::new();
    parts.extend(subject.about.text.clone().map(Part::Text));
    parts.push(Part::Text(words(subject, units, style)?));
    parts.extend(Sketch::of(subject, units, style)?.map(Part::Sketch));
    let bodies = || bodies(subject.worksheet);
    let row = |name: &str, unit: &Option<String>, entry: &dyn Fn(&Body) -> Entry| {
        let unit = unit.as_ref().map_or(String::new(), |unit| format!(" ({unit})"));
        let cells = bodies().map(|body| Ok(Cell::Number(written(&entry(body), style)?)));
        Ok::<Row, NumberError>(Row { name: format!("{name}{unit}"), cells: cells.collect::<Result<_, NumberError>>()? })
    };
    let rows = [
        row("mass", &units.mass, &|b| b.mass.clone())?,
        row("velocity before", &units.velocity, &|b| b.velocity.before.clone())?,
    ];
    // A wide table is cut into several.
    let number = |place: usize| format!("body {}", place + 1);
    for from in (0..collisions.len() + 1).step_by(COLUMNS) {
        let to = (from + COLUMNS).min(collisions.len() + 1);
        let cut = |row: &Row| Row { name: row.name.clone(), cells: row.cells[from..to].to_vec() };
        parts.push(Part::Table(Table {
            title: String::new(),
            columns: (from..to).map(number).collect(),
            groups: vec![rows.iter().map(cut).collect()],
        }));
    }
    Ok(parts)
}

/// The bodies of a sheet before the first collision, in their order.
pub(super) fn bodies(worksheet: &Worksheet) -> impl Iterator<Item = &Body> {
    let first = worksheet.collisions.first().map(|c| &c.bodies[0]);
    first.into_iter().chain(worksheet.collisions.iter().map(|c| &c.bodies[1]))
}

/// The most bodies side by side.
const COLUMNS: usize = 5;

fn words(subject: &Subject<'_>, units: &Units, style: Style) -> Result<String, NumberError> {
    let collisions = &subject.worksheet.collisions;
    let bodies = count(collisions.len() + 1);
    let start = match (subject.drop, collisions.first()) {
        (Some(drop), _) => {
            let height = drop.height().map_or(String::new(), |height| {
                let unit = subject.about.height.as_deref().map_or(String::new(), |unit| format!(" {unit}"));
                let (lo, hi) = (height.lo().value(), height.hi().value());
                let shown = plus_minus(lo, hi).unwrap_or_else(|| decimal_or_fraction(lo));
                format!(" from a height of {shown}{unit}")
            });
            let (lo, hi) = (drop.floor().lo().value(), drop.floor().hi().value());
            let e = plus_minus(lo, hi).unwrap_or_else(|| decimal_or_fraction(lo));
            let then = match (*lo == 0u32, *hi == 0u32) {
                (_, true) => "and stays there. The ball above, which still falls, strikes it",
                (true, _) => "and comes back up, or stays there if e is 0. It meets the ball above, which still falls",
                _ => "and comes back up. It strikes the ball above, which still falls",
            };
            format!(
                "{bodies} balls are dropped together{height}, one right above the other. They reach the floor with the speed v. \
                 The lowest ball, body 1, strikes the floor first (e = {e}) {then}, and so on up to the highest."
            )
        }
        (None, Some(first)) => {
            let zero = Entry::exact(&Rational::ZERO);
            let rests =
                collisions.iter().all(|c| c.bodies[1].velocity.before.compared(&zero).is_some_and(|o| o.is_eq()));
            let speed = written(&first.bodies[0].velocity.before, style)?;
            let unit = units.velocity.as_deref().map_or(String::new(), |unit| format!(" {unit}"));
            match (rests, collisions.len()) {
                (true, 1) => format!(
                    "Two bodies are on a straight track. Body 1 moves with a velocity of {speed}{unit} towards body 2, which is at rest."
                ),
                (true, _) => format!(
                    "{bodies} bodies stand in a row on a straight track. Body 1 moves with a velocity of {speed}{unit} towards the others, \
                     which are at rest. Each body strikes the next one once."
                ),
                (false, 1) => "Two bodies move along a straight track, body 1 on the left. They collide.".to_owned(),
                (false, _) => format!(
                    "{bodies} bodies move along a straight track, body 1 on the left. Each body collides with the next one once."
                ),
            }
        }
        (None, None) => String::new(),
    };
    let later = later(subject, style)?;
    let of = if subject.drop.is_some() { " of two balls" } else { "" };
    Ok(format!("{start}{later} {} {RESTITUTION}", restitutions(collisions, of, style)?))
}

/// What the coefficient of restitution is.
const RESTITUTION: &str = "It is the speed at which two bodies move apart after a collision, divided by the speed at which they came together.";

/// That bodies meet again, and the gaps that decide how.
fn later(subject: &Subject<'_>, style: Style) -> Result<String, NumberError> {
    if subject.drop.is_some() || subject.worksheet.again == Some(false) {
        return Ok(String::new());
    }
    let Some(later) = &subject.worksheet.later else {
        let may = if subject.worksheet.again.is_none() { "may meet" } else { "meet" };
        return Ok(format!(" After that, bodies {may} again; the sheet ends before."));
    };
    let gaps = if later.gaps == 1u32 {
        "The gaps between them are equal.".to_owned()
    } else {
        let gaps = written(&Entry::exact(&later.gaps), style)?;
        format!("From body 1 on, each gap is {gaps} times the one before it.")
    };
    Ok(format!(" After that, bodies meet again. {gaps}"))
}

fn restitutions(collisions: &[Collision], of: &str, style: Style) -> Result<String, NumberError> {
    let all = collisions.iter().map(|c| written(&c.e, style)).collect::<Result<Vec<String>, _>>()?;
    let same = all.windows(2).all(|pair| pair[0] == pair[1]);
    Ok(match all.as_slice() {
        [] => String::new(),
        [only] => format!("The coefficient of restitution{of} is e = {only}."),
        [first, ..] if same => format!("The coefficient of restitution{of} is e = {first} in every collision."),
        list => {
            let list: Vec<String> =
                list.iter().enumerate().map(|(i, e)| format!("{e} in collision {}", i + 1)).collect();
            format!("The coefficient of restitution{of} is e = {}.", list.join(", "))
        }
    })
}

/// A length with its unit.
pub(super) fn length(about: &About, lo: &Rational, hi: &Rational, digits: Digits) -> Result<String, NumberError> {
    let unit = about.height.as_deref().map_or(String::new(), |unit| format!(" {unit}"));
    let shown = match plus_minus(lo, hi) {
        Some(shown) => shown,
        None => Decimal::of_rational(lo, digits, Rounding::Nearest)?.to_string(),
    };
    Ok(if shown.contains('±') && !unit.is_empty() { format!("({shown}){unit}") } else { format!("{shown}{unit}") })
}
