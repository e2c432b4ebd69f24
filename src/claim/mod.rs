//! The claim language: reading, checking and printing claim files.
mod check;
pub mod diagnostic;
pub mod lex;
pub mod parse;
pub mod print;
pub mod syntax;
