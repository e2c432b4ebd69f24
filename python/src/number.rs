//! Numbers on their way to Python.
//!
//! Contract: integers go as hexadecimal digits, which Python reads without a limit and in linear time; doubles are
//! rounded outwards from the enclosure that the exact ends describe.

use carom::claim::parse::parse_prop;
use carom::claim::print::Style;
use carom::claim::syntax::PropKind;
use carom::number::rational;
use carom::number::real::Real;
use carom::scene::answer::Number;
use malachite::Rational;
use pyo3::prelude::*;

/// The longest closed form that is written for LaTeX.
const MAX_TYPESET: usize = 200;

/// Numerator, with its sign, and denominator.
pub type Hex = (String, String);

/// A rational number for Python's `Fraction`.
pub fn hex(x: &Rational) -> Hex {
    let sign = if *x < 0u32 { "-" } else { "" };
    (format!("{sign}{:x}", x.numerator_ref()), format!("{:x}", x.denominator_ref()))
}

/// A number: exactly, in closed form, between bounds, as a decimal.
#[derive(IntoPyObject)]
pub struct Found {
    exact: Option<Hex>,
    radical: Option<String>,
    latex: Option<String>,
    /// The ends of the enclosure; `None` where they are too long to write.
    lower: Option<Hex>,
    upper: Option<Hex>,
    lo: f64,
    hi: f64,
    decimal: Option<String>,
}

impl Found {
    /// The number as Python gets it.
    pub fn of(number: &Number) -> Found {
        let ends = match &number.exact {
            Some(exact) => (Some(exact.clone()), Some(exact.clone())),
            None => (rational::parse(&number.enclosure.0).ok(), rational::parse(&number.enclosure.1).ok()),
        };
        let double = |end: &Option<Rational>, text: &str| match end {
            Some(x) => Real::rational(x.clone()).neighbours().unwrap_or((f64::NEG_INFINITY, f64::INFINITY)),
            None => beyond(text),
        };
        let (lo, hi) = (double(&ends.0, &number.enclosure.0).0, double(&ends.1, &number.enclosure.1).1);
        Found {
            exact: number.exact.as_ref().map(hex),
            radical: number.radical.clone(),
            latex: number.radical.as_deref().and_then(latex),
            lower: ends.0.as_ref().map(hex),
            upper: ends.1.as_ref().map(hex),
            lo,
            hi,
            decimal: number.decimal.clone(),
        }
    }
}

/// Doubles around a decimal whose exponent is beyond all that is read back, and so far beyond doubles.
fn beyond(text: &str) -> (f64, f64) {
    let (lo, hi) = if text.contains("e-") { (0.0, f64::from_bits(1)) } else { (f64::MAX, f64::INFINITY) };
    if text.starts_with('-') { (-hi, -lo) } else { (lo, hi) }
}

/// A closed form for LaTeX.
fn latex(radical: &str) -> Option<String> {
    if radical.len() > MAX_TYPESET {
        return None;
    }
    match parse_prop(&format!("0 = {radical}")).ok()?.kind {
        PropKind::Compare(sides, _) => sides.get(1).map(|side| Style::Latex.expr(side)),
        _ => None,
    }
}
