//! Carom audits the algebra of one-dimensional chain collisions and computes with it exactly.
#![forbid(unsafe_code)]

pub mod claim;

#[cfg(feature = "engine")]
pub mod algebra;
#[cfg(feature = "engine")]
pub mod number;
#[cfg(feature = "engine")]
pub mod prove;
