//! Refutations with certificates: how many refuted claims have one, that none is had for what is true, and that damaged ones
//! refute nothing that an evaluator of its own does not find false.
//!
//! `cargo test --test all refutations -- --nocapture` prints how many have one, by kind. `refutations/evaluated.txt` lists those
//! that are refuted by evaluation alone, and it may only become shorter; `CAROM_WRITE=1` writes it again. `CAROM_MUTANTS=N`
//! damages each certificate in N ways.

#![allow(clippy::unwrap_used)] // a test stops where it fails

use crate::support::{at_least, sample, whole};
use carom::certificate::Refutes;
use carom::certificate::text::{digest, read, write};
use carom::claim::embedded;
use carom::claim::parse::{parse, parse_expr};
use carom::claim::print;
use carom::claim::syntax::*;
use carom::judge::hand::AtHand;
use carom::judge::{Entry, Settings, one_of, refuted};
use carom::kernel::statement::Statement;
use carom::kernel::{Verdict as Checked, check, refutation};
use carom::number::rational;
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::evaluate::Assignment;
use carom::refute::expand;
use carom::refute::outcome::{Point, Verdict};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::OnceLock;
use std::time::Duration;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");
const EVALUATED: &str = include_str!("../refutations/evaluated.txt");

fn deep<T: Send + 'static>(run: impl FnOnce() -> T + Send + 'static) -> T {
    std::thread::Builder::new().stack_size(64 << 20).spawn(run).unwrap().join().unwrap()
}

fn limits() -> Limits {
    Limits { time: Duration::from_secs(3), steps: 40_000, ..Limits::default() }
}

/// The claim files below a folder, by path.
fn files(folder: &str) -> Vec<PathBuf> {
    let (mut open, mut out) = (vec![Path::new(ROOT).join(folder)], Vec::new());
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|e| e == "claim") {
                out.push(path);
            }
        }
    }
    out.sort();
    out
}

/// Claims that are expected to be false, by kind: those of other papers by file, and those of `proofs` by folder.
fn expected() -> BTreeMap<String, Vec<Claim>> {
    let mut out: BTreeMap<String, Vec<Claim>> = BTreeMap::new();
    for (folder, by_file) in [("tests/corpus", true), ("proofs", false)] {
        // What stands in `later` is not in the language yet.
        for path in files(folder).into_iter().filter(|p| !p.to_string_lossy().contains("corpus/later")) {
            let claims = parse(&fs::read_to_string(&path).unwrap()).unwrap();
            let kind = if by_file { path.file_stem() } else { path.parent().unwrap().file_name() };
            let kind = format!("{}{}", if by_file { "" } else { "proofs/" }, kind.unwrap().to_str().unwrap());
            out.entry(kind).or_default().extend(claims.into_iter().filter(|c| c.expect == Expectation::Refuted));
        }
    }
    out.retain(|_, claims| !claims.is_empty());
    out
}

/// The same, each with what the audit says of it.
fn verdicts() -> &'static BTreeMap<String, Vec<(Claim, Entry)>> {
    static JUDGED: OnceLock<BTreeMap<String, Vec<(Claim, Entry)>>> = OnceLock::new();
    JUDGED.get_or_init(|| {
        let each = |claim: Claim| {
            let entry = judged(&claim);
            (claim, entry)
        };
        expected().into_iter().map(|(kind, claims)| (kind, claims.into_iter().map(each).collect())).collect()
    })
}

/// A claim by itself, judged from nothing.
fn judged(claim: &Claim) -> Entry {
    let catalogue = Catalogue::new(vec![Claim { using: Vec::new(), ..claim.clone() }]);
    let catalogue = catalogue.unwrap_or_else(|_| panic!("{}", claim.name.text));
    let settings = Settings { limits: limits(), anew: true, ..Settings::default() };
    one_of(&catalogue, &claim.name.text, &AtHand::default(), &settings).unwrap_or_else(|f| panic!("{f:?}"))
}

#[test]
fn a_refuted_claim_without_a_certificate_is_listed() {
    deep(|| {
        let mut table = vec![format!("{:<28}{:>8}{:>10}{:>11}", "refutations", "refuted", "certified", "evaluated")];
        let (mut listed, mut all) = (Vec::new(), (0, 0));
        for (kind, claims) in verdicts() {
            let (mut refuted, mut certified) = (0, 0);
            for (claim, entry) in claims {
                if entry.outcome.verdict != Verdict::Refuted {
                    continue;
                }
                refuted += 1;
                match &entry.proof {
                    Some(proof) => {
                        certified += 1;
                        let certificate = read(&proof.certificate).unwrap();
                        assert!(matches!(check(claim, &certificate, &[]), Checked::Refuted), "{}", claim.name.text);
                        assert_eq!(write(&certificate), proof.certificate);
                        let shown = refutation::of(claim, certificate.refutes.as_ref().unwrap()).unwrap();
                        assert_eq!(digest(&Statement::of(&shown).unwrap().text()), proof.statement);
                    }
                    None => listed.push(claim.name.text.clone()),
                }
            }
            all = (all.0 + refuted, all.1 + certified);
            table.push(format!("{kind:<28}{refuted:>8}{certified:>10}{:>11}", refuted - certified));
        }
        table.push(format!("{:<28}{:>8}{:>10}{:>11}", "all refutations", all.0, all.1, all.0 - all.1));
        super::corpus::show("refutations", &table);
        listed.sort();
        if std::env::var_os("CAROM_WRITE").is_some() {
            let text: String = listed.iter().map(|name| format!("{name}\n")).collect();
            return fs::write(format!("{ROOT}/tests/refutations/evaluated.txt"), text).unwrap();
        }
        let known: BTreeSet<&str> = EVALUATED.lines().collect();
        let new: Vec<&String> = listed.iter().filter(|name| !known.contains(name.as_str())).collect();
        assert!(new.is_empty(), "these had a certificate, or are new: {new:?}");
        // As many as ever had one. Of limits, more are refuted than can be certified.
        assert!(all.1 >= 174, "{} of {}", all.1, all.0);
    });
}

#[test]
fn what_a_quantifier_or_a_logarithm_decides_at_a_point_is_refuted_with_a_certificate() {
    deep(|| {
        let files =
            [include_str!("../refutations/quantifiers.claim"), include_str!("../refutations/transcendental.claim")];
        for claim in files.into_iter().flat_map(|text| parse(text).unwrap()) {
            let entry = judged(&claim);
            assert_eq!(entry.outcome.verdict, Verdict::Refuted, "{}", claim.name.text);
            let certificate = read(&entry.proof.unwrap_or_else(|| panic!("{}", claim.name.text)).certificate).unwrap();
            assert!(matches!(check(&claim, &certificate, &[]), Checked::Refuted), "{}", claim.name.text);
        }
    });
}

/// Small points for the variables of a claim, of its quantifiers and of its extrema.
fn points(claim: &Claim) -> Vec<Point> {
    let Ok(statement) = Statement::of(claim) else { return Vec::new() };
    let mut names: Vec<(String, bool)> = Vec::new();
    let mut add = |bindings: &[Binding]| {
        for binding in bindings {
            let plain = binding.names.iter().filter(|n| n.1.is_none());
            names.extend(plain.map(|n| (n.0.text.clone(), binding.natural)));
        }
    };
    add(&statement.bindings);
    let mut goal = &statement.goal;
    while let PropKind::ForAll(bindings, body) = &goal.kind {
        add(bindings);
        goal = body;
    }
    if let PropKind::Extremum(e) = &goal.kind {
        add(&e.over);
    }
    let reals = ["1", "2", "0", "1/2", "-1", "3", "1/4"];
    let naturals = ["1", "2", "0", "3"];
    (0..7)
        .map(|k| {
            let each = names.iter().enumerate().map(|(place, (name, natural))| {
                let list: &[&str] = if *natural { &naturals } else { &reals };
                (name.clone(), list[(k + place * (k % 3)) % list.len()].to_string())
            });
            Point { values: each.collect() }
        })
        .collect()
}

#[test]
fn a_true_claim_has_no_refutation() {
    deep(|| {
        let short = Limits { time: Duration::from_millis(60), ..limits() };
        let mut tried = 0;
        let mut claims = embedded::claims(&[]).unwrap().unwrap();
        for folder in ["tests/corpus", "tests/truths", "proofs/published", "proofs/redner-2004"] {
            for path in files(folder).into_iter().filter(|p| !p.to_string_lossy().contains("corpus/later")) {
                claims.extend(parse(&fs::read_to_string(&path).unwrap()).unwrap());
            }
        }
        // `lt4` has a derivative of y by x where y lies in [x, x]. The kernel reads derivatives as partial ones, so it may
        // refute the claim; a reader may see y = x. The search leaves such claims undecided.
        claims.retain(|c| c.expect == Expectation::Proved && c.name.text != "lt4");
        // Searching within a refutation takes time: every claim has one point.
        for (place, claim) in sample(claims.iter().enumerate()) {
            for point in points(claim).iter().skip(place % 6).take(1) {
                tried += 1;
                if let Some(found) = refuted::certificate(claim, point, &short) {
                    panic!("{} is true:\n{}", claim.name.text, write(&found));
                }
            }
        }
        assert!(tried > at_least(600), "{tried}");
    });
}

struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % n.max(1)
    }
}

/// A text with one place changed: a digit, a relation, a sign, a connective, or a line left out.
fn damaged(text: &str, random: &mut Random) -> Option<String> {
    const CHANGES: &[(&str, &str)] = &[
        (" >= ", " > "),
        (" > ", " < "),
        (" = ", " != "),
        (" <= ", " < "),
        (" < ", " >= "),
        (" != ", " = "),
        (" + ", " - "),
        (" - ", " + "),
        ("*", "/"),
        (" and ", " or "),
        (" => ", " and "),
        ("not ", ""),
        ("evaluate", "combination"),
        ("= ", "= -"),
        ("undefined ", "at x = "),
    ];
    let body = text.find("\nrefutes\n")? + 1;
    match random.below(4) {
        0 => {
            let mut lines: Vec<&str> = text.lines().collect();
            let at = 3 + random.below(lines.len() - 4);
            lines.remove(at);
            Some(lines.join("\n") + "\n")
        }
        1 => {
            let digits: Vec<usize> =
                text[body..].match_indices(|c: char| c.is_ascii_digit()).map(|m| body + m.0).collect();
            let at = *digits.get(random.below(digits.len()))?;
            Some(format!("{}{}{}", &text[..at], random.below(10), &text[at + 1..]))
        }
        _ => {
            let places =
                CHANGES.iter().flat_map(|(a, b)| text[body..].match_indices(a).map(move |m| (body + m.0, *a, *b)));
            let places: Vec<_> = places.collect();
            let (at, old, new) = *places.get(random.below(places.len()))?;
            Some(format!("{}{new}{}", &text[..at], &text[at + old.len()..]))
        }
    }
}

/// Whether the evaluator finds that a claim holds at the point of a refutation, or that a hypothesis does not; `None` where
/// it does not say.
fn holds(claim: &Claim, refutes: &Refutes) -> Option<bool> {
    let statement = expand::Statement::of(claim).ok()?;
    let mut at = Assignment::default();
    for binding in &statement.bindings {
        for (name, index) in &binding.names {
            if index.is_some() {
                return None;
            }
            if binding.natural {
                Rc::make_mut(&mut at.naturals).insert(name.text.clone());
            }
        }
    }
    for (place, value) in &refutes.point {
        let value = value.clone();
        let exact = Assignment::default().number(&value).ok()?;
        let carom::refute::number::Number::Exact(q) = exact else { return None };
        at.values.insert(print::expr(place), q);
    }
    at.sequences = Rc::new(statement.sequences.iter().map(|u| (u.name.clone(), Rc::new(u.clone()))).collect());
    let domains = statement.bindings.iter().flat_map(carom::kernel::statement::domain);
    for known in domains.chain(statement.assumptions.iter().map(|a| a.1.clone())) {
        if at.truth(&known) == Ok(false) {
            return Some(true);
        }
    }
    at.truth(&statement.goal).ok()
}

#[test]
fn a_damaged_refutation_refutes_only_what_is_false_there() {
    let each: usize =
        std::env::var("CAROM_MUTANTS").ok().and_then(|n| n.parse().ok()).unwrap_or(if whole() { 8 } else { 4 });
    deep(move || {
        let (mut tried, mut refuting, mut compared) = (0, 0, 0);
        let mut random = Random(0xCA20);
        for (claim, entry) in verdicts().values().flatten() {
            let Some(proof) = &entry.proof else { continue };
            for _ in 0..each {
                let Some(mutant) = damaged(&proof.certificate, &mut random) else { continue };
                tried += 1;
                let Ok(certificate) = read(&mutant) else { continue };
                let Some(refutes) = &certificate.refutes else { continue };
                if !matches!(check(claim, &certificate, &[]), Checked::Refuted) {
                    continue;
                }
                refuting += 1;
                if let Some(holds) = holds(claim, refutes) {
                    compared += 1;
                    assert!(!holds, "{} holds there:\n{mutant}", claim.name.text);
                }
            }
        }
        println!(
            "{tried} damaged refutations, {refuting} still refute, {compared} of these compared with the evaluator"
        );
        assert!(tried > if whole() { 1_000 } else { 500 } && compared > 0, "{tried} {compared}");
        assert!(refuting * 3 < tried, "{refuting} of {tried} still refute");
    });
}

#[test]
fn a_number_that_the_kernel_encloses_is_the_one_that_the_evaluator_finds() {
    // Both enclose independently: neither may decide what the other denies.
    let exprs = [
        "sqrt(2)",
        "3^(1/3)",
        "2^(-5/7)",
        "exp(1)",
        "exp(-20)",
        "exp(1/1000)",
        "ln(2)",
        "ln(1/1000)",
        "ln(10^30)",
        "cosh(3)",
        "sinh(-1/2)",
        "tanh(2)",
        "sech(5)",
        "7^sqrt(2)",
        "(1/3)^exp(1)",
        "sum(i = 1..20, 1/i)",
        "product(i = 1..9, sqrt(i))",
        "(1 + 1/100)^100",
        "10^(1/99)",
        "cbrt(10^20 + 1)",
    ];
    for text in exprs {
        let number = Assignment::default().number(&parse_expr(text).unwrap()).unwrap();
        let (low, high) = match number {
            carom::refute::number::Number::Exact(q) => (q.clone(), q),
            carom::refute::number::Number::Between(low, high, _) => (low, high),
        };
        let width = rational::parse("1e-20").unwrap();
        let (below, above) = (
            print::expr(&carom::refute::literal::literal(&(&low - &width))),
            print::expr(&carom::refute::literal::literal(&(&high + &width))),
        );
        let goal = format!("{below} < {text} and {text} < {above}");
        let claims = parse(&format!("claim t \"t\"\nprove {goal}\n")).unwrap();
        let steps =
            format!("carom-certificate 2\nclaim t\nstatement sha256 {}\n1 evaluate: {goal}\nqed\n", "0".repeat(64));
        let verdict = check(&claims[0], &read(&steps).unwrap(), &[]);
        assert!(matches!(verdict, Checked::Accepted(_)), "{goal}: {verdict:?}");
    }
}
