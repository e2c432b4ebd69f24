//! Units of measurement and their dimensions.
//!
//! Contract: a unit is read from a text such as `kg*m/s^2`, or refused with the place of what is wrong. Its dimension has exact
//! rational exponents over the seven base quantities of the SI. Units *fit* if they belong to one coherent system: then an
//! equation between quantities is the same equation between the numbers that they are measured as.
#![forbid(unsafe_code)]

mod dimension;
mod exponent;
mod read;
mod system;
mod table;

pub use dimension::Dimension;
pub use exponent::Exponent;
pub use read::{Fault, Unit};
pub use system::System;
pub use table::known;
