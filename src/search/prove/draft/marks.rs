//! Marks: where each consulted fact comes from. With them one walk backwards finds all that a proof needs.
//!
//! Nothing is accepted because of a mark. If a mark is missing, a needed step is dropped and the kernel rejects the
//! certificate. A superfluous mark keeps an unneeded step, or reports an unneeded hypothesis as used.

use std::collections::BTreeSet;

/// The source of a fact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Source {
    /// A domain or hypothesis of the claim: the fact `h1` is 0, `h2` is 1, …
    Hypothesis(usize),
    /// The kind of the names in the claim's binding at this place: that they are natural, or the domain of a family's
    /// members.
    Binding(usize),
    /// A step of the certificate, by its place among those that were taken.
    Step(usize),
}

/// Some sources, in order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Sources(Vec<Source>);

impl Sources {
    /// One source.
    pub(crate) fn one(source: Source) -> Sources {
        Sources(vec![source])
    }

    /// Adds one.
    pub(crate) fn add(&mut self, source: Source) {
        if let Err(place) = self.0.binary_search(&source) {
            self.0.insert(place, source);
        }
    }

    /// Adds others.
    pub(crate) fn extend(&mut self, others: &Sources) {
        others.0.iter().for_each(|source| self.add(*source));
    }

    /// The sources in order.
    pub(crate) fn iter(&self) -> impl Iterator<Item = Source> {
        self.0.iter().copied()
    }
}

/// All sources that the goal needs, directly or indirectly; `trail` holds what each step used, in order.
///
/// A step uses only earlier facts, so one walk from the last step to the first finds them all.
pub(crate) fn needed(trail: &[Sources], goal: Source) -> BTreeSet<Source> {
    let mut needed = BTreeSet::from([goal]);
    for (place, used) in trail.iter().enumerate().rev() {
        if needed.contains(&Source::Step(place)) {
            needed.extend(used.iter());
        }
    }
    needed
}
