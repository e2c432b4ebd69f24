//! A referee for other people's simulators of collisions on a line.
//!
//! Contract: [`scenes`] are the reference scenes of `scenes.json`, each with its end, computed here and now by
//! [`replay`]: velocities and positions at the time `until`, collisions in order, momentum and energy. Every number is
//! exact or enclosed to [`DIGITS`] digits. [`judge::judge`] compares somebody's results with them.
//!
//! A contact at one instant that the laws leave open has several ends ([`Reference::ends`]); each of them is right. Where
//! infinitely many collisions happen, those before them are listed, and the count is left out.

pub mod judge;
pub mod results;

use crate::chain::replay::{Body, Line, Options, Outcome, Status, Value, Wall, replay};
use crate::number::rational;
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
use serde_json::{Map, Value as Json};

/// The scenes: set-up and end time, without results.
const SCENES: &str = include_str!("scenes.json");

/// Digits to which an end is enclosed where it is not exact.
pub const DIGITS: u64 = 40;

/// How many collisions of a scene are listed; all are counted.
pub const LISTED: usize = 200;

/// Contacts that the laws leave open, one after the other, that are followed.
const DEEPEST: usize = 3;

/// A scene: bodies from left to right at time 0, and the time at which results are compared.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Its name, which results are filed under.
    pub name: String,
    /// What kind of scene it is.
    pub group: String,
    /// What happens, in a sentence.
    pub about: String,
    /// The bodies.
    pub bodies: Vec<Body>,
    /// The restitution of each neighbouring pair.
    pub restitution: Vec<Rational>,
    /// The walls.
    pub walls: [Option<Wall>; 2],
    /// The time of comparison; no collision happens then.
    pub until: Rational,
}

/// A number that is exact, or lies between two others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Known {
    /// The number as the replay has it.
    pub value: Value,
    /// At most the number.
    pub lo: Rational,
    /// At least the number.
    pub hi: Rational,
}

impl Known {
    fn of(value: &Value) -> Known {
        let (lo, hi) = value.enclose(DIGITS * 4);
        Known { value: value.clone(), lo, hi }
    }
}

/// How a scene ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct End {
    /// The velocities at the end.
    pub velocities: Vec<Known>,
    /// The positions at the end.
    pub positions: Vec<Known>,
}

/// A collision: the pair by its left point (0 is the left wall), and when.
#[derive(Clone, Debug)]
pub struct Due {
    /// Bodies `pair` and `pair + 1`.
    pub pair: usize,
    /// The time.
    pub time: Known,
}

/// What is right for a scene.
#[derive(Clone, Debug)]
pub struct Reference {
    /// The scene.
    pub scene: Scene,
    /// The possible ends: one, or several after a contact that the laws leave open.
    pub ends: Vec<End>,
    /// The first collisions, those of one instant together; up to a contact that is left open, or to infinitely many.
    pub instants: Vec<Vec<Due>>,
    /// How many collisions there are; `None` where they are infinitely many, or their number is left open.
    pub count: Option<u64>,
}

impl Scene {
    /// The line of bodies.
    fn line(&self) -> Result<Line, String> {
        line(&self.bodies, self)
    }
}

fn line(bodies: &[Body], scene: &Scene) -> Result<Line, String> {
    let [left, right] = &scene.walls;
    Line::new(bodies, &scene.restitution, left.as_ref(), right.as_ref())
        .map_err(|error| format!("{}: {error}", scene.name))
}

/// All scenes with what is right for them, in the order of the file.
///
/// ```
/// let references = carom_physics::referee::scenes().unwrap();
/// assert!(references.len() >= 100);
/// let half = references.iter().find(|r| r.scene.name == "two-equal-half").unwrap();
/// assert_eq!(half.ends[0].velocities[0].lo.to_string(), "1/4");
/// ```
///
/// # Errors
/// A fault of the file of scenes, by name: none, as the tests hold it.
pub fn scenes() -> Result<Vec<Reference>, String> {
    settings()?.into_iter().map(reference).collect()
}

/// The scenes without their ends.
///
/// # Errors
/// As [`scenes`].
pub fn settings() -> Result<Vec<Scene>, String> {
    let list: Vec<Map<String, Json>> = serde_json::from_str(SCENES).map_err(|e| e.to_string())?;
    list.iter().map(scene).collect()
}

fn scene(entry: &Map<String, Json>) -> Result<Scene, String> {
    let name = text(entry, "name")?;
    let wrong = |key: &str| format!("{name}: {key} cannot be read");
    let number = |value: &Json| value.as_str().and_then(|text| rational::parse(text).ok());
    let list = |key: &str| -> Result<Vec<Rational>, String> {
        let values = entry.get(key).and_then(Json::as_array).ok_or_else(|| wrong(key))?;
        values.iter().map(|value| number(value).ok_or_else(|| wrong(key))).collect()
    };
    let (masses, positions, velocities) = (list("masses")?, list("positions")?, list("velocities")?);
    let lengths = if entry.contains_key("lengths") { list("lengths")? } else { vec![Rational::ZERO; masses.len()] };
    if [positions.len(), velocities.len(), lengths.len()].iter().any(|count| *count != masses.len()) {
        return Err(wrong("masses"));
    }
    let bodies = (0..masses.len()).map(|k| Body {
        mass: masses[k].clone(),
        position: positions[k].clone(),
        velocity: velocities[k].clone(),
        length: lengths[k].clone(),
    });
    let bodies: Vec<Body> = bodies.collect();
    let restitution = match entry.get("restitution").and_then(number) {
        Some(one) => vec![one; bodies.len().saturating_sub(1)],
        None => list("restitution")?,
    };
    let wall = |key: &str| -> Result<Option<Wall>, String> {
        let Some(wall) = entry.get(key) else { return Ok(None) };
        let part = |part: &str| wall.get(part).and_then(number).ok_or_else(|| wrong(key));
        Ok(Some(Wall { position: part("position")?, restitution: part("restitution")? }))
    };
    let walls = [wall("left_wall")?, wall("right_wall")?];
    let until = entry.get("until").and_then(number).ok_or_else(|| wrong("until"))?;
    Ok(Scene { group: text(entry, "group")?, about: text(entry, "about")?, name, bodies, restitution, walls, until })
}

fn text(entry: &Map<String, Json>, key: &str) -> Result<String, String> {
    entry.get(key).and_then(Json::as_str).map(str::to_owned).ok_or_else(|| format!("a scene without {key}"))
}

/// What is right for a scene.
///
/// # Errors
/// The scene makes no sense, or its end is not known.
pub fn reference(scene: Scene) -> Result<Reference, String> {
    let outcome = played(&scene.line()?, &scene.until, &scene.name)?;
    let first_join = outcome.joined.first().map(|joined| joined.after);
    // Where several orders are right, none of them is asked for.
    let known = first_join.into_iter().chain(outcome.before_any_order).min().unwrap_or(u64::MAX);
    let listed = usize::try_from(known).unwrap_or(usize::MAX).min(LISTED);
    let mut instants: Vec<Vec<Due>> = Vec::new();
    for collision in outcome.events.iter().take(listed) {
        let due = Due { pair: collision.pair, time: Known::of(&collision.time) };
        match instants.last_mut() {
            Some(instant) if instant[0].time.value == due.time.value => instant.push(due),
            _ => instants.push(vec![due]),
        }
    }
    let finite = outcome.joins == 0 && matches!(outcome.status, Status::Complete);
    let count = finite.then_some(outcome.count);
    let mut ends = Vec::new();
    follow(&scene, &outcome, &scene.until, DEEPEST, &mut ends)?;
    Ok(Reference { scene, ends, instants, count })
}

fn played(line: &Line, until: &Rational, name: &str) -> Result<Outcome, String> {
    let options = Options {
        until: Some(until.clone()),
        list: LISTED,
        orders: true,
        through_collapse: true,
        digits: DIGITS,
        ..Options::default()
    };
    replay(line, &options).map_err(|fault| format!("{name}: {} is not kept", fault.law))
}

/// The ends that an outcome leads to: its own, or those after each order of a contact that is left open.
fn follow(scene: &Scene, outcome: &Outcome, until: &Rational, depth: usize, ends: &mut Vec<End>) -> Result<(), String> {
    let open = || format!("{}: its end is not known", scene.name);
    let contact = match &outcome.status {
        Status::Complete => {
            let known = |list: &[Value]| list.iter().map(Known::of).collect();
            let end = End { velocities: known(&outcome.velocities), positions: known(&outcome.positions) };
            if !ends.contains(&end) {
                ends.push(end);
            }
            return Ok(());
        }
        Status::Ambiguous(contact) if depth > 0 => contact,
        _ => return Err(open()),
    };
    let found = contact.outcomes.as_ref().filter(|found| !found.cut).ok_or_else(open)?;
    let exact = |list: &[Value]| list.iter().map(|v| v.rational().cloned()).collect::<Option<Vec<_>>>();
    let (positions, velocities) = exact(&outcome.positions).zip(exact(&outcome.velocities)).ok_or_else(open)?;
    for one in &found.outcomes {
        let body = |k: usize| {
            // The points of the contact count from its first one; 0 is the left wall.
            let place = (k + 1).checked_sub(contact.bodies.0);
            let velocity = place.and_then(|place| one.velocities.get(place)).unwrap_or(&velocities[k]);
            Body { position: positions[k].clone(), velocity: velocity.clone(), ..scene.bodies[k].clone() }
        };
        let bodies: Vec<Body> = (0..scene.bodies.len()).map(body).collect();
        let rest = until - &contact.time;
        let after = played(&line(&bodies, scene)?, &rest, &scene.name)?;
        follow(scene, &after, &rest, depth - 1, ends)?;
    }
    Ok(())
}
