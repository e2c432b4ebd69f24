//! Judged or tried claims as JUnit XML: a test case for each claim, failed where the answer is not as expected.
//!
//! A failure says at which point the claim fails and what both sides are there. Each case has the claim's file and line.

use crate::claim::syntax::Expectation;
use crate::refute::outcome::Broken;
use crate::report::{Audit, Entry, Problem};
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite, XmlString};

/// The file and the line of a claim by its name.
pub(super) type Place<'a> = dyn Fn(&str) -> Option<(String, usize)> + 'a;

/// An audit.
///
/// What could not be judged is an error of the suite, so that a run that read nothing is no success.
pub(super) fn report(audit: &Audit, place: &Place<'_>) -> String {
    let cases = audit.entries.iter().map(|entry| {
        let claim = &entry.claim;
        case(&claim.name.text, &claim.title, claim.section.as_deref(), status(entry), place)
    });
    suite("carom audit", cases, &audit.problems)
}

/// A report of test cases, and of what could not be judged.
pub(super) fn suite(name: &str, cases: impl Iterator<Item = TestCase>, problems: &[Problem]) -> String {
    let mut report = Report::new(name);
    let mut suite = TestSuite::new("claims");
    suite.add_test_cases(cases);
    for problem in problems {
        let mut status = TestCaseStatus::non_success(NonSuccessKind::Error);
        status.set_message(problem.message.lines().next().unwrap_or_default());
        status.set_description(&problem.message);
        let mut case = TestCase::new(problem.name.as_str(), status);
        case.set_classname("errors");
        suite.add_test_case(case);
    }
    report.add_test_suite(suite);
    report.to_string().unwrap_or_default()
}

/// The test case of a claim.
pub(super) fn case(
    name: &str,
    title: &str,
    section: Option<&str>,
    status: TestCaseStatus,
    place: &Place<'_>,
) -> TestCase {
    let mut case = TestCase::new(format!("{name} {title}"), status);
    case.set_classname(section.unwrap_or("claims"));
    if let Some((file, line)) = place(name) {
        case.extra.insert(XmlString::new("file"), XmlString::new(file));
        case.extra.insert(XmlString::new("line"), XmlString::new(line.to_string()));
    }
    case
}

/// A failure: what is wrong on one line, and all of it.
pub(super) fn failure(verdict: &str, lines: &[String]) -> TestCaseStatus {
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
    status.set_type(verdict);
    status.set_message(format!("{verdict}: {}", lines.join("; ")));
    status.set_description(lines.join("\n"));
    status
}

/// The point at which a claim fails, and both sides of what is false there.
pub(super) fn witness(point: &[String], broken: &[Broken]) -> Vec<String> {
    let at = if point.is_empty() { "it is false".to_owned() } else { format!("fails at {}", point.join(", ")) };
    let sides = broken.iter().map(|broken| match broken.right.is_empty() {
        true => broken.statement.clone(),
        false => format!("{}: left side {}, right side {}", broken.statement, broken.left, broken.right),
    });
    std::iter::once(at).chain(sides).collect()
}

fn status(entry: &Entry) -> TestCaseStatus {
    if entry.as_expected() {
        return TestCaseStatus::success();
    }
    let found = entry.outcome.witness.as_ref();
    let mut lines = found.map_or_else(Vec::new, |found| witness(&found.point.in_words(&entry.claim), &found.broken));
    lines.extend(entry.outcome.reason.clone());
    let expected = match entry.claim.expect {
        Expectation::Proved => "proved",
        Expectation::Refuted => "refuted",
        Expectation::Undecided => "undecided",
    };
    lines.push(format!("expected: {expected}"));
    failure(entry.outcome.verdict.name(), &lines)
}
