//! An audit for a terminal.

use super::{Audit, Entry, counted, section, summary, visible};
use crate::claim::print::Style;
use crate::claim::syntax::Reading;
use crate::refute::outcome::Verdict;

const GREEN: &str = "\x1b[32m";
const RED: &str = "\x1b[31m";
const YELLOW: &str = "\x1b[33m";
const BOLD: &str = "\x1b[1m";
const DIM: &str = "\x1b[2m";
const PLAIN: &str = "\x1b[0m";

/// The report with colours; a caller that does not write to a terminal strips them.
pub fn report(audit: &Audit) -> String {
    shown(audit, false)
}

/// The same, with only the claims whose verdict is not the expected one.
pub fn unexpected(audit: &Audit) -> String {
    shown(audit, true)
}

fn shown(audit: &Audit, only_unexpected: bool) -> String {
    let mut pieces = Pieces::new(only_unexpected);
    let entries = audit.sections().into_iter().flat_map(|section| section.1);
    let mut out: String = entries.map(|entry| pieces.entry(entry)).collect();
    out.push_str(&pieces.end(audit));
    out
}

/// The report in pieces, for claims that are told one after the other, section by section.
pub struct Pieces {
    only_unexpected: bool,
    section: Option<String>,
}

impl Pieces {
    /// Nothing is told yet.
    #[must_use]
    pub fn new(only_unexpected: bool) -> Pieces {
        Pieces { only_unexpected, section: None }
    }

    /// A claim, with the heading of its section where that begins; nothing if only unexpected verdicts are told.
    pub fn entry(&mut self, entry: &Entry) -> String {
        let mut out = String::new();
        if self.only_unexpected && entry.as_expected() {
            return out;
        }
        let section = section(entry);
        if self.section.as_deref() != Some(section) {
            let gap = if self.section.is_none() { "" } else { "\n" };
            out.push_str(&format!("{gap}{BOLD}{}{PLAIN}\n", visible(section)));
            self.section = Some(section.to_owned());
        }
        one(&mut out, entry);
        out
    }

    /// The counts at the end.
    #[must_use]
    pub fn end(&self, audit: &Audit) -> String {
        let gap = if self.section.is_none() { "" } else { "\n" };
        counts(audit, gap)
    }
}

fn counts(audit: &Audit, gap: &str) -> String {
    let s = summary(&audit.entries);
    let mut out = String::new();
    out.push_str(&format!(
        "{gap}{BOLD}{}: {} proved, {} refuted, {} undecided{PLAIN}",
        audit.count(),
        s.proved,
        s.refuted,
        s.undecided
    ));
    let errors = match audit.problems.len() {
        0 => String::new(),
        n => format!("; {RED}{}{PLAIN}", counted(n, "error")),
    };
    out.push_str(&match s.unexpected {
        0 if errors.is_empty() => "; all as expected\n".to_string(),
        0 => format!("{errors}\n"),
        n => format!("; {RED}{n} not as expected{PLAIN}{errors}\n"),
    });
    out
}

fn one(out: &mut String, entry: &Entry) {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let (colour, mark) = match outcome.verdict {
        Verdict::Proved => (GREEN, "proved   "),
        Verdict::Refuted => (RED, "refuted  "),
        Verdict::Undecided => (YELLOW, "undecided"),
    };
    let number = claim.number.as_ref().map_or(String::new(), |n| format!("({n})"));
    let reading = match claim.reading {
        Some(Reading::Extracted) => ", as extracted",
        Some(Reading::Printed) => ", as printed",
        Some(Reading::Restored | Reading::Beyond) | None => "",
    };
    out.push_str(&format!(
        "  {colour}{mark}{PLAIN} {number:>5} {BOLD}{}{PLAIN}  {}{reading}\n",
        claim.name.text,
        visible(&claim.title)
    ));
    let goal = entry.goal(Style::Unicode);
    out.push_str(&format!("                  {DIM}{goal}{PLAIN}\n"));
    if let Some(witness) = &outcome.witness {
        let at = witness.point.in_words(&entry.claim);
        let fails = if at.is_empty() { "is false".to_string() } else { format!("fails at {}", at.join(", ")) };
        out.push_str(&format!("                  {fails}\n"));
        for broken in &witness.broken {
            if broken.right.is_empty() {
                out.push_str(&format!("                    {}\n", broken.statement));
            } else {
                // A single broken comparison is the goal printed above; several are named.
                let which = if witness.broken.len() > 1 { format!("{}: ", broken.statement) } else { String::new() };
                out.push_str(&format!(
                    "                    {which}left side {}, right side {}\n",
                    broken.left, broken.right
                ));
            }
        }
        if entry.proof.is_none() {
            out.push_str("                  evaluated, not certified\n");
        }
    }
    if let Some(reason) = &outcome.reason {
        out.push_str(&format!("                  {reason}\n"));
        if outcome.verdict == Verdict::Undecided {
            if outcome.points + outcome.open > 0 {
                let points = counted(outcome.points + outcome.open, "point");
                out.push_str(&format!("                  no counterexample was found at {points}\n"));
            }
            let hint = format!("to see what was tried and what would help: carom explain {} FILE", claim.name.text);
            out.push_str(&format!("                  {hint}\n"));
        }
    }
    if outcome.verdict == Verdict::Proved && !outcome.unused.is_empty() {
        out.push_str(&format!("                  not needed: {}\n", visible(&outcome.unused.join("; "))));
    }
    for note in &claim.notes {
        out.push_str(&format!("                  note: {}\n", visible(note)));
    }
    if !entry.as_expected() {
        out.push_str(&format!("                  {RED}not as expected{PLAIN}\n"));
    }
}
