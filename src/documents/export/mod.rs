//! Statements in the languages of other provers: what they prove is then what the audit says.
//!
//! Contract: an exported statement is equivalent to the claim's, hypotheses included, or the export
//! is refused with the reason. A printer over the syntax tree, no reasoning.

pub mod coq;
mod kinds;
mod positive;
pub mod smt2;
pub mod values;

use crate::claim::syntax::{Claim, Span};
use crate::kernel::substitution::Obstacle;
use crate::refute::expand::Limit;

/// Why a claim cannot be said in the other language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsupported {
    /// The construct, and what is missing for it.
    pub reason: String,
    /// Where it stands.
    pub span: Span,
    /// Whether it is a limit of this program, and the language could say it.
    pub limit: bool,
}

impl Unsupported {
    /// A limit that was reached.
    fn limit(name: &str, span: Span) -> Unsupported {
        Unsupported { reason: format!("limit reached: {name}"), span, limit: true }
    }

    /// A value that cannot be put in place.
    fn not_put_in(obstacle: Obstacle, span: Span) -> Unsupported {
        Unsupported::limit(Limit::from(obstacle).0, span)
    }
}

/// What has to hold for every expression in a claim's sequences and goal to have a value: the conditions that both
/// exports write, but for those that hold by their form.
///
/// # Errors
/// The limit that the definitions, put in place, or an exponent reach.
pub fn conditions(claim: &Claim) -> Result<Vec<values::Condition>> {
    let statement =
        crate::refute::expand::Statement::of(claim).map_err(|limit| Unsupported::limit(limit.0, claim.name.span))?;
    let positive = positive::Positive::of_claim(claim);
    values::of_statement(&statement, &kinds::of_claim(claim), &positive)
}

type Result<T> = std::result::Result<T, Unsupported>;

fn unsupported<T>(span: Span, reason: impl Into<String>) -> Result<T> {
    Err(Unsupported { reason: reason.into(), span, limit: false })
}
