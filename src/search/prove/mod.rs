//! The search for proofs. It asks the kernel about every step, and proves what a claim's own argument states (`argument`) by
//! the same methods as the goal.
//!
//! Contract: [`certificate()`] returns a certificate that the kernel accepted, or says what it could not prove. Nothing here
//! is trusted: the kernel rejects a wrong step, and `carom check` checks the certificate again from its text.
//!
//! Method: a goal is split at its connectives into comparisons. Every root, power, sum and member of a sequence is
//! treated as a variable, called a *letter*. Each fact becomes a polynomial in the letters that is 0, positive or not
//! negative. A linear program finds products of these polynomials that add up to the goal, or to a contradiction with
//! the goal's opposite (`products`). If that fails, the search distinguishes cases and tries induction. `brief` shortens
//! what was found.

mod absolute;
mod alternating;
mod angles;
mod antiderivatives;
mod arcs;
mod argument;
mod asymptotic_bounds;
mod asymptotic_form;
mod asymptotic_limits;
mod at_once;
mod boxes;
mod branching;
mod brief;
mod cases;
mod chains;
mod circle;
mod closed_members;
mod coefficients;
mod cofactors;
mod columns;
mod comparison;
mod completed_squares;
mod conditions;
mod conjugates;
mod contraction;
mod contraction_regions;
mod denesting;
mod differences;
mod elimination;
mod eventually;
mod existence;
mod expansion_steps;
mod expansions;
mod exponent_lattice;
mod exponents;
mod extrema;
mod facts;
mod fail;
mod far_members;
mod formulas;
mod found_limits;
mod fourier_motzkin;
mod goals;
mod growing_sums;
mod halved_sums;
mod hoelder;
mod homogeneous;
mod hypergeometric;
mod ideal;
mod induction;
mod instances;
mod integers;
mod integral_test;
mod integrals;
mod intermediate;
mod invariants;
mod jensen;
mod lattice;
mod letters;
mod limits;
mod logarithms;
mod means;
mod members;
mod methods;
mod narrowing;
mod parameters;
mod partial_fractions;
mod parts_of_pi;
mod powers;
mod powers_of_bases;
mod powers_of_sides;
mod products;
mod quarters;
mod radicals;
mod ranges;
mod ratio_inductions;
mod ratios;
mod refutation;
mod residues;
mod root_bounds;
mod roots_of_sides;
mod scaling;
mod sign_charts;
mod signs_of_divisors;
mod signs_of_parts;
mod slopes;
mod solutions;
mod solved_equations;
mod squares;
mod steps_of_sums;
mod strengthening;
mod substitutions;
mod sums;
mod sums_of_squares;
mod tails;
mod tangent_sums;
mod tangents;
mod taylor;
mod taylor_bounds;
mod telescoping;
#[cfg(test)]
mod tests;
mod trial_points;
mod turning_values;
mod universal;
mod values;
mod witnesses;

use crate::algebra::Moment;
use crate::certificate::{Certificate, Label, Rule, Show, Step, Term};
use crate::claim::syntax::{Claim, Expr, PI, Proof, Prop, PropKind, Relation, is_built_in};
use crate::kernel::fraction::Watch;
use crate::kernel::statement::prop;
use crate::kernel::substitution::Substitution;
use crate::kernel::{Accepted, Checker, Mark, Refusal};
use crate::refute::catalogue::Limits;
use crate::refute::expand;
use crate::refute::outcome::Remaining;
use argument::Named;
pub(crate) use at_once::at_once;
pub(crate) use eventually::{eventual, inside, under_root};
pub use fail::Fail;
pub(crate) use found_limits::value_of_limit;
pub(crate) use goals::together;
pub(crate) use integrals::with_values_of_integrals;
use letters::Letters;
pub(crate) use limits::turns;
pub use methods::names as methods;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::rc::Rc;

/// How many search steps ([`Limits::steps`]) one step that is tried counts as.
const STEPS_OF_A_TRY: usize = 20;

/// Largest number of steps tried for one claim.
const TRIES: usize = 2_000;

/// Largest total size of all linear programs for one claim. The size of one is its number of columns times the
/// number of nonzero entries (see `spend`).
const PROGRAMS: usize = 5_000_000;

/// A certificate of a claim; `cited` holds the accepted claims that it cites.
///
/// # Errors
/// What could not be proved.
pub fn certificate(claim: &Claim, cited: &[&Accepted], limits: &Limits) -> Result<(Certificate, Accepted), Fail> {
    at_once(claim, cited, limits).or_else(|_| match by_search(claim, cited, limits) {
        Ok(found) => Ok((found.certificate, found.accepted)),
        Err(missed) => Err(missed.fail),
    })
}

/// A certificate that the search found.
pub(crate) struct Found {
    pub(crate) certificate: Certificate,
    pub(crate) accepted: Accepted,
    /// The methods that showed its comparisons, each once.
    pub(crate) by: Vec<&'static str>,
}

/// What the search says of a claim that it did not prove.
pub(crate) struct Missed {
    pub(crate) fail: Fail,
    /// The goals that remained.
    pub(crate) remaining: Vec<Remaining>,
}

impl From<Fail> for Missed {
    fn from(fail: Fail) -> Missed {
        Missed { fail, remaining: Vec::new() }
    }
}

/// A certificate of a claim that [`at_once`] cannot prove: by the argument in its file, or else without it in the time that is
/// left.
///
/// # Errors
/// What could not be proved.
pub(crate) fn by_search(claim: &Claim, cited: &[&Accepted], limits: &Limits) -> Result<Found, Missed> {
    let argument = expand::Statement::of(claim).map_err(|limit| Fail::Limit(limit.0))?;
    let deadline = Moment::now().checked_add(limits.time);
    let by = |proof: &Proof| {
        let mut prover = Prover::new(claim, cited, limits, deadline)?;
        // The hypotheses come after the domains of the variables, and before what is added to them.
        let given = prover.facts();
        let hypotheses = given.iter().skip(given.len().saturating_sub(argument.assumptions.len()));
        let labels = argument.assumptions.iter().zip(hypotheses).filter_map(|(a, g)| Some((a.0.clone()?, g.0.clone())));
        let labels = labels.collect();
        let goal = prover.checker.statement().goal.clone();
        let mut exprs = Vec::new();
        prover.checker.statement().assumptions.iter().for_each(|p| goals::sides_in(p, &mut exprs));
        goals::sides_in(&goal, &mut exprs);
        argument::exprs_in(&argument.proof, &goals::sides_in, &mut exprs);
        prover.write_powers(&exprs.iter().collect::<Vec<_>>());
        let given = prover.facts();
        prover.name_integers();
        for (label, fact) in &given {
            prover.take_in(label, fact)?;
        }
        let shown = match prover.follow(&goal, proof, &Named::hypotheses(labels)) {
            Ok(shown) => shown,
            Err(fail) => {
                let fail = match prover.exhausted() {
                    Some(limit) => fail.for_want_of(limit),
                    None => fail,
                };
                return Err(Missed { fail: fail.of_goal(&goal), remaining: prover.remaining });
            }
        };
        let mut by: Vec<&'static str> = Vec::new();
        for name in &prover.found_by {
            if !by.contains(name) {
                by.push(name);
            }
        }
        let (certificate, accepted) = prover.concluded(claim, &shown, cited, limits)?;
        Ok(Found { certificate, accepted, by })
    };
    match by(&argument.proof) {
        Err(missed) if !argument.proof.is_empty() && missed.fail.limit() != Some("time") => {
            by(&Proof::default()).map_err(|_| missed)
        }
        other => other,
    }
}

/// What the facts in force have told: see the fields of [`Prover`] of the same names.
struct Told {
    equations: Vec<Label>,
    naturals: Vec<String>,
    enriched: BTreeSet<String>,
    roots: usize,
    powers: Rc<powers::Powers>,
}

/// Where the search stood before an attempt.
struct State {
    told: Told,
    mark: Mark,
    steps: usize,
    found_by: usize,
    splits: usize,
    inductions: usize,
}

/// The state of the search.
pub(crate) struct Prover {
    checker: Checker,
    steps: Vec<Step>,
    counter: usize,
    letters: Letters,
    /// For each fact, the difference of its sides as a polynomial. The key is the fact's label and the list of
    /// equations substituted when it was read.
    readings: HashMap<(Label, Vec<Label>), Option<facts::Reading>>,
    /// Whether a step may use the signs of the fact with this label (`signs`).
    speaking: HashMap<Label, bool>,
    /// Labels of the equations that the kernel substitutes in every step.
    equations: Vec<Label>,
    /// The variables that are natural numbers.
    naturals: Vec<String>,
    /// The integers, each with the difference of natural numbers that it is.
    integers: Vec<(String, Expr)>,
    /// Names in use.
    names: BTreeSet<String>,
    /// Those of the claim.
    own_names: BTreeSet<String>,
    /// Expressions of letters for which `values` has already added facts.
    enriched: BTreeSet<String>,
    /// Expressions of letters for which no fact could be added in the open blocks.
    failed: BTreeSet<String>,
    /// The bases of even powers in goals and facts, before multiplying out.
    squares_written: Vec<crate::algebra::Polynomial>,
    /// Roots of numbers for which facts were added.
    roots: Vec<Expr>,
    /// The powers by which others are written.
    powers: Rc<powers::Powers>,
    deadline: Option<Moment>,
    /// The names of methods that are left out.
    without: Vec<String>,
    /// The methods that showed the comparisons so far, each after those of its parts.
    found_by: Vec<&'static str>,
    /// The first goals that no method showed.
    remaining: Vec<Remaining>,
    /// The number of comparisons within which the search is.
    within_comparisons: usize,
    /// Number of steps, linear programs and the like tried, in all.
    ticks: usize,
    /// An evaluation was not carried out, since the time was not enough.
    is_short: bool,
    tries: usize,
    most_tries: usize,
    /// Total size of the linear programs so far, limited by [`PROGRAMS`].
    spent: usize,
    /// Semidefinite programs without an answer.
    failed_programs: HashSet<crate::algebra::semidefinite::Program>,
    /// The operations that semidefinite programs may still take.
    program_work: usize,
    /// What was asked about ideals.
    ideals: ideal::Asked,
    /// Number of nested case distinctions.
    splits: usize,
    /// The facts `exists` of which a name for what exists was introduced.
    opened: Vec<Label>,
    /// Number of nested inductions.
    inductions: usize,
    /// Number of members that are being unfolded, each within the one before.
    unfoldings: usize,
    /// Number of comparisons tried by the sign of a derivative.
    slopes: usize,
    /// Number of sign charts so far.
    charts: usize,
    /// How many more goals may be tried at stationary points.
    stationary: usize,
    /// How many exponentials are put in for what grows.
    exponentials: usize,
    /// The place of the extremum whose bound is being shown.
    extremal_place: Vec<(String, Expr)>,
    /// Number of such attempts that are nested now.
    slopes_open: usize,
    /// Signs of divisors that were shown for all values of a natural variable.
    signs_for_all: Vec<Label>,
    /// Whether powers of facts are tried.
    within_powers: bool,
    /// Whether the members of a goal's sums are compared.
    in_members: bool,
    /// The goals whose sums were compared so.
    compared: BTreeSet<String>,
    /// The number of roots isolated within one another, where roots are compared with all effort.
    roots_in_full: Option<usize>,
    /// Whether an equation or order of arcs is tried.
    within_arcs: bool,
    /// Whether the logarithms of a goal's sides are compared.
    within_logarithms: bool,
    /// Whether the remainders of a natural number are distinguished.
    in_residues: bool,
    /// Whether Bernoulli's inequality is being shown, which needs no other inequality between powers.
    in_bernoulli: bool,
    /// Whether whole numbers are tried one by one.
    in_boxes: bool,
    /// How many more such searches may fail.
    box_searches: usize,
    /// Number of parameters whose signs are distinguished for a limit.
    parameters: usize,
}

/// Lets the kernel work until a deadline: the kernel itself looks at no clock.
pub(crate) fn until(deadline: Option<Moment>) -> Option<Watch> {
    deadline.map(|deadline| Watch(Rc::new(move || Moment::now() <= deadline)))
}

/// The end of a part of the time until a deadline.
fn within(deadline: Option<Moment>, parts: u32) -> Option<Moment> {
    let now = Moment::now();
    deadline.and_then(|end| now.checked_add(end.after(now) / parts))
}

/// How often an evaluation is carried out until its certificate is written.
const EVALUATIONS: u32 = 5;

impl Prover {
    /// A search that knows the hypotheses of a claim.
    fn new(claim: &Claim, cited: &[&Accepted], limits: &Limits, deadline: Option<Moment>) -> Result<Prover, Fail> {
        let mut checker = Checker::new(claim, cited).map_err(Fail::from)?;
        checker.watched_by(until(deadline));
        let statement = checker.statement();
        let natural = statement.bindings.iter().filter(|b| b.natural).flat_map(|b| &b.names);
        Ok(Prover {
            naturals: natural.map(|n| n.0.text.clone()).collect(),
            integers: Vec::new(),
            names: statement.names(),
            own_names: statement.names(),
            checker,
            steps: Vec::new(),
            counter: 0,
            letters: Letters::default(),
            readings: HashMap::new(),
            speaking: HashMap::new(),
            equations: Vec::new(),
            enriched: BTreeSet::new(),
            failed: BTreeSet::new(),
            squares_written: Vec::new(),
            roots: Vec::new(),
            powers: Rc::default(),
            deadline,
            without: limits.without.clone(),
            found_by: Vec::new(),
            remaining: Vec::new(),
            within_comparisons: 0,
            ticks: 0,
            is_short: false,
            tries: 0,
            most_tries: limits.steps.div_ceil(STEPS_OF_A_TRY).min(TRIES),
            spent: 0,
            failed_programs: HashSet::new(),
            program_work: sums_of_squares::WORK,
            ideals: ideal::Asked::nothing(),
            splits: 0,
            opened: Vec::new(),
            inductions: 0,
            unfoldings: 0,
            slopes: 0,
            charts: 0,
            stationary: slopes::STATIONARY,
            exponentials: 0,
            extremal_place: Vec::new(),
            slopes_open: 0,
            signs_for_all: Vec::new(),
            within_powers: false,
            in_members: false,
            compared: BTreeSet::new(),
            roots_in_full: None,
            within_arcs: false,
            within_logarithms: false,
            in_residues: false,
            in_bernoulli: false,
            in_boxes: false,
            box_searches: boxes::SEARCHES,
            parameters: 0,
        })
    }

    /// Every goal of an argument may cost what a claim without an argument may.
    fn renew(&mut self) {
        (self.tries, self.spent, self.slopes) = (0, 0, 0);
        self.program_work = sums_of_squares::WORK;
        self.box_searches = boxes::SEARCHES;
        self.ideals.renew();
    }

    /// Runs a part of the search with the effort of a claim of its own, which is not taken from what follows.
    fn on_its_own<T>(&mut self, run: impl FnOnce(&mut Self) -> Result<T, Fail>) -> Result<T, Fail> {
        let (tries, spent, slopes) = (self.tries, self.spent, self.slopes);
        self.renew();
        let shown = self.attempt(run);
        (self.tries, self.spent, self.slopes) = (tries, spent, slopes);
        shown
    }

    /// The certificate of a claim whose goal this fact states.
    fn concluded(
        mut self,
        claim: &Claim,
        shown: &str,
        cited: &[&Accepted],
        limits: &Limits,
    ) -> Result<(Certificate, Accepted), Fail> {
        let statement = self.checker.statement().clone();
        // The goal is what the last step shows; a goal that is a hypothesis is said once more.
        match end_of(&self.steps, shown) {
            Some(end) => self.steps.truncate(end),
            None => {
                self.emit(Rule::Logic { from: vec![shown.to_string()] }, statement.goal.clone())?;
            }
        }
        let digest = crate::certificate::text::digest(&statement.text());
        let whole = Certificate { claim: claim.name.text.clone(), statement: digest, refutes: None, steps: self.steps };
        at_once::accepted(claim, whole, cited, limits)
    }

    /// Whether the time is over.
    fn is_late(&self) -> bool {
        self.deadline.is_some_and(|deadline| Moment::now() > deadline)
    }

    fn tick(&mut self) -> Result<(), Fail> {
        self.tries += 1;
        self.ticks += 1;
        if self.is_late() {
            return Err(Fail::Limit("time"));
        }
        if self.tries > self.most_tries { Err(Fail::Limit("steps")) } else { Ok(()) }
    }

    /// Runs a method with half of the steps and of the time that are left, so that another can follow.
    fn with_half<T>(&mut self, run: impl FnOnce(&mut Self) -> Result<T, Fail>) -> Result<T, Fail> {
        let most = self.most_tries;
        self.most_tries -= most.saturating_sub(self.tries) / 2;
        let result = self.with_half_of_the_time(run);
        self.most_tries = most;
        result
    }

    /// Runs a method with half of the time that is left.
    fn with_half_of_the_time<T>(&mut self, run: impl FnOnce(&mut Self) -> Result<T, Fail>) -> Result<T, Fail> {
        let deadline = self.deadline;
        self.deadline = within(deadline, 2);
        self.checker.watched_by(until(self.deadline));
        let result = self.attempt(run);
        self.deadline = deadline;
        self.checker.watched_by(until(deadline));
        result
    }

    /// The limit that ended the search, if the user's own did.
    fn exhausted(&self) -> Option<Fail> {
        if self.is_short || self.is_late() {
            return Some(Fail::Limit("time"));
        }
        (self.tries > self.most_tries && self.most_tries < TRIES).then_some(Fail::Limit("steps"))
    }

    /// Adds a step if the kernel accepts it, citing only what the kernel looks at. Returns the label of the new fact.
    fn emit(&mut self, rule: Rule, shown: Prop) -> Result<Label, Fail> {
        self.tick()?;
        let evaluates = matches!(rule, Rule::Evaluate);
        if evaluates {
            self.checker.watched_by(until(within(self.deadline, EVALUATIONS)));
        }
        let by = self.signs();
        let show = Show { label: self.next_label(), rule, prop: shown, by, using: self.equations.clone() };
        let step = match brief::take(&mut self.checker, show.clone()) {
            Err(_) if !show.using.is_empty() => brief::take(&mut self.checker, Show { using: Vec::new(), ..show }),
            other => other,
        };
        if evaluates {
            self.checker.watched_by(until(self.deadline));
            self.is_short = self.is_short || matches!(step, Err(Refusal::Limit(_)));
        }
        Ok(self.taken(step.map_err(Fail::from)?))
    }

    /// The label of the next step.
    fn next_label(&self) -> Label {
        format!("{}", self.counter + 1)
    }

    /// Keeps a step that the kernel has accepted.
    fn taken(&mut self, step: Step) -> Label {
        let label = self.next_label();
        self.counter += 1;
        self.steps.push(step);
        label
    }

    /// Adds the size of a linear program with these columns to the total.
    fn spend(&mut self, columns: &[products::Known]) -> Result<(), Fail> {
        self.ticks += 1;
        self.spent += columns.len() * columns.iter().map(|c| c.poly.term_count()).sum::<usize>();
        if self.spent > PROGRAMS { Err(Fail::Limit("linear programs")) } else { Ok(()) }
    }

    fn combination(&mut self, shown: Prop, terms: Vec<Term>) -> Result<Label, Fail> {
        // The kernel takes it where facts contradict each other, but then `0 > 0` by one of these is what to say.
        if terms.is_empty() && self.denies_an_identity(&shown) {
            return Err(Fail::No("a comparison that can hold"));
        }
        self.emit(Rule::Combination { times: None, terms }, shown)
    }

    /// A combination that is an identity of polynomials: no sign is asked and no equation put in, unless it fails without.
    fn identity(&mut self, shown: Prop, terms: Vec<Term>) -> Result<Label, Fail> {
        self.tick()?;
        let rule = Rule::Combination { times: None, terms };
        let (by, using) = (Vec::new(), Vec::new());
        let step =
            Step::Show(Box::new(Show { label: self.next_label(), rule: rule.clone(), prop: shown.clone(), by, using }));
        match self.checker.step(&step) {
            Ok(()) => Ok(self.taken(step)),
            Err(_) => self.emit(rule, shown),
        }
    }

    fn logic(&mut self, from: &[&str], shown: &Prop) -> Result<Label, Fail> {
        self.emit(Rule::Logic { from: from.iter().map(|l| (*l).to_string()).collect() }, shown.clone())
    }

    /// Whether a comparison says that one side lies strictly above the other, and both are the same with the equations put in.
    fn denies_an_identity(&mut self, p: &Prop) -> bool {
        let Some((a, Relation::Less | Relation::Greater | Relation::NotEqual, b)) = p.single() else {
            return false;
        };
        !self.equations.is_empty() && self.is_zero(&facts::minus(a, b))
    }

    /// What the facts in force have told so far.
    fn told(&self) -> Told {
        Told {
            equations: self.equations.clone(),
            naturals: self.naturals.clone(),
            enriched: self.enriched.clone(),
            roots: self.roots.len(),
            powers: self.powers.clone(),
        }
    }

    /// Forgets what was told after this.
    fn forget(&mut self, told: Told) {
        self.equations = told.equations;
        self.naturals = told.naturals;
        self.enriched = told.enriched;
        self.roots.truncate(told.roots);
        self.powers = told.powers;
    }

    /// Runs a part of the search; if it fails, restores the state before it.
    fn attempt<T>(&mut self, run: impl FnOnce(&mut Self) -> Result<T, Fail>) -> Result<T, Fail> {
        let state = self.state();
        let result = run(self);
        if result.is_err() {
            self.back_to(state);
        }
        result
    }

    fn state(&self) -> State {
        State {
            told: self.told(),
            mark: self.checker.mark(),
            steps: self.steps.len(),
            found_by: self.found_by.len(),
            splits: self.splits,
            inductions: self.inductions,
        }
    }

    fn back_to(&mut self, state: State) {
        self.forget(state.told);
        self.checker.back_to(&state.mark);
        self.steps.truncate(state.steps);
        self.found_by.truncate(state.found_by);
        (self.splits, self.inductions) = (state.splits, state.inductions);
    }

    /// Proves an implication or a `for all` statement in a block.
    fn block(&mut self, goal: &Prop, run: impl FnOnce(&mut Self, &str) -> Result<Label, Fail>) -> Result<Label, Fail> {
        if let Some(label) = self.known(goal) {
            return Ok(label);
        }
        let told = self.told();
        let (block, failed) = self.open_block(goal)?;
        let conclusion = run(self, &block);
        self.failed = failed;
        self.close_block(conclusion?)?;
        self.forget(told);
        Ok(block)
    }

    /// Opens a block for a goal and takes in what it supposes; its label, and what had failed outside.
    fn open_block(&mut self, goal: &Prop) -> Result<(Label, BTreeSet<String>), Fail> {
        let rule = if matches!(goal.kind, PropKind::ForAll(..)) { Rule::Let } else { Rule::Suppose };
        let block = self.emit(rule, goal.clone())?;
        let failed = std::mem::take(&mut self.failed);
        // What is supposed may tell signs of cosines and sines.
        self.enriched.retain(|letter| !letter.starts_with("cos(") && !letter.starts_with("sin("));
        if let PropKind::ForAll(bindings, _) = &goal.kind {
            for binding in bindings.iter().filter(|b| b.natural) {
                self.naturals.extend(binding.names.iter().map(|n| n.0.text.clone()));
            }
        }
        let new: Vec<(Label, Rc<Prop>)> = self
            .checker
            .facts()
            .filter(|(label, _)| label.strip_prefix(block.as_str()).is_some_and(|rest| rest.starts_with(['s', 'd'])))
            .map(|(l, p)| (l.to_string(), p.clone()))
            .collect();
        for (label, fact) in &new {
            self.take_in(label, fact)?;
        }
        Ok((block, failed))
    }

    /// Ends the innermost block with its conclusion.
    fn close_block(&mut self, conclusion: Label) -> Result<(), Fail> {
        let end = Step::End(conclusion);
        self.checker.step(&end).map_err(Fail::from)?;
        self.steps.push(end);
        Ok(())
    }

    /// The label of the fact with the same text, if there is one.
    fn known(&self, wanted: &Prop) -> Option<Label> {
        self.checker.find(wanted).map(str::to_string)
    }

    /// Whether a name is a variable, family or sequence: no function of the language, and not π.
    fn is_a_name(&self, name: &str) -> bool {
        !is_built_in(name) && (name != PI || self.checker.statement().declares(PI))
    }

    /// The facts whose signs a step may use. A `for all` fact that contains a sum is left out, because the kernel applies
    /// such a fact inside every sum, where its index may be in use. Only its instances are useful.
    fn signs(&mut self) -> Vec<Label> {
        let speaks = |p: &Prop| match &p.kind {
            PropKind::Compare(..) | PropKind::And(_) => true,
            PropKind::ForAll(_, body) => !has_an_index(body),
            _ => false,
        };
        let mut labels = Vec::new();
        for (label, fact) in self.checker.facts() {
            let speaking = match self.speaking.get(label) {
                Some(speaking) => *speaking,
                None => *self.speaking.entry(label.to_string()).or_insert(speaks(fact)),
            };
            if speaking {
                labels.push(label.to_string());
            }
        }
        labels
    }

    /// The facts known now. It is a copy, because steps taken during a walk add more facts.
    fn facts(&self) -> Vec<(Label, Rc<Prop>)> {
        self.checker.facts().map(|(l, p)| (l.to_string(), p.clone())).collect()
    }

    fn fact(&self, label: &str) -> Option<Prop> {
        self.checker.fact_of(label).map(|fact| (**fact).clone())
    }

    /// A name that is not in use anywhere.
    fn fresh(&mut self, stem: &str) -> String {
        let fresh = (1..).map(|k| format!("{stem}{k}")).find(|n| !self.names.contains(n)).unwrap_or_default();
        self.names.insert(fresh.clone());
        fresh
    }
}

/// The number of steps up to the one that shows a fact outside of all blocks; that of a block is its end.
fn end_of(steps: &[Step], label: &str) -> Option<usize> {
    let mut depth = 0usize;
    let mut opened = false;
    for (place, step) in steps.iter().enumerate() {
        match step {
            Step::Show(show) => {
                let opens = matches!(show.rule, Rule::Let | Rule::Suppose);
                if depth == 0 && show.label == label {
                    if !opens {
                        return Some(place + 1);
                    }
                    opened = true;
                }
                depth += usize::from(opens);
            }
            Step::End(_) => {
                depth = depth.saturating_sub(1);
                if opened && depth == 0 {
                    return Some(place + 1);
                }
            }
        }
    }
    None
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
