//! The claim files that come with the program.
//!
//! A claim is in the file of its name, so that one claim and those it cites are found without
//! reading the rest.

use super::diagnostic::Diagnostic;
use super::parse::parse;
use super::syntax::Claim;
use include_dir::{Dir, include_dir};
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, HashMap};

/// The folders of claims in the order of reports: the paper, then beyond, then lemmas. What else lies in
/// `proofs/` stays out of the program.
static FOLDERS: [Dir; 3] = [
    include_dir!("$CARGO_MANIFEST_DIR/proofs/ricardo-lee-2015"),
    include_dir!("$CARGO_MANIFEST_DIR/proofs/beyond"),
    include_dir!("$CARGO_MANIFEST_DIR/proofs/lemmas"),
];

/// The library of the Coq proofs, and the page of theorems.
static COQ: Dir = include_dir!("$CARGO_MANIFEST_DIR/proofs/coq");

/// The certificates of the proved claims: `carom check` without paths checks them.
static CERTIFICATES: Dir = include_dir!("$CARGO_MANIFEST_DIR/proofs/certificates");

/// A claim file: its name and its text.
#[derive(Clone, Copy, Debug)]
pub struct File {
    /// The file's name.
    pub path: &'static str,
    /// The text.
    pub text: &'static str,
}

/// All claim files in the order of reports: the paper, then beyond, then lemmas, each by number.
pub fn files() -> Vec<File> {
    let mut out = Vec::new();
    for dir in &FOLDERS {
        let mut list: Vec<File> = dir
            .files()
            .filter_map(|f| Some(File { path: f.path().to_str()?, text: f.contents_utf8()? }))
            .filter(|f| f.path.ends_with(".claim"))
            .collect();
        list.sort_by_cached_key(|f| natural(f.path));
        out.extend(list);
    }
    out
}

/// The certificates that come with the program: name of the claim, text.
pub fn certificates() -> Vec<(String, &'static str)> {
    let mut out: Vec<(String, &'static str)> = CERTIFICATES
        .files()
        .filter_map(|f| Some((f.path().to_str()?.strip_suffix(".cert")?, f.contents_utf8()?)))
        .map(|(path, text)| (stem(path).to_string(), text))
        .collect();
    out.sort();
    out
}

/// The Coq files, without the folder and the ending in their paths.
pub fn coq_files() -> Vec<File> {
    let mut out: Vec<File> = COQ
        .files()
        .filter_map(|f| {
            Some(File { path: f.path().file_name()?.to_str()?.strip_suffix(".v")?, text: f.contents_utf8()? })
        })
        .collect();
    out.sort_by_key(|f| f.path);
    out
}

/// The name of the claim in a file.
pub fn stem(path: &str) -> &str {
    let name = path.rsplit_once('/').map_or(path, |(_, name)| name);
    name.strip_suffix(".claim").unwrap_or(name)
}

/// `u2` before `u10`.
fn natural(path: &str) -> (String, u32, String) {
    let name = stem(path);
    let head: String = name.chars().take_while(|c| !c.is_ascii_digit()).collect();
    let digits: String = name[head.len()..].chars().take_while(char::is_ascii_digit).collect();
    (head.clone(), digits.parse().unwrap_or(0), name[head.len() + digits.len()..].to_string())
}

/// The claims with these names and all that they cite; all claims where no names are given. `None`
/// where a name is not there.
///
/// # Errors
/// The faults of an embedded file; the tests see to it that there are none.
pub fn claims(only: &[String]) -> Result<Option<Vec<Claim>>, Vec<Diagnostic>> {
    let files = files();
    if only.is_empty() {
        let mut out = Vec::new();
        for file in &files {
            out.extend(parse(file.text)?);
        }
        return Ok(Some(out));
    }
    let places: HashMap<&str, usize> = files.iter().enumerate().map(|(i, f)| (stem(f.path), i)).collect();
    let mut out: BTreeMap<usize, Vec<Claim>> = BTreeMap::new();
    let mut wanted: Vec<String> = only.to_vec();
    while let Some(name) = wanted.pop() {
        let Some(place) = places.get(name.as_str()).copied() else { return Ok(None) };
        if let Entry::Vacant(entry) = out.entry(place) {
            let claims = entry.insert(parse(files[place].text)?);
            wanted.extend(claims.iter().flat_map(|c| c.using.iter().map(|n| n.text.clone())));
        }
    }
    Ok(Some(out.into_values().flatten().collect()))
}
