//! Statements of other people's papers: `tests/corpus` holds them by kind, each with the verdict that is right.
//!
//! Prints how many are decided, by kind (`cargo test --test all corpus -- --nocapture`). Fails where a verdict is wrong, and
//! where a claim that `decided.txt` lists is no longer decided. *Proved* means that the kernel accepted a certificate.
//! A third of those that `decided.txt` lists is judged. All, and the others too, each of which is searched to its limit, are
//! judged where `CAROM_WHOLE=1` or `CAROM_WRITE=1` asks for it. `CAROM_WRITE=1` writes that list again. `tests/corpus/check.py`
//! shows by evaluation that the verdicts are right.

#![allow(clippy::unwrap_used)] // a test stops where it fails

use crate::support::{at_least, sample, whole};
use carom::claim::parse::parse;
use carom::claim::syntax::{Claim, Expectation};
use carom::judge::outcome_of;
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::outcome::Verdict;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What became of a claim.
struct Judged {
    name: String,
    expected: Verdict,
    /// The verdict, or why there is none.
    verdict: Result<Verdict, String>,
    /// How long the verdict took.
    time: Duration,
}

impl Judged {
    fn is_right(&self) -> bool {
        self.verdict.as_ref().is_ok_and(|v| *v == self.expected)
    }

    fn is_wrong(&self) -> bool {
        !self.is_right() && self.verdict != Ok(Verdict::Undecided)
    }

    /// The line of `decided.txt` about a claim that is decided rightly.
    fn line(&self) -> String {
        line(&self.name, &self.expected)
    }
}

/// The line of `decided.txt` about a claim with this verdict.
fn line(name: &str, verdict: &Verdict) -> String {
    format!("{name}: {}", verdict.name())
}

/// The verdict that is right.
fn expected(claim: &Claim) -> Verdict {
    if claim.expect == Expectation::Refuted { Verdict::Refuted } else { Verdict::Proved }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus")
}

/// The kinds with their claims: a file to each.
fn kinds() -> BTreeMap<String, Vec<Claim>> {
    let paths = fs::read_dir(folder()).unwrap().map(|e| e.unwrap().path());
    paths
        .filter(|p| p.extension().is_some_and(|e| e == "claim"))
        .map(|path| {
            let claims = parse(&fs::read_to_string(&path).unwrap());
            let claims = claims.unwrap_or_else(|f| panic!("{}: {}", path.display(), f[0].message()));
            (path.file_stem().unwrap().to_str().unwrap().to_owned(), claims)
        })
        .collect()
}

/// A claim's verdict. What `decided.txt` lists has three times the time in which it was found to be decided: another machine
/// may be slower.
fn judge(claim: &Claim, is_listed: bool) -> Judged {
    let limits =
        Limits { time: Duration::from_secs(if is_listed { 9 } else { 3 }), steps: 40_000, ..Limits::default() };
    let name = claim.name.text.clone();
    let begin = Instant::now();
    let catalogue = Catalogue::new(vec![claim.clone()]).unwrap_or_else(|f| panic!("{name}: {}", f[0].1.message()));
    let verdict = outcome_of(&catalogue, &name, &limits).map(|o| o.verdict).map_err(|fault| format!("{fault:?}"));
    Judged { name, expected: expected(claim), verdict, time: begin.elapsed() }
}

/// One line of the table: what was decided of these claims.
fn row(title: &str, claims: &[&Judged]) -> String {
    let count = |test: &dyn Fn(&Judged) -> bool| claims.iter().filter(|c| test(c)).count();
    let is_true = |c: &Judged| c.expected == Verdict::Proved;
    let mut times: Vec<Duration> = claims.iter().map(|c| c.time).collect();
    times.sort();
    let ms = |t: Duration| t.as_secs_f64() * 1000.0;
    format!(
        "{title:<24}{:>5} of {:<4}{:>8} of {:<4}{:>8}{:>8}{:>9.1}{:>10.1}",
        count(&|c| is_true(c) && c.is_right()),
        count(&is_true),
        count(&|c| !is_true(c) && c.is_right()),
        count(&|c| !is_true(c)),
        count(&|c| c.verdict == Ok(Verdict::Undecided)),
        count(&Judged::is_wrong),
        ms(times.get(times.len() / 2).copied().unwrap_or_default()),
        ms(times.last().copied().unwrap_or_default()),
    )
}

/// Prints a table; where `CAROM_TABLES` names a folder it is written there as well, for those who read no output of tests.
pub(crate) fn show(name: &str, table: &[String]) {
    let text = table.join("\n");
    println!("{text}");
    if let Some(folder) = std::env::var_os("CAROM_TABLES") {
        fs::write(Path::new(&folder).join(name).with_extension("txt"), text + "\n").unwrap();
    }
}

#[test]
fn no_verdict_on_other_papers_is_wrong_and_none_is_lost() {
    // With the stack that every face of the program gives.
    let worker = std::thread::Builder::new().stack_size(64 << 20).spawn(judge_all);
    worker.unwrap().join().unwrap();
}

fn judge_all() {
    let path = folder().join("decided.txt");
    let listed: BTreeSet<String> = fs::read_to_string(&path).unwrap_or_default().lines().map(str::to_owned).collect();
    let asked = |name: &str| std::env::var_os(name).is_some();
    let is_listed = |claim: &Claim| listed.contains(&line(&claim.name.text, &expected(claim)));
    let judge = |claim: &Claim| judge(claim, is_listed(claim) && !asked("CAROM_WRITE"));
    let judged = |claims: Vec<Claim>| -> Vec<Judged> {
        if whole() || asked("CAROM_WRITE") {
            claims.iter().map(judge).collect()
        } else {
            sample(claims.iter().filter(|c| is_listed(c))).map(judge).collect()
        }
    };
    let kinds: Vec<(String, Vec<Judged>)> = kinds().into_iter().map(|(kind, claims)| (kind, judged(claims))).collect();
    let all: Vec<&Judged> = kinds.iter().flat_map(|(_, claims)| claims).collect();
    assert!(all.len() >= at_least(600), "{}", all.len());

    let mut table =
        vec!["kind                       proved     refuted   undecided   wrong  median ms  slowest".to_owned()];
    table.extend(kinds.iter().map(|(kind, claims)| row(kind, &claims.iter().collect::<Vec<_>>())));
    table.push(row("all", &all));
    show("corpus", &table);

    let wrong: Vec<String> = all
        .iter()
        .filter(|c| c.is_wrong())
        .map(|c| format!("{}: {:?}, but it is {}", c.name, c.verdict, c.expected.name()))
        .collect();
    assert!(wrong.is_empty(), "wrong verdicts:\n{}", wrong.join("\n"));

    let decided: BTreeSet<String> = all.iter().filter(|c| c.is_right()).map(|c| c.line()).collect();
    let gained = decided.difference(&listed).count();
    if std::env::var_os("CAROM_WRITE").is_some() {
        fs::write(&path, decided.into_iter().map(|line| line + "\n").collect::<String>()).unwrap();
        return;
    }
    let tried: BTreeSet<String> = all.iter().map(|c| line(&c.name, &c.expected)).collect();
    let lost: Vec<&String> =
        listed.iter().filter(|l| !decided.contains(*l) && (tried.contains(*l) || whole())).collect();
    assert!(lost.is_empty(), "decided before, and no longer:\n{lost:#?}");
    if gained > 0 {
        println!("{gained} more than decided.txt lists; CAROM_WRITE=1 cargo test --test all corpus lists them");
    }
}

#[test]
fn every_claim_of_the_corpus_has_its_own_name() {
    let mut names = BTreeSet::new();
    for (kind, claims) in kinds() {
        for claim in claims {
            assert!(names.insert(claim.name.text.clone()), "{} of {kind} is there twice", claim.name.text);
        }
    }
}
