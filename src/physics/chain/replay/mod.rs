//! Replay: every collision of bodies on a line, in order, with exact times.
//!
//! Contract: [`replay`] follows point bodies or rods between optional walls ([`Line`]) from one collision to the
//! next. While numbers are small it is exact throughout (`exact`): velocities, times, places, the order of
//! collisions, and a ledger of energy and momentum that is checked at every collision. Where numbers outgrow
//! [`Options::exact_bits`], enclosures take over (`certified`): count and order stay certain, values become
//! enclosures. It ends
//! - *complete*: no pair approaches, or the next collision is later than asked for;
//! - *collapse*: infinitely many collisions before a finite time, proved (`collapse`, `pattern`);
//! - *ambiguous*: three or more bodies touch, and the order of their collisions changes the outcome (`contact`);
//! - *limit*: as many collisions, or as large numbers, as [`Options`] allow.
//!
//! **Bodies that touch.** They are treated as if the gap were too small to matter: a touching pair that
//! approaches collides at once; one that separates, or moves together, does not. A cluster in which one pair
//! approaches goes on at the same instant; one in which several do goes on where every order of their collisions leads to
//! the same velocities, and is ambiguous elsewhere. With restitution 0 bodies move on
//! together, touching, until one of them is hit; three or more that touch reach their common velocity after infinitely many
//! collisions at one instant, whatever the order (`joined`).
//!
//! Source of the collision: Ricardo & Lee 2015, (1), (4)–(7).

mod bounds;
mod certified;
mod collapse;
mod contact;
mod enclosure;
mod end;
mod exact;
mod history;
mod joined;
mod ledger;
mod line;
mod near;
mod outcome;
mod pattern;
mod queue;
mod surd;
mod value;

pub use collapse::Collapse;
pub use contact::{ContactOutcome, ContactOutcomes};
pub use joined::{Cause, Entry, Joined};
pub use ledger::LedgerFault;
pub use line::{Body, Line, LineError, MAX_BODIES, Wall};
pub use outcome::{Collision, Contact, Enclosed, Energy, Limit, Outcome, Status};
pub use surd::Surd;
pub use value::Value;

use crate::number::interval::Interval;
use bounds::Bounds;
use certified::{Certified, End, MAX_BITS};
use enclosure::Enclosure;
use end::{Made, conclude, values};
use exact::{Bound, Run, Stop};
use history::evaluate;
use malachite::Rational;

/// The most collisions of one replay, unless told otherwise.
pub const MAX_EVENTS: u64 = 1_000_000;

/// Numbers of more bits end the exact part of a replay, unless told otherwise (bench `replay`, table `sizes`).
pub const EXACT_BITS: u64 = 8192;

/// Exact final values of a run in enclosures are evaluated up to about so many bits.
pub const MAX_VALUE_BITS: u64 = 1 << 24;

/// What a replay may do.
#[derive(Clone, Debug)]
pub struct Options {
    /// Stop after this many collisions; an instant that has begun is finished.
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

impl Options {
    fn bound(&self) -> Bound<'_> {
        Bound {
            events: self.max_events,
            until: self.until.as_ref(),
            list: self.list,
            bits: self.exact_bits,
            through: self.through_collapse,
        }
    }
}

/// Replays the line: [`follow`], with exact values.
///
/// ```
/// use carom_physics::chain::replay::{Body, Line, Options, Status, replay};
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
    follow(line, options)?.outcome()
}

/// Follows the line: the order of all collisions and their number, certified by doubles with a proved error, and by exact
/// numbers where these leave it open. [`Followed::outcome`] then gives exact values, and checks energy and momentum of
/// each collision exactly.
///
/// # Errors
/// [`LedgerFault`] where energy or momentum do not add up: a fault of this program.
pub fn follow<'a>(line: &'a Line, options: &'a Options) -> Result<Followed<'a>, LedgerFault> {
    let mut run = Run::new(line);
    let stop = run.go(&options.bound())?;
    run.check_sums()?;
    Ok(Followed { run, stop, options })
}

/// A line that was followed to its end, or to a limit.
pub struct Followed<'a> {
    run: Run<'a>,
    stop: Stop,
    options: &'a Options,
}

impl Followed<'_> {
    /// The number of collisions; `None` where only [`Followed::outcome`] finds it, because exact numbers outgrew
    /// [`Options::exact_bits`] on the way.
    #[must_use]
    pub fn count(&self) -> Option<u64> {
        (!matches!(self.stop, Stop::Grown)).then(|| self.run.count())
    }

    /// Doubles that the velocity of each body lies between at the end.
    #[must_use]
    pub fn velocities(&self) -> Vec<(f64, f64)> {
        let points = self.run.line.body_points();
        points.map(|k| self.run.velocity(k)).map(|v| (v.lo, v.hi)).collect()
    }

    /// What was found, with exact values.
    ///
    /// # Errors
    /// [`LedgerFault`] where energy or momentum do not add up: a fault of this program.
    pub fn outcome(self) -> Result<Outcome, LedgerFault> {
        let Followed { mut run, stop, options } = self;
        let line = run.line;
        let grown = run.settle(&options.bound())?;
        run.ledger.balance(line, &run.v)?;
        let status = match stop {
            Stop::Grown => return Ok(go_on(run, options)),
            _ if grown => return Ok(go_on(run, options)),
            Stop::Quiet | Stop::Until => Status::Complete,
            Stop::Events => Status::Limit(Limit::Events { allowed: options.max_events }),
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
    let needed = run.largest.saturating_mul(rest.count.div_ceil(run.count().max(1)));
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
