//! An audit as a folder to hand in: a page, Markdown, LaTeX, certificates, Coq proofs, certified tables and pictures.
//!
//! Contract: [`Handout::files`] returns all files of the folder, the same on every machine and at every time. Links go to
//! files of the folder or to places on the same page, never elsewhere. Text from claim files is escaped in each form.
//! Beside each verdict stands the checker that accepted it ([`evidence`]).

mod document;
pub mod evidence;
mod findings;
mod markdown;
pub mod numbers;
mod page;

use super::{Audit, counted};
use crate::refute::outcome::{DIMENSIONS, Verdict};
use evidence::Evidence;
use numbers::{Plot, Table};
use std::collections::BTreeMap;

/// The contents of a report's folder.
pub struct Handout {
    /// The audit.
    pub audit: Audit,
    /// The title.
    pub title: String,
    /// Who else has shown each claim.
    pub evidence: BTreeMap<String, Evidence>,
    /// The Coq proofs made from the certificates, as files; none if there is no theorem.
    pub coq: Vec<(String, String)>,
    /// Whether Coq was run on them while the report was made.
    pub coq_ran: bool,
    /// Whether the claims are those of the built-in catalogue.
    pub catalogue: bool,
    /// Its tables.
    pub tables: Vec<Table>,
    /// Its pictures.
    pub plots: Vec<Plot>,
}

/// How many claims others than the search have shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Counts {
    /// Proved, and accepted by the kernel.
    pub kernel: usize,
    /// Refuted, and accepted by the kernel.
    pub refutations: usize,
    /// Proved or refuted, and so by a theorem of Coq.
    pub coq: usize,
    /// Refuted by evaluation alone.
    pub alone: usize,
}

impl Handout {
    /// The files of the folder, with their paths in it, separated by `/`.
    #[must_use]
    pub fn files(&self) -> Vec<(String, Vec<u8>)> {
        let mut out = vec![
            ("index.html".to_string(), page::page(self).into_bytes()),
            ("report.md".to_string(), markdown::report(self).into_bytes()),
            ("report.tex".to_string(), document::document(self).into_bytes()),
        ];
        for (name, evidence) in &self.evidence {
            if let Some(proof) = &evidence.kernel {
                out.push((certificate_of(name), proof.certificate.clone().into_bytes()));
            }
        }
        out.extend(self.coq.iter().map(|(name, text)| (format!("coq/{name}"), text.clone().into_bytes())));
        for (place, table) in self.tables.iter().enumerate() {
            out.push((table_file(place, "csv"), table.csv.clone().into_bytes()));
            out.push((table_file(place, "jsonl"), table.certificate.clone().into_bytes()));
        }
        for (place, plot) in self.plots.iter().enumerate() {
            out.push((plot_file(place, "svg"), plot.svg.clone().into_bytes()));
            out.push((plot_file(place, "png"), plot.png.clone()));
        }
        out
    }

    /// Counts over some claims.
    #[must_use]
    pub(crate) fn counts<'a>(&self, entries: impl Iterator<Item = &'a super::Entry>) -> Counts {
        let mut out = Counts::default();
        for entry in entries.filter(|e| e.outcome.verdict != Verdict::Undecided) {
            let Some(evidence) = self.evidence.get(&entry.claim.name.text) else { continue };
            match entry.outcome.verdict {
                Verdict::Refuted => out.refutations += usize::from(evidence.kernel.is_some()),
                _ => out.kernel += usize::from(evidence.kernel.is_some()),
            }
            out.coq += usize::from(evidence.coq.is_ok());
            out.alone += usize::from(evidence.is_alone());
        }
        out
    }

    /// Who vouches for the verdicts, in one sentence each.
    #[must_use]
    pub fn vouched(&self) -> Vec<String> {
        let counts = self.counts(self.audit.entries.iter());
        let proved = self.audit.entries.iter().filter(|e| e.outcome.verdict == Verdict::Proved).count();
        let all_refuted = self.audit.entries.iter().filter(|e| e.outcome.verdict == Verdict::Refuted).count();
        let differing = self.audit.entries.iter().filter(|e| e.outcome.method == DIMENSIONS).count();
        let refuted = all_refuted - differing;
        let (has, rests) = match counts.alone {
            1 => ("verdict", "rests"),
            _ => ("verdicts", "rest"),
        };
        let mut out = vec![
            format!(
                "The kernel accepted {} of the {}{} in this run.",
                counts.kernel,
                counted(proved, "proof"),
                match refuted {
                    0 => String::new(),
                    some => format!(", and {} of the {}", counts.refutations, counted(some, "refutation")),
                }
            ),
            match counts.coq {
                0 => "Coq checked none of the verdicts.".to_string(),
                some if self.coq_ran => format!(
                    "Coq accepted theorems for {some} of the {} in this run.",
                    counted(self.audit.entries.len(), "verdict")
                ),
                some => format!(
                    "The Coq files beside this report prove {some} of the {}.",
                    counted(self.audit.entries.len(), "verdict")
                ),
            },
            format!("{} {has} {rests} only on the evaluation of a witness.", counts.alone),
        ];
        if differing > 0 {
            out.push(format!(
                "{} refuted by {} dimensions.",
                counted(differing, "claim") + if differing == 1 { " is" } else { " are" },
                if differing == 1 { "its" } else { "their" }
            ));
        }
        out
    }

    /// How to check everything again.
    #[must_use]
    pub fn again(&self) -> Vec<(String, &'static str)> {
        let mut out = Vec::new();
        if self.evidence.values().any(|e| e.kernel.is_some()) {
            let claims = if self.catalogue { "" } else { " --claims PATH…" };
            out.push((
                format!("carom check certificates{claims}"),
                match self.catalogue {
                    true => "the kernel, on the certificates in this folder",
                    false => "the kernel, on the certificates in this folder; PATH is where the claim files are",
                },
            ));
        }
        if !self.tables.is_empty() {
            out.push(("carom check tables/*.jsonl".to_string(), "the checker of tables, on every cell"));
        }
        if !self.coq.is_empty() {
            out.push((
                "bash coq/check".to_string(),
                match self.coq_ran {
                    true => "Coq, on the proofs made from the certificates, and what axioms they rest on",
                    false => {
                        "Coq, on the proofs made from the certificates, and what axioms they rest on; this report did \
                              not run Coq"
                    }
                },
            ));
        }
        out
    }
}

fn certificate_of(claim: &str) -> String {
    format!("certificates/{claim}.cert")
}

/// The Coq file that states the theorems.
const STATED: &str = "statements";

fn coq_file(module: &str) -> String {
    format!("coq/{module}.v")
}

fn table_file(place: usize, form: &str) -> String {
    format!("tables/table-{}.{form}", place + 1)
}

fn plot_file(place: usize, form: &str) -> String {
    format!("plots/plot-{}.{form}", place + 1)
}

/// A path of the folder as an address relative to it.
fn address(path: &str) -> String {
    let plain = |b: u8| b.is_ascii_alphanumeric() || matches!(b, b'/' | b'-' | b'.' | b'_');
    path.bytes().map(|b| if plain(b) { char::from(b).to_string() } else { format!("%{b:02X}") }).collect()
}

/// The provenance of a table: where its numbers come from, and which checker accepted them. Names of claims are in backquotes.
fn provenance(handout: &Handout, table: &Table) -> Vec<String> {
    let mut out = vec![format!("{}; {}", table.fact("formula"), named(handout, table.claims()))];
    let rounding = table.fact("rounding");
    if !rounding.is_empty() {
        out.push(format!("Rounding: {rounding}"));
    }
    out.push(match table.checked() {
        Ok([]) => "Every cell accepted by the checker of tables".to_string(),
        Ok(claims) => {
            format!("Every cell accepted by the checker of tables; the formula rests on {}", named(handout, claims))
        }
        Err(reason) => format!("Not accepted by the checker of tables: {reason}"),
    });
    out
}

/// Claims with their verdicts, the names between backquotes.
fn named(handout: &Handout, claims: &[&str]) -> String {
    let one = |name: &&str| {
        let found = handout.audit.entries.iter().find(|e| handout.catalogue && e.claim.name.text == **name);
        match found {
            Some(entry) => format!("claim `{name}` ({})", entry.outcome.verdict.name()),
            None => format!("claim `{name}` of the built-in catalogue"),
        }
    };
    claims.iter().map(one).collect::<Vec<_>>().join(", ")
}
