//! Linear programs over products of facts: nonnegative weights with which known polynomials add up to a wanted one.

use crate::algebra::simplex::{Column, SimplexLimits, solve};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::Label;
use crate::claim::syntax::Expr;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::BTreeMap;

/// A polynomial known to be 0, not negative, or positive.
#[derive(Clone, Debug)]
pub(crate) struct Known {
    /// The polynomial.
    pub poly: Polynomial,
    /// Its known sign.
    pub kind: Kind,
    /// Facts whose differences, multiplied together and by `factors`, give the polynomial.
    pub facts: Vec<Label>,
    /// Expressions that multiply the differences.
    pub factors: Vec<Expr>,
    /// Number of facts in the product; squares and letters do not count.
    pub order: usize,
}

/// The known sign of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// It is 0.
    Zero,
    /// It is not negative.
    Weak,
    /// It is positive.
    Strict,
}

impl Kind {
    /// The known sign of a product.
    pub(crate) fn times(self, other: Kind) -> Kind {
        match (self, other) {
            (Kind::Zero, _) | (_, Kind::Zero) => Kind::Zero,
            (Kind::Strict, Kind::Strict) => Kind::Strict,
            _ => Kind::Weak,
        }
    }
}

impl Known {
    /// The number 1, which is positive.
    pub(super) fn one() -> Known {
        let factors = vec![crate::kernel::statement::numeral(1)];
        Known { poly: Polynomial::one(), kind: Kind::Strict, facts: Vec::new(), factors, order: 0 }
    }

    /// The product of two; `None` if it has too many terms or too high a degree.
    pub(crate) fn times(&self, other: &Known) -> Option<Known> {
        let poly = self.poly.try_mul(&other.poly).ok()?;
        if poly.term_count() > 80 || poly.degree() > 12 {
            return None;
        }
        Some(Known {
            poly,
            kind: self.kind.times(other.kind),
            facts: self.facts.iter().chain(&other.facts).cloned().collect(),
            factors: self.factors.iter().chain(&other.factors).cloned().collect(),
            order: self.order + other.order,
        })
    }
}

/// Limits on the work of one linear program.
const LIMITS: SimplexLimits = SimplexLimits { pivots: 250, work: 400_000 };

/// Weights λ with Σ λ·column = wanted. A column known to be 0 may have a weight of any sign; all other weights are
/// at least 0. With `strict`, some column known to be positive has a positive weight.
pub(super) fn combination(wanted: &Polynomial, columns: &[Known], strict: bool) -> Option<Vec<(usize, Rational)>> {
    let mut rows: BTreeMap<Monomial, usize> = BTreeMap::new();
    let mut signed: Vec<(usize, bool)> = Vec::new();
    let mut matrix: Vec<Column> = Vec::new();
    let polys = columns.iter().map(|c| &c.poly).chain([wanted]);
    for (m, _) in polys.flat_map(|p| p.terms()) {
        let next = rows.len();
        rows.entry(m.clone()).or_insert(next);
    }
    for (place, column) in columns.iter().enumerate() {
        let entries = |flip: bool| -> Column {
            let entry =
                |(m, c): (&Monomial, &Rational)| rows.get(m).map(|row| (*row, if flip { -c } else { c.clone() }));
            column.poly.terms().filter_map(entry).collect()
        };
        for flip in [false, true] {
            if !flip || column.kind == Kind::Zero {
                matrix.push(entries(flip));
                signed.push((place, flip));
            }
        }
    }
    let mut target = vec![Rational::ZERO; rows.len()];
    for (m, c) in wanted.terms() {
        if let Some(row) = rows.get(m) {
            target[*row] = c.clone();
        }
    }
    let marked: Vec<bool> = signed.iter().map(|(place, _)| columns[*place].kind == Kind::Strict).collect();
    let solution = solve(&matrix, &target, strict.then_some(marked.as_slice()), &LIMITS).ok()??;
    let weighted = signed.iter().zip(solution).filter(|(_, weight)| *weight != Rational::ZERO);
    Some(weighted.map(|((place, flip), weight)| (*place, if *flip { -weight } else { weight })).collect())
}

/// Weights with which columns add up to 0, so that some positive column has a positive weight.
pub(crate) fn contradiction(columns: &[Known]) -> Option<Vec<(usize, Rational)>> {
    // One more row, with an unknown of its own, makes the weights of positive columns add up to 1.
    let unit = u32::MAX;
    let one = Polynomial::variable(unit);
    let mut list: Vec<Known> = columns.to_vec();
    for column in &mut list {
        if column.kind == Kind::Strict {
            column.poly = column.poly.add(&one);
        }
    }
    combination(&one, &list, false)
}

/// The monomials m for which m² may occur in a sum of squares that is p: 2·m lies in the convex hull of p's exponents.
pub(super) fn halves(p: &Polynomial, most: usize) -> Vec<Polynomial> {
    let letters = p.variables();
    if letters.len() > 8 || p.term_count() > 60 {
        return Vec::new();
    }
    let exponents = |m: &Monomial| -> Vec<u32> {
        let of = |v: &u32| m.powers().iter().find(|p| p.0 == *v).map_or(0, |p| p.1);
        letters.iter().map(of).collect()
    };
    let support: Vec<Vec<u32>> = p.terms().map(|(m, _)| exponents(m)).collect();
    let most_of: Vec<u32> = (0..letters.len()).map(|i| support.iter().map(|s| s[i]).max().unwrap_or(0) / 2).collect();
    let total = |list: &[u32]| list.iter().sum::<u32>();
    let (low, high) = (
        support.iter().map(|s| total(s)).min().unwrap_or(0).div_ceil(2),
        support.iter().map(|s| total(s)).max().unwrap_or(0) / 2,
    );
    let mut candidates: Vec<Vec<u32>> = vec![Vec::new()];
    for bound in &most_of {
        candidates = candidates
            .iter()
            .flat_map(|c| (0..=*bound).map(move |k| c.iter().copied().chain([k]).collect::<Vec<u32>>()))
            .filter(|c| total(c) <= high)
            .take(2000)
            .collect();
    }
    candidates.retain(|c| total(c) >= low && total(c) <= high);
    let matrix: Vec<Column> = support
        .iter()
        .map(|s| {
            let own = s.iter().enumerate().filter(|(_, k)| **k > 0).map(|(i, k)| (i, Rational::from(*k)));
            own.chain([(letters.len(), Rational::ONE)]).collect()
        })
        .collect();
    let inside = |c: &Vec<u32>| {
        let target: Vec<Rational> = c.iter().map(|k| Rational::from(2 * k)).chain([Rational::ONE]).collect();
        matches!(solve(&matrix, &target, None, &LIMITS), Ok(Some(_)))
    };
    candidates.truncate(120);
    let mut kept: Vec<Vec<u32>> = candidates.into_iter().filter(inside).collect();
    kept.truncate(most);
    let monomial = |c: &Vec<u32>| {
        let powers: Vec<(u32, u32)> = letters.iter().copied().zip(c.iter().copied()).filter(|p| p.1 > 0).collect();
        Some(Polynomial::term(Monomial::new(&powers).ok()?, Rational::ONE))
    };
    kept.iter().filter_map(monomial).collect()
}

/// Linear forms, with constants, whose squares with positive weights add up to a polynomial of degree two, if there are
/// such: one variable after the other is completed to a square.
pub(crate) fn completed_squares(p: &Polynomial) -> Vec<Polynomial> {
    let mut rest = p.clone();
    let mut out = Vec::new();
    if p.degree() != 2 {
        return out;
    }
    for v in p.variables() {
        let parts = rest.coefficients_in(v);
        match parts.as_slice() {
            [_, linear, lead] => {
                let Some(c) = lead.as_constant().filter(|c| *c > 0) else { return Vec::new() };
                // c·v² + l·v = c·(v + l/(2c))² − l²/(4c).
                let half = linear.scale(&(Rational::ONE / (Rational::from(2) * &c)));
                let form = Polynomial::variable(v).add(&half);
                rest = rest.sub(&form.mul(&form).scale(&c));
                out.push(form);
            }
            [_, linear] if !linear.is_zero() => return Vec::new(),
            _ => {}
        }
    }
    out
}

/// Forms whose squares show the sign of a polynomial that is quadratic in a variable: of L·v² + M·v + N, 2·L·v + M, since
/// 4·L·(L·v² + M·v + N) = (2·L·v + M)² + (4·L·N − M²).
pub(crate) fn discriminant_forms(p: &Polynomial) -> Vec<Polynomial> {
    let of = |v: u32| match p.coefficients_in(v).as_slice() {
        [_, linear, lead] if !linear.is_zero() => {
            let lead = lead.mul(&Polynomial::variable(v));
            Some(lead.scale(&Rational::from(2)).add(linear)).filter(|form| form.term_count() <= 6)
        }
        _ => None,
    };
    p.variables().into_iter().filter_map(of).take(4).collect()
}
