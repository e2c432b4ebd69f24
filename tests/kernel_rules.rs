//! Each rule of the kernel of format 2, with certificates that it must accept and certificates that it must reject,
//! named by the fault. The cases stand in `tests/rules`, a file for each group of rules.
//!
//! A case is a claim without its head line, `--`, and the steps of a certificate. A case to reject says behind a colon
//! what the kernel must answer.

use carom::certificate2::text;
use carom::kernel2::{Verdict, check};

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
            assert!(matches!(kind, "accept" | "reject"), "{head}");
            assert_eq!(kind == "reject", !reason.is_empty(), "{head}");
            Case {
                accept: kind == "accept",
                name: name.to_string(),
                reason: reason.to_string(),
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
        Verdict::Rejected { reason, .. } => reason.to_string(),
        Verdict::Declined { limit } => format!("limit reached: {limit}"),
    }
}

fn file(source: &str) {
    let mut wrong = Vec::new();
    let list = cases(source);
    assert!(list.iter().any(|c| c.accept) && list.iter().any(|c| !c.accept));
    for case in &list {
        let expected = if case.accept { "accepted" } else { &case.reason };
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
            file(include_str!(concat!("rules/", stringify!($name), ".txt")));
        })*
    };
}

files! { combination power logic blocks quantifiers sums order limits }
