//! `carom export coq --proofs`: a folder of theorems with their proofs; Coq run on such a folder for a report.

use super::audit::{cited_too, load};
use super::export::names_after_from;
use super::interrupt::{Interrupt, interrupted};
use super::{Exit, Language, print, terminal, write_file};
use crate::certificate::Certificate;
use crate::claim::syntax::Claim;
use crate::judge::Settings;
use crate::kernel::Accepted;
use crate::prove;
use crate::refute::catalogue::{Catalogue, Limits};
use crate::report::handout::evidence::{self, Evidence};
use crate::report::theorems::{Folder, folder};
use crate::report::{Audit, counted};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The script of the folder that runs Coq.
const CHECK: &str = "check";

/// The folder of the claims that are asked for, made but not written.
fn asked(ids: &[String], from: &[PathBuf], limits: &Limits) -> Result<Folder, Exit> {
    names_after_from(ids, from)?;
    let loaded = load(from, ids)?.with_certificates(false)?;
    let wanted = |claim: &&Claim| ids.is_empty() || ids.contains(&claim.name.text);
    let asked: Vec<Claim> = loaded.catalogue.claims().iter().filter(wanted).cloned().collect();
    let names: Vec<String> = loaded.catalogue.in_order(&asked).into_iter().map(|c| c.name.text).collect();
    let settings = Settings { limits: limits.clone(), ..Settings::default() };
    let mut entries = Vec::new();
    for (name, entry) in loaded.judge(&names, &settings).entries {
        entries.push(entry.map_err(|fault| loaded.failure(&name, fault))?);
    }
    folder(&loaded.catalogue, &entries, &search(limits)).map_err(|clash| Exit::usage(format!("error: {clash}")))
}

/// What proves the theorems that an audit does not judge.
fn search(limits: &Limits) -> impl Fn(&Claim, &[&Accepted]) -> Result<Certificate, String> {
    |claim, cited| prove::certificate(claim, cited, limits).map(|found| found.0).map_err(|fail| fail.to_string())
}

/// Writes the folder. It judges and computes everything first, so that nothing is written if that fails.
pub(super) fn run(
    language: Option<Language>,
    ids: &[String],
    from: &[PathBuf],
    output: Option<&Path>,
    limits: &Limits,
) -> Result<u8, Exit> {
    if language != Some(Language::Coq) {
        return Err(Exit::usage("error: --proofs are for Coq: write `carom export coq --proofs --output DIR`"));
    }
    let out = output.unwrap_or(Path::new("."));
    is_free(out)?;
    let made = asked(ids, from, limits)?;
    let interrupt = Interrupt::listen();
    write(&made, out)?;
    if interrupt.asked() {
        return Err(interrupted("everything is written"));
    }
    let files = made.files.iter().filter(|f| f.module.is_some()).count();
    print(&format!(
        "{} with {} in {}; `bash {}/check` has Coq verify them\n",
        counted(files, "claim"),
        counted(made.theorems(), "theorem"),
        out.display(),
        out.display()
    ))?;
    for file in &made.files {
        for (name, reason) in &file.open {
            terminal::note(&format!("no proof of {name}: {reason}"));
        }
    }
    Ok(0)
}

/// The page of theorems: each in full, with the place of its proof in the folder that [`run`] writes.
pub(super) fn page(
    language: Option<Language>,
    ids: &[String],
    from: &[PathBuf],
    limits: &Limits,
) -> Result<String, Exit> {
    if language != Some(Language::Coq) {
        return Err(Exit::usage("error: --theorems are for Coq: write `carom export coq --theorems`"));
    }
    let made = asked(ids, from, limits)?;
    if made.theorems() == 0 {
        return Err(Exit::usage(
            "error: --theorems: none of these claims has a proof; leave --theorems out to print the statements",
        ));
    }
    Ok(made.page())
}

/// A folder that is not empty is never changed.
fn is_free(out: &Path) -> Result<(), Exit> {
    let here = out.display();
    match std::fs::read_dir(out).map(Iterator::count) {
        Ok(1..) => {
            Err(Exit::usage(format!("error: {here} is not empty: --proofs needs a new folder, or an empty one")))
        }
        Err(_) if out.as_os_str() == "-" => {
            Err(Exit::usage("error: --proofs writes a folder, which cannot go to standard output"))
        }
        Err(e) if out.exists() => Err(Exit::usage(format!("error: {here} cannot be read as a folder: {e}"))),
        _ => Ok(()),
    }
}

/// Writes the files of a folder.
pub(super) fn write(made: &Folder, out: &Path) -> Result<(), Exit> {
    std::fs::create_dir_all(out)
        .map_err(|e| Exit::usage(format!("error: cannot make the folder {}: {e}", out.display())))?;
    made.contents().iter().try_for_each(|(name, text)| write_file(&out.join(name), text))
}

/// Whether Coq is here.
fn is_installed() -> bool {
    let silent = Command::new("coqc").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    silent.is_ok_and(|status| status.success())
}

/// The folder of an audit's claims.
pub(crate) fn of_audit(audit: &Audit, limits: &Limits) -> Result<Folder, String> {
    let claims: Vec<Claim> = audit.entries.iter().map(|e| e.claim.clone()).collect();
    // What they cite of the built-in catalogue belongs to them.
    let catalogue =
        Catalogue::new(cited_too(claims)).map_err(|_| "the claims are not those that were judged".to_string())?;
    folder(&catalogue, &audit.entries, &search(limits)).map_err(|clash| clash.to_string())
}

/// The evidence where Coq is run on the folder of an audit; `None` where Coq is not installed.
pub(super) fn ran(audit: &Audit, made: &Folder) -> Result<Option<BTreeMap<String, Evidence>>, Exit> {
    if !is_installed() {
        terminal::note(
            "note: coqc is not installed, so the proofs were not checked by Coq; `bash coq/check` in the folder checks them later",
        );
        return Ok(None);
    }
    let place = tempfile::tempdir().map_err(|e| Exit::usage(format!("error: cannot make a folder for Coq: {e}")))?;
    write(made, place.path())?;
    let cannot = |e: std::io::Error| Exit::usage(format!("error: cannot run {CHECK} of the Coq proofs: {e}"));
    let output = Command::new("bash").arg(place.path().join(CHECK)).stdin(Stdio::null()).output().map_err(cannot)?;
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    // An error that concerns the whole folder is on standard error.
    let wrong =
        String::from_utf8_lossy(&output.stderr).lines().find_map(|l| l.strip_prefix("error: ")).map(str::to_string);
    let refused = |module: &str, theorem: &str| {
        let word = |line: &str, from: &str| {
            let name = line.strip_prefix(from)?.trim_start().split([' ', ':']).next()?;
            (name == module).then(|| line.split_whitespace().collect::<Vec<_>>().join(" "))
        };
        let line = |from: &str| said.lines().find_map(|line| word(line, from));
        let known = said.lines().any(|line| line.split_whitespace().eq(["theorem", theorem]));
        ["failed ", "timed out ", "not tried "]
            .iter()
            .find_map(|from| line(from))
            .or_else(|| wrong.clone())
            .or_else(|| (!known).then(|| "Coq printed no result".to_string()))
    };
    Ok(Some(evidence::ran(audit, made, &refused)))
}
