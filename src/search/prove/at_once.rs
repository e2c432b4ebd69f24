//! Comparisons that the kernel sees when it multiplies out, before anything is searched for; and the last check of what any
//! search found.

use super::{Fail, brief};
use crate::algebra::Moment;
use crate::certificate::{Certificate, Rule, Show, Step};
use crate::claim::syntax::{Claim, Prop, PropKind};
use crate::kernel::statement::compare;
use crate::kernel::{Accepted, Checker, Refusal, Verdict};
use crate::refute::catalogue::Limits;

/// Shortens a certificate, with a time limit of its own, and has the kernel check it. The text counts: it is read back and
/// checked from the beginning.
pub(super) fn accepted(
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
    let mut steps: Vec<Step> = Vec::new();
    let mut take = |rule: Rule, prop: Prop| {
        let by = match rule {
            Rule::Combination { .. } => checker.facts().map(|f| f.0.to_string()).collect(),
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
        take(Rule::Combination { times: None, terms: Vec::new() }, part.clone()).map_err(Fail::from)?;
    }
    if !matches!(goal.kind, PropKind::Compare(..)) || parts.len() > 1 {
        let from = (1..=parts.len()).map(|k| k.to_string()).collect();
        take(Rule::Logic { from }, goal).map_err(Fail::from)?;
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
