//! Claims at exact points: where the hypotheses hold, and where the goal then fails.
//!
//! A claim is expanded ([`expand`]), its hypotheses are taken into a context ([`context`],
//! [`assume`]), expressions become forms ([`translate`]), and comparisons become signs of few sums
//! ([`comparison`], [`sign`]). [`refute`] searches exact points ([`evaluate`]); [`case`] says what came of it.
//! Proofs are found in [`crate::certify`].
pub mod assume;
pub mod case;
pub mod catalogue;
pub mod comparison;
pub mod context;
pub mod evaluate;
pub mod expand;
pub mod faults;
pub mod limit;
pub mod outcome;
pub mod refute;
mod series;
pub mod show;
pub mod sign;
pub mod translate;
pub mod trial;

mod candidates;

use crate::algebra::Instant;
