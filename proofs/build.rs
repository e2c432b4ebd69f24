//! Lists the claim files, certificates and Coq proofs, which the program embeds.
//!
//! What else lies in their folders, such as scripts and the second checker, stays out of the program.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// For each list: its name, its folders in the order of reports, and the ending of its files.
const LISTS: [(&str, &[&str], &str); 3] = [
    ("CLAIMS", &["ricardo-lee-2015", "beyond", "lemmas"], "claim"),
    ("CERTIFICATES", &["certificates"], "cert"),
    ("COQ", &["coq"], "v"),
];

fn main() -> io::Result<()> {
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").ok_or(io::ErrorKind::NotFound)?);
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or(io::ErrorKind::NotFound)?);
    let mut text = String::new();
    for (name, folders, ending) in LISTS {
        let _ = writeln!(text, "/// For each folder: the names and texts of its files, by name.");
        let _ = writeln!(text, "static {name}: &[&[(&str, &str)]] = &[");
        for folder in folders {
            println!("cargo:rerun-if-changed={folder}");
            text.push_str("    &[\n");
            for path in files(&here.join(folder), ending)? {
                let file = path.file_name().unwrap_or_default();
                let _ = writeln!(text, "        ({file:?}, include_str!({path:?})),");
            }
            text.push_str("    ],\n");
        }
        text.push_str("];\n");
    }
    fs::write(out.join("files.rs"), text)
}

/// The files of a folder with this ending, by name.
fn files(folder: &Path, ending: &str) -> io::Result<Vec<PathBuf>> {
    let all: Vec<PathBuf> = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<_>>()?;
    let mut files: Vec<PathBuf> =
        all.into_iter().filter(|path| path.extension().is_some_and(|end| end == ending)).collect();
    files.sort_by(|a, b| a.file_stem().cmp(&b.file_stem()));
    Ok(files)
}
