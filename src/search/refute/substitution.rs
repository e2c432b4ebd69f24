//! Substitution: free names replaced by expressions, all at once, without capture.
//!
//! Contract: a bound name that would capture a name of a replacement is renamed. The size of the result is bounded by
//! [`NODES_LIMIT`]: definitions that double at each line end in a limit, not in memory.

use super::expand::Limit;
use crate::claim::syntax::*;
use crate::claim::walk::{names_in, nodes_in, parts};
use rustc_hash::FxHashMap as HashMap;
use std::collections::BTreeSet;

/// The largest number of nodes of all expanded expressions of a claim together.
pub const NODES_LIMIT: usize = 100_000;

type Result<T> = std::result::Result<T, Limit>;

/// What a name is replaced by.
#[derive(Clone, Debug)]
enum Replacement {
    Value(Expr),
    Definition(Vec<String>, Expr),
    Family(String),
}

/// A simultaneous replacement of free names.
#[derive(Clone, Debug, Default)]
pub struct Substitution {
    map: HashMap<String, Replacement>,
    mentioned: BTreeSet<String>,
    nodes: usize,
    fresh: usize,
}

impl Substitution {
    /// Replaces a free name by an expression.
    pub fn replace(&mut self, name: &str, value: Expr) {
        names_in(&value, &mut self.mentioned);
        self.map.insert(name.to_string(), Replacement::Value(value));
    }

    /// Renames a family or sequence.
    pub(crate) fn rename_family(&mut self, name: &str, other: &str) {
        self.mentioned.insert(other.to_string());
        self.map.insert(name.to_string(), Replacement::Family(other.to_string()));
    }

    /// Puts a definition in place of a name or of its applications.
    pub fn define(&mut self, name: &str, parameters: Vec<String>, value: Expr) {
        names_in(&value, &mut self.mentioned);
        self.map.insert(name.to_string(), Replacement::Definition(parameters, value));
    }

    fn count(&mut self) -> Result<()> {
        self.nodes += 1;
        if self.nodes > NODES_LIMIT { Err(Limit("definition size")) } else { Ok(()) }
    }

    /// Enters the scope of bound names: they are no longer replaced, and renamed if they would
    /// capture a name of a replacement. Returns the inner substitution and the names to write.
    fn enter(&mut self, names: &[&Name]) -> (Substitution, Vec<Name>) {
        let mut inner = self.clone();
        let mut out = Vec::new();
        for name in names {
            inner.map.remove(&name.text);
            if self.mentioned.contains(&name.text) && !inner.map.is_empty() {
                self.fresh += 1;
                // No name that anybody can write has an apostrophe before its end.
                let fresh = format!("{}'{}", name.text, self.fresh);
                let value = Expr { kind: ExprKind::Name(fresh.clone()), span: name.span };
                inner.fresh = self.fresh;
                inner.map.insert(name.text.clone(), Replacement::Value(value));
                inner.mentioned.insert(fresh.clone());
                out.push(Name { text: fresh, span: name.span });
            } else {
                out.push((*name).clone());
            }
        }
        (inner, out)
    }

    fn leave(&mut self, inner: Substitution) {
        self.nodes = inner.nodes;
        self.fresh = inner.fresh;
    }

    fn exprs(&mut self, list: &[Expr]) -> Result<Vec<Expr>> {
        list.iter().map(|e| self.expr(e)).collect()
    }

    /// The expression with the names replaced.
    pub fn expr(&mut self, expr: &Expr) -> Result<Expr> {
        self.count()?;
        use ExprKind::*;
        let kind = match &expr.kind {
            Number(text) => Number(text.clone()),
            Name(name) => match self.map.get(name) {
                Some(Replacement::Value(value)) => return self.copied(value.clone(), expr.span),
                Some(Replacement::Definition(parameters, value)) if parameters.is_empty() => {
                    return self.copied(value.clone(), expr.span);
                }
                Some(Replacement::Family(other)) => Name(other.clone()),
                _ => Name(name.clone()),
            },
            Apply(function, arguments) => {
                let arguments = self.exprs(arguments)?;
                match self.map.get(&function.text).cloned() {
                    Some(Replacement::Definition(parameters, value)) if parameters.len() == arguments.len() => {
                        let mut inner = Substitution { nodes: self.nodes, fresh: self.fresh, ..Default::default() };
                        for (parameter, argument) in parameters.iter().zip(&arguments) {
                            inner.replace(parameter, argument.clone());
                        }
                        let out = inner.expr(&value)?;
                        self.leave(inner);
                        return Ok(Expr { kind: out.kind, span: expr.span });
                    }
                    Some(Replacement::Family(other)) => {
                        Apply(crate::claim::syntax::Name { text: other, span: function.span }, arguments)
                    }
                    _ => Apply(function.clone(), arguments),
                }
            }
            Negate(a) => Negate(Box::new(self.expr(a)?)),
            Sum(list) => Sum(list.iter().map(|(s, e)| Ok((*s, self.expr(e)?))).collect::<Result<_>>()?),
            Product(list) => Product(list.iter().map(|(s, e)| Ok((*s, self.expr(e)?))).collect::<Result<_>>()?),
            Power(a, b) => Power(Box::new(self.expr(a)?), Box::new(self.expr(b)?)),
            SumOver(index, body) => {
                let (index, body) = self.over(index, body)?;
                SumOver(index, body)
            }
            ProductOver(index, body) => {
                let (index, body) = self.over(index, body)?;
                ProductOver(index, body)
            }
            Derivative(body, by) => {
                let mut names = Vec::new();
                for name in by {
                    names.push(self.moving(name, body)?);
                }
                Derivative(Box::new(self.expr(body)?), names)
            }
            Matrix(rows) => Matrix(rows.iter().map(|r| self.exprs(r)).collect::<Result<_>>()?),
        };
        Ok(Expr { kind, span: expr.span })
    }

    /// The variable that moves in a derivative or a limit: it stays a name, and a renaming is followed. What is put
    /// in for other names must not move with it, and no other name may become it: that would be another derivative.
    /// The text of a `let` is what the claim says, and may contain the variable.
    fn moving(&self, variable: &Name, body: &Expr) -> Result<Name> {
        const MOVES: Limit = Limit("a value put in for what a derivative or a limit holds fast");
        let renamed = match self.map.get(&variable.text) {
            Some(Replacement::Value(Expr { kind: ExprKind::Name(other), .. })) => Some(other.clone()),
            Some(_) => return Err(Limit("a value put for a variable of differentiation or of a limit")),
            None => None,
        };
        let text = renamed.as_ref().unwrap_or(&variable.text);
        // A sequence in the body may be made of what the variable would become, unless that is a name of our own.
        if renamed.as_ref().is_some_and(|name| !name.trim_end_matches('\'').contains('\'')) && has_member(body) {
            return Err(MOVES);
        }
        let mut names = BTreeSet::new();
        names_in(body, &mut names);
        names.remove(&variable.text);
        for name in &names {
            let moves = match self.map.get(name) {
                None => name == text,
                // A sequence may be made of the variable.
                Some(Replacement::Family(_)) => true,
                Some(Replacement::Definition(..)) if renamed.is_none() => false,
                Some(Replacement::Value(value) | Replacement::Definition(_, value)) => {
                    let mut inside = BTreeSet::new();
                    names_in(value, &mut inside);
                    inside.contains(text) || has_member(value)
                }
            };
            if moves {
                return Err(MOVES);
            }
        }
        Ok(Name { text: text.clone(), span: variable.span })
    }

    fn copied(&mut self, value: Expr, span: Span) -> Result<Expr> {
        self.nodes += nodes_in(&value);
        self.count()?;
        Ok(Expr { kind: value.kind, span })
    }

    fn over(&mut self, index: &Index, body: &Expr) -> Result<(Index, Box<Expr>)> {
        let from = Box::new(self.expr(&index.from)?);
        let to = Box::new(self.expr(&index.to)?);
        let (mut inner, names) = self.enter(&[&index.name]);
        let body = Box::new(inner.expr(body)?);
        self.leave(inner);
        let name = names.into_iter().next().unwrap_or_else(|| index.name.clone());
        Ok((Index { name, from, to }, body))
    }

    /// The binding with the names in its constraints replaced. There the index of a family is bound.
    pub fn binding(&mut self, binding: &Binding) -> Result<Binding> {
        let range = match &binding.indices {
            Some((a, b)) => Some((self.expr(a)?, self.expr(b)?)),
            None => None,
        };
        // Families that are declared together may have one name for their indices.
        let mut own: Vec<&Name> = Vec::new();
        for index in binding.names.iter().filter_map(|n| n.1.as_ref()) {
            if own.iter().all(|other| other.text != index.text) {
                own.push(index);
            }
        }
        let (mut inner, renamed) = self.enter(&own);
        let mut names = binding.names.clone();
        for index in names.iter_mut().filter_map(|n| n.1.as_mut()) {
            if let Some(place) = own.iter().position(|other| other.text == index.text) {
                *index = renamed[place].clone();
            }
        }
        let constraints = binding
            .constraints
            .iter()
            .map(|c| {
                Ok(match c {
                    Constraint::Relation(r, e) => Constraint::Relation(*r, inner.expr(e)?),
                    Constraint::Interval { from, from_closed, to, to_closed } => Constraint::Interval {
                        from: inner.expr(from)?,
                        from_closed: *from_closed,
                        to: inner.expr(to)?,
                        to_closed: *to_closed,
                    },
                    Constraint::Range(a, b) => Constraint::Range(inner.expr(a)?, inner.expr(b)?),
                })
            })
            .collect::<Result<_>>()?;
        self.leave(inner);
        Ok(Binding { names, constraints, indices: range, ..binding.clone() })
    }

    /// Families that got another name on entering a scope have it where members are named, too.
    fn rename_families(&mut self, bindings: &[Binding], renamed: &[Name]) {
        for ((name, index), new) in bindings.iter().flat_map(|b| &b.names).zip(renamed) {
            if index.is_some() && name.text != new.text {
                self.rename_family(&name.text, &new.text);
            }
        }
    }

    fn quantified(&mut self, bindings: &[Binding], body: &Prop) -> Result<(Vec<Binding>, Box<Prop>)> {
        let names: Vec<&Name> = bindings.iter().flat_map(|b| b.names.iter().map(|n| &n.0)).collect();
        let (mut inner, renamed) = self.enter(&names);
        inner.rename_families(bindings, &renamed);
        let mut renamed = renamed.into_iter();
        let mut out = Vec::new();
        for binding in bindings {
            let mut binding = inner.binding(binding)?;
            for name in &mut binding.names {
                if let Some(new) = renamed.next() {
                    name.0 = new;
                }
            }
            out.push(binding);
        }
        let body = Box::new(inner.prop(body)?);
        self.leave(inner);
        Ok((out, body))
    }

    /// The proposition with the names replaced.
    pub fn prop(&mut self, prop: &Prop) -> Result<Prop> {
        use PropKind::*;
        let kind = match &prop.kind {
            Compare(sides, relations) => Compare(self.exprs(sides)?, relations.clone()),
            And(list) => And(list.iter().map(|p| self.prop(p)).collect::<Result<_>>()?),
            Or(list) => Or(list.iter().map(|p| self.prop(p)).collect::<Result<_>>()?),
            Not(p) => Not(Box::new(self.prop(p)?)),
            Implies(p, q) => Implies(Box::new(self.prop(p)?), Box::new(self.prop(q)?)),
            Equivalent(list) => Equivalent(list.iter().map(|p| self.prop(p)).collect::<Result<_>>()?),
            Exists(bindings, body) => {
                let (bindings, body) = self.quantified(bindings, body)?;
                Exists(bindings, body)
            }
            ForAll(bindings, body) => {
                let (bindings, body) = self.quantified(bindings, body)?;
                ForAll(bindings, body)
            }
            PropKind::Extremum(extremum) => {
                // The point is outside the scope of `over`; what is extremised is inside. A renamed
                // variable keeps its place in `at`.
                let at_values = extremum.at.iter().map(|(_, e)| self.expr(e)).collect::<Result<Vec<_>>>()?;
                let value = self.expr(&extremum.value)?;
                let names: Vec<&Name> = extremum.over.iter().flat_map(|b| b.names.iter().map(|n| &n.0)).collect();
                let (mut inner, renamed) = self.enter(&names);
                inner.rename_families(&extremum.over, &renamed);
                let rename: HashMap<String, Name> = names.iter().map(|n| n.text.clone()).zip(renamed).collect();
                let mut over = Vec::new();
                for binding in &extremum.over {
                    let mut binding = inner.binding(binding)?;
                    for name in &mut binding.names {
                        if let Some(new) = rename.get(&name.0.text) {
                            name.0 = new.clone();
                        }
                    }
                    over.push(binding);
                }
                let of = inner.expr(&extremum.of)?;
                self.leave(inner);
                let at = extremum
                    .at
                    .iter()
                    .zip(at_values)
                    .map(|((n, _), e)| (rename.get(&n.text).unwrap_or(n).clone(), e))
                    .collect();
                PropKind::Extremum(Box::new(crate::claim::syntax::Extremum {
                    maximum: extremum.maximum,
                    unique: extremum.unique,
                    of,
                    over,
                    at,
                    value,
                }))
            }
            PropKind::WrittenLimit(_) => prop.kind.clone(),
            PropKind::Limit(limit) => PropKind::Limit(Box::new(crate::claim::syntax::Limit {
                variable: self.moving(&limit.variable, &limit.of)?,
                of: self.expr(&limit.of)?,
                value: self.expr(&limit.value)?,
            })),
        };
        Ok(Prop { kind, span: prop.span })
    }

    fn values(&mut self, list: &[(Name, Expr)]) -> Result<Vec<(Name, Expr)>> {
        list.iter().map(|(n, e)| Ok((n.clone(), self.expr(e)?))).collect()
    }

    /// The argument with the names replaced.
    pub fn proof(&mut self, proof: &Proof) -> Result<Proof> {
        let steps = proof
            .steps
            .iter()
            .map(|step| {
                Ok(match step {
                    Step::Have { label, prop, proof } => {
                        Step::Have { label: label.clone(), prop: self.prop(prop)?, proof: self.proof(proof)? }
                    }
                    Step::Obtain { binding, label, prop, witness } => Step::Obtain {
                        binding: self.binding(binding)?,
                        label: label.clone(),
                        prop: self.prop(prop)?,
                        witness: self.expr(witness)?,
                    },
                    Step::Case { label, prop, proof } => {
                        Step::Case { label: label.clone(), prop: self.prop(prop)?, proof: self.proof(proof)? }
                    }
                })
            })
            .collect::<Result<_>>()?;
        let close = match &proof.close {
            None => None,
            Some(method) => Some(match method {
                Method::Algebra(facts) => Method::Algebra(facts.clone()),
                Method::Induction(name, step) => Method::Induction(name.clone(), Box::new(self.proof(step)?)),
                Method::Instance { claim, with } => Method::Instance { claim: claim.clone(), with: self.values(with)? },
                Method::Witness(list) => Method::Witness(self.values(list)?),
                Method::Power { fact, exponent } => {
                    Method::Power { fact: fact.clone(), exponent: self.expr(exponent)? }
                }
                Method::Product(list) => Method::Product(
                    list.iter()
                        .map(|(n, e)| Ok((n.clone(), e.as_ref().map(|e| self.expr(e)).transpose()?)))
                        .collect::<Result<_>>()?,
                ),
                Method::Mean { a, b, weight } => {
                    Method::Mean { a: self.expr(a)?, b: self.expr(b)?, weight: self.expr(weight)? }
                }
                Method::Hoelder { first, second, weight } => Method::Hoelder {
                    first: (self.expr(&first.0)?, self.expr(&first.1)?),
                    second: (self.expr(&second.0)?, self.expr(&second.1)?),
                    weight: self.expr(weight)?,
                },
                Method::Squeeze { lower, upper } => {
                    Method::Squeeze { lower: self.expr(lower)?, upper: self.expr(upper)? }
                }
            }),
        };
        Ok(Proof { steps, close })
    }
}

/// Whether a member of a family or sequence occurs: of what it is made is not seen in it.
fn has_member(expr: &Expr) -> bool {
    let mut found = matches!(&expr.kind, ExprKind::Apply(name, _) if !FUNCTIONS.iter().any(|f| f.0 == name.text));
    parts(expr, &mut |part| found |= has_member(part));
    found
}
