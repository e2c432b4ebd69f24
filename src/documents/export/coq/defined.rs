//! The second theorem: every expression of a claim has a value.
//!
//! Contract: [`companion`] is a claim with the same declarations and hypotheses, whose goal says what
//! [`super::Statement::defined`] says but for what is positive by its form and for derivatives' being there. A
//! certificate of it becomes the script of the second theorem by [`proof()`]; Coq finds the rest itself (`valued` in
//! `proofs/coq/values.v`).

use super::proof::{Found, Script, script};
use super::*;
use crate::certificate::Certificate;
use crate::kernel::statement::{Statement as Read, compare, numeral, prop, sum};
use crate::kernel::{Accepted, key};

/// The statement that every expression of a claim has a value; `None` if that is obvious.
///
/// # Errors
/// The claim makes no sense to the kernel.
pub(crate) fn companion(claim: &Claim) -> Found<Option<Claim>> {
    let read = Read::of(claim)?;
    let (kinds, positive) = (of_claim(claim), Positive::of_claim(claim));
    let mut needs = Collector::new(&kinds, &positive);
    for u in &read.sequences {
        needs.sequence(&u.initial, &u.index, &u.step)?;
    }
    needs.prop(&read.goal)?;
    if needs.found.is_empty() {
        return Ok(None);
    }
    let mut goals: Vec<Prop> = Vec::new();
    for condition in needs.found.iter().filter(|c| !is_by_form(c, &kinds, &positive)) {
        let Some(goal) = said(condition) else { continue };
        if !goals.iter().any(|other| key::prop(other) == key::prop(&goal)) {
            goals.push(goal);
        }
    }
    let goal = match (goals.len(), goals.pop()) {
        (_, None) => compare(numeral(0), Relation::Equal, numeral(0)),
        (1, Some(only)) => only,
        (_, last) => prop(PropKind::And(goals.into_iter().chain(last).collect())),
    };
    let sequences = read.sequences.iter().map(|u| Item::Define {
        name: Name::new(&u.name),
        initial: u.initial.clone(),
        index: Name::new(&u.index),
        step: u.step.clone(),
        span: Span::default(),
    });
    let supposed = read.assumptions.iter().map(|prop| Item::Assume { label: None, prop: prop.clone() });
    Ok(Some(Claim {
        items: [Item::Given(read.bindings.clone())].into_iter().chain(sequences).chain(supposed).collect(),
        goal,
        proof: Proof::default(),
        expect: Expectation::Proved,
        ..claim.clone()
    }))
}

/// Whether a condition holds because an expression is positive by its form.
fn is_by_form(condition: &Condition, kinds: &Kinds, positive: &Positive) -> bool {
    let (mut kinds, mut positive) = (kinds.clone(), positive.clone());
    for guard in &condition.guards {
        match guard {
            Guard::Bindings(bindings) => {
                bind(bindings, &mut kinds);
                positive.declare(bindings);
            }
            Guard::Index(Index { name, .. }) | Guard::Natural(name) => {
                kinds.insert(name.text.clone(), Kind::Natural);
            }
        }
    }
    match &condition.need {
        Need::NotZero(e) | Need::Positive(e) | Need::NotNegative(e) | Need::NotZeroOrNatural(e, _) => {
            positive.holds(e, &kinds)
        }
        Need::Range(..) | Need::Differentiable(..) => false,
    }
}

/// A condition in words of the claim language; `None` for a derivative's being there.
fn said(condition: &Condition) -> Option<Prop> {
    let zero = || numeral(0);
    let need = match &condition.need {
        Need::NotZero(e) => compare(e.clone(), Relation::NotEqual, zero()),
        Need::Positive(e) => compare(e.clone(), Relation::Greater, zero()),
        Need::NotNegative(e) => compare(zero(), Relation::LessEqual, e.clone()),
        Need::NotZeroOrNatural(base, exponent) => prop(PropKind::Or(vec![
            compare(base.clone(), Relation::NotEqual, zero()),
            compare(zero(), Relation::LessEqual, exponent.clone()),
        ])),
        Need::Range(from, to) => {
            let end = sum(vec![(Sign::Plus, to.clone()), (Sign::Plus, numeral(1))]);
            compare(from.clone(), Relation::LessEqual, end)
        }
        Need::Differentiable(..) => return None,
    };
    let natural = |name: &Name, constraints: Vec<Constraint>| Binding::of(name.clone(), true, constraints);
    Some(condition.guards.iter().rev().fold(need, |body, guard| {
        let bindings = match guard {
            Guard::Bindings(list) => list.clone(),
            Guard::Index(index) => {
                let range = Constraint::Range((*index.from).clone(), (*index.to).clone());
                vec![natural(&index.name, vec![range])]
            }
            Guard::Natural(name) => vec![natural(name, Vec::new())],
        };
        prop(PropKind::ForAll(bindings, Box::new(body)))
    }))
}

/// The script of the second theorem, from a certificate of the [`companion`].
///
/// # Errors
/// Why there is none.
pub(crate) fn proof(
    companion: &Claim,
    certificate: &Certificate,
    cited: &[&Accepted],
    claims: &dyn Fn(&str) -> Option<Claim>,
) -> Found<Script> {
    let mut made = script(companion, certificate, cited, claims)?;
    made.text += &format!("\n  valued {}.", made.shown);
    Ok(made)
}
