//! Carom audits the algebra of one-dimensional chain collisions and computes with it exactly.
//!
//! A claim file states an equation of a paper with its hypotheses. A search finds a proof for all values that the
//! hypotheses allow, which a small kernel then checks; or an exact point where the claim fails; or it says what is missing.
//!
//! ```
//! use carom::claim::parse::parse;
//! use carom::judge::{Settings, hand::AtHand, one_of};
//! use carom::prove::catalogue::Catalogue;
//!
//! let claims = parse("claim half \"Half\"\ngiven x > 0\nprove x/(2*x) = 1/2\n").unwrap();
//! let catalogue = Catalogue::new(claims).unwrap();
//! let entry = one_of(&catalogue, "half", &AtHand::default(), &Settings::default()).unwrap();
//! assert_eq!(entry.outcome.verdict.name(), "proved");
//! assert!(entry.proof.unwrap().certificate.starts_with("carom-certificate 1"));
//! ```
#![forbid(unsafe_code)]

pub mod certificate;
pub mod certificate2;
pub mod claim;
pub mod kernel;
pub mod kernel2;
pub mod table_checker;

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
#[cfg(feature = "report")]
pub mod judge;
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
