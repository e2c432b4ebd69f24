//! Verdicts that once were wrong, or right with a wrong word beside them.
#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::claim::embedded;
use carom::claim::parse::parse;
use carom::prove::catalogue::{Catalogue, Limits};
use carom::prove::expand::Statement;
use carom::prove::outcome::{Fault, Outcome, Verdict};
use carom::prove::{need, refute};
use std::process::Command;
use std::time::Duration;

fn judged(body: &str) -> Result<Outcome, Fault> {
    let claims = parse(&format!("claim c \"t\"\n{body}\n")).unwrap();
    Catalogue::new(claims).unwrap().audit("c", &Limits::default())
}

fn proved(body: &str) -> Outcome {
    let outcome = judged(body).unwrap();
    assert_eq!(outcome.verdict, Verdict::Proved, "{body}: {:?}", outcome.reason);
    outcome
}

/// Each of these is refuted without the hypothesis that was called not needed.
#[test]
fn no_hypothesis_is_called_not_needed_that_is_needed() {
    for (body, needed) in [
        ("given x > 0; y real\nassume x*y = 0\nprove y = 0", "x > 0"),
        ("given x, y > 0; n natural >= 1\nassume x^n = y^n\nprove x = y", "n >= 1"),
        ("given x real; e in [0, 1)\nassume (1 - e)*x >= 0\nprove x >= 0", "e < 1"),
        ("given x, y > 0; p > 0\nassume x^p < y^p\nprove x < y", "p > 0"),
    ] {
        let outcome = proved(body);
        assert!(outcome.used.iter().any(|used| used == needed), "{body}: not needed: {:?}", outcome.unused);
    }
}

#[test]
fn hypotheses_past_the_127th_are_not_confused() {
    let many: String = (0..140).map(|k| format!("assume h{k}: a{k} = b{k}\n")).collect();
    let names: Vec<String> = (0..140).flat_map(|k| [format!("a{k}"), format!("b{k}")]).collect();
    let outcome = proved(&format!("given {} real\n{many}prove a139 = b139", names.join(", ")));
    assert_eq!(outcome.used, ["h139: a139 = b139"]);
    assert_eq!(outcome.unused.len(), 139);
}

#[test]
fn what_is_not_needed_is_still_said() {
    let outcome = proved("given x > 0; e in [0, 1]\nassume small: x < 1\nassume big: x < 5 and e < 3\nprove x*e < 1");
    assert_eq!(outcome.unused, ["big: x < 5 and e < 3"]);
    let outcome = proved("given x > 0; mu(k) > 0; n natural >= 2\nprove (x + 1)^2 = x^2 + 2*x + 1");
    assert_eq!(outcome.unused, ["mu(k) > 0", "n >= 2"]);
}

/// The whole catalogue: without all that is called not needed, nothing is refuted.
#[test]
fn without_what_the_catalogue_calls_not_needed_no_claim_is_refuted() {
    let run = || {
        let claims = embedded::claims(&[]).unwrap().unwrap();
        let mut catalogue = Catalogue::new(claims.clone()).unwrap();
        let mut dropped = 0;
        for claim in &claims {
            let outcome = catalogue.audit(&claim.name.text, &Limits::default()).unwrap();
            if outcome.verdict != Verdict::Proved || outcome.unused.is_empty() {
                continue;
            }
            let statement = Statement::of(claim).unwrap();
            let stated = need::hypotheses(&statement);
            let idle: Vec<&need::Hypothesis> = stated.iter().filter(|h| outcome.unused.contains(&h.text)).collect();
            assert_eq!(idle.len(), outcome.unused.len(), "{}", claim.name.text);
            let witness = refute::falsified(&need::without(&statement, &idle), Some(Duration::from_millis(300)));
            assert!(witness.is_none(), "{}: {:?}: {witness:?}", claim.name.text, outcome.unused);
            dropped += idle.len();
        }
        assert!(dropped > 20, "{dropped}");
        println!("{dropped} hypotheses not needed");
    };
    std::thread::Builder::new().stack_size(64 << 20).spawn(run).unwrap().join().unwrap();
}

/// `derivative` holds all other variables fast; where a hypothesis or premise ties them to the one that moves, a reader
/// may think of another derivative, and nothing is said.
#[test]
fn a_premise_that_ties_the_variable_of_a_derivative_counts_as_a_hypothesis_does() {
    for body in [
        "given x, y real\nprove y = x^2 => derivative(y, x) = 2*x",
        "given x, y real\nassume y = x^2\nprove derivative(y, x) = 2*x",
        "given x, y real\nprove y = x^2 <=> derivative(y, x) = 2*x",
        "given x, y real\nprove y != x^2 or derivative(y, x) = 2*x",
        "given x, y real\nprove for all z real: y = z*x => derivative(y, x) = z",
    ] {
        assert_eq!(judged(body).unwrap().verdict, Verdict::Undecided, "{body}");
    }
    proved("given x real\nlet y = x^2\nprove derivative(y, x) = 2*x");
    assert_eq!(judged("given x, y real\nprove derivative(x^2*y, x) = 2*x").unwrap().verdict, Verdict::Refuted);
}

/// What was obtained may depend on the variable of a limit, and lies between two limits all the same.
#[test]
fn no_limit_of_what_was_obtained_is_squeezed() {
    let body = "given n natural >= 1\nprove 1 = 1 {\n  obtain r > 0 with l: r <= 1/n by r = 1/(n + 1)\n  \
                have still: limit of r as n -> infinity is 0 by squeeze between 0 and 1/n\n}";
    let outcome = proved(body);
    assert!(outcome.argument.iter().all(|line| !line.text.contains("limit of r")), "{:?}", outcome.argument);
}

/// All members of a sequence have to have values, whichever the claim asks for.
#[test]
fn a_sequence_without_a_first_member_has_no_later_ones() {
    let sequence = "given x real\ndefine u by u(0) = 1/x, u(k + 1) = 2\n";
    let outcome = judged(&format!("{sequence}prove u(1) = 2")).unwrap();
    assert_eq!(outcome.verdict, Verdict::Refuted);
    assert!(outcome.witness.unwrap().broken[0].statement.contains("division by x"));
    assert_eq!(judged(&format!("{sequence}prove 1 = 1")).unwrap().verdict, Verdict::Undecided);
    proved("given x real\nassume x > 0\ndefine u by u(0) = 1/x, u(k + 1) = 2\nprove u(1) = 2");
    let outcome = judged("given x real\ndefine u by u(0) = 1, u(k + 1) = x/(k - 3)\nprove u(1) = -x/3").unwrap();
    let reason = outcome.reason.unwrap();
    assert!(reason.contains("in the sequence u") && reason.contains("k - 3") && !reason.contains('\''), "{reason}");
}

#[test]
fn matrices_differ_where_an_entry_does() {
    assert_eq!(judged("given a real\nprove [a, 1] != [1, a]").unwrap().verdict, Verdict::Refuted);
    proved("given a > 1\nprove [a, 1] != [1, a]");
    proved("given a real\nprove [a, 1] != [a + 1, 1]");
    for (goal, said) in [("[a, 1] < [2, a]", "no order"), ("[a, 1] != [1; a]", "sizes"), ("[a, 1] != 1", "a number")] {
        let Err(Fault::Text(fault)) = judged(&format!("given a real\nprove {goal}")) else { panic!("{goal}") };
        assert!(fault.message.contains(said), "{goal}: {}", fault.message);
    }
}

#[test]
fn a_claim_whose_lemma_is_undecided_is_undecided_and_says_so() {
    let text = "claim lemma \"t\"\ngiven x real\nprove exp(x) >= 1 + x\n\nclaim false-lemma \"t\"\ngiven x real\nprove x > 0\n\n\
                claim user \"t\"\nusing lemma\ngiven y real\nprove exp(y) >= 1 + y by lemma with x = y\n\n\
                claim next \"t\"\nusing user\ngiven z real\nprove exp(z) >= 1 + z by user with y = z\n\n\
                claim other \"t\"\nusing false-lemma\ngiven y real\nprove exp(y) + 1 >= y + 2 by false-lemma with x = y\n";
    let mut catalogue = Catalogue::new(parse(text).unwrap()).unwrap();
    let limits = Limits { time: Duration::from_secs(5), ..Limits::default() };
    let mut reason = |name: &str| {
        let outcome = catalogue.audit(name, &limits).unwrap();
        assert_eq!(outcome.verdict, Verdict::Undecided, "{name}");
        outcome.reason.unwrap()
    };
    assert!(reason("user").starts_with("rests on lemma, which is undecided: "), "{}", reason("user"));
    assert!(reason("next").starts_with("rests on user, which is undecided: rests on lemma"), "{}", reason("next"));
    assert_eq!(reason("other"), "rests on false-lemma, which is refuted");
}

/// Without time nothing is at fault: it is a limit, and the exit code is that of limits.
#[test]
fn an_audit_without_time_ends_at_a_limit() {
    for more in [&["--time", "0"][..], &["--time", "0", "--anew"]] {
        let out = Command::new(env!("CARGO_BIN_EXE_carom")).arg("audit").args(more).output().unwrap();
        let (text, said) = (String::from_utf8(out.stdout).unwrap(), String::from_utf8(out.stderr).unwrap());
        assert_eq!(out.status.code(), Some(3), "{more:?}: {text}{said}");
        assert!(!text.contains("error") && text.contains("limit reached: time"), "{more:?}: {text}{said}");
        // Where the search decides, a claim that cites what is undecided says so.
        assert!(more.len() == 2 || text.contains("rests on "), "{text}");
    }
}
