//! The section of a claim: statement, witness, proof, and who else has shown it.

use super::point;
use crate::claim::print::{self, Style};
use crate::claim::syntax::Claim;
use crate::refute::outcome::Witness;
use crate::report::handout::evidence::Evidence;
use crate::report::handout::{Handout, STATED, address, certificate_of, coq_file};
use crate::report::markup::escape;
use crate::report::{Entry, mathml, proof, reading};

/// Writes the section.
pub(super) fn section(out: &mut String, entry: &Entry, handout: &Handout) {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let evidence = handout.evidence.get(&claim.name.text);
    heading(out, entry, evidence);
    if !claim.written_items().is_empty() {
        out.push_str("<details><summary>Hypotheses and definitions</summary>\n");
        for item in claim.written_items() {
            let text = escape(&Style::Unicode.item(item));
            out.push_str(&format!(
                "<div class=\"math\" role=\"group\" aria-label=\"{text}\">{}</div>\n",
                mathml::item(item)
            ));
        }
        out.push_str("</details>\n");
    }
    goal(out, claim);
    if let Some(witness) = &outcome.witness {
        fails_at(out, claim, witness);
    }
    if let Some(reason) = &outcome.reason {
        out.push_str(&format!("<p>{}</p>\n", escape(reason)));
    }
    for note in &claim.notes {
        out.push_str(&format!("<p>{}</p>\n", escape(note)));
    }
    if let Some(document) = &entry.explained {
        out.push_str("<details><summary>Proof</summary>\n<div class=\"proof\">\n");
        out.push_str(&proof::html::html(document));
        out.push_str("</div></details>\n");
    }
    rests_on(out, entry);
    if let Some(evidence) = evidence {
        shown_by(out, &claim.name.text, evidence);
    }
    out.push_str("</section>\n");
}

/// What is proved; where a paper prints it, beside the paper's own formula.
fn goal(out: &mut String, claim: &Claim) {
    let said = escape(&print::prop(claim.written_goal()));
    let read = format!(
        "<div class=\"math\" role=\"group\" aria-label=\"{said}\">{}</div>\n",
        mathml::statement(claim.written_goal())
    );
    let Some(latex) = &claim.typeset else {
        out.push_str(&read);
        return;
    };
    let label = escape(latex);
    let own = match mathml::typeset(latex) {
        Some(formula) => format!("<div class=\"math\" role=\"group\" aria-label=\"{label}\">{formula}</div>"),
        None => format!("<pre>{label}</pre>"),
    };
    out.push_str(&format!(
        "<div class=\"sides\">\n<div><p class=\"meta\">In the paper</p>\n{own}</div>\n\
         <div><p class=\"meta\">As it was read</p>\n{read}</div>\n</div>\n"
    ));
}

/// The title with the verdict, and where the claim stands.
fn heading(out: &mut String, entry: &Entry, evidence: Option<&Evidence>) {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let verdict = outcome.verdict.name();
    let mark = |(text, good)| format!(" <span class=\"mark {}\">{text}</span>", if good { "good" } else { "lack" });
    let marks: Vec<String> =
        evidence.map(|e| e.marks(outcome.verdict)).unwrap_or_default().into_iter().map(mark).collect();
    let number = claim.number.as_ref().map_or(String::new(), |n| format!("({}) ", escape(n)));
    out.push_str(&format!(
        "<section class=\"claim\" aria-labelledby=\"{0}\">\n<h3 id=\"{0}\">{number}{1} \
         <span class=\"verdict {verdict}\">{verdict}</span>{2}</h3>\n<p class=\"meta\">{0}",
        escape(&claim.name.text),
        escape(&claim.title),
        marks.concat(),
    ));
    if let Some(source) = &claim.source {
        out.push_str(&format!(" · {}", escape(source)));
    }
    if let Some(reading) = reading(claim) {
        out.push_str(&format!(" · {reading}"));
    }
    if !outcome.method.is_empty() {
        out.push_str(&format!(" · by {}", escape(&outcome.method)));
    }
    if !entry.as_expected() {
        out.push_str(" · <strong>not as expected</strong>");
    }
    out.push_str("</p>\n");
}

/// The point at which a refuted claim fails, and what is broken there.
fn fails_at(out: &mut String, claim: &Claim, witness: &Witness) {
    out.push_str(&format!(
        "<div class=\"witness\">\n<p>It fails at {}.</p>\n<ul>\n",
        point(&witness.point.in_words(claim))
    ));
    for broken in &witness.broken {
        out.push_str(&format!("<li><code>{}</code>", escape(&broken.statement)));
        if !broken.right.is_empty() {
            let (left, right) = (escape(&broken.left), escape(&broken.right));
            out.push_str(&format!(": left side <code>{left}</code>, right side <code>{right}</code>"));
        }
        out.push_str("</li>\n");
    }
    out.push_str("</ul>\n</div>\n");
}

/// The hypotheses that were used, and a point at which they hold; the claims that are cited.
fn rests_on(out: &mut String, entry: &Entry) {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    for (title, list) in [("Used", &outcome.used), ("Stated but not needed", &outcome.unused)] {
        if !list.is_empty() {
            let list: Vec<String> = list.iter().map(|h| format!("<code>{}</code>", escape(h))).collect();
            out.push_str(&format!("<p class=\"meta\">{title}: {}</p>\n", list.join("; ")));
        }
    }
    if let Some(sample) = &outcome.sample {
        out.push_str(&format!(
            "<p class=\"meta\">The hypotheses hold, for instance, at {}.</p>\n",
            point(&sample.in_words(claim))
        ));
    }
    if !claim.using.is_empty() {
        let list: Vec<String> =
            claim.using.iter().map(|n| format!("<a href=\"#{0}\">{0}</a>", escape(&n.text))).collect();
        out.push_str(&format!("<p class=\"meta\">Rests on {}.</p>\n", list.join(", ")));
    }
}

/// Certificate and theorem, or why there is none.
fn shown_by(out: &mut String, name: &str, evidence: &Evidence) {
    let link = |path: &str| format!("<a href=\"{}\">{}</a>", address(path), escape(path));
    if let Some(proof) = &evidence.kernel {
        out.push_str(&format!(
            "<p class=\"meta\">Checked by the kernel: {}, SHA-256 of the statement <code>{}</code>{}.</p>\n",
            link(&certificate_of(name)),
            proof.statement,
            match proof.rests_on.as_slice() {
                [] => String::new(),
                list => format!("; rests on {}", escape(&list.join(", "))),
            }
        ));
    }
    match &evidence.coq {
        Ok(theorem) => out.push_str(&format!(
            "<p class=\"meta\">Coq: theorem <code>{}</code>, stated in {}, proved in {}.</p>\n\
             <details><summary>The theorem in Coq</summary>\n<pre><code>{}</code></pre>\n{}</details>\n",
            escape(&theorem.name),
            link(&coq_file(STATED)),
            link(&coq_file(&theorem.module)),
            escape(&theorem.statement),
            theorem
                .proof
                .as_ref()
                .map_or_else(String::new, |proof| format!("<pre><code>{}</code></pre>\n", escape(proof)))
        )),
        Err(reason) => out.push_str(&format!("<p class=\"meta\">Not in Coq: {}.</p>\n", escape(reason))),
    }
}
