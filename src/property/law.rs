//! Claims of the language as properties: tried at random exact points that satisfy their hypotheses.
//!
//! [`law`] reads a claim. The [`Law`] tries itself ([`Law::tried`]), and it is a strategy of proptest that draws points
//! where its hypotheses hold, for tests of your own code at such points:
//!
//! ```
//! use carom_property::law::{Outcome, Settings, law};
//! use proptest::prelude::*;
//!
//! let claim = law("given m1, m2 > 0;  e in [0, 1]\nprove (1 + e)*m1/(m1 + m2) <= 1").expect("it parses");
//! let Outcome::Failed(failure) = claim.tried(&Settings::default()) else { panic!() };
//! assert_eq!(failure.witness.point.values[2], ("e".to_string(), "1".to_string()));
//!
//! let kept = law("given m1, m2 > 0;  e in [0, 1]\nprove (1 + e)*m1/(m1 + m2) <= 2").expect("it parses");
//! proptest!(|(at in kept.clone())| {
//!     prop_assert_eq!(kept.holds(&at), Some(true));
//!     prop_assert!(at["m1"] > 0 && at["e"] <= 1);
//! });
//! ```
//!
//! A claim that held is not proved: [`Law::assured`] proves it where it can, and tries what it cannot prove. A claim that
//! failed is false: its hypotheses hold at the point for certain and its goal does not ([`carom_search::refute::trial`]).

use super::points::Values;
use carom_checker::claim::diagnostic::Diagnostic;
use carom_checker::claim::parse::parse;
use carom_checker::claim::print;
use carom_checker::claim::syntax::{Claim, Item, Prop, Relation};
use carom_exact::algebra::Moment;
use carom_search::judge::hand::AtHand;
use carom_search::judge::{self, Entry, contradiction, contradictory, judge, refuted};
use carom_search::refute::catalogue::{Catalogue, Limits};
use carom_search::refute::outcome::{Broken, Fault, Point, Verdict, Witness, limit_reached};
use carom_search::refute::points::Effort;
use carom_search::refute::trial::{Trial, Tried, Untried};
use std::time::Duration;

/// How a claim is tried.
#[derive(Clone, Debug)]
pub struct Settings {
    /// At how many random points, after those of an audit.
    pub cases: u32,
    /// The seed of the random numbers.
    pub seed: u64,
    /// The longest time for one claim.
    pub time: Duration,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings { cases: 256, seed: 0, time: Duration::from_secs(10) }
    }
}

/// What became of a claim.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// It held at so many points, and so many others left it open.
    Held {
        /// Where it certainly holds.
        points: usize,
        /// Where it is not decided.
        open: usize,
        /// Whether the time ended before all points were tried.
        late: bool,
    },
    /// It is false.
    Failed(Failure),
    /// No point decides it, and why.
    Untested(String),
    /// It makes no sense.
    Fault(Fault),
}

/// A counterexample.
#[derive(Clone, Debug)]
pub struct Failure {
    /// The point, as small as it could be made, and what fails there.
    pub witness: Witness,
    /// How it was found.
    pub found: Found,
}

/// How a counterexample was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    /// At the point of this number, from 1.
    At(usize),
    /// At a point that an earlier run saved.
    Saved,
    /// By an audit, where all points held: mostly its values are roots, which are not drawn at random.
    ByAudit,
}

/// A claim as a property.
#[derive(Clone, Debug)]
pub struct Law {
    claim: Claim,
}

/// A law from a claim as it stands in a file, or from its hypotheses and goal alone: what stands after the first line.
///
/// # Errors
/// Faults of the text.
pub fn law(text: &str) -> Result<Law, Vec<Diagnostic>> {
    let whole = text.lines().any(|line| line.starts_with("claim "));
    let mut claims = if whole { parse(text)? } else { parse(&format!("claim law \"\"\n{text}\n"))? };
    claims.pop().map(|claim| Law { claim }).ok_or_else(Vec::new)
}

/// What is known of a law.
#[derive(Clone, Debug)]
pub enum Assurance {
    /// It holds for all values: the kernel accepted a certificate, whose SHA-256 this is.
    Proved(String),
    /// There is no proof, and this came of trying it.
    Tried(Outcome),
}

impl Law {
    /// The claim.
    #[must_use]
    pub fn claim(&self) -> &Claim {
        &self.claim
    }

    /// Whether the goal holds at a point; `None` where that is left open.
    #[must_use]
    pub fn holds(&self, at: &Values) -> Option<bool> {
        at.holds
    }

    /// Tries the law at random points.
    #[must_use]
    pub fn tried(&self, settings: &Settings) -> Outcome {
        tried(&self.claim, settings, &AtHand::default(), &mut |_| {})
    }

    /// Proves the law, or tries it where no proof is found. What is proved is not tried.
    #[must_use]
    pub fn assured(&self, settings: &Settings) -> Assurance {
        let entry = audited(&self.claim, settings.time, &AtHand::default());
        match entry {
            Some(Entry { proof: Some(proof), outcome, .. }) if outcome.verdict == Verdict::Proved => {
                Assurance::Proved(proof.sha256)
            }
            entry => Assurance::Tried(match at_points(&self.claim, settings, &mut |_| {}) {
                held if is_no_failure(&held) => by_audit(entry).map_or(held, Outcome::Failed),
                outcome => outcome,
            }),
        }
    }
}

/// What an audit says of one claim; `None` where the claim is at fault or cites others.
fn audited(claim: &Claim, time: Duration, hand: &AtHand) -> Option<Entry> {
    let names = [claim.name.text.clone()];
    let catalogue = Catalogue::new(vec![claim.clone()]).ok()?;
    let settings = judge::Settings { limits: Limits { time, ..Limits::default() }, ..judge::Settings::default() };
    let found = judge(&catalogue, &names, hand, &settings, &|_| {});
    found.entries.into_iter().find_map(|(_, entry)| entry.ok())
}

/// The counterexample of an audit; without a point where the claim compares different dimensions.
fn by_audit(entry: Option<Entry>) -> Option<Failure> {
    let outcome = entry?.outcome;
    if outcome.verdict != Verdict::Refuted {
        return None;
    }
    let reason = outcome.reason.map(|statement| Broken { statement, left: String::new(), right: String::new() });
    let without_point = || reason.map(|reason| Witness { point: Point::default(), broken: vec![reason] });
    Some(Failure { witness: outcome.witness.or_else(without_point)?, found: Found::ByAudit })
}

/// Whether no point that was tried speaks against a claim that makes sense.
fn is_no_failure(outcome: &Outcome) -> bool {
    matches!(outcome, Outcome::Held { .. } | Outcome::Untested(_))
}

/// Tries a claim at the points of an audit, and at random points; `now` hears how many points are done. Where none fails, an
/// audit is asked for the time that is left, with the certificates at `hand`, so that no claim holds here which it refutes. The same seed gives the same points,
/// whatever else is tried.
pub fn tried(claim: &Claim, settings: &Settings, hand: &AtHand, now: &mut dyn FnMut(usize)) -> Outcome {
    let started = Moment::now();
    match at_points(claim, settings, now) {
        held if is_no_failure(&held) => {
            let left = settings.time.saturating_sub(started.elapsed());
            by_audit(audited(claim, left, hand)).map_or(held, Outcome::Failed)
        }
        outcome => outcome,
    }
}

/// Tries a claim again at the point of a counterexample that was saved: a claim with the point's values among its hypotheses.
/// `None` where the claim does not fail there any more.
pub fn again(claim: &Claim, saved: &Claim, settings: &Settings) -> Option<Failure> {
    let own: Vec<String> = assumed(claim).map(print::prop).collect();
    let values: Vec<&Prop> = assumed(saved).filter(|prop| !own.contains(&print::prop(prop))).collect();
    let point = values.iter().filter_map(|prop| match prop.single()? {
        (place, Relation::Equal, value) => Some((print::expr(place), print::expr(value))),
        _ => None,
    });
    let point = Point { values: point.collect() };
    let mut there = claim.clone();
    there.items.extend(values.into_iter().map(|prop| Item::Assume { label: None, prop: prop.clone() }));
    let witness = match at_points(&there, &Settings { cases: 1, ..settings.clone() }, &mut |_| {}) {
        Outcome::Failed(failure) => failure.witness,
        // Members of families are not drawn by their equations: the kernel is asked about the point itself.
        _ => {
            let limits = Limits { time: settings.time, ..Limits::default() };
            refuted::witness(claim, &refuted::certificate(claim, &point, &limits)?)
        }
    };
    Some(Failure { witness, found: Found::Saved })
}

/// The hypotheses of a claim.
fn assumed(claim: &Claim) -> impl Iterator<Item = &Prop> {
    claim.items.iter().filter_map(|item| match item {
        Item::Assume { prop, .. } => Some(prop),
        _ => None,
    })
}

/// Tries a claim at the points of an audit, and at random points.
fn at_points(claim: &Claim, settings: &Settings, now: &mut dyn FnMut(usize)) -> Outcome {
    let started = Moment::now();
    let limits = Limits { time: settings.time, ..Limits::default() };
    let mut trial = match Trial::new(claim) {
        Ok(trial) => trial,
        Err(Untried::Fault(fault)) => return Outcome::Fault(fault),
        Err(Untried::Limit(name)) => return Outcome::Untested(limit_reached(name)),
        Err(Untried::Moves) => {
            return Outcome::Untested(
                "a point says nothing of a derivative or limit whose variable is tied".to_owned(),
            );
        }
    };
    let deadline = started.checked_add(settings.time);
    let effort = Effort { first: None, deadline, random: settings.cases, seed: settings.seed };
    let mut number = 0;
    let Tried { witness, held: points, open, .. } = trial.tried(&effort, true, &mut || {
        number += 1;
        now(number);
    });
    if let Some(witness) = witness {
        return Outcome::Failed(Failure { witness, found: Found::At(number) });
    }
    let late = started.elapsed() > settings.time;
    match (points, open, late) {
        (0, _, true) => Outcome::Untested(limit_reached("time")),
        (0, 0, _) if contradictory(claim, &limits) => Outcome::Fault(contradiction(claim)),
        (0, 0, _) => Outcome::Untested("no point was found that satisfies all hypotheses".to_owned()),
        (0, _, _) => Outcome::Untested(format!("no comparison could be decided at {open} points")),
        _ => Outcome::Held { points, open, late },
    }
}
