//! The claim language: reading, checking and printing claim files.
pub(crate) mod abbreviation;
mod angle;
mod check;
mod circle;
pub mod definedness;
pub mod diagnostic;
#[cfg(feature = "report")]
pub mod embedded;
mod floor;
pub mod format;
pub(crate) mod lex;
pub(crate) mod matrix;
mod matrix_power;
pub mod parse;
pub(crate) mod preamble;
pub mod print;
pub mod syntax;
mod total;
mod trigonometry;
pub(crate) mod walk;

/// The description of the language, for `carom help language`.
pub const LANGUAGE: &str = include_str!("../../proofs/README.md");
