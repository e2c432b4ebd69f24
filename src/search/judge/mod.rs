//! Claims judged. *Proved* means: the kernel accepted a certificate of the claim in this run.
//!
//! Contract: a certificate at hand decides first; where the kernel accepts none, a counterexample is sought at few points,
//! then a proof, which is written as a certificate that the kernel has to accept, then a counterexample at all points.
//! A claim is judged after those that it cites, and may use what was proved of them. The order of the answers does not depend on the number of threads.

pub mod hand;
mod hypotheses;
mod other_limit;
pub mod refuted;
pub mod repair;
mod satisfiable;
mod threads;

use crate::certificate::Certificate;
use crate::certificate::text::{digest, write};
use crate::claim::diagnostic::{self, Diagnostic};
use crate::claim::dimension;
use crate::claim::print::Style;
use crate::claim::syntax::{self as claim, Claim, Item, Method, Relation, Span, Step};
use crate::explain::{self, Document};
use crate::kernel::Accepted;
use crate::kernel::statement::{compare, numeral};
use crate::prove;
use crate::refute::case::{Case, Stage, beyond, broken_off, differing};
use crate::refute::catalogue::{Catalogue, Limits};
use crate::refute::outcome::{Fault, Outcome, Point, Verdict};
use hand::AtHand;

/// The part of the time limit for proving that some point satisfies the hypotheses, or that they contradict each other, if the
/// search found no point.
const CONTRADICTION: u32 = 5;

/// The part of the time limit for showing that a counterexample exists, before a proof is sought.
const EARLY: u32 = 20;

/// The part of the time limit for proving that a limit is another.
const EXPANDED: u32 = 3;

/// The part of the time limit that the search for a proof leaves to the search for a counterexample.
const LEFT: u32 = 8;

/// A claim and its result in the audit.
#[derive(Clone)]
pub struct Entry {
    /// The claim.
    pub claim: Claim,
    /// The outcome.
    pub outcome: Outcome,
    /// What the kernel accepted: of a refuted claim, that it is false at the witness.
    pub proof: Option<Proof>,
    /// The proof in words, where it was asked for.
    pub explained: Option<Document>,
}

impl Entry {
    /// Whether the verdict is the one that the file expects.
    pub fn as_expected(&self) -> bool {
        self.outcome.verdict.is_expected(self.claim.expect)
    }

    /// The goal on one line.
    pub fn goal(&self, style: Style) -> String {
        style.prop(self.claim.written_goal()).split_whitespace().collect::<Vec<_>>().join(" ")
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

impl Proof {
    /// A refutation, which rests on no other claim.
    fn refuting(certificate: Certificate) -> Proof {
        let text = write(&certificate);
        Proof { sha256: digest(&text), statement: certificate.statement, rests_on: Vec::new(), certificate: text }
    }
}

/// How claims are judged.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// The limits for each claim.
    pub limits: Limits,
    /// Search every proof anew, even where a certificate is at hand.
    pub anew: bool,
    /// Say each proof in words.
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

/// What happens while claims are judged.
pub enum News<'n> {
    /// A claim of this name is begun; so many are done.
    Begun(usize, &'n str),
    /// What came of a claim that was asked for.
    Judged(&'n str, &'n Result<Entry, Fault>),
}

/// Judges the claims of these names, and what they cite. `hear` is told what happens, by any thread.
pub fn judge(
    catalogue: &Catalogue,
    names: &[String],
    hand: &AtHand,
    settings: &Settings,
    hear: &(dyn Fn(News<'_>) + Sync),
) -> Judgement {
    let asked: Vec<Claim> = names.iter().filter_map(|name| catalogue.get(name).cloned()).collect();
    let order = catalogue.in_order(&asked);
    let silent = Settings { argument: false, ..settings.clone() };
    let mut done = threads::each_after_what_it_cites(
        &order,
        &|done, name| hear(News::Begun(done, name)),
        &|claim, cited: &[&Judged]| {
            let is_asked = names.contains(&claim.name.text);
            let judged =
                unless_it_breaks_off(claim, || one(claim, cited, hand, if is_asked { settings } else { &silent }));
            if is_asked {
                hear(News::Judged(&claim.name.text, &judged.entry));
            }
            judged
        },
    );
    let judged = done.len();
    let entries = names.iter().map(|name| {
        let entry = done.remove(name).map(|judged| judged.entry);
        (name.clone(), entry.unwrap_or_else(|| Err(unknown(name))))
    });
    Judgement { entries: entries.collect(), judged }
}

/// What comes of judging a claim. An error of the search itself leaves it undecided and takes no other claim with it: what is proved
/// or refuted, the kernel has accepted.
fn unless_it_breaks_off(claim: &Claim, judge: impl FnOnce() -> Judged) -> Judged {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(judge)).unwrap_or_else(|_| {
        let outcome = broken_off(claim);
        Judged { entry: Ok(Entry { claim: claim.clone(), outcome, proof: None, explained: None }), accepted: None }
    })
}

/// Judges one claim.
///
/// # Errors
/// The claim makes no sense: its hypotheses contradict each other, or its argument cites what is not there.
pub fn one_of(catalogue: &Catalogue, name: &str, hand: &AtHand, settings: &Settings) -> Result<Entry, Fault> {
    let mut found = judge(catalogue, &[name.to_string()], hand, settings, &|_| {});
    found.entries.pop().map_or_else(|| Err(unknown(name)), |entry| entry.1)
}

/// The outcome of one claim, with no certificate at hand.
///
/// # Errors
/// As [`one_of`].
pub fn outcome_of(catalogue: &Catalogue, name: &str, limits: &Limits) -> Result<Outcome, Fault> {
    let settings = Settings { limits: limits.clone(), ..Settings::default() };
    one_of(catalogue, name, &AtHand::default(), &settings).map(|entry| entry.outcome)
}

fn unknown(name: &str) -> Fault {
    let message = format!("no claim is called {name}");
    Fault::Text(crate::refute::outcome::Diagnose { message, help: None, span: Span::default() })
}

/// The fault of a claim that makes no sense, at its place.
pub fn diagnostic(claim: &Claim, fault: Fault) -> Diagnostic {
    // A goal between numerals, as 0 = 1, is there to be proved from them.
    let is_numeral = |e: &claim::Expr| matches!(e.kind, claim::ExprKind::Number(_));
    let itself = match &claim.goal.kind {
        claim::PropKind::Compare(sides, _) if sides.iter().all(is_numeral) => {
            "; to prove the contradiction itself write `prove not (A and B)` in their place"
        }
        _ => "",
    };
    match fault {
        Fault::Contradictory { hypotheses } => Diagnostic::new(
            diagnostic::Fault::Other {
                message: format!("the hypotheses of {} contradict each other: {hypotheses}", claim.name.text),
                help: Some(format!("no values satisfy these hypotheses; remove or weaken one{itself}")),
            },
            claim.name.span,
        ),
        Fault::Text(d) => Diagnostic::new(diagnostic::Fault::Other { message: d.message, help: d.help }, d.span),
    }
}

fn one(claim: &Claim, cited: &[&Judged], hand: &AtHand, settings: &Settings) -> Judged {
    if let Some(mismatch) = dimension::of_goal(claim) {
        let entry = Entry { claim: claim.clone(), outcome: differing(claim, &mismatch), proof: None, explained: None };
        return Judged { entry: Ok(entry), accepted: None };
    }
    let accepted: Vec<&Accepted> = cited.iter().filter_map(|c| c.accepted.as_ref()).collect();
    let held = if settings.anew { None } else { hand.accepted(claim, &accepted) };
    let refuting = if settings.anew || held.is_some() { None } else { hand.refuting(claim) };
    let decided = match with_a_point(claim, &settings.limits) {
        Err(name) => Decided::without_proof(beyond(claim, name)),
        Ok(case) if case.has_no_point() && contradictory(claim, &settings.limits) => {
            return Judged { entry: Err(contradiction(claim)), accepted: None };
        }
        Ok(case) => match (held, &refuting) {
            (Some(held), _) => Decided { outcome: case.proved(), held: Some(held) },
            // A refutation at hand needs no search where it shows as much as one that is found.
            (None, Some(certificate)) if refuted::shows_sides(claim, certificate) => {
                Decided::refuted(claim, case, certificate)
            }
            (None, _) => match searched(claim, case, cited, &accepted, &settings.limits) {
                Err(fault) => return Judged { entry: Err(fault), accepted: None },
                Ok(decided) => decided,
            },
        },
    };
    let Decided { mut outcome, held } = decided;
    // A refutation at hand decides where no witness was found.
    if outcome.verdict == Verdict::Undecided
        && let Some(certificate) = &refuting
    {
        outcome = refuted::outcome(outcome, claim, certificate);
    }
    let Some((certificate, shown)) = held.filter(|_| outcome.verdict == Verdict::Proved) else {
        let refuted = outcome.witness.as_ref().filter(|_| outcome.verdict == Verdict::Refuted);
        let proof = refuted.and_then(|w| {
            refuting.or_else(|| refuted::certificate(claim, &w.point, &settings.limits)).map(Proof::refuting)
        });
        let entry = Entry { claim: claim.clone(), outcome, proof, explained: None };
        return Judged { entry: Ok(entry), accepted: None };
    };
    (outcome.used, outcome.unused) = hypotheses::used(claim, &certificate, &shown);
    outcome.method = hypotheses::method(&certificate, &shown).to_string();
    let words = settings.argument.then(|| explain::proof(claim, &certificate, &accepted).ok());
    let certificate = write(&certificate);
    let proof = Proof {
        sha256: digest(&certificate),
        statement: digest(&shown.text()),
        rests_on: shown.rests_on().iter().cloned().collect(),
        certificate,
    };
    let entry = Entry { claim: claim.clone(), outcome, proof: Some(proof), explained: words.flatten() };
    Judged { entry: Ok(entry), accepted: Some(shown) }
}

/// A claim with a point at which its hypotheses hold: one that was found, or else one that was shown to exist.
fn with_a_point(claim: &Claim, limits: &Limits) -> Result<Case, &'static str> {
    let mut case = Case::new(claim, limits)?;
    if case.has_no_point() {
        case.found_a_point(satisfiable::point(claim, &Limits { time: limits.time / CONTRADICTION, ..limits.clone() }));
    }
    Ok(case)
}

/// Whether the hypotheses are shown to contradict each other: anything follows from them.
pub fn contradictory(claim: &Claim, limits: &Limits) -> bool {
    let goal = compare(numeral(0), Relation::Equal, numeral(1));
    let absurd = Claim { goal, proof: claim::Proof::default(), using: Vec::new(), ..claim.clone() };
    prove::certificate(&absurd, &[], &Limits { time: limits.time / CONTRADICTION, ..limits.clone() }).is_ok()
}

/// The fault of a claim whose hypotheses contradict each other; without hypotheses its domains do.
pub fn contradiction(claim: &Claim) -> Fault {
    let of = |print: &dyn Fn(&Item) -> Option<String>| claim.items.iter().filter_map(print).collect::<Vec<_>>();
    let mut list = of(&|item| match item {
        Item::Assume { prop, .. } => Some(crate::claim::print::prop(prop)),
        _ => None,
    });
    if list.is_empty() {
        list = of(&|item| match item {
            Item::Given(bindings) if bindings.iter().any(|b| !b.constraints.is_empty()) => {
                Some(crate::claim::print::Style::Text.item(item))
            }
            _ => None,
        });
    }
    Fault::Contradictory { hypotheses: list.join("; ") }
}

/// What the search says of a claim.
struct Decided {
    outcome: Outcome,
    held: Option<(Certificate, Accepted)>,
}

impl Decided {
    fn without_proof(outcome: Outcome) -> Decided {
        Decided { outcome, held: None }
    }

    /// Refuted by this certificate.
    fn refuted(claim: &Claim, case: Case, certificate: &Certificate) -> Decided {
        let undecided = case.undecided(String::new(), None);
        Decided::without_proof(refuted::outcome(undecided, claim, certificate))
    }
}

/// Multiplies out, then seeks a counterexample at few points, then a proof, then a counterexample at all points.
fn searched(
    claim: &Claim,
    mut case: Case,
    cited: &[&Judged],
    accepted: &[&Accepted],
    limits: &Limits,
) -> Result<Decided, Fault> {
    let known: Vec<&Claim> = cited.iter().filter_map(|c| c.entry.as_ref().ok()).map(|e| &e.claim).collect();
    case.check(&known).map_err(Fault::Text)?;
    if let Some(reason) = case.ambiguous() {
        return Ok(Decided::without_proof(case.undecided(reason, None)));
    }
    if let Ok(held) = prove::at_once(claim, accepted, limits) {
        return Ok(Decided { outcome: case.proved(), held: Some(held) });
    }
    let first = case.counterexample(Stage::First);
    let points = match first.as_ref().and_then(|first| first.witness.as_ref()) {
        Some(witness) => vec![witness.point.clone()],
        None => case.open_points().to_vec(),
    };
    let short = Limits { time: case.time_left() / EXPANDED, ..limits.clone() };
    if !case.has_no_point()
        && let Some(witness) = other_limit::witness(claim, &points, &short)
    {
        let refuted = first.unwrap_or_else(|| case.refuted("limit"));
        return Ok(Decided::without_proof(Outcome { witness: Some(witness), ..refuted }));
    }
    if let Some(refuted) = first {
        return Ok(Decided::without_proof(other_limit::without_what_moves(claim, refuted)));
    }
    // Where evaluation found no point for the hypotheses it finds no counterexample either: it is shown to exist, or not.
    if case.has_shown_point()
        && let Some(certificate) = refuted_by_proof(claim, &case, limits, EARLY)
    {
        return Ok(Decided::refuted(claim, case, &certificate));
    }
    // A bound for all values is sought for long where there is none, and what lies beyond each bound is found at once.
    if !case.has_variables()
        && says_that_a_bound_exists(&claim.goal)
        && let Some(certificate) = refuted_by_proof(claim, &case, limits, EARLY)
    {
        return Ok(Decided::refuted(claim, case, &certificate));
    }
    let time = case.time_left().saturating_sub(limits.time / LEFT);
    let missed = match prove::by_search(claim, accepted, &Limits { time, ..limits.clone() }) {
        Ok(found) => {
            let outcome = Outcome { found_by: found.by, ..case.proved() };
            return Ok(Decided { outcome, held: Some((found.certificate, found.accepted)) });
        }
        Err(missed) => missed,
    };
    if let Some(refuted) = case.counterexample(Stage::Last) {
        return Ok(Decided::without_proof(other_limit::without_what_moves(claim, refuted)));
    }
    if !case.has_no_point()
        && let Some(certificate) = refuted_by_proof(claim, &case, limits, CONTRADICTION)
    {
        return Ok(Decided::refuted(claim, case, &certificate));
    }
    let reason = rests_on(claim, cited).unwrap_or_else(|| missed.fail.to_string());
    let outcome = case.undecided(reason, missed.fail.limit());
    Ok(Decided::without_proof(Outcome { remaining: missed.remaining, ..outcome }))
}

/// A refutation by the search for proofs: at a point with roots as coordinates, or of an existence that fails for all values, where
/// evaluation leaves it open. It takes this part of the time limit at most.
fn refuted_by_proof(claim: &Claim, case: &Case, limits: &Limits, part: u32) -> Option<Certificate> {
    let limits = Limits { time: case.time_left().min(limits.time / part), ..limits.clone() };
    let points = match &claim.goal.kind {
        claim::PropKind::Exists(..) if !case.has_variables() => vec![Point { values: Vec::new() }],
        claim::PropKind::Compare(..) => vec![satisfiable::counterexample(claim, &limits)?],
        _ if says_existence(&claim.goal) => case.open_points().to_vec(),
        _ => return None,
    };
    let each = Limits { time: limits.time / u32::try_from(points.len()).unwrap_or(1).max(1), ..limits.clone() };
    points.iter().find_map(|point| refuted::certificate(claim, point, &each))
}

/// Whether a statement says that something exists, alone or with others: an extremum says so of the place where it is attained.
fn says_existence(p: &claim::Prop) -> bool {
    match &p.kind {
        claim::PropKind::Exists(..) | claim::PropKind::Extremum(_) => true,
        claim::PropKind::And(list) => list.iter().any(says_existence),
        _ => false,
    }
}

/// Whether a statement says that there are values with a property for all others.
fn says_that_a_bound_exists(p: &claim::Prop) -> bool {
    match &p.kind {
        claim::PropKind::Exists(_, body) => {
            matches!(body.kind, claim::PropKind::ForAll(..)) || says_that_a_bound_exists(body)
        }
        _ => false,
    }
}

/// What is said of the first claim that the argument cites and that is not proved.
fn rests_on(claim: &Claim, cited: &[&Judged]) -> Option<String> {
    let mut names = Vec::new();
    instances(&claim.proof, &mut names);
    let entry = |name: &str| cited.iter().filter_map(|c| c.entry.as_ref().ok()).find(|e| e.claim.name.text == name);
    names.into_iter().filter(|name| claim.using.iter().any(|n| n.text == *name)).find_map(|name| match entry(name) {
        None => Some(format!("rests on {name}, which is at fault")),
        Some(entry) if entry.outcome.verdict == Verdict::Proved => None,
        Some(Entry { outcome, .. }) => {
            let reason = outcome.reason.as_ref().map_or(String::new(), |reason| format!(": {reason}"));
            Some(format!("rests on {name}, which is {}{reason}", outcome.verdict.name()))
        }
    })
}

/// The claims and facts of which an argument takes instances.
fn instances<'c>(proof: &'c claim::Proof, into: &mut Vec<&'c str>) {
    for step in &proof.steps {
        match step {
            Step::Have { proof, .. } | Step::Case { proof, .. } => instances(proof, into),
            Step::Obtain { .. } => {}
        }
    }
    match &proof.close {
        Some(Method::Instance { claim, .. }) => into.push(&claim.text),
        Some(Method::Induction(_, steps)) => instances(steps, into),
        _ => {}
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    #[test]
    fn an_error_of_the_search_takes_other_claims_with_it() {
        let claim = crate::claim::parse::parse("claim c \"c\"\ngiven x real\nprove x = x\n").unwrap().remove(0);
        let judged = unless_it_breaks_off(&claim, || [0usize; 0].first().map(|_| unreachable!()).unwrap());
        let outcome = judged.entry.unwrap().outcome;
        assert_eq!(outcome.verdict, Verdict::Undecided);
        assert!(outcome.reason.unwrap().contains("broke off") && judged.accepted.is_none());
    }
}
