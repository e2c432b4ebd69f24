//! Values to try for the variables of a claim, in lists.
//!
//! The usual values are small. Those that a claim suggests are its numerals and their neighbours, numbers between two
//! numerals, Pythagorean ratios for sums of two squares, large and negative values, and for a single variable a fine grid.
//! Far values are large and small powers of ten. Of an angle, multiples of π.

use super::expand::Statement;
use super::number::Number;
use super::search::Search;
use super::turns::Angles;
use crate::claim::syntax::*;
use crate::number::rational;
use malachite::Rational;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Real values in order of simplicity; the perfect powers among them make roots rational.
const USUAL: &[&str] = &[
    "1", "2", "1/2", "0", "3", "4", "1/4", "-1", "-1/2", "1/3", "9", "8", "64", "3/2", "3/4", "1/8", "9/10", "16",
    "1/9", "-2", "1/10", "27", "1/64", "10", "81", "99/100", "100", "729",
];

/// One and values far from it.
const FAR: &[&str] = &["1", "1e6", "1e-6", "1000", "1/1000", "1e12", "1e-12", "-1e6", "-1000", "-1e12", "0", "-1"];

/// The same for natural numbers.
const FAR_NATURALS: &[u32] = &[1, 100, 1_000_000, 1000, 20, 0, 2];

/// Natural numbers that the usual list leaves out.
const NATURALS: &[u32] =
    &[8, 9, 10, 11, 12, 13, 14, 15, 16, 20, 24, 25, 32, 50, 64, 100, 128, 200, 256, 400, 500, 700, 1000];

/// Reals that the usual list leaves out.
const OTHERS: &[&str] = &[
    "3/5", "4/5", "5", "6", "7", "-3", "-4", "-5", "12", "13", "5/13", "12/13", "2/3", "1/5", "-1/4", "-3/2", "3/10",
    "7/10", "1/100", "1000", "-10", "-1000", "1000000", "-1000000",
];

/// Multiples of π that an angle is tried at: where sines and cosines are 0, 1, -1, or equal, first.
const TURNS: &[&str] = &[
    "1", "0", "1/2", "2", "1/3", "2/3", "1/6", "5/6", "3/2", "-1", "1/4", "3/4", "-1/2", "3", "4", "4/3", "5/3", "5/4",
    "7/4", "7/6", "11/6", "-2", "1/12", "5/12", "-1/3", "-1/6", "2/5", "1/5", "4/5", "1/8", "6", "5", "-3", "8", "10",
];

/// Values for real variables and for natural ones, the likeliest first, and what of them the variables of a search may have.
pub(super) struct Values {
    lists: [Vec<Rational>; 2],
    /// The variables that multiples of π are tried for.
    angles: Angles,
    /// The first value that a variable or member may have, by name.
    first: BTreeMap<String, Option<Rc<[Rational]>>>,
    /// All of them.
    all: BTreeMap<String, Rc<[Rational]>>,
}

impl Values {
    fn new(lists: [Vec<Rational>; 2]) -> Values {
        Values { lists, angles: Angles::new(), first: BTreeMap::new(), all: BTreeMap::new() }
    }

    /// Small values, and simple multiples of π for these angles.
    pub(super) fn turned(angles: Angles) -> Values {
        Values { angles, ..Values::usual() }
    }

    /// Small values.
    pub(super) fn usual() -> Values {
        Values::new([parsed(USUAL).collect(), (0..8).map(Rational::from).collect()])
    }

    /// Values that the claim suggests.
    pub(super) fn suggested(statement: &Statement) -> Values {
        Values::new(suggested(statement))
    }

    /// Small values, and where a domain has none of them, those that the claim suggests.
    pub(super) fn small(statement: &Statement) -> Values {
        Values::followed(Values::usual().lists, suggested(statement))
    }

    /// Far values, and where a domain has none of them, those that the claim suggests.
    pub(super) fn far(statement: &Statement) -> Values {
        let naturals = FAR_NATURALS.iter().map(|n| Rational::from(*n)).collect();
        Values::followed([parsed(FAR).collect(), naturals], suggested(statement))
    }

    fn followed(first: [Vec<Rational>; 2], then: [Vec<Rational>; 2]) -> Values {
        let mut then = then.into_iter();
        Values::new(first.map(|list| distinct(list.into_iter().chain(then.next().unwrap_or_default()).collect())))
    }

    /// The first value that a variable, or the members of a family, may have.
    pub(super) fn first(&mut self, search: &Search, name: &str, natural: bool) -> Option<Rc<[Rational]>> {
        if !self.first.contains_key(name) {
            let found = self.allowed(search, name, natural).next().map(|value| Rc::from([value]));
            self.first.insert(name.to_string(), found);
        }
        self.first.get(name).cloned().flatten()
    }

    /// All values that a variable, or the members of a family, may have.
    pub(super) fn of(&mut self, search: &Search, name: &str, natural: bool) -> Rc<[Rational]> {
        if let Some(found) = self.all.get(name) {
            return found.clone();
        }
        let found: Rc<[Rational]> = self.allowed(search, name, natural).collect();
        self.all.insert(name.to_string(), found.clone());
        found
    }

    /// Its values that the bounds allow.
    fn allowed<'a>(
        &'a self,
        search: &'a Search,
        name: &'a str,
        natural: bool,
    ) -> Box<dyn Iterator<Item = Rational> + 'a> {
        if let Some(way) = self.angles.get(name) {
            return Box::new(parsed(TURNS).filter(|turns| search.allows_turned(way, name, turns)));
        }
        let list = self.lists[usize::from(natural)].iter();
        Box::new(list.filter(|value| search.allows(name, Number::Exact((*value).clone()))).cloned())
    }
}

fn parsed(list: &[&str]) -> impl Iterator<Item = Rational> {
    list.iter().filter_map(|text| rational::parse(text).ok())
}

/// Values that the claim suggests, for real variables and for natural ones.
fn suggested(statement: &Statement) -> [Vec<Rational>; 2] {
    let mut numerals = Vec::new();
    for binding in &statement.bindings {
        in_constraints(binding, &mut numerals);
    }
    statement.assumptions.iter().for_each(|(_, p)| in_prop(p, &mut numerals));
    in_prop(&statement.goal, &mut numerals);
    numerals.sort();
    numerals.dedup();
    let fraction = |n: i32, d: i32| Rational::from_signeds(n, d);
    let mut reals: Vec<Rational> = numerals.clone();
    reals.extend(numerals.windows(2).map(|pair| (&pair[0] + &pair[1]) / Rational::from(2)));
    for c in &numerals {
        reals.push(-c);
        for step in [fraction(1, 1), fraction(1, 10), fraction(1, 100)] {
            reals.extend([c + &step, c - &step, -c - &step, &step - c]);
        }
    }
    // Quotients: the roots of linear factors.
    for p in &numerals {
        for q in numerals.iter().filter(|q| **q != 0) {
            reals.extend([p / q, -(p / q)]);
        }
    }
    reals.extend(parsed(OTHERS));
    let mut naturals: Vec<Rational> = (0..8).map(Rational::from).collect();
    naturals.extend(
        numerals
            .iter()
            .filter(|c| **c >= 0 && *c.denominator_ref() == 1u32)
            .flat_map(|c| [c.clone(), c + Rational::from(1)]),
    );
    naturals.extend(NATURALS.iter().map(|n| Rational::from(*n)));
    let names = statement.bindings.iter().flat_map(|b| &b.names).count();
    if names <= 1 {
        reals.extend((1..=200).flat_map(|k| [fraction(k, 10), fraction(-k, 10)]));
        reals.extend((1..=400).flat_map(|k| [fraction(k, 100), fraction(-k, 100)]));
        reals.extend((1..=999).map(|k| fraction(k, 1000)));
    } else {
        reals.truncate(160);
    }
    [distinct(reals), distinct(naturals)]
}

/// The list without repetitions.
fn distinct(list: Vec<Rational>) -> Vec<Rational> {
    let mut seen = std::collections::BTreeSet::new();
    list.into_iter().filter(|q| seen.insert(q.clone())).collect()
}

fn in_constraints(binding: &Binding, out: &mut Vec<Rational>) {
    for constraint in &binding.constraints {
        match constraint {
            Constraint::Relation(_, e) => in_expr(e, out),
            Constraint::Interval { from, to, .. } | Constraint::Range(from, to) => {
                [from, to].into_iter().for_each(|e| in_expr(e, out));
            }
        }
    }
}

fn in_prop(p: &Prop, out: &mut Vec<Rational>) {
    match &p.kind {
        PropKind::Compare(sides, _) => sides.iter().for_each(|e| in_expr(e, out)),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| in_prop(p, out));
        }
        PropKind::Not(p) => in_prop(p, out),
        PropKind::Implies(p, q) => [p, q].into_iter().for_each(|p| in_prop(p, out)),
        PropKind::Exists(bindings, p) | PropKind::ForAll(bindings, p) => {
            bindings.iter().for_each(|b| in_constraints(b, out));
            in_prop(p, out);
        }
        PropKind::Extremum(e) => [&e.of, &e.value].into_iter().for_each(|e| in_expr(e, out)),
        PropKind::Limit(l) => [&l.of, &l.value].into_iter().for_each(|e| in_expr(e, out)),
        PropKind::WrittenLimit(l) => l.parts().for_each(|e| in_expr(e, out)),
    }
}

/// The numerals of an expression, fractions of two of them as one number; not those of exponents.
fn in_expr(e: &Expr, out: &mut Vec<Rational>) {
    match &e.kind {
        ExprKind::Number(text) => out.extend(rational::parse(text)),
        ExprKind::Name(_) => {}
        ExprKind::Apply(_, list) => list.iter().for_each(|e| in_expr(e, out)),
        ExprKind::Negate(a) | ExprKind::Power(a, _) | ExprKind::Derivative(a, _) => in_expr(a, out),
        ExprKind::Sum(list) => list.iter().for_each(|(_, e)| in_expr(e, out)),
        ExprKind::Product(list) => match list.as_slice() {
            [
                (Factor::Times, Expr { kind: ExprKind::Number(p), .. }),
                (Factor::Over, Expr { kind: ExprKind::Number(q), .. }),
            ] => {
                if let (Ok(p), Ok(q)) = (rational::parse(p), rational::parse(q))
                    && q != 0
                {
                    out.push(p / q);
                }
            }
            _ => list.iter().for_each(|(_, e)| in_expr(e, out)),
        },
        ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) | ExprKind::IntegralOver(index, body) => {
            [&*index.from, &*index.to, &**body].into_iter().for_each(|e| in_expr(e, out));
        }
        ExprKind::Matrix(rows) => rows.iter().flatten().for_each(|e| in_expr(e, out)),
    }
}
