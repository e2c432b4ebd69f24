//! Scene files: TOML with exact numbers.
//!
//! Numbers are integers or strings that [`crate::number::rational`] reads exactly; a mass or a coefficient may
//! also be measured, `"57.1 ± 0.1"`, `"57.1(1)"` or `"[0.84, 0.90]"`. A TOML float is refused, since it is not exact. Unknown
//! keys are refused with the nearest known one.

use super::drop::Drop;
use super::quantity::{Input, Quantity};
use super::{About, Coefficients, Inputs, Inserted, Scene, Start, keys};
use crate::chain::uncertain::{Range, RangeError};
use crate::chain::{ChainError, MAX_LISTED, Positive, Restitution};
use crate::number::decimal::{Digits, Rounding};
use crate::number::rational::NumeralError;
use crate::number::typed;
use carom_diagnostic::{Diagnostic, Fault, Span};
use malachite::Rational;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The most bytes of a scene file.
pub const MAX_BYTES: usize = 64 << 20;

/// Digits of a decimal where a scene does not say.
pub const DEFAULT_DIGITS: u64 = 15;

/// The JSON schema of scene files, for editors.
pub const SCHEMA: &str = include_str!("schema.json");

const SCENE_KEYS: [&str; 8] = ["title", "about", "units", "want", "digits", "places", "rounding", "chain"];
const DROP_SCENE_KEYS: [&str; 5] = ["title", "about", "units", "digits", "drop"];
const DROP_KEYS: [&str; 4] = ["masses", "floor", "restitution", "height"];
const UNIT_KEYS: [&str; 3] = ["mass", "velocity", "height"];
const CHAIN_KEYS: [&str; 6] = ["first", "last", "inserted", "restitution", "speed", "velocities"];

type Value<'a> = Spanned<DeValue<'a>>;

/// A fault of a scene, and whether it is a stated limit.
#[derive(Clone, Debug)]
pub struct SceneFault {
    /// What is wrong, and where.
    pub diagnostic: Diagnostic,
    /// Whether a limit was reached.
    pub limit: bool,
}

fn fault(span: std::ops::Range<usize>, message: impl Into<String>, help: Option<String>) -> SceneFault {
    let fault = Fault::Other { message: message.into(), help };
    SceneFault { diagnostic: Diagnostic::new(fault, Span { start: span.start, end: span.end }), limit: false }
}

fn of_chain(span: std::ops::Range<usize>, error: &ChainError) -> SceneFault {
    let mut fault = fault(span, error.to_string(), None);
    fault.limit = matches!(error, ChainError::Number(crate::number::NumberError::LimitReached { .. }));
    fault
}

fn of_range(span: std::ops::Range<usize>, error: &RangeError) -> SceneFault {
    let limit = matches!(
        error,
        RangeError::Numeral(NumeralError::TooManyDigits { .. } | NumeralError::ExponentTooLarge { .. })
    );
    let help = (!limit)
        .then(|| "write a number such as \"9/10\" or \"0.9\", or a measured one such as \"0.9 ± 0.01\"".to_owned());
    SceneFault { limit, ..fault(span, error.to_string(), help) }
}

/// What a scene file is of.
#[derive(Clone, Debug)]
pub enum Subject {
    /// A chain.
    Chain(Scene),
    /// Balls that are dropped together, and the digits of each answer.
    Drop(Drop, u64),
}

/// Reads a scene with what it says of itself.
///
/// # Errors
/// The first fault, with its place.
pub fn described(text: &str) -> Result<(About, Subject), SceneFault> {
    let document = document(text)?;
    let table = document.get_ref();
    let about = about(table)?;
    match find(table, "drop") {
        None => Ok((about, Subject::Chain(chain_scene(table)?))),
        Some(value) => {
            known_keys(table, &DROP_SCENE_KEYS, "a scene with [drop]")?;
            let digits = find(table, "digits").map_or(Ok(DEFAULT_DIGITS), |value| match natural(value, "digits")? {
                0 => Err(fault(value.span(), "digits must be at least 1, not 0", None)),
                count => Ok(count),
            })?;
            Ok((about, Subject::Drop(dropped(value)?, digits)))
        }
    }
}

/// Whether a text can be a unit: short, and without digits.
#[must_use]
pub fn is_unit(text: &str) -> bool {
    text.chars().count() <= MAX_UNIT && !text.chars().any(|c| c.is_control() || c.is_ascii_digit())
}

/// Title, text and units.
fn about(table: &DeTable<'_>) -> Result<About, SceneFault> {
    let text = |table: &DeTable<'_>, key: &str| -> Result<Option<String>, SceneFault> {
        let Some(value) = find(table, key) else { return Ok(None) };
        let Some(text) = value.get_ref().as_str() else {
            return Err(fault(value.span(), format!("{key} must be a string"), Some(format!("write {key} = \"…\""))));
        };
        Ok(Some(text.trim().to_owned()).filter(|text| !text.is_empty()))
    };
    let mut about = About { title: text(table, "title")?, text: text(table, "about")?, ..About::default() };
    let Some(value) = find(table, "units") else { return Ok(about) };
    let Some(units) = value.get_ref().as_table() else {
        let help = "write units = { mass = \"g\", velocity = \"m/s\" }".to_owned();
        return Err(fault(value.span(), "units must be a table", Some(help)));
    };
    known_keys(units, &UNIT_KEYS, "units")?;
    for (key, place) in [("mass", &mut about.mass), ("velocity", &mut about.velocity), ("height", &mut about.height)] {
        *place = text(units, key)?;
        if let (Some(unit), Some(value)) = (place.as_deref(), find(units, key))
            && !is_unit(unit)
        {
            let message = format!("{unit:?} is not a unit");
            return Err(fault(value.span(), message, Some("write a unit such as kg, g, m/s or cm".to_owned())));
        }
    }
    Ok(about)
}

/// The most characters of a unit.
const MAX_UNIT: usize = 12;

/// The balls of a table `[drop]`.
fn dropped(value: &Value<'_>) -> Result<Drop, SceneFault> {
    let Some(table) = value.get_ref().as_table() else {
        let help = "write [drop] on a line of its own".to_owned();
        return Err(fault(value.span(), "drop must be a table", Some(help)));
    };
    known_keys(table, &DROP_KEYS, "[drop]")?;
    let needed = |key: &'static str, example: &str| {
        find(table, key)
            .ok_or_else(|| fault(value.span(), format!("[drop] has no {key}"), Some(format!("add {key} = {example}"))))
    };
    let masses = needed("masses", "[\"620\", \"57.7\"], from the lowest ball to the highest")?;
    let restitution = needed("restitution", "\"0.8\", or a list with one for each pair of neighbours")?;
    let floor = find(table, "floor").map_or_else(
        || Restitution::new(Rational::from(1)).map(Range::point).map_err(|e| of_chain(value.span(), &e)),
        coefficient,
    )?;
    let height = find(table, "height").map(mass).transpose()?;
    let list = list(masses, "masses", mass)?;
    Drop::new(list, coefficients(restitution)?, floor, height).map_err(|error| {
        let place = if let ChainError::Count { of: "masses", .. } = error { masses } else { restitution };
        of_chain(place.span(), &error)
    })
}

fn coefficients(value: &Value<'_>) -> Result<Coefficients, SceneFault> {
    if value.get_ref().is_array() {
        return Ok(Coefficients::Each(list(value, "restitution", coefficient)?));
    }
    Ok(Coefficients::Same(coefficient(value)?))
}

fn document(text: &str) -> Result<Spanned<DeTable<'_>>, SceneFault> {
    if text.len() > MAX_BYTES {
        let message = format!("limit reached: at most {MAX_BYTES} bytes in a scene file");
        return Err(SceneFault { limit: true, ..fault(0..0, message, None) });
    }
    DeTable::parse(text).map_err(|e| {
        fault(e.span().unwrap_or(0..0), format!("not TOML: {}", e.message().trim()), Some(TOML.to_owned()))
    })
}

/// What to write instead of what is no TOML.
pub(super) const TOML: &str = "a scene is a TOML file; `carom help scene` shows one";

/// Reads a scene. An input that is not there is no fault here: [`Scene::missing`] tells which quantity needs it, and
/// [`lacking`] says so.
///
/// ```
/// let text = "want = [\"eta\"]\n[chain]\nfirst = 10\nlast = 1\ninserted = 7\nrestitution = \"9/10\"\n";
/// assert_eq!(carom_physics::scene::read::scene(text).unwrap().missing(), None);
/// assert!(carom_physics::scene::read::scene(&text.replace("\"9/10\"", "0.9")).is_err());
/// ```
///
/// # Errors
/// The first fault, with its place.
pub fn scene(text: &str) -> Result<Scene, SceneFault> {
    let document = document(text)?;
    let table = document.get_ref();
    about(table)?;
    if let Some(drop) = find(table, "drop") {
        let help = "describe the chain in a table [chain]; `carom eval`, `carom worksheet` and `carom plot velocities` accept [drop]";
        return Err(fault(
            drop.span(),
            "this command needs a chain, and this scene has dropped balls",
            Some(help.to_owned()),
        ));
    }
    chain_scene(table)
}

fn chain_scene(table: &DeTable<'_>) -> Result<Scene, SceneFault> {
    if let Some(body) = find(table, "body") {
        let help = "describe the chain in a table [chain]; `carom replay` accepts [[body]]".to_owned();
        return Err(fault(body.span(), "this command needs a chain, and this scene has bodies on a line", Some(help)));
    }
    known_keys(table, &SCENE_KEYS, "the scene")?;
    let want = match find(table, "want") {
        None => vec![Quantity::Eta],
        Some(value) => {
            let want = list(value, "want", quantity)?;
            if want.is_empty() {
                let help = format!("give at least one of {}", Quantity::names().collect::<Vec<_>>().join(", "));
                return Err(fault(value.span(), "want is empty", Some(help)));
            }
            want
        }
    };
    let digits = match (find(table, "digits"), find(table, "places")) {
        (Some(_), Some(places)) => {
            return Err(fault(
                places.span(),
                "digits and places cannot be combined",
                Some("keep one of them".to_owned()),
            ));
        }
        (None, Some(places)) => Digits::Places(natural(places, "places")?),
        (Some(digits), None) => match natural(digits, "digits")? {
            0 => return Err(fault(digits.span(), "digits must be at least 1, not 0", None)),
            count => Digits::Significant(count),
        },
        (None, None) => Digits::Significant(DEFAULT_DIGITS),
    };
    let rounding = find(table, "rounding").map(direction).transpose()?.unwrap_or_default();
    let Some(chain) = find(table, "chain") else {
        let help = "add [chain] with first, last, inserted and restitution".to_owned();
        return Err(fault(0..0, "this scene has no table [chain]", Some(help)));
    };
    Ok(Scene { want, digits, rounding, inputs: inputs(chain)? })
}

/// The fault of a scene without an input that a quantity needs, at its table `[chain]`.
#[must_use]
pub fn lacking(text: &str, quantity: Quantity, input: Input) -> SceneFault {
    let (key, example) = match input {
        Input::Inserted => ("inserted", "7"),
        Input::Restitution => ("restitution", "\"9/10\""),
    };
    let document = DeTable::parse(text).ok();
    let span = document.and_then(|document| Some(find(document.get_ref(), "chain")?.span())).unwrap_or(0..0);
    let message = format!("{} needs {key}, {}", quantity.name(), input.words());
    fault(span, message, Some(format!("add {key} = {example} to [chain]")))
}

fn inputs(value: &Value<'_>) -> Result<Inputs, SceneFault> {
    let Some(table) = value.get_ref().as_table() else {
        return Err(fault(
            value.span(),
            "chain must be a table",
            Some("write [chain] on a line of its own".to_owned()),
        ));
    };
    known_keys(table, &CHAIN_KEYS, "[chain]")?;
    let needed = |key: &'static str, example: &str| {
        find(table, key)
            .ok_or_else(|| fault(value.span(), format!("[chain] has no {key}"), Some(format!("add {key} = {example}"))))
    };
    let first = mass(needed("first", "\"10\"")?)?;
    let last = mass(needed("last", "\"1\"")?)?;
    let inserted = match find(table, "inserted") {
        None => Inserted::Optimal(0),
        Some(value) if value.get_ref().is_array() => Inserted::Given(list(value, "inserted", mass)?),
        Some(value) => Inserted::Optimal(natural(value, "inserted")?),
    };
    let restitution = find(table, "restitution");
    let coefficients = restitution.map(coefficients).transpose()?;
    let start = match (find(table, "speed"), find(table, "velocities")) {
        (Some(_), Some(velocities)) => {
            return Err(fault(
                velocities.span(),
                "speed and velocities cannot be combined",
                Some("keep one of them".to_owned()),
            ));
        }
        (None, Some(velocities)) => Start::Velocities(list(velocities, "velocities", number)?),
        (Some(speed), None) => Start::Speed(number(speed)?),
        (None, None) => Start::unit(),
    };
    // Counts that do not fit are shown at the list that is checked.
    let place = find(table, "velocities").or(restitution).map_or(value.span(), Spanned::span);
    Inputs::new(first, last, Some(inserted), coefficients, start).map_err(|error| {
        let place = match &error {
            ChainError::Count { of: "coefficients of restitution", .. } => {
                restitution.map_or(place.clone(), Spanned::span)
            }
            ChainError::Number(_) => find(table, "inserted").map_or(place.clone(), Spanned::span),
            _ => place.clone(),
        };
        of_chain(place, &error)
    })
}

fn find<'a, 'i>(table: &'a DeTable<'i>, key: &str) -> Option<&'a Value<'i>> {
    table.iter().find(|(k, _)| k.get_ref().as_ref() == key).map(|(_, v)| v)
}

fn known_keys(table: &DeTable<'_>, known: &[&str], place: &str) -> Result<(), SceneFault> {
    keys::known(table, known, place).map_err(|unknown| fault(unknown.span, unknown.message, Some(unknown.help)))
}

fn list<T>(
    value: &Value<'_>,
    key: &str,
    item: impl Fn(&Value<'_>) -> Result<T, SceneFault>,
) -> Result<Vec<T>, SceneFault> {
    let Some(array) = value.get_ref().as_array() else {
        return Err(fault(
            value.span(),
            format!("{key} must be a list"),
            Some(format!("write {key} = [\"…\", \"…\"]")),
        ));
    };
    if array.len() as u64 > MAX_LISTED + 2 {
        let message = format!("limit reached: at most {MAX_LISTED} elements in {key}");
        return Err(SceneFault { limit: true, ..fault(value.span(), message, None) });
    }
    array.iter().map(item).collect()
}

/// The text of a number: a string, or an integer.
fn numeral<'a>(value: &'a Value<'_>) -> Result<&'a str, SceneFault> {
    match value.get_ref() {
        DeValue::String(text) => Ok(text.as_ref()),
        DeValue::Integer(integer) if integer.radix() == 10 => Ok(integer.as_str()),
        DeValue::Integer(_) => Err(fault(value.span(), "write the integer in base ten", None)),
        DeValue::Float(float) => {
            let help = format!("write the number as a string: \"{}\"", float.as_str());
            Err(fault(value.span(), "a TOML number with a point or exponent is not exact", Some(help)))
        }
        other => Err(fault(
            value.span(),
            format!("expected a number, found a value of type {}", other.type_str()),
            Some("write an integer or a string such as \"9/10\"".to_owned()),
        )),
    }
}

fn measured(value: &Value<'_>) -> Result<Range<Rational>, SceneFault> {
    Range::read(numeral(value)?).map_err(|error| of_range(value.span(), &error))
}

fn mass(value: &Value<'_>) -> Result<Range<Positive>, SceneFault> {
    measured(value)?.map(Positive::new).map_err(|error| of_chain(value.span(), &error))
}

fn coefficient(value: &Value<'_>) -> Result<Range<Restitution>, SceneFault> {
    measured(value)?.map(Restitution::new).map_err(|error| of_chain(value.span(), &error))
}

fn number(value: &Value<'_>) -> Result<Rational, SceneFault> {
    typed::read(numeral(value)?).map_err(|error| of_range(value.span(), &RangeError::Numeral(error)))
}

fn natural(value: &Value<'_>, key: &str) -> Result<u64, SceneFault> {
    let text = numeral(value)?;
    if !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit()) {
        return text.parse().map_err(|_| SceneFault {
            limit: true,
            ..fault(value.span(), format!("limit reached: {key} = {text} is too large"), None)
        });
    }
    Err(fault(value.span(), format!("{key} must be a natural number, not {text}"), None))
}

fn quantity(value: &Value<'_>) -> Result<Quantity, SceneFault> {
    let Some(name) = value.get_ref().as_str() else {
        return Err(fault(
            value.span(),
            "expected the name of a quantity",
            Some("write it as a string, \"eta\"".to_owned()),
        ));
    };
    Quantity::of_name(name).map_err(|message| fault(value.span(), message, None))
}

/// The names of the directions of rounding.
pub const ROUNDINGS: [(&str, Rounding); 5] = [
    ("nearest", Rounding::Nearest),
    ("up", Rounding::Up),
    ("down", Rounding::Down),
    ("zero", Rounding::Zero),
    ("away", Rounding::Away),
];

fn direction(value: &Value<'_>) -> Result<Rounding, SceneFault> {
    let name = value.get_ref().as_str().unwrap_or("");
    ROUNDINGS.iter().find(|(known, _)| *known == name).map(|(_, r)| *r).ok_or_else(|| {
        fault(value.span(), "unknown direction of rounding", Some("write nearest, up, down, zero or away".to_owned()))
    })
}
