//! The greatest value over a box of masses: guessed in floating point, certified by concavity.
//!
//! **What is maximised.** With the first body moving and the others at rest, the velocity with which body `k` leaves is
//! proportional to `P = ∏_(j<k) m_j/(m_j + m_(j+1))`. The functions are `P^c` times a factor of the masses at the ends:
//! [`Last`] lists them. In the logarithms `x_j` of the masses each is concave: `ln(m_j/(m_j + m_(j+1)))` is
//! `−ln(1 + exp(x_(j+1) − x_j))`; `ln((m − e·b)/(m + b))` has the second derivative `−e·b·m/(m − e·b)² − b·m/(m + b)²`, and
//! `ln(m·b/(m + b))` is `−ln(1/m + 1/b)`.
//!
//! **Certificate.** A concave function `H` lies below its tangents: for any point `y` of its domain and all `x` of the
//! box, `H(x) <= H(y) + Σ g_j·(x_j − y_j)`, `g` the gradient at `y`. Each term is greatest at an end of the range of
//! `x_j`, and `ln t <= t − 1`. With `S` the sum of these greatest terms, the function is at most `exp(H(y))/(1 − S)`.
//! Where `y` is the maximum, `S` is zero or as small as rounding leaves it; where the guess is bad, the bound is
//! refused ([`MAX_EXCESS_BITS`]), never wrong.
//!
//! **Guess.** With both ends fixed the maximum is the taut string through the ranges of the logarithms: it minimises
//! `Σ f(x_j − x_(j+1))` for every convex `f`. With free ends and even `f`, too. Between the walls that it touches the masses
//! are in constant ratio. Where the last mass enters twice it is found by bisection of the derivative by `x_k`,
//! which is that of the last link alone, and then by the secant method to the precision asked for.
//!
//! **Cost.** `O(k)` operations on numbers of the precision asked for, and the string some 60 times in doubles.

use super::bound::{Side, product, shortened};
use super::{Positive, Range};
use crate::number::NumberError;
use crate::number::interval::Interval;
use crate::number::rational::exact_root;
use crate::number::root::{guess_ln, root};
use malachite::base::num::arithmetic::traits::{Abs, Pow, PowerOf2, Sign};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};
use std::cmp::Ordering;

/// A bound exceeds a value that is attained by at most `2^-MAX_EXCESS_BITS` of itself.
pub(crate) const MAX_EXCESS_BITS: u64 = 30;

/// The most steps of the secant method.
const STEPS: usize = 40;

/// What stands beside the power of `P`.
#[derive(Clone, Debug)]
pub(crate) enum Last<'a> {
    /// `P`: body `k` leaves with it.
    Arrival,
    /// `P·(m_k − e·b)/(m_k + b)`: body `k` keeps that after striking a body of mass `b`. Somewhere in the box it is above 0.
    Kept {
        /// The coefficient of that collision.
        e: &'a Rational,
        /// The mass `b`.
        front: &'a Rational,
    },
    /// `P²·m_k·b/(m_k + b)`: twice the energy that a plastic collision with a body of mass `b` loses.
    Lost {
        /// The mass `b`.
        front: &'a Rational,
    },
    /// `P²·m_k/m_0`: the share of the energy.
    Transfer,
}

impl Last<'_> {
    /// The exponent of `P`.
    fn power(&self) -> u64 {
        match self {
            Self::Arrival | Self::Kept { .. } => 1,
            Self::Lost { .. } | Self::Transfer => 2,
        }
    }

    /// The derivative of the logarithm of the factor by `ln m_k`.
    fn slope(&self, mass: &Rational) -> Rational {
        match self {
            Self::Arrival => Rational::ZERO,
            Self::Transfer => Rational::ONE,
            Self::Lost { front } => *front / (mass + *front),
            Self::Kept { e, front } => mass / (mass - *e * *front) - mass / (mass + *front),
        }
    }

    /// The same in doubles, at `x = ln m_k`; infinite where nothing is kept.
    fn guess_slope(&self, x: f64) -> f64 {
        let share = |other: f64| 1.0 / (1.0 + (x - other).exp());
        match self {
            Self::Arrival => 0.0,
            Self::Transfer => 1.0,
            Self::Lost { front } => share(guess_ln(front)),
            Self::Kept { e, front } => {
                let front_log = guess_ln(front);
                let lost = if **e == Rational::ZERO { 0.0 } else { (front_log + guess_ln(e) - x).exp() };
                if lost >= 1.0 { f64::INFINITY } else { 1.0 / (1.0 - lost) - (1.0 - share(front_log)) }
            }
        }
    }

    /// The factor itself.
    fn factor(&self, first: &Rational, mass: &Rational) -> Rational {
        match self {
            Self::Arrival => Rational::ONE,
            Self::Transfer => mass / first,
            Self::Lost { front } => mass * *front / (mass + *front),
            Self::Kept { e, front } => (mass - *e * *front) / (mass + *front),
        }
    }
}

/// Where a mass lies in its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Wall {
    Lower,
    Upper,
    Neither,
}

/// A point where the string turns: the number of the body, the logarithm of its mass, and its wall.
#[derive(Clone, Copy, Debug)]
struct Knot {
    body: usize,
    log: f64,
    wall: Wall,
}

/// An upper bound of the greatest value over the box, of about `bits` bits; at least two bodies.
///
/// # Errors
/// A limit where the bound exceeds what is attained by more than [`MAX_EXCESS_BITS`] tell.
pub(crate) fn greatest(masses: &[Range<Positive>], last: &Last<'_>, bits: u64) -> Result<Rational, NumberError> {
    let places = guess(masses, last, bits + 16);
    certify(masses, last, &places, bits + 16)
}

/// An upper bound from the tangent at a point.
fn certify(
    masses: &[Range<Positive>],
    last: &Last<'_>,
    places: &[Rational],
    bits: u64,
) -> Result<Rational, NumberError> {
    let refused = NumberError::LimitReached {
        limit: "bits of agreement of a greatest value over measured masses",
        allowed: MAX_EXCESS_BITS,
        needed: "more".to_owned(),
    };
    let (Some(first), Some(end)) = (places.first(), places.last()) else { return Err(refused) };
    let factor = last.factor(first, end);
    if factor <= Rational::ZERO || places.len() != masses.len() {
        return Err(refused);
    }
    let power = Rational::from(last.power());
    // The share of the body in front, for each link.
    let shares: Vec<Rational> = places
        .windows(2)
        .filter_map(|pair| match pair {
            [behind, front] => Some(front / (behind + front)),
            _ => None,
        })
        .collect();
    let mut excess = Rational::ZERO;
    for (j, (place, range)) in places.iter().zip(masses).enumerate() {
        let mut gradient = shares.get(j).cloned().unwrap_or(Rational::ZERO);
        if let Some(behind) = j.checked_sub(1).and_then(|j| shares.get(j)) {
            gradient -= behind;
        }
        gradient *= &power;
        if let (Last::Transfer, 0) = (last, j) {
            gradient -= Rational::ONE;
        }
        if j + 1 == places.len() {
            gradient += last.slope(place);
        }
        excess = shortened(excess + rise(&gradient, place, range), Side::Above, bits);
    }
    if excess > Rational::power_of_2(-i64::try_from(MAX_EXCESS_BITS).unwrap_or(0)) {
        return Err(refused);
    }
    let links = places.windows(2).filter_map(|pair| match pair {
        [behind, front] => Some(behind / (behind + front)),
        _ => None,
    });
    let value = shortened(product(links, Side::Above, bits).pow(last.power()) * factor, Side::Above, bits);
    Ok(shortened(value / (Rational::ONE - excess), Side::Above, bits))
}

/// At least the greatest `g·(x − y)` over the range of `x`, and zero.
fn rise(gradient: &Rational, mass: &Rational, range: &Range<Positive>) -> Rational {
    let step = match gradient.sign() {
        Ordering::Equal => return Rational::ZERO,
        Ordering::Greater => range.hi().value() / mass,
        Ordering::Less => mass / range.lo().value(),
    };
    if step > Rational::ONE { gradient.abs() * ln_above(&step) } else { Rational::ZERO }
}

/// At least `ln t`, `t > 1`.
fn ln_above(t: &Rational) -> Rational {
    // t < 2^k, and ln 2 < 7/10.
    let k = t.numerator_ref().significant_bits() + 1 - t.denominator_ref().significant_bits();
    (t - Rational::ONE).min(Rational::from_unsigneds(7 * k, 10))
}

/// A point near the maximum; may be wrong.
fn guess(masses: &[Range<Positive>], last: &Last<'_>, bits: u64) -> Vec<Rational> {
    let walls: Vec<(f64, f64)> = masses.iter().map(|m| (guess_ln(m.lo().value()), guess_ln(m.hi().value()))).collect();
    let knots = match (last, walls.last()) {
        (_, None) => Vec::new(),
        (Last::Transfer, _) => free_string(&walls),
        (Last::Arrival, Some(end)) => string(&walls, (end.0, Wall::Lower)),
        (Last::Kept { .. } | Last::Lost { .. }, _) => string(&walls, guess_end(&walls, last)),
    };
    let mut places: Vec<Rational> = Vec::with_capacity(masses.len());
    for knot in knots {
        let Some(range) = masses.get(knot.body) else { continue };
        let mass = match (knot.wall, places.last()) {
            (Wall::Lower, _) => range.lo().value().clone(),
            (Wall::Upper, _) => range.hi().value().clone(),
            (Wall::Neither, None) => continue,
            (Wall::Neither, Some(before)) => refined(last, before, knot.body + 1 - places.len(), knot.log, bits),
        };
        match places.last().cloned() {
            // A string with free ends is level up to its first knot.
            None => places.resize(knot.body, mass.clone()),
            Some(before) => between(&mut places, &before, &mass, knot.body, bits),
        }
        places.push(mass);
    }
    if let (Last::Transfer, Some(end)) = (last, places.last().cloned()) {
        // And from its last one on.
        places.resize(masses.len(), end);
    }
    places
}

/// Fills the places up to a knot with masses in constant ratio.
fn between(places: &mut Vec<Rational>, from: &Rational, to: &Rational, body: usize, bits: u64) {
    let links = (body + 1).saturating_sub(places.len());
    if links < 2 {
        return;
    }
    let ratio = to / from;
    let step = match exact_root(&ratio, links as u64) {
        Some(step) => Some(step),
        None => root(&ratio, &Natural::from(links as u64), bits).middle(bits).point(),
    };
    let Some(step) = step else { return };
    let mut mass = from.clone();
    for _ in 1..links {
        mass = shortened(mass * &step, Side::Below, bits);
        places.push(mass.clone());
    }
}

/// The last mass, where it enters twice and lies inside of its range: a zero of the derivative.
fn refined(last: &Last<'_>, from: &Rational, links: usize, log: f64, bits: u64) -> Rational {
    let links = Natural::from(links.max(1) as u64);
    let Some(guess) = Interval::from_f64(log.exp()).point().filter(|m| *m > Rational::ZERO) else {
        return from.clone();
    };
    let short = |x: &Rational| Interval::from_rational(x, bits).middle(bits).point();
    let derivative = |mass: &Rational| {
        let behind = root(&(from / mass), &links, bits).middle(bits).point()?;
        short(&(last.slope(mass) - Rational::from(last.power()) / (behind + Rational::ONE)))
    };
    let mut older = &guess * (Rational::ONE + Rational::power_of_2(-26_i64));
    let mut newer = guess;
    let (Some(mut before), Some(mut now)) = (derivative(&older), derivative(&newer)) else { return newer };
    for _ in 0..STEPS {
        if now == before || now == Rational::ZERO {
            break;
        }
        let step = (&newer - &older) * &now / (&now - &before);
        let Some(next) = short(&(&newer - step)).filter(|m| *m > Rational::ZERO && *m != newer) else { break };
        let Some(found) = derivative(&next) else { break };
        (older, newer, before, now) = (newer, next, now, found);
    }
    newer
}

/// The logarithm of the last mass at which the derivative vanishes, or its wall.
fn guess_end(walls: &[(f64, f64)], last: &Last<'_>) -> (f64, Wall) {
    let Some((low, high)) = walls.last().copied() else { return (0.0, Wall::Neither) };
    let rises = |x: f64| {
        let knots = string(walls, (x, Wall::Neither));
        let [.., before, end] = knots.as_slice() else { return false };
        let slope = (end.log - before.log) / (end.body - before.body).max(1) as f64;
        // The share of the last body is 1/(1 + exp(−slope)).
        last.guess_slope(x) > last.power() as f64 / (1.0 + (-slope).exp())
    };
    if rises(high) {
        return (high, Wall::Upper);
    }
    if !rises(low) {
        return (low, Wall::Lower);
    }
    let (mut low, mut high) = (low, high);
    for _ in 0..64 {
        let middle = low + (high - low) / 2.0;
        if middle <= low || middle >= high {
            break;
        }
        if rises(middle) { low = middle } else { high = middle }
    }
    (high, Wall::Neither)
}

/// The taut string from the upper wall of the first body to a fixed end.
fn string(walls: &[(f64, f64)], end: (f64, Wall)) -> Vec<Knot> {
    let Some(first) = walls.first() else { return Vec::new() };
    follow(walls, vec![Knot { body: 0, log: first.1, wall: Wall::Upper }], Some(end))
}

/// The knots of the taut string with both ends free: level before the first and after the last.
fn free_string(walls: &[(f64, f64)]) -> Vec<Knot> {
    let Some(first) = walls.first() else { return Vec::new() };
    let (mut low, mut high) = ((0, first.0), (0, first.1));
    let mut start = None;
    for (k, wall) in walls.iter().enumerate() {
        if wall.0 > high.1 {
            start = Some(Knot { body: high.0, log: high.1, wall: Wall::Upper });
            break;
        }
        if wall.1 < low.1 {
            start = Some(Knot { body: low.0, log: low.1, wall: Wall::Lower });
            break;
        }
        if wall.0 >= low.1 {
            low = (k, wall.0);
        }
        if wall.1 <= high.1 {
            high = (k, wall.1);
        }
    }
    match start {
        Some(knot) => follow(walls, vec![knot], None),
        None => vec![Knot { body: low.0, log: low.1, wall: Wall::Lower }],
    }
}

/// Follows the string from its last knot to the end, or to where it is level.
fn follow(walls: &[(f64, f64)], mut knots: Vec<Knot>, end: Option<(f64, Wall)>) -> Vec<Knot> {
    let last = walls.len().saturating_sub(1);
    while let Some(at) = knots.last().copied()
        && at.body < last
        && let Some(next) = next_knot(walls, at, end)
    {
        knots.push(next);
    }
    knots
}

/// The next point where the string turns, or its end; `None` where it is level to a free end.
fn next_knot(walls: &[(f64, f64)], at: Knot, end: Option<(f64, Wall)>) -> Option<Knot> {
    let last = walls.len() - 1;
    let (mut low, mut high) = ((f64::NEG_INFINITY, at), (f64::INFINITY, at));
    for (k, wall) in walls.iter().enumerate().skip(at.body + 1) {
        let links = (k - at.body) as f64;
        let fixed = end.filter(|_| k == last);
        let (bottom, top) = fixed.map_or(*wall, |(log, _)| (log, log));
        let (rise_low, rise_high) = ((bottom - at.log) / links, (top - at.log) / links);
        if rise_low > high.0 {
            return Some(high.1);
        }
        if rise_high < low.0 {
            return Some(low.1);
        }
        if rise_low >= low.0 {
            low = (rise_low, Knot { body: k, log: bottom, wall: fixed.map_or(Wall::Lower, |(_, wall)| wall) });
        }
        if rise_high <= high.0 {
            high = (rise_high, Knot { body: k, log: top, wall: fixed.map_or(Wall::Upper, |(_, wall)| wall) });
        }
    }
    match end {
        Some((log, wall)) => Some(Knot { body: last, log, wall }),
        // The end is free: as level as the walls allow.
        None if low.0 > 0.0 => Some(low.1),
        None if high.0 < 0.0 => Some(high.1),
        None => None,
    }
}
