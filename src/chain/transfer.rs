//! The energy transfer eta of a chain of optimal masses, (25): `∏(1+e_i)²·(t/(1+t)²)^N`, `t = r^(1/N)`.
//!
//! It depends on the masses through `r` only and is the same for `r` and `1/r`. In this form nothing overflows
//! and nothing cancels. For given masses see [`super::pass::Pass::transfer`].

use super::optimum::{exact_bits, factor_text, root_text};
use super::pass::product;
use super::{ChainError, MAX_EXACT_BITS, MAX_INSERTED, Positive, Restitutions, limit_inserted};
use crate::number::double::Double;
use crate::number::interval::Interval;
use crate::number::rational::exact_root;
use crate::number::real::Real;
use crate::number::root::root;
use malachite::base::num::arithmetic::traits::{Pow, Square};
use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};

/// Exact powers of `1 + e` up to so many bits enter as short factors; longer ones are enclosed.
const SHORT_BITS: u64 = 4_096;

/// eta for the mass ratio `r = m1/m2` and `n` inserted bodies of optimal mass.
///
/// # Errors
/// [`ChainError::Count`] for a list of coefficients of the wrong length; a limit above [`MAX_INSERTED`].
pub fn optimal(r: &Positive, restitutions: &Restitutions, n: u64) -> Result<Real, ChainError> {
    limit_inserted(n, "inserted bodies", MAX_INSERTED)?;
    let count = n + 1;
    let r = r.value().clone();
    let gains = match restitutions.clone().for_inserted(n)? {
        Restitutions::Same(e) => Gains { base: e.plus_one().square(), count },
        Restitutions::Each(list) => {
            let factors = list.iter().map(|e| e.plus_one().into_numerator_and_denominator());
            let (above, below): (Vec<Natural>, Vec<Natural>) = factors.unzip();
            Gains { base: Rational::from_naturals(product(above), product(below)).square(), count: 1 }
        }
    };
    let exact = exact_root(&r, count);
    if let Some(t) = &exact {
        let share = t / (t + Rational::ONE).square();
        let size = exact_bits(&share, count).saturating_add(exact_bits(&gains.base, gains.count));
        if size <= MAX_EXACT_BITS {
            return Ok(Real::rational(share.pow(count) * gains.base.pow(gains.count)));
        }
    }
    let text = format!(
        "{}^{}*{}/(1 + {})^{}",
        factor_text(&gains.base),
        gains.count,
        factor_text(&r),
        root_text(&r, 1, count),
        2 * count
    );
    let quick = quick(&r, &gains, count);
    let degree = Natural::from(count);
    let both = Natural::from(2 * count);
    let enclose = move |bits: u64| {
        let work = bits + count.significant_bits() + 12;
        let t = root(&r, &degree, work);
        let sum = t.add(&Interval::from_integer(1), work);
        let below = sum.power(&both, work).reciprocal(work);
        gains.multiply(&below, work).multiply_rational(&r, bits + 4)
    };
    Ok(Real::enclosed(enclose).with_quick(move || quick.to_interval()).with_radical(text))
}

/// `base^count`: the product of all `(1 + e_i)²`.
struct Gains {
    base: Rational,
    count: u64,
}

impl Gains {
    /// The product with an enclosure.
    fn multiply(&self, x: &Interval, bits: u64) -> Interval {
        if exact_bits(&self.base, self.count) <= SHORT_BITS {
            return x.multiply_rational(&(&self.base).pow(self.count), bits);
        }
        let work = bits + self.count.significant_bits() + 4;
        Interval::from_rational(&self.base, work).power(&Natural::from(self.count), work).multiply(x, bits)
    }
}

/// eta in double-double.
fn quick(r: &Rational, gains: &Gains, count: u64) -> Double {
    let t = Double::from_rational(r).root(count);
    let one = Double::exact(1.0);
    let sum = t.plus(one);
    let base = Double::from_rational(&gains.base);
    // One power for all where the base is the same: nothing overflows on the way.
    if gains.count == count {
        base.multiply(t).divide(sum.multiply(sum)).power(count)
    } else {
        t.divide(sum.multiply(sum)).power(count).multiply(base.power(gains.count))
    }
}
