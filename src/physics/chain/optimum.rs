//! The optimal inserted masses, and what a pass along them does: (20)–(24).
//!
//! `mu_i = m1^((N−i)/N)·m2^(i/N)`, so that neighbours have the mass ratio `x = r^(1/N)` everywhere. Which of the
//! results are rational is told by the lemma in [`super`].

use super::{ChainError, MAX_EXACT_BITS, MAX_INSERTED, Positive, Restitutions, limit_inserted};
use crate::number::interval::Interval;
use crate::number::rational::exact_root;
use crate::number::real::Real;
use crate::number::root::root;
use malachite::base::num::arithmetic::traits::{Gcd, Pow, Square};
use malachite::base::num::basic::traits::{One, Two, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};

/// A chain whose `n` inserted bodies have the optimal masses.
#[derive(Clone, Debug)]
pub struct Optimum {
    first: Positive,
    last: Positive,
    inserted: u64,
    restitutions: Restitutions,
    step: Step,
}

/// `x = r^(1/N)`.
#[derive(Clone, Debug)]
enum Step {
    Rational(Rational),
    /// Irrational: `r` and `N`.
    Root(Rational, Natural),
}

impl Step {
    fn at(&self, bits: u64) -> Interval {
        match self {
            Self::Rational(x) => Interval::from_rational(x, bits),
            Self::Root(r, count) => root(r, count, bits),
        }
    }

    fn as_rational(&self) -> Option<&Rational> {
        match self {
            Self::Rational(x) => Some(x),
            Self::Root(..) => None,
        }
    }
}

/// The mass of body `i` of a chain with so many inserted bodies: 0 is the first one, `inserted + 1` the last.
#[must_use]
pub fn mass(first: &Positive, last: &Positive, inserted: u64, i: u64) -> Real {
    let count = inserted + 1;
    let i = i.min(count);
    // r^(−i/N) in lowest terms of the exponent.
    let common = i.gcd(count).max(1);
    let (power, degree) = (i / common, count / common);
    let ratio = last.over(first);
    let m1 = first.value().clone();
    if let Some(t) = exact_root(ratio.value(), degree)
        && exact_bits(&t, power) <= MAX_EXACT_BITS
    {
        return Real::rational(m1 * t.pow(power));
    }
    let text = {
        let (m1, ratio) = (m1.clone(), ratio.clone());
        move || format!("{}*{}", factor_text(&m1), root_text(ratio.value(), power, degree))
    };
    Real::enclosed(move |bits| {
        let work = bits + power.significant_bits() + 8;
        let t = root(ratio.value(), &Natural::from(degree), work);
        t.power(&Natural::from(power), work).multiply_rational(&m1, bits + 4)
    })
    .with_radical(text)
}

impl Optimum {
    /// A chain from the first to the last mass.
    ///
    /// # Errors
    /// [`ChainError::Count`] for a list of coefficients of the wrong length; a limit above [`MAX_INSERTED`].
    pub fn new(
        first: Positive,
        last: Positive,
        inserted: u64,
        restitutions: Restitutions,
    ) -> Result<Optimum, ChainError> {
        limit_inserted(inserted, "inserted bodies", MAX_INSERTED)?;
        let restitutions = restitutions.for_inserted(inserted)?;
        let ratio = first.over(&last);
        let step = match exact_root(ratio.value(), inserted + 1) {
            Some(x) => Step::Rational(x),
            None => Step::Root(ratio.value().clone(), Natural::from(inserted + 1)),
        };
        Ok(Optimum { first, last, inserted, restitutions, step })
    }

    /// `N`, the number of collisions.
    #[must_use]
    pub fn collisions(&self) -> u64 {
        self.inserted + 1
    }

    /// The coefficients of restitution.
    #[must_use]
    pub fn restitutions(&self) -> &Restitutions {
        &self.restitutions
    }

    /// The transfer matrix of a collision, counted from 0, (7): `[[x−e, 1+e], [x(1+e), 1−e·x]]/(x+1)`.
    ///
    /// Each entry `(c + s·x)/(1 + x)` has `s − c = ±(1 + e)`, so it is rational iff `x` is. `None` beyond the last collision.
    #[must_use]
    pub fn matrix(&self, collision: u64) -> Option<[[Real; 2]; 2]> {
        let e = self.restitutions.at(collision).filter(|_| collision < self.collisions())?;
        let (up, down, zero) = (e.plus_one(), -e.value(), Rational::ZERO);
        let entry = |constant: &Rational, slope: &Rational| self.fraction(constant.clone(), slope.clone());
        let one = Rational::ONE;
        Some([[entry(&down, &one), entry(&up, &zero)], [entry(&zero, &up), entry(&one, &down)]])
    }

    /// `(constant + slope·x)/(1 + x)`, which is not constant: `constant` and `slope` differ.
    fn fraction(&self, constant: Rational, slope: Rational) -> Real {
        let step = self.step.clone();
        if let Some(x) = step.as_rational() {
            return Real::rational((constant + slope * x) / (x + Rational::ONE));
        }
        Real::enclosed(move |bits| {
            let work = bits + 8;
            let x = step.at(work);
            let above = x.multiply_rational(&slope, work).add(&Interval::from_rational(&constant, work), work);
            above.divide(&x.add(&Interval::from_integer(1), work), bits + 4)
        })
    }

    /// The ratio of neighbouring masses, `x`.
    #[must_use]
    pub fn step(&self) -> Real {
        match &self.step {
            Step::Rational(x) => Real::rational(x.clone()),
            Step::Root(r, _) => {
                let (step, text) = (self.step.clone(), root_text(r, 1, self.collisions()));
                let text = move || text;
                Real::enclosed(move |bits| step.at(bits)).with_radical(text)
            }
        }
    }

    /// The mass of body `i`: 0 is the first one, `N` the last.
    #[must_use]
    pub fn mass(&self, i: u64) -> Real {
        mass(&self.first, &self.last, self.inserted, i)
    }

    /// `1 + e` of collision `i` (from 1) for each `i` up to `count`, multiplied.
    fn gain(&self, count: u64) -> impl Fn(u64) -> Interval + Send + Sync + 'static {
        let restitutions = self.restitutions.clone();
        move |bits| match &restitutions {
            Restitutions::Same(e) => Interval::from_rational(&e.plus_one(), bits + count.significant_bits() + 4)
                .power(&Natural::from(count), bits),
            Restitutions::Each(list) => {
                let work = bits + count.significant_bits() + 4;
                let count = usize::try_from(count).unwrap_or(usize::MAX);
                list.iter()
                    .take(count)
                    .fold(Interval::from_integer(1), |product, e| product.multiply_rational(&e.plus_one(), work))
            }
        }
    }

    fn exact_gain(&self, count: u64) -> Rational {
        match &self.restitutions {
            Restitutions::Same(e) => e.plus_one().pow(count),
            Restitutions::Each(list) => {
                let count = usize::try_from(count).unwrap_or(usize::MAX);
                list.iter().take(count).fold(Rational::ONE, |product, e| product * e.plus_one())
            }
        }
    }

    /// The largest size of an exact result of `count` collisions, in bits.
    fn exact_size(&self, x: &Rational, count: u64) -> u64 {
        match &self.restitutions {
            // A power of one number, which may be short where its factors are long, as 1 = 2·1/2; and some of each.
            Restitutions::Same(e) => {
                let once = e.plus_one() * x / (x + Rational::ONE);
                let few = exact_bits(&e.plus_one(), 4).saturating_add(exact_bits(x, 4));
                exact_bits(&once, count).saturating_mul(2).saturating_add(few)
            }
            Restitutions::Each(list) => {
                let e: u64 = list.iter().map(|e| exact_bits(&e.plus_one(), 1)).sum();
                e.saturating_add(exact_bits(x, count).saturating_mul(4))
            }
        }
    }

    /// A bound of the bits of all velocities together, where they are exact; 0 where they are enclosed.
    #[must_use]
    pub(crate) fn listed_bits(&self) -> u64 {
        let count = self.collisions();
        let each = self.step.as_rational().map_or(0, |x| self.exact_size(x, count).min(MAX_EXACT_BITS));
        each.saturating_mul(count)
    }

    /// The velocity with which body `i` arrives at its collision with body `i + 1`, or leaves for `i = N`:
    /// `∏_(j<=i)(1 + e_j)·(x/(1+x))^i·v1`.
    #[must_use]
    pub fn arrival(&self, i: u64, speed: &Rational) -> Real {
        if i == 0 || *speed == Rational::ZERO {
            return Real::rational(speed.clone());
        }
        if let Some(x) = self.step.as_rational()
            && self.exact_size(x, i) <= MAX_EXACT_BITS
        {
            let share = x / (x + Rational::ONE);
            return Real::rational(match &self.restitutions {
                Restitutions::Same(e) => (e.plus_one() * share).pow(i) * speed,
                Restitutions::Each(_) => self.exact_gain(i) * share.pow(i) * speed,
            });
        }
        let (step, gain, speed) = (self.step.clone(), self.gain(i), speed.clone());
        Real::enclosed(move |bits| {
            let work = bits + i.significant_bits() + 8;
            let x = step.at(work);
            let share = x.divide(&x.add(&Interval::from_integer(1), work), work);
            share.power(&Natural::from(i), work).multiply(&gain(work), work).multiply_rational(&speed, bits + 4)
        })
    }

    /// The velocity of body `i` after the pass, (22)–(24), for a first body of velocity `speed`.
    #[must_use]
    pub fn velocity(&self, i: u64, speed: &Rational) -> Real {
        let i = i.min(self.collisions());
        let arrival = self.arrival(i, speed);
        let text = self.velocity_text(i, speed);
        let closed = |x: Real| match text {
            Some(text) => x.with_radical(move || text),
            None => x,
        };
        let Some(e) = self.restitutions.at(i).filter(|_| i < self.collisions()) else {
            return closed(arrival);
        };
        if *speed == Rational::ZERO {
            return Real::rational(Rational::ZERO);
        }
        // Left with (x − e)/(x + 1) of it.
        let e = e.value().clone();
        if let (Some(x), Some(v)) = (self.step.as_rational(), arrival.as_rational()) {
            return Real::rational(v * (x - e) / (x + Rational::ONE));
        }
        if self.step.as_rational() == Some(&e) {
            return Real::rational(Rational::ZERO);
        }
        let step = self.step.clone();
        closed(Real::enclosed(move |bits| {
            let x = step.at(bits + 8);
            let below = x.add(&Interval::from_integer(1), bits + 8);
            let above = x.subtract(&Interval::from_rational(&e, bits + 8), bits + 8);
            arrival.enclosure(bits + 8).multiply(&above.divide(&below, bits + 8), bits + 4)
        }))
    }

    /// The closed form of a velocity where `x` is irrational, `(x − e)/(x + 1)·∏(1 + e_j)·(x/(x + 1))^i·v1`, the first
    /// factor for all bodies but the last; `None` where it would be long.
    fn velocity_text(&self, i: u64, speed: &Rational) -> Option<String> {
        let Step::Root(r, _) = &self.step else { return None };
        let x = root_text(r, 1, self.collisions());
        let mut factors = Vec::new();
        if let Some(e) = self.restitutions.at(i).filter(|_| i < self.collisions()) {
            factors.push(match *e.value() == Rational::ZERO {
                true => format!("{x}/({x} + 1)"),
                false => format!("({x} - {})/({x} + 1)", e.value()),
            });
        }
        match &self.restitutions {
            _ if i == 0 => {}
            Restitutions::Same(e) if *e.value() == Rational::ZERO => factors.push(format!("({x}/({x} + 1))^{i}")),
            Restitutions::Same(e) => factors.push(format!("({}*{x}/({x} + 1))^{i}", factor_text(&e.plus_one()))),
            Restitutions::Each(list) => {
                let size: u64 = list.iter().map(|e| exact_bits(&e.plus_one(), 1)).sum();
                if size > MAX_TEXT_BITS {
                    return None;
                }
                let gain = self.exact_gain(i);
                if gain != Rational::ONE {
                    factors.push(factor_text(&gain));
                }
                factors.push(format!("({x}/({x} + 1))^{i}"));
            }
        }
        if *speed != Rational::ONE {
            factors.push(if *speed > Rational::ZERO { factor_text(speed) } else { format!("({speed})") });
        }
        Some(factors.join("*"))
    }

    /// The kinetic energy lost in collision `i` (from 1 to `N`), for a first body of velocity `speed`:
    /// `m1·x^(1−i)·(1 − e_i²)·w²/(2(1 + x))`, `w` the velocity with which body `i − 1` arrives.
    #[must_use]
    pub fn loss(&self, i: u64, speed: &Rational) -> Real {
        let i = i.clamp(1, self.collisions());
        let share = match self.restitutions.at(i - 1) {
            Some(e) => Rational::ONE - e.value().square(),
            None => Rational::ZERO,
        };
        if share == Rational::ZERO || *speed == Rational::ZERO {
            return Real::rational(Rational::ZERO);
        }
        let arrival = self.arrival(i - 1, speed);
        let mass = self.mass(i - 1);
        if let (Some(x), Some(w), Some(m)) = (self.step.as_rational(), arrival.as_rational(), mass.as_rational()) {
            return Real::rational(m * share * w.square() / (Rational::TWO * (x + Rational::ONE)));
        }
        let step = self.step.clone();
        Real::enclosed(move |bits| {
            let work = bits + 8;
            let below = step.at(work).add(&Interval::from_integer(1), work);
            let energy = arrival.enclosure(work).square(work).multiply(&mass.enclosure(work), work).shifted(-1);
            energy.divide(&below, work).multiply_rational(&share, bits + 4)
        })
    }

    /// The kinetic energy of both bodies of collision `i` (from 0) after it, for `e_i < 1`, where it is rational and `x` is
    /// not: with the energy `E` before, `E·(e_i² + x)/(1 + x)`.
    #[must_use]
    pub(crate) fn rational_energy_after(&self, i: u64, speed: &Rational) -> Option<Rational> {
        let e = self.restitutions.at(i)?;
        let found = self.rational_quotient(i, &e.value().square(), 1, 2 * i + 1)?;
        Some(self.energy_factor(i, speed) * found)
    }

    /// The change of the kinetic energy of the body that strikes in collision `i` (from 0), for `e_i < 1`, where it is
    /// rational and `x` is not: with its energy `E` before, `−E·(1 + e_i)·(1 − e_i + 2x)/(1 + x)²`.
    #[must_use]
    pub(crate) fn rational_energy_change(&self, i: u64, speed: &Rational) -> Option<Rational> {
        let e = self.restitutions.at(i)?;
        let found = self.rational_quotient(i, &(Rational::ONE - e.value()), 2, 2 * i + 2)?;
        Some(-self.energy_factor(i, speed) * e.plus_one() * found)
    }

    /// The energy with which body `i` arrives, `m1·v1²/2·∏_(j<=i)(1 + e_j)²·x^i/(1 + x)^(2i)`, without its powers of `x` and
    /// `1 + x`.
    fn energy_factor(&self, i: u64, speed: &Rational) -> Rational {
        self.first.value() * (self.exact_gain(i) * speed).square() / Rational::TWO
    }

    /// `x^i·(constant + slope·x)/(1 + x)^power` where that is rational and `x` is not; `constant` and `slope` differ, and
    /// neither is below 0.
    ///
    /// Let `k >= 2` be least with `x^k` rational. For `k >= 3` the powers of `x` in `(1 + x)^power` fill at least three classes
    /// of exponents modulo `k` (two for `power = 1`), those above at most two, and by the lemma in [`super`] no multiple of
    /// the one is the other. For `k = 2`, let `(1 + x)^power = a + b·x`; the two parts above must be as `a` to `b`.
    fn rational_quotient(&self, i: u64, constant: &Rational, slope: u64, power: u64) -> Option<Rational> {
        let Step::Root(r, _) = &self.step else { return None };
        let half = self.collisions() / 2;
        // For an odd number of collisions a rational x² makes x rational.
        let square = exact_root(r, half).filter(|_| 2 * half == self.collisions())?;
        if exact_bits(&square, power) > MAX_QUOTIENT_BITS {
            return None;
        }
        let (a, b) = power_of_one_plus_root(&square, power);
        let slope = Rational::from(slope);
        // The part above that goes with `below`, and the other part with what goes with it.
        let (above, below, other, beside) =
            if i.is_multiple_of(2) { (slope, b, constant, a) } else { (slope * &square, a, constant, b) };
        (&above * beside == other * &below).then(|| above / below * square.pow(i / 2))
    }
}

/// `(a, b)` with `(1 + √s)^power = a + b·√s`.
fn power_of_one_plus_root(s: &Rational, power: u64) -> (Rational, Rational) {
    let (mut a, mut b) = (Rational::ONE, Rational::ZERO);
    for place in (0..power.significant_bits()).rev() {
        (a, b) = ((&a).square() + (&b).square() * s, Rational::TWO * &a * &b);
        if power >> place & 1 == 1 {
            (a, b) = (&a + &b * s, a + b);
        }
    }
    (a, b)
}

/// The most bits of a power of `1 + x` that is formed to see whether an energy is rational.
const MAX_QUOTIENT_BITS: u64 = 1 << 18;

/// The most bits of a product that a closed form writes out.
const MAX_TEXT_BITS: u64 = 400;

/// An upper bound of the bits of `x^count`.
pub(super) fn exact_bits(x: &Rational, count: u64) -> u64 {
    let size = x.numerator_ref().significant_bits().max(x.denominator_ref().significant_bits());
    // One costs nothing.
    if *x == Rational::ONE { 1 } else { size.saturating_mul(count) }
}

/// A rational as a factor in a formula.
pub(super) fn factor_text(x: &Rational) -> String {
    if *x.denominator_ref() == Natural::ONE { x.to_string() } else { format!("({x})") }
}

/// `r^(power/degree)` as text.
pub(super) fn root_text(r: &Rational, power: u64, degree: u64) -> String {
    let base = factor_text(r);
    if degree == 1 { format!("{base}^{power}") } else { format!("{base}^({power}/{degree})") }
}
