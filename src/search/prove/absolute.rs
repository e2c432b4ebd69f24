//! Absolute values, and with them `min` and `max`, as roots of squares.
//!
//! Method: sqrt(q^2) is q if q >= 0, and −q otherwise. The search distinguishes cases by the signs of the factors of q until
//! the sign of q is known. It starts with the innermost absolute value and replaces each by q or −q.

use super::comparison::single;
use super::facts::{minus, opposite};
use super::letters::{as_power, natural, product, whole_power};
use super::values::root_of;
use super::{Fail, Prover, implies};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, numeral, prop};
use crate::refute::literal::literal;
use malachite::Rational;
use std::rc::Rc;

/// Largest number of signs distinguished along one branch.
const DEPTH: usize = 6;

/// An absolute value: the letter for sqrt(q^2), and q as a number times powers of polynomials.
struct Absolute {
    root: Expr,
    number: Expr,
    factors: Vec<(Expr, i64)>,
}

impl Absolute {
    fn inside(&self) -> Expr {
        let powers = self.factors.iter().map(|(f, k)| whole_power(f.clone(), *k));
        product(std::iter::once(self.number.clone()).chain(powers).collect())
    }
}

impl Prover {
    /// Proves a comparison that contains absolute values.
    pub(crate) fn by_absolute_values(&mut self, goal: &Prop) -> Result<Label, Fail> {
        if self.next_absolute(goal, &[]).is_none() {
            return Err(Fail::No("an absolute value"));
        }
        self.in_signs_with(8, goal)
    }

    /// Proves a goal by the signs inside its absolute values, each case with the effort of one below so many others.
    fn in_signs_with(&mut self, splits: usize, goal: &Prop) -> Result<Label, Fail> {
        self.attempt(|c| {
            let before = std::mem::replace(&mut c.splits, splits);
            let shown = c.in_signs(goal, &mut Vec::new(), 0);
            c.splits = before;
            shown
        })
    }

    /// Proves a comparison in which absolute values are written. Cases cost less here than products of facts. A side that is an
    /// absolute value is squared as well, with the effort of a goal.
    pub(crate) fn by_written_absolute_values(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, _, b) = single(goal)?;
        if self.splits >= 3 || !(has_absolute(a) || has_absolute(b)) {
            return Err(Fail::No("an absolute value"));
        }
        // Where facts speak of the same absolute values, or of those of the members before, their signs may not matter.
        if self.inductions == 0 && self.looks_back() {
            for n in self.candidates(goal) {
                if let Ok(label) = self.on_its_own(|c| c.show_by_induction_on(goal, &n)) {
                    return Ok(label);
                }
            }
        }
        for degree in 0..=1 {
            if let Ok(label) = self.attempt(|c| c.by_products(goal, degree)) {
                return Ok(label);
            }
        }
        if let Ok(label) = self.attempt(|c| c.by_two_bounds(goal)) {
            return Ok(label);
        }
        let mut first = self.by_absolute_values(goal);
        if first.is_err() && self.splits == 0 && (has_application(a) || has_application(b)) {
            // What stands there besides may need a slope.
            first = self.in_signs_with(1, goal);
        }
        if first.is_ok() || self.splits > 0 || !(is_absolute(a) || is_absolute(b)) {
            return first;
        }
        self.attempt(|c| c.by_squares(goal)).or(first)
    }

    /// |E| <= F by E <= F and -E <= F, where E is no variable: its sign may be unknown, or need cases by itself.
    fn by_two_bounds(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("an absolute value as the smaller side");
        let is_turned = relation.is_greater().ok_or_else(no)?;
        let (small, relation, great) = if is_turned { (b, relation.turned(), a) } else { (a, relation, b) };
        let (square, half) = as_power(small).ok_or_else(no)?;
        let (inside, two) = as_power(&square).ok_or_else(no)?;
        let is_root = self.letters.number(&half).is_some_and(|k| k == Rational::from_unsigneds(1u32, 2));
        if !is_root || natural(&two) != Some(2) || matches!(inside.kind, ExprKind::Name(_)) {
            return Err(no());
        }
        let negated = expr(ExprKind::Negate(Box::new(inside.clone())));
        let mut bounds = Vec::new();
        for side in [&inside, &negated] {
            bounds.push(self.in_signs_with(3, &compare(side.clone(), relation, great.clone()))?);
        }
        let same_way = if is_turned { -1 } else { 1 };
        let values = [(Relation::GreaterEqual, &inside), (Relation::Less, &negated)];
        let by_the_sign = self.attempt(|c| {
            let mut from = Vec::new();
            for ((sign, value), bound) in values.into_iter().zip(&bounds) {
                let case = implies(&compare(inside.clone(), sign, numeral(0)), goal);
                from.push(c.block(&case, |c, _| {
                    // Before anything gives the square a name.
                    let root = c.emit(Rule::Power, compare(small.clone(), Relation::Equal, value.clone()))?;
                    let factor = literal(&Rational::from(same_way));
                    let term = |fact: &Label| Term { facts: vec![fact.clone()], factor: factor.clone() };
                    c.combination(goal.clone(), vec![term(&root), term(bound)])
                })?);
            }
            c.emit(Rule::Logic { from }, goal.clone())
        });
        by_the_sign.or_else(|_| self.by_absolute_values(goal))
    }

    /// Proves a goal after the signs inside some absolute values are known; `known` holds the keys of these.
    fn in_signs(&mut self, goal: &Prop, known: &mut Vec<String>, depth: usize) -> Result<Label, Fail> {
        let Some(found) = self.next_absolute(goal, known) else { return self.show(goal) };
        let settled = |s: Signs| s.within(Signs::NOT_NEGATIVE) || s.within(Signs::of(Relation::LessEqual));
        let mut negative = false;
        for (factor, k) in &found.factors {
            let signs = self.signs_of(factor);
            if k % 2 == 0 || signs.within(Signs::NOT_NEGATIVE) {
                continue;
            }
            if settled(signs) {
                negative = !negative;
                continue;
            }
            if depth >= DEPTH {
                return Err(Fail::Limit("cases"));
            }
            let case = compare(factor.clone(), Relation::GreaterEqual, numeral(0));
            let other = opposite(&case).ok_or(Fail::No("an opposite"))?;
            let length = known.len();
            let mut branch = |c: &mut Self, case: &Prop| {
                let shown = c.block(&implies(case, goal), |c, _| c.in_signs(goal, known, depth + 1));
                known.truncate(length);
                shown
            };
            let x = branch(self, &case)?;
            let y = branch(self, &other)?;
            return self.logic(&[&x, &y], goal);
        }
        let inside = found.inside();
        let value = if negative { expr(ExprKind::Negate(Box::new(inside))) } else { inside };
        let equal = compare(found.root.clone(), Relation::Equal, value.clone());
        let shown = self.emit(Rule::Power, equal.clone()).or_else(|_| {
            // (root − q)·(root + q) = 0, of which the first factor is positive where q is negative.
            let apart = compare(minus(&found.root, &found.inside()), Relation::Greater, numeral(0));
            let negative =
                found.factors.iter().enumerate().filter(|(_, (_, k))| *k == 1).find_map(|(place, (f, _))| {
                    Some((place, self.known(&compare(f.clone(), Relation::Less, numeral(0)))?))
                });
            if let Some((place, label)) = negative {
                let others = found.factors.iter().enumerate().filter(|(i, _)| *i != place);
                let powers = others.map(|(_, (f, k))| whole_power(f.clone(), *k));
                let number = expr(ExprKind::Negate(Box::new(found.number.clone())));
                let factor = product(std::iter::once(number).chain(powers).collect());
                let root = Term { facts: Vec::new(), factor: found.root.clone() };
                let _ = self.combination(apart, vec![Term { facts: vec![label], factor }, root]);
            }
            self.quietly(&equal)
        })?;
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(Fail::No("a comparison")) };
        let plain: Vec<Expr> = sides.iter().map(|e| self.with_sign(e, &found.root, &value)).collect();
        self.put_in(&shown);
        known.push(key::expr(&found.root));
        if plain == *sides {
            return self.in_signs(goal, known, depth);
        }
        // Methods that read the goal as it is written see the value.
        let plain = prop(PropKind::Compare(plain, relations.clone()));
        let shown = self.in_signs(&plain, known, depth)?;
        self.combination(goal.clone(), vec![Term { facts: vec![shown], factor: numeral(1) }])
    }

    /// An expression with a value for one of its absolute values.
    fn with_sign(&mut self, e: &Expr, root: &Expr, value: &Expr) -> Expr {
        if is_absolute(e) && self.read(&minus(e, root), false).is_some_and(|r| r.number == 0) {
            return value.clone();
        }
        let mut out = e.clone();
        crate::claim::walk::parts_mut(&mut out, &mut |part| *part = self.with_sign(part, root, value));
        out
    }

    /// The innermost absolute value of the goal, or else of the facts, that is not among the known ones.
    fn next_absolute(&mut self, goal: &Prop, known: &[String]) -> Option<Absolute> {
        let facts: Vec<Rc<Prop>> = self.checker.facts().map(|(_, p)| p.clone()).collect();
        for p in std::iter::once(goal).chain(facts.iter().map(|p| &**p)) {
            let Some((a, _, b)) = p.single() else { continue };
            let Some(reading) = self.read(&minus(a, b), false) else { continue };
            for f in &reading.factors {
                if let Some(found) = self.absolute_in(&f.poly, known) {
                    return Some(found);
                }
            }
        }
        None
    }

    fn absolute_in(&mut self, poly: &Polynomial, known: &[String]) -> Option<Absolute> {
        for v in poly.variables() {
            let Some(e) = self.letters.expr(v).cloned() else { continue };
            let ExprKind::Power(base, _) = &e.kind else { continue };
            let Some(half) = as_power(&e).and_then(|(_, k)| self.read(&k, false)) else { continue };
            if !half.factors.is_empty() || half.number != malachite::Rational::from_unsigneds(1u32, 2) {
                continue;
            }
            let Some(reading) = self.read(base, false) else { continue };
            for f in &reading.factors {
                if let Some(inner) = self.absolute_in(&f.poly, known) {
                    return Some(inner);
                }
            }
            let even = !reading.factors.is_empty() && reading.factors.iter().all(|f| f.power % 2 == 0);
            let (Some((number, true)), true) = (root_of(&reading.number, 2), even) else { continue };
            if known.contains(&key::expr(&e)) {
                continue;
            }
            let factors = reading.factors.iter().map(|f| (self.letters.written(&f.poly), f.power / 2)).collect();
            return Some(Absolute { root: e, number: literal(&number), factors });
        }
        None
    }
}

fn is_absolute(e: &Expr) -> bool {
    let is_square = |e: &Expr| as_power(e).is_some_and(|(_, k)| natural(&k) == Some(2));
    as_power(e).is_some_and(|(base, exponent)| natural(&exponent).is_none() && is_square(&base))
}

/// Whether a function is applied in an expression.
fn has_application(e: &Expr) -> bool {
    let mut found = matches!(e.kind, ExprKind::Apply(..));
    crate::claim::walk::parts(e, &mut |part| found = found || has_application(part));
    found
}

/// Whether a square root of a square is part of an expression.
pub(super) fn has_absolute(e: &Expr) -> bool {
    let mut found = is_absolute(e);
    crate::refute::expand::parts(e, &mut |part| found = found || has_absolute(part));
    found
}
