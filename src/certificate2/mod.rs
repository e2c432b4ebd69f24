//! The data of a certificate of format 2: plain values, nothing that reasons.
//!
//! A step can be checked from its own text, the facts that it cites and the declarations in scope. No step changes
//! what a later step means.

pub mod text;

use crate::claim::syntax::{Expr, Name, Prop};

/// The version of the format.
pub const VERSION: u32 = 2;

/// The name of a fact: letters and digits. The hypotheses are `h1`, `h2`, …
pub type Label = String;

/// The steps that show one claim.
#[derive(Clone, Debug)]
pub struct Certificate {
    /// The claim's name.
    pub claim: String,
    /// The SHA-256 of the statement as the kernel writes it, in hexadecimal digits.
    pub statement: String,
    /// The steps in order.
    pub steps: Vec<Step>,
}

/// One step.
#[derive(Clone, Debug)]
pub enum Step {
    /// Shows a proposition, or opens a block that will.
    Show(Box<Show>),
    /// Closes the innermost block. The cited fact is its conclusion.
    End(Label),
}

/// A proposition with the rule and the facts that show it.
#[derive(Clone, Debug)]
pub struct Show {
    /// The name by which later steps cite it.
    pub label: Label,
    /// The rule with its own fields.
    pub rule: Rule,
    /// What is shown.
    pub prop: Prop,
    /// The facts that signs are read from, and by which every expression of the step has a value.
    pub by: Vec<Label>,
    /// Equations whose left sides are replaced by their right sides in this step, in this order.
    pub using: Vec<Label>,
}

/// A summand of a combination: an expression times differences of facts.
#[derive(Clone, Debug)]
pub struct Term {
    /// The facts, each standing for the difference of its sides.
    pub facts: Vec<Label>,
    /// The expression.
    pub factor: Expr,
}

/// The rules, each with the fields that it reads and no others.
#[derive(Clone, Debug)]
pub enum Rule {
    /// Opens a block that shows an implication.
    Suppose,
    /// Opens a block that shows a statement for all values.
    Let,
    /// What follows from facts by the connectives and the order of the reals.
    Logic {
        /// The facts.
        from: Vec<Label>,
    },
    /// A cited claim, or a fact for all values, with values put in.
    Instance {
        /// The fact's label or the claim's name.
        source: String,
        /// The values.
        with: Vec<(Name, Expr)>,
        /// Facts that say that the values lie in the domain and satisfy the hypotheses.
        from: Vec<Label>,
    },
    /// Induction on a natural number.
    Induction {
        /// The statement at the least number.
        base: Label,
        /// The step from n to n + 1, for all n.
        advance: Label,
    },
    /// Existence by a witness.
    Witness {
        /// The values.
        with: Vec<(Name, Expr)>,
        /// Facts that say that the values lie in the domain and have the property.
        from: Vec<Label>,
    },
    /// An extremum by its definition.
    Extremum {
        /// The point's domain, the value there, the bound, and for `only` the uniqueness.
        from: Vec<Label>,
    },
    /// A comparison by a sum of products of facts.
    Combination {
        /// What the difference of the sides is multiplied by.
        times: Option<Expr>,
        /// The summands.
        terms: Vec<Term>,
    },
    /// An equation between products of powers, a power that is positive, or a logarithm of a product.
    Power,
    /// A comparison of powers from that of their bases, or the other way round.
    Monotone {
        /// The comparison.
        from: Label,
    },
    /// A member of a sequence, or a sum or product with a member split off.
    Unfold,
    /// Two sums or products from the comparison of their terms.
    Termwise {
        /// The comparison for all indices.
        from: Label,
    },
    /// The weighted mean inequality for two values: the one analytic lemma.
    Mean {
        /// The values a, b and the weight p.
        with: Vec<(Name, Expr)>,
    },
    /// A limit of a rational function by degrees.
    Limit {
        /// From which numeral on the expression has a value.
        with: Vec<(Name, Expr)>,
    },
    /// A limit between two others.
    Squeeze {
        /// Lower bound for all values, upper bound, and the limits of both.
        from: Vec<Label>,
    },
    /// `A >= B + 1` from `A > B` for whole numbers.
    Integer {
        /// The comparison.
        from: Label,
    },
}

impl Rule {
    /// The name in the text format.
    pub fn name(&self) -> &'static str {
        match self {
            Rule::Suppose => "suppose",
            Rule::Let => "let",
            Rule::Logic { .. } => "logic",
            Rule::Instance { .. } => "instance",
            Rule::Induction { .. } => "induction",
            Rule::Witness { .. } => "witness",
            Rule::Extremum { .. } => "extremum",
            Rule::Combination { .. } => "combination",
            Rule::Power => "power",
            Rule::Monotone { .. } => "monotone",
            Rule::Unfold => "unfold",
            Rule::Termwise { .. } => "termwise",
            Rule::Mean { .. } => "mean",
            Rule::Limit { .. } => "limit",
            Rule::Squeeze { .. } => "squeeze",
            Rule::Integer { .. } => "integer",
        }
    }
}
