//! How a decimal is written: plainly, or with an exponent where it is far from one.

use super::Decimal;
use std::fmt;

/// Leading places from here to [`PLAIN_TO`] are written without an exponent.
const PLAIN_FROM: i64 = -6;
const PLAIN_TO: i64 = 20;

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.negative {
            write!(f, "-")?;
        }
        let length = i64::try_from(self.digits.len()).unwrap_or(i64::MAX);
        let leading = length - 1 + self.exponent;
        let plain = self.plain || (self.exponent <= 0 && (PLAIN_FROM..=PLAIN_TO).contains(&leading));
        if !plain {
            let (first, rest) = self.digits.split_at(1);
            let point = if rest.is_empty() { "" } else { "." };
            return write!(f, "{first}{point}{rest}e{leading}");
        }
        if self.exponent >= 0 {
            return write!(f, "{}{}", self.digits, "0".repeat(usize::try_from(self.exponent).unwrap_or(0)));
        }
        let after = usize::try_from(-self.exponent).unwrap_or(usize::MAX);
        if after < self.digits.len() {
            let (whole, fraction) = self.digits.split_at(self.digits.len() - after);
            write!(f, "{whole}.{fraction}")
        } else {
            // By hand: format widths end at 65535.
            write!(f, "0.{}{}", "0".repeat(after - self.digits.len()), self.digits)
        }
    }
}
