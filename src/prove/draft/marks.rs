//! Marks: from where each thing that a step consults is known, so that what a proof needs is one walk backwards.
//!
//! Nothing is accepted because of a mark. A mark too few shows where the certificate without a step that seems not
//! needed is rejected; a mark too many leaves in a step, or calls a hypothesis used, that could be spared.

use std::collections::BTreeSet;

/// From where something is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Source {
    /// A domain or hypothesis of the claim: the fact `h1` is 0, `h2` is 1, …
    Hypothesis(usize),
    /// What a binding of the claim, by its place, says of the kind of its names: that they are natural, or the domain
    /// of a family's members.
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

/// All that is needed for what the goal comes from: `trail` holds what each step used, in order.
///
/// A step uses only what is known before it, so that one walk from the last step to the first finds all.
pub(crate) fn needed(trail: &[Sources], goal: Source) -> BTreeSet<Source> {
    let mut needed = BTreeSet::from([goal]);
    for (place, used) in trail.iter().enumerate().rev() {
        if needed.contains(&Source::Step(place)) {
            needed.extend(used.iter());
        }
    }
    needed
}
