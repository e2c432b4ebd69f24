//! Worksheets for teaching: what each collision of a pass does to masses, velocities, momenta and energies.
//!
//! **Contract.** Every entry is a real number that can be printed to any number of correct digits, exact where
//! it is rational. Totals obey the laws exactly: the total momentum does not change, and the total energy
//! changes by the loss of the collision.

use crate::chain::optimum::Optimum;
use crate::chain::pass::Pass;
use crate::chain::{ChainError, Restitutions, recollision};
use crate::number::NumberError;
use crate::number::interval::Interval;
use crate::number::real::Real;
use crate::scene::{Chain, Inserted, Start};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Two, Zero};
use std::sync::Arc;

/// The most collisions of a worksheet.
pub const MAX_COLLISIONS: u64 = 1_000;

/// A number that several entries are made of.
type Shared = Arc<Real>;

/// One quantity of a body, or of both.
#[derive(Clone, Debug)]
pub struct Change {
    /// Before the collision.
    pub before: Shared,
    /// After it.
    pub after: Shared,
    /// After minus before.
    pub change: Shared,
}

/// What a collision does to a body.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its number, from 1.
    pub number: u64,
    /// Its mass.
    pub mass: Shared,
    /// Its velocity.
    pub velocity: Change,
    /// Its momentum.
    pub momentum: Change,
    /// Its kinetic energy.
    pub energy: Change,
}

/// A collision.
#[derive(Clone, Debug)]
pub struct Collision {
    /// The coefficient of restitution.
    pub e: Rational,
    /// The body that strikes and the body that is struck.
    pub bodies: [Body; 2],
    /// The momentum of both.
    pub momentum: Change,
    /// The kinetic energy of both.
    pub energy: Change,
}

/// All collisions of a pass.
#[derive(Clone, Debug)]
pub struct Worksheet {
    /// The collisions in order.
    pub collisions: Vec<Collision>,
    /// Whether bodies meet again after the pass.
    pub again: bool,
}

impl Worksheet {
    /// The worksheet of a chain without measured inputs.
    ///
    /// # Errors
    /// [`ChainError::Measured`]; a pass in which a collision does not take place; more than [`MAX_COLLISIONS`].
    pub fn of(chain: &Chain) -> Result<Worksheet, ChainError> {
        if !chain.is_exact() {
            return Err(ChainError::Measured { quantity: "a worksheet or picture of velocities" });
        }
        let count = chain.count().saturating_add(1);
        if count > MAX_COLLISIONS {
            let needed = count.to_string();
            let limit = "collisions of a worksheet or picture";
            return Err(NumberError::LimitReached { limit, allowed: MAX_COLLISIONS, needed }.into());
        }
        let restitutions = chain.restitutions().0;
        match (chain.inserted(), chain.start()) {
            (Inserted::Given(_), start) => {
                let masses: Vec<_> = chain.masses().unwrap_or_default().iter().map(|m| m.lo().clone()).collect();
                let pass = match start {
                    Start::Speed(speed) => Pass::from_rest(masses, restitutions.clone(), speed.clone())?,
                    Start::Velocities(list) => Pass::new(masses, restitutions.clone(), list.clone())?,
                };
                of_pass(&pass, &restitutions)
            }
            (Inserted::Optimal(n), Start::Speed(speed)) if *speed > Rational::ZERO => {
                let (first, last) = (chain.first().lo().clone(), chain.last().lo().clone());
                of_optimum(&Optimum::new(first, last, *n, restitutions)?, speed)
            }
            (Inserted::Optimal(_), _) => Err(ChainError::NotAtRest),
        }
    }
}

fn exact(x: &Rational) -> Shared {
    Arc::new(Real::rational(x.clone()))
}

fn of_pass(pass: &Pass, restitutions: &Restitutions) -> Result<Worksheet, ChainError> {
    let mut collisions = Vec::new();
    for (i, (found, pair)) in pass.collisions()?.iter().zip(pass.masses().windows(2)).enumerate() {
        let ([m1, m2], Some(e)) = (pair, restitutions.at(i as u64)) else { continue };
        let velocities = [[&found.before.0, &found.after.0], [&found.before.1, &found.after.1]];
        let velocities = velocities.map(|pair| pair.map(exact));
        collisions.push(collision(i as u64, e.value(), [exact(m1.value()), exact(m2.value())], velocities));
    }
    Ok(Worksheet { collisions, again: recollision::of_velocities(&pass.velocities_after()?) })
}

fn of_optimum(optimum: &Optimum, speed: &Rational) -> Result<Worksheet, ChainError> {
    let mut collisions = Vec::new();
    for i in 0..optimum.collisions() {
        let Some(e) = optimum.restitutions().at(i) else { continue };
        let masses = [i, i + 1].map(|i| Arc::new(optimum.mass(i)));
        let struck = [exact(&Rational::ZERO), Arc::new(optimum.arrival(i + 1, speed))];
        let velocities = [[Arc::new(optimum.arrival(i, speed)), Arc::new(optimum.velocity(i, speed))], struck];
        let mut found = collision(i, e.value(), masses, velocities);
        known_energies(&mut found, optimum, i, speed);
        collisions.push(found);
    }
    Ok(Worksheet { collisions, again: recollision::of_optimum(optimum)?.0 })
}

/// Puts in the energies that enclosures cannot tell to be rational: a rational number on the edge between two decimals
/// would be enclosed more and more narrowly for ever.
///
/// All other entries of a chain with irrational `x` are irrational, or products of rational ones (lemma in
/// [`crate::chain`]): up to rational factors and powers of `x`, momenta are `1/(1 + x)^j` or `(x − e)/(1 + x)^j`, and energies
/// their products with velocities.
fn known_energies(found: &mut Collision, optimum: &Optimum, i: u64, speed: &Rational) {
    let loss = optimum.loss(i + 1, speed);
    if loss.as_rational() == Some(&Rational::ZERO) {
        found.energy.after = found.energy.before.clone();
    } else {
        if let Some(after) = optimum.rational_energy_after(i, speed) {
            found.energy.after = exact(&after);
        }
        if let Some(change) = optimum.rational_energy_change(i, speed) {
            found.bodies[0].energy.change = exact(&change);
        }
    }
    found.energy.change = scaled(&Arc::new(loss), &-Rational::ONE);
}

/// The entries of one collision.
fn collision(i: u64, e: &Rational, masses: [Shared; 2], velocities: [[Shared; 2]; 2]) -> Collision {
    let [m1, m2] = masses;
    let [first, second] = velocities;
    let bodies = [body(i + 1, m1, first), body(i + 2, m2, second)];
    let [a, b] = &bodies;
    let momentum = sum(&a.momentum.before, &b.momentum.before);
    let before = sum(&a.energy.before, &b.energy.before);
    let change = sum(&a.energy.change, &b.energy.change);
    let energy = Change { after: sum(&a.energy.after, &b.energy.after), before, change };
    let momentum = Change { before: momentum.clone(), after: momentum, change: exact(&Rational::ZERO) };
    Collision { e: e.clone(), momentum, energy, bodies }
}

fn body(number: u64, mass: Shared, [before, after]: [Shared; 2]) -> Body {
    let momentum = [&before, &after].map(|v| product(&mass, v));
    let half = Rational::ONE / Rational::TWO;
    let energy = [&before, &after].map(|v| scaled(&product(&mass, &product(v, v)), &half));
    let change =
        |[before, after]: [Shared; 2]| Change { change: sum(&after, &scaled(&before, &-Rational::ONE)), before, after };
    Body { number, velocity: change([before, after]), momentum: change(momentum), energy: change(energy), mass }
}

fn product(a: &Shared, b: &Shared) -> Shared {
    if [a, b].iter().any(|x| x.as_rational() == Some(&Rational::ZERO)) {
        return exact(&Rational::ZERO);
    }
    combined(a, b, |a, b| a * b, |a, b, bits| a.multiply(b, bits))
}

fn sum(a: &Shared, b: &Shared) -> Shared {
    for (x, other) in [(a, b), (b, a)] {
        if x.as_rational() == Some(&Rational::ZERO) {
            return other.clone();
        }
    }
    combined(a, b, |a, b| a + b, |a, b, bits| a.add(b, bits))
}

fn scaled(a: &Shared, by: &Rational) -> Shared {
    product(a, &exact(by))
}

/// Exact where both are; else enclosed.
fn combined(
    a: &Shared,
    b: &Shared,
    exactly: impl Fn(&Rational, &Rational) -> Rational,
    enclosed: impl Fn(&Interval, &Interval, u64) -> Interval + Send + Sync + 'static,
) -> Shared {
    if let (Some(a), Some(b)) = (a.as_rational(), b.as_rational()) {
        return Arc::new(Real::rational(exactly(a, b)));
    }
    let (a, b) = (a.clone(), b.clone());
    Arc::new(Real::enclosed(move |bits| enclosed(&a.enclosure(bits + 8), &b.enclosure(bits + 8), bits + 4)))
}
