//! Why a table is not accepted.

/// Why a line was not taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The line is wrong.
    Rejected(String),
    /// A limit was reached.
    Declined(&'static str),
}

/// A rejection.
pub(super) fn rejected<T>(reason: &str) -> Result<T, Failure> {
    Err(Failure::Rejected(reason.to_string()))
}

/// A limit.
pub(super) fn declined<T>(limit: &'static str) -> Result<T, Failure> {
    Err(Failure::Declined(limit))
}
