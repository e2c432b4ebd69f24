//! Dyadic numbers and intervals of them: arithmetic that is rounded outwards.
//!
//! Contract: an operation on intervals gives an interval that holds the result for all elements of its operands. Numbers
//! are not negative. Every operation is monotone in each operand there, so that its ends come from ends alone,
//! the lower one cut downwards and the upper one upwards.

use super::failure::{Failure, declined};
use super::work::Work;
use num_bigint::BigUint;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::cmp::Ordering;

/// The most bits that a shift adds to a number.
const SHIFT_LIMIT: u64 = 1 << 24;

/// The direction of a cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Toward {
    /// The result is at most the exact one.
    Down,
    /// The result is at least the exact one.
    Up,
}

/// `mantissa·2^exponent`, not negative.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Dyadic {
    mantissa: BigUint,
    exponent: i64,
}

fn exponent(sum: Option<i64>) -> Result<i64, Failure> {
    sum.map_or_else(|| declined("exponents of dyadic numbers"), Ok)
}

/// `x·2^places`.
fn shifted(x: &BigUint, places: u64) -> Result<BigUint, Failure> {
    if places > SHIFT_LIMIT {
        return declined("bits of a number");
    }
    Ok(x << places)
}

/// How far apart two exponents are.
fn distance(high: i64, low: i64) -> u64 {
    high.abs_diff(low)
}

impl Dyadic {
    /// `mantissa·2^exponent`.
    pub(crate) fn new(mantissa: BigUint, exponent: i64) -> Dyadic {
        Dyadic { mantissa, exponent }
    }

    /// One.
    pub(crate) fn one() -> Dyadic {
        Dyadic::new(BigUint::one(), 0)
    }

    /// Whether it is 0.
    pub(crate) fn is_zero(&self) -> bool {
        self.mantissa.is_zero()
    }

    /// The mantissa and the exponent.
    pub(crate) fn parts(&self) -> (&BigUint, i64) {
        (&self.mantissa, self.exponent)
    }

    /// The mantissa and the exponent, taken apart.
    pub(crate) fn into_parts(self) -> (BigUint, i64) {
        (self.mantissa, self.exponent)
    }

    /// `t` with `2^(t−1) <= self < 2^t`, for a number other than 0.
    pub(crate) fn top(&self) -> i64 {
        let bits = i64::try_from(self.mantissa.bits()).unwrap_or(i64::MAX);
        self.exponent.saturating_add(bits)
    }

    /// The number times `2^places`.
    pub(crate) fn scaled(&self, places: i64) -> Result<Dyadic, Failure> {
        Ok(Dyadic::new(self.mantissa.clone(), exponent(self.exponent.checked_add(places))?))
    }

    /// At most `bits` bits of it: the low bits are cut off, and one is added in their place upwards if they were not
    /// all 0.
    pub(crate) fn cut(self, bits: u64, toward: Toward) -> Result<Dyadic, Failure> {
        let low = self.mantissa.bits().saturating_sub(bits);
        if low == 0 {
            return Ok(self);
        }
        let mut kept = &self.mantissa >> low;
        // The last bit that is set tells whether anything is lost.
        if toward == Toward::Up && self.mantissa.trailing_zeros().is_some_and(|zeros| zeros < low) {
            kept += 1u32;
        }
        let by = i64::try_from(low).ok();
        Ok(Dyadic::new(kept, exponent(by.and_then(|by| self.exponent.checked_add(by)))?))
    }

    /// The same number with a mantissa of exactly `bits` bits or more.
    pub(crate) fn widened(self, bits: u64) -> Result<Dyadic, Failure> {
        let places = bits.saturating_sub(self.mantissa.bits());
        let by = i64::try_from(places).ok();
        let exponent = exponent(by.and_then(|by| self.exponent.checked_sub(by)))?;
        Ok(Dyadic::new(shifted(&self.mantissa, places)?, exponent))
    }

    /// The mantissa moved by so many units of its last place; `None` below 0.
    pub(crate) fn moved(&self, units: &BigUint, toward: Toward) -> Option<Dyadic> {
        let mantissa = match toward {
            Toward::Up => &self.mantissa + units,
            Toward::Down if self.mantissa > *units => &self.mantissa - units,
            Toward::Down => return None,
        };
        Some(Dyadic::new(mantissa, self.exponent))
    }

    /// The product, cut.
    pub(crate) fn times(&self, other: &Dyadic, bits: u64, toward: Toward) -> Result<Dyadic, Failure> {
        let exponent = exponent(self.exponent.checked_add(other.exponent))?;
        Dyadic::new(&self.mantissa * &other.mantissa, exponent).cut(bits, toward)
    }

    /// The sum, exactly.
    pub(crate) fn plus(&self, other: &Dyadic) -> Result<Dyadic, Failure> {
        let (high, low) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let aligned = shifted(&high.mantissa, distance(high.exponent, low.exponent))?;
        Ok(Dyadic::new(aligned + &low.mantissa, low.exponent))
    }

    /// The difference, exactly; `None` if it is below 0.
    pub(crate) fn minus(&self, other: &Dyadic) -> Result<Option<Dyadic>, Failure> {
        if self.compare(other)? == Ordering::Less {
            return Ok(None);
        }
        let least = self.exponent.min(other.exponent);
        let (a, b) = (
            shifted(&self.mantissa, distance(self.exponent, least))?,
            shifted(&other.mantissa, distance(other.exponent, least))?,
        );
        Ok(Some(Dyadic::new(a - b, least)))
    }

    /// The quotient, cut to `bits` or one more; the divisor is not 0.
    pub(crate) fn over(&self, other: &Dyadic, bits: u64, toward: Toward) -> Result<Dyadic, Failure> {
        if other.is_zero() {
            return declined("a divisor without a lower bound above 0");
        }
        let places = (bits + other.mantissa.bits()).saturating_sub(self.mantissa.bits());
        let above = shifted(&self.mantissa, places)?;
        let mut quotient = &above / &other.mantissa;
        if toward == Toward::Up && &quotient * &other.mantissa != above {
            quotient += 1u32;
        }
        let by = i64::try_from(places).ok();
        let exponent = self.exponent.checked_sub(other.exponent).and_then(|e| e.checked_sub(by?));
        Dyadic::new(quotient, self::exponent(exponent)?).cut(bits + 1, toward)
    }

    /// The power by products, each cut; for `n >= 1`.
    pub(crate) fn power(&self, n: &BigUint, bits: u64, toward: Toward, work: &Work) -> Result<Dyadic, Failure> {
        let mut out = self.clone();
        for place in (0..n.bits().saturating_sub(1)).rev() {
            work.product(out.mantissa.bits(), out.mantissa.bits())?;
            out = out.times(&out, bits, toward)?;
            if n.bit(place) {
                work.product(out.mantissa.bits(), self.mantissa.bits())?;
                out = out.times(self, bits, toward)?;
            }
        }
        Ok(out)
    }

    /// The order of two numbers. Where the leading bits stand at different places, they decide; else the exponents
    /// differ by no more than the mantissas have bits.
    pub(crate) fn compare(&self, other: &Dyadic) -> Result<Ordering, Failure> {
        match (self.is_zero(), other.is_zero()) {
            (true, true) => return Ok(Ordering::Equal),
            (true, false) => return Ok(Ordering::Less),
            (false, true) => return Ok(Ordering::Greater),
            (false, false) => {}
        }
        let by_top = self.top().cmp(&other.top());
        if by_top != Ordering::Equal {
            return Ok(by_top);
        }
        let least = self.exponent.min(other.exponent);
        let a = shifted(&self.mantissa, distance(self.exponent, least))?;
        let b = shifted(&other.mantissa, distance(other.exponent, least))?;
        Ok(a.cmp(&b))
    }

    /// The order of the number and a rational that is not negative: that of `mantissa·2^exponent·denominator` and the
    /// numerator.
    pub(crate) fn compare_ratio(&self, ratio: &BigRational) -> Result<Ordering, Failure> {
        let times = Dyadic::new(&self.mantissa * ratio.denom().magnitude(), self.exponent);
        times.compare(&Dyadic::new(ratio.numer().magnitude().clone(), 0))
    }
}

/// All numbers from `lo` to `hi`.
#[derive(Clone, Debug)]
pub(crate) struct Interval {
    /// The lower end.
    pub lo: Dyadic,
    /// The upper end.
    pub hi: Dyadic,
}

impl Interval {
    /// A point.
    pub(crate) fn point(x: Dyadic) -> Interval {
        Interval { lo: x.clone(), hi: x }
    }

    /// A rational that is not negative.
    pub(crate) fn ratio(x: &BigRational, bits: u64) -> Result<Interval, Failure> {
        let part = |of: &BigUint| Interval::point(Dyadic::new(of.clone(), 0));
        part(x.numer().magnitude()).over(&part(x.denom().magnitude()), bits)
    }

    /// The products.
    pub(crate) fn times(&self, other: &Interval, bits: u64) -> Result<Interval, Failure> {
        Ok(Interval {
            lo: self.lo.times(&other.lo, bits, Toward::Down)?,
            hi: self.hi.times(&other.hi, bits, Toward::Up)?,
        })
    }

    /// The quotients; the divisor grows where the quotient falls.
    pub(crate) fn over(&self, other: &Interval, bits: u64) -> Result<Interval, Failure> {
        Ok(Interval {
            lo: self.lo.over(&other.hi, bits, Toward::Down)?,
            hi: self.hi.over(&other.lo, bits, Toward::Up)?,
        })
    }

    /// `1 + x`.
    pub(crate) fn plus_one(&self, bits: u64) -> Result<Interval, Failure> {
        let one = Dyadic::one();
        Ok(Interval {
            lo: self.lo.plus(&one)?.cut(bits, Toward::Down)?,
            hi: self.hi.plus(&one)?.cut(bits, Toward::Up)?,
        })
    }

    /// `x·2^places`, exactly.
    pub(crate) fn scaled(&self, places: i64) -> Result<Interval, Failure> {
        Ok(Interval { lo: self.lo.scaled(places)?, hi: self.hi.scaled(places)? })
    }

    /// `x^n`, for `n >= 1`.
    pub(crate) fn power(&self, n: &BigUint, bits: u64, work: &Work) -> Result<Interval, Failure> {
        Ok(Interval { lo: self.lo.power(n, bits, Toward::Down, work)?, hi: self.hi.power(n, bits, Toward::Up, work)? })
    }
}
