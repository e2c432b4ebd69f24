//! Findings for a reader of the paper: hidden hypotheses, damaged lines, false statements.

use crate::claim::syntax::Reading;
use crate::refute::outcome::Verdict;
use crate::report::Audit;

/// A finding.
pub(super) struct Finding<'a> {
    /// The claim's name.
    pub name: &'a str,
    /// The claim's title.
    pub title: &'a str,
    /// Its kind in a few words.
    pub kind: &'static str,
    /// What was found, in words.
    pub says: Vec<&'a str>,
    /// Where the claim fails, a value in each text.
    pub fails_at: Option<Vec<String>>,
}

/// The findings of an audit, in the order of the claims.
pub(super) fn of(audit: &Audit) -> Vec<Finding<'_>> {
    let mut out = Vec::new();
    for entry in &audit.entries {
        let (claim, outcome) = (&entry.claim, &entry.outcome);
        let kind = match (claim.reading, outcome.verdict) {
            (Some(Reading::Extracted), Verdict::Refuted) => "a damaged line of the text",
            (Some(Reading::Printed), Verdict::Refuted) => "false as printed",
            (_, Verdict::Refuted) => "false as stated",
            (_, Verdict::Undecided) => "undecided",
            _ if !claim.notes.is_empty() => "note",
            _ => continue,
        };
        let says = claim.notes.iter().chain(&outcome.reason).map(String::as_str).collect();
        let fails_at = outcome.witness.as_ref().map(|w| w.point.in_words(claim));
        out.push(Finding { name: &claim.name.text, title: &claim.title, kind, says, fails_at });
    }
    out
}
