//! An audit as one HTML page that needs nothing else: no network, no scripts, no fonts of ours.
//!
//! Contract: whatever stands in a claim file is escaped, so that no title or note can bring markup into the page.
//! Headings, tables with header cells and a skip link make it readable by keyboard and ear; colours are not the
//! only sign of a verdict; a print style keeps sections together.

use super::markup::escape;
use super::{Audit, Entry, counted, graph, mathml, reading, summary};
use crate::claim::print::{self, Style};
use crate::claim::syntax::Reading;
use crate::prove::outcome::{Point, Verdict};

const STYLE: &str = "\
:root{--ink:#1b1b1b;--paper:#fff;--line:#c9c9c9;--soft:#f4f4f1;--good:#14532d;--bad:#8a1c1c;--open:#6b4a00}\
body{font:1rem/1.5 Georgia,'Times New Roman',serif;color:var(--ink);background:var(--paper);max-width:58rem;\
margin:0 auto;padding:1rem 1.2rem 4rem}\
h1{font-size:1.7rem;line-height:1.2}h2{margin-top:2.5rem;border-bottom:1px solid var(--line)}\
h3{margin:1.6rem 0 .3rem;font-size:1.1rem}a{color:#0b4a8f}a:focus{outline:3px solid #0b4a8f}\
.skip{position:absolute;left:-99rem}.skip:focus{left:1rem}\
table{border-collapse:collapse;width:100%;font-size:.95rem}th,td{border:1px solid var(--line);padding:.3rem .5rem;\
text-align:left;vertical-align:top}th{background:var(--soft)}\
.verdict{font-family:system-ui,sans-serif;font-size:.85rem;font-weight:600;padding:.1rem .5rem;border:1px solid;\
border-radius:1rem;white-space:nowrap}.proved{color:var(--good)}.refuted{color:var(--bad)}.undecided{color:var(--open)}\
.claim{border-top:1px solid var(--line);padding-top:.2rem}.meta{color:#444;font-size:.9rem}\
.math{overflow-x:auto;overflow-y:hidden;padding:.3rem 0}math{font-size:1.05rem}\
details{background:var(--soft);padding:.3rem .7rem;margin:.4rem 0}summary{cursor:pointer}\
ol.argument{list-style:none;padding:0;margin:.3rem 0;font-size:.9rem}ol.argument li{overflow-wrap:anywhere}\
.rule{font-style:italic}code{font-size:.9em;overflow-wrap:anywhere}svg{max-width:100%;height:auto}\
@media print{details{background:none}.claim{break-inside:avoid}a{color:inherit;text-decoration:none}}";

/// The page.
pub fn page(audit: &Audit, title: &str) -> String {
    let title = escape(title);
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
         <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n\
         <a class=\"skip\" href=\"#claims\">Skip to the claims</a>\n<h1>{title}</h1>\n"
    );
    overview(&mut out, audit);
    findings(&mut out, audit);
    let figure = graph::svg(&audit.entries);
    if !figure.is_empty() {
        out.push_str("<h2 id=\"graph\">Which claim rests on which</h2>\n");
        out.push_str(&figure);
    }
    out.push_str("<main id=\"claims\">\n");
    for (section, entries) in audit.sections() {
        out.push_str(&format!("<h2>{}</h2>\n", escape(section)));
        for entry in entries {
            claim(&mut out, entry);
        }
    }
    for problem in &audit.problems {
        out.push_str(&format!("<h2>{}</h2>\n<pre>{}</pre>\n", escape(&problem.name), escape(&problem.message)));
    }
    out.push_str(&format!(
        "</main>\n<footer><p class=\"meta\">Written by carom {}. <em>Proved</em> means: for all values that the \
         hypotheses allow. <em>Refuted</em> means: false at the exact point shown.</p></footer>\n</body>\n</html>\n",
        env!("CARGO_PKG_VERSION")
    ));
    out
}

fn overview(out: &mut String, audit: &Audit) {
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
    out.push_str("<table><caption>Verdicts by section</caption><thead><tr><th scope=\"col\">Section</th>");
    out.push_str("<th scope=\"col\">Proved</th><th scope=\"col\">Refuted</th><th scope=\"col\">Undecided</th>");
    out.push_str("</tr></thead><tbody>\n");
    for (section, entries) in audit.sections() {
        let count = |verdict: Verdict| entries.iter().filter(|e| e.outcome.verdict == verdict).count();
        out.push_str(&format!(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            escape(section),
            count(Verdict::Proved),
            count(Verdict::Refuted),
            count(Verdict::Undecided)
        ));
    }
    out.push_str("</tbody></table>\n");
}

/// What a reader of the paper should know first.
fn findings(out: &mut String, audit: &Audit) {
    let mut rows = Vec::new();
    for entry in &audit.entries {
        let (claim, outcome) = (&entry.claim, &entry.outcome);
        let kind = match (claim.reading, outcome.verdict) {
            (Reading::Extracted, Verdict::Refuted) => "a damaged line of the text",
            (_, Verdict::Refuted) => "false as stated",
            (_, Verdict::Undecided) => "undecided",
            _ if !claim.notes.is_empty() => "note",
            _ => continue,
        };
        let mut says: Vec<String> = claim.notes.iter().map(|n| escape(n)).collect();
        if let Some(witness) = &outcome.witness {
            says.push(format!("Fails at {}.", point(&witness.point)));
        }
        says.extend(outcome.reason.iter().map(|r| escape(r)));
        rows.push(format!(
            "<tr><th scope=\"row\"><a href=\"#{0}\">{0}</a></th><td>{1}</td><td>{2}</td><td>{3}</td></tr>\n",
            escape(&claim.name.text),
            kind,
            escape(&claim.title),
            says.join(" ")
        ));
    }
    if rows.is_empty() {
        return;
    }
    out.push_str("<h2 id=\"findings\">Findings</h2>\n<table><caption>Hidden hypotheses, damaged lines, what is false");
    out.push_str("</caption><thead><tr><th scope=\"col\">Claim</th><th scope=\"col\">Finding</th>");
    out.push_str("<th scope=\"col\">Title</th><th scope=\"col\">What was found</th></tr></thead><tbody>\n");
    out.push_str(&rows.concat());
    out.push_str("</tbody></table>\n");
}

fn point(point: &Point) -> String {
    let values: Vec<String> =
        point.values.iter().map(|(n, v)| format!("<code>{} = {}</code>", escape(n), escape(v))).collect();
    values.join(", ")
}

fn claim(out: &mut String, entry: &Entry) {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let verdict = outcome.verdict.name();
    let number = claim.number.map_or(String::new(), |n| format!("({n}) "));
    out.push_str(&format!(
        "<section class=\"claim\" aria-labelledby=\"{0}\">\n<h3 id=\"{0}\">{number}{1} \
         <span class=\"verdict {verdict}\">{verdict}</span></h3>\n<p class=\"meta\">{0}",
        escape(&claim.name.text),
        escape(&claim.title),
    ));
    if let Some(source) = &claim.source {
        out.push_str(&format!(" · {}", escape(source)));
    }
    out.push_str(&format!(" · {}", reading(claim)));
    if !outcome.method.is_empty() {
        out.push_str(&format!(" · by {}", escape(&outcome.method)));
    }
    if !entry.as_expected() {
        out.push_str(" · <strong>not as expected</strong>");
    }
    out.push_str("</p>\n");
    if !claim.items.is_empty() {
        out.push_str("<details><summary>Hypotheses and definitions</summary>\n");
        for item in &claim.items {
            let text = escape(&Style::Unicode.item(item));
            out.push_str(&format!(
                "<div class=\"math\" role=\"group\" aria-label=\"{text}\">{}</div>\n",
                mathml::item(item)
            ));
        }
        out.push_str("</details>\n");
    }
    let goal = escape(&print::prop(&claim.goal));
    out.push_str(&format!(
        "<div class=\"math\" role=\"group\" aria-label=\"{goal}\">{}</div>\n",
        mathml::statement(&claim.goal)
    ));
    if let Some(witness) = &outcome.witness {
        out.push_str(&format!("<p>It fails at {}.</p>\n<ul>\n", point(&witness.point)));
        for broken in &witness.broken {
            out.push_str(&format!("<li><code>{}</code>", escape(&broken.statement)));
            if !broken.right.is_empty() {
                let (left, right) = (escape(&broken.left), escape(&broken.right));
                out.push_str(&format!(": left side <code>{left}</code>, right side <code>{right}</code>"));
            }
            out.push_str("</li>\n");
        }
        out.push_str("</ul>\n");
    }
    if let Some(reason) = &outcome.reason {
        out.push_str(&format!("<p>{}</p>\n", escape(reason)));
    }
    for note in &claim.notes {
        out.push_str(&format!("<p>{}</p>\n", escape(note)));
    }
    if !outcome.argument.is_empty() && outcome.witness.is_none() {
        out.push_str("<details><summary>Argument</summary>\n<ol class=\"argument\">\n");
        for line in &outcome.argument {
            out.push_str(&format!(
                "<li style=\"padding-left:{}em\"><span class=\"rule\">{}</span>: <code>{}</code></li>\n",
                2 * line.depth.min(20),
                escape(line.rule),
                escape(&line.text)
            ));
        }
        out.push_str("</ol></details>\n");
    }
    for (title, list) in [("Used", &outcome.used), ("Stated but not needed", &outcome.unused)] {
        if !list.is_empty() {
            let list: Vec<String> = list.iter().map(|h| format!("<code>{}</code>", escape(h))).collect();
            out.push_str(&format!("<p class=\"meta\">{title}: {}</p>\n", list.join("; ")));
        }
    }
    if let Some(sample) = &outcome.sample {
        out.push_str(&format!("<p class=\"meta\">The hypotheses hold, for instance, at {}.</p>\n", point(sample)));
    }
    if !claim.using.is_empty() {
        let list: Vec<String> =
            claim.using.iter().map(|n| format!("<a href=\"#{0}\">{0}</a>", escape(&n.text))).collect();
        out.push_str(&format!("<p class=\"meta\">Rests on {}.</p>\n", list.join(", ")));
    }
    out.push_str("</section>\n");
}
