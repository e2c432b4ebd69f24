//! Who has shown a claim: the kernel, by a certificate that it accepted in this run, and Coq, by a theorem.
//!
//! Contract: where Coq was run on the proofs that are made from the certificates ([`ran`]), a theorem is named only where Coq
//! accepted it. Where Coq was not run ([`gather`]), a theorem is named only where its statement stands in
//! `proofs/coq/claims.v` letter by letter as this claim is exported, and the proof in the folder says what the verdict says.

use crate::claim::syntax::Claim;
use crate::export::coq;
use crate::judge::Proof;
use crate::refute::outcome::Verdict;
use crate::report::theorems::{File, Folder};
use crate::report::{Audit, Entry};
use carom_catalogue as embedded;
use std::collections::BTreeMap;

/// A theorem of Coq and its proof.
pub struct Theorem {
    /// Its name.
    pub name: String,
    /// The file of its proof, without folder and ending.
    pub module: String,
    /// Whether Coq accepted it while the report was made.
    pub accepted: bool,
    /// Its statement; of a refuted claim, the negation.
    pub statement: String,
    /// Its proof in the file, unless it is long.
    pub proof: Option<String>,
}

/// Who has shown a claim, other than the search.
pub struct Evidence {
    /// The proof that the kernel accepted in this run.
    pub kernel: Option<Proof>,
    /// Coq; else why there is no theorem.
    pub coq: Result<Theorem, String>,
}

impl Evidence {
    /// Whether nobody but the search vouches for the verdict: a counterexample that it evaluated, without a certificate, and
    /// that Coq has not shown.
    #[must_use]
    pub(crate) fn is_alone(&self) -> bool {
        self.kernel.is_none() && self.coq.is_err()
    }

    /// Short remarks beside the verdict, and whether each is good news.
    #[must_use]
    pub(crate) fn marks(&self, verdict: Verdict) -> Vec<(&'static str, bool)> {
        match (verdict, &self.coq) {
            (Verdict::Undecided, _) => Vec::new(),
            (Verdict::Refuted, coq) => {
                let mut marks = match (&self.kernel, coq) {
                    (Some(_), _) => vec![("refutation checked by the kernel", true)],
                    (None, Ok(_)) => Vec::new(),
                    (None, Err(_)) => vec![("evaluated, not certified", false)],
                };
                marks.extend(coq.as_ref().ok().map(|theorem| match theorem.accepted {
                    true => ("negation accepted by Coq", true),
                    false => ("negation proved in Coq", true),
                }));
                marks
            }
            (Verdict::Proved, Ok(theorem)) if theorem.accepted => {
                vec![("checked by the kernel", true), ("accepted by Coq", true)]
            }
            (Verdict::Proved, Ok(_)) => vec![("checked by the kernel", true), ("proved in Coq", true)],
            (Verdict::Proved, Err(_)) => vec![("checked by the kernel", true), ("not in Coq", false)],
        }
    }
}

/// The evidence for each claim of an audit, by name, where Coq is not run; `made` are the proofs for Coq, or why there are
/// none.
pub fn gather(audit: &Audit, made: Result<&Folder, &str>) -> BTreeMap<String, Evidence> {
    let claims = embedded::coq_files().into_iter().find(|f| f.path == "claims").map_or("", |f| f.text);
    let one = |entry: &Entry| {
        let coq = made.map_err(str::to_string).and_then(|made| {
            let (file, module, name) = theorem(entry, made)?;
            match is_stated(claims, &entry.claim, name) {
                true => Ok(read(file, module, name, false)),
                false => {
                    Err(format!("coq/{module}.v holds a proof that Coq was not run on; `carom report --coq` runs it"))
                }
            }
        });
        (entry.claim.name.text.clone(), Evidence { kernel: entry.proof.clone(), coq })
    };
    audit.entries.iter().map(one).collect()
}

/// Whether the page of theorems states this claim, letter by letter, under the name of this theorem.
fn is_stated(claims: &str, claim: &Claim, theorem: &str) -> bool {
    coq::statement(claim).is_ok_and(|said| {
        said.name == theorem && claims.contains(&format!("\nTheorem {theorem} :\n{}.\nProof. exact ", said.full))
    })
}

/// The evidence where Coq was run on a folder of generated proofs; `refused` says of theorems and files why Coq did not
/// accept them.
pub fn ran(audit: &Audit, made: &Folder, refused: &dyn Fn(&str, &str) -> Option<String>) -> BTreeMap<String, Evidence> {
    let one = |entry: &Entry| {
        let coq = theorem(entry, made).and_then(|(file, module, name)| match refused(module, name) {
            Some(why) => Err(why),
            None => Ok(read(file, module, name, true)),
        });
        (entry.claim.name.text.clone(), Evidence { kernel: entry.proof.clone(), coq })
    };
    audit.entries.iter().map(one).collect()
}

/// The file, its module and the theorem that states the verdict of a claim.
fn theorem<'a>(entry: &Entry, made: &'a Folder) -> Result<(&'a File, &'a str, &'a str), String> {
    let file = made.files.iter().find(|file| file.claim == entry.claim.name.text).ok_or("it has no file for Coq")?;
    match (&file.module, file.theorems.first()) {
        (Some(module), Some(theorem)) if !theorem.name.ends_with("_defined") => Ok((file, module, &theorem.name)),
        _ => Err(file.open.first().map_or_else(String::new, |open| open.1.clone())),
    }
}

/// The longest proof that a page shows, in bytes: a longer one is read in its file.
const SHOWN: usize = 4000;

/// A theorem of a generated file.
fn read(file: &File, module: &str, name: &str, accepted: bool) -> Theorem {
    let from = file.text.find(&format!("Theorem {name} :\n")).unwrap_or_default();
    let (statement, proof) = file.text[from..].split_once("\nProof.").unwrap_or_default();
    let proof = proof.split_once("\nQed.").map_or(proof, |(proof, _)| proof);
    Theorem {
        name: name.to_string(),
        module: module.to_string(),
        accepted,
        statement: statement.to_string(),
        proof: (proof.len() <= SHOWN).then(|| format!("Proof.{proof}\nQed.")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_claim_with_a_known_name_and_another_statement_has_no_theorem() {
        let mut claims = embedded::claims(&["eq13".to_string()]).ok().flatten().unwrap_or_default();
        let mut claim = claims.remove(claims.iter().position(|c| c.name.text == "eq13").expect("a claim"));
        let page = embedded::coq_files().into_iter().find(|f| f.path == "claims").expect("the page").text;
        assert!(is_stated(page, &claim, "eq13"));
        assert!(!is_stated(page, &claim, "eq13_refuted"));
        claim.items.remove(0);
        assert!(!is_stated(page, &claim, "eq13"));
    }

    #[test]
    fn what_only_the_prover_has_shown_is_marked() {
        let none = || Err("none".to_string());
        let (certificate, sha256, statement) = Default::default();
        let proof = Proof { certificate, sha256, statement, rests_on: Vec::new() };
        let checked = Evidence { kernel: Some(proof), coq: none() };
        assert!(!checked.is_alone());
        assert_eq!(checked.marks(Verdict::Proved), [("checked by the kernel", true), ("not in Coq", false)]);
        let refuted = Evidence { kernel: None, coq: none() };
        assert!(refuted.is_alone());
        assert_eq!(refuted.marks(Verdict::Refuted), [("evaluated, not certified", false)]);
        assert_eq!(checked.marks(Verdict::Refuted), [("refutation checked by the kernel", true)]);
        assert_eq!(refuted.marks(Verdict::Undecided), []);
    }
}
