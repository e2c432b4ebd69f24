//! Scene files.

pub mod replay;
