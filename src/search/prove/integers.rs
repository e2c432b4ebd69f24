//! An integer is a real number.
//!
//! The reader writes an integer k as k_up − k_down with natural numbers. A real number gets a name with `name: k_up - k_down = r`,
//! and `k_up = r + k_down` is put in: every reading is then a polynomial in r, and whatever is shown for reals is shown for
//! integers. What needs whole numbers (`branching`) writes r as the difference again.
//!
//! Cost: two steps for each integer, which the certificate keeps only where they are used.

use super::sign_charts::enclosed;
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::definedness::is_whole;
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::statement::{compare, name, numeral, sum};
use crate::kernel::substitution::Substitution;
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Floor;
use malachite::base::num::conversion::traits::IsInteger;
use std::collections::BTreeSet;

/// The most integers that get a name.
const INTEGERS: usize = 24;

/// k_up and k_down, where an expression is their difference.
pub(super) fn difference(e: &Expr) -> Option<(&str, &str)> {
    let ExprKind::Sum(list) = &e.kind else { return None };
    match list.as_slice() {
        [
            (Sign::Plus, Expr { kind: ExprKind::Name(up), .. }),
            (Sign::Minus, Expr { kind: ExprKind::Name(down), .. }),
        ] => Some((up, down)),
        _ => None,
    }
}

/// The differences of two names in an expression, each once.
fn differences_in(e: &Expr, out: &mut Vec<Expr>) {
    if difference(e).is_some() {
        if !out.iter().any(|d| key::expr(d) == key::expr(e)) {
            out.push(e.clone());
        }
    } else {
        crate::claim::walk::parts(e, &mut |part| differences_in(part, out));
    }
}

/// The sides of all comparisons in a proposition, those under quantifiers too.
pub(super) fn all_sides(p: &Prop, out: &mut Vec<Expr>) {
    match &p.kind {
        PropKind::Exists(_, body) | PropKind::ForAll(_, body) => all_sides(body, out),
        PropKind::Not(inner) => all_sides(inner, out),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| all_sides(p, out));
        }
        PropKind::Implies(a, b) => [a, b].into_iter().for_each(|p| all_sides(p, out)),
        _ => super::goals::sides_in(p, out),
    }
}

impl Prover {
    /// Gives a real name to every integer of the claim, a difference of two natural numbers that are used for nothing else.
    pub(super) fn name_integers(&mut self) {
        let statement = self.checker.statement().clone();
        let mut sides = Vec::new();
        statement.assumptions.iter().chain([&statement.goal]).for_each(|p| all_sides(p, &mut sides));
        let mut found = Vec::new();
        sides.iter().for_each(|e| differences_in(e, &mut found));
        let mut alone: Vec<(Expr, [String; 2])> = Vec::new();
        for d in found {
            let Some((up, down)) = difference(&d) else { continue };
            let pair = [up.to_string(), down.to_string()];
            if pair.iter().all(|n| self.naturals.contains(n)) && up.ends_with("up") && down.ends_with("down") {
                alone.push((d, pair));
            }
        }
        alone.truncate(INTEGERS);
        for (d, [up, down]) in alone {
            let stem = up.trim_end_matches("up").trim_end_matches('_').to_string();
            let _ = self.attempt(|c| c.name_integer(if stem.is_empty() { "k" } else { &stem }, &up, &down, d));
        }
        if !self.integers.is_empty() {
            for (label, fact) in self.facts() {
                let PropKind::Compare(sides, relations) = &fact.kind else { continue };
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let part = compare(pair[0].clone(), *relation, pair[1].clone());
                    let _ = self.attempt(|c| c.beside_whole_numbers(&label, &part));
                }
            }
        }
    }

    /// From a comparison with a number that is not rational, that with the whole number next to it.
    fn beside_whole_numbers(&mut self, label: &str, fact: &Prop) -> Result<(), Fail> {
        let no = || Fail::No("a number between whole numbers");
        let Some((a, relation, b)) = fact.single() else { return Err(no()) };
        let (e, other, relation, sign) = match (self.is_of_numbers(a), self.is_of_numbers(b)) {
            (true, false) => (a, b, relation.turned(), -1),
            (false, true) => (b, a, relation, 1),
            _ => return Err(no()),
        };
        let (low, high) = enclosed(e).ok_or_else(no)?;
        let floor = (&low).floor();
        if low == high || high.floor() != floor {
            return Err(no());
        }
        let floor = Rational::from(floor);
        let (bound, k) = match relation.is_greater() {
            Some(true) => (Relation::Greater, floor),
            Some(false) => (Relation::Less, floor + Rational::from(1)),
            None => return Err(no()),
        };
        let k = literal(&k);
        let label = self.known(fact).map_or_else(|| self.logic(&[label], fact), Ok)?;
        let number = self.emit(Rule::Evaluate, compare(e.clone(), bound, k.clone()))?;
        let shown = compare(other.clone(), bound, k);
        // other − k = (other − e) + (e − k), in which the fact may say e − other.
        let term =
            |label: &Label, sign: i64| Term { facts: vec![label.clone()], factor: literal(&Rational::from(sign)) };
        let terms = vec![term(&label, sign), term(&number, 1)];
        let label = self.combination(shown.clone(), terms)?;
        self.take_in(&label, &shown)
    }

    /// Gives a real name, which is returned, to the difference of two natural numbers.
    pub(super) fn name_integer(&mut self, stem: &str, up: &str, down: &str, d: Expr) -> Result<String, Fail> {
        let fresh = self.fresh(stem);
        let named = self.emit(Rule::Name, compare(d.clone(), Relation::Equal, name(&fresh)))?;
        let whole = sum(vec![(Sign::Plus, name(&fresh)), (Sign::Plus, name(down))]);
        let shown = compare(name(up), Relation::Equal, whole);
        let label = self.combination(shown, vec![Term { facts: vec![named], factor: numeral(1) }])?;
        self.put_in(&label);
        self.integers.push((fresh.clone(), d));
        Ok(fresh)
    }

    /// An expression with every named integer as the difference of natural numbers that it is.
    pub(super) fn in_naturals(&self, e: &Expr) -> Expr {
        let mut map = Substitution::default();
        self.integers.iter().for_each(|(n, d)| map.replace(n, d));
        map.expr(e).unwrap_or_else(|_| e.clone())
    }

    /// Whether an expression is a whole number by its form, named integers included.
    pub(super) fn is_whole(&self, e: &Expr) -> bool {
        let whole = |n: &str| self.naturals.iter().any(|m| m == n) || self.integers.iter().any(|k| k.0 == n);
        is_whole(e, &whole)
    }

    /// Whether −constant/slope, in the place of a name, is whole by its form if the name is.
    pub(super) fn stays_whole(&self, name: &str, constant: &Polynomial, slope: &Polynomial) -> bool {
        let is_unit = slope.as_constant().is_some_and(|c| *c.numerator_ref() == 1u32 && c.is_integer());
        let whole = constant.terms().all(|t| t.1.is_integer())
            && self.whole_letters(constant.variables()).len() == constant.variables().len();
        is_unit && whole || self.integers.iter().all(|k| k.0 != name)
    }

    /// The letters of these that are whole numbers.
    pub(super) fn whole_letters(&self, letters: impl IntoIterator<Item = u32>) -> BTreeSet<u32> {
        letters.into_iter().filter(|v| self.letters.expr(*v).is_some_and(|e| self.is_whole(e))).collect()
    }
}
