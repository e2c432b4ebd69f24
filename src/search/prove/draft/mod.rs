//! The working memory of the search: the facts known so far, as steps from which a certificate can be written.
//!
//! Nothing here is trusted. A draft says which steps seem right, so that the search can build on them. The kernel decides
//! after `elaborate` has written them as a certificate. A bug here can lose a proof, but cannot make a false one.
//!
//! A draft keeps more than a certificate can cite: a table of signs, introduced powers, and replacements valid from some
//! step on. `marks` records where each of them comes from, and `elaborate` writes it out.

mod analysis;
mod derivative;
mod logic;
pub(crate) mod marks;
mod matrix;
mod order;
mod step;
pub(crate) mod translate;

pub(super) use logic::negation;
pub(super) use step::{Rule, Step};

use crate::claim::substitution::Obstacle;
use crate::claim::syntax::{Binding, Claim, Prop, PropKind};
use crate::kernel::fraction::{self, Fraction, Work};
use crate::kernel::statement::{self, Statement};
use crate::kernel::{Accepted, Refusal, text};
use marks::{Source, Sources};
use order::Note;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use translate::Atom;

/// The most steps of a certificate.
pub(crate) const STEPS_LIMIT: usize = 20_000;
/// The most names that a statement declares, and that are in scope at once.
pub(crate) const NAMES_LIMIT: usize = 1_000;

/// Why a step was not taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The step is not justified.
    Rejected(String),
    /// A limit was reached.
    Declined(&'static str),
}

/// A rejection.
pub(super) fn rejected<T>(reason: &str) -> Result<T, Failure> {
    Err(Failure::Rejected(reason.to_string()))
}

/// A limit.
pub(crate) fn declined<T>(limit: &'static str) -> Result<T, Failure> {
    Err(Failure::Declined(limit))
}

impl From<Obstacle> for Failure {
    fn from(obstacle: Obstacle) -> Failure {
        Refusal::from(obstacle).into()
    }
}

impl From<Refusal> for Failure {
    fn from(refusal: Refusal) -> Failure {
        match refusal {
            Refusal::Rejected(reason) => Failure::Rejected(reason.to_string()),
            Refusal::Limit(limit) => Failure::Declined(limit),
        }
    }
}

/// Something that seems known.
#[derive(Clone, Debug)]
pub(super) struct Fact {
    label: String,
    prop: Rc<Prop>,
    /// The same as text: facts are compared by it.
    key: String,
    source: Source,
}

impl Fact {
    /// Its label.
    pub(super) fn label(&self) -> &str {
        &self.label
    }

    /// What holds.
    pub(super) fn prop(&self) -> &Rc<Prop> {
        &self.prop
    }

    /// What holds, as the kernel writes it.
    pub(super) fn key(&self) -> &str {
        &self.key
    }

    /// From where it is known.
    pub(super) fn source(&self) -> Source {
        self.source
    }
}

/// A variable in scope.
#[derive(Clone, Debug)]
pub(super) struct Variable {
    name: String,
    natural: bool,
    /// What says so; the index of a sum or product needs nothing.
    source: Option<Source>,
}

impl Variable {
    /// Its name.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// Whether it is a natural number.
    pub(crate) fn is_natural(&self) -> bool {
        self.natural
    }
}

/// A family of the claim.
struct Family<'s> {
    binding: &'s Binding,
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
pub(crate) const DRAFT_LIMIT: u64 = 200 * fraction::WORK_LIMIT;

/// A block that is open, with what is forgotten at its end.
#[derive(Clone, Debug)]
struct Block {
    label: String,
    goal: Prop,
    kept: [usize; 5],
    source: Source,
}

/// What is known so far.
#[derive(Clone)]
pub(super) struct Draft {
    statement: Rc<Statement>,
    cited: Rc<Vec<Accepted>>,
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
    /// What was consulted since the last step.
    used: RefCell<Sources>,
    /// From where that is known which is noted now.
    now: Source,
    work: Work,
    /// The work of all attempts, those that failed and were forgotten among them.
    total: Rc<Cell<u64>>,
}

impl Draft {
    /// The state before the first step: the hypotheses are the facts `h1`, `h2`, …
    ///
    /// # Errors
    /// The statement makes no sense, or is beyond a limit.
    pub(super) fn new(claim: &Claim, cited: &[&Accepted]) -> Result<Draft, Failure> {
        let statement = Statement::of(claim)?;
        if statement.bindings.iter().map(|b| b.names.len()).sum::<usize>() + statement.sequences.len() > NAMES_LIMIT {
            return declined("names");
        }
        let allowed: BTreeSet<&str> = claim.using.iter().map(|n| n.text.as_str()).collect();
        let cited =
            cited.iter().filter(|a| allowed.contains(a.statement().name.as_str())).map(|a| (*a).clone()).collect();
        let mut checker = Draft {
            statement: Rc::new(statement),
            cited: Rc::new(cited),
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
            used: RefCell::default(),
            now: Source::Hypothesis(0),
            work: Work::default(),
            total: Rc::default(),
        };
        let statement = checker.statement.clone();
        for (place, binding) in statement.bindings.iter().enumerate() {
            checker.declare(binding, Source::Binding(place))?;
        }
        // A sequence speaks of what the claim declares, never of a variable that a block introduces later, nor of
        // a sequence that is defined after it; and of itself only by the member before.
        for (place, u) in statement.sequences.iter().enumerate() {
            let mut names = BTreeSet::new();
            crate::kernel::names::names_in(&u.step, &mut names);
            names.remove(&u.index);
            crate::kernel::names::names_in(&u.initial, &mut names);
            let known = |n: &String| checker.is_declared(n) || translate::FUNCTIONS.contains(&n.as_str());
            if let Some(free) = names.iter().find(|n| !known(n)) {
                return rejected(&format!("{free} in the sequence {} is not declared", u.name));
            }
            let later = statement.sequences.iter().skip(place + 1).any(|v| names.contains(&v.name));
            let mut first = BTreeSet::new();
            crate::kernel::names::names_in(&u.initial, &mut first);
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
            let of_member = |failure| match failure {
                Failure::Rejected(because) => Failure::Rejected(format!("in the sequence {} {because}", u.name)),
                limit => limit,
            };
            checker.scalar(&u.initial).map_err(of_member)?;
            checker.step_has_a_value(&u.index, &u.step).map_err(of_member)?;
        }
        Ok(checker)
    }

    /// The statement that is to be shown.
    pub(super) fn statement(&self) -> &Statement {
        &self.statement
    }

    /// The statement of a claim that may be cited.
    pub(crate) fn cited_statement(&self, name: &str) -> Option<Statement> {
        self.cited.iter().find(|a| a.statement().name == name).map(|a| a.statement().clone())
    }

    /// The facts that are known now, those of open blocks among them.
    pub(super) fn facts(&self) -> &[Fact] {
        &self.facts
    }

    /// The variables in scope.
    pub(super) fn variables(&self) -> &[Variable] {
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
    pub(super) fn step(&mut self, step: &Step) -> Result<Sources, Failure> {
        self.total.set(self.total.get().saturating_add(self.work.done()));
        if self.total.get() > DRAFT_LIMIT {
            return declined("work of a search");
        }
        self.work = Work::default();
        self.used = RefCell::default();
        self.now = Source::Step(self.taken);
        self.take(step)?;
        self.taken += 1;
        let used = self.used.take();
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
            return rejected("a field is missing, or does not belong to this rule");
        }
        // A walk that ends at the limits of depth and size; after it recursion is safe.
        let walk = crate::kernel::substitution::Substitution::default();
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
    pub(super) fn fact(&self, label: &str) -> Result<Rc<Prop>, Failure> {
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
    pub(super) fn knows(&self, prop: &Prop) -> bool {
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
        let is_family = |b: &Binding| b.names.iter().any(|n| n.0.text == name && n.1.is_some());
        let (place, binding) = self.statement.bindings.iter().enumerate().find(|(_, b)| is_family(b))?;
        Some(Family { binding, source: Source::Binding(place) })
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
