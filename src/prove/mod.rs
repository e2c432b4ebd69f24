//! From statement to verdict.
//!
//! A claim is expanded ([`expand`]), its hypotheses are taken into a context ([`context`],
//! [`assume`]), expressions become forms ([`translate`]), comparisons become signs of few sums
//! ([`comparison`], [`sign`]), and goals are shown by rules ([`argument`], [`method`], [`extremum`],
//! [`limit`]). What is not shown may be false: [`refute`] searches exact points ([`evaluate`]).
pub mod argument;
pub mod assume;
pub mod catalogue;
pub mod comparison;
pub mod context;
pub mod evaluate;
pub mod expand;
pub mod extremum;
pub mod limit;
pub mod method;
pub mod need;
pub mod outcome;
pub mod refute;
mod series;
pub mod show;
pub mod sign;
pub mod translate;

use crate::algebra::Instant;
