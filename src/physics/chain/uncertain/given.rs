//! Given masses, some of them measured, with the first body moving and the others at rest.
//!
//! With `P_k = ∏_(j<k) m_j/(m_j + m_(j+1))` and `G_k = ∏_(j<k) (1 + e_j)` (`e_j` at the collision of bodies `j` and `j + 1`):
//! - body `k` arrives at its collision with `w_k = G_k·P_k·v`, the last body leaves with it;
//! - body `k` leaves with `u_k = w_k·g`, `g = (m_k − e_k·m_(k+1))/(m_k + m_(k+1))`;
//! - the collision of bodies `k` and `k + 1` loses `w_k²·(1 − e_k²)/2 · m_k·m_(k+1)/(m_k + m_(k+1))`.
//!
//! **Ends.** `g` rises with `m_k` and falls with `m_(k+1)` and `e_k`; `w_k` falls with `m_k` and rises with each `e_j`, `j < k`.
//! - *Least, of what is nowhere negative.* Each of these is a concave function of the logarithms of the masses, so its
//!   least value lies at a vertex; `P_(k+1)` depends on the masses before `m_k` through `P_k` alone, so the vertices are
//!   searched body by body.
//! - *Greatest, of what is positive somewhere*: `super::peak`.
//! - *Where `u_k` is negative* its size is a product of two factors that both fall with `m_k`: `m_k` stands at an end.
//!   Greatest size: lower end, with the greatest `P_k` for it; least size: upper end.
//! - *Independent coefficients* enter in factors of their own, each monotone. *One coefficient for all*, measured:
//!   `w_k` and the size of a negative `u_k` rise with it; the losses have the factor `(1 − e)(1 + e)^(2k+1)`, which rises
//!   up to `e = k/(k+1)` and falls from there; `(1 + e)^k·(m_k − e·m_(k+1))` is log-concave in `e`, so its least value is
//!   at an end. Its greatest is where `k·(m_k − e·m_(k+1)) = (1 + e)·m_(k+1)`: for each mass elsewhere. Where that lies inside of
//!   the box, the range of `e` is cut into [`PIECES`], and each is bounded with its upper end in `G_k` and its lower
//!   one in `g`: this is the one end that may not be attained.
//!
//! **Cost.** `O(n²)` operations on short numbers for all velocities, and as much for all losses.

use super::bound::{Side, limit_spread, product, shortened};
use super::peak::{Last, greatest};
use super::{Coefficients, MAX_MEASURED, Positive, Range, Reals};
use crate::chain::{ChainError, collision, limit_inserted};
use crate::number::real::Real;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Pow, Square};
use malachite::base::num::basic::traits::{One, Two, Zero};

/// Into so many pieces the range of a common coefficient is cut at most.
pub const PIECES: usize = 64;

/// A chain of given masses whose first body moves.
#[derive(Clone, Debug)]
pub struct Given {
    masses: Vec<Range<Positive>>,
    coefficients: Coefficients,
    speed: Rational,
    bits: u64,
    /// For each body the least `P` with its mass at the lower and at the upper end.
    least: Vec<[Rational; 2]>,
}

/// A bound on both sides, exact rationals.
fn reals(least: Rational, greatest: Rational) -> Reals {
    Reals { least: Real::rational(least), greatest: Real::rational(greatest) }
}

/// Refuses too many bodies, and masses of too different sizes.
pub(super) fn limit(masses: &[Range<Positive>]) -> Result<(), ChainError> {
    limit_inserted(masses.len() as u64, "bodies of measured mass", MAX_MEASURED)?;
    limit_spread(masses)
}

impl Given {
    /// A chain of at least two bodies; results are bounds of about `bits` bits.
    ///
    /// # Errors
    /// [`ChainError::Count`] for too few masses or coefficients; [`ChainError::NoCollision`] for a first body that does
    /// not move forward; a limit above [`MAX_MEASURED`].
    pub fn new(
        masses: Vec<Range<Positive>>,
        coefficients: Coefficients,
        speed: Rational,
        bits: u64,
    ) -> Result<Given, ChainError> {
        limit(&masses)?;
        check(&masses, &coefficients)?;
        if speed <= Rational::ZERO {
            return Err(ChainError::NoCollision { collision: 1, velocities: Box::new((speed, Rational::ZERO)) });
        }
        let bits = bits + 64;
        let mut least = vec![[Rational::ONE, Rational::ONE]];
        for pair in masses.windows(2) {
            let ([behind, front], Some(before)) = (pair, least.last()) else { continue };
            let arrive = |mass: &Positive| {
                let from = |p: &Rational, m: &Positive| p * m.value() / (m.value() + mass.value());
                let [low, high] = before;
                shortened(from(low, behind.lo()).min(from(high, behind.hi())), Side::Below, bits)
            };
            let next = [arrive(front.lo()), arrive(front.hi())];
            least.push(next);
        }
        Ok(Given { masses, coefficients, speed, bits, least })
    }

    /// `G_k` with all coefficients at one end, on one side.
    fn gain(&self, k: usize, side: Side) -> Rational {
        let ends = (0..k).filter_map(|j| self.coefficients.at(j)).map(|e| match side {
            Side::Below => e.lo().plus_one(),
            Side::Above => e.hi().plus_one(),
        });
        product(ends, side, self.bits)
    }

    /// Bounds of the velocity of each body after the pass.
    ///
    /// # Errors
    /// A limit of `super::peak`.
    pub fn velocities(&self) -> Result<Vec<Reals>, ChainError> {
        let mut list = Vec::with_capacity(self.masses.len());
        for (k, pair) in self.masses.windows(2).enumerate() {
            let ([mass, front], Some(e)) = (pair, self.coefficients.at(k)) else { continue };
            let least = self.least_kept(k, mass, front, (e.lo().value(), e.hi().value()))?;
            let greatest = self.greatest_kept(k, mass, front, (e.lo().value(), e.hi().value()))?;
            list.push(reals(least * &self.speed, greatest * &self.speed));
        }
        list.push(self.last_velocity()?);
        Ok(list)
    }

    /// Bounds of the velocity of the last body after the pass.
    ///
    /// # Errors
    /// A limit of `super::peak`.
    pub fn last_velocity(&self) -> Result<Reals, ChainError> {
        let last = self.masses.len().saturating_sub(1);
        let least = self.least.last().map_or(Rational::ZERO, |[low, high]| low.min(high).clone());
        let least = least * self.gain(last, Side::Below) * &self.speed;
        let greatest = self.arrival(last)? * self.gain(last, Side::Above) * &self.speed;
        Ok(reals(least, greatest))
    }

    /// The greatest `P_k`.
    fn arrival(&self, k: usize) -> Result<Rational, ChainError> {
        if k == 0 {
            return Ok(Rational::ONE);
        }
        Ok(greatest(&self.masses[..=k], &Last::Arrival, self.bits)?)
    }

    /// At most `G_k·P_k·g`.
    fn least_kept(
        &self,
        k: usize,
        mass: &Range<Positive>,
        front: &Range<Positive>,
        (low, high): (&Rational, &Rational),
    ) -> Result<Rational, ChainError> {
        let b = front.hi().value();
        let worst = kept(mass.lo().value(), b, high);
        if worst < Rational::ZERO {
            return Ok(worst * self.arrival(k)? * self.gain(k, Side::Above));
        }
        let Some(least) = self.least.get(k) else { return Ok(worst) };
        let ends = least.iter().zip([mass.lo(), mass.hi()]);
        let value = |e: &Rational| ends.clone().map(|(p, m)| p * kept(m.value(), b, e)).min().unwrap_or(Rational::ZERO);
        let at_high = value(high) * self.gain(k, Side::Below);
        Ok(match self.coefficients.shared() {
            None => at_high,
            Some(_) => {
                let high_gain = shortened((high + Rational::ONE).pow(k as u64), Side::Below, self.bits);
                (value(high) * high_gain).min(value(low) * self.gain(k, Side::Below))
            }
        })
    }

    /// At least `G_k·P_k·g`.
    fn greatest_kept(
        &self,
        k: usize,
        mass: &Range<Positive>,
        front: &Range<Positive>,
        (low, high): (&Rational, &Rational),
    ) -> Result<Rational, ChainError> {
        let b = front.lo().value();
        let best = kept(mass.hi().value(), b, low);
        if k == 0 {
            return Ok(best);
        }
        if best <= Rational::ZERO {
            let least = self.least.get(k).map_or(Rational::ZERO, |[_, high]| high.clone());
            return Ok(best * least * self.gain(k, Side::Below));
        }
        let peak = |e: &Rational| -> Result<Rational, ChainError> {
            Ok(greatest(&self.masses[..=k], &Last::Kept { e, front: b }, self.bits)?)
        };
        if self.coefficients.shared().is_none() {
            return Ok(peak(low)? * self.gain(k, Side::Above));
        }
        let count = Rational::from(k);
        let gain = |e: &Rational| shortened((e + Rational::ONE).pow(k as u64), Side::Above, self.bits);
        // The sign of the derivative by e, at one mass.
        let rises = |m: &Rational, e: &Rational| &count * (m - e * b) >= (e + Rational::ONE) * b;
        let bound = |from: &Rational, to: &Rational| -> Result<Rational, ChainError> {
            if rises(mass.lo().value(), to) {
                Ok(peak(to)? * gain(to))
            } else if !rises(mass.hi().value(), from) {
                Ok(peak(from)? * gain(from))
            } else {
                Ok(peak(from)? * gain(to))
            }
        };
        let mut pieces = vec![(bound(low, high)?, low.clone(), high.clone())];
        for _ in 1..PIECES {
            let Some(top) = (0..pieces.len()).max_by(|i, j| pieces[*i].0.cmp(&pieces[*j].0)) else { break };
            let (value, from, to) = pieces[top].clone();
            if rises(mass.lo().value(), &to) || !rises(mass.hi().value(), &from) {
                // Attained: nothing is gained by cutting it.
                return Ok(value);
            }
            let middle = (&from + &to) / Rational::TWO;
            // A part where nothing is kept does not matter.
            let positive = |e: &Rational| kept(mass.hi().value(), b, e) > Rational::ZERO;
            pieces[top] = (bound(&from, &middle)?, from, middle.clone());
            if positive(&middle) {
                pieces.push((bound(&middle, &to)?, middle, to));
            }
        }
        Ok(pieces.into_iter().map(|piece| piece.0).max().unwrap_or(best))
    }

    /// Bounds of the energy lost in each collision.
    ///
    /// # Errors
    /// A limit of `super::peak`.
    pub fn losses(&self) -> Result<Vec<Reals>, ChainError> {
        let scale = (&self.speed).square() / Rational::TWO;
        let mut list = Vec::with_capacity(self.masses.len());
        for (k, pair) in self.masses.windows(2).enumerate() {
            let ([mass, front], Some(e)) = (pair, self.coefficients.at(k)) else { continue };
            let reduced = |m: &Rational, b: &Rational| m * b / (m + b);
            let b = front.lo().value();
            let ends = self.least.get(k).into_iter().flatten().zip([mass.lo(), mass.hi()]);
            let least = ends.map(|(p, m)| p.square() * reduced(m.value(), b)).min().unwrap_or(Rational::ZERO);
            let b = front.hi().value();
            let most = if k == 0 {
                reduced(mass.hi().value(), b)
            } else {
                greatest(&self.masses[..=k], &Last::Lost { front: b }, self.bits)?
            };
            let (low, high) = self.plasticity(k, e.lo().value(), e.hi().value());
            list.push(reals(least * low * &scale, most * high * &scale));
        }
        Ok(list)
    }

    /// Bounds of `(1 − e_k²)·G_k²`.
    fn plasticity(&self, k: usize, low: &Rational, high: &Rational) -> (Rational, Rational) {
        let lost = |e: &Rational| Rational::ONE - e.square();
        if self.coefficients.shared().is_none() {
            let (least, most) = (self.gain(k, Side::Below).square(), self.gain(k, Side::Above).square());
            return (lost(high) * least, lost(low) * most);
        }
        let at = |e: &Rational, side| lost(e) * shortened((e + Rational::ONE).pow(2 * k as u64), side, self.bits);
        let top = Rational::from_unsigneds(k as u64, k as u64 + 1);
        (at(low, Side::Below).min(at(high, Side::Below)), at(&top.clamp(low.clone(), high.clone()), Side::Above))
    }

    /// Bounds of the energy transfer.
    ///
    /// # Errors
    /// A limit of `super::peak`.
    pub fn transfer(&self) -> Result<Reals, ChainError> {
        let last = self.masses.len().saturating_sub(1);
        // Here the first mass enters twice: its two ends are tried like all others.
        let mut products = [Rational::ONE, Rational::ONE];
        for pair in self.masses.windows(2) {
            let [behind, front] = pair else { continue };
            let arrive = |mass: &Positive| {
                let from = |p: &Rational, m: &Positive| p * collision_share(m.value(), mass.value());
                shortened(from(&products[0], behind.lo()).min(from(&products[1], behind.hi())), Side::Below, self.bits)
            };
            products = [arrive(front.lo()), arrive(front.hi())];
        }
        let [a, b] = products;
        let least = a.min(b) * self.gain(last, Side::Below).square();
        let most = greatest(&self.masses, &Last::Transfer, self.bits)? * self.gain(last, Side::Above).square();
        Ok(reals(least, most))
    }
}

/// Checks that there are two bodies, and a coefficient for each collision.
pub(super) fn check(masses: &[Range<Positive>], coefficients: &Coefficients) -> Result<(), ChainError> {
    let bodies = masses.len() as u64;
    if bodies < 2 {
        return Err(ChainError::Count { of: "masses", given: bodies, needed: 2 });
    }
    if let Coefficients::Each(list) = coefficients
        && list.len() as u64 + 1 != bodies
    {
        let given = list.len() as u64;
        return Err(ChainError::Count { of: "coefficients of restitution", given, needed: bodies - 1 });
    }
    Ok(())
}

/// `(m − e·b)/(m + b)`.
fn kept(m: &Rational, b: &Rational, e: &Rational) -> Rational {
    (m - e * b) / (m + b)
}

/// `a·b/(a + b)²`: the share of the energy that a pair of masses hands on, for `e = 0`.
fn collision_share(a: &Rational, b: &Rational) -> Rational {
    a * b / (a + b).square()
}

/// Bounds of the transfer matrix of each collision: each entry is monotone in both masses and in `e`,
/// `[[↑↓↓, ↓↑↑], [↑↓↑, ↓↑↓]]` in `m1`, `m2` and `e`.
///
/// # Errors
/// [`ChainError::Count`] for too few masses or coefficients.
pub fn matrices(masses: &[Range<Positive>], coefficients: &Coefficients) -> Result<Vec<[[Reals; 2]; 2]>, ChainError> {
    check(masses, coefficients)?;
    let mut list = Vec::with_capacity(masses.len());
    for (k, pair) in masses.windows(2).enumerate() {
        let ([m1, m2], Some(e)) = (pair, coefficients.at(k)) else { continue };
        // The heavier the body behind, and the lighter the one in front.
        let forward = |e| collision::matrix(m1.hi(), m2.lo(), e);
        let backward = |e| collision::matrix(m1.lo(), m2.hi(), e);
        let [[a_most, b_least], _] = forward(e.lo());
        let [_, [c_most, d_least]] = forward(e.hi());
        let [_, [c_least, d_most]] = backward(e.lo());
        let [[a_least, b_most], _] = backward(e.hi());
        list.push([[reals(a_least, a_most), reals(b_least, b_most)], [reals(c_least, c_most), reals(d_least, d_most)]]);
    }
    Ok(list)
}
