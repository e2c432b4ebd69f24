//! A set of claims, ordered so that every claim comes after those that it cites.

use crate::claim::diagnostic::{self, Diagnostic};
use crate::claim::syntax::*;
use std::collections::BTreeMap;
use std::time::Duration;

/// Bounds on the work for one claim; each is reported by name when it is reached.
#[derive(Clone, Debug)]
pub struct Limits {
    /// Largest number of search steps (`steps`).
    pub steps: usize,
    /// The longest time for one claim (`time`).
    pub time: Duration,
    /// The methods of the search for proofs that are left out, by name.
    pub without: Vec<String>,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits { steps: 400_000, time: Duration::from_secs(10), without: Vec::new() }
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
