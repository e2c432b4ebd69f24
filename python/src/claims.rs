//! Claims and what is thought of them.

use crate::refusal::{Refusal, detached_deep};
use crate::tools::unknown_form;
use carom::certificate::text::write;
use carom::claim::diagnostic::{Diagnostic, Span, nearest};
use carom::claim::parse::parse;
use carom::claim::print::{self, Style};
use carom::claim::syntax::{Claim, Expectation};
use carom::claim::{LANGUAGE, embedded};
use carom::judge::hand::AtHand;
use carom::judge::repair::{NoRepair, repair as repaired};
use carom::judge::{Settings, diagnostic, judge};
use carom::latex::{Manuscript, Outcome, manuscript, paper_of};
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::outcome;
use carom::report::{self, Entry, mathml};
use pyo3::prelude::*;
use serde_json::{Value, json};
use std::path::Path;
use std::time::Duration;

/// The columns to which an argument is wrapped.
const COLUMNS: usize = 100;

/// Judges the claims of a text, or of the built-in catalogue; the verdicts as JSON.
#[pyfunction]
pub fn audit(
    py: Python<'_>,
    text: Option<String>,
    file: String,
    only: Vec<String>,
    seconds: u64,
) -> Result<String, Refusal> {
    detached_deep(py, || {
        let limits = Limits { time: Duration::from_secs(seconds), ..Limits::default() };
        let (entries, _) = judged(text.as_deref(), &file, &only, &limits)?;
        Ok(Value::from(entries.iter().map(described).collect::<Vec<_>>()).to_string())
    })
}

/// Judges the equations of a paper in LaTeX or Markdown; the verdicts and what was not read as JSON. A paper that is a
/// file calls for others beside it.
#[pyfunction]
pub fn audit_paper(
    py: Python<'_>,
    text: String,
    path: Option<String>,
    only: Vec<String>,
    seconds: u64,
) -> Result<String, Refusal> {
    detached_deep(py, || {
        let whole = match path {
            Some(path) => manuscript(Path::new(&path), text),
            None => Manuscript::alone(&text),
        };
        let source = &whole.source;
        let shown = |faults: &[Diagnostic]| refusal(faults, |fault| source.render(fault, false));
        let found = paper_of(&whole).map_err(|faults| shown(&faults))?;
        let unread = |name: &str, span: Span, message: String, faults: &[Diagnostic]| {
            let (file, line, _) = source.place(span);
            let text: Vec<String> = faults.iter().map(|fault| source.render(fault, false)).collect();
            json!({ "id": name, "file": file, "line": line, "message": message, "text": text.join("\n") })
        };
        let mut list: Vec<Value> = Vec::new();
        for fault in &found.faults {
            list.push(unread("", fault.span, fault.message(), std::slice::from_ref(fault)));
        }
        let mut claims = Vec::new();
        for equation in found.equations {
            let why = equation.unread(source);
            let faults = match equation.outcome {
                Outcome::Read(claim) => {
                    claims.push(*claim);
                    continue;
                }
                Outcome::NotRead(faults) => faults,
                _ => Vec::new(),
            };
            list.extend(why.map(|why| unread(&equation.name, equation.span, why, &faults)));
        }
        let limits = Limits { time: Duration::from_secs(seconds), ..Limits::default() };
        let (entries, _) = entries(claims, &only, &limits, &shown)?;
        Ok(json!({ "claims": entries.iter().map(described).collect::<Vec<_>>(), "unread": list }).to_string())
    })
}

/// Verdicts of a text, or of the built-in catalogue, as the program writes them: `text`, `json` or `markdown`.
#[pyfunction]
pub fn audit_report(
    py: Python<'_>,
    text: Option<String>,
    file: String,
    only: Vec<String>,
    seconds: u64,
    form: &str,
) -> Result<String, Refusal> {
    detached_deep(py, || {
        let written = match form {
            "text" => report::text::report,
            "json" => report::json::report,
            "markdown" => report::markdown::report,
            other => return Err(unknown_form(other, "text, json or markdown")),
        };
        let limits = Limits { time: Duration::from_secs(seconds), ..Limits::default() };
        let (entries, judged) = judged(text.as_deref(), &file, &only, &limits)?;
        Ok(written(&report::Audit { entries, problems: Vec::new(), judged }))
    })
}

/// A hypothesis, whether it is exact, the repaired claim, its certificate.
type Repaired = (String, bool, String, String);

/// The hypothesis that a refuted claim lacks; or why there is none.
#[pyfunction]
pub fn repair(
    py: Python<'_>,
    text: Option<String>,
    file: String,
    id: String,
    seconds: u64,
) -> Result<(Option<Repaired>, String), Refusal> {
    detached_deep(py, || {
        let limits = Limits { time: Duration::from_secs(seconds), ..Limits::default() };
        let (mut entries, _) = judged(text.as_deref(), &file, std::slice::from_ref(&id), &limits)?;
        let entry = entries.pop().ok_or_else(|| no_match(std::slice::from_ref(&id), &[]))?;
        Ok(match repaired(&entry, &limits) {
            Ok(found) => {
                let claim = &found.claim;
                let lines = print::statement(claim, Style::Text).join("\n");
                let claim = format!("claim {} \"{}\"\n{lines}\n", claim.name.text, claim.title);
                let parts = (print::prop(&found.hypothesis), found.exact, claim, write(&found.certificate));
                (Some(parts), String::new())
            }
            Err(NoRepair::NotRefuted(verdict)) => {
                (None, format!("{id} is {}; only a refuted claim can be repaired", verdict.name()))
            }
            Err(NoRepair::Dimensions) => {
                (None, format!("{id} is refuted by its dimensions, which no hypothesis changes"))
            }
            Err(NoRepair::NoneOf(tried)) => {
                (None, format!("{id} is refuted, and none of the {tried} hypotheses tried makes it provable"))
            }
        })
    })
}

/// The built-in catalogue without verdicts, as JSON.
#[pyfunction]
pub fn catalogue(py: Python<'_>) -> Result<String, Refusal> {
    detached_deep(py, || {
        let claims = embedded::claims(&[]).ok().flatten().ok_or(Refusal::Failure)?;
        let row = |claim: &Claim| {
            let statement = print::statement(claim, Style::Unicode);
            json!({ "id": claim.name.text, "number": report::number(claim), "title": claim.title,
                "section": claim.section, "source": claim.source, "expected": expected(claim), "statement": statement })
        };
        Ok(Value::from(claims.iter().map(row).collect::<Vec<_>>()).to_string())
    })
}

/// The description of the claim language.
#[pyfunction]
pub fn language() -> &'static str {
    LANGUAGE
}

/// The entries of what was asked for, and how many claims were worked on.
fn judged(text: Option<&str>, file: &str, only: &[String], limits: &Limits) -> Result<(Vec<Entry>, usize), Refusal> {
    let shown = |faults: &[Diagnostic]| {
        refusal(faults, |fault| match text {
            Some(text) => fault.render(file, text, false),
            None => fault.message(),
        })
    };
    let claims = match text {
        Some(text) => parse(text).map_err(|faults| shown(&faults))?,
        None => match embedded::claims(only).map_err(|faults| shown(&faults))? {
            Some(claims) => claims,
            None => {
                let files = embedded::files();
                let names: Vec<&str> = files.iter().map(|f| embedded::stem(f.path)).collect();
                return Err(no_match(only, &names));
            }
        },
    };
    entries(claims, only, limits, &shown)
}

/// Faults as one refusal.
fn refusal(faults: &[Diagnostic], one: impl Fn(&Diagnostic) -> String) -> Refusal {
    Refusal::Input(faults.iter().map(one).collect::<Vec<_>>().join("\n"))
}

/// The entries of these claims, and how many claims were worked on.
fn entries(
    claims: Vec<Claim>,
    only: &[String],
    limits: &Limits,
    shown: &dyn Fn(&[Diagnostic]) -> Refusal,
) -> Result<(Vec<Entry>, usize), Refusal> {
    let catalogue = Catalogue::new(claims);
    let catalogue = catalogue.map_err(|list| shown(&list.into_iter().map(|f| f.1).collect::<Vec<_>>()))?;
    let all: Vec<String> = catalogue.claims().iter().map(|c| c.name.text.clone()).collect();
    if only.iter().any(|name| !all.contains(name)) {
        return Err(no_match(only, &all.iter().map(String::as_str).collect::<Vec<_>>()));
    }
    let asked: Vec<String> = all.into_iter().filter(|name| only.is_empty() || only.contains(name)).collect();
    let settings = Settings { limits: limits.clone(), argument: true, ..Settings::default() };
    let found = judge(&catalogue, &asked, &AtHand::of(embedded::certificates()), &settings, &|_| {});
    let (mut entries, mut faults, worked) = (Vec::new(), Vec::new(), found.judged);
    for (name, entry) in found.entries {
        match (entry, catalogue.get(&name)) {
            (Ok(entry), _) => entries.push(entry),
            (Err(fault), Some(claim)) => faults.push(diagnostic(claim, fault)),
            (Err(_), None) => {}
        }
    }
    if faults.is_empty() { Ok((entries, worked)) } else { Err(shown(&faults)) }
}

fn no_match(only: &[String], names: &[&str]) -> Refusal {
    let missing = only.iter().filter(|name| !names.contains(&name.as_str()));
    let said = missing.map(|name| match nearest(name, names.iter().copied()) {
        Some(near) => format!("no claim is called {name}; did you mean {near}?"),
        None => format!("no claim is called {name}"),
    });
    Refusal::Input(said.collect::<Vec<_>>().join("\n"))
}

fn point(claim: &Claim, point: &outcome::Point) -> Value {
    point.named(claim, Style::Text).map(|(name, value)| json!([name, value])).collect()
}

fn expected(claim: &Claim) -> &'static str {
    match claim.expect {
        Expectation::Proved => "proved",
        Expectation::Refuted => "refuted",
        Expectation::Undecided => "undecided",
    }
}

fn described(entry: &Entry) -> Value {
    let (claim, outcome): (&Claim, _) = (&entry.claim, &entry.outcome);
    json!({
        "id": claim.name.text,
        "title": claim.title,
        "number": report::number(claim),
        "source": claim.source,
        "section": claim.section,
        "reading": report::reading(claim),
        "verdict": outcome.verdict.name(),
        "expected": expected(claim),
        "as_expected": entry.as_expected(),
        "method": outcome.method,
        "statement": entry.goal(Style::Unicode),
        "latex": entry.goal(Style::Latex),
        "mathml": mathml::statement(claim.written_goal()),
        "hypotheses": claim.written_items().iter().map(|item| Style::Unicode.item(item)).collect::<Vec<_>>(),
        "argument": report::argument::lines(entry),
        "used": outcome.used,
        "unused": outcome.unused,
        "sample": outcome.sample.as_ref().map(|sample| point(claim, sample)),
        "witness": outcome.witness.as_ref().map(|w| json!({
            "point": point(claim, &w.point),
            "broken": w.broken.iter().map(|b| json!([b.statement, b.left, b.right])).collect::<Vec<_>>(),
        })),
        "reason": outcome.reason,
        "certificate": entry.proof.as_ref().map(|p| &p.sha256),
        "certificate_text": entry.proof.as_ref().map(|p| &p.certificate),
        "explanation": report::argument::text(entry, COLUMNS),
        "notes": claim.notes,
    })
}
