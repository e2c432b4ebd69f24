//! Worksheets for teaching: what each collision of a pass does to masses, velocities, momenta and energies.
//!
//! **Contract.** Every entry is a real number that can be printed to any number of correct digits, exact where
//! it is rational; or, where inputs are measured, a range that holds all its values. Totals obey the laws exactly: the
//! total momentum does not change, and the total energy changes by the loss of the collision.
//!
//! **Measured inputs.** The velocities are those of [`Given`], whose ends are attained. Momenta, energies and changes follow
//! from them by interval arithmetic: sound, and wider than need be where a mass and a velocity depend on each other.

use crate::chain::optimum::Optimum;
use crate::chain::pass::Pass;
use crate::chain::uncertain::given::Given;
use crate::chain::uncertain::{Coefficients, Range, Reals};
use crate::chain::{ChainError, Positive, Restitution, Restitutions, recollision};
use crate::number::NumberError;
use crate::number::interval::Interval;
use crate::number::real::Real;
use crate::scene::drop::Drop;
use crate::scene::{Chain, Inserted, Start};
use crate::table::later::{Later, later};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Two, Zero};
use std::cmp::Ordering;
use std::sync::Arc;

/// The most collisions of a worksheet.
pub const MAX_COLLISIONS: u64 = 1_000;
/// Bits of an enclosure by which two irrational entries are compared.
const BITS: u64 = 192;

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
            Entry::Number(x) => x.scaled(&minus).entry(),
            Entry::Between(range) => Arithmetic::scaled(range, &minus).entry(),
        }
    }

    /// The sum of two entries.
    #[must_use]
    pub fn plus(&self, other: &Entry) -> Entry {
        match (self, other) {
            (Entry::Number(a), Entry::Number(b)) => Entry::Number(a.plus(b)),
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
            return of_measured(&masses, chain.coefficients(), &frame);
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
        of_measured(drop.masses(), drop.coefficients(), &frame)
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
const MEASURED: &str = "a worksheet or picture of velocities of optimal masses, or of velocities of all bodies,";

fn limit(collisions: u64) -> Result<(), ChainError> {
    if collisions > MAX_COLLISIONS {
        let limit = "collisions of a worksheet or picture";
        return Err(NumberError::LimitReached { limit, allowed: MAX_COLLISIONS, needed: collisions.to_string() }.into());
    }
    Ok(())
}

/// From the frame in which the first body alone moves, with velocity 1, to the one that is shown: `v·speed + shift`.
struct Frame {
    speed: Range<Rational>,
    shift: Rational,
}

impl Frame {
    fn shown(&self, v: &Range<Rational>) -> Range<Rational> {
        let shift = Range::point(self.shift.clone());
        v.times(&self.speed).plus(&shift)
    }
}

/// The pass of bodies of which some mass, coefficient or the approach may be measured.
fn of_measured(
    masses: &[Range<Positive>],
    coefficients: &Coefficients,
    frame: &Frame,
) -> Result<Worksheet, ChainError> {
    if *frame.speed.lo() <= Rational::ZERO {
        return Err(ChainError::NotAtRest);
    }
    let ends = |found: Reals| match (found.least.as_rational(), found.greatest.as_rational()) {
        (Some(lo), Some(hi)) => Range::new(lo.clone(), hi.clone()).map_err(|_| ChainError::NotAtRest),
        // Bounds of given masses are rational.
        _ => Err(ChainError::Measured { quantity: MEASURED }),
    };
    // Enough for the digits of any sheet: what is rounded is far below any uncertainty.
    let given = |count: usize| {
        let coefficients = match coefficients {
            Coefficients::Each(list) => Coefficients::Each(list.iter().take(count - 1).cloned().collect()),
            same => same.clone(),
        };
        Given::new(masses[..count].to_vec(), coefficients, Rational::ONE, BITS)
    };
    let whole = given(masses.len())?;
    let after = whole.velocities()?.into_iter().map(ends).collect::<Result<Vec<_>, _>>()?;
    let mut arrivals = vec![Range::point(Rational::ONE)];
    for count in 2..=masses.len() {
        arrivals.push(ends(given(count)?.last_velocity()?)?);
    }
    let square = frame.speed.times(&frame.speed);
    let losses = whole.losses()?.into_iter().map(ends).collect::<Result<Vec<_>, _>>()?;
    let rest = Range::point(Rational::ZERO);
    let mut collisions = Vec::new();
    for (i, ((pair, loss), left)) in masses.windows(2).zip(&losses).zip(&after).enumerate() {
        let ([m1, m2], Some(e)) = (pair, coefficients.at(i)) else { continue };
        let mass = |m: &Range<Positive>| m.clone().map(|m| Ok::<_, ChainError>(m.value().clone()));
        let velocities = [[&arrivals[i], left], [&rest, &arrivals[i + 1]]].map(|pair| pair.map(|v| frame.shown(v)));
        let mut found = collision(i as u64, Entry::range(value(e)), [mass(m1)?, mass(m2)?], velocities);
        found.energy.change = Entry::range(loss.times(&square).times(&Range::point(-Rational::ONE)));
        if found.energy.change.bounds() == Some((Rational::ZERO, Rational::ZERO)) {
            found.energy.after = found.energy.before.clone();
        }
        collisions.push(found);
    }
    let pairs = || after.windows(2);
    let never = pairs().all(|pair| pair[0].hi() <= pair[1].lo());
    let always = pairs().any(|pair| pair[0].lo() > pair[1].hi());
    Ok(Worksheet { collisions, again: if never { Some(false) } else { always.then_some(true) }, later: None })
}

fn value(e: &Range<Restitution>) -> Range<Rational> {
    let end = |e: &Restitution| e.value().clone();
    Range::new(end(e.lo()), end(e.hi())).unwrap_or_else(|_| Range::point(end(e.lo())))
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
    found.energy.change = Entry::Number(Arc::new(loss).scaled(&-Rational::ONE));
}

/// What entries are computed with.
trait Arithmetic: Clone {
    fn plus(&self, other: &Self) -> Self;
    fn product(&self, other: &Self) -> Self;
    fn scaled(&self, by: &Rational) -> Self;
    /// Half of the product with the square.
    fn energy(&self, velocity: &Self) -> Self;
    fn entry(&self) -> Entry;
}

impl Arithmetic for Shared {
    fn plus(&self, other: &Shared) -> Shared {
        sum(self, other)
    }

    fn product(&self, other: &Shared) -> Shared {
        product(self, other)
    }

    fn scaled(&self, by: &Rational) -> Shared {
        product(self, &exact(by))
    }

    fn energy(&self, v: &Shared) -> Shared {
        product(self, &product(v, v)).scaled(&(Rational::ONE / Rational::TWO))
    }

    fn entry(&self) -> Entry {
        Entry::Number(self.clone())
    }
}

impl Arithmetic for Range<Rational> {
    fn plus(&self, other: &Self) -> Self {
        Range::plus(self, other)
    }

    fn product(&self, other: &Self) -> Self {
        self.times(other)
    }

    fn scaled(&self, by: &Rational) -> Self {
        self.times(&Range::point(by.clone()))
    }

    fn energy(&self, v: &Self) -> Self {
        self.times(&v.square()).scaled(&(Rational::ONE / Rational::TWO))
    }

    fn entry(&self) -> Entry {
        Entry::range(self.clone())
    }
}

/// A quantity before, after, and its change.
struct Pair<T> {
    before: T,
    after: T,
    change: T,
}

impl<T: Arithmetic> Pair<T> {
    fn new([before, after]: [T; 2]) -> Pair<T> {
        Pair { change: after.plus(&before.scaled(&-Rational::ONE)), before, after }
    }

    fn entries(&self) -> Change {
        Change { before: self.before.entry(), after: self.after.entry(), change: self.change.entry() }
    }

    fn plus(&self, other: &Pair<T>) -> Pair<T> {
        Pair {
            before: self.before.plus(&other.before),
            after: self.after.plus(&other.after),
            change: self.change.plus(&other.change),
        }
    }
}

/// The entries of one collision.
fn collision<T: Arithmetic>(i: u64, e: Entry, masses: [T; 2], velocities: [[T; 2]; 2]) -> Collision {
    let [m1, m2] = masses;
    let [first, second] = velocities;
    let momenta = [(&m1, &first), (&m2, &second)].map(|(m, v)| Pair::new([m.product(&v[0]), m.product(&v[1])]));
    let energies = [(&m1, &first), (&m2, &second)].map(|(m, v)| Pair::new([m.energy(&v[0]), m.energy(&v[1])]));
    let (momentum, energy) = (momenta[0].plus(&momenta[1]), energies[0].plus(&energies[1]));
    let body = |number: u64, mass: &T, velocity: [T; 2], place: usize| Body {
        number,
        mass: mass.entry(),
        velocity: Pair::new(velocity).entries(),
        momentum: momenta[place].entries(),
        energy: energies[place].entries(),
    };
    let bodies = [body(i + 1, &m1, first, 0), body(i + 2, &m2, second, 1)];
    let before = momentum.before.entry();
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
