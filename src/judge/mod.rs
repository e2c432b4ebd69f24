//! Claims judged. *Proved* means: the kernel accepted a certificate of the claim in this run.
//!
//! Contract: a certificate at hand decides first; where the kernel accepts none, the search looks for a proof, and what
//! it finds is written as a certificate, which the kernel has to accept. Where the search finds a proof that the kernel
//! cannot check, the claim is undecided and [`Entry::found`] says so. A claim is judged after those that it cites, and
//! may use what was proved of them. The order of the answers does not depend on the number of threads.

pub mod hand;
mod hypotheses;
mod threads;

use crate::certificate::text::{digest, write};
use crate::certify::{Fail, certify};
use crate::claim::diagnostic::{self, Diagnostic};
use crate::claim::print::Style;
use crate::claim::syntax::{Claim, Span};
use crate::kernel::Accepted;
use crate::prove::catalogue::{self, Catalogue, Limits};
use crate::prove::outcome::{Fault, Outcome, Verdict};
use hand::AtHand;

/// A claim and what the audit says of it.
pub struct Entry {
    /// The claim.
    pub claim: Claim,
    /// The outcome.
    pub outcome: Outcome,
    /// Whether the search found a proof that the kernel did not accept.
    pub found: bool,
    /// What the kernel accepted.
    pub proof: Option<Proof>,
}

impl Entry {
    /// Whether the verdict is the one that the file expects.
    pub fn as_expected(&self) -> bool {
        self.outcome.verdict.is_expected(self.claim.expect)
    }

    /// The goal on one line.
    pub fn goal(&self, style: Style) -> String {
        style.prop(&self.claim.goal).split_whitespace().collect::<Vec<_>>().join(" ")
    }
}

/// A certificate that the kernel accepted in this run.
#[derive(Clone, Debug)]
pub struct Proof {
    /// The certificate as text.
    pub certificate: String,
    /// Its SHA-256, in hexadecimal digits.
    pub sha256: String,
    /// The SHA-256 of the statement as the kernel reads it; it stands in the certificate.
    pub statement: String,
    /// The cited claims and analytic lemmas that it rests on.
    pub rests_on: Vec<String>,
}

/// How claims are judged.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// The limits for each claim.
    pub limits: Limits,
    /// Search every proof anew, even where a certificate is at hand.
    pub anew: bool,
    /// Give the argument that the search finds, even where a certificate at hand decides.
    pub argument: bool,
}

/// A claim that was judged, with what others may build on.
struct Judged {
    entry: Result<Entry, Fault>,
    accepted: Option<Accepted>,
}

/// What came of a set of claims.
pub struct Judgement {
    /// Each claim that was asked for, in the order of the names, with its entry or why it makes no sense.
    pub entries: Vec<(String, Result<Entry, Fault>)>,
    /// How many claims were worked on, cited ones included.
    pub judged: usize,
}

/// Judges the claims of these names, and what they cite. `now` hears how many are done and the name of one that is begun.
pub fn judge(
    catalogue: &Catalogue,
    names: &[String],
    hand: &AtHand,
    settings: &Settings,
    now: &(dyn Fn(usize, &str) + Sync),
) -> Judgement {
    let asked: Vec<Claim> = names.iter().filter_map(|name| catalogue.get(name).cloned()).collect();
    let order = catalogue.in_order(&asked);
    let silent = Settings { argument: false, ..settings.clone() };
    let mut done = threads::each_after_what_it_cites(&order, now, &|claim, cited: &[&Judged]| {
        let settings = if names.contains(&claim.name.text) { settings } else { &silent };
        one(claim, cited, hand, settings)
    });
    let judged = done.len();
    let entries = names.iter().map(|name| {
        let entry = done.remove(name).map(|judged| judged.entry);
        (name.clone(), entry.unwrap_or_else(|| Err(unknown(name))))
    });
    Judgement { entries: entries.collect(), judged }
}

/// Judges one claim.
///
/// # Errors
/// The claim makes no sense: its hypotheses contradict each other, or its argument cites what is not there.
pub fn one_of(catalogue: &Catalogue, name: &str, hand: &AtHand, settings: &Settings) -> Result<Entry, Fault> {
    let mut found = judge(catalogue, &[name.to_string()], hand, settings, &|_, _| {});
    found.entries.pop().map_or_else(|| Err(unknown(name)), |entry| entry.1)
}

fn unknown(name: &str) -> Fault {
    let message = format!("no claim is called {name}");
    Fault::Text(crate::claim::syntax::Diagnose { message, help: None, span: Span::default() })
}

/// The fault of a claim that makes no sense, at its place.
pub fn diagnostic(claim: &Claim, fault: Fault) -> Diagnostic {
    match fault {
        Fault::Contradictory { hypotheses } => Diagnostic::new(
            diagnostic::Fault::Other {
                message: format!("the hypotheses of {} cannot all hold: {hypotheses}", claim.name.text),
                help: Some("no values satisfy these hypotheses; remove or weaken one".to_string()),
            },
            claim.name.span,
        ),
        Fault::Text(d) => Diagnostic::new(diagnostic::Fault::Other { message: d.message, help: d.help }, d.span),
    }
}

fn one(claim: &Claim, cited: &[&Judged], hand: &AtHand, settings: &Settings) -> Judged {
    let accepted: Vec<&Accepted> = cited.iter().filter_map(|c| c.accepted.as_ref()).collect();
    let held = if settings.anew { None } else { hand.accepted(claim, &accepted) };
    let proved: Vec<&Claim> = cited
        .iter()
        .filter_map(|c| c.entry.as_ref().ok())
        .filter(|e| e.outcome.verdict == Verdict::Proved)
        .map(|e| &e.claim)
        .collect();
    let others = cited.iter().filter_map(|c| c.entry.as_ref().ok()).filter(|e| e.outcome.verdict != Verdict::Proved);
    let unproved = others
        .map(|e| {
            let reason = e.outcome.reason.as_ref().map_or(String::new(), |reason| format!(": {reason}"));
            (e.claim.name.text.clone(), format!("{}{reason}", e.outcome.verdict.name()))
        })
        .chain(claim.using.iter().map(|n| (n.text.clone(), "at fault".to_string())).filter(|(name, _)| {
            !cited.iter().filter_map(|c| c.entry.as_ref().ok()).any(|e| e.claim.name.text == *name)
        }))
        .collect();
    let search = || catalogue::search(claim, &proved, &unproved, &settings.limits);
    // The outcome, what the kernel accepted, and whether it is a proof that the kernel does not check.
    let result = match held {
        Some(held) => catalogue::given(claim, &settings.limits).and_then(|mut outcome| {
            if settings.argument {
                outcome.argument = search()?.argument;
            }
            Ok((outcome, Some(held), false))
        }),
        None => search().map(|outcome| match outcome.verdict {
            Verdict::Proved => match certify(claim, &accepted, &settings.limits) {
                Ok(shown) => (outcome, Some(shown), false),
                Err(fail) => (unchecked(outcome, &fail), None, true),
            },
            _ => (outcome, None, false),
        }),
    };
    match result {
        Err(fault) => Judged { entry: Err(fault), accepted: None },
        Ok((mut outcome, Some((certificate, shown)), _)) if outcome.verdict == Verdict::Proved => {
            (outcome.used, outcome.unused) = hypotheses::used(claim, &shown);
            outcome.method = hypotheses::method(&certificate).to_string();
            let certificate = write(&certificate);
            let proof = Proof {
                sha256: digest(&certificate),
                statement: digest(&shown.text()),
                rests_on: shown.rests_on().iter().cloned().collect(),
                certificate,
            };
            let entry = Entry { claim: claim.clone(), outcome, found: false, proof: Some(proof) };
            Judged { entry: Ok(entry), accepted: Some(shown) }
        }
        Ok((outcome, _, found)) => {
            Judged { entry: Ok(Entry { claim: claim.clone(), outcome, found, proof: None }), accepted: None }
        }
    }
}

/// What is said of a proof that the kernel does not check.
fn unchecked(outcome: Outcome, fail: &Fail) -> Outcome {
    Outcome {
        verdict: Verdict::Undecided,
        method: String::new(),
        used: Vec::new(),
        unused: Vec::new(),
        limit: fail.limit(),
        reason: Some(format!("the search found a proof, but no certificate that the kernel accepts: {fail}")),
        ..outcome
    }
}
