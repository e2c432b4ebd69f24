//! The claims of an audit as theorems for Coq, in a self-contained folder.
//!
//! Contract: each file of the folder states a claim as `carom export coq` does and proves it from its certificate, or
//! says why it does not. What is believed of them is for Coq to say: the folder's `check` compiles them, holds each theorem
//! against `statements.v` and its axioms against a list.

mod folder;

use crate::certificate::text::read;
use crate::certificate::{Certificate, Rule, Step};
use crate::claim::parse::parse_expr;
use crate::claim::syntax::{Claim, Expectation};
use crate::export::coq::{self, Statement, defined, proof, refuted};
use crate::judge::Entry;
use crate::kernel::{self, Accepted};
use crate::refute::catalogue::Catalogue;
use crate::refute::outcome::{Verdict, Witness, limit_reached};
use std::collections::{BTreeMap, BTreeSet};

/// A theorem.
#[derive(Clone, Debug)]
pub struct Theorem {
    /// Its name.
    pub name: String,
    /// Its statement, as in `statements.v`.
    pub says: String,
}

/// The file of one claim.
#[derive(Clone, Debug)]
pub struct File {
    /// The claim.
    pub claim: String,
    /// The file's name without its ending; `None` where Coq cannot say the claim.
    pub module: Option<String>,
    /// The text.
    pub text: String,
    /// What it proves.
    pub theorems: Vec<Theorem>,
    /// The claims that it states without a proof, by name, and why.
    pub open: Vec<(String, String)>,
    /// The files that it needs.
    pub needs: BTreeSet<String>,
}

/// Why there is no folder: two claims would be one file, or a claim one of the library's.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Clash {
    /// The claims, or one of them and the library.
    pub claims: (String, String),
    /// The name of the file.
    pub file: String,
}

impl std::fmt::Display for Clash {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Clash { claims: (a, b), file } = self;
        write!(f, "{a} and {b} would both become {file}.v for Coq: rename one, or export them separately")
    }
}

/// The folder.
#[derive(Clone, Debug)]
pub struct Folder {
    /// The files of claims, those of cited claims first.
    pub files: Vec<File>,
    statements: Vec<Statement>,
}

/// A search for a certificate of a theorem that no audit judged, where these claims are cited; or why there is none.
pub type Search<'a> = dyn Fn(&Claim, &[&Accepted]) -> Result<Certificate, String> + 'a;

/// The state of the claims while the files are made.
struct Maker<'a> {
    catalogue: &'a Catalogue,
    search: &'a Search<'a>,
    accepted: BTreeMap<String, Accepted>,
    /// The claims whose first theorem is there.
    proved: BTreeSet<String>,
}

/// The folder of these claims; each entry's cited claims have to be among them.
///
/// # Errors
/// Two files would have one name.
pub fn folder(catalogue: &Catalogue, entries: &[Entry], search: &Search<'_>) -> Result<Folder, Clash> {
    let by_name: BTreeMap<&str, &Entry> = entries.iter().map(|e| (e.claim.name.text.as_str(), e)).collect();
    let asked: Vec<Claim> = entries.iter().map(|e| e.claim.clone()).collect();
    let mut maker = Maker { catalogue, search, accepted: BTreeMap::new(), proved: BTreeSet::new() };
    let mut names: BTreeMap<String, String> =
        folder::own_modules().into_iter().map(|module| (module.to_lowercase(), "the library".to_string())).collect();
    let mut out = Folder { files: Vec::new(), statements: Vec::new() };
    for claim in catalogue.in_order(&asked) {
        let Some(entry) = by_name.get(claim.name.text.as_str()) else { continue };
        let (file, statement) = maker.file(entry);
        if let Some(module) = &file.module {
            // Folders of some systems do not tell capital letters from small ones.
            if let Some(other) = names.insert(module.to_lowercase(), file.claim.clone()) {
                return Err(Clash { claims: (other, file.claim), file: module.clone() });
            }
        }
        out.files.push(file);
        out.statements.extend(statement);
    }
    Ok(out)
}

impl Maker<'_> {
    /// The file of one claim.
    fn file(&mut self, entry: &Entry) -> (File, Option<Statement>) {
        let claim = &entry.claim;
        let mut file = File {
            claim: claim.name.text.clone(),
            module: None,
            text: String::new(),
            theorems: Vec::new(),
            open: Vec::new(),
            needs: BTreeSet::new(),
        };
        let stated = match coq::statement(claim) {
            Ok(stated) => stated,
            Err(refusal) => {
                file.open.push((coq::identifier(&file.claim), format!("Coq cannot state it: {}", refusal.reason)));
                return (file, None);
            }
        };
        let mut bodies = String::new();
        match self.first(entry, &stated) {
            Ok(first) => {
                bodies += &first.text;
                file.theorems.push(first.theorem);
                file.needs.extend(first.cites.iter().map(|name| coq::identifier(name)));
                self.proved.insert(file.claim.clone());
            }
            Err(reason) => file.open.push((stated.name.clone(), reason)),
        }
        if let Some(full) = &stated.defined {
            let name = format!("{}_defined", stated.name);
            match self.second(entry, &name, full) {
                Ok(second) => {
                    bodies += &second.text;
                    file.theorems.push(second.theorem);
                    file.needs.extend(second.cites.iter().map(|name| coq::identifier(name)));
                }
                Err(reason) => file.open.push((name, reason)),
            }
        }
        file.text = head(&bodies, &file.needs);
        file.text += &format!("\n(* statement sha256 {} *)\n", stated.digest);
        for (name, reason) in &file.open {
            let full = stated.propositions().into_iter().find(|p| p.0 == *name).map_or("", |p| p.1);
            file.text += &format!("(* No proof: {}. *)\nDefinition {name} : Prop :=\n{full}.\n\n", comment(reason));
        }
        file.text += &bodies;
        file.module = Some(stated.name.clone());
        (file, Some(stated))
    }

    /// The accepted claims that a claim cites.
    fn cited(&self, claim: &Claim) -> Vec<&Accepted> {
        claim.using.iter().filter_map(|name| self.accepted.get(&name.text)).collect()
    }

    /// The theorem that states the verdict.
    fn first(&mut self, entry: &Entry, stated: &Statement) -> Result<Made, String> {
        let claim = &entry.claim;
        match (entry.outcome.verdict, &entry.proof) {
            (Verdict::Proved, Some(proof)) => {
                let certificate = read(&proof.certificate).map_err(|e| e.fault.to_string())?;
                let cited = self.cited(claim);
                if let kernel::Verdict::Accepted(shown) = kernel::check(claim, &certificate, &cited) {
                    self.accepted.insert(claim.name.text.clone(), *shown);
                }
                if claim.expect == Expectation::Refuted {
                    return Err("it is proved, but its file expects it to be refuted".to_string());
                }
                let cited = self.cited(claim);
                let made = proof::script(claim, &certificate, &cited, &|name| self.catalogue.get(name).cloned());
                let made = made.map_err(|open| why(&open))?;
                if let Some(missing) = made.cites.iter().find(|name| !self.proved.contains(*name)) {
                    return Err(format!("it cites {missing}, which has no proof here"));
                }
                let script = format!("{}\n  finish {}.", made.text, made.shown);
                Ok(Made::new(&stated.name, &stated.full, &script, made.cites, format!("statements.{}", stated.name)))
            }
            (Verdict::Refuted, proof) => {
                let witness = entry.outcome.witness.as_ref().ok_or("its counterexample is not certified")?;
                let point = point(witness)?;
                let certificate = match refuted::is_computed(claim, &point).map_err(|open| why(&open))? {
                    true => None,
                    false => match proof.as_ref().and_then(|proof| held(&proof.certificate, &point)) {
                        Some(certificate) => Some(certificate),
                        None => Some(refutation(claim, &point, self.search)?),
                    },
                };
                let made = refuted::proof(claim, &point, certificate.as_ref()).map_err(|open| why(&open))?;
                let (name, full, says) = match claim.expect {
                    Expectation::Refuted => {
                        (stated.name.clone(), stated.full.clone(), format!("statements.{}", stated.name))
                    }
                    _ => {
                        let full = format!("  ~ (\n{})", stated.full);
                        (format!("{}_refuted", stated.name), full, format!("(~ statements.{})", stated.name))
                    }
                };
                let mut out = Made::new(&name, &full, &made.script, BTreeSet::new(), says);
                out.text = format!("{}\n{}", made.lemma, out.text);
                Ok(out)
            }
            (_, _) => Err(match &entry.outcome.reason {
                Some(reason) => format!("{}: {reason}", entry.outcome.verdict.name()),
                None => entry.outcome.verdict.name().to_string(),
            }),
        }
    }

    /// The theorem that every expression has a value.
    fn second(&self, entry: &Entry, name: &str, full: &str) -> Result<Made, String> {
        let companion = defined::companion(&entry.claim).map_err(|open| why(&open))?;
        let companion = companion.ok_or("nothing that it needs is known")?;
        let cited = self.cited(&entry.claim);
        let certificate = (self.search)(&companion, &cited)?;
        let claims = |name: &str| self.catalogue.get(name).cloned();
        let made = defined::proof(&companion, &certificate, &cited, &claims).map_err(|open| why(&open))?;
        Ok(Made::new(name, full, &made.text, made.cites, format!("statements.{name}")))
    }
}

/// A theorem with its text.
struct Made {
    theorem: Theorem,
    text: String,
    cites: BTreeSet<String>,
}

impl Made {
    fn new(name: &str, full: &str, script: &str, cites: BTreeSet<String>, says: String) -> Made {
        let text = format!("Theorem {name} :\n{full}.\nProof.\n{script}\nQed.\n\n");
        Made { theorem: Theorem { name: name.to_string(), says }, text, cites }
    }
}

/// The beginning of a file: it imports only the part of the library that its proofs need, because Coq loads it for each file.
fn head(bodies: &str, needs: &BTreeSet<String>) -> String {
    let mut text = "From Carom Require Import vocabulary rules".to_string();
    for (module, words) in [("values", &["  valued "][..]), ("points", &["evaluated", "computed", "premises_at"])] {
        if words.iter().any(|word| bodies.contains(word)) {
            text += &format!(" {module}");
        }
    }
    text += ".\n";
    needs.iter().for_each(|module| text += &format!("From Carom Require {module}.\n"));
    text
}

/// Why there is no proof for Coq.
fn why(open: &proof::Open) -> String {
    match open {
        proof::Open::Unsupported(refusal) => format!("Coq cannot state a step: {}", refusal.reason),
        proof::Open::Refused(kernel::Refusal::Rejected(reason)) => reason.to_string(),
        proof::Open::Refused(kernel::Refusal::Limit(limit)) => limit_reached(limit),
        proof::Open::Untranslated(step, what) => format!("step {step} of its certificate is not translated: {what}"),
    }
}

/// A text that ends no comment of Coq, nor opens one or a string.
fn comment(text: &str) -> String {
    text.replace("(*", "( *").replace("*)", "* )").replace('"', "'")
}

/// Where a claim fails.
fn point(witness: &Witness) -> Result<refuted::Point, String> {
    let read = |(place, value): &(String, String)| match (parse_expr(place), parse_expr(value)) {
        (Ok(place), Ok(value)) => Ok((place, value)),
        _ => Err(format!("the witness has {place} = {value}")),
    };
    witness.point.values.iter().map(read).collect()
}

/// The refutation that the kernel accepted, if it is at this point and each of its steps becomes one of Coq.
fn held(text: &str, point: &refuted::Point) -> Option<Certificate> {
    let certificate = read(text).ok()?;
    let refutes = certificate.refutes.as_ref().filter(|refutes| refutes.undefined.is_none())?;
    let written = |point: &refuted::Point| -> BTreeSet<String> {
        point
            .iter()
            .map(|(place, value)| format!("{} = {}", kernel::key::expr(place), kernel::key::expr(value)))
            .collect()
    };
    let numeric = |step: &Step| matches!(step, Step::Show(show) if matches!(show.rule, Rule::Evaluate));
    (written(&refutes.point) == written(point) && !certificate.steps.iter().any(numeric)).then_some(certificate)
}

/// A certificate of the claim at a point where another one fails.
fn refutation(claim: &Claim, point: &refuted::Point, search: &Search<'_>) -> Result<Certificate, String> {
    let there = refuted::at(claim, point).map_err(|refusal| why(&refusal.into()))?;
    search(&there, &[])
}
