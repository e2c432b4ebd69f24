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
use crate::chain::replay::contact;
use crate::chain::replay::joined::settle;
use crate::chain::replay::ledger::LedgerFault;
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
    /// All pairs that meet when the first does, in order from the left, out of the heap.
    pub(super) fn take_instant(&mut self, first: usize, together: &mut Vec<usize>) {
        together.clear();
        while let Some(p) = self.queue.first()
            && self.order(p, first) == Ordering::Equal
        {
            together.push(p);
            self.place(p, false);
        }
        together.sort_unstable();
    }

    /// The soft runs around pairs that meet at one instant.
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

    /// A cluster of touching bodies, first and last, in which two pairs approach whose order is not determined.
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

    /// Plays a cluster in one order, where the order does not matter; else the run ends. Pairs that are not in the cluster go
    /// back into the heap.
    pub(super) fn play(
        &mut self,
        cluster: (usize, usize),
        together: &[usize],
        bound: &Bound,
    ) -> Result<Option<Stop>, LedgerFault> {
        let (ours, others): (Vec<usize>, Vec<usize>) =
            together.iter().partition(|p| (cluster.0..cluster.1).contains(*p));
        let Some(order) = contact::agreed(self.line, &self.v, cluster.0, cluster.1) else {
            let time = ours.first().and_then(|p| self.due_exactly(*p)).unwrap_or_default();
            return Ok(Some(Stop::Ambiguous { cluster, pairs: ours, time }));
        };
        self.free.get_or_insert(self.count);
        self.frees += 1;
        self.withdraw(cluster);
        for p in order {
            self.collide(p, bound)?;
        }
        for p in others {
            self.predict(p);
        }
        self.predict_around(cluster);
        Ok(None)
    }

    /// Whether the two points of pair `r` are at one place when pair `p` meets.
    fn touch(&self, r: usize, p: usize) -> bool {
        let ahead = self.near_b[r + 1].minus(self.near_b[r]);
        let drift = self.near_v[r + 1].minus(self.near_v[r]);
        if ahead.plus(drift.times(self.due[p])).sign().is_some_and(Ordering::is_ne) {
            return false;
        }
        let (gap, speed) = self.meeting(p);
        (&self.b[r + 1] - &self.b[r]) * speed + (&self.v[r + 1] - &self.v[r]) * gap == Rational::ZERO
    }
}
