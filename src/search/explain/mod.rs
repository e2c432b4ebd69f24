//! A certificate as a proof in words.
//!
//! Contract: [`proof`] follows a certificate step by step with the kernel, and says of each step that a reader needs what
//! is proved, from which facts and why, in the words of the claim's author. Statements about signs are the kernel's answers; there is no search.
//! Obvious steps are left out: a part of a conjunction, a case that repeats a known fact.

pub mod document;
mod follow;
mod shorthand;
mod signs;
pub mod text;
mod words;

use crate::certificate::Certificate;
use crate::claim::syntax::Claim;
use crate::kernel::{Accepted, Refusal};
pub use document::Document;

/// The proof in a certificate of a claim; `cited` holds the accepted claims that it cites.
///
/// # Errors
/// The kernel does not take a step.
pub fn proof(claim: &Claim, certificate: &Certificate, cited: &[&Accepted]) -> Result<Document, Refusal> {
    let followed = follow::follow(claim, certificate, cited)?;
    Ok(Document::numbered(words::Words::of(claim, &followed).all()).in_words(claim))
}
