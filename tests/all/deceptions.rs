//! Claims written to deceive: each is false, or without a value somewhere, and was once proved. `tests/deceptions`
//! holds them by the way in which they deceive. Refused names are as good as a claim that is not proved.

#![allow(clippy::unwrap_used)] // a test stops where it fails

use crate::support::{at_least, sample};
use carom::algebra::Moment;
use carom::claim::parse::parse;
use carom::judge::outcome_of;
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::outcome::Verdict;
use std::fs;
use std::path::Path;
use std::time::Duration;

/// The claims of a file, as text.
fn claims(text: &str) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        match out.last_mut() {
            Some(last) if !line.starts_with("claim ") => *last += &format!("{line}\n"),
            _ if line.starts_with("claim ") => out.push(format!("{line}\n")),
            _ => {}
        }
    }
    out
}

#[test]
fn no_deception_succeeds() {
    let limits = Limits { time: Duration::from_secs(1), ..Limits::default() };
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/deceptions");
    // A claim with the true ones before it in its file, which it may cite.
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let mut cited = String::new();
        for claim in claims(&fs::read_to_string(&path).unwrap()) {
            let name = claim.split_whitespace().nth(1).unwrap().to_owned();
            all.push((format!("{cited}{claim}"), name.clone(), path.clone()));
            if name.starts_with("true") {
                cited += &claim;
            }
        }
    }
    let (mut count, mut truths, mut wrong) = (0, 0, Vec::new());
    for (text, name, path) in sample(all) {
        let proved = match parse(&text) {
            Ok(claims) => {
                let audited = outcome_of(&Catalogue::new(claims).unwrap(), &name, &limits);
                // Hypotheses that are found to contradict each other are an error.
                audited.is_ok_and(|outcome| outcome.verdict == Verdict::Proved)
            }
            Err(_) => false,
        };
        count += 1;
        if name.starts_with("true") {
            truths += usize::from(proved);
        } else if proved {
            wrong.push(format!("{name} of {}", path.display()));
        }
    }
    assert!(wrong.is_empty(), "proved: {wrong:#?}");
    // The true ones beside them, which differ from a deception by a little, are within reach.
    assert!(count >= at_least(360) && truths >= at_least(30), "{count}, {truths} of them true and proved");
}

/// What the procedures decide by themselves, a file for each kind of statement. They are true: no other verdict is right.
const DECIDED: &[&str] = &[
    "waves",
    "derivatives-of-sums",
    "infinite-sums",
    "limits",
    "equations",
    "nested-roots",
    "existence",
    "whole-numbers",
    "root-bounds",
    "sequences",
    "sums",
    "logarithms",
    "absolute-values",
    "quantifiers",
    "witnesses",
    "trigonometry",
    "trigonometric-equations",
    "binomials",
    "members",
    "parameters",
    "quotients",
    "orders",
    "extrema-with-roots",
    "members-in-closed-form",
    "powers-of-sums",
    "values-at-means",
    "symmetric-inequalities",
    "integral-test",
    "taylor-bounds",
    "angles",
    "arcs",
    "inductions",
    "integrals",
    "units",
    "hypergeometric-inequalities",
    "recurrences",
];

/// What a procedure decided is not lost in silence, and what is true is never refuted.
#[test]
fn no_truth_is_refuted_and_those_of_a_procedures_kind_are_proved() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/truths");
    let (mut lost, mut refuted, mut count, mut kinds) = (Vec::new(), Vec::new(), 0, 0);
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let is_decided = DECIDED.contains(&path.file_stem().unwrap().to_str().unwrap());
        kinds += usize::from(is_decided);
        // Where no proof is asked for, there is less time for a refutation.
        let limits = Limits { time: Duration::from_secs(if is_decided { 20 } else { 1 }), ..Limits::default() };
        for claim in sample(claims(&fs::read_to_string(path).unwrap())) {
            let name = claim.split_whitespace().nth(1).unwrap().to_owned();
            let catalogue = Catalogue::new(parse(&claim).unwrap()).unwrap();
            match outcome_of(&catalogue, &name, &limits).unwrap().verdict {
                Verdict::Refuted => refuted.push(name),
                Verdict::Undecided if is_decided => lost.push(name),
                _ => count += 1,
            }
        }
    }
    assert_eq!(kinds, DECIDED.len(), "a file is missing");
    assert!(refuted.is_empty(), "true, and refuted: {refuted:?}");
    assert!(lost.is_empty(), "undecided: {lost:?}");
    assert!(count >= at_least(400), "{count}");
}

/// Small files that once ran for minutes, filled the memory or broke off: each ends with a verdict, whichever.
#[test]
fn hostile_files_end() {
    // With the stack that every face of the program gives.
    let worker = std::thread::Builder::new().stack_size(64 << 20).spawn(end_with_a_verdict);
    worker.unwrap().join().unwrap();
}

fn end_with_a_verdict() {
    let limits = Limits { time: Duration::from_secs(1), ..Limits::default() };
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/hostile");
    let mut count = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        let names: Vec<String> =
            claims(&text).iter().map(|c| c.split_whitespace().nth(1).unwrap().to_owned()).collect();
        let catalogue = Catalogue::new(parse(&text).unwrap()).unwrap();
        for name in names {
            let verdict = outcome_of(&catalogue, &name, &limits).unwrap().verdict;
            // Of these alone the answer is within reach.
            assert!(
                verdict == Verdict::Undecided || ["h2", "h4", "d12", "h6", "k2"].contains(&name.as_str()),
                "{}",
                path.display()
            );
        }
        count += 1;
    }
    assert!(count >= 13, "{count}");
}

#[test]
fn a_time_limit_beyond_the_clock_is_none() {
    let limits = Limits { time: Duration::MAX, ..Limits::default() };
    let catalogue = Catalogue::new(parse("claim c \"t\"\ngiven x > 0\nprove x/x = 1\n").unwrap()).unwrap();
    assert_eq!(outcome_of(&catalogue, "c", &limits).unwrap().verdict, Verdict::Proved);
}

/// A hypothesis of several parts is used where one of them is.
#[test]
fn hypotheses_that_are_used_in_parts_are_used() {
    for said in ["x > 0 and x < 1", "0 < x < 1", "not x <= 0 and (x < 1 and 1 = 1)"] {
        let text = format!("claim c \"t\"\ngiven x, y real\nassume h: {said}\nassume y > 3\nprove x*(1 - x) > 0\n");
        let catalogue = Catalogue::new(parse(&text).unwrap()).unwrap();
        let outcome = outcome_of(&catalogue, "c", &Limits::default()).unwrap();
        assert!(outcome.verdict == Verdict::Proved, "{said}");
        assert!(outcome.used.iter().any(|u| u.starts_with("h: ")), "{said}: {:?}", outcome.used);
        assert!(
            outcome.unused.iter().all(|u| !u.contains("h: ")) && outcome.unused.iter().any(|u| u.contains("y > 3")),
            "{said}"
        );
    }
}

#[test]
fn an_evaluation_takes_longer_than_its_claim_may() {
    let limits = Limits { time: Duration::from_secs(1), ..Limits::default() };
    for goal in [
        "sum(i = 1..1000000000, i) > 0",
        "exists i in 1..100, j in 1..100, k in 1..100: i^3 + j^3 = k^3",
        "for all i in 1..1000, j in 1..1000: i^2 + j^2 != 3",
    ] {
        let catalogue = Catalogue::new(parse(&format!("claim c \"t\"\nprove {goal}\n")).unwrap()).unwrap();
        // The time that this thread works, not that of others.
        let begun = Moment::now();
        let _ = outcome_of(&catalogue, "c", &limits);
        let took = begun.elapsed();
        assert!(took < Duration::from_secs(4), "{goal}: {took:?}");
    }
}
