//! Inelastic collapse: infinitely many collisions before a finite time, proved.
//!
//! **Three points** (a wall may be one), the middle one hit from its two sides in turn. Let `s > 0` be the speed
//! at which the pair that is due approaches, `w ≥ 0` that at which the other separates. A collision of the pair
//! `A` gives the middle body a velocity that makes the other pair approach at `a·s − w`, and leaves `A`
//! separating at `e_A·s`. Over both collisions `(s, w)` is multiplied by
//! `P = [[a·c − e_A, −c], [e_B·a, −e_B]]`, `trace P = a·c − e_A − e_B`, `det P = e_A·e_B`.
//! The row `f = (λ + e_B, −c)` is a left eigenvector, `λ` the larger eigenvalue.
//!
//! *Infinitely many collisions*: where the eigenvalues are real and positive trace makes `λ > 0`, the cone
//! `s > 0, f·(s, w) > 0` is mapped into itself: `s` after `k` rounds is
//! `(λ^k·f − λ'^k·f')/(λ − λ')`, positive as `f > f'` for `s > 0`; for a double eigenvalue it is
//! `λ^k·s + k·λ^(k−1)·f`. The speed in between is `(s₊ + e_A·s)/c > 0`. Elsewhere the signs of these
//! expressions make it fail after finitely many.
//!
//! *In a finite time*: intercepts are multiplied by the same matrices as velocities (see [`super::exact`]), so
//! the time of round `k` is `−σ_k/s_k` with `σ_k` the same expression in the intercepts. It tends to
//! `T = −f·(σ, ω)/f·(s, w)`, geometrically for `λ' < λ`, like `1/k` for a double eigenvalue. `T` lies in the field
//! of `λ`, rational or quadratic.
//!
//! *What it ends in*: both eigenvalues lie in `[0, λ]` and `λ < 1`, so all powers of `P` tend to 0, those of a double
//! eigenvalue like `k·λ^k`: the speeds among the three tend to 0. Positions are continuous and each gap is 0 at times that
//! tend to `T`, so it is 0 at `T`. Hence the three are at one place with one velocity, at criticality as elsewhere: those
//! of their centre of mass, whose worldline no collision among them changes, or those of the wall. So the worldline from
//! `T` on is known exactly, even where `T` is irrational or only enclosed. The same is true of a pattern of more
//! points ([`super::pattern`]): closing speeds tend to 0 there, and so do the gaps `ω_pq/c_p`, since `Γ < γ²`.

use super::Value;
use super::bounds::Bounds;
use super::line::Line;
use super::near::Near;
use super::surd::{Surd, larger_root};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Sign;
use malachite::base::num::basic::traits::{One, Zero};
use std::cmp::Ordering;

/// A proved collapse.
#[derive(Clone, Debug)]
pub struct Collapse {
    /// The points that come together, first and last; 0 is the left wall, the one after the last body the right.
    pub bodies: (usize, usize),
    /// The pairs that collide in turn, for ever, each shown by its left point; the next first.
    pub pattern: Vec<usize>,
    /// The time of accumulation: in the field of the eigenvalue for three points, else enclosed.
    pub time: Value,
    /// The place, as position of the second of the points.
    pub position: Value,
    /// The velocity that all of them approach.
    pub velocity: Rational,
    /// The factor of all speeds over `rounds` rounds, in the limit: the largest eigenvalue.
    pub factor: Value,
    /// How many rounds of the pattern `factor` is for.
    pub rounds: u32,
    /// For three points, trace and determinant of the product of the transfer matrices over one round.
    pub trace: Option<(Rational, Rational)>,
    /// Whether the eigenvalue is double: then times converge like 1/k, not geometrically.
    pub critical: bool,
    /// The worldline of their centre of mass (or the wall) in the coordinates of points: intercept, velocity.
    pub(super) centre: (Rational, Rational),
}

impl Collapse {
    /// The point whose position `position` is.
    #[must_use]
    pub fn second(&self) -> usize {
        self.bodies.0 + 1
    }

    /// Whether a pair of the three has restitution 0: then they stick at the instant at which they touch.
    pub(super) fn sticks(&self) -> bool {
        self.trace.as_ref().is_some_and(|(_, determinant)| *determinant == Rational::ZERO)
    }

    /// On which side of the place of the collapse a worldline `b + v·t` is at that time, where it is certain.
    pub(super) fn reach(&self, b: &Rational, v: &Rational) -> Option<Ordering> {
        let (slope, ahead) = (v - &self.centre.1, b - &self.centre.0);
        match &self.time {
            Value::Exact(t) => Some((t * slope + ahead).sign()),
            Value::Surd(t) => Some(t.times(&slope).plus(&ahead).sign()),
            Value::Within(lo, hi) => {
                let (at, then) = ((lo * &slope + &ahead).sign(), (hi * slope + ahead).sign());
                (at == then).then_some(at)
            }
        }
    }
}

/// What two collisions do to the speeds of three points, where they can collide for ever in a finite time.
pub(super) struct Contraction {
    trace: Rational,
    determinant: Rational,
    eigenvalue: Surd,
}

/// The contraction of the three points around `middle`, whichever pair collides first; `None` where their eigenvalues are
/// not real, not positive, or not below 1.
pub(super) fn contraction(line: &Line, middle: usize) -> Option<Contraction> {
    let (left, right) = (&line.pairs[middle - 1], &line.pairs[middle]);
    let (a, c) = (&left.right, &right.left);
    // Most are told by doubles: the trace is negative, or the discriminant.
    let [e, f] = [left, right].map(|pair| Near::of(&pair.restitution).bounds());
    let trace = Near::of(a).bounds().times(Near::of(c).bounds()).minus(e.plus(f));
    let discriminant = trace.times(trace).minus(e.times(f).times(Bounds { lo: 4.0, hi: 4.0 }));
    if trace.hi < 0.0 || discriminant.hi < 0.0 {
        return None;
    }
    let trace = a * c - &left.restitution - &right.restitution;
    let determinant = &left.restitution * &right.restitution;
    if trace <= Rational::ZERO || *a <= Rational::ZERO || *c <= Rational::ZERO {
        return None;
    }
    let eigenvalue = larger_root(&trace, &determinant)?;
    (eigenvalue.compare(&Rational::ONE) == Ordering::Less).then_some(Contraction { trace, determinant, eigenvalue })
}

/// The collapse of the three points around `middle`, if they collide for ever as long as nothing else comes.
///
/// The answer is exact: `None` where the number of collisions of the three alone is finite, or where it is
/// infinite but takes for ever.
pub(super) fn of_three(line: &Line, b: &[Rational], v: &[Rational], middle: usize) -> Option<Collapse> {
    let (left, right) = (middle - 1, middle);
    let closing = |x: &[Rational], p: usize| &x[p] - &x[p + 1];
    let (next, other) = if closing(v, left) > Rational::ZERO { (left, right) } else { (right, left) };
    let (s, w) = (closing(v, next), -closing(v, other));
    if s <= Rational::ZERO || w < Rational::ZERO {
        return None;
    }
    let Contraction { trace, determinant, eigenvalue } = contraction(line, middle)?;
    let c = if other == left { &line.pairs[left].right } else { &line.pairs[right].left };
    let e_other = &line.pairs[other].restitution;
    let row = |x: &Rational, y: &Rational| eigenvalue.times(x).plus(&(e_other * x - c * y));
    let speeds = row(&s, &w);
    if speeds.sign() != Ordering::Greater {
        return None;
    }
    let intercepts = row(&closing(b, next), &-closing(b, other));
    let time = intercepts.times(&-Rational::ONE).over(&speeds)?;
    let centre = centre(line, b, v, left..=middle + 1);
    let position = time.times(&centre.1).plus(&(&centre.0 + &line.points[middle].offset));
    let critical = &trace * &trace == Rational::from(4) * &determinant;
    Some(Collapse {
        bodies: (left + line.first, middle + 1 + line.first),
        pattern: vec![next + line.first, other + line.first],
        time: Value::from(time),
        position: Value::from(position),
        velocity: centre.1.clone(),
        factor: Value::from(eigenvalue),
        rounds: 1,
        trace: Some((trace, determinant)),
        critical,
        centre,
    })
}

/// Intercept and velocity of the centre of mass of some points, or of the wall among them.
pub(super) fn centre(
    line: &Line,
    b: &[Rational],
    v: &[Rational],
    points: std::ops::RangeInclusive<usize>,
) -> (Rational, Rational) {
    let (mut mass, mut intercept, mut momentum) = (Rational::ZERO, Rational::ZERO, Rational::ZERO);
    for k in points {
        match &line.points[k].mass {
            None => return (b[k].clone(), v[k].clone()),
            Some(m) => {
                mass += m;
                intercept += m * &b[k];
                momentum += m * &v[k];
            }
        }
    }
    (intercept / &mass, momentum / mass)
}
