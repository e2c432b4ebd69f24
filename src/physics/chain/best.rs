//! The best number of inserted bodies, `n* = #{n >= 1 : L_n <= e}` (B-best): `L_n` rises with `n`.
//!
//! **Method.** A guess, then two certified comparisons: `L_(n*) <= e < L_(n*+1)`. With `d = ln(r)/2`, (25) as a
//! function of a real number `N` of collisions is greatest at `N = |d|/u`, `u·tanh u − ln cosh u = ln(2/(1+e))`, and
//! `n*` is about `N − 1/2`; for a small right-hand side `c`, `u²` is about `2c`. Beyond the digits of a double the guess
//! is refined: `1 − L_n` is nearly `d²/(n(n+1))`. A guess that is off costs more comparisons, never a wrong
//! answer: the certified ones bracket `n*`, and the bracket is halved.
//!
//! **Cost.** For a good guess three comparisons, of a squaring for each binary digit of `n*` each.

use super::{ChainError, Positive, Restitution, threshold};
use crate::number::NumberError;
use crate::number::real::Level;
use crate::number::root::guess_ln;
use malachite::base::num::arithmetic::traits::{FloorSqrt, PowerOf2};
use malachite::base::num::basic::traits::{One, Two, Zero};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::rounding_modes::RoundingMode;
use malachite::{Natural, Rational};
use std::cmp::Ordering;

/// The most bits of `n*`.
pub const MAX_COUNT_BITS: u64 = 2_048;

/// Guesses of more bits than this need more than a double.
const DOUBLE_BITS: u64 = 40;

/// The number of inserted bodies that transfers most energy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Best {
    /// That many; with `tie`, one fewer does exactly as well (`e = L_n*`).
    Finite {
        /// `n*`.
        count: Natural,
        /// Whether `e = L_n*`.
        tie: bool,
    },
    /// Every further body helps: `e = 1` and unequal masses.
    Infinite,
    /// Every number does as well as any other: `e = 1` and equal masses.
    Any,
}

/// `n*` for the mass ratio `r = m1/m2`, and the dearest level that was needed.
///
/// # Errors
/// [`NumberError::LimitReached`] above [`MAX_COUNT_BITS`], or where enclosures cannot tell.
pub fn best(r: &Positive, e: &Restitution) -> Result<(Best, Level), ChainError> {
    let equal = *r.value() == Rational::ONE;
    if *e.value() == Rational::ONE {
        return Ok((if equal { Best::Any } else { Best::Infinite }, Level::Exact));
    }
    let mut search = Search { r, e, level: Level::Double, tie: None };
    if equal || *e.value() == Rational::ZERO {
        return Ok((Best::Finite { count: Natural::ZERO, tie: false }, Level::Exact));
    }
    let guess = refined(r, e, guess(r.value(), e.value()));
    // A bracket: helps(low) and not helps(high), where 0 counts as helping.
    let (mut low, mut high) = (Natural::ZERO, None);
    let mut probe = guess;
    let mut reach = Natural::ONE;
    loop {
        if probe == 0u32 {
            // Nothing to ask: zero bodies need no threshold.
        } else if search.helps(&probe)? {
            low = probe;
        } else {
            high = Some(probe);
        }
        match &high {
            Some(high) if &low + Natural::ONE >= *high => break,
            // Towards the other end, in steps that double while it is open; then halving.
            Some(high) if low > 0u32 || high.significant_bits() <= 2 || reach > *high => {
                probe = (&low + high) >> 1u32;
            }
            Some(high) => probe = if *high > reach { high - &reach } else { Natural::ONE },
            None => {
                probe = &low + &reach;
                if probe.significant_bits() > MAX_COUNT_BITS {
                    return Err(too_many(&probe).into());
                }
            }
        }
        reach <<= 1u32;
    }
    let tie = search.tie.as_ref() == Some(&low);
    Ok((Best::Finite { count: low, tie }, search.level))
}

fn too_many(count: &Natural) -> NumberError {
    let needed = count.significant_bits().to_string();
    NumberError::LimitReached { limit: "bits of the best number of bodies", allowed: MAX_COUNT_BITS, needed }
}

/// The comparisons made so far.
struct Search<'a> {
    r: &'a Positive,
    e: &'a Restitution,
    level: Level,
    tie: Option<Natural>,
}

impl Search<'_> {
    /// Whether `L_n <= e`.
    fn helps(&mut self, n: &Natural) -> Result<bool, ChainError> {
        if n.significant_bits() > MAX_COUNT_BITS {
            return Err(too_many(n).into());
        }
        let (order, level) = threshold::compare(self.e, self.r, n)?;
        self.level = self.level.max(level);
        if order == Ordering::Equal {
            self.tie = Some(n.clone());
        }
        Ok(order != Ordering::Less)
    }
}

/// A guess with about twice as many digits, where `n*` has more than a double can tell; may be wrong.
fn refined(r: &Positive, e: &Restitution, guess: Natural) -> Natural {
    let size = guess.significant_bits();
    if size <= DOUBLE_BITS || size > MAX_COUNT_BITS {
        return guess;
    }
    let missing = threshold::shortfall(r, &guess, size + 96);
    let Some(missing) = missing.middle(size + 96).point().filter(|m| *m > Rational::ZERO) else { return guess };
    // n(n + 1)·(1 − L_n) hardly depends on n.
    let product = Rational::from(&guess * (&guess + Natural::ONE));
    let wanted = product * missing / (Rational::ONE - e.value());
    Natural::rounding_from(wanted, RoundingMode::Floor).0.floor_sqrt()
}

/// About `n*`; may be wrong.
fn guess(r: &Rational, e: &Rational) -> Natural {
    let d = guess_ln(r).abs() / 2.0;
    // c = −ln(1 − δ), δ = (1 − e)/2 in (0, 1/2).
    let delta = (Rational::ONE - e) / Rational::TWO;
    let small = f64::rounding_from(&delta, RoundingMode::Nearest).0;
    if small < 1e-9 || d < 1e-200 {
        // n ≈ |d|/u, u² = 2δ(1 + …): in integers, for any size.
        let Ok(d) = Rational::try_from(d) else { return Natural::ONE };
        let square = &d * &d / (delta * Rational::TWO);
        let scale = 128;
        let scaled = square * Rational::power_of_2(2 * scale as i64);
        let root = Natural::rounding_from(scaled, RoundingMode::Floor).0.floor_sqrt();
        return root >> scale;
    }
    let c = -(-small).ln_1p();
    let u = guess_crossing(c);
    let count = d / u - 0.5;
    if count.is_finite() && count >= 1.0 { Natural::rounding_from(count, RoundingMode::Floor).0 } else { Natural::ONE }
}

/// About the `u > 0` with `u·tanh u − ln cosh u = c`.
fn guess_crossing(c: f64) -> f64 {
    // The derivative is u/cosh²u; the left side is below u²/2 and tends to ln 2.
    let mut u = (2.0 * c).sqrt().max(1e-160);
    for _ in 0..60 {
        let log_cosh = u + (-2.0 * u).exp().ln_1p() - std::f64::consts::LN_2;
        let value = if u < 1e-2 { u * u / 2.0 - u.powi(4) / 4.0 + u.powi(6) / 9.0 } else { u * u.tanh() - log_cosh };
        let slope = u / u.cosh().powi(2);
        let next = u + ((c - value) / slope).clamp(-u / 2.0, 1.0);
        if (next - u).abs() <= 1e-16 * u {
            return next;
        }
        u = next;
    }
    u
}
