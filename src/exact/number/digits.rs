//! Binary fractions as decimal digits, in subquadratic time and without a division.
//!
//! **Contract.** [`of_fraction`] gives the first `n` decimal digits of a number from 0 to 1, cut off, exactly; `None` in the rare
//! case that the digits after them are so near to the next place that the truncations below could matter.
//!
//! **Method.** The first `m` digits of `v` are those of `v` itself, cut to the bits that they need; the other ones are the
//! digits of the fractional part of `10^m·v`, cut likewise (`GUARD` bits more than needed). Both halves by the same rule,
//! down to `LEAF` digits, which are taken 19 at a time by products with a machine word.
//!
//! **Why it is right.** All cuts are downwards. A cut to `log2(10^n) + GUARD` bits lowers a number by at most `2^-GUARD` units of
//! its `n`-th digit; the first half inherits nothing else that counts, the second one what its parent had, so that the
//! digits of a leaf are those of a number that is too small by at most `60·2^-GUARD` units of the leaf's last digit. They are
//! those of the number itself if what follows them is below `1 − 60·2^-GUARD`: that is tested at every leaf, and where
//! a cut has carried a number across a power of ten, all its leaves show nines and fail the test.
//!
//! **Cost.** `O(M(n) log n)`, half of what a division with remainder at every level would take at least.

use super::parallel::{MIN_BITS, both};
use malachite::Natural;
use malachite::base::num::arithmetic::traits::{ModPowerOf2, Pow, Square};
use malachite::base::num::logic::traits::SignificantBits;
use std::collections::BTreeMap;

/// Bits beyond those that the digits need.
const GUARD: u64 = 64;

/// So many digits at most are taken in machine words (bench `numbers`, group `digits`).
const LEAF: u64 = 19 * 60;

/// Digits in a machine word.
const WORD: u64 = 19;

/// A thread is started where a half has this many times the bits that are worth one.
const SPLIT: u64 = 8;

/// What follows a leaf's digits must be below this, of `2^64`.
const NEARLY_ONE: u64 = u64::MAX - (1 << 20);

/// The power of five for each length that is cut in two.
type Powers = BTreeMap<u64, Natural>;

/// The digits of the first half; whole words.
fn first_half(n: u64) -> u64 {
    (n / 2).div_ceil(WORD) * WORD
}

/// Finds the powers for a number of `n` digits, each from a shorter one.
fn prepare(n: u64, powers: &mut Powers) {
    if n <= LEAF {
        return;
    }
    // Lengths that share a first half need not share the second one.
    let first = first_half(n);
    prepare(first, powers);
    prepare(n - first, powers);
    if powers.contains_key(&first) {
        return;
    }
    let five = Natural::from(5u32);
    // The half of the first half is there, unless that is a leaf.
    let found = match powers.get(&first_half(first)) {
        // It may be longer than a half by some digits.
        Some(half) => match first.checked_sub(2 * first_half(first)) {
            Some(more) => half.square() * five.pow(more),
            None => half.square() / five.pow(2 * first_half(first) - first),
        },
        None => five.pow(first),
    };
    powers.insert(first, found);
}

/// Bits that hold so many decimal digits.
#[must_use]
pub fn bits_of_digits(digits: u64) -> u64 {
    // log2(10) = 3.32192…; at least that many.
    digits.saturating_mul(3_322) / 1_000 + 1
}

/// Bits that hold every number of so many digits, and [`GUARD`] more.
fn bits_for(digits: u64) -> u64 {
    bits_of_digits(digits) + GUARD
}

/// The first `n` digits of `fraction·2^-bits`, a number below 1.
#[must_use]
pub(crate) fn of_fraction(fraction: &Natural, bits: u64, n: u64) -> Option<String> {
    if fraction.significant_bits() > bits {
        return None;
    }
    let wanted = bits_for(n);
    let cut = if bits > wanted { fraction >> (bits - wanted) } else { fraction << (wanted - bits) };
    let mut powers = Powers::new();
    prepare(n, &mut powers);
    String::from_utf8(digits(cut, wanted, n, &powers)?).ok()
}

/// The first `n` digits of `fraction·2^-bits`.
fn digits(fraction: Natural, bits: u64, n: u64, powers: &Powers) -> Option<Vec<u8>> {
    if n <= LEAF {
        let mut out = Vec::with_capacity(usize::try_from(n).ok()?);
        leaf(&fraction, bits, n, &mut out)?;
        return Some(out);
    }
    let first = first_half(n);
    let power = powers.get(&first)?;
    let unit = bits.checked_sub(first)?;
    let begin = || {
        let needed = bits_for(first).min(bits);
        digits(&fraction >> (bits - needed), needed, first, powers)
    };
    let end = || {
        // The fractional part of 10^first·v: 5^first·fraction in units of 2^-(bits − first).
        let rest = (&fraction * power).mod_power_of_2(unit);
        let cut = unit.saturating_sub(bits_for(n - first));
        digits(rest >> cut, unit - cut, n - first, powers)
    };
    let (begin, end) = both(bits / SPLIT >= MIN_BITS, begin, end);
    let mut out = begin?;
    out.extend(end?);
    Some(out)
}

/// Appends digits by products with powers of ten in a machine word.
fn leaf(fraction: &Natural, bits: u64, n: u64, out: &mut Vec<u8>) -> Option<()> {
    let words = bits.div_ceil(u64::BITS.into());
    let mut limbs = (fraction << (words * u64::from(u64::BITS) - bits)).into_limbs_asc();
    limbs.resize(usize::try_from(words).ok()?, 0);
    let mut left = n;
    while left > 0 {
        let taken = left.min(WORD);
        let factor = u128::from(10_u64.pow(u32::try_from(taken).ok()?));
        let mut carry = 0_u64;
        for limb in &mut limbs {
            let product = u128::from(*limb) * factor + u128::from(carry);
            *limb = u64::try_from(product & u128::from(u64::MAX)).ok()?;
            carry = u64::try_from(product >> u64::BITS).ok()?;
        }
        let start = out.len();
        let width = usize::try_from(taken).ok()?;
        out.resize(start + width, b'0');
        for place in out.get_mut(start..)?.iter_mut().rev() {
            *place = b'0' + u8::try_from(carry % 10).ok()?;
            carry /= 10;
        }
        left -= taken;
    }
    (limbs.last().copied().unwrap_or(0) < NEARLY_ONE).then_some(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use malachite::base::num::arithmetic::traits::PowerOf2;
    use proptest::prelude::*;

    /// The digits by one division.
    fn plain(fraction: &Natural, bits: u64, n: u64) -> String {
        let whole = (fraction * Natural::from(10u32).pow(n)) >> bits;
        format!("{whole:0>width$}", width = usize::try_from(n).expect("small"))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn digits_are_those_of_one_division(words in prop::collection::vec(any::<u64>(), 1..400), n in 1u64..9_000) {
            let bits = 64 * words.len() as u64;
            let fraction = Natural::from_limbs_asc(&words);
            if let Some(found) = of_fraction(&fraction, bits, n) {
                prop_assert_eq!(found, plain(&fraction, bits, n));
            } else {
                prop_assert!(plain(&fraction, bits, n + 12).ends_with("99999"), "refused without need");
            }
        }
    }

    #[test]
    fn decimals_and_their_neighbours_are_cut_or_refused() {
        // 10^-k and what lies a hair below it, to lengths around the cuts.
        for n in [1, 19, 20, 1_140, 1_141, 1_160, 2_280, 2_300, 2_400] {
            for k in [1, 10, 190, 569, 570, 571, 1_139, 1_140, 1_141, 1_160, 2_000] {
                let bits = 8_000;
                let unit = Natural::power_of_2(bits) / Natural::from(10u32).pow(k);
                for fraction in [&unit + Natural::from(1u32), unit.clone(), &unit - Natural::from(1u32)] {
                    if let Some(found) = of_fraction(&fraction, bits, n) {
                        assert_eq!(found, plain(&fraction, bits, n), "{n} {k}");
                    }
                }
            }
        }
        assert_eq!(of_fraction(&Natural::from(0u32), 10, 500), Some("0".repeat(500)));
        assert_eq!(of_fraction(&Natural::from(1u32), 1, 1_000), Some(format!("5{}", "0".repeat(999))));
        assert_eq!(of_fraction(&Natural::power_of_2(10), 10, 5), None);
    }
}
