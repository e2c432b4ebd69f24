//! Papers in LaTeX as claim files: what is read, what is refused, and what comes back from print.

mod commands;
mod documents;
mod example;
mod files;
mod planted;
mod public;
mod refused;
mod round_trip;
