//! Hypotheses that hold somewhere, shown by a certificate where no point with rational coordinates was found.
//!
//! Contract: a point is returned only where the kernel accepted that such values exist: `exists x …: hypotheses`.

use crate::certificate::{Certificate, Rule, Step};
use crate::claim::print;
use crate::claim::syntax::{Claim, Proof, PropKind};
use crate::kernel::statement::{Statement, prop};
use crate::prove;
use crate::refute::catalogue::Limits;
use crate::refute::outcome::Point;

/// A point at which the hypotheses of a claim hold, its coordinates perhaps roots; `None` where none was shown to exist.
pub fn point(claim: &Claim, limits: &Limits) -> Option<Point> {
    let certificate = prove::certificate(&existence(claim)?, &[], limits).ok()?.0;
    witness(&certificate)
}

/// The claim that values exist for which the hypotheses of another hold.
fn existence(claim: &Claim) -> Option<Claim> {
    let Statement { bindings, sequences, assumptions, .. } = Statement::of(claim).ok()?;
    if bindings.is_empty() || assumptions.is_empty() || !sequences.is_empty() {
        return None;
    }
    let body = match assumptions.as_slice() {
        [only] => only.clone(),
        _ => prop(PropKind::And(assumptions)),
    };
    let goal = prop(PropKind::Exists(bindings, Box::new(body)));
    Some(Claim {
        using: Vec::new(),
        items: Vec::new(),
        sample: Vec::new(),
        proof: Proof::default(),
        goal,
        ..claim.clone()
    })
}

/// The values of the last witness.
fn witness(certificate: &Certificate) -> Option<Point> {
    certificate.steps.iter().rev().filter_map(Step::show).find_map(|show| match &show.rule {
        Rule::Witness { with, .. } => {
            let values = with.iter().map(|(n, value)| (n.text.clone(), print::expr(value)));
            Some(Point { values: values.collect() })
        }
        _ => None,
    })
}
