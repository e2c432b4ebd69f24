//! eta on a grid, as products of two factors.

use super::{SMALL, etas};

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
        Factors::of(e, &vec![1.0; e.len()], collisions)
    }

    /// `B(r, N)` for each `r`.
    #[must_use]
    pub fn of_ratios(r: &[f64], collisions: u64) -> Factors {
        // At e = 1, eta is (4t/(1+t)²)^N.
        Factors::of(&vec![1.0; r.len()], r, collisions)
    }

    fn of(e: &[f64], r: &[f64], collisions: u64) -> Factors {
        let mut ends = vec![(0.0, 0.0); e.len()];
        etas(e, r, &vec![collisions; e.len()], &mut ends);
        let (lower, upper) = ends.into_iter().unzip();
        Factors { lower, upper }
    }
}

/// All products of the factors, a row of `ratios` for each restitution: `lower` and `upper` ends.
///
/// A cell costs a product for each end: the row's factor is moved a double outwards, by more than a relative `u = 2^-53`, and
/// a product is rounded by at most `u/(1 + u)` of what it becomes. Where products may underflow, cells are [`times`]. The
/// relative width is that of both factors and two roundings, below 2^-48. `lower` and `upper` must have
/// `restitutions × ratios` places; further cells are left.
pub fn grid(restitutions: &Factors, ratios: &Factors, lower: &mut [f64], upper: &mut [f64]) {
    let width = ratios.lower.len();
    if width == 0 {
        return;
    }
    // NaN fails it, too.
    let ordinary = |factor: &f64| *factor >= SMALL;
    let all_ordinary = ratios.lower.iter().all(ordinary);
    let rows = lower.chunks_exact_mut(width).zip(upper.chunks_exact_mut(width));
    for ((a, b), (low, high)) in restitutions.lower.iter().zip(&restitutions.upper).zip(rows) {
        if all_ordinary && ordinary(a) {
            products(a.next_down(), &ratios.lower, low);
            products(b.next_up(), &ratios.upper, high);
        } else {
            let ends = ratios.lower.iter().zip(&ratios.upper).map(|(c, d)| times((*a, *b), (*c, *d)));
            for (ends, cell) in ends.zip(low.iter_mut().zip(high)) {
                (*cell.0, *cell.1) = ends;
            }
        }
    }
}

/// The products of one factor with others, rounded to nearest.
fn products(factor: f64, others: &[f64], cells: &mut [f64]) {
    for (cell, other) in cells.iter_mut().zip(others) {
        *cell = factor * other;
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

#[cfg(test)]
mod tests {
    use super::{Factors, grid};
    use malachite::Rational;
    use proptest::prelude::*;

    /// Doubles from 2^-390 to 1, with first and last digits where the step outwards is least and most.
    fn factor() -> impl Strategy<Value = f64> {
        const LAST: u64 = (1 << 52) - 1;
        let digits = prop_oneof![4 => 0..=LAST, 2 => 0..4_u64, 2 => LAST - 4..=LAST];
        (digits, 633..1023_u64).prop_map(|(digits, exponent)| f64::from_bits(exponent << 52 | digits))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2_000))]
        #[test]
        fn products_rounded_to_nearest_are_bounds(
            a in prop::collection::vec(factor(), 1..8), b in prop::collection::vec(factor(), 1..16),
        ) {
            let points = |x: &[f64]| Factors { lower: x.to_vec(), upper: x.to_vec() };
            let (mut lower, mut upper) = (vec![0.0; a.len() * b.len()], vec![0.0; a.len() * b.len()]);
            grid(&points(&a), &points(&b), &mut lower, &mut upper);
            let pairs = a.iter().flat_map(|a| b.iter().map(move |b| (*a, *b)));
            for ((a, b), (lo, hi)) in pairs.zip(lower.into_iter().zip(upper)) {
                let exact = |x: f64| Rational::try_from(x).expect("finite");
                let product = exact(a) * exact(b);
                prop_assert!(exact(lo) <= product && product <= exact(hi), "{a:e}·{b:e}: {lo:e} {hi:e}");
                prop_assert!(hi - lo <= lo * 2f64.powi(-50), "{a:e}·{b:e}: {lo:e} {hi:e}");
            }
        }
    }
}
