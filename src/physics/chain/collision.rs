//! One collision of two bodies: Ricardo & Lee (2015), (1)–(9).
//!
//! Everything is exact. `e` is the coefficient of restitution, `v1`, `v2` the velocities before.

use super::{Positive, Restitution};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Square;
use malachite::base::num::basic::traits::{One, Two, Zero};

/// The velocities after the collision, (5) and (6).
#[must_use]
pub fn velocities_after(
    m1: &Positive,
    m2: &Positive,
    e: &Restitution,
    v1: &Rational,
    v2: &Rational,
) -> (Rational, Rational) {
    let (m1, m2) = (m1.value(), m2.value());
    // As seen by the second body, which may be at rest. In a long chain the approach alone is a long number, and the
    // factors of the masses are short: no operation costs more than a pass over its digits.
    let approach = v1 - v2;
    let push = e.plus_one() / (m1 + m2);
    let (kept, given) = (Rational::ONE - m2 * &push, m1 * push);
    (v2 + &approach * kept, v2 + approach * given)
}

/// The transfer matrix, (7): velocities after = matrix · velocities before.
#[must_use]
pub fn matrix(m1: &Positive, m2: &Positive, e: &Restitution) -> [[Rational; 2]; 2] {
    let (m1, m2) = (m1.value(), m2.value());
    let total = m1 + m2;
    let up = e.plus_one();
    let e = e.value();
    [[(m1 - e * m2) / &total, m2 * &up / &total], [m1 * up / &total, (m2 - e * m1) / total]]
}

/// The coefficient of restitution that two pairs of velocities show, (4); `None` for `v1 = v2`.
#[must_use]
pub fn restitution(v1: &Rational, v2: &Rational, v1_after: &Rational, v2_after: &Rational) -> Option<Rational> {
    let before = v2 - v1;
    (before != Rational::ZERO).then(|| (v1_after - v2_after) / before)
}

/// The kinetic energy lost, `m1·m2·(1 − e²)·(v1 − v2)²/(2(m1 + m2))`.
#[must_use]
pub fn loss(m1: &Positive, m2: &Positive, e: &Restitution, v1: &Rational, v2: &Rational) -> Rational {
    let (m1, m2) = (m1.value(), m2.value());
    let share = Rational::ONE - e.value().square();
    m1 * m2 * share * (v1 - v2).square() / (Rational::TWO * (m1 + m2))
}

/// `m·v²/2`.
#[must_use]
pub fn kinetic_energy(m: &Positive, v: &Rational) -> Rational {
    m.value() * v.square() / Rational::TWO
}

/// The fraction of the kinetic energy that a body at rest receives, (8) and (9).
#[must_use]
pub fn transfer(m1: &Positive, m2: &Positive, e: &Restitution) -> Rational {
    let (m1, m2) = (m1.value(), m2.value());
    (e.plus_one() / (m1 + m2)).square() * m1 * m2
}
