//! Comparisons with one root, or one product of roots: isolate it, then square both sides.

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

/// A difference as a factor whose sign is open, times the rest.
pub(super) struct Open {
    /// The factor.
    pub poly: Polynomial,
    /// The factors of the rest.
    pub rest: Vec<Expr>,
    /// The signs of the rest.
    pub signs: Signs,
}

/// A polynomial as constant + slope·M, where M is a square root or a product of square roots.
struct Radical {
    /// M as it stands.
    written: Expr,
    /// M as one root.
    root: Expr,
    constant: Polynomial,
    slope: Polynomial,
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
    /// Shows a comparison that is linear in a square root or a product of some, M against e, from that of M² and e².
    pub(crate) fn by_squares(&mut self, goal: &Prop, a: &Expr, relation: Relation, b: &Expr) -> Result<Label, Fail> {
        let no = || Fail::No("a root alone");
        let reading = self.read(&minus(a, b), true).ok_or_else(no)?;
        let open = Open::of(self, &reading).ok_or_else(no)?;
        let mut last = Err(no());
        for radical in self.radicals_of(&open.poly) {
            let slope = self.letters.written(&radical.slope);
            // a − b = rest·slope·(M − e).
            let sign = open.signs.times(self.signs_of(&slope));
            let Some(own) = own_relation(sign, relation) else { continue };
            let e = expr(ExprKind::Product(vec![
                (Factor::Times, self.letters.written(&radical.constant.neg())),
                (Factor::Over, slope.clone()),
            ]));
            let mut factors = open.rest.clone();
            factors.push(slope);
            last = self.attempt(|c| {
                let shown = c.root_against(&radical, own, &e)?;
                c.combination(goal.clone(), vec![Term { facts: vec![shown], factor: product(factors) }])
            });
            if last.is_ok() {
                break;
            }
        }
        last
    }

    /// Shows M against e. Where e is negative, M is greater.
    fn root_against(&mut self, radical: &Radical, own: Relation, e: &Expr) -> Result<Label, Fail> {
        let shown = compare(radical.written.clone(), own, e.clone());
        let not_negative = compare(e.clone(), Relation::GreaterEqual, numeral(0));
        let above = matches!(own, Relation::Greater | Relation::GreaterEqual);
        if !above || self.quietly(&not_negative).is_ok() {
            self.show(&not_negative)?;
            return self.by_their_squares(radical, own, e, &shown);
        }
        let negative = opposite(&not_negative).ok_or(Fail::No("an opposite"))?;
        let x = self.block(&implies(&not_negative, &shown), |c, _| c.by_their_squares(radical, own, e, &shown))?;
        let y = self.block(&implies(&negative, &shown), |c, _| c.show(&shown))?;
        self.logic(&[&x, &y], &shown)
    }

    /// Shows M against e, which is not negative.
    fn by_their_squares(&mut self, radical: &Radical, own: Relation, e: &Expr, shown: &Prop) -> Result<Label, Fail> {
        let ExprKind::Power(base, exponent) = &radical.root.kind else { return Err(Fail::No("a root")) };
        let square = whole_power(e.clone(), 2);
        let squares = compare((**base).clone(), own, square.clone());
        let from = self.quietly(&squares).or_else(|first| {
            let PropKind::Compare(sides, _) = &squares.kind else { return Err(first) };
            let shown = self.attempt(|c| c.by_radicals(&squares, &sides[0], own, &sides[1]));
            // Where effort is left: what remains has a root less.
            if shown.is_err() && self.splits < 2 { self.show(&squares) } else { shown }
        })?;
        let even = expr(ExprKind::Power(Box::new(square), exponent.clone()));
        let roots = self.emit(Rule::Monotone { from }, compare(radical.root.clone(), own, even.clone()))?;
        let same = self.emit(Rule::Power, compare(even, Relation::Equal, e.clone()))?;
        let mut labels = vec![roots, same];
        if crate::kernel::key::expr(&radical.written) != crate::kernel::key::expr(&radical.root) {
            let one = compare(radical.written.clone(), Relation::Equal, radical.root.clone());
            labels.push(self.emit(Rule::Power, one)?);
        }
        let terms = labels.into_iter().map(|label| Term { facts: vec![label], factor: numeral(1) });
        self.combination(shown.clone(), terms.collect())
    }

    /// Whether a letter is a square root; its base then.
    fn square_root(&mut self, letter: u32) -> Option<Expr> {
        let ExprKind::Power(base, exponent) = &self.letters.expr(letter)?.kind.clone() else { return None };
        let q = self.read(exponent, false).filter(|r| r.factors.is_empty())?;
        (q.number == Rational::from(1) / Rational::from(2)).then(|| (**base).clone())
    }

    /// The ways to write a polynomial as constant + slope·M.
    fn radicals_of(&mut self, poly: &Polynomial) -> Vec<Radical> {
        let mut roots = Vec::new();
        for v in poly.variables() {
            roots.extend(self.square_root(v).map(|base| (v, base)));
        }
        let mut out = Vec::new();
        for (v, _) in &roots {
            let Some(root) = self.letters.expr(*v).cloned() else { continue };
            if let [constant, slope] = poly.coefficients_in(*v).as_slice() {
                let (constant, slope) = (constant.clone(), slope.clone());
                out.push(Radical { written: root.clone(), root, constant, slope });
            }
        }
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
        Some(Radical { written, root, constant, slope })
    }
}
