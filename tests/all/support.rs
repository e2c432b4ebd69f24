//! What several subjects need: the program run as a user runs it, and the catalogue's claims.

use carom::claim::embedded;
use carom::claim::syntax::Claim;
use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// The program with these arguments and nothing to read, in the folder of the project.
pub(crate) fn carom(arguments: &[&str]) -> Output {
    with_input(arguments, "")
}

/// The program with these arguments and this text on its standard input, in the folder of the project.
pub(crate) fn with_input(arguments: &[&str], input: &str) -> Output {
    in_folder(Path::new(env!("CARGO_MANIFEST_DIR")), arguments, input)
}

/// The same in another folder.
pub(crate) fn in_folder(folder: &Path, arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(arguments)
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    // A program that refuses its flags does not read.
    let _ = child.stdin.take().expect("a pipe").write_all(input.as_bytes());
    child.wait_with_output().expect("it ends")
}

/// The program for a reader that goes away at once, as `head` does.
pub(crate) fn for_nobody(arguments: &[&str]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    child.wait_with_output().expect("it ends")
}

/// What a program wrote.
pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// What the program writes for these arguments, which it takes.
pub(crate) fn good(arguments: &[&str]) -> String {
    let out = carom(arguments);
    assert_eq!(out.status.code(), Some(0), "{arguments:?}: {}", text(&out.stderr));
    text(&out.stdout)
}

/// What the program wrote to both of its outputs.
pub(crate) fn said(output: &Output) -> String {
    text(&output.stdout) + &text(&output.stderr)
}

/// Whether every case is asked for, as `.ci/run` does: `CAROM_WHOLE=1`.
pub(crate) fn whole() -> bool {
    std::env::var_os("CAROM_WHOLE").is_some()
}

/// A run that is not whole tries one of so many cases.
const SAMPLED: usize = 3;

/// Every third of these, and all in a whole run: whoever changes one function does not wait for them all.
pub(crate) fn sample<T>(cases: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
    cases.into_iter().step_by(if whole() { 1 } else { SAMPLED })
}

/// The least number of cases that a test with this one in a whole run must have tried.
pub(crate) fn at_least(in_all: usize) -> usize {
    if whole() { in_all } else { in_all / SAMPLED }
}

/// The claims of the catalogue by name.
pub(crate) fn catalogue() -> BTreeMap<String, Claim> {
    let claims = embedded::claims(&[]).expect("they are read").expect("no name was asked for");
    claims.into_iter().map(|claim| (claim.name.text.clone(), claim)).collect()
}
