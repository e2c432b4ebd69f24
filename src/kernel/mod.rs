//! The kernel: certificates re-checked with nothing but the claim, ring arithmetic and one lemma.
//!
//! Contract: [`Checker::finish`] returns [`Accepted`] only if the claim's goal holds, with a value for
//! every expression in it, at every point that its hypotheses allow. The prover is not asked.
//!
//! **What a fact is.** The kernel keeps a list of facts. At every point that satisfies the hypotheses
//! and the suppositions of the open blocks, each fact is true and every expression in it has a value.
//! A rule adds a fact only if that stays so; above each rule stands why. A block ends by turning its
//! last fact into an implication or a statement `for all`, and everything else in it is forgotten.
//!
//! **What is assumed.** The field and order of the reals; x ↦ exp x and its inverse ln on positive
//! numbers, with b^E = exp(E·ln b); derivatives of these; induction; and one inequality, the weighted
//! mean of two values ([`analysis`]). An acceptance says whether it rests on that.
//!
//! The kernel imports the syntax tree, the certificate as data, num-bigint and num-rational. Nothing
//! is searched: a step that lacks a hint is rejected. Work, depth and size have limits; reaching one
//! is not a rejection but [`Verdict::Declined`].

pub mod analysis;
pub mod fraction;
pub mod logic;
pub mod marks;
pub mod order;
pub mod statement;
pub mod text;
pub mod translate;

use crate::certificate::{Certificate, Rule, Step};
use crate::claim::syntax::{Binding, Claim, Prop, PropKind};
use fraction::{Fraction, Work};
use marks::{Source, Sources};
use order::Note;
use statement::Statement;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use translate::Atom;

/// The most steps of a certificate.
pub const STEPS_LIMIT: usize = 20_000;
/// The most names that a statement declares, and that are in scope at once.
pub const NAMES_LIMIT: usize = 1_000;

/// Why a step was not taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The step is not justified.
    Rejected(String),
    /// A limit was reached.
    Declined(&'static str),
}

/// A rejection.
pub fn rejected<T>(reason: &str) -> Result<T, Failure> {
    Err(Failure::Rejected(reason.to_string()))
}

/// A limit.
pub fn declined<T>(limit: &'static str) -> Result<T, Failure> {
    Err(Failure::Declined(limit))
}

/// A claim that was shown. Only the kernel makes one.
#[derive(Clone, Debug)]
pub struct Accepted {
    statement: Statement,
    rests_on: BTreeSet<String>,
    needed: BTreeSet<Source>,
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

    /// The hypotheses that the proof needs, and the steps, by their places in the certificate.
    pub fn needed(&self) -> &BTreeSet<Source> {
        &self.needed
    }
}

/// What the kernel says of a certificate.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// The claim is shown.
    Accepted(Box<Accepted>),
    /// It is not, by this certificate.
    Rejected {
        /// The first bad step, by label.
        step: String,
        /// Its rule.
        rule: &'static str,
        /// What is wrong.
        reason: String,
    },
    /// A limit was reached.
    Declined {
        /// Its name.
        limit: &'static str,
    },
}

/// Checks a certificate of a claim; `cited` holds what was accepted of the claims under `using`.
pub fn check(claim: &Claim, certificate: &Certificate, cited: &[&Accepted]) -> Verdict {
    let verdict = |step: &str, rule, failure| match failure {
        Failure::Rejected(reason) => Verdict::Rejected { step: step.to_string(), rule, reason },
        Failure::Declined(limit) => Verdict::Declined { limit },
    };
    let mut checker = match Checker::new(claim, cited) {
        Ok(checker) => checker,
        Err(failure) => return verdict("", "statement", failure),
    };
    if certificate.claim != claim.name.text {
        return verdict("", "statement", Failure::Rejected("the certificate is of another claim".to_string()));
    }
    for step in &certificate.steps {
        if let Err(failure) = checker.step(step) {
            return verdict(&step.label, step.rule.name(), failure);
        }
    }
    match checker.finish() {
        Ok(accepted) => Verdict::Accepted(Box::new(accepted)),
        Err(failure) => verdict("", "qed", failure),
    }
}

/// Something known. Only the kernel makes one.
#[derive(Clone, Debug)]
pub struct Fact {
    label: String,
    prop: Rc<Prop>,
    /// The same as text: facts are compared by it.
    key: String,
    source: Source,
}

impl Fact {
    /// Its label.
    pub fn label(&self) -> &str {
        &self.label
    }

    /// What holds.
    pub fn prop(&self) -> &Rc<Prop> {
        &self.prop
    }

    /// What holds, as the kernel writes it.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// From where it is known.
    pub fn source(&self) -> Source {
        self.source
    }
}

/// A variable in scope.
#[derive(Clone, Debug)]
pub struct Variable {
    name: String,
    natural: bool,
    /// What says so; the index of a sum or product needs nothing.
    source: Option<Source>,
}

impl Variable {
    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether it is a natural number.
    pub fn is_natural(&self) -> bool {
        self.natural
    }
}

/// A family of the claim.
struct Family<'s> {
    binding: &'s Binding,
    index: &'s str,
    source: Source,
}

/// exp of `log` is `value`, as a step of rule `power` has shown.
#[derive(Clone, Debug)]
struct Power {
    log: Fraction,
    value: Fraction,
    source: Source,
}

/// An atom that is written as something else; that an index stands for itself needs no step.
#[derive(Clone, Debug)]
struct Replaced {
    atom: usize,
    value: Fraction,
    source: Option<Source>,
}

/// The most work in all attempts of one search for a certificate.
pub const DRAFT_LIMIT: u64 = 200 * fraction::WORK_LIMIT;

/// How much work is allowed.
#[derive(Clone)]
enum Budget {
    /// [`fraction::WORK_LIMIT`] for the whole check.
    Whole,
    /// As much for each step of a draft, and [`DRAFT_LIMIT`] for all, those of failed attempts among them.
    EachStep(Rc<Cell<u64>>),
}

/// A block that is open, with what is forgotten at its end.
#[derive(Clone, Debug)]
struct Block {
    label: String,
    goal: Prop,
    kept: [usize; 5],
    source: Source,
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
/// assert!(checker.facts().is_empty());
/// assert!(checker.finish().is_err());
/// ```
///
/// Nor can the goal be slipped in among them:
///
/// ```compile_fail,E0616
/// use carom::{claim::parse::parse, kernel::Checker};
/// let claims = parse("claim false \"x = x + 1\"\ngiven x real\nprove x = x + 1\n").unwrap_or_default();
/// let Ok(mut checker) = Checker::new(&claims[0], &[]) else { panic!("no checker") };
/// let mut fact = checker.facts()[0].clone();
/// fact.prop = std::rc::Rc::new(claims[0].goal.clone());
/// checker.facts.push(fact);
/// assert!(checker.finish().is_ok());
/// ```
///
/// Nor can a fact be made from nothing, nor the count of work be set back:
///
/// ```compile_fail,E0451
/// use carom::{claim::parse::parse_prop, kernel::Fact};
/// let prop = std::rc::Rc::new(parse_prop("x = x + 1").unwrap_or_else(|_| unreachable!()));
/// let fact = Fact { label: String::new(), prop, key: String::new(), source: unreachable!() };
/// ```
///
/// ```compile_fail,E0616
/// use carom::kernel::{Checker, fraction::Work};
/// fn again(checker: &mut Checker) {
///     checker.work = Work::default();
/// }
/// ```
#[derive(Clone)]
pub struct Checker {
    statement: Rc<Statement>,
    cited: Rc<Vec<Accepted>>,
    rests_on: BTreeSet<String>,
    facts: Vec<Fact>,
    blocks: Vec<Block>,
    variables: Vec<Variable>,
    atoms: Vec<Atom>,
    atom_index: BTreeMap<Atom, usize>,
    /// Polynomials of known signs.
    signs: Vec<Note>,
    powers: Vec<Power>,
    replaced: Vec<Replaced>,
    /// How many indices of sums and products are in scope.
    binders: usize,
    /// How many steps were tried.
    steps: usize,
    /// How many were taken.
    taken: usize,
    /// What the steps that were taken used; a draft keeps no record.
    trail: Vec<Sources>,
    /// What was consulted since the last step.
    used: RefCell<Sources>,
    /// From where that is known which is noted now.
    now: Source,
    work: Work,
    budget: Budget,
}

impl Checker {
    /// The state before the first step: the hypotheses are the facts `h1`, `h2`, …
    pub fn new(claim: &Claim, cited: &[&Accepted]) -> Result<Checker, Failure> {
        Checker::within(claim, cited, Budget::Whole)
    }

    /// The same for a search, which tries many steps: each has a budget of its own, and nothing is accepted in the end.
    /// What was found is written down, and checked from nothing.
    pub fn draft(claim: &Claim, cited: &[&Accepted]) -> Result<Checker, Failure> {
        Checker::within(claim, cited, Budget::EachStep(Rc::default()))
    }

    fn within(claim: &Claim, cited: &[&Accepted], budget: Budget) -> Result<Checker, Failure> {
        let statement = Statement::of(claim)?;
        if statement.bindings.iter().map(|b| b.names.len()).sum::<usize>() + statement.sequences.len() > NAMES_LIMIT {
            return declined("names");
        }
        let allowed: BTreeSet<&str> = claim.using.iter().map(|n| n.text.as_str()).collect();
        let cited =
            cited.iter().filter(|a| allowed.contains(a.statement.name.as_str())).map(|a| (*a).clone()).collect();
        let mut checker = Checker {
            statement: Rc::new(statement),
            cited: Rc::new(cited),
            rests_on: BTreeSet::new(),
            facts: Vec::new(),
            blocks: Vec::new(),
            variables: Vec::new(),
            atoms: Vec::new(),
            atom_index: BTreeMap::new(),
            signs: Vec::new(),
            powers: Vec::new(),
            replaced: Vec::new(),
            binders: 0,
            steps: 0,
            taken: 0,
            trail: Vec::new(),
            used: RefCell::default(),
            now: Source::Hypothesis(0),
            work: Work::default(),
            budget,
        };
        let statement = checker.statement.clone();
        for (place, binding) in statement.bindings.iter().enumerate() {
            checker.declare(binding, Source::Binding(place))?;
        }
        // A sequence speaks of what the claim declares, never of a variable that a block introduces later, nor of
        // a sequence that is defined after it; and of itself only by the member before.
        for (place, u) in statement.sequences.iter().enumerate() {
            let mut names = BTreeSet::new();
            statement::names_in(&u.step, &mut names);
            names.remove(&u.index);
            statement::names_in(&u.initial, &mut names);
            let known = |n: &String| checker.is_declared(n) || translate::FUNCTIONS.contains(&n.as_str());
            if let Some(free) = names.iter().find(|n| !known(n)) {
                return rejected(&format!("{free} in the sequence {} is not declared", u.name));
            }
            let later = statement.sequences.iter().skip(place + 1).any(|v| names.contains(&v.name));
            let mut first = BTreeSet::new();
            statement::names_in(&u.initial, &mut first);
            if later || first.contains(&u.name) || !statement::steps_once(&u.step, &u.name, &u.index) {
                return rejected(&format!("the sequence {} is not defined by the member before", u.name));
            }
        }
        let domains = statement.bindings.iter().flat_map(statement::domain);
        for prop in domains.chain(statement.assumptions.iter().cloned()) {
            let label = format!("h{}", checker.facts.len() + 1);
            checker.now = Source::Hypothesis(checker.facts.len());
            checker.know(&label, prop)?;
        }
        // Every member has a value, so that a member is one wherever its index is a natural number.
        for u in &statement.sequences {
            checker.scalar(&u.initial)?;
            checker.step_has_a_value(&u.index, &u.step)?;
        }
        Ok(checker)
    }

    /// The statement that is to be shown.
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// The statement of a claim that may be cited.
    pub fn cited_statement(&self, name: &str) -> Option<Statement> {
        self.cited.iter().find(|a| a.statement.name == name).map(|a| a.statement.clone())
    }

    /// The facts that are known now, those of open blocks among them.
    pub fn facts(&self) -> &[Fact] {
        &self.facts
    }

    /// The variables in scope.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    fn variable(&self, name: &str) -> Option<&Variable> {
        self.variables.iter().find(|v| v.name == name)
    }

    /// Notes that something was consulted.
    fn consult(&self, source: Source) {
        self.used.borrow_mut().add(source);
    }

    fn consult_all(&self, sources: &Sources) {
        self.used.borrow_mut().extend(sources);
    }

    /// Takes one step and says what it used, or says why not; then nothing is changed but the list of atoms.
    pub fn step(&mut self, step: &Step) -> Result<Sources, Failure> {
        if let Budget::EachStep(total) = &self.budget {
            total.set(total.get().saturating_add(self.work.done()));
            if total.get() > DRAFT_LIMIT {
                return declined("work of a search");
            }
            self.work = Work::default();
        }
        self.used = RefCell::default();
        self.now = Source::Step(self.taken);
        self.take(step)?;
        self.taken += 1;
        let used = self.used.take();
        if let Budget::Whole = self.budget {
            self.trail.push(used.clone());
        }
        Ok(used)
    }

    fn take(&mut self, step: &Step) -> Result<(), Failure> {
        self.steps += 1;
        if self.steps > STEPS_LIMIT {
            return declined("steps");
        }
        // Labels are sought among all that are in use.
        self.work.count(self.facts.len() + self.blocks.len())?;
        self.fields(step)?;
        let (kept, blocks) = (self.sizes(), self.blocks.len());
        let result = match step.rule {
            Rule::Power => self.power(step),
            Rule::Logarithm => self.logarithm(step),
            Rule::Replace => self.replace(step),
            Rule::Unfold => self.unfold(step),
            Rule::Member => self.member(step),
            Rule::Note => self.note(step),
            Rule::Sign => self.sign(step),
            Rule::Combination => self.combination(step),
            Rule::Suppose => self.suppose(step),
            Rule::Let => self.let_values(step),
            Rule::End => return self.end(),
            Rule::All => self.all(step),
            Rule::Part => self.part(step),
            Rule::Either => self.either(step),
            Rule::Excluded => self.excluded(step),
            Rule::Cases => self.cases(step),
            Rule::Apply => self.apply(step),
            Rule::Equivalent => self.equivalent(step),
            Rule::Negation => self.negation(step),
            Rule::Absurd => self.absurd(step),
            Rule::Instance => self.instance(step),
            Rule::Induction => self.induction(step),
            Rule::Witness => self.witness(step),
            Rule::Monotone => self.monotone(step),
            Rule::Mean => self.mean(step),
            Rule::Extremum => self.extremum(step),
            Rule::Limit => self.limit(step),
            Rule::Squeeze => self.squeeze(step),
        };
        if result.is_err() {
            self.blocks.truncate(blocks);
            self.forget(kept);
        }
        result
    }

    /// Whether the goal is shown.
    pub fn finish(self) -> Result<Accepted, Failure> {
        if let Budget::EachStep(_) = self.budget {
            return rejected("a draft is not accepted: its steps are written down and checked from nothing");
        }
        if !self.blocks.is_empty() {
            return rejected("a block is open at the end");
        }
        self.work.count(0)?;
        let Some(goal) = self.find(&self.statement.goal) else { return rejected("the goal is not among the facts") };
        let needed = marks::needed(&self.trail, goal.source);
        Ok(Accepted { needed, statement: (*self.statement).clone(), rests_on: self.rests_on })
    }

    /// A step has the fields that its rule reads and no others.
    fn fields(&self, step: &Step) -> Result<(), Failure> {
        let from = match step.rule {
            Rule::Note | Rule::Replace | Rule::Part | Rule::Cases | Rule::Apply | Rule::Monotone | Rule::Absurd => 1,
            Rule::Negation | Rule::Instance => 1,
            _ => 0,
        };
        let with = matches!(step.rule, Rule::Instance | Rule::Witness | Rule::Monotone | Rule::Mean | Rule::Squeeze);
        let combination = step.rule == Rule::Combination;
        let prop = !matches!(step.rule, Rule::Note | Rule::Replace | Rule::End);
        let label = step.rule != Rule::End;
        let used =
            self.facts.iter().any(|f| f.label == step.label) || self.blocks.iter().any(|b| b.label == step.label);
        if step.from.len() != from
            || step.prop.is_some() != prop
            || (!with && !step.with.is_empty())
            || (step.times.is_some() && !combination)
            || (!step.terms.is_empty() && !combination)
            || step.label.is_empty() == label
        {
            return rejected("a field is missing, or is not one of this rule");
        }
        // A walk that ends at the limits of depth and size; after it recursion is safe.
        let walk = statement::Substitution::default();
        step.prop.as_ref().map_or(Ok(()), |p| walk.prop(p).map(|_| ()))?;
        let terms = step.terms.iter().map(|t| &t.factor);
        for e in step.with.iter().map(|w| &w.1).chain(&step.times).chain(terms) {
            walk.expr(e)?;
        }
        if used { rejected("the label is in use") } else { Ok(()) }
    }

    /// What a step shows; `fields` has seen that it is there.
    fn shown(step: &Step) -> Result<&Prop, Failure> {
        step.prop.as_ref().ok_or(Failure::Rejected("a step that shows nothing".to_string()))
    }

    /// The fact that a step cites.
    fn cited_fact(&self, step: &Step) -> Result<Rc<Prop>, Failure> {
        self.fact(step.from.first().map_or("", String::as_str))
    }

    /// A fact by label.
    pub fn fact(&self, label: &str) -> Result<Rc<Prop>, Failure> {
        match self.facts.iter().find(|f| f.label == label) {
            Some(fact) => {
                self.work.count(fact.key.len())?;
                self.consult(fact.source);
                Ok(fact.prop.clone())
            }
            None => rejected(&format!("there is no fact {label}")),
        }
    }

    /// Whether this very proposition is a fact.
    pub fn knows(&self, prop: &Prop) -> bool {
        self.find(prop).is_some()
    }

    /// The fact that says this, the first if there are several.
    fn find(&self, prop: &Prop) -> Option<&Fact> {
        let key = text::prop(prop);
        self.work.spend(key.len() + self.facts.len());
        let found = self.facts.iter().find(|f| f.key == key);
        found.iter().for_each(|fact| self.consult(fact.source));
        found
    }

    /// A fact that a rule needs must be known word for word.
    fn need(&self, prop: &Prop) -> Result<(), Failure> {
        let known = self.knows(prop);
        self.work.count(0)?;
        if known { Ok(()) } else { rejected(&format!("needs {}", text::prop(prop))) }
    }

    /// Adds a fact; the sign of what it compares is noted where it can be translated.
    fn know(&mut self, label: &str, prop: Prop) -> Result<(), Failure> {
        if let PropKind::Compare(..) = &prop.kind {
            // What the note needs is needed where the note is, not for the step.
            let used = self.used.take();
            let noted = self.note_comparison(&prop, false);
            self.used = RefCell::new(used);
            match noted {
                Ok(()) | Err(Failure::Rejected(_)) => {}
                Err(limit) => return Err(limit),
            }
        }
        let key = text::prop(&prop);
        self.facts.push(Fact { label: label.to_string(), prop: Rc::new(prop), key, source: self.now });
        Ok(())
    }

    fn declare(&mut self, binding: &Binding, source: Source) -> Result<(), Failure> {
        for (name, index) in &binding.names {
            if index.is_none() {
                if self.is_declared(&name.text) {
                    return rejected(&format!("the name {} is in use", name.text));
                }
                let name = name.text.clone();
                self.variables.push(Variable { name, natural: binding.natural, source: Some(source) });
            }
        }
        if self.variables.len() > NAMES_LIMIT { declined("names") } else { Ok(()) }
    }

    fn is_declared(&self, name: &str) -> bool {
        self.variable(name).is_some() || self.is_family(name)
    }

    fn is_family(&self, name: &str) -> bool {
        self.family(name).is_some() || self.statement.sequences.iter().any(|s| s.name == name)
    }

    fn family(&self, name: &str) -> Option<Family<'_>> {
        // Families are declared by the claim only, never in a block.
        let index_in = |b: &'_ Binding| b.names.iter().position(|n| n.0.text == name && n.1.is_some());
        let (place, binding) = self.statement.bindings.iter().enumerate().find(|(_, b)| index_in(b).is_some())?;
        let index = binding.names.get(index_in(binding)?)?.1.as_ref()?;
        Some(Family { binding, index: &index.text, source: Source::Binding(place) })
    }

    fn sizes(&self) -> [usize; 5] {
        [self.facts.len(), self.variables.len(), self.signs.len(), self.powers.len(), self.replaced.len()]
    }

    fn forget(&mut self, kept: [usize; 5]) {
        let [facts, variables, signs, powers, replaced] = kept;
        self.facts.truncate(facts);
        self.variables.truncate(variables);
        self.signs.truncate(signs);
        self.powers.truncate(powers);
        self.replaced.truncate(replaced);
    }
}
