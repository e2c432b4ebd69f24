//! Exact numbers.

pub mod elementary;
pub mod rational;
