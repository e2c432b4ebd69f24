//! Shortens a certificate: drops steps that the goal does not need, and citations that a step does not need.
//!
//! Contract: the result is a certificate of the same statement, with the labels 1, 2, 3, … in order. The search cites
//! everything that the kernel looked at. Unused steps go first, because testing a citation costs one check of its step.
//! Then each citation of the remaining steps is dropped if the kernel still accepts the step.

use crate::algebra::Moment;
use crate::certificate::{Certificate, Label, Show, Step, needed};
use crate::claim::syntax::Claim;
use crate::kernel::{Accepted, Checker, Refusal};
use std::collections::{BTreeSet, HashMap};

/// The shortened certificate. At the deadline the rest stays as it is.
///
/// # Errors
/// The kernel rejects a step: this was not a certificate of the claim.
pub(crate) fn brief(
    claim: &Claim,
    certificate: Certificate,
    cited: &[&Accepted],
    deadline: Option<Moment>,
) -> Result<Certificate, Refusal> {
    let mut certificate = swept(certificate);
    let mut checker = Checker::new(claim, cited)?;
    let mut needed = BTreeSet::new();
    for step in &mut certificate.steps {
        if let Step::Show(show) = step {
            if deadline.is_none_or(|deadline| Moment::now() <= deadline) {
                spare(&mut checker, show, &needed);
            }
            needed.extend(show.cited().cloned());
        }
        checker.step(step)?;
    }
    Ok(swept(certificate))
}

/// Takes a step without the citations that the kernel does not look at.
///
/// # Errors
/// The kernel does not take the step.
pub(crate) fn take(checker: &mut Checker, show: Show) -> Result<Step, Refusal> {
    let used = checker.used(&show)?;
    let shorter = Step::Show(Box::new(Show { by: used.by, using: used.using, ..show.clone() }));
    if checker.step(&shorter).is_ok() {
        return Ok(shorter);
    }
    let whole = Step::Show(Box::new(show));
    checker.step(&whole).map(|()| whole)
}

/// Drops each citation that the step does not need. Citations that no other step needs are tried first, because the steps
/// behind them can then be dropped too.
fn spare(checker: &mut Checker, show: &mut Show, needed: &BTreeSet<Label>) {
    let mut tried: Vec<Label> = show.by.iter().chain(&show.using).cloned().collect();
    tried.sort_by_key(|label| (!label.starts_with('h'), needed.contains(label)));
    for label in tried {
        let mut fewer = show.clone();
        fewer.by.retain(|l| *l != label);
        fewer.using.retain(|l| *l != label);
        if checker.used(&fewer).is_ok() {
            *show = fewer;
        }
    }
}

/// The steps that the goal rests on. No label may be used twice.
fn swept(certificate: Certificate) -> Certificate {
    let needed = needed(&certificate);
    let kept = certificate.steps.into_iter().enumerate().filter(|(place, _)| needed.steps.contains(place));
    let mut names = Names::default();
    let steps = kept.map(|(_, step)| match step {
        Step::Show(show) => Step::Show(Box::new(names.renamed(*show))),
        Step::End(conclusion) => Step::End(names.of(&conclusion)),
    });
    Certificate {
        steps: steps.collect(),
        claim: certificate.claim,
        statement: certificate.statement,
        refutes: certificate.refutes,
    }
}

/// New labels by the old ones.
#[derive(Default)]
struct Names(HashMap<Label, Label>);

impl Names {
    /// The new label of a fact: of a step, or of what a block supposes, which is the block's label with a suffix.
    fn of(&self, label: &str) -> Label {
        if let Some(new) = self.0.get(label) {
            return new.clone();
        }
        let of_block = || {
            let domain = label.trim_end_matches(|c: char| c.is_ascii_digit());
            let block = label.strip_suffix('s').or_else(|| domain.strip_suffix('d'))?;
            Some(format!("{}{}", self.0.get(block)?, label.get(block.len()..)?))
        };
        // Hypotheses and cited claims keep their names.
        of_block().unwrap_or_else(|| label.to_string())
    }

    fn renamed(&mut self, mut show: Show) -> Show {
        show.relabel(&mut |label| self.of(label));
        let label = (self.0.len() + 1).to_string();
        self.0.insert(std::mem::replace(&mut show.label, label.clone()), label);
        show
    }
}
