//! One search for counterexamples: what `carom audit` refutes, `carom test` refutes at the same points, `carom repair` takes for
//! refuted and `carom explain` shows. `refutations/edges.claim` holds claims that fail where chance does not look.
#![allow(clippy::unwrap_used)] // a test stops where it fails

use crate::support::{carom, text, with_input};
use carom::claim::parse::{parse, parse_expr};
use carom::claim::print::{Style, statement};
use carom::claim::syntax::Claim;
use carom::judge::hand::AtHand;
use carom::judge::repair::{NoRepair, repair};
use carom::judge::{Entry, Settings, one_of};
use carom::property::law::{self, Outcome, law};
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::evaluate::Assignment;
use carom::refute::number::{Missing, Number};
use carom::refute::outcome::Verdict;
use carom::report::argument;
use malachite::Rational;
use std::rc::Rc;
use std::time::{Duration, Instant};

const EDGES: &str = include_str!("../refutations/edges.claim");
const TRUTHS: &str = include_str!("../truths/edges.claim");

fn deep(run: impl FnOnce() + Send + 'static) {
    std::thread::Builder::new().stack_size(64 << 20).spawn(run).unwrap().join().unwrap();
}

fn limits() -> Limits {
    Limits { time: Duration::from_secs(3), steps: 40_000, ..Limits::default() }
}

fn judged(claim: &Claim) -> Entry {
    let catalogue = Catalogue::new(vec![claim.clone()]).unwrap_or_else(|_| panic!("{}", claim.name.text));
    let settings = Settings { limits: limits(), ..Settings::default() };
    one_of(&catalogue, &claim.name.text, &AtHand::default(), &settings).unwrap_or_else(|f| panic!("{f:?}"))
}

/// What comes of a claim at the points of an audit and this number of random ones.
fn tried(claim: &Claim, cases: u32, seed: u64) -> Outcome {
    let text = statement(claim, Style::Text).join("\n");
    let text = format!("claim {} \"t\"\n{text}\n", claim.name.text);
    law(&text).unwrap_or_else(|_| panic!("{text}")).tried(&law::Settings { cases, seed, ..law::Settings::default() })
}

#[test]
fn what_fails_is_said_in_the_words_of_the_author() {
    for (goal, said) in [
        ("1/cos(t/2) = 1/cos(t/2)", "division by cos(t/2) = 0"),
        ("sin(t) <= 1 and cos(t/2) >= 0", "cos(t/2) >= 0"),
        ("ln(cos(t)) <= 0", "ln(cos(t)) takes the logarithm of a number that is not positive"),
    ] {
        let claims = parse(&format!("claim c \"t\"\ngiven t real\nprove {goal}\n")).unwrap();
        let witness = judged(&claims[0]).outcome.witness.unwrap();
        assert_eq!(witness.broken[0].statement, said, "{goal}");
    }
}

#[test]
fn both_sides_are_shown_with_digits_that_are_certain_and_differ() {
    let cube = "claim c \"t\"\ngiven x real\nassume x^2 = 2\nassume x > 0\nprove x^3 = 3\n";
    let near = "claim c \"t\"\nprove sqrt(2) = 1.41421356237309504880\n";
    let small = "claim c \"t\"\nprove 10^-30*sqrt(2) = 10^-30*sqrt(3)\n";
    // An enclosure from 0 to 0.018 has no digit but zeros.
    let wide = "claim c \"t\"\nprove (99/100)^1000000 = 1/2\n";
    for (claim, left, right) in [
        (cube, "2.828427124746...", "3"),
        (near, "1.414213562373095048801688...", "1767766952966368811/1250000000000000000"),
        (small, "1.41421356237...e-30", "1.73205080756...e-30"),
        (wide, "between 0 and 0.0180", "1/2"),
    ] {
        let json = with_input(&["audit", "-", "--format", "json"], claim);
        let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
        let broken = &json["claims"][0]["broken"][0];
        assert_eq!((broken["left"].as_str(), broken["right"].as_str()), (Some(left), Some(right)), "{claim}: {json}");
        for form in ["text", "junit"] {
            let shown = text(&with_input(&["audit", "-", "--format", form], claim).stdout);
            assert!(shown.contains(&format!("left side {left}, right side {right}")), "{claim}: {shown}");
        }
    }
}

#[test]
fn what_fails_at_an_edge_alone_fails_for_every_command() {
    deep(|| {
        let mut missed = Vec::new();
        for claim in parse(EDGES).unwrap() {
            let name = claim.name.text.as_str();
            let entry = judged(&claim);
            if entry.outcome.verdict != Verdict::Refuted {
                missed.push(format!("audit: {name}: {:?}", entry.outcome.reason));
            }
            let words = argument::text(&entry, 100);
            if !words.contains("It fails at") {
                missed.push(format!("explain: {name}: {words}"));
            }
            if let Err(NoRepair::NotRefuted(verdict)) = repair(&entry, &limits()) {
                missed.push(format!("repair: {name} is {}", verdict.name()));
            }
            if !matches!(tried(&claim, 1, 7), Outcome::Failed(_)) {
                missed.push(format!("test: {name}"));
            }
        }
        assert!(missed.is_empty(), "{missed:#?}");
    });
}

#[test]
fn what_holds_beside_an_edge_fails_for_no_command() {
    deep(|| {
        for claim in parse(TRUTHS).unwrap() {
            let name = &claim.name.text;
            let entry = judged(&claim);
            assert!(entry.outcome.verdict != Verdict::Refuted, "{name}: {:?}", entry.outcome.witness);
            let outcome = tried(&claim, 300, 11);
            assert!(!matches!(outcome, Outcome::Failed(_)), "{name}: {outcome:?}");
        }
    });
}

/// The commands themselves, on a claim that no method proves and that holds at all points, and on one that fails.
#[test]
fn the_commands_say_of_a_claim_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("two.claim").display().to_string();
    let open = "claim open \"t\"\ngiven x, y, z natural >= 1\nprove x^3 + y^3 != z^3\n";
    let wrong = EDGES.split("\n\n").find(|text| text.contains("claim derivative-that-cancels")).unwrap();
    std::fs::write(&path, format!("{open}\n{wrong}\n")).unwrap();
    let carom = |arguments: &[&str]| text(&carom(arguments).stdout);
    let counted = |text: &str| {
        let words = text.split_whitespace().collect::<Vec<_>>();
        let place = words.iter().position(|word| word.starts_with("point")).unwrap_or_else(|| panic!("{text}"));
        words[place - 1].parse::<usize>().unwrap_or_else(|_| panic!("{text}"))
    };
    let explained = carom(&["explain", "open", &path]);
    let points = counted(&explained[explained.find("No counterexample was found").unwrap()..]);
    assert!(points > 1_000 && !explained.contains("true at all"), "{explained}");
    let audit = carom(&["audit", &path, "--only", "open"]);
    assert_eq!(counted(&audit[audit.find("no counterexample").unwrap()..]), points, "{audit}");
    assert_eq!(counted(&carom(&["repair", "open", &path])), points);
    // The random points of an audit are those of the seed 0.
    let tested = carom(&["test", &path, "--only", "open", "--seed", "0", "--format", "json"]);
    let tested: serde_json::Value = serde_json::from_str(&tested).unwrap();
    let count = |key: &str| tested["claims"][0][key].as_u64().unwrap();
    assert_eq!(count("points") + count("open"), points as u64, "{tested}");

    let name = "derivative-that-cancels";
    for arguments in
        [&["audit", &path, "--only", name][..], &["test", &path, "--only", name], &["explain", name, &path]]
    {
        let text = carom(arguments);
        assert!(text.contains("c = 43") || text.contains("c = -43"), "{text}");
        assert!(text.contains("division by derivative(c^3/3 - 1849*c, c) = 0"), "{text}");
    }
    assert!(!carom(&["repair", name, &path]).contains("only a refuted claim"));
}

/// A value that the author gives to a natural variable is one of a natural number, or the sample is no point.
#[test]
fn a_sample_with_a_fraction_for_a_natural_number_refutes_nothing() {
    deep(|| {
        for (value, goal) in [("1/2", "2*n != 1"), ("-1", "n >= 0"), ("3/2", "n <= 1 or n >= 2")] {
            let text = format!("claim c \"t\"\ngiven n natural\nsample n = {value}\nprove {goal}\n");
            let entry = judged(&parse(&text).unwrap()[0]);
            assert!(entry.outcome.verdict != Verdict::Refuted, "{text}: {:?}", entry.outcome.witness);
            let sample = entry.outcome.sample.unwrap();
            assert!(sample.values != [("n".to_string(), value.to_string())], "{text}: {sample:?}");
        }
    });
}

#[test]
fn a_seed_gives_the_same_points() {
    let claim = &parse("claim far-off \"t\"\ngiven x > 0; y > 0\nprove x*y != 123/457\n").unwrap()[0];
    let narrow =
        &parse("claim narrow \"t\"\ngiven x, y > 0\nprove x^4 + y^4 > 10 or x*y < 2 or x < y + 1/10\n").unwrap()[0];
    for claim in [claim, narrow] {
        let text = |seed: u64| format!("{:?}", tried(claim, 300, seed));
        assert_eq!(text(3), text(3));
    }
}

fn at(x: (i64, i64), derivatives: &[(&str, &str)]) -> Assignment {
    let mut point = Assignment::default();
    point.values.insert("x".to_string(), Rational::from_signeds(x.0, x.1));
    let parsed = |text: &str| parse_expr(text).unwrap();
    let formulas = derivatives.iter().map(|(e, formula)| (carom::claim::print::expr(&parsed(e)), parsed(formula)));
    point.derivatives = Rc::new(formulas.collect());
    point
}

/// The value of a derivative is that of its formula where what is differentiated has no root of 0, and unknown otherwise.
#[test]
fn a_derivative_has_the_value_of_its_formula_where_it_has_one() {
    let value = |point: &Assignment, text: &str| point.number(&parse_expr(text).unwrap());
    let known = [("derivative(x^2, x)", "2*x"), ("derivative(sqrt(x), x)", "1/(2*sqrt(x))")];
    let four = at((4, 1), &known);
    assert_eq!(value(&four, "derivative(x^2, x)"), Ok(Number::Exact(Rational::from(8))));
    assert_eq!(value(&four, "derivative(sqrt(x), x)"), Ok(Number::Exact(Rational::from_signeds(1, 4))));
    // No formula is known.
    assert_eq!(value(&four, "derivative(x^3, x)"), Err(Missing::Unknown));
    let zero = at((0, 1), &known);
    assert_eq!(value(&zero, "derivative(sqrt(x), x)"), Err(Missing::Unknown));
    assert!(matches!(value(&zero, "1/derivative(x^2, x)"), Err(Missing::Undefined(_))));
    // What is differentiated has no value.
    assert!(matches!(value(&zero, "derivative(1/x, x)"), Err(Missing::Undefined(_))));
    // A formula with a hole says nothing.
    let hole = at((1, 1), &[("derivative(x^2, x)", "2*x*(x - 1)/(x - 1)")]);
    assert_eq!(value(&hole, "derivative(x^2, x)"), Err(Missing::Unknown));
}

#[test]
fn time_ends_the_search_for_points() {
    let wide = "claim wide \"t\"\ngiven x, y > 0; n natural >= 300\nprove sum(i = 1..n, exp(x/i)) > sum(j = 1..n, ln(1 + y/j)) - n*x*y\n";
    let claim = &parse(wide).unwrap()[0];
    let begin = Instant::now();
    let settings = law::Settings { cases: 1_000, seed: 1, time: Duration::from_millis(300) };
    let text = statement(claim, Style::Text).join("\n");
    let outcome = law(&format!("claim wide \"t\"\n{text}\n")).unwrap().tried(&settings);
    assert!(begin.elapsed() < Duration::from_secs(20), "{outcome:?} {:?}", begin.elapsed());
}
