//! Papers in LaTeX as claim files: what is read, what is refused, and what comes back from print.

#[path = "latex/commands.rs"]
mod commands;
#[path = "latex/example.rs"]
mod example;
#[path = "latex/planted.rs"]
mod planted;
#[path = "latex/refused.rs"]
mod refused;
#[path = "latex/round_trip.rs"]
mod round_trip;
