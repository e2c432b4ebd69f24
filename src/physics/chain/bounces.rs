//! The coefficient of restitution from a class's measurements: heights of a ball that bounces, or times between bounces.
//!
//! **Model.** A ball that falls from the height `h` bounces to `e²·h`; each flight between two bounces takes `e` times as long as
//! the one before. Air and the ball's size are left out. A run is a list of such readings of one ball, one bounce
//! after the other; each reading is known to lie in a range.
//!
//! **Contract.** [`restitution`] answers with the set of all `e` from 0 to 1 with which there are exact values in all ranges
//! that obey the model: nothing outside of it is possible, and everything in it is. Where the set is empty, two comparisons
//! of readings are named that exclude each other, or one that gives `e > 1`.
//!
//! **Why pairs suffice.** With `g` for `e` (times) or `e²` (heights), a run obeys the model iff some `c > 0` has
//! `lo_k <= c·g^k <= hi_k` for all `k`. For a fixed `g > 0` these are intervals of `c`, and intervals have a common point iff each
//! two of them have: iff `lo_j <= hi_i·g^(j−i)` and `lo_i·g^(j−i) <= hi_j` for all `i < j`. So the possible `g` are those
//! from the greatest `(lo_j/hi_i)^(1/(j−i))` to the least `(hi_j/lo_i)^(1/(j−i))`.
//!
//! **Cost.** Roots are compared by powers of rationals, exactly: about `n²` comparisons for `n` readings of a run.

use super::uncertain::Range;
use super::{ChainError, Positive, limit_inserted};
use crate::number::decimal::{Decimal, Digits, Rounding};
use crate::number::rational::exact_root;
use crate::number::real::Real;
use crate::number::{NumberError, root};
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::One;
use malachite::{Natural, Rational};
use std::cmp::Ordering;

/// The most readings of a run.
pub(crate) const MAX_READINGS: u64 = 100;
/// The most runs.
pub(crate) const MAX_RUNS: u64 = 100_000;

/// What was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Heights: that of the fall and of the bounces after it.
    Heights,
    /// Times of the flights between bounces.
    Times,
}

impl Kind {
    /// The power of `e` by which a reading is smaller than the one before.
    fn power(self) -> u64 {
        match self {
            Self::Heights => 2,
            Self::Times => 1,
        }
    }
}

/// Two readings of a run, the earlier one first, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pair {
    /// The run.
    pub run: usize,
    /// The earlier reading.
    pub earlier: usize,
    /// The later one.
    pub later: usize,
}

/// A bound of `e`: the root of a quotient of readings, and the two that it comes from; `None` for `e <= 1` itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bound {
    /// The quotient.
    pub quotient: Rational,
    /// Which root of it.
    pub index: u64,
    /// The readings.
    pub from: Option<Pair>,
}

impl Bound {
    /// Which of two bounds is greater, exactly.
    #[must_use]
    pub fn compared(&self, other: &Bound) -> Ordering {
        if self.index == other.index {
            return self.quotient.cmp(&other.quotient);
        }
        (&self.quotient).pow(other.index).cmp(&(&other.quotient).pow(self.index))
    }

    /// The bound as a number.
    #[must_use]
    pub fn value(&self) -> Real {
        if let Some(exact) = exact_root(&self.quotient, self.index) {
            return Real::rational(exact);
        }
        let (quotient, index) = (self.quotient.clone(), Natural::from(self.index));
        Real::enclosed(move |bits| root::root(&quotient, &index, bits))
    }

    /// The bound as a decimal.
    ///
    /// # Errors
    /// A limit on digits.
    pub fn decimal(&self, digits: u64, rounding: Rounding) -> Result<Decimal, NumberError> {
        Ok(Decimal::of_real(&self.value(), Digits::Significant(digits), rounding)?.0)
    }
}

/// What measurements say about `e`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Estimate {
    /// All `e` from the first to the second bound are possible, and no other.
    Consistent(Bound, Bound),
    /// No `e` is: it would be at least the first bound and at most the second, which is smaller.
    Contradiction(Bound, Bound),
}

/// All `e` with which readings obey the model.
///
/// ```
/// use carom_physics::chain::bounces::{Estimate, Kind, restitution};
/// use carom_physics::chain::{Positive, uncertain::Range};
/// let read = |text| Range::read(text).unwrap().map(Positive::new).unwrap();
/// let run = vec![read("1.00"), read("0.64 ± 0.15")];
/// let Estimate::Consistent(lo, hi) = restitution(&[run], Kind::Heights).unwrap() else { panic!() };
/// assert_eq!((lo.value().as_rational(), hi.value().as_rational()), (Some(&carom_exact::number::rational::parse("0.7").unwrap()), None));
/// ```
///
/// # Errors
/// [`ChainError::Count`] where no run has two readings; a limit.
pub fn restitution(runs: &[Vec<Range<Positive>>], kind: Kind) -> Result<Estimate, ChainError> {
    limit_inserted(runs.len() as u64, "runs of measurements", MAX_RUNS)?;
    let one = Bound { quotient: Rational::ONE, index: 1, from: None };
    let (mut lower, mut upper) = (None::<Bound>, one);
    for (run, readings) in runs.iter().enumerate() {
        limit_inserted(readings.len() as u64, "readings of a run", MAX_READINGS)?;
        for (earlier, first) in readings.iter().enumerate() {
            for (later, second) in readings.iter().enumerate().skip(earlier + 1) {
                let index = (later - earlier) as u64 * kind.power();
                let from = Some(Pair { run, earlier, later });
                let least = Bound { quotient: second.lo().value() / first.hi().value(), index, from };
                let most = Bound { quotient: second.hi().value() / first.lo().value(), index, from };
                if lower.as_ref().is_none_or(|lower| least.compared(lower).is_gt()) {
                    lower = Some(least);
                }
                if most.compared(&upper).is_lt() {
                    upper = most;
                }
            }
        }
    }
    let given = runs.iter().map(Vec::len).max().unwrap_or(0) as u64;
    let lower = lower.ok_or(ChainError::Count { of: "readings of a run", given, needed: 2 })?;
    Ok(match lower.compared(&upper) {
        Ordering::Greater => Estimate::Contradiction(lower, upper),
        _ => Estimate::Consistent(lower, upper),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Random numbers, the same on every machine.
    struct Dice(u64);

    impl Dice {
        fn upto(&mut self, most: u64) -> Rational {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            Rational::from_unsigneds((self.0 >> 33) % (most + 1), most)
        }
    }

    /// Readings of a ball with this `e`, each wrong by at most the reach.
    fn simulated(dice: &mut Dice, e: &Rational, kind: Kind, count: usize) -> Vec<Range<Positive>> {
        let reach = dice.upto(50) / Rational::from(200) + Rational::from_unsigneds(1u32, 1000u32);
        let mut exact = Rational::from(1) + dice.upto(1000);
        let mut out = Vec::new();
        for _ in 0..count {
            let wrong = (dice.upto(1000) * Rational::from(2) - Rational::ONE) * &exact * &reach;
            let (read, reach) = (&exact + wrong, &exact * &reach);
            let ends = (&read - &reach, read + reach);
            out.push(Range::new(ends.0, ends.1).expect("in order").map(Positive::new).expect("above 0"));
            exact *= e.clone().pow(kind.power());
        }
        out
    }

    #[test]
    fn the_true_coefficient_is_never_outside_in_ten_thousand_experiments() {
        let mut dice = Dice(2026);
        for experiment in 0..10_000u32 {
            let e = (dice.upto(999) * Rational::from(999) + Rational::ONE) / Rational::from(1000);
            let kind = if experiment % 2 == 0 { Kind::Heights } else { Kind::Times };
            let runs: Vec<_> = (0..1 + experiment % 3)
                .map(|_| simulated(&mut dice, &e, kind, 2 + (experiment % 4) as usize))
                .collect();
            let truth = Bound { quotient: e.clone(), index: 1, from: None };
            match restitution(&runs, kind).expect("an answer") {
                Estimate::Consistent(lower, upper) => {
                    assert!(lower.compared(&truth).is_le() && upper.compared(&truth).is_ge(), "{experiment}: {e}");
                    let shown = [(&lower, Rounding::Down), (&upper, Rounding::Up)]
                        .map(|(bound, way)| bound.decimal(4, way).expect("digits").value());
                    assert!(shown[0] <= e && e <= shown[1], "{experiment}: {e} is outside of {shown:?}");
                }
                Estimate::Contradiction(..) => panic!("{experiment}: the readings come from e = {e}"),
            }
        }
    }

    #[test]
    fn the_ends_are_attained_and_nothing_beyond_them_is_possible() {
        // Whether some c has lo_k <= c·g^k <= hi_k for all k, tried directly.
        let possible = |run: &[Range<Positive>], g: &Rational| {
            let ends = |f: fn(&Range<Positive>) -> &Positive| {
                run.iter().enumerate().map(|(k, r)| f(r).value() / g.pow(k as u64)).collect::<Vec<_>>()
            };
            ends(Range::lo).into_iter().max() <= ends(Range::hi).into_iter().min()
        };
        let mut dice = Dice(7);
        for _ in 0..500 {
            let e = (dice.upto(80) * Rational::from(80) + Rational::from(10)) / Rational::from(100);
            let run = simulated(&mut dice, &e, Kind::Times, 4);
            let found = restitution(std::slice::from_ref(&run), Kind::Times).expect("an answer");
            let Estimate::Consistent(lower, upper) = found else { panic!("it is") };
            for (bound, ways) in [(lower, [Rounding::Up, Rounding::Down]), (upper, [Rounding::Down, Rounding::Up])] {
                let [inside, outside] = ways.map(|way| bound.decimal(30, way).expect("digits").value());
                if bound.from.is_some() && inside != outside {
                    assert!(possible(&run, &inside) && !possible(&run, &outside), "{run:?}");
                }
            }
        }
    }

    #[test]
    fn a_contradiction_names_the_readings_that_exclude_each_other() {
        let read = |text: &str| Range::read(text).expect("a range").map(Positive::new).expect("above 0");
        let runs = vec![
            vec![read("1.00 ± 0.01"), read("0.64 ± 0.01")],
            vec![read("1.00 ± 0.01"), read("0.60 ± 0.02")],
            vec![read("1.00 ± 0.01"), read("0.49 ± 0.01")],
        ];
        let Ok(Estimate::Contradiction(lower, upper)) = restitution(&runs, Kind::Heights) else { panic!("it is one") };
        assert_eq!((lower.from.map(|p| p.run), upper.from.map(|p| p.run)), (Some(0), Some(2)));
        let higher = vec![vec![read("1.00 ± 0.01"), read("1.03 ± 0.01")]];
        let Ok(Estimate::Contradiction(lower, upper)) = restitution(&higher, Kind::Heights) else {
            panic!("it is one")
        };
        assert!(lower.from.is_some() && upper.from.is_none(), "a ball does not bounce higher than it fell");
        assert!(restitution(&[vec![read("1")]], Kind::Times).is_err(), "one reading says nothing");
        // A single run of which no pair of neighbours is impossible by itself.
        let run = vec![read("1.00 ± 0.01"), read("0.80 ± 0.01"), read("0.50 ± 0.01")];
        assert!(matches!(restitution(&[run], Kind::Heights), Ok(Estimate::Contradiction(..))));
    }
}
