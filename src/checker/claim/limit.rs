//! Limits at a point, from one side, and infinite ones, written out as limits at infinity.
//!
//! | written | stands for |
//! |---|---|
//! | `limit of F as x -> a from above is L` | that of F with a + 1/x for x, as x → ∞ |
//! | `limit of F as x -> a from below is L` | that of F with a − 1/x for x |
//! | `limit of F as x -> a is L` | both |
//! | `limit of F … is infinity` | F > 0 from some x on, and 1/F → 0; `-infinity` with F < 0 |
//! | `F = P + O(G) as x -> infinity` | for some C > 0, abs(F − P) <= C·abs(G) from some x on; at a point with a ± 1/x for x |
//!
//! Contract: after [`write_out`] no [`WrittenLimit`] is left, and the claim says the same. Every definition that speaks of the
//! variable is put into F first. A recurrence that speaks of it is refused, and so is what [`super::substitution`] refuses: a
//! derivative by the variable, and an index that the point mentions.

use super::diagnostic::{Diagnostic, Fault};
use super::free_names::names_in;
use super::fresh::Fresh;
use super::substitution::{NODES_LIMIT, Obstacle, Substitution};
use super::syntax::*;
use super::walk;
use std::collections::{BTreeMap, BTreeSet};

/// The state while the limits of one claim are written out.
struct Writer<'a> {
    /// The declarations before the limit.
    before: Vec<Item>,
    /// The variables that the claim declares, and whether each is a natural number; `None` for one with a domain.
    variables: BTreeMap<String, Option<bool>>,
    /// The names `x_from` and `x_later` for each variable x.
    made: BTreeMap<String, (String, String)>,
    /// The name `x_bound` for each variable x.
    bounds: BTreeMap<String, String>,
    fresh: &'a mut Fresh,
    faults: &'a mut Vec<Diagnostic>,
}

/// Writes out the limits of a claim.
pub(super) fn write_out(claim: &mut Claim, fresh: &mut Fresh, faults: &mut Vec<Diagnostic>) {
    let mut variables = BTreeMap::new();
    for binding in
        claim.items.iter().filter_map(|i| if let Item::Given(list) = i { Some(list) } else { None }).flatten()
    {
        for (name, index) in &binding.names {
            let is_plain = binding.constraints.is_empty() && index.is_none();
            variables.insert(name.text.clone(), is_plain.then_some(binding.natural));
        }
    }
    let mut writer =
        Writer { before: Vec::new(), variables, made: BTreeMap::new(), bounds: BTreeMap::new(), fresh, faults };
    for mut item in std::mem::take(&mut claim.items) {
        if let Item::Assume { prop, .. } = &mut item {
            walk::props(prop, &mut |p| writer.prop(p));
        }
        writer.before.push(item);
    }
    walk::props(&mut claim.goal, &mut |p| writer.prop(p));
    walk::props_of_proof(&mut claim.proof, &mut |p| writer.prop(p));
    claim.items = writer.before;
}

impl Writer<'_> {
    fn prop(&mut self, p: &mut Prop) {
        let PropKind::WrittenLimit(limit) = &p.kind else { return };
        match self.written((**limit).clone(), p.span) {
            Ok(kind) => p.kind = kind,
            Err(fault) => self.faults.push(*fault),
        }
    }

    fn written(&mut self, limit: WrittenLimit, span: Span) -> Result<PropKind, Box<Diagnostic>> {
        let WrittenLimit { of, variable, towards, value, .. } = limit;
        let natural = match (self.variables.get(&variable.text), &towards) {
            (Some(Some(natural)), Towards::Infinity) => *natural,
            (Some(Some(false)), Towards::Point(..)) => false,
            _ => {
                let message =
                    format!("{} is already declared, so it cannot be the variable of this limit", variable.text);
                return Err(fault(message, "use a new name: the limit itself declares its variable", variable.span));
            }
        };
        let (definitions, tied) = self.that_speak_of(&variable)?;
        let put_in = |e: &Expr| definitions.expr(e).map_err(|obstacle| refused(obstacle, &variable, e.span));
        // What has an order: the difference, and its size.
        let (of, size) = match &value {
            Tendency::Order { about: Some(about), size } => {
                (difference(&put_in(&of)?, &put_in(about)?), Some(put_in(size)?))
            }
            Tendency::Order { about: None, size } => (put_in(&of)?, Some(put_in(size)?)),
            _ => (put_in(&of)?, None),
        };
        let mut inside = BTreeSet::new();
        [Some(&of), size.as_ref()].into_iter().flatten().for_each(|e| names_in(e, &mut inside));
        if let Some(name) = inside.intersection(&tied).next() {
            let message = format!("{name} depends on {}, the variable of this limit", variable.text);
            return Err(fault(message, "write its members out, as an expression in the variable", of.span));
        }
        let mut sides = vec![of.clone()];
        let mut sizes: Vec<Expr> = size.iter().cloned().collect();
        let mut list = Vec::new();
        if let Towards::Point(point, side) = towards {
            let point = definitions.expr(&point).map_err(|obstacle| refused(obstacle, &variable, point.span))?;
            self.is_fixed(&point, &variable, &tied)?;
            sides = near(&of, &variable, &point, side)?;
            if let Some(size) = &size {
                sizes = near(size, &variable, &point, side)?;
            }
            if !inside.contains(&variable.text) {
                // Nothing is left of the point, and it has to have a value.
                let kind = PropKind::Compare(vec![point.clone(), point.clone()], vec![Relation::Equal]);
                list.push(Prop { kind, span: point.span });
            }
        }
        if let Tendency::Number(value) = &value {
            let value = definitions.expr(value).map_err(|obstacle| refused(obstacle, &variable, value.span))?;
            self.is_fixed(&value, &variable, &tied)?;
        }
        let mut said = Vec::new();
        for (of, size) in sides.iter().zip(&sizes) {
            said.push(self.is_bounded(of, size, &variable, natural, span)?);
        }
        for of in sides.into_iter().filter(|_| size.is_none()) {
            said.extend(self.says(of, &variable, natural, &value, span)?);
        }
        said.append(&mut list);
        Ok(match said.len() {
            1 => said.remove(0).kind,
            _ => PropKind::And(said),
        })
    }

    /// The definitions that speak of a variable, directly or through others, to be put in; and the sequences that do.
    fn that_speak_of(&self, variable: &Name) -> Result<(Substitution, BTreeSet<String>), Box<Diagnostic>> {
        let mut definitions = Substitution::default();
        let mut tied = BTreeSet::new();
        for item in &self.before {
            let speaks = |e: &Expr, bound: &[Name], tied: &BTreeSet<String>| {
                let mut names = BTreeSet::new();
                names_in(e, &mut names);
                bound.iter().for_each(|n| {
                    names.remove(&n.text);
                });
                names.contains(&variable.text) || !names.is_disjoint(tied)
            };
            let put_in = |e: &Expr, bound: &[Name]| {
                let put_in = definitions.under(bound).and_then(|inner| inner.expr(e));
                put_in.map_err(|obstacle| refused(obstacle, variable, e.span))
            };
            match item {
                Item::Let { name, parameters, value } => {
                    let value = put_in(value, parameters)?;
                    if speaks(&value, parameters, &tied) {
                        definitions.define(&name.text, parameters.iter().map(|p| p.text.clone()).collect(), value);
                    }
                }
                Item::Define { name, initial, index, step, .. } => {
                    let (initial, step) = (put_in(initial, &[])?, put_in(step, std::slice::from_ref(index))?);
                    if speaks(&initial, &[], &tied) || speaks(&step, std::slice::from_ref(index), &tied) {
                        tied.insert(name.text.clone());
                    }
                }
                Item::Given(_) | Item::Assume { .. } => {}
            }
        }
        Ok((definitions, tied))
    }

    /// Refuses a point or a value that depends on the variable.
    fn is_fixed(&self, e: &Expr, variable: &Name, tied: &BTreeSet<String>) -> Result<(), Box<Diagnostic>> {
        let mut names = BTreeSet::new();
        names_in(e, &mut names);
        if names.contains(&variable.text) || !names.is_disjoint(tied) {
            let message = format!("this depends on {}, the variable of the limit", variable.text);
            return Err(fault(message, "use another name for the variable of the limit", e.span));
        }
        Ok(())
    }

    /// The statement about a function whose variable grows.
    fn says(
        &mut self,
        of: Expr,
        variable: &Name,
        natural: bool,
        value: &Tendency,
        span: Span,
    ) -> Result<Vec<Prop>, Box<Diagnostic>> {
        let at = |kind: ExprKind| Expr { kind, span };
        let prop = |kind: PropKind| Prop { kind, span };
        let number = |k: u32| at(ExprKind::Number(k.to_string()));
        let limit =
            |of: Expr, value: Expr| prop(PropKind::Limit(Box::new(Limit { of, variable: variable.clone(), value })));
        let sign = match value {
            Tendency::Number(value) => return Ok(vec![limit(of, value.clone())]),
            Tendency::Infinite(sign) => *sign,
            Tendency::Order { .. } => return Ok(Vec::new()),
        };
        let inverse = at(ExprKind::Product(vec![(Factor::Times, number(1)), (Factor::Over, of.clone())]));
        let (from, later) = self.eventual_names(variable);
        let value = |name: &Name| at(ExprKind::Name(name.text.clone()));
        let mut there = Substitution::default();
        there.replace(&variable.text, &value(&later));
        let there = there.expr(&of).map_err(|obstacle| refused(obstacle, variable, of.span))?;
        let binding = |name: &Name, relation: Relation, least: Expr| {
            Binding::new(vec![(name.clone(), None)], natural, vec![Constraint::Relation(relation, least)], span)
        };
        let relation = if sign == Sign::Plus { Relation::Greater } else { Relation::Less };
        let holds = prop(PropKind::Compare(vec![there, number(0)], vec![relation]));
        let from_there =
            prop(PropKind::ForAll(vec![binding(&later, Relation::GreaterEqual, value(&from))], Box::new(holds)));
        let eventually =
            prop(PropKind::Exists(vec![binding(&from, Relation::Greater, number(0))], Box::new(from_there)));
        Ok(vec![eventually, limit(inverse, number(0))])
    }

    /// That an expression is at most a multiple of another one where the variable is large: the root of its square is.
    fn is_bounded(
        &mut self,
        of: &Expr,
        size: &Expr,
        variable: &Name,
        natural: bool,
        span: Span,
    ) -> Result<Prop, Box<Diagnostic>> {
        let at = |kind: ExprKind| Expr { kind, span };
        let prop = |kind: PropKind| Prop { kind, span };
        let number = |k: u32| at(ExprKind::Number(k.to_string()));
        let value = |name: &Name| at(ExprKind::Name(name.text.clone()));
        let (from, later) = self.eventual_names(variable);
        let bound = Name { text: self.bound_name(variable), span: variable.span };
        let mut there = Substitution::default();
        there.replace(&variable.text, &value(&later));
        let absolute = |e: &Expr| {
            let e = there.expr(e).map_err(|obstacle| refused(obstacle, variable, e.span))?;
            let square = at(ExprKind::Power(Box::new(e), Box::new(number(2))));
            Ok::<_, Box<Diagnostic>>(at(ExprKind::Apply(Name { text: "sqrt".to_string(), span }, vec![square])))
        };
        let multiple = at(ExprKind::Product(vec![(Factor::Times, value(&bound)), (Factor::Times, absolute(size)?)]));
        let holds = prop(PropKind::Compare(vec![absolute(of)?, multiple], vec![Relation::LessEqual]));
        let binding = |name: &Name, natural: bool, relation: Relation, least: Expr| {
            Binding::new(vec![(name.clone(), None)], natural, vec![Constraint::Relation(relation, least)], span)
        };
        let later = binding(&later, natural, Relation::GreaterEqual, value(&from));
        let from_there = prop(PropKind::ForAll(vec![later], Box::new(holds)));
        let some = vec![
            binding(&bound, false, Relation::Greater, number(0)),
            binding(&from, natural, Relation::Greater, number(0)),
        ];
        Ok(prop(PropKind::Exists(some, Box::new(from_there))))
    }

    /// The name of a factor that is found for a variable.
    fn bound_name(&mut self, variable: &Name) -> String {
        let fresh = &mut self.fresh;
        let name = || fresh.name(&format!("{}_bound", variable.text));
        self.bounds.entry(variable.text.clone()).or_insert_with(name).clone()
    }

    /// The names of a value from which on something holds, and of one that is greater.
    fn eventual_names(&mut self, variable: &Name) -> (Name, Name) {
        let made = self.made.entry(variable.text.clone()).or_insert_with(|| {
            let name = |end: &str| format!("{}_{end}", variable.text);
            (self.fresh.name(&name("from")), self.fresh.name(&name("later")))
        });
        let name = |text: &str| Name { text: text.to_string(), span: variable.span };
        (name(&made.0), name(&made.1))
    }
}

/// The function near a point, on one side or on both, by a variable that grows.
fn near(of: &Expr, variable: &Name, point: &Expr, side: Option<Sign>) -> Result<Vec<Expr>, Box<Diagnostic>> {
    let size = walk::nodes_in(of).saturating_mul(walk::nodes_in(point));
    if size > NODES_LIMIT {
        let limit = Fault::Limit { name: "nodes of a limit at a point", allowed: NODES_LIMIT };
        return Err(Box::new(Diagnostic::new(limit, point.span)));
    }
    let at = |kind: ExprKind| Expr { kind, span: variable.span };
    let one = at(ExprKind::Number("1".to_string()));
    let name = at(ExprKind::Name(variable.text.clone()));
    let step = at(ExprKind::Product(vec![(Factor::Times, one), (Factor::Over, name)]));
    let is_zero = matches!(&point.kind, ExprKind::Number(text) if text == "0");
    let sides = match side {
        Some(side) => vec![side],
        None => vec![Sign::Plus, Sign::Minus],
    };
    let of_side = |sign: Sign| {
        let value = match (is_zero, sign) {
            (false, _) => at(ExprKind::Sum(vec![(Sign::Plus, point.clone()), (sign, step.clone())])),
            (true, Sign::Plus) => step.clone(),
            (true, Sign::Minus) => at(ExprKind::Negate(Box::new(step.clone()))),
        };
        let mut map = Substitution::default();
        map.replace(&variable.text, &value);
        map.expr(of).map_err(|obstacle| refused(obstacle, variable, point.span))
    };
    sides.into_iter().map(of_side).collect()
}

/// One expression less another.
fn difference(a: &Expr, b: &Expr) -> Expr {
    Expr { kind: ExprKind::Sum(vec![(Sign::Plus, a.clone()), (Sign::Minus, b.clone())]), span: a.span }
}

fn fault(message: String, help: &str, span: Span) -> Box<Diagnostic> {
    Box::new(Diagnostic::new(Fault::Other { message, help: Some(help.to_string()) }, span))
}

/// Why something is not put into a limit.
fn refused(obstacle: Obstacle, variable: &Name, span: Span) -> Box<Diagnostic> {
    match obstacle {
        Obstacle::Capture(name) => {
            let message = format!("{name} means one thing in the point and another inside the limit");
            fault(message, "give one of them another name", span)
        }
        Obstacle::Moves(name) => {
            let message = format!("a derivative by {name} inside a limit by {} cannot be read", variable.text);
            fault(message, "write the derivative out", span)
        }
        Obstacle::NotAFunction(name) => fault(format!("{name} is not a function"), "write a product with `*`", span),
        Obstacle::Limit(_) => {
            let limit = Fault::Limit { name: "nodes of a limit at a point", allowed: NODES_LIMIT };
            Box::new(Diagnostic::new(limit, span))
        }
    }
}
