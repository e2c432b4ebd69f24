//! Solutions of one equation in one variable between two values at which it fails in opposite directions.
//!
//! Certificate: what the sides are at both values, and the rule `intermediate`; or a witness, where the function is 0 at a place that
//! the signs of its derivative tell. The values are ends of the domain, numbers
//! between them, 1 more than the squares of all other variables, these variables, and small numbers.
//!
//! Limit: [`VALUES`] values of the variable.

use super::facts::minus;
use super::{Fail, Prover};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, domain, expr, name, numeral, power, sum};
use crate::kernel::substitution::Substitution;
use std::collections::BTreeSet;

/// The most values at which the sides are compared.
const VALUES: usize = 16;

/// A value of the variable, and what is shown of the sides there.
struct Side {
    value: Expr,
    relation: Relation,
    fact: Label,
    within: Vec<Label>,
}

impl Prover {
    /// Shows `exists x …: F = G` by two values of x; nothing is tried for other statements.
    pub(super) fn by_intermediate_value(
        &mut self,
        goal: &Prop,
        bindings: &[Binding],
        body: &Prop,
    ) -> Result<Label, Fail> {
        let none = Fail::No("two values between which an equation has a solution");
        let [binding] = bindings else { return Err(none) };
        let ([(variable, None)], false) = (binding.names.as_slice(), binding.natural) else { return Err(none) };
        let Some((left, Relation::Equal, right)) = body.single() else { return Err(none) };
        for place in self.exact_zeros(&minus(left, right), &variable.text) {
            let point = vec![(variable.text.clone(), place)];
            if let Ok(label) = self.attempt(|c| c.by_values(goal, bindings, body, point)) {
                return Ok(label);
            }
        }
        let mut found: Vec<Side> = Vec::new();
        for value in places(binding, variable, [left, right]) {
            let Ok(side) = self.attempt(|c| c.side(binding, variable, [left, right], value)) else { continue };
            let other = found.iter().find(|other| other.relation.is_greater() != side.relation.is_greater());
            let Some(other) = other else {
                found.push(side);
                continue;
            };
            let (a, b) = if side.relation.is_greater() == Some(true) { (other, &side) } else { (&side, other) };
            let with = [("a", a), ("b", b)].map(|(n, side)| (Name::new(n), side.value.clone())).to_vec();
            let facts = [&a.fact, &b.fact].into_iter().chain(&a.within).chain(&b.within);
            let from = facts.cloned().collect();
            if let Ok(label) = self.emit(Rule::Intermediate { with, from }, goal.clone()) {
                return Ok(label);
            }
            found.push(side);
        }
        Err(none)
    }

    /// What is shown of the sides of an equation at a value, and that the value lies in the domain or is an end of it.
    fn side(
        &mut self,
        binding: &Binding,
        variable: &Name,
        [left, right]: [&Expr; 2],
        value: Expr,
    ) -> Result<Side, Fail> {
        let mut map = Substitution::default();
        map.replace(&variable.text, &value);
        let mut within = Vec::new();
        for needed in domain(binding) {
            let needed = map.prop(&needed).map_err(Fail::from)?;
            let label = match (&needed.kind, self.quietly(&needed)) {
                (_, Ok(label)) => label,
                (PropKind::Compare(sides, relations), Err(_)) if sides.len() == 2 => {
                    self.quietly(&compare(sides[0].clone(), relations[0].loose(), sides[1].clone()))?
                }
                (_, Err(fail)) => return Err(fail),
            };
            within.push(label);
        }
        let (left, right) = (map.expr(left).map_err(Fail::from)?, map.expr(right).map_err(Fail::from)?);
        let difference = minus(&left, &right);
        // A number is evaluated, however long it is when it is multiplied out.
        if self.is_of_numbers(&difference) {
            for relation in [Relation::Less, Relation::Greater] {
                let order = compare(left.clone(), relation, right.clone());
                if let Ok(fact) = self.attempt(|c| c.emit(Rule::Evaluate, order)) {
                    return Ok(Side { value, relation, fact, within });
                }
            }
        }
        self.define(&difference);
        if self.read(&difference, false).is_none() {
            return Err(Fail::No("the sides of an equation at a value"));
        }
        let signs = self.signs_of(&difference);
        for relation in [Relation::Less, Relation::Greater, Relation::LessEqual, Relation::GreaterEqual] {
            if !signs.within(Signs::of(relation.negated()))
                && let Ok(fact) = self.attempt(|c| c.without_cases(&compare(left.clone(), relation, right.clone())))
            {
                return Ok(Side { value, relation, fact, within });
            }
        }
        Err(Fail::No("the sides of an equation at a value"))
    }
}

/// The number k sixths of the way from one to another.
fn part_of_the_way(from: &Expr, to: &Expr, k: u32) -> Expr {
    let times =
        |k: u32, e: &Expr| expr(ExprKind::Product(vec![(Factor::Times, numeral(k)), (Factor::Times, e.clone())]));
    let whole = sum(vec![(Sign::Plus, times(6 - k, from)), (Sign::Plus, times(k, to))]);
    expr(ExprKind::Product(vec![(Factor::Times, whole), (Factor::Over, numeral(6))]))
}

/// The variables that an expression mentions, bound ones included.
fn letters_in(e: &Expr, into: &mut BTreeSet<String>) {
    if let ExprKind::Name(letter) = &e.kind {
        into.insert(letter.clone());
    }
    crate::claim::walk::parts(e, &mut |part| letters_in(part, into));
}

/// Values at which the sides may differ in opposite directions.
fn places(binding: &Binding, variable: &Name, sides: [&Expr; 2]) -> Vec<Expr> {
    let (mut places, mut inside) = (Vec::new(), Vec::new());
    for constraint in &binding.constraints {
        match constraint {
            Constraint::Relation(_, bound) => places.push(bound.clone()),
            Constraint::Interval { from, to, .. } => {
                places.extend([from.clone(), to.clone()]);
                inside.extend([1, 5, 3].map(|k| part_of_the_way(from, to, k)));
            }
            Constraint::Range(..) => {}
        }
    }
    places.append(&mut inside);
    let mut letters = BTreeSet::new();
    sides.into_iter().for_each(|side| letters_in(side, &mut letters));
    letters.remove(&variable.text);
    let negative = |e: &Expr| expr(ExprKind::Negate(Box::new(e.clone())));
    if !letters.is_empty() {
        let squares = letters.iter().map(|letter| (Sign::Plus, power(&name(letter), &numeral(2))));
        let beyond = sum(std::iter::once((Sign::Plus, numeral(1))).chain(squares).collect());
        places.extend([negative(&beyond), beyond]);
        for letter in letters.iter().take(2).map(|letter| name(letter)) {
            let next = |sign| sum(vec![(Sign::Plus, letter.clone()), (sign, numeral(1))]);
            places.extend([next(Sign::Minus), next(Sign::Plus), letter.clone()]);
        }
    }
    places.extend([0, 1, 2, 10].map(numeral));
    places.extend([1, 2, 10].map(|k| negative(&numeral(k))));
    places.truncate(VALUES);
    places
}
