//! Statements for Coq, over its real numbers and with Coquelicot's derivatives and limits.
//!
//! Contract: the text of [`Statement::full`] is a closed proposition over the words of
//! `proofs/coq/vocabulary.v` that says what the claim says: reals are `R`, naturals `nat` (with
//! `INR` where they stand among reals), families and sequences `nat -> R`, a `let` of the claim a
//! `let` of Coq. A power with a natural exponent is `pow`, with the exponent 1/2 `sqrt`, any other `Rpower`,
//! exp (y ln x), which is the claim's power where the base is positive. Coq's functions are total; that divisors are not 0,
//! bases positive and so on is the second statement, [`Statement::defined`], with the same hypotheses.
//! A hypothesis that divides comes with its divisors' being other than 0, as the language has it.
//!
//! Refused, with the reason: families on a part of the naturals, matrices among functions' values,
//! bounds of a sum that are not natural by their form, determinants beyond two rows.

pub(crate) mod defined;
mod expressions;
mod layout;
mod page;
mod printer;
pub mod proof;
mod propositions;
pub(crate) mod refuted;
mod words;

pub use page::{BY_HAND, definitions, proved_in, theorems};
pub use words::identifier;

use super::kinds::{Kind, Kinds, bind, is_natural, of_claim};
use super::positive::Positive;
use super::values::{self, Collector, Condition, Guard};
use super::{Result, Unsupported};
use crate::claim::definedness::{self, Need};
use crate::claim::syntax::*;
use crate::refute::expand;
use crate::{certificate, kernel};
use expressions::is_root;
use layout::{laid_out, without_unused};
use printer::{AND, ATOM, Printer, at};
use std::collections::BTreeSet;

/// A claim's statement for Coq.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The claim's name as an identifier.
    pub name: String,
    /// The proposition; of a claim expected to be refuted, its negation.
    pub full: String,
    /// That every expression has a value under the hypotheses; `None` if that is plain.
    pub defined: Option<String>,
    /// How many variables and hypotheses come before what is claimed.
    pub premises: usize,
    /// SHA-256 of the claim's statement as the kernel of certificates reads it, in hexadecimal digits: one
    /// digest stands in the certificate, beside the Coq statement and in the table of claims.
    pub digest: String,
}

impl Statement {
    /// The statement and, if there is one, that its expressions have values, each with its name.
    pub fn propositions(&self) -> Vec<(String, &str)> {
        let defined = self.defined.as_ref().map(|text| (format!("{}_defined", self.name), text.as_str()));
        std::iter::once((self.name.clone(), self.full.as_str())).chain(defined).collect()
    }
}

/// The statement of a claim.
///
/// # Errors
/// The construct that the language cannot express, with its place.
pub fn statement(claim: &Claim) -> Result<Statement> {
    let expanded = expand::Statement::of(claim).map_err(|limit| Unsupported::limit(limit.0, claim.name.span))?;
    let mut printer = printer(claim, &expanded)?;
    let mut full = declared(&mut printer, claim, &expanded)?;
    let (mut bare, premises) = in_place(&mut printer, &expanded)?;
    full.push(match &claim.goal.kind {
        PropKind::And(list) => printer.props(list, " /\\\n", AND)?,
        _ => printer.prop(&claim.goal)?.0,
    });
    let full = without_unused(full);
    let needs = values::of_statement(&expanded, &printer.kinds, &printer.positive)?;
    let needs = printer.conditions(&needs)?;
    let refuted = claim.expect == Expectation::Refuted;
    let defined = (!needs.is_empty() && !refuted).then(|| {
        bare.push(needs.join(" /\\\n"));
        laid_out(&bare)
    });
    let full = if refuted { format!("  ~ (\n{})", laid_out(&full)) } else { laid_out(&full) };
    let read = kernel::statement::Statement::of(claim).map_err(|_| Unsupported::limit("size", claim.name.span))?;
    let digest = certificate::text::digest(&read.text());
    Ok(Statement { name: identifier(&claim.name.text), full, defined, premises, digest })
}

/// The printer of a claim, which knows what restricts its variables, and its definitions.
fn printer(claim: &Claim, expanded: &expand::Statement) -> Result<Printer> {
    let mut printer = Printer::of_claim(claim);
    for (_, prop) in &expanded.assumptions {
        let text = printer.prop(prop)?.0;
        printer.tied.push(text);
    }
    for binding in &expanded.bindings {
        let from_below =
            |c: &Constraint| matches!(c, Constraint::Relation(Relation::Greater | Relation::GreaterEqual, _));
        if !binding.constraints.iter().all(from_below) {
            let text = printer.binders(binding)?;
            printer.tied.push(text);
        }
    }
    for item in &claim.items {
        if let Item::Let { name, parameters, value } = item {
            let value = printer.in_place(value)?;
            if printer.powers_depend_on(&name.text, parameters, &value) {
                printer.in_place_only.insert(name.text.clone());
            }
            let parameters = parameters.iter().map(|p| p.text.clone()).collect();
            printer.definitions.define(&name.text, parameters, value);
        }
    }
    Ok(printer)
}

/// The text before the goal: variables, definitions and hypotheses in the order of the claim.
fn declared(printer: &mut Printer, claim: &Claim, expanded: &expand::Statement) -> Result<Vec<String>> {
    let mut assumptions = expanded.assumptions.iter();
    let mut out = Vec::new();
    for item in &claim.items {
        match item {
            Item::Given(bindings) => {
                for binding in bindings {
                    out.push(printer.given(binding)?);
                }
            }
            Item::Let { name, .. } if printer.in_place_only.contains(&name.text) => {}
            Item::Let { name, parameters, value } => out.push(printer.definition(name, parameters, value)?),
            Item::Define { name, initial, index, step, .. } => {
                out.push(printer.sequence(&name.text, initial, &index.text, step)?);
            }
            Item::Assume { prop, .. } => out.extend(hypothesis(printer, prop, assumptions.next().map(|a| &a.1))?),
        }
    }
    Ok(out)
}

/// The same with the definitions put in place, and how many variables and hypotheses these are.
fn in_place(printer: &mut Printer, expanded: &expand::Statement) -> Result<(Vec<String>, usize)> {
    let (mut out, mut premises) = (Vec::new(), 0);
    for binding in &expanded.bindings {
        premises += binding.names.len() * (1 + binding.constraints.len());
        out.push(printer.given(binding)?);
    }
    for sequence in &expanded.sequences {
        premises += 3;
        out.push(printer.sequence(&sequence.name, &sequence.initial, &sequence.index, &sequence.step)?);
    }
    for (_, prop) in &expanded.assumptions {
        let said = hypothesis(printer, prop, Some(prop))?;
        premises += said.len();
        out.extend(said);
    }
    Ok((out, premises))
}

/// A hypothesis, behind that its divisors, which are those of its expanded form, are not 0.
fn hypothesis(printer: &mut Printer, prop: &Prop, expanded: Option<&Prop>) -> Result<Vec<String>> {
    let mut divisors = Collector::new(&printer.kinds, &printer.positive);
    if let Some(prop) = expanded {
        divisors.prop(prop)?;
    }
    divisors.found.retain(|c| !printer.plain(c));
    let mut out = printer.conditions(&divisors.found)?;
    out.push(printer.prop_at(prop, 80)?);
    Ok(out.into_iter().map(|premise| format!("{premise} ->")).collect())
}
