//! Sums of hypergeometric terms: closed forms by Gosper's algorithm, recurrences by Zeilberger's.
//!
//! Contract: for the ratio t(i + 1)/t(i) of a term as a quotient of polynomials, [`antidifference`] finds a quotient R of
//! polynomials with T(i + 1) − T(i) = t(i) for T = R·t, if it comes to one. Other variables are parameters. [`recurrence`] does so
//! for a combination of F(n, i) and F(n + 1, i) whose weights are free of i.
//!
//! Method (R. W. Gosper, 1978; Petkovšek, Wilf, Zeilberger, "A = B", chapter 5): t(i + 1)/t(i) = a(i)/b(i)·c(i + 1)/c(i), where a(i)
//! and b(i + h) have no factor in common for h = 0, 1, 2, …; then T = b(i − 1)·x(i)/c(i)·t for a polynomial x with
//! a(i)·x(i + 1) − b(i − 1)·x(i) = c(i), whose degree is bounded. What is not found proves nothing: factors may be reducible.
//! D. Zeilberger, 1991 (chapter 6): with F(n + 1, i)/F(n, i) = u/v, the term w·F(n, i) + F(n + 1, i) is (w·v + u)·F/v, and w is one more
//! unknown of the same linear equations, c·(w·v + u) standing for c.
//!
//! Limits: `SHIFT`, `DEGREE`.

use super::factor::factor;
use super::gcd::gcd;
use super::{Polynomial, Var};
use malachite::Rational;

/// The largest distance between two factors that is looked for.
const SHIFT: u32 = 24;

/// The highest degree of x.
const DEGREE: u32 = 12;

/// A quotient R of polynomials, as numerator and denominator, with T(i + 1) − T(i) = t(i) for T = R·t, where
/// t(i + 1)/t(i) = `above`/`below`.
#[must_use]
pub fn antidifference(above: &Polynomial, below: &Polynomial, i: Var) -> Option<(Polynomial, Polynomial)> {
    let (a, before, c) = normal_form(above, below, i)?;
    let (x, _, under) = solution(&a, &before, &[], &c, i)?;
    Some((before.try_mul(&x).ok()?, c.try_mul(&under).ok()?))
}

/// Weights w and w′ free of i, and a quotient R of polynomials, with G(i + 1) − G(i) = w·F(n, i) + w′·F(n + 1, i) for G = R·F(n, i).
#[derive(Debug)]
pub struct Recurrence {
    /// w
    pub own: Polynomial,
    /// w′
    pub next: Polynomial,
    /// The numerator and the denominator of R.
    pub certificate: (Polynomial, Polynomial),
}

/// A recurrence in n for the sum over i of a term F(n, i), where F(n, i + 1)/F(n, i) = `step` and F(n + 1, i)/F(n, i) = `next`.
#[must_use]
pub fn recurrence(step: &(Polynomial, Polynomial), next: &(Polynomial, Polynomial), i: Var) -> Option<Recurrence> {
    let (u, v) = next;
    let (above, below) = (v.try_mul(&step.0).ok()?, shifted(v, i, 1)?.try_mul(&step.1).ok()?);
    let (a, before, c) = normal_form(&above, &below, i)?;
    let (x, weights, under) = solution(&a, &before, &[c.try_mul(v).ok()?], &c.try_mul(u).ok()?, i)?;
    let own = weights.into_iter().next()?;
    // What both weights have in common goes to the certificate.
    let polynomial = gcd(&own, &under).ok()?;
    let (own, next) = (own.exact_divide(&polynomial)?, under.exact_divide(&polynomial)?);
    let number = next.content();
    let scaled = |p: &Polynomial| p.scale(&(Rational::from(1) / &number));
    let certificate = (scaled(&before.try_mul(&x).ok()?), c.try_mul(v).ok()?.try_mul(&polynomial).ok()?);
    Some(Recurrence { own: scaled(&own), next: scaled(&next), certificate })
}

/// a(i), b(i − 1) and c(i) with `above`/`below` = a(i)/b(i)·c(i + 1)/c(i), and no factor of a in b moved on.
fn normal_form(above: &Polynomial, below: &Polynomial, i: Var) -> Option<(Polynomial, Polynomial, Polynomial)> {
    let common = gcd(above, below).ok()?;
    let (mut a, mut b) = (above.exact_divide(&common)?, below.exact_divide(&common)?);
    let mut c = Polynomial::one();
    for (f, _) in factor(&a).ok()?.factors {
        for (g, _) in factor(&b).ok()?.factors {
            let Some(h) = distance(&f, &g, i) else { continue };
            while let (Some(less_a), Some(less_b)) =
                (a.exact_divide(&f), b.exact_divide(&shifted(&f, i, -i64::from(h))?))
            {
                (a, b) = (less_a, less_b);
                for k in 1..=h {
                    c = c.try_mul(&shifted(&f, i, -i64::from(k))?).ok()?;
                }
            }
        }
    }
    Some((a, shifted(&b, i, -1)?, c))
}

/// p(i + k).
fn shifted(p: &Polynomial, i: Var, k: i64) -> Option<Polynomial> {
    p.substitute(i, &Polynomial::variable(i).add(&Polynomial::integer(k))).ok()
}

/// The h from 1 on with f(i − h) a multiple of g(i).
fn distance(f: &Polynomial, g: &Polynomial, i: Var) -> Option<u32> {
    let degree = f.degree_in(i);
    if degree == 0 || degree != g.degree_in(i) {
        return None;
    }
    // f = f1·i^d + f0·i^(d−1) + …, so that f(i − h) begins f1·i^d + (f0 − d·h·f1)·i^(d−1), in the ratio of g1 to g0.
    let top = |p: &Polynomial, k: u32| p.coefficients_in(i).get(k as usize).cloned().unwrap_or_else(Polynomial::zero);
    let (f1, f0, g1, g0) = (top(f, degree), top(f, degree - 1), top(g, degree), top(g, degree - 1));
    let gap = f0.try_mul(&g1).ok()?.sub(&g0.try_mul(&f1).ok()?);
    let unit = f1.try_mul(&g1).ok()?.scale(&Rational::from(degree));
    let h = gap.exact_divide(&unit)?.as_constant()?;
    let h = u32::try_from(&h).ok().filter(|h| (1..=SHIFT).contains(h))?;
    // Multiples of one another: g1·f(i − h) = f1·g(i).
    let moved = shifted(f, i, -i64::from(h))?;
    (moved.try_mul(&g1).ok()? == g.try_mul(&f1).ok()?).then_some(h)
}

/// A polynomial x and weights w, over one denominator without i, with a(i)·x(i + 1) − b(i)·x(i) − Σ w·others(i) = c(i).
fn solution(
    a: &Polynomial,
    b: &Polynomial,
    others: &[Polynomial],
    c: &Polynomial,
    i: Var,
) -> Option<(Polynomial, Vec<Polynomial>, Polynomial)> {
    let (la, lb) = (a.degree_in(i), b.degree_in(i));
    let lc = others.iter().chain([c]).map(|p| p.degree_in(i)).max()?;
    let top = |p: &Polynomial, k: u32| p.coefficients_in(i).get(k as usize).cloned().unwrap_or_else(Polynomial::zero);
    let degree = if la != lb || top(a, la) != top(b, lb) {
        lc.checked_sub(la.max(lb))?
    } else {
        // The terms of degree la + d cancel, and those below where d is this number.
        let gap = if la == 0 { Polynomial::zero() } else { top(b, la - 1).sub(&top(a, la - 1)) };
        let other = gap.exact_divide(&top(a, la)).and_then(|q| u32::try_from(&q.as_constant()?).ok());
        (lc + 1).checked_sub(la).into_iter().chain(other).max()?
    };
    if degree > DEGREE {
        return None;
    }
    // One column for each coefficient of x, one for each weight, and c as the last.
    let rows = (la.max(lb) + degree).max(lc) as usize + 1;
    let own = degree as usize + 1;
    let mut matrix = vec![vec![Polynomial::zero(); own + others.len() + 1]; rows];
    let mut fill = |column: usize, p: &Polynomial| {
        p.coefficients_in(i).into_iter().enumerate().for_each(|(row, value)| matrix[row][column] = value);
    };
    for k in 0..=degree {
        let power = Polynomial::variable(i).pow(k).ok()?;
        let next = shifted(&power, i, 1)?;
        fill(k as usize, &a.try_mul(&next).ok()?.sub(&b.try_mul(&power).ok()?));
    }
    others.iter().enumerate().for_each(|(k, other)| fill(own + k, &other.neg()));
    fill(own + others.len(), c);
    let (mut values, below) = solved(matrix)?;
    let weights = values.split_off(own);
    Some((Polynomial::from_coefficients_in(i, &values), weights, below))
}

/// A solution of linear equations, the last column on the right: numerators over one denominator. What stays free is 0.
fn solved(mut matrix: Vec<Vec<Polynomial>>) -> Option<(Vec<Polynomial>, Polynomial)> {
    let unknowns = matrix.first()?.len() - 1;
    let mut pivots: Vec<(usize, usize)> = Vec::new();
    for column in 0..unknowns {
        let free = |row: &usize| pivots.iter().all(|p| p.0 != *row);
        let candidates = (0..matrix.len()).filter(free).filter(|row| !matrix[*row][column].is_zero());
        let Some(pivot) = candidates.min_by_key(|row| matrix[*row][column].term_count()) else { continue };
        let by = matrix[pivot].clone();
        for (place, row) in matrix.iter_mut().enumerate().filter(|(place, _)| *place != pivot) {
            if row[column].is_zero() {
                continue;
            }
            let times = row[column].clone();
            for (entry, of_pivot) in row.iter_mut().zip(&by) {
                *entry = entry.try_mul(&by[column]).ok()?.sub(&of_pivot.try_mul(&times).ok()?);
            }
            // What a row has in common goes out, so that it stays small.
            let mut common = Polynomial::zero();
            for entry in row.iter() {
                common = gcd(&common, entry).ok()?;
            }
            if !common.is_zero() && !common.is_constant() {
                for entry in row.iter_mut() {
                    *entry = entry.exact_divide(&common)?;
                }
            }
            debug_assert!(place != pivot);
        }
        pivots.push((pivot, column));
    }
    let is_pivot = |row: usize| pivots.iter().any(|p| p.0 == row);
    if (0..matrix.len()).any(|row| !is_pivot(row) && !matrix[row][unknowns].is_zero()) {
        return None;
    }
    let mut below = Polynomial::one();
    for (row, column) in &pivots {
        let own = &matrix[*row][*column];
        below = below.try_mul(&own.exact_divide(&gcd(&below, own).ok()?)?).ok()?;
    }
    let mut values = vec![Polynomial::zero(); unknowns];
    for (row, column) in &pivots {
        let factor = below.exact_divide(&matrix[*row][*column])?;
        values[*column] = matrix[*row][unknowns].try_mul(&factor).ok()?;
    }
    Some((values, below))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    const I: Var = 0;
    const R: Var = 1;

    fn i(k: i64) -> Polynomial {
        Polynomial::variable(I).add(&Polynomial::integer(k))
    }

    /// R(i + 1)·above/below − R(i) = 1 says that T(i + 1) − T(i) = t(i).
    fn is_antidifference(above: &Polynomial, below: &Polynomial) -> bool {
        let Some((top, bottom)) = antidifference(above, below, I) else { return false };
        let (next_top, next_bottom) = (shifted(&top, I, 1).unwrap(), shifted(&bottom, I, 1).unwrap());
        let left = next_top.mul(above).mul(&bottom).sub(&top.mul(below).mul(&next_bottom));
        left == below.mul(&next_bottom).mul(&bottom)
    }

    #[test]
    fn terms_with_a_closed_form_have_an_antidifference() {
        let r = Polynomial::variable(R);
        let cases = [
            ("i^3", i(1).pow(3).unwrap(), i(0).pow(3).unwrap()),
            ("1/(i*(i + 1))", i(0), i(2)),
            ("1/(i*(i + 2))", i(0).mul(&i(2)), i(1).mul(&i(3))),
            ("1/(i*(i + 1)*(i + 2))", i(0), i(3)),
            ("i*r^i", i(1).mul(&r), i(0)),
            ("i^2/2^i", i(1).pow(2).unwrap(), i(0).pow(2).unwrap().scale(&Rational::from(2))),
            ("i*i!", i(1).pow(2).unwrap(), i(0)),
            ("i/(i + 1)!", i(1), i(0).mul(&i(2))),
            ("r^i", r.clone(), Polynomial::one()),
        ];
        for (name, above, below) in cases {
            assert!(is_antidifference(&above, &below), "{name}");
        }
    }

    #[test]
    fn sums_of_binomial_coefficients_have_a_recurrence() {
        const N: Var = 2;
        let n = |k: i64| Polynomial::variable(N).add(&Polynomial::integer(k));
        let square = |p: &Polynomial| p.pow(2).unwrap();
        // binomial(n, i + 1)/binomial(n, i), and binomial(n + 1, i)/binomial(n, i).
        let (step, next) = ((n(0).sub(&i(0)), i(1)), (n(1), n(1).sub(&i(0))));
        let own = recurrence(&step, &next, I).unwrap();
        // w·2^n + w′·2^(n + 1) = 0.
        assert_eq!(own.own, own.next.scale(&Rational::from(-2)));
        let squares = recurrence(&(square(&step.0), square(&step.1)), &(square(&next.0), square(&next.1)), I).unwrap();
        // (n + 1)·binomial(2·n + 2, n + 1) = 2·(2·n + 1)·binomial(2·n, n).
        let double = n(0).scale(&Rational::from(2)).add(&Polynomial::one()).scale(&Rational::from(-2));
        assert_eq!(squares.own.mul(&n(1)), squares.next.mul(&double));
    }

    #[test]
    fn terms_without_one_have_none() {
        // 1/i, 1/i^2, i!, 2^i/i
        let two = Rational::from(2);
        for (above, below) in [
            (i(0), i(1)),
            (i(0).pow(2).unwrap(), i(1).pow(2).unwrap()),
            (i(1), Polynomial::one()),
            (i(0).scale(&two), i(1)),
        ] {
            assert!(antidifference(&above, &below, I).is_none());
        }
    }
}
