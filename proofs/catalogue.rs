//! The claim files that come with the program, with their certificates and Coq proofs.
//!
//! A claim is in the file of its name, so that one claim and those it cites are found without
//! reading the rest.

use carom_checker::claim::diagnostic::Diagnostic;
use carom_checker::claim::parse::parse;
use carom_checker::claim::syntax::Claim;
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, HashMap};

// CLAIMS, CERTIFICATES and COQ, which build.rs lists.
include!(concat!(env!("OUT_DIR"), "/files.rs"));

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
    for folder in CLAIMS {
        let mut list: Vec<File> = folder.iter().map(|&(path, text)| File { path, text }).collect();
        list.sort_by_cached_key(|f| natural(f.path));
        out.extend(list);
    }
    out
}

/// The certificates that come with the program: name of the claim, text. `carom check` without paths checks them.
pub fn certificates() -> Vec<(String, &'static str)> {
    without_ending(CERTIFICATES, ".cert").map(|f| (f.path.to_string(), f.text)).collect()
}

/// The library of the Coq proofs and the page of theorems, without the ending in their names.
pub fn coq_files() -> Vec<File> {
    without_ending(COQ, ".v").collect()
}

fn without_ending(folders: &'static [&[(&str, &str)]], ending: &'static str) -> impl Iterator<Item = File> {
    folders
        .iter()
        .flat_map(|f| f.iter())
        .map(move |&(path, text)| File { path: path.strip_suffix(ending).unwrap_or(path), text })
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
