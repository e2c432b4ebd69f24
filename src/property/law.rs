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
use carom_checker::claim::syntax::Claim;
use carom_exact::algebra::Moment;
use carom_search::judge::{contradiction, contradictory};
use carom_search::refute::catalogue::Limits;
use carom_search::refute::outcome::{Fault, Witness, limit_reached};
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
    /// The number of the point at which it failed first, from 1.
    pub found: usize,
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
        tried(&self.claim, settings, &mut |_| {})
    }

    /// Proves the law, or tries it where no proof is found. What is proved is not tried.
    #[must_use]
    pub fn assured(&self, settings: &Settings) -> Assurance {
        use carom_search::judge::{self, hand::AtHand};
        use carom_search::refute::catalogue::Catalogue;
        use carom_search::refute::outcome::Verdict;
        let names = [self.claim.name.text.clone()];
        let found = Catalogue::new(vec![self.claim.clone()]).ok().map(|catalogue| {
            let limits = Limits { time: settings.time, ..Limits::default() };
            let settings = judge::Settings { limits, ..judge::Settings::default() };
            judge::judge(&catalogue, &names, &AtHand::default(), &settings, &|_| {})
        });
        let entries = found.into_iter().flat_map(|found| found.entries);
        let entry = entries.filter_map(|(_, entry)| entry.ok()).find(|entry| entry.outcome.verdict == Verdict::Proved);
        match entry.and_then(|entry| entry.proof) {
            Some(proof) => Assurance::Proved(proof.sha256),
            None => Assurance::Tried(self.tried(settings)),
        }
    }
}

/// Tries a claim at the points of an audit, and at random points; `now` hears how many points are done. The same seed gives
/// the same points, whatever else is tried.
pub fn tried(claim: &Claim, settings: &Settings, now: &mut dyn FnMut(usize)) -> Outcome {
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
        return Outcome::Failed(Failure { witness, found: number });
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
