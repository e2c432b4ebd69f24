//! What measurements of bounces say about the coefficient of restitution, in words and as JSON.

use super::counted;
use crate::chain::bounces::{Bound, Estimate};
use crate::number::NumberError;
use crate::number::decimal::Rounding;
use crate::number::plus_minus::plus_minus;
use crate::number::rational::parse;
use crate::table::bounces::Measurements;
use malachite::Rational;
use serde_json::json;

fn rounded(bound: &Bound, digits: u64, rounding: Rounding) -> Result<String, NumberError> {
    Ok(bound.decimal(digits, rounding)?.to_string())
}

/// In words, bounds with so many digits, rounded outwards.
///
/// # Errors
/// A limit on digits.
pub fn text(found: &Measurements, estimate: &Estimate, digits: u64) -> Result<String, NumberError> {
    let count = counted(found.count(), "reading");
    let mut out = String::new();
    match estimate {
        Estimate::Consistent(lower, upper) => {
            let (low, high) = (rounded(lower, digits, Rounding::Down)?, rounded(upper, digits, Rounding::Up)?);
            let ends: [Option<Rational>; 2] = [&low, &high].map(|end| parse(end).ok());
            let about = if let [Some(lo), Some(hi)] = &ends { plus_minus(lo, hi) } else { None };
            out.push_str(&format!("e = {}\n", about.unwrap_or_else(|| low.clone())));
            out.push_str(&format!("consistent with one e: {count}, e from {low} to {high}\n"));
            out.push_str(&format!("at least {low}: {}\n", found.named(lower.from)));
            out.push_str(&format!("at most {high}: {}\n", found.named(upper.from)));
        }
        Estimate::Contradiction(lower, upper) => {
            // Rounded towards each other they might seem to agree: more digits, until they do not.
            let mut digits = digits;
            let (low, high) = loop {
                let (low, high) = (lower.decimal(digits, Rounding::Down)?, upper.decimal(digits, Rounding::Up)?);
                if low.value() > high.value() {
                    break (low.to_string(), high.to_string());
                }
                digits = digits.saturating_mul(2);
            };
            out.push_str(&format!("no e fits {count}\n"));
            out.push_str(&format!("{}: e is at least {low}\n", found.named(lower.from)));
            out.push_str(&format!("{}: e is at most {high}\n", found.named(upper.from)));
            let exact = found.runs.iter().flatten().all(|reading| reading.single().is_some());
            out.push_str(if exact {
                "the readings have no uncertainty, so each is taken as exact: give one with --within, as 0.01 or \"2 %\"\n"
            } else {
                "a reading is wrong, an uncertainty is too small, or e differed between the bounces\n"
            });
        }
    }
    Ok(out)
}

/// For programs.
///
/// # Errors
/// A limit on digits.
pub fn json(found: &Measurements, estimate: &Estimate, digits: u64) -> Result<String, NumberError> {
    let bound = |bound: &Bound, rounding| {
        Ok::<_, NumberError>(json!({
            "decimal": rounded(bound, digits, rounding)?,
            "root": { "of": bound.quotient.to_string(), "index": bound.index },
            "lines": found.pair(bound.from).map(|pair| pair.map(|reading| reading.line)),
        }))
    };
    let (consistent, lower, upper) = match estimate {
        Estimate::Consistent(lower, upper) => (true, lower, upper),
        Estimate::Contradiction(lower, upper) => (false, lower, upper),
    };
    let value = json!({
        "consistent": consistent,
        "at_least": bound(lower, Rounding::Down)?,
        "at_most": bound(upper, Rounding::Up)?,
        "readings": found.count(),
    });
    Ok(serde_json::to_string_pretty(&value).unwrap_or_default() + "\n")
}
