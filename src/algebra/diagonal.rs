//! Homogeneous polynomials in two variables that vanish where the variables are equal.
//!
//! Contract: [`diagonal`] writes `p = (x − y)^m·q` with the largest `m ≥ 1`, exactly, and tells the common
//! sign of the coefficients of `q`. For positive `x, y` that is the sign of `q`, and an even `m` settles
//! that of `p`. A polynomial in one variable counts with `y = 1`.
//!
//! The shape is that of the differences of chain formulas (rising bounds on e, mean inequalities):
//! equality for equal masses, to even order.
//!
//! Method: with `u = x/y` the division by `u − 1` is a running sum of the coefficients.
//! Cost: `m + 1` additions for each power up to the degree; memory for as many integers.

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
    // Coefficients from the highest power of x down.
    let mut coefficients = vec![Integer::ZERO; degree as usize + 1];
    for (monomial, c) in p.terms() {
        let power = monomial.powers().iter().find(|(v, _)| *v == x).map_or(0, |(_, k)| *k);
        let scaled = Integer::try_from(c * &common).ok()?;
        coefficients[(degree - power) as usize] = scaled;
    }
    let mut multiplicity = 0;
    loop {
        let mut sum = Integer::ZERO;
        let mut quotient = Vec::with_capacity(coefficients.len());
        for c in &coefficients {
            sum += c;
            quotient.push(sum.clone());
        }
        // The last sum is the remainder: the value at u = 1.
        if quotient.pop() != Some(Integer::ZERO) || quotient.is_empty() {
            break;
        }
        coefficients = quotient;
        multiplicity += 1;
    }
    let positive = coefficients.iter().all(|c| *c >= 0);
    let one_sign = positive || coefficients.iter().all(|c| *c <= 0);
    (multiplicity > 0 && one_sign).then_some(Diagonal { x, y, multiplicity, positive })
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
