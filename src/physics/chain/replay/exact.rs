//! The exact run: rational worldlines, ordered by doubles with a proved error as long as these tell.
//!
//! **State.** A body moves on `x = b + v·t` until it collides; the state is the intercept `b` and the velocity
//! `v` of each worldline, no positions and no clock. A collision of neighbours multiplies `(v_l, v_r)` by the
//! transfer matrix `M`. It multiplies the intercepts by the same matrix: both bodies are at the same place `x`
//! at the time `t`, `M` fixes `(1, 1)`, so `x·(1,1) − t·M·v = M·(x·(1,1) − t·v)`. Times never enter the state,
//! only quotients of it leave; a collision touches two bodies, and numbers grow with the masses and restitutions
//! on a body's causal past.
//!
//! **Events.** A pair that approaches meets at `t = (b_r − b_l)/(v_l − v_r)`. The same state in doubles with a proved
//! error (`near`) encloses each such time. A heap holds one entry a pair, by the lower end. Pairs whose time may be the
//! least are the first and those that begin before the earliest of their upper ends; where they are several,
//! cross-multiplied exact fractions decide among them. So does the exact sign of a speed that doubles leave open.
//!
//! **Exact numbers on demand.** Collisions wait in a `backlog` until an exact number is asked for. A comparison asks for the
//! past of its own points. Everything else settles the whole backlog: contacts whose order may matter, bodies that stick,
//! collisions that may accumulate, and the end.
//!
//! **Instants.** All pairs that meet at the least time are taken together (`instant`).
//!
//! **Cost.** `O(log n)` comparisons of doubles and a fixed number of operations in doubles a collision; as many exact
//! ones, those of the ledger included, when it is settled. Memory: the state, the heap, the backlog, the listed collisions.

mod accumulation;
mod backlog;
mod instant;

use super::bounds::Bounds;
use super::collapse::{self, Collapse};
use super::joined::{Cause, Joined};
use super::ledger::{Ledger, LedgerFault};
use super::line::Line;
use super::near::{Course, Near};
use super::queue::Queue;
use super::{Collision, Value};
use backlog::Backlog;
use malachite::Rational;
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
    /// Intercepts of the worldlines, settled.
    pub b: Vec<Rational>,
    /// Velocities, settled.
    pub v: Vec<Rational>,
    /// What doubles know of the present state.
    near: Vec<Course>,
    due: Vec<Bounds>,
    queue: Queue,
    backlog: Backlog,
    /// For the point in the middle of three: collisions in a row, its left and right pair in turn, that nothing
    /// outside the three disturbed, and the pair of the last.
    streak: Vec<(u32, u32)>,
    /// Whether the collisions of three can accumulate, by their middle, where that was asked.
    contracts: Vec<Option<bool>>,
    /// The pairs of the last collisions.
    recent: Vec<usize>,
    pub ledger: Ledger,
    /// How many collisions are settled.
    settled: u64,
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
            near: line.points.iter().map(|p| p.near).collect(),
            b,
            v,
            due: vec![Bounds::WHOLE; line.pairs.len()],
            queue: Queue::new(line.pairs.len()),
            backlog: Backlog::new(n),
            streak: vec![(0, u32::MAX); n],
            contracts: vec![None; n],
            recent: Vec::new(),
            ledger: Ledger::default(),
            settled: 0,
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

    /// How many collisions there were.
    pub(super) fn count(&self) -> u64 {
        self.settled + self.backlog.len()
    }

    /// What doubles know of the velocity of a point.
    pub(super) fn velocity(&self, k: usize) -> Bounds {
        self.near[k].v().bounds()
    }

    /// Holds the sums over all bodies against the start, as far as doubles tell: momentum, which only walls change, and
    /// energy, which never grows.
    pub(super) fn check_sums(&self) -> Result<(), LedgerFault> {
        let zero = Bounds { lo: 0.0, hi: 0.0 };
        let (mut momentum, mut energy) = (zero, zero);
        for (point, course) in self.line.points.iter().zip(&self.near) {
            let Some(mass) = &point.mass else { continue };
            let (before, after) = (point.near.v().bounds(), course.v().bounds());
            let given = Near::of(mass).bounds().times(after.minus(before));
            momentum = momentum.plus(given);
            energy = energy.plus(given.times(after.plus(before)));
        }
        let walls = self.line.has_left_wall() || self.line.has_right_wall();
        let fault = |law| Err(LedgerFault { law, collision: None });
        match (momentum.sign(), energy.sign()) {
            (Some(Ordering::Less | Ordering::Greater), _) if !walls => fault("momentum"),
            (_, Some(Ordering::Greater)) => fault("energy"),
            _ => Ok(()),
        }
    }

    /// Replays until something ends it. Where that is not a collapse or a contact, the last collisions are not settled.
    pub(super) fn go(&mut self, bound: &Bound) -> Result<Stop, LedgerFault> {
        self.backlog.most_bits = bound.bits.unwrap_or(u64::MAX);
        let mut together = Vec::new();
        loop {
            if self.queue.first().is_none() {
                return Ok(Stop::Quiet);
            }
            if self.backlog.is_due() && self.settle(bound)? {
                return Ok(Stop::Grown);
            }
            self.take_instant(&mut together);
            if let Some(until) = bound.until
                && self.later_than(together[0], until)
            {
                return Ok(Stop::Until);
            }
            if self.count() >= bound.events {
                return Ok(Stop::Events);
            }
            let soft = self.soft && together.iter().any(|p| self.line.pairs[*p].restitution == Rational::ZERO);
            let clash = together.len() > 1 && self.may_clash(&together);
            if (soft || clash) && self.settle(bound)? || self.backlog.len() == 0 && self.has_grown() {
                return Ok(Stop::Grown);
            }
            let runs = if soft { self.soft_runs(&together) } else { Vec::new() };
            if clash && let Some(cluster) = self.clash(&together, &runs) {
                match self.play(cluster, &together) {
                    Some(stop) => return Ok(stop),
                    None => continue,
                }
            }
            let blocks = self.join_runs(&runs, &mut together, bound)?;
            // An instant is finished even where it passes the limit: its collisions belong together.
            let several = together.len() + blocks.len() > 1;
            self.simultaneous += u64::from(several && together.is_empty());
            for (i, p) in together.iter().enumerate() {
                self.collide(*p, i == 0, several && i == 0);
            }
            for p in &together {
                self.predict_beside(*p);
            }
            for block in &blocks {
                self.predict_around(*block);
            }
            if let Some(stop) = self.accumulation(&together, bound)? {
                return Ok(stop);
            }
        }
    }

    /// Whether settled numbers have more bits than allowed.
    fn has_grown(&self) -> bool {
        self.largest > self.backlog.most_bits
    }

    /// The pairs that a change of the points `first ..= last` concerns.
    fn around(&self, (first, last): (usize, usize)) -> std::ops::RangeInclusive<usize> {
        first.saturating_sub(1)..=last.min(self.line.pairs.len() - 1)
    }

    /// Looks when the pairs of these points meet next.
    fn predict_around(&mut self, points: (usize, usize)) {
        for q in self.around(points) {
            self.predict(q);
        }
    }

    /// Looks when the points of a pair that has collided meet others next: each other they do not approach.
    fn predict_beside(&mut self, p: usize) {
        self.queue.set(p, None);
        if p > 0 {
            self.predict(p - 1);
        }
        if p + 1 < self.line.pairs.len() {
            self.predict(p + 1);
        }
    }

    /// Puts the points `first ..= last` on one worldline, that of their centre of mass, or of the wall among them; the state is settled.
    fn join(
        &mut self,
        (first, last): (usize, usize),
        time: Value,
        cause: Cause,
        bound: &Bound,
    ) -> Result<(), LedgerFault> {
        let (b, v) = collapse::centre(self.line, &self.b, &self.v, first..=last);
        let lost = self.ledger.book_joined(&self.line.points[first..=last], &self.v[first..=last], &v, self.settled)?;
        self.joins += 1;
        if self.events.len() as u64 == self.settled && self.joined.len() < bound.list {
            self.joined.push(Joined {
                after: self.settled,
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
            self.near[k] = Course::of(&b, &v);
        }
        self.largest = self.largest.max(bits(&b)).max(bits(&v));
        for k in first.saturating_sub(1)..=(last + 1).min(self.line.points.len() - 1) {
            self.streak[k] = (0, u32::MAX);
        }
        self.recent.clear();
        self.last = Last::Joined(time);
        Ok(())
    }

    /// When the pair meets, if it approaches; the state is settled.
    pub(crate) fn due_exactly(&self, p: usize) -> Option<Rational> {
        let speed = &self.v[p] - &self.v[p + 1];
        (speed > Rational::ZERO).then(|| (&self.b[p + 1] - &self.b[p]) / speed)
    }

    /// The time of what happened last; the state is settled.
    pub(super) fn time(&self) -> Value {
        match &self.last {
            Last::Start => Value::Exact(Rational::ZERO),
            Last::Meeting(gap, speed) => Value::Exact(gap / speed),
            Last::Joined(time) => time.clone(),
        }
    }

    fn later_than(&mut self, p: usize, until: &Rational) -> bool {
        let near = self.due[p].order(Bounds::of(until));
        near.unwrap_or_else(|| {
            let (gap, speed) = self.meeting(p);
            gap.cmp(&(speed * until))
        }) == Ordering::Greater
    }

    /// Puts the pair's next meeting into the heap, or takes it out.
    fn predict(&mut self, p: usize) {
        let speed = self.near[p].v().less(self.near[p + 1].v());
        match speed.sign() {
            Some(Ordering::Greater) => {
                self.due[p] = self.near[p + 1].b().less(self.near[p].b()).over(speed);
                self.queue.set(p, Some(self.due[p].lo));
            }
            Some(_) => self.queue.set(p, None),
            None => {
                let approaching = self.meeting(p).1 > Rational::ZERO;
                self.queue.set(p, approaching.then_some(self.due[p].lo));
            }
        }
    }

    /// A collision: the doubles follow at once, the exact numbers when asked for.
    fn collide(&mut self, p: usize, begins: bool, simultaneous: bool) {
        (self.near[p], self.near[p + 1]) = Course::after(&self.line.pairs[p].near, &self.near[p], &self.near[p + 1]);
        self.backlog.push(p, begins, simultaneous);
        self.recent.push(p);
        for k in [p, p + 1] {
            let (streak, last) = self.streak[k];
            self.streak[k] = (if streak > 0 && last != p as u32 { streak + 1 } else { 1 }, p as u32);
        }
        if p > 0 {
            self.streak[p - 1].0 = 0;
        }
        if let Some(outer) = self.streak.get_mut(p + 2) {
            outer.0 = 0;
        }
    }
}

/// The bits of the larger of numerator and denominator.
pub(super) fn bits(x: &Rational) -> u64 {
    x.numerator_ref().significant_bits().max(x.denominator_ref().significant_bits())
}
