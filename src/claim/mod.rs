//! The claim language: reading, checking and printing claim files.
pub mod syntax;
