//! The claim language: reading, checking and printing claim files.
pub(crate) mod abbreviation;
mod alpha_conversion;
mod angle;
mod binding;
mod check;
pub mod circle;
mod constants;
pub mod definedness;
pub mod dimension;
mod floor;
pub mod format;
pub mod free_names;
mod fresh;
pub mod lex;
mod limit;
pub mod matrix;
mod matrix_power;
pub mod parse;
pub mod preamble;
pub mod print;
pub mod substitution;
pub mod syntax;
mod total;
mod trigonometry;
pub mod walk;
pub mod write_out;

pub use carom_diagnostic as diagnostic;
