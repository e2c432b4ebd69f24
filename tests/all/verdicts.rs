//! Verdicts that once were wrong, or right with a wrong word beside them.
#![allow(clippy::unwrap_used)] // a test stops where it fails

use crate::support::{carom, said};
use carom::claim::embedded;
use carom::claim::parse::parse;
use carom::claim::print::Style;
use carom::claim::syntax::{Binding, Constraint, Relation};
use carom::judge::hand::AtHand;
use carom::judge::{Entry, Settings, judge, one_of, outcome_of};
use carom::kernel::statement::domain;
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::counterexample;
use carom::refute::expand::Statement;
use carom::refute::outcome::{Fault, Outcome, Verdict};
use std::time::Duration;

fn judged(body: &str) -> Result<Outcome, Fault> {
    let claims = parse(&format!("claim c \"t\"\n{body}\n")).unwrap();
    outcome_of(&Catalogue::new(claims).unwrap(), "c", &Limits::default())
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
        ("given x real; e in [0, 1)\nassume (1 - e)*x >= 0\nprove x >= 0", "e < 1"),
        // Without it, the floor has no value at b = 0.
        ("given a natural; b natural >= 1\nprove floor(a/b)*b <= a", "b >= 1"),
        ("given a, b > 0; n natural\nassume 2 < a\nprove floor(n/(a + b)) <= n/(a + b)", "b > 0"),
        ("given x > 0\ndefine u by u(0) = 1, u(1) = 2, u(k + 2) = u(k)/x\nprove u(0) = 1", "x > 0"),
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
    assert_eq!(outcome.unused, ["e >= 0", "big: x < 5 and e < 3"]);
    let outcome = proved("given x > 0; mu(k) > 0; n natural >= 2\nprove (x + 1)^2 = x^2 + 2*x + 1");
    assert_eq!(outcome.unused, ["x > 0", "mu(k) > 0", "n >= 2"]);
}

/// The whole catalogue: without all that is called not needed, nothing is refuted.
#[test]
fn without_what_the_catalogue_calls_not_needed_no_claim_is_refuted() {
    let run = || {
        let claims = embedded::claims(&[]).unwrap().unwrap();
        let names: Vec<String> = claims.iter().map(|c| c.name.text.clone()).collect();
        let catalogue = Catalogue::new(claims).unwrap();
        let found = judge(&catalogue, &names, &AtHand::of(embedded::certificates()), &Settings::default(), &|_| {});
        let mut dropped = 0;
        for (name, entry) in found.entries {
            let Entry { claim, outcome, .. } = entry.unwrap();
            if outcome.verdict != Verdict::Proved || outcome.unused.is_empty() {
                continue;
            }
            let (rest, count) = without(&Statement::of(&claim).unwrap(), &outcome.unused);
            assert_eq!(count, outcome.unused.len(), "{name}: {:?}", outcome.unused);
            let witness = counterexample::falsified(&rest, Some(Duration::from_millis(300)));
            assert!(witness.is_none(), "{name}: {:?}: {witness:?}", outcome.unused);
            dropped += count;
        }
        assert!(dropped > 20, "{dropped}");
        println!("{dropped} hypotheses not needed");
    };
    std::thread::Builder::new().stack_size(64 << 20).spawn(run).unwrap().join().unwrap();
}

/// The statement without the hypotheses that read like this, and how many they are.
fn without(statement: &Statement, unused: &[String]) -> (Statement, usize) {
    let mut out = statement.clone();
    let mut count = 0;
    let mut keep = |text: String| {
        let idle = unused.contains(&text);
        count += usize::from(idle);
        !idle
    };
    out.bindings.clear();
    for binding in &statement.bindings {
        for name in &binding.names {
            let mut single = Binding { names: vec![name.clone()], ..binding.clone() };
            if name.1.is_some() {
                if !keep(Style::Text.binding(&single)) {
                    single.constraints.clear();
                }
            } else {
                single.constraints = binding.constraints.iter().flat_map(comparisons).collect();
                let bare = single.clone();
                single.constraints.retain(|constraint| {
                    let one = Binding { constraints: vec![constraint.clone()], ..bare.clone() };
                    domain(&one).iter().all(|prop| keep(Style::Text.prop(prop)))
                });
            }
            out.bindings.push(single);
        }
    }
    out.assumptions.retain(|(label, prop)| {
        let label = label.as_ref().map_or(String::new(), |label| format!("{label}: "));
        keep(format!("{label}{}", Style::Text.prop(prop)))
    });
    (out, count)
}

/// An interval is two comparisons, of which one may stay.
fn comparisons(constraint: &Constraint) -> Vec<Constraint> {
    let (least, greatest) = (Relation::GreaterEqual, Relation::LessEqual);
    match constraint {
        Constraint::Relation(..) => vec![constraint.clone()],
        Constraint::Interval { from, from_closed, to, to_closed } => vec![
            Constraint::Relation(if *from_closed { least } else { Relation::Greater }, from.clone()),
            Constraint::Relation(if *to_closed { greatest } else { Relation::Less }, to.clone()),
        ],
        Constraint::Range(from, to) => {
            vec![Constraint::Relation(least, from.clone()), Constraint::Relation(greatest, to.clone())]
        }
    }
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
    let text = format!("claim c \"t\"\n{body}\n");
    let catalogue = Catalogue::new(parse(&text).unwrap()).unwrap();
    let entry = one_of(&catalogue, "c", &AtHand::default(), &Settings::default()).unwrap();
    let certificate = entry.proof.expect("1 = 1 needs no limit").certificate;
    assert!(!certificate.contains("limit"), "{certificate}");
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
    for (goal, said) in [("[a, 1] < [2, a]", "no order"), ("[a, 1] != [1; a]", "sizes"), ("[a, 1] != 1", "a number")] {
        let Err(Fault::Text(fault)) = judged(&format!("given a real\nprove {goal}")) else { panic!("{goal}") };
        assert!(fault.message.contains(said), "{goal}: {}", fault.message);
    }
}

#[test]
fn a_claim_whose_lemma_is_undecided_is_undecided_and_says_so() {
    let text = "claim lemma \"t\"\ngiven x, y > 0\nprove x^y + y^x > 1\n\nclaim false-lemma \"t\"\ngiven x real\nprove x > 0\n\n\
                claim user \"t\"\nusing lemma\ngiven a, b > 0\nprove a^b + b^a > 1 by lemma with x = a, y = b\n\n\
                claim next \"t\"\nusing user\ngiven c, d > 0\nprove c^d + d^c > 1 by user with a = c, b = d\n\n\
                claim other \"t\"\nusing false-lemma\ngiven a, b > 0\nprove a^b + b^a > 1 by false-lemma with x = a\n";
    let catalogue = Catalogue::new(parse(text).unwrap()).unwrap();
    let limits = Limits { time: Duration::from_secs(5), ..Limits::default() };
    let reason = |name: &str| {
        let outcome = outcome_of(&catalogue, name, &limits).unwrap();
        assert_eq!(outcome.verdict, Verdict::Undecided, "{name}");
        outcome.reason.unwrap()
    };
    assert!(reason("user").starts_with("rests on lemma, which is undecided: "), "{}", reason("user"));
    assert!(reason("next").starts_with("rests on user, which is undecided: rests on lemma"), "{}", reason("next"));
    assert_eq!(reason("other"), "rests on false-lemma, which is refuted");
}

/// Without time nothing is at fault: it is a limit, and the exit code is that of limits. Certificates at hand need no search: what they
/// show stays shown, though no point is sought that satisfies the hypotheses.
#[test]
fn an_audit_without_time_ends_at_a_limit() {
    let audit = |more: &[&str]| {
        let out = carom(&[&["audit"], more].concat());
        let text = said(&out);
        assert!(!text.contains("error"), "{more:?}: {text}");
        (out.status.code(), text)
    };
    let (code, text) = audit(&["--time", "0"]);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("0 undecided") && text.contains("no point was found"), "{text}");
    let (code, text) = audit(&["--time", "0", "--anew"]);
    assert_eq!(code, Some(3), "{text}");
    assert!(text.contains("limit reached: time"), "{text}");
    // Where the search decides, a claim that cites what is undecided says so.
    assert!(text.contains("rests on "), "{text}");
}
