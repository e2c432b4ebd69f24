//! A second search, for claims that the draft cannot prove. It asks the kernel directly about every step.
//!
//! Contract: [`prove`] returns a certificate that the kernel accepted, or says what it could not prove. Nothing here is
//! trusted.
//!
//! Method: a goal is split at its connectives into comparisons. Every root, power, sum and member of a sequence is
//! treated as a variable, called a *letter*. Each fact becomes a polynomial in the letters that is 0, positive or not
//! negative. A linear program finds products of these polynomials that add up to the goal, or to a contradiction with
//! the goal's opposite (`products`). If that fails, the search distinguishes cases and tries induction.

mod absolute;
mod cases;
mod columns;
mod comparison;
mod compound;
mod divisibility;
mod exponentials;
mod facts;
mod goals;
mod induction;
mod instances;
mod letters;
mod limits;
mod logarithms;
mod means;
mod products;
mod quadratics;
mod radicals;
mod slopes;
mod solutions;
mod squares;
mod sums;
mod tangents;
#[cfg(test)]
mod tests;
mod values;

use super::Fail;
use super::brief::looked_at;
use crate::algebra::Moment;
use crate::certificate::{Certificate, Label, Rule, Show, Step, Term};
use crate::claim::syntax::{Claim, Expr, Prop, PropKind};
use crate::kernel::statement::prop;
use crate::kernel::substitution::Substitution;
use crate::kernel::{Accepted, Checker, key};
use crate::refute::catalogue::Limits;
use letters::Letters;
use std::collections::{BTreeSet, HashMap};

/// Largest number of steps tried for one claim.
const TRIES: usize = 2_000;

/// Largest total size of all linear programs for one claim. The size of one is its number of columns times the
/// number of nonzero entries (see `spend`).
const PROGRAMS: usize = 5_000_000;

/// Proves a claim without using the argument in its file.
///
/// # Errors
/// What could not be proved.
pub(super) fn prove(claim: &Claim, cited: &[&Accepted], limits: &Limits) -> Result<(Certificate, Accepted), Fail> {
    let checker = Checker::new(claim, cited).map_err(Fail::from)?;
    let statement = checker.statement().clone();
    let mut prover = Prover {
        checker,
        steps: Vec::new(),
        counter: 0,
        letters: Letters::default(),
        readings: HashMap::new(),
        keys: HashMap::new(),
        equations: Vec::new(),
        naturals: statement
            .bindings
            .iter()
            .filter(|b| b.natural)
            .flat_map(|b| &b.names)
            .map(|n| n.0.text.clone())
            .collect(),
        names: statement.names(),
        enriched: BTreeSet::new(),
        failed: BTreeSet::new(),
        squares_written: Vec::new(),
        roots: Vec::new(),
        deadline: Moment::now().checked_add(limits.time),
        tries: 0,
        most_tries: limits.steps.div_ceil(super::STEPS_OF_A_TRY).min(TRIES),
        spent: 0,
        splits: 0,
        inductions: 0,
        slopes: 0,
        slopes_open: 0,
    };
    let given: Vec<(Label, Prop)> = prover.checker.facts().map(|(l, p)| (l.to_string(), p.clone())).collect();
    for (label, fact) in &given {
        prover.take_in(label, fact)?;
    }
    let shown = prover.show(&statement.goal)?;
    // The goal is what the last step shows.
    if prover.checker.facts().last().is_none_or(|last| last.0 != shown) {
        prover.emit(Rule::Logic { from: vec![shown] }, statement.goal.clone())?;
    }
    let digest = crate::certificate::text::digest(&statement.text());
    let whole = Certificate { claim: claim.name.text.clone(), statement: digest, refutes: None, steps: prover.steps };
    super::accepted(claim, whole, cited, limits)
}

/// The state of the search.
pub(super) struct Prover {
    checker: Checker,
    steps: Vec<Step>,
    counter: usize,
    letters: Letters,
    /// For each fact, the difference of its sides as a polynomial. The key is the fact's label and the list of
    /// equations substituted when it was read.
    readings: HashMap<(Label, Vec<Label>), Option<facts::Reading>>,
    /// The text of each fact, by its label; `known` compares these texts.
    keys: HashMap<Label, String>,
    /// Labels of the equations that the kernel substitutes in every step.
    equations: Vec<Label>,
    /// The variables that are natural numbers.
    naturals: Vec<String>,
    /// Names in use.
    names: BTreeSet<String>,
    /// Expressions of letters for which `values` has already added facts.
    enriched: BTreeSet<String>,
    /// Expressions of letters for which no fact could be added in the open blocks.
    failed: BTreeSet<String>,
    /// The bases of even powers in goals and facts, before multiplying out.
    squares_written: Vec<crate::algebra::Polynomial>,
    /// Roots of numbers for which facts were added.
    roots: Vec<Expr>,
    deadline: Option<Moment>,
    tries: usize,
    most_tries: usize,
    /// Total size of the linear programs so far, limited by [`PROGRAMS`].
    spent: usize,
    /// Number of nested case distinctions.
    splits: usize,
    /// Number of nested inductions.
    inductions: usize,
    /// Number of comparisons tried by the sign of a derivative.
    slopes: usize,
    /// Number of such attempts that are nested now.
    slopes_open: usize,
}

impl Prover {
    fn tick(&mut self) -> Result<(), Fail> {
        self.tries += 1;
        if self.deadline.is_some_and(|deadline| Moment::now() > deadline) {
            return Err(Fail::Limit("time"));
        }
        if self.tries > self.most_tries { Err(Fail::Limit("tries")) } else { Ok(()) }
    }

    /// Adds a step if the kernel accepts it, citing only what the kernel looks at. Returns the label of the new fact.
    fn emit(&mut self, rule: Rule, shown: Prop) -> Result<Label, Fail> {
        self.tick()?;
        let by = self.signs();
        let show =
            Show { label: format!("{}", self.counter + 1), rule, prop: shown, by, using: self.equations.clone() };
        let show = match looked_at(&mut self.checker, show.clone()) {
            Err(_) if !show.using.is_empty() => looked_at(&mut self.checker, Show { using: Vec::new(), ..show }),
            other => other,
        };
        let show = show.map_err(Fail::from)?;
        let label = show.label.clone();
        let step = Step::Show(Box::new(show));
        self.checker.step(&step).map_err(Fail::from)?;
        self.counter += 1;
        self.steps.push(step);
        Ok(label)
    }

    /// Adds the size of a linear program with these columns to the total.
    fn spend(&mut self, columns: &[products::Known]) -> Result<(), Fail> {
        self.spent += columns.len() * columns.iter().map(|c| c.poly.term_count()).sum::<usize>();
        if self.spent > PROGRAMS { Err(Fail::Limit("linear programs")) } else { Ok(()) }
    }

    fn combination(&mut self, shown: Prop, terms: Vec<Term>) -> Result<Label, Fail> {
        self.emit(Rule::Combination { times: None, terms }, shown)
    }

    fn logic(&mut self, from: &[&str], shown: &Prop) -> Result<Label, Fail> {
        self.emit(Rule::Logic { from: from.iter().map(|l| (*l).to_string()).collect() }, shown.clone())
    }

    /// Runs a part of the search; if it fails, restores the state before it.
    fn attempt<T>(&mut self, run: impl FnOnce(&mut Self) -> Result<T, Fail>) -> Result<T, Fail> {
        let checker = self.checker.clone();
        let (steps, equations, naturals) = (self.steps.len(), self.equations.clone(), self.naturals.clone());
        let (splits, inductions, enriched) = (self.splits, self.inductions, self.enriched.clone());
        let roots = self.roots.len();
        let result = run(self);
        if result.is_err() {
            self.checker = checker;
            self.steps.truncate(steps);
            self.equations = equations;
            self.naturals = naturals;
            self.enriched = enriched;
            self.roots.truncate(roots);
            (self.splits, self.inductions) = (splits, inductions);
        }
        result
    }

    /// Proves an implication or a `for all` statement in a block.
    fn block(&mut self, goal: &Prop, run: impl FnOnce(&mut Self, &str) -> Result<Label, Fail>) -> Result<Label, Fail> {
        if let Some(label) = self.known(goal) {
            return Ok(label);
        }
        let (equations, naturals) = (self.equations.clone(), self.naturals.clone());
        let (enriched, roots) = (self.enriched.clone(), self.roots.len());
        let rule = if matches!(goal.kind, PropKind::ForAll(..)) { Rule::Let } else { Rule::Suppose };
        let block = self.emit(rule, goal.clone())?;
        let failed = std::mem::take(&mut self.failed);
        if let PropKind::ForAll(bindings, _) = &goal.kind {
            for binding in bindings.iter().filter(|b| b.natural) {
                self.naturals.extend(binding.names.iter().map(|n| n.0.text.clone()));
            }
        }
        let new: Vec<(Label, Prop)> = self
            .checker
            .facts()
            .filter(|(label, _)| label.strip_prefix(block.as_str()).is_some_and(|rest| rest.starts_with(['s', 'd'])))
            .map(|(l, p)| (l.to_string(), p.clone()))
            .collect();
        for (label, fact) in &new {
            self.take_in(label, fact)?;
        }
        let conclusion = run(self, &block);
        self.failed = failed;
        let conclusion = conclusion?;
        let end = Step::End(conclusion);
        self.checker.step(&end).map_err(Fail::from)?;
        self.steps.push(end);
        self.equations = equations;
        self.naturals = naturals;
        self.enriched = enriched;
        self.roots.truncate(roots);
        Ok(block)
    }

    /// The label of the fact with the same text, if there is one.
    fn known(&mut self, wanted: &Prop) -> Option<Label> {
        let wanted = key::prop(wanted);
        let facts: Vec<&str> = self.checker.facts().map(|f| f.0).collect();
        let missing: Vec<(Label, String)> = self
            .checker
            .facts()
            .filter(|(label, _)| !self.keys.contains_key(*label))
            .map(|(label, p)| (label.to_string(), key::prop(p)))
            .collect();
        let found =
            facts.iter().rev().find(|l| self.keys.get(**l).is_some_and(|k| *k == wanted)).map(|l| (*l).to_string());
        let new = missing.iter().find(|(_, k)| *k == wanted).map(|(l, _)| l.clone());
        self.keys.extend(missing);
        found.or(new)
    }

    /// The facts whose signs a step may use. A `for all` fact that contains a sum is left out, because the kernel applies
    /// such a fact inside every sum, where its index may be in use. Only its instances are useful.
    fn signs(&self) -> Vec<Label> {
        let speaks = |p: &Prop| match &p.kind {
            PropKind::Compare(..) | PropKind::And(_) => true,
            PropKind::ForAll(_, body) => !has_an_index(body),
            _ => false,
        };
        self.checker.facts().filter(|(_, p)| speaks(p)).map(|f| f.0.to_string()).collect()
    }

    fn fact(&self, label: &str) -> Option<Prop> {
        self.checker.facts().find(|f| f.0 == label).map(|f| f.1.clone())
    }

    /// A name that is not in use anywhere.
    fn fresh(&mut self, stem: &str) -> String {
        let fresh = (1..).map(|k| format!("{stem}{k}")).find(|n| !self.names.contains(n)).unwrap_or_default();
        self.names.insert(fresh.clone());
        fresh
    }
}

/// Whether a proposition contains a sum or product over an index.
fn has_an_index(p: &Prop) -> bool {
    let mut found = BTreeSet::new();
    let mut sides = Vec::new();
    goals::sides_in(p, &mut sides);
    sides.iter().for_each(|e| crate::claim::walk::indices(e, &mut found));
    !found.is_empty()
}

/// `P => Q`.
fn implies(p: &Prop, q: &Prop) -> Prop {
    prop(PropKind::Implies(Box::new(p.clone()), Box::new(q.clone())))
}

/// Substitutes a value for a name in a proposition.
fn put(p: &Prop, name: &str, value: &Expr) -> Result<Prop, Fail> {
    let mut map = Substitution::default();
    map.replace(name, value);
    map.prop(p).map_err(Fail::from)
}
