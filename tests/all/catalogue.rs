//! The catalogue: every claim has the expected verdict, and one reviewed snapshot each.

use carom::claim::embedded::{self, stem};
use carom::claim::format::format;
use carom::claim::parse::parse;
use carom::claim::print::{Style, statement};
use carom::judge::hand::AtHand;
use carom::judge::{Entry, Settings, judge, outcome_of};
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::outcome::Verdict;
use std::collections::BTreeSet;

/// What a snapshot holds of one claim.
fn snapshot(entry: &Entry) -> String {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let mut out = format!("{}\n{}\n", claim.title, claim.source.as_deref().unwrap_or("no source"));
    for line in statement(claim, Style::Text) {
        out.push_str(&format!("  {}\n", line.split_whitespace().collect::<Vec<_>>().join(" ")));
    }
    out.push_str(&format!("latex: {}\n", Style::Latex.prop(&claim.goal)));
    out.push_str(&format!("verdict: {}\nmethod: {}\n", outcome.verdict.name(), outcome.method));
    let mut list = |title: &str, items: &[String]| {
        if !items.is_empty() {
            out.push_str(&format!("{title}: {}\n", items.join("; ")));
        }
    };
    list("used", &outcome.used);
    list("not needed", &outcome.unused);
    let at = |values: &[(String, String)]| values.iter().map(|(n, v)| format!("{n} = {v}")).collect::<Vec<_>>();
    list("sample", &outcome.sample.as_ref().map_or(Vec::new(), |p| at(&p.values)));
    list("witness", &outcome.witness.as_ref().map_or(Vec::new(), |w| at(&w.point.values)));
    for broken in outcome.witness.iter().flat_map(|w| &w.broken) {
        list("broken", &[format!("{} | {} | {}", broken.statement, broken.left, broken.right)]);
    }
    out
}

/// Runs a test on a stack that holds the deepest trees.
fn on_large_stack(test: fn()) {
    let worker = std::thread::Builder::new().stack_size(64 << 20).spawn(test).expect("a thread starts");
    worker.join().expect("the test passes");
}

#[test]
fn every_claim_has_the_expected_verdict_and_its_snapshot() {
    on_large_stack(|| {
        let claims = embedded::claims(&[]).expect("the catalogue parses").expect("all claims");
        let names: Vec<String> = claims.iter().map(|c| c.name.text.clone()).collect();
        let catalogue = Catalogue::new(claims).expect("names and citations are in order");
        let found = judge(&catalogue, &names, &AtHand::of(embedded::certificates()), &Settings::default(), &|_| {});
        let mut unexpected = Vec::new();
        for (name, entry) in &found.entries {
            let entry = entry.as_ref().expect("the claim makes sense");
            if !entry.as_expected() {
                unexpected.push(name.clone());
            }
            let beyond = entry.claim.reading == Some(carom::claim::syntax::Reading::Beyond);
            let folder = if beyond { "beyond" } else { "ricardo-lee-2015" };
            insta::with_settings!({snapshot_path => format!("snapshots/{folder}"), prepend_module_to_snapshot => false, omit_expression => true}, {
                insta::assert_snapshot!(name.as_str(), snapshot(entry));
            });
        }
        assert!(unexpected.is_empty(), "not as expected: {unexpected:?}");
    });
}

#[test]
fn every_numbered_equation_and_display_has_its_file() {
    let stems: BTreeSet<&str> = embedded::files().iter().map(|f| stem(f.path)).collect();
    let wanted = (1..=25).map(|n| format!("eq{n:02}")).chain((1..=13).map(|n| format!("u{n}")));
    let texts = [
        "p-loss",
        "p-order",
        "p-frame",
        "p-stop",
        "p-full",
        "p-indep",
        "p-rest",
        "p-elastic",
        "p-inelastic",
        "p-two",
        "p-grow",
        "p-final",
    ];
    let beyond = [
        "b-matrix",
        "b-global",
        "b-closed",
        "b-grow",
        "b-insert",
        "b-insert-each",
        "b-best",
        "b-final",
        "b-budget",
        "b-limit",
        "b-power",
        "b-superball",
    ];
    for name in wanted.chain(texts.iter().chain(&beyond).map(|s| s.to_string())) {
        assert!(stems.contains(name.as_str()), "no file for {name}");
    }
}

#[test]
fn every_file_holds_the_claim_of_its_name_and_is_formatted() {
    for file in embedded::files() {
        let claims = parse(file.text).unwrap_or_else(|f| panic!("{}: {:?}", file.path, f));
        assert_eq!(claims[0].name.text, stem(file.path));
        let once = format(file.text).expect("it parses");
        assert_eq!(once, file.text, "{} is not formatted", file.path);
        assert_eq!(format(&once).expect("it parses"), once, "{} changes twice", file.path);
    }
}

#[test]
fn one_claim_is_judged_without_the_others() {
    let only = ["eq13".to_string()];
    let claims = embedded::claims(&only).expect("it parses").expect("it is there");
    assert_eq!(claims.len(), 1);
    let catalogue = Catalogue::new(claims).expect("in order");
    let found = judge(&catalogue, &only, &AtHand::default(), &Settings::default(), &|_| {});
    assert_eq!(found.entries[0].1.as_ref().expect("it makes sense").outcome.verdict, Verdict::Proved);
    assert_eq!(found.judged, 1);
}

#[test]
fn every_example_of_the_language_page_is_proved() {
    on_large_stack(|| {
        let mut count = 0;
        for block in carom::claim::LANGUAGE.split("```claim\n").skip(1) {
            let source = block.split("```").next().expect("a block ends");
            let claims = parse(source).unwrap_or_else(|f| panic!("{source}: {f:?}"));
            let catalogue = Catalogue::new(claims).expect("in order");
            for claim in catalogue.claims() {
                let name = &claim.name.text;
                let outcome = outcome_of(&catalogue, name, &Limits::default()).expect("it makes sense");
                assert_eq!(outcome.verdict, Verdict::Proved, "{name}: {:?}", outcome.reason);
                count += 1;
            }
        }
        assert!(count >= 6);
    });
}
