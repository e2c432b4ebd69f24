//! Which typed numbers answer a cell or a question of a sheet.
//!
//! Contract: an exact value is right as itself, however it is spelled. A value that the wanted digits do not show in full is also
//! right as its decimal of that many digits. In the middle of two, either of them is. Calculators show more digits: up to
//! [`MOST`] of them are right, rounded up or down in the last one. No other number is right. An answer with an
//! uncertainty has no [`Expected`]: people may round it in several ways.
//!
//! [`Expected::digests`] is what a page holds of it: salted SHA-256, so that nobody reads the answers in the source at a glance.
//! There are few short numbers, so a program that tries them all does find them.

use crate::certificate::text::digest;
use crate::number::decimal::{Decimal, Digits, Rounding, bits_of_digits};
use crate::number::rational::parse;
use crate::table::worksheet::Entry;
use malachite::Rational;

/// The digits of the longest decimals that are right: those of calculators. Where a sheet asks for more, its own alone.
pub const MOST: u64 = 16;

/// The numbers that answer a question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expected(Vec<Rational>);

impl Expected {
    /// The answers that fit an entry, whose decimal on the key is `printed`.
    pub(super) fn of(entry: &Entry, printed: &str, digits: Digits) -> Option<Expected> {
        let Entry::Number(x) = entry else { return None };
        let more = (digits.count() + 1..=MOST).map(|count| match digits {
            Digits::Significant(_) => Digits::Significant(count),
            Digits::Places(_) => Digits::Places(count),
        });
        let ways = [Rounding::Down, Rounding::Up];
        let mut right = match x.as_rational() {
            Some(x) => {
                let decimal =
                    |digits, rounding| parse(&Decimal::of_rational(x, digits, rounding).ok()?.to_string()).ok();
                let mut right = vec![x.clone()];
                right.extend(nearest(x, decimal(digits, Rounding::Down)?, decimal(digits, Rounding::Up)?));
                right.extend(more.flat_map(|digits| ways.map(|way| decimal(digits, way))).flatten());
                right
            }
            None => {
                // One narrow enclosure: what it leaves open is not among the answers.
                let narrow = x.enclosure(bits_of_digits(digits.count().max(MOST)) + 128);
                let decimal =
                    |digits, rounding| parse(&Decimal::of_interval(&narrow, digits, rounding)?.to_string()).ok();
                let mut right = vec![parse(printed).ok()?];
                right.extend(more.flat_map(|digits| ways.map(|way| decimal(digits, way))).flatten());
                right
            }
        };
        right.sort();
        right.dedup();
        Some(Expected(right))
    }

    /// Whether a typed number is right.
    #[must_use]
    pub fn accepts(&self, typed: &Rational) -> bool {
        self.0.contains(typed)
    }

    /// The digests of all right answers as reduced fractions, salted with the field's name.
    #[must_use]
    pub fn digests(&self, salt: &str) -> Vec<String> {
        let sign = |x: &Rational| if *x < 0u32 { "-" } else { "" };
        let normal = |x: &Rational| format!("{}{}/{}", sign(x), x.numerator_ref(), x.denominator_ref());
        let mut found: Vec<String> = self.0.iter().map(|x| salted(salt, &normal(x))).collect();
        // Their order would tell which one is which.
        found.sort();
        found
    }
}

/// The first 20 hexadecimal digits of the SHA-256 of a salt, a blank and a text.
pub(super) fn salted(salt: &str, text: &str) -> String {
    let mut found = digest(&format!("{salt} {text}"));
    found.truncate(20);
    found
}

/// The nearer one of the decimals below and above a number, or both where it lies in their middle.
fn nearest(x: &Rational, down: Rational, up: Rational) -> Vec<Rational> {
    match (x - &down).cmp(&(&up - x)) {
        std::cmp::Ordering::Less => vec![down],
        std::cmp::Ordering::Greater => vec![up],
        std::cmp::Ordering::Equal => vec![down, up],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::typed::read;

    fn accepted(value: &str, digits: Digits, typed: &str) -> bool {
        let entry = Entry::exact(&parse(value).expect("a number"));
        Expected::of(&entry, value, digits).expect("it is exact").accepts(&read(typed).expect("a number"))
    }

    #[test]
    fn an_answer_is_judged_by_its_value_and_by_the_digits_that_are_asked() {
        let four = Digits::Significant(4);
        for (value, right, wrong) in [
            // Shown in full by four digits: this number and no other.
            ("9/10", vec!["0,9", "90 %", ".9", "9/10", "0.9000", "9*10^-1"], vec!["0.90001", "-0.9", "9"]),
            // One third: itself, or a decimal of four digits or more.
            (
                "1/3",
                vec!["1/3", "0.3333", "0.33333", "0.33334", "33.33 %", "0.3333333333333333"],
                vec!["0.333", "0.3334", "0.33325", "0.33335", "0.33", "-1/3"],
            ),
            // In the middle of two decimals: both.
            ("6172.5", vec!["6172", "6173", "6172.5"], vec!["6171", "6170"]),
            ("-2/3", vec!["-0.6667", "−2/3"], vec!["0.6667", "-0.6666"]),
            ("0", vec!["0", "-0", "0,00"], vec!["0.0001", "1e-40"]),
            ("22500", vec!["22500", "2.25*10^4", "2.250·10⁴"], vec!["2250", "22501"]),
            // 9999.7 is rounded up to a number with a digit more.
            ("99997/10", vec!["10000", "1e4", "9999.7"], vec!["9999", "10001"]),
        ] {
            right.iter().for_each(|typed| assert!(accepted(value, four, typed), "{value}: {typed}"));
            wrong.iter().for_each(|typed| assert!(!accepted(value, four, typed), "{value}: {typed}"));
        }
        let places = Digits::Places(2);
        assert!(accepted("2/3", places, "0.67") && accepted("2/3", places, "0.667"));
        assert!(!accepted("2/3", places, "0.66") && !accepted("2/3", places, "0.668"));
    }

    #[test]
    fn digests_differ_from_field_to_field() {
        let entry = Entry::exact(&parse("1/3").expect("a number"));
        let expected = Expected::of(&entry, "0.3333", Digits::Significant(4)).expect("it is exact");
        assert_ne!(expected.digests("a"), expected.digests("b"));
        assert!(
            expected.digests("a").contains(&digest("a 1/3")[..20].to_owned()),
            "the form that the page's script uses"
        );
    }
}
