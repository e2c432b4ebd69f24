//! The exact state behind the collisions that doubles have ordered.
//!
//! A collision enters the backlog as its pair and the collisions before it of the same two points. Its exact outcome is
//! needed only where doubles leave a question open, and at the end:
//! - [`Run::solve`] follows the two points back as far as their past is not exact yet, and keeps what it finds. Each
//!   collision is solved once.
//! - [`Run::settle`] takes the whole backlog in its order: it books, lists and measures each collision. From then on `b`
//!   and `v` are the exact state.
//!
//! So a run is exact, and ends where exact numbers outgrow their limit, as if every collision had been solved at once.

use super::{Bound, Last, Run, bits};
use crate::chain::replay::ledger::LedgerFault;
use crate::chain::replay::line::Pair;
use crate::chain::replay::near::{Course, Near};
use crate::chain::replay::{Collision, Value};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::NegAssign;
use std::collections::HashMap;

/// A longer backlog is settled, or one with more collisions for each point: 16 bytes a collision.
const MOST_PENDING: usize = 1 << 14;
const MOST_PENDING_A_POINT: usize = 64;

/// So is one with more solved collisions.
const MOST_SOLVED: usize = 1 << 16;

/// A collision that is ordered.
#[derive(Clone, Copy)]
struct Pending {
    pair: u32,
    /// The collisions before it of its left and of its right point, from 1; 0 for the settled state.
    before: [u32; 2],
    /// Whether an instant begins with it, and whether several separate pairs collide then.
    begins: bool,
    simultaneous: bool,
}

/// Intercept and velocity, exactly.
type Worldline = (Rational, Rational);

/// The collisions that are ordered and not settled.
#[derive(Clone, Default)]
pub(super) struct Backlog {
    pending: Vec<Pending>,
    /// The last of them for each point, from 1; 0 where there is none.
    last: Vec<u32>,
    /// The worldlines of both points after some of them.
    solved: HashMap<u32, [Worldline; 2]>,
    /// Numbers of more bits than this end the exact part.
    pub(super) most_bits: u64,
    grown: bool,
}

impl Backlog {
    /// Nothing pending among `n` points.
    pub(super) fn new(n: usize) -> Backlog {
        Backlog { last: vec![0; n], most_bits: u64::MAX, ..Backlog::default() }
    }

    /// How many collisions are pending.
    pub(super) fn len(&self) -> u64 {
        self.pending.len() as u64
    }

    /// Whether it is time to settle: it has become long, or a number has outgrown its limit.
    pub(super) fn is_due(&self) -> bool {
        let most = MOST_PENDING.max(MOST_PENDING_A_POINT * self.last.len());
        self.grown || self.pending.len() >= most || self.solved.len() >= MOST_SOLVED
    }

    /// Adds a collision.
    pub(super) fn push(&mut self, p: usize, begins: bool, simultaneous: bool) {
        self.pending.push(Pending { pair: p as u32, before: [self.last[p], self.last[p + 1]], begins, simultaneous });
        let number = self.pending.len() as u32;
        self.last[p] = number;
        self.last[p + 1] = number;
    }
}

/// What a collision does to worldlines with this gap and closing speed.
fn collided(pair: &Pair, sides: [(&Rational, &Rational); 2], gap: &Rational, speed: &Rational) -> [Worldline; 2] {
    let [left, right] = sides;
    let mut back = gap.clone();
    back.neg_assign();
    // The intercepts change as the velocities do: by b_l − b_r in place of v_l − v_r.
    [
        (left.0 - &pair.left * &back, left.1 - &pair.left * speed),
        (right.0 + &pair.right * back, right.1 + &pair.right * speed),
    ]
}

impl Run<'_> {
    /// The exact worldline of point `k` after the pending collision with this number, which is solved.
    fn after(&self, k: usize, number: u32) -> (&Rational, &Rational) {
        match number.checked_sub(1) {
            None => (&self.b[k], &self.v[k]),
            Some(i) => {
                let (b, v) = &self.backlog.solved[&number][k - self.backlog.pending[i as usize].pair as usize];
                (b, v)
            }
        }
    }

    /// Makes the worldline of a point exact.
    pub(super) fn solve(&mut self, k: usize) {
        let mut open = vec![self.backlog.last[k]];
        while let Some(&number) = open.last() {
            if number == 0 || self.backlog.solved.contains_key(&number) {
                open.pop();
                continue;
            }
            let Pending { pair: p, before, .. } = self.backlog.pending[number as usize - 1];
            let unknown = before.into_iter().filter(|n| *n > 0 && !self.backlog.solved.contains_key(n));
            let length = open.len();
            open.extend(unknown);
            if open.len() > length {
                continue;
            }
            let p = p as usize;
            let sides = [self.after(p, before[0]), self.after(p + 1, before[1])];
            let (gap, speed) = (sides[1].0 - sides[0].0, sides[0].1 - sides[1].1);
            let found = collided(&self.line.pairs[p], sides, &gap, &speed);
            self.backlog.grown |= found.iter().any(|(b, v)| bits(b).max(bits(v)) > self.backlog.most_bits);
            self.backlog.solved.insert(number, found);
        }
    }

    /// When the pair meets, exactly: a gap over a speed, both positive or the gap zero. The doubles follow.
    pub(super) fn meeting(&mut self, p: usize) -> (Rational, Rational) {
        self.solve(p);
        self.solve(p + 1);
        let last = &self.backlog.last;
        let (left, right) = (self.after(p, last[p]), self.after(p + 1, last[p + 1]));
        let near = [Course::of(left.0, left.1), Course::of(right.0, right.1)];
        let (gap, speed) = (right.0 - left.0, left.1 - right.1);
        self.near[p..p + 2].copy_from_slice(&near);
        self.due[p] = Near::of(&gap).over(Near::of(&speed));
        (gap, speed)
    }

    /// Makes the whole state exact. Answers whether numbers outgrew their limit: then the state is that before the first
    /// instant after which they had, and what came later is forgotten.
    pub(in crate::chain::replay) fn settle(&mut self, bound: &Bound) -> Result<bool, LedgerFault> {
        let pending = std::mem::take(&mut self.backlog.pending);
        let mut solved = std::mem::take(&mut self.backlog.solved);
        for (entry, number) in pending.iter().zip(1..) {
            if entry.begins && self.largest > self.backlog.most_bits {
                self.backlog.grown = false;
                self.backlog.last.fill(0);
                return Ok(true);
            }
            self.simultaneous += u64::from(entry.simultaneous);
            self.book(entry.pair as usize, solved.remove(&number), bound)?;
        }
        for entry in &pending {
            for k in [entry.pair as usize, entry.pair as usize + 1] {
                if std::mem::take(&mut self.backlog.last[k]) > 0 {
                    self.near[k] = Course::of(&self.b[k], &self.v[k]);
                }
            }
        }
        self.backlog.grown = false;
        Ok(false)
    }

    /// Books, lists and measures a collision, from its solution where there is one.
    fn book(&mut self, p: usize, solved: Option<[Worldline; 2]>, bound: &Bound) -> Result<(), LedgerFault> {
        let line = self.line;
        let pair = &line.pairs[p];
        let (gap, speed) = (&self.b[p + 1] - &self.b[p], &self.v[p] - &self.v[p + 1]);
        let sides = [(&self.b[p], &self.v[p]), (&self.b[p + 1], &self.v[p + 1])];
        let [left, right] = solved.unwrap_or_else(|| collided(pair, sides, &gap, &speed));
        let number = self.settled + 1;
        let points = (&line.points[p], &line.points[p + 1]);
        let lost = self.ledger.book(points, pair, (sides[0].1, sides[1].1), (&left.1, &right.1), number)?;
        if self.events.len() < bound.list {
            let time = &gap / &speed;
            let position = sides[0].0 + sides[0].1 * &time;
            self.events.push(Collision {
                pair: p + line.first,
                position: Value::Exact(position + line.contact_offset(p)),
                time: Value::Exact(time),
                before: [Value::Exact(self.v[p].clone()), Value::Exact(self.v[p + 1].clone())],
                after: [Value::Exact(left.1.clone()), Value::Exact(right.1.clone())],
                lost: Value::Exact(lost),
            });
        }
        for (k, (b, v)) in [(p, left), (p + 1, right)] {
            self.largest = self.largest.max(bits(&b)).max(bits(&v));
            (self.b[k], self.v[k]) = (b, v);
        }
        self.last = Last::Meeting(gap, speed);
        self.settled = number;
        if number.is_power_of_two() {
            self.growth.push((number, self.largest));
        }
        Ok(())
    }
}
