//! Which names stand for natural numbers, reals, matrices and functions of them.
//!
//! Contract: a parameter of a `let` is natural if every use of it, in what follows, puts a natural
//! expression there, and one of them a name; otherwise it is real. An expression is natural if it is built from natural
//! names and integers by `+`, `*` and powers alone, so that it has the same value in either kind.

use crate::claim::syntax::*;
use std::collections::BTreeMap;

/// What a name stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A real number.
    Real,
    /// A natural number.
    Natural,
    /// A matrix.
    Matrix,
    /// A function to the reals; for each parameter, whether it is natural.
    Function(Vec<bool>),
}

/// The kinds of the names in scope.
pub(super) type Kinds = BTreeMap<String, Kind>;

/// Whether a name stands for natural numbers, as [`definedness`](crate::claim::definedness) asks.
pub(crate) fn is_natural_name(name: &str, kinds: &Kinds) -> bool {
    kinds.get(name) == Some(&Kind::Natural)
}

/// Whether an expression is a natural number by its form alone, such that it can be written in `nat`.
pub(crate) fn is_natural(expr: &Expr, kinds: &Kinds) -> bool {
    match &expr.kind {
        ExprKind::Number(text) => text.bytes().all(|b| b.is_ascii_digit()),
        ExprKind::Name(name) => is_natural_name(name, kinds),
        ExprKind::Sum(list) => list.iter().all(|(s, e)| *s == Sign::Plus && is_natural(e, kinds)),
        ExprKind::Product(list) => list.iter().all(|(f, e)| *f == Factor::Times && is_natural(e, kinds)),
        ExprKind::Power(a, b) => is_natural(a, kinds) && is_natural(b, kinds),
        _ => false,
    }
}

/// Whether an expression is a matrix.
pub(crate) fn is_matrix(expr: &Expr, kinds: &Kinds) -> bool {
    match &expr.kind {
        ExprKind::Matrix(_) => true,
        ExprKind::Name(name) => kinds.get(name) == Some(&Kind::Matrix),
        ExprKind::Apply(f, arguments) => f.text == "transpose" && arguments.iter().any(|a| is_matrix(a, kinds)),
        ExprKind::Negate(a) => is_matrix(a, kinds),
        ExprKind::Sum(list) => list.iter().any(|(_, e)| is_matrix(e, kinds)),
        ExprKind::Product(list) => list.iter().any(|(_, e)| is_matrix(e, kinds)),
        _ => false,
    }
}

/// Adds the names of bindings.
pub(crate) fn bind(bindings: &[Binding], kinds: &mut Kinds) {
    for binding in bindings {
        for (name, index) in &binding.names {
            let kind = match index {
                Some(_) => Kind::Function(vec![true]),
                None if binding.natural => Kind::Natural,
                None => Kind::Real,
            };
            kinds.insert(name.text.clone(), kind);
        }
    }
}

/// The kinds of all names that a claim declares.
pub(crate) fn of_claim(claim: &Claim) -> Kinds {
    let mut kinds = Kinds::new();
    for item in &claim.items {
        match item {
            Item::Given(bindings) => bind(bindings, &mut kinds),
            Item::Let { name, parameters, value } => {
                let kind = if !parameters.is_empty() {
                    Kind::Function(vec![false; parameters.len()])
                } else if is_matrix(value, &kinds) {
                    Kind::Matrix
                } else if is_natural(value, &kinds) && names_one(value) {
                    Kind::Natural
                } else {
                    Kind::Real
                };
                kinds.insert(name.text.clone(), kind);
            }
            Item::Define { name, .. } => {
                kinds.insert(name.text.clone(), Kind::Function(vec![true]));
            }
            Item::Assume { .. } => {}
        }
    }
    // Backwards: the uses of a definition stand after it, within definitions that are then known.
    for (place, item) in claim.items.iter().enumerate().rev() {
        let Item::Let { name, parameters, .. } = item else { continue };
        if parameters.is_empty() {
            continue;
        }
        let mut uses =
            Uses { target: &name.text, natural: vec![true; parameters.len()], named: vec![false; parameters.len()] };
        for later in claim.items.iter().skip(place + 1) {
            match later {
                Item::Given(bindings) => uses.bindings(bindings, &kinds),
                Item::Let { name, parameters, value } => {
                    let mut inner = kinds.clone();
                    if let Some(Kind::Function(natural)) = kinds.get(&name.text) {
                        for (parameter, natural) in parameters.iter().zip(natural) {
                            let kind = if *natural { Kind::Natural } else { Kind::Real };
                            inner.insert(parameter.text.clone(), kind);
                        }
                    }
                    uses.expr(value, &inner);
                }
                Item::Define { initial, index, step, .. } => {
                    uses.expr(initial, &kinds);
                    let mut inner = kinds.clone();
                    inner.insert(index.text.clone(), Kind::Natural);
                    uses.expr(step, &inner);
                }
                Item::Assume { prop, .. } => uses.prop(prop, &kinds),
            }
        }
        uses.prop(&claim.goal, &kinds);
        let natural = uses.natural.iter().zip(&uses.named).map(|(natural, named)| *natural && *named).collect();
        kinds.insert(name.text.clone(), Kind::Function(natural));
    }
    kinds
}

fn names_one(expr: &Expr) -> bool {
    let mut found = matches!(expr.kind, ExprKind::Name(_));
    crate::refute::expand::parts(expr, &mut |part| found |= names_one(part));
    found
}

/// The uses of one function: which of its parameters are natural in all of them.
struct Uses<'a> {
    target: &'a str,
    natural: Vec<bool>,
    /// Whether a name stands in some use: numerals alone are read as reals.
    named: Vec<bool>,
}

impl Uses<'_> {
    fn expr(&mut self, expr: &Expr, kinds: &Kinds) {
        match &expr.kind {
            ExprKind::Apply(f, arguments) => {
                if f.text == self.target {
                    for ((natural, named), argument) in self.natural.iter_mut().zip(&mut self.named).zip(arguments) {
                        *natural &= is_natural(argument, kinds);
                        *named |= names_one(argument);
                    }
                }
                arguments.iter().for_each(|a| self.expr(a, kinds));
            }
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
                self.expr(&index.from, kinds);
                self.expr(&index.to, kinds);
                let mut inner = kinds.clone();
                inner.insert(index.name.text.clone(), Kind::Natural);
                self.expr(body, &inner);
            }
            ExprKind::IntegralOver(variable, body) => {
                self.expr(&variable.from, kinds);
                self.expr(&variable.to, kinds);
                let mut inner = kinds.clone();
                inner.insert(variable.name.text.clone(), Kind::Real);
                self.expr(body, &inner);
            }
            _ => crate::refute::expand::parts(expr, &mut |part| self.expr(part, kinds)),
        }
    }

    fn bindings(&mut self, bindings: &[Binding], kinds: &Kinds) {
        for binding in bindings {
            let mut inner = kinds.clone();
            for index in binding.names.iter().filter_map(|n| n.1.as_ref()) {
                inner.insert(index.text.clone(), Kind::Natural);
            }
            for constraint in &binding.constraints {
                match constraint {
                    Constraint::Relation(_, e) => self.expr(e, &inner),
                    Constraint::Interval { from, to, .. } | Constraint::Range(from, to) => {
                        self.expr(from, &inner);
                        self.expr(to, &inner);
                    }
                }
            }
        }
    }

    fn prop(&mut self, prop: &Prop, kinds: &Kinds) {
        match &prop.kind {
            PropKind::Compare(sides, _) => sides.iter().for_each(|e| self.expr(e, kinds)),
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().for_each(|p| self.prop(p, kinds));
            }
            PropKind::Not(p) => self.prop(p, kinds),
            PropKind::Implies(p, q) => {
                self.prop(p, kinds);
                self.prop(q, kinds);
            }
            PropKind::Exists(bindings, body) | PropKind::ForAll(bindings, body) => {
                let mut inner = kinds.clone();
                bind(bindings, &mut inner);
                self.bindings(bindings, &inner);
                self.prop(body, &inner);
            }
            PropKind::Extremum(extremum) => {
                extremum.at.iter().for_each(|(_, e)| self.expr(e, kinds));
                self.expr(&extremum.value, kinds);
                let mut inner = kinds.clone();
                bind(&extremum.over, &mut inner);
                self.bindings(&extremum.over, &inner);
                self.expr(&extremum.of, &inner);
            }
            PropKind::Limit(limit) => {
                self.expr(&limit.of, kinds);
                self.expr(&limit.value, kinds);
            }
            PropKind::WrittenLimit(_) => {}
        }
    }
}
