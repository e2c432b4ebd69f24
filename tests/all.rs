//! All tests of the library and the program in one binary: it is linked once, and its tests share all cores.
//!
//! A module for each subject: `cargo test --test all corpus` runs the tests whose path contains `corpus`.
#![allow(missing_docs, clippy::unwrap_used)] // a test stops where it fails

#[path = "algebra.rs"]
mod algebra;
#[path = "angles.rs"]
mod angles;
#[path = "architecture.rs"]
mod architecture;
#[path = "bad_inputs.rs"]
mod bad_inputs;
#[path = "bytes.rs"]
mod bytes;
#[path = "catalogue.rs"]
mod catalogue;
#[path = "certificates.rs"]
mod certificates;
#[path = "chain.rs"]
mod chain;
#[path = "check_command.rs"]
mod check_command;
#[path = "claim_language.rs"]
mod claim_language;
#[path = "classroom.rs"]
mod classroom;
#[path = "command_line.rs"]
mod command_line;
#[path = "coq_folder.rs"]
mod coq_folder;
#[path = "coq_proofs.rs"]
mod coq_proofs;
#[path = "corpus.rs"]
mod corpus;
#[path = "counterexamples.rs"]
mod counterexamples;
#[path = "deceptions.rs"]
mod deceptions;
#[path = "definedness.rs"]
mod definedness;
#[path = "dependencies.rs"]
mod dependencies;
#[path = "eval.rs"]
mod eval;
#[path = "explained.rs"]
mod explained;
#[path = "export.rs"]
mod export;
#[path = "false_claims.rs"]
mod false_claims;
#[path = "flags.rs"]
mod flags;
#[path = "forged.rs"]
mod forged;
#[path = "forms.rs"]
mod forms;
#[path = "formulas.rs"]
mod formulas;
#[path = "kernel_marks.rs"]
mod kernel_marks;
#[path = "kernel_rules.rs"]
mod kernel_rules;
#[path = "latex.rs"]
mod latex;
#[path = "law.rs"]
mod law;
#[path = "limits.rs"]
mod limits;
#[path = "measured.rs"]
mod measured;
#[path = "numbers.rs"]
mod numbers;
#[path = "one_verdict.rs"]
mod one_verdict;
#[path = "pictures.rs"]
mod pictures;
#[path = "published.rs"]
mod published;
#[path = "referee.rs"]
mod referee;
#[path = "refutations.rs"]
mod refutations;
#[path = "repair.rs"]
mod repair;
#[path = "replay.rs"]
mod replay;
#[path = "replay_command.rs"]
mod replay_command;
#[path = "report.rs"]
mod report;
#[path = "second_checker.rs"]
mod second_checker;
#[path = "second_paper.rs"]
mod second_paper;
#[path = "soundness.rs"]
mod soundness;
#[path = "stability.rs"]
mod stability;
#[path = "table_certificates.rs"]
mod table_certificates;
#[path = "tables.rs"]
mod tables;
#[path = "teaching.rs"]
mod teaching;
#[path = "verdicts.rs"]
mod verdicts;
