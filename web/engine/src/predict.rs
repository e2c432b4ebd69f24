//! A guess, marked exactly.
//!
//! Contract: a guess is *exact* where it is the answer, *rounded* where it is the answer rounded to as many places as
//! were typed, else *off*, with the side and the distance in per cent of the answer. The side and the two other marks are
//! decided by exact comparison; the distance is for the eye.

use crate::request::{Fault, Request, numeral};
use carom_exact::number::decimal::{Decimal, Digits, Rounding};
use carom_exact::number::rational;
use carom_physics::chain::best::Best;
use carom_physics::scene::Scene;
use carom_physics::scene::answer::{Answers, Number, Value as Answer};
use carom_physics::scene::quantity::Quantity;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Abs;
use malachite::base::num::basic::traits::Zero;
use serde_json::{Value, json};
use std::cmp::Ordering;

/// Digits of an irrational answer that a guess is compared with.
const DIGITS: u64 = 60;

/// Marks a guess: `{quantity, guess}` and the chain.
pub fn mark(request: &Request) -> Result<Value, Fault> {
    let quantity = match request.text("quantity")? {
        "" | "eta" => Quantity::Eta,
        "last-velocity" => Quantity::LastVelocity,
        "best-n" => Quantity::BestN,
        other => return Err(Fault::at("quantity", format!("there is no prediction of {other:?}"))),
    };
    let typed = request.number("guess")?;
    let guess = rational::parse(&typed).map_err(|error| {
        let message = if typed.is_empty() { "type your prediction".to_owned() } else { numeral(&typed, &error) };
        Fault::at("guess", message)
    })?;
    let digits = Digits::Significant(DIGITS);
    let scene = Scene { want: vec![quantity], digits, rounding: Rounding::Nearest, inputs: request.chain()?.into() };
    let answers = Answers::new(&scene);
    let (answer, _) = answers.get(quantity).map_err(|error| Fault::chain(None, &error))?;
    match answer {
        Answer::Number(number) => against(&guess, &typed, number),
        Answer::Best(Best::Finite { count, .. }, Best::Finite { count: most, .. }) if count == most => {
            Ok(compared(&guess, &Rational::from(count), None))
        }
        Answer::Best(Best::Infinite, _) => Ok(json!({ "mark": "off", "side": "small", "off": null })),
        Answer::Best(Best::Any, _) => Ok(json!({ "mark": "exact", "side": null, "off": null })),
        _ => Err(Fault::new("the answer depends on the measured inputs: type single numbers")),
    }
}

fn against(guess: &Rational, typed: &str, number: &Number) -> Result<Value, Fault> {
    let end = |text: &str| rational::parse(text).map_err(|_| Fault::new("the answer has no decimal"));
    if let Some(exact) = &number.exact {
        return Ok(compared(guess, exact, places(typed)));
    }
    if number.decimal.is_none() {
        return Err(Fault::new("the answer depends on the measured inputs: type single numbers"));
    }
    let (lo, hi) = (end(&number.enclosure.0)?, end(&number.enclosure.1)?);
    // A guess between ends that agree in 60 digits is the answer as far as anybody can type it.
    let nearest = if *guess < lo {
        lo
    } else if *guess > hi {
        hi
    } else {
        guess.clone()
    };
    let marked = compared(guess, &nearest, places(typed));
    Ok(if marked["mark"] == "exact" { json!({ "mark": "rounded", "side": null, "off": null }) } else { marked })
}

fn compared(guess: &Rational, answer: &Rational, places: Option<u64>) -> Value {
    let side = match guess.cmp(answer) {
        Ordering::Equal => return json!({ "mark": "exact", "side": null, "off": null }),
        Ordering::Less => "small",
        Ordering::Greater => "large",
    };
    let rounded = places.is_some_and(|places| {
        Decimal::of_rational(answer, Digits::Places(places), Rounding::Nearest).is_ok_and(|d| d.value() == *guess)
    });
    if rounded && *guess != Rational::ZERO {
        return json!({ "mark": "rounded", "side": null, "off": null });
    }
    let off = (*answer != Rational::ZERO).then(|| (guess - answer).abs() / answer.abs() * Rational::from(100));
    // No powers of ten: 368 % off, not 3.7e2 %.
    let digits = |x: &Rational| if *x >= 10 { Digits::Places(0) } else { Digits::Significant(2) };
    let off = off.and_then(|x| Decimal::of_rational(&x, digits(&x), Rounding::Nearest).ok());
    json!({ "mark": "off", "side": side, "off": off.map(|d| d.to_string()) })
}

/// The places after the point that were typed; `None` where the guess is no decimal.
fn places(typed: &str) -> Option<u64> {
    let (_, places) = typed.split_once('.')?;
    places.bytes().all(|b| b.is_ascii_digit()).then_some(places.len() as u64)
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    fn mark(quantity: &str, guess: &str, m1: &str, e: &str, n: &str) -> Value {
        let request = json!({"m1": m1, "m2": "1", "e": e, "n": n, "quantity": quantity, "guess": guess});
        serde_json::from_str(&crate::predict(&request.to_string())).expect("JSON")
    }

    #[test]
    fn marks_are_exact() {
        // eta = 15625000000/282429536481 = 0.0553235…
        for (guess, expected) in [
            ("15625000000/282429536481", "exact"),
            ("0.055", "rounded"),
            ("0,0553", "rounded"),
            ("0.056", "off"),
            ("5.53 %", "rounded"),
            ("5,5 %", "rounded"),
            ("5.54 %", "off"),
            ("0.0", "off"),
        ] {
            assert_eq!(mark("eta", guess, "64", "44/81", "2")["mark"], expected, "{guess}");
        }
        let irrational = mark("eta", "0.373137511773739", "10", "9/10", "7");
        assert_eq!(irrational["mark"], "rounded");
        let low = mark("eta", "0.3", "10", "9/10", "7");
        assert_eq!((&low["mark"], &low["side"], &low["off"]), (&json!("off"), &json!("small"), &json!("20")));
        assert_eq!(mark("eta", "-1", "10", "9/10", "7")["off"], json!("368"));
        assert_eq!(mark("best-n", "3", "10", "9/10", "7")["mark"], "exact");
        assert_eq!(mark("best-n", "4", "10", "9/10", "7")["side"], "large");
        assert_eq!(mark("best-n", "1000", "10", "1", "7")["side"], "small");
        assert_eq!(mark("last-velocity", "1", "1", "1", "3")["mark"], "exact");
    }

    #[test]
    fn what_is_no_number_is_a_fault_of_the_guess() {
        assert_eq!(mark("eta", "a half", "10", "1", "1")["error"]["field"], "guess");
        assert_eq!(mark("eta", "", "10", "1", "1")["error"]["field"], "guess");
    }
}
