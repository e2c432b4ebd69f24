//! Carom audits the algebra of one-dimensional chain collisions and computes with it exactly.
//!
//! A claim file states an equation of a paper with its hypotheses. The prover shows it for all values
//! that the hypotheses allow, or finds an exact point where it fails, or says what is missing.
//!
//! ```
//! use carom::claim::parse::parse;
//! use carom::prove::catalogue::{Catalogue, Limits};
//!
//! let claims = parse("claim half \"Half\"\ngiven x > 0\nprove x/(2*x) = 1/2\n").unwrap();
//! let mut catalogue = Catalogue::new(claims).unwrap();
//! let outcome = catalogue.audit("half", &Limits::default()).unwrap();
//! assert_eq!(outcome.verdict.name(), "proved");
//! ```
#![forbid(unsafe_code)]

pub mod certificate;
pub mod certificate2;
pub mod claim;
pub mod kernel;
pub mod kernel2;

#[cfg(feature = "engine")]
pub mod algebra;
#[cfg(feature = "engine")]
pub mod certify;
#[cfg(feature = "engine")]
pub mod chain;
#[cfg(feature = "cli")]
pub mod cli;
pub mod elaborate;
#[cfg(feature = "engine")]
pub mod export;
#[cfg(feature = "engine")]
pub mod number;
#[cfg(feature = "proptest")]
pub mod property;
#[cfg(feature = "engine")]
pub mod prove;
#[cfg(feature = "report")]
pub mod report;
#[cfg(feature = "engine")]
pub mod scene;
#[cfg(feature = "engine")]
pub mod table;
