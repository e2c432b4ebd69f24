//! Damaged bytes for every reader: the laws of the fuzz targets, for a few hundred mutants of their corpus each, or as many
//! times more as the environment variable `CAROM_MUTANTS` says.
#![allow(missing_docs)]

mod laws;

use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;
use std::path::Path;

/// The files of a target's corpus, in order.
fn corpus(target: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(target);
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut paths: Vec<_> = entries.map(|e| e.expect("an entry").path()).collect();
    paths.sort();
    paths.iter().map(|p| std::fs::read(p).expect("a file")).collect()
}

/// One change at a place, given as a share of the length.
#[derive(Clone, Debug)]
enum Change {
    Put(u16, Vec<u8>),
    Flip(u16, u8),
    Cut(u16, u8),
    /// A piece of another file, or of this one.
    Splice(u16, usize, u16, u8),
    End(u16),
}

/// Pieces that readers stumble over.
const PIECES: [&str; 16] =
    ["9", "0", "-", "^", "e9", "/0", "(", "((((", "]", "\"", "\n", "\u{301}", "x1", "\0", "=", "[[body]]\n"];

fn change() -> impl Strategy<Value = Change> {
    let piece = prop_oneof![
        prop::collection::vec(any::<u8>(), 1..6),
        prop::sample::select(&PIECES[..]).prop_map(|w| w.as_bytes().to_vec()),
        (1usize..3000).prop_map(|n| b"7".repeat(n)),
        (1usize..3000).prop_map(|n| b"(".repeat(n)),
    ];
    prop_oneof![
        3 => (any::<u16>(), piece).prop_map(|(at, piece)| Change::Put(at, piece)),
        2 => (any::<u16>(), any::<u8>()).prop_map(|(at, to)| Change::Flip(at, to)),
        2 => (any::<u16>(), any::<u8>()).prop_map(|(at, count)| Change::Cut(at, count)),
        3 => (any::<u16>(), 0usize..64, any::<u16>(), any::<u8>()).prop_map(|(a, b, c, d)| Change::Splice(a, b, c, d)),
        1 => any::<u16>().prop_map(Change::End),
    ]
}

fn place(share: u16, length: usize) -> usize {
    usize::from(share) * length / usize::from(u16::MAX)
}

fn mutant(corpus: &[Vec<u8>], which: usize, changes: &[Change]) -> Vec<u8> {
    let mut bytes = corpus[which % corpus.len()].clone();
    for change in changes {
        let length = bytes.len();
        match change {
            Change::Put(at, piece) => {
                let at = place(*at, length);
                bytes.splice(at..at, piece.iter().copied());
            }
            Change::Flip(at, to) => {
                if let Some(byte) = bytes.get_mut(place(*at, length)) {
                    *byte = *to;
                }
            }
            Change::Cut(at, count) => {
                let at = place(*at, length);
                bytes.drain(at..(at + usize::from(*count)).min(length));
            }
            Change::Splice(at, other, from, count) => {
                let source = &corpus[other % corpus.len()];
                let from = place(*from, source.len());
                let piece = source[from..(from + usize::from(*count)).min(source.len())].to_vec();
                let at = place(*at, length);
                bytes.splice(at..at, piece);
            }
            Change::End(at) => bytes.truncate(place(*at, length)),
        }
    }
    bytes
}

/// The law holds for the corpus, and for so many mutants of it.
fn holds(target: &str, cases: u32, law: fn(&[u8])) {
    let times = std::env::var("CAROM_MUTANTS").map_or(1, |times| times.parse().expect("a number"));
    let corpus = corpus(target);
    assert!(!corpus.is_empty(), "{target} has a corpus");
    corpus.iter().for_each(|bytes| law(bytes));
    let strategy = (0usize..64, prop::collection::vec(change(), 1..5));
    // What fails is kept in tests/all/bytes.proptest-regressions.
    let kept = FileFailurePersistence::WithSource("proptest-regressions");
    let config = ProptestConfig {
        cases: cases * times,
        source_file: Some(file!()),
        failure_persistence: Some(Box::new(kept)),
        ..ProptestConfig::default()
    };
    let mut runner = proptest::test_runner::TestRunner::new(config);
    let outcome = runner.run(&strategy, |(which, changes)| {
        law(&mutant(&corpus, which, &changes));
        Ok(())
    });
    if let Err(error) = outcome {
        panic!("{target}: {error}");
    }
}

#[test]
fn damaged_claims_are_read_or_refused() {
    holds("claim", 600, laws::claim);
}

#[test]
fn damaged_certificates_are_refused_and_show_nothing_false() {
    holds("certificate", 600, laws::certificate);
}

#[test]
fn damaged_scenes_are_read_or_refused() {
    holds("scene", 800, laws::scene);
}

#[test]
fn damaged_numerals_are_read_alike_or_refused() {
    holds("numeral", 1500, laws::numeral);
}

#[test]
fn damaged_tables_are_accepted_whole_or_refused() {
    holds("table", 300, laws::table);
}
