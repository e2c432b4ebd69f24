//! The values of a table's cells: eta by (25) and `L_n` by (19), exactly or enclosed.
//!
//! Contract: an exact value is the value; an enclosure holds it. With `r = m1/m2` and `t = r^(1/N)`, `N = n + 1`:
//!
//! - (25) reads `eta = (1+e)^(2N)·r/(1+t)^(2N)`. As `r = t^N`, that is `(((1+e)/2)^2)^N·(t/((1+t)/2)^2)^N`: powers of
//!   numbers from 0 to 1, so that no exponent runs away.
//! - (19) reads `L_n = (1+a)^(n+1)/(1+b)^n − 1` with `a = r^(1/(n+1))`, `b = r^(1/n)`. That is
//!   `2·((1+a)/2)^(n+1)/((1+b)/2)^n − 1`.

use super::dyadic::{Dyadic, Interval};
use super::failure::{Failure, declined};
use super::root::{enclosure, rational};
use super::work::Work;
use num_bigint::{BigInt, BigUint};
use num_rational::BigRational;
use num_traits::{One, Pow, ToPrimitive};
use std::cmp::Ordering;

/// The most bits of a number of bodies.
pub(crate) const COUNT_BITS: u64 = 2_048;
/// Exact values have at most about so many bits.
const EXACT_BITS: u64 = 1 << 20;
/// The most bits with which a cell is computed.
const PRECISION_LIMIT: u64 = 1 << 17;

/// A cell whose value is a real number.
#[derive(Clone, Debug)]
pub(crate) enum Cell {
    /// eta, of the ratio, the restitution and the number of collisions `N`.
    Eta(BigRational, BigRational, BigUint),
    /// `L_n`, of the ratio and `n`.
    Threshold(BigRational, BigUint),
}

/// What is known of a value before anything is enclosed.
#[derive(Clone, Debug)]
pub(crate) enum Form {
    /// It is this number.
    Exact(BigRational),
    /// It is rational and too long to be multiplied out.
    Long,
    /// A root in it is irrational.
    Irrational,
}

/// `x^n` where that is short enough.
fn power(x: &BigRational, n: &BigUint, work: &Work) -> Result<Option<BigRational>, Failure> {
    let bits = x.numer().bits().max(x.denom().bits()) * n;
    let bits = bits.to_u64().filter(|bits| *bits <= EXACT_BITS);
    let short = if x.is_one() { Some((1, 0)) } else { n.to_u32().zip(bits) };
    let Some((n, bits)) = short else { return Ok(None) };
    // Numerator and denominator; the squares before the last one take less than that one.
    (0..4).try_for_each(|_| work.product(bits / 2, bits / 2))?;
    Ok(Some(Pow::pow(x, n)))
}

fn half_sum(x: &BigRational) -> BigRational {
    (x + BigRational::one()) / BigInt::from(2)
}

impl Cell {
    /// Whether the value is rational, as far as its roots tell, and the value.
    pub(crate) fn form(&self, work: &Work) -> Result<Form, Failure> {
        let exact = |value: Option<BigRational>| value.map_or(Form::Long, Form::Exact);
        let size = |x: &BigRational| x.numer().bits().max(x.denom().bits());
        Ok(match self {
            Cell::Eta(r, e, count) => {
                let Some(t) = rational(r, count, work)? else { return Ok(Form::Irrational) };
                // The four products and quotients below, of no more bits than the last of them.
                (0..4).try_for_each(|_| work.reduction(2 * size(e) + 3 * size(&t) + 4))?;
                let (gain, sum) = (half_sum(e), half_sum(&t));
                exact(power(&(&gain * &gain * t / (&sum * &sum)), count, work)?)
            }
            // (1 + 1)^(n+1)/(1 + 1)^n − 1.
            Cell::Threshold(r, _) if r.is_one() => Form::Exact(BigRational::one()),
            Cell::Threshold(r, n) => {
                let next = n + 1u32;
                let (Some(a), Some(b)) = (rational(r, &next, work)?, rational(r, n, work)?) else {
                    return Ok(Form::Irrational);
                };
                let (above, below) = (power(&half_sum(&a), &next, work)?, power(&half_sum(&b), n, work)?);
                let Some((above, below)) = above.zip(below) else { return Ok(Form::Long) };
                // A quotient, a product and a difference.
                (0..3).try_for_each(|_| work.reduction(size(&above) + size(&below)))?;
                Form::Exact(above / below * BigInt::from(2) - BigRational::one())
            }
        })
    }

    /// An enclosure with about `bits` bits: of eta, or of `L_n + 1`.
    ///
    /// A root is computed with as many bits more as its exponent has, since a power multiplies the error in
    /// proportion by its exponent.
    fn computed(&self, bits: u64, work: &Work) -> Result<Interval, Failure> {
        match self {
            Cell::Eta(r, e, count) => {
                let wide = bits + count.bits() + 14;
                work.quotient(wide, e.numer().bits().max(e.denom().bits()))?;
                (0..16).try_for_each(|_| work.quotient(wide, wide))?;
                let gain = Interval::ratio(&half_sum(e), wide)?;
                let t = enclosure(r, count, wide, work)?;
                // t/((1+t)/2)^2 falls and rises with t: the quotient takes the ends of t apart.
                let sum = t.plus_one(wide)?.scaled(-1)?;
                let share = t.over(&sum.times(&sum, wide)?, wide)?;
                gain.times(&gain, wide)?.times(&share, wide)?.power(count, wide, work)
            }
            Cell::Threshold(r, n) => {
                let next = n + 1u32;
                let wide = bits + next.bits() + 14;
                (0..8).try_for_each(|_| work.quotient(wide, wide))?;
                let factor =
                    |k: &BigUint| enclosure(r, k, wide, work)?.plus_one(wide)?.scaled(-1)?.power(k, wide, work);
                factor(&next)?.over(&factor(n)?, wide)?.scaled(1)
            }
        }
    }

    /// An enclosure of the value; `None` if so few bits do not tell it from 0.
    pub(crate) fn enclosed(&self, bits: u64, work: &Work) -> Result<Option<Interval>, Failure> {
        if bits > PRECISION_LIMIT {
            return declined("bits of a cell");
        }
        let found = self.computed(bits, work)?;
        match self {
            Cell::Eta(..) => Ok(Some(found)),
            Cell::Threshold(..) => {
                let one = Dyadic::one();
                let (lo, hi) = (found.lo.minus(&one)?, found.hi.minus(&one)?);
                Ok(lo.zip(hi).map(|(lo, hi)| Interval { lo, hi }))
            }
        }
    }

    /// The order of the value and a rational that is not negative. Enclosures are narrowed until they tell; a value that
    /// is equal to it is recognised if it is known exactly.
    pub(crate) fn compare(&self, number: &BigRational, work: &Work) -> Result<Ordering, Failure> {
        if let Form::Exact(value) = self.form(work)? {
            return Ok(value.cmp(number));
        }
        let (Cell::Eta(.., n) | Cell::Threshold(_, n)) = self;
        let mut bits = 64 + 2 * n.bits();
        loop {
            if let Some(found) = self.enclosed(bits, work)? {
                (0..2).try_for_each(|_| work.quotient(bits, number.denom().bits()))?;
                if found.hi.compare_ratio(number)? == Ordering::Less {
                    return Ok(Ordering::Less);
                }
                if found.lo.compare_ratio(number)? == Ordering::Greater {
                    return Ok(Ordering::Greater);
                }
            }
            bits *= 2;
        }
    }
}
