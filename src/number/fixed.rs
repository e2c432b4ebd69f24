//! Enclosures of numbers from 0 to 1 in a few machine words: no allocation, for up to some 400 bits.
//!
//! **Contract.** A [`Fixed`] stands for every real from 0 to 1 that is at most `error` units away from its digits, a
//! unit being `2^(−64·L)`. Every operation contains what the exact operation gives on all elements of its operands,
//! as far as that lies from 0 to 1, or says `None`: the caller then takes [`super::interval`].
//!
//! **Why the bounds hold.** Operands `a = A + α`, `b = B + β` with digits `A`, `B` and `|α| <= e`, `|β| <= f` units.
//! - *Product.* `|ab − AB| = |αb + Aβ| <= e + f` units, since `A, b <= 1`. Of the products of words only those are formed
//!   that reach the word before the last kept one. The others are `s + 1` at each place `s <= L − 2`, each below
//!   `2^(64·(s + 2))` where a unit is `2^(64·L)`: below `L` units together, and the word that is cut off below another.
//! - *Quotient* with `ab^-1 <= 1` and `B >= 2^-k`: `a/b − A/B = α/B − (a/b)·β/B`, at most `2^k·(e + f)` units; a digit that
//!   is cut off is one more.
//! - *Root.* See [`Fixed::inverse_root`].
//!
//! Errors are counted in 64 bits, saturating, and refused where they are too large to be of use.

use super::interval::Interval;
use malachite::{Integer, Natural, Rational};

/// Errors of more units than this are refused.
const MAX_ERROR: u64 = 1 << 60;

/// Exponents up to which powers are taken.
pub const MAX_EXPONENT: u64 = 1 << 10;

/// All reals from 0 to 1 within `error·2^(−64·L)` of the number whose binary digits after the point are `words`, the
/// last word first.
#[derive(Clone, Copy, Debug)]
pub struct Fixed<const L: usize> {
    words: [u64; L],
    error: u64,
}

/// The upper and the lower word.
#[inline(always)]
fn halves(x: u128) -> (u64, u64) {
    // Both casts keep 64 bits on purpose.
    ((x >> 64) as u64, x as u64)
}

/// `a·b + c + d`, which fits: `(2^64 − 1)² + 2·(2^64 − 1) = 2^128 − 1`.
#[inline(always)]
fn fused(a: u64, b: u64, c: u64, d: u64) -> (u64, u64) {
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
struct Divisor {
    value: u64,
    places: u32,
    shifted: u64,
    /// `⌊(2^128 − 1)/shifted⌋ − 2^64`.
    reciprocal: u64,
}

impl Divisor {
    fn new(value: u64) -> Option<Divisor> {
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
    fn divide(&self, high: u64, low: u64) -> (u64, u64) {
        let (high, low) = halves((u128::from(high) << 64 | u128::from(low)) << self.places);
        let (quotient, rest) = divide_two(high, low, self.shifted, self.reciprocal);
        (quotient, rest >> self.places)
    }
}

impl<const L: usize> Fixed<L> {
    /// Up to so many bits can be expected of a result.
    pub const ROOM: u64 = 64 * L as u64 - 40;

    fn with_error(words: [u64; L], error: u64) -> Option<Fixed<L>> {
        (error < MAX_ERROR).then_some(Fixed { words, error })
    }

    /// The point with the leading digits of a double between 0 and 1, without error; for guesses.
    fn point(x: f64) -> Option<Fixed<L>> {
        let inside = x > 0.0 && x < 1.0;
        let mut words = [0; L];
        // Below 2^64 as x < 1: the cast is exact but for digits beyond the 64th, which a guess does without.
        *words.last_mut()? = if inside { (x * 18_446_744_073_709_551_616.0) as u64 } else { 0 };
        inside.then_some(Fixed { words, error: 0 })
    }

    /// The digits with more or fewer words, without the error.
    fn resized<const M: usize>(&self) -> Fixed<M> {
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
        let (mut places, mut below) = ([0_u64; L], 0_u64);
        for (i, a) in self.words.iter().enumerate() {
            let mut factors = other.words.iter().skip(L - 1 - i);
            let mut carry = 0;
            if let Some(b) = factors.next() {
                (carry, below) = fused(*a, *b, below, 0);
            }
            for (place, b) in places.iter_mut().zip(factors) {
                (carry, *place) = fused(*a, *b, *place, carry);
            }
            places[i] = carry;
        }
        let cut = L as u64 + 1;
        Fixed::with_error(places, self.error.saturating_add(other.error).saturating_add(cut))
    }

    /// All powers, for an exponent from 1 to [`MAX_EXPONENT`].
    pub fn power(&self, exponent: u64) -> Option<Fixed<L>> {
        if !(1..=MAX_EXPONENT).contains(&exponent) {
            return None;
        }
        let mut result = *self;
        for place in (0..exponent.ilog2()).rev() {
            result = result.times(&result)?;
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
        for word in words.iter_mut().rev() {
            (*word, rest) = q.divide(rest, *word);
        }
        (first, words)
    }

    /// All products with `p/q <= 1`.
    pub fn times_rational(&self, p: u64, q: u64) -> Option<Fixed<L>> {
        if p > q {
            return None;
        }
        let (whole, words) = self.times_word(p);
        let (_, words) = Fixed::over_word(whole, words, &Divisor::new(q)?);
        // The error does not grow; a digit is cut off.
        Fixed::with_error(words, self.error.saturating_add(1))
    }

    /// `(1 + x)/2` for all elements.
    pub fn halfway_to_one(&self) -> Option<Fixed<L>> {
        let mut words = self.words;
        let mut above = 1;
        for word in words.iter_mut().rev() {
            let last = *word & 1;
            *word = *word >> 1 | above << 63;
            above = last;
        }
        Fixed::with_error(words, self.error / 2 + 1)
    }

    /// All quotients of what is at most 1; `None` unless the dividend's digits are below the divisor's.
    pub fn over(&self, other: &Fixed<L>) -> Option<Fixed<L>> {
        let zeros = other.leading_zeros();
        // B >= 2^-k.
        let k = zeros + 1;
        if zeros >= 60 || !below(&self.words, &other.words) {
            return None;
        }
        // Shifting both by the same places changes nothing but puts the divisor's first digit in front; the
        // dividend, being smaller, loses nothing either.
        let (mut rest, d) = (shifted(&self.words, zeros), shifted(&other.words, zeros));
        let top = Divisor::new(*d.last()?)?;
        let mut words = [0; L];
        for word in words.iter_mut().rev() {
            // A guess from the two first words of the rest and the first of the divisor, at most 2 too large
            // (Knuth, The Art of Computer Programming, 4.3.1, theorem B), or all ones.
            let first = *rest.last()?;
            let next = *rest.get(L.wrapping_sub(2))?;
            let mut guess = if first >= top.value { u64::MAX } else { top.divide(first, next).0 };
            // rest·2^64 − guess·d; it may be negative by up to two d.
            let (mut borrow, mut out, mut previous) = (0_u64, [0; L], 0_u64);
            for (i, digit) in d.iter().enumerate() {
                let (high, low) = fused(*digit, guess, borrow, 0);
                let (difference, under) = previous.overflowing_sub(low);
                out[i] = difference;
                borrow = high + u64::from(under);
                previous = rest[i];
            }
            let (mut over, _) = previous.overflowing_sub(borrow);
            while over != 0 {
                guess -= 1;
                let mut carry = 0;
                for (place, digit) in out.iter_mut().zip(&d) {
                    (carry, *place) = halves(u128::from(*place) + u128::from(*digit) + u128::from(carry));
                }
                over = over.wrapping_add(carry);
            }
            *word = guess;
            rest = out;
        }
        let error = self.error.saturating_add(other.error).saturating_mul(1 << k).saturating_add(1);
        Fixed::with_error(words, error)
    }

    /// `(p/q)^(−1/n)` for `p > q > 0` and `n` from 1 to [`MAX_EXPONENT`].
    ///
    /// As in [`super::root`]: for a point `y` and `ρ = (p/q)·y^n − 1`, `|ρ| <= 1/16`, the root is `y − y·ρ/n + y·θ`, `|θ| <= 2ρ²/n`. The
    /// guess has some 50 digits and each step doubles them: in two words, in four, in seven, and in all.
    pub fn inverse_root(p: u64, q: u64, n: u64) -> Option<Fixed<L>> {
        if p <= q || !(1..=MAX_EXPONENT).contains(&n) {
            return None;
        }
        let equation = (p, Divisor::new(q)?, Divisor::new(n)?);
        // The casts round; the guess may be wrong.
        let guess = (q as f64 / p as f64).powf(1.0 / n as f64);
        let y = Fixed::<2>::point(guess)?.corrected(equation)?;
        if L <= 3 {
            return y.resized::<L>().corrected(equation);
        }
        let y = y.resized::<4>().corrected(equation)?;
        if L <= 6 {
            return y.resized::<L>().corrected(equation);
        }
        y.resized::<7>().corrected(equation)?.resized::<L>().corrected(equation)
    }

    /// One step of [`Fixed::inverse_root`] from a point.
    fn corrected(&self, (p, q, n): (u64, Divisor, Divisor)) -> Option<Fixed<L>> {
        let power = self.power(n.value)?;
        let (whole, words) = power.times_word(p);
        let (whole, words) = Fixed::over_word(whole, words, &q);
        // |ρ|, with its sign aside; the error may make it cross 0, which the bounds of a product allow.
        let (above, words) = match whole {
            1 => (true, words),
            // Without a digit ρ is −1, which is not small.
            0 if words != [0; L] => (false, complement(&words)),
            _ => return None,
        };
        let rho = Fixed { words, error: power.error.saturating_mul(p.div_ceil(q.value)).saturating_add(1) };
        // |ρ| <= 2^-k.
        let k =
            rho.leading_zeros().min((64 * L as u64).saturating_sub(u64::from(rho.error.ilog2()) + 1)).saturating_sub(1);
        if k < 4 {
            return None;
        }
        let product = self.times(&rho)?;
        let (_, step) = Fixed::over_word(0, product.words, &n);
        // 2ρ²/n in units, at most 2^(64L + 1 − 2k).
        let tail = match (64 * L as u64 + 1).saturating_sub(2 * k) {
            places @ 0..64 => (1_u64 << places).div_ceil(n.value),
            _ => u64::MAX,
        };
        let (words, beyond) = if above { difference(&self.words, &step) } else { sum(&self.words, &step) };
        let error = (product.error / n.value).saturating_add(2).saturating_add(tail);
        // Points of intermediate steps may have any error.
        (!beyond).then_some(Fixed { words, error })
    }

    /// The same set as an interval with at most `bits` bits in the middle, where it has that accuracy.
    #[must_use]
    pub fn to_interval(&self, bits: u64) -> Option<Interval> {
        let Fixed { words, error } = Fixed::with_error(self.words, self.error)?;
        let mid = Integer::from(Natural::from_limbs_asc(&words));
        let unit = -i64::try_from(64 * L).ok()?;
        Some(Interval::around(mid, error, unit, bits + 4)).filter(|x| x.accuracy() >= bits)
    }
}

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

/// Whether the first number is below the second.
fn below<const L: usize>(a: &[u64; L], b: &[u64; L]) -> bool {
    a.iter().rev().lt(b.iter().rev())
}

/// The digits moved up by fewer places than leading zeros.
fn shifted<const L: usize>(words: &[u64; L], places: u64) -> [u64; L] {
    let (mut out, mut carry) = ([0; L], 0);
    for (out, word) in out.iter_mut().zip(words) {
        let (high, low) = halves(u128::from(*word) << places);
        *out = low | carry;
        carry = high;
    }
    out
}

/// The sum, and whether it reaches 1.
fn sum<const L: usize>(a: &[u64; L], b: &[u64; L]) -> ([u64; L], bool) {
    let (mut out, mut carry) = ([0; L], 0);
    for ((out, a), b) in out.iter_mut().zip(a).zip(b) {
        (carry, *out) = halves(u128::from(*a) + u128::from(*b) + u128::from(carry));
    }
    (out, carry != 0)
}

/// The difference, and whether it lies below 0.
fn difference<const L: usize>(a: &[u64; L], b: &[u64; L]) -> ([u64; L], bool) {
    let (mut out, mut borrow) = ([0; L], false);
    for ((out, a), b) in out.iter_mut().zip(a).zip(b) {
        let (rest, under) = a.overflowing_sub(*b);
        let (rest, again) = rest.overflowing_sub(u64::from(borrow));
        (*out, borrow) = (rest, under || again);
    }
    (out, borrow)
}

/// `1 − x` for `x > 0`; 0 for 0.
fn complement<const L: usize>(words: &[u64; L]) -> [u64; L] {
    difference(&[0; L], words).0
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::{Divisor, Fixed, MAX_EXPONENT};
    use crate::number::interval::Interval;
    use crate::number::root::root;
    use malachite::base::num::arithmetic::traits::{Pow, PowerOf2};
    use malachite::{Natural, Rational};
    use proptest::prelude::*;

    /// Words of every kind: any, all zeros, all ones, a single digit.
    fn word() -> impl Strategy<Value = u64> {
        prop_oneof![4 => any::<u64>(), 1 => Just(0), 1 => Just(u64::MAX), 1 => (0..64_u32).prop_map(|k| 1 << k)]
    }

    fn number<const L: usize>() -> impl Strategy<Value = Fixed<L>> {
        (prop::collection::vec(word(), L), prop_oneof![Just(0), 0..1000_u64])
            .prop_map(|(words, error)| Fixed { words: words.try_into().unwrap(), error })
    }

    fn unit<const L: usize>() -> Rational {
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
        let (product, quotient) = (a.times(b).unwrap(), a.over(b));
        let (power, half) = (a.power(5).unwrap(), a.halfway_to_one().unwrap());
        let share = a.times_rational(p.min(q), p.max(q)).unwrap();
        for x in elements(a) {
            prop_assert!(holds(&power, &(&x).pow(5_u64)));
            prop_assert!(holds(&half, &((&x + Rational::from(1)) / Rational::from(2))));
            prop_assert!(holds(&share, &(&x * Rational::from_unsigneds(p.min(q), p.max(q)))));
            for y in elements(b) {
                prop_assert!(holds(&product, &(&x * &y)));
                if let Some(quotient) = &quotient
                    && x <= y
                    && y > 0
                {
                    prop_assert!(holds(quotient, &(&x / &y)));
                }
            }
        }
        // The bounds are of use, too.
        prop_assert!(product.error <= a.error + b.error + L as u64 + 1 && half.error <= a.error / 2 + 1);
        Ok(())
    }

    fn enclosed_root<const L: usize>(p: u64, q: u64, n: u64) -> Result<bool, TestCaseError> {
        let Some(found) = Fixed::<L>::inverse_root(p, q, n).and_then(|y| y.to_interval(10)) else { return Ok(false) };
        let exact = root(&Rational::from_unsigneds(q, p), &Natural::from(n), 64 * L as u64 + 100);
        prop_assert!(found.contains_interval(&exact), "{p}/{q}, {n}: {found:?} against {exact:?}");
        Ok(true)
    }

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

    #[test]
    fn roots_are_as_narrow_as_the_words_allow() {
        for n in [1, 2, 3, 8, 100] {
            let narrow = |x: Option<Interval>| assert!(x.is_some(), "{n}");
            narrow(Fixed::<3>::inverse_root(10, 1, n).and_then(|y| y.to_interval(Fixed::<3>::ROOM)));
            narrow(Fixed::<4>::inverse_root(10, 1, n).and_then(|y| y.to_interval(Fixed::<4>::ROOM)));
            narrow(Fixed::<6>::inverse_root(10, 1, n).and_then(|y| y.to_interval(Fixed::<6>::ROOM)));
            narrow(Fixed::<8>::inverse_root(10, 1, n).and_then(|y| y.to_interval(Fixed::<8>::ROOM)));
        }
        assert!(Fixed::<3>::inverse_root(1, 1, 3).is_none() && Fixed::<3>::inverse_root(1, 2, 3).is_none());
        assert!(
            Fixed::<3>::inverse_root(2, 1, 0).is_none() && Fixed::<3>::inverse_root(2, 1, MAX_EXPONENT + 1).is_none()
        );
    }

    proptest! {
        #[test]
        fn operations_in_three_words_hold_every_result(a in number::<3>(), b in number::<3>(), p in 1_u64.., q in 1_u64..) {
            operations(&a, &b, p, q)?;
        }

        #[test]
        fn operations_in_six_words_hold_every_result(a in number::<6>(), b in number::<6>(), p in 1..99_u64, q in 1_u64..) {
            operations(&a, &b, p, q)?;
        }

        #[test]
        fn roots_hold_the_root(
            p in prop_oneof![1..1000_u64, any::<u64>()], q in prop_oneof![1..1000_u64, 1_u64..], n in 1..=64_u64,
        ) {
            let (p, q) = (p.max(q), p.min(q));
            prop_assume!(q > 0);
            let all = [enclosed_root::<3>(p, q, n)?, enclosed_root::<4>(p, q, n)?, enclosed_root::<6>(p, q, n)?, enclosed_root::<8>(p, q, n)?];
            // Ordinary ratios are not left to others.
            prop_assert!(p / q >= 1 << 20 || p - q <= q / 1000 || all == [true; 4], "{p}/{q}, {n}: {all:?}");
        }

        #[test]
        fn a_wrong_guess_is_refused_or_corrected(guess in 0.0..1.0_f64, n in 1..20_u64) {
            let equation = (10, Divisor::new(1).unwrap(), Divisor::new(n).unwrap());
            let exact = root(&Rational::from_unsigneds(1_u8, 10), &Natural::from(n), 400);
            let found = Fixed::<4>::point(guess).and_then(|y| y.corrected(equation)).and_then(|y| y.to_interval(1));
            prop_assert!(found.is_none_or(|found| found.contains_interval(&exact)));
        }
    }
}
