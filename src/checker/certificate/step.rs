//! The data of a certificate: plain values, nothing that reasons.

use crate::claim::syntax::{Expr, Name, Prop};

/// The version of the format.
pub const VERSION: u32 = 2;

/// The name of a fact: letters and digits. The hypotheses are `h1`, `h2`, …
pub type Label = String;

/// The steps that show one claim, or that it is false at a point.
#[derive(Clone, Debug)]
pub struct Certificate {
    /// The claim's name.
    pub claim: String,
    /// The SHA-256 of the statement as the kernel writes it, in hexadecimal digits.
    pub statement: String,
    /// Where and how the claim is false; nothing for a proof.
    pub refutes: Option<Refutes>,
    /// The steps in order.
    pub steps: Vec<Step>,
}

/// Where and how a claim is false.
#[derive(Clone, Debug, Default)]
pub struct Refutes {
    /// Variables and members of families with their values.
    pub point: Vec<(Expr, Expr)>,
    /// The expression of the goal that has no value there; nothing where the goal is false.
    pub undefined: Option<Expr>,
}

/// One step.
#[derive(Clone, Debug)]
pub enum Step {
    /// Shows a proposition, or opens a block that will.
    Show(Box<Show>),
    /// Closes the innermost block. The cited fact is its conclusion.
    End(Label),
}

impl Step {
    /// What it shows; nothing for the end of a block.
    pub fn show(&self) -> Option<&Show> {
        match self {
            Step::Show(show) => Some(show),
            Step::End(_) => None,
        }
    }
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
    /// A consequence of facts by the connectives and the order of the reals.
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
    /// What holds for all that exist, and does not speak of them.
    Existence {
        /// The statement `exists`.
        some: Label,
        /// For all of these, what they have implies the conclusion.
        all: Label,
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
    /// An expression gets a new name.
    Name,
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
    /// The weighted mean inequality for two values: an analytic lemma.
    Mean {
        /// The values a, b and the weight p.
        with: Vec<(Name, Expr)>,
    },
    /// exp lies above its tangent at 0: an analytic lemma.
    Tangent {
        /// The exponent x.
        with: Vec<(Name, Expr)>,
    },
    /// What cosine and sine of a number are by the unit circle.
    Circle {
        /// The number u.
        with: Vec<(Name, Expr)>,
    },
    /// What arcsin, arccos and arctan are by their inverses, and that they rise or fall.
    Arc,
    /// A function of one variable at two values, from the sign of its derivative: the mean value theorem.
    Slope {
        /// The sign of the derivative, for all values in an interval.
        source: Label,
        /// The values a and b.
        with: Vec<(Name, Expr)>,
        /// Facts that say that the values lie in the interval.
        from: Vec<Label>,
    },
    /// A solution between two values at which the sides differ in opposite directions: the intermediate value theorem.
    Intermediate {
        /// The values a and b.
        with: Vec<(Name, Expr)>,
        /// The sides at a, the sides at b, and facts that say that the values lie in the interval.
        from: Vec<Label>,
    },
    /// A limit of a quotient of sums of powers by degrees.
    Limit {
        /// From which numeral on the expression has a value.
        with: Vec<(Name, Expr)>,
    },
    /// A limit between two others.
    Squeeze {
        /// Lower bound for all values, upper bound, and the limits of both.
        from: Vec<Label>,
    },
    /// A limit as x grows from that with exp(y) in the place of x.
    Along {
        /// The limit as y grows.
        from: Label,
    },
    /// What a limit says of all values from some number on.
    Eventually {
        /// The limit.
        from: Label,
    },
    /// A statement that arithmetic decides at a point.
    Evaluate,
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
            Rule::Existence { .. } => "existence",
            Rule::Witness { .. } => "witness",
            Rule::Extremum { .. } => "extremum",
            Rule::Combination { .. } => "combination",
            Rule::Power => "power",
            Rule::Monotone { .. } => "monotone",
            Rule::Unfold => "unfold",
            Rule::Termwise { .. } => "termwise",
            Rule::Mean { .. } => "mean",
            Rule::Tangent { .. } => "tangent",
            Rule::Circle { .. } => "circle",
            Rule::Arc => "arc",
            Rule::Slope { .. } => "slope",
            Rule::Intermediate { .. } => "intermediate",
            Rule::Limit { .. } => "limit",
            Rule::Squeeze { .. } => "squeeze",
            Rule::Along { .. } => "along",
            Rule::Eventually { .. } => "eventually",
            Rule::Integer { .. } => "integer",
            Rule::Name => "name",
            Rule::Evaluate => "evaluate",
        }
    }

    /// The values that the rule puts in for names.
    pub fn values(&self) -> &[(Name, Expr)] {
        match self {
            Rule::Instance { with, .. }
            | Rule::Witness { with, .. }
            | Rule::Mean { with }
            | Rule::Tangent { with }
            | Rule::Circle { with }
            | Rule::Slope { with, .. }
            | Rule::Intermediate { with, .. }
            | Rule::Limit { with } => with,
            _ => &[],
        }
    }

    /// The facts that the rule is applied to; for an instance the first is its source, which may be a claim.
    pub fn from(&self) -> Vec<&Label> {
        match self {
            Rule::Logic { from }
            | Rule::Witness { from, .. }
            | Rule::Extremum { from }
            | Rule::Intermediate { from, .. }
            | Rule::Squeeze { from } => from.iter().collect(),
            Rule::Instance { source, from, .. } | Rule::Slope { source, from, .. } => {
                std::iter::once(source).chain(from).collect()
            }
            Rule::Induction { base, advance } => vec![base, advance],
            Rule::Existence { some, all } => vec![some, all],
            Rule::Monotone { from }
            | Rule::Termwise { from }
            | Rule::Integer { from }
            | Rule::Along { from }
            | Rule::Eventually { from } => vec![from],
            _ => Vec::new(),
        }
    }
}

impl Show {
    /// Whether the step opens a block.
    pub fn opens(&self) -> bool {
        matches!(self.rule, Rule::Suppose | Rule::Let)
    }

    /// Gives every fact that the step cites another label, and the claim if it is an instance of one.
    pub fn relabel(&mut self, new: &mut dyn FnMut(&str) -> Label) {
        let mut each = |labels: &mut dyn Iterator<Item = &mut Label>| labels.for_each(|label| *label = new(label));
        each(&mut self.by.iter_mut().chain(&mut self.using));
        match &mut self.rule {
            Rule::Logic { from }
            | Rule::Witness { from, .. }
            | Rule::Extremum { from }
            | Rule::Intermediate { from, .. }
            | Rule::Squeeze { from } => {
                each(&mut from.iter_mut());
            }
            Rule::Instance { source, from, .. } | Rule::Slope { source, from, .. } => {
                each(&mut from.iter_mut().chain([source]));
            }
            Rule::Induction { base, advance } => each(&mut [base, advance].into_iter()),
            Rule::Existence { some, all } => each(&mut [some, all].into_iter()),
            Rule::Monotone { from }
            | Rule::Termwise { from }
            | Rule::Integer { from }
            | Rule::Along { from }
            | Rule::Eventually { from } => each(&mut std::iter::once(from)),
            Rule::Combination { terms, .. } => each(&mut terms.iter_mut().flat_map(|term| &mut term.facts)),
            Rule::Suppose
            | Rule::Let
            | Rule::Name
            | Rule::Power
            | Rule::Evaluate
            | Rule::Unfold
            | Rule::Mean { .. }
            | Rule::Tangent { .. }
            | Rule::Circle { .. }
            | Rule::Arc
            | Rule::Limit { .. } => {}
        }
    }

    /// Every fact that the step cites, and the claim if it is an instance of one.
    pub fn cited(&self) -> impl Iterator<Item = &Label> {
        let terms = match &self.rule {
            Rule::Combination { terms, .. } => terms.as_slice(),
            _ => &[],
        };
        let facts = terms.iter().flat_map(|term| &term.facts);
        self.rule.from().into_iter().chain(facts).chain(&self.by).chain(&self.using)
    }
}
