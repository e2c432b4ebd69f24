//! What happens at one instant: the pairs that meet, and whether their order matters.
//!
//! All pairs that meet at the least time are taken together. Two of them within one cluster of touching bodies leave
//! the order undetermined. Where all orders lead to the same velocities by equally many collisions (`contact`), one of them is
//! played; else the outcome is undetermined as well, and the run stops as ambiguous. Pairs of different clusters are independent.
//!
//! A pair that touches and approaches after that meets at the same instant, by the same rule: a neighbour was hit while
//! they touched. Gaps that are too small to matter behave alike.
//!
//! **Restitution 0.** Points that touch, all their pairs with restitution 0, are one *soft run*. The end of their
//! collisions does not depend on the order (`joined`), so several approaching pairs of one run are not ambiguous. Three or
//! more points that end with one velocity have collided infinitely often. They are joined, which is listed apart and counts
//! no collision.
//!
//! One thing can make a run depend on the order: a touching pair at its edge with a restitution above 0 that would approach
//! before the run is at its end. Then the run is no longer taken as a whole, and the rule for instants applies.

use super::{Bound, Run, Stop};
use crate::chain::replay::joined::{Cause, settle};
use crate::chain::replay::ledger::LedgerFault;
use crate::chain::replay::{Value, contact};
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
use std::cmp::Ordering;

/// Touching points whose pairs all have restitution 0, some of them approaching.
pub(super) struct SoftRun {
    /// The pairs, first and last.
    pub(super) pairs: (usize, usize),
    /// Points that end with one velocity after infinitely many collisions, first and last of each block.
    pub(super) blocks: Vec<(usize, usize)>,
    /// Whether a touching pair at an edge, with a restitution above 0, would approach at the end.
    pub(super) strained: bool,
}

impl Run<'_> {
    /// All pairs that meet first, in order from the left; the heap is not empty.
    pub(super) fn take_instant(&mut self, together: &mut Vec<usize>) {
        together.clear();
        let latest = |run: &Self, list: &[usize]| list.iter().map(|p| run.due[*p].hi).fold(f64::INFINITY, f64::min);
        let bound = self.queue.first().map_or(f64::INFINITY, |p| self.due[p].hi);
        self.queue.up_to(bound, together);
        if together.len() > 1 {
            let bound = latest(self, together);
            together.retain(|p| self.due[*p].lo <= bound);
        }
        if together.len() > 1 {
            self.earliest(together);
        }
    }

    /// Of pairs that doubles do not order, those that meet first, exactly.
    fn earliest(&mut self, pairs: &mut Vec<usize>) {
        let mut first: Option<(Rational, Rational)> = None;
        let mut earliest = Vec::new();
        for p in pairs.drain(..) {
            let (gap, speed) = self.meeting(p);
            self.queue.set(p, Some(self.due[p].lo));
            let order = first.as_ref().map_or(Ordering::Less, |(g, s)| (&gap * s).cmp(&(g * &speed)));
            if order == Ordering::Less {
                earliest.clear();
                first = Some((gap, speed));
            }
            if order != Ordering::Greater {
                earliest.push(p);
            }
        }
        earliest.sort_unstable();
        *pairs = earliest;
    }

    /// The soft runs around pairs that meet at one instant; the state is settled.
    pub(super) fn soft_runs(&self, together: &[usize]) -> Vec<SoftRun> {
        let is_soft = |q: usize| self.line.pairs[q].restitution == Rational::ZERO;
        let mut runs: Vec<SoftRun> = Vec::new();
        for p in together.iter().copied().filter(|p| is_soft(*p)) {
            if runs.last().is_some_and(|run| p <= run.pairs.1) {
                continue;
            }
            let end = self.line.pairs.len();
            let touching = |q: usize| together.binary_search(&q).is_ok() || self.touch(q, p);
            let mut pairs = (p, p);
            while pairs.0 > 0 && is_soft(pairs.0 - 1) && touching(pairs.0 - 1) {
                pairs.0 -= 1;
            }
            while pairs.1 + 1 < end && is_soft(pairs.1 + 1) && touching(pairs.1 + 1) {
                pairs.1 += 1;
            }
            let settled = settle(self.line, &self.v, pairs.0, pairs.1 + 1);
            let left = pairs.0 > 0
                && settled.first().is_some_and(|block| self.v[pairs.0 - 1] > block.velocity())
                && touching(pairs.0 - 1);
            let right = pairs.1 + 1 < end
                && settled.last().is_some_and(|block| block.velocity() > self.v[pairs.1 + 2])
                && touching(pairs.1 + 1);
            let blocks = settled.iter().map(|block| block.points).filter(|points| points.1 > points.0 + 1).collect();
            runs.push(SoftRun { pairs, blocks, strained: left || right });
        }
        runs
    }

    /// Whether two of the pairs may belong to one cluster of touching bodies.
    pub(super) fn may_clash(&self, together: &[usize]) -> bool {
        together.windows(2).any(|w| (w[0] + 1..w[1]).all(|r| !self.apart(r, w[0])))
    }

    /// A cluster of touching bodies, first and last, in which two pairs approach whose order is not determined; the state
    /// is settled.
    pub(super) fn clash(&self, together: &[usize], runs: &[SoftRun]) -> Option<(usize, usize)> {
        let settled = |w: &[usize]| runs.iter().any(|run| !run.strained && run.pairs.0 <= w[0] && w[1] <= run.pairs.1);
        let clash = together.windows(2).find(|w| !settled(w) && (w[0] + 1..w[1]).all(|r| self.touch(r, w[0])))?;
        let from = clash[0];
        let mut cluster = (from, from + 1);
        while cluster.0 > 0 && (together.contains(&(cluster.0 - 1)) || self.touch(cluster.0 - 1, from)) {
            cluster.0 -= 1;
        }
        while cluster.1 < self.line.pairs.len() && (together.contains(&cluster.1) || self.touch(cluster.1, from)) {
            cluster.1 += 1;
        }
        Some(cluster)
    }

    /// Plays a cluster in one order, where the order does not matter; else the run ends. The state is settled.
    pub(super) fn play(&mut self, cluster: (usize, usize), together: &[usize]) -> Option<Stop> {
        let Some(order) = contact::agreed(self.line, &self.v, cluster.0, cluster.1) else {
            let pairs: Vec<usize> = together.iter().copied().filter(|p| (cluster.0..cluster.1).contains(p)).collect();
            let time = pairs.first().and_then(|p| self.due_exactly(*p)).unwrap_or_default();
            return Some(Stop::Ambiguous { cluster, pairs, time });
        };
        self.free.get_or_insert(self.settled);
        self.frees += 1;
        for (i, p) in order.into_iter().enumerate() {
            self.collide(p, i == 0, false);
        }
        self.predict_around(cluster);
        None
    }

    /// Joins the blocks of soft runs that nothing strains, and takes their pairs from the list. The state is settled.
    pub(super) fn join_runs(
        &mut self,
        runs: &[SoftRun],
        together: &mut Vec<usize>,
        bound: &Bound,
    ) -> Result<Vec<(usize, usize)>, LedgerFault> {
        let blocks: Vec<_> = runs.iter().filter(|run| !run.strained).flat_map(|run| run.blocks.clone()).collect();
        if let Some(now) = together.first().filter(|_| !blocks.is_empty()).and_then(|p| self.due_exactly(*p)) {
            for block in &blocks {
                self.join(*block, Value::Exact(now.clone()), Cause::Inelastic, bound)?;
            }
            together.retain(|p| !blocks.iter().any(|block| (block.0..block.1).contains(p)));
        }
        Ok(blocks)
    }

    /// Whether doubles show that the two points of pair `r` are at two places when pair `p` meets.
    fn apart(&self, r: usize, p: usize) -> bool {
        let (left, right) = (&self.near[r], &self.near[r + 1]);
        let (ahead, drift) = (right.b().less(left.b()).bounds(), right.v().less(left.v()).bounds());
        ahead.plus(drift.times(self.due[p])).sign().is_some_and(Ordering::is_ne)
    }

    /// Whether the two points of pair `r` are at one place when pair `p` meets; the state is settled.
    fn touch(&self, r: usize, p: usize) -> bool {
        let gap = |q: usize| &self.b[q + 1] - &self.b[q];
        let drift = |q: usize| &self.v[q + 1] - &self.v[q];
        !self.apart(r, p) && gap(r) * drift(p) == drift(r) * gap(p)
    }
}
