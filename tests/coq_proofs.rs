//! Proofs for Coq that are made from the catalogue's certificates. `proofs/coq/check` has Coq verify them.

use carom::certificate::{Certificate, text};
use carom::claim::syntax::Claim;
use carom::export::coq::{proof, statement};
use carom::kernel::{Accepted, Verdict, check};
use std::collections::{BTreeMap, BTreeSet};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

fn claims() -> BTreeMap<String, Claim> {
    let mut claims = BTreeMap::new();
    for folder in ["lemmas", "ricardo-lee-2015", "beyond"] {
        for entry in std::fs::read_dir(format!("{ROOT}/proofs/{folder}")).expect("a folder of claims") {
            let path = entry.expect("an entry").path();
            if path.extension().is_some_and(|e| e == "claim") {
                let source = std::fs::read_to_string(&path).expect("a claim file");
                for claim in carom::claim::parse::parse(&source).expect("claims") {
                    claims.insert(claim.name.text.clone(), claim);
                }
            }
        }
    }
    claims
}

/// The certificates, those of cited claims first, each with what was accepted of the claims that it cites.
fn certificates(claims: &BTreeMap<String, Claim>) -> Vec<(String, Certificate, Vec<Accepted>)> {
    let certificate = |name: &str| {
        let source = std::fs::read_to_string(format!("{ROOT}/proofs/certificates/{name}.cert")).ok();
        source.filter(|source| text::refuted_by(source).is_none())
    };
    let mut accepted: BTreeMap<String, Accepted> = BTreeMap::new();
    let mut out = Vec::new();
    let mut open: Vec<&String> = claims.keys().filter(|name| certificate(name).is_some()).collect();
    while let Some(place) =
        open.iter().position(|name| claims[*name].using.iter().all(|n| accepted.contains_key(&n.text)))
    {
        let name = open.remove(place);
        let claim = &claims[name];
        let cited: Vec<Accepted> = claim.using.iter().filter_map(|n| accepted.get(&n.text).cloned()).collect();
        let found = text::read(&certificate(name).expect("a certificate")).expect("the format");
        let borrowed: Vec<&Accepted> = cited.iter().collect();
        let Verdict::Accepted(shown) = check(claim, &found, &borrowed) else { panic!("{name} is not accepted") };
        out.push((name.clone(), found, cited));
        accepted.insert(name.clone(), *shown);
    }
    assert!(open.is_empty(), "claims that cite each other: {open:?}");
    out
}

#[test]
fn every_certificate_becomes_a_proof_for_coq() {
    // Expressions of certificates nest deeply.
    let roomy = std::thread::Builder::new().stack_size(64 << 20).spawn(made).expect("a thread");
    roomy.join().expect("proofs for Coq");
}

fn made() {
    let claims = claims();
    let mut open = BTreeSet::new();
    for (name, certificate, cited) in certificates(&claims) {
        let claim = &claims[&name];
        let cited: Vec<&Accepted> = cited.iter().collect();
        let Ok(made) = proof::proof(claim, &certificate, &cited, &|n| claims.get(n).cloned()) else {
            open.insert(name);
            continue;
        };
        let stated = statement(claim).expect("a statement");
        let theorem = format!("\nTheorem {} :\n{}.\nProof.\n", stated.name, stated.full);
        assert!(made.text.contains(&theorem), "{name}: the theorem is another");
        assert_eq!(made.text.matches("Theorem").count(), 1, "{name}");
        assert!(!made.text.contains("Admitted") && made.text.ends_with("\nQed.\n"), "{name}");
        for other in &made.cites {
            assert!(claim.using.iter().any(|n| n.text == *other), "{name} imports {other}");
        }
    }
    assert!(open.is_empty(), "a step of their certificates is not translated: {open:?}");
}

/// Rules that are not translated yet: a claim that needs one gets its statement and this reason.
const OPEN: [&str; 1] = ["slope"];

/// The library's list has every rule of the kernel but the open ones and no other, and the lemmas that it names are there.
#[test]
fn every_rule_of_the_kernel_has_its_lemma_in_the_library() {
    let file = |path: &str| std::fs::read_to_string(format!("{ROOT}/{path}")).expect("a file");
    let source = file("src/certificate/step.rs");
    let names = source
        .split_once("pub fn name(&self)")
        .and_then(|(_, after)| after.split_once("\n    }\n"))
        .expect("the names")
        .0;
    let rules: BTreeSet<&str> =
        names.lines().filter_map(|l| Some(l.split_once("=> \"")?.1.trim_end_matches("\","))).collect();
    assert!(rules.len() >= 19 && rules.contains("combination"), "{rules:?}");
    let lists = file("proofs/coq/rules.v");
    let library = ["rules", "bounds", "points", "values"].map(|name| file(&format!("proofs/coq/{name}.v"))).concat();
    let listed: BTreeMap<&str, &str> =
        lists.lines().filter_map(|line| line.trim().strip_prefix("rule ")?.split_once(": ")).collect();
    assert_eq!(listed.keys().copied().chain(OPEN).collect::<BTreeSet<_>>(), rules);
    for (rule, words) in listed {
        // Coq's own tactics.
        for word in words.trim_end_matches([' ', ')', '*']).split(", ").filter(|w| !["intro", "exists"].contains(w)) {
            let defined = ["Lemma ", "Theorem ", "Ltac "]
                .iter()
                .any(|kind| [":", " "].iter().any(|end| library.contains(&format!("{kind}{word}{end}"))));
            assert!(defined, "{rule}: the library has no {word}");
        }
    }
}
