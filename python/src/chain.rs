//! A chain and the answers about it.

use crate::number::Found;
use crate::refusal::{Refusal, detached, interruptible};
use carom::chain::best::Best;
use carom::chain::threshold::Helps;
use carom::chain::uncertain::meeting::Meeting;
use carom::chain::uncertain::{Range, RangeError};
use carom::chain::{ChainError, Positive, Restitution, Restitutions, transfer};
use carom::number::decimal::Digits;
use carom::number::rational::{self, NumeralError};
use carom::number::typed;
use carom::scene::answer::{Answers, Value};
use carom::scene::quantity::{Input, Quantity};
use carom::scene::read::ROUNDINGS;
use carom::scene::{Coefficients, Inputs, Inserted, Scene, Start};
use malachite::Rational;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyInt, PyString, PyType};

/// From so many digits on an answer takes long enough that somebody may want to end it.
const MANY_DIGITS: u64 = 100_000;

/// A chain of bodies, or as much of it as is known.
#[pyclass(frozen, module = "carom._engine")]
pub struct Chain {
    inputs: Inputs,
}

/// An answer as Python gets it.
#[derive(IntoPyObject)]
#[allow(clippy::large_enum_variant)] // made once, and handed over at once
pub enum Answer {
    /// A number.
    #[pyo3(transparent)]
    Number(Found),
    /// A number for each body or collision.
    #[pyo3(transparent)]
    List(Vec<Found>),
    /// A matrix for each collision.
    #[pyo3(transparent)]
    Matrices(Vec<Vec<Vec<Found>>>),
    /// In words.
    #[pyo3(transparent)]
    Words(String),
    /// In words for each inserted body.
    #[pyo3(transparent)]
    EachWords(Vec<String>),
    /// The least and the greatest best number, as hexadecimal digits or words, and whether one fewer does as well.
    #[pyo3(transparent)]
    Best((String, String, bool)),
}

fn numeral_fault(name: &str, error: &NumeralError) -> Refusal {
    let text = format!("{name}: {error}");
    match error {
        NumeralError::TooManyDigits { .. } | NumeralError::ExponentTooLarge { .. } => Refusal::Limit(text),
        _ => Refusal::Input(text),
    }
}

fn measured(name: &str, text: &str) -> Result<Range<Rational>, Refusal> {
    Range::read(text).map_err(|error| match error {
        RangeError::Numeral(error @ (NumeralError::TooManyDigits { .. } | NumeralError::ExponentTooLarge { .. })) => {
            numeral_fault(name, &error)
        }
        error => Refusal::at(name, error),
    })
}

fn mass(name: &str, text: &str) -> Result<Range<Positive>, Refusal> {
    measured(name, text)?.map(Positive::new).map_err(|error: ChainError| Refusal::at(name, error))
}

fn coefficient(text: &str) -> Result<Range<Restitution>, Refusal> {
    measured("e", text)?.map(Restitution::new).map_err(|error: ChainError| Refusal::at("e", error))
}

fn number(name: &str, text: &str) -> Result<Rational, Refusal> {
    typed::read(text).map_err(|error| numeral_fault(name, &error))
}

#[pymethods]
impl Chain {
    /// Reads a chain: the masses of the ends; one coefficient, or one for each collision; the number of inserted
    /// bodies of optimal mass, or their masses; the first body's speed, or all velocities. Coefficients and inserted
    /// bodies may be missing: some answers do not need them.
    #[new]
    fn new(
        py: Python<'_>,
        ends: (String, String),
        e: Option<(bool, Vec<String>)>,
        n: Option<u64>,
        masses: Option<Vec<String>>,
        speed: String,
        velocities: Option<Vec<String>>,
    ) -> Result<Chain, Refusal> {
        detached(py, || {
            let (first, last) = (mass("m1", &ends.0)?, mass("m2", &ends.1)?);
            let coefficients = e.map(|(common, list)| -> Result<Coefficients, Refusal> {
                match (common, list.first()) {
                    (true, Some(one)) => Ok(Coefficients::Same(coefficient(one)?)),
                    _ => Ok(Coefficients::Each(list.iter().map(|e| coefficient(e)).collect::<Result<_, _>>()?)),
                }
            });
            let coefficients = coefficients.transpose()?;
            let inserted = match masses {
                Some(list) => Some(Inserted::Given(list.iter().map(|m| mass("masses", m)).collect::<Result<_, _>>()?)),
                None => n.map(Inserted::Optimal),
            };
            let start = match velocities {
                Some(list) => {
                    Start::Velocities(list.iter().map(|v| number("velocities", v)).collect::<Result<_, _>>()?)
                }
                None => Start::Speed(number("speed", &speed)?),
            };
            Ok(Chain { inputs: Inputs::new(first, last, inserted, coefficients, start)? })
        })
    }

    /// How many bodies are inserted, where that is known.
    fn count(&self) -> Option<u64> {
        self.inputs.inserted().map(Inserted::count)
    }

    /// Whether nothing is measured.
    fn is_exact(&self) -> bool {
        self.inputs.is_exact()
    }

    /// The answer to one question, decimals with so many digits rounded in a direction.
    fn answer(&self, py: Python<'_>, quantity: &str, digits: u64, rounding: &str) -> PyResult<Answer> {
        let quantity = Quantity::of_name(quantity).map_err(Refusal::Input)?;
        if let Some(input) = self.inputs.missing(quantity) {
            let argument = match input {
                Input::Restitution => "e, the coefficient of restitution",
                Input::Inserted => "n, the number of inserted bodies (0 for none), or masses",
            };
            return Err(Refusal::Input(format!("{} needs {argument}", quantity.name())).into());
        }
        let direction = ROUNDINGS.iter().find(|(name, _)| *name == rounding).map(|(_, direction)| *direction);
        let rounding = direction.ok_or_else(|| {
            Refusal::Input(format!("rounding: {rounding:?} is unknown; write nearest, up, down, zero or away"))
        })?;
        let scene =
            Scene { want: vec![quantity], digits: Digits::Significant(digits), rounding, inputs: self.inputs.clone() };
        let work = move || {
            let mut answers = Answers::new(&scene);
            answers.get(quantity)?;
            answers.take(quantity).map(described).ok_or(Refusal::Failure)
        };
        if digits >= MANY_DIGITS { interruptible(py, work) } else { Ok(detached(py, work)?) }
    }
}

fn described(value: Value) -> Answer {
    match value {
        Value::Number(number) => Answer::Number(number.into()),
        Value::List(list) => Answer::List(list.into_iter().map(Found::from).collect()),
        Value::Matrices(list) => {
            let row = |row: [_; 2]| row.map(Found::from).into_iter().collect();
            Answer::Matrices(list.into_iter().map(|rows| rows.map(row).into_iter().collect()).collect())
        }
        Value::Helps(answer) => Answer::Words(answer.map_or("depends", Helps::text).to_owned()),
        Value::EachHelps(list) => {
            Answer::EachWords(list.iter().map(|answer| answer.map_or("depends", Helps::text).to_owned()).collect())
        }
        Value::Best(least, greatest) => {
            let tie = least == greatest && matches!(least, Best::Finite { tie: true, .. });
            Answer::Best((count(&least), count(&greatest), tie))
        }
        Value::Recollides(meeting) => Answer::Words(
            match meeting {
                Meeting::Always => "yes",
                Meeting::Never => "no",
                other => other.text(),
            }
            .to_owned(),
        ),
        // It cannot be asked for by name.
        Value::Prepared(_) => Answer::Words(String::new()),
    }
}

fn count(best: &Best) -> String {
    match best {
        Best::Finite { count, .. } => format!("{count:x}"),
        Best::Infinite => "infinite".to_owned(),
        Best::Any => "any".to_owned(),
    }
}

/// An eta that was found at once.
#[derive(IntoPyObject)]
#[allow(clippy::large_enum_variant)] // made once, and handed over at once
pub enum Quick {
    /// Numerator and denominator.
    #[pyo3(transparent)]
    Fraction((u64, u64)),
    /// Any other number.
    #[pyo3(transparent)]
    Number(Found),
}

/// eta of a chain of optimal masses, where all inputs are plain: integers, texts of numerals, fractions. `None` for
/// anything else, and for what is no chain: [`Chain`] judges it.
#[pyfunction]
pub fn eta(
    py: Python<'_>,
    m1: &Bound<'_, PyAny>,
    m2: &Bound<'_, PyAny>,
    e: &Bound<'_, PyAny>,
    n: &Bound<'_, PyAny>,
) -> Result<Option<Quick>, Refusal> {
    let count = || if n.is_exact_instance_of::<PyInt>() { n.extract::<u64>().ok() } else { None };
    let read = || Some((plain(m1)?, plain(m2)?, plain(e)?, count()?));
    let Some((m1, m2, e, n)) = read() else { return Ok(None) };
    detached(py, || Ok(quick_eta(m1, m2, e, n)))
}

fn quick_eta(m1: Rational, m2: Rational, e: Rational, n: u64) -> Option<Quick> {
    let ratio = Positive::new(m1).ok()?.over(&Positive::new(m2).ok()?);
    let real = transfer::optimal(&ratio, &Restitutions::Same(Restitution::new(e).ok()?), n).ok()?;
    if let Some(exact) = real.as_rational() {
        let parts = (u64::try_from(exact.numerator_ref()).ok()?, u64::try_from(exact.denominator_ref()).ok()?);
        return Some(Quick::Fraction(parts));
    }
    let ends = real.neighbours().ok()?;
    Some(Quick::Number(Found::of_real(real, ends)))
}

/// The number that a Python object of a plain type says exactly.
fn plain(x: &Bound<'_, PyAny>) -> Option<Rational> {
    static FRACTION: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    if x.is_exact_instance_of::<PyInt>() {
        return x.extract::<i64>().ok().map(Rational::from);
    }
    if let Ok(text) = x.cast_exact::<PyString>() {
        return rational::parse(&text.to_cow().ok()?).ok();
    }
    let py = x.py();
    if !x.get_type().is(FRACTION.import(py, "fractions", "Fraction").ok()?) {
        return None;
    }
    let part = |name| x.getattr(name).ok()?.extract::<i64>().ok();
    let (above, below) = (part(intern!(py, "numerator"))?, part(intern!(py, "denominator"))?);
    Some(Rational::from_signeds(above, below))
}
