//! The exact run: rational worldlines, times compared by enclosures first.
//!
//! **State.** A body moves on `x = b + v·t` until it collides; the state is the intercept `b` and the velocity
//! `v` of each worldline, no positions and no clock. A collision of neighbours multiplies `(v_l, v_r)` by the
//! transfer matrix `M`. It multiplies the intercepts by the same matrix: both bodies are at the same place `x`
//! at the time `t`, `M` fixes `(1, 1)`, so `x·(1,1) − t·M·v = M·(x·(1,1) − t·v)`. Times never enter the state,
//! only quotients of it leave; a collision touches two bodies, and numbers grow with the masses and restitutions
//! on a body's causal past.
//!
//! **Events.** A pair that approaches meets at `t = (b_r − b_l)/(v_l − v_r)`. A heap holds one entry a pair,
//! ordered by enclosures of `t`; where two overlap, cross-multiplied exact fractions decide.
//!
//! **Instants.** All pairs that meet at the least time are taken together (`instant`).
//!
//! **Cost.** `O(log n)` comparisons of doubles and a fixed number of exact operations a collision, those of the
//! ledger included. Memory: the state, the heap, the listed collisions.

mod accumulation;
mod instant;

use super::bounds::Bounds;
use super::collapse::{self, Collapse};
use super::joined::{Cause, Joined};
use super::ledger::{Ledger, LedgerFault};
use super::line::Line;
use super::queue::Queue;
use super::{Collision, Value};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::NegAssign;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;
use std::cmp::Ordering;

/// Why the exact run ended.
#[derive(Clone, Debug)]
pub(super) enum Stop {
    /// Nothing approaches any more.
    Quiet,
    /// The next collision is later than the time asked for.
    Until,
    /// As many collisions as allowed, and another is due.
    Events,
    /// Numbers of more bits than allowed.
    Grown,
    /// Pairs of touching bodies that would collide at one instant.
    Ambiguous {
        /// The cluster of points, first and last.
        cluster: (usize, usize),
        /// The pairs that approach.
        pairs: Vec<usize>,
        /// The instant.
        time: Rational,
    },
    /// Infinitely many collisions before a finite time, proved.
    Collapse(Box<Collapse>),
}

/// What the run may do.
#[derive(Clone, Debug)]
pub(super) struct Bound<'a> {
    pub events: u64,
    pub until: Option<&'a Rational>,
    pub list: usize,
    pub bits: Option<u64>,
    /// Whether to go on from a proved collapse.
    pub through: bool,
}

/// What happened last, which gives its time.
#[derive(Clone, Debug)]
enum Last {
    /// Nothing yet.
    Start,
    /// A collision: a gap over a speed.
    Meeting(Rational, Rational),
    /// Bodies came together.
    Joined(Value),
}

/// The state of the run.
#[derive(Clone)]
pub(super) struct Run<'a> {
    pub line: &'a Line,
    /// Intercepts of the worldlines.
    pub b: Vec<Rational>,
    /// Velocities.
    pub v: Vec<Rational>,
    near_b: Vec<Bounds>,
    near_v: Vec<Bounds>,
    due: Vec<Bounds>,
    queue: Queue,
    /// For the point in the middle of three: collisions in a row, its left and right pair in turn, that nothing
    /// outside the three disturbed.
    streak: Vec<u32>,
    last_pair: Vec<usize>,
    /// The pairs of the last collisions.
    recent: Vec<usize>,
    pub ledger: Ledger,
    pub count: u64,
    pub events: Vec<Collision>,
    /// Instants with more than one collision of separate pairs.
    pub simultaneous: u64,
    /// Contacts at which several orders of collisions agreed, and the collisions before the first of them.
    pub frees: u64,
    pub free: Option<u64>,
    /// The most bits of a numerator or denominator, after each doubling of the count.
    pub growth: Vec<(u64, u64)>,
    pub largest: u64,
    /// Bodies that came together, those that are listed.
    pub joined: Vec<Joined>,
    /// How often bodies came together.
    pub joins: u64,
    /// Whether a pair has restitution 0.
    soft: bool,
    last: Last,
}

impl<'a> Run<'a> {
    /// The state at time 0, with what is due.
    pub(super) fn new(line: &'a Line) -> Run<'a> {
        let n = line.points.len();
        let b: Vec<Rational> = line.points.iter().map(|p| p.position.clone()).collect();
        let v: Vec<Rational> = line.points.iter().map(|p| p.velocity.clone()).collect();
        let largest = b.iter().chain(&v).map(bits).max().unwrap_or(0);
        let mut run = Run {
            line,
            near_b: b.iter().map(Bounds::of).collect(),
            near_v: v.iter().map(Bounds::of).collect(),
            b,
            v,
            due: vec![Bounds::WHOLE; line.pairs.len()],
            queue: Queue::new(line.pairs.len()),
            streak: vec![0; n],
            last_pair: vec![usize::MAX; n],
            recent: Vec::new(),
            ledger: Ledger::default(),
            count: 0,
            events: Vec::new(),
            simultaneous: 0,
            frees: 0,
            free: None,
            growth: vec![(0, largest)],
            largest,
            joined: Vec::new(),
            joins: 0,
            soft: line.pairs.iter().any(|p| p.restitution == Rational::ZERO),
            last: Last::Start,
        };
        for p in 0..line.pairs.len() {
            run.predict(p);
        }
        run
    }

    /// Replays until something ends it.
    pub(super) fn go(&mut self, bound: &Bound) -> Result<Stop, LedgerFault> {
        let mut together = Vec::new();
        loop {
            let Some(first) = self.queue.first() else { return Ok(Stop::Quiet) };
            if let Some(until) = bound.until
                && self.later_than(first, until)
            {
                return Ok(Stop::Until);
            }
            if self.count >= bound.events {
                return Ok(Stop::Events);
            }
            if bound.bits.is_some_and(|most| self.largest > most) {
                return Ok(Stop::Grown);
            }
            self.take_instant(first, &mut together);
            let runs = if self.soft { self.soft_runs(&together) } else { Vec::new() };
            if let Some(cluster) = self.clash(&together, &runs) {
                match self.play(cluster, &together, bound)? {
                    Some(stop) => return Ok(stop),
                    None => continue,
                }
            }
            // What is about to change leaves the heap first: an order must not change under it.
            for p in &together {
                self.withdraw((*p, p + 1));
            }
            let mut blocks: Vec<(usize, usize)> = Vec::new();
            if runs.iter().any(|run| !run.strained && !run.blocks.is_empty()) {
                blocks.extend(runs.iter().filter(|run| !run.strained).flat_map(|run| &run.blocks));
                let (gap, speed) = self.meeting(first);
                let now = Value::Exact(gap / speed);
                for block in &blocks {
                    self.withdraw(*block);
                }
                for block in &blocks {
                    self.join(*block, now.clone(), Cause::Inelastic, bound)?;
                }
                together.retain(|p| !blocks.iter().any(|block| (block.0..block.1).contains(p)));
            }
            self.simultaneous += u64::from(together.len() + blocks.len() > 1);
            // An instant is finished even where it passes the limit: its collisions belong together.
            for p in &together {
                self.collide(*p, bound)?;
            }
            for p in &together {
                self.predict_around((*p, p + 1));
            }
            for block in &blocks {
                self.predict_around(*block);
            }
            for p in &together {
                for middle in [*p, p + 1] {
                    if self.streak[middle] >= 4
                        && self.streak[middle].is_power_of_two()
                        && let Some(found) = self.collapse_at(middle, bound.until)
                        && let Some(stop) = self.collapsed(found, bound)?
                    {
                        return Ok(stop);
                    }
                }
            }
            if let Some(found) = self.pattern(bound.until)
                && let Some(stop) = self.collapsed(found, bound)?
            {
                return Ok(stop);
            }
        }
    }

    /// The pairs that a change of the points `first ..= last` concerns.
    fn around(&self, (first, last): (usize, usize)) -> std::ops::RangeInclusive<usize> {
        first.saturating_sub(1)..=last.min(self.line.pairs.len() - 1)
    }

    /// Takes the pairs of these points out of the heap.
    fn withdraw(&mut self, points: (usize, usize)) {
        for q in self.around(points) {
            self.place(q, false);
        }
    }

    /// Looks when the pairs of these points meet next.
    fn predict_around(&mut self, points: (usize, usize)) {
        for q in self.around(points) {
            self.predict(q);
        }
    }

    /// Puts the points `first ..= last` on one worldline, that of their centre of mass, or of the wall among them.
    fn join(
        &mut self,
        (first, last): (usize, usize),
        time: Value,
        cause: Cause,
        bound: &Bound,
    ) -> Result<(), LedgerFault> {
        let (b, v) = collapse::centre(self.line, &self.b, &self.v, first..=last);
        let lost = self.ledger.book_joined(&self.line.points[first..=last], &self.v[first..=last], &v, self.count)?;
        self.joins += 1;
        if self.events.len() as u64 == self.count && self.joined.len() < bound.list {
            self.joined.push(Joined {
                after: self.count,
                cause,
                bodies: (first + self.line.first, last + self.line.first),
                position: time.times(&v).plus(&(&b + self.line.contact_offset(first))),
                time: time.clone(),
                before: [self.v[first].clone(), self.v[last].clone()],
                velocity: v.clone(),
                lost,
            });
        }
        for k in first..=last {
            self.b[k].clone_from(&b);
            self.v[k].clone_from(&v);
            self.near_b[k] = Bounds::of(&b);
            self.near_v[k] = Bounds::of(&v);
        }
        self.largest = self.largest.max(bits(&b)).max(bits(&v));
        for k in first.saturating_sub(1)..=(last + 1).min(self.line.points.len() - 1) {
            self.streak[k] = 0;
            self.last_pair[k] = usize::MAX;
        }
        self.recent.clear();
        self.last = Last::Joined(time);
        Ok(())
    }

    /// When the pair meets: a gap over a speed, both positive or the gap zero.
    fn meeting(&self, p: usize) -> (Rational, Rational) {
        (&self.b[p + 1] - &self.b[p], &self.v[p] - &self.v[p + 1])
    }

    /// When the pair meets, if it approaches.
    pub(crate) fn due_exactly(&self, p: usize) -> Option<Rational> {
        let (gap, speed) = self.meeting(p);
        (speed > Rational::ZERO).then(|| gap / speed)
    }

    /// The time of what happened last.
    pub(super) fn time(&self) -> Value {
        match &self.last {
            Last::Start => Value::Exact(Rational::ZERO),
            Last::Meeting(gap, speed) => Value::Exact(gap / speed),
            Last::Joined(time) => time.clone(),
        }
    }

    /// Which of two pairs meets first.
    fn order(&self, p: usize, q: usize) -> Ordering {
        if p == q {
            return Ordering::Equal;
        }
        self.due[p].order(self.due[q]).unwrap_or_else(|| {
            let ((gap_p, speed_p), (gap_q, speed_q)) = (self.meeting(p), self.meeting(q));
            (gap_p * speed_q).cmp(&(gap_q * speed_p))
        })
    }

    fn later_than(&self, p: usize, until: &Rational) -> bool {
        let near = self.due[p].order(Bounds::of(until));
        near.unwrap_or_else(|| {
            let (gap, speed) = self.meeting(p);
            gap.cmp(&(speed * until))
        }) == Ordering::Greater
    }

    /// Puts the pair's next meeting into the heap, or takes it out.
    fn predict(&mut self, p: usize) {
        let speed = self.near_v[p].minus(self.near_v[p + 1]);
        let approaching = match speed.sign() {
            Some(sign) => sign == Ordering::Greater,
            None => self.v[p] > self.v[p + 1],
        };
        if approaching {
            let near = self.near_b[p + 1].minus(self.near_b[p]).over(speed);
            // Far from the origin the difference of enclosures may be wide: then from exact differences.
            self.due[p] = if near.hi - near.lo <= near.hi.abs() * 1e-9 {
                near
            } else {
                let (gap, speed) = self.meeting(p);
                Bounds::of(&gap).over(Bounds::of(&speed))
            };
        }
        self.place(p, approaching);
    }

    fn place(&mut self, p: usize, present: bool) {
        let mut queue = std::mem::replace(&mut self.queue, Queue::new(0));
        queue.set(p, present, |a, b| match self.order(a, b) {
            Ordering::Equal => a < b,
            order => order == Ordering::Less,
        });
        self.queue = queue;
    }

    fn collide(&mut self, p: usize, bound: &Bound) -> Result<(), LedgerFault> {
        let line = self.line;
        let pair = &line.pairs[p];
        let (gap, speed) = self.meeting(p);
        let left = &self.v[p] - &pair.left * &speed;
        let right = &self.v[p + 1] + &pair.right * &speed;
        let number = self.count + 1;
        let sides = (&line.points[p], &line.points[p + 1]);
        let lost = self.ledger.book(sides, pair, (&self.v[p], &self.v[p + 1]), (&left, &right), number)?;
        if self.events.len() < bound.list {
            let time = &gap / &speed;
            let position = &self.b[p] + &self.v[p] * &time;
            self.events.push(Collision {
                pair: p + line.first,
                position: Value::Exact(position + line.contact_offset(p)),
                time: Value::Exact(time),
                before: [Value::Exact(self.v[p].clone()), Value::Exact(self.v[p + 1].clone())],
                after: [Value::Exact(left.clone()), Value::Exact(right.clone())],
                lost: Value::Exact(lost),
            });
        }
        let mut back = gap.clone();
        back.neg_assign();
        // The intercepts change as the velocities do: by b_l − b_r in place of v_l − v_r.
        self.b[p] -= &pair.left * &back;
        self.b[p + 1] += &pair.right * back;
        self.v[p] = left;
        self.v[p + 1] = right;
        self.last = Last::Meeting(gap, speed);
        self.count = number;
        self.recent.push(p);
        for k in [p, p + 1] {
            self.near_b[k] = Bounds::of(&self.b[k]);
            self.near_v[k] = Bounds::of(&self.v[k]);
            self.largest = self.largest.max(bits(&self.b[k])).max(bits(&self.v[k]));
            let in_turn = self.streak[k] > 0 && self.last_pair[k] != p;
            self.streak[k] = if in_turn { self.streak[k] + 1 } else { 1 };
            self.last_pair[k] = p;
        }
        if p > 0 {
            self.streak[p - 1] = 0;
        }
        if let Some(outer) = self.streak.get_mut(p + 2) {
            *outer = 0;
        }
        if number.is_power_of_two() {
            self.growth.push((number, self.largest));
        }
        Ok(())
    }
}

/// The bits of the larger of numerator and denominator.
pub(super) fn bits(x: &Rational) -> u64 {
    x.numerator_ref().significant_bits().max(x.denominator_ref().significant_bits())
}
