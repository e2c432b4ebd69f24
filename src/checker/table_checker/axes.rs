//! The axes of a table: their values, and the row that stands at the present place.

use super::failure::{Failure, declined, rejected};
use super::text::{Head, Quantity, Row, Values};
use super::value;
use super::work::Work;
use num_bigint::BigUint;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::BTreeSet;

/// The most bits of a value of an axis.
const AXIS_BITS: u64 = 1 << 18;
/// Values of a list that the statement shows.
const SHOWN: usize = 12;

/// An axis with its present value.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    pub(super) name: String,
    values: Values,
    place: u64,
    value: BigRational,
    pub(super) text: String,
}

impl Axis {
    /// Its values differ: a cell that is given twice could hide that another one is missing.
    fn new(name: String, values: Values) -> Result<Axis, Failure> {
        let differ = match &values {
            Values::List(list) => list.iter().collect::<BTreeSet<_>>().len() == list.len(),
            Values::Steps(_, step, _) => !step.is_zero(),
            Values::Factors(start, factor, _) => !start.is_zero() && factor.is_positive() && !factor.is_one(),
        };
        if !differ {
            return rejected(&format!("the axis {name} has a value twice"));
        }
        let first = match &values {
            Values::List(list) => list.first().cloned(),
            Values::Steps(start, _, count) | Values::Factors(start, _, count) => (*count > 0).then(|| start.clone()),
        };
        let Some(value) = first else { return rejected(&format!("the axis {name} has no values")) };
        let text = value.to_string();
        Ok(Axis { name, values, place: 0, value, text })
    }

    fn count(&self) -> u64 {
        match &self.values {
            Values::List(list) => u64::try_from(list.len()).unwrap_or(u64::MAX),
            Values::Steps(.., count) | Values::Factors(.., count) => *count,
        }
    }

    /// Goes on to the next value, or back to the first: then the answer is true.
    fn advance(&mut self, work: &Work) -> Result<bool, Failure> {
        self.place += 1;
        let wraps = self.place >= self.count();
        if wraps {
            self.place = 0;
        }
        if let Values::Steps(_, by, _) | Values::Factors(_, by, _) = &self.values
            && !wraps
        {
            // The sum or product in lowest terms, and its digits.
            let size = |x: &BigRational| x.numer().bits().max(x.denom().bits());
            work.reduction(size(&self.value) + size(by))?;
        }
        let next = match &self.values {
            Values::List(list) => usize::try_from(self.place).ok().and_then(|place| list.get(place)).cloned(),
            Values::Steps(start, ..) | Values::Factors(start, ..) if wraps => Some(start.clone()),
            Values::Steps(_, step, _) => Some(&self.value + step),
            Values::Factors(_, factor, _) => Some(&self.value * factor),
        };
        let Some(next) = next else { return rejected("the row's value is not on the axis") };
        if next.numer().bits() + next.denom().bits() > AXIS_BITS {
            return declined("bits of a value of an axis");
        }
        if next != self.value {
            self.text = next.to_string();
            self.value = next;
        }
        Ok(wraps)
    }

    pub(super) fn described(&self) -> String {
        let values = match &self.values {
            Values::List(list) => {
                let shown: Vec<String> = list.iter().take(SHOWN).map(BigRational::to_string).collect();
                let rest = list.len().saturating_sub(SHOWN);
                shown.join(", ") + &if rest > 0 { format!(" and {rest} more") } else { String::new() }
            }
            Values::Steps(start, step, count) => format!("{count} from {start} by steps of {step}"),
            Values::Factors(start, factor, count) => format!("{count} from {start} by factors of {factor}"),
        };
        format!("{} = {values}\n", self.name)
    }
}

/// The axes of a table at the present row.
#[derive(Clone, Debug)]
pub(super) struct Axes(pub(super) Vec<Axis>);

impl Axes {
    fn named(&self, name: &str) -> Option<&Axis> {
        self.0.iter().find(|axis| axis.name == name)
    }

    /// The axes that the quantity depends on, in this order; their lengths' product is the number of rows.
    pub(super) fn of(head: &Head) -> Result<Axes, Failure> {
        let names: &[&str] = match head.quantity {
            Quantity::Eta => &["ratio", "e", "n"],
            Quantity::Threshold => &["ratio", "n"],
            Quantity::BestN => &["ratio", "e"],
        };
        if !head.axes.iter().map(|(name, _)| name.as_str()).eq(names.iter().copied()) {
            return rejected(&format!("the axes of this quantity are {}", names.join(", ")));
        }
        let axes: Result<Vec<Axis>, Failure> =
            head.axes.iter().map(|(name, values)| Axis::new(name.clone(), values.clone())).collect();
        let axes = axes?;
        match axes.iter().try_fold(1u64, |rows, axis| rows.checked_mul(axis.count())) {
            Some(rows) if rows == head.rows => Ok(Axes(axes)),
            Some(rows) => rejected(&format!("the axes make {rows} rows, not {}", head.rows)),
            None => declined("rows of a table"),
        }
    }

    /// The row stands at the present place: its numbers are those of the axes there, in the same lowest terms, and it
    /// has no others.
    pub(super) fn matches(&self, row: &Row<'_>) -> Result<(), Failure> {
        for (name, given) in [("ratio", Some(row.ratio)), ("e", row.e), ("n", row.n)] {
            let wanted = self.named(name).map(|axis| axis.text.as_str());
            if given != wanted {
                let (given, wanted) = (given.unwrap_or("nothing"), wanted.unwrap_or("nothing"));
                return rejected(&format!("{name} is {wanted} in this row, not {given}"));
            }
        }
        Ok(())
    }

    /// The mass ratio, above 0.
    pub(super) fn ratio(&self) -> Result<BigRational, Failure> {
        match self.named("ratio") {
            Some(axis) if axis.value.is_positive() => Ok(axis.value.clone()),
            _ => rejected("a ratio of masses is above 0"),
        }
    }

    /// The restitution, from 0 to 1.
    pub(super) fn restitution(&self) -> Result<BigRational, Failure> {
        match self.named("e") {
            Some(axis) if !axis.value.is_negative() && axis.value <= BigRational::one() => Ok(axis.value.clone()),
            _ => rejected("a restitution lies from 0 to 1"),
        }
    }

    /// The number of inserted bodies, at least so many.
    pub(super) fn inserted(&self, least: u32) -> Result<BigUint, Failure> {
        let n = self.named("n").filter(|axis| axis.value.is_integer()).and_then(|axis| axis.value.numer().to_biguint());
        match n {
            Some(n) if n.bits() > value::COUNT_BITS => declined("bits of a number of bodies"),
            Some(n) if n >= BigUint::from(least) => Ok(n),
            _ => rejected(&format!("n is an integer from {least} on")),
        }
    }

    /// Goes on to the next row: the last axis runs fastest.
    pub(super) fn advance(&mut self, work: &Work) -> Result<(), Failure> {
        for axis in self.0.iter_mut().rev() {
            if !axis.advance(work)? {
                break;
            }
        }
        Ok(())
    }
}
