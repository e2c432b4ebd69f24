//! Quotients of enclosures in machine words, by long division.
//!
//! **Method.** Each word of the quotient is guessed from the first words of the rest and the divisor, and then corrected.
//!
//! **Why the bound holds.** Operands `a = A + α`, `b = B + β` with digits `A`, `B` and `|α| <= e`, `|β| <= f` units, where
//! `a/b <= 1` and `B >= 2^-k`. Then `a/b − A/B = α/B − (a/b)·β/B`, which is at most `2^k·(e + f)` units. A digit that is cut
//! off is one more.
//!
//! Of many words the digits of `A/B` may be off by another unit. They come from the first one on, and where `j` words are
//! still to be found the rest and the divisor are cut to `j + 1` words. Count in the place of the next step's last word:
//! - Cutting the rest lowers what is left of it by less than one.
//! - Cutting the divisor raises it by less than one: a digit is below `2^64`, and what is cut off of the divisor is below
//!   one in the place before.
//!
//! A step moves all up by a word. After `L` steps the rest is off by at most `L` in the place of the divisor's first word.
//! That is `L·2^-63` units, since that word begins with a digit.
//!
//! Cut, the rest is never above the divisor. Where it equals it, the next word is all ones, and they stay equal.

use super::Fixed;
use crate::number::words::{Divisor, UNROLLED, below, fused, halves, shifted};

impl<const L: usize> Fixed<L> {
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
        for (place, word) in words.iter_mut().enumerate().rev() {
            // A guess from the two first words of the rest and the first of the divisor, at most 2 too large
            // (Knuth, The Art of Computer Programming, 4.3.1, theorem B), or all ones.
            let first = *rest.last()?;
            let next = *rest.get(L.wrapping_sub(2))?;
            let mut guess = if first >= top.value { u64::MAX } else { top.divide(first, next).0 };
            // As many words as are still to be found, and one.
            let cut = if L > UNROLLED { L.saturating_sub(place + 2) } else { 0 };
            let (d, rest) = (d.get(cut..)?, rest.get_mut(cut..)?);
            // rest·2^64 − guess·d, as the product with the complement, −d = !d + 1 − 2^(64·words); it may be negative by
            // up to two d.
            let (mut carry, mut previous) = (guess, 0_u64);
            for (digit, place) in d.iter().zip(rest.iter_mut()) {
                let (high, low) = fused(!*digit, guess, carry, previous);
                carry = high;
                previous = std::mem::replace(place, low);
            }
            let mut over = previous.wrapping_add(carry).wrapping_sub(guess);
            while over != 0 {
                guess -= 1;
                let mut carry = 0;
                for (place, digit) in rest.iter_mut().zip(d) {
                    (carry, *place) = halves(u128::from(*place) + u128::from(*digit) + u128::from(carry));
                }
                over = over.wrapping_add(carry);
            }
            *word = guess;
        }
        let error = self.error.saturating_add(other.error).saturating_mul(1 << k);
        Fixed::with_error(words, error.saturating_add(if L > UNROLLED { 2 } else { 1 }))
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{number, unit};
    use super::Fixed;
    use malachite::{Natural, Rational};
    use proptest::prelude::*;

    /// The quotient is that of the digits, cut off, or a unit less, whatever digits are skipped on the way.
    fn cut_quotient<const L: usize>(a: &Fixed<L>, b: &Fixed<L>) -> Result<(), TestCaseError> {
        let (mut a, mut b) = (*a, *b);
        (a.error, b.error) = (0, 0);
        if let Some(found) = a.over(&b) {
            let value = |x: &Fixed<L>| Rational::from(Natural::from_limbs_asc(&x.words));
            let exact = value(&a) / value(&b) / unit::<L>();
            let off = exact - value(&found);
            prop_assert!(off > -1 && off < 2, "{a:?} {b:?}: {off}");
        }
        Ok(())
    }

    proptest! {
        #[test]
        fn long_quotients_skip_no_digit_that_counts(a in number::<16>(), b in number::<16>(), same in 0..16_usize) {
            cut_quotient(&a, &b)?;
            // The first words of both agree: guesses are all ones.
            let mut near = b;
            near.words[..same].copy_from_slice(&a.words[..same]);
            cut_quotient(&near, &b)?;
            cut_quotient(&b, &near)?;
        }
    }
}
