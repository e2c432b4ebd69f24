//! `carom repair`: refuted claims of the catalogue and of the gallery, and true ones of which a hypothesis is dropped, with
//! the hypothesis that is found. Whatever is found is checked again here, from the text of its certificate.
#![allow(clippy::unwrap_used)] // a test stops where it fails

use crate::support::{at_least, sample};
use carom::certificate::text::{read, write};
use carom::claim::parse::parse;
use carom::claim::print;
use carom::claim::syntax::{Claim, Expectation, Item};
use carom::judge::hand::AtHand;
use carom::judge::repair::{Repair, repair};
use carom::judge::{Entry, Settings, one_of};
use carom::kernel::{Verdict as Checked, check};
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::outcome::Verdict;
use std::path::Path;
use std::time::Duration;

fn limits() -> Limits {
    Limits { time: Duration::from_secs(12), steps: 40_000, ..Limits::default() }
}

fn claims(folder: &str) -> Vec<Claim> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut paths: Vec<_> = std::fs::read_dir(&folder).unwrap().map(|e| e.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "claim"));
    paths.sort();
    paths.iter().flat_map(|p| parse(&std::fs::read_to_string(p).unwrap()).unwrap()).collect()
}

/// A claim that cites nothing, judged.
fn judged(claim: &Claim) -> Option<Entry> {
    let claim = Claim { using: Vec::new(), ..claim.clone() };
    let catalogue = Catalogue::new(vec![claim.clone()]).ok()?;
    let settings = Settings { limits: limits(), ..Settings::default() };
    one_of(&catalogue, &claim.name.text, &AtHand::of(carom::claim::embedded::certificates()), &settings).ok()
}

fn found(claim: &Claim) -> Option<(Entry, Option<Repair>)> {
    let entry = judged(claim).filter(|e| e.outcome.verdict == Verdict::Refuted)?;
    let repair = repair(&entry, &limits()).ok();
    if let Some(repair) = &repair {
        let again = read(&write(&repair.certificate)).unwrap();
        assert!(matches!(check(&repair.claim, &again, &[]), Checked::Accepted(_)), "{}", claim.name.text);
    }
    Some((entry, repair))
}

/// The claim without its last hypothesis.
fn mutant(claim: &Claim) -> Option<Claim> {
    let place = claim.items.iter().rposition(|item| matches!(item, Item::Assume { .. }))?;
    let mut out = claim.clone();
    out.items.remove(place);
    Some(out)
}

#[test]
fn most_refuted_claims_get_a_hypothesis_and_it_is_enough() {
    let worker = std::thread::Builder::new().stack_size(64 << 20).spawn(repair_all);
    worker.unwrap().join().unwrap();
}

fn repair_all() {
    let refuted = ["proofs/ricardo-lee-2015", "proofs/beyond", "proofs/published", "proofs/redner-2004"];
    let own = refuted.iter().flat_map(|f| claims(f)).filter(|c| c.expect == Expectation::Refuted);
    let kinds = ["facts-together", "powers", "relativity", "restitution", "energy-transfer", "superballs", "integers"];
    let source = |kind: &&str| std::fs::read_to_string(format!("tests/corpus/{kind}.claim")).unwrap();
    let dropped = kinds.iter().flat_map(|k| parse(&source(k)).unwrap());
    let dropped = dropped.filter(|c| c.expect == Expectation::Proved).filter_map(|c| mutant(&c));
    let (mut tried, mut repaired, mut exact) = (0, 0, 0);
    for claim in sample(own.chain(dropped)) {
        let Some((_, repair)) = found(&claim) else { continue };
        tried += 1;
        let name = &claim.name.text;
        match repair {
            Some(repair) => {
                repaired += 1;
                exact += usize::from(repair.exact);
                let how = if repair.exact { "exactly where" } else { "where" };
                println!("{name:<45} {how:<14} {}", print::prop(&repair.hypothesis));
            }
            None => println!("{name:<45} none"),
        }
    }
    println!("{repaired} of {tried} repaired, {exact} of these exactly");
    assert!(tried >= at_least(60), "{tried}");
    assert!(repaired >= at_least(40), "{repaired} of {tried}");
}

#[test]
fn the_printed_finality_of_a_pass_lacks_what_its_repair_says() {
    let claim = claims("proofs/ricardo-lee-2015").into_iter().find(|c| c.name.text == "p-final").unwrap();
    let (_, repair) = found(&claim).unwrap();
    let repair = repair.unwrap();
    assert!(repair.exact);
    assert_eq!(print::prop(&repair.hypothesis), "x*e >= 1 or e >= x");
}

#[test]
fn a_claim_lacks_the_order_of_two_of_its_products() {
    for (goal, exact, hypothesis) in
        [("(M - e*m)/(M + m) > 0", true, "m*e < M"), ("sqrt((M - e*m)^2) = M - e*m", false, "M >= e*m")]
    {
        let text = format!("claim t \"t\"\ngiven M > 0; m > 0; e in [0, 1]\nprove {goal}\n");
        let repair = found(&parse(&text).unwrap().remove(0)).unwrap().1.unwrap();
        assert_eq!((repair.exact, print::prop(&repair.hypothesis).as_str()), (exact, hypothesis), "{goal}");
    }
}

#[test]
fn a_claim_that_is_proved_is_not_repaired() {
    let claim = parse("claim t \"t\"\ngiven x > 0\nprove x + 1 > 1\n").unwrap().remove(0);
    assert!(repair(&judged(&claim).unwrap(), &limits()).is_err());
}

#[test]
fn a_hypothesis_that_cannot_hold_is_no_repair() {
    // x < 0 would make it true of nothing.
    let claim = parse("claim t \"t\"\ngiven x > 0\nprove 0 > 1/x\n").unwrap().remove(0);
    assert!(found(&claim).unwrap().1.is_none());
}

#[test]
fn a_hypothesis_about_an_angle_or_a_floor_is_lost_in_print() {
    for (given, goal) in [
        ("theta real", "tan(theta) = sin(theta)/cos(theta)"),
        ("x real", "floor(x)/x <= 1"),
        ("a, b real", "tan(a)*tan(b) = sin(a)*sin(b)/(cos(a)*cos(b))"),
        ("x real", "abs(x)/x = 1"),
    ] {
        let claim = parse(&format!("claim t \"t\"\ngiven {given}\nprove {goal}\n")).unwrap().remove(0);
        let Some(repair) = found(&claim).unwrap().1 else { panic!("{goal}: nothing is found") };
        let printed =
            format!("claim t-repaired \"t\"\n{}\n", print::statement(&repair.claim, print::Style::Text).join("\n"));
        let read = parse(&printed).unwrap_or_else(|faults| panic!("{printed}: {faults:?}")).remove(0);
        assert_eq!(judged(&read).unwrap().outcome.verdict, Verdict::Proved, "{printed}");
        assert!(printed.contains(&print::prop(&repair.hypothesis)), "{printed}");
    }
}
