//! The statement of a claim with its definitions put in place.
//!
//! Contract: [`Statement::of`] puts every `let` in place by [`super::substitution`], in the order written. A binding says of each of
//! its names what [`constraints`] says.

use super::names::{names_in, names_in_binding, names_in_prop};
use super::substitution::{Room, Substitution};
use super::tree::parts;
use super::{Refusal, text};
use crate::claim::syntax::*;
use std::collections::BTreeSet;

/// A sequence u by u(0) and u(k + 1).
#[derive(Clone, Debug)]
pub struct Sequence {
    /// Its name u.
    pub name: String,
    /// u(0).
    pub initial: Expr,
    /// The name k.
    pub index: String,
    /// u(k + 1) in terms of k and u(k).
    pub step: Expr,
}

/// What a claim says.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The claim's name.
    pub name: String,
    /// Its variables and families.
    pub bindings: Vec<Binding>,
    /// Its sequences.
    pub sequences: Vec<Sequence>,
    /// Its hypotheses.
    pub assumptions: Vec<Prop>,
    /// What it claims.
    pub goal: Prop,
}

impl Statement {
    /// The statement of a claim: every `let` is put in place, in the order written.
    pub fn of(claim: &Claim) -> Result<Statement, Refusal> {
        Statement::with_lets(claim).map(|both| both.0)
    }

    /// The statement of a claim, and what puts its `let`s in place in its argument.
    pub fn with_lets(claim: &Claim) -> Result<(Statement, Substitution), Refusal> {
        let mut lets = Substitution::default();
        let room = &mut Room::new();
        let (mut bindings, mut sequences, mut assumptions) = (Vec::new(), Vec::new(), Vec::new());
        for item in &claim.items {
            match item {
                Item::Given(list) => {
                    for binding in list {
                        bindings.push(lets.binding_in(binding, room)?);
                    }
                }
                Item::Let { name, parameters, value } => {
                    let value = lets.without(parameters.iter(), room)?.expr_in(value, room)?;
                    lets.define(&name.text, parameters.iter().map(|p| p.text.clone()).collect(), value);
                }
                Item::Define { name, initial, index, step, .. } => sequences.push(Sequence {
                    name: name.text.clone(),
                    initial: lets.expr_in(initial, room)?,
                    index: index.text.clone(),
                    step: lets.without([index].into_iter(), room)?.expr_in(step, room)?,
                }),
                Item::Assume { prop, .. } => assumptions.push(lets.prop_in(prop, room)?),
            }
        }
        let goal = lets.prop_in(&claim.goal, room)?;
        Ok((Statement { name: claim.name.text.clone(), bindings, sequences, assumptions, goal }, lets))
    }

    /// Whether it declares this name.
    pub fn declares(&self, name: &str) -> bool {
        declares(&self.bindings, &self.sequences, name)
    }

    /// Every name that occurs, bound ones included.
    pub fn names(&self) -> BTreeSet<String> {
        let mut out = BTreeSet::new();
        self.bindings.iter().for_each(|b| names_in_binding(b, &mut out));
        for u in &self.sequences {
            out.extend([u.name.clone(), u.index.clone()]);
            names_in(&u.initial, &mut out);
            names_in(&u.step, &mut out);
        }
        self.assumptions.iter().chain([&self.goal]).for_each(|p| names_in_prop(p, &mut out));
        out
    }

    /// The statement, one hypothesis on each line: what the kernel understood.
    pub fn text(&self) -> String {
        let mut out = format!("claim {}\n", self.name);
        for binding in &self.bindings {
            out += &format!("given {}\n", text::binding(binding));
        }
        for u in &self.sequences {
            let (name, k) = (&u.name, &u.index);
            out += &format!(
                "define {name} by {name}(0) = {}, {name}({k} + 1) = {}\n",
                text::expr(&u.initial),
                text::expr(&u.step)
            );
        }
        for prop in &self.assumptions {
            out += &format!("assume {}\n", text::prop(prop));
        }
        out + &format!("prove {}\n", text::prop(&self.goal))
    }
}

/// Whether one of these variables, families and sequences has this name.
pub fn declares(bindings: &[Binding], sequences: &[Sequence], name: &str) -> bool {
    bindings.iter().flat_map(|b| &b.names).any(|n| n.0.text == name) || sequences.iter().any(|u| u.name == name)
}

/// An expression without a place.
pub fn expr(kind: ExprKind) -> Expr {
    Expr { kind, span: Span::default() }
}

/// A numeral.
pub fn numeral(k: u32) -> Expr {
    expr(ExprKind::Number(k.to_string()))
}

/// A name.
pub fn name(text: &str) -> Expr {
    expr(ExprKind::Name(text.to_string()))
}

/// A sum.
pub fn sum(parts: Vec<(Sign, Expr)>) -> Expr {
    expr(ExprKind::Sum(parts))
}

/// A product.
pub fn product(parts: Vec<Expr>) -> Expr {
    expr(ExprKind::Product(parts.into_iter().map(|e| (Factor::Times, e)).collect()))
}

/// A power.
pub fn power(base: &Expr, exponent: &Expr) -> Expr {
    expr(ExprKind::Power(Box::new(base.clone()), Box::new(exponent.clone())))
}

/// `function(argument)`.
pub fn apply(function: &str, argument: Expr) -> Expr {
    expr(ExprKind::Apply(Name::new(function), vec![argument]))
}

/// `1 - p`.
pub fn one_minus(p: &Expr) -> Expr {
    sum(vec![(Sign::Plus, numeral(1)), (Sign::Minus, p.clone())])
}

/// A proposition without a place.
pub fn prop(kind: PropKind) -> Prop {
    Prop { kind, span: Span::default() }
}

/// `a relation b`.
pub fn compare(a: Expr, relation: Relation, b: Expr) -> Prop {
    prop(PropKind::Compare(vec![a, b], vec![relation]))
}

/// What the domain of a binding says of each plain name; families say it of their members.
pub fn domain(binding: &Binding) -> Vec<Prop> {
    let plain = binding.names.iter().filter(|n| n.1.is_none());
    plain.flat_map(|(n, _)| constraints(binding, &name(&n.text))).collect()
}

/// The constraints of a binding about one value.
pub fn constraints(binding: &Binding, value: &Expr) -> Vec<Prop> {
    let mut out = Vec::new();
    let mut push = |relation: Relation, bound: &Expr| out.push(compare(value.clone(), relation, bound.clone()));
    for constraint in &binding.constraints {
        match constraint {
            Constraint::Relation(relation, e) => push(*relation, e),
            Constraint::Interval { from, from_closed, to, to_closed } => {
                push(if *from_closed { Relation::GreaterEqual } else { Relation::Greater }, from);
                push(if *to_closed { Relation::LessEqual } else { Relation::Less }, to);
            }
            Constraint::Range(from, to) => {
                push(Relation::GreaterEqual, from);
                push(Relation::LessEqual, to);
            }
        }
    }
    out
}

/// Whether a sequence occurs in its own step as the member at the index only, which nothing binds again.
pub fn steps_once(step: &Expr, sequence: &str, index: &str) -> bool {
    let here = match &step.kind {
        ExprKind::Name(text) => text != sequence,
        ExprKind::Apply(f, arguments) if f.text == sequence => {
            return matches!(arguments.as_slice(), [Expr { kind: ExprKind::Name(text), .. }] if text == index);
        }
        ExprKind::SumOver(i, _) | ExprKind::ProductOver(i, _) | ExprKind::IntegralOver(i, _) => i.name.text != index,
        ExprKind::Derivative(_, by) => by.iter().all(|n| n.text != sequence && n.text != index),
        _ => true,
    };
    here && parts(step).into_iter().all(|e| steps_once(e, sequence, index))
}
