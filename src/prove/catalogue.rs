//! Claims judged: each once, those that it cites first, no others.

use super::Instant;
use super::context::{Context, Engine, Failure, Origin};
use super::expand::Statement;
use super::outcome::{Fault, Line, Outcome, Point, Verdict, limit_reached};
use super::{need, refute};
use crate::claim::diagnostic::{self, Diagnostic};
use crate::claim::print;
use crate::claim::syntax::*;
use std::collections::BTreeMap;
use std::rc::Rc;
use std::time::Duration;

/// Bounds on the work for one claim; each is reported by name when it is reached.
#[derive(Clone, Debug)]
pub struct Limits {
    /// The largest power of a sum that is expanded (`degree`).
    pub degree: u32,
    /// The most terms of a sum (`terms`).
    pub terms: usize,
    /// The most bits of a coefficient after a power (`digits`, in bits).
    pub digits: u64,
    /// The most steps of the search (`steps`).
    pub steps: usize,
    /// The longest time for one claim (`time`).
    pub time: Duration,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits { degree: 100, terms: 5_000, digits: 100_000, steps: 400_000, time: Duration::from_secs(10) }
    }
}

/// A set of claims and what is known of them.
pub struct Catalogue {
    claims: Vec<Claim>,
    index: BTreeMap<String, usize>,
    outcomes: BTreeMap<String, Result<Outcome, Fault>>,
    proved: BTreeMap<String, Rc<Statement>>,
    judged: usize,
}

impl Catalogue {
    /// A catalogue of claims with distinct names.
    ///
    /// # Errors
    /// Names used twice, citations of claims that are not there, and citations in a circle.
    pub fn new(claims: Vec<Claim>) -> Result<Catalogue, Vec<(String, Diagnostic)>> {
        let mut faults = Vec::new();
        let mut index = BTreeMap::new();
        for (place, claim) in claims.iter().enumerate() {
            if index.insert(claim.name.text.clone(), place).is_some() {
                let fault = diagnostic::Fault::Twice(claim.name.text.clone());
                faults.push((claim.name.text.clone(), Diagnostic::new(fault, claim.name.span)));
            }
        }
        for claim in &claims {
            for cited in &claim.using {
                if !index.contains_key(&cited.text) {
                    let nearest = diagnostic::nearest(&cited.text, index.keys().map(String::as_str));
                    let message = format!("no claim is called {}", cited.text);
                    let help = nearest.map(|n| format!("did you mean {n}?"));
                    faults.push((
                        claim.name.text.clone(),
                        Diagnostic::new(diagnostic::Fault::Other { message, help }, cited.span),
                    ));
                }
            }
        }
        if faults.is_empty()
            && let Some(path) = circle(&claims, &index)
        {
            let first = &claims[index[&path[0]]];
            let span = first.using.first().map_or(first.name.span, |n| n.span);
            faults.push((path[0].clone(), Diagnostic::new(diagnostic::Fault::Circular(path), span)));
        }
        if faults.is_empty() {
            Ok(Catalogue { claims, index, outcomes: BTreeMap::new(), proved: BTreeMap::new(), judged: 0 })
        } else {
            Err(faults)
        }
    }

    /// The claims in their order.
    pub fn claims(&self) -> &[Claim] {
        &self.claims
    }

    /// A claim by name.
    pub fn get(&self, name: &str) -> Option<&Claim> {
        self.index.get(name).map(|i| &self.claims[*i])
    }

    /// Claims and all that they cite, those cited first.
    pub fn in_order(&self, claims: &[Claim]) -> Vec<Claim> {
        let mut out: Vec<Claim> = Vec::new();
        let mut stack: Vec<Claim> = claims.iter().rev().cloned().collect();
        while let Some(claim) = stack.pop() {
            if out.iter().any(|c| c.name.text == claim.name.text) {
                continue;
            }
            let missing: Vec<Claim> = claim
                .using
                .iter()
                .filter(|n| !out.iter().any(|c| c.name.text == n.text))
                .filter_map(|n| self.get(&n.text).cloned())
                .collect();
            if missing.is_empty() {
                out.push(claim);
            } else {
                stack.push(claim);
                stack.extend(missing);
            }
        }
        out
    }

    /// How many claims were judged so far.
    pub fn work(&self) -> usize {
        self.judged
    }

    /// The outcome of a claim; what it cites is judged first.
    ///
    /// # Errors
    /// The claim makes no sense: its hypotheses contradict each other, or its argument cites what is
    /// not there.
    pub fn audit(&mut self, name: &str, limits: &Limits) -> Result<Outcome, Fault> {
        // An explicit stack: citations may be many levels deep.
        let mut stack = vec![name.to_string()];
        while let Some(top) = stack.last().cloned() {
            if self.outcomes.contains_key(&top) {
                stack.pop();
                continue;
            }
            let Some(claim) = self.get(&top).cloned() else {
                let message = format!("no claim is called {top}");
                return Err(Fault::Text(Diagnose { message, help: None, span: Span::default() }));
            };
            let open: Vec<String> =
                claim.using.iter().map(|n| n.text.clone()).filter(|n| !self.outcomes.contains_key(n)).collect();
            if !open.is_empty() {
                stack.extend(open);
                continue;
            }
            let (outcome, statement) = self.judge(&claim, limits);
            if let (Ok(Outcome { verdict: Verdict::Proved, .. }), Some(statement)) = (&outcome, statement) {
                self.proved.insert(top.clone(), Rc::new(statement));
            }
            self.judged += 1;
            self.outcomes.insert(top, outcome);
            stack.pop();
        }
        self.outcomes[name].clone()
    }

    fn judge(&self, claim: &Claim, limits: &Limits) -> (Result<Outcome, Fault>, Option<Statement>) {
        let statement = match Statement::of(claim) {
            Ok(statement) => statement,
            Err(limit) => {
                return (Ok(beyond(claim, limit.0)), None);
            }
        };
        let cited: BTreeMap<String, Rc<Statement>> =
            statement.using.iter().filter_map(|n| self.proved.get(n).map(|s| (n.clone(), s.clone()))).collect();
        // What the argument may name and nobody has proved, with what is known of it.
        let mut unproved = BTreeMap::new();
        for name in statement.using.iter().filter(|n| !cited.contains_key(*n)) {
            let what = match self.outcomes.get(name) {
                Some(Ok(Outcome { reason: Some(reason), .. })) => format!("undecided: {reason}"),
                Some(Ok(outcome)) => outcome.verdict.name().to_string(),
                Some(Err(_)) | None => "at fault".to_string(),
            };
            unproved.insert(name.clone(), what);
        }
        let outcome = judge(claim, &statement, &cited, &unproved, limits);
        (outcome, Some(statement))
    }
}

fn undecided(claim: &Claim, reason: String) -> Outcome {
    Outcome {
        claim: claim.name.text.clone(),
        verdict: Verdict::Undecided,
        method: String::new(),
        used: Vec::new(),
        unused: Vec::new(),
        sample: None,
        witness: None,
        reason: Some(reason),
        limit: None,
        argument: Vec::new(),
    }
}

/// Undecided because of a limit.
fn beyond(claim: &Claim, limit: &'static str) -> Outcome {
    Outcome { limit: Some(limit), ..undecided(claim, limit_reached(limit)) }
}

/// What the search believes of a claim. Of those that it cites, it may use the claims that are `proved`; `unproved` says
/// what is known of the others.
///
/// # Errors
/// The claim makes no sense.
pub fn search(
    claim: &Claim,
    proved: &[&Claim],
    unproved: &BTreeMap<String, String>,
    limits: &Limits,
) -> Result<Outcome, Fault> {
    let statement = match Statement::of(claim) {
        Ok(statement) => statement,
        Err(limit) => return Ok(beyond(claim, limit.0)),
    };
    let cited = proved.iter().filter(|c| statement.using.contains(&c.name.text));
    let cited = cited.filter_map(|c| Some((c.name.text.clone(), Rc::new(Statement::of(c).ok()?)))).collect();
    let started = Instant::now();
    let mut outcome = judge(claim, &statement, &cited, unproved, limits)?;
    // A search for points ends without a word where the time is over.
    if outcome.verdict == Verdict::Undecided && outcome.limit.is_none() && started.elapsed() > limits.time {
        outcome.limit = Some("time");
        let reason = outcome.reason.take().map_or(String::new(), |reason| format!("{reason}; "));
        outcome.reason = Some(format!("{reason}{}", limit_reached("time")));
    }
    Ok(outcome)
}

/// A claim that a certificate shows, proved if its hypotheses hold at some point, which is sought; without argument.
///
/// # Errors
/// The hypotheses contradict each other.
pub fn given(claim: &Claim, limits: &Limits) -> Result<Outcome, Fault> {
    let statement = match Statement::of(claim) {
        Ok(statement) => statement,
        Err(limit) => return Ok(beyond(claim, limit.0)),
    };
    let (cited, unproved) = (BTreeMap::new(), BTreeMap::new());
    let mut engine = engine(&cited, &unproved, limits);
    let (_, result, sample) = given_in(&mut engine, &statement)?;
    let mut outcome = undecided(claim, String::new());
    outcome.sample = sample;
    if statement.has_hypotheses() && outcome.sample.is_none() {
        outcome.limit = match result {
            Err(Failure::Limit(name)) => Some(name),
            _ => engine.limit.or_else(|| out_of_time(&engine)),
        };
        let limit = outcome.limit.map_or(String::new(), |name| format!("; {}", limit_reached(name)));
        outcome.reason = Some(format!("{NO_POINT}{limit}"));
    } else {
        (outcome.verdict, outcome.reason) = (Verdict::Proved, None);
    }
    Ok(outcome)
}

/// The limit `time`, where it is reached: a search for points ends there without a word.
fn out_of_time(engine: &Engine) -> Option<&'static str> {
    engine.deadline.is_some_and(|deadline| Instant::now() > deadline).then_some("time")
}

const NO_POINT: &str = "no point was found at which all the hypotheses hold";

/// The hypotheses in a context, whether they could be taken in, and a point at which they hold.
type Given = (Context, Result<(), Failure>, Option<Point>);

/// Takes the hypotheses of a claim into a context, and seeks a point at which they hold.
fn given_in(engine: &mut Engine, statement: &Statement) -> Result<Given, Fault> {
    let mut cx = Context::default();
    let result = take_hypotheses(engine, &mut cx, statement);
    if let Err(Failure::Fault(diagnose)) = result {
        return Err(Fault::Text(diagnose));
    }
    let sample = if statement.has_hypotheses() { refute::sample(engine, &cx, statement) } else { None };
    if cx.contradiction.is_some() && sample.is_none() {
        let list: Vec<String> = statement.assumptions.iter().map(|a| print::prop(&a.1)).collect();
        return Err(Fault::Contradictory { hypotheses: list.join("; ") });
    }
    Ok((cx, result, sample))
}

fn engine<'c>(
    cited: &'c BTreeMap<String, Rc<Statement>>,
    unproved: &BTreeMap<String, String>,
    limits: &Limits,
) -> Engine<'c> {
    let mut engine = Engine {
        ring: Default::default(),
        log: Vec::new(),
        depth: 0,
        used: 0,
        // No deadline where the clock does not reach that far.
        deadline: Instant::now().checked_add(limits.time),
        steps: limits.steps,
        cited,
        unproved: unproved.keys().cloned().collect(),
        limit: None,
        rules: Vec::new(),
        certified: Default::default(),
    };
    engine.ring.degree_limit = limits.degree;
    engine.ring.terms_limit = limits.terms;
    engine.ring.bits_limit = limits.digits;
    engine.ring.deadline = engine.deadline;
    engine
}

fn judge(
    claim: &Claim,
    statement: &Statement,
    cited: &BTreeMap<String, Rc<Statement>>,
    unproved: &BTreeMap<String, String>,
    limits: &Limits,
) -> Result<Outcome, Fault> {
    let mut engine = engine(cited, unproved, limits);
    let (cx, mut result, sample) = given_in(&mut engine, statement)?;
    let has_hypotheses = statement.has_hypotheses();
    engine.used = 0;
    if result.is_ok() {
        result = show(&mut engine, &cx, statement);
    }
    if let Err(Failure::Fault(diagnose)) = result {
        return Err(Fault::Text(diagnose));
    }
    let mut outcome = undecided(claim, String::new());
    outcome.sample = sample;
    outcome.reason = None;
    match result {
        Ok(()) if has_hypotheses && outcome.sample.is_none() => {
            // The argument stands, but nothing shows that the hypotheses can hold at once.
            outcome.reason = Some(NO_POINT.to_string());
        }
        Ok(()) => {
            outcome.verdict = Verdict::Proved;
            outcome.method = main_rule(&engine.rules).to_string();
            let attempt = || {
                let mut again = self::engine(cited, unproved, limits);
                again.steps = 2 * (limits.steps - engine.steps.min(limits.steps)) + 1_000;
                // The time is that of the whole claim.
                again.deadline = engine.deadline;
                again.ring.deadline = engine.deadline;
                again
            };
            let stated = need::hypotheses(statement);
            let idle = need::not_needed(&engine, statement, &stated, &attempt);
            for (place, hypothesis) in stated.into_iter().enumerate() {
                let list = if idle.contains(&place) { &mut outcome.unused } else { &mut outcome.used };
                list.push(hypothesis.text);
            }
            outcome.argument = engine.log.clone();
        }
        Err(failure) => {
            let limit = engine.limit;
            engine.steps = engine.steps.max(1_000);
            match refute::counterexample(&mut engine, &cx, statement) {
                Some(witness) => {
                    outcome.verdict = Verdict::Refuted;
                    outcome.method =
                        if witness.broken.iter().all(|b| b.left == "no value") { "definedness" } else { "search" }
                            .to_string();
                    let at: Vec<String> = witness.point.values.iter().map(|(n, v)| format!("{n} = {v}")).collect();
                    outcome.argument.push(Line { depth: 0, rule: "witness", text: at.join(", ") });
                    for broken in &witness.broken {
                        let text = if broken.right.is_empty() {
                            broken.statement.clone()
                        } else {
                            format!("{}: left side {}, right side {}", broken.statement, broken.left, broken.right)
                        };
                        outcome.argument.push(Line { depth: 1, rule: "witness", text });
                    }
                    outcome.witness = Some(witness);
                }
                None => {
                    outcome.limit = match &failure {
                        Failure::Limit(name) => Some(name),
                        Failure::NotShown(_) => limit,
                        _ => None,
                    };
                    outcome.reason = Some(match (failure, limit) {
                        (Failure::Limit(name), _) => limit_reached(name),
                        (Failure::NotShown(text), Some(name)) => format!("not shown: {text}; {}", limit_reached(name)),
                        (Failure::NotShown(text), None) => format!("not shown: {text}"),
                        (Failure::RestsOn(name), _) => {
                            let what = unproved.get(&name).map_or("not proved", String::as_str);
                            format!("rests on {name}, which is {what}")
                        }
                        (Failure::Undefined(text), _) => format!("an expression may have no value: {text}"),
                        (Failure::Fault(diagnose), _) => diagnose.message,
                    });
                }
            }
        }
    }
    Ok(outcome)
}

/// Takes the hypotheses into the context, as facts in the order of [`need::hypotheses`].
pub(super) fn take_hypotheses(engine: &mut Engine, cx: &mut Context, statement: &Statement) -> Result<(), Failure> {
    for sequence in &statement.sequences {
        cx.sequences.insert(sequence.name.clone(), Rc::new(sequence.clone()));
    }
    engine.declare(cx, &statement.bindings)?;
    for (label, prop) in &statement.assumptions {
        engine.assume(cx, prop, label.clone(), Origin::Hypothesis)?;
    }
    // A member counts as a number wherever its index is one.
    statement.sequences.iter().try_for_each(|sequence| engine.members_valued(cx, sequence))
}

/// Shows the goal by the claim's argument; where that fails, without it.
pub(super) fn show(engine: &mut Engine, cx: &Context, statement: &Statement) -> Result<(), Failure> {
    let mut proving = cx.clone();
    let result = engine.attempt(|engine| engine.follow(&mut proving, &statement.goal, &statement.proof));
    let guided = !statement.proof.steps.is_empty() || statement.proof.close.is_some();
    let led_nowhere = matches!(result, Err(Failure::NotShown(_) | Failure::Undefined(_) | Failure::RestsOn(_)));
    if guided && led_nowhere {
        let mut alone = cx.clone();
        if engine.attempt(|engine| engine.show_goal(&mut alone, &statement.goal)).is_ok() {
            return Ok(());
        }
    }
    result
}

/// The rule that carries an argument, the most telling of those used.
fn main_rule(rules: &[&'static str]) -> &'static str {
    const ORDER: &[&str] = &[
        "limit",
        "extremum",
        "induction",
        "mean inequality",
        "witness",
        "equivalence",
        "cofactors",
        "instance",
        "power",
        "product",
        "cases",
        "elimination",
        "sign",
        "identity",
        "contradiction",
    ];
    ORDER.iter().find(|r| rules.contains(r)).copied().unwrap_or("logic")
}

/// Names along a circle of citations, the first repeated at the end.
fn circle(claims: &[Claim], index: &BTreeMap<String, usize>) -> Option<Vec<String>> {
    // 0 not seen, 1 on the path, 2 done.
    let mut state = vec![0u8; claims.len()];
    for start in 0..claims.len() {
        let mut path: Vec<(usize, usize)> = Vec::new();
        if state[start] == 0 {
            state[start] = 1;
            path.push((start, 0));
        }
        while let Some((node, next)) = path.last().copied() {
            let Some(cited) = claims[node].using.get(next) else {
                state[node] = 2;
                path.pop();
                continue;
            };
            if let Some(last) = path.last_mut() {
                last.1 += 1;
            }
            let to = index[&cited.text];
            match state[to] {
                0 => {
                    state[to] = 1;
                    path.push((to, 0));
                }
                1 => {
                    let from = path.iter().position(|p| p.0 == to).unwrap_or(0);
                    let mut names: Vec<String> = path[from..].iter().map(|p| claims[p.0].name.text.clone()).collect();
                    names.push(claims[to].name.text.clone());
                    return Some(names);
                }
                _ => {}
            }
        }
    }
    None
}
