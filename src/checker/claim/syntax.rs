//! The syntax tree of a claim file: what the author wrote, with the place of every part.
//!
//! Contract: the tree is plain data. Numerals stay text, so that prover and kernel each read them
//! with their own arithmetic. Chains of `+ -` and of `* /` are flat lists, so that the depth of a
//! tree is bounded by [`MAX_DEPTH`], which the parser enforces; recursion over a tree is safe.
//! Names and expressions are equal where they are written alike; places do not count.

/// The deepest nesting of parentheses, powers, negations and propositions that the parser accepts.
pub const MAX_DEPTH: usize = 200;

pub use super::binding::{Binding, Constraint};
pub use carom_diagnostic::Span;
pub use carom_unit::Unit;

/// A name with its place.
#[derive(Clone, Debug)]
pub struct Name {
    /// The name as written: a letter, then letters, digits and `_`; claim names also hold `-`.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

impl Name {
    /// A name that stands in no file.
    #[must_use]
    pub fn new(text: impl Into<String>) -> Name {
        Name { text: text.into(), span: Span::default() }
    }
}

/// An expression with its place.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where it stands.
    pub span: Span,
}

impl PartialEq for Name {
    fn eq(&self, other: &Name) -> bool {
        self.text == other.text
    }
}

impl Eq for Name {}

impl std::hash::Hash for Name {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.text.hash(state);
    }
}

impl PartialEq for Expr {
    fn eq(&self, other: &Expr) -> bool {
        self.kind == other.kind
    }
}

impl Eq for Expr {}

impl std::hash::Hash for Expr {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.kind.hash(state);
    }
}

/// The sign of a summand in a sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sign {
    /// `+ a`
    Plus,
    /// `- a`
    Minus,
}

/// The operator before a factor in a product.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Factor {
    /// `* a`
    Times,
    /// `/ a`
    Over,
}

/// The kinds of expressions.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum ExprKind {
    /// A numeral as written: `3`, `0.5`, `2.5e-3`. Always non-negative.
    Number(String),
    /// A variable, a definition without parameters, or `infinity` in a limit.
    Name(String),
    /// `f(a, b)`: a definition with parameters, a family or sequence at an index, or one of the
    /// functions of [`FUNCTIONS`].
    Apply(Name, Vec<Expr>),
    /// `-a`
    Negate(Box<Expr>),
    /// `a + b - c`: at least two summands, the first with `Plus`.
    Sum(Vec<(Sign, Expr)>),
    /// `a * b / c`, read from the left: at least two factors, the first with `Times`.
    Product(Vec<(Factor, Expr)>),
    /// `a ^ b`, grouping to the right.
    Power(Box<Expr>, Box<Expr>),
    /// `sum(i = a..b, body)`: the empty sum is 0 when b = a − 1.
    SumOver(Index, Box<Expr>),
    /// `product(i = a..b, body)`: the empty product is 1 when b = a − 1.
    ProductOver(Index, Box<Expr>),
    /// `integral(x = a..b, body)`: the definite integral over a real number from a to b; for b < a its opposite.
    IntegralOver(Index, Box<Expr>),
    /// `derivative(f, x)` or, repeated, `derivative(f, x, x)`: by the variables in turn.
    Derivative(Box<Expr>, Vec<Name>),
    /// `[a, b; c, d]`: rows of equal length, at least one entry.
    Matrix(Vec<Vec<Expr>>),
}

/// The functions that the language knows, with the number of their arguments.
pub const FUNCTIONS: &[(&str, usize)] = &[
    ("sqrt", 1),
    ("cbrt", 1),
    ("exp", 1),
    ("ln", 1),
    ("cos", 1),
    ("sin", 1),
    ("arcsin", 1),
    ("arccos", 1),
    ("arctan", 1),
    ("cosh", 1),
    ("sinh", 1),
    ("tanh", 1),
    ("sech", 1),
    ("det", 1),
    ("transpose", 1),
];

/// Whether the language knows a function of this name.
pub fn is_built_in(name: &str) -> bool {
    FUNCTIONS.iter().any(|f| f.0 == name)
}

/// The number π, where a claim does not declare it.
pub const PI: &str = "pi";

/// The bound index of a sum or a product, or the variable of an integral: `i = from..to`.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Index {
    /// The index, a whole number, or the variable, a real one.
    pub name: Name,
    /// First value, or where the integral begins.
    pub from: Box<Expr>,
    /// Last value, included, or where the integral ends.
    pub to: Box<Expr>,
}

/// A relation between two expressions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// `=`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
}

impl Relation {
    /// An order where equal numbers are in order, too; another relation as it is.
    pub fn loose(self) -> Relation {
        match self {
            Relation::Less => Relation::LessEqual,
            Relation::Greater => Relation::GreaterEqual,
            same => same,
        }
    }

    /// An order where equal numbers are not in order; another relation as it is.
    pub fn strict(self) -> Relation {
        match self {
            Relation::LessEqual => Relation::Less,
            Relation::GreaterEqual => Relation::Greater,
            same => same,
        }
    }

    /// The relation of b to a if this is the relation of a to b.
    pub fn turned(self) -> Relation {
        match self {
            Relation::Less => Relation::Greater,
            Relation::LessEqual => Relation::GreaterEqual,
            Relation::Greater => Relation::Less,
            Relation::GreaterEqual => Relation::LessEqual,
            same => same,
        }
    }

    /// Whether it is `>` or `>=`, and not `<` or `<=`; `=` and `!=` are neither.
    pub fn is_greater(self) -> Option<bool> {
        match self {
            Relation::Greater | Relation::GreaterEqual => Some(true),
            Relation::Less | Relation::LessEqual => Some(false),
            Relation::Equal | Relation::NotEqual => None,
        }
    }

    /// The negated relation.
    pub fn negated(self) -> Relation {
        match self {
            Relation::Equal => Relation::NotEqual,
            Relation::NotEqual => Relation::Equal,
            Relation::Less => Relation::GreaterEqual,
            Relation::LessEqual => Relation::Greater,
            Relation::Greater => Relation::LessEqual,
            Relation::GreaterEqual => Relation::Less,
        }
    }
}

/// A proposition with its place.
#[derive(Clone, Debug)]
pub struct Prop {
    /// What it says.
    pub kind: PropKind,
    /// Where it stands.
    pub span: Span,
}

impl Prop {
    /// The sides and the relation of a single comparison.
    pub fn single(&self) -> Option<(&Expr, Relation, &Expr)> {
        let PropKind::Compare(sides, relations) = &self.kind else { return None };
        match (sides.as_slice(), relations.as_slice()) {
            ([left, right], [relation]) => Some((left, *relation, right)),
            _ => None,
        }
    }
}

/// The kinds of propositions.
#[derive(Clone, Debug)]
pub enum PropKind {
    /// `a <= b < c`: a chain of comparisons; one more expression than relations.
    Compare(Vec<Expr>, Vec<Relation>),
    /// `P and Q`: at least two.
    And(Vec<Prop>),
    /// `P or Q`: at least two.
    Or(Vec<Prop>),
    /// `not P`
    Not(Box<Prop>),
    /// `P => Q`, grouping to the right.
    Implies(Box<Prop>, Box<Prop>),
    /// `P <=> Q <=> R`: all equivalent; at least two.
    Equivalent(Vec<Prop>),
    /// `exists x, y > 0; k natural: P`
    Exists(Vec<Binding>, Box<Prop>),
    /// `for all x > 0: P`, also `for all k in 1..6: P`
    ForAll(Vec<Binding>, Box<Prop>),
    /// `maximum of F over x > 0, y > 0 at x = A, y = B is M`
    Extremum(Box<Extremum>),
    /// `limit of F as n -> infinity is L`
    Limit(Box<Limit>),
    /// A limit at a point or an infinite one, as its author wrote it. The reader writes it out (`crate::claim::limit`);
    /// the kernel refuses it.
    WrittenLimit(Box<WrittenLimit>),
}

/// A global maximum or minimum over a domain, attained at a stated point.
#[derive(Clone, Debug)]
pub struct Extremum {
    /// `maximum` (true) or `minimum` (false).
    pub maximum: bool,
    /// The word `only`: the point is the only one where the extremum is attained.
    pub unique: bool,
    /// The expression whose extremum is stated.
    pub of: Expr,
    /// The variables and their domains (`over`).
    pub over: Vec<Binding>,
    /// The point (`at x = A`), one expression for each variable of `over`.
    pub at: Vec<(Name, Expr)>,
    /// The value there (`is M`).
    pub value: Expr,
}

/// A limit at infinity.
#[derive(Clone, Debug)]
pub struct Limit {
    /// The expression.
    pub of: Expr,
    /// The variable that grows without bound.
    pub variable: Name,
    /// The limit, a finite expression.
    pub value: Expr,
}

/// `limit of F as x -> a from above is L`, `limit of F as n -> infinity is -infinity`, `F = P + O(G) as x -> a`.
#[derive(Clone, Debug)]
pub struct WrittenLimit {
    /// The expression.
    pub of: Expr,
    /// The variable that moves.
    pub variable: Name,
    /// Whether it is said to be a natural number.
    pub natural: bool,
    /// Where it goes.
    pub towards: Towards,
    /// What the expression tends to.
    pub value: Tendency,
}

impl WrittenLimit {
    /// The expressions in it: the function, the point, and the value or what the function is near to and how far from it.
    pub fn parts(&self) -> impl Iterator<Item = &Expr> {
        let point = if let Towards::Point(point, _) = &self.towards { Some(point) } else { None };
        let (value, size) = match &self.value {
            Tendency::Number(value) => (Some(value), None),
            Tendency::Infinite(_) => (None, None),
            Tendency::Order { about, size } => (about.as_ref(), Some(size)),
        };
        std::iter::once(&self.of).chain(point).chain(value).chain(size)
    }

    /// The same with parts that may be changed.
    pub fn parts_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        let point = if let Towards::Point(point, _) = &mut self.towards { Some(point) } else { None };
        let (value, size) = match &mut self.value {
            Tendency::Number(value) => (Some(value), None),
            Tendency::Infinite(_) => (None, None),
            Tendency::Order { about, size } => (about.as_mut(), Some(size)),
        };
        std::iter::once(&mut self.of).chain(point).chain(value).chain(size)
    }
}

/// Where the variable of a limit goes.
#[derive(Clone, Debug)]
pub enum Towards {
    /// Beyond all bounds.
    Infinity,
    /// To a point, from above (`Plus`), from below (`Minus`) or, with no side, from both.
    Point(Expr, Option<Sign>),
}

/// What the expression of a limit tends to.
#[derive(Clone, Debug)]
pub enum Tendency {
    /// A number.
    Number(Expr),
    /// Beyond all bounds, upwards (`Plus`) or downwards (`Minus`).
    Infinite(Sign),
    /// It differs from an expression, or from 0, by at most a multiple of another one: `P + O(G)`.
    Order {
        /// P.
        about: Option<Expr>,
        /// G.
        size: Expr,
    },
}

/// The function of [`Tendency::Order`].
pub(crate) const ORDER: &str = "O";

/// `P + O(G)` as an expression.
pub fn with_order(about: Option<&Expr>, size: &Expr) -> Expr {
    let name = Name { text: ORDER.to_string(), span: size.span };
    let order = Expr { kind: ExprKind::Apply(name, vec![size.clone()]), span: size.span };
    let mut terms = match about.map(|p| &p.kind) {
        None => return order,
        Some(ExprKind::Sum(terms)) => terms.clone(),
        Some(_) => about.map(|p| (Sign::Plus, p.clone())).into_iter().collect(),
    };
    terms.push((Sign::Plus, order));
    Expr { kind: ExprKind::Sum(terms), span: size.span }
}

/// A declaration of a claim, in the order written.
#[derive(Clone, Debug)]
pub enum Item {
    /// `given …; …`
    Given(Vec<Binding>),
    /// `let f(x) = …`: an abbreviation, expanded where used.
    Let {
        /// Its name.
        name: Name,
        /// Its parameters, possibly none.
        parameters: Vec<Name>,
        /// Its value.
        value: Expr,
    },
    /// `define u by u(0) = v1, u(k + 1) = … u(k) …`: a sequence by recurrence.
    Define {
        /// Its name.
        name: Name,
        /// The value at index 0.
        initial: Expr,
        /// The index name k of the step `u(k + 1) = …`.
        index: Name,
        /// The value at k + 1, in terms of k and u(k).
        step: Expr,
        /// Where it stands.
        span: Span,
    },
    /// `assume label: P`
    Assume {
        /// Its label, if any.
        label: Option<Name>,
        /// The hypothesis.
        prop: Prop,
    },
}

/// How the statement was read from the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// As the source prints it, a misprint included.
    Printed,
    /// Damaged text restored by algebra, or still legible.
    Restored,
    /// Exactly as the text was extracted.
    Extracted,
    /// Not in the paper.
    Beyond,
}

/// The verdict that the author expects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Expectation {
    /// `expect proved`; the default.
    #[default]
    Proved,
    /// `expect refuted`
    Refuted,
    /// `expect undecided`
    Undecided,
}

/// A claim.
#[derive(Clone, Debug)]
pub struct Claim {
    /// `claim eq13 "…"`: the name, unique in a catalogue.
    pub name: Name,
    /// The title.
    pub title: String,
    /// `paper "…"` of the preamble: the title of the whole.
    pub paper: Option<String>,
    /// `source "…"`
    pub source: Option<String>,
    /// `section "…"`: groups claims in reports.
    pub section: Option<String>,
    /// `number 13`, `number A.3`: the equation number as the source prints it.
    pub number: Option<String>,
    /// `reading restored|extracted|beyond|as printed`, where the author says it.
    pub reading: Option<Reading>,
    /// `text "…"` above the claim: paragraphs that a report prints before it.
    pub prose: Vec<String>,
    /// `note "…"`: remarks printed with the verdict; several allowed.
    pub notes: Vec<String>,
    /// `using eq06, eq12`: earlier claims that the argument may cite.
    pub using: Vec<Name>,
    /// Declarations in order, those taken from a preamble first.
    pub items: Vec<Item>,
    /// `sample x = 3, y = sqrt(2)`: the author's point that satisfies the hypotheses.
    pub sample: Vec<(Name, Expr)>,
    /// `prove P`
    pub goal: Prop,
    /// The argument, possibly empty; untrusted guidance, every step is checked.
    pub proof: Proof,
    /// `expect …`
    pub expect: Expectation,
    /// The declarations and the goal as their author wrote them, where the reader wrote them out.
    pub written: Option<Box<Written>>,
    /// The equation as the paper prints it that the claim was read from: LaTeX for mathematics mode.
    pub typeset: Option<String>,
}

/// What the author of a claim wrote: declarations and goal before abbreviations, angles, floors and limits are written out.
#[derive(Clone, Debug)]
pub struct Written {
    /// Declarations in order.
    pub items: Vec<Item>,
    /// `prove P`
    pub goal: Prop,
    /// Each name that the reader made, and what it stands for: `cos_theta` for `cos(theta)`.
    pub made: Vec<(String, Expr)>,
}

impl Claim {
    /// The declarations as their author wrote them.
    pub fn written_items(&self) -> &[Item] {
        self.written.as_ref().map_or(&self.items, |written| &written.items)
    }

    /// The goal as its author wrote it.
    pub fn written_goal(&self) -> &Prop {
        self.written.as_ref().map_or(&self.goal, |written| &written.goal)
    }

    /// What a name of the claim stands for, if the reader made it.
    pub fn meaning_of(&self, name: &str) -> Option<&Expr> {
        self.written.as_ref()?.made.iter().find(|made| made.0 == name).map(|made| &made.1)
    }
}

/// A block of steps that ends in a method for the goal.
#[derive(Clone, Debug, Default)]
pub struct Proof {
    /// The steps in order.
    pub steps: Vec<Step>,
    /// `by …` for the goal; `None` means the automatic methods.
    pub close: Option<Method>,
}

impl Proof {
    /// Whether the claim has no argument: the goal is left to the automatic methods.
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty() && self.close.is_none()
    }
}

/// A step of an argument.
#[derive(Clone, Debug)]
pub enum Step {
    /// `have label: P by …` or `have label: P { … }`
    Have {
        /// The label under which later steps cite it.
        label: Name,
        /// What is shown.
        prop: Prop,
        /// How.
        proof: Proof,
    },
    /// `obtain r > 0 with P by r = W`: names a value; P and the domain are checked at r = W.
    Obtain {
        /// The new variable and its domain (one plain name).
        binding: Binding,
        /// The label of the new fact.
        label: Name,
        /// What is known of it.
        prop: Prop,
        /// The value that exists.
        witness: Expr,
    },
    /// `case label: P { … }`, siblings in a row: the cases must cover everything (which is checked)
    /// and each must close the goal.
    Case {
        /// The label of the case's hypothesis.
        label: Name,
        /// The hypothesis of the case.
        prop: Prop,
        /// The argument in this case.
        proof: Proof,
    },
}

/// How to prove a goal. It only guides the search; the kernel checks everything.
#[derive(Clone, Debug)]
pub enum Method {
    /// `by algebra`, `by algebra from a, b`: the automatic methods, only with the named facts if any.
    Algebra(Vec<Name>),
    /// `by induction on n`, `by induction on n { STEPS }`: the base is the least value that the
    /// hypotheses allow; the steps belong to the step from n to n + 1, where the fact `induction` is
    /// the hypothesis.
    Induction(Name, Box<Proof>),
    /// `by power of fact to 1/n`: from A ≥ B > 0 to A^E ≥ B^E, E > 0.
    Power {
        /// The fact.
        fact: Name,
        /// The exponent.
        exponent: Expr,
    },
    /// `by product of a, b^n`: multiplies inequalities between positive sides.
    Product(Vec<(Name, Option<Expr>)>),
    /// `by mean of a, b with weight p`: a^(1−p) b^p ≤ (1−p) a + p b for a, b > 0, 0 ≤ p ≤ 1.
    Mean {
        /// First value.
        a: Expr,
        /// Second value.
        b: Expr,
        /// The weight of the second.
        weight: Expr,
    },
    /// `by hoelder of (a, b), (c, d) with weight p`:
    /// (a+b)^(1−p) (c+d)^p ≥ a^(1−p) c^p + b^(1−p) d^p.
    Hoelder {
        /// First pair.
        first: (Expr, Expr),
        /// Second pair.
        second: (Expr, Expr),
        /// The weight of the second pair.
        weight: Expr,
    },
    /// `by eq19 with n = n + 1, m1 = a`: an instance of a claim under `using` or of a fact `for all`.
    Instance {
        /// The claim or fact.
        claim: Name,
        /// Values for its variables; those not named keep their names.
        with: Vec<(Name, Expr)>,
    },
    /// `by witness x = 1, y = 2`
    Witness(Vec<(Name, Expr)>),
    /// `by squeeze between A and B`: both ends have the limit by themselves; the inequalities must
    /// be facts or follow from facts by the automatic methods.
    Squeeze {
        /// Lower bound.
        lower: Expr,
        /// Upper bound.
        upper: Expr,
    },
}
