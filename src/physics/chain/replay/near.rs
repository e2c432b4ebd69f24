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
use malachite::base::num::arithmetic::traits::Sign;
use malachite::base::num::basic::traits::One;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use malachite::{Natural, Rational};
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
        if let (Some(n), Some(d)) = (short(x.numerator_ref()), short(x.denominator_ref())) {
            return Near::quotient(if x.sign() == Ordering::Less { -n } else { n }, d);
        }
        let (middle, order) = f64::rounding_from(x, RoundingMode::Nearest);
        let size = middle.abs();
        let radius = if size >= HUGE {
            f64::INFINITY
        } else if size < TINY {
            TINY
        } else if order == Ordering::Equal {
            0.0
        } else {
            2.0 * U * size
        };
        Near { middle, radius }
    }

    /// A double near the quotient of two whole numbers below `2^53` in size, the second positive.
    fn quotient(n: i64, d: i64) -> Near {
        let middle = n as f64 / d as f64;
        let exact = n == 0 || (d & (d - 1)) == 0;
        Near { middle, radius: if exact { 0.0 } else { 2.0 * U * middle.abs() } }
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

    /// The double, where it is within `2u` times its size; else not a number.
    fn with_relative_error(self) -> f64 {
        if self.radius <= 2.0 * U * self.middle.abs() { self.middle } else { f64::NAN }
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
    /// Those of a pair that takes this much of the difference of velocities.
    pub(super) fn of(left: &Rational, right: &Rational) -> Shares {
        let row = |share: &Rational| {
            let kept = match (short(share.numerator_ref()), short(share.denominator_ref())) {
                (Some(n), Some(d)) => Near::quotient(d - n, d),
                _ => Near::of(&(Rational::ONE - share)),
            };
            [kept, Near::of(share)].map(Near::with_relative_error)
        };
        Shares { left: row(left), right: row(right) }
    }
}

/// A whole number below `2^53`.
fn short(n: &Natural) -> Option<i64> {
    u64::try_from(n).ok().filter(|n| *n < 1 << 53).map(|n| n as i64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use malachite::base::num::arithmetic::traits::Pow;

    fn holds(near: Near, x: &Rational) -> bool {
        let Bounds { lo, hi } = near.bounds();
        let below = lo == f64::NEG_INFINITY || Rational::try_from(lo).is_ok_and(|lo| lo <= *x);
        below && (hi == f64::INFINITY || Rational::try_from(hi).is_ok_and(|hi| hi >= *x))
    }

    /// Numbers of all sizes, exact in doubles and not.
    fn numbers() -> Vec<Rational> {
        let mut numbers = vec![Rational::from(0), Rational::from(1), Rational::from_signeds(-1, 3)];
        for k in [0i64, 52, 53, 54, 499, 501, 900, 1023, 1074, 1100] {
            for n in [1i64, 3, -5, 1_000_003] {
                numbers.extend([k, -k].map(|k| Rational::from(n) * Rational::from(2).pow(k)));
                numbers.push(Rational::from_signeds(n, 3) * Rational::from(2).pow(-k) + Rational::from(1));
            }
        }
        numbers
    }

    #[test]
    fn every_operation_contains_the_exact_result() {
        let numbers = numbers();
        for x in &numbers {
            assert!(holds(Near::of(x), x), "{x}");
            for y in &numbers {
                let difference = Near::of(x).less(Near::of(y));
                assert!(holds(difference, &(x - y)), "{x} {y}");
                assert!(difference.sign().is_none_or(|sign| sign == x.cmp(y)), "{x} {y}");
                let Bounds { lo, hi } = Near::of(x).over(Near::of(y));
                if *y > 0 && lo.is_finite() && hi.is_finite() {
                    let quotient = x / y;
                    assert!(lo <= hi && Rational::try_from(lo).is_ok_and(|lo| lo <= quotient), "{x} {y}");
                    assert!(Rational::try_from(hi).is_ok_and(|hi| hi >= quotient), "{x} {y}");
                }
            }
        }
    }

    #[test]
    fn courses_contain_the_exact_worldlines_collision_after_collision() {
        let numbers = numbers();
        let shares: Vec<Rational> = [(0, 1), (1, 1), (2, 1), (1, 3), (19, 10), (1, 1_000_000_007)]
            .into_iter()
            .map(|(n, d)| Rational::from_signeds(n, d))
            .chain([Rational::from(2).pow(-600i64), Rational::from(2) - Rational::from(2).pow(-1080i64)])
            .collect();
        for (i, x) in numbers.iter().enumerate() {
            let y = &numbers[(i * 7 + 3) % numbers.len()];
            for (j, share) in shares.iter().enumerate() {
                let other = &shares[(j + i) % shares.len()];
                let matrix = Shares::of(share, other);
                let (mut left, mut right) = ((x.clone(), y.clone()), (y.clone(), x.clone()));
                let mut near = (Course::of(x, y), Course::of(y, x));
                for round in 0..6 {
                    let mixed = |x: &Rational, y: &Rational| (x - share * (x - y), y + other * (x - y));
                    let (b, v) = (mixed(&left.0, &right.0), mixed(&left.1, &right.1));
                    (left, right) = ((b.0, v.0), (b.1, v.1));
                    near = Course::after(&matrix, &near.0, &near.1);
                    for (near, exact) in [(near.0, &left), (near.1, &right)] {
                        assert!(holds(near.b(), &exact.0), "{x} {y} {share} {other} round {round}");
                        assert!(holds(near.v(), &exact.1), "{x} {y} {share} {other} round {round}");
                        assert!(!(near.v().radius == 0.0 && exact.1 != near.v().middle), "{x} {y}: not exact");
                    }
                }
            }
        }
    }
}
