//! `carom check`: certificates of claims, and of tables (`table_certificate`).

use super::audit::cited_too;
use super::table_certificate::Other;
use super::{Exit, form, load, print, table_certificate, terminal, write_file};
use crate::certificate::Certificate;
use crate::certificate::text::{FILE_LIMIT, Malformed, digest, read};
use crate::claim::diagnostic::Diagnostic;
use crate::claim::dimension;
use crate::claim::embedded;
use crate::claim::syntax::Claim;
use crate::kernel::{self, Accepted, Verdict};
use crate::latex::is_paper;
use crate::report::visible_lines;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// A certificate and its origin.
struct Found {
    origin: String,
    certificate: Certificate,
}

/// The result of one certificate.
enum Outcome {
    Accepted(Box<Accepted>),
    /// The claim is refuted, with the statement that was checked at a point.
    Refuted(String),
    Rejected(String),
    Declined(&'static str),
}

/// Runs the command: exit 1 if a certificate is rejected, 3 if a limit was reached.
pub(super) fn run(paths: &[PathBuf], claims: &[PathBuf], output: Option<&Path>) -> Result<u8, Exit> {
    form::ending::<()>(output, &[])?;
    let quiet = terminal::quiet();
    let Some(path) = form::place(output) else { return check(paths, claims, quiet, &mut print) };
    let mut report = String::new();
    let code = check(paths, claims, quiet, &mut |text| {
        report.push_str(text);
        Ok(())
    })?;
    write_file(path, &report)?;
    Ok(code)
}

/// Receives the text to print.
type Say<'a> = &'a mut dyn FnMut(&str) -> Result<(), Exit>;

fn check(paths: &[PathBuf], claims: &[PathBuf], quiet: bool, say: Say<'_>) -> Result<u8, Exit> {
    let is_claims = |path: &&PathBuf| is_paper(path) || path.extension().is_some_and(|end| end == "claim");
    if let Some(path) = paths.iter().find(is_claims) {
        let path = path.display();
        return Err(Exit::usage(format!(
            "error: {path} holds claims, not certificates; `carom audit {path} --certificates DIR` writes their certificates, and \
             `carom check DIR --claims {path}` checks them"
        )));
    }
    let (tables, others) = table_certificate::told_apart(paths)?;
    let only_tables = others.is_empty() && !tables.is_empty();
    let of_tables = table_certificate::run(tables, quiet, say)?;
    if only_tables {
        return Ok(of_tables);
    }
    let of_claims = check_claims(&others, claims, quiet, say)?;
    // A rejection is more important than a limit.
    Ok(if of_tables == 1 || of_claims == 1 { 1 } else { of_tables.max(of_claims) })
}

fn check_claims(paths: &[Other], claims: &[PathBuf], quiet: bool, say: Say<'_>) -> Result<u8, Exit> {
    let claims: Vec<Claim> = if claims.is_empty() {
        let broken = |faults: Vec<Diagnostic>| {
            Exit::usage(faults.iter().map(Diagnostic::message).collect::<Vec<_>>().join("\n"))
        };
        embedded::claims(&[]).map_err(broken)?.unwrap_or_default()
    } else {
        cited_too(load::claims(&load::files(claims)?).whole()?.claims)
    };
    let (asked, found) = certificates(paths, &claims)?;
    let mut outcomes: BTreeMap<String, Outcome> = BTreeMap::new();
    for name in &asked {
        judge(name, &claims, &found, &mut outcomes);
    }
    let (mut out, mut code, mut good) = (String::new(), 0, 0);
    for name in &asked {
        let origin = found.get(name).map_or("", |f| f.origin.as_str());
        match outcomes.get(name) {
            Some(Outcome::Accepted(accepted)) => {
                good += 1;
                out += &format!("accepted  {name}");
                if !accepted.rests_on().is_empty() {
                    let list: Vec<&str> = accepted.rests_on().iter().map(String::as_str).collect();
                    out += &format!("  (rests on {})", list.join(", "));
                }
                out.push('\n');
                if let Some(mismatch) = claims.iter().find(|c| c.name.text == *name).and_then(dimension::of_goal) {
                    out += &format!("    true of numbers, but {}\n", mismatch.message());
                }
                if !quiet {
                    out += &accepted.text().lines().map(|l| format!("    {l}\n")).collect::<String>();
                }
            }
            Some(Outcome::Refuted(statement)) => {
                good += 1;
                out += &format!("refuted   {name}\n");
                if !quiet {
                    out += &statement.lines().map(|l| format!("    {l}\n")).collect::<String>();
                }
            }
            Some(Outcome::Rejected(reason)) => {
                code = 1;
                out += &format!("rejected  {name}  {origin}: {reason}\n");
            }
            Some(Outcome::Declined(limit)) => {
                code = if code == 1 { 1 } else { 3 };
                out += &format!("declined  {name}  {origin}: limit reached: {limit}\n");
            }
            None => {}
        }
    }
    out += &format!("{good} of {} certificates accepted\n", asked.len());
    // Reasons and names quote the files.
    say(&visible_lines(&out))?;
    Ok(code)
}

/// The certificates to judge, and those of the claims that they cite, which are looked for beside them under
/// their claims' names. Other files there are not read.
fn certificates(paths: &[Other], claims: &[Claim]) -> Result<(Vec<String>, BTreeMap<String, Found>), Exit> {
    let mut found = BTreeMap::new();
    let mut asked = Vec::new();
    if paths.is_empty() {
        for (name, text) in embedded::certificates() {
            let certificate = parsed(&format!("{name}.cert"), text)?;
            asked.push(certificate.claim.clone());
            found.insert(certificate.claim.clone(), Found { origin: format!("{name}.cert"), certificate });
        }
        return Ok((asked, found));
    }
    let mut beside: Vec<PathBuf> = Vec::new();
    let mut add = |file: &Path, text: &str| -> Result<(), Exit> {
        let origin = file.display().to_string();
        let certificate = parsed(&origin, text)?;
        asked.push(certificate.claim.clone());
        match found.insert(certificate.claim.clone(), Found { origin: origin.clone(), certificate }) {
            None => Ok(()),
            Some(other) => {
                let other = other.origin;
                Err(Exit::usage(format!("error: {other} and {origin} are certificates of the same claim")))
            }
        }
    };
    for path in paths {
        let path = match path {
            Other::Path(path) => path,
            Other::Text(path, bytes) => {
                add(path, &utf8(path, bytes.clone())?)?;
                continue;
            }
        };
        let files = if path.is_dir() { listed(path)? } else { vec![path.clone()] };
        if files.is_empty() {
            return Err(Exit::usage(format!("error: no .cert files in {}", path.display())));
        }
        for file in files {
            add(&file, &text_of(&file)?)?;
            beside.extend(
                file.parent().map(|p| if p.as_os_str().is_empty() { PathBuf::from(".") } else { p.to_path_buf() }),
            );
        }
    }
    beside.sort();
    beside.dedup();
    let mut open = asked.clone();
    let mut seen = BTreeSet::new();
    while let Some(name) = open.pop() {
        if !seen.insert(name.clone()) {
            continue;
        }
        if !found.contains_key(&name)
            && let Some(file) = beside.iter().map(|folder| folder.join(format!("{name}.cert"))).find(|f| f.is_file())
        {
            let origin = file.display().to_string();
            let certificate = parsed(&origin, &text_of(&file)?)?;
            found.entry(certificate.claim.clone()).or_insert(Found { origin, certificate });
        }
        // A claim may cite one of the built-in catalogue, whose certificate comes with the program.
        if !found.contains_key(&name)
            && let Some((_, text)) = embedded::certificates().into_iter().find(|(built_in, _)| *built_in == name)
        {
            let origin = format!("{name}.cert");
            let certificate = parsed(&origin, text)?;
            found.insert(name.clone(), Found { origin, certificate });
        }
        let cited = claims.iter().filter(|c| c.name.text == name).flat_map(|c| &c.using);
        open.extend(cited.map(|n| n.text.clone()));
    }
    Ok((asked, found))
}

fn listed(folder: &Path) -> Result<Vec<PathBuf>, Exit> {
    let mut out = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(|e| load::cannot_read(folder, &e))? {
        let path = entry.map_err(|e| load::cannot_read(folder, &e))?.path();
        if path.extension().is_some_and(|e| e == "cert") {
            out.push(path);
        }
    }
    out.sort();
    Ok(out)
}

fn text_of(path: &Path) -> Result<String, Exit> {
    let bytes = load::bounded(path, FILE_LIMIT).map_err(|e| load::cannot_read(path, &e))?;
    utf8(path, bytes)
}

fn utf8(path: &Path, bytes: Vec<u8>) -> Result<String, Exit> {
    String::from_utf8(bytes).map_err(|_| Exit::usage(format!("error: {} is not UTF-8 text", path.display())))
}

fn parsed(origin: &str, text: &str) -> Result<Certificate, Exit> {
    read(text).map_err(|malformed| unreadable(origin, &malformed))
}

/// The error of a certificate that cannot be read.
pub(super) fn unreadable(origin: &str, malformed: &Malformed) -> Exit {
    let Malformed { line, fault } = malformed;
    Exit::faults(&[format!("error: {origin}:{line}: {fault}")], fault.is_limit())
}

const OTHER_DIGEST: &str = "the digest belongs to another statement";

/// The statement that a certificate of a refutation shows, if the digest is its.
fn refuted(claim: &Claim, certificate: &Certificate) -> Option<String> {
    let shown = kernel::refutation::of(claim, certificate.refutes.as_ref()?).ok()?;
    let statement = kernel::statement::Statement::of(&shown).ok()?.text();
    (digest(&statement) == certificate.statement).then_some(statement)
}

/// Judges a certificate, those of the claims that it cites first.
fn judge(name: &str, claims: &[Claim], found: &BTreeMap<String, Found>, outcomes: &mut BTreeMap<String, Outcome>) {
    let mut stack = vec![name.to_string()];
    // What was begun and has no outcome waits for the top of the stack: claims that cite each other end there.
    let mut begun = BTreeSet::new();
    while let Some(top) = stack.last().cloned() {
        if outcomes.contains_key(&top) {
            stack.pop();
            continue;
        }
        let (Some(claim), Some(here)) = (claims.iter().find(|c| c.name.text == top), found.get(&top)) else {
            let what =
                if found.contains_key(&top) { "there is no claim of this name" } else { "it has no certificate" };
            outcomes.insert(top, Outcome::Rejected(what.to_string()));
            stack.pop();
            continue;
        };
        let open: Vec<String> = claim
            .using
            .iter()
            .map(|n| n.text.clone())
            .filter(|n| !outcomes.contains_key(n) && !begun.contains(n) && found.contains_key(n))
            .collect();
        begun.insert(top.clone());
        if !open.is_empty() {
            stack.extend(open);
            continue;
        }
        let cited: Vec<&Accepted> = claim
            .using
            .iter()
            .filter_map(|n| match outcomes.get(&n.text) {
                Some(Outcome::Accepted(accepted)) => Some(&**accepted),
                _ => None,
            })
            .collect();
        let outcome = match kernel::check(claim, &here.certificate, &cited) {
            Verdict::Accepted(accepted) if digest(&accepted.text()) == here.certificate.statement => {
                Outcome::Accepted(accepted)
            }
            Verdict::Accepted(_) => Outcome::Rejected(OTHER_DIGEST.to_string()),
            Verdict::Refuted => match refuted(claim, &here.certificate) {
                Some(statement) => Outcome::Refuted(statement),
                None => Outcome::Rejected(OTHER_DIGEST.to_string()),
            },
            Verdict::Rejected { step, rule, reason } => Outcome::Rejected(match step.as_str() {
                "" => format!("{rule}: {reason}"),
                _ => format!("step {step} ({rule}): {reason}"),
            }),
            Verdict::Declined { limit } => Outcome::Declined(limit),
        };
        outcomes.insert(top, outcome);
        stack.pop();
    }
}
