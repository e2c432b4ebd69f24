//! Measured chains at the middle of their values, for pictures and for the replay.

use crate::request::Fault;
use carom_physics::scene::{Chain, Coefficients, Inserted};
use carom_physics::table::grid::decimal_or_fraction;
use malachite::Rational;

/// The chain of the middles, and these in words where something is measured: `m1 = 57.1, e = 0.9`.
pub fn of(asked: &Chain) -> Result<(Chain, Option<String>), Fault> {
    let chain = asked.midpoint().map_err(|error| Fault::chain(None, &error))?;
    let named = (!asked.is_exact()).then(|| named(asked, &chain));
    Ok((chain, named))
}

fn named(asked: &Chain, middle: &Chain) -> String {
    let mut out = Vec::new();
    let mut note = |name: String, is_measured: bool, value: &Rational| {
        if is_measured {
            out.push(format!("{name} = {}", decimal_or_fraction(value)));
        }
    };
    note("m1".to_owned(), asked.first().single().is_none(), middle.first().lo().value());
    if let (Inserted::Given(list), Inserted::Given(middles)) = (asked.inserted(), middle.inserted()) {
        for (body, (given, middle)) in (2..).zip(list.iter().zip(middles)) {
            note(format!("the mass of body {body}"), given.single().is_none(), middle.lo().value());
        }
    }
    note("m2".to_owned(), asked.last().single().is_none(), middle.last().lo().value());
    match (asked.coefficients(), middle.coefficients()) {
        (Coefficients::Same(given), Coefficients::Same(middle)) => {
            note("e".to_owned(), given.single().is_none(), middle.lo().value());
        }
        (Coefficients::Each(list), Coefficients::Each(middles)) => {
            for (place, (given, middle)) in (1..).zip(list.iter().zip(middles)) {
                note(format!("e{place}"), given.single().is_none(), middle.lo().value());
            }
        }
        _ => {}
    }
    out.join(", ")
}
