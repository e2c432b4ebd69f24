//! Optimal masses between measured ones: velocities, losses and transfer matrices.
//!
//! With `x = r^(1/N)`, which ranges over `[x_lo, x_hi]`, and the first body's velocity `v`:
//! - body `i < N` leaves with `v·∏_(j<=i)(1 + e_j)·φ`, `φ = x^i·(x − e)/(1 + x)^(i+1)`, `e` the coefficient of the collision with body
//!   `i + 1`; `φ' = x^(i−1)·(1 + x)^(−i−2)·((1 + i + e)·x − i·e)`, so `φ` falls up to `i·e/(1 + i + e)`, where it is negative, and rises
//!   from there. Its least value is at that place or the end nearest to it, its greatest at an end; where it is
//!   positive it rises. The last body's velocity rises with `x`.
//! - with one coefficient for all and `φ > 0`, `(1 + e)^i·(x − e)` rises up to `e = (i·x − 1)/(i + 1)` and falls from there; it is
//!   log-concave, so its least value is at an end. Where `φ < 0` the size rises with `e`.
//! - collision `i` loses `v²/2·m1·x^(i−1)/(1 + x)^(2i−1)·(1 − e_i²)·∏_(j<i)(1 + e_j)²`. For a fixed `m1` this rises with `x` up to
//!   `(i − 1)/i` and falls from there; for a fixed `m2`, `m1 = m2·x^N` and it rises with `x`, as `N + i − 1 >= 2i − 1`. One
//!   coefficient for all: `(1 − e)(1 + e)^(2i−1)` rises up to `(i − 1)/i` and falls from there.
//! - the entries of `[[x − e, 1 + e], [x(1 + e), 1 − e·x]]/(1 + x)` are monotone in `x` and `e`: `[[↑↓, ↓↑], [↑↑, ↓↓]]`.

use super::{Coefficients, Positive, Range, Reals};
use crate::chain::optimum::{Optimum, exact_bits};
use crate::chain::{ChainError, Restitution, Restitutions};
use crate::number::NumberError;
use crate::number::interval::Interval;
use crate::number::real::Real;
use malachite::base::num::arithmetic::traits::{Pow, Square};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Natural, Rational};
use std::cmp::Ordering;

/// A chain of optimal masses between two measured ones.
#[derive(Clone, Debug)]
pub struct Measured {
    first: Range<Positive>,
    last: Range<Positive>,
    inserted: u64,
    coefficients: Coefficients,
    speed: Rational,
    bits: u64,
}

/// An end of a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    Low,
    High,
}

impl End {
    fn of<T: Clone + PartialOrd>(self, range: &Range<T>) -> &T {
        match self {
            Self::Low => range.lo(),
            Self::High => range.hi(),
        }
    }

    fn other(self) -> End {
        match self {
            Self::Low => Self::High,
            Self::High => Self::Low,
        }
    }

    /// That end of an enclosure.
    fn point(self, x: &Interval) -> Interval {
        let ends = x.ends().map(|(low, high)| if self == Self::Low { low } else { high });
        ends.unwrap_or_else(Interval::whole)
    }
}

impl Measured {
    /// A chain whose first body moves with `speed > 0`; what is irrational is bounded to about `bits` bits.
    #[must_use]
    pub fn new(
        first: Range<Positive>,
        last: Range<Positive>,
        inserted: u64,
        coefficients: Coefficients,
        speed: Rational,
        bits: u64,
    ) -> Measured {
        Measured { first, last, inserted, coefficients, speed, bits: bits + 32 }
    }

    /// The chain with the coefficients at the ends of their ranges, the masses anywhere: for its limits.
    ///
    /// # Errors
    /// As [`Optimum::new`].
    pub fn corner(&self) -> Result<Optimum, ChainError> {
        self.at(End::High, self.ends(End::High, |_| End::High)?)
    }

    /// The chain at one end of `x`, with the given coefficients.
    fn at(&self, x: End, restitutions: Restitutions) -> Result<Optimum, ChainError> {
        let (first, last) = (x.of(&self.first).clone(), x.other().of(&self.last).clone());
        Optimum::new(first, last, self.inserted, restitutions)
    }

    /// All coefficients at ends of their ranges: a common one at `common`, others each as told.
    fn ends(&self, common: End, each: impl Fn(u64) -> End) -> Result<Restitutions, ChainError> {
        match &self.coefficients {
            Coefficients::Same(e) => Ok(Restitutions::Same(common.of(e).clone())),
            Coefficients::Each(list) => {
                let list = list.iter().zip(0..).map(|(e, i)| each(i).of(e).clone());
                Restitutions::Each(list.collect()).for_inserted(self.inserted)
            }
        }
    }

    /// Coefficients before collision `i` at one end and that of collision `i` (from 0) at another; a common one at
    /// the latter.
    fn gains_and(&self, i: u64, gains: End, own: End) -> Result<Restitutions, ChainError> {
        self.ends(own, |j| if j < i { gains } else { own })
    }

    /// Bounds of the velocity of body `i`, 0 for the first one.
    ///
    /// # Errors
    /// As [`Optimum::new`], or where enclosures do not tell a sign.
    pub fn velocity(&self, i: u64) -> Result<Reals, ChainError> {
        if i > self.inserted {
            let end = |end: End| Ok::<_, ChainError>(self.at(end, self.ends(end, |_| end)?)?.arrival(i, &self.speed));
            return Ok(Reals { least: end(End::Low)?, greatest: end(End::High)? });
        }
        Ok(Reals { least: self.least(i)?, greatest: self.greatest(i)? })
    }

    fn least(&self, i: u64) -> Result<Real, ChainError> {
        let gains = |gains| self.gains_and(i, gains, End::High);
        let low = self.at(End::Low, gains(End::High)?)?;
        let worst = low.velocity(i, &self.speed);
        if worst.sign()?.0 == Ordering::Less {
            // The place where φ is least.
            let restitutions = gains(End::High)?;
            let Some(e) = restitutions.at(i).map(Restitution::value) else { return Ok(worst) };
            let i_rational = Rational::from(i);
            let place = &i_rational * e / (Rational::ONE + &i_rational + e);
            if compare(&low.step(), &place)? != Ordering::Less {
                return Ok(worst);
            }
            let high = self.at(End::High, gains(End::High)?)?;
            if compare(&high.step(), &place)? != Ordering::Greater {
                return Ok(high.velocity(i, &self.speed));
            }
            let factor = (&place - e) / (Rational::ONE + &place) * &self.speed;
            let share = &place / (Rational::ONE + &place);
            return Ok(self.powers(&[(share, i)], &restitutions, i, &factor, End::Low));
        }
        let at =
            |e: End| Ok::<_, ChainError>(self.at(End::Low, self.gains_and(i, End::Low, e)?)?.velocity(i, &self.speed));
        match self.coefficients.shared() {
            None => at(End::High),
            Some(_) => Ok(self.outer(vec![at(End::High)?, at(End::Low)?], End::Low)),
        }
    }

    fn greatest(&self, i: u64) -> Result<Real, ChainError> {
        let at = |x: End, gains: End| {
            Ok::<_, ChainError>(self.at(x, self.gains_and(i, gains, End::Low)?)?.velocity(i, &self.speed))
        };
        let best = at(End::High, End::High)?;
        if best.sign()?.0 != Ordering::Greater {
            return Ok(self.outer(vec![at(End::High, End::Low)?, at(End::Low, End::Low)?], End::High));
        }
        let Some(range) = self.coefficients.shared() else { return Ok(best) };
        // Where e = (i·x − 1)/(i + 1) is the greatest: for i > 0, from x = (1 + (i + 1)·e)/i on.
        if i == 0 {
            return Ok(best);
        }
        let high = self.at(End::High, self.ends(End::Low, |_| End::Low)?)?;
        let turn = |e: &Restitution| (Rational::ONE + Rational::from(i + 1) * e.value()) / Rational::from(i);
        if compare(&high.step(), &turn(range.lo()))? != Ordering::Greater {
            return Ok(best);
        }
        if compare(&high.step(), &turn(range.hi()))? != Ordering::Less {
            return Ok(self.at(End::High, self.ends(End::High, |_| End::High)?)?.velocity(i, &self.speed));
        }
        // There (1 + e)^i·φ is (i·x/(i + 1))^i/(i + 1).
        let work = self.bits + 2 * u64::from(u64::BITS - i.leading_zeros());
        let base = high.step().enclosure(work).multiply_rational(&Rational::from_unsigneds(i, i + 1), work);
        let factor = &self.speed / Rational::from(i + 1);
        let value = base.power(&Natural::from(i), work).multiply_rational(&factor, work);
        Ok(end(&value, End::High))
    }

    /// Bounds of the energy lost in collision `i`, from 1 on.
    ///
    /// # Errors
    /// As [`Self::velocity`].
    pub fn loss(&self, i: u64) -> Result<Reals, ChainError> {
        let at = |first: End, last: End, restitutions: Restitutions| {
            let (first, last) = (first.of(&self.first).clone(), last.of(&self.last).clone());
            Ok::<_, ChainError>(Optimum::new(first, last, self.inserted, restitutions)?.loss(i, &self.speed))
        };
        let mut low = Vec::new();
        for last in [End::Low, End::High] {
            low.push(at(End::Low, last, self.gains_and(i - 1, End::Low, End::High)?)?);
            if self.coefficients.shared().is_some() {
                low.push(at(End::Low, last, self.gains_and(i - 1, End::Low, End::Low)?)?);
            }
        }
        let turn = Rational::from_unsigneds(i - 1, i);
        let restitutions = match self.coefficients.shared() {
            Some(range) => {
                let e = turn.clone().clamp(range.lo().value().clone(), range.hi().value().clone());
                Restitutions::Same(Restitution::new(e)?)
            }
            None => self.gains_and(i - 1, End::High, End::Low)?,
        };
        let step = |last: End| {
            let last = last.of(&self.last).clone();
            Ok::<_, ChainError>(
                Optimum::new(self.first.hi().clone(), last, self.inserted, restitutions.clone())?.step(),
            )
        };
        // The heavier the last body, the smaller x.
        let greatest = if compare(&step(End::High)?, &turn)? != Ordering::Less {
            at(End::High, End::High, restitutions)?
        } else if compare(&step(End::Low)?, &turn)? != Ordering::Greater {
            at(End::High, End::Low, restitutions)?
        } else {
            let Some(e) = restitutions.at(i - 1).map(Restitution::value) else { return Err(ChainError::NotAtRest) };
            let energy = self.first.hi().value() * (&self.speed).square() / Rational::from(2);
            // 1 + x = (2i − 1)/i.
            let factor = energy * (Rational::ONE - e.square()) * Rational::from_unsigneds(i, 2 * i - 1);
            let share = Rational::from_unsigneds((i - 1) * i, (2 * i - 1).saturating_mul(2 * i - 1));
            let gains = restitutions.clone();
            let work = self.work(i);
            let gain = self.gain(&gains, i - 1, work).square(work);
            let value = self.product(&[(share, i - 1)], work).multiply(&gain, work).multiply_rational(&factor, work);
            end(&value, End::High)
        };
        Ok(Reals { least: self.outer(low, End::Low), greatest })
    }

    /// Bounds of the entries of the transfer matrix of collision `i`, from 0 on.
    ///
    /// # Errors
    /// [`ChainError::Count`] beyond the last collision; as [`Optimum::new`].
    pub fn matrix(&self, i: u64) -> Result<[[Reals; 2]; 2], ChainError> {
        let of = |x: End, e: End| {
            let matrix = self.at(x, self.ends(e, |_| e)?)?.matrix(i);
            matrix.ok_or(ChainError::Count { of: "collisions", given: i, needed: self.inserted + 1 })
        };
        let [[a_least, b_most], _] = of(End::Low, End::High)?;
        let [[a_most, b_least], _] = of(End::High, End::Low)?;
        let [_, [c_least, d_most]] = of(End::Low, End::Low)?;
        let [_, [c_most, d_least]] = of(End::High, End::High)?;
        let reals = |least, greatest| Reals { least, greatest };
        Ok([[reals(a_least, a_most), reals(b_least, b_most)], [reals(c_least, c_most), reals(d_least, d_most)]])
    }

    /// Bits to work with where `i` factors are multiplied.
    fn work(&self, i: u64) -> u64 {
        self.bits + 2 * u64::from(u64::BITS - i.leading_zeros()) + 8
    }

    /// `∏(1 + e_j)` of the first `count` collisions.
    fn gain(&self, restitutions: &Restitutions, count: u64, bits: u64) -> Interval {
        match restitutions {
            Restitutions::Same(e) => self.product(&[(e.plus_one(), count)], bits),
            Restitutions::Each(list) => list
                .iter()
                .zip(0..count)
                .fold(Interval::from_integer(1), |product, (e, _)| product.multiply_rational(&e.plus_one(), bits)),
        }
    }

    /// The product of powers of rationals.
    fn product(&self, powers: &[(Rational, u64)], bits: u64) -> Interval {
        powers.iter().fold(Interval::from_integer(1), |product, (base, exponent)| {
            product.multiply(&Interval::from_rational(base, bits).power(&Natural::from(*exponent), bits), bits)
        })
    }

    /// One end of `∏(1 + e_j)·powers·factor`.
    fn powers(
        &self,
        powers: &[(Rational, u64)],
        restitutions: &Restitutions,
        count: u64,
        factor: &Rational,
        side: End,
    ) -> Real {
        let short = powers.iter().all(|(base, exponent)| exact_bits(base, *exponent) <= self.bits);
        if let (true, Restitutions::Same(e)) = (short && count < self.bits, restitutions) {
            let power =
                powers.iter().fold(e.plus_one().pow(count), |product, (base, exponent)| product * base.pow(*exponent));
            return Real::rational(power * factor);
        }
        let work = self.work(count);
        let value = self.product(powers, work).multiply(&self.gain(restitutions, count, work), work);
        end(&value.multiply_rational(factor, work), side)
    }

    /// The least or the greatest of several numbers, or a bound of it on that side.
    fn outer(&self, list: Vec<Real>, side: End) -> Real {
        if list.iter().all(|x| x.as_rational().is_some()) {
            let exact = list.iter().filter_map(Real::as_rational);
            let found = if side == End::Low { exact.min() } else { exact.max() };
            return Real::rational(found.cloned().unwrap_or(Rational::ZERO));
        }
        let further = if side == End::Low { Ordering::Less } else { Ordering::Greater };
        let ends = list.iter().map(|x| side.point(&x.enclosure(self.bits)));
        let found = ends.reduce(|a, b| {
            let gap = b.subtract(&a, self.bits);
            match gap.sign() {
                Some(sign) if sign == further => b,
                Some(_) => a,
                // Too near to tell them apart: what lies beyond both.
                None => side.point(&a.widened(&gap)),
            }
        });
        bound(found.unwrap_or_else(Interval::whole))
    }
}

/// A bound as a real number: it is exact.
fn bound(point: Interval) -> Real {
    match point.point() {
        Some(exact) => Real::rational(exact),
        // Too long to be written down, and so to be a short decimal.
        None => Real::enclosed(move |_| point.clone()),
    }
}

/// One end of an enclosure.
fn end(x: &Interval, side: End) -> Real {
    bound(side.point(x))
}

/// The order of a real number and a rational one.
fn compare(x: &Real, y: &Rational) -> Result<Ordering, NumberError> {
    if let Some(exact) = x.as_rational() {
        return Ok(exact.cmp(y));
    }
    let settled = x.settle(0, |x| {
        let bits = x.accuracy().clamp(64, 1 << 30) + 8;
        x.subtract(&Interval::from_rational(y, bits), bits).sign()
    })?;
    Ok(settled.0)
}
