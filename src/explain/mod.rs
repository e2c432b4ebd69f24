//! A certificate as a proof in words.
//!
//! Contract: [`proof`] follows a certificate step by step with the kernel, and says of each step that a reader needs what
//! is shown, from which facts and why. What is said of signs is what the kernel answered; nothing is searched for.
//! Steps that a reader takes by himself are left out: a part of a conjunction, a case that repeats what is known.

pub(crate) mod document;
mod follow;
#[cfg(feature = "report")]
pub(crate) mod html;
#[cfg(feature = "report")]
pub(crate) mod latex;
mod shorthand;
mod signs;
pub mod text;
mod words;

use crate::certificate::Certificate;
use crate::claim::syntax::Claim;
use crate::kernel::{Accepted, Refusal};
pub use document::Document;

/// The proof of a claim that a certificate gives; `cited` holds what was accepted of the claims that it cites.
///
/// # Errors
/// The kernel does not take a step.
pub fn proof(claim: &Claim, certificate: &Certificate, cited: &[&Accepted]) -> Result<Document, Refusal> {
    let followed = follow::follow(claim, certificate, cited)?;
    Ok(Document::numbered(words::Words::of(claim, &followed).all()))
}
