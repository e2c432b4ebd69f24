//! Definitions put in place: a claim without `let`, its argument included.
//!
//! Contract: [`Statement::of`] returns what the kernel understood of the claim, and the argument with every `let` put in
//! place by the same substitution, so that the search meets variables, families and sequences only.

use crate::claim::syntax::*;
pub use crate::claim::walk::{names_in, parts};
use crate::kernel::statement::{self, Sequence};
use crate::kernel::substitution::{Obstacle, Substitution};
use crate::kernel::{Reason, Refusal};

/// A limit that was reached, with its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limit(pub &'static str);

/// Said where a substitution is refused.
const BOUND: &str = "a value put in where a name is bound";

/// The same where it is that of a derivative or limit.
const MOVES: &str = "a value, or what depends on it, put in for the variable of a derivative or limit";

impl From<Refusal> for Limit {
    fn from(refusal: Refusal) -> Limit {
        match refusal {
            Refusal::Limit(name) => Limit(name),
            Refusal::Rejected(Reason::Moves(_)) => Limit(MOVES),
            Refusal::Rejected(_) => Limit(BOUND),
        }
    }
}

impl From<Obstacle> for Limit {
    fn from(obstacle: Obstacle) -> Limit {
        Refusal::from(obstacle).into()
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

    /// Whether it declares this name.
    pub(crate) fn declares(&self, name: &str) -> bool {
        statement::declares(&self.bindings, &self.sequences, name)
    }

    /// The statement of a claim.
    pub fn of(claim: &Claim) -> Result<Statement> {
        let (understood, lets) = statement::Statement::with_lets(claim)?;
        let labels = claim.items.iter().filter_map(|item| match item {
            Item::Assume { label, .. } => Some(label.as_ref().map(|l| l.text.clone())),
            _ => None,
        });
        Ok(Statement {
            name: understood.name,
            bindings: understood.bindings,
            sequences: understood.sequences,
            assumptions: labels.zip(understood.assumptions).collect(),
            goal: understood.goal,
            proof: argument(&claim.proof, &lets)?,
            using: claim.using.iter().map(|n| n.text.clone()).collect(),
            sample: claim.sample.iter().map(|(n, e)| (n.text.clone(), e.clone())).collect(),
        })
    }
}

/// An argument with definitions put in place.
fn argument(proof: &Proof, lets: &Substitution) -> Result<Proof> {
    let step = |step: &Step| {
        Ok(match step {
            Step::Have { label, prop, proof } => {
                Step::Have { label: label.clone(), prop: lets.prop(prop)?, proof: argument(proof, lets)? }
            }
            Step::Obtain { binding, label, prop, witness } => Step::Obtain {
                binding: lets.binding(binding)?,
                label: label.clone(),
                prop: lets.prop(prop)?,
                witness: lets.expr(witness)?,
            },
            Step::Case { label, prop, proof } => {
                Step::Case { label: label.clone(), prop: lets.prop(prop)?, proof: argument(proof, lets)? }
            }
        })
    };
    Ok(Proof {
        steps: proof.steps.iter().map(step).collect::<Result<_>>()?,
        close: proof.close.as_ref().map(|method| by(method, lets)).transpose()?,
    })
}

/// A method with definitions put in place.
fn by(method: &Method, lets: &Substitution) -> Result<Method> {
    let values = |list: &[(Name, Expr)]| -> Result<Vec<(Name, Expr)>> {
        list.iter().map(|(n, e)| Ok((n.clone(), lets.expr(e)?))).collect()
    };
    Ok(match method {
        Method::Algebra(facts) => Method::Algebra(facts.clone()),
        Method::Induction(name, step) => Method::Induction(name.clone(), Box::new(argument(step, lets)?)),
        Method::Instance { claim, with } => Method::Instance { claim: claim.clone(), with: values(with)? },
        Method::Witness(list) => Method::Witness(values(list)?),
        Method::Power { fact, exponent } => Method::Power { fact: fact.clone(), exponent: lets.expr(exponent)? },
        Method::Product(list) => {
            let factor = |(n, e): &(Name, Option<Expr>)| -> Result<(Name, Option<Expr>)> {
                Ok((n.clone(), e.as_ref().map(|e| lets.expr(e)).transpose()?))
            };
            Method::Product(list.iter().map(factor).collect::<Result<_>>()?)
        }
        Method::Mean { a, b, weight } => {
            Method::Mean { a: lets.expr(a)?, b: lets.expr(b)?, weight: lets.expr(weight)? }
        }
        Method::Hoelder { first, second, weight } => Method::Hoelder {
            first: (lets.expr(&first.0)?, lets.expr(&first.1)?),
            second: (lets.expr(&second.0)?, lets.expr(&second.1)?),
            weight: lets.expr(weight)?,
        },
        Method::Squeeze { lower, upper } => Method::Squeeze { lower: lets.expr(lower)?, upper: lets.expr(upper)? },
    })
}
