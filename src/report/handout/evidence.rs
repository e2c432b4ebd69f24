//! Who has shown a claim: the kernel, by a certificate that it accepted in this run, and Coq, by a theorem.
//!
//! Contract: a theorem of Coq is named only where its statement stands in `proofs/coq/claims.v` letter by letter as this claim is
//! exported, and says what the verdict says. Coq itself is not run there: whoever doubts runs it on the files in the folder.
//! Where Coq was run on proofs made from the certificates ([`ran`]), a theorem is named only where Coq accepted it.

use crate::claim::embedded;
use crate::claim::syntax::{Claim, Expectation};
use crate::export::coq;
use crate::judge::Proof;
use crate::refute::outcome::Verdict;
use crate::report::theorems::{File, Folder};
use crate::report::{Audit, Entry};
use std::collections::BTreeMap;

/// A theorem of Coq and its proof.
pub struct Theorem {
    /// Its name.
    pub name: String,
    /// The file of its proof, without folder and ending.
    pub module: String,
    /// The file that states it.
    pub stated: &'static str,
    /// Whether Coq accepted it while the report was made.
    pub accepted: bool,
    /// Its statement, as it stands in `claims.v`; of a refuted claim, the negation.
    pub statement: String,
    /// Its proof, as it stands in the file.
    pub proof: String,
}

/// Who has shown a claim, other than the search.
pub struct Evidence {
    /// What the kernel accepted in this run; it checks proofs only.
    pub kernel: Option<Proof>,
    /// Coq; else why there is no theorem.
    pub coq: Result<Theorem, String>,
}

impl Evidence {
    /// Whether nobody but the search vouches for the verdict: a counterexample that it evaluated, without a certificate, and
    /// that Coq has not shown.
    #[must_use]
    pub fn is_alone(&self) -> bool {
        self.kernel.is_none() && self.coq.is_err()
    }

    /// What stands beside the verdict: a few words each, and whether they are good news.
    #[must_use]
    pub fn marks(&self, verdict: Verdict) -> Vec<(&'static str, bool)> {
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

/// The evidence for each claim of an audit, by name.
pub fn gather(audit: &Audit) -> BTreeMap<String, Evidence> {
    let library = Library::embedded();
    let one = |entry: &Entry| {
        let coq = library.theorem(&entry.claim, entry.outcome.verdict);
        (entry.claim.name.text.clone(), Evidence { kernel: entry.proof.clone(), coq })
    };
    audit.entries.iter().map(one).collect()
}

/// The evidence where Coq was run on a folder of generated proofs; `refused` says of theorems and files why Coq did not
/// accept them.
pub fn ran(audit: &Audit, made: &Folder, refused: &dyn Fn(&str, &str) -> Option<String>) -> BTreeMap<String, Evidence> {
    let one = |entry: &Entry| {
        let file = made.files.iter().find(|file| file.claim == entry.claim.name.text);
        let coq = match file.map(|file| (file, file.module.as_ref(), file.theorems.first())) {
            Some((file, Some(module), Some(theorem))) if !theorem.name.ends_with("_defined") => {
                match refused(module, &theorem.name) {
                    Some(why) => Err(why),
                    None => Ok(accepted(file, module, &theorem.name)),
                }
            }
            Some((file, _, _)) => Err(file.open.first().map_or_else(String::new, |open| open.1.clone())),
            None => Err("it has no file for Coq".to_string()),
        };
        (entry.claim.name.text.clone(), Evidence { kernel: entry.proof.clone(), coq })
    };
    audit.entries.iter().map(one).collect()
}

/// A theorem of a generated file that Coq accepted.
fn accepted(file: &File, module: &str, name: &str) -> Theorem {
    let from = file.text.find(&format!("Theorem {name} :\n")).unwrap_or_default();
    let (statement, proof) = file.text[from..].split_once("\nProof.").unwrap_or_default();
    let proof = proof.split_once("\nQed.").map_or(proof, |(proof, _)| proof);
    Theorem {
        name: name.to_string(),
        module: module.to_string(),
        stated: "statements",
        accepted: true,
        statement: statement.to_string(),
        proof: format!("Proof.{proof}\nQed."),
    }
}

/// The Coq files.
struct Library {
    /// What `claims.v` says.
    claims: &'static str,
    /// The file of each theorem, and its text.
    places: BTreeMap<String, (String, &'static str)>,
}

impl Library {
    fn embedded() -> Library {
        let files = embedded::coq_files();
        let claims = files.iter().find(|f| f.path == "claims").map_or("", |f| f.text);
        let places = |f: &embedded::File| {
            let text = f.text;
            coq::proofs_in(f.path, text).into_iter().map(move |(name, module)| (name, (module, text)))
        };
        Library { claims, places: files.iter().flat_map(places).collect() }
    }

    /// The theorem that says of a claim what the verdict says.
    fn theorem(&self, claim: &Claim, verdict: Verdict) -> Result<Theorem, String> {
        let said = coq::statement(claim).map_err(|refusal| format!("it cannot be said in Coq: {}", refusal.reason))?;
        let name = said.name;
        let stated = match verdict {
            Verdict::Proved => claim.expect != Expectation::Refuted,
            Verdict::Refuted => claim.expect == Expectation::Refuted,
            Verdict::Undecided => false,
        };
        let export = "the Coq files hold no theorem of this statement; carom export coq can state it".to_string();
        let Some((module, text)) = self.places.get(&name).filter(|_| stated) else { return Err(export) };
        let whole = format!("\nTheorem {name} :\n{}.\nProof. exact {module}.{name}. Qed.\n", said.full);
        let proof = proof(&name, text);
        match proof.filter(|_| self.claims.contains(&whole)) {
            Some(proof) => {
                let statement = format!("Theorem {name} :\n{}.", said.full);
                let proof = proof.to_string();
                Ok(Theorem { name, module: module.clone(), stated: "claims", accepted: false, statement, proof })
            }
            None => Err(export),
        }
    }
}

/// A theorem with its proof in a file of proofs.
fn proof<'a>(name: &str, text: &'a str) -> Option<&'a str> {
    let from = text.find(&format!("\nTheorem {name} : statements.{name}.\n"))? + 1;
    let length = text[from..].find("Qed.")? + "Qed.".len();
    Some(&text[from..from + length])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_claim_with_a_known_name_and_another_statement_has_no_theorem() {
        let mut claims = embedded::claims(&["eq13".to_string()]).ok().flatten().unwrap_or_default();
        let mut claim = claims.remove(claims.iter().position(|c| c.name.text == "eq13").expect("a claim"));
        let library = Library::embedded();
        let theorem = library.theorem(&claim, Verdict::Proved).expect("a theorem");
        assert_eq!((theorem.name.as_str(), theorem.module.as_str()), ("eq13", "transfer"));
        assert!(theorem.proof.starts_with("Theorem eq13 : statements.eq13.") && theorem.proof.ends_with("Qed."));
        assert!(library.theorem(&claim, Verdict::Refuted).is_err());
        claim.items.remove(0);
        assert!(library.theorem(&claim, Verdict::Proved).is_err());
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
