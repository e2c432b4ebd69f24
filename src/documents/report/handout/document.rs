//! The report as a LaTeX document.
//!
//! Contract: it compiles with what Debian's texlive-latex-recommended has, with pdflatex and with lualatex. A formula
//! wider than the page is broken at its relations and signs, and what still is too wide is made smaller, by TeX itself,
//! which alone knows how wide it is.

use super::evidence::Evidence;
use super::numbers::{Plot, Table, WHAT_IS_CERTAIN};
use super::{Handout, STATED, certificate_of, coq_file, findings, named, plot_file, provenance, table_file};
use crate::refute::outcome::Verdict;
use crate::report::argument::{clauses_latex, remarks};
use crate::report::latex::{code, escape};
use crate::report::table::Entry as Cell;
use crate::report::table::latex::PAGE;
use crate::report::{Entry, proof, reading, summary};

/// The preamble of the document; formulas use [`proof::latex::MACROS`].
const PREAMBLE: &str = r"\documentclass[a4paper,10pt]{article}
\usepackage{iftex}
\ifpdftex\usepackage[T1]{fontenc}\usepackage[utf8]{inputenc}\pdfsuppressptexinfo=-1 \pdftrailerid{}\fi
\usepackage{amsmath,amssymb,textcomp,array,booktabs,longtable,graphicx}
\usepackage[margin=24mm]{geometry}
\usepackage[hidelinks]{hyperref}
\setlength{\parindent}{0pt}\setlength{\parskip}{3pt plus 1pt}
\setcounter{secnumdepth}{0}\setcounter{tocdepth}{1}
\sloppy\hbadness=10000
\relpenalty=100 \binoppenalty=300
";

/// The document.
pub(super) fn document(handout: &Handout) -> String {
    let s = summary(&handout.audit.entries);
    let title = escape(&handout.title);
    let mut out = format!(
        "{PREAMBLE}{}\\title{{{title}}}\n\\author{{}}\n\\date{{}}\n\\begin{{document}}\n\\maketitle\n\
         {}: {} proved, {} refuted, {} undecided; {} not as expected.\n{}\n\\tableofcontents\n",
        proof::latex::MACROS,
        handout.audit.count(),
        s.proved,
        s.refuted,
        s.undecided,
        s.unexpected,
        escape(&handout.vouched().join(" ")),
    );
    let again = handout.again();
    if !again.is_empty() {
        out.push_str("\n\\paragraph{To check again,} in the folder of this report:\n\\begin{itemize}\n");
        for (command, what) in again {
            out.push_str(&format!("\\item {}: {}.\n", code(&command), escape(what)));
        }
        out.push_str("\\end{itemize}\n");
    }
    findings(&mut out, handout);
    for (section, entries) in handout.audit.sections() {
        out.push_str(&format!("\n\\section{{{}}}\n", escape(section)));
        for entry in entries {
            for paragraph in &entry.claim.prose {
                out.push_str(&format!("\n{}\n\n", escape(paragraph)));
            }
            claim(&mut out, entry, handout.evidence.get(&entry.claim.name.text));
        }
    }
    if !handout.tables.is_empty() || !handout.plots.is_empty() {
        out.push_str(&format!("\n\\section{{Numbers}}\n{}\n", escape(WHAT_IS_CERTAIN)));
    }
    for (place, one) in handout.tables.iter().enumerate() {
        table(&mut out, handout, place, one);
    }
    for (place, one) in handout.plots.iter().enumerate() {
        plot(&mut out, handout, place, one);
    }
    out.push_str("\\end{document}\n");
    out
}

fn findings(out: &mut String, handout: &Handout) {
    let list = findings::of(&handout.audit);
    if list.is_empty() {
        return;
    }
    out.push_str(
        "\n\\section{Findings}\n{\\small\\begin{longtable}{@{}>{\\raggedright}p{0.17\\linewidth}\
         >{\\raggedright}p{0.15\\linewidth}>{\\raggedright\\arraybackslash}p{0.61\\linewidth}@{}}\n\
         \\toprule\nclaim & finding & what was found \\\\\n\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n",
    );
    for finding in list {
        let mut says = vec![format!("{}.", escape(finding.title))];
        says.extend(finding.says.iter().map(|s| escape(s)));
        if let Some(at) = &finding.fails_at {
            says.push(format!("Fails at {}.", code(&at.join(", "))));
        }
        out.push_str(&format!("{} & {} & {} \\\\\n", code(finding.name), finding.kind, says.join(" ")));
    }
    out.push_str("\\end{longtable}}\n");
}

fn claim(out: &mut String, entry: &Entry, evidence: Option<&Evidence>) {
    let (claim, outcome) = (&entry.claim, &entry.outcome);
    let marks: Vec<&str> =
        evidence.map(|e| e.marks(outcome.verdict)).unwrap_or_default().into_iter().map(|m| m.0).collect();
    let verdict = std::iter::once(outcome.verdict.name()).chain(marks).collect::<Vec<_>>().join(", ");
    let number = claim.number.as_ref().map_or(String::new(), |n| format!("({}) ", escape(n)));
    out.push_str(&format!(
        "\n\\subsection{{{number}{}}}\n\\textbf{{{verdict}}}. {}",
        escape(&claim.title),
        code(&claim.name.text)
    ));
    for part in [claim.source.as_deref(), reading(claim)].into_iter().flatten() {
        out.push_str(&format!("; {}", escape(part)));
    }
    if !outcome.method.is_empty() {
        out.push_str(&format!("; by {}", escape(&outcome.method)));
    }
    if !entry.as_expected() {
        out.push_str("; \\textbf{not as expected}");
    }
    out.push_str(".\n");
    if let Some(latex) = &claim.typeset {
        out.push_str(&format!(
            "\n\\noindent\\textit{{In the paper}}\n\\[ {latex} \\]\n\\noindent\\textit{{As it was read}}\n"
        ));
    }
    out.push_str(&clauses_latex(claim));
    if let Some(document) = &entry.explained {
        out.push_str(&format!("\n\\textit{{Proof}}\n{}", proof::latex::latex(document)));
    }
    for (title, lines) in remarks(entry) {
        let text = if title == "Notes" {
            escape(&lines.join(" "))
        } else {
            lines.iter().map(|l| code(l)).collect::<Vec<_>>().join("; ") + "."
        };
        out.push_str(&format!("\n{{\\raggedright {title}: {text}\\par}}\n"));
    }
    if let Some(evidence) = evidence.filter(|_| outcome.verdict != Verdict::Undecided) {
        let said: Vec<String> = shown_by(&claim.name.text, evidence);
        out.push_str(&format!("\n{{\\footnotesize\\raggedright {}\\par}}\n", said.join(" ")));
    }
}

/// Certificate and theorem, or why there is none.
fn shown_by(name: &str, evidence: &Evidence) -> Vec<String> {
    let mut out = Vec::new();
    if let Some(proof) = &evidence.kernel {
        out.push(format!(
            "Checked by the kernel: {}, SHA-256 of the statement {}{}.",
            code(&certificate_of(name)),
            code(&proof.statement),
            match proof.rests_on.as_slice() {
                [] => String::new(),
                list => format!("; rests on {}", escape(&list.join(", "))),
            }
        ));
    }
    out.push(match &evidence.coq {
        Ok(theorem) => format!(
            "Coq: theorem {}, stated in {}, proved in {}.",
            code(&theorem.name),
            code(&coq_file(STATED)),
            code(&coq_file(&theorem.module))
        ),
        Err(reason) => format!("Not in Coq: {}.", escape(reason)),
    });
    out
}

fn table(out: &mut String, handout: &Handout, place: usize, table: &Table) {
    let said: Vec<String> = provenance(handout, table).iter().map(|text| escape(&text.replace('`', ""))).collect();
    out.push_str(&format!(
        "\n\\subsection{{Table {}: {}}}\n{{\\small {}.\\par}}\\nopagebreak\n{{\\footnotesize Made by {}; also in {}.\\par}}\\nopagebreak\n",
        place + 1,
        escape(table.title()),
        said.join(". "),
        code(&table.command),
        code(&table_file(place, "csv")),
    ));
    let columns: String = table.head.columns.iter().map(|c| if c.numeric { 'r' } else { 'l' }).collect();
    let row = |cells: Vec<String>| format!("{} \\\\\n", cells.join(" & "));
    let heading = row(table.head.columns.iter().map(|c| c.latex.clone()).collect());
    let mut body = String::new();
    for cells in &table.rows {
        body.push_str(&row(cells.iter().map(cell).collect()));
    }
    let columns = format!("{{@{{}}{columns}@{{}}}}");
    // A short table is not split across pages.
    out.push_str(&match table.rows.len() {
        0..=PAGE => format!(
            "{{\\centering\\small\\begin{{tabular}}{columns}\n\\toprule\n{heading}\\midrule\n{body}\\bottomrule\n\\end{{tabular}}\\par}}\n"
        ),
        _ => format!(
            "{{\\small\\begin{{longtable}}{columns}\n\\toprule\n{heading}\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n{body}\\end{{longtable}}}}\n"
        ),
    });
}

/// An entry, with its last digits small where it says so.
fn cell(entry: &Cell) -> String {
    match entry.parts() {
        (kept, "", _) => escape(kept),
        (kept, small, exponent) => {
            let exponent = if exponent.is_empty() { String::new() } else { format!("e{}", escape(exponent)) };
            format!("{}{{\\scriptsize {}}}{exponent}", escape(kept), escape(small))
        }
    }
}

fn plot(out: &mut String, handout: &Handout, place: usize, plot: &Plot) {
    out.push_str(&format!(
        "\n\\subsection{{Figure {}: {}}}\n\\includegraphics[width=\\linewidth]{{{}}}\n\n\
         {{\\small The formulas are those of {}. Made by {}.\\par}}\n",
        place + 1,
        escape(&plot.title),
        plot_file(place, "png"),
        escape(&named(handout, plot.claims).replace('`', "")),
        code(&plot.command),
    ));
}
