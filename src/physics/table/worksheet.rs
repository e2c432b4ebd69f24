//! Worksheets for teaching: what each collision of a pass does to masses, velocities, momenta and energies.
//!
//! **Contract.** Every entry is a real number that can be printed to any number of correct digits, exact where
//! it is rational; or, where inputs are measured, a range that holds all its values. Totals obey the laws exactly: the
//! total momentum does not change, and the total energy changes by the loss of the collision.
//!
//! Measured inputs are the matter of `measured`.

use crate::chain::optimum::Optimum;
use crate::chain::pass::Pass;
use crate::chain::uncertain::Range;
use crate::chain::{ChainError, Restitution, Restitutions, recollision};
use crate::number::NumberError;
use crate::number::interval::Interval;
use crate::number::real::Real;
use crate::scene::drop::Drop;
use crate::scene::{Chain, Inserted, Start};
use crate::table::later::{Later, later};
use crate::table::measured::{self, Frame};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Two, Zero};
use std::cmp::Ordering;
use std::sync::Arc;

/// The most collisions of a worksheet.
pub const MAX_COLLISIONS: u64 = 1_000;
/// Bits of an enclosure by which two irrational entries are compared.
pub(super) const BITS: u64 = 192;

/// A number that several entries are made of.
type Shared = Arc<Real>;

/// What stands in a cell.
#[derive(Clone, Debug)]
pub enum Entry {
    /// A number.
    Number(Shared),
    /// All values over a box of measured inputs.
    Between(Range<Rational>),
}

impl Entry {
    /// A rational number.
    #[must_use]
    pub fn exact(x: &Rational) -> Entry {
        Entry::Number(exact(x))
    }

    /// A range; a number where its ends are equal.
    #[must_use]
    pub fn range(range: Range<Rational>) -> Entry {
        range.single().map(Entry::exact).unwrap_or(Entry::Between(range))
    }

    /// Rational bounds: the number itself, or a narrow enclosure, or the ends of the range.
    #[must_use]
    pub fn bounds(&self) -> Option<(Rational, Rational)> {
        match self {
            Entry::Between(range) => Some((range.lo().clone(), range.hi().clone())),
            Entry::Number(x) => x.as_rational().map(|x| (x.clone(), x.clone())).or_else(|| {
                let enclosure = x.enclosure(BITS);
                let end = |(mantissa, power)| Rational::from(mantissa) * Rational::TWO.pow(power);
                let end = |found: Option<(malachite::Integer, i64)>| found.map(end);
                Some((end(enclosure.lower())?, end(enclosure.upper())?))
            }),
        }
    }

    /// Which of two entries is greater, whatever the inputs; `None` where that depends, or where enclosures cannot tell.
    #[must_use]
    pub fn compared(&self, other: &Entry) -> Option<Ordering> {
        let ((a, b), (c, d)) = (self.bounds()?, other.bounds()?);
        match (b.cmp(&c), a.cmp(&d)) {
            (Ordering::Less, _) => Some(Ordering::Less),
            (_, Ordering::Greater) => Some(Ordering::Greater),
            (Ordering::Equal, Ordering::Equal) => Some(Ordering::Equal),
            _ => None,
        }
    }

    /// The entry with its sign changed.
    #[must_use]
    pub fn negated(&self) -> Entry {
        let minus = -Rational::ONE;
        match self {
            Entry::Number(x) => Entry::Number(scaled(x, &minus)),
            Entry::Between(range) => Entry::range(range.scaled(&minus)),
        }
    }

    /// The sum of two entries.
    #[must_use]
    pub fn plus(&self, other: &Entry) -> Entry {
        match (self, other) {
            (Entry::Number(a), Entry::Number(b)) => Entry::Number(sum(a, b)),
            // Bounds of finite numbers are there.
            _ => match (self.bounds(), other.bounds()) {
                (Some((a, b)), Some((c, d))) => Range::new(a + c, b + d).map_or_else(|_| self.clone(), Entry::range),
                _ => self.clone(),
            },
        }
    }
}

/// One quantity of a body, or of both.
#[derive(Clone, Debug)]
pub struct Change {
    /// Before the collision.
    pub before: Entry,
    /// After it.
    pub after: Entry,
    /// After minus before.
    pub change: Entry,
}

/// What a collision does to a body.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its number, from 1.
    pub number: u64,
    /// Its mass.
    pub mass: Entry,
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
    pub e: Entry,
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
    /// Whether bodies meet again after the pass; `None` where that depends on measured inputs.
    pub again: Option<bool>,
    /// What happens then, where it is known.
    pub later: Option<Later>,
}

impl Worksheet {
    /// The worksheet of a chain.
    ///
    /// # Errors
    /// [`ChainError::Measured`] for measured inputs with optimal masses or with velocities of their own; a pass in which a
    /// collision does not take place; more than [`MAX_COLLISIONS`].
    pub fn of(chain: &Chain) -> Result<Worksheet, ChainError> {
        limit(chain.count().saturating_add(1))?;
        if !chain.is_exact() {
            let (Some(masses), Start::Speed(speed)) = (chain.masses(), chain.start()) else {
                return Err(ChainError::Measured { quantity: MEASURED });
            };
            let frame = Frame { speed: Range::point(speed.clone()), shift: Rational::ZERO };
            return measured::worksheet(&masses, chain.coefficients(), &frame);
        }
        let restitutions = chain.restitutions().0;
        match (chain.inserted(), chain.start()) {
            (Inserted::Given(_), start) => {
                let masses: Vec<_> = chain.masses().unwrap_or_default().iter().map(|m| m.lo().clone()).collect();
                let pass = match start {
                    Start::Speed(speed) => Pass::from_rest(masses, restitutions.clone(), speed.clone())?,
                    Start::Velocities(list) => Pass::new(masses, restitutions.clone(), list.clone())?,
                };
                let mut found = of_pass(&pass, &restitutions)?;
                if found.again == Some(true) {
                    let each: Vec<Restitution> =
                        (0..found.collisions.len() as u64).filter_map(|i| restitutions.at(i).cloned()).collect();
                    found.later = later(pass.masses(), &each, pass.velocities_before());
                }
                Ok(found)
            }
            (Inserted::Optimal(n), Start::Speed(speed)) if *speed > Rational::ZERO => {
                let (first, last) = (chain.first().lo().clone(), chain.last().lo().clone());
                of_optimum(&Optimum::new(first, last, *n, restitutions)?, speed)
            }
            (Inserted::Optimal(_), _) => Err(ChainError::NotAtRest),
        }
    }

    /// The worksheet of balls that are dropped together: velocities upwards, in units of the speed at the floor.
    ///
    /// # Errors
    /// As [`Worksheet::of`].
    pub fn of_drop(drop: &Drop) -> Result<Worksheet, ChainError> {
        limit(drop.masses().len() as u64)?;
        if let Some((masses, restitutions, floor)) = drop.exact() {
            let mut before = vec![-Rational::ONE; masses.len()];
            before[0] = floor.value().clone();
            return of_pass(&Pass::new(masses, restitutions.clone(), before)?, &restitutions);
        }
        let frame = Frame { speed: drop.approach(), shift: -Rational::ONE };
        measured::worksheet(drop.masses(), drop.coefficients(), &frame)
    }

    /// The velocity of each body after all collisions, those after the pass included; `None` where they are not known.
    #[must_use]
    pub fn last_velocities(&self) -> Option<Vec<Entry>> {
        match (&self.later, self.again) {
            (Some(later), _) => Some(later.velocities.iter().map(Entry::exact).collect()),
            (None, Some(false)) => Some(self.velocities().into_iter().cloned().collect()),
            (None, _) => None,
        }
    }

    /// The velocity of each body after the pass.
    #[must_use]
    pub fn velocities(&self) -> Vec<&Entry> {
        let last = self.collisions.last().map(|c| &c.bodies[1].velocity.after);
        self.collisions.iter().map(|c| &c.bodies[0].velocity.after).chain(last).collect()
    }
}

/// What a worksheet or a picture of velocities does not take.
pub(super) const MEASURED: &str =
    "a worksheet or picture of velocities of optimal masses, or of velocities of all bodies,";

fn limit(collisions: u64) -> Result<(), ChainError> {
    if collisions > MAX_COLLISIONS {
        let limit = "collisions of a worksheet or picture";
        return Err(NumberError::LimitReached { limit, allowed: MAX_COLLISIONS, needed: collisions.to_string() }.into());
    }
    Ok(())
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
        collisions.push(collision(
            i as u64,
            Entry::exact(e.value()),
            [exact(m1.value()), exact(m2.value())],
            velocities,
        ));
    }
    Ok(Worksheet { collisions, again: Some(recollision::of_velocities(&pass.velocities_after()?)), later: None })
}

fn of_optimum(optimum: &Optimum, speed: &Rational) -> Result<Worksheet, ChainError> {
    let mut collisions = Vec::new();
    for i in 0..optimum.collisions() {
        let Some(e) = optimum.restitutions().at(i) else { continue };
        let masses = [i, i + 1].map(|i| Arc::new(optimum.mass(i)));
        let struck = [exact(&Rational::ZERO), Arc::new(optimum.arrival(i + 1, speed))];
        let velocities = [[Arc::new(optimum.arrival(i, speed)), Arc::new(optimum.velocity(i, speed))], struck];
        let mut found = collision(i, Entry::exact(e.value()), masses, velocities);
        known_energies(&mut found, optimum, i, speed);
        collisions.push(found);
    }
    Ok(Worksheet { collisions, again: Some(recollision::of_optimum(optimum)?.0), later: None })
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
            found.energy.after = Entry::exact(&after);
        }
        if let Some(change) = optimum.rational_energy_change(i, speed) {
            found.bodies[0].energy.change = Entry::exact(&change);
        }
    }
    found.energy.change = Entry::Number(scaled(&Arc::new(loss), &-Rational::ONE));
}

fn scaled(x: &Shared, by: &Rational) -> Shared {
    product(x, &exact(by))
}

fn kinetic(m: &Shared, v: &Shared) -> Shared {
    scaled(&product(m, &product(v, v)), &(Rational::ONE / Rational::TWO))
}

/// A quantity before, after, and its change.
struct Pair {
    before: Shared,
    after: Shared,
    change: Shared,
}

impl Pair {
    fn new([before, after]: [Shared; 2]) -> Pair {
        Pair { change: sum(&after, &scaled(&before, &-Rational::ONE)), before, after }
    }

    fn entries(&self) -> Change {
        let [before, after, change] = [&self.before, &self.after, &self.change].map(|x| Entry::Number(x.clone()));
        Change { before, after, change }
    }

    fn plus(&self, other: &Pair) -> Pair {
        Pair {
            before: sum(&self.before, &other.before),
            after: sum(&self.after, &other.after),
            change: sum(&self.change, &other.change),
        }
    }
}

/// The entries of one collision.
fn collision(i: u64, e: Entry, masses: [Shared; 2], velocities: [[Shared; 2]; 2]) -> Collision {
    let [m1, m2] = masses;
    let [first, second] = velocities;
    let momenta = [(&m1, &first), (&m2, &second)].map(|(m, v)| Pair::new([product(m, &v[0]), product(m, &v[1])]));
    let energies = [(&m1, &first), (&m2, &second)].map(|(m, v)| Pair::new([kinetic(m, &v[0]), kinetic(m, &v[1])]));
    let (momentum, energy) = (momenta[0].plus(&momenta[1]), energies[0].plus(&energies[1]));
    let body = |number: u64, mass: Shared, velocity: [Shared; 2], place: usize| Body {
        number,
        mass: Entry::Number(mass),
        velocity: Pair::new(velocity).entries(),
        momentum: momenta[place].entries(),
        energy: energies[place].entries(),
    };
    let bodies = [body(i + 1, m1, first, 0), body(i + 2, m2, second, 1)];
    let before = Entry::Number(momentum.before);
    let momentum = Change { after: before.clone(), before, change: Entry::exact(&Rational::ZERO) };
    Collision { e, momentum, energy: energy.entries(), bodies }
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
