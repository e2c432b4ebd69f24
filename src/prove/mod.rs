//! From statement to verdict.
pub mod outcome;
