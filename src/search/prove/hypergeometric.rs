//! Terms whose quotient with the next is a quotient of polynomials: powers, factorials, binomial coefficients and products of these.
//!
//! A factor f(i, v) of a product over i that is linear in both moves with the variable v: f(i, v + 1) = f(i + d, v). So the product
//! from a to b becomes that of f(i, v) from a + d to b + d, which differs from the old one by d factors at each end.

use super::letters::natural;
use super::limits::{holds, over, plus};
use super::slopes::put_in;
use super::sums::Quotient;
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::claim::walk::parts;
use crate::kernel::key;
use crate::kernel::statement::{apply, compare, expr, name, numeral, prop};
use crate::kernel::substitution::Substitution;
use malachite::Rational;

/// The most factors by which a product grows or shrinks at an end.
const SHIFT: i64 = 4;

/// A factor of a product over an index.
#[derive(Clone)]
pub(super) struct Factors {
    /// The index with its ends.
    pub(super) index: Index,
    /// The factor at the index.
    pub(super) at: Expr,
}

impl Factors {
    /// Their product.
    pub(super) fn product(&self) -> Expr {
        expr(ExprKind::ProductOver(self.index.clone(), Box::new(self.at.clone())))
    }
}

/// The products in an expression whose factors hold a variable, each factor of a body by itself.
pub(super) fn moving(e: &Expr, variable: &str, out: &mut Vec<Factors>) {
    if let ExprKind::ProductOver(index, body) = &e.kind {
        for at in factors_of(body).into_iter().filter(|at| holds(at, variable)) {
            let new = Factors { index: index.clone(), at };
            if !out.iter().any(|old| key::expr(&old.product()) == key::expr(&new.product())) {
                out.push(new);
            }
        }
        return;
    }
    let before = out.len();
    parts(e, &mut |part| moving(part, variable, out));
    // Not those of a sum that hold its index.
    if let ExprKind::SumOver(index, _) = &e.kind {
        let mut own = out.split_off(before);
        own.retain(|factors| !holds(&factors.at, &index.name.text));
        out.append(&mut own);
    }
}

/// The powers in a product whose exponent holds a variable.
pub(super) fn powers(e: &Expr, variable: &str, out: &mut Vec<(Expr, Expr)>) {
    match &e.kind {
        ExprKind::Power(base, exponent) if holds(exponent, variable) => {
            out.push(((**base).clone(), (**exponent).clone()))
        }
        ExprKind::Power(..) | ExprKind::Negate(_) | ExprKind::Product(_) => {
            parts(e, &mut |part| powers(part, variable, out))
        }
        _ => {}
    }
}

/// The powers in an expression whose base and exponent hold a variable, each once.
pub(super) fn powers_of_both(e: &Expr, variable: &str, out: &mut Vec<(Expr, Expr)>) {
    if let ExprKind::Power(base, exponent) = &e.kind
        && holds(base, variable)
        && holds(exponent, variable)
        && !out.iter().any(|(b, e)| key::expr(b) == key::expr(base) && key::expr(e) == key::expr(exponent))
    {
        out.push(((**base).clone(), (**exponent).clone()));
    }
    parts(e, &mut |part| powers_of_both(part, variable, out));
}

/// What an expression multiplies and divides by.
fn factors_of(e: &Expr) -> Vec<Expr> {
    match &e.kind {
        ExprKind::Product(list) => list.iter().flat_map(|(_, e)| factors_of(e)).collect(),
        ExprKind::Power(base, k) if natural(k).is_some() => factors_of(base),
        _ => vec![e.clone()],
    }
}

/// The product of two quotients.
pub(super) fn times(a: &Quotient, b: &Quotient) -> Option<Quotient> {
    Some((a.0.try_mul(&b.0).ok()?, a.1.try_mul(&b.1).ok()?))
}

impl Prover {
    /// E(v + 1)/E(v) as a quotient of polynomials.
    pub(super) fn ratio(&mut self, e: &Expr, v: &str) -> Option<Quotient> {
        if !holds(e, v) {
            return Some((Polynomial::one(), Polynomial::one()));
        }
        match &e.kind {
            ExprKind::Negate(a) => self.ratio(a, v),
            ExprKind::Product(list) => {
                let mut all = (Polynomial::one(), Polynomial::one());
                for (how, e) in list {
                    let (above, below) = self.ratio(e, v)?;
                    all = times(&all, &if *how == Factor::Over { (below, above) } else { (above, below) })?;
                }
                Some(all)
            }
            ExprKind::Power(base, k) if natural(k).is_some() => {
                let (above, below) = self.ratio(base, v)?;
                Some((above.pow(natural(k)?).ok()?, below.pow(natural(k)?).ok()?))
            }
            ExprKind::Power(base, exponent) if !holds(base, v) => {
                let slope = self.slope(exponent, v)?;
                let own = self.quotient(base, v)?;
                power(&own, slope)
            }
            ExprKind::Apply(f, list) if f.text == "exp" && list.len() == 1 => {
                let step = self.step(list.first()?, v)?;
                Some((self.letters.polynomial(&apply("exp", step))?, Polynomial::one()))
            }
            ExprKind::ProductOver(index, body) => {
                let factors = match &body.kind {
                    ExprKind::Product(list) => list.clone(),
                    _ => vec![(Factor::Times, (**body).clone())],
                };
                let mut all = (Polynomial::one(), Polynomial::one());
                for (how, at) in factors {
                    let (above, below) = self.moved(&Factors { index: index.clone(), at }, v)?;
                    all = times(&all, &if how == Factor::Over { (below, above) } else { (above, below) })?;
                }
                Some(all)
            }
            _ => {
                let (above, below) = self.quotient(e, v)?;
                let letter = self.letters.of(&name(v));
                let after = Polynomial::variable(letter).add(&Polynomial::one());
                let next = |p: &Polynomial| p.substitute(letter, &after).ok();
                times(&(next(&above)?, next(&below)?), &(below, above))
            }
        }
    }

    /// The factors of a term that are quotients of polynomials in a variable, multiplied, and the others.
    pub(super) fn parted(&mut self, term: &Expr, v: &str) -> Option<(Quotient, Vec<(Factor, Expr)>)> {
        let (mut plain, mut rest) = ((Polynomial::one(), Polynomial::one()), Vec::new());
        self.parted_into(term, v, Factor::Times, &mut plain, &mut rest)?;
        Some((plain, rest))
    }

    fn parted_into(
        &mut self,
        e: &Expr,
        v: &str,
        how: Factor,
        plain: &mut Quotient,
        rest: &mut Vec<(Factor, Expr)>,
    ) -> Option<()> {
        if let Some((above, below)) = self.quotient(e, v) {
            *plain = times(plain, &if how == Factor::Over { (below, above) } else { (above, below) })?;
            return Some(());
        }
        match &e.kind {
            ExprKind::Negate(a) => {
                plain.0 = plain.0.neg();
                self.parted_into(a, v, how, plain, rest)
            }
            ExprKind::Product(list) => list.iter().try_for_each(|(own, e)| {
                let own = if *own == how { Factor::Times } else { Factor::Over };
                self.parted_into(e, v, own, plain, rest)
            }),
            _ => {
                rest.push((how, e.clone()));
                Some(())
            }
        }
    }

    /// By how much an expression that is linear in a variable is more where that is one more.
    fn step(&mut self, e: &Expr, v: &str) -> Option<Expr> {
        let letter = self.letters.of(&name(v));
        let p = self.letters.polynomial(e)?;
        self.is_plain(&p, v).then_some(())?;
        let step = p.derivative(letter);
        (!step.variables().contains(&letter)).then(|| self.letters.written(&step))
    }

    /// The whole slope of an expression that is linear in a variable.
    pub(super) fn slope(&mut self, e: &Expr, v: &str) -> Option<i64> {
        let letter = self.letters.of(&name(v));
        let p = self.letters.polynomial(e)?;
        self.is_plain(&p, v).then_some(())?;
        let slope = i64::try_from(&p.derivative(letter).as_constant()?).ok()?;
        (slope.abs() <= SHIFT).then_some(slope)
    }

    /// Whether a polynomial holds a variable only as a letter.
    fn is_plain(&self, p: &Polynomial, v: &str) -> bool {
        p.variables().into_iter().filter_map(|letter| self.letters.expr(letter)).all(|e| match &e.kind {
            ExprKind::Name(_) => true,
            _ => !holds(e, v),
        })
    }

    /// By what a product is multiplied where a variable is one more.
    pub(super) fn moved(&mut self, factors: &Factors, v: &str) -> Option<Quotient> {
        let (index, at) = (&factors.index, &factors.at);
        if holds(&index.from, v) {
            return None;
        }
        let (i, letter) = (self.letters.of(&name(&index.name.text)), self.letters.of(&name(v)));
        let f = self.letters.polynomial(at)?;
        let (from, to) = (self.letters.polynomial(&index.from)?, self.letters.polynomial(&index.to)?);
        let grows = self.slope(&index.to, v)?;
        let shift = match holds(at, v) {
            false => 0,
            true => {
                let own = f.derivative(i).as_constant().filter(|c| *c != 0)?;
                i64::try_from(&(f.derivative(letter).as_constant()? / own)).ok()?
            }
        };
        if !self.is_plain(&f, v) || !self.is_plain(&f, &index.name.text) || shift.abs() > SHIFT {
            return None;
        }
        let (mut above, mut below) = (Polynomial::one(), Polynomial::one());
        let mut put = |beside: &Polynomial, k: i64, divides: bool| {
            let factor = f.substitute(i, &beside.add(&Polynomial::integer(k))).ok()?;
            let side = if divides { &mut below } else { &mut above };
            *side = side.try_mul(&factor).ok()?;
            Some(())
        };
        let end = grows + shift;
        (1..=end).try_for_each(|k| put(&to, k, false))?;
        (end + 1..=0).try_for_each(|k| put(&to, k, true))?;
        (0..shift).try_for_each(|k| put(&from, k, true))?;
        (shift..0).try_for_each(|k| put(&from, k, false))?;
        Some((above, below))
    }

    /// The laws by which the products in an expression move with a variable.
    pub(super) fn laws(&mut self, e: &Expr, v: &str) -> Result<Vec<Law>, Fail> {
        let mut list = Vec::new();
        moving(e, v, &mut list);
        list.iter().map(|factors| self.law(factors, v)).collect()
    }

    /// A product whose factors are scaled as the kernel writes them, so that an equation for it can be put in. The factors are
    /// linear in the index and in a variable, at whose `shift` later value this is asked.
    pub(super) fn as_written(&mut self, factors: &Factors, v: &str, shift: u32) -> Result<Factors, Fail> {
        let no = || Fail::No("a linear factor");
        let f = self.letters.polynomial(&factors.at).ok_or_else(no)?;
        let later = plus(&name(v), numeral(shift));
        for letter in [v, factors.index.name.text.as_str()] {
            let letter = self.letters.of(&name(letter));
            let slope = f.derivative(letter).as_constant().filter(|c| *c != 0).ok_or_else(no)?;
            let at = self.letters.written(&f.scale(&(Rational::from(1) / slope)));
            let index = Index { to: Box::new(name(v)), ..factors.index.clone() };
            let probe = Factors { index, at: put_in(&at, v, &later)? };
            let (probe, equations) = (compare(probe.product(), Relation::Equal, numeral(1)), self.equations.clone());
            if self.checker.can_be_put_in(&probe, &equations) {
                return Ok(Factors { at, ..factors.clone() });
            }
        }
        Err(no())
    }

    fn law(&mut self, factors: &Factors, v: &str) -> Result<Law, Fail> {
        let j = self.fresh("j");
        let factors = &self.as_written(factors, v, 1)?;
        let own = Factors { index: Index { to: Box::new(name(&j)), ..factors.index.clone() }, ..factors.clone() };
        let (above, below) = self.moved(&own, v).ok_or(Fail::No("a product that moves with a variable"))?;
        let (above, below) = (self.letters.written(&above), self.letters.written(&below));
        let next = Factors { at: put_in(&own.at, v, &plus(&name(v), numeral(1)))?, ..own.clone() }.product();
        let own = own.product();
        let by = |a: &Expr, b: &Expr| super::letters::product(vec![a.clone(), b.clone()]);
        let same = compare(by(&below, &next), Relation::Equal, by(&above, &own));
        let every = prop(PropKind::ForAll(vec![Binding::of(Name::new(&j), true, Vec::new())], Box::new(same)));
        let splits = std::mem::replace(&mut self.splits, 0);
        let shown = self.all_by_induction(&every, 3);
        self.splits = splits;
        Ok(Law {
            end: (*factors.index.to).clone(),
            j,
            label: shown?,
            quotient: over(above, below.clone()),
            below,
            next,
            own,
        })
    }

    /// Puts in what a product comes to whose factors are taken at the next value of the variable, and whose end at this one. `at` gives
    /// values to what the end holds.
    pub(super) fn put_in_law(&mut self, law: &Law, at: &Substitution) -> Result<(), Fail> {
        let mut there = Substitution::default();
        there.replace(&law.j, &at.expr(&law.end).map_err(Fail::from)?);
        let end = |e: &Expr| there.expr(e).map_err(Fail::from);
        let here = self.instance(&law.label, &end(&name(&law.j))?)?;
        let below = end(&law.below)?;
        self.without_cases(&compare(below.clone(), Relation::NotEqual, numeral(0)))?;
        let value = super::letters::product(vec![end(&law.quotient)?, end(&law.own)?]);
        let term = Term { facts: vec![here], factor: over(numeral(1), below) };
        let label = self.combination(compare(end(&law.next)?, Relation::Equal, value), vec![term])?;
        self.put_in(&label);
        Ok(())
    }
}

/// How a product moves with a variable, for every end j: below·next = above·own.
pub(super) struct Law {
    /// The end that the product has.
    end: Expr,
    j: String,
    /// The fact that says so for all j.
    label: Label,
    below: Expr,
    /// above/below
    quotient: Expr,
    /// The product with factors at the next value of the variable.
    next: Expr,
    own: Expr,
}

/// A quotient to a whole power.
pub(super) fn power(q: &Quotient, k: i64) -> Option<Quotient> {
    let size = u32::try_from(k.unsigned_abs()).ok()?;
    let (above, below) = (q.0.pow(size).ok()?, q.1.pow(size).ok()?);
    Some(if k < 0 { (below, above) } else { (above, below) })
}
