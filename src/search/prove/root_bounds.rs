//! Inequalities with roots, by bounds that are rational functions: each root lies between a weighted arithmetic and a weighted
//! harmonic mean of its base and a power of any positive Y.
//!
//! Method: for p = m/q between 0 and 1, the inequality between weighted means (Hardy, Littlewood, Pólya, "Inequalities", 1934,
//! theorem 9) says that q·X·Y^m/((q − m)·X + m·Y^q) <= X^p <= (m·X + (q − m)·Y^q)/(q·Y^(q − m)), with equality at X = Y^q. Y has the
//! value of the root where all variables are equal: there most inequalities of this kind are equations. It is a number, or has the
//! degree of the root: the factors of which X is a power, times a power of the sum of the variables, a symmetric form, or the linear
//! form that has the slopes of the root there (the tangent).
//!
//! A root may stand within sums, products, quotients and powers of what is not negative: a bound of a part gives one of the whole.
//! Choices of Y for which the bounds are too wide fail at a trial point (`trial_points`).
//!
//! Certificate: the bounds from the inside to the outside, the inequality between them without roots, and a combination of these.
//!
//! Limits: [`VARIABLES`] positive variables, [`ROOTS`] roots, [`CHOICES`] choices of Y for each of [`KINDS`] kinds of roots, and
//! [`ATTEMPTS`] proofs.

use super::comparison::single;
use super::facts::{Factored, negated, power_of, scaled};
use super::letters::{as_power, natural, product, total, whole_power};
use super::limits::over;
use super::squares::has_a_root;
use super::{Fail, Prover};
use crate::algebra::{Polynomial, Univariate};
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, name, numeral, sum};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::CheckedRoot;
use malachite::base::num::basic::traits::{One, Zero};

/// The most variables, roots, choices of Y for a kind of roots, kinds with choices of their own, and proofs that are tried.
const VARIABLES: usize = 4;
const ROOTS: usize = 8;
const CHOICES: usize = 9;
const KINDS: usize = 3;
const ATTEMPTS: usize = 4;

/// The variables, and their value where they are equal.
struct Equal {
    variables: Vec<u32>,
    at: Rational,
}

/// A root X^(m/q), on which side it is bounded, and what its Y may be.
struct Root {
    written: Expr,
    up: bool,
    base: Expr,
    m: u32,
    q: u32,
    forms: Vec<Expr>,
    /// Roots of one kind have one choice.
    kind: usize,
}

/// Roots, with a choice of Y for each kind.
struct Bounds<'a> {
    roots: &'a [Root],
    choice: &'a [usize],
}

impl Prover {
    /// Shows an inequality with roots of positive variables, read without equations: those may write variables by roots.
    pub(super) fn by_root_bounds(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let equations = std::mem::take(&mut self.equations);
        let shown = self.attempt(|c| c.by_bounds_at(goal, &equations));
        self.equations = equations;
        shown
    }

    fn by_bounds_at(&mut self, goal: &Prop, equations: &[Label]) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("roots of positive variables");
        let is_greater = relation.is_greater().ok_or_else(no)?;
        // The bounds themselves are shown with less effort.
        if self.splits >= 3 || ![a, b].into_iter().any(has_a_root) {
            return Err(no());
        }
        let mut names = std::collections::BTreeSet::new();
        crate::kernel::names::names_in_prop(goal, &mut names);
        names.retain(|n| self.is_a_name(n));
        let names: Vec<Expr> = names.iter().map(|n| name(n)).collect();
        let positive = names.iter().all(|e| self.signs_of(e).within(Signs::POSITIVE));
        if !positive || !(1..=VARIABLES).contains(&names.len()) {
            return Err(no());
        }
        let variables: Vec<u32> = names.iter().map(|e| self.letters.of(e)).collect();
        let equal = Equal { at: self.where_all_are_equal(&variables), variables };
        let (greater, less) = if is_greater { (a, b) } else { (b, a) };
        let mut roots = Vec::new();
        for (e, up) in [(greater, false), (less, true)] {
            self.roots_to_bound(e, up, &equal, &mut roots).ok_or_else(no)?;
        }
        if roots.is_empty() || roots.len() > ROOTS {
            return Err(no());
        }
        let order = if is_greater { relation } else { relation.turned() };
        let trial = self.trial_points(&equal.variables, &equal.at);
        let mut attempts = 0;
        for choice in choices(&roots) {
            let bounds = Bounds { roots: &roots, choice: &choice };
            let (above, below) = (bounds.of(greater, false), bounds.of(less, true));
            if trial.deny(&above, &below) {
                continue;
            }
            attempts += 1;
            let shown = self.attempt(|c| {
                let mut terms = Vec::new();
                for (e, up) in [(greater, false), (less, true)] {
                    terms.extend(c.shown_bound(&bounds, e, up, equations)?);
                }
                let rational = compare(above, order, below);
                let shown = c.attempt(|c| c.by_differences(&rational, 0..=1));
                let shown = shown.or_else(|_| c.attempt(|c| c.by_sums_of_squares(&rational)));
                terms.push(shown.or_else(|_| c.without_roots(&rational))?);
                let sign = |e: Expr, same: bool| if same { e } else { negated(e) };
                let is_below = |c: &Prover, label: &Label| {
                    c.fact(label).and_then(|f| f.single().map(|s| s.1.is_greater() == Some(false))).unwrap_or(false)
                };
                let terms = terms.iter().map(|t| scaled(t, sign(numeral(1), is_greater != is_below(c, t)))).collect();
                c.combination(goal.clone(), terms)
            });
            if shown.is_ok() || attempts == ATTEMPTS {
                return shown;
            }
        }
        Err(no())
    }

    /// An inequality of rational functions in positive variables, or of exponentials. No equation is put in: those of roots would bring
    /// these back.
    pub(super) fn without_roots(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let equations = std::mem::take(&mut self.equations);
        let shown = self
            .attempt(|c| c.without_cases(goal))
            .or_else(|_| self.attempt(|c| c.by_differences(goal, 1..=3)))
            .or_else(|_| self.attempt(|c| c.by_sums_of_squares(goal)))
            .or_else(|_| self.attempt(|c| c.by_tangents(goal)));
        self.equations = equations;
        shown
    }

    /// The value of all variables where they are equal, by an equation between them, or 1.
    fn where_all_are_equal(&mut self, variables: &[u32]) -> Rational {
        let known = self.all_known(&[]);
        let zeros = known.iter().filter(|k| k.kind == super::products::Kind::Zero).map(|k| &k.poly);
        let about = zeros.filter(|p| !p.is_constant() && p.variables().iter().all(|v| variables.contains(v)));
        let mut places = about.filter_map(|p| {
            let one = p.substitute_all(&|_| Some(Polynomial::variable(0))).ok()?;
            Univariate::from_polynomial(&one, 0)?.rational_roots().into_iter().find(|t| *t > 0)
        });
        places.next().unwrap_or(Rational::ONE)
    }

    /// The roots of an expression that is bounded from above or below; none if a root stands where a bound of it gives none.
    fn roots_to_bound(&mut self, e: &Expr, up: bool, equal: &Equal, out: &mut Vec<Root>) -> Option<()> {
        if !has_a_root(e) || self.is_of_numbers(e) {
            return Some(());
        }
        match &e.kind {
            ExprKind::Negate(a) => self.roots_to_bound(a, !up, equal, out),
            ExprKind::Sum(list) => {
                list.iter().try_for_each(|(sign, e)| self.roots_to_bound(e, up == (*sign == Sign::Plus), equal, out))
            }
            ExprKind::Product(list) => list.iter().try_for_each(|(factor, e)| {
                let times = *factor == Factor::Times;
                let due = if times { Signs::NOT_NEGATIVE } else { Signs::POSITIVE };
                self.signs_of(e).within(due).then_some(())?;
                self.roots_to_bound(e, up == times, equal, out)
            }),
            ExprKind::Power(base, exponent) if natural(exponent).is_some() => {
                self.signs_of(base).within(Signs::NOT_NEGATIVE).then_some(())?;
                self.roots_to_bound(base, up, equal, out)
            }
            _ => {
                if !out.iter().any(|r| r.up == up && r.written == *e) {
                    let mut root = self.root(e, up, equal)?;
                    let alike = |r: &&Root| (r.up, r.m, r.q, r.forms.len()) == (up, root.m, root.q, root.forms.len());
                    let last = out.iter().map(|r| r.kind + 1).max().unwrap_or(0);
                    root.kind = out.iter().find(alike).map_or(last.min(KINDS - 1), |r| r.kind);
                    out.push(root);
                }
                Some(())
            }
        }
    }

    /// A root of what is rational in the variables, with what its Y may be.
    fn root(&mut self, e: &Expr, up: bool, equal: &Equal) -> Option<Root> {
        let (base, exponent) = as_power(e)?;
        let p = self.letters.number(&exponent).filter(|p| *p > 0 && *p < 1)?;
        let (m, q) = (u32::try_from(p.numerator_ref()).ok()?, u32::try_from(p.denominator_ref()).ok()?);
        let reading = self.read(&base, true)?;
        let is_plain = |p: &Polynomial| p.variables().iter().all(|v| equal.variables.contains(v));
        if q > 4 || reading.number <= 0 || !reading.factors.iter().all(|f| is_plain(&f.poly)) {
            return None;
        }
        let reading = self.split(reading);
        let forms = self.forms_of_root(&reading.number, &reading.factors, q, equal)?;
        Some(Root { written: e.clone(), up, base, m, q, forms, kind: 0 })
    }

    /// What equals the q-th root of a product where all variables are equal: of its degree, or a number.
    fn forms_of_root(&self, number: &Rational, factors: &[Factored], q: u32, equal: &Equal) -> Option<Vec<Expr>> {
        let whole = |power: i64| power / i64::from(q);
        let left = |f: &Factored| f.power - whole(f.power) * i64::from(q);
        let value = |p: &Polynomial| p.evaluate(&|_| equal.at.clone());
        // A factor that is 0 there has no power below 0, and no slope in proportion to it.
        let under: Vec<&Factored> = factors.iter().filter(|f| left(f) != 0).collect();
        if under.iter().any(|f| value(&f.poly) == 0) {
            return None;
        }
        let inside = under.iter().fold(number.clone(), |all, f| all * power_of(&value(&f.poly), left(f)));
        // Where that is no rational number, the value of Y does not matter.
        let root = Some(inside).filter(|v| *v > 0)?.checked_root(u64::from(q)).unwrap_or(Rational::ONE);
        let beside: Vec<Expr> =
            factors.iter().map(|f| whole_power(self.letters.written(&f.poly), whole(f.power))).collect();
        let degree: i64 = factors.iter().map(|f| left(f) * i64::from(f.poly.degree())).sum();
        let mut out: Vec<Expr> = Vec::new();
        let mut push = |forms: &[(&Polynomial, i64)]| {
            if forms.iter().any(|(p, k)| *k != 0 && value(p) == 0) {
                return;
            }
            let at = forms.iter().filter(|f| f.1 != 0).fold(root.clone(), |all, (p, k)| all / power_of(&value(p), *k));
            let own = forms.iter().map(|(p, k)| whole_power(self.letters.written(p), *k));
            let y = product([literal(&at)].into_iter().chain(beside.iter().cloned()).chain(own).collect());
            if out.len() < CHOICES && !out.contains(&y) {
                out.push(y);
            }
        };
        let count = i64::try_from(equal.variables.len()).ok()?;
        if degree % i64::from(q) == 0 && count > 1 {
            let degree = degree / i64::from(q);
            let letters: Vec<Polynomial> = equal.variables.iter().map(|v| Polynomial::variable(*v)).collect();
            let all = letters.iter().fold(Polynomial::zero(), |s, v| s.add(v));
            let squares = letters.iter().fold(Polynomial::zero(), |s, v| s.add(&v.mul(v)));
            let pairs = all.mul(&all).sub(&squares);
            push(&[(&all, degree)]);
            for f in &under {
                let up = left(f).signum();
                push(&[(&f.poly, up), (&all, degree - up * i64::from(f.poly.degree()))]);
            }
            // The slopes of the root there, in proportion to it.
            let slopes = equal.variables.iter().map(|v| {
                let own = under.iter().map(|f| {
                    let slope = value(&f.poly.derivative(*v)) / value(&f.poly);
                    slope * &equal.at * Rational::from(left(f)) / Rational::from(q)
                });
                own.fold(Rational::ZERO, |s, x| s + x)
            });
            // With others, the sum or its inverse has the degree of the root.
            let up = if degree > 0 { 1 } else { -1 };
            let others = Rational::from(degree - up) / Rational::from(count);
            let slopes: Vec<Rational> = slopes.map(|s| (s - &others) * Rational::from(up)).collect();
            if slopes.iter().all(|s| *s >= 0) && slopes.windows(2).any(|s| s[0] != s[1]) {
                let line = letters.iter().zip(&slopes).fold(Polynomial::zero(), |p, (v, s)| p.add(&v.scale(s)));
                push(&[(&all, degree - up), (&line, up)]);
            }
            if degree != 0 {
                push(&[(&all, degree - 2 * up), (&pairs, up)]);
                push(&[(&all, degree - 2 * up), (&squares, up)]);
            }
        }
        push(&[]);
        Some(out)
    }

    /// The bound of an expression as a fact; none if it has no root to bound.
    fn shown_bound(&mut self, bounds: &Bounds, e: &Expr, up: bool, equations: &[Label]) -> Result<Option<Label>, Fail> {
        let bound = bounds.of(e, up);
        if bound == *e {
            return Ok(None);
        }
        let order = if up { Relation::LessEqual } else { Relation::GreaterEqual };
        let goal = compare(e.clone(), order, bound.clone());
        let mut terms: Vec<Term> = Vec::new();
        match &e.kind {
            ExprKind::Negate(a) => {
                terms.extend(
                    self.shown_bound(bounds, a, !up, equations)?.map(|label| scaled(&label, negated(numeral(1)))),
                );
            }
            ExprKind::Sum(list) => {
                for (sign, e) in list {
                    let plus = *sign == Sign::Plus;
                    let factor = if plus { numeral(1) } else { negated(numeral(1)) };
                    terms.extend(
                        self.shown_bound(bounds, e, up == plus, equations)?.map(|label| scaled(&label, factor)),
                    );
                }
            }
            ExprKind::Product(list) => {
                // One factor after the other gives way to its bound.
                let mut list = list.clone();
                for place in 0..list.len() {
                    let (factor, x) = list[place].clone();
                    let times = factor == Factor::Times;
                    let Some(label) = self.shown_bound(bounds, &x, up == times, equations)? else { continue };
                    let y = bounds.of(&x, up == times);
                    let mut rest = vec![(Factor::Times, numeral(1))];
                    rest.extend(list.iter().enumerate().filter(|(i, _)| *i != place).map(|(_, f)| f.clone()));
                    if !times {
                        rest.extend([(factor, x), (factor, y.clone())]);
                    }
                    let rest = expr(ExprKind::Product(rest));
                    terms.push(scaled(&label, if times { rest } else { negated(rest) }));
                    list[place].1 = y;
                }
            }
            ExprKind::Power(base, exponent) if let Some(k) = natural(exponent).map(i64::from) => {
                let Some(label) = self.shown_bound(bounds, base, up, equations)? else { return Ok(None) };
                // x^k − y^k = (x − y)·(x^(k − 1) + … + y^(k − 1)).
                let y = bounds.of(base, up);
                let products =
                    (0..k).map(|j| product(vec![whole_power((**base).clone(), j), whole_power(y.clone(), k - 1 - j)]));
                terms.push(scaled(&label, total(products.map(|e| (Sign::Plus, e)).collect())));
            }
            _ => {
                let root = bounds.root(e, up).ok_or(Fail::No("a root"))?;
                if let Some(terms) = root.difference(bounds.choice)
                    && let Ok(label) = self.combination(goal.clone(), terms)
                {
                    return Ok(Some(label));
                }
                let without = std::mem::replace(&mut self.equations, equations.to_vec());
                let shown = self.attempt(|c| c.without_cases(&goal));
                self.equations = without;
                return shown.map(Some);
            }
        }
        self.combination(goal, terms).map(Some)
    }
}

impl Bounds<'_> {
    fn root(&self, e: &Expr, up: bool) -> Option<&Root> {
        self.roots.iter().find(|r| r.up == up && r.written == *e)
    }

    /// The bound of an expression from above or from below.
    fn of(&self, e: &Expr, up: bool) -> Expr {
        if let Some(root) = self.root(e, up) {
            return root.bound(self.choice);
        }
        if !has_a_root(e) {
            return e.clone();
        }
        let kind = match &e.kind {
            ExprKind::Negate(a) => ExprKind::Negate(Box::new(self.of(a, !up))),
            ExprKind::Sum(list) => {
                ExprKind::Sum(list.iter().map(|(sign, e)| (*sign, self.of(e, up == (*sign == Sign::Plus)))).collect())
            }
            ExprKind::Product(list) => ExprKind::Product(
                list.iter().map(|(factor, e)| (*factor, self.of(e, up == (*factor == Factor::Times)))).collect(),
            ),
            ExprKind::Power(base, exponent) if natural(exponent).is_some() => {
                ExprKind::Power(Box::new(self.of(base, up)), exponent.clone())
            }
            _ => return e.clone(),
        };
        expr(kind)
    }
}

impl Root {
    /// The Y of a choice; the root itself does not occur there.
    fn y(&self, choice: &[usize]) -> &Expr {
        let own = choice.get(self.kind).and_then(|k| self.forms.get(*k));
        own.or(self.forms.first()).unwrap_or(&self.base)
    }

    /// The bound from above or from below.
    fn bound(&self, choice: &[usize]) -> Expr {
        let (m, q) = (self.m, self.q);
        let y = self.y(choice);
        let times = |k: u32, e: Expr| product(vec![numeral(k), e]);
        let y_to = |k: u32| whole_power(y.clone(), i64::from(k));
        let mean =
            |k: u32, j: u32| sum(vec![(Sign::Plus, times(k, self.base.clone())), (Sign::Plus, times(j, y_to(q)))]);
        if self.up {
            over(mean(m, q - m), times(q, y_to(q - m)))
        } else {
            over(product(vec![numeral(q), self.base.clone(), y_to(m)]), mean(q - m, m))
        }
    }
}

impl Root {
    /// What r = X^(1/q) and its bound differ by, for m = 1: (r − Y)² times what is positive, over the divisor of the bound.
    fn difference(&self, choice: &[usize]) -> Option<Vec<Term>> {
        let (q, y, r) = (self.q, self.y(choice), &self.written);
        if self.m != 1 {
            return None;
        }
        let power = |e: &Expr, k: u32| whole_power(e.clone(), i64::from(k));
        // r^q − q·r·Y^(q − 1) + (q − 1)·Y^q, or (q − 1)·r^q − q·r^(q − 1)·Y + Y^q.
        let weight = |j: u32| if self.up { q - 1 - j } else { j + 1 };
        let inner =
            (0..q - 1).map(|j| (Sign::Plus, product(vec![numeral(weight(j)), power(r, j), power(y, q - 2 - j)])));
        let gap = sum(vec![(Sign::Plus, r.clone()), (Sign::Minus, y.clone())]);
        let square = vec![power(&gap, 2), total(inner.collect())];
        let bound = self.bound(choice);
        let ExprKind::Product(list) = &bound.kind else { return None };
        let divisor = list.last()?.1.clone();
        let sign = if self.up { negated(numeral(1)) } else { r.clone() };
        let factor = over(product([sign].into_iter().chain(square).collect()), divisor);
        Some(vec![Term { facts: Vec::new(), factor }])
    }
}

/// The choices of Y for the kinds of these roots: the first ones of all kinds first.
fn choices(roots: &[Root]) -> Vec<Vec<usize>> {
    let of_kind = |k: usize| roots.iter().filter(|r| r.kind == k).map(|r| r.forms.len()).max();
    (0..KINDS).filter_map(of_kind).fold(vec![Vec::new()], |all, count| {
        all.iter().flat_map(|c| (0..count).map(|k| c.iter().copied().chain([k]).collect::<Vec<_>>())).collect()
    })
}
