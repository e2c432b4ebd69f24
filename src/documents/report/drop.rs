//! What balls that are dropped together do, as text and as JSON.

use super::padded;
use crate::chain::ChainError;
use crate::number::decimal::{Decimal, Digits, Rounding};
use crate::number::plus_minus::plus_minus;
use crate::scene::About;
use crate::scene::drop::Drop;
use crate::table::grid::decimal_or_fraction;
use crate::table::worksheet::{Entry, Worksheet};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Abs;
use serde_json::{Value as Json, json};

/// The answers to a drop.
struct Found {
    velocities: Vec<(Rational, Rational)>,
    rise: (Rational, Rational),
    height: Option<(Rational, Rational)>,
    /// Whether no other ball can reach the highest one again.
    last: bool,
}

fn found(drop: &Drop) -> Result<Found, ChainError> {
    let worksheet = Worksheet::of_drop(drop)?;
    let bounds = |v: &&Entry| v.bounds().ok_or(ChainError::NotAtRest);
    let velocities = worksheet.velocities().iter().map(bounds).collect::<Result<Vec<_>, _>>()?;
    let ends = |range: crate::chain::uncertain::Range<Rational>| (range.lo().clone(), range.hi().clone());
    // A ball that comes down turns at the floor and goes up no faster than it came.
    let last = match velocities.split_last() {
        Some((top, below)) => below.iter().all(|(lo, hi)| lo.abs().max(hi.abs()) <= top.0),
        None => true,
    };
    Ok(Found { velocities, rise: ends(drop.rise()?), height: drop.rises_to()?.map(ends), last })
}

/// Whether no other ball can hit the highest one again, so that its rise after one pass is its rise.
pub(crate) fn rises_for_good(drop: &Drop) -> bool {
    found(drop).is_ok_and(|found| found.last)
}

/// A number, or a centre with its reach.
fn shown((lo, hi): &(Rational, Rational), digits: u64) -> Result<String, ChainError> {
    match plus_minus(lo, hi) {
        Some(text) => Ok(text),
        None => Ok(Decimal::of_rational(lo, Digits::Significant(digits), Rounding::Nearest)?.to_string()),
    }
}

/// What goes with a rise after which the balls may meet again.
const AGAIN: &str = "this is the rise after one pass; another ball may hit the highest one again and change it";

/// The answers as text.
///
/// # Errors
/// A limit.
pub fn text(drop: &Drop, about: &About, digits: u64) -> Result<String, ChainError> {
    let found = found(drop)?;
    let unit = |unit: &Option<String>| unit.as_ref().map_or(String::new(), |unit| format!(" ({unit})"));
    let mut rows = vec![["ball".to_owned(), format!("mass{}", unit(&about.mass)), "velocity after (v)".to_owned()]];
    for (place, (mass, velocity)) in drop.masses().iter().zip(&found.velocities).enumerate() {
        let (lo, hi) = (mass.lo().value(), mass.hi().value());
        let mass = plus_minus(lo, hi).unwrap_or_else(|| decimal_or_fraction(lo));
        rows.push([(place + 1).to_string(), mass, shown(velocity, digits)?]);
    }
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths = [0, 1, 2].map(width);
    let mut out = String::new();
    for row in &rows {
        let cells: Vec<String> = row.iter().zip(widths).map(|(cell, width)| padded(cell, width, true)).collect();
        out.push_str(&format!("{}\n", cells.join("  ")));
    }
    out.push_str("v is the speed at which the balls reach the floor; upward velocities are positive\n");
    out.push_str(&format!("the highest ball rises to {} times the height of its fall\n", shown(&found.rise, digits)?));
    if let (Some(height), Some(fall)) = (&found.height, drop.height()) {
        let unit = about.height.as_deref().map_or(String::new(), |unit| format!(" {unit}"));
        let fall = (fall.lo().value().clone(), fall.hi().value().clone());
        out.push_str(&format!("from {}{unit} to {}{unit}\n", shown(&fall, digits)?, shown(height, digits)?));
    }
    if !found.last {
        out.push_str(&format!("warning: {AGAIN}\n"));
    }
    Ok(out)
}

/// The answers as JSON.
///
/// # Errors
/// A limit.
pub fn json(drop: &Drop, digits: u64) -> Result<String, ChainError> {
    let found = found(drop)?;
    let number = |range: &(Rational, Rational)| -> Result<Json, ChainError> {
        let (lo, hi) = range;
        let longer = Digits::Significant(digits.saturating_add(3));
        let lower = Decimal::of_rational(lo, longer, Rounding::Down)?.to_string();
        let upper = Decimal::of_rational(hi, longer, Rounding::Up)?.to_string();
        let exact = (lo == hi).then(|| lo.to_string());
        Ok(json!({ "exact": exact, "enclosure": [lower, upper], "shown": shown(range, digits)? }))
    };
    let velocities = found.velocities.iter().map(number).collect::<Result<Vec<Json>, _>>()?;
    let value = json!({
        "velocities": velocities,
        "rise": number(&found.rise)?,
        "height": found.height.as_ref().map(number).transpose()?,
        "warnings": if found.last { Vec::new() } else { vec![AGAIN] },
    });
    let mut out = serde_json::to_string_pretty(&value).unwrap_or_default();
    out.push('\n');
    Ok(out)
}
