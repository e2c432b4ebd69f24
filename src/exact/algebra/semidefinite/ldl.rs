//! A symmetric matrix of rationals as a sum of squares, where it is positive semidefinite.

use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

/// Weights d > 0 and vectors v with Σ d·v·vᵀ = Q, by LDLᵀ; `None` where Q is not positive semidefinite.
///
/// Why it is right: after each step what is left is Q less the squares so far, and is 0 in the rows of these. A pivot below 0, or a
/// pivot 0 in a row that is not 0, is a vector at which Q is negative.
pub(super) fn squares(mut q: Vec<Vec<Rational>>) -> Option<Vec<(Rational, Vec<Rational>)>> {
    let n = q.len();
    let mut out = Vec::new();
    for i in 0..n {
        let pivot = q[i][i].clone();
        if pivot < 0 {
            return None;
        }
        if pivot == 0 {
            if (i..n).any(|j| q[i][j] != 0) {
                return None;
            }
            continue;
        }
        let unit = Rational::ONE / &pivot;
        let mut vector = vec![Rational::ZERO; n];
        for j in i..n {
            vector[j] = &q[i][j] * &unit;
        }
        for a in i + 1..n {
            if vector[a] == 0 {
                continue;
            }
            let factor = &vector[a] * &pivot;
            for b in a..n {
                if vector[b] != 0 {
                    let taken_off = &factor * &vector[b];
                    q[a][b] -= taken_off;
                }
            }
        }
        out.push((pivot, vector));
    }
    Some(out)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    fn matrix(rows: [[i32; 3]; 3]) -> Vec<Vec<Rational>> {
        rows.iter().map(|r| r.iter().map(|x| Rational::from(*x)).collect()).collect()
    }

    #[test]
    fn the_squares_add_up_to_the_matrix() {
        let q = matrix([[4, 2, -2], [2, 1, -1], [-2, -1, 5]]);
        let found = squares(q.clone()).unwrap();
        assert_eq!(found.len(), 2, "the rank");
        for i in 0..3 {
            for j in 0..3 {
                let sum = found.iter().fold(Rational::ZERO, |s, (d, v)| s + d * &v[i] * &v[j]);
                assert_eq!(sum, q[i][j]);
            }
        }
    }

    #[test]
    fn a_negative_direction_is_found_where_no_entry_of_the_diagonal_is_negative() {
        assert!(squares(matrix([[1, 2, 0], [2, 1, 0], [0, 0, 1]])).is_none());
        assert!(squares(matrix([[0, 1, 0], [1, 5, 0], [0, 0, 1]])).is_none());
    }
}
