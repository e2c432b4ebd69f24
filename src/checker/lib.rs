//! The claim language, certificates, and what checks them: the kernel, and the checker of tables.
//!
//! Contract: whether a claim is *proved* depends on nothing outside this crate and its five dependencies. It has its own
//! arithmetic, and no floating-point numbers.

pub mod certificate;
pub mod claim;
pub mod kernel;
pub mod table_checker;
