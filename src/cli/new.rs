//! `carom new`: the folder of a paper of one's own.

use super::{Exit, print, write_file};
use crate::claim::preamble;
use std::path::Path;

/// The file with the first claim.
const FIRST: &str = "half.claim";

/// Writes the folder.
pub(super) fn run(dir: &Path, title: &str) -> Result<u8, Exit> {
    let failed = |e: std::io::Error| Exit::usage(format!("error: cannot make the folder {}: {e}", dir.display()));
    if title.contains(['"', '\n', '\r']) {
        return Err(Exit::usage("error: a title must be one line without quotation marks"));
    }
    std::fs::create_dir_all(dir).map_err(failed)?;
    if std::fs::read_dir(dir).map_err(failed)?.next().is_some() {
        return Err(Exit::usage(format!("error: {} is not empty; give a new folder", dir.display())));
    }
    for (name, text) in [
        (preamble::FILE, preamble_text(title)),
        (FIRST, CLAIM.to_string()),
        ("README.md", readme(title, &dir.display().to_string())),
    ] {
        write_file(&dir.join(name), &text)?;
    }
    let shown = dir.display();
    print(&format!("{shown}: {}, {FIRST} and README.md\nnext: carom audit {shown}\n", preamble::FILE))?;
    Ok(0)
}

fn preamble_text(title: &str) -> String {
    format!(
        "# What all claim files of this folder share. A claim takes of it what it speaks of.\n\
         paper \"{title}\"\nsource \"author, journal, year\"\nreading as printed\n\n\
         given m1, m2 > 0;  v real\ngiven e in [0, 1]  # coefficient of restitution\n"
    )
}

/// The claim of the skeleton: two equal bodies that stick together.
const CLAIM: &str = "\
text \"One file may hold many claims. A text like this one is printed above the claim that follows.\"

claim half \"Equal bodies that stick together move at half the speed\"
section \"1 Introduction\"
number 1.1
let w = m1*v/(m1 + m2)
assume equal: m1 = m2
prove w = v/2
";

fn readme(title: &str, dir: &str) -> String {
    format!(
        "# {title}\n\n\
         - `carom audit {dir}` judges every claim: proved, refuted with a point, or undecided with the reason.\n\
         - `carom explain half {dir}` says a proof in words.\n\
         - `carom audit {dir} --certificates {dir}/certificates` keeps the proofs; the next audit checks them only.\n\
         - `carom report {dir} --out report` writes a report to hand in.\n\
         - `carom fmt {dir}` lays the files out in one style.\n\n\
         `carom help language` describes the language. What the claims share stands in `paper.claim`.\n"
    )
}
