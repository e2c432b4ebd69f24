//! The physics of point bodies that collide on a line.

pub mod replay;
