//! Carom audits the algebra of one-dimensional chain collisions and computes with it exactly.
//!
//! A claim file states an equation of a paper with its hypotheses. A search finds a proof for all values that the
//! hypotheses allow, which a small kernel then checks; or an exact point where the claim fails; or it says what is missing.
//!
//! Five functions are the way in; each reads the text that the command of the same name reads.
//!
//! | function | from | to |
//! |---|---|---|
//! | [`audit()`] | a claim file | verdicts, counterexamples, certificates |
//! | [`check()`] | a claim file and a certificate | the statement that the kernel accepted |
//! | [`eval()`] | a scene file | exact numbers, or decimals of which every digit is right |
//! | [`table()`] | a plan over a grid | rows, one at a time |
//! | [`replay()`] | a scene of bodies on a line | its collisions, exactly |
//!
//! ```
//! let claims = "claim half \"Half\"\ngiven x > 0\nprove x/(2*x) = 1/2\n";
//! let entries = carom::audit(claims).unwrap();
//! assert_eq!(entries[0].outcome.verdict.name(), "proved");
//! let certificate = &entries[0].proof.as_ref().unwrap().certificate;
//! println!("{}", carom::check(claims, certificate).unwrap().text());
//! ```
//!
//! The modules are the rooms in which this is done. `docs/architecture.md` in the repository describes them; their items may
//! change with every version, those five functions and [`Error`] only with a new major one.
#![forbid(unsafe_code)]
// With all features nothing is dead. A face with fewer does without what only the others need.
#![cfg_attr(not(all(feature = "cli", feature = "plot", feature = "proptest")), allow(dead_code, unreachable_pub))]

pub mod certificate;
pub mod claim;
pub mod kernel;
pub mod table_checker;

#[cfg(feature = "engine")]
pub mod algebra;
#[cfg(feature = "report")]
mod api;
#[cfg(feature = "engine")]
pub mod chain;
#[cfg(feature = "cli")]
pub mod cli;
pub mod explain;
#[cfg(feature = "engine")]
pub mod export;
#[cfg(feature = "report")]
pub mod judge;
#[cfg(feature = "engine")]
pub mod number;
#[cfg(feature = "proptest")]
pub mod property;
#[cfg(feature = "engine")]
pub mod prove;
#[cfg(feature = "report")]
pub mod referee;
#[cfg(feature = "engine")]
pub mod refute;
#[cfg(feature = "report")]
pub mod report;
#[cfg(feature = "engine")]
pub mod scene;
#[cfg(feature = "engine")]
pub mod table;

#[cfg(feature = "report")]
pub use api::{Error, audit, check, eval, replay, table};
