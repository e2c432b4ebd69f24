//! Given masses, some of them measured, with other bodies in motion as well.
//!
//! Body `k` arrives with `w_k`, and `w_(k+1) = v + (1 + e)(w_k − v)·m_k/(m_k + m_(k+1))`, `v` the velocity of body `k + 1` before.
//! Where the collision takes place (`w_k > v`) this rises with `w_k`, `e` and `m_k` and falls with `m_(k+1)`; but `w_k` itself
//! depends on `m_k`, and in no convenient way. So the range of each mass is cut into [`CELLS`] cells, and `w_k` is bounded
//! for each cell of `m_k`: the inputs of a step are then monotone and independent. A measured coefficient that all
//! collisions share is cut into [`PIECES`], each of which is followed through the chain by itself.
//!
//! **Excess.** Each step takes `m_k` at two ends of one cell. So the bounds exceed what is attained, relative to the
//! velocity of approach, by at most the relative width of a cell for each collision: a share of `1/CELLS` of the
//! input's own uncertainty. It vanishes where only one mass is measured and that body does not move on.
//!
//! **Cost.** `CELLS²` steps for each collision, times [`PIECES`] where the coefficient is shared.

use super::bound::{Side, shortened};
use super::given::{check, limit};
use super::{Coefficients, Positive, Range, Reals};
use crate::chain::{ChainError, Restitution, limit_inserted};
use crate::number::real::Real;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Square;
use malachite::base::num::basic::traits::{One, Two, Zero};

/// Into so many cells the range of each measured mass is cut.
pub const CELLS: u64 = 32;

/// Into so many pieces the range of a coefficient is cut that all collisions share.
pub const PIECES: u64 = 8;

/// The most bodies of measured mass in a chain in which others than the first move.
pub const MAX_MOVING: u64 = 100;

/// Bits of the bounds.
const BITS: u64 = 64;

/// A bound on both sides.
type Bounds = (Rational, Rational);

/// Bounds of all velocities after the pass, and of the energy lost in each collision.
#[derive(Debug)]
pub struct Moving {
    /// The velocities.
    pub velocities: Vec<Reals>,
    /// The losses.
    pub losses: Vec<Reals>,
}

/// Follows the pass.
///
/// # Errors
/// [`ChainError::Count`]; [`ChainError::MayNotCollide`] where a collision does not take place for all inputs; a limit above
/// [`MAX_MOVING`].
pub fn follow(
    masses: &[Range<Positive>],
    coefficients: &Coefficients,
    before: &[Rational],
) -> Result<Moving, ChainError> {
    limit_inserted(masses.len() as u64, "bodies of measured mass, others than the first in motion", MAX_MOVING)?;
    limit(masses)?;
    check(masses, coefficients)?;
    if before.len() != masses.len() {
        let (given, needed) = (before.len() as u64, masses.len() as u64);
        return Err(ChainError::Count { of: "velocities", given, needed });
    }
    let mut all: Option<(Vec<Bounds>, Vec<Bounds>)> = None;
    for coefficients in pieces(coefficients)? {
        let found = pass(masses, &coefficients, before)?;
        all = Some(match all {
            None => found,
            Some(other) => (hull(found.0, other.0), hull(found.1, other.1)),
        });
    }
    let (velocities, losses) = all.unwrap_or_default();
    let reals = |list: Vec<Bounds>| {
        let real = |(lo, hi)| Reals { least: Real::rational(lo), greatest: Real::rational(hi) };
        list.into_iter().map(real).collect()
    };
    Ok(Moving { velocities: reals(velocities), losses: reals(losses) })
}

/// A shared coefficient, cut; others as they are.
fn pieces(coefficients: &Coefficients) -> Result<Vec<Coefficients>, ChainError> {
    let Some(range) = coefficients.shared() else { return Ok(vec![coefficients.clone()]) };
    let (lo, width) = (range.lo().value(), range.hi().value() - range.lo().value());
    let at = |i: u64| Restitution::new(lo + &width * Rational::from_unsigneds(i, PIECES));
    let piece = |i| Ok(Coefficients::Same(Range { lo: at(i)?, hi: at(i + 1)? }));
    (0..PIECES).map(piece).collect()
}

fn hull(one: Vec<Bounds>, other: Vec<Bounds>) -> Vec<Bounds> {
    one.into_iter().zip(other).map(|(a, b)| (a.0.min(b.0), a.1.max(b.1))).collect()
}

/// The cells of a mass.
fn cells(range: &Range<Positive>) -> Vec<Bounds> {
    let (lo, hi) = (range.lo().value(), range.hi().value());
    if lo == hi {
        return vec![(lo.clone(), hi.clone())];
    }
    let at = |i: u64| lo + (hi - lo) * Rational::from_unsigneds(i, CELLS);
    (0..CELLS).map(|i| (at(i), at(i + 1))).collect()
}

fn pass(
    masses: &[Range<Positive>],
    coefficients: &Coefficients,
    before: &[Rational],
) -> Result<(Vec<Bounds>, Vec<Bounds>), ChainError> {
    let (mut velocities, mut losses) = (Vec::new(), Vec::new());
    let start = before.first().cloned().unwrap_or(Rational::ZERO);
    let Some(first) = masses.first() else { return Ok((velocities, losses)) };
    // Each cell of the present body with bounds of the velocity with which it arrives.
    let mut arriving: Vec<(Bounds, Bounds)> =
        cells(first).into_iter().map(|cell| (cell, (start.clone(), start.clone()))).collect();
    for (k, (range, v)) in masses.iter().zip(before).enumerate().skip(1) {
        let Some(e) = coefficients.at(k - 1) else { continue };
        let (e_lo, e_hi) = (e.lo().value(), e.hi().value());
        let (b_lo, b_hi) = (range.lo().value(), range.hi().value());
        // The velocities of approach.
        let approach: Vec<(&Bounds, Bounds)> = arriving.iter().map(|(cell, w)| (cell, (&w.0 - v, &w.1 - v))).collect();
        if approach.iter().any(|(_, d)| d.0 <= Rational::ZERO) {
            return Err(ChainError::MayNotCollide { collision: k });
        }
        let kept = |m: &Rational, b: &Rational, e: &Rational| (m - e * b) / (m + b);
        let leave = approach.iter().map(|((m_lo, m_hi), (d_lo, d_hi))| {
            let (worst, best) = (kept(m_lo, b_hi, e_hi), kept(m_hi, b_lo, e_lo));
            let low = if worst < Rational::ZERO { d_hi * &worst } else { d_lo * &worst };
            let high = if best < Rational::ZERO { d_lo * &best } else { d_hi * &best };
            (v + low, v + high)
        });
        velocities.extend(over(leave));
        let half = |e: &Rational| (Rational::ONE - e.square()) / Rational::TWO;
        let lose = approach.iter().map(|((m_lo, m_hi), (d_lo, d_hi))| {
            let energy =
                |m: &Rational, b: &Rational, d: &Rational, e: &Rational| m * b / (m + b) * d.square() * half(e);
            (energy(m_lo, b_lo, d_lo, e_hi), energy(m_hi, b_hi, d_hi, e_lo))
        });
        losses.extend(over(lose));
        let mut next = Vec::with_capacity(arriving.len());
        for cell in cells(range) {
            let arrive = approach.iter().map(|((m_lo, m_hi), (d_lo, d_hi))| {
                let low = d_lo * m_lo / (m_lo + &cell.1) * (e_lo + Rational::ONE);
                let high = d_hi * m_hi / (m_hi + &cell.0) * (e_hi + Rational::ONE);
                (v + low, v + high)
            });
            if let Some(bounds) = over(arrive) {
                next.push((cell, bounds));
            }
        }
        arriving = next;
    }
    velocities.extend(over(arriving.into_iter().map(|(_, w)| w)));
    Ok((velocities, losses))
}

/// The common bounds, shortened outwards.
fn over(list: impl Iterator<Item = Bounds>) -> Option<Bounds> {
    let (low, high) = list.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))?;
    Some((shortened(low, Side::Below, BITS), shortened(high, Side::Above, BITS)))
}
