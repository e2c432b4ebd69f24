//! `carom read`, and papers in LaTeX or Markdown wherever claim files are read.

use super::load::{Broken, Files, exit, read, rendered};
use super::{Exit, terminal};
use crate::claim::diagnostic::{Diagnostic, Source};
use crate::claim::parse::text_of;
use crate::claim::print::{Style, statement};
use crate::claim::syntax::{Claim, Expectation};
use crate::latex::{Outcome, Paper, Wanted, is_paper, manuscript, paper_of};
use crate::report::counted;
use std::path::Path;

/// A paper's text with the files that it calls for, and its equations.
fn opened(path: &Path, bytes: &[u8]) -> (Source, Result<Paper, Vec<Diagnostic>>) {
    let whole = manuscript(path, String::from_utf8_lossy(bytes).into_owned());
    let found = text_of(bytes).and_then(|_| paper_of(&whole));
    (whole.source, found)
}

/// Adds the claims of a paper, and what of it could not be read.
pub(super) fn add(path: &Path, bytes: &[u8], out: &mut Files) {
    let name = path.display().to_string();
    let (source, found) = opened(path, bytes);
    match found {
        Ok(found) => {
            terminal::note(&format!("{name}: {}; `carom read {name}` lists them", summary(&found)));
            to_declare(&found).into_iter().for_each(|text| terminal::note(&format!("{name}: {text}")));
            if !found.faults.is_empty() {
                let exit = exit(&found.faults, &source);
                out.broken.push(Broken { name: name.clone(), claims: Vec::new(), exit });
            }
            for equation in found.equations {
                let why = equation.unread(&source).unwrap_or_default();
                match equation.outcome {
                    Outcome::Read(claim) => {
                        out.origin.push(out.sources.len());
                        out.claims.push(*claim);
                    }
                    Outcome::NotRead(faults) => {
                        let claims = vec![equation.name.clone()];
                        out.broken.push(Broken { name: equation.name, claims, exit: exit(&faults, &source) });
                    }
                    Outcome::Waits(_) => {
                        let (file, line, _) = source.place(equation.span);
                        let message = format!("error: {file}:{line}: {} {why}", equation.name);
                        let claims = vec![equation.name.clone()];
                        out.broken.push(Broken { name: equation.name, claims, exit: Exit::usage(message) });
                    }
                    Outcome::Used(_) | Outcome::Skipped(_) => {}
                }
            }
        }
        Err(faults) => {
            out.broken.push(Broken { name: name.clone(), claims: Vec::new(), exit: exit(&faults, &source) });
        }
    }
    out.sources.push(source);
}

/// Comments to begin with, for the names that nothing declares.
fn to_declare(found: &Paper) -> Option<String> {
    let mut out: Vec<String> = found.offered.iter().map(|clause| format!("`%carom {clause}`")).collect();
    let functions: Vec<&str> = found
        .undeclared
        .iter()
        .filter(|(_, wanted)| **wanted == Wanted::Function)
        .map(|(name, _)| name.as_str())
        .collect();
    if !functions.is_empty() {
        out.push(format!("functions or factors: {}", functions.join(", ")));
    }
    (!out.is_empty()).then(|| format!("nothing declares these names; to begin with: {}", out.join("; ")))
}

/// How many formulas were read, used, passed over and not read.
fn summary(found: &Paper) -> String {
    let count = |is: fn(&Outcome) -> bool| found.equations.iter().filter(|e| is(&e.outcome)).count();
    let read = count(|o| matches!(o, Outcome::Read(_)));
    let mut out = format!("{} read", counted(read, "claim"));
    for (number, what) in [
        (count(|o| matches!(o, Outcome::Used("hypothesis"))), "taken as hypotheses"),
        (count(|o| matches!(o, Outcome::Used("definition"))), "taken as definitions"),
        (count(|o| matches!(o, Outcome::Skipped(_))), "passed over by the author"),
        (count(|o| matches!(o, Outcome::NotRead(_) | Outcome::Waits(_))), "not read"),
        (found.inline, "in running text, not looked at"),
    ] {
        if number > 0 {
            out += &format!(", {number} {what}");
        }
    }
    out
}

/// The claims of a paper as a claim file, under a list of what was read and not, and of the names. The exit code is 2 if something
/// was not read, 3 if limits alone prevented it.
pub(super) fn run(path: &Path) -> Result<(String, u8, Vec<String>), Exit> {
    let name = path.display().to_string();
    if !is_paper(path) {
        return Err(Exit::usage(format!("error: {name} is no paper: its name must end in .tex or .md")));
    }
    let bytes = read(path)?;
    let (source, found) = opened(path, &bytes);
    let found = found.map_err(|faults| exit(&faults, &source))?;
    let mut out = format!("# {name}: {}\n", summary(&found));
    let mut faults = found.faults.clone();
    for equation in &found.equations {
        let number = equation.number.as_ref().map_or(String::new(), |number| format!(" ({number})"));
        let what = match &equation.outcome {
            Outcome::Read(claim) => format!("read as claim {}", claim.name.text),
            Outcome::Used(what) => format!("taken as a {what}"),
            Outcome::Skipped(reason) if reason.is_empty() => "passed over by the author".to_string(),
            Outcome::Skipped(reason) => format!("passed over by the author: {reason}"),
            Outcome::Waits(_) | Outcome::NotRead(_) => {
                format!("not read: {}", equation.unread(&source).unwrap_or_default())
            }
        };
        if let Outcome::NotRead(list) = &equation.outcome {
            faults.extend(list.iter().cloned());
        }
        out += &format!("# {}{number}: {what}\n", source.line(equation.span));
    }
    out += "#\n# Names: in the paper, in the claims, how often in equations\n";
    for (key, spelled, count) in &found.names {
        let once = if *count == 1 { "   (once: a misprint?)" } else { "" };
        out += &format!("#   {key}   {spelled}   {count}{once}\n");
    }
    if let Some(text) = to_declare(&found) {
        out += &format!("#\n# {text}\n");
    }
    for equation in &found.equations {
        if let Outcome::Read(claim) = &equation.outcome {
            out += &format!("\n{}", file(claim));
        }
    }
    let code = if faults.is_empty() { 0 } else { exit(&faults, &source).code };
    Ok((out, code, rendered(&faults, &source)))
}

/// A claim as it stands in a claim file, without its argument.
fn file(claim: &Claim) -> String {
    let mut out = format!("claim {} \"{}\"\n", claim.name.text, claim.title);
    let said = [("source", &claim.source), ("section", &claim.section)];
    for (word, text) in said.into_iter().filter_map(|(word, text)| Some((word, text.as_ref()?))) {
        out += &format!("{word} \"{text}\"\n");
    }
    if let Some(number) = &claim.number {
        out += &format!("number {number}\n");
    }
    if !claim.using.is_empty() {
        let cited: Vec<&str> = claim.using.iter().map(|name| name.text.as_str()).collect();
        out += &format!("using {}\n", cited.join(", "));
    }
    out += &format!("{}\n", statement(claim, Style::Text).join("\n"));
    match claim.expect {
        Expectation::Proved => {}
        Expectation::Refuted => out += "expect refuted\n",
        Expectation::Undecided => out += "expect undecided\n",
    }
    out
}
