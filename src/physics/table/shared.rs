//! Work that cells share: eta is a factor of `e` times a factor of the ratio, for each `n`; and the texts of the axes.
//!
//! **Why.** With `N = n + 1` and `t = r^(1/N)`, (25) is `((1+e)²/4)^N · (4t/(1+t)²)^N`. A table of `|r|·|e|·|n|` cells
//! needs `|e|·|n| + |r|·|n|` powers and one certified product a cell. Both factors are double-doubles with rigorous bounds
//! from 0 to 1. A cell first takes the product of their ends as doubles ([`fast::times`]) and its decimal in machine
//! words ([`Decimal::of_doubles`]); where that does not settle the digits asked for, the product in double-double; where
//! that does not, and where the value is rational, the cell is computed by itself.
//!
//! **Memory.** Factors and texts of `e` are kept for the whole table and those of one ratio until the next, [`KEPT`] of
//! each at most; what does not fit is computed again.

use super::grid::Grid;
use super::{Found, Plan, Printing, Quantity, TableError, Value};
use crate::chain::best::Best;
use crate::chain::fast;
use crate::number::decimal::{Decimal, Digits};
use crate::number::double::Double;
use crate::number::interval::Interval;
use crate::number::rational::exact_root;
use crate::number::real::Real;
use malachite::Rational;
use malachite::base::num::basic::traits::One;

/// The most factors that are kept of each kind.
pub const KEPT: u64 = 1 << 18;

/// More digits than this are beyond double-doubles.
const DIGITS: u64 = 27;

/// More digits than this are beyond doubles.
const DIGITS_OF_DOUBLES: u64 = 14;

/// The factors found so far for one table.
pub struct Factors<'a> {
    plan: &'a Plan,
    of_e: Vec<Option<Double>>,
    /// The ratio's place, and for each `n` its factor, and whether the value is rational.
    of_ratio: (u64, Vec<Option<(Double, bool)>>),
    shares: bool,
    doubles: bool,
    /// The texts of restitutions and of numbers, and the present ratio's with its place.
    texts: [Vec<Option<String>>; 2],
    text: (u64, String),
}

impl<'a> Factors<'a> {
    /// No factors yet.
    #[must_use]
    pub fn new(plan: &'a Plan) -> Factors<'a> {
        let (Digits::Significant(digits) | Digits::Places(digits)) = plan.printing.digits;
        let shares = plan.quantity == Quantity::Eta && digits <= DIGITS && plan.printing.extra == 0;
        let texts = [&plan.e, &plan.n].map(|grid| {
            let places = grid.as_ref().map(Grid::len).filter(|count| *count <= KEPT);
            vec![None; places.and_then(|count| usize::try_from(count).ok()).unwrap_or(0)]
        });
        let (of_e, of_ratio, text) = (Vec::new(), (u64::MAX, Vec::new()), (u64::MAX, String::new()));
        Factors { plan, of_e, of_ratio, shares, doubles: digits <= DIGITS_OF_DOUBLES, texts, text }
    }

    /// The texts of the axes at a row; the same as [`Plan::labels`].
    pub fn labels(&mut self, row: u64) -> Vec<String> {
        let plan = self.plan;
        let [i, j, k] = plan.places(row);
        if self.text.0 != i {
            self.text = (i, plan.ratio.label(i).unwrap_or_default());
        }
        let mut labels = Vec::with_capacity(3);
        labels.push(self.text.1.clone());
        for ((grid, place), texts) in [(&plan.e, j), (&plan.n, k)].into_iter().zip(&mut self.texts) {
            let Some(grid) = grid else { continue };
            let find = || grid.label(place).unwrap_or_default();
            labels.push(match usize::try_from(place).ok().and_then(|p| texts.get_mut(p)) {
                Some(slot) => slot.get_or_insert_with(find).clone(),
                None => find(),
            });
        }
        labels
    }

    /// The value of a row; the same as [`Plan::value`], found with less work.
    ///
    /// # Errors
    /// As [`Plan::value`].
    pub fn value(&mut self, row: u64) -> Result<Found, TableError> {
        let settled = if self.shares { self.settled(row) } else { None };
        settled.map_or_else(|| self.plan.value(row).map(Found::Open), Ok)
    }

    /// The greatest double not above a row's value and the least one not below it, found with the same shared work: an
    /// enclosure as narrow as doubles allow, the same double twice where the value is one.
    ///
    /// A best number of bodies beyond all bounds is infinite; where every number is as good as any other, it lies
    /// between 0 and infinity.
    ///
    /// # Errors
    /// As [`Plan::value`].
    pub fn neighbours(&mut self, row: u64) -> Result<(f64, f64), TableError> {
        let plan = self.plan;
        if plan.quantity == Quantity::Eta
            // A rational value that is a double is between no two others: it is left to exact arithmetic.
            && let Some((of_e, (of_ratio, _))) = self.factors(row)
            && let Some(found) = of_e.multiply(of_ratio).neighbours()
        {
            return Ok(found);
        }
        let real = match plan.value(row)? {
            Value::Real(real) => real,
            Value::Count(Best::Finite { count, .. }) => Real::rational(Rational::from(count)),
            Value::Count(Best::Infinite) => return Ok((f64::INFINITY, f64::INFINITY)),
            Value::Count(Best::Any) => return Ok((0.0, f64::INFINITY)),
        };
        real.neighbours().map_err(|error| TableError::Row { row: plan.in_words(row), error: Box::new(error.into()) })
    }

    fn settled(&mut self, row: u64) -> Option<Found> {
        let (of_e, (of_ratio, rational)) = self.factors(row)?;
        if rational {
            return None;
        }
        let Printing { digits, rounding, .. } = self.plan.printing;
        if self.doubles {
            let product = fast::times(of_e.ends()?, of_ratio.ends()?);
            if let Some(decimal) = Decimal::of_doubles(product.0, product.1, digits, rounding) {
                return Some(Found::Quick(decimal, product));
            }
        }
        let product: Interval = of_e.multiply(of_ratio).to_interval()?;
        Some(Found::Settled(Decimal::of_interval(&product, digits, rounding)?, product))
    }

    /// The factors of a row's value, that of the ratio with whether the value is rational.
    fn factors(&mut self, row: u64) -> Option<(Double, (Double, bool))> {
        let plan = self.plan;
        let [i, j, k] = plan.places(row);
        let (e_grid, n_grid) = (plan.e.as_ref()?, plan.n.as_ref()?);
        let (es, ns) = (e_grid.len(), n_grid.len());
        let count = || u64::try_from(&n_grid.value(k)?).ok()?.checked_add(1);
        if self.of_ratio.0 != i {
            let kept = if ns <= KEPT { usize::try_from(ns).ok()? } else { 0 };
            self.of_ratio.0 = i;
            self.of_ratio.1.clear();
            self.of_ratio.1.resize(kept, None);
        }
        let of_ratio = kept(&mut self.of_ratio.1, k, || {
            let (Some(r), Some(count)) = (plan.ratio.value(i), count()) else { return (Double::exact(f64::NAN), true) };
            let t = Double::from_rational(&r).root(count);
            let sum = t.plus(Double::exact(1.0));
            let factor = t.multiply(Double::exact(4.0)).divide(sum.multiply(sum)).power(count);
            (factor, exact_root(&r, count).is_some())
        });
        if self.of_e.is_empty() && es.saturating_mul(ns) <= KEPT {
            self.of_e = vec![None; usize::try_from(es * ns).ok()?];
        }
        let of_e = kept(&mut self.of_e, j * ns + k, || {
            let (Some(e), Some(count)) = (e_grid.value(j), count()) else { return Double::exact(f64::NAN) };
            let gain = Double::from_rational(&((e + Rational::ONE) / Rational::from(2)));
            gain.multiply(gain).power(count)
        });
        Some((of_e, of_ratio))
    }
}

/// What is kept at a place, found the first time.
fn kept<T: Copy>(list: &mut [Option<T>], place: u64, find: impl FnOnce() -> T) -> T {
    match usize::try_from(place).ok().and_then(|p| list.get_mut(p)) {
        Some(slot) => *slot.get_or_insert_with(find),
        None => find(),
    }
}
