//! The energy transfer eta of a chain of optimal masses, (25): `∏(1+e_i)²·(t/(1+t)²)^N`, `t = r^(1/N)`.
//!
//! It depends on the masses through `r` only and is the same for `r` and `1/r`. In this form nothing overflows
//! and nothing cancels. For given masses see [`super::pass::Pass::transfer`].

use super::optimum::{exact_bits, factor_text, root_text};
use super::{ChainError, MAX_EXACT_BITS, MAX_INSERTED, Positive, Restitutions, limit_inserted};
use crate::number::double::Double;
use crate::number::fixed::{Fixed, above_one, in_words, two_words};
use crate::number::interval::Interval;
use crate::number::parallel::{MIN_BITS, both};
use crate::number::product::quotient;
use crate::number::rational::exact_root;
use crate::number::real::Real;
use crate::number::root::root;
use malachite::base::num::arithmetic::traits::{Pow, Reciprocal, Square};
use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};

/// From so many bits on, and up to so many collisions, [`merged`] is quicker (bench `numbers`, group `digits`).
const MERGED_BITS: u64 = 5_000;
const MERGED_COUNT: u64 = 1 << 16;

/// The same in machine words, where the operands are formed by halves at a lower price.
const MERGED_WORD_BITS: u64 = 24 * 64;
const MERGED_WORD_COUNT: u64 = 24;

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
            Gains { base: Rational::from(quotient(above, below)).square(), count: 1 }
        }
    };
    let exact = exact_root(&r, count);
    if let Some(t) = &exact {
        let share = t / (t + Rational::ONE).square();
        if gains.count == count {
            // One power: the factors may be long where it is short, as 1 = 1/4·4.
            let both = &share * &gains.base;
            if exact_bits(&both, count) <= MAX_EXACT_BITS {
                return Ok(Real::rational(both.pow(count)));
            }
        }
        let size = exact_bits(&share, count).saturating_add(exact_bits(&gains.base, gains.count));
        if size <= MAX_EXACT_BITS {
            return Ok(Real::rational(share.pow(count) * gains.base.pow(gains.count)));
        }
    }
    let text = {
        let (base, power, r) = (gains.base.clone(), gains.count, r.clone());
        move || {
            let root = root_text(&r, 1, count);
            format!("{}^{power}*{}/(1 + {root})^{}", factor_text(&base), factor_text(&r), 2 * count)
        }
    };
    let quick = quick(&r, &gains, count);
    let degree = Natural::from(count);
    let both = Natural::from(2 * count);
    let enclose = move |bits: u64| {
        if let Some(found) = in_words(&r, &gains, count, bits) {
            return found;
        }
        if bits >= MERGED_BITS && count <= MERGED_COUNT {
            return merged(&r, &gains, count, bits);
        }
        let work = bits + count.significant_bits() + 12;
        let t = root(&r, &degree, work);
        let sum = t.add(&Interval::from_integer(1), work);
        let below = sum.power(&both, work).reciprocal(work);
        gains.multiply(&below, work).multiply_rational(&r, bits + 4)
    };
    Ok(Real::enclosed(enclose).with_quick(move || quick.to_interval()).with_radical(text))
}

/// eta in machine words, where the ratio and the coefficient are short and so many bits fit.
fn in_words(r: &Rational, gains: &Gains, count: u64, bits: u64) -> Option<Interval> {
    let r = if gains.count == count { above_one(r)? } else { return None };
    // ((1 + e)/2)², not above 1.
    let gain = two_words(&(&gains.base >> 2u32))?;
    if bits <= MERGED_WORD_BITS || count > MERGED_WORD_COUNT {
        return in_words!(
            bits, bits, share_in_words(r, gain, count),
            <3>, <4>, <6>, <8>, <10>, <12>, <14>, <16>, <20>, <24>, <32>, <46>, <64>, <94>
        );
    }
    let base = two_words(&gains.base)?;
    let lost = (2.0 * count as f64 * root_of(r, count).ln_1p() * std::f64::consts::LOG2_E) as u64;
    let room = bits.saturating_add(lost);
    in_words!(
        room, bits, merged_in_words(r, base, count),
        <24, 13>, <28, 15>, <32, 17>, <36, 19>, <40, 21>, <46, 24>, <54, 28>, <62, 32>, <70, 36>, <80, 41>, <94, 48>,
        <110, 56>, <126, 64>
    )
}

/// About `r^(1/N)`, for guesses.
fn root_of(r: (u64, u64), count: u64) -> f64 {
    (r.0 as f64 / r.1 as f64).powf(1.0 / count as f64)
}

/// `(g·4z/(1 + z)²)^N`, `z = r^(−1/N)`, for `r > 1` and `g = ((1 + e)/2)²`: eta by (25), with each of its factors at most 1.
fn share_in_words<const L: usize>(r: (u64, u64), gain: (u64, u64), count: u64) -> Option<Fixed<L>> {
    let z = Fixed::<L>::inverse_root(r.0, r.1, count)?;
    let half_sum = z.halfway_to_one()?;
    z.times_rational(gain.0, gain.1)?.over(&half_sum.square()?)?.power(count)
}

/// As [`merged`], from a point `v` of `H` words. With `g = (1 + e)²` and `φ = (1 − v)^N/r − v^N = ρ·v^N`:
/// `eta = g^N·r·(v^(2N) + 2φ·(1 − v)·v^N + κ·v^(2N))`, and `|κ|·v^(2N) <= 11φ²`. The sum begins about `2N·log2(1 + t)` places
/// behind the point, and so many are lost.
fn merged_in_words<const L: usize, const H: usize>(r: (u64, u64), gain: (u64, u64), count: u64) -> Option<Fixed<L>> {
    let z = Fixed::<H>::inverse_root(r.0, r.1, count)?;
    let v = z.over(&z.halfway_to_one()?)?.half()?.resized::<L>();
    let rest = v.one_minus()?;
    let (a, b) = (rest.power(count)?, v.power(count)?);
    let (above, phi) = a.times_rational(r.1, r.0)?.distance(&b)?;
    // |ρ| <= 2^-36.
    if phi.zeros() < b.least()? + 36 {
        return None;
    }
    let correction = b.times(&rest.times(&phi)?)?.times_power_of_2(1)?;
    let main = b.square()?.plus(above, &correction)?.widened(11, &phi)?;
    main.times_power(gain.0, gain.1, count)?.times_rational(r.0, r.1)
}

/// eta at many bits, the last Newton step of the root merged with the formula.
///
/// For `r >= 1` (else for `1/r`, which has the same eta) and `v = 1/(1 + t)`: `eta = g·r·v^(2N)`, `g` the gains, and `(1 − v)^N = r·v^N`.
/// From a point `v` of half the digits, with `f = (1 − v)^N − r·v^N` and `ρ = f/(r·v^N)`, [`super::fast`] shows
/// `eta = g·r·v^(2N)·(1 + 2ρ·(1 − v) + κ)`, `|κ| <= 11ρ²` for `|ρ| <= 2^-36`: that is `g·(r·v^(2N) + 2f·(1 − v)·v^N)` and a rest. At full length
/// there are two powers, which begin with operands of half the length and do not wait for each other, and one square;
/// no root and no division.
fn merged(r: &Rational, gains: &Gains, count: u64, bits: u64) -> Interval {
    let r = if *r < Rational::ONE { r.reciprocal() } else { r.clone() };
    let size = count.significant_bits();
    let work = bits + 2 * size + 16;
    let half = work / 2 + 2 * size + 48;
    let one = Interval::from_integer(1);
    let degree = Natural::from(count);
    let v = root(&r, &degree, half).add(&one, half).reciprocal(half).middle(half);
    let rest = one.subtract(&v, u64::MAX);
    let (a, b) = both(work >= MIN_BITS, || rest.power(&degree, work), || v.power(&degree, work));
    let scaled = b.multiply_rational(&r, work);
    let f = a.subtract(&scaled, work);
    let rho = f.divide(&scaled.round(64), 64);
    if rho.is_whole() || rho.top() > -36 {
        return Interval::whole();
    }
    let correction = f.multiply(&rest, half).multiply(&b, half).shifted(1);
    let main = b.square(work).multiply_rational(&r, work);
    let tail = main.round(64).multiply(&rho.square(64), 64).multiply(&Interval::from_integer(11), 64);
    gains.multiply(&main.add(&correction, work).widened(&tail), bits + 4)
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
