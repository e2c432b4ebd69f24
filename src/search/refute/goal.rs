//! The goal of a claim at a point: whether it holds there, fails or stays open.
//!
//! Contract: [`Seen::Holds`] and [`Seen::Fails`] are certain. The formulas of derivatives are made before, limits are found at the
//! point.

use super::dependence::{differentiates, ties_what_moves};
use super::evaluate::Assignment;
use super::expand::{Statement, parts};
use super::limit::{Tends, tends};
use super::number::Missing;
use super::outcome::Broken;
use super::reading::Reading;
use super::search::{Plan, Search};
use super::solve::ways;
use crate::claim::print;
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, name};
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};
use std::rc::Rc;

/// At how many points limits are found anew.
pub(super) const LIMITS: usize = 60;

/// A goal made ready to be looked at, point by point.
pub(super) struct Goal {
    /// What is to hold, as the claim says it.
    pub(super) prop: Prop,
    /// The same with derivatives carried out, where there are any: it is asked where a derivative has no value by its formula.
    plain: Option<Prop>,
    /// Formulas of the derivatives in it, as printed.
    derivatives: Rc<HashMap<String, Expr>>,
    identities: Rc<HashSet<(String, String)>>,
    pub(super) limits_left: usize,
}

/// What a goal is at a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Seen {
    /// It certainly holds.
    Holds,
    /// It certainly fails, or has no value.
    Fails(Vec<Broken>),
    /// The point does not decide it.
    Open,
}

/// The points of a statement and its goal at them; `None` where a point says nothing of what moves.
pub(super) fn aimed(plan: &mut Plan, statement: &Statement) -> Option<(Search, Goal)> {
    let mut search = Search::new(&statement.bindings, Some(statement));
    let (mut goal, mut bound) = (statement.goal.clone(), statement.bindings.clone());
    // Quantifiers in front and the variables of an extremum are searched like the others.
    loop {
        goal = match goal.kind {
            PropKind::ForAll(bindings, body) => {
                search.declare(&bindings);
                bound.extend(bindings);
                *body
            }
            PropKind::Extremum(extremum) => {
                let mut at = crate::kernel::substitution::Substitution::default();
                for (name, value) in &extremum.at {
                    at.replace(&name.text, value);
                }
                let there = at.expr(&extremum.of).ok()?;
                search.declare(&extremum.over);
                bound.extend(extremum.over.iter().cloned());
                let relation = if extremum.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
                let mut list = vec![
                    compare(there, Relation::Equal, extremum.value.clone()),
                    compare(extremum.of.clone(), relation, extremum.value.clone()),
                ];
                if extremum.unique {
                    let same =
                        extremum.at.iter().map(|(n, e)| compare(name(&n.text), Relation::Equal, e.clone())).collect();
                    let equal = compare(extremum.of, Relation::Equal, extremum.value);
                    let kind = PropKind::Implies(
                        Box::new(equal),
                        Box::new(Prop { kind: PropKind::And(same), span: goal.span }),
                    );
                    list.push(Prop { kind, span: goal.span });
                }
                Prop { kind: PropKind::And(list), span: goal.span }
            }
            kind => {
                goal = Prop { kind, span: goal.span };
                break;
            }
        };
    }
    if ties_what_moves(statement, &bound, &goal) {
        return None;
    }
    // Where a premise has equations, the points at which it holds are tried first.
    if let (PropKind::Implies(premise, _), Some(reading)) = (&goal.kind, &mut plan.reading) {
        let held: Vec<Prop> = search.hypotheses.iter().cloned().chain([(**premise).clone()]).collect();
        search.follow(&ways(reading, &held, &search.real()));
    }
    search.follow(&plan.ways);
    let (mut plain, mut derivatives) = (None, HashMap::default());
    if let Some(reading) = &mut plan.reading
        && differs(&goal)
    {
        plain = Some(without_derivatives(reading, &goal));
        formulas(reading, &goal, &mut derivatives);
    }
    let derivatives = Rc::new(derivatives);
    Some((search, Goal { prop: goal, plain, derivatives, identities: Rc::default(), limits_left: LIMITS }))
}

impl Goal {
    /// Finds the comparisons whose sides are one: intervals cannot tell that they are equal.
    pub(super) fn identify(&mut self, reading: &mut Reading) {
        self.identities = Rc::new(identities(reading, &self.prop));
    }

    /// What it is at a point, which keeps the members of families that were looked up.
    pub(super) fn at(&mut self, point: &Assignment) -> Seen {
        point.seen.borrow_mut().clear();
        let (identities, derivatives) = (self.identities.clone(), self.derivatives.clone());
        let here = Assignment { identities, derivatives, ..point.clone() };
        let mut broken = Vec::new();
        let truth = if has_limit(&self.prop) {
            self.limits_left = self.limits_left.saturating_sub(1);
            let said = with_limits(&here, self.plain.as_ref().unwrap_or(&self.prop), self.limits_left > 0, &mut broken);
            said.map_err(|missing| if self.plain.is_some() { Missing::Unknown } else { missing })
        } else {
            self.truth(&here, &mut broken)
        };
        let seen = match truth {
            Ok(true) => Seen::Holds,
            Ok(false) => Seen::Fails(broken),
            Err(Missing::Undefined(text)) => {
                Seen::Fails(vec![Broken { statement: text, left: "no value".to_string(), right: String::new() }])
            }
            Err(_) => Seen::Open,
        };
        point.seen.replace(here.seen.take());
        seen
    }

    /// The truth of a goal without limits, and what of it fails.
    fn truth(&self, here: &Assignment, broken: &mut Vec<Broken>) -> std::result::Result<bool, Missing> {
        let said = here.truth(&self.prop);
        let (truth, words) = match &self.plain {
            // The formula of a derivative may have no value where the derivative has one.
            Some(plain) if said == Err(Missing::Unknown) => (here.truth(plain).map_err(|_| Missing::Unknown), plain),
            _ => (said, &self.prop),
        };
        if truth == Ok(false) {
            here.broken(words, broken);
        }
        truth
    }
}

/// The truth of a goal that says limits, and what of it fails; limits are left open unless `sought`.
fn with_limits(
    here: &Assignment,
    prop: &Prop,
    sought: bool,
    broken: &mut Vec<Broken>,
) -> std::result::Result<bool, Missing> {
    match &prop.kind {
        PropKind::And(list) => {
            let parts: Vec<_> = list.iter().map(|p| with_limits(here, p, sought, broken)).collect();
            match parts.iter().find(|p| **p != Ok(true)) {
                _ if parts.contains(&Ok(false)) => Ok(false),
                Some(Err(missing)) => Err(missing.clone()),
                _ => Ok(true),
            }
        }
        PropKind::Limit(limit) if sought => {
            let value = here.number(&limit.value)?;
            let left = match tends(here, limit).ok_or(Missing::Unknown)? {
                Tends::Infinitely => "no limit".to_string(),
                Tends::To(found) => match found.order(&value) {
                    None => return Err(Missing::Unknown),
                    Some(std::cmp::Ordering::Equal) => return Ok(true),
                    _ => found.text(),
                },
            };
            broken.push(if left == "no limit" {
                let statement = "the expression grows beyond every bound: it has no finite limit".to_string();
                Broken { statement, left, right: String::new() }
            } else {
                let statement = format!("the limit is {left}, not {}", value.text());
                Broken { statement, left, right: String::new() }
            });
            Ok(false)
        }
        PropKind::Limit(_) => Err(Missing::Unknown),
        _ => {
            let truth = here.truth(prop);
            if truth == Ok(false) {
                here.broken(prop, broken);
            }
            truth
        }
    }
}

/// The proposition with derivatives carried out, where that succeeds: the evaluator knows none.
fn without_derivatives(reading: &mut Reading, prop: &Prop) -> Prop {
    let mut each = |list: &[Prop]| list.iter().map(|p| without_derivatives(reading, p)).collect::<Vec<_>>();
    let kind = match &prop.kind {
        PropKind::And(list) => PropKind::And(each(list)),
        PropKind::Or(list) => PropKind::Or(each(list)),
        PropKind::Equivalent(list) => PropKind::Equivalent(each(list)),
        PropKind::Implies(p, q) => {
            PropKind::Implies(Box::new(without_derivatives(reading, p)), Box::new(without_derivatives(reading, q)))
        }
        PropKind::Compare(sides, relations) => {
            let plain = |e: &Expr| if differentiates(e) { reading.plain(e) } else { None };
            let sides = sides.iter().map(plain).zip(sides).map(|(plain, e)| plain.unwrap_or_else(|| e.clone()));
            PropKind::Compare(sides.collect(), relations.clone())
        }
        other => other.clone(),
    };
    Prop { kind, span: prop.span }
}

/// The formulas of the derivatives in the comparisons of a goal.
fn formulas(reading: &mut Reading, prop: &Prop, out: &mut HashMap<String, Expr>) {
    match &prop.kind {
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| formulas(reading, p, out));
        }
        PropKind::Not(p) => formulas(reading, p, out),
        PropKind::Implies(p, q) => [p, q].into_iter().for_each(|p| formulas(reading, p, out)),
        PropKind::Compare(sides, _) => sides.iter().for_each(|e| formulas_in(reading, e, out)),
        PropKind::Exists(..)
        | PropKind::ForAll(..)
        | PropKind::Extremum(_)
        | PropKind::Limit(_)
        | PropKind::WrittenLimit(_) => {}
    }
}

fn formulas_in(reading: &mut Reading, e: &Expr, out: &mut HashMap<String, Expr>) {
    parts(e, &mut |part| formulas_in(reading, part, out));
    if let ExprKind::Derivative(..) = &e.kind
        && let Some(formula) = reading.plain(e).filter(|formula| !differentiates(formula))
    {
        out.insert(print::expr(e), formula);
    }
}

/// Whether a comparison of a goal has a derivative in it.
fn differs(prop: &Prop) -> bool {
    match &prop.kind {
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().any(differs),
        PropKind::Implies(p, q) => differs(p) || differs(q),
        PropKind::Compare(sides, _) => sides.iter().any(differentiates),
        _ => false,
    }
}

/// The comparisons in a proposition whose two sides have one form: intervals cannot tell that they are equal.
fn identities(reading: &mut Reading, prop: &Prop) -> HashSet<(String, String)> {
    let mut found = HashSet::default();
    let mut open = vec![prop];
    while let Some(prop) = open.pop() {
        match &prop.kind {
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => open.extend(list),
            PropKind::Not(p) => open.push(p),
            PropKind::Implies(p, q) => open.extend([&**p, &**q]),
            PropKind::Compare(sides, _) => {
                for pair in sides.windows(2).filter(|pair| reading.same(&pair[0], &pair[1])) {
                    found.insert((print::expr(&pair[0]), print::expr(&pair[1])));
                }
            }
            _ => {}
        }
    }
    found
}

fn has_limit(prop: &Prop) -> bool {
    match &prop.kind {
        PropKind::And(list) => list.iter().any(has_limit),
        PropKind::Limit(_) => true,
        _ => false,
    }
}
