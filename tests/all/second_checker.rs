//! The second checker of certificates, `proofs/certificates/check.py`, and the kernel say the same: of the
//! catalogue's certificates, of the cases in `tests/rules`, and of damaged certificates. Needs Python 3.9 or later;
//! without it that is said, and nothing is checked.

use crate::support;
use carom::certificate::text;
use carom::claim::syntax::Claim;
use carom::kernel::{Accepted, Verdict, check};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Python with these arguments: what it prints; `None` where there is no Python.
fn python(arguments: &[&str]) -> Option<String> {
    let output = match Command::new("python3").args(arguments).current_dir(ROOT).output() {
        Ok(output) => output,
        Err(_) => {
            println!("NOT CHECKED: python3 is not on this machine");
            return None;
        }
    };
    let (out, error) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{arguments:?}\n{out}{error}");
    Some(out.into_owned())
}

/// What the kernel says of a certificate's text.
fn verdict(claim: &Claim, source: &str, accepted: &BTreeMap<String, Accepted>) -> Result<Accepted, String> {
    let certificate = text::read(source).map_err(|fault| format!("line {}: {}", fault.line, fault.fault))?;
    let statement = carom::kernel::statement::Statement::of(claim).map_err(|fault| format!("{fault:?}"))?;
    if certificate.statement != carom::certificate::text::digest(&statement.text()) {
        return Err("another statement".to_string());
    }
    let cited: Vec<&Accepted> = claim.using.iter().filter_map(|n| accepted.get(&n.text)).collect();
    match check(claim, &certificate, &cited) {
        Verdict::Accepted(shown) => Ok(*shown),
        Verdict::Refuted => Err("it refutes the claim".to_string()),
        Verdict::Rejected { step, rule, reason } => Err(format!("step {step} ({rule}): {reason}")),
        Verdict::Declined { limit } => Err(format!("limit reached: {limit}")),
    }
}

/// Writes the catalogue's certificates to a folder, and checks them with the kernel.
fn catalogue(folder: &Path, claims: &BTreeMap<String, Claim>) -> BTreeMap<String, Accepted> {
    let mut accepted: BTreeMap<String, Accepted> = BTreeMap::new();
    let stored = |name: &str| {
        let source = std::fs::read_to_string(format!("{ROOT}/proofs/certificates/{name}.cert")).ok();
        source.filter(|source| text::refuted_by(source).is_none())
    };
    let mut open: Vec<&String> = claims.keys().filter(|name| stored(name).is_some()).collect();
    while !open.is_empty() {
        let ready =
            |name: &&String| !claims[*name].using.iter().any(|cited| open.iter().any(|other| **other == cited.text));
        let name = *open.iter().find(|name| ready(name)).expect("claims do not cite each other");
        open.retain(|other| *other != name);
        let claim = &claims[name];
        let source = stored(name).expect("a certificate");
        let shown = verdict(claim, &source, &accepted).unwrap_or_else(|why| panic!("{name}: {why}"));
        std::fs::write(folder.join(format!("{name}.cert")), source).expect("a file");
        accepted.insert(name.clone(), shown);
    }
    accepted
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("second-checker").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

#[test]
fn a_rule_is_read_in_another_way() {
    if let Some(out) = python(&["tests/second_checker/rules.py"]) {
        print!("{out}");
    }
}

#[test]
fn an_accepted_step_is_false_somewhere() {
    let count = std::env::var("CAROM_STEPS").unwrap_or_else(|_| "1500".to_string());
    if let Some(out) = python(&["tests/second_checker/truth.py", &count]) {
        print!("{out}");
    }
}

#[test]
fn a_certificate_passes_for_a_changed_claim() {
    if let Some(out) = python(&["tests/second_checker/readings.py"]) {
        print!("{out}");
    }
}

/// Writes the digest of every claim in these folders that Carom's reader gives it a statement.
fn digests(folders: &[PathBuf]) -> String {
    let mut out = String::new();
    for folder in folders {
        let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
        let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
        paths.sort();
        for path in paths.iter().filter(|path| path.extension().is_some_and(|e| e == "claim")) {
            let source = std::fs::read_to_string(path).expect("a claim file");
            for claim in carom::claim::parse::parse(&source).into_iter().flatten() {
                if let Ok(statement) = carom::kernel::statement::Statement::of(&claim) {
                    out += &format!("{} {} {}\n", text::digest(&statement.text()), claim.name.text, path.display());
                }
            }
        }
    }
    out
}

#[test]
fn a_claim_is_read_in_another_way() {
    let random = folder("written");
    let count = std::env::var("CAROM_READINGS").unwrap_or_else(|_| "300".to_string());
    let into = random.to_str().expect("a path");
    if python(&["tests/second_checker/written.py", into, &count]).is_none() {
        return;
    }
    let ours = ["tests/corpus", "tests/corpus/later", "tests/deceptions", "tests/truths", "proofs/published"];
    let mut folders: Vec<PathBuf> = ours.iter().map(|place| Path::new(ROOT).join(place)).collect();
    folders.extend([Path::new(ROOT).join("proofs/redner-2004"), random.clone()]);
    let list = random.join("digests.txt");
    std::fs::write(&list, digests(&folders)).expect("a file");
    if let Some(out) = python(&["tests/second_checker/digests.py", list.to_str().expect("a path")]) {
        print!("{out}");
    }
}

/// Whether the kernel accepts a text as a refutation, and its digest is that of what it shows.
fn refutes(claim: &Claim, source: &str) -> Option<()> {
    let certificate = text::read(source).ok()?;
    let shown = carom::kernel::refutation::of(claim, certificate.refutes.as_ref()?).ok()?;
    let statement = carom::kernel::statement::Statement::of(&shown).ok()?.text();
    let its = certificate.statement == text::digest(&statement);
    (its && matches!(check(claim, &certificate, &[]), Verdict::Refuted)).then_some(())
}

/// A damaged certificate that check.py judged.
struct Damaged {
    line: String,
    name: String,
    source: String,
    is_accepted: bool,
}

/// Those of a folder, from its file verdicts.txt: lines `NAME~K.cert VERDICT`.
fn judged(folder: &Path) -> Vec<Damaged> {
    let verdicts = std::fs::read_to_string(folder.join("verdicts.txt")).expect("verdicts");
    let read = |line: &str| {
        let (file, verdict) = line.split_once(' ').expect("a file and a verdict");
        Damaged {
            line: line.to_string(),
            name: file.split_once('~').expect("NAME~K.cert").0.to_string(),
            source: std::fs::read_to_string(folder.join(file)).expect("a damaged certificate"),
            is_accepted: verdict.starts_with("accepted"),
        }
    };
    verdicts.lines().map(read).collect()
}

#[test]
fn a_refutation_is_judged_in_another_way() {
    let (certificates, damaged) = (folder("refutations"), folder("damaged-refutations"));
    let mut claims = support::catalogue();
    let mut count = 0;
    for place in ["", "published/", "redner-2004/"] {
        if !place.is_empty() {
            for entry in std::fs::read_dir(format!("{ROOT}/proofs/{place}")).expect("a folder of claims") {
                let path = entry.expect("an entry").path();
                if path.extension().is_some_and(|e| e == "claim") {
                    let source = std::fs::read_to_string(&path).expect("a claim file");
                    let read = carom::claim::parse::parse(&source).expect("claims");
                    claims.extend(read.into_iter().map(|claim| (claim.name.text.clone(), claim)));
                }
            }
        }
        for entry in std::fs::read_dir(format!("{ROOT}/proofs/{place}certificates")).expect("certificates") {
            let path = entry.expect("an entry").path();
            let Some(source) = std::fs::read_to_string(&path).ok().filter(|s| text::refuted_by(s).is_some()) else {
                continue;
            };
            let name = path.file_stem().and_then(|n| n.to_str()).expect("a name").to_string();
            assert!(refutes(&claims[&name], &source).is_some(), "{name}");
            std::fs::write(certificates.join(format!("{name}.cert")), source).expect("a file");
            count += 1;
        }
    }
    assert!(count >= 36, "{count}");
    let certificates = certificates.to_str().expect("a path");
    let Some(out) = python(&["-B", "proofs/certificates/check.py", "proofs", "--", certificates]) else { return };
    assert_eq!(out.lines().filter(|l| l.starts_with("refuted ")).count(), count, "{out}");

    let each = std::env::var("CAROM_MUTANTS").unwrap_or_else(|_| "10".to_string());
    let into = damaged.to_str().expect("a path");
    let Some(_) = python(&["tests/second_checker/damage.py", "proofs", certificates, into, &each]) else { return };
    let (mut tried, mut differ) = (0, Vec::new());
    for Damaged { line, name, source, is_accepted } in judged(&damaged) {
        tried += 1;
        // What refutes no longer may still be a proof of something else: of that the other test speaks.
        let refuted = refutes(&claims[&name], &source).is_some();
        if refuted != is_accepted {
            differ.push(format!("{line}: the kernel {}", if refuted { "accepts it" } else { "does not" }));
        }
    }
    println!("{tried} damaged refutations, {} judged differently", differ.len());
    assert!(tried > 100 && differ.is_empty(), "{}\n{}", differ.len(), differ.join("\n"));
}

#[test]
fn a_certificate_is_judged_in_another_way() {
    let claims = support::catalogue();
    let (certificates, damaged) = (folder("certificates"), folder("damaged"));
    let accepted = catalogue(&certificates, &claims);
    let certificates = certificates.to_str().expect("a path");
    let Some(out) = python(&["-B", "proofs/certificates/check.py", "proofs", "--", certificates]) else { return };
    assert!(out.contains(&format!("{0} of {0} certificates accepted", accepted.len())), "{out}");

    let count = std::env::var("CAROM_MUTANTS").unwrap_or_else(|_| "2".to_string());
    let into = damaged.to_str().expect("a path");
    let Some(out) = python(&["tests/second_checker/damage.py", "proofs", certificates, into, &count]) else { return };
    print!("{out}");
    let (mut tried, mut differ) = (0, Vec::new());
    for Damaged { line, name, source, is_accepted } in judged(&damaged) {
        let kernel = verdict(&claims[&name], &source, &accepted);
        tried += 1;
        if kernel.is_ok() != is_accepted {
            differ.push(format!("{line}: the kernel says {}", kernel.err().unwrap_or_else(|| "accepted".to_string())));
        }
    }
    println!("{tried} damaged certificates, {} judged differently", differ.len());
    assert!(tried > 100 && differ.is_empty(), "{}\n{}", differ.len(), differ.join("\n"));
}
