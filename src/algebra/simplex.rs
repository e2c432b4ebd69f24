//! Exact linear feasibility: λ ≥ 0 with A λ = b, by the first phase of the simplex method.
//!
//! Contract: a returned λ satisfies the system exactly. `None` means that there is none, or that
//! [`PIVOTS_LIMIT`] was reached. Bland's rule excludes cycles.

use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

/// The most pivots.
pub const PIVOTS_LIMIT: usize = 600;

/// A solution λ ≥ 0 of Σ λⱼ·columnⱼ = right, columns as sparse lists (row, value).
pub fn feasible(rows: usize, columns: &[Vec<(usize, Rational)>], right: &[Rational]) -> Option<Vec<Rational>> {
    let width = columns.len();
    // Tableau: columns, then artificial variables, then the right side.
    let mut table = vec![vec![Rational::ZERO; width + 1]; rows];
    for (j, column) in columns.iter().enumerate() {
        for (i, value) in column {
            table[*i][j] += value;
        }
    }
    for (row, value) in table.iter_mut().zip(right) {
        row[width] = value.clone();
        if row[width] < 0 {
            for entry in row.iter_mut() {
                *entry = -&*entry;
            }
        }
    }
    // Artificial variable i is basic in row i; it is never needed again once it leaves.
    let mut basis: Vec<Option<usize>> = vec![None; rows];
    // The objective: the sum of the artificial variables, as reduced costs.
    let mut cost = vec![Rational::ZERO; width + 1];
    for row in &table {
        for (c, entry) in cost.iter_mut().zip(row) {
            *c += entry;
        }
    }
    for _ in 0..PIVOTS_LIMIT {
        if cost[width] == 0 {
            let mut out = vec![Rational::ZERO; width];
            for (row, basic) in table.iter().zip(&basis) {
                if let Some(j) = basic {
                    out[*j] = row[width].clone();
                }
            }
            return Some(out);
        }
        let enter = (0..width).find(|&j| cost[j] > 0)?;
        let mut leave: Option<(usize, Rational)> = None;
        for (i, row) in table.iter().enumerate() {
            if row[enter] > 0 {
                let ratio = &row[width] / &row[enter];
                let better = match &leave {
                    None => true,
                    Some((k, least)) => {
                        ratio < *least || (ratio == *least && basis[i].map_or(width + i, |b| b) < basis[*k].map_or(width + *k, |b| b))
                    }
                };
                if better {
                    leave = Some((i, ratio));
                }
            }
        }
        let (pivot, _) = leave?;
        let inverse = Rational::ONE / &table[pivot][enter];
        for entry in &mut table[pivot] {
            if *entry != 0 {
                *entry *= &inverse;
            }
        }
        let line = table[pivot].clone();
        for (i, row) in table.iter_mut().enumerate() {
            if i != pivot && row[enter] != 0 {
                let factor = row[enter].clone();
                for (entry, other) in row.iter_mut().zip(&line) {
                    if *other != 0 {
                        *entry -= other * &factor;
                    }
                }
            }
        }
        let factor = cost[enter].clone();
        for (entry, other) in cost.iter_mut().zip(&line) {
            if *other != 0 {
                *entry -= other * &factor;
            }
        }
        basis[pivot] = Some(enter);
    }
    None
}
