//! Non-negative solutions of linear equations over the rationals, by the simplex method.
//!
//! Contract: [`solve`] finds rational `λ ≥ 0` with `A·λ = b`, or shows that there is none, or stops at
//! a limit. A solution can be asked to have a preferred unknown that is not 0. Everything is exact;
//! a solution is a vertex, so at most as many unknowns as equations are not 0.
//!
//! Method: equations that fix unknowns to 0 by their signs are used up first; phase one removes
//! artificial unknowns, phase two increases the preferred ones. The entering unknown is the one
//! with the steepest reduced cost until a pivot makes no progress, and then the first one (Bland's
//! rule, which cannot cycle) until one does.
//!
//! Cost: every pivot updates the whole tableau, skipping zeros; the updates are counted.

use super::polynomial::within;
use super::{Limit, LimitReached};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

/// One column of the matrix: the rows where it is not 0, with the entries.
pub type Column = Vec<(usize, Rational)>;

/// What one program may cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SimplexLimits {
    /// Pivots.
    pub pivots: usize,
    /// Updates of tableau entries.
    pub work: usize,
}

/// A solution `λ ≥ 0` of `Σ λⱼ·columnⱼ = target`, where there is one. With `preferred`, one in which
/// some unknown marked there is positive.
///
/// # Errors
/// [`LimitReached`] when a limit stops the search; nothing is known then.
pub fn solve(
    columns: &[Column],
    target: &[Rational],
    preferred: Option<&[bool]>,
    limits: &SimplexLimits,
) -> Result<Option<Vec<Rational>>, LimitReached> {
    let Some(kept) = useful_columns(columns, target) else {
        return Ok(None);
    };
    let mut tableau = Tableau::new(columns, target, &kept, *limits);
    if !tableau.remove_artificials()? {
        return Ok(None);
    }
    if let Some(preferred) = preferred {
        let marked: Vec<bool> = kept.iter().map(|&j| preferred[j]).collect();
        if !tableau.raise(&marked)? {
            return Ok(None);
        }
    }
    let mut solution = vec![Rational::ZERO; columns.len()];
    for (&place, value) in kept.iter().zip(tableau.solution()) {
        solution[place] = value;
    }
    Ok(Some(solution))
}

/// The columns that may be positive; `None` where the signs of a row alone exclude a solution.
///
/// Why it is right: in a row with target 0 whose entries have one sign, every unknown with an entry
/// is 0; a row with a positive target needs a positive entry, one with a negative target a negative
/// one.
fn useful_columns(columns: &[Column], target: &[Rational]) -> Option<Vec<usize>> {
    let mut positive = vec![0usize; target.len()];
    let mut negative = vec![0usize; target.len()];
    for (row, entry) in columns.iter().flatten() {
        let count = if *entry > Rational::ZERO { &mut positive } else { &mut negative };
        count[*row] += 1;
    }
    let mut kept: Vec<usize> = (0..columns.len()).collect();
    loop {
        for (row, value) in target.iter().enumerate() {
            if *value > Rational::ZERO && positive[row] == 0 || *value < Rational::ZERO && negative[row] == 0 {
                return None;
            }
        }
        let forced = |row: usize| target[row] == Rational::ZERO && (positive[row] == 0 || negative[row] == 0);
        let (dropped, rest): (Vec<usize>, Vec<usize>) =
            kept.iter().partition(|&&j| columns[j].iter().any(|(row, _)| forced(*row)));
        if dropped.is_empty() {
            return Some(rest);
        }
        for (row, entry) in dropped.iter().flat_map(|&j| &columns[j]) {
            let count = if *entry > Rational::ZERO { &mut positive } else { &mut negative };
            count[*row] -= 1;
        }
        kept = rest;
    }
}

/// The rows of the equations, solved for the basic unknowns.
struct Tableau {
    /// One row for each equation: the entries of all columns, and the right side last.
    rows: Vec<Vec<Rational>>,
    /// The basic unknown of each row; none while it is the row's artificial one.
    basis: Vec<Option<usize>>,
    width: usize,
    limits: SimplexLimits,
    pivots: usize,
    work: usize,
}

impl Tableau {
    fn new(columns: &[Column], target: &[Rational], kept: &[usize], limits: SimplexLimits) -> Self {
        let width = kept.len();
        let mut rows = vec![vec![Rational::ZERO; width + 1]; target.len()];
        for (place, &j) in kept.iter().enumerate() {
            for (row, entry) in &columns[j] {
                rows[*row][place] = entry.clone();
            }
        }
        for (row, value) in rows.iter_mut().zip(target) {
            row[width] = value.clone();
            if *value < Rational::ZERO {
                for entry in row.iter_mut() {
                    *entry = -&*entry;
                }
            }
        }
        rows.retain(|row| row.iter().any(|entry| *entry != Rational::ZERO));
        let basis = vec![None; rows.len()];
        Self { rows, basis, width, limits, pivots: 0, work: 0 }
    }

    /// Phase one: makes the artificial unknowns 0; whether that is possible.
    fn remove_artificials(&mut self) -> Result<bool, LimitReached> {
        // The gain of an unknown is the rate at which the sum of the artificial ones falls.
        let mut gains = vec![Rational::ZERO; self.width + 1];
        for row in &self.rows {
            for (gain, entry) in gains.iter_mut().zip(row) {
                *gain += entry;
            }
        }
        self.improve(&mut gains, |gains| gains.last() == Some(&Rational::ZERO))?;
        if gains.last() != Some(&Rational::ZERO) {
            return Ok(false);
        }
        // What is still artificial is 0: exchange it, or drop a row that says nothing.
        for row in (0..self.rows.len()).rev() {
            if self.basis[row].is_some() {
                continue;
            }
            let entry = self.rows[row][..self.width].iter().position(|e| *e != Rational::ZERO);
            match entry {
                Some(column) => self.pivot(row, column, &mut [])?,
                None => {
                    self.rows.remove(row);
                    self.basis.remove(row);
                }
            }
        }
        Ok(true)
    }

    /// Phase two: makes some marked unknown positive; whether that is possible.
    fn raise(&mut self, marked: &[bool]) -> Result<bool, LimitReached> {
        // Reduced costs of maximising the sum of the marked unknowns; the last entry is minus it.
        let one_if = |mark: bool| if mark { Rational::ONE } else { Rational::ZERO };
        let mut gains: Vec<Rational> = marked.iter().map(|&mark| one_if(mark)).collect();
        gains.push(Rational::ZERO);
        for (row, basic) in self.rows.iter().zip(&self.basis) {
            if basic.is_some_and(|j| marked[j]) {
                for (gain, entry) in gains.iter_mut().zip(row) {
                    *gain -= entry;
                }
            }
        }
        let ray = self.improve(&mut gains, |gains| gains.last().is_some_and(|value| *value < Rational::ZERO))?;
        if let Some(column) = ray {
            // The sum grows without bound along this column: one step of length 1.
            for row in &mut self.rows {
                let step = row[column].clone();
                row[self.width] -= step;
            }
            self.rows.push(vec![Rational::ZERO; self.width + 1]);
            if let Some(last) = self.rows.last_mut() {
                last[self.width] = Rational::ONE;
            }
            self.basis.push(Some(column));
            return Ok(true);
        }
        Ok(gains.last().is_some_and(|value| *value < Rational::ZERO))
    }

    /// Pivots while some gain is positive and the goal is not reached. Returns the column of an
    /// unbounded direction, where one is met.
    fn improve(
        &mut self,
        gains: &mut [Rational],
        reached: impl Fn(&[Rational]) -> bool,
    ) -> Result<Option<usize>, LimitReached> {
        let mut steepest = true;
        while !reached(gains) {
            let candidates = (0..self.width).filter(|&j| gains[j] > Rational::ZERO);
            let entering = if steepest {
                candidates.reduce(|best, j| if gains[j] > gains[best] { j } else { best })
            } else {
                candidates.min()
            };
            let Some(column) = entering else {
                return Ok(None);
            };
            let Some((row, ratio)) = self.leaving(column) else {
                return Ok(Some(column));
            };
            steepest = ratio > Rational::ZERO;
            self.pivot(row, column, gains)?;
        }
        Ok(None)
    }

    /// The row that limits an entering unknown, with the limit; among equals the one whose basic
    /// unknown comes first, artificial ones before all.
    fn leaving(&self, column: usize) -> Option<(usize, Rational)> {
        let mut best: Option<(usize, Rational)> = None;
        for (i, row) in self.rows.iter().enumerate() {
            if row[column] <= Rational::ZERO {
                continue;
            }
            let ratio = &row[self.width] / &row[column];
            let better = best
                .as_ref()
                .is_none_or(|(k, least)| ratio < *least || ratio == *least && self.basis[i] < self.basis[*k]);
            if better {
                best = Some((i, ratio));
            }
        }
        best
    }

    /// Solves one row for an unknown and removes it from all other rows and from the gains.
    fn pivot(&mut self, row: usize, column: usize, gains: &mut [Rational]) -> Result<(), LimitReached> {
        self.pivots += 1;
        within(Limit::Pivots, self.limits.pivots, self.pivots)?;
        let inverse = Rational::ONE / &self.rows[row][column];
        let mut pivot_row = std::mem::take(&mut self.rows[row]);
        for entry in &mut pivot_row {
            if *entry != Rational::ZERO {
                *entry *= &inverse;
            }
        }
        let filled: Vec<usize> = (0..=self.width).filter(|&j| pivot_row[j] != Rational::ZERO).collect();
        let eliminate = |other: &mut [Rational]| {
            let factor = match other.get(column) {
                Some(factor) if *factor != Rational::ZERO => factor.clone(),
                _ => return 0,
            };
            for &j in &filled {
                other[j] -= &factor * &pivot_row[j];
            }
            filled.len()
        };
        for other in &mut self.rows {
            self.work += eliminate(other);
        }
        self.work += eliminate(gains);
        self.rows[row] = pivot_row;
        self.basis[row] = Some(column);
        within(Limit::Work, self.limits.work, self.work)
    }

    /// The values of the unknowns.
    fn solution(&self) -> Vec<Rational> {
        let mut values = vec![Rational::ZERO; self.width];
        for (row, basic) in self.rows.iter().zip(&self.basis) {
            if let Some(j) = basic {
                values[*j] += &row[self.width];
            }
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::{Column, SimplexLimits, solve};
    use malachite::Rational;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn linear_programs_find_solutions_that_exist(
        entries in prop::collection::vec(prop::collection::vec(-3i64..=3, 6), 3),
        solution in prop::collection::vec(0i64..4, 6),
    ) {
        let columns: Vec<Column> = (0..6).map(|j| {
            (0..3).filter(|&i| entries[i][j] != 0).map(|i| (i, Rational::from(entries[i][j]))).collect()
        }).collect();
        let target: Vec<Rational> = (0..3).map(|i| {
            Rational::from((0..6).map(|j| entries[i][j] * solution[j]).sum::<i64>())
        }).collect();
        let limits = SimplexLimits { pivots: 200, work: 100_000 };
        let marked: Vec<bool> = solution.iter().map(|&value| value > 0).collect();
        for preferred in [None, marked.contains(&true).then_some(marked.as_slice())] {
            let found = solve(&columns, &target, preferred, &limits).expect("small").expect("solvable");
            prop_assert!(found.iter().all(|value| *value >= 0));
            for i in 0..3 {
                let sum: Rational = (0..6).map(|j| Rational::from(entries[i][j]) * &found[j]).sum();
                prop_assert_eq!(&sum, &target[i]);
            }
            if let Some(marked) = preferred {
                prop_assert!(found.iter().zip(marked).any(|(value, &mark)| mark && *value > 0));
            }
        }
    }
    }

    #[test]
    fn linear_programs_without_solution_are_recognised() {
        let r = Rational::from;
        let limits = SimplexLimits { pivots: 200, work: 100_000 };
        // λ₁ − λ₂ = 1 and λ₁ − λ₂ = 2.
        let columns: Vec<Column> = vec![vec![(0, r(1)), (1, r(1))], vec![(0, r(-1)), (1, r(-1))]];
        assert_eq!(solve(&columns, &[r(1), r(2)], None, &limits), Ok(None));
        // A marked unknown that every solution has at 0.
        let columns: Vec<Column> = vec![vec![(0, r(1))], vec![(0, r(1)), (1, r(1))], vec![(1, r(1))]];
        let marked = [false, true, false];
        assert_eq!(solve(&columns, &[r(1), r(0)], Some(&marked), &limits), Ok(None));
        assert!(matches!(solve(&columns, &[r(1), r(1)], Some(&marked), &limits), Ok(Some(_))));
    }
}
