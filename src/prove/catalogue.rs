//! A set of claims, those that are cited before those that cite them.

use super::Instant;
use super::context::{Context, Engine, Failure};
use super::expand::Statement;
use super::outcome::{Fault, Point};
use super::refute;
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

/// A set of claims.
pub struct Catalogue {
    claims: Vec<Claim>,
    index: BTreeMap<String, usize>,
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
        if faults.is_empty() { Ok(Catalogue { claims, index }) } else { Err(faults) }
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
}

/// The hypotheses in a context, whether they could be taken in, and a point at which they hold.
pub(super) type Given = (Context, Result<(), Failure>, Option<Point>);

/// Takes the hypotheses of a claim into a context, and seeks a point at which they hold.
pub(super) fn given_in(engine: &mut Engine, statement: &Statement) -> Result<Given, Fault> {
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

pub(super) fn engine(limits: &Limits) -> Engine {
    let mut engine = Engine {
        ring: Default::default(),
        used: 0,
        // No deadline where the clock does not reach that far.
        deadline: Instant::now().checked_add(limits.time),
        steps: limits.steps,
        limit: None,
        points: 0,
        certified: Default::default(),
    };
    engine.ring.degree_limit = limits.degree;
    engine.ring.terms_limit = limits.terms;
    engine.ring.bits_limit = limits.digits;
    engine.ring.deadline = engine.deadline;
    engine
}

/// Takes the hypotheses into the context.
fn take_hypotheses(engine: &mut Engine, cx: &mut Context, statement: &Statement) -> Result<(), Failure> {
    for sequence in &statement.sequences {
        cx.sequences.insert(sequence.name.clone(), Rc::new(sequence.clone()));
    }
    engine.declare(cx, &statement.bindings)?;
    for (_, prop) in &statement.assumptions {
        engine.assume(cx, prop)?;
    }
    // A member counts as a number wherever its index is one.
    statement.sequences.iter().try_for_each(|sequence| engine.members_valued(cx, sequence))
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
