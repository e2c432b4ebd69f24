//! The gallery `proofs/published`: statements that were published and are wrong, each with its repair.

#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::claim::embedded;
use carom::claim::format::format;
use carom::claim::parse::parse;
use carom::claim::syntax::{Claim, Expectation};
use carom::judge::outcome_of;
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::outcome::Verdict;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The files of the gallery: name, text, claims.
fn files() -> Vec<(String, String, Vec<Claim>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/published");
    let paths = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path());
    paths
        .filter(|p| p.extension().is_some_and(|e| e == "claim"))
        .map(|path| {
            let text = fs::read_to_string(&path).unwrap();
            let claims = parse(&text).unwrap_or_else(|f| panic!("{}: {}", path.display(), f[0].message()));
            (path.file_stem().unwrap().to_str().unwrap().to_owned(), text, claims)
        })
        .collect()
}

#[test]
fn what_was_published_is_refuted_and_its_repair_is_proved() {
    // With the stack that every face of the program gives.
    let worker = std::thread::Builder::new().stack_size(64 << 20).spawn(judge_all);
    worker.unwrap().join().unwrap();
}

fn judge_all() {
    let files = files();
    assert!(files.len() >= 28, "{}", files.len());
    for (name, _, claims) in files {
        let names: Vec<String> = claims.iter().map(|c| c.name.text.clone()).collect();
        assert!(names.iter().all(|n| n.starts_with(&format!("{name}-"))), "{name}: {names:?}");
        assert!(claims.iter().all(|c| c.source.is_some() && c.section.is_some()), "{name}: no source or section");
        let [published, repaired] = &claims[..] else { panic!("{name}: {names:?}") };
        assert!(repaired.name.text.ends_with("-repaired") && repaired.expect == Expectation::Proved, "{name}");
        let is_wrong = published.expect == Expectation::Refuted;
        assert!(is_wrong || published.name.text.ends_with("-counterexample"), "{name}");
        let catalogue = Catalogue::new(claims.clone()).unwrap();
        let first = outcome_of(&catalogue, &names[0], &Limits::default()).unwrap();
        assert!(first.verdict.is_expected(published.expect), "{}: {:?}", names[0], first.reason);
        assert_eq!(first.witness.is_some(), is_wrong, "{}", names[0]);
        let second = outcome_of(&catalogue, &names[1], &Limits::default()).unwrap();
        assert!(second.verdict == Verdict::Proved, "{}: {:?}", names[1], second.reason);
    }
}

#[test]
fn a_file_of_the_gallery_is_short_formatted_and_listed() {
    let list = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/published/README.md")).unwrap();
    for (name, text, _) in files() {
        let lines = text.lines().filter(|line| !line.is_empty()).count();
        assert!(lines <= 15, "{name}: {lines} lines");
        assert_eq!(format(&text).unwrap(), text, "{name} is not formatted");
        assert!(list.contains(&format!("| `{name}` |")) || name.starts_with("herbie-"), "{name} is not in the README");
    }
}

#[test]
fn the_gallery_is_no_part_of_the_built_in_catalogue() {
    let built_in: BTreeSet<&str> = embedded::files().iter().map(|f| embedded::stem(f.path)).collect();
    for (_, _, claims) in files() {
        for claim in claims {
            assert!(!built_in.contains(claim.name.text.as_str()), "{}", claim.name.text);
        }
    }
}
