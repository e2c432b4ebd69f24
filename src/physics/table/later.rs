//! What comes after the pass of a worksheet: the bodies that meet again, replayed.
//!
//! **Contract.** [`Later`] is the replay of the worksheet's chain with gaps that make the pass come first: each gap is
//! [`Later::gaps`] times the one before it, for the first number of `GAPS` that does. Its velocities are final: no body is
//! faster than the one before it. There is none for more than [`MAX_BODIES`] bodies, for numbers that are not rational, and
//! where no such gaps are found.

use crate::chain::replay::{Body, Line, Options, Outcome, Status, replay};
use crate::chain::{Positive, Restitution};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::Zero;

/// The most bodies of a chain that is replayed.
pub const MAX_BODIES: usize = 8;
/// The most collisions that are replayed.
const MAX_EVENTS: u64 = 2_000;
/// A gap over the one before it, as fractions: what is tried.
const GAPS: [(u32, u32); 5] = [(1, 1), (1, 10), (1, 1000), (10, 1), (1000, 1)];

/// The collisions after a pass.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Later {
    /// Each gap between neighbours over the one before it.
    pub gaps: Rational,
    /// The pairs that collide, each by its left body, from 1; `None` where they are infinitely many.
    pub pairs: Option<Vec<usize>>,
    /// The final velocities.
    pub velocities: Vec<Rational>,
}

/// What follows the pass along a chain.
#[must_use]
pub fn later(masses: &[Positive], coefficients: &[Restitution], before: &[Rational]) -> Option<Later> {
    if masses.len() > MAX_BODIES {
        return None;
    }
    GAPS.into_iter().find_map(|(above, below)| {
        let gaps = Rational::from_unsigneds(above, below);
        let outcome = replayed(masses, coefficients, before, &gaps)?;
        let collisions = masses.len() - 1;
        let first = outcome.events.get(..collisions)?;
        let passes = first.iter().zip(1..).all(|(event, pair)| event.pair == pair);
        let joins_later = outcome.joined.iter().all(|joined| joined.after >= collisions as u64);
        if !passes || !joins_later || !matches!(outcome.status, Status::Complete) {
            return None;
        }
        let finite = outcome.joins == 0 && outcome.count == outcome.events.len() as u64;
        let velocities = outcome.velocities.iter().map(|v| v.rational().cloned()).collect::<Option<_>>()?;
        let pairs = finite.then(|| outcome.events[collisions..].iter().map(|event| event.pair).collect());
        Some(Later { gaps, pairs, velocities })
    })
}

fn replayed(
    masses: &[Positive],
    coefficients: &[Restitution],
    before: &[Rational],
    gaps: &Rational,
) -> Option<Outcome> {
    let mut position = Rational::ZERO;
    let bodies: Vec<Body> = (0_u64..)
        .zip(masses.iter().zip(before))
        .map(|(place, (mass, velocity))| {
            let here = position.clone();
            position += gaps.pow(place);
            Body { mass: mass.value().clone(), position: here, velocity: velocity.clone(), length: Rational::ZERO }
        })
        .collect();
    let restitutions: Vec<Rational> = coefficients.iter().map(|e| e.value().clone()).collect();
    let line = Line::new(&bodies, &restitutions, None, None).ok()?;
    let options = Options { max_events: MAX_EVENTS, through_collapse: true, ..Options::default() };
    replay(&line, &options).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::rational::parse;
    use malachite::base::num::basic::traits::One;

    fn found(masses: &[&str], e: &str, before: &[i32]) -> Option<Later> {
        let number = |text: &str| parse(text).expect("a number");
        let masses: Vec<Positive> = masses.iter().map(|m| Positive::new(number(m)).expect("a mass")).collect();
        let e = vec![Restitution::new(number(e)).expect("a restitution"); masses.len() - 1];
        later(&masses, &e, &before.iter().map(|v| Rational::from(*v)).collect::<Vec<_>>())
    }

    #[test]
    fn no_body_is_left_behind_one_that_is_slower() {
        let cars = found(&["3", "2", "1", "1"], "1/4", &[8, 0, 0, 0]).expect("a replay");
        assert!(cars.velocities.windows(2).all(|pair| pair[0] <= pair[1]), "{cars:?}");
        assert!(cars.pairs.as_ref().is_none_or(|pairs| !pairs.is_empty()), "{cars:?}");
    }

    #[test]
    fn gaps_are_such_that_the_pass_comes_first() {
        // At equal gaps, bodies 2 and 3 would meet before 1 and 2 do.
        let row = found(&["1", "1", "1"], "1", &[3, 2, 0]).expect("a replay");
        assert_ne!(row.gaps, Rational::ONE);
        assert_eq!(row.pairs, Some(vec![1]));
        assert_eq!(row.velocities, [0, 2, 3].map(Rational::from));
        assert_eq!(found(&["1"; 9], "1/2", &[1, 0, 0, 0, 0, 0, 0, 0, 0]), None, "too many bodies");
    }
}
