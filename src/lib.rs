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

mod api;

pub use api::{Error, audit, check, eval, replay, table};
pub use carom_checker::{certificate, kernel, table_checker};
pub use carom_documents::{export, report};
pub use carom_exact::{algebra, number};
pub use carom_latex as latex;
pub use carom_physics::{chain, referee, scene, table};
pub use carom_property as property;
pub use carom_search::{explain, judge, prove, refute};

/// The claim language: reading, checking and printing claim files, and those that come with the program.
pub mod claim {
    pub use carom_catalogue as embedded;
    pub use carom_checker::claim::*;

    /// The description of the language, for `carom help language`.
    pub const LANGUAGE: &str = include_str!("../docs/language.md");
}
