//! Enclosures of numbers from 0 to 1 in machine words: no allocation, for up to some thousands of bits.
//!
//! **Contract.** A [`Fixed`] stands for every real from 0 to 1 that is at most `error` units away from its digits, a
//! unit being `2^(−64·L)`. Every operation contains what the exact operation gives on all elements of its operands,
//! as far as that lies from 0 to 1, or says `None`: the caller then takes [`super::interval`].
//!
//! **Why the bounds hold.** Operands `a = A + α`, `b = B + β` with digits `A`, `B` and `|α| <= e`, `|β| <= f` units.
//! - *Product.* `|ab − AB| = |αb + Aβ| <= e + f` units, since `A, b <= 1`. Of the products of words only those are formed
//!   that reach the word before the last kept one. The others are `s + 1` at each place `s <= L − 2`, each below
//!   `2^(64·(s + 2))` where a unit is `2^(64·L)`: below `L` units together, and the word that is cut off below another.
//! - *Square.* The same products, those of different words formed once and doubled.
//! - *Quotient* and *root* have files of their own.
//!
//! Errors are counted in 64 bits, saturating, and refused where they are too large to be of use.

mod quotient;
mod root;

use super::interval::Interval;
use super::words::{
    Divisor, UNROLLED, below, columns, columns_of_square, complement, difference, fused, rows, shifted, sum,
};
use malachite::{Integer, Natural, Rational};

/// Errors of more units than this are refused.
const MAX_ERROR: u64 = 1 << 60;

/// Exponents up to which powers are taken.
pub(crate) const MAX_EXPONENT: u64 = 1 << 10;

/// All reals from 0 to 1 within `error·2^(−64·L)` of the number whose binary digits after the point are `words`, the
/// last word first.
#[derive(Clone, Copy, Debug)]
pub struct Fixed<const L: usize> {
    words: [u64; L],
    error: u64,
}

impl<const L: usize> Fixed<L> {
    /// Up to so many bits can be expected of a result.
    pub const ROOM: u64 = 64 * L as u64 - 40;

    fn with_error(words: [u64; L], error: u64) -> Option<Fixed<L>> {
        (error < MAX_ERROR).then_some(Fixed { words, error })
    }

    /// The digits with more or fewer words, without the error: a point.
    #[must_use]
    pub fn resized<const M: usize>(&self) -> Fixed<M> {
        let mut words = [0; M];
        for (word, digit) in words.iter_mut().rev().zip(self.words.iter().rev()) {
            *word = *digit;
        }
        Fixed { words, error: 0 }
    }

    /// Zeros before the first digit that is not 0.
    fn leading_zeros(&self) -> u64 {
        let zeros = |word: &u64| u64::from(word.leading_zeros());
        let full = self.words.iter().rev().take_while(|word| **word == 0).count();
        64 * full as u64 + self.words.iter().rev().nth(full).map_or(0, zeros)
    }

    /// All products.
    #[inline]
    pub fn times(&self, other: &Fixed<L>) -> Option<Fixed<L>> {
        let mut words = [0; L];
        if L > UNROLLED {
            // Words in front that are zero do nothing, nor do the last words of the other factor.
            let used = L - other.words.iter().rev().take_while(|word| **word == 0).count();
            let (a, b) = (self.words.get(L - used..), other.words.get(..used));
            columns(a.unwrap_or_default(), b.unwrap_or_default(), words.get_mut(..used).unwrap_or_default());
        } else {
            words = rows(&self.words, &other.words);
        }
        Fixed::with_error(words, self.error.saturating_add(other.error).saturating_add(L as u64 + 1))
    }

    /// All squares.
    #[inline]
    pub fn square(&self) -> Option<Fixed<L>> {
        let mut words = [0; L];
        if L > UNROLLED {
            columns_of_square(&self.words, &mut words);
        } else {
            words = rows(&self.words, &self.words);
        }
        Fixed::with_error(words, self.error.saturating_mul(2).saturating_add(L as u64 + 1))
    }

    /// All powers, for an exponent from 1 to `MAX_EXPONENT`.
    pub fn power(&self, exponent: u64) -> Option<Fixed<L>> {
        if !(1..=MAX_EXPONENT).contains(&exponent) {
            return None;
        }
        let mut result = *self;
        for place in (0..exponent.ilog2()).rev() {
            result = result.square()?;
            if exponent >> place & 1 == 1 {
                result = result.times(self)?;
            }
        }
        Some(result)
    }

    /// `x·p`: the part before the point and the digits.
    #[inline]
    fn times_word(&self, p: u64) -> (u64, [u64; L]) {
        let (mut carry, mut words) = (0, [0; L]);
        for (out, word) in words.iter_mut().zip(&self.words) {
            (carry, *out) = fused(*word, p, carry, 0);
        }
        (carry, words)
    }

    /// `(whole + digits)/q`, rounded down: the part before the point and the digits.
    #[inline]
    fn over_word(whole: u64, mut words: [u64; L], q: &Divisor) -> (u64, [u64; L]) {
        if q.value == 1 {
            return (whole, words);
        }
        let (first, mut rest) = (whole / q.value, whole % q.value);
        let begins_with_zero = rest == 0;
        for word in words.iter_mut().rev().skip_while(|word| begins_with_zero && **word == 0) {
            (*word, rest) = q.divide(rest, *word);
        }
        (first, words)
    }

    /// All products with `p/q`, where the digits' product is below 1.
    pub fn times_rational(&self, p: u64, q: u64) -> Option<Fixed<L>> {
        let divisor = Divisor::new(q)?;
        let (whole, words) = self.times_word(p);
        let (whole, words) = Fixed::over_word(whole, words, &divisor);
        // A digit is cut off.
        let error = self.error.saturating_mul(p.div_ceil(q)).saturating_add(1);
        if whole == 0 { Fixed::with_error(words, error) } else { None }
    }

    /// All products with `(p/q)^exponent`, where the digits' product is below 1, and so are those with the smaller powers.
    pub fn times_power(&self, p: u64, q: u64, exponent: u64) -> Option<Fixed<L>> {
        if p == q || exponent == 0 {
            return Some(*self);
        }
        // So many factors fit in a word.
        let fitting = |x: u64| u64::from(u64::MAX.ilog2() / (x.ilog2() + 1));
        let power = |x: u64, k: u64| x.checked_pow(u32::try_from(k).ok()?);
        let (mut product, mut left) = (*self, exponent);
        while left > 0 {
            let taken = fitting(q).clamp(1, left);
            let (mut whole, mut above) = (0, taken);
            while above > 0 {
                // The part before the point stays below q^taken, as long as the product is below 1.
                let some = fitting(p.max(1)).clamp(1, above);
                let factor = power(p, some)?;
                let (carry, words) = product.times_word(factor);
                (whole, product.words) = (u64::checked_mul(whole, factor)?.checked_add(carry)?, words);
                above -= some;
            }
            let (whole, words) = Fixed::over_word(whole, product.words, &Divisor::new(power(q, taken)?)?);
            let growth = power(p.div_ceil(q), taken).unwrap_or(u64::MAX);
            let error = product.error.saturating_mul(growth).saturating_add(1);
            product = if whole == 0 { Fixed::with_error(words, error)? } else { return None };
            left -= taken;
        }
        Some(product)
    }

    /// `1 − x` for all elements.
    pub fn one_minus(&self) -> Option<Fixed<L>> {
        // Of 0 the digits of 1, which there is no room for, are a unit less.
        let zero = self.words == [0; L];
        let words = if zero { [u64::MAX; L] } else { complement(&self.words) };
        Fixed::with_error(words, self.error.saturating_add(u64::from(zero)))
    }

    /// Whether the digits are above another number's, and then all `x − y`, else all `y − x`.
    pub fn distance(&self, other: &Fixed<L>) -> Option<(bool, Fixed<L>)> {
        let above = below(&other.words, &self.words);
        let (more, less) = if above { (self, other) } else { (other, self) };
        let (words, _) = difference(&more.words, &less.words);
        // The error may make the difference cross 0, which the bounds of a product allow.
        Some((above, Fixed::with_error(words, self.error.saturating_add(other.error))?))
    }

    /// All sums, where the digits' sum is below 1; all differences if `above` is false, where the digits' difference is not
    /// below 0.
    pub fn plus(&self, above: bool, other: &Fixed<L>) -> Option<Fixed<L>> {
        let (words, beyond) =
            if above { sum(&self.words, &other.words) } else { difference(&self.words, &other.words) };
        if beyond { None } else { Fixed::with_error(words, self.error.saturating_add(other.error)) }
    }

    /// All `x·2^places`, for fewer than 64 places and digits that have so many zeros in front.
    pub fn times_power_of_2(&self, places: u64) -> Option<Fixed<L>> {
        if places >= 64 || self.leading_zeros() < places {
            return None;
        }
        Fixed::with_error(shifted(&self.words, places), self.error.checked_shl(places.try_into().ok()?)?)
    }

    /// The same and what is at most `factor·δ²` away, for each element `δ` of another number.
    pub fn widened(&self, factor: u64, delta: &Fixed<L>) -> Option<Fixed<L>> {
        // δ² in units, at most 2^(64L − 2k) for |δ| <= 2^-k.
        let tail = match (64 * L as u64).saturating_sub(2 * delta.zeros()) {
            places @ 0..64 => factor.saturating_mul(1 << places),
            _ => u64::MAX,
        };
        Fixed::with_error(self.words, self.error.saturating_add(tail))
    }

    /// Some `k` with `|x| <= 2^-k` for all elements, negative ones included.
    pub fn zeros(&self) -> u64 {
        let of_error = (64 * L as u64).saturating_sub(u64::from((self.error | 1).ilog2()) + 1);
        self.leading_zeros().min(of_error).saturating_sub(1)
    }

    /// Some `k` with `x >= 2^-k` for all elements.
    pub fn least(&self) -> Option<u64> {
        let digits = self.leading_zeros();
        let small = digits + 2 + u64::from((self.error | 1).ilog2()) < 64 * L as u64;
        small.then_some(digits + 2)
    }

    /// `(1 + x)/2` for all elements.
    pub fn halfway_to_one(&self) -> Option<Fixed<L>> {
        self.halved(1)
    }

    /// `x/2` for all elements.
    pub fn half(&self) -> Option<Fixed<L>> {
        self.halved(0)
    }

    fn halved(&self, whole: u64) -> Option<Fixed<L>> {
        let mut words = self.words;
        let mut above = whole;
        for word in words.iter_mut().rev() {
            let last = *word & 1;
            *word = *word >> 1 | above << 63;
            above = last;
        }
        Fixed::with_error(words, self.error / 2 + 1)
    }

    /// The same set as an interval with at most `bits` bits in the middle, where it has that accuracy.
    #[must_use]
    pub fn interval(&self, bits: u64) -> Option<Interval> {
        let Fixed { words, error } = Fixed::with_error(self.words, self.error)?;
        let mid = Integer::from(Natural::from_limbs_asc(&words));
        let unit = -i64::try_from(64 * L).ok()?;
        Some(Interval::around(mid, error, unit, bits + 4)).filter(|x| x.accuracy() >= bits)
    }
}

/// A number of machine words by a function that takes their count as a constant, in the least of the counts which has
/// room for so many bits.
#[macro_export]
macro_rules! in_words {
    ($room:expr, $bits:expr, $call:ident $arguments:tt, $(<$words:literal $(, $half:literal)?>),* $(,)?) => {
        $(if $room <= $crate::number::fixed::Fixed::<$words>::ROOM {
            $call::<$words $(, $half)?> $arguments?.interval($bits)
        } else)* {
            None
        }
    };
}
pub use in_words;

/// A ratio that is not 1 or its reciprocal, whichever is above 1, as two words, up to `2^32`.
#[must_use]
pub fn above_one(r: &Rational) -> Option<(u64, u64)> {
    let (p, q) = two_words(r)?;
    let (p, q) = (p.max(q), p.min(q));
    (p != q && p >> 32 < q).then_some((p, q))
}

/// Numerator and denominator of what is not below 0, if each fits in a word.
#[must_use]
pub fn two_words(r: &Rational) -> Option<(u64, u64)> {
    let words = (u64::try_from(r.numerator_ref()).ok()?, u64::try_from(r.denominator_ref()).ok()?);
    (*r >= 0).then_some(words)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::Fixed;
    use malachite::base::num::arithmetic::traits::{Pow, PowerOf2};
    use malachite::{Natural, Rational};
    use proptest::prelude::*;

    /// Words of every kind: any, all zeros, all ones, a single digit.
    fn word() -> impl Strategy<Value = u64> {
        prop_oneof![4 => any::<u64>(), 1 => Just(0), 1 => Just(u64::MAX), 1 => (0..64_u32).prop_map(|k| 1 << k)]
    }

    pub(super) fn number<const L: usize>() -> impl Strategy<Value = Fixed<L>> {
        (prop::collection::vec(word(), L), prop_oneof![Just(0), 0..1000_u64])
            .prop_map(|(words, error)| Fixed { words: words.try_into().unwrap(), error })
    }

    pub(super) fn unit<const L: usize>() -> Rational {
        Rational::power_of_2(-64 * i64::try_from(L).unwrap())
    }

    /// Both ends and the middle of what a number stands for, as far as they lie from 0 to 1.
    fn elements<const L: usize>(x: &Fixed<L>) -> Vec<Rational> {
        let middle = Rational::from(Natural::from_limbs_asc(&x.words)) * unit::<L>();
        let reach = Rational::from(x.error) * unit::<L>();
        let all = [&middle - &reach, middle.clone(), middle + reach];
        all.into_iter().filter(|x| *x >= 0 && *x <= 1).collect()
    }

    fn holds<const L: usize>(x: &Fixed<L>, value: &Rational) -> bool {
        let middle = Rational::from(Natural::from_limbs_asc(&x.words)) * unit::<L>();
        let off = if middle > *value { middle - value } else { value - middle };
        off <= Rational::from(x.error) * unit::<L>()
    }

    fn operations<const L: usize>(a: &Fixed<L>, b: &Fixed<L>, p: u64, q: u64) -> Result<(), TestCaseError> {
        let (product, quotient, square) = (a.times(b).unwrap(), a.over(b), a.square().unwrap());
        let (power, half, rest) = (a.power(5).unwrap(), a.halfway_to_one().unwrap(), a.one_minus().unwrap());
        let (p, q) = (p.min(q), p.max(q));
        let (share, shares) = (a.times_rational(p, q), a.times_power(p, q, 7));
        let grown = a.times_power(7, 2, 5);
        let ((above, gap), doubled) = (a.distance(b).unwrap(), a.times_power_of_2(3));
        let (more, less) = (a.plus(true, b), a.plus(false, b));
        let mut tiny = *b;
        tiny.words[L / 2..].fill(0);
        let wide = a.widened(3, &tiny).unwrap();
        let ratio = Rational::from_unsigneds(p, q);
        for x in elements(a) {
            prop_assert!(holds(&power, &(&x).pow(5_u64)));
            prop_assert!(holds(&square, &(&x).pow(2_u64)));
            prop_assert!(holds(&half, &((&x + Rational::from(1)) / Rational::from(2))));
            prop_assert!(holds(&rest, &(Rational::from(1) - &x)));
            prop_assert!(share.is_none_or(|share| holds(&share, &(&x * &ratio))) && share.is_some());
            prop_assert!(shares.is_none_or(|all| holds(&all, &(&x * (&ratio).pow(7_u64)))) && shares.is_some());
            prop_assert!(grown.is_none_or(|grown| holds(&grown, &(&x * Rational::from_unsigneds(7_u8, 2).pow(5_u64)))));
            prop_assert!(a.half().is_some_and(|half| holds(&half, &(&x >> 1_u32))));
            prop_assert!(doubled.is_none_or(|doubled| holds(&doubled, &(&x << 3_u32))));
            prop_assert!(a.least().is_none_or(|k| x >= Rational::power_of_2(-i64::try_from(k).unwrap())));
            prop_assert!(x <= Rational::power_of_2(-i64::try_from(a.zeros()).unwrap()));
            for delta in elements(&tiny) {
                let reach = Rational::from(3) * delta.pow(2_u64);
                prop_assert!(holds(&wide, &(&x + &reach)) && holds(&wide, &(&x - reach)));
            }
            for y in elements(b) {
                prop_assert!(holds(&product, &(&x * &y)));
                let between = if above { &x - &y } else { &y - &x };
                prop_assert!(holds(&gap, &between));
                prop_assert!(more.is_none_or(|more| holds(&more, &(&x + &y))));
                prop_assert!(less.is_none_or(|less| holds(&less, &(&x - &y))));
                if let Some(quotient) = &quotient
                    && x <= y
                    && y > 0
                {
                    prop_assert!(holds(quotient, &(&x / &y)));
                }
            }
        }
        // The bounds are of use, too.
        let cut = L as u64 + 1;
        prop_assert!(product.error <= a.error + b.error + cut && square.error <= 2 * a.error + cut);
        prop_assert!(half.error <= a.error / 2 + 1 && rest.error <= a.error + 1);
        Ok(())
    }

    proptest! {
        #[test]
        fn operations_in_twelve_words_hold_every_result(a in number::<12>(), b in number::<12>(), p in 1..99_u64, q in 1_u64..) {
            operations(&a, &b, p, q)?;
        }

        #[test]
        fn operations_in_many_words_hold_every_result(a in number::<24>(), b in number::<24>(), p in 1_u64.., q in 1_u64..) {
            operations(&a, &b, p, q)?;
            operations(&a.resized::<16>(), &b.resized::<16>(), p, q)?;
            operations(&a.resized::<33>(), &b.resized::<33>(), p, q)?;
        }

        #[test]
        fn operations_in_three_words_hold_every_result(a in number::<3>(), b in number::<3>(), p in 1_u64.., q in 1_u64..) {
            operations(&a, &b, p, q)?;
        }

        #[test]
        fn operations_in_six_words_hold_every_result(a in number::<6>(), b in number::<6>(), p in 1..99_u64, q in 1_u64..) {
            operations(&a, &b, p, q)?;
        }
    }
}
