//! Long products and their quotients in lowest terms.

use super::fraction::Fraction;
use super::parallel::both;
use malachite::Natural;
use malachite::base::num::arithmetic::traits::{Gcd, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;

/// Primes below this are looked for one by one. Beyond it a prime divides too few of the factors to be worth a
/// division of each (bench `peers`, J6: flat between 256 and 2048).
const SMALL: u64 = 1024;

/// So many words are multiplied one after the other, and compared with the other product one by one (bench `peers`, J6).
const BLOCK: usize = 32;

/// Products of fewer bits are not worth a thread (bench `peers`, J6).
const THREAD_BITS: u64 = 30_000;

/// The product of all, by halves: `O(M(b) log b)` for `b` bits in all.
#[must_use]
pub(crate) fn product(factors: &[Natural]) -> Natural {
    match factors {
        [] => Natural::ONE,
        [only] => only.clone(),
        _ => {
            let mut level = halved(factors);
            while level.len() > 1 {
                level = halved(&level);
            }
            level.pop().unwrap_or(Natural::ONE)
        }
    }
}

/// Products of neighbours; a last one without neighbour stays.
fn halved(list: &[Natural]) -> Vec<Natural> {
    list.chunks(2)
        .map(|pair| match pair {
            [a, b] => a * b,
            [a, ..] => a.clone(),
            [] => Natural::ONE,
        })
        .collect()
}

/// `∏ above/∏ below` in lowest terms; no factor of `below` may be zero.
///
/// Most of what the two products have in common are small primes. Those are counted on both sides before anything is
/// multiplied, and only the difference goes in. What else they have in common is found by blocks. For `D = ∏ d_j` and
/// `g_j = gcd(N, d_j)`,
///
/// ```text
/// gcd(N, D) = gcd(N, ∏ g_j):
/// ```
///
/// let a prime p divide N, D and d_j to the powers a, b and b_j. If some `b_j >= a`, both sides have `p^a`; otherwise g_j
/// has `p^(b_j)`, and both sides have `p^min(a, b)`. The g_j take `N mod d_j`, which come from a remainder tree over the
/// same products that made D; their product is much shorter than D, so that the one long greatest common divisor is short.
#[must_use]
pub fn quotient(above: impl IntoIterator<Item = Natural>, below: impl IntoIterator<Item = Natural>) -> Fraction {
    let (mut up, mut down) = (Factors::of(above), Factors::of(below));
    if up.zero {
        return Fraction::reduced(Natural::ZERO, Natural::ONE, &Natural::ONE);
    }
    for prime in Prime::small(up.len().min(down.len())) {
        let (gained, lost) = (up.without(&prime), down.without(&prime));
        let side = if gained >= lost { &mut up } else { &mut down };
        side.others.push(Natural::from(prime.value).pow(gained.abs_diff(lost)));
    }
    up.pack();
    down.pack();
    let worth = up.bits().min(down.bits()) >= THREAD_BITS;
    let (numerator, below) = both(worth, || product(&up.blocks()), || Tree::of(&down));
    let common = below.common(&numerator);
    Fraction::reduced(numerator, below.root(), &common)
}

/// A number that every common prime of both products divides, and no other prime does; no factor may be zero.
pub(super) fn shared(above: impl IntoIterator<Item = Natural>, below: impl IntoIterator<Item = Natural>) -> Natural {
    let (mut up, mut down) = (Factors::of(above), Factors::of(below));
    up.pack();
    down.pack();
    let worth = up.bits().min(down.bits()) >= THREAD_BITS;
    let (numerator, below) = both(worth, || product(&up.blocks()), || Tree::of(&down));
    below.common(&numerator)
}

/// The factors of a product, by length.
#[derive(Default)]
struct Factors {
    words: Vec<u64>,
    pairs: Vec<u128>,
    others: Vec<Natural>,
    zero: bool,
}

impl Factors {
    fn of(list: impl IntoIterator<Item = Natural>) -> Factors {
        let mut factors = Factors::default();
        for factor in list {
            factors.zero |= factor == Natural::ZERO;
            if let Ok(word) = u64::try_from(&factor) {
                factors.words.push(word);
            } else if let Ok(pair) = u128::try_from(&factor) {
                factors.pairs.push(pair);
            } else {
                factors.others.push(factor);
            }
        }
        factors
    }

    fn len(&self) -> usize {
        self.words.len() + self.pairs.len() + self.others.len()
    }

    /// Divides the factors of one and two words, none of which is zero, by a prime as often as it goes, and says how
    /// often in all.
    fn without(&mut self, prime: &Prime) -> u64 {
        let mut times = 0;
        if prime.value == 2 {
            for factor in &mut self.words {
                let twos = factor.trailing_zeros();
                *factor >>= twos;
                times += u64::from(twos);
            }
        } else {
            for factor in &mut self.words {
                while let Some(rest) = prime.divided_word(*factor) {
                    *factor = rest;
                    times += 1;
                }
            }
        }
        for factor in &mut self.pairs {
            while let Some(rest) = prime.divided(*factor) {
                *factor = rest;
                times += 1;
            }
        }
        times
    }

    /// The same product in fewer words: they are multiplied as long as one holds the product.
    fn pack(&mut self) {
        let mut full = Vec::with_capacity(self.words.len());
        for word in self.words.drain(..) {
            match full.last_mut() {
                Some(last) => match u64::checked_mul(*last, word) {
                    Some(product) => *last = product,
                    None => full.push(word),
                },
                None => full.push(word),
            }
        }
        self.words = full;
        self.pairs.retain(|pair| match u64::try_from(*pair) {
            Ok(word) => {
                self.words.push(word);
                false
            }
            Err(_) => true,
        });
    }

    fn bits(&self) -> u64 {
        let words = self.words.len() as u64 + 2 * self.pairs.len() as u64;
        words * u64::from(u64::BITS) + self.others.iter().map(|f| f.significant_bits()).sum::<u64>()
    }

    /// Products of [`BLOCK`] words each, in order, and then the longer factors.
    fn blocks(&self) -> Vec<Natural> {
        let words = self.words.chunks(BLOCK).map(of_words);
        words.chain(self.pairs.iter().map(|pair| Natural::from(*pair))).chain(self.others.iter().cloned()).collect()
    }
}

/// The product of some words, one after the other.
fn of_words(words: &[u64]) -> Natural {
    let mut digits = Vec::with_capacity(words.len() + 1);
    digits.push(1);
    for word in words {
        let mut carried = 0;
        for digit in &mut digits {
            let wide = u128::from(*digit) * u128::from(*word) + u128::from(carried);
            // The lower and the upper half.
            (*digit, carried) = (wide as u64, (wide >> 64) as u64);
        }
        if carried > 0 {
            digits.push(carried);
        }
    }
    Natural::from_owned_limbs_asc(digits)
}

/// A product with the products of its blocks, of pairs of blocks, and so on: level k + 1 holds the products of neighbours
/// of level k, the last level one product. None is empty.
struct Tree {
    words: Vec<u64>,
    levels: Vec<Vec<Natural>>,
}

impl Tree {
    fn of(factors: &Factors) -> Tree {
        let mut level = factors.blocks();
        if level.is_empty() {
            level.push(Natural::ONE);
        }
        let mut levels = Vec::new();
        while level.len() > 1 {
            let next = halved(&level);
            levels.push(level);
            level = next;
        }
        levels.push(level);
        Tree { words: factors.words.clone(), levels }
    }

    /// The whole product.
    fn root(mut self) -> Natural {
        self.levels.pop().and_then(|mut last| last.pop()).unwrap_or(Natural::ONE)
    }

    /// The greatest common divisor of the product with `n`.
    fn common(&self, n: &Natural) -> Natural {
        let mut shared = Factors::default();
        if let Some(top) = self.levels.len().checked_sub(1) {
            let threads = std::thread::available_parallelism().map_or(1, |count| count.get());
            self.descend((top, 0), n, threads.ilog2(), &mut shared);
        }
        shared.pack();
        let shared = product(&shared.blocks());
        if shared == Natural::ONE { shared } else { (n % &shared).gcd(shared) }
    }

    /// Collects the divisors that factors have in common with a number, given modulo a multiple of the block at `place`,
    /// a level and an index. In the first levels, `spread` of them, both halves of a block are looked at side by side.
    fn descend(&self, place: (usize, usize), n: &Natural, spread: u32, shared: &mut Factors) {
        let (level, index) = place;
        let Some(block) = self.levels.get(level).and_then(|list| list.get(index)) else { return };
        let rest = n % block;
        if level == 0 {
            match self.words.chunks(BLOCK).nth(index) {
                Some(words) => {
                    shared.words.extend(words.iter().map(|word| common_word(&rest, *word)).filter(|g| *g > 1))
                }
                None => shared.others.push(rest.gcd(block)),
            }
            return;
        }
        let half = |index| {
            let mut found = Factors::default();
            self.descend((level - 1, index), &rest, spread.saturating_sub(1), &mut found);
            found
        };
        let worth = spread > 0 && block.significant_bits() >= THREAD_BITS;
        let (left, right) = both(worth, || half(2 * index), || half(2 * index + 1));
        for found in [left, right] {
            shared.words.extend(found.words);
            shared.others.extend(found.others);
        }
    }
}

/// `gcd(x, word)` for a word that is not zero.
fn common_word(x: &Natural, word: u64) -> u64 {
    u64::try_from(&(x % Natural::from(word))).map_or(1, |rest| rest.gcd(word))
}

/// A prime, its inverse modulo 2^64 if it is odd, and the largest quotient of a word.
pub(super) struct Prime {
    pub(super) value: u64,
    inverse: u64,
    most: u64,
}

impl Prime {
    /// The primes that are worth looking for one by one in so many factors.
    pub(super) fn small(factors: usize) -> Vec<Prime> {
        let bound = SMALL.min(factors as u64);
        (2..bound).filter(|p| (2..).take_while(|d| d * d <= *p).all(|d| p % d != 0)).map(Prime::new).collect()
    }

    fn new(value: u64) -> Prime {
        // An odd p is its own inverse modulo 8; each step p·i = 1 + d becomes 1 − d²: 3, 6, 12, 24, 48, 96 bits.
        let step = |i: u64, _| i.wrapping_mul(2_u64.wrapping_sub(value.wrapping_mul(i)));
        Prime { value, inverse: (0..5).fold(value, step), most: u64::MAX / value }
    }

    /// `x/p` where that is whole, for x not zero: the multiples of p are those whose product with the inverse is at
    /// most `(2^64 − 1)/p`.
    pub(super) fn divided_word(&self, x: u64) -> Option<u64> {
        if self.value == 2 {
            return x.is_multiple_of(2).then_some(x / 2);
        }
        let rest = x.wrapping_mul(self.inverse);
        (rest <= self.most).then_some(rest)
    }

    /// `x/p` where that is whole.
    ///
    /// With `x = h·2^64 + l`, a whole quotient is `l/p` modulo 2^64 in its lower half, call it `q`, and `h − (q·p >> 64)`
    /// over `p` in the upper one; that is whole if the product with the inverse is at most `(2^64 − 1)/p`, since the
    /// multiples of p take those values, once each.
    pub(super) fn divided(&self, x: u128) -> Option<u128> {
        if self.value == 2 {
            return x.is_multiple_of(2).then_some(x / 2);
        }
        // Both casts keep 64 bits on purpose.
        let (high, low) = ((x >> 64) as u64, x as u64);
        let lower = low.wrapping_mul(self.inverse);
        let carried = ((u128::from(lower) * u128::from(self.value)) >> 64) as u64;
        let upper = high.checked_sub(carried)?.wrapping_mul(self.inverse);
        (upper <= self.most).then(|| u128::from(upper) << 64 | u128::from(lower))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::{Fraction, Prime, product, quotient};
    use malachite::base::num::basic::traits::{One, Zero};
    use malachite::{Natural, Rational};
    use proptest::prelude::*;

    #[test]
    fn products_without_factors_are_one() {
        let naturals = |list: &[u8]| list.iter().map(|x| Natural::from(*x)).collect::<Vec<_>>();
        assert_eq!(product(&[]), Natural::ONE);
        assert_eq!(quotient([], []), Rational::ONE);
        assert_eq!(quotient(naturals(&[0, 0, 0]), naturals(&[7, 1, 1])), Rational::ZERO);
        assert_eq!(quotient(naturals(&[6]), []), Rational::from(6));
    }

    /// `∏ above/∏ below` by malachite alone, part by part.
    fn plain(above: &[Natural], below: &[Natural]) -> Rational {
        let all = |list: &[Natural]| list.iter().fold(Natural::ONE, |all, f| all * f);
        Rational::from_naturals(all(above), all(below))
    }

    /// Whether the parts are the very ones of malachite's rational: in lowest terms, that is.
    fn agree(found: &Fraction, expected: &Rational) -> bool {
        found.numerator() == expected.numerator_ref() && found.denominator() == expected.denominator_ref()
    }

    /// Primes above those which are looked for one by one, and their products: what the blocks must find.
    fn of_large_primes() -> impl Strategy<Value = u64> {
        let prime = || prop::sample::select(vec![1_u64, 1031, 1033, 65_521, 65_537, 2_147_483_647]);
        (prime(), prime()).prop_map(|(p, q)| p * q)
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
            above in prop::collection::vec(prop_oneof![1..200_u128, any::<u64>().prop_map(u128::from), any::<u128>()], 0..80),
            below in prop::collection::vec(prop_oneof![1..200_u128, 1..=u128::from(u64::MAX), 1..=u128::MAX], 0..80),
            long in 0..3_u32,
        ) {
            let list = |words: &[u128]| -> Vec<Natural> {
                words.iter().map(|w| Natural::from(*w) << (64 * u64::from(long))).collect()
            };
            let (above, below) = (list(&above), list(&below));
            let expected = plain(&above, &below);
            prop_assert!(agree(&quotient(above, below), &expected));
        }

        #[test]
        fn large_primes_in_common_are_found(
            above in prop::collection::vec(of_large_primes(), 0..400), below in prop::collection::vec(of_large_primes(), 0..400),
            squares in prop::collection::vec(of_large_primes(), 0..4),
        ) {
            let list = |words: &[u64]| words.iter().map(|w| Natural::from(*w)).collect::<Vec<_>>();
            let mut below = list(&below);
            // Factors of many words have blocks of their own.
            below.extend(squares.iter().map(|w| Natural::from(*w) * Natural::from(*w) * Natural::from(u128::MAX)));
            let above = list(&above);
            let expected = plain(&above, &below);
            prop_assert!(agree(&quotient(above, below), &expected));
        }
    }

    #[test]
    fn long_products_on_two_threads_are_the_same() {
        // 2,000 factors of 40 bits from a linear congruence: 80,000 bits each.
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            Natural::from((state >> 24) | 1)
        };
        let (above, below): (Vec<Natural>, Vec<Natural>) = (0..2000).map(|_| (next(), next())).unzip();
        let expected = plain(&above, &below);
        assert!(agree(&quotient(above, below), &expected));
    }
}
