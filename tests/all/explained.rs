//! Proofs in words: what a reader sees of the proofs of the catalogue.

use crate::support::{catalogue, text, with_input};
use carom::certificate::Certificate;
use carom::claim::syntax::Claim;
use carom::kernel::{Accepted, Verdict, check};
use std::collections::BTreeMap;

/// A claim's certificate with what it cites.
fn proved(name: &str, claims: &BTreeMap<String, Claim>) -> (Certificate, Vec<Accepted>, Accepted) {
    let claim = &claims[name];
    let cited: Vec<Accepted> = claim.using.iter().map(|n| proved(&n.text, claims).2).collect();
    let root = env!("CARGO_MANIFEST_DIR");
    let source = std::fs::read_to_string(format!("{root}/proofs/certificates/{name}.cert")).expect("a certificate");
    let certificate = carom::certificate::text::read(&source).expect("a certificate");
    let borrowed: Vec<&Accepted> = cited.iter().collect();
    match check(claim, &certificate, &borrowed) {
        Verdict::Accepted(shown) => (certificate, cited, *shown),
        other => panic!("{name}: {other:?}"),
    }
}

fn document(name: &str) -> carom::explain::Document {
    let claims = catalogue();
    let (certificate, cited, _) = proved(name, &claims);
    let cited: Vec<&Accepted> = cited.iter().collect();
    carom::explain::proof(&claims[name], &certificate, &cited).expect("each step is taken")
}

fn words(name: &str) -> String {
    carom::explain::text::text(&document(name), 0, 100)
}

macro_rules! convincing {
    ($($test:ident: $name:literal,)*) => { $(
        #[test]
        fn $test() {
            insta::assert_snapshot!($name, words($name));
        }
    )* };
}

convincing! {
    energy_is_kept: "eq02",
    the_masses_are_equal: "eq10",
    the_best_mass: "eq14",
    when_three_are_better_than_two: "eq15",
    the_best_two_masses: "eq17",
    the_share_through_n_bodies: "eq25",
    the_gain_grows: "b-grow",
}

#[test]
fn a_proof_is_in_the_words_of_the_author() {
    let claim = "claim c \"t\"\ngiven theta real\nprove 2*cos(theta/2)^2 = 1 + cos(theta)\n";
    let said = text(&with_input(&["explain", "c", "-"], claim).stdout).to_string();
    let proof = said.split_once("\nProof\n").expect("a proof").1;
    assert!(proof.contains("cos(θ/2)^2") && !proof.contains("over"), "{said}");
}
