//! Requests of the page: fields as they were typed, and faults that name their field.

use carom_exact::number::NumberError;
use carom_exact::number::rational::NumeralError;
use carom_exact::number::typed::{self, Unclear};
use carom_physics::chain::uncertain::{Range, RangeError};
use carom_physics::chain::{ChainError, Positive, Restitution};
use carom_physics::scene::{Chain, Coefficients, Inserted, Start};
use malachite::Rational;
use serde_json::{Map, Value, json};

/// The longest text of a field other than a claim's.
const MAX_FIELD: usize = 20_000;
/// The most digits that the page asks for.
pub const MAX_DIGITS: u64 = 5_000;

/// What is wrong with a request.
#[derive(Debug)]
pub struct Fault {
    /// The field, where it is one field's fault.
    pub field: Option<&'static str>,
    /// What is wrong.
    pub message: String,
    /// What would be right.
    pub help: Option<String>,
    /// Whether a stated limit was reached.
    pub limit: bool,
}

impl Fault {
    /// A fault of no field in particular.
    pub fn new(message: impl Into<String>) -> Fault {
        Fault { field: None, message: message.into(), help: None, limit: false }
    }

    /// A fault of a field.
    pub fn at(field: &'static str, message: impl Into<String>) -> Fault {
        Fault { field: Some(field), ..Fault::new(message) }
    }

    /// With a hint.
    pub fn help(self, help: impl Into<String>) -> Fault {
        Fault { help: Some(help.into()), ..self }
    }

    /// A stated limit.
    pub fn limit(self) -> Fault {
        Fault { limit: true, ..self }
    }

    /// A text with more than one reading.
    pub fn unclear(field: &'static str, Unclear(message): Unclear) -> Fault {
        Fault::at(field, message)
    }

    /// A fault of the engine's.
    pub fn chain(field: Option<&'static str>, error: &ChainError) -> Fault {
        let limit = matches!(error, ChainError::Number(NumberError::LimitReached { .. }));
        let message = match error {
            // Named by their cards on the page.
            ChainError::UnequalRestitutions { .. } => {
                "defined only where all collisions have one coefficient of restitution".to_owned()
            }
            error => error.to_string(),
        };
        Fault { field, message, help: None, limit }
    }

    /// As the page reads it.
    pub fn to_json(&self) -> Value {
        json!({ "field": self.field, "message": self.message, "help": self.help, "limit": self.limit })
    }
}

/// A request.
pub struct Request(Value);

impl Request {
    /// Reads a JSON object.
    pub fn read(text: &str) -> Result<Request, Fault> {
        match serde_json::from_str(text) {
            Ok(Value::Object(map)) => Ok(Request(Value::Object(map))),
            _ => Err(Fault::new("a request is a JSON object")),
        }
    }

    /// A field's text without blanks at its ends; empty where it is missing.
    pub fn text(&self, field: &'static str) -> Result<&str, Fault> {
        let text = self.long_text(field).trim();
        if text.len() > MAX_FIELD {
            return Err(Fault::at(field, format!("limit reached: {MAX_FIELD} characters in a field")).limit());
        }
        Ok(text)
    }

    /// A field's text as it stands, however long.
    pub fn long_text(&self, field: &'static str) -> &str {
        self.0.get(field).and_then(Value::as_str).unwrap_or("")
    }

    /// A natural number, perhaps with blanks between groups of digits.
    pub fn natural(&self, field: &'static str) -> Result<u64, Fault> {
        let text = self.text(field)?;
        let plain = typed::number(text).map_err(|unclear| Fault::unclear(field, unclear))?;
        if plain.is_empty() || !plain.bytes().all(|b| b.is_ascii_digit()) {
            let found = if text.is_empty() { "nothing".to_owned() } else { shown(text) };
            return Err(Fault::at(field, format!("expected a whole number such as 3, found {found}")));
        }
        plain.parse().map_err(|_| {
            Fault::at(field, format!("limit reached: {} at most", carom_physics::chain::MAX_INSERTED)).limit()
        })
    }

    /// A number of digits that the page is willing to show.
    pub fn digits(&self, field: &'static str) -> Result<u64, Fault> {
        match self.natural(field)? {
            0 => Err(Fault::at(field, "at least one digit is needed")),
            digits if digits > MAX_DIGITS => {
                let help = "the command line prints up to ten million";
                Err(Fault::at(field, format!("limit reached: {MAX_DIGITS} digits on this page")).limit().help(help))
            }
            digits => Ok(digits),
        }
    }

    /// The chain of the fields `m1`, `m2` and `e`, with `n` inserted bodies of optimal mass, or, where `inserted` is
    /// `given`, with those of `masses`; the first body moves with velocity 1, or each with its own of `velocities`.
    pub fn chain(&self) -> Result<Chain, Fault> {
        let first = mass("m1", &self.number("m1")?)?;
        let last = mass("m2", &self.number("m2")?)?;
        let coefficients = self.coefficients()?;
        let inserted = match self.text("inserted")? {
            "given" => {
                let list = self.masses()?;
                Inserted::Given(list.iter().map(|m| mass("masses", m)).collect::<Result<_, _>>()?)
            }
            _ => Inserted::Optimal(self.natural("n")?),
        };
        let start = match self.velocities()?.as_slice() {
            [] => Start::unit(),
            list => Start::Velocities(list.iter().map(|v| velocity(v)).collect::<Result<_, _>>()?),
        };
        Chain::new(first, last, inserted, coefficients, start).map_err(|error| {
            let field = match &error {
                ChainError::Count { of: "coefficients of restitution", .. } => "e",
                ChainError::Count { of: "velocities", .. } | ChainError::NeedsGivenMasses => "velocities",
                _ => "n",
            };
            Fault::chain(Some(field), &error)
        })
    }

    /// The masses of a list, at least two.
    pub fn bodies(&self, field: &'static str) -> Result<Vec<Range<Positive>>, Fault> {
        let list = self.list(field, |m| mass(field, m).is_ok())?;
        if list.len() < 2 {
            return Err(Fault::at(field, "at least two masses are needed, as in 2, 1"));
        }
        list.iter().map(|m| mass(field, m)).collect()
    }

    /// The coefficients of restitution of the field `e`: one for all collisions, or a list.
    pub fn coefficients(&self) -> Result<Coefficients, Fault> {
        Ok(match self.restitutions()?.as_slice() {
            [one] => Coefficients::Same(coefficient("e", one)?),
            list => Coefficients::Each(list.iter().map(|e| coefficient("e", e)).collect::<Result<_, _>>()?),
        })
    }

    /// One coefficient of restitution.
    pub fn coefficient(&self, field: &'static str) -> Result<Range<Restitution>, Fault> {
        coefficient(field, &self.number(field)?)
    }

    /// A height; `None` where the field is empty.
    pub fn length(&self, field: &'static str) -> Result<Option<Range<Positive>>, Fault> {
        let text = self.number(field)?;
        if text.is_empty() { Ok(None) } else { mass(field, &text).map(Some) }
    }

    /// A single number of either sign.
    pub fn single(&self, field: &'static str) -> Result<Rational, Fault> {
        let found = range(field, &self.number(field)?)?;
        found.single().cloned().ok_or_else(|| Fault::at(field, "a single number is needed, such as 1 or 3/4"))
    }

    /// A distance; `None` where the field is empty.
    pub fn distance(&self, field: &'static str) -> Result<Option<Rational>, Fault> {
        let text = self.number(field)?;
        if text.is_empty() { Ok(None) } else { distance(field, &text).map(Some) }
    }

    /// Several distances; none where the field is empty.
    pub fn distances(&self, field: &'static str) -> Result<Vec<Rational>, Fault> {
        if self.text(field)?.is_empty() {
            return Ok(Vec::new());
        }
        let list = self.list(field, |text| distance(field, text).is_ok())?;
        list.iter().map(|text| distance(field, text)).collect()
    }

    /// The fields of the chain in the engine's own spelling, as the command line takes them.
    pub fn plain(&self) -> Result<Value, Fault> {
        let mut plain = Map::new();
        for field in ["m1", "m2"] {
            plain.insert(field.to_owned(), self.number(field)?.into());
        }
        plain.insert("e".to_owned(), self.restitutions()?.into());
        if self.text("inserted")? == "given" {
            plain.insert("masses".to_owned(), self.masses()?.into());
        } else {
            plain.insert("n".to_owned(), self.natural("n")?.to_string().into());
        }
        plain.insert("velocities".to_owned(), self.velocities()?.into());
        Ok(plain.into())
    }

    /// One number or measured value.
    pub fn number(&self, field: &'static str) -> Result<String, Fault> {
        typed::number(self.text(field)?).map_err(|unclear| Fault::unclear(field, unclear))
    }

    fn list(&self, field: &'static str, fits: impl Fn(&str) -> bool) -> Result<Vec<String>, Fault> {
        typed::list(self.text(field)?, fits).map_err(|unclear| Fault::unclear(field, unclear))
    }

    fn restitutions(&self) -> Result<Vec<String>, Fault> {
        self.list("e", |e| coefficient("e", e).is_ok())
    }

    fn masses(&self) -> Result<Vec<String>, Fault> {
        self.list("masses", |m| mass("masses", m).is_ok())
    }

    /// No velocities where the field is empty: the first body moves and all others rest.
    fn velocities(&self) -> Result<Vec<String>, Fault> {
        if self.text("velocities")?.is_empty() {
            return Ok(Vec::new());
        }
        self.list("velocities", |v| velocity(v).is_ok())
    }
}

/// A field's text in a message: not longer than a line.
fn shown(text: &str) -> String {
    const LONGEST: usize = 40;
    if text.chars().count() <= LONGEST {
        return format!("{text:?}");
    }
    format!("{:?}…", text.chars().take(LONGEST).collect::<String>())
}

/// What is wrong with a number, in words for who typed it.
pub fn numeral(text: &str, error: &NumeralError) -> String {
    match error {
        NumeralError::MissingDigits { .. } | NumeralError::Unexpected { .. } => {
            format!("expected a number, found {}", shown(text))
        }
        NumeralError::Uncertainty { .. } => format!("{}: write a measured value as 57.1 ± 0.1", shown(text)),
        NumeralError::Unclear { what } => what.clone(),
        NumeralError::ZeroDenominator { .. } => format!("{}: the denominator is 0", shown(text)),
        NumeralError::TooManyDigits { allowed, needed } => {
            format!("limit reached: a number has {allowed} digits at most, this one has {needed}")
        }
        NumeralError::ExponentTooLarge { allowed, .. } => {
            format!("limit reached: {}: an exponent of ten is {allowed} at most", shown(text))
        }
    }
}

fn distance(field: &'static str, text: &str) -> Result<Rational, Fault> {
    let found = range(field, text)?.single().filter(|x| **x >= 0u32).cloned();
    found.ok_or_else(|| Fault::at(field, "a distance is a single number, 0 or more"))
}

fn range(field: &'static str, text: &str) -> Result<Range<Rational>, Fault> {
    let help = "write 10, 9/10, 0.9, 90 % or 2.5e-3, or a measured value: 0.90 ± 0.02 or [0.88, 0.92]";
    if text.is_empty() {
        return Err(Fault::at(field, "a number is missing").help(help));
    }
    Range::read(text).map_err(|error| {
        let limit = matches!(
            error,
            RangeError::Numeral(NumeralError::TooManyDigits { .. } | NumeralError::ExponentTooLarge { .. })
        );
        let message = match &error {
            RangeError::Numeral(error) => numeral(text, error),
            error => format!("{}: {error}", shown(text)),
        };
        Fault { limit, ..Fault::at(field, message) }.help(help)
    })
}

/// A velocity: a single number, of either sign.
fn velocity(text: &str) -> Result<Rational, Fault> {
    let found = range("velocities", text)?;
    let measured = || Fault::at("velocities", "a velocity is a single number such as 1, 0 or -1/2");
    found.single().cloned().ok_or_else(measured)
}

fn mass(field: &'static str, text: &str) -> Result<Range<Positive>, Fault> {
    range(field, text)?.map(Positive::new).map_err(|error| Fault::chain(Some(field), &error))
}

fn coefficient(field: &'static str, text: &str) -> Result<Range<Restitution>, Fault> {
    range(field, text)?.map(Restitution::new).map_err(|error| Fault::chain(Some(field), &error))
}
