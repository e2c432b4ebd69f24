//! Small files that made the kernel run for minutes, or fill the memory: each ends at once, with an answer or
//! at a limit that has a name.
#![allow(clippy::unwrap_used)]

use carom::certificate::text::read;
use carom::claim::parse::parse;
use carom::kernel::{Verdict, check};
use std::fmt::Write;
use std::sync::mpsc::channel;
use std::time::Duration;

/// Far more than any of these takes, on a slow machine as well.
const BOUND: Duration = Duration::from_secs(120);

/// What the kernel says of steps that show a claim, or a failure of the test after [`BOUND`].
fn verdict(items: &str, goal: &str, steps: &str) -> String {
    let claim = format!("claim small \"t\"\n{items}prove {goal}\n");
    let certificate = format!("carom-certificate 2\nclaim small\nstatement sha256 {}\n{steps}qed\n", "0".repeat(64));
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        let claims = parse(&claim).unwrap();
        let verdict = match check(&claims[0], &read(&certificate).unwrap(), &[]) {
            Verdict::Accepted(_) => "accepted".to_string(),
            Verdict::Rejected { reason, .. } => format!("rejected: {reason}"),
            Verdict::Declined { limit } => format!("limit: {limit}"),
            Verdict::Refuted => "refuted".to_string(),
        };
        let _ = sender.send(verdict);
    });
    receiver.recv_timeout(BOUND).expect("the kernel ends")
}

/// By the signs that the first hypotheses give.
fn by_signs(items: &str, goal: &str, hypotheses: u32) -> String {
    let by = joined(1..hypotheses + 1, " ", |k| format!("h{k}"));
    verdict(items, goal, &format!("1 combination: {goal}\n    | by {by}\n"))
}

fn by_sign(items: &str, goal: &str) -> String {
    by_signs(items, goal, 1)
}

fn nested(depth: usize) -> String {
    (0..depth).fold("x".to_string(), |inner, _| format!("ln(({inner} + 2)^30 + 1)"))
}

fn joined(range: std::ops::Range<u32>, between: &str, part: impl Fn(u32) -> String) -> String {
    range.map(part).collect::<Vec<_>>().join(between)
}

#[test]
fn an_atom_that_stands_in_many_terms_is_looked_at_once() {
    assert_eq!(by_sign("given x > 0\n", &format!("{} > 0", nested(8))), "accepted");
    let goal = format!("limit of {}/(n + 1) as n -> infinity is 0", nested(8));
    assert_eq!(
        verdict(
            "given x > 0; n natural >= 1\n",
            &goal,
            &format!("1 limit: {goal}\n    | with from = 1\n    | by h1\n")
        ),
        "accepted"
    );
}

#[test]
fn a_prime_that_divides_often_is_one_prime() {
    assert_eq!(by_sign("given x > 0\n", "ln(2^40000) > 0"), "accepted");
    let root = "sqrt(3^10000)";
    assert_eq!(by_sign("given x > 0\n", &format!("{root} > 0")), "accepted");
}

#[test]
fn long_numbers_end_at_a_limit() {
    let product = joined(0..3000, "*", |_| "9e9999".to_string());
    assert!(["limit: digits", "limit: work"].contains(&by_sign("given x > 0\n", &format!("{product} > 0")).as_str()));
    let sum = joined(0..300, " + ", |k| format!("1/(1e9999 + {})", 2 * k + 1));
    assert!(["limit: digits", "limit: work"].contains(&by_sign("given x > 0\n", &format!("{sum} > 0")).as_str()));
    assert_eq!(by_sign("given x > 0\n", "((2^1000)^1000)^1000 > 0"), "limit: digits");
}

#[test]
fn long_products_and_sums_take_time_in_proportion() {
    let product = joined(1..3000, "*", |k| format!("(x + {k})"));
    assert_eq!(by_sign("given x > 0\n", &format!("{product} > 0")), "accepted");
    let side = |name: char| joined(0..150, " + ", |k| format!("{name}{k}"));
    let given = |name: char| joined(0..150, ", ", |k| format!("{name}{k}"));
    let items = format!("given {}, {} > 0\n", given('a'), given('b'));
    assert_eq!(by_signs(&items, &format!("({})*({}) + 1 > 0", side('a'), side('b')), 300), "limit: terms");
}

#[test]
fn definitions_in_definitions_share_one_budget() {
    let mut doubled = "given x > 0\nlet a0 = x + x\n".to_string();
    for k in 1..16 {
        writeln!(doubled, "let a{k} = a{0} + a{0}", k - 1).unwrap();
    }
    let copies: String = (0..400).map(|k| format!("let b{k} = a15\n")).collect();
    assert_eq!(verdict(&format!("{doubled}{copies}"), "x > 0", ""), "limit: size");
    // A bound name does not copy the definitions.
    let sums = joined(0..1000, " + ", |_| "sum(i = 1..3, i)".to_string());
    let items = format!("{}assume {sums} > 0\n", doubled.replacen("let a15 = a14 + a14\n", "", 1));
    assert_eq!(verdict(&items, "x > 0", "1 logic from h1: x > 0\n"), "accepted");
}

#[test]
fn names_are_limited() {
    let names = joined(0..1001, ", ", |k| format!("x{k}"));
    assert_eq!(verdict(&format!("given {names} real\n"), "x1 = x1", "1 combination: x1 = x1\n"), "limit: names");
}

#[test]
fn citing_long_facts_is_work() {
    // Each step reads the long implication again.
    let long = joined(0..4000, " and ", |_| "x > 0".to_string());
    let items = format!("given x > 0; y real\nassume {long} => y > 0\n");
    let steps: String = (1..8000).map(|k| format!("{k} logic from h2 a: y > 0\n")).collect();
    let all = format!("a logic from h1: {long}\n{steps}");
    assert_eq!(verdict(&items, "y > 0", &all), "limit: work");
}
