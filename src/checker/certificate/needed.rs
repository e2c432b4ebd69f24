//! The facts and steps that the last step of a certificate needs, found by one walk backwards over the citations.

use super::{Certificate, Label, Step};
use std::collections::BTreeSet;

/// The steps and facts that the goal rests on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Needed {
    /// The places of the steps.
    pub steps: BTreeSet<usize>,
    /// The facts that no step shows: hypotheses, suppositions of blocks, and cited claims by name.
    pub facts: BTreeSet<Label>,
}

/// The facts and steps that the last step needs, itself included.
///
/// A step cites only facts before it. What a block shows is known by the label of its first step, from its `end` on.
pub fn needed(certificate: &Certificate) -> Needed {
    let steps = &certificate.steps;
    // For each `end`, where its block begins.
    let mut begin = vec![None; steps.len()];
    let mut open = Vec::new();
    for (place, step) in steps.iter().enumerate() {
        match step {
            Step::Show(show) if show.opens() => open.push(place),
            Step::Show(_) => {}
            Step::End(_) => begin[place] = open.pop(),
        }
    }
    let mut out = Needed::default();
    for (place, step) in steps.iter().enumerate().rev() {
        let last = place + 1 == steps.len();
        match step {
            Step::Show(show) if show.opens() => {
                if out.steps.contains(&place) {
                    out.facts.extend(show.cited().cloned());
                }
            }
            Step::Show(show) => {
                if out.facts.remove(&show.label) || last {
                    out.steps.insert(place);
                    out.facts.extend(show.cited().cloned());
                }
            }
            Step::End(conclusion) => {
                let first = begin[place].and_then(|first| Some((first, steps.get(first)?)));
                let Some((first, Step::Show(block))) = first else { continue };
                if out.facts.remove(&block.label) || last {
                    out.steps.extend([first, place]);
                    out.facts.insert(conclusion.clone());
                }
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::text::read;

    #[test]
    fn a_block_that_nothing_cites_is_not_needed_and_its_labels_say_nothing_of_later_ones() {
        let head = format!("carom-certificate 2\nclaim a\nstatement sha256 {}\n", "0".repeat(64));
        let steps = "1 suppose: x = 1 => x = 1\n  2 combination: x = 1\n    | term h2: 1\nend 2\n\
                     2 let: for all y real: y = y\n    | by h3\n  3 combination: y = y\n    | using 2d1\nend 3\n\
                     4 combination: x = x\n    | by h4\n\
                     5 instance from 2 h5: x = x\n    | with y = x\nqed\n";
        let certificate = read(&format!("{head}{steps}")).unwrap_or_else(|e| panic!("{e:?}"));
        let found = needed(&certificate);
        assert_eq!(found.steps.into_iter().collect::<Vec<_>>(), [3, 4, 5, 7]);
        assert_eq!(found.facts.into_iter().collect::<Vec<_>>(), ["2d1", "h3", "h5"]);
    }
}
