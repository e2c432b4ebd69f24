//! Each rule of the kernel, with certificates that it must accept and certificates that it must reject,
//! named by the fault. The cases stand in `tests/rules`, a file for each group of rules.
//!
//! A case is a claim without its head line, `--`, and the steps of a certificate. A case to reject says behind a colon
//! what the kernel must answer.

use carom::certificate::text;
use carom::kernel::{Verdict, check};

struct Case {
    accept: bool,
    name: String,
    reason: String,
    claim: String,
    steps: String,
}

fn cases(source: &str) -> Vec<Case> {
    source
        .split("== ")
        .skip(1)
        .map(|section| {
            let (head, rest) = section.split_once('\n').expect("a heading");
            let (claim, steps) = rest.split_once("--\n").expect("`--` between claim and steps");
            let (kind, name) = head.split_once(' ').expect("accept or reject");
            let (name, reason) = name.split_once(": ").unwrap_or((name, ""));
            assert!(matches!(kind, "accept" | "refute" | "reject"), "{head}");
            assert_eq!(kind == "reject", !reason.is_empty(), "{head}");
            Case {
                accept: kind != "reject",
                name: name.to_string(),
                reason: if kind == "refute" { "refuted".to_string() } else { reason.to_string() },
                claim: format!("claim t \"t\"\n{claim}"),
                steps: steps.to_string(),
            }
        })
        .collect()
}

/// What the kernel answers, in words.
fn answer(case: &Case) -> String {
    let claims = carom::claim::parse::parse(&case.claim).unwrap_or_else(|e| panic!("{}: {e:?}", case.name));
    let written = format!(
        "carom-certificate 2\nclaim t\nstatement sha256 {}\n{}qed\n",
        "0".repeat(64),
        case.steps.trim_end().to_owned() + "\n"
    );
    let certificate = text::read(&written).unwrap_or_else(|e| panic!("{}: {e:?}\n{written}", case.name));
    // What is read is what was written.
    let again = text::read(&text::write(&certificate)).expect("what is written can be read");
    assert_eq!(text::write(&certificate), text::write(&again), "{}", case.name);
    match check(&claims[0], &again, &[]) {
        Verdict::Accepted(_) => "accepted".to_string(),
        Verdict::Refuted => "refuted".to_string(),
        Verdict::Rejected { reason, .. } => reason.to_string(),
        Verdict::Declined { limit } => format!("limit reached: {limit}"),
    }
}

fn file(source: &str) {
    let mut wrong = Vec::new();
    let list = cases(source);
    assert!(list.iter().any(|c| c.accept) && list.iter().any(|c| !c.accept));
    for case in &list {
        let expected = if case.reason.is_empty() { "accepted" } else { &case.reason };
        let found = answer(case);
        if found != expected {
            wrong.push(format!("{}:\n  expected {expected}\n  found    {found}", case.name));
        }
    }
    assert!(wrong.is_empty(), "{} of {} cases\n{}", wrong.len(), list.len(), wrong.join("\n"));
}

macro_rules! files {
    ($($name:ident)*) => {
        $(#[test]
        fn $name() {
            file(include_str!(concat!("../rules/", stringify!($name), ".txt")));
        })*
    };
}

files! { refutations evaluate combination intervals power logic blocks quantifiers sums order slope integral circle arc limits eventually intermediate names }

#[test]
fn examples_of_the_page_about_the_format() {
    let page = include_str!("../../docs/certificates.md");
    let mut count = 0;
    for block in page.split("```certificate\n").skip(1) {
        let (example, _) = block.split_once("\n```").expect("the end of the example");
        let section = format!("== accept example\n{example}\n");
        for case in cases(&section) {
            let expected = if case.steps.starts_with("refutes") { "refuted" } else { "accepted" };
            assert_eq!(answer(&case), expected, "{example}");
            count += 1;
        }
    }
    // One for each rule, a second for `slope` and for `arc`; `suppose` and `let` share one; and two refutations.
    assert_eq!(count, 29);
}

/// Propositions are compared by their keys.
#[test]
fn bound_names_do_not_matter_and_free_ones_do() {
    let key = |text: &str| {
        carom::kernel::key::prop(&carom::claim::parse::parse_prop(text).unwrap_or_else(|e| panic!("{text}: {e:?}")))
    };
    for (a, b, same) in [
        ("for all x > 0: x*y > 0", "for all z > 0: z*y > 0", true),
        ("for all x > 0: x*y > 0", "for all y > 0: y*x > 0", false),
        ("sum(i = 1..n, i) = 1", "sum(j = 1..n, j) = 1", true),
        ("sum(i = 1..n, sum(j = 1..i, j)) = 1", "sum(j = 1..n, sum(i = 1..j, i)) = 1", true),
        ("sum(i = 1..n, sum(j = 1..i, j)) = 1", "sum(i = 1..n, sum(j = 1..i, i)) = 1", false),
        ("for all x > 0: for all y > x: y > 0", "for all a > 0: for all b > a: b > 0", true),
        ("for all x > 0: for all y > x: y > 0", "for all a > 0: for all b > a: a > 0", false),
        ("for all n natural: n >= 0", "for all n real: n >= 0", false),
        ("exists x > 0: x = 1", "for all x > 0: x = 1", false),
        ("maximum of x over x > 0 at x = a is b", "maximum of y over y > 0 at y = a is b", true),
        ("maximum of x over x > 0 at x = a is b", "maximum of x over x > 0 only at x = a is b", false),
        ("a - b - c = 0", "a - (b - c) = 0", false),
        (
            "for all m real: for all n real: limit of m/n as n -> infinity is 0",
            "for all n real: for all m real: limit of n/m as n -> infinity is 0",
            false,
        ),
    ] {
        assert_eq!(key(a) == key(b), same, "{a} | {b}");
    }
}
