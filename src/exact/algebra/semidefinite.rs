//! Certificates of positivity by semidefinite programming: a polynomial as a sum of multipliers times sums of squares, exactly.
//!
//! Contract: [`Program::solve`] returns weights and polynomials with target = Σ weight·multiplier·root² + Σ weight·zero, where the
//! weights of squares are positive. The identity is exact: doubles only guide the search. No answer proves nothing.
//!
//! Method: a sum of squares of the polynomials b is bᵀ·Q·b for a positive semidefinite Gram matrix Q, and the identity is linear in
//! the entries of Q. An interior-point method finds Q with the largest least eigenvalue in doubles. Its entries are rounded to
//! rationals with small denominators first, those that the equations give are computed from the others, and LDLᵀ decides exactly
//! whether Q is positive semidefinite (H. Peyrl, P. Parrilo, "Computing sum of squares decompositions with rational coefficients", Theoret.
//! Comput. Sci. 409, 2008). Where every Q is singular, the squares are restricted to the complement of its kernel (`face`).
//!
//! The matrices are small: an equation that makes squares vanish takes them out, which leaves at most the monomials of the half
//! Newton polytope; and monomials whose exponents differ by no even combination of those that occur are in matrices of their own,
//! since changing signs of variables changes neither the target nor the multipliers (K. Gatermann, P. Parrilo, 2004).

mod face;
mod ideal;
mod identity;
mod interior_point;
mod ldl;
mod matrix;
mod monomials;

use super::{Monomial, Polynomial, Var};
pub use monomials::{half_newton_polytope, monomials};

use ideal::Span;
use identity::{Block, Identity};
use interior_point::Suggestion;
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
use matrix::Matrix;
use std::collections::{BTreeMap, BTreeSet};

/// The size of the largest Gram matrix.
const BLOCK: usize = 45;

/// How often the squares are restricted to the complement of a kernel.
const FACES: usize = 4;

/// What denominators entries are rounded to: short ones first, for short certificates.
const DENOMINATORS: [i64; 9] = [1, 2, 4, 12, 60, 1_000, 1 << 16, 1 << 30, 1 << 42];

/// The share of the largest eigenvalue below which one counts as 0, at first and later.
const SHARES: [f64; 2] = [1e-4, 1e-5];

/// How negative an eigenvalue may look that is 0, relative to the trace.
const ROUNDING: f64 = 1e-9;

/// A multiplier, and polynomials whose linear combinations are squared.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Summand {
    /// What the sum of squares is multiplied by.
    pub multiplier: Polynomial,
    /// The polynomials.
    pub roots: Vec<Polynomial>,
    /// Whether some summand that says so has to occur.
    pub wanted: bool,
}

/// What is wanted: target = Σ multiplier·(sum of squares) + Σ weight·zero.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Program {
    /// The left side.
    pub target: Polynomial,
    /// The multipliers.
    pub summands: Vec<Summand>,
    /// Polynomials with weights of any sign.
    pub zeros: Vec<Polynomial>,
}

/// A square with its weight, in the sum of squares of one summand.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Square {
    /// The place of the summand in the program.
    pub summand: usize,
    /// The weight, greater than 0.
    pub weight: Rational,
    /// What is squared.
    pub root: Polynomial,
}

/// An identity that holds.
#[derive(Clone, Debug)]
pub struct Identities {
    /// The squares.
    pub squares: Vec<Square>,
    /// The weights of the zeros that occur, by their place in the program.
    pub zeros: Vec<(usize, Rational)>,
}

impl Program {
    /// An identity, where the search finds one. It takes operations off the budget, and ends where that is used up.
    #[must_use]
    pub fn solve(&self, budget: &mut usize) -> Option<Identities> {
        let span = Span::new(&self.zeros);
        let mut blocks = self.blocks();
        let mut restricted = false;
        for face in 0..=FACES {
            let identity = Identity::new(&self.target, &blocks, &span)?;
            if identity.sizes().iter().any(|n| *n > BLOCK) {
                return None;
            }
            let found = interior_point::search(&identity.sizes(), &identity.conditions(), budget)?;
            let exact = DENOMINATORS.iter().find_map(|d| self.exact(&identity, &found, *d, &span));
            if exact.is_some() {
                return exact;
            }
            let share = SHARES[usize::from(face > 0)];
            blocks = identity.blocks.clone();
            for (block, gram) in blocks.iter_mut().zip(&found.grams) {
                if let Some(roots) = face::complement(&block.roots, gram, share) {
                    block.roots = roots;
                    restricted = true;
                }
            }
            if !std::mem::take(&mut restricted) {
                return None;
            }
            blocks.retain(|b| !b.roots.is_empty());
        }
        None
    }

    /// The identity with Gram matrices rounded to this denominator, if they are positive semidefinite.
    fn exact(&self, identity: &Identity, found: &Suggestion, denominator: i64, span: &Span) -> Option<Identities> {
        let mut squares = Vec::new();
        for (block, gram) in identity.blocks.iter().zip(identity.rounded(&found.grams, denominator)?) {
            if !may_be_positive(&gram) {
                return None;
            }
            for (weight, vector) in ldl::squares(gram)? {
                let parts = block.roots.iter().zip(&vector).filter(|p| *p.1 != Rational::ZERO);
                let root = parts.fold(Polynomial::zero(), |sum, (r, c)| sum.add(&r.scale(c)));
                let (content, root) = root.primitive_part();
                squares.push(Square { summand: block.origin, weight: weight * &content * &content, root });
            }
        }
        let is_wanted = |s: &Summand| s.wanted;
        let occurs = |s: &Square| self.summands.get(s.summand).is_some_and(is_wanted);
        if self.summands.iter().any(is_wanted) && !squares.iter().any(occurs) {
            return None;
        }
        let mut rest = self.target.clone();
        for square in &squares {
            let multiplier = &self.summands.get(square.summand)?.multiplier;
            rest = rest.sub(&multiplier.mul(&square.root).mul(&square.root).scale(&square.weight));
        }
        let (rest, zeros) = span.divided(&rest);
        rest.is_zero().then(|| Identities { squares, zeros: zeros.into_iter().collect() })
    }

    /// The summands, each once for every class of monomials of one parity.
    fn blocks(&self) -> Vec<Block> {
        let parities = self.parities();
        let mut out = Vec::new();
        for (origin, summand) in self.summands.iter().enumerate() {
            let mut classes: BTreeMap<BTreeSet<Var>, Vec<Polynomial>> = BTreeMap::new();
            for root in &summand.roots {
                let class = root.terms().next().map(|(m, _)| reduced(odd(m), &parities)).unwrap_or_default();
                classes.entry(class).or_default().push(root.clone());
            }
            let multiplier = &summand.multiplier;
            out.extend(classes.into_values().map(|roots| Block { origin, multiplier: multiplier.clone(), roots }));
        }
        out
    }

    /// The span of the parities of all monomials that occur, in echelon form.
    fn parities(&self) -> Vec<BTreeSet<Var>> {
        let mut out: Vec<BTreeSet<Var>> = Vec::new();
        let multipliers = self.summands.iter().map(|s| &s.multiplier);
        let mixed = self.summands.iter().flat_map(|s| &s.roots).filter(|r| r.term_count() > 1);
        // A polynomial that is no monomial joins the classes of its monomials.
        let joined: Vec<BTreeSet<Var>> = mixed
            .flat_map(|r| {
                let first = r.terms().next().map(|(m, _)| odd(m)).unwrap_or_default();
                r.terms().map(move |(m, _)| sum(&odd(m), &first)).collect::<Vec<_>>()
            })
            .collect();
        let plain = std::iter::once(&self.target).chain(multipliers).chain(&self.zeros);
        let all = plain.flat_map(|p| p.terms().map(|(m, _)| odd(m)).collect::<Vec<_>>());
        for parity in all.chain(joined) {
            let left = reduced(parity, &out);
            if !left.is_empty() {
                out.push(left);
            }
        }
        out
    }
}

/// Whether a matrix is positive semidefinite as far as doubles tell: where it is clearly not, exact arithmetic is saved.
fn may_be_positive(gram: &[Vec<Rational>]) -> bool {
    let size = gram.len();
    let mut doubles = Matrix::zero(size);
    for (i, row) in gram.iter().enumerate() {
        row.iter().enumerate().for_each(|(j, entry)| doubles.add_at(i, j, crate::number::double::nearest(entry)));
    }
    let trace: f64 = (0..size).map(|i| doubles.at(i, i)).sum();
    trace == 0.0 || doubles.plus(ROUNDING * trace, &Matrix::diagonal(size, 1.0)).cholesky().is_some()
}

/// The variables with odd exponents.
fn odd(m: &Monomial) -> BTreeSet<Var> {
    m.powers().iter().filter(|p| p.1 % 2 == 1).map(|p| p.0).collect()
}

/// The sum of two parities.
fn sum(a: &BTreeSet<Var>, b: &BTreeSet<Var>) -> BTreeSet<Var> {
    a.symmetric_difference(b).copied().collect()
}

/// A parity without the first variables of these, each of which lacks the first ones of those before it.
fn reduced(parity: BTreeSet<Var>, by: &[BTreeSet<Var>]) -> BTreeSet<Var> {
    by.iter().fold(parity, |p, q| match q.first() {
        Some(first) if p.contains(first) => sum(&p, q),
        _ => p,
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    fn variables<const N: usize>() -> [Polynomial; N] {
        std::array::from_fn(|i| Polynomial::variable(Var::try_from(i).unwrap()))
    }

    fn power(p: &Polynomial, k: u32) -> Polynomial {
        p.pow(k).unwrap()
    }

    fn sum_of(list: &[Polynomial]) -> Polynomial {
        list.iter().fold(Polynomial::zero(), |s, p| s.add(p))
    }

    fn times(k: i64, p: &Polynomial) -> Polynomial {
        p.scale(&Rational::from(k))
    }

    /// A polynomial as a plain sum of squares; the identity is checked here once more.
    fn sum_of_squares(target: &Polynomial) -> Option<Vec<Square>> {
        let roots = half_newton_polytope(target, 60)?;
        let one = Summand { multiplier: Polynomial::one(), roots, wanted: false };
        let program = Program { target: target.clone(), summands: vec![one], zeros: Vec::new() };
        let found = program.solve(&mut { usize::MAX })?;
        let parts: Vec<Polynomial> = found.squares.iter().map(|s| s.root.mul(&s.root).scale(&s.weight)).collect();
        assert_eq!(sum_of(&parts), *target);
        assert!(found.squares.iter().all(|s| s.weight > 0));
        Some(found.squares)
    }

    /// x⁴y² + x²y⁴ + z⁶ − 3x²y²z².
    fn motzkin() -> Polynomial {
        let [x, y, z] = variables().map(|v| power(&v, 2));
        sum_of(&[power(&x, 2).mul(&y), x.mul(&power(&y, 2)), power(&z, 3), times(-3, &x.mul(&y).mul(&z))])
    }

    #[test]
    fn a_form_without_zeros_is_a_sum_of_squares() {
        let [x, y] = variables();
        let p = sum_of(&[
            times(2, &power(&x, 4)),
            times(2, &power(&x, 3).mul(&y)),
            times(-1, &power(&x.mul(&y), 2)),
            times(5, &power(&y, 4)),
        ]);
        assert!(sum_of_squares(&p).is_some());
    }

    #[test]
    fn motzkins_form_is_a_sum_of_squares_only_with_a_multiplier() {
        assert!(sum_of_squares(&motzkin()).is_none());
        let squares = sum_of(&variables::<3>().map(|v| power(&v, 2)));
        assert!(sum_of_squares(&motzkin().mul(&squares)).is_some());
    }

    #[test]
    fn zeros_restrict_the_squares() {
        // Zero at (1, 1, 1) and (0, 0, 0): no Gram matrix is positive definite.
        let [x, y, z] = variables();
        let product = x.mul(&y).mul(&z);
        let p = sum_of(&[power(&x, 6), power(&y, 6), power(&z, 6), times(-3, &product.mul(&product))]);
        assert!(sum_of_squares(&p).is_some());
    }

    #[test]
    fn what_is_negative_somewhere_is_no_sum_of_squares() {
        let [x, y] = variables();
        // Negative at (1, 1) by 10⁻⁶ only.
        let least = Polynomial::constant(Rational::from_signeds(1i64, 1_000_000i64));
        let p = power(&x.sub(&y), 2).add(&power(&x.sub(&Polynomial::one()), 2)).sub(&least);
        assert!(sum_of_squares(&p).is_none());
        assert!(sum_of_squares(&motzkin().sub(&times(1, &power(&x, 6)))).is_none());
    }

    #[test]
    fn an_identity_with_a_hypothesis_and_an_equation_adds_up() {
        // 1 − x = (1 − x)² + x·(1 − x) + …; from x² = y and y >= 0.
        let [x, y] = variables();
        let zero = x.mul(&x).sub(&y);
        let target = y.add(&Polynomial::one()).sub(&times(2, &x));
        let summands = [Polynomial::one(), y.clone()].map(|multiplier| Summand {
            multiplier,
            roots: vec![Polynomial::one(), x.clone()],
            wanted: false,
        });
        let program = Program { target: target.clone(), summands: summands.to_vec(), zeros: vec![zero.clone()] };
        let found = program.solve(&mut { usize::MAX }).unwrap();
        let squares = found
            .squares
            .iter()
            .map(|s| program.summands[s.summand].multiplier.mul(&s.root).mul(&s.root).scale(&s.weight));
        let zeros = found.zeros.iter().map(|(k, w)| program.zeros[*k].scale(w));
        assert_eq!(sum_of(&squares.chain(zeros).collect::<Vec<_>>()), target);
    }

    #[test]
    fn a_rounding_that_misses_positivity_is_refused() {
        // x⁴ + x²·y² + y⁴: of its Gram matrices, that with 1000 for x²·y² has −1999 for (x·y)².
        let [x, y] = variables().map(|v| power(&v, 2));
        let target = sum_of(&[power(&x, 2), x.mul(&y), power(&y, 2)]);
        let roots = half_newton_polytope(&target, 9).unwrap();
        let one = Summand { multiplier: Polynomial::one(), roots, wanted: false };
        let program = Program { target, summands: vec![one], zeros: Vec::new() };
        let span = Span::new(&[]);
        let identity = Identity::new(&program.target, &program.blocks(), &span).unwrap();
        let mut grams: Vec<Matrix> = identity.sizes().iter().map(|n| Matrix::diagonal(*n, 1.0)).collect();
        grams.iter_mut().filter(|g| g.size() == 2).for_each(|g| g.add_at(0, 1, 1_000.0));
        let far = Suggestion { grams };
        assert!(program.exact(&identity, &far, 1_000, &span).is_none());
        assert!(program.solve(&mut { usize::MAX }).is_some());
    }
}
