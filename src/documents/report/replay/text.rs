//! A replay as text.

use super::{Numbers, Replay, counted, decimal, group, pair};
use crate::chain::replay::{Cause, Collapse, Contact, Entry, Limit, Status, Value};
use crate::report::{padded, visible};
use std::fmt::Write;

/// The report.
#[must_use]
pub fn report(replay: &Replay) -> String {
    let o = replay.outcome;
    let n = |v: &Value| replay.numbers.write(v);
    let mut out = String::new();
    if let Some(title) = replay.title {
        let _ = writeln!(out, "{}\n", visible(title));
    }
    collisions(replay, &mut out);
    let _ = writeln!(out, "{}", verdict(replay));
    if o.any_order > 0 {
        let _ = writeln!(
            out,
            "Contacts at which every order of collisions leads to the same velocities (one is listed): {}",
            o.any_order
        );
    }
    if o.simultaneous > 0 {
        let _ = writeln!(out, "Times at which several separate pairs collide at once: {}", o.simultaneous);
    }
    if let Some(part) = o.enclosed {
        let _ = writeln!(
            out,
            "Exact numbers for the first {} collisions, then enclosures of {} bits. The count and the order of collisions are certain.",
            part.after, part.bits
        );
    }
    let _ = writeln!(out, "\nAt time {}:", n(&o.time));
    let mut rows = vec![["body", "mass", "position", "velocity"].map(String::from).to_vec()];
    const SHOWN: usize = 100;
    for (i, (x, v)) in o.positions.iter().zip(&o.velocities).enumerate().take(SHOWN) {
        let mass = replay.line.mass(i + 1).map(ToString::to_string).unwrap_or_default();
        rows.push(vec![(i + 1).to_string(), mass, n(x), n(v)]);
    }
    table(&rows, &mut out);
    if o.positions.len() > SHOWN {
        let _ = writeln!(out, "  … {} more (--format json lists all)", o.positions.len() - SHOWN);
    }
    let e = &o.energy;
    let _ = writeln!(out, "\nEnergy    {} before, {} after, {} lost", n(&e.initial), n(&e.last), n(&e.lost));
    let _ = writeln!(out, "Momentum  {} before, {} after", n(&o.momentum.0), n(&o.momentum.1));
    if let Some((_, largest)) = o.growth.last() {
        let bits = crate::report::counted(usize::try_from(*largest).unwrap_or(usize::MAX), "bit");
        let _ = writeln!(out, "Largest numerator or denominator of an exact number: {bits}");
    }
    out
}

fn collisions(replay: &Replay, out: &mut String) {
    let o = replay.outcome;
    if o.events.is_empty() && o.joined.is_empty() {
        return;
    }
    let n = |v: &Value| replay.numbers.write(v);
    let q = |x| replay.numbers.rational(x);
    let head = ["no.", "time", "pair", "place", "before", "", "after", "", "energy lost"];
    let mut rows = vec![head.map(String::from).to_vec()];
    for entry in o.in_order() {
        rows.push(match entry {
            Entry::Collision(number, c) => vec![
                number.to_string(),
                n(&c.time),
                pair(replay.line, c.pair),
                n(&c.position),
                n(&c.before[0]),
                n(&c.before[1]),
                n(&c.after[0]),
                n(&c.after[1]),
                n(&c.lost),
            ],
            Entry::Joined(j) => vec![
                "∞".to_string(),
                n(&j.time),
                group(replay.line, j.bodies),
                n(&j.position),
                q(&j.before[0]),
                q(&j.before[1]),
                q(&j.velocity),
                q(&j.velocity),
                q(&j.lost),
            ],
        });
    }
    table(&rows, out);
    let more = o.count - (o.events.len() as u64).min(o.count);
    if more > 0 {
        let _ = writeln!(out, "  … {more} more (--list N lists more)");
    }
    if !o.joined.is_empty() {
        let _ = writeln!(out, "  {JOINED}");
    }
    out.push('\n');
    for j in &o.joined {
        if let Cause::Collapse(found) = &j.cause {
            let _ = writeln!(out, "{}\n  the replay continues from there\n", collapse(replay, found, j.after));
        }
    }
}

/// Columns, each as wide as its widest cell.
fn table(rows: &[Vec<String>], out: &mut String) {
    let columns = rows.first().map_or(0, Vec::len);
    let width = |c: usize| rows.iter().map(|r| r[c].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    for row in rows {
        let cells: Vec<String> = row.iter().zip(&widths).map(|(cell, width)| padded(cell, *width, false)).collect();
        let _ = writeln!(out, "  {}", cells.join("  ").trim_end());
    }
}

/// The legend for rows of bodies that came together.
pub(super) const JOINED: &str = "∞: infinitely many collisions. Afterwards the bodies touch and share one exact velocity: their total momentum over their total mass, or 0 at a wall.";

/// How the replay ended.
pub(super) fn verdict(replay: &Replay) -> String {
    let o = replay.outcome;
    match &o.status {
        Status::Complete => format!("complete: {}", counted(o)),
        Status::Collapse(found) => {
            let text = collapse(replay, found, o.count);
            format!(
                "{text}\n  the replay ends here; --through-collapse continues, with the bodies in contact at one velocity"
            )
        }
        Status::Ambiguous(found) => ambiguous(replay, found),
        Status::Limit(Limit::Events { allowed }) => {
            format!("limit reached: {allowed} collisions, and another one follows (--max-events raises the limit)")
        }
        Status::Limit(Limit::Values { allowed, needed }) => format!(
            "limit reached: all {} collisions were found, but exact final values would need about {needed} bits, and {allowed} are allowed; enclosures are printed instead",
            o.count
        ),
        Status::Limit(Limit::Precision { bits }) => format!(
            "limit reached: after {} collisions, enclosures of {bits} bits do not decide which collision is next (--exact-bits keeps the run exact for longer)",
            o.count
        ),
    }
}

fn collapse(replay: &Replay, found: &Collapse, after: u64) -> String {
    let n = |x: &Value| {
        let written = replay.numbers.write(x);
        let exact = matches!(x, Value::Surd(_)) && written == Numbers::Exact.write(x);
        if exact { format!("{written} ≈ {}", decimal(x, 12)) } else { written }
    };
    let turn: Vec<String> = found.pattern.iter().map(|p| pair(replay.line, *p)).collect();
    let mut text = format!(
        "collapse: infinitely many collisions before the time {}\n  after {} collisions, the pairs {} collide in turn, for ever (proved)\n  {} come together at {} with velocity {}\n",
        n(&found.time),
        after,
        turn.join(", "),
        group(replay.line, found.bodies),
        n(&found.position),
        replay.numbers.rational(&found.velocity),
    );
    match &found.trace {
        Some((trace, determinant)) => {
            let _ = write!(
                text,
                "  each round multiplies the relative speeds by a matrix of trace {trace}, determinant {determinant}, larger eigenvalue {}",
                n(&found.factor)
            );
        }
        None => {
            let rounds = if found.rounds == 1 { "one round".to_string() } else { format!("{} rounds", found.rounds) };
            let _ = write!(text, "  over {rounds} the relative speeds shrink by a factor near {}", n(&found.factor));
        }
    }
    text.push_str(if found.critical { ", a double eigenvalue: the times converge like 1/n" } else { "" });
    text
}

fn ambiguous(replay: &Replay, found: &Contact) -> String {
    let pairs: Vec<String> = found.pairs.iter().map(|p| pair(replay.line, *p)).collect();
    let mut text = format!(
        "ambiguous: after {}, {} touch at time {}, and {} would collide at the same time: mechanics does not determine their order",
        counted(replay.outcome),
        group(replay.line, found.bodies),
        replay.numbers.rational(&found.time),
        pairs.join(", "),
    );
    match &found.outcomes {
        None => text.push_str("\n  --orders tries each order"),
        Some(all) => {
            for one in &all.outcomes {
                let order: Vec<String> = one.order.iter().map(|p| pair(replay.line, *p)).collect();
                let v: Vec<String> = one.velocities.iter().map(|v| replay.numbers.rational(v)).collect();
                let _ = write!(text, "\n  {}: velocities {}", order.join(", "), v.join(", "));
            }
            if all.outcomes.len() == 1 && !all.cut {
                text.push_str("\n  all orders lead to the same velocities, by different numbers of collisions");
            }
            if all.cut {
                text.push_str("\n  limit reached: some orders were not replayed to the end");
            }
        }
    }
    text
}
