//! The negation of a claim that is refuted at a rational point.
//!
//! Contract: a lemma says what the kernel's claim at the point ([`refutation::of`]) says; the negation follows by putting the
//! point into the statement. The lemma is computed where it holds nothing but fractions and roots of them; else it is shown
//! by a script from the refutation's steps.

use super::proof::{Found, Open, script};
use super::*;
use crate::certificate::{Certificate, Refutes};
use crate::kernel::refutation;
use crate::kernel::statement::Statement as Read;

/// Variables and members of families with their values.
pub(crate) type Point = Vec<(Expr, Expr)>;

/// What has to be shown so that a claim is false at a point.
///
/// # Errors
/// The point is none of the claim.
pub(crate) fn at(claim: &Claim, point: &Point) -> std::result::Result<Claim, crate::kernel::Refusal> {
    refutation::of(claim, &Refutes { point: point.clone(), undefined: None })
}

/// The negation of a claim in Coq, and how it is proved.
pub(crate) struct Negation {
    /// The lemma that says what holds at the point, as text with its proof.
    pub lemma: String,
    /// The proof of the negation.
    pub script: String,
}

/// Whether the claim at the point can be computed: no certificate of it is needed.
///
/// # Errors
/// The point is none of the claim.
pub(crate) fn is_computed(claim: &Claim, point: &Point) -> Found<bool> {
    Ok(prop_is_computed(&at(claim, point)?.goal))
}

fn prop_is_computed(p: &Prop) -> bool {
    match &p.kind {
        PropKind::Compare(sides, _) => sides.iter().all(expr_is_computed),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().all(prop_is_computed),
        PropKind::Not(inner) => prop_is_computed(inner),
        PropKind::Implies(a, b) => prop_is_computed(a) && prop_is_computed(b),
        PropKind::Exists(..)
        | PropKind::ForAll(..)
        | PropKind::Extremum(_)
        | PropKind::Limit(_)
        | PropKind::WrittenLimit(_) => false,
    }
}

fn expr_is_computed(e: &Expr) -> bool {
    let fits = match &e.kind {
        ExprKind::Derivative(..) => false,
        ExprKind::Apply(f, _) => {
            !["exp", "ln", "arcsin", "arccos", "arctan", "cosh", "sinh", "tanh", "sech"].contains(&f.text.as_str())
        }
        // What is no root is natural, or refused where the statement is printed.
        ExprKind::Power(_, exponent) => {
            definedness::numerals(exponent).is_ok_and(|known| known.is_none_or(|known| known.is_whole))
        }
        _ => true,
    };
    let mut all = fits;
    expand::parts(e, &mut |part| all &= expr_is_computed(part));
    all
}

/// The negation of a claim at a point; `certificate` shows the claim at the point and is needed unless that
/// [`is_computed`].
///
/// # Errors
/// Why there is none.
pub(crate) fn proof(claim: &Claim, point: &Point, certificate: Option<&Certificate>) -> Found<Negation> {
    let mut there = at(claim, point)?;
    if certificate.is_none() {
        with_domains(&mut there, claim)?;
    }
    let name = format!("{}_at", identifier(&claim.name.text));
    let stated = statement(&there)?;
    let shown = match certificate {
        None => "  computed.".to_string(),
        Some(certificate) => {
            let shown = script(&there, certificate, &[], &|_| None)?;
            format!("{}\n  finish {}.", shown.text, shown.shown)
        }
    };
    let lemma = format!("Lemma {name} :\n{}.\nProof.\n{shown}\nQed.\n", stated.full);
    let mut text = format!("  cbv beta zeta. intro z. assert (w := {name}). cbv beta zeta in w.\n");
    let mut put = |hypothesis: &str, items: &[Item]| -> Found<()> {
        for item in items {
            match item {
                Item::Given(bindings) => {
                    for value in bindings.iter().flat_map(|b| values(b, point)) {
                        text += &format!("  put {hypothesis} {value}.\n");
                    }
                }
                Item::Define { name, .. } => {
                    return Err(Open::Untranslated(name.text.clone(), "a sequence at a point"));
                }
                Item::Let { .. } | Item::Assume { .. } => {}
            }
        }
        text += &format!("  premises_at {hypothesis}.\n");
        Ok(())
    };
    put("w", &there.items)?;
    put("z", &claim.items)?;
    let mut goal = &claim.goal;
    while let PropKind::ForAll(bindings, body) = &goal.kind {
        put("z", &[Item::Given(bindings.clone())])?;
        goal = body;
    }
    if let PropKind::Extremum(_) = &goal.kind {
        return Err(Open::Untranslated("goal".to_string(), "an extremum at a point"));
    }
    text += "  contrary w z.";
    Ok(Negation { lemma, script: text })
}

/// Gives the variables of the claim at a point their domains again, without which Coq's words do not say a root: where the
/// point is put in, they are shown.
fn with_domains(there: &mut Claim, claim: &Claim) -> Found<()> {
    let read = Read::of(claim)?;
    let (mut bindings, mut goal) = (read.bindings, &read.goal);
    while let PropKind::ForAll(list, body) = &goal.kind {
        bindings.extend(list.iter().cloned());
        goal = body;
    }
    for item in &mut there.items {
        let Item::Given(list) = item else { continue };
        for binding in list.iter_mut().filter(|b| b.constraints.is_empty()) {
            let names = |b: &Binding| b.names.iter().map(|n| n.0.text.clone()).collect::<Vec<_>>();
            let same = bindings.iter().find(|b| names(binding).iter().all(|n| names(b).contains(n)));
            binding.constraints = same.map(|b| b.constraints.clone()).unwrap_or_default();
        }
    }
    Ok(())
}

/// What the names of a binding are at a point, for Coq; a name that the point leaves open is 1.
fn values(binding: &Binding, point: &Point) -> Vec<String> {
    let of = |wanted: &dyn Fn(&ExprKind) -> bool| point.iter().find(|p| wanted(&p.0.kind)).map(|p| &p.1);
    let real = |value: Option<&Expr>| value.map_or("1".to_string(), number);
    let one = |(name, index): &(Name, Option<Name>)| match index {
        None => {
            let value = of(&|kind| matches!(kind, ExprKind::Name(text) if *text == name.text));
            if binding.natural { format!("{}%nat", real(value)) } else { real(value) }
        }
        Some(_) => {
            let members: Vec<(String, String)> = point
                .iter()
                .filter_map(|(place, value)| match (&place.kind, number(value)) {
                    (ExprKind::Apply(f, list), value) if f.text == name.text => Some((number(list.first()?), value)),
                    _ => None,
                })
                .collect();
            let other = members.first().map_or("1".to_string(), |m| m.1.clone());
            let cases: String = members.iter().map(|(k, v)| format!("| {k}%nat => {v} ")).collect();
            format!("(fun k : nat => match k with {cases}| _ => {other} end)")
        }
    };
    binding.names.iter().map(one).collect()
}

/// A rational number, for Coq.
fn number(e: &Expr) -> String {
    match &e.kind {
        ExprKind::Number(text) => text.clone(),
        ExprKind::Negate(inner) => format!("(- {})", number(inner)),
        ExprKind::Product(list) => match list.as_slice() {
            [(_, p), (Factor::Over, q)] => format!("({} / {})", number(p), number(q)),
            _ => "0".to_string(),
        },
        _ => "0".to_string(),
    }
}
