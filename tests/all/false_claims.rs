//! Changed statements before the kernel, with the certificates of the statements that they were made from: what is accepted has
//! to be true.
//!
//! `CAROM_MUTANTS=N` changes each claim of the catalogue in N ways (a few, if it is not set).

#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::certificate::text::{read, refuted_by};
use carom::certificate::{Certificate, Step};
use carom::claim::embedded;
use carom::claim::parse::parse;
use carom::claim::syntax::{Claim, Prop};
use carom::kernel::statement::Statement;
use carom::kernel::{Accepted, Verdict, check, key};
use carom::refute::{counterexample, expand};
use std::collections::BTreeMap;
use std::time::Duration;

struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % n.max(1)
    }
}

/// The text of a claim with one place of its statement changed, or a hypothesis left out.
fn changed(text: &str, random: &mut Random) -> Option<String> {
    const CHANGES: &[(&str, &str)] = &[
        (" >= ", " > "),
        (" >= ", " <= "),
        (" > ", " >= "),
        (" = ", " < "),
        (" <= ", " < "),
        (" < ", " > "),
        (" + ", " - "),
        (" - ", " + "),
        ("*", "/"),
        ("/", "*"),
        (" and ", " or "),
        (" => ", " <=> "),
        ("sqrt", "cbrt"),
        ("maximum", "minimum"),
        (" only at ", " at "),
        (" real", " natural"),
    ];
    let clauses = ["given ", "let ", "define ", "assume ", "prove "];
    let mut lines: Vec<String> = text.lines().map(str::to_string).collect();
    let open: Vec<usize> = (0..lines.len()).filter(|k| clauses.iter().any(|c| lines[*k].starts_with(c))).collect();
    let at = *open.get(random.below(open.len()))?;
    let line = lines[at].clone();
    match random.below(3) {
        0 if line.starts_with("assume ") => {
            lines.remove(at);
        }
        1 => {
            let digits: Vec<usize> = line.match_indices(|c: char| c.is_ascii_digit()).map(|m| m.0).collect();
            let place = *digits.get(random.below(digits.len()))?;
            lines[at].replace_range(place..=place, &random.below(5).to_string());
        }
        _ => {
            let places = CHANGES.iter().flat_map(|(a, b)| line.match_indices(a).map(move |m| (m.0, *a, *b)));
            let places: Vec<(usize, &str, &str)> = places.collect();
            let (place, old, new) = *places.get(random.below(places.len()))?;
            lines[at].replace_range(place..place + old.len(), new);
        }
    }
    Some(lines.join("\n") + "\n")
}

/// The certificate with the new goal wherever it says the old one.
fn aimed(certificate: &Certificate, old: &Prop, new: &Prop) -> Certificate {
    let mut out = certificate.clone();
    for step in &mut out.steps {
        if let Step::Show(show) = step
            && key::prop(&show.prop) == key::prop(old)
        {
            show.prop = new.clone();
        }
    }
    out
}

/// The catalogue's proofs with their claims and files, and what the kernel accepted of them.
type Proofs = (Vec<(Claim, &'static str, Certificate)>, BTreeMap<String, Accepted>);

fn proofs() -> Proofs {
    let texts: BTreeMap<String, &str> =
        embedded::certificates().into_iter().filter(|(_, text)| refuted_by(text).is_none()).collect();
    let (mut accepted, mut out) = (BTreeMap::new(), Vec::new());
    let mut waiting: Vec<(Claim, &'static str)> = embedded::files()
        .into_iter()
        .flat_map(|file| parse(file.text).unwrap().into_iter().map(move |claim| (claim, file.text)))
        .filter(|(claim, _)| texts.contains_key(&claim.name.text))
        .collect();
    while !waiting.is_empty() {
        let ready = |c: &Claim| c.using.iter().all(|n| accepted.contains_key(&n.text));
        let place = waiting.iter().position(|(c, _)| ready(c)).unwrap();
        let (claim, text) = waiting.remove(place);
        let certificate = read(texts[&claim.name.text]).unwrap();
        let cited: Vec<&Accepted> = claim.using.iter().filter_map(|n| accepted.get(&n.text)).collect();
        let Verdict::Accepted(shown) = check(&claim, &certificate, &cited) else { panic!("{}", claim.name.text) };
        accepted.insert(claim.name.text.clone(), *shown);
        out.push((claim, text, certificate));
    }
    (out, accepted)
}

#[test]
fn a_changed_statement_is_accepted_only_if_it_is_true() {
    let each: usize = std::env::var("CAROM_MUTANTS").ok().and_then(|n| n.parse().ok()).unwrap_or(12);
    let run = move || {
        let (list, accepted) = proofs();
        let mut random = Random(0xFA15E);
        let (mut tried, mut true_ones) = (0, 0);
        for (claim, text, certificate) in &list {
            let cited: Vec<&Accepted> = claim.using.iter().filter_map(|n| accepted.get(&n.text)).collect();
            let old = Statement::of(claim).unwrap();
            for _ in 0..each {
                let Some(Ok(claims)) = changed(text, &mut random).map(|text| parse(&text)) else { continue };
                let Some(mutant) = claims.into_iter().find(|c| c.name.text == claim.name.text) else { continue };
                let Ok(new) = Statement::of(&mutant) else { continue };
                if new.text() == old.text() {
                    continue;
                }
                tried += 1;
                if matches!(check(&mutant, &aimed(certificate, &old.goal, &new.goal), &cited), Verdict::Accepted(_)) {
                    true_ones += 1;
                    let statement = expand::Statement::of(&mutant).unwrap();
                    let witness = counterexample::falsified(&statement, Some(Duration::from_millis(200)));
                    assert!(witness.is_none(), "{}accepted, and false at {witness:?}", new.text());
                }
            }
        }
        println!("{tried} changed statements, {true_ones} accepted, none of them false at a point");
        assert!(tried > 4 * list.len(), "{tried}");
        assert!(true_ones * 3 < tried, "{true_ones} of {tried}: the changes change too little");
    };
    std::thread::Builder::new().stack_size(256 << 20).spawn(run).unwrap().join().unwrap();
}
