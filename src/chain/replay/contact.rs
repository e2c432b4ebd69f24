//! What may come of a contact of three or more bodies at one instant: every order, tried.
//!
//! Contract: from the velocities of a cluster of touching points, all sequences of collisions of approaching
//! neighbours are followed until nothing approaches. Sequences that reach the same velocities are one outcome;
//! the first found stands for it. Limits: [`MAX_STATES`] states in all and [`MAX_DEPTH`] collisions in one
//! sequence; what was cut off is said.

use super::line::Line;
use malachite::Rational;
use std::collections::HashSet;

/// The most states that are followed.
const MAX_STATES: usize = 20_000;

/// The most collisions of one sequence.
pub(crate) const MAX_DEPTH: usize = 200;

/// One possible end of a contact.
#[derive(Clone, Debug)]
pub struct ContactOutcome {
    /// The pairs in the order in which they collide, each shown by its left point.
    pub order: Vec<usize>,
    /// The velocities of the cluster after that.
    pub velocities: Vec<Rational>,
}

/// The outcomes of a contact.
#[derive(Clone, Debug, Default)]
pub struct ContactOutcomes {
    /// Those found, each with other velocities.
    pub outcomes: Vec<ContactOutcome>,
    /// Whether a limit cut some sequences off.
    pub cut: bool,
}

/// All outcomes of the cluster of points `first ..= last` with these velocities (of all points of the line).
pub(super) fn outcomes(line: &Line, v: &[Rational], first: usize, last: usize) -> ContactOutcomes {
    let mut found = ContactOutcomes::default();
    let mut seen: HashSet<Vec<Rational>> = HashSet::new();
    let mut open: Vec<(Vec<Rational>, Vec<usize>)> = vec![(v[first..=last].to_vec(), Vec::new())];
    while let Some((state, order)) = open.pop() {
        if seen.len() >= MAX_STATES {
            found.cut = true;
            break;
        }
        if !seen.insert(state.clone()) {
            continue;
        }
        let approaching: Vec<usize> = (0..last - first).filter(|i| state[*i] > state[i + 1]).collect();
        if approaching.is_empty() {
            found.outcomes.push(ContactOutcome { order, velocities: state });
            continue;
        }
        if order.len() >= MAX_DEPTH {
            found.cut = true;
            continue;
        }
        for i in approaching.into_iter().rev() {
            let pair = &line.pairs[first + i];
            let speed = &state[i] - &state[i + 1];
            let mut after = state.clone();
            after[i] -= &pair.left * &speed;
            after[i + 1] += &pair.right * speed;
            let mut longer = order.clone();
            longer.push(first + i + line.first);
            open.push((after, longer));
        }
    }
    found
}
