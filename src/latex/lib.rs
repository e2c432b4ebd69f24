//! A paper's own LaTeX as a claim file.
//!
//! Contract: each displayed equation becomes a claim of the claim language, or is refused with the reason; nothing is guessed. The
//! clauses of the language stand in comments, `%carom given m_1 > 0`, with the paper's names. The reader of the claim language
//! checks names and shapes, and every place in its trees and messages is a place in the document.
//! Limits: the size of a file, tokens, macros, nesting; each has a name.
#![forbid(unsafe_code)]

mod atom;
mod binding;
mod clause;
mod comment;
mod comparison;
mod derivative;
mod document;
mod domain;
mod expression;
mod form;
mod function;
mod index;
mod input;
mod integral;
mod macros;
mod markdown;
mod measured;
mod name;
mod number;
mod offered;
mod outcome;
mod paper;
mod phrase;
mod piece;
mod place;
mod prepare;
mod refusal;
mod remark;
mod row;
mod scope;
mod script;
mod statement;
mod structure;
mod symbol;
mod token;
mod typeset;
mod unit;
mod vector;
mod whole;

pub use input::{DEPTH_LIMIT, INPUTS_LIMIT, Manuscript, is_paper, manuscript};
pub use markdown::latex_of;
pub use outcome::{Equation, Outcome, Paper, Wanted};
pub use paper::{paper, paper_of};
pub use token::FILE_LIMIT;
