//! Certificates as data: the steps by which a claim is shown, each with all that it cites.
//!
//! Nothing here reasons. A step can be checked from its own text, the facts that it cites and the declarations in
//! scope; no step changes what a later step means. A certificate is bound to its claim by name and by the digest of its
//! statement, which only catches mix-ups: what is accepted is the claim that the kernel is given.

mod needed;
mod step;
pub mod text;

pub use needed::{Needed, needed};
pub use step::*;
