//! The claim language: reading, checking and printing claim files.
mod check;
pub mod definedness;
pub mod diagnostic;
#[cfg(feature = "report")]
pub mod embedded;
pub mod format;
pub mod lex;
pub mod parse;
pub mod print;
pub mod syntax;

/// The description of the language, for `carom help language`.
pub const LANGUAGE: &str = include_str!("../../proofs/README.md");
