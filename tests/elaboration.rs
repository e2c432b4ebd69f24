//! Certificates of the catalogue in format 2: each is made from the old one, written, read back and accepted by the
//! kernel of format 2. Those that are not elaborated yet are named, so that none gets lost and none is added.

use carom::certificate2::text;
use carom::kernel2::{Accepted, Verdict, check};
use std::collections::{BTreeMap, BTreeSet};

/// Claims whose certificate of format 1 does not become one of format 2 yet.
const NOT_YET: &[&str] = &[
    "b-best",
    "b-best-after",
    "b-closed",
    "b-final",
    "b-grow",
    "b-grow-limit",
    "b-limit",
    "b-limit-inelastic",
    "b-power",
    "b-power-attained",
    "eq24",
    "u11",
];

#[test]
fn certificates_of_the_catalogue_in_format_2() {
    let root = env!("CARGO_MANIFEST_DIR");
    let mut claims = BTreeMap::new();
    for folder in ["lemmas", "ricardo-lee-2015", "beyond"] {
        for entry in std::fs::read_dir(format!("{root}/proofs/{folder}")).expect("a folder of claims") {
            let path = entry.expect("an entry").path();
            if path.extension().is_some_and(|e| e == "claim") {
                let source = std::fs::read_to_string(&path).expect("a claim file");
                for claim in carom::claim::parse::parse(&source).expect("claims") {
                    claims.insert(claim.name.text.clone(), claim);
                }
            }
        }
    }
    let certificate = |name: &str| std::fs::read_to_string(format!("{root}/proofs/certificates/{name}.cert")).ok();
    let mut accepted: BTreeMap<String, Accepted> = BTreeMap::new();
    let mut stuck: BTreeMap<String, String> = BTreeMap::new();
    let mut open: Vec<&String> = claims.keys().filter(|name| certificate(name).is_some()).collect();
    while let Some(place) = open.iter().position(|name| {
        let cited = &claims[*name].using;
        cited.iter().all(|n| accepted.contains_key(&n.text) || stuck.contains_key(&n.text))
    }) {
        let name = open.remove(place);
        let claim = &claims[name];
        let cited: Vec<&Accepted> = claim.using.iter().filter_map(|n| accepted.get(&n.text)).collect();
        let old = carom::certificate::text::read(&certificate(name).expect("a certificate")).expect("format 1");
        match carom::elaborate::elaborate(claim, &old, &cited) {
            Ok((found, _)) => {
                let written = text::write(&found);
                let read = text::read(&written).expect("what is written can be read");
                match check(claim, &read, &cited) {
                    Verdict::Accepted(shown) => {
                        accepted.insert(name.clone(), *shown);
                    }
                    other => panic!("{name}: read back, it is not accepted: {other:?}"),
                }
            }
            Err(why) => {
                stuck.insert(name.clone(), format!("{why:?}").chars().take(200).collect());
            }
        }
    }
    assert!(open.is_empty(), "claims that cite each other: {open:?}");
    println!("{} of {} certificates elaborated", accepted.len(), accepted.len() + stuck.len());
    for (name, why) in &stuck {
        println!("  {name}: {why}");
    }
    let expected: BTreeSet<&str> = NOT_YET.iter().copied().collect();
    let found: BTreeSet<&str> = stuck.keys().map(String::as_str).collect();
    assert_eq!(found, expected);
}
