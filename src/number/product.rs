//! Long products and their quotients in lowest terms.

use super::parallel::both;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};

/// Primes below this are looked for one by one. Beyond it a prime divides too few of the factors to be worth a
/// division of each (bench `peers`, J6: a bit less in each of 10^5 factors saves about 0.2 µs, a division takes 2 ns).
const SMALL: u64 = 2048;

/// The product of all, by halves: `O(M(b) log b)` for `b` bits in all.
#[must_use]
pub fn product(factors: &[Natural]) -> Natural {
    let halved = |list: &[Natural]| -> Vec<Natural> {
        list.chunks(2)
            .map(|pair| match pair {
                [a, b] => a * b,
                [a, ..] => a.clone(),
                [] => Natural::ONE,
            })
            .collect()
    };
    let mut level = halved(factors);
    while level.len() > 1 {
        level = halved(&level);
    }
    level.pop().unwrap_or(Natural::ONE)
}

/// `∏ above/∏ below` in lowest terms; no factor of `below` may be zero.
///
/// Most of what the two products have in common are small primes. Those are counted on both sides before anything is
/// multiplied, only the difference goes in: the long greatest common divisor, which takes most of the time, gets
/// shorter operands.
#[must_use]
pub fn quotient(above: &[Natural], below: &[Natural]) -> Rational {
    let bound = SMALL.min(above.len().min(below.len()) as u64);
    let (mut up, mut above) = parted(above);
    let (mut down, mut below) = parted(below);
    for prime in (2..bound).filter(|p| (2..).take_while(|d| d * d <= *p).all(|d| p % d != 0)).map(Prime::new) {
        let (gained, lost) = (prime.taken_from(&mut up), prime.taken_from(&mut down));
        let side = if gained >= lost { &mut above } else { &mut below };
        side.push(Natural::from(prime.value).pow(gained.abs_diff(lost)));
    }
    above.extend(up.into_iter().map(Natural::from));
    below.extend(down.into_iter().map(Natural::from));
    let bits = |list: &[Natural]| list.iter().map(|f| f.significant_bits()).sum::<u64>();
    let (above, below) = both(bits(&above).min(bits(&below)), || product(&above), || product(&below));
    Rational::from_naturals(above, below)
}

/// Factors of up to 128 bits, without zero, and the others.
fn parted(factors: &[Natural]) -> (Vec<u128>, Vec<Natural>) {
    let (mut small, mut others) = (Vec::with_capacity(factors.len()), Vec::new());
    for factor in factors {
        match u128::try_from(factor) {
            Ok(word) if word != 0 => small.push(word),
            _ => others.push(factor.clone()),
        }
    }
    (small, others)
}

/// A prime, and its inverse modulo 2^64 if it is odd.
struct Prime {
    value: u64,
    inverse: u64,
}

impl Prime {
    fn new(value: u64) -> Prime {
        // An odd p is its own inverse modulo 8; each step p·i = 1 + d becomes 1 − d²: 3, 6, 12, 24, 48, 96 bits.
        let step = |i: u64, _| i.wrapping_mul(2_u64.wrapping_sub(value.wrapping_mul(i)));
        Prime { value, inverse: (0..5).fold(value, step) }
    }

    /// `x/p` where that is whole.
    ///
    /// With `x = h·2^64 + l`, a whole quotient is `l/p` modulo 2^64 in its lower half, call it `q`, and `h − (q·p >> 64)`
    /// over `p` in the upper one; that is whole if the product with the inverse is at most `(2^64 − 1)/p`, since the
    /// multiples of p take those values, once each.
    fn divided(&self, x: u128) -> Option<u128> {
        if self.value == 2 {
            return x.is_multiple_of(2).then_some(x / 2);
        }
        // Both casts keep 64 bits on purpose.
        let (high, low) = ((x >> 64) as u64, x as u64);
        let lower = low.wrapping_mul(self.inverse);
        let carried = ((u128::from(lower) * u128::from(self.value)) >> 64) as u64;
        let upper = high.checked_sub(carried)?.wrapping_mul(self.inverse);
        (upper <= u64::MAX / self.value).then(|| u128::from(upper) << 64 | u128::from(lower))
    }

    /// Divides every factor, none of which is zero, by p as often as it goes, and says how often in all.
    fn taken_from(&self, factors: &mut [u128]) -> u64 {
        let mut times = 0;
        for factor in factors {
            while let Some(rest) = self.divided(*factor) {
                *factor = rest;
                times += 1;
            }
        }
        times
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::{Prime, product, quotient};
    use malachite::base::num::basic::traits::{One, Zero};
    use malachite::{Natural, Rational};
    use proptest::prelude::*;

    #[test]
    fn products_without_factors_are_one() {
        assert_eq!(product(&[]), Natural::ONE);
        assert_eq!(quotient(&[], &[]), Rational::ONE);
        assert_eq!(quotient(&[Natural::ZERO; 3], &[Natural::from(7u8), Natural::ONE, Natural::ONE]), Rational::ZERO);
    }

    proptest! {
        #[test]
        fn a_quotient_is_there_exactly_where_it_is_whole(
            p in prop::sample::select(vec![2_u64, 3, 5, 7, 61, 251, 2039]), x in any::<u128>(), multiple in any::<bool>(),
        ) {
            let x = if multiple { x / u128::from(p) * u128::from(p) } else { x };
            let divided = Prime::new(p).divided(x);
            prop_assert_eq!(divided, (x % u128::from(p) == 0).then_some(x / u128::from(p)));
        }

        #[test]
        fn the_quotient_is_that_of_the_products(
            above in prop::collection::vec(prop_oneof![1..200_u128, any::<u128>()], 0..80),
            below in prop::collection::vec(prop_oneof![1..200_u128, 1..=u128::MAX], 0..80),
            long in 0..3_u32,
        ) {
            let list = |words: &[u128]| -> Vec<Natural> {
                words.iter().map(|w| Natural::from(*w) << (64 * u64::from(long))).collect()
            };
            let (above, below) = (list(&above), list(&below));
            let plain = |list: &[Natural]| list.iter().fold(Natural::ONE, |all, f| all * f);
            prop_assert_eq!(quotient(&above, &below), Rational::from_naturals(plain(&above), plain(&below)));
        }
    }
}
