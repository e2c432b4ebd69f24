//! The result of an audit for one claim: the verdict with its evidence.

use crate::claim::print::Style;
use crate::claim::syntax::{Claim, Expectation, Span};

/// The three verdicts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// Proved for all values that satisfy the hypotheses.
    Proved,
    /// False at an exact point that satisfies every hypothesis, or adds or compares different dimensions.
    Refuted,
    /// Neither; [`Outcome::reason`] says what was tried or which limit was reached.
    Undecided,
}

impl Verdict {
    /// `proved`, `refuted` or `undecided`.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Proved => "proved",
            Verdict::Refuted => "refuted",
            Verdict::Undecided => "undecided",
        }
    }

    /// Whether the author expected this verdict.
    pub fn is_expected(self, expected: Expectation) -> bool {
        matches!(
            (self, expected),
            (Verdict::Proved, Expectation::Proved)
                | (Verdict::Refuted, Expectation::Refuted)
                | (Verdict::Undecided, Expectation::Undecided)
        )
    }
}

/// An exact point: variable names with exact values in the order of declaration.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Point {
    /// `("m1", "4")`, `("mu(1)", "3/2")`: the values are integers or fractions `p/q`, of angles also multiples of π and roots,
    /// `("x", "2*pi/3")`; those of a sample point may be roots, `("x", "1/2 + 1/2*sqrt(5)")`.
    pub values: Vec<(String, String)>,
}

impl Point {
    /// The values with their names in the words of the claim's author: `cos(theta)` with `3/5`, where the reader made a name for
    /// the cosine.
    pub fn named<'a>(&'a self, claim: &'a Claim, style: Style) -> impl Iterator<Item = (String, &'a str)> {
        let word =
            move |name: &str| claim.meaning_of(name).map_or_else(|| style.name(name), |meaning| style.expr(meaning));
        self.values.iter().map(move |(name, value)| (word(name), value.as_str()))
    }

    /// The same, each as one text: `cos(theta) = 3/5`.
    pub fn in_words(&self, claim: &Claim) -> Vec<String> {
        self.named(claim, Style::Text).map(|(name, value)| format!("{name} = {value}")).collect()
    }
}

/// A counterexample with what it breaks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Witness {
    /// Where.
    pub point: Point,
    /// What is false there: the broken comparison as text with both sides' values, for instance
    /// `eta3 >= eta2` with `16/81` and `1/4`. Sides that are not rational are given as text with
    /// enough digits to see the difference.
    pub broken: Vec<Broken>,
}

/// A comparison that fails at a witness.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Broken {
    /// The comparison as text.
    pub statement: String,
    /// The value of its left side.
    pub left: String,
    /// The value of its right side.
    pub right: String,
}

/// The method of a refutation by dimensions that differ.
pub const DIMENSIONS: &str = "dimensions";

/// The message for a limit that was reached, with the flag that raises it.
pub fn limit_reached(name: &str) -> String {
    let flag = match name {
        "steps" => " (--max-steps raises it)",
        "time" => " (--time raises it)",
        _ => "",
    };
    format!("limit reached: {name}{flag}")
}

/// A goal that the search for a proof was left with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remaining {
    /// The goal, as text.
    pub goal: String,
    /// The methods that were tried, in their order.
    pub tried: Vec<&'static str>,
    /// The factors of the difference of its sides whose signs are open, as text.
    pub open: Vec<String>,
}

/// The result of the audit for one claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// The claim's name.
    pub claim: String,
    /// The verdict.
    pub verdict: Verdict,
    /// The main rule of the argument, or of the refutation: `identity`, `elimination`, `sign`,
    /// `equivalence`, `extremum`, `induction`, `mean inequality`, `tangent`, `limit`, `witness`, `search`,
    /// `definedness`, `dimensions`, …; empty when undecided.
    pub method: String,
    /// The hypotheses that the argument used, as text; hypotheses that only make expressions
    /// defined are included.
    pub used: Vec<String>,
    /// The stated hypotheses that the argument did not use.
    pub unused: Vec<String>,
    /// A point where all hypotheses hold; `None` when the claim has none or none was needed.
    pub sample: Option<Point>,
    /// The counterexample of a refutation.
    pub witness: Option<Witness>,
    /// Why it is undecided: what was tried, what is missing, or the limit reached. Of a claim refuted without a witness: which
    /// dimensions differ. Of a proved claim: that no point is known at
    /// which its hypotheses hold.
    pub reason: Option<String>,
    /// The limit that was reached, if one was.
    pub limit: Option<&'static str>,
    /// Of a claim that the search proved: the methods that showed its comparisons.
    pub found_by: Vec<&'static str>,
    /// Of an undecided claim: the goals that remained.
    pub remaining: Vec<Remaining>,
    /// For an undecided claim: the number of points, tried for a counterexample, at which the claim was true.
    pub points: usize,
    /// For an undecided claim: the number of those that left it open.
    pub open: usize,
}

/// A claim that cannot be judged because it makes no sense; the audit of its file fails (exit 2).
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// No values satisfy all hypotheses.
    Contradictory {
        /// The contradictory hypotheses, as text.
        hypotheses: String,
    },
    /// An error in the text, such as an undeclared label or a method that does not fit.
    Text(Diagnose),
}

/// A fault at a place of the claim, found after it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnose {
    /// What is wrong.
    pub message: String,
    /// What would be right, if known.
    pub help: Option<String>,
    /// Where.
    pub span: Span,
}
