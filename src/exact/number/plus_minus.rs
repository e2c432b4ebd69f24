//! A range as `1.698 ± 0.006`: a centre and a reach with as many digits as are known.
//!
//! **Contract.** Every number of the range lies within the reach of the centre, both read as the exact decimals that they
//! are. The reach has one significant digit, or two where the first is 1; both are shorter where that loses nothing.

use super::decimal::{Decimal, Digits, Rounding};
use malachite::base::num::arithmetic::traits::{Abs, Ceiling, Pow};
use malachite::base::num::basic::traits::Two;
use malachite::base::num::conversion::traits::RoundingInto;
use malachite::base::rounding_modes::RoundingMode;
use malachite::{Integer, Rational};

/// Decimals with at most so many places are written without a power of ten.
const PLACES: i64 = 9;
/// So are whole numbers of at most so many digits.
const WHOLE: i64 = 9;

/// The range from `lo` to `hi`, as `centre ± reach`; `None` for a single number, or where `hi < lo`.
///
/// ```
/// use carom_exact::number::{plus_minus::plus_minus, rational::parse};
/// let range = |lo, hi| plus_minus(&parse(lo).unwrap(), &parse(hi).unwrap());
/// assert_eq!(range("1.69209", "1.70336").unwrap(), "1.698 ± 0.006");
/// assert_eq!(range("57", "57.2").unwrap(), "57.1 ± 0.1");
/// ```
#[must_use]
pub fn plus_minus(lo: &Rational, hi: &Rational) -> Option<String> {
    if lo >= hi {
        return None;
    }
    let middle = (lo + hi) / Rational::TWO;
    let (place, first) = leading((hi - lo) / Rational::TWO)?;
    let mut unit = if first == "1" { place - 1 } else { place };
    let (mut centre, mut reach) = around(&middle, lo, hi, unit);
    // A last digit 0 in both says nothing where the range is met exactly.
    while centre.1 && (&centre.0 % Integer::from(10)) == 0 && (&reach % Integer::from(10)) == 0 {
        unit += 1;
        let shorter = around(&middle, lo, hi, unit);
        (centre, reach) = shorter;
    }
    let value = |digits: &Integer| Rational::from(digits) * ten_to(unit);
    let top = leading(value(&centre.0).abs().max(value(&reach)))?.0;
    let scaled = if unit < -PLACES || top >= WHOLE { top } else { 0 };
    let places = u64::try_from(scaled - unit).unwrap_or(0);
    let text = |digits: &Integer| {
        let shown = value(digits) / ten_to(scaled);
        Decimal::of_rational(&shown, Digits::Places(places), Rounding::Nearest).map(|d| d.to_string())
    };
    let (centre, reach) = (text(&centre.0).ok()?, text(&reach).ok()?);
    Some(if scaled == 0 { format!("{centre} ± {reach}") } else { format!("({centre} ± {reach})e{scaled}") })
}

/// The multiple of `10^unit` next to the middle, whether it is the middle, and the least reach in such units.
fn around(middle: &Rational, lo: &Rational, hi: &Rational, unit: i64) -> ((Integer, bool), Integer) {
    let scale = ten_to(unit);
    let (centre, side): (Integer, _) = (middle / &scale).rounding_into(RoundingMode::Nearest);
    let at = Rational::from(&centre) * &scale;
    let reach = ((hi - &at).max(&at - lo) / scale).ceiling();
    ((centre, side.is_eq()), reach)
}

fn ten_to(exponent: i64) -> Rational {
    Rational::from(10u32).pow(exponent)
}

/// The exponent of ten of a positive number's first digit, and the digit.
fn leading(x: Rational) -> Option<(i64, String)> {
    let found = Decimal::of_rational(&x, Digits::Significant(1), Rounding::Down).ok()?;
    Some((found.exponent() + found.digits().len() as i64 - 1, found.digits().to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::rational::parse;

    #[test]
    fn as_many_digits_are_shown_as_are_known() {
        for (lo, hi, shown) in [
            ("57.0", "57.2", "57.1 ± 0.1"),
            ("1.69209", "1.70336", "1.698 ± 0.006"),
            ("-0.013", "0.011", "-0.001 ± 0.012"),
            ("0.0999", "0.1001", "0.1000 ± 0.0001"),
            ("618", "622", "620 ± 2"),
            ("9", "11", "10 ± 1"),
            ("0", "1e-12", "(5 ± 5)e-13"),
            ("1.0e12", "1.2e12", "(1.1 ± 0.1)e12"),
            ("1/3", "2/3", "0.50 ± 0.17"),
        ] {
            let (lo, hi) = (parse(lo).expect("a number"), parse(hi).expect("a number"));
            assert_eq!(plus_minus(&lo, &hi).as_deref(), Some(shown));
        }
        assert_eq!(plus_minus(&Rational::TWO, &Rational::TWO), None, "a single number has no reach");
    }
}
