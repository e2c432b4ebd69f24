//! The physics of bodies on a line: chains, scene files, tables over grids, replay, and reference scenes for simulators.

pub mod chain;
pub mod referee;
pub mod scene;
pub mod table;

// The room of the crate above, under the name that it has there.
pub(crate) use carom_exact::number;
