//! Witnesses that depend on variables, for `exists` over linear comparisons, in cases where no single one suffices.
//!
//! Method: [`super::elimination`] says for which values of the other variables a value of x makes the goal true. A value that
//! does wherever the facts hold is taken; else the order of two bounds of x is distinguished, and each case has its own value. The
//! instance is a goal like any other, so that inner quantifiers are treated in the same way.
//!
//! Limits: [`CANDIDATES`] values of a variable, [`DEPTH`] nested cases, [`FACTS`] facts, and the limits of elimination.

use super::elimination::{Formula, PROGRAMS, and, at, candidates, eliminated, not, orders, satisfiable};
use super::formulas::Reader;
use super::{Fail, Prover, implies};
use crate::algebra::Polynomial;
use crate::certificate::Label;
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, name, numeral, prop, sum};

/// The most values that are tried for a variable.
const CANDIDATES: usize = 40;

/// The most cases within one another.
const DEPTH: usize = 3;

/// The most orders of bounds that are tried for a case.
const ORDERS: usize = 10;

/// The most facts that are read.
const FACTS: usize = 40;

/// Shows a goal at a point.
type Leaf<'l> = dyn FnMut(&mut Prover, Vec<(String, Expr)>) -> Result<Label, Fail> + 'l;

/// Values of variables, in cases.
enum Plan {
    /// These.
    Values(Vec<(u32, Polynomial)>),
    /// One plan where the polynomial is not negative, the other where it is.
    Cases(Polynomial, Box<Plan>, Box<Plan>),
}

/// Whether a formula holds wherever what is assumed does.
fn holds(assumed: &Formula, f: &Formula, programs: &mut usize) -> Option<bool> {
    Some(!satisfiable(&and(vec![assumed.clone(), not(f)]), programs)?)
}

/// Values for these letters that make a formula true wherever what is assumed holds.
fn plan(assumed: &Formula, names: &[u32], f: &Formula, depth: usize, programs: &mut usize) -> Option<Plan> {
    let Some((x, rest)) = names.split_first() else {
        return holds(assumed, f, programs)?.then(|| Plan::Values(Vec::new()));
    };
    let others = rest.iter().rev().fold(f.clone(), |f, y| Formula::Exists(*y, Box::new(f)));
    let open = eliminated(&others)?;
    let somewhere = eliminated(&Formula::Exists(*x, Box::new(open.clone())))?;
    if !holds(assumed, &somewhere, programs)? {
        return None;
    }
    for value in candidates(&open, *x).into_iter().take(CANDIDATES) {
        if !holds(assumed, &at(&open, *x, &value), programs)? {
            continue;
        }
        let found = plan(assumed, rest, &at(f, *x, &value), depth, programs)?;
        return Some(with(found, *x, &value));
    }
    if depth == 0 {
        return None;
    }
    for order in orders(&open, *x).into_iter().take(ORDERS) {
        let above = Formula::Atom(order.clone(), super::elimination::Sense::NotNegative);
        let sides = [and(vec![assumed.clone(), above.clone()]), and(vec![assumed.clone(), not(&above)])];
        if !satisfiable(&sides[0], programs)? || !satisfiable(&sides[1], programs)? {
            continue;
        }
        let [first, second] = &sides;
        if let Some(high) = plan(first, names, f, depth - 1, programs)
            && let Some(low) = plan(second, names, f, depth - 1, programs)
        {
            return Some(Plan::Cases(order, Box::new(high), Box::new(low)));
        }
    }
    None
}

/// A plan with one more value.
fn with(plan: Plan, x: u32, value: &Polynomial) -> Plan {
    match plan {
        Plan::Values(mut list) => {
            list.insert(0, (x, value.clone()));
            Plan::Values(list)
        }
        Plan::Cases(p, high, low) => Plan::Cases(p, Box::new(with(*high, x, value)), Box::new(with(*low, x, value))),
    }
}

impl Prover {
    /// The facts without quantifiers that are read, all of them together.
    fn assumed(&mut self, reader: &mut Reader, more: &[&Prop]) -> Formula {
        let facts = self.facts();
        let plain =
            facts.iter().map(|f| &*f.1).filter(|p| !matches!(p.kind, PropKind::ForAll(..) | PropKind::Exists(..)));
        let read = plain.chain(more.iter().copied()).filter_map(|p| eliminated(&reader.read(p, true)?));
        let mut list: Vec<Formula> = read.take(FACTS).collect();
        for n in &self.naturals {
            let letter = reader.letters.of(&name(n));
            list.push(Formula::Atom(Polynomial::variable(letter), super::elimination::Sense::NotNegative));
        }
        and(list)
    }

    /// Values, in cases, for the variables of a formula `exists …`, where what is assumed holds.
    fn planned(&mut self, reader: &mut Reader, mut f: Formula, more: &[&Prop], count: usize) -> Option<Plan> {
        let mut names = Vec::new();
        while names.len() < count
            && let Formula::Exists(x, body) = f
        {
            names.push(x);
            f = *body;
        }
        let assumed = self.assumed(reader, more);
        plan(&assumed, &names, &eliminated(&f)?, DEPTH, &mut PROGRAMS.clone())
    }

    /// Proves `exists` by values from elimination.
    pub(super) fn by_elimination(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a linear witness");
        let mut reader = Reader::default();
        let f = reader.read(goal, true).ok_or_else(no)?;
        let count = bindings.iter().map(|b| b.names.len()).sum();
        let plan = self.planned(&mut reader, f, &[], count).ok_or_else(no)?;
        let splits = std::mem::take(&mut self.splits);
        let shown = self
            .attempt(|c| c.follow_plan(goal, &reader, &plan, &mut |c, point| c.by_values(goal, bindings, body, point)));
        self.splits = splits;
        shown
    }

    /// Proves `not for all` by values for which the body fails.
    pub(super) fn by_failing_instance(&mut self, goal: &Prop, every: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a linear instance that fails");
        let PropKind::ForAll(bindings, body) = &every.kind else { return Err(no()) };
        let absurd = compare(numeral(0), Relation::Greater, numeral(0));
        let at = |c: &mut Prover, block: &str, point| {
            c.instance_at(&format!("{block}s"), point)?;
            c.refuted(&absurd)
        };
        let mut reader = Reader::default();
        let count = bindings.iter().map(|b| b.names.len()).sum();
        let plan = reader.read(goal, true).and_then(|f| self.planned(&mut reader, f, &[], count));
        let mut points = self.natural_points(goal, bindings, body);
        points.extend(self.example(bindings, &prop(PropKind::Not(body.clone()))));
        let shown = self.attempt(|c| {
            let block = c.block(&implies(every, &absurd), |c, block| {
                if let Some(plan) = &plan
                    && let Ok(label) =
                        c.attempt(|c| c.follow_plan(&absurd, &reader, plan, &mut |c, point| at(c, block, point)))
                {
                    return Ok(label);
                }
                points.into_iter().find_map(|point| c.attempt(|c| at(c, block, point)).ok()).ok_or_else(no)
            })?;
            c.logic(&[&block], goal)
        });
        shown.or_else(|_| self.attempt(|c| c.by_example_without(goal, every)))
    }

    /// Proves a comparison by an instance of a fact `for all` that its opposite contradicts.
    pub(super) fn by_linear_instance(&mut self, goal: &Prop, label: &str, every: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a linear instance");
        let PropKind::ForAll(bindings, _) = &every.kind else { return Err(no()) };
        let other = super::facts::opposite(goal).ok_or_else(no)?;
        let mut reader = Reader::default();
        let f = reader.read(every, false).ok_or_else(no)?;
        let count = bindings.iter().map(|b| b.names.len()).sum();
        let plan = self.planned(&mut reader, f, &[&other], count).ok_or_else(no)?;
        self.against_opposite(goal, |c, _| {
            c.follow_plan(goal, &reader, &plan, &mut |c, point| {
                c.instance_at(label, point)?;
                c.refuted(goal)
            })
        })
    }

    /// A goal in the cases of a plan.
    fn follow_plan(&mut self, goal: &Prop, reader: &Reader, plan: &Plan, leaf: &mut Leaf<'_>) -> Result<Label, Fail> {
        match plan {
            Plan::Values(list) => {
                let mut point = Vec::new();
                for (x, value) in list {
                    let Some(Expr { kind: ExprKind::Name(n), .. }) = reader.letters.expr(*x) else {
                        return Err(Fail::No("a name"));
                    };
                    point.push((n.clone(), reader.letters.written(value)));
                }
                leaf(self, point)
            }
            Plan::Cases(p, high, low) => {
                let e = reader.letters.written(p);
                let mut cases = Vec::new();
                for (relation, plan) in [(Relation::GreaterEqual, high), (Relation::Less, low)] {
                    let case = compare(e.clone(), relation, numeral(0));
                    cases.push(self.block(&implies(&case, goal), |c, _| c.follow_plan(goal, reader, plan, leaf))?);
                }
                self.logic(&cases.iter().map(String::as_str).collect::<Vec<_>>(), goal)
            }
        }
    }

    /// A few values for a natural number: numbers, the variables in reach, what the variable is compared with, and one more
    /// than these.
    fn natural_points(&self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Vec<Vec<(String, Expr)>> {
        let [Binding { names, natural: true, .. }] = bindings else { return Vec::new() };
        let [(variable, None)] = names.as_slice() else { return Vec::new() };
        let mut used = std::collections::BTreeSet::new();
        crate::kernel::names::names_in_prop(goal, &mut used);
        let plus_one = |e: &Expr| sum(vec![(Sign::Plus, e.clone()), (Sign::Plus, numeral(1))]);
        let mut values = vec![numeral(0), numeral(1), numeral(2)];
        let reach = self.naturals.iter().filter(|n| used.contains(*n)).take(3).map(|n| name(n));
        let mut sides = Vec::new();
        super::integers::all_sides(body, &mut sides);
        let is_value = |e: &Expr| !matches!(e.kind, ExprKind::Name(_)) && !super::limits::holds(e, &variable.text);
        let compared = sides.into_iter().filter(|e| is_value(e) && self.is_whole(e)).take(3);
        for e in reach.chain(compared) {
            values.extend([e.clone(), plus_one(&e)]);
        }
        values.into_iter().map(|value| vec![(variable.text.clone(), value)]).collect()
    }

    /// Proves `exists` over natural numbers by a few values.
    pub(super) fn by_natural_values(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        for point in self.natural_points(goal, bindings, body) {
            let splits = std::mem::replace(&mut self.splits, 9);
            let shown = self.attempt(|c| c.by_values(goal, bindings, body, point));
            self.splits = splits;
            if shown.is_ok() {
                return shown;
            }
        }
        Err(Fail::No("a natural witness"))
    }
}
