//! The part of the engine that a visitor waits for: the answers and the replay of a chain, without prover,
//! tables and pictures.
#![deny(unsafe_code)]
#![warn(missing_docs)]

use wasm_bindgen::prelude::wasm_bindgen;

/// Everything that is known of a chain: `{m1, m2, e, n, inserted, masses, digits}` as they were typed.
#[must_use]
#[wasm_bindgen]
pub fn answers(request: &str) -> String {
    carom_web::answers(request)
}

/// A guess against the answer: `{quantity, guess}` and the chain.
#[must_use]
#[wasm_bindgen]
pub fn predict(request: &str) -> String {
    carom_web::predict(request)
}

/// The collisions of a chain, one by one, and the worldlines to draw.
#[must_use]
#[wasm_bindgen]
pub fn replay(request: &str) -> String {
    carom_web::replay(request)
}
