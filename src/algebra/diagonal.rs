//! Homogeneous polynomials in two variables that vanish where the variables are equal.
//!
//! Contract: [`diagonal`] writes `p = (x − y)^m·q` with the largest `m ≥ 1`, exactly, and tells the common
//! sign of the coefficients of `q`. For positive `x, y` that is the sign of `q`, and an even `m` settles
//! that of `p`. A polynomial in one variable counts with `y = 1`.
//!
//! The shape is that of the differences of chain formulas (rising bounds on e, mean inequalities):
//! equality for equal masses, to even order.
//!
//! Method: with `u = x/y` the division by `u − 1` is a running sum of the coefficients, from the highest power
//! down. Once divided, the coefficients are constant between the powers that occur in `p`; twice divided, linear
//! there, so their signs are seen at these powers. Only a higher multiplicity is divided out term by term.
//! Cost: for `m ≤ 2` a few operations for each term of `p`, whatever its degree; for more `m + 1` additions for
//! each power up to the degree, which must not exceed [`MAX_DENSE_DEGREE`].

use super::{Polynomial, Var};
use malachite::Integer;
use malachite::base::num::arithmetic::traits::Lcm;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Natural, Rational};

/// `p = (x − y)^multiplicity·q`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Diagonal {
    /// The variable x.
    pub x: Var,
    /// The variable y; none stands for 1.
    pub y: Option<Var>,
    /// How often x − y divides p.
    pub multiplicity: u32,
    /// Whether the coefficients of q are all positive (or 0), rather than all negative.
    pub positive: bool,
}

/// The factor x − y of a homogeneous polynomial whose cofactor has coefficients of one sign.
#[must_use]
pub fn diagonal(p: &Polynomial) -> Option<Diagonal> {
    let (x, y) = match p.variables()[..] {
        [x] => (x, None),
        [x, y] => (x, Some(y)),
        _ => return None,
    };
    let degree = p.degree();
    if y.is_some() && p.terms().any(|(monomial, _)| monomial.degree() != degree) {
        return None;
    }
    let common = p.terms().fold(Natural::ONE, |lcm, (_, c)| lcm.lcm(c.denominator_ref().clone()));
    let common = Rational::from(common);
    // The place of a term is its distance from the highest power of x.
    let mut terms = Vec::with_capacity(p.term_count());
    for (monomial, c) in p.terms() {
        let power = monomial.powers().iter().find(|(v, _)| *v == x).map_or(0, |(_, k)| *k);
        terms.push((degree - power, Integer::try_from(c * &common).ok()?));
    }
    terms.sort_unstable_by_key(|t| t.0);
    let (multiplicity, positive) = divided(&terms)?;
    Some(Diagonal { x, y, multiplicity, positive })
}

/// The largest degree for which a factor to the third or a higher power is divided out.
pub const MAX_DENSE_DEGREE: u32 = 100_000;

/// How often `u − 1` divides, and whether what is left has no negative coefficient; `None` where it does not
/// divide, or where coefficients of both signs are left.
fn divided(terms: &[(u32, Integer)]) -> Option<(u32, bool)> {
    let mut sum = Integer::ZERO;
    // The coefficients after one division, and after two, at the ends of the gaps between places.
    let mut once = Signs::default();
    let mut twice = Signs::default();
    let (mut second, mut third) = (Integer::ZERO, Integer::ZERO);
    for (i, (place, c)) in terms.iter().enumerate() {
        sum += c;
        once.see(&sum);
        if let Some((next, _)) = terms.get(i + 1) {
            let gap = Integer::from(next - place);
            // The sum of second + k·sum for k = 1 … gap.
            third += &second * &gap + &sum * ((&gap * (&gap + Integer::ONE)) >> 1u32);
            second += &sum * gap;
            twice.see(&second);
        }
    }
    // Each last sum is the remainder of a division: the value at u = 1.
    if sum != 0 {
        return None;
    }
    if second != 0 {
        return once.common().map(|positive| (1, positive));
    }
    if third != 0 {
        return twice.common().map(|positive| (2, positive));
    }
    term_by_term(terms)
}

/// As [`divided`], for any multiplicity.
fn term_by_term(terms: &[(u32, Integer)]) -> Option<(u32, bool)> {
    let degree = terms.last()?.0;
    if degree > MAX_DENSE_DEGREE {
        return None;
    }
    let mut coefficients = vec![Integer::ZERO; degree as usize + 1];
    for (place, c) in terms {
        coefficients[*place as usize] = c.clone();
    }
    let mut multiplicity = 0;
    loop {
        let mut sum = Integer::ZERO;
        let mut quotient = Vec::with_capacity(coefficients.len());
        for c in &coefficients {
            sum += c;
            quotient.push(sum.clone());
        }
        if quotient.pop() != Some(Integer::ZERO) || quotient.is_empty() {
            break;
        }
        coefficients = quotient;
        multiplicity += 1;
    }
    let mut signs = Signs::default();
    coefficients.iter().for_each(|c| signs.see(c));
    signs.common().filter(|_| multiplicity > 0).map(|positive| (multiplicity, positive))
}

/// Which signs were seen.
#[derive(Default)]
struct Signs {
    positive: bool,
    negative: bool,
}

impl Signs {
    fn see(&mut self, x: &Integer) {
        self.positive |= *x > 0;
        self.negative |= *x < 0;
    }

    /// Whether all are positive (or 0) rather than negative (or 0).
    fn common(&self) -> Option<bool> {
        (!(self.positive && self.negative)).then_some(!self.negative)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn binomial(k: u32) -> Polynomial {
        Polynomial::variable(0).sub(&Polynomial::variable(1)).pow(k).expect("small")
    }

    proptest! {
        #[test]
        fn what_is_multiplied_by_the_factor_shows_it(
            m in 1u32..5, coefficients in prop::collection::vec(0i64..9, 1..7), negative in any::<bool>(),
        ) {
            prop_assume!(coefficients.iter().any(|c| *c != 0));
            let degree = u32::try_from(coefficients.len()).expect("short") - 1;
            let q = coefficients.iter().zip(0u32..).fold(Polynomial::zero(), |sum, (c, k)| {
                let x = Polynomial::variable(0).pow(k).expect("small");
                let y = Polynomial::variable(1).pow(degree - k).expect("small");
                sum.add(&x.mul(&y).scale(&Rational::from_signeds(if negative { -*c } else { *c }, 3)))
            });
            let p = q.mul(&binomial(m));
            prop_assert_eq!(diagonal(&p), Some(Diagonal { x: 0, y: Some(1), multiplicity: m, positive: !negative }));
            prop_assert_eq!(diagonal(&p.add(&Polynomial::variable(0).pow(m + degree).expect("small"))), None);
        }
    }

    proptest! {
        #[test]
        fn gaps_change_nothing(
            mut terms in prop::collection::vec((0u32..40, -4i64..5), 1..8), m in 0u32..3,
        ) {
            // Times (u − 1)^m, so that the factor is met often; the coefficients by place.
            let mut list = vec![0i64; 43];
            terms.iter_mut().for_each(|(place, c)| list[*place as usize] += *c);
            for _ in 0..m {
                list = (0..list.len()).map(|k| list[k] - if k > 0 { list[k - 1] } else { 0 }).collect();
            }
            let sparse: Vec<(u32, Integer)> =
                (0u32..).zip(&list).filter(|t| *t.1 != 0).map(|(k, c)| (k, Integer::from(*c))).collect();
            prop_assume!(!sparse.is_empty());
            let first = sparse[0].0;
            let shifted: Vec<(u32, Integer)> = sparse.iter().map(|(k, c)| (k - first, c.clone())).collect();
            prop_assert_eq!(divided(&shifted), term_by_term(&shifted));
            prop_assert!(m == 0 || divided(&shifted).is_none_or(|d| d.0 >= m));
        }
    }

    #[test]
    fn a_degree_in_the_millions_costs_no_memory() {
        let at = |place: u32, c: i64| (place, Integer::from(c));
        // u^(4·10^9) − 2u^(2·10^9) + 1 = (u^(2·10^9) − 1)², and the same with another middle.
        assert_eq!(divided(&[at(0, 1), at(2_000_000_000, -2), at(4_000_000_000, 1)]), Some((2, true)));
        assert_eq!(divided(&[at(0, 1), at(3_000_000_000, -2), at(4_000_000_000, 1)]), None);
        assert_eq!(divided(&[at(0, -1), at(4_000_000_000, 1)]), Some((1, false)));
    }

    #[test]
    fn mixed_signs_and_other_shapes_say_nothing() {
        let (x, y) = (Polynomial::variable(0), Polynomial::variable(1));
        // (x − y)(x − 2y) and a polynomial that is not homogeneous.
        assert_eq!(diagonal(&x.sub(&y).mul(&x.sub(&y.scale(&Rational::from(2))))), None);
        assert_eq!(diagonal(&x.mul(&x).sub(&y)), None);
        assert_eq!(diagonal(&Polynomial::zero()), None);
        let one = Polynomial::one();
        let squared = x.sub(&one).mul(&x.sub(&one));
        assert_eq!(diagonal(&squared).map(|d| (d.multiplicity, d.positive)), Some((2, true)));
    }
}
