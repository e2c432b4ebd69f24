//! All tests of the library and the program in one binary: it is linked once, and its tests share all cores.
//!
//! A module for each subject: `cargo test --test all corpus` runs the tests whose path contains `corpus`.
//! `tests/kernel_alone.rs` is apart, because it builds the kernel without the rest of the crate.
#![allow(missing_docs, clippy::unwrap_used)] // a test stops where it fails

#[cfg(feature = "cli")]
#[path = "algebra.rs"]
mod algebra;
#[cfg(feature = "cli")]
#[path = "angles.rs"]
mod angles;
#[cfg(feature = "cli")]
#[path = "bad_inputs.rs"]
mod bad_inputs;
#[cfg(feature = "cli")]
#[path = "bytes.rs"]
mod bytes;
#[cfg(feature = "cli")]
#[path = "catalogue.rs"]
mod catalogue;
#[cfg(feature = "cli")]
#[path = "certificates.rs"]
mod certificates;
#[cfg(feature = "cli")]
#[path = "chain.rs"]
mod chain;
#[cfg(feature = "cli")]
#[path = "check_command.rs"]
mod check_command;
#[cfg(feature = "cli")]
#[path = "claim_language.rs"]
mod claim_language;
#[cfg(feature = "cli")]
#[path = "classroom.rs"]
mod classroom;
#[cfg(feature = "cli")]
#[path = "command_line.rs"]
mod command_line;
#[cfg(feature = "cli")]
#[path = "coq_folder.rs"]
mod coq_folder;
#[cfg(feature = "cli")]
#[path = "coq_proofs.rs"]
mod coq_proofs;
#[cfg(feature = "cli")]
#[path = "corpus.rs"]
mod corpus;
#[cfg(feature = "cli")]
#[path = "deceptions.rs"]
mod deceptions;
#[cfg(feature = "cli")]
#[path = "definedness.rs"]
mod definedness;
#[cfg(feature = "cli")]
#[path = "dependencies.rs"]
mod dependencies;
#[cfg(feature = "cli")]
#[path = "eval.rs"]
mod eval;
#[cfg(feature = "cli")]
#[path = "explained.rs"]
mod explained;
#[cfg(feature = "cli")]
#[path = "export.rs"]
mod export;
#[cfg(feature = "cli")]
#[path = "false_claims.rs"]
mod false_claims;
#[cfg(feature = "cli")]
#[path = "flags.rs"]
mod flags;
#[cfg(feature = "cli")]
#[path = "forms.rs"]
mod forms;
#[cfg(feature = "cli")]
#[path = "formulas.rs"]
mod formulas;
#[path = "kernel_rules.rs"]
mod kernel_rules;
#[cfg(feature = "cli")]
#[path = "law.rs"]
mod law;
#[cfg(feature = "cli")]
#[path = "limits.rs"]
mod limits;
#[cfg(feature = "cli")]
#[path = "measured.rs"]
mod measured;
#[cfg(feature = "cli")]
#[path = "numbers.rs"]
mod numbers;
#[cfg(feature = "cli")]
#[path = "pictures.rs"]
mod pictures;
#[cfg(feature = "cli")]
#[path = "published.rs"]
mod published;
#[cfg(feature = "cli")]
#[path = "referee.rs"]
mod referee;
#[cfg(feature = "cli")]
#[path = "refutations.rs"]
mod refutations;
#[cfg(feature = "cli")]
#[path = "repair.rs"]
mod repair;
#[cfg(feature = "cli")]
#[path = "replay.rs"]
mod replay;
#[cfg(feature = "cli")]
#[path = "replay_command.rs"]
mod replay_command;
#[cfg(feature = "cli")]
#[path = "report.rs"]
mod report;
#[path = "second_checker.rs"]
mod second_checker;
#[cfg(feature = "cli")]
#[path = "second_paper.rs"]
mod second_paper;
#[cfg(feature = "cli")]
#[path = "soundness.rs"]
mod soundness;
#[cfg(feature = "cli")]
#[path = "stability.rs"]
mod stability;
#[cfg(feature = "cli")]
#[path = "table_certificates.rs"]
mod table_certificates;
#[cfg(feature = "cli")]
#[path = "tables.rs"]
mod tables;
#[cfg(feature = "cli")]
#[path = "teaching.rs"]
mod teaching;
#[cfg(feature = "cli")]
#[path = "verdicts.rs"]
mod verdicts;
