//! Names the commit for `carom --version`.
//!
//! Contract: the name depends on the sources alone, so that the same commit gives the same bytes. It is the commit that git
//! names where the crate is a repository of its own, the one that `cargo package` wrote down, or `CAROM_COMMIT`;
//! without any of them there is none. Only a release has it: other builds would begin anew with each commit.

use std::path::Path;
use std::process::Command;

/// Digits of a commit that are shown.
const SHOWN: usize = 12;
/// What the program is made of.
const SOURCES: [&str; 5] = ["build.rs", "Cargo.toml", "Cargo.lock", "src", "proofs"];

fn main() {
    println!("cargo:rerun-if-env-changed=CAROM_COMMIT");
    let version = env!("CARGO_PKG_VERSION");
    let is_release = std::env::var("PROFILE").is_ok_and(|profile| profile == "release");
    let commit = if is_release { commit() } else { None };
    println!("cargo:rustc-env=CAROM_VERSION={}", commit.map_or(version.to_owned(), |c| format!("{version} ({c})")));
}

fn commit() -> Option<String> {
    if let Ok(given) = std::env::var("CAROM_COMMIT") {
        return Some(given).filter(|text| !text.is_empty());
    }
    of_repository().or_else(of_package)
}

/// The commit that is checked out, and whether the sources differ from it.
fn of_repository() -> Option<String> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR")).canonicalize().ok()?;
    // A repository around this one is somebody else's.
    if Path::new(&git(&["rev-parse", "--show-toplevel"])?).canonicalize().ok()? != here {
        return None;
    }
    for path in SOURCES.map(str::to_owned).into_iter().chain(git(&["rev-parse", "--git-path", "logs/HEAD"])) {
        if Path::new(&path).exists() {
            println!("cargo:rerun-if-changed={path}");
        }
    }
    let commit = git(&["rev-parse", &format!("--short={SHOWN}"), "HEAD"])?;
    let mut status = vec!["status", "--porcelain", "--"];
    status.extend(SOURCES);
    let is_changed = !git(&status)?.is_empty();
    Some(if is_changed { format!("{commit}, changed") } else { commit })
}

/// What `cargo package` writes beside the sources.
fn of_package() -> Option<String> {
    let text = std::fs::read_to_string(".cargo_vcs_info.json").ok()?;
    println!("cargo:rerun-if-changed=.cargo_vcs_info.json");
    let (_, rest) = text.split_once("\"sha1\": \"")?;
    rest.get(..SHOWN).filter(|digits| digits.bytes().all(|b| b.is_ascii_hexdigit())).map(str::to_owned)
}

fn git(arguments: &[&str]) -> Option<String> {
    let out = Command::new("git").args(arguments).output().ok().filter(|out| out.status.success())?;
    Some(String::from_utf8(out.stdout).ok()?.trim().to_owned())
}
