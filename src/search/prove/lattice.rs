//! Vectors with rational coordinates, written by some of them with whole coefficients. A polynomial is the vector of its
//! coefficients.

use crate::algebra::{Monomial, Polynomial};
use malachite::base::num::arithmetic::traits::{DivRound, Lcm, UnsignedAbs};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::rounding_modes::RoundingMode;
use malachite::{Integer, Natural, Rational};
use std::collections::BTreeSet;

/// The monomials of vectors, each once, in the order of their powers.
fn monomials<'p>(vectors: impl Iterator<Item = &'p Polynomial>) -> Vec<&'p Monomial> {
    let mut out: Vec<&Monomial> =
        vectors.flat_map(|p| p.terms().map(|t| t.0)).collect::<BTreeSet<_>>().into_iter().collect();
    out.sort_by(|m, n| m.powers().cmp(n.powers()));
    out
}

/// The coefficients with which a basis gives a vector; nothing where the basis depends on itself or does not reach the vector.
fn coordinates(basis: &[Polynomial], target: &Polynomial) -> Option<Vec<Rational>> {
    let all = || basis.iter().chain([target]);
    let mut rows: Vec<Vec<Rational>> =
        monomials(all()).into_iter().map(|m| all().map(|p| p.coefficient(m)).collect()).collect();
    let width = basis.len();
    for column in 0..width {
        let place = (column..rows.len()).find(|r| rows[*r][column] != 0)?;
        rows.swap(column, place);
        let lead: Vec<Rational> = rows[column].iter().map(|c| c / &rows[column][column]).collect();
        for (r, row) in rows.iter_mut().enumerate() {
            if r != column && row[column] != 0 {
                let factor = row[column].clone();
                row.iter_mut().zip(&lead).for_each(|(c, l)| *c -= &factor * l);
            }
        }
        rows[column] = lead;
    }
    if rows.iter().skip(width).any(|row| row[width] != 0) {
        return None;
    }
    Some(rows.iter().take(width).map(|row| row[width].clone()).collect())
}

/// The same, where all coefficients are whole.
pub(super) fn whole_coordinates(basis: &[Polynomial], target: &Polynomial) -> Option<Vec<i64>> {
    let whole = |k: Rational| i64::try_from(&Integer::try_from(k).ok()?).ok();
    coordinates(basis, target)?.into_iter().map(whole).collect()
}

/// The places of vectors that give all with whole coefficients, the first in lexicographic order among this many choices that
/// `may` be taken.
pub(super) fn chosen(vectors: &[Polynomial], choices: usize, may: &dyn Fn(&[usize]) -> bool) -> Option<Vec<usize>> {
    let mut independent: Vec<Polynomial> = Vec::new();
    for v in vectors {
        if coordinates(&independent, v).is_none() {
            independent.push(v.clone());
        }
    }
    let size = independent.len();
    let mut places: Vec<usize> = (0..size).collect();
    for _ in 0..choices {
        let basis: Vec<Polynomial> = places.iter().map(|p| vectors[*p].clone()).collect();
        if may(&places) && vectors.iter().all(|v| whole_coordinates(&basis, v).is_some()) {
            return Some(places);
        }
        let at = (0..size).rev().find(|i| places[*i] < vectors.len() - size + i)?;
        places[at] += 1;
        for i in at + 1..size {
            places[i] = places[i - 1] + 1;
        }
    }
    None
}

/// A basis of the lattice that vectors span, by row reduction over the whole numbers. The first coefficient of each is positive.
pub(super) fn reduced(vectors: &[Polynomial]) -> Vec<Polynomial> {
    let keys = monomials(vectors.iter());
    let denominators = vectors.iter().flat_map(|p| p.terms().map(|t| t.1.denominator_ref()));
    let scale = Rational::from(denominators.fold(Natural::ONE, |n, d| n.lcm(d)));
    let whole = |c: Rational| Integer::try_from(c * &scale).unwrap_or(Integer::ZERO);
    let mut rows: Vec<Vec<Integer>> =
        vectors.iter().map(|p| keys.iter().map(|m| whole(p.coefficient(m))).collect()).collect();
    let mut done = 0;
    for column in 0..keys.len() {
        loop {
            let mut open: Vec<usize> = (done..rows.len()).filter(|r| rows[*r][column] != 0).collect();
            open.sort_by_key(|r| (&rows[*r][column]).unsigned_abs());
            let Some((&first, others)) = open.split_first() else { break };
            if others.is_empty() {
                rows.swap(done, first);
                done += 1;
                break;
            }
            let lead = rows[first].clone();
            for &r in others {
                let factor = (&rows[r][column]).div_round(&lead[column], RoundingMode::Floor).0;
                rows[r].iter_mut().zip(&lead).for_each(|(c, l)| *c -= &factor * l);
            }
        }
    }
    let vector = |row: &Vec<Integer>| {
        let flip = row.iter().find(|c| **c != 0).is_some_and(|c| *c < 0);
        let coefficient = |c: &Integer| Rational::from(if flip { -c } else { c.clone() }) / &scale;
        Polynomial::from_terms(keys.iter().zip(row).map(|(m, c)| ((*m).clone(), coefficient(c))))
    };
    rows.iter().take(done).map(vector).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vector(coefficients: [(i64, i64); 2]) -> Polynomial {
        let [(a, b), (c, d)] = coefficients;
        let entry = |v, n, d| Polynomial::variable(v).scale(&Rational::from_signeds(n, d));
        entry(0, a, b).add(&entry(1, c, d))
    }

    #[test]
    fn a_vector_has_the_coordinates_that_give_it_back() {
        let basis = [vector([(1, 2), (0, 1)]), vector([(1, 1), (1, 3)])];
        assert_eq!(whole_coordinates(&basis, &vector([(5, 2), (1, 1)])), Some(vec![-1, 3]));
        assert_eq!(whole_coordinates(&basis, &vector([(1, 4), (0, 1)])), None);
        assert_eq!(whole_coordinates(&[basis[0].clone()], &vector([(0, 1), (1, 1)])), None);
    }

    #[test]
    fn a_reduced_basis_gives_all_vectors_with_whole_coefficients() {
        let all = [vector([(1, 2), (1, 3)]), vector([(1, 3), (-1, 1)]), vector([(2, 1), (5, 6)])];
        assert_eq!(chosen(&all, 10, &|_| true), None);
        let basis = reduced(&all);
        assert_eq!(basis.len(), 2);
        assert!(all.iter().all(|v| whole_coordinates(&basis, v).is_some()));
    }
}
