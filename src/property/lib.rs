//! Properties of chains and of claims, on random exact inputs.
//!
//! [`law::law`] reads a claim of the language: it tries it at random exact points that satisfy its hypotheses, as `carom
//! test` does, and is a strategy of proptest for such points ([`points`]). [`strategies`] are proptest's for chains, also with
//! extreme ratios and with thresholds met exactly; [`scene`] writes a chain as a scene file.

pub mod law;
pub mod points;
pub mod scene;
pub mod strategies;
