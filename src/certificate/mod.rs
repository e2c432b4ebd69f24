//! Certificates as data: the steps by which a claim is shown, with all the hints that a checker needs.
//!
//! Nothing here reasons. A certificate is bound to its claim by name and by the digest of its
//! statement, which only catches mix-ups: what is accepted is the claim that the kernel is given.

mod step;
pub mod text;

pub use step::*;
