//! Rounding of an enclosure to many digits: the digits are made first, and those beyond tell how to round.

use super::place::{leading_place, times_power_of_ten};
use super::{Decimal, Digits, Rounding, bits_of_digits};
use crate::number::digits;
use crate::number::interval::Interval;
use malachite::base::num::arithmetic::traits::UnsignedAbs;
use malachite::base::num::logic::traits::SignificantBits;
use std::cmp::Ordering;

/// From so many digits on, digits are made by [`super::digits`] (bench `numbers`, group `digits`).
const LONG_DIGITS: u64 = 2_000;

/// Digits beyond those asked for that tell how to round, and the unit of the last digit asked for in theirs.
const FURTHER: u64 = 9;
const FURTHER_UNIT: u64 = 1_000_000_000;

/// The common rounding of all elements of an enclosure to many digits; `None` where the general way must tell.
///
/// `y = |x|·10^-(leading + 1)`, from 0.1 to 1, is written down to [`FURTHER`] digits more than asked for, cut off; those tell
/// whether the width of the enclosure, in their last place, reaches across a point where rounding jumps.
pub(super) fn of_long(x: &Interval, sign: Ordering, digits: Digits, rounding: Rounding) -> Option<Decimal> {
    let leading = leading_place(x);
    let wanted = match digits {
        Digits::Significant(count) => i64::try_from(count).ok()?,
        Digits::Places(places) => i64::try_from(places).ok()?.checked_add(leading)?.checked_add(1)?,
    };
    let count = u64::try_from(wanted).ok().filter(|count| *count >= LONG_DIGITS)?;
    let shift = -leading.checked_add(1)?;
    let scaled = if shift == 0 {
        let ((lo, exponent), (hi, _)) = (x.lower()?, x.upper()?);
        (lo, hi, exponent)
    } else {
        times_power_of_ten(x, shift, digits)?
    };
    let (lo, hi, exponent) = scaled;
    let (near, far) = if sign == Ordering::Less {
        (hi.unsigned_abs(), lo.unsigned_abs())
    } else {
        (lo.unsigned_abs(), hi.unsigned_abs())
    };
    let bits = u64::try_from(exponent.checked_neg()?).ok()?;
    if far.significant_bits() > bits || far <= near {
        return None;
    }
    let all = count + FURTHER;
    // The width in units of the last digit: (far − near)·10^all/2^bits, at most 2^(its bits + log2(10)·all − bits).
    let gap = (far - &near).significant_bits() + bits_of_digits(all);
    let units =
        1_u64.checked_shl(u32::try_from(gap.saturating_sub(bits)).ok()?).filter(|units| *units < FURTHER_UNIT / 4)?;
    let text = digits::of_fraction(&near, bits, all)?;
    let (kept, rest) = text.split_at_checked(usize::try_from(count).ok()?)?;
    let rest: u64 = rest.parse().ok()?;
    // The value lies between `rest` and `rest + units + 1` units, or at one of them.
    let (least, most) = (rest, rest + units + 1);
    let half = FURTHER_UNIT / 2;
    let away = match rounding {
        Rounding::Nearest => (least > half).then_some(true).or((most < half).then_some(false))?,
        Rounding::Up => sign == Ordering::Greater,
        Rounding::Down => sign == Ordering::Less,
        Rounding::Away => true,
        Rounding::Zero => false,
    };
    if least == 0 || most >= FURTHER_UNIT || kept.starts_with('0') {
        return None;
    }
    let plain = matches!(digits, Digits::Places(_));
    let negative = sign == Ordering::Less;
    let cut = Decimal { negative, digits: kept.to_owned(), exponent: leading + 1 - wanted, plain };
    let mut found = if away { cut.away() } else { cut };
    if !plain && found.digits.len() > kept.len() {
        found.digits.pop();
        found.exponent += 1;
    }
    Some(found)
}
