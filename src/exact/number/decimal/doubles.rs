//! Decimals of numbers between two doubles, in machine words.

use super::{Decimal, Digits, Rounding};

/// The doubles that [`Decimal::of_doubles`] takes: with `10^MAX_PLACES` they make numbers of at most 127 bits.
const WORD_LEAST: f64 = f64::from_bits((1023 - 70) << 52);
const WORD_MOST: f64 = 1.0;
const MAX_PLACES: i64 = 21;

/// About `10^-k`.
const SCALES: [f64; 22] = [
    1e0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, 1e-17,
    1e-18, 1e-19, 1e-20, 1e-21,
];

/// `10^k`, for `k` from 0 to [`MAX_PLACES`].
fn power_of_ten(k: i64) -> Option<u128> {
    (0..=MAX_PLACES).contains(&k).then(|| 10_u128.pow(u32::try_from(k).unwrap_or(0)))
}

impl Decimal {
    /// The common rounding of all reals between two positive doubles, in machine words; `None` where they do not share
    /// one, where a tie is among them, and where words are too short.
    ///
    /// Right for a number between the doubles that is neither a decimal of so many digits nor a tie: both ends have the
    /// same whole number of halves of the last place, and the lower one is not itself such a number of halves.
    #[must_use]
    pub fn of_doubles(lo: f64, hi: f64, digits: Digits, rounding: Rounding) -> Option<Decimal> {
        if !(WORD_LEAST..=WORD_MOST).contains(&lo) || !(WORD_LEAST..=WORD_MOST).contains(&hi) {
            return None;
        }
        let (places, least) = match digits {
            Digits::Places(places) => (i64::try_from(places).ok()?, 1_u128),
            Digits::Significant(count) => {
                // The leading place, give or take one: the number of digits is checked below.
                let leading = -i64::try_from(SCALES.iter().position(|scale| lo >= *scale)?).ok()?;
                let count = i64::try_from(count).ok()?;
                (count - 1 - leading, power_of_ten(count - 1)?)
            }
        };
        let power = power_of_ten(places)?;
        // Twice x·10^places: its whole part, and whether it is whole.
        let halves = |x: f64| {
            let bits = x.to_bits();
            let mantissa = u128::from(bits & ((1 << 52) - 1) | 1 << 52);
            // At most 2^127 by the limits of both factors; x = mantissa·2^-shift.
            let shift = u32::try_from(1075 - i64::try_from(bits >> 52).ok()?).ok()?;
            let scaled = mantissa.checked_mul(power)?.checked_mul(2)?;
            Some((scaled >> shift, scaled & ((1 << shift) - 1) == 0))
        };
        let ((below, whole), (above, _)) = (halves(lo)?, halves(hi)?);
        if below != above || whole {
            return None;
        }
        let floor = below / 2;
        let value = match rounding {
            Rounding::Nearest => floor + below % 2,
            Rounding::Down | Rounding::Zero => floor,
            Rounding::Up | Rounding::Away => floor + 1,
        };
        let plain = matches!(digits, Digits::Places(_));
        let (fits, value, exponent) = match digits {
            Digits::Places(_) => (value > 0, value, -places),
            // What rounds up to a power of ten has one digit more: its last zero goes.
            Digits::Significant(_) if value == 10 * least => (true, least, 1 - places),
            Digits::Significant(_) => (floor >= least && value < 10 * least, value, -places),
        };
        fits.then(|| Decimal { negative: false, digits: value.to_string(), exponent, plain })
    }
}
