//! Stored certificates, by the digest of their statement.
//!
//! Nothing is believed of them: the kernel checks each from nothing, and one that is wrong costs only the time of that.

use crate::certificate::Certificate;
use crate::certificate::text::{digest, read, refuted_by, statement_of};
use crate::claim::syntax::Claim;
use crate::kernel::statement::Statement;
use crate::kernel::{self, Accepted, Verdict, refutation};
use std::borrow::Cow;
use std::collections::HashMap;

/// Certificates by the digests of their statements, and those of refutations by the names of their claims: what they
/// show depends on the point.
#[derive(Default)]
pub struct AtHand {
    proofs: HashMap<String, Vec<Cow<'static, str>>>,
    refutations: HashMap<String, Vec<Cow<'static, str>>>,
}

impl AtHand {
    /// Those of a list that names each, such as the certificates that come with the program.
    pub fn of(named: Vec<(String, &'static str)>) -> AtHand {
        let mut out = AtHand::default();
        named.into_iter().for_each(|(_, text)| out.add(Cow::Borrowed(text)));
        out
    }

    /// Adds one; a text that does not begin as a certificate does is left out.
    pub fn add(&mut self, text: Cow<'static, str>) {
        if let Some(claim) = refuted_by(&text) {
            self.refutations.entry(claim.to_string()).or_default().push(text);
        } else if let Some(statement) = statement_of(&text) {
            self.proofs.entry(statement.to_string()).or_default().push(text);
        }
    }

    /// The first that the kernel accepts for this claim.
    pub fn accepted(&self, claim: &Claim, cited: &[&Accepted]) -> Option<(Certificate, Accepted)> {
        if self.proofs.is_empty() {
            return None;
        }
        let statement = digest(&Statement::of(claim).ok()?.text());
        self.proofs.get(&statement)?.iter().find_map(|text| {
            let certificate = read(text).ok()?;
            match kernel::check(claim, &certificate, cited) {
                Verdict::Accepted(shown) => Some((certificate, *shown)),
                _ => None,
            }
        })
    }

    /// The first stored certificate that the kernel accepts as a refutation of this claim, with the digest of its statement.
    pub fn refuting(&self, claim: &Claim) -> Option<Certificate> {
        self.refutations.get(&claim.name.text)?.iter().find_map(|text| {
            let certificate = read(text).ok()?;
            let shown = refutation::of(claim, certificate.refutes.as_ref()?).ok()?;
            let is_its = digest(&Statement::of(&shown).ok()?.text()) == certificate.statement;
            (is_its && matches!(kernel::check(claim, &certificate, &[]), Verdict::Refuted)).then_some(certificate)
        })
    }
}
