//! Scenes of `carom replay`: TOML in, a checked line of bodies out.
//!
//! Contract: every number is exact. It stands as a string (`"1/3"`, `"0.1"`, `"2.5e-3"`) or as a TOML integer; a
//! TOML float is refused, since it would be rounded before it gets here, with the string to write instead. Unknown
//! keys are refused with the nearest known one. Each fault has its place in the file.
//!
//! ```toml
//! title = "Three equal bodies"   # optional
//! restitution = "1/5"            # one for all pairs, or a list, one for each neighbouring pair
//! [[body]]                       # bodies from left to right
//! mass = "1"
//! position = "0"
//! velocity = "1"                 # optional, 0
//! length = "1/2"                 # optional, 0; the position is the middle of the rod
//! [wall]                         # optional
//! left = "-3"                    # either or both
//! right = "8"
//! restitution = "1"              # one, or a list for left and right
//! ```
//!
//! Limits: [`MAX_BYTES`] bytes, those of numerals ([`crate::number::rational`]) and of
//! [`crate::chain::replay::MAX_BODIES`] bodies.

use super::keys;
use crate::chain::Restitution;
use crate::chain::replay::{Body, Line, LineError, Wall};
use crate::number::{rational, typed};
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The most bytes of a scene file.
pub const MAX_BYTES: usize = 256 << 20;

/// A fault in a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneError {
    /// What is wrong.
    pub message: String,
    /// What would be right.
    pub help: Option<String>,
    /// Where, in bytes.
    pub span: Range<usize>,
}

/// A scene.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Its title, if it has one.
    pub title: Option<String>,
    /// The bodies and walls.
    pub line: Line,
}

/// Reads a scene.
///
/// ```
/// let scene = carom_physics::scene::replay::read("[[body]]\nmass = \"1\"\nposition = 0\nvelocity = 1\n").unwrap();
/// assert_eq!(scene.line.bodies(), 1);
/// let fault = carom_physics::scene::replay::read("[[body]]\nmass = 0.1\nposition = 0\n").unwrap_err();
/// assert!(fault.help.unwrap().contains("\"0.1\""));
/// ```
///
/// # Errors
/// The first fault.
pub fn read(text: &str) -> Result<Scene, SceneError> {
    if text.len() > MAX_BYTES {
        return Err(fault(0..0, format!("limit reached: at most {MAX_BYTES} bytes in a scene"), None));
    }
    let root = DeTable::parse(text)
        .map_err(|e| fault(e.span().unwrap_or(0..0), e.message().to_string(), Some(super::read::TOML.to_owned())))?;
    let whole = 0..text.len().min(1);
    let table = Table { text, table: root.get_ref(), span: whole.clone() };
    if let Some(chain) = table.get("chain") {
        let help =
            "`carom eval` and `carom worksheet` accept a chain; for a replay, describe each body in a table [[body]]"
                .to_string();
        return Err(fault(
            chain.span(),
            "a replay needs bodies on a line, and this scene has a chain".to_string(),
            Some(help),
        ));
    }
    table.only(&["title", "restitution", "body", "wall"], "the scene")?;
    let title = table.get("title").map(|v| match v.get_ref() {
        DeValue::String(s) => Ok(s.to_string()),
        _ => Err(fault(v.span(), "title must be a string".to_string(), Some("write title = \"…\"".to_string()))),
    });
    let title = title.transpose()?;
    let (bodies, spans) = bodies(&table)?;
    let restitution = restitution(&table, bodies.len())?;
    let (left, right, wall_span) = walls(&table)?;
    let pair_span = table.get("restitution").map_or(whole, |v| v.span());
    let line = Line::new(&bodies, &restitution, left.as_ref(), right.as_ref());
    let line = line.map_err(|e| {
        let of = |body: usize| {
            let spans = body.checked_sub(1).and_then(|b| spans.get(b));
            spans.cloned().unwrap_or_else(|| wall_span.clone())
        };
        let (span, help) = match &e {
            // A restitution was checked when it was read.
            LineError::Empty | LineError::TooMany { .. } | LineError::Restitution { .. } => (of(0), None),
            LineError::Mass { body } => (of(*body), Some("a mass must be above 0".to_string())),
            LineError::Length { body } => (of(*body), Some("write 0 for a point-like body".to_string())),
            LineError::Order { body, .. } => {
                let help = "list the bodies from left to right, between the walls; they may touch".to_string();
                (of(*body), Some(help))
            }
            LineError::Pairs { .. } => (
                pair_span,
                Some("give one number for all pairs, or a list with one for each pair of neighbours".to_string()),
            ),
        };
        fault(span, e.to_string(), help)
    })?;
    Ok(Scene { title, line })
}

fn fault(span: Range<usize>, message: String, help: Option<String>) -> SceneError {
    SceneError { message, help, span }
}

/// A table of the file, with what is needed to say where a fault is.
struct Table<'a> {
    text: &'a str,
    table: &'a DeTable<'a>,
    span: Range<usize>,
}

impl<'a> Table<'a> {
    fn of(value: &'a Spanned<DeValue<'a>>, text: &'a str, what: &str) -> Result<Table<'a>, SceneError> {
        match value.get_ref() {
            DeValue::Table(table) => Ok(Table { text, table, span: value.span() }),
            other => Err(fault(
                value.span(),
                format!("{what} must be a table, not a value of type {}", other.type_str()),
                None,
            )),
        }
    }

    fn get(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.table.iter().find(|(k, _)| k.get_ref() == key).map(|(_, v)| v)
    }

    fn only(&self, known: &[&str], place: &str) -> Result<(), SceneError> {
        keys::known(self.table, known, place)
            .map_err(|unknown| fault(unknown.span, unknown.message, Some(unknown.help)))
    }

    fn number(&self, key: &str, otherwise: Option<Rational>) -> Result<Rational, SceneError> {
        match (self.get(key), otherwise) {
            (Some(value), _) => number(value, key, self.text),
            (None, Some(default)) => Ok(default),
            (None, None) => {
                Err(fault(self.span.clone(), format!("{key} is missing"), Some(format!("add {key} = \"…\""))))
            }
        }
    }
}

/// One exact number.
fn number(value: &Spanned<DeValue>, key: &str, text: &str) -> Result<Rational, SceneError> {
    let span = value.span();
    let parse = |digits: &str, inner: Range<usize>| {
        typed::read(digits).map_err(|e| {
            fault(
                inner,
                format!("{key}: {e}"),
                Some("write for instance \"3\", \"1/3\", \"0.25\" or \"2.5e-3\"".into()),
            )
        })
    };
    match value.get_ref() {
        DeValue::String(digits) => parse(digits.trim(), span),
        DeValue::Integer(i) if i.radix() == 10 => parse(i.as_str(), span),
        DeValue::Float(_) => {
            let written = text.get(span.clone()).unwrap_or("").replace('_', "");
            let help = match rational::parse(&written) {
                Ok(_) => format!("write {key} = \"{written}\": a string is read exactly"),
                Err(_) => "write the exact number as a string".to_string(),
            };
            Err(fault(span, format!("{key} is a TOML number with a point or exponent, which is not exact"), Some(help)))
        }
        other => {
            let help = Some(format!("write {key} = \"1/3\" or {key} = 2"));
            Err(fault(span, format!("{key} must be a number, not a value of type {}", other.type_str()), help))
        }
    }
}

/// One coefficient of restitution, or a list of them, each checked whether or not something collides with it.
fn coefficients(value: &Spanned<DeValue>, text: &str) -> Result<(bool, Vec<Rational>), SceneError> {
    let one = |value: &Spanned<DeValue>| {
        let e = number(value, "restitution", text)?;
        Restitution::new(e.clone()).map_err(|error| fault(value.span(), error.to_string(), None))?;
        Ok(e)
    };
    match value.get_ref() {
        DeValue::Array(list) => Ok((true, list.iter().map(one).collect::<Result<_, _>>()?)),
        _ => Ok((false, vec![one(value)?])),
    }
}

fn bodies(root: &Table) -> Result<(Vec<Body>, Vec<Range<usize>>), SceneError> {
    let help = || Some("write [[body]] on a line of its own, and below it mass, position and velocity".to_string());
    let Some(value) = root.get("body") else {
        return Err(fault(root.span.clone(), "there is no body in this scene".to_string(), help()));
    };
    let DeValue::Array(list) = value.get_ref() else {
        return Err(fault(value.span(), "body must be a list of tables".to_string(), help()));
    };
    let (mut bodies, mut spans) = (Vec::with_capacity(list.len()), Vec::with_capacity(list.len()));
    for value in list {
        let table = Table::of(value, root.text, "a body")?;
        table.only(&["mass", "position", "velocity", "length"], "[[body]]")?;
        bodies.push(Body {
            mass: table.number("mass", None)?,
            position: table.number("position", None)?,
            velocity: table.number("velocity", Some(Rational::ZERO))?,
            length: table.number("length", Some(Rational::ZERO))?,
        });
        spans.push(value.span());
    }
    Ok((bodies, spans))
}

fn restitution(root: &Table, bodies: usize) -> Result<Vec<Rational>, SceneError> {
    let pairs = bodies.saturating_sub(1);
    match root.get("restitution") {
        None if pairs == 0 => Ok(Vec::new()),
        None => {
            let help = Some("add restitution = \"1\" for elastic collisions".to_string());
            Err(fault(root.span.clone(), "restitution is missing".to_string(), help))
        }
        Some(value) => {
            let (list, mut all) = coefficients(value, root.text)?;
            if !list {
                all = vec![all[0].clone(); pairs];
            }
            Ok(all)
        }
    }
}

/// The walls, and where the file speaks of them.
type Walls = (Option<Wall>, Option<Wall>, Range<usize>);

fn walls(root: &Table) -> Result<Walls, SceneError> {
    let Some(value) = root.get("wall") else { return Ok((None, None, root.span.clone())) };
    let table = Table::of(value, root.text, "wall")?;
    table.only(&["left", "right", "restitution"], "[wall]")?;
    let place = |key: &str| table.get(key).map(|v| number(v, key, root.text)).transpose();
    let (left, right) = (place("left")?, place("right")?);
    if left.is_none() && right.is_none() {
        let help = Some("add left = \"…\" or right = \"…\"".to_string());
        return Err(fault(value.span(), "the wall has no position".to_string(), help));
    }
    let Some(given) = table.get("restitution") else {
        let help = Some("add restitution = \"1\" for elastic walls".to_string());
        return Err(fault(value.span(), "the restitution of the wall is missing".to_string(), help));
    };
    let (list, all) = coefficients(given, root.text)?;
    let (at_left, at_right) = match (list, all.as_slice()) {
        (false, [one]) => (one.clone(), one.clone()),
        (true, [one, two]) if left.is_some() && right.is_some() => (one.clone(), two.clone()),
        _ => {
            let help = Some("give one number, or [left, right] where there are two walls".to_string());
            return Err(fault(given.span(), format!("the wall has {} coefficients of restitution", all.len()), help));
        }
    };
    let wall = |position: Option<Rational>, restitution| position.map(|position| Wall { position, restitution });
    Ok((wall(left, at_left), wall(right, at_right), value.span()))
}
