//! What became of a paper's formulas.

use carom_checker::claim::syntax::Claim;
use carom_diagnostic::{Diagnostic, Source, Span};
use std::collections::BTreeMap;

/// What became of a displayed formula.
#[derive(Debug)]
pub enum Outcome {
    /// A claim.
    Read(Box<Claim>),
    /// A hypothesis or a definition of the equations that follow.
    Used(&'static str),
    /// The author passes it over, for this reason.
    Skipped(String),
    /// It was not read.
    NotRead(Vec<Diagnostic>),
    /// A declaration at this place was not read, and it would be judged without what that says.
    Waits(Span),
}

/// A displayed formula.
#[derive(Debug)]
pub struct Equation {
    /// The claim's name.
    pub name: String,
    /// Its number in print.
    pub number: Option<String>,
    /// Its place in the text.
    pub span: Span,
    /// What became of it.
    pub outcome: Outcome,
}

impl Equation {
    /// Why it was not read, in one line, if it was not.
    #[must_use]
    pub fn unread(&self, source: &Source) -> Option<String> {
        match &self.outcome {
            Outcome::NotRead(faults) => Some(faults.first().map(Diagnostic::message).unwrap_or_default()),
            Outcome::Waits(declaration) => Some(format!("waits for {}, which is not read", source.line(*declaration))),
            Outcome::Read(_) | Outcome::Used(_) | Outcome::Skipped(_) => None,
        }
    }
}

/// What a name may be that nothing declares.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Wanted {
    /// A number.
    Number,
    /// A natural number: the end of a sum, or an index.
    Natural,
    /// A family of numbers.
    Family,
    /// A function, or a factor.
    Function,
}

/// A paper.
#[derive(Debug, Default)]
pub struct Paper {
    /// The displayed formulas in order.
    pub equations: Vec<Equation>,
    /// What is wrong outside of them.
    pub faults: Vec<Diagnostic>,
    /// The paper's names in its equations: as printed, in the claim language, and how often each occurs.
    pub names: Vec<(String, String, usize)>,
    /// The names in its equations that nothing declares, as printed, and what each may be. What is written like a function of a
    /// number has an argument.
    pub undeclared: BTreeMap<String, Wanted>,
    /// Comments to begin with that declare these names; each is read where it is put before the equations.
    pub offered: Vec<String>,
    /// The number of formulas in running text, which are not read.
    pub inline: usize,
}
