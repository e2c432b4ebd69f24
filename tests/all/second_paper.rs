//! The second worked paper, `proofs/redner-2004`: made by the means that a user has, apart from the built-in catalogue.

#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::claim::format::format;
use carom::claim::parse::parse;
use carom::judge::outcome_of;
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::outcome::Verdict;
use std::fs;
use std::path::Path;

#[test]
fn every_claim_of_the_second_paper_has_the_expected_verdict() {
    // With the stack that every face of the program gives.
    let worker = std::thread::Builder::new().stack_size(64 << 20).spawn(judge_all);
    worker.unwrap().join().unwrap();
}

fn judge_all() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/redner-2004");
    let (mut count, mut accepted, mut refuted) = (0, 0, 0);
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "claim") {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        assert_eq!(format(&text).unwrap(), text, "{} is not formatted", path.display());
        let claims = parse(&text).unwrap();
        let [claim] = &claims[..] else { panic!("{}: one claim to a file", path.display()) };
        let name = claim.name.text.as_str();
        assert_eq!(path.file_stem().unwrap(), name);
        assert!(claim.source.is_some() && claim.section.is_some(), "{name}");
        let outcome = outcome_of(&Catalogue::new(claims.clone()).unwrap(), name, &Limits::default()).unwrap();
        // Those that are open: products of several roots, and an equivalence of squares.
        let is_right = outcome.verdict.is_expected(claim.expect) || outcome.verdict == Verdict::Undecided;
        assert!(is_right, "{name}: {:?}", outcome.verdict);
        accepted += usize::from(outcome.verdict == Verdict::Proved);
        refuted += usize::from(outcome.verdict == Verdict::Refuted);
        count += 1;
    }
    assert!(count >= 32 && refuted == 2 && accepted >= 26, "{count} claims, {refuted} refuted, {accepted} accepted");
}
