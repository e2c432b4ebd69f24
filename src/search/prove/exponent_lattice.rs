//! Exponents of powers of one base, and the lattice over the whole numbers that they span.

use super::lattice::{chosen, reduced};
use crate::algebra::Polynomial;
use crate::algebra::gcd::gcd;
use malachite::base::num::arithmetic::traits::{Abs, Gcd, Lcm};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Natural, Rational};

/// The most choices of exponents that are tried as a basis.
const CHOICES: usize = 500;

/// An exponent: a quotient of polynomials without a common factor.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Exponent {
    /// The dividend.
    pub(super) top: Polynomial,
    /// The divisor; its leading coefficient is 1.
    pub(super) bottom: Polynomial,
}

impl Exponent {
    pub(super) fn new(top: Polynomial, bottom: Polynomial) -> Option<Exponent> {
        if bottom.is_zero() {
            return None;
        }
        let common = gcd(&top, &bottom).ok().filter(|g| !g.is_zero())?;
        let (top, bottom) = (top.exact_divide(&common)?, bottom.exact_divide(&common)?);
        let lead = Rational::ONE / bottom.leading_coefficient();
        Some(Exponent { top: top.scale(&lead), bottom: bottom.scale(&lead) })
    }

    pub(super) fn is_number(&self) -> bool {
        self.top.is_constant() && self.bottom.is_constant()
    }

    /// Its opposite where it begins with a minus sign.
    pub(super) fn upright(self) -> Exponent {
        if self.top.leading_coefficient() < 0 { Exponent { top: self.top.neg(), ..self } } else { self }
    }

    pub(super) fn number(k: Rational) -> Exponent {
        Exponent { top: Polynomial::constant(k), bottom: Polynomial::one() }
    }

    pub(super) fn one() -> Exponent {
        Exponent::number(Rational::ONE)
    }

    pub(super) fn times(&self, other: &Exponent) -> Option<Exponent> {
        Exponent::new(self.top.try_mul(&other.top).ok()?, self.bottom.try_mul(&other.bottom).ok()?)
    }

    pub(super) fn plus(&self, other: &Exponent) -> Option<Exponent> {
        let (a, b) = (self.top.try_mul(&other.bottom).ok()?, other.top.try_mul(&self.bottom).ok()?);
        Exponent::new(a.add(&b), self.bottom.try_mul(&other.bottom).ok()?)
    }
}

/// The largest number of which both are multiples; positive unless both are 0.
pub(super) fn common_step(a: &Rational, b: &Rational) -> Rational {
    let scale = Rational::from(a.denominator_ref().lcm(b.denominator_ref()));
    let whole = |q: &Rational| Natural::try_from((q * &scale).abs()).unwrap_or(Natural::ZERO);
    Rational::from(whole(a).gcd(whole(b))) / scale
}

/// The product of all divisors of exponents, each as often as one of them needs it.
fn common_denominator(list: &[Exponent]) -> Option<Polynomial> {
    list.iter().try_fold(Polynomial::one(), |common, q| {
        let shared = gcd(&common, &q.bottom).ok()?;
        common.try_mul(&q.bottom.exact_divide(&shared)?).ok()
    })
}

/// Exponents over a common denominator.
pub(super) fn vectors(list: &[Exponent]) -> Option<Vec<Polynomial>> {
    let common = common_denominator(list)?;
    list.iter().map(|q| q.top.try_mul(&common.exact_divide(&q.bottom)?).ok()).collect()
}

/// Exponents that give all of these with whole coordinates: some of them if possible. With `free` the first may be left out, and
/// where none suffice a basis of the lattice that they span is taken.
pub(super) fn basis_of(all: &[Exponent], free: bool) -> Option<Vec<Exponent>> {
    let list = vectors(all)?;
    if let Some(places) = chosen(&list, CHOICES, &|places| free || places.contains(&0)) {
        return Some(places.iter().map(|p| all[*p].clone()).collect());
    }
    if !free {
        return basis_of(all.get(1..).filter(|rest| !rest.is_empty())?, true);
    }
    let common = common_denominator(all)?;
    reduced(&list).into_iter().map(|top| Exponent::new(top, common.clone())).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    fn number(n: i64, d: i64) -> Exponent {
        Exponent::number(Rational::from_signeds(n, d))
    }

    #[test]
    fn a_square_root_and_a_cube_root_are_powers_of_a_sixth_root() {
        let all = [Exponent::one(), number(1, 2), number(1, 3)];
        assert_eq!(basis_of(&all, true), Some(vec![number(1, 6)]));
    }

    #[test]
    fn a_base_that_stays_is_in_its_basis_where_it_can_be() {
        let n = Polynomial::variable(0);
        let share = Exponent::new(n.clone(), n.add(&Polynomial::one())).unwrap();
        let rest = Exponent::new(Polynomial::one(), n.add(&Polynomial::one())).unwrap();
        // 1 = n/(n + 1) + 1/(n + 1): two of the three give the third.
        assert_eq!(basis_of(&[Exponent::one(), share.clone(), rest], false), Some(vec![Exponent::one(), share]));
    }

    #[test]
    fn both_numbers_are_whole_multiples_of_their_common_step() {
        let q = |n: i64, d: i64| Rational::from_signeds(n, d);
        assert_eq!(common_step(&q(1, 2), &q(-3, 4)), q(1, 4));
        assert_eq!(common_step(&q(0, 1), &q(-3, 4)), q(3, 4));
    }
}
