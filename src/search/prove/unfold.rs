//! Unfolding: members split off sums, products and sequences, so that equal ones are written alike.

use super::draft::Rule;
use super::{Certifier, Fail};
use crate::claim::syntax::*;
use crate::kernel::fraction::{Fraction, Poly, Work};
use crate::kernel::statement::{compare, expr, numeral};
use crate::prove::draft::translate::Atom;
use num_rational::BigRational;
use std::collections::BTreeSet;

impl Certifier {
    /// Splits members off sums, products and sequences, so that equal ones are written alike.
    pub(crate) fn unfold_all(&mut self, exprs: &[&Expr]) -> Result<(), Fail> {
        self.unfold_within(exprs, 40)
    }

    fn unfold_within(&mut self, exprs: &[&Expr], depth: usize) -> Result<(), Fail> {
        for _ in 0..depth {
            let mut atoms = BTreeSet::new();
            for e in exprs {
                if let Ok(crate::prove::draft::translate::Value::Scalar(f)) = self.checker.value(e, 300) {
                    atoms.extend(f.atoms());
                }
            }
            let mut changed = false;
            for atom in atoms {
                if let Some((left, right)) = self.unfolding(atom)? {
                    let prop = compare(left, Relation::Equal, right.clone());
                    let done = self.attempt(|c| {
                        let label = c.take(Rule::Unfold, &[], Some(prop))?;
                        // What is replaced is not looked at again: the right side has to be unfolded first.
                        c.unfold_within(&[&right], depth - 1)?;
                        c.take(Rule::Replace, &[label], None)
                    });
                    changed |= done.is_ok();
                }
            }
            if !changed {
                return Ok(());
            }
        }
        Ok(())
    }

    /// An atom as what it unfolds to, where its index has a positive constant part.
    fn unfolding(&mut self, atom: usize) -> Result<Option<(Expr, Expr)>, Fail> {
        use crate::kernel::substitution::Substitution;
        let constant =
            |p: &Poly| p.terms().find(|t| t.0.is_empty()).map_or(BigRational::from_integer(0.into()), |t| t.1.clone());
        let zero = BigRational::from_integer(0.into());
        let shifted = |p: &Poly, by: i64| {
            let sum = Fraction::sum(&[Fraction::of(p), Fraction::integer(by)], &Work::default());
            sum.and_then(|f| f.expanded(&Work::default())).map_err(Fail::from)
        };
        match self.checker.atom(atom).cloned() {
            Some(Atom::Member(name, index)) => {
                let statement = self.checker.statement().clone();
                let Some(u) = statement.sequences.iter().find(|s| s.name == name) else { return Ok(None) };
                let left = self.atom_expr(atom)?;
                if index.terms().next().is_none() {
                    return Ok(Some((left, u.initial.clone())));
                }
                if constant(&index) <= zero {
                    return Ok(None);
                }
                let before = self.poly_expr(&shifted(&index, -1)?)?;
                let mut map = Substitution::default();
                map.replace(&u.index, &before);
                Ok(Some((left, map.expr(&u.step).map_err(Fail::from)?)))
            }
            Some(Atom::Over(is_sum, _, from, to, _)) => {
                let left = self.atom_expr(atom)?;
                let (ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body)) = &left.kind else {
                    return Ok(None);
                };
                let length = Fraction::of(&shifted(&to, 1)?)
                    .minus(&Fraction::of(&from), &Work::default())
                    .map_err(Fail::from)?;
                if length.is_zero() {
                    return Ok(Some((left.clone(), numeral(u32::from(!is_sum)))));
                }
                let over = |index: Index| {
                    let body = body.clone();
                    expr(if is_sum { ExprKind::SumOver(index, body) } else { ExprKind::ProductOver(index, body) })
                };
                let at = |e: &Expr| -> Result<Expr, Fail> {
                    let mut map = Substitution::default();
                    map.replace(&index.name.text, e);
                    map.expr(body).map_err(Fail::from)
                };
                let joined = |rest: Expr, one: Expr| {
                    if is_sum {
                        expr(ExprKind::Sum(vec![(Sign::Plus, rest), (Sign::Plus, one)]))
                    } else {
                        expr(ExprKind::Product(vec![(Factor::Times, rest), (Factor::Times, one)]))
                    }
                };
                if constant(&to) > zero {
                    let shorter = Index { to: Box::new(self.poly_expr(&shifted(&to, -1)?)?), ..index.clone() };
                    return Ok(Some((left.clone(), joined(over(shorter), at(&index.to)?))));
                }
                if from.terms().next().is_none() {
                    let later = Index { from: Box::new(numeral(1)), ..index.clone() };
                    return Ok(Some((left.clone(), joined(over(later), at(&index.from)?))));
                }
                Ok(None)
            }
            _ => Ok(None),
        }
    }
}
