//! eta on a grid, as products of two factors.

use super::eta;

/// The factors of eta on a grid: `eta(e, r, N) = A(e, N)·B(r, N)`, `A = ((1+e)/2)^(2N)`, `B = (4t/(1+t)²)^N`.
///
/// Both lie in (0, 1], so their products do not overflow.
#[derive(Clone, Debug, Default)]
pub struct Factors {
    lower: Vec<f64>,
    upper: Vec<f64>,
}

impl Factors {
    /// `A(e, N)` for each `e`.
    #[must_use]
    pub fn of_restitutions(e: &[f64], collisions: u64) -> Factors {
        // At r = 1, eta is ((1+e)/2)^(2N).
        Factors::collect(e.iter().map(|e| eta(*e, 1.0, collisions)))
    }

    /// `B(r, N)` for each `r`.
    #[must_use]
    pub fn of_ratios(r: &[f64], collisions: u64) -> Factors {
        // At e = 1, eta is (4t/(1+t)²)^N.
        Factors::collect(r.iter().map(|r| eta(1.0, *r, collisions)))
    }

    fn collect(ends: impl Iterator<Item = (f64, f64)>) -> Factors {
        let (lower, upper) = ends.unzip();
        Factors { lower, upper }
    }
}

/// All products of the factors, a row of `ratios` for each restitution: `lower` and `upper` ends.
///
/// A cell costs two products and a step outwards each; its relative width is that of both factors and two
/// roundings, below 2^-48. `lower` and `upper` must have `restitutions × ratios` places; further cells are left.
pub fn grid(restitutions: &Factors, ratios: &Factors, lower: &mut [f64], upper: &mut [f64]) {
    let width = ratios.lower.len();
    if width == 0 {
        return;
    }
    let rows = lower.chunks_exact_mut(width).zip(upper.chunks_exact_mut(width));
    for ((a, b), (low, high)) in restitutions.lower.iter().zip(&restitutions.upper).zip(rows) {
        for (cell, factor) in low.iter_mut().zip(&ratios.lower) {
            *cell = step_down(a * factor);
        }
        for (cell, factor) in high.iter_mut().zip(&ratios.upper) {
            *cell = step_up(b * factor);
        }
    }
}

/// Encloses the product of two numbers from 0 to 1 that are given by their ends.
#[must_use]
#[inline]
pub fn times(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    (step_down(a.0 * b.0), step_up(a.1 * b.1))
}

/// Below `x >= 0` by at least half an ulp, without a branch: `x·2^-52` is at least an ulp, so the product is
/// rounded to at most the double below `x`; two of the least positive doubles cover what underflows.
#[inline(always)]
fn step_down(x: f64) -> f64 {
    let below = x * (1.0 - f64::EPSILON) - f64::from_bits(2);
    below.max(0.0)
}

/// Above `x >= 0` by at least half an ulp.
#[inline(always)]
fn step_up(x: f64) -> f64 {
    x * (1.0 + f64::EPSILON) + f64::from_bits(2)
}
