//! Requests of the page: fields as they were typed, and faults that name their field.

use carom::chain::uncertain::{Range, RangeError};
use carom::chain::{ChainError, Positive, Restitution};
use carom::number::NumberError;
use carom::number::rational::NumeralError;
use carom::scene::read::elements;
use carom::scene::{Chain, Coefficients, Inserted, Start};
use malachite::Rational;
use serde_json::{Value, json};

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

    /// A fault of the engine's.
    pub fn chain(field: Option<&'static str>, error: &ChainError) -> Fault {
        let limit = matches!(error, ChainError::Number(NumberError::LimitReached { .. }));
        Fault { field, message: error.to_string(), help: None, limit }
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

    /// A natural number.
    pub fn natural(&self, field: &'static str) -> Result<u64, Fault> {
        let text = self.text(field)?;
        if text.is_empty() || !text.bytes().all(|b| b.is_ascii_digit()) {
            let found = if text.is_empty() { "nothing".to_owned() } else { shown(text) };
            return Err(Fault::at(field, format!("a whole number such as 3 was expected, not {found}")));
        }
        text.parse()
            .map_err(|_| Fault::at(field, format!("limit reached: {} at most", carom::chain::MAX_INSERTED)).limit())
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
    /// `given`, with those of `masses`.
    pub fn chain(&self) -> Result<Chain, Fault> {
        let first = mass("m1", self.text("m1")?)?;
        let last = mass("m2", self.text("m2")?)?;
        let coefficients = match elements(self.text("e")?).as_slice() {
            [one] => Coefficients::Same(coefficient(one)?),
            list => Coefficients::Each(list.iter().map(|e| coefficient(e)).collect::<Result<_, _>>()?),
        };
        let inserted = match self.text("inserted")? {
            "given" => {
                let list = elements(self.text("masses")?);
                Inserted::Given(list.iter().map(|m| mass("masses", m)).collect::<Result<_, _>>()?)
            }
            _ => Inserted::Optimal(self.natural("n")?),
        };
        Chain::new(first, last, inserted, coefficients, Start::unit()).map_err(|error| {
            let field = match &error {
                ChainError::Count { of: "coefficients of restitution", .. } => "e",
                _ => "n",
            };
            Fault::chain(Some(field), &error)
        })
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

fn range(field: &'static str, text: &str) -> Result<Range<Rational>, Fault> {
    let help = "write 10, 9/10, 0.9 or 2.5e-3, or a measured value: 0.90 ± 0.02 or [0.88, 0.92]";
    if text.is_empty() {
        return Err(Fault::at(field, "a number is missing").help(help));
    }
    Range::read(text).map_err(|error| {
        let limit = matches!(
            error,
            RangeError::Numeral(NumeralError::TooManyDigits { .. } | NumeralError::ExponentTooLarge { .. })
        );
        Fault { limit, ..Fault::at(field, format!("{}: {error}", shown(text))) }.help(help)
    })
}

fn mass(field: &'static str, text: &str) -> Result<Range<Positive>, Fault> {
    range(field, text)?.map(Positive::new).map_err(|error| Fault::chain(Some(field), &error))
}

fn coefficient(text: &str) -> Result<Range<Restitution>, Fault> {
    range("e", text)?.map(Restitution::new).map_err(|error| Fault::chain(Some("e"), &error))
}
