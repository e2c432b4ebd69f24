//! Whether units belong to one coherent system.
//!
//! Contract: units fit if a product of their powers that is a number is 1. Then there are units of the base quantities of which
//! all of them are products of powers with no other factor. `m` and `cm` do not fit, nor do `kg`, `m/s` and `erg`; `g`, `cm/s` and
//! `erg` do.
//! Method: elimination of exponents; each unit is a row of the exponents of its dimension and of its factor.

use super::exponent::{Exponent, add_multiple};
use super::read::Unit;
use super::table::Scale;

/// A combination of units that were added.
#[derive(Clone, Debug)]
struct Row {
    dimension: [Exponent; 7],
    scale: Scale,
    /// The power of each unit in it.
    powers: Vec<Exponent>,
    /// The place of the first exponent that is not 0, which is 1.
    lead: usize,
}

/// Units that fit each other.
#[derive(Clone, Debug, Default)]
pub struct System {
    units: Vec<Unit>,
    rows: Vec<Row>,
}

impl System {
    /// Adds a unit.
    ///
    /// # Errors
    /// The unit does not fit: those with which it does not, and the unit itself at the end.
    pub fn add(&mut self, unit: &Unit) -> Result<(), Vec<String>> {
        if self.units.iter().any(|own| own.text() == unit.text()) {
            return Ok(());
        }
        let is_other = |own: &&Unit| own.dimension() == unit.dimension() && own.scale() != unit.scale();
        if let Some(own) = self.units.iter().find(is_other) {
            return Err(vec![own.text().to_string(), unit.text().to_string()]);
        }
        self.units.push(unit.clone());
        // Exponents beyond 64 bits are refused when a unit is read; that combinations stay below is checked as well.
        match self.row(unit) {
            Some(row) if row.dimension.iter().any(|exponent| !exponent.is_zero()) => {
                self.rows.extend(led(row));
                Ok(())
            }
            Some(row) if row.scale.iter().all(|exponent| exponent.is_zero()) => Ok(()),
            row => {
                let is_in = |place: usize| {
                    row.as_ref().is_none_or(|row| row.powers.get(place).is_some_and(|power| !power.is_zero()))
                };
                let list = self.units.iter().enumerate().filter(|(place, _)| is_in(*place));
                Err(list.map(|(_, unit)| unit.text().to_string()).collect())
            }
        }
    }

    /// The last unit without what the others say of its dimension.
    fn row(&self, unit: &Unit) -> Option<Row> {
        let mut powers = vec![Exponent::ZERO; self.units.len()];
        *powers.last_mut()? = Exponent::ONE;
        let mut out = Row { dimension: unit.dimension().0, scale: unit.scale(), powers, lead: 0 };
        for row in &self.rows {
            let factor = out.dimension[row.lead].negated()?;
            out = added(&out, row, factor)?;
        }
        Some(out)
    }
}

/// `row + factor * other`
fn added(row: &Row, other: &Row, factor: Exponent) -> Option<Row> {
    let mut out = row.clone();
    add_multiple(&mut out.dimension, &other.dimension, factor)?;
    add_multiple(&mut out.scale, &other.scale, factor)?;
    add_multiple(&mut out.powers, &other.powers, factor)?;
    Some(out)
}

/// A row divided by its first exponent that is not 0.
fn led(row: Row) -> Option<Row> {
    let lead = row.dimension.iter().position(|exponent| !exponent.is_zero())?;
    let factor = Exponent::ONE.over(row.dimension[lead])?.plus(Exponent::whole(-1))?;
    Some(Row { lead, ..added(&row, &row, factor)? })
}
