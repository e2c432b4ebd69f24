//! Numbers from 0 to 1 as machine words: products, squares, sums and quotients of their digits.
//!
//! Contract: digits are after the point, the last word first; nothing is allocated. What is cut off is said with each
//! function; [`super::fixed`] counts it.

/// The upper and the lower word.
#[inline(always)]
pub(super) fn halves(x: u128) -> (u64, u64) {
    // Both casts keep 64 bits on purpose.
    ((x >> 64) as u64, x as u64)
}

/// `a·b + c + d`, which fits: `(2^64 − 1)² + 2·(2^64 − 1) = 2^128 − 1`.
#[inline(always)]
pub(super) fn fused(a: u64, b: u64, c: u64, d: u64) -> (u64, u64) {
    halves(u128::from(a) * u128::from(b) + u128::from(c) + u128::from(d))
}

/// `⌊(high·2^64 + low)/d⌋` and the rest, for `d >= 2^63`, `high < d` and `reciprocal = ⌊(2^128 − 1)/d⌋ − 2^64`
/// (Möller and Granlund, Improved division by invariant integers, 2011, algorithm 4).
#[inline(always)]
fn divide_two(high: u64, low: u64, d: u64, reciprocal: u64) -> (u64, u64) {
    let (estimate, fraction) = halves(u128::from(reciprocal) * u128::from(high));
    let (fraction, carry) = fraction.overflowing_add(low);
    let mut quotient = estimate.wrapping_add(high).wrapping_add(1).wrapping_add(u64::from(carry));
    let mut rest = low.wrapping_sub(quotient.wrapping_mul(d));
    if rest > fraction {
        quotient = quotient.wrapping_sub(1);
        rest = rest.wrapping_add(d);
    }
    if rest >= d {
        quotient = quotient.wrapping_add(1);
        rest -= d;
    }
    (quotient, rest)
}

/// A divisor that is not 0, shifted so that its first digit stands in front, with its reciprocal.
#[derive(Clone, Copy)]
pub(super) struct Divisor {
    pub(super) value: u64,
    places: u32,
    shifted: u64,
    /// `⌊(2^128 − 1)/shifted⌋ − 2^64`.
    reciprocal: u64,
}

impl Divisor {
    pub(super) fn new(value: u64) -> Option<Divisor> {
        if value == 0 {
            return None;
        }
        let places = value.leading_zeros();
        let shifted = value << places;
        let (_, reciprocal) = halves(u128::MAX / u128::from(shifted));
        Some(Divisor { value, places, shifted, reciprocal })
    }

    /// `⌊(high·2^64 + low)/value⌋` and the rest, for `high < value`.
    #[inline(always)]
    pub(super) fn divide(&self, high: u64, low: u64) -> (u64, u64) {
        let (high, low) = halves((u128::from(high) << 64 | u128::from(low)) << self.places);
        let (quotient, rest) = divide_two(high, low, self.shifted, self.reciprocal);
        (quotient, rest >> self.places)
    }
}

/// Up to so many words products are formed row by row, in registers.
pub(super) const UNROLLED: usize = 8;

/// The upper half of a product, without the places below the last kept word but one, row by row.
#[inline(always)]
pub(super) fn rows<const L: usize>(a: &[u64; L], b: &[u64; L]) -> [u64; L] {
    let (mut places, mut below) = ([0_u64; L], 0_u64);
    for (i, a) in a.iter().enumerate() {
        let mut factors = b.iter().skip(L - 1 - i);
        let mut carry = 0;
        if let Some(b) = factors.next() {
            (carry, below) = fused(*a, *b, below, 0);
        }
        for (place, b) in places.iter_mut().zip(factors) {
            (carry, *place) = fused(*a, *b, *place, carry);
        }
        places[i] = carry;
    }
    places
}

/// The same column by column, for operands and a result of equal length: longer sums, which are not stored on the way.
#[inline(always)]
pub(super) fn columns(a: &[u64], b: &[u64], places: &mut [u64]) {
    let mut sum = Column::default();
    sum.add_products(a, b);
    for (k, place) in places.iter_mut().enumerate() {
        sum.carry_on();
        sum.add_products(a.get(k + 1..).unwrap_or_default(), b.get(k + 1..).unwrap_or_default());
        *place = sum.word();
    }
}

/// The same for a square, in which the product of two different words occurs twice.
#[inline(always)]
pub(super) fn columns_of_square(a: &[u64], places: &mut [u64]) {
    // A short point has many: they do nothing.
    let zeros = a.iter().take_while(|word| **word == 0).count();
    let mut sum = Column::default();
    sum.add_products_of_square(a, zeros);
    for (k, place) in places.iter_mut().enumerate() {
        sum.carry_on();
        sum.add_products_of_square(a.get(k + 1..).unwrap_or_default(), zeros.saturating_sub(k + 1));
        *place = sum.word();
    }
}

/// A sum of products of words, below `2^192`: of fewer than `2^63` of them and what the column before carried.
#[derive(Default)]
struct Column {
    low: u128,
    high: u64,
}

impl Column {
    #[inline(always)]
    fn add(&mut self, low: u128, high: u64) {
        let (sum, carry) = self.low.overflowing_add(low);
        self.low = sum;
        self.high = self.high.wrapping_add(high).wrapping_add(u64::from(carry));
    }

    /// Adds `a_0·b_n + a_1·b_(n−1) + … + a_n·b_0`.
    #[inline(always)]
    fn add_products(&mut self, a: &[u64], b: &[u64]) {
        for (a, b) in a.iter().zip(b.iter().rev()) {
            self.add(u128::from(*a) * u128::from(*b), 0);
        }
    }

    /// Adds `a_0·a_n + … + a_n·a_0`, where so many of the first words are zero.
    #[inline(always)]
    fn add_products_of_square(&mut self, a: &[u64], zeros: usize) {
        let half = a.len() / 2;
        let (lower, upper) = (a.get(zeros..half), a.get(a.len() - half..a.len().saturating_sub(zeros)));
        let mut once = Column::default();
        once.add_products(lower.unwrap_or_default(), upper.unwrap_or_default());
        self.add(once.low << 1, once.high << 1 | halves(once.low).0 >> 63);
        if let Some(middle) = a.get(half).filter(|_| a.len() % 2 == 1) {
            self.add(u128::from(*middle) * u128::from(*middle), 0);
        }
    }

    /// The last word.
    #[inline(always)]
    pub(super) fn word(&self) -> u64 {
        halves(self.low).1
    }

    /// Goes on to the next column with what is carried.
    #[inline(always)]
    fn carry_on(&mut self) {
        let (high, _) = halves(self.low);
        *self = Column { low: u128::from(self.high) << 64 | u128::from(high), high: 0 };
    }
}

/// Whether the first number is below the second.
pub(super) fn below<const L: usize>(a: &[u64; L], b: &[u64; L]) -> bool {
    a.iter().rev().lt(b.iter().rev())
}

/// The digits moved up by fewer places than leading zeros.
pub(super) fn shifted<const L: usize>(words: &[u64; L], places: u64) -> [u64; L] {
    let (mut out, mut carry) = ([0; L], 0);
    for (out, word) in out.iter_mut().zip(words) {
        let (high, low) = halves(u128::from(*word) << places);
        *out = low | carry;
        carry = high;
    }
    out
}

/// The sum, and whether it reaches 1.
pub(super) fn sum<const L: usize>(a: &[u64; L], b: &[u64; L]) -> ([u64; L], bool) {
    let (mut out, mut carry) = ([0; L], 0);
    for ((out, a), b) in out.iter_mut().zip(a).zip(b) {
        (carry, *out) = halves(u128::from(*a) + u128::from(*b) + u128::from(carry));
    }
    (out, carry != 0)
}

/// The difference, and whether it lies below 0.
pub(super) fn difference<const L: usize>(a: &[u64; L], b: &[u64; L]) -> ([u64; L], bool) {
    let (mut out, mut borrow) = ([0; L], false);
    for ((out, a), b) in out.iter_mut().zip(a).zip(b) {
        let (rest, under) = a.overflowing_sub(*b);
        let (rest, again) = rest.overflowing_sub(u64::from(borrow));
        (*out, borrow) = (rest, under || again);
    }
    (out, borrow)
}

/// `1 − x` for `x > 0`; 0 for 0.
pub(super) fn complement<const L: usize>(words: &[u64; L]) -> [u64; L] {
    difference(&[0; L], words).0
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::Divisor;

    #[test]
    fn a_word_over_a_word_is_rounded_down() {
        for d in [1, 2, 3, 10, 1 << 63, (1 << 63) + 1, u64::MAX - 1, u64::MAX] {
            let divisor = Divisor::new(d).unwrap();
            for high in [0, 1, d / 2, d - 1] {
                for low in [0, 1, d.wrapping_sub(1), u64::MAX - 1, u64::MAX] {
                    if high < d {
                        let x = u128::from(high) << 64 | u128::from(low);
                        let (quotient, rest) = divisor.divide(high, low);
                        assert_eq!((u128::from(quotient), u128::from(rest)), (x / u128::from(d), x % u128::from(d)));
                    }
                }
            }
        }
        assert!(Divisor::new(0).is_none());
    }
}
