//! Definitions put in place: a claim without `let`.
//!
//! Contract: [`Statement::of`] returns the claim's hypotheses, goal and argument with every `let` expanded
//! ([`Substitution`]), so that the search meets variables, families and sequences only.

use super::substitution::Substitution;
use crate::claim::syntax::*;
pub use crate::claim::walk::{names_in, parts};
use std::collections::BTreeSet;

/// A limit that was reached, with its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limit(pub &'static str);

/// A sequence by recurrence: u(0) and u(k + 1) in terms of k and u(k).
#[derive(Clone, Debug)]
pub struct Sequence {
    /// Its name.
    pub name: String,
    /// u(0).
    pub initial: Expr,
    /// The name k.
    pub index: String,
    /// u(k + 1).
    pub step: Expr,
}

impl Sequence {
    /// The names in its definition, but for its own index.
    pub fn names(&self) -> BTreeSet<String> {
        let mut names = BTreeSet::new();
        names_in(&self.step, &mut names);
        names.remove(&self.index);
        names_in(&self.initial, &mut names);
        names
    }

    /// Whether the step mentions the sequence only by the member before, u(k).
    pub(crate) fn steps_once(&self) -> bool {
        fn fine(e: &Expr, name: &str, index: &str) -> bool {
            if let ExprKind::Apply(function, arguments) = &e.kind
                && function.text == name
            {
                return matches!(arguments.as_slice(), [Expr { kind: ExprKind::Name(k), .. }] if k == index);
            }
            let mut all = true;
            parts(e, &mut |part| all &= fine(part, name, index));
            all
        }
        fine(&self.step, &self.name, &self.index)
    }
}

/// A claim with its definitions expanded.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The claim's name.
    pub name: String,
    /// Variables and families.
    pub bindings: Vec<Binding>,
    /// Sequences.
    pub sequences: Vec<Sequence>,
    /// Hypotheses with their labels.
    pub assumptions: Vec<(Option<String>, Prop)>,
    /// What is to be shown.
    pub goal: Prop,
    /// The argument.
    pub proof: Proof,
    /// Claims it may cite.
    pub using: Vec<String>,
    /// The author's point that satisfies the hypotheses (`sample`).
    pub sample: Vec<(String, Expr)>,
}

type Result<T> = std::result::Result<T, Limit>;

impl Statement {
    /// Whether there are hypotheses.
    pub(crate) fn has_hypotheses(&self) -> bool {
        !self.bindings.is_empty() || !self.assumptions.is_empty()
    }

    /// The statement of a claim.
    pub fn of(claim: &Claim) -> Result<Statement> {
        let mut definitions = Substitution::default();
        let mut out = Statement {
            name: claim.name.text.clone(),
            bindings: Vec::new(),
            sequences: Vec::new(),
            assumptions: Vec::new(),
            goal: claim.goal.clone(),
            proof: Proof::default(),
            using: claim.using.iter().map(|n| n.text.clone()).collect(),
            sample: claim.sample.iter().map(|(n, e)| (n.text.clone(), e.clone())).collect(),
        };
        for item in &claim.items {
            match item {
                Item::Given(bindings) => {
                    for binding in bindings {
                        out.bindings.push(definitions.binding(binding)?);
                    }
                }
                Item::Let { name, parameters, value } => {
                    let value = definitions.expr(value)?;
                    let parameters = parameters.iter().map(|p| p.text.clone()).collect();
                    definitions.define(&name.text, parameters, value);
                }
                Item::Define { name, initial, index, step, .. } => out.sequences.push(Sequence {
                    name: name.text.clone(),
                    initial: definitions.expr(initial)?,
                    index: index.text.clone(),
                    step: definitions.expr(step)?,
                }),
                Item::Assume { label, prop } => {
                    let label = label.as_ref().map(|l| l.text.clone());
                    out.assumptions.push((label, definitions.prop(prop)?));
                }
            }
        }
        out.goal = definitions.prop(&claim.goal)?;
        out.proof = definitions.proof(&claim.proof)?;
        Ok(out)
    }
}
