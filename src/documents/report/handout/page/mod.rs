//! An audit as one HTML page that needs nothing else: no network, no scripts, no fonts of ours. What it links to are
//! files of the same folder.
//!
//! Contract: whatever stands in a claim file is escaped, so that no title or note can bring markup into the page.
//! Headings, tables with header cells and a skip link make it readable by keyboard and ear; colours are not the
//! only sign of a verdict; in print everything folded is open. The page's own identifiers hold a point, which no
//! claim's name does: a claim's section is found under the claim's name.

mod claim;
mod graph;
mod numbers;

use super::{Handout, findings};
use crate::refute::outcome::Verdict;
use crate::report::markup::escape;
use crate::report::{counted, summary};

const STYLE: &str = include_str!("style.css");

/// The page.
pub(super) fn page(handout: &Handout) -> String {
    let (audit, title) = (&handout.audit, escape(&handout.title));
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <a class=\"skip\" href=\"#page.claims\">Skip to the claims</a>\n<header>\n<h1>{title}</h1>\n"
    );
    overview(&mut out, handout);
    out.push_str("</header>\n");
    let mut body = String::new();
    let mut places: Vec<(String, String)> = Vec::new();
    let mut heading = |body: &mut String, id: &str, text: &str| {
        places.push((id.to_string(), text.to_string()));
        body.push_str(&format!("<h2 id=\"{id}\">{}</h2>\n", escape(text)));
    };
    let rows = findings(handout);
    if !rows.is_empty() {
        heading(&mut body, "page.findings", "Findings");
        body.push_str(&rows);
    }
    let figure = graph::svg(&audit.entries);
    if !figure.is_empty() {
        heading(&mut body, "page.graph", "Which claim rests on which");
        body.push_str(&figure);
    }
    body.push_str("<main id=\"page.claims\">\n");
    for (place, (section, entries)) in audit.sections().into_iter().enumerate() {
        heading(&mut body, &format!("page.section.{}", place + 1), section);
        for entry in entries {
            for paragraph in &entry.claim.prose {
                body.push_str(&format!("<p>{}</p>\n", escape(paragraph)));
            }
            claim::section(&mut body, entry, handout);
        }
    }
    body.push_str("</main>\n");
    if !handout.tables.is_empty() || !handout.plots.is_empty() {
        heading(&mut body, "page.numbers", "Numbers");
        numbers::all(&mut body, handout);
    }
    for problem in &audit.problems {
        body.push_str(&format!("<h2>{}</h2>\n<pre>{}</pre>\n", escape(&problem.name), escape(&problem.message)));
    }
    let links: Vec<String> =
        places.iter().map(|(id, text)| format!("<li><a href=\"#{id}\">{}</a></li>\n", escape(text))).collect();
    out.push_str(&format!("<nav aria-label=\"Contents\">\n<ul>\n{}</ul>\n</nav>\n{body}", links.concat()));
    out.push_str(&format!(
        "<footer><p class=\"meta\">Written by carom {}. <em>Proved</em> means: for all values that the \
         hypotheses allow. <em>Refuted</em> means: false at the exact point shown, or different dimensions are added or compared.</p></footer>\n</body>\n</html>\n",
        env!("CARGO_PKG_VERSION")
    ));
    out
}

fn overview(out: &mut String, handout: &Handout) {
    let audit = &handout.audit;
    let s = summary(&audit.entries);
    out.push_str(&format!(
        "<p>{}: <strong>{} proved</strong>, <strong>{} refuted</strong>, <strong>{} undecided</strong>; {}.</p>\n",
        audit.count(),
        s.proved,
        s.refuted,
        s.undecided,
        if s.unexpected == 0 { "all as expected".to_string() } else { format!("{} not as expected", s.unexpected) }
    ));
    if !audit.problems.is_empty() {
        out.push_str(&format!("<p>{} could not be judged.</p>\n", counted(audit.problems.len(), "claim")));
    }
    let vouched: Vec<String> = handout.vouched().iter().map(|s| escape(s)).collect();
    out.push_str(&format!("<p>{}</p>\n", vouched.join(" ")));
    out.push_str(&wide("Verdicts by section"));
    out.push_str("<table><caption>Verdicts by section. Kernel: checked by the kernel. Coq: proved in the Coq files. Prover alone: \
         found by the search, and checked by neither</caption><thead><tr>");
    for title in ["Section", "Proved", "Refuted", "Undecided", "Kernel", "Coq", "Prover alone"] {
        out.push_str(&format!("<th scope=\"col\">{title}</th>"));
    }
    out.push_str("</tr></thead><tbody>\n");
    for (section, entries) in audit.sections() {
        let count = |verdict: Verdict| entries.iter().filter(|e| e.outcome.verdict == verdict).count();
        let shown = handout.counts(entries.iter().copied());
        out.push_str(&format!("<tr><th scope=\"row\">{}</th>", escape(section)));
        let verdicts = [Verdict::Proved, Verdict::Refuted, Verdict::Undecided].map(count);
        for number in verdicts.into_iter().chain([shown.kernel, shown.coq, shown.alone]) {
            out.push_str(&format!("<td class=\"number\">{number}</td>"));
        }
        out.push_str("</tr>\n");
    }
    out.push_str("</tbody></table></div>\n");
    let again: Vec<String> =
        handout.again().iter().map(|(c, what)| format!("<li><code>{}</code>: {what}.</li>\n", escape(c))).collect();
    if !again.is_empty() {
        out.push_str(&format!("<p>To check again, in this folder:</p>\n<ul>\n{}</ul>\n", again.concat()));
    }
}

/// Opens a part that scrolls sideways by itself where the screen is narrow, also by keyboard.
fn wide(label: &str) -> String {
    format!("<div class=\"wide\" role=\"region\" aria-label=\"{}\" tabindex=\"0\">\n", escape(label))
}

/// The table of findings; empty if there are none.
fn findings(handout: &Handout) -> String {
    let row = |finding: &findings::Finding| {
        let mut says: Vec<String> = finding.says.iter().map(|n| escape(n)).collect();
        says.extend(finding.fails_at.as_ref().map(|at| format!("Fails at {}.", point(at))));
        format!(
            "<tr><th scope=\"row\"><a href=\"#{0}\">{0}</a></th><td>{1}</td><td>{2}</td><td>{3}</td></tr>\n",
            escape(finding.name),
            finding.kind,
            escape(finding.title),
            says.join(" ")
        )
    };
    let rows: Vec<String> = findings::of(&handout.audit).iter().map(row).collect();
    if rows.is_empty() {
        return String::new();
    }
    let head: String =
        ["Claim", "Finding", "Title", "What was found"].map(|t| format!("<th scope=\"col\">{t}</th>")).concat();
    format!(
        "{}<table class=\"findings\"><caption>Hidden hypotheses, damaged lines, what is false</caption>\
         <thead><tr>{head}</tr></thead><tbody>\n{}</tbody></table></div>\n",
        wide("Findings"),
        rows.concat()
    )
}

fn point(point: &[String]) -> String {
    let values: Vec<String> = point.iter().map(|value| format!("<code>{}</code>", escape(value))).collect();
    values.join(", ")
}
