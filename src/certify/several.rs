//! Certificates of several claims: those that are cited come first and are then known.
//!
//! Contract: what [`Accepted`] holds went through the kernel in this run, against the claim given and not against its
//! name: a certificate at hand that is of another statement, or is wrong, only costs the time of a search.

use super::{Fail, certify};
use crate::certificate::Certificate;
use crate::certificate::text::digest;
use crate::claim::syntax::Claim;
use crate::kernel::{self, Accepted, Verdict};
use std::collections::BTreeMap;

/// What the kernel accepted so far.
#[derive(Default)]
pub struct Collection {
    accepted: BTreeMap<String, Accepted>,
}

impl Collection {
    /// The certificate of a claim, and what the kernel accepted: the one at hand where the kernel accepts it, else one
    /// that is searched. Claims that it cites must have been added before.
    ///
    /// # Errors
    /// Why none was found.
    pub fn add(&mut self, claim: &Claim, at_hand: Option<Certificate>) -> Result<(Certificate, &Accepted), Fail> {
        let cited: Vec<&Accepted> = claim.using.iter().filter_map(|n| self.accepted.get(&n.text)).collect();
        let held = at_hand.and_then(|certificate| match kernel::check(claim, &certificate, &cited) {
            Verdict::Accepted(shown) if digest(&shown.text()) == certificate.statement => Some((certificate, *shown)),
            _ => None,
        });
        let (certificate, shown) = match held {
            Some(held) => held,
            None => certify(claim, &cited)?,
        };
        let place = self.accepted.entry(claim.name.text.clone());
        Ok((certificate, &*place.and_modify(|old| *old = shown.clone()).or_insert(shown)))
    }
}
