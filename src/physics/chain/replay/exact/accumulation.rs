//! Collisions that accumulate: a collapse that is proved, that nothing disturbs, and that ends the run or joins bodies.

use super::{Bound, Run, Stop};
use crate::chain::replay::bounds::Bounds;
use crate::chain::replay::collapse::{self, Collapse};
use crate::chain::replay::joined::Cause;
use crate::chain::replay::ledger::LedgerFault;
use crate::chain::replay::pattern;
use malachite::Rational;
use std::cmp::Ordering;

impl Run<'_> {
    /// What the collisions of one instant begin: where they are proved to accumulate, the run ends, or bodies join.
    pub(super) fn accumulation(&mut self, together: &[usize], bound: &Bound) -> Result<Option<Stop>, LedgerFault> {
        for middle in together.iter().flat_map(|p| [*p, p + 1]) {
            let streak = self.streak[middle].0;
            if streak < 4 || !streak.is_power_of_two() || !self.contracts(middle) {
                continue;
            }
            if self.settle(bound)? {
                return Ok(Some(Stop::Grown));
            }
            let found = collapse::of_three(self.line, &self.b, &self.v, middle);
            if let Some(found) = found.filter(|found| self.undisturbed(found, bound.until))
                && let Some(stop) = self.collapsed(found, bound)?
            {
                return Ok(Some(stop));
            }
        }
        if self.recent.len() < pattern::ATTEMPT {
            return Ok(None);
        }
        let recent = std::mem::take(&mut self.recent);
        let Some(round) = pattern::round(&recent) else { return Ok(None) };
        if self.settle(bound)? {
            return Ok(Some(Stop::Grown));
        }
        match pattern::of_round(self.line, &self.b, &self.v, round).filter(|f| self.undisturbed(f, bound.until)) {
            Some(found) => self.collapsed(found, bound),
            None => Ok(None),
        }
    }

    /// Whether a point has two neighbours with which it can collide for ever in a finite time.
    fn contracts(&mut self, middle: usize) -> bool {
        let within = middle > 0 && middle + 1 < self.line.points.len();
        *self.contracts[middle].get_or_insert_with(|| within && collapse::contraction(self.line, middle).is_some())
    }

    /// Ends the run at a collapse, or goes on from its end: always where a pair has restitution 0, for then the bodies
    /// stick, and where asked for.
    fn collapsed(&mut self, found: Collapse, bound: &Bound) -> Result<Option<Stop>, LedgerFault> {
        let sticks = found.sticks();
        if !sticks && !bound.through {
            return Ok(Some(Stop::Collapse(Box::new(found))));
        }
        let points = (found.bodies.0 - self.line.first, found.bodies.1 - self.line.first);
        let time = found.time.clone();
        let cause = if sticks { Cause::Inelastic } else { Cause::Collapse(Box::new(found)) };
        self.join(points, time, cause, bound)?;
        self.predict_around(points);
        Ok(None)
    }

    /// Nothing outside the points of a collapse meets any of them, or another, before it; and it is not later than
    /// asked for.
    fn undisturbed(&self, found: &Collapse, until: Option<&Rational>) -> bool {
        let (from, to) = (found.bodies.0 - self.line.first, found.bodies.1 - self.line.first);
        let not_after = |t: &Rational| found.time.compare(t).is_some_and(|order| order != Ordering::Greater);
        if until.is_some_and(|until| !not_after(until)) {
            return false;
        }
        let (lo, hi) = found.time.enclose(64);
        let near = Bounds { lo: Bounds::of(&lo).lo, hi: Bounds::of(&hi).hi };
        let mut far = self.queue.present().filter(|q| *q + 1 < from || *q > to);
        let late = far.all(|q| match self.due[q].order(near) {
            Some(order) => order == Ordering::Greater,
            None => self.due_exactly(q).is_none_or(|t| not_after(&t)),
        });
        // The outer bodies of a collapse are only ever pushed outward, so each stays on the inner side of the
        // chord of its worldline; a neighbour on a straight line that ends outside has not met it. Where all happens at
        // this instant there is no chord: a neighbour that touches must be as fast as what the outer body approaches.
        let at_once = self.time().rational().is_some_and(|now| found.time.compare(now) == Some(Ordering::Equal));
        let apart = |outer: usize, side: Ordering| match found.reach(&self.b[outer], &self.v[outer]) {
            Some(Ordering::Equal) => !at_once || self.v[outer].cmp(&found.velocity) != side.reverse(),
            there => there == Some(side),
        };
        late && (from == 0 || apart(from - 1, Ordering::Less))
            && (to + 1 >= self.line.points.len() || apart(to + 1, Ordering::Greater))
    }
}
