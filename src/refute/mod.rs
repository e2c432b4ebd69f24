//! Claims at exact points: points that satisfy the hypotheses, and points at which the goal then fails.
//!
//! A claim is expanded ([`expand`]) and read ([`reading`]), its equations are solved for variables (`solve`), and exact
//! points are tried ([`search`], [`evaluate`]), members of families by their recurrences (`recurrence`); limits are found at a point
//! (`limit`). `case` runs these for one claim.
//! [`crate::prove`] finds proofs.
pub(crate) mod case;
pub mod catalogue;
pub mod evaluate;
pub mod expand;
pub(crate) mod faults;
pub(crate) mod limit;
pub mod number;
pub mod outcome;
pub mod reading;
pub(crate) mod recurrence;
pub mod search;
pub(crate) mod shape;
pub(crate) mod solve;
pub mod trial;

mod candidates;
mod closed;

use crate::algebra::Moment;
