//! Claims of the language as properties: tried at random exact points that satisfy their hypotheses.
//!
//! [`law`] reads a claim. The [`Law`] tries itself ([`Law::tried`]), and it is a strategy of proptest that draws points
//! where its hypotheses hold, for tests of your own code at such points:
//!
//! ```
//! use carom::property::law::{Outcome, Settings, law};
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
//! failed is false: its hypotheses hold at the point for certain and its goal does not ([`crate::refute::trial`]).

use super::points::Values;
use crate::algebra::Moment;
use crate::claim::diagnostic::Diagnostic;
use crate::claim::parse::parse;
use crate::claim::syntax::Claim;
use crate::judge::{contradiction, contradictory};
use crate::refute::catalogue::Limits;
use crate::refute::goal::Seen;
use crate::refute::outcome::{Fault, Witness, limit_reached};
use crate::refute::trial::{Trial, Untried};
use proptest::prelude::Rng;
use proptest::test_runner::{RngAlgorithm, TestRng};
use std::time::Duration;

/// One point in so many is a simple one, and they come first.
const SIMPLE: u32 = 4;

/// How a claim is tried.
#[derive(Clone, Debug)]
pub struct Settings {
    /// At how many points.
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
        points: u32,
        /// Where it is not decided.
        open: u32,
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
    pub found: u32,
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
#[cfg(feature = "report")]
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
    #[cfg(feature = "report")]
    #[must_use]
    pub fn assured(&self, settings: &Settings) -> Assurance {
        use crate::judge::{self, hand::AtHand};
        use crate::refute::catalogue::Catalogue;
        use crate::refute::outcome::Verdict;
        let names = [self.claim.name.text.clone()];
        let found = Catalogue::new(vec![self.claim.clone()]).ok().map(|catalogue| {
            let limits = Limits { time: settings.time, ..Limits::default() };
            let settings = judge::Settings { limits, ..judge::Settings::default() };
            judge::judge(&catalogue, &names, &AtHand::default(), &settings, &|_, _| {})
        });
        let entries = found.into_iter().flat_map(|found| found.entries);
        let entry = entries.filter_map(|(_, entry)| entry.ok()).find(|entry| entry.outcome.verdict == Verdict::Proved);
        match entry.and_then(|entry| entry.proof) {
            Some(proof) => Assurance::Proved(proof.sha256),
            None => Assurance::Tried(self.tried(settings)),
        }
    }
}

/// Tries a claim; `now` hears how many points are done. The same seed gives the same points, whatever else is tried.
pub fn tried(claim: &Claim, settings: &Settings, now: &mut dyn FnMut(u32)) -> Outcome {
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
    let mut random = generator(&claim.name.text, settings.seed);
    // The bias is far below what a test could notice.
    let mut below = |bound: u64| random.next_u64() % bound.max(1);
    let simple = trial.simple(usize::try_from(settings.cases.div_ceil(SIMPLE)).unwrap_or(usize::MAX));
    let mut simple = simple.into_iter();
    let (mut points, mut open) = (0, 0);
    for number in 1..=settings.cases {
        now(number - 1);
        if started.elapsed() > settings.time {
            break;
        }
        let Some(choice) = simple.next().or_else(|| trial.random(&mut below)) else { continue };
        match trial.at(&choice) {
            Some((Seen::Holds, _)) => points += 1,
            Some((Seen::Open, _)) => open += 1,
            None => {}
            Some((Seen::Fails(_), _)) => {
                if let Some(witness) = trial.smallest(choice) {
                    return Outcome::Failed(Failure { witness, found: number });
                }
            }
        }
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

/// Random numbers of their own for each claim.
fn generator(id: &str, seed: u64) -> TestRng {
    // FNV-1a: any mixing will do, as long as it never changes.
    let mix = |start: u64| id.bytes().fold(start, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3));
    let words = [seed, mix(0xcbf2_9ce4_8422_2325), mix(seed), seed.rotate_left(32)];
    let mut bytes = [0; 32];
    for (place, byte) in words.iter().flat_map(|word| word.to_le_bytes()).enumerate() {
        bytes[place] = byte;
    }
    TestRng::from_seed(RngAlgorithm::ChaCha, &bytes)
}
