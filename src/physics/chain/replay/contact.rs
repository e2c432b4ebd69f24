//! What may come of a contact of three or more bodies at one instant: every order, tried.
//!
//! Contract: from the velocities of a cluster of touching points, all sequences of collisions of approaching
//! neighbours are followed until nothing approaches. Sequences that reach the same velocities are one outcome;
//! the first found stands for it. Limits: [`MAX_STATES`] states in all and [`MAX_DEPTH`] collisions in one
//! sequence; what was cut off is said.
//!
//! [`agreed`] answers whether the order matters: not, where every sequence ends with the same velocities after equally many
//! collisions. For elastic bodies of one mass, at most one elastic wall among them, that is so without a search: a collision
//! exchanges two velocities, or turns one round at the wall. Orders that sort the same list meet in the sorted one, each after
//! as many exchanges as the list has inversions, counted with the mirror images behind the wall.

use super::line::{Line, Pair};
use malachite::Rational;
use malachite::base::num::basic::traits::One;
use std::collections::HashMap;

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

/// What was found, and whether sequences of different lengths lead to one state.
#[derive(Default)]
struct Explored {
    found: ContactOutcomes,
    uneven: bool,
}

/// All outcomes of the cluster of points `first ..= last` with these velocities (of all points of the line).
pub(super) fn outcomes(line: &Line, v: &[Rational], first: usize, last: usize) -> ContactOutcomes {
    explore(line, v, (first, last), |_| false).found
}

/// An order of collisions of the cluster, where all orders agree in the velocities after it and in their number.
pub(super) fn agreed(line: &Line, v: &[Rational], first: usize, last: usize) -> Option<Vec<usize>> {
    if exchanges(line, first, last) {
        return sorted(&line.pairs[first..last], v[first..=last].to_vec(), first);
    }
    let open = |so_far: &Explored| so_far.uneven || so_far.found.cut || so_far.found.outcomes.len() > 1;
    let Explored { found, uneven } = explore(line, v, (first, last), open);
    match found.outcomes.as_slice() {
        [one] if !uneven && !found.cut => Some(one.order.iter().map(|pair| pair - line.first).collect()),
        _ => None,
    }
}

/// Whether every collision of the cluster exchanges two velocities or turns one round, with a wall at one side at most.
fn exchanges(line: &Line, first: usize, last: usize) -> bool {
    let points = &line.points[first..=last];
    let mut masses = points.iter().filter_map(|point| point.mass.as_ref());
    let one = masses.next();
    let walls = points.iter().filter(|point| point.mass.is_none()).count();
    walls <= 1
        && masses.all(|mass| Some(mass) == one)
        && line.pairs[first..last].iter().all(|p| p.restitution == Rational::ONE)
}

/// The order that collides the leftmost pair that approaches, again and again; `None` beyond [`MAX_STATES`] collisions.
fn sorted(pairs: &[Pair], mut v: Vec<Rational>, first: usize) -> Option<Vec<usize>> {
    let (mut order, mut at) = (Vec::new(), 0);
    while at + 1 < v.len() {
        if v[at] > v[at + 1] {
            if order.len() >= MAX_STATES {
                return None;
            }
            collide(&pairs[at], &mut v, at);
            order.push(first + at);
            at = at.saturating_sub(1);
        } else {
            at += 1;
        }
    }
    Some(order)
}

/// The velocities after the collision of points `at` and `at + 1`.
fn collide(pair: &Pair, v: &mut [Rational], at: usize) {
    let speed = &v[at] - &v[at + 1];
    v[at] -= &pair.left * &speed;
    v[at + 1] += &pair.right * speed;
}

/// Follows all sequences until they end, or until enough is known.
fn explore(line: &Line, v: &[Rational], (first, last): (usize, usize), enough: impl Fn(&Explored) -> bool) -> Explored {
    let mut explored = Explored::default();
    let mut seen: HashMap<Vec<Rational>, usize> = HashMap::new();
    let mut open: Vec<(Vec<Rational>, Vec<usize>)> = vec![(v[first..=last].to_vec(), Vec::new())];
    while let Some((state, order)) = open.pop() {
        if enough(&explored) {
            break;
        }
        let Explored { found, uneven } = &mut explored;
        if seen.len() >= MAX_STATES {
            found.cut = true;
            break;
        }
        if let Some(length) = seen.get(&state) {
            *uneven |= *length != order.len();
            continue;
        }
        seen.insert(state.clone(), order.len());
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
            let mut after = state.clone();
            collide(&line.pairs[first + i], &mut after, i);
            let mut longer = order.clone();
            longer.push(first + i + line.first);
            open.push((after, longer));
        }
    }
    explored
}
