//! What must hold for any bytes given to a reader of Carom: it answers, and what it says is consistent.
//!
//! The fuzz targets (`fuzz/`) and `tests/all/bytes.rs` run the same laws. A broken law is a panic.

use carom::certificate::text::{read, write};
use carom::claim::diagnostic::{Diagnostic, Fault};
use carom::claim::parse::{parse, parse_bytes, parse_prop};
use carom::claim::print;
use carom::claim::syntax::{Claim, Span};
use carom::kernel::{self, Verdict};
use std::sync::OnceLock;

/// Claims that cite no other, so that a certificate is all the kernel needs; together they need most of its rules.
const CLAIMS: [&str; 14] = [
    include_str!("../../../proofs/ricardo-lee-2015/eq04.claim"),
    include_str!("../../../proofs/ricardo-lee-2015/eq10-roots.claim"),
    include_str!("../../../proofs/ricardo-lee-2015/eq11.claim"),
    include_str!("../../../proofs/ricardo-lee-2015/eq13.claim"),
    include_str!("../../../proofs/ricardo-lee-2015/eq20-converse.claim"),
    include_str!("../../../proofs/ricardo-lee-2015/eq21.claim"),
    include_str!("../../../proofs/ricardo-lee-2015/eq22.claim"),
    include_str!("../../../proofs/ricardo-lee-2015/p-frame-energy.claim"),
    include_str!("../../../proofs/ricardo-lee-2015/p-stop.claim"),
    include_str!("../../../proofs/beyond/b-final.claim"),
    include_str!("../../../proofs/beyond/b-matrix.claim"),
    include_str!("../../../proofs/beyond/b-superball-limit.claim"),
    include_str!("../../../proofs/lemmas/lemma-bernoulli.claim"),
    include_str!("../../../proofs/lemmas/lemma-tangent.claim"),
];

/// Nothing shows these.
const FALSE: [&str; 3] = [
    "claim f \"f\"\ngiven x > 0\nprove x + 1/x > 2\n",
    "claim f \"f\"\ngiven e in [0, 1]\nprove (1 + e)^2/4 > e\n",
    "claim f \"f\"\ngiven n natural >= 1\nprove 2^n > n + 1\n",
];

fn claims(texts: &[&str]) -> Vec<Claim> {
    texts.iter().flat_map(|text| parse(text).expect("a claim")).collect()
}

fn shown(faults: &[Diagnostic], text: &str) {
    for fault in faults {
        let _ = fault.render("bytes", text, false);
    }
}

/// The parser answers with claims or faults that can be shown; a claim that was read prints as one that reads to the
/// same statement.
pub(crate) fn claim(bytes: &[u8]) {
    match parse_bytes(bytes) {
        Ok(claims) => {
            for claim in &claims {
                let goal = print::prop(&claim.goal);
                let again = parse_prop(&goal).expect("what was printed reads");
                assert_eq!(kernel::text::prop(&again), kernel::text::prop(&claim.goal));
            }
        }
        Err(faults) => {
            assert!(!faults.is_empty(), "a refusal says why");
            shown(&faults, &String::from_utf8_lossy(bytes));
        }
    }
}

/// A certificate that was read is written and read to the same text; the kernel answers for the claim that it
/// names, and shows nothing false by it.
pub(crate) fn certificate(bytes: &[u8]) {
    static KNOWN: OnceLock<(Vec<Claim>, Vec<Claim>)> = OnceLock::new();
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let Ok(mut certificate) = read(text) else { return };
    let written = write(&certificate);
    let again = read(&written).expect("what was written reads");
    assert_eq!(write(&again), written);
    let (known, wrong) = KNOWN.get_or_init(|| (claims(&CLAIMS), claims(&FALSE)));
    for claim in known.iter().filter(|c| c.name.text == certificate.claim) {
        let _ = kernel::check(claim, &certificate, &[]);
    }
    certificate.claim = "f".to_string();
    for claim in wrong {
        assert!(!matches!(kernel::check(claim, &certificate, &[]), Verdict::Accepted(_)), "shown: {}", claim.title);
    }
}

/// Both readers of scenes answer with a scene or a fault that can be shown; a small scene of bodies is replayed, its
/// ledger balances, and every form of it is written.
pub(crate) fn scene(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Err(fault) = carom::scene::read::scene(text) {
        shown(&[fault.diagnostic], text);
    }
    match carom::scene::replay::read(text) {
        Ok(scene) if text.len() <= 4096 => replayed(&scene),
        Ok(_) => {}
        Err(error) => {
            let fault = Fault::Other { message: error.message, help: error.help };
            shown(&[Diagnostic::new(fault, Span { start: error.span.start, end: error.span.end })], text);
        }
    }
}

/// A replay in all its ways ends in an outcome that can be shown.
fn replayed(scene: &carom::scene::replay::Scene) {
    use carom::chain::replay::{Options, replay};
    use carom::report::replay::{Numbers, Replay, csv, html, json, svg, text};
    for (through_collapse, orders, exact_bits) in [(false, true, 2000), (true, false, 200)] {
        let exact_bits = Some(exact_bits);
        let options = Options { max_events: 120, list: 30, through_collapse, orders, exact_bits, ..Options::default() };
        let outcome = replay(&scene.line, &options).expect("the ledger balances");
        assert!(outcome.in_order().count() as u64 <= outcome.count + outcome.joins);
        let title = scene.title.as_deref();
        for numbers in [Numbers::Short(24, 12), Numbers::Exact] {
            let replay = Replay { title, line: &scene.line, outcome: &outcome, numbers };
            for form in [text::report, json::report, csv::report, svg::report, html::report] {
                assert!(!form(&replay).is_empty());
            }
        }
    }
}

/// The kernel and the engine read a numeral, or say why not; where both read it, to the same number.
pub(crate) fn numeral(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let ours = carom::number::rational::parse(text);
    if let (Ok(theirs), Ok(ours)) = (kernel::numeral(text), &ours) {
        assert_eq!(theirs.to_string(), ours.to_string(), "{text}");
    }
    if let (Ok(range), Ok(number)) = (carom::chain::uncertain::Range::read(text), &ours) {
        assert_eq!(range.single(), Some(number), "{text}");
    }
}

/// The kernel answers for a table, and accepts no more or fewer rows than there are lines for.
pub(crate) fn table(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let mut lines = text.lines();
    let Ok(mut checker) = carom::table_checker::Checker::new(lines.next().unwrap_or("")) else { return };
    if lines.all(|line| checker.row(line).is_ok())
        && let Ok(table) = checker.finish()
    {
        assert_eq!(table.rows(), text.lines().count() as u64 - 1);
    }
}
