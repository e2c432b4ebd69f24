//! Expressions as the statement writes them: with the claim's own definitions and with the names that the proof gives.
//!
//! Contract: a proposition and its shorthand mean the same. A definition without parameters replaces its value, one
//! with parameters replaces every expression of its form.

use crate::claim::syntax::*;
use crate::kernel::statement::{Statement, expr, name};

/// A name written for a longer expression.
#[derive(Clone, Debug, Default)]
pub(super) struct Shorthand {
    /// The definitions of the claim, each with the earlier ones put in.
    definitions: Vec<(Name, Vec<String>, Expr)>,
    /// The names that the proof gives.
    names: Vec<(String, Expr)>,
}

impl Shorthand {
    /// The definitions of a claim.
    pub(super) fn of(claim: &Claim) -> Shorthand {
        let mut definitions = Vec::new();
        for (place, item) in claim.items.iter().enumerate() {
            let Item::Let { name, parameters, value } = item else { continue };
            // The kernel's own reader puts the earlier definitions in.
            let mut alone = claim.clone();
            alone.items.truncate(place);
            let kind = PropKind::Compare(vec![value.clone(), value.clone()], vec![Relation::Equal]);
            alone.goal = Prop { kind, span: value.span };
            let Ok(statement) = Statement::of(&alone) else { continue };
            let PropKind::Compare(sides, _) = statement.goal.kind else { continue };
            let Some(value) = sides.into_iter().next() else { continue };
            if !matches!(value.kind, ExprKind::Name(_) | ExprKind::Number(_)) {
                definitions.push((name.clone(), parameters.iter().map(|p| p.text.clone()).collect(), value));
            }
        }
        Shorthand { definitions, names: Vec::new() }
    }

    /// Gives something a name from here on.
    pub(super) fn give(&mut self, name: &str, value: &Expr) {
        self.names.push((name.to_string(), value.clone()));
    }

    /// Whether a name was given by the proof.
    pub(crate) fn is_given(&self, name: &str) -> bool {
        self.names.iter().any(|n| n.0 == name)
    }

    /// How many names were given.
    pub(super) fn given(&self) -> usize {
        self.names.len()
    }

    /// Forgets the names given since.
    pub(crate) fn back_to(&mut self, given: usize) {
        self.names.truncate(given);
    }

    /// An expression in short.
    pub(super) fn expr(&self, e: &Expr) -> Expr {
        if let Some((short, _)) = self.names.iter().find(|n| n.1 == *e) {
            return name(short);
        }
        for (short, parameters, value) in self.definitions.iter().rev() {
            let mut found: Vec<(&str, &Expr)> = Vec::new();
            if matches(value, e, parameters, &mut found) {
                let values: Option<Vec<Expr>> =
                    parameters.iter().map(|p| found.iter().find(|f| f.0 == p).map(|f| self.expr(f.1))).collect();
                match values {
                    Some(values) if values.is_empty() => return name(&short.text),
                    Some(values) => return expr(ExprKind::Apply(short.clone(), values)),
                    None => {}
                }
            }
        }
        let list = |list: &[Expr]| list.iter().map(|e| self.expr(e)).collect::<Vec<_>>();
        let boxed = |e: &Expr| Box::new(self.expr(e));
        let index = |i: &Index| Index { name: i.name.clone(), from: boxed(&i.from), to: boxed(&i.to) };
        expr(match &e.kind {
            ExprKind::Number(_) | ExprKind::Name(_) => e.kind.clone(),
            ExprKind::Apply(f, arguments) => ExprKind::Apply(f.clone(), list(arguments)),
            ExprKind::Negate(a) => ExprKind::Negate(boxed(a)),
            ExprKind::Sum(terms) => ExprKind::Sum(terms.iter().map(|(s, e)| (*s, self.expr(e))).collect()),
            ExprKind::Product(terms) => ExprKind::Product(terms.iter().map(|(s, e)| (*s, self.expr(e))).collect()),
            ExprKind::Power(base, exponent) => match root(exponent) {
                Some(root) => ExprKind::Apply(Name::new(root), vec![self.expr(base)]),
                None => ExprKind::Power(boxed(base), boxed(exponent)),
            },
            ExprKind::SumOver(i, body) => ExprKind::SumOver(index(i), boxed(body)),
            ExprKind::ProductOver(i, body) => ExprKind::ProductOver(index(i), boxed(body)),
            ExprKind::IntegralOver(x, body) => ExprKind::IntegralOver(index(x), boxed(body)),
            ExprKind::Derivative(body, by) => ExprKind::Derivative(boxed(body), by.clone()),
            ExprKind::Matrix(rows) => ExprKind::Matrix(rows.iter().map(|row| list(row)).collect()),
        })
    }

    /// A proposition in short.
    pub(super) fn prop(&self, p: &Prop) -> Prop {
        let list = |list: &[Prop]| list.iter().map(|p| self.prop(p)).collect::<Vec<_>>();
        let boxed = |p: &Prop| Box::new(self.prop(p));
        let kind = match &p.kind {
            PropKind::Compare(sides, relations) => {
                PropKind::Compare(sides.iter().map(|e| self.expr(e)).collect(), relations.clone())
            }
            PropKind::And(parts) => PropKind::And(list(parts)),
            PropKind::Or(parts) => PropKind::Or(list(parts)),
            PropKind::Not(q) => PropKind::Not(boxed(q)),
            PropKind::Implies(a, b) => PropKind::Implies(boxed(a), boxed(b)),
            PropKind::Equivalent(parts) => PropKind::Equivalent(list(parts)),
            PropKind::Exists(bindings, q) => PropKind::Exists(bindings.clone(), boxed(q)),
            PropKind::ForAll(bindings, q) => PropKind::ForAll(bindings.clone(), boxed(q)),
            PropKind::Extremum(x) => PropKind::Extremum(Box::new(Extremum {
                of: self.expr(&x.of),
                at: x.at.iter().map(|(n, e)| (n.clone(), self.expr(e))).collect(),
                value: self.expr(&x.value),
                ..(**x).clone()
            })),
            PropKind::WrittenLimit(_) => p.kind.clone(),
            PropKind::Limit(l) => PropKind::Limit(Box::new(Limit {
                of: self.expr(&l.of),
                variable: l.variable.clone(),
                value: self.expr(&l.value),
            })),
        };
        Prop { kind, span: p.span }
    }
}

/// The root that a power to `1/2` or `1/3` is.
fn root(exponent: &Expr) -> Option<&'static str> {
    let ExprKind::Product(list) = &exponent.kind else { return None };
    let [(Factor::Times, above), (Factor::Over, below)] = list.as_slice() else { return None };
    match (&above.kind, &below.kind) {
        (ExprKind::Number(one), ExprKind::Number(two)) if one == "1" && two == "2" => Some("sqrt"),
        (ExprKind::Number(one), ExprKind::Number(three)) if one == "1" && three == "3" => Some("cbrt"),
        _ => None,
    }
}

/// Whether an expression is a form with values for its parameters, which are collected.
fn matches<'a>(form: &'a Expr, e: &'a Expr, parameters: &[String], found: &mut Vec<(&'a str, &'a Expr)>) -> bool {
    if let ExprKind::Name(parameter) = &form.kind
        && parameters.contains(parameter)
    {
        return match found.iter().find(|f| f.0 == parameter) {
            Some((_, before)) => *before == e,
            None => {
                found.push((parameter, e));
                true
            }
        };
    }
    let mut all = |forms: &'a [Expr], es: &'a [Expr]| {
        forms.len() == es.len() && forms.iter().zip(es).all(|(f, e)| matches(f, e, parameters, found))
    };
    match (&form.kind, &e.kind) {
        (ExprKind::Apply(f, a), ExprKind::Apply(g, b)) => f == g && all(a, b),
        (ExprKind::Negate(a), ExprKind::Negate(b)) => matches(a, b, parameters, found),
        (ExprKind::Sum(a), ExprKind::Sum(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(f, e)| f.0 == e.0 && matches(&f.1, &e.1, parameters, found))
        }
        (ExprKind::Product(a), ExprKind::Product(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(f, e)| f.0 == e.0 && matches(&f.1, &e.1, parameters, found))
        }
        (ExprKind::Power(a, k), ExprKind::Power(b, l)) => {
            matches(a, b, parameters, found) && matches(k, l, parameters, found)
        }
        _ => form == e,
    }
}
