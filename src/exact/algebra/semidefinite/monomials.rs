//! Which monomials may occur in the squares of a sum.

use super::super::{Monomial, Polynomial, Var};
use std::collections::BTreeSet;

/// The most monomials that are looked at.
const CANDIDATES: usize = 1_000;

/// The monomials in these variables of at most this degree that no monomial of `without` divides; `None` where there are too many.
#[must_use]
pub fn monomials(variables: &[Var], degree: u32, without: &[Monomial]) -> Option<Vec<Polynomial>> {
    let found = within(variables, degree, &|_| true)?.into_iter();
    let kept = found.filter(|m| without.iter().all(|w| m.checked_div(w).is_none()));
    Some(kept.map(Polynomial::monomial).collect())
}

/// The monomials whose squares may occur in a sum of squares that is this polynomial; `None` where there are too many.
///
/// Why it is right: a monomial whose square is no term of p, and no product of two others, cannot occur. What is left has its
/// corners in the half Newton polytope.
#[must_use]
pub fn half_newton_polytope(p: &Polynomial, most: usize) -> Option<Vec<Polynomial>> {
    let variables = p.variables();
    let range = |of: &dyn Fn(&Monomial) -> i64| {
        let values: Vec<i64> = p.terms().map(|(m, _)| of(m)).collect();
        (values.iter().min().copied().unwrap_or(0), values.iter().max().copied().unwrap_or(0))
    };
    // Exponents, their sums and differences lie in the halves of their ranges.
    let mut directions: Vec<Vec<(Var, i64)>> = vec![variables.iter().map(|v| (*v, 1)).collect()];
    for (i, v) in variables.iter().enumerate() {
        directions.push(vec![(*v, 1)]);
        for w in &variables[i + 1..] {
            directions.extend([vec![(*v, 1), (*w, 1)], vec![(*v, 1), (*w, -1)], vec![(*v, 1), (*w, 2)]]);
            directions.push(vec![(*v, 2), (*w, 1)]);
        }
    }
    let along = |d: &[(Var, i64)], m: &Monomial| d.iter().map(|(v, k)| k * i64::from(m.exponent(*v))).sum::<i64>();
    let ranges: Vec<(i64, i64)> = directions.iter().map(|d| range(&|m| along(d, m))).collect();
    let inside = |m: &Monomial| {
        directions.iter().zip(&ranges).all(|(d, (low, high))| (*low..=*high).contains(&(2 * along(d, m))))
    };
    let most_of: Vec<(Var, u32)> = variables.iter().map(|v| (*v, p.degree_in(*v) / 2)).collect();
    let within_box = |m: &Monomial| most_of.iter().all(|(v, k)| m.exponent(*v) <= *k);
    let mut kept: Vec<Monomial> = within(&variables, p.degree() / 2, &within_box)?.into_iter().filter(inside).collect();
    loop {
        let mut products = BTreeSet::new();
        for (i, a) in kept.iter().enumerate() {
            products.extend(kept[i + 1..].iter().map(|b| a.mul(b)));
        }
        let before = kept.len();
        kept.retain(|m| {
            let square = m.mul(m);
            products.contains(&square) || p.coefficient(&square) != 0
        });
        if kept.len() == before {
            break;
        }
    }
    (kept.len() <= most).then(|| kept.into_iter().map(Polynomial::monomial).collect())
}

/// All monomials up to a degree, as far as their divisors are allowed.
fn within(variables: &[Var], degree: u32, allowed: &dyn Fn(&Monomial) -> bool) -> Option<Vec<Monomial>> {
    let mut out = vec![Monomial::one()];
    for v in variables {
        let mut next = Vec::new();
        for m in &out {
            for k in 0..=degree.saturating_sub(m.degree()) {
                let longer = m.mul(&Monomial::small_power(*v, k));
                if !allowed(&longer) {
                    break;
                }
                next.push(longer);
            }
            if next.len() > CANDIDATES {
                return None;
            }
        }
        out = next;
    }
    out.sort_by(|a, b| b.cmp(a));
    Some(out)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    #[test]
    fn a_monomial_outside_the_newton_polytope_is_no_candidate() {
        // Motzkin's: x⁴y² + x²y⁴ + 1 − 3x²y².
        let [x, y] = [0, 1].map(Polynomial::variable);
        let (xx, yy) = (x.mul(&x), y.mul(&y));
        let three = Polynomial::integer(3);
        let p = xx.mul(&xx).mul(&yy).add(&xx.mul(&yy).mul(&yy)).add(&Polynomial::one()).sub(&xx.mul(&yy).mul(&three));
        let found = half_newton_polytope(&p, 50).unwrap();
        assert_eq!(found, [xx.mul(&y), x.mul(&yy), x.mul(&y), Polynomial::one()]);
    }

    #[test]
    fn too_many_monomials_are_none() {
        assert!(monomials(&[0, 1, 2, 3, 4, 5, 6, 7], 9, &[]).is_none());
        assert_eq!(monomials(&[0, 1], 2, &[Monomial::variable(1)]).unwrap().len(), 3);
    }
}
