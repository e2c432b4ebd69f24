//! What a replay found: its collisions, how it ended, and the state at its end.

use super::{Collapse, ContactOutcomes, Joined, Value};
use malachite::Rational;

/// One collision.
#[derive(Clone, Debug)]
pub struct Collision {
    /// The pair, shown by its left point: body `pair` and body `pair + 1`; 0 and the number after the last body
    /// are walls.
    pub pair: usize,
    /// When.
    pub time: Value,
    /// Where the two touch.
    pub position: Value,
    /// The velocities before, left and right.
    pub before: [Value; 2],
    /// The velocities after.
    pub after: [Value; 2],
    /// The energy that it cost.
    pub lost: Value,
}

/// How a replay ended.
#[derive(Clone, Debug)]
pub enum Status {
    /// Nothing more happens, or not before the time asked for.
    Complete,
    /// Infinitely many collisions before a finite time.
    Collapse(Box<Collapse>),
    /// A stated limit.
    Limit(Limit),
    /// A contact with more than one possible outcome.
    Ambiguous(Contact),
}

/// The limits that can end a replay.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Limit {
    /// [`super::Options::max_events`], and another collision is due.
    Events {
        /// The limit.
        allowed: u64,
    },
    /// Enclosures of this precision leave open what comes next.
    Precision {
        /// The limit in bits.
        bits: u64,
    },
    /// Exact final values would need more than [`super::MAX_VALUE_BITS`]; they are enclosed instead.
    Values {
        /// The limit in bits.
        allowed: u64,
        /// About how many would be needed.
        needed: u64,
    },
}

/// A contact of three or more bodies at one instant, more than one pair of them approaching, whose order matters.
#[derive(Clone, Debug)]
pub struct Contact {
    /// The points that touch, first and last; 0 and the number after the last body are walls.
    pub bodies: (usize, usize),
    /// The pairs that approach, each shown by its left point.
    pub pairs: Vec<usize>,
    /// The instant.
    pub time: Rational,
    /// The outcomes of all orders, where asked for.
    pub outcomes: Option<ContactOutcomes>,
}

/// Energy before and after, and what was lost in between.
#[derive(Clone, Debug)]
pub struct Energy {
    /// At the start.
    pub initial: Value,
    /// At the end.
    pub last: Value,
    /// The difference.
    pub lost: Value,
}

/// What a replay found.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// How it ended.
    pub status: Status,
    /// The number of collisions, before the collapse where there is one.
    pub count: u64,
    /// The first of them, as many as asked for.
    pub events: Vec<Collision>,
    /// How often three or more points came together after infinitely many collisions, none of which is counted.
    pub joins: u64,
    /// Those among the listed collisions, as many as asked for.
    pub joined: Vec<Joined>,
    /// The time that `positions` belong to: of what happened last, of the collapse or contact, or the one asked for.
    pub time: Value,
    /// The velocities of the bodies at the end; in a collapse those that they approach.
    pub velocities: Vec<Value>,
    /// The positions of the bodies at `time`.
    pub positions: Vec<Value>,
    /// The kinetic energy.
    pub energy: Energy,
    /// The momentum at the start and at the end; only walls change it.
    pub momentum: (Value, Value),
    /// Instants at which several separate pairs collide.
    pub simultaneous: u64,
    /// Contacts of several bodies at which any order of collisions leads to the same velocities; one order is played.
    pub any_order: u64,
    /// How many collisions come before the first of them.
    pub before_any_order: Option<u64>,
    /// The most bits of a numerator or denominator of the state, after 0, 1, 2, 4, 8, … collisions.
    pub growth: Vec<(u64, u64)>,
    /// What was settled by enclosures; `None` where the run was exact throughout.
    pub enclosed: Option<Enclosed>,
}

/// The part of a run in which enclosures stand for exact numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Enclosed {
    /// The number of collisions before it.
    pub after: u64,
    /// The bits of the enclosures that settled count and order.
    pub bits: u64,
    /// The entries that the order takes as runs of two pairs in turn.
    pub entries: usize,
}
