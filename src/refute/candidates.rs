//! Values to try for the variables of a claim, read off the claim itself. They are used after the usual values.
//!
//! They are its numerals and their neighbours, numbers between two numerals, Pythagorean ratios for sums of two squares,
//! large and negative values, and for a single variable a fine grid.

use super::expand::Statement;
use crate::claim::syntax::*;
use crate::number::rational;
use malachite::Rational;

/// Natural numbers that the usual list leaves out.
const NATURALS: &[u32] =
    &[8, 9, 10, 11, 12, 13, 14, 15, 16, 20, 24, 25, 32, 50, 64, 100, 128, 200, 256, 400, 500, 700, 1000];

/// Reals that the usual list leaves out.
const REALS: &[&str] = &[
    "3/5", "4/5", "5", "6", "7", "-3", "-4", "-5", "12", "13", "5/13", "12/13", "2/3", "1/5", "-1/4", "-3/2", "3/10",
    "7/10", "1/100", "1000", "-10", "-1000", "1000000", "-1000000",
];

/// Candidates for real variables and for natural ones, the likeliest first.
pub(super) fn suggested(statement: &Statement, goal: &Prop) -> [Vec<Rational>; 2] {
    let mut numerals = Vec::new();
    for binding in &statement.bindings {
        in_constraints(binding, &mut numerals);
    }
    statement.assumptions.iter().for_each(|(_, p)| in_prop(p, &mut numerals));
    in_prop(goal, &mut numerals);
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
    reals.extend(REALS.iter().filter_map(|text| rational::parse(text).ok()));
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
        ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
            [&*index.from, &*index.to, &**body].into_iter().for_each(|e| in_expr(e, out));
        }
        ExprKind::Matrix(rows) => rows.iter().flatten().for_each(|e| in_expr(e, out)),
    }
}
