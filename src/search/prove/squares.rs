//! Comparisons with roots: isolate one of them, or a product of some, then compare the squares of both sides, or the powers that
//! free it of its root. What is left has a root less, and is compared in the same way.
//!
//! Effort: at first little. [`Prover::by_roots_in_full`] repeats the search with the signs of factors, differences and sums of squares
//! for what is left without roots, and for the conditions under which the roots have values.

use super::comparison::single;
use super::facts::{Reading, is_settled, minus, opposite, sign_of};
use super::letters::{product, whole_power};
use super::{Fail, Prover, implies};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, numeral};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::conversion::traits::IsInteger;

/// A difference as a factor whose sign is open, times the rest.
pub(super) struct Open {
    /// The factor.
    pub poly: Polynomial,
    /// The factors of the rest.
    pub rest: Vec<Expr>,
    /// The signs of the rest.
    pub signs: Signs,
}

/// How many roots are isolated within one another.
const NESTED: usize = 5;

/// A polynomial as constant + slope·M, where M is a root, a power of one, or a product of square roots.
struct Radical {
    /// M as it stands.
    written: Expr,
    /// M as one root.
    root: Expr,
    /// The n for which the n-th power of M is free of this root.
    degree: i64,
    constant: Polynomial,
    slope: Polynomial,
}

/// M relation e, which gives the whole comparison when it is multiplied by these factors.
struct Isolated {
    radical: Radical,
    relation: Relation,
    e: Expr,
    factors: Vec<Expr>,
}

impl Open {
    /// The only factor whose sign is open; `None` where there are several, or its power is not 1.
    pub(super) fn of(prover: &Prover, reading: &Reading) -> Option<Open> {
        let mut rest = vec![literal(&reading.number)];
        let mut signs = sign_of(&reading.number);
        let mut open = None;
        for f in &reading.factors {
            match f.power {
                1 if open.is_none() && !is_settled(f.signs) => open = Some(f.poly.clone()),
                _ => {
                    signs = signs.times(f.signs.power(f.power));
                    rest.push(whole_power(prover.letters.written(&f.poly), f.power));
                }
            }
        }
        Some(Open { poly: open?, rest, signs })
    }
}

/// The relation of a factor to 0, given the relation of its product with something of these signs.
pub(crate) fn own_relation(rest: Signs, relation: Relation) -> Option<Relation> {
    let all = [Relation::Less, Relation::LessEqual, Relation::Greater, Relation::GreaterEqual];
    all.into_iter().find(|r| is_settled(rest) && rest.times(Signs::of(*r)) == Signs::of(relation))
}

impl Prover {
    /// Shows a comparison with roots with all effort: for the conditions of its roots, for the signs that are met on the way, and for
    /// what squares leave.
    pub(super) fn by_roots_in_full(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, _, b) = single(goal)?;
        if ![a, b].into_iter().any(has_a_root) {
            return Err(Fail::No("a root"));
        }
        self.in_full(|c| {
            c.failed.clear();
            c.define(a);
            c.define(b);
            c.enrich(&[a, b]);
            c.compared_in_full(goal)
        })
    }

    fn in_full(&mut self, run: impl FnOnce(&mut Self) -> Result<Label, Fail>) -> Result<Label, Fail> {
        if self.roots_in_full.is_some() || self.inductions > 0 || self.splits >= 8 {
            return Err(Fail::No("effort left"));
        }
        let failed = self.failed.clone();
        let splits = std::mem::replace(&mut self.splits, 8);
        self.roots_in_full = Some(0);
        let shown = self.with_half(|c| {
            c.bound_points_of_circles();
            run(c)
        });
        self.roots_in_full = None;
        self.splits = splits;
        self.failed = failed;
        shown
    }

    /// Shows a comparison: one with roots by squares, another by what decides polynomials.
    pub(super) fn compared_in_full(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, _, b) = single(goal)?;
        let depth = self.roots_in_full.filter(|depth| *depth < NESTED).ok_or(Fail::No("effort left"))?;
        if let Ok(label) = self.quietly(goal) {
            return Ok(label);
        }
        self.roots_in_full = Some(depth + 1);
        let shown = if self.roots_in(&minus(a, b)).is_empty() {
            self.attempt(|c| c.by_signs_of_parts(goal)).or_else(|_| self.attempt(|c| c.by_radicals(goal)))
        } else {
            self.attempt(|c| c.by_squares(goal)).or_else(|_| self.attempt(|c| c.by_radicals(goal)))
        };
        self.roots_in_full = Some(depth);
        shown
    }

    /// Shows a comparison that is linear in a root or a product of some, M against e, from that of their powers.
    pub(crate) fn by_squares(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let mut last = Err(Fail::No("a root alone"));
        let (all, slope) = self.isolated(a, relation, b)?;
        if let Some(slope) = slope.filter(|_| all.is_empty()) {
            return self.by_sign_of_slope(goal, &slope);
        }
        for isolated in all {
            last = self.attempt(|c| {
                let shown = c.root_against(&isolated.radical, isolated.relation, &isolated.e)?;
                c.combination(goal.clone(), vec![Term { facts: vec![shown], factor: product(isolated.factors) }])
            });
            if last.is_ok() {
                break;
            }
        }
        last
    }

    /// Shows a comparison in the cases of the sign of what a root is multiplied by.
    fn by_sign_of_slope(&mut self, goal: &Prop, slope: &Expr) -> Result<Label, Fail> {
        let mut from = Vec::new();
        for case in [Relation::Greater, Relation::Less, Relation::Equal] {
            let case = compare(slope.clone(), case, numeral(0));
            from.push(self.block(&implies(&case, goal), |c, _| c.compared_in_full(goal))?);
        }
        self.emit(Rule::Logic { from }, goal.clone())
    }

    /// The ways to isolate a root of a − b, those first where the other side is seen to be not negative; and what a root is multiplied
    /// by, if its sign is not known.
    fn isolated(&mut self, a: &Expr, relation: Relation, b: &Expr) -> Result<(Vec<Isolated>, Option<Expr>), Fail> {
        let no = || Fail::No("a root alone");
        let in_full = self.roots_in_full.is_some();
        let mut reading = self.read(&minus(a, b), true).ok_or_else(no)?;
        if in_full && reading.factors.iter().filter(|f| !is_settled(f.signs)).count() > 1 {
            for f in &reading.factors {
                let e = self.letters.written(&f.poly);
                let _ = self.sign_in_full(&e);
            }
            reading = self.read(&minus(a, b), true).ok_or_else(no)?;
        }
        let open = Open::of(self, &reading).ok_or_else(no)?;
        let (mut out, mut of_no_sign) = (Vec::new(), None);
        for radical in self.radicals_of(&open.poly) {
            let slope = self.letters.written(&radical.slope);
            let mut signs = self.signs_of(&slope);
            if in_full && !is_settled(signs) {
                signs = self.sign_in_full(&slope);
            }
            // a − b = rest·slope·(M − e).
            let sign = open.signs.times(signs);
            let own = match relation {
                Relation::Equal => (in_full && sign.within(Signs::NOT_ZERO)).then_some(Relation::Equal),
                _ => own_relation(sign, relation),
            };
            let Some(own) = own else {
                of_no_sign = Some(slope).filter(|_| in_full && relation != Relation::Equal).or(of_no_sign);
                continue;
            };
            let e = expr(ExprKind::Product(vec![
                (Factor::Times, self.letters.written(&radical.constant.neg())),
                (Factor::Over, slope.clone()),
            ]));
            let mut factors = open.rest.clone();
            factors.push(slope);
            out.push(Isolated { radical, relation: own, e, factors });
        }
        if in_full {
            out.sort_by_cached_key(|i| !self.signs_of(&i.e).within(Signs::NOT_NEGATIVE));
        }
        Ok((out, of_no_sign))
    }

    /// Shows M against e. Where e is negative, M is greater.
    fn root_against(&mut self, radical: &Radical, own: Relation, e: &Expr) -> Result<Label, Fail> {
        let shown = compare(radical.written.clone(), own, e.clone());
        let not_negative = compare(e.clone(), Relation::GreaterEqual, numeral(0));
        let above = matches!(own, Relation::Greater | Relation::GreaterEqual);
        if !above || self.quietly(&not_negative).is_ok() {
            if self.roots_in_full.is_some() {
                self.compared_in_full(&not_negative)?;
            } else {
                self.show(&not_negative)?;
            }
            return self.by_their_squares(radical, own, e, &shown);
        }
        let negative = opposite(&not_negative).ok_or(Fail::No("an opposite"))?;
        let x = self.block(&implies(&not_negative, &shown), |c, _| c.by_their_squares(radical, own, e, &shown))?;
        let y = self.block(&implies(&negative, &shown), |c, block| {
            let turned = expr(ExprKind::Negate(Box::new(numeral(1))));
            let below = Term { facts: vec![format!("{block}s")], factor: turned };
            let above = Term { facts: Vec::new(), factor: radical.written.clone() };
            c.combination(shown.clone(), vec![above, below]).or_else(|_| c.show(&shown))
        })?;
        self.logic(&[&x, &y], &shown)
    }

    /// Shows M against e, which is not negative.
    fn by_their_squares(&mut self, radical: &Radical, own: Relation, e: &Expr, shown: &Prop) -> Result<Label, Fail> {
        let ExprKind::Power(base, exponent) = &radical.root.kind else { return Err(Fail::No("a root")) };
        let power = whole_power(e.clone(), radical.degree);
        let powers = compare((**base).clone(), own, power.clone());
        let from = self.quietly(&powers).or_else(|_| {
            if self.roots_in_full.is_some() {
                return self.compared_in_full(&powers);
            }
            let shown = self.attempt(|c| c.by_radicals(&powers));
            // Where effort is left: what remains has a root less.
            if shown.is_err() && self.splits < 2 { self.show(&powers) } else { shown }
        })?;
        let root = expr(ExprKind::Power(Box::new(power), exponent.clone()));
        let roots = self.emit(Rule::Monotone { from }, compare(radical.root.clone(), own, root.clone()))?;
        let mut labels = vec![roots];
        labels.extend(self.root_of_power(&root, e, radical.degree)?);
        if crate::kernel::key::expr(&radical.written) != crate::kernel::key::expr(&radical.root) {
            let one = compare(radical.written.clone(), Relation::Equal, radical.root.clone());
            labels.push(self.emit(Rule::Power, one)?);
        }
        let terms = labels.into_iter().map(|label| Term { facts: vec![label], factor: numeral(1) });
        self.combination(shown.clone(), terms.collect())
    }

    /// The facts that add up to (e^n)^(1/n) = e, where e is not negative. What the kernel writes with a minus sign gets a name.
    fn root_of_power(&mut self, root: &Expr, e: &Expr, degree: i64) -> Result<Vec<Label>, Fail> {
        let same = compare(root.clone(), Relation::Equal, e.clone());
        let first = match self.emit(Rule::Power, same) {
            Ok(label) => return Ok(vec![label]),
            Err(fail) => fail,
        };
        let ExprKind::Power(_, exponent) = &root.kind else { return Err(first) };
        let (r, named) = self.named_not_negative(e)?;
        let power = whole_power(r.clone(), degree);
        // eⁿ − rⁿ = (e − r)·(eⁿ⁻¹ + … + rⁿ⁻¹).
        let products = (0..degree)
            .map(|k| (Sign::Plus, product(vec![whole_power(e.clone(), degree - 1 - k), whole_power(r.clone(), k)])));
        let factor = expr(ExprKind::Sum(products.collect()));
        let powers = compare(whole_power(e.clone(), degree), Relation::Equal, power.clone());
        let from = self.combination(powers, vec![Term { facts: vec![named.clone()], factor }])?;
        let plain = expr(ExprKind::Power(Box::new(power), exponent.clone()));
        let one = self.emit(Rule::Monotone { from }, compare(root.clone(), Relation::Equal, plain.clone()))?;
        let two = self.emit(Rule::Power, compare(plain, Relation::Equal, r.clone()))?;
        let turned = expr(ExprKind::Negate(Box::new(numeral(1))));
        let back = compare(r, Relation::Equal, e.clone());
        let three = self.combination(back, vec![Term { facts: vec![named], factor: turned }])?;
        Ok(vec![one, two, three])
    }

    /// The base and the degree of a letter that is a root.
    fn root_of_letter(&mut self, letter: u32) -> Option<(Expr, i64)> {
        let e = self.letters.expr(letter)?.clone();
        let ExprKind::Power(base, _) = &e.kind else { return None };
        let degree = self.degree(&e).filter(|d| *d == 2 || self.roots_in_full.is_some())?;
        Some(((**base).clone(), degree))
    }

    /// The ways to write a polynomial as constant + slope·M.
    fn radicals_of(&mut self, poly: &Polynomial) -> Vec<Radical> {
        let mut roots = Vec::new();
        for v in poly.variables() {
            roots.extend(self.root_of_letter(v).map(|(base, degree)| (v, base, degree)));
        }
        let mut out = Vec::new();
        for (v, base, degree) in &roots {
            let Some(root) = self.letters.expr(*v).cloned() else { continue };
            let parts = poly.coefficients_in(*v);
            let mut powers = (1..).zip(parts.iter().skip(1)).filter(|p| !p.1.is_zero());
            let (Some((k, slope)), None, Some(constant)) = (powers.next(), powers.next(), parts.first()) else {
                continue;
            };
            let common = greatest_common_divisor(k, *degree);
            let (written, root) = if k == 1 {
                (root.clone(), root)
            } else {
                let exponent = literal(&(Rational::from(1) / Rational::from(degree / common)));
                let inside = Box::new(whole_power(base.clone(), k / common));
                (whole_power(root, k), expr(ExprKind::Power(inside, Box::new(exponent))))
            };
            if common < *degree {
                let (constant, slope) = (constant.clone(), slope.clone());
                out.push(Radical { written, root, degree: degree / common, constant, slope });
            }
        }
        roots.retain(|r| r.2 == 2);
        let roots: Vec<(u32, Expr)> = roots.into_iter().map(|(v, base, _)| (v, base)).collect();
        out.extend(self.product_of_roots(poly, &roots));
        out
    }

    /// The one product of two roots or more that stands in a polynomial, if no other root does.
    fn product_of_roots(&self, poly: &Polynomial, roots: &[(u32, Expr)]) -> Option<Radical> {
        let is_root = |v: u32| roots.iter().any(|r| r.0 == v);
        let mut found: Option<Vec<(u32, u32)>> = None;
        let (mut constant, mut slope) = (Polynomial::zero(), Polynomial::zero());
        for (m, c) in poly.terms() {
            let (own, others): (Vec<_>, Vec<_>) = m.powers().iter().copied().partition(|p| is_root(p.0));
            let term = Polynomial::term(Monomial::new(&others).ok()?, c.clone());
            if own.is_empty() {
                constant = constant.add(&term);
            } else if own.len() > 1 && own.iter().all(|p| p.1 == 1) && found.as_ref().is_none_or(|f| *f == own) {
                found = Some(own);
                slope = slope.add(&term);
            } else {
                return None;
            }
        }
        let own = found?;
        let of = |pick: &dyn Fn(u32) -> Option<Expr>| own.iter().map(|p| pick(p.0)).collect::<Option<Vec<_>>>();
        let written = product(of(&|v| self.letters.expr(v).cloned())?);
        let bases = of(&|v| roots.iter().find(|r| r.0 == v).map(|r| r.1.clone()))?;
        let (_, exponent) = super::letters::as_power(self.letters.expr(own.first()?.0)?)?;
        let root = expr(ExprKind::Power(Box::new(product(bases)), Box::new(exponent)));
        Some(Radical { written, root, degree: 2, constant, slope })
    }
}

fn greatest_common_divisor(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

/// Whether a power whose exponent is a number, but no whole one, stands in an expression.
pub(super) fn has_a_root(e: &Expr) -> bool {
    let mut found = super::letters::as_power(e)
        .is_some_and(|(_, exponent)| super::coefficients::rational(&exponent).is_some_and(|q| !q.is_integer()));
    crate::claim::walk::parts(e, &mut |part| found |= has_a_root(part));
    found
}
