//! An audit as JUnit XML: a test case for each claim, failed where the verdict is not as expected.

use super::Entry;
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

/// The report.
pub fn report(entries: &[Entry]) -> String {
    let mut report = Report::new("carom audit");
    let mut suite = TestSuite::new("claims");
    for entry in entries {
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
        suite.add_test_case(case);
    }
    report.add_test_suite(suite);
    report.to_string().unwrap_or_default()
}
