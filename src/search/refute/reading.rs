//! Expressions of a claim as the kernel reads them: fractions in atoms, by their form alone.
//!
//! Contract: wherever an expression has a value, the fraction has the same value. It decides nothing: points are evaluated
//! with the claim's own expressions.

use super::expand::Statement;
use crate::algebra::{Monomial, Polynomial};
use crate::claim::definedness;
use crate::claim::parse::parse;
use crate::claim::syntax::*;
use crate::claim::walk::parts_mut;
use crate::kernel::Checker;
use crate::kernel::fraction::{Fraction, Poly};
use crate::kernel::statement::{expr, numeral};
use crate::kernel::substitution::Substitution;
use malachite::Rational;
use num_rational::BigRational;
use std::str::FromStr;

/// The longest range of a sum or product of numerals that is written out.
const WRITTEN_OUT: i128 = 12;

/// A reader of the expressions of one claim.
pub struct Reading {
    checker: Checker,
}

/// A claim that declares these variables and says nothing of them.
pub(super) fn declaring(bindings: &[Binding]) -> Option<Claim> {
    let mut claim = parse("claim c \"\"\nprove 0 = 0\n").ok()?.pop()?;
    claim.items.push(Item::Given(bindings.to_vec()));
    Some(claim)
}

impl Reading {
    /// A reader for what these bindings declare, and the sequences and hypotheses of the statement; none where the kernel
    /// cannot read the statement.
    pub fn of(statement: &Statement, bindings: &[Binding]) -> Option<Reading> {
        let mut claim = declaring(bindings)?;
        claim.items.extend(statement.sequences.iter().map(|u| Item::Define {
            name: Name::new(&u.name),
            initial: u.initial.clone(),
            index: Name::new(&u.index),
            step: u.step.clone(),
            span: Span::default(),
        }));
        // Hypotheses only say that members of sequences have values. They may bind again what these bindings declare.
        if !statement.sequences.is_empty() {
            let said = statement.assumptions.iter().map(|(_, p)| Item::Assume { label: None, prop: p.clone() });
            claim.items.extend(said);
        }
        Some(Reading { checker: Checker::new(&claim, &[]).ok()? })
    }

    fn fraction(&mut self, e: &Expr) -> Option<Fraction> {
        let mut e = e.clone();
        write_out(&mut e);
        self.checker.read(&e, &[]).ok()
    }

    /// Whether two expressions are equal wherever both have values, by their form.
    pub fn same(&mut self, a: &Expr, b: &Expr) -> bool {
        match (self.fraction(a), self.fraction(b)) {
            (Some(a), Some(b)) => self.checker.difference_of(&a, &b).is_ok_and(|d| d.is_zero()),
            _ => false,
        }
    }

    /// The same expression with derivatives carried out.
    pub fn plain(&mut self, e: &Expr) -> Option<Expr> {
        let f = self.fraction(e)?;
        Some(self.checker.fraction_words(&f))
    }

    /// The numerator and denominator of the difference of two numbers.
    pub fn difference(&mut self, a: &Expr, b: &Expr) -> Option<(Polynomial, Polynomial)> {
        let (a, b) = (self.fraction(a)?, self.fraction(b)?);
        let difference = self.checker.difference_of(&a, &b).ok()?;
        let (above, below) = self.checker.parts_of(&difference).ok()?;
        Some((to_algebra(&above)?, to_algebra(&below)?))
    }

    /// The expression of a polynomial's variable.
    pub fn letter(&self, letter: u32) -> Expr {
        self.checker.atom_words(letter as usize)
    }

    /// A polynomial as an expression.
    pub fn words(&self, p: &Polynomial) -> Expr {
        let terms = p.terms().map(|(monomial, c)| {
            let mut list = vec![(Factor::Times, super::literal::literal(c))];
            list.extend(monomial.powers().iter().map(|(letter, k)| {
                let power = ExprKind::Power(Box::new(self.letter(*letter)), Box::new(numeral(*k)));
                (Factor::Times, expr(power))
            }));
            (Sign::Plus, expr(ExprKind::Product(list)))
        });
        let terms: Vec<(Sign, Expr)> = terms.collect();
        if terms.is_empty() { numeral(0) } else { expr(ExprKind::Sum(terms)) }
    }
}

/// The kernel's polynomial as one of the engine's: its letters are the places of the atoms.
pub(crate) fn to_algebra(poly: &Poly) -> Option<Polynomial> {
    let mut terms = Vec::new();
    for (monomial, c) in poly.terms() {
        let powers: Option<Vec<(u32, u32)>> =
            monomial.iter().map(|(a, k)| Some((u32::try_from(*a).ok()?, *k))).collect();
        terms.push((Monomial::new(&powers?).ok()?, rational(c)?));
    }
    Some(Polynomial::from_terms(terms))
}

fn rational(c: &BigRational) -> Option<Rational> {
    Rational::from_str(&c.to_string()).ok()
}

/// Writes sums and products over short ranges of numerals as sums and products.
fn write_out(e: &mut Expr) {
    parts_mut(e, &mut write_out);
    let (ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body)) = &e.kind else { return };
    let (Some((from @ 0.., 1)), Some((to, 1))) = (definedness::number(&index.from), definedness::number(&index.to))
    else {
        return;
    };
    if to < from || to - from > WRITTEN_OUT {
        return;
    }
    let at = |k: i128| {
        let mut put = Substitution::default();
        put.replace(&index.name.text, &numeral(u32::try_from(k).ok()?));
        put.expr(body).ok()
    };
    let Some(list) = (from..=to).map(at).collect::<Option<Vec<Expr>>>() else { return };
    e.kind = match &e.kind {
        ExprKind::SumOver(..) => ExprKind::Sum(list.into_iter().map(|e| (Sign::Plus, e)).collect()),
        _ => ExprKind::Product(list.into_iter().map(|e| (Factor::Times, e)).collect()),
    };
}
