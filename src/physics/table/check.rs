//! Somebody's decimal beside the certified one.
//!
//! **Contract.** A written decimal is compared with the correctly rounded value *to as many places as are
//! written*, in the given direction of rounding: it is right, or right if rounded in another direction, or
//! wrong from a digit on. A written fraction must be the exact value. Where there is no value, nothing or `none` is right.

use super::grid::beyond_limits;
use super::{Place, Quantity, Value, count_text, rounded, value};
use crate::chain::ChainError;
use crate::chain::best::Best;
use crate::number::NumberError;
use crate::number::decimal::{Decimal, Digits, Rounding};
use crate::number::rational::{self, NumeralError};
use crate::number::real::Real;
use crate::number::typed::{self, Unclear};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Abs, Floor, Pow, UnsignedAbs};

/// What is to be said of a written number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Agreement {
    /// The correctly rounded value, or exactly the value.
    Right,
    /// Not the value rounded as asked, but the value rounded in this other direction.
    Rounded(Rounding),
    /// Wrong; the first wrong significant digit, from 1, where there is one to point at.
    Wrong(Option<u64>),
    /// Not a number.
    Unreadable(NumeralError),
}

impl Agreement {
    /// In words.
    #[must_use]
    pub fn text(&self) -> String {
        match self {
            Self::Right => "right".to_owned(),
            Self::Rounded(direction) => {
                format!("not rounded as requested: it is the value rounded {}", direction.rule())
            }
            Self::Wrong(Some(digit)) => format!("wrong from significant digit {digit} on"),
            Self::Wrong(None) => "wrong".to_owned(),
            Self::Unreadable(error) => format!("not a number: {error}"),
        }
    }
}

/// A written number beside the certified one.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// What is to be said of it.
    pub agreement: Agreement,
    /// The certified value, to as many places or exactly; `none` where there is none.
    pub certified: String,
    /// The tie in the certified value, in words, where it matters; else empty.
    pub tie: &'static str,
}

impl Judgement {
    fn new(agreement: Agreement, certified: String) -> Judgement {
        Judgement { agreement, certified, tie: "" }
    }

    /// In words.
    #[must_use]
    pub fn text(&self) -> String {
        self.agreement.text() + self.tie
    }
}

/// A written number judged beside a quantity at its place.
///
/// # Errors
/// As of [`value`]; a limit, also where the written number is too long to be read: it may be right.
pub fn judge(written: &str, quantity: Quantity, place: &Place, rounding: Rounding) -> Result<Judgement, ChainError> {
    // Without an inserted body there is none that could help.
    if quantity == Quantity::Threshold && place.n == Some(0) {
        let right = written.is_empty() || written.eq_ignore_ascii_case("none");
        let agreement = if right { Agreement::Right } else { Agreement::Wrong(None) };
        return Ok(Judgement::new(agreement, "none".to_owned()));
    }
    Ok(match value(quantity, place)? {
        Value::Count(best) => judge_count(written, &best)?,
        Value::Real(real) => judge_real(written, &real, rounding)?,
    })
}

fn judge_real(written: &str, value: &Real, rounding: Rounding) -> Result<Judgement, NumberError> {
    let plain = typed::number(written).map_err(|Unclear(what)| NumeralError::Unclear { what });
    let (number, written) = match plain.and_then(|plain| Ok((rational::parse(&plain)?, plain))) {
        Ok(read) => read,
        Err(error) => {
            if let Some(limit) = beyond_limits(&error) {
                return Err(limit);
            }
            let (decimal, _) = rounded(value, Digits::Significant(10), rounding)?;
            return Ok(Judgement::new(Agreement::Unreadable(error), decimal.to_string()));
        }
    };
    if written.contains('/') {
        let (right, shown) = match value.as_rational() {
            Some(exact) => (*exact == number, exact.to_string()),
            None => (false, rounded(value, Digits::Significant(10), rounding)?.0.to_string()),
        };
        return Ok(Judgement::new(if right { Agreement::Right } else { Agreement::Wrong(None) }, shown));
    }
    let places = places(&written);
    let to = |direction| Ok::<Decimal, NumberError>(rounded(value, Digits::Places(places), direction)?.0);
    let certified = to(rounding)?;
    let shown = certified.to_string();
    if certified.value() == number {
        return Ok(Judgement::new(Agreement::Right, shown));
    }
    for direction in Rounding::ALL {
        if direction != rounding && to(direction)?.value() == number {
            let middle = (to(Rounding::Up)?.value() + to(Rounding::Down)?.value()) / Rational::from(2);
            let tie = if value.as_rational() == Some(&middle) {
                "; a tie: the exact value lies midway between two"
            } else {
                ""
            };
            return Ok(Judgement { agreement: Agreement::Rounded(direction), certified: shown, tie });
        }
    }
    Ok(Judgement::new(Agreement::Wrong(first_difference(&number, &certified.value(), places)), shown))
}

/// A written number of bodies judged beside the certified one, which may be `infinite`.
fn judge_count(written: &str, best: &Best) -> Result<Judgement, NumberError> {
    let certified = count_text(best).0;
    let agreement = |same| if same { Agreement::Right } else { Agreement::Wrong(None) };
    let agreement = match written.to_lowercase().as_str() {
        "infinite" | "infinity" | "inf" | "∞" => agreement(certified == "infinite"),
        other if other == certified => Agreement::Right,
        other => match typed::read(other) {
            Ok(number) => agreement(number.to_string() == certified),
            Err(error) => beyond_limits(&error).map_or(Ok(Agreement::Unreadable(error)), Err)?,
        },
    };
    let tie = if let Best::Finite { tie: true, .. } = best { TIE } else { "" };
    Ok(Judgement { agreement, certified, tie })
}

/// What is said of a best number beside which one body fewer is as good.
const TIE: &str = "; a tie: one body fewer than n* transfers exactly as much";

/// How many places after the point a decimal is written to; `2.50e-3` has five.
fn places(written: &str) -> u64 {
    let (mantissa, exponent) = written.split_once(['e', 'E']).unwrap_or((written, "0"));
    let fraction = mantissa.split_once('.').map_or(0, |(_, digits)| digits.len());
    let exponent: i64 = exponent.parse().unwrap_or(0);
    let fraction = i64::try_from(fraction).unwrap_or(i64::MAX);
    u64::try_from(fraction.saturating_sub(exponent)).unwrap_or(0)
}

/// The first significant digit, from 1, in which two decimals of so many places differ; `None` for different
/// signs.
fn first_difference(a: &Rational, b: &Rational, places: u64) -> Option<u64> {
    if (*a < 0u32) != (*b < 0u32) {
        return None;
    }
    let digits = |x: &Rational| (x.abs() * Rational::from(10).pow(places)).floor().unsigned_abs().to_string();
    let (a, b) = (digits(a), digits(b));
    let width = a.len().max(b.len());
    let filled = |digits: &str| "0".repeat(width - digits.len()) + digits;
    let (a, b) = (filled(&a), filled(&b));
    let place = a.bytes().zip(b.bytes()).position(|(x, y)| x != y)?;
    Some(place as u64 + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(written: &str, value: &str) -> String {
        let value = Real::rational(rational::parse(value).expect("a number"));
        judge_real(written, &value, Rounding::Nearest).expect("no limit").text()
    }

    #[test]
    fn right_to_as_many_places_as_are_written() {
        for written in ["0.4", "0.44", "0.444", "0.4444", "4.4e-1", "44e-2", "4/9", "8/18", "0", "+0.44"] {
            assert_eq!(said(written, "4/9"), "right", "{written}");
        }
        // A tie goes to the even digit, exactly.
        assert_eq!(said("0.2", "1/4"), "right");
        let tie =
            "not rounded as requested: it is the value rounded up; a tie: the exact value lies midway between two";
        assert_eq!(said("0.3", "1/4"), tie);
        assert_eq!(said("0.666", "2/3"), "not rounded as requested: it is the value rounded down");
        assert_eq!(said("0.100", "0.09996"), "right");
        assert_eq!(said("0.0999", "0.09996"), "not rounded as requested: it is the value rounded down");
    }

    #[test]
    fn numbers_of_bodies_are_compared_as_numbers() {
        let best = |certified: &str| match certified {
            "infinite" => Best::Infinite,
            "any" => Best::Any,
            count => Best::Finite { count: count.parse::<u32>().expect("a number").into(), tie: false },
        };
        let said = |written: &str, certified: &str| judge_count(written, &best(certified)).map(|a| a.text());
        for (written, certified) in [("5", "5"), ("5.0", "5"), ("10/2", "5"), ("INF", "infinite"), ("any", "any")] {
            assert_eq!(said(written, certified), Ok("right".to_owned()), "{written}");
        }
        for (written, certified) in [("6", "5"), ("inf", "5"), ("5", "any"), ("4.9", "5")] {
            assert_eq!(said(written, certified), Ok("wrong".to_owned()), "{written}");
        }
        for written in ["80 %%", "1,000", "many", "any"] {
            assert!(said(written, "5").is_ok_and(|text| text.starts_with("not a number")), "{written}");
        }
        // It may be right: it is not read.
        for written in [format!("5.{}", "0".repeat(10_001)), format!("{}5", "0".repeat(10_001))] {
            assert!(said(&written, "5").is_err(), "{} characters", written.len());
        }
    }

    #[test]
    fn the_first_wrong_digit_is_found() {
        assert_eq!(said("0.4454", "4/9"), "wrong from significant digit 3 on");
        assert_eq!(said("0.5", "4/9"), "not rounded as requested: it is the value rounded up");
        assert_eq!(said("0.6", "4/9"), "wrong from significant digit 1 on");
        assert_eq!(said("0.00123", "0.00124"), "wrong from significant digit 3 on");
        assert_eq!(said("1.23e-3", "0.00124"), "wrong from significant digit 3 on");
        assert_eq!(said("4", "4/9"), "wrong from significant digit 1 on");
        assert_eq!(said("-0.44", "4/9"), "wrong");
        assert_eq!(said("4/8", "4/9"), "wrong");
        assert_eq!(said(".4444", "4/9"), "right");
        assert_eq!(said("-.44", "4/9"), "wrong");
        let beyond = |text: &str| judge_real(text, &Real::rational(Rational::from(1)), Rounding::Nearest).is_err();
        assert!(beyond("1e99999") && beyond(&format!("0.{}", "3".repeat(20_000))));
        assert_eq!([said("0,44", "4/9"), said("44 %", "4/9")], ["right", "right"]);
        assert!(said("4,444", "4444").starts_with("not a number"));
        assert!(said("", "4/9").starts_with("not a number"));
    }
}
