//! Proofs for Coq that are made from the catalogue's certificates.
//!
//! With CAROM_COQ_PROOFS=DIR they are written to DIR, with the order in which Coq needs them: `proofs/coq/generated` then
//! runs Coq on them.

use carom::certificate::{Certificate, Rule, Step, text};
use carom::claim::syntax::Claim;
use carom::export::coq::{identifier, proof, statement};
use carom::kernel::{Accepted, Verdict, check};
use std::collections::{BTreeMap, BTreeSet};

/// Claims whose certificates have a step that is not translated yet; the proofs by hand cover them.
const OPEN: [&str; 0] = [];

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
fn every_certificate_becomes_a_proof_for_coq_but_those_named() {
    // Expressions of certificates nest deeply.
    let roomy = std::thread::Builder::new().stack_size(64 << 20).spawn(made).expect("a thread");
    roomy.join().expect("proofs for Coq");
}

fn made() {
    let claims = claims();
    let folder = std::env::var("CAROM_COQ_PROOFS").ok();
    let (mut open, mut order) = (BTreeSet::new(), String::new());
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
        order += &format!("{}\n", identifier(&name));
        if let Some(folder) = &folder {
            std::fs::write(format!("{folder}/{}.v", identifier(&name)), made.text).expect("a file");
        }
    }
    if let Some(folder) = &folder {
        std::fs::write(format!("{folder}/ORDER"), order).expect("a file");
    }
    assert_eq!(open.iter().map(String::as_str).collect::<Vec<_>>(), OPEN);
}

/// The library names the lemma of every rule that the catalogue uses, and no rule besides those of the kernel.
#[test]
fn every_rule_of_the_catalogue_stands_in_the_library_s_list() {
    let library = std::fs::read_to_string(format!("{ROOT}/proofs/coq/rules.v")).expect("the library");
    let listed: BTreeMap<&str, &str> =
        library.lines().filter_map(|line| line.trim().strip_prefix("rule ")?.split_once(": ")).collect();
    for (_, certificate, _) in certificates(&claims()) {
        for step in &certificate.steps {
            if let Step::Show(show) = step {
                let name = show.rule.name();
                assert!(listed.contains_key(name), "{name} is not in the list of rules.v");
                if matches!(show.rule, Rule::Suppose | Rule::Let | Rule::Extremum { .. } | Rule::Witness { .. }) {
                    continue;
                }
                let words = listed[name].trim_end_matches(['.', ')', '*', ' ']);
                for word in words.split(", ") {
                    let defined = ["Lemma ", "Theorem ", "Ltac "]
                        .iter()
                        .any(|kind| [":", " "].iter().any(|end| library.contains(&format!("{kind}{word}{end}"))));
                    assert!(defined, "{name}: rules.v has no {word}");
                }
            }
        }
    }
}
