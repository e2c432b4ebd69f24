//! Exact numbers.

pub mod rational;
