//! Derivations of our own with errors planted in them, one at a time: a sign, a factor, an exponent, an index.
//!
//! A planted error is found if the claim that is named beside it is refuted. Nothing may be found in the text as it is.

use carom::claim::syntax::Claim;
use carom::judge::hand::AtHand;
use carom::judge::{Settings, one_of};
use carom::latex::{Outcome, paper};
use carom::refute::catalogue::Catalogue;
use carom::refute::outcome::Verdict;

/// The claims of a text, and what is said of formulas that are not read.
fn read(text: &str) -> (Vec<Claim>, Vec<String>) {
    let found = paper(text).unwrap();
    let mut faults: Vec<String> = found.faults.iter().map(|fault| fault.message()).collect();
    let mut claims = Vec::new();
    for equation in found.equations {
        match equation.outcome {
            Outcome::Read(claim) => claims.push(*claim),
            Outcome::NotRead(list) => faults.extend(list.iter().map(|fault| fault.message())),
            Outcome::Used(_) | Outcome::Waits(_) | Outcome::Skipped(_) => {}
        }
    }
    (claims, faults)
}

fn verdict(claims: &[Claim], name: &str) -> Verdict {
    let catalogue = Catalogue::new(claims.to_vec()).unwrap();
    one_of(&catalogue, name, &AtHand::default(), &Settings::default()).unwrap().outcome.verdict
}

/// What is wrong with a derivation and its planted errors.
fn tried(text: &str, changes: &str) -> Vec<String> {
    let mut wrong = Vec::new();
    let (claims, faults) = read(text);
    wrong.extend(faults);
    for claim in &claims {
        if verdict(&claims, &claim.name.text) != Verdict::Proved {
            wrong.push(format!("a false alarm: {}", claim.name.text));
        }
    }
    let list: Vec<&str> = changes.lines().filter(|line| !line.starts_with('#')).collect();
    assert_eq!(list.len(), 10);
    for line in list {
        let Some((from, (to, name))) = line.split_once('\t').map(|(from, rest)| (from, rest.split_once('\t').unwrap()))
        else {
            panic!("{line}");
        };
        assert_eq!(text.matches(from).count(), 1, "{line}");
        let (claims, faults) = read(&text.replace(from, to));
        if !faults.is_empty() || verdict(&claims, name) != Verdict::Refuted {
            wrong.push(format!("not found: {line}; {}", faults.join("; ")));
        }
    }
    wrong
}

macro_rules! derivation {
    ($test:ident, $name:literal) => {
        #[test]
        fn $test() {
            let text = include_str!(concat!("derivations/", $name, ".tex"));
            let wrong = tried(text, include_str!(concat!("derivations/", $name, ".changes")));
            assert!(wrong.is_empty(), "{}", wrong.join("\n"));
        }
    };
}

derivation!(an_error_in_a_collision_is_missed, "collision");
derivation!(an_error_in_a_throw_is_missed, "throw");
derivation!(an_error_in_springs_is_missed, "springs");
derivation!(an_error_in_a_triangle_is_missed, "triangle");
derivation!(an_error_in_a_lens_is_missed, "lens");
