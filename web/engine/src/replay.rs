//! The collisions of a chain, one by one.
//!
//! The bodies are rods that stand one unit apart, or at the distances `gaps`, perhaps between walls at the distances `left` and
//! `right` from them; the first one moves, or each has its own velocity. Rods behave as points do: their lengths,
//! chosen for the eye, shift when collisions happen and change no velocity. Inserted masses that are irrational are
//! replaced by decimals of [`MASS_DIGITS`] digits: every number of such a replay is written as an approximation, with
//! [`APPROXIMATE`] digits. A replay goes on where bodies stick and from a collapse: an event that stands for infinitely
//! many collisions, after which the bodies from `first` to `last` have one velocity, is marked `joined`. Where inputs are
//! measured, the chain of their middles is replayed; `middle` names these, and says that it is one of many chains.

use crate::middle;
use crate::request::{Fault, Request};
use carom_documents::report::replay::svg::{self, Worldlines};
use carom_documents::report::replay::{Numbers, Replay, counted, decimal, group, pair};
use carom_exact::number::decimal::{Digits, Rounding};
use carom_exact::number::rational;
use carom_physics::chain::recollision::WARNING;
use carom_physics::chain::replay::{self, Body, Entry, Limit, Line, Options, Outcome, Status, Value as Exact, Wall};
use carom_physics::scene::answer::{Answers, Number, Value as Answer};
use carom_physics::scene::quantity::Quantity;
use carom_physics::scene::{Chain, Scene, Start};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use serde_json::{Value, json};

/// The most inserted bodies that are drawn.
const MAX_DRAWN: u64 = 40;
/// The most collisions that are listed.
const MAX_EVENTS: u64 = 1_000;
/// Digits of an irrational mass in the replay.
const MASS_DIGITS: u64 = 12;
/// Digits of the numbers of a replay whose masses were rounded.
const APPROXIMATE: u64 = 6;
/// Texts of exact numbers that are longer are decimals instead, with so many digits.
const SHORT: (usize, u64) = (24, 12);

/// Replays the chain.
pub fn replay(request: &Request) -> Result<Value, Fault> {
    let (chain, middle) = middle::of(&request.chain()?)?;
    if chain.count() > MAX_DRAWN {
        let message = format!("limit reached: {MAX_DRAWN} inserted bodies are drawn at most");
        return Err(Fault::new(message).limit().help("the numbers on this page are about all of them"));
    }
    let (masses, rounded) = masses(&chain)?;
    let around = Around::of(request, masses.len())?;
    let line = line(&chain, &masses, &around)?;
    let options = Options {
        max_events: MAX_EVENTS,
        list: usize::try_from(MAX_EVENTS).unwrap_or(usize::MAX),
        through_collapse: true,
        ..Options::default()
    };
    let outcome = replay::replay(&line, &options)
        .map_err(|fault| Fault::new(format!("internal error: {} is not conserved; please report this", fault.law)))?;
    let title = middle.as_ref().map(|named| format!("The middle of the measured values: {named}"));
    let replay =
        Replay { title: title.as_deref(), line: &line, outcome: &outcome, numbers: Numbers::Short(SHORT.0, SHORT.1) };
    let lines = Worldlines::new(&replay);
    let pass = chain.count() + 1;
    let written = |x: &Exact| if rounded { approximate(x) } else { exact(x) };
    let rational = |x: &Rational| written(&Exact::Exact(x.clone()));
    let shown = Shown::of(&line, &outcome);
    let is_walled = around.left.is_some() || around.right.is_some();
    // The pass is the first meeting of each pair.
    let mut met = vec![false; line.bodies() + 1];
    let mut again = false;
    let events: Vec<Value> = outcome
        .in_order()
        .zip(lines.contacts.iter().zip(&shown.after))
        .map(|(entry, (contact, after))| {
            let (first, last) = match entry {
                Entry::Collision(_, c) => (c.pair, c.pair + 1),
                Entry::Joined(j) => j.bodies,
            };
            let of_the_pass = met[first..last].contains(&false);
            met[first..last].fill(true);
            again |= !of_the_pass;
            let mut event = match entry {
                Entry::Collision(number, c) => json!({
                    "number": number,
                    "pair": pair(&line, c.pair),
                    "time": written(&c.time),
                    "before": [written(&c.before[0]), written(&c.before[1])],
                    "after": [written(&c.after[0]), written(&c.after[1])],
                    "lost": written(&c.lost),
                    "joined": false,
                }),
                Entry::Joined(j) => json!({
                    "number": "∞",
                    "pair": group(&line, j.bodies),
                    "time": written(&j.time),
                    "before": [rational(&j.before[0]), rational(&j.before[1])],
                    "after": [rational(&j.velocity), rational(&j.velocity)],
                    "lost": rational(&j.lost),
                    "joined": true,
                }),
            };
            let drawn = [
                ("first", json!(first)),
                ("last", json!(last)),
                ("of_the_pass", json!(of_the_pass)),
                ("drawn_time", json!(contact.0)),
                ("drawn_after", json!(after)),
            ];
            drawn.into_iter().for_each(|(key, value)| event[key] = value);
            event
        })
        .collect();
    Ok(json!({
        "events": events,
        "count": outcome.count,
        "total": total(&outcome),
        "pass": pass,
        "again": outcome.joins > 0 || again,
        "warning": WARNING,
        "end": end(&outcome.status),
        "exact": outcome.enclosed.is_none(),
        "rounded": rounded.then_some(MASS_DIGITS),
        "middle": middle,
        // Where collisions are left, nobody has a last velocity.
        "final": match &outcome.status {
            Status::Complete => outcome.velocities.iter().map(&written).collect(),
            _ => Vec::new(),
        },
        "walled": is_walled,
        "lost": written(&outcome.energy.lost),
        // Bodies of rounded mass rest before the first collision: what is known then is exact.
        "energy": exact(&outcome.energy.initial),
        "momentum": exact(&outcome.momentum.0),
        "start": (1..=line.bodies())
            .filter_map(|b| line.start(b))
            .map(|(_, v)| exact(&Exact::Exact(v)))
            .collect::<Vec<_>>(),
        "masses": masses.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "drawn": {
            "worldlines": lines.bodies,
            "half": lines.half,
            "end": lines.end,
            "range": [lines.range.0, lines.range.1],
            "masses": shown.masses,
            "start": shown.start,
            // Walls change the momentum, and the centre of mass turns.
            "centre": (!is_walled).then_some([shown.centre.0, shown.centre.1]),
            "gaps": around.gaps.iter().map(double).collect::<Vec<_>>(),
            "walls": [lines.walls.0, lines.walls.1],
            "room": [around.left.as_ref().map(double), around.right.as_ref().map(double)],
        },
        "svg": svg::report(&replay),
    }))
}

/// A number as text, and whether that is exact.
fn exact(x: &Exact) -> Value {
    let exact = Numbers::Exact.write(x);
    let is_exact = !matches!(x, Exact::Within(..)) && exact.chars().count() <= SHORT.0;
    json!({ "text": if is_exact { exact } else { decimal(x, SHORT.1) }, "exact": is_exact })
}

/// The same for a replay with rounded masses: a few digits, marked.
fn approximate(x: &Exact) -> Value {
    json!({ "text": decimal(x, APPROXIMATE), "exact": false, "approximate": true })
}

/// Doubles for the arrows and bars of the animation.
struct Shown {
    masses: Vec<f64>,
    /// The velocities before the first collision.
    start: Vec<f64>,
    /// The velocities of the first and the last body after each event.
    after: Vec<[f64; 2]>,
    /// Place at the start and velocity of the centre of mass.
    centre: (f64, f64),
}

impl Shown {
    fn of(line: &Line, outcome: &Outcome) -> Shown {
        let near = |x: &Rational| f64::rounding_from(x, RoundingMode::Nearest).0;
        let middle = |x: &Exact| {
            let (lo, hi) = x.enclose(80);
            near(&((lo + hi) / Rational::from(2)))
        };
        let bodies: Vec<(&Rational, Rational, Rational)> = (1..=line.bodies())
            .filter_map(|b| Some((line.mass(b)?, line.start(b)?)))
            .map(|(mass, (place, velocity))| (mass, place, velocity))
            .collect();
        let sum =
            |of: &dyn Fn(&(&Rational, Rational, Rational)) -> Rational| -> Rational { bodies.iter().map(of).sum() };
        let all = sum(&|b| b.0.clone());
        let (moment, momentum) = (sum(&|b| b.0 * &b.1), sum(&|b| b.0 * &b.2));
        Shown {
            masses: bodies.iter().map(|b| near(b.0)).collect(),
            start: bodies.iter().map(|b| near(&b.2)).collect(),
            after: outcome
                .in_order()
                .map(|entry| match entry {
                    Entry::Collision(_, c) => [middle(&c.after[0]), middle(&c.after[1])],
                    Entry::Joined(j) => [near(&j.velocity); 2],
                })
                .collect(),
            centre: (near(&(moment / &all)), near(&(momentum / all))),
        }
    }
}

/// How many collisions there are in all, in words.
fn total(outcome: &Outcome) -> String {
    match &outcome.status {
        Status::Complete => counted(outcome),
        Status::Limit(_) | Status::Ambiguous(_) | Status::Collapse(_) => format!("{} and more", counted(outcome)),
    }
}

fn end(status: &Status) -> String {
    match status {
        Status::Complete => "no further collision follows".to_owned(),
        Status::Collapse(found) => {
            format!("those of the bodies {} to {} never end", found.bodies.0, found.bodies.1)
        }
        Status::Limit(Limit::Events { allowed }) => format!("limit reached: {allowed} collisions, and more are due"),
        Status::Limit(_) => "limit reached: the numbers have become too long".to_owned(),
        Status::Ambiguous(found) => format!(
            "the bodies {} to {} touch, and several pairs of them would collide at the same time. Mechanics does not determine the order of these collisions, so the replay ends there",
            found.bodies.0, found.bodies.1
        ),
    }
}

/// The masses of a chain as rationals, and whether one of them had to be rounded.
fn masses(chain: &Chain) -> Result<(Vec<Rational>, bool), Fault> {
    let scene = Scene {
        want: vec![Quantity::Masses],
        digits: Digits::Significant(MASS_DIGITS),
        rounding: Rounding::Nearest,
        inputs: chain.clone().into(),
    };
    let answers = Answers::new(&scene);
    let (answer, _) = answers.get(Quantity::Masses).map_err(|error| Fault::chain(None, &error))?;
    let Answer::List(numbers) = answer else { return Err(Fault::new("the masses are not known")) };
    let rounded = numbers.iter().any(|n| n.exact.is_none());
    let mass = |number: &Number| match (&number.exact, &number.decimal) {
        (Some(exact), _) => Some(exact.clone()),
        (None, Some(decimal)) => rational::parse(decimal).ok(),
        _ => None,
    };
    let list: Option<Vec<Rational>> = numbers.iter().map(mass).collect();
    Ok((list.ok_or_else(|| Fault::new("the masses are not known"))?, rounded))
}

fn double(x: &Rational) -> f64 {
    f64::rounding_from(x, RoundingMode::Nearest).0
}

/// What is around the bodies.
struct Around {
    /// The free way from each body to the next.
    gaps: Vec<Rational>,
    /// The free ways from the walls to the outer bodies, where there are walls.
    left: Option<Rational>,
    right: Option<Rational>,
    /// The restitution of the walls.
    restitution: Rational,
}

impl Around {
    /// The fields `gaps`, `left`, `right` and `wall`. An empty one stands for gaps of 1, no wall and elastic walls.
    fn of(request: &Request, bodies: usize) -> Result<Around, Fault> {
        let needed = bodies.saturating_sub(1);
        // A comma in a single distance is a decimal one.
        let mut gaps = match needed {
            1 => request.distance("gaps")?.into_iter().collect(),
            _ => request.distances("gaps")?,
        };
        if gaps.is_empty() {
            gaps = vec![Rational::ONE; needed];
        }
        if gaps.len() != needed {
            let message = format!("{} distances for {bodies} bodies: {needed} are needed", gaps.len());
            return Err(Fault::at("gaps", message));
        }
        let is_empty = request.text("wall")?.is_empty();
        let restitution = if is_empty { Rational::ONE } else { request.single("wall")? };
        if !(Rational::ZERO..=Rational::ONE).contains(&restitution) {
            return Err(Fault::at("wall", "a restitution is between 0 and 1"));
        }
        Ok(Around { gaps, left: request.distance("left")?, right: request.distance("right")?, restitution })
    }
}

/// The bodies on their line with the free way between them, lengths as the cube roots of masses.
fn line(chain: &Chain, masses: &[Rational], around: &Around) -> Result<Line, Fault> {
    let near = |m: &Rational| f64::rounding_from(m, RoundingMode::Nearest).0;
    let heaviest = masses.iter().map(near).fold(f64::MIN_POSITIVE, f64::max);
    let restitutions = chain.restitutions().0;
    let velocity = |i: usize| match chain.start() {
        Start::Speed(speed) if i == 0 => speed.clone(),
        Start::Speed(_) => Rational::ZERO,
        Start::Velocities(list) => list.get(i).cloned().unwrap_or(Rational::ZERO),
    };
    let mut bodies = Vec::with_capacity(masses.len());
    let (mut place, mut end) = (Rational::ZERO, Rational::ZERO);
    for (i, mass) in masses.iter().enumerate() {
        // From 1/8 to 1, in steps of 1/64.
        let steps = (64.0 * (near(mass) / heaviest).cbrt()).round().clamp(8.0, 64.0);
        let length = Rational::from_unsigneds(steps as u64, 64);
        let half = &length / Rational::from(2);
        bodies.push(Body {
            mass: mass.clone(),
            position: &place + &half,
            velocity: velocity(i),
            length: length.clone(),
        });
        place += length;
        end = place.clone();
        place += around.gaps.get(i).unwrap_or(&Rational::ONE);
    }
    let pairs: Vec<Rational> =
        (0..masses.len() as u64 - 1).filter_map(|i| restitutions.at(i).map(|e| e.value().clone())).collect();
    let wall = |position| Wall { position, restitution: around.restitution.clone() };
    let left = around.left.as_ref().map(|way| wall(-way));
    let right = around.right.as_ref().map(|way| wall(end + way));
    Line::new(&bodies, &pairs, left.as_ref(), right.as_ref()).map_err(|error| Fault::new(error.to_string()))
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    fn replay(m1: &str, e: &str, n: &str) -> Value {
        let request = json!({"m1": m1, "m2": "1", "e": e, "n": n});
        serde_json::from_str(&crate::replay(&request.to_string())).expect("JSON")
    }

    #[test]
    fn the_velocities_of_the_replay_are_those_of_the_pass() {
        // x = 4, e = 1/2, x·e >= 1: no body is struck twice.
        let found = replay("64", "1/2", "2");
        assert_eq!(found["count"], 3);
        assert_eq!(found["again"], false);
        assert!(found["rounded"].is_null());
        let request = json!({"m1": "64", "m2": "1", "e": "1/2", "n": "2", "digits": "12"});
        let pass: Value = serde_json::from_str(&crate::answers(&request.to_string())).expect("JSON");
        for i in 0..4 {
            let exact = &pass["answers"]["velocities"]["value"][i]["exact"];
            assert_eq!(&found["final"][i]["text"], exact, "{found}");
        }
    }

    #[test]
    fn walls_and_distances_are_those_of_the_fields() {
        let ask = |more: Value| {
            let mut request = json!({"m1": "1", "m2": "1", "e": "1", "n": "0", "velocities": "1; 0"});
            request.as_object_mut().expect("fields").extend(more.as_object().expect("fields").clone());
            serde_json::from_str::<Value>(&crate::replay(&request.to_string())).expect("JSON")
        };
        // Body 1 comes 3 units far, body 2 goes 2 more to the wall: the times are 3 and 5.
        let found = ask(json!({"gaps": "3", "right": "2", "wall": "1/2"}));
        let events = found["events"].as_array().expect("a list");
        assert_eq!((&events[0]["time"]["text"], &events[1]["time"]["text"]), (&json!("3"), &json!("5")), "{found}");
        assert_eq!(events[1]["pair"], "2–right wall", "{found}");
        // It comes back with half its speed and hands that on.
        assert_eq!(found["final"][0]["text"], "-1/2", "{found}");
        assert_eq!((found["count"].clone(), found["drawn"]["centre"].clone()), (json!(3), Value::Null), "{found}");
        // Between two elastic walls it never ends, and nobody has a last velocity.
        let endless = ask(json!({"gaps": "0,5", "left": "1", "right": "1"}));
        assert_eq!((&endless["final"], &endless["walled"]), (&json!([]), &json!(true)), "{endless}");
        assert!(endless["end"].as_str().expect("words").starts_with("limit reached"), "{endless}");
        for (more, field) in [
            (json!({"gaps": "1; 1"}), "gaps"),
            (json!({"gaps": "-1"}), "gaps"),
            (json!({"left": "-1/2"}), "left"),
            (json!({"right": "far"}), "right"),
            (json!({"left": "1", "wall": "2"}), "wall"),
        ] {
            assert_eq!(ask(more.clone())["error"]["field"], field, "{more}: {}", ask(more.clone()));
        }
    }

    #[test]
    fn bodies_that_meet_again_are_seen() {
        let found = replay("2", "1/2", "0");
        assert_eq!(found["again"], false);
        // e < x < 1/e with x = 2^(1/2).
        let found = replay("2", "1/2", "1");
        assert_eq!(found["again"], true);
        assert_eq!(found["rounded"], 12);
        // No fraction passes as a time of the chain that was asked for.
        for event in found["events"].as_array().expect("a list") {
            assert_eq!(event["time"]["exact"], false, "{event}");
        }
    }

    #[test]
    fn bodies_that_stick_are_played_to_the_end() {
        let found = replay("1", "0", "3");
        assert_eq!(found["end"], "no further collision follows");
        assert_eq!(found["total"], "1 collision, and 3 times infinitely many more");
        assert_eq!(found["again"], true);
        let events = found["events"].as_array().expect("a list");
        assert_eq!(events.len(), 4);
        assert!(events.iter().all(|e| e["of_the_pass"] == true));
        assert_eq!(
            (&events[3]["first"], &events[3]["last"], &events[3]["joined"]),
            (&json!(1), &json!(5), &json!(true))
        );
        for i in 0..5 {
            assert_eq!(found["final"][i]["text"], "1/5", "{found}");
        }
    }

    #[test]
    fn only_first_meetings_are_of_the_pass() {
        let found = replay("1", "1/2", "2");
        let mut seen = Vec::new();
        for event in found["events"].as_array().expect("a list") {
            assert_eq!(event["of_the_pass"] == true, !seen.contains(&event["first"]), "{event}");
            seen.push(event["first"].clone());
        }
        assert!(seen.len() > 3);
    }

    #[test]
    fn limits_are_said() {
        assert_eq!(replay("2", "1/2", "41")["error"]["limit"], true);
    }

    #[test]
    fn measured_values_are_replayed_at_their_middles_and_named() {
        let mut measured = replay("57.1 ± 0.1", "[0.88, 0.92]", "2");
        assert_eq!(measured["middle"], "m1 = 57.1, e = 0.9");
        let mut exact = replay("57.1", "0.9", "2");
        assert!(exact["middle"].is_null());
        exact["middle"] = measured["middle"].clone();
        let title = "The middle of the measured values: m1 = 57.1, e = 0.9";
        assert!(measured["svg"].as_str().is_some_and(|svg| svg.contains(title)));
        (measured["svg"], exact["svg"]) = (Value::Null, Value::Null);
        assert_eq!(exact, measured, "every number is that of the middle");
        let request = json!({"m1": "2", "m2": "1", "e": "1, 0.5 ± 0.1", "inserted": "given", "masses": "1.5(1)"});
        let found: Value = serde_json::from_str(&crate::replay(&request.to_string())).expect("JSON");
        assert_eq!(found["middle"], "the mass of body 2 = 1.5, e2 = 0.5");
    }
}
