//! Claims written to deceive: each is false, or without a value somewhere, and was once proved. `tests/deceptions`
//! holds them by the way in which they deceive. Refused names are as good as a claim that is not proved.

#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::claim::parse::parse;
use carom::prove::catalogue::{Catalogue, Limits};
use carom::prove::outcome::Verdict;
use std::fs;
use std::path::Path;

/// The claims of a file, as text.
fn claims(text: &str) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        match out.last_mut() {
            Some(last) if !line.starts_with("claim ") => *last += &format!("{line}\n"),
            _ if line.starts_with("claim ") => out.push(format!("{line}\n")),
            _ => {}
        }
    }
    out
}

#[test]
fn no_deception_succeeds() {
    let mut count = 0;
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/deceptions");
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        let mut cited = String::new();
        for claim in claims(&text) {
            let name = claim.split_whitespace().nth(1).unwrap().to_owned();
            let proved = match parse(&format!("{cited}{claim}")) {
                Ok(claims) => {
                    Catalogue::new(claims).unwrap().audit(&name, &Limits::default()).unwrap().verdict == Verdict::Proved
                }
                Err(_) => false,
            };
            assert_eq!(proved, name.starts_with("true"), "{name} of {}", path.display());
            if proved {
                cited += &claim;
            }
            count += 1;
        }
    }
    assert!(count >= 120, "{count}");
}

#[test]
fn no_truth_is_refuted() {
    let text =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/truths/refuted-once.claim")).unwrap();
    let names: Vec<String> = claims(&text).iter().map(|c| c.split_whitespace().nth(1).unwrap().to_owned()).collect();
    assert!(names.len() >= 10);
    let mut catalogue = Catalogue::new(parse(&text).unwrap()).unwrap();
    for name in names {
        let verdict = catalogue.audit(&name, &Limits::default()).unwrap().verdict;
        assert!(verdict != Verdict::Refuted, "{name}");
    }
}
