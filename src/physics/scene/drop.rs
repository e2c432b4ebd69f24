//! Balls that are dropped together, one above the other, on a floor.
//!
//! The lowest ball strikes the floor first and goes up with `e_f` times its speed. It strikes the second one, which still
//! falls, that one the third, and so on: one pass. Velocities are upwards, in units of the speed at the floor.
//!
//! **Law.** In the frame that falls with the upper balls these are at rest, and the lowest one comes at `1 + e_f`. With `w` for
//! the last ball's velocity in a chain whose first body moves with velocity 1, the last ball goes up with
//! `u = (1 + e_f)·w − 1`, and rises to `u²` times the height if `u >= 0`. No ratio need equal another.
//! [`crate::chain::uncertain::given`] has `w`.
//!
//! **What is left out.** The balls' sizes, the time between the collisions, and air: the height is that of the fall.
//!
//! **Contract.** Over a box of measured inputs both ends of `u` and of the rise are attained: `e_f` and the height enter
//! nowhere else.

use crate::chain::uncertain::given::Given;
use crate::chain::uncertain::{Coefficients, Range};
use crate::chain::{ChainError, Positive, Restitution, Restitutions};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

/// Bits of bounds where inputs are measured; far more than an uncertainty lets one print.
const BITS: u64 = 192;

/// The balls from the lowest to the highest, and the floor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drop {
    masses: Vec<Range<Positive>>,
    coefficients: Coefficients,
    floor: Range<Restitution>,
    height: Option<Range<Positive>>,
}

impl Drop {
    /// At least two balls, with a coefficient for each pair of neighbours or one for all.
    ///
    /// # Errors
    /// [`ChainError::Count`], or a limit on their number.
    pub fn new(
        masses: Vec<Range<Positive>>,
        coefficients: Coefficients,
        floor: Range<Restitution>,
        height: Option<Range<Positive>>,
    ) -> Result<Drop, ChainError> {
        Given::new(masses.clone(), coefficients.clone(), Rational::ONE, BITS)?;
        Ok(Drop { masses, coefficients, floor, height })
    }

    /// The masses, from the lowest ball to the highest.
    #[must_use]
    pub fn masses(&self) -> &[Range<Positive>] {
        &self.masses
    }

    /// The restitutions between neighbours.
    #[must_use]
    pub fn coefficients(&self) -> &Coefficients {
        &self.coefficients
    }

    /// The restitution with the floor.
    #[must_use]
    pub fn floor(&self) -> &Range<Restitution> {
        &self.floor
    }

    /// The height of the fall, where it is given.
    #[must_use]
    pub fn height(&self) -> Option<&Range<Positive>> {
        self.height.as_ref()
    }

    /// Masses, coefficients and floor where all are single numbers.
    #[must_use]
    pub fn exact(&self) -> Option<(Vec<Positive>, Restitutions, &Restitution)> {
        let masses = self.masses.iter().map(|m| m.single().cloned()).collect::<Option<Vec<_>>>()?;
        let coefficients = match &self.coefficients {
            Coefficients::Same(e) => Restitutions::Same(e.single()?.clone()),
            Coefficients::Each(list) => {
                Restitutions::Each(list.iter().map(|e| e.single().cloned()).collect::<Option<Vec<_>>>()?)
            }
        };
        Some((masses, coefficients, self.floor.single()?))
    }

    /// The speed with which the lowest ball comes towards the others: `1 + e_f`.
    #[must_use]
    pub fn approach(&self) -> Range<Rational> {
        let end = |e: &Restitution| e.plus_one();
        Range::new(end(self.floor.lo()), end(self.floor.hi())).unwrap_or_else(|_| Range::point(end(self.floor.lo())))
    }

    /// The velocity of the highest ball after the pass, upwards.
    ///
    /// # Errors
    /// A limit on measured masses.
    pub fn last_velocity(&self) -> Result<Range<Rational>, ChainError> {
        if let Some((masses, coefficients, floor)) = self.exact() {
            let pairs = masses.windows(2).enumerate();
            let share = |(i, pair): (usize, &[Positive])| {
                let e = coefficients.at(i as u64).map_or(Rational::ONE, Restitution::plus_one);
                e * pair[0].value() / (pair[0].value() + pair[1].value())
            };
            let arrival: Rational = pairs.map(share).product();
            return Ok(Range::point(arrival * floor.plus_one() - Rational::ONE));
        }
        let found = Given::new(self.masses.clone(), self.coefficients.clone(), Rational::ONE, BITS)?.last_velocity()?;
        let (Some(lo), Some(hi)) = (found.least.as_rational(), found.greatest.as_rational()) else {
            return Err(ChainError::NotAtRest);
        };
        let arrival = Range::new(lo.clone(), hi.clone()).map_err(|_| ChainError::NotAtRest)?;
        Ok(arrival.times(&self.approach()).plus(&Range::point(-Rational::ONE)))
    }

    /// To how many times the height the highest ball rises; 0 where it does not.
    ///
    /// # Errors
    /// As [`Drop::last_velocity`].
    pub fn rise(&self) -> Result<Range<Rational>, ChainError> {
        let u = self.last_velocity()?;
        let up = |u: &Rational| u.clone().max(Rational::ZERO);
        let up = Range::new(up(u.lo()), up(u.hi())).map_err(|_| ChainError::NotAtRest)?;
        Ok(up.square())
    }

    /// The height to which it rises, where that of the fall is given.
    ///
    /// # Errors
    /// As [`Drop::last_velocity`].
    pub fn rises_to(&self) -> Result<Option<Range<Rational>>, ChainError> {
        let Some(height) = &self.height else { return Ok(None) };
        let height = height.clone().map(|h| Ok::<_, ChainError>(h.value().clone()))?;
        Ok(Some(self.rise()?.times(&height)))
    }
}
