//! `carom read`, and papers in LaTeX or Markdown wherever claim files are read.

use super::load::{Broken, Files, Source, read, rendered};
use super::{Exit, terminal};
use crate::claim::diagnostic::{Diagnostic, Fault, Span};
use crate::claim::parse::text_of;
use crate::claim::print::{Style, statement};
use crate::claim::syntax::{Claim, Expectation};
use crate::latex::{Outcome, Paper, latex_of, paper};
use crate::report::counted;
use std::path::Path;

/// Whether a path is that of a paper.
pub(crate) fn is_paper(path: &Path) -> bool {
    path.extension().is_some_and(|end| ["tex", "ltx", "md", "markdown"].iter().any(|known| end == *known))
}

/// The equations of a paper's text.
fn equations(path: &Path, text: &str) -> Result<Paper, Vec<Diagnostic>> {
    let is_latex = path.extension().is_some_and(|end| end == "tex" || end == "ltx");
    let found = if is_latex { paper(text)? } else { paper(&latex_of(text))? };
    if found.equations.is_empty() && found.faults.is_empty() {
        let help = "a displayed equation stands in \\begin{equation}, \\begin{align}, \\[ … \\] or $$ … $$".to_string();
        let message = "no displayed equation found in this file".to_string();
        return Err(vec![Diagnostic::new(
            Fault::Other { message, help: Some(help) },
            Span { start: 0, end: text.len().min(1) },
        )]);
    }
    Ok(found)
}

/// Adds the claims of a paper, and what of it could not be read.
pub(super) fn add(path: &Path, bytes: &[u8], out: &mut Files) {
    let name = path.display().to_string();
    let text = String::from_utf8_lossy(bytes).into_owned();
    let exit =
        |faults: &[Diagnostic]| Exit::faults(&rendered(faults, &name, &text), faults.iter().all(Diagnostic::is_limit));
    match text_of(bytes).and_then(|text| equations(path, text)) {
        Ok(found) => {
            terminal::note(&format!("{name}: {}; `carom read {name}` lists them", summary(&found)));
            if !found.faults.is_empty() {
                out.broken.push(Broken { name: name.clone(), claims: Vec::new(), exit: exit(&found.faults) });
            }
            for equation in found.equations {
                match equation.outcome {
                    Outcome::Read(claim) => {
                        out.origin.push(out.sources.len());
                        out.claims.push(*claim);
                    }
                    Outcome::NotRead(faults) => {
                        let claims = vec![equation.name.clone()];
                        out.broken.push(Broken { name: equation.name, claims, exit: exit(&faults) });
                    }
                    Outcome::Waits(line) => {
                        let message = format!(
                            "error: {name}:{}: {} waits for line {line}, which is not read",
                            equation.line, equation.name
                        );
                        let claims = vec![equation.name.clone()];
                        out.broken.push(Broken { name: equation.name, claims, exit: Exit::usage(message) });
                    }
                    Outcome::Used(_) | Outcome::Skipped(_) => {}
                }
            }
        }
        Err(faults) => out.broken.push(Broken { name: name.clone(), claims: Vec::new(), exit: exit(&faults) }),
    }
    out.sources.push(Source { path: name, text });
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
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let exit =
        |faults: &[Diagnostic]| Exit::faults(&rendered(faults, &name, &text), faults.iter().all(Diagnostic::is_limit));
    let found = text_of(&bytes).and_then(|text| equations(path, text)).map_err(|faults| exit(&faults))?;
    let mut out = format!("# {name}: {}\n", summary(&found));
    let mut faults = found.faults.clone();
    for equation in &found.equations {
        let number = equation.number.as_ref().map_or(String::new(), |number| format!(" ({number})"));
        let what = match &equation.outcome {
            Outcome::Read(claim) => format!("read as claim {}", claim.name.text),
            Outcome::Used(what) => format!("taken as a {what}"),
            Outcome::Skipped(reason) if reason.is_empty() => "passed over by the author".to_string(),
            Outcome::Skipped(reason) => format!("passed over by the author: {reason}"),
            Outcome::Waits(line) => format!("not read: waits for line {line}, which is not read"),
            Outcome::NotRead(list) => {
                faults.extend(list.iter().cloned());
                let first = list.first().map(Diagnostic::message).unwrap_or_default();
                format!("not read: {first}")
            }
        };
        out += &format!("# line {}{number}: {what}\n", equation.line);
    }
    out += "#\n# Names: in the paper, in the claims, how often in equations\n";
    for (key, spelled, count) in &found.names {
        let once = if *count == 1 { "   (once: a misprint?)" } else { "" };
        out += &format!("#   {key}   {spelled}   {count}{once}\n");
    }
    for equation in &found.equations {
        if let Outcome::Read(claim) = &equation.outcome {
            out += &format!("\n{}", file(claim));
        }
    }
    let code = if faults.is_empty() { 0 } else { exit(&faults).code };
    Ok((out, code, rendered(&faults, &name, &text)))
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
