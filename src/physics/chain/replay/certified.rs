//! The certified run: worldlines as enclosures, count and order still certain.
//!
//! **Why local certainty is enough.** A set of worldlines in which every corner is a collision that obeys the
//! laws, and neighbours never cross, is *the* motion from its start: by induction over its collisions in the
//! order of time. So the order of collisions far apart need not be decided, only what makes the worldlines
//! consistent. For the collision of points `p`, `p+1` at `T`, and likewise on the left:
//! - its time lies before the meeting of `p+1` and `p+2`, where these approach; and
//! - `p+2` had its last corner before `T`; or else its gap to `p+1` is positive at both times for all worldlines
//!   before and after both corners, hence, being linear, in between.
//!
//! Then the gap to `p+2` is positive up to `T` and the next meeting, computed from the new worldlines, is later
//! than both corners by itself. Times that follow one another on one pair are never compared: a heavy body that
//! sends a light one against a wall a million times needs the signs of velocities only.
//!
//! **Precision.** The run is repeated with more bits where a sign or an order stays open, up to
//! [`MAX_BITS`]; a true tie of neighbouring times stays open for ever and ends as a limit.
//!
//! **Values.** What happened is kept as a [`History`], which is evaluated when asked for.

use super::Collision;
use super::enclosure::Enclosure;
use super::exact::Run;
use super::history::{History, Rows};
use super::line::Line;
use super::queue::Queue;
use malachite::Rational;
use std::cmp::Ordering;

/// The most bits of an enclosure of the run.
pub(crate) const MAX_BITS: u64 = 4096;

/// Why a certified run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// Nothing approaches any more.
    Quiet,
    /// The next collision is later than the time asked for.
    Until,
    /// As many collisions as allowed, and another is due.
    Events,
}

/// A sign or an order that these enclosures leave open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Open;

/// A worldline since its last corner, and the one before.
#[derive(Clone)]
struct Worldline<E> {
    b: E,
    v: E,
    before: Option<(E, E)>,
    /// The time of the last corner and of the one before that.
    corner: Option<E>,
    corner_before: Option<E>,
    /// The pair of the last corner.
    pair: usize,
}

/// The state of the run.
pub(super) struct Certified<'a, E> {
    line: &'a Line,
    bits: u64,
    rows: Vec<Rows<E>>,
    points: Vec<Worldline<E>>,
    due: Vec<Option<E>>,
    queue: Queue,
    pub history: History,
    pub count: u64,
    pub events: Vec<Collision>,
}

impl<'a, E: Enclosure> Certified<'a, E> {
    /// Goes on from where an exact run stopped.
    pub(super) fn new(run: &Run<'a>, bits: u64) -> Certified<'a, E> {
        let line = run.line;
        let points = run.b.iter().zip(&run.v).map(|(b, v)| Worldline {
            b: E::of(b, bits),
            v: E::of(v, bits),
            before: None,
            corner: None,
            corner_before: None,
            pair: usize::MAX,
        });
        let mut this = Certified {
            line,
            bits,
            rows: line.pairs.iter().map(|p| Rows::of(p, bits)).collect(),
            points: points.collect(),
            due: vec![None; line.pairs.len()],
            queue: Queue::new(line.pairs.len()),
            history: History::default(),
            count: run.count(),
            events: run.events.clone(),
        };
        for p in 0..line.pairs.len() {
            let due = run.due_exactly(p).map(|t| E::of(&t, bits));
            this.set_due(p, due);
        }
        this
    }

    fn set_due(&mut self, p: usize, due: Option<E>) {
        self.due[p] = due;
        self.queue.set(p, self.due[p].as_ref().map(E::guess));
    }

    fn order(&self, a: &E, b: &E) -> Option<Ordering> {
        a.minus(b, self.bits).sign()
    }

    /// Runs until something ends it.
    pub(super) fn go(&mut self, events: u64, until: Option<&Rational>, list: usize) -> Result<End, Open> {
        let until = until.map(|t| E::of(t, self.bits));
        while let Some(first) = self.queue.first() {
            let (p, time) = self.earliest_near(first)?;
            if let Some(until) = &until {
                match self.order(&time, until) {
                    Some(Ordering::Greater) => {
                        // The heap is ordered by guesses: all others must be late, too.
                        for q in self.queue.present() {
                            let due = self.due[q].as_ref().ok_or(Open)?;
                            if self.order(due, until) != Some(Ordering::Greater) {
                                return Err(Open);
                            }
                        }
                        return Ok(End::Until);
                    }
                    Some(_) => {}
                    None => return Err(Open),
                }
            }
            if self.count >= events {
                return Ok(End::Events);
            }
            self.collide(p, time, list)?;
        }
        Ok(End::Quiet)
    }

    /// From the pair that seems first, down to one that certainly meets before its neighbours do.
    fn earliest_near(&self, mut p: usize) -> Result<(usize, E), Open> {
        loop {
            let time = self.due[p].as_ref().ok_or(Open)?;
            let mut next = None;
            for q in [p.checked_sub(1), Some(p + 1)].into_iter().flatten() {
                if let Some(Some(other)) = self.due.get(q) {
                    match self.order(time, other) {
                        Some(Ordering::Less) => {}
                        Some(Ordering::Greater) => next = Some(q),
                        _ => return Err(Open),
                    }
                }
            }
            match next {
                Some(q) => p = q,
                None => return Ok((p, time.clone())),
            }
        }
    }

    fn collide(&mut self, p: usize, time: E, list: usize) -> Result<(), Open> {
        let bits = self.bits;
        let (left, right) = (self.points[p].clone(), self.points[p + 1].clone());
        let (b, v) = (self.rows[p].apply(&left.b, &right.b, bits), self.rows[p].apply(&left.v, &right.v, bits));
        let corner = |old: &Worldline<E>, b: E, v: E| Worldline {
            b,
            v,
            before: Some((old.b.clone(), old.v.clone())),
            corner_before: old.corner.clone(),
            corner: Some(time.clone()),
            pair: p,
        };
        let (new_left, new_right) = (corner(&left, b.0, v.0), corner(&right, b.1, v.1));
        if let Some(outer) = p.checked_sub(1) {
            self.clear_of(outer, &self.points[outer], &left, &new_left, &time, Ordering::Less)?;
        }
        if let Some(outer) = self.points.get(p + 2) {
            self.clear_of(p + 1, outer, &right, &new_right, &time, Ordering::Greater)?;
        }
        self.count += 1;
        if self.events.len() < list {
            self.list(p, &time, (&left, &right), (&new_left, &new_right))?;
        }
        self.points[p] = new_left;
        self.points[p + 1] = new_right;
        self.history.push(p);
        self.set_due(p, None);
        for q in [p.checked_sub(1), Some(p + 1)].into_iter().flatten() {
            if q < self.due.len() {
                let due = self.meeting(q)?;
                self.set_due(q, due);
            }
        }
        Ok(())
    }

    /// When a pair meets from its current worldlines, whose gap is known not to be negative.
    fn meeting(&self, q: usize) -> Result<Option<E>, Open> {
        let (l, r) = (&self.points[q], &self.points[q + 1]);
        let closing = l.v.minus(&r.v, self.bits);
        match closing.sign() {
            None => Err(Open),
            Some(Ordering::Greater) => Ok(Some(r.b.minus(&l.b, self.bits).over(&closing, self.bits))),
            Some(_) => Ok(None),
        }
    }

    /// The outer neighbour over the pair `q` is apart from the inner body around the time of its new corner.
    fn clear_of(
        &self,
        q: usize,
        outer: &Worldline<E>,
        inner: &Worldline<E>,
        inner_after: &Worldline<E>,
        time: &E,
        side: Ordering,
    ) -> Result<(), Open> {
        let Some(corner) = &outer.corner else { return Ok(()) };
        if outer.pair == q || self.order(time, corner) == Some(Ordering::Greater) {
            return Ok(());
        }
        if let Some(earlier) = &outer.corner_before
            && self.order(time, earlier) != Some(Ordering::Greater)
        {
            return Err(Open);
        }
        let before = outer.before.as_ref().ok_or(Open)?;
        for (b, v) in [(&outer.b, &outer.v), (&before.0, &before.1)] {
            for inner in [inner, inner_after] {
                let (gap, drift) = (b.minus(&inner.b, self.bits), v.minus(&inner.v, self.bits));
                for at in [time, corner] {
                    if gap.plus(&drift.times(at, self.bits), self.bits).sign() != Some(side) {
                        return Err(Open);
                    }
                }
            }
        }
        Ok(())
    }

    fn list(
        &mut self,
        p: usize,
        time: &E,
        before: (&Worldline<E>, &Worldline<E>),
        after: (&Worldline<E>, &Worldline<E>),
    ) -> Result<(), Open> {
        let bits = self.bits;
        let offset = E::of(&self.line.contact_offset(p), bits);
        let position = before.0.b.plus(&before.0.v.times(time, bits), bits).plus(&offset, bits);
        let value = |x: &E| x.value().ok_or(Open);
        let loss = E::of(&self.line.loss_factor(p), bits);
        let closing = before.0.v.minus(&before.1.v, bits);
        self.events.push(Collision {
            pair: p + self.line.first,
            time: value(time)?,
            position: value(&position)?,
            before: [value(&before.0.v)?, value(&before.1.v)?],
            after: [value(&after.0.v)?, value(&after.1.v)?],
            lost: value(&loss.times(&closing.times(&closing, bits), bits))?,
        });
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::replay::bounds::Bounds;
    use crate::chain::replay::exact::{Bound, Stop};
    use crate::chain::replay::history::{Evaluated, evaluate};
    use crate::chain::replay::{Body, Wall};
    use crate::number::interval::Interval;

    fn small(seed: &mut u64, from: u64, to: u64) -> Rational {
        *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        Rational::from((*seed >> 33) % (to - from) + from)
    }

    fn scene(seed: u64) -> Line {
        let mut seed = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        let n = 2 + (seed >> 40) % 6;
        let mut at = Rational::from(0);
        let mut bodies = Vec::new();
        for _ in 0..n {
            at += small(&mut seed, 1, 40) / Rational::from(7);
            bodies.push(Body {
                mass: small(&mut seed, 1, 9),
                position: at.clone(),
                velocity: small(&mut seed, 0, 41) / Rational::from(5) - Rational::from(4),
                length: Rational::from(0),
            });
        }
        let e: Vec<Rational> = (1..n).map(|_| small(&mut seed, 5, 11) / Rational::from(10)).collect();
        let wall = |x| Wall { position: x, restitution: Rational::from(1) };
        let left = (seed & 64 == 0).then(|| wall(Rational::from(-1)));
        let right = (seed & 128 == 0).then(|| wall(at + Rational::from(2)));
        Line::new(&bodies, &e, left.as_ref(), right.as_ref()).expect("a valid line")
    }

    /// The exact run is the oracle: same order, same count, its values inside the enclosures.
    fn agrees<E: Enclosure>(bits: u64) {
        let mut open = 0;
        for seed in 1..400 {
            let line = scene(seed);
            let mut exact = Run::new(&line);
            let bound = Bound { events: 120, until: None, list: 120, bits: None, through: false };
            let stop = exact.go(&bound).expect("the ledger holds");
            assert!(!exact.settle(&bound).expect("the ledger holds"), "numbers may have any size");
            if !matches!(stop, Stop::Quiet | Stop::Events) || exact.count() > 120 {
                continue;
            }
            let start = Run::new(&line);
            let mut certified: Certified<E> = Certified::new(&start, bits);
            match certified.go(120, None, 120) {
                Err(Open) => open += 1,
                Ok(end) => {
                    // Far apart, collisions at nearly one time may be listed in another order.
                    let mut left: Vec<usize> = exact.events.iter().map(|c| c.pair).collect();
                    let mut right: Vec<usize> = certified.events.iter().map(|c| c.pair).collect();
                    left.sort_unstable();
                    right.sort_unstable();
                    assert_eq!(left, right, "scene {seed}");
                    assert_eq!(certified.count, exact.count(), "scene {seed}");
                    let quiet = matches!(stop, Stop::Quiet);
                    assert_eq!(end == End::Quiet, quiet, "scene {seed}");
                    for (b, v) in certified.points.iter().zip(&exact.v) {
                        let Some(value) = b.v.value() else { continue };
                        let (lo, hi) = value.enclose(0);
                        assert!(lo <= *v && *v <= hi, "scene {seed}: {v} outside");
                    }
                    for bits in [64, 200] {
                        let again: Evaluated<Interval> = evaluate(&start, &certified.history, bits);
                        for (x, v) in again.v.iter().zip(&exact.v).chain(again.b.iter().zip(&exact.b)) {
                            assert!(x.contains(v), "scene {seed} at {bits} bits");
                        }
                    }
                    let again: Evaluated<Rational> = evaluate(&start, &certified.history, 0);
                    assert_eq!((again.b, again.v), (exact.b.clone(), exact.v.clone()), "scene {seed}");
                }
            }
        }
        println!("{open} scenes left open");
        assert!(open < 40, "{open} scenes left open");
    }

    #[test]
    fn doubles_agree_with_the_exact_run() {
        agrees::<Bounds>(53);
    }

    #[test]
    fn intervals_agree_with_the_exact_run() {
        agrees::<Interval>(256);
    }
}
