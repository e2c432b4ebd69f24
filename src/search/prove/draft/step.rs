//! The steps of a draft: plain values, nothing that reasons.

use crate::certificate::Term;
use crate::claim::syntax::{Expr, Name, Prop};

/// One step: a rule with what it is applied to.
#[derive(Clone, Debug)]
pub(crate) struct Step {
    /// Its name, by which later steps cite what it shows; `end` has none.
    pub label: String,
    /// The rule.
    pub rule: Rule,
    /// The facts that it is applied to, by label; `h1`, `h2`, … are the hypotheses.
    pub from: Vec<String>,
    /// What it shows.
    pub prop: Option<Prop>,
    /// Values for names.
    pub with: Vec<(Name, Expr)>,
    /// A common multiplier.
    pub times: Option<Expr>,
    /// The summands of a combination.
    pub terms: Vec<Term>,
}

macro_rules! rules {
    ($($(#[$doc:meta])* $rule:ident = $name:literal,)*) => {
        /// The rules of drafts; some need several steps of a certificate.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum Rule {
            $($(#[$doc])* $rule,)*
        }

        impl Rule {
            /// The name, for messages.
            pub(crate) fn name(self) -> &'static str {
                match self {
                    $(Rule::$rule => $name,)*
                }
            }
        }
    };
}

rules! {
    /// Writes a power as a product of other powers.
    Power = "power",
    /// An equation between positive values whose logarithms agree.
    Logarithm = "logarithm",
    /// From here on the left side of an equation is written as its right side.
    Replace = "replace",
    /// A member of a sequence, or a sum or product with a member split off.
    Unfold = "unfold",
    /// Notes the sign that a fact gives, and what a hypothesis takes for granted.
    Note = "note",
    /// A comparison by the signs of the factors of the difference.
    Sign = "sign",
    /// A comparison by a sum of products of facts.
    Combination = "combination",
    /// Opens a block that shows an implication.
    Suppose = "suppose",
    /// Opens a block that shows a statement for all values.
    Let = "let",
    /// Closes a block.
    End = "end",
    /// A conjunction, or a chain of comparisons, from its parts.
    All = "all",
    /// A part of a conjunction or of a chain of comparisons.
    Part = "part",
    /// A disjunction from one of its parts.
    Either = "either",
    /// A comparison or its negation holds.
    Excluded = "excluded",
    /// What each case of a disjunction implies.
    Cases = "cases",
    /// Modus ponens.
    Apply = "apply",
    /// An equivalence from its implications.
    Equivalent = "equivalent",
    /// A statement from one with `not` moved inwards.
    Negation = "negation",
    /// Anything, from a comparison of numbers that is false.
    Absurd = "absurd",
    /// A cited claim or a fact for all values, with values put in.
    Instance = "instance",
    /// Induction on a natural number.
    Induction = "induction",
    /// Existence by a witness.
    Witness = "witness",
    /// Positive powers of both sides of a comparison.
    Monotone = "monotone",
    /// The weighted mean inequality for two values: the one analytic lemma.
    Mean = "mean",
    /// An extremum by its definition.
    Extremum = "extremum",
    /// A limit of a rational function by degrees.
    Limit = "limit",
    /// A limit between two others.
    Squeeze = "squeeze",
}
