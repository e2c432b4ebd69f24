//! Roots and reciprocals: guessed in floating point, certified by a power; or integer square roots and quotients.
//!
//! **Contract.** [`root`] encloses `r^(1/k)` for a positive rational `r` and `k >= 1`; [`Interval::reciprocal`]
//! encloses `1/x`. Nothing rests on the guess: a bad one gives a wide result or the whole line.
//!
//! **Method.** For a point `y > 0` near `s^(−1/k)` let `ρ = s·y^k − 1`. Then `s^(−1/k) = y·(1 + ρ)^(−1/k)` exactly, and
//! for `|ρ| <= 1/16` Taylor's theorem gives `(1 + ρ)^(−1/k) = 1 − ρ/k + θ` with
//! `|θ| <= (1/k)(1/k + 1)/2·(15/16)^(−3)·ρ² <= 2ρ²/k`: an enclosure, and at once a Newton step that doubles the
//! digits. No division takes part but that by `k` (and by the short numbers of `s`).
//!
//! Casts between integers and doubles, which round or saturate, occur in guesses only.
//!
//! **Cost.** Precision doubles from step to step, so all of them together cost about twice the last:
//! a squaring for each binary digit of `k`.

use super::interval::{Interval, NEWTON_DIVISION_BITS};
use malachite::base::num::arithmetic::traits::{CheckedLogBase2, Reciprocal};
use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Natural, Rational};
use std::cmp::Ordering;

/// Up to so many bits roots with a power of two as index are taken by square roots (bench `numbers`, group `digits`):
/// each costs about a product, and a Newton step some of them. An odd factor of the index leaves the Newton steps to do.
const SQUARE_ROOT_BITS: u64 = 32_000;

/// Digits that a floating-point guess is expected to have; only speed depends on it.
const GUESS_BITS: u64 = 28;

/// `r^(1/k)` with about `bits` bits; the whole line for `r <= 0` or `k = 0`.
#[must_use]
pub fn root(r: &Rational, k: &Natural, bits: u64) -> Interval {
    if *r <= 0 || *k == 0 {
        return Interval::whole();
    }
    if *k == Natural::ONE {
        return Interval::from_rational(r, bits);
    }
    if let Some(halvings) = k.checked_log_base_2().filter(|_| bits <= SQUARE_ROOT_BITS) {
        // Each square root halves the relative error and adds some units of its own.
        let first = Interval::from_rational(r, bits + 6);
        return (0..halvings).fold(first, |x, _| x.square_root(bits + 6)).round(bits + 2);
    }
    let inverse = r.reciprocal();
    inverse_root(&|y, bits| y.multiply_rational(&inverse, bits), guess_root(r, k), k, bits)
}

impl Interval {
    /// All reciprocals; the whole line where zero may be an element.
    #[must_use]
    pub fn reciprocal(&self, bits: u64) -> Interval {
        match self.sign() {
            Some(Ordering::Greater) if bits <= NEWTON_DIVISION_BITS => Interval::from_integer(1).divide(self, bits),
            Some(Ordering::Greater) => {
                let guess = Interval::from_integer(1).divide(&self.round(64), 64).middle(60);
                // Early steps need few digits of the number.
                inverse_root(&|y, bits| y.multiply(&self.round(bits + 8), bits), guess, &Natural::ONE, bits)
            }
            Some(Ordering::Less) => self.negated().reciprocal(bits).negated(),
            _ => Interval::whole(),
        }
    }
}

/// Encloses `s^(−1/k)`, where `times_s(y, bits)` encloses `s·y`.
fn inverse_root(times_s: &dyn Fn(&Interval, u64) -> Interval, guess: Interval, k: &Natural, bits: u64) -> Interval {
    let size = k.significant_bits();
    // ρ is k times as large as the relative error of y.
    let last = bits.saturating_sub(size).max(GUESS_BITS) + 6;
    let mut steps = vec![last];
    while let Some(&step) = steps.last()
        && step > 2 * GUESS_BITS
    {
        steps.push(step / 2 + 3);
    }
    let mut y = guess;
    let mut result = Interval::whole();
    for precision in steps.into_iter().rev() {
        let work = precision + size + 4;
        result = step(times_s, &y, k, precision, work);
        if result.is_whole() {
            return result;
        }
        y = result.middle(work);
    }
    result.round(bits + 2)
}

/// One certified Newton step from the point `y`.
fn step(
    times_s: &dyn Fn(&Interval, u64) -> Interval,
    y: &Interval,
    k: &Natural,
    precision: u64,
    work: u64,
) -> Interval {
    let one = Interval::from_integer(1);
    let rho = times_s(&y.power(k, precision + 4), precision + 4).subtract(&one, precision + 4);
    // |ρ| < 2^top <= 1/16.
    let top = rho.top();
    if rho.is_whole() || top > -4 {
        return Interval::whole();
    }
    if top == i64::MIN {
        return y.clone();
    }
    // Digits of y·ρ/k below the precision are not needed: ρ is small.
    let places = u64::try_from(i64::try_from(precision).unwrap_or(i64::MAX).saturating_add(top)).unwrap_or(0) + 6;
    let correction = y.multiply(&rho, places).divide_by_natural(k, places);
    let tail = y.round(40).multiply(&rho.square(40), 40).divide_by_natural(k, 40).shifted(1);
    y.subtract(&correction, work).widened(&tail)
}

/// About `r^(1/k)`, as a point; for guesses only.
fn guess_root(r: &Rational, k: &Natural) -> Interval {
    let log = guess_ln(r);
    let (mantissa, exponent) = mantissa_exponent(k);
    // log/k may be far below the range of doubles: it is scaled by 2^exponent, and back at the end.
    let scaled = log / mantissa;
    let quotient = if exponent < 900 { scaled * (-(exponent as f64)).exp2() } else { 0.0 };
    if quotient.abs() < 0.25 {
        // 1 + (e^q − 1), with e^q − 1 = q·(1 + …) where q is tiny.
        let ratio = if quotient == 0.0 { 1.0 } else { quotient.exp_m1() / quotient };
        let near = Interval::from_f64(scaled * ratio).shifted(-exponent);
        if near.is_whole() {
            return Interval::from_integer(1);
        }
        return Interval::from_integer(1).add(&near, 64 + k.significant_bits());
    }
    // e^q = 2^whole·2^part.
    let binary = quotient * std::f64::consts::LOG2_E;
    let whole = binary.floor();
    Interval::from_f64((binary - whole).exp2()).shifted(whole as i64)
}

/// `x` as about `mantissa·2^exponent` with a mantissa in [1/2, 1].
fn mantissa_exponent(x: &Natural) -> (f64, i64) {
    let bits = x.significant_bits();
    let shift = bits.saturating_sub(64);
    let top = u64::try_from(&(x >> shift)).unwrap_or(u64::MAX);
    let scale = i32::try_from(bits - shift).unwrap_or(64);
    (top as f64 * (-f64::from(scale)).exp2(), i64::try_from(bits).unwrap_or(i64::MAX))
}

/// About `ln r` for a positive rational; for guesses only. Zero where it is below the range of doubles.
#[must_use]
pub fn guess_ln(r: &Rational) -> f64 {
    let (numerator, denominator) = (r.numerator_ref(), r.denominator_ref());
    let ((p, p_exponent), (q, q_exponent)) = (mantissa_exponent(numerator), mantissa_exponent(denominator));
    let difference = Integer::from(numerator) - Integer::from(denominator);
    if difference == 0 {
        return 0.0;
    }
    if (p_exponent - q_exponent).abs() <= 1 {
        let (d, d_exponent) = mantissa_exponent(difference.unsigned_abs_ref());
        let gap = ((d_exponent - q_exponent) as f64).exp2();
        let relative = if difference < 0 { -d / q * gap } else { d / q * gap };
        if relative.abs() < 0.5 {
            return relative.ln_1p();
        }
    }
    (p / q).ln() + (p_exponent - q_exponent) as f64 * std::f64::consts::LN_2
}
