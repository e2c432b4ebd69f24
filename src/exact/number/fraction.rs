//! Long fractions in lowest terms.
//!
//! malachite's rational takes a greatest common divisor whenever it is made from two naturals, even where they are known
//! to have none. For the velocities in a long chain that divisor is most of the work, and `super::product` finds it
//! in a quicker way: what it finds is kept here.

use super::parallel::{MIN_BITS, both};
use malachite::base::num::arithmetic::traits::{DivExact, DivMod, Gcd, Square};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Natural, Rational};

/// A fraction in lowest terms; its denominator is not zero, and zero is not negative.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fraction {
    negative: bool,
    numerator: Natural,
    denominator: Natural,
}

impl Fraction {
    /// `numerator/denominator`, which have no common divisor.
    pub(super) fn of_coprime(numerator: Natural, denominator: Natural) -> Fraction {
        Fraction { negative: false, numerator, denominator }
    }

    /// `numerator/denominator`, where `common` is their greatest common divisor.
    pub(super) fn reduced(numerator: Natural, denominator: Natural, common: &Natural) -> Fraction {
        if *common == Natural::ONE {
            return Fraction::of_coprime(numerator, denominator);
        }
        let worth = numerator.significant_bits() >= MIN_BITS;
        let (numerator, denominator) = both(worth, || (&numerator).div_exact(common), || denominator.div_exact(common));
        Fraction::of_coprime(numerator, denominator)
    }

    /// The same with the sign of a number that is negative, or not.
    #[must_use]
    pub fn signed(self, negative: bool) -> Fraction {
        Fraction { negative: negative && self.numerator != Natural::ZERO, ..self }
    }

    /// Whether it is below zero.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        self.negative
    }

    /// The absolute value of the numerator.
    #[must_use]
    pub fn numerator(&self) -> &Natural {
        &self.numerator
    }

    /// The denominator, not zero.
    #[must_use]
    pub fn denominator(&self) -> &Natural {
        &self.denominator
    }

    /// The numerator and the denominator.
    #[must_use]
    pub(crate) fn into_parts(self) -> (Integer, Natural) {
        (Integer::from_sign_and_abs(!self.negative, self.numerator), self.denominator)
    }

    /// Its square: parts without a common divisor have none when squared.
    #[must_use]
    pub fn square(self) -> Fraction {
        Fraction::of_coprime(self.numerator.square(), self.denominator.square())
    }

    /// The product with `x`: two common divisors of a long number with a short one, where `x` is short.
    #[must_use]
    pub fn times(self, x: &Rational) -> Fraction {
        let (above, below) = (x.numerator_ref(), x.denominator_ref());
        let (left, right) = ((&self.numerator).gcd(below), (&self.denominator).gcd(above));
        let (numerator, denominator) = (self.numerator.div_exact(&left), self.denominator.div_exact(&right));
        Fraction::of_coprime(numerator * above.div_exact(right), denominator * below.div_exact(left))
            .signed(self.negative != (*x < Rational::ZERO))
    }

    /// The bits of both parts.
    #[must_use]
    pub fn bits(&self) -> u64 {
        self.numerator.significant_bits() + self.denominator.significant_bits()
    }

    /// Whether finitely many decimals write it: whether its denominator has no prime factor but 2 and 5.
    #[must_use]
    pub(crate) fn is_decimal(&self) -> bool {
        let odd = match self.denominator.trailing_zeros() {
            Some(twos) => &self.denominator >> twos,
            None => Natural::ONE,
        };
        without(odd, Natural::from(5u32)) == Natural::ONE
    }
}

/// `x` without its factors `p`.
///
/// On the way up `p`, `p²`, `p⁴`, … are divided out until one does not go in: less than `p^(2^k)` is left, if that was the
/// one, and on the way down each power goes in at most once.
fn without(mut x: Natural, p: Natural) -> Natural {
    let (mut powers, mut power) = (Vec::new(), p);
    loop {
        let (quotient, rest) = (&x).div_mod(&power);
        if rest != Natural::ZERO || x == Natural::ZERO {
            break;
        }
        x = quotient;
        let next = (&power).square();
        powers.push(std::mem::replace(&mut power, next));
    }
    while let Some(power) = powers.pop() {
        let (quotient, rest) = (&x).div_mod(&power);
        if rest == Natural::ZERO {
            x = quotient;
        }
    }
    x
}

impl From<Fraction> for Rational {
    /// Takes the greatest common divisor once more, as malachite does.
    fn from(x: Fraction) -> Rational {
        Rational::from_sign_and_naturals(!x.negative, x.numerator, x.denominator)
    }
}

impl From<Rational> for Fraction {
    fn from(x: Rational) -> Fraction {
        let negative = x < Rational::ZERO;
        let (numerator, denominator) = x.into_numerator_and_denominator();
        Fraction { negative, numerator, denominator }
    }
}

impl PartialEq<Rational> for Fraction {
    fn eq(&self, x: &Rational) -> bool {
        self.negative == (*x < Rational::ZERO)
            && self.numerator == *x.numerator_ref()
            && self.denominator == *x.denominator_ref()
    }
}

#[cfg(test)]
mod tests {
    use super::Fraction;
    use malachite::base::num::arithmetic::traits::{Gcd, Pow, Square};
    use malachite::base::num::basic::traits::One;
    use malachite::{Natural, Rational};
    use proptest::prelude::*;

    fn fraction(x: &Rational) -> Fraction {
        Fraction::reduced(x.numerator_ref().clone(), x.denominator_ref().clone(), &Natural::ONE)
    }

    proptest! {
        #[test]
        fn it_computes_as_rationals_do(a in any::<u64>(), b in 1..=u64::MAX, c in any::<u64>(), d in 1..=u64::MAX) {
            let (x, y) = (Rational::from_unsigneds(a, b), Rational::from_unsigneds(c, d));
            prop_assert_eq!(fraction(&x).square(), (&x).square());
            prop_assert_eq!(fraction(&x).times(&y), &x * &y);
            prop_assert_eq!(fraction(&x).signed(true).times(&y), -(&x * &y));
            prop_assert_eq!(Fraction::from(-(&x * &y)), fraction(&x).times(&-&y));
            prop_assert_eq!(Rational::from(fraction(&x).signed(true)), -x.clone());
            prop_assert_eq!(Rational::from(fraction(&x)), x.clone());
            let common = Natural::from(a).gcd(Natural::from(b));
            prop_assert_eq!(Fraction::reduced(Natural::from(a), Natural::from(b), &common), x);
        }

        #[test]
        fn decimals_are_told_from_others(twos in 0..200_u64, fives in 0..200_u64, other in 1..50_u32) {
            let denominator = Natural::from(2u32).pow(twos) * Natural::from(5u32).pow(fives);
            let x = Rational::from_naturals(Natural::ONE, &denominator * Natural::from(other));
            let mut rest = other;
            for p in [2, 5] {
                while rest % p == 0 {
                    rest /= p;
                }
            }
            prop_assert_eq!(fraction(&x).is_decimal(), rest == 1);
        }
    }
}
