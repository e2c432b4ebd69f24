//! The claim language: reading, checking and printing claim files.
pub mod abbreviation;
mod angle;
mod check;
mod circle;
pub mod definedness;
pub mod diagnostic;
#[cfg(feature = "report")]
pub mod embedded;
mod floor;
pub mod format;
pub mod lex;
mod matrix;
pub mod parse;
pub mod preamble;
pub mod print;
pub mod syntax;
mod total;
mod trigonometry;
pub mod walk;

/// The description of the language, for `carom help language`.
pub const LANGUAGE: &str = include_str!("../../proofs/README.md");
