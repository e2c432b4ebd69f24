//! The listed collisions as CSV.
//!
//! Columns: the collision's number from 1, its time, the two neighbours (0 is the left wall, the number after
//! the last body the right wall), where they touch, the velocities before and after, the energy lost.

use super::Replay;
use std::fmt::Write;

/// The table.
#[must_use]
pub fn report(replay: &Replay) -> String {
    let mut out =
        String::from("number,time,left,right,position,left_before,right_before,left_after,right_after,energy_lost\n");
    for (i, c) in replay.outcome.events.iter().enumerate() {
        let _ = write!(out, "{},{},{},{}", i + 1, field(replay, &c.time), c.pair, c.pair + 1);
        for value in [&c.position, &c.before[0], &c.before[1], &c.after[0], &c.after[1], &c.lost] {
            let _ = write!(out, ",{}", field(replay, value));
        }
        out.push('\n');
    }
    out
}

/// A number; an enclosure `[a, b]` has a comma in it.
fn field(replay: &Replay, value: &crate::chain::replay::Value) -> String {
    let text = replay.numbers.write(value);
    if text.contains(',') { format!("\"{text}\"") } else { text }
}
