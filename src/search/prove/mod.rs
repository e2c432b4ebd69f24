//! The search for proofs: it makes the steps of a draft, and writes them as a certificate that the kernel accepts.
//!
//! Contract: [`certificate()`] returns a certificate that the kernel accepted, or says where it got stuck. Nothing here is
//! trusted: the kernel rejects a wrong step, and `carom check` checks the certificate again from its text.
//!
//! Method: the search follows the claim's own argument. If the argument fails, it tries the automatic methods. Proved
//! facts become steps of a draft (`draft`). Signs come from factorisations and certificates of positivity, as explicit
//! identities. The steps that the goal needs are then written as a certificate (`elaborate`), each with its citations.
//! If this fails, a second search follows the argument with methods of its own, or works without it (`direct`). `brief` shortens
//! what either of them found.

mod argument;
mod brief;
mod constraints;
mod contradiction;
mod direct;
mod draft;
mod elaborate;
mod equations;
mod fail;
mod goal;
mod lattice;
mod methods;
mod polynomials;
mod powers;
mod signs;
mod unfold;
mod write;

use crate::algebra::Moment;
use crate::certificate::{self, Certificate, Show, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, name};
use crate::kernel::substitution::Substitution;
use crate::kernel::{Accepted, Checker, Refusal, Verdict, text};
use crate::refute::catalogue::Limits;
use crate::refute::expand;
use draft::marks::{Source, Sources, needed};
use draft::{Draft, Fact, Rule, Step, negation};
pub use fail::Fail;
use goal::exprs_in;
use std::rc::Rc;

/// How many search steps ([`Limits::steps`]) one step of a draft counts as.
const STEPS_OF_A_TRY: usize = 20;

/// A certificate of a claim; `cited` holds the accepted claims that it cites.
///
/// # Errors
/// Those of `by_search`.
pub fn certificate(claim: &Claim, cited: &[&Accepted], limits: &Limits) -> Result<(Certificate, Accepted), Fail> {
    at_once(claim, cited, limits).or_else(|_| by_search(claim, cited, limits))
}

/// A certificate of a claim that [`at_once`] cannot prove.
///
/// # Errors
/// The first thing that could not be proved; [`Fail::Unwritten`] if everything was, but the kernel rejects the certificate.
pub(crate) fn by_search(claim: &Claim, cited: &[&Accepted], limits: &Limits) -> Result<(Certificate, Accepted), Fail> {
    let begin = Moment::now();
    if std::env::var_os("NODRAFT").is_some() {
        return direct::prove(claim, cited, limits);
    }
    by_draft(claim, cited, limits).or_else(|first| {
        // What the draft does not reach may be found by all methods, in the time that is left.
        let rest = Limits { time: limits.time.saturating_sub(begin.elapsed()), ..limits.clone() };
        direct::prove(claim, cited, &rest).map_err(|_| first)
    })
}

/// Shortens a certificate, with a time limit of its own, and has the kernel check it. The text counts: it is read back and
/// checked from the beginning.
fn accepted(
    claim: &Claim,
    found: Certificate,
    cited: &[&Accepted],
    limits: &Limits,
) -> Result<(Certificate, Accepted), Fail> {
    let deadline = Moment::now().checked_add(limits.time);
    let written = &brief::brief(claim, found, cited, deadline).map_err(Fail::from)?;
    let read = crate::certificate::text::read(&crate::certificate::text::write(written))
        .map_err(|m| Fail::Value(m.fault.to_string()).within(&format!("line {}", m.line)))?;
    match crate::kernel::check(claim, &read, cited) {
        Verdict::Accepted(shown) => Ok((read, *shown)),
        other => Err(Fail::whole(other)),
    }
}

/// Proves comparisons that the kernel sees by multiplying out: identities, and signs that follow from the hypotheses.
/// A claim with an argument of its own is left to that argument.
///
/// # Errors
/// The kernel does not see the comparison.
pub(crate) fn at_once(claim: &Claim, cited: &[&Accepted], limits: &Limits) -> Result<(Certificate, Accepted), Fail> {
    if !claim.proof.is_empty() {
        return Err(Fail::No("a comparison without an argument"));
    }
    let mut checker = Checker::new(claim, cited).map_err(Fail::from)?;
    let statement = checker.statement();
    let (goal, digest) = (statement.goal.clone(), crate::certificate::text::digest(&statement.text()));
    let parts = parts(&goal);
    let mut steps: Vec<certificate::Step> = Vec::new();
    let mut take = |rule: certificate::Rule, prop: Prop| {
        let by = match rule {
            certificate::Rule::Combination { .. } => checker.facts().map(|f| f.0.to_string()).collect(),
            _ => Vec::new(),
        };
        let show = Show { label: format!("{}", steps.len() + 1), rule, prop, by, using: Vec::new() };
        steps.push(brief::take(&mut checker, show)?);
        Ok::<(), Refusal>(())
    };
    for part in &parts {
        if !matches!(part.kind, PropKind::Compare(..)) {
            return Err(Fail::No("a comparison without an argument"));
        }
        take(certificate::Rule::Combination { times: None, terms: Vec::new() }, part.clone()).map_err(Fail::from)?;
    }
    if !matches!(goal.kind, PropKind::Compare(..)) || parts.len() > 1 {
        let from = (1..=parts.len()).map(|k| k.to_string()).collect();
        take(certificate::Rule::Logic { from }, goal).map_err(Fail::from)?;
    }
    let found = Certificate { claim: claim.name.text.clone(), statement: digest, refutes: None, steps };
    accepted(claim, found, cited, limits)
}

/// The comparisons that make up a conjunction or chain; a proposition of another kind is its only part.
fn parts(p: &Prop) -> Vec<Prop> {
    match &p.kind {
        PropKind::And(list) => list.iter().flat_map(parts).collect(),
        PropKind::Compare(sides, relations) => {
            let pairs = sides.windows(2).zip(relations);
            pairs.map(|(pair, r)| compare(pair[0].clone(), *r, pair[1].clone())).collect()
        }
        _ => vec![p.clone()],
    }
}

/// Follows the claim's argument in a draft, and writes the draft as a certificate.
fn by_draft(claim: &Claim, cited: &[&Accepted], limits: &Limits) -> Result<(Certificate, Accepted), Fail> {
    let statement = expand::Statement::of(claim).map_err(|limit| Fail::Limit(limit.0))?;
    let deadline = Moment::now().checked_add(limits.time);
    let guided = !statement.proof.is_empty();
    match certified(claim, &statement, cited, limits, deadline) {
        Err(fail) if guided && fail.limit().is_none() => {
            let alone = expand::Statement { proof: Proof::default(), ..statement };
            certified(claim, &alone, cited, limits, deadline).map_err(|_| fail)
        }
        other => other,
    }
}

/// A certificate of a claim by the argument of this statement.
fn certified(
    claim: &Claim,
    statement: &expand::Statement,
    cited: &[&Accepted],
    limits: &Limits,
    deadline: Option<Moment>,
) -> Result<(Certificate, Accepted), Fail> {
    let checker = Draft::new(claim, cited).map_err(Fail::from)?;
    let mut certifier = Certifier {
        checker,
        steps: Vec::new(),
        trail: Vec::new(),
        generators: Vec::new(),
        exponentials: Vec::new(),
        labels: Vec::new(),
        values: Substitution::default(),
        replaced: Vec::new(),
        entries: Vec::new(),
        introduced: std::collections::HashSet::new(),
        counter: 0,
        tries: limits.steps.div_ceil(STEPS_OF_A_TRY),
        deadline,
        splits: 0,
        within_powers: false,
    };
    let goal = certifier.checker.statement().goal.clone();
    certifier.begin(statement)?;
    certifier.follow(&goal, &statement.proof).map_err(|fail| fail.of_goal(&goal))?;
    certifier.concluded(claim, &goal, cited, limits).map_err(|fail| Fail::Unwritten(Box::new(fail)))
}

impl Certifier {
    /// The steps on which the goal rests, as a certificate that the kernel accepts.
    fn concluded(
        self,
        claim: &Claim,
        goal: &Prop,
        cited: &[&Accepted],
        limits: &Limits,
    ) -> Result<(Certificate, Accepted), Fail> {
        let certifier = self;
        let goal = certifier.checker.facts().iter().find(|f| f.key() == text::prop(goal)).map(Fact::source);
        let needed = goal.map(|goal| needed(&certifier.trail, goal)).ok_or("the goal is not among the facts")?;
        let steps = certifier.steps;
        // What was found is written in a time of its own.
        let deadline = Moment::now().checked_add(limits.time);
        let fewer: Vec<Step> =
            (0..).zip(&steps).filter(|(k, _)| needed.contains(&Source::Step(*k))).map(|s| s.1.clone()).collect();
        // The marks only propose which steps to keep: if these do not make a certificate, all steps may.
        let written = match elaborate::elaborate(claim, &fewer, cited, deadline) {
            Ok(written) => written,
            Err(_) => elaborate::elaborate(claim, &steps, cited, deadline)?,
        };
        accepted(claim, written, cited, limits)
    }
}

/// The search for one certificate.
pub struct Certifier {
    checker: Draft,
    steps: Vec<Step>,
    /// What each of them used.
    trail: Vec<Sources>,
    generators: Vec<powers::Generator>,
    /// Atoms that are powers, as they are written.
    exponentials: Vec<(usize, Expr)>,
    /// The argument's labels, with the facts they stand for.
    labels: Vec<(String, Prop)>,
    /// Names that the argument obtained, with their values.
    values: Substitution,
    /// Equations by which variables are replaced: label, variable.
    replaced: Vec<(String, String)>,
    /// Powers that are not generators, with their bases and exponents.
    entries: Vec<(Expr, Vec<(crate::kernel::fraction::Poly, crate::kernel::fraction::Fraction)>)>,
    /// Powers known to be introduced, as text.
    introduced: std::collections::HashSet<String>,
    counter: usize,
    /// How many steps may still be tried.
    tries: usize,
    deadline: Option<Moment>,
    splits: usize,
    /// Whether powers of facts are being tried: not within one another.
    within_powers: bool,
}

/// The state to restore after a failed attempt.
struct Mark {
    checker: Draft,
    steps: usize,
    generators: Vec<powers::Generator>,
    exponentials: usize,
    labels: usize,
    entries: usize,
    introduced: std::collections::HashSet<String>,
    counter: usize,
}

impl Certifier {
    fn tick(&mut self) -> Result<(), Fail> {
        if self.deadline.is_some_and(|deadline| Moment::now() > deadline) {
            return Err(Fail::Limit("time"));
        }
        self.tries = self.tries.checked_sub(1).ok_or(Fail::Limit("steps"))?;
        Ok(())
    }

    /// Adds a step if the draft accepts it; returns its label.
    fn step(&mut self, mut step: Step) -> Result<String, Fail> {
        self.tick()?;
        if step.rule != Rule::End {
            step.label = format!("x{}", self.counter + 1);
        }
        let used = self.checker.step(&step).map_err(|f| Fail::step(step.rule.name(), f))?;
        self.trail.push(used);
        self.counter += 1;
        let label = step.label.clone();
        self.steps.push(step);
        Ok(label)
    }

    fn take(&mut self, rule: Rule, from: &[String], prop: Option<Prop>) -> Result<String, Fail> {
        self.with(rule, from, prop, Vec::new())
    }

    fn with(
        &mut self,
        rule: Rule,
        from: &[String],
        prop: Option<Prop>,
        with: Vec<(Name, Expr)>,
    ) -> Result<String, Fail> {
        self.step(Step { label: String::new(), rule, from: from.to_vec(), prop, with, times: None, terms: Vec::new() })
    }

    fn combination(&mut self, prop: Prop, times: Option<Expr>, terms: Vec<Term>) -> Result<String, Fail> {
        let sides: Vec<Expr> = match &prop.kind {
            PropKind::Compare(sides, _) => sides.clone(),
            _ => Vec::new(),
        };
        self.prepare(&sides.iter().collect::<Vec<_>>())?;
        self.step(Step {
            label: String::new(),
            rule: Rule::Combination,
            from: Vec::new(),
            prop: Some(prop),
            with: Vec::new(),
            times,
            terms,
        })
    }

    /// Runs a part of the search; if it fails, restores the state before it.
    fn attempt<T>(&mut self, run: impl FnOnce(&mut Self) -> Result<T, Fail>) -> Result<T, Fail> {
        let mark = Mark {
            checker: self.checker.clone(),
            steps: self.steps.len(),
            generators: self.generators.clone(),
            exponentials: self.exponentials.len(),
            labels: self.labels.len(),
            entries: self.entries.len(),
            introduced: self.introduced.clone(),
            counter: self.counter,
        };
        let result = run(self);
        if result.is_err() {
            self.checker = mark.checker;
            self.steps.truncate(mark.steps);
            self.trail.truncate(mark.steps);
            self.generators = mark.generators;
            self.exponentials.truncate(mark.exponentials);
            self.labels.truncate(mark.labels);
            self.entries.truncate(mark.entries);
            self.introduced = mark.introduced;
            self.counter = mark.counter;
        }
        result
    }

    /// Opens a block for a goal, runs something in it and closes it.
    fn block(&mut self, goal: &Prop, run: impl FnOnce(&mut Self, &str) -> Result<(), Fail>) -> Result<(), Fail> {
        if self.checker.knows(goal) {
            return Ok(());
        }
        let rule = if matches!(goal.kind, PropKind::ForAll(..)) { Rule::Let } else { Rule::Suppose };
        let (generators, labels) = (self.generators.clone(), self.labels.len());
        let (entries, introduced) = (self.entries.len(), self.introduced.clone());
        let label = self.take(rule, &[], Some(goal.clone()))?;
        run(self, &label)?;
        self.take(Rule::End, &[], None)?;
        self.generators = generators;
        self.labels.truncate(labels);
        self.entries.truncate(entries);
        self.introduced = introduced;
        Ok(())
    }

    /// The hypotheses, with all powers of the claim introduced.
    fn begin(&mut self, statement: &expand::Statement) -> Result<(), Fail> {
        let own = self.checker.statement().clone();
        let mut exprs = Vec::new();
        own.assumptions.iter().for_each(|p| exprs_in(p, &mut exprs));
        exprs_in(&own.goal, &mut exprs);
        direct::argument::exprs_in(&statement.proof, &exprs_in, &mut exprs);
        self.prepare(&exprs.iter().collect::<Vec<_>>())?;
        // The domains and hypotheses, not the powers that were introduced beside them.
        let given = self.checker.facts().iter().filter(|f| f.label().starts_with('h'));
        let list: Vec<(String, Prop)> = given.map(|f| (f.label().to_string(), (**f.prop()).clone())).collect();
        for (label, prop) in &list {
            self.suppose(label, prop)?;
        }
        for variable in self.checker.variables().to_vec() {
            if let Ok(f) = self.checker.scalar(&name(variable.name())) {
                for poly in f.factors.keys() {
                    let _ = self.settle(poly, 1);
                }
            }
        }
        self.prepare(&exprs.iter().collect::<Vec<_>>())?;
        let first = list.len() - own.assumptions.len();
        for ((label, _), (_, prop)) in statement.assumptions.iter().zip(list.into_iter().skip(first)) {
            if let Some(label) = label {
                self.labels.push((label.clone(), prop));
            }
        }
        Ok(())
    }

    /// Uses a fact: adds its parts, and the signs and values that follow from it.
    fn suppose(&mut self, label: &str, fact: &Prop) -> Result<(), Fail> {
        let mut exprs = Vec::new();
        exprs_in(fact, &mut exprs);
        self.prepare(&exprs.iter().collect::<Vec<_>>())?;
        match &fact.kind {
            PropKind::Compare(sides, relations) if relations.len() == 1 => {
                self.unfold_all(&sides.iter().collect::<Vec<_>>())?;
                self.exploit(label, fact)
            }
            PropKind::Compare(sides, relations) => {
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let part = compare(pair[0].clone(), *relation, pair[1].clone());
                    let label = self.take(Rule::Part, &[label.to_string()], Some(part.clone()))?;
                    self.suppose(&label, &part)?;
                }
                Ok(())
            }
            PropKind::And(list) => {
                for part in list {
                    let label = self.take(Rule::Part, &[label.to_string()], Some(part.clone()))?;
                    self.suppose(&label, part)?;
                }
                Ok(())
            }
            PropKind::Not(inner) => match negation(inner) {
                Some(p) => {
                    let label = self.take(Rule::Negation, &[label.to_string()], Some(p.clone()))?;
                    self.suppose(&label, &p)
                }
                None => Ok(()),
            },
            _ => Ok(()),
        }
    }

    /// The labels of the facts known now. It is a copy, because steps taken during a walk add more facts.
    fn facts(&self) -> Vec<(String, Rc<Prop>)> {
        self.checker.facts().iter().map(|f| (f.label().to_string(), f.prop().clone())).collect()
    }

    fn label_of(&self, fact: &Prop) -> Option<String> {
        let key = text::prop(fact);
        self.checker.facts().iter().rev().find(|f| f.key() == key).map(|f| f.label().to_string())
    }
}
