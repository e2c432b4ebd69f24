//! Numbers on their way to Python.
//!
//! Contract: integers go as hexadecimal digits, which Python reads without a limit and in linear time; doubles are
//! rounded outwards from the enclosure that the exact ends describe.

use crate::refusal::Refusal;
use carom::claim::parse::parse_prop;
use carom::claim::print::Style;
use carom::claim::syntax::{Expr, PropKind};
use carom::number::decimal::{Decimal, Digits, Rounding};
use carom::number::rational;
use carom::number::real::Real;
use carom::report::mathml;
use carom::scene::answer::Number;
use malachite::Rational;
use pyo3::prelude::*;
use std::sync::OnceLock;

/// The longest closed form that is typeset.
const MAX_TYPESET: usize = 200;

/// Numerator, with its sign, and denominator.
pub type Hex = (String, String);

/// A rational number for Python's `Fraction`.
pub fn hex(x: &Rational) -> Hex {
    let sign = if *x < 0u32 { "-" } else { "" };
    (format!("{sign}{:x}", x.numerator_ref()), format!("{:x}", x.denominator_ref()))
}

/// Digits of an enclosure's decimal where it is computed alone; the enclosure has three more.
const DIGITS: u64 = 20;

/// A number: exactly, in closed form, between bounds, as a decimal. What is asked for is made when it is asked for.
#[pyclass(frozen, module = "carom._engine")]
pub struct Found {
    source: Source,
    number: OnceLock<Number>,
    ends: OnceLock<(f64, f64)>,
}

/// Where the number comes from.
enum Source {
    /// An answer, with its decimals.
    Answer,
    /// A real that is no short rational.
    Real(Real),
}

impl From<Number> for Found {
    fn from(number: Number) -> Found {
        Found { source: Source::Answer, number: OnceLock::from(number), ends: OnceLock::new() }
    }
}

impl Found {
    /// A real that is no short rational, with the doubles around it.
    pub fn of_real(real: Real, ends: (f64, f64)) -> Found {
        Found { source: Source::Real(real), number: OnceLock::new(), ends: OnceLock::from(ends) }
    }

    /// The number with its decimals.
    fn number(&self) -> Result<&Number, Refusal> {
        if let Some(number) = self.number.get() {
            return Ok(number);
        }
        let Source::Real(real) = &self.source else { return Err(Refusal::Failure) };
        let (found, _) = Decimal::with_enclosure(real, Digits::Significant(DIGITS), Rounding::Nearest)?;
        let number = Number {
            exact: None,
            radical: real.radical().map(str::to_owned),
            enclosure: (found.lower.to_string(), found.upper.to_string()),
            decimal: Some(found.decimal.to_string()),
        };
        Ok(self.number.get_or_init(|| number))
    }

    /// The ends of the enclosure; `None` where they are too long to write. They are not beyond the doubles that were found
    /// first: those are rounded outwards from them.
    fn exact_ends(&self) -> Result<[Option<Rational>; 2], Refusal> {
        let number = self.number()?;
        if let Some(exact) = &number.exact {
            return Ok([Some(exact.clone()), Some(exact.clone())]);
        }
        let [lower, upper] = [&number.enclosure.0, &number.enclosure.1].map(|text| rational::parse(text).ok());
        let Source::Real(_) = &self.source else { return Ok([lower, upper]) };
        let double = |x: f64| Rational::try_from(x).ok();
        let (lo, hi) = self.ends()?;
        Ok([
            lower.map(|x| double(lo).map_or(x.clone(), |lo| x.max(lo))),
            upper.map(|x| double(hi).map_or(x.clone(), |hi| x.min(hi))),
        ])
    }

    /// Doubles around the number.
    fn ends(&self) -> Result<(f64, f64), Refusal> {
        if let Some(ends) = self.ends.get() {
            return Ok(*ends);
        }
        let number = self.number()?;
        let ends = self.exact_ends()?;
        let double = |end: &Option<Rational>, text: &str| match end {
            Some(x) => Real::rational(x.clone()).neighbours().unwrap_or((f64::NEG_INFINITY, f64::INFINITY)),
            None => beyond(text),
        };
        let found = (double(&ends[0], &number.enclosure.0).0, double(&ends[1], &number.enclosure.1).1);
        Ok(*self.ends.get_or_init(|| found))
    }

    /// The closed form, where the number is irrational and one is known, read as an expression.
    fn formula<T>(&self, written: impl Fn(&Expr) -> T) -> Result<Option<T>, Refusal> {
        let Some(radical) = &self.number()?.radical else { return Ok(None) };
        if radical.len() > MAX_TYPESET {
            return Ok(None);
        }
        let Ok(relation) = parse_prop(&format!("0 = {radical}")) else { return Ok(None) };
        Ok(match relation.kind {
            PropKind::Compare(sides, _) => sides.get(1).map(written),
            _ => None,
        })
    }
}

#[pymethods]
impl Found {
    /// The number itself, where it is rational and short.
    #[getter]
    fn exact(&self) -> Result<Option<Hex>, Refusal> {
        Ok(self.number()?.exact.as_ref().map(hex))
    }

    /// The closed form in the claim language.
    #[getter]
    fn radical(&self) -> Result<Option<&str>, Refusal> {
        Ok(self.number()?.radical.as_deref())
    }

    /// The closed form for LaTeX.
    #[getter]
    fn latex(&self) -> Result<Option<String>, Refusal> {
        self.formula(|x| Style::Latex.expr(x))
    }

    /// The closed form as MathML.
    #[getter]
    fn mathml(&self) -> Result<Option<String>, Refusal> {
        self.formula(mathml::expression_within)
    }

    /// The lower end of the enclosure.
    #[getter]
    fn lower(&self) -> Result<Option<Hex>, Refusal> {
        Ok(self.exact_ends()?[0].as_ref().map(hex))
    }

    /// The upper end of the enclosure.
    #[getter]
    fn upper(&self) -> Result<Option<Hex>, Refusal> {
        Ok(self.exact_ends()?[1].as_ref().map(hex))
    }

    /// A double at most the number.
    #[getter]
    fn lo(&self) -> Result<f64, Refusal> {
        Ok(self.ends()?.0)
    }

    /// A double at least the number.
    #[getter]
    fn hi(&self) -> Result<f64, Refusal> {
        Ok(self.ends()?.1)
    }

    /// The decimal, where all values round to one.
    #[getter]
    fn decimal(&self) -> Result<Option<&str>, Refusal> {
        Ok(self.number()?.decimal.as_deref())
    }
}

/// Doubles around a decimal whose exponent is beyond all that is read back, and so far beyond doubles.
fn beyond(text: &str) -> (f64, f64) {
    let (lo, hi) = if text.contains("e-") { (0.0, f64::from_bits(1)) } else { (f64::MAX, f64::INFINITY) };
    if text.starts_with('-') { (-hi, -lo) } else { (lo, hi) }
}
