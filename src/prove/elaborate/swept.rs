//! A certificate without the steps that its goal does not rest on, their labels 1, 2, 3, … in order.

use crate::certificate::{Certificate, Label, Show, Step, needed};
use std::collections::HashMap;

/// The steps that the goal rests on. No label may be used twice.
pub fn swept(certificate: Certificate) -> Certificate {
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
