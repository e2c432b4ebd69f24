//! The place of a decimal's last digit: where a number is rounded, and the number scaled to it.

use super::{Decimal, Digits, bits_of_digits};
use crate::number::interval::{Interval, MAX_EXPONENT};
use crate::number::real::MAX_BITS;
use malachite::base::num::arithmetic::traits::{ShrRound, UnsignedAbs};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::rounding_modes::RoundingMode;
use malachite::{Integer, Natural};
use std::cmp::Ordering;

/// Finds the place of the last digit and rounds there.
///
/// `scaled(places)` gives the number times `10^places`, rounded as asked, and whether the number reaches that
/// in size; `None` where the enclosure does not tell.
pub(super) fn place_and_round(
    sign: Ordering,
    digits: Digits,
    mut leading: i64,
    scaled: impl Fn(i64) -> Option<(Integer, Option<bool>)>,
) -> Option<Decimal> {
    let negative = sign == Ordering::Less;
    let wanted = match digits {
        Digits::Places(places) => {
            let places = i64::try_from(places).ok()?;
            let value = scaled(places)?.0.unsigned_abs();
            return Some(Decimal {
                negative: negative && value != 0,
                digits: value.to_string(),
                exponent: -places,
                plain: true,
            });
        }
        Digits::Significant(wanted) => i64::try_from(wanted).ok()?,
    };
    // The estimate is off by a few places at most, and each round corrects it by what it finds.
    for _ in 0..6 {
        let places = wanted.checked_sub(1)?.checked_sub(leading)?;
        let (value, reaches) = scaled(places)?;
        let mut text = value.unsigned_abs_ref().to_string();
        let length = i64::try_from(text.len()).ok()?;
        let is_power_of_ten = text.starts_with('1') && text.bytes().skip(1).all(|b| b == b'0');
        if value == 0 {
            leading -= 1;
        } else if length == wanted + 1 && is_power_of_ten {
            // Rounded up to the next power of ten, or equal to it to the last digit: the same decimal.
            text.pop();
            return Some(Decimal { negative, digits: text, exponent: 1 - places, plain: false });
        } else if length == wanted && is_power_of_ten && !reaches? {
            // Smaller than that power of ten: one more place is significant.
            leading -= 1;
        } else if length == wanted {
            return Some(Decimal { negative, digits: text, exponent: -places, plain: false });
        } else {
            leading += length - wanted;
        }
    }
    None
}

/// The place of the leading decimal digit, give or take one (a few for exponents of 10^18).
pub(super) fn leading_place(x: &Interval) -> i64 {
    let top = x.top();
    // ends with 53 bits of the middle, scaled to [1/2, 1)
    let mantissa = x.middle(53).shifted(-top.clamp(-MAX_EXPONENT, MAX_EXPONENT));
    let part = mantissa.guess_f64().abs().log10();
    // log10(2)·10^18 = 301029995663981195.2…
    let whole = i128::from(top) * 301_029_995_663_981_195;
    let unit = 1_000_000_000_000_000_000_i128;
    // The cast saturates; the result is an estimate that is corrected where it is used.
    let part = if part.is_finite() { (part * 1e18) as i128 } else { 0 };
    i64::try_from((whole + part).div_euclid(unit)).unwrap_or(0)
}

/// The ends of `x·10^places` in units of a common power of two.
pub(super) fn times_power_of_ten(x: &Interval, places: i64, digits: Digits) -> Option<(Integer, Integer, i64)> {
    // All that x tells is kept: how near it is to a rounding boundary is not known in advance.
    let bits = x.accuracy().min(x.middle_bits().max(bits_of_digits(digits.count()))).max(64) + 40;
    let five = Interval::from_integer(5);
    let power = five.power(&Natural::from(places.unsigned_abs()), bits);
    let product = if places >= 0 { x.multiply(&power, bits) } else { x.divide(&power, bits) }.shifted(places);
    // An integer of that many bits would not be the result of any rounding that is asked for.
    if product.top() > i64::try_from(MAX_BITS).unwrap_or(i64::MAX) {
        return None;
    }
    let ((lo, exponent), (hi, _)) = (product.lower()?, product.upper()?);
    Some((lo, hi, exponent))
}

/// `x·2^exponent` as an integer, rounded as asked.
pub(super) fn to_integer(x: &Integer, exponent: i64, mode: RoundingMode) -> Integer {
    if exponent >= 0 { x << exponent.unsigned_abs() } else { x.shr_round(exponent.unsigned_abs(), mode).0 }
}

/// The order of `|x·2^exponent|` and `|y|`.
pub(super) fn compare_size(x: &Integer, exponent: i64, y: &Integer) -> Ordering {
    let places = exponent.unsigned_abs();
    let (x, y) = (x.unsigned_abs(), y.unsigned_abs());
    if exponent >= 0 {
        (x << places).cmp(&y)
    } else if x.significant_bits() < places + y.significant_bits() {
        Ordering::Less
    } else if x.significant_bits() > places + y.significant_bits() {
        Ordering::Greater
    } else {
        x.cmp(&(y << places))
    }
}
