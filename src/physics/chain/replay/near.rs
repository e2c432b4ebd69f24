//! Worldlines in double precision with a proved error: the first look at an exact state.
//!
//! Contract: a [`Near`] stands for a number that is at most `radius` from `middle`; where the radius is infinite or not a
//! number, nothing is known. [`Course::after`] contains intercept and velocity after a collision, [`Near::less`] a
//! difference, [`Near::over`] a quotient.
//!
//! **Why the bounds hold.** `u = 2^-53`, `TINY = 2^-500`. A sum or a product of doubles is off by at most `u` times its
//! size, a product that underflows by `2^-1075` more. Radii are computed by at most eight such operations on numbers that
//! are not negative, and enlarged by `1 + 32u`, which covers them.
//! - *Range.* Shares, and middles of courses with radius 0, are 0 or at least `TINY`; radii of courses are 0 or at least
//!   `2^-552`. A share is within `2u` times its size, or not a number.
//! - *Collision.* Let `p`, `q` be the computed products of the shares with the middles. The numbers times the shares are
//!   off by at most `|share|·radius·(1 + 2u) + 2u·|product|` each, the products by `u` times their size, the sum by
//!   `u·(|p| + |q|)`: together less than `Σ |share|·radius + 8u·(|p| + |q|)`, enlarged. Underflow adds less than `TINY`.
//!   Where the computed radius is 0, each product has a factor that is exactly 0, for a product of two factors in range is at
//!   least `2^-1052`: then the result is exactly 0.
//! - *Difference.* A difference of doubles never underflows: `2u` times its size, and both radii.
//! - *Quotient.* For `|g − g°| ≤ r`, `|s − s°| ≤ ρ < s°` and `t = g°/s°`, `g/s − t = (g − g° − t·(s − s°))/s`, at most
//!   `(r + |t|·ρ)/(s° − ρ)` in size. The computed `s° − ρ` is positive exactly where the number is, and is off by `u`
//!   times its size. Where `t` underflows, `|t|·ρ/(s° − ρ)` is off by at most `2^-1074·2^54`, less than `TINY`.
//! - *Overflow.* A middle that is infinite or not a number comes from a product or a sum whose size is in the radius, which
//!   is then neither finite.

use super::bounds::Bounds;
use super::line::Pair;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use std::cmp::Ordering;

/// The relative error of one operation.
const U: f64 = f64::EPSILON / 2.0;

/// More than all that underflow can take away.
const TINY: f64 = f64::from_bits((1023 - 500) << 52);

/// Numbers from here on are not followed in doubles.
const HUGE: f64 = f64::from_bits((1023 + 500) << 52);

/// Covers the roundings of a radius.
const UP: f64 = 1.0 + 32.0 * U;

/// A number near a double.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    middle: f64,
    radius: f64,
}

impl Near {
    /// A double near an exact number.
    pub(super) fn of(x: &Rational) -> Near {
        let short = |n: &malachite::Natural| u64::try_from(n).ok().filter(|n| *n < 1 << 53);
        let (middle, exact) = match (short(x.numerator_ref()), short(x.denominator_ref())) {
            (Some(n), Some(d)) => {
                let size = n as f64 / d as f64;
                (if *x < Rational::ZERO { -size } else { size }, d.is_power_of_two() || n == 0)
            }
            _ => {
                let (near, order) = f64::rounding_from(x, RoundingMode::Nearest);
                (near, order == Ordering::Equal)
            }
        };
        let size = middle.abs();
        if size >= HUGE {
            return Near { middle, radius: f64::INFINITY };
        }
        let radius = if size < TINY && *x != Rational::ZERO {
            TINY
        } else if exact {
            0.0
        } else {
            2.0 * U * size
        };
        Near { middle, radius }
    }

    /// The difference.
    #[inline]
    pub(super) fn less(self, other: Near) -> Near {
        let middle = self.middle - other.middle;
        Near { middle, radius: (self.radius + other.radius + 2.0 * U * middle.abs()) * UP }
    }

    /// The quotient by a number that is known to be positive; the whole line where the doubles do not show it.
    #[inline]
    pub(super) fn over(self, speed: Near) -> Bounds {
        let least = speed.middle - speed.radius;
        let middle = self.middle / speed.middle;
        let radius = ((self.radius + middle.abs() * speed.radius) / least + 2.0 * U * middle.abs()) * UP + TINY;
        if least > 0.0 { Near { middle, radius }.bounds() } else { Bounds::WHOLE }
    }

    /// The sign, where the doubles show it.
    #[inline]
    pub(super) fn sign(self) -> Option<Ordering> {
        if self.middle > self.radius {
            Some(Ordering::Greater)
        } else if self.middle < -self.radius {
            Some(Ordering::Less)
        } else if self.middle == 0.0 && self.radius == 0.0 {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    /// The doubles that the number lies between.
    #[inline]
    pub(super) fn bounds(self) -> Bounds {
        if self.middle.is_finite() && self.radius < f64::INFINITY {
            Bounds { lo: (self.middle - self.radius).next_down(), hi: (self.middle + self.radius).next_up() }
        } else {
            Bounds::WHOLE
        }
    }
}

/// Intercept and velocity of a worldline.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course {
    middle: [f64; 2],
    radius: [f64; 2],
}

impl Course {
    /// The doubles near an exact worldline.
    pub(super) fn of(intercept: &Rational, velocity: &Rational) -> Course {
        let (b, v) = (Near::of(intercept), Near::of(velocity));
        Course { middle: [b.middle, v.middle], radius: [b.radius, v.radius] }
    }

    /// The intercept.
    #[inline]
    pub(super) fn b(&self) -> Near {
        Near { middle: self.middle[0], radius: self.radius[0] }
    }

    /// The velocity.
    #[inline]
    pub(super) fn v(&self) -> Near {
        Near { middle: self.middle[1], radius: self.radius[1] }
    }

    /// The courses of two points after their collision.
    #[inline]
    pub(super) fn after(shares: &Shares, left: &Course, right: &Course) -> (Course, Course) {
        (mixed(shares.left, left, right), mixed(shares.right, right, left))
    }
}

/// `kept·own + given·other`, for the intercept and for the velocity.
#[inline]
fn mixed([kept, given]: [f64; 2], own: &Course, other: &Course) -> Course {
    if kept == 1.0 && given == 0.0 {
        // A wall.
        return *own;
    }
    let mut new = Course { middle: [0.0; 2], radius: [0.0; 2] };
    for i in 0..2 {
        let (p, q) = (kept * own.middle[i], given * other.middle[i]);
        let spread = kept.abs() * own.radius[i] + given.abs() * other.radius[i];
        let radius = spread + 8.0 * U * (p.abs() + q.abs());
        new.middle[i] = p + q;
        new.radius[i] = if radius == 0.0 { 0.0 } else { radius * UP + TINY };
    }
    new
}

/// What each point of a pair keeps of its own course in a collision, and what it takes of the other's.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shares {
    left: [f64; 2],
    right: [f64; 2],
}

impl Shares {
    /// Those of a pair.
    pub(super) fn of(pair: &Pair) -> Shares {
        let double = |x: &Rational| {
            let near = Near::of(x);
            if near.radius <= 2.0 * U * near.middle.abs() { near.middle } else { f64::NAN }
        };
        let row = |share: &Rational| [double(&(Rational::ONE - share)), double(share)];
        Shares { left: row(&pair.left), right: row(&pair.right) }
    }
}
