//! All tests of the library and the program in one binary: it is linked once, and its tests share all cores.
//!
//! A module for each subject: `cargo test --test all corpus` runs the tests whose path contains `corpus`.
#![allow(missing_docs, clippy::unwrap_used)] // a test stops where it fails

mod algebra;
mod angles;
mod architecture;
mod bad_inputs;
mod bytes;
mod catalogue;
mod certificates;
mod chain;
mod check_command;
mod claim_language;
mod classroom;
mod command_line;
mod coq_folder;
mod coq_proofs;
mod corpus;
mod counterexamples;
mod deceptions;
mod definedness;
mod dependencies;
mod eval;
mod explained;
mod export;
mod false_claims;
mod flags;
mod forged;
mod forms;
mod formulas;
mod kernel_marks;
mod kernel_rules;
mod latex;
mod law;
mod limits;
mod marks;
mod measured;
mod numbers;
mod one_verdict;
mod pictures;
mod published;
mod referee;
mod refutations;
mod repair;
mod replay;
mod replay_command;
mod report;
mod second_checker;
mod second_paper;
mod soundness;
mod stability;
mod support;
mod table_certificates;
mod tables;
mod teaching;
mod verdicts;
