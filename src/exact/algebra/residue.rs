//! Residues modulo the Mersenne prime 2⁶¹ − 1.

use malachite::base::num::basic::traits::Zero;
use malachite::{Natural, Rational};

/// The prime.
pub(crate) const PRIME: u64 = (1 << 61) - 1;

/// The residue of a number; nothing where the prime divides its denominator.
pub(crate) fn residue(c: &Rational) -> Option<u64> {
    let rest = |n: &Natural| u64::try_from(&(n % Natural::from(PRIME))).unwrap_or(0);
    let (top, bottom) = (rest(c.numerator_ref()), rest(c.denominator_ref()));
    let size = match bottom {
        0 => return None,
        1 => top,
        _ => multiply(top, inverse(bottom)),
    };
    Some(if *c < Rational::ZERO { negate(size) } else { size })
}

/// a + b.
pub(crate) fn add(a: u64, b: u64) -> u64 {
    (a + b) % PRIME
}

/// −a.
pub(crate) fn negate(a: u64) -> u64 {
    if a == 0 { 0 } else { PRIME - a }
}

/// a·b: 2⁶¹ leaves 1, so the digits to the base 2⁶¹ are added.
pub(crate) fn multiply(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    let low = u64::try_from(product & u128::from(PRIME)).unwrap_or(0);
    add(low, u64::try_from(product >> 61).unwrap_or(0))
}

/// A power.
pub(crate) fn power(mut base: u64, mut exponent: u64) -> u64 {
    let mut result = 1;
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = multiply(result, base);
        }
        base = multiply(base, base);
        exponent >>= 1;
    }
    result
}

/// 1/a, by Fermat; 0 of 0.
pub(crate) fn inverse(a: u64) -> u64 {
    power(a, PRIME - 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quotient_times_its_divisor_is_the_number() {
        for (top, bottom) in [(1, 3), (-7, 1 << 40), (5, -11), (0, 9)] {
            let quotient = residue(&Rational::from_signeds(top, bottom)).unwrap_or(PRIME);
            let whole = |k: i64| residue(&Rational::from(k)).unwrap_or(PRIME);
            assert_eq!(multiply(quotient, whole(bottom)), whole(top));
        }
        assert_eq!(multiply(PRIME - 1, PRIME - 1), 1);
    }

    #[test]
    fn a_denominator_that_the_prime_divides_has_no_residue() {
        assert_eq!(residue(&Rational::from_signeds(1, (1_i64 << 61) - 1)), None);
    }
}
