//! Every claim of the project, printed as LaTeX and read back, has the digest that it had.

use carom::certificate::text::digest;
use carom::claim::parse::parse_under;
use carom::claim::preamble::{FILE, Preamble};
use carom::claim::print::Style;
use carom::claim::syntax::{Claim, Item};
use carom::kernel::statement::Statement;
use carom::latex::{Outcome, paper};
use std::path::{Path, PathBuf};

fn claim_files(folder: &Path, out: &mut Vec<PathBuf>) {
    let mut list: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    list.sort();
    for path in list {
        // Statements of a later language are not read at all.
        if path.is_dir() && !path.ends_with("later") {
            claim_files(&path, out);
        } else if path.extension().is_some_and(|end| end == "claim") {
            out.push(path);
        }
    }
}

fn claims() -> Vec<Claim> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    ["proofs", "tests/corpus"].iter().for_each(|folder| claim_files(&root.join(folder), &mut files));
    let mut out = Vec::new();
    for path in files {
        let read = |path: &Path| std::fs::read_to_string(path).unwrap();
        let shared = path.with_file_name(FILE);
        let preamble = match shared.exists() && shared != path {
            true => parse_under(&read(&shared), &Preamble::default()).unwrap().1,
            false => Preamble::default(),
        };
        out.extend(parse_under(&read(&path), &preamble).unwrap_or_else(|f| panic!("{}: {f:?}", path.display())).0);
    }
    out
}

fn digest_of(claim: &Claim) -> String {
    digest(&Statement::of(claim).unwrap().text())
}

/// The claim in the claim language, its declarations before it: the claim takes those that it needs, as one in a paper does.
fn as_claim_file(claim: &Claim) -> String {
    let mut out = String::new();
    for item in claim.written_items() {
        out += &format!("{}\n", Style::Text.item(item));
    }
    out + &format!("claim {} \"t\"\nprove {}\n", claim.name.text, Style::Text.prop(claim.written_goal()))
}

/// The claim as a paper: definitions, hypotheses and goal are displayed equations.
fn as_paper(claim: &Claim) -> String {
    let mut out = String::new();
    for item in claim.written_items() {
        let (math, purpose) = match item {
            Item::Given(_) | Item::Define { .. } => {
                out += &format!("%carom {}\n", Style::Text.item(item));
                continue;
            }
            Item::Let { .. } => (Style::Latex.item(item), "let".to_string()),
            Item::Assume { label, .. } => {
                let label = label.as_ref().map_or(String::new(), |label| label.text.clone());
                (Style::Latex.item(item), format!("assume {label}"))
            }
        };
        out += &format!("\\begin{{equation}}\n  {math} %carom {purpose}\n\\end{{equation}}\n");
    }
    let goal = Style::Latex.prop(claim.written_goal());
    out + &format!("\\begin{{equation}}\n  {goal} %carom claim {} \"t\"\n\\end{{equation}}\n", claim.name.text)
}

#[test]
fn no_claim_comes_back_from_print_as_another_one() {
    let worker = std::thread::Builder::new().stack_size(64 << 20).spawn(|| {
        let (mut same, mut refused) = (0, Vec::new());
        for claim in claims() {
            let text = as_claim_file(&claim);
            let Ok((reference, _)) = parse_under(&text, &Preamble::default()) else {
                refused.push(format!("{}: not in the claim language either", claim.name.text));
                continue;
            };
            let printed = as_paper(&claim);
            let found = paper(&printed).unwrap();
            let mut faults = found.faults.iter().map(|fault| fault.message()).collect::<Vec<_>>();
            let mut read = None;
            for equation in found.equations {
                match equation.outcome {
                    Outcome::Read(claim) => read = Some(claim),
                    Outcome::NotRead(list) => faults.extend(list.iter().map(|fault| fault.message())),
                    _ => {}
                }
            }
            match read {
                Some(read) if faults.is_empty() => {
                    assert_eq!(digest_of(&read), digest_of(&reference[0]), "{text}\n{printed}");
                    same += 1;
                }
                _ => refused.push(format!("{}: {}", claim.name.text, faults.first().map_or("no claim", |fault| fault))),
            }
        }
        // In print: a sum with its index behind a sign, a name that is also a family's member, a name that is a product too.
        assert!(
            same >= 850 && refused.len() <= 4,
            "{same} come back, {} do not:\n{}",
            refused.len(),
            refused.join("\n")
        );
    });
    worker.unwrap().join().unwrap();
}
