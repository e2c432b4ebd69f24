//! Work that cells share: eta is a factor of `e` times a factor of the ratio, for each `n`.
//!
//! **Why.** With `N = n + 1` and `t = r^(1/N)`, (25) is `((1+e)²)^N · (t/(1+t)²)^N`. A table of `|r|·|e|·|n|` cells
//! needs `|e|·|n| + |r|·|n|` powers and one certified product a cell. Both factors are double-doubles with
//! rigorous bounds; where their product does not settle the digits asked for, and where the value is rational,
//! the cell is computed by itself.
//!
//! **Memory.** Factors of `e` are kept for the whole table and those of one ratio until the next, [`KEPT`] of
//! each at most; what does not fit is computed again.

use super::{Found, Place, Plan, Printing, Quantity, TableError};
use crate::number::decimal::{Decimal, Digits};
use crate::number::double::Double;
use crate::number::interval::Interval;
use crate::number::rational::exact_root;

/// The most factors that are kept of each kind.
pub const KEPT: u64 = 1 << 18;

/// More digits than this are beyond double-doubles.
const DIGITS: u64 = 27;

/// The factors found so far for one table.
pub struct Factors<'a> {
    plan: &'a Plan,
    of_e: Vec<Option<Double>>,
    /// The ratio's place, and for each `n` its factor, or that the value is rational.
    of_ratio: (u64, Vec<Option<Option<Double>>>),
    shares: bool,
}

impl<'a> Factors<'a> {
    /// No factors yet.
    #[must_use]
    pub fn new(plan: &'a Plan) -> Factors<'a> {
        let (Digits::Significant(digits) | Digits::Places(digits)) = plan.printing.digits;
        let shares = plan.quantity == Quantity::Eta && digits <= DIGITS && plan.printing.extra == 0;
        Factors { plan, of_e: Vec::new(), of_ratio: (u64::MAX, Vec::new()), shares }
    }

    /// The value of a row; the same as [`Plan::value`], found with less work.
    ///
    /// # Errors
    /// As [`Plan::value`].
    pub fn value(&mut self, row: u64) -> Result<Found, TableError> {
        if !self.shares {
            return self.plan.value(row).map(Found::Open);
        }
        let place = self.plan.place(row).ok_or(TableError::TooManyRows)?;
        Ok(match self.settled(row, &place) {
            Some((decimal, enclosure)) => Found::Settled(decimal, enclosure),
            None => Found::Open(self.plan.value(row)?),
        })
    }

    fn settled(&mut self, row: u64, place: &Place) -> Option<(Decimal, Interval)> {
        let product = self.enclosure(row, place)?.to_interval()?;
        let Printing { digits, rounding, .. } = self.plan.printing;
        Some((Decimal::of_interval(&product, digits, rounding)?, product))
    }

    /// An enclosure of a row's value in double-double; `None` where it is rational or out of range.
    pub fn enclosure(&mut self, row: u64, place: &Place) -> Option<Double> {
        let [i, j, k] = self.plan.places(row);
        let (e, count) = (place.e.as_ref()?, place.n?.checked_add(1)?);
        let ns = self.plan.n.as_ref()?.len();
        let es = self.plan.e.as_ref()?.len();
        if self.of_ratio.0 != i {
            let kept = if ns <= KEPT { usize::try_from(ns).ok()? } else { 0 };
            self.of_ratio = (i, vec![None; kept]);
        }
        let of_ratio = kept(&mut self.of_ratio.1, k, || {
            let r = place.ratio.value();
            if exact_root(r, count).is_some() {
                return None;
            }
            let t = Double::from_rational(r).root(count);
            let sum = t.plus(Double::exact(1.0));
            Some(t.divide(sum.multiply(sum)).power(count))
        })?;
        if self.of_e.is_empty() && es.saturating_mul(ns) <= KEPT {
            self.of_e = vec![None; usize::try_from(es * ns).ok()?];
        }
        let of_e = kept(&mut self.of_e, j * ns + k, || {
            let gain = Double::from_rational(&e.plus_one());
            gain.multiply(gain).power(count)
        });
        Some(of_e.multiply(of_ratio))
    }
}

/// What is kept at a place, found the first time.
fn kept<T: Copy>(list: &mut [Option<T>], place: u64, find: impl FnOnce() -> T) -> T {
    match usize::try_from(place).ok().and_then(|p| list.get_mut(p)) {
        Some(slot) => *slot.get_or_insert_with(find),
        None => find(),
    }
}
