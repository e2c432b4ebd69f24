//! Who else than the prover has shown a claim: the kernel, by a certificate, and Coq, by a theorem.
//!
//! Contract: "checked by the kernel" is said of a claim only where the kernel accepted its certificate in this run. A
//! theorem of Coq is named only where its statement stands in `proofs/coq/claims.v` letter by letter as this claim is
//! exported, and says what the verdict says. Coq itself is not run: whoever doubts runs it on the files in the folder.

use crate::certificate::text::{digest, read, write};
use crate::certify::several::Collection;
use crate::claim::embedded;
use crate::claim::syntax::{Claim, Expectation};
use crate::export::coq;
use crate::prove::outcome::Verdict;
use crate::report::{Audit, Entry};
use std::collections::BTreeMap;

/// What the kernel says of a claim.
pub enum Kernel {
    /// It accepted a certificate.
    Accepted {
        /// The certificate.
        certificate: String,
        /// SHA-256 of the statement as the kernel reads it, in hexadecimal digits; it stands in the certificate.
        digest: String,
        /// The analytic lemmas that it rests on.
        rests_on: Vec<String>,
    },
    /// There is no certificate, and why.
    Without(String),
    /// The claim is not proved: the kernel checks proofs only.
    NotAsked,
}

/// A theorem of Coq and its proof.
pub struct Theorem {
    /// Its name.
    pub name: String,
    /// The file of its proof, without folder and ending.
    pub module: String,
    /// Its statement, as it stands in `claims.v`; of a refuted claim, the negation.
    pub statement: String,
    /// Its proof, as it stands in the file.
    pub proof: String,
}

/// Who else has shown a claim.
pub struct Evidence {
    /// The kernel.
    pub kernel: Kernel,
    /// Coq; else why there is no theorem.
    pub coq: Result<Theorem, String>,
}

impl Evidence {
    /// Whether nobody but the prover vouches for the verdict.
    #[must_use]
    pub fn is_alone(&self) -> bool {
        !self.is_checked() && self.coq.is_err()
    }

    /// Whether the kernel accepted a certificate.
    #[must_use]
    pub fn is_checked(&self) -> bool {
        matches!(self.kernel, Kernel::Accepted { .. })
    }

    /// What stands beside the verdict: a few words each, and whether they are good news.
    #[must_use]
    pub fn marks(&self, verdict: Verdict) -> Vec<(&'static str, bool)> {
        match (verdict, &self.kernel, &self.coq) {
            (Verdict::Undecided, ..) => Vec::new(),
            (Verdict::Refuted, _, Ok(_)) => vec![("negation proved in Coq", true)],
            (Verdict::Refuted, ..) => vec![("refuted by the prover alone", false)],
            (_, Kernel::Accepted { .. }, Ok(_)) => vec![("checked by the kernel", true), ("proved in Coq", true)],
            (_, Kernel::Accepted { .. }, Err(_)) => vec![("checked by the kernel", true), ("not in Coq", false)],
            (_, _, Ok(_)) => vec![("not checked by the kernel", false), ("proved in Coq", true)],
            (_, _, Err(_)) => vec![("proved by the prover alone", false)],
        }
    }
}

/// The evidence for each claim of an audit, by name; `proved` are the proved claims, cited ones first. A certificate
/// that comes with the program is tried before one is searched; `now` hears the name of each claim in turn.
pub fn gather(audit: &Audit, proved: &[Claim], now: &dyn Fn(usize, &str)) -> BTreeMap<String, Evidence> {
    let held: BTreeMap<String, &str> = embedded::certificates().into_iter().collect();
    let mut collection = Collection::default();
    let mut kernel: BTreeMap<String, Kernel> = BTreeMap::new();
    for (place, claim) in proved.iter().enumerate() {
        let name = &claim.name.text;
        now(place, name);
        let at_hand = held.get(name).and_then(|text| read(text).ok());
        let found = match collection.add(claim, at_hand) {
            Ok((certificate, shown)) => Kernel::Accepted {
                certificate: write(&certificate),
                digest: digest(&shown.text()),
                rests_on: shown.rests_on().iter().cloned().collect(),
            },
            Err(reason) => Kernel::Without(reason),
        };
        kernel.insert(name.clone(), found);
    }
    let library = Library::embedded();
    let one = |entry: &Entry| {
        let name = entry.claim.name.text.clone();
        let kernel = match entry.outcome.verdict {
            Verdict::Proved => kernel.remove(&name).unwrap_or(Kernel::NotAsked),
            _ => Kernel::NotAsked,
        };
        (name, Evidence { kernel, coq: library.theorem(&entry.claim, entry.outcome.verdict) })
    };
    audit.entries.iter().map(one).collect()
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
                Ok(Theorem { name, module: module.clone(), statement, proof: proof.to_string() })
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
        let alone = || Evidence { kernel: Kernel::Without("no luck".into()), coq: Err("none".into()) };
        assert!(alone().is_alone());
        assert_eq!(alone().marks(Verdict::Proved), [("proved by the prover alone", false)]);
        let kernel = Kernel::Accepted { certificate: String::new(), digest: String::new(), rests_on: Vec::new() };
        let checked = Evidence { kernel, coq: Err("none".into()) };
        assert!(!checked.is_alone());
        assert_eq!(checked.marks(Verdict::Proved), [("checked by the kernel", true), ("not in Coq", false)]);
        let refuted = Evidence { kernel: Kernel::NotAsked, coq: Err("none".into()) };
        assert_eq!(refuted.marks(Verdict::Refuted), [("refuted by the prover alone", false)]);
        assert_eq!(refuted.marks(Verdict::Undecided), []);
    }
}
