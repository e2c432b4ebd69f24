//! Certificates at hand, by the digest of what they show.
//!
//! Nothing is believed of them: the kernel checks each from nothing, and one that is wrong costs only the time of that.

use crate::certificate::Certificate;
use crate::certificate::text::{digest, read, statement_of};
use crate::claim::embedded;
use crate::claim::syntax::Claim;
use crate::kernel::statement::Statement;
use crate::kernel::{self, Accepted, Verdict};
use std::borrow::Cow;
use std::collections::HashMap;

/// Certificates by the digests of their statements.
#[derive(Default)]
pub struct AtHand(HashMap<String, Vec<Cow<'static, str>>>);

impl AtHand {
    /// Those that come with the program.
    pub fn embedded() -> AtHand {
        let mut out = AtHand::default();
        embedded::certificates().into_iter().for_each(|(_, text)| out.add(Cow::Borrowed(text)));
        out
    }

    /// Adds one; a text that does not begin as a certificate does is left out.
    pub fn add(&mut self, text: Cow<'static, str>) {
        if let Some(statement) = statement_of(&text) {
            self.0.entry(statement.to_string()).or_default().push(text);
        }
    }

    /// The first that the kernel accepts for this claim.
    pub fn accepted(&self, claim: &Claim, cited: &[&Accepted]) -> Option<(Certificate, Accepted)> {
        if self.0.is_empty() {
            return None;
        }
        let statement = digest(&Statement::of(claim).ok()?.text());
        self.0.get(&statement)?.iter().find_map(|text| {
            let certificate = read(text).ok()?;
            match kernel::check(claim, &certificate, cited) {
                Verdict::Accepted(shown) => Some((certificate, *shown)),
                _ => None,
            }
        })
    }
}
