//! The kernel: certificates checked step by step, each from its own text and the facts that it cites.
//!
//! Contract: [`check`] returns [`Verdict::Accepted`] only if the claim's goal holds, with a value for every expression
//! in it, at every point that its hypotheses allow. The prover is not asked.
//!
//! **What a fact is.** At every point that satisfies the hypotheses and the suppositions of the open blocks, each fact
//! is true and has a value (`logic` says when a proposition has one). A rule adds a fact only if that stays so. Above
//! each rule stands why. A block ends by turning its conclusion into an implication or a statement `for all`, and all
//! else in it is forgotten.
//!
//! **No hidden state.** Besides the facts the kernel keeps the names in scope. What signs a step may use it reads from
//! the facts under `by`, which equations it puts in from those under `using`. No step changes what a later one means.
//!
//! **What is assumed.** The field and order of the reals; exp and its inverse ln on positive numbers, with
//! b^E = exp(E·ln b); derivatives of these; induction; two inequalities, the weighted mean of two values
//! and exp above its tangent (`analysis`); and the mean value theorem (`slope`). An acceptance says whether it rests on
//! these three.
//!
//! The kernel imports the syntax tree, the certificate as data, num-bigint and num-rational. Nothing is searched.
//!
//! Work, depth and size have limits. Reaching one is no rejection but [`Verdict::Declined`].

pub mod analysis;
mod arithmetic;
mod defined;
mod derivative;
pub(crate) mod enclosure;
mod evaluate;
pub mod fraction;
pub mod key;
mod logic;
mod matrix;
mod memo;
pub(crate) mod order;
mod over;
mod poly;
mod power;
mod quantifier;
mod reason;
pub mod refutation;
mod replace;
mod sign;
pub(crate) mod slope;
pub mod statement;
mod term;
pub mod text;
pub(crate) mod view;
pub(crate) mod words;

pub use quantifier::domains;
pub use reason::Reason;
pub use term::numeral;

use crate::certificate::{Certificate, Label, Rule, Show, Step};
use crate::claim::syntax::{Binding, Claim, Expr, ExprKind, Prop, PropKind};
use fraction::Work;
use sign::Known;
use statement::{Statement, Substitution, names_in};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::rc::Rc;
use term::Atom;

/// The most steps of a certificate.
pub(crate) const STEPS_LIMIT: usize = 50_000;
/// The most names that a statement declares, and that are in scope at once.
pub(crate) const NAMES_LIMIT: usize = 1_000;

/// Why a step was not taken.
#[derive(Clone, Debug)]
pub enum Refusal {
    /// It is not justified.
    Rejected(Reason),
    /// A limit was reached, by name.
    Limit(&'static str),
}

fn rejected<T>(reason: Reason) -> Result<T, Refusal> {
    Err(Refusal::Rejected(reason))
}

/// A claim that was shown. Only the kernel makes one.
#[derive(Clone, Debug)]
pub struct Accepted {
    statement: Statement,
    rests_on: BTreeSet<String>,
    assumed: BTreeSet<Label>,
}

impl Accepted {
    /// The statement as the kernel understood it.
    pub fn text(&self) -> String {
        self.statement.text()
    }

    /// The same as data.
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// The cited claims and analytic lemmas that it rests on, those of cited claims included.
    pub fn rests_on(&self) -> &BTreeSet<String> {
        &self.rests_on
    }

    /// The hypotheses that it rests on although no step cites them: by which members of sequences have values, and
    /// domains of families that are put for those of cited claims.
    pub fn assumed(&self) -> &BTreeSet<Label> {
        &self.assumed
    }
}

/// What the kernel says of a certificate.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// The claim is shown.
    Accepted(Box<Accepted>),
    /// The claim is false, at the point of the certificate.
    Refuted,
    /// It is not, by this certificate.
    Rejected {
        /// The first bad step, by label; empty for the statement and the end.
        step: Label,
        /// Its rule.
        rule: &'static str,
        /// What is wrong.
        reason: Reason,
    },
    /// A limit was reached.
    Declined {
        /// Its name.
        limit: &'static str,
    },
}

/// Checks a certificate of a claim; `cited` holds what was accepted of the claims under `using`.
pub fn check(claim: &Claim, certificate: &Certificate, cited: &[&Accepted]) -> Verdict {
    let verdict = |step: &str, rule, refusal| match refusal {
        Refusal::Rejected(reason) => Verdict::Rejected { step: step.to_string(), rule, reason },
        Refusal::Limit(limit) => Verdict::Declined { limit },
    };
    let refuting = match certificate.refutes.as_ref().map(|refutes| refutation::of(claim, refutes)) {
        None => None,
        Some(Ok(claim)) => Some(claim),
        Some(Err(refusal)) => return verdict("", "statement", refusal),
    };
    let mut checker = match Checker::new(refuting.as_ref().unwrap_or(claim), cited) {
        Ok(checker) => checker,
        Err(refusal) => return verdict("", "statement", refusal),
    };
    if certificate.claim != claim.name.text {
        return verdict("", "statement", Refusal::Rejected(Reason::OtherClaim));
    }
    for step in &certificate.steps {
        if let Err(refusal) = checker.step(step) {
            return match step {
                Step::Show(show) => verdict(&show.label, show.rule.name(), refusal),
                Step::End(_) => verdict("", "end", refusal),
            };
        }
    }
    match checker.finish() {
        Ok(_) if refuting.is_some() => Verdict::Refuted,
        Ok(accepted) => Verdict::Accepted(Box::new(accepted)),
        Err(refusal) => verdict("", "qed", refusal),
    }
}

/// What a step rests on besides the facts that its rule cites.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Used {
    /// Of the facts under `by`.
    pub by: Vec<Label>,
    /// Of the equations under `using`.
    pub using: Vec<Label>,
}

/// A name in scope.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Variable {
    name: String,
    natural: bool,
    /// What it stands for in fractions: itself, or a bound index.
    atom: Atom,
}

/// Something known.
#[derive(Clone, Debug)]
struct Fact {
    label: Label,
    prop: Rc<Prop>,
    /// The length of what it says, which whoever cites it reads.
    size: usize,
}

/// A block that is open, with how much is kept at its end.
#[derive(Clone, Debug)]
struct Block {
    label: Label,
    goal: Prop,
    facts: usize,
    scope: usize,
}

/// The state of a check.
///
/// Whoever holds one can read its facts and take steps. Nobody outside the kernel can make a fact, a fresh budget or
/// an acceptance. This claim is false; its goal is no fact, and `finish` says so:
///
/// ```
/// use carom::{claim::parse::parse, kernel::Checker};
/// let claims = parse("claim false \"x = x + 1\"\ngiven x real\nprove x = x + 1\n").unwrap_or_default();
/// let Ok(checker) = Checker::new(&claims[0], &[]) else { panic!("no checker") };
/// assert_eq!(checker.facts().count(), 0);
/// assert!(checker.finish().is_err());
/// ```
///
/// The goal cannot be slipped in among the facts, from outside, nor a new budget:
///
/// ```compile_fail,E0616
/// use carom::{claim::syntax::Prop, kernel::Checker};
/// fn forge(checker: &mut Checker, goal: Prop) {
///     checker.facts.push(std::rc::Rc::new(goal).into());
/// }
/// ```
///
/// ```compile_fail,E0624
/// use carom::{claim::syntax::Prop, kernel::Checker};
/// fn forge(checker: &mut Checker, goal: Prop) {
///     let _ = checker.know("1", goal);
/// }
/// ```
///
/// ```compile_fail,E0616
/// use carom::kernel::{Checker, fraction::Work};
/// fn again(checker: &mut Checker) {
///     checker.work = Work::default();
/// }
/// ```
///
/// And an acceptance is not made by hand:
///
/// ```compile_fail,E0451
/// use carom::kernel::{Accepted, statement::Statement};
/// fn forge(statement: Statement) -> Accepted {
///     Accepted { statement, rests_on: Default::default(), assumed: Default::default() }
/// }
/// ```
#[derive(Clone)]
pub struct Checker {
    statement: Rc<Statement>,
    cited: Rc<Vec<Accepted>>,
    rests_on: BTreeSet<String>,
    /// What is used and not cited.
    assumed: BTreeSet<Label>,
    facts: Vec<Fact>,
    /// The facts by label.
    labels: HashMap<Label, usize>,
    blocks: Vec<Block>,
    scope: Vec<Variable>,
    atoms: Vec<Atom>,
    atom_index: BTreeMap<Atom, usize>,
    /// How many indices of sums and products are in scope.
    binders: usize,
    /// The equations put in while an expression of a step is read; empty between.
    put_in: Rc<Vec<sign::Equation>>,
    /// Which of them were.
    were_put_in: BTreeSet<usize>,
    memo: memo::Memo,
    steps: usize,
    work: Work,
}

impl Checker {
    /// The state before the first step: the domains and hypotheses are the facts `h1`, `h2`, …
    ///
    /// # Errors
    /// The statement makes no sense to the kernel, or is beyond a limit.
    pub fn new(claim: &Claim, cited: &[&Accepted]) -> Result<Checker, Refusal> {
        let statement = Statement::of(claim)?;
        if statement.bindings.iter().map(|b| b.names.len()).sum::<usize>() + statement.sequences.len() > NAMES_LIMIT {
            return Err(Refusal::Limit("names"));
        }
        let allowed: BTreeSet<&str> = claim.using.iter().map(|n| n.text.as_str()).collect();
        let cited =
            cited.iter().filter(|a| allowed.contains(a.statement.name.as_str())).map(|a| (*a).clone()).collect();
        let mut checker = Checker {
            statement: Rc::new(statement),
            cited: Rc::new(cited),
            rests_on: BTreeSet::new(),
            assumed: BTreeSet::new(),
            facts: Vec::new(),
            labels: HashMap::new(),
            blocks: Vec::new(),
            scope: Vec::new(),
            atoms: Vec::new(),
            atom_index: BTreeMap::new(),
            binders: 0,
            put_in: Rc::new(Vec::new()),
            were_put_in: BTreeSet::new(),
            memo: memo::Memo::default(),
            steps: 0,
            work: Work::default(),
        };
        checker.hypotheses()?;
        Ok(checker)
    }

    /// Declares what the claim declares, and takes its domains and hypotheses as facts. A hypothesis is understood to
    /// say of its own expressions that they have values.
    fn hypotheses(&mut self) -> Result<(), Refusal> {
        let statement = self.statement.clone();
        for binding in &statement.bindings {
            self.declare_binding(binding)?;
        }
        // A sequence speaks of what the claim declares, never of a variable that a block introduces later, nor of a
        // sequence that is defined after it; and of itself only by the member before.
        for (place, u) in statement.sequences.iter().enumerate() {
            let mut names = BTreeSet::new();
            names_in(&u.step, &mut names);
            names.remove(&u.index);
            names_in(&u.initial, &mut names);
            let known = |n: &String| self.is_declared(n) || term::FUNCTIONS.contains(&n.as_str());
            if let Some(free) = names.iter().find(|n| !known(n)) {
                return rejected(Reason::Undeclared(free.clone()));
            }
            let later = statement.sequences.iter().skip(place + 1).any(|v| names.contains(&v.name));
            let mut first = BTreeSet::new();
            names_in(&u.initial, &mut first);
            if later || first.contains(&u.name) || !statement::steps_once(&u.step, &u.name, &u.index) {
                return rejected(Reason::Sequence(u.name.clone()));
            }
        }
        self.moving_variables_are_free()?;
        let domains = statement.bindings.iter().flat_map(quantifier::domains);
        for prop in domains.chain(statement.assumptions.iter().cloned()) {
            let label = format!("h{}", self.facts.len() + 1);
            self.know(&label, prop)?;
        }
        // Every member has a value, so that a member is one wherever its index is a natural number.
        let all: Vec<Label> = self.facts.iter().map(|f| f.label.clone()).collect();
        for u in &statement.sequences {
            let mut known = self.known(&all, &[])?;
            let of_member = |refusal: Refusal| match refusal {
                Refusal::Rejected(because) => Refusal::Rejected(Reason::Member(u.name.clone(), Box::new(because))),
                limit => limit,
            };
            self.defined(&u.initial, &mut known).map_err(of_member)?;
            self.binders += 1;
            let bound = self.binders;
            let result = self.under(&u.index, bound, |checker| checker.defined(&u.step, &mut known));
            self.binders -= 1;
            result.map_err(of_member)?;
            self.assumed.extend(cited(known.used().0, &all));
        }
        Ok(())
    }

    /// The statement that is to be shown.
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// What a claim says that was accepted and is cited under `using`.
    pub(crate) fn cited_statement(&self, name: &str) -> Option<&Statement> {
        self.cited.iter().map(|accepted| &accepted.statement).find(|statement| statement.name == name)
    }

    /// The facts, with their labels.
    pub fn facts(&self) -> impl Iterator<Item = (&str, &Prop)> {
        self.facts.iter().map(|fact| (fact.label.as_str(), &*fact.prop))
    }

    /// Whether a proposition is an equation that can be put in after these: its left side is an atom, a power or an exponential.
    pub(crate) fn can_be_put_in(&mut self, p: &Prop, after: &[Label]) -> bool {
        self.known(&[], after).is_ok_and(|known| self.equation(p, &known).is_ok())
    }

    /// The difference of the sides of a single comparison, if it is a number once the equations are put in.
    ///
    /// # Errors
    /// A side cannot be read, or an equation cannot be put in.
    pub fn constant(&mut self, p: &Prop, using: &[Label]) -> Result<Option<num_rational::BigRational>, Refusal> {
        let known = self.known(&[], using)?;
        let (a, _, b) = sign::single(p)?;
        let difference = self.fraction_with(a, &known)?.minus(&self.fraction_with(b, &known)?, &self.work)?;
        Ok(difference.as_number().cloned())
    }

    /// Takes one step, or says why not; then no fact is added and no block opened or closed.
    ///
    /// # Errors
    /// The step is not justified, or a limit was reached.
    pub fn step(&mut self, step: &Step) -> Result<(), Refusal> {
        self.steps += 1;
        if self.steps > STEPS_LIMIT {
            return Err(Refusal::Limit("steps"));
        }
        let show = match step {
            Step::Show(show) => show,
            Step::End(conclusion) => return self.end(conclusion),
        };
        self.fresh_label(&show.label)?;
        well_formed(show)?;
        let (scope, binders) = (self.scope.len(), self.binders);
        let result = self.show(show);
        if result.is_err() {
            self.scope.truncate(scope);
            self.binders = binders;
        }
        result
    }

    /// Which facts under `by` and which equations under `using` a step that is justified rests on. Nothing is added:
    /// for whoever writes a certificate and wants its citations short.
    ///
    /// # Errors
    /// The step is not justified, or a limit was reached.
    pub fn used(&mut self, show: &Show) -> Result<Used, Refusal> {
        well_formed(show)?;
        let (scope, binders, rests_on, assumed) =
            (self.scope.len(), self.binders, self.rests_on.clone(), self.assumed.clone());
        let spent = self.work.clone();
        let result = self.justified(show);
        self.work = spent;
        self.scope.truncate(scope);
        self.binders = binders;
        self.rests_on = rests_on;
        self.assumed = assumed;
        let (by, using) = result?.used();
        Ok(Used { by: cited(by, &show.by).collect(), using: cited(using, &show.using).collect() })
    }

    /// Whether the rule of a step justifies it; what it knew is returned.
    fn justified(&mut self, show: &Show) -> Result<Known, Refusal> {
        let goal = &show.prop;
        let mut known = self.known(&show.by, &show.using)?;
        match &show.rule {
            Rule::Suppose => self.may_be_supposed(goal, &mut known)?,
            Rule::Let => self.may_be_let(goal, &mut known)?,
            Rule::Logic { from } => self.logic(goal, from, &mut known)?,
            Rule::Instance { source, with, from } => self.instance(goal, source, with, from, &mut known)?,
            Rule::Induction { base, advance } => self.induction(goal, base, advance)?,
            Rule::Witness { with, from } => self.witness(goal, with, from, &mut known)?,
            Rule::Extremum { from } => self.extremum(goal, from, &mut known)?,
            Rule::Combination { times, terms } => self.combination(goal, times.as_ref(), terms, &mut known)?,
            Rule::Power => self.power_rule(goal, &mut known)?,
            Rule::Monotone { from } => self.monotone(goal, from, &mut known)?,
            Rule::Unfold => self.unfold(goal, &mut known)?,
            Rule::Termwise { from } => self.termwise(goal, from, &mut known)?,
            Rule::Mean { with } => self.mean(goal, with, &mut known)?,
            Rule::Tangent { with } => self.tangent(goal, with, &mut known)?,
            Rule::Slope { source, with, from } => self.slope(goal, source, with, from, &mut known)?,
            Rule::Limit { with } => self.limit(goal, with, &mut known)?,
            Rule::Squeeze { from } => self.squeeze(goal, from)?,
            Rule::Integer { from } => self.integer(goal, from, &mut known)?,
            Rule::Name => self.name(goal, &mut known)?,
            Rule::Evaluate => {
                self.evaluate(goal, &show.using)?;
                known.all_put_in(show.using.len());
            }
        }
        Ok(known)
    }

    fn show(&mut self, show: &Show) -> Result<(), Refusal> {
        self.justified(show)?;
        match &show.rule {
            Rule::Suppose | Rule::Let => self.open(&show.label, &show.prop),
            _ => self.know(&show.label, show.prop.clone()),
        }
    }

    /// Whether the goal is shown.
    ///
    /// # Errors
    /// It is not.
    pub fn finish(self) -> Result<Accepted, Refusal> {
        if !self.blocks.is_empty() {
            return rejected(Reason::OpenBlock);
        }
        let goal = key::prop(&self.statement.goal);
        // The goal is what the last step shows.
        match self.facts.last() {
            Some(fact) if key::prop(&fact.prop) == goal => {
                Ok(Accepted { statement: (*self.statement).clone(), rests_on: self.rests_on, assumed: self.assumed })
            }
            _ => rejected(Reason::GoalNotShown),
        }
    }

    fn fresh_label(&self, label: &str) -> Result<(), Refusal> {
        if self.labels.contains_key(label) || self.blocks.iter().any(|b| b.label == label) {
            return rejected(Reason::LabelInUse(label.to_string()));
        }
        Ok(())
    }

    /// A fact by label.
    fn fact(&self, label: &str) -> Result<Rc<Prop>, Refusal> {
        match self.labels.get(label).and_then(|place| self.facts.get(*place)) {
            Some(fact) => {
                self.work.count(fact.size)?;
                Ok(fact.prop.clone())
            }
            None => rejected(Reason::NoFact(label.to_string())),
        }
    }

    /// Adds a fact.
    fn know(&mut self, label: &str, prop: Prop) -> Result<(), Refusal> {
        self.fresh_label(label)?;
        let size = key::prop(&prop).len();
        self.work.count(size)?;
        self.labels.insert(label.to_string(), self.facts.len());
        self.facts.push(Fact { label: label.to_string(), prop: Rc::new(prop), size });
        Ok(())
    }

    fn forget(&mut self, facts: usize, scope: usize) {
        for fact in self.facts.drain(facts..) {
            self.labels.remove(&fact.label);
        }
        self.scope.truncate(scope);
    }

    fn declare_binding(&mut self, binding: &Binding) -> Result<(), Refusal> {
        for (name, index) in &binding.names {
            if index.is_none() {
                self.declare(&name.text, binding.natural, Atom::Variable(name.text.clone()))?;
            }
        }
        Ok(())
    }

    /// Brings a name into scope, which must be new.
    fn declare(&mut self, name: &str, natural: bool, atom: Atom) -> Result<(), Refusal> {
        if self.is_declared(name) {
            return rejected(Reason::NameInUse(name.to_string()));
        }
        // Variables come before what is made of them, in the order in which they are declared. How a difference is written,
        // x - y or -(y - x), then does not depend on what was asked before.
        self.intern(atom.clone());
        self.scope.push(Variable { name: name.to_string(), natural, atom });
        if self.scope.len() > NAMES_LIMIT { Err(Refusal::Limit("names")) } else { Ok(()) }
    }

    fn is_declared(&self, name: &str) -> bool {
        self.scope.iter().any(|v| v.name == name) || self.is_member(name)
    }

    /// Whether a name is that of a family or sequence.
    fn is_member(&self, name: &str) -> bool {
        self.family(name).is_some() || self.is_sequence(name)
    }

    fn is_sequence(&self, name: &str) -> bool {
        self.statement.sequences.iter().any(|s| s.name == name)
    }

    /// The declaration of a family. Families are declared by the claim only, never in a block.
    fn family(&self, name: &str) -> Option<&Binding> {
        let is_family = |b: &&Binding| b.names.iter().any(|n| n.1.is_some() && n.0.text == name);
        self.statement.bindings.iter().find(is_family)
    }
}

/// The labels at these places.
fn cited(places: BTreeSet<usize>, labels: &[Label]) -> impl Iterator<Item = Label> {
    places.into_iter().filter_map(|place| labels.get(place).cloned())
}

/// A walk over the trees of a step that ends at the limits of depth and size; after it recursion is safe.
fn well_formed(show: &Show) -> Result<(), Refusal> {
    let walk = Substitution::default();
    walk.prop(&show.prop)?;
    let mut exprs: Vec<&Expr> = Vec::new();
    exprs.extend(show.rule.values().iter().map(|w| &w.1));
    if let Rule::Combination { times, terms } = &show.rule {
        exprs.extend(times.iter().chain(terms.iter().map(|t| &t.factor)));
    }
    for e in exprs {
        walk.expr(e)?;
    }
    Ok(())
}

/// An expression with one name in place of another. The new name must not occur yet: it would be taken for the old one.
fn renamed(e: &Expr, old: &str, new: &str) -> Result<Expr, Refusal> {
    let mut names = BTreeSet::new();
    names_in(e, &mut names);
    if old != new && names.contains(new) {
        return rejected(Reason::NameInUse(new.to_string()));
    }
    let mut map = Substitution::default();
    map.replace(old, &statement::name(new));
    map.expr(e)
}

/// The parts of an expression.
fn parts(e: &Expr) -> Vec<&Expr> {
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => Vec::new(),
        ExprKind::Apply(_, arguments) => arguments.iter().collect(),
        ExprKind::Negate(a) | ExprKind::Derivative(a, _) => vec![a],
        ExprKind::Sum(list) => list.iter().map(|(_, e)| e).collect(),
        ExprKind::Product(list) => list.iter().map(|(_, e)| e).collect(),
        ExprKind::Power(a, b) => vec![a, b],
        ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => vec![&index.from, &index.to, body],
        ExprKind::Matrix(rows) => rows.iter().flatten().collect(),
    }
}

/// Whether a proposition is a conjunction, whose parts are facts where it is one.
fn conjuncts(p: &Prop) -> Vec<&Prop> {
    match &p.kind {
        PropKind::And(list) => list.iter().flat_map(conjuncts).collect(),
        _ => vec![p],
    }
}
