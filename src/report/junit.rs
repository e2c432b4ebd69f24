//! An audit as JUnit XML: a test case for each claim, failed where the verdict is not as expected.

use super::{Audit, Entry};
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

/// The report.
///
/// What could not be judged is an error of the suite, so that a run that read nothing is no success.
pub(crate) fn report(audit: &Audit) -> String {
    let mut report = Report::new("carom audit");
    let mut suite = TestSuite::new("claims");
    suite.add_test_cases(audit.entries.iter().map(case));
    for problem in &audit.problems {
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

fn case(entry: &Entry) -> TestCase {
    let status = if entry.as_expected() {
        TestCaseStatus::success()
    } else {
        let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
        let reason = entry.outcome.reason.clone().unwrap_or_default();
        status.set_message(format!("{}: {reason}", entry.outcome.verdict.name()));
        status
    };
    let mut case = TestCase::new(format!("{} {}", entry.claim.name.text, entry.claim.title), status);
    case.set_classname(entry.claim.section.clone().unwrap_or_else(|| "claims".to_string()));
    case
}
