//! The columns of a linear program: what is known, squares, and products of these.

use super::Prover;
use super::letters::whole_power;
use super::products::{Kind, Known, completed_squares, discriminant_forms, halves};
use crate::algebra::{Monomial, Polynomial};
use malachite::Rational;
use malachite::base::num::basic::traits::One;
use std::collections::BTreeSet;

/// The most columns of a linear program, by level.
const COLUMNS: [usize; 3] = [80, 300, 600];

/// Of how many letters the squares of all sums and differences are tried from the second level on.
const FEW_LETTERS: usize = 4;

impl Prover {
    /// The columns of a linear program: what is known, and products of it.
    pub(super) fn columns(&mut self, wanted: &[Polynomial], level: usize) -> Vec<Known> {
        let all = self.all_known(wanted);
        let near = letters_near(wanted, &all);
        let base: Vec<Known> = all
            .into_iter()
            .filter(|k| {
                wanted.is_empty() || k.poly.is_constant() || k.poly.variables().iter().all(|v| near.contains(v))
            })
            .take(26)
            .collect();
        let mut out = base.clone();
        out.push(Known::one());
        let degree = wanted.iter().chain(base.iter().map(|k| &k.poly)).map(Polynomial::degree).max().unwrap_or(0);
        let most = if level > 1 { 24 } else { 14 };
        let mut roots: Vec<Polynomial> = wanted.iter().flat_map(|p| halves(p, most)).collect();
        let equal = wanted.iter().filter_map(|p| made_homogeneous(p, &base));
        roots.extend(equal.flat_map(|p| halves(&p, most)).filter(|m| !roots.contains(m)).collect::<Vec<_>>());
        let squares = self.likely_squares(wanted, level, &roots, &near, &base);
        out.extend(squares.iter().map(|m| self.squared(m)));
        if level == 0 {
            return out;
        }
        let (zeros, signed): (Vec<Known>, Vec<Known>) = base.iter().cloned().partition(|k| k.kind == Kind::Zero);
        // Facts times facts.
        let mut pairs = Vec::new();
        for (i, x) in signed.iter().enumerate() {
            pairs.extend(
                signed.iter().skip(i).filter(|y| level > 1 || x.order + y.order < 3).filter_map(|y| x.times(y)),
            );
        }
        out.extend(self.multiples(&zeros, &near, level, degree.max(3) + 1));
        out.extend(pairs.iter().cloned());
        let squares = self.squares_of_two(roots, &near, level);
        out.extend(squares.iter().cloned());
        if level > 1 {
            out.extend(self.products_of_three(&signed, &pairs, &squares, &near, degree));
        }
        let mut seen = Vec::new();
        out.retain(|k| {
            let new = !seen.contains(&(k.poly.clone(), k.kind));
            if new {
                seen.push((k.poly.clone(), k.kind));
            }
            new
        });
        out.truncate(COLUMNS[level.min(2)]);
        out
    }

    /// Polynomials whose squares a proof is likely to need: completed squares, halves, letters and squares as they are written.
    fn likely_squares(
        &self,
        wanted: &[Polynomial],
        level: usize,
        roots: &[Polynomial],
        near: &BTreeSet<u32>,
        base: &[Known],
    ) -> Vec<Polynomial> {
        let mut squares: Vec<Polynomial> = wanted.iter().flat_map(completed_squares).collect();
        squares.extend(self.squares_written.iter().filter(|p| p.variables().iter().all(|v| near.contains(v))).cloned());
        squares.extend(roots.iter().filter(|m| !m.is_constant()).cloned());
        squares.extend(near.iter().map(|v| Polynomial::variable(*v)));
        if level > 0 {
            squares.extend(wanted.iter().flat_map(discriminant_forms));
            let zeros = base.iter().filter(|k| k.kind == Kind::Zero);
            squares.extend(zeros.flat_map(|k| discriminant_forms(&k.poly)).take(FEW_LETTERS));
        }
        squares
    }

    /// Equations times letters and products of two letters, up to a degree.
    fn multiples(&self, zeros: &[Known], near: &BTreeSet<u32>, level: usize, degree: u32) -> Vec<Known> {
        let mut monomials: Vec<Polynomial> = near.iter().map(|v| Polynomial::variable(*v)).collect();
        if level > 1 || zeros.len() <= 2 {
            let firsts = monomials.clone();
            for (i, x) in firsts.iter().enumerate() {
                monomials.extend(firsts.iter().skip(i).map(|y| x.mul(y)));
            }
        }
        let mut out = Vec::new();
        for z in zeros {
            for m in &monomials {
                let multiplier = self.free(m);
                if z.poly.degree() + m.degree() <= degree {
                    out.extend(z.times(&multiplier));
                }
            }
        }
        out
    }

    /// The squares of the sums and differences of two of these polynomials or letters.
    fn squares_of_two(&self, mut roots: Vec<Polynomial>, near: &BTreeSet<u32>, level: usize) -> Vec<Known> {
        if roots.is_empty() || level > 1 {
            roots.extend(near.iter().map(|v| Polynomial::variable(*v)));
            roots.push(Polynomial::one());
        }
        roots.dedup();
        if near.len() <= FEW_LETTERS {
            let letters = near.iter().map(|v| Polynomial::variable(*v));
            roots.extend(letters.filter(|x| !roots.contains(x)).collect::<Vec<_>>());
        }
        let mut squares = Vec::new();
        for (i, x) in roots.iter().enumerate() {
            for y in roots.iter().skip(i + 1) {
                squares.push(x.add(y));
                squares.push(x.sub(y));
            }
        }
        squares.iter().map(|s| self.squared(s)).collect()
    }

    /// Facts times pairs of facts, pairs times squares of differences of letters, and facts times squares, up to the degree
    /// of the goal and one more.
    fn products_of_three(
        &self,
        signed: &[Known],
        pairs: &[Known],
        squares: &[Known],
        near: &BTreeSet<u32>,
        degree: u32,
    ) -> Vec<Known> {
        let mut out = Vec::new();
        for x in signed {
            out.extend(
                pairs.iter().filter(|p| p.poly.degree() + x.poly.degree() <= degree + 1).filter_map(|p| x.times(p)),
            );
        }
        // Two letters times the square of a difference of letters, as in an energy in the frame of the masses.
        let letters: Vec<Polynomial> = near.iter().map(|v| Polynomial::variable(*v)).collect();
        let differences = letters
            .iter()
            .enumerate()
            .flat_map(|(i, x)| letters.iter().skip(i + 1).map(move |y| x.sub(y)).collect::<Vec<_>>());
        let differences: Vec<Known> = differences.map(|d| self.squared(&d)).collect();
        for pair in pairs.iter().filter(|p| p.poly.term_count() == 1 && p.poly.degree() + 2 == degree) {
            let apart = |s: &&Known| s.poly.variables().iter().all(|v| !pair.poly.contains(*v));
            out.extend(differences.iter().filter(apart).filter_map(|s| pair.times(s)));
        }
        for x in signed.iter().take(8) {
            out.extend(
                squares.iter().filter(|s| x.poly.degree() + s.poly.degree() <= degree + 1).filter_map(|s| x.times(s)),
            );
        }
        out
    }

    /// The square of a polynomial.
    fn squared(&self, p: &Polynomial) -> Known {
        let factors = vec![whole_power(self.letters.written(p), 2)];
        Known { poly: p.mul(p), kind: Kind::Weak, facts: Vec::new(), factors, order: 0 }
    }

    /// A multiplier of any sign, for equations.
    fn free(&self, p: &Polynomial) -> Known {
        Known { poly: p.clone(), kind: Kind::Zero, facts: Vec::new(), factors: vec![self.letters.written(p)], order: 0 }
    }
}

/// The letters of what is wanted, of what shares letters with it, and so on.
pub(super) fn letters_near(wanted: &[Polynomial], all: &[Known]) -> BTreeSet<u32> {
    let mut near: BTreeSet<u32> = wanted.iter().flat_map(Polynomial::variables).collect();
    for _ in 0..3 {
        for k in all {
            let letters = k.poly.variables();
            if letters.iter().any(|v| near.contains(v)) && near.len() + letters.len() < 14 {
                near.extend(letters);
            }
        }
    }
    near
}

/// A polynomial in which every term has the same degree in the letters of a form h, where an equation among the facts says
/// that h is a number other than 0: terms of a lower degree are multiplied by h over that number. From c² + s² = 1 one has
/// A² + B² − (A·c + B·s)² = (A·s − B·c)². `None` where nothing changes.
pub(super) fn made_homogeneous(p: &Polynomial, facts: &[Known]) -> Option<Polynomial> {
    let mut out = p.clone();
    for fact in facts.iter().filter(|k| k.kind == Kind::Zero) {
        let c = -fact.poly.constant_term();
        let form = fact.poly.add(&Polynomial::constant(c.clone()));
        let letters = form.variables();
        let degree_of = |m: &Monomial| m.powers().iter().filter(|p| letters.contains(&p.0)).map(|p| p.1).sum::<u32>();
        let (degree, most) = (form.degree(), out.terms().map(|(m, _)| degree_of(m)).max()?);
        if c == 0 || degree == 0 || most > 8 || form.terms().any(|(m, _)| degree_of(m) != degree) {
            continue;
        }
        let unit = form.scale(&(Rational::ONE / c));
        let mut sum = Polynomial::zero();
        for (m, coefficient) in out.terms() {
            let missing = most - degree_of(m);
            let term = Polynomial::term(m.clone(), coefficient.clone());
            let factor = if missing % degree == 0 { unit.pow(missing / degree).ok()? } else { Polynomial::one() };
            sum = sum.add(&term.try_mul(&factor).ok()?);
        }
        out = sum;
    }
    (out != *p && out.term_count() <= 120).then_some(out)
}
