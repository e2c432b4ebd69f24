//! States of a check to go back to: an attempt that fails is undone without a copy of the checker.

use super::fraction::Work;
use super::{Checker, Label};
use std::collections::BTreeSet;

/// A state of a check, to go back to ([`Checker::back_to`]).
#[derive(Clone, Debug)]
pub struct Mark {
    facts: usize,
    blocks: usize,
    steps: usize,
    rests_on: BTreeSet<String>,
    assumed: BTreeSet<Label>,
    work: Work,
}

impl Checker {
    /// The state now.
    pub fn mark(&self) -> Mark {
        Mark {
            facts: self.facts.len(),
            blocks: self.blocks.len(),
            steps: self.steps,
            rests_on: self.rests_on.clone(),
            assumed: self.assumed.clone(),
            work: self.work.clone(),
        }
    }

    /// Leaves the blocks that were opened since this mark, and forgets the facts that were shown since.
    ///
    /// Sound: fewer facts are known afterwards, each of them shown in the blocks that are still open. A block is left together with
    /// all its facts, also where the mark is older than a block that was closed in between.
    pub fn back_to(&mut self, mark: &Mark) {
        while self.blocks.len() > mark.blocks
            && let Some(block) = self.blocks.pop()
        {
            self.forget(block.facts, block.scope);
        }
        // Between steps the names in scope are those of the open blocks.
        self.forget(mark.facts.min(self.facts.len()), self.scope.len());
        self.steps = mark.steps;
        self.rests_on.clone_from(&mark.rests_on);
        self.assumed.clone_from(&mark.assumed);
        self.work = mark.work.clone();
    }
}
