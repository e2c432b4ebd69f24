//! The engine of the page as WebAssembly: everything but the answers and the replay of a chain, which `../first` gives.
#![deny(unsafe_code)]
#![warn(missing_docs)]

use wasm_bindgen::prelude::wasm_bindgen;

/// A table of certified numbers: `{ratio, e, n, want, digits, places, round, format}`.
#[must_use]
#[wasm_bindgen]
pub fn table(request: &str) -> String {
    carom_web::table(request)
}

/// A picture as SVG: `{picture}` and the chain.
#[must_use]
#[wasm_bindgen]
pub fn plot(request: &str) -> String {
    carom_web::plot(request)
}

/// A worksheet with its key: `{kind, masses, e, velocity, floor, height, versions, seed, format, …}`.
#[must_use]
#[wasm_bindgen]
pub fn worksheet(request: &str) -> String {
    carom_web::worksheet(request)
}

/// Somebody's table beside the certified values: `{table, ratio, e, n, round}`.
#[must_use]
#[wasm_bindgen]
pub fn check_table(request: &str) -> String {
    carom_web::check_table(request)
}

/// The restitution that measured bounces allow: `{readings, kind, within, digits}`.
#[must_use]
#[wasm_bindgen]
pub fn restitution(request: &str) -> String {
    carom_web::restitution(request)
}

/// Judges the claims of a text: `{text, seconds}`.
#[must_use]
#[wasm_bindgen]
pub fn audit(request: &str) -> String {
    carom_web::audit(request)
}

/// Judges one claim of the built-in catalogue: `{id}`.
#[must_use]
#[wasm_bindgen]
pub fn claim(request: &str) -> String {
    carom_web::claim(request)
}

/// The built-in catalogue without verdicts, and the description of the language.
#[must_use]
#[wasm_bindgen]
pub fn catalogue(request: &str) -> String {
    carom_web::catalogue(request)
}
