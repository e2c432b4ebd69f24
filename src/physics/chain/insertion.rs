//! One inserted body of given mass `μ` between neighbours `a` and `b`: does the chain transfer more with it than without it?
//!
//! **The answer.** For one coefficient of restitution `e`, the body helps iff `e >= τ`, `τ = (a·b + μ²)/(μ·(a + b))`, and it
//! changes nothing iff `e = τ`. *Proof.* All other collisions are the same with it and without it. Its two collisions
//! contribute `(1 + e)⁴·a·b·μ²/((a + μ)²·(μ + b)²)` to eta, the direct collision of `a` and `b` contributes
//! `(1 + e)²·a·b/(a + b)²`. The quotient of the two is the square of `(1 + e)/(1 + τ)`, since
//! `1 + τ = (a + μ)·(μ + b)/(μ·(a + b))`. ∎ The claim is `b-insert` of the catalogue. So `τ <= 1` iff `μ` lies between `a` and `b`:
//! no other mass ever helps. For `μ² = a·b`, `τ` is the `L_1` of (15).
//!
//! **Two coefficients.** Let `p` and `q` be those of the body's two collisions and `d` that of the direct one. The body helps iff
//! `(1 + p)·(1 + q)/(1 + d) >= 1 + τ`. A chain says nothing of `d`, because in it `a` and `b` never collide. So `d` is taken to be any
//! number between `p` and `q`. The left side then ranges from `1 + min(p, q)` to `1 + max(p, q)`: both coefficients are compared
//! with `τ`.
//!
//! **Measured inputs.** `1 + τ` is a Möbius function of `a` and of `b`, so it is monotone in each; it is convex in `μ`, with its
//! least value at `μ² = a·b`. Hence the greatest `τ` of a box lies at a vertex. The least lies at an end of `a` and of `b`, and there at an
//! end of `μ` or at `√(a·b)`. Both are attained.

use super::threshold::{Helps, threshold};
use super::uncertain::{Range, Reals};
use super::{Positive, Restitution};
use crate::number::NumberError;
use crate::number::real::Real;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Square;
use malachite::base::num::basic::traits::One;
use std::cmp::Ordering;

/// `τ` over all values of the three masses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bounds {
    least: Least,
    greatest: Rational,
}

/// The least `τ`.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Least {
    /// At a vertex.
    Vertex(Rational),
    /// `2·√r/(1 + r)`, at `μ² = a·b`, for this `r = a/b`.
    Inside(Positive),
}

impl Least {
    /// The order of `e >= 0` and the bound.
    fn compared_with(&self, e: &Rational) -> Ordering {
        match self {
            Self::Vertex(x) => e.cmp(x),
            Self::Inside(_) => e.square().cmp(&self.square()),
        }
    }

    /// The square, which is rational.
    fn square(&self) -> Rational {
        match self {
            Self::Vertex(x) => x.square(),
            Self::Inside(r) => {
                let r = r.value();
                (r << 2u32) / (r + Rational::ONE).square()
            }
        }
    }
}

/// `(a·b + μ²)/(μ·(a + b))`.
#[must_use]
pub fn exact(a: &Positive, mass: &Positive, b: &Positive) -> Rational {
    let (a, m, b) = (a.value(), mass.value(), b.value());
    (a * b + m.square()) / (m * (a + b))
}

impl Bounds {
    /// The bounds for a body `mass` between `a` and `b`.
    #[must_use]
    pub fn of(a: &Range<Positive>, mass: &Range<Positive>, b: &Range<Positive>) -> Bounds {
        if let (Some(a), Some(m), Some(b)) = (a.single(), mass.single(), b.single()) {
            let found = exact(a, m, b);
            return Bounds { least: Least::Vertex(found.clone()), greatest: found };
        }
        let corners = || [a.lo(), a.hi()].into_iter().flat_map(|a| [(a, b.lo()), (a, b.hi())]);
        let above = |m: &Positive| corners().map(|(a, b)| exact(a, m, b)).reduce(Rational::max);
        let least = |(a, b): (&Positive, &Positive)| {
            let best = a.value() * b.value();
            if best <= mass.lo().value().square() {
                Least::Vertex(exact(a, mass.lo(), b))
            } else if best >= mass.hi().value().square() {
                Least::Vertex(exact(a, mass.hi(), b))
            } else {
                Least::Inside(a.over(b))
            }
        };
        let smaller = |x: Least, y: Least| if y.square() < x.square() { y } else { x };
        let first = least((a.lo(), b.lo()));
        Bounds {
            least: corners().map(least).fold(first, smaller),
            greatest: above(mass.lo()).max(above(mass.hi())).unwrap_or(Rational::ONE),
        }
    }

    /// The one value, where the masses determine it.
    #[must_use]
    pub fn single(&self) -> Option<&Rational> {
        match &self.least {
            Least::Vertex(least) if *least == self.greatest => Some(least),
            _ => None,
        }
    }

    /// Both bounds as real numbers.
    ///
    /// # Errors
    /// As [`threshold`].
    pub fn reals(&self) -> Result<Reals, NumberError> {
        let least = match &self.least {
            Least::Vertex(x) => Real::rational(x.clone()),
            Least::Inside(r) => threshold(r, 1)?,
        };
        Ok(Reals { least, greatest: Real::rational(self.greatest.clone()) })
    }

    /// Whether the body helps, for coefficients of its two collisions that lie in this range; `None` where that depends.
    #[must_use]
    pub fn help(&self, e: &Range<Restitution>) -> Option<Helps> {
        let least = e.lo().value().cmp(&self.greatest);
        let greatest = self.least.compared_with(e.hi().value());
        (least == greatest).then_some(match least {
            Ordering::Greater => Helps::Yes,
            Ordering::Less => Helps::No,
            Ordering::Equal => Helps::OnTheThreshold,
        })
    }
}
