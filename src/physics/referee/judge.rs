//! Somebody's results beside the reference: what is wrong, and from which digit on.
//!
//! Contract: a velocity, position or time is right where it differs from the reference by at most `10^-digits` of the
//! scale of the scene, its largest speed, distance or time. Momentum and energy are compared apart, with the same
//! tolerance of what the bodies have at the end and at the start: a heavy body's small error shows there. Collisions
//! are compared in their order; separate pairs that collide at one instant may come in any.
//!
//! Nothing is rounded: results are read as exact numbers and compared as such. Of a number that is only enclosed
//! ([`super::DIGITS`] digits), the nearer end counts.

use super::{Due, End, Known, Reference};
use crate::chain::replay::Body;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Abs, Pow};
use malachite::base::num::basic::traits::{One, Two, Zero};

/// The most digits that can be asked for.
pub const MAX_DIGITS: u64 = 30;

/// A number of somebody's results.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Given {
    /// A number.
    Number(Rational),
    /// `nan` or `inf`.
    Strange(String),
}

/// What somebody's simulator says of a scene. What is empty was not given.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Answer {
    /// The velocities at the end.
    pub velocities: Vec<Given>,
    /// The positions at the end.
    pub positions: Vec<Given>,
    /// The pairs in the order of their collisions, each by its left point.
    pub pairs: Option<Vec<usize>>,
    /// The times of these collisions.
    pub times: Vec<Given>,
    /// How many collisions there were.
    pub count: Option<u64>,
}

/// Something that is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Finding {
    /// No result was given.
    NoAnswer,
    /// A number is wrong.
    Number {
        /// What it is.
        what: Measure,
        /// The body or the collision, from 1.
        number: usize,
        /// What was given.
        given: Given,
        /// What is right.
        right: Box<Known>,
        /// The first significant digit that is wrong; `None` where 0 is right.
        digit: Option<u64>,
    },
    /// Momentum or energy was made or lost.
    Balance {
        /// Which of them.
        law: Law,
        /// What the given velocities have.
        given: Rational,
        /// What the right ones have.
        right: Rational,
    },
    /// A collision that is out of order.
    Order {
        /// Its number, from 1.
        number: usize,
        /// The given pair.
        given: usize,
        /// The pairs of which one is right.
        right: Vec<usize>,
    },
    /// More or fewer collisions.
    Count {
        /// How many were given.
        given: u64,
        /// How many there are, or how many at least.
        right: u64,
    },
}

/// What a number measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// A body's velocity.
    Velocity,
    /// A body's position.
    Position,
    /// The time of a collision.
    Time,
}

/// A law of conservation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Momentum.
    Momentum,
    /// Energy.
    Energy,
}

/// All that is wrong with a result; nothing where it is right. Where a scene has several ends, the nearest counts.
#[must_use]
pub fn judge(reference: &Reference, result: Option<&Answer>, digits: u64) -> Vec<Finding> {
    let Some(result) = result.filter(|result| !result.velocities.is_empty()) else { return vec![Finding::NoAnswer] };
    let tolerance = Rational::from(10).pow(-(digits.min(MAX_DIGITS) as i64));
    let of_end = |end: &End| against(reference, end, result, &tolerance);
    let mut findings = reference.ends.iter().map(of_end).min_by_key(Vec::len).unwrap_or_default();
    findings.extend(collisions(reference, result));
    findings.extend(times(reference, result, &tolerance));
    findings
}

/// The largest of numbers without their signs, and 0.
fn largest<'a>(list: impl Iterator<Item = &'a Rational>) -> Rational {
    list.map(|x| x.abs()).max().unwrap_or(Rational::ZERO)
}

fn against(reference: &Reference, end: &End, result: &Answer, tolerance: &Rational) -> Vec<Finding> {
    let bodies = &reference.scene.bodies;
    let ends = |list: &[Known]| largest(list.iter().flat_map(|known| [&known.lo, &known.hi]));
    let speed = largest(bodies.iter().map(|body| &body.velocity)).max(ends(&end.velocities));
    let distance = largest(bodies.iter().map(|body| &body.position)).max(ends(&end.positions));
    let mut findings = numbers(Measure::Velocity, &result.velocities, &end.velocities, &(speed * tolerance));
    findings.extend(numbers(Measure::Position, &result.positions, &end.positions, &(distance * tolerance)));
    findings.extend(balance(bodies, end, result, tolerance));
    findings
}

fn numbers(what: Measure, given: &[Given], right: &[Known], allowed: &Rational) -> Vec<Finding> {
    let pairs = given.iter().zip(right).enumerate();
    let wrong = pairs.filter_map(|(place, (given, right))| {
        let digit = match given {
            Given::Number(x) if error(x, right) <= *allowed => return None,
            Given::Number(x) => first_wrong(x, right),
            Given::Strange(_) => None,
        };
        Some(Finding::Number { what, number: place + 1, given: given.clone(), right: Box::new(right.clone()), digit })
    });
    wrong.collect()
}

/// The distance to the number, or to the nearer end of what encloses it.
fn error(given: &Rational, right: &Known) -> Rational {
    let below = &right.lo - given;
    let above = given - &right.hi;
    below.max(above).max(Rational::ZERO)
}

/// The first significant digit of the right number that the given one does not reach: with an error of at most half a
/// unit of the k-th digit, the first k are right.
fn first_wrong(given: &Rational, right: &Known) -> Option<u64> {
    let size = (&right.lo).abs();
    if size == 0 {
        return None;
    }
    let ten = Rational::from(10);
    let mut unit = Rational::ONE;
    while unit > size {
        unit /= &ten;
    }
    while &unit * &ten <= size {
        unit *= &ten;
    }
    let error = error(given, right) * Rational::TWO;
    let mut digit = 1;
    while error <= unit && digit <= 2 * super::DIGITS {
        unit /= &ten;
        digit += 1;
    }
    Some(digit)
}

/// What a body of this mass and velocity has.
type Term<'a> = &'a dyn Fn(&Rational, &Rational) -> Rational;

fn balance(bodies: &[Body], end: &End, result: &Answer, tolerance: &Rational) -> Vec<Finding> {
    let given: Option<Vec<&Rational>> =
        result.velocities.iter().map(|v| if let Given::Number(v) = v { Some(v) } else { None }).collect();
    let Some(given) = given else { return Vec::new() };
    let right: Vec<&Rational> = end.velocities.iter().map(|known| &known.lo).collect();
    let start: Vec<&Rational> = bodies.iter().map(|body| &body.velocity).collect();
    let sum = |velocities: &[&Rational], term: Term| {
        let terms = bodies.iter().zip(velocities).map(|(body, v)| term(&body.mass, v));
        terms.fold(Rational::ZERO, |a, b| a + b)
    };
    let momentum = |m: &Rational, v: &Rational| m * v;
    let size = |m: &Rational, v: &Rational| (m * v).abs();
    let energy = |m: &Rational, v: &Rational| m * v * v / Rational::TWO;
    let mut findings = Vec::new();
    let laws: [(Law, Term, Rational); 2] = [
        (Law::Momentum, &momentum, sum(&start, &size).max(sum(&right, &size))),
        (Law::Energy, &energy, sum(&start, &energy).max(sum(&right, &energy))),
    ];
    for (law, term, scale) in laws {
        let (given, right) = (sum(&given, term), sum(&right, term));
        if (&given - &right).abs() > scale * tolerance {
            findings.push(Finding::Balance { law, given, right });
        }
    }
    findings
}

/// The first collision out of order, and whether there are too many or too few.
fn collisions(reference: &Reference, result: &Answer) -> Vec<Finding> {
    let mut findings = Vec::new();
    let listed: usize = reference.instants.iter().map(Vec::len).sum();
    if let Some(pairs) = &result.pairs {
        let mut rest = pairs.as_slice();
        for instant in &reference.instants {
            let place = pairs.len() - rest.len();
            let (now, later) = rest.split_at(instant.len().min(rest.len()));
            if let Some((at, right)) = out_of_order(now, instant) {
                findings.push(Finding::Order { number: place + at + 1, given: now[at], right });
                return findings;
            }
            rest = later;
        }
        let given = pairs.len() as u64;
        let right = reference.count.unwrap_or(listed as u64);
        if pairs.len() < listed || (reference.count.is_some() && given > right) {
            findings.push(Finding::Count { given, right });
            return findings;
        }
    }
    if let (Some(given), Some(right)) = (result.count, reference.count)
        && given != right
    {
        findings.push(Finding::Count { given, right });
    }
    findings
}

/// The first of the given pairs that cannot come then: of the pairs of one instant, one may come if no earlier one
/// that is still to come shares a body with it.
fn out_of_order(given: &[usize], instant: &[Due]) -> Option<(usize, Vec<usize>)> {
    let mut left: Vec<usize> = instant.iter().map(|due| due.pair).collect();
    for (at, pair) in given.iter().enumerate() {
        let free = |k: &usize| left[..*k].iter().all(|earlier| earlier.abs_diff(left[*k]) > 1);
        let ready: Vec<usize> = (0..left.len()).filter(free).collect();
        match ready.iter().find(|k| left[**k] == *pair) {
            Some(k) => {
                left.remove(*k);
            }
            None => return Some((at, ready.iter().map(|k| left[*k]).collect())),
        }
    }
    None
}

/// Times are compared in increasing order, so that pairs of one instant may be given in any.
fn times(reference: &Reference, result: &Answer, tolerance: &Rational) -> Vec<Finding> {
    let right: Vec<Known> = reference.instants.iter().flatten().map(|due| due.time.clone()).collect();
    numbers(Measure::Time, &result.times, &right, &(&reference.scene.until * tolerance))
}
