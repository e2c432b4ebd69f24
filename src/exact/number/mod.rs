//! Exact numbers, certified enclosures and correctly rounded decimals.
//!
//! From cheap to dear: [`double`] (double-double with a rigorous error bound), `fixed` (some machine words),
//! [`interval`] (dyadic enclosures at any precision), [`rational`] and [`radical`] (exact). [`real`] chooses between them and
//! [`decimal`] prints the result.

pub mod decimal;
pub(crate) mod digits;
pub mod double;
pub mod elementary;
pub mod fixed;
pub mod fraction;
pub mod interval;
pub mod parallel;
pub mod plus_minus;
pub mod product;
pub mod radical;
pub mod rational;
pub mod real;
pub mod root;
pub mod running;
pub mod typed;
mod words;

use std::fmt;

/// Why there is no number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NumberError {
    /// There is no mathematical value.
    Undefined {
        /// What has no value, and why.
        what: String,
    },
    /// A stated limit stands in the way; the value exists.
    LimitReached {
        /// The limit's name.
        limit: &'static str,
        /// What it allows.
        allowed: u64,
        /// What would have been needed.
        needed: String,
    },
}

impl fmt::Display for NumberError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Undefined { what } => write!(f, "{what}"),
            Self::LimitReached { limit, allowed, needed } => {
                write!(f, "limit reached: {limit}: {allowed} allowed, {needed} needed")
            }
        }
    }
}

impl std::error::Error for NumberError {}
