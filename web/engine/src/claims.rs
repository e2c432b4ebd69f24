//! Claims and what is thought of them.

use crate::request::{Fault, Request};
use carom_catalogue as embedded;
use carom_checker::claim::diagnostic::{self, Diagnostic, Source};
use carom_checker::claim::parse::parse;
use carom_checker::claim::print::Style;
use carom_checker::claim::syntax::{Claim, Expectation};
use carom_documents::report::{self, Entry, mathml};
use carom_latex::{Outcome, paper};
use carom_search::judge::hand::AtHand;
use carom_search::judge::{Settings, diagnostic, judge};
use carom_search::refute::catalogue::{Catalogue, Limits};
use carom_search::refute::outcome::Point;
use serde_json::{Value, json};
use std::ops::Range;
use std::time::Duration;

/// The description of the language.
const LANGUAGE: &str = include_str!("../../../docs/language.md");
/// The longest text that the page's editor sends.
const MAX_TEXT: usize = 200_000;
/// The most faults that are shown.
const SHOWN: usize = 20;
/// The longest time for one claim, in seconds.
const SECONDS: u64 = 10;

/// Judges the claims of a text, or the displayed equations of a paper in LaTeX. A claim with a fault is left out, with
/// those that rest on it; the others are judged.
pub fn audit(request: &Request) -> Result<Value, Fault> {
    let text = request.long_text("text");
    if text.len() > MAX_TEXT {
        return Err(Fault::at("text", format!("limit reached: {MAX_TEXT} bytes of claims on this page")).limit());
    }
    let (read, mut faults) = if is_paper(text) { equations(text) } else { readable(text) };
    let mut claims: Vec<Value> = Vec::new();
    if let Some(catalogue) = read {
        let names: Vec<String> = catalogue.claims().iter().map(|c| c.name.text.clone()).collect();
        let (entries, wrong) = judged(&catalogue, &names);
        claims.extend(entries.iter().map(|entry| described(entry, Some(text))));
        faults.extend(wrong);
    }
    Ok(json!({ "claims": claims, "faults": shown(&faults, text) }))
}

/// Whether a text is in LaTeX: no claim of the language begins in it, and a displayed formula does.
fn is_paper(text: &str) -> bool {
    let is_claim = |line: &str| line.split_whitespace().next() == Some("claim");
    ["\\begin{", "\\[", "$$"].iter().any(|sign| text.contains(sign)) && !text.lines().any(is_claim)
}

/// The claims of a paper, and the faults of what cannot be read or waits for that.
fn equations(text: &str) -> (Option<Catalogue>, Vec<Diagnostic>) {
    let found = match paper(text) {
        Ok(found) => found,
        Err(faults) => return (None, faults),
    };
    let source = Source::new("your text".to_string(), text.to_string());
    let (mut claims, mut faults) = (Vec::new(), found.faults);
    for equation in found.equations {
        let waits = equation.unread(&source).map(|why| format!("{} {why}", equation.name));
        match equation.outcome {
            Outcome::Read(claim) => claims.push(*claim),
            Outcome::NotRead(list) => faults.extend(list),
            Outcome::Waits(_) => {
                let message = waits.unwrap_or_default();
                faults.push(Diagnostic::new(diagnostic::Fault::Other { message, help: None }, equation.span));
            }
            Outcome::Used(_) | Outcome::Skipped(_) => {}
        }
    }
    for _ in 0..MAX_ROUNDS {
        let list = match Catalogue::new(claims.clone()) {
            Ok(catalogue) => return (Some(catalogue), faults),
            Err(list) => list,
        };
        let is_at =
            |claim: &Claim, place| claim.name.span == place || claim.using.iter().any(|name| name.span == place);
        claims.retain(|claim| !list.iter().any(|(name, fault)| claim.name.text == *name && is_at(claim, fault.span)));
        faults.extend(list.into_iter().map(|fault| fault.1));
    }
    (None, faults)
}

/// Rounds of leaving out claims that rest on what was left out.
const MAX_ROUNDS: usize = 50;

/// The claims of a text that can be read, and the faults of the others. What has a fault is blanked out, so that places
/// in the rest stay as they are.
fn readable(text: &str) -> (Option<Catalogue>, Vec<Diagnostic>) {
    let read = |text: &str| match parse(text).map(Catalogue::new) {
        Ok(Ok(catalogue)) => Ok(catalogue),
        Ok(Err(faults)) => Err(faults.into_iter().map(|f| f.1).collect::<Vec<_>>()),
        Err(faults) => Err(faults),
    };
    let first = match read(text) {
        Ok(catalogue) => return (Some(catalogue), Vec::new()),
        Err(faults) => faults,
    };
    let mut left = Vec::new();
    let mut found = Vec::new();
    for block in blocks(text) {
        let faults = parse(&text[block.clone()]).err().unwrap_or_default();
        if faults.iter().all(|fault| matches!(fault.fault, diagnostic::Fault::Empty)) {
            left.push(block);
            continue;
        }
        found.extend(faults.into_iter().map(|mut fault| {
            fault.span.start += block.start;
            fault.span.end += block.start;
            fault
        }));
    }
    for _ in 0..MAX_ROUNDS {
        if left.is_empty() {
            break;
        }
        let faults = match read(&only(text, &left)) {
            Ok(catalogue) => return (Some(catalogue), found),
            Err(faults) => faults,
        };
        let before = left.len();
        left.retain(|block| !faults.iter().any(|fault| block.contains(&fault.span.start)));
        found.extend(faults);
        if left.len() == before {
            break;
        }
    }
    (None, if found.is_empty() { first } else { found })
}

/// The bytes of each claim, from a line that begins with `claim` to the next one, and of what stands before the first.
fn blocks(text: &str) -> Vec<Range<usize>> {
    let mut starts = vec![0];
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        if at > 0 && line.split_whitespace().next() == Some("claim") {
            starts.push(at);
        }
        at += line.len();
    }
    let ends = starts.iter().skip(1).copied().chain([text.len()]);
    starts.iter().copied().zip(ends).map(|(start, end)| start..end).collect()
}

/// The text with blanks outside of some ranges, lines and places kept.
fn only(text: &str, ranges: &[Range<usize>]) -> String {
    let mut kept = String::with_capacity(text.len());
    let mut next = 0;
    for (at, c) in text.char_indices() {
        while ranges.get(next).is_some_and(|range| range.end <= at) {
            next += 1;
        }
        if c == '\n' || ranges.get(next).is_some_and(|range| range.contains(&at)) {
            kept.push(c);
        } else {
            kept.extend(std::iter::repeat_n(' ', c.len_utf8()));
        }
    }
    kept
}

/// Judges one claim of the catalogue.
pub fn claim(request: &Request) -> Result<Value, Fault> {
    let id = request.text("id")?;
    let broken =
        |faults: Vec<Diagnostic>| Fault::new(faults.iter().map(Diagnostic::message).collect::<Vec<_>>().join("\n"));
    let unknown = || Fault::at("id", format!("no claim is called {id:?}"));
    let claims = embedded::claims(&[id.to_owned()]).map_err(broken)?.ok_or_else(unknown)?;
    let catalogue = Catalogue::new(claims).map_err(|list| broken(list.into_iter().map(|f| f.1).collect()))?;
    let (entries, faults) = judged(&catalogue, &[id.to_owned()]);
    let Some(entry) = entries.first() else { return Err(broken(faults)) };
    let file = embedded::files().into_iter().find(|f| embedded::stem(f.path) == id);
    Ok(json!({ "claim": described(entry, None), "text": file.map(|f| f.text) }))
}

/// The catalogue: names, titles and sections.
pub fn catalogue(_: &Request) -> Result<Value, Fault> {
    let mut list = Vec::new();
    for file in embedded::files() {
        for claim in parse(file.text).unwrap_or_default() {
            list.push(json!({
                "id": claim.name.text,
                "number": report::number(&claim),
                "title": claim.title,
                "section": claim.section,
                "reading": report::reading(&claim),
            }));
        }
    }
    Ok(json!({ "claims": list, "language": LANGUAGE }))
}

/// The entries of claims, and the faults of those that make no sense; certificates that come with the program decide
/// first.
fn judged(catalogue: &Catalogue, names: &[String]) -> (Vec<Entry>, Vec<Diagnostic>) {
    let limits = Limits { time: Duration::from_secs(SECONDS), ..Limits::default() };
    let settings = Settings { limits, argument: true, ..Settings::default() };
    let (mut entries, mut faults) = (Vec::new(), Vec::new());
    for (name, entry) in judge(catalogue, names, &AtHand::of(embedded::certificates()), &settings, &|_| {}).entries {
        match (entry, catalogue.get(&name)) {
            (Ok(entry), _) => entries.push(entry),
            (Err(fault), Some(claim)) => faults.push(diagnostic(claim, fault)),
            (Err(_), None) => {}
        }
    }
    (entries, faults)
}

/// The first faults, each with its place in UTF-16 units, as an editor in a browser counts, and with its caret.
fn shown(faults: &[Diagnostic], text: &str) -> Value {
    let units = |end: usize| {
        let end = (0..=end.min(text.len())).rev().find(|i| text.is_char_boundary(*i)).unwrap_or(0);
        text[..end].encode_utf16().count()
    };
    let one = |fault: &Diagnostic| {
        let (line, column) = fault.place(text);
        let start = units(fault.span.start);
        json!({
            "message": fault.message(),
            "help": fault.help(),
            "start": start,
            "end": units(fault.span.end).max(start),
            "line": line,
            "column": column,
            "excerpt": excerpt(&fault.render("your text", text, false)),
        })
    };
    json!({
        "list": faults.iter().take(SHOWN).map(one).collect::<Vec<_>>(),
        "more": faults.len().saturating_sub(SHOWN),
    })
}

/// A rendered fault without its message and its help, which the page shows in sentences.
fn excerpt(rendered: &str) -> String {
    let of_the_text = |line: &&str| !line.starts_with("error") && !line.trim_start().starts_with("= help:");
    rendered.lines().filter(of_the_text).collect::<Vec<_>>().join("\n")
}

fn point(claim: &Claim, point: &Point) -> Value {
    point.named(claim, Style::Unicode).map(|(name, value)| json!([name, value])).collect()
}

fn described(entry: &Entry, text: Option<&str>) -> Value {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let expected = match claim.expect {
        Expectation::Proved => "proved",
        Expectation::Refuted => "refuted",
        Expectation::Undecided => "undecided",
    };
    json!({
        "id": claim.name.text,
        "title": claim.title,
        "number": report::number(claim),
        "source": claim.source,
        "section": claim.section,
        "reading": report::reading(claim),
        "line": text.map(|text| Diagnostic::new(diagnostic::Fault::Empty, claim.name.span).place(text).0),
        "verdict": outcome.verdict.name(),
        "expected": expected,
        "as_expected": entry.as_expected(),
        "method": outcome.method,
        "statement": entry.goal(Style::Unicode),
        "mathml": mathml::statement(claim.written_goal()),
        "hypotheses": hypotheses(claim),
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
        "notes": claim.notes,
        "using": claim.using.iter().map(|n| n.text.clone()).collect::<Vec<_>>(),
    })
}

fn hypotheses(claim: &Claim) -> Vec<Value> {
    let items = claim.written_items().iter();
    items.map(|item| json!({ "text": Style::Unicode.item(item), "mathml": mathml::item(item) })).collect()
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    fn audit(text: &str) -> Value {
        serde_json::from_str(&crate::audit(&json!({ "text": text }).to_string())).expect("JSON")
    }

    #[test]
    fn a_refuted_claim_shows_its_counterexample() {
        let found = audit("claim mine \"Mine\"\ngiven m > 0\nprove m^2 = m\n");
        let claim = &found["claims"][0];
        assert_eq!(claim["verdict"], "refuted");
        assert_eq!(claim["witness"]["point"][0][0], "m");
        assert_eq!(claim["line"], 1);
    }

    #[test]
    fn places_are_counted_as_an_editor_counts() {
        // The sign 𝜇 takes four bytes and two units.
        let found = audit("claim mine \"𝜇\"\ngiven m > 0\nprove m = k\n");
        let fault = &found["faults"]["list"][0];
        let start = fault["start"].as_u64().expect("a number") as usize;
        let units: Vec<u16> = "claim mine \"𝜇\"\ngiven m > 0\nprove m = k\n".encode_utf16().collect();
        assert_eq!(char::from_u32(units[start].into()), Some('k'));
        let excerpt = fault["excerpt"].as_str().expect("text");
        assert!(excerpt.contains('^') && !excerpt.contains("error"), "{excerpt}");
    }

    #[test]
    fn a_faulty_claim_takes_no_other_verdict_with_it() {
        let good = "claim good \"Good\"\ngiven m > 0\nprove m^2 > 0\n";
        let user = "claim user \"User\"\ngiven m > 0\nusing broken(m = m)\nprove m > 0\n";
        for broken in [
            "claim broken \"𝜇\"\ngiven m > 0\nprove m = k\n",
            "claim broken \"B\"\ngiven m > 0\nprove m +\n",
            "claim broken \"B\"\nnonsense\n",
            "claim broken",
        ] {
            for text in [format!("{good}\n{broken}"), format!("{broken}\n\n{good}")] {
                let found = audit(&text);
                assert_eq!(found["claims"][0]["verdict"], "proved", "{text}: {found}");
                assert_eq!(found["claims"].as_array().map(Vec::len), Some(1), "{text}");
                assert!(found["faults"]["list"][0]["message"].is_string(), "{text}");
            }
        }
        let all = audit(&format!("{good}\nclaim broken \"B\"\ngiven m > 0\nprove m = k\n\n{user}"));
        assert_eq!(all["claims"].as_array().map(Vec::len), Some(1), "{all}");
        assert_eq!(audit("nonsense")["claims"].as_array().map(Vec::len), Some(0));
    }

    #[test]
    fn a_pasted_paper_is_taken_for_claims_or_loses_equations() {
        let paper = "%carom given a, b > 0\n\\begin{equation}\\label{eq:square} (a + b)^2 \\ge 4 a b \\end{equation}\n\
                     \\[ a = b \\]\n\\[ \\oint a = b \\] %carom assume\n\\[ 1 = 1 \\]\n";
        let found = audit(paper);
        let verdicts: Vec<_> =
            found["claims"].as_array().expect("claims").iter().map(|c| (&c["id"], &c["verdict"])).collect();
        assert_eq!(verdicts, [(&json!("square"), &json!("proved")), (&json!("line-3"), &json!("refuted"))]);
        let faults = found["faults"]["list"].as_array().expect("faults");
        assert!(faults[0]["message"].as_str().is_some_and(|text| text.contains("oint")), "{found}");
        assert_eq!(
            (&faults[1]["message"], &faults[1]["line"]),
            (&json!("line-5 waits for line 4, which is not read"), &json!(5))
        );
        // Of two equations with one label the second is called by its line as well.
        let found = audit(
            "\\begin{equation}\\label{eq:a} 1 = 1\\end{equation}\n\\begin{equation}\\label{eq:a} 2 = 2\\end{equation}",
        );
        let names: Vec<_> = found["claims"].as_array().expect("claims").iter().map(|claim| &claim["id"]).collect();
        assert_eq!(names, ["a", "a-line-2"], "{found}");
        assert_eq!(found["faults"]["list"], json!([]), "{found}");
        // Dollars in a title make no paper.
        assert_eq!(audit("claim mine \"$$\"\nprove 1 < 2\n")["claims"][0]["verdict"], "proved");
    }

    #[test]
    fn markup_in_a_title_stays_text() {
        let found = audit("claim mine \"<img src=x onerror=alert(1)>\"\nprove 1 < 2\n");
        assert_eq!(found["claims"][0]["title"], "<img src=x onerror=alert(1)>");
        assert!(!found["claims"][0]["mathml"].as_str().expect("text").contains("<img"));
    }

    #[test]
    fn the_catalogue_is_all_there_and_each_claim_is_as_expected() {
        let all: Value = serde_json::from_str(&crate::catalogue("{}")).expect("JSON");
        let list = all["claims"].as_array().expect("a list");
        assert!(list.len() >= 90);
        for id in ["eq25", "p-final", "eq19"] {
            let found: Value = serde_json::from_str(&crate::claim(&json!({ "id": id }).to_string())).expect("JSON");
            assert_eq!(found["claim"]["as_expected"], true);
            assert!(found["claim"]["mathml"].as_str().expect("text").starts_with("<math"));
        }
        assert!(crate::claim("{\"id\": \"nothing\"}").contains("error"));
    }
}
