//! Dimensions with unknowns, and the equations between them.
//!
//! Contract: [`Unknowns::equate`] accepts an equation exactly if those accepted before have a common solution with it. Method:
//! elimination over the rational numbers; an unknown that is solved for is replaced wherever it occurs.

use carom_unit::{Dimension, Exponent};
use std::collections::BTreeMap;

/// A dimension times powers of unknown ones.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Size {
    pub known: Dimension,
    /// The power of each unknown.
    pub open: BTreeMap<usize, Exponent>,
}

impl Size {
    /// That of a number.
    pub(super) fn number() -> Size {
        Size::of(Dimension::NUMBER)
    }

    pub(super) fn of(known: Dimension) -> Size {
        Size { known, open: BTreeMap::new() }
    }

    /// `self * other^exponent`
    pub(super) fn times(&self, other: &Size, exponent: Exponent) -> Option<Size> {
        let mut out = Size { known: self.known.times(&other.known, exponent)?, open: self.open.clone() };
        for (unknown, power) in &other.open {
            let own = out.open.entry(*unknown).or_insert(Exponent::ZERO);
            *own = own.plus(power.times(exponent)?)?;
        }
        out.open.retain(|_, power| !power.is_zero());
        Some(out)
    }

    pub(super) fn to(&self, exponent: Exponent) -> Option<Size> {
        Size::number().times(self, exponent)
    }

    /// Whether it is known to be a number.
    pub(super) fn is_number(&self) -> bool {
        self.open.is_empty() && self.known.is_number()
    }
}

/// The unknown dimensions of a claim.
#[derive(Default)]
pub(super) struct Unknowns {
    /// Each one's name, if it belongs to one, and its value where an equation gives it.
    list: Vec<(Option<String>, Option<Size>)>,
}

/// What became of an equation.
pub(super) enum Equated {
    Holds,
    Fails,
    /// An exponent left 64 bits.
    TooLong,
}

impl Unknowns {
    pub(super) fn fresh(&mut self, name: Option<&str>) -> Size {
        self.list.push((name.map(str::to_string), None));
        Size { known: Dimension::NUMBER, open: BTreeMap::from([(self.list.len() - 1, Exponent::ONE)]) }
    }

    /// With the values that are known so far.
    pub(super) fn resolved(&self, size: &Size) -> Option<Size> {
        let mut out = size.clone();
        while let Some((unknown, power)) = out
            .open
            .iter()
            .map(|(unknown, power)| (*unknown, *power))
            .find(|(unknown, _)| self.list[*unknown].1.is_some())
        {
            out.open.remove(&unknown);
            if let Some(value) = &self.list[unknown].1 {
                out = out.times(value, power)?;
            }
        }
        Some(out)
    }

    /// Adds the equation `left = right`.
    pub(super) fn equate(&mut self, left: &Size, right: &Size) -> Equated {
        let difference = left.times(right, Exponent::whole(-1)).and_then(|size| self.resolved(&size));
        let Some(mut rest) = difference else { return Equated::TooLong };
        // The youngest unknown is replaced: names are older than what their expressions bring in.
        let Some((unknown, power)) = rest.open.pop_last() else {
            return if rest.known.is_number() { Equated::Holds } else { Equated::Fails };
        };
        let value = Exponent::ONE.over(power).and_then(Exponent::negated).and_then(|power| rest.to(power));
        match value {
            Some(value) => {
                self.list[unknown].1 = Some(value);
                Equated::Holds
            }
            None => Equated::TooLong,
        }
    }

    /// A size in print; an unknown is its name in brackets.
    pub(super) fn printed(&self, size: &Size) -> String {
        let size = self.resolved(size).unwrap_or_else(|| size.clone());
        let mut parts: Vec<String> = Vec::new();
        if !size.known.is_number() || size.open.is_empty() {
            parts.push(size.known.to_string());
        }
        for (unknown, power) in &size.open {
            let name = self.list[*unknown].0.as_deref().unwrap_or("?");
            parts.push(if *power == Exponent::ONE { format!("[{name}]") } else { format!("[{name}]^({power})") });
        }
        parts.join("·")
    }
}
