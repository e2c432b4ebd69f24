//! Roots: the root of a product as the product of the roots, and comparisons simplified by r^d = p.
//!
//! Method: each root r satisfies r^d = p, so a polynomial in the roots is divided by r^d − p, one root after the other. An
//! identity leaves the remainder 0; an inequality leaves a simpler one.

use super::comparison::single;
use super::facts::minus;
use super::letters::{product, whole_power};
use super::products::Kind;
use super::squares::{Open, own_relation};
use super::values::root_of;
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, numeral};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::One;

/// A polynomial with a name.
pub(super) struct Named {
    poly: Polynomial,
    name: Expr,
    /// The fact that the name is the polynomial.
    pub(super) value: Label,
}

/// The most divisions for one comparison.
const DIVISIONS: usize = 40;

impl Prover {
    /// Shows a comparison of expressions with roots.
    pub(crate) fn by_radicals(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("a comparison of radicals");
        let mut split = false;
        let mut named = Vec::new();
        for root in self.roots_in(&minus(a, b)) {
            let before = named.len();
            for way in [Prover::denest, Prover::split_root] {
                if self.attempt(|c| way(c, &root, &mut named)).is_ok() {
                    split = true;
                    break;
                }
                named.truncate(before);
            }
        }
        self.enrich(&[a, b]);
        if split && let Ok(label) = self.combination(goal.clone(), Vec::new()) {
            return Ok(label);
        }
        let reading = self.read(&minus(a, b), true).ok_or_else(no)?;
        if relation == Relation::Equal {
            for (place, f) in reading.factors.iter().enumerate().filter(|(_, f)| f.power > 0) {
                let (left, terms) = self.reduced(&f.poly, &named);
                if !left.is_zero() {
                    continue;
                }
                let mut rest = vec![literal(&reading.number)];
                for (i, other) in reading.factors.iter().enumerate() {
                    let power = if i == place { other.power - 1 } else { other.power };
                    rest.push(whole_power(self.letters.written(&other.poly), power));
                }
                return self.combination(goal.clone(), times(terms, &rest));
            }
            return Err(no());
        }
        let open = Open::of(self, &reading).ok_or_else(no)?;
        let own = own_relation(open.signs, relation).ok_or_else(no)?;
        let (left, terms) = self.reduced(&open.poly, &named);
        if terms.is_empty() && !split {
            return Err(no());
        }
        let simpler = self.letters.written(&left);
        let shown = compare(simpler.clone(), own, numeral(0));
        let label = match self.roots_in_full {
            Some(_) => self.compared_in_full(&shown),
            None => self.quietly(&shown).or_else(|_| self.attempt(|c| c.by_squares(&shown))),
        }?;
        let mut all = times(terms, &open.rest);
        all.push(Term { facts: vec![label], factor: product(open.rest) });
        self.combination(goal.clone(), all)
    }

    /// The letters in an expression that are roots.
    pub(crate) fn roots_in(&mut self, e: &Expr) -> Vec<Expr> {
        let mut roots = self.letters_in(&[e]);
        roots.retain(|e| self.degree(e).is_some());
        roots
    }

    /// The d of a root b^(1/d).
    pub(super) fn degree(&mut self, e: &Expr) -> Option<i64> {
        let ExprKind::Power(_, exponent) = &e.kind else { return None };
        let q = self.read(exponent, false).filter(|r| r.factors.is_empty())?.number;
        let d = i64::try_from(q.denominator_ref()).ok()?;
        (q > 0 && *q.numerator_ref() == 1u32 && (2..=8).contains(&d)).then_some(d)
    }

    /// Puts in the product of the roots of factors, none of which is negative, for the root of their product. A factor that the
    /// kernel writes with a negative number before it, as -(v − 1), gets a name.
    pub(super) fn split_root(&mut self, root: &Expr, named: &mut Vec<Named>) -> Result<(), Fail> {
        let no = || Fail::No("a root of a product");
        let d = self.degree(root).ok_or_else(no)?;
        let ExprKind::Power(base, exponent) = &root.kind else { return Err(no()) };
        let reading = self.read(base, true).ok_or_else(no)?;
        let reading = self.split(reading);
        let single = matches!(reading.factors.as_slice(), [f] if f.power == 1 && reading.number == 1);
        if reading.factors.is_empty() || single {
            return Err(no());
        }
        let mut number = reading.number.clone();
        let (mut inside, mut outside) = (Vec::new(), Vec::new());
        let power = |e: Expr| expr(ExprKind::Power(Box::new(e), exponent.clone()));
        for f in &reading.factors {
            let needed = if f.power < 0 { Signs::POSITIVE } else { Signs::NOT_NEGATIVE };
            let poly = self.of_signs(&f.poly, needed).ok_or_else(no)?;
            let turned = poly != f.poly;
            if f.power % 2 != 0 && turned {
                number = -number;
            }
            let e = if turned { self.named(poly, needed, named)? } else { self.letters.written(&poly) };
            inside.push(whole_power(e.clone(), f.power));
            outside.push(if f.power % d == 0 { whole_power(e, f.power / d) } else { whole_power(power(e), f.power) });
        }
        if number <= 0 {
            return Err(no());
        }
        if number != Rational::ONE {
            inside.push(literal(&number));
            outside.push(match root_of(&number, d) {
                Some((exact, true)) => literal(&exact),
                _ => power(literal(&number)),
            });
        }
        let (inside, outside) = (product(inside), product(outside));
        self.define(&outside);
        let shown = compare(root.clone(), Relation::Equal, outside.clone());
        let label = self.emit(Rule::Power, shown.clone()).or_else(|_| {
            let equations = self.equations.len();
            named.iter().for_each(|n| self.put_in(&n.value));
            let from = self.combination(compare((**base).clone(), Relation::Equal, inside.clone()), Vec::new());
            self.equations.truncate(equations);
            let from = from?;
            let same = power(inside.clone());
            let one = self.emit(Rule::Monotone { from }, compare(root.clone(), Relation::Equal, same.clone()))?;
            let two = self.emit(Rule::Power, compare(same, Relation::Equal, outside.clone()))?;
            let term = |label: Label| Term { facts: vec![label], factor: numeral(1) };
            self.combination(shown.clone(), vec![term(one), term(two)])
        })?;
        self.put_in(&label);
        self.enrich(&[&outside]);
        Ok(())
    }

    /// The name of a polynomial of these signs, a new one if it has none yet.
    fn named(&mut self, poly: Polynomial, signs: Signs, named: &mut Vec<Named>) -> Result<Expr, Fail> {
        if let Some(n) = named.iter().find(|n| n.poly == poly) {
            return Ok(n.name.clone());
        }
        let own = self.letters.written(&poly);
        let name = crate::kernel::statement::name(&self.fresh("r"));
        let label = self.emit(Rule::Name, compare(own.clone(), Relation::Equal, name.clone()))?;
        let turned = Term { facts: vec![label], factor: expr(ExprKind::Negate(Box::new(numeral(1)))) };
        let value = self.combination(compare(name.clone(), Relation::Equal, own.clone()), vec![turned.clone()])?;
        let relation = signs.relation().ok_or(Fail::No("a sign"))?;
        let own = Term { facts: Vec::new(), factor: own };
        self.combination(compare(name.clone(), relation, numeral(0)), vec![turned, own])?;
        named.push(Named { poly, name: name.clone(), value });
        Ok(name)
    }

    /// A new name for an expression that is not negative, and the fact that it is the expression.
    pub(super) fn named_not_negative(&mut self, e: &Expr) -> Result<(Expr, Label), Fail> {
        let name = crate::kernel::statement::name(&self.fresh("r"));
        let label = self.emit(Rule::Name, compare(e.clone(), Relation::Equal, name.clone()))?;
        let turned = expr(ExprKind::Negate(Box::new(numeral(1))));
        let terms =
            vec![Term { facts: vec![label.clone()], factor: turned }, Term { facts: Vec::new(), factor: e.clone() }];
        self.combination(compare(name.clone(), Relation::GreaterEqual, numeral(0)), terms)?;
        Ok((name, label))
    }

    /// The polynomial or its opposite, whichever has these signs as the kernel sees or as is shown with little effort.
    fn of_signs(&mut self, poly: &Polynomial, signs: Signs) -> Option<Polynomial> {
        let both = [poly.clone(), poly.neg()];
        let seen = both.iter().find(|p| self.signs_of(&self.letters.written(p)).within(signs)).cloned();
        seen.or_else(|| {
            let relation = signs.relation()?;
            let shown = |p: &Polynomial| compare(self.letters.written(p), relation, numeral(0));
            let shown = both.each_ref().map(shown);
            let place = shown.iter().position(|p| self.quietly(p).is_ok())?;
            both.into_iter().nth(place)
        })
    }

    /// What is left of a polynomial after division by r^d − p for its roots r, and by name − p for what is named; and the terms
    /// that the difference is made of.
    fn reduced(&mut self, poly: &Polynomial, named: &[Named]) -> (Polynomial, Vec<Term>) {
        let (mut left, mut terms) = (poly.clone(), Vec::new());
        for _ in 0..DIVISIONS {
            let Some((quotient, rest, facts, factors)) =
                left.variables().into_iter().find_map(|v| self.divided(&left, v, named))
            else {
                break;
            };
            left = rest;
            let own = self.letters.written(&quotient);
            terms.push(Term { facts, factor: product([own].into_iter().chain(factors).collect()) });
        }
        (left, terms)
    }

    /// A polynomial divided by c·(r^d − p), where a letter stands for r.
    fn divided(
        &mut self,
        poly: &Polynomial,
        v: u32,
        named: &[Named],
    ) -> Option<(Polynomial, Polynomial, Vec<Label>, Vec<Expr>)> {
        let root = self.letters.expr(v).cloned()?;
        let key = crate::kernel::key::expr(&root);
        let on_circle = if self.roots_in_full.is_some() { self.square_on_circle(&root) } else { None };
        let (degree, label, fact) = match named.iter().find(|n| crate::kernel::key::expr(&n.name) == key) {
            Some(n) => (1, n.value.clone(), self.fact(&n.value)?),
            None if on_circle.is_some() => on_circle.map(|(label, fact)| (2, label, fact))?,
            None => {
                let d = self.degree(&root)?;
                let ExprKind::Power(base, _) = &root.kind else { return None };
                let fact = compare(whole_power(root.clone(), d), Relation::Equal, (**base).clone());
                (usize::try_from(d).ok()?, self.known(&fact)?, fact)
            }
        };
        if poly.coefficients_in(v).len() <= degree {
            return None;
        }
        let known = self.known_of(&label, &fact).filter(|k| k.kind == Kind::Zero)?;
        let divisor = known.poly.coefficients_in(v);
        let lead = divisor.last().filter(|_| divisor.len() == degree + 1)?.as_constant()?;
        let (mut quotient, mut rest) = (Polynomial::zero(), poly.clone());
        loop {
            let parts = rest.coefficients_in(v);
            let Some(excess) = parts.len().checked_sub(degree + 1) else { break };
            let first = parts.last()?.scale(&(Rational::ONE / &lead));
            let step = first.try_mul(&Polynomial::variable(v).pow(u32::try_from(excess).ok()?).ok()?).ok()?;
            rest = rest.sub(&step.try_mul(&known.poly).ok()?);
            quotient = quotient.add(&step);
        }
        Some((quotient, rest, known.facts, known.factors))
    }
}

/// Terms with further factors.
fn times(terms: Vec<Term>, rest: &[Expr]) -> Vec<Term> {
    let all = |t: Term| Term { factor: product([t.factor].into_iter().chain(rest.iter().cloned()).collect()), ..t };
    terms.into_iter().map(all).collect()
}
