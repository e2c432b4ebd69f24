//! Replay: every collision of bodies on a line, in order, with exact times.
//!
//! Contract: [`replay`] follows point bodies or rods between optional walls ([`Line`]) from one collision to the
//! next. While numbers are small it is exact throughout ([`exact`]): velocities, times, places, the order of
//! collisions, and a ledger of energy and momentum that is checked at every collision. Where numbers outgrow
//! [`Options::exact_bits`], enclosures take over ([`certified`]): count and order stay certain, values become
//! enclosures. It ends
//! - *complete*: no pair approaches, or the next collision is later than asked for;
//! - *collapse*: infinitely many collisions before a finite time, proved ([`collapse`], [`pattern`]);
//! - *ambiguous*: three or more bodies touch and more than one pair of them approaches ([`contact`]);
//! - *limit*: as many collisions, or as large numbers, as [`Options`] allow.
//!
//! **Bodies that touch.** They are treated as if the gap were too small to matter: a touching pair that
//! approaches collides at once; one that separates, or moves together, does not. A cluster in which one pair
//! approaches goes on at the same instant; one in which several do is ambiguous. With restitution 0 bodies move on
//! together, touching, until one of them is hit; three or more that touch reach their common velocity after infinitely many
//! collisions at one instant, whatever the order ([`joined`]).
//!
//! Source of the collision: Ricardo & Lee 2015, (1), (4)–(7).

mod bounds;
pub mod certified;
pub mod collapse;
pub mod contact;
pub mod exact;
pub mod joined;
mod ledger;
mod line;
pub mod pattern;
mod queue;
mod surd;

pub use collapse::Collapse;
pub use contact::{ContactOutcome, ContactOutcomes};
pub use joined::{Cause, Entry, Joined};
pub use ledger::LedgerFault;
pub use line::{Body, Line, LineError, MAX_BODIES, Wall};
pub use surd::Surd;

use crate::number::interval::Interval;
use bounds::Bounds;
use certified::{Certified, Enclosure, End, Evaluated, History, MAX_BITS, evaluate};
use exact::{Bound, Run, Stop};
use malachite::Rational;
use std::cmp::Ordering;

/// The most collisions of one replay, unless told otherwise.
pub const MAX_EVENTS: u64 = 1_000_000;

/// Numbers of more bits end the exact part of a replay, unless told otherwise (bench `replay`, table `sizes`).
pub const EXACT_BITS: u64 = 8192;

/// Exact final values of a run in enclosures are evaluated up to about so many bits.
pub const MAX_VALUE_BITS: u64 = 1 << 24;

/// What a replay may do.
#[derive(Clone, Debug)]
pub struct Options {
    /// The most collisions; an instant that has begun is finished.
    pub max_events: u64,
    /// Stop before the first collision later than this.
    pub until: Option<Rational>,
    /// How many collisions to list; all are counted.
    pub list: usize,
    /// Numbers of more bits end the exact part; `None` for exact whatever it costs.
    pub exact_bits: Option<u64>,
    /// Whether to try all orders of an ambiguous contact.
    pub orders: bool,
    /// Whether to go on from a proved collapse: its bodies touch, with one velocity.
    pub through_collapse: bool,
    /// Significant digits that final values are enclosed to, where they are not exact.
    pub digits: u64,
    /// Whether to evaluate final values exactly where the run was enclosed, up to [`MAX_VALUE_BITS`].
    pub exact_values: bool,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            max_events: MAX_EVENTS,
            until: None,
            list: 10_000,
            exact_bits: Some(EXACT_BITS),
            orders: false,
            through_collapse: false,
            digits: 15,
            exact_values: false,
        }
    }
}

/// A number of a replay.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// This number.
    Exact(Rational),
    /// A number of a quadratic field.
    Surd(Surd),
    /// A number from the first to the second.
    Within(Rational, Rational),
}

impl Value {
    /// The number, where it is known and rational.
    #[must_use]
    pub fn rational(&self) -> Option<&Rational> {
        match self {
            Value::Exact(x) => Some(x),
            Value::Surd(x) => x.rational(),
            Value::Within(lo, hi) => (lo == hi).then_some(lo),
        }
    }

    /// Rationals around the number, for exact ones at most `2^-bits` apart.
    #[must_use]
    pub fn enclose(&self, bits: u64) -> (Rational, Rational) {
        match self {
            Value::Exact(x) => (x.clone(), x.clone()),
            Value::Surd(x) => x.enclose(bits),
            Value::Within(lo, hi) => (lo.clone(), hi.clone()),
        }
    }
}

impl Value {
    /// The sum with a rational.
    fn plus(&self, x: &Rational) -> Value {
        match self {
            Value::Exact(y) => Value::Exact(x + y),
            Value::Surd(y) => Value::from(y.plus(x)),
            Value::Within(lo, hi) => Value::Within(lo + x, hi + x),
        }
    }

    /// The product with a rational.
    fn times(&self, x: &Rational) -> Value {
        match self {
            Value::Exact(y) => Value::Exact(x * y),
            Value::Surd(y) => Value::from(y.times(x)),
            Value::Within(lo, hi) if *x < 0 => Value::Within(hi * x, lo * x),
            Value::Within(lo, hi) => Value::Within(lo * x, hi * x),
        }
    }

    /// The order of the number and a rational, where it is certain.
    #[must_use]
    pub fn compare(&self, other: &Rational) -> Option<Ordering> {
        match self {
            Value::Exact(x) => Some(x.cmp(other)),
            Value::Surd(x) => Some(x.compare(other)),
            Value::Within(lo, hi) => {
                let (low, high) = (lo.cmp(other), hi.cmp(other));
                (low == high).then_some(low)
            }
        }
    }
}

impl From<Surd> for Value {
    fn from(x: Surd) -> Value {
        match x.rational() {
            Some(q) => Value::Exact(q.clone()),
            None => Value::Surd(x),
        }
    }
}

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
    /// A contact with more than one possible order.
    Ambiguous(Contact),
}

/// The limits that can end a replay.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Limit {
    /// [`Options::max_events`], and another collision is due.
    Events {
        /// The limit.
        allowed: u64,
    },
    /// Enclosures of this precision leave open what comes next.
    Precision {
        /// The limit in bits.
        bits: u64,
    },
    /// Exact final values would need more than [`MAX_VALUE_BITS`]; they are enclosed instead.
    Values {
        /// The limit in bits.
        allowed: u64,
        /// About how many would be needed.
        needed: u64,
    },
}

/// A contact of three or more bodies at one instant, more than one pair of them approaching.
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

/// Replays the line.
///
/// ```
/// use carom::chain::replay::{Body, Line, Options, Status, replay};
/// use malachite::Rational;
/// let body = |x: i32, v: i32| Body {
///     mass: Rational::from(1),
///     position: Rational::from(x),
///     velocity: Rational::from(v),
///     length: Rational::from(0),
/// };
/// let half = Rational::from_signeds(1, 2);
/// let line = Line::new(&[body(0, 1), body(1, 0), body(2, 0)], &[half.clone(), half], None, None).unwrap();
/// let outcome = replay(&line, &Options::default()).unwrap();
/// assert!(matches!(outcome.status, Status::Complete));
/// assert_eq!(outcome.count, 3);
/// ```
///
/// # Errors
/// [`LedgerFault`] where energy or momentum do not add up: a fault of this program.
pub fn replay(line: &Line, options: &Options) -> Result<Outcome, LedgerFault> {
    let mut run = Run::new(line);
    let bound = Bound {
        events: options.max_events,
        until: options.until.as_ref(),
        list: options.list,
        bits: options.exact_bits,
        through: options.through_collapse,
    };
    let stop = run.go(&bound)?;
    run.ledger.balance(line, &run.v)?;
    let status = match stop {
        Stop::Quiet | Stop::Until => Status::Complete,
        Stop::Events => Status::Limit(Limit::Events { allowed: options.max_events }),
        Stop::Grown => return Ok(go_on(run, options)),
        Stop::Collapse(found) => Status::Collapse(found),
        Stop::Ambiguous { cluster, pairs, time } => Status::Ambiguous(Contact {
            bodies: (cluster.0 + line.first, cluster.1 + line.first),
            pairs: pairs.iter().map(|p| p + line.first).collect(),
            time,
            outcomes: options.orders.then(|| contact::outcomes(line, &run.v, cluster.0, cluster.1)),
        }),
    };
    Ok(conclude(run, status, options))
}

/// Goes on with enclosures where exact numbers have become too large.
fn go_on(run: Run, options: &Options) -> Outcome {
    if let Some(outcome) = enclosed::<Bounds>(&run, options, 53) {
        return outcome;
    }
    let mut bits = 128;
    while bits <= MAX_BITS {
        if let Some(outcome) = enclosed::<Interval>(&run, options, bits) {
            return outcome;
        }
        bits *= 2;
    }
    conclude(run, Status::Limit(Limit::Precision { bits: MAX_BITS }), options)
}

/// The rest of the run in enclosures of one precision; `None` where they leave something open.
fn enclosed<E: Enclosure>(run: &Run, options: &Options, bits: u64) -> Option<Outcome> {
    let mut rest: Certified<E> = Certified::new(run, bits);
    let end = rest.go(options.max_events, options.until.as_ref(), options.list).ok()?;
    let status = match end {
        End::Quiet | End::Until => Status::Complete,
        End::Events => Status::Limit(Limit::Events { allowed: options.max_events }),
    };
    let made = Made { count: rest.count, events: std::mem::take(&mut rest.events), bits };
    // Sizes grow in proportion to the count.
    let needed = run.largest.saturating_mul(rest.count.div_ceil(run.count.max(1)));
    let too_long = options.exact_values && needed > MAX_VALUE_BITS;
    let limit = Status::Limit(Limit::Values { allowed: MAX_VALUE_BITS, needed });
    let status = if too_long && matches!(status, Status::Complete) { limit } else { status };
    if options.exact_values && !too_long {
        let end = evaluate::<Rational>(run, &rest.history, 0);
        values(run, &end, 0, status, options, (&rest.history, made))
    } else {
        let wanted = options.digits.saturating_mul(4).saturating_add(8);
        let mut bits = wanted + 128;
        loop {
            let end = evaluate::<Interval>(run, &rest.history, bits);
            let wide = |x: &Interval| x.accuracy() < wanted && !x.is_point();
            let last = bits >= wanted + MAX_BITS;
            if last || !end.v.iter().any(wide) {
                // A time may need more bits than the velocities.
                let found = values(run, &end, bits, status.clone(), options, (&rest.history, made.clone()));
                if last || found.is_some() {
                    break found;
                }
            }
            bits *= 2;
        }
    }
}

/// What a certified run leaves: its count, its list, its precision.
#[derive(Clone)]
struct Made {
    count: u64,
    events: Vec<Collision>,
    bits: u64,
}

/// The state at the end of a certified run, from the evaluated history.
fn values<N: Enclosure>(
    run: &Run,
    end: &Evaluated<N>,
    bits: u64,
    status: Status,
    options: &Options,
    (history, made): (&History, Made),
) -> Option<Outcome> {
    let line = run.line;
    let value = |x: &N| x.value();
    let number = |x: &Rational| N::of(x, bits);
    let last_pair = history.last();
    let finished = matches!(status, Status::Complete | Status::Limit(Limit::Values { .. }));
    let at_last = !(finished && options.until.is_some());
    let time = match (finished, &options.until, &end.last) {
        (true, Some(until), _) => number(until),
        (_, _, Some((gap, speed))) => gap.over(speed, bits),
        _ => number(run.time().rational()?),
    };
    // Touching a wall is a place that is known.
    let touching = |k: usize| {
        let wall = [k.checked_sub(1), Some(k + 1)]
            .into_iter()
            .flatten()
            .find(|w| line.points.get(*w).is_some_and(|p| p.mass.is_none()) && last_pair == Some(k.min(*w)))?;
        Some(Value::Exact(&line.points[wall].position + &line.points[k].offset))
    };
    let place = |k: usize| {
        if let Some(known) = touching(k).filter(|_| at_last) {
            return Some(known);
        }
        let here = end.b[k].plus(&end.v[k].times(&time, bits), bits);
        value(&here.plus(&number(&line.points[k].offset), bits))
    };
    let start: Vec<Rational> = line.points.iter().map(|p| p.velocity.clone()).collect();
    let (energy, momentum) = (ledger::energy(line, &start), ledger::momentum(line, &start));
    let sum = |term: &dyn Fn(&N, &N) -> N| {
        let all = line.points.iter().zip(&end.v).filter_map(|(p, v)| p.mass.as_ref().map(|m| term(&number(m), v)));
        all.fold(number(&Rational::from(0)), |a, b| a.plus(&b, bits))
    };
    let half = number(&Rational::from_signeds(1, 2));
    let last = sum(&|m, v| m.times(&v.times(v, bits), bits).times(&half, bits));
    let lost = number(&energy).minus(&last, bits);
    let elastic = line.pairs.iter().all(|p| p.restitution == 1);
    let walls = line.has_left_wall() || line.has_right_wall();
    // What the laws give exactly needs no enclosure.
    let energy = if elastic {
        Energy {
            initial: Value::Exact(energy.clone()),
            last: Value::Exact(energy),
            lost: Value::Exact(Rational::from(0)),
        }
    } else {
        Energy { initial: Value::Exact(energy), last: value(&last)?, lost: value(&lost)? }
    };
    let after = if walls { value(&sum(&|m, v| m.times(v, bits)))? } else { Value::Exact(momentum.clone()) };
    Some(Outcome {
        status,
        count: made.count,
        events: made.events,
        joins: run.joins,
        joined: run.joined.clone(),
        time: value(&time)?,
        velocities: line.body_points().map(|k| value(&end.v[k])).collect::<Option<_>>()?,
        positions: line.body_points().map(place).collect::<Option<_>>()?,
        energy,
        momentum: (Value::Exact(momentum), after),
        simultaneous: run.simultaneous,
        growth: run.growth.clone(),
        enclosed: Some(Enclosed { after: run.count, bits: made.bits, entries: history.entries() }),
    })
}

/// The state at the end of an exact run.
fn conclude(run: Run, status: Status, options: &Options) -> Outcome {
    let line = run.line;
    let start: Vec<Rational> = line.points.iter().map(|p| p.velocity.clone()).collect();
    let mut v = run.v.clone();
    let mut joined = None;
    let time = match (&status, &options.until) {
        (Status::Collapse(found), _) => {
            let points = found.bodies.0 - line.first..=found.bodies.1 - line.first;
            for k in points.clone() {
                v[k] = found.velocity.clone();
            }
            joined = Some(points);
            found.time.clone()
        }
        (Status::Ambiguous(contact), _) => Value::Exact(contact.time.clone()),
        (Status::Complete, Some(until)) => Value::Exact(until.clone()),
        _ => run.time(),
    };
    let positions = line.body_points().map(|k| {
        let offset = &line.points[k].offset;
        match &status {
            Status::Collapse(found) if joined.as_ref().is_some_and(|j| j.contains(&k)) => {
                let second = found.second() - line.first;
                found.position.plus(&(offset - &line.points[second].offset))
            }
            _ => time.times(&run.v[k]).plus(&(&run.b[k] + offset)),
        }
    });
    let positions = positions.collect();
    let initial = ledger::energy(line, &start);
    let last = ledger::energy(line, &v);
    let mut growth = run.growth;
    if growth.last().is_none_or(|g| g.0 < run.count) {
        growth.push((run.count, run.largest));
    }
    Outcome {
        status,
        count: run.count,
        events: run.events,
        joins: run.joins,
        joined: run.joined,
        time,
        positions,
        energy: Energy {
            lost: Value::Exact(&initial - &last),
            initial: Value::Exact(initial),
            last: Value::Exact(last),
        },
        momentum: (Value::Exact(ledger::momentum(line, &start)), Value::Exact(ledger::momentum(line, &v))),
        velocities: line.body_points().map(|k| Value::Exact(v[k].clone())).collect(),
        simultaneous: run.simultaneous,
        growth,
        enclosed: None,
    }
}
