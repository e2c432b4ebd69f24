//! One pass along a chain of given masses, in exact arithmetic: velocities, losses, energy transfer.
//!
//! Collision `i` (from 1) is that of body `i − 1` with body `i`; each body strikes the next one once. These are
//! the velocities *after the pass*: neighbours that still approach each other will meet again
//! ([`super::recollision`]), and then they are not final.
//!
//! **Cost.** All velocities: a few operations for each body on numbers that grow with the body's place. The
//! last body's velocity alone, from rest: a product tree with one reduction at the end, `O(M(b) log n)` for
//! `b` bits of input, where folding would be quadratic.

use super::recollision::of_velocities;
use super::uncertain::meeting::meet;
use super::{ChainError, Positive, Restitution, Restitutions, collision};
use crate::number::NumberError;
use crate::number::fraction::Fraction;
use crate::number::product::quotient;
use crate::number::running::{Step, quotients};
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};

/// The most bits of all exact velocities together: they grow with the square of the number of bodies.
pub const MAX_PASS_BITS: u64 = 1 << 31;

/// A chain with exact masses, coefficients of restitution and velocities before the pass.
#[derive(Clone, Debug)]
pub struct Pass {
    masses: Vec<Positive>,
    restitutions: Restitutions,
    velocities: Vec<Rational>,
}

/// What one collision does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Collision {
    /// The velocities of the two bodies before it.
    pub before: (Rational, Rational),
    /// The velocities after it.
    pub after: (Rational, Rational),
    /// The kinetic energy lost.
    pub loss: Rational,
}

/// A collision as it is followed.
struct Struck<'a> {
    masses: (&'a Positive, &'a Positive),
    e: &'a Restitution,
    before: (&'a Rational, &'a Rational),
    after: &'a (Rational, Rational),
}

impl Struck<'_> {
    fn loss(&self) -> Rational {
        collision::loss(self.masses.0, self.masses.1, self.e, self.before.0, self.before.1)
    }
}

impl Pass {
    /// A chain of at least two bodies, with a velocity for each one before the pass.
    ///
    /// # Errors
    /// [`ChainError::Count`] where the numbers of masses, coefficients and velocities do not fit.
    pub fn new(
        masses: Vec<Positive>,
        restitutions: Restitutions,
        velocities: Vec<Rational>,
    ) -> Result<Pass, ChainError> {
        let bodies = masses.len() as u64;
        let Some(inserted) = bodies.checked_sub(2) else {
            return Err(ChainError::Count { of: "masses", given: bodies, needed: 2 });
        };
        let restitutions = restitutions.for_inserted(inserted)?;
        if velocities.len() != masses.len() {
            return Err(ChainError::Count { of: "velocities", given: velocities.len() as u64, needed: bodies });
        }
        Ok(Pass { masses, restitutions, velocities })
    }

    /// A chain whose first body moves with `speed` and whose others are at rest.
    ///
    /// # Errors
    /// As [`Pass::new`].
    pub fn from_rest(masses: Vec<Positive>, restitutions: Restitutions, speed: Rational) -> Result<Pass, ChainError> {
        let mut velocities = vec![Rational::ZERO; masses.len()];
        if let Some(first) = velocities.first_mut() {
            *first = speed;
        }
        Pass::new(masses, restitutions, velocities)
    }

    /// The masses.
    #[must_use]
    pub fn masses(&self) -> &[Positive] {
        &self.masses
    }

    /// The velocities before the pass.
    #[must_use]
    pub fn velocities_before(&self) -> &[Rational] {
        &self.velocities
    }

    /// The pairs of neighbours with their coefficients of restitution, in order.
    fn pairs(&self) -> impl Iterator<Item = (&Positive, &Positive, &Restitution)> {
        self.masses.windows(2).enumerate().filter_map(|(i, pair)| match pair {
            [m1, m2] => Some((m1, m2, self.restitutions.at(i as u64)?)),
            _ => None,
        })
    }

    /// About the bits of all exact velocities together.
    fn size(&self) -> u64 {
        let bits = |x: &Rational| x.numerator_ref().significant_bits() + x.denominator_ref().significant_bits();
        let (mut each, mut all) = (0_u64, 0_u64);
        for ((m1, m2, e), v) in self.pairs().zip(&self.velocities) {
            each = each.saturating_add(2 * (bits(m1.value()) + bits(m2.value())) + bits(e.value()) + bits(v));
            all = all.saturating_add(each);
        }
        all
    }

    /// Refuses to write down more than [`MAX_PASS_BITS`].
    fn limit_size(&self) -> Result<(), ChainError> {
        let size = self.size();
        if size > MAX_PASS_BITS {
            let limit = "bits of all exact velocities";
            return Err(NumberError::LimitReached { limit, allowed: MAX_PASS_BITS, needed: size.to_string() }.into());
        }
        Ok(())
    }

    /// Follows the pass; each collision is shown with the velocities of its bodies before and after it.
    fn follow(&self, mut each: impl FnMut(&Struck<'_>)) -> Result<(), ChainError> {
        self.limit_size()?;
        let mut rest = self.velocities.iter();
        let mut arriving = rest.next().cloned().unwrap_or(Rational::ZERO);
        for (i, ((m1, m2, e), front)) in self.pairs().zip(rest).enumerate() {
            if arriving <= *front {
                let velocities = Box::new((arriving, front.clone()));
                return Err(ChainError::NoCollision { collision: i + 1, velocities });
            }
            let after = collision::velocities_after(m1, m2, e, &arriving, front);
            each(&Struck { masses: (m1, m2), e, before: (&arriving, front), after: &after });
            arriving = after.1;
        }
        Ok(())
    }

    /// Every collision, in order.
    ///
    /// # Errors
    /// [`ChainError::NoCollision`] where a body does not catch up with the next; a limit above [`MAX_PASS_BITS`].
    pub fn collisions(&self) -> Result<Vec<Collision>, ChainError> {
        let mut list = Vec::with_capacity(self.masses.len());
        self.follow(|struck| {
            let before = (struck.before.0.clone(), struck.before.1.clone());
            list.push(Collision { before, after: struck.after.clone(), loss: struck.loss() });
        })?;
        Ok(list)
    }

    /// The velocity of each body after the pass; (22)–(24) for optimal masses.
    ///
    /// # Errors
    /// As [`Pass::collisions`].
    pub fn velocities_after(&self) -> Result<Vec<Rational>, ChainError> {
        let mut list = Vec::with_capacity(self.masses.len());
        let mut last = None;
        self.follow(|struck| {
            list.push(struck.after.0.clone());
            last = Some(struck.after.1.clone());
        })?;
        list.extend(last);
        Ok(list)
    }

    /// The velocity of each body after the pass, with the others at rest before, as fractions in lowest terms: that of
    /// body `i` is `(m_i − e·m_(i+1))/(m_i + m_(i+1))` times its velocity on arrival, a running product
    /// (`crate::number::running`). Quicker than [`Pass::velocities_after`] for many bodies.
    ///
    /// # Errors
    /// [`ChainError::NotAtRest`]; a limit above [`MAX_PASS_BITS`].
    pub fn velocities_from_rest(&self) -> Result<Vec<Fraction>, ChainError> {
        let speed = match self.velocities.first() {
            Some(speed) if self.starts_from_rest() => speed,
            _ => return Err(ChainError::NotAtRest),
        };
        self.limit_size()?;
        let (steps, backwards): (Vec<Step>, Vec<bool>) = self.pairs().map(|(m1, m2, e)| step(m1, m2, e)).unzip();
        let found = quotients(speed.numerator_ref().clone(), speed.denominator_ref().clone(), &steps);
        Ok(found.into_iter().zip(backwards.into_iter().chain([false])).map(|(v, back)| v.signed(back)).collect())
    }

    /// The kinetic energy lost in each collision.
    ///
    /// # Errors
    /// As [`Pass::collisions`].
    pub fn losses(&self) -> Result<Vec<Rational>, ChainError> {
        let mut list = Vec::with_capacity(self.masses.len());
        self.follow(|struck| list.push(struck.loss()))?;
        Ok(list)
    }

    /// Whether all bodies but the first are at rest and the first one moves towards them.
    fn starts_from_rest(&self) -> bool {
        match self.velocities.split_first() {
            Some((first, rest)) => *first > Rational::ZERO && rest.iter().all(|v| *v == Rational::ZERO),
            None => false,
        }
    }

    /// The last body's velocity after the pass, with the others at rest before: `∏ m_i(1+e_i)/(m_i+m_(i+1))·v1`.
    ///
    /// # Errors
    /// [`ChainError::NotAtRest`].
    pub fn last_velocity(&self) -> Result<Fraction, ChainError> {
        match self.velocities.first() {
            Some(speed) if self.starts_from_rest() => Ok(self.gain().times(speed)),
            _ => Err(ChainError::NotAtRest),
        }
    }

    /// Whether bodies meet again after the pass. From rest each pair is told by its masses alone, without velocities
    /// ([`super::uncertain::meeting`]).
    ///
    /// # Errors
    /// As [`Pass::collisions`].
    pub fn recollides(&self) -> Result<bool, ChainError> {
        if !self.starts_from_rest() {
            return Ok(of_velocities(&self.velocities_after()?));
        }
        let values = |k: usize| Some((self.masses.get(k)?.value(), self.restitutions.at(k as u64)));
        Ok((1..self.masses.len().saturating_sub(1)).any(|k| match (values(k - 1), values(k), values(k + 1)) {
            (Some((a, Some(e))), Some((m, Some(f))), Some((b, _))) => meet(a, m, b, e.value(), f.value()),
            _ => false,
        }))
    }

    /// The last body's velocity over the first one's, from rest: with `m1 = a/b`, `m2 = c/d`, `e = p/q` a factor
    /// `m1(1 + e)/(m1 + m2)` is `a·d·(p + q)/((a·d + c·b)·q)`, multiplied out and reduced for all of them at once.
    fn gain(&self) -> Fraction {
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for (m1, m2, e) in self.pairs() {
            let ((a, b), (c, d)) = (parts(m1.value()), parts(m2.value()));
            let (p, q) = parts(e.value());
            below.extend([a * d + c * b, q.clone()]);
            above.extend([a.clone(), d.clone(), p + q]);
        }
        quotient(above, below)
    }

    /// The energy transfer: the last body's kinetic energy over the first one's before, (13) and (16).
    ///
    /// # Errors
    /// [`ChainError::NotAtRest`].
    pub fn transfer(&self) -> Result<Fraction, ChainError> {
        match (self.masses.first(), self.masses.last()) {
            (Some(first), Some(last)) if self.starts_from_rest() => {
                Ok(self.gain().square().times(last.over(first).value()))
            }
            _ => Err(ChainError::NotAtRest),
        }
    }
}

/// One collision with a body at rest as a step of a running product, and whether the first body bounces back: with
/// `m1 = a/b`, `m2 = c/d`, `e = p/q` the velocity on arrival times `(a·d·q − b·c·p)/((a·d + b·c)·q)` is kept, and times
/// `a·d·(p + q)/((a·d + b·c)·q)` given on.
fn step(m1: &Positive, m2: &Positive, e: &Restitution) -> (Step, bool) {
    let ((a, b), (c, d), (p, q)) = (parts(m1.value()), parts(m2.value()), parts(e.value()));
    let (first, second) = (a * d, b * c);
    let (ahead, back) = (&first * q, &second * p);
    let backwards = back > ahead;
    let kept = if backwards { back - ahead } else { ahead - back };
    (Step { below: vec![first + second, q.clone()], kept, given: vec![a.clone(), d.clone(), p + q] }, backwards)
}

/// Numerator and denominator of a mass or a coefficient, which are not negative.
fn parts(x: &Rational) -> (&Natural, &Natural) {
    (x.numerator_ref(), x.denominator_ref())
}
