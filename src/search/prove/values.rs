//! Facts about letters: powers of roots, and the definitions of members of sequences, of sums and of products.

use super::letters::whole_power;
use super::{Fail, Prover, put};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, numeral};
use crate::kernel::substitution::Substitution;
use malachite::Rational;
use std::collections::BTreeSet;
use std::rc::Rc;

/// The sum or product of a body over an index.
pub(super) fn over(is_sum: bool, index: Index, body: &Expr) -> Expr {
    let body = Box::new(body.clone());
    expr(if is_sum { ExprKind::SumOver(index, body) } else { ExprKind::ProductOver(index, body) })
}

/// a + b, or a·b.
fn joined(is_sum: bool, a: Expr, b: Expr) -> Expr {
    expr(if is_sum {
        ExprKind::Sum(vec![(Sign::Plus, a), (Sign::Plus, b)])
    } else {
        ExprKind::Product(vec![(Factor::Times, a), (Factor::Times, b)])
    })
}

/// The body where the index has a value.
fn member(index: &Index, body: &Expr, value: &Expr) -> Result<Expr, Fail> {
    let mut map = Substitution::default();
    map.replace(&index.name.text, value);
    map.expr(body).map_err(Fail::from)
}

/// How deep members are unfolded into members.
const UNFOLDINGS: usize = 200;

impl Prover {
    /// Proves a proposition with little effort: without cases, and with small linear programs only.
    pub(crate) fn quietly(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let splits = std::mem::replace(&mut self.splits, 9);
        let shown = self.attempt(|c| c.show(goal));
        self.splits = splits;
        shown
    }

    /// Shows a comparison with known inequalities, but without cases.
    pub(super) fn without_cases(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let splits = std::mem::replace(&mut self.splits, 3);
        let shown = self.show(goal);
        self.splits = splits;
        shown
    }

    /// What the letters in these expressions stand for, each once.
    pub(super) fn letters_in(&mut self, exprs: &[&Expr]) -> Vec<Expr> {
        let mut letters = BTreeSet::new();
        for e in exprs {
            let reading = self.read(e, false);
            letters.extend(reading.iter().flat_map(|r| &r.factors).flat_map(|f| f.poly.variables()));
        }
        letters.into_iter().filter_map(|v| self.letters.expr(v).cloned()).collect()
    }

    /// Adds facts about the letters in these expressions.
    pub(crate) fn enrich(&mut self, exprs: &[&Expr]) {
        self.write_powers(exprs);
        for _ in 0..12 {
            let mut changed = false;
            for e in self.letters_in(exprs) {
                let key = key::expr(&e);
                if matches!(&e.kind, ExprKind::Name(n) if self.is_a_name(n))
                    || self.failed.contains(&key)
                    || !self.enriched.insert(key.clone())
                {
                    continue;
                }
                match self.learn(&e) {
                    Ok(put_in) => changed |= put_in,
                    Err(_) => {
                        // Under another supposition it may succeed.
                        self.enriched.remove(&key);
                        self.failed.insert(key);
                    }
                }
            }
            if !changed {
                return;
            }
        }
    }

    /// Adds the facts that hold for a letter by its form. Returns whether an equation was substituted.
    fn learn(&mut self, e: &Expr) -> Result<bool, Fail> {
        match &e.kind {
            ExprKind::Power(base, exponent) => self.learn_power(e, base, exponent),
            ExprKind::Apply(name, at) if name.text == "exp" && at.len() == 1 => {
                let exponent = at[0].clone();
                self.exponential(e, &exponent).map(|()| false)
            }
            ExprKind::Apply(name, at) if matches!(name.text.as_str(), "cos" | "sin") && at.len() == 1 => {
                self.learn_circle(&at[0].clone())
            }
            ExprKind::Apply(name, at) if matches!(name.text.as_str(), "arcsin" | "arctan") && at.len() == 1 => {
                self.learn_arc(e)
            }
            ExprKind::Name(_) => self.learn_pi().map(|()| false),
            ExprKind::Apply(name, at) if at.len() == 1 => self.learn_member(e, name, &at[0]),
            ExprKind::SumOver(index, body) => self.learn_over(e, true, index, body),
            ExprKind::ProductOver(index, body) => self.learn_over(e, false, index, body),
            ExprKind::IntegralOver(variable, body) => self.learn_integral(variable, body),
            _ => Ok(false),
        }
    }

    /// Of a root: its power that is free of roots.
    fn learn_power(&mut self, e: &Expr, base: &Expr, exponent: &Expr) -> Result<bool, Fail> {
        let Some(q) = self.read(exponent, false).filter(|r| r.factors.is_empty()) else {
            return Ok(false);
        };
        let (Ok(n), Ok(d)) = (i64::try_from(q.number.numerator_ref()), i64::try_from(q.number.denominator_ref()))
        else {
            return Ok(false);
        };
        let n = if q.number < 0 { -n } else { n };
        if !(2..=8).contains(&d) {
            return Ok(false);
        }
        let base = base.clone();
        self.define(e);
        self.enrich(&[&base]);
        let known = compare(whole_power(e.clone(), d), Relation::Equal, whole_power(base, n));
        if self.emit(Rule::Power, known.clone()).is_err() {
            if n != 1 {
                return Err(Fail::No("a power of a root"));
            }
            self.attempt(|c| c.root_of_sum(e, d, &known))?;
        }
        self.roots_together(e, d);
        Ok(false)
    }

    /// Of a member of a sequence: what it is by the member before.
    fn learn_member(&mut self, e: &Expr, name: &Name, at: &Expr) -> Result<bool, Fail> {
        let sequence = self.checker.statement().sequences.iter().find(|s| s.name == name.text).cloned();
        let Some(u) = sequence else { return Ok(false) };
        let index = self.letters.polynomial(at).ok_or(Fail::No("an index"))?;
        let right = if index.is_zero() {
            u.initial.clone()
        } else if index.constant_term() >= 1 {
            let before = self.letters.written(&index.sub(&Polynomial::one()));
            let mut map = Substitution::default();
            map.replace(&u.index, &before);
            map.expr(&u.step).map_err(Fail::from)?
        } else {
            return Ok(false);
        };
        self.unfolded(e, &right)
    }

    /// Of a sum or product over an index: what it is by one that is shorter.
    fn learn_over(&mut self, e: &Expr, is_sum: bool, index: &Index, body: &Expr) -> Result<bool, Fail> {
        let (Some(from), Some(to)) = (self.letters.polynomial(&index.from), self.letters.polynomial(&index.to)) else {
            return Ok(false);
        };
        let length = to.sub(&from).add(&Polynomial::one());
        let right = if length.is_zero() {
            numeral(u32::from(!is_sum))
        } else if to.constant_term() >= 1 && length.as_constant().is_none_or(|l| l > 0 && l < 12) {
            let shorter = Index { to: Box::new(self.letters.written(&to.sub(&Polynomial::one()))), ..index.clone() };
            let last = member(index, body, &index.to)?;
            joined(is_sum, over(is_sum, shorter, body), last)
        } else if length.as_constant().is_some_and(|l| l > 0 && l < 12) {
            let next = self.letters.written(&from.add(&Polynomial::one()));
            let later = Index { from: Box::new(next), ..index.clone() };
            let first = member(index, body, &index.from)?;
            joined(is_sum, first, over(is_sum, later, body))
        } else {
            return self.learn_longer(e, is_sum, index, body, (&from, &to));
        };
        self.define(&right);
        let shown = self.unfolded(e, &right);
        self.instantiate(&[&right]);
        shown
    }

    /// Of a sum or product beside one with one member more or less at an end: the longer by the shorter.
    fn learn_longer(
        &mut self,
        e: &Expr,
        is_sum: bool,
        index: &Index,
        body: &Expr,
        (from, to): (&Polynomial, &Polynomial),
    ) -> Result<bool, Fail> {
        let moved = |p: &Polynomial, by: i32| p.add(&Polynomial::constant(Rational::from(by)));
        for (at_start, at_end) in [(-1, 0), (1, 0), (0, 1), (0, -1)] {
            let (first, last) = (moved(from, at_start), moved(to, at_end));
            let (first, last) = (self.letters.written(&first), self.letters.written(&last));
            let at = Index { from: Box::new(first.clone()), to: Box::new(last.clone()), ..index.clone() };
            let other = over(is_sum, at, body);
            if !self.letters.knows(&other) {
                continue;
            }
            let is_shorter = at_end < at_start;
            let (long, short) = if is_shorter { (e, &other) } else { (&other, e) };
            let place = match (at_end == 0, is_shorter) {
                (true, true) => &*index.from,
                (true, false) => &first,
                (false, true) => &*index.to,
                (false, false) => &last,
            };
            let one = member(index, body, place)?;
            let right =
                if at_end == 0 { joined(is_sum, one, short.clone()) } else { joined(is_sum, short.clone(), one) };
            return self.unfolded(long, &right);
        }
        Ok(false)
    }

    fn unfolded(&mut self, e: &Expr, right: &Expr) -> Result<bool, Fail> {
        if self.unfoldings >= UNFOLDINGS {
            return Err(Fail::Limit("members unfolded"));
        }
        self.unfoldings += 1;
        self.enrich(&[right]);
        self.unfoldings -= 1;
        let shown = compare(e.clone(), Relation::Equal, right.clone());
        let label = self.emit(Rule::Unfold, shown)?;
        self.put_in(&label);
        Ok(true)
    }

    /// (a^(1/d))^d = a, where a has a negative number before it or is a square: by a name for a.
    fn root_of_sum(&mut self, e: &Expr, d: i64, known: &Prop) -> Result<(), Fail> {
        let ExprKind::Power(base, exponent) = &e.kind else { return Err(Fail::No("a root")) };
        let b = crate::kernel::statement::name(&self.fresh("r"));
        let named = self.emit(Rule::Name, compare((**base).clone(), Relation::Equal, b.clone()))?;
        let term = |label: &str, k: i64| crate::certificate::Term {
            facts: vec![label.to_string()],
            factor: crate::refute::literal::literal(&Rational::from(k)),
        };
        let own = crate::certificate::Term { facts: Vec::new(), factor: (**base).clone() };
        for relation in [Relation::Greater, Relation::GreaterEqual] {
            let sign = compare(b.clone(), relation, numeral(0));
            if self.combination(sign, vec![term(&named, -1), own.clone()]).is_ok() {
                break;
            }
        }
        let root = expr(ExprKind::Power(Box::new(b.clone()), exponent.clone()));
        let same =
            self.emit(Rule::Monotone { from: named.clone() }, compare(e.clone(), Relation::Equal, root.clone()))?;
        let power = self.emit(Rule::Power, compare(whole_power(root, d), Relation::Equal, b))?;
        let equations = std::mem::replace(&mut self.equations, vec![same]);
        let shown = self.combination(known.clone(), vec![term(&power, 1), term(&named, -1)]);
        self.equations = equations;
        shown.map(|_| ())
    }

    /// What is known of a root together with others: bounds of a root of a number, products of roots.
    fn roots_together(&mut self, e: &Expr, d: i64) {
        let ExprKind::Power(base, exponent) = &e.kind else { return };
        // Roots of 0 are compared with nothing: quotients of these numbers follow.
        let number = |c: &mut Self, base: &Expr| {
            let reading = c.read(base, false).filter(|r| r.factors.is_empty())?;
            Some(reading.number).filter(|number| *number != 0)
        };
        let Some(own) = number(self, base) else { return };
        if let Some((low, high)) = enclosed_root(&own, d) {
            for (relation, bound) in [(Relation::Greater, low), (Relation::Less, high)] {
                let _ = self.quietly(&compare(e.clone(), relation, crate::refute::literal::literal(&bound)));
            }
        }
        let others: Vec<(Expr, Expr)> = self
            .roots
            .iter()
            .filter_map(|r| match &r.kind {
                ExprKind::Power(b, q) if q == exponent => Some((r.clone(), (**b).clone())),
                _ => None,
            })
            .collect();
        for (i, (x, a)) in others.iter().enumerate() {
            let Some(a) = number(self, a) else { continue };
            for (y, b) in others.iter().skip(i + 1) {
                let Some(b) = number(self, b) else { continue };
                let triples = [(e, x, y, &own * &a / &b), (e, y, x, &own * &b / &a), (x, y, e, &a * &b / &own)];
                for (p, q, r, square) in triples {
                    let Some((root, true)) = root_of(&square, d) else { continue };
                    let times = |list: Vec<Expr>| super::letters::product(list);
                    let right = times(vec![crate::refute::literal::literal(&root), r.clone()]);
                    let _ = self.emit(Rule::Power, compare(times(vec![p.clone(), q.clone()]), Relation::Equal, right));
                }
            }
            if let Some((root, true)) = root_of(&(&own / &a), d) {
                let right = super::letters::product(vec![crate::refute::literal::literal(&root), x.clone()]);
                let _ = self.emit(Rule::Power, compare(e.clone(), Relation::Equal, right));
            }
        }
        self.roots.push(e.clone());
    }

    /// Substitutes an equation in all later steps, if the kernel can.
    pub(crate) fn put_in(&mut self, label: &str) {
        let Some(fact) = self.fact(label) else { return };
        let equations = self.equations.clone();
        if self.checker.can_be_put_in(&fact, &equations) {
            self.equations.push(label.to_string());
        }
    }

    /// Uses the equations among the facts to write a variable by others.
    pub(crate) fn solve_equations(&mut self) {
        let facts: Vec<(Label, Rc<Prop>)> = self
            .checker
            .facts()
            .filter(|(_, p)| matches!(&p.kind, PropKind::Compare(_, r) if *r == [Relation::Equal]))
            .map(|(l, p)| (l.to_string(), p.clone()))
            .collect();
        for (label, fact) in facts {
            let written = matches!(&fact.kind, PropKind::Compare(sides, _) if stands_alone(sides));
            let before = self.equations.len();
            if written && !self.equations.contains(&label) {
                self.put_in(&label);
            }
            if self.equations.len() == before {
                let _ = self.attempt(|c| c.solve(&label, &fact));
            }
        }
    }

    fn solve(&mut self, label: &str, fact: &Prop) -> Result<(), Fail> {
        let known = self.known_of(label, fact).ok_or(Fail::No("an equation"))?;
        let variables = known.poly.variables();
        for v in variables.into_iter().rev() {
            let Some(e) = self.letters.expr(v).cloned() else { continue };
            let ExprKind::Name(name) = &e.kind else { continue };
            // π is written by no variable: cosines and sines are read by their multiples of π.
            if self.naturals.contains(name) || !self.is_a_name(name) {
                continue;
            }
            let parts = known.poly.coefficients_in(v);
            let [constant, slope] = parts.as_slice() else { continue };
            if !self.stays_whole(name, constant, slope) {
                continue;
            }
            let slope_expr = self.letters.written(slope);
            if !self.signs_of(&slope_expr).within(Signs::NOT_ZERO) {
                continue;
            }
            // The variable must not be inside another letter of the value.
            let value = expr(ExprKind::Product(vec![
                (Factor::Times, self.letters.written(&constant.neg())),
                (Factor::Over, slope_expr.clone()),
            ]));
            let mut names = BTreeSet::new();
            crate::kernel::names::names_in(&value, &mut names);
            if names.contains(name) {
                continue;
            }
            let shown = compare(e.clone(), Relation::Equal, value);
            let mut factors = vec![whole_power(slope_expr, -1)];
            factors.extend(known.factors.iter().cloned());
            let term =
                crate::certificate::Term { facts: known.facts.clone(), factor: super::letters::product(factors) };
            let new = match self.known(&shown) {
                Some(new) => new,
                None => self.combination(shown, vec![term])?,
            };
            self.put_in(&new);
            return Ok(());
        }
        Err(Fail::No("a variable to write by others"))
    }
}

/// Whether the first of two sides is a member of a family that does not occur in the other.
fn stands_alone(sides: &[Expr]) -> bool {
    let [left, right] = sides else { return false };
    let ExprKind::Apply(f, list) = &left.kind else { return false };
    list.len() == 1 && !is_built_in(&f.text) && !super::sums::occurs(left, right)
}

/// The d-th root of a positive number, rounded down to six places, and whether it is exact.
pub(crate) fn root_of(q: &Rational, d: i64) -> Option<(Rational, bool)> {
    let (n, m) = (i64::try_from(q.numerator_ref()).ok()?, i64::try_from(q.denominator_ref()).ok()?);
    if *q <= 0 {
        return None;
    }
    let exact = |k: i64| {
        (0..10_000i64)
            .find(|r| r.checked_pow(u32::try_from(d).unwrap_or(1)).is_none_or(|p| p >= k))
            .filter(|r| r.pow(u32::try_from(d).unwrap_or(1)) == k)
    };
    if let (Some(a), Some(b)) = (exact(n), exact(m)) {
        return Some((Rational::from(a) / Rational::from(b), true));
    }
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)]
    let near = ((n as f64 / m as f64).powf(1.0 / d as f64) * 1e6).floor() as i64;
    Some((Rational::from(near) / Rational::from(1_000_000), false))
}

/// Bounds of the d-th root of a number.
fn enclosed_root(q: &Rational, d: i64) -> Option<(Rational, Rational)> {
    let (near, _) = root_of(q, d).filter(|r| !r.1)?;
    let step = Rational::from(1) / Rational::from(100_000);
    Some((&near - &step, near + step))
}

/// A proposition at the next number.
pub(crate) fn at_next(p: &Prop, name: &str) -> Result<Prop, Fail> {
    let next = expr(ExprKind::Sum(vec![(Sign::Plus, crate::kernel::statement::name(name)), (Sign::Plus, numeral(1))]));
    put(p, name, &next)
}
