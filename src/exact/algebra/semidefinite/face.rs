//! Facial reduction: where all matrices of a program are singular, a common kernel is guessed, and the squares are those of its
//! complement. (J. Borwein, H. Wolkowicz, 1981; H. Peyrl, P. Parrilo, Theoret. Comput. Sci. 409, 2008.)
//!
//! Contract: the guess may be wrong. Then fewer squares are left, and none of them is a wrong one.

use super::super::Polynomial;
use super::matrix::Matrix;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

/// The largest denominator of a guessed kernel.
const DENOMINATOR: u32 = 64;

/// How near to a fraction an entry of the kernel is.
const NEAR: f64 = 2e-3;

/// The smallest pivot of the kernel's echelon form.
const PIVOT: f64 = 1e-3;

/// Polynomials that span what the kernel of a matrix leaves of these; `None` where the matrix has no kernel. An eigenvalue counts as 0
/// if it is less than `share` of the largest.
pub(super) fn complement(roots: &[Polynomial], gram: &Matrix, share: f64) -> Option<Vec<Polynomial>> {
    let values = gram.eigenvectors();
    let largest = values.iter().map(|e| e.0).fold(0.0, f64::max);
    // The matrices of other blocks may be large where this one is all 0.
    let vectors: Vec<Vec<f64>> = values.into_iter().filter(|e| e.0 < share * largest.max(share)).map(|e| e.1).collect();
    let kernel = rational(echelon(vectors));
    (!kernel.is_empty()).then(|| orthogonal(&kernel, roots))
}

/// The reduced echelon form, by Gauss and Jordan with the largest pivot of a column.
fn echelon(mut rows: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let width = rows.first().map_or(0, Vec::len);
    let mut done = 0;
    for column in 0..width {
        let size = |i: &usize| rows[*i][column].abs();
        let Some(best) = (done..rows.len()).max_by(|a, b| size(a).total_cmp(&size(b))) else { break };
        if size(&best) < PIVOT {
            continue;
        }
        rows.swap(done, best);
        let pivot = rows[done][column];
        rows[done].iter_mut().for_each(|x| *x /= pivot);
        let row = rows[done].clone();
        for (i, other) in rows.iter_mut().enumerate() {
            let factor = other[column];
            if i != done {
                other.iter_mut().zip(&row).for_each(|(x, y)| *x -= factor * y);
            }
        }
        done += 1;
    }
    rows.truncate(done);
    rows
}

/// The rows whose entries are all near fractions with small denominators.
fn rational(rows: Vec<Vec<f64>>) -> Vec<Vec<Rational>> {
    rows.into_iter().filter_map(|row| row.into_iter().map(fraction).collect()).collect()
}

/// The fraction with the smallest denominator near a number.
fn fraction(x: f64) -> Option<Rational> {
    (1..=DENOMINATOR).find_map(|d| {
        let scaled = x * f64::from(d);
        let near = (scaled - scaled.round()).abs() < NEAR / f64::from(d) && scaled.abs() < 1e6;
        #[allow(clippy::cast_possible_truncation)] // below 10^6
        near.then(|| Rational::from_signeds(scaled.round() as i64, i64::from(d)))
    })
}

/// The sums of polynomials whose coefficients are orthogonal to these rows, which are in echelon form but for rows left out.
fn orthogonal(kernel: &[Vec<Rational>], roots: &[Polynomial]) -> Vec<Polynomial> {
    let mut rows = kernel.to_vec();
    let mut pivots: Vec<usize> = Vec::new();
    for column in 0..roots.len() {
        let done = pivots.len();
        let Some(at) = (done..rows.len()).find(|i| rows[*i][column] != 0) else { continue };
        rows.swap(done, at);
        let unit = Rational::ONE / &rows[done][column];
        rows[done].iter_mut().for_each(|x| *x *= &unit);
        let row = rows[done].clone();
        for (i, other) in rows.iter_mut().enumerate() {
            let factor = other[column].clone();
            if i != done && factor != 0 {
                other.iter_mut().zip(&row).for_each(|(x, y)| *x -= &factor * y);
            }
        }
        pivots.push(column);
    }
    let free = (0..roots.len()).filter(|c| !pivots.contains(c));
    free.map(|f| {
        let taken_off = |sum: Polynomial, (row, pivot): (&Vec<Rational>, &usize)| match &row[f] {
            c if *c == Rational::ZERO => sum,
            c => sum.sub(&roots[*pivot].scale(c)),
        };
        rows.iter().zip(&pivots).fold(roots[f].clone(), taken_off)
    })
    .collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    #[test]
    fn what_is_left_vanishes_where_the_kernel_says() {
        // Zero at (x, y) = (1, 2): the kernel of x², x·y, y² is (1, 2, 4).
        let [x, y] = [0, 1].map(Polynomial::variable);
        let roots = [x.mul(&x), x.mul(&y), y.mul(&y)];
        let kernel = vec![[1, 2, 4].map(Rational::from).to_vec()];
        let left = orthogonal(&kernel, &roots);
        assert_eq!(left.len(), 2);
        for p in left {
            assert_eq!(p.evaluate(&|v| Rational::from(v + 1)), Rational::ZERO);
        }
    }

    #[test]
    fn a_number_far_from_small_fractions_is_no_fraction() {
        assert_eq!(fraction(-0.333_333_4), Some(Rational::from_signeds(-1i64, 3i64)));
        assert_eq!(fraction(std::f64::consts::SQRT_2), None);
    }
}
