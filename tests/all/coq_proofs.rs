//! Proofs for Coq that are made from the catalogue's certificates. `proofs/coq/check` has Coq verify them.

use crate::certificates::{Random, damaged};
use crate::support::catalogue;
use carom::certificate::{Certificate, text};
use carom::claim::syntax::Claim;
use carom::export::coq::{proof, statement};
use carom::kernel::statement::Statement;
use carom::kernel::{Accepted, Verdict, check};
use std::collections::{BTreeMap, BTreeSet};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

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
    let claims = catalogue();
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

/// What Coq is given for a claim and these steps.
fn translated(claim: &str, steps: &str) -> String {
    let claim = carom::claim::parse::parse(&format!("claim t \"t\"\n{claim}")).expect("a claim").remove(0);
    let digest = text::digest(&Statement::of(&claim).expect("a statement").text());
    let source = format!("carom-certificate 2\nclaim t\nstatement sha256 {digest}\n{steps}qed\n");
    let certificate = text::read(&source).expect("the format");
    proof::proof(&claim, &certificate, &[], &|_| None).expect("a proof").text
}

#[test]
fn a_comparison_by_the_sign_of_a_derivative_rests_on_the_mean_value_theorem() {
    let steps = "1 let: for all t > 1: derivative(t - 1 - ln(t), t) > 0\n\
                 2 combination: derivative(t - 1 - ln(t), t) > 0\n| term: (t - 1)/t\n| by 1d1\nend 2\n\
                 3 slope from 1: x - 1 - ln(x) > 1 - 1 - ln(1)\n| with a = 1\n| with b = x\n| by h1\n\
                 4 combination: ln(x) < x - 1\n| term 3: -1\n| by h1\n";
    let text = translated("given x > 1\nprove ln(x) < x - 1\n", steps);
    // 1 lies in the domain with its end only: there, too, the function has a derivative.
    assert!(text.contains("forall (t : R), t >= 1 -> ex_derive (fun t : R => t - 1 - ln t) t"), "{text}");
    assert!(text.contains("(slope (fun t : R => t - 1 - ln t) 1 x GT GT GT "), "{text}");
}

#[test]
fn a_square_root_of_what_may_be_0_is_no_power_of_a_logarithm() {
    let steps = "1 power: ((x^2 + y^2)^(1/2))^2 = x^2 + y^2\n";
    let text = translated("given x, y real\nprove ((x^2 + y^2)^(1/2))^2 = x^2 + y^2\n", steps);
    assert!(text.contains("sqrt (x ^ 2 + y ^ 2) ^ 2 = x ^ 2 + y ^ 2") && !text.contains("Rpower"), "{text}");
    let text = translated("given x > 0\nprove (x^(1/2))^2 = x\n", "1 power: (x^(1/2))^2 = x\n| by h1\n");
    assert!(text.contains("sqrt x ^ 2 = x") && !text.contains("Rpower"), "{text}");
}

#[test]
fn a_changed_certificate_proves_no_other_statement() {
    let roomy = std::thread::Builder::new().stack_size(64 << 20).spawn(changed).expect("a thread");
    roomy.join().expect("proofs for Coq");
}

fn changed() {
    let claims = catalogue();
    let mut random = Random(0x00C0_FFEE);
    let (mut tried, mut made) = (0, 0);
    for (name, certificate, cited) in certificates(&claims) {
        let claim = &claims[&name];
        let cited: Vec<&Accepted> = cited.iter().collect();
        let stated = statement(claim).expect("a statement");
        let source = text::write(&certificate);
        for kind in 0..11 {
            let Some((_, mutant)) = damaged(&source, kind, &mut random) else { continue };
            tried += 1;
            let Ok(certificate) = text::read(&mutant) else { continue };
            // Each step is asked of the kernel: what it refuses is not translated.
            let Ok(proof) = proof::proof(claim, &certificate, &cited, &|n| claims.get(n).cloned()) else { continue };
            made += 1;
            let theorem = format!("\nTheorem {} :\n{}.\nProof.\n", stated.name, stated.full);
            assert!(proof.text.contains(&theorem) && proof.text.matches("Theorem").count() == 1, "{name}: {mutant}");
            assert!(!proof.text.contains("Admitted") && !proof.text.contains("admit."), "{name}: {mutant}");
        }
    }
    println!("{tried} changed certificates, proofs of {made}");
    assert!(tried > 500 && made * 2 < tried, "{tried} tried, {made} made");
}

/// The library's list has every rule of the kernel and no other, and the lemmas that it names are there.
#[test]
fn every_rule_of_the_kernel_has_its_lemma_in_the_library() {
    let file = |path: &str| std::fs::read_to_string(format!("{ROOT}/{path}")).expect("a file");
    let source = file("src/checker/certificate/step.rs");
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
    assert_eq!(listed.keys().copied().collect::<BTreeSet<_>>(), rules);
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
