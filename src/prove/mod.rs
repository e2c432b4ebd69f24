//! The search for proofs: steps of a draft, written as a certificate that the kernel accepts.
//!
//! Contract: [`certificate`] returns a certificate that the kernel accepted, or says where it got stuck. Nothing here is
//! trusted: a wrong step is rejected by the kernel, and `carom check` reads the text and checks it from nothing.
//!
//! Method: the claim's own argument is followed, and where it leads nowhere the goal is shown without it. What is shown
//! becomes steps of a draft (`draft`), which keeps what is known so far. Signs come from the engine's factorisation and
//! certificates of positivity, as explicit identities. Then the steps that the goal rests on are written as a certificate
//! (`elaborate`), each with all that it cites. Where that fails, a second search is tried that needs no argument (`direct`).

mod direct;
mod draft;
mod elaborate;
mod fail;
mod powers;
mod signs;
mod write;

use crate::algebra::Instant;
use crate::certificate::{Certificate, Term};
use crate::claim::syntax::*;
use crate::kernel::analysis::{at_the_point, weighted_mean};
use crate::kernel::order::Signs;
use crate::kernel::statement::{
    Substitution, compare, domain, expr, name, numeral, one_minus, power, product, prop, sum,
};
use crate::kernel::{Accepted, Verdict, text};
use crate::refute::catalogue::Limits;
use crate::refute::expand;
use draft::marks::{Source, Sources, needed};
use draft::{Draft, Fact, Rule, Step, negation};
pub use fail::Fail;
use std::collections::BTreeSet;
use std::rc::Rc;
use write::{named, negated};

/// How many steps of the search ([`Limits::steps`]) a step of a draft counts for.
const STEPS_OF_A_TRY: usize = 20;

/// A certificate of a claim; `cited` holds what was accepted of the claims it cites.
///
/// # Errors
/// The first thing that could not be shown in the kernel's rules; [`Fail::Unwritten`] where all was, and the kernel does
/// not accept what was written.
pub fn certificate(claim: &Claim, cited: &[&Accepted], limits: &Limits) -> Result<(Certificate, Accepted), Fail> {
    let begin = Instant::now();
    by_draft(claim, cited, limits).or_else(|first| {
        // What the argument does not reach may be found without it, in the time that is left.
        let rest = Limits { time: limits.time.saturating_sub(begin.elapsed()), ..limits.clone() };
        direct::prove(claim, cited, &rest).map_err(|_| first)
    })
}

/// The claim's argument as a draft, and that as a certificate.
fn by_draft(claim: &Claim, cited: &[&Accepted], limits: &Limits) -> Result<(Certificate, Accepted), Fail> {
    let statement = expand::Statement::of(claim).map_err(|limit| Fail::Limit(limit.0))?;
    let deadline = Instant::now().checked_add(limits.time);
    let guided = !statement.proof.steps.is_empty() || statement.proof.close.is_some();
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
    deadline: Option<Instant>,
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
        let deadline = Instant::now().checked_add(limits.time);
        let fewer: Vec<Step> =
            (0..).zip(&steps).filter(|(k, _)| needed.contains(&Source::Step(*k))).map(|s| s.1.clone()).collect();
        // The marks only propose: where fewer steps do not make a certificate, all may.
        let written = match elaborate::elaborate(claim, &fewer, cited, deadline) {
            Ok(written) => written,
            Err(_) => elaborate::elaborate(claim, &steps, cited, deadline)?,
        };
        // What counts is what is written: the text is read back and checked from nothing.
        let text = crate::certificate::text::write(&written);
        let read = crate::certificate::text::read(&text)
            .map_err(|m| Fail::Value(m.fault.to_string()).within(&format!("line {}", m.line)))?;
        match crate::kernel::check(claim, &read, cited) {
            Verdict::Accepted(shown) => Ok((read, *shown)),
            other => Err(Fail::whole(other)),
        }
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
    deadline: Option<Instant>,
    splits: usize,
    /// Whether powers of facts are being tried: not within one another.
    within_powers: bool,
}

/// What a failed attempt goes back to.
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
        if self.deadline.is_some_and(|deadline| Instant::now() > deadline) {
            return Err(Fail::Limit("time"));
        }
        self.tries = self.tries.checked_sub(1).ok_or(Fail::Limit("steps"))?;
        Ok(())
    }

    /// Takes a step, if the kernel does; returns its label.
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

    /// Runs something; if it fails everything is as before.
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
        exprs_in_proof(&statement.proof, &mut exprs);
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

    /// Uses a fact: its parts, the signs and values it gives.
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

    /// The facts known now, by label: steps taken while they are walked through add others.
    fn facts(&self) -> Vec<(String, Rc<Prop>)> {
        self.checker.facts().iter().map(|f| (f.label().to_string(), f.prop().clone())).collect()
    }

    fn label_of(&self, fact: &Prop) -> Option<String> {
        let key = text::prop(fact);
        self.checker.facts().iter().rev().find(|f| f.key() == key).map(|f| f.label().to_string())
    }

    /// Shows a goal with an argument.
    fn follow(&mut self, goal: &Prop, proof: &Proof) -> Result<(), Fail> {
        let labels = self.labels.len();
        let values = self.values.clone();
        let result = self.follow_steps(goal, proof);
        self.labels.truncate(labels);
        self.values = values;
        result
    }

    fn follow_steps(&mut self, goal: &Prop, proof: &Proof) -> Result<(), Fail> {
        for (at, step) in proof.steps.iter().enumerate() {
            match step {
                Step_::Have { label, prop, proof } => {
                    let fact = self.put(prop)?;
                    let taken = self.follow(&fact, proof);
                    taken.map_err(|e| e.within(&label.text))?;
                    if let Some(known) = self.label_of(&fact) {
                        self.suppose(&known, &fact)?;
                    }
                    self.labels.push((label.text.clone(), fact));
                }
                Step_::Obtain { binding, label, prop, witness } => {
                    let value = self.values.expr(witness).map_err(Fail::from)?;
                    if let Some((variable, _)) = binding.names.first() {
                        self.values.replace(&variable.text, &value);
                    }
                    for fact in domain(binding).iter().chain([prop]) {
                        let fact = self.put(fact)?;
                        self.show(&fact)?;
                        if text::prop(&fact) == text::prop(&self.put(prop)?) {
                            self.labels.push((label.text.clone(), fact));
                        }
                    }
                }
                Step_::Case { .. } => return self.cases(goal, proof.steps.get(at..).unwrap_or_default()),
            }
        }
        match &proof.close {
            None => self.show(goal),
            Some(method) => self.by_method(goal, method),
        }
    }

    fn put(&self, p: &Prop) -> Result<Prop, Fail> {
        self.values.prop(p).map_err(Fail::from)
    }

    fn put_expr(&self, e: &Expr) -> Result<Expr, Fail> {
        self.values.expr(e).map_err(Fail::from)
    }

    fn cases(&mut self, goal: &Prop, steps: &[Step_]) -> Result<(), Fail> {
        let mut list = Vec::new();
        for step in steps {
            let Step_::Case { label, prop, proof } = step else { return Err(Fail::No("cases come last")) };
            list.push((label.text.clone(), self.put(prop)?, proof));
        }
        let all = prop(PropKind::Or(list.iter().map(|c| c.1.clone()).collect()));
        self.show(&all)?;
        let disjunction = self.label_of(&all).ok_or("the cases")?;
        for (label, case, proof) in list {
            let implication = prop(PropKind::Implies(Box::new(case.clone()), Box::new(goal.clone())));
            self.block(&implication, |c, block| {
                c.labels.push((label, case.clone()));
                c.suppose(&format!("{block}s"), &case)?;
                c.follow(goal, proof)
            })?;
        }
        self.take(Rule::Cases, &[disjunction], Some(goal.clone())).map(|_| ())
    }

    /// Shows a goal without an argument.
    pub(crate) fn show(&mut self, goal: &Prop) -> Result<(), Fail> {
        self.tick()?;
        if self.checker.knows(goal) {
            return Ok(());
        }
        match &goal.kind {
            PropKind::Compare(sides, relations) => match (sides.as_slice(), relations.as_slice()) {
                ([a, b], [relation]) => self.show_comparison(goal, a, *relation, b),
                _ => {
                    for (pair, relation) in sides.windows(2).zip(relations) {
                        self.show(&compare(pair[0].clone(), *relation, pair[1].clone()))?;
                    }
                    self.take(Rule::All, &[], Some(goal.clone())).map(|_| ())
                }
            },
            PropKind::And(list) => {
                for part in list {
                    self.show(part)?;
                }
                self.take(Rule::All, &[], Some(goal.clone())).map(|_| ())
            }
            PropKind::Or(list) => self.show_or(goal, list),
            PropKind::Not(inner) => {
                let p = negation(inner).ok_or("a negation that is not followed")?;
                self.show(&p)?;
                let label = self.label_of(&p).ok_or("a negation")?;
                self.take(Rule::Negation, &[label], Some(goal.clone())).map(|_| ())
            }
            PropKind::Implies(p, q) => {
                let mut exprs = Vec::new();
                exprs_in(p, &mut exprs);
                let exprs: Vec<&Expr> = exprs.iter().collect();
                self.prepare(&exprs)?;
                self.define(&exprs)?;
                self.block(goal, |c, block| {
                    c.suppose(&format!("{block}s"), p)?;
                    c.show(q)
                })
            }
            PropKind::Equivalent(list) => {
                for pair in list.windows(2) {
                    for (p, q) in [(&pair[0], &pair[1]), (&pair[1], &pair[0])] {
                        self.show(&prop(PropKind::Implies(Box::new(p.clone()), Box::new(q.clone()))))?;
                    }
                }
                self.take(Rule::Equivalent, &[], Some(goal.clone())).map(|_| ())
            }
            PropKind::ForAll(_, body) => self.block(goal, |c, block| {
                c.enter(block)?;
                c.show(body)
            }),
            PropKind::Exists(bindings, body) => {
                let point =
                    crate::refute::search::example(bindings, body, self.deadline).ok_or("no witness was found")?;
                let values: Vec<(Name, Expr)> = point
                    .into_iter()
                    .map(|(n, v)| (Name { text: n, span: Span::default() }, crate::refute::search::literal(&v)))
                    .collect();
                self.witness(goal, &values)
            }
            PropKind::Extremum(e) => self.extremum(goal, e),
            PropKind::Limit(l) => {
                self.define(&[&l.of, &l.value])?;
                self.take(Rule::Limit, &[], Some(goal.clone())).map(|_| ())
            }
        }
    }

    /// Uses the domain of a block's variables.
    fn enter(&mut self, block: &str) -> Result<(), Fail> {
        let list: Vec<(String, Prop)> = self
            .checker
            .facts()
            .iter()
            .filter(|f| f.label().strip_prefix(block).is_some_and(|rest| rest.starts_with('d')))
            .map(|f| (f.label().to_string(), (**f.prop()).clone()))
            .collect();
        list.iter().try_for_each(|(label, fact)| self.suppose(label, fact))
    }

    fn show_comparison(&mut self, goal: &Prop, a: &Expr, relation: Relation, b: &Expr) -> Result<(), Fail> {
        if is_matrix(a) || is_matrix(b) {
            self.prepare(&[a, b])?;
            self.define(&[a, b])?;
            return self.take(Rule::Sign, &[], Some(goal.clone())).map(|_| ());
        }
        let first = match self.attempt(|c| c.comparison(a, relation, b)) {
            Ok(()) => return Ok(()),
            Err(first) => first,
        };
        if let Some(label) = self.contradiction() {
            return self.take(Rule::Absurd, &[label], Some(goal.clone())).map(|_| ());
        }
        if self.saturate()? && self.attempt(|c| c.comparison(a, relation, b)).is_ok() {
            return Ok(());
        }
        if self.attempt(|c| c.transitive(goal, a, relation, b)).is_ok() {
            return Ok(());
        }
        const ORDER: [Relation; 4] = [Relation::Less, Relation::LessEqual, Relation::Greater, Relation::GreaterEqual];
        if !self.within_powers && ORDER.contains(&relation) {
            self.within_powers = true;
            let result = self.attempt(|c| c.by_powers(goal, &ORDER));
            self.within_powers = false;
            if result.is_ok() {
                return Ok(());
            }
        }
        if self.splits < 3 {
            self.splits += 1;
            let result = self.attempt(|c| c.by_contradiction(goal)).or_else(|_| self.attempt(|c| c.by_facts(goal)));
            self.splits -= 1;
            if result.is_ok() {
                return Ok(());
            }
        }
        Err(first)
    }

    /// A fact that compares two numbers and is false.
    fn contradiction(&mut self) -> Option<String> {
        let list = self.facts();
        for (label, fact) in list.into_iter().rev() {
            if let Ok((difference, relation)) = self.checker.difference(&fact)
                && let Some(number) = difference.as_number()
                && !Signs::of_number(number).within(Signs::of(relation))
            {
                return Some(label);
            }
        }
        self.opposite_signs()
    }

    /// A false comparison of numbers from an equation whose sides are known to differ, by the signs noted.
    fn opposite_signs(&mut self) -> Option<String> {
        let list = self.facts();
        for (label, fact) in list.into_iter().rev() {
            let PropKind::Compare(sides, relations) = &fact.kind else { continue };
            let ([a, b], [Relation::Equal]) = (sides.as_slice(), relations.as_slice()) else { continue };
            let Ok((difference, _)) = self.checker.difference(&fact) else { continue };
            let Ok(signs) = self.checker.signs_of(&difference) else { continue };
            if !(signs.within(Signs::NOT_ZERO) && signs.within(Signs::ZERO)) {
                continue;
            }
            let apart = compare(a.clone(), Relation::NotEqual, b.clone());
            let found = self.attempt(|c| {
                let other = c.take(Rule::Sign, &[], Some(apart))?;
                c.difference_of(&label, &other, Relation::NotEqual)
            });
            if let Ok(found) = found {
                return Some(found);
            }
        }
        None
    }

    /// `0 relation 0` from two facts about one difference, which the first less the second gives.
    fn difference_of(&mut self, first: &str, second: &str, relation: Relation) -> Result<String, Fail> {
        let term = |label: &str, factor: Expr| Term { facts: vec![label.to_string()], factor };
        let terms = vec![term(first, numeral(1)), term(second, negated(numeral(1)))];
        self.combination(compare(numeral(0), relation, numeral(0)), None, terms)
    }

    /// Conclusions of implications and equivalences whose premises are seen at once.
    fn saturate(&mut self) -> Result<bool, Fail> {
        let mut changed = false;
        let list = self.facts();
        for (label, fact) in list {
            let pairs: Vec<(Prop, Prop)> = match &fact.kind {
                PropKind::Implies(p, q) => vec![((**p).clone(), (**q).clone())],
                PropKind::Equivalent(parts) => parts
                    .iter()
                    .flat_map(|p| parts.iter().map(move |q| (p.clone(), q.clone())))
                    .filter(|(p, q)| text::prop(p) != text::prop(q))
                    .collect(),
                _ => continue,
            };
            for (p, q) in pairs {
                if self.checker.knows(&q) {
                    continue;
                }
                let splits = std::mem::replace(&mut self.splits, 9);
                let premise = self.attempt(|c| match &p.kind {
                    PropKind::Compare(sides, relations) if relations.len() == 1 => {
                        c.comparison(&sides[0], relations[0], &sides[1])
                    }
                    PropKind::And(parts) => {
                        for part in parts {
                            let PropKind::Compare(sides, relations) = &part.kind else {
                                return Err(Fail::No("deep"));
                            };
                            c.comparison(&sides[0], relations[0], &sides[1])?;
                        }
                        c.take(Rule::All, &[], Some(p.clone())).map(|_| ())
                    }
                    _ => Err(Fail::No("not at once")),
                });
                self.splits = splits;
                if premise.is_ok()
                    && let Ok(new) = self.take(Rule::Apply, std::slice::from_ref(&label), Some(q.clone()))
                {
                    self.suppose(&new, &q)?;
                    changed = true;
                }
            }
        }
        Ok(changed)
    }

    /// A chain of facts with the very same expressions in between, as a sum.
    fn transitive(&mut self, goal: &Prop, a: &Expr, relation: Relation, b: &Expr) -> Result<(), Fail> {
        let (from, to) = match relation {
            Relation::Greater | Relation::GreaterEqual => (a, b),
            Relation::Less | Relation::LessEqual => (b, a),
            _ => return Err(Fail::No("no chain")),
        };
        let mut edges: Vec<(Expr, Expr, String, bool)> = Vec::new();
        for fact in self.checker.facts() {
            let PropKind::Compare(sides, relations) = &fact.prop().kind else { continue };
            let ([x, y], [r]) = (sides.as_slice(), relations.as_slice()) else { continue };
            if matches!(r, Relation::Greater | Relation::GreaterEqual | Relation::Equal) {
                edges.push((x.clone(), y.clone(), fact.label().to_string(), true));
            }
            if matches!(r, Relation::Less | Relation::LessEqual | Relation::Equal) {
                edges.push((y.clone(), x.clone(), fact.label().to_string(), false));
            }
        }
        let mut paths: Vec<(Expr, Vec<(String, bool)>)> = vec![(from.clone(), Vec::new())];
        for _ in 0..5 {
            let mut next = Vec::new();
            for (at, path) in &paths {
                for (x, y, label, forward) in &edges {
                    if x != at || path.iter().any(|p| p.0 == *label) {
                        continue;
                    }
                    let mut longer = path.clone();
                    longer.push((label.clone(), *forward));
                    if y == to {
                        let up = matches!(relation, Relation::Greater | Relation::GreaterEqual);
                        let terms = longer
                            .iter()
                            .map(|(label, forward)| {
                                let one = numeral(1);
                                let factor = if *forward == up { one } else { negated(one) };
                                Term { facts: vec![label.clone()], factor }
                            })
                            .collect();
                        if self.combination(goal.clone(), None, terms).is_ok() {
                            return Ok(());
                        }
                    }
                    next.push((y.clone(), longer));
                }
            }
            next.truncate(200);
            paths = next;
        }
        Err(Fail::No("no chain"))
    }

    fn by_contradiction(&mut self, goal: &Prop) -> Result<(), Fail> {
        let opposite = negation(goal).ok_or("no negation")?;
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(Fail::No("no comparison")) };
        let sides: Vec<&Expr> = sides.iter().collect();
        self.define(&sides)?;
        let either = prop(PropKind::Or(vec![goal.clone(), opposite.clone()]));
        let either = self.take(Rule::Excluded, &[], Some(either))?;
        let same = prop(PropKind::Implies(Box::new(goal.clone()), Box::new(goal.clone())));
        self.block(&same, |_, _| Ok(()))?;
        let other = prop(PropKind::Implies(Box::new(opposite.clone()), Box::new(goal.clone())));
        let (a, relation, b) = (sides[0].clone(), relations[0], sides[1].clone());
        self.block(&other, |c, block| {
            c.suppose(&format!("{block}s"), &opposite)?;
            if c.comparison(&a, relation, &b).is_ok() {
                return Ok(());
            }
            if c.saturate()? && c.comparison(&a, relation, &b).is_ok() {
                return Ok(());
            }
            if let Some(label) = c.contradiction() {
                return c.take(Rule::Absurd, &[label], Some(goal.clone())).map(|_| ());
            }
            c.clash(goal)
        })?;
        self.take(Rule::Cases, &[either], Some(goal.clone())).map(|_| ())
    }

    /// Facts that contradict each other: two that say opposite things of the same difference.
    fn clash(&mut self, goal: &Prop) -> Result<(), Fail> {
        let list = self.facts();
        for (_, fact) in list.iter().rev() {
            let PropKind::Compare(sides, relations) = &fact.kind else { continue };
            if relations.len() != 1 {
                continue;
            }
            // What is said to vanish may be seen not to.
            if relations[0] == Relation::Equal
                && let Ok((difference, _)) = self.checker.difference(fact)
            {
                for poly in difference.factors.keys() {
                    let done = self.attempt(|c| {
                        c.search_again(poly)?;
                        match &goal.kind {
                            PropKind::Compare(g, r) => c.comparison(&g[0], r[0], &g[1]),
                            _ => Err(Fail::No("no comparison")),
                        }
                    });
                    if done.is_ok() {
                        return Ok(());
                    }
                }
            }
            // A fact whose opposite is shown as well.
            let Some(opposite) = negation(fact) else { continue };
            let PropKind::Compare(_, relations) = &opposite.kind else { continue };
            let (a, b) = (sides[0].clone(), sides[1].clone());
            let relation = relations[0];
            if self.attempt(|c| c.comparison(&a, relation, &b)).is_ok() {
                let both = [self.label_of(fact), self.label_of(&opposite)];
                let [Some(x), Some(y)] = both else { continue };
                let wrong = [(&x, &y, Relation::NotEqual), (&x, &y, Relation::Less), (&y, &x, Relation::Less)];
                for (first, second, relation) in wrong {
                    if let Ok(label) = self.difference_of(first, second, relation) {
                        return self.take(Rule::Absurd, &[label], Some(goal.clone())).map(|_| ());
                    }
                }
            }
        }
        Err(Fail::No("no contradiction"))
    }

    /// Cases by a disjunction that is known.
    fn by_facts(&mut self, goal: &Prop) -> Result<(), Fail> {
        let list = self.facts();
        for (label, fact) in list.iter().rev() {
            let PropKind::Or(parts) = &fact.kind else { continue };
            let done = self.attempt(|c| {
                for part in parts {
                    let implication = prop(PropKind::Implies(Box::new(part.clone()), Box::new(goal.clone())));
                    if c.checker.knows(&implication) {
                        continue;
                    }
                    c.block(&implication, |c, block| {
                        c.suppose(&format!("{block}s"), part)?;
                        c.show(goal)
                    })?;
                }
                c.take(Rule::Cases, std::slice::from_ref(label), Some(goal.clone())).map(|_| ())
            });
            if done.is_ok() {
                return Ok(());
            }
        }
        Err(Fail::No("no disjunction helps"))
    }

    fn show_or(&mut self, goal: &Prop, list: &[Prop]) -> Result<(), Fail> {
        let mut exprs = Vec::new();
        exprs_in(goal, &mut exprs);
        self.prepare(&exprs.iter().collect::<Vec<_>>())?;
        self.define(&exprs.iter().collect::<Vec<_>>())?;
        if self.take(Rule::Excluded, &[], Some(goal.clone())).is_ok() {
            return Ok(());
        }
        let splits = std::mem::replace(&mut self.splits, 9);
        for part in list {
            if self.attempt(|c| c.show(part)).is_ok() {
                self.splits = splits;
                return self.take(Rule::Either, &[], Some(goal.clone())).map(|_| ());
            }
        }
        self.splits = splits;
        // Suppose that all but the last are false.
        let (last, others) = list.split_last().ok_or("an empty disjunction")?;
        let (first, rest) = others.split_first().ok_or("a disjunction of one")?;
        let opposite = negation(first).ok_or("no negation")?;
        let either = prop(PropKind::Or(vec![first.clone(), opposite.clone()]));
        let either = self.take(Rule::Excluded, &[], Some(either))?;
        let implies = |p: &Prop, q: &Prop| prop(PropKind::Implies(Box::new(p.clone()), Box::new(q.clone())));
        let direct = implies(first, goal);
        self.block(&direct, |c, _| c.take(Rule::Either, &[], Some(goal.clone())).map(|_| ()))?;
        let other = implies(&opposite, goal);
        self.block(&other, |c, block| {
            c.suppose(&format!("{block}s"), &opposite)?;
            if rest.is_empty() {
                c.show(last)?;
            } else {
                let mut fewer = rest.to_vec();
                fewer.push(last.clone());
                let fewer = prop(PropKind::Or(fewer));
                c.show(&fewer)?;
                let label = c.label_of(&fewer).ok_or("a disjunction")?;
                if let PropKind::Or(parts) = &fewer.kind {
                    for part in parts {
                        c.block(&implies(part, goal), |c, _| {
                            c.take(Rule::Either, &[], Some(goal.clone())).map(|_| ())
                        })?;
                    }
                }
                return c.take(Rule::Cases, &[label], Some(goal.clone())).map(|_| ());
            }
            c.take(Rule::Either, &[], Some(goal.clone())).map(|_| ())
        })?;
        self.take(Rule::Cases, &[either], Some(goal.clone())).map(|_| ())
    }

    fn by_method(&mut self, goal: &Prop, method: &Method) -> Result<(), Fail> {
        match method {
            Method::Algebra(_) => self.show(goal),
            Method::Witness(values) => {
                let values =
                    values.iter().map(|(n, e)| Ok((n.clone(), self.put_expr(e)?))).collect::<Result<Vec<_>, Fail>>()?;
                self.witness(goal, &values)
            }
            Method::Induction(variable, steps) => self.induction(goal, variable, steps),
            Method::Instance { claim, with } => {
                let with =
                    with.iter().map(|(n, e)| Ok((n.clone(), self.put_expr(e)?))).collect::<Result<Vec<_>, Fail>>()?;
                self.instance(&claim.text, with)?;
                self.show(goal)
            }
            Method::Power { fact, exponent } => {
                let exponent = self.put_expr(exponent)?;
                self.power_of(&fact.text, &exponent)?;
                self.show(goal)
            }
            Method::Product(list) => self.product(goal, list),
            Method::Mean { a, b, weight } => {
                let (a, b, p) = (self.put_expr(a)?, self.put_expr(b)?, self.put_expr(weight)?);
                self.mean(&a, &b, &p)?;
                self.show(goal)
            }
            Method::Hoelder { first, second, weight } => {
                let p = self.put_expr(weight)?;
                let pairs = [&first.0, &first.1, &second.0, &second.1].map(|e| self.put_expr(e));
                let [a, b, c, d] = pairs;
                self.hoelder(goal, [a?, b?, c?, d?], &p)
            }
            Method::Squeeze { lower, upper } => {
                let (lower, upper) = (self.put_expr(lower)?, self.put_expr(upper)?);
                self.squeeze(goal, lower, upper)
            }
        }
    }

    fn labelled(&self, label: &str) -> Result<Prop, Fail> {
        let found = self.labels.iter().rev().find(|l| l.0 == label);
        found.map(|l| l.1.clone()).ok_or_else(|| Fail::NoFact(label.to_string()))
    }

    fn witness(&mut self, goal: &Prop, values: &[(Name, Expr)]) -> Result<(), Fail> {
        let PropKind::Exists(bindings, body) = &goal.kind else { return Err(Fail::No("a witness is for `exists`")) };
        let mut map = Substitution::default();
        values.iter().for_each(|(n, e)| map.replace(&n.text, e));
        for fact in bindings.iter().flat_map(domain).chain([(**body).clone()]) {
            let fact = map.prop(&fact).map_err(Fail::from)?;
            self.show(&fact)?;
        }
        self.prepare(&values.iter().map(|v| &v.1).collect::<Vec<_>>())?;
        self.with(Rule::Witness, &[], Some(goal.clone()), values.to_vec()).map(|_| ())
    }

    fn induction(&mut self, goal: &Prop, variable: &Name, steps: &Proof) -> Result<(), Fail> {
        // The bound variable of the induction must be new.
        let mut fresh = format!("{}_step", variable.text);
        while self.checker.variables().iter().any(|v| v.name() == fresh) {
            fresh += "_";
        }
        let statement = self.checker.statement().clone();
        let declared =
            statement.bindings.iter().find(|b| b.names.iter().any(|n| n.0.text == variable.text && n.1.is_none()));
        let constraints: Vec<Constraint> = declared
            .map(|b| b.constraints.clone())
            .unwrap_or_default()
            .into_iter()
            .filter(|c| {
                matches!(c, Constraint::Relation(Relation::GreaterEqual, Expr { kind: ExprKind::Number(_), .. }))
            })
            .collect();
        let base = match constraints.first() {
            Some(Constraint::Relation(_, bound)) => bound.clone(),
            _ => numeral(0),
        };
        let mut map = Substitution::default();
        map.replace(&variable.text, &name(&fresh));
        let body = map.prop(goal).map_err(Fail::from)?;
        let at = |value: &Expr| -> Result<Prop, Fail> {
            let mut map = Substitution::default();
            map.replace(&fresh, value);
            map.prop(&body).map_err(Fail::from)
        };
        let next = expr(ExprKind::Sum(vec![(Sign::Plus, name(&fresh)), (Sign::Plus, numeral(1))]));
        let binding = Binding {
            names: vec![(Name { text: fresh.clone(), span: Span::default() }, None)],
            natural: true,
            constraints,
            indices: None,
            span: Span::default(),
        };
        let every = |body: Prop| prop(PropKind::ForAll(vec![binding.clone()], Box::new(body)));
        let first = at(&base)?;
        self.show(&first).map_err(|e| e.within("base"))?;
        let advance = prop(PropKind::Implies(Box::new(body.clone()), Box::new(at(&next)?)));
        let values = self.values.clone();
        self.values.replace(&variable.text, &name(&fresh));
        let all = every(advance.clone());
        let done = self.block(&all, |c, outer| {
            c.enter(outer)?;
            let mut exprs = Vec::new();
            exprs_in(&body, &mut exprs);
            exprs_in(&at(&next)?, &mut exprs);
            let mut inside = Vec::new();
            exprs_in_proof(steps, &mut inside);
            for e in &inside {
                exprs.push(c.put_expr(e)?);
            }
            c.prepare(&exprs.iter().collect::<Vec<_>>())?;
            let mut premise = Vec::new();
            exprs_in(&body, &mut premise);
            c.define(&premise.iter().collect::<Vec<_>>())?;
            c.block(&advance, |c, inner| {
                c.labels.push(("induction".to_string(), body.clone()));
                c.suppose(&format!("{inner}s"), &body)?;
                c.follow(&at(&next)?, steps)
            })
        });
        self.values = values;
        done?;
        let whole = every(body.clone());
        let label = self.take(Rule::Induction, &[], Some(whole))?;
        let with = vec![named(&fresh, &name(&variable.text))];
        self.with(Rule::Instance, &[label], Some(goal.clone()), with).map(|_| ())
    }

    /// An instance of a cited claim or of a fact, made known with its parts.
    fn instance(&mut self, source: &str, with: Vec<(Name, Expr)>) -> Result<(), Fail> {
        if let Ok(fact) = self.labelled(source) {
            let PropKind::ForAll(bindings, body) = &fact.kind else { return Ok(()) };
            let label = self.label_of(&fact).ok_or("a fact")?;
            let mut map = Substitution::default();
            with.iter().for_each(|(n, e)| map.replace(&n.text, e));
            for fact in bindings.iter().flat_map(domain) {
                let fact = map.prop(&fact).map_err(Fail::from)?;
                self.show(&fact)?;
            }
            let shown = map.prop(body).map_err(Fail::from)?;
            let label = self.with(Rule::Instance, &[label], Some(shown.clone()), with)?;
            return self.suppose(&label, &shown);
        }
        let cited = self.checker.cited_statement(source).ok_or_else(|| Fail::NoProofOf(source.to_string()))?;
        // A variable without a value keeps its name; an obtained name stands for its value.
        let mut with = with;
        for (variable, index) in cited.bindings.iter().flat_map(|b| &b.names) {
            let value = self.put_expr(&name(&variable.text))?;
            let given = with.iter().any(|w| w.0.text == variable.text);
            if index.is_none() && !given && !matches!(&value.kind, ExprKind::Name(n) if *n == variable.text) {
                with.push((variable.clone(), value));
            }
        }
        let mut map = Substitution::default();
        for (variable, value) in &with {
            let family =
                cited.bindings.iter().any(|b| b.names.iter().any(|n| n.0.text == variable.text && n.1.is_some()));
            match (&value.kind, family) {
                (ExprKind::Name(other), true) => map.rename_family(&variable.text, other),
                _ => map.replace(&variable.text, value),
            }
        }
        self.prepare(&with.iter().map(|v| &v.1).collect::<Vec<_>>())?;
        self.define(&with.iter().map(|v| &v.1).collect::<Vec<_>>())?;
        for fact in cited.bindings.iter().flat_map(domain).chain(cited.assumptions.iter().cloned()) {
            let fact = map.prop(&fact).map_err(Fail::from)?;
            self.show(&fact).map_err(|e| e.within(source))?;
        }
        let shown = map.prop(&cited.goal).map_err(Fail::from)?;
        let label = self.with(Rule::Instance, &[source.to_string()], Some(shown.clone()), with)?;
        self.suppose(&label, &shown)
    }

    /// A fact with both sides to a power.
    fn power_of(&mut self, fact: &str, exponent: &Expr) -> Result<(), Fail> {
        let fact = self.labelled(fact)?;
        let PropKind::Compare(sides, relations) = &fact.kind else { return Err(Fail::No("a comparison is needed")) };
        let label = self.label_of(&fact).ok_or("a fact")?;
        for e in sides.iter().chain([exponent]) {
            self.show(&compare(e.clone(), Relation::Greater, numeral(0)))?;
        }
        self.raised(&label, (&sides[0], relations[0], &sides[1]), exponent)
    }

    /// Both sides of a known comparison to a power; that they and the exponent are positive is seen.
    fn raised(&mut self, label: &str, (x, relation, y): (&Expr, Relation, &Expr), exponent: &Expr) -> Result<(), Fail> {
        let (a, b) = (power(x, exponent), power(y, exponent));
        self.prepare(&[&a, &b])?;
        let shown = compare(a, relation, b);
        let with = vec![named("exponent", exponent)];
        let label = self.with(Rule::Monotone, &[label.to_string()], Some(shown.clone()), with)?;
        self.suppose(&label, &shown)
    }

    /// The product of comparisons between positive sides, by telescoping.
    fn product(&mut self, goal: &Prop, list: &[(Name, Option<Expr>)]) -> Result<(), Fail> {
        let mut pairs = Vec::new();
        let mut strict = false;
        for (fact, exponent) in list {
            if exponent.is_some() {
                return Err(Fail::No("powers in a product"));
            }
            let fact = self.labelled(&fact.text)?;
            let PropKind::Compare(sides, relations) = &fact.kind else { return Err(Fail::No("a comparison")) };
            let label = self.label_of(&fact).ok_or("a fact")?;
            strict |= matches!(relations[0], Relation::Greater | Relation::Less);
            let up = matches!(relations[0], Relation::Greater | Relation::GreaterEqual);
            let (high, low) = if up { (&sides[0], &sides[1]) } else { (&sides[1], &sides[0]) };
            self.prepare(&[high, low])?;
            self.unfold_all(&[high, low])?;
            pairs.push((high.clone(), low.clone(), label, up));
        }
        let highs: Vec<Expr> = pairs.iter().map(|p| p.0.clone()).collect();
        let lows: Vec<Expr> = pairs.iter().map(|p| p.1.clone()).collect();
        let (a, b) = (write::quotient(highs.clone(), Vec::new()), write::quotient(lows.clone(), Vec::new()));
        let relation = if strict { Relation::Greater } else { Relation::GreaterEqual };
        let mut terms = Vec::new();
        for (place, (_, _, label, up)) in pairs.iter().enumerate() {
            let mut factors: Vec<Expr> = lows.iter().take(place).cloned().collect();
            factors.extend(highs.iter().skip(place + 1).cloned());
            let factor = write::quotient(factors, Vec::new());
            let factor = if *up { factor } else { negated(factor) };
            terms.push(Term { facts: vec![label.clone()], factor });
        }
        let shown = compare(a, relation, b);
        let label = self.combination(shown.clone(), None, terms)?;
        self.suppose(&label, &shown)?;
        self.show(goal)
    }

    /// The weighted mean inequality, strict where the kernel sees that it is.
    fn mean(&mut self, a: &Expr, b: &Expr, p: &Expr) -> Result<(String, bool), Fail> {
        let rest = one_minus(p);
        for e in [a, b] {
            self.show(&compare(e.clone(), Relation::Greater, numeral(0)))?;
            let f = self.checker.scalar(e).map_err(Fail::from)?;
            for poly in f.factors.keys() {
                let _ = self.settle(poly, 2);
            }
        }
        for e in [p, &rest] {
            let positive = compare(e.clone(), Relation::Greater, numeral(0));
            if self.attempt(|c| c.show(&positive)).is_err() {
                self.show(&compare(e.clone(), Relation::GreaterEqual, numeral(0)))?;
            }
        }
        let apart = compare(a.clone(), Relation::NotEqual, b.clone());
        let strict = self.attempt(|c| c.comparison(a, Relation::NotEqual, b)).is_ok()
            || self.attempt(|c| c.by_powers(&apart, &[Relation::NotEqual])).is_ok();
        self.prepare(&[&product(vec![power(a, &rest), power(b, p)])])?;
        let with = vec![named("a", a), named("b", b), named("p", p)];
        for (relation, possible) in [(Relation::Less, strict), (Relation::LessEqual, true)] {
            if possible {
                let shown = weighted_mean(a, b, p, relation);
                if let Ok(label) = self.with(Rule::Mean, &[], Some(shown.clone()), with.clone()) {
                    self.suppose(&label, &shown)?;
                    return Ok((label, relation == Relation::Less));
                }
            }
        }
        Err(Fail::No("the mean inequality"))
    }

    /// A comparison of values that are powers of others, from a fact that compares those.
    fn by_powers(&mut self, goal: &Prop, wanted: &[Relation]) -> Result<(), Fail> {
        let PropKind::Compare(goal_sides, goal_relations) = &goal.kind else { return Err(Fail::No("no comparison")) };
        let goal_relation = goal_relations[0];
        let list = self.facts();
        for (label, fact) in list.iter().rev() {
            let PropKind::Compare(sides, relations) = &fact.kind else { continue };
            let ([x, y], [relation]) = (sides.as_slice(), relations.as_slice()) else { continue };
            if !wanted.contains(relation) {
                continue;
            }
            let Ok(f) = self.checker.scalar(x) else { continue };
            for exponent in self.exponents_of(&f) {
                let done = self.attempt(|c| {
                    // Not every exponent is positive; that has to be seen at once.
                    c.comparison(&exponent, Relation::Greater, &numeral(0))?;
                    c.raised(label, (x, *relation, y), &exponent)?;
                    c.comparison(&goal_sides[0], goal_relation, &goal_sides[1])
                });
                if done.is_ok() {
                    return Ok(());
                }
            }
        }
        Err(Fail::No("no power of a fact helps"))
    }

    /// (a+b)^(1−p) (c+d)^p ≥ a^(1−p) c^p + b^(1−p) d^p: the mean of a/(a+b) and c/(c+d), that of b/(a+b)
    /// and d/(c+d), added.
    fn hoelder(&mut self, goal: &Prop, [a, b, c, d]: [Expr; 4], p: &Expr) -> Result<(), Fail> {
        let plus = |x: &Expr, y: &Expr| sum(vec![(Sign::Plus, x.clone()), (Sign::Plus, y.clone())]);
        let times = |x: Expr, y: Expr| product(vec![x, y]);
        let over = |x: &Expr, y: &Expr| write::quotient(vec![x.clone()], vec![y.clone()]);
        let rest = one_minus(p);
        let (ab, cd) = (plus(&a, &b), plus(&c, &d));
        let big = times(power(&ab, &rest), power(&cd, p));
        let small = plus(&times(power(&a, &rest), power(&c, p)), &times(power(&b, &rest), power(&d, p)));
        let means = [(over(&a, &ab), over(&c, &cd)), (over(&b, &ab), over(&d, &cd))];
        let mut all = vec![big.clone(), small.clone()];
        for (x, y) in &means {
            all.push(power(x, &rest));
            all.push(power(y, p));
        }
        self.prepare(&all.iter().collect::<Vec<_>>())?;
        let mut terms = Vec::new();
        let mut strict = false;
        for (x, y) in &means {
            let (label, is_strict) = self.mean(x, y, p)?;
            strict |= is_strict;
            terms.push(Term { facts: vec![label], factor: negated(big.clone()) });
        }
        let relation = if strict { Relation::Greater } else { Relation::GreaterEqual };
        let shown = compare(big, relation, small);
        let label = self.combination(shown.clone(), None, terms)?;
        self.suppose(&label, &shown)?;
        self.show(goal)
    }

    fn extremum(&mut self, goal: &Prop, e: &Extremum) -> Result<(), Fail> {
        let mut at = Substitution::default();
        e.at.iter().for_each(|(n, v)| at.replace(&n.text, v));
        for fact in e.over.iter().flat_map(domain) {
            let fact = at.prop(&fact).map_err(Fail::from)?;
            self.show(&fact)?;
        }
        self.show(&compare(at.expr(&e.of).map_err(Fail::from)?, Relation::Equal, e.value.clone()))?;
        let every = |body: Prop| prop(PropKind::ForAll(e.over.clone(), Box::new(body)));
        let relation = if e.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
        self.show(&every(compare(e.of.clone(), relation, e.value.clone())))?;
        if e.unique {
            let there = at_the_point(e).ok_or("an extremum has a point")?;
            let equal = compare(e.of.clone(), Relation::Equal, e.value.clone());
            self.show(&every(prop(PropKind::Implies(Box::new(equal), Box::new(there)))))?;
        }
        self.take(Rule::Extremum, &[], Some(goal.clone())).map(|_| ())
    }

    fn squeeze(&mut self, goal: &Prop, lower: Expr, upper: Expr) -> Result<(), Fail> {
        let PropKind::Limit(limit) = &goal.kind else { return Err(Fail::No("`squeeze` is for limits")) };
        for bound in [&lower, &upper] {
            let same = Limit { of: bound.clone(), ..(**limit).clone() };
            self.show(&prop(PropKind::Limit(Box::new(same))))?;
        }
        self.show(&compare(lower.clone(), Relation::LessEqual, limit.of.clone()))?;
        self.show(&compare(limit.of.clone(), Relation::LessEqual, upper.clone()))?;
        let with = vec![named("lower", &lower), named("upper", &upper)];
        self.with(Rule::Squeeze, &[], Some(goal.clone()), with).map(|_| ())
    }
}

/// A step of an argument, which is not a step of a certificate.
use crate::claim::syntax::Step as Step_;

fn is_matrix(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Matrix(_) => true,
        ExprKind::Apply(f, _) => f.text == "transpose",
        ExprKind::Negate(a) => is_matrix(a),
        ExprKind::Sum(list) => list.iter().any(|(_, e)| is_matrix(e)),
        ExprKind::Product(list) => list.iter().any(|(_, e)| is_matrix(e)),
        _ => false,
    }
}

/// The sides of every comparison in a proposition, but for those under quantifiers.
fn exprs_in(p: &Prop, out: &mut Vec<Expr>) {
    match &p.kind {
        PropKind::Compare(sides, _) => out.extend(sides.iter().cloned()),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| exprs_in(p, out));
        }
        PropKind::Not(inner) => exprs_in(inner, out),
        PropKind::Implies(a, b) => {
            exprs_in(a, out);
            exprs_in(b, out);
        }
        PropKind::Exists(..) | PropKind::ForAll(..) => {}
        PropKind::Extremum(e) => {
            out.extend(e.at.iter().map(|a| a.1.clone()));
            out.push(e.value.clone());
        }
        PropKind::Limit(l) => out.extend([l.of.clone(), l.value.clone()]),
    }
}

/// Every expression of an argument whose powers will be met.
fn exprs_in_proof(proof: &Proof, out: &mut Vec<Expr>) {
    let mut names = BTreeSet::new();
    for step in &proof.steps {
        match step {
            Step_::Have { prop, proof, .. } | Step_::Case { prop, proof, .. } => {
                exprs_in(prop, out);
                exprs_in_proof(proof, out);
            }
            Step_::Obtain { witness, binding, .. } => {
                out.push(witness.clone());
                names.extend(binding.names.iter().map(|n| n.0.text.clone()));
            }
        }
    }
    match &proof.close {
        Some(Method::Mean { a, b, weight }) => out.extend([power(a, &one_minus(weight)), power(b, weight)]),
        Some(Method::Hoelder { first, second, weight }) => {
            let rest = one_minus(weight);
            for (x, e) in [(&first.0, &rest), (&first.1, &rest), (&second.0, weight), (&second.1, weight)] {
                out.push(power(x, e));
            }
        }
        Some(Method::Squeeze { lower, upper }) => out.extend([lower.clone(), upper.clone()]),
        Some(Method::Instance { with, .. }) => out.extend(with.iter().map(|w| w.1.clone())),
        _ => {}
    }
}
