//! The listed collisions as CSV.
//!
//! Columns: the collision's number from 1, its time, the two neighbours (0 is the left wall, the number after
//! the last body the right wall), where they touch, the velocities before and after, the energy lost. A line without
//! a number stands for infinitely many collisions, after which all bodies from `left` to `right` have one velocity.

use super::Replay;
use crate::chain::replay::{Entry, Value};
use malachite::Rational;
use std::fmt::Write;

/// The table.
#[must_use]
pub fn report(replay: &Replay) -> String {
    let mut out =
        String::from("number,time,left,right,position,left_before,right_before,left_after,right_after,energy_lost\n");
    let rational = |x: &Rational| Value::Exact(x.clone());
    for entry in replay.outcome.in_order() {
        let (number, pair, time, values) = match entry {
            Entry::Collision(number, c) => {
                let values = [&c.position, &c.before[0], &c.before[1], &c.after[0], &c.after[1], &c.lost];
                (number.to_string(), (c.pair, c.pair + 1), &c.time, values.map(Value::clone))
            }
            Entry::Joined(j) => {
                let [left, right] = j.before.each_ref().map(rational);
                let after = rational(&j.velocity);
                let values = [j.position.clone(), left, right, after.clone(), after, rational(&j.lost)];
                (String::new(), j.bodies, &j.time, values)
            }
        };
        let _ = write!(out, "{number},{},{},{}", field(replay, time), pair.0, pair.1);
        for value in &values {
            let _ = write!(out, ",{}", field(replay, value));
        }
        out.push('\n');
    }
    out
}

/// A number; an enclosure `[a, b]` has a comma in it.
fn field(replay: &Replay, value: &Value) -> String {
    let text = replay.numbers.write(value);
    if text.contains(',') { format!("\"{text}\"") } else { text }
}
