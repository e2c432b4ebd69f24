//! An audit as text, JSON, Markdown and JUnit, one claim's argument, the answers to a scene, and a replay in words
//! and pictures.

pub mod answers;
pub mod argument;
pub mod json;
pub mod junit;
pub mod markdown;
pub mod replay;
pub mod text;

use crate::claim::print::{self, Style};
use crate::claim::syntax::{Claim, Reading};
use crate::prove::outcome::{Outcome, Verdict};

/// A claim and what the audit says of it.
pub struct Entry {
    /// The claim.
    pub claim: Claim,
    /// The outcome.
    pub outcome: Outcome,
}

impl Entry {
    /// Whether the verdict is the one that the file expects.
    pub fn as_expected(&self) -> bool {
        self.outcome.verdict.is_expected(self.claim.expect)
    }

    /// The goal on one line.
    pub fn goal(&self, style: Style) -> String {
        style.prop(&self.claim.goal).split_whitespace().collect::<Vec<_>>().join(" ")
    }
}

/// The counts of an audit.
#[derive(Default, Clone, Copy)]
pub struct Summary {
    /// Claims proved.
    pub proved: usize,
    /// Claims refuted.
    pub refuted: usize,
    /// Claims undecided.
    pub undecided: usize,
    /// Claims whose verdict is not the expected one.
    pub unexpected: usize,
}

/// Counts the verdicts.
pub fn summary(entries: &[Entry]) -> Summary {
    let mut out = Summary::default();
    for entry in entries {
        match entry.outcome.verdict {
            Verdict::Proved => out.proved += 1,
            Verdict::Refuted => out.refuted += 1,
            Verdict::Undecided => out.undecided += 1,
        }
        out.unexpected += usize::from(!entry.as_expected());
    }
    out
}

/// `restored`, `extracted` or `beyond`.
pub fn reading(claim: &Claim) -> &'static str {
    match claim.reading {
        Reading::Restored => "restored",
        Reading::Extracted => "extracted",
        Reading::Beyond => "beyond",
    }
}

/// Hypotheses and goal, one a line.
pub fn statement(claim: &Claim, style: Style) -> Vec<String> {
    print::statement(claim, style)
}
