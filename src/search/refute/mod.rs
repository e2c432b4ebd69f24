//! Claims at exact points: points that satisfy the hypotheses, and points at which the goal then fails.
//!
//! A claim is expanded ([`expand`]) and read ([`reading`]), its equations are solved for variables (`solve`), and exact
//! points are tried ([`search`]). At each the hypotheses and the goal are evaluated ([`goal`], [`evaluate`], `truth`):
//! members of families by their recurrences (`recurrence`), limits by series (`limit`). What comes of it is a sample, where the hypotheses
//! hold (`sample`), or a [`counterexample`]; `case` collects both for a claim.
//! Proofs are found in [`crate::prove`].
pub(crate) mod case;
pub mod catalogue;
pub mod counterexample;
pub mod evaluate;
pub mod expand;
pub(crate) mod faults;
pub mod goal;
pub(crate) mod limit;
pub mod literal;
pub(crate) mod names;
pub mod number;
pub mod outcome;
pub mod reading;
pub(crate) mod recurrence;
pub(crate) mod sample;
pub mod search;
pub(crate) mod shape;
pub(crate) mod solve;
pub mod trial;
pub(crate) mod truth;

mod candidates;
pub(crate) mod closed;
mod dependence;
mod draw;
pub(crate) mod edges;
mod matrix;
pub mod points;
mod quantified;
pub(crate) mod random;
mod series;
mod shrink;
mod turns;

use crate::algebra::Moment;
