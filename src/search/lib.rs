//! The search: counterexamples, proofs, verdicts, and proofs in words.
//!
//! Contract: nothing here is trusted. A claim is proved if the kernel accepts the certificate that the search wrote.

pub mod explain;
pub mod judge;
pub mod prove;
pub mod refute;

// The rooms of the crates above, under the names that they have there.
pub(crate) use carom_checker::{certificate, claim, kernel};
pub(crate) use carom_exact::{algebra, number};
