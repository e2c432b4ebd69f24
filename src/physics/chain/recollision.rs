//! Whether bodies meet again after the pass: P-final, the hypothesis that (22)–(24) need to be final.
//!
//! After the pass the bodies still stand in order, so two of them meet again iff some body is faster than its
//! neighbour in front. The last pair never does: `(x − e) <= (1 + e)x`.
//!
//! For optimal masses and one `e` all other pairs do iff `e < x < 1/e`. For unequal coefficients, bodies `i − 1`
//! and `i` (`i < N`) do iff `(x − e_i)(1 + x) > (1 + e_i)·x·(x − e_(i+1))`, that is, iff
//! `−e_i·x² + (1 − e_i + (1 + e_i)e_(i+1))·x − e_i > 0`. With irrational `x` this is never zero: `x` alone is
//! independent of 1, so `e_i = 0`, and then the coefficient of `x` is `1 + e_(i+1)`; for `x² ` rational likewise.

use super::optimum::Optimum;
use super::{ChainError, MAX_LISTED, Restitution, Restitutions, limit_inserted};
use crate::number::NumberError;
use crate::number::interval::Interval;
use crate::number::real::{Level, Real};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Square;
use malachite::base::num::basic::traits::One;
use std::cmp::Ordering;

/// What goes with every list of velocities where bodies meet again.
pub const WARNING: &str = "bodies meet again after the pass: these velocities are not final";

/// What goes with them where that depends on measured inputs.
pub const MAY_WARN: &str = "bodies may meet again after the pass, depending on the inputs: then these are not final";

/// Whether bodies of given velocities, in their order on the line, meet again.
#[must_use]
pub fn of_velocities(velocities: &[Rational]) -> bool {
    velocities.windows(2).any(|pair| matches!(pair, [behind, front] if behind > front))
}

/// Whether bodies of optimal masses meet again, and the level that settled it.
///
/// # Errors
/// A limit where a list of coefficients is too long, or where enclosures cannot tell.
pub fn of_optimum(chain: &Optimum) -> Result<(bool, Level), ChainError> {
    let count = chain.collisions();
    if count == 1 {
        return Ok((false, Level::Exact));
    }
    let x = chain.step();
    match chain.restitutions() {
        Restitutions::Same(e) => Ok(again(&x, e, e)?),
        Restitutions::Each(list) => {
            limit_inserted(count, "coefficients of restitution", MAX_LISTED)?;
            let mut deepest = Level::Double;
            for pair in list.windows(2) {
                let [e, next] = pair else { continue };
                let (answer, level) = again(&x, e, next)?;
                if answer {
                    return Ok((true, level));
                }
                deepest = deepest.max(level);
            }
            Ok((false, deepest))
        }
    }
}

/// Whether the two bodies of the collision with `e` meet again, `next` being the coefficient of the collision
/// that follows.
pub(super) fn again(x: &Real, e: &Restitution, next: &Restitution) -> Result<(bool, Level), NumberError> {
    let (a, up) = (e.value(), e.plus_one());
    let linear = Rational::ONE - a + up * next.value();
    if let Some(x) = x.as_rational() {
        return Ok((&linear * x > a * (x.square() + Rational::ONE), Level::Exact));
    }
    let (sign, level) = x.settle(0, |x| {
        let bits = x.accuracy().clamp(64, 1 << 30);
        let curve = x.square(bits).add(&Interval::from_integer(1), bits).multiply_rational(a, bits);
        x.multiply_rational(&linear, bits).subtract(&curve, bits).sign()
    })?;
    Ok((sign == Ordering::Greater, level))
}
