//! The kernel: checks a certificate step by step, each step from its own text and the facts that it cites.
//!
//! Contract: [`check`] returns [`Verdict::Accepted`] only if the claim's goal holds, with a value for every expression
//! in it, at every point that its hypotheses allow. The kernel trusts nothing that the search reports.
//!
//! **What a fact is.** A fact is true and has a value at every point that satisfies the hypotheses and the suppositions of the
//! open blocks (`logic` defines when a proposition has a value). A rule adds a fact only if it keeps this invariant; the comment
//! above each rule proves it. The end of a block turns its conclusion into an implication or a statement `for all`, and
//! removes all other facts of the block.
//!
//! **No hidden state.** Besides the facts the kernel keeps the names in scope. A step gets signs from the facts under `by` and
//! equations to put in from the facts under `using`, and from nothing else. No step changes the meaning of a later one.
//!
//! **What is assumed.** The axioms of the ordered field of reals; exp and its inverse ln on positive numbers, with
//! b^E = exp(E·ln b); cos and sin with their sums of angles, cos² + sin² = 1 and the least zero π of sin above 0; arcsin and
//! arctan as the inverses of sin and tan between −π/2 and π/2; their derivatives; limits by their definition; induction. Four theorems of analysis as well:
//! the inequality of the weighted means of two values, exp above its tangent (`analysis`), the mean value theorem (`slope`) and
//! the intermediate value theorem (`intermediate`).
//! [`Accepted::rests_on`] names those of the four that a proof uses.
//!
//! The kernel imports the syntax tree, the exact points of the unit circle, the certificate as data, num-bigint and num-rational. It
//! searches nothing.
//!
//! Work, depth and size have limits. A certificate that reaches one is not rejected: the verdict is [`Verdict::Declined`].

pub mod analysis;
pub mod arc;
mod arithmetic;
mod binder;
mod defined;
mod derivative;
pub(crate) mod enclosure;
mod evaluate;
mod eventually;
pub mod fraction;
mod hypotheses;
mod integral;
mod intermediate;
mod interval;
pub mod key;
mod known;
mod logic;
mod matrix;
mod memo;
pub mod names;
pub mod order;
mod over;
mod poly;
mod power;
mod quantifier;
mod reason;
pub mod refutation;
mod replace;
mod scope;
mod sign;
pub(crate) mod slope;
pub mod statement;
mod term;
pub mod text;
mod trail;
mod tree;
pub mod trigonometry;
mod value;
pub mod view;
mod well_formed;
pub mod words;

pub use crate::claim::substitution;
pub use quantifier::domains;
pub use reason::Reason;
pub use term::numeral;
pub use trail::Mark;
pub use well_formed::Shape;

use crate::certificate::{Certificate, Label, Refutes, Rule, Show, Step};
use crate::claim::definedness::TooLong;
use crate::claim::syntax::{Claim, Item, Prop};
use fraction::Work;
use known::Known;
use order::Signs;
use scope::Variable;
use statement::Statement;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::rc::Rc;
use term::Atom;

/// The most steps of a certificate.
pub(crate) const STEPS_LIMIT: usize = 50_000;
/// The most names that a statement declares, and that are in scope at once.
pub(crate) const NAMES_LIMIT: usize = 1_000;

/// Why a step was refused.
#[derive(Clone, Debug)]
pub enum Refusal {
    /// The step is not justified.
    Rejected(Reason),
    /// The named limit was reached.
    Limit(&'static str),
}

impl From<substitution::Obstacle> for Refusal {
    fn from(obstacle: substitution::Obstacle) -> Refusal {
        use substitution::Obstacle;
        match obstacle {
            Obstacle::Capture(name) => Refusal::Rejected(Reason::Capture(name)),
            Obstacle::Moves(name) => Refusal::Rejected(Reason::Moves(name)),
            Obstacle::NotAFunction(name) => Refusal::Rejected(Reason::NotAFunction(name)),
            Obstacle::Limit(limit) => Refusal::Limit(limit),
        }
    }
}

impl From<TooLong> for Refusal {
    fn from(_: TooLong) -> Refusal {
        Refusal::Limit(TooLong::LIMIT)
    }
}

fn rejected<T>(reason: Reason) -> Result<T, Refusal> {
    Err(Refusal::Rejected(reason))
}

/// A proved claim. Only the kernel makes one.
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

    /// The cited claims and theorems of analysis that the proof uses, those of the cited claims included.
    pub fn rests_on(&self) -> &BTreeSet<String> {
        &self.rests_on
    }

    /// The hypotheses that the proof uses although no step cites them. They are those by which members of sequences have values,
    /// and the domains of families that replace families of cited claims.
    pub fn assumed(&self) -> &BTreeSet<Label> {
        &self.assumed
    }
}

/// The kernel's verdict on a certificate.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// The certificate proves the claim.
    Accepted(Box<Accepted>),
    /// The certificate refutes the claim: it is false at the given point.
    Refuted,
    /// The certificate does neither.
    Rejected {
        /// The label of the first wrong step; empty for the statement and the end.
        step: Label,
        /// The rule of this step.
        rule: &'static str,
        /// What is wrong.
        reason: Reason,
    },
    /// A limit was reached.
    Declined {
        /// The name of the limit.
        limit: &'static str,
    },
}

/// Checks a certificate of a claim. `cited` holds the accepted claims among those under `using`.
pub fn check(claim: &Claim, certificate: &Certificate, cited: &[&Accepted]) -> Verdict {
    let verdict = |step: &str, rule, refusal| match refusal {
        Refusal::Rejected(reason) => Verdict::Rejected { step: step.to_string(), rule, reason },
        Refusal::Limit(limit) => Verdict::Declined { limit },
    };
    let checker = match &certificate.refutes {
        None => Checker::new(claim, cited),
        Some(refutes) => Checker::refuting(claim, refutes),
    };
    let mut checker = match checker {
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
        Ok(_) if certificate.refutes.is_some() => Verdict::Refuted,
        Ok(accepted) => Verdict::Accepted(Box::new(accepted)),
        Err(refusal) => verdict("", "qed", refusal),
    }
}

/// The facts that a step needs besides those that its rule cites.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Used {
    /// Those of the facts under `by`.
    pub by: Vec<Label>,
    /// Those of the equations under `using`.
    pub using: Vec<Label>,
}

/// A fact with its label.
#[derive(Clone, Debug)]
struct Fact {
    label: Label,
    prop: Rc<Prop>,
    /// What it is compared by ([`key::prop`]); its length is the work of a step that cites the fact.
    key: Rc<str>,
}

/// An open block, with the number of facts and names that remain after its end.
#[derive(Clone, Debug)]
struct Block {
    label: Label,
    goal: Prop,
    facts: usize,
    scope: usize,
}

/// The state of a check.
///
/// A caller can read its facts and take steps. No code outside the kernel can make a fact, reset the budget of work or make an
/// [`Accepted`]. This claim is false; its goal is not a fact, and `finish` returns an error:
///
/// ```
/// use carom_checker::{claim::parse::parse, kernel::Checker};
/// let claims = parse("claim false \"x = x + 1\"\ngiven x real\nprove x = x + 1\n").unwrap_or_default();
/// let Ok(checker) = Checker::new(&claims[0], &[]) else { panic!("no checker") };
/// assert_eq!(checker.facts().count(), 0);
/// assert!(checker.finish().is_err());
/// ```
///
/// Code outside the kernel cannot add the goal to the facts, nor reset the budget:
///
/// ```compile_fail,E0616
/// use carom_checker::{claim::syntax::Prop, kernel::Checker};
/// fn forge(checker: &mut Checker, goal: Prop) {
///     checker.facts.push(std::rc::Rc::new(goal).into());
/// }
/// ```
///
/// ```compile_fail,E0624
/// use carom_checker::{claim::syntax::Prop, kernel::Checker};
/// fn forge(checker: &mut Checker, goal: Prop) {
///     let _ = checker.know("1", goal);
/// }
/// ```
///
/// ```compile_fail,E0616
/// use carom_checker::kernel::{Checker, fraction::Work};
/// fn again(checker: &mut Checker) {
///     checker.work = Work::default();
/// }
/// ```
///
/// Nor can it make an acceptance:
///
/// ```compile_fail,E0451
/// use carom_checker::kernel::{Accepted, statement::Statement};
/// fn forge(statement: Statement) -> Accepted {
///     Accepted { statement, rests_on: Default::default(), assumed: Default::default() }
/// }
/// ```
#[derive(Clone)]
pub struct Checker {
    statement: Rc<Statement>,
    cited: Rc<Vec<Accepted>>,
    rests_on: BTreeSet<String>,
    /// The hypotheses that are used without being cited ([`Accepted::assumed`]).
    assumed: BTreeSet<Label>,
    /// The signs that all members of a sequence have.
    signs_of_members: BTreeMap<String, Signs>,
    facts: Vec<Fact>,
    /// The places of the facts by label.
    labels: HashMap<Label, usize>,
    blocks: Vec<Block>,
    scope: Vec<Variable>,
    atoms: Vec<Atom>,
    atom_index: BTreeMap<Atom, usize>,
    /// For each atom those that occur in it at any depth, itself among them, in order.
    occurring: Vec<Vec<usize>>,
    /// For each atom the greatest number that is bound in it ([`binder`]), or 0.
    heights: Vec<usize>,
    /// Names in scope that a quantifier may bind again.
    again: BTreeSet<String>,
    /// The number of indices of sums and products in scope.
    binders: usize,
    /// The equations put in while an expression of a step is read; empty otherwise.
    put_in: Rc<Vec<known::Equation>>,
    /// The places of those that were put in.
    were_put_in: BTreeSet<usize>,
    memo: memo::Memo,
    steps: usize,
    work: Work,
}

impl Checker {
    /// The state before the first step: the domains and hypotheses are the facts `h1`, `h2`, …
    ///
    /// # Errors
    /// The kernel cannot read the statement, no text can say it, or it exceeds a limit.
    pub fn new(claim: &Claim, cited: &[&Accepted]) -> Result<Checker, Refusal> {
        well_formed::claim(claim)?;
        Checker::of(claim, cited, BTreeSet::new())
    }

    /// The state before the first step of a refutation: the equations that give the point are among its facts.
    ///
    /// The statement is [`refutation::of`] the claim. Variables that the goal binds are declared by it, and the hypotheses may
    /// bind them as before.
    ///
    /// # Errors
    /// As [`Checker::new`], or the point is none of the claim.
    pub fn refuting(claim: &Claim, refutes: &Refutes) -> Result<Checker, Refusal> {
        let shown = refutation::of(claim, refutes)?;
        let mut again = declared(&shown);
        declared(claim).iter().for_each(|name| {
            again.remove(name);
        });
        Checker::of(&shown, &[], again)
    }

    fn of(claim: &Claim, cited: &[&Accepted], again: BTreeSet<String>) -> Result<Checker, Refusal> {
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
            signs_of_members: BTreeMap::new(),
            facts: Vec::new(),
            labels: HashMap::new(),
            blocks: Vec::new(),
            scope: Vec::new(),
            atoms: Vec::new(),
            atom_index: BTreeMap::new(),
            occurring: Vec::new(),
            heights: Vec::new(),
            again,
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

    /// The statement to prove.
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// The statement of an accepted claim that is cited under `using`.
    pub fn cited_statement(&self, name: &str) -> Option<&Statement> {
        self.cited.iter().map(|accepted| &accepted.statement).find(|statement| statement.name == name)
    }

    /// Has somebody asked from time to time whether work may go on, or nobody.
    pub fn watched_by(&mut self, watch: Option<fraction::Watch>) {
        self.work.watched_by(watch);
    }

    /// The facts, with their labels.
    pub fn facts(&self) -> impl DoubleEndedIterator<Item = (&str, &Rc<Prop>)> {
        self.facts.iter().map(|fact| (fact.label.as_str(), &fact.prop))
    }

    /// The label of the last fact that says this, up to the names of bound variables.
    pub fn find(&self, p: &Prop) -> Option<&str> {
        let wanted = key::prop(p);
        self.facts.iter().rev().find(|fact| *fact.key == *wanted).map(|fact| fact.label.as_str())
    }

    /// The fact of this label.
    pub fn fact_of(&self, label: &str) -> Option<&Rc<Prop>> {
        self.labels.get(label).and_then(|place| self.facts.get(*place)).map(|fact| &fact.prop)
    }

    /// Whether a proposition is an equation that can be put in after the equations `after`: its left side is an atom, a power or
    /// an exponential.
    pub fn can_be_put_in(&mut self, p: &Prop, after: &[Label]) -> bool {
        self.known(&[], after).is_ok_and(|known| self.equation(p, &known).is_ok())
    }

    /// The difference of the sides of a single comparison, if it is a number once the equations are put in.
    ///
    /// # Errors
    /// A side cannot be read, or an equation cannot be put in.
    pub fn constant(&mut self, p: &Prop, using: &[Label]) -> Result<Option<num_rational::BigRational>, Refusal> {
        well_formed::prop(p)?;
        let known = self.known(&[], using)?;
        let (a, _, b) = tree::single(p)?;
        let difference = self.fraction_with(a, &known)?.minus(&self.fraction_with(b, &known)?, &self.work)?;
        Ok(difference.as_number().cloned())
    }

    /// Takes one step. A refused step adds no fact and opens or closes no block.
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
        well_formed::label(&show.label)?;
        self.well_formed(show)?;
        let (scope, binders) = (self.scope.len(), self.binders);
        let result = self.show(show);
        if result.is_err() {
            self.scope.truncate(scope);
            self.binders = binders;
        }
        result
    }

    /// The facts under `by` and the equations under `using` that a justified step needs. The state stays as it is. The search
    /// uses this to write short citations.
    ///
    /// # Errors
    /// The step is not justified, or a limit was reached.
    pub fn used(&mut self, show: &Show) -> Result<Used, Refusal> {
        self.well_formed(show)?;
        let (scope, binders, rests_on, assumed) =
            (self.scope.len(), self.binders, self.rests_on.clone(), self.assumed.clone());
        let spent = self.work.clone();
        let result = self.justified(show);
        self.work = spent;
        self.scope.truncate(scope);
        self.binders = binders;
        self.rests_on = rests_on;
        self.assumed = assumed;
        let (by, using) = result?;
        Ok(Used { by: cited(by, &show.by).collect(), using: cited(using, &show.using).collect() })
    }

    /// Checks that a text can say the trees of a step, and that its quantifiers take new names.
    fn well_formed(&self, show: &Show) -> Result<(), Refusal> {
        well_formed::step(show, &|name| self.is_declared(name) && !self.again.contains(name))
    }

    /// Checks that the rule of a step justifies it. Returns the places of the facts under `by` and `using` that it looked at.
    fn justified(&mut self, show: &Show) -> Result<(BTreeSet<usize>, BTreeSet<usize>), Refusal> {
        let mut known = self.known(&show.by, &show.using)?;
        let result = self.by_rule(show, &mut known);
        let used = known.used();
        self.memo.keep(known);
        result.map(|()| used)
    }

    fn by_rule(&mut self, show: &Show, known: &mut Known) -> Result<(), Refusal> {
        let goal = &show.prop;
        match &show.rule {
            Rule::Suppose => self.may_be_supposed(goal, known)?,
            Rule::Let => self.may_be_let(goal, known)?,
            Rule::Logic { from } => self.logic(goal, from, known)?,
            Rule::Instance { source, with, from } => self.instance(goal, source, with, from, known)?,
            Rule::Induction { base, advance } => self.induction(goal, base, advance)?,
            Rule::Existence { some, all } => self.existence(goal, some, all)?,
            Rule::Witness { with, from } => self.witness(goal, with, from, known)?,
            Rule::Extremum { from } => self.extremum(goal, from, known)?,
            Rule::Combination { times, terms } => self.combination(goal, times.as_ref(), terms, known)?,
            Rule::Power => self.power_rule(goal, known)?,
            Rule::Monotone { from } => self.monotone(goal, from, known)?,
            Rule::Unfold => self.unfold(goal, known)?,
            Rule::Termwise { from } => self.termwise(goal, from, known)?,
            Rule::Mean { with } => self.mean(goal, with, known)?,
            Rule::Tangent { with } => self.tangent(goal, with, known)?,
            Rule::Circle { with } => self.circle(goal, with, known)?,
            Rule::Arc => self.arc_rule(goal, known)?,
            Rule::Slope { source, with, from } => self.slope(goal, source, with, from, known)?,
            Rule::Intermediate { with, from } => self.intermediate(goal, with, from, known)?,
            Rule::Limit { with } => self.limit(goal, with, known)?,
            Rule::Squeeze { from } => self.squeeze(goal, from)?,
            Rule::Along { from } => self.along(goal, from)?,
            Rule::Eventually { from } => self.eventually(goal, from, known)?,
            Rule::Integer { from } => self.integer(goal, from, known)?,
            Rule::Name => self.name(goal, known)?,
            Rule::Evaluate => {
                self.evaluate(goal, &show.using)?;
                known.all_put_in(show.using.len());
            }
        }
        Ok(())
    }

    /// Takes a step that shows something: adds its fact, or opens its block.
    fn show(&mut self, show: &Show) -> Result<(), Refusal> {
        self.justified(show)?;
        match &show.rule {
            Rule::Suppose | Rule::Let => self.open(&show.label, &show.prop),
            _ => self.know(&show.label, show.prop.clone()),
        }
    }

    /// Ends the check.
    ///
    /// # Errors
    /// A block is open, or the last fact is not the goal.
    pub fn finish(self) -> Result<Accepted, Refusal> {
        if !self.blocks.is_empty() {
            return rejected(Reason::OpenBlock);
        }
        let goal = key::prop(&self.statement.goal);
        // The goal is what the last step shows.
        match self.facts.last() {
            Some(fact) if *fact.key == *goal => {
                Ok(Accepted { statement: (*self.statement).clone(), rests_on: self.rests_on, assumed: self.assumed })
            }
            _ => rejected(Reason::GoalNotShown),
        }
    }

    /// Refuses a label that is in use.
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
                self.work.count(fact.key.len())?;
                Ok(fact.prop.clone())
            }
            None => rejected(Reason::NoFact(label.to_string())),
        }
    }

    /// Adds a fact.
    fn know(&mut self, label: &str, prop: Prop) -> Result<(), Refusal> {
        self.fresh_label(label)?;
        let key: Rc<str> = key::prop(&prop).into();
        self.work.count(key.len())?;
        self.labels.insert(label.to_string(), self.facts.len());
        self.facts.push(Fact { label: label.to_string(), prop: Rc::new(prop), key });
        Ok(())
    }

    /// Removes the facts and names beyond these numbers.
    fn forget(&mut self, facts: usize, scope: usize) {
        for fact in self.facts.drain(facts..) {
            self.labels.remove(&fact.label);
        }
        self.scope.truncate(scope);
    }
}

/// The labels at these places.
fn cited(places: BTreeSet<usize>, labels: &[Label]) -> impl Iterator<Item = Label> {
    places.into_iter().filter_map(|place| labels.get(place).cloned())
}

/// The variables and families that a claim declares.
fn declared(claim: &Claim) -> BTreeSet<String> {
    let bindings = claim.items.iter().flat_map(|item| match item {
        Item::Given(bindings) => bindings.as_slice(),
        _ => &[],
    });
    bindings.flat_map(|binding| &binding.names).map(|name| name.0.text.clone()).collect()
}
