//! Tables of certified numbers.

pub mod grid;
