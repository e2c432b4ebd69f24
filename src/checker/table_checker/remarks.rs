//! What the head of a table says in words: the formula, its number, the digits and the rounding.

use super::cell::EXACT_LENGTH;
use super::failure::{Failure, rejected};
use super::rounding::{Digits, Rounding};
use super::text::{Head, Quantity};

/// The formula of a quantity with its number.
pub(super) fn formula(quantity: Quantity) -> (&'static str, &'static str) {
    match quantity {
        Quantity::Eta => ("eta = (1 + e)^(2(n + 1)) r/(1 + r^(1/(n + 1)))^(2(n + 1)), r = m1/m2 = ratio", "(25)"),
        Quantity::Threshold => ("L_n = (1 + r^(1/(n + 1)))^(n + 1)/(1 + r^(1/n))^n - 1, r = m1/m2 = ratio", "(19)"),
        Quantity::BestN => ("n* = number of n >= 1 with L_n <= e, r = m1/m2 = ratio", "claim b-best, from (19)"),
    }
}

/// Digits and rounding in words; none for numbers of bodies.
pub(super) fn rounding_in_words(head: &Head) -> Result<Option<String>, Failure> {
    let (digits, rounding) = match (head.quantity, head.digits, head.rounding) {
        (Quantity::BestN, None, None) => return Ok(None),
        (Quantity::Eta | Quantity::Threshold, Some(digits), Some(rounding)) => (digits, rounding),
        _ => return rejected("digits and a rounding belong to eta and L_n, and to them only"),
    };
    let count = match digits {
        Digits::Significant(1) => "1 significant digit".to_string(),
        Digits::Significant(count) => format!("{count} significant digits"),
        Digits::Places(1) => "1 place after the point".to_string(),
        Digits::Places(count) => format!("{count} places after the point"),
    };
    let rule = match rounding {
        Rounding::NearestEven => "to nearest, ties to even",
        Rounding::Up => "up",
        Rounding::Down => "down",
        Rounding::Zero => "towards zero",
        Rounding::Away => "away from zero",
    };
    Ok(Some(format!("{count}, {rule}")))
}

/// What the head has to say in words.
pub(super) fn remarks(head: &Head) -> Result<Vec<(&'static str, String)>, Failure> {
    let (formula, number) = formula(head.quantity);
    let equation = format!("{number} of Ricardo & Lee 2015, inserted bodies of optimal mass");
    let mut list = vec![("formula", formula.to_string()), ("equation", equation)];
    if let Some(words) = rounding_in_words(head)? {
        list.push(("rounding", format!("{words}; every digit is certified")));
        list.push(("exact", format!("p/q where the value is rational, up to {EXACT_LENGTH} characters")));
    }
    Ok(list)
}
