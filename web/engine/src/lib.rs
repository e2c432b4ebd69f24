//! Carom's engine for a browser: plain functions from text to JSON.
//!
//! Contract: every function returns one JSON object. An object with the key `error` says what is wrong: `message`,
//! perhaps `help`, `field` (the name of the request's entry that is wrong, or null) and `limit` (whether a stated
//! limit was reached). No input makes a function panic; what the engine cannot finish ends at a limit, and the page
//! may end the worker that runs it.
//!
//! Every number that the page shows is made here; numbers for drawing are doubles and are called so.
#![deny(unsafe_code)]
#![warn(missing_docs)]

mod chain;
mod claims;
mod classroom;
mod energy;
mod middle;
mod pictures;
mod predict;
mod reasons;
mod replay;
mod request;
mod table;

use request::{Fault, Request};
use serde_json::{Value, json};

/// The answer to a request, or what is wrong with it.
fn answer(text: &str, work: impl FnOnce(&Request) -> Result<Value, Fault>) -> String {
    let found = Request::read(text).and_then(|request| work(&request));
    found.unwrap_or_else(|fault| json!({ "error": fault.to_json() })).to_string()
}

/// Everything that is known of a chain: `{m1, m2, e, n, inserted, masses, digits}` as they were typed.
#[must_use]
pub fn answers(request: &str) -> String {
    answer(request, chain::answers)
}

/// A guess against the answer: `{quantity, guess}` and the chain.
#[must_use]
pub fn predict(request: &str) -> String {
    answer(request, predict::mark)
}

/// The collisions of a chain, one by one, and the worldlines to draw.
#[must_use]
pub fn replay(request: &str) -> String {
    answer(request, replay::replay)
}

/// A table of certified numbers: `{ratio, e, n, want, digits, places, round, format}`.
#[must_use]
pub fn table(request: &str) -> String {
    answer(request, table::table)
}

/// A picture as SVG: `{picture}` and the chain.
#[must_use]
pub fn plot(request: &str) -> String {
    answer(request, pictures::plot)
}

/// A worksheet with its key: `{kind, masses, e, velocity, floor, height, versions, seed, format, …}`.
#[must_use]
pub fn worksheet(request: &str) -> String {
    answer(request, classroom::worksheet)
}

/// Somebody's table beside the certified values: `{table, ratio, e, n, round}`.
#[must_use]
pub fn check_table(request: &str) -> String {
    answer(request, classroom::check_table)
}

/// The restitution that measured bounces allow: `{readings, kind, within, digits}`.
#[must_use]
pub fn restitution(request: &str) -> String {
    answer(request, classroom::restitution)
}

/// Judges the claims of a text: `{text, seconds}`.
#[must_use]
pub fn audit(request: &str) -> String {
    answer(request, claims::audit)
}

/// Judges one claim of the built-in catalogue: `{id}`.
#[must_use]
pub fn claim(request: &str) -> String {
    answer(request, claims::claim)
}

/// The built-in catalogue without verdicts, and the description of the language.
#[must_use]
pub fn catalogue(request: &str) -> String {
    answer(request, claims::catalogue)
}
