//! Bodies that come together and move on as one: infinitely many collisions whose end is exact.
//!
//! Contract: `settle` takes points that touch, every pair of neighbours with restitution 0, and gives the velocities
//! that their collisions approach. They do not depend on the order of the collisions, and no gap enters.
//!
//! **Why the order does not matter.** Let `J_j ≥ 0` be the momentum that the cut between point `j` and `j + 1` has
//! handed to the right so far: `v_j = v_j⁰ + (J_(j−1) − J_j)/m_j`, with `1/m = 0` for a wall. The pair approaches
//! exactly where `J_j < f_j`, and a collision with restitution 0 puts `J_j := f_j`, where
//! `f_j·(1/m_j + 1/m_(j+1)) = v_j⁰ − v_(j+1)⁰ + J_(j−1)/m_j + J_(j+1)/m_(j+1)` grows with both neighbours. Call `J̃ ≥ 0`
//! *quiet* if `J̃_j ≥ f_j(J̃)` for all `j`: no pair approaches. One exists: all at one velocity, that of the wall if there
//! is one. From `J = 0`, every collision keeps `J ≤ J̃`, since `f_j(J) ≤ f_j(J̃) ≤ J̃_j`. So `J` grows and is bounded, and
//! has a limit below every quiet `J̃`. If no pair that approaches waits for ever, the limit is quiet itself: it is the least
//! quiet one, whatever the order. ∎
//!
//! **What it is.** In the least quiet `J`, a pair with `J_j > 0` has equal velocities: else a smaller `J_j` would do,
//! and the neighbours would stay quiet. These are the conditions for the velocities nearest to `v⁰`, in the metric of the
//! masses, among those that nowhere approach; there is one such point, and pooling neighbours that approach into one body
//! with their momentum finds it (pool adjacent violators).
//!
//! **Infinitely many collisions** exactly where two cuts side by side have `J > 0`. Were there finitely many, let the last
//! one be on the right cut: it lowers the velocity of the body in the middle, which the left pair had reached at its own
//! last collision, so the left pair is left approaching. Where the cuts beside `j` have `J = 0`, one collision reaches
//! `f_j`. So a block of two bodies is one collision, a block of three or more infinitely many.
//!
//! **With a restitution above 0** beside the block nothing changes as long as that pair does not approach at the end:
//! the velocity of the body at the edge only moves outward, so it did not approach before either.
//!
//! **Three points, one pair with restitution 0** and the other not, are decided by [`super::collapse`]: the determinant
//! is 0, the eigenvalues are 0 and the trace. Every speed is multiplied by the trace, below 1, over each two collisions;
//! all of them happen at one instant, for the pair with restitution 0 does not part.

use super::collapse::Collapse;
use super::line::Line;
use super::{Outcome, Value};
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;

/// Why bodies move on together.
#[derive(Clone, Debug)]
pub enum Cause {
    /// They touch, and a pair of them has restitution 0: infinitely many collisions at one instant.
    Inelastic,
    /// Infinitely many collisions before a finite time ended in a point.
    Collapse(Box<Collapse>),
}

/// Bodies that came together after infinitely many collisions and move on as one.
#[derive(Clone, Debug)]
pub struct Joined {
    /// How many collisions were counted before.
    pub after: u64,
    /// Why.
    pub cause: Cause,
    /// The points, first and last; 0 and the number after the last body are walls.
    pub bodies: (usize, usize),
    /// When they are together.
    pub time: Value,
    /// Where the first two of them touch then.
    pub position: Value,
    /// The velocities of the first and the last of them before the infinitely many collisions.
    pub before: [Rational; 2],
    /// Their common velocity from then on.
    pub velocity: Rational,
    /// The energy that it cost.
    pub lost: Rational,
}

/// What was listed, in order.
#[derive(Clone, Copy, Debug)]
pub enum Entry<'a> {
    /// A collision, counted from 1.
    Collision(u64, &'a super::Collision),
    /// Infinitely many.
    Joined(&'a Joined),
}

impl Outcome {
    /// The listed collisions and the bodies that came together, in order.
    pub fn in_order(&self) -> impl Iterator<Item = Entry<'_>> {
        let mut joined = self.joined.iter().peekable();
        let mut events = self.events.iter().zip(1..).peekable();
        std::iter::from_fn(move || {
            let done = events.peek().map_or(u64::MAX, |(_, number)| number - 1);
            if let Some(next) = joined.next_if(|j| j.after <= done) {
                return Some(Entry::Joined(next));
            }
            events.next().map(|(event, number)| Entry::Collision(number, event))
        })
    }
}

/// Points that end with one velocity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Block {
    /// The first and the last point.
    pub points: (usize, usize),
    /// `None` where a wall is among them.
    mass: Option<Rational>,
    momentum: Rational,
}

impl Block {
    /// The common velocity.
    pub(super) fn velocity(&self) -> Rational {
        self.mass.as_ref().map_or(Rational::ZERO, |mass| &self.momentum / mass)
    }

    fn with(self, right: Block) -> Block {
        Block {
            points: (self.points.0, right.points.1),
            mass: self.mass.zip(right.mass).map(|(a, b)| a + b),
            momentum: self.momentum + right.momentum,
        }
    }
}

/// What collisions with restitution 0 among the touching points `first ..= last` lead to: blocks from left to right,
/// velocities that do not fall.
pub(super) fn settle(line: &Line, v: &[Rational], first: usize, last: usize) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    for (k, (point, v)) in line.points.iter().zip(v).enumerate().take(last + 1).skip(first) {
        let mass = point.mass.clone();
        let momentum = mass.as_ref().map_or(Rational::ZERO, |m| m * v);
        let mut block = Block { points: (k, k), mass, momentum };
        while let Some(left) = blocks.pop() {
            if left.velocity() > block.velocity() {
                block = left.with(block);
            } else {
                blocks.push(left);
                break;
            }
        }
        blocks.push(block);
    }
    blocks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::replay::{Body, Wall};
    use malachite::base::num::basic::traits::One;

    /// Every order of collisions comes near what pooling gives, and keeps on its side of it.
    #[test]
    fn every_order_of_inelastic_collisions_leads_to_the_pooled_velocities() {
        let mut seed = 7u64;
        let mut random = move |n: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) % n
        };
        let mut pooled = 0;
        for scene in 0..60 {
            let n = 2 + random(4);
            let bodies: Vec<Body> = (0..n)
                .map(|_| Body {
                    mass: Rational::from(1 + random(4)),
                    position: Rational::ZERO,
                    velocity: Rational::from(random(7)) - Rational::from(3),
                    length: Rational::ZERO,
                })
                .collect();
            let wall = Wall { position: Rational::ZERO, restitution: Rational::ZERO };
            let left = (random(3) == 0).then_some(&wall);
            let right = (random(3) == 0).then_some(&wall);
            let soft = vec![Rational::ZERO; bodies.len() - 1];
            let line = Line::new(&bodies, &soft, left, right).expect("a valid line");
            let start: Vec<Rational> = line.points.iter().map(|p| p.velocity.clone()).collect();
            let blocks = settle(&line, &start, 0, start.len() - 1);
            pooled += blocks.iter().filter(|b| b.points.1 > b.points.0 + 1).count();
            let end: Vec<Rational> =
                blocks.iter().flat_map(|b| vec![b.velocity(); b.points.1 + 1 - b.points.0]).collect();
            assert!(end.windows(2).all(|w| w[0] <= w[1]), "scene {scene}: {end:?}");
            for order in 0..3 {
                let mut v = start.clone();
                let pairs = v.len() - 1;
                // From left to right again and again, from right to left, or at random: no pair waits for ever.
                for turn in 0..3_000 {
                    let p = match order {
                        0 => turn % pairs,
                        1 => pairs - 1 - turn % pairs,
                        _ => random(pairs as u64) as usize,
                    };
                    if v[p] <= v[p + 1] {
                        continue;
                    }
                    let (pair, speed) = (&line.pairs[p], &v[p] - &v[p + 1]);
                    v[p] -= &pair.left * &speed;
                    v[p + 1] += &pair.right * speed;
                    // Round to keep numbers short: what is lost is far below the bound.
                    for x in &mut v {
                        let scaled =
                            Rational::from((&*x << 200u32).numerator_ref() / (&*x << 200u32).denominator_ref());
                        *x = if *x < Rational::ZERO { -(scaled >> 200u32) } else { scaled >> 200u32 };
                    }
                }
                let far = v.iter().zip(&end).map(|(a, b)| if a > b { a - b } else { b - a }).max();
                assert!(far < Some(Rational::ONE >> 20u32), "scene {scene}, order {order}: {v:?} against {end:?}");
            }
        }
        assert!(pooled > 20, "{pooled} blocks of three and more");
    }
}
